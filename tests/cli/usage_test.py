"""What the command line takes, refuses and says."""

import re

import program
from program import NO_INPUT, OK, STEP, USAGE, run


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
        lines = self.expect(OK, run("settings")).stdout.splitlines()
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


if __name__ == "__main__":
    program.main()
