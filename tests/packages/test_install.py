#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What `meson install` installs: that and no more, and each of it is used.

    test_install.py ROOT SCRATCH MESON COMPILER

Manual pages keep the rules of man(7) and have every command and option of --help; words are
completed in bash and fish, and zsh takes its script; peers are asked where they are installed and
nowhere else."""
import json
import re
import shutil
import sys

from trial import Fault, Trial

# Below the prefix; * is a version, and each line one file at least, those in brackets any number.
INSTALLED = """
bin/surehit
include/surehit/*.h
lib/cmake/surehit/surehitConfig.cmake
lib/cmake/surehit/surehitConfigVersion.cmake
lib/libsurehit.a
lib/libsurehit.so
lib/libsurehit.so.0
lib/libsurehit.so.{version}
lib/pkgconfig/surehit.pc
lib/surehit/peers/libpeer-*.so
share/bash-completion/completions/surehit.bash
share/doc/surehit/CHANGELOG.md
share/doc/surehit/LICENSE
share/doc/surehit/README.md
share/doc/surehit/docs/**
share/doc/surehit/docs/building.md
share/doc/surehit/docs/examples/renderer.c
share/fish/vendor_completions.d/surehit.fish
share/man/man1/surehit.1
share/man/man1/surehit-*.1
share/zsh/site-functions/_surehit
"""
OPTIONS = ["-Dlibdir=lib", "-Dtests=disabled", "-Dreference=disabled", "-Dembree=disabled",
           "-Dlibraries=false", "-Doptimization=0", "-Ddebug=false", "-Dwerror=true"]
BASH = """\
source {script}
compopt() {{ :; }} # only where bash itself completes
COMP_WORDS=({words})
COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))
_surehit
printf '%s\\n' "${{COMPREPLY[@]}}"
"""
TIERS = "float32 textbook stable certain exact"
COMPLETED = {  # words as bash has them, the last to be completed
    "surehit re": "render report regress",
    "surehit render --ti": "--tier --tile --time",
    "surehit render --tier ''": TIERS,
    "surehit bench --tier = ex": "exact",
    "surehit judge --regime ri": "rim",
    "surehit cases --set ''": "2026.1 2026.2",
    "surehit render --falloff =": "none inverse-square",
    "surehit merge -o m": "mine.rt",
    "surehit check m": "mine.rt",
    "surehit render --size ''": "",
}


def pattern(line):
    return re.escape(line).replace(r"\*\*", ".*").replace(r"\*", "[^/]*")


class Install(Trial):
    def check_installed(self):
        self.prefix = self.scratch / "prefix"
        self.run(*self.meson, "setup", "whole", self.root, f"--prefix={self.prefix}", *OPTIONS)
        if json.loads(self.run(*self.meson, "introspect", "--tests", "whole")):
            raise Fault("-Dtests=disabled leaves tests, and Debian's tools would run them")
        self.run("ninja", "-C", "whole")
        self.run(*self.meson, "install", "-C", "whole", "--no-rebuild")
        self.program_path = self.prefix / "bin/surehit"
        found = sorted(str(path.relative_to(self.prefix)) for path in self.prefix.rglob("*")
                       if not path.is_dir())
        lines = [line.format(version=self.version) for line in INSTALLED.split()]
        for line in lines:
            if not any(re.fullmatch(pattern(line), path) for path in found):
                raise Fault(f"not installed: {line}")
        for path in found:
            if not any(re.fullmatch(pattern(line), path) for line in lines):
                raise Fault(f"installed and in no list: {path}")
        if self.run(self.program_path, "--version") != f"surehit {self.version}\n":
            raise Fault("surehit --version is another one")

    def helps(self):
        """(command or '', its --help)"""
        help_of_all = self.run(self.program_path, "--help")
        listed = re.search(r"Commands;.*?\n((?:  \S.*\n)+)", help_of_all)[1]
        commands = re.findall(r"^  (\S+)", listed, re.M)
        if len(commands) < 10:
            raise Fault(f"only {len(commands)} commands are in --help")
        return [("", help_of_all)] + [(command, self.run(self.program_path, command, "--help"))
                                      for command in commands]

    def check_manual(self):
        """A page each, and every option of --help in it. No page has a date: none depends on it."""
        pages = self.prefix / "share/man/man1"
        helps = self.helps()
        names = {f"surehit-{command}.1" if command else "surehit.1" for command, _ in helps}
        if names != {path.name for path in pages.iterdir()}:
            raise Fault(f"pages are of other commands: {sorted(names)}")
        for command, help_text in helps:
            page = pages / (f"surehit-{command}.1" if command else "surehit.1")
            said = self.run("man", "--warnings", "-E", "UTF-8", "-l", page, MANWIDTH="80",
                            LC_ALL="C.UTF-8")
            option = r"(?:-h, )?(?:-(\w)|--([a-z-]+))(?=[ =]|$)"
            options = set(re.findall("^ {2,6}" + option, help_text, re.M))
            listed = set(re.findall("^ {7}" + option, said, re.M))
            if options != listed or ("", "help") not in options or "<standard input>" in said:
                raise Fault(f"{page.name}: of --help and not there, or the other way round: "
                            f"{options ^ listed}\n{said[:500]}")
            self.lint(page)

    def lint(self, page):
        try:
            self.run("mandoc", "-Tlint", "-Wwarning", page)
        except Fault as fault:
            wrong = [line for line in str(fault).splitlines()[1:] if "missing date" not in line]
            if wrong:
                raise Fault("\n".join(wrong)) from None

    def check_completion(self):
        self.write("folder/mine.rt", "")
        script = self.prefix / "share/bash-completion/completions/surehit.bash"
        for words, expected in COMPLETED.items():
            said = self.run("bash", "--norc", "-c", BASH.format(script=script, words=words),
                            cwd=self.scratch / "folder")
            if sorted(said.split()) != sorted(expected.split()):
                raise Fault(f"bash completes {words} by {said.split()}")
        fish = self.prefix / "share/fish/vendor_completions.d/surehit.fish"
        for words in ("surehit re", "surehit render --heat "):
            said = self.run("fish", "--no-config", "-c", f"source {fish}; complete -C '{words}'",
                            HOME=str(self.scratch))
            first = sorted(line.split("\t")[0] for line in said.splitlines())
            if first != (["regress", "render", "report"] if words.endswith("re")
                         else ["error", "stage", "time"]):
                raise Fault(f"fish completes '{words}' by {said}")
        zsh = self.prefix / "share/zsh/site-functions"
        self.run("zsh", "-f", "-n", zsh / "_surehit")
        said = self.run("zsh", "-f", "-c", f"fpath=({zsh} $fpath); autoload -U compinit; "
                        "compinit -D -u; print $_comps[surehit]", HOME=str(self.scratch))
        if said != "_surehit\n":
            raise Fault(f"zsh takes the script for {said!r}")

    def asked(self, program):
        """The routines of its report, without the tiers."""
        self.run(program, "report", "-o", "page.html", "--json", "page.json", "--count", "1",
                 "--shape", "plane", "--regime", "camera", "--quiet")
        document = json.loads((self.scratch / "page.json").read_text(encoding="utf-8"))
        return {who["name"] for who in document["candidates"]} - set(TIERS.split())

    def check_peers(self):
        """Those that are installed, whatever lies where those of a build would be; of the program
        where it was built, the build's."""
        installed = {path.name.removeprefix("libpeer-").removesuffix(".so")
                     for path in (self.prefix / "lib/surehit/peers").iterdir()}
        (self.scratch / "meson-info").mkdir()
        strange = self.scratch / "reference/peers"
        strange.mkdir(parents=True)
        shutil.copy(next((self.prefix / "lib/surehit/peers").iterdir()),
                    strange / "libpeer-strange.so")
        asked = self.asked(self.program_path)
        if installed != asked or len(installed) < 5:
            raise Fault(f"installed are {sorted(installed)}, asked {sorted(asked)}")
        shutil.rmtree(self.prefix / "lib/surehit")
        if asked := self.asked(self.program_path):
            raise Fault(f"none is installed, asked are {sorted(asked)}")
        if installed != (asked := self.asked("whole/src/cli/surehit")):
            raise Fault(f"built are {sorted(installed)}, asked {sorted(asked)}")


install = Install(*sys.argv[1:])
install.finish(install.check_installed, install.check_manual, install.check_completion,
               install.check_peers)
