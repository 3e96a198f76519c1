#!/usr/bin/env python3
"""POV-Ray's trace() of its primitives (https://www.povray.org/documentation/3.7.0/r3_3.html), by
scenes. unit: t is told from the point; local: a plane's distance is from the origin; ray: there is
no range; surface=miss, scale: nothing is seen nearer than 1e-4 or farther than 2e10."""
import os
import subprocess
import sys
import tempfile

SHAPES = {
    "plane": "plane {{ z, 0 }}", "disc": "disc {{ 0, z, {6} }}",
    "sphere": "sphere {{ 0, {3} }}",
    "cylinder": "cylinder {{ 0, {5} * z, {6} }}",
    "cone": "cone {{ 0, {6}, {5} * z, 0 }}",
    "box": "box {{ 0, <{3}, {4}, {5}> }}",
}
ASKED = """#declare S = {object}; #declare O = <{o}>; #declare D = <{d}>; #declare N = 0 * x;
#declare T = vdot(trace(S, O, D, N) - O, D);
#if (vlength(N) > 0) #write(F, "hit ", str(T, 0, 20), "\\n") #else #write(F, "miss\\n") #end
"""

print("ready", *SHAPES, "unit local ray surface=miss scale=1e-2..1e4\n", flush=True)
block = ""
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    os.mkfifo("answers")
    for line in sys.stdin:
        if line != "\n":
            shape, *numbers = line.split()
            numbers = [repr(float.fromhex(number)) for number in numbers]
            block += ASKED.format(object=SHAPES[shape].format(*numbers[8:]),
                                  o=",".join(numbers[:3]), d=",".join(numbers[3:6]))
            continue
        with open("scene.pov", "w") as scene:
            scene.write('#version 3.6;\n#fopen F "answers" write\n' + block + "#fclose F\n")
        with subprocess.Popen(["povray", "+Iscene.pov", "-F", "-D", "+W1", "+H1"],
                              stderr=subprocess.DEVNULL) as tracing, open("answers") as answers:
            print(answers.read(), flush=True)
            tracing.kill()  # it would sleep
        block = ""
