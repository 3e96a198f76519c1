#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""coarse_bounds.py BOUNDS: prints the header bounds.h for operations that are off by 2^-36, not by
2^-52. Bounds grow by 2^16, and so does SURE_SPHERE_CERTAIN, which is a multiple of D's. It is also
the square of a bound of t over the contract's cap, so the cap grows by 2^8; and it is a bound of t
over SURE_CROSSING_STEEP squared, so that grows by 2^4. A choice between numbers is one, too."""
import re
import sys

POWERS = {"SURE_T_ERROR_CAP": 8, "SURE_CROSSING_STEEP": 4}

for line in open(sys.argv[1]):
    found = re.fullmatch(r"#define (SURE_\w+) (0x[\da-f.]+p-\d+|\(.* \? .*\))\n", line)
    by = found and POWERS.get(found[1], 16 if re.search("_(BOUND|CERTAIN)$", found[1]) else None)
    print(f"#define {found[1]} ({found[2]} * 0x1p{by})\n" if by else line, end="")
