"""A closed body of sheet, drawn as panels: two sides, the deck that wraps over them, the floor.

    side    drawn in (z, y), with its wheel arches; half_width(z, y) says how far out it lies
    deck    drawn in (station, u): station i is the corner i of the outline, which runs from the
            lower edge of the nose over bonnet, glass and roof to the lower edge of the tail;
            u is 0 in the middle of the vehicle and 1 at its side
    arches  the lining of the wheel housings, from the arch to the inner wall
    floor   what lies between the lower edges

A material "door:paint" belongs to the part `door`, one without a colon to `body`; a star in the
name of a part becomes left or right. Neighbouring panels share the points of their borders.
"""

import math
from bisect import bisect_right

from car_sheet import facing, grid, lerp, mirrored
from panel import arc, crossed, panel, pins, snapped, split

EDGE = 0.16              # m, of the faces


class Coachwork:
    def __init__(self, outline, half_width, axles, arch, hub_height, inner, folds=(),
                 edge=EDGE):
        """outline: corners (z, y, dz, dy), from the side of the vehicle to its middle by (dz, dy).

        arch: radius of the wheel arches; inner: x of the walls of the wheel housings; folds: pairs
        of points (z, y) of the sides between which edges run.
        """
        self.outline, self.half_width, self.folds = outline, half_width, folds
        self.edge = edge
        self.axles, self.arch, self.hub, self.inner = axles, arch, hub_height, inner
        self.reach = [0.0]
        for (z0, y0, *_), (z1, y1, *_) in zip(outline, outline[1:]):
            self.reach.append(self.reach[-1] + math.dist((z0, y0), (z1, y1)))
        self.wide = max(half_width(z, y) for z, y, *_ in outline)

    def parts(self, side, deck, power=2.6):
        """{name: sheet} of the whole body for the regions of its side and its deck."""
        deck = [(material, [self.plane(*p) for p in polygon]) for material, polygon in deck]
        self._lay_borders(side, deck)
        half = (self._side(side) + self._deck(deck, power) + self._housings() + self._floor(power))
        parts = {}
        for sheet, name in ((half, "left"), (mirrored(half), "right")):
            for material, polygon in sheet:
                part, _, paint = material.rpartition(":")
                part = part.replace("*", name) or "body"
                parts.setdefault(part, []).append((paint, polygon))
        return parts

    # ---- borders --------------------------------------------------------------------------------

    def _lay_borders(self, side, deck):
        """Sets the points that panels share, with those where a region meets the border."""
        line = [self._at(reach) for reach, _ in crossed([(r, self.wide) for r in self.reach], deck)]
        self.upper = [snapped(p) for p in split(crossed(line, side), self.edge)]
        self.lower = [snapped(p) for p in split(crossed(self._lower_edge(), side), self.edge)]

    def _at(self, reach):
        station = self.station(reach)
        i = min(len(self.outline) - 2, int(station))
        (z0, y0, *_), (z1, y1, *_) = self.outline[i:i + 2]
        return (lerp(z0, z1, station - i), lerp(y0, y1, station - i))

    def _lower_edge(self):
        """Points (z, y) of the side's lower edge, rear to front, with the arches in it."""
        (front_z, front_y), (rear_z, rear_y) = self.outline[0][:2], self.outline[-1][:2]

        def low(z):
            return lerp(rear_y, front_y, (z - rear_z) / (front_z - rear_z))
        line, self.arcs = [(rear_z, rear_y)], []
        for axle in sorted(self.axles):
            drop = math.degrees(math.asin((low(axle) - self.hub) / self.arch))
            curve = [snapped(p) for p in arc((axle, self.hub), self.arch, 180 - drop, drop, 14)]
            self.arcs.append(curve)
            line += curve
        return line + [(front_z, front_y)]

    # ---- side -----------------------------------------------------------------------------------

    def side_lift(self, z, y):
        return (self.half_width(z, y), y, z)

    def _side(self, regions):
        loop = self.upper + self.lower[1:-1]
        drawn = [("paint", loop[::-1])] + regions
        return facing(panel(drawn, self.edge, self.side_lift, folds=self.folds), (99, 1, 0))

    # ---- deck -----------------------------------------------------------------------------------

    def station(self, reach):
        i = min(len(self.reach) - 2, max(0, bisect_right(self.reach, reach) - 1))
        return i + (reach - self.reach[i]) / (self.reach[i + 1] - self.reach[i])

    def plane(self, station, u):
        """The place in the drawing of the deck, in metres."""
        i = min(len(self.reach) - 2, int(station))
        return (lerp(self.reach[i], self.reach[i + 1], station - i), u * self.wide)

    def deck_point(self, station, u, power=2.6):
        i = min(len(self.outline) - 2, int(station))
        z, y, dz, dy = (lerp(a, b, station - i) for a, b in zip(self.outline[i],
                                                                self.outline[i + 1]))
        bulge = 1 - abs(u) ** power
        return (self.half_width(z, y) * u, y + dy * bulge, z + dz * bulge)

    def _deck(self, regions, power):
        def lift(a, b):
            return self.deck_point(self.station(a), b / self.wide, power)
        border, reach = [], 0.0
        for p, q in zip(self.upper[:1] + self.upper, self.upper):
            reach += math.dist(p, q)
            border.append((reach, self.wide))
        pinned = {}
        for place, (z, y) in zip(border, self.upper):
            pinned.update(pins([place], lambda a, b, z=z, y=y: self.side_lift(z, y)))
        across = self._across()
        for end, station in ((0.0, 0), (border[-1][0], len(self.outline) - 1)):
            for u in across[:-1]:
                point = self.deck_point(station, u, power)
                pinned.update(pins([(end, u * self.wide)], lambda a, b, point=point: point))
        loop = ([(0.0, u * self.wide) for u in across] + border[1:-1]
                + [(border[-1][0], u * self.wide) for u in across[::-1]])
        drawn = [("paint", loop)] + regions
        folds = [((reach, 0.0), (reach, self.wide)) for reach in self._bends()]
        return facing(panel(drawn, 1.15 * self.edge, lift, pinned, folds), (0, 99, 0))

    def _bends(self):
        """Where along the outline the deck is bent, so that edges follow the bend."""
        for i in range(1, len(self.outline) - 1):
            (z0, y0), (z1, y1), (z2, y2) = (corner[:2] for corner in self.outline[i - 1:i + 2])
            turn = (math.atan2(y2 - y1, z2 - z1) - math.atan2(y1 - y0, z1 - z0)) % (2 * math.pi)
            if min(turn, 2 * math.pi - turn) > math.radians(7):
                yield self.reach[i]

    def _across(self):
        count = math.ceil(self.wide / self.edge)
        return [i / count for i in range(count + 1)]

    # ---- below ----------------------------------------------------------------------------------

    def _housings(self):
        sheet = []
        for curve in self.arcs:
            middle = ((curve[0][0] + curve[-1][0]) / 2, self.hub)
            viewer = (self.half_width(*middle), middle[1], middle[0])
            lip = [self.side_lift(*p) for p in curve]
            between = [(lerp(x, self.inner, 0.5), y, z) for x, y, z in lip]
            wall = [(self.inner, y, z) for _, y, z in lip]
            sheet += grid([lip, between, wall], lambda r, c: "underbody", viewer)
            chord = self._chord(curve)
            sheet += facing(panel([("underbody", curve + chord[1:-1])], self.edge,
                                  lambda z, y: (self.inner, y, z)), (99, middle[1], middle[0]))
        return sheet

    def _chord(self, curve):
        """The lower edge of a housing's wall, front to rear."""
        return [snapped(p) for p in split([curve[-1], curve[0]], self.edge)]

    def _floor(self, power):
        last = len(self.outline) - 1
        points = [self.deck_point(0, u, power) for u in self._across()[:-1]]
        low = self.lower[::-1]
        ends = {curve[-1]: curve for curve in self.arcs}
        i = 0
        while i < len(low):
            points.append(self.side_lift(*low[i]))
            if curve := ends.get(low[i]):
                points += [(self.inner, y, z) for z, y in self._chord(curve)]
                i = low.index(curve[0])
                points.append(self.side_lift(*low[i]))
            i += 1
        points += [self.deck_point(last, u, power) for u in self._across()[-2::-1]]
        height = {(p[2], p[0]): p for p in points}
        (z0, y0), (z1, y1) = self.outline[0][:2], self.outline[-1][:2]
        pinned = {}
        for place, p in height.items():
            pinned.update(pins([place], lambda z, x, p=p: p))

        def lift(z, x):
            return (x, lerp(y0, y1, (z - z0) / (z1 - z0)), z)
        sheet = panel([("underbody", [(p[2], p[0]) for p in points])], 1.5 * self.edge, lift, pinned)
        return facing(sheet, (0, -99, 0))
