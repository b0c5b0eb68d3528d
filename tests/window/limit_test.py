"""A run that would make more triangles than max_triangles asks first, and says beforehand what it estimates."""

import resource
import unittest

import harness
from keys_test import chord

SMALL = {"name": "small", "outer": [[0, 0], [8, 0], [8, 8], [0, 8]], "min_edge_length": 0.5,
         "density": [{"box": [[0, 0], [8, 8]], "length": 0.5}]}
LARGE = dict(SMALL, name="large", min_edge_length=0.007, density=[{"box": [[0, 0], [8, 8]], "length": 0.007}])


class Limit(harness.WindowTest):
    def asked(self):
        return self.window.wait(lambda s: s["dialog"] == "limit", "the question", timeout=120)

    def most(self, value):
        """Types the limit in Params."""
        window = self.window
        window.click("tab.Params")
        x, y, width, height = window.canvas()
        window.move(x - 60, y + height / 2)  # over Params
        for _ in range(40):
            if window.widget("param.max_triangles")[1] < y + height / 2:
                break
            window.xdotool("click", "5")
        window.press(*window.widget("param.max_triangles"), modifier="ctrl")
        window.key("ctrl+a")
        window.type(str(value))
        window.key("Return")

    def test_one_that_memory_does_not_suffice_for_is_given_up(self):
        window = self.window
        before = window.settled()
        with open(f"/proc/{window.process.pid}/statm", encoding="utf-8") as file:
            taken = int(file.read().split()[0]) * resource.getpagesize()
        if taken > 1 << 40:
            self.skipTest("under a sanitizer the program takes all memory beforehand")
        resource.prlimit(window.process.pid, resource.RLIMIT_AS, (taken + (60 << 20), resource.RLIM_INFINITY))
        self.open("large.json", LARGE)
        state = window.wait(lambda s: s["dialog"] == "error" and s["activity"] == "idle", "the error", timeout=120)
        self.assertIn("not enough memory", state["error"])
        self.assertEqual((state["hash"], state["settings"]), (before["hash"], before["settings"]))
        # It is seen without a key or a move of the mouse.
        self.assertGreater(window.widget_box("dialog.close")[0], 300)
        window.click("dialog.close")
        # What it took is there for the run from before.
        for action, end in (("restart", 0), ("to_end", before["tick"])):
            window.key(chord(window.state()["keys"][action][0]))
            state = window.wait(lambda s: s["tick"] == end and s["activity"] == "idle", action)
            self.assertEqual(state["dialog"], "none")
        self.assertEqual(state["hash"], before["hash"])

    def test_stopped_where_it_is_it_does_not_ask_again(self):
        window = self.window
        self.open("small.json", SMALL)
        whole = window.wait(lambda s: s["domain"] == "small" and s["activity"] == "idle", "the domain")
        self.most(whole["figures"]["triangles"] // 4)
        state = self.asked()
        self.assertTrue(state["failed"])
        self.assertEqual(state["figures"]["triangles"], 0)
        window.click("limit.stop")
        window.wait(lambda s: s["dialog"] == "none", "the question to close")
        for action in ("restart", "to_end"):
            window.key(chord(window.state()["keys"][action][0]))
            state = window.wait(lambda s: s["failed"] == (action == "to_end") and s["activity"] == "idle", action)
            self.assertEqual(state["dialog"], "none")

    def test_what_is_suggested_for_a_run_stopped_early_is_meshed_to_the_end(self):
        # It is given up in the quadtree, long before Table 1 is known; a limit that is soon reached all the same.
        window = self.window
        self.most(60000)
        self.open("early.json", dict(SMALL, name="early", min_edge_length=1e-4,
                                     density=[{"box": [[0, 0], [8, 8]], "rank": 1}]))
        state = self.asked()
        self.assertEqual((state["stage"], state["failed"]), ("quadtree", True))
        window.click("limit.coarser")
        state = window.wait(lambda s: s["dialog"] == "none" and s["activity"] == "idle" and not s["failed"], "a mesh",
                            timeout=120)
        self.assertEqual(state["stage"], "finished")
        self.assertGreater(state["figures"]["triangles"], 1000)

    def test_the_limit_is_raised_lowered_and_kept(self):
        window = self.window
        self.open("small.json", SMALL)
        whole = window.wait(lambda s: s["domain"] == "small" and s["activity"] == "idle", "the domain")
        triangles = whole["figures"]["triangles"]
        self.most(triangles // 4)
        self.asked()
        # Esc stops there; undo gives the mesh back.
        window.key("Escape")
        state = window.wait(lambda s: s["dialog"] == "none", "the question to close")
        self.assertTrue(state["failed"])
        window.key("ctrl+z")
        window.wait(lambda s: s["hash"] == whole["hash"], "the mesh")
        # A larger edge length, as suggested, is within the limit.
        self.most(triangles // 4)
        self.asked()
        window.click("limit.coarser")
        state = window.wait(lambda s: s["dialog"] == "none" and s["activity"] == "idle" and not s["failed"], "a mesh")
        self.assertGreater(state["settings"]["min_edge_length"], whole["min_edge"])
        self.assertLess(state["figures"]["triangles"], triangles)
        window.key("ctrl+z")
        self.asked()
        # Anyway: the same mesh as without a limit.
        window.click("limit.anyway")
        state = window.wait(lambda s: s["dialog"] == "none" and s["activity"] == "idle" and not s["failed"], "a mesh")
        self.assertEqual(state["figures"], whole["figures"])
        self.assertGreater(state["settings"]["max_triangles"], triangles // 4)

    def test_the_estimate_stands_in_the_status_bar_before_there_is_a_mesh(self):
        window = self.window
        self.open("small.json", SMALL)
        window.wait(lambda s: s["domain"] == "small" and s["activity"] == "idle", "the domain")
        window.click("tab.Stages")
        window.click("stage.boundary")
        window.wait(lambda s: s["stage"] == "boundary" and "estimate" in s["widgets"], "the estimate")


if __name__ == "__main__":
    unittest.main()
