"""What is selected, held, pinned or open goes with every moment of the run: its start, where nothing is there yet, the
ends of its stages, and the time while another domain is being opened."""

import os
import unittest

import harness
import monkey_test
from keys_test import chord

# Meshed in a few seconds: long enough to do something meanwhile.
SLOW = {"name": "slow", "outer": [[0, 0], [60, 0], [60, 60], [0, 60]], "min_edge_length": 0.1,
        "density": [{"box": [[1, 1], [59, 59]], "length": 0.12}]}


class AnyMoment(harness.WindowTest):
    def setUp(self):
        super().setUp()
        self.open("asking.json", monkey_test.ASKING)
        self.before = self.window.wait(lambda s: s["domain"] == "asking" and s["activity"] == "idle", "the domain")

    def keys(self, action):
        return chord(self.window.state()["keys"][action][0])

    def requests(self, count):
        return self.window.wait(lambda s: len(s["density"]["requests"]) == count, f"{count} density constraints")

    def place(self, x, y):
        count = len(self.window.state()["density"]["requests"])
        self.window.press(*self.window.pixel(x, y), modifier="alt")
        self.requests(count + 1)
        return self.window.settled()

    def through_the_run(self):
        self.window.key(self.keys("restart"))
        self.window.wait(lambda s: s["tick"] == 0, "the start")
        for _ in range(40):
            state = self.window.settled()
            if state["stage"] == "finished":
                return
            self.window.key(self.keys("stage"))
            self.window.wait(lambda s: s["tick"] != state["tick"] or s["stage"] != state["stage"], "the next stage")
        self.fail("the run has no end")

    def test_a_constraint_just_placed_is_inspected_at_the_start_of_the_run(self):
        placed = self.place(5, 1)
        self.assertEqual(placed["density"]["selected"], 3)
        self.window.key("ctrl+Home")
        state = self.window.wait(lambda s: s["tick"] == 0, "the start")
        self.assertEqual(state["density"]["selected"], 3)
        self.through_the_run()

    def test_every_kind_of_selection_goes_with_the_run(self):
        x, y = self.window.pixel(3.9, 3.1)
        for kind, modifier, at in (("cell", "ctrl", (x, y)), ("triangle", None, (x, y)), ("vertex", None, (x, y))):
            self.window.key("ctrl+End")
            self.window.wait(lambda s: s["stage"] == "finished" and s["activity"] == "idle", "the end")
            if kind == "vertex":
                at = self.window.pixel(0, 0)
            self.window.press(*at, modifier=modifier)
            self.window.wait(lambda s: s["selection"]["kind"] in (kind, "edge"), f"a {kind}")
            for tab in ("tab.Why", "tab.History", "tab.Inspect"):
                self.window.click(tab)
                self.window.key("ctrl+Home")
                state = self.window.wait(lambda s: s["tick"] == 0, "the start")
                self.assertTrue(state["selection"]["gone"])
            self.through_the_run()
            self.assertFalse(self.window.settled()["selection"]["gone"])

    def test_a_constraint_deleted_or_let_go_of_while_it_is_held(self):
        for presses in (["Delete"], ["Escape", "Escape", "Escape"]):
            count = len(self.window.state()["density"]["requests"])
            self.place(5, 1)
            x, y = self.window.pixel(5, 1)
            self.window.hold(x, y)
            self.window.move(x + 12, y + 5)
            self.window.move(x + 20, y + 9)
            for key in presses:  # not with --clearmodifiers, which lets go of buttons too
                before = self.window.state()["keys_pressed"]
                self.window.xdotool("key", key)
                self.window.wait(lambda s: s["keys_pressed"] > before, f"'{key}' to be heard")
            self.window.move(x + 30, y + 15)
            self.window.move(x + 40, y + 20)
            self.window.release()
            self.requests(count if presses == ["Delete"] else count + 1)
            self.window.settled()

    def test_another_domain_is_opened_while_a_constraint_is_selected(self):
        self.place(5, 1)
        self.open("slow.json", SLOW)
        state = self.window.wait(lambda s: s["stale"], "it to be meshed", ends=True)
        self.assertEqual(state["density"]["selected"], -1)
        self.window.wait(lambda s: s["domain"] == "slow" and s["activity"] == "idle", "the domain", timeout=120)

    def test_what_cannot_be_done_is_offered_nowhere(self):
        """An action has one answer to whether it can be done: its key's, its menu's and that of every button."""
        x, y = self.window.pixel(3.9, 3.1)
        self.window.press(x, y)
        self.window.wait(lambda s: s["selection"]["kind"] in ("triangle", "edge"), "a triangle")
        self.window.click("pin_run")
        self.window.wait(lambda s: s["compare"]["pinned"] and not s["compare"]["busy"], "A")
        self.window.click("tab.Why")
        offered = ("pin_run", "compare.unpin", "why.break")
        state = self.window.wait(lambda s: all(name in s["widgets"] for name in offered), "the buttons")
        self.assertEqual([state["widgets"][name][4] for name in offered], [True] * 3)
        self.open("slow.json", SLOW)
        state = self.window.wait(lambda s: all(name in s["widgets"] for name in offered)
                                 and not s["widgets"]["pin_run"][4], "the button above the picture to be disabled")
        self.assertEqual([state["widgets"][name][4] for name in offered], [False] * 3)
        self.window.press(x, y, button=3)
        offered = ("context.why", "context.break")
        state = self.window.wait(lambda s: all(name in s["widgets"] for name in offered), "the menu")
        self.assertTrue(state["stale"], "the mesh was made too soon")
        self.assertEqual([state["widgets"][name][4] for name in offered], [False] * 2)

    def test_what_is_changed_while_another_domain_is_opened_belongs_to_that_one(self):
        path = os.path.join(self.window.folder.name, "asking.session")
        self.window.key("ctrl+s")
        self.window.widget("save.path")
        self.window.key("ctrl+a")
        self.window.type(path)
        self.window.key("Return")
        self.window.wait(lambda s: s["document"]["path"] == path, "the session to be saved")
        self.window.click("tab.Params")
        self.open("slow.json", SLOW)
        self.window.wait(lambda s: s["document"]["opening"], "it to be opened")
        self.window.press(*self.window.pixel(5, 1), modifier="alt")  # no place of the domain to come
        x, y, width, height = self.window.widget_box("param.omega")
        self.window.drag(x + 0.3 * width, y + height / 2, x + 0.6 * width, y + height / 2)
        state = self.window.wait(lambda s: s["domain"] == "slow" and s["activity"] == "idle", "the domain", timeout=120)
        # The session saved before is not this domain's, and nothing of it can be taken back.
        self.assertEqual(state["document"]["path"], "")
        self.assertEqual(state["undo"], 0)
        self.assertEqual(len(state["density"]["requests"]), len(SLOW["density"]))
        self.assertNotEqual(state["settings"]["omega"], self.before["settings"]["omega"])


if __name__ == "__main__":
    unittest.main()
