"""The hatchback: the body, the wheels and the fittings of car.obj, with an engine and a laser."""

import roof_laser
from car_body import body
from car_cabin import DRIVER_X, fittings, seats
from car_shape import AXLES, WHEEL_RADIUS
from car_sheet import moved
from car_wheels import TRACK_X, axles, wheels
from engine_block import engine, radiator
from fittings import exhaust, hang_laser, hang_seats, tank
from vehicle import Vehicle

LASER = (0.0, 1.405, -0.25)
# Hinges of doors, bonnet and tailgate: anchor, axis, limits, and a point on either side.
DOOR_HINGES = [((0.867, 0.425, 0.600), (0.867, 0.42, 0.535), (0.867, 0.42, 0.665)),
               ((0.864, 0.730, 0.599), (0.853, 0.755, 0.535), (0.852, 0.755, 0.665)),
               ((0.867, 0.425, -0.110), (0.867, 0.42, -0.175), (0.867, 0.42, -0.045)),
               ((0.864, 0.742, -0.110), (0.858, 0.757, -0.175), (0.857, 0.757, -0.045))]
LID_HINGES = [((0.397, 0.913, 0.964), [-75, 0], (0.400, 0.904, 1.019), (0.399, 0.927, 0.929),
               0.035),
              ((0.393, 1.308, -1.453), [0, 80], (0.395, 1.279, -1.488), (0.396, 1.321, -1.415),
               0.025)]
SEATS = {"seat_left": "seat_driver", "seat_right": "seat_passenger", "bench": "bench"}


def hatchback():
    car = Vehicle("hatchback", 1000, {"paint": {"colour": "#3d6f86", "gloss": 0.8}})
    car.add(("body", body()), *wheels(), *axles())
    car.add(*((SEATS[name], sheet) for name, sheet in seats()), *fittings())
    car.add(("engine", moved(engine(), (0, 0.46, 1.32))),
            ("radiator", moved(radiator(0.8, 0.36), (0, 0.44, 1.80))))
    car.add(("exhaust", exhaust(-0.26, 0.14, 1.2, -2.06)),
            ("tank", tank((0.16, 0.30, -0.86), (0.56, 0.16, 0.34))))
    car.add(*roof_laser.roof_laser(*LASER))
    hold(car)
    describe(car)
    return car


def hold(car):
    joints = car.joints
    for end, z in zip(("front", "rear"), AXLES):
        for side, x in (("left", 1), ("right", -1)):
            wheel = f"wheel_{end}_{side}"
            joints.turn("hub", wheel, f"axle_{end}", (x * (TRACK_X - 0.01), WHEEL_RADIUS, z),
                        (1, 0, 0), radius=0.15)
            joints.hold_together(wheel)
        joints.hold(f"axle_{end}", "body", [(x, WHEEL_RADIUS + 0.035, z) for x in (0.5, -0.5)],
                    0.12)
    hang_seats(car)
    joints.hold("bench", "body", [(0.5, 0.4, -0.95), (-0.5, 0.4, -0.95)], 0.1)
    joints.hold("dashboard", "body", [(x, 0.195, 0.86) for x in (0.35, -0.35)], 0.08)
    joints.hold("steering_wheel", "dashboard", [(DRIVER_X, 0.85, 0.5)], 0.07)
    for side, x in (("left", 1), ("right", -1)):
        joints.hold(f"mirror_{side}", "body", radius=0.08)
        joints.hold(f"handles_{side}", "body", [(x * 0.86, 0.815, z) for z in (0.07, -0.45)])
        for anchor, *near in DOOR_HINGES:
            places = [(x * a, b, c) for a, b, c in (anchor, *near)]
            limits = [-70, 0] if x > 0 else [0, 70]
            joints.seam("body", places[0], (0, 1, 0), limits, places[1:], 0.05)
        for anchor, limits, *near, radius in LID_HINGES:
            places = [(x * a, b, c) for a, b, c in (anchor, *near)]
            joints.seam("body", places[0], (1, 0, 0), limits, places[1:], radius)
    for name in ("emblem", "plate_front", "plate_rear"):
        joints.hold(name, "body", radius=0.08)
    joints.hold("engine", "body", [(0.5, 0.41, 1.27), (-0.5, 0.41, 1.27), (0.1, 0.2, 1.34),
                                   (-0.1, 0.2, 1.34)], 0.1)
    joints.hold("exhaust", "body", [(-0.26, 0.19, z) for z in (0.3, -0.9)], 0.1)
    joints.hold("tank", "body", [(0.16, 0.2, z) for z in (-0.74, -0.98)], 0.12)
    joints.hold("radiator", "body", [(0.35, 0.25, 1.8), (-0.35, 0.25, 1.8)], 0.1)
    hang_laser(car, *LASER, "body")


def describe(car):
    for end, z in zip(("front", "rear"), AXLES):
        for side, x in (("left", 1), ("right", -1)):
            front = end == "front"
            car.wheel(f"wheel_{end}_{side}", f"axle_{end}", (x * TRACK_X, WHEEL_RADIUS, z),
                      WHEEL_RADIUS, front, front, 0.2)
    car.turret = roof_laser.description(*LASER)
    car.engine = {"force": 7000, "power": 120000, "top_speed": 24}
    car.vital = [{"kind": "engine", "part": "engine", "mount": "body"},
                 {"kind": "driver", "part": "seat_driver", "mount": "body"}]
    car.driver_eye = [DRIVER_X, 1.12, -0.2]
