# SPDX-License-Identifier: MIT
"""Pages of docs that are made out of records: their tables, their parts, and whether they are the
records' still."""
import argparse
import difflib
import json
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # beside the sources

SPDX = "/* SPDX-License-Identifier: MIT */\n"  # before a source's head


def line(cells):
    return "| " + " | ".join(str(cell) for cell in cells) + " |\n"


def table(head, rows, right=None):
    """In Markdown; `right`: the columns that are numbers, all but the first unless told."""
    right = range(1, len(head)) if right is None else right
    rule = ["---:" if i in right else "---" for i in range(len(head))]
    return "".join(map(line, [head, rule, *rows]))


def block(*parts):
    """What fills a place of whole lines."""
    return "\n" + "\n".join(parts)


def filled(page, values):
    """The page with what stands between <!-- name --> and <!-- /name --> renewed, for each name."""
    for name, value in values.items():
        pattern = rf"(?s)(<!-- {name} -->).*?(<!-- /{name} -->)"
        page, count = re.subn(pattern, lambda found, value=value: f"{found[1]}{value}{found[2]}",
                              page)
        if count != 1:
            sys.exit(f"places in the page, not one: {count}: <!-- {name} --> ... <!-- /{name} -->")
    return page


def differences(path, made, record):
    """What is not as the record has it, as lines."""
    there = path.read_text(encoding="utf-8")
    return list(difflib.unified_diff(there.splitlines(True), made.splitlines(True), str(path),
                                     record, n=0))


def tree_of(root):
    """The tree's own files, and when they were written: who builds must leave them as they are."""
    apart = {".git", "build", "out", "__pycache__", "node_modules"}
    tops = [top for top in root.iterdir()
            if top.name not in apart and not (top / "meson-info").exists()]
    return {str(path.relative_to(root)): path.stat().st_mtime_ns for top in tops
            for path in (top.rglob("*") if top.is_dir() else [top])
            if path.is_file() and not apart & set(path.relative_to(root).parts)}


def verdict(faults):
    """The exit status, after the faults, of which each may be a whole line."""
    print(*(fault.removesuffix("\n") for fault in faults),
          "0 passed, 1 failed" if faults else "1 passed, 0 failed", sep="\n")
    return 1 if faults else 0


def written_or_checked(path, values, record, checked):
    """The page filled anew, or held against that. The exit status."""
    made = filled(path.read_text(encoding="utf-8"), values)
    if checked:
        return verdict(differences(path, made, record))
    path.write_text(made, encoding="utf-8")
    return 0


def run(about, record, made_of, measure, words):
    """The exit status of a script ROOT [--measure [OPTION ...] | --check]: the record is measured
    if that is asked for, and what `made_of` says is made of it, {path: text}, or is held against
    that. `words`: names, defaults and meanings of the options of measuring."""
    parser = argparse.ArgumentParser(description=about,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--measure", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--record", type=pathlib.Path,
                        help=f"measured is this, not {record}, and nothing is made of it")
    for name, default, *meaning in words:
        kind = {"action": "store_true"} if default is False else {"type": type(default)}
        parser.add_argument(f"--{name}", default=default, help="".join(meaning), **kind)
    options = parser.parse_args()
    path = options.record or options.root / record
    if options.measure:
        path.write_text(json.dumps(measure(options), indent=1) + "\n", encoding="utf-8")
    made = {} if options.record else made_of(options.root,
                                             json.loads(path.read_text(encoding="utf-8")))
    if options.check:
        return verdict([fault for place, text in made.items()
                        for fault in differences(place, text, record)])
    for place, text in made.items():
        place.write_text(text, encoding="utf-8")
    return 0
