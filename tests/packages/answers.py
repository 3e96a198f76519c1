# SPDX-License-Identifier: MIT
"""What all tiers answer to cases of each shape and regime (answers.c), and whether it is the same
bits in another build."""
import pathlib
import shlex

from trial import Fault, Trial

CASES = 10  # of each shape and regime
ROWS = 6  # the tiers, and floats


class Answers(Trial):
    """Arguments: those of each trial, then PROGRAM, which writes the cases, and LIBRARY, which is
    asked first."""

    def __init__(self, *options):
        super().__init__(*options[:4])
        self.surehit, self.library = (pathlib.Path(path).resolve() for path in options[4:6])
        self.include = self.root / "include"

    def built(self, name, compiler, *words):
        self.run(*compiler.split(), "-std=c11", "-O2", f"-I{self.include}",
                 self.root / "tests/packages/answers.c", *words, "-lm", "-o", name)
        return f"./{name}"

    def answers(self, command, **variables):
        answers = self.scratch / f"{shlex.split(command)[-1]}.answers"
        self.run("sh", "-c", f"{command} <cases >{answers}", **variables)
        return answers.read_text().splitlines()

    def ask_library(self):
        self.cases = self.run(self.surehit, "cases", "--count", CASES).splitlines()
        self.write("cases", "\n".join(self.cases) + "\n")
        self.wanted = self.answers(self.built("by_library", self.compiler, self.library,
                                              f"-Wl,-rpath,{self.library.parent}"))
        if len(self.wanted) != len(self.cases) * ROWS or len(self.cases) < 1000:
            raise Fault(f"{len(self.wanted)} answers of {len(self.cases)} cases")

    def check_answers_of(self, name, command, **variables):
        there = self.answers(command, **variables)
        wrong = [i for i, pair in enumerate(zip(there, self.wanted)) if pair[0] != pair[1]]
        if wrong:
            raise Fault(f"{name}: {len(wrong)} answers differ, the first of\n"
                        f"{self.cases[wrong[0] // ROWS]}\n{there[wrong[0]]}\n"
                        f"in the library\n{self.wanted[wrong[0]]}")
        if len(there) != len(self.wanted):
            raise Fault(f"{name}: {len(there)} answers, not {len(self.wanted)}")
        print(f"{name}: {len(there)} answers, the same bits", flush=True)
