"""The same bytes from gcc -O0, gcc -O2 and clang -O2, for every sample.

Builds the program three times without its window into TRISCOPE_BUILD_DIR/determinism; ccache makes that cheap the next time.
"""

import hashlib
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["TRISCOPE_SOURCE_DIR"])
BUILD = pathlib.Path(os.environ["TRISCOPE_BUILD_DIR"]) / "determinism"
SAMPLES = sorted(SOURCE.glob("assets/domains/*.json"))
VARIANTS = {"gcc-O0": ("g++", "-O0"), "gcc-O2": ("g++", "-O2"), "clang-O2": ("clang++-19", "-O2")}


def call(*command):
    process = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    if process.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}\n{process.stdout[-4000:]}\n{process.stderr[-4000:]}")


def build(name, compiler, optimisation):
    folder = BUILD / name
    call("cmake", "-G", "Ninja", "-S", SOURCE, "-B", folder, f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_BUILD_TYPE=None",
         f"-DCMAKE_CXX_FLAGS={optimisation}", "-DTRISCOPE_WINDOW=OFF", "-DTRISCOPE_TESTS=OFF")
    call("cmake", "--build", folder, "--target", "triscope", "-j", os.cpu_count())
    return folder / "triscope"


def digest(program, sample):
    with tempfile.TemporaryDirectory() as folder:
        mesh, events = pathlib.Path(folder) / "mesh.msh", pathlib.Path(folder) / "events.jsonl"
        call(program, "mesh", sample, "-q", "-o", mesh, "--events", events)
        return hashlib.sha256(mesh.read_bytes() + events.read_bytes()).hexdigest()


class Determinism(unittest.TestCase):
    def test_same_bytes_from_every_compiler(self):
        missing = [compiler for compiler, _ in VARIANTS.values() if shutil.which(compiler) is None]
        if missing:
            self.skipTest(f"not installed: {', '.join(missing)}")
        programs = {name: build(name, *variant) for name, variant in VARIANTS.items()}
        for sample in SAMPLES:
            with self.subTest(sample=sample.stem):
                digests = {name: digest(program, sample) for name, program in programs.items()}
                self.assertEqual(len(set(digests.values())), 1, digests)


if __name__ == "__main__":
    unittest.main()
