"""UVs, normals, materials, images and names come out of a cut, or a note says what did not. `looks_test.py KERF`."""
import ast
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zipfile

KERF = os.path.abspath(sys.argv.pop(1))
IMAGE = b"\x89PNG\r\n\x1a\n an image that nobody decodes"
LIBRARY = "newmtl red paint\nKd 0.8 0.1 0.1\nodd line\nmap_Kd -s 1 1 1 paint.png\nnewmtl bare\nNs 90\n"


def plate(cells, material):
    """A sheet in y = 0 whose UVs are (2x, 1 - z), in two materials."""
    lines = ["mtllib plate.mtl", "o left fender"]
    points = [(i / cells, j / cells) for j in range(cells + 1) for i in range(cells + 1)]
    lines += [f"v {x!r} 0 {z!r}" for x, z in points] + [f"vt {2 * x!r} {1 - z!r}" for x, z in points] + ["vn 0 1 0"]
    faces = []
    for j in range(cells):
        for i in range(cells):
            a = j * (cells + 1) + i + 1
            b = a + cells + 1
            faces += [(a, b, b + 1), (a, b + 1, a + 1)]
    for k, face in enumerate(faces):
        if k in (0, len(faces) // 2):
            lines.append(f"usemtl {material if k else 'bare'}")
        lines.append("f " + " ".join(f"{v}/{v}/1" for v in face))
    return "\n".join(lines) + "\n", points, faces


def numbers(words):
    return tuple(float(word) for word in words)


def read_obj(text):
    """Faces as lists of (position, UV, normal), with the material of each."""
    values = {"v": [], "vt": [], "vn": []}
    faces = []
    material = None
    for line in text.splitlines():
        words = line.split()
        if words[0] in values:
            values[words[0]].append(numbers(words[1:4]))
        elif words[0] == "usemtl":
            material = line[7:]
        elif words[0] == "f":
            corners = [[int(i) - 1 for i in word.split("/")] for word in words[1:]]
            faces.append((material, [(values["v"][v], values["vt"][t], values["vn"][n]) for v, t, n in corners]))
    return faces


def read_npz(file):
    arrays = {}
    with zipfile.ZipFile(file) as archive:
        assert archive.testzip() is None
        for name in archive.namelist():
            data = archive.read(name)
            length = struct.unpack("<H", data[8:10])[0]
            head = ast.literal_eval(data[10:10 + length].decode())
            kind = {"<f8": "d", "<i8": "q"}[head["descr"]]
            content = data[10 + length:]
            arrays[name[:-4]] = head["shape"], struct.unpack(f"<{len(content) // 8}{kind}", content)
    return arrays


class Looks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        text, self.points, self.faces = plate(6, "red paint")
        self.write("plate.obj", text)
        self.write("plate.mtl", LIBRARY)
        self.write("paint.png", IMAGE)
        self.write("cut.json", json.dumps({"strokes": [{"laser": {"radius": 0.02, "range": [0, 5]}, "keys": [
            {"t": 0, "origin": [-0.2, 1, 0.43], "direction": [0, -1, 0]},
            {"t": 1, "origin": [1.2, 1, 0.61], "direction": [0, -1, 0]}]}]}))

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def cut(self, *args, mesh="plate.obj", out="out"):
        command = [KERF, "cut", mesh, "--path", "cut.json", "--out", out, "--target-edge", "0.03", *args]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=900)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.messages = done.stderr
        return json.loads(self.read(f"{out}/report.json"))

    def assert_linear(self, text, up=True):
        faces = read_obj(text)
        self.assertTrue(faces)
        for material, corners in faces:
            self.assertIn(material, ("red paint", "bare", None))  # None: from PLY
            for position, uv, normal in corners:
                self.assertAlmostEqual(uv[0], 2 * position[0], delta=1e-6)
                self.assertAlmostEqual(uv[1], 1 - position[2] if up else position[2], delta=1e-6)
                self.assertEqual(normal, (0, 1, 0))

    def test_obj_keeps_everything(self):
        report = self.cut("--rim", "smooth")
        self.assertEqual(len(report["pieces"]), 2)
        self.assertEqual(report.get("notes", []), [])
        for number, piece in enumerate(report["pieces"]):
            text = self.read("out/" + piece["file"]).decode()
            self.assert_linear(text)
            self.assertTrue(text.startswith("mtllib pieces.mtl\no left fender" + ["", ".001"][number] + "\n"))
        self.assertEqual(self.read("out/paint.png"), IMAGE)
        library = self.read("out/pieces.mtl").decode()
        self.assertIn("newmtl red paint\nKd 0.8 0.1 0.1\nodd line\nmap_Kd -s 1 1 1 paint.png\n", library)

    def test_looks_have_a_hash_of_their_own(self):
        def replayed():
            return subprocess.run([KERF, "replay", "cut.kerf"], cwd=self.folder, capture_output=True, text=True, timeout=900)

        before = self.cut("--journal", "cut.kerf")
        done = replayed()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.write("paint.png", IMAGE + b"!")
        after = self.cut()
        self.assertNotEqual(after["looks_hash"], before["looks_hash"])
        self.assertEqual(after["state_hash"], before["state_hash"])
        done = replayed()
        self.assertEqual((done.returncode, done.stdout.strip()), (0, before["state_hash"]))
        self.assertIn("materials, images or UVs differ", done.stderr)
        os.remove(self.path("plate.mtl"))
        text = self.read("plate.obj").decode()
        self.write("plate.obj", re.sub(r"(?m)^(mtllib|usemtl|vt|vn).*\n|/\d+/\d+", "", text))
        self.assertNotIn("looks_hash", self.cut())

    def test_a_file_of_another_program_is_never_overwritten(self):
        os.mkdir(self.path("out"))
        self.write("out/paint.png", b"mine")
        self.write("out/pieces.mtl", b"mine")
        for _ in range(2):  # the second run uses the files of the first
            self.cut()
            self.assertEqual(self.read("out/paint.png"), b"mine")
            self.assertEqual(self.read("out/pieces.mtl"), b"mine")
            self.assertEqual(self.read("out/paint-2.png"), IMAGE)
            self.assertIn(b"paint-2.png", self.read("out/pieces-2.mtl"))
            self.assertTrue(self.read("out/piece-0000.obj").startswith(b"mtllib pieces-2.mtl\n"))
            self.assertFalse(os.path.exists(self.path("out/pieces-3.mtl")))

    def test_glb_keeps_everything_and_converts_back_to_obj(self):
        report = self.cut("--format", "glb")
        self.assertEqual(report["notes"], ["glTF holds no odd: 1 material loses its"])
        names = set()
        for piece in report["pieces"]:
            data = self.read("out/" + piece["file"])
            self.assertIn(IMAGE, data)
            length = struct.unpack("<I", data[12:16])[0]
            gltf = json.loads(data[20:20 + length])
            names |= {node["name"] for node in gltf["nodes"]}
            for primitive in gltf["meshes"][0]["primitives"]:
                self.assertLessEqual({"POSITION", "NORMAL", "TEXCOORD_0"}, set(primitive["attributes"]))
        self.assertEqual(names, {"left fender", "left fender.001"})
        self.cut(mesh="out/piece-0000.glb", out="back")
        self.assert_linear(self.read("back/piece-0000.obj").decode())
        self.assertEqual(self.read("back/paint.png"), IMAGE)
        self.assertIn("Kd 0.8 0.1 0.1\n", self.read("back/pieces.mtl").decode())

    def gltf_of(self, name):
        """The JSON of a GLB and a function that reads an accessor as a list of rows."""
        data = self.read(name)
        length = struct.unpack("<I", data[12:16])[0]
        gltf, buffer = json.loads(data[20:20 + length]), data[28 + length:]

        def rows(index):
            accessor = gltf["accessors"][index]
            view = gltf["bufferViews"][accessor["bufferView"]]
            parts = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
            kind = {5125: "I", 5126: "f", 5123: "H"}[accessor["componentType"]]
            at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
            values = struct.unpack_from(f"<{parts * accessor['count']}{kind}", buffer, at)
            return [values[i:i + parts] for i in range(0, len(values), parts)]
        return gltf, rows

    def test_colliders_are_hulls_with_names_and_masses(self):
        for engine, name in (("unreal", "UCX_{}_00"), ("godot", "{}-convcolonly")):
            report = self.cut("--format", "glb", "--colliders", "hull", "--collider-names", engine, "--thickness", "0.02",
                              "--density", "1000")
            self.assertEqual(report["settings"]["colliders"], "hull")
            self.assertEqual(report["settings"]["collider-names"], engine)
            for piece in report["pieces"]:
                gltf, rows = self.gltf_of("out/" + piece["file"])
                node, collider = gltf["nodes"]
                self.assertEqual(gltf["scenes"], [{"nodes": [0, 1]}])
                self.assertEqual(collider["name"], name.format(node["name"]))
                self.assertEqual(collider["translation"], node["translation"])
                extras = node["extras"]
                self.assertEqual(extras["mass"], piece["mass"])
                self.assertEqual(extras["inertia"], piece["inertia"])
                for k in range(3):
                    self.assertAlmostEqual(extras["centre_of_mass"][k] + node["translation"][k], piece["centroid"][k])
                primitive = gltf["meshes"][1]["primitives"][0]
                corners = rows(primitive["attributes"]["POSITION"])
                self.assertLessEqual(len(corners), 64)
                self.assertEqual(set(i for i, in rows(primitive["indices"])), set(range(len(corners))))
                for low, end, sign in ((0, "min", 1), (1, "max", -1)):
                    own = gltf["accessors"][gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"]][end]
                    hull = gltf["accessors"][primitive["attributes"]["POSITION"]][end]
                    self.assertAlmostEqual(hull[1], own[1] - sign * 0.01, places=6)
                    for k in (0, 2):
                        self.assertAlmostEqual(hull[k], own[k], delta=2e-3)
        self.cut(mesh="out/piece-0000.glb", out="back")  # the hull is a part like others

    def test_a_single_file_holds_all_pieces(self):
        separate = self.cut("--format", "glb")["pieces"]
        report = self.cut("--format", "glb", "--single-file", "--colliders", "hull")
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["pieces.glb", "report.json"])
        self.assertIs(report["settings"]["single-file"], True)
        self.assertEqual([piece["file"] for piece in report["pieces"]], len(separate) * ["pieces.glb"])
        self.assertEqual([piece["faces"] for piece in report["pieces"]], [piece["faces"] for piece in separate])
        gltf, rows = self.gltf_of("out/pieces.glb")
        names = ["left fender", "UCX_left fender_00", "left fender.001", "UCX_left fender.001_00"]
        self.assertEqual([node["name"] for node in gltf["nodes"]], names)
        self.assertEqual(gltf["scenes"], [{"nodes": [0, 1, 2, 3]}])
        self.assertEqual([node["mesh"] for node in gltf["nodes"]], [0, 1, 2, 3])
        self.assertEqual(sorted(material["name"] for material in gltf["materials"]), ["bare", "red paint"])
        self.assertEqual(len(gltf["images"]), 1)
        self.assertEqual(self.read("out/pieces.glb").count(IMAGE), 1)
        for node, piece in zip(gltf["nodes"][::2], report["pieces"]):
            primitives = gltf["meshes"][node["mesh"]]["primitives"]
            self.assertEqual(sum(gltf["accessors"][p["indices"]]["count"] for p in primitives), 3 * piece["faces"])
            for primitive in primitives:
                keys = primitive["attributes"]
                corners = zip(rows(keys["POSITION"]), rows(keys["TEXCOORD_0"]))
                used = set(i for i, in rows(primitive["indices"]))
                for number, (position, (u, v)) in enumerate(corners):
                    x, z = (position[k] + node["translation"][k] for k in (0, 2))
                    if number in used:
                        self.assertAlmostEqual(u, 2 * x, delta=1e-5)
                        self.assertAlmostEqual(v, z, delta=1e-5)
        self.cut("--format", "gltf")
        self.assertNotIn("pieces.glb", os.listdir(self.path("out")))

    def test_colliders_need_gltf(self):
        for arguments, words in ((["--colliders", "hull"], "only glTF holds colliders"),
                                 (["--colliders", "hull", "--format", "stl"], "only glTF holds colliders"),
                                 (["--collider-names", "godot"], "requires --colliders"),
                                 (["--single-file"], "requires --format glb, gltf or 3mf"),
                                 (["--colliders", "box", "--format", "glb"], "the values are: hull")):
            done = subprocess.run([KERF, "cut", "plate.obj", "--out", "out", *arguments], cwd=self.folder,
                                  capture_output=True, text=True, timeout=900)
            self.assertEqual(done.returncode, 2)
            self.assertIn(words, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1)

    def test_3mf_keeps_names_and_colours(self):
        report = self.cut("--format", "3mf")
        faces = sum(piece["faces"] for piece in report["pieces"])
        self.assertEqual(report["notes"][0], f"3MF holds no UVs, normals or textures: {faces} faces lose theirs")
        self.assertIn("3MF holds no Ns or odd: 2 materials lose theirs", report["notes"])
        for number, piece in enumerate(report["pieces"]):
            with zipfile.ZipFile(self.path("out/" + piece["file"])) as archive:
                model = archive.read("3D/3dmodel.model").decode()
            self.assertIn('unit="millimeter"', model)
            self.assertIn('name="left fender' + ["", ".001"][number] + '"', model)
            self.assertIn('name="red paint" displaycolor="#CC1A1A', model.replace("#cc1a1a", "#CC1A1A"))
        self.cut(mesh="out/piece-0000.3mf", out="back")
        text = self.read("back/piece-0000.obj").decode()
        self.assertIn("o left fender\n", text)
        self.assertIn("Kd 0.8 0.101", self.read("back/pieces.mtl").decode())
        points = [numbers(line.split()[1:4]) for line in text.splitlines() if line.startswith("v ")]
        self.assertAlmostEqual(max(x for x, _, _ in points), 1, delta=1e-6)

    def test_a_single_3mf_file_holds_an_object_per_piece(self):
        separate = self.cut("--format", "3mf")["pieces"]
        report = self.cut("--format", "3mf", "--single-file")
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["pieces.3mf", "report.json"])
        self.assertEqual([piece["file"] for piece in report["pieces"]], len(separate) * ["pieces.3mf"])
        self.assertEqual([piece["faces"] for piece in report["pieces"]], [piece["faces"] for piece in separate])
        with zipfile.ZipFile(self.path("out/pieces.3mf")) as archive:
            model = archive.read("3D/3dmodel.model").decode()
        self.assertIn('unit="millimeter"', model)
        objects = model.split("<object ")[1:]
        self.assertEqual([text.count("<triangle ") for text in objects], [piece["faces"] for piece in separate])
        for text, name in zip(objects, ("left fender", "left fender.001")):
            self.assertIn(f'name="{name}"', text)
            self.assertIn("pid=", text)
        self.assertEqual(model.count("<item "), len(separate))
        self.assertEqual(model.count("<base "), 2)  # shared by the pieces
        ids = re.findall('UUID="([^"]*)"', model)
        self.assertEqual(len(set(ids)), len(ids))
        first = self.read("out/pieces.3mf")
        self.cut("--format", "3mf", "--single-file")
        self.assertEqual(self.read("out/pieces.3mf"), first)
        self.cut(mesh="out/pieces.3mf", out="back")
        text = self.read("back/piece-0000.obj").decode()
        self.assertIn("o left fender", text)

    def test_custom_attributes_and_tangents_are_kept(self):
        rows = "\n".join(f"{x} 0 {z} {3 * x} 7" for x, z in self.points)
        faces = "\n".join("3 " + " ".join(str(v - 1) for v in face) for face in self.faces)
        self.write("plate.ply", "ply\nformat ascii 1.0\nelement vertex " + str(len(self.points)) +
                   "\nproperty double x\nproperty double y\nproperty double z\nproperty float quality\nproperty int label\n" +
                   f"element face {len(self.faces)}\nproperty list uchar int vertex_indices\nend_header\n{rows}\n{faces}\n")
        report = self.cut("--format", "glb", mesh="plate.ply")
        self.assertEqual(report["notes"], [])
        for piece in report["pieces"]:
            gltf, read = self.gltf_of("out/" + piece["file"])
            attributes = gltf["meshes"][0]["primitives"][0]["attributes"]
            middle = gltf["nodes"][0]["translation"]
            for position, (quality,), (label,) in zip(*(read(attributes[key]) for key in ("POSITION", "_quality", "_label"))):
                self.assertAlmostEqual(quality, 3 * (position[0] + middle[0]), delta=1e-5)
                self.assertAlmostEqual(label, 7, delta=1e-5)
        report = self.cut("--format", "obj", mesh="plate.ply")
        faces = sum(piece["faces"] for piece in report["pieces"])
        self.assertEqual(report["notes"], [f"OBJ holds no attribute 'quality' or attribute 'label': {faces} faces lose theirs"])
        done = subprocess.run([KERF, "info", "plate.ply"], cwd=self.folder, capture_output=True, text=True, timeout=900)
        self.assertEqual(json.loads(done.stdout)["looks"]["attributes"], ["quality", "label"])

    def test_each_format_reports_its_losses(self):
        for form, lost in (("stl", "UVs, normals, materials"), ("off", "UVs, normals, materials"), ("ply", "materials")):
            report = self.cut("--format", form)
            faces = sum(piece["faces"] for piece in report["pieces"])
            note = report["notes"][-1]
            self.assertRegex(note, f"no {lost} or textures: {faces} faces lose theirs")
            self.assertIn(note, self.messages)

    def test_ply_keeps_uvs_and_normals(self):
        self.cut("--format", "ply")
        self.cut(mesh="out/piece-0000.ply", out="back")
        self.assert_linear(self.read("back/piece-0000.obj").decode())

    def test_prepare_keeps_looks(self):
        subprocess.run([KERF, "prepare", "plate.obj", "--subdivide", "midpoint", "--simplify", "200", "--out", "made.obj"],
                       cwd=self.folder, check=True, capture_output=True)
        self.assert_linear(self.read("made.obj").decode())
        self.assertIn(b"map_Kd", self.read("made.mtl"))

    def test_prepare_notes_names_that_are_not_written(self):
        def messages(mesh, out):
            done = subprocess.run([KERF, "prepare", mesh, "--subdivide", "midpoint", "--out", out], cwd=self.folder, check=True,
                                  capture_output=True, text=True)
            return done.stderr

        for form in ("stl", "ply", "off"):
            self.assertIn("the name of the part is not written", messages("plate.obj", "made." + form))
        for form in ("obj", "gltf"):
            self.assertNotIn("not written", messages("plate.obj", "made." + form))
        gltf = json.loads(self.read("made.gltf"))
        gltf["nodes"] = [{"mesh": 0}, {"mesh": 0, "translation": [2, 0, 0]}]
        gltf["scenes"] = [{"nodes": [0, 1]}]
        gltf["meshes"][0].pop("name", None)
        self.write("two.gltf", json.dumps(gltf))
        self.assertNotIn("not written", messages("two.gltf", "made.stl"))

    def test_walls_get_the_requested_material(self):
        corners = [(x, y, z) for x in (0, 1) for y in (0, 0.3) for z in (0, 1)]
        quads = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
        self.write("box.obj", "mtllib plate.mtl\nusemtl bare\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in corners) +
                   "".join("f " + " ".join(map(str, quad)) + "\n" for quad in quads))
        for name in ("foam", "bare"):
            self.cut("--solid", "--cut-material", name, "--journal", "cut.kerf", mesh="box.obj")
            self.assertEqual(set(re.findall("usemtl (.*)", self.read("out/piece-0000.obj").decode())), {"bare", name})
            self.assertIn(f'"cut_material":"{name}"', self.read("cut.kerf").decode().replace(" ", ""))
        done = subprocess.run([KERF, "cut", "box.obj", "--path", "cut.json", "--out", "o", "--cut-material", ""],
                              cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--cut-material", done.stderr)

    def test_a_missing_image_is_named(self):
        os.remove(self.path("paint.png"))
        report = self.cut()
        self.assertEqual(report["notes"], ["The image 'paint.png' is not in the folder of this file."])
        self.assertIn("map_Kd -s 1 1 1 paint.png\n", self.read("out/pieces.mtl").decode())

    def test_walls_of_solids_have_normals_and_uvs(self):
        corners = [(x, y, z) for x in (0, 1) for y in (0, 0.3) for z in (0, 1)]
        quads = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
        self.write("box.obj", "mtllib plate.mtl\nusemtl red paint\nvt 0 0\n" +
                   "".join(f"v {x} {y} {z}\n" for x, y, z in corners) +
                   "".join("f " + " ".join(f"{v}/1" for v in quad) + "\n" for quad in quads))
        report = self.cut("--solid", "--format", "glb", mesh="box.obj")
        self.assertTrue(all(piece["closed"] for piece in report["pieces"]))
        self.cut(mesh="out/piece-0000.glb", out="back")
        subprocess.run([KERF, "prepare", "box.obj", "--subdivide", "midpoint", "--out", "box.glb"], cwd=self.folder, check=True,
                       capture_output=True)
        self.cut("--solid", mesh="box.glb", out="from-glb")
        for folder in ("back", "from-glb"):
            faces = read_obj(self.read(folder + "/piece-0000.obj").decode())
            walls = [face for material, face in faces if material == "cut"]
            self.assertTrue(walls)
            areas = []  # in the UVs, twice; negative where an image is mirrored
            for face in walls:
                self.assertTrue(all(abs(sum(k * k for k in normal) - 1) < 1e-3 for _, _, normal in face))
                (p, s, _), (q, t, _), (_, u, _) = face
                self.assertAlmostEqual(sum((a - b) ** 2 for a, b in zip(p, q)), sum((a - b) ** 2 for a, b in zip(s, t)),
                                       delta=1e-5)
                areas.append((t[0] - s[0]) * (u[1] - s[1]) - (t[1] - s[1]) * (u[0] - s[0]))
            self.assertGreater(min(areas), -1e-6, folder)
            self.assertGreater(sum(areas), 1e-3, folder)

    def test_provenance_refers_to_the_source(self):
        for form in ("obj", "glb"):
            report = self.cut("--provenance", "from.npz", "--format", form, "--rim", "smooth")
            arrays = read_npz(self.path("from.npz"))
            total = sum(piece["faces"] for piece in report["pieces"])
            self.assertEqual({name: shape for name, (shape, _) in arrays.items()},
                             {"source_face": (total,), "source_barycentrics": (total, 3, 3), "source_mesh": (total,),
                              "piece": (total,)})
            if form == "glb":
                continue
            written = [face for piece in report["pieces"] for _, face in read_obj(self.read("out/" + piece["file"]).decode())]
            weights = arrays["source_barycentrics"][1]
            for f, face in enumerate(written):
                source = self.faces[arrays["source_face"][1][f]]
                for c, (position, _, _) in enumerate(face):
                    w = weights[9 * f + 3 * c:9 * f + 3 * c + 3]
                    for axis, k in ((0, 0), (2, 1)):
                        value = sum(w[i] * self.points[source[i] - 1][k] for i in range(3))
                        self.assertAlmostEqual(value, position[axis], delta=1e-9)
        self.assertEqual(set(arrays["source_mesh"][1]), {0})
        done = subprocess.run([KERF, "cut", "plate.obj", "--path", "cut.json", "--out", "out", "--provenance", "plate.mtl/x"],
                              cwd=self.folder, capture_output=True, text=True, timeout=900)
        self.assertEqual(done.returncode, 1, done.stderr)

    def test_provenance_is_refused_only_if_a_shell_was_turned(self):
        def box(size, at, first):
            corners = [(x, y, z) for x in (at, at + size) for y in (at, at + size) for z in (at, at + size)]
            quads = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
            return "".join(f"v {x} {y} {z}\n" for x, y, z in corners) + \
                   "".join("f " + " ".join(str(first + v) for v in quad) + "\n" for quad in quads)

        def turn(mesh, out):
            return subprocess.run([KERF, "cut", mesh, "--turn-shells", "--provenance", "from.npz", "--out", out],
                                  cwd=self.folder, capture_output=True, text=True, timeout=900)

        self.write("one.obj", box(3, 0, 0))
        self.write("two.obj", box(3, 0, 0) + box(1, 1, 8))
        done = turn("one.obj", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(read_npz(self.path("from.npz"))["source_face"][0], (12,))
        done = turn("two.obj", "other")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("--provenance: --turn-shells has turned shells; turn them first with kerf prepare", done.stderr)
        self.assertFalse(os.path.exists(self.path("other")))

    def test_info_lists_looks(self):
        done = subprocess.run([KERF, "info", "plate.obj"], cwd=self.folder, capture_output=True, text=True, timeout=900)
        self.assertEqual(json.loads(done.stdout)["looks"],
                         {"uv_sets": 1, "normals": True, "vertex_colours": False, "materials": ["bare", "red paint"],
                          "images": [{"name": "paint.png", "bytes": len(IMAGE)}], "parts": 1})


if __name__ == "__main__":
    unittest.main()
