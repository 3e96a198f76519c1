#!/usr/bin/env python3
"""The README's table is what `surehit extremes` prints. Arguments: surehit, source root; --update
renews it.

The shares of wrong answers are the same on every machine and must agree; the times are only renewed
by --update."""
import pathlib
import re
import subprocess
import sys

surehit, root = sys.argv[1:3]
readme = pathlib.Path(root) / "README.md"
text = readme.read_text()
START, END = "<!-- table: tests/house/test_readme.py --update -->\n", "<!-- end of table -->"
head, rest = text.split(START)
old, tail = rest.split(END)


def measured():
    """The tiers' names; (shape, [(wrong, ns) for each tier]) from the printed table's totals."""
    out = subprocess.run([surehit, "extremes"], capture_output=True, text=True, check=True).stdout
    lines = out.splitlines()
    tiers = next(line.split() for line in lines if line.split()[:1] == ["float32"])
    rows, shape = [], None
    for line in lines[lines.index(next(l for l in lines if "float32" in l)) + 2:]:
        if re.fullmatch(r"\w+", line):
            shape = line
        total = re.fullmatch(r"(  all|all shapes) +(.*)", line)
        if total:
            cells = total[2].split()
            name = shape if total[1] == "  all" else "all"
            rows.append((name, [(cells[3 * i], cells[3 * i + 2]) for i in range(len(tiers))]))
    return tiers, rows


def table(tiers, rows):
    yield "| |" + "".join(f" {tier} wrong % | ns |" for tier in tiers)
    yield "|---|" + "---:|---:|" * len(tiers)
    for name, cells in rows:
        yield f"| {name} |" + "".join(f" {wrong} | {ns} |" for wrong, ns in cells)


def wrong_shares(lines):
    """Each row without its times."""
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in lines if "|" in line]
    return [row[:1] + row[1::2] for row in rows]


tiers, rows = measured()
new = list(table(tiers, rows))
if len(rows) != 6:
    sys.exit(f"expected five shapes and a total in the table, read {len(rows)} rows")
if "--update" in sys.argv:
    readme.write_text(head + START + "\n".join(new) + "\n" + END + tail)
elif wrong_shares(old.splitlines()) != wrong_shares(new):
    print("README.md is stale; renew it with tests/house/test_readme.py SUREHIT ROOT --update:")
    print("\n".join(new))
    print("0 passed, 1 failed")
    sys.exit(1)
print("1 passed, 0 failed")
