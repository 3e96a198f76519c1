# SPDX-License-Identifier: MIT
"""Pieces of a campaign add up to what one process makes, byte for byte, whatever becomes of them on
the way; and nothing else is added to them.

    test_pieces.py CAMPAIGN"""
import collections
import csv
from fractions import Fraction
import itertools
import math
import os
import random
import re
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from commands import InFolder, PROGRAM, contents, put  # noqa: E402
from sealed import lines_of, sealed  # noqa: E402

BROKEN, WRONG_USAGE, MISSING = 1, 2, 3
SMALL = ("--cases", "2000", "--against", "exact")
FLOATS = ("--cases", "100000", "--against", "floats")


class Pieces(InFolder):
    def plan(self, manifest, *words):
        return self.succeed("plan", *words, "-o", manifest)

    def work(self, manifest, folder, numbers):
        os.makedirs(folder, exist_ok=True)
        for number in numbers:
            self.succeed("work", manifest, str(number), folder)

    def whole(self):
        """The record that one process makes."""
        self.plan("one", *SMALL, "--pieces", "1")
        self.work("one", "of_one", [1])
        self.succeed("merge", "of_one", "-o", "whole")
        return contents("whole")

    def complain(self, pattern, *words, status=WRONG_USAGE):
        self.fail_with(status, pattern, *words)


class Sums(Pieces):
    def test_any_pieces_in_any_order(self):
        whole = self.whole()
        self.assertEqual(contents("of_one/1.json"), whole)
        for pieces in (2, 3, 40):
            folder = f"of_{pieces}"
            self.plan("many", *SMALL, "--pieces", str(pieces))
            numbers = list(range(1, pieces + 1))
            self.work("many", folder, reversed(numbers))
            names = [f"{folder}/{number}.json" for number in numbers]
            orders = (list(itertools.permutations(names)) if pieces <= 3 else
                      [random.Random(pieces).sample(names, pieces)])
            for order in orders:
                self.succeed("merge", *order, "-o", "sum")
                self.assertEqual(contents("sum"), whole, order)
            self.succeed("merge", *names[1:], "-o", "rest")
            self.succeed("merge", "rest", names[0], "-o", "sum")
            self.assertEqual(contents("sum"), whole)

    def test_a_second_campaign_begins_where_the_first_ends(self):
        self.whole()
        self.plan("more", *SMALL, "--pieces", "2", "--after", "whole")
        self.work("more", "later", [1, 2])
        self.succeed("merge", "whole", "later", "-o", "both")
        pairs = [line for line in lines_of("both") if "ranges" in line]
        self.assertGreater(len(pairs), 50)
        for line in pairs:
            self.assertEqual([first for first, _ in line["ranges"]], [0])

    def test_after_a_gap(self):
        """It begins behind all that was done, and not in what is missing."""
        pair = ("--against", "exact", "--shape", "plane", "--regime", "typical")
        self.plan("gap", *pair, "--cases", "300", "--pieces", "3")
        self.work("gap", "of_gap", [1, 3])
        self.succeed("merge", "of_gap", "-o", "some")
        self.assertEqual(len(lines_of("some")[1]["ranges"]), 2)
        self.plan("more", *pair, "--cases", "9", "--pieces", "1", "--after", "some")
        self.assertEqual(lines_of("more")[1]["cases"][0]["ranges"], [[300, 9]])
        self.complain("no: error: more cases than there are", "plan", *pair, "--cases",
                      str(2 ** 56), "--after", "some", "-o", "no")

    def test_what_a_plan_says(self):
        """As many cases of each pair, but a sixth where they take long; and pieces that take no
        more than they should, by its own count."""
        self.plan("timed", *SMALL, "--seconds", "0.01")
        pieces, cases = lines_of("timed")[1:], collections.Counter()
        for pair in itertools.chain.from_iterable(piece["cases"] for piece in pieces):
            cases[pair["shape"], pair["regime"]] += sum(many for _, many in pair["ranges"])
        long = {("cone", "bits"), ("cone", "degenerate")}
        usual = cases["plane", "bits"]
        self.assertEqual({pair for pair, many in cases.items() if many != usual}, long)
        self.assertEqual({cases[pair] for pair in long}, {math.ceil(usual / 6)})
        seconds = sum(piece["seconds"] for piece in pieces)
        self.assertTrue((len(pieces) - 2) * 0.01 < seconds < (len(pieces) + 1) * 0.01, seconds)

    def test_twice_is_once(self):
        self.whole()
        made = os.stat("of_one/1.json").st_mtime_ns
        self.work("one", "of_one", [1])
        self.assertEqual(os.stat("of_one/1.json").st_mtime_ns, made)

    def test_what_is_missing(self):
        self.plan("many", *SMALL, "--pieces", "9")
        self.assertEqual(self.ask(MISSING, "status", "many", "nowhere").stdout, "1-9\n")
        self.work("many", "some", [2, 3, 7])
        self.assertEqual(self.ask(MISSING, "status", "many", "some").stdout, "1,4-6,8-9\n")
        self.work("many", "some", [1, 4, 5, 6, 8, 9])
        self.assertEqual(self.ask(0, "status", "many", "some").stdout, "")


class Floats(Pieces):
    def test_all_promises_hold(self):
        self.plan("floats", *FLOATS, "--pieces", "1", "--seed", "3")
        self.work("floats", "done", [1])
        said = self.succeed("merge", "done", "-o", "record")
        counts = [int(count) for count in re.findall(r"\d+", said)]
        self.assertGreaterEqual(counts[0], 100000)
        self.assertGreater(min(counts[1:5]), 5000)  # hits, misses, invalid, normals
        self.assertIn("; 0 broken promises\n", said)


class Ends(Pieces):
    """Of pieces, before they are done."""

    def begin(self, *words):
        os.makedirs("cut", exist_ok=True)
        return subprocess.Popen([PROGRAM, "work", "long", "1", "cut", *words],
                                stderr=subprocess.PIPE, text=True)

    def test_a_killed_piece_goes_on(self):
        """Killed again and again, wherever it is: the record is that of a piece left alone."""
        self.plan("long", "--cases", "60000", "--against", "exact", "--pieces", "1")
        self.work("long", "left", [1])
        kept, kills = set(), 0
        for pause in itertools.count(1):
            with self.begin("--keep", "0.002") as running:
                time.sleep(0.02 + 0.005 * pause)
                running.kill()
            kills += running.returncode == -signal.SIGKILL
            if os.path.exists("cut/1.part"):
                kept.add(contents("cut/1.part"))
            if len(kept) > 5 or running.returncode == 0:
                break
        self.assertGreater(kills, 0)
        self.assertGreater(len(kept), 1)
        self.work("long", "cut", [1])
        self.assertEqual(contents("cut/1.json"), contents("left/1.json"))
        self.assertEqual([name for name in os.listdir("cut") if name[0] != "."], ["1.json"])

    def test_what_is_whole_but_no_result(self):
        """It ended between the last case and the result."""
        whole = self.whole()
        os.rename("of_one/1.json", "of_one/1.part")
        self.assertEqual(self.ask(MISSING, "status", "one", "of_one").stdout, "1\n")
        self.work("one", "of_one", [1])
        self.assertEqual(contents("of_one/1.json"), whole)

    def test_an_end_names_its_case(self):
        self.plan("long", "--cases", "1e8", "--against", "exact", "--pieces", "1", "--shape",
                  "cone", "--regime", "rim")
        for number, what in (signal.SIGSEGV, "a crash"), (signal.SIGXCPU, "no end"):
            with self.begin("--keep", "0.002") as running:
                while not os.path.exists("cut/1.part"):
                    time.sleep(0.002)
                running.send_signal(number)
                said = running.stderr.read()
            self.assertRegex(said, rf"\Apiece 1: {what} in case \d+ of cone rim\n\Z")
            self.assertEqual(running.returncode, -number)
            os.unlink("cut/1.part")

    def test_the_limit_is_of_the_processor(self):
        self.plan("long", "--cases", "1e8", "--against", "exact", "--pieces", "1")
        done = []
        for _ in range(3):
            with self.begin("--limit", "1", "--keep", "1000") as running:
                said = running.stderr.read()
            self.assertEqual(running.returncode, BROKEN)
            self.assertEqual(said, "cut/1.part: error: no processor time is left\n")
            done.append(sum(line["counts"]["cases"] for line in lines_of("cut/1.part")
                            if "counts" in line))
        self.assertGreater(done[2], 2 * done[0])
        self.assertEqual(os.listdir("cut"), ["1.part"])
        said = self.ask(MISSING, "status", "long", "cut").stderr
        asked = sum(many for pair in lines_of("long")[1]["cases"] for _, many in pair["ranges"])
        self.assertEqual(said, "0 of 1 pieces are done, "
                         f"{100 * done[2] / asked:.2f} % of all\n")


class Refused(Pieces):
    def test_damage(self):
        """Each byte counts, and each line."""
        whole = self.whole()
        for at in random.Random(1).sample(range(len(whole)), 60):
            put("bad", whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1:])
            self.complain(r"bad: error: .*", "merge", "bad", "-o", "sum")
        for end in (0, 1, len(whole) // 2, len(whole) - 1):
            put("bad", whole[:end])
            self.complain(r"bad: error: is damaged.*", "merge", "bad", "-o", "sum")
        self.assertFalse(os.path.exists("sum"))

    def test_lines_that_were_sealed_anew(self):
        self.whole()
        lines = lines_of("whole")
        pair = lines[1]
        counts = pair["counts"]

        def with_pair(**change):
            return [lines[0], {**pair, **change}, *lines[2:]]

        renamed = {("cases" if name == "hits" else "hits" if name == "cases" else name): count
                   for name, count in counts.items()}
        first, much = pair["ranges"][0]
        for bad in (with_pair(counts=renamed), with_pair(counts={**counts, "more": 0}),
                    with_pair(ranges=[[first, much + 1]]), with_pair(regime="rim2"),
                    [lines[0], *lines], [lines[0], pair, *lines[1:]],
                    with_pair(counts={**counts, "broken": 1}), lines[1:]):
            put("bad", sealed(bad))
            self.complain(r"bad: error: .*", "merge", "bad", "-o", "sum")
        put("good", sealed(lines))
        self.succeed("merge", "good", "-o", "sum")

    def test_a_broken_promise_is_told_and_kept(self):
        self.whole()
        lines = lines_of("whole")
        pair = {**lines[1], "counts": {**lines[1]["counts"], "broken": 1}}
        broken = {"shape": pair["shape"], "regime": pair["regime"], "index": pair["ranges"][0][0],
                  "case": "a case", "promise": "t", "certain": "hit", "exact": "miss"}
        put("bad", sealed([lines[0], pair, *lines[2:], broken]))
        result = self.ask(BROKEN, "merge", "bad", "-o", "sum")
        self.assertTrue(result.stdout.startswith("a case\n  t\n  certain hit\n  exact   miss\n"))
        self.assertIn("; 1 broken promises\n", result.stdout)
        self.assertEqual(lines_of("sum")[-1], broken)
        put("bad", sealed([lines[0], pair, *lines[2:],
                           {**broken, "index": sum(pair["ranges"][0])}]))
        self.complain("bad: error: a broken promise is of a case that was not asked", "merge",
                      "bad", "-o", "sum")

    def test_broken_promises_stand_by_their_cases(self):
        """Whichever file they are in."""
        self.plan("three", "--cases", "9", "--against", "exact", "--shape", "plane", "--regime",
                  "typical", "--pieces", "3")
        self.work("three", "of_three", [1, 2, 3])
        names = [f"of_three/{number}.json" for number in (1, 2, 3)]
        for name in names:
            head, pair, *rest = lines_of(name)
            broken = {"shape": "plane", "regime": "typical", "index": pair["ranges"][0][0],
                      "case": name, "promise": "t", "certain": "hit", "exact": "miss"}
            pair["counts"]["broken"] = 1
            put(name, sealed([head, pair, *rest, broken]))
        for order in itertools.permutations(names):
            said = self.ask(BROKEN, "merge", *order, "-o", "sum").stdout
            self.assertEqual(re.findall("(?m)^of_three.*", said), names)
        put("again", contents(names[1]))
        (first, count), = lines_of("again")[1]["ranges"]  # a third, or one more: by measured times
        self.complain(f"again: error: cases {first} to {first + count - 1} of plane typical are in "
                      "of_three/2.json, too", "merge", *names, "again", "-o", "sum")

    def test_hits_alone_are_no_campaign(self):
        """Of enough cases, that is, a regime that misses its aim is told."""
        self.whole()
        lines = lines_of("whole")
        pair, none = lines[1], dict.fromkeys(lines[1]["counts"], 0)
        for many, kind, status in ((1000, "hits", BROKEN), (1000, "misses", BROKEN),
                                   (999, "hits", 0)):
            counts = {**none, "cases": many, kind: many}
            put("bad", sealed([lines[0], {**pair, "ranges": [[0, many]], "counts": counts}]))
            said = self.ask(status, "merge", "bad", "-o", "sum").stdout
            self.assertEqual("\nplane camera: hits or misses alone\n" in said, status == BROKEN)

    def test_what_does_not_belong_together(self):
        whole = self.whole()
        self.plan("other", *SMALL, "--seed", "9", "--pieces", "1")
        self.work("other", "of_other", [1])
        self.complain("of_other/1.json: error: can't be added to whole: it has another seed",
                      "merge", "whole", "of_other/1.json", "-o", "sum")
        put("again", whole)
        self.complain(r"again: error: cases 0 to \d+ of plane camera are in whole, too",
                      "merge", "whole", "again", "-o", "sum")
        head = lines_of("one")
        put("older", sealed([{**head[0], "sources": "0" * 16}, *head[1:]]))
        self.complain("older: error: is for another program than this one: it has another sources",
                      "work", "older", "1", "of_one")
        self.complain("one: error: piece 2: has no such piece", "work", "one", "2", "of_one")
        put("idle", sealed([head[0], {**head[1], "cases": []}]))
        self.complain("idle: error: piece 1: expected pieces with cases", "work", "idle", "1",
                      "of_idle")
        self.plan("two", *SMALL, "--pieces", "2")
        self.complain("no: error: the shape has no such regime", "plan", *SMALL, "--shape", "plane",
                      "--regime", "rim", "-o", "no")

    def test_what_others_found_is_not_lost(self):
        whole = self.whole()
        self.plan("two", *SMALL, "--pieces", "2")
        self.plan("other", *SMALL, "--seed", "9", "--pieces", "1")
        for ending in (".json", ".part"):
            os.makedirs("strange", exist_ok=True)
            put(f"strange/1{ending}", whole)
            said = self.ask(WRONG_USAGE, "status", "two", "strange")
            self.assertEqual(said.stdout, "1-2\n")
            told = f"strange/1{ending}: error: it has cases of another piece"
            self.assertIn(f"{told}\n", said.stderr)
            self.complain(told, "work", "two", "1", "strange")
            told = f"strange/1{ending}: error: it has another seed than other"
            self.complain(told, "work", "other", "1", "strange")
            self.assertEqual(os.listdir("strange"), [f"1{ending}"])
            self.assertEqual(contents(f"strange/1{ending}"), whole)
            os.unlink(f"strange/1{ending}")
        head, first, *_ = lines_of("of_one/1.json")
        os.makedirs("half", exist_ok=True)
        put("half/1.json", sealed([head, first]))
        said = self.ask(0, "work", "one", "1", "half").stderr
        self.assertEqual(said, "half: error: piece 1: its file has not all cases of it\n")
        self.assertEqual(contents("half/1.json"), whole)
        self.complain("of_one/1.json: error: may not take the place of a file that is read",
                      "merge", "of_one", "-o", "of_one/1.json")
        self.assertEqual(contents("of_one/1.json"), whole)


def binade(x):
    """floor(log2 |x|) of a fraction."""
    x = abs(x)
    guess = x.numerator.bit_length() - x.denominator.bit_length()
    return guess if x >= Fraction(2) ** guess else guess - 1


def numbers_of(case):
    return [Fraction(float.fromhex(word)) if word != "inf" else None for word in case.split()[1:]]


def dot(v, w):
    return sum(a * b for a, b in zip(v, w))


def bits_of_rounding(case):
    """Of a plane."""
    n = numbers_of(case)
    t = dot([p - o for p, o in zip(n[8:11], n[0:3])], n[11:14]) / dot(n[3:6], n[11:14])
    rounded = float(t)
    other = math.nextafter(rounded, math.inf if t > Fraction(rounded) else -math.inf)
    ulp = abs(Fraction(other) - Fraction(rounded))
    away, bits = abs(t - (Fraction(rounded) + Fraction(other)) / 2), 53
    while away < ulp / 2 ** (bits + 1 - 53):
        bits += 1
    return bits


def bits_below(terms, value):
    """By how many binades a sum is below the largest of its terms."""
    return max(binade(term) for term in terms if term != 0) - binade(value) if value != 0 else 0


def apart(v, w):
    return [a - b for a, b in zip(v, w)]


def bits_of_sphere(case):
    """r^2 d^2 against (d x m)^2, m from its centre."""
    n = numbers_of(case)
    d, m, r = n[3:6], apart(n[0:3], n[8:11]), n[11]
    terms = r * r * dot(d, d), dot(d, d) * dot(m, m) - dot(d, m) ** 2
    return bits_below(terms, terms[0] - terms[1])


def bits_of_plane(case):
    """N.(o - Q), and N.d"""
    n = numbers_of(case)
    return max(bits_below([a * b for a, b in zip(n[11:14], v)], dot(n[11:14], v))
               for v in (apart(n[0:3], n[8:11]), n[3:6]))


def bits_of_rim(ray, centre, normal, r):
    """r^2 e^2 against |e m - h d|^2"""
    d, m = ray[3:6], apart(ray[0:3], centre)
    e, h = dot(normal, d), dot(normal, m)
    foot = [e * a - h * b for a, b in zip(m, d)]
    terms = (r * e) ** 2, dot(foot, foot)
    return bits_below(terms, terms[0] - terms[1])


def bits_of_disc(case):
    n = numbers_of(case)
    return bits_of_rim(n, n[8:11], n[11:14], n[14])


def bits_of_base(case):
    n = numbers_of(case)
    return bits_of_rim(n, n[8:11], apart(n[11:14], n[8:11]), n[14])


def bits_of_caps(case):
    n = numbers_of(case)
    return max(bits_of_base(case),
               bits_of_rim(n, n[11:14], apart(n[11:14], n[8:11]), n[14]))


def bits_of_box(case):
    """The first face that is left against the last that is entered, over both divisors."""
    n = numbers_of(case)
    if any(n[3 + k] == 0 and not n[8 + k] <= n[k] <= n[11 + k] for k in range(3)):
        return 0  # beside it, whatever the order
    ways = [(sorted([n[8 + k] - n[k], n[11 + k] - n[k]], key=lambda x, d=n[3 + k]: x / d), n[3 + k])
            for k in range(3) if n[3 + k] != 0]
    enter, along = max(((ends[0], d) for ends, d in ways), key=lambda end: end[0] / end[1])
    leave, other = min(((ends[1], d) for ends, d in ways), key=lambda end: end[0] / end[1])
    terms = leave * along, enter * other
    return bits_below(terms, terms[0] - terms[1])


BITS = {("plane", "rounding"): bits_of_rounding, ("plane", "decision"): bits_of_plane,
        ("disc", "decision"): bits_of_disc, ("sphere", "decision"): bits_of_sphere,
        ("cylinder", "cap"): bits_of_caps, ("cone", "cap"): bits_of_base,
        ("box", "decision"): bits_of_box}


class Floats(Pieces):
    def test_a_tie_beside_a_power_of_two(self):
        """The normal in doubles is midway between 1 and the float below: either is next to it."""
        self.plan("bits", "--against", "floats", "--shape", "sphere", "--regime", "bits",
                  "--cases", "300000", "--seed", "14", "--pieces", "1")
        head, piece, *_ = lines_of("bits")
        piece["cases"][0]["ranges"] = [[218249, 1]]
        put("tie", sealed([head, piece]))
        self.work("tie", "of_tie", [1])
        said = self.succeed("merge", "of_tie", "-o", "sum")
        self.assertRegex(said, "^1 cases: 1 hit, .* 0 broken promises")


class Tables(Pieces):
    def test_each_count_of_the_record(self):
        self.whole()
        self.succeed("table", "whole", "-o", "table.csv")
        with open("table.csv", encoding="ascii") as file:
            self.assertEqual(next(file), "seed,1\n")
            rows = list(csv.DictReader(file))
        pairs = [line for line in lines_of("whole") if "ranges" in line]
        for row, pair in zip(rows, pairs, strict=True):
            self.assertEqual(row, {"shape": pair["shape"], "regime": pair["regime"],
                                   **{name: str(many) for name, many in pair["counts"].items()}})


class Worst(Pieces):
    def test_bits_by_fractions(self):
        self.whole()
        self.succeed("worst", "whole", "-o", "worst.csv")
        with open("worst.csv", encoding="ascii") as file:
            rows = list(csv.DictReader(file))
        counted = collections.Counter()
        for row in rows:
            self.assertLess(int(row["bits"]), int(row["bound"]))
            of = BITS.get((row["shape"], row["question"]))
            if of:
                self.assertEqual(of(row["case"]), int(row["bits"]), row["case"])
            counted[row["shape"], row["question"]] += 1
        self.assertEqual(set(counted.values()), {10})
        self.assertEqual(len(counted), 14)
        calls = [[line["shape"], line["question"], str(bits), regime, str(index)]
                 for line in lines_of("whole") if "worst" in line
                 for bits, regime, index in line["worst"]]
        names = ("shape", "question", "bits", "regime", "index")
        self.assertEqual([[row[name] for name in names] for row in rows], calls)

    def test_other_bits_are_refused(self):
        self.whole()
        lines = lines_of("whole")
        at = next(i for i, line in enumerate(lines) if "worst" in line)
        first, *rest = lines[at]["worst"]
        for worst in ([[first[0] + 1, *first[1:]], *rest],):
            put("bad", sealed([*lines[:at], {**lines[at], "worst": worst}, *lines[at + 1:]]))
            self.complain("bad: error: .* does not need .* bits", "worst", "bad", "-o", "w")
        for worst in ([*rest, first], [first, first, *rest], [[1, "bits", 10 ** 9]], [],
                      [first, *rest, [1, *first[1:]]], [[first[0], "nothing", 0]]):
            put("bad", sealed([*lines[:at], {**lines[at], "worst": worst}, *lines[at + 1:]]))
            self.complain("bad: error: .*", "merge", "bad", "-o", "sum")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
