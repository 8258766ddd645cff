"""Sheets without thickness: polygons in a material, grids of them, and the OBJ file they end in.

A point is a tuple (x, y, z) in metres, +Y up, +Z forward, +X to the car's left. A sheet is a
list of (material, polygon), the polygon a tuple of three or four points, counter-clockwise seen
from its front. Points of different sheets that agree to a micrometre become one vertex, so
neighbouring patches must share the points of their common border, never just the curve.
"""

import math
from bisect import bisect_right


def lerp(a, b, t):
    return a + (b - a) * t


def mix(p, q, t):
    """The point at fraction t of the segment pq; exact at both ends."""
    return p if t == 0 else q if t == 1 else tuple(lerp(a, b, t) for a, b in zip(p, q))


def smoothstep(low, high, x):
    t = min(1.0, max(0.0, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)


def minus(p, q):
    return tuple(a - b for a, b in zip(p, q))


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def smooth_curve(knots):
    """Monotone cubic through (x, y) knots of rising x, constant beyond the ends.

    Based on: F. N. Fritsch and J. Butland, "A method for constructing local monotone piecewise
    cubic interpolants", 1984. It never overshoots a hand-placed knot.
    """
    xs, ys = zip(*knots)
    widths = [b - a for a, b in zip(xs, xs[1:])]
    slopes = [(b - a) / w for a, b, w in zip(ys, ys[1:], widths)]
    tangents = [slopes[0]]
    for left, right in zip(slopes, slopes[1:]):
        tangents.append(2 * left * right / (left + right) if left * right > 0 else 0.0)
    tangents.append(slopes[-1])

    def evaluate(x):
        x = min(xs[-1], max(xs[0], x))
        i = min(len(widths) - 1, bisect_right(xs, x) - 1)
        w, t = widths[i], (x - xs[i]) / widths[i]
        return (ys[i] * (1 + 2 * t) * (1 - t) ** 2 + ys[i + 1] * t * t * (3 - 2 * t)
                + w * t * (1 - t) * (tangents[i] * (1 - t) - tangents[i + 1] * t))

    return evaluate


def facing(sheet, viewer):
    """The sheet, turned over as a whole if most of it shows its back to the viewer."""
    seen = 0.0
    for _, polygon in sheet:
        normal = cross(minus(polygon[1], polygon[0]), minus(polygon[2], polygon[0]))
        seen += dot(normal, minus(viewer, polygon[0]))
    return sheet if seen > 0 else reversed_sheet(sheet)


def reversed_sheet(sheet):
    return [(material, polygon[::-1]) for material, polygon in sheet]


def mirrored(sheet):
    """The sheet reflected in the plane x = 0, its front still outside."""
    return [(material, tuple((-x if x else x, y, z) for x, y, z in polygon[::-1]))
            for material, polygon in sheet]


def moved(sheet, offset):
    return [(material, tuple(tuple(a + b for a, b in zip(p, offset)) for p in polygon))
            for material, polygon in sheet]


def grid(rows, paint, viewer=None, seams=(), seam_width=0.012):
    """The cells between neighbouring rows of points, rows being of one length.

    paint(row, column) names a cell's material, None leaves a hole. Along each column of points
    in `seams` the sheet shows a dark panel gap, which closes in a point on the first and the last
    row, so that the patches beyond them need not know of it; on the plane x = 0 it stays open.
    """
    sheet = []
    inner = range(1, len(rows) - 1)
    sides = [[_split(rows, r, c, seam_width) if c in seams and (r in inner or p[0] == 0) else (p, p)
              for c, p in enumerate(row)] for r, row in enumerate(rows)]
    for r, (low, high) in enumerate(zip(sides, sides[1:])):
        for c in range(len(low) - 1):
            material = paint(r, c)
            if material:
                sheet.append((material, (low[c][1], low[c + 1][0], high[c + 1][0], high[c][1])))
        for c in seams:
            sheet.append(("trim", (low[c][0], low[c][1], high[c][1], high[c][0])))
    sheet = [(material, polygon) for material, polygon in map(_without_repeats, sheet)
             if len(polygon) > 2]
    return facing(sheet, viewer) if viewer else sheet


def _split(rows, r, c, width):
    """Both banks of a seam at a point of the grid, half the width from its course."""
    here, course = rows[r][c], minus(rows[min(r + 1, len(rows) - 1)][c],
                                        rows[max(r - 1, 0)][c])
    banks = []
    for neighbour in (rows[r][c - 1], rows[r][c + 1]):
        side = minus(neighbour, here)
        clear = cross(side, course)
        distance = math.sqrt(dot(clear, clear) / dot(course, course))
        banks.append(mix(here, neighbour, width / 2 / distance))
    return banks


def _without_repeats(face):
    material, polygon = face
    return material, tuple(p for i, p in enumerate(polygon) if p != polygon[i - 1])


def fan(loop, tip, material, viewer):
    """Triangles from the tip to each segment of an open or closed polyline."""
    return facing([(material, (a, b, tip)) for a, b in zip(loop, loop[1:])], viewer)


def smallest_angle(a, b, c):
    def corner(p, q, r):
        u, v = minus(q, p), minus(r, p)
        length = math.sqrt(dot(u, u) * dot(v, v))
        return math.acos(max(-1.0, min(1.0, dot(u, v) / length))) if length else 0.0
    return min(corner(a, b, c), corner(b, c, a), corner(c, a, b))


def triangles(polygon):
    """The polygon's triangles; a quad is split along the diagonal that leaves the wider angles."""
    if len(polygon) == 3:
        return [polygon]
    a, b, c, d = polygon
    splits = ([(a, b, c), (a, c, d)], [(b, c, d), (b, d, a)])
    return max(splits, key=lambda split: round(min(smallest_angle(*t) for t in split), 9))


class ObjFile:
    """Parts in the order they were added, faces of one part grouped by material."""

    def __init__(self):
        self._index_of = {}
        self._parts = []

    def add(self, name, sheet):
        by_material = {}
        for material, polygon in sheet:
            for triangle in triangles(polygon):
                by_material.setdefault(material, []).append([self._index(p) for p in triangle])
        self._parts.append((name, by_material))

    def triangle_count(self):
        return sum(len(faces) for _, groups in self._parts for faces in groups.values())

    def text(self, title, library=None, uv=None):
        """With a library of materials, uv(point, normal) places the faces of "paint" in its image."""
        points, uvs = list(self._index_of), {}
        faces = []
        for name, groups in self._parts:
            faces.append("o " + name)
            for material, triangles_of in groups.items():
                faces += ["g " + name + "_" + material, "usemtl " + material]
                for face in triangles_of:
                    corners = [str(index) for index in face]
                    if uv and material == "paint":
                        a, b, c = (points[index - 1] for index in face)
                        normal = cross(minus(b, a), minus(c, a))
                        placed = ["{:.5f} {:.5f}".format(*uv(point, normal)) for point in (a, b, c)]
                        corners = [f"{index}/{uvs.setdefault(at, len(uvs) + 1)}"
                                   for index, at in zip(face, placed)]
                    faces.append("f " + " ".join(corners))
        lines = ["# " + title] + (["mtllib " + library] if library else [])
        lines += ["v " + " ".join(f"{x:.6f}" for x in point) for point in points]
        lines += ["vt " + at for at in uvs]
        return "\n".join(lines + faces) + "\n"

    def _index(self, point):
        key = tuple(round(x, 6) + 0.0 for x in point)
        return self._index_of.setdefault(key, len(self._index_of) + 1)
