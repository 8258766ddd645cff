"""An OBJ file of named parts, and what can be wrong with it as a mesh of sheets."""
import math
from collections import defaultdict


class PartMesh:
    """Triangles with their parts: `faces` holds vertex indices, `parts` maps a name to its faces.

    Objects and groups both count as parts, as in a scene. `component` numbers, face by face, what
    hangs together by edges.
    """

    def __init__(self, text):
        self.points, self.faces, self.parts, self.materials = [], [], defaultdict(list), set()
        names = {}
        for line in text.splitlines():
            key, *rest = line.split()
            if key == "v":
                self.points.append(tuple(map(float, rest)))
            elif key in "og":
                names = {"o": rest[0]} if key == "o" else {**names, "g": rest[0]}
            elif key == "usemtl":
                self.materials.add(rest[0])
            elif key == "f":
                for name in names.values():
                    self.parts[name].append(len(self.faces))
                self.faces.append(tuple(int(corner) - 1 for corner in rest))
        self.component = self._components()

    def _components(self):
        by_edge = defaultdict(list)
        for f, face in enumerate(self.faces):
            for k in range(3):
                by_edge[frozenset((face[k], face[k - 1]))].append(f)
        number, count = [None] * len(self.faces), 0
        for start in range(len(self.faces)):
            if number[start] is not None:
                continue
            number[start], reached = count, [start]
            while reached:
                face = self.faces[reached.pop()]
                for k in range(3):
                    for other in by_edge[frozenset((face[k], face[k - 1]))]:
                        if number[other] is None:
                            number[other] = count
                            reached.append(other)
            count += 1
        return number

    def nearest(self, part, p):
        """(distance, face) of the face of a part that is nearest to a point."""
        best = (math.inf, None)
        for f in self.parts[part]:
            corners = self.corners(f)
            if all(min(c[k] for c in corners) - best[0] < p[k] < max(c[k] for c in corners) + best[0] for k in range(3)):
                best = min(best, (distance_to(p, corners), f))
        return best

    def corners(self, face):
        return [self.points[v] for v in self.faces[face]]

    def faults(self):
        """Sentences about edges of more than two faces, faces turned over, slivers, T-junctions."""
        directed, found = set(), []
        for face in self.faces:
            if len(set(face)) < 3 or self._height(face) < 1e-5:
                found.append(f"a face without area at {self.points[face[0]]}")
            for k in range(3):
                edge = (face[k - 1], face[k])
                if edge in directed:
                    found.append(f"two faces run along an edge the same way at {self.points[edge[0]]}")
                directed.add(edge)
        border = sorted((a, b) for a, b in directed if (b, a) not in directed)
        return found + self._hanging(border)

    def _height(self, face):
        a, b, c = (self.points[v] for v in face)
        u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
        area = math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        return area / max(math.dist(a, b), math.dist(b, c), math.dist(c, a))

    def _hanging(self, border):
        """Vertices of a border that lie on an edge of the border of the same component."""
        owner = {}
        for f, face in enumerate(self.faces):
            owner.update((v, self.component[f]) for v in face)
        cells, size = defaultdict(list), 0.1
        for v in sorted({v for edge in border for v in edge}):
            cells[tuple(int(x // size) for x in self.points[v])].append(v)
        found = []
        for a, b in border:
            p, q = self.points[a], self.points[b]
            for v in self._within(cells, size, p, q):
                if v not in (a, b) and owner[v] == owner[a] and _off(self.points[v], p, q) < 1e-5:
                    found.append(f"a vertex hangs on an edge at {self.points[v]}")
        return found

    @staticmethod
    def _within(cells, size, p, q):
        ranges = [range(int((min(x, y) - 1e-5) // size), int((max(x, y) + 1e-5) // size) + 1)
                  for x, y in zip(p, q)]
        return [v for i in ranges[0] for j in ranges[1] for k in ranges[2] for v in cells.get((i, j, k), ())]


def _off(p, a, b):
    u, w = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, p)]
    length2 = sum(x * x for x in u)
    t = min(1.0, max(0.0, sum(x * y for x, y in zip(u, w)) / length2))
    return math.hypot(*(y - t * x for x, y in zip(u, w)))


def distance_to(p, triangle):
    """The distance of a point from a triangle, by its plane and by its edges."""
    a, b, c = triangle
    best = min(_off(p, a, b), _off(p, b, c), _off(p, c, a))
    u, v, w = ([y - x for x, y in zip(a, q)] for q in (b, c, p))
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    if not any(n):
        return best
    sides = []
    for r, q in ((a, b), (b, c), (c, a)):
        e, o = [y - x for x, y in zip(r, q)], [y - x for x, y in zip(r, p)]
        sides.append(sum(x * y for x, y in zip(n, (e[1] * o[2] - e[2] * o[1], e[2] * o[0] - e[0] * o[2],
                                                   e[0] * o[1] - e[1] * o[0]))))
    if min(sides) >= 0:
        best = min(best, abs(sum(x * y for x, y in zip(n, w))) / math.hypot(*n))
    return best
