# SPDX-License-Identifier: MIT
"""Pictures are the same bytes whatever goes side by side: every scene of tests/scenes, drawn by
each width of lanes and number of threads, in tiles, of several samples, and as it is where
a certificate is wanted, whose rays go alone.

    test_together.py SUREHIT"""
import os
import pathlib
import subprocess
import sys
import tempfile

SCENES = pathlib.Path(__file__).resolve().parents[1] / "scenes"
ODD = ["--size", "61x37"]  # not of whole packets
WAYS = [("2", "1"), ("4", "2"), ("8", "1"), ("8", "3")]  # lanes, threads
HOW = [[], ["--samples", "9"], ["--tile", "7,3,29x17"]]


def picture(surehit, scene, folder, lanes, words):
    path = os.path.join(folder, "picture.ppm")
    subprocess.run([surehit, "render", str(scene), "-o", path, "--quiet", *ODD, *words], check=True,
                   stdout=subprocess.DEVNULL, env={**os.environ, "SUREHIT_LANES": lanes})
    return pathlib.Path(path).read_bytes()


def main(surehit):
    scenes = sorted([*SCENES.glob("*.rt"), *SCENES.glob("extreme/*.rt")])
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            for how in HOW:
                alone = picture(surehit, scene, folder, "0", [*how, "--threads", "1"])
                wrong += [(scene.name, lanes, threads, *how)
                          for lanes, threads in (WAYS[-1:] if how else WAYS)
                          if picture(surehit, scene, folder, lanes,
                                     [*how, "--threads", threads]) != alone]
            told = picture(surehit, scene, folder, "8",
                           ["--certificate", os.path.join(folder, "certificate")])
            if told != picture(surehit, scene, folder, "8", []):
                wrong.append((scene.name, "told"))
    for case in wrong:
        print(*case)
    print(len(scenes), "scenes,", len(wrong), "pictures are others")
    return 1 if wrong or len(scenes) < 20 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
