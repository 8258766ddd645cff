#!/usr/bin/env python3
"""What `cmake --install` puts down works by itself: install_test.py BUILD CHECKOUT

The program runs from another directory with its own assets, outside programs in C++ and C find the library, and the
Python examples end well and agree with `kerf cut`.
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile

BUILD, CHECKOUT = map(os.path.abspath, sys.argv[1:])
EXAMPLES = os.path.join(CHECKOUT, 'app/examples')
SPHERE = os.path.join(CHECKOUT, 'assets/meshes/sphere.obj')
# Executes the cells of a notebook.
RUN_NOTEBOOK = '''
import json, sys
cells = json.load(open(sys.argv[1], encoding='utf-8'))['cells']
scope = {}
for cell in cells:
    if cell['cell_type'] == 'code':
        exec(compile(''.join(cell['source']), cell['id'], 'exec'), scope)
'''
# The Python for which the module is built.
PYTHON = '/usr/bin/python3'


def run(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f'{" ".join(map(str, command))} ended with {done.returncode}:\n{done.stdout}{done.stderr}')
    return done.stdout


def check_files(prefix):
    for path in ('bin/kerf', 'share/kerf/materials.json', 'share/applications/kerf.desktop', 'share/man/man1/kerf.1',
                 'share/icons/hicolor/scalable/apps/kerf.svg', 'share/mime/packages/kerf.xml',
                 'share/bash-completion/completions/kerf',
                 'share/zsh/vendor-completions/_kerf', 'share/fish/vendor_completions.d/kerf.fish',
                 'share/metainfo/kerf.metainfo.xml', 'share/thumbnailers/kerf.thumbnailer', 'lib/pkgconfig/kerf.pc', 'include/kerf/kerf.h', 'include/kerf/kerf_c.h',
                 'include/kerf/kerf_c_mesh.h'):
        assert os.path.isfile(os.path.join(prefix, path)), f'{path} is not installed'
    assert not os.path.exists(os.path.join(prefix, 'share/kerf/pictures'))


def check_program(prefix, folder):
    kerf = os.path.join(prefix, 'bin/kerf')
    picture = os.path.join(folder, 'ball.png')
    run(kerf, 'render', os.path.join(prefix, 'share/kerf/scenes/sphere.json'), '--out', picture, '--size', '160x100', cwd='/')
    assert os.path.getsize(picture) > 1000
    # It must not need the checkout: no file of it is opened.
    trace = subprocess.run([kerf, 'materials'], capture_output=True, text=True, cwd='/', check=True).stdout
    assert json.loads(trace)


def check_outside_programs(prefix, folder):
    build = os.path.join(folder, 'build')
    run('cmake', '-G', 'Ninja', '-S', EXAMPLES, '-B', build, f'-DCMAKE_PREFIX_PATH={prefix}',
        '-DCMAKE_C_FLAGS=-Wall -Wextra -Werror', '-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror -ffast-math')
    run('cmake', '--build', build)
    said = run(os.path.join(build, 'outside'), SPHERE)
    assert said.count(' kg') == 2, said
    assert 'per changed face' in run(os.path.join(build, 'live_cut'), '60')
    window = os.path.join(build, 'live_window')
    if os.path.exists(window) and shutil.which('xvfb-run'):
        assert ' pieces' in run('xvfb-run', '-a', window, '30', os.path.join(folder, 'scene'))
        assert os.path.exists(os.path.join(folder, 'scene', 'scene.json'))
    assert run(os.path.join(build, 'outside_c')) == '2 pieces\n'
    masses = [float(line.split(', ')[1].split()[0]) for line in run(os.path.join(build, 'engine_extension')).splitlines()]
    # The box has 10 m2 of sheet at 7.85 kg; the slot takes four strips of 2 cm by one metre from it.
    assert len(masses) == 2 and abs(sum(masses) - 7.85 * (10 - 4 * 0.02)) < 0.01, masses


def check_batch(prefix, folder):
    meshes = os.path.join(folder, 'meshes')
    os.mkdir(meshes)
    for name in ('sphere.obj', 'knot.obj'):
        shutil.copy(os.path.join(os.path.dirname(SPHERE), name), meshes)
    shutil.copy(SPHERE, os.path.join(os.fsencode(meshes), b'teil_\xfc.obj'))  # not UTF-8
    out = os.path.join(folder, 'cut')
    command = ['bash', os.path.join(EXAMPLES, 'cut_folder.sh'), os.path.join(prefix, 'bin/kerf'), meshes, out]
    run(*command, errors='replace')
    found = {**os.environ, 'PATH': os.path.join(prefix, 'bin') + ':' + os.environ['PATH']}
    run(*command[:2], 'kerf', meshes, os.path.join(folder, 'cut by name'), errors='replace', env=found)
    assert subprocess.run([*command[:2], 'no/kerf', *command[3:]], capture_output=True, check=False).returncode == 2
    with open(os.path.join(out, 'table.csv'), 'rb') as table:
        assert [line.split(b',')[0] for line in table] == [b'mesh', b'knot.obj', b'sphere.obj', b'teil_\xfc.obj']
    bad = os.path.join(meshes, 'bad.obj')
    open(bad, 'w', encoding='utf-8').close()
    assert subprocess.run(command, capture_output=True, check=False).returncode != 0
    with open(os.path.join(out, 'failed.txt'), encoding='utf-8') as failed:
        assert failed.read() == bad + '\n'


def check_python(prefix, folder):
    site = os.path.join(prefix, 'lib/python3/dist-packages')
    if not os.path.isdir(os.path.join(site, 'kerf')):
        print('the Python module was not built')
        return
    environment = {**os.environ, 'PYTHONPATH': site, 'PYTHONDONTWRITEBYTECODE': '1'}
    for example in ('tune_resolution.py', 'rays_against_brute_force.py'):
        run(PYTHON, os.path.join(EXAMPLES, example), SPHERE, env=environment)
    run(PYTHON, os.path.join(EXAMPLES, 'drill_holes.py'), env=environment)
    run(PYTHON, '-c', RUN_NOTEBOOK, os.path.join(EXAMPLES, 'tune_resolution.ipynb'), env=environment)
    jobs = [{'vertices': [[0, 0, 0], [1, 0, 0], [0, 0, 1]], 'faces': [[0, 2, 1]], 'material': 'copper', 'rim': 'smooth',
             'strokes': [{'keys': [[0, [0.3, 1, -1], [0, -1, 0]], [1, [0.3, 1, 2], [0, -1, 0]]], 'radius': 0.01}]}, {'faces': 3}]
    answers = [json.loads(line) for line in
               run(PYTHON, os.path.join(EXAMPLES, 'cut_server.py'), env=environment,
                   input=''.join(json.dumps(job) + '\n' for job in jobs)).splitlines()]
    assert len(answers[0]['pieces']) == 2 and list(answers[1]) == ['error'], answers
    assert abs(answers[0]['removed_area'] - 0.02 * 0.7) < 1e-9, answers
    said = run(PYTHON, os.path.join(EXAMPLES, 'cut_in_five_lines.py'), SPHERE, env=environment).split()
    path, out = os.path.join(folder, 'path.json'), os.path.join(folder, 'out')
    with open(path, 'w', encoding='utf-8') as text:
        keys = [{'t': t, 'origin': [0, 3, z], 'direction': [0, -1, 0]} for t, z in ((0, -3), (1, 3))]
        json.dump({'strokes': [{'laser': {'radius': 0.005, 'range': [0, 10]}, 'keys': keys}]}, text)
    run(os.path.join(prefix, 'bin/kerf'), 'cut', SPHERE, '--path', path, '--out', out)
    with open(os.path.join(out, 'report.json'), encoding='utf-8') as text:
        report = json.load(text)
    assert said[-1] == report['state_hash'], (said[-1], report['state_hash'])
    areas = [float(said[i - 1]) for i, word in enumerate(said) if word == 'm2,']
    assert len(areas) == len(report['pieces'])
    assert all(abs(a - piece['area']) < 1e-6 for a, piece in zip(areas, report['pieces'])), (areas, report['pieces'])
    run(PYTHON, os.path.join(CHECKOUT, 'tests/api/python_test.py'), SPHERE, env=environment)


def main():
    with tempfile.TemporaryDirectory() as folder:
        prefix = os.path.join(folder, 'prefix')
        run('cmake', '--install', BUILD, '--prefix', prefix)
        check_files(prefix)
        check_program(prefix, folder)
        outside = os.path.join(folder, 'outside')
        os.mkdir(outside)
        check_outside_programs(prefix, outside)
        check_batch(prefix, folder)
        check_python(prefix, folder)


main()
