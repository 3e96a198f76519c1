# SPDX-License-Identifier: MIT
"""Writes a file as a C string, to standard output: embed.py NAME FILE PART... A part called x.js
goes where the file says @x.js@."""
import os
import sys


def read(path):
    with open(path, "rb") as file:
        return file.read()


name = sys.argv[1]
page = read(sys.argv[2])
for part in sys.argv[3:]:
    page = page.replace(b"@%s@" % os.path.basename(part).encode(), read(part))
print(f"extern const char {name}[];\nconst char {name}[] = {{")
for line in page.splitlines(True):
    print("".join(f"{byte - byte // 128 * 256}," for byte in line)) # as a signed char
print("0};")
