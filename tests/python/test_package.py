#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The Python package as a user gets it.

    test_package.py ROOT SCRATCH PROGRAM LIBRARY [--installed PYTHON]

pip makes the wheel of the tree, which stays as it is, and a clean environment installs it. There
the tests of the package run, the examples of its pages as doctests, mypy over package and a user's
file, and what a ray costs above C. --installed: all that with a Python that has the package."""
import argparse
import doctest
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from pages import tree_of, verdict  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
PAGES = "README.md", "docs/python.md"
USER = '''import numpy as np
import surehit

made = surehit.cases("sphere", "grazing", 3, seed=1)
hits = surehit.hits("sphere", made.rays, made.objects, "exact")
where: "np.ndarray[tuple[int], np.dtype[np.float64]]" = hits.t
surehit.hits("sphere", ([0, 0, 0], [0, 0, -1]), ([0, 0, -5], 1), normals=False)
wrong: int = surehit.judge(lambda shape, rays, objects: rays[:, 0]).rows[0]["wrong"]
'''
# A user's mistakes, of which mypy is to find each.
MISTAKES = '''import surehit
surehit.hits("sphere", [0.0], [0.0], tiers="exact")
surehit.cases("sphere", "rim", "many")
surehit.hits("sphere", [0.0], [0.0]).time
'''


class Fault(Exception):
    pass


def run(*command, cwd, status=0, **variables):
    """What it prints."""
    done = subprocess.run(list(map(str, command)), cwd=cwd, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, env={**os.environ, **variables})
    if done.returncode != status:
        raise Fault(f"{' '.join(map(str, command))}:\n{done.stdout}")
    return done.stdout


class Package:
    def __init__(self, options):
        self.root, self.scratch = options.root.resolve(), options.scratch.resolve()
        self.program, self.library = options.program.resolve(), options.library.resolve()
        self.python = options.installed
        shutil.rmtree(self.scratch, ignore_errors=True)
        self.scratch.mkdir(parents=True)

    def check_installed(self):
        if self.python:
            return
        before = tree_of(self.root)
        run(sys.executable, "-m", "pip", "wheel", "--no-index", "--no-deps", "--no-build-isolation",
            "-w", self.scratch, self.root, cwd=self.scratch)
        if len(before) < 100 or tree_of(self.root) != before:
            raise Fault("making the wheel changes the tree")
        wheel, = self.scratch.glob("surehit-*-cp311-abi3-*.whl")
        self.python = self.scratch / "venv/bin/python"
        run(sys.executable, "-m", "venv", "--system-site-packages", "venv", cwd=self.scratch)
        run(self.python, "-m", "pip", "install", "--no-index", "--no-deps", wheel,
            cwd=self.scratch)
        print(wheel.name, wheel.stat().st_size, "bytes")

    def check_libraries(self):
        """Of the system's no more than any Debian has."""
        if not list(self.scratch.glob("surehit-*.whl")):  # another's package
            return
        extension, = (self.scratch / "venv").rglob("_surehit.*.so")
        linked = re.findall(r"(\S+) => (/\S+)", run("ldd", extension, cwd=self.scratch))
        own = [name for name, path in linked if pathlib.Path(path).parent == extension.parent]
        for name, _ in linked:
            if name not in (*own, "libm.so.6", "libc.so.6"):
                raise Fault(f"{name} is the system's")
        if len(own) != len(list(self.scratch.glob("venv/**/surehit-*.dist-info/lib*"))) or not own:
            raise Fault(f"licences of {own} are missing")

    def check_tests(self):
        said = run(self.python, "-B", HERE / "test_surehit.py", self.root, self.program,
                   cwd=self.scratch)
        if "\nOK\n" not in said or "skipped" in said:
            raise Fault(said)

    def check_examples(self):
        for page in PAGES:
            examples = doctest.DocTestParser().get_examples(
                (self.root / page).read_text(encoding="utf-8"))
            if len(examples) < 3:
                raise Fault(f"{page}: {len(examples)} examples in Python")
            run(self.python, "-m", "doctest", self.root / page, cwd=self.scratch)

    def check_types(self):
        for name, text in ("user.py", USER), ("mistakes.py", MISTAKES):
            (self.scratch / name).write_text(text, encoding="utf-8")
        mypy = self.python, "-m", "mypy", "--strict", "--no-error-summary"
        run(*mypy, "-p", "surehit", cwd=self.scratch)
        run(*mypy, "user.py", cwd=self.scratch)
        said = run(*mypy, "mistakes.py", cwd=self.scratch, status=1)
        for line in (2, 3, 4):
            if f"mistakes.py:{line}: error" not in said:
                raise Fault(f"no mistake in line {line}:\n{said}")
        run(self.python, "-m", "mypy.stubtest", "--ignore-missing-stub", "surehit._surehit",
            cwd=self.scratch)

    def check_speed(self):
        """Ten times what a quiet machine needs."""
        print(run(self.python, "-B", HERE / "speed.py", self.library, "20000", "--most", "200",
                  cwd=self.scratch, OPENBLAS_NUM_THREADS="1"), end="")


def main():
    parser = argparse.ArgumentParser()
    for name in ("root", "scratch", "program", "library", "--installed"):
        parser.add_argument(name, type=pathlib.Path)
    package = Package(parser.parse_args())
    faults = []
    for check in (package.check_installed, package.check_libraries, package.check_tests,
                  package.check_examples, package.check_types, package.check_speed):
        try:
            check()
        except Fault as fault:
            faults.append(f"{check.__name__}: {fault}")
            if check == package.check_installed:
                break
    return verdict(faults)


sys.exit(main())
