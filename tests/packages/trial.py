# SPDX-License-Identifier: MIT
"""What the tests of this folder have in common: a scratch folder, and commands run there."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from pages import verdict  # noqa: E402

CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project(user C)
find_package(surehit {version} REQUIRED)
foreach(kind surehit static)
  add_executable(by_${{kind}} sphere.c)
  target_link_libraries(by_${{kind}} PRIVATE surehit::${{kind}})
endforeach()
"""


class Fault(Exception):
    pass


class Trial:
    """Arguments of each test: ROOT SCRATCH MESON COMPILER."""

    def __init__(self, root, scratch, meson, compiler):
        self.root, self.scratch = pathlib.Path(root), pathlib.Path(scratch)
        self.meson, self.compiler = meson.split(), compiler
        shutil.rmtree(self.scratch, ignore_errors=True)
        self.scratch.mkdir(parents=True)
        self.version = re.search(r"version: '(.*)'", (self.root / "meson.build").read_text())[1]
        page = (self.root / "README.md").read_text(encoding="utf-8")
        self.program = re.search(r"<!-- file: sphere\.c -->\n```c\n(.*?)```", page, re.S)[1]
        self.printed = re.search(r"and prints `(.*?)`", page)[1] + "\n"

    def run(self, *command, cwd=None, **variables):
        """What it prints. Nothing is found by variables of whoever runs the test."""
        kept = {name: value for name, value in os.environ.items()
                if not name.startswith(("PKG_CONFIG", "CMAKE", "MESON", "DESTDIR", "CFLAGS"))}
        done = subprocess.run(list(map(str, command)), text=True, cwd=cwd or self.scratch,
                              env={**kept, "CC": self.compiler, **variables},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            raise Fault(f"{' '.join(map(str, command))}:\n{done.stdout[-5000:]}")
        return done.stdout

    def write(self, path, text):
        path = self.scratch / path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def check_program(self, path, **variables):
        """The README's, however it was built."""
        said = self.run(path, **variables)
        if said != self.printed:
            raise Fault(f"{path} printed {said!r}, the README says {self.printed!r}")

    def needed(self, path):
        """The shared libraries that a program asks for."""
        return set(re.findall(r"\(NEEDED\).*\[(.*)\]", self.run("readelf", "-d", path)))

    def finish(self, *checks):
        """Each is a method; the next may need what the one before has made."""
        faults = []
        for check in checks:
            try:
                check()
            except Fault as fault:
                faults.append(f"{check.__name__}: {fault}")
                break
        sys.exit(verdict(faults))
