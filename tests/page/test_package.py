# SPDX-License-Identifier: MIT
"""Installs the tarball in an empty folder, as anybody would, and tries it there: the lines of the
page, the types, then test_package.mjs.

    test_package.py TARBALL FOLDER PAGE NODE NATIVE SPHERE SUREHIT VECTORS [CASES]"""
import pathlib
import re
import shutil
import subprocess
import sys

tarball, folder, page, node, *rest = sys.argv[1:]
folder, here = pathlib.Path(folder).resolve(), pathlib.Path(__file__).resolve().parent
FILE = re.compile(r"(?ms)^<!-- file: (\S+) -->\n```js\n(.*?)^```$")
RUN = re.compile(r"(?ms)^```console\n\$ node (\S+)\n(.*?)^```$")
faults = []


def run(*words, **more):
    return subprocess.run(words, cwd=folder, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, **more)


def install():
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    done = run("npm", "install", "--no-audit", "--no-fund", "--offline",
               str(pathlib.Path(tarball).resolve()))
    if done.returncode != 0:
        sys.exit(done.stdout)


def try_lines():
    text = pathlib.Path(page).read_text()
    for name, body in FILE.findall(text):
        (folder / name).write_text(body)
    shown = RUN.findall(text)
    for name, output in shown:
        said = run(node, name).stdout
        if said != output:
            faults.append(f"node {name}: not what {page} says, but\n{said}")
    if len(shown) < 3:
        faults.append(f"{page}: only {len(shown)} programs")


def try_types():
    shutil.copy(here / "types.ts", folder / "types.mts")
    run(node, "--input-type=module", "-e", (here / "tables.mjs").read_text(), check=True)
    done = run("tsc", "--noEmit", "--strict", "--target", "es2022", "--module", "nodenext",
               "--moduleResolution", "nodenext", "types.mts", "tables.mts")
    if done.returncode != 0:
        faults.append(done.stdout)


install()
try_lines()
try_types()
print("\n".join(faults))
tests = subprocess.run([node, here / "test_package.mjs", folder, *rest])
sys.exit(1 if faults or tests.returncode != 0 else 0)
