#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The library where it is a part of something else.

    test_packages.py ROOT SCRATCH MESON COMPILER

It builds alone, with nothing to be found but a C compiler, in so many steps and so much
time of a processor; --unity=on is refused. Installed it is found by pkg-config and by CMake, shared
and static, its headers anywhere; not installed, as a subproject of Meson's, by a wrap file."""
import os
import re
import resource
import shutil
import sys
import tarfile

from trial import CMAKE, Fault, Trial

MOST_STEPS = 140
MOST_SECONDS = 250  # of a processor; ten times what a quiet one needs (docs/building.md)
MESON = """\
project('user', 'c')
executable('user', 'sphere.c', dependencies: dependency('surehit', version: '>={version}'))
"""


class Packages(Trial):
    def check_alone(self):
        nothing = self.scratch / "nothing"
        nothing.mkdir()
        self.alone = {"PKG_CONFIG_LIBDIR": str(nothing)}
        self.run(*self.meson, "setup", "alone", self.root, "-Dtools=disabled", "-Dwerror=true",
                 f"--prefix={self.scratch}/prefix", "-Dlibdir=lib", **self.alone)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        said = self.run("ninja", "-C", "alone", CCACHE_DISABLE="1")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime - before.ru_utime
        steps = int(re.findall(r"^\[\d+/(\d+)\]", said, re.M)[-1])
        print(f"the library alone: {steps} steps, {seconds:.1f} s of a processor")
        if not 50 < steps <= MOST_STEPS:
            raise Fault(f"{steps} steps, and {MOST_STEPS} may be")
        if not 1 < seconds <= MOST_SECONDS:
            raise Fault(f"{seconds} s, and {MOST_SECONDS} may be")
        self.run(*self.meson, "install", "-C", "alone", "--no-rebuild")
        libraries = next((self.scratch / "prefix").rglob("libsurehit.so")).parent
        self.libraries = str(libraries)
        self.write("sphere.c", self.program)

    def check_refused(self):
        """Builds whose sources would see each other's names, or whose operations run together."""
        for compiler, option, words in (
                (self.compiler, "--unity=on", "--unity=on: each source"),
                (self.compiler, "-Dc_args=-ffp-contract=fast", "-ffp-contract=fast: operations"),
                ("clang", "-Dc_args=-ffp-model=precise", "-ffp-model=precise: operations"),
                ("clang", "-Dc_args=-fno-honor-nans", "-fno-honor-nans: operations")):
            try:
                self.run(*self.meson, "setup", "refused", self.root, "-Dtools=disabled", option,
                         CC=compiler)
            except Fault as fault:
                if words not in str(fault):
                    raise
            else:
                raise Fault(f"{option} is set up")

    def check_pkg_config(self):
        """A static program asks for no libsurehit.so, and for no other one that it had not."""
        where = {"PKG_CONFIG_PATH": f"{self.libraries}/pkgconfig"}
        words = {"shared": [], "static": ["--static"]}
        for name, static in words.items():
            said = self.run("pkg-config", "--cflags", "--libs", *static, "surehit", **where)
            flags = said.split()
            if static:
                flags = ["-Wl,-Bstatic", *flags, "-Wl,-Bdynamic"]
            self.run(*self.compiler.split(), "sphere.c", "-o", name, *flags)
            self.check_program(f"./{name}", LD_LIBRARY_PATH=self.libraries)
        if "libsurehit.so.0" not in self.needed("shared"):
            raise Fault(f"the shared program asks for {self.needed('shared')}")
        if any(name.startswith(("libsurehit", "libgmp")) for name in self.needed("static")):
            raise Fault(f"the static program asks for {self.needed('static')}")
        if self.run("pkg-config", "--modversion", "surehit", **where).strip() != self.version:
            raise Fault("pkg-config has another version than meson.build")

    def cmake(self, prefix, folder, version):
        """Sets up in the folder what asks for the version, to be found below the prefix."""
        self.write("cmake/CMakeLists.txt", CMAKE.format(version=version))
        self.write("cmake/sphere.c", self.program)
        self.run("cmake", "-G", "Ninja", "-S", "cmake", "-B", folder,
                 f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release")

    def found_by_cmake(self, prefix, folder):
        self.cmake(prefix, folder, f"{self.version} EXACT")
        self.run("cmake", "--build", folder)
        for kind in ("surehit", "static"):
            self.check_program(f"{folder}/by_{kind}")
        if "libsurehit.so.0" in self.needed(f"{folder}/by_static"):
            raise Fault("surehit::static is shared")

    def check_cmake(self):
        """Exactly and by its release; and a release that is not there is not found."""
        self.found_by_cmake(self.scratch / "prefix", "cmake/build")
        self.cmake(self.scratch / "prefix", "cmake/other", self.version.rpartition(".")[0])
        for release in ("99.0", "0.1", f"{self.version}.1"):
            try:
                self.cmake(self.scratch / "prefix", "cmake/other", release)
            except Fault as fault:
                if f'requested version "{release}"' not in str(fault):
                    raise
            else:
                raise Fault(f"release {release} is found")

    def check_merged(self):
        """Where /lib is a link to /usr/lib, and the prefix /usr."""
        merged = self.scratch / "merged"
        merged.mkdir()
        (merged / "usr").symlink_to(self.scratch / "prefix")
        (merged / "lib").symlink_to("usr/lib")
        self.found_by_cmake(merged, "cmake/merged")

    def check_headers_elsewhere(self):
        """An includedir that is not below the prefix."""
        shutil.rmtree(self.scratch / "prefix/include")
        self.run(*self.meson, "configure", "alone", f"-Dincludedir={self.scratch}/headers")
        self.run(*self.meson, "install", "-C", "alone", **self.alone)
        self.check_pkg_config()
        self.found_by_cmake(self.scratch / "prefix", "cmake/elsewhere")

    def check_subproject(self):
        """The wrap file of docs/building.md, with this tree where it says which to fetch. Compiled
        without optimisation: what is compiled was tried above."""
        page = (self.root / "docs/building.md").read_text(encoding="utf-8")
        wrap = re.search(r"```ini\n(\[wrap-git\].*?)```", page, re.S)
        if not wrap:
            raise Fault("docs/building.md has no wrap file")
        provided = wrap[1][wrap[1].index("[provide]"):]
        packages = self.write("user/subprojects/packagefiles/.keep", "").parent
        with tarfile.open(packages / "surehit.tar", "w") as archive:
            for name in ("meson.build", "meson_options.txt", "include", "src", "LICENSE"):
                archive.add(self.root / name, f"surehit/{name}")
        self.write("user/subprojects/surehit.wrap", "[wrap-file]\ndirectory = surehit\n"
                   f"source_filename = surehit.tar\n{provided}")
        self.write("user/meson.build", MESON.format(version=self.version))
        self.write("user/sphere.c", self.program)
        self.run(*self.meson, "setup", "user/build", "user", "-Doptimization=0", "-Ddebug=false",
                 PKG_CONFIG_PATH="")
        self.run("ninja", "-C", "user/build", "user")
        self.check_program("user/build/user")
        if os.path.exists(self.scratch / "user/build/subprojects/surehit/src/cli"):
            raise Fault("a subproject comes with the program")


packages = Packages(*sys.argv[1:])
packages.finish(packages.check_alone, packages.check_refused, packages.check_pkg_config,
                packages.check_cmake, packages.check_merged, packages.check_headers_elsewhere,
                packages.check_subproject)
