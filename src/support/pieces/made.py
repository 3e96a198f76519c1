# SPDX-License-Identifier: MIT
"""made.h: who makes records, so that none is added to another's.

    made.py ROOT OUTPUT DEPFILE FOLDERS COMPILER FLAGS ARCHITECTURE REFERENCE

The sources are all that answers depend on, in these FOLDERS (a,b,...) and, but for that of a/*,
below: a digest of their names and bytes."""
import hashlib
import pathlib
import sys

ENDINGS = {".c", ".h", ".cpp", ".def", ".jsonl"}
NAMES = ["SOURCES", "COMPILER", "FLAGS", "ARCHITECTURE", "REFERENCE"]

root, output, depfile = map(pathlib.Path, sys.argv[1:4])
found = hashlib.sha256()
read = []
for folder in sys.argv[4].split(","):
    top = root / folder.removesuffix("/*")
    below = [path for path in (top, *([] if folder.endswith("/*") else top.rglob("*")))
             if path.is_dir()]
    read += below
    for path in sorted(path for place in below for path in place.iterdir()
                       if path.suffix in ENDINGS):
        found.update(path.relative_to(root).as_posix().encode() + b"\0")
        found.update(hashlib.sha256(path.read_bytes()).digest())
        read.append(path)
lines = [f'#define MADE_{name} "{value}"\n'
         for name, value in zip(NAMES, [found.hexdigest()[:16], *sys.argv[5:]], strict=True)]
output.write_text("/* By made.py. */\n#pragma once\n\n" + "".join(lines))
depfile.write_text(f"{output}: " + " ".join(str(path).replace(" ", "\\ ") for path in read) + "\n")
