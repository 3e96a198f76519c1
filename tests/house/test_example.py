#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""In C and in C++, each installed header compiles alone, and the README's program compiles against
the installed library and prints what the README says. Arguments: source root, build root, meson,
pkg-config, C compiler, C++ compiler or ''."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from pages import verdict  # noqa: E402

root, build, meson, pkg_config, *compilers = sys.argv[1:]
text = (pathlib.Path(root) / "README.md").read_text()
program = next(code for code in re.findall(r"```c\n(.*?)```", text, re.S) if "int main" in code)
expected = re.search(r"and prints `(.*?)`", text)[1]
faults = []
STRICT = ["-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Werror"]
LANGUAGES = [["-xc", "-std=c11", "-Wstrict-prototypes"], ["-xc++", "-std=c++17"]]

with tempfile.TemporaryDirectory() as folder:
    place = pathlib.Path(folder)
    subprocess.run([*meson.split(), "install", "-C", build, "--destdir", folder, "--no-rebuild"],
                   check=True, stdout=subprocess.DEVNULL)
    config = next(place.rglob("surehit.pc"))
    found = {**os.environ, "PKG_CONFIG_PATH": str(config.parent), "PKG_CONFIG_SYSROOT_DIR": folder}
    flags = subprocess.run([pkg_config, "--cflags", "--libs", "surehit"], env=found, check=True,
                           capture_output=True, text=True).stdout.split()
    libraries = str(next(place.rglob("libsurehit.so")).parent)
    headers = sorted(place.rglob("surehit/*.h"))
    if len(headers) < 30:
        faults.append(f"only {len(headers)} headers are installed")
    for compiler, ending, language in zip(compilers, (".c", ".cpp"), LANGUAGES):
        if not compiler:
            continue
        for header in headers:
            made = subprocess.run([*compiler.split(), *language, *STRICT, *flags, "-fsyntax-only",
                                   "-include", str(header), "-"], input="extern int alone;",
                                  text=True, capture_output=True)
            if made.returncode != 0:
                faults.append(f"{header.name} alone: {made.stderr}")
        source = place / f"program{ending}"
        source.write_text(program)
        made = subprocess.run([*compiler.split(), "-Wall", "-Wextra", "-Werror", str(source), "-o",
                               str(place / "program"), *flags], capture_output=True, text=True)
        if made.returncode != 0:
            faults.append(f"{compiler}: {made.stderr}")
            continue
        out = subprocess.run([str(place / "program")], capture_output=True, text=True,
                             env={**os.environ, "LD_LIBRARY_PATH": libraries}).stdout
        if out.strip() != expected:
            faults.append(f"{compiler}: printed {out!r}, the README says {expected!r}")

sys.exit(verdict(faults))
