#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The library alone on other architectures: the very same bits of every answer.

    test_arch.py ROOT SCRATCH MESON COMPILER PROGRAM LIBRARY

For each architecture the library is built by its cross compiler, and answers.c, which prints all
that each tier answers, runs under qemu and by this machine's LIBRARY: the same bytes, for cases of
each shape and regime that PROGRAM writes. Without the flags that an architecture needs its build is
refused by the headers, if there are any such flags."""
import concurrent.futures
import sys

from answers import Answers
from trial import Fault

# What its tools begin with; what meson calls it, and its order of bytes; how qemu is called; and
# flags beyond the project's (docs/building.md).
ARCHITECTURES = {
    "aarch64-linux-gnu": ("aarch64", "little", "qemu-aarch64", []),
    "arm-linux-gnueabihf": ("arm", "little", "qemu-arm", []),
    "i686-linux-gnu": ("x86", "little", "qemu-i386", ["-msse2", "-mfpmath=sse"]),
    "riscv64-linux-gnu": ("riscv64", "little", "qemu-riscv64", []),
    "s390x-linux-gnu": ("s390x", "big", "qemu-s390x", ["-fexcess-precision=fast"]),
}
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


class Architectures(Answers):
    def library_of(self, prefix):
        family, endian, _, flags = ARCHITECTURES[prefix]
        machine = self.write(f"{prefix}.ini", MACHINE.format(prefix=prefix, family=family,
                                                             endian=endian, flags=flags))
        self.run(*self.meson, "setup", prefix, self.root, "--cross-file", machine,
                 "-Dtools=disabled", "-Dgmp=disabled", "-Ddefault_library=static", "-Dwerror=true")
        self.run("ninja", "-C", prefix, "-j1")
        return f"{prefix}/src/libsurehit.a"

    def check_refused(self, prefix, flags):
        words = [f"{prefix}-gcc", "-std=c11", f"-I{self.root}/include", "-fsyntax-only",
                 self.root / "src/numbers/exact.c"]
        try:
            self.run(*words)
        except Fault as fault:
            if REFUSED not in str(fault):
                raise
        else:
            if flags:
                raise Fault(f"without {' '.join(flags)} the build is not refused")

    def check_one(self, prefix):
        _, _, qemu, flags = ARCHITECTURES[prefix]
        self.check_refused(prefix, flags)
        program = self.built(f"answers-{prefix}", f"{prefix}-gcc", *flags,
                             self.library_of(prefix), "-static")
        self.check_answers_of(prefix, f"{qemu} {program}")

    def check_all(self):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            jobs = {prefix: pool.submit(self.check_one, prefix) for prefix in ARCHITECTURES}
        faults = [str(job.exception()) for job in jobs.values()
                  if isinstance(job.exception(), Fault)]
        if faults:
            raise Fault("\n".join(faults))
        for job in jobs.values():
            job.result()


architectures = Architectures(*sys.argv[1:])
architectures.finish(architectures.ask_library, architectures.check_all)
