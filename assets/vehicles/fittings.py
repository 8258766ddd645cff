"""What vehicles have in common: running gear, bumpers, mirrors, seats, controls, their joints."""

import math

import car_cabin
import car_wheels
from car_sheet import facing, fan, grid, mirrored, moved
from turned import box, tube, turned

SIDES = (("left", 1), ("right", -1))


def stretched(sheet, x, y, z):
    """The sheet scaled along each axis by a positive factor."""
    return [(material, tuple((a * x, b * y, c * z) for a, b, c in polygon))
            for material, polygon in sheet]


def wheel(radius, width, rim, spokes, window, knobs=0.0):
    """A left wheel at the origin, its rim facing +x: tyre, rim with spokes, hub, brake disc.

    rim: radius of the rim; window: inner and outer radius of the openings between the spokes,
    as shares of it; knobs: depth of the tread. Eighteen to twenty cells go around.
    """
    cells, half = 2 * spokes if spokes > 6 else 4 * spokes, width / 2
    tyre = ((-half * 0.92, rim), (-half, (rim + radius) / 2 + 0.01), (-half * 0.78, radius),
            (half * 0.78, radius), (half, (rim + radius) / 2 + 0.01), (half * 0.92, rim))
    face = ((half * 0.70, rim * 0.93), (half * 0.52, rim * window[1]),
            (half * 0.60, rim * window[0]))

    def rings(profile):
        return [car_wheels.ring(x, r, cells) for x, r in profile]
    treads = rings(tyre[::-1])
    for row in (2, 3):
        treads[row] = [(x, *(v * (1 - knobs / radius * ((i + row) % cells % 2)) for v in p))
                       for i, (x, *p) in enumerate(treads[row])]
    sheet = grid(treads, lambda r, c: "tyre")
    share = cells // spokes
    sheet += grid(rings((tyre[-1],) + face[:2]), lambda r, c: "rim", (9, 0, 0))
    sheet += grid(rings(face[1:]), lambda r, c: "rim" if c % share < share / 2 else None, (9, 0, 0))
    sheet += fan(rings(face)[-1], (half * 0.68, 0, 0), "chrome", (9, 0, 0))
    return sheet + fan(car_wheels.ring(-0.02, rim * 0.6, 12), (-0.02, 0, 0), "axle", (9, 0, 0))


def wheels(track, axles, left):
    """(name, sheet) of four wheels whose hubs are at x = +-track, by their (radius, left wheel)."""
    for end, z, (radius, sheet) in zip(("front", "rear"), axles, left):
        placed = moved(sheet, (track, radius, z))
        for name, side in SIDES:
            yield f"wheel_{end}_{name}", placed if side > 0 else mirrored(placed)


def axle(track, height, z, bulb=0.0):
    """A tube from hub to hub, with the housing of a differential if `bulb` is its radius."""
    steps = [track * (i / 4) for i in range(-4, 5)]
    sheet = tube([(x, height, z) for x in steps], 0.045, "axle", 6)
    if bulb:
        ball = turned(((0.0, -bulb), (0.7 * bulb, -0.75 * bulb), (bulb, 0.0),
                       (0.7 * bulb, 0.75 * bulb), (0.0, bulb)), 10, lambda r, c: "steel", "z")
        sheet += moved(ball, (0.12, height, z))
    return sheet


def exhaust(x, y, front, rear):
    """A pipe with a box along a floor, raised over the rear axle, open at its end."""
    pipe = tube([(x, y + 0.04, front), (x, y, front - 0.6), (x, y, -1.0), (x * 1.25, y + 0.02, -1.7),
                 (x * 1.25, y + 0.02, rear)], 0.03, "steel", 5)
    return pipe + box((x, y - 0.005, -0.3), (0.24, 0.11, 0.6), "steel", (2, 1, 2))


def bumper(coach, station, end, low, high, out, wrap, material="bumper", reach=0.30):
    """A bumper bent around the nose (end +1) or the tail (-1), over `reach` of each side."""
    path = [coach.deck_point(station, i / 8) for i in range(9)]
    z = path[-1][2]
    for i in range(1, 4):
        back = z - end * reach * i / 3
        path.append((coach.half_width(back, wrap), wrap, back))
    rows = [[], [], [], []]
    for i, (x, _, z) in enumerate(path):
        ahead, behind = path[min(i + 1, len(path) - 1)], path[max(i - 1, 0)]
        along = (ahead[0] - behind[0], ahead[2] - behind[2])
        length = math.hypot(*along)
        normal = (abs(along[1]) / length, end * abs(along[0]) / length)
        if i == 0:
            normal = (0.0, end)
        for row, (share, y) in zip(rows, ((0.15, low), (1.0, low + 0.03), (1.0, high - 0.03),
                                          (0.15, high))):
            row.append((x + normal[0] * out * share, y, z + normal[1] * out * share))
    half = grid(rows, lambda r, c: material, (2, (low + high) / 2, 9 * end))
    return half + mirrored(half)


def mirror(at, size=(0.10, 0.13)):
    """A left door mirror: a tall case on an arm that reaches the point `at` of the door."""
    x, y, z = at
    w, h = size
    case = ((0.0, 0.065), (0.55, 0.055), (0.9, 0.03), (1.0, 0.0), (0.94, -0.03))
    rows = []
    for share, depth in case[1:]:
        loop = [(w * share * _squarish(math.cos, i), h * share * _squarish(math.sin, i), depth)
                for i in range(10)]
        rows.append(loop + loop[:1])
    shell = grid(rows[::-1], lambda r, c: "trim") + fan(rows[0], (0, 0, 0.065), "trim", (0, 0, 9))
    glass = fan(rows[-1], (0, 0, -0.03), "chrome", (0, 0, -9))
    body = facing(shell, (0, 0, 9)) + glass
    arm = tube([(x - 0.02, y, z), (x + 0.08, y + 0.02, z)], 0.016, "trim", 5)
    return moved(body, (x + 0.09 + w * 0.8, y + 0.06, z)) + arm


def _squarish(trigonometric, i):
    t = trigonometric(2 * math.pi * (i + 0.5) / 10)
    return math.copysign(abs(t) ** 0.7, t)


def handle(coach, z0, z1, y):
    """A left door handle, bowed away from the skin."""
    rows = []
    for dy, rise in ((-0.016, 0.0), (0.0, 0.008), (0.016, 0.0)):
        row = []
        for t, bow in ((0, 0.004), (0.2, 0.022), (0.5, 0.028), (0.8, 0.022), (1, 0.004)):
            z = z0 + (z1 - z0) * t
            row.append((coach.half_width(z, y + dy) + bow + rise, y + dy, z))
        rows.append(row)
    return grid(rows, lambda r, c: "chrome", (9, y, z0))


def plate(z, end, y, width=0.5, height=0.12):
    rows = [[(width * (i / 4 - 0.5), y + dy, z) for i in range(5)]
            for dy in (-height / 2, height / 2)]
    return grid(rows, lambda r, c: "chrome", (0, y, z + 9 * end))


def seats(floor, z, x=car_cabin.DRIVER_X, rise=0.0):
    """(name, sheet) of the driver's and the passenger's seat, on boxes as high as `rise`."""
    left = dict(car_cabin.seats())["seat_left"]
    left = moved(left, (x - car_cabin.DRIVER_X, floor - 0.19 + rise, z))
    if rise:
        left += box((x, floor + (rise + 0.11) / 2 + 0.005, z), (0.40, rise + 0.09, 0.42), "trim",
                    (2, 1, 2))
    yield "seat_driver", left
    yield "seat_passenger", mirrored(left)


def controls(floor, z, width=1.0, height=1.0, x=car_cabin.DRIVER_X):
    """(name, sheet) of dashboard and steering wheel, for a floor at this height."""
    dashboard = stretched(moved(car_cabin.dashboard(), (0, -0.19, 0)), width, height, 1)
    yield "dashboard", moved(dashboard, (0, floor, z))
    rise = floor - 0.19 + 0.70 * (height - 1)
    yield "steering_wheel", moved(car_cabin.steering_wheel(), (x - car_cabin.DRIVER_X, rise, z))


def tank(centre, size):
    """A fuel tank, narrower at its top."""
    return box(centre, size, "tank", (4, 2, 3), top=0.94)


def hang_seats(car):
    """Welds each seat to the body near the four corners of its foot."""
    for name in ("seat_driver", "seat_passenger"):
        xs, ys, zs = zip(*(p for _, polygon in car.parts[name] for p in polygon))
        foot = [(x, z) for x, y, z in zip(xs, ys, zs) if y < min(ys) + 0.15]
        (left, right), (rear, front) = ((min(a), max(a)) for a in zip(*foot))
        car.joints.hold(name, "body", [(left + a * (right - left), min(ys), rear + b * (front - rear))
                                       for a in (0.15, 0.85) for b in (0.15, 0.85)], 0.08)


def hang_wheels(car, track, radius, axles, inner, driven, travel=0.22):
    """Joints of wheels and axles, and the wheels' entries; `driven` names the driven ends."""
    joints = car.joints
    for end, z in zip(("front", "rear"), axles):
        for name, side in SIDES:
            wheel = f"wheel_{end}_{name}"
            joints.turn("hub", wheel, f"axle_{end}", (side * (track - 0.01), radius, z), (1, 0, 0),
                        radius=0.15)
            joints.hold_together(wheel)
            car.wheel(wheel, f"axle_{end}", (side * track, radius, z), radius, end == "front",
                      end in driven, travel)
        joints.hold(f"axle_{end}", "body", [(side * inner, radius + 0.045, z) for _, side in SIDES],
                    0.12)


def hang_leaf(car, part, hinges, latch, axis, limits, radius=0.07):
    """A door or a lid on the body: two hinges on one line near an axis, and a weld as its latch."""
    first, second = hinges
    line = [b - a for a, b in zip(first, second)]
    along = sum(l * a for l, a in zip(line, axis))
    axis = tuple(round(l * math.copysign(1, along) / math.hypot(*line), 6) + 0.0 for l in line)
    for place in hinges:
        car.joints.turn("hinge", part, "body", place, axis, limits=limits, radius=radius)
    car.joints.hold(part, "body", [latch], radius)


def hang_laser(car, x, y, z, on):
    """The laser's joints: its collar on a part of the roof, turret on collar, barrel on turret."""
    joints = car.joints
    joints.hold("mount", on, [(x + 0.235, y, z), (x - 0.235, y, z), (x, y, z + 0.235),
                              (x, y, z - 0.235)], 0.09)
    joints.hold("turret", "mount", [(x + 0.16, y + 0.07, z), (x - 0.16, y + 0.07, z)], 0.12)
    joints.hold("barrel", "turret", [(x + 0.075, y + 0.235, z), (x - 0.075, y + 0.235, z)], 0.07)
