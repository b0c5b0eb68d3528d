"""Sessions in the window: saved, opened, kept when the program is killed; undo; density constraints by mouse."""

import json
import os
import subprocess
import time
import unittest

import harness
import xdnd
from keys_test import chord


class Sessions(harness.WindowTest):
    def keys(self, action, window=None):
        return [chord(k) for k in (window or self.window).state()["keys"][action]]

    def another(self, *arguments, environment=None):
        """A second run of the program, on the same screen."""
        window = harness.Window(self.display, *arguments, environment=environment)
        self.addCleanup(window.close)
        window.settled()
        return window

    def title(self, window=None):
        window = window or self.window
        return window.xdotool("getwindowname", window.id).strip()

    def write_notes(self, text):
        self.window.click("tab.Notes")
        self.window.click("notes.text")
        self.window.type(text)
        self.window.wait(lambda s: s["document"]["notes"] == text, "the notes")
        left, top, width, height = self.window.canvas()
        self.window.press(left + 3, top + 3)  # out of the text

    def work(self):
        """Something of everything that a session holds."""
        window = self.window
        window.click("tab.Params")
        x, y, width, height = window.widget_box("param.omega")
        window.drag(x + 0.3 * width, y + height / 2, x + 0.7 * width, y + height / 2)
        window.settled()
        window.key("ctrl+b")
        window.click("break.condition")
        window.type("aspect > 4")
        window.key("Return", "ctrl+b")
        window.key("Prior", "Left", "m")
        window.wait(lambda s: len(s["debug"]["bookmarks"]) == 1, "the bookmark")
        window.click("tab.Notes")
        window.click("notes.bookmark.0")
        window.key("ctrl+a")
        window.type("it turns here")
        self.write_notes("look at the nose")
        window.key("equal", "equal")
        return window.settled()

    def save_as(self, path):
        self.window.widget("save.path")
        self.window.key("ctrl+a")
        self.window.type(path)
        self.window.click("save.ok")
        self.window.wait(lambda s: s["message"] == f"Saved {path}." and not s["document"]["saving"], "the file")

    def same(self, now, then):
        """Everything that a session holds."""
        for key in ("domain", "hash", "tick", "settings"):
            self.assertEqual(now[key], then[key], key)
        for key in ("x", "y", "scale"):
            self.assertAlmostEqual(now["camera"][key], then["camera"][key], places=9)
        self.assertEqual(now["debug"]["breakpoints"], then["debug"]["breakpoints"])
        self.assertEqual(now["debug"]["bookmarks"], then["debug"]["bookmarks"])
        self.assertEqual(now["document"]["bookmark_names"], then["document"]["bookmark_names"])
        self.assertEqual(now["document"]["notes"], then["document"]["notes"])
        self.assertEqual(now["density"]["requests"], then["density"]["requests"])

    def test_saved_and_opened_again(self):
        self.assertEqual(self.title(), "blunt body – Triscope")
        before = self.work()
        self.assertTrue(before["document"]["unsaved"])
        self.assertEqual(self.title(), "*blunt body – Triscope")
        path = os.path.join(self.window.folder.name, "one.session")
        for key in self.keys("save_session"):
            self.window.key(key)
            self.save_as(path)
        state = self.window.wait(lambda s: not s["document"]["unsaved"], "it to be saved")
        self.assertEqual(state["document"]["path"], path)
        self.assertEqual(self.title(), "one.session – Triscope")
        # The same without the window.
        replayed = subprocess.run([harness.PROGRAM, "replay", path], capture_output=True, text=True)
        self.assertEqual(replayed.returncode, 0, replayed.stderr)
        self.assertRegex(replayed.stdout, r"[1-9]\d* stage ends, all as recorded")
        # As an argument of another run.
        other = self.another(path)
        state = other.wait(lambda s: s["document"]["path"] == path and s["tick"] == before["tick"], "the session")
        self.same(state, before)
        self.assertFalse(state["document"]["unsaved"])
        self.assertEqual(state["debug"]["ticks"], before["debug"]["ticks"])
        other.close()
        # Dropped over something else, under a name that says nothing.
        unnamed = os.path.join(self.window.folder.name, "something.json")
        os.rename(path, unnamed)
        self.window.key("ctrl+o")
        self.window.click("sample.square")
        self.window.wait(lambda s: s["domain"] == "square" and s["document"]["path"] == "", "the sample")
        left, top, width, height = self.window.canvas()
        xdnd.drop(self.display.name, int(self.window.id), unnamed, left + width / 2, top + height / 2)
        self.window.wait(lambda s: s["document"]["path"] == unnamed and s["tick"] == before["tick"], "the session")
        self.same(self.window.settled(), before)
        # Saved again without a question; another name asks.
        self.window.key("ctrl+z")  # nothing that was done before it was opened
        self.window.wait(lambda s: s["message"] == "Nothing has been changed.", "nothing to undo")
        self.window.key("m", "ctrl+s")
        self.window.wait(lambda s: s["message"] == f"Saved {unnamed}.", "the file")
        with open(unnamed, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["bookmarks"], [])
        for key in self.keys("save_session_as"):
            self.window.key(key)
            self.save_as(path)

    def test_a_wrong_session_says_what_is_wrong(self):
        before = self.window.settled()
        path = os.path.join(self.window.folder.name, "wrong.session")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"format": "triscope session", "version": 1, "domain": {"text": "{}"},
                       "breakpoints": [{"condition": "aspect >> 4"}]}, file)
        left, top, width, height = self.window.canvas()
        xdnd.drop(self.display.name, int(self.window.id), path, left + width / 2, top + height / 2)
        state = self.window.wait(lambda s: s["dialog"] == "error", "the error")
        self.assertIn("wrong.session", state["error"])
        self.assertIn("breakpoints[0]", state["error"])
        self.assertEqual(state["hash"], before["hash"])

    def kept_files(self, environment):
        folder = os.path.join(environment["XDG_STATE_HOME"], "triscope", "autosave")
        names = os.listdir(folder) if os.path.isdir(folder) else []
        return [os.path.join(folder, name) for name in names if name.endswith(".session")]

    def wait_for_files(self, environment, condition, what):
        end = time.monotonic() + harness.TIMEOUT
        while not condition(self.kept_files(environment)):
            self.assertLess(time.monotonic(), end, what)
            time.sleep(0.1)
        return self.kept_files(environment)

    def test_killed(self):
        environment = {"XDG_STATE_HOME": self.window.environment["XDG_STATE_HOME"]}
        # Nothing is written while nothing has changed.
        time.sleep(4)
        self.assertEqual(self.kept_files(environment), [])
        before = self.work()
        tick = before["tick"]

        def holds(files):
            if not files:
                return False
            with open(files[0], encoding="utf-8") as file:
                kept = json.load(file)
            return kept["tick"] == tick and kept["notes"] == before["document"]["notes"] and "view" in kept

        path = self.wait_for_files(environment, holds, "the work to be kept")[0]
        written = os.stat(path).st_mtime_ns
        time.sleep(4)
        self.assertEqual(os.stat(path).st_mtime_ns, written, "nothing has changed since")
        # Another run does not take what this one works on.
        other = self.another(environment=environment)
        self.assertFalse(other.state()["document"]["offering"])
        other.key("ctrl+q")
        other.process.wait()
        self.window.process.kill()
        self.window.process.wait()
        # It is offered, and may be put off.
        for answer in ("kept.later", "kept.restore"):
            other = self.another(environment=environment)
            state = other.wait(lambda s: s["document"]["offering"] and "kept.restore" in s["widgets"], "the offer")
            self.assertEqual(state["document"]["kept"], 1)
            other.click(answer)
            other.wait(lambda s: not s["document"]["offering"], "the offer to go")
            if answer == "kept.later":
                other.key("ctrl+q")
                other.process.wait()
        state = other.wait(lambda s: s["tick"] == tick and s["document"]["unsaved"], "the work")
        self.same(other.settled(), before)
        self.assertEqual(self.title(other), "*blunt body – Triscope")
        self.assertEqual(state["document"]["kept"], 0)
        # Killed once more right away it is still there; saved, it is gone.
        other.process.kill()
        other.process.wait()
        other = self.another(environment=environment)
        other.wait(lambda s: s["document"]["offering"] and "kept.discard" in s["widgets"], "the offer")
        other.click("kept.discard")
        other.wait(lambda s: s["document"]["kept"] == 0, "nothing to be kept")
        self.assertEqual(self.kept_files(environment), [])

    def test_quitting_and_opening_over_unsaved_work(self):
        environment = {"XDG_STATE_HOME": self.window.environment["XDG_STATE_HOME"]}
        before = self.work()
        self.window.key("ctrl+o")
        self.window.click("sample.square")
        state = self.window.wait(lambda s: s["domain"] == "square" and s["document"]["kept"] == 1, "the sample")
        self.assertIn("kept", state["message"])
        self.assertFalse(state["document"]["unsaved"])
        self.assertEqual(state["document"]["notes"], "")
        self.window.settled()
        self.window.click("menu.File")
        self.window.click("menu.restore_work")
        self.window.wait(lambda s: s["domain"] == before["domain"] and s["tick"] == before["tick"], "the work")
        self.same(self.window.settled(), before)
        self.window.key("ctrl+q")
        self.window.process.wait()
        self.assertEqual(len(self.kept_files(environment)), 1)
        other = self.another(environment=environment)
        other.wait(lambda s: s["document"]["offering"], "the offer")

    # Density constraints.

    def place(self, x, y):
        """At a place of the domain, by Alt+click."""
        count = len(self.window.state()["density"]["requests"])
        self.window.press(*self.window.pixel(x, y), modifier="alt")
        self.window.wait(lambda s: len(s["density"]["requests"]) == count + 1, "the constraint")
        return self.window.settled()

    def test_density_constraints_by_mouse(self):
        window = self.window
        plain = os.path.join(window.folder.name, "plain.json")
        with open(plain, "w", encoding="utf-8") as file:
            json.dump({"outer": [[0, 0], [40, 0], [40, 40], [0, 40]], "min_edge_length": 0.5}, file)
        left, top, width, height = window.canvas()
        xdnd.drop(self.display.name, int(window.id), plain, left + width / 2, top + height / 2)
        window.wait(lambda s: s["domain"] == "plain", "the domain")
        before = window.settled()
        self.assertEqual(before["density"]["requests"], [])
        # Placed.
        for key in self.keys("place_density"):
            window.key(key)
            window.wait(lambda s: s["density"]["placing"], "the mode")
        window.press(left + 0.4 * width, top + 0.5 * height)
        window.wait(lambda s: len(s["density"]["requests"]) == 1, "the constraint")
        placed = window.settled()
        request = placed["density"]["requests"][0]
        x, y = window.pixel(request["x"], request["y"])
        self.assertAlmostEqual(x, left + 0.4 * width, delta=1.5)
        self.assertAlmostEqual(y, top + 0.5 * height, delta=1.5)
        self.assertGreater(placed["figures"]["triangles"], before["figures"]["triangles"])
        self.assertTrue(placed["document"]["unsaved"])
        # Moved; the mesh follows, and all of it is one step of undo.
        window.drag(x, y, x + 90, y + 40)
        window.wait(lambda s: s["density"]["requests"][0]["x"] > request["x"], "the constraint to move")
        moved = window.settled()
        self.assertNotEqual(moved["hash"], placed["hash"])
        self.assertEqual(moved["undo"], placed["undo"] + 1)
        x, y = window.pixel(moved["density"]["requests"][0]["x"], moved["density"]["requests"][0]["y"])
        self.assertAlmostEqual(y, top + 0.5 * height + 40, delta=2)
        # By rank instead of by length, then a finer one.
        window.click("request.by_rank")
        window.wait(lambda s: s["density"]["requests"][0]["rank"] > 0, "a rank")
        rank = window.settled()["density"]["requests"][0]["rank"]
        box = window.widget_box("request.value")
        middle = (box[0] + box[2] / 2, box[1] + box[3] / 2)
        window.press(*middle, modifier="ctrl")
        window.key("ctrl+a")
        window.type(str(rank + 2))
        window.key("Return")
        window.wait(lambda s: s["density"]["requests"][0]["rank"] == rank + 2, "the rank")
        ranked = window.settled()
        # Deleted, and everything back and forth again.
        for key in self.keys("delete_density"):
            window.key(key)
            window.wait(lambda s: s["density"]["requests"] == [], "it to be deleted")
            self.assertEqual(window.settled()["hash"], before["hash"])
        window.key("ctrl+z")
        window.wait(lambda s: s["hash"] == ranked["hash"], "undo of the deletion")
        window.key("ctrl+z", "ctrl+z")
        window.wait(lambda s: s["hash"] == moved["hash"], "undo of rank and change")
        window.key("ctrl+z")
        window.wait(lambda s: s["hash"] == placed["hash"], "undo of the move")
        window.key("ctrl+z")
        window.wait(lambda s: s["hash"] == before["hash"] and not s["document"]["unsaved"], "undo of the first")
        window.key("ctrl+shift+z", "ctrl+y")
        window.wait(lambda s: s["hash"] == moved["hash"], "redo twice")
        window.key("Escape", "Escape")
        window.wait(lambda s: not s["density"]["placing"] and s["density"]["selected"] == -1, "the mode to end")
        # Part of the session, and of the domain file.
        path = os.path.join(window.folder.name, "dense.session")
        window.key("ctrl+s")
        self.save_as(path)
        window.key("ctrl+e")
        window.click("export.json")
        window.click("export.ok")
        state = window.wait(lambda s: s["message"].startswith("Wrote") and ".json" in s["message"], "the domain file")
        other = self.another(path)
        other.wait(lambda s: s["hash"] == moved["hash"], "the session")
        self.assertEqual(other.state()["density"]["requests"], moved["density"]["requests"])
        other.close()
        other = self.another(state["message"][len("Wrote "):-1])
        other.wait(lambda s: s["hash"] == moved["hash"], "the domain file")

    def test_a_constraint_on_a_loop_is_selected_but_not_moved(self):
        path = os.path.join(self.window.folder.name, "loop.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"outer": [[0, 0], [40, 0], [40, 40], [0, 40]], "min_edge_length": 0.5,
                       "holes": [{"name": "hole", "kind": "polygon", "points": [[10, 10], [20, 10], [20, 20], [10, 20]]}],
                       "density": [{"loop": "hole", "length": 1}]}, file)
        window = self.another(path)
        window.key("e")
        before = window.wait(lambda s: s["density"]["placing"], "the handles")
        x, y = window.pixel(10, 15)  # its first side, turned round: holes run clockwise
        window.press(x, y)
        window.wait(lambda s: s["density"]["selected"] == 0 and "request.value" in s["widgets"], "it to be selected")
        window.drag(x, y, x + 60, y + 30)
        after = window.wait(lambda s: "cannot be moved" in s["message"], "why it stays")
        self.assertEqual(after["density"]["requests"], before["density"]["requests"])
        self.assertEqual(after["hash"], before["hash"])
        window.key("Delete")
        window.wait(lambda s: s["density"]["requests"] == [], "it to be deleted")

    def test_alt_click_and_escape_while_dragging(self):
        before = self.window.settled()
        left, top, width, height = self.window.canvas()
        self.window.press(left + 0.2 * width, top + 0.3 * height, modifier="alt")
        self.window.wait(lambda s: len(s["density"]["requests"]) == len(before["density"]["requests"]) + 1, "a constraint")
        placed = self.window.settled()
        request = placed["density"]["requests"][-1]
        x, y = self.window.pixel(request["x"], request["y"])
        self.window.hold(x, y)
        self.window.move(x + 30, y + 5)
        self.window.move(x + 40, y + 10)
        self.window.wait(lambda s: s["density"]["requests"][-1]["x"] > request["x"], "the drag")
        self.window.xdotool("key", "Escape")
        self.window.wait(lambda s: s["density"]["requests"][-1] == request and s["hash"] == placed["hash"], "it to go back")
        self.window.release()
        self.window.key("ctrl+z")
        self.window.wait(lambda s: s["hash"] == before["hash"], "undo of the placing")


if __name__ == "__main__":
    unittest.main()
