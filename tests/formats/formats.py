#!/usr/bin/env python3
"""Fails on a format of a number in a widget that the compiler does not check.

formats.py ROOT prints `file:line: why` for each breach below ROOT/ui and exits with 1 if there is one. Widgets for
numbers take their format as a plain pointer; it has to come from RealFormat or WholeFormat (see
ui/window/number_text.h).
"""
import os
import re
import sys

WIDGET = re.compile(r'ImGui::V?(?:Slider|Drag|Input)(?:Float|Int|Scalar|Double|Angle)\w*\(')
STRING = r'"(?:[^"\\]|\\.)*"'
CHECKED = re.compile(rf'\b(?:RealFormat|WholeFormat)\({STRING}\)')
POINTER = re.compile(r'const char ?\* ?(?:const )?format\b(?!, \.\.\.)')


def breaches(root):
    """Every breach below root/ui, as (file, line, why); file is relative to root."""
    found = []
    for folder, folders, files in os.walk(os.path.join(root, 'ui')):
        folders.sort()
        for name in sorted(files):
            if not name.endswith(('.cpp', '.h')):
                continue
            path = os.path.join(folder, name)
            with open(path, encoding='utf-8') as source:
                text = source.read()
            found += [(os.path.relpath(path, root), line, why) for line, why in breaches_in(text)]
    return found


def breaches_in(text):
    for call in WIDGET.finditer(text):
        arguments = CHECKED.sub('', text[call.end():end_of_call(text, call.end())])
        if any('%' in literal for literal in re.findall(STRING, arguments)):
            yield line_of(text, call.start()), 'the format of this widget is not checked: use RealFormat or WholeFormat'
    for pointer in POINTER.finditer(text):
        yield line_of(text, pointer.start()), 'a format that is handed on is not checked: take a RealFormat'


def end_of_call(text, begin):
    depth = 1
    for token in re.finditer(rf'{STRING}|[()]', text[begin:]):
        depth += {'(': 1, ')': -1}.get(token[0], 0)
        if depth == 0:
            return begin + token.start()
    return len(text)


def line_of(text, at):
    return text.count('\n', 0, at) + 1


if __name__ == '__main__':
    all_found = breaches(sys.argv[1])
    for path, line, why in all_found:
        print(f'{path}:{line}: {why}')
    sys.exit(1 if all_found else 0)
