"""Runs the program the way a shell would, for the tests of the command line."""

import os
import pathlib
import resource
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["TRISCOPE_PROGRAM"]
SOURCE = pathlib.Path(os.environ["TRISCOPE_SOURCE_DIR"])
DOMAINS = SOURCE / "assets" / "domains"
STEP = str(DOMAINS / "step.json")
BLUNT_BODY = str(DOMAINS / "blunt_body.json")

OK, UNMET, USAGE, BAD_DATA, NO_INPUT, NO_MEMORY, CANNOT_WRITE, CANCELLED, TERMINATED = 0, 1, 2, 65, 66, 71, 73, 130, 143

# Takes the program seconds to mesh: there is time to press Ctrl+C.
LONG_RUN = ["--set", "min_edge_length=0.00002"]


def run(*arguments, env=None, timeout=120, cwd=None):
    """Runs the program without a terminal; returns the finished process with text in stdout and stderr."""
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=timeout,
                          stdin=subprocess.DEVNULL, env={**os.environ, **(env or {})}, cwd=cwd, check=False)


def run_within(megabytes, *arguments):
    """Like run(), with so much room for the program and what it allocates."""
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120,
                          stdin=subprocess.DEVNULL, preexec_fn=limit, check=False)


class ProgramTest(unittest.TestCase):
    """A test with a folder of its own, which must hold only what the test says it does."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="triscope-test-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path(self, name):
        return str(self.folder / name)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return self.path(name)

    def long_domain(self):
        """A domain file, in a folder apart, that takes the program seconds to mesh on any machine."""
        folder = tempfile.TemporaryDirectory(prefix="triscope-test-")
        self.addCleanup(folder.cleanup)
        path = pathlib.Path(folder.name) / "long.json"
        path.write_text('{"outer": [[0, 0], [1, 0], [1, 1], [0, 1]], "min_edge_length": 0.001, '
                        '"density": [{"box": [[0, 0], [1, 1]], "length": 0.001}]}', encoding="utf-8")
        return str(path)

    def files(self):
        return sorted(entry.name for entry in self.folder.iterdir())

    def expect(self, code, process):
        """The exit code is `code`; a failure said why in one clear line on stderr and nothing on stdout."""
        self.assertEqual(process.returncode, code, f"{process.args}\n{process.stdout}\n{process.stderr}")
        if code not in (OK, UNMET):
            self.assertEqual(process.stdout, "")
            self.assertTrue(process.stderr.startswith("triscope: "), process.stderr)
        return process


def main():
    unittest.main(verbosity=1)
