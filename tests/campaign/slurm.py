#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A manifest's pieces on a Slurm cluster.

    slurm.py CAMPAIGN MANIFEST FOLDER RECORD [--limit S] [OPTION OF sbatch ...]

Submits the pieces that FOLDER lacks as a job array, watches it, submits again what failed or was
preempted, and adds all of them to RECORD. The nodes have to see CAMPAIGN, MANIFEST and FOLDER under
these names. With --limit a task ends after S seconds of its processor, and the next one goes on
from there. Whoever stops this leaves the array running; the same command goes on from what is
done."""
import argparse
import os
import re
import shlex
import subprocess
import sys
import time

MISSING = 3     # exit status of `campaign status`
IDLE_ROUNDS = 3  # in a row without a piece done nor begun
SECONDS = 2     # between looks at the queue, at least


def call(*words, **how):
    try:
        return subprocess.run(words, text=True, stdout=subprocess.PIPE, **how)
    except OSError as error:
        sys.exit(f"slurm.py: {words[0]}: {error.strerror}")


def ask(*words, ok=(0,)):
    done = call(*words, stderr=subprocess.PIPE)
    if done.returncode not in ok:
        sys.exit(f"slurm.py: {shlex.join(words)}: {done.stderr.strip()}")
    return done


def run(*words, ok=(0,)):
    return ask(*words, ok=ok).stdout


def ranges(words):
    """[(first, last)] of what --array takes.

    >>> ranges("1,4-6\\n"), ranges("\\n")
    ([(1, 1), (4, 6)], [])
    """
    pairs = [pair.partition("-") for pair in words.strip().split(",") if pair]
    return [(int(first), int(last or first)) for first, _, last in pairs]


def array_of(missing, most):
    """Of the first ones that fit: what is to be added to a task's number, and --array.

    >>> array_of([(4, 6), (9, 12), (14, 14)], 31)
    (4, '0-2,5-8,10-10')
    >>> array_of([(4, 6), (9, 12), (14, 14)], 7)
    (4, '0-2,5-6')
    >>> array_of([(4, 6), (9, 12), (14, 14)], 5)
    (4, '0-2')
    """
    offset = missing[0][0]
    fit = [(first - offset, min(last - offset, most - 1))
           for first, last in missing if first - offset < most]
    return offset, ",".join(f"{first}-{last}" for first, last in fit)


class Cluster:
    def __init__(self, options, sbatch):
        self.campaign, self.manifest, self.folder = map(
            os.path.abspath, (options.campaign, options.manifest, options.folder))
        self.options, self.sbatch = options, sbatch
        self.logs = os.path.join(self.folder, "logs")
        os.makedirs(self.logs, exist_ok=True)
        config = run("scontrol", "show", "config")
        self.most = int(re.search(r"MaxArraySize\s*=\s*(\d+)", config)[1])

    def look(self):
        """What is missing, and which part of all is done: parts of pieces count."""
        done = ask(self.campaign, "status", self.manifest, self.folder, ok=(0, MISSING))
        return ranges(done.stdout), float(done.stderr.split()[-4]) / 100

    def submit(self, missing):
        limit = self.options.limit
        more = ["--limit", str(limit)] if limit else []
        offset, array = array_of(missing, self.most)
        task = (f"#!/bin/sh\nexec {shlex.join([self.campaign, 'work', self.manifest])} "
                f"$(({offset} + SLURM_ARRAY_TASK_ID)) {shlex.join([self.folder, *more])}\n")
        done = call("sbatch", "--parsable", "--requeue", f"--array={array}",
                    f"--output={self.logs}/%A_%a.txt", *self.sbatch, input=task)
        if done.returncode != 0:
            sys.exit("slurm.py: sbatch took no job")
        return done.stdout.strip().partition(";")[0]

    def states(self, job):
        """Of its tasks that have not ended; none, too, when the job is forgotten. A controller that
        does not answer says neither: it is asked again."""
        while True:
            done = ask("squeue", "--noheader", "--array", f"--jobs={job}", "--format=%T",
                       ok=(0, 1))
            if done.returncode == 0 or "Invalid job id" in done.stderr:
                return done.stdout.split()
            print(f"slurm.py: {done.stderr.strip()}; asked again", file=sys.stderr, flush=True)
            time.sleep(5 * SECONDS)

    def watch(self, job, left):
        total = sum(last - first + 1 for first, last in left)
        began, before = time.monotonic(), self.look()[1]
        while states := self.states(job):
            looked = time.monotonic()
            missing, part = self.look()
            still = sum(last - first + 1 for first, last in missing)
            running = states.count("RUNNING")
            rest = (looked - began) * (1 - part) / (part - before) if part > before else None
            print(f"job {job}: {total - still} of {total} pieces done, {running} running, "
                  f"{len(states) - running} waiting"
                  + (f", about {rest:.0f} s left" if rest is not None else ""), flush=True)
            time.sleep(max(SECONDS, 10 * (time.monotonic() - looked)))

    def kept(self):
        """What says whether a round has brought anything: parts grow."""
        return sorted((entry.name, entry.stat().st_mtime_ns) for entry in os.scandir(self.folder)
                      if entry.name.endswith((".json", ".part")))

    def work(self):
        idle = 0
        while missing := self.look()[0]:
            before = self.kept()
            self.watch(self.submit(missing), missing)
            idle = 0 if self.kept() != before else idle + 1
            if idle == IDLE_ROUNDS:
                sys.exit(f"slurm.py: nothing gets on; {self.logs} has what tasks said")
        run(self.campaign, "status", self.manifest, self.folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__, add_help=True,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("campaign", "manifest", "folder", "record"):
        parser.add_argument(name)
    parser.add_argument("--limit", type=int, default=0)
    options, sbatch = parser.parse_known_args()
    cluster = Cluster(options, sbatch)
    cluster.work()
    done = subprocess.run([cluster.campaign, "merge", cluster.folder, "-o", options.record])
    sys.exit(done.returncode)


if __name__ == "__main__":
    main()
