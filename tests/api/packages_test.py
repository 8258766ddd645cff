#!/usr/bin/env python3
"""The Debian packages and kerf.pc: packages_test.py BUILD CHECKOUT

cpack makes four packages that divide the installed files, with dependencies, copyright, changelog and triggers. lintian
reports no error where it is installed. A C program compiles with the flags of pkg-config.
"""
import gzip
import io
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile

BUILD, CHECKOUT = map(os.path.abspath, sys.argv[1:])
# Minor version of the Python for which the module is built.
MINOR = int(subprocess.run(['/usr/bin/python3', '-c', 'import sys; print(sys.version_info.minor)'], capture_output=True).stdout or 0)
# A file that each package must contain, packages that it must depend on, and files of its control archive.
PACKAGES = {
    'kerf': ({'usr/bin/kerf', 'usr/share/man/man1/kerf.1.gz', 'usr/share/kerf/scenes/car.json'}, ('libkerf0 (=', 'libc6'), set()),
    'libkerf0': ({'usr/lib/libkerf.so.0', 'usr/share/kerf/materials.json'}, ('libc6', 'libstdc++6'), {'triggers', 'shlibs'}),
    'libkerf-dev': ({'usr/include/kerf/kerf.h', 'usr/lib/libkerf.so', 'usr/share/pkgconfig/kerf.pc',
                     'usr/lib/cmake/kerf/kerfConfig.cmake'}, ('libkerf0 (=',), set()),
    'python3-kerf': ({'usr/lib/python3/dist-packages/kerf/__init__.py'}, ('libkerf0 (=', 'python3-numpy', f'python3 (<< 3.{MINOR + 1})'),
                     {'postinst', 'prerm'}),
}


def run(*command, **options):
    done = subprocess.run(command, capture_output=True, **options)
    if done.returncode != 0:
        sys.exit(f'{" ".join(map(str, command))} ended with {done.returncode}:\n{done.stdout}{done.stderr}')
    return done.stdout


def text(*command, **options):
    return run(*command, **options).decode()


def check_package(package, name, every_file):
    wanted, dependencies, control = PACKAGES[name]
    archive = tarfile.open(fileobj=io.BytesIO(run('dpkg-deb', '--fsys-tarfile', package)))
    files = {member.name[2:]: member for member in archive.getmembers() if not member.isdir()}
    assert wanted <= files.keys(), (name, wanted - files.keys())
    assert not every_file & files.keys(), f'{name} repeats {every_file & files.keys()}'
    every_file |= files.keys()
    depends = text('dpkg-deb', '-f', package, 'Depends')
    for dependency in dependencies:
        assert dependency in depends, (name, dependency, depends)
    scripts = tarfile.open(fileobj=io.BytesIO(run('dpkg-deb', '--ctrl-tarfile', package))).getnames()
    assert control <= {os.path.basename(script) for script in scripts}, (name, scripts)
    documents = f'usr/share/doc/{name}/'
    assert 'No licence has been chosen yet' in archive.extractfile(files[documents + 'copyright']).read().decode()
    changelog = gzip.decompress(archive.extractfile(files[documents + 'changelog.gz']).read()).decode()
    assert changelog.startswith(f"kerf ({text('dpkg-deb', '-f', package, 'Version').strip()}) "), changelog


def check_pkg_config(folder):
    if not shutil.which('pkg-config'):
        return
    prefix = os.path.join(folder, 'prefix')
    for component in ('library', 'development'):
        run('cmake', '--install', BUILD, '--prefix', prefix, '--component', component)
    environment = {**os.environ, 'PKG_CONFIG_PATH': os.path.join(prefix, 'lib/pkgconfig')}
    flags = text('pkg-config', '--cflags', '--libs', 'kerf', env=environment).split()
    program = os.path.join(folder, 'outside')
    run('cc', os.path.join(CHECKOUT, 'app/examples/outside.c'), '-o', program, *flags)
    said = text(program, env={**os.environ, 'LD_LIBRARY_PATH': os.path.join(prefix, 'lib')})
    assert said == '2 pieces\n', said


def check_prefix_usr(folder):
    """A build configured for the prefix /usr has kerf.pc in the folder of the architecture, where it stays."""
    file = os.path.join(folder, 'tree/development/usr/lib/x86_64-linux-gnu/pkgconfig/kerf.pc')
    os.makedirs(os.path.dirname(file))
    open(file, 'w').close()
    run('cmake', f'-DCPACK_TEMPORARY_INSTALL_DIRECTORY={folder}/tree', '-P', os.path.join(CHECKOUT, 'app/finish_package.cmake'))
    assert os.path.isfile(file)


def main():
    if not shutil.which('dpkg-deb'):
        sys.exit(77)
    names = set(PACKAGES)
    if not os.path.isdir(os.path.join(BUILD, 'python/kerf')):
        names.remove('python3-kerf')
    with tempfile.TemporaryDirectory() as folder:
        run('cpack', '-G', 'DEB', '--config', os.path.join(BUILD, 'CPackConfig.cmake'), '-B', folder)
        packages = {file.split('_')[0]: os.path.join(folder, file) for file in os.listdir(folder) if file.endswith('.deb')}
        assert set(packages) == names, packages
        every_file = set()
        for name, package in packages.items():
            check_package(package, name, every_file)
        if shutil.which('lintian'):
            said = subprocess.run(['lintian', *packages.values()], capture_output=True, text=True).stdout
            errors = [line for line in said.splitlines() if line.startswith('E:')]
            assert not errors, '\n'.join(errors)
        check_pkg_config(folder)
        check_prefix_usr(folder)


main()
