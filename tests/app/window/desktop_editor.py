"""The editor on a screen of its own, with real input. Needs Xvfb and xdotool."""
import json
import os
import struct
import subprocess
import sys
import time

from editor_driver import HANG, KERF, EditorDriver

WIDTH, HEIGHT = 1280, 800


class DesktopEditor(EditorDriver):
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

    def pause(self, seconds):
        time.sleep(seconds)

    def wait_for_screen(self):
        """A server that has told its number may not answer yet."""
        try:
            self.wait_for(lambda: self.xdotool("getdisplaygeometry").returncode == 0, "the screen never answered")
        except AssertionError:
            self.screen.kill()
            self.screen.wait()
            raise

    def has_window(self):
        self.expect_running()
        seen = self.xdotool("search", "--onlyvisible", "--name", "Kerf").stdout.strip()
        return seen and os.path.exists(self.landmarks_file)

    def wait_for_window(self):
        self.wait_for(self.has_window, "no window came up")
        self.pause(1.5)

    def landmarks(self):
        self.expect_running()
        with open(self.landmarks_file) as file:
            return json.load(file)

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

    def draw_at_once(self, path):
        """Presses the left button, moves through places in pixels and releases it within a frame or two."""
        self.move_to(*path[0])
        self.hold(1)
        self.xdotool(*(word for place in path for word in ("mousemove", *place)))
        self.release(1)

    def has_heard(self):
        return self.landmarks()["pointer"] == self.pointer

    def wait_until_heard(self, of_what):
        """Until a frame has seen the pointer where it was moved last. Repeats a move that the window missed, as it may
        while it comes up."""
        again = time.monotonic() + HANG / 30

        def has_heard():
            nonlocal again
            if time.monotonic() > again:
                again += HANG / 30
                x, y = self.pointer
                self.xdotool("mousemove", x + 1, y, "mousemove", x, y)
            return self.has_heard()
        self.wait_for(has_heard, f"the editor never heard of {of_what}")

    def settle(self):
        """Waits until the editor has heard of the last move of the pointer and has nothing left to do."""
        self.pause(0.3)
        self.wait_for(lambda: self.has_heard() and not self.landmarks()["busy"],
                      lambda: f"the editor never came to rest: busy {self.landmarks()['busy']}, the pointer is at "
                              f"{self.pointer} and was heard of at {self.landmarks()['pointer']}")

    def hold(self, button):
        self.xdotool("mousedown", button)

    def release(self, button):
        self.xdotool("mouseup", button)

    def wheel(self, notches):
        for _ in range(abs(notches)):
            self.xdotool("click", 4 if notches > 0 else 5)

    def key_down(self, key):
        self.xdotool("keydown", key)

    def key_up(self, key):
        self.xdotool("keyup", key)

    def type(self, text):
        self.xdotool("type", "--delay", "60", "--", text)
        self.pause(0.5)

    def double_click(self):
        self.xdotool("click", "--repeat", 2, "--delay", 120, 1)
        self.pause(3)

    def drop(self, *files, seconds=2):
        """Drags files from another program onto the middle of the picture, lets them go and waits."""
        window = self.xdotool("search", "--onlyvisible", "--name", "Kerf").stdout.split()[0]
        source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "drag_source.py")
        x, y = self.place((0.5, 0.5))
        subprocess.run([sys.executable, source, window, str(x), str(y), *files], env=self.environment, check=True)
        self.pause(seconds)

    def resize(self, width, height):
        self.xdotool("search", "--name", "Kerf", "windowsize", width, height)
        self.pause(1.5)

    def title(self):
        return self.xdotool("search", "--onlyvisible", "--name", "Kerf", "getwindowname").stdout.strip()

    def has_ended(self, seconds):
        try:
            self.kerf.wait(timeout=seconds)
        except subprocess.TimeoutExpired:
            return False
        return True

    def die(self):
        self.kerf.kill()
        self.close()

    def report(self, expected=0):
        status = self.kerf.wait(timeout=HANG)
        errors = self.kerf.stderr.read()
        if status != expected:
            raise AssertionError(f"the editor ended with {status}: {errors}")
        with open(self.report_file) as file:
            return json.load(file)

    def close(self):
        for process in (self.kerf, self.screen):
            if process.poll() is None:
                process.kill()
            process.wait()
        self.kerf.stderr.close()
