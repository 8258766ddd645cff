"""Tests of the editor in a window: `SUBJECT_test.py KERF` runs those of a subject.

The window is one without a screen that a script drives, which takes no time for waiting. Tests that are marked with
`real_input` prove that the input of a desktop arrives, too, and see what is on the screen.
"""
import json
import os
import sys
import tempfile
import time
import unittest

from desktop_editor import DesktopEditor
from editor_driver import KERF
from scripted_editor import UI_SCALE, ScriptedEditor

ASSETS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "assets")
ACROSS, ACROSS_ABOVE = [(0.32, 0.5), (0.68, 0.5)], [(0.32, 0.37), (0.68, 0.37)]  # strokes that cut the sphere
SPHERE = os.path.join(ASSETS, "scenes", "sphere.json")


def real_input(test):
    """Marks a test that needs a window on a screen."""
    test.real_input = True
    return test


class WindowTest(unittest.TestCase):
    # Whether the pictures are anti-aliased, which takes a software renderer most of its time.
    antialias = False
    # Whether what is hot stays so; a picture that cools down does not come to rest for seconds.
    heat_held = True

    def run(self, result=None):
        """Says how long the test took, too."""
        begin = time.monotonic()
        super().run(result)
        print(f" {time.monotonic() - begin:.1f} s: {self._testMethodName}", file=sys.stderr)

    def wants_screen(self):
        return getattr(getattr(self, self._testMethodName), "real_input", False)

    def open(self, *arguments):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write_settings({})
        return self.open_again(*arguments)

    def open_again(self, *arguments):
        """With the settings that the last editor left."""
        editor = (DesktopEditor if self.wants_screen() else ScriptedEditor)(self.folder, *arguments)
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
            json.dump({"antialias": self.antialias, "heat_held": self.heat_held,
                       "ui_scale": 1 if self.wants_screen() else UI_SCALE, **settings}, file)

    def only_panel(self, panel):
        """Folds all panels but one, so that nothing pushes it out of the window."""
        if not os.path.exists(self.settings_file()):
            self.write_settings({})
            self.open_again(SPHERE).quit()
        self.write_settings({"panels": {p: p == panel for p in self.settings()["panels"]}})

    def open_by_browser(self, editor, file):
        """Types a whole path, or a part of a name, into File > Open."""
        editor.press("ctrl", "o")
        editor.part("browser")
        editor.pause(1)
        editor.type(file)
        editor.pause(0.5)
        editor.press("Return")
        editor.pause(1.5)

    def unsaved(self):
        folder = os.path.join(self.folder, "kerf")
        return [os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".kerf")]

    def save_as(self, editor, name):
        editor.press("ctrl", "shift", "s")
        self.type_name(editor, name)

    def type_name(self, editor, name):
        """The name that the browser offers is chosen, so that typing replaces it."""
        editor.part("browser")
        editor.pause(1)
        editor.type(os.path.join(self.folder, name))
        editor.pause(1)
        editor.press("Return")
