"""Cuts a mesh in two: cut_in_five_lines.py MESH"""
import sys

import kerf

world = kerf.World()
world.add(kerf.read(sys.argv[1]), name='part')
world.cut(kerf.Stroke([(0, (0, 3, -3), (0, -1, 0)), (1, (0, 3, 3), (0, -1, 0))], radius=0.005, range=(0, 10)))
for piece in world.pieces:
    print(f'{piece.name}: {piece.area:.6f} m2, {piece.mass:.3f} kg')
print(world.hash)
