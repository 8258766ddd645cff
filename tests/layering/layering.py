#!/usr/bin/env python3
"""Fails on an include that runs against the arrows of the project.

layering.py ROOT prints `file:line: why` for each breach below ROOT and exits with 1 if there is one.
"""
import os
import re
import sys

# Each may include itself and what comes after it, never what comes before.
LAYERS = ['app', 'ui', 'core']
CORE = ['game', 'document', 'physics', 'cut', 'graph', 'shadow', 'world', 'heat', 'laser', 'tree', 'mesh', 'debug',
        'base']
# Of ui, first what draws a world, then what any screen needs of a window, then the editor. In the editor: what it
# counts, how the world is looked at, what is open and saved, the section plane, the path and the emitter of the laser, how
# time passes and pieces are pulled, what the mouse does, single steps of a stroke with their panel, how the world changes, what is drawn over the picture, what is told
# of a face, the menus and dialogs, how actions are found and bound to keys, the panels, the panel of the component
# graph, that of preparing meshes, those of heat, and that of moving bodies; the files in ui/editor itself put these together and alone know all of its state.
UI = ['editor', 'editor/bodies', 'editor/graph', 'editor/material', 'editor/prepare', 'editor/panels', 'editor/keys', 'editor/frame', 'editor/marks', 'editor/inspect', 'editor/changes', 'editor/single_step', 'editor/tools', 'editor/play', 'editor/path', 'editor/section', 'editor/work', 'editor/view',
      'editor/figures', 'figures', 'game', 'sound', 'screen', 'window', 'render', 'gl']

SOURCE_FOLDERS = LAYERS + ['tests']
TOP_LEVEL = {'CMakeLists.txt', 'README.md', 'assets', *SOURCE_FOLDERS}
BUILD_FOLDER = re.compile(r'build(-.*)?$')

SOURCE = re.compile(r'\.(h|hh|hpp|hxx|inl|ipp|c|cc|cpp|cxx)$')
INCLUDE = re.compile(r'\s*#\s*include(?:_next)?\b\s*(.*)')
TARGET = re.compile(r'"([^"]+)"|<([^>]+)>')
PRIVATE_TO_MESH = {'core/mesh/half_edges.h', 'core/mesh/kernel.h', 'core/mesh/rings.h'}
# OpenMesh's headers are slow to compile and their types belong to one folder; the benchmark compares with its kernel.
OPENMESH_USERS = ('core/mesh/openmesh/', 'tests/bench/')
PRIVATE_TO_OPENMESH = {'core/mesh/openmesh/kernel_types.h', 'core/mesh/openmesh/sheets.h'}
GRAPHICS = re.compile(r'imgui|imconfig|imstb_|backends/imgui_|GLFW/|epoxy/|GL/|GLES\d*/|EGL/|KHR/|X11/|vulkan/')


def breaches(root):
    """Every breach below root, as (file, line, why); file is relative to root, line 0 means the entry itself."""
    found = [(name, 0, 'is not one of the entries that the top level holds') for name in stray_entries(root)]
    for path in sources(root):
        with open(os.path.join(root, path), encoding='utf-8', errors='replace') as lines:
            for number, line in enumerate(lines, 1):
                include = INCLUDE.match(line)
                why = include and objection(path, include[1])
                if why:
                    found.append((path, number, why))
    return found


def stray_entries(root):
    return sorted(name for name in os.listdir(root)
                  if name not in TOP_LEVEL and not name.startswith('.') and not BUILD_FOLDER.match(name))


def sources(root):
    for top in SOURCE_FOLDERS:
        for folder, folders, files in os.walk(os.path.join(root, top)):
            folders.sort()
            for name in sorted(files):
                if SOURCE.search(name):
                    yield os.path.relpath(os.path.join(folder, name), root)


def objection(path, operand):
    """Why the file at path may not hold `#include operand`, or None where it may."""
    target = TARGET.match(operand)
    if not target:
        return 'an include through a macro hides its arrow'
    quoted, name = target[1], target[1] or target[2]
    if name.split('/')[0] in SOURCE_FOLDERS:
        if not quoted or os.path.normpath(name) != name:
            return f'{name} is a file of the project: write its plain path from the root, in quotes'
        if name in PRIVATE_TO_MESH and not path.startswith('core/mesh/'):
            return f'{name} outside core/mesh'
        if name in PRIVATE_TO_OPENMESH and not path.removeprefix('tests/').startswith('core/mesh/openmesh/'):
            return f'{name} outside core/mesh/openmesh and its tests'
        return against_the_arrows(path, name)
    if quoted:
        return f'"{name}" is not written from the root (or is not of the project and belongs in angle brackets)'
    if GRAPHICS.match(name) and path.startswith('core/'):
        return f'<{name}>: core draws nothing and has no window'
    if name.startswith('OpenMesh/') and not path.startswith(OPENMESH_USERS):
        return f'<{name}>: only core/mesh/openmesh knows OpenMesh'
    return None


def against_the_arrows(path, name):
    here, there = path.split('/')[0], name.split('/')[0]
    if here == 'tests':
        return None
    if there == 'tests':
        return f'{name}: only tests include tests'
    if LAYERS.index(there) < LAYERS.index(here):
        return f'{name}: the arrows go {" -> ".join(LAYERS)}, and {here} does not know {there}'
    if here == there == 'core':
        return inside('core', CORE, path.split('/')[1], name.split('/')[1], name)
    if here == there == 'ui':
        return inside('ui', UI, room_of(path), room_of(name), name)
    return None


def room_of(path):
    """The folder of a file below ui: 'editor/panels' for ui/editor/panels/panel.h."""
    return os.path.dirname(path)[len('ui/'):]


def inside(layer, order, here, there, name):
    for folder in (here, there):
        if folder not in order:
            return (f'{layer}/{folder} has no place in the order of {layer}: give it one in '
                    'tests/layering/layering.py')
    if order.index(there) < order.index(here):
        return f'{name}: {layer}/{here} comes after {layer}/{there} in the order and does not know it'
    return None


def main(root):
    found = breaches(root)
    for path, line, why in found:
        print(f'{path}:{line}: {why}' if line else f'{path}: {why}')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
