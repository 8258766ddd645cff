"""What is bolted to the body: seats, dashboard and steering wheel inside, fittings outside."""

import math

from car_sheet import facing, fan, grid, lerp, mirrored, moved
from car_shape import skin_point, wrap_point

DRIVER_X = 0.36
HANDLES = ((0.07, -0.08), (-0.45, -0.60))   # z of both ends of the left handles


# ---- seats --------------------------------------------------------------------------------------

def pillow(centre, half_size, cells, tilt=0.0):
    """A rounded box, its cells counted along x, y and z, leaning back by the tilt in radians."""
    sheet = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for end in (1, -1):
            rows = [[_pillow_point(axis, end, 2 * i / cells[u] - 1, 2 * j / cells[v] - 1, half_size)
                     for i in range(cells[u] + 1)] for j in range(cells[v] + 1)]
            viewer = tuple(9 * end if k == axis else 0 for k in range(3))
            sheet += grid(rows, lambda r, c: "seat", viewer)
    return moved(_tilted(sheet, tilt), centre)


def _pillow_point(axis, end, a, b, half_size):
    p = [0, 0, 0]
    p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = end, a, b
    norm = sum(abs(x) ** 5 for x in p) ** 0.2
    return tuple(x / norm * h for x, h in zip(p, half_size))


def _tilted(sheet, angle):
    s, c = math.sin(angle), math.cos(angle)
    return [(material, tuple((x, y * c + z * s, z * c - y * s) for x, y, z in polygon))
            for material, polygon in sheet]


def seats():
    """(name, sheet) of the two front seats and the rear bench."""
    front = (pillow((DRIVER_X, 0.40, 0.0), (0.25, 0.10, 0.27), (2, 2, 2), 0.12)
             + pillow((DRIVER_X, 0.73, -0.32), (0.24, 0.32, 0.085), (3, 3, 2), 0.26)
             + pillow((DRIVER_X, 1.12, -0.43), (0.13, 0.075, 0.05), (2, 2, 2), 0.2))
    yield "seat_left", front
    yield "seat_right", mirrored(front)
    yield "bench", (pillow((0, 0.42, -0.67), (0.60, 0.10, 0.25), (4, 2, 2), 0.1)
                    + pillow((0, 0.71, -1.02), (0.48, 0.29, 0.08), (4, 3, 2), 0.3))


# ---- controls -----------------------------------------------------------------------------------

def dashboard():
    """Dashboard and bulkhead in one sheet, from the cowl down to the floor."""
    profile = ((None, 0.895), (0.58, 0.885), (0.51, 0.845), (0.53, 0.70), (0.63, 0.52),
               (0.80, 0.36), (0.86, 0.20))
    columns = [-0.70 + 1.40 * i / 10 for i in range(11)]
    rows = []
    for step, (z, y) in enumerate(profile):
        hood = 0.04 if step in (1, 2) else 0.0
        rows.append([(x, y + hood * math.exp(-((x - DRIVER_X) / 0.17) ** 2),
                      lerp(0.97, 0.70, (x / 0.7) ** 2) if z is None else z) for x in columns])
    return grid(rows, lambda r, c: "interior", (0, 0.9, -9))


def steering_wheel():
    """A rim of square section, three spokes and a hub, leaning towards the driver."""
    radius, tube, count = 0.178, 0.015, 16

    def circle(r, z):
        return [(r * math.sin(2 * math.pi * i / count), r * math.cos(2 * math.pi * i / count), z)
                for i in range(count)] * 2
    section = ((radius, tube), (radius - tube, 0), (radius, -tube), (radius + tube, 0))
    rings = [circle(r, z)[:count + 1] for r, z in section]
    tubes = [face for a, b in zip(rings, rings[1:] + rings[:1])
             for face in grid([b, a], lambda r, c: "interior")]
    inner, hub = circle(radius, 0), circle(0.05, 0.02)
    spokes = [("interior", (hub[i], hub[i + 1], inner[i + 1], inner[i])) for i in (3, 8, 12)]
    boss = fan(hub[:count + 1], (0, 0, -0.01), "interior", (0, 0, -9))
    return moved(_tilted(tubes + facing(spokes, (0, 0, -9)) + boss, -0.45), (DRIVER_X, 0.83, 0.36))


# ---- fittings outside ---------------------------------------------------------------------------

def mirror():
    """The left door mirror: a bowl, the glass that closes it, and its foot."""
    centre, count = (0.905, 0.952, 0.60), 12

    def loop(scale, z):
        return [(0.088 * scale * _rounded(math.cos, i, count), 0.058 * scale
                 * _rounded(math.sin, i, count), z) for i in range(count)]
    rings = [loop(scale, z) for scale, z in ((1, -0.03), (0.97, 0.012), (0.82, 0.046),
                                                     (0.50, 0.069))]
    rings = [r + r[:1] for r in rings]
    bowl = grid(rings, lambda r, c: "paint", None)
    sheet = (facing(bowl + fan(rings[-1], (0, 0, 0.078), "paint", (0, 0, 9)), (0, 0, 9))
             + fan(rings[0], (0, 0, -0.024), "chrome", (0, 0, -9)))
    return moved(sheet, centre) + mirror_foot()


def _rounded(trigonometric, i, count):
    """A coordinate of a circle pulled towards its square."""
    t = trigonometric(2 * math.pi * (i + 0.5) / count)
    return math.copysign(abs(t) ** 0.85, t)


def mirror_foot():
    ends = [[(x, y + dy, 0.60 + dz) for dy, dz in ((-.02, -.03), (-.02, .03), (.02, .03),
                                                  (.02, -.03), (-.02, -.03))]
            for x, y in ((0.86, 0.935), (0.765, 0.915))]
    return grid(ends, lambda r, c: "trim")


def handles():
    """The two left door handles, bowed away from the skin."""
    sheet = []
    for start, end in HANDLES:
        rows = [[skin_point(lerp(start, end, t), 0.80 + dy, 0.003 + bow + rise)
                 for t, bow in ((0, 0), (0.2, 0.018), (0.5, 0.024), (0.8, 0.018), (1, 0))]
                for dy, rise in ((-0.016, 0), (0, 0.008), (0.016, 0))]
        sheet += grid(rows, lambda r, c: "chrome", (9, 0.8, 0))
    return sheet


def plate(end, low, high):
    """A number plate just clear of the skin, between two heights v of the nose or the tail."""
    rows = []
    for v in (low, high):
        _, y, z = wrap_point(end, 0, v)
        rows.append([(-0.24 + 0.12 * i, y, z + end * 0.012) for i in range(5)])
    return grid(rows, lambda r, c: "chrome", (0, 0.5, 9 * end))


def emblem():
    """A slightly domed disc on the grille."""
    x, y, z = wrap_point(1, 0, 0.735)
    loop = [(0.042 * math.cos(math.pi * i / 6), y + 0.042 * math.sin(math.pi * i / 6), z + 0.010)
            for i in range(12)]
    return fan(loop + loop[:1], (x, y, z + 0.018), "chrome", (0, y, 9))


def fittings():
    """(name, sheet) of everything else that is bolted on."""
    yield "dashboard", dashboard()
    yield "steering_wheel", steering_wheel()
    yield "mirror_left", mirror()
    yield "mirror_right", mirrored(mirror())
    yield "handles_left", handles()
    yield "handles_right", mirrored(handles())
    yield "emblem", emblem()
    yield "plate_front", plate(1, 0.43, 0.63)
    yield "plate_rear", plate(-1, 0.595, 0.735)
