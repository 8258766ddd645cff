#!/usr/bin/env python3
"""Work that was saved after strokes as a hand draws them, before, between and while bodies move, with undo, redo and
strokes that are cut again: `kerf replay` and an editor that opens the file come to the state that was saved."""
import math
import os
import random
import subprocess
import unittest

from editor_window import ASSETS, KERF, SPHERE, WindowTest

MESHES = os.environ.get("KERF_TEST_MESHES")
LONG = "KERF_LONG" in os.environ
LARGEST_FILE = 600e3 if LONG else 100e3  # bytes
SHORT = 2  # the seed of a history that takes less time than most
FIRST, LAST = (1, 40) if LONG else (SHORT, SHORT)


def files():
    """The meshes that are drawn on: ours and, where there are some, real ones."""
    found = [SPHERE, os.path.join(ASSETS, "meshes", "car.obj"), os.path.join(ASSETS, "meshes", "bracket.obj")]
    for folder, _, names in sorted(os.walk(os.path.join(MESHES, "real"))) if MESHES else ():
        found += [os.path.join(folder, name) for name in sorted(names) if name.endswith((".obj", ".stl", ".ply", ".off"))
                  and os.path.getsize(os.path.join(folder, name)) < LARGEST_FILE]
    return found


class SavedWork(WindowTest):
    def draw(self, editor, chance):
        """A stroke across the picture, wavering, with many moves of the pointer."""
        down, slope, phase = chance.uniform(0.35, 0.65), chance.uniform(-0.2, 0.2), chance.uniform(0, 6)
        path = [(along / 60, down + slope * (along / 60 - 0.5) + 0.01 * math.sin(along / 7 + phase))
                for along in range(chance.randint(3, 12), chance.randint(48, 57))]
        editor.move_to(*editor.place(path[0]))
        editor.hold(1)
        for point in path:
            editor.move_to(*editor.place(point))
        editor.release(1)

    def act(self, editor, chance):
        action = chance.choice(["draw", "draw", "play", "play", "tick", "undo", "redo", "recut", "wait"])
        if action == "draw":
            self.draw(editor, chance)
        elif action == "play":
            editor.press("space")
        elif action == "tick":
            editor.press("period")
        elif action == "undo":
            editor.press("ctrl", "z")
        elif action == "redo":
            editor.press("ctrl", "shift", "z")
        elif action == "recut":
            editor.drag([("radius", 0.5, 0.5), ("radius", chance.uniform(0.4, 0.6), 0.5)])
        editor.pause(chance.choice([0.05, 0.5, 1]))
        return action

    def stop_time(self, editor):
        if editor.shows("play badge"):
            editor.press("space")
        editor.settle()

    def expect_saved_state(self, seed):
        chance = random.Random(seed)
        mesh = chance.choice(files())
        editor = self.open(mesh)
        self.draw(editor, chance)
        actions = [self.act(editor, chance) for _ in range(chance.randint(3, 7))]
        self.stop_time(editor)
        self.save_as(editor, "saved")
        editor.wait_for_title("saved.kerf - Kerf")
        state = editor.ask("report")["state_hash"]
        editor.quit()
        with self.subTest(seed=seed, mesh=mesh, actions=actions):
            saved = os.path.join(self.folder, "saved.kerf")
            replayed = subprocess.run([KERF, "replay", saved, "--expect", state], capture_output=True, text=True)
            self.assertEqual((replayed.returncode, replayed.stderr), (0, ""))
            again = self.open_again(saved)
            again.wait_for_title("saved.kerf - Kerf")
            report = again.quit()
            self.assertEqual(report["state_hash"], state, report["message"])

    def test_a_saved_session_replays_and_reopens_unchanged(self):
        for seed in range(FIRST, LAST + 1):
            self.expect_saved_state(seed)


if __name__ == "__main__":
    unittest.main()
