#!/usr/bin/env python3
"""The same answers from every build of the library.

test_environments.c runs on libraries built at every level of optimisation, by every compiler given,
and compiled itself as a user might, with -ffast-math; the digests of all answers of exact and of
certain have to be the same. And no source of the library compiles with -ffast-math."""
import argparse
import concurrent.futures
import itertools
import os
import pathlib
import shutil
import subprocess
import sys

BUILDS = ["-O0", "-O1", "-O2", "-O3", "-O3 -march=native", "-Os"]
USUAL = "-O2"
USERS = "-O3 -ffast-math -ffp-contract=fast"
WITHOUT_ARITHMETIC = {"answer.c"}  # names alone
CASES = "10"


class Failed(Exception):
    """What went wrong with a build or a run."""


def run(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        raise Failed(f"{command[0]} {command[1]} ...\n{(done.stderr or done.stdout)[:800]}")
    return done.stdout


def compiled(options, folder, compiler, flags, groups):
    """The objects of {define: sources}."""
    objects = []
    for define, sources in groups.items():
        place = folder / (define or "once")
        place.mkdir(parents=True)
        stage = [f"-DSURE_{define}"] if define else []
        run([compiler, "-std=c11", "-w", *flags.split(), *options.exact_arguments, *stage,
             f"-I{options.root}/include", "-c", *sources], cwd=place)
        objects += sorted(str(path) for path in place.glob("*.o"))
    return objects


def digests(options, folder, compiler, flags, objects):
    """Of test_environments.c, compiled with the flags and linked with a library's objects."""
    program = folder / "test_environments"
    run([compiler, "-std=c11", "-w", *flags.split(), f"-I{options.root}/include",
         f"-I{options.root}/src/cases", f"{options.root}/tests/house/test_environments.c",
         options.judge, *objects, "-lgmp", "-lm", "-o", str(program)])
    return "\n".join(run([str(program), CASES]).splitlines()[:2])


def accepts(compiler, flags):
    command = [compiler, *flags.split(), "-fsyntax-only", "-x", "c", "/dev/null"]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def refusals(options, compiler):
    for source in sorted({*options.tiers, *options.plain, *options.once}):
        if pathlib.Path(source).name in WITHOUT_ARITHMETIC:
            continue
        done = subprocess.run([compiler, "-std=c11", "-ffast-math",
                               f"-I{options.root}/include", "-fsyntax-only", source],
                              capture_output=True, text=True, check=False)
        if done.returncode == 0 or "surehit cannot be compiled" not in done.stderr:
            raise Failed(f"{source} is not refused with -ffast-math")
    return None


def tasks(options, plain):
    """(name, function that returns the two digests, or None where only a failure counts)"""
    groups = {None: options.once}

    def library(compiler, flags, users_flags):
        folder = options.scratch / "".join(filter(str.isalnum, compiler + flags + users_flags))
        objects = compiled(options, folder, compiler, flags, groups)
        return digests(options, folder, compiler, users_flags, objects + plain)

    for compiler, flags in itertools.product(options.compilers, BUILDS):
        if accepts(compiler, flags):
            yield f"{compiler} {flags}", lambda c=compiler, f=flags: library(c, f, USUAL)
    for compiler in options.compilers:
        yield (f"{compiler} {USUAL}, a user's file {USERS}",
               lambda c=compiler: library(c, USUAL, USERS))
        yield f"{compiler} refuses -ffast-math", lambda c=compiler: refusals(options, c)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--root", required=True)
    parser.add_argument("--scratch", type=pathlib.Path, required=True)
    parser.add_argument("--judge", required=True, help="the library of the cases")
    for group in ("tiers", "plain", "once", "compilers"):
        parser.add_argument(f"--{group}", nargs="+", required=True)
    parser.add_argument("exact_arguments", nargs="+", help="after --: meson.build's")
    options = parser.parse_args()
    for name in ("tiers", "plain", "once"):
        setattr(options, name, [os.path.abspath(path) for path in getattr(options, name)])
    options.root, options.judge = os.path.abspath(options.root), os.path.abspath(options.judge)
    options.scratch = options.scratch.absolute()
    return options


def main():
    options = arguments()
    shutil.rmtree(options.scratch, ignore_errors=True)
    # The plain tiers promise nothing of this and are not asked.
    plain = compiled(options, options.scratch / "plain", options.compilers[0], "-O1",
                     {None: options.tiers + options.plain, "FLOAT32": options.tiers + options.plain,
                      "STABLE": options.tiers})
    failed, found = 0, {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        running = {name: pool.submit(task) for name, task in tasks(options, plain)}
        for name, future in running.items():
            try:
                answer = future.result()
                print(f"{name}: {answer.replace(chr(10), ', ') if answer else 'well'}")
                if answer:
                    found.setdefault(answer, name)
            except Failed as failure:
                print(f"{name}: {failure}")
                failed += 1
    shutil.rmtree(options.scratch, ignore_errors=True)
    if len(found) > 1:
        print("different answers: " + "; ".join(found.values()))
        failed += len(found) - 1
    print(f"{len(running) - failed} passed, {failed} failed")
    return 1 if failed else 0


sys.exit(main())
