"""Writes a file as a C string, with scripts in it: embed.py NAME FILE SCRIPT..., to standard
output."""
import sys


def read(path):
    with open(path, "rb") as file:
        return file.read()


name = sys.argv[1]
page = read(sys.argv[2]).replace(b"@SCRIPT@", b"".join(map(read, sys.argv[3:])))
print(f"extern const char {name}[];\nconst char {name}[] = {{")
for line in page.splitlines(True):
    print("".join(f"{byte - byte // 128 * 256}," for byte in line)) # as a signed char
print("0};")
