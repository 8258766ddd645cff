"""The vehicles, the arenas and their programs in assets: run as `assets_test.py KERF`, with KERF the executable."""
import filecmp
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

from part_mesh import PartMesh

KERF = os.path.abspath(sys.argv.pop(1))
ASSETS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "assets")
VEHICLES = ("buggy", "hatchback", "pickup", "van")
ARENAS = ("yard", "depot")
PROGRAMS = ("meshes/make_car.py", "meshes/make_shapes.py", "vehicles/make_vehicles.py", "arenas/make_arenas.py")


def read_json(*path):
    with open(os.path.join(ASSETS, *path)) as file:
        return json.load(file)


def read_mesh(name):
    with open(os.path.join(ASSETS, "meshes", name + ".obj")) as file:
        return PartMesh(file.read())


class Generators(unittest.TestCase):
    def test_generators_reproduce_the_files_of_the_repository_exactly(self):
        with tempfile.TemporaryDirectory() as folder:
            for room in ("meshes", "vehicles", "arenas"):
                programs = [f for f in os.listdir(os.path.join(ASSETS, room)) if f.endswith(".py")]
                os.mkdir(os.path.join(folder, room))
                for name in programs:
                    shutil.copy(os.path.join(ASSETS, room, name), os.path.join(folder, room))
            running = [subprocess.Popen([sys.executable, "-B", os.path.join(folder, program)], stdout=subprocess.DEVNULL)
                       for program in PROGRAMS]
            self.assertEqual([program.wait() for program in running], [0] * len(PROGRAMS))
            for room in ("meshes", "vehicles", "arenas"):
                written = [f for f in os.listdir(os.path.join(folder, room)) if not f.endswith(".py")]
                kept = [f for f in os.listdir(os.path.join(ASSETS, room)) if f.endswith((".obj", ".mtl", ".png", ".json"))]
                self.assertEqual(sorted(written), sorted(kept))
                same, *differ = filecmp.cmpfiles(os.path.join(folder, room), os.path.join(ASSETS, room), written, False)
                self.assertEqual(differ, [[], []])


class Vehicle(unittest.TestCase):
    """The tests of one vehicle; the class of each has its name."""

    @classmethod
    def setUpClass(cls):
        cls.file, cls.mesh = read_json("vehicles", cls.name + ".json"), read_mesh(cls.name)
        # (distance, component) of both sides of each joint
        cls.sides = []
        for joint in cls.file["joints"]:
            found = [cls.mesh.nearest(*side) for side in zip(joint["parts"], joint["near"])]
            cls.sides.append([(distance, cls.mesh.component[face]) for distance, face in found])

    def test_has_three_to_eight_thousand_faces_and_stands_on_the_ground(self):
        self.assertTrue(3000 <= len(self.mesh.faces) <= 8000, len(self.mesh.faces))
        self.assertAlmostEqual(min(p[1] for p in self.mesh.points), 0, delta=0.002)

    def test_mesh_has_no_fault(self):
        self.assertEqual(self.mesh.faults(), [])

    def test_has_the_parts_and_paints_named_in_its_file(self):
        turret = self.file["turret"]
        named = [turret["part"], turret["mount"], turret["barrel"]["part"]]
        for entry in self.file["wheels"] + self.file["vital"] + [self.file["tank"]]:
            named += [entry["part"], entry["mount"]]
        for joint in self.file["joints"]:
            named += joint["parts"]
        self.assertEqual(set(named) - set(self.mesh.parts), set())
        self.assertEqual(len(self.file["wheels"]), 4)
        self.assertEqual(sorted(entry["kind"] for entry in self.file["vital"]), ["driver", "engine"])
        self.assertEqual(self.mesh.materials, set(self.file["paints"]))

    def test_wheels_surround_their_hubs_and_the_lens_is_at_the_muzzle(self):
        for wheel in self.file["wheels"]:
            x, y, z = wheel["hub"]
            points = [p for f in self.mesh.parts[wheel["part"]] for p in self.mesh.corners(f)]
            self.assertAlmostEqual(max(p[2] for p in points) - z, wheel["radius"], delta=0.02)
            self.assertAlmostEqual(y - min(p[1] for p in points), wheel["radius"], delta=0.002)
            self.assertTrue(min(p[0] for p in points) < x < max(p[0] for p in points))
        barrel = self.file["turret"]["barrel"]
        tip = max(p[2] for f in self.mesh.parts[barrel["part"]] for p in self.mesh.corners(f))
        self.assertAlmostEqual(barrel["muzzle"][2], tip, delta=0.001)

    def test_joints_lie_at_their_parts(self):
        for joint, sides in zip(self.file["joints"], self.sides):
            for near, (distance, _) in zip(joint["near"], sides):
                self.assertLess(distance, 2e-5, joint)
                self.assertLess(math.dist(near, joint["anchor"]), 0.13, joint)

    def test_hinges_of_a_part_are_collinear_with_their_axis(self):
        hinges = {}
        for joint in self.file["joints"]:
            if joint["kind"] == "hinge" and joint["parts"][0] != joint["parts"][1]:
                hinges.setdefault(tuple(joint["parts"]), []).append(joint)
        for (first, *others) in hinges.values():
            for other in others:
                way = [b - a for a, b in zip(first["anchor"], other["anchor"])]
                along = sum(w * a for w, a in zip(way, first["axis"])) / math.hypot(*first["axis"])
                self.assertAlmostEqual(abs(along), math.hypot(*way), delta=1e-4, msg=first)
                self.assertEqual(first["axis"], other["axis"])

    def test_every_part_is_connected_to_the_body_by_the_mesh_or_joints(self):
        links = [{component for _, component in sides} for sides in self.sides]
        for joint, link in zip(self.file["joints"], links):
            self.assertTrue(len(link) == 2 or joint["kind"] == "hinge", joint)  # a hinge may cross a seam
        held = {self.mesh.component[self.mesh.parts["body"][0]]}
        for _ in links:
            held = held.union(*(link for link in links if held & link))
        loose = {part for part, faces in self.mesh.parts.items() for f in faces if self.mesh.component[f] not in held}
        self.assertEqual(loose, set())


class Arena(unittest.TestCase):
    """The tests of one arena; the class of each has its name."""

    @classmethod
    def setUpClass(cls):
        cls.file = read_json("arenas", cls.name + ".json")
        cls.meshes = {body["mesh"]: read_mesh(os.path.basename(body["mesh"])[:-4]) for body in cls.file["bodies"]}

    def test_has_fewer_than_22000_faces_and_no_fault(self):
        self.assertLess(sum(len(self.meshes[body["mesh"]].faces) for body in self.file["bodies"]), 22000)
        for name, mesh in self.meshes.items():
            self.assertEqual(mesh.faults(), [], name)
            self.assertLessEqual(mesh.materials, set(self.file["paints"]), name)

    def test_cuttable_bodies_are_glossy_and_fixed_ones_matt(self):
        for body in self.file["bodies"]:
            for material in self.meshes[body["mesh"]].materials:
                gloss = self.file["paints"][material]["gloss"]
                self.assertTrue(gloss >= 0.5 if body["cuttable"] else gloss <= 0.3, (body["name"], material))

    def test_no_road_is_steeper_than_twelve_degrees(self):
        mesh = self.meshes[f"../meshes/{self.name}.obj"]
        road = {f for part, faces in mesh.parts.items() if part.endswith("_asphalt") for f in faces}
        self.assertGreater(len(road), 20)
        for face in road:
            a, b, c = mesh.corners(face)
            u, v = ([y - x for x, y in zip(a, q)] for q in (b, c))
            n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            self.assertGreater(n[1] / math.hypot(*n), math.cos(math.radians(12)), mesh.corners(face))

    def test_all_start_positions_are_on_free_ground_within_the_walls(self):
        starts = [self.file["starts"]["player"], *self.file["starts"]["enemies"]]
        self.assertGreaterEqual(len(starts), 12)
        places = [start["position"] for start in starts]
        for i, (x, y, z) in enumerate(places):
            self.assertEqual(y, self.file["ground"])
            for size, at in zip(self.file["size"], (x, z)):
                self.assertLess(abs(at), size / 2 - 4)
            self.assertGreater(min(math.dist(p, (x, y, z)) for p in places[:i] + places[i + 1:]), 8)
            self.assertGreater(min(self.distances_to(x, z)), 3.0, (x, z))

    def distances_to(self, x, z):
        """How far bodies are from a place, by their vertices up to three metres above the ground."""
        for body in self.file["bodies"]:
            px, py, pz = body.get("position", [0, 0, 0])
            w, _, s, _ = body.get("orientation", [1, 0, 0, 0])
            cosine, sine = 1 - 2 * s * s, 2 * s * w
            for a, b, c in self.meshes[body["mesh"]].points:
                if 0.1 < py + b < 3:
                    yield math.hypot(px + a * cosine + c * sine - x, pz + c * cosine - a * sine - z)

    def test_falling_props_stand_on_plinths_and_weigh_100_to_4000_kg(self):
        fixed = self.meshes[f"../meshes/{self.name}.obj"]
        plinths = [p for f in fixed.parts["plinths"] for p in fixed.corners(f)]
        names = [b["name"] for b in self.file["bodies"] if b.get("position", [0, 0, 0])[1] == 0.95]
        self.assertEqual({name.rsplit("_", 1)[0] for name in names}, {"lamp_post", "gantry", "stack"})
        for body in self.file["bodies"]:
            if body["name"] in names:
                mesh = self.meshes[body["mesh"]]
                area = sum(self.area(*mesh.corners(f)) for f in range(len(mesh.faces)))
                self.assertTrue(100 < area * body["thickness"] * body["density"] < 4000, body["name"])
        self.assertAlmostEqual(max(p[1] for p in plinths), 0.95)

    @staticmethod
    def area(a, b, c):
        u, v = ([y - x for x, y in zip(a, q)] for q in (b, c))
        return math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2


class Games(unittest.TestCase):
    def test_the_scene_of_the_yard_defines_all_its_paints(self):
        scene = read_json("scenes", "yard.json")
        used = set().union(*(read_mesh(os.path.basename(body["mesh"])[:-4]).materials for body in scene["bodies"]))
        self.assertEqual(used - set(scene["paints"]), set())

    def test_the_rules_name_existing_files_and_fit_the_start_positions(self):
        games = sorted(os.listdir(os.path.join(ASSETS, "games")))
        fewest = min(len(read_json("arenas", name + ".json")["starts"]["enemies"]) for name in ARENAS)
        self.assertEqual(games, ["lesson.json", "sandbox.json", "standard.json", "trial.json"])
        for game in games:
            rules = read_json("games", game)
            named = [rules["arena"], rules["player"], *rules.get("spawns", []),
                     *(vehicle for wave in rules["waves"] for vehicle in wave)]
            for path in named:
                self.assertTrue(os.path.isfile(os.path.join(ASSETS, "games", path)), path)
            self.assertTrue(all(1 <= len(wave) <= fewest for wave in rules["waves"]))


class Loaded(unittest.TestCase):
    """What the executable makes of the files, each as the one body of a scene."""

    def pieces(self, body):
        with tempfile.TemporaryDirectory() as folder:
            scene = os.path.join(folder, "scene.json")
            with open(scene, "w") as file:
                json.dump({"bodies": [body]}, file)
            run = subprocess.run([KERF, "cut", scene, "--out", os.path.join(folder, "out")], capture_output=True, text=True)
            self.assertEqual(run.returncode, 0, run.stderr)
            with open(os.path.join(folder, "out", "report.json")) as file:
                return len(json.load(file)["pieces"])

    def test_vehicles_and_props_load_with_their_joints_as_one_piece(self):
        files = [read_json("vehicles", name + ".json") for name in VEHICLES]
        props = {body["mesh"]: body for body in read_json("arenas", "yard.json")["bodies"] if body["cuttable"]}
        for body in files + list(props.values()):
            mesh = os.path.join(ASSETS, "meshes", os.path.basename(body["mesh"]))
            self.assertEqual(self.pieces({"mesh": mesh, "joints": body["joints"]}), 1, body["name"])


def load_tests(loader, tests, _):
    suite = unittest.TestSuite(loader.loadTestsFromTestCase(case) for case in (Generators, Games, Loaded))
    for name in VEHICLES:
        suite.addTests(loader.loadTestsFromTestCase(type(name, (Vehicle,), {"name": name})))
    for name in ARENAS:
        suite.addTests(loader.loadTestsFromTestCase(type(name, (Arena,), {"name": name})))
    return suite


if __name__ == "__main__":
    unittest.main()
