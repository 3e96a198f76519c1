# SPDX-License-Identifier: MIT
"""The table of docs/register.md: each stem has a sibling of every kind, or a reason why not."""
import functools
import re

COLUMNS = ["stem", "what is derived", "source", "fuzz", "reference", "tracer"]
REASON = re.compile(r"not applicable, because \S+(?: \S+){3,}")


@functools.cache
def read(path):
    return path.read_text() if path.is_file() else None


@functools.cache
def listed(root, top, pattern):
    return [str(path.relative_to(root)) for path in sorted((root / top).rglob(pattern))]


class Tree:
    """The texts of the tree, by path; those in `changed` instead, None for what is not there."""

    def __init__(self, root, changed=()):
        self.root, self.changed = root, dict(changed)

    def text(self, path):
        return self.changed[path] if path in self.changed else read(self.root / path)

    def paths(self, top, pattern):
        return listed(self.root, top, pattern)


def rows(tree):
    """{column: cell} of each row."""
    for line in tree.text("docs/register.md").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        stem = re.match(r"\[`(\w+)`\]", cells[0])
        if stem and len(cells) == len(COLUMNS):
            source = re.match(r"\[(src/[\w/]+)\]", cells[2])
            yield {**dict(zip(COLUMNS, cells)), "stem": stem[1],
                   "source": source[1] if source else ""}


def names_in(cell):
    return re.findall(r"`([\w/.]+)`", cell)


def included(tree, path):
    """The file, and what it includes of tests and fuzz: headers, with their sources."""
    seen, ahead = [], [path]
    while ahead:
        path = ahead.pop()
        text = tree.text(path)
        if path in seen or text is None:
            continue
        seen.append(path)
        for name in re.findall(r'^#include "(?:[\w./]*/)?(\w+)\.h"', text, re.M):
            ahead += [f"{folder}/{name}.{end}" for end in "ch"
                      for folder in ("fuzz", "tests/support", "tests/oracles", "tests/stages")]
    return seen


def of_fuzz(tree, stem, cell):
    """What the targets of a cell need."""
    for target in names_in(cell):
        is_shape = f"tests/support/shapes/{target}.c" in tree.paths("tests/support/shapes", "*.c")
        source = f"fuzz/fuzz_{'shape' if is_shape else target}.c"
        asked = "FUZZ_SHAPE" if is_shape else rf"<surehit/{stem}\.h>"
        yield [source], "."
        yield [f"fuzz/corpus/{target}.hex"], "."
        yield ["fuzz/meson.build"], "shapes" if is_shape else f"'{target}'"
        yield [f"fuzz/seeded/{target}.mutants"], "."
        yield included(tree, source), asked


def of_reference(tree, cell):
    """What the functions of a cell need: to be there, and to be asked by others than their own
    tests."""
    askers = [path for path in tree.paths("tests", "*.c") + tree.paths("fuzz", "*.c")
              if "/test_reference" not in path]
    for name in names_in(cell):
        yield ["reference/reference.h"], rf"\b{name}\("
        yield askers, rf"\b{name}\("


def siblings(tree, row):
    """(column, files, pattern): one of the files has to hold the pattern."""
    stem = row["stem"]
    header = f"include/surehit/{stem}.h"
    declared = re.findall(r"SURE_(?:PLAIN|TIERED)\(\w+, sure_(\w+)|"
                          r"\bsure_(\w+?)(?:_(?:float32|textbook|stable|certain|exact))?\(",
                          tree.text(header) or "")
    functions = {one or other for one, other in declared}
    yield "header", [header], "."
    yield "source", [f"{row['source']}/{stem}.c"], "."
    yield "laws", [header], r"\bLaws? +1"
    yield "laws", tree.paths("tests", "meson.build"), rf"'{stem}'|foreach shape : shapes"
    yield "page", [f"docs/derivations/{stem}.md"], "."
    for files, pattern in of_fuzz(tree, stem, row["fuzz"]):
        yield "fuzz", files, pattern
    for files, pattern in of_reference(tree, row["reference"]):
        yield "reference", files, pattern
    for path in names_in(row["tracer"]):
        yield "tracer", [path], rf"\b(?:sure_)?(?:{'|'.join(sorted(functions | {stem}))})"


def row_faults(tree, row):
    for column in ("fuzz", "reference", "tracer"):
        if not names_in(row[column]) and not REASON.fullmatch(row[column]):
            yield f"{row['stem']}: {column}: neither a sibling nor a reason"
    for column, files, pattern in siblings(tree, row):
        if not any(re.search(pattern, tree.text(path) or "") for path in files):
            yield f"{row['stem']}: {column}: {pattern} is in none of {', '.join(files[:3])}"


def faults(tree):
    found = list(rows(tree))
    if len(found) < 27:
        yield f"docs/register.md: only {len(found)} stems read"
    for row in found:
        yield from row_faults(tree, row)
    known = {row["stem"] for row in found}
    for page in tree.paths("docs/derivations", "*.md"):
        if page.rsplit("/", 1)[1][:-3] not in known:
            yield f"{page}: no such stem in docs/register.md"


def unnoticed(tree):
    """Siblings and reasons that could be removed without a fault: each is removed, alone."""
    tried = 0
    for row in rows(tree):
        for column, files, pattern in siblings(tree, row):
            tried += 1
            gone = {path: re.sub(pattern, "", tree.text(path)) if pattern != "." else None
                    for path in files if re.search(pattern, tree.text(path) or "")}
            without = row_faults(Tree(tree.root, gone), row)
            if not any(fault.startswith(f"{row['stem']}: {column}") for fault in without):
                yield f"{row['stem']}: {column}: {pattern} may be removed"
        for column in ("fuzz", "reference", "tracer"):
            tried += 1
            if not any(True for _ in row_faults(tree, row | {column: ""})):
                yield f"{row['stem']}: {column}: an empty cell is not noticed"
    if tried < 300:
        yield f"only {tried} siblings were tried"
