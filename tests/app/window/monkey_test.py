"""An editor under random input: `monkey_test.py KERF`. Keys, clicks, drags, wheels, sizes and dropped files come from a
seed that is printed. After each round the input pauses, the work is saved, and `kerf replay` of it has to lead to what
the editor shows; in the end the editor is killed, and the work that it kept is replayed.

KERF_MONKEY="FIRST LAST ROUNDS ACTIONS" asks for other seeds and lengths. What fails is run again with ever fewer
actions, as long as it fails, and what is left of them is printed."""
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import unittest

from editor_window import ACROSS, ASSETS, KERF, SPHERE, WindowTest
from scripted_editor import HEIGHT, WIDTH

FIRST, LAST, ROUNDS, ACTIONS = map(int, os.environ.get("KERF_MONKEY", "1 3 1 40").split())  # actions a round
MOST_ATTEMPTS = 40  # to make a failure smaller
NAMES = ("bracket.obj", "plate.obj", "knot.obj", "car.obj")
MESHES = [SPHERE, *(os.path.join(ASSETS, "meshes", name) for name in NAMES)]
LETTERS = list("abcdefghijklmnoprstuvwxyz0123456789") + [",", ".", "-", "/", "[", "]"]
NAMED = ["Space", "Esc", "Enter", "Del", "Tab", "Backspace", "Home", "Left", "Right", "Up", "Down", "F1", "Num 5"]
WITH_CTRL = list("zyadcevklpfo")  # not q and s, which ask for names and for leave


def place(chance):
    """In the picture more often than on panels and menus."""
    if chance.random() < 0.7:
        return [round(chance.uniform(0.3, 0.7) * WIDTH), round(chance.uniform(0.15, 0.8) * HEIGHT)]
    return [chance.randint(0, WIDTH - 1), chance.randint(0, HEIGHT - 1)]


def press(key, *held):
    return [{"key_down": k} for k in (*held, key)] + [{"key_up": k} for k in (key, *held)]


def drag(chance, button):
    begin, end, moves = place(chance), place(chance), chance.randint(1, 12)
    path = [[round(a + (b - a) * i / moves) for a, b in zip(begin, end)] for i in range(moves + 1)]
    return [{"move": path[0]}, {"press": button}, *({"move": p} for p in path[1:]), {"release": button}]


def kind_of(fault):
    """What failures of the same cause have in common: no paths, numbers and hashes."""
    return re.sub(r"[^ ]*[0-9/][^ ]*", "", fault)[:80]


def action(chance):
    """The steps of one action, as the editor reads them."""
    kind = chance.random()
    if kind < 0.25:
        key = chance.choice(LETTERS)
        return press(key.upper(), *(["Shift"] if chance.random() < 0.1 else []))
    if kind < 0.4:
        return press(chance.choice(NAMED))
    if kind < 0.5:
        return press(chance.choice(WITH_CTRL).upper(), "Ctrl", *(["Shift"] if chance.random() < 0.3 else []))
    if kind < 0.62:
        button = chance.choice(["left", "left", "right", "middle"])
        return [{"move": place(chance)}, {"press": button}, {"release": button}]
    if kind < 0.87:
        return drag(chance, chance.choice(["left", "left", "left", "right", "middle"]))
    if kind < 0.93:
        return [{"move": place(chance)}, {"wheel": chance.choice([-3, -1, 1, 3])}]
    if kind < 0.96:
        return [{"wait": chance.choice([0.1, 0.5, 1])}]
    if kind < 0.98:
        return [{"size": [chance.randint(300, 1100), chance.randint(200, 700)]}]
    return [{"drop": [chance.choice([*MESHES, "rubbish.obj", "missing.ply"])]}]


class Monkey(WindowTest):
    def pause_input(self, editor):
        """Leaves dialogs, strokes and time."""
        for button in ("left", "right", "middle"):
            editor.send({"release": button})
        for key in ("Ctrl", "Shift", "Alt"):
            editor.send({"key_up": key})
        for _ in range(4):
            editor.press("Escape")
        if editor.ask("report")["time"]["playing"]:
            editor.press("space")
        editor.settle()

    def replay(self, journal, *expected):
        replayed = subprocess.run([KERF, "replay", journal, *expected], capture_output=True, text=True)
        if replayed.returncode != 0:
            raise AssertionError(f"replay of {os.path.basename(journal)}: {replayed.stderr}")

    def check_saved_work(self, editor, name):
        """What is saved leads to what the editor shows."""
        self.pause_input(editor)
        self.save_as(editor, name)
        self.replay(os.path.join(self.folder, name + ".kerf"), "--expect", editor.ask("report")["state_hash"])

    def run_actions(self, mesh, rounds):
        """Why it failed, or nothing."""
        here = tempfile.TemporaryDirectory()  # where files that are written by chance do no harm
        self.addCleanup(here.cleanup)
        os.chdir(here.name)
        with open("rubbish.obj", "w") as file:
            file.write("f one two\n")
        editor = self.open(mesh)
        try:
            for number, actions in enumerate(rounds):
                for steps in actions:
                    for step in steps:
                        editor.send(step)
                editor.expect_running()
                if number + 1 < len(rounds) or len(rounds) == 1:
                    self.check_saved_work(editor, f"round-{number}")
            editor.drag(ACROSS)
            editor.die()
            for left in self.unsaved():
                self.replay(left)
        except (AssertionError, json.JSONDecodeError) as fault:
            return str(fault) + (editor.kerf.stderr.read() if editor.kerf.poll() is not None else "")
        finally:
            editor.close()
        return ""

    def made_smaller(self, mesh, rounds, fault):
        """Fewer actions in one round that fail in the same way."""
        actions, share = [steps for actions in rounds for steps in actions], 2
        for _ in range(MOST_ATTEMPTS):
            size = max(1, len(actions) // share)
            for begin in range(0, len(actions), size):
                fewer = actions[:begin] + actions[begin + size:]
                if fewer and kind_of(self.run_actions(mesh, [fewer])) == kind_of(fault):
                    actions, share = fewer, max(2, share - 1)
                    break
            else:
                if size == 1:
                    break
                share *= 2
        return actions

    def test_random_input_breaks_nothing_and_saved_state_matches_the_view(self):
        for seed in range(FIRST, LAST + 1):
            chance = random.Random(seed)
            mesh = chance.choice(MESHES)
            print(f"seed {seed}, {os.path.basename(mesh)}", file=sys.stderr)
            rounds = [[action(chance) for _ in range(ACTIONS)] for _ in range(ROUNDS)]
            fault = self.run_actions(mesh, rounds)
            if fault and ROUNDS > 1:
                left = self.made_smaller(mesh, rounds, fault)
                fault += "\nwith these actions: " + json.dumps(left)
            self.assertEqual(fault, "", f"seed {seed}")


if __name__ == "__main__":
    unittest.main()
