#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The README's table is what `surehit judge` says of each tier. Arguments: surehit, source root;
--update renews it.

The shares of wrong answers are the same on every machine and must agree; the times are only renewed
by --update."""
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

surehit, root = sys.argv[1:3]
readme = pathlib.Path(root) / "README.md"
text = readme.read_text()
START, END = "<!-- table: tests/house/test_readme.py --update -->\n", "<!-- end of table -->"
head, rest = text.split(START)
old, tail = rest.split(END)
TIERS = ["float32", "textbook", "stable", "certain", "exact"]
PROMISING = ["certain", "exact"]  # what is said of them must not come from them
COUNT = 200
USUAL = ["camera", "typical"]  # all other regimes are hard


def judged(tier):
    """{shape: its rows in the hard regimes}"""
    truth = "reference" if tier in PROMISING else "exact"
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "verdict.json")
        subprocess.run([surehit, "judge", "--tier", tier, "--truth", truth, "--count", str(COUNT),
                        "--json", path], stdout=subprocess.DEVNULL, check=True)
        with open(path, encoding="utf-8") as file:
            rows = json.load(file)["rows"]
    shapes = list(dict.fromkeys(row["shape"] for row in rows))
    return {shape: [row for row in rows if row["shape"] == shape and row["regime"] not in USUAL]
            for shape in shapes}


def percent(share):
    """0 is none at all."""
    return "0" if share == 0 else "<0.1" if share < 0.001 else f"{100 * share:.1f}"


def cells(rows):
    """Each regime counts the same; a tier in float is spared those that no float holds."""
    wrong = statistics.mean(row["wrong"] / row["valid"] for row in rows if row["valid"] > 0)
    times = [row["nanoseconds"]["candidate"] for row in rows]
    return percent(wrong), f"{statistics.median(time for time in times if time):.0f}"


def table(tiers):
    yield "| |" + "".join(f" {tier} wrong % | ns |" for tier in tiers)
    yield "|---|" + "---:|---:|" * len(tiers)
    shapes = list(tiers["exact"])
    for name in [*shapes, "all"]:
        rows = [cells([row for shape in (shapes if name == "all" else [name])
                       for row in by_shape[shape]]) for by_shape in tiers.values()]
        yield f"| {name} |" + "".join(f" {wrong} | {ns} |" for wrong, ns in rows)


def wrong_shares(lines):
    """Each row without its times."""
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in lines if "|" in line]
    return [row[:1] + row[1::2] for row in rows]


new = list(table({tier: judged(tier) for tier in TIERS}))
if "--update" in sys.argv:
    readme.write_text(head + START + "\n".join(new) + "\n" + END + tail)
elif wrong_shares(old.splitlines()) != wrong_shares(new):
    print("README.md is stale; renew it with tests/house/test_readme.py SUREHIT ROOT --update:")
    print("\n".join(new))
    print("0 passed, 1 failed")
    sys.exit(1)
print("1 passed, 0 failed")
