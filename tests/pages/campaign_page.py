#!/usr/bin/env python3
"""docs/accuracy.md out of the campaign's record, docs/accuracy.csv, and that of the extreme scenes.

Arguments: the source root; --check to compare and write nothing."""
import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import pages  # noqa: E402
import pictures_page  # noqa: E402
from pages import table  # noqa: E402

LABELS = ["shape", "regime"]
TIERS = ["float32", "textbook", "stable", "certain", "exact"]
PROMISING = ["certain", "exact"]
STAGES = ["double", "double_double", "mod128", "exact"]
WRONG = ["false_hits", "false_misses", "wrong_parts", "wrong_validity"]
ULPS = ["ulps_0", "ulps_1", "ulps_4", "ulps_64", "ulps_65536", "ulps_more"]

HEAD = """# Accuracy, measured

Made by `meson compile -C build accuracy` out of [accuracy.csv](accuracy.csv), the record of
`meson compile -C build campaign`; a test compares the two. Not to be edited.

The campaign ({cases} cases, seed {seed}) asks every tier the cases of every [regime](regimes.md)
of every shape and holds the answers against the [exact reference](reference.md). Of `certain` and
`exact` it checks what [the contract](contract.md) promises: in each case the status, the part, the
field that is invalid and that nothing is written on a miss, t in [t_min, t_max], |t − t\\*| ≤
`t_error` and its cap, or every bit of t; on {normals} hits the normal, to its bound or to
every bit; on {intervals} lines both ends of the chord; `occluded` on as many others; on
{spawns} hits the side of `sure_spawn`.
**Broken promises: {broken}.**

The regimes go to where intersection code fails. Their shares are no forecast for a picture, whose
rays are `typical` ones, nearly all. A sum over regimes weighs them by their cases: equally, but for
the cone's `bits` and `degenerate`, which count a sixth. 0 is none at all, 100 is all, and `<0.01`
and `>99.99` are not.

"""

SPAWN_TEXT = """
## Where a ray can leave

`sure_spawn` on {spawns} hits, its side checked by the reference: it has no origin on the outside of
{no_outside} and on the inside of {no_inside}. Of the regimes where that happens:

"""

OVERVIEW_TEXT = """## All regimes of all shapes

Wrong: per cent of the cases. t: per cent of the hits that are right, by how far t is from the
correctly rounded one, in ulps of the tier's precision.

"""

CAP_TEXT = """
On {hits} hits half an ulp of t is already above the cap on `t_error`: t is subnormal or infinite,
or far along a ray that grazes a plane. There `certain` answered the correctly rounded t.
"""

STAGE_TEXT = """
## Which stage answers

Per cent of the cases that each stage of `certain` and of `exact` answers: `double` with a proven
bound, `double-double`, `mod128` (the same with the number's integer modulo 2¹²⁸), `exact` numbers.
Of `exact` the first stage can only tell a miss; the second has t rounded for certain.

"""


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


def page(seed, rows):
    shapes = list(dict.fromkeys(row["shape"] for row in rows))
    everything = total(rows)

    def named(shape):
        own = [row for row in rows if row["shape"] == shape]
        return [(f"`{row['regime']}`", row) for row in own] + [("all", total(own))]

    text = HEAD.format(cases=grouped(everything["cases"]), seed=seed, broken=everything["broken"],
                       normals=grouped(everything["normals"]),
                       intervals=grouped(everything["intervals"]),
                       spawns=grouped(everything["spawns"]))
    text += OVERVIEW_TEXT + overview(everything)
    text += CAP_TEXT.format(hits=grouped(everything["out_of_cap"]))
    for shape in shapes:
        text += f"\n## {shape.capitalize()}\n\n" + decisions(named(shape))
    text += STAGE_TEXT
    text += stages([(shape, named(shape)[-1][1]) for shape in shapes] + [("all", everything)],
                   "shape")
    for shape in shapes:
        text += f"\n### {shape.capitalize()}\n\n" + stages(named(shape))
    counts = ("spawns", "no_outside", "no_inside")
    text += SPAWN_TEXT.format(**{name: grouped(everything[name]) for name in counts})
    return text + spawns(rows)


def spawns(rows):
    head = ["shape", "regime", "hits", "none outside %", "none inside %"]
    return table(head, [[row["shape"], f"`{row['regime']}`", grouped(row["spawns"]),
                         percent(row["no_outside"], row["spawns"]),
                         percent(row["no_inside"], row["spawns"])]
                        for row in rows if row["no_outside"] or row["no_inside"]])


def read_record(path):
    with open(path, newline="") as file:
        seed = file.readline().strip().removeprefix("seed,")
        return seed, [{name: cell if name in LABELS else int(cell)
                       for name, cell in row.items()} for row in csv.DictReader(file)]


def main():
    docs = pathlib.Path(sys.argv[1]) / "docs"
    made = page(*read_record(docs / "accuracy.csv")) + pictures_page.section(docs)
    return pages.written_or_checked(docs / "accuracy.md", made, "docs/accuracy.csv",
                                    sys.argv[2:] == ["--check"])


sys.exit(main())
