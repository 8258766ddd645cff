#!/usr/bin/env python3
"""Runs fuzzers: run_fuzzers.py --folder FOLDER [--seconds N] [--quiet N] [--keep] TARGET...

FOLDER holds the executables fuzz_TARGET. Each runs from the seeds in corpus/TARGET, from the archive of inputs in
corpus and from what earlier runs found in FOLDER/found/TARGET, until `seconds` are over or `quiet` seconds have brought
no new coverage; two run at a time. Strokes run as long twice: short histories, some hundred a second, and long ones, a
few a second, which begin from some of those found. Prints a line each with the number of covered edges, and where one
breaks, what it said and the file that broke it, kept in FOLDER/findings; the last line sums the inputs. `--keep` writes
the archive again: the fewest inputs that cover what the found ones do and the seeds do not. Exits 1 on a finding, 77
where there is no fuzzer.
"""
import argparse
import concurrent.futures
import os
import re
import selectors
import shutil
import signal
import subprocess
import sys
import tarfile
import time

HERE = os.path.dirname(os.path.realpath(__file__))
AT_A_TIME = 2
INTERRUPTED = 72  # how a fuzzer ends that was interrupted
# A reader that allocates this for an input of some kilobytes trusted a count that the file cannot hold.
LIMITS = ['-max_len=8192', '-timeout=10', '-rss_limit_mb=1024', '-malloc_limit_mb=64']
# Each byte of a history is worked on longer. How often each feature was seen would take a fifth of the time.
OF_STROKES = ['-timeout=180', '-report_slow_units=60', '-rss_limit_mb=2048', '-entropic=0']
SHORT, LONG = ['-max_len=64', *OF_STROKES], ['-max_len=300', *OF_STROKES]
OF = {'images': ['-max_len=8192', '-timeout=20', '-rss_limit_mb=2048', '-malloc_limit_mb=1024'],
      'drawings': ['-max_len=8192', '-timeout=60', '-rss_limit_mb=2048', '-malloc_limit_mb=1024'],
      'library': ['-max_len=512', '-timeout=60', '-rss_limit_mb=2048', '-malloc_limit_mb=1024']}
MOST_LONG = 64  # that are kept for the next run to begin from: each takes a part of a second


def runs_of(targets):
    """(name, target, limits of the fuzzer)"""
    for target in targets:
        if target == 'strokes':
            yield 'short_strokes', target, SHORT
            yield 'long_strokes', target, LONG
        else:
            yield target, target, OF.get(target, LIMITS)


def environment():
    # The leak check needs ptrace, which containers often refuse.
    return {**os.environ, 'ASAN_OPTIONS': 'detect_leaks=0', 'UBSAN_OPTIONS': 'print_stacktrace=1',
            'KERF_ASSERTS': 'fatal', 'KERF_THREADS': '1'}


def seeds(target):
    return os.path.join(HERE, 'corpus', target)


def archive(name):
    return os.path.join(HERE, 'corpus', name + '.tar.xz')


def unpack(name, folder):
    if not os.path.exists(archive(name)):
        return
    with tarfile.open(archive(name)) as tar:
        for member in tar:
            with open(os.path.join(folder, os.path.basename(member.name)), 'wb') as file:
                file.write(tar.extractfile(member).read())


def follow(fuzzer, seconds, quiet):
    """Reads what a fuzzer says to its end; interrupts it after `quiet` seconds without new coverage."""
    said, covered, last, ended = [], 0, time.monotonic(), False
    end = last + 2 * seconds + 300
    selector = selectors.DefaultSelector()
    selector.register(fuzzer.stderr, selectors.EVENT_READ)
    while True:
        if selector.select(timeout=1):
            line = fuzzer.stderr.readline()
            if not line:
                return said, covered, ended
            said.append(line)
            found = re.search(r'\bcov: (\d+)', line)
            if found and int(found[1]) > covered:
                covered, last = int(found[1]), time.monotonic()
        if not ended and time.monotonic() > last + quiet:
            fuzzer.send_signal(signal.SIGINT)
            ended = True
        if time.monotonic() > end:
            fuzzer.kill()
            said.append(f'did not end within {2 * seconds + 300} s\n')


def fuzz(folder, name, target, limits, seconds, quiet):
    """(runs, covered edges, whether it broke, what the fuzzer said)"""
    found, findings = os.path.join(folder, 'found', name), os.path.join(folder, 'findings')
    os.makedirs(found, exist_ok=True)
    os.makedirs(findings, exist_ok=True)
    unpack(name, found)
    if limits is LONG:
        for path in sorted(os.path.join(found, file) for file in os.listdir(found))[MOST_LONG:]:
            os.remove(path)
    saved = [seeds(target)] if limits is not SHORT and os.path.isdir(seeds(target)) else []
    command = [os.path.join(folder, 'fuzz_' + target), found, *saved,
               f'-artifact_prefix={findings}/{name}-', f'-max_total_time={seconds}', '-print_final_stats=1', *limits]
    words = seeds(target) + '.dict'
    command += [f'-dict={words}'] if os.path.exists(words) else []
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors='replace',
                          bufsize=1, env=environment()) as fuzzer:
        said, covered, ended = follow(fuzzer, seconds, quiet)
    runs = [int(line.split()[1]) for line in said if line.startswith('stat::number_of_executed_units')]
    return runs[-1] if runs else 0, covered, fuzzer.returncode not in (0, INTERRUPTED if ended else 0), said


def keep(folder, name, target, limits):
    """Writes the archive of the inputs that were found, minimised; the number of inputs and its bytes."""
    kept, found = os.path.join(folder, 'kept', name), os.path.join(folder, 'found', name)
    shutil.rmtree(kept, ignore_errors=True)
    given = os.listdir(seeds(target)) if os.path.isdir(seeds(target)) else []
    os.makedirs(kept)
    for file in given:
        shutil.copy(os.path.join(seeds(target), file), kept)
    subprocess.run([os.path.join(folder, 'fuzz_' + target), '-merge=1', kept, found, *limits], capture_output=True,
                   env=environment())
    inputs = sorted(set(os.listdir(kept)) - set(given))
    with tarfile.open(archive(name), 'w:xz') as tar:
        for file in inputs:
            member = tarfile.TarInfo(file)
            member.size = os.path.getsize(os.path.join(kept, file))
            with open(os.path.join(kept, file), 'rb') as content:
                tar.addfile(member, content)
    return len(inputs), os.path.getsize(archive(name))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--folder', required=True)
    parser.add_argument('--seconds', type=int, default=10)
    parser.add_argument('--quiet', type=int, default=1 << 30, help='seconds without new coverage that end a run')
    parser.add_argument('--keep', action='store_true', help='write the archives of inputs again')
    parser.add_argument('targets', nargs='+')
    arguments = parser.parse_args()
    if arguments.seconds < 1:
        parser.error('--seconds must be 1 or more')
    missing = [name for name in arguments.targets if not os.path.exists(os.path.join(arguments.folder, 'fuzz_' + name))]
    if missing:
        print(f'skipped: no fuzzer {", ".join(missing)}; they are built where there is clang++ with libFuzzer')
        return 77
    broken, inputs, edges = 0, 0, 0
    with concurrent.futures.ThreadPoolExecutor(AT_A_TIME) as pool:
        planned = list(runs_of(arguments.targets))
        results = pool.map(lambda run: fuzz(arguments.folder, *run, arguments.seconds, arguments.quiet), planned)
        for (name, target, limits), (runs, covered, broke, said) in zip(planned, results):
            ending = '1 finding' if broke else 'no finding'
            inputs, edges = inputs + runs, edges + covered
            print(f'{name:13} {runs:12,} runs, {covered:7,} edges, {ending}', flush=True)
            if broke:
                broken += 1
                print(''.join(said[-60:]))
            elif arguments.keep:
                files, size = keep(arguments.folder, name, target, limits)
                print(f'{"":13} {files:,} inputs are kept in {size:,} bytes', flush=True)
    print(f'{inputs:,} inputs, {edges:,} edges', flush=True)
    return 1 if broken else 0


if __name__ == '__main__':
    sys.exit(main())
