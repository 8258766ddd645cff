"""The same cuts come to the same hashes in every build: `one_hash_test.py MESHES RELEASE DEBUG`.

RELEASE and DEBUG are made_cuts as two compilers have built it. RELEASE runs with and without AVX2, DEBUG without.
"""
import os
import subprocess
import sys

MESHES = ("bracket.obj", "knot.obj", "plate.obj")


def cuts(program, meshes, avx2):
    environment = dict(os.environ)
    if not avx2:
        environment["GLIBC_TUNABLES"] = "glibc.cpu.hwcaps=-AVX2_Usable,-AVX2"  # for the C library
        environment["KERF_SIMD"] = "sse4"  # programs of clang ask the processor
    files = [os.path.join(meshes, name) for name in MESHES]
    return subprocess.run([program, *files], env=environment, check=True, capture_output=True, text=True).stdout


def main(meshes, release, debug):
    expected = cuts(release, meshes, True)
    lines = expected.splitlines()
    if len(lines) < 5 * len(MESHES) or len(set(lines)) != len(lines):
        sys.exit("the cuts are not all there, or not all different:\n" + expected)
    for program in (release, debug):
        found = cuts(program, meshes, False)
        for a, b in zip(lines, found.splitlines(), strict=True):
            if a != b:
                sys.exit(f"{program} without AVX2:\n  {b}\nand not\n  {a}")
    print(expected, end="")


if __name__ == "__main__":
    main(*sys.argv[1:])
