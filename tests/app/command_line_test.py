"""The command line as INTERFACE promises it: run as `command_line_test.py KERF`, with KERF the executable to test."""
import json
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

KERF = os.path.abspath(sys.argv.pop(1))
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PLATE = "v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0 0.5\nv -0.5 0 0.5\nf 1 4 3\nf 1 3 2\n"
CUBE = ("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
        "f 1 3 4\nf 1 4 2\nf 5 6 8\nf 5 8 7\nf 1 2 6\nf 1 6 5\nf 3 7 8\nf 3 8 4\nf 1 5 7\nf 1 7 3\nf 2 4 8\nf 2 8 6\n")
ACROSS = {"strokes": [{"laser": {"radius": 0.02, "range": [0, 5]},
                       "keys": [{"t": 0, "origin": [-0.7, 1, 0.1], "direction": [0, -1, 0]},
                                {"t": 1, "origin": [0.7, 1, 0.12], "direction": [0, -1, 0]}]}]}

def kerf(*args, cwd=None):
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return subprocess.run([KERF, *map(str, args)], capture_output=True, text=True, cwd=cwd, env=environment, timeout=900)

def wait_for_folder(folder):
    until = time.monotonic() + 60
    while not os.path.isdir(folder) and time.monotonic() < until:
        time.sleep(0.05)

class CommandLine(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.write("plate.obj", PLATE)
        self.write("across.json", json.dumps(ACROSS))

    def write(self, name, text):
        with open(os.path.join(self.folder.name, name), "w") as file:
            file.write(text)

    def read(self, name):
        with open(os.path.join(self.folder.name, name), "rb") as file:
            return file.read()

    def run_here(self, *args):
        return kerf(*args, cwd=self.folder.name)

    def cut(self, *options, path="across.json"):
        done = self.run_here("cut", "plate.obj", "--path", path, "--out", "out", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.folder.name, "out", "report.json")) as file:
            return json.load(file)

    def assert_refused(self, done, status, *words):
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def test_an_invalid_command_line_points_to_the_help_of_its_command(self):
        self.assert_refused(kerf("cut"), 2, "(see kerf cut --help)")
        self.assert_refused(kerf("prepare", "--smooth", "x"), 2, "(see kerf prepare --help)")
        self.assert_refused(kerf("--no-such-option"), 2, "(see kerf --help)")

    def test_empty_words_are_bad_input(self):
        cut = ["cut", "plate.obj", "--out", "out"]
        for option in ("--path", "--drawing", "--settings", "--journal", "--thickness", "--model", "--material", "--depth", "--unit"):
            self.assert_refused(self.run_here(*cut, option, ""), 2, option)
            self.assert_refused(self.run_here(*cut, option + "="), 2, option)
        for command, name in ((["cut", "", "--out", "out"], "MESH"), (["cut", "plate.obj", "--out", ""], "--out"), (["info", ""], "MESH"),
                              (["render", "plate.obj", "-o", ""], "--out"), ([""], "FILE"), (["replay", ""], "JOURNAL")):
            self.assert_refused(self.run_here(*command), 2, name)
        self.assertFalse(os.path.exists(os.path.join(self.folder.name, "out")))

    def test_a_name_longer_than_a_file_may_have_is_bad_input(self):
        long = "x" * 300
        self.assert_refused(kerf(long), 2, "xxx: no such file or command")
        self.assert_refused(kerf("play", "--headless", "--report", f"{long}/report.json"), 2, "--report: no such folder")
        for command in (("info", long), ("cut", long, "--out", "o"), ("replay", long), ("path", long + ".svg", "--out", "a.nc")):
            self.assert_refused(self.run_here(*command), 2, "xxx")

    def test_names_with_line_breaks_leave_a_message_on_one_line(self):
        for command in (("path", "a\nb.txt", "--out", "c.nc"), ("cut", "plate.obj", "--out", "o", "--no\nsuch"),
                        ("render", "plate.obj", "--out", "a\nb.bmp"), ("replay", "a\nb.kerf")):
            self.assert_refused(self.run_here(*command), 2, "?")
        done = self.run_here("cut", "plate.obj", "--path", "across.json", "--out", "o\np")
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (0, 1), done.stderr)

    def test_help_and_version_go_to_standard_output(self):
        for args in (["--help"], ["--version"], ["cut", "--help"], ["info", "--help"], ["inspect", "--help"], ["render", "--help"]):
            done = kerf(*args)
            self.assertEqual((done.returncode, done.stderr), (0, ""), args)
            self.assertTrue(done.stdout.strip())

    def test_info_accounts_for_every_face(self):
        report = json.loads(self.run_here("info", "plate.obj").stdout)
        self.assertEqual(report["faces"], 2)
        self.assertEqual(report["vertices"], 4)
        self.assertEqual(report["boundary_edges"], 4)
        self.assertAlmostEqual(report["area"], 1)

    def test_info_reports_whether_a_mesh_is_closed(self):
        self.write("cube.obj", CUBE)
        for mesh, closed in (("cube.obj", True), ("plate.obj", False)):
            self.assertIs(json.loads(self.run_here("info", mesh).stdout)["closed"], closed)

    def report_of(self, *args):
        done = self.run_here("cut", *args, "--out", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(self.read("out/report.json"))

    def test_a_solid_has_the_mass_of_its_volume_and_a_smooth_rim(self):
        self.write("cube.obj", CUBE)
        report = self.report_of("cube.obj", "--solid", "--density", "1000")
        piece, = report["pieces"]
        self.assertIs(piece["closed"], True)
        self.assertEqual((report["settings"]["rim"], report["settings"]["solid"]), ("smooth", True))
        self.assertAlmostEqual(piece["volume"], 1)
        self.assertAlmostEqual(piece["mass"], 1000)
        for found, expected in zip(piece["inertia"], [1000 / 6] * 3 + [0] * 3):
            self.assertAlmostEqual(found, expected)
        self.assertEqual(report["removed"]["volume"], 0)
        self.assertEqual(report["walls"], {"faces": 0, "area": 0})
        self.assertEqual(self.report_of("cube.obj", "--solid", "--rim", "smooth")["pieces"][0]["closed"], True)

    def test_without_a_solid_the_report_only_states_which_pieces_are_closed(self):
        self.write("cube.obj", CUBE)
        report = self.report_of("cube.obj", "--density", "1000")
        piece, = report["pieces"]
        self.assertEqual((piece["closed"], report["settings"]["rim"]), (True, "faces"))
        self.assertAlmostEqual(piece["mass"], 6)
        self.assertEqual(list(report["removed"]), ["faces", "area"])
        self.assertNotIn("walls", report)
        self.assertEqual(report["notes"], [])
        self.assertNotIn("solid", report["settings"])

    def test_an_open_mesh_declared_solid_is_cut_as_a_sheet(self):
        sheet = self.cut()
        report = self.cut("--solid")
        self.assertEqual([piece["closed"] for piece in report["pieces"]], [False, False])
        self.assertNotIn("volume", report["pieces"][0])
        self.assertAlmostEqual(report["pieces"][0]["mass"], 7.85 * report["pieces"][0]["area"])
        self.assertNotEqual(report["state_hash"], sheet["state_hash"])

    def test_options_that_create_no_walls_are_rejected_with_solid(self):
        for options in (["--rim", "faces"], ["--pattern", "rays4"], ["--model", "thermal"]):
            refused = self.run_here("cut", "plate.obj", "--out", "o", "--solid", *options)
            self.assert_refused(refused, 2, "--solid", options[1])
        for settings, word in (({"solid": True, "rim": "faces"}, "--solid"), ({"solid": "auto"}, "/solid")):
            self.write("settings.json", json.dumps(settings))
            refused = self.run_here("cut", "plate.obj", "--out", "o", "--settings", "settings.json")
            self.assert_refused(refused, 2, word)

    def test_options_that_leave_no_smooth_rim_are_rejected_with_it(self):
        for options in (["--pattern", "rays4"], ["--model", "thermal"]):
            refused = self.run_here("cut", "plate.obj", "--out", "o", "--rim", "smooth", *options)
            self.assert_refused(refused, 2, "--rim: a smooth rim needs", "remove " + " ".join(options))
            self.write("settings.json", json.dumps({"rim": "smooth"}))
            refused = self.run_here("cut", "plate.obj", "--out", "o", "--settings", "settings.json", *options)
            self.assert_refused(refused, 2, "--rim: a smooth rim needs")
            self.report_of("plate.obj", "--settings", "settings.json", "--rim", "faces", *options)

    def test_a_settings_file_makes_bodies_solid(self):
        self.write("settings.json", json.dumps({"solid": True}))
        self.assertEqual(self.cut("--settings", "settings.json")["settings"]["solid"], True)

    def test_a_solid_body_of_a_scene_is_cut_with_a_smooth_rim_by_default(self):
        self.write("cube.obj", CUBE)
        for solid, rim in (("auto", "smooth"), (True, "smooth"), (False, "faces")):
            self.write("scene.json", json.dumps({"bodies": [{"mesh": "cube.obj", "solid": solid}]}))
            report = self.report_of("scene.json")
            self.assertEqual(report["settings"]["rim"], rim)
            self.assertEqual("walls" in report, bool(solid))

    def test_options_that_create_no_walls_are_rejected_with_a_solid_body_of_a_scene(self):
        self.write("cube.obj", CUBE)
        for options in (["--rim", "faces"], ["--pattern", "rays4"], ["--model", "thermal"]):
            for solid in ("auto", True):
                bodies = [{"mesh": "plate.obj"}, {"mesh": "cube.obj", "solid": solid}]
                self.write("scene.json", json.dumps({"bodies": bodies, "strokes": ACROSS["strokes"]}))
                refused = self.run_here("cut", "scene.json", "--out", "o", "--journal", "o.kerf", *options)
                self.assert_refused(refused, 2, "scene.json: /bodies/1/solid: walls need", "remove " + " ".join(options))
            self.assertFalse({"o", "o.kerf"} & set(os.listdir(self.folder.name)))
            self.write("scene.json", json.dumps({"bodies": [{"mesh": "cube.obj", "solid": False}]}))
            self.report_of("scene.json", *options)

    def test_a_mesh_that_differs_from_the_hash_of_its_scene_is_not_cut(self):
        self.cut("--journal", "cut.kerf")
        body, = json.loads(self.read("cut.kerf").splitlines()[0])["bodies"]
        self.write("scene.json", json.dumps({"bodies": [body]}))
        self.report_of("scene.json", "--path", "across.json")
        self.write("plate.obj", PLATE + "v 1 2 3\n")
        refused = self.run_here("cut", "scene.json", "--path", "across.json", "--out", "o", "--journal", "o.kerf")
        self.assert_refused(refused, 2, "plate.obj: the mesh differs")

    def test_a_journal_of_solid_bodies_replays_to_its_hash(self):
        report = self.cut("--solid", "--journal", "cut.kerf")
        self.assertIs(json.loads(self.read("cut.kerf").splitlines()[0])["bodies"][0]["solid"], True)
        self.assertEqual(self.run_here("replay", "cut.kerf").stdout.strip(), report["state_hash"])

    def test_joints_name_parts_of_an_obj_file_with_a_hash(self):
        two = CUBE.replace("v 0 0 0", "g left#1 shared\nv 0 0 0") + "g left#2 shared\n" + re.sub(
            r"f (\d) (\d) (\d)", lambda f: "f " + " ".join(str(int(i) + 8) for i in f.groups()),
            re.sub(r"v (\d)", lambda v: f"v {int(v[1]) + 2}", CUBE))
        self.write("two.obj", two)
        self.write("scene.json", json.dumps({"bodies": [{"mesh": "two.obj", "joints": [
            {"kind": "weld", "parts": ["left#1", "left#2"], "anchor": [1.5, 0.5, 0.5]}]}]}))
        done = self.run_here("cut", "scene.json", "--out", "out")
        self.assertEqual(done.returncode, 0, done.stderr)

    def far_cube(self):
        lines = [line.split() for line in CUBE.splitlines()]
        moved = [["v", repr(448262.537 + 2 * float(l[1])), repr(112.25 + float(l[2])), repr(5411932.731 + float(l[3]))]
                 if l[0] == "v" else l for l in lines]
        self.write("far.obj", "".join(" ".join(line) + "\n" for line in moved))
        at = lambda x, z: {"origin": [448262.537 + x, 115.25, 5411932.731 + z], "direction": [0, -1, 0]}
        self.write("far.json", json.dumps({"strokes": [{"laser": {"radius": 0.03, "range": [0, 10]},
                                                        "keys": [{"t": 0, **at(-1, 0.3)}, {"t": 1, **at(3, 0.7)}]}]}))
        return "cut", "far.obj", "--path", "far.json", "--solid", "--out", "out"

    def stl_edges_and_volume(self, name):
        """How many edges of an STL file are not used once in each direction, and the volume."""
        data, edges, volume = self.read(name), {}, 0
        for at in range(84, 84 + 50 * struct.unpack_from("<I", data, 80)[0], 50):
            a, b, c = (struct.unpack_from("<3f", data, at + 12 * (i + 1)) for i in range(3))
            for edge, sign in (((a, b), 1), ((b, c), 1), ((c, a), 1), ((b, a), -1), ((c, b), -1), ((a, c), -1)):
                edges[edge] = edges.get(edge, 0) + sign
            volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
        return sum(1 for count in edges.values() if count), volume

    def test_single_precision_loss_is_reported_and_avoided_by_recentring(self):
        far = self.far_cube()
        done = self.run_here(*far, "--format", "stl")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("kerf: warning: STL stores single precision: vertices move by up to", done.stderr)
        report = json.loads(self.read("out/report.json"))
        self.assertIn("single precision", report["notes"][0])
        self.assertEqual(report["origin"], [0, 0, 0])

        done = self.run_here(*far, "--format", "stl", "--recentre")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("precision", done.stderr)
        near = json.loads(self.read("out/report.json"))
        self.assertEqual(near["notes"], [])
        self.assertEqual(near["origin"], [448264, 112, 5411934])
        self.assertEqual(len(near["pieces"]), 2)
        for piece, far_piece in zip(near["pieces"], report["pieces"]):
            open_edges, volume = self.stl_edges_and_volume(os.path.join("out", piece["file"]))
            self.assertEqual(open_edges, 0)
            self.assertAlmostEqual(volume, piece["volume"], 6)
            self.assertEqual((piece["pose"], piece["centroid"]), (far_piece["pose"], far_piece["centroid"]))

    def test_recentred_coordinates_plus_origin_equal_those_of_the_mesh(self):
        far = self.far_cube()
        vertices = lambda: [list(map(float, line.split()[1:])) for line in self.read("out/piece-0000.obj").decode().splitlines()
                            if line.startswith("v ")]
        self.assertEqual(self.run_here(*far).returncode, 0)
        exact = vertices()
        self.assertEqual(self.run_here(*far, "--recentre").returncode, 0)
        origin = json.loads(self.read("out/report.json"))["origin"]
        self.assertEqual([[x + o for x, o in zip(v, origin)] for v in vertices()], exact)

    def test_a_nested_shell_is_reported_and_turned_into_a_cavity(self):
        inner = re.sub(r"f (\d) (\d) (\d)", lambda f: "f " + " ".join(str(int(i) + 8) for i in f.groups()),
                       re.sub(r"v (\d) (\d) (\d)", lambda v: "v " + " ".join(str(1 + int(i)) for i in v.groups()), CUBE))
        self.write("shells.obj", re.sub(r"v (\d) (\d) (\d)", lambda v: "v " + " ".join(str(3 * int(i)) for i in v.groups()),
                                        CUBE) + inner)
        note = "1 closed part is inside another one and faces the same way"
        done = self.run_here("info", "shells.obj")
        self.assertIn(note, done.stderr)
        self.assertIn(note, json.loads(done.stdout)["notes"][0])
        report = self.report_of("shells.obj", "--solid")
        self.assertIn(note, report["notes"][0])
        self.assertAlmostEqual(report["pieces"][0]["volume"], 28)

        self.write("down.json", json.dumps({"strokes": [{"laser": {"radius": 0.05, "range": [0, 10]}, "keys": [
            {"t": 0, "origin": [-1, 5, 1.5], "direction": [0, -1, 0]}, {"t": 1, "origin": [4, 5, 1.5], "direction": [0, -1, 0]}]}]}))
        done = self.run_here("cut", "shells.obj", "--out", "out")
        self.assertEqual(done.stderr.count(note), 1, done.stderr)
        report = self.report_of("shells.obj", "--solid", "--turn-shells", "--path", "down.json", "--journal", "down.kerf")
        self.assertEqual(report["notes"], [])
        self.assertEqual([piece["closed"] for piece in report["pieces"]], [True, True])
        self.assertAlmostEqual(sum(piece["volume"] for piece in report["pieces"]) + report["removed"]["volume"], 26, 5)
        done = self.run_here("replay", "down.kerf", "--expect", report["state_hash"])
        self.assertEqual(done.returncode, 0, done.stderr)

        done = self.run_here("prepare", "shells.obj", "--turn-shells", "--out", "turned.obj")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn(note, done.stderr)
        self.assertEqual(self.report_of("turned.obj", "--solid")["notes"], [])
        self.assertAlmostEqual(self.report_of("turned.obj", "--solid")["pieces"][0]["volume"], 26)

    def test_inspect_writes_the_component_graph_of_a_mesh_and_of_a_cut(self):
        graph = json.loads(self.run_here("inspect", "plate.obj", "--graph").stdout)
        self.assertEqual([(n["face"], n["piece"]) for n in graph["nodes"]], [(0, 0), (1, 0)])
        self.assertEqual(graph["edges"], [[0, 1]])
        self.assertIn("0 -- 1;", self.run_here("inspect", "plate.obj", "--graph", "--dot").stdout)
        report = self.cut("--journal", "cut.kerf")
        graph = json.loads(self.run_here("inspect", "cut.kerf", "--graph").stdout)
        self.assertEqual(len(graph["nodes"]), report["output"]["faces"])
        self.assertEqual({n["piece"] for n in graph["nodes"]}, set(range(len(report["pieces"]))))
        for a, b in graph["edges"]:
            self.assertEqual(graph["nodes"][a]["piece"], graph["nodes"][b]["piece"])

    def test_inspect_writes_tree_boxes_and_whether_the_beam_hit_them(self):
        self.cut("--journal", "cut.kerf")
        whole, = json.loads(self.run_here("inspect", "plate.obj", "--tree").stdout)["bodies"]
        self.assertEqual((whole["body"], whole["faces"]), ("plate", 2))
        self.assertEqual([box["leaf"] for box in whole["boxes"]].count(True), 2)
        self.assertFalse(any(box["hit"] for box in whole["boxes"]))
        cut, = json.loads(self.run_here("inspect", "cut.kerf", "--tree").stdout)["bodies"]
        self.assertEqual([box["leaf"] for box in cut["boxes"]].count(True), cut["faces"])
        self.assertTrue(any(box["hit"] for box in cut["boxes"]))

    def test_inspect_replaces_the_bytes_of_names_that_are_not_utf_8(self):
        name = os.fsdecode(b"pl\xe4te.obj")
        self.write(name, PLATE)
        done = self.run_here("inspect", name, "--tree")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([body["body"] for body in json.loads(done.stdout)["bodies"]], ["pl\ufffdte"])

    def test_inspect_writes_the_stages_of_a_move_up_to_the_result_of_the_cut(self):
        report = self.cut("--journal", "cut.kerf")
        beyond = self.run_here("inspect", "cut.kerf", "--step", "1000000")
        self.assertEqual(beyond.returncode, 2)
        moves, = re.findall(r"only (\d+) moves", beyond.stderr)
        removed = 0
        for number in range(1, int(moves) + 1):
            step = json.loads(self.run_here("inspect", "cut.kerf", "--step", str(number)).stdout)
            names = [stage["stage"] for stage in step["stages"]]
            self.assertEqual((names[:3], names[-1]), (["sweep", "hit", "refine"], "separate"))
            for stage in step["stages"]:
                if stage["stage"].startswith("hit"):
                    query, = stage["queries"]
                    self.assertEqual(query["touched"], stage["hit"])
                if stage["stage"] == "remove":
                    removed += len(stage.get("gone", []))
        self.assertEqual(step["state_hash"], report["state_hash"])
        self.assertEqual(removed, report["removed"]["faces"])

    def test_invalid_command_lines_exit_with_2_and_one_sentence(self):
        for args, word in ((["info"], "MESH"), (["info", "nowhere.obj"], "nowhere.obj"), (["cut"], "MESH"),
                           (["info", "plate.obj", "--nonsense"], "nonsense"),
                           (["inspect", "plate.obj"], "--graph"), (["inspect", "nowhere.obj", "--graph"], "nowhere.obj"),
                           (["inspect", "plate.obj", "--dot"], "--graph"),
                           (["inspect", "plate.obj", "--tree", "--graph"], "--step"),
                           (["inspect", "plate.obj", "--step", "0"], "--step"), (["inspect", "plate.obj", "--step", "1"], "moves"),
                           (["play", "--headless", "--driver", "nobody"], "driver"),
                           (["cut", "plate.obj", "--out", "o", "--depth", "x"], "depth"),
                           (["cut", "plate.obj", "--out", "o", "--depth", "-1"], "--depth"),
                           (["cut", "plate.obj", "--out", "o", "--radius", "0"], "--radius"),
                           (["cut", "plate.obj", "--out", "o", "--range", "3,1"], "--range"),
                           (["cut", "plate.obj", "--out", "o", "--scheme", "red"], "one-to-four"),
                           (["cut", "plate.obj", "--out", "o", "--model", "magic"], "thermal"),
                           (["cut", "plate.obj", "--out", "o", "--power", "0"], "--power"),
                           (["cut", "plate.obj", "--out", "o", "--settle", "0"], "--settle: must be from 0.001 to 3600 s"),
                           (["cut", "plate.obj", "--out", "o", "--target-edge", "nan"], "--target-edge"),
                           (["cut", "plate.obj", "--out", "o", "--format", "fbx"], "--format"),
                           (["cut", "plate.obj", "--out", "o", "--path", "missing.json"], "missing.json"),
                           (["render", "plate.obj", "--out", "p.png", "--size", "0x5"], "--size"),
                           (["render", "plate.obj", "--out", "p.png", "--eye", "1,2"], "--eye"),
                           (["render", "plate.obj", "--out", "p.png", "--eye", "1,2,3", "--target", "1,2,3.0"], "--eye and --target: must differ"),
                           (["render", "plate.obj", "--out", "p.png", "--eye", "0,0,0"], "the centre of its view"),
                           (["render", "plate.obj", "--out", "p.png", "--show", "hot"], "kerf: --show: 'hot' is not an overlay"),
                           (["--report"], "report")):
            self.assert_refused(self.run_here(*args), 2, word)

    def test_a_unit_converts_files_that_state_none_to_metres(self):
        self.write("cube.obj", CUBE)
        for unit, metres in (("mm", 0.001), ("cm", 0.01), ("m", 1), ("in", 0.0254)):
            info = json.loads(self.run_here("info", "cube.obj", "--unit", unit).stdout)
            self.assertEqual(unit, info["units"]["mesh_files"])
            self.assertAlmostEqual(6 * metres**2, info["area"], delta=1e-12)
        self.assertEqual(0, self.run_here("prepare", "cube.obj", "--unit", "mm", "--out", "cube.3mf").returncode)
        for name in ("cube.3mf", "cube.obj"):  # 3MF states its unit
            info = json.loads(self.run_here("info", name, "--unit", "mm").stdout)
            self.assertAlmostEqual(6e-6, info["area"], delta=1e-12)
        compared = json.loads(self.run_here("compare", "cube.3mf", "cube.obj", "--unit", "mm").stdout)
        self.assertLess(compared["distance"]["max"], 1e-9)
        # The journal and a scene keep the unit.
        done = self.run_here("cut", "cube.obj", "--unit", "mm", "--plane", "1,0,0,0.0004", "--solid", "--out", "out", "--journal", "a.kerf")
        self.assertEqual(0, done.returncode, done.stderr)
        report = json.loads(self.read("out/report.json"))
        self.assertEqual("mm", report["units"]["mesh_files"])
        for piece, volume in zip(report["pieces"], (6e-10, 4e-10)):
            self.assertAlmostEqual(volume, piece["volume"], delta=1e-18)
        done = self.run_here("replay", "a.kerf")
        self.assertEqual((0, report["state_hash"]), (done.returncode, done.stdout.strip()))
        self.write("scene.json", json.dumps({"bodies": [{"mesh": "cube.obj", "unit": "mm"}]}))
        self.write("settings.json", '{"unit": "mm"}')
        for arguments in (["scene.json"], ["cube.obj", "--settings", "settings.json"]):
            self.run_here("cut", *arguments, "--out", "out")
            self.assertAlmostEqual(6e-6, json.loads(self.read("out/report.json"))["input"]["area"], delta=1e-12)
        for command in (["cut", "scene.json", "--out", "out"], ["render", "scene.json", "--out", "a.png"], ["inspect", "a.kerf", "--graph"]):
            self.assert_refused(self.run_here(*command, "--unit", "mm"), 2, "state that of each mesh")
        self.assert_refused(self.run_here("info", "cube.obj", "--unit", "ft"), 2, "the values are: mm, cm, m, in")

    def test_the_instruction_set_does_not_change_results(self):
        hashes = set()
        for simd in ("plain", "sse4", "avx2", None):
            environment = {**os.environ, **({"KERF_SIMD": simd} if simd else {})}
            done = subprocess.run([KERF, "cut", "assets/meshes/car.obj", "--radius", "0.02", "--path", os.path.join(self.folder.name, "across.json"),
                                   "--out", os.path.join(self.folder.name, "out")], cwd=ROOT, env=environment, capture_output=True, text=True)
            if done.returncode == 2 and "this processor does not support" in done.stderr:
                continue
            self.assertEqual(0, done.returncode, done.stderr)
            hashes.add(json.loads(self.read("out/report.json"))["state_hash"])
        self.assertEqual(1, len(hashes))
        done = subprocess.run([KERF, "materials"], env={**os.environ, "KERF_SIMD": "fast"}, capture_output=True, text=True)
        self.assert_refused(done, 2, "KERF_SIMD must be plain, sse4 or avx2")

    def test_unwritable_output_exits_with_1(self):
        self.assert_refused(self.run_here("cut", "plate.obj", "--out", "/proc/nowhere"), 1, "/proc/nowhere")
        self.write("file", "")
        self.assert_refused(self.run_here("cut", "plate.obj", "--out", "file"), 1, "file")

    def test_cut_reports_its_output(self):
        report = self.cut()
        self.assertEqual(len(report["pieces"]), 2)
        self.assertGreaterEqual(report["pieces"][0]["area"], report["pieces"][1]["area"])
        whole = report["input"]["area"]
        self.assertAlmostEqual(whole, report["removed"]["area"] + report["output"]["area"], delta=1e-6 * whole)
        for piece in report["pieces"]:
            with open(os.path.join(self.folder.name, "out", piece["file"])) as file:
                lines = file.read().splitlines()
            self.assertEqual(sum(line.startswith("f ") for line in lines), piece["faces"])
            self.assertEqual(sum(line.startswith("v ") for line in lines), piece["vertices"])
        self.assertRegex(report["state_hash"], r"^[0-9a-f]{16}$")

    def test_the_same_input_gives_the_same_hash_and_another_input_does_not(self):
        first, second = self.cut(), self.cut("--steps", "7")
        self.assertEqual(first["state_hash"], second["state_hash"])
        self.assertEqual(second["steps"], 7)
        self.assertNotEqual(first["state_hash"], self.cut("--radius", "0.021")["state_hash"])

    def test_without_a_path_nothing_is_cut(self):
        done = self.run_here("cut", "plate.obj", "--out", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.folder.name, "out", "piece-0000.obj")) as file:
            self.assertEqual([l for l in file.read().splitlines() if l[:2] == "v "], PLATE.splitlines()[:4])

    def test_settings_come_from_a_file_and_the_command_line_overrides_them(self):
        self.write("settings.json", json.dumps({"depth": 2, "radius": 0.05, "pattern": "rays4"}))
        report = self.cut("--settings", "settings.json", "--radius", "0.03", "--pattern", "volume")
        self.assertEqual(report["settings"]["depth"], 2)
        self.assertEqual(report["settings"]["radius"], 0.03)
        self.assertEqual(report["settings"]["pattern"], "volume")
        for wrong, words in (({"deepness": 2}, "is not a setting"), ({"radius": -1}, "must be greater than zero"),
                             ({"depth": 25}, "must be a whole number from 0 to 24"), ({"depth": 1.5}, "must be a whole number from 0 to 24"),
                             ({"rim": "red"}, '"red" is not a valid value; the values are: faces, smooth'),
                             ({"range": [2, 1]}, "must be [min, max]")):
            self.write("settings.json", json.dumps(wrong))
            done = self.run_here("cut", "plate.obj", "--out", "out", "--settings", "settings.json")
            self.assert_refused(done, 2, f"settings.json: /{next(iter(wrong))}: {words}")

    def test_depth_0_removes_whole_base_faces(self):
        self.assertEqual(self.cut("--depth", "0")["removed"]["faces"], 2)

    def test_prepare_subdivides_smooths_and_simplifies_and_keeps_materials(self):
        self.write("two.obj", PLATE.replace("f 1 4 3", "usemtl red\nf 1 4 3").replace("f 1 3 2", "usemtl blue\nf 1 3 2"))
        done = self.run_here("prepare", "two.obj", "--subdivide", "midpoint", "--smooth", "2", "--out", "eight.obj")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", "kerf: 2 faces became 8 in eight.obj\n"))
        text = self.read("eight.obj").decode()
        self.assertEqual((text.count("\nf "), text.count("red"), text.count("blue")), (8, 1, 1))
        for ending in ("obj", "ply", "stl", "off"):
            self.assertEqual(self.run_here("prepare", "eight.obj", "--subdivide", "sqrt3", "--out", f"a.{ending}").returncode, 0)
            self.assertEqual(json.loads(self.run_here("info", f"a.{ending}").stdout)["faces"], 24)
        done = self.run_here("prepare", "a.ply", "--out", "same.stl")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("kerf: 24 faces are in same.stl\n", done.stderr)
        self.assertEqual(json.loads(self.run_here("info", "same.stl").stdout)["faces"], 24)
        self.run_here("prepare", "a.ply", "--subdivide", "midpoint", "--out", "b.ply")
        done = self.run_here("prepare", "b.ply", "--simplify-error", "0.001", "--out", "c.ply")
        self.assertRegex(done.stderr, "^kerf: 96 faces became [0-9]+ in c.ply\n$")
        self.write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n")
        done = self.run_here("prepare", "one.obj", "--subdivide", "midpoint", "--out", "four.obj")
        self.assertEqual(done.stderr, "kerf: 1 face became 4 in four.obj\n")

    def test_prepare_reports_when_boundaries_prevent_the_requested_face_count(self):
        done = self.run_here("prepare", "plate.obj", "--subdivide", "midpoint", "--simplify", "1", "--out", "a.obj")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("note: 2 faces are left", done.stderr)

    def test_prepare_rejects_invalid_options(self):
        for options, word in ((["--out", "a.obj"], "nothing to do"), (["--out", "a.txt", "--smooth", "1"], "--out"),
                              (["--out", "a.obj", "--simplify", "0"], "--simplify"),
                              (["--out", "a.obj", "--simplify-error", "nan"], "--simplify-error"),
                              (["--out", "a.obj", "--simplify", "9", "--simplify-error", "1"], "together"),
                              (["--out", "a.obj", "--subdivide", "twice"], "midpoint"),
                              (["--out", "a.obj", "--smooth", "100000"], "--smooth")):
            self.assert_refused(self.run_here("prepare", "plate.obj", *options), 2, word)
        self.assert_refused(self.run_here("prepare", "none.obj", "--smooth", "1", "--out", "a.obj"), 2, "none.obj")
        self.assert_refused(self.run_here("prepare", "plate.obj", "--simplify", "2", "--out", "none/a.obj"), 1, "none")
        self.assertFalse(os.path.exists(os.path.join(self.folder.name, "a.obj")))

    def test_ctrl_c_cancels_prepare_and_leaves_no_file(self):
        rows = 300
        corners = "".join(f"v {x} {(x * y) % 7 / 10} {y}\n" for y in range(rows) for x in range(rows))
        faces = "".join(f"f {a} {a + 1} {a + rows + 1} {a + rows}\n" for y in range(rows - 1)
                        for a in range(y * rows + 1, y * rows + rows))
        self.write("rough.obj", corners + faces)
        process = subprocess.Popen([KERF, "prepare", "rough.obj", "--simplify", "9", "--out", "a.obj"], cwd=self.folder.name,
                                   stderr=subprocess.PIPE, text=True)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        message = process.communicate(timeout=900)[1]
        self.assertEqual(process.returncode, 130, message)
        self.assertIn("interrupted", message)
        self.assertEqual([name for name in os.listdir(self.folder.name) if name.startswith("a.")], [])

    def thermal(self, speed, *options):
        """Crosses a sheet of 2 mm at a speed in m/s with 2 kW; the report."""
        self.write("sheet.obj", "v -.03 0 -.01\nv .03 0 -.01\nv .03 0 .01\nv -.03 0 .01\nf 1 4 3\nf 1 3 2\n")
        key = '{"t": %g, "origin": [0, 0.1, %g], "direction": [0, -1, 0]}'
        self.write("beam.json", '{"strokes": [{"laser": {"radius": 0.0001, "power": 2000}, "keys": [%s, %s]}]}' % (
            key % (0, -.012), key % (.024 / speed, .012)))
        done = self.run_here("cut", "sheet.obj", "--path", "beam.json", "--out", "out", "--model", "thermal",
                             "--thickness", "0.002", *(options if "--material" in options else ("--material", "stainless-304", *options)))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.said = done.stderr
        return json.loads(self.read("out/report.json"))

    def test_strokes_that_miss_are_reported(self):
        far = {"keys": [{"t": 0, "origin": [99, 1, 99], "direction": [0, -1, 0]}]}
        self.write("some.json", json.dumps({"strokes": [far, *ACROSS["strokes"], far]}))
        done = self.run_here("cut", "plate.obj", "--path", "some.json", "--out", "out", "--journal", "some.kerf")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr.splitlines()[0], "kerf: warning: some.json: /strokes/0 and /strokes/2 hit nothing: "
                                                      "no mesh is in the path of the beam")
        self.assertEqual(json.loads(self.read("out/report.json"))["missed"], [0, 2])
        done = self.run_here("replay", "some.kerf", "--out", "again")
        self.assertEqual(json.loads(self.read("again/report.json"))["missed"], [0, 2])
        self.assertEqual(self.cut()["missed"], [])

    def test_a_misspelt_key_or_option_is_rejected_with_the_nearest_name(self):
        stroke, key = ACROSS["strokes"][0], ACROSS["strokes"][0]["keys"][0]
        for path, pointer, nearest in (({**ACROSS, "stroke": 1}, "/stroke", "strokes"),
                                       ({"strokes": [{**stroke, "laser": {"raduis": 1}}]}, "/strokes/0/laser/raduis", "radius"),
                                       ({"strokes": [{**stroke, "laser": {"Range": [0, 1]}}]}, "/strokes/0/laser/Range", "range"),
                                       ({"strokes": [{"keys": [{**key, "dir": 1}]}]}, "/strokes/0/keys/0/dir", "direction")):
            self.write("path.json", json.dumps(path))
            done = self.run_here("cut", "plate.obj", "--out", "o", "--path", "path.json")
            self.assert_refused(done, 2, f"path.json: {pointer}: ", f'"{nearest}"')
        for scene, pointer, nearest in (({"shows": ["wire"]}, "/shows", "show"), ({"pants": {}}, "/pants", "paints"),
                                        ({"bodies": [{"mesh": "plate.obj", "thicknes": 1}]}, "/bodies/0/thicknes", "thickness"),
                                        ({"bodies": [{"mesh": "plate.obj", "soild": True}]}, "/bodies/0/soild", "solid"),
                                        ({"paints": {"a": {"color": "#123456"}}}, "/paints/a/color", "colour"),
                                        ({"lights": [{"direction": [0, 1, 0], "intesity": 1}]}, "/lights/0/intesity", "intensity"),
                                        ({"view": {"eye": [0, 0, 1], "target": [0, 0, 0], "up": "y"}}, "/view/up", "eye")):
            self.write("scene.json", json.dumps({"bodies": [{"mesh": "plate.obj"}], **scene}))
            self.assert_refused(self.run_here("cut", "scene.json", "--out", "o"), 2, f"scene.json: {pointer}: ", f'"{nearest}"')
        self.write("scene.json", json.dumps({"bodies": [{"mesh": "plate.obj"}], "show": ["wires"]}))
        done = self.run_here("render", "scene.json", "--out", "p.png")
        self.assert_refused(done, 2, "kerf: scene.json: /show: 'wires' is not an overlay")
        self.write("settings.json", json.dumps({"thicknes": 1}))
        done = self.run_here("cut", "plate.obj", "--out", "o", "--settings", "settings.json")
        self.assert_refused(done, 2, "/thicknes", '"thickness"')
        self.assert_refused(self.run_here("cut", "plate.obj", "--out", "o", "--raduis=1"), 2, "--raduis", '"--radius"')

    def test_a_key_that_is_given_twice_is_rejected(self):
        whole = json.dumps(ACROSS)
        self.write("path.json", whole[:-1] + ', "strokes": []}')
        done = self.run_here("cut", "plate.obj", "--out", "o", "--path", "path.json")
        self.assert_refused(done, 2, 'path.json: line 1: the key "strokes" is in this object twice')
        self.write("settings.json", '{"radius": 0.1,\n "depth": 1,\n "radius": 0.2}')
        done = self.run_here("cut", "plate.obj", "--out", "o", "--settings", "settings.json")
        self.assert_refused(done, 2, 'settings.json: line 3: the key "radius"')

    def test_a_partly_penetrating_beam_is_not_reported_as_a_miss(self):
        report = self.thermal(5)
        self.assertEqual(report["removed"]["faces"], 0)
        depth = f"{100 * report['depth_fraction']:.0f} %"
        self.assertIn(f"1 stroke removed nothing: the beam reached only {depth} of the thickness", self.said)

    def test_a_beam_with_power_cuts_within_its_energy_and_reports_the_balance(self):
        slow, fast = self.thermal(.1), self.thermal(.5)
        self.assertEqual(len([p for p in slow["pieces"] if p["area"] > 4e-4]), 2)
        self.assertEqual(len(fast["pieces"]), 1)
        self.assertTrue(0 < fast["depth_fraction"] < 1, fast["depth_fraction"])
        for report, speed in ((slow, .1), (fast, .5)):
            e = report["energy_j"]
            self.assertAlmostEqual(e["emitted"], 2000 * .024 / speed, delta=1e-6 * e["emitted"])
            self.assertAlmostEqual(e["emitted"], e["absorbed"] + e["escaped"], delta=1e-6 * e["emitted"])
            self.assertAlmostEqual(e["absorbed"], e["ejected"] + e["stored"] + e["lost"], delta=1e-6 * e["emitted"])

    def test_a_journal_of_a_thermal_cut_stores_material_and_thickness(self):
        report = self.thermal(.2, "--journal", "cut.kerf")
        done = self.run_here("replay", "cut.kerf")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(report["state_hash"], done.stdout)

    def test_oxygen_speeds_up_mild_steel_and_is_stored_in_the_journal(self):
        options = ("--material", "mild-steel", "--journal", "cut.kerf")
        without, oxygen = self.thermal(.12, *options), self.thermal(.12, *options, "--assist", "oxygen")
        self.assertEqual([len([p for p in r["pieces"] if p["area"] > 4e-4]) for r in (without, oxygen)], [1, 2])
        self.assertNotIn("burnt", without["energy_j"])
        self.assertEqual((without["settings"].get("assist"), oxygen["settings"]["assist"]), (None, "oxygen"))
        e = oxygen["energy_j"]
        self.assertAlmostEqual(e["absorbed"] + e["burnt"], e["ejected"] + e["stored"] + e["lost"],
                               delta=1e-6 * e["emitted"])
        done = self.run_here("replay", "cut.kerf")
        self.assertIn(oxygen["state_hash"], done.stdout)
        self.assert_refused(self.run_here("cut", "plate.obj", "--out", "o", "--assist", "air"), 2, "--assist", "oxygen")

    def test_an_unknown_material_is_rejected_with_the_valid_ones(self):
        self.assert_refused(self.run_here("cut", "plate.obj", "--out", "o", "--material", "butter"), 2, "butter",
                            "mild-steel", "pmma")

    def test_ctrl_c_cancels_a_long_cut_and_leaves_no_pieces(self):
        process = subprocess.Popen([KERF, "cut", "plate.obj", "--path", "across.json", "--out", "out", "--target-edge",
                                    "0.0002"], cwd=self.folder.name, stderr=subprocess.PIPE, text=True)
        wait_for_folder(os.path.join(self.folder.name, "out"))
        process.send_signal(signal.SIGINT)
        message = process.communicate(timeout=900)[1]
        self.assertEqual(process.returncode, 130, message)
        self.assertIn("interrupted", message)
        self.assertEqual(os.listdir(os.path.join(self.folder.name, "out")), [])

    def test_a_cut_ends_with_a_one_line_summary_and_no_progress_without_a_terminal(self):
        done = self.run_here("cut", "plate.obj", "--path", "across.json", "--out", "out", "--target-edge", "0.001")
        self.assertEqual((done.returncode, done.stdout), (0, ""))
        self.assertRegex(done.stderr, r"^kerf: 1 stroke removed [0-9 ]+ faces \([0-9.]+ cm²\); "
                                      r"2 pieces and report.json are in out\n$")
        done = self.run_here("cut", "plate.obj", "--out", "whole")
        self.assertEqual(done.stderr, "kerf: no strokes given; "
                                      "1 piece and report.json are in whole\n")

    def test_the_path_file_example_of_readme_and_help_cuts_the_car_in_two(self):
        with open(os.path.join(ROOT, "app", "README.md")) as file:
            readme = file.read()
        example = re.search(r"```json\n(\{\"strokes\".*?)```", readme, re.S).group(1)
        self.write("path.json", example)
        command = re.search(r"^\./app/run (cut assets/meshes/car.obj --path path.json --out pieces)\b", readme, re.M)
        words = command.group(1).replace("assets", os.path.join(ROOT, "assets")).split()
        done = self.run_here(*words)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"^kerf: 1 stroke removed [0-9 ]+ faces .* pieces and report.json are in pieces\n$")
        with open(os.path.join(self.folder.name, "pieces", "report.json")) as file:
            pieces = json.load(file)["pieces"]
        self.assertGreater(pieces[1]["area"], 0.2 * pieces[0]["area"])
        shown = re.search(r"^ *(\{\"strokes\".*\}\]\}\]\})$", kerf("cut", "--help").stdout, re.S | re.M)
        self.assertEqual(json.loads(shown.group(1)), json.loads(example))

    def test_dropped_faces_are_reported(self):
        self.write("odd.obj", PLATE + "f 1 2 9\nf 1 1 2\nf 4 1 2 2 3\nf 1 2\n")
        info = json.loads(self.run_here("info", "odd.obj").stdout)
        notes = info["notes"]
        self.assertEqual(notes[0], "1 triangle refers to a missing vertex and was dropped.")
        self.assertIn("1 face has fewer than three corners and was dropped.", notes)
        self.assertEqual(info["repairs"]["incomplete_faces_dropped"], 1)
        done = self.run_here("cut", "odd.obj", "--out", "out")
        said = done.stderr.splitlines()
        self.assertEqual(said[0], "kerf: note: " + notes[0])
        self.assertTrue(all("dropped" in line for line in said[:-1]), said)
        self.assertIn("report.json", said[-1])
        self.assertEqual(json.loads(self.run_here("info", "plate.obj").stdout)["notes"], [])

    def test_a_full_disk_or_read_only_folder_keeps_existing_files(self):
        os.mkdir(os.path.join(self.folder.name, "out"))
        self.write("out/piece-0000.obj", "old\n")
        limit = "ulimit -f 0; exec \"$@\""  # no file may grow: as on a full disk
        done = subprocess.run(["bash", "-c", limit, "kerf", KERF, "cut", "plate.obj", "--out", "out"],
                              cwd=self.folder.name, capture_output=True, text=True)
        self.assert_refused(done, 1, "piece-0000.obj", "cannot write")
        with open(os.path.join(self.folder.name, "out", "piece-0000.obj")) as file:
            self.assertEqual(file.read(), "old\n")
        self.assertEqual(os.listdir(os.path.join(self.folder.name, "out")), ["piece-0000.obj"])
        if os.geteuid() != 0:
            os.chmod(os.path.join(self.folder.name, "out"), 0o555)
            self.assert_refused(self.run_here("cut", "plate.obj", "--out", "out"), 1, "cannot write")

    def test_render_writes_an_image_without_a_display(self):
        done = self.run_here("render", "plate.obj", "--out", "plate.png", "--size", "320x200", "--show", "aabb,wire")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.folder.name, "plate.png"), "rb") as file:
            head = file.read(24)
        self.assertEqual(head[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual((int.from_bytes(head[16:20], "big"), int.from_bytes(head[20:24], "big")), (320, 200))

    def test_render_uses_the_shadows_of_the_editor_by_default(self):
        def picture(*args):
            done = self.run_here("render", "step.obj", "--out", "step.png", "--size", "160x100", *args)
            self.assertEqual(done.returncode, 0, done.stderr)
            return self.read("step.png")
        self.write("step.obj", PLATE + "v -0.4 0.5 -0.4\nv 0.4 0.5 -0.4\nv 0.4 0.5 0.4\nf 5 7 6\n")
        self.assertEqual(picture(), picture("--show", "shadows"))
        self.assertNotEqual(picture(), picture("--show", "wire"))

    def test_render_explodes_pieces(self):
        self.write("cut.json", json.dumps({"bodies": [{"mesh": "plate.obj"}], "strokes": ACROSS["strokes"]}))
        def picture(*args):
            done = self.run_here("render", "cut.json", "--out", "cut.png", "--size", "160x100", *args)
            self.assertEqual(done.returncode, 0, done.stderr)
            return self.read("cut.png")
        self.assertEqual(picture(), picture("--spread", "0"))
        self.assertNotEqual(picture(), picture("--spread", "0.5"))
        for share in ("wide", "-1", "nan"):
            self.assert_refused(self.run_here("render", "cut.json", "--out", "no.png", "--spread", share), 2,
                                "--spread", "from 0 to 100")

    def write_figures(self, scene="plate.json"):
        self.write("plate.json", json.dumps({"bodies": [{"mesh": "plate.obj"}], "lights": [{"direction": [0.3, 1, 1]}]}))
        self.write("figures.json", json.dumps({
            "figures": [{"number": 3, "caption": "A plate.", "scene": scene},
                        {"number": 12, "caption": "A split.", "diagram": "one-to-four"}],
            "films": {"shadow": "plate.json"}}))

    def test_figures_render_deterministically_from_a_list(self):
        self.write_figures()
        seen = []
        for folder in ("a", "b"):
            done = self.run_here("figures", "--out", folder, "--size", "320x200", "--list", "figures.json")
            self.assertEqual(done.returncode, 0, done.stderr)
            names = sorted(os.listdir(os.path.join(self.folder.name, folder)))
            self.assertEqual(names, ["fig03.png", "fig12.png"])
            seen.append([self.read(os.path.join(folder, name)) for name in names])
        self.assertEqual(seen[0], seen[1])
        self.assertEqual(struct.unpack(">2I", seen[0][0][16:24]), (320, 200))

    def test_figures_render_a_film_of_a_rotating_light(self):
        self.write_figures()
        done = self.run_here("figures", "--film", "films", "--size", "64x64", "--list", "figures.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        frames = sorted(os.listdir(os.path.join(self.folder.name, "films", "shadow")))
        self.assertEqual((frames[0], frames[-1]), ("frame-00000.png", f"frame-{len(frames) - 1:05}.png"))
        self.assertEqual(os.listdir(os.path.join(self.folder.name, "films")), ["shadow"])

    def test_figures_rejects_invalid_lists(self):
        self.write_figures(scene="missing.json")
        self.assert_refused(self.run_here("figures"), 2, "--out or --film")
        self.assert_refused(self.run_here("figures", "--out", "o", "--size", "40x40"), 2, "64x64")
        self.assert_refused(self.run_here("figures", "--out", "o", "--list", "figures.json"), 2, "missing.json")
        self.assert_refused(self.run_here("figures", "--out", "o", "--list", "nothing.json"), 2, "nothing.json")

    def test_render_rejects_an_unsupported_extension(self):
        for name in ("plate.jpg", "plate.JPEG", "plate.obj"):
            self.assert_refused(self.run_here("render", "plate.obj", "--out", name), 2, name, "PNG", ".png")
        self.assertFalse(os.path.exists(os.path.join(self.folder.name, "plate.jpg")))
        with open(os.path.join(self.folder.name, "plate.obj")) as file:
            self.assertEqual(file.read(), PLATE)

    def journal(self, *args):
        """The report of a cut that wrote a journal beside its mesh."""
        return self.cut("--journal", "plate.kerf", *args)

    def test_a_journal_replays_to_the_same_hash(self):
        for args in ([], ["--scheme", "one-to-four"], ["--pattern", "rays4"], ["--rim", "smooth"], ["--depth", "3"],
                     ["--tolerance", "0.004"], ["--steps", "3"]):
            report = self.journal(*args)
            done = self.run_here("replay", "plate.kerf", "--expect", report["state_hash"], "--out", "again")
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, report["state_hash"] + "\n", ""), args)
            with open(os.path.join(self.folder.name, "again", "report.json")) as file:
                again = json.load(file)
            for key in ("input", "settings", "output", "pieces", "max_level", "state_hash"):
                self.assertEqual(again[key], report[key], (key, args))

    def test_a_replay_mismatch_is_reported_and_exits_with_1(self):
        hash_of_cut = self.journal()["state_hash"]
        with open(os.path.join(self.folder.name, "plate.kerf")) as file:
            journal = file.read()
        self.write("other.kerf", journal.replace(hash_of_cut, "0123456789abcdef"))
        done = self.run_here("replay", "other.kerf")
        self.assertEqual((done.returncode, done.stdout), (1, hash_of_cut + "\n"))
        self.assertRegex(done.stderr, r"^kerf: other.kerf: line 5: after command 3 \(End the stroke\) .*\n$")
        self.assertEqual(self.run_here("replay", "plate.kerf", "--expect", hash_of_cut.upper()).returncode, 0)
        done = self.run_here("replay", "plate.kerf", "--expect", "0123456789abcdef")
        self.assertEqual(done.returncode, 1)
        self.assertIn("--expect", done.stderr)

    def test_a_truncated_journal_is_read_up_to_the_damage(self):
        self.journal()
        with open(os.path.join(self.folder.name, "plate.kerf")) as file:
            journal = file.read()
        self.write("torn.kerf", journal[:-9])
        done = self.run_here("replay", "torn.kerf")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stderr, "kerf: warning: torn.kerf: line 5: the last line is incomplete and was ignored\n")
        lines = journal.splitlines(keepends=True)
        for damage in ("no JSON\n", '{"do": "explode"}\n', '{"do": "move-beam", "origin": [0, 0, 0]}\n'):
            self.write("middle.kerf", "".join(lines[:2] + [damage] + lines[2:]))
            done = self.run_here("replay", "middle.kerf")
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertRegex(done.stderr, r"^kerf: middle.kerf: line 3: .*; the journal was ignored from this line on\n$")
        self.write("head.kerf", journal[:40])
        self.assert_refused(self.run_here("replay", "head.kerf"), 2, "head.kerf: line 1")

    def test_replay_rejects_invalid_options(self):
        self.journal()
        for args, word in ((["missing.kerf"], "missing.kerf"), (["plate.obj"], "plate.obj: line 1"),
                           (["plate.kerf", "--expect", "12"], "--expect"), (["plate.kerf", "--fps", "10"], "--frames"),
                           (["plate.kerf", "--frames", "f", "--fps", "0"], "--fps")):
            self.assert_refused(self.run_here("replay", *args), 2, word)
        for option, value in (("--size", "64x48"), ("--eye", "0,2,1"), ("--target", "0,0,0"), ("--section", "0,0,0 0,1,0"),
                              ("--show", "wire")):
            self.assert_refused(self.run_here("replay", "plate.kerf", option, value), 2, f"{option} requires --frames")
        self.write("plate.obj", PLATE + "v 1 2 3\n")
        self.assert_refused(self.run_here("replay", "plate.kerf"), 2, "plate.obj: the mesh differs")
        os.remove(os.path.join(self.folder.name, "plate.obj"))
        self.assert_refused(self.run_here("replay", "plate.kerf"), 2, "plate.obj: no such file")

    def test_a_film_is_numbered_images_at_the_requested_frame_rate(self):
        self.journal()
        def frames(folder, fps):
            done = self.run_here("replay", "plate.kerf", "--frames", folder, "--fps", fps, "--size", "64x48")
            self.assertEqual(done.returncode, 0, done.stderr)
            names = sorted(os.listdir(os.path.join(self.folder.name, folder)))
            self.assertEqual(names, [f"frame-{i:05}.png" for i in range(len(names))])
            return len(names)
        # Across 1.4 m at the diagonal, 1.41 m, in four seconds, with half a second at either end and one more.
        self.assertAlmostEqual(frames("slow", 2), 2 * 6, delta=1)
        self.assertAlmostEqual(frames("fast", 5), 5 * 6, delta=1)

    def test_a_shorter_film_removes_the_later_frames_of_a_longer_one(self):
        self.journal()
        self.write_figures()
        for folder, film in (("slow", ["replay", "plate.kerf", "--frames", "slow", "--fps", 2]),
                             ("films/shadow", ["figures", "--film", "films", "--list", "figures.json"])):
            os.makedirs(os.path.join(self.folder.name, folder))
            own = ["frame-1.png", "frame-99999.jpg", "notes.txt"]
            for name in ["frame-00000.png", "frame-77777.png", "frame-99999.png", *own]:
                self.write(os.path.join(folder, name), "earlier")
            done = self.run_here(*film, "--size", "64x64")
            self.assertEqual(done.returncode, 0, done.stderr)
            names = set(os.listdir(os.path.join(self.folder.name, folder)))
            self.assertEqual(names, {f"frame-{i:05}.png" for i in range(len(names) - len(own))} | set(own))

    def test_a_film_omits_undone_and_recut_strokes(self):
        self.journal()
        with open(os.path.join(self.folder.name, "plate.kerf")) as file:
            lines = [line for line in file.read().splitlines() if '"hash"' not in line[:8]]
        head, stroke, end = lines[0], lines[1:-1], lines[-1]
        undone = [line.replace("-0.7", "-0.6") for line in stroke] + [end, '{"do": "undo"}']
        self.write("plain.kerf", "\n".join([head, *stroke, end]) + "\n")
        self.write("undone.kerf", "\n".join([head, *undone, *undone, *stroke, end]) + "\n")
        films = []
        for name in ("plain", "undone"):
            done = self.run_here("replay", name + ".kerf", "--frames", name, "--fps", 2, "--size", "64x48")
            self.assertEqual(done.returncode, 0, done.stderr)
            names = sorted(os.listdir(os.path.join(self.folder.name, name)))
            films.append([self.read(os.path.join(name, frame)) for frame in names])
        self.assertEqual(len(films[0]), len(films[1]))
        self.assertEqual(*films)

    def test_render_draws_a_journal_after_its_cuts(self):
        self.journal("--radius", "0.2")
        for name in ("plate.kerf", "plate.obj"):
            done = self.run_here("render", name, "--out", name + ".png", "--size", "160x100", "--eye", "0,2,0.1")
            self.assertEqual(done.returncode, 0, done.stderr)
        pictures = []
        for name in ("plate.kerf.png", "plate.obj.png"):
            with open(os.path.join(self.folder.name, name), "rb") as file:
                pictures.append(file.read())
        self.assertNotEqual(*pictures)

    def test_a_film_of_a_fall_continues_until_bodies_rest_and_draws_contacts(self):
        def film(name, *args):
            self.cut("--journal", name + ".kerf", *args)
            done = self.run_here("replay", name + ".kerf", "--frames", name, "--fps", 4, "--size", "64x48")
            self.assertEqual(done.returncode, 0, done.stderr)
            return [self.read(os.path.join(name, frame)) for frame in sorted(os.listdir(
                os.path.join(self.folder.name, name)))]
        still, falls = film("still"), film("falls", "--settle", "2", "--ground", "-0.4")
        # Half a second more where the ground is set and where time begins to pass.
        self.assertAlmostEqual(len(falls) - len(still), 4 * 2.75, delta=3)
        self.assertGreaterEqual(len(set(falls[-4 * 4:])), 2)  # pictures of the fall differ
        pictures = []
        for show in ("contacts", "colliders", "centres", ","):
            done = self.run_here("render", "falls.kerf", "--out", "a.png", "--size", "160x100", "--show", show)
            self.assertEqual(done.returncode, 0, done.stderr)
            pictures.append(self.read("a.png"))
        self.assertEqual(len(set(pictures)), 4)

    def test_joints_of_a_scene_are_drawn(self):
        scene = os.path.join(ROOT, "assets", "scenes", "car.json")
        pictures = []
        for show in ("joints", ","):
            done = self.run_here("render", scene, "--out", "a.png", "--size", "160x100", "--show", show)
            self.assertEqual(done.returncode, 0, done.stderr)
            pictures.append(self.read("a.png"))
        self.assertNotEqual(pictures[0], pictures[1])

    def test_the_editor_reports_a_missing_display(self):
        self.assert_refused(self.run_here("plate.obj"), 1, "display")
        self.assert_refused(self.run_here("play"), 1, "display")

if __name__ == "__main__":
    unittest.main()
