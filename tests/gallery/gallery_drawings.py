# SPDX-License-Identifier: MIT
"""The drawings of docs/gallery.md: how wrong decisions grow with the distance, and the worst cases
as the ray sees them."""
import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../docs/drawings"))
from svg import Drawing  # noqa: E402

ACROSS, WIDE, HIGH = 4, 210, 190
LEFT, LOW, PANEL = 40, 44, (150, 100)
LOOKS = {"sphere": "ray", "cylinder": "mark", "cone": "good", "disc": "edge", "box": "within"}
MOST = 60  # per cent, at the panel's top


def grid(count, title, about, head):
    rows = math.ceil(count / ACROSS)
    return Drawing((ACROSS * WIDE, rows * HIGH + head), (0, rows * HIGH + head), 1, title, about)


def corner(page, index, head):
    """Of the panel, at the lower left."""
    return (index % ACROSS * WIDE, page.size[1] - head - (index // ACROSS + 1) * HIGH)


# How wrong decisions grow.

def curve(distances, steps):
    for distance, (valid, wrong) in zip(distances, steps):
        if valid:
            yield (math.log10(distance), 100 * wrong / valid)


def far_panel(page, place, name, adapter, distances):
    def at(powers, wrong):
        return (place[0] + LEFT + PANEL[0] * (powers - 1) / 8,
                place[1] + LOW + PANEL[1] * min(wrong, MOST) / MOST)

    for wrong in (0, 30, 60):
        page.line(at(1, wrong), at(9, wrong), "faint")
        page.text(at(1, wrong), f"{wrong}", (-6, -4), "upright faint", "end")
    for powers in (1, 3, 5, 7, 9):
        page.text(at(powers, 0), f"1e{powers}", (0, -18), "upright faint")
    page.text(at(5, MOST), name, (0, 10), "upright")
    for shape, found in adapter["shapes"].items():
        for steps, look in ((found.get("control_ladder"), "thin"),
                            (found.get("ladder"), LOOKS.get(shape))):
            places = [at(*step) for step in curve(distances, steps or [])]
            if places:
                page.path(places, look)


def far(record):
    shown = {name: adapter for name, adapter in record["adapters"].items()
             if any("ladder" in found for found in adapter["shapes"].values())}
    said = "; ".join(f"{name} {shape}: " + ", ".join(
        f"{wrong:.2g} % at 1e{power:g}" for power, wrong in
        curve(record["distances"], found["ladder"]) if power == int(power))
        for name, adapter in shown.items() for shape, found in adapter["shapes"].items()
        if "ladder" in found)
    head = 40
    page = grid(len(shown), "Wrong by more than 1 % of the object, by the distance", said, head)
    for i, (name, adapter) in enumerate(shown.items()):
        far_panel(page, corner(page, i, head), name, adapter, record["distances"])
    top = page.size[1] - 24
    for i, (shape, look) in enumerate([*LOOKS.items(), ("control", "thin")]):
        page.line((20 + 130 * i, top + 5), (50 + 130 * i, top + 5), look)
        page.text((56 + 130 * i, top), shape, (0, 0), "upright", "start")
    return page.svg()


# Worst cases.

def dot(p, q):
    return sum(a * b for a, b in zip(p, q))


def cross(p, q):
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def add(p, q, times=1.0):
    return [a + times * b for a, b in zip(p, q)]


def scaled(p, length=1.0):
    most = max(map(abs, p))  # its square may be 0, or none
    return [a / most * length / math.hypot(*(b / most for b in p)) for a in p]


def beside(axis):
    """Two directions of length 1, across the axis and each other."""
    least = min(range(3), key=lambda i: abs(axis[i]))
    first = scaled(cross(axis, [float(i == least) for i in range(3)]))
    return first, scaled(cross(axis, first))


def circle(centre, axis, radius):
    u, v = beside(axis)
    return [add(add(centre, u, radius * math.cos(turn)), v, radius * math.sin(turn))
            for turn in (2 * math.pi * i / 72 for i in range(72))]


def sphere(n, along):
    return circle(n[:3], along, n[3])


def disc(n, _):
    return circle(n[:3], n[3:6], n[6])


def cylinder(n, _):
    return circle(n[:3], n[3:6], n[6]) + circle(add(n[:3], n[3:6]), n[3:6], n[6])


def cone(n, _):
    return circle(n[:3], n[3:6], n[6]) + [add(n[:3], n[3:6])]


def box(n, _):
    return [[n[i] + n[3 + i] * (1 if corner >> i & 1 else -1) for i in range(3)]
            for corner in range(8)]


# Places whose convex hull, seen along the ray, is the object's outline.
OUTLINES = {"sphere": sphere, "disc": disc, "cylinder": cylinder, "cone": cone, "box": box}


def hull(places):
    """Anticlockwise."""
    places = sorted(set(places))

    def chain(those):
        found = []
        for place in those:
            while len(found) > 1 and (
                    (found[-1][0] - found[-2][0]) * (place[1] - found[-2][1]) <=
                    (found[-1][1] - found[-2][1]) * (place[0] - found[-2][0])):
                found.pop()
            found.append(place)
        return found[:-1]

    return chain(places) + chain(places[::-1])


def number(word):
    return math.inf if word == "inf" else float.fromhex(word)


def outline(case):
    """The object as the ray sees it, the ray being the origin; in units of the picture's half."""
    shape, *words = case.split()
    numbers = [number(word) for word in words]
    origin, along = numbers[:3], scaled(numbers[3:6])
    u, v = beside(along)
    seen = [(dot(add(place, origin, -1), u), dot(add(place, origin, -1), v))
            for place in OUTLINES[shape](numbers[8:], along)]
    size = max(math.hypot(*place) for place in seen)
    return hull([(x / size, y / size) for x, y in seen])


def worst_panel(page, place, name, shape, one):
    middle = (place[0] + WIDE / 2, place[1] + 92)
    edge = [(middle[0] + 62 * x, middle[1] + 62 * y) for x, y in outline(one["case"])]
    page.path(edge, "body", closed=True)
    page.dot(middle, "mark")
    page.text((middle[0], place[1] + 162), name, (0, 0), "upright")
    page.text((middle[0], place[1] + 12), f"{shape}: {one['answer'].split()[0]}, not "
              f"{one['right'].split()[0]}", (0, 0), "upright faint")


def worst(record, least):
    shown = [(name, shape, found["worst"]) for name, adapter in record["adapters"].items()
             for shape, found in adapter["shapes"].items()
             if shape in OUTLINES and found["worst"] and found["worst"]["margin"] > least]
    said = "; ".join(f"{name}, {shape}: {one['right'].split()[0]} expected, got "
                     f"{one['answer'].split()[0]}" for name, shape, one in shown)
    page = grid(len(shown), "The worst case of each, as the ray sees the object", said, 0)
    for i, (name, shape, one) in enumerate(shown):
        worst_panel(page, corner(page, i, 0), name, shape, one)
    return page.svg()
