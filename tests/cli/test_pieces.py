# SPDX-License-Identifier: MIT
"""A picture, its photons and a judgement in pieces: what is merged is what one process makes, byte
for byte, whatever becomes of the pieces on the way; and nothing else is merged.

    test_pieces.py SUREHIT CANDIDATE"""
import base64
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time
import unittest
from unittest import mock
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from commands import (InFolder, OUTPUT_FAILED, PROGRAM, SCENE, WRONG_USAGE,  # noqa: E402
                      contents, put)
from sealed import lines_of, sealed  # noqa: E402

CANDIDATE = os.path.abspath(sys.argv[2])
MISSING = 3
SMALL = ("render", "scene.rt", "--size", "170x190")  # 11 times 12 squares, cut at two edges
LONG = ("render", "scene.rt", "--size", "640x640", "--samples", "16")
SHINY = SCENE.replace("sp -2.5,0,0 2 255,60,60", "sp -2.5,0,0 2 255,60,60 refl:0.5")


def lists_in(value):
    """All lists of what JSON holds, however deep."""
    if isinstance(value, list):
        yield value
    for inner in value.values() if isinstance(value, dict) else value:
        if isinstance(inner, (dict, list)):
            yield from lists_in(inner)


class Pieces(InFolder):
    scene = SCENE

    def plan(self, pieces, *words, manifest="manifest"):
        self.succeed("plan", "--pieces", str(pieces), "-o", manifest, *words)

    def work(self, numbers, manifest="manifest", folder="pieces"):
        os.makedirs(folder, exist_ok=True)
        for number in numbers:
            self.succeed("work", manifest, str(number), folder)

    def work_all(self, pieces, *words):
        """In some order."""
        self.plan(pieces, *words)
        numbers = list(range(1, pieces + 1))
        random.Random(pieces).shuffle(numbers)
        self.work(numbers)

    def refuse_merge(self, pattern, *words, status=WRONG_USAGE, **more):
        self.fail_with(status, pattern, "merge", *words, "-o", "sum.ppm", **more)


NOT_KEPT = "-: error: is no file that can be read again"


class Inputs(Pieces):
    """What is hashed are the bytes that were read, and of what may be others each time there are no
    pieces."""

    def test_standard_input(self):
        """Also where a file has that name."""
        self.work_all(2, *SMALL)
        for name in ("manifest", "pieces/1.json", "pieces/2.json"):
            head, *rest = lines_of(name)
            put(name, sealed([{**head, "words": ["render", "-", *SMALL[2:]],
                               "inputs": {"-": head["inputs"]["scene.rt"]}}, *rest]))
        for there in (False, True):
            if there:
                put("-", SCENE)
            for words in (("plan", "--pieces", "2", "-o", "m", "render", "-"),
                          ("plan", "--pieces", "2", "-o", "m", "render", "-", "--integrator",
                           "forward"),
                          ("work", "manifest", "1", "."), ("merge", "pieces", "-o", "sum.ppm")):
                self.fail_with(WRONG_USAGE, NOT_KEPT, *words, input=SCENE)

    def test_pipes(self):
        os.mkfifo("pipe.rt")
        with subprocess.Popen(["cp", "scene.rt", "pipe.rt"], stderr=subprocess.DEVNULL) as writer:
            self.fail_with(WRONG_USAGE, NOT_KEPT.replace("-", "pipe.rt", 1), "plan", "--pieces",
                           "2", "-o", "m", "render", "pipe.rt")
            writer.kill()

    def test_a_scene_that_is_replaced(self):
        for words in (SMALL, (*SMALL, "--integrator", "forward", "--photons", "100")):
            put("scene.rt", SCENE)
            self.ask_while(0, "scene.rt", SHINY, "plan", "--pieces", "2", "-o", "manifest", *words)
            other = ("manifest: error: .* another inputs", "work", "manifest", "1", "pieces")
            self.fail_with(WRONG_USAGE, *other)
            put("scene.rt", SCENE)
            self.work([1])
            put("scene.rt", SHINY)
            said = self.ask_while(WRONG_USAGE, "scene.rt", SCENE, "work", "manifest", "2", "pieces")
            self.assertRegex(said, r"\Amanifest: error: .* another inputs\n\Z")
            self.work([2])
            self.ask_while(0, "scene.rt", SHINY, "merge", "pieces", "-o", "sum.ppm")
            self.refuse_merge("pieces/1.json: error: it has another inputs than here", "pieces")
            for number in (1, 2):
                os.unlink(f"pieces/{number}.json")


class Pictures(Pieces):
    def test_128_pieces_in_any_order(self):
        outputs = ("-o", "sum.png", "--certificate", "sum.cert")
        self.succeed(*SMALL, "-o", "one.ppm", "-o", "one.png", "--certificate", "one.cert")
        self.work_all(128, *SMALL, *outputs)
        self.succeed("merge", "pieces", "-o", "sum.ppm")
        for ending in ("ppm", "png", "cert"):
            self.assertEqual(contents(f"sum.{ending}"), contents(f"one.{ending}"), ending)
        names = [f"pieces/{number}.json" for number in range(1, 129)]
        random.Random(1).shuffle(names)
        self.succeed("merge", *names, "-o", "again.ppm")
        self.assertEqual(contents("again.ppm"), contents("one.ppm"))
        self.assertEqual(self.ask(0, "status", "manifest", "pieces").stdout, "")

    def test_parts_light_and_heat(self):
        put("scene.rt", SHINY)
        for words in ("--tile 20,30,100x70 --samples 4", "--heat stage", "--threads 2",
                      "--integrator mixed --falloff inverse-square --photons 20000 --seed 3"):
            with self.subTest(words):
                self.succeed(*SMALL, *words.split(), "-o", "one.ppm")
                self.work_all(5, *SMALL, *words.split())
                self.succeed("merge", "pieces", "-o", "sum.ppm")
                self.assertEqual(contents("sum.ppm"), contents("one.ppm"))
                for name in os.listdir("pieces"):
                    os.unlink(os.path.join("pieces", name))

    def test_what_is_missing(self):
        self.plan(20, *SMALL)
        self.assertEqual(self.ask(MISSING, "status", "manifest", "pieces").stdout, "1-20\n")
        self.work([n for n in range(1, 21) if n not in (1, 5, 6, 20)])
        self.assertEqual(self.ask(MISSING, "status", "manifest", "pieces").stdout, "1,5-6,20\n")
        self.refuse_merge(r"pieces/10.json: error: squares 0 to 6 of 132 are missing", "pieces")
        self.work([1])
        self.refuse_merge(r"pieces/1.json: error: squares 28 to 41 of 132 are missing", "pieces")
        self.assertFalse(os.path.exists("sum.ppm"))

    def test_twice_is_once(self):
        self.plan(2, *SMALL)
        self.work([1])
        made = os.stat("pieces/1.json").st_mtime_ns
        self.work([1])
        self.assertEqual(os.stat("pieces/1.json").st_mtime_ns, made)

    def test_what_does_not_belong_together(self):
        self.work_all(2, *SMALL)
        put("again.json", contents("pieces/1.json"))
        self.refuse_merge("again.json: error: squares 0 to 65 are in pieces/1.json, too",
                          "pieces", "again.json")
        self.plan(2, *SMALL, "--tier", "exact", manifest="other")
        self.work([2], manifest="other", folder="of_other")
        self.refuse_merge("of_other/2.json: error: it has another words than pieces/1.json",
                          "pieces/1.json", "of_other/2.json")
        said = self.ask(WRONG_USAGE, "status", "other", "pieces")
        self.assertEqual(said.stdout, "1-2\n")
        self.assertIn("pieces/2.json: error: it has another words than other\n", said.stderr)
        self.assertIn("\n0 of 2 pieces are done, 0.00 % of all\n", said.stderr)
        first, *rest = lines_of("pieces/1.json")
        for key, value in (("sources", "0" * 16), ("compiler", "cc 1"), ("flags", "-Ofast"),
                           ("architecture", "pdp11")):
            put("1.json", sealed([{**first, key: value}, *rest]))
            self.refuse_merge(f"1.json: error: it has another {key} than here", "1.json")
            put("older", sealed([{**lines_of("manifest")[0], key: value},
                                 *lines_of("manifest")[1:]]))
            self.fail_with(WRONG_USAGE, "older: error: is for other work than this program's: "
                           f"it has another {key}", "work", "older", "1", "of_other")
        put("scene.rt", SCENE + "# other bytes\n")
        self.refuse_merge("pieces/1.json: error: it has another inputs than here", "pieces")
        self.fail_with(WRONG_USAGE, "manifest: error: .* another inputs", "work", "manifest", "1",
                       "of_other")

    def test_nothing_is_lost(self):
        """Another plan's piece, another piece of this one, a scene; nor time, where the folder is
        missing."""
        self.plan(2, *SMALL)
        self.work([1])
        self.plan(2, *SMALL, "--tier", "exact", manifest="other")
        self.fail_with(WRONG_USAGE, "pieces/1.json: error: it has another words than other", "work",
                       "other", "1", "pieces")
        for ending in (".json", ".part"):
            put(f"pieces/2{ending}", contents("pieces/1.json"))
            self.fail_with(WRONG_USAGE, f"pieces/2{ending}: error: it is of another piece", "work",
                           "manifest", "2", "pieces")
            os.unlink(f"pieces/2{ending}")
        os.symlink("scene.rt", "link")
        for output in ("scene.rt", "link"):
            self.fail_with(WRONG_USAGE, f"{output}: error: a manifest may not take the place of a "
                           "file that is read", "plan", "--pieces", "2", "-o", output, *SMALL)
        self.fail_with(WRONG_USAGE, "surehit render: error: './own' may not take the place of .*",
                       "plan", "--pieces", "2", "-o", "own", *SMALL, "--certificate", "./own")
        self.fail_with(1, "missing/1.json: error: cannot write to its folder: .*", "work",
                       "manifest", "1", "missing")
        self.fail_with(WRONG_USAGE, "18446744073709551617: error: expected the number of a piece",
                       "work", "manifest", "18446744073709551617", "pieces")

    def test_no_piece_is_written_over(self):
        """By an output that the plan's words name."""
        os.mkdir("pieces")
        self.work_all(2, *SMALL, "--certificate", "pieces/1.json", "-o", "pieces/2.ppm")
        self.refuse_merge("surehit render: error: 'pieces/1.json' may not take the place of a file "
                          "that is read, .*", "pieces")
        os.rename("pieces/1.json", "first.json")
        os.rename("pieces/2.json", "pieces/2.ppm")
        self.refuse_merge("surehit render: error: 'pieces/2.ppm' may not .*", "first.json",
                          "pieces/2.ppm")
        put("judged.json", "")
        os.symlink("judged.json", "link")
        self.work_all(1, "judge", "--tier", "certain", "--count", "10", "--shape", "sphere",
                      "--regime", "typical", "--junit", "link")
        os.rename("pieces/1.json", "judged.json")
        self.fail_with(WRONG_USAGE, "surehit judge: error: 'link' may not take .*", "merge",
                       "judged.json")

    def test_nobody_is_waited_for(self):
        """A pipe in the folder of the pieces."""
        self.plan(2, *SMALL)
        self.work([1])
        os.mkfifo("pieces/2.json")
        wrong = "pieces/2.json: error: is no regular file"
        self.refuse_merge(wrong, "pieces", timeout=30)
        self.fail_with(WRONG_USAGE, wrong, "work", "manifest", "2", "pieces", timeout=30)
        said = self.ask(WRONG_USAGE, "status", "manifest", "pieces", timeout=30)
        self.assertEqual(said.stdout, "2\n")
        self.assertIn(wrong, said.stderr)

    def test_damage(self):
        self.plan(2, *SMALL)
        self.work([1, 2])
        whole = contents("pieces/1.json")
        for at in random.Random(1).sample(range(len(whole)), 20):
            put("bad.json", whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1:])
            self.refuse_merge(r"bad.json: error: .*", "bad.json", "pieces/2.json")
        head, ranges, told = lines_of("pieces/1.json")
        packed = base64.b64decode(told["rgb"])
        behind = base64.b64encode(packed + b"x").decode()
        short = base64.b64encode(zlib.compress(zlib.decompress(packed)[:-3])).decode()
        for bad in ([head, {"ranges": [[0, 65]]}, told], [head, {"ranges": [[0, 133]]}, told],
                    [head, {"ranges": []}, told], [head, ranges], [head, ranges, {}],
                    [head, {"ranges": [[0, 33], [33, 33]]}, told],
                    [head, ranges, {**told, "rgb": "====" + told["rgb"]}],
                    [head, ranges, told, told], [{}, ranges, told],
                    [head, ranges, {**told, "rgb": told["rgb"][:-4]}],
                    [head, ranges, {**told, "rgb": behind}],
                    [head, ranges, {**told, "rgb": short}],
                    [{**head, "more": 1}, ranges, told],
                    [{**head, "words": ["rm", "x"]}, ranges, told],
                    [{**head, "words": ["render", 1]}, ranges, told],
                    [{**head, "words": ["render", 1, "scene.rt"]}, ranges, told]):
            put("bad.json", sealed(bad))
            self.refuse_merge(r"(bad.json|surehit merge): error: .*", "bad.json", "pieces/2.json")
        put("bad.json", sealed([head, f'{{"ranges":[[0,66]],{json.dumps(ranges)[1:]}', told]))
        self.refuse_merge("bad.json: error: a name stands twice in one of its lines", "bad.json",
                          "pieces/2.json")
        put("bad.json", sealed([head, {"ranges": [[0, 2 ** 56 + 1]]}, told]))
        self.refuse_merge("bad.json: error: expected ranges, .*", "bad.json", "pieces/2.json")
        head, piece, *rest = lines_of("manifest")
        put("bad", sealed([head, {**piece, "ranges": [[131, 2]]}, *rest]))
        self.fail_with(WRONG_USAGE, "bad: error: piece 1: there are no such squares", "work", "bad",
                       "1", ".")
        put("pieces/1.json", whole[:-9])
        self.assertEqual(self.ask(MISSING, "status", "manifest", "pieces").stdout, "1\n")
        self.ask(0, "work", "manifest", "1", "pieces")
        self.assertEqual(contents("pieces/1.json"), whole)

    def test_claims_and_counts_of_other_squares(self):
        self.work_all(1, *SMALL, "--certificate", "sum.cert")
        head, ranges, told = lines_of("pieces/1.json")
        for key in ("claims", "counts"):
            for bad in (told[key][:-1], told[key] + told[key][:1]):
                put("bad.json", sealed([head, ranges, {**told, key: bad}]))
                self.refuse_merge("bad.json: error: expected .*", "bad.json")
        self.succeed("merge", "pieces", "-o", "sum.ppm")

    def test_wrong_words(self):
        for complaint, words in (("missing '-o MANIFEST'", ("--pieces", "2", *SMALL)),
                                 ("missing '--pieces N'", ("-o", "m", *SMALL)),
                                 ("missing 'COMMAND'", ("--pieces", "2", "-o", "m")),
                                 ("nothing that is worked off in pieces: 'vectors'",
                                  ("--pieces", "2", "-o", "m", "vectors"))):
            self.refuse(complaint, "plan", *words)
        self.fail_with(WRONG_USAGE, ".*.so' is no UTF-8, as the words of a manifest are.*", "plan",
                       "--pieces", "2", "-o", "m", "judge", "--candidate",
                       b"\xe9.so".decode(errors="surrogateescape"), errors="replace")
        for option in ("--time", "--heat time"):
            self.fail_with(WRONG_USAGE, f"surehit render: error: {option} does not go with "
                           "pieces; .*", "plan", "--pieces", "2", "-o", "m", *SMALL,
                           *option.split())
        self.fail_with(WRONG_USAGE, "surehit render: error: --continue does not go with pieces; .*",
                       "plan", "--pieces", "2", "-o", "m", *SMALL, "--integrator", "forward",
                       "--continue", "a.share")
        self.fail_with(WRONG_USAGE, "m: error: there are no more than 132 squares", "plan",
                       "--pieces", "133", "-o", "m", *SMALL)
        self.plan(2, *SMALL)
        os.mkdir("pieces")
        for number in ("0", "3", "x", "1x"):
            self.fail_with(WRONG_USAGE, f".*{number}.*: error: .*piece.*" if number != "3" else
                           "manifest: error: piece 3: has no such piece", "work", "manifest",
                           number, "pieces")
        self.refuse_merge("pieces: error: there are no results", "pieces")


class Ends(Pieces):
    """Of pieces, before they are done."""

    def test_what_is_whole_but_no_result(self):
        """It ended between the last square and the result."""
        self.plan(1, *SMALL)
        self.work([1])
        whole = contents("pieces/1.json")
        os.rename("pieces/1.json", "pieces/1.part")
        self.assertEqual(self.ask(MISSING, "status", "manifest", "pieces").stdout, "1\n")
        self.work([1])
        self.assertEqual(contents("pieces/1.json"), whole)

    def begin(self, *words):
        os.makedirs("cut", exist_ok=True)
        return subprocess.Popen([PROGRAM, "work", "manifest", "1", "cut", *words],
                                stderr=subprocess.PIPE, text=True)

    def test_a_killed_piece_goes_on(self):
        """Killed again and again, wherever it is: nothing, or a whole file."""
        for words in (LONG, (*LONG[:2], "--size", "32x18", "--integrator", "forward",
                             "--photons", "3000000")):
            self.plan(2, *words)
            self.work([1, 2], folder="left")
            kept, kills = set(), 0
            for pause in range(200):
                with self.begin("--keep", "0.01") as running:
                    time.sleep(0.05 + 0.02 * pause)
                    running.kill()
                kills += running.returncode == -signal.SIGKILL
                if os.path.exists("cut/1.json"):
                    self.assertEqual(contents("cut/1.json"), contents("left/1.json"))
                if os.path.exists("cut/1.part"):
                    kept.add(contents("cut/1.part"))
                if len(kept) > 2 or running.returncode == 0:
                    break
            self.assertGreater(kills, 0)
            self.assertGreater(len(kept), 1)
            self.work([1], folder="cut")
            self.assertEqual(contents("cut/1.json"), contents("left/1.json"))
            self.assertEqual([name for name in os.listdir("cut") if name[0] != "."], ["1.json"])
            os.unlink("cut/1.json")
            for number in (1, 2):
                os.unlink(f"left/{number}.json")

    def test_the_limit_is_of_the_processor(self):
        self.plan(1, *LONG[:3], "1280x1280", "--samples", "64")
        for _ in range(2):
            self.fail_late("cut/1.part: error: no processor time is left\n", "--limit", "1",
                           "--keep", "1000")
        self.assertGreater(lines_of("cut/1.part")[1]["ranges"][0][1], 16)
        said = self.ask(MISSING, "status", "manifest", "cut").stderr
        self.assertRegex(said, r"\A0 of 1 pieces are done, (?!0\.00)\d+\.\d\d % of all\n\Z")

    def fail_late(self, said, *words):
        with self.begin(*words) as running:
            self.assertEqual(running.stderr.read(), said)
        self.assertEqual(running.returncode, OUTPUT_FAILED)


class Photons(Pieces):
    def test_shares_of_two_scenes(self):
        """Of one that is replaced while it is read; of standard input, and a file of that name."""
        words = ("-o", "a.ppm", "--size", "8x8", "--quiet", "--integrator", "forward", "--photons",
                 "9")
        more = (*words, "--first", "9", "--share", "more.share")
        self.ask_while(0, "scene.rt", SHINY, "render", "scene.rt", *words, "--share", "of_file")
        put("-", SCENE)
        self.succeed("render", "-", *words, "--share", "of_input", input=SHINY)
        self.succeed("render", "scene.rt", *more)
        self.succeed("merge", "of_input", "more.share", "-o", "of_input.ppm")
        self.refuse_merge("more.share: error: .* of_file: it has another scene", "of_file",
                          "more.share")
        self.ask(0, "render", "./-", *more)
        self.succeed("merge", "of_file", "more.share", "-o", "of_file.ppm")
        self.refuse_merge("more.share: error: .* of_input: it has another scene", "of_input",
                          "more.share")

    def test_shares_of_photons(self):
        words = ("render", "scene.rt", "--size", "64x36", "--integrator", "forward", "--photons",
                 "50000", "--first", "7", "--falloff", "inverse-square", "--seed", "2")
        self.succeed(*words, "-o", "one.ppm", "--share", "one.share")
        self.work_all(5, *words)
        said = self.succeed("merge", "pieces", "-o", "sum.ppm", "--share", "sum.share")
        self.assertIn("photons left", said)
        self.assertEqual(contents("sum.ppm"), contents("one.ppm"))
        self.assertEqual(contents("sum.share"), contents("one.share"))
        os.unlink("pieces/3.json")
        self.assertEqual(self.ask(MISSING, "status", "manifest", "pieces").stdout, "3\n")
        self.refuse_merge("pieces/1.json: error: photons 20000 to 29999 of 50000 are missing",
                          "pieces")
        head, ranges, told = lines_of("pieces/1.json")
        put("other.json", sealed([head, {"ranges": [[20000, 10000]]}, told]))
        self.refuse_merge("other.json: error: its share is of others", "pieces", "other.json")
        put("less.json", sealed([head, {"ranges": [[0, 9999]]}, told]))
        self.refuse_merge("less.json: error: its share is of others", "less.json")


class Judgements(Pieces):
    WORDS = ("judge", "--tier", "float32", "--count", "700", "--seed", "5", "--require",
             "decisions", "--regime", "typical", "--regime", "grazing", "--regime", "camera",
             "--regime", "tiny")

    def judge(self, *words):
        return self.ask(1, *words).stdout

    def test_ranges_of_cases(self):
        """Without margins the first wrong decision is told, whichever piece it is in."""
        for pieces, more in ((1, ()), (9, ()), (9, ("--margin", "none"))):
            words = (*self.WORDS, *more)
            alone = self.judge(*words, "--untimed", "--json", "one.json")
            self.work_all(pieces, *words)
            names = [f"pieces/{number}.json" for number in range(1, pieces + 1)]
            for order in (names, names[::-1]):
                self.assertEqual(self.judge("merge", *order, "-o", "sum.json"), alone)
                self.assertEqual(contents("sum.json"), contents("one.json"))
            for name in names:
                os.unlink(name)

    def test_examples_of_every_kind(self):
        """Of crashes, garbage, both ends of chords and walls: cases, answers and what is right are
        those of one process."""
        line = ("--count", "60", "--shape", "cylinder", "--regime", "typical", "--require",
                "decisions,contract,t<=2ulp", "--sarif", "it.sarif")
        for name, wrong in (("one.so", "exits"), ("program", "garbage"), ("others.so", "3 ulps"),
                            ("walls.so", "part")):
            path = os.path.join(os.path.dirname(CANDIDATE), name)
            words = ("judge", "--candidate" if name[-3:] == ".so" else "--command", path, *line)
            with mock.patch.dict(os.environ, {"SUREHIT_WRONG": wrong}):
                self.judge(*words, "--untimed")
                alone = contents("it.sarif")
                os.unlink("it.sarif")
                self.work_all(2, *words)
                self.judge("merge", "pieces")
            self.assertEqual(json.loads(contents("it.sarif")), json.loads(alone), (name, wrong))
            shutil.rmtree("pieces")

    def test_waiting_for_a_program_counts(self):
        self.plan(1, "judge", "--command", "sleep 1.1; sed 's/.*/miss/'", "--shape", "sphere",
                  "--regime", "typical", "--count", "10000")
        os.makedirs("pieces")
        said = self.ask(OUTPUT_FAILED, "work", "manifest", "1", "pieces", "--limit", "1").stderr
        self.assertEqual(said, "pieces/1.part: error: no processor time is left\n")

    def test_another_build_of_the_library(self):
        """Of that name: neither works it off what was planned of the one before, nor is it added to
        it."""
        words = ("judge", "--candidate", "./mine.so", "--count", "40", "--shape", "sphere")
        shutil.copy(CANDIDATE, "mine.so")
        self.work_all(2, *words)
        os.rename("pieces/2.json", "2.json")
        self.succeed("merge", "pieces/1.json", "2.json")
        with open("mine.so", "ab") as library:
            library.write(b"another")
        self.fail_with(WRONG_USAGE, "manifest: error: .* another inputs", "work", "manifest", "2",
                       "pieces")
        self.plan(2, *words, manifest="other")
        self.work([2], manifest="other", folder="of_other")
        self.refuse_merge("pieces/1.json: error: it has another inputs than here", "pieces/1.json",
                          "of_other/2.json")
        self.refuse_merge("2.json: error: it has another inputs than of_other/2.json",
                          "of_other/2.json", "2.json")

    def test_what_is_refused(self):
        self.work_all(3, *self.WORDS)
        put("again.json", contents("pieces/2.json"))
        self.refuse_merge(r"again.json: error: cases 234 to 466 are in pieces/2.json, too",
                          "pieces", "again.json")
        os.unlink("pieces/2.json")
        self.refuse_merge(r"pieces/1.json: error: cases 234 to 466 of 700 are missing", "pieces")
        head, ranges, told = lines_of("again.json")
        row = told["rows"][0]
        for rows in ([*told["rows"], row], told["rows"][1:], [{**row, "counts": [1]}],
                     [{**row, "most": []}, *told["rows"][1:]]):
            put("bad.json", sealed([head, ranges, {"rows": rows}]))
            self.refuse_merge("bad.json: error: .*", "pieces", "bad.json")
        example = next(found for found in lists_in(told) if len(found) > 9 and
                       isinstance(found[1], str))
        example[3] += 2 ** 32
        put("bad.json", sealed([head, ranges, told]))
        self.refuse_merge("bad.json: error: .*", "pieces", "bad.json")
        for words in ("--answers x", "--tier certain --cases x", "--tier certain --instructions"):
            self.fail_with(WRONG_USAGE, "surehit judge: error: .*no pieces.*", "plan", "--pieces",
                           "2", "-o", "m", "judge", *words.split())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
