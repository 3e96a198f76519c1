#!/usr/bin/env python3
"""What holds of the build itself: test_build.py --root SOURCES --compiler CC --nm NM --library FILE
--tiers ... --plain ... --once ... -- FLAGS, with the lists of
src/meson.build and the exact_arguments of meson.build.

Arithmetic that is not IEEE's is refused; the library exports nothing but sure_*; it allocates
nothing and does no input or output; and no product is contracted into an FMA even for a processor
that has them."""
import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys

PROCESSES = 2
REFUSED = ["-ffast-math", "-Ofast", "-fassociative-math -fno-signed-zeros -fno-trapping-math",
           "-freciprocal-math", "-ffinite-math-only"]
NO_ARITHMETIC = {"answer.c"}
# What the C library may be asked for: correctly rounded or exact functions, the angles' own, and
# the end of a program that has lost its way.
WANTED = {"cos", "cosf", "sin", "sinf", "sincos", "sincosf", "tan", "tanf",
          "sqrt", "sqrtf", "frexp", "frexpf", "ldexp", "ldexpf",
          "fmax", "fmaxf", "fmin", "fminf", "nextafter", "nextafterf",
          "strcmp", "strcpy", "strlen", "memcpy", "memset", "memmove", "abort"}

parser = argparse.ArgumentParser()
for name in ("root", "compiler", "nm", "library"):
    parser.add_argument("--" + name, required=True)
for name in ("tiers", "plain", "once"):
    parser.add_argument("--" + name, nargs="+", type=pathlib.Path, required=True)
parser.add_argument("flags", nargs="+")
given = parser.parse_args()
faults = []

# Every source as src/meson.build has it compiled.
VARIANTS = {"": given.tiers + given.plain + given.once,
            "-DSURE_FLOAT32": given.tiers + given.plain, "-DSURE_STABLE": given.tiers}
SOURCES = [(source, variant) for variant, sources in VARIANTS.items() for source in sources]


def compiled(source, *flags):
    command = [given.compiler, "-std=c11", *flags, "-I", f"{given.root}/include", str(source)]
    return subprocess.run(command, capture_output=True, text=True)


def each_source(check):
    """The faults that check(source, variant) finds, in the order of the sources."""
    with concurrent.futures.ThreadPoolExecutor(PROCESSES) as pool:
        for found in pool.map(lambda pair: check(*pair), SOURCES):
            faults.extend(found)


def macros(flags):
    command = [given.compiler, *flags.split(), "-dM", "-E", "-x", "c", "/dev/null"]
    return subprocess.run(command, capture_output=True, text=True).stdout


def revealed(flags):
    """Does this compiler tell? The contract says that more can't be asked."""
    if flags == "-freciprocal-math":
        return "__RECIPROCAL_MATH__" in macros(flags)
    if flags.startswith("-fassociative"):
        return "__ASSOCIATIVE_MATH__" in macros(flags)
    return True


def refusal_faults(source, variant):
    words = [variant] if variant else []
    if compiled(source, "-fsyntax-only", *words).returncode != 0:
        yield f"{source.name} {variant}: the library's own flags are refused"
    if source.name in NO_ARITHMETIC:
        return
    for flags in filter(revealed, REFUSED):
        result = compiled(source, "-fsyntax-only", *words, *flags.split())
        if result.returncode == 0 or "surehit" not in result.stderr:
            yield f"{source.name} {variant}: {flags} is not refused by surehit"


def assembly(source, *flags):
    result = compiled(source, "-O3", *flags, "-S", "-o", "-")
    result.check_returncode()
    return result.stdout


FUSED = re.compile(r"^\s+(vf[mn]\w*|fn?m(add|sub|la|ls)\w*)\s", re.M)
X86 = "__x86_64__" in macros("")
# Asked for where there are any; and without the macro no source asks for one by name.
WITH_FMA = ["-mfma", "-mavx2", "-U__FP_FAST_FMA"] if X86 else ["-U__FP_FAST_FMA"]


def contraction_faults(source, variant):
    found = FUSED.search(assembly(source, *WITH_FMA, *given.flags, *([variant] if variant else [])))
    if found:
        yield f"{source.name} {variant}: {found[1]}"


def check_that_fmas_are_recognised():
    quadratic = next(path for path in given.tiers if path.name == "quadratic.c")
    asked = [("-mfma", "-ffp-contract=fast"), ("-mfma", "-ffp-contract=off", "-DSURE_STABLE")]
    for flags in asked if X86 else []:
        if not FUSED.search(assembly(quadratic, *flags)):
            faults.append(f"FMAs are not recognised where they are asked for: {' '.join(flags)}")


def symbols(*flags):
    out = subprocess.run([given.nm, "-D", *flags, given.library], capture_output=True, text=True,
                         check=True)
    return [line.split()[-1].split("@")[0] for line in out.stdout.splitlines()]


def check_symbols():
    exported = symbols("--defined-only")
    if len(exported) < 150:
        faults.append(f"only {len(exported)} exported symbols were read")
    faults.extend(f"exported: {name}" for name in exported if not name.startswith("sure_"))
    for name in symbols("--undefined-only"):
        if name.startswith("__gmp") and not name.startswith("__gmpn_"):
            faults.append(f"asks GMP for {name}: only mpn functions allocate nothing")
        elif name not in WANTED and not name.startswith("_"):
            faults.append(f"asks the C library for {name}")


each_source(refusal_faults)
each_source(contraction_faults)
check_that_fmas_are_recognised()
check_symbols()
for fault in faults:
    print(fault)
print("0 passed, 1 failed" if faults else "1 passed, 0 failed")
sys.exit(1 if faults else 0)
