# SPDX-License-Identifier: MIT
"""A drawing a shape: a ray, and where the formulas of the shape's page put its crossings."""
import math

from svg import TILT, Drawing, add, arc_places, dot, sub, unit


def roots(a, half_b, c):
    root = math.sqrt(half_b * half_b - a * c)
    return sorted(((-half_b - root) / a, (-half_b + root) / a))


def crossing(o, d, place, normal):
    return dot(normal, sub(place, o)) / dot(normal, d)


def cone_times(o, d, apex, r, height):
    """The crossings with both generators of the section, whose lines lead up to the apex."""
    found = []
    for side in (-1, 1):
        normal = (height, -side * r)
        found.append(crossing(o, d, apex, normal))
    return sorted(found)


def cone_body(page, apex, low, r):
    page.path([apex] + arc_places(0, low, r, 180, 360), "fill", closed=True)
    page.line(apex, (-r, low), "edge")
    page.line(apex, (r, low), "edge")
    page.arc((0, low), r, TILT * r, 180, 360, "edge")
    page.arc((0, low), r, TILT * r, 0, 180, "faint")


def plane():
    page = Drawing((640, 330), (330, 225), 70, "A ray meets a plane",
                   "The ray starts at o above the plane and goes along d to the point P. The "
                   "plane is given by a point Q and a normal N. rc leads from o to Q. Along "
                   "the normal, o is N.rc / |N| from the plane, and a step of d goes N.d / |N|.")
    q, n, o, d = (1.9, 0), (0, 1.5), (-2.6, 2.4), (1.1, -0.95)
    t = crossing(o, d, q, n)
    p, foot = add(o, d, t), (o[0], 0)
    page.path([(-4.3, 0), (4, 0), (4, -0.5), (-4.3, -0.5)], "fill", closed=True)
    page.line((-4.3, 0), (4, 0), "edge")
    page.line(o, foot, "faint")
    page.corner(foot, (1, 0), (0, 1), 0.17)
    page.arrow(o, q, "mark")
    page.line(add(o, d), p, "ray")
    page.line(p, add(p, d, 0.45), "within")
    page.arrow(o, add(o, d), "ray")
    page.arrow(q, add(q, n), "edge")
    for place in (o, q):
        page.dot(place)
    page.dot(p, "ray")
    page.text(o, "o", (0, 12))
    page.text(add(o, d), "d", (-10, -18), "ray")
    page.text(p, "P = o + t d", (-56, -22), "ray on")
    page.text(q, "Q", (14, -20), "on")
    page.text(add(q, n), "N", (14, -4))
    page.text(add(o, sub(q, o), 0.55), "rc = Q − o", (52, 8), "mark")
    page.text(add(o, sub(foot, o), 0.6), "N.rc / |N|", (-8, 0), "faint", "end")
    return page


def disc():
    page = Drawing((640, 330), (320, 215), 70, "A ray meets a disc",
                   "The disc lies in a plane around its centre Q with radius r. One ray "
                   "crosses the plane at P, within r of Q: it hits. Another crosses the plane "
                   "farther than r from Q: it misses.")
    tilt, r = 0.36, 1.9

    def seen(x, y, z):
        return (x, tilt * -z + y * math.sqrt(1 - tilt * tilt))

    page.path([seen(-4, 0, -2.6), seen(3.2, 0, -2.6), seen(4, 0, 2.6), seen(-3.2, 0, 2.6)], "thin",
              closed=True)
    page.ellipse(seen(0, 0, 0), r, tilt * r, "body")
    q = (0, 0, 0)

    def shot(o, aim, name, side):
        """Straight to a place in the plane."""
        way = [a - b for a, b in zip(aim, o)]
        beyond = [a + 0.35 * w for a, w in zip(aim, way)]
        page.line(seen(*aim), seen(*beyond), "within")
        page.arrow(seen(*o), seen(*aim), "ray")
        page.dot(seen(*aim), "ray")
        page.text(seen(*o), name, (0, 10))
        page.text(seen(*aim), side[0], side[1], side[2])

    hit, missed = (-0.85, 0, 0.6), (2.55, 0, 0.5)
    page.line(seen(*q), seen(*hit), "mark")
    page.arrow(seen(0, 0, 0), seen(0, 1.7, 0), "edge")
    page.line(seen(*q), seen(r * math.cos(0.6), 0, -r * math.sin(0.6)), "edge")
    shot((-2.6, 2.6, 0.2), hit, "o", ("P", (-12, -16), "ray on"))
    shot((1.8, 2.6, 0), missed, "o′", ("a miss", (36, -4), "ray"))
    page.dot(seen(*q))
    page.text(seen(*q), "Q", (12, -20), "on")
    page.text(seen(0, 1.7, 0), "N", (14, -6))
    page.text(seen(0.8, 0, -0.55), "r", (0, 10), "on")
    page.text(seen(-0.43, 0, 0.3), "t d − rc", (-66, 6), "mark on")
    return page


def sphere():
    page = Drawing((680, 360), (430, 190), 84, "A ray meets a sphere",
                   "Seen in the plane of the ray and the centre. The line comes in at t_1 and "
                   "goes out at t_2. The foot of the perpendicular from the centre C is "
                   "|w|/|d| from C and halfway between the two; half the chord is the root of "
                   "D/4, over |d|.")
    c, r, o, d = (0, 0), 1.6, (-4.3, 0.25), (1.35, 0.17)
    rc = sub(c, o)
    first, second = roots(dot(d, d), -dot(rc, d), dot(rc, rc) - r * r)
    middle = add(o, d, dot(rc, d) / dot(d, d))
    page.ellipse(c, r, r, "body")
    page.arrow(o, c, "mark")
    page.line(add(o, d), add(o, d, first), "ray")
    page.line(add(o, d, first), add(o, d, second), "within")
    page.line(add(o, d, second), add(o, d, second + 0.5), "ray")
    page.arrow(o, add(o, d), "ray")
    page.line(c, middle, "edge")
    page.corner(middle, sub(c, middle), d, 0.13)
    page.line(c, add(o, d, second), "edge")
    for place in (o, c):
        page.dot(place)
    page.dot(add(o, d, first), "ray")
    page.dot(add(o, d, second), "ray")
    page.text(o, "o", (-14, 2))
    page.text(add(o, d, 0.75), "d", (0, 12), "ray")
    page.text(c, "C", (2, -24), "on")
    page.text(add(o, rc, 0.45), "rc = C − o", (0, -22), "mark")
    page.text(add(o, d, first), "t₁", (-16, 12), "ray")
    page.text(add(o, d, second), "t₂", (18, 12), "ray")
    page.text(add(c, sub(add(o, d, second), c), 0.6), "r", (10, -14), "on")
    page.text(add(c, sub(middle, c), 0.45), "|w| / |d|", (-8, -4), "on", "end")
    half = (2 * second + 3 * (second + first) / 2) / 5
    page.text(add(o, d, half), "√(D/4) / |d|", (-4, 14), "on")
    return page


def cylinder():
    page = Drawing((680, 400), (350, 205), 78, "A ray meets a cylinder",
                   "Seen in the plane of the ray and the axis. The line crosses the plane of "
                   "the top at t_top, the wall at t_1, the plane of the base at t_base and the "
                   "wall again, below the base, at t_2. It is in the cylinder from the later "
                   "of the first two, t_1, to the earlier of the last two, t_base.")
    r, low, high = 1.35, -1.35, 1.35
    o, d = (-3.7, 2.05), (0.8, -0.64)
    page.path([(-r, high), (-r, low)] + arc_places(0, low, r, 180, 360) +
              [(r, high)], "fill", closed=True)
    for x in (-r, r):
        page.line((x, -2.35), (x, 2.35), "faint")
        page.line((x, low), (x, high), "edge")
    for y in (low, high):
        page.line((-4.1, y), (4, y), "faint")
    page.arc((0, low), r, TILT * r, 180, 360, "edge")
    page.arc((0, low), r, TILT * r, 0, 180, "faint")
    page.ellipse((0, high), r, TILT * r, "body")
    page.arrow((0, low), (0, high), "edge")
    page.line((0, low), (r, low), "edge")
    times = {"top": crossing(o, d, (0, high), (0, 1)), "base": crossing(o, d, (0, low), (0, 1)),
             "one": (-r - o[0]) / d[0], "two": (r - o[0]) / d[0]}
    assert times["top"] < times["one"] < times["base"] < times["two"]
    page.line(add(o, d), add(o, d, times["one"]), "ray")
    page.line(add(o, d, times["one"]), add(o, d, times["base"]), "within")
    page.line(add(o, d, times["base"]), add(o, d, times["two"] + 0.5), "ray")
    page.arrow(o, add(o, d), "ray")
    page.line(add(o, d, times["one"]), (0, add(o, d, times["one"])[1]), "mark")
    page.corner((0, add(o, d, times["one"])[1]), (-1, 0), (0, 1), 0.14)
    for name, words, by in (("top", "t_top", (-8, -22)), ("one", "t₁ = enter", (-50, -20)),
                            ("base", "t_base = leave", (-56, -40)), ("two", "t₂", (20, 2))):
        page.dot(add(o, d, times[name]), "ray")
        page.text(add(o, d, times[name]), words, by, "ray")
    for place, words, by, kind in ((o, "o", (-12, 0), ""), ((0, low), "base", (-22, 10), "on"),
                                   ((0, high), "top", (22, -5), "on")):
        page.dot(place)
        page.text(place, words, by, kind)
    page.text(add(o, d, 0.6), "d", (4, 12), "ray")
    page.text((0, 0.7), "A", (14, 0), "on")
    page.text((r / 2, low), "r", (0, 8), "on")
    page.text((-r / 2, add(o, d, times["one"])[1]), "P − foot", (6, 8), "mark on")
    page.text((-r, 2.35), "wall", (0, 6), "faint upright")
    page.text((4, high), "plane of the top", (0, 8), "faint upright", "end")
    page.text((4, low), "plane of the base", (0, 8), "faint upright", "end")
    return page


def cone():
    page = Drawing((680, 420), (330, 235), 84, "A ray meets a cone",
                   "Seen in the plane of the ray and the axis. The apex Q is above the base; N "
                   "leads from the base's centre to Q and has the length h; the wall makes the "
                   "angle theta with the axis. The line meets the wall at t_1, where it comes "
                   "in, and goes out through the base at t_base, before it meets the wall's "
                   "other side.")
    apex, low, r = (0, 1.75), -1.45, 1.7
    height = apex[1] - low
    o, d = (-2.35, 2.3), (0.72, -0.96)
    cone_body(page, apex, low, r)
    for side in (-1, 1):
        slope = (side * r / height, -1)
        page.line(add(apex, slope, height), add(apex, slope, height + 0.6), "faint")
        page.line(apex, add(apex, slope, -0.75), "faint")
    page.line((-3.7, low), (3.9, low), "faint")
    page.arrow((0, low), apex, "edge")
    page.line((0, low), (-r, low), "edge")
    one, two = cone_times(o, d, apex, r, height)
    base = crossing(o, d, (0, low), (0, 1))
    assert one < base < two
    page.line(add(o, d), add(o, d, one), "ray")
    page.line(add(o, d, one), add(o, d, base), "within")
    page.line(add(o, d, base), add(o, d, base + 0.6), "ray")
    page.arrow(o, add(o, d), "ray")
    hit = add(o, d, one)
    page.line(apex, hit, "mark")
    page.arc(apex, 0.85, 0.85, 270 - math.degrees(math.atan2(r, height)), 270, "thin")
    outward = unit((-height, r))
    page.arrow(hit, add(hit, outward, 0.85), "good")
    page.text(add(hit, outward, 0.85), "normal", (-30, 2), "good")
    page.text(apex, "θ", (-14, -58), "on")
    for name, time, by in (("t₁ = enter", one, (-52, -14)), ("t_base = leave", base, (96, -42))):
        page.dot(add(o, d, time), "ray")
        page.text(add(o, d, time), name, by, "ray")
    for place, words, by, kind in ((o, "o", (-12, 0), ""), (apex, "Q, the apex", (56, 2), ""),
                                   ((0, low), "base", (26, 10), "on")):
        page.dot(place)
        page.text(place, words, by, kind)
    page.text(add(o, d, 0.6), "d", (4, 12), "ray")
    page.text((0, -0.8), "N, |N| = h", (10, 0), "on", "start")
    page.text((-r / 2, low), "r", (0, -20), "on")
    page.text((3.9, low), "plane of the base", (0, 8), "faint upright", "end")
    return page


def box():
    page = Drawing((680, 410), (330, 205), 84, "A ray meets a box",
                   "Two of the three axes. Between the planes x_min and x_max the line is from "
                   "t_x,near to t_x,far, between y_min and y_max from t_y,near to t_y,far. It "
                   "is in the box from the last near time, here that of x, to the first far "
                   "time, here that of y.")
    low, high = (-1.5, -1.05), (1.7, 1.05)
    o, d = (-3.5, -1.75), (0.75, 0.528)
    page.path([low, (high[0], low[1]), high, (low[0], high[1])], "body", closed=True)
    for x in (low[0], high[0]):
        page.line((x, -2.1), (x, 2.1), "faint")
    for y in (low[1], high[1]):
        page.line((-3.8, y), (4, y), "faint")
    times = [[(plane[i] - o[i]) / d[i] for plane in (low, high)] for i in (0, 1)]
    enter, leave = max(times[0][0], times[1][0]), min(times[0][1], times[1][1])
    assert enter == times[0][0] and leave == times[1][1] and enter < leave
    page.line(add(o, d), add(o, d, enter), "ray")
    page.line(add(o, d, enter), add(o, d, leave), "within")
    page.line(add(o, d, leave), add(o, d, times[0][1] + 0.5), "ray")
    page.arrow(o, add(o, d), "ray")
    for time, words, by in ((times[1][0], "y near", (-30, 12)),
                            (enter, "x near = enter", (-70, 10)),
                            (leave, "y far = leave", (-30, 16)), (times[0][1], "x far", (34, -14))):
        page.dot(add(o, d, time), "ray")
        page.text(add(o, d, time), words, by, "ray")
    page.dot(o)
    page.text(o, "o", (-12, 0))
    page.text(add(o, d, 0.6), "d", (14, -10), "ray")
    page.dot(low)
    page.text(low, "L", (-12, -18))
    page.dot(high)
    page.text(high, "H", (14, 8))
    for x, name in ((low[0], "x_min"), (high[0], "x_max")):
        page.text((x, -2.1), name, (0, -13), "faint upright")
    for y, name in ((low[1], "y_min"), (high[1], "y_max")):
        page.text((4, y), name, (0, 7), "faint upright", "end")
    return page
