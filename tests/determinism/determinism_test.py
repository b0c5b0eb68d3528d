"""The same decisions and the same bytes from gcc -O0, clang -O2 and the build under test, for every sample.

Builds tests/determinism/digest.cpp twice more into TRISCOPE_BUILD_DIR/determinism; ccache makes that cheap the next time.
"""

import os
import pathlib
import shutil
import subprocess
import unittest

SOURCE = pathlib.Path(os.environ["TRISCOPE_SOURCE_DIR"])
BUILD = pathlib.Path(os.environ["TRISCOPE_BUILD_DIR"])
SAMPLES = sorted(SOURCE.glob("assets/domains/*.json"))
VARIANTS = {"gcc-O0": ("g++", "-O0"), "clang-O2": ("clang++-19", "-O2")}


def call(*command):
    process = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    if process.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}\n{process.stdout[-4000:]}\n{process.stderr[-4000:]}")
    return process.stdout


def build(name, compiler, optimisation):
    folder = BUILD / "determinism" / name
    call("cmake", "-G", "Ninja", "-S", SOURCE, "-B", folder, f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_BUILD_TYPE=None",
         f"-DCMAKE_CXX_FLAGS={optimisation}", "-DTRISCOPE_WINDOW=OFF", "-DTRISCOPE_FAST_BUILD=ON")
    call("cmake", "--build", folder, "--target", "triscope_digest", "-j", os.cpu_count())
    return folder / "tests" / "triscope_digest"


class Determinism(unittest.TestCase):
    def test_every_build_decides_the_same(self):
        missing = [compiler for compiler, _ in VARIANTS.values() if shutil.which(compiler) is None]
        if missing:
            self.skipTest(f"not installed: {', '.join(missing)}")
        self.assertTrue(SAMPLES, "there are no samples")
        expected = call(BUILD / "tests" / "triscope_digest", *SAMPLES).splitlines()
        self.assertGreater(len(expected), 10 * len(SAMPLES))
        for name, variant in VARIANTS.items():
            found = call(build(name, *variant), *SAMPLES).splitlines()
            for ours, theirs in zip(expected, found):
                self.assertEqual(ours, theirs, f"{name}: the first stage that differs")
            self.assertEqual(len(expected), len(found), name)


if __name__ == "__main__":
    unittest.main()
