"""An engine with its gearbox, set across the car: closed sheets, about four hundred faces."""

from car_sheet import moved
from turned import box, tube, turned


def engine(reach=0.5, low=-0.24):
    """About the origin; brackets carry it to x = +-reach and to y = low."""
    block = box((0.02, 0.0, 0.0), (0.46, 0.26, 0.26), "engine", (3, 2, 2), 0.92)
    sump = box((0.02, -0.165, 0.0), (0.38, 0.05, 0.20), "steel", (2, 1, 1), 1.12)
    cover = box((0.02, 0.165, -0.01), (0.42, 0.06, 0.17), "engine_cover", (3, 1, 1), 0.9)
    gearbox = turned(((0.0, -0.44), (0.075, -0.43), (0.115, -0.34), (0.125, -0.225), (0.0, -0.225)),
                     8, lambda r, c: "steel", "x")
    pulleys = []
    for y, z, radius in ((-0.06, 0.0, 0.085), (0.09, 0.06, 0.055), (0.07, -0.09, 0.05)):
        wheel = turned(((0.0, 0.262), (radius, 0.262), (radius, 0.292), (0.0, 0.292)), 9,
                       lambda r, c: "steel", "x")
        pulleys += moved(wheel, (0, y, z))
    manifold = []
    for i in range(4):
        x = -0.13 + 0.1 * i
        manifold += tube([(x, 0.10, 0.12), (x, 0.12, 0.20), (x, 0.02, 0.24)], 0.024, "steel",
                         4, False)
    collector = tube([(-0.17, 0.02, 0.24), (0.21, 0.02, 0.24)], 0.035, "steel", 5)
    brackets = []
    for side in (-1, 1):
        brackets += tube([(side * 0.2, -0.05, -0.05), (side * reach, -0.05, -0.05)], 0.03,
                         "axle", 4)
    feet = []
    for side in (-1, 1):
        feet += tube([(side * 0.1, -0.15, 0.02), (side * 0.1, low, 0.02)], 0.03, "axle", 4)
    return block + sump + cover + gearbox + pulleys + manifold + collector + brackets + feet


def radiator(width, height, depth=0.05):
    """A radiator core between its two tanks, about the origin, facing forward."""
    core = box((0, 0, 0), (width, height * 0.84, depth), "grille", (4, 2, 1))
    tanks = [box((0, y, 0), (width, height * 0.08, depth * 1.5), "steel", (3, 1, 1))
             for y in (height * 0.47, -height * 0.47)]
    return core + tanks[0] + tanks[1]
