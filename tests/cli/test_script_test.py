"""Which tests `./test` selects. The script runs in a folder of its own where nothing is installed or built, over tests
that do nothing; ctest is the real one."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["TRISCOPE_SOURCE_DIR"])
TESTS = {"Cavity.Fills": "quick", "Cavity.Splits": "quick", "golden": "quick;golden", "window.keys": "full;window",
         "window.monkey_long": "long"}


class TestScript(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        shutil.copy(SOURCE / "test", self.root / "test")
        for stub in (self.root / "cmake" / "install-packages", self.root / "bin" / "cmake"):
            stub.parent.mkdir()
            stub.write_text("#!/bin/sh\n", encoding="utf-8")
            stub.chmod(0o755)
        build = self.root / "build" / "release"
        build.mkdir(parents=True)
        (build / "CTestTestfile.cmake").write_text("".join(
            f'add_test("{name}" true)\nset_tests_properties("{name}" PROPERTIES LABELS "{labels}")\n'
            for name, labels in TESTS.items()), encoding="utf-8")

    def script(self, *arguments):
        environment = dict(os.environ, PATH=f"{self.root / 'bin'}:{os.environ['PATH']}")
        environment.pop("TRISCOPE_PRESET", None)
        return subprocess.run([self.root / "test", *arguments], env=environment, capture_output=True, text=True,
                              timeout=60, check=False)

    def expect_run(self, arguments, names):
        process = self.script(*arguments)
        self.assertEqual(process.returncode, 0, process.stdout + process.stderr)
        self.assertEqual({name for name in TESTS if f": {name} ." in process.stdout}, set(names), process.stdout)
        self.assertTrue(process.stdout.endswith(f"{len(names)} passed, 0 failed\n"), process.stdout)

    def test_a_tier(self):
        self.expect_run([], set(TESTS) - {"window.monkey_long"})
        self.expect_run(["--quick"], ["Cavity.Fills", "Cavity.Splits", "golden"])
        self.expect_run(["--long"], ["window.monkey_long"])
        self.expect_run(["--approve"], ["golden"])

    def test_a_filter(self):
        self.expect_run(["Cavity"], ["Cavity.Fills", "Cavity.Splits"])
        self.expect_run(["^(golden|window.k)"], ["golden", "window.keys"])
        self.expect_run(["--quick", "s$"], ["Cavity.Fills", "Cavity.Splits"])
        self.expect_run(["--long", "monkey"], ["window.monkey_long"])

    def test_a_filter_that_matches_nothing(self):
        for arguments, said in ((["Cavty"], 'There is no test but the long ones whose name matches "Cavty".'),
                                (["monkey_long"], "no test but the long ones"),
                                (["--quick", "window"], 'no test of --quick whose name matches "window"')):
            process = self.script(*arguments)
            self.assertEqual(process.returncode, 2, process.stdout + process.stderr)
            self.assertIn(said, process.stderr)

    def test_usage(self):
        for arguments in (["--slow"], ["Cavity", "--quick"], ["Cavity", "golden"], [""], ["--quick", "--long"]):
            process = self.script(*arguments)
            self.assertEqual(process.returncode, 2, process.stdout + process.stderr)
            self.assertIn("usage: ./test [--quick | --long | --approve] [FILTER]", process.stderr)


if __name__ == "__main__":
    unittest.main()
