"""The buggy: a cage of tubes around an open tub, the engine bare behind it, knobbly tyres."""

import math

import fittings
import roof_laser
from car_sheet import facing, grid, lerp, mirrored, moved, smooth_curve
from engine_block import engine
from turned import box, tube, turned
from vehicle import Vehicle

AXLES, TRACK = (1.25, -1.17), (0.76, 0.78)
RADII, WIDTHS = (0.34, 0.41), (0.22, 0.32)
LASER = (0.0, 1.615, -0.13)
TUBE = 0.03
FLOOR = 0.33


# ---- tub ----------------------------------------------------------------------------------------

STATIONS = (1.78, 1.58, 1.37, 1.16, 0.95, 0.74, 0.52, 0.28, 0.04, -0.20, -0.44, -0.68)
OPEN_FROM = 5             # the station where the nose ends
low_width = smooth_curve([(-0.7, 0.45), (0.6, 0.46), (1.2, 0.38), (1.8, 0.24)])
high_width = smooth_curve([(-0.7, 0.52), (0.6, 0.52), (1.2, 0.40), (1.8, 0.22)])
high_y = smooth_curve([(-0.7, 0.66), (-0.4, 0.58), (0.3, 0.56), (0.74, 0.74), (1.3, 0.66),
                       (1.8, 0.54)])


def tub():
    """Floor, sides and nose in one sheet."""
    rows, noses = [], []
    for z in STATIONS:
        low, high, y = low_width(z), high_width(z), high_y(z)
        keel = FLOOR + 0.06 * max(0.0, (z - 1.0) / 0.8)
        rows.append([(0.0, keel, z), (low * 0.5, keel, z), (low, keel + 0.01, z),
                     (lerp(low, high, 0.5), lerp(keel, y, 0.45), z), (high, y, z)])
        noses.append([(high, y, z), (high * 0.82, y + 0.055, z), (high * 0.42, y + 0.085, z),
                      (0.0, y + 0.095, z)])

    def side_paint(r, c):
        return "trim" if c < 2 else "stripe" if c == 2 and r >= OPEN_FROM else "paint"
    half = facing(grid(rows, side_paint), (9, -6, 0))
    nose = noses[:OPEN_FROM + 1]
    half += grid(nose, lambda r, c: "stripe" if c == 2 else "paint", (0, 9, 0))
    front = [rows[0][:3], [noses[0][3], noses[0][2], noses[0][1]]]
    half += grid(front, lambda r, c: "trim", (0, 0.5, 9))
    half += facing([("trim", (rows[0][2], rows[0][3], noses[0][1])),
                    ("trim", (rows[0][3], rows[0][4], noses[0][1]))], (0, 0.5, 9))
    back = [rows[-1][:3]]
    for y in (0.52, 0.72, 0.92):
        back.append([(x * 0.98, y, STATIONS[-1] - 0.02) for x, _, _ in rows[-1][:3]])
    half += grid(back, lambda r, c: "trim", (0, 0.5, -9))
    return half + mirrored(half)


# ---- cage ---------------------------------------------------------------------------------------

def cage():
    """The tubes of one side, their mirror images, and those across."""
    side = [
        [(0.34, 0.36, 1.74), (0.48, 0.35, 0.8), (0.49, 0.35, -0.70), (0.44, 0.42, -1.55)],
        [(0.26, 0.64, 1.74), (0.55, 0.80, 0.72), (0.58, 0.82, -0.56), (0.45, 0.78, -1.55)],
        [(0.55, 0.80, 0.72), (0.47, 1.53, 0.22)],
        [(0.47, 1.53, 0.22), (0.48, 1.56, -0.50)],
        [(0.48, 1.54, -0.52), (0.45, 0.78, -1.53)],
        [(0.45, 0.78, -1.55), (0.44, 0.42, -1.55)],
        [(0.34, 0.36, 1.74), (0.26, 0.64, 1.74)],
        [(0.49, 0.35, 0.50), (0.575, 0.815, -0.30)],
        [(0.465, 0.40, -1.17), (0.505, 0.80, -1.17)],
        [(0.49, 0.36, 0.62), (0.84, 0.37, 0.45), (0.84, 0.37, -0.42), (0.49, 0.36, -0.62)],
        [(0.55, 0.82, -0.70), (0.45, 0.43, -1.50)],
    ]
    across = [
        [(0.50, 0.35, -0.60), (0.58, 0.82, -0.56), (0.48, 1.56, -0.50), (-0.48, 1.56, -0.50),
         (-0.58, 0.82, -0.56), (-0.50, 0.35, -0.60)],
        [(0.47, 1.53, 0.22), (-0.47, 1.53, 0.22)],
        [(0.545, 0.81, 0.70), (-0.545, 0.81, 0.70)],
        [(0.34, 0.36, 1.74), (-0.34, 0.36, 1.74)],
        [(0.26, 0.64, 1.74), (-0.26, 0.64, 1.74)],
        [(0.45, 0.78, -1.55), (-0.45, 0.78, -1.55)],
        [(0.44, 0.42, -1.55), (-0.44, 0.42, -1.55)],
        [(0.55, 1.05, -0.54), (-0.55, 1.05, -0.54)],
        [(0.33, 0.38, 1.74), (0.30, 0.46, 1.98), (-0.30, 0.46, 1.98), (-0.33, 0.38, 1.74)],
        [(0.43, 0.45, -1.55), (0.42, 0.52, -1.80), (-0.42, 0.52, -1.80), (-0.43, 0.45, -1.55)],
    ]
    sheet = []
    for line in side:
        left = tube(line, TUBE, "cage", 5, pieces=2)
        sheet += left + mirrored(left)
    for line in across:
        sheet += tube(line, TUBE, "cage", 5, pieces=2)
    return sheet


# ---- running gear -------------------------------------------------------------------------------

def axle(end):
    """A tube from hub to hub and two links to the cage."""
    z, track, radius = AXLES[end], TRACK[end], RADII[end]
    steps = [(track - 0.02) * i / 3 for i in range(-3, 4)]
    sheet = tube([(x, radius, z) for x in steps], 0.045, "axle", 6)
    reach = -0.42 if end == 0 else 0.50
    for side in (1, -1):
        sheet += tube([(side * 0.60, radius, z), (side * 0.49, 0.37, z + reach)], 0.024, "steel", 5,
                      pieces=2)
    return sheet


def shock(low, high):
    """A spring around a damper, from one point to another."""
    ends = [tuple(lerp(p, q, t) for p, q in zip(low, high)) for t in (0.14, 0.9)]
    return (tube([low, high], 0.022, "chrome", 5, pieces=2)
            + tube(ends, 0.054, "spring", 7, pieces=12, waist=0.62))


def fender(end):
    """A strip of sheet over a left wheel, on a stay."""
    z, track, radius, width = AXLES[end], TRACK[end], RADII[end], WIDTHS[end]
    angles = range(28, 150, 11) if end == 0 else range(22, 160, 11)
    rows = []
    for degrees in angles:
        t = math.radians(degrees)
        row = []
        for share, drop in ((-0.58, 0.0), (-0.2, 0.012), (0.25, 0.012), (0.6, 0.0), (0.64, -0.05)):
            reach = radius + 0.075 + drop
            row.append((track + width * share, radius + reach * math.sin(t),
                        z + reach * math.cos(t)))
        rows.append(row)
    sheet = grid(rows, lambda r, c: "paint", (track, 9, z))
    top = radius + radius + 0.07
    inside = (0.34, 0.62, z) if end == 0 else (0.50, 0.76, z)
    return sheet + tube([inside, (track - 0.1, top, z)], 0.018, "steel", 5, pieces=2)


# ---- what is bolted on --------------------------------------------------------------------------

def lamp(radius):
    profile = ((0.0, -0.09), (radius * 0.6, -0.08), (radius, -0.01), (radius, 0.03),
               (radius * 0.88, 0.032), (0.0, 0.022))
    return turned(profile, 12, lambda r, c: "light_front" if r == 4 else
                  "chrome" if r == 3 else "trim", "z")


def lamps():
    """Two headlamps before the nose and four on the roof."""
    for name, side in fittings.SIDES:
        yield f"lamp_{name}", (moved(lamp(0.105), (side * 0.30, 0.79, 1.58))
                               + tube([(side * 0.28, 0.62, 1.60), (side * 0.30, 0.71, 1.56)], 0.016,
                                      "steel", 5))
    row = tube([(0.42, 1.555, 0.265), (-0.42, 1.555, 0.265)], 0.016, "steel", 5, pieces=4)
    for x in (-0.33, -0.11, 0.11, 0.33):
        row += moved(lamp(0.068), (x, 1.605, 0.30))
    yield "lamps_roof", row
    for name, side in fittings.SIDES:
        yield f"light_rear_{name}", box((side * 0.30, 0.70, -1.60), (0.16, 0.08, 0.05),
                                        "light_rear", (2, 1, 1))


def roof():
    """The plate that carries the laser."""
    rows = [[(x, 1.598 + 0.014 * (1 - (x / 0.46) ** 2), z)
             for x in (-0.46, -0.3, -0.1, 0.1, 0.3, 0.46)]
            for z in (0.22, 0.08, -0.08, -0.24, -0.38, -0.50)]
    return grid(rows, lambda r, c: "stripe" if c == 2 else "paint", (0, 9, 0))


def dashboard():
    rows = [[(-0.47 + 0.94 * i / 8, y, z) for i in range(9)]
            for y, z in ((0.60, 0.72), (0.74, 0.66), (0.85, 0.66), (0.87, 0.74))]
    dials = []
    for x in (0.19, 0.28, 0.37):
        dials += moved(turned(((0.035, 0.0), (0.035, 0.02), (0.0, 0.02)), 10,
                              lambda r, c: "chrome" if r else "trim", "z"), (x, 0.80, 0))
    flipped = [(m, tuple((x, y, 0.655 - z) for x, y, z in polygon[::-1])) for m, polygon in dials]
    return grid(rows, lambda r, c: "interior", (0, 0.8, -9)) + flipped


def door_board():
    """A sheet with a white field on the left side of the cage."""
    rows = []
    for v in range(5):
        y = 0.46 + 0.30 * v / 4
        rows.append([(0.548 + 0.062 * v / 4, y, 0.36 - 0.74 * i / 8 - 0.06 * v / 4)
                     for i in range(9)])
    return grid(rows, lambda r, c: "plate" if 0 < r < 3 and 1 < c < 6 else "paint", (9, 0.6, 0))


def exhaust():
    left = tube([(0.15, 0.62, -1.36), (0.26, 0.66, -1.50), (0.30, 0.98, -1.62),
                 (0.30, 1.06, -1.95)], 0.035, "chrome", 6, capped=False, pieces=2)
    horn = turned(((0.05, 0.0), (0.06, 0.10), (0.075, 0.22)), 8, lambda r, c: "chrome", "z")
    horn = [(material, tuple((x, y, -z) for x, y, z in polygon[::-1]))
            for material, polygon in horn]
    return left + moved(horn, (0.30, 1.06, -1.90))


def buggy():
    car = Vehicle("buggy", 700, {"paint": {"colour": "#c98f1b", "gloss": 0.75},
                                 "stripe": {"colour": "#26292d", "gloss": 0.4},
                                 "cage": {"colour": "#3f464f", "gloss": 0.6},
                                 "spring": {"colour": "#a8322a", "gloss": 0.6},
                                 "plate": {"colour": "#dfe2e4", "gloss": 0.5}})
    car.add(("body", tub()), ("frame", cage()), ("roof", roof()))
    rolling = [(radius, fittings.wheel(radius, width, rim, 5, (0.36, 0.84), knobs=0.016))
               for radius, width, rim in zip(RADII, WIDTHS, (0.185, 0.205))]
    for end in (0, 1):
        pair = list(fittings.wheels(TRACK[end], AXLES, rolling))
        car.add(*pair[2 * end:2 * end + 2])
    car.add(("axle_front", axle(0)), ("axle_rear", axle(1)))
    for end, place in enumerate(("front", "rear")):
        z, radius = AXLES[end], RADII[end]
        top = (0.40, 0.735, z - 0.22) if end == 0 else (0.52, 0.80, z + 0.28)
        for name, side in fittings.SIDES:
            bent = shock((0.60, radius + 0.03, z - 0.02), top)
            wing = fender(end)
            car.add((f"shock_{place}_{name}", bent if side > 0 else mirrored(bent)),
                    (f"fender_{place}_{name}", wing if side > 0 else mirrored(wing)))
    car.add(*fittings.seats(FLOOR, -0.10, 0.25), ("dashboard", dashboard()))
    wheel = dict(fittings.controls(FLOOR + 0.02, 0.16, x=0.28))["steering_wheel"]
    column = tube([(0.28, 0.80, 0.66), (0.28, 0.985, 0.53)], 0.018, "interior", 5)
    car.add(("steering_wheel", wheel), ("column", column))
    car.add(*lamps(), ("board_left", door_board()), ("board_right", mirrored(door_board())))
    car.add(("engine", moved(engine(0.47, -0.16), (0, 0.60, -1.12))),
            ("tank", box((0, 0.70, -0.79), (0.62, 0.24, 0.15), "tank", (4, 2, 1))))
    car.add(("exhaust_left", exhaust()), ("exhaust_right", mirrored(exhaust())))
    car.add(*roof_laser.roof_laser(*LASER))
    hold(car)
    car.turret = roof_laser.description(*LASER)
    car.engine = {"force": 6500, "power": 115000, "top_speed": 27}
    car.vital = [{"kind": "engine", "part": "engine", "mount": "frame"},
                 {"kind": "driver", "part": "seat_driver", "mount": "body"}]
    car.driver_eye = [0.25, 1.26, -0.3]
    return car


def hold(car):
    joints = car.joints
    joints.together("frame", 0.02)
    joints.hold("body", "frame", [(x, y, z) for x, y in ((0.46, 0.35), (-0.46, 0.35))
                                  for z in (0.7, 0.1, -0.6)]
                + [(0.25, 0.5, 1.74), (-0.25, 0.5, 1.74)], 0.1)
    joints.hold("roof", "frame", [(x, 1.57, z) for x in (0.47, -0.47) for z in (0.2, -0.48)], 0.1)
    for end, place in enumerate(("front", "rear")):
        track, z, radius = TRACK[end], AXLES[end], RADII[end]
        for name, side in fittings.SIDES:
            wheel = f"wheel_{place}_{name}"
            joints.turn("hub", wheel, f"axle_{place}", (side * (track - 0.01), radius, z),
                        (1, 0, 0), radius=0.15)
            joints.hold_together(wheel)
            car.wheel(wheel, f"axle_{place}", (side * track, radius, z), radius, end == 0, end == 1,
                      0.3)
        joints.hold(f"axle_{place}", "frame", [(side * 0.45, radius, z) for side in (1, -1)], 0.1)
        for name, side in fittings.SIDES:
            joints.hold(f"shock_{place}_{name}", f"axle_{place}", radius=0.08)
            joints.hold(f"fender_{place}_{name}", "body" if end == 0 else "frame", radius=0.08)
    for name in ("dashboard", "lamp_left", "lamp_right", "tank", "exhaust_left", "exhaust_right"):
        to = {"tank": "body", "lamp_left": "body", "lamp_right": "body",
              "dashboard": "frame"}.get(name, "engine")
        joints.hold(name, to, radius=0.12)
    fittings.hang_seats(car)
    joints.hold("column", "dashboard")
    joints.hold("steering_wheel", "column")
    for name in ("lamps_roof", "light_rear_left", "light_rear_right", "board_left", "board_right"):
        joints.hold(name, "frame", radius=0.08)
    joints.hold("engine", "frame", [(0.47, 0.55, -1.17), (-0.47, 0.55, -1.17)], 0.09)
    fittings.hang_laser(car, *LASER, "roof")
