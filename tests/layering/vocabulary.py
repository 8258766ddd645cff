#!/usr/bin/env python3
"""The vocabulary of strings, comments, pages and identifiers: terms of the field, and no others for the same thing.

vocabulary.py ROOT prints the count of each retired term, each place where one stands, and exits with 1 if there is
one that EXCEPTIONS does not name.
"""
import collections
import os
import re
import sys

# A retired term and what to write instead.
TERMS = {
    r'[Ww]hoever': 'a noun: the user, the caller',
    r'\banew\b': 'again',
    r'\b(?:hang|hangs|hung) together\b': 'are connected',
    r'\bto be called\b': 'an imperative: call ...',
    r'\b(?:is|are) told\b': 'reports, receives',
    r'\bis said\b': 'reports',
    r'\bany more\b': 'no longer',
    r'\bso many\b': 'the number',
    r'\b(?:taken|takes|take|took) (?:\w+ ){0,3}back\b': 'undo',
    r'\blooked at\b': 'visited, inspected',
    r'\baverted\b': 'back-facing',
    r'\bchosen\b|\bchoose[sn]?\b': 'selected, select',
    r'\bbeside\b': 'next to, compared with, in addition to',
    r'\bgone\b|\bwent\b': 'removed',
    r'\blets? go\b': 'releases',
    r'\bborn\b': 'created',
    r'\bNothing (?:if|where)\b': 'Returns nullopt if',
    r'(?:^|[.:] )(?:What|Whoever|Of the|Those|That of|Of what) '
    r'(?:is|was|are|were|it|the|a|has|had|holds?|stands?)\b': 'a noun as the subject',
    r'\boutsiders?\b': 'client code',
    r'\bin hand\b': 'active',
}
NAMES = {
    r'\bkMost[A-Z]': 'kMax', r'\bkLeast[A-Z]': 'kMin', r'\bmost_faces\b': 'max_faces', r'\blet_go\b': 'release',
    r'\bwhy_not\b': 'disabled_reason', r'\bnote_[a-z]': 'record_', r'\btake_back\b': 'undo', r'\bon_\.': 'workspace_',
    r'\bfulfil\b': 'process', r'\bHeard\b': 'InputState', r'\bStudio\b': 'OffscreenRenderer',
    r'\bnamespace face\b': 'namespace api', r'\bthrow_unless_ok\b': 'check', r'\bweigh\(': 'update_mass_properties(',
    r'\bwhy_no_': '..._disabled_reason', r'\bResumable\b': 'Task', r'\b(?:Heeded|HeldPress)': 'Tracked..., DeferredPress',
    r'\bhear(?:d)?_?\b(?=[(;])': 'handle_', r'\bchoose_': 'select_',
    r'\bMeanwhile\b': 'EditPolicy', r'\bmust_go_on\b': 'is_uninterruptible',
}
# Texts that stay, with the reason.
EXCEPTIONS = {
    ('app/inspect_command.cpp', 'born'): 'a key of the output of `kerf inspect`',
    ('app/inspect_command.cpp', 'gone'): 'a key of the output of `kerf inspect`',
    ('ui/editor/shared/settings.cpp', 'chosen'): 'labels of settings files of before',
    ('ui/editor/shared/settings.cpp', 'gone'): 'labels of settings files of before',
    ('ui/figures/draw_figure.cpp', 'What is'): 'drawn into a committed picture of the paper',
}
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')


def sources(root):
    for top in ('core', 'ui', 'app'):
        for folder, _, files in os.walk(os.path.join(root, top)):
            for name in sorted(files):
                if name.endswith(('.h', '.cpp', '.c', '.md', '.py', '.pyi')):
                    yield os.path.relpath(os.path.join(folder, name), root)
    yield 'README.md'


def prose(path, line):
    """The strings and the comment of a line of code; all of a line of a page."""
    if path.endswith('.md'):
        return line
    mark = '# ' if path.endswith(('.py', '.pyi')) else '//'
    comment = line.split(mark, 1)[1] if mark in line else ''
    return ' '.join(STRING.findall(line)) + ' . ' + comment


def is_exception(path, found):
    return any(path == place and word in found for place, word in EXCEPTIONS)


def breaches(root):
    """(path, line, term found, what to write instead) for each retired term below root."""
    for path in sources(root):
        with open(os.path.join(root, path), encoding='utf-8', errors='replace') as lines:
            for number, line in enumerate(lines, 1):
                checked = [(TERMS, prose(path, line.rstrip('\n')))]
                if not path.endswith('.md'):
                    checked.append((NAMES, line))
                for terms, text in checked:
                    for term, instead in terms.items():
                        for found in re.finditer(term, text):
                            if not is_exception(path, found[0]):
                                yield path, number, found[0].strip('. :'), instead


def main(root):
    counts = collections.Counter()
    for path, number, found, instead in breaches(root):
        counts[found] += 1
        print(f'{path}:{number}: "{found}": write {instead}')
    for found, count in counts.most_common():
        print(f'{count} x {found}')
    return 1 if counts else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
