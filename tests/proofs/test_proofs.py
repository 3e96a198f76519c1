#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The proofs of docs/proofs are proofs, and of the numbers that the library computes with.

A script names the constants that it is about, and their values are read from the source.

test_proofs.py show ROOT SCRIPT: prints the script as Gappa reads it, values in the names' place.

test_proofs.py prove GAPPA ROOT SCRIPT: Gappa proves every goal of the script, takes nothing on
trust, and proves no absurdity from the same hypotheses. Each constant counts: with a sixteenth of
its value, or with sixteen times as much, something is not proven any more.

test_proofs.py expressions ROOT PROGRAM SCRIPTS...: what the scripts say that is computed, in
comments that begin with `computed:`, is what the program (expressions.cpp) says, word for word.

test_proofs.py constants ROOT SCRIPTS...: no script is left out; each constant of the source is
defined once and named by a script, or listed here with the test that holds it."""
import fractions
import pathlib
import re
import subprocess
import sys

# Constants that no script is about: why, and the test that holds them.
HELD = {
    "AXIS_LEAST": ("shorter axes are not moved", "referee"),
    "AXIS_MOST": ("nor are longer ones", "referee"),
    "MARGIN_MOST": ("where a search ends", "referee"),
    "ORDER_FLUSHED": ("more than all that is flushed, by 2^20", "hit_order"),
    "ORDER_SHARE": ("four roundings, counted where it is defined", "hit_order"),
    "ROUNDING": ("a moved object is wider by more than its roundings", "margins"),
    "ROUNDING_LEAST": ("the same of what underflows", "margins"),
    "SLOPE_FLOOR": ("more than what underflows", "discriminant"),
    "SLOPE_SHARE": ("roundings counted in tangent.md", "discriminant"),
    "STEPS": ("what a film counts in: no bound", "film"),
    "SURE_SPAWN_STEPS": ("where a search ends", "spawn"),
    "SURE_STABLE_GRAZING": ("from where on refract's bound is promised", "refract"),
    "TILT_MOST": ("where roundings tilt more, nothing is moved", "margins"),
}

HEADER = "include/surehit/bounds.h"
DEFINE = re.compile(r"^ *# *define +([A-Z][A-Z0-9_]*) +(.+)$", re.M)
NUMBER = re.compile(r"0x[0-9a-f]+(?:\.[0-9a-f]*)?(?:p[+-]?\d+)?|\d+(?:\.\d*)?")
NAME = re.compile(r"\b[A-Z][A-Z0-9]*_[A-Z0-9_]+\b")


def number(token):
    """A number as C writes it."""
    if not token.startswith("0x"):
        return fractions.Fraction(token)
    digits, _, exponent = token[2:].partition("p")
    whole, _, part = digits.partition(".")
    return int(whole + part, 16) * fractions.Fraction(2) ** (int(exponent or 0) - 4 * len(part))


def value_of(text, constants):
    """Of an expression of numbers and of constants' names."""
    numbers = []

    def put(token):
        numbers.append(token)
        return f"numbers[{len(numbers) - 1}]"

    pieces = re.split(f"({NUMBER.pattern}|{NAME.pattern})", text)
    for i in range(1, len(pieces), 2):
        name = pieces[i]
        pieces[i] = put(number(name) if name[0].isdigit() else
                        value_of(constants[name], constants))
    if re.search(r"[^-+*/() ]", "".join(pieces[::2])):
        raise ValueError(text)
    return eval("".join(pieces), {"__builtins__": {}, "numbers": numbers})


def definitions(root, faults):
    """Text by name of each constant that decisions rest on."""
    found = {}
    for path in sorted(p for top in ("include", "src") for p in (root / top).rglob("*.[ch]")):
        place = path.relative_to(root)
        for name, text in DEFINE.findall(path.read_text()):
            text = text.split("/*")[0].strip()
            published = str(place) == HEADER
            if not (published or re.search(r"0x[\da-f.]+p[-+]?\d|_ERROR\b", text) or
                    name.endswith("_MARGIN")):
                continue
            if name in found:
                faults.append(f"{place}: {name} is defined a second time")
            if name.startswith("SURE_") and not published:
                faults.append(f"{place}: {name} belongs into {HEADER}")
            found[name] = text
    if len(found) < 60:
        faults.append(f"only {len(found)} constants were read")
    return found


def names_in(script):
    """Of the constants that the script names, comments left out."""
    code = "\n".join(line.partition("#")[0] for line in script.read_text().splitlines())
    return list(dict.fromkeys(NAME.findall(code)))


def with_values(script, values):
    """The script as Gappa reads it."""
    def put(name):
        value = values[name[0]]
        return f"{value.numerator}b{-(value.denominator.bit_length() - 1)}"

    parts = [line.partition("#") for line in script.read_text().splitlines(keepends=True)]
    return "".join(NAME.sub(put, code) + sign + comment for code, sign, comment in parts)


def values_in(script, root):
    known = definitions(root, [])
    return {name: value_of(known[name], known) for name in names_in(script)}


def conclusions(text):
    """Where each conclusion of the goal begins and ends: at what closes the implication."""
    depth, begun, block = 0, [], text.index("{")
    for found in re.finditer(r"->|[][(){}]", text[block:]):
        place = block + found.start()
        if found[0] == "->":
            begun.append((depth, place + 2))
        elif found[0] in "([{":
            depth += 1
        else:
            while begun and begun[-1][0] == depth:
                yield begun.pop()[1], place
            depth -= 1
            if depth == 0:
                return


def run(gappa, text):
    return subprocess.run([gappa], input=text, capture_output=True, text=True)


def contradictions(gappa, text):
    """From hypotheses that contradict each other anything follows, and Gappa doesn't tell."""
    for begin, end in conclusions(text):
        absurd = run(gappa, f"{text[:begin]} 1 <= 0 {text[end:]}")
        if not re.search("no contradiction was found|were not satisfied", absurd.stderr):
            yield f"an absurdity follows as well as:{text[begin:end]}"


def idle(gappa, script, values):
    """Constants of which the proof holds whatever they are."""
    for name, value in values.items():
        others = (with_values(script, values | {name: value * times})
                  for times in (fractions.Fraction(1, 16), 16))
        if all(run(gappa, text).returncode == 0 for text in others):
            yield f"{name}: a sixteenth of it and sixteen times as much are proven as well"


def prove(gappa, root, script):
    values = values_in(script, root)
    text = with_values(script, values)
    result = run(gappa, text)
    faults = (result.stdout + result.stderr).splitlines()  # it has nothing to say of a proof
    if result.returncode != 0:
        faults.append(f"Gappa returns {result.returncode}")
    return faults + list(contradictions(gappa, text)) + list(idle(gappa, script, values))


def constants(root, scripts):
    faults, named = [], set()
    known = definitions(root, faults)
    for missing in sorted(set((root / "docs/proofs").glob("*.gappa")) - set(scripts)):
        faults.append(f"{missing.relative_to(root)}: not in tests/proofs/meson.build")
    for script in scripts:
        named.update(names_in(script))
        for name in set(names_in(script)) - set(known):
            faults.append(f"{script.relative_to(root)}: there is no constant {name}")
    for name in sorted(set(known) - named - set(HELD)):
        faults.append(f"{name}: no script names it")
    for name in sorted(set(HELD) & named | set(HELD) - set(known)):
        faults.append(f"{name}: is listed in vain")
    tests = "\n".join(path.read_text() for path in (root / "tests").rglob("meson.build"))
    for name, (_, test) in HELD.items():
        if f"'{test}'" not in tests:
            faults.append(f"{name}: there is no test {test}")
    return faults


def computed_in(script):
    """What the script says that is computed: a comment, its next lines more indented."""
    for found in re.findall(r"^# computed: (.*(?:\n#   .*)*)", script.read_text(), re.M):
        yield " ".join(found.replace("\n#", " ").split())


def expressions(program, scripts):
    said = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    computed = set(said.splitlines())
    claimed = {f"{script.stem}: {text}" for script in scripts for text in computed_in(script)}
    return ([f"{line} (computed, and not in the script)" for line in sorted(computed - claimed)] +
            [f"{line} (in the script, and not computed)" for line in sorted(claimed - computed)] +
            ["nothing is computed"] * (not computed))


def main(what, *args):
    paths = [pathlib.Path(arg).resolve() for arg in args]
    if what == "show":
        print(with_values(paths[1], values_in(paths[1], paths[0])), end="")
        return 0
    if what == "prove":
        faults = prove(args[0], *paths[1:])
    elif what == "expressions":
        faults = expressions(paths[1], paths[2:])
    else:
        faults = constants(paths[0], paths[1:])
    for fault in faults:
        print(fault)
    print("0 passed, 1 failed" if faults else "1 passed, 0 failed")
    return 1 if faults else 0


sys.exit(main(*sys.argv[1:]))
