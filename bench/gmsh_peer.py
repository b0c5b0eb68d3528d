"""Meshes a domain with Gmsh for comparison: its boundary points and its edge lengths are those of a mesh of ours.

Gmsh's Frontal-Delaunay with ten steps of its smoothing, as Debian has it. Only domains without inner chains.
"""

import collections
import math
import pathlib
import re
import shutil
import subprocess

GMSH = shutil.which("gmsh")
OPTIONS = """
Mesh.Algorithm = 6;
Mesh.Smoothing = 10;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
"""


def read_msh2(path):
    """Points by name, and triangles as triples of names."""
    lines = iter(path.read_text(encoding="ascii").splitlines())
    points, triangles = {}, []
    for line in lines:
        if line == "$Nodes":
            for _ in range(int(next(lines))):
                name, x, y, _ = next(lines).split()
                points[name] = (float(x), float(y))
        elif line == "$Elements":
            for _ in range(int(next(lines))):
                numbers = next(lines).split()
                if numbers[1] == "2":
                    triangles.append(tuple(numbers[-3:]))
    return points, triangles


def sides(triangle):
    return zip(triangle, triangle[1:] + triangle[:1])


def loops_of(triangles):
    """Closed chains of border edges, the domain on their left."""
    directed = {edge for triangle in triangles for edge in sides(triangle)}
    after = {a: b for a, b in directed if (b, a) not in directed}
    loops = []
    while after:
        start, at = after.popitem()
        loop = [start]
        while at != start:
            loop.append(at)
            at = after.pop(at)
        loops.append(loop)
    return loops


def twice_area(points, loop):
    return sum(points[a][0] * points[b][1] - points[b][0] * points[a][1] for a, b in sides(tuple(loop)))


def geometry(points, loops):
    names = {v: k for k, v in enumerate((v for loop in loops for v in loop), 1)}
    text = [f"Point({k}) = {{{points[v][0]!r}, {points[v][1]!r}, 0}};" for v, k in names.items()]
    line, curves = 0, []
    for loop in loops:
        own = []
        for a, b in sides(tuple(loop)):
            line += 1
            own.append(line)
            text.append(f"Line({line}) = {{{names[a]}, {names[b]}}};")
        curves.append(own)
    text.append(f"Transfinite Curve {{1:{line}}} = 2;")
    text += [f"Curve Loop({k}) = {{{', '.join(map(str, own))}}};" for k, own in enumerate(curves, 1)]
    text.append(f"Plane Surface(1) = {{{', '.join(str(k) for k in range(1, len(curves) + 1))}}};")
    return "\n".join(text)


def lengths(points, triangles):
    """Mean length of the edges at each vertex."""
    sums, counts = collections.Counter(), collections.Counter()
    for triangle in triangles:
        for a, b in sides(triangle):
            length = math.dist(points[a], points[b])
            for v in (a, b):
                sums[v] += length
                counts[v] += 1
    return {v: sums[v] / counts[v] for v in sums}


def aspect(p, q, r):
    """R/r."""
    a, b, c = math.dist(p, q), math.dist(q, r), math.dist(r, p)
    area = 0.5 * abs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]))
    return a * b * c * (a + b + c) / (8.0 * area * area)


def mesh_with_gmsh(program, ours, folder):
    """The figures of `triscope check` of what Gmsh makes of the same boundary points and lengths, with its seconds."""
    points, triangles = read_msh2(ours)
    loops = sorted(loops_of(triangles), key=lambda loop: -twice_area(points, loop))
    h = lengths(points, triangles)
    geo, background, out = folder / "peer.geo", folder / "peer.pos", folder / "peer.msh"
    with background.open("w", encoding="ascii") as file:
        file.write('View "h" {\n')
        for t in triangles:
            places = ", ".join(f"{points[v][0]!r}, {points[v][1]!r}, 0" for v in t)
            file.write(f"ST({places}){{{', '.join(repr(h[v]) for v in t)}}};\n")
        file.write("};\n")
    geo.write_text(geometry(points, loops) + f'\nMerge "{background.name}";\nField[1] = PostView;\nField[1].ViewIndex = 0;\n'
                   "Background Field = 1;\n" + OPTIONS, encoding="ascii")
    told = subprocess.run([GMSH, "-2", "-nt", "1", "-format", "msh2", "-o", out, geo], check=True, capture_output=True,
                          text=True, cwd=folder)
    checked = subprocess.run([program, "check", out], check=False, capture_output=True, text=True).stdout
    figures = {line.split()[0]: float(line.split()[1]) for line in checked.splitlines() if not line.startswith("valid")}
    for key in ("triangles", "obtuse"):
        figures[key] = int(figures[key])
    points, triangles = read_msh2(out)
    figures["aspect_ratio_mean"] = sum(aspect(*(points[v] for v in t)) for t in triangles) / len(triangles)
    figures["seconds"] = float(re.search(r"Done meshing 2D \(Wall \S+s, CPU (\S+)s\)", told.stdout)[1])
    return figures, pathlib.Path(out)
