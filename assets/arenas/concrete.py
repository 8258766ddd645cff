"""Solid shapes of the arena: prisms, columns and walls, each closed and faced outwards."""

import math

from car_sheet import facing, grid, moved
from turned import box, turned

PLINTH = 0.95             # m, higher than the bumper of a vehicle


def prism(stations, half_width, paint, axis="x"):
    """A solid between the planes at -half_width and +half_width across its axis.

    stations: (place along the axis, lower height, upper height), places rising; where two are at
    one place there is a step. paint(side) names the material of "top", "bottom", "side" and "end".
    """
    def point(a, y, b):
        return (a, y, b) if axis == "x" else (b, y, a)

    across = (-half_width, half_width)
    top = [[point(a, high, b) for a, _, high in stations] for b in across]
    bottom = [[point(a, low, b) for a, low, _ in stations] for b in across]
    sheet = grid(top, lambda r, c: paint("top"), (0, 999, 0))
    sheet += grid(bottom, lambda r, c: paint("bottom"), (0, -999, 0))
    for b in across:
        flank = [(paint("side"), tuple(point(a, y, b) for a, y in triangle))
                 for triangle in _flank(stations)]
        sheet += facing(flank, point(0, 0, 999 * b))
    for i, sign in ((0, -1), (-1, 1)):
        end = [[bottom[0][i], bottom[1][i]], [top[0][i], top[1][i]]]
        if stations[i][1] < stations[i][2]:
            sheet += grid(end, lambda r, c: paint("end"), point(999 * sign, 0, 0))
    return sheet


def _flank(stations):
    """Triangles (place, height) of a prism's side view, with the corners of steps in them."""
    def heights(i):
        found = {y for place, *ends in stations if place == stations[i][0] for y in ends}
        return sorted(y for y in found if stations[i][1] <= y <= stations[i][2])

    for i, ((a, *_), (b, *_)) in enumerate(zip(stations, stations[1:])):
        if a == b:
            continue
        left = [(a, y) for y in heights(i)]
        right = [(b, y) for y in heights(i + 1)]
        yield from ((right[0], p, q) for q, p in zip(left, left[1:]))
        yield from ((left[-1], p, q) for p, q in zip(right, right[1:]))


def frustum(base, top, height, paint):
    """A low hill with four slopes: half sizes at its foot and at its top."""
    foot = [(-base, 0, -base), (base, 0, -base), (base, 0, base), (-base, 0, base)]
    head = [(-top, height, -top), (top, height, -top), (top, height, top), (-top, height, top)]
    slopes = grid([foot + foot[:1], head + head[:1]], lambda r, c: paint("side"), (0, 999, 0))
    return slopes + grid([[head[0], head[1]], [head[3], head[2]]], lambda r, c: paint("top"),
                         (0, 999, 0))


def column(height):
    """An eight-sided column on a square foot, with a hazard band at bumper height."""
    foot = box((0, 0.2, 0), (1.5, 0.4, 1.5), "concrete_dark", top=0.86)
    shaft = turned(((0.55, 0.4), (0.5, 0.75), (0.5, 1.25), (0.48, height - 0.5),
                    (0.72, height - 0.2), (0.72, height), (0.0, height)), 8,
                   lambda r, c: "band" if r == 1 else "concrete")
    return foot + shaft


def barrier_block(length):
    """A road barrier of concrete along z, wide at its foot, on y = 0."""
    outline = ((0.32, 0.0), (0.32, 0.10), (0.13, 0.34), (0.09, 0.90), (-0.09, 0.90), (-0.13, 0.34),
               (-0.32, 0.10), (-0.32, 0.0))
    rows = [[(x, y, end * length / 2) for x, y in outline] for end in (1, -1)]
    sheet = grid(rows, lambda r, c: "band" if c in (2, 4) else "concrete", (0, 999, 0))
    for row, end in zip(rows, (1, -1)):
        halves = [[left, right] for left, right in zip(row[:4], row[:3:-1])]
        sheet += grid(halves, lambda r, c: "concrete", (0, 0, 999 * end))
    return sheet


def ring_wall(half_x, half_z, profile, paint, cells):
    """A wall around a rectangle of these half sizes: profile of (distance outwards, height)."""
    sheet = []
    for quarter in range(4):
        side, ahead = (half_x, half_z) if quarter % 2 == 0 else (half_z, half_x)
        rows = []
        for out, y in profile:
            reach = side + out
            line = [(-reach + 2 * reach * i / cells, y, ahead + out) for i in range(cells + 1)]
            rows.append([_quarter_turned(p, quarter) for p in line])
        sheet += [(paint(i), polygon) for i, strip in enumerate(zip(rows, rows[1:]))
                  for _, polygon in grid(list(strip)[::-1], lambda r, c: "any")]
    return sheet


def _quarter_turned(p, times):
    x, y, z = p
    for _ in range(times):
        x, z = z, -x
    return (x, y, z)


def turned_by(sheet, degrees, offset=(0, 0, 0)):
    """The sheet turned about the y axis, from +z towards +x by a positive angle, and moved."""
    s, c = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
    return moved([(material, tuple((x * c + z * s, y, z * c - x * s) for x, y, z in polygon))
                  for material, polygon in sheet], offset)


def plinth(radius, top):
    """A round foot, as wide at its foot as vehicles must keep away from what stands on it."""
    profile = ((radius, 0.0), (radius, 0.5), (top, PLINTH), (0.0, PLINTH))
    return turned(profile, 8, lambda r, c: "band" if r == 0 else "concrete")


def plinths(places):
    """The plinths below the lamp posts, gantries and stacks of an arena."""
    sheet = []
    for x, _, z, _ in places.get("lamp_post", ()):
        sheet += moved(plinth(0.65, 0.45), (x, 0, z))
    for x, _, z, degrees in places.get("gantry", ()):
        for side in (-4.2, 4.2):
            sheet += turned_by(moved(plinth(0.7, 0.5), (side, 0, 0)), degrees, (x, 0, z))
    for x, _, z, _ in places.get("stack", ()):
        sheet += moved(plinth(1.05, 0.8), (x, 0, z))
    return sheet
