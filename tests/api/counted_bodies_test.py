"""The cost of adding, undoing and redoing bodies is linear: counted_bodies_test.py API_TESTS

valgrind counts the instructions for 500 and for 1,000 bodies, beyond those for one.
"""
import os
import subprocess
import sys
import tempfile

LARGEST_GROWTH = 2.7


def instructions(bodies):
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            ['valgrind', '--tool=callgrind', f'--callgrind-out-file={folder}/out', sys.argv[1],
             '--gtest_filter=Bodies.many_are_added_and_undone'], capture_output=True, text=True, check=False,
            env={**os.environ, 'KERF_TEST_BODIES': str(bodies)})
    assert done.returncode == 0, done.stdout + done.stderr
    return int(done.stderr.rsplit('Collected :', 1)[1].split()[0])


one, half, whole = map(instructions, (1, 500, 1000))
growth = (whole - one) / (half - one)
print(f'{half - one} instructions for 500 bodies, {growth:.2f} times as many for 1,000')
assert growth < LARGEST_GROWTH, growth
