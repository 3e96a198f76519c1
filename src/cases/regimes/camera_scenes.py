# SPDX-License-Identifier: MIT
"""Writes the pictures of the regime camera as C, to standard output: camera_scenes.py JSONL. A line
is a picture, or one of its objects: shape, mirror, index of refraction, box (null: all space) and
fields."""
import json
import sys

EVERYWHERE = [3 * ["-INFINITY"], 3 * ["INFINITY"]]
NOWHERE = EVERYWHERE[::-1]


def in_c(value):
    return "{" + ", ".join(map(in_c, value)) + "}" if isinstance(value, list) else str(value)


def print_table(kind, name, rows):
    print(f"{kind} {name}[] = {{", *(row + "," for row in rows), "};", sep="\n")


def widest(boxes):
    """The axis along which their middles are farthest apart."""
    middles = [[low + high for low, high in zip(*box)] for box in boxes]
    return max(range(3), key=lambda k: max(m[k] for m in middles) - min(m[k] for m in middles))


def around(boxes):
    return [[end(box[which][k] for box in boxes) for k in range(3)]
            for which, end in ((0, min), (1, max))]


def quarters(bounded):
    """Into halves, and these again."""
    parts = [bounded]
    for _ in range(2):
        halves = []
        for part in parts:
            axis = widest([box for box, _ in part])
            part = sorted(part, key=lambda one: one[0][0][axis] + one[0][1][axis])
            halves += [part[:len(part) // 2], part[len(part) // 2:]]
        parts = [half for half in halves if half]
    return parts


class Hierarchy:
    """Of (box, object), each in a leaf of its own, and of what has no box."""

    def __init__(self, bounded, endless):
        self.nodes, self.slots = [], endless[:]
        if bounded:
            self.add(bounded)

    def add(self, bounded):
        at = len(self.nodes)
        self.nodes.append(None)
        children = [self.child(part) for part in quarters(bounded)]
        children += [(NOWHERE, 0, 0)] * (4 - len(children))
        boxes, first, count = zip(*children)
        bound = [[box[end][k] for box in boxes] for k in range(3) for end in (0, 1)]
        self.nodes[at] = in_c([bound, list(first), list(count), [0]])
        return at

    def child(self, part):
        box = around([box for box, _ in part])
        if len(part) > 1:
            return box, self.add(part), "SURE_BVH_INNER"
        self.slots.append(part[0][1])
        return box, len(self.slots) - 1, 1


with open(sys.argv[1], encoding="utf-8") as lines:
    records = [json.loads(line) for line in lines]
objects = [one for one in records if isinstance(one, list)]
lights, pictures, nodes, slots, hierarchies, first = [], [], [], [], [], 0
for at, one in enumerate(records):
    if isinstance(one, list):
        continue
    count = next((i for i, other in enumerate(records[at + 1:]) if isinstance(other, dict)),
                 len(records) - at - 1)
    boxes = [own[3] for own in records[at + 1:at + 1 + count]]
    endless = [i for i, box in enumerate(boxes) if not box]
    made = Hierarchy([(box, i) for i, box in enumerate(boxes) if box], endless)
    hierarchies.append(f"{{.nodes = {f'nodes + {len(nodes)}' if made.nodes else 'NULL'}, "
                       f".slots = slots + {len(slots)}, .unbounded = {len(endless)}}}")
    nodes += made.nodes
    slots += made.slots
    pictures.append(f"""{{.name = "{one['name']}", .boxes = boxes + {first},
 .columns = {one['window'][0]}, .rows = {one['window'][1]}, .extent = {one['extent']},
 .scene = {{.objects = objects + {first}, .materials = materials + {first}, .object_count = {count},
  .bvh = hierarchies + {len(pictures)},
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
print_table("static const sure_bvh_node", "nodes", nodes)
print_table("static const uint32_t", "slots", map(str, slots))
print_table("static const sure_bvh", "hierarchies", hierarchies)
print_table("static const sure_light", "lights", (f"{{.position = {in_c(at)}}}" for at in lights))
print_table("const camera_picture", "camera_pictures", pictures)
print("const int camera_picture_count = sizeof camera_pictures / sizeof *camera_pictures;")
