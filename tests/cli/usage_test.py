"""What the command line takes, refuses and says."""

import json
import re

import program
from program import BAD_DATA, NO_INPUT, OK, STEP, USAGE, run


class Help(program.ProgramTest):
    def test_version_is_one_line_on_stdout(self):
        process = self.expect(OK, run("--version"))
        self.assertRegex(process.stdout, r"^triscope \d+\.\d+\.\d+\n$")

    def test_help_names_every_subcommand(self):
        text = self.expect(OK, run("--help")).stdout
        for word in ("mesh", "check", "figure", "settings", "FILE", "Exit codes"):
            self.assertIn(word, text)

    def test_each_subcommand_has_help(self):
        for command in ("mesh", "check", "figure", "settings"):
            self.assertIn("Usage:", self.expect(OK, run(command, "--help")).stdout)

    def test_settings_lists_what_set_takes(self):
        lines = self.expect(OK, run("settings")).stdout.split("\n\n")[0].splitlines()
        keys = [line.split()[0] for line in lines[1:]]
        self.assertIn("omega", keys)
        self.assertIn("min_edge_length", keys)
        for line in lines[1:]:
            default = re.split(r"\s{2,}|\s(?=\S)", line)
            self.assertGreaterEqual(len(default), 3, line)
        # Every key is taken: an absurd value is refused for its value, not for its key.
        for key in keys:
            error = self.expect(USAGE, run("mesh", STEP, "-o", self.path("a.msh"), "--set", f"{key}=absurd")).stderr
            self.assertIn(f"setting '{key}'", error)


    def test_settings_lists_the_presets_and_what_they_set(self):
        lines = self.expect(OK, run("settings")).stdout.split("\n\n")[1].splitlines()
        self.assertEqual([line.split()[0] for line in lines[1::2]], ["paper", "standard", "best"])
        for preset, sets in zip(lines[1::2], lines[2::2]):
            outputs = []
            for arguments in (["--preset", preset.split()[0]], [a for s in sets.split() for a in ("--set", s)]):
                outputs.append(self.path("a.su2"))
                self.expect(OK, run("mesh", STEP, "-o", outputs[-1], *arguments))
                outputs[-1] = open(outputs[-1], encoding="utf-8").read()
            self.assertEqual(*outputs, preset)

    def test_what_is_set_by_hand_comes_after_the_preset(self):
        for arguments in (["--preset", "best", "--set", "optimise=off"], ["--set", "optimise=off", "--preset", "best"]):
            report = self.path("r.json")
            self.expect(OK, run("mesh", STEP, "-o", self.path("a.msh"), "--report", report, *arguments))
            with open(report, encoding="utf-8") as file:
                stages = {s["key"]: s["decisions"] for s in json.load(file)["stages"]}
            self.assertEqual(stages["optimise"], 0)
            self.assertGreater(stages["rows"], 0)

    def test_an_unknown_preset_says_which_there_are(self):
        error = self.expect(USAGE, run("mesh", STEP, "-o", self.path("a.msh"), "--preset", "finest")).stderr
        self.assertIn("paper, standard, best", error)


class Refused(program.ProgramTest):
    def refused(self, *arguments):
        error = self.expect(USAGE, run(*arguments)).stderr
        self.assertEqual(self.files(), [])
        return error

    def test_option_that_does_not_exist(self):
        self.assertIn("--frobnicate", self.refused("mesh", STEP, "--frobnicate", "-o", self.path("a.msh")))

    def test_no_domain(self):
        self.assertIn("DOMAIN", self.refused("mesh", "-o", self.path("a.msh")))

    def test_nothing_to_write(self):
        self.assertIn("-o", self.refused("mesh", STEP))

    def test_setting_that_does_not_exist(self):
        error = self.refused("mesh", STEP, "-o", self.path("a.msh"), "--set", "omgea=0.1")
        self.assertIn("omgea", error)
        self.assertIn("omega", error)

    def test_setting_without_a_value(self):
        self.assertIn("key=value", self.refused("mesh", STEP, "-o", self.path("a.msh"), "--set", "omega"))

    def test_setting_out_of_range(self):
        error = self.refused("mesh", STEP, "-o", self.path("a.msh"), "--set", "omega=7")
        self.assertIn("from 0 to 1", error)

    def test_stage_that_does_not_exist(self):
        error = self.refused("mesh", STEP, "-o", self.path("a.msh"), "--until", "lunch")
        self.assertIn("lunch", error)
        for stage in ("constraints", "quadtree", "density", "boundary", "triangulation", "carve", "fronts", "step1",
                      "rounds", "refine"):
            self.assertIn(stage, error)

    def test_stage_that_comes_again(self):
        """In each round: which of them would be the last? 'triscope debug' goes to the first."""
        for stage in ("step2", "step3", "step4", "step5", "repair"):
            for command, option in (("mesh", "--until"), ("figure", "--stage")):
                error = self.refused(command, STEP, "-o", self.path("a.svg"), option, stage)
                self.assertIn(f"'{stage}' comes again in every round", error)
                self.assertIn("name rounds", error)
            self.expect(OK, run("debug", STEP, "-q", "--goto", f"stage={stage}"))

    def test_extension_that_is_not_known(self):
        for command in ("mesh", "figure"):
            error = self.refused(command, STEP, "-o", self.path("a.xyz"))
            self.assertIn("a.xyz", error)
            self.assertIn(".svg", error)

    def test_no_file_is_called_minus(self):
        ranges = ("--omega", "0.1", "--theta", "7")
        for option, command in (("-o", ("mesh", STEP)), ("--report", ("mesh", STEP)), ("--events", ("mesh", STEP)),
                                ("-o", ("figure", STEP)), ("-o", ("sweep", STEP, *ranges)),
                                ("--save-session", ("debug", STEP)), ("--screenshot", (STEP,)),
                                ("--state-file", (STEP,)), ("--preferences", (STEP,))):
            error = self.expect(USAGE, run(*command, option, "-", cwd=self.folder)).stderr
            self.assertIn(f"{option} takes the name of a file", error)
            self.assertEqual(self.files(), [])

    def test_extension_is_refused_before_the_domain_is_read(self):
        self.refused("mesh", "no such file.json", "-o", self.path("a.xyz"))

    def test_two_files_for_the_window(self):
        self.refused("a.json", "b.json")

    def test_picture_without_a_side(self):
        self.refused("figure", STEP, "-o", self.path("a.svg"), "--width", "0")


class NoInput(program.ProgramTest):
    def test_file_that_is_not_there(self):
        missing = self.path("missing.json")
        for arguments in (("mesh", missing, "-o", self.path("a.msh")), ("figure", missing, "-o", self.path("a.svg")),
                          ("check", self.path("missing.json.msh"))):
            error = self.expect(NO_INPUT, run(*arguments)).stderr
            self.assertIn("missing.json", error)
        self.assertEqual(self.files(), [])

    def test_folder_instead_of_a_file(self):
        self.expect(NO_INPUT, run("mesh", self.folder, "-o", self.path("a.msh")))


class WhatOthersWrote(program.ProgramTest):
    """Names in a file neither command the terminal nor fill it."""

    NAME = "\x1b[2J\x9b31m\r\ntriscope: fine\x7f" + 100000 * "x"
    SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
    HOLE = [[0.4, 0.4], [0.6, 0.4], [0.6, 0.6], [0.4, 0.6]]

    def plain(self, text):
        self.assertNotRegex(text, "[\x00-\x09\x0b-\x1f\x7f-\x9f]")
        self.assertNotIn("\ntriscope: fine", text)
        self.assertLess(len(text), 3000)

    def domain(self, **members):
        return self.write("d.json", json.dumps({"outer": self.SQUARE, **members}, ensure_ascii=False))

    def test_a_domain_that_is_wrong(self):
        hostile = {"name": self.NAME, "points": self.HOLE}
        beyond = {"name": self.NAME + "y", "points": [[x + 5, y] for x, y in self.HOLE]}
        crossing = {"points": [[x + 0.1, y + 0.1] for x, y in self.HOLE]}
        for members in ({"holes": [beyond]}, {"holes": [hostile, crossing]}, {"holes": [hostile, hostile]},
                        {"holes": [hostile], "density": [{"loop": "none", "length": 1}]},
                        {"density": [{"loop": self.NAME, "length": 1}]}, {"density": [{"name": self.NAME}]},
                        {"density": [{self.NAME: 1}]}, {"outer": {"kind": self.NAME}}):
            with self.subTest(list(members)):
                error = self.expect(BAD_DATA, run("mesh", self.domain(**members), "-o", self.path("a.msh"))).stderr
                self.plain(error)
                self.assertEqual(error.count("\n"), 1)
        for text in ('{"min_edge_length": 1' + 100000 * "0" + "}", '{"a": 1, "a": 2}'.replace("a", 1000 * "a")):
            self.plain(self.expect(BAD_DATA, run("mesh", self.write("d.json", text), "-o", self.path("a.msh"))).stderr)

    def test_notes_and_answers(self):
        self.domain(min_edge_length=0.1, density=[{"name": self.NAME, "at": [0.5, 0.5], "rank": 1}],
                    holes=[{"name": self.NAME, "points": self.HOLE}])
        process = run("mesh", self.path("d.json"), "-o", self.path("\x1ba.msh"), "--set", "min_edge_length=0.2")
        self.plain(self.expect(OK, process).stderr)
        self.assertIn("wrote ", process.stderr)
        self.expect(OK, run("mesh", STEP, "-q", "-o", self.path("b.msh")))
        self.plain(run("check", self.path("b.msh"), "--domain", self.path("d.json")).stdout)
        self.plain(self.expect(OK, run("debug", self.path("d.json"), "--print", "why:cell=1")).stdout)

    def test_arguments(self):
        for arguments in (("--\x1b",), ("mesh", "\x1b"), ("mesh", STEP, "-o", self.path("\x9b.xyz")),
                          ("mesh", STEP, "-o", self.path("a.msh"), "--set", "\x1b=1"),
                          ("mesh", STEP, "-o", self.path("a.msh"), "--set", "omega=\x1b")):
            self.plain(run(*arguments).stderr)


if __name__ == "__main__":
    program.main()
