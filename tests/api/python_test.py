"""The Python module: arrays, exceptions, the lock of the interpreter and Ctrl-C: python_test.py MESH"""
import _thread
import ast
import copy
import errno
import os
import pathlib
import pickle
import re
import sys
import tempfile
import threading
import time
import types
import unittest
import unittest.mock

import numpy as np

import kerf

MESH = sys.argv.pop()


def slot(mesh):
    low, high = mesh.vertices.min(0), mesh.vertices.max(0)
    middle, size = (low + high) / 2, high - low
    ends = [middle + [s * size[0], 2 * size[1], 0] for s in (-1, 1)]
    return kerf.Stroke([(t, end, (0, -1, 0)) for t, end in enumerate(ends)], radius=0.01 * size[0], range=(0, 9 * size[1]))


class Module(unittest.TestCase):
    def setUp(self):
        self.mesh = kerf.read(MESH)
        self.world = kerf.World()
        self.world.add(self.mesh, name='ball')

    def test_pieces_are_arrays_that_outlive_the_world(self):
        self.world.cut([slot(self.mesh)], rim='smooth')
        pieces = self.world.pieces
        vertices, faces = pieces[0].vertices, pieces[0].faces
        del self.world, pieces
        self.assertEqual((vertices.shape[1], vertices.dtype, faces.shape[1]), (3, np.float64, 3))
        self.assertTrue(np.isfinite(vertices).all() and faces.max() < len(vertices))
        for array in (vertices, faces):
            with self.assertRaises(ValueError):
                array[0, 0] = 1

    def test_invalid_arguments_report_an_error(self):
        v, f = self.mesh.vertices, self.mesh.faces
        for bad in (lambda: kerf.Mesh(v[:, :2], f), lambda: kerf.Mesh(np.full_like(v, np.nan), f),
                    lambda: kerf.Mesh(v, f + len(v)), lambda: kerf.Mesh(v, f.astype(int) - 1), lambda: kerf.Mesh(v[:0], f[:0]),
                    lambda: kerf.Mesh(v, f.astype(float)), lambda: kerf.Mesh('a', f), lambda: kerf.Mesh(v, None),
                    lambda: kerf.Mesh(v.astype(str), f), lambda: kerf.Mesh(v + 0j, f), lambda: kerf.Mesh((1e6 * v).astype('m8[s]'), f),
                    lambda: kerf.Mesh(v.astype(str).astype(object), f),
                    lambda: kerf.Stroke([(0, ('0', '1', '2'), (0, 1, 0))]),
                    lambda: self.world.closest_points([[1j, 0, 0]]),
                    lambda: kerf.Stroke([()]), lambda: kerf.Stroke([(0, (0, 0), (0, 1, 0))]),
                    lambda: kerf.Stroke([('x', (0, 0, 0), (0, 1, 0))]), lambda: kerf.Stroke([], radius=float('nan')),
                    lambda: self.world.cut(kerf.Stroke([])), lambda: self.world.cut(slot(self.mesh), rim='round'),
                    lambda: self.world.cut(slot(self.mesh), target_edge=-1.0), lambda: self.world.nearest_hits(v[:, :2], v),
                    lambda: self.world.all_hits(v, v[:3]), lambda: self.world.nearest_hits(v, 0 * v),
                    lambda: kerf.World().cut(slot(self.mesh)), lambda: kerf.Stroke([], radius=-1),
                    lambda: kerf.Stroke([], power=-1), lambda: kerf.Stroke([], range=(1,)), lambda: kerf.read('a\0b'),
                    lambda: self.world.add(self.mesh, name='a\0b'), lambda: self.world.add(self.mesh, name='\udcff'),
                    lambda: self.world.cut(slot(self.mesh), threads=-1),
                    lambda: self.world.cut(slot(self.mesh), threads=10**30),
                    lambda: self.world.cut(slot(self.mesh), target_edge=10**400),
                    lambda: self.world.cut(slot(self.mesh), material='cheese')):
            with self.assertRaises(ValueError) as raised:
                bad()
            self.assertGreater(len(str(raised.exception)), 10)
        for level in (-1, 25, 10**30, -10**30):
            with self.assertRaisesRegex(ValueError, '^max_level: must be from 0 to 24$'):
                self.world.cut(slot(self.mesh), max_level=level)

    def test_an_argument_of_the_wrong_type_raises_a_type_error_that_names_it(self):
        cut, stroke = self.world.cut, slot(self.mesh)
        for word, bad in (('strokes', lambda: cut(5)), ('strokes[1]', lambda: cut([stroke, 'x'])),
                          ('mesh', lambda: self.world.add(5)), ('mesh', lambda: self.world.add(None)),
                          ('name', lambda: self.world.add(self.mesh, name=b'x')), ('radius', lambda: kerf.Stroke([], radius='0.1')),
                          ('range', lambda: kerf.Stroke([], range=('0', 1))), ('keys', lambda: kerf.Stroke(5)),
                          ('PathLike', lambda: kerf.read(5)), ('PathLike', lambda: kerf.World.open(None)),
                          ('PathLike', lambda: self.world.save_journal(5)), ('PathLike', lambda: self.mesh.write(None)),
                          ('PathLike', lambda: self.world.save_scene(1.5)), ('max_level', lambda: cut(stroke, max_level=2.5)),
                          ('max_level', lambda: cut(stroke, max_level='2')), ('threads', lambda: cut(stroke, threads=None)),
                          ('target_edge', lambda: cut(stroke, target_edge='1')), ('rim', lambda: cut(stroke, rim=1)),
                          ('material', lambda: cut(stroke, material=1)), ('progress', lambda: cut(stroke, progress=1)),
                          ('raduis', lambda: kerf.Stroke([], raduis=1)), ('resolution', lambda: cut(stroke, resolution=1))):
            with self.assertRaises(TypeError) as raised:
                bad()
            said = str(raised.exception)
            self.assertIn(word, said)
            for foreign in ('PYBIND', 'C++', 'kerf::', 'std::', '_kerf'):
                self.assertNotIn(foreign, said)

    def test_an_exception_of_the_progress_callback_propagates(self):
        class Neither:
            def __bool__(self):
                raise LookupError('neither')
        before = self.world.hash
        with self.assertRaises(LookupError):
            self.world.cut(slot(self.mesh), progress=lambda share: Neither())
        with self.assertRaises(ZeroDivisionError):
            self.world.cut(slot(self.mesh), progress=lambda share: 1 / 0)
        self.assertEqual(self.world.hash, before)

    def test_paths_may_be_pathlib_or_bytes_and_a_missing_file_raises_oserror(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            self.mesh.write(folder / 'ball.ply')
            self.assertEqual(len(kerf.read(folder / 'ball.ply').faces), len(self.mesh.faces))
            self.assertEqual(len(kerf.read(os.fsencode(folder / 'ball.ply')).faces), len(self.mesh.faces))
            self.world.cut(slot(self.mesh))
            self.world.save_journal(folder / 'cut.kerf')
            self.world.save_scene(folder / 'scene')
            self.assertEqual(kerf.World.open(folder / 'cut.kerf').hash, self.world.hash)
            areas = [sum(p.area for p in w.pieces) for w in (self.world, kerf.World.open(folder / 'scene/scene.json'))]
            self.assertAlmostEqual(*areas)
            missing = folder / 'no' / 'such.obj'
            for bad in (lambda: kerf.read(missing), lambda: kerf.World.open(missing), lambda: self.mesh.write(missing),
                        lambda: self.world.save_journal(missing)):
                with self.assertRaises(FileNotFoundError) as raised:
                    bad()
                self.assertEqual((raised.exception.errno, raised.exception.filename), (errno.ENOENT, str(missing)))
            with self.assertRaises(ValueError):  # bad input, as any other file that cannot be read
                kerf.read(missing)
            with self.assertRaises(ValueError) as raised:
                kerf.read(folder)
            self.assertNotIsInstance(raised.exception, FileNotFoundError)
            with self.assertRaises(kerf.Error):
                self.mesh.write('/proc/ball.ply')

    def test_exceptions_can_be_pickled_between_processes(self):
        for kind in (kerf.Error, kerf.Cancelled, kerf.Busy):
            self.assertTrue(issubclass(kind, RuntimeError) and issubclass(kind, kerf.Error))
            self.assertIs(type(pickle.loads(pickle.dumps(kind('said')))), kind)
        with self.assertRaises(FileNotFoundError) as raised:
            kerf.read('no-such.obj')
        self.assertEqual(pickle.loads(pickle.dumps(raised.exception)).filename, 'no-such.obj')

    def test_a_stroke_has_attributes_a_repr_and_equal_copies(self):
        stroke = kerf.Stroke([(0, (0, 1, 0), (0, -1, 0))], radius=0.25, range=(0, 2))
        self.assertEqual(stroke.keys, [(0.0, (0.0, 1.0, 0.0), (0.0, -1.0, 0.0))])
        self.assertEqual((stroke.radius, stroke.range, stroke.power), (0.25, (0.0, 2.0), 2000.0))
        self.assertEqual(repr(stroke), 'kerf.Stroke([(0.0, (0.0, 1.0, 0.0), (0.0, -1.0, 0.0))], radius=0.25, range=(0.0, 2.0))')
        for same in (copy.copy(stroke), copy.deepcopy(stroke), pickle.loads(pickle.dumps(stroke)), eval(repr(stroke))):
            self.assertEqual(same, stroke)
            same.power = 500
            self.assertEqual((same.power, stroke.power), (500, 2000.0))
            self.assertNotEqual(same, stroke)
        for name, bad in (('radius', -1), ('power', -1), ('range', (1,)), ('keys', [()])):
            with self.assertRaises(ValueError):
                setattr(stroke, name, bad)
        stroke.radius = stroke.range = None
        self.assertEqual(repr(stroke), 'kerf.Stroke([(0.0, (0.0, 1.0, 0.0), (0.0, -1.0, 0.0))])')
        self.assertNotEqual(stroke, 5)

    def test_attributes_and_materials_are_arrays(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / 'plate.obj'
            file.write_text('v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt 0 0\nvt 3 0\nvt 3 1\nvt 0 1\n'
                            'usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/3 4/4\n')
            plate = kerf.read(file)
            for ending in ('.glb', '.ply'):
                plate.write(file.with_suffix(ending))
                self.assertEqual(list(kerf.read(file.with_suffix(ending)).attributes), ['TEXCOORD_0'])
        world = kerf.World()
        world.add(plate)
        world.cut([slot(self.mesh)])
        for mesh in (plate, *world.pieces):
            self.assertEqual(list(mesh.attributes), ['TEXCOORD_0'])
            uvs, corners = mesh.attributes['TEXCOORD_0'], mesh.vertices[mesh.faces]
            self.assertEqual((uvs.dtype, uvs.shape), (np.float32, (len(mesh.faces), 3, 2)))
            np.testing.assert_allclose(uvs, np.stack((3 * corners[..., 0], 1 - corners[..., 2]), -1), atol=1e-5)
            middle = corners.mean(1)
            self.assertEqual(mesh.material_names, ['a', 'b'])
            np.testing.assert_array_equal(mesh.face_materials, middle[:, 0] < middle[:, 2])
        self.assertEqual((self.mesh.material_names, self.mesh.face_materials.any()), (['porcelain'], False))
        bare = kerf.Mesh(plate.vertices, plate.faces)
        self.assertEqual((bare.attributes, bare.material_names, bare.face_materials.size), ({}, [], 0))

    def test_meshes_and_hits_can_be_copied_and_pickled(self):
        for same in (copy.copy(self.mesh), copy.deepcopy(self.mesh), pickle.loads(pickle.dumps(self.mesh))):
            np.testing.assert_array_equal(same.vertices, self.mesh.vertices)
            np.testing.assert_array_equal(same.faces, self.mesh.faces)
        piece, = self.world.pieces
        self.assertEqual(copy.deepcopy(piece).mass, piece.mass)
        self.assertEqual((repr(self.mesh), repr(piece)),
                         tuple(f'<kerf.Mesh {name}of {len(self.mesh.faces)} faces>' for name in ('', '"ball" ')))
        hits = self.world.all_hits([[0, 9, 0]] * 2, [[0, -1, 0]] * 2)
        same = pickle.loads(pickle.dumps(hits))
        for name in ('offsets', 'distance', 'body', 'face', 'piece', 'barycentrics', 'position', 'normal', 'material', 'is_cut'):
            np.testing.assert_array_equal(getattr(same, name), getattr(hits, name))
        with self.assertRaises(TypeError):
            pickle.dumps(self.world)

    def test_pickles_scenes_and_journals_keep_attributes_materials_and_images(self):
        image = b'\x89PNG not decoded'
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / 'paint.png').write_bytes(image)
            (folder / 'plate.mtl').write_text('newmtl a\nKd 0.1 0.2 0.3\nmap_Kd paint.png\n')
            (folder / 'plate.obj').write_text(
                'mtllib plate.mtl\nv 0 0 0\nv 0.1 0 0\nv 1 0 1\nv 0 0 1\nvt 0 0\nvt 3 0\nvt 3 1\nvt 0 1\nvn 0 1 0\n'
                'usemtl a\nf 1/1/1 3/3/1 2/2/1\nusemtl b\nf 1/1/1 4/4/1 3/3/1\n')
            plate = kerf.read(folder / 'plate.obj')
            plate.write(folder / 'plate.glb')
            world = kerf.World()
            world.add(plate)
            world.add(kerf.read(folder / 'plate.glb'), name='second')
            world.cut([kerf.Stroke([(0, (0.2, 1, 0.5), (0, -1, 0)), (1, (0.6, 1, 0.5), (0, -1, 0))], radius=0.05)])
            world.save_scene(folder / 'scene')
            world.save_journal(folder / 'world.kerf')
            restored = [[pickle.loads(pickle.dumps(piece)) for piece in world.pieces],
                        kerf.World.open(folder / 'scene' / 'scene.json').pieces,
                        kerf.World.open(folder / 'world.kerf').pieces]
            self.assertEqual(kerf.World.open(folder / 'world.kerf').hash, world.hash)
            for number, pieces in enumerate([[pickle.loads(pickle.dumps(plate))], *restored]):
                originals = world.pieces if number else [plate]
                self.assertEqual(len(pieces), len(originals))
                for same, mesh in zip(pieces, originals):
                    np.testing.assert_array_equal(same.vertices, mesh.vertices)
                    np.testing.assert_array_equal(same.faces, mesh.faces)
                    np.testing.assert_array_equal(same.face_materials, mesh.face_materials)
                    self.assertEqual(same.material_names, mesh.material_names)
                    self.assertEqual(list(same.attributes), ['TEXCOORD_0', 'NORMAL'])
                    for key, values in mesh.attributes.items():
                        np.testing.assert_allclose(same.attributes[key], values, atol=1e-6)
                    same.write(folder / 'again.glb')
                    self.assertIn(image, (folder / 'again.glb').read_bytes())
        state, = plate.__getstate__()
        for bad in (b'', state[:-1], b'x' + state):
            with self.assertRaisesRegex(ValueError, '^bytes: '):
                kerf.Mesh.__new__(kerf.Mesh).__setstate__((bad,))

    def test_bodies_have_properties_that_edits_change_and_undo_restores(self):
        body = self.world.add(self.mesh, 'plate', position=(1, 2, 3), orientation=[0, 1, 0, 0], material='copper',
                              thickness=0.002, is_fixed=True)
        self.assertEqual(self.world.bodies[-1], body)
        info = self.world.info(body)
        self.assertEqual((info.name, info.material, info.thickness, info.face_count, info.piece_count),
                         ('plate', 'copper', 0.002, len(self.mesh.faces), 1))
        self.assertEqual((info.position.tolist(), info.orientation.tolist()), ([1, 2, 3], [0, 1, 0, 0]))
        self.assertEqual((info.is_fixed, info.is_solid, info.is_hidden, info.is_asleep), (True, False, False, False))
        before = self.world.hash
        self.assertEqual(self.world.move(body, 0, (0, 5, 0)), body)
        self.assertEqual(self.world.info(body).position.tolist(), [0, 5, 0])
        self.world.set_sheet(body, 0, thickness=0.003, density=1000)
        self.assertAlmostEqual(self.world.piece(body, 0).mass, 3 * self.mesh.area)
        self.world.set_solid(body, 0, True)
        piece = self.world.piece(body, 0)
        self.assertTrue(piece.is_closed)
        self.assertEqual(piece.euler_number, 2)
        self.assertAlmostEqual(piece.mass, 1000 * piece.volume)
        with self.assertRaisesRegex(ValueError, '^rim: the body "plate" is solid'):
            self.world.cut(slot(self.mesh))
        self.world.set_fixed(body, 0, False)
        self.world.rename(body, 0, 'ball 2')
        self.world.set_hidden(body, 0, True)
        info = self.world.info(body)
        self.assertEqual((info.name, info.is_hidden, info.is_fixed), ('ball 2', True, False))
        self.world.remove(body, 0)
        self.assertEqual((info.name, repr(info)), ('ball 2', f'<kerf.BodyInfo "ball 2" of {info.face_count} faces>'))
        self.assertEqual(len(self.world.bodies), 1)
        for _ in range(7):
            self.assertTrue(self.world.undo())
        self.assertEqual(self.world.hash, before)
        self.assertTrue(self.world.redo())
        for bad in (lambda: self.world.info(body + 9), lambda: self.world.move(body, 3, (0, 0, 0)),
                    lambda: self.world.move(body, 0, (0, 0)), lambda: self.world.move(body, -1, (0, 0, 0)),
                    lambda: self.world.add(self.mesh, thickness=0), lambda: self.world.add(self.mesh, orientation=(1, 0, 0)),
                    lambda: self.world.add(self.mesh, material='cheese'), lambda: self.world.corners(body, [2**31]),
                    lambda: self.world.cut(slot(self.mesh), bodies=[]), lambda: self.world.cut(slot(self.mesh), bodies=[body + 9]),
                    lambda: self.world.simulate(-1), lambda: self.world.set_undo_memory(-1)):
            with self.assertRaises(ValueError):
                bad()
        for bad in (lambda: self.world.info('x'), lambda: self.world.corners(body, 5), lambda: self.world.simulate('1')):
            with self.assertRaises(TypeError):
                bad()

    def test_bodies_fall_under_gravity(self):
        self.world.set_environment(gravity=(0, -10, 0), ground=-9)
        body, = self.world.bodies
        self.world.simulate(0.5)
        info = self.world.info(body)
        np.testing.assert_allclose(info.velocity, (0, -5, 0), atol=0.2)
        np.testing.assert_allclose(info.position, (0, -1.25, 0), atol=0.05)
        self.assertTrue(self.world.undo())
        self.assertEqual(self.world.info(body).position.tolist(), [0, 0, 0])

    def test_names_that_are_not_utf_8_are_replaced(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, 'latin.obj')
            with open(file, 'wb') as obj:
                obj.write(b'g T\xfcr\nusemtl M\xe9tal\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n')
            mesh = kerf.read(file)
            self.assertEqual([name for name, _, _ in mesh.parts], ['T\ufffdr'])
            self.assertEqual(list(mesh.material_names), ['M\ufffdtal'])
            self.assertEqual(repr(mesh), '<kerf.Mesh of 1 face>')
            bad = os.fsencode(folder) + b'/\xfc.xyz'
            with open(bad, 'wb') as junk:
                junk.write(b'junk')
            with self.assertRaises((ValueError, kerf.Error)) as raised:
                kerf.read(bad)
            self.assertNotIsInstance(raised.exception, (UnicodeError, FileNotFoundError))

    def test_a_long_simulation_equals_its_parts(self):
        other = kerf.World()
        other.add(self.mesh)
        other.cut(slot(self.mesh))
        world = kerf.World()
        world.add(self.mesh)
        world.cut(slot(self.mesh))
        world.simulate(0.55)
        for seconds in (0.3, 0.2, 0.05):
            other.simulate(seconds)
        self.assertEqual(world.hash, other.hash)
        self.assertTrue(world.undo() and world.undo())

    def test_parts_that_a_hinge_holds_become_bodies_that_fall_together(self):
        square = np.array([(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)], float)
        mesh = kerf.Mesh(np.vstack([square, square + (1.1, 0, 0)]), [(0, 2, 1), (0, 3, 2), (4, 6, 5), (4, 7, 6)])
        world = kerf.World()
        body = world.add(mesh)
        for wrong in ({'kind': 'glue'}, {'axis': (0, 0, 0)}, {'limits': (5, 10)}, {'radius': -1}):
            with self.assertRaises(ValueError):
                world.join(**{'body': body, 'kind': 'hinge', 'part_a': (1.1, 0, 0), 'part_b': (1, 0, 0),
                              'anchor': (1.05, 0, 0), **wrong})
        world.join(body, 'hinge', (1.1, 0, 0), (1, 0, 0), anchor=(1.05, 0, 0), axis=(0, 0, 1), limits=(-90, 90))
        world.simulate(0.25)
        first, second = (world.info(own) for own in world.bodies)
        np.testing.assert_allclose(first.position, second.position, atol=1e-3)
        self.assertLess(first.position[1], -0.2)

    def test_a_stroke_in_steps_equals_a_cut(self):
        whole = slot(self.mesh)
        self.world.cut(whole, rim='smooth')
        for seed in range(3):
            random = np.random.default_rng(seed)
            world = kerf.World()
            body = world.add(self.mesh)
            world.begin_stroke(kerf.Stroke(whole.keys[:1], whole.radius, whole.range), rim='smooth', bodies=[body])
            with self.assertRaises(kerf.Busy):
                world.cut(whole)
            progress = world.step_stroke(0, 0)
            for key in whole.keys[1:]:
                world.add_pose(*key)
                progress = world.step_stroke(max_faces=int(random.integers(500)))
            world.end_stroke()
            while not progress['is_finished']:
                progress = world.step_stroke(int(random.integers(500)), max_seconds=0.01)
            self.assertTrue(progress['is_idle'] and progress['waiting'] == 0)
            self.assertEqual(world.hash, self.world.hash)
            self.assertEqual(progress['removed_faces'], self.world.report()['removed']['faces'])
            cut = world.hash
            world.begin_stroke(whole)
            world.end_stroke()
            world.step_stroke(100)
            world.cancel_stroke()
            self.assertEqual(world.hash, cut)
        for bad in (world.end_stroke, world.cancel_stroke, world.step_stroke, lambda: world.add_pose(0, (0, 0, 0), (0, 1, 0))):
            with self.assertRaises(ValueError):
                bad()

    def test_changes_keep_a_mirror_equal(self):
        world, (body,) = self.world, self.world.bodies

        def fetch(body, faces):
            return dict(zip(faces.tolist(), zip(world.corners(body, faces).tolist(), world.piece_labels(body, faces).tolist())))

        def fetch_all():
            return {b: fetch(b, world.faces(b)) for b in world.bodies}
        self.assertTrue(world.take_changes().everything)
        mirror = fetch_all()
        labels = []
        for change in (lambda: world.cut(slot(self.mesh)), world.undo, world.redo,
                       lambda: world.move(body, labels[0][0], (0, 1, 0)), lambda: world.add(self.mesh), world.undo,
                       lambda: world.set_hidden(world.bodies[0], 0, True), lambda: world.remove(world.bodies[0], 0)):
            change()
            changes = world.take_changes()
            self.assertFalse(changes.everything)
            for b in changes.bodies:
                labels += b.new_pieces
                if b.destroyed:
                    del mirror[b.body]
            for source, to, piece, keeps_faces in changes.detached:
                if keeps_faces and source in mirror:
                    mirror[to] = mirror.pop(source)
            for b in changes.bodies:
                if b.destroyed:
                    continue
                own = {} if b.created else mirror[b.body]
                for face in b.removed.tolist():
                    own.pop(face, None)
                own.update(fetch(b.body, b.added))
                for face, piece in zip(b.moved.tolist(), b.moved_pieces.tolist()):
                    own[face] = own[face][0], piece
                mirror[b.body] = own
            self.assertEqual(mirror, fetch_all())
        self.assertEqual(labels[0][1], 0)
        self.assertFalse(world.take_changes().bodies)

    def test_hits_describe_the_point_of_the_face(self):
        body, = self.world.bodies
        random = np.random.default_rng(1)
        points = random.normal(size=(50, 3)) * 3
        for hits in (self.world.closest_points(points), self.world.nearest_hits(points, -points)):
            hit = np.isfinite(hits.distance)
            self.assertGreater(hit.sum(), 40)
            corners = self.world.corners(body, hits.face[hit])
            np.testing.assert_allclose((hits.barycentrics[hit, :, None] * corners).sum(1), hits.position[hit], atol=1e-12)
            np.testing.assert_allclose(np.linalg.norm(hits.position - points, axis=1)[hit], hits.distance[hit])
            np.testing.assert_allclose(np.linalg.norm(hits.normal[hit], axis=1), 1)
            self.assertEqual((hits.is_cut.dtype, hits.material.dtype), (bool, np.uint16))
        self.assertTrue((self.world.closest_points(points * 100, max_distance=1).body == 2**64 - 1).all())
        low, high = self.mesh.vertices.min(0), self.mesh.vertices.max(0)
        hits = self.world.faces_in_box(low, high)
        np.testing.assert_array_equal(hits.face, self.world.faces(body))
        self.assertEqual(len(self.world.faces_in_box(2 * high, 3 * high).face), 0)
        with self.assertRaises(ValueError):
            self.world.faces_in_box(high, low)

    def test_a_thermal_stroke_has_all_settings_of_a_laser(self):
        stroke = slot(self.mesh)
        stroke.wavelength, stroke.focus, stroke.pulse_rate, stroke.duty, stroke.assist = 1e-6, 2, 1000, 0.5, 'oxygen'
        self.assertEqual(eval(repr(stroke)), stroke)
        self.assertEqual(pickle.loads(pickle.dumps(stroke)).focus, 2)
        for name, bad in (('wavelength', 0), ('focus', -1), ('pulse_rate', float('nan')), ('duty', 2), ('assist', 'air')):
            with self.assertRaises(ValueError):
                setattr(stroke, name, bad)
        cut = self.world.cut(stroke, model='thermal')
        self.assertAlmostEqual(cut['emitted'], 1000, delta=1e-6)  # in half of a second
        self.assertTrue(0 < cut['absorbed'] < cut['emitted'] and 0 <= cut['depth'] <= 1)

    def test_meshes_are_read_from_bytes_and_arrays_of_any_type(self):
        for name in ('obj', 'ply', 'stl', 'off', 'glb', 'gltf', '3mf'):
            encoded = self.mesh.encode(name)
            with tempfile.TemporaryDirectory() as folder:
                file = pathlib.Path(folder) / ('ball.' + name)
                self.mesh.write(file)
                self.assertEqual(file.read_bytes(), encoded)
                np.testing.assert_array_equal(kerf.Mesh.decode(encoded).vertices, kerf.read(file).vertices)
        with self.assertRaises(ValueError):
            kerf.Mesh.decode(b'', 'stl')
        with self.assertRaises(ValueError):
            self.mesh.encode('fbx')
        notes = kerf.Mesh.decode(b'v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\nf 1 2 2\n', format='obj').warnings
        self.assertEqual(notes, ['1 triangle has two corners at the same position and was dropped.'])
        rows = np.zeros(len(self.mesh.vertices), dtype=[('uv', 'f4', 2), ('at', 'f4', 3), ('x', 'u1')])
        rows['at'] = self.mesh.vertices
        for kind in (np.int64, bool, object):
            np.testing.assert_array_equal(kerf.Mesh(np.ones((3, 3), kind), [[0, 1, 2]]).vertices, np.ones((3, 3)))
        same = kerf.Mesh(rows['at'], self.mesh.faces.astype(np.uint16)[:, ::1])
        np.testing.assert_array_equal(same.vertices, self.mesh.vertices.astype(np.float32))
        np.testing.assert_array_equal(same.faces, self.mesh.faces)

    def test_show_opens_the_editor_on_a_world(self):
        with tempfile.TemporaryDirectory() as folder:
            events, image = os.path.join(folder, 'events'), os.path.join(folder, 'a.png')
            with open(events, 'w', encoding='utf-8') as text:
                text.write('{"wait": 0.1}\n{"picture": "%s"}\n' % image)
            with unittest.mock.patch.dict(os.environ, XDG_CONFIG_HOME=folder, XDG_STATE_HOME=folder):
                kerf.show(self.world, '--events', events, '--size', '320x200')
            self.assertGreater(os.path.getsize(image), 1000)
            with self.assertRaises(kerf.Error):
                kerf.show(self.mesh, '--size', 'wide')
            with self.assertRaises(TypeError):
                kerf.show(5)

    def test_meshes_of_other_libraries_are_accepted_by_attributes(self):
        v, f = np.array(self.mesh.vertices), np.array(self.mesh.faces)
        for other in (types.SimpleNamespace(vertices=v, faces=f.astype(np.int64)),
                      types.SimpleNamespace(vertices=v.tolist(), triangles=f.tolist())):
            world = kerf.World()
            world.add(other, name='ball')
            self.assertEqual(world.hash, self.world.hash)
            self.assertEqual(kerf.Mesh(other).area, self.mesh.area)
        for bad in (types.SimpleNamespace(vertices=v), v, 'x'):
            with self.assertRaisesRegex(TypeError, '^mesh: must be a kerf.Mesh or'):
                self.world.add(bad)

    def test_reading_and_opening_report_progress(self):
        for read in (kerf.read, kerf.World.open):
            shares = []
            read(MESH, progress=shares.append)
            self.assertTrue(all(0 <= share <= 1 for share in shares) and shares)
            with self.assertRaises(kerf.Cancelled):
                read(MESH, progress=lambda share: False)

    def test_a_knife_halves_a_solid_along_a_plane(self):
        body = self.world.bodies[0]
        self.world.set_solid(body, 0, True)
        volume = self.world.piece(body, 0).volume
        before = self.world.hash
        self.world.cut_plane((0, 2, 0), 2 * np.mean(self.mesh.vertices[:, 1]))
        pieces = self.world.pieces
        self.assertEqual([p.is_closed for p in pieces], [True, True])
        self.assertAlmostEqual(sum(p.volume for p in pieces) / volume, 1, 12)
        self.assertTrue(self.world.undo())
        self.assertEqual(self.world.hash, before)
        for bad in (lambda: self.world.cut_plane((0, 0, 0), 1), lambda: self.world.cut_plane((0, 1), 1),
                    lambda: self.world.cut_plane((0, 1, 0), float('inf'))):
            with self.assertRaises(ValueError):
                bad()
        with self.assertRaises(kerf.Cancelled):
            self.world.cut_plane((0, 1, 0), 0, progress=lambda share: False)
        self.assertEqual(self.world.hash, before)

    def test_type_hints_state_defaults_and_docstrings_state_errors(self):
        with open(os.path.splitext(kerf.__file__)[0] + '.pyi', encoding='utf-8') as text:
            hints = ast.parse(text.read())
        functions = [(node.name, node) for node in hints.body if isinstance(node, ast.FunctionDef)]
        for group in hints.body:
            if isinstance(group, ast.ClassDef) and not group.name.startswith('_'):
                functions += [(f'{group.name}.{node.name}', node) for node in group.body
                              if isinstance(node, ast.FunctionDef) and not node.decorator_list]
        self.assertGreater(len(functions), 10)
        for name, node in functions:
            actual = kerf
            for part in name.split('.'):
                actual = getattr(actual, part)
            with self.subTest(name):
                hinted = dict(zip([a.arg for a in node.args.kwonlyargs], node.args.kw_defaults))
                hinted.update(zip([a.arg for a in node.args.args[::-1]], node.args.defaults[::-1]))
                signature = actual.__doc__.splitlines()[0]
                self.assertEqual({k: repr(ast.literal_eval(v)) for k, v in hinted.items() if v},
                                 dict(re.findall(r"(\w+): \w+ = ([^,)]+)", signature)))
                if signature.count(':') > 1 and name != 'World.add':
                    self.assertIn('Raises', actual.__doc__ if name != 'World.all_hits' else kerf.World.nearest_hits.__doc__)

    def test_the_docstring_and_the_type_hint_of_is_closed_state_the_rule_of_the_library(self):
        with open(os.path.splitext(kerf.__file__)[0] + '.pyi', encoding='utf-8') as text:
            hints = text.read()
        rule = 'a piece of a world and uses each edge equally often in both directions'
        self.assertIn(rule, kerf.Mesh.is_closed.__doc__)
        self.assertIn(rule, hints)

    def test_threads_read_one_world_concurrently(self):
        self.world.cut(slot(self.mesh))
        v = np.array(self.mesh.vertices)
        along = np.full_like(v, -1)

        def read():
            return (self.world.hash, [p.area for p in self.world.pieces], self.world.report()['pieces'], self.world.graph(),
                    self.world.nearest_hits(2 * v, along).distance.tolist(), self.world.all_hits(2 * v, along).offsets.tolist())
        wanted, results = read(), []

        def ask():
            try:
                results.append(all(read() == wanted for _ in range(4)))
            except kerf.Error as fault:
                results.append(fault)
        threads = [threading.Thread(target=ask) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(results, [True] * 4)

    def test_progress_acquires_the_gil_at_most_fifty_times_a_second(self):
        shares = []
        begin = time.monotonic()
        for k in range(8):
            self.world.cut(slot(self.mesh), max_level=k // 4 + 4, threads=1, progress=shares.append)
        most = 8 + 50 * (time.monotonic() - begin)
        self.assertLessEqual(len(shares), most)
        self.assertGreaterEqual(len(shares), 8)  # at least once a call

    def test_a_report_balances_and_a_journal_reproduces_the_state(self):
        result = self.world.cut(slot(self.mesh))
        report = self.world.report()
        self.assertEqual(report['removed']['faces'], result['removed_faces'])
        self.assertAlmostEqual(report['input']['area'], report['removed']['area'] + report['output']['area'])
        self.assertEqual(report['state_hash'], self.world.hash)
        self.assertEqual(len(report['pieces']), len(self.world.pieces))
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, 'cut.kerf')
            self.world.save_journal(file)
            self.assertEqual(kerf.World.open(file).hash, self.world.hash)

    def test_a_second_thread_gets_an_error_and_the_gil_is_released(self):
        said = []

        def disturb(share):
            if not said:
                def ask():
                    try:
                        said.append(self.world.hash)
                    except kerf.Busy as fault:
                        said.append(str(fault))
                thread = threading.Thread(target=ask)
                thread.start()
                while not said:  # gives the lock up from time to time
                    thread.join(0.01)
            return True
        self.world.cut(slot(self.mesh), progress=disturb)
        self.assertIn('in use', said[0])

    def test_ctrl_c_cancels_a_cut_and_changes_nothing(self):
        before, asked = self.world.hash, []

        def interrupt(share):
            asked.append(share)
            _thread.interrupt_main()
        with self.assertRaises(KeyboardInterrupt):
            self.world.cut(slot(self.mesh), progress=interrupt)
        self.assertEqual(self.world.hash, before)
        with self.assertRaises(kerf.Cancelled):
            self.world.cut(slot(self.mesh), progress=lambda share: False)
        self.assertEqual(self.world.hash, before)

    def test_an_array_modified_during_a_call_is_harmless(self):
        v = np.array(self.mesh.vertices)
        stop = threading.Event()

        def spoil():
            while not stop.is_set():
                v[:] = np.random.default_rng().normal(size=v.shape)
        thread = threading.Thread(target=spoil)
        thread.start()
        for _ in range(20):
            kerf.Mesh(v, self.mesh.faces)
            self.world.nearest_hits(v, np.ones_like(v))
        stop.set()
        thread.join()


unittest.main()
