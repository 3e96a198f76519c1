#!/usr/bin/env python3
"""The library where it is a part of something else.

    test_packages.py ROOT SCRATCH MESON COMPILER

It builds alone, with nothing to be found but a C compiler."""
import os
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from pages import verdict  # noqa: E402

MOST_TARGETS = 140


class Fault(Exception):
    pass


class Packages:
    def __init__(self, root, scratch, meson, compiler):
        self.root, self.scratch = pathlib.Path(root), pathlib.Path(scratch)
        self.meson, self.compiler = meson.split(), compiler
        shutil.rmtree(self.scratch, ignore_errors=True)
        self.scratch.mkdir(parents=True)

    def run(self, *command, **variables):
        """What it prints. Nothing is found by variables of whoever runs the test."""
        kept = {name: value for name, value in os.environ.items()
                if not name.startswith(("PKG_CONFIG", "CMAKE", "MESON"))}
        done = subprocess.run(list(map(str, command)), text=True, cwd=self.scratch,
                              env={**kept, "CC": self.compiler, **variables},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            raise Fault(f"{' '.join(map(str, command))}:\n{done.stdout}")
        return done.stdout

    def check_alone(self):
        """With no library to be found, and no more than so many files to compile."""
        nothing = self.scratch / "nothing"
        nothing.mkdir()
        self.run(*self.meson, "setup", "alone", self.root, "-Dtools=disabled", "-Dwerror=true",
                 PKG_CONFIG_LIBDIR=str(nothing))
        self.run("ninja", "-C", "alone")
        targets = self.run("ninja", "-C", "alone", "-t", "targets", "all")
        count = targets.count(".o: c_COMPILER")
        if not 50 < count <= MOST_TARGETS:
            raise Fault(f"{count} files are compiled, and {MOST_TARGETS} may be")


packages = Packages(*sys.argv[1:])
faults = []
for check in (packages.check_alone,):
    try:
        check()
    except Fault as fault:
        faults.append(f"{check.__name__}: {fault}")
sys.exit(verdict(faults))
