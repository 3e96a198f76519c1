#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes those of the extreme scenes whose numbers are computed into a folder: make_extreme.py
FOLDER; or compares what is there with what it would write: make_extreme.py FOLDER --check."""
import math
import pathlib
import sys

SKY = 1e30  # a lamp so far away that the way there is one vector, wherever it starts


def vector(*parts):
    return ",".join(repr(part + 0.0).removesuffix(".0") for part in parts)


def angle(width, distance):
    """The field of view, in degrees, that spans a width at a distance."""
    return repr(math.degrees(2 * math.atan2(width / 2, distance)))


def next_up(x):
    return math.nextafter(x, math.inf)


def lines(*parts):
    return "\n".join(parts)


def camera(x, y, z, fov=60, view="0,0,-1"):
    return f"C {vector(x, y, z)} {view} {fov}"


# One of everything on a floor; seen from 0,3,10.
STILL = [
    ("L", (-6, 8, 6), "0.7 255,244,226"), ("L", (7, 5, 4), "0.4 190,208,255"),
    ("pl", (0, 0, 0), (0, 1, 0), (), "205,200,190 refl:0.1"),
    ("sp", (-2.5, 1.25, 0), None, (2.5,), "206,72,58 spec:0.6 shine:60"),
    ("sp", (0.75, 0.625, 2.5), None, (1.25,), "240,240,240 refl:0.7 spec:0.8 shine:100"),
    ("cy", (1, 1.5, -1.5), (0, 1, 0), (1.75, 3), "64,132,176"),
    ("cy", (-0.75, 0.5, 3), (1, 0.25, 0.5), (0.75, 1.5), "112,168,96"),
    ("co", (4, 1.5, -1), (0, 1, 0), (2.75, 3), "158,110,178"),
    ("co", (-3.5, 0.75, 3.25), (0, 1, 0.125), (1.5, 1.5), "224,140,64"),
]


def still(factor, by):
    """That scene times a power of two and then moved, camera and all."""
    def at(point):
        return vector(*(factor * x + step for x, step in zip(point, by)))
    yield "A 0.18 255,255,255"
    yield f"C {at((0, 3, 10))} 0,-0.25,-1 58"
    for kind, position, *rest in STILL:
        if kind == "L":
            yield f"L {at(position)} {rest[0]}"
            continue
        axis, sizes, colour = rest
        words = [kind, at(position)] + ([vector(*axis)] if axis else [])
        yield " ".join(words + [vector(factor * size) for size in sizes] + [colour])


def sphere(distance, width, what):
    """A unit sphere, `width` of whose surroundings spans the picture."""
    return lines(f"# A unit sphere at {distance:.0e}, {what}.",
                 "A 0.2 255,255,255",
                 camera(0, 0, distance, angle(width, distance)),
                 f"L {vector(0.3 * distance, 0.4 * distance, distance)} 0.8",
                 "sp 0,0,0 2 214,88,66")


def solids(distance):
    return lines(f"# A cylinder, a cone and a sphere at {distance:.0e}, seen through a tiny angle.",
                 "A 0.2 255,255,255",
                 camera(0, 0, distance, angle(4, distance)),
                 f"L {vector(0.3 * distance, 0.4 * distance, distance)} 0.8",
                 "cy -1.125,0,0 0.25,1,0.5 0.75 1.5 80,140,210",
                 "co 0,0,0 0.125,1,-0.25 1 1.75 130,190,90",
                 "sp 1.125,0.125,0 1 210,90,70",
                 "pl 0,0,-3 0,0.5,1 190,180,170")


def coincident(apart):
    """Pairs of surfaces at one place, or one double apart; red ones are never to be seen."""
    up = next_up if apart else lambda x: x
    pairs = [(f"pl 0,{vector(up(-2.0))},0 0,1,0 90,190,120", "pl 0,-2,0 0,1,0 200,40,40"),
             (f"sp -2.5,0,-8 {vector(up(2.5))} 80,150,220", "sp -2.5,0,-8 2.5 200,40,40"),
             (f"cy 0.5,-1.5,-6 0,1,0 {vector(up(1.25))} {vector(up(1.0))} 230,190,80",
              "cy 0.5,-1.5,-6 0,1,0 1.25 1 200,40,40"),
             (f"co 2.5,-1,-7 0,1,0 {vector(up(2.0))} 2 180,120,210",
              "co 2.5,-1,-7 0,1,0 2 2 200,40,40"),
             (f"pl 0,0,{vector(up(-12.0))} 0,0,1 200,200,190", "pl 0,0,-12 0,0,1 200,40,40")]
    head = ("# Pairs one double apart: the second of each is nearer, or around the first. None red."
            if apart else "# Pairs at one place: the first of each is seen. None is red.")
    # The camera stands at 0,0,0: what is written is what is seen.
    return lines(head,
                 "A 0.25 255,255,255",
                 camera(0, 0, 0, 64),
                 f"L {vector(0, SKY, 0.5 * SKY)} 0.7",
                 *(line for pair in pairs for line in (reversed(pair) if apart else pair)))


def scenes():
    for power in (5, 7, 12):
        yield f"sphere_1e{power}", sphere(10.0 ** power, 5, "seen through a tiny angle")
    for power in (5, 6, 7, 8):
        yield f"fill_1e{power}", sphere(10.0 ** power, 1.5, "fills the picture")
    for power in (7, 9):
        yield f"solids_1e{power}", solids(10.0 ** power)
    yield "off_1e8", lines("# All of it at 1e8 from the origin.",
                           *still(1, (1e8, -1e8, 1e8)))
    for power, name in ((300, "huge"), (-300, "tiny")):
        yield name, lines(f"# One of everything, times 2^{power}.", *still(2.0 ** power, (0, 0, 0)))
    yield "coincident", coincident(False)
    yield "ulp_apart", coincident(True)


def main():
    folder = pathlib.Path(sys.argv[1])
    made = {f"{name}.rt": text.rstrip("\n") + "\n" for name, text in scenes()}
    if sys.argv[2:] != ["--check"]:
        for name, text in made.items():
            (folder / name).write_text(text, encoding="ascii")
        return 0
    wrong = [name for name, text in made.items()
             if not (folder / name).is_file() or (folder / name).read_text() != text]
    for name in wrong:
        print(f"{folder / name}: not what make_extreme.py writes")
    print(f"{len(made) - len(wrong)} passed, {len(wrong)} failed")
    return 1 if wrong else 0


sys.exit(main())
