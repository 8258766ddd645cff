#!/usr/bin/env python3
"""A batch of cuts whose jobs are killed at random and resumed, as app/README.md shows it: it ends with the results of
undisturbed jobs, each once. GNU parallel runs the jobs where it is installed, otherwise xargs does. With --long there
are 10,000 meshes, else 60; KERF_SEED is the seed of meshes and kills. `batch_test.py KERF`."""
import hashlib
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

KERF = os.path.abspath(sys.argv.pop(1))
MESHES = 10_000 if "KERF_LONG" in os.environ else 60
SEED = int(os.environ.get("KERF_SEED", "1"))
JOB = '[ -e out/{}/report.json ] || KERF_THREADS=1 exec "$KERF" cut {}.obj --path slot.json --quiet --out out/{}'
PATH = {"strokes": [{"laser": {"radius": 0.02, "range": [0, 5]},
                     "keys": [{"t": 0, "origin": [0, 1, -0.7], "direction": [0, -1, 0]},
                              {"t": 1, "origin": [0, 1, 0.7], "direction": [0, -1, 0]}]}]}


def plate(chance):
    x, y, z = (chance.uniform(0.3, 0.6) for _ in range(3))
    return f"v {-x} 0 -0.5\nv {x} {y} -0.5\nv {x} 0 {z}\nv {-x} 0 0.5\nf 1 4 3\nf 1 3 2\n"


class Batch(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.chance = random.Random(SEED)
        self.names = [f"plate{i:05}" for i in range(MESHES)]
        for name in self.names:
            with open(os.path.join(self.folder, name + ".obj"), "w") as file:
                file.write(plate(self.chance))
        with open(os.path.join(self.folder, "slot.json"), "w") as file:
            json.dump(PATH, file)
        os.mkdir(os.path.join(self.folder, "out"))

    def start(self):
        """The jobs of all meshes that have no report, two at a time, in a group of processes of their own."""
        runner = ["parallel", "-j2", JOB] if shutil.which("parallel") else ["xargs", "-P2", "-I{}", "sh", "-c", JOB]
        names = "\n".join(self.names)
        batch = subprocess.Popen(runner, cwd=self.folder, env=dict(os.environ, KERF=KERF), stdin=subprocess.PIPE,
                                 stderr=subprocess.DEVNULL, text=True, start_new_session=True)
        threading.Thread(target=self.feed, args=(batch, names), daemon=True).start()
        return batch

    def feed(self, batch, names):
        try:
            with batch.stdin:
                batch.stdin.write(names)
        except BrokenPipeError:
            pass

    def finished(self):
        return sum(os.path.exists(os.path.join(self.folder, "out", name, "report.json")) for name in self.names)

    def results(self, out):
        """The files of each job: the pieces by their bytes, and what the report says of the cut."""
        found = {}
        for name in sorted(os.listdir(out)):
            files = {}
            for file in sorted(os.listdir(os.path.join(out, name))):
                with open(os.path.join(out, name, file), "rb") as content:
                    files[file] = hashlib.sha256(content.read()).hexdigest()
            with open(os.path.join(out, name, "report.json")) as report:
                files["report.json"] = json.load(report)["state_hash"]
            found[name] = files
        return found

    def test_killed_jobs_resume_to_the_results_of_undisturbed_ones(self):
        kills = 0
        while self.finished() < MESHES:
            batch = self.start()
            goal = self.finished() + self.chance.randint(1, max(2, MESHES // 20))
            while batch.poll() is None and self.finished() < goal:
                time.sleep(0.01)
            if batch.poll() is None and kills < 15:
                os.killpg(batch.pid, signal.SIGKILL)
                kills += 1
            batch.wait()
        killed = self.results(os.path.join(self.folder, "out"))
        shutil.rmtree(os.path.join(self.folder, "out"))
        os.mkdir(os.path.join(self.folder, "out"))
        self.start().wait()
        self.assertGreater(kills, 0)
        self.assertEqual(self.results(os.path.join(self.folder, "out")), killed, f"seed {SEED}")
        print(f"{MESHES} meshes, {kills} kills, seed {SEED}", file=sys.stderr)


if __name__ == "__main__":
    unittest.main()
