"""Times whole processes, from the start of the program to its files written, and writes them as JSON.

Usage: process_bench.py PROGRAM FOLDER_OF_DOMAINS OUT.json [RUNS]

Processor time (user and system), the least of some runs each, and peak memory.
"""

import json
import os
import pathlib
import sys
import tempfile

RING = {
    "outer": [[-8, -8], [8, -8], [8, 8], [-8, 8]],
    "holes": [{"kind": "circle", "name": "disc", "centre": [0, 0], "radius": 1}],
    "density": [{"loop": "disc", "rank": 1}],
}


def run(command):
    """Seconds of processor time, and peak bytes, of one process."""
    child = os.posix_spawn(command[0], command, os.environ,
                           file_actions=[(os.POSIX_SPAWN_OPEN, 1, "/dev/null", os.O_WRONLY, 0)])
    _, status, usage = os.wait4(child, 0)
    # 1: bounds not met, at input angles that no mesh can do anything about
    if os.waitstatus_to_exitcode(status) not in (0, 1):
        sys.exit(f"{' '.join(command)}: {os.waitstatus_to_exitcode(status)}")
    return usage.ru_utime + usage.ru_stime, 1024 * usage.ru_maxrss


def least(command, runs):
    return tuple(min(values) for values in zip(*(run(command) for _ in range(runs))))


def main():
    program, domains, out = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
    runs = int(sys.argv[4]) if len(sys.argv) > 4 else 3
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        cases = [("ring", 94.0 / 15000), ("ring", 94.0 / 540000)]
        files = [domains / f"{name}.json" for name in ("koch5", "perforated_plate", "great_britain")]
        for name, min_edge in cases:
            path = folder / f"{name}_{min_edge:.2g}.json"
            path.write_text(json.dumps({**RING, "min_edge_length": min_edge}), encoding="utf-8")
            files.append(path)
        rows = []
        for path in files:
            mesh, report = folder / "x.msh", folder / "report.json"
            seconds, peak = least([program, "mesh", str(path), "-q", "--set", "optimise=off", "-o", str(mesh), "--report", str(report)], runs)
            check, _ = least([program, "check", str(mesh)], runs)
            told = json.loads(report.read_text(encoding="utf-8"))
            rows.append({"name": path.stem.split("_")[0] if path.parent == folder else path.stem,
                         "triangles": told["triangles"], "seconds": seconds, "peak_bytes": peak, "check": check})
    pathlib.Path(out).write_text(json.dumps(rows, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
