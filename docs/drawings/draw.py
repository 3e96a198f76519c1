#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the drawings beside it, which the pages show: draw.py [FOLDER]. What is drawn is computed:
points of contact and crossings are where the formulas put them."""
import pathlib
import sys

sys.dont_write_bytecode = True
from ideas import chord, nappe, parts, stages  # noqa: E402
from shapes import box, cone, cylinder, disc, plane, sphere  # noqa: E402

DRAWINGS = [plane, disc, sphere, cylinder, cone, box, chord, nappe, parts, stages]

if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    for drawing in DRAWINGS:
        (folder / f"{drawing.__name__}.svg").write_text(drawing().svg(), encoding="utf-8")
