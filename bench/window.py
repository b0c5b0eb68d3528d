#!/usr/bin/python3
"""How long the window takes to answer: bench/window.py PROGRAM [DOMAIN], or else the ring of a million triangles.

Presses real keys and moves a real mouse under Xvfb, and waits until the state file tells of what they ask for. Prints
milliseconds on the clock; for the drag of omega also of processor time by the busiest thread, which makes the mesh.
"""

import ctypes
import json
import os
import pathlib
import statistics
import sys
import tempfile
import time

from process_bench import RING

os.environ["TRISCOPE_PROGRAM"] = os.path.abspath(sys.argv[1])
sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "tests" / "window"))
import harness  # noqa: E402: reads the environment

OMEGAS = [0.05 + 0.02 * (5 * k % 11) for k in range(22)]
PLACES = [0.05 + 0.9 * (7 * k % 20) / 20 for k in range(20)]
LEFT, RIGHT = 0xff51, 0xff53  # keysyms
IDLE_SECONDS = 10.0
MILLION = {**RING, "min_edge_length": 94.0 / 540000}
harness.TIMEOUT = 120.0


class Person:
    """A connection that stays open: no process has to start for each event."""

    def __init__(self, display):
        self.x11, self.test = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
        self.x11.XOpenDisplay.restype = ctypes.c_void_p
        self.x11.XKeysymToKeycode.argtypes = [ctypes.c_void_p, ctypes.c_ulong]
        self.display = ctypes.c_void_p(self.x11.XOpenDisplay(display.encode()))

    def move(self, x, y):
        self.test.XTestFakeMotionEvent(self.display, -1, int(x), int(y), 0)
        self.x11.XFlush(self.display)

    def press(self, keysym):
        code = self.x11.XKeysymToKeycode(self.display, keysym) & 0xff
        self.test.XTestFakeKeyEvent(self.display, code, 1, 0)
        self.test.XTestFakeKeyEvent(self.display, code, 0, 0)
        self.x11.XFlush(self.display)


def processor_time(pid):
    """Milliseconds by thread."""
    folder = pathlib.Path(f"/proc/{pid}/task")
    return {task.name: int((task / "schedstat").read_text().split()[0]) / 1e6 for task in folder.iterdir()}


def answered(window, act, done):
    """Milliseconds from an act until the window shows what it asks for and has come to rest."""
    start = time.monotonic()
    act()
    while True:
        state = window.state()
        if done(state) and state["activity"] == "idle" and not state["stale"]:
            return 1000 * (time.monotonic() - start)
        time.sleep(0.001)


def tell(what, values):
    print(f"{what}: from {min(values):.0f} to {max(values):.0f} ms, median {statistics.median(values):.0f}")


def steps(window, person, back="step back", on="step"):
    for what, keysym in ((back, LEFT), (on, RIGHT)):
        values = []
        for _ in range(30):
            tick = window.settled()["tick"]
            values.append(answered(window, lambda k=keysym: person.press(k), lambda s, t=tick: s["tick"] != t))
        tell(what, values)


def pan(window, person):
    x, y, width, height = window.widget_box("canvas")
    middle = (x + width / 2, y + height / 2)
    window.hold(*middle)
    values = []
    for k in range(1, 21):
        camera = window.settled()["camera"]
        values.append(answered(window, lambda k=k: person.move(middle[0] + 11 * k, middle[1] + 5 * k),
                               lambda s, c=camera: s["camera"] != c))
    window.release()
    tell("pan", values)


def memory(window, when):
    status = pathlib.Path(f"/proc/{window.process.pid}/status").read_text()
    now, peak = (int(next(line for line in status.splitlines() if line.startswith(key)).split()[1]) / 1024
                 for key in ("VmRSS", "VmHWM"))
    print(f"memory {when}: {now:.0f} MiB, at most {peak:.0f} MiB so far")


def scrub(window, person):
    x, y, width, height = window.widget_box("timeline")
    window.hold(x + 0.5 * width, y + height / 2)
    values = []
    for place in PLACES:
        tick = window.settled()["tick"]
        values.append(answered(window, lambda p=place: person.move(x + p * width, y + height / 2),
                               lambda s, t=tick: s["tick"] != t))
    window.release()
    tell("scrub", values)
    steps(window, person, "back from there", "step from there")


def drag_omega(window, person):
    window.key("End")
    window.click("tab.Params")
    x, y, width, height = window.widget_box("param.omega")
    window.hold(x + 0.15 * width, y + height / 2)
    clock, processor = [], []
    for omega in OMEGAS:
        before = window.settled()["hash"]
        used = processor_time(window.process.pid)
        clock.append(answered(window, lambda o=omega: person.move(x + o * width, y + height / 2),
                              lambda s, h=before: s["hash"] != h))
        now = processor_time(window.process.pid)
        processor.append(max(ms - used.get(thread, 0) for thread, ms in now.items()))
    window.release()
    tell("omega dragged, clock", clock)
    tell("omega dragged, processor", processor)


def idle(window):
    before = sum(processor_time(window.process.pid).values())
    time.sleep(IDLE_SECONDS)
    used = sum(processor_time(window.process.pid).values()) - before
    print(f"idle: {100 * used / (1000 * IDLE_SECONDS):.2f} % of a core")


def main():
    display = harness.Display()
    folder = tempfile.TemporaryDirectory()
    domain = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else os.path.join(folder.name, "ring.json")
    if len(sys.argv) <= 2:
        pathlib.Path(domain).write_text(json.dumps(MILLION), encoding="utf-8")
    window = harness.Window(display, domain)
    try:
        person = Person(display.name)
        state = window.wait(lambda s: s.get("stage") == "finished" and s["activity"] == "idle", "the mesh")
        print(f"first meshed frame: within {1000 * (time.monotonic() - window.started):.0f} ms of the start")
        print(state["figures"]["vertices"], "vertices,", state["figures"]["triangles"], "triangles,", state["events"],
              "events")
        window.wait(lambda s: s["debug"]["measured"] == s["debug"]["ticks"], "the measures")
        window.settled()
        idle(window)
        memory(window, "at rest")
        steps(window, person)
        pan(window, person)
        scrub(window, person)
        drag_omega(window, person)
        time.sleep(IDLE_SECONDS)
        memory(window, "in the end")
    finally:
        window.close()
        display.close()
        folder.cleanup()


if __name__ == "__main__":
    main()
