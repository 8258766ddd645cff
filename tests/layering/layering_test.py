#!/usr/bin/env python3
"""The layering test can fail: each small bad tree yields its one breach, and a good tree yields none."""
import os
import tempfile
import unittest

import group_names
import layering

GOOD = {
    'CMakeLists.txt': '', 'README.md': '', '.gitignore': '', 'assets/scene.json': '', 'build/x.cpp': '#include "x"',
    'build-sanitize/x': '',
    'app/main.cpp': '#include <imgui.h>\n#include "app/command.h"\n#include "ui/window/window.h"\n#include "core/cut/step.h"\n',
    'ui/window/window.cpp': '#include <GLFW/glfw3.h>\n#include "ui/window/window.h"\n#include "core/base/result.h"\n',
    'core/cut/step.cpp': '#include <glm/vec3.hpp>\n#include "core/cut/step.h"\n#include "core/graph/pieces.h"\n',
    'core/kerf.h': '#include <vector>\n#include "kerf_c.h"\n',
    'core/api/api_cut.cpp': '#include "core/kerf_c.h"\n#include "core/cut/step.h"\n',
    'core/mesh/half_edges_internal.h': '#include "core/mesh/half_edges_internal.h"\n#include "core/base/result.h"\n',
    'core/mesh/remesh/openmesh_internal.h': '#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>\n',
    'tests/bench/openmesh_peer.cpp': '#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>\n',
    'tests/core/mesh/remesh/openmesh_sheets_test.cpp': '#include "core/mesh/remesh/openmesh_internal.h"\n',
    'tests/core/cut/step_test.cpp': '#include "tests/support/plate.h"\n#include "core/cut/step.h"\n',
}


def breaches_of(files):
    with tempfile.TemporaryDirectory() as root:
        for path, text in files.items():
            full = os.path.join(root, path)
            os.makedirs(os.path.dirname(full), exist_ok=True)
            with open(full, 'w', encoding='utf-8') as out:
                out.write(text)
        return layering.breaches(root)


class Layering(unittest.TestCase):
    def refuses(self, path, text, line, why, reported=None):
        found = breaches_of({**GOOD, path: text})
        self.assertEqual([(reported or path, line)], [breach[:2] for breach in found], found)
        self.assertIn(why, found[0][2])

    def test_accepts_dependencies_along_the_layers(self):
        self.assertEqual([], breaches_of(GOOD))

    def test_rejects_core_depending_on_ui(self):
        self.refuses('core/cut/bad.cpp', '\n#include "ui/window/window.h"\n', 2, 'core does not know ui')

    def test_rejects_ui_depending_on_app(self):
        self.refuses('ui/gl/bad.h', '#include "app/command.h"\n', 1, 'ui does not know app')

    def test_rejects_programs_depending_on_tests(self):
        self.refuses('app/bad.cpp', '#include "tests/support/plate.h"\n', 1, 'only tests include tests')

    def test_rejects_every_reverse_dependency_inside_core(self):
        for earlier, later in zip(layering.CORE, layering.CORE[1:]):
            with self.subTest(earlier=earlier, later=later):
                self.refuses(f'core/{later}/bad.h', f'  #  include  "core/{earlier}/x.h"  // why\n', 1,
                             f'core/{later} comes after core/{earlier}')

    def test_rejects_a_core_folder_without_a_layer(self):
        for folder in ('core', 'core/misc', 'core/mesh/misc', 'core/debug'):
            self.refuses(f'{folder}/bad.h', '#pragma once\n', 0, 'has no place', reported=folder)

    def test_accepts_core_folders_that_include_lower_layers(self):
        for i, here in enumerate(layering.CORE):
            includes = ''.join(f'#include "core/{there}/x.h"\n' for there in layering.CORE[i:])
            self.assertEqual([], breaches_of({**GOOD, f'core/{here}/good.cpp': includes}), here)

    def test_rejects_every_reverse_dependency_inside_ui(self):
        for earlier, later in zip(layering.UI, layering.UI[1:]):
            with self.subTest(earlier=earlier, later=later):
                self.refuses(f'ui/{later}/bad.h', f'#include "ui/{earlier}/x.h"\n', 1,
                             f'ui/{later} comes after ui/{earlier}')

    def test_accepts_ui_modules_that_include_lower_layers(self):
        for i, here in enumerate(layering.UI):
            includes = ''.join(f'#include "ui/{there}/x.h"\n' for there in layering.UI[i:])
            self.assertEqual([], breaches_of({**GOOD, f'ui/{here}/good.cpp': includes}), here)

    def test_rejects_a_ui_module_without_a_layer(self):
        for room in ('ui', 'ui/misc', 'ui/editor/view/misc'):
            self.refuses(f'{room}/bad.h', '#include "ui/gl/buffers.h"\n', 0, 'has no place', reported=room)

    def test_names_a_layered_folder_that_is_missing(self):
        with tempfile.TemporaryDirectory() as root:
            os.makedirs(os.path.join(root, 'core/mesh/files'))
            missing = layering.names_without_folder(root)
            self.assertEqual(len(layering.places()) - 2, len(missing))
            self.assertTrue({'core/mesh', 'core/mesh/files'}.isdisjoint(missing))

    def test_rejects_an_editor_feature_that_depends_on_another(self):
        self.refuses('ui/editor/view/bad.h', '#include "ui/editor/path/x.h"\n', 1, 'do not know each other')
        self.refuses('ui/editor/shell/bad.h', '#include "ui/editor/path/x.h"\n', 1, 'comes after')
        self.assertEqual([], breaches_of({**GOOD, 'ui/editor/view/good.h': '#include "ui/editor/view/x.h"\n',
                                          'ui/editor/editor.cpp': '#include "ui/editor/view/x.h"\n'}))

    def test_rejects_dependencies_in_the_public_header(self):
        for text in ('<glm/vec3.hpp>', '"core/base/result.h"'):
            self.refuses('core/kerf.h', f'#include {text}\n', 1, 'outsiders have the standard library alone')
        for path in ('core/cut/bad.cpp', 'ui/gl/bad.cpp', 'app/bad.cpp'):
            self.refuses(path, '#include "core/kerf.h"\n', 1, 'it is for outsiders')

    def test_rejects_private_headers_outside_their_folder(self):
        for path in ('core/cut/bad.cpp', 'core/mesh/remesh/bad.cpp', 'ui/gl/bad.cpp', 'tests/core/cut/bad.cpp'):
            self.refuses(path, '#include "core/mesh/half_edges_internal.h"\n', 1, 'is private to core/mesh')

    def test_accepts_private_headers_in_tests_and_references(self):
        for path in ('core/mesh/good.cpp', 'tests/core/mesh/good.cpp', 'tests/support/good.cpp'):
            self.assertEqual([], breaches_of({**GOOD, path: '#include "core/mesh/half_edges_internal.h"\n'}))

    def test_rejects_openmesh_outside_its_files(self):
        for path in ('core/mesh/bad.cpp', 'core/document/bad.h', 'ui/gl/bad.cpp', 'tests/core/walls/bad.cpp'):
            self.refuses(path, '#include <OpenMesh/Tools/Decimater/DecimaterT.hh>\n', 1,
                         'only core/mesh/remesh/openmesh_* knows OpenMesh')

    def test_rejects_json_headers_in_every_source(self):
        self.refuses('core/document/bad.cpp', '#include <nlohmann/json.hpp>\n', 1, 'include core/base/json.h')

    def test_rejects_graphics_in_core(self):
        for header in ('imgui.h', 'imgui_internal.h', 'backends/imgui_impl_glfw.h', 'GLFW/glfw3.h', 'epoxy/gl.h',
                       'GL/gl.h', 'EGL/egl.h'):
            self.refuses('core/cut/bad.h', f'#include <{header}>\n', 1, 'core draws nothing')

    def test_rejects_paths_not_relative_to_the_root(self):
        for text in ('"step.h"', '"../mesh/mesh.h"', '"imgui.h"'):
            self.refuses('core/cut/bad.cpp', f'#include {text}\n', 1, 'not written from the root')
        for text in ('<core/mesh/mesh.h>', '"core/cut/../mesh/mesh.h"'):
            self.refuses('core/cut/bad.cpp', f'#include {text}\n', 1, 'plain path from the root')
        self.refuses('core/cut/bad.cpp', '#include HEADER\n', 1, 'through a macro')

    def test_names_duplicate_declarations_in_a_source_group(self):
        source = 'namespace {{\n\nconstexpr int {0} = 1;\n\nint {1}(int a) {{ return a; }}\n\n}}  // namespace\n'
        with tempfile.TemporaryDirectory() as root:
            for name, words in (('a', ('kOne', 'first')), ('b', ('kOne', 'second'))):
                os.makedirs(os.path.join(root, 'core/cut'), exist_ok=True)
                with open(os.path.join(root, f'core/cut/{name}.cpp'), 'w') as file:
                    file.write(source.format(*words))
            self.assertEqual(['core/cut/b.cpp: kOne is also in core/cut/a.cpp'], list(group_names.collisions(root)))

    def test_rejects_a_stray_entry_at_the_top_level(self):
        self.refuses('notes.txt', '', 0, 'top level')
        self.refuses('lib/x.txt', '', 0, 'top level', reported='lib')


if __name__ == '__main__':
    unittest.main()
