#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The library as one file.

    test_single.py ROOT SCRATCH MESON COMPILER PROGRAM LIBRARY CLANG HEADER SOURCE

SOURCE and HEADER, which the build has made, are compiled without a warning by GCC, by Clang and
for Windows. They define what LIBRARY does, and no other names. A program of two lines is linked
with them, and one in C++. Whatever flags a user takes, they answer as LIBRARY does, bit by bit,
for cases of each shape and regime that PROGRAM writes; flags that would change an answer are
refused."""
import platform
import re
import resource
import shutil
import sys

from answers import Answers
from trial import Fault

WINDOWS = "x86_64-w64-mingw32-gcc"
STRICT = ["-std=c11", "-O2", "-Wall", "-Wextra", "-Werror"]
FREE = ["-std=gnu17", "-O3", "-march=native"]  # GCC would multiply and add in one
REFUSED = [("gcc", "-ffast-math", "-ffast-math or a part of it"),
           ("gcc", "-fsingle-precision-constant", "constants of doubles"),
           ("clang", "-ffast-math", "-ffast-math or a part of it")]
if platform.machine() == "x86_64":
    REFUSED.append(("gcc", "-mfpmath=387", "FLT_EVAL_METHOD 0"))
CPP = """\
#include <surehit/surehit.h>
int main()
{
    const sure_ray ray = {{0, 0, 5}, {0, 0, -1}, 0, 9};
    const sure_sphere sphere = {{0, 0, 0}, 1};
    sure_hit hit;
    return !(sure_sphere_hit_exact(&ray, &sphere, &hit) == SURE_HIT && hit.t == 4);
}
"""


class Single(Answers):
    def __init__(self, *options):
        super().__init__(*options[:6])
        self.clang, header, self.source = options[6:]
        self.compilers = {"gcc": self.compiler, "clang": self.clang, "windows": WINDOWS}
        self.include = self.scratch / "include"
        (self.include / "surehit").mkdir(parents=True)
        shutil.copy(header, self.include / "surehit")
        shutil.copy(header, self.scratch)
        shutil.copy(self.source, self.scratch)

    def check_compiles(self):
        for name in ("surehit.h", "surehit.c"):
            text = (self.scratch / name).read_text()
            print(f"{name}: {text.count(chr(10))} lines, {len(text)} bytes")
            if f"surehit {self.version}" not in text or "Permission is hereby granted" not in text:
                raise Fault(f"{name} tells neither its version nor its licence")
        for name, compiler in self.compilers.items():
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            self.run(*compiler.split(), *STRICT, "-c", "surehit.c", "-o", f"{name}.o")
            seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
            print(f"compiled by {name}: {seconds:.1f} s of a processor")
            self.run(*compiler.split(), *STRICT, "-DNDEBUG", "-fsyntax-only", "surehit.c")

    def names(self, *words):
        """What is defined there, but for what compilers add to choose by the processor."""
        said = self.run("nm", "--defined-only", "--extern-only", "--format=posix", *words)
        return set(re.findall(r"^(\w+)(?:@@\w+)? [^A]", said, re.M))

    def check_names(self):
        wanted = self.names("--dynamic", self.library)
        if len(wanted) < 100:
            raise Fault(f"the library has only {len(wanted)} names")
        for name in ("gcc", "clang"):
            there = {one for one in self.names(f"{name}.o") if not one.startswith("surehit_")}
            if there != wanted:
                raise Fault(f"{name}: missing {wanted - there}, too much {there - wanted}")

    def check_refused(self):
        for name, flag, word in REFUSED:
            try:
                self.run(*self.compilers[name].split(), flag, "-w", "-fsyntax-only",
                         "surehit.c")
            except Fault as fault:
                if word not in str(fault):
                    raise
            else:
                raise Fault(f"{name} {flag} is not refused")

    def check_user(self):
        """The page's program, as the page has it compiled; and one in C++."""
        page = (self.root / "docs/building.md").read_text(encoding="utf-8")
        found = re.search(r'```c\n(#include "surehit.h"\n.*?)```.*?```sh\n(cc .*?)\n', page, re.S)
        if not found or found[1].count("\n") != 2:
            raise Fault("docs/building.md has no program of two lines")
        self.write("user.c", found[1])
        self.run("sh", "-c", found[2].replace("cc", self.compiler, 1))
        self.run("./user")
        self.write("user.cpp", CPP)
        for compiler, name in (("g++", "gcc"), (f"{self.clang}++", "clang")):
            self.run(compiler, "-std=c++17", "-Wall", "-Wextra", "-Werror", "-Iinclude",
                     "user.cpp", f"{name}.o", "-o", "by_cpp", "-lm")
            self.run("./by_cpp")

    def check_answers(self):
        for name in ("gcc", "clang"):
            compiler = self.compilers[name]
            self.check_answers_of(name, self.built(f"by_{name}", compiler, f"{name}.o"))
            for kind, flags in {"without a flag": [], " ".join(FREE): FREE}.items():
                self.run(*compiler.split(), *flags, "-c", "surehit.c", "-o", "other.o")
                self.check_answers_of(f"{name} {kind}", self.built("other", compiler, "other.o"))

    def check_windows(self):
        program = self.built("answers.exe", WINDOWS, "windows.o")
        wine = shutil.which("wine64", path="/usr/bin:/usr/lib/wine") or shutil.which("wine")
        if not wine:
            print("windows: compiled and linked; no wine is here to run it")
            return
        self.check_answers_of("windows, by wine", f"{wine} {program}", WINEDEBUG="-all",
                              WINEPREFIX=str(self.scratch / "wine"))


single = Single(*sys.argv[1:])
single.finish(single.check_compiles, single.check_names, single.check_refused, single.check_user,
              single.ask_library, single.check_answers, single.check_windows)
