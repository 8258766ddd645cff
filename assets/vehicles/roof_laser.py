"""The laser on the roof of a vehicle: a collar on the roof, a turret that turns on it, a barrel.

    mount    the collar, which stays on the roof and carries the turret
    turret   a turntable with the two cheeks between which the barrel hangs
    barrel   housing, cooling fins and tube, with the lens at its end
"""

from car_sheet import facing, grid, mirrored, moved
from turned import box, turned

PIVOT = 0.075             # m, of the turret above the foot of the collar
TRUNNION = 0.235          # m, axis of the barrel above the foot of the collar
MUZZLE = 0.62             # m, of the lens ahead of the axis
SIDES = 18
YAW, PITCH = [-180, 180], [-15, 35]


def collar():
    """A flared ring with a flange, closed below the turntable."""
    profile = ((0.235, 0.0), (0.235, 0.012), (0.185, 0.020), (0.170, 0.060), (0.150, 0.066))
    return turned(profile, SIDES, lambda r, c: "steel")


def turntable():
    profile = ((0.120, 0.070), (0.175, 0.074), (0.182, 0.100), (0.165, 0.118), (0.075, 0.124),
               (0.0, 0.124))
    return turned(profile, SIDES, lambda r, c: "laser_dark" if r == 1 else "laser")


def cheek():
    """The left cheek: an upright plate with a rounded head, bent out of sheet."""
    outline = ((-0.100, 0.118), (-0.085, 0.190), (-0.060, 0.262), (-0.025, 0.290), (0.025, 0.290),
               (0.060, 0.262), (0.085, 0.190), (0.100, 0.118))
    inner, outer = 0.082, 0.112
    rows = [[(x, y, z) for z, y in outline] for x in (inner, outer)]
    strip = facing(grid(rows, lambda r, c: "laser"), (0.097, 9, 0))
    sides = []
    for x, viewer in ((inner, (-9, 0.2, 0)), (outer, (9, 0.2, 0))):
        pairs = [[(x, y, z) for z, y in outline[:4]], [(x, y, z) for z, y in outline[:3:-1]]]
        sides += grid(pairs, lambda r, c: "laser", viewer)
    boss = turned(((0.045, 0.112), (0.040, 0.124), (0.0, 0.126)), 12, lambda r, c: "steel", "x")
    return strip + sides + moved(boss, (0, TRUNNION, 0))


def turret():
    magazine = box((0, 0.205, -0.155), (0.15, 0.13, 0.10), "laser_dark", (2, 2, 1), 0.86)
    return turntable() + cheek() + mirrored(cheek()) + magazine


def barrel():
    """About the axis z through the origin, pointing forward."""
    housing = ((0.0, -0.205), (0.050, -0.200), (0.066, -0.170), (0.068, 0.06), 
               (0.060, 0.150), (0.046, 0.165))
    fins = []
    for i in range(3):
        z = 0.18 + 0.05 * i
        fins += [(0.036, z), (0.058, z + 0.008), (0.058, z + 0.02), (0.036, z + 0.028)]
    tube = ((0.036, 0.36), (0.034, 0.54), (0.050, 0.555), (0.054, MUZZLE), (0.040, MUZZLE),
            (0.036, MUZZLE - 0.022), (0.0, MUZZLE - 0.012))
    profile = housing + tuple(fins) + tube
    first_fin, last_fin = len(housing), len(housing) + len(fins)
    lens = len(profile) - 2

    def paint(r, c):
        if r >= lens:
            return "lens"
        if r < 3 or r > last_fin:
            return "laser_dark"
        return "steel" if r >= first_fin else "laser"
    return turned(profile, 10, paint, "z")


def roof_laser(x, y, z):
    """(name, sheet) of a laser whose collar stands at this point of the roof."""
    yield "mount", moved(collar(), (x, y, z))
    yield "turret", moved(turret(), (x, y, z))
    yield "barrel", moved(barrel(), (x, y + TRUNNION, z))


def description(x, y, z):
    """What a vehicle file says of this laser."""
    return {
        "part": "turret", "mount": "mount", "pivot": [x, round(y + PIVOT, 4), z], "yaw": YAW,
        "barrel": {"part": "barrel", "pivot": [x, round(y + TRUNNION, 4), z],
                   "muzzle": [x, round(y + TRUNNION, 4), round(z + MUZZLE, 4)], "pitch": PITCH},
    }
