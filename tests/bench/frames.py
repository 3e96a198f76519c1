#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""surehit's frames beside those of POV-Ray, Tachyon and Embree, on the scenes of frame_scenes.py.

    frames.py ROOT --measure --surehit PROGRAM [--embree PROGRAM] [OPTION ...]
                          measures, makes the record and fills the page
    frames.py ROOT --check   is the page filled by the record?
    frames.py ROOT           fills the page

The record is docs/frames.json, the page docs/tracer.md, its places stand between comments there.
Measuring wants Debian's packages povray and tachyon (and libembree-dev, of which embree_frame is
built); who is missing is left out. Nothing else should run meanwhile."""
import array
import functools
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import pages  # noqa: E402
import frame_scenes  # noqa: E402

WHOLE = ["POV-Ray", "Tachyon"]  # measured from start to end, with reading and writing
PACKETS = "Embree 8-wide"
EMBREES = ["Embree", PACKETS]
TIERS = ["textbook", "certain"]
COMPARED = ["S", "M", "L"]
ALONE = "XL"  # surehit's only

MAY_DIFFER = 1  # of 255: two roundings of the same light

# Bars: least or most, by scene.
OVER_POV = {"S": 5, "M": 5, "L": 5}
OVER_TACHYON = {"S": 1, "M": 1.5, "L": 6}
OF_EMBREE = {"S": 0.9, "M": 0.9, "L": 0.9}  # of the better of both
OVER_TEXTBOOK = {"S": 1.1, "M": 1.1, "L": 1.1}
GROWTH, ALONE_SECONDS, READER, BYTES = 2.5, 20, 1e6, 250


# Pictures.

def pixels_of(path):
    """The bytes of a P6 PPM of 255 levels, and its width."""
    data = pathlib.Path(path).read_bytes()
    head = re.match(rb"P6\s(?:#[^\n]*\n|\s)*(\d+)\s(?:#[^\n]*\n|\s)*(\d+)\s(?:#[^\n]*\n|\s)*255\s",
                    data)
    if not head:
        sys.exit(f"frames: {path} is no PPM of 255 levels")
    rgb = data[head.end():]
    width, height = int(head[1]), int(head[2])
    if len(rgb) != 3 * width * height:
        sys.exit(f"frames: {path} is not whole")
    return rgb, width


def off_in_light(ours, theirs):
    """How many pixels differ by more than two roundings can."""
    a, b = pixels_of(ours)[0], pixels_of(theirs)[0]
    return len({i // 3 for i, (x, y) in enumerate(zip(a, b)) if abs(x - y) > MAY_DIFFER})


def numbers_of(path):
    """The object at each pixel, off a picture of frame_scenes --objects."""
    rgb, width = pixels_of(path)
    return array.array("L", (r << 16 | g << 8 | b for r, g, b in
                             zip(rgb[::3], rgb[1::3], rgb[2::3]))), width


def is_at_edge(numbers, width, i):
    """Is another object beside it, or the end of the picture?"""
    x, height = i % width, len(numbers) // width
    if x in (0, width - 1) or i // width in (0, height - 1):
        return True
    around = (i + dx + dy * width for dx in (-1, 0, 1) for dy in (-1, 0, 1))
    return any(numbers[j] != numbers[i] for j in around)


def other_objects(ours, theirs):
    """Pixels where another object is seen, and those of them that are at no edge."""
    (a, width), (b, _) = numbers_of(ours), numbers_of(theirs)
    off = [i for i, (x, y) in enumerate(zip(a, b)) if x != y]
    return len(off), sum(not is_at_edge(a, width, i) for i in off)


# Programs.

class Program:
    """A command of a scene's and a picture's path; None for a path where it is not here."""

    def __init__(self, name, program, ending, words, threads, asked=(), version=None):
        self.name, self.ending, self.words, self.asked = name, ending, words, asked
        self.path, self.threads, self.says = shutil.which(program or ""), threads, version

    def command(self, scene, picture):
        return [os.path.abspath(self.path), *(
            word.format(scene=scene, picture=picture, threads=self.threads)
            for word in self.words.split())]

    def version(self):
        said = subprocess.run([self.path, *self.asked], capture_output=True, text=True, check=False)
        return re.search(self.says, said.stdout + said.stderr)[1]


def surehits(options):
    return [Program(f"surehit {tier}", options.surehit, "rt",
                    f"render {{scene}} -o {{picture}} --quiet --tier {tier} --threads {{threads}} "
                    "--time", options.threads) for tier in TIERS]


def others_here(options):
    """Who is here, and who is missing."""
    others = {
        "POV-Ray (Debian's package povray)": Program(
            "POV-Ray", options.povray, "pov", "+I{scene} +O{picture} +FP File_Gamma=1 "
            f"+W{frame_scenes.WIDTH} +H{frame_scenes.HEIGHT} -A -D -GA +WT{{threads}}",
            options.threads, ["--version"], r"POV-Ray (\d[.\d]*\d)"),
        "Tachyon (Debian's package tachyon)": Program(
            "Tachyon", options.tachyon, "dat",
            "{scene} -o {picture} -format PPM -numthreads {threads} -shade_nullphong",
            options.threads, [os.devnull], r"Version (\d[.\d]*)"),
        "Embree (Debian's package libembree-dev)": Program(
            "Embree", options.embree, "rt", "{scene} {picture} {threads}", options.threads,
            ["--version"], r"\A\s*(.*\S)"),
        "Embree (Debian's package libembree-dev), eight rays at a time": Program(
            PACKETS, options.embree, "rt", "--packets {scene} {picture} {threads}",
            options.threads, ["--version"], r"\A\s*(.*\S)"),
    }
    missing = [what for what, program in others.items() if not program.path]
    for what in missing:
        print(f"frames: {what} is missing and left out", file=sys.stderr)
    return [program for program in others.values() if program.path], missing


# Measuring.

class Scenes:
    """Files, made when they are first asked for; kept while the program that makes them does."""

    def __init__(self, folder):
        self.folder = folder
        os.makedirs(folder, exist_ok=True)

    def path(self, name, ending, objects=False):
        path = os.path.join(self.folder, f"{name}{'.objects' if objects else ''}.{ending}")
        maker = os.path.getmtime(frame_scenes.__file__)
        if not os.path.exists(path) or os.path.getmtime(path) < maker:
            frame_scenes.write(self.folder, name, ending, objects)
        return path

    def picture(self, program):
        return os.path.join(self.folder, program.name.replace(" ", "-") + ".ppm")


def run(program, scene, picture):
    """One run: seconds from start to end, of processors, peak kilobytes, and what it says."""
    command = program.command(scene, picture)
    with open(picture + ".log", "wb") as log:
        started = time.perf_counter()
        with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=log) as child:
            said = child.stdout.read()
            _, status, used = os.wait4(child.pid, 0)
            wall = time.perf_counter() - started
            child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0 or not os.path.exists(picture):
        with open(picture + ".log", encoding="utf-8", errors="replace") as log:
            sys.exit(f"frames: {' '.join(command)} failed:\n{log.read()[-2000:]}")
    line = said.decode("utf-8", "replace").strip() if program.ending == "rt" else "{}"
    return {"wall": wall, "cpu": used.ru_utime + used.ru_stime, "kilobytes": used.ru_maxrss,
            **json.loads(line)}


def drawn(program, scenes, name, objects=False):
    """The picture's path."""
    picture = scenes.picture(program)
    if os.path.exists(picture):
        os.remove(picture)
    run(program, scenes.path(name, program.ending, objects), picture)
    return picture


def compare(name, certain, others, scenes):
    """Of each other program, how far its picture is ours."""
    result = {other.name: {} for other in others}
    ours = drawn(certain, scenes, name)
    for other in others:
        result[other.name]["light"] = off_in_light(ours, drawn(other, scenes, name))
    ours = drawn(certain, scenes, name, objects=True)
    for other in others:
        off, inside = other_objects(ours, drawn(other, scenes, name, objects=True))
        result[other.name].update(object=off, inside=inside)
    print(name, result, flush=True)
    return result


def medians(runs):
    """Of each time, and the peak."""
    return {key: max(run[key] for run in runs) if key == "kilobytes"
            else statistics.median(run[key] for run in runs) for key in runs[0]}


def measured(names, tiers, others, scenes, repeats):
    """By scene and program the medians; one round of everybody after the other. The bars are about
    the last tier."""
    runs = {name: {program.name: [] for program in
                   (tiers + others if name in COMPARED else tiers[-1:])} for name in names}
    programs = {program.name: program for program in tiers + others}
    for repeat in range(repeats):
        for name, of_scene in runs.items():
            for who, own in of_scene.items():
                path = scenes.path(name, programs[who].ending)
                own.append(run(programs[who], path, scenes.picture(programs[who])))
        print(f"round {repeat + 1} of {repeats}", flush=True)
    return {name: {program: medians(all_runs) for program, all_runs in of_scene.items()}
            for name, of_scene in runs.items()}


def machine(surehit, folder):
    path = os.path.join(folder, "machine.json")
    subprocess.run([surehit, "bench", "--cases", "10", "--repeats", "1", "--regime", "typical",
                    "--shape", "plane", "--json", path], check=True, stdout=subprocess.DEVNULL)
    with open(path, encoding="ascii") as file:
        bench = json.load(file)
    return {key: bench[key] for key in ("cpu", "compiler", "flags")}


def rounded(value):
    if isinstance(value, dict):
        return {key: rounded(part) for key, part in value.items()}
    return round(value, 5) if isinstance(value, float) else value


def warn_when_busy():
    load = os.getloadavg()[0]
    if load > 0.5:
        print(f"frames: something else runs (load {load:.1f}): these times are not worth keeping",
              file=sys.stderr)


def measure(options):
    warn_when_busy()
    scenes = Scenes(options.scratch)
    tiers = surehits(options)
    if not tiers[0].path:
        sys.exit("frames: surehit is missing")
    others, missing = others_here(options)
    names = options.scenes.split(",")
    record = {**machine(options.surehit, options.scratch), "threads": options.threads,
              "repeats": options.repeats, "width": frame_scenes.WIDTH,
              "height": frame_scenes.HEIGHT,
              "versions": {other.name: other.version() for other in others}, "missing": missing}
    record["times"] = measured(names, tiers, others, scenes, options.repeats)
    record["pictures"] = {name: compare(name, tiers[-1], others, scenes) for name in names
                          if name in COMPARED and not options.no_pictures}
    print(*page_values(record).values(), sep="\n")
    return rounded(record)


# The page.

table = functools.partial(pages.table, right=())


def time_of(record, name, program, key):
    """None where it was not measured."""
    return record["times"].get(name, {}).get(program, {}).get(key)


def quotient(a, b):
    return a / b if a is not None and b else None


def total(record, name, program, *keys):
    times = [time_of(record, name, program, key) for key in keys]
    return None if None in times else sum(times)


def judged(value, bar, least=True, digits=2):
    """A figure with its bar; bold where it does not hold."""
    if value is None:
        return "–"
    holds = value >= bar if least else value <= bar
    figure = f"{value:.{digits}f}" if holds else f"**{value:.{digits}f}**"
    return f"{figure} ({'≥' if least else '≤'} {bar:g})"


def bars_table(record):
    def shares(above, below, *keys):
        return {name: quotient(total(record, name, above, *keys),
                               total(record, name, below, *keys)) for name in COMPARED}

    def row(title, values, bar, least=True):
        return [title, *(judged(values[name], bar[name], least) for name in COMPARED)]

    certain = "surehit certain"

    def of_embree(*keys):
        """Of whichever of both has the shorter frame."""
        both = {who: shares(who, certain, *keys) for who in EMBREES}
        frames = {who: shares(who, certain, "frame") for who in EMBREES}
        return {name: min(((frames[who][name], both[who][name]) for who in EMBREES
                           if both[who][name] is not None), default=(None, None))[1]
                for name in COMPARED}

    with_build = of_embree("build", "frame")
    return table(["bar", *COMPARED], [
        row("speed-up over POV-Ray, whole process", shares("POV-Ray", certain, "wall"), OVER_POV),
        row("speed-up over Tachyon, whole process", shares("Tachyon", certain, "wall"),
            OVER_TACHYON),
        row("frame rate as a share of Embree's", of_embree("frame"), OF_EMBREE),
        ["the same, with the building of the hierarchy",
         *("–" if value is None else f"{value:.2f}" for value in with_build.values())],
        row("frame time, `certain` over `textbook`", shares(certain, "surehit textbook", "frame"),
            OVER_TEXTBOOK, least=False)])


def seconds(value):
    return "–" if value is None else f"{value:.3f}"


def times_table(record):
    lines = [(f"{program}, whole process", program, "wall") for program in WHOLE]
    lines += [(f"surehit, `{tier}`, whole process", f"surehit {tier}", "wall") for tier in TIERS]
    lines += [("Embree, frame", "Embree", "frame")]
    if any(PACKETS in of_scene for of_scene in record["times"].values()):
        lines += [("Embree, eight rays at a time, frame", PACKETS, "frame")]
    lines += [(f"surehit, `{tier}`, frame", f"surehit {tier}", "frame") for tier in TIERS]
    lines += [("Embree, building", "Embree", "build"),
              ("surehit, building", "surehit certain", "build")]
    names = COMPARED + [ALONE]
    return table(["seconds", *names],
                 [[title, *(seconds(time_of(record, name, program, key)) for name in names)]
                  for title, program, key in lines])


def size_table(record):
    certain = "surehit certain"
    ratio = quotient(*(time_of(record, name, certain, "frame") for name in ("L", "M")))
    read = quotient(*(time_of(record, ALONE, certain, key) for key in ("objects", "read")))
    kilobytes = [time_of(record, name, certain, "kilobytes") for name in ("L", ALONE)]
    more = frame_scenes.SOLIDS[ALONE] - frame_scenes.SOLIDS["L"]
    each = None if None in kilobytes else 1024 * (kilobytes[1] - kilobytes[0]) / more
    frame = total(record, ALONE, certain, "read", "place", "build", "frame")
    return table(["with the number of objects", "tier `certain`"], [
        ["time a ray, L over M (100 times the objects)", judged(ratio, GROWTH, least=False)],
        ["XL: read, place, build and frame, seconds", judged(frame, ALONE_SECONDS, least=False)],
        ["XL: objects read a second, in millions", judged(quotient(read, 1e6), READER / 1e6)],
        ["bytes an object, at the peak", judged(each, BYTES, least=False, digits=0)]])


def pictures_table(record):
    lines = [("light", "light off by more than 1/255"), ("object", "another object"),
             ("inside", "of these, at no edge")]
    rows = [[f"{program}: {title}",
             *(f"{record['pictures'][name][program][key]:,}" for name in record["pictures"])]
            for program in record["versions"] for key, title in lines]
    return table([f"pixels of {record['width'] * record['height']:,}", *record["pictures"]], rows)


def page_values(record):
    """What fills the page."""
    others = ", ".join(f"{name} {version}" for name, version in record["versions"].items())
    said = f"{others}." if others else "nobody."
    shown = record["pictures"] and record["versions"]
    return {"repeats": record["repeats"], "threads": record["threads"],
            "size": f"{record['width']}x{record['height']}",
            "machine": f"{record['cpu']}, {record['compiler']}",
            "others": " ".join([said, *(f"{what} was missing." for what in record["missing"])]),
            "bars": pages.block(bars_table(record)), "times": pages.block(times_table(record)),
            "sizes": pages.block(size_table(record)),
            "pictures": pages.block(*([pictures_table(record)] if shown else []))}


def outputs(root, record):
    page = root / "docs/tracer.md"
    return {page: pages.filled(page.read_text(encoding="utf-8"), page_values(record))}


if __name__ == "__main__":
    sys.exit(pages.run(__doc__, "docs/frames.json", outputs, measure, [
        ("surehit", "surehit"), ("povray", "povray"), ("tachyon", "tachyon"),
        ("embree", "", "the program embree_frame"),
        ("scratch", "frames.scratch", "folder of scenes and pictures"),
        ("scenes", ",".join(frame_scenes.SOLIDS)), ("repeats", 15), ("threads", 2),
        ("no-pictures", False, "times alone")]))
