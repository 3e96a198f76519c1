#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The site of the pages is whole, and what is not whole is seen: test_site.py ROOT SCRATCH

The tree's pages are built, and the tree stays as it is. Then a copy with faults: links to no page,
to no file and to no place of a page, pages to which nothing leads; and one that the list leaves
out."""
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from pages import tree_of, verdict  # noqa: E402
import site_of_pages  # noqa: E402

ROOT, SCRATCH = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
# What is added to a page, and what is said of it.
SEEDED = {
    "docs/words.md": ("[a](nowhere.md)", "words.html: nowhere.md is nowhere"),
    "docs/python.md": ("[a](../src/nowhere.c)", "python.html: ../src/nowhere.c is nowhere"),
    "docs/walks.md": ("[a](contract.md#nowhere)", "contract.html#nowhere: no such place"),
    "docs/judge.md": ("[a](#nowhere)", "#nowhere: no such place"),
    "docs/report.md": ("![a](nowhere.png)", "report.html: nowhere.png is nowhere"),
    "docs/lonely.md": ("# One\n\n[other](lonely_too.md)", "lonely.html: no text leads here"),
    "docs/lonely_too.md": ("# Other\n\n[one](lonely.md)", "lonely_too.html: no text leads here"),
}


def seeded(folder):
    """The tree with these faults."""
    for name in tree_of(ROOT):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    for page, (text, _) in SEEDED.items():
        with open(folder / page, "a", encoding="utf-8") as file:
            file.write(f"\n{text}\n")
    return folder


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    before = tree_of(ROOT)
    faults = site_of_pages.build(ROOT, SCRATCH / "site")
    if len(before) < 100 or tree_of(ROOT) != before:
        faults.append("building the site changes the tree")
    found = site_of_pages.build(seeded(SCRATCH / "copy"), SCRATCH / "seeded")
    for _, words in SEEDED.values():
        if not any(words in fault for fault in found):
            faults.append(f"not found: {words}")
    if len(found) != len(SEEDED):
        faults += [f"{len(found)} faults were found of {len(SEEDED)}:", *found]
    with open(SCRATCH / "site/mkdocs.yml", "a", encoding="utf-8") as file:
        file.write("  - lost: docs/lost.md\n")
    found = site_of_pages.faults_of(SCRATCH / "site")
    if not any("lost.html: not in the list" in fault for fault in found):
        faults.append("not found: a page that the list leaves out")
    return verdict(faults)


sys.exit(main())
