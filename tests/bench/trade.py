#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What each tier shows wrong in ordinary frames, and what it costs: the README's first table.

    trade.py ROOT --measure --surehit PROGRAM [OPTION ...]
                          measures, makes the record and its drawing, and fills the pages
    trade.py ROOT --check   are pages and drawing made of the record?
    trade.py ROOT           makes them

The record is docs/trade.json, the drawing docs/trade.svg; the places are <!-- trade --> in
README.md and <!-- trade-bars --> in docs/tracer.md. Extremes are those of the README's other
table. Nothing else should run meanwhile."""
import math
import os
import pathlib
import re
import statistics
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "support"), str(HERE.parents[1] / "docs/drawings")]
import pages  # noqa: E402
import frame_scenes  # noqa: E402
import frames  # noqa: E402
from svg import Drawing  # noqa: E402

TIERS = ["float32", "textbook", "certain", "exact"]
TRUTH, BASE = "exact", "textbook"
# Of tests/scenes; the others are frame_scenes'.
OURS = {"default": "default", "mirrors": "mirrors", "glass": "photons_glass", "inside": "inside"}
SCENES = [*OURS, "S", "M", "L"]
TITLES = {"inside": "eye inside a solid"}
SIZE = f"{frame_scenes.WIDTH}x{frame_scenes.HEIGHT}"
PIXELS = frame_scenes.WIDTH * frame_scenes.HEIGHT

# Bars: most, of `certain`'s frame over `textbook`'s.
MOST = {"default": 1.1, "mirrors": 1.1, "glass": 1.25, "inside": 1.4, "S": 1.1, "M": 1.1, "L": 1.1}


# Scenes.

def objects_alone(text):
    """The scene without light, every object in a colour of its own."""
    lines, count = [], 0
    for line in text.splitlines():
        words = line.split("#")[0].split() if not line.startswith("#!") else ["#!"]
        if words and words[0] == "A":
            line = "A 1 255,255,255"
        elif words and words[0] == "L":
            continue
        elif words and words[0] not in ("R", "C", "#!"):
            plain = [word for word in words if not re.match(r"[a-z]+:", word)]
            line = " ".join([*plain[:-1], ",".join(map(str, frame_scenes.colour_of_object(count)))])
            count += 1
        lines.append(line)
    return "\n".join(lines) + "\n"


class Scenes(frames.Scenes):
    def __init__(self, root, folder):
        super().__init__(folder)
        self.root = root

    def path(self, name, ending="rt", objects=False):
        if name not in OURS:
            return super().path(name, ending, objects)
        path = self.root / f"tests/scenes/{OURS[name]}.rt"
        if objects:
            text = objects_alone(path.read_text(encoding="utf-8"))
            path = pathlib.Path(self.folder) / f"{name}.objects.rt"
            path.write_text(text, encoding="utf-8")
        return str(path)


# Measuring.

def programs(options):
    """Without photons: these are the same in every tier's picture, but for the rays."""
    return {tier: frames.Program(tier, options.surehit, "rt",
                                 f"render {{scene}} -o {{picture}} --quiet --tier {tier} --time "
                                 f"--threads {{threads}} --size {SIZE} --integrator backward", 1)
            for tier in TIERS}


def difference(ours, truth):
    """The largest step of a colour, and the pixels that have one."""
    a, b = frames.pixels_of(ours)[0], frames.pixels_of(truth)[0]
    steps = [(i // 3, abs(x - y)) for i, (x, y) in enumerate(zip(a, b)) if x != y]
    return max((step for _, step in steps), default=0), len({pixel for pixel, _ in steps})


def shown(tiers, scenes, name):
    """By tier: pixels that show another object than the truth, and how far colours are off."""
    result = {}
    lit = {tier: frames.drawn(program, scenes, name) for tier, program in tiers.items()}
    for tier in tiers:
        step, coloured = difference(lit[tier], lit[TRUTH])
        result[tier] = {"step": step, "coloured": coloured}
    seen = {tier: frames.drawn(program, scenes, name, objects=True)
            for tier, program in tiers.items()}
    for tier in tiers:
        result[tier]["other"] = frames.other_objects(seen[tier], seen[TRUTH])[0]
    print(name, result, flush=True)
    return result


def timed(tiers, scenes, names, repeats):
    """By scene and tier: the median of the frame's seconds, and of its ratio to BASE's of the same
    round."""
    rounds = {name: [] for name in names}
    for _ in range(repeats):
        for name in names:
            rounds[name].append({tier: frames.run(program, scenes.path(name),
                                                  scenes.picture(program))["frame"]
                                 for tier, program in tiers.items()})
    return {name: {tier: {"seconds": statistics.median(one[tier] for one in of),
                          "ratio": statistics.median(one[tier] / one[BASE] for one in of)}
                   for tier in tiers} for name, of in rounds.items()}


def memory(program, scenes, name):
    """Objects, and the bytes that they and the hierarchy take, whatever the tier."""
    said = frames.run(program, scenes.path(name), scenes.picture(program))
    return {key: said[key] for key in ("objects", "object_bytes", "hierarchy_bytes")}


def measure(options):
    frames.warn_when_busy()
    scenes, tiers = Scenes(options.root, options.scratch), programs(options)
    names = options.scenes.split(",")
    record = {**frames.machine(options.surehit, options.scratch), "repeats": options.repeats,
              "pictures": {name: shown(tiers, scenes, name) for name in names},
              "memory": {name: memory(tiers[BASE], scenes, name) for name in names}}
    record["times"] = timed(tiers, scenes, names, options.repeats)
    return frames.rounded(record)


# The pages.

def extremes(root):
    """By tier: per cent of wrong answers in the hard regimes, off the README's other table."""
    text = (root / "README.md").read_text(encoding="utf-8").split("<!-- table: ")[1]
    lines = [line.split("|")[2:] for line in text.splitlines() if line.startswith("|")]
    every = next(line for line in text.splitlines() if line.startswith("| all |")).split("|")[2:]
    return {title.split()[0]: wrong.strip() for title, wrong in zip(lines[0], every)
            if "wrong %" in title}


def cell(record, name, tier):
    seen, took = record["pictures"][name][tier], record["times"][name][tier]
    return f"{seen['other']:,} · {seen['step']} · {took['ratio']:.2f}"


def bytes_cell(of):
    return " + ".join(f"{of[key] / of['objects']:.0f}" for key in ("object_bytes",
                                                                   "hierarchy_bytes"))


def trade_table(record, wrong):
    rows = [[f"`{tier}`", wrong[tier],
             *(cell(record, name, tier) for name in record["pictures"])] for tier in TIERS]
    rows.append(["bytes an object", "", *(bytes_cell(of) for of in record["memory"].values())])
    return pages.table(["", "extremes: wrong %", *(TITLES.get(name, name)
                                                   for name in record["pictures"])], rows)


ABOUT = """In each cell: pixels of {pixels:,} that show another object than `exact` · the largest
step of a colour, of 255 · the time of the frame over `textbook`'s (one core of {cpu},
median of {repeats} rounds in turns). S, M and L are
[12, 1,001 and 100,001 objects](docs/tracer.md#what-it-costs-beside-others), glass is drawn without
photons; extremes are answers in the hard regimes, [below](#how-wrong-is-textbook-double). Bytes are
those of objects, with materials and lights, and of the hierarchy.
`meson compile -C build/test trade` measures it anew.

Take `certain` where it matters what is hit, and for pictures anyway: it asks for the rays of pixels
side by side, and these frames take {least:.2f} to {most:.2f} times as long as `textbook`'s. Take
`textbook` where rays are asked one by one, sizes and distances are ordinary and a wrong hit would
be forgiven: in these frames it shows none. Take `exact` where t and normals are to be the true
ones, rounded, or as what others are held against. `float32` shows what single precision does: it is
wrong the more often, the more objects there are, and saves little of a frame, most of which is
[double in every tier](docs/tracer.md#what-stays-double).

![Time against wrong pixels, a panel a scene](docs/trade.svg)
"""


def bars_table(record):
    names = list(record["times"])
    return pages.table(["frame of one core, over `textbook`'s", *(TITLES.get(name, name)
                                                                for name in names)], [
        [f"`{tier}`", *(frames.judged(record["times"][name][tier]["ratio"], MOST[name], least=False)
                        if tier == "certain" else f"{record['times'][name][tier]['ratio']:.2f}"
                        for name in names)] for tier in TIERS if tier != BASE], right=())


# The drawing: a panel a scene, time to the right, wrong pixels upwards.

LOOKS = {"float32": "mark", "textbook": "edge", "certain": "ray", "exact": "good"}
PANEL, HIGH, LEFT, LOW = 104, 250, 84, 70
TIMES = {"½": 0.5, "1": 1, "2": 2, "4": 4, "8": 8}


def rise(pixels):
    return LOW + (HIGH - 20) * (math.log10(pixels) + 1 if pixels else 0) / 7


def across(ratio):
    return 14 + (PANEL - 34) * (math.log2(max(ratio, 0.5)) + 1) / 4.3


def panel(page, left, title, record, name):
    page.line((left, LOW - 14), (left + PANEL - 10, LOW - 14), "thin")
    page.text((left + PANEL / 2 - 5, LOW + HIGH), title, (0, 0), "upright")
    for time, ratio in TIMES.items():
        page.text((left + across(ratio), LOW - 34), time, (0, 0), "upright faint")
    for tier, look in LOOKS.items():
        page.dot((left + across(record["times"][name][tier]["ratio"]),
                  rise(record["pictures"][name][tier]["other"])), look)


def drawing(record):
    names = list(record["times"])
    said = "; ".join(f"{name}: " + ", ".join(
        f"{tier} {record['pictures'][name][tier]['other']} wrong pixels in "
        f"{record['times'][name][tier]['ratio']:.2f} times textbook's time" for tier in TIERS)
        for name in names)
    page = Drawing((LEFT + PANEL * len(names), HIGH + 130), (0, HIGH + 130), 1,
                   "Time against wrong pixels", said)
    for pixels in (0, 1, 10, 100, 1000, 10000, 100000):
        page.text((LEFT - 12, rise(pixels) - 5), f"{pixels:,}", (0, 0), "upright faint", "end")
        page.line((LEFT, rise(pixels)), (LEFT + PANEL * len(names) - 10, rise(pixels)), "faint")
    for i, name in enumerate(names):
        panel(page, LEFT + PANEL * i, {"inside": "eye inside"}.get(name, name), record, name)
    page.text((LEFT, 12), "time over textbook's", (0, 0), "upright", "start")
    page.text((12, LOW + HIGH + 28), "wrong pixels", (0, 0), "upright", "start")
    for i, (tier, look) in enumerate(LOOKS.items()):
        page.dot((LEFT + 230 + 120 * i, 17), look)
        page.text((LEFT + 242 + 120 * i, 12), tier, (0, 0), "upright", "start")
    return page.svg()


def outputs(root, record):
    """By path what it is to hold."""
    ratios = [one["certain"]["ratio"] for one in record["times"].values()]
    about = ABOUT.format(pixels=PIXELS, cpu=record["cpu"], repeats=record["repeats"],
                         least=min(ratios), most=max(ratios))
    filled = {"README.md": {"trade": pages.block(trade_table(record, extremes(root)), about)},
              "docs/tracer.md": {"trade-bars": pages.block(bars_table(record))}}
    made = {root / name: pages.filled((root / name).read_text(encoding="utf-8"), values)
            for name, values in filled.items()}
    return {**made, root / "docs/trade.svg": drawing(record)}


if __name__ == "__main__":
    sys.exit(pages.run(__doc__, "docs/trade.json", outputs, measure, [
        ("surehit", "surehit"), ("scratch", "frames.scratch", "folder of scenes and pictures"),
        ("scenes", ",".join(SCENES)), ("repeats", 15)]))
