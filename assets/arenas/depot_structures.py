"""The depot: a narrow court between two galleries, their ramps and a bridge, and the places of its props."""

from car_sheet import moved
from concrete import PLINTH, barrier_block, plinths, prism, ring_wall, turned_by
from turned import box, turned
from yard_structures import chimney, hall, mast, silo, stripe

HALF_X, HALF_Z = 18.0, 42.0           # m, from the middle to the walls
SIZE, INTENSITY = [36, 84], 0.024
INNER, OUTER = 10.2, 17.9             # m, edges of the galleries from the middle
DECK, CLEAR, TALL = 3.4, 2.9, 13.0    # m, height of the floor, of the passage below, of the masts
# (distance from the middle along z, height of the road); no slope is over 12 degrees
ROAD = ((11.0, DECK), (12.5, DECK - 0.15), (27.6, 0.15), (29.1, 0.0))
BRIDGE = 3.5                          # m, half of its width
BLOCKS = [(4.5, 13.0, 20), (-4.5, -13.0, 20), (-5.5, 26.5, 75), (5.5, -26.5, 75), (-2.0, 19.0, 100),
          (2.0, -19.0, 100)]
MASTS = [(x, z) for x in (-20.6, 20.6) for z in (-21.0, 21.0)]
PLACES = {
    "container": [(5.6, 0, 21.5, 5), (-5.6, 0, -21.5, 5), (-13.6, 0, 37.2, 90), (13.6, 0, -37.2, 90),
                  (13.6, 2.59, -37.2, 84)],
    "drum": [(0.4, 0, 8.5, 0), (-0.4, 0, 8.1, 25), (0.3, 0, -8.5, 0), (-0.5, 0, -8.2, 70), (9.3, 0, 33.0, 0),
             (-9.3, 0, -33.0, 15), (-9.0, 0, -32.2, 40)],
    "barrier": [(-6.5, 0, 7.5, 90), (6.5, 0, -7.5, 90), (3.2, 0, 36.5, 0), (-3.2, 0, -36.5, 0)],
    "sign": [(0, 0, 39.6, 180), (0, 0, -39.6, 0)],
    "lamp_post": [(8.6, PLINTH, 15.5, 270), (-8.6, PLINTH, -15.5, 90), (-8.6, PLINTH, 31.0, 90),
                  (8.6, PLINTH, -31.0, 270)],
    "gantry": [(0, PLINTH, 29.5, 0), (0, PLINTH, -29.5, 0)],
    "stack": [(-7.6, PLINTH, 20.0, 0), (7.6, PLINTH, -20.0, 0)],
}
ENEMIES = [(0, 33.7, 180), (-13.8, 32.5, 180), (13.8, 32.5, 180), (5.5, 7.2, 180), (-13.8, 2.5, 180), (13.8, -2.5, 0),
           (-6.5, 12.5, 180), (6.5, -12.5, 0), (-5.5, -7.5, 0), (13.8, 7.9, 180), (-13.8, -7.9, 0), (0, 24, 180)]
PLAYER = (2, 0, -33)


def walls():
    """Walls of a roofless hall with a sloping foot, pillars, windows and a gate at both ends."""
    profile = ((-0.42, 0.0), (-0.38, 0.10), (-0.16, 0.42), (0.0, 1.0), (0.0, 7.0), (-0.12, 7.0), (-0.12, 7.3),
               (0.52, 7.3), (0.52, 7.0), (0.4, 7.0), (0.4, 0.0))
    names = {0: "concrete_dark", 1: "concrete_dark", 2: "concrete_dark"}
    sheet = ring_wall(HALF_X, HALF_Z, profile, lambda i: names.get(i, "concrete"), 10)
    for side in (-1, 1):
        for i in range(-6, 7):
            sheet += box((side * (HALF_X - 0.02), 5.35, 6.4 * i), (0.4, 3.6, 0.7), "concrete")
            if i < 6:
                sheet += window(side, 6.4 * i + 3.2, i % 4 == 1)
        sheet += turned_by(gate(), 0 if side > 0 else 180)
    return sheet


def window(side, z, lit):
    x, a, low, high = side * (HALF_X - 0.04), 2.3, 4.6, 6.1
    corners = ((x, low, z - a), (x, low, z + a), (x, high, z + a), (x, high, z - a))
    return [("window_lit" if lit else "window_dark", corners if side > 0 else corners[::-1])]


def gate():
    """A closed gate of slats in a frame."""
    z = HALF_Z - 0.1
    sheet = [("gate", ((-3.4, y, z), (-3.4, y + 0.34, z), (3.4, y + 0.34, z), (3.4, y, z)))
             for y in (0.2 + 0.38 * i for i in range(11))]
    for x in (-3.7, 3.7):
        sheet += box((x, 2.3, z), (0.6, 4.6, 0.5), "concrete_dark")
    return sheet + box((0, 4.55, z), (8.0, 0.6, 0.6), "concrete_dark")


def road_paint(side):
    return {"top": "asphalt", "bottom": "concrete_dark"}.get(side, "concrete")


def edge_paint(side):
    return "band_edge" if side == "top" else "concrete"


def gallery():
    """The gallery at positive x: its deck along z, a ramp at either end, and parapets, open to the bridge."""
    ramp = [(z, 0.0, y) for z, y in ROAD]
    deck = [(z, CLEAR, DECK) for z in (-ROAD[0][0], 0.0, ROAD[0][0])]
    half, middle = (OUTER - INNER) / 2, (OUTER + INNER) / 2
    stations = [(-z, low, high) for z, low, high in ramp[::-1]] + deck + ramp
    sheet = moved(prism(stations, half, road_paint, "z"), (middle, 0, 0))
    road = [(z, y - 0.02, y + 0.8) for z, y in ROAD[:-1]]
    for sign in (-1, 1):
        line = [(BRIDGE + 0.1, DECK - 0.02, DECK + 0.8), *road]
        line = line if sign > 0 else [(-z, low, high) for z, low, high in line[::-1]]
        sheet += moved(prism(line, 0.14, edge_paint, "z"), (INNER + 0.16, 0, 0))
    for z in (-10.4, -5.2, 5.2, 10.4):
        sheet += moved(pillar(), (INNER + 0.5, 0, z))
    for sign in (-1, 1):                # marks how high the passage is
        sheet += box((middle, CLEAR + 0.25, sign * (ROAD[0][0] - 0.3)), (5.0, 0.5, 0.06), "band")
    return sheet


def pillar():
    return turned(((0.42, 0.0), (0.42, 0.5), (0.34, 0.7), (0.34, CLEAR)), 10,
                  lambda r, c: "band" if r == 0 else "concrete")


def bridge():
    """The bridge along x, on two pillars."""
    sheet = prism([(x, CLEAR, DECK) for x in (-INNER, 0.0, INNER)], BRIDGE, road_paint)
    for side in (-1, 1):
        parapet = prism([(x, DECK - 0.02, DECK + 0.8) for x in (-INNER + 0.2, 0.0, INNER - 0.2)], 0.14,
                        edge_paint)
        sheet += moved(parapet, (0, 0, side * (BRIDGE - 0.16)))
        sheet += moved(pillar(), (0, 0, side * 2.3))
        for x in (-6.0, 6.0):
            sheet += box((x, CLEAR + 0.25, side * (BRIDGE + 0.03)), (3.0, 0.5, 0.06), "band")
    return sheet


def markings():
    """The middle of the court, bays at its ends, and arrows' stems before the ramps."""
    sheet = []
    for i in range(-8, 9):
        if abs(i) > 1:
            sheet += stripe(0, 4.2 * i, 1.8, 0.16, 0)
    for end in (-1, 1):
        for i in range(5):
            sheet += stripe(-6.0 + 3.0 * i, end * 38.2, 4.4, 0.14, 0)
        for side in (-1, 1):
            for x in (12.4, 15.6):
                sheet += stripe(side * x, end * 32.0, 3.4, 0.16, 0)
    return sheet


def backdrop():
    sheet = turned_by(hall(), 90, (33, 0, 4)) + turned_by(hall(), -90, (-33, 0, -6))
    for i, z in enumerate((-34.0, -24.0)):
        sheet += moved(silo(3.6, 14.0 + 3 * i), (-30.0, 0, z - 16))
    return sheet + moved(chimney(30.0), (26, 0, 52)) + moved(chimney(24.0), (-22, 0, -58))


def lamps():
    """The floodlights of the masts beyond the walls, a little before their glass."""
    return [(round(x * 0.97, 3), TALL + 0.15, round(z * 0.97, 3)) for x, z in MASTS]


def structures():
    """(name, sheet) of the fixed structures."""
    yield "walls", walls()
    right = gallery()
    yield "galleries", right + turned_by(right, 180)
    yield "bridge", bridge()
    yield "blocks", [face for x, z, degrees in BLOCKS
                     for face in turned_by(barrier_block(3.2), degrees, (x, 0, z))]
    yield "masts", [face for x, z in MASTS for face in mast(x, z)]
    yield "plinths", plinths(PLACES)
    yield "markings", markings()
    yield "backdrop", backdrop()
