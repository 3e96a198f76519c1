# SPDX-License-Identifier: MIT
"""What simulate.py takes from a program's pieces, by one whose parts cost what is known.

    test_simulate.py"""
import argparse
import contextlib
import io
import os
import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.argv = [sys.argv[0], str(HERE / "simulate.py")]
sys.path[:0] = [str(HERE), str(HERE.parent / "support")]
import simulate  # noqa: E402
from commands import InFolder, put  # noqa: E402
from sealed import lines_of  # noqa: E402

PARTS, ANEW = 640, 0.5
# Plans like surehit: COMMAND plan --pieces N -o MANIFEST.
PLANS = f"""#!{sys.executable}
import sys
sys.path.insert(0, "{HERE.parent / "support"}")
from sealed import sealed
pieces = int(sys.argv[3])
ends = [{PARTS} * i // pieces for i in range(pieces + 1)]
lines = [{{"ranges": [[a, b - a]]}} for a, b in zip(ends, ends[1:])]
open(sys.argv[5], "w").write(sealed([{{}}, *lines]))
print(f"{{sys.argv[5]}}: {{pieces}} pieces of {PARTS} parts")
"""


class Simulated(simulate.Measured):
    """Part n costs so many 4096ths of a second, and what is made anew half of one."""

    def seconds(self, manifest, number):
        (first, many), = lines_of(self.path(manifest))[number]["ranges"]
        return ANEW + (sum(range(first, first + many)) / 4096 if manifest == "sample" else 0)


class Simulation(InFolder):
    def test_samples_stand_for_all(self):
        put("plans", PLANS)
        os.chmod("plans", 0o755)
        with contextlib.redirect_stderr(io.StringIO()):
            of = Simulated("./plans", [], 4, ".")
        self.assertEqual((of.total, of.anew), (PARTS, ANEW))
        # Of 20 pieces of 32 parts the third, eighth, ... stand for five each.
        self.assertEqual(of.costs, [5 * sum(range(32 * i, 32 * i + 32)) / 4096
                                    for i in (2, 7, 12, 17)])
        with contextlib.redirect_stdout(io.StringIO()) as said:
            simulate.tell(of.costs, of, argparse.Namespace(nodes=[1], pieces=[4, 1000], start=0))
        whole = sum(of.costs)
        self.assertEqual(said.getvalue().splitlines(), [
            f"one process {whole + ANEW:.0f} s", "pieces | seconds | 1 cores",
            f"4 | {whole / 4:.3g} | {100 * (whole + ANEW) / (whole + 4 * ANEW):.1f} %"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
