"""What Kerf does where the machine has less than it wants: `limits_test.py KERF`. Each shortage ends with one sentence,
and nothing is lost. Cuts are equal to the byte in every environment."""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

KERF = os.path.abspath(sys.argv.pop(1))
ASSETS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "assets")
SPHERE = os.path.join(ASSETS, "meshes", "sphere.obj")
ACROSS = {"strokes": [{"laser": {"radius": 0.02, "range": [0, 5]},
                       "keys": [{"t": 0, "origin": [-1.2, 0.01, 3], "direction": [0, 0, -1]},
                                {"t": 1, "origin": [1.2, 0.02, 3], "direction": [0, 0, -1]}]}]}
SANITIZED = "KERF_TEST_SANITIZED" in os.environ  # whose shadow memory no limit leaves room for


class Limits(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        with open(os.path.join(self.folder, "across.json"), "w") as file:
            json.dump(ACROSS, file)

    def run_kerf(self, *arguments, without=(), limit="true", folder="", **more):
        environment = {name: value for name, value in os.environ.items()
                       if name not in ("DISPLAY", "WAYLAND_DISPLAY", *without)}
        environment.update(more)
        command = ["bash", "-c", limit + '; exec "$@"', "kerf", KERF, *map(str, arguments)]
        return subprocess.run(command, cwd=folder or self.folder, env=environment, capture_output=True, text=True,
                              timeout=900)

    def assert_one_sentence(self, done, *words, status=1):
        self.assertEqual(done.returncode, status, done.stderr)
        said = [line for line in done.stderr.splitlines() if line and not line.startswith("libEGL warning")]
        self.assertEqual(len(said), 1, done.stderr)
        self.assertTrue(said[0].startswith("kerf: "), done.stderr)
        for word in words:
            self.assertIn(word, said[0])

    @unittest.skipIf(SANITIZED, "the sanitizers want more address space")
    def test_a_stroke_beyond_the_memory_limit_fails_and_keeps_existing_files(self):
        os.mkdir(os.path.join(self.folder, "out"))
        kept = os.path.join(self.folder, "out", "piece-0000.obj")
        with open(kept, "w") as file:
            file.write("old\n")
        fine = ("cut", SPHERE, "--path", "across.json", "--out", "out", "--target-edge", "0.00005")
        done = self.run_kerf(*fine, limit="ulimit -v 300000", KERF_THREADS="1")
        self.assert_one_sentence(done, "memory", "coarser resolution")
        with open(kept) as file:
            self.assertEqual(file.read(), "old\n")
        self.assertEqual(os.listdir(os.path.join(self.folder, "out")), ["piece-0000.obj"])

    @unittest.skipIf(SANITIZED, "the sanitizers want more address space")
    def test_a_mesh_beyond_the_memory_limit_is_rejected(self):
        large = os.path.join(self.folder, "large.obj")
        finer = SPHERE
        for name in ("a.obj", "b.obj", "c.obj", "large.obj"):
            made = self.run_kerf("prepare", finer, "--subdivide", "midpoint", "--out", name)
            self.assertEqual(made.returncode, 0, made.stderr)
            finer = name
        done = self.run_kerf("cut", large, "--out", "out", limit="ulimit -v 160000", KERF_THREADS="1")
        self.assert_one_sentence(done, "large.obj", "memory")

    def test_a_mesh_whose_squared_lengths_overflow_is_rejected(self):
        for name, width in (("wide.obj", "1e160"), ("wider.obj", "1.7e308")):
            with open(os.path.join(self.folder, name), "w") as file:
                file.write(f"v -{width} 0 0\nv {width} 0 0\nv 0 0 {width}\nf 1 2 3\n")
            with open(os.path.join(self.folder, "scene.json"), "w") as file:
                json.dump({"bodies": [{"mesh": name}]}, file)
            for arguments in (("info", name), ("cut", name, "--path", "across.json", "--out", "out"),
                              ("cut", "scene.json", "--path", "across.json", "--out", "out"),
                              ("prepare", name, "--subdivide", "midpoint", "--out", "out.obj")):
                with self.subTest(arguments):
                    self.assert_one_sentence(self.run_kerf(*arguments), name, "is wider than 1e150 m", status=2)

    def test_areas_of_meshes_of_any_size_are_finite(self):
        for length in ("e80", "e140", "e-100", "e-140"):
            with open(os.path.join(self.folder, "odd.obj"), "w") as file:
                file.write(f"v 0 0 0\nv 3{length} 0 0\nv 0 0 4{length}\nf 1 2 3\n")
            done = self.run_kerf("info", "odd.obj")
            self.assertEqual(done.returncode, 0, done.stderr)
            info = json.loads(done.stdout)
            self.assertAlmostEqual(info["area"] / float("1" + length) / float("1" + length), 6)
            self.assertEqual(info["repairs"]["zero_area_faces"], 0)

    def test_the_memory_limit_is_not_recorded(self):
        done = self.run_kerf("cut", SPHERE, "--path", "across.json", "--out", "out", "--journal", "out.kerf")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.folder, "out.kerf")) as file:
            self.assertNotIn("most-faces", file.read())

    def assert_equal_cut(self, what, **settings):
        """Cuts in an environment; report and files have the bytes of all other environments."""
        folder = os.path.join(self.folder, what)
        os.makedirs(folder)
        os.chmod(folder, 0o777)
        shutil.copy(SPHERE, folder)
        shutil.copy(os.path.join(self.folder, "across.json"), folder)
        done = self.run_kerf("cut", "sphere.obj", "--path", "across.json", "--out", "out", "--journal", "out.kerf",
                             folder=folder, **settings)
        self.assertEqual(done.returncode, 0, f"{what}: {done.stderr}")
        files = {}
        for name in ("out/report.json", "out/piece-0000.obj", "out.kerf"):
            with open(os.path.join(folder, name), "rb") as file:
                files[name] = file.read()
        report = json.loads(files.pop("out/report.json"))
        files["state_hash"], files["summary"] = report["state_hash"], done.stdout + done.stderr
        self.files = getattr(self, "files", files)
        for name, content in files.items():
            self.assertEqual(content, self.files[name], f"{what}: {name}")

    def test_cuts_are_equal_in_every_environment(self):
        self.assert_equal_cut("plain surroundings")
        self.assert_equal_cut("one core", limit=f"taskset -cp {min(os.sched_getaffinity(0))} $$ >/dev/null")
        self.assert_equal_cut("many threads", KERF_THREADS="64")
        for lanes in ("plain", "sse4", "avx2"):
            self.assert_equal_cut(lanes, KERF_SIMD=lanes)
        self.assert_equal_cut("a zone ahead", TZ="LINT-14")
        self.assert_equal_cut("a zone behind", TZ="AOE12")
        self.assert_equal_cut("Übung İı 刀 'quoted' $HOME", limit="umask 077")
        nobody = "setpriv --reuid=65534 --regid=65534 --clear-groups"
        if subprocess.run(["bash", "-c", f"{nobody} test -x '{KERF}'"], capture_output=True).returncode == 0:
            self.assert_equal_cut("another user", limit=f'set -- {nobody} "$@"')

    @unittest.skipUnless(os.path.exists("/usr/share/i18n/locales/tr_TR"), "needs the package locales")
    def test_cuts_are_equal_in_every_locale(self):
        self.assert_equal_cut("no locale", LC_ALL="C")
        for locale in ("de_DE", "tr_TR", "fr_FR", "ar_EG", "hi_IN"):
            subprocess.run(["localedef", "-c", "-i", locale, "-f", "UTF-8", os.path.join(self.folder, locale)],
                           check=True, capture_output=True)
            self.assert_equal_cut(f"as {locale}", LOCPATH=self.folder, LC_ALL=locale, LANGUAGE=locale[:2])

    def test_a_full_disk_is_reported_and_leaves_no_files(self):
        full = "mkdir small && mount -t tmpfs -o size=64k none small && " + \
            "trap 'find small -type f | wc -l >left' EXIT; \"$@\"; exit $?"
        done = subprocess.run(["unshare", "-rm", "bash", "-c", full, "kerf", KERF, "cut", SPHERE, "--path",
                               "across.json", "--out", "small/out"],
                              cwd=self.folder, capture_output=True, text=True, timeout=900)
        if "unshare" in done.stderr or "mount" in done.stderr:
            self.skipTest("needs user namespaces")
        self.assert_one_sentence(done, "No space left on device")
        with open(os.path.join(self.folder, "left")) as file:
            self.assertEqual(file.read().strip(), "0")

    def test_cuts_and_renders_without_a_home_folder(self):
        bare = ("HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME")
        for arguments in (("cut", SPHERE, "--path", "across.json", "--out", "out"),
                          ("render", SPHERE, "--out", "a.png", "--size", "160x100")):
            done = self.run_kerf(*arguments, without=bare)
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_missing_opengl_is_reported_with_the_package_to_install(self):
        draw = ("render", SPHERE, "--out", "a.png")
        missing = {"no driver": {"LIBGL_DRIVERS_PATH": "/nonexistent"},
                   "no vendor": {"__EGL_VENDOR_LIBRARY_FILENAMES": "/dev/null"},
                   "an old version": {"MESA_GL_VERSION_OVERRIDE": "2.1"}}
        for what, settings in missing.items():
            with self.subTest(what):
                words = ["install libegl1 and libgl1-mesa-dri"] + (["3.3"] if what == "an old version" else [])
                self.assert_one_sentence(self.run_kerf(*draw, **settings), *words)
                self.assertFalse(os.path.exists(os.path.join(self.folder, "a.png")))

    def test_a_missing_display_is_reported(self):
        self.assert_one_sentence(self.run_kerf(SPHERE), "display", "kerf render")


unittest.main()
