#!/usr/bin/env python3
"""Makes the small shapes of the example scenes: sphere, thin plate, knot, sheet, bracket. Run as
`make_shapes.py [FOLDER]`; the files are the same on every run.

Metres, +Y up, counter-clockwise fronts. A shape is a list of points and a list of polygons of indices.
"""
import math
import os
import sys

TURN = 2 * math.pi


def sphere(rings, segments, radius):
    """Latitude and longitude, standing on the ground."""
    points = [(0.0, 2 * radius, 0.0)]
    for r in range(1, rings):
        polar = math.pi * r / rings
        for s in range(segments):
            a = TURN * s / segments
            points.append((radius * math.sin(polar) * math.sin(a), radius + radius * math.cos(polar),
                           radius * math.sin(polar) * math.cos(a)))
    points.append((0.0, 0.0, 0.0))
    at = lambda r, s: 1 + (r - 1) * segments + s % segments
    faces = []
    for s in range(segments):
        faces.append((0, at(1, s), at(1, s + 1)))
        for r in range(1, rings - 1):
            faces.append((at(r, s), at(r + 1, s), at(r + 1, s + 1), at(r, s + 1)))
        faces.append((len(points) - 1, at(rings - 1, s + 1), at(rings - 1, s)))
    return points, faces


def plate(width, height, thickness, columns, rows):
    """A closed box that stands upright, its two large sides in squares."""
    points, faces = [], []
    for z in (thickness / 2, -thickness / 2):
        for j in range(rows + 1):
            for i in range(columns + 1):
                points.append((width * (i / columns - 0.5), height * j / rows, z))
    back = (rows + 1) * (columns + 1)
    at = lambda i, j: j * (columns + 1) + i
    for j in range(rows):
        for i in range(columns):
            square = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1))
            faces.append(square)
            faces.append(tuple(back + p for p in reversed(square)))
    border = ([at(i, 0) for i in range(columns)] + [at(columns, j) for j in range(rows)]
              + [at(i, rows) for i in range(columns, 0, -1)] + [at(0, j) for j in range(rows, 0, -1)])
    for p, q in zip(border, border[1:] + border[:1]):
        faces.append((q, p, back + p, back + q))
    return points, faces


def knot(p, q, big, small, tube, around, along):
    """A tube along the torus knot (p, q). The tube's frame turns with the torus, so that it closes."""
    def line(t):
        r = big + small * math.cos(q * t)
        return (r * math.cos(p * t), small * math.sin(q * t), r * math.sin(p * t))

    points = []
    for k in range(along):
        t, step = TURN * k / along, 1e-4
        here, ahead, behind = line(t), line(t + step), line(t - step)
        forward = unit(minus(ahead, behind))
        centre = (big * math.cos(p * t), 0.0, big * math.sin(p * t))
        out = minus(here, centre)
        out = unit(minus(out, scaled(forward, dot(out, forward))))
        side = cross(forward, out)
        for s in range(around):
            a = TURN * s / around
            points.append(tuple(c + tube * (math.cos(a) * o + math.sin(a) * w)
                                for c, o, w in zip(here, out, side)))
    low = min(y for _, y, _ in points)
    points = [(x, y - low, z) for x, y, z in points]
    at = lambda k, s: (k % along) * around + s % around
    faces = [(at(k, s), at(k + 1, s), at(k + 1, s + 1), at(k, s + 1))
             for k in range(along) for s in range(around)]
    return points, [tuple(reversed(f)) for f in faces]


def bracket(length, thickness, width, hole, corners):
    """An angle bracket with a round hole in each leg, triangulated as CAD exports are: each flat side as a
    few fans of long, thin triangles between its outline and the hole."""
    points, faces, known = [], [], {}

    def point(p):
        key = tuple(round(c, 9) for c in p)
        if key not in known:
            known[key] = len(points)
            points.append(p)
        return known[key]

    def leg(place):
        """A plate with a hole: place(u, v, w) puts u along the leg, v across, w through it."""
        outline = [(0.0, 0.0), (length, 0.0), (length, width), (0.0, width)]
        centre = (length * 0.58, width / 2)
        ring = [(centre[0] + hole * math.cos(TURN * i / corners), centre[1] + hole * math.sin(TURN * i / corners))
                for i in range(corners)]
        sides = []
        # From each corner of the hole to the corner of the outline that its direction points at.
        nearest = [max(range(4), key=lambda c, r=r: dot2(unit2((outline[c][0] - centre[0], outline[c][1] - centre[1])),
                                                         unit2((r[0] - centre[0], r[1] - centre[1]))))
                   for r in ring]
        for i in range(corners):
            a, b = ring[i], ring[(i + 1) % corners]
            ca, cb = nearest[i], nearest[(i + 1) % corners]
            sides.append((a, outline[ca], b))
            if ca != cb:
                sides.append((outline[ca], outline[cb], b))
        for triangle in sides:
            faces.append(tuple(point(place(u, v, thickness)) for u, v in triangle))
            faces.append(tuple(point(place(u, v, 0.0)) for u, v in reversed(triangle)))
        for a, b in zip(ring, ring[1:] + ring[:1]):
            wall(place, b, a)
        return outline

    def wall(place, a, b):
        faces.append(tuple(point(place(u, v, w)) for u, v, w in
                           ((*a, thickness), (*a, 0.0), (*b, 0.0), (*b, thickness))))

    t = thickness
    lying = lambda u, v, w: (u + t, w, width / 2 - v)
    standing = lambda u, v, w: (w, u + t, v - width / 2)
    for place in (lying, standing):
        o = leg(place)
        for a, b in ((o[0], o[1]), (o[1], o[2]), (o[2], o[3])):
            wall(place, a, b)
    # The square bar in the corner, open where the legs go on.
    z0, z1 = -width / 2, width / 2
    box = lambda x, y, z: point((x, y, z))
    faces.append((box(0, 0, z0), box(t, 0, z0), box(t, 0, z1), box(0, 0, z1)))
    faces.append((box(0, 0, z0), box(0, 0, z1), box(0, t, z1), box(0, t, z0)))
    faces.append((box(0, 0, z1), box(t, 0, z1), box(t, t, z1), box(0, t, z1)))
    faces.append((box(0, t, z0), box(t, t, z0), box(t, 0, z0), box(0, 0, z0)))
    return points, faces


def sheet(width, height, columns, rows, uneven):
    """A single sheet that stands on the ground, of triangles that differ: inner points are moved by up to so much of
    a cell, and the diagonals alternate."""
    random = lambda i: (i * 2654435761 % 4294967296) / 2147483648 - 1
    points, faces = [], []
    for r in range(rows + 1):
        for c in range(columns + 1):
            inner = 0 < r < rows and 0 < c < columns
            i = 2 * (r * (columns + 1) + c) + 1
            x, y = (c + uneven * random(i) * inner) / columns, (r + uneven * random(i + 1) * inner) / rows
            points.append(((x - 0.5) * width, y * height, 0.0))
    at = lambda r, c: r * (columns + 1) + c
    for r in range(rows):
        for c in range(columns):
            a, b, d, e = at(r, c), at(r, c + 1), at(r + 1, c + 1), at(r + 1, c)
            faces += [(a, b, d), (a, d, e)] if (r + c) % 2 == 0 else [(a, b, e), (b, d, e)]
    return points, faces


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scaled(a, s):
    return tuple(x * s for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def dot2(a, b):
    return a[0] * b[0] + a[1] * b[1]


def unit2(a):
    length = math.hypot(*a)
    return (a[0] / length, a[1] / length)


def unit(a):
    return scaled(a, 1 / math.sqrt(dot(a, a)))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def write_obj(path, name, material, shape):
    points, faces = shape
    lines = ["# made by make_shapes.py, metres", f"o {name}", f"usemtl {material}"]
    lines += ["v " + " ".join(f"{c + 0.0:.7g}" for c in p) for p in points]
    lines += ["f " + " ".join(str(i + 1) for i in f) for f in faces]
    with open(path, "w", newline="\n") as file:
        file.write("\n".join(lines) + "\n")


SHAPES = {
    "sphere": ("porcelain", lambda: sphere(40, 64, 0.25)),
    "plate": ("steel", lambda: plate(1.0, 0.7, 0.003, 40, 28)),
    "knot": ("copper", lambda: knot(2, 3, 0.32, 0.14, 0.07, 20, 260)),
    "sheet": ("paint", lambda: sheet(1.2, 0.75, 5, 3, 0.25)),
    "bracket": ("zinc", lambda: bracket(0.09, 0.006, 0.05, 0.012, 48)),
}


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    for name, (material, make) in SHAPES.items():
        write_obj(os.path.join(folder, name + ".obj"), name, material, make())


if __name__ == "__main__":
    main()
