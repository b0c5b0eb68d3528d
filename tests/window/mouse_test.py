"""Buttons, picking, panning and zooming with a real mouse, checked against the pixels on the screen."""

import unittest

import harness


class Toolbar(harness.WindowTest):
    def test_every_button(self):
        window = self.window
        vertices = lambda s: s["figures"]["vertices"]
        end = window.settled()
        self.assertEqual(end["stage"], "finished")
        for name in ("step", "insertion", "stage", "to_end", "play_pause", "reload"):
            self.assertFalse(window.enabled(name), name)

        def press(name, change):
            before = window.settled()
            window.click(name)
            return window.wait(lambda s: s["activity"] == "idle" and change(before, s), f"the button '{name}'")

        press("restart", lambda a, b: b["tick"] == 0)
        for name in ("restart", "stage_back", "insertion_back", "step_back", "worst_aspect"):
            self.assertFalse(window.enabled(name), name)
        window.click("stage.step1")
        window.wait(lambda s: s["stage"] == "step1", "the first step")
        press("step", lambda a, b: b["tick"] == a["tick"] + 1)
        press("insertion", lambda a, b: vertices(b) == vertices(a) + 1)
        press("insertion_back", lambda a, b: vertices(b) == vertices(a) - 1)
        press("step_back", lambda a, b: b["tick"] == a["tick"] - 1)
        press("stage.step1", lambda a, b: b["stage"] == "step1")
        press("stage", lambda a, b: b["stage"] == "step2")
        press("stage_back", lambda a, b: b["stage"] == "step1")
        before = window.settled()
        window.click("play_pause")
        window.wait(lambda s: s["activity"] == "playing" and s["tick"] > before["tick"] + 3, "playing")
        window.click("play_pause")
        paused = window.settled()
        self.assertLess(paused["tick"], end["tick"])
        press("to_end", lambda a, b: b["hash"] == end["hash"])
        for name in ("worst_aspect", "worst_area", "worst_edge"):
            press(name, lambda a, b: b["selection"]["kind"] == "triangle" and b["camera"] != a["camera"])
            self.assertGreater(window.state()["camera"]["scale"], 1.5 * end["camera"]["scale"])
        press("fit", lambda a, b: abs(b["camera"]["scale"] - end["camera"]["scale"]) < 1e-6)
        window.click("open")
        window.wait(lambda s: s["dialog"] == "open", "the dialog")
        window.click("open.close")
        window.wait(lambda s: s["dialog"] == "none", "the dialog to close")
        window.click("save_picture")
        window.wait(lambda s: s["message"].startswith("Wrote"), "the picture")
        x, y = window.widget("speed")
        window.drag(x, y, x + 40, y)
        window.wait(lambda s: s["speed"] > 2 * end["speed"], "a higher speed")

    def test_a_disabled_button_says_why(self):
        window = self.window
        x, y = window.widget("step")
        before = window.image()
        window.move(x, y - 3)
        window.move(x, y)
        after = window.image()
        # The tooltip covers something below the button that it did not cover before.
        self.assertNotEqual(before.colors(x, y + 20, 160, 40), after.colors(x, y + 20, 160, 40))


    def test_tooltips_keep_away_from_who_works_by_keys(self):
        x, y = self.window.widget("restart")
        self.window.move(x, y)
        self.window.wait(lambda s: s["tooltip"], "the tooltip")
        self.window.key("Left")
        self.window.wait(lambda s: not s["tooltip"], "the tooltip to go")
        self.window.key("Right")
        self.assertEqual(self.window.settled()["tooltip"], "")
        self.window.move(x + 2, y)
        self.window.wait(lambda s: s["tooltip"], "the tooltip once the mouse moves")


class Canvas(harness.WindowTest):
    def test_is_not_blank_and_shows_the_mesh(self):
        state = self.window.settled()
        left, top, width, height = self.window.canvas()
        image = self.window.image()
        colors = image.colors(left, top, width, height)
        self.assertGreater(len(colors), 50)
        background = tuple(state["colors"]["background"])
        inside = sum(n for c, n in colors.items() if c != background)
        self.assertGreater(inside, width * height / 4)
        # The corner of the canvas is outside the domain.
        self.assertEqual(image.at(left + 4, top + 4), background)
        # The corners of the domain are input points, drawn in the colour of text.
        for x in (-32, 32):
            for y in (-32, 32):
                px, py = self.window.pixel(x, y)
                self.assertGreater(image.near((0, 0, 0), px, py, 4, 120), 8, (x, y))
        # Without the triangulation the wire is gone.
        wire = tuple(state["colors"]["wire"])
        near_wire = lambda im: sum(n for c, n in im.colors(left, top, width, height).items()
                                   if sum(abs(a - b) for a, b in zip(c, wire)) < 60)
        before = near_wire(image)
        self.window.key("t", "w")
        after = near_wire(self.window.image())
        self.assertLess(after, before / 4)

    def test_pick_triangle_vertex_edge_and_cell(self):
        window = self.window
        window.key("2")
        framed = window.wait(lambda s: s["selection"]["kind"] == "triangle", "the worst triangle")
        selection = framed["selection"]
        x, y = window.pixel(selection["x"], selection["y"])
        color = tuple(framed["colors"]["selection"])
        lit = window.image().near(color, x, y, 60)
        self.assertGreater(lit, 60)
        window.key("Escape")
        window.wait(lambda s: s["selection"]["kind"] == "none", "nothing selected")
        self.assertLess(window.image().near(color, x, y, 60), lit / 4)
        window.press(x, y)
        picked = window.wait(lambda s: s["selection"]["kind"] == "triangle", "a triangle")
        self.assertEqual(picked["selection"]["id"], selection["id"])
        self.assertGreater(window.image().near(color, x, y, 60), 60)
        # A vertex of it, by the link in the panel, then the same by hand.
        window.press(x, y, modifier="ctrl")
        window.wait(lambda s: s["selection"]["kind"] == "cell", "a cell")
        # A corner of the domain is a vertex.
        window.key("Home")
        window.settled()
        window.press(*window.pixel(32, 32))
        corner = window.wait(lambda s: s["selection"]["kind"] == "vertex", "a vertex")
        self.assertAlmostEqual(corner["selection"]["x"], 32)
        self.assertAlmostEqual(corner["selection"]["y"], 32)
        # Near the middle of a boundary edge beside it, nearer than to either end.
        window.key("plus", "plus", "plus", "plus", "plus")
        window.settled()

    def test_wheel_zooms_to_the_cursor_and_drag_pans(self):
        window = self.window
        before = window.settled()
        x, y = window.pixel(10, 12)
        window.move(x, y)
        window.xdotool("click", "4")
        zoomed = window.wait(lambda s: s["camera"]["scale"] > before["camera"]["scale"] * 1.1, "the zoom")
        zx, zy = window.pixel(10, 12)
        self.assertAlmostEqual(zx, x, delta=1.5)
        self.assertAlmostEqual(zy, y, delta=1.5)
        scale = zoomed["camera"]["scale"]
        window.drag(x, y, x + 60, y - 30)
        window.wait(lambda s: abs(s["camera"]["x"] - zoomed["camera"]["x"] + 60 / scale) < 8 / scale, "the pan")
        after = window.settled()
        self.assertAlmostEqual(after["camera"]["y"], zoomed["camera"]["y"] - 30 / scale, delta=8 / scale)
        self.assertEqual(after["selection"]["kind"], "none")  # a drag is no click

    def test_box_zoom_and_centring(self):
        window = self.window
        before = window.settled()
        x0, y0 = window.pixel(-20, 20)
        x1, y1 = window.pixel(-10, 10)
        window.drag(x0, y0, x1, y1, modifier="shift")
        after = window.wait(lambda s: s["camera"]["scale"] > 2 * before["camera"]["scale"], "the box")
        self.assertAlmostEqual(after["camera"]["x"], -15, delta=1)
        self.assertAlmostEqual(after["camera"]["y"], 15, delta=1)
        x, y = window.pixel(-13, 13)
        window.move(x, y)
        window.xdotool("click", "--repeat", "2", "--delay", "120", "1")
        window.wait(lambda s: abs(s["camera"]["x"] + 13) < 0.3 and abs(s["camera"]["y"] - 13) < 0.3, "centring")

    def test_context_menu_picks_the_cell(self):
        window = self.window
        window.press(*window.pixel(-25, 5), button=3)
        window.click("context.cell")
        window.wait(lambda s: s["selection"]["kind"] == "cell", "a cell")

    def test_context_menu_asks_about_what_is_there(self):
        window = self.window
        place = window.pixel(-25, 5)
        window.press(*place, button=3)
        window.widget("context.why")
        window.key("Escape")
        window.wait(lambda s: "context.why" not in s["widgets"], "Esc to close the menu")
        window.press(*place, button=3)
        window.click("context.why")
        picked = window.wait(lambda s: s["selection"]["kind"] != "none" and s["debug"]["tab"] == "Why", "the answer")
        window.press(*place, button=3)
        window.click("context.history")
        window.wait(lambda s: s["debug"]["tab"] == "History", "the history")
        window.press(*place, button=3)
        window.click("context.break")
        state = window.wait(lambda s: s["message"].startswith("Breakpoint:"), "the breakpoint")
        self.assertIn(str(picked["selection"]["id"]), state["message"])

    def test_splitters_move_the_borders(self):
        window = self.window
        left, _, width, _ = window.canvas()
        x, y = window.widget("splitter.left")
        window.drag(x, y, x + 60, y)
        window.wait(lambda s: s["widgets"]["canvas"][0] > left + 40, "a wider left side")
        x, y = window.widget("splitter.right")
        window.drag(x, y, x - 50, y)
        window.wait(lambda s: s["widgets"]["canvas"][2] < width - 80, "a wider right side")


class Menus(harness.WindowTest):
    def test_menu_entries_act(self):
        window = self.window
        window.click("menu.View")
        window.click("menu.quadtree")
        window.wait(lambda s: s["layers"]["quadtree"], "the quadtree")
        window.click("menu.Run")
        window.click("menu.restart")
        window.wait(lambda s: s["tick"] == 0, "the start")
        window.click("menu.Help")
        window.click("menu.about")
        window.wait(lambda s: s["dialog"] == "about", "the dialog")
        window.click("dialog.close")
        window.wait(lambda s: s["dialog"] == "none", "the dialog to close")

    def test_panels_switch_layers(self):
        window = self.window
        window.click("tab.Layers")
        for name in ("boundary", "quadtree", "obtuse", "worst"):
            before = window.settled()["layers"][name]
            window.click("layer." + name)
            window.wait(lambda s: s["layers"][name] != before, name)


if __name__ == "__main__":
    unittest.main()
