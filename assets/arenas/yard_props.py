"""The cuttable props of the arenas, of thin painted sheet. Each stands on y = 0 about the origin."""

from car_sheet import facing, grid, moved
from panel import panel, rectangle
from turned import box, tube, turned


def drum():
    """A steel drum with two rolled beads and a sunken lid."""
    r = 0.29
    profile = ((0.0, 0.02), (r - 0.02, 0.02), (r, 0.0), (r, 0.27), (r + 0.02, 0.295), (r, 0.32),
               (r, 0.56), (r + 0.02, 0.585), (r, 0.61), (r, 0.88), (r - 0.025, 0.86), (0.0, 0.865))
    white = (5,)
    yield "drum", turned(profile, 14, lambda i, c: "drum_stripe" if i in white else "drum")


def barrier():
    """A crowd barrier of sheet, red and white, on two bent feet."""
    half, low, high = 1.0, 0.30, 0.95
    columns = [-half + 2 * half * i / 16 for i in range(17)]
    rows = []
    for v in range(5):
        y = low + (high - low) * v / 4
        bead = 0.03 if v in (1, 2, 3) else 0.0
        rows.append([(x, y, bead) for x in columns])

    def paint(r, c):
        return "sheet_red" if (c + r) // 2 % 2 else "sheet_white"
    yield "panel", grid(rows, paint, (0, 0.5, 9))
    foot = ((-0.34, 0.0), (-0.30, 0.03), (-0.035, 0.06), (0.035, 0.06), (0.30, 0.03), (0.34, 0.0))
    post = ((-0.03, 0.05), (-0.03, 0.3), (-0.03, 0.6), (-0.03, 0.9))
    for place, x in (("left", 0.8), ("right", -0.8)):
        for name, line in (("foot", foot), ("post", post)):
            strip = [[(x + dx, y, z) for z, y in line] for dx in (-0.04, 0.04)]
            yield f"{name}_{place}", grid(strip, lambda r, c: "sheet_steel", (x, 9, -9))


def sign():
    """A board with arrows that show the way of the circuit, on two posts with plates as feet."""
    half, low, high = 1.1, 0.75, 1.55
    middle = (low + high) / 2
    board = [("sheet_yellow", rectangle(-half, low, half, high))]
    for x in (-0.85, -0.2, 0.45):
        board.append(("sign_dark", [(x, low), (x + 0.25, low), (x + 0.6, middle), (x + 0.25, high),
                                    (x, high), (x + 0.35, middle)]))
    yield "board", facing(panel(board, 0.3, lambda x, y: (x, y, 0.0)), (0, 1, 9))
    for name, x in (("post_left", 0.8), ("post_right", -0.8)):
        yield name, tube([(x, 0.02, -0.045), (x, 1.5, -0.045)], 0.035, "sheet_steel", 5, pieces=4)
    for name, x in (("plate_left", 0.8), ("plate_right", -0.8)):
        yield name, moved(turned(((0.30, 0.0), (0.28, 0.02), (0.05, 0.035), (0.0, 0.035)), 9,
                                 lambda r, c: "sheet_steel"), (x, 0, -0.045))


def pylon():
    """A board with the arrows of the circuit, high on one side of a column: it falls as soon as the
    column is cut, and stands before, on a heavy foot."""
    yield "foot", box((0, 0.2, 0), (1.3, 0.4, 1.3), "sheet_steel", (3, 1, 3))
    yield "column", tube([(0, 0.38, 0), (0, 5.3, 0)], 0.14, "sheet_steel", 6, pieces=6)
    for name, y in (("arm_low", 4.05), ("arm_high", 5.0)):
        yield name, box((1.2, y, 0), (2.3, 0.08, 0.08), "sheet_steel", (3, 1, 1))
    low, high = 3.85, 5.2
    middle = (low + high) / 2
    for name, z in (("board_front", 0.06), ("board_rear", -0.06)):
        board = [("sheet_yellow", rectangle(0.25, low, 2.45, high))]
        for x in (0.4, 1.05, 1.7):
            board.append(("sign_dark", [(x, low), (x + 0.25, low), (x + 0.6, middle),
                                        (x + 0.25, high), (x, high), (x + 0.35, middle)]))
        yield name, facing(panel(board, 0.5, lambda x, y, z=z: (x, y, z)), (1, 4.5, 99 * z))


def lamp_post():
    """A lamp post of 200 kg, on a foot plate."""
    profile = ((0.0, 0.0), (0.40, 0.0), (0.12, 0.05), (0.11, 1.2), (0.105, 2.8), (0.095, 4.6), (0.08, 6.9),
               (0.0, 6.9))
    yield "post", turned(profile, 6, lambda r, c: "post")
    yield "arm", tube([(0, 6.7, 0.06), (0, 7.0, 0.5), (0, 7.05, 1.5)], 0.045, "post", 4)
    yield "head", box((0, 7.02, 1.85), (0.34, 0.14, 0.8), "post")
    yield "glass", [("post_lamp", ((-0.14, 6.945, 1.5), (0.14, 6.945, 1.5), (0.14, 6.945, 2.2),
                                   (-0.14, 6.945, 2.2)))]


def gantry():
    """Two legs and a girder with a board across a road of 8 m, nearly two tonnes in all."""
    leg = ((0.0, 0.0), (0.44, 0.0), (0.19, 0.06), (0.18, 1.4), (0.18, 2.9), (0.18, 4.4), (0.0, 4.4))
    for name, x in (("leg_left", 4.2), ("leg_right", -4.2)):
        yield name, moved(turned(leg, 6, lambda r, c: "gantry_black" if r == 3 else "gantry_steel"),
                          (x, 0, 0))
    yield "girder", box((0, 4.7, 0), (9.0, 0.6, 0.5), "gantry_steel", (6, 1, 1))
    low, high = 5.0, 6.0
    middle = (low + high) / 2
    board = [("sign_dark", rectangle(-2.2, low, 2.2, high))]
    for x in (-1.7, -0.4, 0.9):
        board.append(("sheet_yellow", [(x, low + 0.15), (x + 0.3, low + 0.15), (x + 0.65, middle),
                                       (x + 0.3, high - 0.15), (x, high - 0.15), (x + 0.35, middle)]))
    for name, z in (("board_front", 0.12), ("board_rear", -0.12)):
        yield name, facing(panel(board, 1.1, lambda x, y, z=z: (x, y, z)), (0, middle, 99 * z))


def stack():
    """A chimney of sheet, three quarters of a tonne."""
    profile = ((0.0, 0.0), (0.62, 0.0), (0.45, 0.08), (0.44, 2.0), (0.44, 4.0), (0.44, 6.0), (0.5, 7.2),
               (0.5, 7.9), (0.0, 7.9))
    yield "stack", turned(profile, 10, lambda r, c: "stack_band" if r in (3, 6) else "stack")


def corrugated(length, low, high, waves, rows, depth):
    """Points of an upright corrugated sheet along x from 0 to length; it bulges towards +z."""
    line = [(length * (i + share) / waves, rise) for i in range(waves)
            for share, rise in ((0.0, 0.0), (0.36, 0.0), (0.5, depth), (0.86, depth))]
    line.append((length, 0.0))
    return [[(x, low + (high - low) * v / rows, rise) for x, rise in line] for v in range(rows + 1)]


def container():
    """A twenty-foot container of corrugated sheet, closed, with doors at +z."""
    length, width, height = 6.06, 2.44, 2.59
    x, z, low, high = width / 2, length / 2, 0.12, height - 0.12
    side = corrugated(length, low, high, 9, 2, 0.07)
    sheet = []
    for sign in (-1, 1):
        rows = [[(sign * (x - 0.075 + d), y, a - z) for a, y, d in line] for line in side]
        sheet += grid(rows, lambda r, c: "container", (sign * 99, 1, 0))
    roof = corrugated(length, 0.0, width - 0.1, 9, 1, -0.03)
    roof = [[(b - x + 0.05, high + d, a - z) for a, b, d in line] for line in roof]
    sheet += grid(roof, lambda r, c: "container", (0, 99, 0))
    end = corrugated(width - 0.1, low, high, 4, 2, 0.07)
    sheet += grid([[(a - x + 0.05, y, -z - d + 0.075) for a, y, d in line] for line in end],
                  lambda r, c: "container", (0, 1, -99))
    yield "shell", sheet
    floor = [[(b - x + 0.05, 0.14, a - z) for a in (0, 1.5, 3, 4.5, 6.0)] for b in
             (0, 0.78, 1.56, width - 0.1)]
    yield "floor", grid(floor, lambda r, c: "sheet_steel", (0, 99, 0))
    yield from container_doors(z, low, high)
    yield from container_frame(x, z, height)


def container_doors(z, low, high):
    for name, sign in (("door_left", 1), ("door_right", -1)):
        rows = []
        for v in range(6):
            y = low + (high - low) * v / 5
            rows.append([(sign * a, y, z - 0.01 + (0.03 if v in (1, 3) and 0.1 < a < 1.1 else 0.0))
                         for a in (0.006, 0.14, 0.4, 0.65, 0.9, 1.165)])
        yield name, grid(rows, lambda r, c: "container", (0, 1, 99))
        for k, a in (("inner", 0.27), ("outer", 0.8)):
            rod = tube([(sign * a, low + 0.04, z + 0.05), (sign * a, high - 0.04, z + 0.05)], 0.018,
                       "sheet_steel", 4, pieces=3)
            yield f"{name}_rod_{k}", rod


def container_frame(x, z, height):
    for i in (-1, 1):
        for j in (-1, 1):
            yield f"post_{'left' if i > 0 else 'right'}_{'front' if j > 0 else 'rear'}", box(
                (i * (x - 0.07), height / 2, j * (z - 0.07)), (0.13, height - 0.02, 0.13),
                "container_frame", (1, 4, 1))
    for y in (0.07, height - 0.07):
        level = "low" if y < 1 else "high"
        for i, side_name in ((-1, "right"), (1, "left")):
            yield f"rail_{level}_{side_name}", box((i * (x - 0.07), y, 0),
                                                   (0.12, 0.13, 2 * z - 0.3), "container_frame",
                                                   (1, 1, 8))
        for j, end_name in ((-1, "rear"), (1, "front")):
            yield f"rail_{level}_{end_name}", box((0, y, j * (z - 0.07)), (2 * x - 0.3, 0.13, 0.12),
                                                  "container_frame", (4, 1, 1))
