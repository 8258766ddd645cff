"""Prints which tests took longest, from the report that ctest writes with --output-junit."""

import sys
import xml.etree.ElementTree as xml

ROWS = 25


def main():
    tests = [(float(case.get("time")), case.get("name")) for case in xml.parse(sys.argv[1]).iter("testcase")]
    if not tests:
        return
    longest = sorted(tests, reverse=True)[:ROWS]
    print(f"\nThe slowest of {len(tests)} tests, which took {sum(seconds for seconds, _ in tests):.0f} s one after the other:")
    for seconds, name in longest:
        print(f"{seconds:8.1f} s  {name}")


if __name__ == "__main__":
    main()
