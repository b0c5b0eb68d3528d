"""triscope check: a good mesh passes, a bad one does not, and the figures are those of the report."""

import json
import re

import program
from program import BAD_DATA, BLUNT_BODY, OK, STEP, UNMET, USAGE, run

MSH2 = """$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
{count}
{nodes}
$EndNodes
$Elements
{triangles}
{elements}
$EndElements
"""


def msh2(points, triangles):
    """A Gmsh 2.2 file of triangles only."""
    return MSH2.format(count=len(points), nodes="\n".join(f"{i + 1} {x} {y} 0" for i, (x, y) in enumerate(points)),
                       triangles=len(triangles),
                       elements="\n".join(f"{i + 1} 2 2 1 1 " + " ".join(str(v + 1) for v in t)
                                          for i, t in enumerate(triangles)))


class Check(program.ProgramTest):
    def test_own_mesh_is_good_in_every_format(self):
        for name, flags in (("a.msh", []), ("b.msh", ["--msh2"]), ("c.node", []), ("d.vtu", []),
                            ("e.su2", []), ("f.off", []), ("g.obj", [])):
            self.expect(OK, run("mesh", STEP, "-o", self.path(name), *flags))
            self.expect(OK, run("check", self.path(name)))
            self.expect(OK, run("check", self.path(name), "--domain", STEP))

    def test_figures_are_those_of_the_report(self):
        self.expect(OK, run("mesh", BLUNT_BODY, "-o", self.path("a.msh"), "--report", self.path("r.json")))
        report = json.loads((self.folder / "r.json").read_text())
        text = self.expect(OK, run("check", self.path("a.msh"))).stdout
        shown = dict(re.findall(r"^(\w+) +(\S+)", text, re.MULTILINE))
        for key in ("vertices", "triangles", "obtuse", "boundary_vertices"):
            self.assertEqual(int(shown[key]), report[key], key)
        for key in ("aspect_ratio_max", "area_ratio_max", "edge_ratio_max", "min_angle_deg", "max_angle_deg"):
            self.assertAlmostEqual(float(shown[key]), report[key], delta=1e-5 * report[key], msg=key)

    def test_bound_not_met(self):
        # A right triangle of sides 1 and 3: a minimum angle of 18 degrees, an edge ratio above 3.
        path = self.write("thin.msh", msh2([(0, 0), (3, 0), (0, 1)], [(0, 1, 2)]))
        text = self.expect(UNMET, run("check", path)).stdout
        self.assertRegex(text, r"min_angle_deg +18\.43\d* .*not met")

    def test_mesh_that_is_not_delaunay(self):
        # The diagonal of a kite-like quadrilateral taken the wrong way.
        path = self.write("wrong.msh", msh2([(0, 0), (1, -0.4), (2, 0), (1, 0.4)], [(0, 1, 2), (0, 2, 3)]))
        self.assertIn("inside the circumcircle", self.expect(UNMET, run("check", path)).stdout)

    def test_triangles_that_overlap(self):
        path = self.write("twice.off", "OFF\n6 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 0\n5 1 0\n1 5 0\n3 0 1 2\n3 3 4 5\n")
        text = self.expect(UNMET, run("check", path)).stdout
        self.assertRegex(text, r"valid +no\n +at \(\S+, \S+\): border edge 0-1|valid +no\n.*overlaps itself")
        self.assertRegex(text, r"area_ratio_max +1 ")

    def test_mesh_of_another_domain(self):
        self.expect(OK, run("mesh", STEP, "-o", self.path("a.msh")))
        self.expect(UNMET, run("check", self.path("a.msh"), "--domain", BLUNT_BODY))

    def test_file_that_is_no_mesh(self):
        self.write("a.ele", "1 3 0\n1 1 2 3\n")
        for name, text, code in (("a.msh", "nonsense", BAD_DATA), ("a.msh", "", BAD_DATA),
                                 ("a.node", "3 2 0 0\n1 0 0\n", BAD_DATA), ("a.xyz", "", USAGE)):
            error = self.expect(code, run("check", self.write(name, text))).stderr
            self.assertIn(name, error)


if __name__ == "__main__":
    program.main()
