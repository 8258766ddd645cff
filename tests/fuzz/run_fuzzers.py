#!/usr/bin/env python3
"""Runs fuzzers of the mesh readers: run_fuzzers.py --folder FOLDER [--seconds N] READER...

FOLDER holds the executables fuzz_READER. Each runs for N seconds from the saved corpus beside this file and from
what earlier runs found in FOLDER/found/READER; two run at a time. Prints one line a reader, and where one breaks,
what it said and the file that broke it, kept in FOLDER/findings. Exits 1 on a finding, 77 where there is no fuzzer.
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


def fuzz(folder, reader, seconds):
    """(runs, exit status, what the fuzzer said)"""
    found, findings = os.path.join(folder, 'found', reader), os.path.join(folder, 'findings')
    os.makedirs(found, exist_ok=True)
    os.makedirs(findings, exist_ok=True)
    command = [os.path.join(folder, 'fuzz_' + reader), found, os.path.join(HERE, 'corpus', reader),
               f'-dict={os.path.join(HERE, "corpus", reader + ".dict")}', f'-artifact_prefix={findings}/{reader}-',
               f'-max_total_time={seconds}', '-print_final_stats=1', *LIMITS]
    # The leak check needs ptrace, which containers often refuse.
    environment = {**os.environ, 'ASAN_OPTIONS': 'detect_leaks=0', 'UBSAN_OPTIONS': 'print_stacktrace=1'}
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors='replace', env=environment,
                              timeout=2 * seconds + 60)
    except subprocess.TimeoutExpired:
        return 0, 1, f'did not end within {2 * seconds + 60} s'
    runs = re.search(r'stat::number_of_executed_units:\s*(\d+)', done.stderr)
    return int(runs[1]) if runs else 0, done.returncode, done.stderr


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--folder', required=True)
    parser.add_argument('--seconds', type=int, default=10)
    parser.add_argument('readers', nargs='+')
    arguments = parser.parse_args()
    if arguments.seconds < 1:
        parser.error('--seconds must be 1 or more')
    if not all(os.path.exists(os.path.join(arguments.folder, 'fuzz_' + reader)) for reader in arguments.readers):
        print('skipped: the fuzzers were not built, for there is no clang++ with libFuzzer')
        return 77
    broken = 0
    with concurrent.futures.ThreadPoolExecutor(AT_A_TIME) as pool:
        results = pool.map(lambda reader: fuzz(arguments.folder, reader, arguments.seconds), arguments.readers)
        for reader, (runs, status, said) in zip(arguments.readers, results):
            print(f'{reader:4} {runs:12,} runs, {"1 finding" if status else "no finding"}', flush=True)
            if status:
                broken += 1
                print('\n'.join(said.strip().splitlines()[-60:]))
    return 1 if broken else 0


if __name__ == '__main__':
    sys.exit(main())
