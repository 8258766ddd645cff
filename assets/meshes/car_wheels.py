"""Wheels and axles. A wheel is one sheet of tyre and rim, turned about the x axis."""

import math

from car_sheet import fan, grid, mirrored, moved
from car_shape import AXLES, WHEEL_RADIUS

SPOKES, CELLS_PER_SPOKE, CELLS_PER_GAP = 5, 2, 3
CELLS = SPOKES * (CELLS_PER_SPOKE + CELLS_PER_GAP)
TRACK_X = 0.738
# (x, radius), from the inner bead over the tread to the outer bead, where the rim begins
TYRE = ((-0.090, 0.222), (-0.098, 0.280), (-0.070, WHEEL_RADIUS), (0.064, WHEEL_RADIUS),
        (0.096, 0.286), (0.090, 0.222))
RIM_LIP = (TYRE[-1], (0.082, 0.211), (0.062, 0.196))
SPOKE = (RIM_LIP[-1], (0.058, 0.13), (0.050, 0.060))
SPOKE_RIDGE = 0.014
HUB_TIP = (0.060, 0, 0)


def ring(x, radius, count=CELLS):
    """A closed polyline about the x axis, its first point straight below the centre."""
    points = [(x, -radius * math.cos(2 * math.pi * i / count),
               radius * math.sin(2 * math.pi * i / count)) for i in range(count)]
    return points + points[:1]


def tyre():
    return grid([ring(x, r) for x, r in TYRE[::-1]], lambda r, c: "tyre")


def rim():
    viewer = (9, 0, 0)
    period = CELLS_PER_SPOKE + CELLS_PER_GAP
    spokes = [ring(*SPOKE[0])] + [
        [(x + (SPOKE_RIDGE if i % period == 1 else 0), y, z) for i, (x, y, z) in
         enumerate(ring(*step))] for step in SPOKE[1:]]
    return (grid([ring(*step) for step in RIM_LIP], lambda r, c: "rim", viewer)
            + grid(spokes, lambda r, c: "rim" if c % period < CELLS_PER_SPOKE else None, viewer)
            + fan(spokes[-1], HUB_TIP, "chrome", viewer))


def wheel():
    """A left wheel at the origin, its rim facing +x, with its brake disc."""
    brake = fan(ring(-0.02, 0.13, 15), (-0.02, 0, 0), "axle", (9, 0, 0))
    return tyre() + rim() + brake


def wheels():
    """(name, sheet) of the four wheels."""
    for place, z in zip(("front", "rear"), AXLES):
        left = moved(wheel(), (TRACK_X, WHEEL_RADIUS, z))
        yield f"wheel_{place}_left", left
        yield f"wheel_{place}_right", mirrored(left)


def axles():
    """(name, sheet) of the two axles: hexagonal tubes from brake disc to brake disc."""
    for place, z in zip(("front", "rear"), AXLES):
        half = grid([ring(TRACK_X * i / 2, 0.042, 6) for i in (2, 1, 0)], lambda r, c: "axle")
        half = moved(half, (0, WHEEL_RADIUS, z))
        yield f"axle_{place}", half + mirrored(half)
