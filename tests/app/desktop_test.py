#!/usr/bin/env python3
"""Completion and the files by which a desktop uses Kerf: desktop_test.py KERF

Completions offer the values that the program accepts. MIME types recognise the files that Kerf writes, and the
thumbnailer draws them.
"""
import configparser
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

KERF = os.path.abspath(sys.argv.pop())
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
EXTRAS = os.path.join(ROOT, 'assets/install')
SPHERE = os.path.join(ROOT, 'assets/meshes/sphere.obj')
BALL = shlex.quote(SPHERE)
# Command lines whose error lists the values of the last option.
REFUSED = ('cut x --out y --rim', 'cut x --out y --scheme', 'cut x --out y --model', 'cut x --out y --pattern',
           'cut x --out y --assist', 'cut x --out y --format', 'cut x --out y --outlines', f'prepare {BALL} --out x.obj --subdivide',
           f'render {BALL} --out x.png --show', f'cut {BALL} --out y --material', 'play --driver',
           'play --headless --driver bot --difficulty', 'compare x y --align', 'info x --unit')


def text_of(name):
    with open(os.path.join(EXTRAS, name), encoding='utf-8') as file:
        return file.read()


def accepted(line):
    """The values of the last option of a command line, as the error of a wrong value lists them."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([KERF, *shlex.split(line), '?'], capture_output=True, text=True, cwd=folder)
    assert done.returncode == 2, done
    return set(re.findall('[a-z0-9][a-z0-9-]*', re.split(r'values are: |names: |materials are: |must be ', done.stderr)[1])) - {'or'}


def mime_types():
    space = '{http://www.freedesktop.org/standards/shared-mime-info}'
    return {kind.get('type'): kind for kind in ElementTree.parse(os.path.join(EXTRAS, 'kerf.xml')).getroot()}, space


class Desktop(unittest.TestCase):
    def test_completions_offer_the_accepted_values(self):
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(KERF, os.path.join(folder, 'kerf'))
            environment = {**os.environ, 'PATH': folder + ':' + os.environ['PATH']}
            for line in REFUSED:
                option = line.split()[-1]
                with self.subTest(option):
                    program = (f'source {shlex.quote(EXTRAS)}/kerf.bash; COMP_WORDS=(kerf {line} ""); '
                               'COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _kerf; printf "%s\\n" "${COMPREPLY[@]}"')
                    said = subprocess.run(['bash', '-c', program], env=environment, capture_output=True, text=True, check=True)
                    values = accepted(line)
                    self.assertGreater(len(values), 1)
                    self.assertEqual(values, set(said.stdout.split()))
                    if option in ('--material', '--show'):  # asked of the program
                        continue
                    zsh = re.search(rf'{option}\) compadd (.*) ;;', text_of('_kerf'))[1]
                    fish = re.search(rf"-l {option[2:]} -x -a '(.*)'", text_of('kerf.fish'))[1]
                    self.assertEqual((set(zsh.split()), set(fish.split())), (values, values))

    def test_completions_offer_whole_names_of_options(self):
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(KERF, os.path.join(folder, 'kerf'))
            program = (f'source {shlex.quote(EXTRAS)}/kerf.bash; COMP_WORDS=(kerf path x --power); COMP_CWORD=3; _kerf; '
                       'printf "%s\\n" "${COMPREPLY[@]}"')
            environment = {**os.environ, 'PATH': folder + ':' + os.environ['PATH']}
            said = subprocess.run(['bash', '-c', program], env=environment, capture_output=True, text=True, check=True).stdout
        self.assertEqual(said.split(), ['--power-at-s1000'])
        patterns = re.findall(r"--\[a-z\][^']*", text_of('kerf.bash') + text_of('_kerf') + text_of('kerf.fish'))
        self.assertEqual(patterns, 3 * ['--[a-z][a-z0-9-]*'])

    def test_completion_by_bash_asks_the_program_that_is_typed(self):
        for option, value in (('--material', 'pmma'), ('--show', 'wire')):
            program = (f'source {shlex.quote(EXTRAS)}/kerf.bash; COMP_WORDS=({shlex.quote(KERF)} cut x {option} {value[:2]}); '
                       'COMP_CWORD=4; _kerf; printf "%s\\n" "${COMPREPLY[@]}"')
            environment = {**os.environ, 'PATH': '/usr/bin:/bin'}
            said = subprocess.run(['bash', '-c', program], env=environment, capture_output=True, text=True, check=True).stdout
            self.assertIn(value, said.split())

    def test_completed_names_of_files_are_quoted(self):
        program = (f'source {shlex.quote(EXTRAS)}/kerf.bash; compopt() {{ echo "compopt $*"; }}; COMP_WORDS=(true my); COMP_CWORD=1; '
                   '_kerf; printf "%s\\n" "${COMPREPLY[@]}"')
        with tempfile.TemporaryDirectory() as folder:
            open(os.path.join(folder, 'my mesh.obj'), 'w').close()
            said = subprocess.run(['bash', '-c', program], capture_output=True, text=True, check=True, cwd=folder).stdout
        self.assertEqual(said, 'compopt -o filenames\nmy mesh.obj\n')

    def test_completions_can_be_parsed(self):
        for shell, check, name in (('bash', '-n', 'kerf.bash'), ('zsh', '-n', '_kerf'), ('fish', '--no-execute', 'kerf.fish')):
            if shutil.which(shell):
                subprocess.run([shell, check, os.path.join(EXTRAS, name)], check=True)

    def test_ply_and_off_files_have_mime_types_that_detect_them(self):
        types, space = mime_types()
        for ending in ('ply', 'off'):
            kind = types[f'application/x-{ending}']
            self.assertEqual(kind.find(space + 'glob').get('pattern'), '*.' + ending)
            with tempfile.TemporaryDirectory() as folder:
                file = os.path.join(folder, 'ball.' + ending)
                subprocess.run([KERF, 'prepare', SPHERE, '--simplify', '100', '--out', file], check=True, capture_output=True)
                with open(file, 'rb') as written:
                    head = written.read(16)
            starts = [m.get('value').encode().decode('unicode_escape').encode() for m in kind.iter(space + 'match')]
            self.assertTrue(any(head.startswith(start) for start in starts), (head, starts))

    def test_the_thumbnailer_draws_its_declared_types(self):
        entry = configparser.ConfigParser(interpolation=None)
        entry.read(os.path.join(EXTRAS, 'kerf.thumbnailer'))
        entry = entry['Thumbnailer Entry']
        types = set(entry['MimeType'].strip(';').split(';'))
        desktop = re.search('^MimeType=(.*);$', text_of('kerf.desktop'), re.MULTILINE)[1].split(';')
        self.assertLessEqual(types, set(desktop))
        self.assertLessEqual({'application/x-kerf-journal', 'application/x-ply', 'model/obj', 'model/stl', 'model/gltf-binary'}, types)
        with tempfile.TemporaryDirectory() as folder:
            for source in (SPHERE, os.path.join(ROOT, 'assets/scenes/figure-08.kerf')):
                image = os.path.join(folder, 'thumbnail.png')
                words = [word.replace('%i', source).replace('%o', image).replace('%s', '128') for word in shlex.split(entry['Exec'])]
                self.assertEqual(words[0], 'kerf')
                subprocess.run([KERF, *words[1:]], check=True, capture_output=True)
                with open(image, 'rb') as file:
                    self.assertEqual(file.read(24)[16:], bytes([0, 0, 0, 128] * 2))
                os.remove(image)

    def test_the_man_page_has_all_sections_and_names_existing_files(self):
        with open(os.path.join(os.path.dirname(KERF), 'kerf.1'), encoding='utf-8') as file:
            page = file.read().replace('\\-', '-')
        sections = re.split('^[.]SH (.*)\n', page, flags=re.MULTILINE)
        text = dict(zip(sections[1::2], sections[2::2]))
        self.assertLessEqual({'NAME', 'SYNOPSIS', 'DESCRIPTION', 'OPTIONS', 'COMMANDS', 'EXIT STATUS', 'ENVIRONMENT', 'FILES',
                              'EXAMPLES'}, set(text))
        files = re.findall('/usr/share/kerf/([^ \n]+)', text['EXAMPLES'])
        self.assertGreater(len(files), 4)
        for name in files:
            self.assertTrue(os.path.isfile(os.path.join(ROOT, 'assets', name)), name)
        commands = re.findall('^[.]SS kerf ([a-z]+)', text['COMMANDS'], re.MULTILINE)
        self.assertEqual(commands, re.findall('^kerf ([a-z]+)', text['EXAMPLES'], re.MULTILINE))
        for command in commands:
            said = subprocess.run([KERF, command, '--help'], capture_output=True, text=True, check=True).stdout
            part = text['COMMANDS'].split(f'.SS kerf {command}\n')[1].split('.SS ')[0]
            self.assertEqual(re.findall('^  (?:-., *)?(--[a-z-]+)', said, re.MULTILINE),
                             re.findall(r'^\\fB(?:-.,)?(--[a-z-]+)', part, re.MULTILINE))

    def test_metadata_names_the_desktop_entry_and_its_types(self):
        root = ElementTree.fromstring(text_of('kerf.metainfo.xml'))
        self.assertEqual(root.find('launchable').text, 'kerf.desktop')
        desktop = re.search('^MimeType=(.*);$', text_of('kerf.desktop'), re.MULTILINE)[1].split(';')
        self.assertEqual({kind.text for kind in root.iter('mediatype')}, set(desktop))


unittest.main()
