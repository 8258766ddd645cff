"""Build backend of `pip install ./app/python`: a wheel with the Python module and the library that it needs.

Builds both with CMake in build/ of the checkout, like app/run. With KERF_BUILD=FOLDER in the environment, the module of
that build folder is packed unchanged.
"""
import base64
import glob
import hashlib
import os
import re
import subprocess
import sys
import tempfile
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))


def _run(*command):
    subprocess.run(command, check=True, stdout=sys.stderr)


def _version():
    with open(os.path.join(ROOT, 'core/base/version.h'), encoding='utf-8') as text:
        return re.search(r'kVersion = "([0-9.]+)"', text.read())[1]


def _tag():
    """The tag of the Python that runs pip, which must have the version of the one that CMake builds for."""
    number = f'{sys.version_info.major}{sys.version_info.minor}'
    return f'cp{number}-cp{number}-linux_{os.uname().machine}'


def _built():
    """The build folder with the module."""
    folder = os.environ.get('KERF_BUILD')
    if not folder:
        folder = os.path.join(ROOT, 'build')
        # A configured folder is configured again: it lacks the module if a package was missing then.
        generator = [] if os.path.exists(os.path.join(folder, 'CMakeCache.txt')) else ['-G', 'Ninja']
        _run('cmake', '-S', ROOT, '-B', folder, *generator)
        _run('cmake', '--build', folder, '--target', 'kerf_python')
    modules = glob.glob(os.path.join(folder, 'python/kerf/_kerf.*.so'))
    suffix = f'cpython-{sys.version_info.major}{sys.version_info.minor}-'
    if not any(suffix in os.path.basename(module) for module in modules):
        sys.exit(f'{folder} has no module for this Python; use that of /usr/bin/python3, with pybind11-dev and python3-dev')
    return folder


def _files(folder):
    """Pairs of a name in the wheel and the contents, taken from the installed components."""
    with tempfile.TemporaryDirectory() as prefix:
        install = os.path.join(folder, 'app', 'cmake_install.cmake')
        for component in ('library', 'python'):
            _run('cmake', f'-DCMAKE_INSTALL_PREFIX={prefix}', f'-DCMAKE_INSTALL_COMPONENT={component}',
                 '-DCMAKE_INSTALL_DO_STRIP=1', '-P', install)
        wanted = {'lib/python3/dist-packages/kerf/*': 'kerf/', '**/libkerf.so.?': 'kerf/', 'share/kerf/*': 'kerf/share/kerf/'}
        for pattern, place in wanted.items():
            for path in sorted(glob.glob(os.path.join(prefix, pattern), recursive=True)):
                with open(path, 'rb') as file:
                    yield place + os.path.basename(path), file.read()


def _metadata():
    return (f'Metadata-Version: 2.1\nName: kerf\nVersion: {_version()}\nSummary: Cuts triangle meshes with a laser\n'
            'Requires-Python: >=3.9\nRequires-Dist: numpy\n').encode()


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel to the folder and returns its name (PEP 517)."""
    information = f'kerf-{_version()}.dist-info/'
    entries = list(_files(_built()))
    entries += [(information + 'METADATA', _metadata()),
                (information + 'WHEEL', f'Wheel-Version: 1.0\nGenerator: kerf\nRoot-Is-Purelib: false\nTag: {_tag()}\n'.encode())]
    record = ''
    for name, content in entries:
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b'=').decode()
        record += f'{name},sha256={digest},{len(content)}\n'
    record += f'{information}RECORD,,\n'
    wheel = f'kerf-{_version()}-{_tag()}.whl'
    with zipfile.ZipFile(os.path.join(wheel_directory, wheel), 'w', zipfile.ZIP_DEFLATED) as archive:
        for name, content in [*entries, (information + 'RECORD', record.encode())]:
            archive.writestr(name, content)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    """Fails: the sources lie outside this folder (PEP 517)."""
    raise NotImplementedError('kerf is built from its checkout only: pip install ./app/python')
