# SPDX-License-Identifier: MIT
"""`surehit diff` and `surehit regress`: test_regress.py SUREHIT

Where Chromium is installed, the page is opened in it."""

import base64
import html.parser
import os
import random
import re
import struct
import sys
import unittest
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import browser  # noqa: E402
from commands import (FAULTY, ROOT, InFolder, all_files, contents,  # noqa: E402
                      limit_file_size, loaded, put, respect_permissions, rows_of)

SAME, DIFFERENT, TROUBLE = 0, 1, 2
SIZE = ("--size", "64x48")
LARGE = ("--size", "640x480")

SCENE = """\
A 0.2 255,255,255
C 0,1,6 0,-0.1,-1 70
L -5,6,5 0.7 255,255,255
pl 0,-1,0 0,1,0 200,200,200
sp 0,0,0 2 255,60,60
"""
FAR = """\
A 0.15 255,255,255
C 0,0,30000000 0,0,-1 4.125e-6
L 18000000,21000000,27000000 0.85
sp 0,0,0 2 206,92,70
"""
OTHER = SCENE.replace("sp 0,0,0 2", "sp 0.5,0,0 2")


# Pictures: a list of rows, each a list of (r, g, b).

def noise(width, height, seed):
    dice = random.Random(seed)
    return [[tuple(dice.randrange(256) for _ in range(3)) for _ in range(width)]
            for _ in range(height)]


def changed(image, x, y, step, channels=(1,)):
    """The picture with values of a pixel moved by a step, towards where there is room."""
    rows = [list(row) for row in image]
    rows[y][x] = tuple(c if i not in channels else c + step if c + step < 256 else c - step
                       for i, c in enumerate(rows[y][x]))
    return rows


def ppm(image):
    head = f"P6\n{len(image[0])} {len(image)}\n255\n".encode()
    return head + bytes(c for row in image for pixel in row for c in pixel)


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


PNG_START = b"\x89PNG\r\n\x1a\n"
GREY, RGB, PALETTE, GREY_ALPHA, RGBA = 0, 2, 3, 4, 6


def png_of(width, height, depth, colour, rows, extra=b"", interlaced=False):
    """`rows` are the bytes of each, of every pass where it is interlaced."""
    head = struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, interlaced)
    data = zlib.compress(b"".join(b"\0" + row for row in rows))
    return (PNG_START + chunk(b"IHDR", head) + extra + chunk(b"IDAT", data) + chunk(b"IEND", b""))


def flat(row):
    return bytes(c for pixel in row for c in pixel)


def png(image):
    return png_of(len(image[0]), len(image), 8, RGB, [flat(row) for row in image])


def interlaced_png(image, depth=8, colour=RGB, row_of=flat, extra=b""):
    """Adam7."""
    rows = []
    for x0, y0, dx, dy in ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4),
                           (1, 0, 2, 2), (0, 1, 1, 2)):
        rows += [row_of(row[x0::dx]) for row in image[y0::dy] if row[x0::dx]]
    return png_of(len(image[0]), len(image), depth, colour, rows, extra, interlaced=True)


def packed(values, depth):
    bits = "".join(f"{value:0{depth}b}" for value in values)
    bits += "0" * (-len(bits) % 8)
    return bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8))


def greys(depth):
    """A grey picture of that many bits: its values, and what they are in 8 bits."""
    dice = random.Random(depth)
    most = 2 ** depth - 1
    values = [[dice.randrange(most + 1) for _ in range(11)] for _ in range(5)]
    return values, [[(255 * v // most,) * 3 for v in row] for row in values]


def compared(a, b):
    """What there is to say about two pictures of one size."""
    apart = {(x, y): max(abs(p - q) for p, q in zip(a[y][x], b[y][x]))
             for y in range(len(a)) for x in range(len(a[0])) if a[y][x] != b[y][x]}
    if not apart:
        return {"pixels": 0, "largest": 0}, apart
    xs, ys = [x for x, _ in apart], [y for _, y in apart]
    return {"pixels": len(apart), "largest": max(apart.values()),
            "box": {"x": min(xs), "y": min(ys), "w": max(xs) - min(xs) + 1,
                    "h": max(ys) - min(ys) + 1}}, apart


class TwoPictures(InFolder):
    def diff(self, status, a, b, *words):
        return self.ask(status, "diff", a, b, *words).stdout

    def put_pair(self, image, other):
        put("a", ppm(image))
        put("b", ppm(other))

    def refused(self, data, word):
        put("bad", data)
        put("good.ppm", ppm(noise(2, 2, 0)))
        for pair in (("bad", "good.ppm"), ("good.ppm", "bad")):
            self.fail_with(TROUBLE, f"bad: error: .*{word}.*", "diff", *pair, "-o", "d.ppm")


class Diff(TwoPictures):
    def test_the_same(self):
        image = noise(7, 5, 1)
        put("a.ppm", ppm(image))
        put("b", ppm(image))
        self.assertEqual(self.diff(SAME, "a.ppm", "b"), "a.ppm and b are the same\n")
        self.assertEqual(self.diff(SAME, "a.ppm", "a.ppm"), "a.ppm and a.ppm are the same\n")

    def test_counts_and_boxes(self):
        for seed in range(40):
            dice = random.Random(seed)
            image = noise(dice.randrange(1, 40), dice.randrange(1, 30), seed)
            other = image
            for _ in range(dice.randrange(6)):
                other = changed(other, dice.randrange(len(image[0])), dice.randrange(len(image)),
                                dice.choice((1, 2, 120)), dice.sample(range(3), 1 + seed % 3))
            self.put_pair(image, other)
            truth, apart = compared(image, other)
            self.diff(DIFFERENT if apart else SAME, "a", "b", "--json", "j")
            found = loaded("j")
            size = [len(image[0]), len(image)]
            self.assertEqual(found, {"same": not apart, "sizes": [size, size], **truth}, seed)

    def test_the_picture_of_the_difference(self):
        image = noise(20, 256, 3)
        for y in range(256):
            image[y][5] = (0, y, 255)
            image[y][6] = (255, 255, 255)
        other = [list(row) for row in image]
        for y in range(256):
            other[y][5] = (0, 0, 255)
        self.put_pair(image, other)
        self.diff(DIFFERENT, "a", "b", "-o", "d.ppm")
        shown, apart = rows_of("d.ppm"), compared(image, other)[1]
        self.assertEqual(len(apart), 255)
        for y, row in enumerate(shown):
            for x, pixel in enumerate(row):
                if (x, y) in apart:
                    self.assertEqual(pixel[0], 255)
                    self.assertGreater(pixel[1], 51)
                else:
                    self.assertEqual(pixel, (sum(image[y][x]) // 15,) * 3)
        brightness = [sum(shown[y][5]) for y in range(1, 256)]
        self.assertEqual(brightness, sorted(brightness))
        self.assertGreater(brightness[-1], brightness[0] + 200)

    def test_different_sizes(self):
        self.put_pair(noise(6, 4, 1), noise(4, 6, 1))
        put("d.ppm", "old")
        result = self.ask(DIFFERENT, "diff", "a", "b", "-o", "d.ppm", "--json", "j")
        self.assertEqual(result.stdout, "a and b differ: sizes 6x4 and 4x6\n")
        self.assertEqual(result.stderr, "d.ppm: not written: the pictures differ in size\n")
        self.assertEqual(contents("d.ppm"), b"old")
        self.assertEqual(loaded("j"), {"same": False, "sizes": [[6, 4], [4, 6]]})
        for size in ((6, 3), (5, 4)):
            self.put_pair(noise(6, 4, 1), noise(*size, 1))
            self.assertEqual(self.diff(DIFFERENT, "a", "b"),
                             "a and b differ: sizes 6x4 and %dx%d\n" % size)

    def test_comments_and_blanks_of_a_ppm(self):
        image = noise(3, 2, 1)
        image[0][0] = (35, 10, 35)  # what looks like a comment is a pixel
        whole = ppm(image)
        put("a", whole)
        pixels = whole[len(b"P6\n3 2\n255\n"):]
        for head in (b"P6 3 2 255 ", b"P6\t3\r2\n\n255\r", b"P6\n# by hand\n3 2\n255\n",
                     b"P6\n3 # 9\n#\n#9 9\r2\n255\n", b"P6\n#\xff\0#\n3 2\n255\n"):
            put("b", head + pixels)
            self.diff(SAME, "a", "b")

    def test_what_is_no_picture(self):
        for data, word in (
                (b"", "neither"), (b"P", "neither"), (b"P3\n1 1\n255\n1 2 3\n", "neither"),
                (b"P5\n1 1\n255\n1", "neither"), (b"GIF89a", "neither"), (SCENE, "neither"),
                (b"\xff\xd8\xff", "neither"), (b"\x89PNG\n", "neither"),
                (b"P6\n1 1\n65535\nabcdef", "255"), (b"P6\n1 1\n15\nabc", "255"),
                (b"P6\n0 1\n255\n", "255"), (b"P6\n-1 1\n255\nabc", "255"),
                (b"P61 1\n255\nabc", "255"), (b"P6\n1 1\n25", "255"),
                (b"P6\n1x1\n255\nabc", "255"), (b"P6\n2147483648 1\n255\nabc", "255"),
                (b"P6\n1 1# 255\nabc", "255"), (b"P6\n# 1 1 255", "255"),
                (b"P6\n4294967297 1\n255\nabc", "255"), (b"P6\n1 1\n255\nabcd", "bytes after"),
                (b"P6\n2147483647 2147483647\n255\n", "memory")):
            self.refused(data, word)

    def test_what_cannot_be_read(self):
        put("a", ppm(noise(2, 2, 0)))
        self.fail_with(TROUBLE, "missing: error: No such file.*", "diff", "a", "missing")
        self.fail_with(TROUBLE, r"\.: error: Is a directory", "diff", ".", "a")
        both = self.ask(TROUBLE, "diff", "no1", "no2").stderr
        self.assertRegex(both, r"\Ano1: error: .*\nno2: error: .*\n\Z")

    def test_a_pipe(self):
        put("a", ppm(noise(2, 2, 0)))
        for data in [ppm(noise(2, 2, 0)), png(noise(2, 2, 0))]:
            there, here = os.pipe()
            os.write(here, data)
            os.close(here)
            self.ask(SAME, "diff", "a", f"/dev/fd/{there}", pass_fds=[there])
            os.close(there)


class DiffOfPngs(TwoPictures):
    def test_every_way_to_write_the_same(self):
        image = noise(11, 9, 1)
        put("a.png", ppm(image))  # the name does not count
        for data in (png(image), interlaced_png(image)):
            put("b.ppm", data)
            self.diff(SAME, "a.png", "b.ppm")
        colours = noise(4, 1, 5)[0]
        few = [[colours[(x * y + x) % 4] for x in range(11)] for y in range(5)]
        put("a", ppm(few))
        for depth in (2, 4, 8):
            def row_of(row):
                return packed([colours.index(pixel) for pixel in row], depth)
            rows = [row_of(row) for row in few]
            palette = chunk(b"PLTE", flat(colours))
            for data in (png_of(11, 5, depth, PALETTE, rows, palette),
                         interlaced_png(few, depth, PALETTE, row_of, palette)):
                put("b", data)
                self.diff(SAME, "a", "b")
            self.refused(png_of(11, 5, depth, PALETTE, rows, chunk(b"PLTE", flat(colours[:-1]))),
                         "not in its palette")
        for depth in (1, 2, 4, 8):
            values, shown = greys(depth)
            put("a", ppm(shown))
            put("b", png_of(11, 5, depth, GREY, [packed(row, depth) for row in values]))
            self.diff(SAME, "a", "b")

    def test_values_are_taken_as_they_stand(self):
        """No gamma, no profile: only the numbers count."""
        image = noise(3, 2, 1)
        put("a", ppm(image))
        rows = [flat(row) for row in image]
        for extra in (chunk(b"gAMA", struct.pack(">I", 100000)), chunk(b"sRGB", b"\0"),
                      chunk(b"sBIT", b"\4\4\4"), chunk(b"tEXt", b"a\0b")):
            put("b", png_of(3, 2, 8, RGB, rows, extra))
            self.diff(SAME, "a", "b")

    def test_what_is_refused(self):
        for data, word in (
                (png_of(1, 1, 16, RGB, [b"abcdef"]), "16 bits"),
                (png_of(1, 1, 16, GREY, [b"ab"]), "16 bits"),
                (png_of(1, 1, 8, RGBA, [b"abcd"]), "transparency"),
                (png_of(1, 1, 8, GREY_ALPHA, [b"ab"]), "transparency"),
                (png_of(1, 1, 8, RGB, [b"abc"], chunk(b"tRNS", b"\0a\0b\0c")), "transparency"),
                (png(noise(2, 2, 0)) + b"x", "bytes after"),
                (PNG_START + b"more", "ends before"),
                (PNG_START + bytes(40), "not a whole PNG")):
            self.refused(data, word)

    def test_every_truncation(self):
        for whole, head, least, said in ((ppm(noise(3, 2, 1)), b"P6\n3 2\n255\n", 3, "255"),
                                         (png(noise(3, 2, 1)), PNG_START, 2, "neither")):
            for size in range(least, len(whole)):
                self.refused(whole[:size], said if size < len(head) else "ends before")

    def test_every_spoilt_bit_of_what_counts(self):
        """A check sum covers each chunk, and the length of one leads to the next."""
        whole = png(noise(3, 2, 1))
        put("a", whole)
        for place in range(len(PNG_START), len(whole)):
            put("b", whole[:place] + bytes([whole[place] ^ 4]) + whole[place + 1:])
            self.fail_with(TROUBLE, "b: error: .*", "diff", "a", "b")

    def test_a_difference_as_png(self):
        put("a", png(noise(9, 4, 1)))
        put("b", png(changed(noise(9, 4, 1), 2, 3, 9)))
        self.diff(DIFFERENT, "a", "b", "-o", "d.png")
        self.diff(DIFFERENT, "a", "b", "-o", "d.ppm")
        self.diff(SAME, "d.png", "d.ppm")


# What stands in a golden picture behind its first 33 bytes, and in no other.
MARK = b"\0\0\0\x1ftEXtSource\0surehit regress --accept"


def unmarked(path):
    """A golden picture as `surehit render` writes it."""
    data = contents(path)
    if data[33:33 + len(MARK)] != MARK:
        raise AssertionError(f"{path} is not marked")
    return data[:33] + data[33 + len(MARK) + 4:]


class Scenes(InFolder):
    """a.rt to d.rt in the folder s, each with its golden picture."""

    def setUp(self):
        super().setUp()
        os.mkdir("s")
        for name in "abcd":
            put(f"s/{name}.rt", SCENE.replace("255,60,60", f"{ord(name)},60,60"))
        self.ask(SAME, "regress", "s", *SIZE, "--accept")

    def regress(self, status, *words, **more):
        """The lines about scenes, and the last one, on standard output."""
        result = self.ask(status, "regress", "s", *SIZE, *words, **more)
        lines = result.stdout.splitlines()
        return lines[:-1], lines[-1], result.stderr

    def render(self, name, path, *words):
        self.ask(SAME, "render", f"s/{name}.rt", *SIZE, "-o", path, "--quiet", *words)

    def rendered(self, name):
        """As rows of pixels."""
        self.render(name, "x.ppm")
        return rows_of("x.ppm")


class Regress(Scenes):
    def test_all_the_same(self):
        before = all_files()
        self.assertEqual(self.regress(SAME),
                         ([f"{name}.rt: same" for name in "abcd"], "4 scenes: 4 same", ""))
        self.assertEqual(self.ask(SAME, "regress", "s", *SIZE, "--quiet").stdout, "")
        self.assertEqual(self.regress(SAME, "--accept")[1], "4 scenes: 4 same")
        self.assertEqual(all_files(), before)

    def test_the_picture_is_that_of_render(self):
        usual, other = (
            re.search(r"\(default:\s+(\w+)\)", self.ask(0, command, "--help").stdout)[1]
            for command in ("render", "regress"))
        self.assertEqual(usual, other)
        self.render("a", "x.png")
        self.assertEqual(contents("x.png"), unmarked("s/golden/a.png"))
        put("s/d.rt", FAR)
        for number, words in enumerate((["--tier", "float32"], ["--tier", "exact"],
                                        ["--tier", usual, "--threads", "3"], ["--fov", "vertical"],
                                        ["--size", "5x7", "--handedness", "left"])):
            folder = f"golden{number}"
            self.ask(SAME, "regress", "s", *SIZE, *words, "--golden", folder, "--accept")
            for name in "abcd":
                self.render(name, "x.png", *words)
                self.assertEqual(contents("x.png"), unmarked(f"{folder}/{name}.png"), words)
        self.ask(DIFFERENT, "diff", "golden0/d.png", "golden1/d.png")
        self.assertEqual(contents("golden2/a.png"), contents("s/golden/a.png"))

    def test_a_scene_says_its_own_size(self):
        put("s/a.rt", SCENE + "R 20 10\n")
        self.ask(SAME, "regress", "s", "--accept", "--golden", "g")
        self.assertEqual(contents("g/a.png")[16:24], struct.pack(">II", 20, 10))

    def test_a_changed_pixel(self):
        put("s/golden/b.png", png(changed(self.rendered("b"), 17, 31, 1)))
        before = all_files()
        lines, last, said = self.regress(DIFFERENT)
        self.assertEqual(lines[1], "b.rt: differs: 1 of 3072 pixels, by at most 1, "
                                   "box x=17 y=31 w=1 h=1")
        self.assertEqual([lines[0], lines[2], said], ["a.rt: same", "c.rt: same", ""])
        self.assertTrue(last.startswith("4 scenes: 3 same, 1 different; "), last)
        self.assertEqual(self.ask(DIFFERENT, "regress", "s", *SIZE, "--quiet").stdout,
                         lines[1] + "\n")
        self.assertEqual(all_files(), before)

    def test_a_changed_scene_is_accepted(self):
        old = contents("s/golden/b.png")
        put("s/b.rt", OTHER)
        self.assertTrue(self.regress(DIFFERENT)[0][1].startswith("b.rt: differs: "))
        self.assertEqual(contents("s/golden/b.png"), old)
        before = all_files()
        lines = self.regress(SAME, "--accept")[0]
        self.assertRegex(lines[1], r"\Ab\.rt: differs: .*; accepted\Z")
        self.render("b", "x.png")
        self.assertEqual(contents("x.png"), unmarked("s/golden/b.png"))
        os.remove("x.png")
        changes = {path for path, data in all_files().items() if before.get(path) != data}
        self.assertEqual(changes, {"./s/golden/b.png"})
        self.regress(SAME)

    def test_the_same_pixels_in_another_file_are_the_same(self):
        other = png(self.rendered("c"))
        self.assertNotEqual(other, contents("s/golden/c.png"))
        put("s/golden/c.png", other)
        self.regress(SAME, "--accept")
        self.assertEqual(contents("s/golden/c.png"), other)

    def test_a_missing_golden_picture(self):
        os.remove("s/golden/a.png")
        lines, last, _ = self.regress(DIFFERENT)
        self.assertEqual(lines[0], "a.rt: new: no golden picture yet")
        self.assertTrue(last.startswith("4 scenes: 3 same, 1 new; "), last)
        self.assertNotIn("./s/golden/a.png", all_files())
        self.assertEqual(self.regress(SAME, "--accept")[0][0],
                         "a.rt: new: no golden picture yet; accepted")
        self.regress(SAME)

    def test_a_stale_golden_picture(self):
        os.remove("s/c.rt")
        lines, last, _ = self.regress(DIFFERENT)
        self.assertEqual(lines[2:], ["d.rt: same",
                                     "c.png: stale: a golden picture without a scene"])
        self.assertTrue(last.startswith("3 scenes: 3 same; 1 stale golden picture; "), last)
        self.assertIn("./s/golden/c.png", all_files())
        self.assertTrue(self.regress(SAME, "--accept")[0][3].endswith("; removed"))
        self.assertNotIn("./s/golden/c.png", all_files())
        self.assertEqual(self.regress(SAME)[1], "3 scenes: 3 same")

    def test_a_stale_golden_picture_beside_one_of_like_name(self):
        os.rename("s/a.rt", "s/ab.rt")
        lines = self.regress(DIFFERENT)[0]
        self.assertEqual([line.split(": ")[:2] for line in lines],
                         [["ab.rt", "new"], ["b.rt", "same"], ["c.rt", "same"], ["d.rt", "same"],
                          ["a.png", "stale"]])

    def test_a_broken_scene_stops_no_other(self):
        put("s/b.rt", SCENE + FAULTY)
        put("s/d.rt", OTHER)
        old = contents("s/golden/b.png")
        lines, last, said = self.regress(TROUBLE)
        self.assertEqual(lines[1], "b.rt: error: the scene can't be drawn")
        self.assertRegex(said, r"\As/b\.rt:6:1: error: .*\n\Z")
        self.assertTrue(lines[3].startswith("d.rt: differs: "))
        self.assertTrue(last.startswith("4 scenes: 2 same, 1 different, 1 not drawn; "), last)
        lines, _, said_again = self.regress(TROUBLE, "--accept")
        self.assertEqual((lines[1], said_again), ("b.rt: error: the scene can't be drawn", said))
        self.assertTrue(lines[3].endswith("; accepted"))
        self.assertEqual(contents("s/golden/b.png"), old)
        self.assertEqual(self.regress(TROUBLE)[0][3], "d.rt: same")

    def test_warnings_are_passed_on(self):
        put("s/b.rt", SCENE.replace("L ", "# "))
        self.assertRegex(self.regress(DIFFERENT)[2], r"\As/b\.rt:.*: warning: .*\n\Z")

    def test_a_truncated_golden_picture(self):
        whole = contents("s/golden/b.png")
        put("s/golden/b.png", whole[:-20])
        lines, _, said = self.regress(TROUBLE)
        self.assertEqual(lines[1], "b.rt: error: the golden picture can't be read")
        self.assertEqual(said, "s/golden/b.png: error: ends before the picture does\n")
        self.assertEqual(contents("s/golden/b.png"), whole[:-20])
        self.assertTrue(self.regress(SAME, "--accept")[0][1].endswith("; accepted"))
        self.assertEqual(contents("s/golden/b.png"), whole)

    def test_which_files_are_scenes(self):
        for name in ("B.rt", "a.b.rt", "a-b.rt"):
            put("s/" + name, SCENE)
        for name in ("e.RT", "f.rt.txt", "rt", ".rt", ".hidden.rt", "golden/.hidden.png",
                     "golden/notes.txt"):
            put("s/" + name, "no scene and no picture")
        os.mkdir("s/below")
        put("s/below/g.rt", SCENE)
        lines = self.regress(SAME, "--accept")[0]
        self.assertEqual([line.split(":")[0] for line in lines],
                         ["B.rt", "a-b.rt", "a.b.rt", "a.rt", "b.rt", "c.rt", "d.rt"])
        self.assertEqual(sorted(os.listdir("s/golden")),
                         [".hidden.png", "B.png", "a-b.png", "a.b.png", "a.png", "b.png", "c.png",
                          "d.png", "notes.txt"])

    def test_unusual_names(self):
        name = "a folder/-o <i>'&\"\n\x1b[1m é"
        os.mkdir("a folder")
        put(name + ".rt", SCENE)
        said = self.ask(SAME, "regress", "a folder/", *SIZE, "--accept", "-o", "p.html").stdout
        self.assertTrue(said.startswith("-o <i>'&\"\\x0a\\x1b[1m é.rt: new"), said)
        self.assertEqual(os.listdir("a folder/golden"), [os.path.basename(name) + ".png"])
        text = contents("p.html").decode()
        self.assertIn("-o &lt;i&gt;&#39;&amp;&quot;\\x0a\\x1b[1m é.rt", text)
        self.assertNotIn("<i>'", text)

    def test_folders_that_are_none(self):
        os.mkdir("empty")
        put("file", "")
        for line, complaint in (("empty --accept", "empty: error: no scene in it"),
                                ("missing", "missing: error: .*No such file"),
                                ("file", "file: error: .*Not a directory"),
                                ("s --golden file", "file: error: .*Not a directory")):
            self.fail_with(TROUBLE, complaint + ".*", "regress", *line.split())
        self.ask(DIFFERENT, "regress", "s", "--golden", "missing")
        self.assertFalse(os.path.exists("missing"))

    def test_a_stale_golden_picture_that_cannot_be_read(self):
        os.mkdir("s/golden/q.png")
        for words in ((), ("--accept",)):
            lines, _, said = self.regress(TROUBLE, *words)
            self.assertEqual(said, "s/golden/q.png: error: Is a directory\n")
            self.assertTrue(lines[4].startswith("q.png: stale"), lines)

    def test_nobody_is_waited_for(self):
        """A pipe in a folder."""
        os.remove("s/golden/b.png")
        os.remove("s/d.rt")
        for name in ("s/d.rt", "s/golden/b.png", "s/golden/q.png"):
            os.mkfifo(name)
        for words, b in (((), ""), (("--accept",), "; not accepted")):
            lines, _, said = self.regress(TROUBLE, *words, timeout=30)
            self.assertEqual(said, "".join(f"s/{name}: error: is no regular file\n"
                                           for name in ("golden/b.png", "d.rt", "golden/q.png")))
            self.assertEqual(lines[1], "b.rt: error: the golden picture can't be read" + b)

    def test_links_that_lead_nowhere(self):
        """What is there and cannot be read is not taken for what is not there."""
        os.remove("s/golden/b.png")
        for path in ("s/golden/b.png", "loop"):
            os.symlink(os.path.basename(path), path)
        for words in ((), ("--accept",)):
            lines, _, said = self.regress(TROUBLE, *words)
            self.assertEqual(lines[1].split(";")[0],
                             "b.rt: error: the golden picture can't be read")
            self.assertIn("s/golden/b.png: error: Too many levels", said)
        self.fail_with(TROUBLE, "loop: error: cannot be read: Too many levels .*", "regress", "s",
                       "--golden", "loop")

    def test_one_scene(self):
        os.mkdir("one")
        put("one/a.rt", SCENE)
        said = self.ask(SAME, "regress", "one", *SIZE, "--accept").stdout
        self.assertTrue(said.endswith("\n1 scene: 1 new\n"), said)

    def test_no_scene_left_removes_nothing(self):
        for name in "abcd":
            os.remove(f"s/{name}.rt")
        self.fail_with(TROUBLE, "s: error: no scene in it.*", "regress", "s", "--accept")


class FailedWrites(Scenes):
    """Whatever fails, nothing is lost and nothing half done is left."""

    def setUp(self):
        super().setUp()
        os.rename("s/c.rt", "s/e.rt")  # so c.png is stale, and e.png is new
        put("s/b.rt", OTHER)
        self.before = all_files()

    def fail(self, *words, **more):
        lines, _, said = self.regress(TROUBLE, "--accept", *words, **more)
        self.assertEqual(all_files(), self.before)
        self.assertRegex(lines[1], r"\Ab\.rt: differs: .*; not accepted\Z")
        self.assertTrue(lines[3].endswith("; not accepted"), lines)
        self.assertTrue(lines[4].endswith("; kept, since not all went well"), lines)
        return said

    def test_an_unwritable_folder(self):
        os.chmod("s/golden", 0o555)
        said = self.fail(preexec_fn=respect_permissions)
        for name in "be":
            self.assertRegex(said, rf"(?m)^s/golden/{name}\.png: error: .*Permission denied$")

    def test_a_folder_that_cannot_be_made(self):
        lines, _, said = self.regress(TROUBLE, "--accept", "--golden", "/proc/golden")
        self.assertEqual(said.count("/proc/golden: error: cannot be made"), 4)
        self.assertEqual(len(lines), 4)
        self.assertEqual(all_files(), self.before)

    def test_a_full_disk(self):
        said = self.fail(*LARGE, preexec_fn=limit_file_size)
        for name in "abde":
            self.assertIn(f"s/golden/{name}.png: error: cannot be written: File too large", said)

    def test_after_a_scene_that_is_broken(self):
        """What the stale picture's scene has become may be just that one."""
        put("s/e.rt", SCENE + FAULTY)
        lines = self.regress(TROUBLE, "--accept")[0]
        self.assertTrue(lines[4].endswith("; kept, since not all went well"), lines)
        self.assertIn("./s/golden/c.png", all_files())

    def test_strangers_pictures_are_kept(self):
        """Whatever has no mark of --accept is not golden, and nobody's to remove."""
        self.render("a", "s/golden/holiday.png")
        put("s/golden/photo.png", png_of(1, 1, 8, RGB, [b"rgb"],
                                         chunk(b"tEXt", b"Source\0surehit render")))
        lines = self.regress(DIFFERENT, "--accept")[0]
        self.assertTrue(lines[4].endswith("; removed"), lines)
        os.mkdir("s/golden/z.png")
        golden = self.before["./s/golden/c.png"]
        put("s/golden/c.png", golden[:33] + chunk(b"tEXt", b"Title\0c") + golden[33:])
        lines = self.regress(TROUBLE, "--accept")[0]
        self.assertTrue(lines[4].endswith("; removed"), lines)
        for line in lines[5:]:
            self.assertTrue(line.endswith("; kept, since --accept has not made it: remove it "
                                          "yourself"), lines)
        self.assertEqual(sorted(os.listdir("s/golden")), ["a.png", "b.png", "d.png", "e.png",
                                                          "holiday.png", "photo.png", "z.png"])

    def test_no_picture_takes_the_place_of_a_scene(self):
        for make, taken in ((os.symlink, "../a.rt"), (os.link, "s/a.rt")):
            os.remove("s/golden/b.png")
            make(taken, "s/golden/b.png")
            lines, _, said = self.regress(TROUBLE, "--accept")
            self.assertTrue(lines[1].endswith("; not accepted"), lines)
            self.assertIn("s/golden/b.png: error: a golden picture may not take the place of a "
                          "scene", said)
            self.assertEqual(contents("s/a.rt"), self.before["./s/a.rt"])

    def test_no_page_takes_the_place_of_a_scene_or_picture(self):
        for path in ("s/a.rt", "s/golden/a.png"):
            os.link(path, "page.html")
            said = self.ask(TROUBLE, "regress", "s", *SIZE, "-o", "page.html").stderr
            self.assertEqual(said, "page.html: error: the page may not take the place of a scene "
                             "or picture\n")
            os.remove("page.html")
        os.remove("s/golden/a.png")
        said = self.ask(TROUBLE, "regress", "s", *SIZE, "--accept", "-o", "s/golden/a.png").stderr
        self.assertEqual(said, "s/golden/a.png: error: the page may not take the place of a scene "
                         "or picture\n")
        self.assertFalse(os.path.exists("s/golden/a.png"))
        said = self.ask(TROUBLE, "regress", "s", "--golden", ".", "-o", "new.png").stderr
        self.assertTrue(said.startswith("new.png: error: the page may not take the place"), said)

    def test_a_page_that_the_disk_has_no_room_for(self):
        put("p.html", "old")
        self.before = all_files()
        result = self.ask(TROUBLE, "regress", "s", *LARGE, "-o", "p.html",
                          preexec_fn=limit_file_size)
        self.assertIn("p.html: error: cannot be written", result.stderr)
        self.assertEqual(all_files(), self.before)


class Page(html.parser.HTMLParser):
    """The page as a list of elements; complains about tags out of step."""

    VOID = {"meta", "br", "img", "input"}

    def __init__(self, text):
        super().__init__()
        self.open, self.found, self.faults = [], [], []
        self.feed(text)
        self.close()
        self.faults += [f"<{tag}> is left open" for tag, _ in self.open]

    def handle_starttag(self, tag, attrs):
        self.found.append((tag, dict(attrs)))
        if tag not in self.VOID:
            self.open.append((tag, dict(attrs)))

    def handle_startendtag(self, tag, attrs):
        self.found.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        if not self.open or self.open[-1][0] != tag:
            self.faults.append(f"</{tag}> after {[t for t, _ in self.open[-3:]]}")
        else:
            self.open.pop()


class OnePage(Scenes):
    """One scene of each verdict, on a page."""

    def setUp(self):
        super().setUp()
        put("s/e.rt", OTHER)
        put("s/f.rt", SCENE + FAULTY)
        put("s/g.rt", SCENE)
        put("s/golden/b.png", png(changed(self.rendered("b"), 60, 2, 200)))
        put("s/golden/c.png", png(noise(30, 20, 0)))
        put("s/golden/g.png", "no picture <script>")
        put("s/golden/z.png", png(noise(9, 9, 0)))
        self.lines = self.regress(TROUBLE, "-o", "p.html")[0]
        self.text = contents("p.html").decode()
        self.page = Page(self.text)

    def test_well_formed_and_self_contained(self):
        self.assertEqual(self.page.faults, [])
        tags = {tag for tag, _ in self.page.found}
        self.assertFalse(tags & {"script", "link", "iframe", "object", "embed", "a"}, tags)
        for word in ("url(", "@import", "http:", "https:"):
            self.assertNotIn(word, self.text)
        for tag, attrs in self.page.found:
            for name in ("src", "href"):
                self.assertTrue(attrs.get(name, "data:").startswith("data:"), (tag, name))
            self.assertFalse([name for name in attrs if name.startswith("on")], attrs)

    def test_the_frame_is_where_it_differs(self):
        (frame,) = {attrs["style"] for tag, attrs in self.page.found if tag == "i"
                    and attrs["style"].startswith("left:93.7")} or {None}
        width, height = 64, 48
        self.assertEqual(frame, "left:%.3f%%;top:%.3f%%;width:%.3f%%;height:%.3f%%" % (
            100 * 60 / width, 100 * 2 / height, 100 / width, 100 / height))

    def sections(self):
        """{scene: {caption: path of a file with its picture}}"""
        found = {}
        for part in re.findall(r"<section>.*?</section>", self.text, re.S):
            name = re.search(r"<h2>(.*?)</h2>", part)[1]
            found[name] = {}
            for title, data in re.findall(r"<figcaption>(.*?)</figcaption>.*?base64,([^']*)'",
                                          part, re.S):
                path = f"{name}-{title}.png"
                put(path, base64.b64decode(data, validate=True))
                found[name][title] = path
        return found

    def test_what_is_shown(self):
        found = self.sections()
        whole = ["expected", "got", "difference"]
        cut = [title + ", enlarged" for title in whole]
        self.assertEqual({name: list(pictures) for name, pictures in found.items()},
                         {"b.rt": whole + cut, "c.rt": ["expected", "got"], "e.rt": ["got"],
                          "f.rt": [], "g.rt": ["got"], "z.png": ["expected"]})
        for name in "bc":
            self.ask(SAME, "diff", found[f"{name}.rt"]["expected"], f"s/golden/{name}.png")
        for name in "bceg":
            self.render(name, "x.ppm")
            self.ask(SAME, "diff", found[f"{name}.rt"]["got"], "x.ppm")
        self.ask(DIFFERENT, "diff", "s/golden/b.png", found["b.rt"]["got"], "-o", "x.ppm")
        self.ask(SAME, "diff", "x.ppm", found["b.rt"]["difference"])
        self.assertIn("<h2>The same</h2>\n<p>a.rt, d.rt</p>", self.text)

    def test_what_is_enlarged_is_round_the_box(self):
        """24 pixels each way of 64x48, or as many as there are on one side."""
        image = self.rendered("b")
        for x, y, left, top in ((60, 2, 40, 0), (0, 47, 0, 24), (15, 20, 3, 8), (63, 0, 40, 0)):
            put("s/golden/b.png", png(changed(image, x, y, 100)))
            self.regress(TROUBLE, "-o", "p.html")
            self.text = contents("p.html").decode()
            put("part", ppm([row[left:left + 24] for row in image[top:top + 24]]))
            found = self.sections()["b.rt"]
            self.ask(SAME, "diff", "part", found["got, enlarged"])
            said = self.ask(DIFFERENT, "diff", "part", found["expected, enlarged"]).stdout
            self.assertIn(f" 1 of 576 pixels, by at most 100, box x={x - left} y={y - top} w=1 h=1",
                          said)

    def test_what_is_enlarged_has_a_margin(self):
        """Of 4 pixels round a wide box; what is most of the picture is not shown again."""
        image = self.rendered("b")
        for width, enlarged in ((20, True), (30, False)):
            put("s/golden/b.png",
                png(changed(changed(image, 10, 5, 100), 10 + width - 1, 5, 100)))
            self.regress(TROUBLE, "-o", "p.html")
            self.text = contents("p.html").decode()
            found = self.sections()["b.rt"]
            self.assertEqual("got, enlarged" in found, enlarged)
            if enlarged:
                put("part", ppm([row[6:34] for row in image[:24]]))
                self.ask(SAME, "diff", "part", found["got, enlarged"])

    def test_small_pictures_are_shown_enlarged(self):
        for width, kind in ((479, "small"), (480, "large")):
            self.ask(TROUBLE, "regress", "s", "--size", f"{width}x1", "--golden", "none", "-o",
                     "p.html")
            shown = {attrs["class"] for tag, attrs in Page(contents("p.html").decode()).found
                     if tag == "img"}
            self.assertEqual(shown, {kind})

    def test_what_is_said(self):
        for line in self.lines:
            name, verdict = line.split(": ", 1)
            if verdict != "same":
                self.assertIn(f"<h2>{name}</h2>\n", self.text)
                self.assertIn(f">{verdict}</b>", self.text)
        self.assertIn("7 scenes: 2 same, 2 different, 1 new, 1 not drawn, 1 with an unreadable "
                      "golden picture; 1 stale golden picture.", self.text)
        self.assertRegex(self.text, r"<pre>s/f\.rt:6:1: error: ")
        self.assertIn("<pre>s/golden/g.png: error: neither", self.text)
        self.assertIn(">Tier certain, 64x48 pixels. ", self.text)
        self.regress(TROUBLE, "-o", "p.html", "--tier", "exact")
        self.assertIn(">Tier exact, 64x48 pixels. ", contents("p.html").decode())

    def test_the_same_page_again(self):
        self.regress(TROUBLE, "-o", "again.html", "--threads", "1")
        self.assertEqual(contents("again.html"), contents("p.html"))

    def test_what_was_accepted_is_shown_as_it_was(self):
        self.regress(TROUBLE, "-o", "p.html", "--accept")
        self.text = contents("p.html").decode()
        self.assertEqual(self.text.count("</b>; accepted</p>"), 4)
        self.assertEqual(self.text.count("; kept, since not all went well</p>"), 1)
        self.assertEqual(contents(self.sections()["c.rt"]["expected"])[16:24],
                         struct.pack(">II", 30, 20))

    def test_contrast(self):
        browser.check_contrast(self, self.text, [("shade", "ink"), *(
            ("paper", name) for name in ("ink", "soft", "wrong", "new"))])

    @unittest.skipUnless(browser.CHROMIUM, "Chromium is not installed")
    def test_looks(self):
        for scheme in browser.SCHEMES:
            for width in (360, 1280):
                blank, wide = browser.check(
                    self, "p.html", width, scheme, "label, pre",
                    "[...document.images].filter(i => !i.naturalWidth).length",
                    "document.querySelectorAll('figure')[1].getBoundingClientRect().width")
                self.assertEqual(blank, 0)
                self.assertGreater(wide, 300)


class OurOwn(InFolder):
    """The picture at the top of the README is what ./run draws."""

    def test_the_picture_of_the_readme(self):
        with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as readme:
            shown = re.search(r"!\[The default scene\]\((.*?)\)", readme.read())[1]
        scene = os.path.join(ROOT, "tests/scenes/default.rt")
        self.ask(SAME, "render", scene, "-o", "x.ppm", "--quiet")
        self.assertEqual(self.ask(SAME, "diff", os.path.join(ROOT, shown), "x.ppm").stderr, "")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
