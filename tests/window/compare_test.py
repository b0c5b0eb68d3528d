"""Two runs side by side, with real keys and mouse."""

import time
import unittest

import harness
from keys_test import chord


class Compare(harness.WindowTest):
    def keys(self, action):
        return [chord(k) for k in self.window.state()["keys"][action]]

    def together(self):
        """The state once both runs rest."""
        return self.window.wait(lambda s: s["activity"] == "idle" and not s["stale"] and s["compare"]["pinned"]
                                and not s["compare"]["busy"] and self.window.settled(), "both runs to rest")

    def pin(self):
        self.window.key("a")
        return self.together()

    def set(self, key, value):
        """Types a parameter, as Ctrl+click allows."""
        self.window.click("tab.Params")
        self.window.press(*self.window.widget("param." + key), modifier="ctrl")
        self.window.xdotool("key", "ctrl+a")
        self.window.type(str(value))
        self.window.key("Return")
        time.sleep(0.3)  # until the field is left, keys are text
        self.window.wait(lambda s: s["settings"][key] == value and not s["stale"] and s["activity"] == "idle", key)

    def test_omega_005_with_025(self):
        """What the guide promises: docs/debugging.md."""
        window = self.window
        self.set("omega", 0.05)
        one = self.pin()
        self.assertEqual(one["compare"]["hash"], one["hash"])
        self.assertEqual((one["compare"]["first"], one["compare"]["differing"]), (-1, []))
        self.set("omega", 0.25)
        state = window.wait(lambda s: s["compare"].get("first", -1) >= 0 and s["stage"] == "finished", "a difference")
        self.assertEqual(state["compare"]["differing"], ["omega"])
        self.assertEqual((state["compare"]["settings"]["omega"], state["settings"]["omega"]), (0.05, 0.25))
        self.assertEqual(state["compare"]["hash"], one["hash"], "A stays")
        self.assertNotEqual(state["hash"], one["hash"])
        self.assertEqual(state["debug"]["bottom"], "Compare")
        for name in ("compare.settings", "compare.figures", "canvas", "canvas.A"):
            self.assertIn(name, state["widgets"])
        window.click("first_difference")
        state = window.wait(lambda s: s["stage"] == "refine" and s["compare"]["tick"] == s["tick"], "both to be there")
        self.assertEqual(state["events"], state["compare"]["first"] + 1)
        self.assertNotEqual(state["hash"], state["compare"]["hash"])
        window.key("Left")
        state = window.wait(lambda s: s["tick"] < state["tick"] and s["compare"]["tick"] == s["tick"], "one step back")
        self.assertEqual(state["figures"], state["compare"]["figures"])
        window.key(self.keys("restart")[0])
        window.wait(lambda s: s["tick"] == 0 and "compare.figures" not in s["widgets"], "no figures of empty meshes")
        window.click("compare.unpin")
        state = window.wait(lambda s: not s["compare"]["pinned"] and "canvas.A" not in s["widgets"], "one run again")
        self.assertEqual(state["debug"]["bottom"], "")

    def test_keys_and_buttons(self):
        window = self.window
        for key in self.keys("pin_run"):
            window.key(key)
            self.together()
            window.key(key)
            window.wait(lambda s: not s["compare"]["pinned"], "'pin_run' again")
        for key in self.keys("compare_panel"):
            window.key(key)
            window.wait(lambda s: s["debug"]["bottom"] == "Compare", "'compare_panel'")
            self.assertTrue(window.enabled("pin_run"))
            window.key(self.keys("first_difference")[0])
            window.wait(lambda s: s["message"].startswith("No run is pinned"), "the reason")
            window.key(key)
            window.wait(lambda s: s["debug"]["bottom"] == "", "'compare_panel' again")
        window.click("pin_run")
        self.together()
        self.assertFalse(window.enabled("first_difference"), "the runs are the same")
        self.set("theta", 20)
        window.wait(lambda s: s["compare"]["first"] >= 0, "a difference")
        for key in self.keys("first_difference"):
            window.key("End")
            window.wait(lambda s: s["stage"] == "finished" and s["compare"]["stage"] == "finished", "the ends")
            window.key(key)
            window.wait(lambda s: s["events"] == s["compare"]["first"] + 1 == s["compare"]["events"], "'first_difference'")
        window.click("pin_run")
        window.wait(lambda s: not s["compare"]["pinned"], "the button again")

    def test_stages_are_linked(self):
        window = self.window
        self.pin()
        self.set("omega", 0.25)
        window.key("ctrl+d")  # room for the list of stages
        for stage in ("step1", "boundary", "front2", "refine"):
            window.click("tab.Stages")
            window.click("stage." + stage)
            state = window.wait(lambda s: s["stage"] == s["compare"]["stage"] == stage, stage)
            self.assertEqual(state["compare"]["tick"], state["tick"])
        x, y, width, height = window.widget_box("timeline")
        window.press(x + 0.8 * width, y + height / 2)
        state = window.wait(lambda s: s["tick"] > state["tick"] and s["compare"]["tick"] > state["tick"], "beyond step 6")
        self.together()
        state = window.settled()
        start = state["compare"]["ticks"] - state["debug"]["ticks"]
        self.assertEqual(state["compare"]["stage"], "optimise")
        self.assertNotEqual(start, 0, "the runs differ in length")
        window.key("End")
        state = window.wait(lambda s: s["stage"] == s["compare"]["stage"] == "finished", "both ends")
        self.assertEqual(state["compare"]["tick"], state["compare"]["ticks"])

    def test_headings_leave_the_mesh_free(self):
        self.pin()
        self.window.settled()
        top = self.window.pixel(-30, 30)[1] - self.window.canvas()[1]  # of the domain, in the picture
        self.assertGreater(top, 8 + 17 + 15 + 8)

    def test_one_camera(self):
        window = self.window
        self.pin()
        a, b = window.widget_box("canvas.A"), window.widget_box("canvas")
        self.assertEqual((a[1], a[2], a[3]), (b[1], b[2], b[3]))
        self.assertLess(a[0] + a[2], b[0] + 1)
        before = window.settled()["camera"]
        window.drag(a[0] + 0.5 * a[2], a[1] + 0.7 * a[3], a[0] + 0.5 * a[2] + 40, a[1] + 0.7 * a[3])
        window.wait(lambda s: abs((before["x"] - s["camera"]["x"]) * s["camera"]["scale"] - 38) < 4, "A to pan both")
        same = window.image()
        # The same run in the same place: the same pixels, away from names, labels and the place of the mouse.
        part = (0.1, 0.75, 0.3, 0.2)
        colors = [same.colors(p[0] + part[0] * p[2], p[1] + part[1] * p[3], part[2] * p[2], part[3] * p[3])
                  for p in (a, b)]
        self.assertEqual(*colors)
        self.assertGreater(len(colors[0]), 10)
        window.press(b[0] + 0.5 * b[2], b[1] + 0.8 * b[3])
        chosen = window.wait(lambda s: s["selection"]["kind"] != "none", "a pick in B")["selection"]
        window.key("Escape")
        window.wait(lambda s: s["selection"]["kind"] == "none", "nothing")
        window.press(a[0] + 0.5 * a[2], a[1] + 0.8 * a[3])
        window.wait(lambda s: s["selection"] == chosen, "the same place in A to pick the same")

    def test_another_domain_lets_a_go(self):
        self.pin()
        path = f"{harness.SOURCE}/assets/domains/square.json"
        self.window.open_by_dialog(path)
        self.window.wait(lambda s: not s["compare"]["pinned"] and s["domain"] == "square", "A to go")


if __name__ == "__main__":
    unittest.main()
