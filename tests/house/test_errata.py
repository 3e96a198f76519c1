#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The errata of docs/errata.md that numbers can show: test_errata.py LIBSUREHIT ROOT [E05 ...].

Each `erratum` has pairs that must be equal: what the notes' printed formula comes to on the
counterexample, then surehit's answer to the same question (tier textbook). Where a comment stands
above it says how the formula is printed. Wording errata have no test."""
import ctypes
import math
import pathlib
import re
import sys

LIBRARY = ctypes.CDLL(sys.argv[1])
double, integer, size_t = ctypes.c_double, ctypes.c_int, ctypes.c_size_t
pointer, reference = ctypes.pointer, ctypes.byref
INFINITY, HIT, INVALID, PI = math.inf, 1, 2, math.pi
BASE, TOP, WALL = 1, 2, 3
TEXTBOOK = 1
FOUND = []  # (id, place, value, expected)


def erratum(name, *pairs):
    FOUND.extend((name, place, *pair) for place, pair in enumerate(pairs))


class Vec(ctypes.Structure):
    _fields_ = [(name, double) for name in "xyz"]

    def __add__(self, v):
        return Vec(self.x + v.x, self.y + v.y, self.z + v.z)

    def __rmul__(self, k):
        return Vec(k * self.x, k * self.y, k * self.z)

    def __sub__(self, v):
        return self + -1 * v

    def __matmul__(self, v):
        return self.x * v.x + self.y * v.y + self.z * v.z

    def __iter__(self):
        return iter((self.x, self.y, self.z))

    def __eq__(self, v):
        return tuple(self) == tuple(v)

    def __repr__(self):
        return f"({self.x.hex()}, {self.y.hex()}, {self.z.hex()})"


def structure(**fields):
    return type("Structure", (ctypes.Structure,), {"_fields_": list(fields.items())})


Ray = structure(origin=Vec, direction=Vec, t_min=double, t_max=double)
Hit = structure(t=double, t_error=double, part=integer)
Rotation = structure(row=Vec * 3)
Object = structure(shape=integer, numbers=double * 7)
Camera = structure(position=Vec, focal_length=double, width=double, height=double)
Light = structure(position=Vec, color=Vec, brightness=double)
Material = structure(color=Vec, specular=double, mirror=double, refract=double, shine=integer)
SurfacePoint = structure(object=size_t, point=Vec, normal=Vec, inside=integer)
Scene = structure(
    objects=ctypes.POINTER(Object), materials=ctypes.POINTER(Material), object_count=size_t,
    floats=ctypes.c_void_p, bvh=ctypes.c_void_p, caustics=ctypes.c_void_p,
    lights=ctypes.POINTER(Light), light_count=size_t, ambient=Vec, falloff=integer,
    camera=Camera, turn=Rotation, width=integer, height=integer, depth=integer)
IMPLICIT = ctypes.CFUNCTYPE(double, ctypes.c_void_p, Vec)

NOWHERE, X, UP, DOWN = Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 0, 1), Vec(0, 0, -1)
WHITE = Vec(1, 1, 1)
UNTURNED = Rotation((X, Vec(0, 1, 0), UP))


def ray_of(o, d, t_min=0, t_max=INFINITY):
    return Ray(o, d, t_min, t_max)


def shape_of(*fields):
    """A shape's struct is its fields' doubles, one behind the other."""
    numbers = [x for field in fields for x in (field if isinstance(field, Vec) else [field])]
    return (double * len(numbers))(*numbers)


def call(name, returns, *words):
    function = getattr(LIBRARY, name)
    function.restype = returns
    return function(*(double(word) if isinstance(word, float) else
                      reference(word) if isinstance(word, ctypes.Structure) and
                      not isinstance(word, Vec) else word for word in words))


def textbook(name, returns, *words):
    return call(f"sure_{name}_textbook", returns, *words)


def met(shape, ray, it):
    """What is hit, or None."""
    hit = Hit()
    return hit if textbook(f"{shape}_hit", integer, ray, it, hit) == HIT else None


def t_of(shape, o, d, *fields):
    return met(shape, ray_of(o, d), shape_of(*fields)).t


def t_and_part(shape, o, d, *fields):
    hit = met(shape, ray_of(o, d), shape_of(*fields))
    return hit.t, hit.part


def normal_of(shape, ray, it):
    return textbook(f"{shape}_normal", Vec, ray, it, met(shape, ray, it))


def pixel_ray(camera, width, height, column, row):
    return textbook("pixel_ray", Ray, camera, width, height, column, row)


def intensity(point, normal, lamp):
    return textbook("light_intensity", double, point, normal, lamp)


def from_axis(shape, centre, axis, radius, height):
    """The two ends."""
    made = (double * 7)()
    textbook(f"{shape}_from_axis", integer, centre, axis, float(radius), float(height), made)
    return Vec(*made[:3]), Vec(*made[3:6])


def world_for(view):
    world = Rotation()
    textbook("camera_rotation", integer, view, world)
    return world


def turned(view, v):
    return textbook("rotation_apply", Vec, world_for(view), v)


def over(a, b):
    """a / b as IEEE has it."""
    if b != 0:
        return a / b
    return math.nan if a == 0 or a != a else math.copysign(INFINITY, a)


def length(v):
    return math.sqrt(v @ v)


def unit(v):
    return Vec(*(over(x, length(v)) for x in v))


def reads(*values):
    """As docs/errata.md writes them."""
    return ", ".join(f"{value:.4f}" for value in values)


class Quadratic:
    """a t^2 + 2 half_b t + c = 0"""

    def __init__(self, a, half_b, c):
        self.a, self.half_b, self.c = a, half_b, c

    def quarter(self):
        return self.half_b * self.half_b - self.a * self.c

    def root(self, sign):
        quarter = self.quarter()
        root = math.sqrt(quarter) if quarter >= 0 else math.nan
        return over(-self.half_b + sign * root, self.a)

    def roots_of_squared_half_b(self):
        """(-(b/2)^2 +- sqrt(D/4)) / a: E18, E30, E50"""
        return [(-self.half_b ** 2 + sign * math.sqrt(self.quarter())) / self.a for sign in (-1, 1)]


# The pixel ray

BALL, PRINTED = shape_of(Vec(0, 0, -0.5), 0.25), ray_of(DOWN, unit(DOWN - NOWHERE))
erratum("E01", (met("sphere", PRINTED, BALL), None),
        (met("sphere", pixel_ray(Camera(NOWHERE, 1, 2, 2), 1, 1, 0, 0), BALL).t, 0.25))

PIXEL, MIDDLE = Vec(3, 0, -4), pixel_ray(Camera(NOWHERE, 4, 12, 12), 2, 1, 1, 0)
erratum("E02", (t_of("plane", NOWHERE, unit(PIXEL - NOWHERE), Vec(0, 0, -8), UP), 10),
        (MIDDLE.direction, PIXEL), (met("plane", MIDDLE, shape_of(Vec(0, 0, -8), UP)).t, 2))


# The bracket

def first_sign_change(f, ray, steps):
    """The first n with f(P_n) > 0 and f(P_n+1) < 0, or -1."""
    values = [f(None, ray.origin + n * ray.direction) for n in range(steps + 1)]
    return next((n for n in range(steps) if values[n] > 0 > values[n + 1]), -1)


def bracket(f, ray, steps):
    t = (double * 2)()
    return t[1] if textbook("bracket", integer, f, None, ray, steps, t) == HIT else None


WALL_AT_1, ALONG = IMPLICIT(lambda _, p: 1 - p.x), ray_of(NOWHERE, X, 0, 2)
erratum("E03", (first_sign_change(WALL_AT_1, ALONG, 2), -1), (bracket(WALL_AT_1, ALONG, 2), 1))

SPHERE, THROUGH = IMPLICIT(lambda _, p: p @ p - 1), ray_of(-2 * X, 4 * X, 0, 1)
erratum("E04", (first_sign_change(SPHERE, THROUGH, 1), -1), (bracket(SPHERE, THROUGH, 1), None),
        (met("sphere", THROUGH, shape_of(NOWHERE, 1)).t, 0.25))

# The Phong reflection model

V = Vec(1, 0, 1)
erratum("E05", (2 * ((UP @ V) / (UP @ UP) * UP - V), Vec(-2, 0, 0)),
        (textbook("reflect", Vec, V, UP), Vec(-1, 0, 1)))

# The nearest formula to "closer": a power of R.L without a condition.
erratum("E07", ((textbook("reflect", Vec, UP, UP) @ DOWN) ** 2, 1),
        (textbook("phong_specular", double, UP, UP, DOWN, 2), 0))

# The viewport and its pixels

erratum("E08", (reads(2 * 1 * math.tan(4 / 2)), "-4.3701"),
        (reads(textbook("viewport_extent", double, 1.0, 4.0)), "0.0698"))

# The height taken for the width, too.
EXTENT = 2 * 1 * math.tan(PI / 360 * 90)
SQUARE = Camera(NOWHERE, 1, textbook("viewport_extent", double, 1.0, 90.0) * 4 / 2,
                textbook("viewport_extent", double, 1.0, 90.0))
STEP = pixel_ray(SQUARE, 4, 2, 1, 1).direction - pixel_ray(SQUARE, 4, 2, 0, 0).direction
erratum("E75", (reads(EXTENT, EXTENT / 4, EXTENT / 2), "2.0000, 0.5000, 1.0000"),
        (reads(*STEP), "1.0000, 1.0000, 0.0000"))

# "viewport_low_left: a direction", from which P_camera is subtracted.
ASIDE = Camera(Vec(5, 0, 0), 1, 4, 4)
erratum("E09", (Vec(-1, -1, -1) - ASIDE.position, Vec(-6, -1, -1)),
        (pixel_ray(ASIDE, 2, 2, 0, 0).direction, Vec(-1, -1, -1)))

# The scalars are added to every component of the point.
S = 4 * 0.75 + 4 * 0.25
erratum("E10", (Vec(-2, -2, -1) + Vec(S, S, S), Vec(2, 2, 3)),
        (pixel_ray(Camera(NOWHERE, 1, 4, 4), 2, 2, 1, 0).direction, Vec(1, -1, -1)))


def across(width, i, screen_width):
    """The share of the width is i / (screen_width - 1): E11, E12"""
    return -width / 2 + width * over(float(i), screen_width - 1)


def direction(column, row):
    return pixel_ray(Camera(NOWHERE, 1, 3, 2), 3, 2, column, row).direction


erratum("E11", (math.isnan(across(4, 0, 1)), True),
        (pixel_ray(Camera(NOWHERE, 1, 4, 4), 1, 1, 0, 0).direction.x, 0))
erratum("E12", (across(3, 0, 3), -1.5), (across(3, 1, 3) - across(3, 0, 3), 1.5),
        (across(2, 1, 2) - across(2, 0, 2), 2), (direction(0, 0), Vec(-1, -0.5, -1)),
        (direction(1, 1) - direction(0, 0), Vec(1, 1, 0)))


# The sphere

def sphere_quadratic(rc, d, r):
    """The last line of the derivation; rc is the centre's position there, the way to it from the
    ray's origin in the corrected form."""
    return Quadratic(d @ d, -(rc @ d), rc @ rc - r * r)


BEHIND = Vec(0, 0, -3)
Q = sphere_quadratic(2 * UP, DOWN, 1)
erratum("E14", (Q.root(-1), -3), (Q.root(+1), -1), (t_of("sphere", 5 * UP, DOWN, 2 * UP, 1), 2))

# "discriminant >= 0": a hit.
Q = sphere_quadratic(BEHIND, UP, 1)
erratum("E16", (Q.quarter() >= 0, True), (Q.root(-1), -4), (Q.root(+1), -2),
        (met("sphere", ray_of(NOWHERE, UP), shape_of(BEHIND, 1)), None))
erratum("E17", (sphere_quadratic(NOWHERE, DOWN, 1).root(-1), -1),
        (t_of("sphere", NOWHERE, DOWN, NOWHERE, 1), 1))
erratum("E18", (sphere_quadratic(BEHIND, DOWN, 1).roots_of_squared_half_b(), [-10, -8]),
        (t_of("sphere", NOWHERE, DOWN, BEHIND, 1), 2))

TO_POINT, POINT = ray_of(4 * UP, 2 * DOWN), shape_of(NOWHERE, 0)
erratum("E19", (math.isnan(unit(NOWHERE - NOWHERE).z), True), (met("sphere", TO_POINT, POINT).t, 2),
        (normal_of("sphere", TO_POINT, POINT), UP))

# The plane

# ad + by + cz + d, with one d for x and for the constant.
D = -(X @ (3 * X))
erratum("E20", (X.x * D + X.y * 0 + X.z * 0 + D, -6), (t_of("plane", NOWHERE, X, 3 * X, X), 3))


def plane_t(n, rc, d):
    """N.rc / N.d: E22, E38, E41"""
    return over(n @ rc, n @ d)


INSIDE = ray_of(X, Vec(0, 1, 0), 2)
erratum("E22", (math.isnan(plane_t(UP, NOWHERE - INSIDE.origin, INSIDE.direction)), True),
        (met("plane", INSIDE, shape_of(NOWHERE, UP)).t, 2))

# N_hit = N
PLANE = shape_of(NOWHERE, 2 * UP)
erratum("E23", (Vec(*PLANE[3:]), Vec(0, 0, 2)), (normal_of("plane", ray_of(UP, DOWN), PLANE), UP))

# N_hit = N
AWAY, LAMP = Object(0, shape_of(Vec(0, 0, -2), DOWN, 0)), Light(NOWHERE, WHITE, 1)
BESIDE_LAMP = Scene(pointer(AWAY), pointer(Material(color=WHITE)), 1, lights=pointer(LAMP),
                    light_count=1, camera=Camera(NOWHERE, 1, 1, 1), turn=UNTURNED, width=1,
                    height=1)
erratum("E24", (intensity(Vec(0, 0, -2), Vec(*AWAY.numbers[3:6]), NOWHERE), 0),
        (call("sure_backward_pixel", Vec, BESIDE_LAMP, TEXTBOOK, 0, 0), WHITE))


# The cylinder

def wall_quadratic(rc, d, n, r):
    """The last line, for the axis N as it is given, rc from the ray's origin to a point of the
    axis: E25"""
    return Quadratic(d @ d - (d @ n) ** 2, -(rc @ d - (d @ n) * (rc @ n)),
                     rc @ rc - (rc @ n) ** 2 - r * r)


def wall_t(o, d, base, top):
    return t_of("cylinder_wall", o, d, base, top, 1)


erratum("E14", (wall_quadratic(X, X, UP, 1).root(-1), 0), (wall_t(-3 * X, X, X, Vec(1, 0, 1)), 3))
erratum("E25", (wall_quadratic(Vec(3, 0, -1), X, 2 * UP, 1).root(-1), 1),
        (wall_t(Vec(-3, 0, 1), X, NOWHERE, 2 * UP), 2))

# ... + (rc.N)^2 - r^2
C = Vec(3, 0, 1)
Q = wall_quadratic(C, X, UP, 1)
Q.c = C @ C + (C @ UP) ** 2 - 1
erratum("E26", (Q.quarter(), -1), (wall_t(NOWHERE, X, C, Vec(3, 0, 2)), 2))


def e28(rp, d, rc, n, r):
    """- (rp.N)^2 - 2 (rp.N)(d.N) + (d.N)^2 + ..., rc the centre's position."""
    c = (rp @ rp - 2 * (rc @ rp) + rc @ rc - (rp @ n) ** 2 - 2 * (rp @ n) * (d @ n) + (d @ n) ** 2
         + 2 * (rp @ n) * (rc @ n) - (rc @ n) ** 2 - r * r)
    return Quadratic(d @ d, rp @ d - rc @ d + (d @ n) * (rc @ n), c)


erratum("E28", (e28(Vec(-3, 0, 1), Vec(1, 0, 1), NOWHERE, UP, 1).quarter(), -10),
        (wall_t(Vec(-3, 0, 1), Vec(1, 0, 1), NOWHERE, UP), 2))

FROM_ABOVE = Vec(0.5, 0, 5)
erratum("E29", (math.isnan(wall_quadratic(NOWHERE - FROM_ABOVE, DOWN, UP, 1).root(-1)), True),
        (t_and_part("cylinder", FROM_ABOVE, DOWN, NOWHERE, 2 * UP, 1), (3, TOP)))
erratum("E30", (wall_quadratic(3 * X, X, UP, 1).roots_of_squared_half_b(), [-10, -8]),
        (wall_t(-3 * X, X, NOWHERE, UP), 2))

# The left side of sqrt((x_n^2 + y_n^2 + z_n^2) t^2) = -h/2.
erratum("E31", (math.sqrt((UP @ UP) * -1 * -1), 1),
        (from_axis("cylinder", NOWHERE, UP, 1, 2)[0], DOWN))

# d_n read as -N.C, the constant d of the plane through C.
N = Vec(1, 2, 2)
D = 0 - N @ NOWHERE
T = 6 / 2 * math.sqrt(1 / (D * D + N.y ** 2 + N.z ** 2))
erratum("E76", (reads(T, T * D, T * N.y, T * N.z), "1.0607, 0.0000, 2.1213, 2.1213"),
        (from_axis("cylinder", NOWHERE, N, 1, 6)[1], N),
        (from_axis("cone", NOWHERE, N, 1, 6)[1], N))


def angle(u, v):
    return math.acos(u @ v / (length(u) * length(v)))


# pi/2 <= alpha < pi and 0 < beta <= pi/2: a right angle or more, and not along N.
ALPHA, BETA = angle(UP, UP - 2 * UP), angle(UP, UP - NOWHERE)
erratum("E32", (PI / 2 <= ALPHA < PI and 0 < BETA <= PI / 2, False),
        (textbook("cylinder_height", integer, UP, shape_of(NOWHERE, 2 * UP, 0)), 1))


def wall_normal(shape, p_hit, *fields):
    return textbook(f"{shape}_wall_normal", Vec, p_hit, shape_of(*fields))


N = unit(X - DOWN)
erratum("E33", (reads(N.x, N.z), "0.7071, 0.7071"), (wall_normal("cylinder", X, DOWN, UP, 1), X))
N = unit(X - (NOWHERE + (UP @ (UP - NOWHERE)) / (UP @ UP) * UP))
erratum("E34", (reads(N.x, N.z), "0.7071, -0.7071"), (wall_normal("cylinder", X, DOWN, UP, 1), X))

# C + h/2 sqrt(1/x_n^2 + y_n^2 + z_n^2) N
N = Vec(1, 2, 2)
erratum("E35", (6 / 2 * math.sqrt(1 / N.x ** 2 + N.y ** 2 + N.z ** 2) * N, Vec(9, 18, 18)),
        (from_axis("cylinder", NOWHERE, N, 1, 6)[1], N))

# N.rQ / N.rcy, the only symbol like it being rc
O = 5 * UP
erratum("E36", (UP @ (UP - O) / (UP @ (NOWHERE - O)), 0.8),
        (t_of("cylinder", O, DOWN, DOWN, UP, 1), 4))
erratum("E38", (math.isnan(plane_t(UP, 3 * X, X)), True),
        (t_of("disc", -3 * X, X, NOWHERE, UP, 1), 2))

# N_hit = N
FROM_BELOW, CYLINDER = ray_of(5 * DOWN, UP), shape_of(NOWHERE, 2 * UP, 1)
erratum("E39", (unit(Vec(*CYLINDER[3:6]) - NOWHERE), UP),
        (met("cylinder", FROM_BELOW, CYLINDER).part, BASE),
        (normal_of("cylinder", FROM_BELOW, CYLINDER), DOWN))

# The nearer of the circles that are hit.
O, D = Vec(-3, 0, 3), Vec(1, 0, -1)
CIRCLES = [(end, plane_t(2 * UP, end - O, D)) for end in (2 * UP, NOWHERE)]
erratum("E41", (min(t for end, t in CIRCLES if length(O + t * D - end) <= 1), 3),
        (t_and_part("cylinder", O, D, NOWHERE, 2 * UP, 1), (2, WALL)))

# The lesser of t_top and t_bottom.
CIRCLES = [plane_t(2 * UP, end - UP, UP) for end in (2 * UP, NOWHERE)]
erratum("E77", (CIRCLES, [1, -1]), (min(CIRCLES), -1),
        (t_and_part("cylinder", UP, UP, NOWHERE, 2 * UP, 1), (1, TOP)))

# The cone: base at the origin, apex at (0,0,1), radius 1, so that cos^2 is 1/2

APEX, RIGHT_ANGLED, COS2 = UP, (NOWHERE, UP, 1), 0.5
BESIDE, INWARD, ABOVE = Vec(3, 0, 0), Vec(-1, 0, 0), Vec(0.5, 0, 10)
FROM_BESIDE = (t_of("cone", BESIDE, INWARD, *RIGHT_ANGLED), 2)


def cone_quadratic(rq, d):
    """The last line, for |N| = 1 and rq from the ray's origin to the apex."""
    return Quadratic((d @ UP) ** 2 - (d @ d) * COS2, -((rq @ UP) * (UP @ d) - (rq @ d) * COS2),
                     (rq @ UP) ** 2 - (rq @ rq) * COS2)


# The nearer root, dropped when it is on the other nappe.
Q = cone_quadratic(APEX - ABOVE, DOWN)
T = min(Q.root(-1), Q.root(+1))
erratum("E43", (Q.root(-1), 8.5), (UP @ (APEX - ABOVE) + T * -(UP @ DOWN) >= 0, False),
        (t_of("cone", ABOVE, DOWN, *RIGHT_ANGLED), 9.5))

# -2 (rq.N) ray(t), where a number is wanted.
erratum("E44", (-2 * (APEX @ UP) * X, Vec(-2, 0, 0)), (-2 * (APEX @ UP) * (X @ UP), 0), FROM_BESIDE)


def expanded(rp, d, rq, square_term, cross_term):
    """The expanded equation, rq the apex's position; square_term stands for the constant part of
    (ray(t).N)^2, cross_term for that of 2 rq.ray(t): E45 to E47"""
    q_n, p_n, d_n = rq @ UP, rp @ UP, d @ UP
    return Quadratic(d_n ** 2 - (d @ d) * COS2,
                     -q_n * d_n + p_n * d_n + (rq @ d - rp @ d) * COS2,
                     q_n ** 2 - 2 * q_n * p_n + square_term
                     - (rq @ rq - cross_term + rp @ rp) * COS2)


# (rq.N)^2 - 2 (rq.N) ray.N + ray^2 (N.N) - {rq.rq - 2 rq.ray + ray^2} cos^2
Q = expanded(BESIDE, INWARD, APEX, BESIDE @ BESIDE, 2 * (APEX @ BESIDE))
Q.a += INWARD @ INWARD - (INWARD @ UP) ** 2
Q.half_b += BESIDE @ INWARD - (BESIDE @ UP) * (INWARD @ UP)
erratum("E45", (Q.quarter(), -0.25), FROM_BESIDE)
Q = expanded(BESIDE, INWARD, APEX, BESIDE @ BESIDE, 2 * (APEX @ BESIDE))
erratum("E46", (reads(Q.root(+1), Q.root(-1)), "-1.3589, 7.3589"), FROM_BESIDE)
O = Vec(3, 0, 1)
erratum("E47", (expanded(O, INWARD, 2 * UP, (O @ UP) ** 2, 2 * (O @ UP)).quarter(), -0.25),
        (t_of("cone", O, INWARD, NOWHERE, 2 * UP, 2), 2))

# All terms with r_p struck out, rq still the apex's position.
Q = cone_quadratic(APEX, INWARD)
erratum("E48", ((Q.root(+1), Q.root(-1)), (-1, 1)), FROM_BESIDE)

# (-1 - 2 {...} +- sqrt(D)) / 2a
Q = cone_quadratic(APEX - BESIDE, INWARD)
erratum("E49", *(((-1 - 2 * -Q.half_b + sign * 2 * math.sqrt(Q.quarter())) / (2 * Q.a), wrong)
                 for sign, wrong in ((+1, -3), (-1, -1))), FROM_BESIDE)
erratum("E50", (Q.roots_of_squared_half_b(), [5.5, 3.5]), FROM_BESIDE)
erratum("E51", (Q.root(-1), 4), FROM_BESIDE)

O, ALONG_WALL = Vec(-1, 0, 1), Vec(1, 0, -1)
erratum("E52", (math.isnan(cone_quadratic(APEX - O, ALONG_WALL).root(+1)), True),
        (t_of("cone", O, ALONG_WALL, *RIGHT_ANGLED), 0.5))

# |PQ| <= sqrt(r^2 + h^2) and rq.PQ >= 0
for P, printed, right in ((Vec(0.5, 0, 1.5), True, 0), (Vec(0.5, 0, 0.5), False, 1)):
    SAID = length(APEX - P) <= math.sqrt(1 + 1) and (APEX - ABOVE) @ (APEX - P) >= 0
    erratum("E53", (SAID, printed),
            (textbook("cone_height", integer, P, shape_of(*RIGHT_ANGLED)), right))

# Height 4, radius 3, so that the slant is 5 and the cosine 4/5

TIP, HALF_WAY, COSINE = 4 * UP, Vec(1.5, 0, 2), 0.8
HALF_WAY_NORMAL = (wall_normal("cone", HALF_WAY, NOWHERE, TIP, 3), Vec(0.8, 0, 0.6))

# {(rq - ray).N}^2 = |rq - ray|^2 cos^2 at the depth 2, cos = 3/5, the angle between base and wall.
erratum("E78", (reads(5 - math.sqrt(2 ** 2 / 0.6 ** 2 - 2 ** 2)), "2.3333"),
        (t_of("cone", Vec(5, 0, 2), INWARD, NOWHERE, TIP, 3), 3.5))

# Q + |PQ| / cos N, for both
ABOVE_TIP = TIP + length(TIP - HALF_WAY) / COSINE * UP
N = unit(HALF_WAY - ABOVE_TIP)
erratum("E54", (unit(ABOVE_TIP), UP), HALF_WAY_NORMAL)
erratum("E55", (reads(N.x, N.z), "0.2809, -0.9597"), HALF_WAY_NORMAL)
erratum("E56", (unit(HALF_WAY - NOWHERE), Vec(0.6, 0, 0.8)), HALF_WAY_NORMAL)

# P - S with S = Q - |PQ| / cos N, at the apex
S = TIP - length(TIP - TIP) / COSINE * UP
erratum("E57", (math.isnan(unit(TIP - S).z), True), (wall_normal("cone", TIP, NOWHERE, TIP, 3), UP))

# The first coordinate of B, d_c - h/2 sqrt(1/d_n^2 + n^2 + z_n^2) d_n, n read as |N|.
N = Vec(1, 2, 2)
erratum("E59", (reads(0 - 6 / 2 * math.sqrt(1 / N.x ** 2 + N @ N + N.z ** 2) * N.x), "-11.2250"),
        (from_axis("cone", NOWHERE, N, 1, 6)[0], -1 * N))

O = Vec(0.25, 0, -5)
erratum("E60", (UP @ (NOWHERE - Vec(0.25, 0, 0)) / (UP @ UP), 0),
        (t_of("cone", O, UP, *RIGHT_ANGLED), 5))

# N_hit = N
erratum("E61", (unit(APEX - NOWHERE), UP), (t_and_part("cone", O, UP, *RIGHT_ANGLED), (5, BASE)),
        (normal_of("cone", ray_of(O, UP), shape_of(*RIGHT_ANGLED)), DOWN))
erratum("E62", (cone_quadratic(APEX - O, UP).root(-1), 5.75),
        (t_of("cone", O, UP, *RIGHT_ANGLED), 5))

# The light

OVERHEAD, BELOW = 2 * UP, 2 * DOWN


def cosine(p_hit, n, p_light):
    """Of the angle between light_direction = P_hit - P_light and N: E63 to E65"""
    return unit(p_hit - p_light) @ n


erratum("E63", (cosine(NOWHERE, UP, OVERHEAD), -1), (intensity(NOWHERE, UP, OVERHEAD), 1),
        (cosine(NOWHERE, UP, BELOW), 1), (intensity(NOWHERE, UP, BELOW), 0))
# The angle itself, after the sign is mended.
erratum("E64", (math.acos(-cosine(NOWHERE, UP, OVERHEAD)), 0),
        (intensity(NOWHERE, UP, OVERHEAD), 1))
# The cosine without a lower end, after the sign is mended.
erratum("E65", (-cosine(NOWHERE, UP, BELOW), -1), (intensity(NOWHERE, UP, BELOW), 0))
erratum("E66", (over(1 * 1, 4 * PI * 0 * 0), INFINITY),
        (textbook("light_color", Vec, LAMP, NOWHERE, 1), NOWHERE),
        (intensity(NOWHERE, UP, NOWHERE), 0))

# "without hitting other objects"
ALONE = Scene(objects=pointer(Object(2, shape_of(NOWHERE, 1, 0, 0, 0))), object_count=1)
WITHIN = SurfacePoint(0, DOWN, UP, 1)
erratum("E67", (len([i for i in range(ALONE.object_count) if i != WITHIN.object]), 0),
        (call("sure_shadow_reaches", integer, ALONE, TEXTBOOK, WITHIN, 5 * UP), 0))

# A line without an end.
BALL_BEYOND = shape_of(5 * UP, 1)
FLOOR_AND_BALL = Scene((Object * 2)(Object(0, shape_of(NOWHERE, UP, 0)),
                                    Object(2, shape_of(5 * UP, 1, 0, 0, 0))), object_count=2)
erratum("E79", (met("sphere", ray_of(NOWHERE, OVERHEAD), BALL_BEYOND).t, 2),
        (call("sure_shadow_reaches", integer, FLOOR_AND_BALL, TEXTBOOK,
              SurfacePoint(0, NOWHERE, UP, 0), OVERHEAD), 1))

# The camera

# R_z by 3 pi / 2
VIEW, COS, SIN = Vec(0, 1, 0), 0, -1
erratum("E68", (Vec(COS * VIEW.x - SIN * VIEW.y, SIN * VIEW.x + COS * VIEW.y, VIEW.z), X),
        (turned(VIEW, VIEW), DOWN))

# Case 7, y < 0 and z < 0: cos = y / sqrt(y^2 + z^2), sin = sqrt(1 - cos^2).
COS = -3 / math.sqrt(-3 * -3 + -4 * -4)
WORLD = world_for(Vec(0, -3, -4))
erratum("E69", ((COS, math.sqrt(1 - COS * COS)), (-0.6, 0.8)), (WORLD.row[1], Vec(0, 0.8, -0.6)),
        (WORLD.row[2], Vec(0, 0.6, 0.8)))

# The sine of case 7 with the cosine mended.
Y = -2.0 ** -30
COS = 1 / math.sqrt(Y * Y + 1)
erratum("E70", (math.sqrt(1 - COS * COS), 0), (world_for(Vec(0, Y, -1)).row[2].y, -Y))

# Where case 7, y > 0 and z > 0, takes the world's up, (0, 1, 0): -cos, -sin, the cosine mended.
LONG = math.sqrt(3 * 3 + 4 * 4)
erratum("E71", (Vec(0, -4 / LONG, -3 / LONG), Vec(0, -0.8, -0.6)),
        (turned(Vec(0, 3, 4), Vec(0, 1, 0)), Vec(0, 0.8, -0.6)))

# Case 8, x > 0 and z < 0: cos = z / sqrt(x^2 + z^2).
erratum("E72", (-4 / LONG, -0.8), (world_for(Vec(3, 0, -4)).row[0], Vec(0.8, 0, 0.6)))
# Case 8, x > 0 and z > 0: cos, -sin.
erratum("E73", ((4 / LONG, -3 / LONG), (0.8, -0.6)),
        (world_for(Vec(3, 0, 4)).row[0], Vec(-0.8, 0, 0.6)))

# Case 7 is the nearest for x != 0: a turn about x alone, which leaves x as it was.
WORLD = world_for(Vec(3, 12, -4))
erratum("E74", (Vec(3, 12, -4).x, 3), (WORLD.row[0], Vec(0.8, 0, 0.6)),
        ((WORLD.row[1].y, WORLD.row[2].y), (5 / 13, -12 / 13)))

# The cosine of cases 7 and 8.
erratum("E80", (math.isnan(over(0, math.sqrt(0 * 0 + 0 * 0))), True),
        (textbook("camera_rotation", integer, NOWHERE, Rotation()), INVALID))


# The sections of the page, by kind.
SECTIONS = {"formula": "Wrong formulas", "misprint": "Misprints that change the meaning",
            "convention": "Conventions", "struck out": "Struck out", "rounding": "Rounding",
            "gap": "Gaps: conditions left out", "wording": "Wording"}


def differences(errata):
    """What the page's table, its sections and this file say differently of one another."""
    page = pathlib.Path(errata).read_text(encoding="utf-8")
    rows = dict(re.findall(r"^\| (E\d+) \|[^|]*\|[^|]*\| ([\w ]+) \|", page, re.M))
    expected = {name for name, kind in rows.items() if kind != "wording"}
    found = [f"{name}: in one of page and tests alone"
             for name in sorted(expected ^ {name for name, *_ in FOUND})]
    sections = {name: part.splitlines()[0] for part in page.split("\n## ")[1:]
                for name in re.findall(r"^(?:- )?\*\*(E\d+)", part, re.M)}
    return found + [f"{name}: is not under {SECTIONS.get(kind)}" for name, kind in rows.items()
                    if sections.get(name) != SECTIONS.get(kind, "")]


faults = differences(pathlib.Path(sys.argv[2]) / "docs/errata.md")
faults += [f"{name}, answer {place}: {value!r}, expected {expected!r}"
           for name, place, value, expected in FOUND
           if value != expected and (not sys.argv[3:] or name in sys.argv[3:])]
print(*faults, "0 passed, 1 failed" if faults else "1 passed, 0 failed", sep="\n")
sys.exit(1 if faults else 0)
