#!/usr/bin/env python3
"""What holds of the build itself. Arguments: source root, C compiler, nm, the built library.

Arithmetic that is not IEEE's is refused; the library exports nothing but sure_*; it allocates nothing and
does no input or output."""
import pathlib
import subprocess
import sys

root, compiler, nm, library = sys.argv[1:5]
faults = []

REFUSED = ["-ffast-math", "-Ofast", "-fassociative-math -fno-signed-zeros -fno-trapping-math",
           "-freciprocal-math", "-ffinite-math-only"]
# What the C library may be asked for: correctly rounded or exact functions, and the angles' own.
WANTED = {"cos", "cosf", "sin", "sinf", "sincos", "sincosf", "tan", "tanf", "sqrt", "sqrtf", "frexp", "frexpf", "ldexp",
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
check_symbols()
for fault in faults:
    print(fault)
print("0 passed, 1 failed" if faults else "1 passed, 0 failed")
sys.exit(1 if faults else 0)
