# SPDX-License-Identifier: MIT
"""Pictures by their hashes, for what `surehit regress` does not keep as golden pictures: the tiers
that nobody draws with, and a crowd. tests/golden/SCENES has a line a
picture: scene, tier, size, hash of its bytes. A picture of another hash is left in the working
folder, to be looked at.

    test_scenes.py SUREHIT CROWD.rt            compares
    test_scenes.py SUREHIT CROWD.rt --accept   renews the hashes"""
import subprocess
import sys
from pathlib import Path

TESTS = Path(__file__).resolve().parent.parent
LIST = TESTS / "golden" / "SCENES"
PROGRAM, CROWD = sys.argv[1:3]


def hash_of(data):
    """FNV-1a, 64 bits."""
    value = 0xcbf29ce484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    return f"{value:016x}"


def drawn(scene, tier, size):
    """The picture's file, and its hash."""
    picture = Path(f"got-{scene}-{tier}.ppm")
    path = CROWD if scene == "crowd" else TESTS / "scenes" / f"{scene}.rt"
    subprocess.run([PROGRAM, "render", path, "-o", picture, "--tier", tier, "--size", size,
                    "--quiet"], check=True)
    return picture, hash_of(picture.read_bytes().split(b"\n", 3)[3])


def main():
    rows, failed = [line.split() for line in LIST.read_text().splitlines()], 0
    for row in rows:
        picture, got = drawn(*row[:3])
        if got == row[3]:
            picture.unlink()
            continue
        failed += 1
        print(f"{row[0]}, tier {row[1]}: another picture; see {picture.resolve()}, and hold it "
              "against an older build's with `surehit diff`; `ninja accept-hashes` renews the "
              "hashes")
        row[3] = got
    if sys.argv[3:] == ["--accept"]:
        LIST.write_text("".join(" ".join(row) + "\n" for row in rows))
        return 0
    print(f"{len(rows) - failed} passed, {failed} failed")
    return 1 if failed or not rows else 0


sys.exit(main())
