#!/usr/bin/env python3
"""Sizes of the tree: few files, each with one concept, in few folders.

file_counts.py ROOT prints the counts, and a line for each one beyond its limit, with exit code 1.
"""
import os
import re
import statistics
import sys

MAX_FILES, MIN_MEDIAN, MAX_LINES, MAX_FOLDERS, MAX_DEPTH = 650, 120, 700, 48, 3


def line_counts(root):
    """Lines of each C++ source of the product, by path."""
    counts = {}
    for top in ('core', 'ui', 'app'):
        for folder, _, files in os.walk(os.path.join(root, top)):
            for name in files:
                if re.search(r'\.(h|cpp|c)$', name):
                    with open(os.path.join(folder, name), encoding='utf-8') as file:
                        counts[os.path.relpath(os.path.join(folder, name), root)] = sum(1 for _ in file)
    return counts


def main(root):
    counts = line_counts(root)
    folders = {os.path.dirname(path) for path in counts}
    median, (longest, lines) = statistics.median(counts.values()), max(counts.items(), key=lambda item: item[1])
    depth = max(folder.count('/') + 1 for folder in folders)
    print(f'{len(counts)} files, median {median:g} lines, longest {lines} ({longest}), {len(folders)} folders, '
          f'{sum(counts.values())} lines')
    wrong = [text for text, bad in (
        (f'files: {len(counts)}, at most {MAX_FILES}', len(counts) > MAX_FILES),
        (f'short files: median {median:g}, at least {MIN_MEDIAN}', median < MIN_MEDIAN),
        (f'lines in {longest}: {lines}, at most {MAX_LINES}', lines > MAX_LINES),
        (f'folders: {len(folders)}, at most {MAX_FOLDERS}', len(folders) > MAX_FOLDERS),
        (f'levels of folders: {depth}, at most {MAX_DEPTH}', depth > MAX_DEPTH)) if bad]
    for text in wrong:
        print('beyond the limit:', text)
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
