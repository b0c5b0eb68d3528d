"""The programs of examples/ do what they say, and give the program's own mesh."""

import os
import pathlib
import subprocess

import program
from program import OK, STEP, run

EXAMPLES = pathlib.Path(os.environ["TRISCOPE_BUILD_DIR"]) / "examples"


class MeshDomain(program.ProgramTest):
    def example(self, *arguments):
        return subprocess.run([EXAMPLES / "mesh_domain", *arguments], capture_output=True, text=True, timeout=60,
                              check=False)

    def test_the_mesh_is_the_programs(self):
        process = self.example(STEP, self.path("example.vtu"))
        self.assertEqual((process.returncode, process.stderr), (OK, ""))
        self.assertIn("step 3\n", process.stdout)
        self.expect(OK, run("mesh", STEP, "--set", "omega=0.1", "-o", self.path("program.vtu"), "-q"))
        self.assertEqual((self.folder / "example.vtu").read_bytes(), (self.folder / "program.vtu").read_bytes())
        self.assertRegex(process.stdout, r"\n\d+ triangles, \d+ vertices, angles from [\d.]+ to [\d.]+ degrees, worst "
                                         r"aspect ratio [\d.]+\n$")

    def test_what_is_wrong_is_said(self):
        self.assertEqual(self.example().returncode, 1)
        process = self.example(self.path("missing.json"), self.path("x.vtu"))
        self.assertEqual(process.returncode, 1)
        self.assertIn("missing.json", process.stderr)


if __name__ == "__main__":
    program.main()
