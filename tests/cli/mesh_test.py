"""triscope mesh: what it writes, what it says, and that it never harms a file on an error."""

import json
import math
import os
import pathlib
import pty
import re
import select
import signal
import subprocess
import time

import program
from program import (BAD_DATA, BLUNT_BODY, CANNOT_WRITE, NO_MEMORY, OK, STEP, UNMET, USAGE, run, run_within)

STAGES = ["constraints", "quadtree", "density", "boundary", "triangulation", "carve", "fronts", "step1", "rounds", "refine"]
FIGURES = ["vertices", "triangles", "boundary_vertices", "estimated_triangles", "aspect_ratio_max", "area_ratio_max",
           "edge_ratio_max", "min_angle_deg", "max_angle_deg", "obtuse", "min_edge_length"]


# Chains so close together that a point on one is too near to the next.
NARROW_HUB = '{"outer": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "min_edge_length": 0.5, "segments": [' \
             '[[0, 0], [0.3, 6e-7]], [[0, 0], [0.7, 1e-6]], [[0, 0], [0.9, 2e-6]]]}'


class Outputs(program.ProgramTest):
    def test_every_format(self):
        names = ["a.msh", "a.vtu", "a.node", "a.svg", "a.png"]
        arguments = [part for name in names for part in ("-o", self.path(name))]
        process = self.expect(OK, run("mesh", STEP, *arguments))
        self.assertEqual(process.stdout, "")
        self.assertEqual(self.files(), sorted(names + ["a.ele", "a.poly"]))
        self.assertTrue((self.folder / "a.msh").read_text().startswith("$MeshFormat\n4.1 "))
        self.assertTrue((self.folder / "a.png").read_bytes().startswith(b"\x89PNG\r\n"))
        self.assertIn("<svg", (self.folder / "a.svg").read_text())

    def test_msh2(self):
        self.expect(OK, run("mesh", STEP, "-o", self.path("a.msh"), "--msh2"))
        self.assertTrue((self.folder / "a.msh").read_text().startswith("$MeshFormat\n2.2 "))

    def test_quiet_says_nothing(self):
        process = self.expect(OK, run("mesh", STEP, "-o", self.path("a.msh"), "-q"))
        self.assertEqual((process.stdout, process.stderr), ("", ""))

    def test_without_a_terminal_no_control_characters(self):
        process = self.expect(OK, run("mesh", BLUNT_BODY, "-o", self.path("a.msh")))
        self.assertNotIn("\r", process.stderr)
        self.assertNotIn("\x1b", process.stderr)
        self.assertIn("triangles", process.stderr)
        self.assertIn("a.msh", process.stderr)

    def test_same_bytes_twice(self):
        for name in ("a.msh", "b.msh"):
            self.expect(OK, run("mesh", BLUNT_BODY, "-o", self.path(name)))
        self.assertEqual((self.folder / "a.msh").read_bytes(), (self.folder / "b.msh").read_bytes())

    def test_report_has_every_figure(self):
        self.expect(OK, run("mesh", BLUNT_BODY, "--report", self.path("r.json")))
        report = json.loads((self.folder / "r.json").read_text())
        for key in FIGURES:
            self.assertIn(key, report)
        self.assertGreater(report["triangles"], 1000)
        self.assertLess(report["aspect_ratio_max"], 4.31)
        self.assertGreater(report["rounds"], 0)
        self.assertGreater(report["passes"], 0)
        for stage in report["stages"]:
            for key in ("seconds", "inserted", "refused", "moved"):
                self.assertIn(key, stage)
        self.assertGreater(sum(stage["inserted"] for stage in report["stages"]), 500)
        self.assertGreater(sum(stage["seconds"] for stage in report["stages"]), 0)

    def test_report_into_a_pipe(self):
        process = self.expect(OK, run("mesh", STEP, "-q", "--report", "/dev/stdout"))
        self.assertIn("triangles", json.loads(process.stdout))

    def test_report_on_a_full_disk(self):
        self.expect(CANNOT_WRITE, run("mesh", STEP, "-q", "--report", "/dev/full"))

    def test_events_are_one_json_object_a_line(self):
        self.expect(OK, run("mesh", STEP, "--events", self.path("e.jsonl")))
        lines = (self.folder / "e.jsonl").read_text().splitlines()
        self.assertGreater(len(lines), 10)
        version = self.expect(OK, run("--version")).stdout.split()[1]
        self.assertEqual(json.loads(lines[0])["program_version"], version)
        for number, line in enumerate(lines[1:]):
            self.assertEqual(json.loads(line)["event"], number)

    def test_a_listener_does_not_change_the_mesh(self):
        self.expect(OK, run("mesh", BLUNT_BODY, "-o", self.path("a.msh")))
        self.expect(OK, run("mesh", BLUNT_BODY, "-o", self.path("b.msh"), "--events", self.path("e.jsonl")))
        self.assertEqual((self.folder / "a.msh").read_bytes(), (self.folder / "b.msh").read_bytes())

    def test_a_request_below_the_smallest_edge_is_noted(self):
        domain = self.write("d.json", json.dumps({"outer": [[0, 0], [1, 0], [1, 1], [0, 1]], "density": [
            {"name": "fine", "at": [0.5, 0.5], "length": 0.01}, {"at": [0.2, 0.5], "length": 0.1}]}))
        error = self.expect(OK, run("mesh", domain, "-o", self.path("a.msh"))).stderr
        self.assertEqual(error.count("note: density entry"), 1)
        self.assertIn("note: density entry 'fine' asks for edges of length 0.01, but gets none below", error)
        error = run("mesh", domain, "-o", self.path("a.msh"), "--set", "min_edge_length=0.01").stderr
        self.assertNotIn("note: density", error)

    def test_settings_matter(self):
        triangles = {}
        for edge in ("1", "2"):
            self.expect(OK, run("mesh", BLUNT_BODY, "--report", self.path("r.json"), "--set", f"min_edge_length={edge}",
                                "--set", "laplacian=off"))
            triangles[edge] = json.loads((self.folder / "r.json").read_text())["triangles"]
        self.assertGreater(triangles["1"], triangles["2"])


class Limit(program.ProgramTest):
    """A mesh that would be too large is not begun; the message says what asks for it and what to change."""

    BOX = str(program.SOURCE / "tests" / "data" / "refused" / "box_1e16_triangles.json")

    def test_every_subcommand_that_meshes(self):
        for arguments in (["mesh", self.BOX, "-o", self.path("a.msh")], ["figure", self.BOX, "-o", self.path("a.svg")],
                          ["sweep", self.BOX, "--omega", "0.1", "--theta", "7", "-o", self.path("a.csv")]):
            error = self.expect(BAD_DATA, run(*arguments)).stderr
            for words in ("e+15 triangles", "density entry 1", "max_triangles"):
                self.assertIn(words, error)
            self.assertEqual(self.files(), [])

    def test_debug_shows_where_it_stops(self):
        process = self.expect(OK, run("debug", self.BOX, "--print", "events:0-99999999", "-q"))
        self.assertIn("more triangles than max_triangles allows", process.stdout)

    def test_the_limit_can_be_moved(self):
        for option in (["--max-triangles", "1000"], ["--set", "max_triangles=1000"]):
            error = self.expect(BAD_DATA, run("mesh", BLUNT_BODY, "-q", "-o", self.path("a.msh"), *option)).stderr
            self.assertIn("max_triangles is 1000", error)
        self.expect(USAGE, run("mesh", BLUNT_BODY, "-o", self.path("a.msh"), "--max-triangles", "many"))
        self.expect(OK, run("mesh", BLUNT_BODY, "-o", self.path("a.msh"), "--max-triangles", "100000"))

    def test_what_is_advised_suffices(self):
        for box, most in ((0.6, 20000), (1.0, 3000), (0.13, 700)):
            for length in (0.0007, 0.001, 0.0021):
                domain = {"outer": [[0, 0], [1, 0], [1, 1], [0, 1]], "min_edge_length": 0.0005,
                          "density": [{"box": [[0.1, 0.1], [0.1 + box, 0.1 + box]], "length": length}]}
                command = ("mesh", "-q", "--set", "optimise=off", "-o", self.path("a.msh"), "--max-triangles", str(most))
                error = self.expect(BAD_DATA, run(*command, self.write("d.json", json.dumps(domain)))).stderr
                domain["density"][0]["length"] = float(re.search(r"ask for edges of (\S+) or longer", error)[1])
                self.expect(OK, run(*command, self.write("d.json", json.dumps(domain))))
        error = self.expect(BAD_DATA, run("mesh", BLUNT_BODY, "-q", "-o", self.path("a.msh"), "--max-triangles",
                                          "1000")).stderr
        length = re.search(r"min_edge_length of (\S+) or more", error)[1]
        self.expect(OK, run("mesh", BLUNT_BODY, "-q", "-o", self.path("a.msh"), "--max-triangles", "1000",
                            "--set", "min_edge_length=" + length))

    def test_edges_that_are_kept_are_held_to_the_limit_too(self):
        spokes = 300
        turn = 2 * math.pi / spokes
        hub = self.write("hub.json", json.dumps({
            "outer": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "min_edge_length": 0.3,
            "segments": [[[0, 0], [0.9 * math.cos(k * turn), 0.9 * math.sin(k * turn)]] for k in range(spokes)]}))
        error = self.expect(BAD_DATA, run("mesh", hub, "-q", "-o", self.path("a.msh"), "--max-triangles", "1500")).stderr
        self.assertIn("because of edges that it has to keep", error)
        self.assertNotIn("min_edge_length", error)
        self.assertEqual(self.files(), ["hub.json"])

    def test_a_refusal_leaves_every_file(self):
        names = ["a.msh", "r.json", "e.jsonl"]
        for name in names:
            self.write(name, "old")
        self.expect(BAD_DATA, run("mesh", BLUNT_BODY, "-o", self.path("a.msh"), "--report", self.path("r.json"),
                                  "--events", self.path("e.jsonl"), "--max-triangles", "10"))
        self.assertEqual([(self.folder / name).read_text() for name in names], ["old"] * 3)

    def test_the_estimate_is_told(self):
        error = self.expect(OK, run("mesh", BLUNT_BODY, "-o", self.path("a.msh"))).stderr
        self.assertRegex(error, r"about \d+ triangles and [\d.]+ [kM]B of memory by the estimate of Table 1\n")
        self.assertLess(error.index("estimate"), error.index("vertices in"), "it is told before the mesh is made")
        error = self.expect(OK, run("mesh", BLUNT_BODY, "-o", self.path("a.svg"), "--until", "quadtree")).stderr
        self.assertNotIn("estimated", error)


class Memory(program.ProgramTest):
    """Too little memory is no defect of the program, and harms no file."""

    ROOM = 300  # megabytes

    def setUp(self):
        super().setUp()
        if run_within(self.ROOM, "--version").returncode != OK:
            self.skipTest("the program alone takes more room, as under the sanitizers")
        self.large = self.write("large.json", json.dumps({
            "outer": [[0, 0], [1, 0], [1, 1], [0, 1]], "min_edge_length": 0.0004,
            "density": [{"box": [[0, 0], [1, 1]], "length": 0.0004}]}))
        self.write("a.msh", "precious")

    def test_is_said_in_words(self):
        error = self.expect(NO_MEMORY, run_within(self.ROOM, "mesh", self.large, "-q", "-o", self.path("a.msh"))).stderr
        self.assertIn("not enough memory", error)
        self.assertNotIn("defect", error)
        self.assertEqual((self.folder / "a.msh").read_text(), "precious")
        self.assertEqual(self.files(), ["a.msh", "large.json"])


class Bounds(program.ProgramTest):
    """A mesh that breaks a bound is a mesh: exit code 0, and a note that says where, and whether the input excuses it."""

    def notes(self, outer):
        domain = self.write("d.json", json.dumps({"outer": outer}))
        error = self.expect(OK, run("mesh", domain, "-o", self.path("a.msh"), "--report", self.path("r.json"))).stderr
        report = json.loads((self.folder / "r.json").read_text())
        notes = [line for line in error.splitlines() if line.startswith("note: ") and " dial " not in line]
        self.assertEqual(report["bounds_met"], not notes)
        return notes

    def test_no_note_where_all_are_met(self):
        self.assertEqual(self.notes([[0, 0], [4, 0], [4, 3], [0, 3]]), [])

    def test_what_the_dial_asks_for_is_no_bound(self):
        """Short of it, the mesh is told of in one line, with what stands in the way."""
        path = self.write("d.json", json.dumps({"outer": [[0, 0], [12, 0], [12, 8.4]], "min_edge_length": 0.3}))
        error = self.expect(OK, run("mesh", path, "-o", self.path("a.msh"))).stderr
        self.assertIn("note: short of what the dial asks for: smallest angle 35.0, not 44, at the input angle of 35.0° at (0, 0)",
                      error)
        self.assertEqual(error.count("note: "), 1)
        self.assertNotIn("note: ", self.expect(OK, run("mesh", path, "-o", self.path("a.msh"), "--set", "optimise=off")).stderr)

    def test_an_input_angle_excuses(self):
        notes = self.notes([[0, 0], [4, 0], [4, 1]])
        self.assertRegex("\n".join(notes), r"note: smallest angle 1[34]\S*, not > 30, at the input angle of 14\.0° at "
                                           r"\(0, 0\), below 60°: no mesh can meet it there")
        text = self.expect(UNMET, run("check", self.path("a.msh"))).stdout
        self.assertRegex(text, r"min_angle_deg +1[34]\S* +> 30 +not met +triangle .*at the input angle of 14.0° at")


class CannotGoOn(program.ProgramTest):
    def test_where_many_curves_meet_their_point_is_named(self):
        path = self.write("hub.json", NARROW_HUB)
        error = self.expect(UNMET, run("mesh", path, "-q", "-o", self.path("a.msh"))).stderr
        self.assertRegex(error, r"cannot go on in stage boundary recovery: .*; 3 curves meet at \(0, 0\);")
        self.assertEqual(self.files(), ["hub.json"])

    def test_a_point_of_fewer_is_not(self):
        path = self.write("two.json", NARROW_HUB.replace("[[0, 0], [0.3, 6e-7]], ", "").replace("2e-6", "1.1e-6"))
        error = self.expect(UNMET, run("mesh", path, "-q", "-o", self.path("a.msh"))).stderr
        self.assertIn("cannot go on in stage boundary recovery", error)
        self.assertNotIn("curves meet", error)


class Undercut(program.ProgramTest):
    """An edge below the smallest length that was given is named, with what it lies on."""

    OUTER = [[0, 0], [4, 0], [4, 3], [0.05, 3], [0, 2.95]]  # its last corner is cut off by an edge of 0.07

    def error(self, *options, **domain):
        path = self.write("d.json", json.dumps({"outer": self.OUTER, **domain}))
        return self.expect(OK, run("mesh", path, *options, "--report", self.path("r.json"))).stderr

    def test_a_shorter_kept_edge_is_named(self):
        self.assertRegex(self.error("--set", "optimise=off", min_edge_length=0.08),
                         r"note: the shortest edge, 0\.07071 at \(0\.025, 2\.975\), is below the min_edge_length given, "
                         r"0\.08: it is a piece of 'outer'")

    def test_so_is_one_beside_it(self):
        self.assertRegex(self.error(min_edge_length=0.5), r"note: the shortest edge, 0\.\d+ at .* given, 0\.5: it is near ")

    def test_nothing_is_said_where_none_is_shorter(self):
        self.assertNotIn("note: the shortest edge", self.error("--set", "optimise=off", min_edge_length=0.07))
        self.assertGreaterEqual(json.loads((self.folder / "r.json").read_text())["min_edge_length"], 0.07)

    def test_optimised_only_one_below_half_of_it(self):
        """Edges as long as is wanted on the whole are partly shorter."""
        self.assertNotIn("note: the shortest edge", self.error(min_edge_length=0.08))
        self.assertIn("note: the shortest edge, 0.07071 at", self.error(min_edge_length=0.15))

    def test_nothing_is_said_of_a_derived_length(self):
        self.assertNotIn("note: the shortest edge", self.error())


class Until(program.ProgramTest):
    def test_every_stage_can_be_the_last(self):
        seen = []
        for stage in STAGES:
            self.expect(OK, run("mesh", STEP, "--until", stage, "--report", self.path("r.json"), "-o",
                                self.path("a.svg")))
            seen.append(json.loads((self.folder / "r.json").read_text())["triangles"])
        self.assertEqual(seen[0], 0)
        self.assertEqual(seen, sorted(seen[:5]) + seen[5:], "a stage up to the triangulation lost triangles")
        self.assertGreater(seen[8], seen[5])

    def test_each_front_can_be_the_last(self):
        seen = []
        for stage in ("carve", "front1", "front2", "fronts"):
            self.expect(OK, run("mesh", STEP, "--until", stage, "--report", self.path("r.json")))
            seen.append(json.loads((self.folder / "r.json").read_text())["triangles"])
        self.assertTrue(seen[0] < seen[1] < seen[2] == seen[3], seen)

    def test_a_mesh_file_needs_a_mesh(self):
        error = self.expect(USAGE, run("mesh", STEP, "--until", "density", "-o", self.path("a.msh"))).stderr
        self.assertIn("triangulation", error)
        self.assertEqual(self.files(), [])


class NoHarm(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("a.msh", "precious")

    def unharmed(self):
        self.assertEqual(self.files(), ["a.msh"])
        self.assertEqual((self.folder / "a.msh").read_text(), "precious")

    def test_bad_domain(self):
        for text, words in (("{", "JSON"), ('{"outer": [[0,0],[1,0]]}', "outer"), ("[]", ""),
                            ('{"outer": [[0,0],[1,1],[1,0],[0,1]]}', "cross")):
            domain = self.write("bad.json", text)
            error = self.expect(BAD_DATA, run("mesh", domain, "-o", self.path("a.msh"))).stderr
            self.assertIn("bad.json", error)
            self.assertIn(words, error)
            os.remove(domain)
            self.unharmed()

    def test_one_output_that_cannot_be_written(self):
        bad = self.path("no such folder/a.svg")
        error = self.expect(CANNOT_WRITE, run("mesh", STEP, "-o", bad, "-o", self.path("a.msh"))).stderr
        self.assertIn("no such folder", error)
        self.unharmed()

    def test_output_that_is_a_folder(self):
        (self.folder / "b.msh").mkdir()
        self.expect(CANNOT_WRITE, run("mesh", STEP, "-o", self.path("b.msh")))
        (self.folder / "b.msh").rmdir()
        self.unharmed()

    def test_folder_that_may_not_be_written(self):
        if os.geteuid() == 0:
            self.skipTest("root may write everywhere")
        self.folder.chmod(0o500)
        self.expect(CANNOT_WRITE, run("mesh", STEP, "-o", self.path("a.msh")))
        self.folder.chmod(0o700)
        self.unharmed()

    def interrupt(self, number):
        process = subprocess.Popen(
            [program.PROGRAM, "mesh", self.long_domain(), "-o", self.path("a.msh"), "--report", self.path("r.json"), "--events",
             self.path("e.jsonl")], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        time.sleep(0.5)
        self.assertIsNone(process.poll(), "the run ended before Ctrl+C was pressed")
        process.send_signal(number)
        _, error = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 128 + number, error)
        self.assertIn("nothing was written", error)
        self.unharmed()

    def test_control_c(self):
        self.interrupt(signal.SIGINT)

    def test_terminate(self):
        self.interrupt(signal.SIGTERM)


class Terminal(program.ProgramTest):
    def on_terminal(self, **env):
        """Runs with stderr on a pseudo-terminal, long enough for a bar; returns what was shown there."""
        square = {"outer": [[0, 0], [1, 0], [1, 1], [0, 1]], "min_edge_length": 0.004,
                  "density": [{"box": [[0, 0], [1, 1]], "length": 0.004}]}
        pathlib.Path(self.path("square.json")).write_text(json.dumps(square), encoding="utf-8")
        master, slave = pty.openpty()
        process = subprocess.Popen([program.PROGRAM, "mesh", self.path("square.json"), "-o", self.path("a.msh")],
                                   stderr=slave, stdout=subprocess.DEVNULL, env={**os.environ, "TERM": "xterm", **env})
        os.close(slave)
        shown = b""
        while True:
            ready, _, _ = select.select([master], [], [], 60)
            try:
                piece = os.read(master, 65536) if ready else b""
            except OSError:  # the other side is closed
                piece = b""
            if not piece:
                break
            shown += piece
        os.close(master)
        self.assertEqual(process.wait(timeout=60), OK)
        return shown.decode()

    def test_progress_and_color(self):
        shown = self.on_terminal(NO_COLOR="")
        self.assertIn("\r", shown)
        self.assertIn("\x1b[36m", shown)

    def test_no_color(self):
        shown = self.on_terminal(NO_COLOR="1")
        self.assertIn("\r", shown)
        self.assertNotIn("\x1b[3", shown)

    def test_dumb_terminal(self):
        self.assertNotIn("\x1b", self.on_terminal(TERM="dumb"))


if __name__ == "__main__":
    program.main()
