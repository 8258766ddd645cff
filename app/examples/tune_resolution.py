"""Cuts a mesh at increasing resolutions and prints faces and removed area per edge length, as a table and as bars:
tune_resolution.py MESH"""
import sys

import numpy as np

import kerf

mesh = kerf.read(sys.argv[1])
low, high = mesh.vertices.min(0), mesh.vertices.max(0)
middle, size = (low + high) / 2, high - low
radius = 0.02 * size.max()
stroke = kerf.Stroke([(0, middle + [-size[0], 2 * size[1], 0], (0, -1, 0)), (1, middle + [size[0], 2 * size[1], 0], (0, -1, 0))],
                     radius=radius, range=(0, 9 * size[1]))
rows = []
for edge in radius * np.array([2, 1, 0.5, 0.25]):
    world = kerf.World()
    world.add(mesh)
    removed = world.cut(stroke, target_edge=edge)['removed_area']
    rows.append((edge, sum(len(p.faces) for p in world.pieces), removed))
for edge, faces, removed in rows:
    print(f'{edge:.5f} m  {faces:7d} faces  {removed:.6f} m2  ' + '#' * int(50 * faces / rows[-1][1]))
