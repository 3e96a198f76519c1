#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the library gives to the linker.

    test_symbols.py NM LIBRARY ARCHIVE LIST

The shared library exports the LIST's names, each with its version and no other. The ARCHIVE, of all
of its objects, defines these too; whatever else it defines is surehit_*, by src/names.h, which no
program calls a function of its own. A name that is meant to come or to go does so in the LIST."""
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from pages import verdict  # noqa: E402

VERSION = "SUREHIT_0"


def symbols(*command):
    """But for those that the compiler makes, with a dot: not by every one, nor everywhere."""
    lines = subprocess.run([*command], capture_output=True, text=True, check=True).stdout
    rows = (line.split() for line in lines.splitlines())
    return {row[2] for row in rows if len(row) == 3 and row[2] != VERSION and "." not in row[2]}


def faults_of(nm, library, archive, path):
    listed = pathlib.Path(path).read_text().split()
    if listed != sorted(set(listed)) or len(listed) < 150:
        yield f"{path} has {len(listed)} names, not each once and in order"
    given = {f"{name}@@{VERSION}" for name in listed}
    exported = symbols(nm, "-D", "--defined-only", library)
    yield from (f"exported, and not in the list: {name}" for name in sorted(exported - given))
    yield from (f"not exported: {name}" for name in sorted(given - exported))
    defined = symbols(nm, "-g", "--defined-only", archive)
    yield from (f"not in the archive: {name}" for name in sorted({*listed} - defined))
    yield from (f"src/names.h has no {name}" for name in sorted(defined - {*listed})
                if not name.startswith("surehit_"))
    yield from (f"{name} starts otherwise" for name in listed if not name.startswith("sure_"))


sys.exit(verdict([*faults_of(*sys.argv[1:])]))
