"""Presses keys and buttons at random, and holds that the program lives, answers and ends when it is asked to.

TRISCOPE_MONKEY_SECONDS   how long on each domain (15)
TRISCOPE_MONKEY_SEED      what it does is drawn from this number (1); a failure names it
TRISCOPE_MONKEY_RUNS      how many runs, each from the next number (1)
TRISCOPE_MONKEY_REPLAY    a JSON file with a list of actions, as a failure prints them: exactly these, once
"""

import json
import os
import random
import subprocess
import sys
import tempfile
import time
import unittest

import harness
import keys_test

SECONDS = float(os.environ.get("TRISCOPE_MONKEY_SECONDS", "15"))
SEED = int(os.environ.get("TRISCOPE_MONKEY_SEED", "1"))
RUNS = int(os.environ.get("TRISCOPE_MONKEY_RUNS", "1"))
REPLAY = os.environ.get("TRISCOPE_MONKEY_REPLAY", "")
TAIL = 40        # actions that a failure prints
PATIENCE = 90.0  # seconds until a program that does not answer counts as hanging

SCREEN = (1280, 800)
SMALL = {"name": "small", "outer": [[0, 0], [4, 0], [4, 4], [0, 4]], "min_edge_length": 0.5}
ASKING = {"name": "asking", "outer": [[0, 0], [6, 0], [6, 4], [0, 4]], "min_edge_length": 0.2,
          "holes": [{"name": "hole", "kind": "circle", "centre": [3, 2], "radius": 0.7}],
          "density": [{"at": [1, 1], "length": 0.25, "name": "here"}, {"loop": "hole", "length": 0.3},
                      {"box": [[4, 3], [5, 3.5]], "rank": 2}]}
CROSSED = {"name": "crossed", "outer": [[0, 0], [4, 4], [4, 0], [0, 4]]}
# What is typed. No text can name anything outside the folder that the program works in.
TEXTS = ["7", "0.3", "-1", "1e9", "0", "nan", "step == 3", "vertex == 12", "aspect > 2", "kind == ", "a", "my name"]
# Without these, most of what is drawn would be steps and layers.
OFTEN = ["ctrl+Home", "ctrl+End", "Home", "F5", "F8", "F10", "shift+F10", "F11", "shift+F11", "Left", "Right",
         "ctrl+z", "ctrl+y", "space", "Escape", "Delete", "a", "d", "y", "m", "f", "c"]


class Monkey:
    """Draws actions. An action is a list that can be printed and done again."""

    def __init__(self, window, files, draw):
        self.window, self.files, self.draw = window, files, draw

    def somewhere(self, state):
        left, top, width, height = state["widgets"].get("canvas", [0, 0, *SCREEN, True])[:4]
        if self.draw.random() < 0.8:
            return [int(left + self.draw.random() * width), int(top + self.draw.random() * height)]
        return [self.draw.randrange(SCREEN[0]), self.draw.randrange(SCREEN[1])]

    def on_a_widget(self, state):
        # The quit button ends the program; ".." leads out of the folder.
        names = sorted(n for n in state["widgets"] if n not in ("file...", "menu.quit", "canvas", "canvas.A"))
        if not names:
            return self.somewhere(state)
        left, top, width, height, _ = state["widgets"][self.draw.choice(names)]
        return [int(left + self.draw.random() * width), int(top + self.draw.random() * height)]

    def key(self, state):
        if self.draw.random() < 0.5:
            return ["key", self.draw.choice(OFTEN)]
        action = self.draw.choice(sorted(a for a in state["keys"] if state["keys"][a] and a != "quit"))
        return ["key", keys_test.chord(self.draw.choice(state["keys"][action]))]

    def in_dialog(self, state):
        """A path out of the folder cannot come about: a field is filled as a whole."""
        path = self.draw.choice(self.files if state["dialog"] == "open" else
                                ["a.msh", "b.png", "c.svg", "d.session", "e.json", "f.csv", "g.vtu", "h"])
        return self.draw.choice([
            ["key", "Escape"], ["key", "Return"], ["key", "Tab"], ["press", *self.on_a_widget(state), 1, None],
            ["fill", path, "Return"], ["fill", path, "Escape"], ["resize", *self.size()]])

    def size(self):
        return [self.draw.choice([200, 480, 640, 900, 1280]), self.draw.choice([150, 400, 560, 800])]

    def next(self, state):
        if state["dialog"] in ("open", "save", "export"):
            return self.in_dialog(state)
        modifier = self.draw.choice([None, None, None, "alt", "alt", "ctrl", "shift"])
        kind = self.draw.choices(
            ["key", "keys", "press", "canvas", "drag", "wheel", "type", "resize", "wait", "open", "menu", "twice",
             "held"],
            [30, 10, 22, 14, 8, 4, 4, 2, 4, 3, 3, 2, 4])[0]
        if kind == "key":
            return self.key(state)
        if kind == "keys":  # faster than the window draws
            return ["keys", [self.key(state)[1] for _ in range(self.draw.randrange(2, 6))]]
        if kind == "press":
            return ["press", *self.on_a_widget(state), 1, None]
        if kind == "canvas":
            return ["press", *self.somewhere(state), 1, modifier]
        if kind == "drag":
            start = self.draw.choice([self.somewhere, self.on_a_widget])(state)
            return ["drag", *start, *self.somewhere(state), self.draw.choice([None, "shift", "alt"])]
        if kind == "wheel":
            return ["wheel", *self.somewhere(state), self.draw.choice([4, 5]), self.draw.randrange(1, 12)]
        if kind == "type":
            return ["type", self.draw.choice(TEXTS), self.draw.choice(["Return", "Escape", "Tab"])]
        if kind == "resize":
            return ["resize", *self.size()]
        if kind == "open":
            return ["open", self.draw.choice(self.files)]
        if kind == "menu":
            return ["press", *self.somewhere(state), 3, None]
        if kind == "held":  # keys while the button is down
            keys = [self.key(state)[1] for _ in range(self.draw.randrange(1, 4))]
            return ["held", *self.draw.choice([self.somewhere, self.on_a_widget])(state), keys, *self.somewhere(state)]
        if kind == "twice":
            return ["twice", *self.somewhere(state)]
        return ["wait", round(self.draw.random(), 2)]

    def do(self, action):
        kind, *rest = action
        tool = self.window.xdotool
        if kind == "key":
            tool("key", "--clearmodifiers", rest[0])
        elif kind == "keys":
            tool("key", "--clearmodifiers", "--delay", "1", *rest[0])
        elif kind == "press":
            x, y, button, modifier = rest
            held, let = (["keydown", modifier], ["keyup", modifier]) if modifier else ([], [])
            tool("mousemove", str(x), str(y), "sleep", "0.05", *held, "mousedown", str(button), "sleep", "0.08",
                 "mouseup", str(button), "sleep", "0.05", *let)
        elif kind == "drag":
            x0, y0, x1, y1, modifier = rest
            held, let = (["keydown", modifier], ["keyup", modifier]) if modifier else ([], [])
            steps = []
            for k in range(1, 6):
                steps += ["mousemove", str(x0 + (x1 - x0) * k // 5), str(y0 + (y1 - y0) * k // 5), "sleep", "0.03"]
            tool("mousemove", str(x0), str(y0), "sleep", "0.05", *held, "mousedown", "1", "sleep", "0.06", *steps,
                 "mouseup", "1", *let)
        elif kind == "held":
            x0, y0, keys, x1, y1 = rest
            tool("mousemove", str(x0), str(y0), "sleep", "0.05", "mousedown", "1", "sleep", "0.05", "mousemove",
                 str((x0 + x1) // 2), str((y0 + y1) // 2), "sleep", "0.05")
            for key in keys:
                tool("key", key)
            tool("sleep", "0.05", "mousemove", str(x1), str(y1), "sleep", "0.05", "mouseup", "1")
        elif kind == "wheel":
            tool("mousemove", str(rest[0]), str(rest[1]), "click", "--repeat", str(rest[3]), "--delay", "5",
                 str(rest[2]))
        elif kind == "type":
            tool("type", "--delay", "5", "--", rest[0])
            tool("key", rest[1])
        elif kind == "fill":
            tool("key", "ctrl+a")
            tool("type", "--delay", "5", "--", rest[0])
            tool("key", rest[1])
        elif kind == "open":
            tool("key", "Escape", "ctrl+o", "sleep", "0.3", "key", "ctrl+a")
            tool("type", "--delay", "5", "--", rest[0])
            tool("key", "Return")
        elif kind == "twice":
            tool("mousemove", str(rest[0]), str(rest[1]), "click", "--repeat", "2", "--delay", "60", "1")
        elif kind == "resize":
            tool("windowsize", self.window.id, str(rest[0]), str(rest[1]))
        elif kind == "wait":
            time.sleep(rest[0])


class MonkeyTest(unittest.TestCase):
    def setUp(self):
        if not harness.PROGRAM:
            self.skipTest("TRISCOPE_PROGRAM is not set")
        root = tempfile.TemporaryDirectory(prefix="triscope-monkey-")
        self.addCleanup(root.cleanup)
        self.home = os.path.join(root.name, "the folder of nobody")
        self.work = os.path.join(self.home, "what it may write to")
        os.makedirs(self.work)
        self.display = harness.Display(*SCREEN)
        self.addCleanup(self.display.close)

    def write(self, name, content):
        with open(os.path.join(self.work, name), "w", encoding="utf-8") as file:
            json.dump(content, file)
        return name

    def start(self, *arguments):
        # The drivers of Mesa are unloaded before the leaks are looked for: they cannot be told from real ones.
        sanitizer = ":".join(o for o in (os.environ.get("ASAN_OPTIONS"), "detect_leaks=0") if o)
        window = harness.Window(
            self.display, "--preferences", os.path.join(self.home, "preferences.json"), *arguments, cwd=self.work,
            environment={"HOME": self.home, "XDG_CONFIG_HOME": self.home, "ASAN_OPTIONS": sanitizer})
        self.addCleanup(window.close)
        return window

    def answers(self, window):
        """A key that means nothing is heard, and the state file says so."""
        before = window.state()["keys_pressed"]
        window.xdotool("key", "Scroll_Lock")
        window.wait(lambda s: s["keys_pressed"] > before, "a key to be heard", timeout=PATIENCE)

    def was_quit(self, window):
        """By a click on Quit in a menu."""
        try:
            return window.process.wait(5) == 0
        except subprocess.TimeoutExpired:
            return False

    def let_loose(self, domain, seed, seconds):
        files = [self.write("small.json", SMALL), self.write("asking.json", ASKING), self.write("bad.json", CROSSED),
                 "missing.json", "d.session"]
        window = self.start(*domain)
        monkey = Monkey(window, files, random.Random(seed))
        done = []
        replayed = None
        if REPLAY:
            with open(REPLAY, encoding="utf-8") as file:
                replayed = iter(json.load(file))
        end = time.monotonic() + seconds
        try:
            while replayed is not None or time.monotonic() < end:
                action = next(replayed, None) if replayed is not None else monkey.next(window.state())
                if action is None:
                    break
                done.append(action)
                try:
                    monkey.do(action)
                    self.assertIsNone(window.process.poll(), "the program ended")
                    if len(done) % 10 == 0:
                        self.answers(window)
                except (AssertionError, subprocess.CalledProcessError):
                    if not self.was_quit(window):
                        raise
                    window.close()
                    window = monkey.window = self.start(*domain)
            self.answers(window)
            window.xdotool("key", "--clearmodifiers", "Escape", "Escape", "Escape", "Escape", "ctrl+q")
            self.assertEqual(window.process.wait(PATIENCE), 0)
        except Exception as failure:
            print(f"\nseed {seed}, {' '.join(domain) or 'the first sample'}, action {len(done)}: {failure}\n"
                  f"the program's exit status: {window.process.poll()}\nthe last actions:\n[" +
                  ",\n ".join(json.dumps(a) for a in done[-TAIL:]) + "]", file=sys.stderr)
            raise
        window.close()

    def test_small(self):
        for seed in range(SEED, SEED + RUNS):
            self.let_loose([self.write("asking.json", ASKING)], seed, SECONDS)

    def test_larger(self):
        domain = os.path.join(harness.SOURCE, "assets", "domains", "three_element_airfoil.json")
        for seed in range(SEED, SEED + RUNS):
            self.let_loose([domain], seed, SECONDS)


if __name__ == "__main__":
    unittest.main()
