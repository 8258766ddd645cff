#!/usr/bin/env python3
"""The wheel of `pip install ./app/python`: wheel_test.py BUILD CHECKOUT

The backend packs the module of BUILD, and otherwise configures a build folder that lacks it again. The wheel works by itself, its table of materials included. Where the packages
of pip and venv are installed, pip installs it into a virtual environment without a network.
"""
import glob
import os
import subprocess
import sys
import tempfile
import zipfile

BUILD, CHECKOUT = map(os.path.abspath, sys.argv[1:])
SOURCE = os.path.join(CHECKOUT, 'app/python')
PYTHON = '/usr/bin/python3'
# Ends with the version and the file of the module.
PROGRAM = '''
import numpy as np, kerf
world = kerf.World()
world.add(kerf.Mesh([[0, 0, 0], [1, 0, 0], [0, 0, 1]], [[0, 2, 1]]))
stroke = kerf.Stroke([(0, (0.2, 1, -1), (0, -1, 0)), (1, (0.2, 1, 2), (0, -1, 0))], radius=0.01)
assert world.cut(stroke, material='copper')['removed_faces'] > 0 and len(world.pieces) == 2
print(kerf.__version__, kerf.__file__, [line.split()[-1] for line in open('/proc/self/maps') if 'libkerf' in line][0])
'''
# Nothing is downloaded: no index, and a proxy that does not exist.
OFFLINE = {'PIP_NO_INDEX': '1', 'PIP_DISABLE_PIP_VERSION_CHECK': '1', 'https_proxy': 'http://127.0.0.1:9'}


def run(*command, **variables):
    environment = {**os.environ, 'KERF_BUILD': BUILD, 'PYTHONDONTWRITEBYTECODE': '1', **OFFLINE, **variables}
    done = subprocess.run(command, capture_output=True, text=True, env=environment, cwd='/')
    if done.returncode != 0:
        sys.exit(f'{" ".join(map(str, command))} ended with {done.returncode}:\n{done.stdout}{done.stderr}')
    return done.stdout


def check(python, site, **variables):
    version, module, library = run(python, '-c', PROGRAM, **variables).split()
    assert module.startswith(site) and library.startswith(site), (site, module, library)
    return version


def check_configuring(folder):
    sys.path.insert(0, SOURCE)
    import build_wheel
    os.environ.pop('KERF_BUILD', None)
    commands, build = [], os.path.join(folder, 'build')
    build_wheel.ROOT, build_wheel._run = folder, lambda *command: commands.append(command)
    os.makedirs(os.path.join(build, 'python/kerf'))
    number = f'{sys.version_info.major}{sys.version_info.minor}'
    open(os.path.join(build, f'python/kerf/_kerf.cpython-{number}-x.so'), 'w').close()
    for generator in (('-G', 'Ninja'), ()):
        assert build_wheel._built() == build
        assert commands == [('cmake', '-S', folder, '-B', build, *generator),
                            ('cmake', '--build', build, '--target', 'kerf_python')], commands
        open(os.path.join(build, 'CMakeCache.txt'), 'w').close()
        open(os.path.join(build, 'build.ninja'), 'w').close()
        commands.clear()


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_configuring(folder)
    if not glob.glob(os.path.join(BUILD, 'python/kerf/_kerf.*.so')):
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        folder = os.path.realpath(folder)
        wheel = run(PYTHON, '-c', f'import build_wheel; print(build_wheel.build_wheel({folder!r}))', PYTHONPATH=SOURCE).split()[-1]
        site = os.path.join(folder, 'site')
        with zipfile.ZipFile(os.path.join(folder, wheel)) as archive:
            archive.extractall(site)
            record = archive.read([n for n in archive.namelist() if n.endswith('/RECORD')][0]).decode()
            assert {line.split(',')[0] for line in record.splitlines()} == set(archive.namelist())
        # The library looks for it here, before the checkout.
        assert os.path.isfile(os.path.join(site, 'kerf/share/kerf/materials.json'))
        version = check(PYTHON, site, PYTHONPATH=site)
        assert wheel.startswith(f'kerf-{version}-cp'), (wheel, version)
        environment = os.path.join(folder, 'environment')
        made = subprocess.run([PYTHON, '-m', 'venv', '--system-site-packages', environment], capture_output=True)
        if made.returncode != 0:
            print('pip is not tested: the package python3-venv is missing')
            return
        python = os.path.join(environment, 'bin/python3')
        run(python, '-m', 'pip', 'install', SOURCE)
        check(python, environment)


main()
