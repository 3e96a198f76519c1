#!/usr/bin/env python3
"""Writes the extreme scenes into a folder: make_extreme.py FOLDER; or compares what is there with
what it would write: make_extreme.py FOLDER --check."""
import math
import pathlib
import sys

SKY = 1e30  # a lamp so far away that the way there is one vector, wherever it starts
LEAST = 5e-324


def vector(*parts):
    return ",".join(repr(part + 0.0).removesuffix(".0") for part in parts)


def angle(width, distance):
    """The field of view, in degrees, that spans a width at a distance."""
    return repr(math.degrees(2 * math.atan2(width / 2, distance)))


def next_up(x):
    return math.nextafter(x, math.inf)


def next_down(x):
    return math.nextafter(x, -math.inf)


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


GROUND = """\
# The ground is a sphere of radius 1e8. What stands on it touches it, or has its foot in it.
A 0.2 255,255,255
C 0,0.75,9 0,-0.05,-1 50
L -5,7,6 0.6
L 6,9,3 0.3
sp 0,-100000000,0 200000000 170,180,150
sp 0,1,0 2 210,80,70
cy -2.75,1,-0.5 0,1,0 1.25 2 80,130,200
co 2.75,1,0.25 0,1,0 1.75 2 220,180,80
sp 1.25,0.0625,3.5 0.25 240,240,240 refl:0.6
"""

LOW = lines("# An eye a quarter of a millionth above a ground of radius 1e8, and what is as small.",
            "A 0.2 255,255,255",
            f"C 0,{2.0 ** -22!r},{2.0 ** -18!r} 0,-0.0625,-1 50",
            f"L {vector(-2.0 ** -18, 2.0 ** -18, 2.0 ** -18)} 0.8",
            "sp 0,-100000000,0 200000000 170,180,150",
            f"sp 0,{2.0 ** -21!r},0 {2.0 ** -20!r} 210,80,70",
            f"cy {-2.0 ** -19!r},{2.0 ** -21!r},0 0,1,0 {2.0 ** -20!r} {2.0 ** -20!r} 80,130,200",
            f"co {2.0 ** -19!r},{2.0 ** -21!r},0 0,1,0 {2.0 ** -20!r} {2.0 ** -20!r} 220,180,80")

NEEDLES = lines("# Needles a millionth thick, up to a million long, some nearly along the sight.",
                "A 0.25 255,255,255",
                camera(0, 0, 10, angle(2e-5, 10)),
                "L 4,8,10 0.75",
                "pl 0,0,-1 0.25,0.25,1 90,95,105",
                "cy 0,0,0 1,2,0 1e-6 8 220,70,70",
                "cy -4e-6,0,0 -1,8,1 0.75e-6 1 70,150,230",
                "cy 5e-6,1e-6,-499990 1e-12,1e-12,-1 1.5e-6 1000000 90,200,110",
                "cy 0,-4e-6,0 1,0.03125,4 0.5e-6 6 230,200,80",
                "co -7e-6,0,0 1e-6,1,0 2e-6 2e-5 200,110,210",
                "co 7.5e-6,-1e-6,-499990.5 0,0,1 2e-6 1000000 240,150,60",
                "co 1e-6,3e-6,0 8,1,-4 1e-6 4 110,210,210")

# The camera looks along an axis: turned otherwise, so thin a coin leans by its ends' rounding.
COINS = lines("# Coins from a thousandth down to 1e-14 of their diameter, stacked and leaning.",
              "A 0.25 255,255,255",
              camera(0, 0, 7.5, 50),
              "L -3,8,6 0.75",
              "pl 0,0,0 0,0,1 120,125,130",
              "cy -2,0,0.0005 0,0,1 2 0.001 220,180,60",
              "cy -1.75,0.25,0.0010000005 0,0,1 1.5 1e-9 200,200,210",
              "cy -1.5,0.5,0.001000001000005 0,0,1 1 1e-14 190,100,60",
              "cy 1,0.25,1 1,0.25,0.5 2 1e-12 90,170,220",
              "co 2.5,-0.5,0 0,0,1 2 1e-6 210,90,120",
              "co 0,-1,1e-9 0,0,-1 1.25 2e-9 120,200,120",
              "cy 0.25,1,0.5 0,1,0.25 1.5 1e-14 230,210,120")


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


# What is inside with the camera, and outside where it must not be seen.
INSIDE = """\
A 0.2 255,255,255
C 0,0,0 0,0,-1 90
L 0.25,0.75,-0.25 0.8
{solid}
sp 0.5,-0.25,-1.5 0.5 220,80,70
sp -1,0.25,-9 2 200,40,200
pl 0,-20,0 0,1,0 40,200,40
"""

INSIDES = {
    "sphere": "sp 0,0,-1 6 90,140,190",
    "cylinder": "cy 0,0.25,-1 0.25,1,0.125 5 3 90,140,190",
    "cone": "co 0,0.5,-1 0.125,1,0 6 5 90,140,190",
}

# The camera in the very surface of the first object. It looks along -z; nothing is rounded.
ON = """\
# The camera is {where}.
A 0.25 255,255,255
C 0,0,0 0,0,-1 90
L 0.5,1.5,1 0.4
L -1,0.5,-2 0.4
{solid}
sp 0.75,0.25,-4 1.5 220,80,70
cy -1.25,0,-5 0,1,0 1 2 80,190,120
pl 0,0,-8 0.25,0,1 150,150,160
"""

ONS = {
    "plane": ("in a plane", "pl 3,0,4 0,1,0 90,140,190"),
    "plane_least": ("as near to a plane as doubles tell", f"pl 3,1,{-LEAST!r} 0,0,1 90,140,190"),
    "plane_ahead": ("in a plane across the view", "pl 3,1,0 0,0,1 90,140,190"),
    "sphere": ("on a sphere and looks into it", "sp -3,0,-4 10 90,140,190"),
    "sphere_behind": ("on a sphere and looks away from it", "sp 3,0,4 10 90,140,190"),
    "sphere_within": ("one double inside a sphere",
                      f"sp -3,0,-4 {next_up(10.0)!r} 90,140,190"),
    "sphere_without": ("one double outside a sphere",
                       f"sp -3,0,-4 {next_down(10.0)!r} 90,140,190"),
    "sphere_beside": ("on a sphere and looks along it", "sp -3,-4,0 10 90,140,190"),
    "wall": ("in a cylinder's wall and looks into it", "cy -3,0.25,-4 0,1,0 10 3 90,140,190"),
    "generator": ("in a cylinder's wall and looks along it", "cy 0,-1,-3 0,0,1 2 10 90,140,190"),
    "cap": ("in a cylinder's cap and looks along it", "cy 0,-1,-2 0,1,0 8 2 90,140,190"),
    "cap_ahead": ("in a cylinder's cap and looks into it", "cy 0.5,0,-3 0,0,1 8 6 90,140,190"),
    "rim": ("on a cylinder's rim", "cy -3,-1,-4 0,1,0 10 2 90,140,190"),
    "cone": ("in a cone's wall and looks into it", "co 0,0,-2 0,1,0 8 4 90,140,190"),
    "cone_beside": ("in a cone's wall and looks along it", "co -2,0,0 0,1,0 8 4 90,140,190"),
    "base": ("in a cone's base", "co 0,2,-1 0,1,0 6 4 90,140,190"),
    "cone_rim": ("on a cone's rim", "co -3,2,-4 0,1,0 10 4 90,140,190"),
    "apex": ("at a cone's apex and looks into it", "co 0,0,-1.5 0,0,1 4 3 90,140,190"),
    "apex_above": ("at a cone's apex, beside it", "co 0,-1.5,0 0,1,0 4 3 90,140,190"),
}

STRAIGHT = """\
# The camera looks straight {where}.
A 0.2 255,255,255
C 0,0,0 0,{y},0 80
L 3,0,3 0.7
L -4,{lamp},-1 0.3
pl 0,{floor},0 0,1,0 170,165,150
sp 0,{low},0 2 220,80,70
cy 2.5,{low},0 0,1,0 1.5 2 80,150,220
co -2.5,{low},-1 0,1,0 2 2 230,190,80
cy 0,{low},-2.5 0,0,1 1 2 120,200,120
sp -1,{low},2 1 240,240,240 refl:0.7
"""


def straight(where, sign):
    return STRAIGHT.format(where=where, y=sign, lamp=2 * sign, floor=7 * sign, low=6 * sign)


def scenes():
    for power in (5, 7, 12):
        yield f"sphere_1e{power}", sphere(10.0 ** power, 5, "seen through a tiny angle")
    for power in (5, 6, 7, 8):
        yield f"fill_1e{power}", sphere(10.0 ** power, 1.5, "fills the picture")
    for power in (7, 9):
        yield f"solids_1e{power}", solids(10.0 ** power)
    yield "ground", GROUND
    yield "ground_low", LOW
    yield "needles", NEEDLES
    yield "coins", COINS
    yield "off_1e8", lines("# All of it at 1e8 from the origin.",
                           *still(1, (1e8, -1e8, 1e8)))
    for power, name in ((300, "huge"), (-300, "tiny")):
        yield name, lines(f"# One of everything, times 2^{power}.", *still(2.0 ** power, (0, 0, 0)))
    yield "coincident", coincident(False)
    yield "ulp_apart", coincident(True)
    for name, solid in INSIDES.items():
        yield f"inside_{name}", f"# The camera in a {name}.\n" + INSIDE.format(solid=solid)
    for name, (where, solid) in ONS.items():
        yield f"on_{name}", ON.format(where=where, solid=solid)
    yield "up", straight("up", 1)
    yield "down", straight("down", -1)


def main():
    folder = pathlib.Path(sys.argv[1])
    made = {f"{name}.rt": text.rstrip("\n") + "\n" for name, text in scenes()}
    if sys.argv[2:] != ["--check"]:
        for name, text in made.items():
            (folder / name).write_text(text, encoding="ascii")
        return 0
    there = {path.name: path.read_text(encoding="ascii") for path in folder.glob("*.rt")}
    wrong = [name for name in sorted(made.keys() | there.keys())
             if made.get(name) != there.get(name)]
    for name in wrong:
        print(f"{folder / name}: not what make_extreme.py writes")
    print(f"{len(made) - len(wrong)} passed, {len(wrong)} failed")
    return 1 if wrong else 0


sys.exit(main())
