#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How much sooner all cores of this machine are done than one: the table of docs/cluster.md.

    scaling.py BUILD [--rounds N] [--fuzz]

BUILD is a build folder with surehit, the campaign's program and the peers. One core and all take
turns; told are medians of elapsed seconds. With --fuzz, which wants clang, executions are counted,
too. Nothing else should run meanwhile."""
import argparse
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "bench"))
import frame_scenes  # noqa: E402

CORES = len(os.sched_getaffinity(0))
PIECES = 16


def run(*words, **more):
    done = subprocess.run(list(map(str, words)), text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, check=False, **more)
    if done.returncode != 0:
        sys.exit(f"scaling.py: {' '.join(map(str, words))}: {done.stderr.strip()}")
    return done.stdout


def pieces(program, folder, *words):
    """Elapsed seconds of all pieces of a plan, on so many cores."""
    manifest = folder / "manifest"
    run(program, "plan", *words)

    def work(cores):
        done = folder / "done"
        shutil.rmtree(done, ignore_errors=True)
        done.mkdir()
        start = time.monotonic()
        run("xargs", "-P", cores, "-I{}", program, "work", manifest, "{}", done,
            input="\n".join(map(str, range(1, PIECES + 1))))
        return time.monotonic() - start
    return work


def frame(surehit, folder, scene, *words):
    def draw(cores):
        said = run(surehit, "render", scene, "-o", folder / "picture.ppm", "--quiet", "--time",
                   "--threads", cores, *words)
        return json.loads(said.strip().splitlines()[-1])["frame"]
    return draw


def fuzzing(cores):
    """Seconds an execution."""
    start = time.monotonic()
    said = run(ROOT / "fuzz" / "run", "sphere", "--minutes", "0.25", "--cores", cores)
    executions = int(re.search(r"([\d,]+) executions", said)[1].replace(",", ""))
    return (time.monotonic() - start) / executions


def contests(build, folder, fuzz):
    surehit, campaign = build / "src/cli/surehit", build / "tests/campaign/campaign"
    peer = build / "reference/peers/libpeer-kahan.so"
    for name in ("M", "L"):
        frame_scenes.write(str(folder), name, "rt", False)
    glass = ROOT / "tests/scenes/photons_glass.rt"
    (folder / "of_campaign").mkdir()
    (folder / "of_judge").mkdir()
    yield "campaign", pieces(campaign, folder / "of_campaign", "--cases", "1000000", "--pieces",
                             PIECES, "-o", folder / "of_campaign" / "manifest")
    yield "judge", pieces(surehit, folder / "of_judge", "--pieces", PIECES, "-o",
                          folder / "of_judge" / "manifest", "judge", "--candidate", peer,
                          "--count", "40000", "--untimed")
    for name in ("M", "L"):
        yield f"render {name}", frame(surehit, folder, folder / f"{name}.rt", "--size", "3840x2160")
    yield "photons", frame(surehit, folder, glass, "--size", "640x360", "--integrator", "forward",
                           "--photons", "20000000")
    if fuzz:
        yield "fuzzing", fuzzing


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--fuzz", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        print(f"| | one core | {CORES} cores | |\n|---|---:|---:|---:|")
        for name, contest in contests(options.build.resolve(), pathlib.Path(folder), options.fuzz):
            taken = [(contest(1), contest(CORES)) for _ in range(options.rounds)]
            one, all_cores = (statistics.median(times) for times in zip(*taken))
            ratio = statistics.median(a / b for a, b in taken)
            print(f"| {name} | {one:.3g} s | {all_cores:.3g} s | {ratio:.2f} |", flush=True)


if __name__ == "__main__":
    main()
