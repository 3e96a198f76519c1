#!/usr/bin/env python3
"""What holds of the build itself. Arguments: source root, C compiler, nm, the built library; then,
after --, the flags of meson.build's exact_arguments.

Arithmetic that is not IEEE's is refused; the library exports nothing but sure_*; it allocates
nothing and does no input or output; and no product is contracted into an FMA even for a processor
that has them."""
import pathlib
import re
import subprocess
import sys

root, compiler, nm, library = sys.argv[1:5]
exact_arguments = sys.argv[6:]
faults = []

REFUSED = ["-ffast-math", "-Ofast", "-fassociative-math -fno-signed-zeros -fno-trapping-math",
           "-freciprocal-math", "-ffinite-math-only"]
# What the C library may be asked for: correctly rounded or exact functions, and the angles' own.
WANTED = {"cos", "cosf", "sin", "sinf", "sincos", "sincosf", "tan", "tanf",
          "sqrt", "sqrtf", "frexp", "frexpf", "ldexp",
          "ldexpf", "fmax", "fmaxf", "fmin", "fminf", "nextafter", "nextafterf", "strcmp", "memcpy",
          "memset", "memmove"}


def compiles(flags):
    source = pathlib.Path(root) / "src/geometry/quadratic.c"
    command = [compiler, "-std=c11", *flags, "-I", f"{root}/include", "-fsyntax-only", str(source)]
    return subprocess.run(command, capture_output=True, text=True)


def check_refusals():
    if compiles([]).returncode != 0:
        faults.append("the library's own flags are refused")
    for flags in REFUSED:
        result = compiles(flags.split())
        if flags == "-freciprocal-math" and "__RECIPROCAL_MATH__" not in macros(flags):
            continue  # not revealed by this compiler: the contract says so
        if flags.startswith("-fassociative") and "__ASSOCIATIVE_MATH__" not in macros(flags):
            continue
        if result.returncode == 0 or "surehit" not in result.stderr:
            faults.append(f"{flags}: not refused by surehit\n{result.stderr}")


def macros(flags):
    command = [compiler, *flags.split(), "-dM", "-E", "-x", "c", "/dev/null"]
    return subprocess.run(command, capture_output=True, text=True).stdout


def check_contraction():
    """FMAs in the assembly of every source, asked for with -O3 and, where there are any, -mfma."""
    flags = [flag for flag in ["-mfma", "-mavx2"] if "__x86_64__" in macros("")]
    sources = [path for room in ("geometry", "intersect", "shading", "tracer")
               for path in sorted((pathlib.Path(root) / "src" / room).glob("*.c"))
               if not path.name.startswith(("rt_", "whole_", "picture"))]
    fused = re.compile(r"^\s+(vf[mn]\w*|fn?m(add|sub|la|ls)\w*)\s", re.M)
    if flags and not fused.search(assembly(sources[0], ["-mfma", "-ffp-contract=fast"], "")):
        faults.append("FMAs are not recognised where they are asked for")
    for source in sources:
        for real in ("", "-DSURE_FLOAT32"):
            found = fused.search(assembly(source, [*flags, *exact_arguments], real))
            if found:
                faults.append(f"{source.name} {real}: {found[1]}")


def assembly(source, flags, real):
    command = [compiler, "-std=c11", "-O3", *flags, "-I", f"{root}/include", "-S", "-o", "-",
               str(source)] + ([real] if real else [])
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def symbols(*flags):
    out = subprocess.run([nm, "-D", *flags, library], capture_output=True, text=True, check=True)
    return [line.split()[-1].split("@")[0] for line in out.stdout.splitlines()]


def check_symbols():
    exported = symbols("--defined-only")
    if len(exported) < 80:
        faults.append(f"only {len(exported)} exported symbols were read")
    faults.extend(f"exported: {name}" for name in exported if not name.startswith("sure_"))
    for name in symbols("--undefined-only"):
        if name not in WANTED and not name.startswith(("_", "sure_")):
            faults.append(f"asks the C library for {name}")


check_refusals()
check_contraction()
check_symbols()
for fault in faults:
    print(fault)
print("0 passed, 1 failed" if faults else "1 passed, 0 failed")
sys.exit(1 if faults else 0)
