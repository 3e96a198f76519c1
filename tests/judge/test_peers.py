# SPDX-License-Identifier: MIT
"""The peers that are judged: test_peers.py SUREHIT LIBRARY...

Each is right where nothing is hard, keeps the contract as far as its model does, and is wrong where
what it stands for is."""

import math
import os
import re
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import commands  # noqa: E402
from commands import ROOT, contents, loaded, put  # noqa: E402
from pages import SPDX  # noqa: E402

PEERS = {re.fullmatch(r"libpeer-(\w+)\.\w+", os.path.basename(path))[1]: os.path.abspath(path)
         for path in sys.argv[2:]}

# The shapes that each answers.
ANSWERS = {
    "embree": ["disc", "sphere", "cylinder", "cone"],
    "epsilon": ["plane", "disc", "sphere", "cylinder", "cone"],
    "gems_cylinder": ["cylinder"],
    "interval": ["disc", "sphere", "cylinder", "cone"],
    "kahan": ["sphere", "cylinder", "cone"],
    "perpendicular_double": ["sphere"],
    "perpendicular_float": ["sphere"],
    "textbook_float": ["plane", "disc", "sphere", "cylinder", "cone", "box"],
}

EASY = {}  # by shape
with open(ROOT + "/tests/judge/easy.cases", encoding="ascii") as easy:
    for case in easy:
        if case[0] != "#":
            EASY[case.split()[0]] = EASY.get(case.split()[0], "") + case

# All are exact there but three: the middle of an interval, a frame that is scaled by 1 / r, and
# Embree, whose reciprocals are the processor's estimate, which makers have their own, and a step.
ULPS = {"interval": 4, "epsilon": 2, "embree": 4}

# What no peer may do, whatever the case; "valid refused" is Embree's alone.
BROKEN = ["not a number", "t out of range", "wrong field", "outputs touched", "answer changes",
          "leak", "garbage", "crash", "no answer in time", "no answer"]
COUNT = "300"


def is_human(shape, line):
    """Are all lengths in 1/8..8, and is the start near?"""
    numbers = [float.fromhex(number) for number in line.split()[1:]]
    o, d, place = numbers[:3], numbers[3:6], numbers[8:11]
    lengths = [math.hypot(*d), math.dist(o, place)]
    if shape == "box":
        lengths += [high - low for low, high in zip(place, numbers[11:])]
    elif shape != "plane":
        lengths.append(numbers[-1])
    if shape in ("cylinder", "cone"):
        lengths.append(math.dist(place, numbers[11:14]))
    return all(1 / 8 < length < 8 for length in lengths) and math.hypot(*place) < 64


class InFolder(commands.InFolder):
    def judge(self, peer, *words, status=0):
        """The rows by shape and regime."""
        self.ask(status, "judge", "--candidate", PEERS[peer], *words, "--json", "verdict.json")
        return {(row["shape"], row["regime"]): row for row in loaded("verdict.json")["rows"]}

    def row_of(self, peer, text, *words):
        """Of these cases."""
        put("given", text)
        (row,) = self.judge(peer, "--cases", "given", *words).values()
        return row

    def row(self, peer, shape, regime):
        return self.judge(peer, "--shape", shape, "--regime", regime, "--count",
                          COUNT)[shape, regime]

    def faults(self, row):
        return {name for name, count in row["faults"].items() if count}

    def check_hit(self, peer, line, *faults):
        """A case that is a hit."""
        row = self.row_of(peer, line + "\n")
        self.assertEqual((row["valid"], row["hits"]), (1, 1), line)
        self.assertEqual(self.faults(row), {*faults}, line)


class Every(InFolder):
    def test_all_are_here(self):
        self.assertLessEqual(set(PEERS), set(ANSWERS))
        self.assertLessEqual(set(ANSWERS) - set(PEERS), {"embree"})  # need not be installed

    def test_right_where_nothing_is_hard(self):
        for peer in PEERS:
            for shape in ANSWERS[peer]:
                promises = f"decisions,contract,t<={ULPS.get(peer, 0)}ulp"
                row = self.row_of(peer, EASY[shape], "--require", promises)
                self.assertTrue(0 < row["hits"] < row["valid"], (peer, shape))

    def test_right_at_a_human_scale(self):
        """Turned and moved anyhow, but nothing much larger or smaller than anything else."""
        for shape in EASY:
            made = self.succeed("cases", "--shape", shape, "--regime", "typical", "--count",
                                "30000").splitlines(keepends=True)
            human = "".join(line for line in made if is_human(shape, line))
            for peer in PEERS:
                if shape in ANSWERS[peer]:
                    row = self.row_of(peer, human)
                    self.assertTrue(50 < row["valid"] and 20 < row["hits"] < row["valid"] - 20)
                    self.assertEqual(row["wrong"], 0, (peer, shape))

    def test_contract_in_every_regime(self):
        for peer in PEERS:
            rows = self.judge(peer, "--count", "60")
            self.assertEqual({shape for shape, _ in rows}, set(ANSWERS[peer]))
            broken = BROKEN + (["valid refused"] if peer != "embree" else [])
            for where, row in rows.items():
                self.assertEqual(row["unasked"], 0, (peer, where))
                for fault in broken:
                    self.assertEqual(row["faults"][fault], 0, (peer, where, fault))

    def test_each_says_what_it_stands_for(self):
        sources = {name: "perpendicular" if name.startswith("perpendicular") else name
                   for name in ANSWERS}
        for source in sources.values():
            text = contents(f"{ROOT}/reference/peers/{source}.c").decode()
            head = text.removeprefix(SPDX).split("*/")[0]
            self.assertRegex(head, r"\A/\* Stands for ")
            self.assertRegex(head, r"\b(19|20)\d\d\b")
            self.assertRegex(head, r"https://|Press|Kaufmann")


class WhatItStandsFor(InFolder):
    def test_single_precision_wants_the_perpendicular(self):
        self.assertGreater(self.row("textbook_float", "sphere", "typical")["wrong"], 0)
        self.assertEqual(self.row("perpendicular_float", "sphere", "typical")["wrong"], 0)

    def test_coefficients_are_rounded_before_the_discriminant(self):
        """From afar: no care in solving brings back what o - C has lost in c."""
        self.assertGreater(self.row("kahan", "sphere", "far")["wrong"], 0)
        self.assertEqual(self.row("perpendicular_double", "sphere", "far")["wrong"], 0)
        self.assertGreater(self.row("kahan", "cylinder", "far")["wrong"], 0)
        self.assertEqual(self.row("gems_cylinder", "cylinder", "far")["wrong"], 0)

    def test_exact_coefficients_are_solved(self):
        self.assertEqual(self.row("kahan", "sphere", "integers")["wrong"], 0)

    def test_products_keep_their_errors(self):
        """Coefficients in whole numbers below 2^53, products that are not: an impact parameter of
        168/169 or 170/169 from 2^25 away. d = (119, 120) has length 169."""
        lines = []
        for steps in range(2 ** 18, 2 ** 18 + 10):
            for impact in (168, 170):
                # x 120 - y 119 = impact, and steps further back
                x, y = impact - 119 * steps, impact - 120 * steps
                lines.append(f"sphere {x} {y} 0 119 120 0 0 inf 0 0 0 1\n")
        row = self.row_of("kahan", "".join(lines))
        self.assertEqual((row["valid"], row["hits"], row["wrong"]), (20, 10, 0))
        self.assertGreater(self.row_of("epsilon", "".join(lines))["wrong"], 0)

    def test_intervals_reject(self):
        for regime in ("grazing", "tangent", "neighbour", "on_surface"):
            row = self.row("interval", "sphere", regime)
            self.assertEqual(self.faults(row), {"false miss"}, regime)

    def test_epsilons_have_a_size(self):
        """The same sphere, from the same side, in metres and in micrometres."""
        self.check_hit("epsilon", "sphere 0 0 -3 0 0 1 0 inf 0 0 0 1")
        self.check_hit("epsilon", "sphere 0 0 -3e-6 0 0 1 0 inf 0 0 0 1e-6", "false miss")
        self.check_hit("epsilon", "cylinder -8 0 2 1 0 0 0 inf 0 0 0 0 0 4 1")
        self.check_hit("epsilon", "cylinder -8 0 2 1e-3 0 0 0 inf 0 0 0 0 0 4 1", "false miss")

    @unittest.skipIf("embree" not in PEERS, "Embree is not installed")
    def test_embree_has_a_largest_number(self):
        self.check_hit("embree", "sphere 0 0 -3e18 0 0 1 0 inf 0 0 0 1e17", "valid refused")
        self.check_hit("embree", "sphere 0 0 -1e18 0 0 1 0 inf 0 0 0 1e17")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
