"""Photons on the command line, `surehit render --integrator forward` and `surehit merge`:
test_forward_commands.py SUREHIT png|no-png"""

import gzip
import itertools
import json
import os
import pty
import re
import signal
import subprocess
import sys
import time
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "cli"))
from test_cli import (FAULTY_SCENE, HAS_PNG, OUTPUT_FAILED, PROGRAM, WRONG_USAGE, InFolder,
                      contents, limit_file_size)

INTERRUPTED = 130
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
    def setUp(self):
        super().setUp()
        self.put("scene.rt", SCENE)

    def fail_with(self, *words, **more):
        self.before = set(os.listdir("."))
        super().fail_with(*words, **more)

    def words(self, output, *more, scene="scene.rt"):
        return ("render", scene, "-o", output, "--integrator", "forward", *SIZE, *more)

    def forward(self, output, *more, **options):
        """Its standard output; quiet unless asked for."""
        return self.succeed(*self.words(output, *more, **options))

    def made(self, *more, name="a", photons=PHOTONS, **options):
        """The bytes of a picture and its share."""
        said = self.forward(f"{name}.ppm", "--quiet", "--photons", str(photons), "--share",
                            f"{name}.share", *more, **options)
        self.assertEqual(said, "")
        return contents(f"{name}.ppm"), contents(f"{name}.share")

    def whole(self):
        return self.made(name="whole")

    def cut(self, *counts):
        """Shares of so many photons each, one behind the other."""
        names, first = [], 0
        for i, count in enumerate(counts):
            names.append(f"{i}.share")
            self.made("--first", str(first), name=str(i), photons=count)
            first += count
        return names

    def assert_merged(self, names, expected):
        self.assertEqual(self.succeed("merge", *names, "-o", "sum.ppm", "--share", "sum.share",
                                      "--quiet"), "")
        self.assertEqual((contents("sum.ppm"), contents("sum.share")), expected, names)


class Pictures(Forward):
    def test_the_same_for_any_number_of_threads_and_without_the_hierarchy(self):
        expected = self.whole()
        self.assertGreater(len(set(expected[0])), 50)
        for more in [("--threads", str(n)) for n in range(1, 5)] + [("--no-hierarchy",)]:
            self.assertEqual(self.made(*more), expected, more)

    def test_seeds_bounces_and_apertures_are_heard(self):
        seen = set()
        for more in [(), ("--seed", "1"), ("--bounces", "1"), ("--bounces=3",),
                     ("--aperture", "0.5"), ("--seed", "18446744073709551615"),
                     ("--first", "72057594037897936"), ("--tier", "float32")]:
            self.made(*more)
            seen.add(share("a.share")[1])
        self.assertEqual(len(seen), 8)

    def test_defaults(self):
        self.made(photons=10)
        header, _ = share("a.share")
        for name, value in {"seed": 16 * "0", "bounces": 16, "aperture": 0, "ranges": [[0, 10]],
                            "tier": "certain"}.items():
            self.assertEqual(header[name], value)
        self.assertEqual(header["options"]["falloff"], "inverse-square")
        self.put("plain.rt", PLAIN)
        self.made(photons=10, scene="plain.rt")
        header, _ = share("a.share")
        self.assertEqual((header["bounces"], header["options"]["falloff"]), (1, "none"))
        self.assertEqual(self.counts(self.forward("a.ppm", "--size", "4x4"))["photons left"],
                         10000000)

    def test_several_pictures(self):
        words = ("-o", "b.png") if HAS_PNG else ("-o", "b.ppm")
        said = self.forward("a.ppm", *words, "--photons", "1000", "--share", "a.share")
        self.assertRegex(said, rf"\Aa\.ppm, {words[1]}, a\.share: 64x36, \d+\.\d\d s\n")

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
        expected = self.whole()
        for counts in [(30000,), (1, 29999), (10000, 4096, 15904),
                       (1, 4095, 4096, 4097, 5000, 2711, 10000)]:
            names = self.cut(*counts)
            orders = (itertools.permutations(names) if len(names) < 4 else
                      [names, names[::-1], names[3:] + names[:3], names[::2] + names[1::2]])
            for order in orders:
                self.assert_merged(order, expected)

    def test_any_grouping(self):
        expected = self.whole()
        names = self.cut(7000, 9000, 3000, 11000)
        for groups in ((names[:2], names[2:]), (names[::2], names[1::2]), (names[1:], names[:1])):
            for i, group in enumerate(groups):
                self.succeed("merge", *group, "-o", "a.ppm", "--share", f"g{i}", "--quiet")
            self.assert_merged(["g1", "g0"], expected)
        self.succeed("merge", names[0], names[2], "-o", "a.ppm", "--share", "g0", "--quiet")
        self.assertEqual(share("g0")[0]["ranges"], [[0, 7000], [16000, 3000]])

    def test_into_one_of_them(self):
        expected = self.whole()
        names = self.cut(12000, 18000)
        self.succeed("merge", *names, "-o", "a.ppm", "--share", names[0], "--quiet")
        self.assertEqual(contents(names[0]), expected[1])

    def test_the_summary_is_that_of_one_run(self):
        said = self.forward("a.ppm", "--photons", str(PHOTONS)).splitlines()
        names = self.cut(20000, 10000)
        merged = self.succeed("merge", *names[::-1], "-o", "sum.ppm").splitlines()
        self.assertEqual(merged[0], "sum.ppm: 64x36, photons 0 to 29999")
        self.assertEqual(merged[1:9], said[1:9])
        self.assertEqual(merged[9], said[9].split(",")[0])
        merged = self.succeed("merge", names[1], "-o", "sum.ppm", "--share", "sum.share")
        self.assertIn("sum.ppm, sum.share: 64x36, photons 20000 to 29999\n", merged)

    def refuse_merge(self, pattern, *names, status=WRONG_USAGE):
        self.fail_with(status, pattern, "merge", *names, "-o", "sum.ppm", "--share", "sum.share")

    def test_what_does_not_go_together(self):
        self.made(photons=100)
        self.put("other.rt", SCENE + "# another one\n")
        cases = {"scene": (), "seed": ("--seed", "1"), "bounces": ("--bounces", "2"),
                 "aperture": ("--aperture", "0.1"), "tier": ("--tier", "exact"),
                 "size": ("--size", "64x37"), "fov": ("--fov", "vertical"),
                 "handedness": ("--handedness", "left"), "skip-unknown": ("--skip-unknown",),
                 "cone-position": ("--cone-position", "apex"),
                 "cylinder-position": ("--cylinder-position", "base")}
        for name, more in cases.items():
            scene = "other.rt" if name == "scene" else "scene.rt"
            self.made("--first", "100", *more, name="b", photons=100, scene=scene)
            self.refuse_merge(rf"b\.share: error: can't be added to a\.share: it has another "
                              rf"{name}", "a.share", "b.share")

    def test_photons_twice(self):
        for i, (first, count) in enumerate([(0, 100), (200, 100), (100, 50), (140, 80)]):
            self.made("--first", str(first), name=str(i), photons=count)
        self.refuse_merge(r"0\.share: error: photons 0 to 99 are in 0\.share, too",
                          "0.share", "1.share", "0.share")
        self.refuse_merge(r"3\.share: error: photons 200 to 219 are in 1\.share, too",
                          "0.share", "1.share", "3.share")
        self.refuse_merge(r"3\.share: error: photons 140 to 149 are in 2\.share, too",
                          "0.share", "2.share", "1.share", "3.share")

    def test_what_is_no_share(self):
        self.made(photons=100)
        self.refuse_merge(r"none: error: .*", "a.share", "none")
        self.refuse_merge(r"scene\.rt: error: this is no share", "a.share", "scene.rt")
        with open("cut.share", "wb") as file:
            file.write(contents("a.share")[:-1])
        self.refuse_merge(r"cut\.share: error: the share .*", "cut.share")
        os.mkdir("folder")
        self.refuse_merge(r"folder: error: .*", "folder")

    def test_usage(self):
        self.made(photons=100)
        for words, complaint in (((), "missing 'A.share'"), (("a.share",), "missing '-o FILE'"),
                                 (("a.share", "-o"), "a value is missing after '-o'"),
                                 (("a.share", "--nope"), "unknown option '--nope'")):
            self.fail_with(WRONG_USAGE, re.escape(f"surehit merge: error: {complaint}") + ".*",
                           "merge", *words)
        self.fail_with(WRONG_USAGE, r"a\.gif: error: .*", "merge", "a.share", "-o", "a.gif")
        for words in (("-o", "missing/a.ppm"), ("-o", "b.ppm", "--share", "missing/b.share")):
            self.fail_with(OUTPUT_FAILED, r"missing/.*: error: .*", "merge", "a.share", *words)
        for word in ("A.share", "-o", "--share", "--quiet", "Exit status"):
            self.assertIn(word, self.succeed("merge", "--help"))


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
        self.assertEqual(self.made(photons=done), (picture, contents("i.share")))
        more = done + PHOTONS
        self.assertEqual(self.made("--continue", "i.share", name="b", photons=more),
                         self.made(photons=more))

    def test_without_a_share(self):
        said, errors = self.interrupt("--time", threads="1")
        done = re.search(r"interrupted after (\d+) photons \(0 to \d+\); to be able to go on, "
                         r"give --share FILE\n\Z", errors)
        self.assertIsNotNone(done, errors)
        self.assertEqual(json.loads(said.splitlines()[-1])["photons"], int(done[1]))
        self.assertTrue(contents("i.ppm").startswith(b"P6"))

    def test_elsewhere_in_the_range(self):
        _, errors = self.interrupt("--share", "i.share", "--quiet", "--first", "5000")
        self.assertRegex(errors, r"\(5000 to \d+\)")

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
        expected = self.whole()
        self.cut(5000, 9000, 1000)
        self.succeed("merge", "0.share", "2.share", "-o", "a.ppm", "--share", "some", "--quiet")
        for words in (("0.share",), ("1.share",), ("some",), ("whole.share",)):
            self.assertEqual(self.made("--continue", *words), expected, words)
        self.forward("a.ppm", "--photons", str(PHOTONS), "--quiet", "--share", "some",
                     "--continue", "some")
        self.assertEqual(contents("some"), expected[1])

    def test_of_all_that_is_there_nothing_is_traced(self):
        """Which takes no time that could be told."""
        self.whole()
        words = ("--photons", str(PHOTONS), "--continue", "whole.share")
        self.assertNotIn("times", self.forward("a.ppm", *words))
        found = json.loads(self.forward("a.ppm", *words, "--quiet", "--time"))
        self.assertEqual((found["photons"], found["variance_seconds"]), (PHOTONS, None))

    def test_what_cannot_be_continued(self):
        self.cut(5000, 9000)
        last = ("--photons", "14000", "--continue", "1.share")
        stray = r"1\.share: error: has photons 5000 to 13999, which are not all among those of .*"
        self.fail_with(WRONG_USAGE, stray, *self.words("a.ppm", "--photons", "13999",
                                                       "--continue", "1.share"))
        self.fail_with(WRONG_USAGE, stray, *self.words("a.ppm", "--first", "5001", *last))
        for name, more in (("seed", ("--seed=3",)), ("bounces", ("--bounces=15",)),
                           ("aperture", ("--aperture=1",)), ("tier", ("--tier=exact",))):
            self.fail_with(WRONG_USAGE, rf"1\.share: error: can't be continued here: it has "
                                        rf"another {name}", *self.words("a.ppm", *last, *more))
        self.put("scene.rt", SCENE + "\n")
        self.fail_with(WRONG_USAGE, r"1\.share: error: .* another scene",
                       *self.words("a.ppm", *last))
        self.fail_with(WRONG_USAGE, r"none: error: .*",
                       *self.words("a.ppm", "--continue", "none"))


class Refused(Forward):
    def test_clashes(self):
        forward = [("--samples=4",), ("--tile=0,0,4x4",), ("--certificate=a.cert",),
                   ("--heat=time",)]
        for more in forward:
            self.refuse(f"{more[0].split('=')[0]} does not go with --integrator forward",
                        *self.words("a.ppm", *more))
        ways = [("--first=0",), ("--share=a.share",), ("--continue=a.share",), ("--bounces=1",),
                ("--aperture=0",)]
        for kind in ("auto", "backward", "mixed"):
            for more in ways:
                self.refuse(f"{more[0].split('=')[0]} does not go with --integrator {kind}",
                            "render", "scene.rt", "-o", "a.ppm", "--integrator", kind, *more)
        self.refuse("--first does not go with --integrator auto", "render", "scene.rt", "-o",
                    "a.ppm", "--first=0")
        for more in ("--photons=1", "--seed=1"):
            self.refuse(f"{more.split('=')[0]} does not go with --integrator backward",
                        "render", "scene.rt", "-o", "a.ppm", "--integrator", "backward", more)
        self.put("plain.rt", PLAIN)
        self.refuse("--bounces 2 does not go with --falloff none: light goes on only where it "
                    "falls off: add --falloff inverse-square",
                    *self.words("a.ppm", "--bounces=2", scene="plain.rt"))
        self.refuse("--first does not go with --photons",
                    *self.words("a.ppm", "--first=72057594037927935", "--photons=2"))

    def test_values(self):
        for option, values in {"--integrator": ("sideways", "Forward"),
                               "--photons": ("0", "-1", "1e6", "72057594037927937"),
                               "--first": ("-1", "72057594037927936"),
                               "--seed": ("-1", "18446744073709551616", "x"),
                               "--bounces": ("0", "1000001"),
                               "--aperture": ("-1", "inf", "nan", "1e999", "0.1m", "0x3")}.items():
            for value in values:
                self.refuse(f"{option} '{value}': expected",
                            *self.words("a.ppm", f"{option}={value}"))

    def test_no_light(self):
        self.put("dark.rt", DARK)
        self.fail_with(WRONG_USAGE, r"dark\.rt: error: no light that photons could leave",
                       *self.words("a.ppm", "--share", "a.share", scene="dark.rt"))

    def test_scenes(self):
        self.put("faulty.rt", FAULTY_SCENE)
        for scene in ("faulty.rt", "missing.rt"):
            self.fail_with(WRONG_USAGE, f"{scene}:.*",
                           *self.words("a.ppm", "--share", "a.share", scene=scene))

    def test_places_are_checked_first(self):
        os.mkdir("folder")
        for path in ("missing/a.share", "folder"):
            self.fail_with(OUTPUT_FAILED, re.escape(path) + ": error: .*",
                           *self.words("a.ppm", "--share", path, scene="missing.rt"))
        for path in ("scene.rt", "./scene.rt", "b.ppm", "b.PNG"):
            self.fail_with(WRONG_USAGE, re.escape(path) + ": error: a share may not take the "
                           "place of .*", *self.words("a.ppm", "--share", path))

    def test_all_or_nothing(self):
        self.put("old.share", "old")
        for path in ("old.share", "new.share"):
            result = self.run_program(*self.words("a.ppm", "--photons", str(PHOTONS), "--share",
                                                  path, "--size", "32x32"),
                                      preexec_fn=limit_file_size)
            self.assertEqual((result.returncode, result.stdout), (OUTPUT_FAILED, ""))
            self.assertRegex(result.stderr, rf"\A{path}: error: .*\n\Z")
        self.assertEqual(contents("old.share"), b"old")
        self.assertEqual(set(os.listdir(".")), {"scene.rt", "old.share", "a.ppm"})

    def test_pipes(self):
        os.mkfifo("pipe.rt")
        writer = os.fork()
        if writer == 0:
            signal.signal(signal.SIGPIPE, signal.SIG_DFL)
            with open("pipe.rt", "wb") as pipe:
                pipe.write(contents("scene.rt"))
            os._exit(0)
        self.fail_with(WRONG_USAGE, r"pipe\.rt: error: .*of a scene in a file.*",
                       *self.words("b.ppm", "--share", "b.share", scene="pipe.rt"))
        os.waitpid(writer, 0)


class Progress(Forward):
    def test_the_bar_shows_an_error_that_shrinks(self):
        master, slave = pty.openpty()
        running = subprocess.Popen([PROGRAM, *self.words("a.ppm", "--photons", "4000000000")],
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=slave,
                                   preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        os.close(slave)
        interrupt(running, 3)
        shown = b""
        while True:
            try:
                part = os.read(master, 4096)
            except OSError: # the terminal's other side is closed
                break
            if not part:
                break
            shown += part
        os.close(master)
        self.assertEqual(running.wait(), INTERRUPTED)
        bars = re.findall(r"\r\[#* *\] +\d+ %, +\d+:\d\d left, error ([\d.e+-]+) % *",
                          shown.decode("ascii"))
        self.assertGreater(len(bars), 3, shown)
        self.assertLess(float(bars[-1]), float(bars[0]))
        self.assertRegex(shown, rb"left, error [\d.e+-]+ % *\r +\rsurehit render: interrupted")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
