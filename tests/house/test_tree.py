#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The house keeps its shape: every stem has all its siblings, and includes point one way.

Argument: the source root. Fails with a list of what is missing or points the wrong way."""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import register  # noqa: E402
from pages import verdict  # noqa: E402

root = pathlib.Path(sys.argv[1]).resolve()
faults = []

# Rooms of src/ and the frozen peers of reference/, and the rooms that each may include.
BELOW = {
    "numbers": [],
    "geometry": ["numbers"],
    "shapes": ["numbers", "geometry", "stages"],
    "stages": ["numbers"],
    "shading": ["numbers", "geometry"],
    "support": [],
    "scene": ["support"],
    "image": ["support"],
    "hierarchy": ["numbers", "support"],
    "tracer": ["numbers", "geometry", "support", "scene", "image", "hierarchy", "stages", "shapes"],
    "photons": ["numbers", "geometry", "support", "scene", "image", "hierarchy", "tracer"],
    "evidence": ["numbers", "support", "scene", "image", "hierarchy", "tracer"],
    "regress": ["support", "scene", "image", "photons"],
    "cases": ["numbers", "geometry", "support"],
    "judge": ["cases", "numbers", "geometry", "support", "peers"],
    "peers": [],
    "controls": ["peers"],
    "report": ["cases", "judge", "support", "scene", "image", "tracer", "photons"],
    "wasm": ["support", "scene", "image", "hierarchy", "tracer", "photons", "evidence", "cases",
             "judge"],
    "cli": ["support", "scene", "image", "hierarchy", "tracer", "photons", "evidence",
            "regress", "cases", "judge", "report"],
    "python": ["cases", "judge", "cli"],
}


def room_of(path):
    parts = path.relative_to(root).parts
    return parts[1] if parts[0] == "src" or parts[1] in ("peers", "controls") else parts[0]


def check_circles(name, arrows):
    """Takes away the rooms that reach none of the others, until none is left."""
    left = {room: set(below) - {room} for room, below in arrows.items()}
    while ends := [room for room, below in left.items() if not below & left.keys()]:
        for room in ends:
            del left[room]
    if left:
        faults.append(f"{name}: rooms in a circle, or above one: {', '.join(sorted(left))}")


def check_includes():
    count = 0
    used = {}
    for path in sorted(p for top in ("src", "include", "reference") for p in (root / top).rglob("*")
                       if p.suffix in (".c", ".h", ".cpp")):
        for name in re.findall(r'^#include "([^"]+)"', path.read_text(), re.M):
            count += 1
            target = (path.parent / name).resolve()
            if not target.is_file():  # found through an include path: the rooms beside cli
                homes = [home for home in (root / "src").rglob(name) if room_of(home) != "cli"]
                target = homes[0] if len(homes) == 1 else None
            if target is None:
                faults.append(f'{path.relative_to(root)}: "{name}" is nowhere')
                continue
            here, there = room_of(path), room_of(target)
            used.setdefault(here, set()).add(there)
            if here != there and there not in BELOW.get(here, []):
                faults.append(f"{path.relative_to(root)}: {here} must not include {there} ({name})")
    if count < 50:
        faults.append(f"only {count} includes were read")
    check_circles("BELOW", BELOW)
    check_circles("includes", used)


def closure(*sources):
    """What these sources include of the project, themselves too."""
    seen, ahead = set(), [root / source for source in sources]
    while ahead:
        path = ahead.pop()
        if path not in seen:
            seen.add(path)
            for own, public in re.findall(r'^#include (?:"([^"]+)"|<(surehit/[^>]+)>)',
                                          path.read_text(), re.M):
                ahead.append((path.parent / own).resolve() if own else root / "include" / public)
    return seen


def check_closure():
    """A sphere's ray, from the public header to the exact stage, fits in a reader's head."""
    files = closure("src/shapes/sphere/sphere_stages.c", "src/stages/stages.c")
    lines = sum(len(path.read_text().splitlines()) for path in files)
    if not 10 < len(files) <= 25 or not 1000 < lines <= 2600:
        faults.append(f"sphere_stages.c and stages.c include {len(files)} files, {lines} lines")


def check_links():
    """Relative links of the pages lead somewhere."""
    count = 0
    pages = [root / "README.md", root / "CHANGELOG.md", *(root / "docs").rglob("*.md")]
    for page in pages:
        for target in re.findall(r"\]\(([^)#:]+)\)", page.read_text()):
            count += 1
            if not (page.parent / target).exists():
                faults.append(f"{page.relative_to(root)}: {target} is nowhere")
    if count < 20:
        faults.append(f"only {count} links were read")


def check_widths():
    """No line of code is wider than 100 columns."""
    count = 0
    for path in sorted(p for top in ("src", "include", "reference", "tests", "fuzz") for p in
                       (root / top).rglob("*") if p.suffix in (".c", ".h", ".cpp", ".py")):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            count += 1
            if len(line) > 100:
                faults.append(f"{path.relative_to(root)}:{number}: {len(line)} columns")
    if count < 10000:
        faults.append(f"only {count} lines were read")


def check_coordinates():
    """No index goes beyond a vector's x: C knows no array there, and clang makes use of that."""
    beyond = re.compile(r"\(&[^()]*\b(x|origin\[0\])\)\[|&[\w>.\[\]-]*\bx \+ ")
    for room in ("src", "include", "reference", "tests", "fuzz"):
        for path in sorted((root / room).rglob("*.[ch]")):
            for number, line in enumerate(path.read_text().splitlines(), 1):
                if beyond.search(line):
                    faults.append(f"{path.relative_to(root)}:{number}: an index beyond x; "
                                  "src/geometry/coordinate.h has coordinate and coordinate_of")


def check_sizes():
    """No source has more than 400 lines, and no folder more than 20 files."""
    folders = [path for path in (root / "src").rglob("*")
               if path.is_dir() and path.name != "__pycache__"]
    for folder in folders:
        files = [path for path in folder.iterdir() if path.is_file()]
        if len(files) > 20:
            faults.append(f"{folder.relative_to(root)}: {len(files)} files")
        for path in files:
            lines = len(path.read_text().splitlines())
            if lines > 400:
                faults.append(f"{path.relative_to(root)}: {lines} lines")
    if len(folders) < 20:
        faults.append(f"only {len(folders)} folders were read")


def check_licences():
    """Each source says its licence, by which it may leave the house."""
    count = 0
    for top in ("src", "include", "tests", "fuzz", "reference", "docs"):
        for path in (root / top).rglob("*.*"):
            if path.suffix not in (".c", ".h", ".cpp", ".hpp", ".def", ".py", ".sh", ".js", ".mjs",
                                   ".cjs", ".ts", ".pyi", ".rs", ".glsl"):
                continue
            if {"node_modules", "__pycache__"} & {*path.parts} or path.is_symlink():
                continue
            count += 1
            if not any("SPDX-License-Identifier: MIT" in line
                       for line in path.read_text().splitlines()[:2]):
                faults.append(f"{path.relative_to(root)}: no SPDX line")
    if count < 700:
        faults.append(f"only {count} sources were read")


def check_shapes():
    """No code asks which shape an object has: what differs stands in the shapes' rows. The table
    itself makes the one choice."""
    asked = re.compile(r"\bcase SURE_SHAPE_|[=!]= *SURE_SHAPE_(?!NUMBERS)|SURE_SHAPE_[A-Z]+ *[=!]=")
    count = 0
    for path in sorted(p for top in ("src", "fuzz") for p in (root / top).rglob("*.[ch]")):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            count += "SURE_SHAPE_" in line
            if asked.search(line) and path != root / "src/shapes/shapes.c":
                faults.append(f"{path.relative_to(root)}:{number}: a comparison on the shape")
    if count < 20:
        faults.append(f"only {count} lines name a shape")


def check_gallery():
    """Programs about libraries are short, the licence's line apart, and know nothing of surehit."""
    programs = [path for path in (root / "reference/gallery").iterdir() if path.suffix != ".patch"]
    for path in programs:
        lines = path.read_text().splitlines()
        if len(lines) > 21 or "sure" in " ".join(lines):
            faults.append(f"{path.relative_to(root)}: more than 20 lines, or a word of surehit")
    if len(programs) < 10:
        faults.append(f"only {len(programs)} programs of the gallery were read")


tree = register.Tree(root)
faults += register.faults(tree)
faults += register.unnoticed(tree)
check_includes()
check_closure()
check_links()
check_widths()
check_coordinates()
check_sizes()
check_licences()
check_shapes()
check_gallery()
sys.exit(verdict(faults))
