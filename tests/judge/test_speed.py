# SPDX-License-Identifier: MIT
"""What the judge takes of itself for a case: instructions, which repeat (docs/judge.md, "Speed").

    test_speed.py SUREHIT

Of the regime typical, whose answers are right: counted by cachegrind (callgrind takes five times as
long), of two runs of more and fewer cases the difference, so that what a run takes once is left
out."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from commands import PROGRAM, ROOT, InFolder, contents  # noqa: E402
from shapes import SHAPES  # noqa: E402

PAGE = pathlib.Path(ROOT, "docs/judge.md").read_text(encoding="utf-8")
MOST = int(re.search(r"at most ([\d,]+)\ninstructions of its own", PAGE)[1].replace(",", ""))
FEW, MANY = 2048, 6144


@unittest.skipUnless(shutil.which("valgrind"), "no valgrind")
class Instructions(InFolder):
    def count(self, shape, cases):
        """Of the judge alone: who is asked runs in another process."""
        words = ["judge", "--tier", "textbook", "--shape", shape, "--regime", "typical",
                 "--margin", "none", "--untimed", "--count", str(cases)]
        with subprocess.Popen(["valgrind", "--tool=cachegrind", "--cache-sim=no",
                               "--cachegrind-out-file=out.%p", PROGRAM, *words],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as running:
            self.assertEqual(running.wait(), 0)
        return int(re.search(rb"^summary: (\d+)", contents(f"out.{running.pid}"), re.M)[1])

    def test_typical(self):
        for shape in SHAPES:
            each = (self.count(shape, MANY) - self.count(shape, FEW)) / (MANY - FEW)
            self.assertTrue(1000 < each <= MOST, f"{shape}: {each:.0f} instructions a case")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
