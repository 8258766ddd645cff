#!/usr/bin/env python3
"""The recipe of app/README.md works from a clean folder: recipe_test.py BUILD CHECKOUT

A copy of the sources is configured, built and installed by the lines of the page, with the options of BUILD, so that a
compiler cache has what BUILD compiled. Installing before anything is built installs nothing and names the target.
Compilation file by file can be configured.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

BUILD, CHECKOUT = map(os.path.abspath, sys.argv[1:])
PYTHON = '/usr/bin/python3'
SOURCES = ('CMakeLists.txt', 'app', 'assets', 'core', 'tests', 'ui')
PREFIX = '/opt/kerf'


def run(command, folder, status=0, **variables):
    cache = {'CCACHE_BASEDIR': folder, 'CCACHE_DEPEND': '1', 'CCACHE_SLOPPINESS': 'pch_defines,time_macros'}
    done = subprocess.run(command, shell=isinstance(command, str), capture_output=True, text=True, cwd=folder,
                          env={**os.environ, **cache, **variables})
    said = done.stdout + done.stderr
    assert (done.returncode == 0) == (status == 0), f'{command} ended with {done.returncode}:\n{said[-4000:]}'
    return said


def recipe():
    with open(os.path.join(CHECKOUT, 'app/README.md'), encoding='utf-8') as page:
        return re.search(r'## Installing\n\n```\n(.*?)```', page.read(), re.S)[1].splitlines()


def options():
    wanted = re.compile(r'(CMAKE_BUILD_TYPE|CMAKE_CXX_FLAGS\w*|KERF_SINGLE|KERF_WARNINGS_AS_ERRORS):\w+=(.*)')
    with open(os.path.join(BUILD, 'CMakeCache.txt'), encoding='utf-8') as cache:
        return [f"'-D{found[1]}={found[2]}'" for found in map(wanted.match, cache) if found]


def without(package, folder):
    """What configuring says where a package of CMake is not found."""
    return run(['cmake', '-S', '.', '-B', 'build', f'-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON'], folder)


def check_module(prefix, folder):
    site = os.path.join(prefix, 'lib/python3/dist-packages')
    if not os.path.isdir(os.path.join(site, 'kerf')):
        return
    hidden = os.path.join(folder, 'hidden')
    os.mkdir(hidden)
    with open(os.path.join(hidden, 'numpy.py'), 'w', encoding='utf-8') as module:
        module.write('raise ModuleNotFoundError("No module named numpy", name="numpy")\n')
    said = run([PYTHON, '-B', '-c', 'import kerf'], folder, status=1, PYTHONPATH=f'{hidden}:{site}')
    assert 'ImportError: kerf needs NumPy' in said and 'python3-numpy' in said, said


def main():
    configure, build, install = recipe()
    assert PREFIX in install, install
    with tempfile.TemporaryDirectory() as folder:
        for source in SOURCES:
            path = os.path.join(CHECKOUT, source)
            (shutil.copytree if os.path.isdir(path) else shutil.copy)(path, os.path.join(folder, source))
        prefix = os.path.join(folder, 'prefix')
        install = install.replace(PREFIX, prefix)
        said = run(' '.join([configure, *options()]), folder)
        has_module = 'The Python module is left out' not in said
        said = run(install, folder, status=1)
        assert '--target distribution' in said and not os.path.exists(prefix), said
        run(build, folder)
        run(install, folder)
        run([os.path.join(prefix, 'bin/kerf'), '--version'], '/')
        assert has_module == os.path.isdir(os.path.join(prefix, 'lib/python3/dist-packages/kerf'))
        check_module(prefix, folder)
        said = without('pybind11', folder)
        assert 'The Python module is left out' in said and 'pybind11-dev' in said, said
        run(['cmake', '-S', '.', '-B', 'single', '-G', 'Ninja', '-DKERF_SINGLE=ON'], folder)


main()
