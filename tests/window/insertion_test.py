"""Stepping through one insertion with F11 and Shift+F11."""

import re
import unittest

import harness
from keys_test import chord


class Insertions(harness.WindowTest):
    def keys(self, action):
        return [chord(k) for k in self.window.state()["keys"][action]]

    def go_to(self, stage):
        """To where a stage begins."""
        while self.window.settled()["stage"] != stage:
            before = self.window.state()["tick"], self.window.state()["stage"]
            self.window.key("Prior")
            self.window.wait(lambda s: (s["tick"], s["stage"]) != before and s["activity"] == "idle", "a stage back")
        return self.window.settled()

    def press(self, key, phase):
        self.window.key(key)
        self.window.wait(lambda s: s["insertion"]["phase"] == phase and s["activity"] == "idle", f"phase {phase}")
        return self.window.settled()

    def look(self):
        left, top, width, height = self.window.canvas()
        return self.window.image().colors(left, top, width, height)

    def test_the_phases(self):
        start = self.go_to("step1")
        into = self.keys("into")[0]
        states, looks = [], []
        for phase in (1, 2, 3, 4):
            states.append(self.press(into, phase))
            looks.append(self.look())
        first = states[0]["insertion"]
        self.assertGreaterEqual(states[0]["tick"], start["tick"])
        # The first three show the state before the decision, the last one that after it.
        self.assertEqual([s["tick"] - states[0]["tick"] for s in states], [0, 0, 0, 1])
        self.assertEqual({s["insertion"]["vertex"] for s in states}, {first["vertex"]})
        self.assertEqual(len({str(sorted(look.items())) for look in looks}), 4, "each phase looks different")
        # What each says, with the figures of the run.
        candidate = re.fullmatch(r"Triangle (\d+) is the candidate\. Its circumcircle has R = ([\d.e-]+); the limit is "
                                 r"the edge length h .* = ([\d.e-]+) \(dashed\)\.", states[0]["caption"])
        self.assertTrue(candidate, states[0]["caption"])
        self.assertGreaterEqual(float(candidate[2]), 0.999 * float(candidate[3]))
        self.assertRegex(states[1]["caption"], rf"[Tt]riangle {candidate[1]}\b")
        cavity = re.match(r"The cavity: (\d+) triangles? .* (\d+) rim edges stay", states[2]["caption"])
        self.assertTrue(cavity, states[2]["caption"])
        gone, rim = int(cavity[1]), int(cavity[2])
        self.assertEqual(rim, gone + 2)
        self.assertEqual(gone, first["cavity"])
        self.assertIn(f"Vertex {first['vertex']} is joined", states[3]["caption"])
        grown = states[3]["figures"]["triangles"] - states[2]["figures"]["triangles"]
        self.assertEqual(grown, rim - gone)
        # In view, and large enough to see.
        left, top, width, height = self.window.canvas()
        x, y = self.window.pixel(first["x"], first["y"])
        self.assertTrue(left < x < left + width and top < y < top + height)
        # All panels tell of the stage that the insertion is of, whatever came before it.
        for state in states:
            self.assertEqual(state["insertion"]["stage"], "step1")
            self.assertEqual(state["widgets"]["current_stage"], state["widgets"]["stage.step1"])
        # The indicator has its place.
        box = states[3]["widgets"]["phases"]
        caption = states[3]["widgets"]["caption"]
        self.assertLessEqual(box[1] + box[3], caption[1] + 1)
        # On to the next, and back through all of them.
        second = self.press(into, 1)
        self.assertGreaterEqual(second["tick"], states[3]["tick"])
        self.assertNotEqual(second["insertion"]["vertex"], first["vertex"])
        back = self.keys("into_back")
        for phase, key in ((4, back[0]), (3, back[-1]), (2, back[0]), (1, back[0])):
            state = self.press(key, phase)
            self.assertEqual(state["insertion"]["vertex"], first["vertex"])
            self.assertEqual(state["tick"], states[phase - 1]["tick"])
            self.assertEqual(state["caption"], states[phase - 1]["caption"])
        # Before the first of this stage there are those of the fronts.
        state = self.press(back[0], 4)
        self.assertLess(state["insertion"]["vertex"], first["vertex"])
        self.assertLessEqual(state["tick"], states[0]["tick"])

    def circles(self, state):
        """Across the circles of what was measured, in pixels."""
        return 2 * state["insertion"]["reach"] * state["camera"]["scale"]

    def test_the_camera_goes_near_and_back(self):
        self.window.key("minus", "minus", "minus", "minus", "minus", "minus")
        self.go_to("step2")
        before = self.window.settled()["camera"]
        into = self.keys("into")[0]
        first = self.press(into, 1)
        self.assertLess(2 * first["insertion"]["reach"] * before["scale"], 120, "too small from where it was")
        smaller = min(before["width"], before["height"])
        self.assertGreater(self.circles(first), smaller / 3)
        self.assertLess(self.circles(first), smaller / 2)
        self.assertEqual((first["camera"]["x"], first["camera"]["y"]),
                         (first["insertion"]["x"], first["insertion"]["y"]))
        # It stays through the phases, follows to the next insertion, and comes back when they are left.
        for phase in (2, 3, 4):
            self.assertEqual(self.press(into, phase)["camera"], first["camera"])
        second = self.press(into, 1)
        self.assertGreater(self.circles(second), 120)
        self.window.key("Escape")
        self.window.wait(lambda s: s["insertion"]["phase"] == 0 and s["camera"] == before, "the camera to come back")
        # Leaving by a step does the same.
        self.press(into, 1)
        self.window.key("Right")
        self.window.wait(lambda s: s["insertion"]["phase"] == 0 and s["camera"] == before, "the camera to come back")
        # One that was moved by hand is left alone.
        self.press(into, 1)
        self.window.key("minus")
        moved = self.window.settled()["camera"]
        self.window.key("Escape")
        self.window.wait(lambda s: s["insertion"]["phase"] == 0, "the phases to end")
        self.assertEqual(self.window.settled()["camera"], moved)

    def test_the_whole_domain_is_fitted_again(self):
        self.window.key("Home")
        self.go_to("step2")
        before = self.window.settled()["camera"]
        into = self.keys("into")[0]
        state = self.press(into, 1)
        self.assertNotEqual(state["camera"], before)
        self.window.key("ctrl+plus")  # another layout while it is near
        self.assertNotEqual(self.window.settled()["camera"]["width"], before["width"])
        self.window.key("Escape", "ctrl+0")
        self.window.wait(lambda s: s["insertion"]["phase"] == 0 and s["camera"] == before, "the whole domain")

    def test_leaving(self):
        self.go_to("step1")
        into = self.keys("into")[0]
        self.press(into, 1)
        self.press(into, 2)
        for key in ("Right", "Escape"):
            tick = self.window.settled()["tick"]
            self.window.key(key)
            state = self.window.wait(lambda s: s["insertion"]["phase"] == 0, "the phases to end")
            if key == "Escape":
                self.assertEqual(state["tick"], tick)
            self.press(into, 1)
        # Any other place in the run, and another mesh.
        self.window.key("End")
        self.window.wait(lambda s: s["insertion"]["phase"] == 0 and s["stage"] == "finished", "the end")
        self.assertFalse(self.window.enabled("menu.into") if "menu.into" in self.window.state()["widgets"] else False)
        self.window.key(into)
        self.window.wait(lambda s: "finished" in s["message"], "nothing to step into")

    def test_boundary_points_and_fronts(self):
        """Every stage that inserts can be stepped through, from its first point on."""
        self.go_to("front1")
        into = self.keys("into")[0]
        state = self.press(into, 1)
        self.assertRegex(state["caption"], r"A point off vertex \d+ is to go in at .* No other vertex may be nearer")
        self.assertRegex(self.press(into, 2)["caption"], r"triangle \d+|Triangle \d+")
        self.go_to("triangulation")
        self.window.key(into)
        self.window.wait(lambda s: "cannot be taken apart" in s["message"], "the first point of all")
        self.press(into, 1)
        state = self.press(into, 2)
        self.assertGreaterEqual(state["insertion"]["walk"], 1)


if __name__ == "__main__":
    unittest.main()
