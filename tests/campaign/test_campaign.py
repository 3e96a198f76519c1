# SPDX-License-Identifier: MIT
"""Every tier against the reference: no promise is broken in 800,000 cases of a seed of their own.

    test_campaign.py CAMPAIGN HERE"""
import os
import re
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from commands import InFolder, PROGRAM  # noqa: E402

HERE = os.path.abspath(sys.argv[2])


class Campaign(InFolder):
    def test_all_promises_hold(self):
        self.succeed("plan", "--cases", "800000", "--seed", "2", "--seconds", "5", "-o", "manifest")
        subprocess.run(["sh", HERE, PROGRAM, "manifest", "pieces"], check=True)
        said = self.succeed("merge", "pieces", "-o", "record")
        print(said, end="")
        self.assertGreaterEqual(int(re.match(r"\d+", said)[0]), 800000)
        self.assertIn("; 0 broken promises\n", said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
