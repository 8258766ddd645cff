#!/usr/bin/env python3
"""Breaks one line at a time of sources of the core, in a copy of the last commit, and lists the mutants that no test of
the core notices: mutants.py --copy FOLDER [--seed N] [--each N] [FOLDER_OF_CORE...]

The copy and its build are made where they are missing; FOLDER is new, empty or that of an earlier run. The mutants
follow from the seed. Each is tested by the suites of its own file, then by those of its folder, then by the quick ones
of all others, until one fails or takes three times as long as without a mutant. A mutant that compiles to the same
objects is passed over. Results are kept in FOLDER/mutants.jsonl, and a later run with the same seed and commit goes on
from there. Exits with 1 if one survived.
"""
import argparse
import datetime
import glob
import hashlib
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
FOLDERS = ['cut', 'edit', 'tree', 'mesh', 'document', 'physics']
QUICK = ['base', 'edit', 'graph', 'heat', 'joints', 'laser', 'mesh', 'physics', 'shadow', 'tree', 'walls', 'world']
SHARDS = 2

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


def mutants(copy, folder, seed):
    """An endless list of (file, index of the line, new line), each once."""
    choice = random.Random(f'{seed} {folder}')
    lines = {path: open(path).read().split('\n')
             for path in sorted(glob.glob(f'{copy}/core/{folder}/**/*.cpp', recursive=True))}
    all_lines = [(path, i) for path in lines for i in code_lines(lines[path]) if variants(lines[path][i])]
    seen = set()
    while True:
        path, i = choice.choice(all_lines)
        new = choice.choice(variants(lines[path][i]))
        if (path, i, new) in seen or new.strip() == lines[path][i].strip():
            continue
        seen.add((path, i, new))
        yield path, i, new


def suites_in(paths):
    found = set()
    for path in paths:
        found |= set(re.findall(r'^TEST(?:_[FP])?\((\w+),', open(path).read(), re.M))
    return found


def stages(copy, path):
    """The filters of the suites that test a mutant of a file, in order."""
    def of(folder):
        return suites_in(glob.glob(f'{copy}/tests/core/{folder}/**/*.cpp', recursive=True))
    folder = os.path.relpath(path, f'{copy}/core').split('/')[0]
    own = path.replace(f'{copy}/core/', f'{copy}/tests/core/').replace('.cpp', '_test.cpp')
    first = suites_in([own] if os.path.exists(own) else [])
    others = set().union(*(of(quick) for quick in QUICK if quick != folder))
    return [':'.join(sorted(f'{suite}.*:*/{suite}.*' for suite in suites))
            for suites in (first, of(folder) - first, others - of(folder)) if suites]


def build(copy, target):
    return subprocess.run(['ninja', '-C', f'{copy}/build', target], capture_output=True).returncode == 0


def objects(copy):
    return {path: hashlib.sha1(open(path, 'rb').read()).hexdigest()
            for path in glob.glob(f'{copy}/build/core/**/*.o', recursive=True)}


def run_tests(copy, tests, limit):
    """How the tests end ('failed', 'time' or 'passed'), and their processor time in seconds."""
    command = [f'{copy}/build/tests/kerf_core_tests', '--gtest_brief=1', '--gtest_fail_fast', f'--gtest_filter={tests}']
    before = os.times()
    limited = ['prlimit', f'--cpu={int(limit)}', '--as=8000000000', *command]
    settings = {**os.environ, 'KERF_ASSERTS': 'fatal', 'GTEST_TOTAL_SHARDS': str(SHARDS)}
    shards = [subprocess.Popen(limited, cwd=copy, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               env={**settings, 'GTEST_SHARD_INDEX': str(shard)}) for shard in range(SHARDS)]
    end = time.monotonic() + 4 * limit
    result = 'passed'
    while result == 'passed' and any(shard.poll() is None for shard in shards):
        if any(shard.poll() not in (None, 0) for shard in shards):
            result = 'failed'
        elif time.monotonic() > end:
            result = 'time'
        time.sleep(0.05)
    if any(shard.poll() not in (None, 0) for shard in shards):
        result = 'time' if any(shard.poll() == -signal.SIGXCPU for shard in shards) else 'failed'
    for shard in shards:
        shard.kill()
        shard.wait()
    after = os.times()
    return result, after.children_user + after.children_system - before.children_user - before.children_system


def bring_up_to_date(copy):
    os.makedirs(copy, exist_ok=True)
    if os.listdir(copy) and not os.path.exists(f'{copy}/mutants.jsonl'):
        sys.exit(f'{copy} has files that are not of an earlier run, and would lose them: name a new folder')
    open(f'{copy}/mutants.jsonl', 'a').close()
    for name in sorted(set(os.listdir(copy)) - {'build', 'mutants.jsonl'}):
        path = f'{copy}/{name}'
        if os.path.isdir(path):
            shutil.rmtree(path)
        else:
            os.remove(path)
    archive = subprocess.Popen(['git', '-C', ROOT, 'archive', 'HEAD'], stdout=subprocess.PIPE)
    subprocess.run(['tar', '-x', '-C', copy], stdin=archive.stdout, check=True)
    # Files of the core compile by themselves, as each mutant changes one; the tests compile faster in groups.
    with open(f'{copy}/tests/CMakeLists.txt', 'r+') as file:
        text = file.read()
        file.seek(0)
        file.write('set(KERF_SINGLE OFF)\n' + text)
    if not os.path.exists(f'{copy}/build/build.ninja'):
        subprocess.run(['cmake', '-S', copy, '-B', f'{copy}/build', '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release',
                        '-DKERF_SINGLE=ON'], check=True, stdout=subprocess.DEVNULL)
    if not build(copy, 'kerf_core_tests'):
        sys.exit('the copy cannot be built')


class Log:
    """Results by (seed, folder, number) of one commit, and times of suites, in a file with a line each."""

    def __init__(self, path, commit):
        self.path, self.commit, self.results = path, commit, {}
        for line in open(path) if os.path.exists(path) else []:
            entry = json.loads(line)
            if entry['commit'] == commit:
                self.results[tuple(entry['key'])] = entry['result']

    def add(self, key, result):
        self.results[tuple(key)] = result
        with open(self.path, 'a') as file:
            file.write(json.dumps({'commit': self.commit, 'key': key, 'result': result}) + '\n')


def try_one(copy, whole, log, path, i, new):
    """What becomes of the mutant; 'none' where it is none. The file is put back."""
    tests = stages(copy, path)
    for one in tests:
        if ('time', one) not in log.results:
            build(copy, 'kerf_core_tests')
            result, seconds = run_tests(copy, one, 1000)
            if result != 'passed':
                sys.exit(f'tests fail without a mutant: {one}')
            log.add(['time', one], seconds)
    text = open(path).read()
    lines = text.split('\n')
    lines[i] = new
    try:
        with open(path, 'w') as file:
            file.write('\n'.join(lines))
        if not build(copy, 'kerf_core') or objects(copy) == whole or not build(copy, 'kerf_core_tests'):
            return 'none'
        for one in tests:
            result, _ = run_tests(copy, one, 3 * log.results['time', one] + 10)
            if result != 'passed':
                return result
        return 'passed'
    finally:
        with open(path, 'w') as file:
            file.write(text)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--copy', required=True, help='folder of the copy, its build and the results')
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--each', type=int, default=50, help='mutants of each folder')
    parser.add_argument('folders', nargs='*', default=FOLDERS)
    arguments = parser.parse_args()
    copy = os.path.realpath(arguments.copy)
    bring_up_to_date(copy)
    commit = subprocess.check_output(['git', '-C', ROOT, 'rev-parse', '--short=10', 'HEAD'], text=True).strip()
    log = Log(f'{copy}/mutants.jsonl', commit)
    whole, survivors, killed = objects(copy), [], 0
    for folder in arguments.folders:
        counts = {'failed': 0, 'time': 0, 'passed': 0}
        for number, (path, i, new) in enumerate(mutants(copy, folder, arguments.seed)):
            if sum(counts.values()) == arguments.each:
                break
            key, old = [arguments.seed, folder, number], open(path).read().split('\n')[i]
            if tuple(key) not in log.results:
                log.add(key, try_one(copy, whole, log, path, i, new))
            result = log.results[tuple(key)]
            if result == 'none':
                continue
            counts[result] += 1
            where = f'{os.path.relpath(path, copy)}:{i + 1}'
            line = f'{number:4} {result:6} {where}: {old.strip()}  ->  {new.strip() or "(left out)"}'
            print(line, flush=True)
            if result == 'passed':
                survivors.append(line)
        dead = counts['failed'] + counts['time']
        killed += dead
        print(f'{folder}: {counts["failed"]} failed, {counts["time"]} took too long, {counts["passed"]} survived',
              flush=True)
        print(f'proof: tests/mutants/mutants.py {folder} | {dead} of {dead + counts["passed"]} mutants killed | '
              f'{datetime.date.today()} | {commit}', flush=True)
    print(f'{killed} of {killed + len(survivors)} mutants of seed {arguments.seed} are killed. Survivors:')
    print('\n'.join(survivors))
    return 1 if survivors else 0


if __name__ == '__main__':
    sys.exit(main())
