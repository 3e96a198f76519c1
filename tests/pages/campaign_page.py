#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""docs/accuracy.md out of the campaign's record, docs/accuracy.csv, and those of heights and of the
extreme scenes.

Arguments: the source root; --check to compare and write nothing."""
import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import pages  # noqa: E402
import pictures_page  # noqa: E402
from pages import block, table  # noqa: E402

LABELS = ["shape", "regime"]
TIERS = ["float32", "textbook", "stable", "certain", "exact"]
PROMISING = ["certain", "exact"]
STAGES = ["double", "double_double", "mod128", "exact"]
WRONG = ["false_hits", "false_misses", "wrong_parts", "wrong_validity"]
ULPS = ["ulps_0", "ulps_1", "ulps_4", "ulps_64", "ulps_65536", "ulps_more"]


def percent(part, whole):
    if part == 0 or part == whole:
        return "0" if part == 0 else "100"
    hundredths = round(10000 * part / whole)
    if hundredths in (0, 10000):
        return ">99.99" if hundredths else "<0.01"
    return f"{hundredths / 100:.2f}"


def grouped(number):
    return f"{number:,}"


def wrong(row, tier):
    return sum(row[f"{tier}_{kind}"] for kind in WRONG)


def total(rows):
    return {name: sum(row[name] for row in rows) for name in rows[0] if name not in LABELS}


def overview(everything):
    rows = []
    for tier in TIERS:
        right = sum(everything[f"{tier}_{within}"] for within in ULPS)
        rows.append([f"`{tier}`", percent(wrong(everything, tier), everything["cases"]),
                     *(percent(everything[f"{tier}_{kind}"], everything["cases"])
                       for kind in WRONG[:3]),
                     *(percent(everything[f"{tier}_{within}"], right) for within in ULPS)])
    return table(["tier", "wrong %", "hit where none is", "miss of a hit", "wrong part",
                  "t %: 0 ulps", "1", "≤ 4", "≤ 64", "≤ 2¹⁶", "more"], rows)


def near(row, tier):
    right = sum(row[f"{tier}_{within}"] for within in ULPS)
    return percent(sum(row[f"{tier}_{within}"] for within in ULPS[:3]), right)


def decisions(named):
    rows = [[name, grouped(row["cases"]),
             *(percent(wrong(row, tier), row["cases"]) for tier in TIERS),
             *(near(row, tier) for tier in TIERS[:4])] for name, row in named]
    return table(["regime", "cases", "wrong %: float32", *TIERS[1:],
                  "t ≤ 4 ulps %: float32", *TIERS[1:4]], rows)


def stages(named, label="regime"):
    rows = [[name, *(percent(row[f"{tier}_{stage}"], row["cases"])
                     for tier in PROMISING for stage in STAGES)] for name, row in named]
    heads = [stage.replace("_", "-") for stage in STAGES]
    return table([label] + [f"{tier} %: {heads[0]}" if head == heads[0] else head
                            for tier in PROMISING for head in heads], rows)


def values(seed, rows):
    """What fills the page."""
    shapes = list(dict.fromkeys(row["shape"] for row in rows))
    everything = total(rows)

    def named(shape):
        own = [row for row in rows if row["shape"] == shape]
        return [(f"`{row['regime']}`", row) for row in own] + [("all", total(own))]

    counts = {"cases": "cases", "broken": "broken", "normals": "normals",
              "intervals": "intervals", "spawns": "spawns", "hits": "out_of_cap",
              "asked": "spawns", "outside": "no_outside", "inside": "no_inside"}
    all_shapes = [(shape, named(shape)[-1][1]) for shape in shapes] + [("all", everything)]
    return {"seed": seed, **{place: grouped(everything[name]) for place, name in counts.items()},
            "tiers": block(overview(everything)),
            "shapes": block(*(f"## {shape.capitalize()}\n\n{decisions(named(shape))}"
                              for shape in shapes)),
            "stages": block(stages(all_shapes, "shape"), *(
                f"### {shape.capitalize()}\n\n{stages(named(shape))}" for shape in shapes)),
            "origins": block(spawns(rows))}


def spawns(rows):
    head = ["shape", "regime", "hits", "none outside %", "none inside %"]
    return table(head, [[row["shape"], f"`{row['regime']}`", grouped(row["spawns"]),
                         percent(row["no_outside"], row["spawns"]),
                         percent(row["no_inside"], row["spawns"])]
                        for row in rows if row["no_outside"] or row["no_inside"]])


def heights(path):
    names = {"0": "the nearest doubles", "1": "anywhere"}
    with open(path, newline="") as file:
        rows = [[row["shape"],
                 names.get(row["distance"], f"within {row['distance']} of the height"),
                 grouped(int(row["cases"])),
                 *(percent(int(row[tier]), int(row["cases"])) for tier in TIERS if tier in row)]
                for row in csv.DictReader(file)]
    return table(["solid", "from the rim", "points", "wrong %: float32", "textbook", "certain",
                  "exact"], rows, range(2, 7))


def read_record(path):
    with open(path, newline="") as file:
        seed = file.readline().strip().removeprefix("seed,")
        return seed, [{name: cell if name in LABELS else int(cell)
                       for name, cell in row.items()} for row in csv.DictReader(file)]


def main():
    docs = pathlib.Path(sys.argv[1]) / "docs"
    filled = {**values(*read_record(docs / "accuracy.csv")), **pictures_page.values(docs),
              "heights": block(heights(docs / "heights.csv"))}
    return pages.written_or_checked(docs / "accuracy.md", filled, "docs/accuracy.csv",
                                    sys.argv[2:] == ["--check"])


sys.exit(main())
