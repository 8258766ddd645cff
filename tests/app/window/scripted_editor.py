"""The editor without a screen, driven by a script of events (ui/window/scripted_window.h): nothing sleeps, and a run is
repeated to the bit."""
import json
import os
import subprocess

from editor_driver import HANG, KERF, EditorDriver
from png_pixels import pixels_of

# A small window, in which panels and text are small, too, takes a software renderer half the time.
WIDTH, HEIGHT, UI_SCALE = 896, 560, 0.7
FRAME, RESTING_FRAME = 0.05, 0.25  # s between two frames, and where a test only waits for sparks to die down
KEYS = {"ctrl": "Ctrl", "shift": "Shift", "alt": "Alt", "Shift_L": "Shift", "Return": "Enter", "Escape": "Esc",
        "BackSpace": "Backspace", "Delete": "Del", "space": "Space", "comma": ",", "period": ".", "minus": "-",
        "slash": "/", " ": "Space", "bracketright": "]", "bracketleft": "[", "KP_5": "Num 5"}


class ScriptedEditor(EditorDriver):
    def __init__(self, folder, *arguments):
        self.report_file = os.path.join(folder, "report.json")
        self.picture_file = os.path.join(folder, "picture.png")
        environment = dict(os.environ, XDG_CONFIG_HOME=folder, XDG_STATE_HOME=folder)
        self.kerf = subprocess.Popen([KERF, *arguments, "--report", self.report_file, "--size", f"{WIDTH}x{HEIGHT}",
                                      "--events", "-"], env=environment, stdin=subprocess.PIPE,
                                     stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, bufsize=1)
        self.pointer = [0, 0]
        self.held = set()
        self.answers = 0  # read so far
        self.send({"draws": False})
        self.send({"frame": FRAME})
        if arguments[:1] != ("play",):  # a match never settles
            self.settle()

    def send(self, step):
        """Fails where the editor has ended before it read the step."""
        try:
            self.kerf.stdin.write(json.dumps(step) + "\n")
        except BrokenPipeError:
            self.kerf.wait(timeout=HANG)

    def ask(self, what):
        self.send({"answer": what})
        line = self.kerf.stdout.readline()
        if not line:
            self.kerf.wait(timeout=HANG)
            self.expect_running()
        self.answers += 1
        return json.loads(line)

    def pause(self, seconds):
        self.send({"wait": seconds})

    def pass_time(self):
        """Until the editor is there, too."""
        self.pause(0.1)
        self.title()

    def landmarks(self):
        return self.ask("landmarks")

    def title(self):
        return self.ask("title")

    def pixels(self):
        """What the window shows in a frame that is drawn now, as a function from a place to red, green and blue."""
        self.send({"draws": True})
        self.settle()
        self.send({"picture": self.picture_file})
        self.send({"draws": False})
        self.title()  # the steps before it were taken
        return pixels_of(self.picture_file)

    def draw_at_once(self, path):
        """Presses the left button, moves through places in pixels and releases it within a frame."""
        self.move_to(*path[0])
        self.send({"together": [{"press": "left"}, *({"move": place} for place in path), {"release": "left"}]})
        self.pointer = list(path[-1])

    def press_at_once(self, *parts):
        """Presses and releases keys within one frame: a tuple is a chord, as ("ctrl", "o"), and a text is typed."""
        steps = []
        for part in parts:
            for keys in [part] if isinstance(part, tuple) else [(c,) for c in part]:
                names = [KEYS.get(key, key.upper() if len(key) == 1 else key) for key in keys]
                steps += [{"key_down": name} for name in names if name != "_"]
                steps += [] if isinstance(part, tuple) else [{"type": keys[0]}]
                steps += [{"key_up": name} for name in reversed(names) if name != "_"]
        self.send({"together": steps})

    def wait_until_heard(self, of_what):
        pass  # each step is heard by the frame after it

    def settle(self):
        self.send({"frame": RESTING_FRAME})
        self.send({"settle": 60})
        self.send({"frame": FRAME})

    def move_to(self, x, y):
        self.send({"move": [x, y]})
        self.pointer = [x, y]

    def hold(self, button):
        self.send({"press": ["left", "middle", "right"][button - 1]})

    def release(self, button):
        self.send({"release": ["left", "middle", "right"][button - 1]})

    def wheel(self, notches):
        self.send({"wheel": notches})

    def key_down(self, key):
        name = KEYS.get(key, key.upper() if len(key) == 1 else key)
        steps = [{"key_down": name}]
        if len(name) == 1 and not self.held:
            steps.append({"type": name.lower()})
        if name in ("Ctrl", "Alt"):
            self.held.add(name)
        self.send({"together": steps})

    def key_up(self, key):
        name = KEYS.get(key, key.upper() if len(key) == 1 else key)
        self.held.discard(name)
        self.send({"key_up": name})

    def type(self, text):
        self.send({"type": text})
        self.pause(0.2)

    def double_click(self):
        for step in ("press", "release") * 2:
            self.send({step: "left"})
        self.settle()

    def drop(self, *files):
        self.send({"drop": list(files)})
        self.pause(0.2)
        self.settle()

    def resize(self, width, height):
        self.send({"size": [width, height]})
        self.settle()

    def has_ended(self, _):
        self.send({"answer": "title"})
        if self.kerf.stdout.readline():
            self.answers += 1
            return False
        self.kerf.wait(timeout=HANG)
        return True

    def die(self):
        """By a signal, after all that was sent was heard."""
        self.title()
        self.kerf.kill()
        self.close()

    def report(self):
        try:
            self.kerf.stdin.close()
        except BrokenPipeError:
            pass
        status = self.kerf.wait(timeout=HANG)
        errors = self.kerf.stderr.read()
        if status != 0:
            raise AssertionError(f"the editor ended with {status}: {errors}")
        with open(self.report_file) as file:
            return json.load(file)

    def close(self):
        if self.kerf.poll() is None:
            self.kerf.kill()
        self.kerf.wait()
        for stream in (self.kerf.stdin, self.kerf.stdout, self.kerf.stderr):
            try:
                stream.close()
            except BrokenPipeError:
                pass
