"""Themes, scales, parameters and the circles: what is on the screen follows what the state says."""

import os
import re
import tempfile
import time
import unittest

import harness
import xresources


class Look(harness.WindowTest):
    def test_themes_change_what_is_seen(self):
        seen = set()
        for _ in range(3):
            state = self.window.settled()
            left, top, _, _ = self.window.canvas()
            image = self.window.image()
            self.assertEqual(image.at(left + 4, top + 4), tuple(state["colors"]["background"]), state["theme"])
            x, y, width, height = state["widgets"]["caption"][:4]
            colors = image.colors(x, y, width, height)
            self.assertEqual(max(colors, key=colors.get), tuple(state["colors"]["surface"]), state["theme"])
            seen.add(state["theme"])
            self.window.key("ctrl+t")
            self.window.wait(lambda s: s["theme"] != state["theme"], "another theme")
        self.assertEqual(seen, {"light", "dark", "high contrast"})

    def test_what_is_drawn_in_places_looks_as_if_drawn_as_a_whole(self):
        self.window.key("w")  # the circles of the worst triangles would cover much of the mesh
        for keys in (["Left"] * 9 + ["Right"] * 4, ["shift+Left"] * 5 + ["Left"] * 3, ["2", "Left", "Left", "Right"]):
            self.window.key(*keys)
            theme = self.window.settled()["theme"]
            left, top, width, height = self.window.canvas()
            mended = self.window.image()
            for _ in range(3):  # another theme has the whole of it drawn anew
                before = self.window.settled()["theme"]
                self.window.key("ctrl+t")
                self.window.wait(lambda s, t=before: s["theme"] != t, "another theme")
            self.assertEqual(self.window.settled()["theme"], theme)
            anew = self.window.image()
            for row in range(int(top), int(top + height)):
                start, end = (3 * (row * anew.width + int(x)) for x in (left, left + width))
                self.assertEqual(mended.data[start:end], anew.data[start:end], f"row {row} after {keys}")

    def test_scales_keep_everything_on_the_screen(self):
        small = self.window.settled()["widgets"]["open"][3]
        for scale in (0.75, 1.5, 2.0, 3.0):
            while self.window.settled()["scale"] != scale:
                self.window.key("ctrl+equal" if self.window.state()["scale"] < scale else "ctrl+minus")
            # The letters of another size are there a frame later.
            self.window.wait(lambda s: abs(s["widgets"]["open"][3] / small - scale) < 0.1, f"the size at {scale}")
            state = self.window.settled()
            fixed = ["open", "play_pause", "to_end", "canvas", "tab.Stages"]
            # Where the window is low beside its letters, one row of buttons and one column of tabs must do.
            fixed += ["speed", "fit", "save_picture"] if scale <= 2 else []
            fixed += ["tab.Inspect"] if scale <= 1.5 else []
            fixed += ["timeline", "timeline.count"]
            fixed += ["tab.Plots", "tab.Breakpoints", "tab.Compare"] if scale <= 2 else ["timeline.panels", "toolbar.more"]
            for name in fixed:
                x, y, width, height, _ = state["widgets"][name]
                self.assertTrue(x >= 0 and y >= 0 and x + width <= 1280 and y + height <= 800, (scale, name))
            for i, first in enumerate(fixed):
                for second in fixed[i + 1:]:
                    a, b = state["widgets"][first], state["widgets"][second]
                    apart = (a[0] + a[2] <= b[0] or b[0] + b[2] <= a[0] or a[1] + a[3] <= b[1] or b[1] + b[3] <= a[1])
                    self.assertTrue(apart, (scale, first, second))

    def test_worst_circles_are_where_the_state_says(self):
        self.window.key("2")
        state = self.window.wait(lambda s: s["selection"]["kind"] == "triangle", "the worst triangle")
        left, top, width, height = self.window.canvas()
        with_circles = self.window.image().colors(left, top, width, height)
        self.window.key("w", "l")
        self.window.settled()
        without = self.window.image().colors(left, top, width, height)
        changed = sum(abs(with_circles.get(c, 0) - without.get(c, 0)) for c in set(with_circles) | set(without))
        self.assertGreater(changed, 200)
        self.assertTrue(state["figures"]["within_bounds"])

    def test_a_hidden_quadtree_says_so(self):
        window = self.window
        window.key("c", "q")
        window.wait(lambda s: s["layers"]["quadtree"] and "hidden by the coloured triangles" in s["message"], "the hint")
        window.key("q", "t", "q")
        window.wait(lambda s: s["layers"]["quadtree"] and not s["message"], "no hint where it is seen")

    def test_a_step_is_drawn(self):
        self.window.click("stage.step1")
        self.window.wait(lambda s: s["stage"] == "step1", "step 1")
        left, top, width, height = self.window.canvas()
        for _ in range(3):
            before = self.window.image().colors(left, top, width, height)
            caption = self.window.state()["caption"]
            self.window.key("F10")
            state = self.window.wait(lambda s: s["caption"] != caption, "another caption")
            self.assertRegex(state["caption"], r"^Step 1 put vertex \d+ at the circumcentre of triangle \d+: .* R = ")
            self.window.drawn(lambda image: image.colors(left, top, width, height) != before, "the step to be drawn")


class Stages(harness.WindowTest):
    def test_layers_and_captions_follow_the_stage(self):
        window = self.window
        window.key("ctrl+Home")
        window.wait(lambda s: s["tick"] == 0 and s["activity"] == "idle", "the start")
        seen = []
        for caption in (r"Constraints are done: \d+ found, Δx = 1\.", r"Quadtree is done: \d+ leaf cells\.",
                        r"Density is done: \d+ leaf cells, ranks 1–\d+, \d+ triangles estimated, [\d.]+ \w+ of memory\.",
                        r"Boundary points are done: [1-9]\d* placed between those of the input\."):
            window.key("ctrl+Right")
            seen.append(window.wait(lambda s: re.fullmatch(caption, s["caption"]), caption)["layers"])
        self.assertEqual([layers["quadtree"] for layers in seen], [True, True, True, False])
        self.assertEqual([layers["constraints"] for layers in seen], [True, True, True, False])
        # A switch by hand holds in every stage, until the layers are to follow again.
        window.key("q")
        window.key("End")
        state = window.wait(lambda s: s["stage"] == "finished", "the end")
        self.assertTrue(state["layers"]["quadtree"])
        window.click("tab.Layers")
        window.click("layers follow")
        window.wait(lambda s: not s["layers"]["quadtree"], "the layers to follow again")

    def test_the_whole_list_is_in_sight(self):
        state = self.window.settled()
        rows = [box for name, box in state["widgets"].items() if name.startswith("stage.")]
        self.assertEqual(len(rows), 19)
        for x, y, width, height, _ in rows:
            self.assertGreater(y, state["widgets"]["tab.Stages"][1] + 15)
            self.assertLess(y + height, state["widgets"]["timeline"][1])
        self.assertEqual(len({box[1] for box in rows}), 19)


class Room(harness.WindowTest):
    def test_what_has_no_room_is_in_a_menu(self):
        window = self.window
        for _ in range(8):
            window.key("ctrl+equal")
        window.wait(lambda s: s["scale"] == 3, "the scale")
        window.settled()
        window.click("toolbar.more")
        for name in ("speed", "pin_run", "fit", "worst_aspect", "save_picture"):
            x, y, width, height = window.widget_box(name)
            self.assertTrue(x >= 0 and y >= 0 and x + width <= 1280 and y + height <= 800, name)
        window.click("worst_aspect")
        window.wait(lambda s: s["selection"]["kind"] == "triangle", "the worst triangle")
        self.assertNotIn("worst_aspect", window.settled()["widgets"])
        window.click("timeline.panels")
        window.click("tab.Breakpoints")
        window.wait(lambda s: s["debug"]["bottom"] == "Breakpoints", "the panel")

    def test_the_legend_leaves_the_picture_free(self):
        """Beside it as long as it fits; where it would cover much of it, a button and its key show it."""
        window = self.window
        window.key("ctrl+p")
        state = window.wait(lambda s: s["debug"]["bottom"] == "Plots" and "legend" in s["widgets"], "the legend")
        canvas = state["widgets"]["canvas"]
        self.assertGreaterEqual(state["widgets"]["legend"][0], canvas[0] + canvas[2])
        window.key("ctrl+p")
        for _ in range(4):
            window.key("ctrl+equal")
        window.wait(lambda s: s["scale"] == 2 and "legend.folded" in s["widgets"], "the button")
        self.assertFalse(window.settled()["layers"]["legend"])
        window.move(*window.widget("legend.folded"))
        window.wait(lambda s: "legend.over" in s["widgets"], "the legend while the mouse is on the button")
        window.move(5, 700)
        window.wait(lambda s: "legend.over" not in s["widgets"], "the legend to go")
        window.key("g")
        state = window.wait(lambda s: s["layers"]["legend"] and "legend.over" in s["widgets"], "the legend by its key")
        x, y, width, height, _ = state["widgets"]["legend.over"]
        self.assertTrue(x >= 0 and y >= 0 and x + width <= 1280 and y + height <= 800)
        window.key("g")
        window.wait(lambda s: "legend.over" not in s["widgets"], "the legend to go again")
        window.click("legend.folded")
        window.wait(lambda s: s["layers"]["legend"], "the legend by its button")

    def legend_at(self):
        widgets = self.window.settled()["widgets"]
        return [name for name in ("legend", "legend.folded") if name in widgets]

    def test_the_legend_stays_where_it_is_while_one_steps(self):
        window = self.window
        window.key("ctrl+equal", "c")
        window.wait(lambda s: s["scale"] == 1.25, "125 %")
        seen = []
        for key in ("End", "shift+F10", "F11", "F11", "F11", "F11", "Escape", "Right", "Left", "End", "Prior", "o", "End"):
            window.key(key)
            seen.append((key, self.legend_at()))
        self.assertEqual({str(place) for _, place in seen}, {"['legend']"}, seen)
        # Where it has no room, it stays away until the window changes, also where it would have room again.
        window.key("ctrl+p", "q", "c", "c")
        seen = []
        for key in ("shift+F10", "k", "k", "End", "o", "g", "g"):
            window.key(key)
            seen.append((key, self.legend_at()))
        self.assertEqual(len({str(place) for _, place in seen if place}), 1, seen)

    def test_no_label_is_under_the_legend(self):
        window = self.window
        for _ in range(4):
            window.key("ctrl+equal")
        window.wait(lambda s: s["scale"] == 2 and "legend.folded" in s["widgets"], "the button")
        window.key("Home")
        for _ in range(3):
            widgets = window.settled()["widgets"]
            left, top, wide, high, _ = widgets["legend.folded"]
            labels = [box for name, box in widgets.items() if name.startswith("label.")]
            self.assertGreaterEqual(len(labels), 2)
            for x, y, width, height, _ in labels:
                self.assertTrue(x + width <= left or x >= left + wide or y >= top + high or y + height <= top,
                                (labels, widgets["legend.folded"]))
            window.key("plus")

    def test_no_button_of_the_breakpoints_is_cut(self):
        window = self.window
        for _ in range(4):
            window.key("ctrl+equal")
        window.key("ctrl+b")
        names = ["break.words", "continue_back", "continue_forward", "first_violation"]
        state = window.wait(lambda s: s["scale"] == 2 and all(n in s["widgets"] for n in names), "the panel")
        right = 1280 - min(2 * 340, 0.4 * (1280 - 48)) - 36
        for name in names:
            self.assertLessEqual(sum(state["widgets"][name][0:3:2]), right, name)

    def test_the_picture_keeps_its_share(self):
        """However large everything is, a good part of the width is the picture's, and no panel is lost."""
        window = self.window
        for _ in range(8):
            window.key("ctrl+equal")
        state = window.wait(lambda s: s["scale"] == 3 and s["widgets"]["canvas"][2] >= 0.4 * 1280 - 40, "the picture")
        self.assertGreater(state["widgets"]["canvas"][3], 150)
        window.press(*window.pixel(-25, 5))
        window.wait(lambda s: s["selection"]["kind"] != "none", "a selection")
        window.key("y")
        window.wait(lambda s: s["debug"]["tab"] == "Why" and "tab.Why" in s["widgets"], "the answer in the one column")
        window.key("F4")
        window.wait(lambda s: s["widgets"]["canvas"][2] > 1200, "the picture alone")
        window.key("F4")
        window.wait(lambda s: "tab.Why" in s["widgets"], "the column again")


class Low(harness.WindowTest):
    """A small screen with large letters."""

    screen = (1280, 720)

    def setUp(self):
        super().setUp()
        for _ in range(4):
            self.window.key("ctrl+equal")
        self.window.wait(lambda s: s["scale"] == 2, "the scale")
        self.window.settled()

    def test_the_open_dialog_is_in_sight_from_its_heading_on(self):
        window = self.window
        window.key("ctrl+o")
        self.assertGreater(window.widget_box("open.samples")[1], 60)  # its title ends there
        _, top, _, height = window.widget_box("open.close")
        self.assertLess(top + height, 720)

    def test_the_example_of_a_condition_is_not_cut(self):
        window = self.window
        window.key("ctrl+b")
        x, y, width, height = window.widget_box("break.condition")
        at_its_end = window.image().colors(x + width - 12, y + 10, 8, height - 20)
        self.assertEqual(len(at_its_end), 1, "letters")

    def test_the_name_of_a_constraint_stays_in_the_picture(self):
        window = self.window
        for at in ([16, 0], [16, 4], [8, 4]):
            wish = {"at": at, "length": 0.5, "name": "the far end of the plate"}
            self.open("plate.json", {"name": "plate", "outer": [[0, 0], [16, 0], [16, 4], [0, 4]], "density": [wish]})
            window.settled()
            if not window.state()["layers"]["constraints"]:
                window.key("k")
            window.key("Home")
            x, y, width, height = window.widget_box("wish.the far end of the plate, h 0.5")
            left, top, wide, high = window.canvas()
            self.assertTrue(left <= x and x + width <= left + wide, at)
            self.assertTrue(top <= y and y + height <= top + high, at)

    def test_what_plots_tell_covers_none_of_them(self):
        window = self.window
        window.key("ctrl+p")
        for name in ("plots.run", "plots.bars"):
            x, y, width, height = window.widget_box(name)
            for part in (0.05, 0.95):
                window.move(x + part * width - 2, y + height / 2)
                window.move(x + part * width, y + height / 2)
                left, top, wide, high = window.widget_box("tooltip")
                self.assertLessEqual(top + high, y, (name, part))
                self.assertTrue(left >= 0 and left + wide <= 1280, (name, part))


class MonitorScale(unittest.TestCase):
    def test_the_window_fits_on_the_screen(self):
        """A monitor that asks for 200 % enlarges the window, but not beyond itself."""
        display = harness.Display(1440, 900)
        self.addCleanup(display.close)
        resources = xresources.Resources(display.name, Xft_dpi=192)
        self.addCleanup(resources.close)
        window = harness.Window(display)
        self.addCleanup(window.close)
        state = window.settled()
        self.assertEqual(state["scale"], 2.0)
        geometry = window.xdotool("getwindowgeometry", "--shell", window.id)
        x, y, width, height = (int(re.search(rf"^{name}=(-?\d+)$", geometry, re.MULTILINE)[1])
                               for name in ("X", "Y", "WIDTH", "HEIGHT"))
        self.assertTrue(x >= 0 and y >= 0 and x + width <= 1440 and y + height <= 900, geometry)
        for name, (left, top, wide, high, _) in state["widgets"].items():
            if name in ("canvas", "timeline", "tab.Plots", "save_picture", "caption"):
                self.assertTrue(left >= 0 and top >= 0 and left + wide <= 1440 and top + high <= 900, name)


class Captions(harness.WindowTest):
    def test_no_line_is_cut(self):
        window = self.window
        window.click("stage.step5")
        window.wait(lambda s: s["stage"] == "step5", "step 5")
        window.key("F11")
        caption = window.wait(lambda s: s["insertion"]["phase"] == 1, "a long caption")["caption"]
        for scale in (1.0, 2.0, 2.5, 3.0):
            while window.settled()["scale"] < scale:
                window.key("ctrl+equal")
            state = window.settled()
            _, top, _, height, _ = state["widgets"]["caption"]
            self.assertLessEqual(top + height, state["widgets"]["timeline"][1], scale)
            self.assertEqual(state["caption"], caption)
            # Beside it the list of stages shows the one that it is about.
            top = state["widgets"]["current_stage"][1]
            _, above, _, high, _ = state["widgets"]["canvas"]
            self.assertGreaterEqual(top, above, scale)
            self.assertLessEqual(top + 20 * scale, above + high, scale)
        # What had no room at the largest scale is told by the tooltip.
        x, y = window.widget("caption")
        window.move(x, y)
        window.move(x + 2, y)
        window.wait(lambda s: s["tooltip"] == caption, "the whole caption")


class Idle(harness.WindowTest):
    def test_nothing_is_drawn_while_nothing_happens(self):
        def ticks():
            with open(f"/proc/{self.window.process.pid}/stat", encoding="utf-8") as file:
                fields = file.read().rsplit(")", 1)[1].split()
            return int(fields[11]) + int(fields[12])

        self.window.settled()
        time.sleep(1)
        before = ticks()
        time.sleep(3)
        self.assertLessEqual(ticks() - before, 0.02 * 3 * os.sysconf("SC_CLK_TCK"))


class Parameters(harness.WindowTest):
    def bring(self, name):
        """Scrolls the parameters from their start until one of them is well in sight."""
        left, top, _, height = self.window.canvas()
        self.window.move(left / 2, top + 200)
        self.window.xdotool("click", "--repeat", "12", "--delay", "40", "4")
        for _ in range(12):
            if self.window.widget(name)[1] < top + 0.6 * height:
                break
            self.window.xdotool("click", "5")

    def test_switches_and_numbers_mesh_again(self):
        window = self.window
        window.click("tab.Stages")
        window.click("stage.optimise")
        start = window.wait(lambda s: s["stage"] == "optimise" and s["activity"] == "idle", "the end of step 6")
        window.click("tab.Params")
        for name in ("laplacian", "reduce_obtuse", "shared_edge", "polish"):
            before = window.settled()
            self.bring("param." + name)
            window.click("param." + name)
            after = window.wait(lambda s: s["settings"][name] == 0 and not s["stale"] and s["activity"] == "idle", name)
            self.assertNotEqual(after["hash"], before["hash"])
        self.assertGreater(after["figures"]["obtuse"], start["figures"]["obtuse"])
        window.key("ctrl+z", "ctrl+z", "ctrl+z", "ctrl+z")
        window.wait(lambda s: s["hash"] == start["hash"], "everything undone")
        self.bring("param.omega")
        x, y = window.widget("param.omega")
        window.drag(x - 60, y, x + 40, y)
        dragged = window.wait(lambda s: s["settings"]["omega"] > 0.3 and s["activity"] == "idle", "a larger omega")
        self.assertEqual(dragged["stage"], "optimise")
        window.click("param.omega.reset")
        window.wait(lambda s: s["hash"] == start["hash"], "the default again")

    def test_a_drag_is_followed_and_is_one_step_of_undo(self):
        window = self.window
        start = window.settled()
        window.click("tab.Params")
        x, y, width, height = window.widget_box("param.omega")
        places = [x + part * width for part in (0.25, 0.5, 0.75)]
        seen = []
        window.hold(places[0], y + height / 2)
        for place in places:
            window.move(place, y + height / 2)
            last = seen[-1]["settings"]["omega"] if seen else 0.0
            window.wait(lambda s: s["settings"]["omega"] > last + 0.1, "omega to follow")
            seen.append(window.settled())
        window.release()
        self.assertEqual(len({s["hash"] for s in [start] + seen}), 4, "each place has a mesh of its own")
        window.key("ctrl+z")
        window.wait(lambda s: s["settings"] == start["settings"] and s["hash"] == start["hash"], "one undo for the drag")
        window.key("ctrl+z")
        window.wait(lambda s: s["message"] == "Nothing has been changed.", "nothing more to undo")
        window.key("ctrl+y")
        window.wait(lambda s: s["hash"] == seen[-1]["hash"], "the drag again")

    def test_escape_gives_a_drag_up(self):
        window = self.window
        start = window.settled()
        window.click("tab.Params")
        x, y, width, height = window.widget_box("param.theta")
        window.hold(x + 0.4 * width, y + height / 2)
        window.move(x + 0.8 * width, y + height / 2)
        window.wait(lambda s: s["settings"]["theta"] > 20 and s["activity"] == "idle", "a larger theta")
        window.xdotool("key", "Escape")  # key() would let the button go
        window.wait(lambda s: s["settings"] == start["settings"] and s["hash"] == start["hash"], "everything as before")
        window.move(x + 0.6 * width, y + height / 2)  # still held: nothing more is to come of it
        self.assertEqual(window.settled()["settings"], start["settings"])
        window.release()
        self.assertEqual(window.settled()["hash"], start["hash"])
        window.key("ctrl+z")
        window.wait(lambda s: s["message"] == "Nothing has been changed.", "nothing to undo")

    def test_smallest_edge(self):
        window = self.window
        start = window.settled()
        window.click("tab.Params")
        x, y = window.widget("param.min_edge_length")
        window.drag(x, y, x + 60, y)
        coarse = window.wait(lambda s: s["min_edge"] > 1.3 and s["activity"] == "idle" and not s["stale"], "coarser")
        self.assertLess(coarse["figures"]["triangles"], start["figures"]["triangles"])


class Kept(unittest.TestCase):
    def test_theme_and_scale_are_remembered(self):
        display = harness.Display()
        self.addCleanup(display.close)
        with tempfile.TemporaryDirectory() as home:
            file = os.path.join(home, "triscope", "window.conf")
            first = harness.Window(display, "--preferences", file)
            self.addCleanup(first.close)
            first.settled()
            first.key("ctrl+t", "ctrl+equal", "ctrl+q")
            first.process.wait(harness.TIMEOUT)
            second = harness.Window(display, "--preferences", file)
            self.addCleanup(second.close)
            state = second.settled()
            self.assertEqual((state["theme"], state["scale"]), ("dark", 1.25))


if __name__ == "__main__":
    unittest.main()
