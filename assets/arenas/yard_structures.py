"""The yard: its fixed structures of grey, matt concrete, its surroundings, and the places of its props."""

import math

from car_sheet import moved
from concrete import (PLINTH, barrier_block, column, frustum, plinths, prism, ring_wall,
                      turned_by)
from turned import box, tube, turned

HALF = 40.0               # m, from the middle to the walls
SIZE, INTENSITY = [80, 80], 0.03
BRIDGE_WIDTH, DECK, CLEAR = 7.0, 3.4, 2.9
# (distance from the middle of the bridge, height of the road); no slope is over 12 degrees
ROAD = ((7.0, DECK), (8.5, DECK - 0.15), (23.6, 0.15), (25.1, 0.0))
# (x, z, degrees) of road barriers as cover around the middle
BLOCKS = [(10.5, 10.0, 35), (-10.5, 10.0, -35), (10.5, -10.0, -35), (-10.5, -10.0, 35),
          (13.5, 8.6, 80), (-13.5, -8.6, 80), (3.5, 20.5, 80), (-4.0, -19.0, 95), (21.5, 6.8, 10),
          (-21.5, -6.8, 10)]
MASTS = [(x, z) for x in (-27.0, 27.0) for z in (-14.0, 14.0)]
TALL = 13.0               # m, of the masts
# (x, y, z, degrees from +z towards +x); those of falling props: see plinths().
PLACES = {
    "container": [(-21, 0, 24, 25), (-14.5, 0, 27.5, -60), (20, 0, 26, 85), (23, 0, -24, -20),
                  (-24, 0, -22, 50), (-20.4, 2.59, 24.4, 32)],
    "drum": [(-30.4, 0, 2, 15), (-17.5, 0, 22, 0), (-16.7, 0, 21.8, 40), (18, 0, 22.5, 0),
             (18.8, 0, 22.2, 30), (24, 0, -18.5, 0), (24.8, 0, -18.9, 60), (23.5, 0, -19.3, 20),
             (-21, 0, -17.8, 0), (-20.2, 0, -18.3, 50), (0.4, 0, 12, 0), (-0.4, 0, 11.6, 25),
             (0.3, 0, -12, 0), (-0.5, 0, -11.7, 70)],
    "barrier": [(-6, 0, 26, 90), (-6, 0, 28.3, 90), (6, 0, 31, 80), (6.2, 0, 33.3, 95),
                (12, 0, -26, 90), (12, 0, -31, 90), (-12, 0, -25, 100), (-12, 0, -30, 85),
                (33, 0, 14, 0), (30.6, 0, 14.4, 10), (-30, 0, -14, 0), (-32.4, 0, -14.3, -8)],
    "pylon": [(-35.6, 0, -8, 0), (35.6, 0, 8, 180)],
    "sign": [(36.8, 0, 36.8, 225), (-36.8, 0, 36.8, 135), (36.8, 0, -36.8, 315),
             (-36.8, 0, -36.8, 45), (28.2, 0, 0, 270), (-28.2, 0, 0, 90)],
    "lamp_post": [(-28, PLINTH, -26.5, 45), (28, PLINTH, 27.5, 225), (-28.5, PLINTH, 30, 90),
                  (28.5, PLINTH, -28, 270), (-8.5, PLINTH, 31, 0), (15, PLINTH, -24, 180)],
    "gantry": [(32.5, PLINTH, -17.5, 0), (-32.5, PLINTH, 16.5, 0)],
    "stack": [(23.5, PLINTH, -12.6, 0), (-23.5, PLINTH, 12.6, 0)],
}
ENEMIES = [(33, 22, 180), (22, 34, 270), (34, -24, 0), (-20, 34, 90), (18, -35, 270), (-33, 25, 180),
           (-18, 6, 180), (-10.5, -19.5, 270), (10, 22, 180), (22, -8, 270), (0.5, 35.5, 270), (34, 0, 180),
           (-5, -8.5, 270), (6, -8.5, 90)]
PLAYER = (-33, 0, -22)


def walls():
    """A wall with a sloping foot that turns wheels away, buttresses, a coping and two gates."""
    profile = ((-0.42, 0.0), (-0.38, 0.10), (-0.16, 0.42), (0.0, 1.0), (0.0, 3.3), (-0.12, 3.3),
               (-0.12, 3.55), (0.52, 3.55), (0.52, 3.3), (0.4, 3.3), (0.4, 0.0))
    names = {0: "concrete_dark", 1: "concrete_dark", 2: "concrete_dark"}
    sheet = ring_wall(HALF, HALF, profile, lambda i: names.get(i, "concrete"), 10)
    for quarter in range(4):
        for i in range(-4, 5):
            gate = quarter % 2 == 0 and abs(i) < 1
            if not gate:
                post = box((8.0 * i, 1.85, HALF - 0.06), (0.7, 3.7, 0.5), "concrete", top=0.94)
                sheet += turned_by(post, 90 * quarter)
    for quarter in (0, 2):
        sheet += turned_by(gate_leaf(), 90 * quarter)
    return sheet


def gate_leaf():
    """A roller door in a frame, before the wall."""
    z = HALF - 0.10
    rows = []
    for i in range(19):
        y, bulge = 0.2 + 3.6 * i / 18, 0.05 if i % 2 else 0.0
        rows.append([(x, y, z - bulge) for x in (-3.0, 3.0)])
    slats = [("gate", polygon) for row in zip(rows, rows[1:])
             for polygon in ((row[0][0], row[1][0], row[1][1], row[0][1]),)]
    frame = [box((x, 2.1, z), (0.5, 4.2, 0.5), "concrete_dark") for x in (-3.2, 3.2)]
    lintel = box((0, 4.1, z), (6.9, 0.6, 0.6), "concrete_dark")
    return slats + frame[0] + frame[1] + lintel


def bridge():
    """Two ramps and a deck along x, to be driven over and, across them, under."""
    half = BRIDGE_WIDTH / 2

    def paint(side):
        return {"top": "asphalt", "bottom": "concrete_dark"}.get(side, "concrete")
    ramp = [(x, 0.0, y) for x, y in ROAD]
    deck = [(x, CLEAR, DECK) for x in (-7.0, 0.0, 7.0)]
    sheet = prism([(-x, low, high) for x, low, high in ramp[::-1]] + deck + ramp, half, paint)
    road = [(-x, y) for x, y in ROAD[::-1]] + list(ROAD)
    for side in (-1, 1):
        parapet = prism([(x, y - 0.02 if y else 0.0, y + 0.8) for x, y in road[1:-1]], 0.14,
                        lambda part: "band_edge" if part == "top" else "concrete")
        sheet += moved(parapet, (0, 0, side * (half - 0.16)))
    for z in (-2.3, 2.3):
        sheet += moved(turned(((0.5, 0.0), (0.5, 0.5), (0.42, 0.7), (0.42, CLEAR)), 10,
                              lambda r, c: "band" if r == 0 else "concrete"), (0, 0, z))
    for x in (-6.7, 6.7):       # marks how high the passage is
        for side in (-1, 1):
            sheet += box((x, CLEAR + 0.25, side * (half + 0.03)), (0.5, 0.5, 0.06), "band")
    return sheet


def colonnades():
    """Two rows of columns with the beams of a crane that is gone."""
    sheet = []
    for z in (-15.0, 15.0):
        for x in (-18.0, -6.0, 6.0, 18.0):
            sheet += moved(column(6.0), (x, 0, z))
        for x in (-12.0, 12.0):
            sheet += box((x, 6.35, z), (13.4, 0.7, 0.6), "concrete_dark")
    return sheet


def kicker():
    """A ramp to jump from, towards +z, of ten degrees."""
    stations = [(-4.2, 0.0, 0.0), (-3.0, 0.0, 0.11), (3.0, 0.0, 1.17)]

    def paint(side):
        return "asphalt" if side == "top" else "concrete_dark"
    edges = []
    for x in (-1.87, 1.87):
        strip = prism([(a, low, high + 0.03 if high else 0.0) for a, low, high in stations], 0.2,
                      lambda side: "band_edge", "z")
        edges += moved(strip, (x, 0, 0))
    return prism(stations, 2.1, paint, "z") + edges


def ramps():
    hill = frustum(7.2, 2.8, 0.9, lambda side: "asphalt" if side == "top" else "concrete_dark")
    return (moved(kicker(), (-32.5, 0, 8)) + turned_by(kicker(), 180, (32.5, 0, -8))
            + moved(hill, (0, 0, -28)))


def mast(x, z):
    """A floodlight mast on a concrete foot; its lamps look at the middle of the yard."""
    foot = turned(((0.75, 0.0), (0.75, 0.5), (0.55, 0.9), (0.0, 0.9)), 8,
                  lambda r, c: "band" if r == 0 else "concrete")
    pole = turned(((0.22, 0.9), (0.17, 5.0), (0.11, TALL), (0.0, TALL)), 8, lambda r, c: "mast")
    head = box((0, TALL - 0.2, 0.1), (3.0, 0.14, 0.14), "mast")
    for i in (-1.2, -0.4, 0.4, 1.2):
        head += box((i, TALL + 0.15, 0.22), (0.62, 0.5, 0.3), "mast")
        low, high = TALL - 0.05, TALL + 0.35
        head.append(("floodlight", ((i - 0.26, low, 0.38), (i + 0.26, low, 0.38),
                                    (i + 0.26, high, 0.38), (i - 0.26, high, 0.38))))
    return moved(foot + pole + turned_by(head, math.degrees(math.atan2(-x, -z))), (x, 0, z))


def masts():
    return [face for x, z in MASTS for face in mast(x, z)]


def lamps():
    """Where the floodlights are: a little before their glass."""
    return [(round(x * (1 - 0.7 / math.hypot(x, z)), 3), TALL + 0.15,
             round(z * (1 - 0.7 / math.hypot(x, z)), 3)) for x, z in MASTS]


# ---- on the ground ------------------------------------------------------------------------------

def stripe(x, z, length, width, degrees):
    """A painted stripe a finger's breadth above the ground, along z if not turned."""
    a, b = width / 2, length / 2
    flat = [("marking", ((-a, 0, -b), (-a, 0, b), (a, 0, b), (a, 0, -b)))]
    return turned_by(flat, degrees, (x, 0.012, z))


def markings():
    """The dashed middle of the circuit, its corners, bays along two walls, the passage's edges."""
    sheet = []
    for quarter in range(4):
        for i in range(-6, 7):
            sheet += turned_by(stripe(32.5, 4.0 * i, 1.8, 0.16, 0), 90 * quarter)
        for i in range(1, 6):
            t = math.radians(90 * i / 6)
            sheet += turned_by(stripe(26.5 + 6.0 * math.sin(t), 26.5 + 6.0 * math.cos(t), 1.2, 0.16,
                                      90 * i / 6 + 90), 90 * quarter)
    for side in (-1, 1):
        for i in range(8):
            sheet += stripe(side * (-14.0 + 4.0 * i), side * 36.6, 4.6, 0.14, 0)
        sheet += stripe(0.0, side * 34.3, 28.0, 0.14, 90)
        for x in (-6.2, 6.2):
            sheet += stripe(x, side * 7.4, 6.6, 0.16, 0)
        for i in range(5):
            sheet += stripe(side * 26.2, -2.4 + 1.2 * i, 0.6, 0.6, 0)
    return sheet


# ---- beyond the walls ---------------------------------------------------------------------------

def hall():
    """A long hall with a saw-tooth roof and a row of windows."""
    sheet = box((0, 4.5, 0), (60.0, 9.0, 16.0), "hall")
    for i in range(6):
        x = -25.0 + 10.0 * i
        tooth = prism([(-4.95, 9.0, 9.0), (4.6, 9.0, 12.4), (4.95, 9.0, 9.0)], 8.0,
                      lambda side: "hall")
        sheet += moved(tooth, (x, 0, 0))
    for i in range(15):
        x = -28.0 + 4.0 * i
        y = 6.0
        material = "window_lit" if i in (2, 3, 9, 13) else "window_dark"
        sheet.append((material, ((x + 1.3, y, -8.05), (x - 1.3, y, -8.05),
                                 (x - 1.3, y + 1.8, -8.05), (x + 1.3, y + 1.8, -8.05))))
    return sheet


def silo(radius, height):
    return turned(((radius, 0.0), (radius, height), (radius * 0.25, height + radius * 0.55),
                   (radius * 0.25, height + radius * 0.55 + 0.8),
                   (0.0, height + radius * 0.6 + 0.8)),
                  16, lambda r, c: "hall_light")


def chimney(height):
    return turned(((1.9, 0.0), (1.25, height - 5), (1.2, height - 3), (1.15, height), (0.9, height),
                   (0.0, height - 0.1)), 12, lambda r, c: "band_red" if r == 1 else "hall")


def backdrop():
    sheet = moved(hall(), (6, 0, 54)) + turned_by(hall(), 180, (-12, 0, -56))
    for i, (radius, height) in enumerate(((4.2, 15.0), (4.2, 15.0), (3.0, 19.0))):
        sheet += moved(silo(radius, height), (53.0, 0, -14.0 + 10.0 * i))
    sheet += moved(chimney(34.0), (56, 0, 26)) + moved(chimney(27.0), (-54, 0, -22))
    sheet += moved(box((0, 5.0, 0), (14.0, 10.0, 40.0), "hall", (1, 1, 4)), (-54, 0, 12))
    for z in (-6.0, 2.0):
        sheet += tube([(48.8, 9.0, z), (47.0, 9.0, z), (47.0, 0.0, z)], 0.45, "hall_light", 8)
    return sheet


def structures():
    """(name, sheet) of the fixed structures."""
    yield "walls", walls()
    yield "bridge", bridge()
    yield "columns", colonnades()
    yield "ramps", ramps()
    yield "blocks", [face for x, z, degrees in BLOCKS
                     for face in turned_by(barrier_block(3.2), degrees, (x, 0, z))]
    yield "masts", masts()
    yield "plinths", plinths(PLACES)
    yield "markings", markings()
    yield "backdrop", backdrop()
