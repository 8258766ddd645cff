"""The editor in a real window, with real input: run as `window_test.py KERF`. Needs Xvfb and xdotool."""
import json
import math
import os
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

KERF = os.path.abspath(sys.argv.pop(1))
WIDTH, HEIGHT = 1280, 800
# A build with sanitizers is several times slower; all waits are lengthened by this.
PATIENCE = float(os.environ.get("KERF_TEST_PATIENCE", "1"))
ASSETS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "assets")
ACROSS, ACROSS_ABOVE = [(0.32, 0.5), (0.68, 0.5)], [(0.32, 0.37), (0.68, 0.37)]  # strokes that cut the sphere
SPHERE = os.path.join(ASSETS, "scenes", "sphere.json")


def pause(seconds):
    time.sleep(PATIENCE * seconds)


def wait_for(met, seconds, what):
    """Until met() is true."""
    until = time.monotonic() + PATIENCE * seconds
    while not met():
        if time.monotonic() > until:
            raise AssertionError(what)
        time.sleep(0.1)


class Editor:
    """A screen of its own with one editor on it.

    A point of the window is (along, down), shares of the width and the height of the picture, or (part, along, down),
    those of a part of the window that the editor reports under this name (ui/window/landmarks.h).
    """

    def __init__(self, folder, *arguments):
        self.report_file = os.path.join(folder, "report.json")
        self.screen_file = os.path.join(folder, "Xvfb_screen0")
        self.landmarks_file = os.path.join(folder, f"landmarks-{time.monotonic_ns()}.json")
        read, write = os.pipe()
        # A server without -noreset starts anew when its last client goes, and refuses who comes meanwhile.
        self.screen = subprocess.Popen(["Xvfb", "-noreset", "-displayfd", str(write), "-fbdir", folder,
                                        "-screen", "0", f"{WIDTH}x{HEIGHT}x24"],
                                       pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            self.environment = dict(os.environ, DISPLAY=":" + pipe.readline().strip(), XDG_CONFIG_HOME=folder,
                                    XDG_STATE_HOME=folder)
        self.wait_for_screen()
        self.kerf = subprocess.Popen([KERF, *arguments, "--report", self.report_file, "--size", f"{WIDTH}x{HEIGHT}",
                                      "--landmarks", self.landmarks_file],
                                     env=self.environment, stderr=subprocess.PIPE, text=True)
        try:
            self.wait_for_window()
        except AssertionError:
            self.close()
            raise

    def xdotool(self, *arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, capture_output=True, text=True)

    def wait_for_screen(self):
        """A server that has told its number may not answer yet."""
        try:
            wait_for(lambda: self.xdotool("getdisplaygeometry").returncode == 0, 10, "the screen never answered")
        except AssertionError:
            self.screen.kill()
            self.screen.wait()
            raise

    def has_window(self):
        if self.kerf.poll() is not None:
            raise AssertionError("the editor ended: " + self.kerf.stderr.read())
        seen = self.xdotool("search", "--onlyvisible", "--name", "Kerf").stdout.strip()
        return seen and os.path.exists(self.landmarks_file)

    def wait_for_window(self):
        wait_for(self.has_window, 60, "no window came up")
        pause(1.5)

    def landmarks(self):
        with open(self.landmarks_file) as file:
            return json.load(file)

    def part(self, name):
        """The rectangle of a part of the window, x, y, width and height, once there is one that is not empty."""
        wait_for(lambda: any(self.landmarks()["parts"].get(name, [])), 60, f"the editor shows no {name!r}")
        return self.landmarks()["parts"][name]

    def place(self, point):
        """The point in pixels."""
        *part, along, down = point
        x, y, width, height = self.part(part[0] if part else "viewport")
        return round(x + along * width), round(y + down * height)

    def pixels(self):
        """What the screen shows at the moment, as a function from a place to red, green and blue."""
        with open(self.screen_file, "rb") as file:
            dump = file.read()
        header = struct.unpack(">25I", dump[:100])  # of the format of xwd
        begin, row = header[0] + 12 * header[19], header[12]
        return lambda x, y: tuple(dump[begin + row * y + 4 * x + channel] for channel in (2, 1, 0))

    def move_to(self, x, y):
        self.xdotool("mousemove", x, y)
        self.pointer = [x, y]

    def has_heard(self):
        return self.landmarks()["pointer"] == self.pointer

    def settle(self):
        """Waits until the editor has heard of the last move of the pointer and has nothing left to do."""
        pause(0.3)
        wait_for(lambda: self.has_heard() and not self.landmarks()["busy"], 240, "the editor never came to rest")

    def point_at(self, *point):
        self.move_to(*self.place(point))
        self.settle()

    def wait_for_popup(self, there):
        wait_for(lambda: ("popup" in self.landmarks()["parts"]) == there, 20, f"a popup is open: {not there}")

    def click(self, *point, button=1):
        """A press and a release that different frames hear of."""
        x, y = self.place(point)
        self.move_to(x, y)
        self.settle()
        self.xdotool("mousedown", button)
        self.move_to(x + 1, y)
        wait_for(self.has_heard, 60, "the editor never heard of the press")
        self.xdotool("mouseup", button)
        self.move_to(x, y)
        self.settle()

    def drag(self, points, button=1):
        """Moves through the points with the button down, slowly enough that a software renderer sees them."""
        self.drag_pixels([self.place(point) for point in points], button)

    def drag_pixels(self, points, button=1):
        x, y = points[0]
        self.move_to(x, y)
        self.settle()
        self.xdotool("mousedown", button)
        # A frame that sees the pointer here has heard of the press, and where it was.
        self.move_to(x + 1, y)
        wait_for(self.has_heard, 60, "the editor never heard of the press")
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            for i in range(1, 13):
                self.move_to(round(x0 + (x1 - x0) * i / 12), round(y0 + (y1 - y0) * i / 12))
                pause(0.05)
        pause(0.3)
        wait_for(self.has_heard, 60, "the editor never heard of the last move")
        self.xdotool("mouseup", button)
        pause(0.2)
        self.settle()

    def press(self, *keys):
        for key in keys:
            self.xdotool("keydown", key)
            pause(0.15)
        for key in reversed(keys):
            self.xdotool("keyup", key)
            pause(0.15)

    def do(self, *keys):
        """Presses the keys and waits until the editor has done what they ask for; the pointer was moved before."""
        self.press(*keys)
        x, y = self.pointer
        self.move_to(x + 1, y)  # seen after the keys were heard
        self.settle()

    def drop(self, *files):
        """Drags files from another program onto the middle of the picture and lets them go."""
        window = self.xdotool("search", "--onlyvisible", "--name", "Kerf").stdout.split()[0]
        source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "drag_source.py")
        x, y = self.place((0.5, 0.5))
        subprocess.run([sys.executable, source, window, str(x), str(y), *files], env=self.environment, check=True)
        pause(2)

    def quit(self):
        """Ends the editor by its own shortcut, gives up what is not saved, and returns its report."""
        self.press("ctrl", "q")
        for _ in range(10):
            try:
                self.kerf.wait(timeout=1.5 * PATIENCE)
                break
            except subprocess.TimeoutExpired:
                self.press("d")  # again where a slow picture kept the question from being there
        return self.report()

    def title(self):
        return self.xdotool("search", "--onlyvisible", "--name", "Kerf", "getwindowname").stdout.strip()

    def wait_for_title(self, title):
        wait_for(lambda: self.title() == title, 60, f"the title never was {title!r}")

    def draw_without_end(self):
        """A stroke that is running still."""
        self.point_at(0.3, 0.63)
        self.xdotool("mousedown", 1)
        for i in range(10):
            self.move_to(*self.place((0.3 + 0.02 * i, 0.63)))
            pause(0.1)

    def die(self):
        self.kerf.kill()
        self.close()

    def report(self):
        status = self.kerf.wait(timeout=30 * PATIENCE)
        errors = self.kerf.stderr.read()
        if status != 0:
            raise AssertionError(f"the editor ended with {status}: {errors}")
        with open(self.report_file) as file:
            return json.load(file)

    def close(self):
        for process in (self.kerf, self.screen):
            if process.poll() is None:
                process.kill()
            process.wait()
        self.kerf.stderr.close()


class Window(unittest.TestCase):
    def open(self, *arguments):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        editor = Editor(folder.name, *arguments)
        self.addCleanup(editor.close)
        return editor

    def test_a_drag_across_the_car_cuts_it_in_two(self):
        editor = self.open()
        editor.drag([(0.53, 0.14), (0.53, 0.93)])
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertGreater(report["faces_removed"], 100)
        self.assertGreater(report["pieces"], 1)
        self.assertGreater(report["frames"], 5)
        self.assertEqual(sorted(report["frame_ms"]), ["max", "p50", "p99"])

    def test_turning_the_view_and_stray_keys_cut_nothing(self):
        editor = self.open()
        editor.drag([(0.53, 0.5), (0.66, 0.43)], button=2)
        editor.drag([(0.53, 0.5), (0.6, 0.57)], button=3)
        editor.press("Escape")
        for key in ("f", "Home", "x", "space", "Delete"):
            editor.press(key)
        for _ in range(3):
            editor.xdotool("click", 4)
        report = editor.quit()
        self.assertEqual((report["strokes"], report["faces_removed"], report["pieces"]), (0, 0, 1))

    def test_a_slit_follows_the_pointer_also_where_it_moves_within_a_slow_frame(self):
        self.assert_slit_follows_pointer(self.open())

    def test_standard_views_come_by_keys_and_by_the_axes_and_a_slit_follows_the_pointer_in_an_orthographic_view(self):
        editor = self.open()
        editor.point_at(0.05, 0.05)
        editor.do("ctrl", "3")
        editor.do("KP_5")
        editor.click("axis X", 0.5, 0.5)
        editor.do("Home")
        self.assert_slit_follows_pointer(editor)
        editor.click("axis Z", 0.5, 0.5)
        report = editor.quit()
        self.assertEqual((report["strokes"], report["view"]["orthographic"]), (1, True))
        x, y, z = report["view"]["eye"]
        self.assertLess(max(abs(x), abs(y)), 1.5)
        self.assertGreater(z, 3)

    def assert_slit_follows_pointer(self, editor):
        """Draws a curve over the car from the bonnet to a door, all within a frame or two."""
        x, y = editor.place((0.3, 0.51))
        path = [(x + 3 * i, round(y - 35 * math.sin(i / 13))) for i in range(121)]
        editor.move_to(*path[0])
        editor.settle()
        before = editor.pixels()
        editor.xdotool("mousedown", 1)
        editor.xdotool(*(word for place in path for word in ("mousemove", *place)))
        editor.xdotool("mouseup", 1)
        editor.move_to(*editor.place((0.05, 0.05)))
        editor.settle()
        after = editor.pixels()
        missed = [p for p in path if max(abs(a - b) for a, b in zip(before(*p), after(*p))) < 12]
        self.assertLess(len(missed), 8, f"the slit is not at {missed}")

    def test_a_stroke_over_the_sky_removes_nothing(self):
        editor = self.open()
        editor.drag([(0.06, 0.07), (0.21, 0.09)])
        report = editor.quit()
        self.assertEqual(report["faces_removed"], 0)

    def test_a_broken_file_leaves_the_default_scene_and_the_editor_running(self):
        with tempfile.NamedTemporaryFile("w", suffix=".obj") as file:
            file.write("f one two three\n")
            file.flush()
            report = self.open(file.name).quit()
        self.assertGreater(report["faces"], 3000)

    def open_again(self, *arguments):
        """With the settings that the last editor left."""
        editor = Editor(self.folder, *arguments)
        self.addCleanup(editor.close)
        return editor

    def settings_file(self):
        return os.path.join(self.folder, "kerf", "settings.json")

    def settings(self):
        with open(self.settings_file()) as file:
            return json.load(file)

    def set(self, **settings):
        """Changes some of the settings that the last editor left."""
        settings = {**self.settings(), **settings}
        with open(self.settings_file(), "w") as file:
            json.dump(settings, file)

    def open_by_browser(self, editor, file):
        """Types a whole path, or a part of a name, into File > Open."""
        editor.press("ctrl", "o")
        pause(1.5)
        editor.xdotool("type", "--delay", "40", file)
        pause(1)
        editor.press("Return")
        pause(1.5)

    def test_overlays_and_the_theme_are_switched_by_keys_and_the_theme_is_remembered(self):
        editor = self.open()
        for key in ("b", "w", "g"):
            editor.press(key)
        editor.press("F9")
        pause(1)
        view = editor.quit()["view"]
        self.assertEqual([view[name] for name in ("boxes", "wire", "ghost", "normals")], [True, True, True, False])
        self.assertEqual(self.settings()["theme"], "light")

    def test_shadow_views_are_switched_by_keys_and_a_light_is_dragged(self):
        editor = self.open(SPHERE)
        for key in ("d", "e", "v", "c", "t", "x"):
            editor.press(key)
        pause(1)
        view = editor.quit()["view"]
        names = ("silhouette", "shadow_volumes", "shadow_counts", "shadow_facing", "shadow_compare")
        self.assertEqual(view["shadows"], "none")  # after all
        self.assertTrue(all(view[name] for name in names))

        settings = self.settings()
        settings["panels"]["Light"] = True
        with open(self.settings_file(), "w") as file:
            json.dump(settings, file)
        editor = self.open_again(SPHERE)
        light = editor.quit()["lights"][0]
        editor = self.open_again(SPHERE)
        x, y = editor.place(("light 0", 0.5, 0.5))
        editor.drag_pixels([(x, y), (x + 50, y + 30)])
        report = editor.quit()
        moved = report["lights"][0]
        self.assertEqual(report["strokes"], 0)
        self.assertNotEqual(moved["at"], light["at"])
        self.assertLess(abs(moved["handle"][0] - x - 50) + abs(moved["handle"][1] - y - 30), 6)

    def test_the_last_stroke_is_cut_again(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.do("r")
        report = editor.quit()
        self.assertEqual((report["recuts"], report["strokes"]), (1, 1))
        self.assertGreater(report["faces_removed"], 100)

    def test_a_stroke_among_many_faces_is_cut_again_and_again_and_all_pieces_are_shown(self):
        editor = self.open()
        editor.drag([(0.53, 0.14), (0.53, 0.93)])
        for keys in (("r",), ("r",), ("ctrl", "a"), ("h",), ("shift", "h")):
            editor.press(*keys)
            pause(4)
        report = editor.quit()
        self.assertGreater(report["faces"], 40000)
        self.assertEqual((report["recuts"], report["strokes"], report["pieces_hidden"]), (2, 1, 0))
        self.assertEqual(report["undo_depth"], 2 + 2 * report["pieces"])

    def test_a_piece_is_picked_and_hidden(self):
        editor = self.open(SPHERE)
        editor.press("k")
        editor.click(0.5, 0.53)
        editor.press("h")
        report = editor.quit()
        self.assertEqual((report["pieces_hidden"], report["pieces_chosen"], report["strokes"]), (1, 0, 0))

    def test_pieces_are_chosen_by_a_box_and_isolated(self):
        editor = self.open(SPHERE)
        editor.drag([(0.2, 0.5), (0.8, 0.5)])
        editor.xdotool("keydown", "ctrl")
        editor.drag([(0.9, 0.2), (0.1, 0.3)])  # from right to left, over the upper half alone
        editor.xdotool("keyup", "ctrl")
        editor.do("slash")
        editor.do("slash")
        report = editor.quit()
        self.assertEqual((report["pieces"], report["pieces_chosen"], report["pieces_hidden"]), (2, 1, 0))
        self.assertEqual(report["undo_depth"], 3)  # the stroke, one half hidden, and shown again

    def picture(self, editor):
        """The colours of the picture at points of a grid, once it is smooth, while the pointer is in a corner."""
        editor.point_at(0.02, 0.04)
        x, y, width, height = editor.part("viewport")
        points = [(round(x + width * i / 100), round(y + height * j / 100)) for i in range(8, 92) for j in range(8, 92)]
        last = None
        for _ in range(20):
            pixel = editor.pixels()
            now = [pixel(*point) for point in points]
            if now == last:
                break
            last = now
            pause(1.5)
        return now

    def changed(self, before, after):
        """The share of the points whose colour is another."""
        return sum(max(abs(a - b) for a, b in zip(p, q)) > 24 for p, q in zip(before, after)) / len(before)

    def test_a_piece_looks_as_before_when_it_was_hidden_and_shown_again(self):
        editor = self.open()
        editor.drag([(0.53, 0.14), (0.53, 0.93)])
        editor.press("k")
        before = self.picture(editor)
        editor.click(0.42, 0.6)
        editor.do("h")
        self.assertGreater(self.changed(before, self.picture(editor)), 0.02)
        editor.do("shift", "h")
        self.assertLess(self.changed(before, self.picture(editor)), 0.002)
        self.assertEqual(editor.quit()["pieces_hidden"], 0)

    def test_an_export_offers_its_formats_and_names_files_after_pieces(self):
        self.open(SPHERE).quit()
        self.set(folder=self.folder)
        editor = self.open_again(SPHERE)
        editor.point_at(0.5, 0.5)
        editor.do("ctrl", "a")
        editor.do("ctrl", "e")
        editor.click("format PLY", 0.3, 0.5)
        editor.press("Return")
        wait_for(lambda: os.path.exists(os.path.join(self.folder, "sphere.ply")), 20, "no file was written")
        editor.quit()

    def test_a_mesh_file_is_shown_as_guessed_and_the_question_about_it_holds_nothing_up(self):
        cut = [KERF, "cut", os.path.join(ASSETS, "meshes", "plate.obj"), "--format", "stl", "--out"]
        pieces = tempfile.TemporaryDirectory()
        self.addCleanup(pieces.cleanup)
        subprocess.run([*cut, pieces.name], check=True, capture_output=True)
        plate, = (os.path.join(pieces.name, name) for name in os.listdir(pieces.name) if name.endswith(".stl"))
        editor = self.open(plate)
        editor.part("up axis")
        editor.drag(ACROSS)
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertEqual(report["view"]["frame"]["unit"], "m")
        self.assertEqual(self.settings()["frames"], {})
        editor = self.open_again(plate)
        editor.click("frame for all", 0.5, 0.5)
        frame = editor.quit()["view"]["frame"]
        self.assertEqual(self.settings()["frames"], {"stl": frame})

    def test_a_good_file_opens_and_a_broken_one_changes_nothing(self):
        editor = self.open()
        self.open_by_browser(editor, SPHERE)
        broken = os.path.join(self.folder, "broken.obj")
        with open(broken, "w") as file:
            file.write("f one two three\n")
        self.open_by_browser(editor, broken)
        report = editor.quit()
        self.assertEqual(report["files"], [os.path.basename(SPHERE)])
        self.assertIn("broken.obj", report["message"])
        self.assertEqual(self.settings()["recent"], [os.path.realpath(SPHERE)])

    def test_dropped_files_open_together_and_a_broken_one_neither_changes_anything_nor_keeps_others_out(self):
        editor = self.open()
        bracket, plate = (os.path.join(ASSETS, "meshes", name) for name in ("bracket.obj", "plate.obj"))
        broken = os.path.join(self.folder, "not a mesh.stl")
        with open(broken, "w") as file:
            file.write("solid nothing\nfacet normal none\n")
        editor.drop(bracket, broken, plate)
        editor.wait_for_title("bracket.obj and 1 more - Kerf")
        editor.point_at("message", 0.3, 0.5)
        editor.part("whole message")
        editor.drop(broken)
        editor.click("message", 0.3, 0.5)
        editor.part("messages")
        editor.do("Escape")
        self.assertNotIn("messages", editor.landmarks()["parts"])
        report = editor.quit()
        self.assertEqual(report["files"], ["bracket.obj", "plate.obj"])
        self.assertEqual(report["bodies"], 2)
        self.assertIn("not a mesh.stl", report["message"])
        self.assertEqual(sum("not a mesh.stl" in text for text in report["messages"]), 2)

    def test_a_click_on_nothing_leaves_no_step(self):
        editor = self.open(SPHERE)
        editor.click(0.06, 0.1)
        editor.wait_for_title("sphere.json - Kerf")
        report = editor.quit()
        self.assertEqual((report["undo_depth"], report["strokes"]), (0, 0))

    def test_the_last_stroke_follows_the_slider_of_the_radius_and_its_figures_follow_undo(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.drag([("radius", 0.5, 0.5), ("radius", 0.7, 0.5)])
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertGreater(report["recuts"], 0)
        wide = report["last_stroke"]
        again = self.open_again(SPHERE)
        again.drag(ACROSS)
        again.drag(ACROSS_ABOVE)
        again.do("ctrl", "z")
        report = again.quit()
        self.assertGreater(wide["radius"], 1.5 * report["last_stroke"]["radius"])
        self.assertGreater(wide["removed_area"], 1.5 * report["last_stroke"]["removed_area"])
        self.assertEqual(report["last_stroke"]["faces_removed"], report["faces_removed"])
        self.assertGreater(report["last_stroke"]["faces_made"], 100)

    def comb_without_teeth(self):
        """The journal of a bar from which a stroke has cut twelve teeth of two faces each."""
        mesh, path, journal = (os.path.join(self.folder, name) for name in ("comb.obj", "path.json", "comb.kerf"))
        corners = [(0.1 * x, y, 0) for y in (0, 1, 1.1, 1.2) for x in range(24)]
        quads = [(0, x) for x in range(23)] + [(y, x) for y in (1, 2) for x in range(0, 24, 2)]
        with open(mesh, "w") as file:
            file.writelines(f"v {x} {y} {z}\n" for x, y, z in corners)
            for y, x in quads:
                a = 24 * y + x + 1
                file.write(f"f {a} {a + 1} {a + 25} {a + 24}\n")
        keys = [{"t": t, "origin": [x, 1.05, 1], "direction": [0, 0, -1]} for t, x in ((0, -0.1), (1, 2.5))]
        with open(path, "w") as file:
            json.dump({"strokes": [{"laser": {"radius": 0.005}, "keys": keys}]}, file)
        subprocess.run([KERF, "cut", mesh, "--path", path, "--out", os.path.join(self.folder, "pieces"),
                        "--depth", "0", "--journal", journal], check=True, capture_output=True)
        return journal

    def test_crumbs_share_a_row_that_a_click_unfolds(self):
        self.open(SPHERE).quit()
        self.only_panel("Pieces")
        editor = self.open_again(self.comb_without_teeth())
        editor.wait_for_title("comb.kerf - Kerf")
        editor.part("crumbs")
        teeth = lambda: [name for name in editor.landmarks()["parts"] if name.startswith("piece comb ")]
        self.assertEqual(teeth(), [])
        editor.click("crumbs", 0.5, 0.5)
        wait_for(teeth, 20, "no crumb is listed")
        self.assertEqual(editor.quit()["pieces"], 13)

    def test_a_double_click_renames_a_piece_and_undo_takes_the_name_back(self):
        self.open(SPHERE).quit()
        self.only_panel("Pieces")
        editor = self.open_again(SPHERE)
        for name, end in (("half of a ball", "Return"), ("nothing", "Escape")):
            where = "piece sphere" if end == "Return" else "piece half of a ball"
            editor.point_at(where, 0.2, 0.5)
            editor.xdotool("click", "--repeat", 2, "--delay", 120, 1)
            pause(1)
            editor.xdotool("type", "--delay", "60", name)
            pause(0.5)
            editor.do(end)
            editor.part("piece half of a ball")
        editor.do("ctrl", "z")
        editor.part("piece sphere")
        editor.do("ctrl", "shift", "z")
        self.save_as(editor, "named")
        editor.wait_for_title("named.kerf - Kerf")
        editor.quit()
        with open(os.path.join(self.folder, "named.kerf")) as file:
            self.assertIn('"half of a ball"', file.read())

    def test_a_split_view_cuts_the_stroke_at_two_resolutions(self):
        self.assert_split_view_works()

    def test_a_split_view_works_where_no_font_is_installed(self):
        self.assert_split_view_works("--own-font")

    def assert_split_view_works(self, *options):
        editor = self.open(SPHERE, *options)
        editor.press("s")
        editor.part("second")
        editor.drag([("first", 0.32, 0.5), ("first", 0.7, 0.5)])
        editor.drag([("second", 0, 0.77), (0.32, 0.77)])
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertTrue(report["split"]["shown"])
        self.assertGreater(report["split"]["faces"], 5000)
        self.assertLess(report["split"]["faces"], report["faces"])
        first, second = report["layout"]["first"], report["layout"]["second"]
        self.assertAlmostEqual(first[2], 0.32 * report["layout"]["viewport"][2], delta=8)
        self.assertEqual(first[2] + second[2], report["layout"]["viewport"][2])

    def test_escape_and_a_stroke_close_what_is_open_over_the_picture(self):
        editor = self.open(SPHERE)
        for opener, button in ((("radius",), 3), (("pattern",), 1)):
            editor.click(*opener, 0.3, 0.5, button=button)
            editor.wait_for_popup(True)
            editor.do("Escape")
            editor.wait_for_popup(False)
        editor.click("radius", 0.3, 0.5, button=3)
        editor.wait_for_popup(True)
        editor.click(0.5, 0.5)
        editor.wait_for_popup(False)
        editor.click("pattern", 0.3, 0.5)
        editor.wait_for_popup(True)
        editor.drag(ACROSS)
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertGreater(report["faces_removed"], 100)

    def test_a_smaller_window_keeps_panels_and_picture_apart(self):
        editor = self.open()
        editor.xdotool("search", "--name", "Kerf", "windowsize", 800, 600)
        pause(1.5)
        layout = editor.quit()["layout"]
        self.assertEqual(layout["viewport"][2] + layout["side"][2], 800)
        self.assertGreaterEqual(layout["viewport"][2], 320)
        self.assertEqual(layout["status"][1] + layout["status"][3], 600)

    def test_files_open_together_and_broken_settings_are_set_aside(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        os.mkdir(os.path.join(folder.name, "kerf"))
        with open(os.path.join(folder.name, "kerf", "settings.json"), "w") as file:
            file.write("{broken")
        meshes = os.path.join(ASSETS, "meshes")
        editor = Editor(folder.name, os.path.join(meshes, "knot.obj"), os.path.join(meshes, "bracket.obj"))
        self.addCleanup(editor.close)
        report = editor.quit()
        self.assertEqual(report["bodies"], 2)
        self.assertTrue(os.path.exists(os.path.join(folder.name, "kerf", "settings.json.bad")))
        self.assertIn("set aside", report["message"])

    def unsaved(self):
        folder = os.path.join(self.folder, "kerf")
        return [os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".kerf")]

    def save_as(self, editor, name):
        editor.press("ctrl", "shift", "s")
        self.type_name(editor, name)

    def type_name(self, editor, name):
        """The name that the browser offers is chosen, so that typing replaces it."""
        pause(2)
        editor.xdotool("type", "--delay", "40", os.path.join(self.folder, name))
        pause(1.5)
        editor.press("Return")

    def test_what_was_cut_is_saved_and_opens_again_as_it_was(self):
        editor = self.open(SPHERE)
        editor.wait_for_title("sphere.json - Kerf")
        editor.drag(ACROSS)
        editor.wait_for_title("sphere.json* - Kerf")
        self.save_as(editor, "ball")
        editor.wait_for_title("ball.kerf - Kerf")
        editor.drag(ACROSS_ABOVE)
        editor.wait_for_title("ball.kerf* - Kerf")
        editor.press("ctrl", "s")
        editor.wait_for_title("ball.kerf - Kerf")
        saved = editor.quit()
        self.assertEqual(self.unsaved(), [])
        journal = os.path.join(self.folder, "ball.kerf")
        self.assertTrue(os.path.exists(journal + "~"))
        replayed = subprocess.run([KERF, "replay", journal], capture_output=True, text=True)
        self.assertEqual((replayed.returncode, replayed.stderr), (0, ""))
        self.set(folder=self.folder)
        again = self.open_again(SPHERE)
        self.open_by_browser(again, "all.kerf")  # a part of its name
        again.wait_for_title("ball.kerf - Kerf")
        report = again.quit()
        for key in ("strokes", "faces", "pieces", "faces_removed"):
            self.assertEqual(report[key], saved[key], key)
        self.assertEqual(self.settings()["recent"][0], os.path.realpath(journal))

    def only_panel(self, title):
        """Folds all panels but one, so that nothing pushes it out of the window."""
        os.makedirs(os.path.join(self.folder, "kerf"), exist_ok=True)
        titles = ("Laser", "Resolution", "Pieces", "History", "Light", "Tree", "View", "Statistics", "File", "Display")
        with open(os.path.join(self.folder, "kerf", "settings.json"), "w") as file:
            json.dump({"panels": {t: t == title for t in titles}}, file)

    def test_strokes_are_taken_back_and_brought_again(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.drag(ACROSS_ABOVE)
        for keys in (("ctrl", "z"), ("ctrl", "z"), ("ctrl", "shift", "z")):
            editor.do(*keys)
        back = editor.quit()
        self.assertEqual((back["undo_depth"], back["strokes"]), (1, 1))
        self.assertGreater(back["faces_removed"], 0)

    def test_a_click_on_the_first_row_of_the_history_goes_back_to_what_was_opened(self):
        self.assert_history_is_travelled()

    def test_the_history_is_travelled_where_no_font_is_installed(self):
        self.assert_history_is_travelled("--own-font")

    def assert_history_is_travelled(self, *options):
        self.open(SPHERE).quit()
        self.only_panel("History")
        editor = self.open_again(SPHERE, *options)
        editor.drag(ACROSS)
        editor.drag(ACROSS_ABOVE)
        editor.part("history row 2")
        editor.click("history row 0", 0.2, 0.5)
        there = editor.quit()
        self.assertEqual((there["undo_depth"], there["strokes"], there["faces_removed"]), (0, 0, 0))
        self.assertEqual(there["pieces"], 1)

    def test_unsaved_work_does_not_go_without_a_question(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        for leave in (("ctrl", "q"), ("ctrl", "n")):
            editor.press(*leave)
            pause(1)
            editor.press("Escape")
            pause(0.5)
            editor.wait_for_title("sphere.json* - Kerf")
        editor.press("ctrl", "n")
        pause(1)
        editor.press("d")
        editor.wait_for_title("car.json - Kerf")
        pause(1)
        editor.drag([(0.53, 0.14), (0.53, 0.5)])
        editor.wait_for_title("car.json* - Kerf")
        editor.press("ctrl", "q")
        pause(1)
        editor.press("s")
        self.type_name(editor, "car")
        self.assertEqual(editor.report()["strokes"], 1)
        self.assertTrue(os.path.exists(os.path.join(self.folder, "car.kerf")))
        self.assertEqual(self.unsaved(), [])

    def test_a_killed_editor_loses_nothing_and_the_next_one_goes_on(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.draw_without_end()
        editor.die()
        left, = self.unsaved()
        with open(left) as file:
            lines = file.read().splitlines()
        self.assertEqual(sum('"do":"begin"' in line for line in lines), 2)
        self.assertIn('"do":"move"', lines[-1])

        later = self.open_again(SPHERE)
        later.press("Escape")
        self.assertEqual(later.quit()["strokes"], 0)
        self.assertEqual(self.unsaved(), [left])

        editor = self.open_again(SPHERE)
        other = self.open_again(SPHERE)  # is not offered what another looks at
        self.assertEqual(other.quit()["strokes"], 0)
        editor.press("Return")
        editor.wait_for_title("sphere.obj* - Kerf")
        self.assertNotIn(left, self.unsaved())
        self.assertEqual(len(self.unsaved()), 1)
        self.save_as(editor, "saved")
        editor.wait_for_title("saved.kerf - Kerf")
        report = editor.quit()
        self.assertEqual(report["strokes"], 2)
        self.assertGreater(report["faces_removed"], 500)
        self.assertGreater(report["last_stroke"]["faces_made"], 100)  # as figures of what was replayed
        self.assertEqual(self.unsaved(), [])
        replayed = subprocess.run([KERF, "replay", os.path.join(self.folder, "saved.kerf")], stdout=subprocess.DEVNULL)
        self.assertEqual(replayed.returncode, 0)

    def test_two_editors_at_once_keep_their_work_apart(self):
        one = self.open(SPHERE)
        one.drag(ACROSS)
        two = self.open_again(SPHERE)
        two.drag(ACROSS_ABOVE)
        self.assertEqual(len(self.unsaved()), 2)
        two.die()
        self.assertEqual(one.quit()["strokes"], 1)
        self.assertEqual(len(self.unsaved()), 1)

    def test_sigterm_leaves_unsaved_work_for_the_next_start(self):
        editor = self.open(SPHERE)
        editor.drag(ACROSS)
        editor.kerf.send_signal(signal.SIGTERM)
        self.assertEqual(editor.report()["strokes"], 1)
        self.assertEqual(len(self.unsaved()), 1)

    def large_mesh(self):
        mesh = os.path.join(os.environ.get("KERF_TEST_MESHES", ""), "real", "derived", "big_bunny_x16.ply")
        if not os.path.exists(mesh):
            self.skipTest("KERF_TEST_MESHES names no folder with the large mesh")
        return mesh

    def test_a_million_faces_open_beside_the_frames(self):
        editor = self.open(self.large_mesh())
        pause(25)
        report = editor.quit()
        self.assertEqual(report["faces"], 1114656)
        self.assertEqual(report["files"], ["big_bunny_x16.ply"])
        longest = report["between_pictures_ms"]["max"]
        print(f"1.1 M faces: the longest frame took {longest:.0f} ms beside drawing, "
              f"{report['process_bytes'] / report['faces']:.0f} bytes a face in the process")

    def test_a_million_faces_are_cut_live(self):
        editor = self.open(self.large_mesh())
        editor.wait_for_title("big_bunny_x16.ply - Kerf")
        pause(8)
        editor.drag([(0.48, 0.17), (0.51, 0.9)])
        pause(10)
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertGreater(report["faces_removed"], 1000)
        cutting = report["while_cutting"]
        self.assertGreater(cutting["frames"], 1)
        self.assertEqual(len(cutting["each_frame_ms"]), cutting["frames"])
        for name in "frame_ms", "between_pictures_ms":
            times = ", ".join(f"{key} {value:.0f}" for key, value in cutting[name].items())
            print(f"1.1 M faces, {cutting['frames']} frames that cut: {name} {times}")

    def slot_journal(self, mesh):
        """The mesh cut in two large pieces, and a small one, by a stroke of more than 16 MB of before-images."""
        journal = os.path.join(self.folder, "slot.kerf")
        path = os.path.join(self.folder, "path.json")
        keys = [{"t": t, "origin": [-0.0168, y, -0.157], "direction": [0, 0, 1]} for t, y in ((0, 0.001), (1, 0.22))]
        with open(path, "w") as file:
            json.dump({"strokes": [{"laser": {"radius": 0.0003}, "keys": keys}]}, file)
        subprocess.run([KERF, "cut", mesh, "--path", path, "--out", os.path.join(self.folder, "pieces"),
                        "--target-edge", "0.00015", "--steps", "400", "--journal", journal], check=True)
        return journal

    def test_a_large_piece_is_copied_out_and_a_stroke_taken_back_by_replay_beside_the_frames(self):
        mesh = self.large_mesh()
        self.open(SPHERE).quit()
        with open(self.settings_file(), "w") as file:
            json.dump({"history_mb": 16}, file)
        editor = self.open_again(self.slot_journal(mesh))
        editor.wait_for_title("slot.kerf - Kerf")
        editor.point_at(0.64, 0.63)
        editor.xdotool("keydown", "ctrl", "click", 1, "keyup", "ctrl")
        editor.press("h")
        editor.wait_for_title("slot.kerf* - Kerf")
        pause(10)
        editor.press("ctrl", "z")
        pause(5)
        editor.press("ctrl", "z")
        pause(25)
        report = editor.quit()
        self.assertEqual((report["undo_depth"], report["strokes"], report["bodies"], report["pieces"]), (0, 0, 1, 1))
        self.assertEqual(report["faces"], 1114656)
        print(f"1.1 M faces: the longest frame took {report['between_pictures_ms']['max']:.0f} ms beside drawing")

    def test_opening_is_cancelled_and_changes_nothing(self):
        editor = self.open()
        before = editor.quit()["faces"]
        editor = self.open()
        editor.drop(self.large_mesh())
        editor.press("Escape")
        pause(6)
        report = editor.quit()
        self.assertEqual(report["faces"], before)
        self.assertIn("cancelled", report["message"])

    def test_sigterm_ends_it_with_its_report(self):
        editor = self.open()
        editor.kerf.send_signal(signal.SIGTERM)
        self.assertEqual(editor.report()["strokes"], 0)


if __name__ == "__main__":
    unittest.main()
