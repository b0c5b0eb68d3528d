"""Files of users: never overwritten by mistake, all new or all old, and no signal leaves half of one."""

import json
import os
import pathlib
import resource
import signal
import stat
import subprocess
import tempfile
import time

import program
from program import (CANCELLED, CANNOT_WRITE, LONG_RUN, OK, STEP, TERMINATED, USAGE, run)

RANGES = ["--omega", "0.1", "--theta", "7"]


class Overwrites(program.ProgramTest):
    """No output is an input or another output, whatever it is called; nothing is read or made before that is known."""

    def setUp(self):
        super().setUp()
        self.text = pathlib.Path(STEP).read_text(encoding="utf-8")
        for name in ("b.json", "b.svg", "b.msh"):
            self.write(name, self.text)
        os.symlink("b.json", self.path("soft.json"))
        os.link(self.path("b.json"), self.path("hard.json"))
        os.mkdir(self.path("sub"))
        os.symlink("sub", self.path("folder"))
        self.before = self.files()

    def refused(self, *arguments, words=("would overwrite",), env=None):
        with self.subTest(arguments):
            error = self.expect(USAGE, run(*arguments, timeout=30, env=env)).stderr
            for word in words:
                self.assertIn(word, error)
            self.assertIn("name another file", error)
            self.assertEqual(self.files(), self.before)
            for name in ("b.json", "b.svg", "b.msh"):
                self.assertEqual((self.folder / name).read_text(encoding="utf-8"), self.text)

    def test_an_input(self):
        domain = self.path("b.json")
        x = self.path("x.msh")
        for name in ("b.json", "soft.json", "hard.json", "sub/../b.json", "folder/../b.json"):
            for option in ("--report", "--events"):
                self.refused("mesh", domain, "-o", x, option, self.path(name), words=(option, "the domain"))
            self.refused("debug", domain, "--save-session", self.path(name), words=("--save-session", "the domain"))
            self.refused("sweep", domain, *RANGES, "-o", self.path(name), words=("-o", "the domain"))
            self.refused("--state-file", self.path(name), domain, words=("--state-file", "the file to open"))
            self.refused("--preferences", self.path(name), domain, words=("--preferences", "the file to open"))
            self.refused("--screenshot", self.path(name), domain, words=("--screenshot", "the file to open"))
        self.refused("mesh", self.path("b.msh"), "-o", self.path("b.msh"))
        self.refused("mesh", self.path("b.svg"), "-o", self.path("b.svg"))
        self.refused("figure", self.path("b.svg"), "-o", self.path("b.svg"))

    def test_an_input_by_a_relative_name(self):
        process = subprocess.run([program.PROGRAM, "mesh", "b.json", "--report", self.path("b.json")],
                                 cwd=self.folder, capture_output=True, text=True, timeout=30, check=False)
        self.expect(USAGE, process)
        self.assertEqual((self.folder / "b.json").read_text(encoding="utf-8"), self.text)

    def test_another_output(self):
        domain = self.path("b.json")
        x = self.path("x.svg")
        self.refused("mesh", domain, "-o", x, "--report", x, words=("--report", "-o"))
        self.refused("mesh", domain, "-o", x, "--events", self.path("sub/../x.svg"))
        self.refused("mesh", domain, "-o", x, "-o", x)
        self.refused("mesh", domain, "-o", self.path("sub/x.msh"), "-o", self.path("folder/x.msh"))
        self.refused("mesh", domain, "--report", x, "--events", x)
        self.refused("mesh", domain, "-o", self.path("a.node"), "--report", self.path("a.ele"))
        self.refused("mesh", domain, "-o", self.path("a.node"), "--events", self.path("a.poly"))
        self.refused("figure", domain, "-o", x, "-o", x)
        self.refused("--state-file", x, "--preferences", x)

    def test_an_input_called_like_a_temporary_file(self):
        os.symlink(".x.msh.99999-0.tmp", self.path("y.json"))
        for name in (".x.msh.99999-0.tmp", "y.json"):
            self.write(".x.msh.99999-0.tmp", self.text)
            self.expect(OK, run("mesh", self.path(name), "-q", "-o", self.path("x.msh")))
            self.assertEqual((self.folder / name).read_text(encoding="utf-8"), self.text)

    def test_it_is_known_before_any_work(self):
        os.mkfifo(self.path("pipe"))
        self.before = self.files()
        self.refused("mesh", self.path("pipe"), "-o", self.path("x.svg"), "--report", self.path("x.svg"))

    def test_a_pipe_overwrites_nothing(self):
        self.expect(OK, run("mesh", STEP, "-q", "--report", "/dev/null", "--events", "/dev/null"))


class OneUnit(program.ProgramTest):
    """All outputs are new, or all are old."""

    NAMES = ("a.msh", "a.node", "a.ele", "a.poly", "r.json", "e.jsonl")

    def setUp(self):
        super().setUp()
        for name in self.NAMES:
            self.write(name, "precious")

    def command(self, domain=STEP):
        return ["mesh", domain, "-q", "-o", self.path("a.msh"), "-o", self.path("a.node"), "--report",
                self.path("r.json"), "--events", self.path("e.jsonl")]

    def unharmed(self, *others):
        self.assertEqual(self.files(), sorted([*self.NAMES, *others]))
        for name in self.NAMES:
            self.assertEqual((self.folder / name).read_text(encoding="utf-8"), "precious")

    def test_all_new(self):
        self.expect(OK, run(*self.command()))
        self.assertEqual(self.files(), sorted(self.NAMES))
        for name in self.NAMES:
            self.assertNotEqual((self.folder / name).read_text(encoding="utf-8"), "precious")

    def test_the_last_is_refused(self):
        self.expect(CANNOT_WRITE, run(*self.command()[:-1], "/dev/full"))
        self.unharmed()

    def test_a_protected_file_is_not_replaced(self):
        os.chmod(self.path("r.json"), 0o444)
        error = self.expect(CANNOT_WRITE, run(*self.command())).stderr
        self.assertIn("r.json", error)
        self.assertIn("protected", error)
        self.unharmed()

    def test_mode_is_kept(self):
        os.chmod(self.path("a.msh"), 0o600)
        self.expect(OK, run(*self.command()))
        self.assertEqual(stat.S_IMODE(os.stat(self.path("a.msh")).st_mode), 0o600)

    def test_a_limit_on_the_size_of_files(self):
        limit = 20000  # enough for some of the files, not for all

        def shrink():
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

        process = subprocess.run([program.PROGRAM, *self.command()], capture_output=True, text=True, timeout=120,
                                 preexec_fn=shrink, check=False)
        self.expect(CANNOT_WRITE, process)
        self.unharmed()

    def test_a_full_disk(self):
        disk = self.path("disk")
        os.mkdir(disk)
        if os.geteuid() != 0 or subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "none", disk],
                                               capture_output=True, check=False).returncode != 0:
            self.skipTest("only root may make a small disk, and not everywhere")
        self.addCleanup(subprocess.run, ["umount", disk], check=True)
        for name in self.NAMES:
            self.write(f"disk/{name}", "precious")
        process = run("mesh", STEP, "-q", "--set", "min_edge_length=0.1", "-o", f"{disk}/a.msh", "-o",
                      f"{disk}/a.node", "--report", f"{disk}/r.json", "--events", f"{disk}/e.jsonl")
        self.assertIn("make room", self.expect(CANNOT_WRITE, process).stderr)
        self.assertEqual(sorted(os.listdir(disk)), sorted(self.NAMES))
        for name in self.NAMES:
            self.assertEqual((self.folder / "disk" / name).read_text(encoding="utf-8"), "precious")

    def test_all_or_none_whenever_it_is_stopped(self):
        begun = time.monotonic()
        self.expect(OK, run(*self.command()))
        length = time.monotonic() - begun
        for k in range(40):
            for name in self.NAMES:
                self.write(name, "precious")
            process = subprocess.Popen([program.PROGRAM, *self.command()], stderr=subprocess.DEVNULL)
            time.sleep(1.2 * length * k / 40)
            process.terminate()
            process.wait(timeout=60)
            self.assertEqual(self.files(), sorted(self.NAMES))
            old = {(self.folder / name).read_text(encoding="utf-8") == "precious" for name in self.NAMES}
            self.assertEqual(len(old), 1, f"some are old and some are new after {k} of 40 parts of a run")

    def test_a_run_that_is_killed_leaves_the_old_and_the_next_one_clears_up(self):
        process = subprocess.Popen([program.PROGRAM, *self.command(self.long_domain())])
        while len(self.files()) < 2 * len(self.NAMES):
            self.assertIsNone(process.poll(), "the run is over")
            time.sleep(0.01)
        # What it is writing is not cleared by another program that writes the same files.
        self.expect(OK, run("mesh", STEP, "-q", "-o", self.path("a.msh")))
        self.assertEqual(len(self.files()), 2 * len(self.NAMES))
        self.write("a.msh", "precious")
        process.kill()
        process.wait(timeout=60)
        for name in self.NAMES:
            self.assertEqual((self.folder / name).read_text(encoding="utf-8"), "precious")
        self.expect(OK, run(*self.command()))
        self.assertEqual(self.files(), sorted(self.NAMES))


class Signals(program.ProgramTest):
    """Ctrl+C and TERM end the program wherever it is, and leave the files as they were."""

    def setUp(self):
        super().setUp()
        self.write("a.msh", "precious")
        os.mkfifo(self.path("pipe"))
        self.before = self.files()

    def begin(self, *arguments, **options):
        """The program, once it has begun: under the sanitizers it takes a while to be loaded."""
        process = subprocess.Popen([program.PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, **options)
        until = time.monotonic() + 20.0
        while not self.listens(process) and process.poll() is None and time.monotonic() < until:
            time.sleep(0.002)
        return process

    @staticmethod
    def listens(process):
        """Whether it catches TERM."""
        try:
            status = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="utf-8")
        except OSError:
            return False
        caught = next((line for line in status.splitlines() if line.startswith("SigCgt:")), "SigCgt: 0")
        return int(caught.split()[1], 16) >> (signal.SIGTERM - 1) & 1 == 1

    def end(self, process, number=signal.SIGINT, words="nothing was written"):
        self.assertIsNone(process.poll(), "the run ended before the signal was sent")
        process.send_signal(number)
        output, error = process.communicate(timeout=60)
        self.assertEqual(process.returncode, {signal.SIGINT: CANCELLED, signal.SIGTERM: TERMINATED}[number], error)
        self.assertEqual(output, "")
        self.assertIn("triscope: stopped by ", error)
        self.assertIn(words, error)
        self.assertEqual(self.files(), self.before)
        self.assertEqual((self.folder / "a.msh").read_text(encoding="utf-8"), "precious")

    def test_an_input_that_does_not_come(self):
        pipe = self.path("pipe")
        for arguments in (("mesh", pipe, "-o", self.path("a.msh")), ("figure", pipe, "-o", self.path("a.svg")),
                          ("debug", pipe), ("check", pipe + ".msh"), ("check", self.path("a.msh"), "--domain", pipe),
                          ("sweep", pipe, *RANGES, "-o", self.path("a.csv")), ("replay", pipe)):
            if arguments[1] == pipe + ".msh":
                os.mkfifo(arguments[1])
                self.before = self.files()
            if "--domain" in arguments:
                self.expect(OK, run("mesh", STEP, "-q", "-o", self.path("c.msh")))
                self.before = self.files()
                arguments = ("check", self.path("c.msh"), "--domain", pipe)
            for number in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(arguments):
                    process = self.begin(*arguments)
                    self.wait_until_it_waits(process)
                    self.end(process, number)

    def test_an_output_that_nobody_reads(self):
        for option in ("--report", "--events"):
            process = self.begin("mesh", STEP, "-q", "-o", self.path("a.msh"), option, self.path("pipe"))
            self.wait_until_it_waits(process)
            self.end(process)

    def test_an_output_that_is_not_read_on(self):
        process = self.begin("mesh", STEP, "-q", "-o", self.path("a.msh"), "--events", self.path("pipe"), "--set",
                             "min_edge_length=0.1")
        with open(self.path("pipe"), "rb") as reader:
            self.assertTrue(reader.read(1))
            self.wait_until_it_waits(process)
            self.end(process, words="no file was changed")

    def test_messages_that_nobody_reads(self):
        reader, writer = os.pipe()
        os.set_blocking(writer, False)
        try:
            while True:
                os.write(writer, b"x" * 4096)
        except BlockingIOError:
            os.set_blocking(writer, True)
        process = subprocess.Popen([program.PROGRAM, "mesh", self.path("pipe"), "-o", self.path("a.msh")], stderr=writer)
        self.wait_until_it_waits(process)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=60), CANCELLED)
        os.close(reader)
        os.close(writer)

    def test_a_reader_that_goes_away(self):
        process = self.begin("mesh", STEP, "-q", "-o", self.path("a.msh"), "--events", self.path("pipe"), "--set",
                             "min_edge_length=0.1")
        with open(self.path("pipe"), "rb") as reader:
            self.assertTrue(reader.read(1))
        _, error = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 128 + signal.SIGPIPE, error)
        self.assertEqual(error, "")
        self.assertEqual(self.files(), self.before)

    def test_at_any_moment_of_a_run(self):
        """The derivation of the smallest edge, the constraints, the quadtree, the steps: a domain of many holes."""
        def hole(i, j):
            ring = ((3, 0), (2, 2), (0, 3), (-2, 2), (-3, 0), (-2, -2), (0, -3), (2, -2))
            return [[10 * i + x, 10 * j + y] for x, y in ring]
        side = 70
        far = 10 * side - 5
        domain = {"outer": [[-5, -5], [far, -5], [far, far], [-5, far]],
                  "holes": [hole(i, j) for i in range(side) for j in range(side)]}
        folder = tempfile.TemporaryDirectory(prefix="triscope-test-")
        self.addCleanup(folder.cleanup)
        path = pathlib.Path(folder.name) / "holes.json"
        path.write_text(json.dumps(domain), encoding="utf-8")
        for wait in (0.1, 0.3, 0.6, 1.0, 1.5):
            for number in (signal.SIGINT, signal.SIGTERM):
                process = self.begin("mesh", path, "-o", self.path("a.msh"), "--events", self.path("e.jsonl"), "--set",
                                     "min_edge_length=0.02" if number == signal.SIGINT else "min_edge_length=0")
                time.sleep(wait)
                if wait > 0.5 and process.poll() is not None:  # a fast machine: the earlier moments were all of it
                    process.communicate()
                    return
                self.end(process, number)

    def test_each_subcommand(self):
        long = self.long_domain()
        for arguments in (("figure", long, "-o", self.path("a.svg")), ("debug", long),
                          ("sweep", STEP, "--omega", "0.05:0.25:1000", "--theta", "5:10:1000", *LONG_RUN),
                          ("sweep", STEP, "--omega", "0.05:0.25:1000", "--theta", "5:10:1000")):
            process = self.begin(*arguments)
            time.sleep(0.5)
            self.end(process)

    def test_a_run_in_the_background_is_stopped_too(self):
        """A shell lets programs that it starts in the background ignore Ctrl+C."""
        process = self.begin("mesh", self.path("pipe"), "-o", self.path("a.msh"),
                             preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
        self.wait_until_it_waits(process)
        self.end(process)

    def wait_until_it_waits(self, process):
        """For a file to open, or for room in a pipe; not for the linker that brings the program into memory."""
        for _ in range(3000):
            where = pathlib.Path(f"/proc/{process.pid}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()[0]
            caught = catches_control_c(process.pid)
            if where == "S" and caught:
                return
            self.assertIsNone(process.poll(), "the run ended by itself")
            time.sleep(0.01)
        self.fail("the program does not come to wait")


def catches_control_c(pid):
    """Whether the process has a handler for INT."""
    for line in pathlib.Path(f"/proc/{pid}/status").read_text(encoding="utf-8").splitlines():
        if line.startswith("SigCgt:"):
            return int(line.split()[1], 16) >> (signal.SIGINT - 1) & 1
    return 0


if __name__ == "__main__":
    program.main()
