"""Drills a grid of holes through a plate and prints the remaining mass: drill_holes.py"""
import numpy as np

import kerf

n = 24
x, z = np.meshgrid(np.linspace(-0.5, 0.5, n + 1), np.linspace(-0.5, 0.5, n + 1))
vertices = np.stack([x.ravel(), 0 * x.ravel(), z.ravel()], axis=1)
corner = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
faces = np.concatenate([np.stack([corner, corner + n + 1, corner + 1], 1),
                        np.stack([corner + 1, corner + n + 1, corner + n + 2], 1)])
world = kerf.World()
world.add(kerf.Mesh(vertices, faces), name='plate')
radius, places = 0.03, [-0.3, -0.1, 0.1, 0.3]
holes = [kerf.Stroke([(0, (px, 1, pz), (0, -1, 0))], radius=radius, range=(0, 2)) for px in places for pz in places]
world.cut(holes, rim='smooth')
plate = max(world.pieces, key=lambda piece: piece.area)
wanted = 1 - len(holes) * np.pi * radius**2
print(f'{plate.area:.6f} m2 of {wanted:.6f}, {plate.mass:.3f} kg, {plate.boundary_edges} edges on boundaries')
assert abs(plate.area - wanted) < 1e-3
