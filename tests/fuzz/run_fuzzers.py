#!/usr/bin/env python3
"""Runs fuzzers: run_fuzzers.py --folder FOLDER [--seconds N] TARGET...

FOLDER holds the executables fuzz_TARGET. Each runs for N seconds from the saved corpus beside this file and from
what earlier runs found in FOLDER/found/TARGET; two run at a time. Strokes run as long twice: short histories, some
hundred a second, and long ones, a few a second, which begin from some of those found. Prints one line each, and where
one breaks, what it said and the file that broke it, kept in FOLDER/findings. Exits 1 on a finding, 77 where there is
no fuzzer.
"""
import argparse
import concurrent.futures
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.realpath(__file__))
AT_A_TIME = 2
# A reader that allocates this for an input of some kilobytes trusted a count that the file cannot hold.
LIMITS = ['-max_len=8192', '-timeout=10', '-rss_limit_mb=1024', '-malloc_limit_mb=64']
# Each byte of a history is worked on longer. How often each feature was seen would take a fifth of the time.
OF_STROKES = ['-timeout=180', '-report_slow_units=60', '-rss_limit_mb=2048', '-entropic=0']
SHORT, LONG = ['-max_len=64', *OF_STROKES], ['-max_len=300', *OF_STROKES]
OF_IMAGES = ['-max_len=8192', '-timeout=20', '-rss_limit_mb=2048', '-malloc_limit_mb=1024']
OF_DRAWINGS = ['-max_len=8192', '-timeout=60', '-rss_limit_mb=2048', '-malloc_limit_mb=1024']
OF_LIBRARY = ['-max_len=512', '-timeout=60', '-rss_limit_mb=2048', '-malloc_limit_mb=1024']
MOST_LONG = 64  # that are kept for the next run to begin from: each takes a part of a second


def runs_of(targets):
    """(name, target, limits of the fuzzer)"""
    for target in targets:
        if target == 'strokes':
            yield 'short_strokes', target, SHORT
            yield 'long_strokes', target, LONG
        else:
            yield target, target, {'library': OF_LIBRARY, 'images': OF_IMAGES, 'drawings': OF_DRAWINGS}.get(target, LIMITS)


def fuzz(folder, name, target, limits, seconds):
    """(runs, exit status, what the fuzzer said)"""
    found, findings = os.path.join(folder, 'found', name), os.path.join(folder, 'findings')
    os.makedirs(found, exist_ok=True)
    os.makedirs(findings, exist_ok=True)
    if limits is LONG:
        for path in sorted(os.path.join(found, file) for file in os.listdir(found))[MOST_LONG:]:
            os.remove(path)
    corpus = os.path.join(HERE, 'corpus', target)
    saved = [corpus] if limits is not SHORT and os.path.isdir(corpus) else []
    command = [os.path.join(folder, 'fuzz_' + target), found, *saved,
               f'-artifact_prefix={findings}/{name}-', f'-max_total_time={seconds}', '-print_final_stats=1', *limits]
    words = os.path.join(HERE, 'corpus', target + '.dict')
    command += [f'-dict={words}'] if os.path.exists(words) else []
    # The leak check needs ptrace, which containers often refuse.
    environment = {**os.environ, 'ASAN_OPTIONS': 'detect_leaks=0', 'UBSAN_OPTIONS': 'print_stacktrace=1',
                   'KERF_ASSERTS': 'fatal', 'KERF_THREADS': '1'}
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors='replace', env=environment,
                              timeout=2 * seconds + 300)
    except subprocess.TimeoutExpired:
        return 0, 1, f'did not end within {2 * seconds + 300} s'
    runs = re.search(r'stat::number_of_executed_units:\s*(\d+)', done.stderr)
    return int(runs[1]) if runs else 0, done.returncode, done.stderr


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--folder', required=True)
    parser.add_argument('--seconds', type=int, default=10)
    parser.add_argument('targets', nargs='+')
    arguments = parser.parse_args()
    if arguments.seconds < 1:
        parser.error('--seconds must be 1 or more')
    if not all(os.path.exists(os.path.join(arguments.folder, 'fuzz_' + target)) for target in arguments.targets):
        print('skipped: the fuzzers were not built, for there is no clang++ with libFuzzer')
        return 77
    broken = 0
    with concurrent.futures.ThreadPoolExecutor(AT_A_TIME) as pool:
        planned = list(runs_of(arguments.targets))
        results = pool.map(lambda run: fuzz(arguments.folder, *run, arguments.seconds), planned)
        for (name, _, _), (runs, status, said) in zip(planned, results):
            print(f'{name:13} {runs:12,} runs, {"1 finding" if status else "no finding"}', flush=True)
            if status:
                broken += 1
                print('\n'.join(said.strip().splitlines()[-60:]))
    return 1 if broken else 0


if __name__ == '__main__':
    sys.exit(main())
