#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The library alone on other architectures: the very same bits of every answer.

    test_arch.py ROOT SCRATCH MESON COMPILER PROGRAM LIBRARY

For each architecture the library is built by its cross compiler, and answers.c, which prints all
that each tier answers, runs under qemu and by this machine's LIBRARY: the same bytes, for cases of
each shape and regime that PROGRAM writes. Without the flags that an architecture needs its build is
refused by the headers, if there are any such flags."""
import concurrent.futures
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from pages import verdict  # noqa: E402

# What its tools begin with; what meson calls it, and its order of bytes; how qemu is called; and
# flags beyond the project's (docs/building.md).
ARCHITECTURES = {
    "aarch64-linux-gnu": ("aarch64", "little", "qemu-aarch64", []),
    "arm-linux-gnueabihf": ("arm", "little", "qemu-arm", []),
    "i686-linux-gnu": ("x86", "little", "qemu-i386", ["-msse2", "-mfpmath=sse"]),
    "riscv64-linux-gnu": ("riscv64", "little", "qemu-riscv64", []),
    "s390x-linux-gnu": ("s390x", "big", "qemu-s390x", ["-fexcess-precision=fast"]),
}
CASES = 10  # of each shape and regime
TIERS = 5
MACHINE = """\
[binaries]
c = '{prefix}-gcc'
ar = '{prefix}-ar'
strip = '{prefix}-strip'
[host_machine]
system = 'linux'
cpu_family = '{family}'
cpu = '{family}'
endian = '{endian}'
[built-in options]
c_args = {flags}
"""
REFUSED = "surehit needs FLT_EVAL_METHOD 0"


class Fault(Exception):
    pass


def run(*command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, **options)
    if done.returncode != 0:
        raise Fault(f"{' '.join(map(str, command))}:\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout


class Architecture:
    def __init__(self, options, prefix):
        self.root, self.meson, self.prefix = options["root"], options["meson"], prefix
        self.family, self.endian, self.qemu, self.flags = ARCHITECTURES[prefix]
        self.folder = options["scratch"] / prefix

    def library(self):
        machine = self.folder.with_suffix(".ini")
        machine.write_text(MACHINE.format(**vars(self)))
        run(*self.meson, "setup", self.folder, self.root, "--cross-file", machine,
            "-Dtools=disabled", "-Dgmp=disabled", "-Ddefault_library=static", "-Dwerror=true")
        run("ninja", "-C", self.folder)
        return self.folder / "src/libsurehit.a"

    def answers(self, cases):
        program = self.folder / "answers"
        run(f"{self.prefix}-gcc", "-std=c11", "-O2", *self.flags, f"-I{self.root}/include",
            f"{self.root}/tests/arch/answers.c", self.library(), "-lm", "-static", "-o", program)
        return run(self.qemu, program, input=cases)

    def check_refused(self):
        if self.flags:
            done = subprocess.run([f"{self.prefix}-gcc", "-std=c11", f"-I{self.root}/include",
                                   "-fsyntax-only", f"{self.root}/src/numbers/exact.c"],
                                  capture_output=True, text=True)
            if REFUSED not in done.stderr:
                raise Fault(f"without {' '.join(self.flags)} the build is not refused")


def check(options, prefix, cases, native):
    one = Architecture(options, prefix)
    one.check_refused()
    answers = one.answers(cases).splitlines()
    if len(answers) != len(native):
        raise Fault(f"{len(answers)} answers, and {len(native)} here")
    wrong = [i for i, (there, here) in enumerate(zip(answers, native)) if there != here]
    if wrong:
        case = cases.splitlines()[wrong[0] // TIERS]
        raise Fault(f"{len(wrong)} answers of {len(native)} differ, the first of\n{case}\n"
                    f"{answers[wrong[0]]}\nhere\n{native[wrong[0]]}")
    print(f"{prefix}: {len(answers)} answers, the same bits", flush=True)


def native_answers(options, cases):
    program, library = options["scratch"] / "answers", options["library"]
    run(*options["compiler"], "-std=c11", "-O2", f"-I{options['root']}/include",
        f"{options['root']}/tests/arch/answers.c", library, f"-Wl,-rpath,{library.parent}",
        "-o", program)
    return run(program, input=cases).splitlines()


def main():
    root, scratch, meson, compiler, program, library = sys.argv[1:]
    options = {"root": pathlib.Path(root), "scratch": pathlib.Path(scratch),
               "meson": meson.split(), "compiler": compiler.split(),
               "library": pathlib.Path(library).resolve()}
    shutil.rmtree(scratch, ignore_errors=True)
    options["scratch"].mkdir(parents=True)
    cases = run(pathlib.Path(program).resolve(), "cases", "--count", CASES)
    native = native_answers(options, cases)
    faults = [] if len(native) > 1000 * TIERS else [f"only {len(native)} answers"]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = {prefix: pool.submit(check, options, prefix, cases, native)
                for prefix in ARCHITECTURES}
    for prefix, job in jobs.items():
        if isinstance(job.exception(), Fault):
            faults.append(f"{prefix}: {job.exception()}")
        else:
            job.result()
    return verdict(faults)


sys.exit(main())
