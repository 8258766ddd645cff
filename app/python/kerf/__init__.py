"""Kerf: a laser drills through any triangle mesh.

    import kerf
    world = kerf.World()
    world.add(kerf.read("car.obj"))
    world.cut(kerf.Stroke([(0, (-2, 3, 0), (0, -1, 0)), (1, (2, 3, 0), (0, -1, 0))], radius=0.01))
    print([piece.area for piece in world.pieces])

Lengths are in metres, +Y points up, faces are counter-clockwise seen from outside. Bad input raises ValueError with a
sentence that says what is wrong; what fails has changed nothing.
"""

from ._kerf import Hits, Mesh, Stroke, World, __version__, read

__all__ = ['Hits', 'Mesh', 'Stroke', 'World', 'read', '__version__']
