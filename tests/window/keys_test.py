"""Every key of the table does what the table says."""

import os
import unittest

import harness

NAMES = {"Esc": "Escape", "Del": "Delete", "PageUp": "Prior", "PageDown": "Next", "Space": "space", "[": "bracketleft",
         "]": "bracketright", ",": "comma", ".": "period", "=": "equal", "-": "minus", "+": "plus", "?": "question",
         "Enter": "Return", "Keypad Enter": "KP_Enter", "Keypad +": "KP_Add", "Keypad -": "KP_Subtract"}


def chord(text):
    """The table's 'Ctrl+Shift+F11' as xdotool's 'ctrl+shift+F11'."""
    modifiers = []
    while text[:-1] and any(text.startswith(m + "+") for m in ("Ctrl", "Shift", "Alt")):
        modifier, text = text.split("+", 1)
        modifiers.append(modifier.lower())
    name = NAMES.get(text, text.lower() if len(text) == 1 else text)
    return "+".join(modifiers + [name])


class Keys(harness.WindowTest):
    def chords(self, action):
        keys = self.window.state()["keys"][action]
        self.tried.add(action)
        return [chord(k) for k in keys]

    def setUp(self):
        super().setUp()
        self.tried = set()

    def press(self, action, change):
        """Presses each key of the action; `change(before, after)` must become true each time."""
        for key in self.chords(action):
            before = self.window.settled()
            self.window.key(key)
            after = self.window.wait(lambda s: change(before, s), f"'{key}' to do '{action}'")
            yield before, after

    def each(self, action, change):
        for _ in self.press(action, change):
            pass

    def go_to(self, stage):
        self.window.click("tab.Stages")
        self.window.click("stage." + stage)
        return self.window.wait(lambda s: s["stage"] == stage and s["activity"] == "idle", stage)

    def run_to_end(self):
        self.window.key("F5")
        self.window.wait(lambda s: s["stage"] == "finished" and s["activity"] == "idle", "the end")

    def test_running(self):
        vertices = lambda s: s["figures"]["vertices"]
        self.go_to("step1")
        self.each("step", lambda a, b: b["tick"] == a["tick"] + 1)
        self.each("step_back", lambda a, b: b["tick"] == a["tick"] - 1)
        self.each("insertion", lambda a, b: vertices(b) == vertices(a) + 1)
        self.each("insertion_back", lambda a, b: vertices(b) == vertices(a) - 1 or b["tick"] < a["tick"])
        self.go_to("step1")
        for _ in self.press("stage", lambda a, b: b["stage"] == "step2"):
            self.go_to("step1")
        self.window.key("F10", "F10")
        self.each("stage_back", lambda a, b: b["tick"] < a["tick"])
        for _ in self.press("restart", lambda a, b: b["tick"] == 0):
            self.go_to("step1")
        for _ in self.press("to_end", lambda a, b: b["stage"] == "finished"):
            self.go_to("step2")
        self.each("round", lambda a, b: b["round"] != a["round"])
        self.each("slower", lambda a, b: abs(b["speed"] * 2 - a["speed"]) < 1e-9)
        self.each("faster", lambda a, b: abs(b["speed"] - a["speed"] * 2) < 1e-9)
        self.go_to("step1")
        for key in self.chords("play_pause"):
            before = self.window.settled()
            self.window.key(key)
            self.window.wait(lambda s: s["activity"] == "playing" and s["tick"] > before["tick"], "playing")
            self.window.key(key)
            self.window.settled()

    def test_view(self):
        state = self.window.settled()
        for layer in [k for k in state["layers"] if k not in ("fill", "side_panels")]:
            self.each(layer, lambda a, b: b["layers"][layer] != a["layers"][layer])
        self.each("next_fill", lambda a, b: b["layers"]["fill"] == (a["layers"]["fill"] + 1) % 8)
        self.each("next_theme", lambda a, b: b["theme"] != a["theme"])
        self.each("side_panels", lambda a, b: b["widgets"]["canvas"][2] > a["widgets"]["canvas"][2])
        self.each("side_panels", lambda a, b: b["widgets"]["canvas"][2] < a["widgets"]["canvas"][2])
        self.each("larger", lambda a, b: b["scale"] == a["scale"] + 0.25)
        self.each("smaller", lambda a, b: b["scale"] == a["scale"] - 0.25)
        self.window.key("ctrl+equal")
        self.each("normal_size", lambda a, b: b["scale"] == 1)
        self.each("zoom_in", lambda a, b: abs(b["camera"]["scale"] / a["camera"]["scale"] - 1.25) < 1e-6)
        self.each("zoom_out", lambda a, b: abs(b["camera"]["scale"] / a["camera"]["scale"] - 0.8) < 1e-6)
        fitted = state["camera"]["scale"]
        self.window.click("tab.Stages")
        self.window.click("stage.optimise")
        self.window.wait(lambda s: s["stage"] == "optimise" and s["activity"] == "idle", "the end of step 6")
        for action in ("worst_aspect", "worst_area", "worst_edge"):
            for _, after in self.press(action, lambda a, b: b["selection"]["kind"] == "triangle"):
                self.assertGreater(after["camera"]["scale"], 2 * fitted)
                # Framed: the triangle is in the middle of the canvas, more or less.
                x, y = self.window.pixel(after["selection"]["x"], after["selection"]["y"])
                left, top, width, height = self.window.canvas()
                self.assertLess(abs(x - left - width / 2), width / 4)
                self.assertLess(abs(y - top - height / 2), height / 4)
                self.window.key("Escape")
                self.window.wait(lambda s: s["selection"]["kind"] == "none", "Esc to drop the selection")
        for _ in self.press("fit", lambda a, b: abs(b["camera"]["scale"] / fitted - 1) < 0.05):
            self.window.key("2", "Escape")
            self.window.wait(lambda s: s["camera"]["scale"] > 2 * fitted, "key 2")

    def test_dialogs_and_files(self):
        for action, dialog in (("open", "open"), ("export_mesh", "export"), ("help", "help")):
            for _ in self.press(action, lambda a, b: b["dialog"] == dialog):
                for key in self.chords("cancel"):
                    self.window.key(key)
                    self.window.wait(lambda s: s["dialog"] == "none", "Esc to close the dialog")
        for action, extension in (("save_picture", ".png"), ("save_figure", ".svg")):
            for _ in self.press(action, lambda a, b: b["message"].startswith("Wrote") and extension in b["message"]):
                path = os.path.join(self.window.folder.name, "blunt_body" + extension)
                self.assertGreater(os.path.getsize(path), 10000)
        # A built-in sample has no file: the key says so and nothing happens.
        before = self.window.settled()
        for key in self.chords("reload"):
            self.window.key(key)
            after = self.window.wait(lambda s: "built in" in s["message"], "the reason")
            self.assertEqual(after["hash"], before["hash"])

    def test_undo_and_redo(self):
        start = self.window.settled()
        self.window.click("tab.Params")
        self.window.click("param.laplacian")
        changed = self.window.wait(lambda s: s["settings"]["laplacian"] == 0 and not s["stale"], "the change")
        self.assertNotEqual(changed["hash"], start["hash"])
        for key in self.chords("redo"):
            for back in self.chords("undo"):
                self.window.key(back)
                self.window.wait(lambda s: s["hash"] == start["hash"], "undo")
                self.window.key(key)
                self.window.wait(lambda s: s["hash"] == changed["hash"], "redo")

    def test_typing_is_not_a_command(self):
        self.window.key("ctrl+o")
        self.window.widget("open.path")
        before = self.window.settled()
        self.window.type("qtbow 24")
        self.window.key("Home", "End")
        self.window.key("Escape")
        after = self.window.wait(lambda s: s["dialog"] == "none", "the dialog to close")
        for what in ("layers", "tick", "camera", "theme"):
            self.assertEqual(after[what], before[what])

    def test_quit(self):
        self.window.key(self.chords("quit")[0])
        self.assertEqual(self.window.process.wait(harness.TIMEOUT), 0)

    def test_documentation_is_the_table(self):
        path = os.path.join(harness.SOURCE, "docs", "keys.md")
        text = self.window.state()["keys_markdown"]
        if os.environ.get("TRISCOPE_APPROVE"):
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        with open(path, encoding="utf-8") as file:
            self.assertEqual(file.read(), text)


class Complete(unittest.TestCase):
    def test_every_action_with_a_key_is_tried(self):
        """The tests above name every action that docs/keys.md has a key for."""
        with open(__file__, encoding="utf-8") as file:
            tests = file.read()
        for other in ("debugger_test.py", "session_window_test.py", "insertion_test.py", "compare_test.py",
                      "sweep_test.py"):
            with open(os.path.join(os.path.dirname(__file__), other), encoding="utf-8") as file:
                tests += file.read()
        import glob
        import re
        table = ""
        for part in glob.glob(os.path.join(harness.SOURCE, "src", "ui", "app", "actions_*.h")):
            with open(part, encoding="utf-8") as file:
                table += file.read()
        self.assertIn("{Action::quit,", table)
        layers = {"boundary", "boundary_points", "quadtree", "constraints", "fronts", "steiner", "degrees", "triangulation",
                  "obtuse", "worst", "decision", "labels", "legend"}  # taken from the state file
        for action in re.findall(r'\{Action::(\w+),', table):
            if action not in layers and action not in ("about", "restore_work"):
                self.assertIn(f'"{action}"', tests)


if __name__ == "__main__":
    unittest.main()
