"""Kerf: cuts triangle meshes with a laser.

    import kerf
    world = kerf.World()
    world.add(kerf.read("car.obj"))
    world.cut(kerf.Stroke([(0, (-2, 3, 0), (0, -1, 0)), (1, (2, 3, 0), (0, -1, 0))], radius=0.01))
    print([piece.area for piece in world.pieces])

Lengths are in metres, +Y points up, faces are counter-clockwise seen from outside. Paths are str, bytes or os.PathLike.

A failed call changes nothing, unless stated otherwise, and raises
    TypeError          for an argument of the wrong type,
    ValueError         for bad input; the message states what failed and where,
    FileNotFoundError  for a path without a file,
    kerf.Cancelled     if the progress callback cancelled the call,
    kerf.Busy          if another thread or a stroke in steps uses the world,
    kerf.Error         for everything else, such as a full disk; the base of Cancelled and Busy.

Several threads may read one world at the same time: pieces, hits, hash, report, graph and the save functions.
Functions that change it, such as add and cut, raise kerf.Busy while another thread uses the world, and the others raise
it while the world is being changed.
"""

try:
    import numpy as _numpy
except ImportError as _error:
    raise ImportError('kerf needs NumPy, which cannot be imported: install python3-numpy (Debian) or numpy (pip)',
                      name='numpy') from _error

from ._kerf import (BodyChanges, BodyInfo, Busy, Cancelled, Changes, Error, FileNotFound, Hits, Mesh, Stroke, World,
                    __version__, read)

del _numpy

__all__ = ['BodyChanges', 'BodyInfo', 'Busy', 'Cancelled', 'Changes', 'Error', 'FileNotFound', 'Hits', 'Mesh', 'Stroke',
           'World', 'read', 'show', '__version__']


def show(world, *options):
    """Opens the editor on a copy of a world or of a mesh, and returns when its window is closed.

    world: a World, or what World.add accepts.
    options: of the program `kerf`, such as '--size', '1280x800'.

    Raises TypeError for another object, ValueError if there is no visible face, and Error if the program is not
    installed or ends with an error.
    """
    import os
    import shutil
    import subprocess
    import tempfile
    if not isinstance(world, World):
        mesh, world = world, World()
        world.add(mesh)
    beside = os.path.abspath(os.path.join(os.path.dirname(__file__), *[os.pardir] * 4, 'bin', 'kerf'))
    program = beside if os.access(beside, os.X_OK) else shutil.which('kerf')
    if program is None:
        raise Error('the program kerf is not installed; install it, or add its folder to PATH')
    with tempfile.TemporaryDirectory(prefix='kerf-show-') as folder:
        world.save_scene(folder)
        done = subprocess.run([program, os.path.join(folder, 'scene.json'), *map(str, options)], stderr=subprocess.PIPE,
                              text=True, check=False)
    if done.returncode != 0:
        raise Error(done.stderr.strip().removeprefix('kerf: ') or f'kerf ended with status {done.returncode}')
