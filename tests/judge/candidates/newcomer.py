#!/usr/bin/env python3
"""A routine on a pipe, as someone might have it: the sphere by D/4."""
import math
import sys

for line in sys.stdin:
    ox, oy, oz, dx, dy, dz, t_min, t_max, x, y, z, r = map(float.fromhex, line.split()[1:])
    m, d = (ox - x, oy - y, oz - z), (dx, dy, dz)
    a, b = sum(v * v for v in d), sum(v * w for v, w in zip(m, d))
    quarter = b * b - a * (sum(v * v for v in m) - r * r) if a > 0 else -1
    hits = [(-b - s) / a for s in (math.sqrt(quarter), -math.sqrt(quarter))] if quarter >= 0 else []
    hits = [t for t in hits if t_min <= t <= t_max]
    print(f"hit {hits[0].hex()}" if hits else "miss", flush=True)
