"""The paint of rally_car.obj: its image and the UVs that place it on the body.

The lower part of the image covers both sides, as seen from each of them, so that the number reads
rightly on either; the upper part covers what faces upwards. Colours are sRGB.
"""

import math
import random
import struct
import zlib

SIZE = 1024
SIDES = 0.4                        # of the image's height, from its lower edge
LENGTH, LOW, HIGH, HALF_WIDTH = 2.12, 0.12, 1.46, 1.0     # m, of the car
PETROL, CREAM, DARK, RUST = (61, 111, 134), (226, 217, 196), (28, 34, 38), (112, 62, 34)
NUMBER, NUMBER_AT = "27", (0.04, 0.62)                    # its z and y, m
DISC = 0.25                                               # m
# The strokes of each digit in a box of one by two.
DIGITS = {"2": [((0, 2), (1, 2)), ((1, 2), (1, 1)), ((1, 1), (0, 1)), ((0, 1), (0, 0)), ((0, 0), (1, 0))],
          "7": [((0, 2), (1, 2)), ((1, 2), (0.35, 0))]}


def uv(point, normal):
    x, y, z = point
    if abs(normal[1]) > max(abs(normal[0]), abs(normal[2])):
        return (LENGTH - z) / (2 * LENGTH), SIDES + (1 - SIDES) * (x + HALF_WIDTH) / (2 * HALF_WIDTH)
    along = (z if normal[0] < 0 else -z) + LENGTH
    return along / (2 * LENGTH), SIDES * (y - LOW) / (HIGH - LOW)


def image():
    """The rows of the image from the top, each a bytes of RGB."""
    noise = Noise()
    rows = []
    for row in range(SIZE):
        v = 1 - (row + 0.5) / SIZE
        line = bytearray()
        for column in range(SIZE):
            z = (2 * (column + 0.5) / SIZE - 1) * LENGTH
            if v < SIDES:
                colour = side(z, LOW + (HIGH - LOW) * v / SIDES, noise)
            else:
                colour = top((2 * (v - SIDES) / (1 - SIDES) - 1) * HALF_WIDTH)
            line += bytes(colour)
        rows.append(bytes(line))
    return rows


def top(x):
    """Two stripes from bonnet to tail."""
    return CREAM if 0.06 < abs(x) < 0.27 else PETROL


def side(z, y, noise):
    z_mid, y_mid = NUMBER_AT
    distance = math.hypot(z - z_mid, y - y_mid)
    if distance < DISC:
        return DARK if is_digit((z - z_mid) / 0.105, (y - y_mid) / 0.105) else CREAM
    if distance < DISC + 0.02:
        return DARK
    # Rust creeps up from the sill and the arches.
    eaten = 0.34 + 0.16 * noise.at(9 * z, 5 * y) - 0.55 * max(0, abs(abs(z) - 1.3) - 0.45)
    edge = eaten - y
    if edge > 0 and noise.at(60 * z, 60 * y) < min(1, 9 * edge) - 0.15:
        shade = 0.75 + 0.5 * noise.at(140 * z, 140 * y)
        return tuple(min(255, int(shade * c)) for c in RUST)
    return CREAM if 0.80 < y < 0.845 or 0.86 < y < 0.875 else PETROL


def is_digit(x, y):
    """Both digits stand side by side around the origin."""
    for i, digit in enumerate(NUMBER):
        left = -1.25 + 1.5 * i
        for (ax, ay), (bx, by) in DIGITS[digit]:
            if distance_to_segment(x - left, y + 1, ax, ay, bx, by) < 0.19:
                return True
    return False


def distance_to_segment(x, y, ax, ay, bx, by):
    ux, uy = bx - ax, by - ay
    t = max(0.0, min(1.0, ((x - ax) * ux + (y - ay) * uy) / (ux * ux + uy * uy)))
    return math.hypot(x - ax - t * ux, y - ay - t * uy)


class Noise:
    """Smooth values from 0 to 1 over the plane, the same on each run."""

    def __init__(self):
        values = random.Random(27)
        self._grid = [[values.random() for _ in range(64)] for _ in range(64)]

    def at(self, x, y):
        i, j = math.floor(x), math.floor(y)
        s, t = x - i, y - j
        s, t = s * s * (3 - 2 * s), t * t * (3 - 2 * t)
        a, b = (self._grid[(i + k) % 64] for k in (0, 1))
        low = a[j % 64] + s * (b[j % 64] - a[j % 64])
        high = a[(j + 1) % 64] + s * (b[(j + 1) % 64] - a[(j + 1) % 64])
        return low + t * (high - low)


def png(rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head)
            + chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows), 9)) + chunk(b"IEND", b""))
