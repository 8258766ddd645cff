"""The van: a tall box on small wheels, with sliding doors, a pair of rear doors, and its cargo."""

import math

import fittings
import roof_laser
from car_sheet import grid, mirrored, moved, smooth_curve
from coachwork import Coachwork
from engine_block import engine, radiator
from panel import arc, inset, leaf, rectangle
from turned import box, tube
from vehicle import Vehicle

AXLES, TRACK, RADIUS = (1.55, -1.48), 0.80, 0.34
ARCH, INNER = 0.40, 0.56
LASER = (0.0, 2.045, 0.05)
FLOOR = 0.285
OUTLINE = [(2.26, 0.28, 0.14, 0.0), (2.37, 0.38, 0.15, 0.0), (2.42, 0.60, 0.15, 0.0),
           (2.40, 0.86, 0.13, 0.0), (2.31, 1.00, 0.11, 0.02), (2.10, 1.08, 0.10, 0.04),
           (1.66, 1.205, 0.13, 0.04), (1.57, 1.24, 0.15, 0.03), (0.84, 1.86, 0.21, 0.05),
           (0.66, 1.94, 0.16, 0.07), (0.28, 1.975, 0.0, 0.08), (-2.08, 1.955, 0.0, 0.08),
           (-2.27, 1.90, -0.03, 0.07), (-2.36, 1.77, -0.05, 0.03), (-2.44, 1.12, -0.06, 0.0),
           (-2.47, 0.64, -0.07, 0.0), (-2.46, 0.46, -0.07, 0.0), (-2.38, 0.30, -0.06, 0.0)]
LEAD, COWL, GLASS, REAR = 4, 6, 7, 13      # stations of the deck

profile = smooth_curve([(0.28, 0.945), (0.45, 0.985), (0.75, 1.0), (1.15, 0.99), (1.30, 0.972),
                        (1.65, 0.925), (1.80, 0.895), (1.98, 0.825)])
plan = smooth_curve([(-2.5, 0.965), (-2.1, 1.0), (1.2, 1.0), (1.8, 0.975), (2.2, 0.90),
                     (2.45, 0.80)])
PRESSED = [(-2.14, -1.12, 1.12, 1.64)]              # z and y of the fields in the sides
BORDER = 0.02


def half_width(z, y):
    flare = 0.0
    for axle in AXLES:
        off = math.hypot(z - axle, y - RADIUS) - ARCH
        if y < 1.0:
            flare += 0.022 * math.exp(-(off / 0.06) ** 2) * min(1.0, (1.0 - y) / 0.2)
    for z0, z1, y0, y1 in PRESSED:
        inside = min(z - z0, z1 - z, y - y0, y1 - y)
        flare -= 0.018 * min(1.0, max(0.0, inside / BORDER))
    return 0.965 * profile(y) * plan(z) + flare


DOOR = [(0.20, 0.40), (1.04, 0.40), (1.16, 0.72), (1.24, 1.14), (0.82, 1.69), (0.66, 1.78),
        (0.20, 1.81)]
DOOR_GLASS = [(0.30, 1.17), (1.10, 1.17), (0.74, 1.63), (0.62, 1.69), (0.30, 1.71)]
QUARTER = [(1.30, 1.18), (1.45, 1.205), (1.12, 1.475)]
SLIDE = [(-0.98, 0.40), (0.12, 0.40), (0.12, 1.81), (-0.98, 1.80)]
SLIDE_GLASS = [(-0.86, 1.17), (0.02, 1.17), (0.02, 1.69), (-0.86, 1.68)]
STRIPE = (0.80, 1.00)


def side():
    low, high = STRIPE
    regions = [("trim", rectangle(-2.6, 0.2, 2.6, 0.385)),
               ("stripe", rectangle(-2.6, low, 2.6, high))]
    for axle in AXLES:
        regions.append(("trim", arc((axle, RADIUS), ARCH + 0.05, 180, 0, 14)
                        + [(axle + ARCH + 0.05, 0.1), (axle - ARCH - 0.05, 0.1)]))
    for z0, z1, y0, y1 in PRESSED:
        field = rectangle(z0, y0, z1, y1)
        regions += [("paint", field), ("paint", inset(field, BORDER))]
    regions += [("light_front", [(2.18, 0.72), (2.50, 0.72), (2.50, 0.98), (2.22, 0.98)]),
                ("light_rear", [(-2.60, 0.70), (-2.36, 0.70), (-2.34, 1.14), (-2.60, 1.14)])]
    for part, door, glass in (("door_*", DOOR, DOOR_GLASS), ("door_slide_*", SLIDE, SLIDE_GLASS)):
        regions += leaf(f"{part}:paint", door)
        strip = inset(door, 0.009)
        regions.append((f"{part}:stripe", _between(strip, low, high)))
        regions += [(f"{part}:trim", inset(glass, -0.028)), (None, glass)]
    regions += [("trim", inset(QUARTER, -0.018)), (None, QUARTER)]
    return regions


def _between(loop, low, high):
    """The part of a polygon between two heights; it crosses each height twice."""
    points = []
    for (z0, y0), (z1, y1) in zip(loop, loop[1:] + loop[:1]):
        if low < y0 < high:
            points.append((z0, y0))
        crossed = [y for y in (low, high) if (y0 - y) * (y1 - y) < 0]
        for y in sorted(crossed, reverse=y1 < y0):
            points.append((z0 + (z1 - z0) * (y - y0) / (y1 - y0), y))
    return points


def deck():
    lamps = [("trim", [(2.42, 0.50), (3.9, 0.56), (3.9, 1.02), (2.42, 1.02)]),
             ("light_front", [(2.52, 0.54), (3.78, 0.60), (3.78, 0.97), (2.52, 0.97)])]
    nose = [("trim", rectangle(0.0, -0.02, 1.4, 1.02)),
            ("trim", rectangle(2.52, -0.02, 3.55, 0.47)),
            ("chrome", rectangle(2.95, -0.02, 3.15, 0.44)),
            ("grille", rectangle(0.55, -0.02, 1.1, 0.62))] + lamps
    bonnet = leaf("bonnet:paint", rectangle(LEAD + 0.12, -0.1, COWL - 0.1, 0.86))
    screen = [("trim", rectangle(COWL, -0.02, GLASS + 0.05, 0.93)),
              (None, rectangle(GLASS + 0.05, -0.02, GLASS + 0.95, 0.90))]
    doors = leaf("door_rear_*:paint", rectangle(REAR - 0.35, 0.0, REAR + 2.7, 0.86))
    glass = rectangle(REAR + 0.12, 0.10, REAR + 0.85, 0.72)
    doors += [("door_rear_*:trim", rectangle(REAR + 0.07, 0.065, REAR + 0.90, 0.755)),
              (None, glass)]
    tail = [("light_rear", rectangle(REAR + 0.96, 0.885, REAR + 1.9, 1.0)),
            ("trim", rectangle(REAR + 2.85, -0.02, REAR + 4, 1.02))]
    return nose + bonnet + screen + doors + tail


def rack():
    """Two rails on feet and four bars, behind the laser."""
    sheet = []
    for x in (0.62, -0.62):
        sheet += tube([(x, 2.10, -0.55), (x, 2.10, -2.0)], 0.022, "steel", 4, pieces=3)
        for z in (-0.6, -1.95):
            sheet += tube([(x, 1.985, z), (x, 2.09, z)], 0.02, "steel", 4)
    for i in range(4):
        z = -0.62 - 0.44 * i
        sheet += tube([(0.62, 2.12, z), (-0.62, 2.12, z)], 0.02, "steel", 4, pieces=2)
    return sheet


def ladder():
    """An aluminium ladder that lies on the rack."""
    sheet = []
    for x in (0.05, 0.42):
        sheet += tube([(x, 2.165, -0.5), (x, 2.165, -2.25)], 0.022, "chrome", 4, pieces=3)
    for i in range(5):
        z = -0.66 - 0.36 * i
        sheet += tube([(0.05, 2.165, z), (0.42, 2.165, z)], 0.014, "chrome", 4, pieces=1)
    return sheet


def cargo():
    """Cases on the floor behind the bulkhead."""
    yield "case_1", box((0.35, 0.545, -0.75), (0.62, 0.5, 0.7), "case", (3, 2, 3))
    yield "case_2", box((-0.32, 0.495, -0.55), (0.5, 0.4, 0.6), "case", (2, 2, 2))
    yield "case_3", box((0.33, 0.995, -0.72), (0.5, 0.36, 0.5), "case_dark", (2, 2, 2))
    yield "case_4", box((-0.1, 0.62, -1.7), (0.8, 0.65, 0.6), "case_dark", (3, 2, 2))


def bulkhead():
    """A sheet behind the seats, up to the shoulders."""
    rows = [[(-0.86 + 1.72 * i / 8, y, -0.02) for i in range(9)]
            for y in (0.30, 0.5, 0.72, 0.94, 1.12)]
    return grid(rows, lambda r, c: "interior", (0, 1, 9))


def van():
    car = Vehicle("van", 1700, {"paint": {"colour": "#b9bdb6", "gloss": 0.7},
                                "stripe": {"colour": "#2d5a46", "gloss": 0.7},
                                "bumper": {"colour": "#25292e", "gloss": 0.2},
                                "case": {"colour": "#7a6038", "gloss": 0.1},
                                "case_dark": {"colour": "#3f5360", "gloss": 0.3}})
    coach = Coachwork(OUTLINE, half_width, AXLES, ARCH, RADIUS, INNER, edge=0.185)
    body = coach.parts(side(), deck())
    car.add(("body", body.pop("body")), *body.items())
    rolling = (RADIUS, fittings.wheel(RADIUS, 0.21, 0.205, 9, (0.52, 0.80)))
    car.add(*fittings.wheels(TRACK, AXLES, (rolling, rolling)))
    car.add(("axle_front", fittings.axle(TRACK - 0.02, RADIUS, AXLES[0])),
            ("axle_rear", fittings.axle(TRACK - 0.02, RADIUS, AXLES[1])))
    car.add(("bumper_front", fittings.bumper(coach, 1.1, 1, 0.34, 0.56, 0.07, 0.45, reach=0.28)),
            ("bumper_rear", fittings.bumper(coach, 16.2, -1, 0.36, 0.52, 0.06, 0.44)))
    car.add(*fittings.seats(FLOOR, 0.52, 0.40, 0.22),
            *fittings.controls(FLOOR + 0.02, 0.62, 1.17, 1.30, 0.40))
    car.add(("bulkhead", bulkhead()), *cargo(), ("rack", rack()), ("ladder", ladder()),
            ("exhaust", fittings.exhaust(-0.3, FLOOR - 0.065, 1.5, -2.45)))
    car.add(*outside(coach))
    car.add(("engine", moved(engine(0.56, -0.33), (0, 0.63, 1.86))),
            ("radiator", moved(radiator(0.9, 0.40), (0, 0.62, 2.24))))
    car.add(("tank", fittings.tank((0.28, 0.22, 0.35), (0.56, 0.12, 0.7))))
    car.add(*roof_laser.roof_laser(*LASER))
    hold(car)
    car.turret = roof_laser.description(*LASER)
    car.engine = {"force": 9000, "power": 115000, "top_speed": 20}
    car.vital = [{"kind": "engine", "part": "engine", "mount": "body"},
                 {"kind": "driver", "part": "seat_driver", "mount": "body"}]
    car.driver_eye = [0.40, 1.45, 0.32]
    return car


def outside(coach):
    left = fittings.mirror((half_width(1.08, 1.18), 1.18, 1.08), (0.10, 0.16))
    grips = (fittings.handle(coach, 0.26, 0.42, 1.08)
             + fittings.handle(coach, -0.06, 0.08, 1.08))
    yield "mirror_left", left
    yield "mirror_right", mirrored(left)
    yield "handles_left", grips
    yield "handles_right", mirrored(grips)
    yield "plate_front", fittings.plate(2.60, 1, 0.45)
    yield "plate_rear", fittings.plate(-2.60, -1, 0.44)


def hold(car):
    joints = car.joints
    fittings.hang_wheels(car, TRACK, RADIUS, AXLES, INNER, ("front",))
    for name, x in fittings.SIDES:
        limits = [-70, 0] if x > 0 else [0, 70]
        fittings.hang_leaf(car, f"door_{name}", [(x * 0.96, 0.62, 1.13), (x * 0.96, 1.0, 1.21)],
                           (x * 0.97, 1.0, 0.195), (0, 1, 0), limits)
        joints.hold(f"door_slide_{name}", "body", [(x * 0.95, y, z) for y in (0.5, 1.6)
                                                   for z in (-0.985, 0.125)])
        edge = x * 0.80
        fittings.hang_leaf(car, f"door_rear_{name}", [(edge, 0.6, -2.5), (edge, 1.5, -2.45)],
                           (x * 0.4, 0.46, -2.52), (0, 1, 0), [-110, 0] if x > 0 else [0, 110])
        joints.hold(f"mirror_{name}", f"door_{name}", radius=0.07)
        joints.hold(f"handles_{name}", f"door_{name}", [(x * 0.96, 1.08, 0.3)])
    fittings.hang_leaf(car, "bonnet", [(0.5, 1.235, 1.76), (-0.5, 1.235, 1.76)], (0.0, 1.02, 2.4),
                       (1, 0, 0), [-60, 0])
    corners = [(x, z) for x in (0.62, -0.62) for z in (-0.6, -1.95)]
    joints.hold("rack", "body", [(x, 1.99, z) for x, z in corners])
    joints.hold("ladder", "rack", [(x, 2.14, z) for x in (0.05, 0.42) for z in (-0.62, -1.94)])
    joints.hold("bulkhead", "body", [(x, 0.3, 0.0) for x in (0.6, -0.6)]
                + [(x, 1.0, 0.0) for x in (0.95, -0.95)], 0.1)
    for name in ("case_1", "case_2", "case_4", "dashboard"):
        joints.hold(name, "body", radius=0.14)
    fittings.hang_seats(car)
    joints.hold("exhaust", "body", [(-0.3, 0.28, 0.8), (-0.3, 0.28, -2.3)], 0.1)
    joints.hold("tank", "body", [(0.28, 0.285, z) for z in (0.1, 0.6)], 0.12)
    joints.hold("case_3", "case_1")
    joints.hold("steering_wheel", "dashboard", radius=0.07)
    for name, sign in (("bumper_front", 1), ("bumper_rear", -1)):
        joints.hold(name, "body", [(x, 0.45, 2.45 * sign) for x in (0.7, -0.7)], 0.1)
    joints.hold("engine", "body", [(0.56, 0.55, 1.8), (-0.56, 0.55, 1.8), (0.1, 0.29, 1.88),
                                   (-0.1, 0.29, 1.88)], 0.1)
    joints.hold("radiator", "body", [(0.35, 0.4, 2.3), (-0.35, 0.4, 2.3)], 0.12)
    joints.hold("plate_front", "bumper_front", radius=0.08)
    joints.hold("plate_rear", "bumper_rear", radius=0.08)
    fittings.hang_laser(car, *LASER, "body")
