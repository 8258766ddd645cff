#!/usr/bin/env python3
"""Fails on an include that runs against the arrows of the project.

layering.py ROOT prints `file:line: why` for each breach below ROOT and exits with 1 if there is one.
"""
import os
import re
import sys

# Each may include itself and what comes after it, never what comes before.
LAYERS = ['app', 'ui', 'core']
# All folders of core that hold sources.
CORE = [
    'api',
    'game/match',
    'game/driver',
    'game/vehicle',
    'game/arena',
    'document',
    'document/text',
    'physics',
    'physics/contact',
    'cut',
    'joints',
    'walls',
    'edit',
    'graph',
    'shadow',
    'world',
    'heat',
    'laser',
    'tree',
    'mesh/remesh',
    'mesh',
    'mesh/files',
    'base',
]
# Of ui, first what draws a world, then what any screen needs of a window, then the editor. In the editor: what every
# feature may know, the frame of the window that shows them, and the features; the files in ui/editor itself put these
# together. Each folder below ui/editor that is not named here is a feature and has the place of editor/FEATURE.
FEATURE = 'editor/FEATURE'
UI = [
    'editor',
    FEATURE,
    'editor/shell',
    'editor/shared',
    'figures',
    'game',
    'screen',
    'window',
    'render',
    'render/passes',
    'render/bodies',
    'render/view',
    'gl',
]

ORDERS = {'core': CORE, 'ui': UI}

SOURCE_FOLDERS = LAYERS + ['tests']
TOP_LEVEL = {'CMakeLists.txt', 'README.md', 'assets', *SOURCE_FOLDERS}
BUILD_FOLDER = re.compile(r'build(-.*)?$')

SOURCE = re.compile(r'\.(h|hh|hpp|hxx|inl|ipp|c|cc|cpp|cxx)$')
INCLUDE = re.compile(r'\s*#\s*include(?:_next)?\b\s*(.*)')
TARGET = re.compile(r'"([^"]+)"|<([^>]+)>')
# Public headers are installed as it lies: the standard library and each other alone.
PUBLIC_HEADERS = {'core/kerf.h', 'core/kerf_c.h', 'core/kerf_c_mesh.h'}
PUBLIC_HEADER_USERS = ('core/api/', 'app/python/', 'app/examples/', 'tests/api/', 'tests/fuzz/library/')
# Private headers: for their own folder, its tests, and the benchmarks, fuzzers and references of the tests.
INTERNAL = re.compile(r'(core|ui|app)/.*_internal\.h$')
INTERNAL_USERS = ('tests/bench/', 'tests/fuzz/', 'tests/support/')
# OpenMesh's headers are slow to compile and their types belong to one folder; benchmarks and tests compare with it.
OPENMESH_USERS = ('core/mesh/remesh/openmesh_', 'tests/bench/', 'tests/support/openmesh_')
GRAPHICS = re.compile(r'imgui|imconfig|imstb_|backends/imgui_|GLFW/|epoxy/|GL/|GLES\d*/|EGL/|KHR/|X11/|vulkan/')


def breaches(root):
    """Every breach below root, as (file, line, why); file is relative to root, line 0 means the entry itself."""
    found = [(name, 0, 'is not one of the entries that the top level holds') for name in stray_entries(root)]
    found += [(folder, 0, 'has no place in the order of folders: give it one in tests/layering/layering.py')
              for folder in unnamed_folders(root)]
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


def unnamed_folders(root):
    folders = {os.path.dirname(path) for path in sources(root) if path not in PUBLIC_HEADERS}
    return sorted(folder for folder in folders if folder.split('/')[0] in ORDERS and not has_place(folder))


def has_place(folder):
    layer, _, room = folder.partition('/')
    return folder in places() or place_of(layer, room) == FEATURE


def names_without_folder(root):
    """What the orders name and is not there."""
    return sorted(folder for folder in places() if not os.path.isdir(os.path.join(root, folder)))


def places():
    """All folders that have one by name: 'core/mesh/files'."""
    return {f'{layer}/{folder}' for layer, order in ORDERS.items() for folder in order if folder != FEATURE}


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
    if path in PUBLIC_HEADERS:
        own = quoted and f'core/{name}' in PUBLIC_HEADERS
        return None if own or (not quoted and '/' not in name) else f'{name}: outsiders have the standard library alone'
    if name in PUBLIC_HEADERS and not path.startswith(PUBLIC_HEADER_USERS):
        return f'{name}: it is for outsiders, and core/api makes it'
    if name.split('/')[0] in SOURCE_FOLDERS:
        if not quoted or os.path.normpath(name) != name:
            return f'{name} is a file of the project: write its plain path from the root, in quotes'
        if INTERNAL.match(name) and not may_know(path, name):
            return f'{name} is private to {os.path.dirname(name)}'
        return against_the_arrows(path, name)
    if quoted:
        return f'"{name}" is not written from the root (or is not of the project and belongs in angle brackets)'
    if GRAPHICS.match(name) and path.startswith('core/'):
        return f'<{name}>: core draws nothing and has no window'
    if name == 'nlohmann/json.hpp' and path != 'core/base/json.h':
        return f'<{name}>: include core/base/json.h, whose values are compiled once'
    if name.startswith('OpenMesh/') and not path.startswith(OPENMESH_USERS):
        return f'<{name}>: only core/mesh/remesh/openmesh_* knows OpenMesh'
    return None


def may_know(path, internal):
    """Whether the file at path may include a private header."""
    folder = os.path.dirname(internal)
    return os.path.dirname(path).removeprefix('tests/') == folder or path.startswith(INTERNAL_USERS)


def against_the_arrows(path, name):
    here, there = path.split('/')[0], name.split('/')[0]
    if here == 'tests':
        return None
    if there == 'tests':
        return f'{name}: only tests include tests'
    if LAYERS.index(there) < LAYERS.index(here):
        return f'{name}: the arrows go {" -> ".join(LAYERS)}, and {here} does not know {there}'
    return inside(here, room_of(path), room_of(name), name) if here == there and here in ORDERS else None


def room_of(path):
    """The folder of a file below its layer: 'editor/panels' for ui/editor/panels/panel.h."""
    return os.path.dirname(path).partition('/')[2]


def place_of(layer, room):
    """The entry of the order for a folder of the layer: features of the editor share one."""
    is_feature = layer == 'ui' and room.startswith('editor/') and room.count('/') == 1 and room not in UI
    return FEATURE if is_feature else room


# Folders that have no place are reported by themselves, see unnamed_folders.
def inside(layer, here, there, name):
    order, here_place, there_place = ORDERS[layer], place_of(layer, here), place_of(layer, there)
    if here_place == there_place == FEATURE and here != there:
        return f'{name}: ui/{here} and ui/{there} are features of the editor, which do not know each other'
    if here_place in order and there_place in order and order.index(there_place) < order.index(here_place):
        return f'{name}: {layer}/{here} comes after {layer}/{there} in the order and does not know it'
    return None


def main(root):
    found = breaches(root)
    found += [(folder, 0, 'has a place in the order of folders and is not there') for folder in names_without_folder(root)]
    for path, line, why in found:
        print(f'{path}:{line}: {why}' if line else f'{path}: {why}')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
