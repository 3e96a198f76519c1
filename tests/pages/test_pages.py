#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every command of every page runs as it is printed.

    test_pages.py ROOT SCRATCH [PAGE or FOLDER ...]

The tree is copied to SCRATCH, ./run builds it there, and each page's commands run in that folder in
their order, with what earlier ones of the page have made. A page must leave the tree's own files as
they were. Commands are fenced as `sh`, or as `console` where their output stands below them: it
must be that, and "..." stands for any lines. `./run ...` between backticks is a command, too,
unless it has a placeholder (a word in capitals, or ...). Comments right above a block say what no
reader needs:

    <!-- file: NAME -->         the block, in any language, is this file
    <!-- from: FILE -->         a part of this file
    <!-- status: N -->          the commands end with this exit status
    <!-- here: LONG => SHORT -->  what this test puts in the place of something that takes long
    <!-- not run: REASON -->    the block can't run here
    <!-- needs: PATH -->        it runs where this is: what may be out of reach

Nothing else may look like a command, and no block is left out without a reason. The pages of
docs/gallery need libraries that few have: they run where they are named, and without ./run."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from pages import verdict  # noqa: E402

SECONDS = 1800
LANGUAGES = {"sh", "console", "text", "c", "cpp", "python", "yaml", "json", "rt",
             "cmake", "ini", "js"}
FENCE = re.compile(r"(?ms)^```(\w*)\n(.*?)^```$")
NOTE = re.compile(r"<!-- (file|from|status|here|needs|not run): (.*?) -->\n")
COMMAND = re.compile(r"\$ |(?:\./\w|surehit|meson|ninja|cc|gcc|git|make|fuzz/run|python3|pkg-config"
                     r"|build/\S|tests/\S+\.py|apt-get|export|echo|cp|mkdir|cat|sed|grep) ?")
NAMED = re.compile(r"surehit [a-z]+( --[a-z-]+)*")  # no command, but its name
PLACEHOLDER = re.compile(r"\b[A-Z]{1,}\b(?!=)|\.\.\.")


class Block:
    """A fenced block, or a command between backticks, which has no language."""

    def __init__(self, page, text, start, language, body):
        self.page, self.language, self.body = page, language, body
        self.line = text.count("\n", 0, start) + 1
        self.notes = []
        while language and (above := re.search(NOTE.pattern + r"\Z", text[:start])):
            self.notes.append((above[1], above[2]))
            start = above.start()

    def __str__(self):
        return f"{self.page}:{self.line}"

    def note(self, name):
        return next((value for key, value in self.notes if key == name), None)

    def here(self, command):
        for key, value in self.notes:
            if key == "here":
                long, short = value.split(" => ")
                if long not in self.body:
                    raise Fault(f"'{long}' is not in the block")
                command = command.replace(long, short)
        return command


class Fault(Exception):
    pass


def blocks_of(page, text):
    """In their order."""
    found = [(match.start(), Block(page, text, match.start(), match[1] or "text", match[2]))
             for match in FENCE.finditer(text)]
    prose = FENCE.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
    for match in re.finditer(r"`([^`]+)`", prose):
        command = " ".join(match[1].split())
        if re.match(r"\./run (-|[a-z]+ )", command) and not PLACEHOLDER.search(command):
            found.append((match.start(), Block(page, prose, match.start(), "", command + "\n")))
    return [block for _, block in sorted(found, key=lambda pair: pair[0])], prose


def stray_commands(page, prose):
    """What a reader would paste and nothing tries."""
    for number, line in enumerate(prose.splitlines(), 1):
        if re.match(r"    ", line) and COMMAND.match(line.strip()):
            yield f"{page}:{number}: a command that is not fenced as sh: {line.strip()}"
    for match in re.finditer(r"`(surehit [^`]*)`", prose):
        words = " ".join(match[1].split())
        if not NAMED.fullmatch(words) and not PLACEHOLDER.search(words):
            number = prose.count("\n", 0, match.start()) + 1
            yield f"{page}:{number}: no `surehit` is on the PATH after ./run: {words}"


def wrong_targets(root, page, text):
    """What ninja is said to make, and no meson.build has."""
    builds = "".join(path.read_text() for path in root.rglob("meson.build"))
    for folder, target in re.findall(r"meson compile -C (\S+) ([\w-]+)", text):
        known = folder in ("build/test", "build/page") or f"meson setup {folder}" in text
        if not known or f"'{target}'" not in builds:
            yield f"{page}: no such target: {folder}, {target}"


class Copy:
    """The tree in another folder, as ./run leaves it."""

    def __init__(self, root, folder):
        self.folder = folder
        shutil.rmtree(folder, ignore_errors=True)
        skipped = shutil.ignore_patterns(".git", "build", "b", "out", "__pycache__", "node_modules",
                                         folder.name)
        shutil.copytree(root, folder, ignore=skipped, symlinks=True)
        modules = "reference/peers/libraries/node/node_modules"  # npm's, where they are
        (folder / modules).symlink_to(root / modules)
        self.own = dict(self.files())
        self.environment = {**os.environ, "DESTDIR": str(folder / "build/root"),
                            "CFLAGS": "-O1", "CXXFLAGS": "-O0"}

    def files(self):
        """(path, contents) of all but what is built."""
        for path in self.folder.rglob("*"):
            parts = path.relative_to(self.folder).parts
            if path.is_file() and parts[0] not in ("build", "out") and "__pycache__" not in parts:
                yield path, path.read_bytes()

    def restore(self):
        """Takes away what is new. The files of the tree that were changed."""
        changed = []
        now = dict(self.files())
        for path in now.keys() - self.own.keys():
            path.unlink()
        for path, contents in self.own.items():
            if now.get(path) != contents:
                path.write_bytes(contents)
                changed.append(str(path.relative_to(self.folder)))
        return changed

    def installed(self):
        """The environment of somebody who has installed the library where systems look for it."""
        root = self.folder / "build/root"
        found = next(root.rglob("surehit.pc"), None)
        return {} if not found else {
            "PKG_CONFIG_PATH": str(found.parent), "PKG_CONFIG_SYSROOT_DIR": str(root),
            "LD_LIBRARY_PATH": str(found.parent.parent)}

    def run(self, commands):
        """Exit status, standard output, and both outputs."""
        done = subprocess.run(["sh", "-ec", commands], cwd=self.folder, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=SECONDS,
                              env={**self.environment, **self.installed()})
        return done.returncode, done.stdout, done.stdout + done.stderr


def check_status(block, status, said):
    if status != int(block.note("status") or 0):
        raise Fault(f"exit status {status}\n{said[-3000:]}")


def dialogue(body):
    """(command, what it prints) of a console."""
    parts = re.split(r"(?m)^\$ ", body)
    if parts[0]:
        raise Fault("a console begins with `$ `")
    for part in parts[1:]:
        command, _, output = part.partition("\n")
        while command.endswith("\\"):
            more, _, output = output.partition("\n")
            command += "\n" + more
        yield command, output


def run_block(copy, block):
    if name := block.note("file"):
        (copy.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (copy.folder / name).write_text(block.body)
        return
    if block.language == "console":
        for command, expected in dialogue(block.body):
            status, out, said = copy.run(block.here(command))
            pattern = re.escape(expected).replace(re.escape("...\n"), r"(?s:.*\n)")
            if not re.fullmatch(pattern, out):
                raise Fault(f"{command}\nprints, with status {status}:\n{said[:3000]}")
        check_status(block, status, said)
    else:
        status, _, said = copy.run(block.here(block.body))
        check_status(block, status, said)


def is_run(block):
    return block.note("file") or block.language in ("", "sh", "console")


def run_page(copy, page, text):
    """What went wrong."""
    blocks, prose = blocks_of(page, text)
    faults = [*stray_commands(page, prose), *wrong_targets(copy.folder, page, text)]
    count = 0
    for block in blocks:
        if block.language not in LANGUAGES | {""}:
            faults.append(f"{block}: a block in no language, or another: '{block.language}'")
        elif reason := block.note("not run"):
            print(f"{block}: not run: {reason}")
        elif (path := block.note("needs")) and not (copy.folder / path).exists():
            print(f"{block}: not run: {path} is not here")
        elif (source := block.note("from")) and \
                block.body not in (copy.folder / source).read_text():
            faults.append(f"{block}: not in {source}")
        elif is_run(block):
            count += 1
            try:
                run_block(copy, block)
            except (Fault, subprocess.TimeoutExpired) as fault:
                faults.append(f"{block}: {fault}")
    faults += [f"{page}: changes {path}" for path in copy.restore()]
    if count:
        print(f"{page}: {count} blocks", flush=True)
    return faults


def main():
    root, folder = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
    pages = sys.argv[3:] or ["README.md", *sorted(str(path.relative_to(root))
                                                  for path in (root / "docs").rglob("*.md")
                                                  if path.parent.name != "gallery")]
    pages = [str(path.relative_to(root)) for page in pages
             for path in (sorted((root / page).glob("*.md")) or [root / page])]
    texts = {page: (root / page).read_text(encoding="utf-8") for page in pages}
    copy = Copy(root, folder)
    if any("./run" in text for text in texts.values()):
        status, _, said = copy.run("./run --version")
        if status != 0:
            return verdict(["./run --version: " + said])
    faults = [fault for page, text in texts.items() for fault in run_page(copy, page, text)]
    return verdict(faults)


if __name__ == "__main__":
    sys.exit(main())
