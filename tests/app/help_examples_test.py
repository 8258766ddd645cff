#!/usr/bin/env python3
"""Every subcommand's help ends with an example that works: help_examples_test.py KERF

The scripts that build and test Kerf do what their comments and their help state, here with stubs for the build.
"""
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

KERF = os.path.abspath(sys.argv.pop())
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ASSETS = os.path.join(ROOT, 'assets')
# Each appends its arguments to $LOG, a line a call.
STUBS = {
    'cmake': 'mkdir -p "$5"; echo "CMAKE_BUILD_TYPE:STRING=Release" >"$5/CMakeCache.txt"; : >"$5/build.ninja"',
    'ninja': 'printf "#!/bin/sh\\n" >"$2/kerf"; chmod +x "$2/kerf"',
    'ctest': f'[ "$1" != --help ] || exec {shlex.quote(shutil.which("ctest") or "false")} --help\n'
             'touch "$TEST_TMPDIR/kerf-left"; echo "$TEST_TMPDIR" >>"$LOG"\n'
             'while [ $# -gt 0 ]; do [ "$1" != --output-junit ] || report=$2; shift; done\n'
             '[ -z "$REPORT" ] || printf %s "$REPORT" >"$report"',
    'dpkg-query': 'printf "installed %s\\n" "$@"',
    'sysctl': 'exit 1',
    'setarch': 'shift; exec "$@"',
}


def help_of(*command):
    return subprocess.run([KERF, *command, '--help'], capture_output=True, text=True, check=True).stdout


class Examples(unittest.TestCase):
    def test_every_subcommand_has_a_working_example(self):
        names = re.findall(r'^  ([a-z]+) ', help_of().split('Subcommands:')[1], re.MULTILINE)
        self.assertGreater(len(names), 8)
        for name in names:
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                example = help_of(name).rstrip().rsplit('Example:\n', 1)[1]
                self.assertEqual(1, len(example.splitlines()), example)
                words = shlex.split(example)
                self.assertEqual(['kerf', name], words[:2])
                os.symlink(ASSETS, os.path.join(folder, 'assets'))
                done = subprocess.run([KERF, *words[1:]], cwd=folder, capture_output=True, text=True, check=False)
                self.assertEqual(0, done.returncode, done.stderr)


class Scripts(unittest.TestCase):
    """app/run and tests/run in a small checkout, whose path has blanks, brackets and a letter that is not ASCII."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root, stubs = os.path.join(folder.name, 'my kerf (1)', 'ä'), os.path.join(folder.name, 'stubs')
        self.log_file = os.path.join(folder.name, 'log')
        for name in ('app/run', 'app/prepare.sh', 'tests/run', 'tests/slowest.py', 'tests/mutants/mutants.py'):
            os.makedirs(os.path.dirname(os.path.join(self.root, name)), exist_ok=True)
            shutil.copy(os.path.join(ROOT, name), os.path.join(self.root, name))
        os.mkdir(stubs)
        for name, text in STUBS.items():
            with open(os.path.join(stubs, name), 'w', encoding='utf-8') as stub:
                stub.write(f'#!/bin/sh\n[ "$1" = --help ] || echo "{name} $*" >>"$LOG"\n{text}\n')
            os.chmod(stub.name, 0o755)
        self.environment = {name: value for name, value in os.environ.items() if not name.startswith(('KERF_', 'GIT_')) and name != 'CI'}
        self.environment.update(PATH=stubs + ':' + os.environ['PATH'], LOG=self.log_file, REPORT='',
                                GIT_CONFIG_GLOBAL=os.devnull)

    def script(self, name, *words, **variables):
        return subprocess.run(['bash', os.path.join(self.root, name), *words], env={**self.environment, **variables},
                              capture_output=True, text=True, check=False)

    def log(self):
        """The calls of stubs, and temporary folders of tests, since the last call of this function."""
        if not os.path.exists(self.log_file):
            return []
        with open(self.log_file, encoding='utf-8') as log:
            lines = log.read().splitlines()
        os.remove(self.log_file)
        return lines

    def configures(self, name, *words):
        done = self.script(name, *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return sum(line.startswith('cmake ') for line in self.log())

    def test_a_build_is_configured_once_and_after_a_change_by_hand(self):
        self.assertEqual([self.configures('app/run', '--version') for _ in range(2)], [1, 0])
        with open(os.path.join(self.root, 'build/CMakeCache.txt'), 'a', encoding='utf-8') as cache:
            cache.write('KERF_CORE_ONLY:BOOL=ON\n')
        self.assertEqual([self.configures('app/run', '--version') for _ in range(2)], [1, 0])

    def test_arguments_that_ctest_ignores_are_refused(self):
        for words in (('--sanitize', '--long'), ('-R', 'keys', '--long'), ('--sanitise',), ('--threads', '--tests=a'), ('keys',)):
            with self.subTest(words):
                done = self.script('tests/run', *words)
                self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1), done.stderr)
                self.assertEqual(self.log(), [])
        for words in (('-R', 'keys', '-j2', '-V'), ('--repeat', 'until-fail:3', '--timeout', '5', '--show-only=json-v1'), ()):
            self.assertEqual(self.script('tests/run', *words).returncode, 0, words)

    def test_a_proof_counts_the_tests_that_ran_and_names_the_commit(self):
        case = '<testcase name="{0}" classname="{0}" time="0.1" status="{0}"/>\n'
        others = case.format('disabled') + case.format('notrun')
        for report, proof in ((others + 2 * case.format('run'), 'proof: tests/run -R x | 2 tests | '), (others, ''), ('', '')):
            done = self.script('tests/run', '-R', 'x', REPORT=report and f'<testsuite>\n{report}</testsuite>\n')
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual((proof and proof in done.stdout, 'proof' in done.stdout), (proof and True, bool(proof)), done.stdout)
            self.assertEqual('no test was run' in done.stderr, not proof)
        if shutil.which('git'):
            for words in (('init', '-q'), ('add', 'app', 'tests'), ('commit', '-q', '-m', 'a'), ('tag', '-a', 'v1', '-m', 'a')):
                subprocess.run(['git', '-C', self.root, '-c', 'user.name=a', '-c', 'user.email=a@b.c', *words], check=True,
                               env=self.environment, capture_output=True)
            done = self.script('tests/run', REPORT=f'<testsuite>\n{case.format("run")}</testsuite>\n')
            self.assertRegex(done.stdout, r'(?m)^proof: tests/run \| 1 tests \| [0-9-]{10} \| [0-9a-f]{10,}$')

    def test_files_that_tests_leave_behind_are_removed(self):
        self.assertEqual(self.script('tests/run').returncode, 0)
        folder = self.log()[-1]
        self.assertRegex(os.path.basename(folder), '^kerf-tests-')
        self.assertFalse(os.path.exists(folder))

    def test_threads_disables_randomisation_for_users_who_cannot_read_its_width(self):
        done = self.script('tests/run', '--threads', '-E', 'physics', '-V')
        self.assertEqual(done.returncode, 0, done.stderr)
        calls = self.log()
        self.assertIn(f'setarch -R {self.root}/tests/run --threads -E physics -V', calls)
        tests = [call for call in calls if call.startswith('ctest ')]
        self.assertEqual(len(tests), 1, calls)
        self.assertRegex(tests[0], r' -E window_\|\^\(batch\|.*\)\$\|physics -V$')

    def test_mutants_overwrite_no_folder_with_other_files(self):
        thesis = os.path.join(self.root, 'thesis', 'thesis.tex')
        os.mkdir(os.path.dirname(thesis))
        with open(thesis, 'w', encoding='utf-8') as file:
            file.write('years of work')
        done = subprocess.run([sys.executable, '-B', os.path.join(self.root, 'tests/mutants/mutants.py'), '--copy',
                               os.path.dirname(thesis)], env=self.environment, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn('name a new folder', done.stderr)
        self.assertTrue(os.path.exists(thesis))


unittest.main()
