#!/usr/bin/env python3
"""Work that an earlier version saved still ends where it ended then: kept_test.py KERF replays each journal and recording
beside this file to its hash in hashes.json.

They were made with the editor, with `kerf cut` and with the library: strokes of many poses that cool, undo, redo and
recut (geometric); a laser with power (thermal); strokes before and while bodies move, single ticks (bodies); pins and
the spring (pins); pieces that are moved, copied, hidden, deleted (pieces); simplify, smooth, subdivide (prepare);
welds and hinges of a scene (joints); a rim of faces (faces); a solid with a cut material, cut by laser and knife
(knife); a Kerf mesh with UVs and materials (looks); the lines of a drawing as one step, recut (drawing); a match of a
bot (match). The meshes are copies, so that those of the assets may change. What a change breaks on purpose is made
again by remake_journals, and its commit says what a user of such a file sees.
"""
import json
import os
import subprocess
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
KERF = os.path.abspath(sys.argv.pop(1))


class Kept(unittest.TestCase):
    def test_every_stored_file_replays_to_its_hash(self):
        with open(os.path.join(HERE, "hashes.json")) as file:
            hashes = json.load(file)
        self.assertEqual(sorted(hashes), sorted(name for name in os.listdir(HERE) if name.endswith(".kerf")))
        for name, wanted in hashes.items():
            with self.subTest(name):
                done = subprocess.run([KERF, "replay", os.path.join(HERE, name)], capture_output=True, text=True)
                if "another kind of machine" in done.stderr:
                    self.assertEqual(done.returncode, 0, done.stderr)
                    print(f"its hash is not asked: {done.stderr.strip()}", file=sys.stderr)
                    continue
                self.assertEqual((done.returncode, done.stdout.strip()), (0, wanted), done.stderr)


if __name__ == "__main__":
    unittest.main()
