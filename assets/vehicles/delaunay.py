"""Constrained Delaunay triangulation of points in the plane, in plain Python.

Based on: J. R. Shewchuk, "Lecture notes on Delaunay mesh generation", 2012 (insertion by digging
cavities), and S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations",
1993 (segments recovered by flips).
"""


def orientation(a, b, c):
    """Twice the signed area of a triangle, positive if it is counter-clockwise."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def in_circle(a, b, c, p):
    """Positive if p is inside the circle through the counter-clockwise triangle abc."""
    ax, ay, bx, by, cx, cy = (a[0] - p[0], a[1] - p[1], b[0] - p[0], b[1] - p[1], c[0] - p[0],
                              c[1] - p[1])
    a2, b2, c2 = ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy
    return ax * (by * c2 - b2 * cy) - ay * (bx * c2 - b2 * cx) + a2 * (bx * cy - by * cx)


class Triangulation:
    """Triangles of point indices, kept as the apex that lies left of each directed edge.

    Precondition: no four of the points lie on a circle and no three on a line. Callers that have
    such points shift each by a tiny, fixed amount.
    """

    def __init__(self, points):
        low = [min(p[k] for p in points) for k in (0, 1)]
        high = [max(p[k] for p in points) for k in (0, 1)]
        size = 40 * max(high[0] - low[0], high[1] - low[1])
        x, y = (low[0] + high[0]) / 2, (low[1] + high[1]) / 2
        n = self.count = len(points)
        self.points = list(points) + [(x - size, y - 0.71 * size), (x + size, y - 0.69 * size),
                                      (x + 0.013 * size, y + size)]
        self.apex = {}
        self._add(n, n + 1, n + 2)
        self._last = (n, n + 1)
        for i in range(n):
            self._insert(i)

    def triangles(self):
        """The triangles of the given points, each once, in a fixed order."""
        return sorted((a, b, c) for (a, b), c in self.apex.items()
                      if a < b and a < c and max(b, c) < self.count)

    def require(self, a, b):
        """Makes ab an edge. Precondition: no point and no required edge lies across it."""
        crossing = self._crossing(a, b) if (a, b) not in self.apex else []
        while crossing:
            u, v = crossing.pop(0)
            p, q = self.apex[u, v], self.apex[v, u]
            if self._side(p, q, u) * self._side(p, q, v) >= 0 or not self._convex(u, q, v, p):
                crossing.append((u, v))
                continue
            self._remove(u, v, p)
            self._remove(v, u, q)
            self._add(p, u, q)
            self._add(q, v, p)
            if {p, q} != {a, b} and not {p, q} & {a, b} and (
                    self._side(a, b, p) * self._side(a, b, q) < 0):
                crossing.append((p, q))

    def _side(self, a, b, c):
        return orientation(self.points[a], self.points[b], self.points[c])

    def _convex(self, a, b, c, d):
        loop = (a, b, c, d)
        return all(self._side(loop[i - 2], loop[i - 1], loop[i]) > 0 for i in range(4))

    def _crossing(self, a, b):
        """The edges that the segment ab crosses."""
        start = next((u, v) for (u, v), w in self.apex.items() if w == a
                     and self._side(a, b, u) < 0 < self._side(a, b, v)
                     and self._side(u, v, b) < 0)
        found, (u, v) = [start], start
        while (w := self.apex[v, u]) != b:
            if self._side(a, b, w) < 0:
                u = w
            else:
                v = w
            found.append((u, v))
        return found

    def _add(self, a, b, c):
        self.apex[a, b], self.apex[b, c], self.apex[c, a] = c, a, b

    def _remove(self, a, b, c):
        del self.apex[a, b], self.apex[b, c], self.apex[c, a]

    def _locate(self, i):
        """A directed edge of the triangle that contains the point."""
        u, v = self._last if self._last in self.apex else next(iter(self.apex))
        while True:
            w = self.apex[u, v]
            for a, b in ((u, v), (v, w), (w, u)):
                if self._side(a, b, i) < 0:
                    u, v = b, a
                    break
            else:
                return u, v

    def _insert(self, i):
        u, v = self._locate(i)
        w = self.apex[u, v]
        self._remove(u, v, w)
        open_edges = [(u, v), (v, w), (w, u)]
        while open_edges:
            a, b = open_edges.pop()
            c = self.apex.get((b, a))
            if c is not None and in_circle(self.points[b], self.points[a], self.points[c],
                                           self.points[i]) > 0:
                self._remove(b, a, c)
                open_edges += [(a, c), (c, b)]
            else:
                self._add(a, b, i)
                self._last = (a, b)
