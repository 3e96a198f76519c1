#!/usr/bin/env python3
"""The proofs of docs/proofs are proofs, and of the numbers that the library computes with.

test_proofs.py prove GAPPA SCRIPT: Gappa proves every goal of the script, takes nothing on trust,
and proves no absurdity from the same hypotheses.

test_proofs.py constants ROOT SCRIPTS...: no script is left out; each line of a script

    # proves NAME = value [as FORM]

has the value that the source gives NAME, and FORM (or else the value as it is written) is at most
that and made of numbers of the script's own, but for units 1bN; each constant is defined once, and
has such a line or is a definition, listed here."""
import fractions
import pathlib
import re
import subprocess
import sys

# Constants that no proof could be of.
DEFINITIONS = {
    "SURE_T_ERROR_CAP": "the contract's cap, to which each stage is held",
    "SURE_SPAWN_STEPS": "where a search ends; tests/test_spawn.c holds it against true points",
}

HEADER = "include/surehit/bounds.h"
INTERNAL = re.compile(r"(SURE|NEAR|PAIR|TOUCH|QUICK|QUARTER|REACH|WALK)_[A-Z_]+")
NUMBER = re.compile(r"0x[0-9a-f]+(?:\.[0-9a-f]*)?(?:p[+-]?\d+)?|\d+b[+-]?\d+|\d+(?:\.\d*)?")
NAME = re.compile(r"\b[A-Z][A-Z_]+\b")


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


def contradictions(gappa, text):
    """From hypotheses that contradict each other anything follows, and Gappa doesn't tell."""
    for begin, end in conclusions(text):
        absurd = subprocess.run([gappa], input=f"{text[:begin]} 1 <= 0 {text[end:]}",
                                capture_output=True, text=True)
        if not re.search("no contradiction was found|were not satisfied", absurd.stderr):
            yield f"an absurdity follows as well as:{text[begin:end]}"


def prove(gappa, script):
    path = pathlib.Path(script)
    result = subprocess.run([gappa, script], capture_output=True, text=True)
    faults = (result.stdout + result.stderr).splitlines()  # it has nothing to say of a proof
    if result.returncode != 0:
        faults.append(f"Gappa returns {result.returncode}")
    return faults + list(contradictions(gappa, path.read_text()))


def number(token):
    """A number as C or Gappa writes it."""
    if "b" in token and not token.startswith("0x"):
        factor, exponent = token.split("b")
        return int(factor) * fractions.Fraction(2) ** int(exponent)
    if token.startswith("0x"):
        digits, _, exponent = token[2:].partition("p")
        whole, _, part = digits.partition(".")
        return int(whole + part, 16) * fractions.Fraction(2) ** (int(exponent or 0) - 4 * len(part))
    return fractions.Fraction(token)


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
        for name, text in re.findall(r"^ *# *define +([A-Z_]+) +(.+)$", path.read_text(), re.M):
            text = text.split("/*")[0].strip()
            published = str(place) == HEADER
            is_bound = published or re.search(r"[\da-f]p[-+]?\d|_ERROR", text)
            if not (INTERNAL.fullmatch(name) and is_bound):
                continue
            if name in found:
                faults.append(f"{place}: {name} is defined a second time")
            if name.startswith("SURE_") and not published:
                faults.append(f"{place}: {name} belongs into {HEADER}")
            found[name] = text
    if len(found) < 40:
        faults.append(f"only {len(found)} constants were read")
    return found


def check_claim(line, body, constants):
    """The name that a line says is proven, and what is wrong with it."""
    claim = re.fullmatch(r"# proves (\w+) = (.+?)(?: as (.+))?", line)
    if not claim:
        return None, "is not of the form"
    name, text, form = claim.groups()
    if name not in constants:
        return name, "there is no such constant"
    if value_of(text, {}) != value_of(constants[name], constants):
        return name, f"it is {constants[name]} in the source"
    form = form or text
    if value_of(form, {}) > value_of(text, {}):
        return name, f"{form} is more than {text}"
    own, used = set(NUMBER.findall(body)), NUMBER.findall(form)
    strange = [token for token in used if token not in own and not re.match("1(b|$)", token)]
    if strange or not own.intersection(used):
        return name, f"{', '.join(strange or used)} is not in the script"
    return name, None


def constants(root, scripts):
    faults, proven = [], set()
    known = definitions(root, faults)
    for missing in sorted(set((root / "docs/proofs").glob("*.gappa")) - set(scripts)):
        faults.append(f"{missing.relative_to(root)}: not in tests/meson.build")
    for script in scripts:
        lines = script.read_text().splitlines()
        body = "\n".join(line.partition("#")[0] for line in lines)
        for line in (line for line in lines if re.match(r"#\s*proves?\b", line)):
            name, fault = check_claim(line, body, known)
            proven.add(name)
            if fault:
                faults.append(f"{script.relative_to(root)}: {line}: {fault}")
    for name in sorted(set(known) - proven - set(DEFINITIONS)):
        faults.append(f"{name}: no script proves it")
    for name in sorted(set(DEFINITIONS) & proven | set(DEFINITIONS) - set(known)):
        faults.append(f"{name}: is no definition")
    return faults


def main(what, *args):
    if what == "prove":
        faults = prove(*args)
    else:
        root = pathlib.Path(args[0]).resolve()
        faults = constants(root, [pathlib.Path(script).resolve() for script in args[1:]])
    for fault in faults:
        print(fault)
    print("0 passed, 1 failed" if faults else "1 passed, 0 failed")
    return 1 if faults else 0


sys.exit(main(*sys.argv[1:]))
