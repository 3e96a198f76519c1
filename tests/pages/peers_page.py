#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""docs/peers.md: tiers and peers, judged side by side, out of their record, docs/peers.csv.

    peers_page.py ROOT --measure SUREHIT LIBRARY...   makes the record anew, and fills the page
    peers_page.py ROOT --check SUREHIT LIBRARY...     is the page the record's, and the record true?
    peers_page.py ROOT                                fills the page

The page's own table says who they are, in order."""
import csv
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import pages  # noqa: E402
from pages import SPDX, block, table  # noqa: E402
from shapes import SHAPES  # noqa: E402

PROMISING = ["certain", "exact"]  # a row about them must not come from them
TIERS = ["float32", "textbook", "stable", "certain", "exact"]

# A row of the page about a tier, or about a peer: whom it stands for, and the source of its
# formula. Both are quotations of the head of its adapter (reference/peers/*.c).
WHO = re.compile(r"""(?mx) ^\|\ (?: `(?P<tier>\w+)` |
                                  \[(?P<peer>\w+)\]\(\.\./(?P<file>reference/peers/\w+\.c)\) )
                     \ \|\ (?P<inputs>\w+) \ \|\ (?P<shapes>[^|]+)
                     \ \|\ (?P<stands>[^|]+) \ \|\ (?P<by>[^|]+) \ \|$""")

# How many cases of a regime. The reference is slow; accuracy.md has both tiers' hundred million.
USUAL = ["typical", "grazing"]
COUNT, COUNT_OF_USUAL, COUNT_OF_USUAL_BY_REFERENCE = 2000, 100000, 20000
TIMES = 5  # the median of so many runs is a candidate's time in `typical`

DECISIONS = ["false hit", "false miss", "wrong part", "valid refused"]
LABELS = ["candidate", "shape", "regime", "inputs", "truth"]
COUNTS = ["cases", "valid", "hits", "skipped", "unasked", "wrong",
          *(name.replace(" ", "_") for name in DECISIONS), "breaches", "t_hits", "t_right"]
SIZES = ["t_50", "t_99", "t_most"]
NANOSECONDS = ["ns", "ns_textbook", "ns_certain"]
COLUMNS = LABELS + COUNTS + SIZES + NANOSECONDS


def who(root):
    """{name: its row of the page}"""
    rows = WHO.finditer((root / "docs/peers.md").read_text(encoding="utf-8"))
    return {row["tier"] or row["peer"]: row for row in rows}


# Measuring.

def run(surehit, *words):
    """What it writes as JSON."""
    with tempfile.TemporaryDirectory(prefix="peers.") as folder:
        path = os.path.join(folder, "out.json")
        subprocess.run([surehit, *words, "--json", path], check=True, stdout=subprocess.DEVNULL)
        with open(path, encoding="ascii") as file:
            return json.load(file)


def regimes_of(surehit):
    listed = subprocess.run([surehit, "judge", "--help"], check=True, capture_output=True,
                            text=True).stdout.split("Regimes:")[1].split("\n\n")[0]
    return [regime for regime in listed.split() if regime not in USUAL]


def chosen(option, words):
    return [word for value in words for word in (option, value)]


def judged(surehit, subject, count, regimes, truth="exact", shapes=()):
    return run(surehit, "judge", *subject, "--count", str(count), "--truth", truth,
               *chosen("--regime", regimes), *chosen("--shape", shapes))["rows"]


def row_of(name, inputs, truth, found):
    faults, t, time = found["faults"], found["t_ulps"], found["nanoseconds"]
    breaches = sum(count for fault, count in faults.items() if fault not in DECISIONS)
    return {"candidate": name, "inputs": inputs, "truth": truth,
            **{key: found[key] for key in COLUMNS if key in found},
            **{fault.replace(" ", "_"): faults[fault] for fault in DECISIONS},
            "breaches": breaches, "t_hits": t["hits"], "t_right": t["correctly_rounded"],
            "t_50": size(t["median"]), "t_99": size(t["99"]), "t_most": size(t["most"]),
            "ns": time["candidate"], "ns_textbook": time["textbook"],
            "ns_certain": time["certain"]}


def size(ulps):
    return "inf" if ulps is None else f"{ulps:.6g}"


def rows_of(surehit, name, inputs, subject):
    truth = "reference" if name in PROMISING else "exact"
    usual = COUNT_OF_USUAL_BY_REFERENCE if name in PROMISING else COUNT_OF_USUAL
    found = judged(surehit, subject, usual, USUAL, truth)
    found += judged(surehit, subject, COUNT, regimes_of(surehit), truth)
    found.sort(key=lambda row: SHAPES.index(row["shape"]))  # the regimes stay in order
    return [row_of(name, inputs, truth, row) for row in found]


def take_times(surehit, subject, rows):
    runs = [judged(surehit, subject, COUNT, ["typical"]) for _ in range(TIMES)]
    for row in rows:
        if row["regime"] != "typical":
            continue
        own = [next(one for one in found if one["shape"] == row["shape"])["nanoseconds"]
               for found in runs]
        own.sort(key=lambda time: time["candidate"])
        middle = own[TIMES // 2]
        row.update(ns=middle["candidate"], ns_textbook=middle["textbook"],
                   ns_certain=middle["certain"])


def inputs_of(library):
    """By the names of its functions, which are not loaded: they may want a sanitizer's runtime."""
    functions = pathlib.Path(library).read_bytes()
    return "float" if re.search(rb"sure_candidate_[a-z_]+_float\0", functions) else "double"


def names_of(libraries):
    return {re.fullmatch(r"libpeer-(\w+)\.\w+", os.path.basename(path))[1]: os.path.abspath(path)
            for path in libraries}


def measure(root, surehit, libraries):
    rows, known = [], list(who(root))
    candidates = [(tier, "float" if tier == "float32" else "double", ["--tier", tier])
                  for tier in TIERS]
    candidates += [(name, inputs_of(libraries[name]), ["--candidate", libraries[name]])
                   for name in sorted(libraries, key=known.index)]
    for name, inputs, subject in candidates:
        own = rows_of(surehit, name, inputs, subject)
        take_times(surehit, subject, own)
        rows += own
        print(name, flush=True)
    machine = run(surehit, "bench", "--shape", "plane", "--cases", "512", "--repeats", "1")
    with open(root / "docs/peers.csv", "w", newline="", encoding="ascii") as file:
        file.write(f"seed,0\ncpu,{machine['cpu']}\ncompiler,{machine['compiler']}\n")
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        for row in rows:
            for column in NANOSECONDS:
                row[column] = "" if row[column] is None else f"{row[column]:.1f}"
            writer.writerow(row)


# The page.

def read_record(path):
    with open(path, newline="", encoding="ascii") as file:
        made = dict(file.readline().strip().split(",", 1) for _ in range(3))
        rows = list(csv.DictReader(file))
    for row in rows:
        row.update({name: int(row[name]) for name in COUNTS})
        row.update({name: float(row[name] or "nan") for name in SIZES + NANOSECONDS})
    return made, rows


def shapes_of(rows):
    """Those of the record, in their order."""
    recorded = {row["shape"] for row in rows}
    return [shape for shape in SHAPES if shape in recorded]


def per_million(share):
    """0 is none at all."""
    millionths = round(1e6 * share)
    return "0" if share == 0 else f"{millionths:,}" if millionths > 0 else "<1"


def share(row):
    return row["wrong"] / row["valid"]


def per_cent(part, whole):
    return f"{100 * part / whole:.1f}" if whole > 0 else "–"


def ulps(number):
    return f"{number:.0f}" if number < 1e4 else f"{number:.1e}".replace("e+", "e")


def table_row(name, rows):
    """The rows are a candidate's of one shape."""
    typical, grazing = (next(row for row in rows if row["regime"] == regime) for regime in USUAL)
    possible = [row for row in rows if row["valid"] > 0]
    worst = max(possible, key=share)
    everywhere = statistics.fmean(share(row) for row in possible)
    breaches = statistics.fmean(row["breaches"] / row["cases"] for row in rows if row["cases"] > 0)
    return [name, per_million(share(typical)), per_million(share(grazing)),
            per_million(everywhere),
            f"`{worst['regime']}` {per_million(share(worst))}" if worst["wrong"] else "none",
            per_million(breaches), *(ulps(typical[name]) for name in SIZES),
            per_cent(typical["t_right"], typical["t_hits"]),
            *(f"{typical[name]:.0f}" for name in NANOSECONDS)]


TABLE_HEAD = ["candidate", "wrong: typical", "grazing", "all", "worst in", "breaches",
              "t: 50 %", "99 %", "most", "right %", "ns", "textbook", "certain"]


def asked(row):
    return row["cases"] + row["skipped"] + row["unasked"]


def counts_of(rows):
    """How many were asked, of whom and where."""
    def counts(promising, usual):
        numbers = {asked(row) for row in rows if (row["candidate"] in PROMISING) == promising
                   and (row["regime"] in USUAL) == usual}
        return " to ".join(f"{number:,}" for number in sorted(numbers))
    return (f"{counts(False, True)} of `typical` and of `grazing` ({counts(True, True)} for "
            f"{named(PROMISING)}), {counts(False, False)} of every other")


def named(names):
    return " and ".join(f"`{name}`" for name in names)


def upper_end(cases):
    """Of Wilson's 95 % interval, none of so many being wrong."""
    z = 1.959963984540054
    return z * z / (cases + z * z)


def shape_table(rows, shape, links):
    """A row for each candidate that answers it."""
    own = [row for row in rows if row["shape"] == shape]
    names = dict.fromkeys(row["candidate"] for row in own)
    return table(TABLE_HEAD, [table_row(links[name], [row for row in own
                                                      if row["candidate"] == name])
                              for name in names], right={*range(1, 4), *range(5, 13)})


def links_of(root):
    """{name: how a page of docs has it}"""
    return {name: row[0].split(" | ")[0][2:] for name, row in who(root).items()}


def page_values(made, rows, links):
    """What fills the page."""
    none = "; ".join(f"0 of {count:,} is up to {per_million(upper_end(count))}"
                     for count in sorted({asked(row) for row in rows}, reverse=True))
    return {"seed": made["seed"], "counts": counts_of(rows), "none": none, "times": TIMES,
            "machine": f"{made['cpu']}, {made['compiler']}",
            "shapes": block(*(f"## {shape.capitalize()}\n\n{shape_table(rows, shape, links)}"
                              for shape in shapes_of(rows)))}


def summary(rows, links):
    """A row for each candidate: wrong in typical / grazing / all regimes, by shape."""
    cells = []
    for name in dict.fromkeys(row["candidate"] for row in rows):
        cells.append([links[name]])
        for shape in shapes_of(rows):
            own = [row for row in rows if (row["candidate"], row["shape"]) == (name, shape)]
            cells[-1].append(" / ".join(table_row(name, own)[1:4]) if own else "–")
    return table(["candidate"] + shapes_of(rows), cells)


def made_pages(root):
    """(path, text) of all that the record makes."""
    made, rows = read_record(root / "docs/peers.csv")
    links = links_of(root)
    for path, values in ((root / "docs/peers.md", page_values(made, rows, links)),
                         (root / "docs/judge.md", {"peers": block(summary(rows, links))})):
        yield path, pages.filled(path.read_text(encoding="utf-8"), values)


# The check.

def words(text):
    return " ".join(re.sub(r"^ \*", "", text, flags=re.M).split())


def check_who(root, rows):
    """Who is in the record is on the page, and is said to be what he is."""
    known, found = who(root), list(dict.fromkeys(row["candidate"] for row in rows))
    if list(known) != found:
        yield f"docs/peers.md: is about {', '.join(known)}; the record about {', '.join(found)}"
    for name, row in known.items():
        own = [one for one in rows if one["candidate"] == name]
        shapes = list(dict.fromkeys(one["shape"] for one in own))
        said = (row["inputs"], row["shapes"])
        everything = shapes == shapes_of(rows)
        if said != (own[0]["inputs"], "all" if everything else ", ".join(shapes)):
            yield f"docs/peers.md: {name}: answers {shapes} in {own[0]['inputs']}, not as said"
        if row["peer"]:
            text = (root / row["file"]).read_text(encoding="utf-8")
            head = words(text.removeprefix(SPDX).split("*/")[0])
            for quotation in [f"Stands for {row['stands']}", *row["by"].split("; ")]:
                if quotation not in head:
                    yield f"{name}: its adapter's head does not say: {quotation}"


def check_rows(rows, libraries):
    """Everyone is there, with all regimes of each shape that it answers."""
    def regimes(name, shape):
        return [row["regime"] for row in rows if (row["candidate"], row["shape"]) == (name, shape)]
    for name in [*TIERS, *libraries]:
        shapes = {row["shape"] for row in rows if row["candidate"] == name}
        if not shapes or (name in TIERS and shapes != set(shapes_of(rows))):
            yield f"docs/peers.csv: {name}: rows are missing"
        if any(regimes(name, shape) != regimes("exact", shape) for shape in shapes):
            yield f"docs/peers.csv: {name}: regimes are missing"


def check_promises(rows):
    for row in rows:
        if row["candidate"] not in PROMISING:
            continue
        where = f"docs/peers.csv: {row['candidate']} {row['shape']} {row['regime']}"
        if row["truth"] != "reference":
            yield f"{where}: judged by its like"
        if row["wrong"] or row["breaches"]:
            yield f"{where}: wrong, or a breach"
        if row["candidate"] == "exact" and row["t_right"] != row["t_hits"]:
            yield f"{where}: t is not correctly rounded"


def check_again(surehit, rows, libraries):
    """The answers are the same on every machine, but Embree's."""
    for name, library in libraries.items():
        if name == "embree":
            continue
        recorded = {row["shape"]: row for row in rows
                    if (row["candidate"], row["regime"]) == (name, "neighbour")}
        subject = ["--candidate", library]
        found = {row["shape"]: row_of(name, inputs_of(library), "exact", row)
                 for row in judged(surehit, subject, COUNT, ["neighbour"])}
        if set(found) != set(recorded):
            yield f"docs/peers.csv: {name} answers {sorted(found)}, not {sorted(recorded)}"
        for shape in set(found) & set(recorded):
            for column in LABELS + COUNTS + SIZES:
                was, now = recorded[shape][column], found[shape][column]
                if was != (float(now) if column in SIZES else now):
                    yield f"docs/peers.csv: {name} {shape} neighbour: {column} is {now}, not {was}"


def check(root, surehit, libraries):
    _, rows = read_record(root / "docs/peers.csv")
    faults = [difference for path, text in made_pages(root)
              for difference in pages.differences(path, text, "docs/peers.csv")]
    faults += check_who(root, rows)
    faults += check_rows(rows, libraries)
    faults += check_promises(rows)
    faults += check_again(surehit, rows, libraries)
    return pages.verdict(faults)


def main():
    root, options = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
    if options and options[0] == "--check":
        return check(root, options[1], names_of(options[2:]))
    if options and options[0] == "--measure":
        measure(root, options[1], names_of(options[2:]))
    for path, text in made_pages(root):
        path.write_text(text, encoding="utf-8")
    return 0


sys.exit(main())
