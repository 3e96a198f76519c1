#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A sphere from the centre's distance to the ray, as a program on a pipe. To be judged:

    ./run judge --command docs/examples/sphere.py --shape sphere
"""
import math
import sys

for line in sys.stdin:
    ox, oy, oz, dx, dy, dz, t_min, t_max, cx, cy, cz, r = map(float.fromhex, line.split()[1:])
    answer = "miss"
    length = math.hypot(dx, dy, dz)
    if length > 0:
        to_centre = [(c - o) for c, o in ((cx, ox), (cy, oy), (cz, oz))]
        unit = (dx / length, dy / length, dz / length)
        middle = sum(m * u for m, u in zip(to_centre, unit))
        off = math.hypot(*(m - middle * u for m, u in zip(to_centre, unit)))
        if off <= r:
            half = math.sqrt((r - off) * (r + off))
            for t in ((middle - half) / length, (middle + half) / length):
                if t_min <= t <= t_max:
                    answer = "hit " + t.hex()
                    break
    print(answer)
