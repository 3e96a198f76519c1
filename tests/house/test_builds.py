#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The library however it is built, by every compiler given.

The same answers: test_environments.c prints the same digests of all answers of exact and of certain
with a library of every level of optimisation, and compiled itself as a user might. No product is
contracted into an FMA even for a processor that has them. Arithmetic that is not IEEE's is refused.
What is built allocates nothing and does no input or output.

ninja compiles in a folder of its own what has changed since the last time."""
import argparse
import concurrent.futures
import itertools
import os
import re
import subprocess
import sys

LEVELS = ["-O0", "-O1", "-O2", "-O3", "-O3 -march=native", "-Os", "-O2 -U__SIZEOF_INT128__"]
USUAL = "-O2"
BY_GMP = "-O2 -DSURE_GMP"
USERS = "-O3 -ffast-math -ffp-contract=fast"
REFUSED = {"-ffast-math": "", "-Ofast": "", "-ffinite-math-only": "",
           "-fassociative-math -fno-signed-zeros -fno-trapping-math": "__ASSOCIATIVE_MATH__",
           "-freciprocal-math": "__RECIPROCAL_MATH__"}  # and what tells, if anything does
FUSED = re.compile(r"^\s+(vf[mn]\w*|fn?m(add|sub|la|ls)\w*)\s", re.M)
WITHOUT_ARITHMETIC = {"answer.c", "block.c", "bvh_box.c", "many.c", "occluded.c",
                      "packet_here.c"}  # names, copies
CASES = 10
# What the C library may be asked for: correctly rounded or exact functions, the angles' own, and
# the end of a program that has lost its way.
WANTED = {"cos", "cosf", "sin", "sinf", "sincos", "sincosf", "tan", "tanf",
          "sqrt", "sqrtf", "frexp", "frexpf", "frexpl", "ldexp", "ldexpf", "ldexpl",
          "fmax", "fmaxf", "fmin", "fminf", "nextafter", "nextafterf",
          "strcmp", "strcpy", "strlen", "memchr", "memcpy", "memset", "memmove", "abort",
          "getenv"}
RULES = """\
rule compile
  command = $compiler -std=c11 -w $flags -I{root}/include -MD -MF $out.d $in -o $out
  depfile = $out.d
  deps = gcc
rule link
  command = $compiler $in -Wl,-rpath,$$(dirname {library}) -lgmp -lm -o $out
rule run
  command = ./$in {cases} > $out || {{ cat $out; false; }}
"""


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, **options)


class Plan:
    """What ninja is to make: `answers` by what they are called, `assembly` likewise."""

    def __init__(self, options):
        self.options, self.answers, self.assembly = options, {}, {}
        self.text = RULES.format(root=options.root, library=options.library, cases=CASES)

    def make(self, rule, out, inputs, **variables):
        self.text += f"build {out}: {rule} {' '.join(inputs)}\n"
        self.text += "".join(f"  {name} = {value}\n" for name, value in variables.items())
        return out

    def compiled(self, source, folder, suffix, compiler, flags):
        name = os.path.relpath(source, self.options.root).replace("/", "_")
        mode = "-S" if suffix == ".s" else "-c"
        return self.make("compile", f"{folder}/{name}{suffix}", [source], compiler=compiler,
                         flags=f"{mode} {flags} {' '.join(self.options.exact_arguments)}")

    def answered(self, name, compiler, flags, objects):
        """By test_environments.c, compiled with the flags and linked with a library's objects. The
        plain tiers promise nothing of this and are the build's own."""
        folder, options = re.sub(r"\W", "", name), self.options
        test = self.make("compile", f"{folder}/test.o",
                         [f"{options.root}/tests/house/test_environments.c"], compiler=compiler,
                         flags=f"-c {flags} -I{options.root}/src/cases")
        program = self.make("link", f"{folder}/test", [test, *objects, options.judge,
                                                       options.library], compiler=compiler)
        self.answers[name] = self.make("run", f"{folder}/answers", [program])

    def environments(self):
        """The build's own library is the first compiler's usual one, by GMP where there is one."""
        own = BY_GMP if self.options.gmp else USUAL
        levels = [*LEVELS, *([BY_GMP] if self.options.gmp else [])]
        for compiler, level in itertools.product(self.options.compilers, levels):
            name, objects = f"{compiler} {level}", []
            if run(*f"{compiler} {level} -fsyntax-only -x c /dev/null".split()).returncode:
                continue
            if (compiler, level) != (self.options.compilers[0], own):
                objects = [self.compiled(source, re.sub(r"\W", "", name), ".o", compiler, level)
                           for source in self.options.once]
            self.answered(name, compiler, USUAL, objects)
            if level == USUAL:
                self.answered(f"{name}, a user's file {USERS}", compiler, USERS, objects)

    def contraction(self, sources, with_fma):
        """Asked for where there are any; and without the macro no source asks for one by name."""
        for source, variant in sources:
            self.assembly[f"{source} {variant}"] = self.compiled(
                source, f"fma{variant}", ".s", self.options.compilers[0],
                f"-O3 {with_fma} -U__FP_FAST_FMA {variant}")

    def recognised(self, quadratic, with_fma):
        """Assembly with FMAs in it, of two kinds."""
        if with_fma:
            for folder, flags in (("fast", "-ffp-contract=fast"), ("macro", "-DSURE_STABLE")):
                yield self.make("compile", f"{folder}.s", [quadratic],
                                compiler=self.options.compilers[0], flags=f"-S -O3 -mfma {flags} "
                                + ("-ffp-contract=off" if folder == "macro" else ""))


def refusals(options, sources):
    """What is not refused: each source with -ffast-math, and by each compiler the rest."""
    def accepts(compiler, file, *flags):
        done = run(*compiler.split(), "-std=c11", *flags, f"-I{options.root}/include", "-E", file,
                   "-o", os.devnull)
        return done.returncode == 0 or "surehit cannot be compiled" not in done.stderr

    asked = [(options.compilers[0], source, "-ffast-math", *variant.split())
             for source, variant in sources if os.path.basename(source) not in WITHOUT_ARITHMETIC]
    for compiler, (flags, macro) in itertools.product(options.compilers, REFUSED.items()):
        if macro in run(*f"{compiler} {flags} -dM -E -x c /dev/null".split()).stdout:
            asked.append((compiler, f"{options.root}/src/numbers/bits.h", *flags.split()))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for words, accepted in zip(asked, pool.map(lambda words: accepts(*words), asked)):
            if accepted:
                yield f"not refused by surehit: {' '.join(words)}"


def wrong_symbols(options):
    wanted = run(options.nm, "-D", "--undefined-only", options.library, check=True).stdout
    for line in wanted.splitlines():
        name = line.split()[-1].split("@")[0]
        if name.startswith("__gmp") and not name.startswith("__gmpn_"):
            yield f"asks GMP for {name}: only mpn functions allocate nothing"
        elif name not in WANTED and not name.startswith("_"):
            yield f"asks the C library for {name}"


def built_faults(options, sources):
    plan = Plan(options)
    predefined = run(*f"{options.compilers[0]} -dM -E -x c /dev/null".split()).stdout
    x86 = "__x86_64__" in predefined
    plan.environments()
    plan.contraction(sources, "-mfma -mavx2" if x86 else "")
    quadratic = next(path for path in options.tiers if path.endswith("/quadratic.c"))
    recognised = list(plan.recognised(quadratic, x86))
    os.makedirs(options.scratch, exist_ok=True)
    os.chdir(options.scratch)
    with open("build.ninja", "w") as file:
        file.write(plan.text)
    done = run("ninja", "--quiet", "-k0")
    if done.returncode != 0:
        yield done.stdout
        return
    by_exact, by_certain = {}, {}
    for name, path in plan.answers.items():
        with open(path) as file:
            exact, certain = file.read().splitlines()[:2]
        print(f"{name}: {exact}, {certain}")
        by_exact.setdefault(exact, name)
        by_certain.setdefault(certain, name)
    for found in by_exact, by_certain:
        if len(found) > 1:
            yield "different answers: " + "; ".join(found.values())
    for name, path in plan.assembly.items():
        with open(path) as file:
            fused = FUSED.search(file.read())
        if fused:
            yield f"{name}: {fused[1]}"
    for path in recognised:
        with open(path) as file:
            if not FUSED.search(file.read()):
                yield f"FMAs are not recognised where they are asked for: {path}"


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("root", "scratch", "nm", "library"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("--judge", required=True, help="the library of the cases")
    parser.add_argument("--gmp", action="store_true", help="the library's long numbers are GMP's")
    for group in ("tiers", "plain", "once", "compilers"):
        parser.add_argument(f"--{group}", nargs="+", required=True)
    parser.add_argument("exact_arguments", nargs="+", help="after --: meson.build's")
    options = parser.parse_args()
    for name in ("root", "library", "judge"):
        setattr(options, name, os.path.abspath(getattr(options, name)))
    for name in ("tiers", "plain", "once"):
        setattr(options, name, [os.path.abspath(path) for path in getattr(options, name)])
    return options


def main():
    options = arguments()
    twice, thrice = options.tiers + options.plain, options.tiers
    sources = [(source, variant) for variant, group in
               {"": twice + options.once, "-DSURE_FLOAT32": twice, "-DSURE_STABLE": thrice}.items()
               for source in group]
    faults = [*refusals(options, sources), *wrong_symbols(options), *built_faults(options, sources)]
    print(*faults, "0 passed, 1 failed" if faults else "1 passed, 0 failed", sep="\n")
    return 1 if faults else 0


sys.exit(main())
