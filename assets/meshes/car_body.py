"""The car's body: one edge-connected sheet of side, deck, roof on its pillars, arches and floor.

Only the left half is laid out, as patches of quads that share their border points; the right half
is its mirror image. The window openings are cells left out.

    deck     bonnet, windscreen, roof and tailgate window: rows across the car, one per station
    side     nose, wheel arches, doors and tail, from the lower edge to the belt line
    cabin    pillars and window frames between the belt line and the edge of the deck
    floor    undertray, closed at the wheel housings by their lining
"""

import math

from car_sheet import facing, fan, grid, lerp, mirrored, mix, smooth_curve, smoothstep
from car_shape import (ARCH_BAND, ARCH_RADIUS, AXLES, INNER_X, WHEEL_RADIUS, CrossProfile,
                       glass_point, side_point, skin_point, wrap_point)

ROWS = (0, 0.1, 0.28, 0.45, 0.62, 0.78, 0.9, 1)
# Heights v of single rows at each column of LATERAL, which give grille and lights their outline.
NOSE_ROWS = {2: (0.24, 0.24, 0.24, 0.25, 0.28, 0.29, 0.28, 0.28),
             3: (0.38, 0.38, 0.38, 0.39, 0.41, 0.43, 0.45, 0.45),
             4: (0.67, 0.67, 0.67, 0.665, 0.65, 0.63, 0.63, 0.715),
             5: (0.79, 0.79, 0.79, 0.79, 0.795, 0.82, 0.845, 0.84),
             6: (0.88, 0.88, 0.88, 0.88, 0.885, 0.90, 0.92, 0.92)}
TAIL_ROWS = {4: (0.56, 0.56, 0.56, 0.57, 0.66, 0.645, 0.63, 0.62),
             5: (0.77, 0.77, 0.77, 0.77, 0.775, 0.77, 0.77, 0.77),
             6: (0.885, 0.885, 0.885, 0.885, 0.875, 0.885, 0.895, 0.90)}
LATERAL = (0, 0.13, 0.26, 0.40, 0.53, 0.64, 0.73, 0.80)
BUMPER_ROW = 3             # the gap between hatch and rear bumper
ARCH_TOP_SEGMENTS = 6
# z of the borders of the arch patches at the lower edge and at the belt line
ARCH_BORDERS = {"front": ((1.75, 1.62), (0.85, 0.76)), "rear": ((-0.85, -0.87), (-1.75, -1.66))}
DOOR_COLUMNS = ((0.85, 0.76), (0.60, 0.60), (0.38, 0.38), (0.14, 0.14), (-0.10, -0.12),
                (-0.22, -0.22), (-0.42, -0.42), (-0.64, -0.64), (-0.85, -0.87))

# Stations of the deck, front to rear: 0 the bonnet's leading edge, 25 the tail's upper edge.
A_BASE, WINDSCREEN = 7, (8, 12)
BONNET_RIDGE = 4           # column
B_PILLAR, WINDOW_FRONT, WINDOW_REAR = (14, 15), 9, 18
TAILGATE_TOP, TAILGATE_WINDOW, TAIL = 21, (22, 24), 25
edge_z = smooth_curve([(7, 0.76), (8, 0.67), (9, 0.565), (12, 0.205), (13, 0.10), (14, -0.12),
                       (15, -0.22), (16, -0.45), (17, -0.71), (18, -0.97), (19, -1.11),
                       (20, -1.255), (21, -1.375), (22, -1.44), (24, -1.66), (25, -1.76)])
edge_y = smooth_curve([(7, 0.875), (8, 0.945), (9, 1.020), (12, 1.290), (13, 1.316), (14, 1.332),
                       (15, 1.338), (16, 1.342), (18, 1.325), (20, 1.292), (21, 1.268),
                       (22, 1.205), (24, 1.025), (25, 0.96)])
middle_z = smooth_curve([(0, 1.93), (7, 1.03), (8, 0.96), (12, 0.265), (13, 0.165), (14, -0.02),
                         (15, -0.17), (16, -0.42), (18, -0.95), (21, -1.475), (22, -1.53),
                         (24, -1.88), (25, -1.95)])
middle_y = smooth_curve([(0, 0.685), (2, 0.775), (5, 0.885), (7, 0.918), (8, 0.942), (12, 1.345),
                         (13, 1.377), (14, 1.405), (16, 1.42), (18, 1.407), (20, 1.362),
                         (21, 1.335), (22, 1.285), (24, 1.04), (25, 0.965)])


def body():
    front, rear = Arch("front"), Arch("rear")
    nose, tail = wrap(1, front.ahead), wrap(-1, rear.behind)
    doors = [column(*ends) for ends in DOOR_COLUMNS]
    rows = deck_rows(nose, tail, front)
    belt = [door[-1] for door in doors] + rear.belt[1:] + [tail[-2][-1]]
    half = (nose_skin(nose) + front.skin() + door_skin(doors) + rear.skin() + tail_skin(tail)
            + deck_skin(rows) + window_skin([row[-1] for row in rows], belt)
            + front.lining() + rear.lining() + floor(front, doors, rear))
    return half + mirrored(half)


# ---- side ---------------------------------------------------------------------------------------

def column(low_z, belt_z):
    """Points of the body side from the lower edge to the belt line."""
    return [side_point(lerp(low_z, belt_z, v), v) for v in ROWS]


def wrap(end, border):
    """Columns of the nose (end +1) or tail (-1), from the middle to the border of the arch."""
    heights = NOSE_ROWS if end > 0 else TAIL_ROWS
    return [[wrap_point(end, fraction, heights[r][c] if r in heights else v)
             for r, v in enumerate(ROWS)] for c, fraction in enumerate(LATERAL)] + [border]


def nose_skin(columns):
    def paint(c, r):
        grille = c < 4 and r == 4
        intake = c < 4 and r in (1, 2) or c in (5, 6) and r == 2
        if r == 0 or grille or intake:
            return "trim"
        return "light_front" if c in (4, 5, 6) and r == 4 else "paint"
    return grid(columns, paint, viewer=(2, 0.5, 4))


def tail_skin(columns):
    def paint(c, r):
        plate_recess = c < 3 and r == 4
        if r == 0 or r == 1 and c < 6 or plate_recess:
            return "trim"
        return "light_rear" if c > 3 and r in (4, 5) else "paint"
    return grid(columns, paint, viewer=(2, 0.5, -4), seams=(BUMPER_ROW,),
                seam_width=0.016)


def door_skin(columns):
    rows = list(zip(*columns))
    return grid(rows, lambda r, c: "trim" if r == 0 else "paint", viewer=(9, 0.5, 0),
                seams=(1, 4, 7))


class Arch:
    """The body side around one wheel: rings of points from the opening's lip to the border."""

    def __init__(self, name):
        self.axle_z = AXLES[0 if name == "front" else 1]
        ahead, behind = ARCH_BORDERS[name]
        self.ahead, self.behind = column(*ahead), column(*behind)
        steps = [i / ARCH_TOP_SEGMENTS for i in range(1, ARCH_TOP_SEGMENTS)]
        self.belt = ([self.ahead[-1]] + [side_point(lerp(ahead[1], behind[1], t), 1) for t in steps]
                     + [self.behind[-1]])
        border = self.ahead[:-1] + self.belt + self.behind[-2::-1]
        lip, band = (self._circle(ARCH_RADIUS + d, len(border), 0.012) for d in (0, ARCH_BAND))
        between = [skin_point(lerp(p[2], q[2], 0.45), lerp(p[1], q[1], 0.45), 0.004)
                   for p, q in zip(band, border)]
        self.rings = [lip, band, between, border]
        self.lip = lip

    def skin(self):
        last = len(self.lip) - 2
        return grid(self.rings, lambda ring, c: "trim" if c in (0, last) else "paint",
                    viewer=(9, 0.6, self.axle_z))

    def lining(self):
        """The wheel housing: a strip inwards from the lip, and the wall it ends at."""
        inner = [(INNER_X, y, z) for _, y, z in self.lip]
        hub = (INNER_X, WHEEL_RADIUS, self.axle_z)
        viewer = (0.7, WHEEL_RADIUS, self.axle_z)
        strip = grid([self.lip, inner], lambda r, c: "trim", viewer)
        return strip + fan(inner + self.chord()[::-1][1:], hub, "trim", viewer)

    def chord(self):
        """The lower edge of the housing's wall, front to rear."""
        (_, y, front), (_, _, rear) = self.lip[0], self.lip[-1]
        return [(INNER_X, y, lerp(front, rear, i / 4)) for i in range(5)]

    def lower_edges(self):
        """The lower points ahead of the opening and behind it, both front to rear."""
        return [ring[0] for ring in reversed(self.rings)], [ring[-1] for ring in self.rings]

    def _circle(self, radius, count, bulge):
        low = math.asin((self.ahead[0][1] - WHEEL_RADIUS) / radius)
        points = []
        for i in range(count):
            angle = lerp(low, math.pi - low, i / (count - 1))
            y = self.ahead[0][1] if i in (0, count - 1) else WHEEL_RADIUS + radius * math.sin(angle)
            points.append(skin_point(self.axle_z + radius * math.cos(angle), y, bulge))
        return points


# ---- deck ---------------------------------------------------------------------------------------

def deck_rows(nose, tail, front_arch):
    """Rows across the deck, from the middle to its edge, one per station."""
    first = [col[-1] for col in nose[:-1]]
    last = [col[-1] for col in tail[:-1]]
    fractions = [c / LATERAL[-1] for c in LATERAL]
    crowned = CrossProfile.crowned(fractions, 2.2, 2.5)
    nose_profile, tail_profile = CrossProfile.through(first), CrossProfile.through(last)
    rows = [first]
    for station in range(1, TAIL):
        profile = nose_profile.towards(crowned, smoothstep(0, 6, station))
        profile = profile.towards(tail_profile, smoothstep(TAILGATE_TOP, TAIL, station))
        middle = (0.0, middle_y(station), middle_z(station))
        edge = (front_arch.belt[station - 1] if station <= A_BASE
                else glass_point(edge_z(station), edge_y(station)))
        row = profile.row(middle, edge)
        x, y, z = row[BONNET_RIDGE]
        row[BONNET_RIDGE] = (x, y + bonnet_ridge(station), z)
        rows.append(row)
    return rows + [last]


def bonnet_ridge(station):
    """Height of the bonnet's two ridges, which run out at both ends."""
    return 0.011 * smoothstep(0, 3, station) * (1 - smoothstep(A_BASE - 1, A_BASE + 1, station))


def deck_skin(rows):
    pillar = len(LATERAL) - 2

    def paint(r, c):
        station = r + A_BASE
        if c < pillar and (WINDSCREEN[0] <= station < WINDSCREEN[1]
                           or TAILGATE_WINDOW[0] <= station < TAILGATE_WINDOW[1]):
            return None
        return "trim" if c < pillar and station == A_BASE else "paint"

    bonnet = grid(rows[:A_BASE + 1], lambda r, c: "paint", viewer=(0, 9, 0), seams=(pillar,),
                  seam_width=0.014)
    return bonnet + grid(rows[A_BASE:], paint, viewer=(0, 9, 0))


# ---- cabin --------------------------------------------------------------------------------------

def window_skin(edge, belt):
    """Window frames and pillars; edge is the deck's, one point per station, belt from A to C."""
    above_arch = len(DOOR_COLUMNS) + 3
    rear = [glass_line(belt[above_arch], edge[WINDOW_REAR], i / 4) for i in range(5)]
    sill = belt[1:above_arch + 1]
    roof = edge[WINDOW_FRONT:WINDOW_REAR + 1]
    viewer = (9, 1, 0)
    sail = [("trim", (belt[0], belt[1], edge[A_BASE + 1])),
            ("trim", (belt[1], edge[WINDOW_FRONT], edge[A_BASE + 1]))]
    return (facing(sail, viewer) + window_frame(roof, rear, sill, viewer)
            + rear_pillar(rear, edge, belt[above_arch:], viewer))


def glass_line(low, high, t):
    if t in (0, 1):
        return mix(low, high, t)
    return glass_point(lerp(low[2], high[2], t), lerp(low[1], high[1], t))


def window_frame(roof, rear, sill, viewer):
    """A band inside the window's outline, and the B pillar across the opening."""
    outline = roof + rear[-2:0:-1] + sill[::-1]
    widths = ([0.032] * (len(roof) - 1) + [0.03] * (len(rear) - 1) + [0.026] * (len(sill) - 1)
              + [0.03])
    inner = [glass_point(z, y) for z, y in inset([(z, y) for _, y, z in outline], widths)]
    band = grid([outline + outline[:1], inner + inner[:1]], lambda r, c: "trim", viewer)
    tops = [inner[station - WINDOW_FRONT] for station in B_PILLAR]
    feet = [inner[len(inner) - 1 - (c - 1)] for c in (4, 5)]
    pillar = [[glass_line(foot, top, i / 3) for foot, top in zip(feet, tops)] for i in range(4)]
    return band + grid(pillar, lambda r, c: "trim", viewer)


def inset(loop, widths):
    """The polygon with edge i, from corner i to the next, moved inwards by widths[i].

    The loop is a list of (z, y), counter-clockwise as drawn with z to the right. At a corner
    between two widths the mean of both holds.
    """
    normals = []
    for (z0, y0), (z1, y1) in zip(loop, loop[1:] + loop[:1]):
        length = math.hypot(z1 - z0, y1 - y0)
        normals.append((-(y1 - y0) / length, (z1 - z0) / length))
    corners = []
    for i, (z, y) in enumerate(loop):
        (a, b), (c, d) = normals[i - 1], normals[i]
        mitre = (widths[i - 1] + widths[i]) / 2 / (1 + a * c + b * d)
        corners.append((z + (a + c) * mitre, y + (b + d) * mitre))
    return corners


def rear_pillar(rear, edge, sill, viewer):
    """The C pillar, blended from its four sides (a Coons patch in the side view)."""
    roof, hatch = edge[WINDOW_REAR:TAILGATE_TOP + 1], edge[TAIL:TAILGATE_TOP - 1:-1]
    rows = []
    for j in range(len(rear)):
        t, row = j / (len(rear) - 1), []
        for i in range(len(sill)):
            s = i / (len(sill) - 1)
            if i in (0, len(sill) - 1) or j in (0, len(rear) - 1):
                row.append(rear[j] if i == 0 else hatch[j] if i == len(sill) - 1
                           else sill[i] if j == 0 else roof[i])
                continue
            across, along = mix(rear[j], hatch[j], s), mix(sill[i], roof[i], t)
            corners = mix(mix(rear[0], hatch[0], s), mix(rear[-1], hatch[-1], s), t)
            _, y, z = (a + b - c for a, b, c in zip(across, along, corners))
            row.append(glass_point(z, y))
        rows.append(row)
    return grid(rows, lambda r, c: "paint", viewer)


# ---- floor --------------------------------------------------------------------------------------

def floor(front, doors, rear):
    """The undertray, in strips between the lower edges of the side."""
    ahead, behind_front = front.lower_edges()
    ahead_rear, behind = rear.lower_edges()
    sill = behind_front + [door[0] for door in doors[1:-1]] + ahead_rear
    strips = ([floor_row(p) for p in ahead], [floor_row(p)[:3] for p in front.chord()],
              [floor_row(p) for p in sill], [floor_row(p)[:3] for p in rear.chord()],
              [floor_row(p) for p in behind])
    return [face for strip in strips for face in grid(strip, lambda r, c: "trim", (0, -9, 0))]


def floor_row(outer):
    _, y, z = outer
    return [(0.0, y, z), (INNER_X / 2, y, z), (INNER_X, y, z), outer]
