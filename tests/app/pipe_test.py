#!/usr/bin/env python3
"""The command line in a pipe, and reports that their schema describes: pipe_test.py KERF"""
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

KERF = os.path.abspath(sys.argv.pop())
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MESHES = os.path.join(ROOT, 'assets/meshes')
SPHERE = os.path.join(MESHES, 'sphere.obj')
KNOWN = {'$schema', '$defs', 'title', 'description', '$ref', 'type', 'required', 'additionalProperties', 'properties', 'items',
         'minItems', 'maxItems', 'minimum', 'maximum', 'pattern', 'enum', 'const'}
TYPES = {'object': dict, 'array': list, 'string': str, 'boolean': bool, 'integer': int, 'number': (int, float)}


def faults(value, schema, root, where=''):
    """What a schema says against a value, for the keywords that the schema of reports uses."""
    assert schema.keys() <= KNOWN, schema.keys() - KNOWN
    if '$ref' in schema:
        yield from faults(value, root['$defs'][schema['$ref'].rsplit('/', 1)[1]], root, where)
    kind = schema.get('type')
    if kind and (not isinstance(value, TYPES[kind]) or (isinstance(value, bool) and kind != 'boolean')):
        yield f'{where}: {value!r} is no {kind}'
        return
    if 'const' in schema and value != schema['const'] or 'enum' in schema and value not in schema['enum']:
        yield f'{where}: {value!r} is not allowed'
    if 'pattern' in schema and not re.search(schema['pattern'], value):
        yield f'{where}: {value!r} does not match {schema["pattern"]}'
    if not schema.get('minimum', float('-inf')) <= (value if kind in ('integer', 'number') else 0) <= schema.get('maximum', float('inf')):
        yield f'{where}: {value!r} is out of range'
    if isinstance(value, list):
        if not schema.get('minItems', 0) <= len(value) <= schema.get('maxItems', len(value)):
            yield f'{where}: {len(value)} items'
        for i, item in enumerate(value):
            yield from faults(item, schema.get('items', {}), root, f'{where}/{i}')
    if isinstance(value, dict):
        yield from (f'{where}: {key} is missing' for key in schema.get('required', ()) if key not in value)
        for key, member in value.items():
            inner = schema.get('properties', {}).get(key, schema.get('additionalProperties', {}))
            if inner is False:
                yield f'{where}: {key} is not described'
            else:
                yield from faults(member, inner, root, f'{where}/{key}')


class Pipe(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        keys = [{'t': t, 'origin': [x, 3, 0.1], 'direction': [0, -1, 0]} for t, x in ((0, -2), (1, 2))]
        self.path = json.dumps({'strokes': [{'laser': {'radius': 0.02, 'range': [0, 10]}, 'keys': keys}]}).encode()
        with open(os.path.join(self.folder, 'path.json'), 'wb') as file:
            file.write(self.path)
        with open(SPHERE, 'rb') as file:
            self.mesh = file.read()

    def kerf(self, *words, status=0, **options):
        done = subprocess.run([KERF, *words], capture_output=True, cwd=self.folder, **options)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def report(self, out='out'):
        with open(os.path.join(self.folder, out, 'report.json'), encoding='utf-8') as file:
            return json.load(file)

    def test_info_reads_a_mesh_from_standard_input(self):
        piped = json.loads(self.kerf('info', '-', input=self.mesh).stdout)
        named = json.loads(self.kerf('info', SPHERE).stdout)
        self.assertEqual(piped.pop('file'), '-')
        named.pop('file')
        self.assertEqual(piped, named)

    def test_prepare_works_as_a_filter(self):
        self.kerf('prepare', SPHERE, '--simplify', '500', '-o', 'light.obj')
        with open(os.path.join(self.folder, 'light.obj'), 'rb') as file:
            light = file.read()
        done = self.kerf('prepare', '-', '--simplify', '500', '-o', '-', input=self.mesh)
        self.assertEqual(done.stdout, light)
        self.assertIn(b'in standard output', done.stderr)
        ply = self.kerf('prepare', '-', '--smooth', '1', '--out', '-', '--format', 'ply', input=self.mesh).stdout
        self.assertEqual(json.loads(self.kerf('info', '-', input=ply).stdout)['format'], 'ply')
        for words in (('-o', 'x.obj', '--format', 'ply'), ('-o', '-', '--format', 'jpg')):
            said = self.kerf('prepare', '-', '--smooth', '1', *words, input=self.mesh, status=2)
            self.assertIn(b'--format', said.stderr)

    def test_a_cut_reads_its_mesh_or_path_from_standard_input(self):
        self.kerf('cut', SPHERE, '--path', 'path.json', '-o', 'out')
        wanted = self.report()
        self.kerf('cut', '-', '--path', 'path.json', '-o', 'mesh', input=self.mesh)
        self.kerf('cut', SPHERE, '--path', '-', '-o', 'path', input=self.path)
        for out, inputs in (('mesh', ['-', 'path.json']), ('path', [SPHERE, '-'])):
            self.assertEqual(self.report(out)['state_hash'], wanted['state_hash'])
            self.assertEqual(self.report(out)['inputs'], inputs)

    def test_warnings_name_standard_output(self):
        far = b'v 1000000 0 0\nv 1000000.001 0 0\nv 1000000 0.001 0\nf 1 2 3\n'
        done = self.kerf('prepare', '-', '--subdivide', 'midpoint', '--out', '-', '--format', 'stl', input=far)
        self.assertIn(b'kerf: warning: standard output: STL stores single precision', done.stderr)

    def test_notes_name_standard_input(self):
        keys = [{'t': t, 'origin': [x, 3, 0.1], 'direction': [0, -1, 0]} for t, x in ((0, 0), (1, 2))]
        knife = json.dumps({'strokes': [{'laser': {'radius': 0, 'range': [0, 10]}, 'keys': keys}]})
        with open(os.path.join(self.folder, 'knife.json'), 'w', encoding='utf-8') as file:
            file.write(knife)
        self.kerf('cut', '-', '--path', 'knife.json', '-o', 'out', input=self.mesh)
        self.assertRegex(self.report()['notes'][0], '^standard input.*: the part stays connected')

    def test_errors_name_standard_input(self):
        for words, given in ((('info', '-'), b'rubbish'), (('cut', SPHERE, '--path', '-', '-o', 'x'), b'{"strokes": 5}'),
                             (('prepare', '-', '--smooth', '1', '-o', '-'), b'')):
            done = self.kerf(*words, input=given, status=2)
            self.assertIn(b'standard input: ', done.stderr)
            self.assertNotIn(b'/proc', done.stderr)
            self.assertEqual(done.stdout, b'')
        for words in (('cut', '-', '--path', '-', '-o', 'x'), ('cut', '-', '-o', 'x', '--journal', 'x.kerf')):
            done = self.kerf(*words, input=self.mesh, status=2)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)

    def test_short_options_and_the_help_command(self):
        self.assertEqual(self.kerf('-h').stdout, self.kerf('--help').stdout)
        self.assertEqual(self.kerf('help').stdout, self.kerf('--help').stdout)
        self.assertEqual(self.kerf('-V').stdout, self.kerf('--version').stdout)
        for command in re.findall(r'^  ([a-z]+) ', self.kerf('-h').stdout.decode().split('Subcommands:')[1], re.MULTILINE):
            wanted = self.kerf(command, '--help').stdout
            self.assertEqual(self.kerf('help', command).stdout, wanted)
            self.assertEqual(self.kerf(command, '-h').stdout, wanted)
            self.assertIn(b'-q,--quiet', wanted)
        self.assertIn(b'help: "cutt" is not a command; the nearest name is "cut"', self.kerf('help', 'cutt', status=2).stderr)

    def test_quiet_prints_no_summary(self):
        for words in (('cut', SPHERE, '--path', 'path.json', '-o', 'out'), ('prepare', SPHERE, '--smooth', '1', '-o', 'x.obj')):
            self.assertEqual(len(self.kerf(*words).stderr.splitlines()), 1)
            self.assertEqual(self.kerf(*words, '-q').stderr, b'')
        match = ('play', '--headless', '--driver', 'still', '--seconds', '0.5')
        self.assertIn(b'kerf: quit after ', self.kerf(*match).stderr)
        self.assertEqual(self.kerf(*match, '-q').stderr, b'')

    def test_reports_state_their_provenance_and_match_their_schema(self):
        with open(os.path.join(ROOT, 'app/report.schema.json'), encoding='utf-8') as file:
            schema = json.load(file)
        self.kerf('cut', SPHERE, '--path', 'path.json', '-o', 'first', '--journal', "it's.kerf", '--depth', '2')
        runs = (('cut', SPHERE, '--path', 'path.json'), ('cut', SPHERE, '--path', 'path.json', '--solid', '--format', 'stl'),
                ('cut', SPHERE, '--path', 'path.json', '--model', 'thermal', '--thickness', '0.0001', '--material', 'mild-steel',
                 '--assist', 'oxygen'),
                ('cut', SPHERE, '--settle', '0.1', '--split-all', '--recentre'), ('replay', "it's.kerf"),
                ('cut', SPHERE, '--plane', '0,1,0,0.01', '--fit-bed', '9,9,9', '--lay-flat', '--solid'),
                ('cut', os.path.join(ROOT, 'assets/scenes/car-cut.json'), '--tolerance', '0.01'))
        for words in runs:
            with self.subTest(words):
                self.kerf(*words, '--out', 'out')
                report = self.report()
                self.assertEqual(list(faults(report, schema, schema)), [])
                self.assertEqual(shlex.split(report['command'])[1:], [*words, '--out', 'out'])
                self.assertEqual(report['inputs'], [word for word in words[1:] if re.search(r'[.](obj|json|kerf)$', word)])
                self.assertEqual(report['version'], self.kerf('--version').stdout.decode().split()[1])
        broken = {**report, 'steps': -1, 'state_hash': 'x', 'more': 1}
        broken.pop('notes')
        self.assertEqual(len(list(faults(broken, schema, schema))), 4)


unittest.main()
