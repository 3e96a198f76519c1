#!/usr/bin/env python3
"""coarse_bounds.py BOUNDS: prints the header bounds.h for operations that are off by 2^-36, not by
2^-52. Bounds and what is measured by them grow by 2^16; a bound of t over the contract's cap, of which
SURE_SPHERE_CERTAIN is the square, by 2^8; and so does the cap, and by 2^4 the inverse of the slope
beyond which it is kept, which is squared there."""
import re
import sys

POWERS = {"SURE_T_ERROR_CAP": 8, "SURE_CROSSING_STEEP": 4}

for line in open(sys.argv[1]):
    found = re.fullmatch(r"#define (SURE_\w+) (0x[\da-f.]+p-\d+)\n", line)
    by = found and POWERS.get(found[1], 16 if re.search("_(BOUND|CERTAIN)$", found[1]) else None)
    print(f"#define {found[1]} ({found[2]} * 0x1p{by})\n" if by else line, end="")
