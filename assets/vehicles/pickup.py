"""The pick-up: a cab for two, an open bed behind it, tall wheels, a ladder frame below."""

import math

import fittings
import roof_laser
from car_sheet import grid, lerp, mirrored, moved, smooth_curve
from coachwork import Coachwork
from engine_block import engine, radiator
from panel import arc, inset, leaf, rectangle
from turned import box, tube
from vehicle import Vehicle

AXLES, TRACK, RADIUS = (1.55, -1.62), 0.76, 0.39
ARCH, INNER = 0.47, 0.52
LASER = (0.0, 1.815, -0.30)
FLOOR = 0.43
BELT = 1.14
OUTLINE = [(2.30, 0.42, 0.10, 0.0), (2.38, 0.56, 0.12, 0.0), (2.40, 0.78, 0.13, 0.0),
           (2.39, 0.98, 0.12, 0.0), (2.34, 1.06, 0.10, 0.02), (2.24, 1.10, 0.06, 0.045),
           (1.70, 1.135, 0.03, 0.055), (1.12, 1.165, 0.07, 0.05), (1.02, 1.19, 0.10, 0.035),
           (0.40, 1.68, 0.13, 0.05), (0.28, 1.735, 0.09, 0.06), (-0.20, 1.76, 0.0, 0.06),
           (-0.78, 1.745, -0.02, 0.05), (-0.90, 1.68, -0.03, 0.04), (-0.99, 1.15, -0.03, 0.0),
           (-1.04, 1.135, -0.02, 0.0), (-2.54, 1.12, 0.0, 0.0), (-2.58, 1.08, -0.03, 0.0),
           (-2.59, 0.62, -0.04, 0.0), (-2.54, 0.46, -0.03, 0.0)]
RAIL = 0.87               # u of the inner edge of the bed's side
HOOD, SCUTTLE, GLASS, BACK, BED, TAIL = 4, 7, 8, 13, 15, 16   # stations of the deck

profile = smooth_curve([(0.40, 0.955), (0.60, 0.99), (0.80, 1.0), (1.0, 0.992), (1.16, 0.955),
                        (1.30, 0.905), (1.76, 0.735)])
plan = smooth_curve([(-2.6, 0.972), (-2.2, 1.0), (1.5, 1.0), (2.0, 0.985), (2.3, 0.93),
                     (2.42, 0.86)])


def half_width(z, y):
    flare = 0.0
    for axle in AXLES:
        off = math.hypot(z - axle, y - RADIUS) - ARCH
        if y < BELT:
            flare += 0.035 * math.exp(-(off / 0.07) ** 2) * min(1.0, (BELT - y) / 0.2)
    return 0.915 * profile(y) * plan(z) + flare


FOLDS = [((1.10, 1.155), (-0.97, 1.155))]
DOOR = [(-0.52, 0.52), (0.90, 0.52), (0.90, 1.14), (0.33, 1.64), (-0.40, 1.665), (-0.52, 1.14)]
WINDOW = [(-0.42, 1.17), (0.74, 1.17), (0.30, 1.575), (-0.33, 1.60)]
QUARTER = [(-0.86, 1.17), (-0.60, 1.17), (-0.52, 1.60), (-0.79, 1.60)]


def side():
    regions = [("trim", rectangle(-2.7, 0.40, 2.5, 0.50))]
    regions += [("trim", band) for band in arch_bands()]
    regions += [("light_rear", [(-2.60, 0.72), (-2.50, 0.72), (-2.50, 1.04), (-2.60, 1.04)]),
                ("indicator", [(2.20, 0.83), (2.42, 0.83), (2.42, 0.95), (2.24, 0.95)])]
    regions += leaf("door_*:paint", DOOR)
    regions += [("door_*:trim", inset(WINDOW, -0.028)), (None, WINDOW)]
    regions += [("trim", inset(QUARTER, -0.022)), (None, QUARTER)]
    return regions


def arch_bands():
    """The painted lips of the arches, as polygons that reach below the lower edge."""
    for axle in AXLES:
        yield (arc((axle, RADIUS), ARCH + 0.055, 180, 0, 14)
               + [(axle + ARCH + 0.055, 0.2), (axle - ARCH - 0.055, 0.2)])


def deck():
    lamps = [("trim", [(1.98, 0.57), (1.98, 1.02), (3.2, 1.02), (3.2, 0.57)]),
             ("light_front", [(2.14, 0.61), (2.14, 0.93), (3.0, 0.93), (3.0, 0.61)])]
    grille = [("chrome", rectangle(1.95, -0.02, 3.30, 0.545)),
              ("grille", rectangle(2.05, -0.02, 3.15, 0.52)),
              ("chrome", rectangle(2.52, -0.02, 2.68, 0.52))]
    nose = [("trim", rectangle(0, -0.02, 0.95, 1.02)),
            ("grille", rectangle(0.35, -0.02, 0.75, 0.45))] + grille + lamps
    bonnet = leaf("bonnet:paint", rectangle(HOOD + 0.25, -0.1, SCUTTLE - 0.12, 0.90))
    screen = [("trim", rectangle(SCUTTLE, -0.02, GLASS + 0.06, 0.93)),
              (None, rectangle(GLASS + 0.06, -0.02, GLASS + 0.93, 0.915)),
              (None, rectangle(BACK + 0.10, -0.02, BACK + 0.72, 0.80))]
    tail = [(None, rectangle(BED - 0.5, -0.02, TAIL + 0.62, RAIL))]
    gate = leaf("tailgate:paint", rectangle(TAIL + 0.62, -0.1, TAIL + 1.93, 0.885))
    tail += gate + [("light_rear", rectangle(TAIL + 1.2, 0.905, TAIL + 1.85, 1.0)),
                    ("trim", rectangle(TAIL + 2.1, -0.02, TAIL + 3, 1.02))]
    return nose + bonnet + screen + tail


def bed(coach):
    """The tub between the sides of the bed, with boxes over the wheels."""
    front, rear, floor, top = -1.07, -2.535, 0.66, 0.93
    axle = AXLES[1]
    boxed = (axle + ARCH + 0.03, axle - ARCH - 0.03)
    stations = [(z, False) for z in (front, -1.09)] + [(boxed[0], False)]
    stations += [(lerp(*boxed, i / 5), True) for i in range(6)] + [(boxed[1], False)]
    stations += [(-2.3, False), (-2.42, False), (rear, False)]
    rows = []
    for z, over_wheel in stations:
        outer = coach.half_width(z, 1.12) * RAIL - 0.012
        step = top if over_wheel else floor
        middle = [(x, floor, z) for x in (0.0, 0.25, 0.50)]
        ledge = ((0.50, step, z) if over_wheel else (0.62, floor, z), (outer, step, z))
        rows.append([*middle, *ledge, (outer, top, z), (outer, 1.105, z)])
    half = grid(rows, lambda r, c: "bed", (0, 9, -1.8))
    return half + mirrored(half) + bulkhead(rows[0], top)


def bulkhead(row, top):
    """The bed's front wall, up to the rail."""
    lines = [row[:5]]
    for y in (top, 1.105):
        lines.append([(x, y, z) for x, _, z in lines[0]])
    half = grid(lines, lambda r, c: "bed", (0, 1, -9))
    return half + mirrored(half)


def frame():
    """Two rails, bent over the rear axle, and cross members."""
    sheet = []
    for x in (0.40, -0.40):
        sheet += tube([(x, 0.40, 2.15), (x, 0.36, 1.0), (x, 0.36, -1.0), (x, 0.50, -1.35),
                       (x, 0.50, -1.95), (x, 0.42, -2.45)], 0.055, "axle", 4, pieces=2)
    for y, z in ((0.37, 0.75), (0.36, -0.6), (0.47, -2.1)):
        sheet += tube([(0.36, y, z), (-0.36, y, z)], 0.04, "axle", 4, pieces=2)
    return sheet


def driveline():
    """Gearbox, shaft and exhaust."""
    shaft = tube([(0.06, 0.42, 0.75), (0.12, 0.40, -1.48)], 0.04, "steel", 6, pieces=6)
    pipe = tube([(-0.25, 0.40, 1.2), (-0.25, 0.31, 0.7), (-0.25, 0.31, -1.2), (-0.3, 0.55, -1.5),
                 (-0.3, 0.55, -1.9), (-0.55, 0.40, -2.45)], 0.03, "steel", 5)
    muffler = box((-0.25, 0.31, -0.3), (0.22, 0.13, 0.6), "steel", (2, 1, 3))
    return shaft, pipe + muffler


def roll_bar():
    """A hoop in the bed, behind the cab."""
    y, z = 1.66, -1.22
    hoop = tube([(0.72, 0.68, z), (0.70, y - 0.12, z), (0.58, y, z), (-0.58, y, z),
                 (-0.70, y - 0.12, z), (-0.72, 0.68, z)], 0.038, "chrome", 6, pieces=1)
    for x in (0.66, -0.66):
        hoop += tube([(x, y - 0.10, z - 0.03), (x * 1.08, 1.0, -1.95), (x * 1.08, 0.945, -1.97)],
                     0.03, "chrome", 5, pieces=2)
    return hoop


def pickup():
    car = Vehicle("pickup", 1500, {"paint": {"colour": "#8f3a2b", "gloss": 0.75},
                                   "bed": {"colour": "#33373c", "gloss": 0.3},
                                   "bumper": {"colour": "#9aa1a9", "gloss": 0.8}})
    coach = Coachwork(OUTLINE, half_width, AXLES, ARCH, RADIUS, INNER, FOLDS)
    body = coach.parts(side(), deck())
    car.add(("body", body.pop("body")), *body.items())
    car.add(("bed", bed(coach)), ("roll_bar", roll_bar()), ("frame", frame()))
    shaft, exhaust = driveline()
    car.add(("shaft", shaft), ("exhaust", exhaust))
    rolling = (RADIUS, fittings.wheel(RADIUS, 0.25, 0.24, 5, (0.38, 0.86)))
    car.add(*fittings.wheels(TRACK, AXLES, (rolling, rolling)))
    car.add(("axle_front", fittings.axle(TRACK - 0.02, RADIUS, AXLES[0])),
            ("axle_rear", fittings.axle(TRACK - 0.02, RADIUS, AXLES[1], 0.15)))
    car.add(("bumper_front", fittings.bumper(coach, 0.9, 1, 0.50, 0.68, 0.10, 0.6)),
            ("bumper_rear", fittings.bumper(coach, 18.5, -1, 0.46, 0.62, 0.09, 0.55)))
    car.add(*fittings.seats(FLOOR, -0.12), *fittings.controls(FLOOR, 0.14, 1.1, 1.02))
    car.add(*cab_fittings(coach))
    car.add(("engine", moved(engine(0.52, -0.28), (0, 0.72, 1.55))),
            ("radiator", moved(radiator(0.86, 0.44), (0, 0.78, 2.22))))
    car.add(("tank", fittings.tank((0.62, 0.31, -0.62), (0.26, 0.22, 0.62))))
    car.add(*roof_laser.roof_laser(*LASER))
    hold(car)
    car.turret = roof_laser.description(*LASER)
    car.engine = {"force": 9500, "power": 140000, "top_speed": 23}
    car.vital = [{"kind": "engine", "part": "engine", "mount": "body"},
                 {"kind": "driver", "part": "seat_driver", "mount": "body"}]
    car.driver_eye = [0.36, 1.36, -0.3]
    return car


def cab_fittings(coach):
    left = fittings.mirror((half_width(0.72, 1.16), 1.16, 0.72))
    grip = fittings.handle(coach, -0.44, -0.28, 1.02)
    yield "mirror_left", left
    yield "mirror_right", mirrored(left)
    yield "handle_left", grip
    yield "handle_right", mirrored(grip)
    yield "plate_front", fittings.plate(2.63, 1, 0.59)
    yield "plate_rear", fittings.plate(-2.735, -1, 0.54)


def hold(car):
    joints = car.joints
    fittings.hang_wheels(car, TRACK, RADIUS, AXLES, INNER, ("rear",))
    for name, x in fittings.SIDES:
        edge = x * half_width(0.9, 0.7)
        limits = [-70, 0] if x > 0 else [0, 70]
        fittings.hang_leaf(car, f"door_{name}", [(edge, 0.62, 0.905), (edge, 1.05, 0.905)],
                           (x * half_width(-0.52, 0.9), 0.9, -0.525), (0, 1, 0), limits)
        joints.hold(f"mirror_{name}", f"door_{name}", radius=0.07)
        joints.hold(f"handle_{name}", f"door_{name}", [(x * 0.9, 1.02, -0.44),
                                                       (x * 0.9, 1.02, -0.28)])
    fittings.hang_leaf(car, "bonnet", [(0.5, 1.19, 1.13), (-0.5, 1.19, 1.13)], (0.0, 1.1, 2.4),
                       (1, 0, 0), [-75, 0])
    fittings.hang_leaf(car, "tailgate", [(0.5, 0.65, -2.62), (-0.5, 0.65, -2.62)],
                       (0.8, 1.0, -2.6), (1, 0, 0), [-90, 0])
    joints.hold("tailgate", "body", [(-0.8, 1.0, -2.6)])
    joints.hold("bed", "body", [(x, 1.11, z) for x in (0.79, -0.79) for z in (-1.1, -1.8, -2.5)],
                0.09)
    joints.hold("roll_bar", "bed", [(x, 0.66, -1.22) for x in (0.72, -0.72)], 0.1)
    joints.hold("frame", "body", [(x, 0.42, z) for x in (0.4, -0.4)
                                  for z in (1.9, 0.3, -0.8, -2.3)], 0.1)
    joints.hold("shaft", "axle_rear")
    joints.hold("exhaust", "body", [(-0.25, 0.43, z) for z in (0.5, -0.9)], 0.1)
    for name in ("bumper_front", "bumper_rear"):
        sign = 1 if name.endswith("front") else -1
        joints.hold(name, "body", [(x, 0.57, 2.4 * sign) for x in (0.7, -0.7)], 0.1)
    joints.hold("dashboard", "body", radius=0.14)
    fittings.hang_seats(car)
    joints.hold("tank", "body", [(0.66, 0.43, z) for z in (-0.45, -0.8)], 0.12)
    joints.hold("steering_wheel", "dashboard", radius=0.07)
    joints.hold("engine", "body", [(0.52, 0.67, 1.5), (-0.52, 0.67, 1.5), (0.1, 0.43, 1.57),
                                   (-0.1, 0.43, 1.57)], 0.1)
    joints.hold("radiator", "body", [(0.35, 0.55, 2.25), (-0.35, 0.55, 2.25)], 0.12)
    joints.hold("plate_front", "bumper_front", radius=0.08)
    joints.hold("plate_rear", "bumper_rear", radius=0.08)
    fittings.hang_laser(car, *LASER, "body")
