"""The standard streams: closed, full, or led into a file of the command's own."""

import os
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


class Descriptors(StreamsTest):
    """/dev/stdout and its like are written to from where they stand, whatever they lead to."""

    def setUp(self):
        super().setUp()
        self.expect(OK, run("mesh", STEP, "-q", "-o", self.path("right.su2")))
        self.mesh = self.read("right.su2")

    def test_what_a_file_holds_stays(self):
        for name in ("/dev/stdout", "/proc/self/fd/1", "/dev/fd/1"):
            with self.subTest(name):
                os.symlink(name, self.path("o.su2"))
                self.assertEqual(self.shell("(echo header; triscope mesh d.json -o o.su2 -q; echo footer) > a.txt").returncode, OK)
                self.assertEqual(self.read("a.txt"), f"header\n{self.mesh}footer\n")
                self.assertEqual(self.shell("triscope mesh d.json -o o.su2 -q >> a.txt").returncode, OK)
                self.assertEqual(self.read("a.txt"), f"header\n{self.mesh}footer\n{self.mesh}")
                os.remove(self.path("o.su2"))
        for name, stream in (("/dev/stderr", "2"), ("/dev/fd/7", "7"), ("/proc/self/fd/7", "7")):
            for option in ("--report", "--events"):
                self.write("a.txt", "header\n")
                self.expect(OK, self.shell(f"triscope mesh d.json -q {option} {name} {stream}>> a.txt"))
                self.assertRegex(self.read("a.txt"), r"\Aheader\n\{")

    def test_more_than_one(self):
        self.expect(OK, self.shell("triscope mesh d.json -q --report /dev/stdout --events /dev/stdout > a.txt"))
        text = self.read("a.txt")
        self.assertIn('"estimated_triangles"', text)
        self.assertIn('"stage begun"', text)

    def test_beside_answers(self):
        self.expect(OK, self.shell("triscope debug d.json -q --save-session /dev/stdout > a.txt"))
        self.assertRegex(self.read("a.txt"), r'(?s)\A\{.*"hashes".*\}\ntick ')

    def test_nothing_before_all_is_complete(self):
        self.write("a.txt", "header\n")
        self.expect(CANNOT_WRITE, self.shell("triscope mesh d.json -q --report /dev/stdout --events /dev/full >> a.txt"))
        self.assertEqual(self.read("a.txt"), "header\n")

    def test_what_cannot_be_written_to(self):
        self.write("other", "")
        for stream in ("1>&-", "1< other"):
            process = self.expect(CANNOT_WRITE, self.shell(f"triscope mesh d.json -q -o x.su2 --report /dev/stdout {stream}"))
            self.assertIn("/dev/stdout", process.stderr)
        self.expect(CANNOT_WRITE, self.shell("triscope mesh d.json -q --report /dev/fd/9"))
        self.assertEqual(self.read("d.json"), self.text)
        self.assertFalse((self.folder / "x.su2").exists())


class LedIntoAFile(StreamsTest):
    """No standard stream leads into a file that the command reads or names: it says so before any work."""

    def refused(self, line, what, kept):
        with self.subTest(line):
            before = self.read(kept)
            process = self.shell(line)
            self.assertEqual(process.returncode, USAGE, process.stderr)
            self.assertIn(f"led into {what}; lead it into another file", process.stderr + process.stdout)
            self.assertEqual(self.read(kept), before)
            self.assertFalse((self.folder / "new.msh").exists())

    def test_an_input(self):
        self.expect(OK, run("mesh", STEP, "-q", "-o", self.path("m.msh"), "-o", self.path("m.node")))
        self.expect(OK, run("debug", STEP, "--save-session", self.path("s.json")))
        os.symlink("d.json", self.path("soft.json"))
        for stream in ("", "2"):
            self.refused(f"triscope debug d.json {stream}>> d.json", "the domain", "d.json")
            self.refused(f"triscope debug soft.json {stream}>> d.json", "the domain", "d.json")
            self.refused(f"triscope mesh d.json -o new.msh {stream}>> d.json", "the domain", "d.json")
            self.refused(f"triscope figure d.json -o new.svg {stream}>> d.json", "the domain", "d.json")
            self.refused(f"triscope sweep d.json --omega 0.1 --theta 7 {stream}>> d.json", "the domain", "d.json")
            self.refused(f"triscope check m.msh {stream}>> m.msh", "the mesh", "m.msh")
            self.refused(f"triscope check m.node {stream}>> m.ele", "the mesh", "m.ele")
            self.refused(f"triscope check m.msh --domain d.json {stream}>> d.json", "the domain", "d.json")
            self.refused(f"triscope check /dev/stdin < m.msh {stream}>> m.msh", "the mesh", "m.msh")
            self.refused(f"triscope replay s.json {stream}>> s.json", "the session", "s.json")

    def test_an_output(self):
        self.write("s", "")
        for stream in ("", "2"):
            self.refused(f"triscope debug d.json --save-session s {stream}> s", "--save-session", "s")
            self.refused(f"triscope mesh d.json --report s {stream}>> s", "--report", "s")
            self.refused(f"triscope sweep d.json --omega 0.1 --theta 7 -o s {stream}>> s", "-o", "s")

    def test_both_streams(self):
        """Then there is nowhere left to say it."""
        self.assertEqual(self.shell("triscope debug d.json >> d.json 2>&1").returncode, USAGE)
        self.assertEqual(self.read("d.json"), self.text)

    def test_other_files(self):
        self.expect(OK, self.shell("triscope debug d.json > a.txt 2>&1"))
        self.expect(OK, self.shell("triscope mesh d.json --report /dev/stdout > b.txt 2> c.txt"))
        self.expect(OK, self.shell("triscope mesh d.json --report /dev/stdout > d.txt 2>&1"))


if __name__ == "__main__":
    program.main()
