"""The editor in a real window, with real input: run as `window_test.py KERF`. Needs Xvfb and xdotool."""
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

KERF = os.path.abspath(sys.argv.pop(1))
WIDTH, HEIGHT = 1280, 800


class Editor:
    """A screen of its own with one editor on it."""

    def __init__(self, folder, *arguments):
        self.report_file = os.path.join(folder, "report.json")
        read, write = os.pipe()
        self.screen = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", f"{WIDTH}x{HEIGHT}x24"],
                                       pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            self.environment = dict(os.environ, DISPLAY=":" + pipe.readline().strip(), XDG_CONFIG_HOME=folder,
                                    XDG_STATE_HOME=folder)
        self.kerf = subprocess.Popen([KERF, *arguments, "--report", self.report_file, "--size", f"{WIDTH}x{HEIGHT}"],
                                     env=self.environment, stderr=subprocess.PIPE, text=True)
        self.wait_for_window()

    def xdotool(self, *arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, capture_output=True, text=True)

    def wait_for_window(self):
        for _ in range(300):
            if self.kerf.poll() is not None:
                raise AssertionError("the editor ended: " + self.kerf.stderr.read())
            if self.xdotool("search", "--onlyvisible", "--name", "Kerf").stdout.strip():
                time.sleep(1.5)
                return
            time.sleep(0.1)
        raise AssertionError("no window came up")

    def drag(self, points, button=1):
        """Moves through the points with the button down, slowly enough that a software renderer sees them."""
        self.xdotool("mousemove", *points[0])
        time.sleep(0.4)
        self.xdotool("mousedown", button)
        time.sleep(0.3)
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            for i in range(1, 13):
                self.xdotool("mousemove", round(x0 + (x1 - x0) * i / 12), round(y0 + (y1 - y0) * i / 12))
                time.sleep(0.05)
        time.sleep(0.3)
        self.xdotool("mouseup", button)
        time.sleep(0.5)

    def press(self, *keys):
        for key in keys:
            self.xdotool("keydown", key)
            time.sleep(0.15)
        for key in reversed(keys):
            self.xdotool("keyup", key)
            time.sleep(0.15)

    def quit(self):
        """Ends the editor by its own shortcut and returns its report."""
        self.press("ctrl", "q")
        return self.report()

    def report(self):
        status = self.kerf.wait(timeout=30)
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
        editor.drag([(500, 130), (500, 720)])
        report = editor.quit()
        self.assertEqual(report["strokes"], 1)
        self.assertGreater(report["faces_removed"], 100)
        self.assertGreater(report["pieces"], 1)
        self.assertGreater(report["frames"], 5)
        self.assertEqual(sorted(report["frame_ms"]), ["max", "p50", "p99"])

    def test_turning_the_view_and_stray_keys_cut_nothing(self):
        editor = self.open()
        editor.drag([(500, 400), (620, 350)], button=2)
        editor.drag([(500, 400), (560, 450)], button=3)
        editor.press("Escape")
        for key in ("f", "Home", "x", "space", "Delete"):
            editor.press(key)
        for _ in range(3):
            editor.xdotool("click", 4)
        report = editor.quit()
        self.assertEqual((report["strokes"], report["faces_removed"], report["pieces"]), (0, 0, 1))

    def test_a_stroke_over_the_sky_removes_nothing(self):
        editor = self.open()
        editor.drag([(60, 80), (200, 90)])
        report = editor.quit()
        self.assertEqual(report["faces_removed"], 0)

    def test_a_broken_file_leaves_the_default_scene_and_the_editor_running(self):
        with tempfile.NamedTemporaryFile("w", suffix=".obj") as file:
            file.write("f one two three\n")
            file.flush()
            report = self.open(file.name).quit()
        self.assertGreater(report["faces"], 3000)

    def test_sigterm_ends_it_with_its_report(self):
        editor = self.open()
        editor.kerf.send_signal(signal.SIGTERM)
        self.assertEqual(editor.report()["strokes"], 0)


if __name__ == "__main__":
    unittest.main()
