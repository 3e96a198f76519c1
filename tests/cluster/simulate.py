#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How well pieces fill a cluster: measured here, scheduled by simulation.

    simulate.py [--nodes N,...] [--pieces N,...] [--start S] [--sample N] [--times N,...]
                SUREHIT COMMAND WORD ...

Works off a sample of pieces of what `surehit plan COMMAND WORD ...` cuts, and takes their seconds
of the processor, of which a piece of one part tells what each piece makes anew. Between those that
were measured the cost of a part is taken to change evenly. Then pieces are given to cores as they
become free, as job arrays are, after S seconds each that a scheduler takes to start a task.
With --times the same is told of so many times as much work, as more samples a pixel are.
Efficiency is the time of one process over that of all cores together: what is made anew, starts and
cores without work are lost."""
import argparse
import heapq
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from sealed import lines_of, sealed  # noqa: E402


def makespan(seconds, nodes):
    """Of pieces in their order, each by whoever is free first.

    >>> makespan([1.0] * 8, 4), makespan([1.0] * 9, 4), makespan([3.0, 1.0, 1.0, 1.0], 2)
    (2.0, 3.0, 3.0)
    """
    free = [0.0] * nodes
    for piece in seconds:
        heapq.heappush(free, heapq.heappop(free) + piece)
    return max(free)


def cut(costs, pieces, anew):
    """Seconds of each of so many pieces, when parts of the whole cost that, one after the other.

    >>> cut([1.0, 3.0], 2, 0.5), cut([1.0, 3.0], 4, 0.0), cut([2.0] * 3, 2, 0.0)
    ([1.5, 3.5], [0.5, 0.5, 1.5, 1.5], [3.0, 3.0])
    """
    sums = [0.0]
    for cost in costs:
        sums.append(sums[-1] + cost)

    def until(share):
        at = share * len(costs)
        whole = min(int(at), len(costs) - 1)
        return sums[whole] + (at - whole) * costs[whole]
    ends = [until(i / pieces) for i in range(pieces + 1)]
    return [anew + ends[i + 1] - ends[i] for i in range(pieces)]


def efficiency(costs, pieces, nodes, anew, start):
    """
    >>> efficiency([1.0] * 8, 8, 4, 0.0, 0.0), efficiency([1.0] * 8, 8, 4, 0.0, 1.0)
    (1.0, 0.5)
    """
    seconds = [start + piece for piece in cut(costs, pieces, anew)]
    return (anew + sum(costs)) / (nodes * makespan(seconds, nodes))


class Measured:
    """Seconds of a command's parts, one sample beside the other, and what each piece makes anew."""

    def __init__(self, program, words, sample, folder):
        self.program, self.words, self.folder = program, words, folder
        self.total = self.plan("one", 1)
        self.plan("least", 2)
        asked, piece, _ = lines_of(self.path("least"))
        piece["ranges"] = [[self.total // 2, 1]]
        pathlib.Path(self.path("least")).write_text(sealed([asked, piece, piece, piece]))
        self.anew = min(self.seconds("least", 1 + i) for i in range(3))
        pieces = max(sample, self.total // 32)
        self.plan("sample", pieces)
        self.costs = []
        for i in range(sample):
            number = 1 + (2 * i + 1) * pieces // (2 * sample)
            taken = max(0, self.seconds("sample", number) - self.anew)
            self.costs.append(taken * pieces / sample)
            print(f"piece {number} of {pieces}: {taken:.2f} s", file=sys.stderr, flush=True)

    def path(self, name):
        return os.path.join(self.folder, name)

    def plan(self, manifest, pieces):
        """How many parts there are."""
        said = subprocess.run([self.program, "plan", "--pieces", str(pieces), "-o",
                               self.path(manifest), *self.words], check=True,
                              text=True, stdout=subprocess.PIPE).stdout
        return int(said.split()[-2])

    def seconds(self, manifest, number):
        def spent():
            used = resource.getrusage(resource.RUSAGE_CHILDREN)
            return used.ru_utime + used.ru_stime
        before, name = spent(), self.path(manifest)
        os.makedirs(name + "s", exist_ok=True)
        subprocess.run([self.program, "work", name, str(number), name + "s"], check=True)
        return spent() - before


def numbers(text):
    return [int(number) for number in text.split(",")]


def tell(costs, of, asked):
    print(f"one process {sum(costs) + of.anew:.0f} s\npieces | seconds",
          *(f"{nodes} cores" for nodes in asked.nodes), sep=" | ")
    for pieces in (count for count in asked.pieces if count <= of.total):
        print(pieces, f"{sum(costs) / pieces:.3g}",
              *(f"{100 * efficiency(costs, pieces, nodes, of.anew, asked.start):.1f} %"
                for nodes in asked.nodes), sep=" | ")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--nodes", type=numbers, default=[64, 1024])
    parser.add_argument("--pieces", type=numbers, default=[128, 1024, 4096, 16384])
    parser.add_argument("--start", type=float, default=0.5)
    parser.add_argument("--sample", type=int, default=48)
    parser.add_argument("--times", type=numbers, default=[1])
    parser.add_argument("words", nargs=argparse.REMAINDER)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        of = Measured(asked.program, asked.words, asked.sample, folder)
    print(f"each piece makes {of.anew:.2f} s anew")
    for times in asked.times:
        tell([times * cost for cost in of.costs], of, asked)


if __name__ == "__main__":
    main()
