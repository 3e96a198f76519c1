# SPDX-License-Identifier: MIT
"""Photons on the command line, `surehit render --integrator forward` and `surehit merge`:
test_forward_commands.py SUREHIT"""

import gzip
import itertools
import json
import os
import random
import re
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from commands import (INTERRUPTED, PROGRAM, WRONG_USAGE, InFolder,  # noqa: E402
                      at_terminal, contents, put)

PHOTONS = 30000
SIZE = ("--size", "64x36")

# A floor, a ball, a mirror and a glass ball under two lamps: photons end in all ways but one.
SCENE = """\
A 0.2 255,255,255
C 0,2,8 0,-0.15,-1 60
L -5,8,5 900 255,255,255
L 2,3,2 100 255,200,150
pl 0,-1,0 0,1,0 200,200,200
sp -2.5,0,0 2 255,60,60
sp 0,0,0 1.8 255,255,255 refl:0.7
sp 2,0,1 1.8 250,250,250 refr:1.5
cy 3,0,-2 0,1,0 1.4 2 60,255,60
co -1,0,-3 0,1,0 1.8 2 60,60,255
sp -1,3,-3 1 90,90,90
falloff inverse-square
"""
DARK = re.sub(r"(?m)^L (\S+) \d+", r"L \1 0", SCENE)
PLAIN = re.sub(r"(?m)^L (\S+) \d+", r"L \1 0.5", SCENE).replace("falloff inverse-square\n", "")


def share(path):
    """A share's header, and its pixels."""
    header, pixels = gzip.decompress(contents(path)).split(b"\n", 1)
    return json.loads(header), pixels


class Forward(InFolder):
    scene = SCENE

    def words(self, output, *more, scene="scene.rt"):
        return ("render", scene, "-o", output, "--integrator", "forward", *SIZE, *more)

    def forward(self, output, *more, **options):
        """Its standard output; quiet unless asked for."""
        return self.succeed(*self.words(output, *more, **options))

    def shared(self, *more, photons=PHOTONS, share="a.share", **options):
        """The bytes of picture and share."""
        self.forward("a.ppm", "--quiet", "--photons", str(photons), "--share", share, *more,
                     **options)
        return contents("a.ppm"), contents(share)

    def cut(self, *counts):
        """Shares of so many photons each, one behind the other."""
        firsts = itertools.accumulate((0, *counts))
        for i, (first, count) in enumerate(zip(firsts, counts)):
            self.shared("--first", str(first), photons=count, share=f"{i}.share")
        return [f"{i}.share" for i in range(len(counts))]

    def merge(self, share, *names):
        """The bytes of picture and share."""
        self.assertEqual(self.succeed("merge", *names, "-o", "sum.ppm", "--share", share,
                                      "--quiet"), "")
        return contents("sum.ppm"), contents(share)


class Pictures(Forward):
    def test_the_same_for_any_number_of_threads_and_without_the_hierarchy(self):
        expected = self.shared()
        self.assertGreater(len(set(expected[0])), 50)
        for more in [("--threads", str(n)) for n in range(1, 5)] + [("--no-hierarchy",)]:
            self.assertEqual(self.shared(*more), expected, more)

    def test_seeds_bounces_and_apertures_are_heard(self):
        seen = set()
        for line in ("", "--seed 1", "--bounces 1", "--bounces=3", "--aperture 0.5",
                     "--seed 18446744073709551615", "--first 72057594037897936", "--tier float32"):
            self.shared(*line.split())
            seen.add(share("a.share")[1])
        self.assertEqual(len(seen), 8)

    def test_defaults(self):
        said = self.forward("a.ppm", "-o", "b.png", "--photons", "10", "--share", "a.share")
        self.assertRegex(said, r"\Aa\.ppm, b\.png, a\.share: 64x36, \d+\.\d\d s\n")
        header, _ = share("a.share")
        for name, value in {"seed": 16 * "0", "bounces": 16, "aperture": 0, "ranges": [[0, 10]],
                            "tier": "certain"}.items():
            self.assertEqual(header[name], value)
        self.assertEqual(header["options"]["falloff"], "inverse-square")
        put("plain.rt", PLAIN)
        self.shared(photons=10, scene="plain.rt")
        header, _ = share("a.share")
        self.assertEqual((header["bounces"], header["options"]["falloff"]), (1, "none"))
        self.assertEqual(self.counts(self.forward("a.ppm", "--size", "4x4"))["photons left"],
                         10000000)

    NAMES = ["photons left", "  escaped", "  absorbed", "  stopped", "  entered the opening",
             "points lit", "passed the view plane", "reached the eye"]

    def counts(self, said):
        lines = said.splitlines()
        self.assertEqual(len(lines), 10, said)
        found = {}
        for name, line in zip(self.NAMES, lines[1:9]):
            number = re.fullmatch(re.escape(name) + r" +(\d+)(?: +([\d.]+) per million)?", line)
            self.assertIsNotNone(number, line)
            found[name] = int(number[1])
            if name != "photons left":
                self.assertAlmostEqual(float(number[2]),
                                       1e6 * found[name] / found["photons left"], delta=0.051)
        return found

    def test_summary(self):
        for aperture in ("0", "0.8"):
            said = self.forward("a.ppm", "--photons", str(PHOTONS), "--aperture", aperture)
            found = self.counts(said)
            self.assertEqual(found["photons left"], PHOTONS)
            self.assertEqual(sum(found[name] for name in self.NAMES[1:5]), PHOTONS)
            self.assertEqual(found["  entered the opening"] > 0, aperture != "0")
            self.assertLessEqual(found["reached the eye"], found["passed the view plane"])
            self.assertGreater(found["points lit"], 0)
            self.assertRegex(said.splitlines()[9],
                             r"\Avariance of a pixel's mean [\d.e+-]+, times [\d.]+ s: "
                             r"[\d.e+-]+ s\Z")

    def test_times(self):
        said = self.forward("a.ppm", "--photons", str(PHOTONS), "--time", "--quiet")
        found = json.loads(said)
        self.assertEqual(said.count("\n"), 1)
        self.assertEqual(found["photons"], PHOTONS)
        self.assertEqual(sum(found[name] for name in
                             ("escaped", "absorbed", "stopped", "entered")), PHOTONS)
        for name in ("read", "place", "frame", "write", "objects", "threads", "lit",
                     "through", "reached", "variance"):
            self.assertLess(0, found[name], name)
        self.assertAlmostEqual(found["variance_seconds"] / found["variance"], found["frame"],
                               delta=1e-6)
        found = json.loads(self.forward("a.ppm", "--photons", "1", "--time", "--quiet"))
        self.assertIsNone(found["variance"])

    def test_explain(self):
        said = self.forward("a.ppm", "--photons", "10", "--quiet", "--explain")
        self.assertRegex(said, r"\Aobjects .*\n(?:.*\n)*reflection +on: .*\n")
        self.assertNotIn("rays ", said)

    def test_other_integrators_say_nothing_of_photons(self):
        for kind in ("auto", "backward", "mixed"):
            said = self.succeed("render", "scene.rt", "-o", "a.ppm", "--integrator", kind, *SIZE)
            self.assertRegex(said, r"\Aa\.ppm: 64x36, \d+\.\d\d s\n\Z")


class Merges(Forward):
    def test_any_cut_in_any_order(self):
        expected = self.shared()
        for counts in [(30000,), (1, 29999), (10000, 4096, 15904),
                       (1, 4095, 4096, 4097, 5000, 2711, 10000)]:
            names = self.cut(*counts)
            orders = (itertools.permutations(names) if len(names) < 4 else
                      [names, names[::-1], names[3:] + names[:3], names[::2] + names[1::2]])
            for order in orders:
                self.assertEqual(self.merge("sum.share", *order), expected, order)

    def test_a_gap(self):
        names = self.cut(7000, 9000, 3000)
        self.merge("g0", names[0], names[2])
        self.assertEqual(share("g0")[0]["ranges"], [[0, 7000], [16000, 3000]])

    def test_into_one_of_them(self):
        names = self.cut(12000, 18000)
        self.assertEqual(self.merge(names[0], *names)[1], self.shared()[1])
        os.mkfifo("pipe")
        with subprocess.Popen(["cp", names[1], "pipe"]) as writer:
            self.merge("of_pipe", "pipe")
            self.assertEqual(writer.wait(), 0)
        self.assertEqual(contents("of_pipe"), contents(names[1]))

    def test_a_share_alone(self):
        self.shared()
        expected, names = share("a.share"), self.cut(10000, 20000)
        said = self.succeed("merge", *names, "--share", "sum.share")
        self.assertIn("sum.share: 64x36, photons 0 to 29999\n", said)
        self.assertEqual(share("sum.share"), expected)
        for wrong in ("-", "sum.ppm"):
            self.fail_with(WRONG_USAGE, f"{wrong}: error: a share .*", "merge", *names, "-o",
                           "sum.png", "--share", wrong)
        self.fail_with(WRONG_USAGE, "surehit merge: error: '-o' is given 2 times.*", "merge",
                       *names, "-o", "sum.png", "-o", "sum.ppm")

    def test_the_summary_is_that_of_one_run(self):
        said = self.forward("a.ppm", "--photons", str(PHOTONS)).splitlines()
        names = self.cut(20000, 10000)
        merged = self.succeed("merge", *names[::-1], "-o", "sum.ppm").splitlines()
        self.assertEqual(merged[0], "sum.ppm: 64x36, photons 0 to 29999")
        self.assertEqual(merged[1:9], said[1:9])
        self.assertEqual(merged[9], said[9].split(",")[0])
        merged = self.succeed("merge", names[1], "-o", "sum.ppm", "--share", "sum.share")
        self.assertIn("sum.ppm, sum.share: 64x36, photons 20000 to 29999\n", merged)

    def refuse_merge(self, pattern, *names):
        self.fail_with(WRONG_USAGE, pattern, "merge", *names, "-o", "sum.ppm", "--share",
                       "sum.share")

    def test_what_does_not_go_together(self):
        """test_share.c has everything else that two shares have in common."""
        self.shared(photons=100)
        put("other.rt", SCENE + "# another one\n")
        for name, words, scene in (("scene", [], "other.rt"), ("seed", ["--seed=1"], "scene.rt")):
            self.shared("--first", "100", *words, photons=100, share="b.share", scene=scene)
            self.refuse_merge(r"b\.share: error: can't be added to a\.share: it has another "
                              + name, "a.share", "b.share")

    def test_photons_twice(self):
        for i, (first, count) in enumerate([(0, 100), (200, 100), (100, 50), (140, 80)]):
            self.shared("--first", str(first), photons=count, share=f"{i}.share")
        for order, what in (("010", "0 to 99 are in 0"), ("013", "200 to 219 are in 1"),
                            ("0213", "140 to 149 are in 2")):
            self.refuse_merge(rf"{order[-1]}\.share: error: photons {what}\.share, too",
                              *(f"{i}.share" for i in order))

    def test_what_is_no_share(self):
        self.shared(photons=100)
        put("cut.share", contents("a.share")[:-1])
        put("long.share", contents("a.share") + random.Random(1).randbytes(5000))
        os.mkdir("folder")
        for name, complaint in (("none", ""), ("scene.rt", "this is no share"),
                                ("folder", "Is a directory"), ("cut.share", "the share "),
                                ("long.share", "something follows where the share ends")):
            self.refuse_merge(f"{re.escape(name)}: error: {complaint}.*", "a.share", name)
            self.fail_with(WRONG_USAGE, f"{re.escape(name)}: error: {complaint}.*",
                           *self.words("c.ppm", "--continue", name))


def interrupt(running, after):
    """Ctrl-C, so many seconds after the program has begun to listen for it."""
    while True:
        with open(f"/proc/{running.pid}/status", encoding="ascii") as status:
            caught = int(re.search(r"^SigCgt:\s*(\w+)$", status.read(), re.M)[1], 16)
        if running.poll() is not None or caught >> (signal.SIGINT - 1) & 1:
            break
        os.sched_yield()
    time.sleep(after)
    running.send_signal(signal.SIGINT)


class Interrupted(Forward):
    MANY = "4000000000"

    def interrupt(self, *more, threads="2"):
        """What it says on standard error."""
        running = subprocess.Popen([PROGRAM, *self.words("i.ppm", "--photons", self.MANY,
                                                         "--threads", threads, *more)],
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True,
                                   preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        interrupt(running, 0.5)
        said, errors = running.communicate()
        self.assertEqual(running.returncode, INTERRUPTED, errors)
        self.assertEqual(errors.count("\n"), 1)
        return said, errors

    def test_goes_on_to_the_same_bytes(self):
        _, errors = self.interrupt("--share", "i.share", "--quiet")
        done = re.fullmatch(r"surehit render: interrupted after (\d+) photons \(0 to (\d+)\); "
                            r"go on with the same words and --continue i\.share\n", errors)
        self.assertIsNotNone(done, errors)
        done = int(done[1])
        self.assertEqual(done % 4096, 0)
        self.assertEqual(share("i.share")[0]["ranges"], [[0, done]])
        picture = contents("i.ppm")
        self.assertEqual(self.shared(photons=done), (picture, contents("i.share")))
        more = done + PHOTONS
        self.assertEqual(self.shared("--continue", "i.share", photons=more),
                         self.shared(photons=more))

    def test_without_a_share(self):
        said, errors = self.interrupt("--time", "--first", "5000", threads="1")
        done = re.search(r"interrupted after (\d+) photons \(5000 to \d+\); to be able to go on, "
                         r"give --share FILE\n\Z", errors)
        self.assertIsNotNone(done, errors)
        self.assertEqual(json.loads(said.splitlines()[-1])["photons"], int(done[1]))
        self.assertTrue(contents("i.ppm").startswith(b"P6"))

    def test_ignored_where_it_was(self):
        running = subprocess.Popen([PROGRAM, *self.words("i.ppm", "--photons", "3000000",
                                                         "--quiet")],
                                   stderr=subprocess.PIPE,
                                   preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
        time.sleep(0.2)
        running.send_signal(signal.SIGINT)
        self.assertEqual(running.communicate(), (None, b""))
        self.assertEqual(running.returncode, 0)


class Continued(Forward):
    def test_photons_that_are_there_are_not_traced_again(self):
        expected = self.shared(share="whole.share")
        self.cut(5000, 9000, 1000)
        self.merge("some", "0.share", "2.share")
        for name in ("0.share", "1.share", "some", "whole.share"):
            self.assertEqual(self.shared("--continue", name), expected, name)
        self.assertEqual(self.shared("--continue", "some", share="some"), expected)

    def test_of_all_that_is_there_nothing_is_traced(self):
        """Which takes no time that could be told."""
        self.shared(share="whole.share")
        words = ("--photons", str(PHOTONS), "--continue", "whole.share")
        self.assertNotIn("times", self.forward("a.ppm", *words))
        found = json.loads(self.forward("a.ppm", *words, "--quiet", "--time"))
        self.assertEqual((found["photons"], found["variance_seconds"]), (PHOTONS, None))

    def test_what_cannot_be_continued(self):
        self.cut(5000, 9000)

        def refused(pattern, *more):
            self.fail_with(WRONG_USAGE, pattern, *self.words("a.ppm", *more))

        last = ("--photons", "14000", "--continue", "1.share")
        stray = r"1\.share: error: has photons 5000 to 13999, which are not all among those of .*"
        refused(stray, "--photons", "13999", "--continue", "1.share")
        refused(stray, "--first", "5001", *last)
        for more in ("--seed=3", "--bounces=15", "--aperture=1", "--tier=exact"):
            refused(r"1\.share: error: can't be continued here: it has another "
                    + more[2:].split("=")[0], *last, more)
        put("scene.rt", SCENE + "\n")
        refused(r"1\.share: error: .* another scene", *last)
        refused(r"none: error: .*", "--continue", "none")


class Refused(Forward):
    def test_clashes(self):
        clashes = {"forward": "--samples=4 --tile=0,0,4x4 --certificate=a.cert --heat=time",
                   "backward": "--photons=1 --seed=1"}
        ways = " --first=0 --share=a.share --continue=a.share --bounces=1 --aperture=0"
        for kind in ("forward", "auto", "backward", "mixed"):
            options = clashes.get(kind, "") + (ways if kind != "forward" else "")
            for option in options.split():
                self.refuse(f"{option.split('=')[0]} does not go with --integrator {kind}",
                            "render", "scene.rt", "-o", "a.ppm", "--integrator", kind, option)
        self.refuse("--first does not go with --integrator auto", "render", "scene.rt", "-o",
                    "a.ppm", "--first=0")
        put("plain.rt", PLAIN)
        self.refuse("--bounces 2 does not go with --falloff none: light goes on only where it "
                    "falls off: add --falloff inverse-square",
                    *self.words("a.ppm", "--bounces=2", scene="plain.rt"))
        self.refuse("--first does not go with --photons",
                    *self.words("a.ppm", "--first=72057594037927935", "--photons=2"))

    def test_no_light(self):
        put("dark.rt", DARK)
        self.fail_with(WRONG_USAGE, r"dark\.rt: error: no light that photons could leave",
                       *self.words("a.ppm", "--share", "a.share", scene="dark.rt"))

    def test_nothing_else_is_replaced(self):
        for path in ("scene.rt", "./scene.rt"):
            self.refuse(f"'{path}' may not take the place of a file that is read, or of another",
                        *self.words("a.ppm", "--share", path))
        for path in ("b.ppm", "b.PNG"):
            self.fail_with(WRONG_USAGE, re.escape(path) + ": error: a share may not have a "
                           "picture's name", *self.words("a.ppm", "--share", path))
        names = self.cut(12000, 18000)
        os.link(names[0], "linked.ppm")
        self.refuse("'linked.ppm' may not take the place of a file that is read, or of another",
                    "merge", *names, "-o", "linked.ppm")


class Progress(Forward):
    def test_the_bar_shows_an_error_that_shrinks(self):
        shown, _, _, status = at_terminal(
            *self.words("a.ppm", "--photons", "4000000000"),
            meanwhile=lambda running: interrupt(running, 3),
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        self.assertEqual(status, INTERRUPTED)
        bars = re.findall(r"\r\[#* *\] +\d+ %, +\d+:\d\d left, error ([\d.e+-]+) % *",
                          shown)
        self.assertGreater(len(bars), 3, shown)
        self.assertLess(float(bars[-1]), float(bars[0]))
        self.assertRegex(shown, r"left, error [\d.e+-]+ % *\r +\rsurehit render: interrupted")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
