"""Work takes time in proportion to its size: valgrind counts the instructions of `kerf info` for a file, and for one of
twice the size. Beyond those for a single triangle they are then twice as many, or four times as many where a reader or
the triangulation of a polygon is quadratic. For `prepare` and `cut` the work is four times as large: what is quadratic
takes sixteen times as many."""
import json
import math
import os
import random
import re
import struct
import subprocess
import sys
import tempfile
import unittest

KERF = os.path.abspath(sys.argv.pop(1))
SIZE = 2500
LARGEST_GROWTH = 2.7  # n log n grows by 2.2
LARGEST_GROWTH_OF_FOUR = 6
# While keys come to lie denser than the edges of the rim, each vertex of it sees more moves of the beam. From there on
# four times the keys take 4.3 times as long; quadratic growth is 16.
LARGEST_GROWTH_OF_FOUR_BY_DENSITY = 8


def grid(size):
    """Vertices and quadrangles of a sheet with about so many quadrangles."""
    across = math.isqrt(size)
    vertices = [(x, y, (x * y) % 7 / 10) for y in range(across + 1) for x in range(across + 1)]
    corner = lambda x, y: y * (across + 1) + x
    return vertices, [[corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)]
                      for y in range(across) for x in range(across)]


def triangle(_):
    return [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [[0, 1, 2]]


def star(size):
    """One polygon with so many corners, at random distances from its middle."""
    distances = random.Random(1)
    return [(r * math.cos(a), r * math.sin(a), 0) for r, a in
            ((distances.uniform(1, 3), 2 * math.pi * i / size) for i in range(size))], [list(range(size))]


def spiral(size):
    """One polygon with so many corners: a band that winds around its middle."""
    half = size // 2

    def arm(i, inwards):
        angle, radius = 0.2 * i, 10 + 0.05 * i - inwards
        return radius * math.cos(angle), radius * math.sin(angle), 0
    outer, inner = [arm(i, 0) for i in range(half)], [arm(i, 0.4) for i in reversed(range(half))]
    return outer + inner, [list(range(2 * half))]


def convex(size):
    corners = [(math.cos(2 * math.pi * i / size), math.sin(2 * math.pi * i / size), 0) for i in range(size)]
    return corners, [list(range(size))]


def fan_of_sheets(size):
    """So many triangles at one edge."""
    corners = [(math.cos(0.001 * i), math.sin(0.001 * i), 0.5) for i in range(size)]
    return [(0, 0, 0), (0, 0, 1)] + corners, [[0, 1, 2 + i] for i in range(size)]


def double_cone(size):
    """Two vertices with so many triangles each."""
    ring = [(math.cos(2 * math.pi * i / size), 0, math.sin(2 * math.pi * i / size)) for i in range(size)]
    faces = [[0, (i + 1) % size + 2, i + 2] for i in range(size)] + [[1, i + 2, (i + 1) % size + 2] for i in range(size)]
    return [(0, 1, 0), (0, -1, 0)] + ring, faces


def hub_in_a_plane(size):
    """A flat disc with one vertex in its middle, between it and a rim of squares."""
    at = lambda i, r: (r * math.cos(2 * math.pi * i / size), 0, r * math.sin(2 * math.pi * i / size))
    rings = [at(i, r) for r in (1, 2, 3) for i in range(size)]
    faces = [[0, (i + 1) % size + 1, i + 1] for i in range(size)]
    faces += [[1 + k * size + i, 1 + k * size + (i + 1) % size, 1 + (k + 1) * size + (i + 1) % size,
               1 + (k + 1) * size + i] for k in (0, 1) for i in range(size)]
    return [(0, 0, 0)] + rings, faces


def boxes(count):
    """So many boxes in one place."""
    corners = [(i & 1, i >> 1 & 1, i >> 2 & 1) for i in range(8)]
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return corners * count, [[8 * box + v for v in side] for box in range(count) for side in sides]


def stroke(places, radius):
    """A path file with a beam downwards over these places."""
    keys = [{"t": i, "origin": [x, 3, z], "direction": [0, -1, 0]} for i, (x, z) in enumerate(places)]
    return json.dumps({"strokes": [{"laser": {"radius": radius, "range": [0, 5]}, "keys": keys}]}).encode()


def circle(keys):
    angles = [2 * math.pi * i / keys for i in range(keys + 1)]
    return stroke([(0.5 + 0.3 * math.cos(a), 0.5 + 0.3 * math.sin(a)) for a in angles], 0.05)


def numbers(values):
    return " ".join(map(str, values))


def obj(vertices, faces):
    lines = ["v " + numbers(v) for v in vertices] + ["vn 0 0 1"]
    lines += ["f " + " ".join(f"{v + 1}//1" for v in face) for face in faces]
    return "\n".join(lines).encode()


def obj_with_relative_corners(vertices, faces):
    return "\n".join(["v " + numbers(v) for v in vertices] +
                     ["f " + numbers(v - len(vertices) for v in face) for face in faces]).encode()


def off(vertices, faces):
    return "\n".join([f"OFF\n{len(vertices)} {len(faces)} 0"] + [numbers(v) for v in vertices] +
                     [f"{len(face)} {numbers(face)}" for face in faces]).encode()


def ply_header(kind, vertices, faces):
    return (f"ply\nformat {kind} 1.0\nelement vertex {len(vertices)}\nproperty float x\nproperty float y\n"
            f"property float z\nelement face {len(faces)}\nproperty list int int vertex_indices\nend_header\n").encode()


def ply_as_text(vertices, faces):
    return ply_header("ascii", vertices, faces) + "\n".join(
        [numbers(v) for v in vertices] + [f"{len(face)} {numbers(face)}" for face in faces]).encode()


def ply(vertices, faces):
    return ply_header("binary_little_endian", vertices, faces) + b"".join(
        [struct.pack("<3f", *v) for v in vertices] + [struct.pack(f"<{len(f) + 1}i", len(f), *f) for f in faces])


def triangles(vertices, faces):
    return [[vertices[f[0]], vertices[f[i]], vertices[f[i + 1]]] for f in faces for i in range(1, len(f) - 1)]


def stl(vertices, faces):
    all_of_them = triangles(vertices, faces)
    return bytes(80) + struct.pack("<I", len(all_of_them)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *(x for corner in t for x in corner), 0) for t in all_of_them)


def stl_as_text(vertices, faces):
    facets = ["facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {numbers(c)}\n" for c in t) + "endloop\nendfacet"
              for t in triangles(vertices, faces)]
    return "\n".join(["solid sheet", *facets, "endsolid sheet"]).encode()


def write_file(path, content):
    with open(path, "wb") as file:
        file.write(content)


class CountedSteps(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.start = cls.instructions(off(*triangle(1)), ".off")

    @staticmethod
    def instructions(content, ending):
        with tempfile.NamedTemporaryFile(suffix=ending) as file:
            file.write(content)
            file.flush()
            return CountedSteps.instructions_of("info", file.name)

    @staticmethod
    def instructions_of(*arguments):
        run = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", KERF, *arguments],
                             env=dict(os.environ, KERF_THREADS="1"), capture_output=True, text=True)
        if run.returncode != 0:
            raise AssertionError(run.stderr)
        return int(re.search(r"Collected : (\d+)", run.stderr)[1])

    def expect_growth_of_four(self, name, run, size, largest=LARGEST_GROWTH_OF_FOUR):
        """`run` gets a folder and a size, and returns the arguments of a command that does work of this size."""
        def count(n):
            with tempfile.TemporaryDirectory() as folder:
                return self.instructions_of(*run(folder, n))
        one, four = count(size), count(4 * size)
        print(f"{name}: {four / (4 * size):.0f} instructions an item, growth {four / one:.2f}")
        self.assertLess(four / one, largest)

    def expect_no_quadratic_growth(self, shape, write, ending):
        one, two = (self.instructions(write(*shape(size)), ending) - self.start for size in (SIZE, 2 * SIZE))
        growth = two / one
        print(f"{shape.__name__} as {write.__name__}: {two / (2 * SIZE):.0f} instructions an item, growth {growth:.2f}")
        self.assertLess(growth, LARGEST_GROWTH)

    def test_each_reader(self):
        for write, ending in ((obj, ".obj"), (obj_with_relative_corners, ".obj"), (off, ".off"), (ply_as_text, ".ply"),
                              (ply, ".ply"), (stl, ".stl"), (stl_as_text, ".stl")):
            with self.subTest(write.__name__):
                self.expect_no_quadratic_growth(grid, write, ending)

    def test_polygons_of_many_corners(self):
        for shape in star, spiral, convex:
            with self.subTest(shape.__name__):
                self.expect_no_quadratic_growth(shape, off, ".off")

    def test_many_faces_on_one_edge(self):
        self.expect_no_quadratic_growth(fan_of_sheets, ply, ".ply")

    def test_simplifying_around_a_vertex_of_many_faces(self):
        def prepare(shape):
            def run(folder, size):
                write_file(f"{folder}/mesh.off", off(*shape(size)))
                return ["prepare", f"{folder}/mesh.off", "--simplify", "200", "--out", f"{folder}/out.ply"]
            return run
        for shape in double_cone, hub_in_a_plane:
            with self.subTest(shape.__name__):
                self.expect_growth_of_four(shape.__name__, prepare(shape), 2000)

    @staticmethod
    def cut(mesh, path, *options):
        def run(folder, size):
            write_file(f"{folder}/mesh.stl", stl(*mesh(size)))
            write_file(f"{folder}/path.json", path(size))
            return ["cut", f"{folder}/mesh.stl", "--path", f"{folder}/path.json", "--out", f"{folder}/out", *options]
        return run

    def test_cutting_coinciding_faces(self):
        self.expect_growth_of_four("boxes", self.cut(boxes, lambda _: stroke([(-1, 0.3), (2, 0.3)], 0.2)), 10)

    def test_closing_a_solid_after_a_stroke_of_many_keys(self):
        run = self.cut(lambda _: boxes(1), circle, "--solid", "--target-edge", "0.05")
        self.expect_growth_of_four("keys", run, 500, LARGEST_GROWTH_OF_FOUR_BY_DENSITY)


if __name__ == "__main__":
    unittest.main()
