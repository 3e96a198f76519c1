# SPDX-License-Identifier: MIT
"""Writes scenes of random objects, each into a file: random_scenes.py SCENE.rt..."""
import random
import sys

PLANES, SOLIDS, LIGHTS = 2, 40, 3


def vector(*numbers):
    return ",".join(map(float.hex, numbers))


class Scene:
    def __init__(self, seed):
        self.dice = random.Random(seed)

    def place(self, reach):
        return vector(*(self.dice.uniform(-reach, reach) for _ in range(3)))

    def size(self, low, high):
        return (2 ** self.dice.uniform(low, high)).hex()

    def color(self):
        return ",".join(str(self.dice.randrange(40, 256)) for _ in range(3))

    def camera(self):
        """Looks from the outskirts to about the middle."""
        eye = [self.dice.uniform(-7, 7) for _ in range(3)]
        view = [self.dice.uniform(-1, 1) - x for x in eye]
        return f"C {vector(*eye)} {vector(*view)} {self.dice.uniform(40, 110).hex()}"

    def material(self):
        """A third of the surfaces are mirrors, a sixth is clear."""
        dice = self.dice
        more = dice.choice([f" refl:{dice.uniform(0.2, 0.9)}"] * 2 + [f" refr:{dice.uniform(1, 2)}"]
                           + [""] * 3)
        return f"{self.color()} spec:{dice.random()} shine:{dice.randrange(100)}{more}"

    def solid(self):
        name = self.dice.choice(("sp", "cy", "co"))
        axis = "" if name == "sp" else self.place(1)
        height = "" if name == "sp" else self.size(-5, 3)
        return f"{name} {self.place(6)} {axis} {self.size(-5, 2)} {height} {self.material()}"

    def lines(self):
        dice = self.dice
        falls = dice.random() < 0.5
        yield "A 0.15 255,255,255"
        yield self.camera()
        yield f"#! handedness {dice.choice(('left', 'right'))}"
        yield f"#! fov {dice.choice(('vertical', 'horizontal'))}"
        yield f"#! cylinder-position {dice.choice(('middle', 'base'))}"
        yield f"#! cone-position {dice.choice(('middle', 'base', 'apex'))}"
        yield f"falloff {'inverse-square' if falls else 'none'}"
        for _ in range(LIGHTS):
            ratio = dice.uniform(50, 500) if falls else dice.uniform(0.2, 0.8)
            yield f"L {self.place(8)} {ratio} {self.color()}"
        for _ in range(PLANES):
            yield f"pl {self.place(9)} {self.place(1)} {self.material()}"
        for _ in range(SOLIDS):
            yield self.solid()


for number, path in enumerate(sys.argv[1:]):
    with open(path, "w", encoding="ascii") as file:
        file.write("\n".join(Scene(124 + number).lines()) + "\n")
