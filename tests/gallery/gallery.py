#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Libraries that engineers use, judged: docs/gallery.md, out of its record, docs/gallery.json.

    gallery.py ROOT --measure --surehit PROGRAM --build FOLDER   judges, makes record and pages
    ... --only 'povray embree-float'                             the record of these alone
    gallery.py ROOT --check                                      are the pages the record's?
    gallery.py ROOT                                              makes them

The adapters are those of reference/peers/libraries that are built. Each is asked of each of its
shapes, under its own entry; a control that is right about what it is handed is asked the same."""
import ctypes
import json
import math
import multiprocessing.pool
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(HERE.parent / "support"), str(HERE)]
import gallery_page  # noqa: E402
import pages  # noqa: E402

COUNT, COUNT_OF_HARD, COUNT_OF_LADDER = 10000, 300, 1000
# Regimes that are not hard; with objects that are points; and pictures, which take long to make.
NOT_HARD = ["camera", "typical", "degenerate", "bits", "integers"]
DISTANCES = [10.0 ** (power / 2) for power in range(2, 19)]
FARTHEST = 1e10
BY_POINTS = ["bullet", "vtk"]  # whose interface is a segment's two points
SOLIDS = {  # of size 1 around the origin; the ladder's
    "sphere": [0, 0, 0, 1],
    "disc": [0, 0, 0, 0, 0, 1, 1],
    "cylinder": [0, 0, -1, 0, 0, 2, 1],
    "cone": [0, 0, -1, 0, 0, 2, 1],
    "box": [0, 0, 0, 1, 1, 1],
}


# Asking.

class Judge:
    def __init__(self, surehit, folder):
        self.surehit, self.folder = surehit, folder

    def ask(self, *words):
        """What it says as JSON. Broken promises are none of ours, but it has to be able to ask."""
        with tempfile.TemporaryDirectory(dir=self.folder) as folder:
            path = pathlib.Path(folder) / "verdict.json"
            done = subprocess.run([self.surehit, "judge", *words, "--json", path], check=False,
                                  capture_output=True)  # what dies says much
            if done.returncode != 0:
                sys.exit(done.stderr.decode(errors="replace"))
            return json.loads(path.read_text(encoding="utf-8"))


def entry_of(path):
    """As the library declares it; read in a process of its own."""
    with multiprocessing.pool.Pool(1) as pool:
        return pool.apply(declared, (str(path),))


def declared(path):
    library = ctypes.CDLL(path)
    try:
        return ctypes.string_at(ctypes.addressof(
            ctypes.c_char.in_dll(library, "sure_candidate_entry"))).decode()
    except ValueError:
        return ""


def under(entry):
    return ["--entry", entry] if entry else []


def within(entry, least, most, *more):
    """The entry, and these words; sizes and ways from the one to the other, or fewer."""
    words = [word for word in entry.split() if not word.startswith("scale=")]
    for word in entry.split():
        if word.startswith("scale="):
            low, high = map(float, word[6:].split(".."))
            least, most = max(least, low), min(most, high)
    words += [word for word in more if word not in words]
    return " ".join([*words, f"scale={least:g}..{most:g}"])


def ordinary_entry(entry):
    return within(entry, 0.2, 100, "outside")


def hard_entry(entry):
    """Asked for are neither tolerances of surfaces, nor overflow, nor objects far off."""
    frame = [] if "local" in entry.split() else ["centred"]
    return within(entry, 1e-3, 1e6, "unit", "apart=1e-6", *frame)


def control_entry(entry):
    """The same, but in the control's frame."""
    words = [word for word in entry.split() if word not in ("aligned", "centred", "local", "unit")]
    return " ".join(["unit local t_min=0", *words])


def beyond_scale(entry):
    """The entry for the ladder, which goes on where an adapter has chosen an end of distances."""
    return " ".join(word.split("..")[0] + f"..{FARTHEST:g}" if word.startswith("scale=") else word
                    for word in entry.split())


def ladder_cases(shape, distance):
    """Rays from that far at a place near the solid: half of them hit, more or less."""
    rng = random.Random(f"{shape} {distance}")
    for _ in range(COUNT_OF_LADDER):
        way = [rng.gauss(0, 1) for _ in range(3)]
        origin = [distance * x / math.hypot(*way) for x in way]
        ray = [*origin, *(rng.uniform(-1.2, 1.2) - x for x in origin), 0, math.inf]
        yield " ".join([shape, *(float(x).hex() if math.isfinite(x) else "inf" for x in
                                 [*ray, *SOLIDS[shape]])])


# What is kept of a verdict.

def counts(rows):
    beyond = {}
    for row in rows:
        for one in row["margins"]["wrong"]:
            beyond[f"{one['beyond']:g}"] = beyond.get(f"{one['beyond']:g}", 0) + one["wrong"]
    return {"valid": sum(row["valid"] for row in rows), "wrong": sum(row["wrong"] for row in rows),
            "outside": sum(row["skipped"] for row in rows), "beyond": beyond,
            "most": max((row["margins"]["most"] for row in rows), default=0)}


def ordinary_of(said):
    row = said["rows"][0]
    return {**counts(said["rows"]), "hits": row["hits"], "t_99": row["t_relative"]["99"],
            "t_most": row["t_relative"]["most"], "nanoseconds": row["nanoseconds"]}


def worst_of(*said):
    """Of pairs of a verdict and its entry the decision that is wrong by the largest margin."""
    found = [{**one, "entry": entry} for verdict, entry in said for one in verdict["worst"]
             if one.get("margin")]
    return max(found, key=lambda one: one["margin"], default=None)


TABLE = pathlib.Path("reference/peers/libraries/libraries.txt")


class Adapter:
    """One library in one build: `subject` is how the judge is told of it."""

    def __init__(self, name, library, package, subject, entry, build, version=None, command=None):
        self.name, self.library, self.package = name, library, package
        self.subject, self.entry = subject, entry
        self.version, self.command = version, command
        self.by_points = name.split("-")[0] in BY_POINTS
        kind = "points-" if self.by_points else ""
        kind += "float" if "float" in [*entry.split(), *name.split("-")] else "double"
        self.control = ["--candidate", str(build / f"reference/controls/libcontrol-{kind}.so")]

    def ladder(self, judge, subject, entry, shapes):
        """By shape, of each distance: valid cases, and those wrong by more than 1 % of it."""
        steps = {shape: [] for shape in shapes}
        for distance in DISTANCES if shapes else []:
            with tempfile.NamedTemporaryFile("w", dir=judge.folder, suffix=".cases") as file:
                file.write("\n".join(line for shape in shapes
                                     for line in ladder_cases(shape, distance)) + "\n")
                file.flush()
                said = judge.ask("--cases", file.name, *subject, *under(entry))
            for shape in shapes:
                found = counts([row for row in said["rows"] if row["shape"] == shape])
                steps[shape].append([found["valid"], found["beyond"].get("0.01", 0)])
        return steps

    def ordinary(self, judge, shape):
        return judge.ask(*self.subject, "--shape", shape, "--regime", "typical", "--count",
                         str(COUNT), *under(ordinary_entry(self.entry)))

    def judged(self, judge, shape):
        hard = [word for regime in judge.hard for word in ("--regime", regime)]
        hard += ["--count", str(COUNT_OF_HARD), "--shape", shape]
        ordinary = self.ordinary(judge, shape)
        entry = hard_entry(self.entry)
        own = judge.ask(*self.subject, *hard, "--entry", entry)
        control = judge.ask(*self.control, *hard, "--entry", control_entry(entry))
        return {"ordinary": ordinary_of(ordinary), "hard": counts(own["rows"]),
                "control": counts(control["rows"]),
                "worst": worst_of((own, entry), (ordinary, ordinary_entry(self.entry)))}

    def verdict(self, judge):
        said = judge.ask(*self.subject, "--regime", "typical", "--count", "10")
        shapes = [row["shape"] for row in said["rows"]]
        print(f"{self.name} {self.version or said['version']}: {', '.join(shapes)}", flush=True)
        found = {shape: {**self.judged(judge, shape),
                         "conventions": said["conventions"].get(shape, {})} for shape in shapes}
        solids = [shape for shape in shapes if shape in SOLIDS]
        far = beyond_scale(self.entry)
        for key, subject, entry in (("ladder", self.subject, far),
                                    ("control_ladder", self.control, control_entry(far))):
            for shape, steps in self.ladder(judge, subject, entry, solids).items():
                found[shape][key] = steps
        return {"library": self.library, "package": self.package, "entry": self.entry,
                "by_points": self.by_points,
                "version": self.version or said["version"], "command": self.command,
                "shapes": found}


def listed(root):
    """Each row of the table of adapters: its name, library and package."""
    table = (root / TABLE).read_text(encoding="utf-8")
    for line in table.splitlines():
        if not line.startswith("#"):
            yield [field.strip() for field in line.split("|")[:3]]


def compiled(root, build):
    """What meson has built, and programs that are beside, whose library is installed."""
    folder = TABLE.parent
    for name, library, package in listed(root):
        path = build / folder / f"libpeer-{name}.so"
        if path.exists():
            yield Adapter(name, library, package, ["--candidate", str(path)], entry_of(path), build)
        elif (root / folder / f"{name}.py").exists() and shutil.which(name):
            yield of_program("python3", folder / f"{name}.py", root, build, package)


def adapters(root, build):
    build = pathlib.Path(build).resolve()
    return [*compiled(root, build), *of_npm(root, build)]


def of_program(language, path, root, build, package):
    """It says itself what it is."""
    about = json.loads(subprocess.run([language, root / path, "--about"], check=True, text=True,
                                      capture_output=True).stdout)
    return Adapter(path.stem, about["library"], package,
                   ["--keep", "--command", f"{language} {root / path}", "--time-limit", "60"],
                   about["entry"], build, about["version"], f"{language} {path}")


def of_npm(root, build):
    """Where `npm ci` has put them."""
    folder = pathlib.Path("reference/peers/libraries/node")
    for path in sorted((root / folder).glob("*.mjs")):
        if path.stem != "coprocess" and (root / folder / "node_modules").exists():
            yield of_program("node", folder / path.name, root, build, "npm")


def rounded(value):
    """To the three digits that are shown."""
    if isinstance(value, dict):
        return {key: rounded(part) for key, part in value.items()}
    if isinstance(value, list):
        return [rounded(part) for part in value]
    return float(f"{value:.3g}") if isinstance(value, float) else value


def measured(options):
    with tempfile.TemporaryDirectory(prefix="gallery.") as folder:
        judge = Judge(options.surehit, folder)
        said = subprocess.run([options.surehit, "judge", "--help"], check=True, text=True,
                              capture_output=True).stdout
        regimes = said.split("Regimes:")[1].split("Sets")[0].split()
        judge.hard = [regime for regime in regimes if regime not in NOT_HARD]
        every = [one for one in adapters(options.root, options.build)
                 if not options.only or one.name in options.only.split()]
        with multiprocessing.pool.ThreadPool(os.cpu_count()) as pool:
            found = pool.map(lambda one: one.verdict(judge), every, chunksize=1)
    return rounded({"count": COUNT, "count_of_hard": COUNT_OF_HARD, "regimes": judge.hard,
                    "distances": DISTANCES, "count_of_ladder": COUNT_OF_LADDER,
                    "adapters": {one.name: what for one, what in zip(every, found)}})


def measure(options):
    """Where only some are, the others stay as they were, each in its place."""
    record = measured(options)
    path = options.root / "docs/gallery.json"
    if options.only:
        of = record["adapters"]
        missing = set(options.only.split()) - of.keys()
        if missing:
            sys.exit(f"not built: {' '.join(sorted(missing))}")
        of = {**json.loads(path.read_text(encoding="utf-8"))["adapters"], **of}
        order = [name for name, *_ in listed(options.root)]  # and those of npm behind
        place = {name: i for i, name in enumerate(order)}
        record["adapters"] = {name: of[name] for name in
                              sorted(of, key=lambda name: place.get(name, len(order)))}
    return record


if __name__ == "__main__":
    sys.exit(pages.run(__doc__, "docs/gallery.json", gallery_page.outputs, measure, [
        ("surehit", "surehit"), ("build", "build/release", "folder with the adapters"),
        ("only", "", "names of adapters, separated by blanks")]))
