"""Finds where the parts of a vehicle touch, and writes the joints that hold them there.

A part is held component by component, a component being faces that share edges. What hold() is
told is which part hangs on which; where the joint sits follows from the meshes: at the nearest
points of the two, or at the points nearest to given places.
"""

import copy
import math

from car_sheet import dot, minus, mix, triangles


def nearest_on_triangle(p, a, b, c):
    """Based on: C. Ericson, "Real-Time Collision Detection", 2005, section 5.1.5."""
    ab, ac, ap = minus(b, a), minus(c, a), minus(p, a)
    d1, d2 = dot(ab, ap), dot(ac, ap)
    if d1 <= 0 and d2 <= 0:
        return a
    bp = minus(p, b)
    d3, d4 = dot(ab, bp), dot(ac, bp)
    if d3 >= 0 and d4 <= d3:
        return b
    vc = d1 * d4 - d3 * d2
    if vc <= 0 <= d1 and d3 <= 0:
        return mix(a, b, d1 / (d1 - d3))
    cp = minus(p, c)
    d5, d6 = dot(ab, cp), dot(ac, cp)
    if d6 >= 0 and d5 <= d6:
        return c
    vb = d5 * d2 - d1 * d6
    if vb <= 0 <= d2 and d6 <= 0:
        return mix(a, c, d2 / (d2 - d6))
    va = d3 * d6 - d5 * d4
    if va <= 0 and d4 >= d3 and d5 >= d6:
        return mix(b, c, (d4 - d3) / ((d4 - d3) + (d5 - d6)))
    v, w = vb / (va + vb + vc), vc / (va + vb + vc)
    return tuple(x + v * y + w * z for x, y, z in zip(a, ab, ac))


def squared(v):
    return dot(v, v)


class Component:
    """Triangles that hang together by edges, and the part that they belong to."""

    def __init__(self, part, faces):
        self.part, self.faces = part, faces
        self.points = sorted({p for face in faces for p in face})
        self.low = [min(p[k] for p in self.points) for k in range(3)]
        self.high = [max(p[k] for p in self.points) for k in range(3)]
        self.boxes = [(tuple(map(min, *f)), tuple(map(max, *f)), f) for f in faces]

    def part_within(self, low, high, within):
        """The faces whose boxes are within sqrt(within) of a box."""
        near = copy.copy(self)
        near.boxes = [box for box in self.boxes if _apart(low, high, box[0], box[1]) < within]
        return near

    def nearest(self, p, within=math.inf):
        """(squared distance, point, face) of what is nearest to p, None beyond sqrt(within)."""
        best = None
        if _apart(p, p, self.low, self.high) >= within:
            return None
        for low, high, face in self.boxes:
            if _apart(p, p, low, high) < within:
                q = nearest_on_triangle(p, *face)
                if (d := squared(minus(p, q))) < within:
                    within, best = d, (d, q, face)
        return best


def _apart(low, high, other_low, other_high):
    """The squared distance of two boxes."""
    x = max(low[0] - other_high[0], other_low[0] - high[0], 0.0)
    y = max(low[1] - other_high[1], other_low[1] - high[1], 0.0)
    z = max(low[2] - other_high[2], other_low[2] - high[2], 0.0)
    return x * x + y * y + z * z


def closest(a, b, within=math.inf):
    """(squared distance, (point, face) of a, (point, face) of b) of two components, or None."""
    if _apart(a.low, a.high, b.low, b.high) >= within:
        return None
    for p in a.points[::7]:
        within = min(within, 1e-12 + min(math.dist(p, q) for q in b.points[::7]) ** 2)
    best = None
    for first, second, swap in ((a, b, False), (b, a, True)):
        near = second.part_within(first.low, first.high, within)
        for low, high, face in first.part_within(second.low, second.high, within).boxes:
            for p in face + (_middle(face),):
                found = near.nearest(p, within)
                if found:
                    within = found[0]
                    ends = ((p, face), (found[1], found[2]))
                    best = (within, *(ends[::-1] if swap else ends))
    return best


def _middle(face):
    return tuple(sum(x) / 3 for x in zip(*face))


def components(parts):
    """The components of {name: sheet}; faces of two parts never belong to one."""
    found = []
    for name, sheet in parts.items():
        faces = [tuple(tuple(round(x, 6) + 0.0 for x in p) for p in t)
                 for _, polygon in sheet for t in triangles(polygon)]
        by_edge, reached = {}, [False] * len(faces)
        for i, face in enumerate(faces):
            for k in range(3):
                by_edge.setdefault(frozenset((face[k], face[k - 1])), []).append(i)
        for start in range(len(faces)):
            if reached[start]:
                continue
            reached[start], open_faces, own = True, [start], []
            while open_faces:
                i = open_faces.pop()
                own.append(i)
                for k in range(3):
                    for j in by_edge[frozenset((faces[i][k], faces[i][k - 1]))]:
                        if not reached[j]:
                            reached[j] = True
                            open_faces.append(j)
            found.append(Component(name, [faces[i] for i in sorted(own)]))
    return found


class Joints:
    """The joints of a vehicle, collected part by part."""

    def __init__(self, parts):
        self.all = []
        self._of = {}
        for component in components(parts):
            self._of.setdefault(component.part, []).append(component)

    def hold(self, part, to, places=(), radius=0.06):
        """Welds a part to another, and the components of the part to each other.

        It is welded at its points nearest to `places`, or else where the two are nearest.
        """
        mine = self._of[part]
        for place in places:
            self._weld(self._at(mine, place), self._at(self._of[to], place), radius)
        placed = [self._at(mine, place)[2] for place in places]
        held = [c for c in mine if c in placed] or self._of[to]
        self._hold_rest([c for c in mine if c not in held], held, radius)

    def hold_all(self, root, radius=0.06):
        """Welds every component to what is nearest of those that hang on the root part."""
        first = self._of[root][:1]
        self._hold_rest([c for own in self._of.values() for c in own if c not in first], first,
                        radius)

    def hold_together(self, part, radius=0.06):
        """Welds the components of a part to the one with the most faces, or to each other."""
        mine = self._of[part]
        largest = max(mine, key=lambda c: len(c.faces))
        self._hold_rest([c for c in mine if c is not largest], [largest], radius)

    def turn(self, kind, part, to, anchor, axis, **more):
        """A hinge or a hub: `part` turns on `to` about the axis through the anchor."""
        sides = (self._at(self._of[part], anchor), self._at(self._of[to], anchor))
        self._add(kind, sides, anchor, more.pop("radius", 0.08), {"axis": list(axis), **more})

    def seam(self, part, anchor, axis, limits, near, radius):
        """A hinge across a seam of one part, which acts once what it holds was cut out."""
        sides = [self._at(self._of[part], place) for place in near]
        self._add("hinge", sides, anchor, radius, {"axis": list(axis), "limits": limits})

    def together(self, part, gap, radius=0.06):
        """Welds the components of one part wherever they touch or nearly so, as those of a cage."""
        mine = self._of[part]
        for i, a in enumerate(mine):
            for b in mine[i + 1:]:
                if found := closest(a, b, gap * gap):
                    self._weld((*found[1], a), (*found[2], b), radius)

    def _hold_rest(self, rest, held, radius):
        """Welds what is nearest first, so that everything hangs on what it touches."""
        nearest = {}
        while rest:
            for a in rest:
                for b in held:
                    if (id(a), id(b)) not in nearest:
                        nearest[id(a), id(b)] = closest(a, b)
            a, b = min(((a, b) for a in rest for b in held),
                       key=lambda pair: nearest[id(pair[0]), id(pair[1])][0])
            found = nearest[id(a), id(b)]
            self._weld((*found[1], a), (*found[2], b), radius)
            rest.remove(a)
            held = held + [a]

    def _at(self, choice, place):
        """(point, face, component) of the components nearest to a place."""
        best, within = None, math.inf
        for component in choice:
            if found := component.nearest(place, within):
                within, best = found[0], (found[1], found[2], component)
        return best

    def _weld(self, a, b, radius):
        self._add("weld", (a, b), mix(a[0], b[0], 0.5), radius, {})

    def _add(self, kind, sides, anchor, radius, more):
        near = [list(self._own_point(*side)) for side in sides]
        self.all.append({"kind": kind, "parts": [side[2].part for side in sides],
                         "anchor": list(_rounded(anchor)), **more, "near": near, "radius": radius})

    def _own_point(self, point, face, component):
        """A point of the face, near the given one, where no other component of its part is."""
        others = [c for c in self._of[component.part] if c is not component]
        for share in (0.05, 0.12, 0.2, 0.3, 0.4, 0.5, 0.65, 0.8, 1.0):
            p = _rounded(mix(point, _middle(face), share))
            if not any(c.nearest(p, 1e-6) for c in others):
                break
        return p


def _rounded(p):
    return tuple(round(x, 5) + 0.0 for x in p)
