#!/usr/bin/env python3
"""Writes a scene of N small solids over a plane, the same for the same N on every machine."""
import sys


def draws():
    """Values 0..1 of a 64-bit linear congruential generator (Knuth's MMIX constants)."""
    state = 1
    while True:
        state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
        yield (state >> 33) / 2**31


def main():
    count = int(sys.argv[1])
    side = max(1.0, count ** 0.5 / 4)
    draw = draws()
    print(f"# {count} solids and a plane")
    print("A 0.25 255,255,255")
    print(f"C 0,{0.3 * side:.3f},{0.75 * side:.3f} 0,-0.42,-1 60")
    print(f"L {-side:.3f},{side:.3f},{side:.3f} 0.8")
    print("pl 0,0,0 0,1,0 150,160,150")
    for i in range(count):
        x, z = (next(draw) - 0.5) * side, (next(draw) - 0.5) * side
        size = 0.04 + 0.12 * next(draw)
        color = ",".join(str(int(60 + 190 * next(draw))) for _ in range(3))
        lean = f"{next(draw) - 0.5:.3f},1,{next(draw) - 0.5:.3f}"
        if i % 3 == 0:
            print(f"sp {x:.4f},{size / 2:.4f},{z:.4f} {size:.4f} {color}")
        else:
            name = "cy" if i % 3 == 1 else "co"
            print(f"{name} {x:.4f},{size:.4f},{z:.4f} {lean} {size:.4f} {2 * size:.4f} {color}")


main()
