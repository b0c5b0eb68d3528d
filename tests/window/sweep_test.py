"""Sweeps over ω and θ in the window, with real keys and mouse."""

import csv
import io
import os
import subprocess
import unittest

import harness
from keys_test import chord

BLUNT_BODY = f"{harness.SOURCE}/assets/domains/blunt_body.json"
LARGE = f"{harness.SOURCE}/assets/domains/three_element_airfoil.json"


class Sweep(harness.WindowTest):
    arguments = [BLUNT_BODY]

    def keys(self, action):
        return [chord(k) for k in self.window.state()["keys"][action]]

    def sweep(self, what):
        """The state once `what` holds for the sweep."""
        return self.window.wait(lambda s: what(s["sweep"]), "the sweep")

    def set(self, field, value):
        """Types into a field of the ranges, as Ctrl+click allows."""
        self.window.press(*self.window.widget("sweep." + field), modifier="ctrl")
        self.window.xdotool("key", "ctrl+a")
        self.window.type(str(value))
        self.window.key("Return")

    def small(self):
        """Opens the panel and runs 3 × 2 pairs."""
        self.window.key(*self.keys("sweep_panel"))
        self.set("omega.count", 3)
        self.set("theta.count", 2)
        self.sweep(lambda s: s["omega"] == [0.05, 0.25, 3] and s["theta"] == [5, 10, 2])
        self.window.click("run_sweep")
        return self.sweep(lambda s: not s["running"] and s["done"] == 6)

    def rows(self, state):
        return list(csv.DictReader(io.StringIO(state["sweep"]["csv"])))

    def cell(self, omega, theta):
        """Middle of a cell on the screen."""
        sweep = self.window.state()["sweep"]
        x, y, width, height = self.window.widget_box("sweep.map")
        columns, rows = len(sweep["omegas"]), len(sweep["thetas"])
        i, j = sweep["omegas"].index(omega), sweep["thetas"].index(theta)
        return x + (i + 0.5) * width / columns, y + (rows - j - 0.5) * height / rows

    def command_line(self, *arguments):
        return subprocess.run([harness.PROGRAM, "sweep", BLUNT_BODY, "-q", *arguments], check=True,
                              capture_output=True, text=True).stdout

    def test_values_are_those_of_the_command_line(self):
        window = self.window
        before = window.settled()
        after = self.small()
        self.assertEqual(after["sweep"]["csv"], self.command_line("--omega", "0.05:0.25:3", "--theta", "5:10:2"))
        self.assertIn("6 pairs", after["message"])
        self.assertFalse(after["sweep"]["stale"])
        for same in ("hash", "tick", "settings", "undo"):
            self.assertEqual(after[same], before[same], "the run at hand is untouched")
        # Another setting of step 6 counts too.
        window.click("tab.Params")
        window.click("param.shared_edge")
        self.sweep(lambda s: s["stale"])
        window.settled()
        window.key(*self.keys("run_sweep"))
        state = self.sweep(lambda s: not s["running"] and not s["stale"])
        expected = self.command_line("--omega", "0.05:0.25:3", "--theta", "5:10:2", "--set", "shared_edge=off")
        self.assertEqual(state["sweep"]["csv"], expected)
        self.assertNotEqual(state["sweep"]["csv"], after["sweep"]["csv"])

    def test_a_click_takes_the_pair_and_undo_brings_it_back(self):
        window = self.window
        before = self.small()
        wanted = {(float(r["omega"]), float(r["theta_deg"])): r for r in self.rows(before)}
        for omega, theta in ((0.25, 5.0), (0.05, 10.0)):
            window.press(*self.cell(omega, theta))
            state = window.wait(lambda s: s["settings"]["omega"] == omega and s["settings"]["theta"] == theta
                                and s["stage"] == "optimise" and not s["stale"] and s["activity"] == "idle", "the pair")
            row = wanted[omega, theta]
            for key in ("triangles", "obtuse", "aspect_ratio_max", "area_ratio_max", "edge_ratio_max", "min_angle_deg"):
                self.assertEqual(state["figures"][key], float(row[key]), key)
            self.assertFalse(state["sweep"]["stale"], "the pair itself changes nothing of a sweep")
        self.assertEqual(state["undo"], 2)
        window.press(*self.cell(0.05, 10.0))
        self.assertEqual(window.settled()["undo"], 2, "the pair in force is no change")
        window.key("ctrl+z", "ctrl+z", "End")
        state = window.wait(lambda s: s["hash"] == before["hash"] and not s["stale"], "the run from before")
        self.assertEqual((state["settings"], state["undo"]), (before["settings"], 0))

    def test_a_pair_taken_on_the_way_is_shown_where_step_6_ends(self):
        """The figures of a cell are those of the end of step 6: nothing else is shown as if it had them."""
        window = self.window
        before = self.small()
        window.click("tab.Stages")
        window.click("stage.front1")
        window.wait(lambda s: s["tick"] < before["tick"] and s["activity"] == "idle", "an early stage")
        window.press(*self.cell(0.25, 5.0))
        state = window.wait(lambda s: s["settings"]["omega"] == 0.25 and s["stage"] == "optimise" and not s["stale"]
                            and s["activity"] == "idle", "the end of step 6 with the pair")
        row = next(r for r in self.rows(before) if (float(r["omega"]), float(r["theta_deg"])) == (0.25, 5.0))
        self.assertEqual(state["figures"]["obtuse"], float(row["obtuse"]))

    def test_cells_are_coloured_by_the_figure_chosen(self):
        window = self.window
        rows = self.rows(self.small())

        def best(key, sign):
            return min(range(len(rows)), key=lambda k: (sign * float(rows[k][key]), float(rows[k]["obtuse"]),
                                                        float(rows[k]["aspect_ratio_max"])))

        for name, key, sign in (("worst aspect ratio", "aspect_ratio_max", 1), ("worst area ratio", "area_ratio_max", 1),
                                ("worst edge ratio", "edge_ratio_max", 1), ("smallest angle", "min_angle_deg", -1),
                                ("obtuse triangles", "obtuse", 1), ("largest angle", "max_angle_deg", 1)):
            window.click("sweep.figure")
            window.click("sweep.figure." + name)
            state = self.sweep(lambda s: s["figure"] == name)
            self.assertEqual(state["sweep"]["best"], best(key, sign), name)
        window.move(10, 10)
        # Cividis goes from dark blue to light yellow: the extremes of the last figure have its ends.
        values = [float(r["max_angle_deg"]) for r in rows]
        for k, color in ((values.index(min(values)), (0x00, 0x22, 0x4E)), (values.index(max(values)), (0xFE, 0xE8, 0x38))):
            x, y = self.cell(float(rows[k]["omega"]), float(rows[k]["theta_deg"]))
            window.drawn(lambda image: image.near(color, x, y, 10) > 100, f"the colour of cell {k}")

    def test_ranges_stay_within_the_settings(self):
        self.window.key(*self.keys("sweep_panel"))
        self.set("omega.to", 7)
        self.sweep(lambda s: s["omega"] == [0.05, 1, 5])
        self.set("omega.from", 0)
        self.sweep(lambda s: s["omega"] == [0, 1, 5])
        self.set("theta.to", 99)
        self.sweep(lambda s: s["theta"] == [5, 30, 6])
        self.set("theta.to", 8)
        self.set("theta.from", 12)
        self.sweep(lambda s: s["theta"] == [12, 12, 6])
        self.set("theta.count", 1000)
        self.sweep(lambda s: s["theta"] == [12, 12, 40])
        self.set("omega.count", 2)
        self.window.click("run_sweep")
        state = self.sweep(lambda s: not s["running"] and s["done"] == 2)
        self.assertEqual((state["sweep"]["omegas"], state["sweep"]["thetas"]), ([0, 1], [12]))

    def test_out_of_date_and_back(self):
        window = self.window
        before = self.small()
        self.assertTrue(window.enabled("save_sweep"))
        window.press(*self.cell(0.15, 5.0))
        window.wait(lambda s: s["settings"]["theta"] == 5, "the pair")
        window.settled()
        window.click("tab.Params")
        window.click("param.shared_edge")
        state = self.sweep(lambda s: s["stale"])
        self.assertIn("sweep.stale", window.wait(lambda s: "sweep.stale" in s["widgets"], "the words")["widgets"])
        self.assertFalse(window.enabled("save_sweep"))
        self.assertNotIn("sweep.legend", window.state()["widgets"])
        # Pale: no cell has the dark end of the colours any more.
        x, y, width, height = window.widget_box("sweep.map")
        window.move(10, 10)
        window.drawn(lambda i: all(sum(c) > 3 * 80 for c, n in i.colors(x + 4, y + 4, width - 8, height - 8).items()
                                   if n > 1500), "pale cells")
        window.key("ctrl+z")
        state = self.sweep(lambda s: not s["stale"])
        self.assertEqual(state["sweep"]["csv"], before["sweep"]["csv"])
        window.settled()
        # Another domain: the sweep is not about it.
        window.open_by_dialog(f"{harness.SOURCE}/assets/domains/square.json")
        window.wait(lambda s: s.get("domain") == "square" and s["sweep"]["stale"], "the other domain")

    def test_saved_as_the_command_line_writes_it(self):
        window = self.window
        self.assertFalse(self.possible("save_sweep"))
        state = self.small()
        window.click("save_sweep")
        window.wait(lambda s: s["dialog"] == "export", "the dialog")
        path = os.path.join(window.folder.name, "pairs.csv")
        window.click("export.path")
        window.xdotool("key", "ctrl+a")
        window.type(path)
        window.key("Return")
        window.wait(lambda s: s["message"].startswith("Wrote "), "the file")
        with open(path, encoding="utf-8") as file:
            self.assertEqual(file.read(), state["sweep"]["csv"])

    def possible(self, action):
        """Whether the menu's entry can be chosen."""
        window = self.window
        window.click("menu.Compare")
        possible = window.wait(lambda s: "menu." + action in s["widgets"], "the menu")["widgets"]["menu." + action][4]
        window.key("Escape")
        window.wait(lambda s: "menu." + action not in s["widgets"], "the menu to close")
        return possible

    def test_keys(self):
        window = self.window
        for key in self.keys("sweep_panel"):
            window.key(key)
            window.wait(lambda s: s["debug"]["bottom"] == "Sweep", "'sweep_panel'")
            window.key(key)
            window.wait(lambda s: s["debug"]["bottom"] == "", "'sweep_panel' again")
        for key in self.keys("run_sweep"):
            window.key(key)
            state = self.sweep(lambda s: not s["running"] and s["done"] == 30)
            self.assertEqual(state["debug"]["bottom"], "Sweep", "it opens by itself")
        window.click("tab.Params")
        for name in ("laplacian", "reduce_obtuse", "shared_edge", "polish"):
            window.click("param." + name)
            window.settled()
        window.key(self.keys("run_sweep")[0])
        window.wait(lambda s: s["message"].startswith("Step 6 is switched off"), "the reason")

    def test_the_map_by_keys(self):
        window = self.window
        before = window.settled()
        window.key(*self.keys("sweep_panel"))
        window.key(self.keys("cell_up")[0])
        self.assertNotIn("chosen", window.settled()["sweep"], "there is no map yet")
        window.key(*self.keys("sweep_panel"))
        self.small()
        tick = window.settled()["tick"]
        self.assertEqual(window.state()["sweep"]["chosen"], -1)
        # Left steps back until the map has been given the keys.
        left, right, up, down = (self.keys(way)[0] for way in ("cell_left", "cell_right", "cell_up", "cell_down"))
        window.key(left)
        window.wait(lambda s: s["tick"] == tick - 1, "a step back")
        window.key("End")
        window.wait(lambda s: s["tick"] == tick and s["activity"] == "idle", "the end")
        # At first the cell nearest to the run shown; it stops at the borders.
        omegas, thetas = window.state()["sweep"]["omegas"], window.state()["sweep"]["thetas"]
        i = min(range(3), key=lambda k: abs(omegas[k] - before["settings"]["omega"]))
        j = min(range(2), key=lambda k: abs(thetas[k] - before["settings"]["theta"]))
        window.key(up)
        self.sweep(lambda s: s["chosen"] == 2 * i + j)
        for key, across, along in ((left, -1, 0), (left, -1, 0), (left, -1, 0), (up, 0, 1), (up, 0, 1), (right, 1, 0),
                                   (down, 0, -1), (down, 0, -1)):
            i, j = min(2, max(0, i + across)), min(1, max(0, j + along))
            window.key(key)
            self.sweep(lambda s: s["chosen"] == 2 * i + j)
        self.assertEqual(window.state()["tick"], tick)
        omega, theta = omegas[i], thetas[j]
        self.assertNotEqual((omega, theta), (before["settings"]["omega"], before["settings"]["theta"]))
        # The ring can be seen whatever the colour of the cell.
        window.move(10, 10)
        x, y = self.cell(omega, theta)
        _, _, width, height = window.widget_box("sweep.map")

        def ringed(image):
            colors = image.colors(x - width / 6, y - height / 4, width / 3, height / 2)
            return colors.get((0, 0, 0), 0) > 100 and colors.get((255, 255, 255), 0) > 100

        window.drawn(ringed, "the ring")
        for key in self.keys("take_cell"):
            window.key(key)
            window.wait(lambda s: (s["settings"]["omega"], s["settings"]["theta"]) == (omega, theta), "the pair")
            window.settled()
            window.key("ctrl+z")
            window.wait(lambda s: s["settings"] == before["settings"] and not s["stale"], "the pair from before")
        # Esc lets the keys go, and so does a click elsewhere; a click on a cell gives them.
        window.key("Escape")
        self.sweep(lambda s: s["chosen"] == -1)
        window.drawn(lambda image: not ringed(image), "no ring")
        window.press(*self.cell(0.25, 10.0))
        self.sweep(lambda s: s["chosen"] == 5)
        window.settled()
        at, top, wide, high = window.canvas()
        window.press(at + wide / 2, top + high / 2)
        self.sweep(lambda s: s["chosen"] == -1)

    def test_before_step_6_steps_1_to_5_are_run_for_it(self):
        window = self.window
        window.click("tab.Stages")
        window.click("stage.front1")
        window.wait(lambda s: s["stage"] == "front1" and s["activity"] == "idle", "the first front")
        # The run is made anew up to here only, and again: what came after is forgotten.
        window.click("tab.Params")
        window.press(*window.widget("param.curvature_turn"), modifier="ctrl")
        window.xdotool("key", "ctrl+a")
        window.type("25")
        window.key("Return")
        window.wait(lambda s: s["settings"]["curvature_turn"] == 25, "another parameter")
        window.settled()
        window.click("param.curvature_turn.reset")
        window.wait(lambda s: s["settings"]["curvature_turn"] == 30, "the default")
        before = window.settled()
        self.assertNotIn(before["stage"], ("refine", "finished"))
        state = self.small()
        self.assertEqual((state["stage"], state["tick"], state["hash"]), tuple(before[k] for k in ("stage", "tick", "hash")))
        self.assertEqual(state["sweep"]["csv"], self.command_line("--omega", "0.05:0.25:3", "--theta", "5:10:2"))


class LargeSweep(harness.WindowTest):
    arguments = [LARGE]

    def begin(self):
        """1600 pairs: they take minutes."""
        window = self.window
        window.key("ctrl+h")
        for name in ("omega", "theta"):
            window.press(*window.widget(f"sweep.{name}.count"), modifier="ctrl")
            window.xdotool("key", "ctrl+a")
            window.type("40")
            window.key("Return")
        window.wait(lambda s: s["sweep"]["omega"][2] == s["sweep"]["theta"][2] == 40, "the numbers of values")
        window.click("run_sweep")
        return window.wait(lambda s: s["sweep"]["running"] and s["sweep"]["done"] > 0, "some pairs")

    def test_cancelled_by_button_and_by_key(self):
        window = self.window
        before = window.settled()
        self.begin()
        window.click("sweep.cancel")
        state = window.wait(lambda s: not s["sweep"]["running"], "the sweep to end")
        self.assertEqual(state["message"], "The sweep was given up.")
        self.assertNotIn("csv", state["sweep"])
        self.assertEqual(state["hash"], before["hash"])
        window.click("run_sweep")
        window.wait(lambda s: s["sweep"]["running"] and s["sweep"]["done"] > 0, "some pairs")
        window.key("Escape")
        window.wait(lambda s: not s["sweep"]["running"], "the sweep to end")

    def test_the_run_goes_on_meanwhile(self):
        window = self.window
        self.begin()
        before = window.state()
        window.key("ctrl+Left")
        state = window.wait(lambda s: s["tick"] < before["tick"] and s["activity"] == "idle", "a stage back")
        self.assertTrue(state["sweep"]["running"])
        window.key("End")
        state = window.wait(lambda s: s["hash"] == before["hash"] and s["activity"] == "idle", "the end")
        self.assertTrue(state["sweep"]["running"])
        self.assertFalse(state["sweep"]["stale"])

    def test_another_domain_ends_it(self):
        window = self.window
        self.begin()
        window.open_by_dialog(BLUNT_BODY)
        state = window.wait(lambda s: s.get("domain") == "blunt body" and not s["sweep"]["running"], "the sweep to end")
        self.assertNotIn("csv", state["sweep"])
        window.settled()
        window.click("run_sweep")
        window.wait(lambda s: s["sweep"]["running"] and s["sweep"]["done"] > 0, "another sweep")

    def test_closing_the_window_ends_it(self):
        window = self.window
        self.begin()
        window.key("ctrl+q")
        self.assertEqual(window.process.wait(timeout=harness.TIMEOUT), 0)


if __name__ == "__main__":
    unittest.main()
