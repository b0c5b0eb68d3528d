#!/usr/bin/python3
"""How long a drag of omega takes to be seen: bench/tuning.py PROGRAM DOMAIN.

Moves a real mouse over the slider under Xvfb and waits until the state file tells of the new mesh. Prints milliseconds
on the clock, and of processor time by the busiest thread, which is the one that makes the mesh.
"""

import ctypes
import os
import pathlib
import statistics
import sys
import time

os.environ["TRISCOPE_PROGRAM"] = os.path.abspath(sys.argv[1])
sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "tests" / "window"))
import harness  # noqa: E402: reads the environment

OMEGAS = [0.05 + 0.02 * (5 * k % 11) for k in range(22)]


class Mouse:
    """A connection that stays open: no process has to start for each event."""

    def __init__(self, display):
        self.x11, self.test = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
        self.x11.XOpenDisplay.restype = ctypes.c_void_p
        self.display = ctypes.c_void_p(self.x11.XOpenDisplay(display.encode()))

    def move(self, x, y):
        self.test.XTestFakeMotionEvent(self.display, -1, int(x), int(y), 0)
        self.x11.XFlush(self.display)


def processor_time(pid):
    """Milliseconds by thread."""
    folder = pathlib.Path(f"/proc/{pid}/task")
    return {task.name: int((task / "schedstat").read_text().split()[0]) / 1e6 for task in folder.iterdir()}


def main():
    display = harness.Display()
    window = harness.Window(display, os.path.abspath(sys.argv[2]))
    try:
        mouse = Mouse(display.name)
        print(window.settled()["figures"]["vertices"], "vertices")
        window.wait(lambda s: s["debug"]["measured"] == s["debug"]["ticks"], "the measures")
        window.click("tab.Params")
        x, y, width, height = window.widget_box("param.omega")
        window.hold(x + 0.15 * width, y + height / 2)
        clock, processor = [], []
        for omega in OMEGAS:
            before = window.settled()
            used = processor_time(window.process.pid)
            start = time.monotonic()
            mouse.move(x + omega * width, y + height / 2)
            state = window.state()
            while state["hash"] == before["hash"] or state["stale"] or state["activity"] != "idle":
                time.sleep(0.002)
                state = window.state()
            clock.append(1000 * (time.monotonic() - start))
            now = processor_time(window.process.pid)
            processor.append(max(ms - used.get(thread, 0) for thread, ms in now.items()))
        window.release()
        for name, values in (("clock", clock), ("processor", processor)):
            print(f"{name}: from {min(values):.0f} to {max(values):.0f} ms, median {statistics.median(values):.0f}")
    finally:
        window.close()
        display.close()


if __name__ == "__main__":
    main()
