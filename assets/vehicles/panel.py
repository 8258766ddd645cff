"""Turns the drawing of a panel into a sheet of well-shaped triangles.

A drawing is a list of regions in the plane, painted one over the other: (material, polygon). The
first is the outline of the panel; None as the material leaves a hole. Borders of regions become
edges of the sheet. Polygons may cross and share borders.
"""

import math

from delaunay import Triangulation, orientation


def rectangle(u0, v0, u1, v1):
    return [(u0, v0), (u1, v0), (u1, v1), (u0, v1)]


def arc(centre, radius, start, end, count):
    """count + 1 points of a circle, between two angles in degrees."""
    angles = [math.radians(start + (end - start) * i / count) for i in range(count + 1)]
    return [(centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)) for t in angles]


def inset(loop, width):
    """A counter-clockwise polygon with its borders moved inwards by the width."""
    normals = []
    for (x0, y0), (x1, y1) in zip(loop, loop[1:] + loop[:1]):
        length = math.dist((x0, y0), (x1, y1))
        normals.append(((y0 - y1) / length, (x1 - x0) / length))
    corners = []
    for i, (x, y) in enumerate(loop):
        (a, b), (c, d) = normals[i - 1], normals[i]
        mitre = width / (1 + a * c + b * d)
        corners.append((x + (a + c) * mitre, y + (b + d) * mitre))
    return corners


def leaf(material, polygon, gap=0.009):
    """Regions for a door or a lid in a panel: the gap around it, and the leaf itself."""
    return [(None, polygon), (material, inset(polygon, gap))]


def crossed(line, regions):
    """The polyline with a point wherever the border of a region crosses it."""
    points = line[:1]
    for a, b in zip(line, line[1:]):
        cuts = {}
        for _, polygon in regions:
            for c, d in zip(polygon, polygon[1:] + polygon[:1]):
                cuts.update(_cuts(a, b, c, d))
        for t in sorted(cuts):
            if min(t, 1 - t) * math.dist(a, b) > 1e-4 and math.dist(points[-1], cuts[t]) > 1e-4:
                points.append(cuts[t])
        points.append(b)
    return points


def split(line, length):
    """The polyline with each segment in equal pieces that are no longer than `length`."""
    points = line[:1]
    for p, q in zip(line, line[1:]):
        count = max(1, math.ceil(math.dist(p, q) / length - 1e-5))
        points += [tuple(a + (b - a) * i / count for a, b in zip(p, q)) for i in range(1, count)]
        points.append(q)
    return points


def panel(regions, edge, lift, pinned=None, folds=()):
    """The sheet of a drawing, its edges about `edge` long.

    lift(u, v) is the point of space of a point of the plane; `pinned` gives points that are to be
    met to the bit, by their snapped() points of the plane, as where the border is another panel's
    too. Along the segments `folds` (pairs of points) there are edges as well.
    """
    drawing = _Drawing(regions, edge, folds)
    for _ in range(2):
        drawing.relax()
    place = {}
    for i, p in enumerate(drawing.points):
        key = snapped(p)
        place[i] = pinned[key] if pinned and key in pinned else lift(*p)
    return [(material, tuple(place[i] for i in face)) for material, face in drawing.faces()]


def pins(points, lift):
    """For panel(): the points of a border as `lift` places them."""
    return {snapped(p): lift(*p) for p in points}


def snapped(p):
    """A point of the plane to a tenth of a micrometre, as drawings hold them."""
    return (round(p[0], 7), round(p[1], 7))


class _Drawing:
    def __init__(self, regions, edge, folds):
        self.regions, self.edge = regions, edge
        self.points, self._index = [], {}
        segments = _crossed([(snapped(p), snapped(q)) for _, polygon in regions
                             for p, q in zip(polygon, polygon[1:] + polygon[:1])]
                            + [(snapped(p), snapped(q)) for p, q in folds])
        self._check_outline(segments)
        self.segments = sorted({tuple(sorted((i, j))) for p, q in segments for i, j in
                                self._pieces(p, q)})
        self.fixed = len(self.points)
        self._fill()
        self.shifted = self._shift()

    def _check_outline(self, pieces):
        """The short segments of the outline may be another panel's too: none may be cut."""
        pieces = {frozenset(piece) for piece in pieces}
        outline = [snapped(p) for p in self.regions[0][1]]
        for p, q in zip(outline, outline[1:] + outline[:1]):
            assert math.dist(p, q) > self.edge or frozenset((p, q)) in pieces, (
                f"the border of a region cuts the outline between {p} and {q}")

    def _point(self, p):
        key = snapped(p)
        if key not in self._index:
            self._index[key] = len(self.points)
            self.points.append(p)
        return self._index[key]

    def _pieces(self, p, q):
        p, q = min(p, q), max(p, q)     # the same pieces from either side
        line = [self._point(x) for x in split([p, q], self.edge)]
        return zip(line, line[1:])

    def _fill(self):
        """Adds a lattice of points that keep clear of all borders."""
        outline = self.regions[0][1]
        low = [min(p[k] for p in outline) for k in (0, 1)]
        high = [max(p[k] for p in outline) for k in (0, 1)]
        rise = self.edge * math.sqrt(3) / 2
        rows = int((high[1] - low[1]) / rise) + 1
        columns = int((high[0] - low[0]) / self.edge) + 1
        ends = [(self.points[i], self.points[j]) for i, j in self.segments]
        for r in range(rows + 1):
            for c in range(columns + 1):
                p = (low[0] + (c + 0.5 * (r % 2)) * self.edge, low[1] + (r + 0.3) * rise)
                if self._material(p) and all(_clear(p, *s) > 0.55 * self.edge for s in ends):
                    self.points.append(p)

    def _shift(self):
        """The points moved by a millionth of an edge, so that none lie on a line or a circle."""
        state, moved = 1, []
        for p in self.points:
            shift = []
            for _ in range(2):
                state = state * 1103515245 + 12345 & 0x7fffffff
                shift.append((state / 0x7fffffff - 0.5) * 1e-6 * self.edge)
            moved.append((p[0] + shift[0], p[1] + shift[1]))
        return moved

    def _triangles(self):
        found = Triangulation(self.shifted)
        for i, j in self.segments:
            found.require(i, j)
        return found.triangles()

    def relax(self):
        """Moves the points inside to the middle of their neighbours."""
        around = {}
        for face in self._triangles():
            for k in range(3):
                around.setdefault(face[k], set()).update((face[k - 1], face[k - 2]))
        for i in range(self.fixed, len(self.points)):
            near = sorted(around[i])
            self.points[i] = tuple(sum(self.points[j][k] for j in near) / len(near)
                                   for k in (0, 1))
        self.shifted = self._shift()

    def faces(self):
        for face in self._triangles():
            a, b, c = (self.points[i] for i in face)
            if orientation(a, b, c) < 1e-5 * self.edge * self.edge:
                continue                      # between points of one straight border
            if material := self._material(tuple(sum(x) / 3 for x in zip(a, b, c))):
                yield material, face

    def _material(self, p):
        found = None
        for i, (material, polygon) in enumerate(self.regions):
            if _inside(p, polygon):
                found = material
            elif i == 0:
                return None
        return found


def _inside(p, polygon):
    inside = False
    for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1]):
        if (y0 > p[1]) != (y1 > p[1]) and p[0] < x0 + (p[1] - y0) * (x1 - x0) / (y1 - y0):
            inside = not inside
    return inside


def _clear(p, a, b):
    """The distance of a point from a segment."""
    ux, uy = b[0] - a[0], b[1] - a[1]
    t = ((p[0] - a[0]) * ux + (p[1] - a[1]) * uy) / (ux * ux + uy * uy)
    t = min(1.0, max(0.0, t))
    return math.hypot(p[0] - a[0] - t * ux, p[1] - a[1] - t * uy)


def _crossed(segments):
    """The segments cut where they cross or touch each other."""
    segments = sorted({(min(s), max(s)) for s in segments if s[0] != s[1]})
    pieces = []
    for a, b in segments:
        cuts = {0.0: a, 1.0: b}
        for c, d in segments:
            if (c, d) != (a, b):
                cuts.update(_cuts(a, b, c, d))
        line, reached = [], -1.0
        for t in sorted(cuts):
            if (t - reached) * math.dist(a, b) > 1e-6:
                line.append(cuts[t])
                reached = t
        line[-1] = b
        pieces += zip(line, line[1:])
    return pieces


def _cuts(a, b, c, d):
    """{share of ab: point} where cd crosses ab or ends on it."""
    length = math.dist(a, b)
    found = {}
    for p in (c, d):
        t = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / length ** 2
        if 0 < t < 1 and abs(orientation(a, b, p)) < 1e-6 * length:
            found[t] = p
    if found:
        return found
    s0, s1 = orientation(a, b, c), orientation(a, b, d)
    t0, t1 = orientation(c, d, a), orientation(c, d, b)
    if s0 * s1 < 0 and t0 * t1 < 0:
        far_from_ends = (min(abs(t0), abs(t1)) > 1e-6 * math.dist(c, d)
                         and min(abs(s0), abs(s1)) > 1e-6 * length)
        if far_from_ends:
            # The same point for either order of the two segments.
            (e, f), (g, h) = sorted(((a, b), (c, d)))
            r0, r1 = orientation(g, h, e), orientation(g, h, f)
            r = r0 / (r0 - r1)
            found[t0 / (t0 - t1)] = snapped((e[0] + r * (f[0] - e[0]), e[1] + r * (f[1] - e[1])))
    return found
