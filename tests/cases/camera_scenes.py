#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The scenes of the regime camera: src/cases/regimes/camera_scenes.jsonl is what the scenes make.

    camera_scenes.py PROGRAM ROOT [--accept]

PROGRAM is camera_scenes.c. Fails where the file is other than what it writes; --accept writes it.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

program, root = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
sys.dont_write_bytecode = True
sys.path.insert(0, str(root / "tests/bench"))
import frame_scenes  # noqa: E402

# Our scenes that are no test of something hard, and those of the frame bench: a crowd's windows are
# as large as some of its solids.
SCENES = ["default", "mirrors", "wild", "falloff", "inside", "photons_glass", "photons_matte",
          "photons_mirror", "boxes"]
FRAMES = {"S": "", "M": ":64x36", "L": ":16x8"}

path = root / "src/cases/regimes/camera_scenes.jsonl"
with tempfile.TemporaryDirectory() as folder:
    asked = [str(root / f"tests/scenes/{name}.rt") for name in SCENES]
    asked += [frame_scenes.write(folder, name, "rt") + window for name, window in FRAMES.items()]
    made = subprocess.run([program, *asked], check=True, capture_output=True, text=True).stdout
found = [json.loads(line) for line in made.splitlines()]
made = "".join(json.dumps(one) + "\n" for one in found)  # in the fewest digits
if sys.argv[3:] == ["--accept"]:
    path.write_text(made)
elif path.read_text() != made:
    sys.exit(f"{path}: other than what the scenes make; to renew it add --accept")
print(len(found), "pictures and objects")
