#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""docs/worst_cases.md out of tests/vectors/worst_cases.json, whose bits are counted anew.

    worst_page.py ROOT CAMPAIGN [--check]"""
import csv
import itertools
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import pages  # noqa: E402

TOLD = 3
ASKED = {"decision": "is it met?", "cap": "is a cap crossed?", "rounding": "t"}


def tables(rows):
    for (shape, question), group in itertools.groupby(
            rows, lambda row: (row["shape"], row["question"])):
        told = list(itertools.islice(group, TOLD))
        yield (f"## {shape.capitalize()}: {ASKED[question]}\n\n"
               f"At most {int(told[0]['bound']):,} bits.\n\n"
               + pages.table(["bits", "regime", "number", "case"],
                             [[row["bits"], f"`{row['regime']}`", row["index"], f"`{row['case']}`"]
                              for row in told], [0, 2]))


def main():
    root, campaign = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    record = root / "tests/vectors/worst_cases.json"
    lines = [json.loads(line) for line in record.read_text().splitlines()]
    cases = sum(line["counts"]["cases"] for line in lines if "counts" in line)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "worst.csv")
        subprocess.run([campaign, "worst", record, "-o", path], check=True)
        rows = list(csv.DictReader(path.read_text().splitlines()))
    values = {"cases": f"{cases:,}", "seed": str(int(lines[0]["seed"], 16)),
              "worst": pages.block(*tables(rows))}
    return pages.written_or_checked(root / "docs/worst_cases.md", values, record.name,
                                    "--check" in sys.argv)


if __name__ == "__main__":
    sys.exit(main())
