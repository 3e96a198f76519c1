# SPDX-License-Identifier: MIT
"""The part of docs/accuracy.md about the extreme scenes, out of docs/pictures.csv and
docs/pictures."""
import csv

from pages import block, table

TIERS = ["float32", "textbook", "stable", "certain", "exact"]


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


def values(docs):
    """What fills the page."""
    scenes = read_record(docs / "pictures.csv")
    everything = total(scenes)
    named = [(f"`{name}`", views) for name, views in scenes.items()] + [("all", everything)]
    drawn = sorted(path.stem for path in (docs / "pictures").glob("*.png") if path.stem in scenes)
    return {
        "pixels": f"{next(iter(scenes.values()))['exact']['pixels']:,}", "scenes": len(scenes),
        "certain": f"{everything['certain']['wrong']:,}",
        "pictures": block(table(
            ["scene", f"wrong: {TIERS[0]}", *TIERS[1:], f"ms: {TIERS[0]}", *TIERS[1:]],
            [[name, *cells(views, "wrong"), *time_cells(views)] for name, views in named])),
        "colours": block(table(
            ["scene", *TIERS], [[name, *cells(views, "wrong_color")] for name, views in named
                                if any(views[tier]["wrong_color"] for tier in TIERS)])),
        "shown": block(*(f"`{name}`\n\n![{name} by four tiers](pictures/{name}.png)\n"
                         for name in drawn))}
