#!/usr/bin/env python3
"""Results depend on the world and the command alone: shuffled_test.py KERF CHECKOUT.

Each case, made from a seed, runs twice: as it is, and with KERF_SHUFFLE, which lists the results of queries in random
order, rebuilds trees in other shapes and processes 1, 17, 128 or 3,000 faces together, on 1, 2 or 7 threads. Hashes and
files have to be equal. Cases are random strokes of all schemes, rims and models through sheets and solids, with pieces
that fall, replayed journals with undo and redo, and matches. KERF_LONG=1 runs a thousand cases instead of twenty quick
ones.
"""
import filecmp
import json
import math
import os
import random
import subprocess
import sys
import tempfile

KERF, CHECKOUT = sys.argv[1:3]
MESHES = [os.path.join(CHECKOUT, "assets/meshes", name) for name in ("bracket.obj", "knot.obj", "plate.obj", "sphere.obj")]
KEPT = os.path.join(CHECKOUT, "tests/kept")


def run(arguments, shuffled=None):
    environment = {name: value for name, value in os.environ.items() if not name.startswith("KERF_SHUFFLE")}
    if shuffled:
        environment["KERF_SHUFFLE"], environment["KERF_THREADS"] = shuffled
    done = subprocess.run([KERF, *arguments], env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"kerf {' '.join(arguments)} ended with {done.returncode}, shuffle {shuffled}:\n{done.stderr}")
    return done.stdout


def vector(rng, size):
    return [rng.uniform(-size, size) for _ in range(3)]


def random_strokes(rng, bounds):
    """One to three strokes from outside through the middle of the bounds; each turns a little on its way."""
    low, high = bounds["min"], bounds["max"]
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    size = sum((b - a) ** 2 for a, b in zip(low, high)) ** 0.5
    strokes = []
    for _ in range(rng.randint(1, 3)):
        towards, across = vector(rng, 1), vector(rng, 0.5 * size)
        length = sum(x * x for x in towards) ** 0.5
        towards = [x / length for x in towards]
        keys = []
        for t in range(rng.randint(2, 4)):
            at = [m - size * d + (t - 1) * a + o for m, d, a, o in zip(middle, towards, across, vector(rng, 0.02 * size))]
            keys.append({"t": 0.2 * t, "origin": at, "direction": [d + o for d, o in zip(towards, vector(rng, 0.03))]})
        strokes.append({"laser": {"radius": size / rng.uniform(40, 150), "range": [0, 10 * size], "power": 4000},
                        "keys": keys})
    return {"strokes": strokes}


def cut_case(rng, folder):
    mesh = rng.choice(MESHES)
    bounds = json.loads(run(["info", mesh]))["bounds"]
    size = math.dist(bounds["min"], bounds["max"])
    path = os.path.join(folder, "path.json")
    with open(path, "w") as file:
        json.dump(random_strokes(rng, bounds), file)
    options = ["--scheme", rng.choice(["longest-edge", "one-to-four"])]
    options += rng.choice([["--rim", "faces"], ["--rim", "smooth"], ["--solid"], ["--pattern", "rays4"],
                           ["--model", "thermal", "--material", "mild-steel", "--power", "40000",
                            "--target-edge", str(size / 20)]])
    if rng.random() < 0.4:
        options += ["--settle", "0.3"]
    return ["cut", mesh, "--path", path, *options]


def same(a, b):
    """Equal, but for the last bits of sums, which are added up step by step."""
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(same(a[key], b[key]) for key in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, float) and isinstance(b, float):
        return math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-15)
    return a == b


def compare_cuts(rng, shuffled, folder):
    arguments = cut_case(rng, folder)
    reports = []
    for name, how in (("plain", None), ("shuffled", shuffled)):
        out = os.path.join(folder, name)
        run([*arguments, "--out", out], how)
        with open(os.path.join(out, "report.json")) as file:
            report = json.load(file)
        del report["timing_ms"], report["command"]  # which names the output folder
        reports.append(report)
    pieces = [piece["file"] for piece in reports[0]["pieces"]]
    equal = filecmp.cmpfiles(os.path.join(folder, "plain"), os.path.join(folder, "shuffled"), pieces, shallow=False)[0]
    return same(*reports) and equal == pieces, arguments


def compare_replays(rng, shuffled, folder):
    journals = sorted(name for name in os.listdir(KEPT) if name.endswith(".kerf"))
    arguments = ["replay", os.path.join(KEPT, rng.choice(journals))]
    return run(arguments) == run(arguments, shuffled), arguments


def compare_matches(rng, shuffled, folder):
    report = os.path.join(folder, "match.json")
    arguments = ["play", "--headless", "--driver", "bot", "--seconds", "6", "--seed", str(rng.randint(1, 99)),
                 "--report", report]
    hashes = []
    for how in (None, shuffled):
        run(arguments, how)
        with open(report) as file:
            hashes.append(json.load(file)["state_hash"])
    return hashes[0] == hashes[1], arguments


def main():
    seeds = range(1, 1001) if os.environ.get("KERF_LONG") else range(13, 33)
    for seed in seeds:
        rng = random.Random(seed)
        kind = {3: compare_replays, 7: compare_replays, 9: compare_matches}.get(seed % 10, compare_cuts)
        shuffled = str(seed), rng.choice(["1", "2", "7"])
        with tempfile.TemporaryDirectory() as folder:
            equal, arguments = kind(rng, shuffled, folder)
            if not equal:
                sys.exit(f"seed {seed}: another result with KERF_SHUFFLE={shuffled[0]} KERF_THREADS={shuffled[1]}: "
                         f"kerf {' '.join(arguments)}")
    print(f"{len(seeds)} cases with equal results")


if __name__ == "__main__":
    main()
