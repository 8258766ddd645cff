"""Traces random rays against a mesh and compares the nearest hits with a test of every face: rays_against_brute_force.py MESH"""
import sys

import numpy as np

import kerf

mesh = kerf.read(sys.argv[1])
world = kerf.World()
world.add(mesh)
random = np.random.default_rng(7)
low, high = mesh.vertices.min(0), mesh.vertices.max(0)
size = np.linalg.norm(high - low)
origins = (low + high) / 2 + size * random.normal(size=(200, 3))
directions = random.uniform(low, high, size=(200, 3)) - origins
directions /= np.linalg.norm(directions, axis=1, keepdims=True)

a, b, c = (mesh.vertices[mesh.faces[:, i]] for i in range(3))
nearest = np.full(len(origins), np.inf)
for i, (o, d) in enumerate(zip(origins, directions)):  # Moeller and Trumbore, 1997
    p = np.cross(d, c - a)
    det = np.einsum('ij,ij->i', b - a, p)
    with np.errstate(divide='ignore', invalid='ignore'):
        u = np.einsum('ij,ij->i', o - a, p) / det
        q = np.cross(o - a, b - a)
        v, t = q @ d / det, np.einsum('ij,ij->i', c - a, q) / det
    hit = (u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0)
    nearest[i] = t[hit].min(initial=np.inf)
found = world.nearest_hits(origins, directions).distance
both = np.isfinite(found) & np.isfinite(nearest)
print(f'{both.sum()} of {len(found)} rays hit, {np.abs(found[both] - nearest[both]).max():.3g} m apart at most')
assert (np.isfinite(found) == np.isfinite(nearest)).all() and np.abs(found[both] - nearest[both]).max() < 1e-9 * size
