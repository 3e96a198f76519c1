# SPDX-License-Identifier: MIT
"""Writes the pictures of the regime camera as C, to standard output: camera_scenes.py JSONL. A line
is a picture, or one of its objects: shape, mirror, index of refraction, box (null: all space) and
fields."""
import json
import sys

EVERYWHERE = [3 * ["-INFINITY"], 3 * ["INFINITY"]]


def in_c(value):
    return "{" + ", ".join(map(in_c, value)) + "}" if isinstance(value, list) else str(value)


def print_table(kind, name, rows):
    print(f"{kind} {name}[] = {{", *(row + "," for row in rows), "};", sep="\n")


with open(sys.argv[1], encoding="utf-8") as lines:
    records = [json.loads(line) for line in lines]
objects = [one for one in records if isinstance(one, list)]
lights, pictures, first = [], [], 0
for at, one in enumerate(records):
    if isinstance(one, list):
        continue
    count = next((i for i, other in enumerate(records[at + 1:]) if isinstance(other, dict)),
                 len(records) - at - 1)
    pictures.append(f"""{{.name = "{one['name']}", .boxes = boxes + {first},
 .columns = {one['window'][0]}, .rows = {one['window'][1]}, .extent = {one['extent']},
 .scene = {{.objects = objects + {first}, .materials = materials + {first}, .object_count = {count},
  .lights = lights + {len(lights)}, .light_count = {len(one['lights'])},
  .camera = {in_c(one['camera'])}, .turn = {in_c([one['turn']])}, .width = {one['size'][0]},
  .height = {one['size'][1]}}}}}""")
    lights += one["lights"]
    first += count

print('#include "camera_pictures.h"\n#include <math.h>')
print_table("static const sure_object", "objects",
            (f"{{SURE_SHAPE_{shape.upper()}, {{.{shape} = {in_c(fields)}}}}}"
             for shape, _, _, _, *fields in objects))
print_table("static const sure_material", "materials",
            (f"{{.mirror = {mirror}, .refract = {index}}}" for _, mirror, index, *_ in objects))
print_table("static const sure_bounds", "boxes", (in_c(one[3] or EVERYWHERE) for one in objects))
print_table("static const sure_light", "lights", (f"{{.position = {in_c(at)}}}" for at in lights))
print_table("const camera_picture", "camera_pictures", pictures)
print("const int camera_picture_count = sizeof camera_pictures / sizeof *camera_pictures;")
