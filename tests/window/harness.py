"""Drives the real window under Xvfb with real keys and mouse, and reads back its state file and its pixels."""

import json
import os
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ.get("TRISCOPE_PROGRAM", "")
SOURCE = os.environ.get("TRISCOPE_SOURCE_DIR", "")
TIMEOUT = 30.0  # seconds until something that should happen counts as not happening


class Display:
    """A screen of its own; Xvfb chooses a free number and says which."""

    def __init__(self, width=1280, height=800):
        read, write = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp"],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            self.name = ":" + pipe.readline().strip()

    def close(self):
        self.process.terminate()
        self.process.wait()


class Image:
    """Pixels of the screen, as import(1) of ImageMagick sees them."""

    def __init__(self, display):
        ppm = subprocess.run(["/usr/bin/import", "-window", "root", "-depth", "8", "ppm:-"], check=True,
                             capture_output=True, env=dict(os.environ, DISPLAY=display)).stdout
        magic, width, height, depth = ppm.split(maxsplit=4)[:4]
        assert magic == b"P6" and depth == b"255"
        self.width, self.height = int(width), int(height)
        self.data = ppm[-3 * self.width * self.height:]

    def at(self, x, y):
        start = 3 * (int(y) * self.width + int(x))
        return tuple(self.data[start:start + 3])

    def colors(self, x, y, width, height):
        """How often each colour occurs in a rectangle."""
        counts = {}
        for row in range(max(0, int(y)), min(self.height, int(y + height))):
            start = 3 * (row * self.width + max(0, int(x)))
            line = self.data[start:start + 3 * int(width)]
            for i in range(0, len(line) - 2, 3):
                color = tuple(line[i:i + 3])
                counts[color] = counts.get(color, 0) + 1
        return counts

    def near(self, color, x, y, radius, tolerance=40):
        """How many pixels within `radius` are about this colour."""
        found = 0
        for (r, g, b), n in self.colors(x - radius, y - radius, 2 * radius + 1, 2 * radius + 1).items():
            if abs(r - color[0]) + abs(g - color[1]) + abs(b - color[2]) <= tolerance:
                found += n
        return found


class Window:
    """The running program."""

    def __init__(self, display, *arguments, environment=None, cwd=None):
        self.display = display
        self.folder = tempfile.TemporaryDirectory()
        self.state_path = os.path.join(self.folder.name, "state.json")
        # Work that is kept automatically goes to a folder of its own, not to the user's.
        kept = {"XDG_STATE_HOME": os.path.join(self.folder.name, "state")}
        self.environment = {**os.environ, "DISPLAY": display.name, **kept, **(environment or {})}
        self.started = time.monotonic()
        self.process = subprocess.Popen(
            [PROGRAM, "--state-file", self.state_path,
             *([] if "--preferences" in arguments else ["--preferences", "none"]), *arguments], env=self.environment,
            cwd=cwd or self.folder.name)
        self.wait(lambda s: True, "the window to appear")
        self.id = self.xdotool("search", "--sync", "--onlyvisible", "--pid", str(self.process.pid)).split()[0]
        self.xdotool("windowfocus", "--sync", self.id)

    def close(self):
        if self.process.poll() is None:
            self.process.terminate()
        self.process.wait()
        self.folder.cleanup()

    def xdotool(self, *arguments):
        return subprocess.run(["xdotool", *arguments], check=True, capture_output=True, text=True,
                              env=self.environment).stdout

    # What the window says.

    def state(self):
        try:
            with open(self.state_path, encoding="utf-8") as file:
                return json.load(file)
        except FileNotFoundError:
            return None

    def wait(self, condition, what, timeout=TIMEOUT, ends=False):
        """The first state that the condition holds for; with `ends` the program may also end."""
        end = time.monotonic() + timeout
        state = None
        while time.monotonic() < end:
            if self.process.poll() is not None:
                if ends:
                    return state
                raise AssertionError(f"the program ended with {self.process.returncode} while waiting for {what}")
            state = self.state()
            if state is not None and condition(state):
                return state
            time.sleep(0.02)
        brief = {k: v for k, v in (state or {}).items() if k not in ("widgets", "settings", "keys", "keys_markdown")}
        raise AssertionError(f"waited in vain for {what}; the state is {json.dumps(brief, indent=1)}")

    def settled(self):
        """The state once nothing is under way, and the frames that follow have been drawn."""
        end = time.monotonic() + TIMEOUT
        while True:
            state = self.wait(lambda s: s["activity"] == "idle" and not s["stale"] and "stage" in s, "the run to settle")
            time.sleep(0.15)
            if self.state() == state or time.monotonic() > end:
                return state

    def image(self):
        time.sleep(0.15)  # the frame that the state file tells of is on its way to the screen
        return Image(self.display.name)

    def drawn(self, condition, what):
        """The first picture that the condition holds for."""
        end = time.monotonic() + TIMEOUT
        while time.monotonic() < end:
            image = self.image()
            if condition(image):
                return image
        raise AssertionError(f"waited in vain for {what}")

    # What a person does.

    def key(self, *chords):
        """Each key is pressed when the one before has been acted on."""
        for chord in chords:
            before = self.state()["keys_pressed"]
            self.xdotool("key", "--clearmodifiers", chord)
            self.wait(lambda s: s["keys_pressed"] > before, f"'{chord}' to be heard", ends=True)

    def type(self, text):
        self.xdotool("type", "--delay", "40", text)
        time.sleep(0.5)

    def move(self, x, y):
        self.xdotool("mousemove", str(int(x)), str(int(y)))
        time.sleep(0.08)

    def button_down(self, button=1):
        """It has been seen before the mouse goes on."""
        before = self.state()["buttons_pressed"]
        self.xdotool("mousedown", str(button))
        self.wait(lambda s: s["buttons_pressed"] > before, "the button to be heard", ends=True)

    def press(self, x, y, button=1, modifier=None):
        self.move(x - 1, y)
        self.move(x, y)
        if modifier:
            self.xdotool("keydown", modifier)
            time.sleep(0.1)
        before = self.state()["buttons_released"]
        self.button_down(button)
        self.xdotool("mouseup", str(button))
        self.wait(lambda s: s["buttons_released"] > before, "the mouse to be heard", ends=True)
        if modifier:
            self.xdotool("keyup", modifier)

    def drag(self, x0, y0, x1, y1, modifier=None):
        self.move(x0, y0)
        if modifier:
            self.xdotool("keydown", modifier)
            time.sleep(0.1)
        self.button_down()
        for i in range(1, 11):
            self.xdotool("mousemove", str(int(x0 + (x1 - x0) * i / 10)), str(int(y0 + (y1 - y0) * i / 10)))
            time.sleep(0.03)
        time.sleep(0.1)
        before = self.state()["buttons_released"]
        self.xdotool("mouseup", "1")
        self.wait(lambda s: s["buttons_released"] > before, "the mouse to be heard")
        if modifier:
            self.xdotool("keyup", modifier)

    def open_by_dialog(self, path):
        """The dialog is left behind; the mesh may come later."""
        self.key("ctrl+o")
        self.widget("open.path")
        self.key("ctrl+a")
        self.type(path)
        self.key("Return")
        self.wait(lambda s: s["dialog"] != "open", "the dialog to close")

    def hold(self, x, y):
        """Presses the button and keeps it down."""
        self.move(x, y)
        self.button_down()

    def release(self):
        before = self.state()["buttons_released"]
        self.xdotool("mouseup", "1")
        self.wait(lambda s: s["buttons_released"] > before, "the mouse to be heard")

    def widget_box(self, name):
        """Left, top, width, height of a widget that stays in its place."""
        self.widget(name)
        return self.state()["widgets"][name][:4]

    def widget(self, name):
        """Middle of a widget, once it is there and the next frame, if there is one, leaves it in its place."""
        place, frame, since = None, None, 0.0
        while True:
            state = self.wait(lambda s: name in s["widgets"], f"the widget '{name}'")
            if state["widgets"][name] != place:
                place, frame, since = state["widgets"][name], state["frame"], time.monotonic()
            elif state["frame"] > frame or time.monotonic() - since > 0.3:
                break
            time.sleep(0.04)
        x, y, width, height, _ = place
        return x + width / 2, y + height / 2

    def click(self, name):
        self.press(*self.widget(name))

    def enabled(self, name):
        self.settled()
        return self.wait(lambda s: name in s["widgets"], f"the widget '{name}'")["widgets"][name][4]

    def canvas(self):
        """Left, top, width, height."""
        return self.wait(lambda s: "canvas" in s["widgets"], "the canvas")["widgets"]["canvas"][:4]

    def pixel(self, x, y):
        """Where a world point is on the screen."""
        state = self.state()
        left, top = state["widgets"]["canvas"][:2]
        camera = state["camera"]
        return (left + camera["width"] / 2 + (x - camera["x"]) * camera["scale"],
                top + camera["height"] / 2 - (y - camera["y"]) * camera["scale"])


class WindowTest(unittest.TestCase):
    """One display and one program for each test."""

    arguments = []
    screen = (1280, 800)

    def write(self, name, content):
        """A file in the window's folder: text, or what is written as JSON. Returns its path."""
        path = os.path.join(self.window.folder.name, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(content if isinstance(content, str) else json.dumps(content))
        return path

    def open(self, name, content):
        """Opens a domain written for the purpose."""
        self.window.open_by_dialog(self.write(name, content))

    def setUp(self):
        if not PROGRAM:
            self.skipTest("TRISCOPE_PROGRAM is not set")
        self.display = Display(*self.screen)
        self.addCleanup(self.display.close)
        self.window = Window(self.display, *self.arguments)
        self.addCleanup(self.window.close)
        self.window.settled()
