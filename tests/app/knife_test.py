"""Cuts along planes, and pieces that are ready to print: knife_test.py KERF"""
import json
import math
import os
import struct
import subprocess
import sys
import tempfile
import unittest

KERF = os.path.abspath(sys.argv.pop(1))
SIZE = (0.5, 0.2, 0.3)


def box(at=(0, 0, 0)):
    corners = [[a + s * x for a, s, x in zip(at, (i & 1, i >> 1 & 1, i >> 2), SIZE)] for i in range(8)]
    sides = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    return "".join("v %r %r %r\n" % tuple(c) for c in corners) + \
           "".join("f %d %d %d %d\n" % tuple(i + 1 for i in side) for side in sides)


class Knife(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        with open(os.path.join(self.folder, "box.obj"), "w") as file:
            file.write(box())

    def kerf(self, *arguments):
        return subprocess.run([KERF, "cut", "box.obj", "--out", "out", *arguments], cwd=self.folder, capture_output=True,
                              text=True)

    def cut(self, *arguments):
        """The report, and the vertices of each piece."""
        run = self.kerf(*arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        with open(os.path.join(self.folder, "out", "report.json")) as file:
            report = json.load(file)
        vertices = []
        for piece in report["pieces"]:
            with open(os.path.join(self.folder, "out", piece["file"])) as file:
                vertices.append([[float(x) for x in line.split()[1:4]] for line in file if line.startswith("v ")])
        return report, vertices

    def assert_closed(self, report, count):
        self.assertEqual([piece["closed"] for piece in report["pieces"]], [True] * count)
        volume = SIZE[0] * SIZE[1] * SIZE[2]
        self.assertAlmostEqual(sum(piece["volume"] for piece in report["pieces"]), volume, delta=1e-12 * volume)
        self.assertEqual(report["removed"]["faces"], 0)

    def test_planes_cut_a_solid_and_one_beside_it_is_noted(self):
        report, vertices = self.cut("--plane", "1,0,0,0.2", "--plane", "0,0,2,0.2", "--plane", "0,1,0,9", "--solid")
        self.assert_closed(report, 4)
        self.assertTrue(any("0,1,0,9" in note for note in report["notes"]), report["notes"])
        for piece in vertices:
            for axis, at in ((0, 0.2), (2, 0.1)):
                side = [v[axis] - at for v in piece]
                self.assertTrue(min(side) >= -1e-15 or max(side) <= 1e-15)

    def test_the_mesh_may_follow_a_plane(self):
        run = subprocess.run([KERF, "cut", "--plane", "1,0,0,0.2", "box.obj", "--out", "out"], cwd=self.folder,
                             capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_journal_and_provenance_are_two_files(self):
        run = self.kerf("--plane", "1,0,0,0.2", "--journal", "a.kerf", "--provenance", "./a.kerf")
        self.assertEqual(run.returncode, 2)
        self.assertIn("--journal: a.kerf is the file of --provenance", run.stderr)

    def test_pieces_fit_the_bed(self):
        self.assertIn("cut along 3 planes; 6 pieces", self.kerf("--fit-bed", "0.2,0.25,0.15", "--solid").stderr)
        report, vertices = self.cut("--fit-bed", "0.2,0.25,0.15", "--solid")
        self.assert_closed(report, 6)  # three along x, two along z
        for piece in vertices:
            for axis, most in enumerate((0.2, 0.25, 0.15)):
                extent = max(v[axis] for v in piece) - min(v[axis] for v in piece)
                self.assertLessEqual(extent, most + 1e-15)

    def test_pegs_join_the_halves_of_a_solid(self):
        report, _ = self.cut("--plane", "1,0,0,0.2", "--solid", "--pegs", "3,0.02,0.03,0.001", "--journal", "a.kerf")
        self.assertEqual([True, True], [piece["closed"] for piece in report["pieces"]])
        prism = 16 * math.sin(math.pi / 16)
        holes, pegs = report["pieces"]  # of 0.3 and of 0.2 along x
        self.assertAlmostEqual(pegs["volume"], 0.2 * 0.06 + 3 * prism * 0.01**2 * 0.03, delta=1e-15)
        self.assertAlmostEqual(holes["volume"], 0.3 * 0.06 - 3 * prism * 0.011**2 * 0.031, delta=1e-15)
        replay = subprocess.run([KERF, "replay", "a.kerf"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual((0, report["state_hash"]), (replay.returncode, replay.stdout.strip()))

    def test_pieces_with_pegs_fit_the_bed(self):
        report, vertices = self.cut("--fit-bed", "0.2,0.25,0.35", "--solid", "--pegs", "2,0.02,0.03,0.001")
        self.assertEqual([True] * 3, [piece["closed"] for piece in report["pieces"]])
        for piece in vertices:
            self.assertLessEqual(max(v[0] for v in piece) - min(v[0] for v in piece), 0.2 + 1e-12)

    def test_pegs_without_room_are_noted(self):
        report, _ = self.cut("--plane", "1,0,0,0.2", "--solid", "--pegs", "3,0.02,0.4,0.001")
        self.assert_closed(report, 2)
        self.assertIn("--pegs: there is room for 0 of 3 pegs", report["notes"])
        report, _ = self.cut("--plane", "1,0,0,0.2", "--pegs", "3,0.02,0.04,0.001")
        self.assertIn("--pegs: only solids get pegs; add --solid for closed meshes", report["notes"])
        for wrong in ("3,0.02,0.04", "0,1,1,1", "2,-1,1,1", "2.5,1,1,1"):
            run = self.kerf("--plane", "1,0,0,0.2", "--pegs", wrong)
            self.assertEqual(2, run.returncode)
            self.assertIn("--pegs: must be COUNT", run.stderr)
        self.assertEqual(2, self.kerf("--pegs", "2,1,1,1").returncode)

    def test_pieces_lie_flat_on_their_largest_cut_face(self):
        report, vertices = self.cut("--plane", "0.5,0,1,0.3", "--solid", "--lay-flat")
        self.assert_closed(report, 2)
        spans = []
        for piece in vertices:
            self.assertAlmostEqual(min(v[2] for v in piece), 0, delta=1e-12)
            lowest = [v for v in piece if v[2] < 1e-12]
            self.assertGreaterEqual(len(lowest), 4)  # the section of the box, with points on the diagonals of its sides
            spans.append((min(v[0] for v in piece), max(v[0] for v in piece)))
        (_, left), (right, _) = sorted(spans)
        self.assertLess(left, right)

    def test_pieces_of_a_far_mesh_lie_flat_near_their_origin(self):
        with open(os.path.join(self.folder, "box.obj"), "w") as file:
            file.write(box((1e5, -3e5, 2e4)))
        run = self.kerf("--plane", "1,0,0,100000.2", "--solid", "--lay-flat", "--recentre", "--format", "stl")
        self.assertEqual(run.returncode, 0, run.stderr)
        with open(os.path.join(self.folder, "out", "report.json")) as file:
            report = json.load(file)
        self.assertEqual((report["notes"], len(report["pieces"])), ([], 2))
        for piece in report["pieces"]:
            with open(os.path.join(self.folder, "out", piece["file"]), "rb") as file:
                data = file.read()
            volume = 0
            for face in range(struct.unpack_from("<I", data, 80)[0]):
                a, b, c = (struct.unpack_from("<3f", data, 96 + 50 * face + 12 * corner) for corner in range(3))
                volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                           a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
                for centre, origin, *corners in zip(piece["centroid"], report["origin"], a, b, c):
                    self.assertLess(max(abs(origin + x - centre) for x in corners), 1)
            self.assertAlmostEqual(volume, piece["volume"], delta=1e-6)

    def test_a_knife_that_leaves_its_plane_is_refused_with_file_stroke_and_key(self):
        def key(t, x, z, *direction):
            return {"t": t, "origin": [x, 1, z], "direction": direction}
        knife = {"radius": 0, "range": [0, 2]}
        strokes = [{"laser": knife, "keys": [key(0, -1, 0.1, 0, -1, 0), key(1, 1, 0.1, 0, -1, 0)]},
                   {"laser": knife, "keys": [key(0, -1, 0.2, 0, -1, 0), key(1, 0.2, 0.2, 0, -1, 0), key(2, 1, 0.2, 0, -1, 1)]}]
        with open(os.path.join(self.folder, "twisted.json"), "w") as file:
            json.dump({"strokes": strokes}, file)
        run = self.kerf("--path", "twisted.json", "--solid", "--journal", "a.kerf")
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertIn("twisted.json: /strokes/1/keys/2: the beam of the knife turns out of the plane", run.stderr)
        self.assertEqual(["box.obj", "twisted.json"], sorted(os.listdir(self.folder)))

    def test_wrong_numbers_are_refused_and_write_nothing(self):
        for option, value, words in (("--plane", "0,0,0,1", "normal"), ("--plane", "1,0,0", "four"),
                                     ("--fit-bed", "1,2", "three"), ("--fit-bed", "1,0,1", "positive"),
                                     ("--fit-bed", "0.001,1,1", "larger bed")):
            run = self.kerf(option, value)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(option, run.stderr)
            self.assertIn(words, run.stderr)
            self.assertFalse(os.path.exists(os.path.join(self.folder, "out", "report.json")))


if __name__ == "__main__":
    unittest.main()
