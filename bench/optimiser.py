#!/usr/bin/python3
"""What each way of placing points and the optimiser make of a domain: bench/optimiser.py PROGRAM DOMAIN… > docs/optimiser.md

Every figure but the time and the degrees is that of the program's own report; degrees are counted in the mesh file.
"""

import collections
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

from gmsh_peer import GMSH, mesh_with_gmsh, read_msh2, sides
from process_bench import RING

STEP_6 = "laplacian reduce_obtuse shared_edge polish".split()
NO_STEP_6 = [f"{key}=off" for key in STEP_6]
PLACEMENTS = ["circumcentre", "off-centre", "frontal", "size-optimal", "tiling", "spokes"]
DIALS = ["easy", "default", "acute"]
RINGS = {"ring, 30 k": 94.0 / 16500, "ring, 1 M": 94.0 / 540000}
FRONTIER = [(86, 43), (84, 43.5), (82, 44), (80, 44), (78, 44.5), (76, 44.5), (74, 44.5), (72.5, 44.5)]


def inner_degrees(path):
    """How many vertices off the boundary have five, six, seven and any other number of triangles."""
    degree, edges = collections.Counter(), collections.Counter()
    for corners in read_msh2(path)[1]:
        degree.update(corners)
        for a, b in sides(corners):
            edges[(a, b) if a < b else (b, a)] += 1
    border = {v for edge, sides in edges.items() if sides == 1 for v in edge}
    return collections.Counter(n for v, n in degree.items() if v not in border)


def run(program, domain, preset, settings, folder, degrees):
    mesh, report = folder / "mesh.msh", folder / "report.json"
    command = [program, "mesh", domain, "-q", "--preset", preset, "--report", report, "-o", mesh, "--msh2"]
    for setting in settings:
        command += ["--set", setting]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    figures = json.loads(report.read_text(encoding="utf-8"))
    figures["seconds"] = sum(stage["seconds"] for stage in figures["stages"])
    figures["process"] = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    figures["degrees"] = inner_degrees(mesh) if degrees else None
    return figures


def row(name, f):
    degrees = f["degrees"]
    six = six_near = "—"
    if degrees:
        inner = max(1, sum(degrees.values()))
        six = f"{100 * degrees[6] / inner:.1f}"
        six_near = f"{100 * (degrees[5] + degrees[6] + degrees[7]) / inner:.2f}"
    fit = "— | —" if "edge_over_h_mean" not in f else f"{f['edge_over_h_mean']:.2f} | {100 * f['edge_over_h_within']:.2f}"
    return (f"| {name} | {f['triangles']:,} | {f['obtuse']:,} | {f['min_angle_deg']:.1f}–{f['max_angle_deg']:.1f}° "
            f"| {f['aspect_ratio_max']:.2f} | {f['aspect_ratio_mean']:.4f} | {f['area_ratio_max']:.2f} "
            f"| {f['edge_ratio_max']:.2f} | {six} | {six_near} | {fit} | {f['seconds']:.3f} |")


HEADING = ("| {} | triangles | obtuse | angles | R/r worst | mean | area ratio | edge ratio | degree 6, % | 5–7, % | e/h | 0.71–1.41, % | s |\n"
           "|---|---:|---:|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|")


def variants():
    yield "steps 1–5", "standard", [*NO_STEP_6, "optimise=off"]
    yield "steps 1–6", "standard", ["optimise=off"]
    yield "steps 1–6, optimised", "standard", []
    for placement in PLACEMENTS:
        yield f"{placement}, placed", "best", [f"placement={placement}", "optimise=off"]
        yield f"{placement}, optimised", "best", [f"placement={placement}"]


def main():
    program, *domains = sys.argv[1:]
    print("# The optimiser\n\nWritten by `bench/optimiser.py`; run it again rather than edit this page. Seconds are those "
          "of all stages, nobody\nlistening, on one core; the machine is that of [the benchmarks](benchmarks.md), and "
          "figures in seconds are ±30 %.\nWhat the measures mean is said [here](measures.md); degrees are those of inner "
          "vertices, e/h is\n`edge_over_h_mean` and the column after it `edge_over_h_within`.")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        files = {}
        for ring, shortest in RINGS.items():
            files[ring] = folder / f"{ring}.json"
            files[ring].write_text(json.dumps({**RING, "min_edge_length": shortest}), encoding="utf-8")
        files.update({pathlib.Path(domain).stem: domain for domain in domains})
        print("\n## The three marks of the dial\n\nPreset `best`, at each mark.")
        for dial in DIALS:
            print(f"\n### {dial}\n\n" + HEADING.format("domain"))
            for domain, file in files.items():
                large = os.path.getsize(file) > 300_000 or domain == "ring, 1 M"
                print(row(domain, run(program, file, "best", [f"dial={dial}"], folder, not large)), flush=True)
        print("\n## Where points go\n\nDial `easy`. \"Placed\" is what the placement leaves, after the rounds of steps 2–5 "
              "where it is not optimised. Gmsh\nhas the boundary points and the lengths of the mesh of spokes, optimised; it is "
              "its Frontal-Delaunay with ten steps of\nsmoothing, from Debian, and its own processor time for the inside.")
        for domain in ["ring, 30 k", *[d for d in files if d in ("three_element_airfoil", "lake_superior")]]:
            print(f"\n### {domain}\n\n" + HEADING.format("how"))
            for how, preset, settings in variants():
                figures = run(program, files[domain], preset, ["dial=easy", *settings], folder, True)
                print(row(how, figures), flush=True)
            if GMSH:
                run(program, files[domain], "best", ["dial=easy"], folder, False)
                figures, mesh = mesh_with_gmsh(program, folder / "mesh.msh", folder)
                figures["degrees"] = inner_degrees(mesh)
                print(row("Gmsh", figures), flush=True)
        print("\n## How far it goes\n\nPreset `best`, with angles of its own, area ratio 1.4 and edge ratio 1.4.")
        for domain in ["ring, 30 k", *[d for d in files if d in ("airfoil_30p30n", "lake_superior", "koch5")]]:
            print(f"\n### {domain}\n\n" + HEADING.format("asked for"))
            for highest, lowest in FRONTIER:
                settings = [f"lowest_angle={lowest}", f"highest_angle={highest}", "area_ratio=1.4", "edge_ratio=1.4"]
                figures = run(program, files[domain], "best", settings, folder, True)
                print(row(f"{lowest:g}–{highest:g}°", figures), flush=True)


if __name__ == "__main__":
    main()
