#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Debian's source package of this tree, and the three packages built from it.

    src/packaging/debian.py FOLDER

What they are called and what they hold stands in the folder debian; what else Debian asks for is
made here, from the tree's own version, licence and list of symbols. All is built in a scratch
folder; FOLDER gets nothing unless all is made. Of one commit the packages are the same bytes."""
import datetime
import email.utils
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tests/support"))
from pages import tree_of  # noqa: E402

REVISION = "0surehit1"  # before any of Debian's own
CHANGELOG = """\
surehit ({version}-{revision}) bookworm; urgency=medium

  * What is new in {version} stands in CHANGELOG.md.

 -- {maintainer}  {date}
"""
COPYRIGHT = """\
Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: surehit

Files: *
Copyright: {holders}
License: Expat
{text}
"""


def text_of(path):
    return (ROOT / path).read_text(encoding="utf-8")


def released():
    """The version, which must head the list of changes."""
    version = re.search(r"^ *version: '(.*)'", text_of("meson.build"), re.M)[1]
    if version != re.search(r"^## ([0-9.]+)", text_of("CHANGELOG.md"), re.M)[1]:
        sys.exit(f"debian.py: CHANGELOG.md does not begin with version {version} of meson.build")
    return version


def moment():
    """When the packages say that they were made, whenever that is: the time of the commit, or of
    the list of changes where there is none."""
    if given := os.environ.get("SOURCE_DATE_EPOCH"):
        return int(given)
    if (ROOT / ".git").exists() and shutil.which("git"):
        said = subprocess.run(["git", "-c", f"safe.directory={ROOT}", "-C", ROOT, "log", "-1",
                               "--format=%ct"], capture_output=True, text=True)
        if said.returncode == 0:
            return int(said.stdout)
    return int((ROOT / "CHANGELOG.md").stat().st_mtime)


def changes(version, seconds):
    maintainer = re.search(r"^Maintainer: (.*)", (HERE / "debian/control").read_text(), re.M)[1]
    date = datetime.datetime.fromtimestamp(seconds, datetime.timezone.utc)
    return CHANGELOG.format(version=version, revision=REVISION, maintainer=maintainer,
                            date=email.utils.format_datetime(date))


def licence():
    """LICENSE as Debian writes it: indented, a dot in an empty line."""
    _, holders, text = re.fullmatch(r"(.*?)\n\nCopyright \(c\) (.*?)\n\n(.*)\n",
                                    text_of("LICENSE"), re.S).groups()
    return COPYRIGHT.format(holders=holders, text="\n".join(f" {line or '.'}"
                                                            for line in text.split("\n")))


def symbols(version):
    """Programs that are linked with this version need no older one, whatever they call. Names with
    a dot are the compiler's own."""
    node = re.match(r"\w+", text_of("src/surehit.map"))[0]
    names = [node, *text_of("tests/house/symbols.txt").split()]
    lines = [f"{name}@{node} {version}" for name in names]
    lines.append(rf'(optional|regex)"^sure_\w+\.\w+@{node}$" {version}')
    return ("libsurehit.so.0 libsurehit0 #MINVER#\n* Build-Depends-Package: libsurehit-dev\n"
            + "".join(f" {line}\n" for line in lines))


def pack(archive, top, apart, seconds):
    """The tree's files, with nothing of who packs them; without those of the folder `apart`, if it
    is one of the tree's."""
    def plain(entry):
        entry.mtime, entry.uid, entry.gid, entry.uname, entry.gname = seconds, 0, 0, "", ""
        entry.mode = 0o755 if entry.mode & 0o100 else 0o644
        return entry

    with tarfile.open(archive, "w:xz") as packed:
        for name in sorted(tree_of(ROOT)):
            if ROOT not in apart.parents or apart not in (ROOT / name).parents:
                packed.add(ROOT / name, f"{top}/{name}", filter=plain)


def prepare(scratch, folder, version):
    """The source as Debian has it: an archive, unpacked, and the folder debian in it."""
    seconds, top = moment(), f"surehit-{version}"
    archive = scratch / f"surehit_{version}.orig.tar.xz"
    pack(archive, top, folder, seconds)
    with tarfile.open(archive) as packed:
        packed.extractall(scratch)
    source = scratch / top
    shutil.copytree(HERE / "debian", source / "debian")
    for name, text in {"changelog": changes(version, seconds), "copyright": licence(),
                       "libsurehit0.symbols": symbols(version)}.items():
        (source / "debian" / name).write_text(text, encoding="utf-8")
    return source


def without_debugging():
    """No package of debugging symbols beside each of the three, and no such symbols."""
    words = os.environ.get("DEB_BUILD_OPTIONS", "").split()
    return {**os.environ, "DEB_BUILD_OPTIONS": " ".join([*words, "noautodbgsym"]),
            "DEB_CFLAGS_STRIP": "-g"}


def check(folder):
    if folder == ROOT:
        sys.exit("debian.py: packages in the tree itself would become a part of it")
    if not shutil.which("dpkg-buildpackage") or not shutil.which("dh"):
        sys.exit("debian.py: dpkg-buildpackage or dh is missing; install debhelper, "
                 "and what else docs/building.md names")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        sys.exit(f"debian.py: {error}")


def main(folder):
    version = released()
    check(folder)
    with tempfile.TemporaryDirectory(prefix="surehit-") as made:
        scratch = pathlib.Path(made)
        source = prepare(scratch, folder, version)
        if subprocess.run(["dpkg-buildpackage", "--unsigned-source", "--unsigned-changes"],
                          cwd=source, env=without_debugging()).returncode:
            sys.exit("debian.py: dpkg-buildpackage failed")
        for path in sorted(scratch.iterdir()):
            if path.is_file():
                shutil.copy(path, folder)
                print(folder / path.name)


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]).resolve())
