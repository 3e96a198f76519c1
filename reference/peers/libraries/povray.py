#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""POV-Ray's trace() of its primitives (https://www.povray.org/documentation/3.7.0/r3_3.html), by a
scene that goes on for ever. unit: t is told from the point; local: a plane's distance is from the
origin; ray: there is no range; surface=miss, scale: nothing nearer than 1e-4 is seen. A cylinder
or cone below SHORTEST ends it ("Degenerate"): that is refused here."""
import ctypes
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile

SHAPES = {"plane": "plane { z, 0 }", "disc": "disc { 0, z, G }", "sphere": "sphere { 0, D }",
          "cylinder": "cylinder { 0, F * z, G }", "cone": "cone { 0, G, F * z, 0 }",
          "box": "box { 0, <D, E, F> }"}
SCENE = """#version 3.6; #while (1) #fopen Ready "{ready}" write #fclose Ready
#fopen Asked "{asked}" read #fopen Answers "{answers}" write #read (Asked, Count)
#while (Count > 0) #read (Asked, Shape, Ox, Oy, Oz, Dx, Dy, Dz, A, B, C, D, E, F, G)
#if (Shape < 0) #write (Answers, "invalid\\n") #else
#switch (Shape) {cases} #end #declare N = 0 * x; #declare O = <Ox, Oy, Oz>;
#declare T = vdot(trace(S, O, <Dx, Dy, Dz>, N) - O, <Dx, Dy, Dz>); #if (vlength(N) > 0)
#write (Answers, "hit ", str(T, 0, 20), "\\n") #else #write (Answers, "miss\\n") #end
#end #declare Count = Count - 1; #end #fclose Asked #fclose Answers #end"""
SHORTEST = 1e-10
ENTRY = "unit local ray surface=miss scale=1e-2..1e4"
if sys.argv[1:] == ["--about"]:
    said = subprocess.run(["povray", "--version"], capture_output=True, text=True).stderr
    version = said.split("POV-Ray ")[1].split()[0]
    print(json.dumps({"library": "POV-Ray", "entry": ENTRY, "version": version}))
    sys.exit()
at = {"cases": "".join(f"#case ({i}) #declare S = {SHAPES[shape]}; #break "
                       for i, shape in enumerate(SHAPES))}
with tempfile.TemporaryDirectory() as folder:  # what is open is reached without it
    for name in "scene", "asked", "ready", "answers":
        (os.mkfifo if name in ("ready", "answers") else os.mknod)(f"{folder}/{name}")
        at[name] = f"/proc/{os.getpid()}/fd/{os.open(f'{folder}/{name}', os.O_PATH)}"
pathlib.Path(at["scene"]).write_text(SCENE.format(**at))
subprocess.Popen(["povray", f"+I{at['scene']}", "-F", "-D", "+W1", "+H1"],
                 stderr=subprocess.DEVNULL,
                 preexec_fn=lambda: ctypes.CDLL(None).prctl(1, signal.SIGKILL))  # ends with this
signal.signal(signal.SIGCHLD, lambda *_: os._exit(1))  # and this with it
print("ready", *SHAPES, ENTRY, "\n", flush=True)
block = []
for line in sys.stdin:
    if line != "\n":
        shape, *words = line.split()
        numbers = [float.fromhex(word) for word in words[:6] + words[8:]] + 3 * [0.0]
        refused = shape in ("cylinder", "cone") and numbers[11] < SHORTEST
        kind = -1 if refused else [*SHAPES].index(shape)
        block.append(f"{kind},{','.join(map(repr, numbers[:13]))},")
        continue
    pathlib.Path(at["asked"]).write_text("\n".join([f"{len(block)},", *block, "0"]))
    for fifo in "ready", "answers":
        print(end=pathlib.Path(at[fifo]).read_text())
    print(flush=True)
    block = []
