#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""docs/worst_cases.md out of tests/vectors/worst_cases*.json, whose bits are counted anew.

    worst_page.py ROOT CAMPAIGN [--check]"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import pages  # noqa: E402

RECORDS = ["worst_cases.json", "worst_cases_earlier.json"]
TOLD = 3
ASKED = {"decision": "is it met?", "cap": "is a cap crossed?", "rounding": "t"}


def tables(rows):
    """The worst of each question, of whatever record."""
    groups = {}
    for row in rows:
        groups.setdefault((row["shape"], row["question"]), []).append(row)
    for (shape, question), group in groups.items():
        told = sorted(group, key=lambda row: -int(row["bits"]))[:TOLD]
        yield (f"## {shape.capitalize()}: {ASKED[question]}\n\n"
               f"At most {int(told[0]['bound']):,} bits.\n\n"
               + pages.table(["bits", "regime", "seed", "number", "case"],
                             [[row["bits"], f"`{row['regime']}`", row["seed"], row["index"],
                               f"`{row['case']}`"] for row in told], [0, 2, 3]))


def read(record, campaign):
    """How many cases, and the worst with their bits."""
    lines = [json.loads(line) for line in record.read_text().splitlines()]
    seed = str(int(lines[0]["seed"], 16))
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "worst.csv")
        subprocess.run([campaign, "worst", record, "-o", path], check=True)
        rows = [{**row, "seed": seed} for row in csv.DictReader(path.read_text().splitlines())]
    return sum(line["counts"]["cases"] for line in lines if "counts" in line), rows


def main():
    root, campaign = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    found = [read(root / "tests/vectors" / name, campaign) for name in RECORDS]
    values = {"cases": f"{sum(cases for cases, _ in found):,}",
              "worst": pages.block(*tables([row for _, rows in found for row in rows]))}
    return pages.written_or_checked(root / "docs/worst_cases.md", values, RECORDS[0],
                                    "--check" in sys.argv)


if __name__ == "__main__":
    sys.exit(main())
