# SPDX-License-Identifier: MIT
"""Makes the package: pack.py FOLDER VERSION FILE... puts these files into the folder, package.json
with its version, and `npm pack` makes the tarball beside it."""
import pathlib
import shutil
import subprocess
import sys

folder, version = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
for path in map(pathlib.Path, sys.argv[3:]):
    if path.suffix == ".in":
        text = path.read_text().replace("@version@", version)
        (folder / path.stem).write_text(text)
    elif path.name == "javascript.md":
        shutil.copy(path, folder / "README.md")
    else:
        shutil.copy(path, folder)
subprocess.run(["npm", "pack", "--silent", "--pack-destination", str(folder.parent), str(folder)],
               check=True, stdout=subprocess.DEVNULL)
