#!/usr/bin/env python3
"""No loss of power takes work that Kerf reported as saved or autosaved, or leaves half a file. The states are random
ones of those in which a disk may be left (power_cut.py). `power_cut_test.py KERF`."""
import os
import random
import shlex
import shutil
import stat
import subprocess
import tempfile
import unittest
from unittest import mock

import scripted_editor
from editor_window import ASSETS, KERF, WindowTest
from power_cut import Disk, calls, traced, wait_for_end

STATES = 500 if "KERF_LONG" in os.environ else 60
SEED = int(os.environ.get("KERF_SEED", "1"))
PLATE = "v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0 0.5\nv -0.5 0 0.5\nf 1 4 3\nf 1 3 2\n"


def whole_lines(journal):
    """The lines of a journal up to the first damaged one."""
    lines = []
    for line in journal.split(b"\n")[:-1]:
        if b"\0" in line or not line.endswith(b"}"):
            break
        lines.append(line)
    return lines


def strokes(journal):
    return sum(line.startswith(b'{"do":"begin-stroke"') for line in whole_lines(journal))


def files_of(folder):
    found = {}
    for path, _, names in os.walk(os.path.realpath(folder)):
        for name in names:
            with open(os.path.join(path, name), "rb") as file:
                found[os.path.join(path, name)] = file.read()
    return found


def can_trace():
    try:
        return subprocess.run(["strace", "-o", os.devnull, "true"], capture_output=True).returncode == 0
    except FileNotFoundError:
        return False


@unittest.skipIf("KERF_TEST_SANITIZED" in os.environ, "the leak sanitizer does not run in a traced program")
@unittest.skipUnless(can_trace(), "strace is missing or may not trace programs here")
class PowerCut(WindowTest):
    def states(self, log, folder, before):
        """Yields (answers, files): what the disk may hold after a loss of power at a random call, when the program had
        written this number of lines. The last state is that after the end of the program."""
        chance, recorded = random.Random(SEED), list(calls(log))
        self.assertGreater(len(recorded), 20)
        places = sorted(chance.choices(range(len(recorded)), k=STATES - 1)) + [len(recorded)]
        disk, taken, answers = Disk(folder, before), 0, 0
        for place in places:
            for call in recorded[taken:place]:
                disk.take(call)
                if call.name == "write" and call.numbers[0] == 1 and call.result:
                    answers += call.texts[0][:call.result].count(b"\n")
            taken = place
            with self.subTest(seed=SEED, calls=place, last=recorded[max(0, place - 8):place]):
                yield answers, disk.after_loss(chance)

    def traced_kerf(self, folder, log):
        """A program that runs Kerf and records its calls."""
        script = os.path.join(folder, "kerf.sh")
        with open(script, "w") as file:
            file.write(f'#!/bin/sh\nexec {shlex.join(traced(log, KERF))} "$@"\n')
        os.chmod(script, stat.S_IRWXU)
        return script

    def new_folder(self):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        return folder

    def draw(self, editor, at):
        editor.drag([(at, 0.4), (at, 0.6)])

    def wait_for_autosave(self, editor):
        editor.wait_for(lambda: editor.shows("autosaved"), "the work is not autosaved")

    def test_saved_and_autosaved_strokes_survive(self):
        tools = self.new_folder()
        log = os.path.join(tools, "log")
        plate = os.path.join(tools, "plate.obj")
        with open(plate, "w") as file:
            file.write(PLATE)
        said, versions = [(0, 0)], []  # (answers read before, strokes reported as saved)

        def expect_saved(number):
            said.append((editor.answers, number))

        with mock.patch.object(scripted_editor, "KERF", self.traced_kerf(tools, log)):
            editor = self.open(plate)
            before = files_of(self.folder)
            self.draw(editor, 0.3)
            self.wait_for_autosave(editor)
            expect_saved(1)
            self.draw(editor, 0.4)
            self.save_as(editor, "saved")
            editor.wait_for_title("saved.kerf - Kerf")
            expect_saved(2)
            saved = os.path.join(os.path.realpath(self.folder), "saved.kerf")
            versions.append(files_of(self.folder)[saved])
            self.draw(editor, 0.5)
            self.wait_for_autosave(editor)
            expect_saved(3)
            self.draw(editor, 0.6)
            editor.do("ctrl", "s")
            editor.wait_for_title("saved.kerf - Kerf")
            expect_saved(4)
            versions.append(files_of(self.folder)[saved])
            self.draw(editor, 0.7)
            self.wait_for_autosave(editor)
            expect_saved(5)
            editor.die()
        wait_for_end(log)
        self.assertEqual([strokes(version) for version in versions], [2, 4])
        opened = set()
        for answers, files in self.states(log, self.folder, before):
            wanted = max(number for at, number in said if at <= answers)
            journals = {name: text for name, text in files.items() if name.endswith(".kerf")}
            self.assertGreaterEqual(max([0, *map(strokes, journals.values())]), wanted)
            self.assertIn(files.get(saved), [None, *versions])
            opened.update(journals.values())
        self.expect_openable(sorted(opened), tools)

    def expect_openable(self, journals, folder):
        """Each journal replays to the hashes that it holds. Of a damaged one, a sentence states the line."""
        for text in journals:
            path = os.path.join(folder, "left.kerf")
            with open(path, "wb") as file:
                file.write(text)
            done = subprocess.run([KERF, "replay", path], capture_output=True, text=True)
            self.assertIn(done.returncode, (0, 1, 2), done.stderr)
            self.assertRegex(done.stderr, "^$" if done.returncode == 0 else r"^kerf: \S+: .*line \d+.*\n$")

    def test_an_exported_mesh_is_the_old_or_the_new_one(self):
        folder, tools = self.new_folder(), self.new_folder()
        log, mesh = os.path.join(tools, "log"), os.path.join(os.path.realpath(folder), "out.obj")
        with open(mesh, "w") as file:
            file.write(PLATE)
        before = files_of(folder)
        bracket = os.path.join(ASSETS, "meshes", "bracket.obj")
        subprocess.run(traced(log, KERF, "prepare", bracket, "--quiet", "--subdivide", "midpoint", "--out", mesh), check=True)
        wait_for_end(log)
        after = files_of(folder)
        for _, files in self.states(log, folder, before):
            self.assertIn(files.get(mesh), (before[mesh], after[mesh]))
        self.assertEqual(files[mesh], after[mesh], "the program ended before the file was on the disk")


if __name__ == "__main__":
    unittest.main()
