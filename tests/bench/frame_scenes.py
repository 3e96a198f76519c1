#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The scenes on which tracers are compared, the same for each: NAME.rt (surehit and Embree's
frame), NAME.pov (POV-Ray 3.7) and NAME.dat (Tachyon).

    frame_scenes.py FOLDER NAME...             S, M, L, XL
    frame_scenes.py --objects FOLDER NAME...   NAME.objects.*: no light, every object in a colour of
                                               its own, so that a picture tells which is where
    frame_scenes.py --rt FOLDER NAME...        NAME.rt alone

Solids stand on a square field. Everything is a whole number of thousandths, which every format
takes as it is, and the only functions on the way to an .rt are + - * / and sqrt: the same bytes on
every machine.
"""
import math
import os
import random
import sys

SOLIDS = {"S": 11, "M": 1000, "L": 100000, "XL": 1000000}
WIDTH, HEIGHT, FOV = 1280, 720, 55
SEED = 1
COLOURS = 48
GROUND = (150, 160, 150)
AMBIENT = 0.2

# Where eye and lights are, and what the eye looks at, of the field's side and a solid's height.
EYE, LOOKED_AT = (0, 0.4, 0.64), (0, 0, 0)
LIGHTS = [((-0.6, 0.75, 0.45), 0.5), ((0.75, 0.6, 0.1), 0.4)]


def thousandths(number):
    return round(1000 * number)


def text(whole, unit=1000):
    """A whole number of units of 1 / `unit`, in the fewest digits."""
    digits = f"{whole / unit:.4f}".rstrip("0").rstrip(".")
    return "0" if digits == "-0" else digits


def joined(vector, between=",", unit=1000):
    return between.join(text(part, unit) for part in vector)


# The scene. A solid is (shape, base or centre, top, radius, colour), in thousandths.

def side_of(name):
    """The field's: a solid has one square unit of it."""
    return math.sqrt(SOLIDS[name])


def placed(name, point):
    return tuple(thousandths(part * (side_of(name) + 4)) for part in point)


def palette(draw):
    return [tuple(int(60 + 190 * draw()) for _ in range(3)) for _ in range(COLOURS)]


def colour_of_object(index):
    """The ground is object 0."""
    number = index + 1
    return (number >> 16, number >> 8 & 255, number & 255)


def sphere(draw, x, z, radius):
    del draw
    return (x, radius, z), None


def upright(draw, x, z, radius):
    """A cylinder or cone that leans a little, its base's rim on the ground."""
    height = 600 + int(900 * draw())
    axis = [round(height * (0.7 * draw() - 0.35)), height, round(height * (0.7 * draw() - 0.35))]
    level = axis[0] * axis[0] + axis[2] * axis[2]
    base = (x, math.ceil(radius * math.sqrt(level / (level + height * height))), z)
    return base, tuple(a + b for a, b in zip(base, axis))


SHAPES = [("sp", sphere), ("cy", upright), ("co", upright)]


def solids(name):
    """By turns a sphere, a cylinder and a cone; the last ones, when they are no three, spheres."""
    count, side = SOLIDS[name], side_of(name)
    draw = random.Random(SEED).random
    colours = palette(draw)
    for i in range(count):
        # Roberts' sequence: anywhere in the field, but never close to an earlier one.
        x = thousandths(side * ((SEED + i) * 0.7548776662466927 % 1 - 0.5))
        z = thousandths(side * ((SEED + i) * 0.5698402909980532 % 1 - 0.5))
        radius = 200 + int(200 * draw())
        shape, stand = SHAPES[i % 3 if i < count - count % 3 else 0]
        base, top = stand(draw, x, z, radius)
        yield shape, base, top, radius, colours[int(COLOURS * draw())]


def coloured(name, objects):
    """The ground's colour, then the solids."""
    yield colour_of_object(0) if objects else GROUND
    for i, solid in enumerate(solids(name)):
        yield (*solid[:4], colour_of_object(i + 1)) if objects else solid


def ambient(objects):
    return 1 if objects else AMBIENT


def lights(name, objects):
    return [] if objects else [(placed(name, at), ratio) for at, ratio in LIGHTS]


class Camera:
    """It looks along -z and down, so that its right is the world's."""

    def __init__(self, name):
        self.eye = placed(name, EYE)
        at = placed(name, LOOKED_AT)
        self.view = tuple(b - a for a, b in zip(self.eye, at))
        length = math.sqrt(self.view[1] ** 2 + self.view[2] ** 2)
        self.forward = (0, self.view[1] / length, self.view[2] / length)
        self.up = (0, -self.forward[2], self.forward[1])
        self.width = 2 * math.tan(math.radians(FOV / 2))  # of what is seen at distance 1
        self.height = self.width * HEIGHT / WIDTH


# surehit's format.

def rt_solid(shape, base, top, radius, colour):
    if top is None:
        return f"sp {joined(base)} {text(2 * radius)} {joined(colour, unit=1)}"
    middle = [a + b for a, b in zip(base, top)]  # in halves of thousandths
    axis = [b - a for a, b in zip(base, top)]
    height = math.sqrt(sum(part * part for part in axis)) / 1000
    return (f"{shape} {joined(middle, unit=2000)} {joined(axis)} {text(2 * radius)} {height:.6f} "
            f"{joined(colour, unit=1)}")


def rt_lines(name, objects):
    camera = Camera(name)
    scene = coloured(name, objects)
    yield f"R {WIDTH} {HEIGHT}"
    yield f"A {ambient(objects)} 255,255,255"
    yield f"C {joined(camera.eye)} {joined(camera.view)} {FOV}"
    for position, ratio in lights(name, objects):
        yield f"L {joined(position)} {ratio} 255,255,255"
    yield f"pl 0,0,0 0,1,0 {joined(next(scene), unit=1)}"
    for solid in scene:
        yield rt_solid(*solid)


# POV-Ray's. Colours are linear, as ours.

def pov_vector(vector):
    return f"<{joined(vector)}>"


def exact(vector, between=","):
    return between.join(f"{part:.15g}" for part in vector)


def shares(colour, between):
    return between.join(f"{part / 255:.8f}" for part in colour)


def name_of(colour):
    return "c{:02x}{:02x}{:02x}".format(*colour)


def scaled(factor, vector):
    return tuple(factor * part for part in vector)


def once(declare):
    """The line that declares a colour where it is first asked for, since it is shared."""
    known = set()

    def declared(colour):
        if colour not in known:
            known.add(colour)
            yield declare(colour)
    return declared


POV_SOLIDS = {"cy": "cylinder{{{base},{top},{radius} texture{{{name}}}}}",
              "co": "cone{{{base},{radius},{top},0 texture{{{name}}}}}",
              "sp": "sphere{{{base},{radius} texture{{{name}}}}}"}


def pov_camera(camera):
    yield (f"camera{{location {pov_vector(camera.eye)} direction <{exact(camera.forward)}> "
           f"right <{exact((camera.width, 0, 0))}> "
           f"up <{exact(scaled(camera.height, camera.up))}>}}")


def pov_lines(name, objects):
    scene = coloured(name, objects)
    texture = once(lambda colour: f"#declare {name_of(colour)}=texture{{pigment{{rgb<"
                                  f"{shares(colour, ',')}>}}}}")
    yield "#version 3.7;"
    yield "global_settings{assumed_gamma 1}"
    yield (f"#default{{finish{{ambient rgb {ambient(objects)} diffuse {int(not objects)} "
           "specular 0 phong 0 reflection 0}}")
    yield from pov_camera(Camera(name))
    for position, ratio in lights(name, objects):
        yield f"light_source{{{pov_vector(position)} rgb {ratio}}}"
    ground = next(scene)
    yield from texture(ground)
    yield f"plane{{<0,1,0>,0 texture{{{name_of(ground)}}}}}"
    for shape, base, top, radius, colour in scene:
        yield from texture(colour)
        yield POV_SOLIDS[shape].format(base=pov_vector(base), top=top and pov_vector(top),
                                       radius=text(radius), name=name_of(colour))


# Tachyon's. It is left-handed: z is turned round. It has no cone, and cylinders without caps.

def dat_vector(vector):
    x, y, z = vector
    return joined((x, y, -z), " ")


def dat_point(vector):
    """Not in whole thousandths, but in units."""
    x, y, z = vector
    return f"{x:.6f} {y:.6f} {-z:.6f}"


def corners_of(name):
    """How many triangles a cone has: so that not even the one nearest to the eye is half a pixel
    off."""
    eye = [part / 1000 for part in Camera(name).eye]
    nearest = min(math.dist(eye, (0, 0, side_of(name) * z / 100)) for z in range(-50, 51))
    radius = 0.4 * WIDTH / (Camera(name).width * nearest)
    return max(6, math.ceil(math.pi / math.acos(1 - 0.5 / max(radius, 0.5))))


def circle(corners):
    return [(math.cos(2 * math.pi * i / corners), math.sin(2 * math.pi * i / corners))
            for i in range(corners)]


def unit(vector):
    length = math.sqrt(sum(part * part for part in vector))
    return tuple(part / length for part in vector)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def combined(*terms):
    return tuple(sum(factor * vector[i] for factor, vector in terms) for i in range(3))


def dat_cone(base, top, radius, name, directions):
    """Triangles with the normals of the wall; the apex has that of each one's middle."""
    foot, apex = scaled(0.001, base), scaled(0.001, top)
    axis = combined((1, apex), (-1, foot))
    height = math.sqrt(sum(part * part for part in axis))
    u = unit(cross(axis, (0, 0, 1)))
    v = unit(cross(u, axis))
    r = radius / 1000

    def around(cosine, sine):
        return combined((cosine, u), (sine, v))

    def normal(outward):
        return unit(combined((height, outward), (r / height, axis)))

    rim = [around(*direction) for direction in directions]
    for i, first in enumerate(rim):
        second = rim[(i + 1) % len(rim)]
        corners = [combined((1, foot), (r, first)), combined((1, foot), (r, second)), apex]
        normals = [normal(first), normal(second), normal(unit(combined((1, first), (1, second))))]
        yield ("STRI " + " ".join(f"V{k} {dat_point(p)}" for k, p in enumerate(corners)) + " "
               + " ".join(f"N{k} {dat_point(n)}" for k, n in enumerate(normals)) + f" {name}")


def dat_cap(centre, axis, radius, name):
    return (f"RING CENTER {dat_vector(centre)} NORMAL {dat_vector(axis)} INNER 0 "
            f"OUTER {text(radius)} {name}")


def dat_solid(shape, base, top, radius, name, directions):
    if shape == "sp":
        yield f"SPHERE CENTER {dat_vector(base)} RAD {text(radius)} {name}"
        return
    axis = tuple(b - a for a, b in zip(base, top))
    yield dat_cap(base, axis, radius, name)
    if shape == "co":
        yield from dat_cone(base, top, radius, name, directions)
        return
    yield dat_cap(top, axis, radius, name)
    yield f"FCYLINDER BASE {dat_vector(base)} APEX {dat_vector(top)} RAD {text(radius)} {name}"


def dat_frustum(camera):
    """Left, right, bottom and top at distance 1. It sends a ray through a pixel's corner, the upper
    right one, where ours goes through the middle."""
    half = camera.width / WIDTH / 2
    return (-camera.width / 2 - half, camera.width / 2 - half,
            -camera.height / 2 - half, camera.height / 2 - half)


def dat_camera(camera):
    forward = (0, camera.forward[1], -camera.forward[2])
    up = (0, camera.up[1], -camera.up[2])
    yield "CAMERA"
    yield "ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 1"
    yield f"CENTER {dat_vector(camera.eye)} VIEWDIR {exact(forward, ' ')} UPDIR {exact(up, ' ')}"
    yield f"FRUSTUM {exact(dat_frustum(camera), ' ')}"
    yield "END_CAMERA"


def dat_lines(name, objects):
    scene = coloured(name, objects)
    directions = circle(corners_of(name))

    def declare(colour):
        shown = [part + 0.5 for part in colour] if objects else colour  # it rounds down
        return (f"TEXDEF {name_of(colour)} AMBIENT {ambient(objects)} DIFFUSE "
                f"{int(not objects)} SPECULAR 0 OPACITY 1 COLOR {shares(shown, ' ')} TEXFUNC 0")

    texture = once(declare)
    yield "BEGIN_SCENE"
    yield f"RESOLUTION {WIDTH} {HEIGHT}"
    yield from dat_camera(Camera(name))
    yield "BACKGROUND 0 0 0"
    for position, ratio in lights(name, objects):
        yield f"LIGHT CENTER {dat_vector(position)} RAD 0 COLOR {ratio} {ratio} {ratio}"
    ground = next(scene)
    yield from texture(ground)
    yield f"PLANE CENTER 0 0 0 NORMAL 0 1 0 {name_of(ground)}"
    for shape, base, top, radius, colour in scene:
        yield from texture(colour)
        yield from dat_solid(shape, base, top, radius, name_of(colour), directions)
    yield "END_SCENE"


# Files.

FORMATS = {"rt": rt_lines, "pov": pov_lines, "dat": dat_lines}


def write(folder, name, ending, objects=False):
    """Whole or not at all. Returns the path."""
    path = os.path.join(folder, f"{name}{'.objects' if objects else ''}.{ending}")
    with open(path + ".part", "w", encoding="ascii", newline="\n") as file:
        for line in FORMATS[ending](name, objects):
            file.write(line + "\n")
    os.replace(path + ".part", path)
    return path


def main():
    words = sys.argv[1:]
    option = words.pop(0) if words[0].startswith("--") else None
    folder, *names = words
    for name in names:
        for ending in ["rt"] if option == "--rt" else FORMATS:
            write(folder, name, ending, option == "--objects")


if __name__ == "__main__":
    main()
