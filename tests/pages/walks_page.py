#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""docs/walks.md: who gets lost, and where, out of the record docs/walks.json.

    walks_page.py ROOT --measure --surehit PROGRAM [--libraries "PATH ..."]
                             walks, makes the record, and fills the page: minutes
    walks_page.py ROOT --check   is the page the record's?
    walks_page.py ROOT           fills the page"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import pages  # noqa: E402
from pages import block, table  # noqa: E402

SEED = 1
# Steps of a row: of `certain`, of others, and of those that CGAL judges.
MANY, USUAL, FEW = 3_800_000, 100_000, 10_000
TIERS = [("certain", None, MANY), ("exact", None, USUAL), ("certain", 1e-6, USUAL),
         ("certain", 1e-9, USUAL), ("textbook", 1e-6, USUAL), ("textbook", 1e-9, USUAL)]
BY_REFERENCE = ["--truth", "reference"]
OF_LIBRARIES = [1e-6, 1e-8]


def walked(surehit, name, words, nudge, steps):
    """What is recorded of a run."""
    if nudge is not None:
        words = [*words, "--nudge", repr(nudge)]
    with tempfile.TemporaryDirectory(prefix="walks.") as folder:
        path = os.path.join(folder, "out.json")
        subprocess.run([surehit, "walk", *words, "--steps", str(steps), "--seed", str(SEED),
                        "--json", path], check=True, stdout=subprocess.DEVNULL)
        with open(path, encoding="ascii") as file:
            return recorded(name, json.load(file))


def recorded(name, found):
    return {"routine": name, "nudge": found["nudge"], "truth": found["truth"], "seed": SEED,
            "rows": [line_of(row) for row in found["rows"]]}


def line_of(row):
    """A row of the record."""
    counts = [row["steps"], row["stopped"], *row["faults"].values()]
    return " ".join([row["shape"], row["kind"], *map(str, counts)])


def rows_of(run):
    for line in run["rows"]:
        shape, kind, steps, _, *faults = line.split()
        yield {"shape": shape, "kind": kind, "steps": int(steps), "faults": sum(map(int, faults))}


def measure(options):
    runs = [walked(options.surehit, tier, ["--tier", tier], nudge, steps)
            for tier, nudge, steps in TIERS]
    runs[1:1] = [walked(options.surehit, "certain", ["--tier", "certain", *BY_REFERENCE], None,
                        FEW)]
    for path in options.libraries.split():
        name = re.fullmatch(r"lib(?:peer-|walks-)?([\w-]+)\.\w+", os.path.basename(path))[1]
        runs += [walked(options.surehit, name, ["--candidate", os.path.abspath(path)], nudge,
                        USUAL) for nudge in OF_LIBRARIES]
    return {"runs": runs}


def per_million(rows):
    """Faults of so many steps; 0 is none at all."""
    rows = list(rows)
    if not rows:
        return "–"
    faults = sum(row["faults"] for row in rows)
    share = 1e6 * faults / sum(row["steps"] for row in rows)
    return "0" if faults == 0 else f"{share:,.0f}" if share >= 1 else f"{share:.2g}"


def name_of(run):
    again = "`sure_spawn`"
    if run["nudge"] is not None:
        again = f"nudged by {run['nudge']:g}".replace("e-0", "e-")
    by = ", judged by CGAL" if run["truth"] == "reference" else ""
    return f"`{run['routine']}`, {again}{by}"


def figures(record, column, of=lambda row: True):
    """A row a run, a column each of what the record's rows have there."""
    runs = [(run, [row for row in rows_of(run) if of(row)]) for run in record["runs"]]
    names = list(dict.fromkeys(row[column] for row in runs[0][1]))
    cells = [[name_of(run), f"{sum(row['steps'] for row in rows):,}",
              *(per_million(row for row in rows if row[column] == name) for name in names)]
             for run, rows in runs]
    return table(["routine", "steps", *names], cells)


def outputs(root, record):
    page = root / "docs/walks.md"
    values = {"kinds": block(figures(record, "kind")),
              "shapes": block(figures(record, "shape", lambda row: row["kind"] == "alone")),
              "seed": record["runs"][0]["seed"]}
    return {page: pages.filled(page.read_text(encoding="utf-8"), values)}


if __name__ == "__main__":
    sys.exit(pages.run(__doc__, "docs/walks.json", outputs, measure,
                       [("surehit", ""), ("libraries", "", "as candidates")]))
