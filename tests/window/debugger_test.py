"""The debugger: timeline, why, history, breakpoints and plots, with real keys and mouse."""

import json
import os
import subprocess
import unittest

import harness
from keys_test import chord

BLUNT_BODY = f"{harness.SOURCE}/assets/domains/blunt_body.json"


class Debugger(harness.WindowTest):
    def keys(self, action):
        return [chord(k) for k in self.window.state()["keys"][action]]

    def measured(self):
        """Settled, with the measures along the whole run."""
        self.window.settled()
        return self.window.wait(lambda s: s["debug"]["measured"] == s["debug"]["ticks"] > 0, "the measures")

    def strip(self, name="timeline"):
        return self.window.wait(lambda s: name in s["widgets"], name)["widgets"][name][:4]

    def add(self, condition):
        """Types a condition into the panel, which is open, and presses Enter."""
        count = len(self.window.state()["debug"]["breakpoints"])
        self.window.click("break.condition")
        self.window.type(condition)
        self.window.key("Return")
        return self.window.wait(lambda s: len(s["debug"]["breakpoints"]) == count + 1, f"the breakpoint '{condition}'")

    def test_scrubbing(self):
        end = self.measured()["tick"]
        x, y, width, height = self.strip()
        for part in (0.25, 0.8, 0.5):
            self.window.press(x + part * width, y + height / 2)
            state = self.window.wait(lambda s: abs(s["tick"] - part * end) < 0.01 * end, "the place clicked")
            self.assertEqual(state["debug"]["ticks"], end)
        self.window.drag(x + 0.5 * width, y + height / 2, x + 0.1 * width, y + height / 2)
        self.window.wait(lambda s: abs(s["tick"] - 0.1 * end) < 0.01 * end, "the place dragged to")
        self.window.drag(x + 0.1 * width, y + height / 2, x + width + 30, y + height / 2)
        self.window.wait(lambda s: s["tick"] == end and s["activity"] == "idle", "the end")

    def test_zooming_the_timeline(self):
        end = self.measured()["tick"]
        x, y, width, height = self.strip()
        self.window.move(x + 0.5 * width, y + height / 2)
        for _ in range(4):
            self.window.xdotool("click", "4")
        shown = self.window.wait(lambda s: 0 < s["debug"]["to"] - s["debug"]["from"] < 0.5 * end, "the zoom")["debug"]
        self.assertTrue(shown["from"] < 0.5 * end < shown["to"])
        self.window.press(x + 0.25 * width, y + height / 2)
        aim = shown["from"] + 0.25 * (shown["to"] - shown["from"])
        self.window.wait(lambda s: abs(s["tick"] - aim) < 0.01 * end, "the place clicked")
        for _ in range(8):
            self.window.xdotool("click", "5")
        self.window.wait(lambda s: s["debug"]["to"] <= s["debug"]["from"], "the whole run")

    def test_why_and_history(self):
        self.window.key("2")
        worst = self.window.wait(lambda s: s["selection"]["kind"] == "triangle", "the worst triangle")["selection"]["id"]
        self.window.click("tab.Why")
        state = self.window.wait(lambda s: s["debug"]["why"], "an answer")
        self.assertTrue(state["debug"]["why_not"])
        link = next(name for name in state["widgets"] if name.startswith("why.vertex "))
        self.window.click("why.birth")
        born = self.window.wait(lambda s: s["tick"] < state["tick"] and s["activity"] == "idle", "its birth")
        self.assertFalse(born["selection"]["gone"])
        self.assertEqual(born["selection"]["id"], worst)
        self.window.key("Left")
        self.window.wait(lambda s: s["selection"]["gone"], "a step back over its birth")
        self.window.key("Right")
        self.window.wait(lambda s: not s["selection"]["gone"], "its birth again")
        if link in self.window.state()["widgets"]:
            self.window.click(link)
            self.window.wait(lambda s: s["selection"]["kind"] == "vertex", "the vertex of the link")
        self.window.click("tab.History")
        self.window.wait(lambda s: s["debug"]["tab"] == "History" and s["debug"]["history"], "the history")
        before = self.window.settled()["tick"]
        if self.window.enabled("history.next"):
            self.window.click("history.next")
            after = self.window.wait(lambda s: s["tick"] > before and s["activity"] == "idle", "the next event")["tick"]
            self.window.click("history.previous")
            self.window.wait(lambda s: s["tick"] < after and s["activity"] == "idle", "the one before")
        for key in self.keys("why"):
            self.window.key(key)
            self.window.wait(lambda s: s["debug"]["tab"] == "Why", "'why'")

    def test_breakpoints(self):
        end = self.measured()["tick"]
        for key in self.keys("breakpoints_panel"):
            self.window.key(key)
            self.window.wait(lambda s: s["debug"]["bottom"] == "Breakpoints", "'breakpoints_panel'")
        self.window.type("aspect >> 4")
        self.window.key("Return")
        state = self.window.wait(
            lambda s: "character 9" in s["debug"]["complaint"] and "break.caret" in s["widgets"], "the complaint")
        self.assertEqual(state["debug"]["breakpoints"], [])
        self.window.key("ctrl+a", "BackSpace")
        self.window.wait(lambda s: s["debug"]["condition"] == "", "nothing typed")
        state = self.add("stage == step1 and inserted")
        self.assertEqual(state["debug"]["condition"], "")
        self.window.key("ctrl+Home")
        self.window.wait(lambda s: s["tick"] == 0, "the start")
        places = []
        for key in self.keys("continue_forward") * 3:
            before = self.window.settled()["tick"]
            self.window.key(key)
            state = self.window.wait(lambda s: s["tick"] > before and s["activity"] == "idle", "'continue_forward'")
            self.assertEqual(state["stage"], "step1")
            self.assertRegex(state["caption"], "^Step 1 put vertex")
            places.append(state["tick"])
        self.assertEqual(state["debug"]["hits"], places)
        for key in self.keys("continue_back") * 2:
            self.window.key(key)
            places.pop()
            self.window.wait(lambda s: s["tick"] == places[-1] and s["activity"] == "idle", "'continue_back'")
        for key in self.keys("next_mark"):
            self.window.key(key)
            there = self.window.wait(lambda s: s["tick"] > places[-1], "'next_mark'")["tick"]
            for back in self.keys("previous_mark"):
                self.window.key(back)
                self.window.wait(lambda s: s["tick"] == places[-1] < there, "'previous_mark'")
        # Off, it is passed by; a click on a hit goes there; deleted, it and its hits are gone.
        self.window.click("break.0.enabled")
        self.window.wait(lambda s: not s["debug"]["breakpoints"][0]["enabled"], "the breakpoint to be off")
        self.window.key("F5")
        self.window.wait(lambda s: s["tick"] == end and s["activity"] == "idle", "the end")
        self.assertFalse(self.window.enabled("continue_back"))
        self.window.click("break.hit.0")
        self.window.wait(lambda s: s["tick"] == places[0], "the hit")
        self.window.click("break.0.delete")
        self.window.wait(lambda s: s["debug"]["breakpoints"] == [] and s["debug"]["hits"] == [], "nothing left")

    def test_breaking_on_an_element(self):
        self.window.key("2")
        selected = self.window.wait(lambda s: s["selection"]["kind"] == "triangle", "the worst triangle")["selection"]
        for key in self.keys("breakpoint"):
            self.window.key(key)
            state = self.window.wait(lambda s: len(s["debug"]["breakpoints"]) == 1, "'breakpoint'")
            self.assertEqual(state["debug"]["breakpoints"][0]["condition"], f"triangle == {selected['id']}")
            self.window.key("shift+F5")
            self.window.wait(lambda s: s["message"].startswith("Stopped at decision"), "the last event about it")
            self.window.key(key)
            self.window.wait(lambda s: s["debug"]["breakpoints"] == [], "'breakpoint' again")

    def test_first_violation(self):
        for key in self.keys("first_violation"):
            self.window.key(key)
            self.window.wait(lambda s: "No rule is broken" in s["message"], "'first_violation'")

    def test_a_search_tells_how_far_it_is_and_can_be_given_up(self):
        path = os.path.join(self.window.folder.name, "large.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"outer": [[0, 0], [40, 0], [40, 40], [0, 40]], "min_edge_length": 0.1,
                       "density": [{"box": [[0, 0], [40, 40]], "length": 0.1}]}, file)
        window = harness.Window(self.display, path)
        self.addCleanup(window.close)
        window.settled()
        window.key("Prior")
        there = window.settled()
        for give_up in (lambda: window.key("Escape"), lambda: window.click("cancel")):
            window.key("shift+F9")
            window.wait(lambda s: s["activity"] == "searching" and "cancel" in s["widgets"], "how far it is")
            give_up()
            state = window.wait(lambda s: s["activity"] == "idle", "the search to end")
            self.assertEqual(state["message"], "The search was stopped.")
            self.assertEqual((state["tick"], state["hash"]), (there["tick"], there["hash"]))
        window.key("shift+F9")
        window.wait(lambda s: "No rule is broken" in s["message"], "a search that is not given up")

    def test_bookmarks(self):
        tick = self.measured()["tick"]
        for key in self.keys("bookmark"):
            self.window.key(key)
            self.window.wait(lambda s: s["debug"]["bookmarks"] == [tick], "'bookmark'")
            self.window.key("Prior")
            self.window.wait(lambda s: s["tick"] < tick, "going back")
            self.window.key("j")
            self.window.wait(lambda s: s["tick"] == tick, "the bookmark")
            self.window.key(key)
            self.window.wait(lambda s: s["debug"]["bookmarks"] == [], "'bookmark' again")

    def test_plots(self):
        end = self.measured()["tick"]
        for key in self.keys("plots_panel"):
            self.window.key(key)
            self.window.wait(lambda s: s["debug"]["bottom"] == "Plots", "'plots_panel'")
        x, y, width, height = self.strip("plots.run")
        self.window.press(x + 0.3 * width, y + height / 2)
        self.window.wait(lambda s: abs(s["tick"] - 0.3 * end) < 0.01 * end, "the place clicked")
        left, top, wide, high = self.window.canvas()
        before = self.window.image().colors(left, top, wide, high)
        x, y, width, height = self.strip("plots.bars")
        self.window.press(x + 3, y + height - 3)
        self.window.wait(lambda s: s["debug"]["brush"], "the bar to mark its triangles")
        self.window.drawn(lambda image: image.colors(left, top, wide, high) != before, "the change to be drawn")
        self.window.click("plots.unmark")
        self.window.wait(lambda s: not s["debug"]["brush"], "the marks to go")
        for end in ("Escape", "ctrl+p"):
            self.window.press(x + 3, y + height - 3)
            self.window.wait(lambda s: s["debug"]["brush"], "the bar to mark its triangles")
            self.window.key(end)
            self.window.wait(lambda s: not s["debug"]["brush"], f"{end} to take the marks away")

    def test_a_drag_over_bars_marks_a_range(self):
        window = self.window
        triangles = self.measured()["figures"]["triangles"]
        window.key(self.keys("plots_panel")[0])
        x, y, width, height = self.strip("plots.bars")
        low = y + height - 3

        def marked(what, condition):
            window.wait(lambda s: s["debug"]["brush"] and condition(s["debug"]), what)
            return window.settled()["debug"]  # what is marked is counted a frame later

        # Bars are found by what a click on each marks.
        bars = []
        for part in (0.02, 0.06, 0.1):
            window.press(x + part * width, low)
            bars.append(marked(f"a bar at {part}", lambda d: not bars or d["brush_low"] > bars[-1]["brush_low"]))
        self.assertGreater(min(bar["brushed"] for bar in bars), 0)
        for start, end in ((0.02, 0.1), (0.1, 0.02)):
            window.drag(x + start * width, low, x + end * width, low)
            range_of = marked("the range", lambda d: (d["brush_low"], d["brush_high"]) == (bars[0]["brush_low"],
                                                                                           bars[2]["brush_high"]))
            self.assertGreaterEqual(range_of["brushed"], max(bar["brushed"] for bar in bars))
            self.assertLess(range_of["brushed"], triangles)
            # A click into the range takes it away.
            window.press(x + 0.06 * width, low)
            window.wait(lambda s: not s["debug"]["brush"], "the marks to go")
        # From end to end, and beyond: every triangle of the mesh.
        window.drag(x + 2, low, x + width + 30, low)
        marked("the whole mesh", lambda d: d["brushed"] == triangles)
        left, top, _, _ = window.canvas()
        window.press(left + 5, top + 5)
        window.wait(lambda s: not s["debug"]["brush"], "a click beside the mesh to take the marks away")

    def test_what_is_hovered_says_of_which_decision_it_is(self):
        """Between two samples: the mesh of the decision itself where the window stands, else the sample's decision."""
        end = self.measured()["tick"]
        self.window.key("ctrl+p")
        x, y, width, height = self.strip("plots.run")
        for part in (0.31, 0.33, 0.35):
            self.window.press(x + part * width, y + height / 2)
            state = self.window.wait(lambda s: abs(s["tick"] - part * end) < 0.01 * end, "the place clicked")
            worst = f"{state['figures']['aspect_ratio_max']:.3f}".rstrip("0")
            tip = f"Decision {state['tick']}: worst aspect ratio {worst}\n"
            self.window.wait(lambda s: s["tooltip"].startswith(tip), tip)
        self.window.key("Left")
        state = self.window.wait(lambda s: s["tick"] == state["tick"] - 1, "a step back")
        place = x + round(0.34 * width)
        self.window.move(place, y + height / 2)
        state = self.window.wait(lambda s: s["tooltip"].startswith("Decision ") and s["tooltip"] != state["tooltip"],
                                 "what is told of the place")
        if "after decision" not in state["tooltip"]:  # a sample's own decision; that of the next pixel is not
            self.window.move(place + 1, y + height / 2)
        self.window.wait(lambda s: "after decision" in s["tooltip"], "the decision of the sample")

    def test_a_stage_is_named_up_to_its_last_decision(self):
        end = self.measured()["tick"]
        x, y, width, height = self.strip()
        self.window.key("Prior")
        state = self.window.wait(lambda s: s["tick"] < end and s["activity"] == "idle", "the last stage's start")
        self.window.move(x + width * state["tick"] / end, y + height / 2)
        self.window.xdotool("click", "--repeat", "24", "--delay", "10", "4")
        self.window.wait(lambda s: 0 < s["debug"]["to"] - s["debug"]["from"] < 0.2 * width, "the zoom")
        shown = self.window.settled()["debug"]
        for tick in range(state["tick"] - 1, state["tick"] + 2):
            part = (tick - shown["from"]) / (shown["to"] - shown["from"])
            self.window.press(x + part * width, y + height / 2)
            there = self.window.wait(lambda s: s["tick"] == tick and s["activity"] == "idle", f"decision {tick}")
            name = {"refine": "step 6"}.get(there["stage"], there["stage"].replace("step", "step "))
            self.window.wait(lambda s: s["tooltip"].startswith(f"Decision {tick}, {name}"), (tick, name))

    def test_where_a_breakpoint_stops_is_in_view(self):
        """Near the worst triangle, a run that stops elsewhere brings the place along, and keeps the scale."""
        self.window.key("2")
        near = self.window.wait(lambda s: s["selection"]["kind"] == "triangle" and s["camera"]["scale"] > 20,
                                "the worst triangle")["camera"]
        self.window.key("ctrl+b")
        self.add("stage == step1 and inserted")
        self.window.key("shift+F5")
        self.window.wait(lambda s: s["stage"] == "step1" and s["activity"] == "idle", "the last insertion of step 1")
        state = self.window.wait(lambda s: (s["camera"]["x"], s["camera"]["y"]) != (near["x"], near["y"]), "the place")
        self.assertEqual(state["camera"]["scale"], near["scale"])
        last = state["events"] - 1
        told = subprocess.run([harness.PROGRAM, "debug", BLUNT_BODY, "-q", "--goto", f"tick={state['tick']}", "--print",
                               f"events:{last}-{last}", "--json"], check=True, capture_output=True, text=True)
        x, y = json.loads(told.stdout)["answers"][0]["events"][0]["at"]
        self.assertAlmostEqual(state["camera"]["x"], x, 4)
        self.assertAlmostEqual(state["camera"]["y"], y, 4)

    def test_a_key_that_follows_the_end_of_typing_is_heard(self):
        """Escape leaves the field, and the next key, however soon, is a command again."""
        for _ in range(3):
            self.window.key("ctrl+b")
            self.window.wait(lambda s: s["debug"]["bottom"] == "Breakpoints", "the field of conditions")
            self.window.xdotool("key", "--delay", "0", "Escape", "shift+h")
            self.window.wait(lambda s: s["debug"]["bottom"] == "Sweep", "the sweep's panel")

    def test_everything_has_its_place(self):
        """At 100 % and 200 %, with each panel open: on the screen, and nothing over anything else."""
        for scale in (1.0, 2.0):
            while self.window.settled()["scale"] != scale:
                self.window.key("ctrl+equal")
            for panel, own in (("", []), ("Plots", ["plots.series", "plots.run", "plots.spread", "plots.bars"]),
                               ("Breakpoints", ["break.condition", "break.action", "break.words"]),
                               ("Sweep", ["sweep.omega.from", "sweep.omega.to", "sweep.omega.count", "sweep.theta.from",
                                          "sweep.theta.to", "sweep.theta.count", "run_sweep", "save_sweep", "sweep.map"])):
                if panel == "Sweep" and scale == 1.0:
                    self.window.key("Escape", "shift+h")  # the field of conditions has the keyboard
                elif panel:
                    self.window.key({"Plots": "ctrl+p", "Breakpoints": "ctrl+b", "Sweep": "ctrl+h"}[panel])
                state = self.window.wait(lambda s: s["debug"]["bottom"] == panel, panel)
                names = ["canvas", "timeline", "timeline.count", "tab.Plots", "tab.Breakpoints", "tab.Compare", "tab.Sweep"] + own
                names += ["caption"] if scale == 1.0 or not panel else []
                state = self.window.wait(lambda s: all(n in s["widgets"] for n in names), names)
                for i, name in enumerate(names):
                    x, y, width, height, _ = state["widgets"][name]
                    self.assertTrue(x >= 0 and y >= 0 and x + width <= 1280 and y + height <= 800, (scale, panel, name))
                    for other in names[i + 1:]:
                        a, b = state["widgets"][name], state["widgets"][other]
                        apart = (a[0] + a[2] <= b[0] or b[0] + b[2] <= a[0] or a[1] + a[3] <= b[1] + 1
                                 or b[1] + b[3] <= a[1] + 1)
                        self.assertTrue(apart, (scale, panel, name, other))
            self.window.key("ctrl+h")
            self.window.wait(lambda s: s["debug"]["bottom"] == "", "the panel to close")


if __name__ == "__main__":
    unittest.main()
