"""Cuts along drawings and programs, and conversions between them. `jobs_test.py KERF`."""
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

KERF = os.path.abspath(sys.argv.pop(1))
DRAWINGS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), 'assets', 'drawings')
RADIUS = 0.0002
SVG = ('<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 200 200">'
       '<g transform="translate(20 20)"><path d="M0,0h60v60h-60z"/></g><circle cx="140" cy="140" r="30"/>'
       '<text>A</text></svg>')


class Jobs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, text):
        with open(self.path(name), 'w', encoding='utf-8') as file:
            file.write(text)
        return self.path(name)

    def sheet(self, half, middle=(0, 0, 0), axes=((1, 0, 0), (0, 0, 1))):
        """A square in two triangles."""
        corners = [[m + half * (s * a + t * b) for m, a, b in zip(middle, *axes)] for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        return self.write('sheet.obj', ''.join('v {} {} {}\n'.format(*c) for c in corners) + 'f 1 4 3\nf 1 3 2\n')

    def kerf(self, *arguments, status=0):
        done = subprocess.run([KERF, *map(str, arguments)], capture_output=True, text=True, check=False)
        self.assertEqual(status, done.returncode, done.stderr)
        return done.stderr

    def cut(self, sheet, *options):
        self.kerf('cut', sheet, '--radius', RADIUS, '--rim', 'smooth', '--out', self.path('out'), *options)
        with open(self.path('out/report.json'), encoding='utf-8') as file:
            return json.load(file)

    def areas(self, report):
        """Areas of the drops, without slivers at sharp corners of the kerf."""
        return sorted(piece['area'] for piece in report['pieces'] if piece['area'] > 1e-9)[:-1]

    def test_a_drawing_cuts_drops_of_its_areas_less_the_kerf(self):
        svg = self.write('a.svg', SVG)
        report = self.cut(self.sheet(.05), '--drawing', svg, '--onto', '-y', '--at', '0,1,0', '--range', '0,2')
        circle, square = self.areas(report)
        self.assertAlmostEqual(square, (.03 - 2 * RADIUS)**2, delta=1e-6)
        self.assertAlmostEqual(circle, math.pi * (.015 - RADIUS)**2, delta=1e-6)
        # The square lies to the left (-x) and at the top (-z).
        drops = sorted(report['pieces'], key=lambda piece: piece['area'])
        self.assertAlmostEqual(drops[0]['centroid'][0], .02, delta=1e-4)
        self.assertAlmostEqual(drops[1]['centroid'][0], -.025, delta=1e-4)
        self.assertAlmostEqual(drops[1]['centroid'][2], -.025, delta=1e-4)
        self.assertIn(f'{svg}: left out: 1 text', report['notes'])
        self.assertIn(svg, report['inputs'])

    def test_a_drawing_lies_above_the_middle_upright_turned_and_scaled(self):
        svg = self.write('a.svg', SVG)
        sheet = self.sheet(.1, (3, 2, 1), ((0, 0, 1), (0, 1, 0)))
        report = self.cut(sheet, '--drawing', svg, '--onto', '-x', '--turn', 90, '--scale', 1.5)
        circle, square = sorted(report['pieces'], key=lambda piece: piece['area'])[:2]
        self.assertAlmostEqual(square['area'], (.045 - 2 * RADIUS)**2, delta=2e-6)
        # Right is -z and up is +y; a quarter turn takes the upper left (-1, 1) to the lower left (-1, -1).
        for got, wanted in zip(square['centroid'], (3, 2 - .0375, 1 + .0375)):
            self.assertAlmostEqual(got, wanted, delta=1e-4)
        for got, wanted in zip(circle['centroid'], (3, 2 + .03, 1 - .03)):
            self.assertAlmostEqual(got, wanted, delta=1e-4)

    def test_a_compensated_flange_has_the_areas_of_the_drawing(self):
        nc = self.path('flange.nc')
        self.kerf('path', os.path.join(DRAWINGS, 'flange.dxf'), '--out', nc, '--compensate', 'right', '--radius', RADIUS)
        report = self.cut(self.sheet(.08), '--gcode', nc, '--at', '0,1,0', '--range', '0,2')
        areas = self.areas(report)
        self.assertEqual(14, len(areas))  # twelve holes, the bore and the flange
        flange = math.pi * (.06**2 - .03**2 - 12 * .004**2)
        # 2 % of the radius along all lines.
        self.assertAlmostEqual(areas[-1], flange, delta=.02 * RADIUS * 2 * math.pi * (.06 + .03 + 12 * .004))
        for area in areas[:12]:
            self.assertAlmostEqual(area, math.pi * (.004 - 2 * RADIUS)**2, delta=1e-7)
        # Holes come first, the outline last.
        with open(nc, encoding='utf-8') as file:
            starts = [[float(word[1:]) for word in line.split()[1:3]] for line in file if line.startswith('G0')]
        self.assertEqual(14, len(starts))
        self.assertAlmostEqual(math.hypot(*starts[-1]), 60 + 1000 * RADIUS, delta=.02 * 1000 * RADIUS)

    def test_a_program_becomes_a_path_with_power_and_the_report_states_its_duration(self):
        nc = self.write('a.nc', '%\nG21 G90 G17\nM4 S0\nG0 X10 Y10\nG1 X40 S800 F1200\nG1 Y40\nG2 X40 Y60 I0 J10\nG1 X10\n'
                                'G1 Y10\nM5\nM2\n%\n')
        self.kerf('path', nc, '--out', self.path('a.json'), '--power-at-s1000', 2000)
        with open(self.path('a.json'), encoding='utf-8') as file:
            stroke, = json.load(file)['strokes']
        self.assertEqual(1600, stroke['laser']['power'])
        self.assertEqual([.01, 0, -.01], stroke['keys'][0]['origin'])
        way = 30 + 30 + math.pi * 10 + 30 + 50
        self.assertAlmostEqual(stroke['keys'][-1]['t'] - stroke['keys'][0]['t'], way / 20, delta=1e-6)
        report = self.cut(self.sheet(.1), '--gcode', nc)
        self.assertAlmostEqual(report['program_ms'], 1000 * way / 20 + 1000 * math.hypot(.01, .01) * 6, delta=1)
        # An arc from (40, 40) to (40, 60) about (40, 50), clockwise: on the left, into the rectangle.
        self.assertAlmostEqual(self.areas(report)[0], .03 * .05 - math.pi * .01**2 / 2 - RADIUS * way / 1000, delta=1e-6)

    def strokes(self, name):
        with open(self.path(name), encoding='utf-8') as file:
            return json.load(file)['strokes']

    def test_a_program_keeps_its_powers_and_speeds_where_it_is_rewritten(self):
        nc = self.write('a.nc', 'G21 G90\nM4\nG0 X0 Y0\nG1 X40 S200 F3000\nG1 Y40\nG1 X0\nG1 Y0\n'
                                'G0 X10 Y10\nG1 X30 S1000 F600\nG1 Y30\nG1 X10\nG1 Y10\nM5\n')
        for options in ([], ['--tabs', '2,0.001', '--radius', '0.0001']):
            self.kerf('path', nc, '--out', self.path('b.nc'), *options)
            self.kerf('path', self.path('b.nc'), '--out', self.path('c.json'), '--power-at-s1000', 1000)
            seen = set()
            for stroke in self.strokes('c.json'):
                keys = stroke['keys']
                way = sum(math.dist(a['origin'], b['origin']) for a, b in zip(keys, keys[1:]))
                seen.add((round(stroke['laser']['power']), round(way / (keys[-1]['t'] - keys[0]['t']), 6)))
            self.assertEqual({(200, .05), (1000, .01)}, seen)

    def test_a_program_keeps_s_if_its_controller_has_another_full_power(self):
        nc = self.write('a.nc', 'G21 G90\nM4\nG0 X0 Y0\nG1 X40 S255 F3000\nG0 X0 Y10\nG1 X40 S51\nM5\n')
        self.kerf('path', nc, '--out', self.path('b.nc'), '--post', self.write('post.json', '{"full_power": 255}'))
        with open(self.path('b.nc'), encoding='utf-8') as file:
            words = [word for line in file if not line.startswith('(') for word in line.split()]
        self.assertEqual([255, 51], [round(float(word[1:]), 9) for word in words if word.startswith('S')])

    def test_tabs_keep_the_speed_of_a_stroke_that_dwells(self):
        keys = [{'t': t, 'origin': [x, 1, z], 'direction': [0, -1, 0]} for t, x, z in (
            (0, 0, 0), (.5, 0, 0), (1.5, .04, 0), (2.5, .04, .04), (3.5, 0, .04), (4.5, 0, 0))]
        path = self.write('a.json', json.dumps({'strokes': [{'laser': {'radius': RADIUS}, 'keys': keys}]}))
        self.kerf('path', path, '--out', self.path('b.json'), '--tabs', '2,0.001')
        strokes = self.strokes('b.json')
        self.assertEqual(2, len(strokes))
        for keys in (stroke['keys'] for stroke in strokes):
            way = sum(math.dist(a['origin'], b['origin']) for a, b in zip(keys, keys[1:]))
            self.assertAlmostEqual(.04, way / (keys[-1]['t'] - keys[0]['t']))

    def test_tabs_keep_the_height_of_each_stroke(self):
        nc = self.write('a.nc', 'G21 G90\n' + ''.join(
            f'G0 X{x} Y0 Z{z}\nM3 S1000\nG1 X{x + 20} F1000\nY20\nX{x}\nY0\nM5\n' for x, z in ((0, 5), (100, -2))))
        self.kerf('path', nc, '--out', self.path('b.json'), '--tabs', '2,0.001', '--radius', RADIUS)
        seen = {(key['origin'][0] > .05, key['origin'][1]) for stroke in self.strokes('b.json') for key in stroke['keys']}
        self.assertEqual({(False, .005), (True, -.002)}, seen)

    def test_strokes_that_stand_still_are_left_out_of_lines_with_a_warning(self):
        point = 'G0 X5 Y5\nM3 S1000\nG1 F1000\nG4 P1\nM5\n'
        nc = self.write('a.nc', 'G21 G90\n' + point + 'G0 X10 Y10\nM3\nG1 X30\nY30\nX10\nY10\nM5\n')
        for out, options in (('b.svg', []), ('b.json', ['--tabs', '2,0.001', '--radius', RADIUS])):
            said = self.kerf('path', nc, '--out', self.path(out), *options)
            self.assertIn(f'{nc}: left out: 1 stroke that stands still', said)
            self.assertIn('\nkerf: 2 strokes' if options else '\nkerf: 1 stroke ', said)
        self.assertNotIn('left out', self.kerf('path', nc, '--out', self.path('b.json')))
        nc = self.write('a.nc', 'G21 G90\n' + 2 * point)
        said = self.kerf('path', nc, '--out', self.path('c.svg'), status=2)
        self.assertIn('left out: 2 strokes that stand still', said)
        self.assertIn('nothing is left to write', said)
        self.assertFalse(os.path.exists(self.path('c.svg')))

    def test_layers_keep_their_order_and_the_radius_is_that_of_the_compensation(self):
        square = 'M{0} {0}h{1}v{1}h-{1}z'
        svg = self.write('a.svg', '<svg width="100mm" height="100mm" viewBox="0 0 100 100"><path stroke="red" d="' +
                         square.format(20, 60) + '"/><path stroke="blue" d="' + square.format(40, 20) + '"/></svg>')
        layers = self.write('layers.json', json.dumps({'layers': {'red': {'radius': .0005, 'power': 1, 'order': 1},
                                                                  'blue': {'power': 2, 'order': 2}}}))
        self.kerf('path', svg, '--out', self.path('a.json'), '--compensate', 'right', '--radius', RADIUS, '--layers', layers)
        self.assertEqual([(1, RADIUS), (2, RADIUS)],
                         [(stroke['laser']['power'], stroke['laser']['radius']) for stroke in self.strokes('a.json')])

    def test_conversions_restore_the_path(self):
        svg = self.write('a.svg', SVG)
        strokes = []
        for name in ('a.json', 'b.nc', 'c.json', 'd.svg', 'e.json'):
            self.kerf('path', svg if name == 'a.json' else source, '--out', self.path(name))
            source = self.path(name)
            if name.endswith('.json'):
                with open(source, encoding='utf-8') as file:
                    strokes.append([[key['origin'] for key in stroke['keys']] for stroke in json.load(file)['strokes']])
        for back in strokes[1:]:
            self.assertEqual([len(keys) for keys in strokes[0]], [len(keys) for keys in back])
            for keys, again in zip(strokes[0], back):
                for p, q in zip(keys, again):
                    self.assertLess(math.dist(p, q), 1e-12)

    def test_the_duration_of_a_path_is_stated_however_long_it_is(self):
        keys = [{'t': t, 'origin': [x, 1, 0], 'direction': [0, -1, 0]} for t, x in ((0, 0), (119.5, .01))]
        for end, text in ((119.5, ', 120 s, '), (1e300, ', 1e+300 s, ')):
            keys[1]['t'] = end
            path = self.write('long.json', json.dumps({'strokes': [{'keys': keys}]}))
            self.assertIn(text, self.kerf('path', path, '--out', self.path('again.json')))

    def test_bad_input_names_its_place_and_writes_nothing(self):
        bad = self.write('bad.nc', 'G21\nG1 X10 F100\nG2 X5 Y5 I100 J100\n')
        self.assertIn('bad.nc, line 3, column 1: ', self.kerf('path', bad, '--out', self.path('x.json'), status=2))
        self.assertIn('bad.nc, line 3', self.kerf('cut', self.sheet(1), '--gcode', bad, '--out', self.path('out'), status=2))
        svg = self.write('bad.svg', '<svg>\n<path d="M0 0 R"/></svg>')
        self.assertIn("bad.svg, line 2, column 15: d: 'R' is no command", self.kerf(
            'cut', self.sheet(1), '--drawing', svg, '--out', self.path('out'), status=2))
        self.assertFalse(os.path.exists(self.path('out')) or os.path.exists(self.path('x.json')))
        good = self.write('good.svg', SVG)
        for options, words in (
                (['--onto', '-y'], 'require --drawing or --gcode'),
                (['--drawing', good, '--onto', 'y'], '--onto: "y" is not a valid value'),
                (['--drawing', good, '--at', '1,2'], '--at: must be three numbers'),
                (['--drawing', good, '--power-at-s1000', '5'], 'requires --gcode'),
                (['--drawing', good, '--gcode', bad], 'give only one of them'),
                (['--drawing', self.sheet(1)], 'must end in .svg or .dxf')):
            self.assertIn(words, self.kerf('cut', self.sheet(1), *options, '--out', self.path('out'), status=2))
        for options, words in (
                (['--compensate', 'up'], 'the values are: left, right, none'),
                (['--compensate', 'left'], 'require --radius'),
                (['--lead-in', '1'], 'requires --compensate'),
                (['--tabs', '2'], '--tabs: must be N,M')):
            self.assertIn(words, self.kerf('path', good, *options, '--out', self.path('x.nc'), status=2))
        self.assertIn('--power-at-s1000: requires a program',
                      self.kerf('path', good, '--power-at-s1000', 5, '--out', self.path('x.json'), status=2))
        self.assertIn('.json, .svg or .nc', self.kerf('path', good, '--out', self.path('x.dxf'), status=2))
        self.assertIn('good.svg', self.kerf('path', good, '--out', good, status=2))

    def area_of_lines(self, drawing):
        """The area that the lines of a drawing enclose; holes run the other way."""
        self.kerf('path', drawing, '--out', self.path('lines.json'))
        with open(self.path('lines.json'), encoding='utf-8') as file:
            strokes = json.load(file)['strokes']
        area = 0
        for stroke in strokes:
            points = [(key['origin'][0], -key['origin'][2]) for key in stroke['keys']]
            area += sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:])) / 2
        return area, len(strokes)

    def test_flat_pieces_have_outlines_of_their_areas(self):
        nc = self.path('flange.nc')
        self.kerf('path', os.path.join(DRAWINGS, 'flange.dxf'), '--out', nc, '--compensate', 'right', '--radius', RADIUS)
        for ending in ('svg', 'dxf'):
            report = self.cut(self.sheet(.08), '--gcode', nc, '--at', '0,1,0', '--range', '0,2', '--outlines', ending)
            flange = sorted(report['pieces'], key=lambda piece: piece['area'])[-2]
            area, lines = self.area_of_lines(self.path('out/' + flange['outline']))
            self.assertEqual(14, lines)
            self.assertAlmostEqual(area, flange['area'], delta=1e-12)
            self.assertAlmostEqual(area, math.pi * (.06**2 - .03**2 - 12 * .004**2), delta=.02 * RADIUS * 2 * math.pi * (.06 + .03 + 12 * .004))
            outlines = {piece['outline'] for piece in report['pieces']}
            self.assertEqual(outlines, {name for name in os.listdir(self.path('out')) if name.endswith(('.svg', '.dxf'))})

    def test_a_piece_that_is_not_flat_has_no_outline(self):
        self.kerf('cut', os.path.join(os.path.dirname(DRAWINGS), 'meshes/sphere.obj'), '--outlines', 'svg', '--out', self.path('out'))
        with open(self.path('out/report.json'), encoding='utf-8') as file:
            report = json.load(file)
        self.assertNotIn('outline', report['pieces'][0])
        self.assertIn('1 piece is not flat and has no outline', report['notes'])

    def test_a_post_processor_sets_the_dialect_of_a_program(self):
        svg = self.write('a.svg', SVG)
        self.kerf('path', svg, '--out', self.path('a.nc'), '--post', os.path.join(DRAWINGS, 'grbl.json'))
        with open(self.path('a.nc'), encoding='utf-8') as file:
            lines = file.read().splitlines()
        self.assertEqual('G21 G90 G17 G94', lines[1])
        self.assertEqual(('M4 S1000.0000', 'M5', 'M2'), (lines[3], lines[-2], lines[-1]))
        self.assertLess(max(map(len, lines)), 80)
        for name in ('grbl', 'linuxcnc'):
            self.kerf('path', svg, '--out', self.path('a.nc'), '--post', os.path.join(DRAWINGS, name + '.json'))
            self.kerf('path', self.path('a.nc'), '--out', self.path('b.json'))
        # GRBL's M4 adapts the power to the speed.
        dwells = {'keys': [{'t': t, 'origin': [x, 0, 0], 'direction': [0, -1, 0]} for t, x in ((0, 0), (1, 0), (2, 1))]}
        path = self.write('dwells.json', json.dumps({'strokes': [dwells, {'keys': dwells['keys'][:1]}, {'keys': dwells['keys'][1:]}]}))
        for name, warned in (('grbl', True), ('linuxcnc', False)):
            said = self.kerf('path', path, '--out', self.path('a.nc'), '--post', os.path.join(DRAWINGS, name + '.json'))
            self.assertEqual(warned, 'a.nc: with M4 of --post the laser is off in the dwells of 2 strokes' in said)
        wrong = self.write('post.json', '{"on": "M3"}')
        self.assertIn('post.json: /on', self.kerf('path', svg, '--out', self.path('b.nc'), '--post', wrong, status=2))
        self.assertIn('--post: requires an --out that ends in .nc', self.kerf('path', svg, '--out', self.path('b.svg'), '--post', wrong, status=2))

    def test_a_drawing_seen_from_an_eye_is_cut_as_large_as_it_looks_on_the_sheet(self):
        svg = self.write('a.svg', '<svg width="20mm" height="20mm" viewBox="0 0 20 20"><path d="M5 5h10v10h-10z"/></svg>')
        # The plane of the drawing is half-way from the eye to the sheet in y = 0, so the square is twice as large.
        report = self.cut(self.sheet(.05), '--drawing', svg, '--eye', '0,.5,0', '--at', '0,.25,0')
        drop, = self.areas(report)
        self.assertAlmostEqual(drop, (.02 - 2 * RADIUS)**2, delta=1e-6)
        for wrong, why in ((['--eye', '0,1,0'], 'requires --drawing'),
                           (['--eye', '0,0,0', '--drawing', svg], '--eye: is the middle of the drawing'),
                           (['--eye', '0,1,0', '--onto', '-y', '--drawing', svg], 'cannot be combined')):
            self.assertIn(why, self.kerf('cut', self.sheet(1), *wrong, '--out', self.path('o'), status=2))

    def test_layers_and_colours_have_settings_and_an_order(self):
        svg = self.write('a.svg', '<svg width="100mm" height="100mm" viewBox="0 0 100 100"><path stroke="red" d="M10 10h20"/>'
                                  '<path stroke="#00F" d="M10 20h20"/><path stroke="green" d="M10 30h20"/></svg>')
        layers = self.write('layers.json', json.dumps({'layers': {
            '#0000ff': {'speed': .01, 'power': 500, 'order': 1}, 'red': {'radius': .001, 'order': 2}, 'green': {'skip': True},
            'teal': {}}}))
        self.assertIn('"teal"', self.kerf('path', svg, '--layers', layers, '--out', self.path('a.json')))
        with open(self.path('a.json'), encoding='utf-8') as file:
            blue, red = json.load(file)['strokes']
        self.assertEqual((500, .001), (blue['laser']['power'], red['laser']['radius']))
        self.assertAlmostEqual(2, blue['keys'][-1]['t'])
        self.assertAlmostEqual(1, red['keys'][-1]['t'])
        report = json.loads('{}')
        self.kerf('cut', self.sheet(.06), '--drawing', svg, '--layers', layers, '--rim', 'smooth', '--out', self.path('out'))
        with open(self.path('out/report.json'), encoding='utf-8') as file:
            report = json.load(file)
        # A slot of radius .001 and one of the default.
        self.assertGreater(report['removed']['area'], .02 * .002)
        self.assertIn('requires --drawing', self.kerf('cut', self.sheet(1), '--layers', layers, '--out', self.path('o'), status=2))

    def test_the_report_lists_segments_that_are_not_cut_through_and_parts_that_drop_early(self):
        # Fast along the first segment, slow along the second.
        keys = [{'t': t, 'origin': [x, 1, 0], 'direction': [0, -1, 0]} for t, x in ((0, -.005), (.0025, 0), (.5025, .005))]
        path = self.write('a.json', json.dumps({'strokes': [{'laser': {'radius': .0002, 'power': 1000}, 'keys': keys}]}))
        self.kerf('cut', self.sheet(.05), '--path', path, '--model', 'thermal', '--out', self.path('out'))
        with open(self.path('out/report.json'), encoding='utf-8') as file:
            report = json.load(file)
        self.assertEqual([(0, 0)], [(s['stroke'], s['segment']) for s in report['uncut']])
        self.assertTrue(0 < report['uncut'][0]['depth'] < 1)
        # The outline comes first, so a hole in it is cut in a part that has dropped.
        square = 'M{0} {0}h{1}v{1}h-{1}z'
        svg = self.write('b.svg', '<svg width="100mm" height="100mm" viewBox="0 0 100 100"><path d="' + square.format(20, 60) +
                         '"/><path d="' + square.format(40, 20) + '"/></svg>')
        report = self.cut(self.sheet(.05), '--drawing', svg, '--journal', self.path('b.kerf'))
        scrap, = report['scrap']
        self.assertEqual((1, 0), (scrap['stroke'], scrap['freed_by']))
        self.kerf('replay', self.path('b.kerf'), '--out', self.path('again'))
        with open(self.path('again/report.json'), encoding='utf-8') as file:
            again, = json.load(file)['scrap']
        self.assertEqual({key: scrap[key] for key in ('stroke', 'freed_by', 'piece')}, {key: again[key] for key in ('stroke', 'freed_by', 'piece')})
        self.assertNotIn('segment', again)
        self.assertAlmostEqual(scrap['area'], 4 * .02 * 2 * RADIUS, delta=.01 * scrap['area'])
        self.kerf('path', svg, '--out', self.path('c.json'), '--compensate', 'right', '--radius', RADIUS)
        self.kerf('cut', self.sheet(.05), '--path', self.path('c.json'), '--out', self.path('out'), '--range', '0,9', '--rim', 'smooth')
        with open(self.path('out/report.json'), encoding='utf-8') as file:
            self.assertNotIn('scrap', json.load(file))

    def tube(self, radius, length, sectors=360):
        """An open tube round the z axis."""
        ring = [(radius * math.cos(2 * math.pi * i / sectors), radius * math.sin(2 * math.pi * i / sectors)) for i in range(sectors)]
        text = ''.join('v {} {} {}\n'.format(x, y, z) for z in (-length / 2, length / 2) for x, y in ring)
        for i in range(sectors):
            j = (i + 1) % sectors
            text += f'f {i + 1} {j + 1} {sectors + j + 1}\nf {i + 1} {sectors + j + 1} {sectors + i + 1}\n'
        return self.write('tube.obj', text)

    def solid_tube(self, outer=.025, inner=.0225, length=.1, sectors=180):
        """A solid tube along the x axis, and the ratio of its section to that of round walls."""
        angles = [2 * math.pi * i / sectors for i in range(sectors)]
        text = ''.join(f'v {x!r} {r * math.cos(a)!r} {r * math.sin(a)!r}\n' for x in (-length / 2, length / 2) for r in (outer, inner) for a in angles)
        quads = []
        for i in range(sectors):
            j = (i + 1) % sectors
            o, p, q, r = ((k * sectors + i + 1, k * sectors + j + 1) for k in range(4))  # outer and inner, at both ends
            quads += [(o[0], q[0], q[1], o[1]), (p[1], r[1], r[0], p[0]), (o[0], o[1], p[1], p[0]), (q[1], q[0], r[0], r[1])]
        text += ''.join('f {0} {3} {2}\nf {0} {2} {1}\n'.format(*quad) for quad in quads)
        return self.write('solid.obj', text), math.sin(2 * math.pi / sectors) * sectors / (2 * math.pi)

    AXES = {'axes': [{'letter': 'A', 'turns': 'table', 'axis': [1, 0, 0], 'pivot': [0, 0, 0]}]}

    def rotary(self, program, *options, radius=.001, axes=None):
        """Cuts a solid tube by a program, with the report."""
        nc = self.write('rotary.nc', program)
        mesh, _ = self.solid_tube()
        self.kerf('cut', mesh, '--solid', '--gcode', nc, '--axes', self.write('axes.json', json.dumps(axes or self.AXES)),
                  '--radius', radius, '--out', self.path('out'), *options)
        with open(self.path('out/report.json'), encoding='utf-8') as file:
            return json.load(file)

    def test_a_rotary_axis_cuts_a_window_in_a_solid_tube(self):
        radius, width, turn = .001, .02, math.radians(50)
        report = self.rotary('G21 G90\nG0 X-10 Z27 A-25\nM3 S1\nG1 X10 F1200\nA25 F600\nX-10 F1200\nA-25 F600\nM5\n', '--range', '0,0.027')
        self.assertEqual([], report['notes'])
        self.assertTrue(all(piece['closed'] for piece in report['pieces']))
        # A band along a rectangle on each cylinder, with round corners outside, and the rectangle within it.
        integral = lambda f: sum(f(.0225 + .0025 * (i + .5) / 100) for i in range(100)) * .0025 / 100
        removed = integral(lambda r: 4 * radius * (width + turn * r) + math.pi * radius**2 - 4 * radius**2)
        window = integral(lambda r: (width - 2 * radius) * (turn * r - 2 * radius))
        self.assertAlmostEqual(report['removed']['volume'], removed, delta=.003 * removed)
        self.assertAlmostEqual(report['pieces'][1]['volume'], window, delta=.003 * window)
        # Two moves of 20 mm at 20 mm/s, two of 50 degrees at 10 degrees/s, and a rapid one.
        self.assertAlmostEqual(report['program_ms'], 12000 + 1000 * max(math.hypot(.01, .027) * 6, 25 / 60), delta=1e-6)

    def test_a_whole_turn_cuts_a_tube_in_two(self):
        report = self.rotary('G21 G90\nG0 X10 Z27\nM3 S1\nG1 A380 F2000\nM5\n', '--range', '0,0.027', '--target-edge', .002)
        self.assertEqual([], report['notes'])
        section = math.pi * (.025**2 - .0225**2) * self.solid_tube()[1]
        self.assertEqual([True, True], [piece['closed'] for piece in report['pieces']])
        for piece, length in zip(report['pieces'], (.059, .039)):
            self.assertAlmostEqual(piece['volume'], section * length, delta=1e-4 * section * length)

    def test_wrong_rotary_axes_are_one_sentence(self):
        nc = self.write('a.nc', 'G21\nG1 X1 F100 A5\n')
        for axes, words in (
                (None, 'a.nc, line 2, column 12: A5 is not supported without a description'),
                ({'axes': []}, 'axes.json: /axes: must list an axis'),
                ({'axes': self.AXES['axes'] * 2}, 'axes.json: /axes/1/letter'),
                ({'axes': [dict(self.AXES['axes'][0], letter='X')]}, '/axes/0/letter: must be "A", "B" or "C"'),
                ({'axes': [dict(self.AXES['axes'][0], turns='bed')]}, '/axes/0/turns'),
                ({'axes': [dict(self.AXES['axes'][0], axis=[0, 0, 0])]}, '/axes/0/axis')):
            options = [] if axes is None else ['--axes', self.write('axes.json', json.dumps(axes))]
            self.assertIn(words, self.kerf('path', nc, '--out', self.path('a.json'), *options, status=2))
        self.assertIn('--axes: requires --gcode', self.kerf('cut', self.sheet(1), '--axes', nc, '--out', self.path('o'), status=2))

    def test_uncut_and_scrap_name_the_lines_of_the_program(self):
        # The arc is too fast, and one segment.
        nc = self.write('a.nc', 'G21 G90 M3 S1000\nG1 X2 F600\nG2 X6 Y0 I2 J0 F120000\nG1 X8 F600\nM5\n')
        self.kerf('cut', self.sheet(.05), '--gcode', nc, '--power-at-s1000', 1000, '--radius', RADIUS, '--model', 'thermal', '--out', self.path('out'))
        with open(self.path('out/report.json'), encoding='utf-8') as file:
            report = json.load(file)
        self.assertEqual([3], [s['line'] for s in report['uncut']])
        square = 'G0 X{0} Y{0}\nM3 S1\nG1 X{1} F1000\nY{1}\nX{0}\nY{0}\nM5\n'
        nc = self.write('b.nc', 'G21 G90\n' + square.format(-20, 20) + square.format(-5, 5))
        report = self.cut(self.sheet(.05), '--gcode', nc)
        scrap, = report['scrap']
        self.assertEqual((1, 0, 11), (scrap['stroke'], scrap['freed_by'], scrap['line']))
        self.assertLess(math.hypot(*scrap['at']), 1e-4)
        piece, = (p for p in report['pieces'] if p['file'] == scrap['piece'])
        self.assertAlmostEqual(piece['area'], (.04 - 2 * RADIUS)**2 - (.01 + 2 * RADIUS)**2, delta=1e-6)

    def test_strokes_are_fitted_to_datum_points_and_to_the_mesh_as_measured(self):
        nc = self.write('a.nc', 'G21 G90\nG0 X-5 Y-5\nM3 S1\nG1 X5 F1000\nY5\nX-5\nY-5\nM5\n')
        turn, shift = math.radians(30), (.3, .02, -.1)
        moved = lambda p: [math.cos(turn) * p[0] + math.sin(turn) * p[2] + shift[0], p[1] + shift[1], -math.sin(turn) * p[0] + math.cos(turn) * p[2] + shift[2]]
        points = [[0, 0, 0], [.04, 0, 0], [0, .03, .02], [-.01, 0, .05]]
        fit = self.write('fit.json', json.dumps({'points': [{'planned': p, 'measured': moved(p)} for p in points]}))
        sheet = self.sheet(.02, shift)
        report = self.cut(sheet, '--gcode', nc, '--at', '0,0.01,0', '--fit', fit)
        self.assertLess(report['fit']['residuals']['max'], 1e-12)
        self.assertEqual(4, len(report['fit']['residuals']['points']))
        drop = min(report['pieces'], key=lambda piece: piece['area'])
        self.assertLess(math.dist(drop['centroid'], shift), 1e-4)
        # A bent sheet as planned, and as measured.
        tent = [(-.04, 0, -.02), (.03, 0, -.02), (.03, 0, .025), (-.04, 0, .02), (0, .02, 0)]
        faces = ''.join('f 5 {} {}\n'.format((k + 1) % 4 + 1, k + 1) for k in range(4))
        planned = self.write('planned.obj', ''.join('v {} {} {}\n'.format(*p) for p in tent) + faces)
        part = self.write('part.obj', ''.join('v {} {} {}\n'.format(*moved(p)) for p in tent) + faces)
        report = self.cut(part, '--gcode', nc, '--at', '0,0.1,0', '--fit', planned)
        self.assertLess(report['fit']['residuals']['rms'], 1e-6)
        for got, wanted in zip(report['fit']['motion']['position'], shift):
            self.assertAlmostEqual(got, wanted, delta=1e-5)
        # The unit of a scene is that of both meshes.
        for name, points in (('planned_mm.obj', tent), ('part_mm.obj', map(moved, tent))):
            self.write(name, ''.join('v {} {} {}\n'.format(*(1000 * x for x in p)) for p in points) + faces)
        scene = self.write('scene.json', json.dumps({'bodies': [{'mesh': 'part_mm.obj', 'unit': 'mm'}]}))
        report = self.cut(scene, '--gcode', nc, '--at', '0,0.1,0', '--fit', self.path('planned_mm.obj'))
        for got, wanted in zip(report['fit']['motion']['position'], shift):
            self.assertAlmostEqual(got, wanted, delta=1e-5)
        line = self.write('line.json', json.dumps({'points': [{'planned': [x, 0, 0], 'measured': [x, 0, 0]} for x in range(3)]}))
        self.assertIn('do not lie on one line', self.kerf('cut', sheet, '--gcode', nc, '--fit', line, '--out', self.path('o'), status=2))

    def test_a_nozzle_has_its_standoff_and_collisions_listed_by_segment(self):
        # A block of 10 mm beside a path 2 mm above a sheet: the cone of 45 degrees meets it from 21 mm on.
        corners = [(x, y, z) for y in (0, .01) for x, z in ((.03, -.05), (.04, -.05), (.04, .05), (.03, .05))]
        text = ''.join('v {} {} {}\n'.format(*p) for p in [(-.05, 0, -.05), (.05, 0, -.05), (.05, 0, .05), (-.05, 0, .05)] + corners)
        text += 'f 1 4 3\nf 1 3 2\nf 9 12 11\nf 9 11 10\nf 5 8 12\nf 5 12 9\n'
        mesh = self.write('block.obj', text)
        nc = self.write('a.nc', 'G21 G90\nG0 X0 Y0\nM3 S1\nG1 X10 F1000\nX20\nX25\nM5\n')
        report = self.cut(mesh, '--gcode', nc, '--at', '0,0.002,0', '--nozzle', '0.001,45,0.02')
        self.assertEqual([4, 5, 6], [s['line'] for s in report['nozzle']])
        self.assertEqual([False, False, True], [s['collides'] for s in report['nozzle']])
        for segment in report['nozzle']:
            for standoff in segment['standoff']:
                self.assertAlmostEqual(standoff, .002, delta=1e-9)
        self.assertIn('--nozzle: must be R,ANGLE,LENGTH', self.kerf('cut', mesh, '--nozzle', '1,90,1', '--out', self.path('o'), status=2))

    def test_fit_and_nozzle_are_refused_without_strokes(self):
        points = [[0, 0, 0], [1, 0, 0], [0, 0, 1]]
        fit = self.write('fit.json', json.dumps({'points': [{'planned': p, 'measured': p} for p in points]}))
        empty = self.write('empty.json', json.dumps({'strokes': []}))
        sheet = self.sheet(.05)
        for option in (['--fit', fit], ['--fit', sheet], ['--nozzle', '0.001,45,0.02']):
            for job in (['--plane', '1,0,0,0'], ['--path', empty]):
                said = self.kerf('cut', sheet, *job, *option, '--out', self.path('o'), status=2)
                self.assertIn(option[0] + ': requires strokes', said)
        self.assertFalse(os.path.exists(self.path('o')))
        # A scene has strokes of its own.
        stroke = {'laser': {'radius': RADIUS}, 'keys': [{'t': t, 'origin': [.01 * t, .1, 0], 'direction': [0, -1, 0]} for t in (0, 1)]}
        scene = self.write('scene.json', json.dumps({'bodies': [{'mesh': 'sheet.obj'}], 'strokes': [stroke]}))
        report = self.cut(scene, '--fit', fit, '--nozzle', '0.001,45,0.02')
        self.assertEqual([0], [s['stroke'] for s in report['nozzle']])
        self.assertLess(report['fit']['residuals']['max'], 1e-12)

    def test_a_wrapped_drawing_cuts_windows_of_its_size_in_the_near_wall(self):
        square = 'M35 35h30v30h-30z'  # 30 mm, about the middle
        svg = self.write('a.svg', f'<svg width="100mm" height="100mm" viewBox="0 0 100 100"><path d="{square}"/></svg>')
        for at in ([], ['--at', '0,.025,0']):
            report = self.cut(self.tube(.025, .1), '--drawing', svg, '--onto', '-y', '--wrap', .025, *at)
            drop, = self.areas(report)
            self.assertAlmostEqual(drop, (.03 - 2 * RADIUS)**2, delta=2e-3 * drop)
            # The far wall is whole: only the border of the drop is removed.
            self.assertAlmostEqual(report['removed']['area'], .12 * 2 * RADIUS, delta=.02 * .12 * 2 * RADIUS)
            window = min(report['pieces'], key=lambda piece: abs(piece['area'] - drop))
            # The centroid of an arc of .03 on the radius .025.
            self.assertAlmostEqual(window['centroid'][1], .025 * math.sin(.6) / .6, delta=1e-4)
        for more in (['--scale', 1000], ['--scale', 1e6]):
            said = self.kerf('cut', self.tube(.025, .1), '--drawing', svg, '--wrap', 1e-6, *more, '--out', self.path('o'), status=2)
            self.assertIn('a.svg has too many turns', said)
        self.assertIn('--wrap: requires --drawing', self.kerf('cut', self.sheet(1), '--wrap', 1, '--out', self.path('o'), status=2))

    def compare(self, *arguments):
        done = subprocess.run([KERF, 'compare', *map(str, arguments)], capture_output=True, text=True, check=False)
        self.assertEqual(0, done.returncode, done.stderr)
        return json.loads(done.stdout)

    def test_compare_states_distances_areas_and_volumes(self):
        bricks = []
        for name, move in (('a', 0), ('b', .1)):
            corners = [(x + move, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
            faces = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
            bricks.append(self.write(name + '.obj', ''.join('v {} {} {}\n'.format(*c) for c in corners) +
                                     ''.join('f {} {} {} {}\n'.format(*f) for f in faces)))
        a, b = bricks
        same = self.compare(a, a)
        self.assertEqual({'max': 0, 'mean': 0, 'rms': 0, 'p95': 0}, same['distance'])
        report = self.compare(a, b)
        self.assertEqual(([6, 6], [1, 1]), (report['area'], report['volume']))
        self.assertEqual((.1, [a, b], 'm'), (round(report['distance']['max'], 12), report['inputs'], report['units']['length']))
        # The left side is .1 outside; the right side is .1 inside, as are parts of the others at their left ends.
        self.assertAlmostEqual(report['signed']['min'], -.1)
        self.assertAlmostEqual(report['signed']['max'], .1)
        self.assertEqual(100000, sum(report['signed']['histogram']))
        self.assertGreater(report['signed']['histogram'][-1], 100000 / 6 - 100)
        for align in ('centre', 'icp'):
            aligned = self.compare(a, b, '--align', align)
            self.assertLess(aligned['distance']['max'], 1e-12)
            self.assertAlmostEqual(aligned['motion']['position'][0], .1)
        sheet = self.sheet(1)
        report = self.compare(a, sheet)
        self.assertEqual((None, False), (report['volume'][1], 'signed' in report))
        self.assertIn('the values are: none, centre, icp', self.kerf('compare', a, b, '--align', 'both', status=2))
        self.assertIn('none.obj', self.kerf('compare', a, 'none.obj', status=2))


unittest.main()
