"""Results have the same bits on two kinds of machine: `other_machine.py CHECKOUT HERE THERE CASES EMULATOR...`.

HERE and THERE are folders with made_cuts and hash_cases, built for this machine and for the other one, whose programs
EMULATOR runs. CASES is the number of random strokes; the other kinds have as many or fewer. Lists the number of equal
lines by kind and the first difference of each kind. Fails if there is one where no body moves.
"""
import concurrent.futures
import os
import subprocess
import sys
import time

MESHES = ("bracket.obj", "knot.obj", "plate.obj")
# Kinds of hash_cases, those that take long first, and the share of CASES.
SHARES = {"prepare": 0.2, "heat": 0.5, "fall": 0.2, "solid": 1, "stroke": 1, "shadow": 1}

# Kinds of lines with moving bodies, whose bits depend on the kind of machine (core/physics/physics.h).
MOTION = {"fall", "journal", "match"}


def lines_of(command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)} ended with {done.returncode}:\n{done.stderr}")
    return done.stdout.splitlines()


def commands(checkout, cases):
    yield ["hash_cases", checkout, "kept", "0"]
    for kind, share in SHARES.items():
        yield ["hash_cases", checkout, kind, str(max(1, round(share * cases)))]
    yield ["made_cuts", *(os.path.join(checkout, "assets/meshes", name) for name in MESHES)]


def compare(here, there, emulator, command):
    """Returns counts of equal and different lines by kind, and texts of the first differences."""
    program, *arguments = command
    began = time.monotonic()
    wanted = lines_of([os.path.join(here, program), *arguments])
    found = lines_of([*emulator, os.path.join(there, program), *arguments])
    counts, differences = {}, {}
    if len(wanted) != len(found) or not wanted:
        differences[program] = f"{len(wanted)} lines here and {len(found)} there: {' '.join(command)}"
    for a, b in zip(wanted, found):
        kind = "made_cuts" if program == "made_cuts" else a.split(maxsplit=1)[0]
        count = counts.setdefault(kind, [0, 0])
        count[a != b] += 1
        if a != b:
            differences.setdefault(kind, f"here:  {a}\n  there: {b}")
    return counts, differences, time.monotonic() - began


def main(checkout, here, there, cases, *emulator):
    differences = {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        running = [pool.submit(compare, here, there, emulator, c) for c in commands(checkout, int(cases))]
        for done in concurrent.futures.as_completed(running):
            counts, different, seconds = done.result()
            differences |= different
            for kind, (equal, unequal) in counts.items():
                print(f"{kind}: {equal} of {equal + unequal} lines are equal ({seconds:.0f} s)", flush=True)
    for kind, text in differences.items():
        print(f"{kind}, the first difference{' of motion' if kind in MOTION else ''}:\n  {text}")
    sys.exit(1 if differences.keys() - MOTION else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
