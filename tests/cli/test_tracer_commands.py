# SPDX-License-Identifier: MIT
"""Certificates, heat pictures and what else `surehit render` tells of a scene, and `surehit check`:
test_tracer_commands.py SUREHIT"""

import glob
import json
import math
import os
import re
import resource
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from commands import (PROGRAM, ROOT, SCENE, WRONG_USAGE, InFolder,  # noqa: E402
                      contents, put, rows_of)

SCENES = sorted(glob.glob(ROOT + "/tests/scenes/*.rt") +
                glob.glob(ROOT + "/tests/scenes/extreme/*.rt"))
RIGHT, WRONG, TROUBLE = 0, 1, 2
SIZE = ("--size", "64x36")
ALL_RIGHT = "2304 pixels, all right"

# The objects of SCENE.
FLOOR, BALL, CYLINDER, CONE = range(4)
LINES = {FLOOR: 4, BALL: 5, CYLINDER: 6, CONE: 7}  # of the file
OTHER = SCENE.replace("sp -2.5,0,0 2 ", "sp -2.5,0,0 1 ")


def hexadecimal(value):
    """As %a writes it."""
    return re.sub(r"\.?0*p", "p", value.hex())


def ulp_up(text):
    """The next double, as %a writes it."""
    return hexadecimal(math.nextafter(float.fromhex(text), math.inf))


class Certificate:
    """One as a head, and a line a pixel."""

    def __init__(self, text):
        self.head, end = json.JSONDecoder().raw_decode(text)
        first, *self.pixels, last = text[end:].split("\n")
        assert first == last == ""

    @classmethod
    def of(cls, path):
        return cls(contents(path).decode("ascii"))

    def text(self):
        return "\n".join([json.dumps(self.head, indent=2), *self.pixels, ""])

    def line(self, i):
        """Of a pixel, in the file."""
        return json.dumps(self.head, indent=2).count("\n") + 2 + i

    def home(self, name):
        return next(home for home in (self.head, self.head["options"], self.head["totals"])
                    if name in home)

    def field(self, name):
        return self.home(name)[name]

    def with_field(self, name, value):
        """A copy that says another thing, as those below."""
        assert self.field(name) != value
        changed = Certificate(self.text())
        changed.home(name)[name] = value
        return changed

    def with_pixel(self, i, text):
        changed = Certificate(self.text())
        changed.pixels[i] = text
        return changed

    def answer(self, i):
        """What stands behind the direction."""
        return self.pixels[i].split(" ", OBJECT)[OBJECT]

    def with_answer(self, i, text):
        return self.with_pixel(i, self.pixels[i].removesuffix(self.answer(i)) + text)

    def with_word(self, i, position, word):
        words = self.pixels[i].split(" ")
        assert words[position] != word
        words[position] = word
        return self.with_pixel(i, " ".join(words))

    def more(self, name, part, count):
        """The counts of that name, with more of a part."""
        return {**self.field(name), part: self.field(name)[part] + count}

    def object_at(self, i):
        word = self.word(i, OBJECT)
        return None if word == "miss" else int(word)

    def word(self, i, position):
        return self.pixels[i].split(" ")[position]

    def number(self, i, position):
        return float.fromhex(self.word(i, position))

    def first(self, wanted):
        """The first pixel in reading order that sees this object."""
        return next(i for i in range(len(self.pixels)) if self.object_at(i) == wanted)


X, Y, Z, OBJECT, PART, STAGE, T, ERROR = range(8)


class Commands(InFolder):
    scene = SCENE

    def render(self, scene, output, *words):
        return self.succeed("render", scene, "-o", output, "--quiet", *words)

    def certified(self, *words, scene="scene.rt"):
        """The certificate, which is in a.cert, too."""
        self.render(scene, "a.ppm", "--certificate", "a.cert", *words)
        return Certificate.of("a.cert")

    def check(self, status, *words, claims=None, certificate="a.cert", scene="scene.rt"):
        """What is said of the claims, or of the file."""
        if claims is not None:
            certificate = "lie.cert"
            put(certificate, claims if isinstance(claims, str) else claims.text())
        return self.ask(status, "check", certificate, scene, *words)

    def assert_right(self, *words, **more):
        result = self.check(RIGHT, *words, **more)
        self.assertEqual(result.stderr, "", result.stdout)
        return result.stdout

    def assert_wrong(self, claims, total, *patterns):
        """What is wrong is said, a line a pattern, and the total."""
        result = self.check(WRONG, claims=claims)
        lines = result.stdout.splitlines()
        self.assertEqual((result.stderr, lines[-1]), ("", f"lie.cert: 2304 pixels, {total}"))
        self.assertEqual(len(lines), len(patterns) + 1, result.stdout)
        for line, pattern in zip(lines, patterns):
            self.assertRegex(line, r"\A" + pattern + r"\Z")

    def assert_refused(self, pattern, *words, **more):
        """One line on standard error."""
        result = self.check(TROUBLE, *words, **more)
        self.assertRegex(result.stderr, r"\A" + pattern + r"\n\Z")
        self.assertEqual((result.stdout, result.stderr.count("\n")), ("", 1))


class Certificates(Commands):
    """What they say of a scene in which everybody can see what is where."""

    def test_head(self):
        claims = self.certified("--size", "64x36", "--tier", "certain")
        self.assertEqual(list(claims.head),
                         ["surehit certificate", "scene", "hash", "objects", "numbers", "eye",
                          "part", "tier", "options", "rays", "hits", "totals"])
        self.assertEqual(list(claims.head["totals"]),
                         ["misses", "origins", "without-origin", "covered", "acne"])
        for name, value in {"surehit certificate": 2, "scene": "scene.rt", "objects": 4,
                            "size": "64x36", "part": "0,0,64x36", "tier": "certain",
                            "handedness": "right", "fov": "horizontal",
                            "cylinder-position": "middle", "cone-position": "middle",
                            "falloff": "none", "dialect": "strict", "camera": "1",
                            "skip-unknown": False, "acne": 0}.items():
            self.assertEqual(claims.field(name), value)
        value = 0xcbf29ce484222325
        for byte in contents("scene.rt"):
            value = (value ^ byte) * 0x100000001b3 % 2 ** 64
        self.assertEqual(claims.field("hash"), f"{value:016x}")
        self.assertEqual(len(claims.pixels), 64 * 36)
        rays, hits = claims.field("rays"), claims.field("hits")
        self.assertEqual(list(rays), ["pixel", "shadow", "mirror", "refracted"])
        self.assertEqual((rays["pixel"], rays["mirror"], rays["refracted"]), (64 * 36, 0, 0))
        self.assertGreater(rays["shadow"], 0)
        self.assertEqual(list(hits), ["double", "double-double", "mod128", "exact"])
        self.assertEqual(sum(hits.values()) + claims.field("misses"), sum(rays.values()))

    def test_options_as_they_are_resolved(self):
        put("other.rt", SCENE + "#! handedness left\n#! cone-position base\nsq 0,0,0 1\n"
            "R 40 30\nfalloff inverse-square\n")
        self.ask(0, "render", "other.rt", "-o", "a.ppm", "--certificate", "a.cert",
                 "--cone-position", "apex", "--fov=vertical", "--skip-unknown", "--tile",
                 "3,4,20x10", "--tier", "exact")
        claims = Certificate.of("a.cert")
        for name, value in {"handedness": "left", "cone-position": "apex", "fov": "vertical",
                            "falloff": "inverse-square", "skip-unknown": True, "size": "40x30",
                            "part": "3,4,20x10", "tier": "exact"}.items():
            self.assertEqual(claims.field(name), value)
        self.assertIn("warning", self.check(RIGHT, scene="other.rt").stderr)
        self.check(WRONG, claims=claims.with_field("handedness", "right"), scene="other.rt")

    def test_pixels(self):
        claims = self.certified("--size", "64x36", "--tier", "certain")
        above, row = range(64), range(22 * 64, 23 * 64)
        self.assertEqual({claims.answer(i) for i in above}, {"miss"})
        seen = [claims.object_at(i) for i in row]
        order = [a for a, b in zip(seen, seen[1:] + [None]) if a != b and a not in (FLOOR, None)]
        self.assertEqual(order, [BALL, CYLINDER, CONE])
        self.assertEqual({claims.object_at(i) for i in range(35 * 64, 36 * 64)}, {FLOOR})
        parts = {}
        for i in range(len(claims.pixels)):
            if claims.answer(i) != "miss":
                self.assertRegex(claims.answer(i),
                                 r"\A\d (surface|base|top|wall) (double|double-double|mod128|exact)"
                                 r" 0x1[.\da-f]*p[+-]\d+ 0x[01][.\da-f]*p[+-]\d+\Z")
                parts.setdefault(claims.object_at(i), set()).add(claims.word(i, PART))
        self.assertEqual(parts, {FLOOR: {"surface"}, BALL: {"surface"}, CYLINDER: {"top", "wall"},
                                 CONE: {"wall"}})
        middle = next(i for i in row if claims.object_at(i) == BALL)
        self.assertTrue(4 < claims.number(middle, T) < 12)

    def test_objects_are_the_surfaces_of_the_file_in_their_order(self):
        """By the line of grep that docs/tracer.md gives."""
        page = contents(ROOT + "/docs/tracer.md").decode()
        command = re.search(r"^\$ (grep .*)", page, re.M)[1]
        command = command.replace("tests/scenes/mirrors.rt", "scene.rt")
        put("scene.rt", SCENE.replace("pl", "# sp, as a comment\n\n  pl"))
        for number, word in ((FLOOR, "pl"), (BALL, "sp"), (CYLINDER, "cy"), (CONE, "co")):
            with os.popen(command.replace("4p", f"{number + 1}p")) as said:
                self.assertRegex(said.read(), rf"\A\d+: *{word} .*\n\Z")

    def test_a_tile_has_the_lines_of_the_whole(self):
        whole = self.certified(*SIZE).pixels
        picture = rows_of("a.ppm")
        part = self.certified(*SIZE, "--tile", "10,20,30x5").pixels
        self.assertEqual(part, [whole[64 * y + x] for y in range(20, 25) for x in range(10, 40)])
        self.assertEqual(rows_of("a.ppm"), [row[10:40] for row in picture[20:25]])
        self.assert_right()

    def test_the_same_for_any_number_of_threads_and_without_the_hierarchy(self):
        """By the picture, too."""
        for scene in ("scene.rt", ROOT + "/tests/scenes/wild.rt"):
            whole = self.certified(*SIZE, scene=scene).text(), contents("a.ppm")
            for line in ("--threads 1", "--threads 3", "--threads 4", "--no-hierarchy"):
                made = self.certified(*SIZE, *line.split(), scene=scene).text()
                self.assertEqual((made, contents("a.ppm")), whole, line)

    def test_the_picture_is_the_same_and_both_are_named(self):
        self.render("scene.rt", "plain.ppm", *SIZE)
        said = self.succeed("render", "scene.rt", "-o", "a.ppm", "--certificate", "a.cert", *SIZE)
        self.assertRegex(said, r"\Aa\.ppm, a\.cert: 64x36, \d+\.\d\d s\n\Z")
        self.assertEqual(contents("a.ppm"), contents("plain.ppm"))

    def test_nothing_else_is_replaced(self):
        os.link("scene.rt", "linked")
        words = ("render", "scene.rt", "-o", "a.ppm", "--certificate")
        for path in ("scene.rt", "./scene.rt", "linked"):
            self.refuse(f"'{path}' may not take the place of a file that is read, or of another",
                        *words, path)
        for path in ("a.ppm", "./a.ppm", "b.PNG"):
            self.fail_with(WRONG_USAGE, re.escape(path) + ": error: a certificate may not have a "
                           "picture's name", *words, path)
        self.fail_with(WRONG_USAGE, "-: error: a certificate is written to a file that has a name",
                       *words, "-")


class Checks(Commands):
    def test_what_is_next_to_the_eye(self):
        """Half an ulp is the least double there, and as much as t."""
        for z in ("5e-324", "1e-322", "1e-310", "3"):
            put("near.rt", f"A 0.1 255,255,255\nC 0,0,{z} 0,0,-1 60\nL 1,0,0 0.9\n"
                           "pl 0,0,0 0,0,1 99,99,99\n")
            for tier in ("certain", "exact"):
                self.certified(*SIZE, "--tier", tier, scene="near.rt")
                self.assertEqual(self.assert_right(scene="near.rt"), f"a.cert: {ALL_RIGHT}\n")

    def test_t_is_coarser_than_the_bound(self):
        """Far along a plane that is almost parallel, next to the eye, and beyond all doubles."""
        far, most = "C 0,1,0 {} 60\npl 0,0,0 0,1,0 9,9,9\n", "1.7e308,1.7e308,1.7e308"
        for lines in (far.format("0,-6.123233995736766e-17,-1"), far.format("0,-1e-10,-1"),
                      "C 0,0,0 0,0,-1 60\npl 0,0,-5e-324 1e-320,0,1 9,9,9\n",
                      f"C 0,0,0 1,1,-1 60\nbo -{most.replace(',', ',-')} {most} 9,9,9\n"):
            put("far.rt", "A 0.1 255,255,255\nL 0,5,0 0.9\n" + lines)
            for tier in ("certain", "exact"):
                self.certified("--size", "161x91", "--tier", tier, scene="far.rt")
                said = self.assert_right(scene="far.rt")
                self.assertEqual(said, "a.cert: 14651 pixels, all right\n")
        self.assertIn(" inf inf\n", contents("a.cert").decode())
        self.succeed("plan", "--pieces", "1", "-o", "man", "render", "far.rt", "--size", "161x91",
                     "--certificate", "b.cert")
        os.mkdir("pieces")
        self.succeed("work", "man", "1", "pieces")
        self.succeed("merge", "pieces", "-o", "b.ppm")
        self.succeed("check", "b.cert", "far.rt")

    def test_every_scene_of_ours(self):
        self.assertGreater(len(SCENES), 40)
        for scene in SCENES:
            claims = self.certified(*SIZE, "--tier", "certain", scene=scene)
            self.assertEqual(self.assert_right(scene=scene), f"a.cert: {ALL_RIGHT}\n")
            if claims.field("objects") > 5:
                self.assert_right("--quick", scene=scene)
            self.assertEqual(claims.field("acne"), 0, scene)

    def test_every_scene_by_exact(self):
        for scene in SCENES[::4]:
            self.certified("--size", "48x27", "--tier", "exact", scene=scene)
            self.assert_right(scene=scene)

    def test_places_in_a_tile_are_those_of_the_picture(self):
        truth = self.certified(*SIZE, "--tile", "10,15,40x20")
        i = truth.first(CYLINDER)
        said = self.check(WRONG, claims=truth.with_word(i, T, "inf")).stdout
        self.assertTrue(said.startswith(f"pixel {10 + i % 40},{15 + i // 40}: certified object "),
                        said)

    def test_from_within_the_size_alone_counts(self):
        """Of what the error may be: the eye is at the point that the object is told by."""
        for lines in ("C 0,0,0 0,0,-1 60\nsp 0,0,0 2000 9,9,9\n",
                      "C 0,0,0 1,1,1 60\nbo 0,0,0 1000,1000,1000 9,9,9\n"):
            put("within.rt", "A 0.1 255,255,255\nL 5,5,5 0.9\n" + lines)
            claims = self.certified(*SIZE, "--tier", "certain", scene="within.rt")
            self.assertGreater(max(claims.number(i, ERROR) for i in range(len(claims.pixels))), 0)
            self.assertEqual(self.assert_right(scene="within.rt"), f"a.cert: {ALL_RIGHT}\n")

    def test_options(self):
        self.certified(*SIZE)
        for words in (["--quick"], ["--threads", "1"], ["--threads=3"], ["--quick", "--threads=2"]):
            self.assertEqual(self.assert_right(*words), f"a.cert: {ALL_RIGHT}\n")
        self.assertEqual(self.assert_right("--quiet"), "")
        put("a.cert", contents("a.cert").replace(b" miss\n", b" 0 surface exact 0x1p+0 0x0p+0\n",
                                                 1))
        self.assertIn("1 wrong: another object 1", self.check(WRONG, "--quiet").stdout)

    def test_another_object(self):
        for tier in ("certain", "exact"):
            truth = self.certified(*SIZE, "--tier", tier)
            i = truth.first(BALL)
            t = re.escape(truth.word(i, T))
            exact = rf"exact: object {BALL} \(line {LINES[BALL]}\) surface t 0x1.*"
            claims = truth.with_word(i, OBJECT, str(CONE))
            self.assert_wrong(
                claims, "1 wrong: another object 1",
                rf"pixel {i % 64},{i // 64}: certified object {CONE} \(line {LINES[CONE]}\)"
                rf" surface t {t} \+- 0x.*; {exact}")
            claims = truth.with_answer(i, "miss").with_field("misses", truth.field("misses") + 1)
            claims = claims.with_field("hits", truth.more("hits", truth.word(i, STAGE), -1))
            self.assert_wrong(claims, "1 wrong: another object 1",
                              f"pixel {i % 64},{i // 64}: certified nothing; {exact}")

    def test_other_claims_of_a_pixel(self):
        """An object where there is none; the ball's own far side, as though the near one were
        missed; another part; an error that says nothing."""
        truth = self.certified(*SIZE, "--tier", "certain")
        ball = truth.first(BALL)
        far = hexadecimal(truth.number(ball + 2 * 64, T) + 0.5)
        for claims, total, pattern in (
                (truth.with_answer(7, truth.answer(ball)), "another object",
                 rf"pixel 7,0: certified object {BALL} .*; exact: nothing"),
                (truth.with_word(ball + 2 * 64, T, far), "t off", r"pixel .*"),
                (truth.with_word(truth.first(CYLINDER), PART, "base"), "another part",
                 r"pixel .* base t .*; exact: .* top t .*"),
                (truth.with_word(ball, ERROR, "0x1p-19"), "t too vague",
                 r"pixel .*; the error is too large"),
                (truth.with_word(ball, ERROR, "0x1p+1000"), "t too vague",
                 r"pixel .*; the error is too large"),
                (truth.with_word(ball, ERROR, "inf"), "t too vague", r"pixel .* \+- inf; .*"),
                (truth.with_word(ball, T, "inf"), "t off", r"pixel .* t inf .*")):
            self.assert_wrong(claims, f"1 wrong: {total} 1", pattern)

    def test_an_ulp_of_exact(self):
        truth = self.certified(*SIZE, "--tier", "exact")
        ball = truth.first(BALL)
        error = truth.number(ball, ERROR)
        for times, total in ((2, "t too vague"), (0.5, "t off"), (0, "t off")):
            self.assert_wrong(truth.with_word(ball, ERROR, hexadecimal(times * error)),
                              f"1 wrong: {total} 1", r"pixel .*")
        for i in map(truth.first, (FLOOR, BALL, CYLINDER, CONE)):
            self.assert_wrong(truth.with_word(i, T, ulp_up(truth.word(i, T))), "1 wrong: t off 1",
                              r"pixel .*")

    def test_the_error_of_certain(self):
        """Taken at its word: t may be anywhere in it, and no farther off than that."""
        truth = self.certified(*SIZE, "--tier", "certain")
        right = self.certified(*SIZE, "--tier", "exact")
        for i in map(truth.first, (FLOOR, BALL, CYLINDER, CONE)):
            error, t = truth.number(i, ERROR), right.number(i, T)
            for share in (0.98, -0.98):
                self.assert_right(claims=truth.with_word(i, T, hexadecimal(t + share * error)))
            wrong = [truth.with_word(i, T, hexadecimal(t + share * error))
                     for share in (1.02, -1.02)]
            wrong.append(truth.with_word(i, ERROR, "0x0p+0"))
            if truth.word(i, T) != right.word(i, T):
                wrong.append(wrong[-1].with_word(i, T, right.word(i, T)))
            for claims in wrong:
                self.assert_wrong(claims, "1 wrong: t off 1", r"pixel .*")

    def test_totals(self):
        truth = self.certified(*SIZE)
        off = truth.field("misses") - 575  # a row less than the sky's
        fewer = dict(truth.field("rays"))
        fewer["pixel"] -= 1
        fewer["shadow"] += 1
        for claims in (truth.with_field("rays", truth.more("rays", "shadow", 1)),
                       truth.with_field("rays", fewer),
                       truth.with_field("misses", 0),
                       truth.with_field("covered", truth.field("origins") + 1),
                       truth.with_field("without-origin", 2 * sum(truth.field("hits").values())),
                       truth.with_field("hits", truth.more("hits", "double", off))
                       .with_field("misses", 575),
                       truth.with_word(truth.first(BALL), STAGE, "exact")):
            self.assert_wrong(claims, "all right; the totals don't fit the pixels")
        self.assert_wrong(truth.with_field("acne", 3), "all right; acne 3")

    def test_another_picture(self):
        """Another tier, size, part or way to read the scene, each wrong in most of its pixels."""
        truth = self.certified(*SIZE, "--tier", "certain", "--tile", "0,0,63x35")
        for name, value in {"tier": "exact", "size": "72x40", "part": "1,0,63x35",
                            "fov": "vertical", "handedness": "left"}.items():
            result = self.check(WRONG, claims=truth.with_field(name, value))
            lines = result.stdout.splitlines()
            self.assertEqual((len(lines), result.stderr), (11, ""), name)
            self.assertRegex(lines[-1], r"\Alie\.cert: \d+ pixels, [1-9]\d+ wrong: ")
            places = [tuple(map(int, re.match(r"pixel (\d+),(\d+): ", line).groups()))
                      for line in lines[:-1]]
            self.assertEqual(places, sorted(places, key=lambda place: place[::-1]), name)
            again = self.check(WRONG, "--threads", "1", certificate="lie.cert")
            self.assertEqual(again.stdout, result.stdout)

    def test_another_scene(self):
        claims = self.certified(*SIZE)
        put("other.rt", SCENE + "\n")
        for scene, pattern in (("other.rt", "other.rt: error: not the scene of .*bytes.*"),
                               ("missing.rt", "missing.rt:1:1: error: No such file.*"),
                               (".", r"\.:1:1: error: a directory; .*file.*")):
            self.assert_refused(pattern, scene=scene)
        more = claims.with_field("numbers", [*claims.field("numbers"), "sphere 0x0p+0"])
        self.assert_refused("scene.rt: error: not the scene of .*number of objects.*",
                            claims=more.with_field("objects", 5))
        for lie in (claims.with_field("cylinder-position", "base"),
                    claims.with_field("cone-position", "apex"),
                    claims.with_field("numbers", claims.field("numbers")[::-1])):
            self.assert_refused("scene.rt: error: not the scene of .*other numbers", claims=lie)

    def test_a_scene_from_standard_input(self):
        """A file of that name is another scene."""
        words = ("render", "-", "-o", "a.ppm", "--quiet", "--certificate", "a.cert", *SIZE)
        for there in (False, True):
            if there:
                put("-", OTHER)
            self.succeed(*words, input=SCENE)
            self.assertEqual(Certificate.of("a.cert").head["scene"], "-")
            self.assertIn(ALL_RIGHT, self.assert_right())
            self.assertIn(ALL_RIGHT, self.succeed("check", "a.cert", "-", input=SCENE))
            self.fail_with(TROUBLE, "-: error: not the scene of .*bytes.*", "check", "a.cert", "-",
                           input=OTHER)
        self.assert_refused("./-: error: not the scene of .*bytes.*", scene="./-")

    def test_a_scene_that_is_replaced(self):
        words = ("render", "scene.rt", "-o", "a.ppm", "--quiet", "--certificate", "a.cert", *SIZE)
        self.assertEqual(self.ask_while(0, "scene.rt", OTHER, *words), "")
        self.assert_refused("scene.rt: error: not the scene of .*bytes.*")
        put("scene.rt", SCENE)
        self.assertIn(ALL_RIGHT, self.ask_while(0, "scene.rt", OTHER, "check", "a.cert",
                                                "scene.rt"))
        said = self.ask_while(TROUBLE, "scene.rt", SCENE, "check", "a.cert", "scene.rt")
        self.assertRegex(said, r"\Ascene.rt: error: not the scene of .*bytes.*\n\Z")

    def test_another_ray(self):
        truth = self.certified(*SIZE)
        i = truth.first(BALL)
        for position in (X, Y, Z):
            self.assert_wrong(truth.with_word(i, position, ulp_up(truth.word(i, position))),
                              "1 wrong: another ray 1", r"pixel .*; its ray is another one")
        eye = truth.with_field("eye", "0x1p+0 " + truth.field("eye").split(" ", 1)[1])
        self.assertIn("2304 wrong: another ray 2304", self.check(WRONG, claims=eye).stdout)

    def test_rays_and_numbers_are_those_of_the_file(self):
        claims = self.certified(*SIZE)
        eye = [float.fromhex(x) for x in claims.field("eye").split(" ")]
        self.assertEqual(eye, [0, 2, 8])
        self.assertEqual([line.split(" ")[0] for line in claims.field("numbers")],
                         ["plane", "sphere", "cylinder", "cone"])
        ball = [float.fromhex(x) for x in claims.field("numbers")[BALL].split(" ")[1:]]
        self.assertEqual(ball, [-2.5, 0, 0, 1])

    def test_lines_that_are_missing_or_too_many(self):
        claims = self.certified("--size", "8x4", "--tile", "0,0,8x4")
        head, last = claims.line(0) - 1, claims.line(31)
        whole = claims.text()
        lines = whole.splitlines(True)
        for line in range(last - 1):
            self.assert_refused(r"lie\.cert:\d+: error: .*" if line < head else
                                rf"lie\.cert:{line + 1}: error: .*ends too early",
                                claims="".join(lines[:line]))
            self.assert_refused(r"lie\.cert:\d+: error: .*" if line < head else
                                rf"lie\.cert:{last}: error: .*",
                                claims="".join(lines[:line] + lines[line + 1:]))
        for text, pattern in ((whole + claims.pixels[-1] + "\n",
                               f"{last + 1}: error: more pixels .*"),
                              (whole + "\n", f"{last + 1}: error: more pixels .*"),
                              (whole[:-1], f"{last}: error: no whole line.*"),
                              (whole[:-3], f"{last}: error: no whole line.*"),
                              ("", "1: error: .*")):
            self.assert_refused(r"lie\.cert:" + pattern, claims=text)

    def test_garbage_in_the_head(self):
        truth = self.certified("--size", "8x4")
        counts = truth.field("rays")
        garbage = {"surehit certificate": (1, "2", 2 ** 32 + 2), "scene": (1,),
                   "numbers": ([], 4, ["x"]), "eye": ("", "0x0p+0 0x0p+0", "0 0 0", 3),
                   "hash": ("xyz", "", "-1", 17 * "1", 16 * "F", 1),
                   "objects": ("four", -4, 4.5, [4, 4], 4294967296, 99999999999999999999),
                   "size": ("8x0", "8", "70000x4"),
                   "part": ("0,0,9x4", "0,1,8x4", "0,0,0x4", "-1,0,8x4", "0,0,8x4 ", "0,0,8",
                            " 0,0,8x4", "0,0,99999999999x4", "4294967296,0,8x4"),
                   "tier": ("textbook", "Certain", "certain "), "handedness": ("both",),
                   "fov": ("Vertical",), "skip-unknown": ("maybe", "no"), "falloff": ("none none",),
                   "rays": ({**counts, "shadow": "x"}, {**counts, "more": 1}, {"pixel": 32}, 32),
                   "hits": ({"double": 1},), "totals": ({},),
                   "misses": ("many", -1, 2 ** 56 + 1), "acne": ("0", None)}
        lies = [truth.with_field(name, value) for name, values in garbage.items()
                for value in values]
        doubled = truth.text().replace('"objects": 4,', '"objects": 9, "objects": 4,')
        for lie in lies + [truth.text().replace("\n}\n", "\n} "), doubled]:
            self.assert_refused(r"lie\.cert:\d+: error: .*", claims=lie)

    def test_garbage_in_a_pixel(self):
        truth = self.certified(*SIZE)
        i = truth.first(BALL)
        garbage = {X: ("", "0", "nan ", "0x1p", "0x2p+0"),
                   OBJECT: ("4", "-1", "ball", "", "01x", "4294967297"),
                   PART: ("side", "Wall", "2"), STAGE: ("triple", "double-", "doubled", "0"),
                   T: ("7.5", "nan", "-inf", "-0x1p+3", "0x1p+9999", "0x", "0x1p+3p"),
                   ERROR: ("nan", "-nan", "-0x1p-40", "0")}
        lies = [truth.with_word(i, position, word) for position, words in garbage.items()
                for word in words]
        lies += [truth.with_pixel(i, text) for text in (
            "", " ", "miss", truth.pixels[i] + " ", truth.pixels[i] + " 0",
            truth.pixels[i].replace(" ", "  "), truth.pixels[i] + "\r")]
        lies += [truth.with_answer(i, text) for text in (
            "", " ", "miss ", "miss 1", "Miss", "miss\0")]
        for lie in lies:
            self.assert_refused(rf"lie\.cert:{truth.line(i)}: error: .*", claims=lie)

    def test_no_certificate_at_all(self):
        self.render("scene.rt", "a.ppm", *SIZE)
        for path, pattern in (("a.ppm", "a.ppm:1: error: .*"),
                              ("scene.rt", "scene.rt:1: error: .*"),
                              ("missing", "missing: error: No such file.*"),
                              (".", r"\.:1: error: .*directory.*")):
            self.assert_refused(pattern, certificate=path)

    def test_a_faulty_scene(self):
        put("scene.rt", SCENE + "sq 0,0,0 1\n")
        self.ask(0, "render", "scene.rt", "-o", "a.ppm", "--certificate", "a.cert", *SIZE,
                 "--skip-unknown")
        self.assert_refused("scene.rt:8:1: error: .*",
                            claims=Certificate.of("a.cert").with_field("skip-unknown", False))

    def test_the_whole_frame_takes_seconds(self):
        scene = ROOT + "/tests/scenes/default.rt"
        self.certified("--size", "1280x720", scene=scene)
        self.assertLess(self.seconds_of(scene=scene), 10)

    def seconds_of(self, *words, **more):
        """Of all processors."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        self.assert_right(*words, **more)
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before

    def test_quick(self):
        """Where every ray would ask twenty thousand objects."""
        balls = (f"sp {i % 200},{i // 200 % 10},{-(i // 2000)} 0.5 9,9,9\n" for i in range(20000))
        put("scene.rt", SCENE + "".join(balls))
        self.certified(*SIZE)
        self.assertLess(2 * self.seconds_of("--quick"), self.seconds_of())


class TilesAndSamples(Commands):
    def test_tiles_outside(self):
        for text in ("64,0,1x1", "0,36,1x1", "60,0,5x1", "0,30,1x7", "999999999,0,1x1"):
            self.fail_with(WRONG_USAGE, rf"scene\.rt: error: the tile {re.escape(text)} is not "
                                        r"within its picture of 64x36", "render", "scene.rt", "-o",
                           "a.ppm", *SIZE, "--tile", text)

    def test_the_most_samples(self):
        self.render("scene.rt", "a.ppm", "--size", "2x2", "--samples", "4096")

    def test_what_does_not_go_together(self):
        for option in (["--certificate", "a.cert"], ["--heat", "stage"], ["--heat", "error"]):
            name = " ".join(option) if option[0] == "--heat" else option[0]
            for other, words in (("--samples 4", ["--samples", "4"]),
                                 ("--tier textbook", ["--tier=textbook"]),
                                 ("--tier float32", ["--tier", "float32"]),
                                 ("--tier stable", ["--tier", "stable"])):
                self.refuse(f"{name} does not go with {other}: ", "render", "scene.rt", "-o",
                            "a.ppm", *option, *words)
        for words in (["--tier", "textbook"], ["--samples", "4"]):
            self.render("scene.rt", "a.ppm", *SIZE, "--heat", "time", *words)


class Heat(Commands):
    """With a scene whose rays take several stages."""

    SCENE = ROOT + "/tests/scenes/extreme/ground_low.rt"
    RAMP = ((24, 20, 88), (96, 32, 140), (192, 52, 112), (240, 128, 56), (252, 236, 150))

    def key(self, kind, *words):
        """What is said below the first line, of what is drawn."""
        said = self.succeed("render", self.SCENE, "-o", f"{kind}.ppm", "--heat", kind, *words)
        return said.splitlines()[1:]

    def test_stages_have_their_colors(self):
        claims = self.certified("--size", "200x90", scene=self.SCENE)
        said, rows = self.key("stage", "--size", "200x90"), rows_of("stage.ppm")
        colors, counts = {}, {}
        for i in range(len(claims.pixels)):
            stage = "miss" if claims.object_at(i) is None else claims.word(i, STAGE)
            colors.setdefault(stage, set()).add(rows[i // 200][i % 200])
            counts[stage] = counts.get(stage, 0) + 1
        self.assertGreater(len(colors), 2, counts)
        self.assertEqual([len(found) for found in colors.values()], [1] * len(colors))
        self.assertEqual(len(set().union(*colors.values())), len(colors))
        self.assertEqual(len(rows), 90)
        found = {}
        for line in said[1:]:
            color, stage, pixels = line.split()
            found[stage] = (tuple(bytes.fromhex(color[1:])), int(pixels))
        for stage, count in counts.items():
            self.assertEqual(found.pop(stage), (*colors[stage], count))
        self.assertEqual({pixels for _, pixels in found.values()}, {0})
        self.key("stage", "--size", "200x90", "--tile", "8,10,50x20")
        self.assertEqual([row[:50] for row in rows_of("stage.ppm")[:20]],
                         [row[8:58] for row in rows[10:30]])

    def ulps(self, claims, i):
        """Of a pixel's error."""
        t = claims.number(i, T)
        return claims.number(i, ERROR) / (math.nextafter(t, math.inf) - t)

    def test_a_larger_error_is_lighter(self):
        scene = ROOT + "/tests/scenes/edge_on.rt"
        claims = self.certified("--size", "200x100", scene=scene)
        self.render(scene, "error.ppm", "--heat", "error", "--size", "200x100")
        rows, pairs, missed = rows_of("error.ppm"), [], set()
        for i in range(len(claims.pixels)):
            color = rows[i // 200][i % 200]
            if claims.object_at(i) is None:
                missed.add(color)
                continue
            pairs.append((self.ulps(claims, i), 299 * color[0] + 587 * color[1] + 114 * color[2]))
        pairs.sort()
        self.assertLess(10, pairs[-1][0] / pairs[0][0])
        lights = [light for _, light in pairs]
        self.assertGreater(len(set(lights)), 50)
        for before, after in zip(lights, lights[1:]):
            self.assertLessEqual(before, after + 1000)  # a step of a level in each channel
        self.assertEqual(len(missed), 1)

    def test_a_thousandth_at_either_end_is_not_in_the_key(self):
        left_out = set()
        for scene in ("edge_on.rt", "extreme/solids_1e9.rt", "extreme/coins.rt"):
            scene = f"{ROOT}/tests/scenes/{scene}"
            said = self.succeed("render", scene, "-o", "a.ppm", "--heat", "error", "--certificate",
                                "a.cert", "--size", "200x100")
            claims = Certificate.of("a.cert")
            decades = sorted(math.floor(math.log10(self.ulps(claims, i)))
                             for i in range(len(claims.pixels)) if claims.object_at(i) is not None)
            thousandth = len(decades) // 1000
            low, high = decades[thousandth], decades[-1 - thousandth]
            self.assertIn(f" from 1e{low} (dark) to 1e{high + 1} (light)\n", said)
            left_out |= {low - decades[0], decades[-1] - high}
        self.assertEqual(left_out, {0, 1})

    def test_colours_are_those_of_the_key(self):
        """By the logarithm, in four steps that are alike."""
        said = self.succeed("render", ROOT + "/tests/scenes/edge_on.rt", "-o", "a.ppm", "--heat",
                            "error", "--certificate", "a.cert", "--size", "200x100")
        claims, rows, seen = Certificate.of("a.cert"), rows_of("a.ppm"), set()
        low, high = map(int, re.search(r" from 1e(\S+) \(dark\) to 1e(\S+) ", said).groups())
        for i in range(len(claims.pixels)):
            if claims.object_at(i) is not None:
                share = (math.log10(self.ulps(claims, i)) - low) / (high - low)
                step = min(int(4 * min(share, 1)), 3)
                seen.add(step)
                for one, *ends in zip(rows[i // 200][i % 200], *self.RAMP[step:step + 2]):
                    self.assertTrue(min(ends) <= one <= max(ends), (share, i))
        self.assertEqual(seen, {0, 1, 2, 3})

    def test_keys_of_scales(self):
        scale = r"from 1e(-?\d+) \(dark\) to 1e(-?\d+) \(light\)"
        for kind, title, lines in (("error", "t_error in ulps of t", 2),
                                   ("time", "microseconds a pixel", 1)):
            said = self.key(kind, *SIZE)
            self.assertEqual(len(said), lines)
            found = re.fullmatch(f"heat {kind}: {title}, {scale}", said[0])
            self.assertLess(int(found[1]), int(found[2]))
            self.assertGreater(len(set(sum(rows_of(f"{kind}.ppm")[:36], []))), 1)

    def test_one_pixel_takes_what_the_frame_takes(self):
        """In the same unit, or one of them would be a thousand times the other."""
        *_, key, times = self.key("time", *SIZE, "--tile", "3,4,1x1", "--samples", "4096", "--time")
        low, high = map(int, re.search(r" from 1e(\S+) \(dark\) to 1e(\S+) ", key).groups())
        microseconds = 1e6 * json.loads(times)["frame"]
        self.assertTrue(10.0 ** low <= microseconds < 10.0 ** (high + 2), (key, times))

    def test_the_key_of_an_empty_picture(self):
        self.SCENE = "empty.rt"
        put(self.SCENE, SCENE)
        sky = (*SIZE, "--tile", "3,0,5x4")
        self.assertEqual(self.key("error", *sky), ["heat error: no ray met anything",
                                                   f"  #54585c miss {'20':>22}"])
        self.assertEqual(self.key("stage", *sky)[0], "heat stage, pixels")

    def test_a_heat_is_written_like_any_picture(self):
        self.render("scene.rt", "a.png", "--heat", "stage", *SIZE)
        self.assertEqual(contents("a.png")[:8], b"\x89PNG\r\n\x1a\n")

    def test_with_a_certificate(self):
        alone = self.certified(*SIZE).text()
        self.assertEqual(self.certified(*SIZE, "--heat", "error").text(), alone)
        self.assert_right()
        heat = rows_of("a.ppm")
        self.render("scene.rt", "b.ppm", "--heat", "error", *SIZE)
        self.assertEqual(heat, rows_of("b.ppm"))


class Times(Commands):
    KEYS = ["read", "place", "build", "forward", "frame", "write", "objects", "threads",
            "object_bytes", "hierarchy_bytes", "photon_bytes"]

    def test_one_line(self):
        line = self.render("scene.rt", "a.ppm", *SIZE, "--time", "--threads", "3")
        self.assertEqual(line.count("\n"), 1)
        found = json.loads(line)
        self.assertEqual(list(found), self.KEYS)
        self.assertEqual(found["objects"], 4)
        self.assertIn(found["threads"], (1, 3))  # 1: built without OpenMP
        for key in self.KEYS[:6]:
            self.assertTrue((key in ("place", "build", "forward") or found[key] > 0)
                            and 0 <= found[key] < 60, found)
        said = self.succeed("render", "scene.rt", "-o", "a.ppm", *SIZE, "--time").splitlines()
        self.assertEqual((len(said), list(json.loads(said[1]))), (2, self.KEYS))

    def test_the_frame_takes_longer_where_there_is_more_of_it(self):
        small, large = (json.loads(self.render("scene.rt", "a.ppm", "--time", "--threads", "1",
                                                "--size", size))
                        for size in ("16x9", "640x360"))
        self.assertLess(10 * small["frame"], large["frame"])

    def test_bytes_grow_with_what_there_is(self):
        def bytes_of(text, *words):
            put("a.rt", text)
            found = json.loads(self.render("a.rt", "a.ppm", *SIZE, "--time", *words))
            return [found[key] for key in self.KEYS[-3:]]
        few, none, dark = bytes_of(SCENE)
        self.assertEqual((none, dark), (0, 0))
        self.assertGreater(few, 4 * 60)
        balls = [SCENE + "sp 0,5,-9 1 1,1,1\n" * n for n in (100, 1100)]
        small, large = map(bytes_of, balls)
        self.assertEqual((large[0] - small[0]) % 1000, 0)
        self.assertGreater(small[0], few)
        self.assertGreater(large[1], 5 * small[1])
        self.assertGreater(small[1], 4 * 100)
        self.assertEqual(bytes_of(balls[0], "--no-hierarchy"), [small[0], 0, 0])
        caustic = Explain.HEAD + Explain.LAMP + Explain.FLOOR + "sp 0,0,0 2 255,255,255 refr:1.5\n"
        photons = [bytes_of(caustic, "--falloff", "inverse-square", "--photons", n)[2]
                   for n in ("1000", "100000")]
        self.assertGreater(photons[0], 0)
        self.assertGreater(photons[1], 30 * photons[0])


class Explain(Commands):
    HEAD = "A 0.2 255,255,255\nC 0,2,8 0,-0.15,-1 60\n"
    LAMP = "L -5,8,5 0.7 255,255,255\n"
    FLOOR = "pl 0,-1,0 0,1,0 200,200,200\n"
    NAMES = ["objects", "lights", "shadows", "highlights", "reflection", "refraction", "hierarchy",
             "forward pass", "memory"]

    def explained(self, text, *words):
        """The features, and the counts behind them."""
        put("a.rt", text)
        said = self.run_program("render", "a.rt", "-o", "a.ppm", "--quiet", "--explain", "--time",
                                *SIZE, *words).stdout
        *lines, times = said.splitlines()
        features = dict(re.fullmatch(r"(\w+(?: \w+)?)  +(.*)", line).groups()
                        for line in lines[:len(self.NAMES)])
        self.assertEqual(list(features), self.NAMES)
        all_of = 1
        counts = {}
        for line in lines[len(self.NAMES):]:
            head = re.fullmatch(r"(rays|hits decided by the stage) +(\d+)", line)
            found = re.fullmatch(r"  (\w[\w -]*\w) +(\d+)(?: +([\d.]+) %)?", line)
            all_of = int(head[2]) if head else all_of
            if found:
                counts[found[1]] = int(found[2])
                share = found[3] and f"{100 * int(found[2]) / all_of:.4f}"
                self.assertEqual(found[3], share, line)
        bytes_of = [int(number) for number in re.findall(r"\d+", features["memory"])]
        self.assertEqual(bytes_of[1:], [json.loads(times)[key] for key in Times.KEYS[-3:]])
        self.assertEqual(bytes_of[0], sum(bytes_of[1:]))
        return features, counts

    def test_nothing_is_asked_for(self):
        features, counts = self.explained(self.HEAD)
        self.assertEqual(features, {"objects": "none", "lights": "off", "shadows": "off",
                                    "highlights": "off", "reflection": "off", "refraction": "off",
                                    "hierarchy": "off: 0 bounded objects, worth it from 6 on",
                                    "forward pass": "off: no mirror, no glass",
                                    "memory": "0 bytes: objects 0, hierarchy 0, photons 0"})
        self.assertEqual(counts["pixel"], 64 * 36)
        self.assertEqual(counts["met nothing"], 64 * 36)

    def test_each_feature_by_itself(self):
        ball = "sp 0,0,0 2 255,255,255"
        lit = self.HEAD + self.LAMP + self.FLOOR
        off = {"highlights": "off", "reflection": "off", "refraction": "off"}
        dark = {"lights": "off", "shadows": "off"}
        on = "on: 1 object"
        cases = [  # scene, features, kinds of rays beside the pixels'
            (self.HEAD + self.FLOOR + ball + " spec:0.5\n", {**dark, **off}, set()),
            (lit + ball + "\n", {"lights": "on: 1 light", "shadows": "on", **off}, {"shadow"}),
            (lit + ball + " spec:0.5\n", {**off, "highlights": on}, {"shadow"}),
            (lit + ball + " refl:0.5\n", {**off, "reflection": on}, {"shadow", "mirror"}),
            (lit + ball + " refr:1\n", {**off, "refraction": on}, {"shadow", "refracted"}),
            (lit + ball + " refr:1.5\n", {**off, "reflection": on, "refraction": on},
             {"shadow", "mirror", "refracted"}),
            (self.HEAD + self.LAMP + ball + " refr:1\n",
             {"lights": "on: 1 light", "shadows": "off"}, {"refracted"}),
            (self.HEAD + 2 * self.LAMP + ball + " refr:1 spec:1\n",
             {"lights": "on: 2 lights", "shadows": "on", "highlights": on},
             {"shadow", "refracted"}),
        ]
        for text, expected, kinds in cases:
            features, counts = self.explained(text)
            for name, value in expected.items():
                self.assertEqual(features[name], value, (name, text))
            self.assertEqual({kind for kind in ("shadow", "mirror", "refracted")
                              if counts[kind] > 0}, kinds, text)

    def test_depth(self):
        facing = (self.HEAD + self.LAMP + "pl 0,-1,0 0,1,0 200,200,200 refl:0.5\n"
                  "pl 0,4,0 0,-1,0 200,200,200 refl:0.5\nsp 0,0,0 2 255,255,255 refr:1.5\n")
        seen = []
        for depth in (0, 1, 2, 8, 20):
            _, counts = self.explained(facing, "--depth", str(depth))
            seen.append((counts["mirror"], counts["refracted"], contents("a.ppm")))
        self.assertEqual(seen[0][:2], (0, 0))
        for less, more in zip(seen, seen[1:]):
            self.assertLess(less[0], more[0])
            self.assertLess(less[1], more[1])
        self.explained(facing)
        self.assertEqual(contents("a.ppm"), seen[3][2])
        falls = ("--falloff", "inverse-square", "--integrator")
        said = self.explained(facing, *falls, "auto", "--depth", "0")[0]
        self.assertIn("mirrors and glass are not followed (--depth 0)", said["forward pass"])
        self.assertEqual([said["reflection"], said["refraction"]], ["off: --depth 0"] * 2)
        for words, expected in (("--share b.share", "share"), ("--continue b.share", "continue")):
            ended = self.run_program("render", "a.rt", "-o", "a.ppm", *falls, "forward", "--depth",
                                     "3", *words.split())
            self.assertEqual(ended.returncode, WRONG_USAGE)
            self.assertIn(f"--depth does not go with --{expected}", ended.stderr)

    def test_objects_and_the_hierarchy(self):
        features, _ = self.explained(SCENE)
        self.assertEqual(features["objects"], "1 plane, 1 sphere, 1 cylinder, 1 cone")
        self.assertEqual(features["hierarchy"], "off: 3 bounded objects, worth it from 6 on")
        more = SCENE + "sp 0,5,-9 1 1,1,1\n" * 2
        self.assertEqual(self.explained(more)[0]["hierarchy"],
                         "off: 5 bounded objects, worth it from 6 on")
        more += "pl 0,9,0 0,1,0 1,1,1\nco 0,5,-9 0,1,0 1 1 1,1,1\n"
        features, _ = self.explained(more)
        self.assertEqual(features["objects"], "2 planes, 3 spheres, 1 cylinder, 2 cones")
        self.assertEqual(features["hierarchy"], "on: 6 objects")
        boxes = self.explained(SCENE + "bo 0,0,-9 1,1,-8 1,1,1\n" * 2)[0]["objects"]
        self.assertTrue(boxes.endswith(", 2 boxes"), boxes)
        self.assertEqual(self.explained(more, "--no-hierarchy")[0]["hierarchy"],
                         "off: --no-hierarchy")

    def test_photons_that_land(self):
        text = self.HEAD + self.LAMP + self.FLOOR + "sp 0,0,0 2 255,255,255 refr:1.5\n"
        features, _ = self.explained(text, "--falloff", "inverse-square", "--photons", "1000")
        found = re.fullmatch(r"on: mirrors or glass light a surface; (\d+) photons towards them, "
                             r"(\d+) landed, \d+\.\d\d s", features["forward pass"])
        self.assertTrue(0 < int(found[2]) < int(found[1]) < 2000, features)
        self.assertGreater(int(re.search(r"photons (\d+)", features["memory"])[1]), 0)

    def test_counts_are_those_of_the_certificate(self):
        names = (("misses", "met nothing"), ("covered", "covered"), ("acne", "acne"),
                 ("without-origin", "not found"))
        covered = ("A 0.2 255,255,255\nC 0,0,0 0,0,-1 60\nL 0,5,0 0.7 255,255,255\n"
                   "pl 0,0,-4 0.3,0.2,1 9,9,9 refr:1.5\n"
                   "pl 0,0,-4 0.3,0.2,1.0000000000000002 9,9,9 refr:1.5\n"
                   "sp 0,0,-3 0.2 255,0,0\n")
        for text in (SCENE, covered):
            put("scene.rt", text)
            claims = self.certified(*SIZE)
            _, counts = self.explained(text)
            for kind, rays in claims.field("rays").items():
                self.assertEqual(counts[kind], rays)
            for stage, hits in claims.field("hits").items():
                self.assertEqual(counts[stage], hits)
            for field, name in names:
                self.assertEqual(counts[name], claims.field(field))
        self.assertGreater(counts["covered"], 0)

    def test_tiers_that_promise_nothing(self):
        put("a.rt", SCENE)
        said = self.render("a.rt", "a.ppm", *SIZE, "--explain", "--tier", "textbook")
        self.assertIn("tier textbook has no stages and promises nothing", said)
        self.assertNotIn("double", said)

    def test_samples_and_tiles_count(self):
        _, counts = self.explained(SCENE, "--samples", "9", "--tile", "3,4,10x20")
        self.assertEqual(counts["pixel"], 9 * 10 * 20)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
