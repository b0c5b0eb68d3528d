"""Opening by name, by dialog and by drop; what happens with a file that is wrong; exporting."""

import json
import os
import signal
import unittest

import harness
import xdnd

SQUARE = {"name": "square", "outer": [[0, 0], [4, 0], [4, 4], [0, 4]], "min_edge_length": 0.5}
CROSSED = {"name": "crossed", "outer": [[0, 0], [4, 4], [4, 0], [0, 4]]}


class Files(harness.WindowTest):
    def drop(self, path):
        left, top, width, height = self.window.canvas()
        xdnd.drop(self.display.name, int(self.window.id), path, left + width / 2, top + height / 2)

    def test_drop_opens_a_file(self):
        self.drop(self.write("a square.json", SQUARE))
        state = self.window.wait(lambda s: s["domain"] == "square" and s["activity"] == "idle", "the square")
        self.assertEqual(state["stage"], "finished")
        # The whole of it is in view.
        left, top, width, height = self.window.canvas()
        for corner in ((0, 0), (4, 4)):
            x, y = self.window.pixel(*corner)
            self.assertTrue(left < x < left + width and top < y < top + height)
        # It can be read again, now that there is a file.
        self.write("a square.json", dict(SQUARE, min_edge_length=0.25))
        self.window.key("ctrl+r")
        self.window.wait(lambda s: s["min_edge"] == 0.25 and s["activity"] == "idle", "the file to be read again")

    def test_wrong_file_says_where_and_keeps_the_mesh(self):
        before = self.window.settled()
        for name, content, words in (("crossed.json", CROSSED, ["crossed.json", "outer"]),
                                     ("broken.json", '{"outer": [[0,0],', ["broken.json"]),
                                     ("short.json", {"outer": [[0, 0], [1, 0]]}, ["short.json", "at least 3"])):
            self.drop(self.write(name, content))
            state = self.window.wait(lambda s: s["dialog"] == "error" and name in s["error"], "the error")
            for word in words:
                self.assertIn(word, state["error"])
            self.assertEqual(state["hash"], before["hash"])
            self.window.click("dialog.close")
            self.window.wait(lambda s: s["dialog"] == "none", "the error to close")
        # The window goes on as before.
        self.window.key("Left")
        self.window.wait(lambda s: s["tick"] == before["tick"] - 1, "a step back")

    def test_wrong_file_by_dialog_says_where(self):
        path = self.write("crossed.json", CROSSED)
        for how in ("Return", "click", "double click"):
            self.window.key("ctrl+o")
            self.window.widget("open.path")
            if how == "double click":
                self.double_click(path)
            else:
                self.window.key("ctrl+a")
                self.window.type(path)
                self.window.key("Return") if how == "Return" else self.window.click("open.ok")
            state = self.window.wait(lambda s: s["dialog"] == "error", f"the error after {how}")
            self.assertIn("crossed.json", state["error"])
            self.window.click("dialog.close")
            self.window.wait(lambda s: s["dialog"] == "none", "the error to close")

    def double_click(self, path):
        x, y = self.window.widget("file." + os.path.basename(path))
        self.window.move(x, y)
        self.window.xdotool("click", "--repeat", "2", "--delay", "120", "1")

    def test_quick_keys_are_not_lost(self):
        """Keys faster than the frames: select all, type a path, Return, with nothing between them."""
        path = os.path.join(self.window.folder.name, "quick.off")
        for key in ("ctrl+e", "ctrl+o"):
            self.window.key(key)
            self.window.wait(lambda s: s["dialog"] != "none", "the dialog")
            self.window.xdotool("key", "--delay", "0", "Escape")
            self.window.wait(lambda s: s["dialog"] == "none", "the dialog to close")
        self.window.xdotool("key", "--delay", "0", "ctrl+e", "ctrl+a", "BackSpace")
        self.window.xdotool("type", "--delay", "1", path + "x")
        self.window.xdotool("key", "--delay", "0", "BackSpace", "Return")
        self.window.wait(lambda s: s["message"] == f"Wrote {path}.", "the file to be written")
        self.assertGreater(os.path.getsize(path), 1000)

    def test_pictures_take_free_names(self):
        paths = []
        for name in ("blunt_body.png", "blunt_body-2.png", "blunt_body-3.png"):
            paths.append(os.path.join(self.window.folder.name, name))
            self.window.key("F12")
            self.window.wait(lambda s: s["message"] == f"Wrote {paths[-1]}.", name)
        self.assertEqual([p for p in paths if not os.path.exists(p)], [])

    def test_a_message_is_gone_after_the_next_action(self):
        self.window.key("shift+j")
        self.window.wait(lambda s: "no mark before" in s["message"], "the reason")
        self.window.key("Home")
        self.window.wait(lambda s: s["message"] == "", "the message to go")
        self.window.key("m")
        self.window.wait(lambda s: "Bookmark at decision" in s["message"], "what M did")

    def test_a_change_with_no_domain_open_is_for_the_next_one(self):
        window = harness.Window(self.display, self.write("broken.json", "{"))
        self.addCleanup(window.close)
        before = window.wait(lambda s: s["dialog"] == "error", "the error")["settings"]["omega"]
        window.click("dialog.close")
        window.click("tab.Params")
        x, y, width, height = window.widget_box("param.omega")
        place = window.widget("param.min_edge_length")
        self.assertFalse(window.state()["widgets"]["param.min_edge_length"][4])
        window.move(place[0] + 1, place[1])
        window.move(*place)
        window.wait(lambda s: "there is none yet" in s["tooltip"], "the reason")
        window.drag(x + 0.3 * width, y + height / 2, x + 0.9 * width, y + height / 2)
        omega = window.wait(lambda s: s["settings"]["omega"] != before and s["undo"] == 1, "the change")["settings"]["omega"]
        window.key("ctrl+z")
        window.wait(lambda s: s["settings"]["omega"] == before and s["undo"] == 0, "it to be taken back")
        window.key("ctrl+y")
        window.wait(lambda s: s["settings"]["omega"] == omega, "it to be there again")
        window.open_by_dialog(self.write("square.json", SQUARE))
        state = window.wait(lambda s: s.get("domain") == "square" and s["activity"] == "idle", "the square")
        self.assertEqual((state["settings"]["omega"], state["undo"]), (omega, 0))
        self.assertTrue(window.enabled("param.min_edge_length"))

    def test_dialog_opens_a_path_and_a_sample(self):
        path = self.write("square.json", SQUARE)
        self.window.key("ctrl+o")
        self.window.widget("open.path")
        self.window.type(path)
        self.window.click("open.ok")
        self.window.wait(lambda s: s["domain"] == "square", "the square")
        self.window.key("ctrl+o")
        self.window.click("file.square.json")
        self.window.click("open.ok")
        self.window.wait(lambda s: s["dialog"] == "none", "the dialog to close")
        self.window.key("ctrl+o")
        self.window.click("sample.blunt_body")
        self.window.wait(lambda s: s["domain"] != "square" and s["activity"] == "idle", "the sample")

    def test_export_by_dialog(self):
        for extension in (".msh", ".vtu", ".svg", ".png"):
            self.window.key("ctrl+e")
            self.window.click("export" + extension)
            self.window.click("export.ok")
            state = self.window.wait(lambda s: s["message"].startswith("Wrote") and extension in s["message"], extension)
            path = os.path.join(self.window.folder.name, "blunt_body" + extension)
            self.assertIn(path, state["message"])
            self.assertGreater(os.path.getsize(path), 10000)

    def test_export_where_nothing_can_be_written(self):
        self.window.key("ctrl+e")
        self.window.widget("export.path")
        x, y = self.window.widget("export.path")
        self.window.press(x, y)
        self.window.key("ctrl+a")
        self.window.type("/nowhere/at/all.msh")
        self.window.click("export.ok")
        state = self.window.wait(lambda s: s["dialog"] == "error", "the error")
        self.assertIn("/nowhere/at/all.msh", state["error"])

    def test_the_domain_that_is_open_is_not_overwritten(self):
        path = self.write("square.msh", SQUARE)  # a domain that has the name its mesh would get
        self.drop(path)
        self.window.wait(lambda s: s["domain"] == "square" and s["activity"] == "idle", "the square")
        for key, name in (("ctrl+e", "export"), ("ctrl+shift+s", "save")):
            self.window.key(key)
            self.window.widget(f"{name}.path")
            self.window.key("ctrl+a")
            self.window.type(path)
            self.window.click(f"{name}.ok")
            state = self.window.wait(lambda s: s["dialog"] == "error", "the refusal")
            self.assertIn("would overwrite the domain that is open", state["error"])
            self.window.click("dialog.close")
            self.window.wait(lambda s: s["dialog"] == "none", "the refusal to close")
            with open(path, encoding="utf-8") as file:
                self.assertEqual(json.load(file), SQUARE)

    def test_signals_end_the_window(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            window = harness.Window(self.display)
            self.addCleanup(window.close)
            window.settled()
            window.key("Left")  # something to write to the state file
            window.process.send_signal(number)
            self.assertEqual(window.process.wait(timeout=30), 128 + number)
            self.assertEqual([name for name in os.listdir(window.folder.name) if name.endswith(".tmp")], [])


class Arguments(unittest.TestCase):
    def test_a_file_that_is_not_there(self):
        display = harness.Display()
        self.addCleanup(display.close)
        window = harness.Window(display, "/nowhere/at/all.json")
        self.addCleanup(window.close)
        state = window.wait(lambda s: s["dialog"] == "error", "the error")
        self.assertIn("/nowhere/at/all.json", state["error"])

    def test_without_a_display(self):
        import subprocess
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        process = subprocess.run([harness.PROGRAM], env=environment, capture_output=True, text=True, timeout=30)
        self.assertEqual(process.returncode, 69)
        self.assertIn("display", process.stderr)


if __name__ == "__main__":
    unittest.main()
