"""The smooth shape of the car's skin: the left half of the body side, the glass and the deck.

The body side wraps the car as a belt from the middle of the nose to the middle of the tail. A
point on it is named by z and by v, 0 at the lower edge and 1 at the belt line, where the windows
and the bonnet begin. In plan every height is a superellipse.
"""

import math

from car_sheet import mix, smooth_curve, smoothstep

HALF_WIDTH = 0.872
PLAN_POWER = 4.6
INNER_X = 0.50            # inner wall of the wheel housings
AXLES = (1.30, -1.30)     # z, front then rear
WHEEL_RADIUS = 0.32
ARCH_RADIUS = 0.356
ARCH_BAND = 0.03          # width of the raised band around an arch

belt_height = smooth_curve([(-2.0, 0.965), (-1.3, 0.945), (-0.4, 0.905), (0.3, 0.890),
                            (0.76, 0.875), (1.2, 0.828), (1.6, 0.765), (1.9, 0.695), (2.05, 0.655)])
lower_edge = smooth_curve([(-2.1, 0.27), (-1.75, 0.19), (1.75, 0.19), (2.1, 0.22)])
section = smooth_curve([(0, 0.925), (0.1, 0.962), (0.28, 0.992), (0.45, 1.0), (0.62, 0.990),
                        (0.78, 0.991), (0.9, 0.950), (1, 0.905)])
nose_reach = smooth_curve([(0, 2.02), (0.1, 2.06), (0.28, 2.095), (0.45, 2.10), (0.62, 2.085),
                           (0.78, 2.06), (0.9, 2.01), (1, 1.93)])
tail_reach = smooth_curve([(0, 2.02), (0.1, 2.07), (0.28, 2.10), (0.45, 2.095), (0.52, 2.06),
                           (0.62, 2.045), (0.78, 2.03), (0.9, 2.0), (1, 1.95)])


def reach(end, v):
    """How far the body reaches along z at v; end is +1 at the nose and -1 at the tail."""
    return nose_reach(v) if end > 0 else tail_reach(v)


def plan_partner(fraction):
    """The other coordinate of the unit superellipse's point with this coordinate."""
    return max(0.0, 1 - abs(fraction) ** PLAN_POWER) ** (1 / PLAN_POWER)


def half_width(z, v):
    across = plan_partner(z / reach(z, v))
    from_axle = min(abs(z - axle) for axle in AXLES)
    haunch = 0.016 * math.exp(-(from_axle / 0.36) ** 2) * smoothstep(0.1, 0.7, v)
    return across * (HALF_WIDTH * section(v) + haunch)


def side_point(z, v):
    low = lower_edge(z)
    return (half_width(z, v), low + v * (belt_height(z) - low), z)


def skin_point(z, y, bulge=0.0):
    """The point of the body side at this place in the side view, raised outwards by the bulge."""
    low = lower_edge(z)
    return (half_width(z, (y - low) / (belt_height(z) - low)) + bulge, y, z)


def glass_point(z, y):
    """The point of the side windows' surface, which leans inwards above the belt line."""
    height = y - belt_height(z)
    return (half_width(z, 1) - 0.21 * height - 0.38 * height * height, y, z)


def wrap_point(end, fraction, v):
    """The point of the nose or tail at a fraction of the half width."""
    return side_point(end * reach(end, v) * plan_partner(fraction), v)


class CrossProfile:
    """How a row of deck points runs from the middle to the edge, each coordinate on its own."""

    def __init__(self, fractions, forward, down):
        self.fractions, self.forward, self.down = fractions, forward, down

    @classmethod
    def through(cls, row):
        """The profile for which `row` returns these very points."""
        (_, y0, z0), (x1, y1, z1) = row[0], row[-1]
        return cls([x / x1 for x, _, _ in row], [(z0 - z) / (z0 - z1) for _, _, z in row],
                   [(y0 - y) / (y0 - y1) for _, y, _ in row])

    @classmethod
    def crowned(cls, fractions, forward_power, down_power):
        return cls(fractions, [f ** forward_power for f in fractions],
                   [f ** down_power for f in fractions])

    def towards(self, other, t):
        return CrossProfile(mix(self.fractions, other.fractions, t),
                            mix(self.forward, other.forward, t), mix(self.down, other.down, t))

    def row(self, middle, edge):
        _, y0, z0 = middle
        x1, y1, z1 = edge
        return [(x1 * f, y0 + (y1 - y0) * d, z0 + (z1 - z0) * g)
                for f, g, d in zip(self.fractions, self.forward, self.down)]
