#!/usr/bin/env python3
"""Brings the table of proofs in tests/README.md up to date from the logs of runs: `proofs.py LOG...`.

A run that passed prints `proof: COMMAND | CASES | DATE | COMMIT`. The row whose second column is COMMAND gets the other
values; of several lines, the last one counts. Without a log, fails if a row has no values.
"""
import os
import re
import sys

PAGE = os.path.join(os.path.dirname(os.path.realpath(__file__)), "README.md")
LINE = re.compile(r"^proof: (.+) \| (.+) \| (\d{4}-\d\d-\d\d) \| ([0-9a-f]{7,})$", re.M)
ROW = re.compile(r"^\| ([^|]+) \| `([^`]+)` \| ([^|]*) \| ([^|]*) \| ([^|]*) \|$", re.M)


def main(logs):
    with open(PAGE, encoding="utf-8") as file:
        page = file.read()
    if not logs:
        empty = [row[1] for row in ROW.findall(page) if not all(value.strip() for value in row[2:])]
        sys.exit(f"without a proof: {', '.join(empty)}" if empty or not ROW.search(page) else 0)
    found = {}
    for log in logs:
        with open(log, encoding="utf-8", errors="replace") as file:
            found |= {command: values for command, *values in LINE.findall(file.read())}

    def with_values(row):
        values = found.get(row[2], row.groups()[2:])
        return f"| {row[1]} | `{row[2]}` | {' | '.join(values)} |"

    with open(PAGE, "w", encoding="utf-8") as file:
        file.write(ROW.sub(with_values, page))


if __name__ == "__main__":
    main(sys.argv[1:])
