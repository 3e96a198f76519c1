#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Debian's packages: made of the tree by one command, without a fault of lintian's, and installed
and used in a Debian that has nothing else (use_debs.sh).

    test_debian.py ROOT SCRATCH MESON COMPILER"""
import re
import shlex
import shutil
import sys
import time

from trial import CMAKE, Fault, Trial

MADE = """
libsurehit-dev_{version}-0surehit1_{machine}.deb
libsurehit0_{version}-0surehit1_{machine}.deb
surehit_{version}-0surehit1.debian.tar.xz
surehit_{version}-0surehit1.dsc
surehit_{version}-0surehit1_{machine}.buildinfo
surehit_{version}-0surehit1_{machine}.changes
surehit_{version}-0surehit1_{machine}.deb
surehit_{version}.orig.tar.xz
"""


class Debian(Trial):
    def check_made(self):
        """By the compiler and with the options that a package is made with."""
        self.made = self.scratch / "made"
        began = time.monotonic()
        temporary = self.write("temporary/.keep", "").parent
        self.run("env", "-u", "CC", self.root / "src/packaging/debian.py", self.made,
                 TMPDIR=str(temporary))
        print(f"made in {time.monotonic() - began:.0f} s")
        machine = self.run("dpkg", "--print-architecture").strip()
        expected = MADE.format(version=self.version, machine=machine).split()
        if (found := sorted(path.name for path in self.made.iterdir())) != expected:
            raise Fault(f"made are {found}")
        self.packages = sorted(self.made.glob("*.deb"))
        for package in self.packages:
            self.check_nameless(package, str(temporary))
            print(f"{package.name}: {package.stat().st_size} bytes")

    def check_nameless(self, package, folder):
        """Nothing in it names the folder where it was built, which is another one each time."""
        unpacked = self.scratch / f"unpacked-{package.name}"
        self.run("dpkg-deb", "-x", package, unpacked)
        paths = [path for path in unpacked.rglob("*") if path.is_file()]
        for path in paths:
            if folder.encode() in path.read_bytes():
                raise Fault(f"{path} names the folder where it was built")
        if len(paths) < 3:
            raise Fault(f"{package.name} has {len(paths)} files")

    def check_lintian(self):
        said = self.run("lintian", "--fail-on", "error,warning", "--tag-display-limit", "0",
                        next(self.made.glob("*.changes")))
        print(said)

    def check_used(self):
        """In the Debian 12 that the host's apt knows, of which nothing is left behind."""
        trial = self.write("trial/sphere.c", self.program).parent
        self.write("trial/CMakeLists.txt", CMAKE.format(version=self.version))
        for path in [*self.packages, self.root / "tests/packages/use_debs.sh"]:
            shutil.copy(path, trial)
        for name in ("cases", "vectors"):
            shutil.copytree(self.root / "tests" / name, trial / name)
        host = {name: self.run("sh", "-c", f'. "{self.root}/.ci/debian.sh"; debian_{name}')
                for name in ("sources", "settings")}
        words = shlex.join(["/trial/use_debs.sh", self.version, self.printed.strip()])
        said = self.run(
            "mmdebstrap", "--variant=minbase", "--dpkgopt=force-unsafe-io",
            f"--aptopt={self.write('settings', host['settings'])}",
            "--customize-hook=mkdir \"$1/trial\"",
            f"--customize-hook=sync-in {shlex.quote(str(trial))} /trial",
            f"--customize-hook=chroot \"$1\" sh {words} 2>&1",
            "bookworm", "/dev/null", self.write("sources.list", host["sources"]))
        print(*re.findall(r"^took .*", said, re.M), sep="\n")
        if "\nall went well\n" not in said:
            raise Fault(said[-5000:])


debian = Debian(*sys.argv[1:])
debian.finish(debian.check_made, debian.check_lintian, debian.check_used)
