#!/usr/bin/env python3
"""Every subcommand's help ends with an example that works: help_examples_test.py KERF"""
import os
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

KERF = os.path.abspath(sys.argv.pop())
ASSETS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), 'assets')


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


unittest.main()
