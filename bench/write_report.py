"""Turns the JSON files of bench/run into docs/benchmarks.md and docs/figures/linear.svg.

Usage: write_report.py FOLDER_OF_JSON DOCS_FOLDER
"""

import json
import math
import pathlib
import sys

# Stages drawn and listed together, by the keys of the stage table.
GROUPS = [
    ("density", ["constraints", "quadtree", "density"]),
    ("boundary", ["boundary", "triangulation", "recovery", "carve"]),
    ("fronts", ["front1", "front2"]),
    ("step 1", ["step1"]),
    ("steps 2-5", ["step2", "step3", "step4", "step5"]),
    ("repair", ["repair"]),
    ("step 6", ["refine"]),
]
# Okabe-Ito, with a marker each so that colour is never the only sign.
STYLES = [("#0072B2", "circle"), ("#E69F00", "square"), ("#009E73", "diamond"), ("#CC79A7", "up"), ("#D55E00", "down"),
          ("#56B4E9", "ring"), ("#F0E442", "square"), ("#000000", "plus")]


def load(folder, name):
    """What one file holds, or of the rounds of a benchmark the fastest entry of each name."""
    files = sorted(folder.glob(f"{name}.*.json")) or [folder / f"{name}.json"]
    data, *others = (json.loads(file.read_text(encoding="utf-8")) for file in files)
    for other in others:
        data["benchmarks"] = [min(pair, key=lambda entry: entry.get("seconds", entry["cpu_time"]))
                              for pair in zip(data["benchmarks"], other["benchmarks"], strict=True)]
    return data


def seconds(entry, keys):
    return sum(entry[key] for key in keys)


def rows_of(stages):
    """One row per size: vertices, triangles, total seconds, and the seconds of each group."""
    rows = []
    for entry in stages["benchmarks"]:
        groups = [seconds(entry, keys) for _, keys in GROUPS]
        rows.append((entry["vertices"], entry["triangles"], entry["seconds"], groups))
    return rows


def exponent(rows, pick):
    """Least-squares slope of log(time) against log(vertices), from 10,000 vertices on: 1 is linear."""
    data = [(math.log(row[0]), math.log(pick(row))) for row in rows if row[0] > 8000 and pick(row) > 0]
    mean_x = sum(x for x, _ in data) / len(data)
    mean_y = sum(y for _, y in data) / len(data)
    return sum((x - mean_x) * (y - mean_y) for x, y in data) / sum((x - mean_x) ** 2 for x, _ in data)


def marker(kind, x, y, color):
    r = 4
    if kind == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r}" fill="{color}"/>'
    if kind == "ring":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r}" fill="#ffffff" stroke="{color}" stroke-width="2"/>'
    if kind == "plus":
        return (f'<path d="M{x - r:.1f} {y:.1f}h{2 * r}M{x:.1f} {y - r:.1f}v{2 * r}" stroke="{color}" '
                f'stroke-width="2" fill="none"/>')
    shapes = {
        "square": [(-r, -r), (r, -r), (r, r), (-r, r)],
        "diamond": [(0, -r - 1), (r + 1, 0), (0, r + 1), (-r - 1, 0)],
        "up": [(0, -r - 1), (r + 1, r), (-r - 1, r)],
        "down": [(0, r + 1), (r + 1, -r), (-r - 1, -r)],
    }
    points = " ".join(f"{x + dx:.1f},{y + dy:.1f}" for dx, dy in shapes[kind])
    return f'<polygon points="{points}" fill="{color}"/>'


def plot(rows):
    """Log-log plot of the seconds of each group and of the whole against the number of points."""
    width, height, left, right, top, bottom = 760, 520, 70, 110, 50, 55
    series = [(name, [(row[0], row[3][i]) for row in rows]) for i, (name, _) in enumerate(GROUPS)]
    series.append(("whole", [(row[0], row[2]) for row in rows]))
    values = [t for _, points in series for _, t in points if t > 0]
    x_low, x_high = math.floor(math.log10(rows[0][0]) * 2) / 2, math.ceil(math.log10(rows[-1][0]) * 10) / 10
    y_low, y_high = math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))

    def to_x(vertices):
        return left + (math.log10(vertices) - x_low) / (x_high - x_low) * (width - left - right)

    def to_y(time):
        return height - bottom - (math.log10(time) - y_low) / (y_high - y_low) * (height - top - bottom)

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
           'font-family="sans-serif" font-size="13">',
           f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
           f'<text x="{left}" y="28" font-size="16">Time of each stage against the number of points (graded ring)</text>']
    for power in range(y_low, y_high + 1):
        y = to_y(10.0**power)
        out.append(f'<line x1="{left}" y1="{y:.1f}" x2="{width - right}" y2="{y:.1f}" stroke="#dddddd"/>')
        label = f"{10**power:g} s" if power >= 0 else f"{10 ** (power + 3):g} ms" if power >= -3 else f"{10 ** (power + 6):g} µs"
        out.append(f'<text x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">{label}</text>')
    for power in range(math.ceil(x_low), math.floor(x_high) + 1):
        x = to_x(10.0**power)
        out.append(f'<line x1="{x:.1f}" y1="{top}" x2="{x:.1f}" y2="{height - bottom}" stroke="#dddddd"/>')
        out.append(f'<text x="{x:.1f}" y="{height - bottom + 20}" text-anchor="middle">{10**power:,}</text>')
    out.append(f'<text x="{(left + width - right) / 2}" y="{height - 12}" text-anchor="middle">points</text>')

    # The dashed line has slope 1: what linear looks like.
    start, end = rows[0][0], rows[-1][0]
    anchor = rows[-1][2] * 2.0
    first = max(start, end * 10.0**y_low / anchor)
    out.append(f'<line x1="{to_x(first):.1f}" y1="{to_y(anchor * first / end):.1f}" x2="{to_x(end):.1f}" '
               f'y2="{to_y(min(anchor, 10.0**y_high)):.1f}" stroke="#777777" stroke-dasharray="6 4"/>')
    labels = [("linear", to_y(min(anchor, 10.0**y_high)), "#555555")]
    for (name, points), (color, kind) in zip(series, STYLES):
        places = [(to_x(vertices), to_y(time)) for vertices, time in points if time > 0]
        out.append(f'<polyline points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in places)}" fill="none" '
                   f'stroke="{color}" stroke-width="2"/>')
        out += [marker(kind, x, y, color) for x, y in places]
        labels.append((name, places[-1][1], color))
    labels.sort(key=lambda label: label[1])
    floor = top
    for name, y, color in labels:  # spread so that no two overlap
        y = max(y, floor)
        out.append(f'<text x="{width - right + 10}" y="{y + 4:.1f}" fill="{color}">{name}</text>')
        floor = y + 15
    out.append("</svg>")
    return "\n".join(out) + "\n"


def best(data, prefix):
    """The entries whose name begins so, in order."""
    return [entry for entry in data["benchmarks"] if entry["name"].startswith(prefix)]


def rate(row):
    return row[1] / row[2]


def near(rows, triangles):
    """The row whose number of triangles is the closest."""
    return min(rows, key=lambda row: abs(math.log(row[1] / triangles)))


def real_name(entry):
    return entry["name"].split("/")[1]


def near_entry(stages, triangles):
    return min(stages["benchmarks"], key=lambda entry: abs(math.log(entry["triangles"] / triangles)))


def stage_table(entries, head, name_of):
    """Lines of a table of the seconds of each group."""
    lines = [f"| {head} | triangles | " + " | ".join(f"{name}, ms" for name, _ in GROUPS) + " | whole, ms |",
             "|---|" + "---:|" * (len(GROUPS) + 2)]
    for entry in entries:
        cells = [name_of(entry), f"{entry['triangles']:,.0f}",
                 *(f"{1000 * seconds(entry, keys):,.1f}" for _, keys in GROUPS), f"{1000 * entry['seconds']:,.0f}"]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def miss_table(entries, head, name_of):
    """Lines of a table of the cache misses of each group, where they are counted."""
    if not all(f"{key}_misses" in entry for entry in entries for _, keys in GROUPS for key in keys):
        return ["Misses of the last-level cache: not counted here (the machine or its settings do not)."]
    lines = ["Misses of the last-level cache, for each triangle:", "",
             f"| {head} | " + " | ".join(name for name, _ in GROUPS) + " |", "|---|" + "---:|" * len(GROUPS)]
    for entry in entries:
        cells = [sum(entry[f"{key}_misses"] for key in keys) / entry["triangles"] for _, keys in GROUPS]
        lines.append(f"| {name_of(entry)} | " + " | ".join(f"{cell:.2f}" for cell in cells) + " |")
    return lines


def process_table(processes):
    lines = ["| domain | triangles | mesh, s | µs/triangle | peak, MiB | check, s |", "|---|" + "---:|" * 5]
    for row in processes:
        lines.append(f"| {row['name']} | {row['triangles']:,} | {row['seconds']:.2f} | "
                     f"{1e6 * row['seconds'] / row['triangles']:.2f} | {row['peak_bytes'] / 2**20:.0f} | {row['check']:.2f} |")
    return lines


def report(stages, journal, airfoil, domains, history, memory, predicates, processes):
    rows = rows_of(stages)
    context = stages["context"]
    lines = [
        "# Benchmarks",
        "",
        "Written by `bench/run`; run it again rather than edit this page. Release build, one core, nobody listening to",
        f"events, on a machine of {context['num_cpus']} cores at {context['mhz_per_cpu'] / 1000:.1f} GHz. Processor time, the fastest of several",
        "runs each; treat figures as ±30 %.",
        "",
        "## Time against points",
        "",
        "The domain is a graded ring: a disc of radius 1 as the hole of a square of side 16, edges of Δx on the disc and",
        "growing away from it. All stages to step 6; what optimising takes is in [another table](optimiser.md).",
        "",
        "![Time of each stage against the number of points](figures/linear.svg)",
        "",
        "| points | triangles | " + " | ".join(f"{name}, ms" for name, _ in GROUPS) + " | whole, ms | triangles/s |",
        "|" + "---:|" * (len(GROUPS) + 4),
    ]
    for row in rows:
        cells = [f"{row[0]:,.0f}", f"{row[1]:,.0f}", *(f"{1000 * t:,.2f}" for t in row[3]), f"{1000 * row[2]:,.1f}",
                 f"{rate(row):,.0f}"]
        lines.append("| " + " | ".join(cells) + " |")
    slopes = [f"{exponent(rows, lambda row, i=i: row[3][i]):.2f}" for i in range(len(GROUPS))]
    lines.append("| exponent | | " + " | ".join(slopes) + f" | {exponent(rows, lambda row: row[2]):.2f} | |")
    small, large = near(rows, 3e4), near(rows, 1e6)
    lines += [
        "",
        "The last line fits time ~ points^exponent from 10,000 points on; 1 is linear, as Theorem 3 of the paper says.",
        f"A triangle of {large[1]:,.0f} costs {rate(small) / rate(large):.2f} times one of {small[1]:,.0f}: the small mesh",
        "fits into the processor's cache, the large one does not; and a short run that is repeated here is learnt by the",
        "processor, which foresees its branches. Whole processes, below, run once and have only the first of the two.",
        "",
        *miss_table([near_entry(stages, 3e4), near_entry(stages, 1e6)], "points", lambda e: f"{e['vertices']:,.0f}"),
        "",
        "## Real domains",
        "",
        *stage_table(domains["benchmarks"], "domain", real_name),
        "",
        *miss_table(domains["benchmarks"], "domain", real_name),
        "",
        "## Whole processes",
        "",
        "`triscope mesh DOMAIN --set optimise=off -o x.msh --report r.json` from its start to the files written, and",
        "`triscope check x.msh`: processor time, user and system.",
        "",
        *process_table(processes),
        "",
        "## Other figures",
        "",
        "| what | figure |",
        "|---|---:|",
    ]
    entry = best(airfoil, "threeElementAirfoil")[0]
    lines.append(f"| three-element airfoil, file to mesh without step 6, {entry['triangles']:,.0f} triangles | "
                 f"{1000 * entry['seconds']:.0f} ms |")
    plain, kept, travelled = best(history, "airfoilHistory")
    lines.append(f"| three-element airfoil with step 6, nobody listening | {1000 * plain['seconds']:.0f} ms |")
    lines.append(f"| the same, keeping all {kept['events']:,.0f} events as they are, {kept['event_bytes'] / kept['inserted']:.0f} bytes an inserted point | "
                 f"{1000 * kept['seconds']:.0f} ms |")
    lines.append(f"| the same with time travel as in the window, without the optimiser: events packed, {travelled['event_bytes'] / travelled['inserted']:.0f} bytes an "
                 f"inserted point, and {travelled['keyframes']:.0f} keyframes of {travelled['keyframe_bytes'] / 2**20:.0f} MiB together | {1000 * travelled['seconds']:.0f} ms |")
    entry = best(memory, "ringMemory")[0]
    lines.append(f"| peak memory at {entry['triangles']:,.0f} triangles | {entry['bytes_per_triangle']:.0f} bytes/triangle |")
    off, on = best(journal, "ringJournal")[:2]
    lines.append(f"| ring of {off['triangles']:,.0f} triangles without a listener | {1000 * off['seconds']:.0f} ms |")
    lines.append(f"| the same, keeping all {on['events']:,.0f} events | {1000 * on['seconds']:.0f} ms |")
    names = {"inCircle/random": "in-circle, random points", "inCircle/cocircular_grid": "in-circle, cocircular grid",
             "inCircle/nearly_cocircular": "in-circle, one bit off cocircular", "orientation/random": "orientation, random points"}
    for entry in predicates["benchmarks"]:
        lines.append(f"| {names.get(entry['name'], entry['name'])} | {entry['cpu_time']:.0f} ns |")
    return "\n".join(lines) + "\n", plot(rows)


def main():
    folder, docs = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    page, figure = report(*(load(folder, name) for name in ("stages", "journal", "airfoil", "domains", "history", "memory", "predicates", "processes")))
    (docs / "figures").mkdir(parents=True, exist_ok=True)
    (docs / "benchmarks.md").write_text(page, encoding="utf-8")
    (docs / "figures" / "linear.svg").write_text(figure, encoding="utf-8")
    print(docs / "benchmarks.md")


if __name__ == "__main__":
    main()
