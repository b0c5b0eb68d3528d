"""The standard streams: closed, full, or led into a file of the command's own."""

import pathlib
import subprocess

import program
from program import BLUNT_BODY, CANNOT_WRITE, OK, STEP, USAGE, run


class StreamsTest(program.ProgramTest):
    def shell(self, line):
        """What a shell makes of the line; `triscope` is the program, and files are named in the folder of the test."""
        script = f'triscope() {{ "{program.PROGRAM}" "$@"; }}\n{line}'
        return subprocess.run(["bash", "-c", script], cwd=self.folder, capture_output=True, text=True, timeout=120,
                              stdin=subprocess.DEVNULL, check=False)

    def setUp(self):
        super().setUp()
        self.text = pathlib.Path(STEP).read_text(encoding="utf-8")
        self.write("d.json", self.text)

    def read(self, name):
        return (self.folder / name).read_text(encoding="utf-8")


class CannotBeWritten(StreamsTest):
    def test_messages(self):
        """They change nothing: neither the files nor the exit code."""
        self.expect(OK, run("mesh", STEP, "-q", "-o", self.path("right.msh")))
        for stream in ("2>&-", "2>/dev/full", ">&- 2>&-", "<&- >&- 2>&-"):
            with self.subTest(stream):
                self.assertEqual(self.shell(f"triscope mesh d.json -o o.msh --set omega=0.4 {stream}").returncode, OK)
                self.assertEqual(self.shell(f"triscope mesh d.json -o o.msh {stream}").returncode, OK)
                self.assertEqual(self.read("o.msh"), self.read("right.msh"))
                self.assertEqual(self.shell(f"triscope mesh d.json {stream}").returncode, USAGE)

    def test_answers(self):
        self.expect(OK, run("mesh", STEP, "-q", "-o", self.path("o.msh"), "--until", "carve"))
        self.expect(OK, run("debug", STEP, "--save-session", self.path("s.json")))
        for stream in (">/dev/full", ">&-"):
            for command in ("check o.msh", f"check o.msh --domain {BLUNT_BODY}", "debug d.json",
                            "debug d.json --print events:0-2000", "settings", "--help", "mesh --help", "--version",
                            "replay s.json", "sweep d.json -q --omega 0.1 --theta 7"):
                with self.subTest(command + stream):
                    process = self.expect(CANNOT_WRITE, self.shell(f"triscope {command} {stream}"))
                    self.assertIn("cannot write to the standard output", process.stderr)


if __name__ == "__main__":
    program.main()
