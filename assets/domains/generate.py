#!/usr/bin/python3
"""Writes the samples of this folder whose points come from formulas:
blunt_body, naca0012 and three_element_airfoil. Run it after changing a number below;
with an argument it writes into that folder.

Airfoil sections: E. N. Jacobs, K. E. Ward, R. M. Pinkerton, NACA Report 460, 1933,
with the last thickness coefficient changed so that the trailing edge closes.
"""

import math
import pathlib
import sys

FOLDER = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
if FOLDER.is_file():
    FOLDER = FOLDER.parent


def section(camber, camber_at, thickness, points):
    """Points of a NACA four-digit section of chord 1: from the trailing edge over the
    upper side to the nose and back below, counter-clockwise, the trailing edge once."""

    def half(x):
        return 5 * thickness * (
            0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)

    def camber_line(x):
        if camber == 0:
            return 0.0, 0.0
        p = camber_at
        scale = camber / p**2 if x < p else camber / (1 - p)**2
        base = 0.0 if x < p else 1 - 2 * p
        return scale * (base + 2 * p * x - x * x), 2 * scale * (p - x)

    result = []
    for i in range(2 * points):
        angle = math.pi * i / points  # 0: trailing edge, pi: nose
        x = 0.5 * (1 + math.cos(angle))
        side = 1 if i <= points else -1
        y, slope = camber_line(x)
        tilt = math.atan(slope)
        offset = side * half(x)
        result.append((x - offset * math.sin(tilt), y + offset * math.cos(tilt)))
    return result


def place(points, chord, degrees, trailing_edge):
    """Scales a section, turns it nose down by `degrees` about its trailing edge, and moves
    the trailing edge (its first point) to where it belongs."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    x0, y0 = points[0]
    return [(trailing_edge[0] + chord * (c * (x - x0) - s * (y - y0)),
             trailing_edge[1] + chord * (s * (x - x0) + c * (y - y0))) for x, y in points]


def nice(value):
    text = f"{value:.9f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def listed(points, indent):
    pad = " " * indent
    lines = []
    for i in range(0, len(points), 4):
        lines.append(pad + ", ".join(f"[{nice(x)}, {nice(y)}]" for x, y in points[i:i + 4]))
    return "[\n" + ",\n".join(lines) + "\n" + pad[:-2] + "]"


def spline_hole(name, points):
    return ("    {\n"
            f'      "name": "{name}",\n'
            '      "kind": "spline",\n'
            '      "corners": [0],\n'
            f'      "points": {listed(points, 8)}\n'
            "    }")


def square(size):
    return f"[[{-size}, {-size}], [{size}, {-size}], [{size}, {size}], [{-size}, {size}]]"


def write(name, text):
    (FOLDER / name).write_text(text, encoding="utf-8")


def naca0012():
    write("naca0012.json", "{\n"
          '  "name": "NACA 0012",\n'
          '  "description": "One symmetric airfoil of chord 1: a round nose, where curvature sets the density, '
          'and a sharp trailing edge, which is kept as a corner.",\n'
          '  "min_edge_length": 0.005,\n'
          f'  "outer": {{"name": "far field", "kind": "polygon", "points": {square(8)}}},\n'
          '  "holes": [\n' + spline_hole("airfoil", section(0, 0.4, 0.12, 40)) + "\n  ]\n}\n")


def three_element_airfoil():
    slat = place(section(0.09, 0.5, 0.10, 28), 0.17, 28, (0.083, 0.0485))
    main = place(section(0.03, 0.4, 0.13, 40), 0.72, 0, (0.78, 0.0))
    flap = place(section(0.04, 0.4, 0.12, 32), 0.30, -30, (1.032, -0.1665))
    holes = [spline_hole("slat", slat), spline_hole("main", main), spline_hole("flap", flap)]
    write("three_element_airfoil.json", "{\n"
          '  "name": "three-element airfoil",\n'
          '  "description": "Slat, main element and flap from airfoil formulas: narrow gaps, three sharp trailing '
          'edges, and edge lengths over four orders of magnitude. The counterpart of the second example of the '
          'paper.",\n'
          '  "min_edge_length": 0.001,\n'
          f'  "outer": {{"name": "far field", "kind": "polygon", "points": {square(16)}}},\n'
          '  "holes": [\n' + ",\n".join(holes) + "\n  ]\n}\n")


def blunt_body():
    """A blunt cone with bulging sides, symmetric about the x axis: arcs at the nose and at both
    base corners, joined by splines along the sides and a line along the base, all tangent."""
    nose = (-4.68, 0.0, 1.716)    # centre and radius
    corner = (6.24, 4.68, 1.17)
    bulge = 6.0                 # degrees that each side turns

    # The side leaves the nose in direction `a` and meets the corner in direction `a - bulge`.
    def on(circle, degrees):
        angle = math.radians(degrees)
        return circle[0] + circle[2] * math.cos(angle), circle[1] + circle[2] * math.sin(angle)

    def chord_tilt(a):
        start, end = on(nose, a + 90), on(corner, a - bulge + 90)
        return math.degrees(math.atan2(end[1] - start[1], end[0] - start[0]))

    low, high = 0.0, 60.0       # the chord of a symmetric side points along a - bulge / 2
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if chord_tilt(middle) > middle - bulge / 2 else (low, middle)
    a = low
    start, end = on(nose, a + 90), on(corner, a - bulge + 90)
    half = 0.5 * math.hypot(end[0] - start[0], end[1] - start[1])
    rise = 0.5 * half * math.tan(math.radians(bulge / 2))  # of a parabola with these end tangents
    tilt = math.radians(a - bulge / 2)
    top = (0.5 * (start[0] + end[0]) - rise * math.sin(tilt), 0.5 * (start[1] + end[1]) + rise * math.cos(tilt))
    shoulder = on(corner, 0.5 * (a - bulge + 90))
    base = on(corner, 0)

    def below(p):
        return p[0], -p[1]

    pieces = [("arc", [start, on(nose, 180), below(start)]),
              ("spline", [below(start), below(top), below(end)]),
              ("arc", [below(end), below(shoulder), below(base)]),
              ("line", [below(base), base]),
              ("arc", [base, shoulder, end]),
              ("spline", [end, top, start])]
    text = ",\n".join('        {"kind": "%s", "points": [%s]}' % (
        kind, ", ".join(f"[{nice(x)}, {nice(y)}]" for x, y in points)) for kind, points in pieces)
    places = [("nose", on(nose, 180)), ("lower base corner", below(shoulder)), ("upper base corner", shoulder)]
    density = ",\n".join(f'    {{"name": "{name}", "at": [{nice(x)}, {nice(y)}], "rank": 1}}' for name, (x, y) in places)
    write("blunt_body.json", "{\n"
          '  "name": "blunt body",\n'
          '  "description": "A rounded blunt body in a square, with three points of large curvature: the nose and '
          'two base corners. The counterpart of the running example of the paper.",\n'
          '  "min_edge_length": 1,\n'
          f'  "outer": {{"name": "far field", "kind": "polygon", "points": {square(32)}}},\n'
          '  "holes": [\n    {\n      "name": "body",\n      "kind": "pieces",\n      "pieces": [\n'
          + text + "\n      ]\n    }\n  ],\n"
          '  "density": [\n' + density + "\n  ]\n}\n")


if __name__ == "__main__":
    blunt_body()
    naca0012()
    three_element_airfoil()
