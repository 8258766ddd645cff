"""The editor in a real window, with real input: `SUBJECT_test.py KERF` runs the tests of a subject. Needs Xvfb and
xdotool."""
import json
import os
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
ASSETS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "assets")
ACROSS, ACROSS_ABOVE = [(0.32, 0.5), (0.68, 0.5)], [(0.32, 0.37), (0.68, 0.37)]  # strokes that cut the sphere
SPHERE = os.path.join(ASSETS, "scenes", "sphere.json")


def pause(seconds):
    time.sleep(PATIENCE * seconds)


def wait_for(met, seconds, what):
    """Until met() is true. `what` is said otherwise: a text, or a function that gives one."""
    until = time.monotonic() + PATIENCE * seconds
    while not met():
        if time.monotonic() > until:
            raise AssertionError(what() if callable(what) else what)
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

    def expect_running(self):
        if self.kerf.poll() is not None:
            raise AssertionError(f"the editor ended with {self.kerf.returncode}: {self.kerf.stderr.read()}")

    def has_window(self):
        self.expect_running()
        seen = self.xdotool("search", "--onlyvisible", "--name", "Kerf").stdout.strip()
        return seen and os.path.exists(self.landmarks_file)

    def wait_for_window(self):
        wait_for(self.has_window, 60, "no window came up")
        pause(1.5)

    def landmarks(self):
        self.expect_running()
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
        wait_for(lambda: self.has_heard() and not self.landmarks()["busy"], 240,
                 lambda: f"the editor never came to rest: busy {self.landmarks()['busy']}, the pointer is at "
                         f"{self.pointer} and was heard of at {self.landmarks()['pointer']}")

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


class WindowTest(unittest.TestCase):
    # Whether the pictures are anti-aliased, which takes a software renderer most of its time.
    antialias = False
    # Whether what is hot stays so; a picture that cools down does not come to rest for seconds.
    heat_held = True

    def open(self, *arguments):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write_settings({})
        editor = Editor(folder.name, *arguments)
        self.addCleanup(editor.close)
        return editor

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

    def write_settings(self, settings):
        os.makedirs(os.path.join(self.folder, "kerf"), exist_ok=True)
        with open(self.settings_file(), "w") as file:
            json.dump({"antialias": self.antialias, "heat_held": self.heat_held, **settings}, file)

    def only_panel(self, title):
        """Folds all panels but one, so that nothing pushes it out of the window."""
        titles = ("Laser", "Material", "Prepare", "Resolution", "Path", "Pieces", "Bodies", "History", "Light", "Tree", "Graph", "Single step", "View", "Statistics", "File", "Display")
        self.write_settings({"panels": {t: t == title for t in titles}})

    def open_by_browser(self, editor, file):
        """Types a whole path, or a part of a name, into File > Open."""
        editor.press("ctrl", "o")
        editor.part("browser")
        pause(1)
        editor.xdotool("type", "--delay", "40", file)
        pause(1)
        editor.press("Return")
        pause(1.5)

    def unsaved(self):
        folder = os.path.join(self.folder, "kerf")
        return [os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".kerf")]

    def save_as(self, editor, name):
        editor.press("ctrl", "shift", "s")
        self.type_name(editor, name)

    def type_name(self, editor, name):
        """The name that the browser offers is chosen, so that typing replaces it."""
        editor.part("browser")
        pause(1)
        editor.xdotool("type", "--delay", "40", os.path.join(self.folder, name))
        pause(1.5)
        editor.press("Return")
