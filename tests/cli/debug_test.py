"""triscope debug: where it goes, what it stops at, what it answers, and how it exits."""

import json
import pathlib
import re
import signal
import subprocess
import time

import program
from program import (BLUNT_BODY, CANCELLED, CANNOT_WRITE, DOMAINS, NO_INPUT, OK, STEP, UNMET, USAGE, run)

ANNULUS = str(DOMAINS / "annulus.json")
CRACKED = str(DOMAINS / "cracked_plate.json")
CYLINDER = str(DOMAINS / "cylinder.json")


class Debug(program.ProgramTest):
    def ask(self, *arguments, code=OK):
        """Runs with --json; returns what it says."""
        return json.loads(self.expect(code, run("debug", *arguments, "--json")).stdout)

    def lines(self, *arguments):
        return [line["text"] for line in self.ask(*arguments)["answers"][0]["lines"]]


class Places(Debug):
    def test_without_a_place_it_is_the_end(self):
        text = self.expect(OK, run("debug", ANNULUS)).stdout
        self.assertIn("stage finished", text)
        self.assertIn("Finished after", text)

    def test_counts_are_plain_digits(self):
        """The window sets thousands apart by a thin space, which no script reads as a number."""
        text = self.expect(OK, run("debug", CYLINDER, "--print", "state", "--print", "events:0-20000")).stdout
        self.assertRegex(text, r"(?m)^  Finished after 3\d{4} decisions")
        self.assertRegex(text, r"(?m)^  3\d{4} decisions made, 4\d{4} events recorded\.$")
        self.assertNotIn("\u2009", text)
        self.assertTrue(self.lines(CYLINDER, "--print", "state")[1].startswith(text.split("Finished after ")[1][:15]))

    def test_every_place_can_be_gone_to(self):
        end = self.ask(ANNULUS)
        for place, check in (("start", lambda s: s["tick"] == 0), ("end", lambda s: s == end | {"answers": s["answers"]}),
                             ("tick=100", lambda s: s["tick"] == 100), ("event=100", lambda s: s["events"] > 100),
                             ("stage=step3", lambda s: s["stage"] == "step3" and s["round"] == 1)):
            self.assertTrue(check(self.ask(ANNULUS, "--goto", place)), place)

    def test_the_state_is_that_of_the_run(self):
        hashes = {self.ask(ANNULUS, "--goto", "tick=200")["hash"],
                  self.ask(ANNULUS, "--goto", "tick=200", "--print", "why:triangle=300")["hash"]}
        self.assertEqual(len(hashes), 1)
        self.assertNotEqual(hashes.pop(), self.ask(ANNULUS, "--goto", "tick=201")["hash"])

    def test_a_place_beyond_the_end(self):
        for place in ("tick=999999", "event=999999"):
            process = run("debug", ANNULUS, "--goto", place)
            self.assertEqual(process.returncode, UNMET)
            self.assertIn("decisions", process.stderr)
            self.assertEqual(process.stdout, "")

    def test_settings_matter(self):
        a = self.ask(ANNULUS, "--set", "omega=0.05")["hash"]
        self.assertNotEqual(a, self.ask(ANNULUS, "--set", "omega=0.25")["hash"])


class Breaks(Debug):
    def test_forwards_to_the_first_and_on(self):
        first = self.ask(CRACKED, "--break", "refused")
        self.assertEqual(first["hit"]["condition"], "refused")
        event = first["hit"]["event"]
        self.assertIn("refusal", event)
        second = self.ask(CRACKED, "--goto", f"tick={first['tick']}", "--break", "refused")
        self.assertGreater(second["hit"]["event"]["event"], event["event"])
        back = self.ask(CRACKED, "--goto", f"tick={second['tick']}", "--break", "refused", "--back")
        self.assertEqual(back["hit"]["event"], event)
        self.assertEqual(back["hash"], first["hash"])

    def test_the_first_of_several(self):
        hit = self.ask(BLUNT_BODY, "--break", "stage == refine", "--break", "stage == step2")["hit"]
        self.assertEqual(hit["condition"], "stage == step2")

    def test_back_from_the_end(self):
        hit = self.ask(BLUNT_BODY, "--break", "moved", "--back")["hit"]
        self.assertEqual(hit["event"]["kind"], "vertex moved")
        self.assertEqual(hit["event"]["stage"], "optimise")

    def test_text_says_why_it_stopped(self):
        text = self.expect(OK, run("debug", CRACKED, "--break", "refused and rule == second_front")).stdout
        self.assertRegex(text, r"stopped by refused and rule == second_front\n  Event \d+: Second front proposed")

    def test_one_that_is_never_met(self):
        process = run("debug", ANNULUS, "--break", "triangles > 1000000")
        self.assertEqual(process.returncode, UNMET)
        self.assertIn("no breakpoint was met", process.stderr)
        self.assertIn("stage finished", process.stdout)

    def test_a_mistake_is_pointed_at(self):
        error = self.expect(USAGE, run("debug", ANNULUS, "--break", "aspect >> 4")).stderr
        self.assertIn("\n  aspect >> 4\n          ^\nexpected a number", error)

    def test_a_mistake_is_found_before_the_domain_is_read(self):
        self.expect(USAGE, run("debug", "no such file.json", "--break", "aspect >> 4"))

    def test_first_violation(self):
        for sample in sorted(DOMAINS.glob("*.json")):
            held = self.expect(OK, run("debug", sample, "--first-violation"))
            self.assertIn("no rule of validity and no bound of the paper is broken", held.stderr)
        self.assertEqual(self.expect(OK, run("debug", ANNULUS, "--first-violation", "-q")).stderr, "")
        # An angle of 8° in the domain lets no mesh keep the bound of 30°.
        wedge = self.write("wedge.json", '{"outer": [[0, 0], [10, 0], [10, 1.4]], "min_edge_length": 0.2}')
        found = self.ask(wedge, "--first-violation", "--print", "worst", code=UNMET)
        self.assertIn("bound_broken", found["hit"]["condition"])
        angle = found["answers"][0]["worst"][3]
        self.assertEqual(angle["measure"], "min_angle")
        self.assertFalse(angle["met"])
        self.assertLess(angle["value"], 8.1)

    def test_what_does_not_go_together(self):
        self.expect(USAGE, run("debug", ANNULUS, "--back"))
        self.expect(USAGE, run("debug", ANNULUS, "--first-violation", "--break", "failed"))


class Answers(Debug):
    def test_why_names_the_rule_and_values_that_satisfy_it(self):
        worst = self.ask(BLUNT_BODY, "--print", "worst", "--goto", "stage=refine")["answers"][0]["worst"]
        self.assertEqual([w["measure"] for w in worst],
                         ["aspect_ratio", "area_ratio", "edge_ratio", "min_angle", "max_angle"])
        seen = 0
        for w in worst:
            for text in self.lines(BLUNT_BODY, "--goto", "stage=refine", "--print", f"why:triangle={w['triangle']}"):
                found = re.search(r"Step [123] put vertex \d+ at .*R = ([\d.]+) is not below .*[eh] = ([\d.]+)", text)
                if found:
                    self.assertGreaterEqual(float(found[1]), float(found[2]) * 0.999, text)
                    seen += 1
        self.assertGreater(seen, 0)

    def test_links_are_the_ids_in_the_text(self):
        answers = self.ask(CRACKED, "--print", "why:vertex=900", "--print", "history:vertex=900", "--print", "why:cell=20",
                           "--print", "whynot:triangle=5000", "--print", "history:triangle=5000")["answers"]
        self.assertEqual(len(answers), 5)
        links = 0
        for answer in answers:
            self.assertGreater(len(answer["lines"]), 0, answer)
            for line in answer["lines"]:
                for link in line["links"]:
                    self.assertIn(str(link["id"]), line["text"])
                    links += 1
        self.assertGreater(links, 10)

    def test_an_event_asked_for_is_the_event_recorded(self):
        self.expect(OK, run("mesh", ANNULUS, "--events", self.path("e.jsonl"), "-q"))
        recorded = [json.loads(line) for line in (self.folder / "e.jsonl").read_text().splitlines()[1:]]
        answer = self.ask(ANNULUS, "--print", "events:100-119")["answers"][0]
        self.assertEqual(answer["events"], recorded[100:120])
        self.assertEqual(len(answer["lines"]), 20)
        self.assertTrue(answer["lines"][0]["text"].startswith("Event 100: "))

    def test_whynot_names_every_rule(self):
        triangle = self.ask(ANNULUS, "--print", "worst")["answers"][0]["worst"][0]["triangle"]
        text = "\n".join(self.lines(ANNULUS, "--print", f"whynot:triangle={triangle}"))
        for rule in ("Step 1", "Step 2", "Step 3", "Step 4", "Step 5", "Repair", "Laplacian", "Obtuse", "Shared edge"):
            self.assertIn(rule, text)

    def test_a_triangle_that_is_gone_has_its_end_in_its_history(self):
        text = "\n".join(self.lines(ANNULUS, "--print", "history:triangle=200"))
        self.assertIn("It ended with event", text)
        self.assertIn("There is no triangle 200", "\n".join(self.lines(ANNULUS, "--print", "triangle=200")))

    def test_figures_of_elements(self):
        triangle = self.ask(ANNULUS, "--print", "worst")["answers"][0]["worst"][0]
        text = "\n".join(self.lines(ANNULUS, "--print", f"triangle={triangle['triangle']}"))
        self.assertIn(f"aspect ratio R/r = {triangle['value']:.4g}", text)
        self.assertIn("Vertex 30", self.lines(ANNULUS, "--print", "vertex=30")[0])
        self.assertIn("Cell 0", self.lines(ANNULUS, "--print", "cell=0")[0])

    def test_quality_is_the_report_of_mesh(self):
        self.expect(OK, run("mesh", ANNULUS, "--report", self.path("r.json"), "-q"))
        report = json.loads((self.folder / "r.json").read_text())
        quality = self.ask(ANNULUS, "--print", "quality")["answers"][0]["quality"]
        for key, value in quality.items():
            self.assertEqual(report[key], value, key)

    def test_ids_that_are_not_there(self):
        for what in ("why:triangle=4000000000", "whynot:triangle=4000000000", "history:vertex=4000000000",
                     "why:cell=4000000000", "event=4000000000", "vertex=4000000000", "events:900000-900001"):
            text = self.lines(ANNULUS, "--print", what)
            self.assertEqual(len(text), 1, text)
            self.assertRegex(text[0], "There is no|Only", what)

    def test_what_cannot_be_printed(self):
        for what in ("why", "why:edge=3", "whynot:vertex=3", "triangle=x", "events:5-1", "events:x", "why:triangle=-1",
                     "the weather", ""):
            self.assertIn("triscope: ", self.expect(USAGE, run("debug", ANNULUS, "--print", what)).stderr)
        for place in ("nowhere", "tick=x", "event=-1", "stage=lunch", "tick="):
            self.expect(USAGE, run("debug", ANNULUS, "--goto", place))

    def test_no_domain_no_answer(self):
        self.expect(NO_INPUT, run("debug", self.path("missing.json")))

    def test_control_c(self):
        process = subprocess.Popen([program.PROGRAM, "debug", self.long_domain()], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        time.sleep(0.5)
        self.assertIsNone(process.poll(), "the run ended before Ctrl+C was pressed")
        process.send_signal(signal.SIGINT)
        output, error = process.communicate(timeout=60)
        self.assertEqual(process.returncode, CANCELLED, error)
        self.assertEqual(output, "")


class Sessions(Debug):
    def test_written_and_replayed(self):
        for arguments in (("--goto", "stage=step3"), ("--break", "refused", "--break", "aspect < 3"), ()):
            self.expect(OK, run("debug", CRACKED, "--set", "omega=0.1", *arguments, "--save-session", self.path("s.json")))
            session = json.loads((self.folder / "s.json").read_text())
            self.assertEqual(session["format"], "triscope session")
            self.assertEqual(session["settings"]["omega"], 0.1)
            self.assertEqual([b["condition"] for b in session["breakpoints"]], list(arguments[1::2]) if "--break" in arguments else [])
            self.assertGreater(len(session["hashes"]), 5)
            text = self.expect(OK, run("replay", self.path("s.json"))).stdout
            self.assertIn(f"{len(session['hashes'])} stage ends", text)

    def session(self):
        self.expect(OK, run("debug", STEP, "--save-session", self.path("s.json")))
        return json.loads((self.folder / "s.json").read_text())

    def replay(self, session, code):
        return self.expect(code, run("replay", self.write("t.json", json.dumps(session))))

    def test_the_first_stage_that_differs_is_named(self):
        session = self.session()
        for k, stage in ((0, "constraints"), (9, session["hashes"][9]["stage"])):
            changed = json.loads(json.dumps(session))
            changed["hashes"][k]["hash"] = "0123456789abcdef"
            process = self.replay(changed, UNMET)
            self.assertIn("0123456789abcdef", process.stderr)
            self.assertIn(f"tick {session['hashes'][k]['tick']}", process.stderr)
            self.assertIn(stage.replace("step", "step "), process.stderr)

    def test_another_version_is_noted(self):
        session = self.session()
        self.assertEqual(self.replay(session, OK).stderr, "")
        session["program_version"], session["method_version"] = "0.0.1", 1
        self.assertIn("note: the session was saved by triscope 0.0.1 with version 1 of the method; this is ",
                      self.replay(session, OK).stderr)
        session["hashes"][0]["hash"] = "0123456789abcdef"
        self.assertIn("or saved by triscope 0.0.1", self.replay(session, UNMET).stderr)
        del session["method_version"]
        session["hashes"] = []
        self.assertIn("did not say which it was", self.replay(session, OK).stderr)

    def test_a_setting_that_was_changed_shows(self):
        session = self.session()
        session["settings"]["omega"] = 0.25
        self.assertIn("step 6", self.replay(session, UNMET).stderr)

    def test_the_domain_file_is_not_needed(self):
        domain = self.write("domain.json", pathlib.Path(STEP).read_text(encoding="utf-8"))
        self.expect(OK, run("debug", domain, "--save-session", self.path("s.json")))
        (self.folder / "domain.json").write_text("{}")
        self.assertIn("another text", self.expect(OK, run("replay", self.path("s.json"))).stderr)
        (self.folder / "domain.json").unlink()
        self.assertIn("is not there", self.expect(OK, run("replay", self.path("s.json"))).stderr)
        self.assertEqual(self.expect(OK, run("replay", "-q", self.path("s.json"))).stderr, "")

    def test_what_is_no_session(self):
        self.expect(NO_INPUT, run("replay", self.path("missing.json")))
        self.assertIn("no session file", self.expect(program.BAD_DATA, run("replay", STEP)).stderr)
        session = self.session()
        session["domain"]["text"] = "{"
        self.assertIn("t.json", self.replay(session, program.BAD_DATA).stderr)

    def test_a_session_that_cannot_be_written(self):
        process = run("debug", STEP, "--save-session", self.path("no such folder/s.json"))
        self.assertEqual(process.returncode, CANNOT_WRITE)


if __name__ == "__main__":
    program.main()
