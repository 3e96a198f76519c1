# SPDX-License-Identifier: MIT
"""`surehit walk` as its users meet it:

    test_walks.py SUREHIT CANDIDATES CC [REFERENCE]

CANDIDATES as test_judge.py has them; the last word says that surehit-reference is built."""

import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import commands  # noqa: E402
from commands import ROOT, TIERS, WRONG_USAGE, loaded, put  # noqa: E402

CANDIDATES = os.path.abspath(sys.argv[2])
CC = sys.argv[3].split()
HAS_REFERENCE = "reference" in sys.argv[4:]
BROKEN = 1
NUDGED = ["--nudge", "1e-9"]
NEVER = """
#include <surehit/candidate.h>
const int sure_candidate_version = SURE_CANDIDATE_VERSION;
const char sure_candidate_entry[] = ENTRY;
int sure_candidate_sphere(const double *ray, const double *sphere, sure_candidate_hit *hit)
{
    (void)ray, (void)sphere, (void)hit;
    return SURE_CANDIDATE_MISS;
}
"""


class Walks(commands.InFolder):
    def walk(self, subject, *words, status=0, wrong="right"):
        """The JSON."""
        self.ask(status, "walk", *subject, *words, "--json", "walks.json",
                 env={**os.environ, "SUREHIT_WRONG": wrong})
        return loaded("walks.json")

    def library(self, name):
        return ["--candidate", os.path.join(CANDIDATES, name)]

    def test_who_is_right_keeps_the_promise(self):
        for tier in ("certain", "exact"):
            found = self.walk(["--tier", tier], "--require", "--steps", "2000", "--seed", "5")
            self.assertEqual(set(found["all"]["faults"].values()), {0})
            self.assertEqual(sum(row["steps"] for row in found["rows"]), found["all"]["steps"])

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_by_the_reference(self):
        """All that is told of certain is so by CGAL, too."""
        found = self.walk(["--tier", "certain"], "--require", "--steps", "300", "--seed", "6",
                          "--truth", "reference")
        self.assertEqual(set(found["all"]["faults"].values()), {0})
        rows = [self.walk(["--tier", "textbook"], "--steps", "300", *words)["rows"]
                for words in ([], ["--truth", "reference"])]
        self.assertEqual(*rows)

    def test_a_nudge_does_not(self):
        found = self.walk(["--tier", "certain"], *NUDGED, "--require", "--kind", "grazing",
                          "--steps", "1000", status=BROKEN)
        for row in found["rows"]:
            self.assertGreater(row["faults"]["side"], 0)

    def test_a_library_walks_as_its_tier(self):
        found = [self.walk(subject, *NUDGED, "--steps", "300", "--shape", "cone")["rows"]
                 for subject in (["--tier", "exact"], self.library("one.so"))]
        self.assertEqual(*found)

    def test_what_a_library_does_wrong_is_found(self):
        for wrong, fault in (("false miss", "lost"), ("nan", "zero"), ("crashes", "lost"),
                             ("garbage", "lost"), ("refuses", "lost")):
            found = self.walk(self.library("one.so"), "--kind", "alone", "--shape", "sphere",
                              "--steps", "500", wrong=wrong)["all"]
            self.assertEqual({name for name, count in found["faults"].items() if count},
                             {fault}, wrong)

    def test_the_record_is_true(self):
        """A row of each of docs/walks.json that takes no long."""
        for run in loaded(os.path.join(ROOT, "docs/walks.json"))["runs"]:
            if run["nudge"] is None or run["routine"] not in TIERS:
                continue
            was = next(row for row in run["rows"] if " far " in row)
            (row,) = self.walk(["--tier", run["routine"]], "--nudge", repr(run["nudge"]),
                               "--seed", str(run["seed"]), "--steps", "100000", "--kind",
                               "far", "--shape", was.split()[0])["rows"]
            self.assertEqual([row["steps"], row["stopped"], *row["faults"].values()],
                             [int(count) for count in was.split()[2:]])

    def test_its_first_step_can_be_asked_again(self):
        found = self.walk(["--tier", "textbook"], "--kind", "grazing", "--steps", "2000",
                          "--shape", "sphere")["all"]["first"]
        line = found["ghost"]["asked"][found["ghost"]["met"]] + "\n"
        self.assertRegex(self.succeed("answer", "--tier", "textbook", input=line), "hit")

    def test_what_is_printed(self):
        """Faults of a million steps, and of a fault's first step the solid that is met."""
        said = self.succeed("walk", "--tier", "textbook", "--kind", "beside", "--kind", "grazing",
                            "--shape", "sphere", "--steps", "2000", "--json", "walks.json")
        found = loaded("walks.json")
        for row, named in zip((*found["rows"], found["all"]), ("sphere beside", "sphere grazing",
                                                               "all"), strict=True):
            counts = [str(row["steps"]), str(row["walks"]), *map(str, row["faults"].values())]
            share = 1e6 * sum(row["faults"].values()) / row["steps"]
            (line,) = (one for one in said.splitlines() if one.split()[:-11] == named.split())
            self.assertEqual(line.split()[-11:],
                             [*counts, "|", f"{share:.6g}", "|", str(row["stopped"])])
        for fault, step in found["all"]["first"].items():
            asked = [f"  {case}{' (met)' if i == step['met'] else ''}\n"
                     for i, case in enumerate(step["asked"])]
            start = f"  next start {step['start']}\n" if step["start"] else ""
            self.assertIn(f"\n{fault}\n{''.join(asked)}{start}", said)

    def test_one_fault_is_enough(self):
        """Where walks are short there are none, one, and more of them."""
        words = ("--kind", "nested", "--shape", "cone", "--steps", "300", "--seed")
        for seed in "1234":
            faults = self.walk(["--tier", "textbook"], *words, seed)["all"]["faults"]
            self.walk(["--tier", "textbook"], *words, seed, "--require",
                      status=BROKEN if any(faults.values()) else 0)

    def test_who_is_given_up_on(self):
        """Nobody is to blame for what is not asked any more."""
        found = self.walk(self.library("one.so"), "--kind", "alone", "--shape", "sphere", "--steps",
                          "500", wrong="always aborts")["all"]
        self.assertGreaterEqual(found["stopped"], 500)
        self.assertEqual(found["faults"]["lost"], found["steps"])
        self.assertLess(found["steps"], 50)

    def test_who_cannot_walk(self):
        for words, why in ((["--tier", "exact", "--shape", "plane"], "no kind of walk"),
                           (self.library("some.so") + ["--shape", "cone"], "no kind of walk"),
                           (self.library("missing.so"), ".*missing.so")):
            self.fail_with(WRONG_USAGE, f"surehit walk: error: {why}.*", "walk", *words)
        for word in "wall", "decision", "outside", "scale=1000..9000":
            put("never.c", NEVER)
            subprocess.run([*CC, "-shared", "-fPIC", f'-DENTRY="{word}"', "-I",
                            os.path.join(ROOT, "include"), "never.c", "-o", "never.so"], check=True)
            why = "no step could be asked" if word[0] in "os" else f".*'{word}' can't walk"
            said = self.ask(WRONG_USAGE, "walk", "--candidate", "./never.so", "--steps", "200",
                            "--require")
            self.assertRegex(said.stderr, f"surehit walk: error: {why}")
        self.fail_with(BROKEN, ".*older.*", "walk", "--tier", "exact", "--json", "folder/w")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
