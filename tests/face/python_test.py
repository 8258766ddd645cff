"""The Python module: arrays, exceptions, the lock of the interpreter and Ctrl-C: python_test.py MESH"""
import _thread
import os
import sys
import tempfile
import threading
import unittest

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

    def test_rubbish_gets_a_sentence(self):
        v, f = self.mesh.vertices, self.mesh.faces
        for bad in (lambda: kerf.Mesh(v[:, :2], f), lambda: kerf.Mesh(np.full_like(v, np.nan), f),
                    lambda: kerf.Mesh(v, f + len(v)), lambda: kerf.Mesh(v, f.astype(int) - 1), lambda: kerf.Mesh(v[:0], f[:0]),
                    lambda: kerf.Mesh(v, f.astype(float)), lambda: kerf.Mesh('a', f), lambda: kerf.Mesh(v, None),
                    lambda: kerf.read('no-such.obj'), lambda: kerf.Stroke([()]), lambda: kerf.Stroke([(0, (0, 0), (0, 1, 0))]),
                    lambda: kerf.Stroke([('x', (0, 0, 0), (0, 1, 0))]), lambda: kerf.Stroke([], radius=float('nan')),
                    lambda: self.world.cut(kerf.Stroke([])), lambda: self.world.cut(slot(self.mesh), rim='round'),
                    lambda: self.world.cut(slot(self.mesh), target_edge=-1.0), lambda: self.world.nearest_hits(v[:, :2], v),
                    lambda: self.world.all_hits(v, v[:3]), lambda: self.world.nearest_hits(v, 0 * v)):
            with self.assertRaises(ValueError) as raised:
                bad()
            self.assertGreater(len(str(raised.exception)), 10)

    def test_a_report_balances_and_a_journal_leads_to_the_same_state(self):
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

    def test_a_second_thread_gets_a_sentence_and_the_lock_is_released(self):
        said = []

        def disturb(share):
            if not said:
                def ask():
                    try:
                        said.append(self.world.hash)
                    except RuntimeError as fault:
                        said.append(str(fault))
                thread = threading.Thread(target=ask)
                thread.start()
                while not said:  # gives the lock up from time to time
                    thread.join(0.01)
            return True
        self.world.cut(slot(self.mesh), progress=disturb)
        self.assertIn('in use', said[0])

    def test_ctrl_c_stops_a_cut_and_changes_nothing(self):
        before, asked = self.world.hash, []

        def interrupt(share):
            asked.append(share)
            if len(asked) == 3:
                _thread.interrupt_main()
        with self.assertRaises(KeyboardInterrupt):
            self.world.cut(slot(self.mesh), progress=interrupt)
        self.assertEqual(self.world.hash, before)
        with self.assertRaises(RuntimeError):
            self.world.cut(slot(self.mesh), progress=lambda share: False)
        self.assertEqual(self.world.hash, before)

    def test_an_array_that_changes_during_a_call_does_no_harm(self):
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
