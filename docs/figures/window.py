#!/usr/bin/python3
"""Takes the picture of the window that README.md shows: docs/figures/window.py BUILD/triscope

Needs the packages of ./test; opens the window on a screen of its own, presses keys and takes what is to be seen.
"""

import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
PROGRAM = pathlib.Path(sys.argv[1]).resolve()
os.environ.update(TRISCOPE_SOURCE_DIR=str(SOURCE), TRISCOPE_BUILD_DIR=str(PROGRAM.parent), TRISCOPE_PROGRAM=str(PROGRAM))
sys.path.insert(0, str(SOURCE / "tests" / "window"))
import harness  # noqa: E402

display = harness.Display(1280, 800)
try:
    window = harness.Window(display)
    window.wait(lambda s: s.get("stage") == "finished" and s["activity"] == "idle", "the mesh")
    for key in ("2", "y", "minus", "minus", "minus"):  # the worst triangle, why it is there, and further away
        window.settled()
        window.key(key)
    window.settled()
    shot = subprocess.run(["import", "-window", "root", "-display", display.name, "png:-"], check=True,
                          capture_output=True).stdout
    subprocess.run(["convert", "-", "-dither", "None", "-colors", "240", f"PNG8:{HERE / 'window.png'}"], input=shot,
                   check=True)
    window.close()
finally:
    display.close()
