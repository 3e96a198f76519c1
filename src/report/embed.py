"""Writes the page with its scripts in it as a C string: embed.py PAGE SCRIPT..., to standard
output."""
import sys


def read(path):
    with open(path, "rb") as file:
        return file.read()


page = read(sys.argv[1]).replace(b"@SCRIPT@", b"".join(map(read, sys.argv[2:])))
print("extern const char report_page[];\nconst char report_page[] = {")
for line in page.splitlines(True):
    print("".join(f"{byte - byte // 128 * 256}," for byte in line)) # as a signed char
print("0};")
