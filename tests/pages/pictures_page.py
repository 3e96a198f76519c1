"""The part of docs/accuracy.md about the extreme scenes, out of docs/pictures.csv and
docs/pictures."""
import csv

from pages import table

TIERS = ["float32", "textbook", "stable", "certain", "exact"]

HEAD = """
## The extreme scenes

Made out of [pictures.csv](pictures.csv), the record of `meson compile -C build pictures`; the
pictures by `meson compile -C build extreme-pictures`.

Every scene of `tests/scenes/extreme`, {pixels} pixels, by each tier. Wrong: pixels that show
another object than the pixel's ray meets first, told by the exact reference. ms: the whole frame,
lights and mirrors too, by one thread; the median of five.
**Pixels of {scenes} scenes that `certain` shows wrong: {certain}.**

"""

COLORS = """
Wrong colours: pixels that differ from `exact`'s by more than the rounding to a level, be it by
another object, a shadow where none is, or a normal that is off. In scenes not named here there are
none.

"""

PICTURES = """
Where tiers part: `float32`, `textbook`, `stable` and `certain`, and below each what is wrong, red
for another object and blue for another colour.
"""


def cells(views, column, show="{:,}"):
    return [show.format(views[tier][column]) for tier in TIERS]


def read_record(path):
    """{scene: {tier: row}}"""
    scenes = {}
    with open(path, newline="", encoding="ascii") as file:
        for row in csv.DictReader(file):
            name, tier = row.pop("scene"), row.pop("tier")
            scenes.setdefault(name, {})[tier] = {key: int(cell) for key, cell in row.items()}
    return scenes


def total(scenes):
    columns = next(iter(scenes.values()))[TIERS[0]]
    return {tier: {column: sum(views[tier][column] for views in scenes.values())
                   for column in columns} for tier in TIERS}


def time_cells(views):
    return [f"{views[tier]['microseconds'] / 1000:.1f}" for tier in TIERS]


def section(docs):
    scenes = read_record(docs / "pictures.csv")
    everything = total(scenes)
    named = [(f"`{name}`", views) for name, views in scenes.items()] + [("all", everything)]
    text = HEAD.format(pixels=f"{next(iter(scenes.values()))['exact']['pixels']:,}",
                       scenes=len(scenes), certain=f"{everything['certain']['wrong']:,}")
    text += table(["scene", f"wrong: {TIERS[0]}", *TIERS[1:], f"ms: {TIERS[0]}", *TIERS[1:]],
                  [[name, *cells(views, "wrong"), *time_cells(views)] for name, views in named])
    text += COLORS
    text += table(["scene", *TIERS], [[name, *cells(views, "wrong_color")] for name, views in named
                                      if any(views[tier]["wrong_color"] for tier in TIERS)])
    drawn = sorted(path.stem for path in (docs / "pictures").glob("*.png") if path.stem in scenes)
    if drawn:
        text += PICTURES
    return text + "".join(f"\n`{name}`\n\n![{name} by four tiers](pictures/{name}.png)\n"
                          for name in drawn)
