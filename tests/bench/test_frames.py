# SPDX-License-Identifier: MIT
"""The comparison of frames: test_frames.py SUREHIT [EMBREE_FRAME]

Its scenes are the same bytes each time and everywhere, and the same scene for all; what it counts
and concludes is so."""
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "support")]
import frame_scenes  # noqa: E402
import frames  # noqa: E402
import trade  # noqa: E402
from commands import PROGRAM, InFolder, contents, loaded, put  # noqa: E402

EMBREE = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else None

# Of an .rt, which no function of the C library has a part in.
DIGESTS = {
    "S.rt": "2e4f2cb4df46043fac14361214f5c5dbf9008337b497a47922940a58b3c6b37c",
    "S.objects.rt": "66f2518c476619ce5cbb79e1b52ce14dc3a746807b6399c782c729085aa03e4f",
    "M.rt": "c114bb2ee6e38f76f335fae8c8a8314ffc759e2aa073d15deb312e0119f6d3db",
}

SMALL = "160 90"


def made(folder, *words, hash_seed="0"):
    os.makedirs(folder, exist_ok=True)
    subprocess.run([sys.executable, str(HERE / "frame_scenes.py"), *words[:-1], folder, words[-1]],
                   check=True, env={**os.environ, "PYTHONHASHSEED": hash_seed})
    return {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}


def rendered(scene, picture, *words):
    subprocess.run([PROGRAM, "render", scene, "-o", picture, "--quiet", *words], check=True,
                   stderr=subprocess.DEVNULL)  # a warning: no light
    return picture


def checked(script):
    """The exit status."""
    return subprocess.run([sys.executable, str(HERE / script), ".", "--check"], check=False,
                          stdout=subprocess.DEVNULL).returncode


def write_ppm(path, width, pixels):
    """Of one number a pixel."""
    rgb = b"".join(pixel.to_bytes(3, "big") for pixel in pixels)
    head = b"P6\n# made\n%d %d\n255\n" % (width, len(pixels) // width)
    put(path, head + rgb)
    return path


class TheScenes(InFolder):
    def test_are_the_same_bytes_each_time(self):
        for words in (["S"], ["M"], ["--objects", "S"]):
            first = made("a", *words)
            second = made("b", *words, hash_seed="1")
            self.assertEqual(first, second)
        self.assertEqual(len(first), 9)
        for name, digest in DIGESTS.items():
            self.assertEqual(hashlib.sha256(first[name]).hexdigest(), digest, name)

    def test_surehit_draws_them_all(self):
        for name in ("S", "M", "L"):
            scene = frame_scenes.write(".", name, "rt")
            rendered(scene, "x.ppm", "--size", "16x9")
            self.assertEqual(len(frames.pixels_of("x.ppm")[0]), 3 * 16 * 9)

    def test_every_object_of_the_small_one_is_seen(self):
        scene = frame_scenes.write(".", "S", "rt", objects=True)
        numbers, _ = frames.numbers_of(rendered(scene, "x.ppm"))
        self.assertEqual(set(numbers), set(range(1, 13)))

    @unittest.skipUnless(EMBREE, "not built")
    def test_embree_sees_the_same_objects(self):
        for name in ("S", "M"):
            scene = pathlib.Path(frame_scenes.write(".", name, "rt", objects=True))
            scene.write_text(scene.read_text().replace("R 1280 720", "R " + SMALL))
            ours = rendered(str(scene), "ours.ppm", "--tier", "certain")
            subprocess.run([EMBREE, str(scene), "theirs.ppm", "1"], check=True,
                           stdout=subprocess.DEVNULL)
            off, inside = frames.other_objects(ours, "theirs.ppm")
            self.assertEqual(inside, 0, f"{name}: {off} pixels differ")
            # Rounding to float moves an edge by some 2^-12 of a pixel here: few centres change
            # sides. Half a pixel changes every other one.
            numbers, width = frames.numbers_of(ours)
            at_edge = sum(frames.is_at_edge(numbers, width, i) for i in range(len(numbers)))
            self.assertGreater(at_edge, 1000)
            self.assertLess(100 * off, at_edge)


class ThePictures(InFolder):
    def setUp(self):
        super().setUp()
        self.pixels = [1] * 25
        self.ours = write_ppm("ours.ppm", 5, self.pixels)

    def changed(self, *places):
        pixels = [2 if i in places else pixel for i, pixel in enumerate(self.pixels)]
        return write_ppm("theirs.ppm", 5, pixels)

    def test_other_objects_are_counted(self):
        self.assertEqual(frames.other_objects(self.ours, self.changed()), (0, 0))
        self.assertEqual(frames.other_objects(self.ours, self.changed(0, 12)), (2, 1))
        for end in (2, 10, 14, 22):
            self.assertEqual(frames.other_objects(self.ours, self.changed(end)), (1, 0))
        self.pixels[6] = 3
        self.ours = write_ppm(self.ours, 5, self.pixels)
        self.assertEqual(frames.other_objects(self.ours, self.changed(6, 12, 18)), (3, 1))

    def test_objects_are_told_apart_by_all_of_their_colour(self):
        numbers = [0, 1, 0x102, 0x010203, 0xffffff, 0x20000]
        path = write_ppm("x.ppm", 3, numbers)
        self.assertEqual(frames.numbers_of(path)[0].tolist(), numbers)
        self.assertEqual([frame_scenes.colour_of_object(i) for i in (0, 0x1ff, 0x010202)],
                         [(0, 0, 1), (0, 2, 0), (1, 2, 3)])

    def test_two_roundings_are_no_difference(self):
        def off(pixel):
            return frames.off_in_light(self.ours, write_ppm("b.ppm", 5,
                                                            [pixel] + self.pixels[1:]))
        self.assertEqual([off(0), off(1), off(2), off(3), off(0x000201), off(0x050501)],
                         [0, 0, 0, 1, 1, 1])

    def test_half_a_picture_is_none(self):
        with open(self.ours, "rb+") as file:
            file.truncate(60)
        with self.assertRaises(SystemExit):
            frames.pixels_of(self.ours)


def times(**more):
    return {"wall": 1.0, "cpu": 1.5, "kilobytes": 10000, **more}


RECORD = {
    "cpu": "a cpu", "compiler": "a compiler", "threads": 2, "repeats": 5, "width": 10, "height": 10,
    "versions": {"POV-Ray": "3.7", "Embree": "3.13"}, "missing": ["Tachyon"],
    "times": {
        "S": {"POV-Ray": times(wall=6.0), "Embree": times(build=0.5, frame=0.5),
              "Embree 8-wide": times(build=0.5, frame=0.25),
              "surehit certain": times(read=0, place=0, build=0.25, frame=1.0),
              "surehit textbook": times(read=0, place=0, build=0.25, frame=0.8)},
        "L": {"surehit certain": times(frame=2.4, kilobytes=50000),
              "POV-Ray": times(wall=4.99)},
        "M": {"surehit certain": times(frame=1.0)},
        "XL": {"surehit certain": times(read=0.5, place=1, build=3, frame=15.5, objects=1000001,
                                        kilobytes=500000)}},
    "pictures": {"S": {"POV-Ray": {"light": 12345, "object": 4, "inside": 0},
                       "Embree": {"light": 1, "object": 2, "inside": 3}}},
}


class ThePage(InFolder):
    def setUp(self):
        super().setUp()
        self.part = "\n".join(map(str, frames.page_values(RECORD).values()))

    def row(self, title):
        rows = [line for line in self.part.splitlines() if line.startswith(f"| {title} |")]
        self.assertEqual(len(rows), 1, title)
        return [cell.strip() for cell in rows[0].split("|")[2:-1]]

    def test_bars(self):
        self.assertEqual(self.row("speed-up over POV-Ray, whole process"),
                         ["6.00 (≥ 5)", "–", "**4.99** (≥ 5)"])
        self.assertEqual(self.row("speed-up over Tachyon, whole process"), ["–"] * 3)
        self.assertEqual(self.row("frame rate as a share of Embree's"),
                         ["**0.25** (≥ 0.9)", "–", "–"])
        self.assertEqual(self.row("the same, with the building of the hierarchy"),
                         ["0.60", "–", "–"])
        self.assertEqual(self.row("frame time, `certain` over `textbook`"),
                         ["**1.25** (≤ 1.1)", "–", "–"])

    def test_growth(self):
        self.assertEqual(self.row("time a ray, L over M (100 times the objects)"), ["2.40 (≤ 2.5)"])
        self.assertEqual(self.row("XL: read, place, build and frame, seconds"), ["20.00 (≤ 20)"])
        self.assertEqual(self.row("XL: objects read a second, in millions"), ["2.00 (≥ 1)"])
        self.assertEqual(self.row("bytes an object, at the peak"), ["**512** (≤ 250)"])

    def test_who_is_missing_is_said(self):
        self.assertIn("POV-Ray 3.7, Embree 3.13. Tachyon was missing.", self.part)
        self.assertEqual(self.row("POV-Ray: light off by more than 1/255"), ["12,345"])
        self.assertNotIn("| Tachyon: another", self.part)

    def test_stands_between_its_marks(self):
        page = "before <!-- a -->{}<!-- /a --> after\n<!-- b -->{}<!-- /b -->\n"
        self.assertEqual(frames.pages.filled(page.format("old", "old"), {"a": "1", "b": "\n2\n"}),
                         page.format("1", "\n2\n"))
        for wrong in ("before\n", 2 * page):
            with self.assertRaises(SystemExit):
                frames.pages.filled(wrong, {"a": "1"})

    def test_is_compared(self):
        os.mkdir("docs")
        put("docs/frames.json", json.dumps(RECORD))
        put("docs/tracer.md", "".join(f"<!-- {name} --><!-- /{name} -->\n"
                                      for name in frames.page_values(RECORD)))
        self.assertEqual(checked("frames.py"), 1)
        subprocess.run([sys.executable, str(HERE / "frames.py"), "."], check=True)
        self.assertEqual(checked("frames.py"), 0)
        put("docs/tracer.md", contents("docs/tracer.md").replace(b"6.00", b"6.01"))
        self.assertEqual(checked("frames.py"), 1)
        put("docs/tracer.md", "no marks")
        self.assertEqual(checked("frames.py"), 1)


class TheTrade(InFolder):
    def test_every_object_has_a_colour_of_its_own(self):
        said = trade.objects_alone("#! falloff none\nR 4 3\nA 0.1 1,2,3 # dim\nC 0,0,0 0,0,-1 60\n"
                                   "L 1,1,1 0.5 9,9,9\n\nsp 0,0,-5 2 255,0,0 refl:0.5 # red\n"
                                   "  pl 0,-1,0 0,1,0 7,7,7\n")
        self.assertEqual(said, "#! falloff none\nR 4 3\nA 1 255,255,255\nC 0,0,0 0,0,-1 60\n\n"
                               "sp 0,0,-5 2 0,0,1\npl 0,-1,0 0,1,0 0,0,2\n")
        put("x.rt", said)
        rendered("x.rt", "x.ppm", "--size", "16x9")
        self.assertEqual(set(frames.numbers_of("x.ppm")[0]), {0, 1, 2})

    def test_the_largest_step_and_how_many(self):
        one, other = (write_ppm(f"{name}.ppm", 2, pixels) for name, pixels in
                      (("a", [0, 1, 2, 3]), ("b", [0, 5, 2, 0x2003])))
        self.assertEqual(trade.difference(one, other), (32, 2))
        self.assertEqual(trade.difference(one, one), (0, 0))

    def test_measures_and_checks(self):
        for folder in ("docs", "tests/scenes"):
            os.makedirs(folder)
        for scene in ("default", "inside"):
            put(f"tests/scenes/{scene}.rt", (HERE.parent / f"scenes/{scene}.rt").read_text())
        put("README.md", "<!-- trade --><!-- /trade -->\n<!-- table: x -->\n| | float32 wrong % |"
            " ns | textbook wrong % | ns | certain wrong % | ns | exact wrong % | ns |\n"
            "| all | 20.2 | 1 | 16.3 | 2 | 0 | 3 | 0 | 4 |\n")
        put("docs/tracer.md", "<!-- trade-bars --><!-- /trade-bars -->\n")
        subprocess.run([sys.executable, str(HERE / "trade.py"), ".", "--measure", "--surehit",
                        PROGRAM, "--scenes", "inside", "--repeats", "1", "--scratch", "scratch"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        found = loaded("docs/trade.json")
        self.assertEqual([found["pictures"]["inside"][tier]["other"] for tier in trade.TIERS[1:]],
                         [0, 0, 0])
        self.assertEqual(found["times"]["inside"]["textbook"]["ratio"], 1)
        self.assertEqual(checked("trade.py"), 0)
        put("README.md", contents("README.md").replace(b"20.2 |", b"20.3 |", 1))
        self.assertEqual(checked("trade.py"), 1)


class TheCommand(InFolder):
    def test_measures_whom_it_finds(self):
        said = subprocess.run(
            [sys.executable, str(HERE / "frames.py"), ".", "--measure", "--surehit",
             PROGRAM, "--embree", EMBREE or "", "--povray", "not-here", "--tachyon", "not-here",
             "--scenes", "S", "--repeats", "1", "--record", "record.json",
             "--scratch", "scratch"], check=False, capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertIn("POV-Ray (Debian's package povray) is missing", said.stderr)
        self.assertIn("Tachyon (Debian's package tachyon) is missing", said.stderr)
        record = loaded("record.json")
        self.assertEqual(len(record["missing"]), 2 if EMBREE else 4)
        measured = record["times"]["S"]
        self.assertEqual(set(measured), {"surehit textbook", "surehit certain"} |
                         ({"Embree", "Embree 8-wide"} if EMBREE else set()))
        self.assertEqual(measured["surehit certain"]["objects"], 12)
        for one in measured.values():
            parts = sum(one.get(key, 0) for key in ("read", "place", "build", "frame", "write"))
            self.assertLess(0, one["frame"])
            self.assertLess(parts, one["wall"])
        if EMBREE:
            for who in frames.EMBREES:
                self.assertEqual(record["pictures"]["S"][who]["inside"], 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
