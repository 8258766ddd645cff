"""What commands write: an output folder tells of one run, and no input is overwritten. `outputs_test.py KERF`."""
import glob
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

KERF = os.path.abspath(sys.argv.pop(1))
PLATE = "v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0 0.5\nv -0.5 0 0.5\nf 1 4 3\nf 1 3 2\n"


def stroke(x):
    return {"laser": {"radius": 0.02, "range": [0, 5]},
            "keys": [{"t": 0, "origin": [x, 1, -0.7], "direction": [0, -1, 0]},
                     {"t": 1, "origin": [x, 1, 0.7], "direction": [0, -1, 0]}]}


class Outputs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write("plate.obj", PLATE)
        self.write("thrice.json", json.dumps({"strokes": [stroke(-0.2), stroke(0), stroke(0.2)]}))
        self.write("once.json", json.dumps({"strokes": [stroke(0.1)]}))

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def kerf(self, *args, limit="true"):
        command = ["bash", "-c", limit + '; exec "$@"', "kerf", KERF, *args]
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=900)

    def cut(self, *args):
        done = self.kerf("cut", *args)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def files(self, folder="out"):
        return sorted(os.listdir(self.path(folder)))

    def assert_one_run(self, *others):
        listed = [piece["file"] for piece in json.loads(self.read("out/report.json"))["pieces"]]
        self.assertEqual(self.files(), sorted([*listed, "report.json", *others]))

    def assert_refused_and_unchanged(self, args, *words):
        before = {name: self.read(name) for name in glob.glob("**", root_dir=self.folder, recursive=True)
                  if os.path.isfile(self.path(name))}
        done = self.kerf(*args)
        self.assertEqual(done.returncode, 2, (args, done.stderr))
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        for name, content in before.items():
            self.assertEqual(self.read(name), content, name)

    def test_a_folder_describes_only_its_last_run_and_keeps_foreign_files(self):
        self.cut("plate.obj", "--path", "thrice.json", "--out", "out")
        self.write("out/mine.txt", "mine")
        self.write("out/piece-0009.obj", "mine too: no report lists it")
        others = ["mine.txt", "piece-0009.obj"]
        for options in (["--path", "once.json"], ["--format", "ply"], ["--path", "thrice.json", "--format", "stl"], []):
            self.cut("plate.obj", "--out", "out", *options)
            self.assert_one_run(*others)

    def test_only_piece_files_are_removed_whatever_a_report_lists(self):
        os.mkdir(self.path("out"))
        names = ["../plate.obj", "mine.txt", "piece-1.obj", "piece-0001", "piece-0001.obj~", "piece-00a1.obj", "report.json"]
        for name in ("mine.txt", "piece-1.obj", "piece-0001", "piece-0001.obj~", "piece-00a1.obj"):
            self.write("out/" + name, "mine")
        self.write("out/report.json", json.dumps({"pieces": [{"file": name} for name in names] + [7, {"file": 8}]}))
        self.cut("plate.obj", "--out", "out")
        self.assert_one_run("mine.txt", "piece-1.obj", "piece-0001", "piece-0001.obj~", "piece-00a1.obj")
        self.assertEqual(self.read("plate.obj").decode(), PLATE)

    def test_a_failed_run_writes_no_report_and_the_next_run_cleans_up_after_both(self):
        self.write("fine.json", json.dumps({"strokes": [{**stroke(0), "laser": {"radius": 0.01}}]}))
        self.cut("plate.obj", "--path", "thrice.json", "--out", "out", "--depth", "1")
        pieces = self.files()
        # A piece of the fine cut is larger than a file may be, as on a full disk.
        done = self.kerf("cut", "plate.obj", "--path", "fine.json", "--target-edge", "0.001", "--out", "out",
                         limit="ulimit -f 20")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertNotIn("report.json", self.files())
        self.assertEqual([name for name in self.files() if name.startswith("piece-")], pieces[:-1])
        self.cut("plate.obj", "--out", "out")
        self.assert_one_run()

    def test_a_failed_run_leaves_no_outlines(self):
        rows = 60
        corners = "".join(f"v {x} 0 {y}\n" for y in range(rows) for x in range(rows))
        faces = "".join(f"f {a} {a + rows} {a + rows + 1} {a + 1}\n" for y in range(rows - 1)
                        for a in range(y * rows + 1, y * rows + rows))
        self.write("grid.obj", corners + faces)
        for options in ([], ["--format", "glb", "--single-file"]):
            cut = ["cut", "grid.obj", "--out", "out", "--outlines", "svg", *options]
            done = self.kerf(*cut, limit="ulimit -f 20")  # less than a piece, more than its outline
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertEqual(self.files(), [])
            self.cut(*cut[1:])
            self.assertIn("piece-0000.svg", self.files())
            shutil.rmtree(self.path("out"))

    def test_a_mesh_in_the_output_folder_is_rejected_as_input(self):
        self.cut("plate.obj", "--path", "once.json", "--out", "out")
        for options in ([], ["--format", "ply"], ["--journal", "out.kerf"]):
            self.assert_refused_and_unchanged(["cut", "out/piece-0000.obj", "--out", "out", *options], "--out", "input")
        os.remove(self.path("out/report.json"))
        self.cut("out/piece-0000.obj", "--out", "out", "--format", "ply")

    def test_an_input_is_identified_by_its_file_not_its_name(self):
        os.mkdir(self.path("out"))
        for make in (os.symlink, os.link):
            make(self.path("plate.obj"), self.path("out/piece-0000.obj"))
            self.assert_refused_and_unchanged(["cut", "plate.obj", "--out", "out"], "plate.obj")
            os.remove(self.path("out/piece-0000.obj"))
            make(self.path("plate.obj"), self.path("j.kerf"))
            self.assert_refused_and_unchanged(["cut", "plate.obj", "--out", "out", "--journal", "j.kerf"], "--journal")
            os.remove(self.path("j.kerf"))
        self.assert_refused_and_unchanged(["cut", "plate.obj", "--out", "out", "--journal", "out/../plate.obj"], "--journal")

    def test_no_command_overwrites_what_it_reads(self):
        self.write("scene.json", json.dumps({"bodies": [{"mesh": "plate.obj"}]}))
        self.write("set.json", "{}")
        self.cut("plate.obj", "--path", "once.json", "--out", "other", "--journal", "j.kerf")
        cut = ["cut", "scene.json", "--path", "once.json", "--settings", "set.json", "--out", "out", "--journal"]
        for name in ("plate.obj", "scene.json", "once.json", "set.json"):
            self.assert_refused_and_unchanged([*cut, name], "--journal", name)
        for name in ("out/report.json", "out/piece-0001.obj", "./out/piece-12345.ply"):
            self.assert_refused_and_unchanged([*cut, name], "--journal", name)
        self.assert_refused_and_unchanged(["prepare", "plate.obj", "--smooth", "1", "--out", "plate.obj"], "--out")
        os.mkdir(self.path("again"))
        os.symlink(self.path("plate.obj"), self.path("again/piece-0000.obj"))
        self.assert_refused_and_unchanged(["replay", "j.kerf", "--out", "again"], "--out", "plate.obj")
        os.symlink(self.path("j.kerf"), self.path("again/frame-00000.png"))
        self.assert_refused_and_unchanged(["replay", "j.kerf", "--frames", "again"], "--frames", "j.kerf")
        for name, file in (("plate.obj", "plate.obj"), ("scene.json", "plate.obj"), ("j.kerf", "plate.obj"), ("j.kerf", "j.kerf")):
            os.symlink(self.path(file), self.path("p.png"))
            self.assert_refused_and_unchanged(["render", name, "--out", "p.png"], "--out", file)
            self.assert_refused_and_unchanged([name, "--report", file], "--report", file)
            os.remove(self.path("p.png"))

    def test_material_libraries_and_their_images_are_inputs(self):
        self.write("look.obj", 'mtllib look.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n')
        self.write("look.mtl", "newmtl a\nmap_Kd look.png\n")
        self.write("look.png", "not an image")
        self.write("paint.png", "not an image")
        self.write("look.ply", "ply\nformat ascii 1.0\ncomment TextureFile paint.png\nelement vertex 3\nproperty float x\n"
                   "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                   "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        self.assert_refused_and_unchanged(["render", "look.obj", "--out", "look.png"], "--out", "look.png")
        self.assert_refused_and_unchanged(["render", "look.ply", "--out", "paint.png"], "--out", "paint.png")
        self.assert_refused_and_unchanged(["cut", "look.ply", "--out", "out", "--journal", "paint.png"], "--journal", "paint.png")
        for name in ("look.mtl", "look.png"):
            self.assert_refused_and_unchanged(["cut", "look.obj", "--plane", "1,0,0,0.5", "--out", "out", "--journal", name],
                                              "--journal", name)

    def test_a_match_recording_does_not_overwrite_its_rules(self):
        rules = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "assets")
        shutil.copytree(rules, self.path("assets"), ignore=shutil.ignore_patterns("pictures", "shaders", "*.py"))
        play = ["play", "assets/games/trial.json", "--headless", "--driver", "still", "--seconds", "1"]
        for file in ("assets/games/trial.json", "assets/arenas/yard.json", "assets/meshes/yard.obj"):
            for option in ("--report", "--record"):
                self.assert_refused_and_unchanged([*play, option, file], option, file)

    def test_a_report_does_not_replace_the_recording_of_its_match(self):
        self.write("m.kerf", "an earlier match")
        os.symlink("m.kerf", self.path("link.kerf"))
        for record in ("m.kerf", "./m.kerf", "link.kerf"):
            self.assert_refused_and_unchanged(["play", "--headless", "--report", "m.kerf", "--record", record], "--report", "--record")

    def test_a_match_is_recorded_if_its_report_cannot_be_written(self):
        os.mkdir(self.path("folder"))
        done = self.kerf("play", "--headless", "--driver", "still", "--seconds", "0.1", "--report", "folder", "--record", "m.kerf")
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
        self.assertIn("cannot write folder", done.stderr)
        self.assertEqual(self.kerf("replay", "m.kerf").returncode, 0)

    def test_an_unwritable_recording_is_reported_before_the_match(self):
        os.mkdir(self.path("folder"))
        done = self.kerf("play", "--headless", "--driver", "still", "--seconds", "0.1", "--report", "r.json", "--record", "folder")
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
        self.assertIn("cannot write folder", done.stderr)
        self.assertFalse(os.path.exists(self.path("r.json")))

    def test_buffers_of_a_gltf_file_count_as_inputs(self):
        self.cut("plate.obj", "--format", "gltf", "--out", "g")
        gltf = json.loads(self.read("g/piece-0000.gltf"))
        self.write("a b.bin", "x")
        gltf["buffers"][0]["uri"] = "a%20b.bin"
        self.write("g.gltf", json.dumps(gltf))
        self.assert_refused_and_unchanged(["cut", "g.gltf", "--out", "out", "--journal", "a b.bin"], "--journal", "a b.bin")

    def test_an_unwritable_journal_is_reported_before_the_cut(self):
        os.mkdir(self.path("folder"))
        for journal in ("/dev/full", "folder", "nowhere/j.kerf"):
            done = self.kerf("cut", "plate.obj", "--path", "once.json", "--out", "out", "--journal", journal)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(journal, done.stderr)
            self.assertFalse(os.path.exists(self.path("out")))

    def test_an_unwritable_provenance_is_reported_before_the_cut(self):
        self.cut("plate.obj", "--path", "thrice.json", "--out", "out")
        os.mkdir(self.path("folder"))
        for name, why in (("nowhere/p.npz", "there is no folder"), ("folder", "Is a directory"), ("folder/", "Is a directory")):
            done = self.kerf("cut", "plate.obj", "--path", "once.json", "--out", "out", "--provenance", name)
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
            self.assertIn(f"cannot write {name}: {why}", done.stderr)
            self.assert_one_run()
        self.cut("plate.obj", "--path", "once.json", "--out", "new", "--provenance", "new/p.npz")
        self.assertIn("p.npz", self.files("new"))

    def test_a_journal_may_lie_in_the_new_folder_of_the_pieces(self):
        for out in ("out", "more/out/"):
            journal = os.path.join(out, "cut.kerf")
            self.cut("plate.obj", "--path", "once.json", "--out", out, "--journal", journal)
            self.assertIn("cut.kerf", self.files(out))
            done = self.kerf("replay", journal)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_refused_and_unchanged(["cut", "plate.obj", "--out", "new/", "--journal", "new/report.json"], "--journal")
        self.assertFalse(os.path.exists(self.path("new")))

    def test_results_that_cannot_be_written_are_a_failure(self):
        self.cut("plate.obj", "--path", "once.json", "--out", "out", "--journal", "j.kerf")
        for args in (["replay", "j.kerf"], ["info", "plate.obj"], ["materials"], ["inspect", "plate.obj", "--tree"],
                     ["compare", "plate.obj", "plate.obj"], ["--version"], ["help"], ["cut", "--help"]):
            done = self.kerf(*args, limit="exec >/dev/full")
            self.assertEqual((done.returncode, done.stderr), (1, "kerf: cannot write to standard output\n"), args)

    def test_closed_standard_streams_do_not_reach_files(self):
        cut = ["cut", "plate.obj", "--path", "once.json", "--model", "thermal", "--depth", "1", "--out", "out", "--journal"]
        self.cut(*cut[1:], "j.kerf")
        done = self.kerf(*cut, "k.kerf", limit="exec 2>&-")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(self.read("k.kerf"), self.read("j.kerf"))
        self.assertEqual(self.kerf("replay", "k.kerf", limit="exec >&-").returncode, 1)

    def test_an_incomplete_journal_does_not_affect_pieces(self):
        strokes = [stroke(-0.4 + 0.001 * (i % 800)) for i in range(400)]
        self.write("many.json", json.dumps({"strokes": strokes}))
        self.write("j.kerf", "what was there\n")
        done = self.kerf("cut", "plate.obj", "--path", "many.json", "--depth", "0", "--out", "out", "--journal", "j.kerf",
                         limit="ulimit -f 100")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("cannot write j.kerf", done.stderr)
        self.assert_one_run()
        self.assertEqual(self.read("j.kerf"), b"what was there\n")
        self.assertEqual([name for name in os.listdir(self.folder) if name.endswith(".tmp")], [])

    def test_names_that_are_not_utf_8_are_replaced_in_the_report(self):
        name = b"teil_\xfc.obj"
        os.rename(self.path("plate.obj"), os.path.join(os.fsencode(self.folder), name))
        done = subprocess.run([KERF, "cut", name, "--path", "once.json", "--out", "out"], cwd=self.folder,
                              capture_output=True, timeout=900)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("teil_\ufffd.obj", json.loads(self.read("out/report.json"))["command"])

    def test_the_report_of_a_replay_counts_what_lasts(self):
        for model in ([], ["--model", "thermal", "--thickness", "0.001"]):
            self.cut("plate.obj", "--path", "once.json", "--journal", "once.kerf", "--out", "once", *model)
            head, *rest = self.read("once.kerf").decode().splitlines()
            commands = [line for line in rest if '"hash"' not in line[:8]]
            undo, redo = '{"do": "undo"}', '{"do": "redo"}'
            # A mark makes the replay execute a stroke that is undone next.
            for name, lines in (("undone", [*rest, undo, *commands]), ("redone", [*commands, undo, redo]),
                                ("replaced", [*commands, undo, redo, undo, *commands])):
                self.write(name + ".kerf", "\n".join([head, *lines]) + "\n")
                done = self.kerf("replay", name + ".kerf", "--out", "again")
                self.assertEqual(done.returncode, 0, done.stderr)
                once, again = (json.loads(self.read(folder + "/report.json")) for folder in ("once", "again"))
                self.assertEqual(again["removed"], once["removed"], name)
                for key in ("energy_j", "depth_fraction"):
                    self.assertEqual(key in again, key in once, key)
                self.assertEqual(("uncut" in once, "uncut" in again), (bool(model), False))

    def test_a_thermal_stroke_without_a_duration_is_reported(self):
        still = stroke(0)
        still["keys"] = still["keys"][:1]
        still["keys"][0]["origin"][2] = 0
        self.write("still.json", json.dumps({"strokes": [still]}))
        self.cut("plate.obj", "--path", "still.json", "--out", "out", "--model", "thermal", "--thickness", "0.001")
        report = json.loads(self.read("out/report.json"))
        self.assertEqual(report["missed"], [])
        self.assertTrue(any("lasts no time" in note for note in report["notes"]), report["notes"])

if __name__ == "__main__":
    unittest.main()
