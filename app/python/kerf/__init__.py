"""Kerf: cuts triangle meshes with a laser.

    import kerf
    world = kerf.World()
    world.add(kerf.read("car.obj"))
    world.cut(kerf.Stroke([(0, (-2, 3, 0), (0, -1, 0)), (1, (2, 3, 0), (0, -1, 0))], radius=0.01))
    print([piece.area for piece in world.pieces])

Lengths are in metres, +Y points up, faces are counter-clockwise seen from outside. Paths are str, bytes or os.PathLike.

A failed call has changed nothing and raises
    TypeError          for an argument of the wrong type,
    ValueError         for bad input; the message states what failed and where,
    FileNotFoundError  for a path without a file,
    kerf.Cancelled     if the progress callback cancelled the call,
    kerf.Busy          if another thread uses the world,
    kerf.Error         for everything else, such as a full disk; it is the base of the last two.

Several threads may read one world at the same time: pieces, hits, hash, report, graph and the save functions.
add and cut raise kerf.Busy while another thread uses the world, and the others raise it while the world is being changed.
"""

try:
    import numpy as _numpy
except ImportError as _error:
    raise ImportError('kerf needs NumPy, which cannot be imported: install python3-numpy (Debian) or numpy (pip)',
                      name='numpy') from _error

from ._kerf import Busy, Cancelled, Error, FileNotFound, Hits, Mesh, Stroke, World, __version__, read

del _numpy

__all__ = ['Busy', 'Cancelled', 'Error', 'FileNotFound', 'Hits', 'Mesh', 'Stroke', 'World', 'read', '__version__']
