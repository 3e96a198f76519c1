# SPDX-License-Identifier: MIT
"""What all shapes have in common: the chord, the nappe that is kept, parts, stages."""
import math

from shapes import cone_body, cone_times, crossing
from svg import TILT, Drawing, add, arc_places, dot, sub


def chord():
    page = Drawing((700, 410), (350, 130), 78, "The chord and the range",
                   "A line cuts its chord from a closed solid: from t_enter to t_leave. Below, "
                   "four ranges from t_min to t_max. A range that begins before t_enter and "
                   "reaches it: the answer is t_enter. One that begins within the chord and "
                   "reaches t_leave: t_leave. One within the chord: a miss. One that ends "
                   "before t_enter: a miss.")
    rx, ry = 2.1, 1.05
    y = 0.25
    half = rx * math.sqrt(1 - (y / ry) ** 2)
    page.ellipse((0, 0), rx, ry, "body")
    page.line((-4.2, y), (-half, y), "ray")
    page.line((-half, y), (half, y), "within")
    page.arrow((half, y), (4.2, y), "ray")
    for x, name in ((-half, "t_enter"), (half, "t_leave")):
        page.line((x, y), (x, -3.25), "faint")
        page.dot((x, y), "ray")
        page.text((x, y), name, (-34 if x < 0 else 36, 10), "ray")
    page.text((-4.2, y), "o + t d", (24, 10), "ray")
    page.text((0, y), "chord", (0, 10), "ray on")
    rows = [(-3.5, 0.9, -half, "t_enter"), (-1.0, 3.1, half, "t_leave"), (-1.1, 1.2, None, "miss"),
            (-4.0, -2.6, None, "miss")]
    for i, (start, end, answer, words) in enumerate(rows):
        line = -1.45 - 0.6 * i
        page.line((-4.2, line), (4.2, line), "thin")
        page.line((start, line), (end, line), "bar")
        if answer is not None:
            page.dot((answer, line), "ray")
        page.text((4.25, line), words, (0, 8), "upright", "end")
        if i == 0:
            page.text((start, line), "t_min", (0, 10), "mark")
            page.text((end, line), "t_max", (0, 10), "mark")
    return page


def nappe():
    page = Drawing((680, 400), (340, 190), 70, "The two nappes of a double cone",
                   "The equation of the wall describes two nappes that meet at the apex. The "
                   "cone keeps the lower one, down to its base. A steep line crosses both: the "
                   "root on the upper nappe is none of the cone's. A line parallel to a "
                   "generator has one root.")
    apex, low, r = (0, 0.35), -2.1, 1.6
    height = apex[1] - low
    cone_body(page, apex, low, r)
    for side in (-1, 1):
        page.line(apex, add(apex, (side * r / height, 1), 2.0), "faint")
    page.arc((0, apex[1] + 2.0), 2.0 * r / height, TILT * 2.0 * r / height, 0, 360, "faint")
    page.line((-3.6, low), (3.7, low), "faint")
    o, d = (-0.9, 2.5), (0.098, -1.1)
    one, two = cone_times(o, d, apex, r, height)
    found = [time for time in (one, two) if add(o, d, time)[1] < apex[1]]
    base = crossing(o, d, (0, low), (0, 1))
    assert len(found) == 1 and found[0] > min(one, two)
    page.line(o, add(o, d, found[0]), "ray")
    page.line(add(o, d, found[0]), add(o, d, base), "within")
    page.arrow(add(o, d, base), add(o, d, base + 0.5), "ray")
    for time in (one, two):
        kept = time in found
        page.dot(add(o, d, time), "ray" if kept else "edge")
        words, by = ("root 2 = enter", (-68, 4)) if kept else ("root 1", (-34, 2))
        page.text(add(o, d, time), words, by, "ray" if kept else "")
    page.dot(add(o, d, base), "ray")
    page.text(add(o, d, base), "leave", (-28, 6), "ray on")
    slope = (-r / height, -1)  # of the left generator
    start = (2.9, 2.1)
    other = [time for time in cone_times_of_one(start, slope, apex, r, height)]
    page.line(start, add(start, slope, other[0]), "good")
    page.line(add(start, slope, other[0]), add(start, slope, (start[1] - low)), "within")
    page.arrow(add(start, slope, start[1] - low), add(start, slope, start[1] - low + 0.5), "good")
    page.dot(add(start, slope, other[0]), "mark")
    page.text(add(start, slope, other[0]), "the only root", (62, -4), "good")
    page.text((-1.5, 2.0), "the other nappe", (0, 0), "faint upright", "end")
    page.text((-1.45, -1.2), "the kept nappe", (0, 0), "upright", "end")
    page.text(start, "parallel to a generator", (90, 8), "good upright", "end")
    page.dot(apex)
    page.text(apex, "apex", (30, 0))
    return page


def cone_times_of_one(o, d, apex, r, height):
    """The crossing with the one generator that the line is not parallel to."""
    for side in (-1, 1):
        normal = (height, -side * r)
        if abs(dot(normal, d)) > 1e-9:
            yield crossing(o, d, apex, normal)


def parts():
    page = Drawing((700, 330), (350, 170), 70, "The parts of the solids",
                   "A cylinder has a base, a wall and a top. A cone has a base and a wall, to "
                   "which the apex belongs. A box has six faces, x_min to z_max. On an edge "
                   "the first of these counts.")
    x, r, low, high = -3.6, 1.0, -1.2, 1.2
    page.path([(x - r, high), (x - r, low)] + arc_places(x, low, r, 180, 360) + [(x + r, high)],
              "fill", closed=True)
    page.line((x - r, low), (x - r, high), "edge")
    page.line((x + r, low), (x + r, high), "edge")
    page.arc((x, low), r, TILT * r, 180, 360, "edge")
    page.arc((x, low), r, TILT * r, 0, 180, "faint")
    page.ellipse((x, high), r, TILT * r, "body")
    page.text((x, high), "top", (0, -5), "upright on")
    page.text((x, 0), "wall", (0, 0), "upright on")
    page.text((x, low), "base", (0, -5), "upright on")
    x, r = -0.8, 1.15
    page.path([(x, 1.4)] + arc_places(x, low, r, 180, 360), "fill", closed=True)
    page.line((x, 1.4), (x - r, low), "edge")
    page.line((x, 1.4), (x + r, low), "edge")
    page.arc((x, low), r, TILT * r, 180, 360, "edge")
    page.arc((x, low), r, TILT * r, 0, 180, "faint")
    page.dot((x, 1.4))
    page.text((x, 1.4), "apex: wall", (0, 12), "upright")
    page.text((x, -0.2), "wall", (0, 0), "upright on")
    page.text((x, low), "base", (0, -5), "upright on")
    x, side, skew = 3.1, 1.7, (0.65, 0.5)
    front = [(x - side / 2 - 0.3, -1.2), (x + side / 2 - 0.3, -1.2), (x + side / 2 - 0.3, 0.6),
             (x - side / 2 - 0.3, 0.6)]
    back = [add(place, skew) for place in front]
    page.path(front, "body", closed=True)
    page.path([front[3], front[2], back[2], back[3]], "body", closed=True)
    page.path([front[1], back[1], back[2], front[2]], "body", closed=True)
    for i in (1, 3):
        page.line(back[0], back[i], "faint")
    page.line(back[0], front[0], "faint")
    page.text(add(front[0], sub(front[2], front[0]), 0.5), "z_max", (0, -5), "upright on")
    page.text(add(front[3], sub(back[2], front[3]), 0.5), "y_max", (0, -5), "upright on")
    page.text(add(front[1], sub(back[2], front[1]), 0.5), "x_max", (26, 2), "upright", "start")
    origin = add(front[0], (-0.75, -0.15))
    for way, name, by in (((0.55, 0), "x", (8, -5)), ((0, 0.55), "y", (0, 6)),
                          ((-0.27, -0.21), "z", (-6, -12))):
        page.arrow(origin, add(origin, way), "thin")
        page.text(add(origin, way), name, by, "faint")
    return page


def stages():
    page = Drawing((700, 520), (350, 0), 1, "The stages of certain and exact",
                   "A query goes down a list. First the shape's filter, in doubles. What it "
                   "leaves uncertain goes to refine: the filter with a discriminant in "
                   "double-double or modulo 2 to the 128. Where the input is out of the "
                   "filter's range both are asked again for the scaled query. What is left is "
                   "decided by exact numbers. Each stage may answer, and for exact the t of an "
                   "answer is rounded.")
    steps = [("query: ray and shape", "src/stages/query.c"),
             ("1: filter, in doubles", "<shape>_filter.h"),
             ("2: refine, double-double or mod 2^128", "<shape>_stages.c"),
             ("3: filter and refine, query scaled", "src/stages/query.c"),
             ("4: exact numbers", "src/stages/last")]
    x, answer = -130, 225
    for i, (words, where) in enumerate(steps):
        y = -50 - 100 * i
        page.box((x, y), (330, 58), "body")
        page.text((x, y), words, (0, 5), "upright on")
        page.text((x, y), where, (0, -17), "upright on")
        if i < len(steps) - 1:
            page.arrow((x, y - 29), (x, y - 71), "ray")
            if i > 0:
                page.text((x, y - 50), "uncertain" if i < 3 else "still uncertain", (10, -5),
                          "ray upright", "start")
        if i > 0:
            page.arrow((x + 165, y), (answer - 75, y), "good")
            page.text((x + 195, y), "certain", (18, 8), "good upright")
    page.box((answer, -300), (150, 360), "body")
    page.text((answer, -285), "status, part", (0, 0), "upright on")
    page.text((answer, -307), "t and its error", (0, 0), "upright on")
    page.text((answer, -329), "(exact: rounded t)", (0, 0), "upright on")
    return page
