# SPDX-License-Identifier: MIT
"""The one list of shapes: SURE_EACH_SHAPE of include/surehit/shape.h."""
import re
from pathlib import Path

HEADER = Path(__file__).resolve().parents[2] / "include/surehit/shape.h"
MACRO = re.search(r"^#define SURE_EACH_SHAPE\(DO\)((?:.*\\\n)*.*)", HEADER.read_text(),
                  re.MULTILINE)

# ["plane", "disc", ...], in the order of the enumeration.
SHAPES = re.findall(r"DO\((\w+), \w+\)", MACRO.group(1))
