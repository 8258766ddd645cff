"""Sheets that are turned about an axis, swept along a line, or bent into a box."""

import math

from car_sheet import cross, dot, fan, grid, minus, moved


def turned(profile, count, paint, axis="y"):
    """The surface of revolution of a profile of (radius, height) about the axis through the origin.

    It shows its front outwards where the heights rise. A radius of 0 at either end closes it.
    paint(row, column) names the material of a cell.
    """
    place = {"y": lambda a, b, h: (a, h, b), "z": lambda a, b, h: (b, a, h),
             "x": lambda a, b, h: (h, b, a)}[axis]

    def circle(radius, height):
        steps = [2 * math.pi * (i % count) / count for i in range(count + 1)]
        return [place(radius * math.sin(t), radius * math.cos(t), height) for t in steps]

    sheet = []
    rows = [circle(*step) for step in profile]
    for r, (low, high) in enumerate(zip(rows, rows[1:])):
        if profile[r][0] == 0:
            sheet += [(paint(r, c), (low[0], high[c + 1], high[c])) for c in range(count)]
        elif profile[r + 1][0] == 0:
            sheet += [(paint(r, c), (low[c], low[c + 1], high[0])) for c in range(count)]
        else:
            sheet += grid([low, high], lambda _, c, r=r: paint(r, c))
    return sheet


def unit(v):
    length = math.sqrt(dot(v, v))
    return tuple(a / length for a in v)


def tube(points, radius, material, sides=6, capped=True, pieces=1, waist=1.0):
    """A tube along a polyline, mitred at its corners, each straight run in as many pieces as told.

    Every second ring is narrower by the factor `waist`, as the coils of a spring.
    """
    course = [points[0]]
    for p, q in zip(points, points[1:]):
        course += [tuple(a + (b - a) * i / pieces for a, b in zip(p, q))
                   for i in range(1, pieces + 1)]
    runs = [unit(minus(q, p)) for p, q in zip(course, course[1:])]
    side = unit(cross(runs[0], min(((1, 0, 0), (0, 1, 0), (0, 0, 1)),
                                   key=lambda e: abs(dot(e, runs[0])))))
    rings = []
    for i, point in enumerate(course):
        before, after = runs[max(i - 1, 0)], runs[min(i, len(runs) - 1)]
        along = unit(tuple(a + b for a, b in zip(before, after)))
        side = unit(tuple(s - dot(side, before) * b for s, b in zip(side, before)))
        other = cross(before, side)
        ring = []
        reach = radius * (waist if i % 2 else 1)
        for k in range(sides):
            t = 2 * math.pi * (k + 0.5) / sides
            p = tuple(reach * (math.cos(t) * s + math.sin(t) * o) for s, o in zip(side, other))
            shift = dot(p, along) / dot(before, along)      # onto the plane of the mitre
            ring.append(tuple(c + a - shift * b for c, a, b in zip(point, p, before)))
        rings.append(ring + ring[:1])
    sheet = grid(rings, lambda r, c: material)
    if capped:
        ahead, behind = ((course[0], runs[0], -1), (course[-1], runs[-1], 1))
        for (centre, run, sign), ring in ((ahead, rings[0]), (behind, rings[-1])):
            viewer = tuple(c + 9 * sign * r for c, r in zip(centre, run))
            sheet += fan(ring, centre, material, viewer)
    return sheet


def box(centre, size, material, cells=(1, 1, 1), top=1.0):
    """A closed box, its cells counted along x, y and z; its upper side is scaled by `top`."""
    sheet = []
    half = [s / 2 for s in size]

    def place(p):
        shrink = 1 + (top - 1) * (p[1] + 1) / 2
        return (p[0] * half[0] * shrink, p[1] * half[1], p[2] * half[2] * shrink)

    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for end in (1, -1):
            rows = []
            for j in range(cells[v] + 1):
                row = []
                for i in range(cells[u] + 1):
                    p = [0, 0, 0]
                    p[axis], p[u], p[v] = end, 2 * i / cells[u] - 1, 2 * j / cells[v] - 1
                    row.append(place(p))
                rows.append(row)
            viewer = tuple(99 * end if k == axis else 0 for k in range(3))
            sheet += grid(rows, lambda r, c: material, viewer)
    return moved(sheet, centre)
