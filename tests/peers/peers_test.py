"""Other programs open what we write, and we read what they write: Gmsh and meshio, each skipped where it is absent."""

import importlib.util
import json
import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))

import program  # noqa: E402  (found through the path above)
from program import DOMAINS, OK, run  # noqa: E402

GMSH = shutil.which("gmsh")
MESHIO = importlib.util.find_spec("meshio") is not None
AIRFOIL = str(DOMAINS / "naca0012.json")


class Peers(program.ProgramTest):
    def mesh(self, name, *flags):
        """Meshes the airfoil into a file; returns the path and the report."""
        report = self.path("report.json")
        self.expect(OK, run("mesh", AIRFOIL, "-o", self.path(name), "--report", report, "--until", "rounds", *flags))
        return self.path(name), json.loads(pathlib.Path(report).read_text())

    def figures(self, path):
        """What `triscope check` says of a mesh that another program wrote."""
        process = run("check", path)
        self.assertEqual(process.returncode, OK, process.stderr)
        return process.stdout


@unittest.skipUnless(GMSH, "gmsh is not installed")
class Gmsh(Peers):
    def gmsh(self, *arguments):
        process = subprocess.run([GMSH, *arguments], capture_output=True, text=True, timeout=120, check=False)
        output = process.stdout + process.stderr
        self.assertEqual(process.returncode, 0, output)
        self.assertNotIn("Warning", output)
        self.assertNotIn("Error", output)
        return output

    def test_finds_nothing_wrong_with_either_version(self):
        for flags in ([], ["--msh2"]):
            path, report = self.mesh("a.msh", *flags)
            output = self.gmsh(path, "-0", "-check")
            self.assertIn(f"{report['vertices']} nodes", output)
            self.assertIn("Done checking mesh coherence", output)

    def test_converts_it(self):
        path, report = self.mesh("a.msh")
        self.gmsh(path, "-0", "-save", "-format", "vtk", "-o", self.path("a.vtk"))
        self.assertIn(f"POINTS {report['vertices']} double", pathlib.Path(self.path("a.vtk")).read_text())

    def test_keeps_groups_and_figures_when_it_writes_the_mesh_anew(self):
        path, report = self.mesh("a.msh")
        for version in ("msh41", "msh22"):
            again = self.path(f"{version}.msh")
            self.gmsh(path, "-0", "-save", "-format", version, "-o", again)
            for name in ('"far field"', '"airfoil"', '"domain"'):
                self.assertIn(name, pathlib.Path(again).read_text())
            self.assertIn(str(report["triangles"]), self.figures(again))


@unittest.skipUnless(MESHIO, "meshio is not installed for this Python")
class Meshio(Peers):
    def read(self, path):
        import meshio

        return meshio.read(path)

    def count(self, mesh, kind):
        return sum(len(block.data) for block in mesh.cells if block.type == kind)

    def test_reads_vtu_with_its_cell_data(self):
        path, report = self.mesh("a.vtu")
        mesh = self.read(path)
        self.assertEqual(len(mesh.points), report["vertices"])
        self.assertEqual(self.count(mesh, "triangle"), report["triangles"])
        self.assertEqual(max(mesh.cell_data["aspect"][0]), report["aspect_ratio_max"])
        self.assertEqual(max(mesh.cell_data["max_angle"][0]), report["max_angle_deg"])
        self.assertEqual(len(set(mesh.cell_data["id"][0])), report["triangles"])

    def test_reads_both_versions_of_msh(self):
        for flags in ([], ["--msh2"]):
            path, report = self.mesh("a.msh", *flags)
            mesh = self.read(path)
            self.assertEqual(len(mesh.points), report["vertices"])
            self.assertEqual(self.count(mesh, "triangle"), report["triangles"])
            self.assertEqual(self.count(mesh, "line"), report["boundary_vertices"])
            self.assertEqual(set(mesh.field_data), {"far field", "airfoil", "domain"})

    def test_reads_su2_off_and_obj(self):
        for name in ("a.su2", "a.off", "a.obj"):
            path, report = self.mesh(name)
            mesh = self.read(path)
            self.assertEqual(len(mesh.points), report["vertices"], name)
            self.assertEqual(self.count(mesh, "triangle"), report["triangles"], name)

    def test_what_it_writes_in_ascii_is_read(self):
        import meshio

        path, report = self.mesh("a.vtu")
        mesh = self.read(path)
        meshio.write(self.path("b.vtu"), mesh, binary=False)
        meshio.write(self.path("b.msh"), mesh, file_format="gmsh", binary=False)
        meshio.write(self.path("c.msh"), mesh, file_format="gmsh22", binary=False)
        for name in ("b.vtu", "b.msh", "c.msh"):
            self.assertIn(str(report["triangles"]), self.figures(self.path(name)), name)


if __name__ == "__main__":
    program.main()
