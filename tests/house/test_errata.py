#!/usr/bin/env python3
"""The errata of docs/errata.md that numbers can show: test_errata.py LIBSUREHIT ROOT [E05 ...].

A function a test of an id. It yields pairs that must be equal: what the notes' printed formula
comes to on the counterexample, then surehit's answer to the same question (tier textbook). Where a
docstring stands it says how the formula is printed. Wording errata have no test."""
import ctypes
import math
import pathlib
import re
import sys

LIBRARY = ctypes.CDLL(sys.argv[1])
double = ctypes.c_double
INFINITY, HIT, PI = math.inf, 1, math.pi
BASE, TOP, WALL = 1, 2, 3


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


class Hit(ctypes.Structure):
    _fields_ = [("t", double), ("t_error", double), ("part", ctypes.c_int)]


class Object(ctypes.Structure):
    _fields_ = [("shape", ctypes.c_int), ("numbers", double * 7)]


class Camera(ctypes.Structure):
    _fields_ = [("position", Vec), ("focal_length", double), ("width", double), ("height", double)]


class Light(ctypes.Structure):
    _fields_ = [("position", Vec), ("color", Vec), ("brightness", double)]


class Material(ctypes.Structure):
    _fields_ = [("color", Vec), ("specular", double), ("mirror", double), ("refract", double),
                ("shine", ctypes.c_int)]


class Scene(ctypes.Structure):
    _fields_ = [("objects", ctypes.POINTER(Object)), ("materials", ctypes.POINTER(Material)),
                ("object_count", ctypes.c_size_t), ("bvh", ctypes.c_void_p),
                ("caustics", ctypes.c_void_p), ("lights", ctypes.POINTER(Light)),
                ("light_count", ctypes.c_size_t), ("ambient", Vec), ("falloff", ctypes.c_int),
                ("camera", Camera), ("width", ctypes.c_int), ("height", ctypes.c_int),
                ("depth", ctypes.c_int)]


class SurfacePoint(ctypes.Structure):
    _fields_ = [("object", ctypes.c_size_t), ("point", Vec), ("normal", Vec),
                ("inside", ctypes.c_int)]


class Ray(ctypes.Structure):
    _fields_ = [("origin", Vec), ("direction", Vec), ("t_min", double), ("t_max", double)]


class Rotation(ctypes.Structure):
    _fields_ = [("row", Vec * 3)]


NOWHERE, X, UP, DOWN = Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 0, 1), Vec(0, 0, -1)
WHITE = Vec(1, 1, 1)
TEXTBOOK = 1


def ray_of(o, d, t_min=0, t_max=INFINITY):
    return Ray(o, d, t_min, t_max)


def shape_of(*fields):
    """A shape's struct is its fields' doubles, one behind the other."""
    numbers = [x for field in fields for x in (field if isinstance(field, Vec) else [field])]
    return (double * len(numbers))(*numbers)


def call(name, returns, *words):
    function = getattr(LIBRARY, name)
    function.restype = returns
    return function(*(double(word) if isinstance(word, float) else word for word in words))


def textbook(name, returns, *words):
    return call(f"sure_{name}_textbook", returns, *words)


def met(shape, ray, it):
    """What is hit, or None."""
    hit = Hit()
    status = textbook(f"{shape}_hit", ctypes.c_int, ctypes.byref(ray), it, ctypes.byref(hit))
    return hit if status == HIT else None


def normal_of(shape, ray, it):
    hit = met(shape, ray, it)
    return textbook(f"{shape}_normal", Vec, ctypes.byref(ray), it, ctypes.byref(hit))


def pixel_ray(camera, width, height, column, row):
    return textbook("pixel_ray", Ray, ctypes.byref(camera), width, height, column, row)


def intensity(point, normal, lamp):
    return textbook("light_intensity", double, point, normal, lamp)


def from_axis(shape, centre, axis, radius, height):
    """The two ends."""
    made = (double * 7)()
    textbook(f"{shape}_from_axis", ctypes.c_int, centre, axis, float(radius), float(height), made)
    return Vec(*made[:3]), Vec(*made[3:6])


def world_for(view):
    world = Rotation()
    textbook("camera_rotation", ctypes.c_int, view, ctypes.byref(world))
    return world


def turned(world, v):
    return textbook("rotation_apply", Vec, ctypes.byref(world), v)


def over(a, b):
    """a / b as IEEE has it."""
    if b != 0:
        return a / b
    return math.nan if a == 0 or a != a else math.copysign(INFINITY, a)


def root_of(x):
    return math.sqrt(x) if x >= 0 else math.nan


def length(v):
    return math.sqrt(v @ v)


def unit(v):
    return Vec(*(over(x, length(v)) for x in v))


def reads(value):
    """As docs/errata.md writes it."""
    return f"{value:.4f}"


class Quadratic:
    """a t^2 + 2 half_b t + c = 0"""

    def __init__(self, a, half_b, c):
        self.a, self.half_b, self.c = a, half_b, c

    def quarter(self):
        return self.half_b * self.half_b - self.a * self.c

    def root(self, sign):
        return over(-self.half_b + sign * root_of(self.quarter()), self.a)

    def root_of_squared_half_b(self, sign):
        """(-(b/2)^2 +- sqrt(D/4)) / a: E18, E30, E50"""
        return (-self.half_b ** 2 + sign * math.sqrt(self.quarter())) / self.a


# The pixel ray

def e01():
    sphere, printed = shape_of(Vec(0, 0, -0.5), 0.25), ray_of(DOWN, unit(DOWN - NOWHERE))
    yield met("sphere", printed, sphere), None
    yield met("sphere", pixel_ray(Camera(NOWHERE, 1, 2, 2), 1, 1, 0, 0), sphere).t, 0.25


def e02():
    wall, pixel = shape_of(Vec(0, 0, -8), UP), Vec(3, 0, -4)
    yield met("plane", ray_of(NOWHERE, unit(pixel - NOWHERE)), wall).t, 10
    right = pixel_ray(Camera(NOWHERE, 4, 12, 12), 2, 1, 1, 0)
    yield right.direction, pixel
    yield met("plane", right, wall).t, 2


# The bracket

IMPLICIT = ctypes.CFUNCTYPE(double, ctypes.c_void_p, Vec)


def first_sign_change(f, ray, steps):
    """The first n with f(P_n) > 0 and f(P_n+1) < 0, or -1."""
    values = [f(None, ray.origin + n * ray.direction) for n in range(steps + 1)]
    return next((n for n in range(steps) if values[n] > 0 > values[n + 1]), -1)


def bracket(f, ray, steps):
    t = (double * 2)()
    status = textbook("bracket", ctypes.c_int, f, None, ctypes.byref(ray), steps, t)
    return t[1] if status == HIT else None


def e03():
    wall, ray = IMPLICIT(lambda _, p: 1 - p.x), ray_of(NOWHERE, X, 0, 2)
    yield first_sign_change(wall, ray, 2), -1
    yield bracket(wall, ray, 2), 1


def e04():
    sphere, through = IMPLICIT(lambda _, p: p @ p - 1), ray_of(-2 * X, 4 * X, 0, 1)
    yield first_sign_change(sphere, through, 1), -1
    yield bracket(sphere, through, 1), None
    yield met("sphere", through, shape_of(NOWHERE, 1)).t, 0.25


# The Phong reflection model

def e05():
    v = Vec(1, 0, 1)
    yield 2 * ((UP @ v) / (UP @ UP) * UP - v), Vec(-2, 0, 0)
    yield textbook("reflect", Vec, v, UP), Vec(-1, 0, 1)


def e07():
    """The nearest formula to "closer": a power of R.L without a condition."""
    yield (textbook("reflect", Vec, UP, UP) @ DOWN) ** 2, 1
    yield textbook("phong_specular", double, UP, UP, DOWN, 2), 0


# The viewport and its pixels

def e08():
    yield reads(2 * 1 * math.tan(4 / 2)), "-4.3701"
    yield reads(textbook("viewport_extent", double, 1.0, 4.0)), "0.0698"


def e09():
    """ "viewport_low_left: a direction", from which P_camera is subtracted."""
    camera = Camera(Vec(5, 0, 0), 1, 4, 4)
    yield Vec(-1, -1, -1) - camera.position, Vec(-6, -1, -1)
    yield pixel_ray(camera, 2, 2, 0, 0).direction, Vec(-1, -1, -1)


def e10():
    """The scalars are added to every component of the point."""
    s = 4 * 0.75 + 4 * 0.25
    yield Vec(-2, -2, -1) + Vec(s, s, s), Vec(2, 2, 3)
    yield pixel_ray(Camera(NOWHERE, 1, 4, 4), 2, 2, 1, 0).direction, Vec(1, -1, -1)


def pixel_share(i, screen_width):
    """i / (screen_width - 1): E11, E12"""
    return over(float(i), screen_width - 1)


def e11():
    yield math.isnan(pixel_share(0, 1)), True
    yield pixel_ray(Camera(NOWHERE, 1, 4, 4), 1, 1, 0, 0).direction.x, 0


def e12():
    def across(width, i, screen_width):
        return -width / 2 + width * pixel_share(i, screen_width)

    yield across(3, 0, 3), -1.5
    yield across(3, 1, 3) - across(3, 0, 3), 1.5
    yield across(2, 1, 2) - across(2, 0, 2), 2
    camera = Camera(NOWHERE, 1, 3, 2)
    low_left = pixel_ray(camera, 3, 2, 0, 0).direction
    yield low_left, Vec(-1, -0.5, -1)
    yield pixel_ray(camera, 3, 2, 1, 1).direction - low_left, Vec(1, 1, 0)


# The sphere

def sphere_quadratic(rc, d, r):
    """The last line of the derivation; rc is the centre's position there, the way to it from the
    ray's origin in the corrected form."""
    return Quadratic(d @ d, -(rc @ d), rc @ rc - r * r)


def e14():
    centre, q = Vec(0, 0, 2), sphere_quadratic(Vec(0, 0, 2), DOWN, 1)
    yield q.root(-1), -3
    yield q.root(+1), -1
    yield met("sphere", ray_of(Vec(0, 0, 5), DOWN), shape_of(centre, 1)).t, 2


def e16():
    """ "discriminant >= 0": a hit."""
    q = sphere_quadratic(Vec(0, 0, -3), UP, 1)
    yield q.quarter() >= 0, True
    yield q.root(-1), -4
    yield q.root(+1), -2
    yield met("sphere", ray_of(NOWHERE, UP), shape_of(Vec(0, 0, -3), 1)), None


def e17():
    yield sphere_quadratic(NOWHERE, DOWN, 1).root(-1), -1
    yield met("sphere", ray_of(NOWHERE, DOWN), shape_of(NOWHERE, 1)).t, 1


def e18():
    q = sphere_quadratic(Vec(0, 0, -3), DOWN, 1)
    yield q.root_of_squared_half_b(-1), -10
    yield q.root_of_squared_half_b(+1), -8
    yield met("sphere", ray_of(NOWHERE, DOWN), shape_of(Vec(0, 0, -3), 1)).t, 2


def e19():
    ray, point = ray_of(Vec(0, 0, 4), Vec(0, 0, -2)), shape_of(NOWHERE, 0)
    yield math.isnan(unit(NOWHERE - NOWHERE).z), True
    yield met("sphere", ray, point).t, 2
    yield normal_of("sphere", ray, point), UP


# The plane

def e20():
    """ad + by + cz + d, with one d for x and for the constant."""
    n, point = X, Vec(3, 0, 0)
    d = -(n @ point)
    yield n.x * d + n.y * 0 + n.z * 0 + d, -6
    yield met("plane", ray_of(NOWHERE, X), shape_of(point, n)).t, 3


def plane_t(n, rc, d):
    """N.rc / N.d: E22, E38, E41"""
    return over(n @ rc, n @ d)


def e22():
    inside = ray_of(X, Vec(0, 1, 0), 2)
    yield math.isnan(plane_t(UP, NOWHERE - inside.origin, inside.direction)), True
    yield met("plane", inside, shape_of(NOWHERE, UP)).t, 2


def e23():
    """N_hit = N"""
    plane = shape_of(NOWHERE, 2 * UP)
    yield Vec(*plane[3:]), Vec(0, 0, 2)
    yield normal_of("plane", ray_of(UP, DOWN), plane), UP


def e24():
    """N_hit = N"""
    away = Object(0, shape_of(Vec(0, 0, -2), DOWN, 0))
    matte, lamp = Material(color=WHITE), Light(NOWHERE, WHITE, 1)
    scene = Scene(ctypes.pointer(away), ctypes.pointer(matte), 1, lights=ctypes.pointer(lamp),
                  light_count=1, camera=Camera(NOWHERE, 1, 1, 1), width=1, height=1)
    yield intensity(Vec(0, 0, -2), Vec(*away.numbers[3:6]), NOWHERE), 0
    yield call("sure_backward_pixel", Vec, ctypes.byref(scene), TEXTBOOK, 0, 0), WHITE


# The cylinder

def wall_quadratic(rc, d, n, r):
    """The last line, for the axis N as it is given, rc from the ray's origin to a point of the
    axis: E25"""
    return Quadratic(d @ d - (d @ n) ** 2, -(rc @ d - (d @ n) * (rc @ n)),
                     rc @ rc - (rc @ n) ** 2 - r * r)


def wall_t(o, d, base, top):
    return met("cylinder_wall", ray_of(o, d), shape_of(base, top, 1)).t


def e14_cylinder():
    o = -3 * X
    yield wall_quadratic(X, X, UP, 1).root(-1), 0
    yield wall_t(o, X, X, Vec(1, 0, 1)), 3


def e25():
    o, n = Vec(-3, 0, 1), 2 * UP
    yield wall_quadratic(NOWHERE - o, X, n, 1).root(-1), 1
    yield wall_t(o, X, NOWHERE, n), 2


def e26():
    """... + (rc.N)^2 - r^2"""
    c = Vec(3, 0, 1)
    q = wall_quadratic(c, X, UP, 1)
    q.c = c @ c + (c @ UP) ** 2 - 1
    yield q.quarter(), -1
    yield wall_t(NOWHERE, X, c, Vec(3, 0, 2)), 2


def e28():
    """- (rp.N)^2 - 2 (rp.N)(d.N) + (d.N)^2 + ..., rc the centre's position."""
    rp, d, rc, n, r = Vec(-3, 0, 1), Vec(1, 0, 1), NOWHERE, UP, 1
    c = (rp @ rp - 2 * (rc @ rp) + rc @ rc - (rp @ n) ** 2 - 2 * (rp @ n) * (d @ n) + (d @ n) ** 2
         + 2 * (rp @ n) * (rc @ n) - (rc @ n) ** 2 - r * r)
    yield Quadratic(d @ d, rp @ d - rc @ d + (d @ n) * (rc @ n), c).quarter(), -10
    yield wall_t(rp, d, rc, n), 2


def e29():
    ray = ray_of(Vec(0.5, 0, 5), DOWN)
    yield math.isnan(wall_quadratic(NOWHERE - ray.origin, DOWN, UP, 1).root(-1)), True
    hit = met("cylinder", ray, shape_of(NOWHERE, 2 * UP, 1))
    yield (hit.t, hit.part), (3, TOP)


def e30():
    o = -3 * X
    q = wall_quadratic(NOWHERE - o, X, UP, 1)
    yield q.root_of_squared_half_b(-1), -10
    yield q.root_of_squared_half_b(+1), -8
    yield wall_t(o, X, NOWHERE, UP), 2


def e31():
    """The left side of sqrt((x_n^2 + y_n^2 + z_n^2) t^2) = -h/2."""
    yield math.sqrt((UP @ UP) * -1 * -1), 1
    yield from_axis("cylinder", NOWHERE, UP, 1, 2)[0], DOWN


def e32():
    """pi/2 <= alpha < pi and 0 < beta <= pi/2: a right angle or more, and not along N."""
    def angle(u, v):
        return math.acos(u @ v / (length(u) * length(v)))

    p_hit, top = UP, 2 * UP
    alpha, beta = angle(UP, p_hit - top), angle(UP, p_hit - NOWHERE)
    yield PI / 2 <= alpha < PI and 0 < beta <= PI / 2, False
    yield textbook("cylinder_height", ctypes.c_int, p_hit, shape_of(NOWHERE, top, 0)), 1


def wall_normal(shape, p_hit, it):
    return textbook(f"{shape}_wall_normal", Vec, p_hit, it)


def e33():
    n = unit(X - DOWN)
    yield (reads(n.x), reads(n.z)), ("0.7071", "0.7071")
    yield wall_normal("cylinder", X, shape_of(DOWN, UP, 1)), X


def e34():
    c, n, p = NOWHERE, UP, UP
    wrong = unit(X - (c + (n @ (p - c)) / (n @ n) * n))
    yield (reads(wrong.x), reads(wrong.z)), ("0.7071", "-0.7071")
    yield wall_normal("cylinder", X, shape_of(DOWN, UP, 1)), X


def e35():
    """C + h/2 sqrt(1/x_n^2 + y_n^2 + z_n^2) N"""
    n = Vec(1, 2, 2)
    yield NOWHERE + 6 / 2 * math.sqrt(1 / n.x ** 2 + n.y ** 2 + n.z ** 2) * n, Vec(9, 18, 18)
    yield from_axis("cylinder", NOWHERE, n, 1, 6)[1], n


def e36():
    """N.rQ / N.rcy, the only symbol like it being rc"""
    o = Vec(0, 0, 5)
    yield UP @ (UP - o) / (UP @ (NOWHERE - o)), 0.8
    yield met("cylinder", ray_of(o, DOWN), shape_of(DOWN, UP, 1)).t, 4


def e38():
    ray = ray_of(-3 * X, X)
    yield math.isnan(plane_t(UP, NOWHERE - ray.origin, X)), True
    yield met("disc", ray, shape_of(NOWHERE, UP, 1)).t, 2


def e39():
    """N_hit = N"""
    ray, cylinder = ray_of(Vec(0, 0, -5), UP), shape_of(NOWHERE, 2 * UP, 1)
    yield unit(Vec(*cylinder[3:6]) - NOWHERE), UP
    yield met("cylinder", ray, cylinder).part, BASE
    yield normal_of("cylinder", ray, cylinder), DOWN


def e41():
    """The nearer of the circles that are hit."""
    ray, base, top = ray_of(Vec(-3, 0, 3), Vec(1, 0, -1)), NOWHERE, 2 * UP
    found = [(end, plane_t(top - base, end - ray.origin, ray.direction)) for end in (top, base)]
    yield min(t for end, t in found if length(ray.origin + t * ray.direction - end) <= 1), 3
    hit = met("cylinder", ray, shape_of(base, top, 1))
    yield (hit.t, hit.part), (2, WALL)


# The cone: base at the origin, apex at (0,0,1), radius 1, so that cos^2 is 1/2

APEX, RIGHT_ANGLED, COS2 = UP, shape_of(NOWHERE, UP, 1), 0.5
BESIDE, INWARD, ABOVE = Vec(3, 0, 0), Vec(-1, 0, 0), Vec(0.5, 0, 10)


def cone_quadratic(rq, d):
    """The last line, for |N| = 1 and rq from the ray's origin to the apex."""
    return Quadratic((d @ UP) ** 2 - (d @ d) * COS2, -((rq @ UP) * (UP @ d) - (rq @ d) * COS2),
                     (rq @ UP) ** 2 - (rq @ rq) * COS2)


def cone_t(o, d, cone=RIGHT_ANGLED):
    return met("cone", ray_of(o, d), cone).t


def e43():
    """The nearer root, dropped when it is on the other nappe."""
    rq = APEX - ABOVE
    q = cone_quadratic(rq, DOWN)
    t = min(q.root(-1), q.root(+1))
    yield q.root(-1), 8.5
    yield UP @ rq + t * -(UP @ DOWN) >= 0, False
    yield cone_t(ABOVE, DOWN), 9.5


def e44():
    """-2 (rq.N) ray(t), where a number is wanted."""
    yield -2 * (APEX @ UP) * X, Vec(-2, 0, 0)
    yield -2 * (APEX @ UP) * (X @ UP), 0
    yield cone_t(BESIDE, INWARD), 2


def expanded(rp, d, rq, square_term, cross_term):
    """The expanded equation, rq the apex's position; square_term stands for the constant part of
    (ray(t).N)^2, cross_term for that of 2 rq.ray(t): E45 to E47"""
    q_n, p_n, d_n = rq @ UP, rp @ UP, d @ UP
    return Quadratic(d_n ** 2 - (d @ d) * COS2,
                     -q_n * d_n + p_n * d_n + (rq @ d - rp @ d) * COS2,
                     q_n ** 2 - 2 * q_n * p_n + square_term
                     - (rq @ rq - cross_term + rp @ rp) * COS2)


def e45():
    """(rq.N)^2 - 2 (rq.N) ray.N + ray^2 (N.N) - {rq.rq - 2 rq.ray + ray^2} cos^2"""
    rp, d, rq = BESIDE, INWARD, APEX
    q = expanded(rp, d, rq, rp @ rp, 2 * (rq @ rp))
    q.a += d @ d - (d @ UP) ** 2
    q.half_b += rp @ d - (rp @ UP) * (d @ UP)
    yield q.quarter(), -0.25
    yield cone_t(BESIDE, INWARD), 2


def e46():
    q = expanded(BESIDE, INWARD, APEX, BESIDE @ BESIDE, 2 * (APEX @ BESIDE))
    yield (reads(q.root(+1)), reads(q.root(-1))), ("-1.3589", "7.3589")
    yield cone_t(BESIDE, INWARD), 2


def e47():
    o, apex = Vec(3, 0, 1), 2 * UP
    q = expanded(o, INWARD, apex, (o @ UP) ** 2, 2 * (o @ UP))
    yield q.quarter(), -0.25
    yield cone_t(o, INWARD, shape_of(NOWHERE, apex, 2)), 2


def e48():
    """All terms with r_p struck out, rq still the apex's position."""
    q = cone_quadratic(APEX, INWARD)
    yield (q.root(+1), q.root(-1)), (-1, 1)
    yield cone_t(BESIDE, INWARD), 2


def e49():
    """(-1 - 2 {...} +- sqrt(D)) / 2a"""
    q = cone_quadratic(APEX - BESIDE, INWARD)
    for sign, wrong in ((+1, -3), (-1, -1)):
        yield (-1 - 2 * -q.half_b + sign * 2 * math.sqrt(q.quarter())) / (2 * q.a), wrong
    yield cone_t(BESIDE, INWARD), 2


def e50():
    q = cone_quadratic(APEX - BESIDE, INWARD)
    yield q.root_of_squared_half_b(+1), 3.5
    yield q.root_of_squared_half_b(-1), 5.5
    yield cone_t(BESIDE, INWARD), 2


def e51():
    yield cone_quadratic(APEX - BESIDE, INWARD).root(-1), 4
    yield cone_t(BESIDE, INWARD), 2


def e52():
    o, along = Vec(-1, 0, 1), Vec(1, 0, -1)
    yield math.isnan(cone_quadratic(APEX - o, along).root(+1)), True
    yield cone_t(o, along), 0.5


def e53():
    """|PQ| <= sqrt(r^2 + h^2) and rq.PQ >= 0"""
    rq = APEX - ABOVE
    for point, printed, right in ((Vec(0.5, 0, 1.5), True, 0), (Vec(0.5, 0, 0.5), False, 1)):
        pq = APEX - point
        yield length(pq) <= math.sqrt(1 + 1) and rq @ pq >= 0, printed
        yield textbook("cone_height", ctypes.c_int, point, RIGHT_ANGLED), right


# Height 4, radius 3, so that the slant is 5 and the cosine 4/5

POINTED, TIP, HALF_WAY, COSINE = shape_of(NOWHERE, 4 * UP, 3), 4 * UP, Vec(1.5, 0, 2), 0.8
NORMAL = Vec(0.8, 0, 0.6)


def above_the_tip(p_hit):
    """Q + |PQ| / cos N: E54, E55"""
    return TIP + length(TIP - p_hit) / COSINE * UP


def e54():
    yield unit(above_the_tip(HALF_WAY)), UP
    yield wall_normal("cone", HALF_WAY, POINTED), NORMAL


def e55():
    n = unit(HALF_WAY - above_the_tip(HALF_WAY))
    yield (reads(n.x), reads(n.z)), ("0.2809", "-0.9597")
    yield wall_normal("cone", HALF_WAY, POINTED), NORMAL


def e56():
    yield unit(HALF_WAY - NOWHERE), Vec(0.6, 0, 0.8)
    yield wall_normal("cone", HALF_WAY, POINTED), NORMAL


def e57():
    """P - S with S = Q - |PQ| / cos N, at the apex"""
    s = TIP - length(TIP - TIP) / COSINE * UP
    yield math.isnan(unit(TIP - s).z), True
    yield wall_normal("cone", TIP, POINTED), UP


def e59():
    """The first coordinate of B, d_c - h/2 sqrt(1/d_n^2 + n^2 + z_n^2) d_n, n read as |N|."""
    n = Vec(1, 2, 2)
    yield reads(0 - 6 / 2 * math.sqrt(1 / n.x ** 2 + n @ n + n.z ** 2) * n.x), "-11.2250"
    yield from_axis("cone", NOWHERE, n, 1, 6)[0], -1 * n


def e60():
    o, p_hit = Vec(0.25, 0, -5), Vec(0.25, 0, 0)
    yield UP @ (NOWHERE - p_hit) / (UP @ UP), 0
    yield cone_t(o, UP), 5


def e61():
    """N_hit = N"""
    ray = ray_of(Vec(0.25, 0, -5), UP)
    yield unit(APEX - NOWHERE), UP
    yield met("cone", ray, RIGHT_ANGLED).part, BASE
    yield normal_of("cone", ray, RIGHT_ANGLED), DOWN


def e62():
    o = Vec(0.25, 0, -5)
    yield cone_quadratic(APEX - o, UP).root(-1), 5.75
    yield cone_t(o, UP), 5


# The light

OVERHEAD, BELOW = Vec(0, 0, 2), Vec(0, 0, -2)


def cosine(p_hit, n, p_light):
    """Of the angle between light_direction = P_hit - P_light and N: E63 to E65"""
    return unit(p_hit - p_light) @ n


def e63():
    for lamp, printed, right in ((OVERHEAD, -1, 1), (BELOW, 1, 0)):
        yield cosine(NOWHERE, UP, lamp), printed
        yield intensity(NOWHERE, UP, lamp), right


def e64():
    """The angle itself, after the sign is mended."""
    yield math.acos(-cosine(NOWHERE, UP, OVERHEAD)), 0
    yield intensity(NOWHERE, UP, OVERHEAD), 1


def e65():
    """The cosine without a lower end, after the sign is mended."""
    yield -cosine(NOWHERE, UP, BELOW), -1
    yield intensity(NOWHERE, UP, BELOW), 0


def e66():
    lamp = Light(NOWHERE, WHITE, 1)
    yield over(1 * 1, 4 * PI * 0 * 0), INFINITY
    yield textbook("light_color", Vec, ctypes.byref(lamp), NOWHERE, 1), NOWHERE
    yield intensity(NOWHERE, UP, NOWHERE), 0


def e67():
    """ "without hitting other objects" """
    sphere, lamp = Object(2, shape_of(NOWHERE, 1, 0, 0, 0)), Vec(0, 0, 5)
    scene = Scene(objects=ctypes.pointer(sphere), object_count=1)
    inside = SurfacePoint(0, DOWN, UP, 1)
    others = [i for i in range(scene.object_count) if i != inside.object]
    yield len(others), 0
    yield call("sure_shadow_reaches", ctypes.c_int, ctypes.byref(scene), TEXTBOOK,
               ctypes.byref(inside), lamp), 0


# The camera

def e68():
    """R_z by 3 pi / 2"""
    view, cos, sin = Vec(0, 1, 0), 0, -1
    yield Vec(cos * view.x - sin * view.y, sin * view.x + cos * view.y, view.z), X
    yield turned(world_for(view), view), DOWN


def e69():
    """Case 7, y < 0 and z < 0: cos = y / sqrt(y^2 + z^2), sin = sqrt(1 - cos^2)."""
    y, z = -3, -4
    cos = y / math.sqrt(y * y + z * z)
    yield (cos, math.sqrt(1 - cos * cos)), (-0.6, 0.8)
    world = world_for(Vec(0, y, z))
    yield world.row[1], Vec(0, 0.8, -0.6)
    yield world.row[2], Vec(0, 0.6, 0.8)


def e70():
    """The sine of case 7 with the cosine mended."""
    y, z = -2.0 ** -30, -1
    cos = abs(z) / math.sqrt(y * y + z * z)
    yield math.sqrt(1 - cos * cos), 0
    yield world_for(Vec(0, y, z)).row[2].y, -y


def e71():
    """Where case 7, y > 0 and z > 0, takes the world's up, (0, 1, 0): -cos, -sin, the cosine
    mended."""
    y, z = 3, 4
    across = math.sqrt(y * y + z * z)
    yield Vec(0, -abs(z) / across, -abs(y) / across), Vec(0, -0.8, -0.6)
    yield turned(world_for(Vec(0, y, z)), Vec(0, 1, 0)), Vec(0, 0.8, -0.6)


def e72():
    """Case 8, x > 0 and z < 0: cos = z / sqrt(x^2 + z^2)."""
    x, z = 3, -4
    yield z / math.sqrt(x * x + z * z), -0.8
    yield world_for(Vec(x, 0, z)).row[0], Vec(0.8, 0, 0.6)


def e73():
    """Case 8, x > 0 and z > 0: cos, -sin."""
    x, z = 3, 4
    across = math.sqrt(x * x + z * z)
    yield (abs(z) / across, -abs(x) / across), (0.8, -0.6)
    yield world_for(Vec(x, 0, z)).row[0], Vec(-0.8, 0, 0.6)


def e74():
    """Case 7 is the nearest for x != 0: a turn about x alone."""
    view = Vec(3, 12, -4)
    yield view.x, 3  # as it was
    world = world_for(view)
    yield world.row[0], Vec(0.8, 0, 0.6)
    yield (world.row[1].y, world.row[2].y), (5 / 13, -12 / 13)


def untested(errata, tests):
    """What the page promises and this file doesn't hold, and the other way round."""
    page = pathlib.Path(errata).read_text(encoding="utf-8")
    rows = re.findall(r"^\| (E\d+) \|[^|]*\|[^|]*\| (\w+) \|", page, re.M)
    expected = {row[0] for row in rows if row[1] != "wording"}
    found = {name[:3].upper() for name in tests}
    return [f"{name}: in one of page and tests alone" for name in sorted(expected ^ found)]


def main():
    tests = {name: test for name, test in globals().items() if re.match(r"e\d\d", name)}
    faults = untested(pathlib.Path(sys.argv[2]) / "docs/errata.md", tests)
    for name, test in tests.items():
        if sys.argv[3:] and name[:3].upper() not in sys.argv[3:]:
            continue
        faults += [f"{name}, answer {place}: {value!r}, expected {expected!r}"
                   for place, (value, expected) in enumerate(test()) if value != expected]
    print(*faults, "0 passed, 1 failed" if faults else "1 passed, 0 failed", sep="\n")
    return 1 if faults else 0


sys.exit(main())
