#!/usr/bin/env python3
"""Breaks one line at a time of the sources of rooms of core, in a copy of the tree, and says whether the tests of the
room notice: mutants.py --folder FOLDER [--seed N] [--count N] [--first K] [--only N,N...] [ROOM...]

FOLDER holds the copy of the last commit and its build; both are made where they are missing and brought up to date
where they are not. What is broken follows from the seed: mutants K to K + count - 1 of an endless list. A mutant that
compiles to the same objects is passed over. Prints one line each, and the survivors again in the end. Exits 1 where
one survived.
"""
import argparse
import glob
import hashlib
import os
import random
import re
import shutil
import subprocess
import sys
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
ROOMS = ['cut', 'walls', 'edit', 'graph', 'heat', 'physics', 'document']
ALSO = {'walls': ['CloseByWalls', 'SolidStrokes']}  # tests of a room that stand in another one
LONGEST = 90  # s, of a room's tests

SWAPS = [(' < ', ' <= '), (' <= ', ' < '), (' > ', ' >= '), (' >= ', ' > '), (' < ', ' > '), (' > ', ' < '),
         (' == ', ' != '), (' != ', ' == '), (' && ', ' || '), (' || ', ' && '),
         (' + ', ' - '), (' - ', ' + '), (' += ', ' -= '), (' -= ', ' += '), (' * ', ' / '), (' / ', ' * '),
         ('return true;', 'return false;'), ('return false;', 'return true;'), ('if (!', 'if ('),
         ('std::min', 'std::max'), ('std::max', 'std::min'), ('continue;', 'break;'), ('break;', 'continue;')]
NUMBER = re.compile(r'(?<![\w.])(\d+(?:\.\d+)?(?:e-?\d+)?)(?![\w.]*[\w])')
CALL = re.compile(r'^\s+[a-z_][\w.>:\[\]-]*\([^;]*\);$')


def code_lines(lines):
    """The indices of lines that are code and no assertion."""
    asserts = False
    for i, line in enumerate(lines):
        text = line.strip()
        asserts = asserts or text.startswith(('KERF_ASSERT', 'static_assert', 'assert('))
        if text and not asserts and not text.startswith(('//', '#', 'namespace', 'using', 'template')):
            yield i
        asserts = asserts and not text.endswith(';')


def variants(line):
    """What the line may become."""
    code, _, _ = line.partition('//')
    found = []
    for old, new in SWAPS:
        for match in re.finditer(re.escape(old), code):
            found.append(code[:match.start()] + new + code[match.end():])
    for match in NUMBER.finditer(code):
        number = match[1]
        other = str(int(number) + 1) if number.isdigit() else repr(2 * float(number))
        if '0.0' not in (number, other):
            found.append(code[:match.start()] + other + code[match.end():])
    if CALL.match(code.rstrip()) and not code.strip().startswith(('return', 'throw')):
        found.append('')
    return found


def mutants(folder, rooms, seed):
    """An endless list of (room, file, number of the line, new line), each once."""
    choice = random.Random(seed)
    files = [(room, path) for room in rooms
             for path in sorted(glob.glob(f'{folder}/core/{room}/**/*.cpp', recursive=True))]
    lines = {path: open(path).read().split('\n') for _, path in files}
    all_lines = [(room, path, i) for room, path in files for i in code_lines(lines[path]) if variants(lines[path][i])]
    seen = set()
    while True:
        room, path, i = choice.choice(all_lines)
        new = choice.choice(variants(lines[path][i]))
        if (path, i, new) in seen or new.strip() == lines[path][i].strip():
            continue
        seen.add((path, i, new))
        yield room, path, i, new


def suites(folder, room):
    found = set(ALSO.get(room, []))
    for path in glob.glob(f'{folder}/tests/core/{room}/**/*.cpp', recursive=True):
        found |= set(re.findall(r'^TEST(?:_[FP])?\((\w+),', open(path).read(), re.M))
    return ':'.join(sorted(f'{suite}.*' for suite in found))


def build(folder, target):
    done = subprocess.run(['ninja', '-C', f'{folder}/build', target], capture_output=True, text=True)
    return done.returncode == 0


def objects(folder):
    return {path: hashlib.sha1(open(path, 'rb').read()).hexdigest()
            for path in glob.glob(f'{folder}/build/core/**/*.o', recursive=True)}


def noticed(folder, room):
    """How the tests of the room end: 'failed', 'time' or 'passed'."""
    command = [f'{folder}/build/tests/kerf_core_tests', '--gtest_brief=1', '--gtest_fail_fast',
               '--gtest_filter=' + suites(folder, room)]
    shards = [subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               env={**os.environ, 'KERF_ASSERTS': 'fatal', 'GTEST_TOTAL_SHARDS': '2',
                                    'GTEST_SHARD_INDEX': str(shard)}) for shard in range(2)]
    end = time.monotonic() + LONGEST
    result = 'passed'
    while any(shard.poll() is None for shard in shards):
        if any(shard.poll() not in (None, 0) for shard in shards):
            break
        if time.monotonic() > end:
            result = 'time'
            break
        time.sleep(0.05)
    if any(shard.poll() not in (None, 0) for shard in shards):
        result = 'failed'
    for shard in shards:
        shard.kill()
        shard.wait()
    return result


def bring_up_to_date(folder):
    os.makedirs(folder, exist_ok=True)
    for name in sorted(set(os.listdir(folder)) - {'build'}):
        path = f'{folder}/{name}'
        if os.path.isdir(path):
            shutil.rmtree(path)
        else:
            os.remove(path)
    archive = subprocess.Popen(['git', '-C', ROOT, 'archive', 'HEAD'], stdout=subprocess.PIPE)
    subprocess.run(['tar', '-x', '-C', folder], stdin=archive.stdout, check=True)
    if not os.path.exists(f'{folder}/build/build.ninja'):
        subprocess.run(['cmake', '-S', folder, '-B', f'{folder}/build', '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release'],
                       check=True, stdout=subprocess.DEVNULL)
    if not build(folder, 'kerf_core_tests'):
        sys.exit('the copy cannot be built')


def try_one(folder, whole, room, path, i, new):
    """What becomes of the mutant; None where it is none. The file is put back."""
    text = open(path).read()
    lines = text.split('\n')
    lines[i] = new
    try:
        with open(path, 'w') as file:
            file.write('\n'.join(lines))
        if not build(folder, 'kerf_core') or objects(folder) == whole:
            return None
        return noticed(folder, room) if build(folder, 'kerf_core_tests') else None
    finally:
        with open(path, 'w') as file:
            file.write(text)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--folder', required=True)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--count', type=int, default=100)
    parser.add_argument('--first', type=int, default=0)
    parser.add_argument('--only', type=lambda text: {int(n) for n in text.split(',')}, help='numbers, as in 1,2,7')
    parser.add_argument('rooms', nargs='*', default=ROOMS)
    arguments = parser.parse_args()
    folder = os.path.realpath(arguments.folder)
    bring_up_to_date(folder)
    whole = objects(folder)
    counts, survivors, tried = {'failed': 0, 'time': 0, 'passed': 0}, [], 0
    for number, (room, path, i, new) in enumerate(mutants(folder, arguments.rooms, arguments.seed)):
        if number < arguments.first or (arguments.only and number not in arguments.only):
            continue
        if tried == (len(arguments.only) if arguments.only else arguments.count):
            break
        old = open(path).read().split('\n')[i]
        result = try_one(folder, whole, room, path, i, new)
        if result is None:
            continue
        tried += 1
        counts[result] += 1
        where = f'{os.path.relpath(path, folder)}:{i + 1}'
        line = f'{number:4} {result:6} {where}: {old.strip()}  ->  {new.strip() or "(left out)"}'
        print(line, flush=True)
        if result == 'passed':
            survivors.append(line)
    print(f'{tried} mutants of seed {arguments.seed}: {counts["failed"]} failed, {counts["time"]} took longer than '
          f'{LONGEST} s, {counts["passed"]} survived')
    print('\n'.join(survivors))
    return 1 if survivors else 0


if __name__ == '__main__':
    sys.exit(main())
