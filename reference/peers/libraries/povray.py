#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""POV-Ray's trace() of its primitives (https://www.povray.org/documentation/3.7.0/r3_3.html), by a
scene that goes on for ever, povray.pov. unit: t is told from the point; local: a plane's distance
is from the origin; ray: there is no range; surface=miss, scale: none is seen within 1e-4."""
import ctypes
import itertools
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile

SHAPES = ["plane", "disc", "sphere", "cylinder", "cone", "box"]  # as povray.pov counts them
ENTRY = "unit local ray surface=miss scale=1e-2..1e4"
if sys.argv[1:] == ["--about"]:
    said = subprocess.run(["povray", "--version"], capture_output=True, text=True).stderr
    version = said.split("POV-Ray ")[1].split()[0]
    print(json.dumps({"library": "POV-Ray", "entry": ENTRY, "version": version}))
    sys.exit()
FILES = [pathlib.Path(f"/proc/self/fd/{number}") for number in (100, 101, 102)]
with tempfile.TemporaryDirectory() as folder:  # what is open is reached without it
    for file, make in zip(FILES, (os.mkfifo, os.mknod, os.mkfifo)):
        make(f"{folder}/{file.name}")
        os.dup2(os.open(f"{folder}/{file.name}", os.O_PATH), int(file.name))
subprocess.Popen(["povray", "+I" + __file__.replace(".py", ".pov"), "-F", "-D", "+W1", "+H1"],
                 pass_fds=(100, 101, 102), stderr=subprocess.DEVNULL,
                 preexec_fn=lambda: ctypes.CDLL(None).prctl(1, signal.SIGKILL))  # ends with this
signal.signal(signal.SIGCHLD, lambda *_: os._exit(1))  # and this with it
print("ready", *SHAPES, ENTRY, "\n", flush=True)
while block := list(itertools.takewhile("\n".__ne__, sys.stdin)):
    asked = [f"{len(block)},"]
    for shape, *words in map(str.split, block):
        numbers = [float.fromhex(word) for word in words[:6] + words[8:]] + 3 * [0.0]
        asked.append(f"{SHAPES.index(shape)},{','.join(map(repr, numbers[:13]))},")
    FILES[1].write_text("\n".join([*asked, "0"]))
    print(FILES[0].read_text() + FILES[2].read_text(), flush=True)
