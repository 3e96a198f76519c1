# SPDX-License-Identifier: MIT
"""Makes of the library's sources two files that need no build system, surehit.h and surehit.c.

    single.py FOLDER VERSION LICENSE NAMES -- FLAG... -- COMPILER... -- PUBLIC_HEADER...
              -- SOURCE... [-- MACRO SOURCE...]...

The first sources are taken as they are, those of each further list once more where MACRO is
defined; the compiler preprocesses them. FLAGs are what they need of it, and NAMES is what stands
before each: what sources call of each other. FOLDER/surehit.d says what all was made of.

A source becomes a section of surehit.c behind the headers that it includes. A header stands there
once, and once more with a MACRO that changes it. A name of a section's own that stands elsewhere,
too, becomes NAME_SECTION; by a macro, which finds names that other macros put together."""
import collections
import pathlib
import re
import sys

import declarations

LICENCE = "SPDX-License-Identifier"  # at the head, once
INCLUDE = re.compile(r'\s*#\s*include\s+(?:"(.*)"|<(surehit/.*)>|<(.*)>)')
WORD = re.compile(r"""/\*.*?\*/|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'|(?:\.|->)\s*\w+|\w+""", re.S)
HEAD = """\
/* SPDX-License-Identifier: MIT */
/* surehit {version}: {what}, made of its sources.
 *
{license}
 */
"""
NEEDS = """\

/* This is C11. Decisions are proven for operations that are rounded one by one:
 *
 *     cc -std=c11 -O2 {flags} -c surehit.c
 *
 * and -lm for the program. -DNDEBUG leaves out what asserts that entry conditions hold. GCC and
 * Clang are told here what those flags say, though Clang obeys -ffp-contract=fast all the same;
 * -ffast-math, and whatever else can be seen to change a result, is refused below. */
#ifdef __clang__
#pragma clang diagnostic ignored "-Wunknown-warning-option"
#pragma clang diagnostic ignored "-Wunused-function"
#pragma clang diagnostic ignored "-Wbitwise-instead-of-logical" /* no branch, on purpose */
#pragma clang diagnostic ignored "-Wbitwise-conditional-parentheses"
#endif
#if defined __GNUC__ && !defined __clang__
#pragma GCC optimize({told})
#else
#pragma STDC FP_CONTRACT OFF
#endif

#include "surehit.h"

"""


def includes(names):
    return "".join(f"#include <{name}>\n" for name in sorted(names))


def define(pairs):
    return "".join(f"#define {name} {other}\n" for name, other in sorted(pairs.items()))


def undefine(names):
    return "".join(f"#undef {name}\n" for name in sorted(names))


def with_names(text, names):
    """Exchanged, but for members of structs, comments and strings."""
    return WORD.sub(lambda found: names.get(found[0], found[0]), text)


def members(text):
    return {re.sub(r"\W", "", found[0]) for found in WORD.finditer(text) if found[0][0] in ".-"}


class Source:
    """A file's text without what it includes: `headers`, and those of the `system`, but for what is
    asked under a condition. A header without #pragma once is a part of who includes it."""

    def __init__(self, path, tree):
        self.path, self.tree = path, tree
        self.headers, self.system, self.pieces = [], set(), []
        text, depth, kept = path.read_text(), 0, []
        self.once = "#pragma once" in text.splitlines() or tree.is_public(path)
        for line in text.splitlines():
            depth += bool(re.match(r"\s*#\s*if", line)) - bool(re.match(r"\s*#\s*endif", line))
            kept += self.kept(line, depth)
        self.text = re.sub(r"\n{3,}", "\n\n", "\n".join(kept).strip("\n") + "\n")
        self.macros = set(re.findall(r"^\s*#\s*define\s+(\w+)", self.text, re.M))

    def kept(self, line, depth):
        found = INCLUDE.match(line)
        if not found:
            return [] if line == "#pragma once" or LICENCE in line else [line]
        own, public, system = found.groups()
        if system and depth > 0:
            return [line]
        if system:
            self.system.add(system)
            return []
        header = self.tree.source(self.path.parent / own if own else self.tree.include / public)
        if header.once:
            self.headers.append(header)
            return []
        self.pieces += [header, *header.pieces]
        self.headers += header.headers
        self.system |= header.system
        return [header.text.rstrip("\n")]


class Tree:
    def __init__(self, include):
        self.include, self.known = include, {}

    def is_public(self, path):
        return self.include in path.parents

    def source(self, path):
        path = path.resolve()
        if path not in self.known:
            self.known[path] = Source(path, self)
        return self.known[path]

    def ordered(self, sources):
        """They and what they include, each behind what it includes."""
        seen, order = set(), []

        def visit(source):
            if source not in seen:
                seen.add(source)
                for header in source.headers:
                    visit(header)
                order.append(source)
        for source in sources:
            visit(source)
        return order


class Part:
    """A header or, as a section, a source: as it is where the macro of its list is defined."""

    def __init__(self, source, macro, is_section):
        self.source, self.macro, self.is_section = source, macro, is_section
        self.own = set()  # names
        stem = source.path.stem if is_section else ""
        self.suffix = stem + "_" * bool(stem and macro) + macro.removeprefix("SURE_").lower()

    def renamed(self, names):
        return {name: f"{name}_{self.suffix}" for name in self.own & names}


class Single:
    def __init__(self, tree, compiler, names, lists):
        self.names = names
        self.tree, self.compiler, self.macros = tree, compiler, [macro for macro, _ in lists]
        self.parts = []
        for macro, paths in lists:
            self.add_list(macro, [tree.source(path) for path in paths])
        for part in self.parts:
            if part.is_section:
                self.learn_names(part)
        self.taken = names.macros.union(*(part.source.macros for part in self.headers()))
        counted = collections.Counter(name for part in self.parts for name in part.own)
        self.clashes = self.taken | {name for name, count in counted.items() if count > 1}

    def headers(self, *macros):
        return [part for part in self.parts
                if not part.is_section and (part.macro in macros or not macros)]

    def changed(self, header):
        text = "".join(one.text for one in self.tree.ordered([header]))
        return any(macro and re.search(rf"\b{macro}\b", text) for macro in self.macros)

    def add_list(self, macro, sources):
        there = {part.source for part in self.headers()}
        for source in self.tree.ordered(sources):
            is_section = source in sources
            again = source in there and not self.changed(source)
            if is_section or not again and not self.tree.is_public(source.path):
                self.parts.append(Part(source, macro, is_section))

    def learn_names(self, section):
        """Of the section and of the headers that it includes."""
        owners = {part.source.path: part for part in self.headers("", section.macro)}
        owners[section.source.path] = section
        for part in list(owners.values()):
            owners.update((piece.path, None) for piece in part.source.pieces)
        macro = [f"-D{section.macro}"] if section.macro else []
        command = [*self.compiler, *macro, "-E", str(section.source.path)]
        for part, name in declarations.names(command, owners):
            part.own.add(name)

    def check_headers(self, macro):
        stands = {}
        for part in self.headers(macro):
            for name in part.own:
                other = stands.setdefault(name, part)
                if other is not part:
                    sys.exit(f"{name} stands in {other.source.path} and {part.source.path}")

    def texts(self):
        yield includes(set().union(*(part.source.system for part in self.parts)))
        yield f"\n{self.names.text}"
        for macro in self.macros:
            self.check_headers(macro)
            yield from self.list_texts(macro)

    def list_texts(self, macro):
        again = {}
        if macro:
            gone = set().union(*(part.source.macros for part in self.headers(macro)))
            for part in self.headers(macro):
                again.update(part.renamed(self.clashes))
            yield f"\n#define {macro}\n{undefine(gone)}{define(again)}"
        for part in self.parts:
            if part.macro == macro:
                where = part.source.path.relative_to(self.tree.include.parent)
                yield f"\n/* {where}{', ' + macro if macro else ''} */\n\n"
                yield self.section_text(part) if part.is_section else part.source.text
        if macro:
            yield f"\n{undefine(again)}#undef {macro}\n"

    def section_text(self, part):
        """A macro would rename members of structs, and there may be another one of the name: such
        names are exchanged in the text."""
        names, text = part.renamed(self.clashes), part.source.text
        at_once = {name for name in names if name in self.taken | members(text)}
        text = with_names(text, {name: names.pop(name) for name in at_once})
        return f"{define(names)}{text}{undefine(part.source.macros | set(names))}"


def header_texts(tree, headers):
    order = tree.ordered(sorted(headers, key=lambda one: one.path.name != "surehit.h"))
    yield "#pragma once\n\n"
    yield includes(set().union(*(header.system for header in order)))
    for header in order:
        yield f"\n/* {header.path.relative_to(tree.include)} */\n\n{header.text}"


def split(words):
    lists = [[]]
    for word in words:
        if word == "--":
            lists.append([])
        else:
            lists[-1].append(word)
    return lists


def main():
    options, flags, compiler, headers, sources, *more = split(sys.argv[1:])
    folder, version, license, names = options
    lists = [(macro, list(map(pathlib.Path, paths)))
             for macro, *paths in [["", *sources], *more]]
    headers = [pathlib.Path(path).resolve() for path in headers]
    tree = Tree(headers[0].parents[1])
    single = Single(tree, [*compiler, "-std=c11", f"-I{tree.include}"],
                    tree.source(pathlib.Path(names)), lists)
    lines = pathlib.Path(license).read_text().strip().splitlines()
    terms = "\n".join(f" * {line}".rstrip() for line in lines)
    told = ", ".join(f'"{flag.removeprefix("-f")}"' for flag in flags)

    def write(name, what, texts):
        head = HEAD.format(version=version, what=what, license=terms)
        pathlib.Path(folder, name).write_text(head + "".join(texts))

    write("surehit.h", "its public headers in one", header_texts(tree, map(tree.source, headers)))
    write("surehit.c", "the whole library in one file",
          [NEEDS.format(flags=" ".join(flags), told=told), *single.texts()])
    made_of = " ".join(str(path).replace(" ", "\\ ") for path in
                       [__file__, declarations.__file__, license, *tree.known])
    pathlib.Path(folder, "surehit.d").write_text(f"{folder}/surehit.h: {made_of}\n")


main()
