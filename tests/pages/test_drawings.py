#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The pages' drawings are what their script draws, can be read by everyone, and are shown; and what
pages call by its path or its name is there. Argument: the source root. Where Chromium is installed,
it says whether letters are on each other."""
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as tree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from browser import CHROMIUM, LEAST_CONTRAST, contrast, values_of  # noqa: E402
from pages import verdict  # noqa: E402
from shapes import SHAPES  # noqa: E402

root = pathlib.Path(sys.argv[1]).resolve()
folder = root / "docs/drawings"
SVG = "{http://www.w3.org/2000/svg}"
PLACES = re.compile(r"`((?:src|include|tests|fuzz|reference|docs)/[\w./-]+)`")
LABELS = ["color", "--ray", "--mark", "--good", "--faint"]  # of letters
ILL_PLACED = """(() => {
    const all = [...document.querySelectorAll('text')].map(e => [e.getBoundingClientRect(), e]);
    const s = document.documentElement.getBoundingClientRect();
    return all.filter(([r]) => r.left < s.left || r.right > s.right || r.top < s.top ||
                               r.bottom > s.bottom).map(([, e]) => e.textContent + ' is cut')
        .concat(all.flatMap(([a, e], i) => all.slice(0, i).filter(([b]) =>
            Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 &&
            Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 0.35 * a.height)
            .map(([, f]) => e.textContent + ' on ' + f.textContent)));
})()"""
SOURCES = [".c", ".cpp", ".h", ".py", ".build", ".def", ".gappa", ".cases", ".hex"]
NAMES = re.compile(r"`([A-Za-z]\w*_\w+?)(_\*|)`")
faults = []


def check_made():
    with tempfile.TemporaryDirectory() as made:
        subprocess.run([sys.executable, str(folder / "draw.py"), made], check=True)
        names = {path.name for path in pathlib.Path(made).iterdir()}
        there = {path.name for path in folder.glob("*.svg")}
        if len(names) < 10 or names != there:
            faults.append(f"docs/drawings: draw.py makes {len(names)} of {len(there)} drawings")
        for name in names & there:
            if (pathlib.Path(made) / name).read_text() != (folder / name).read_text():
                faults.append(f"docs/drawings/{name}: not what draw.py draws")


def colours(style):
    """{name: value} of what the style calls --name, and of its colour."""
    return dict(re.findall(r"(--\w+|\bcolor): (#\w+)", style))


def check_readable(path):
    """By those who see no pictures, in a light and in a dark page."""
    name = path.relative_to(root)
    drawing = tree.parse(path).getroot()
    for kind, least in (("title", 10), ("desc", 60)):
        text = drawing.findtext(SVG + kind, "")
        if len(text) < least:
            faults.append(f"{name}: no {kind}, or one of {len(text)} letters")
    light, _, dark = drawing.findtext(SVG + "style", "").partition("(prefers-color-scheme: dark)")
    light, dark = colours(light), colours(dark)
    if len(light) < 5 or light.keys() != dark.keys() or \
            any(light[key] == dark[key] for key in light):
        faults.append(f"{name}: not a colour for light and another for dark pages: {light} {dark}")
        return
    for mode in light, dark:
        faults.extend(f"{name}: {label} is faint on {ground}: {mode[label]} {mode[ground]}"
                      for label in LABELS for ground in ("--paper", "--body")
                      if contrast(mode[label], mode[ground]) < LEAST_CONTRAST)


def check_places(paths):
    for path, (found,) in zip(paths, values_of(paths, 800, "dark", ILL_PLACED)):
        faults.extend(f"{path.relative_to(root)}: {words}" for words in found)


def check_shown(pages):
    shown = set()
    for page, text in pages.items():
        for words, target in re.findall(r"!\[([^\]]*)\]\(([^)]+)\)", text):
            shown.add((page.parent / target).resolve())
            if len(words) < 3:
                faults.append(f"{page.relative_to(root)}: {target} has no words beside it")
    for path in folder.glob("*.svg"):
        if path not in shown:
            faults.append(f"{path.relative_to(root)}: on no page")


def check_paths(pages):
    count = 0
    for page, text in pages.items():
        for name in PLACES.findall(without_records(text)):
            count += 1
            if not (root / name).exists() and not (root / name).with_suffix("").exists():
                faults.append(f"{page.relative_to(root)}: no such path: {name}")
    if count < 100:
        faults.append(f"only {count} paths were read")


def words_of_code():
    """Of sources, of Gappa's scripts, of files' names; and the functions that macros make."""
    words = {"r_point", "to_double"}  # the notes', CGAL's
    for folder in ("src", "include", "tests", "reference", "fuzz", "docs"):
        for path in (root / folder).rglob("*"):
            if path.suffix in SOURCES:
                words |= {path.stem, *re.findall(r"\w+", path.read_text(encoding="utf-8"))}
    return words | {f"sure_{shape}_{question}_{tier}" for shape in SHAPES
                    for question in ("hit", "interval", "occluded", "normal", "hits")
                    for tier in ("float32", "textbook", "stable", "certain", "exact",
                                 "certain_f", "exact_f")}


def check_names(pages):
    count, words = 0, words_of_code()
    ours = {page: text for page, text in pages.items() if page.parent.name != "gallery"}
    for page, text in ours.items():
        for name, family in NAMES.findall(without_records(text)):
            count += 1
            if not any(word.startswith(name + "_") for word in words) if family \
                    else name not in words:
                faults.append(f"{page.relative_to(root)}: no such name: {name}{family}")
    if count < 300:
        faults.append(f"only {count} names were read")


def without_records(text):
    """What a record says is of its day."""
    return re.sub(r"(?s)<!-- ([\w-]+) -->.*?<!-- /\1 -->", "", text)


pages = {page: page.read_text(encoding="utf-8")
         for page in [root / "README.md", *(root / "docs").rglob("*.md")]}
check_made()
drawings = sorted((root / "docs").rglob("*.svg"))
for svg in drawings:
    check_readable(svg)
if CHROMIUM:
    check_places(drawings)
check_shown(pages)
check_paths(pages)
check_names(pages)
sys.exit(verdict(faults))
