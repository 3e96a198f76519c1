"""The command line as its users meet it: test_cli.py SUREHIT png|no-png

The second word says whether the program was built to write PNG."""

import json
import math
import os
import pty
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from shapes import SHAPES  # noqa: E402

PROGRAM = os.path.abspath(sys.argv[1])
HAS_PNG = {"png": True, "no-png": False}[sys.argv[2]]

SCENE = """\
A 0.2 255,255,255
C 0,1,6 0,-0.1,-1 70
L -5,6,5 0.7 255,255,255
pl 0,-1,0 0,1,0 200,200,200
sp 0,0,0 2 255,60,60
cy 2.2,0,-1 0,1,0 1.4 2 60,255,60
co -2.2,0,-1 0,1,0 1.8 2 60,60,255
"""
FAULTY_SCENE = SCENE + "pll 0,-1,0 0,1,0 200,200,200\n"

# A measurement that takes no time.
QUICK = ("--cases", "20", "--repeats", "3")

OUTPUT_FAILED = 1
WRONG_USAGE = 2


def limit_file_size():
    """Less than the test's output, and more than an OpenMP library keeps for itself in a file."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192))


def contents(path):
    with open(path, "rb") as file:
        return file.read()


class InFolder(unittest.TestCase):
    """Every test has a folder of its own that holds scene.rt and is the working folder."""

    def setUp(self):
        self.start = os.getcwd()
        self.folder = tempfile.TemporaryDirectory(prefix="test_cli.", dir=self.start)
        os.chdir(self.folder.name)
        self.put("scene.rt", SCENE)
        self.before = set(os.listdir("."))

    def tearDown(self):
        os.chdir(self.start)
        self.folder.cleanup()

    def put(self, path, text):
        with open(path, "w", encoding="ascii") as file:
            file.write(text)

    def run_program(self, *words, **more):
        more.setdefault("stdout", subprocess.PIPE)
        more.setdefault("stderr", subprocess.PIPE)
        return subprocess.run([PROGRAM, *words], stdin=subprocess.DEVNULL, text=True, check=False,
                              **more)

    def succeed(self, *words):
        """Its standard output; nothing was said on standard error."""
        result = self.run_program(*words)
        self.assertEqual((result.returncode, result.stderr), (0, ""), words)
        return result.stdout

    def fail_with(self, status, pattern, *words, **more):
        """One line on standard error, which the pattern matches; no output and no new file."""
        result = self.run_program(*words, **more)
        self.assertRegex(result.stderr, r"\A" + pattern + r"\n\Z", words)
        self.assertEqual(result.stderr.count("\n"), 1, words)
        self.assertEqual((result.returncode, result.stdout or ""), (status, ""), words)
        self.assertEqual(set(os.listdir(".")), self.before, words)

    def refuse(self, complaint, *words):
        """`words` begin with a command."""
        name = "surehit " + words[0] if words[0] in ("render", "bench") else "surehit"
        self.fail_with(WRONG_USAGE,
                       re.escape(f"{name}: error: {complaint}") + f".*; see '{name} --help'",
                       *words)

    def header(self, path):
        return contents(path)[:30].split(b"\n")[:3]


class Help(InFolder):
    def test_every_command_has_one(self):
        for words in ([], ["render"], ["bench"]):
            text = self.succeed(*words, "--help")
            lines = text.split("\n")
            self.assertTrue(text.startswith(" ".join(["Usage: surehit", *words]) + " "), text)
            self.assertLessEqual(max(map(len, lines)), 80)
            self.assertLess(len(lines), 60 if words == ["render"] else 30)

    def test_it_names_every_command_and_option(self):
        for word in ("render", "merge", "bench", "--help", "--version"):
            self.assertIn(word, self.succeed("--help"))
        for word in ("-o", "--size", "--tier", "--threads", "--quiet", "--handedness", "--fov",
                     "--cylinder-position", "--cone-position", "--falloff", "--skip-unknown",
                     "float32", "textbook", "stable", "certain", "exact", "Exit status",
                     "--integrator", "--photons", "--seed", "--first", "--bounces", "--aperture",
                     "--share", "--continue", "auto", "backward", "forward", "mixed"):
            self.assertIn(word, self.succeed("render", "--help"))
        for word in ("--shape", "--regime", "--tier", "--cases", "--repeats", "--json", "cylinder",
                     "wall_parallel", "bits", "float32", "exact", "Exit status"):
            self.assertIn(word, self.succeed("bench", "--help"))

    def test_no_word_at_all(self):
        result = self.run_program()
        self.assertEqual((result.returncode, result.stdout), (WRONG_USAGE, ""))
        self.assertEqual(result.stderr, self.succeed("--help"))

    def test_version(self):
        self.assertRegex(self.succeed("--version"), r"\Asurehit \d+\.\d+\.\d+\n\Z")

    def test_lost_output_is_reported(self):
        for words in (["--help"], ["--version"], ["render", "--help"], ["bench", "--help"],
                      ["bench", *QUICK]):
            complaint = "surehit.*: error: standard output cannot be written"
            with open("/dev/full", "w", encoding="ascii") as full:
                self.fail_with(OUTPUT_FAILED, complaint + "(: No space left on device)?",
                               *words, stdout=full)
            self.fail_with(OUTPUT_FAILED, complaint + "(: Bad file descriptor)?",
                           *words, preexec_fn=lambda: os.close(1))


class Usage(InFolder):
    def test_words_that_are_wrong(self):
        self.refuse("unknown command 'nope'", "nope")
        self.refuse("unknown option '--nope'", "--nope")
        self.refuse("unknown option '-x'", "-x")
        self.refuse("no command", "--")
        for command in ("render", "bench"):
            for word in ("--nope", "-x", "--hel", "--helpme", "---"):
                self.refuse(f"unknown option '{word}'", command, word)
            self.refuse("a value was given to '--help'", command, "--help=yes")
        self.refuse("one word too many: '--cases'", "bench", "--", "--cases")
        self.refuse("one word too many: 'x'", "bench", "x")

    def test_words_that_are_missing(self):
        self.refuse("missing 'SCENE.rt'", "render")
        self.refuse("missing 'SCENE.rt'", "render", "-o", "a.ppm")
        self.refuse("missing '-o FILE'", "render", "scene.rt")
        self.refuse("one word too many: 'b.rt'", "render", "scene.rt", "b.rt", "-o", "a.ppm")
        for option in ("-o", "--size", "--tier", "--threads", "--fov", "--handedness", "--falloff",
                       "--cylinder-position", "--cone-position"):
            self.refuse(f"a value is missing after '{option}'", "render", "scene.rt", option)
            self.refuse(f"a value is missing after '{option}'", "render", "scene.rt", option, "")
        self.refuse("a value is missing after '--size'", "render", "scene.rt", "--size=")
        for option in ("--shape", "--regime", "--tier", "--cases", "--repeats", "--json"):
            self.refuse(f"a value is missing after '{option}'", "bench", option)

    def test_values_that_are_wrong(self):
        wrong = {
            "--size": ("0x10", "10x0", "-1x10", "10x-1", "10", "x", "10x", "x10", "10x10x10",
                       "1e2x10", "10X10", " 10x10", "10x10 ", "+1x1", "4294967297x1",
                       "2147483648x1", "99999999999999999999x1"),
            "--threads": ("0", "-1", "+1", " 1", "1 ", "1.0", "two", "1025", "4294967297",
                          "18446744073709551617", "0x1"),
            "--tier": ("TEXTBOOK", "text", "textbook ", "2", "double-double"),
            "--fov": ("diagonal",),
            "--handedness": ("both",),
            "--falloff": ("linear",),
            "--cylinder-position": ("apex",),
            "--cone-position": ("tip",),
        }
        for option, values in wrong.items():
            for value in values:
                complaint = f"{option} '{value}': expected"
                self.refuse(complaint, "render", "scene.rt", "-o", "a.ppm", option, value)
                self.refuse(complaint, "render", f"{option}={value}", "scene.rt", "-o", "a.ppm")
        self.refuse("a value was given to '--quiet'", "render", "scene.rt", "--quiet=1")
        self.refuse("--tier 'sure': expected float32, textbook, stable, certain or exact",
                    "render", "scene.rt", "-o", "a.ppm", "--tier", "sure")
        wrong = {
            "--shape": ("SPHERE", "spheres", "0"),
            "--regime": ("Typical", "typical ", "0"),
            "--tier": ("naive", "EXACT", "1"),
            "--cases": ("0", "-1", "x", "1048577", "18446744073709551617"),
            "--repeats": ("0", "-1", "x", "10001", "18446744073709551617"),
        }
        for option, values in wrong.items():
            for value in values:
                self.refuse(f"{option} '{value}': expected", "bench", option, value)
        self.refuse("--regime 'apex': expected a regime that the shape has", "bench", "--regime",
                    "apex", "--shape", "sphere")


class Render(InFolder):
    def test_says_what_it_wrote(self):
        said = self.succeed("render", "scene.rt", "-o", "a.ppm", "--size", "16x9")
        self.assertRegex(said, r"\Aa\.ppm: 16x9, \d+\.\d\d s\n\Z")
        self.assertEqual(self.header("a.ppm"), [b"P6", b"16 9", b"255"])
        self.assertEqual(len(contents("a.ppm")), len(b"P6\n16 9\n255\n") + 3 * 16 * 9)
        quiet = self.succeed("render", "--quiet", "scene.rt", "-o", "a.ppm", "--size=4x4")
        self.assertEqual(quiet, "")
        self.assertEqual(self.header("a.ppm"), [b"P6", b"4 4", b"255"])

    def test_options_before_between_and_after(self):
        self.succeed("render", "--size=8x8", "-o", "a.ppm", "scene.rt", "--tier=textbook")
        self.succeed("render", "-o", "b.ppm", "--tier", "textbook", "--size", "8x8", "--",
                     "scene.rt")
        self.succeed("render", "scene.rt", "--size", "9x9", "-o", "c.ppm", "--size", "8x8")
        self.assertEqual(contents("a.ppm"), contents("b.ppm"))
        self.assertEqual(contents("a.ppm"), contents("c.ppm"))

    def test_every_option_reaches_the_picture(self):
        self.put("tall.rt", SCENE + "sq 0,0,0 0,1,0 1 255,0,0\n")
        plain = ("render", "scene.rt", "-o", "plain.ppm", "--size", "64x48")
        self.succeed(*plain)
        for words in (["--handedness", "left"], ["--fov=vertical"], ["--cylinder-position", "base"],
                      ["--cone-position", "base"], ["--cone-position=apex"],
                      ["--falloff", "inverse-square"]):
            self.succeed("render", "scene.rt", "-o", "other.ppm", "--size", "64x48", *words)
            self.assertNotEqual(contents("other.ppm"), contents("plain.ppm"), words)
        self.assertEqual(self.run_program("render", "tall.rt", "-o", "tall.ppm", "--size", "64x48")
                         .returncode, WRONG_USAGE)
        skipped = self.run_program("render", "tall.rt", "-o", "tall.ppm", "--size", "64x48",
                                   "--skip-unknown")
        self.assertEqual(skipped.returncode, 0)
        self.assertIn("sq", skipped.stderr)
        self.assertEqual(contents("tall.ppm"), contents("plain.ppm"))

    def test_tiers_differ_somewhere(self):
        for tier in ("float32", "textbook", "stable", "certain", "exact"):
            self.succeed("render", "scene.rt", "-o", f"{tier}.ppm", "--size", "320x200", "--tier",
                         tier)
            self.assertEqual(self.header(f"{tier}.ppm"), [b"P6", b"320 200", b"255"])
        self.succeed("render", "scene.rt", "-o", "default.ppm", "--size", "320x200")
        self.assertEqual(contents("default.ppm"), contents("certain.ppm"))
        self.assertNotEqual(contents("default.ppm"), contents("float32.ppm"))

    def test_the_same_bytes_for_any_number_of_threads(self):
        words = ("render", "scene.rt", "--size", "301x203", "-o")
        self.succeed(*words, "default.ppm")
        for threads in ("1", "2", "3", "4"):
            self.succeed(*words, f"{threads}.ppm", "--threads", threads)
            self.assertEqual(contents(f"{threads}.ppm"), contents("default.ppm"), threads)

    def test_two_pictures_of_one_rendering(self):
        self.succeed("render", "scene.rt", "-o", "alone.ppm", "--size", "32x20")
        words = ("render", "scene.rt", "-o", "a.ppm", "-o", "a.png", "--size", "32x20")
        if not HAS_PNG:
            self.before.add("alone.ppm")
            self.fail_with(WRONG_USAGE, r"a\.png: error: .*no PNG.*", *words)
            return
        self.assertRegex(self.succeed(*words), r"\Aa\.ppm, a\.png: 32x20, ")
        self.assertEqual(contents("a.ppm"), contents("alone.ppm"))
        self.assertEqual(contents("a.png")[:24],
                         b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x20\0\0\0\x14")

    def test_unusual_names(self):
        os.mkdir("a folder")
        os.rename("scene.rt", "a folder/my scene.rt")
        for output in ("a folder/my picture.ppm", "-o.ppm", "--.PPM", ".ppm", "a;b'c\".ppm"):
            self.assertIn(output, self.succeed("render", "a folder/my scene.rt", "-o", output,
                                               "--size", "4x4"))
            self.assertEqual(self.header(output), [b"P6", b"4 4", b"255"])
        os.rename("a folder/my scene.rt", "--size")
        result = self.run_program("render", "-o", "b.ppm", "--size", "4x4", "--", "--size")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(self.header("b.ppm"), [b"P6", b"4 4", b"255"])

    def test_endings_are_checked_first(self):
        for path in ("a", "ppm", "a.jpg", "a.ppm.txt", "missing/a", "a.ppm/", "/dev/stdout"):
            for scene in ("scene.rt", "missing.rt"):
                self.fail_with(WRONG_USAGE, re.escape(path) + r": error: .*\.ppm.*",
                               "render", scene, "-o", path)
        self.fail_with(WRONG_USAGE, r"b\.gif: error: .*",
                       "render", "scene.rt", "-o", "a.ppm", "-o", "b.gif")

    def test_places_are_checked_before_the_scene(self):
        os.mkdir("folder.ppm")
        self.put("file", "")
        self.before |= {"folder.ppm", "file"}
        for path in ("missing/a.ppm", "folder.ppm", "file/a.ppm", "scene.rt/a.ppm"):
            for scene in ("scene.rt", "missing.rt"):
                self.fail_with(OUTPUT_FAILED, re.escape(path) + ": error: .*",
                               "render", scene, "-o", path)

    def test_a_folder_that_takes_no_file(self):
        self.fail_with(OUTPUT_FAILED, r"/proc/a\.ppm: error: .*",
                       "render", "scene.rt", "-o", "/proc/a.ppm")

    def test_a_faulty_scene_touches_nothing(self):
        self.put("faulty.rt", FAULTY_SCENE)
        self.put("old.ppm", "old")
        self.before |= {"faulty.rt", "old.ppm"}
        for scene in ("faulty.rt", "missing.rt", "."):
            for output in ("old.ppm", "new.ppm"):
                result = self.run_program("render", scene, "-o", output)
                self.assertEqual((result.returncode, result.stdout), (WRONG_USAGE, ""))
                self.assertTrue(result.stderr.startswith(scene + ":"), result.stderr)
                self.assertEqual(set(os.listdir(".")), self.before)
        self.assertEqual(contents("old.ppm"), b"old")

    def test_a_full_disk_leaves_what_was_there(self):
        self.put("old.ppm", "old")
        self.before.add("old.ppm")
        for path in ("old.ppm", "new.ppm"):
            self.fail_with(OUTPUT_FAILED, re.escape(path) + ": error: .*too large",
                           "render", "scene.rt", "-o", path, "--size", "64x64",
                           preexec_fn=limit_file_size)
        self.assertEqual(contents("old.ppm"), b"old")

    def test_closed_streams_do_not_reach_the_picture(self):
        words = ("render", "scene.rt", "-o", "a.ppm", "--size", "4x4")
        self.succeed(*words)
        whole = contents("a.ppm")
        self.before.add("a.ppm")
        self.fail_with(OUTPUT_FAILED, "surehit render: error: .*Bad file descriptor", *words,
                       preexec_fn=lambda: os.close(1))
        self.assertEqual(contents("a.ppm"), whole)
        for closed in ([0], [2], [0, 2], [0, 1, 2]):
            os.remove("a.ppm")
            self.run_program(*words, preexec_fn=lambda streams=closed: [*map(os.close, streams)])
            self.assertEqual(contents("a.ppm"), whole, closed)

    def test_an_interrupt_leaves_what_was_there(self):
        self.put("old.ppm", "old")
        self.before.add("old.ppm")
        with subprocess.Popen([PROGRAM, "render", "scene.rt", "-o", "old.ppm", "--size",
                               "20000x20000"], stderr=subprocess.DEVNULL) as running:
            time.sleep(0.3)
            running.terminate()
            self.assertEqual(running.wait(), -signal.SIGTERM)
        self.assertEqual(contents("old.ppm"), b"old")
        self.assertEqual(set(os.listdir(".")), self.before)


class Bench(InFolder):
    TIERS = ("float32", "textbook", "stable", "certain", "exact")

    def rows(self, *words):
        """(shape, regime, tier) of each row, after a head that ends with an empty line."""
        head, table = self.succeed("bench", *QUICK, *words).split("\n\n")
        self.assertIn("20 cases", head)
        rows = []
        for line in table.splitlines()[1:]:
            number = r"[\d.]+"
            row = re.fullmatch(rf"(\w+) +(\w+) +(\w+) +{number}(?: +{number} +{number}\.\.{number})"
                               r"{2} +\d+ %", line)
            self.assertIsNotNone(row, line)
            rows.append(row.groups())
        return rows

    def test_everything(self):
        self.assertEqual(self.rows(), [
            (shape, regime, tier) for shape in SHAPES
            for regime in ("typical", "grazing", "tangent") for tier in ("naive", *self.TIERS)])

    def test_a_choice(self):
        self.assertEqual(self.rows("--shape=cone", "--regime", "apex", "--tier", "exact"),
                         [("cone", "apex", "naive"), ("cone", "apex", "exact")])
        solid = {shape for shape, _, _ in self.rows("--regime", "inside")}
        self.assertEqual(solid & {"plane", "disc", "sphere", "cone"}, {"sphere", "cone"})

    def test_json(self):
        self.rows("--shape", "disc", "--json", "a.json")
        found = json.loads(contents("a.json"))
        for key in ("cpu", "compiler", "flags"):
            self.assertTrue(found[key])
        self.assertIn("-ffp-contract=off", found["flags"])
        self.assertEqual(found["threads"], 1)
        self.assertEqual([(row["regime"], row["tier"]) for row in found["results"]],
                         [(regime, tier) for regime in ("typical", "grazing", "tangent")
                          for tier in ("naive", *self.TIERS)])
        for row in found["results"]:
            self.assertEqual((row["shape"], row["cases"], row["repeats"]), ("disc", 20, 3))
            self.assertLessEqual(row["hits"], 20)
            self.assertTrue(0 < row["quiet"] <= 1, row["quiet"])
            for figure in ("nanoseconds", "over_naive", "over_textbook"):
                figure = row[figure]
                self.assertLess(0, figure["lower_quartile"])
                self.assertLessEqual(figure["lower_quartile"], figure["median"])
                self.assertLessEqual(figure["median"], figure["upper_quartile"])

    def test_json_that_cannot_be_written(self):
        self.fail_with(OUTPUT_FAILED, r"missing/a\.json: error: .*", "bench", *QUICK, "--json",
                       "missing/a.json")
        self.put("old.json", "old")
        result = self.run_program("bench", *QUICK, "--json", "old.json",
                                  preexec_fn=limit_file_size)
        self.assertEqual(result.returncode, OUTPUT_FAILED)
        self.assertRegex(result.stderr, r"\Aold\.json: error: .*\n\Z")
        self.assertEqual(contents("old.json"), b"old")


class Shrink(InFolder):
    """Cases that are answered wrongly, made simple."""

    # t is 3/11, a little beyond t_max, which float32 does not see.
    BEYOND = "plane 0.3 0.7 0.1 0.01 0.02 3.3 0 0.27272727272727 7.1 5.2 1 0 0 1\n"
    PLAIN = "sphere 0 0 0 0 0 -1 0 inf 0 0 -5 1\n"
    INVALID = "plane 0 0 0 0 0 0 0 inf 0 0 0 0 0 1\n"

    def shrink(self, text, *words):
        with open("lines", "wb") as file:
            file.write(text.encode("latin-1"))
        self.before.add("lines")
        with open("lines", "rb") as lines:
            return subprocess.run([PROGRAM, "shrink", *words], stdin=lines, text=True, check=False,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def test_what_fails_is_printed_simpler_and_fails_still(self):
        for against in ("decision", "answer"):
            words = ("--tier", "float32", "--against", against)
            result = self.shrink(self.PLAIN + self.BEYOND, *words)
            self.assertEqual((result.returncode, result.stderr),
                             (0, "surehit shrink: line 1: does not fail\n"))
            self.assertRegex(result.stdout, r"\Aplane( -?0x[01](\.[0-9a-f]+)?p[+-]\d+){14}\n\Z")
            self.assertGreater(result.stdout.count(" 0x0p+0"), 5)
            again = self.shrink(result.stdout, *words)
            self.assertEqual((again.returncode, again.stdout, again.stderr), (0, result.stdout, ""))

    def test_what_does_not_fail_is_told(self):
        for words in (["--tier", "textbook"], ["--tier=certain", "--against", "promise"],
                      ["--tier", "stable", "--against=answer"]):
            result = self.shrink(self.PLAIN + self.INVALID, *words)
            self.assertEqual((result.returncode, result.stdout), (0, ""), words)
            self.assertEqual(result.stderr, "surehit shrink: line 1: does not fail\n"
                                            "surehit shrink: line 2: does not fail\n", words)

    def test_lines_that_are_no_cases(self):
        bad = ("nonsense\n", "\n", self.PLAIN.replace(" 1\n", "\n"), self.PLAIN[:-1] + "\0\n",
               self.PLAIN[:-1] + "0" * 5000 + "x\n")
        for line in bad:
            result = self.shrink(self.PLAIN + line + self.PLAIN, "--tier", "textbook")
            self.assertEqual((result.returncode, result.stdout), (WRONG_USAGE, ""), line)
            self.assertEqual(result.stderr, "surehit shrink: line 1: does not fail\n"
                                            "surehit shrink: error: line 2: no case\n"
                                            "surehit shrink: line 3: does not fail\n", line)

    def test_a_file_and_standard_input(self):
        self.put("a.cases", self.BEYOND)
        self.before.add("a.cases")
        by_input = self.shrink(self.BEYOND, "--tier", "float32", "--against", "answer").stdout
        self.assertEqual(by_input.count("\n"), 1)
        self.assertEqual(self.succeed("shrink", "--tier", "float32", "--against", "answer",
                                      "a.cases"), by_input)
        self.assertEqual(self.shrink(self.BEYOND, "--tier", "float32", "--against", "answer",
                                     "-").stdout, by_input)
        self.fail_with(WRONG_USAGE, r"surehit shrink: error: missing: No such file.*", "shrink",
                       "--tier", "float32", "missing")

    def test_words_that_are_wrong(self):
        for words, complaint in (
                ([], "missing '--tier'"), (["--tier", "exact"], "--tier 'exact': expected float32"),
                (["--tier", "stable", "--against", "promise"], "--against 'promise': expected"),
                (["--tier", "stable", "--against", "all"], "--against 'all': expected decision"),
                (["--tier", "stable", "a", "b"], "one word too many: 'b'"),
                (["--sort"], "unknown option '--sort'")):
            self.fail_with(WRONG_USAGE, f"surehit shrink: error: {re.escape(complaint)}.*"
                                        "; see 'surehit shrink --help'", "shrink", *words)

    def test_help(self):
        text = self.succeed("shrink", "--help")
        self.assertTrue(text.startswith("Usage: surehit shrink "))
        self.assertLessEqual(max(map(len, text.split("\n"))), 80)
        for word in ("--tier", "--against", "decision", "answer", "promise", "Exit status"):
            self.assertIn(word, text)
        self.assertIn("shrink", self.succeed("--help"))

    def test_lost_output_is_reported(self):
        self.put("a.cases", self.BEYOND)
        self.before.add("a.cases")
        with open("/dev/full", "w", encoding="ascii") as full:
            self.fail_with(OUTPUT_FAILED,
                           "surehit shrink: error: standard output cannot be written.*",
                           "shrink", "--tier", "float32", "--against", "answer", "a.cases",
                           stdout=full)


class Progress(InFolder):
    """The bar on a terminal, and its absence anywhere else."""

    def render_at_terminal(self, size, *words):
        """What the terminal got, and when: from the start to the first byte and to the end."""
        master, slave = pty.openpty()
        start = time.monotonic()
        running = subprocess.Popen([PROGRAM, "render", "scene.rt", "-o", "a.ppm", "--threads", "1",
                                    "--size", size, *words],
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=slave)
        os.close(slave)
        shown, first = b"", None
        while True:
            try:
                part = os.read(master, 4096)
            except OSError: # the terminal's other side is closed
                part = b""
            if not part:
                break
            first = first or time.monotonic() - start
            shown += part
        self.assertEqual(running.wait(), 0)
        os.close(master)
        return shown.decode("ascii"), first, time.monotonic() - start

    def slow_render(self):
        """As above, of a picture that takes two seconds at least; and its size."""
        self.put("scene.rt", SCENE + "sp 0,9,0 1 9,9,9\n" * 200)
        side, elapsed = 128, 0
        while elapsed < 2:
            size = f"{side}x{side}"
            shown, first, elapsed = self.render_at_terminal(size)
            side = math.ceil(side * max(1.2, (2.4 / elapsed) ** 0.5))
        return shown, first, elapsed, size

    def test_short_work_shows_no_bar(self):
        shown, _, elapsed = self.render_at_terminal("4x4")
        self.assertTrue(shown == "" or elapsed > 1, repr(shown))

    def test_long_work_shows_it_and_erases_it(self):
        shown, first, elapsed, size = self.slow_render()
        bars = re.fullmatch(r"((?:\r\[#* *\] +\d+ %, +\d+:\d\d left)+)\r +\r", shown)
        self.assertIsNotNone(bars, repr(shown))
        bars = bars[1].split("\r")[1:]
        self.assertGreaterEqual(first, 1)
        self.assertLessEqual(len(bars), 10 * (elapsed - 1) + 1)
        self.assertEqual(len({len(bar) for bar in bars}), 1)
        self.assertLess(len(bars[0]), 80)
        shares = [int(re.search(r"(\d+) %", bar)[1]) for bar in bars]
        self.assertEqual(shares, sorted(shares))
        self.assertLessEqual(shares[-1], 100)
        self.assertGreater(len(re.search(r" +\r\Z", shown)[0]), len(bars[0]))
        self.assertEqual(self.render_at_terminal(size, "--quiet")[0], "")
        self.succeed("render", "scene.rt", "-o", "a.ppm", "--threads", "1", "--size", size)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
