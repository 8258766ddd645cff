#!/usr/bin/env python3
"""Names that two sources of one group declare in their anonymous namespaces.

The sources of a folder are compiled together (core/group_sources.cmake), so such a name does not compile, and the
compiler reports it far from its cause. group_names.py ROOT prints `file: name is also in file` and exits with 1 if
there is one.
"""
import os
import re
import sys

MIN_MEMBERS = 6  # sources of a folder with groups of its own; smaller folders join the one above
TYPE = re.compile(r'(?:struct|class|enum class|union) (\w+)(?!.*;$)')
ALIAS = re.compile(r'using (\w+) =')
CONSTANT = re.compile(r'(?:static |inline )?(?:constexpr|const|constinit) [^(=;]*?\b(\w+)(?:\[[^\]]*\])?\s*(?:=|\{|\()')
FUNCTION = re.compile(r'(?:template .*> ?)?[\w:<>,&*\[\] ]+?[ &*](\w+)\(')


def groups(root):
    """The sources that may be compiled together, as lists of paths."""
    folders = {}
    for top in ('core', 'ui', 'app', 'tests/core', 'tests/ui', 'tests/support'):
        for folder, _, files in os.walk(os.path.join(root, top)):
            members = [os.path.join(folder, name) for name in sorted(files) if name.endswith('.cpp')]
            if members:
                owner = folder if len(members) >= MIN_MEMBERS else os.path.dirname(folder)
                folders.setdefault(owner, []).extend(members)
    return folders.values()


def declared(path):
    """The names in the anonymous namespaces of a source; of functions with their parameters."""
    names, inside, statement = set(), False, ''
    with open(path, encoding='utf-8') as lines:
        for line in map(str.rstrip, lines):
            if line == 'namespace {':
                inside = True
            elif line == '}  // namespace':
                inside = False
            elif inside and statement:
                statement += ' ' + line.strip()
            elif inside and line and line[0] not in ' /#}':
                statement = line
            if inside and statement and statement.endswith((';', '{', '}')):
                names.update(name_of(statement))
                statement = ''
    return names


def name_of(statement):
    if ALIAS.match(statement):
        return []  # may be repeated for the same type; the compiler reports another one well
    for pattern in (TYPE, CONSTANT):
        found = pattern.match(statement)
        if found:
            return [found[1]]
    found = FUNCTION.match(statement)
    return [found[1] + ' '.join(statement[found.end() - 1:].rstrip('{; ').split())] if found else []


def collisions(root):
    for members in groups(root):
        owner = {}
        for path in members:
            for name in sorted(declared(path)):
                if name in owner:
                    yield f'{os.path.relpath(path, root)}: {name} is also in {os.path.relpath(owner[name], root)}'
                owner.setdefault(name, path)


if __name__ == '__main__':
    found = list(collisions(sys.argv[1]))
    print(*found, sep='\n', end='\n' if found else '')
    sys.exit(1 if found else 0)
