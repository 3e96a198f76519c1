#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The three tracers on a matte, a mirror and a glass scene, for docs/forward.md.

    forward_page.py ROOT --measure --surehit PROGRAM --error PROGRAM --agreement PROGRAM
                          draws the pictures (docs/pictures/photons_*.png), measures, makes the
                          record and fills the page
    forward_page.py ROOT --check   is the page filled by the record?
    forward_page.py ROOT           fills the page

The record is docs/forward.json; the places stand between comments of docs/forward.md. Measuring
takes about ten minutes of two cores, on which nothing else should run."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import pages  # noqa: E402
from pages import block, table  # noqa: E402

SCENES = ["matte", "mirror", "glass"]
TRACERS = ["backward", "forward", "mixed"]
PHOTONS = 10_000_000  # of a forward picture
OPENING = 0.05        # of the eye, in the scenes' units
TRUTH = 1_000_000_000  # photons, unless --truth says otherwise
TITLES = {"matte": "matte", "mirror": "a mirrored cylinder", "glass": "a ball of glass"}

PHOTONS_LEAST_SECONDS = 20  # bar: ten million of them in scene S
ERROR_SHARE = 0.1           # bar: mixed, of forward's


def run(*words):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True,
                          text=True).stdout


# Measuring.

def scene_of(root, name):
    return root / f"tests/scenes/photons_{name}.rt"


def picture_of(name, tracer):
    return f"pictures/photons_{name}_{tracer}.png"


def draw(options, scene, picture, *words):
    said = run(options.surehit, "render", scene, "-o", picture, "--quiet", "--time", *words)
    return json.loads(said)


def forward_words(*more):
    return ["--integrator", "forward", "--photons", PHOTONS, "--bounces", 1, *more]


def pictures_of(options, name):
    words = {"backward": ["--integrator", "backward"], "mixed": ["--integrator", "mixed"],
             "forward": forward_words()}
    return {tracer: draw(options, scene_of(options.root, name),
                         options.root / "docs" / picture_of(name, tracer), *words[tracer])
            for tracer in TRACERS}


def opening_of(options, name):
    with tempfile.TemporaryDirectory() as folder:
        return draw(options, scene_of(options.root, name), pathlib.Path(folder) / "x.png",
                    *forward_words("--aperture", OPENING))


def error_of(options, name):
    measured = json.loads(run(options.error, scene_of(options.root, name), options.truth, 2))
    del measured["scene"]  # a path of this machine
    return measured


def scene_s(options):
    """The scene of the frames' table, with light that falls off."""
    with tempfile.TemporaryDirectory() as folder:
        run(sys.executable, options.root / "tests/bench/frame_scenes.py", folder, "S")
        path = pathlib.Path(folder)
        return draw(options, path / "S.rt", path / "S.png", "--integrator", "forward", "--photons",
                    PHOTONS, "--falloff", "inverse-square")


def agreement(options):
    """What the test prints: the tiles, and a line for each number of photons."""
    said = run(options.agreement)
    tiles = re.search(r"(\d+) tiles and colours, (\d+) photons: at most ([\d.]+) sigma apart "
                      r"\(limit ([\d.]+)\)", said)
    falls = re.findall(r"(\d+) photons, +(\d+) runs: error ([\d.]+), times root N ([\d.]+), "
                       r"expected ([\d.]+)", said)
    return {"tiles": [float(number) for number in tiles.groups()],
            "falls": [[float(number) for number in line] for line in falls]}


def measure(options):
    return {"photons": PHOTONS, "opening": OPENING, "truth": options.truth,
            "scenes": {name: {"pictures": pictures_of(options, name),
                              "opening": opening_of(options, name),
                              "error": error_of(options, name)} for name in SCENES},
            "S": scene_s(options), "agreement": agreement(options)}


# The page.

def gallery():
    rows = [[TITLES[name], *(f"![{TITLES[name]}, {tracer}]({picture_of(name, tracer)})"
                             for tracer in TRACERS)] for name in SCENES]
    return table(["", *TRACERS], rows)


def per_million(count, of):
    share = 1e6 * count / of
    return f"{share:,.0f}" if count == 0 or share >= 1 else f"{share:.1g}"


ENDS = [("lit", "points of matte surfaces lit"), ("escaped", "escaped"),
        ("through", "passed the view plane"), ("reached", "reached the eye")]


def economy(record):
    rows = []
    for key, title in ENDS:
        rows.append([title] + [per_million(record["scenes"][name][way][key], record["photons"])
                               for name in SCENES for way in ("forward", "opening")])
    return table(["of a million photons"] + [f"{name}, {way}" for name in SCENES
                                             for way in ("pinhole", "opening")], rows)


def flat(record):
    """The economy reads the forward picture as it reads the opening's."""
    for name in SCENES:
        record["scenes"][name]["forward"] = record["scenes"][name]["pictures"]["forward"]
    return record


def number(value):
    return f"{value:.3g}" if value < 1000 else f"{value:,.0f}"


def noise(record):
    rows = []
    for name in SCENES:
        of = record["scenes"][name]
        rows.append([TITLES[name]] + [number(of[way]["variance_seconds"])
                                      for way in ("forward", "opening")])
    return table(["variance of a pixel's mean, times seconds", "pinhole",
                  f"opening {record['opening']}"], rows)


def judged(value, bar, holds):
    text = f"{number(value)} ({bar})"
    return text if holds else f"**{text}**"


def errors(record):
    rows = []
    for name in SCENES:
        of = record["scenes"][name]["error"]
        share = of["mixed_error"] / of["forward_error"]
        rows.append([TITLES[name], number(of["mixed_seconds"]), number(of["forward_photons"]),
                     number(of["mixed_error"]), number(of["forward_error"]),
                     judged(share, f"≤ {ERROR_SHARE}", share <= ERROR_SHARE)])
    return table(["", "seconds", "forward: photons in that time", "mean squared error, mixed",
                  "forward", "share"], rows)


def falls(record):
    rows = [[f"{n:,.0f}", f"{runs:.0f}", f"{error:.4g}", f"{one:.4g}", f"{expected:.4g}"]
            for n, runs, error, one, expected in record["agreement"]["falls"]]
    return table(["photons", "runs", "error", "error times √N", "expected"], rows)


def page_values(record):
    """What fills the page."""
    tiles, of_photons, worst, limit = record["agreement"]["tiles"]
    seconds = record["S"]["frame"]
    flat(record)
    return {"gallery": block(gallery()), "photons": f"{record['photons']:,}",
            "opening": record["opening"], "economy": block(economy(record)),
            "noise": block(noise(record)), "errors": block(errors(record)),
            "seconds": judged(seconds, f"≤ {PHOTONS_LEAST_SECONDS}",
                              seconds <= PHOTONS_LEAST_SECONDS),
            "truth": f"{record['truth']:,}", "tiles": f"{tiles:.0f}", "worst": worst,
            "tile-photons": f"{of_photons:,.0f}", "limit": limit, "falls": block(falls(record))}


def outputs(root, record):
    page = root / "docs/forward.md"
    return {page: pages.filled(page.read_text(encoding="utf-8"), page_values(record))}


if __name__ == "__main__":
    sys.exit(pages.run(__doc__, "docs/forward.json", outputs, measure, [
        ("surehit", ""), ("error", ""), ("agreement", ""), ("truth", TRUTH, "photons")]))
