"""triscope figure: a picture of every stage, without a display."""

import struct
import xml.etree.ElementTree

import program
from program import BLUNT_BODY, CANNOT_WRITE, OK, STEP, USAGE, run
from mesh_test import STAGES


class Figure(program.ProgramTest):
    def test_every_stage_is_well_formed_and_different(self):
        pictures = set()
        for stage in STAGES:
            self.expect(OK, run("figure", STEP, "-o", self.path("a.svg"), "--stage", stage))
            root = xml.etree.ElementTree.parse(self.path("a.svg")).getroot()
            self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
            pictures.add((self.folder / "a.svg").read_bytes())
        self.assertGreaterEqual(len(pictures), len(STAGES) - 1)

    def test_png_has_the_size_asked_for(self):
        self.expect(OK, run("figure", BLUNT_BODY, "-o", self.path("a.png"), "--width", "320", "--height", "200"))
        data = (self.folder / "a.png").read_bytes()
        self.assertEqual(struct.unpack(">II", data[16:24]), (320, 200))

    def test_needs_no_display(self):
        self.expect(OK, run("figure", STEP, "-o", self.path("a.png"), env={"DISPLAY": "", "WAYLAND_DISPLAY": ""}))

    def test_dark_differs(self):
        self.expect(OK, run("figure", STEP, "-o", self.path("a.svg")))
        self.expect(OK, run("figure", STEP, "-o", self.path("b.svg"), "--dark"))
        self.assertNotEqual((self.folder / "a.svg").read_bytes(), (self.folder / "b.svg").read_bytes())

    def test_cells_by_type_or_rank(self):
        legend = {"rank": "density rank", "type": "adjacent"}
        for stage in ("density", "refine"):
            pictures = {}
            for cells, words in legend.items():
                self.expect(OK, run("figure", STEP, "-o", self.path("a.svg"), "--stage", stage, "--cells", cells))
                pictures[cells] = (self.folder / "a.svg").read_text()
                self.assertIn(words, pictures[cells])
            self.assertNotIn(legend["type"], pictures["rank"])

    def test_a_part_of_the_plane(self):
        for name, box in (("a.svg", "-1,-1,2,2"), ("b.svg", "2,2,-1,-1"), ("c.svg", "4,0,9,2")):
            self.expect(OK, run("figure", STEP, "-o", self.path(name), "--box", box))
        self.expect(OK, run("figure", STEP, "-o", self.path("d.svg")))
        text = {name: (self.folder / name).read_bytes() for name in self.files()}
        self.assertEqual(text["a.svg"], text["b.svg"])
        self.assertEqual(len(set(text.values())), 3)

    def test_a_part_that_cannot_be_drawn(self):
        for box, words in (("1,2,3", "--box=-1,-1,2,1"), ("1,2,3,x", "opposite corners"), ("1,2,1,4", "opposite corners"),
                           ("0,0,inf,1", "opposite corners"), ("90,90,99,99", "outside the domain")):
            error = self.expect(USAGE, run("figure", STEP, "-o", self.path("a.svg"), "--box", box)).stderr
            self.assertIn(words, error)
        self.expect(USAGE, run("figure", STEP, "-o", self.path("a.svg"), "--cells", "colour"))
        self.assertEqual(self.files(), [])

    def test_cannot_write(self):
        self.expect(CANNOT_WRITE, run("figure", STEP, "-o", self.path("no such folder/a.svg")))
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    program.main()
