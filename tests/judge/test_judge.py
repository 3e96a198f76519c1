# SPDX-License-Identifier: MIT
"""`surehit cases`, `answer` and `judge` as their users meet them:

    test_judge.py SUREHIT CC CANDIDATES [REFERENCE]

CANDIDATES is the folder of tests/judge/candidates/*.c as built: one.so, many.so, float.so,
prepared.so, half.so (the same without _free), others.so and others_prepared.so (in float), which
answer all but hits, some.so (the sphere alone), old.so (another version),
none.so (nothing), program. Each does what SUREHIT_WRONG names, in one case of sixteen. The last
word says that surehit-reference is built."""

import hashlib
import json
import os
import pathlib
import re
import shutil
import signal
import statistics
import subprocess
import sys
import unittest
import xml.etree.ElementTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import commands  # noqa: E402
from commands import PROGRAM, ROOT, WRONG_USAGE, contents, loaded, put  # noqa: E402
from shapes import SHAPES  # noqa: E402

CC, CANDIDATES = sys.argv[2].split(), os.path.abspath(sys.argv[3])
HAS_REFERENCE = "reference" in sys.argv[4:]
BROKEN = 1
BORNE = 16  # crashes in a row of cases, whatever they cost
HANGS = 2
TRIES = 2000   # cases of several at a time, to make one simple
FAULTS = ["false hit", "false miss", "wrong part", "valid refused", "not a number",
          "t out of range", "invalid accepted", "wrong field", "outputs touched", "answer changes",
          "leak", "garbage", "crash", "no answer in time", "no answer"]

# What SUREHIT_WRONG names, and the faults to be found: these and no others.
ANSWERS = {
    "right": [],
    "frees": [],
    "false hit": ["false hit"],
    "false miss": ["false miss"],
    "part": ["wrong part"],
    "nan": ["not a number"],
    "nan in the normal": ["not a number"],
    "no t": ["not a number"],
    "range": ["t out of range"],
    "normal": [],
    "refuses": ["valid refused"],
    "garbage": ["garbage"],
    "accepts": ["invalid accepted"],
    "changes": ["answer changes", "false miss", "valid refused", "invalid accepted"],
    "remembers": ["answer changes", "t out of range"],
}
ONLY_LIBRARIES = {"touches": ["outputs touched"], "leaks": ["leak"]}
ENDS = {"crashes": "crash", "aborts": "crash", "exits": "crash", "exits quietly": "crash"}
ENDS_OF_PROGRAM = {**ENDS, "exits quietly": "no answer"}


def candidate(name):
    path = os.path.join(CANDIDATES, name)
    return ["--candidate" if name.endswith(".so") else "--command", path]


def tier(name):
    return ["--tier", name]


class InFolder(commands.InFolder):
    """Who is asked is a list of words, and what else is said a line of them."""

    def run_program(self, *words, wrong="right", **more):
        more.setdefault("env", {**os.environ, "SUREHIT_WRONG": wrong})
        return super().run_program(*words, **more)

    def judge(self, subject, line="", status=0, **more):
        """The verdict as JSON."""
        self.ask(status, "judge", *subject, *line.split(), "--json", "verdict.json", **more)
        return loaded("verdict.json")

    def rows(self, subject, line="", **more):
        """Without what no two runs have alike."""
        rows = self.judge(subject, line, **more)["rows"]
        for row in rows:
            del row["nanoseconds"]
        return rows

    def row(self, subject, line="", **more):
        """The only one."""
        (row,) = self.judge(subject, line, **more)["rows"]
        return row

    def alone(self, subject, case, **more):
        """The row of one case."""
        return self.row(subject, "--cases -", input=case + "\n", **more)

    def check_again(self, subject, one, **more):
        """One of the worst is of its kind when it is asked again."""
        row = self.alone(subject, one["case"], **more)
        if one["kind"] in FAULTS:
            self.assertEqual(row["faults"][one["kind"]], 1, one)
        elif one["kind"] == "largest error of t":
            self.assertEqual(row["t_ulps"]["most"], one["ulps"])

    def found(self, row):
        self.assertEqual(list(row["faults"]), FAULTS)
        return {name for name, count in row["faults"].items() if count > 0}


ONE, MANY, FLOAT, PREPARED = (candidate(name + ".so")
                              for name in ("one", "many", "float", "prepared"))
SOME, ON_A_PIPE = candidate("some.so"), candidate("program")
KEPT, IN_BLOCKS = (["--command", f"{ON_A_PIPE[1]} {words}", "--keep"]
                   for words in ("lines", "binary"))
PROGRAMS = ON_A_PIPE, KEPT, IN_BLOCKS

# A row in which every status occurs.
ROW = "--shape cylinder --regime degenerate --count 400"


class Faults(InFolder):
    def test_answers(self):
        """One by one, many at once, in float, of objects that are built, and of programs."""
        for subject in (ONE, MANY, FLOAT, PREPARED, *PROGRAMS):
            for wrong, faults in (ANSWERS if subject in PROGRAMS else
                                  {**ANSWERS, **ONLY_LIBRARIES}).items():
                if subject in PROGRAMS and wrong == "no t":
                    continue
                row = self.row(subject, ROW, wrong=wrong)
                self.assertEqual(self.found(row), set(faults), (subject, wrong))
                self.assertEqual(row["unasked"], 0)
                t = row["t_ulps"]
                if wrong != "normal":
                    self.assertEqual(t["hits"] == t["correctly_rounded"],
                                     wrong not in ("nan", "no t", "range", "remembers"),
                                     (subject, wrong))

    def test_every_case_is_blamed_once(self):
        """The same cases, whatever is wrong with them."""
        sixteenth = self.row(ONE, ROW, wrong="garbage")["faults"]["garbage"]
        self.assertTrue(15 <= sixteenth <= 35, sixteenth)
        for subject, wrong, fault in ((ONE, "leaks", "leak"), (MANY, "leaks", "leak"),
                                      (ON_A_PIPE, "garbage", "garbage")):
            self.assertEqual(self.row(subject, ROW, wrong=wrong)["faults"][fault], sixteenth)

    def test_what_is_not_written_is_no_status(self):
        """Nor is what the block before has left."""
        put("silent.c", '''
#include <surehit/candidate.h>
const int sure_candidate_version = SURE_CANDIDATE_VERSION;
void sure_candidate_sphere_many(int count, const double *rays, const double *spheres, int *statuses,
                                sure_candidate_hit *hits)
{
    static int calls;
    for (int i = 0; calls < 3 && i < count; i++) /* of one block: forwards, and half by half */
        statuses[i] = SURE_CANDIDATE_MISS;
    calls++;
    (void)rays, (void)spheres, (void)hits;
}
''')
        subprocess.run([*CC, "-shared", "-fPIC", "-I", os.path.join(ROOT, "include"), "silent.c",
                        "-o", "silent.so"], check=True)
        row = self.row(["--candidate", "./silent.so"], "--regime typical --count 10000")
        self.assertGreater(row["faults"]["garbage"], 1000)

    def test_remembering_shows_in_the_order(self):
        """Backwards each case has another one before it, and not only the first."""
        row = self.row(ONE, ROW, wrong="remembers")
        self.assertGreater(row["faults"]["answer changes"], 20)

    def test_errors_are_measured(self):
        line = "--shape cone --regime typical --count 500"
        for subject in (ONE, MANY, FLOAT, *PROGRAMS):
            row = self.row(subject, line, wrong="3 ulps")
            t = row["t_ulps"]
            self.assertEqual((t["median"], t["99"], t["99.99"], t["most"]), (0, 3, 3, 3), subject)
            self.assertEqual(row["t_ulps_by_powers_of_two"][3], t["hits"] - t["correctly_rounded"])
            row = self.row(subject, line, wrong="normal")
            self.assertEqual(row["t_ulps"]["most"], 0)
            normal = row["normal"]
            self.assertLess(normal["correctly_rounded"], normal["hits"])
            # The change is rounded to the component's own precision.
            self.assertAlmostEqual(normal["most"] / 2**-20, 1, delta=2**-3)

    def test_ends(self):
        """All of them are counted: as many as there are answers that are garbage."""
        line = ROW + " --regime typical --time-limit 60"
        for subject in (ONE, MANY, FLOAT, PREPARED, *PROGRAMS):
            counts = [row["faults"]["garbage"] for row in
                      self.rows(subject, line, wrong="garbage")]
            self.assertGreater(min(counts), BORNE)
            for wrong, fault in (ENDS_OF_PROGRAM if subject in PROGRAMS else ENDS).items():
                for row, count in zip(self.rows(subject, line, wrong=wrong), counts, strict=True):
                    self.assertEqual(self.found(row), {fault}, (subject, wrong))
                    self.assertEqual(row["faults"][fault], count, (subject, wrong))
                    self.assertEqual(row["unasked"], 0, (subject, wrong))

    def test_lines_are_lost(self):
        for subject in (ON_A_PIPE, KEPT):
            for wrong in ("skips misses", "floods", "closes early"):
                for row in self.rows(subject, ROW + " --regime typical", wrong=wrong):
                    self.assertEqual(self.found(row), {"no answer"}, (subject, wrong))
                    self.assertGreaterEqual(row["faults"]["no answer"], BORNE)

    def test_a_rate_of_crashes(self):
        """A library that crashes on 3 % of its cases: all of them are told."""
        line = "--shape sphere --regime typical --count 2000"
        cases = self.succeed("cases", *line.split())
        ends = self.row(ONE, line, wrong="rarely aborts")["faults"]["crash"]
        answers = self.run_program(program=ON_A_PIPE[1], input=cases, wrong="rarely garbage")
        self.assertEqual(ends, answers.stdout.count("garbage"))
        self.assertTrue(0.02 * 2000 < ends < 0.04 * 2000, ends)

    def test_it_is_given_up(self):
        """Where there are more crashes than answers, or they take too long."""
        line = "--shape sphere --regime typical --regime far --count 400 --time-limit "
        for always in (ONE, MANY, *PROGRAMS):
            self.check_given_up(always, line + "60", "always aborts")
        slow = ["--command", f"sleep 0.1; exec {KEPT[1]}", "--keep"]
        self.check_given_up(slow, line + "0.9", "aborts")

    def check_given_up(self, subject, line, wrong):
        """And it goes on with the next row."""
        for row in self.rows(subject, line, wrong=wrong):
            self.assertEqual(row["faults"]["crash"], BORNE, (subject, wrong))
            self.assertGreater(row["unasked"], 0)

    def test_few_ends_are_survived(self):
        """The cases that crash, one by one, and no others."""
        few = "--shape sphere --regime typical --count 100"
        crashing = sum(self.alone(ONE, case, wrong="aborts")["faults"]["crash"]
                       for case in self.succeed("cases", *few.split()).splitlines())
        self.assertTrue(0 < crashing < BORNE, crashing)
        for subject in (ONE, MANY, *PROGRAMS):
            row = self.row(subject, few, wrong="aborts")
            self.assertEqual((row["faults"]["crash"], row["wrong"], row["unasked"], row["cases"]),
                             (crashing, crashing, 0, 100))

    def test_what_shows_in_no_answer(self):
        for subject, wrong, fault in ((MANY, "crashes in company", "crash"),
                                      (ONE, "writes its input", "crash")):
            self.assertEqual(self.found(self.row(subject, ROW, wrong=wrong)), {fault})
        row = self.row(ON_A_PIPE, "--shape sphere --regime typical --count 4000",
                       wrong="leaks always")
        self.assertEqual(self.found(row), {"leak"})

    def test_objects_that_are_built(self):
        """What goes wrong with them: of every case the object, not one in sixteen."""
        line = "--shape cylinder --regime typical --count 30"
        for wrong, fault, count in (("keeps objects", "leak", 30),
                                    ("builds nothing", "valid refused", 30),
                                    ("crashes while building", "crash", BORNE)):
            row = self.row(PREPARED, line, wrong=wrong)
            self.assertEqual((self.found(row), row["faults"][fault]), ({fault}, count), wrong)

    def test_hangs(self):
        for subject in (ONE, MANY, *PROGRAMS):
            row = self.row(subject, "--shape disc --regime typical --count 64 --time-limit 0.1",
                           wrong="hangs")
            self.assertEqual(self.found(row), {"no answer in time"}, subject)
            self.assertEqual(row["faults"]["no answer in time"], HANGS)
            self.assertEqual(row["cases"] + row["unasked"], 64)

    def test_worst_cases(self):
        """Each is of its kind when it is asked again, by the line that is printed, and is a simpler
        one unless a program that is started for each block has ended in it."""
        lines = self.succeed("cases", *ROW.split()).splitlines()
        kinds = ["false hit", "part", "3 ulps", "aborts"]
        more = ["false miss", "range", "accepts", "nan", "leaks", "touches"]
        for subject, wrong in [(ONE, wrong) for wrong in kinds + more] + \
                [(subject, wrong) for subject in PROGRAMS for wrong in kinds]:
            worst = self.judge(subject, ROW, wrong=wrong)["worst"]
            text = self.succeed("judge", *subject, *ROW.split(), wrong=wrong)
            self.assertTrue(worst, wrong)
            for one in worst:
                self.assertEqual(one["case"] in lines, (subject, wrong) == (ON_A_PIPE, "aborts"))
                self.check_line(one, text, wrong)
                self.check_again(subject, one, wrong=wrong)

    def test_worst_normals(self):
        """They are on the part that is right, made simple, too, and stay half as large at least."""
        seen, of = 0, {"largest error of t": "t_ulps",
                       "largest error of the normal": "normal_ulps"}
        for shape, seed in ("cylinder", 4), ("cylinder", 5), ("cone", 2), ("cone", 4):
            verdict = self.judge(tier("textbook"), f"--shape {shape} --count 300 --seed {seed}")
            for one in verdict["worst"]:
                if one["kind"] == "largest error of the normal":
                    self.assertEqual(one["answer"].split()[2], one["right"].split()[2], one)
                    seen += 1
                if one["kind"] in of:
                    most = max(row[of[one["kind"]]]["most"] for row in verdict["rows"])
                    self.assertGreaterEqual(one["ulps"], most / 2, one)
        self.assertEqual(seen, 4)

    def test_worst_cases_of_who_hangs_now_and_then(self):
        """To make one simple no more time is taken than one may: of each kind a hang or two."""
        put("hangs.c", HANGS_BELOW)
        subprocess.run([*CC, "-shared", "-fPIC", "-I", os.path.join(ROOT, "include"), "hangs.c",
                        "-o", "hangs.so"], check=True)
        verdict = self.judge(["--candidate", "./hangs.so"],
                             "--shape disc --regime typical --count 30 --seed 4 --time-limit 1")
        self.assertIn("largest error of t", [one["kind"] for one in verdict["worst"]])
        hangs = contents("hangs").count(b"\n")
        self.assertLessEqual(hangs, 2 * verdict["rows"][0]["faults"]["no answer in time"] +
                             2 * len(verdict["worst"]))

    def check_line(self, one, text, wrong):
        """The line that is printed asks the case again, as it stands."""
        line = next(line for line in text.splitlines()
                    if line.startswith(f"  echo '{one['case']} # {one['regime']}'"))
        again = subprocess.run(line, shell=True, env={**os.environ, "SUREHIT_WRONG": wrong},
                               capture_output=True, text=True, check=True).stdout
        self.assertIn(f"\n{one['shape']:9} {one['regime']:13} ", again)

    def test_odd_names(self):
        """A line can be pasted whatever the candidate is called, and asks as it was asked."""
        name = "./it's one; or $two.so"
        shutil.copy(ONE[1], name)
        words = ["--entry", "unit inside=miss", "--margin", "ulps", "--inputs", "double",
                 "--time-limit", "0.75"]
        line = ROW.replace("degenerate", "typical").split()
        text = self.succeed("judge", "--candidate", name, *line, *words, wrong="false hit")
        (worst,) = self.judge(["--candidate", name, *words], " ".join(line),
                              wrong="false hit")["worst"]
        self.check_line(worst, text, "false hit")
        self.assertRegex(text, "two.so' --inputs double --entry 'unit inside=miss' --time-limit "
                               "0.75 --margin ulps\n")

    def test_names_that_a_terminal_obeys(self):
        """They are shown; the line can be pasted; programs get them as they are."""
        name = "./a\x1b[31m\n'b\x7f\x9b1m.so"
        shutil.copy(ONE[1], name)
        line = ROW.replace("degenerate", "typical")
        text = self.succeed("judge", "--candidate", name, *line.split(), wrong="false hit")
        shown = "./a\\x1b[31m\\x0a'b\\x7f\\xc2\\x9b1m.so, held against"
        self.assertTrue(text.startswith(shown), text)
        self.assertNotRegex(text, "[^ -~\n]")
        said = self.judge(["--candidate", name], line, wrong="false hit")
        self.assertEqual(said["candidate"], name)
        paste = text[text.index("  echo '"):]
        again = subprocess.run(paste, shell=True, env={**os.environ, "SUREHIT_WRONG": "false hit"},
                               capture_output=True, text=True, check=True).stdout
        self.assertIn("\ncylinder  typical ", again)
        walked = self.succeed("walk", "--candidate", name, "--shape", "cylinder", "--steps", "9")
        self.assertTrue(walked.startswith(shown), walked)
        self.fail_with(WRONG_USAGE, r".*: 'exit 127 #\\x1b\\x0a' cannot be started", "judge",
                       "--command", "exit 127 #\x1b\n")
        self.fail_with(WRONG_USAGE, r".*--shape 'a\\x1b\\x0a': expected .*", "judge", *ONE,
                       "--shape", "a\x1b\n")

    def test_worst_cases_by_the_count(self):
        """So many cases are tried to make one simple, and no more; always the same."""
        tee = ["--command", "tee -a asked | " + ON_A_PIPE[1]]
        line = "--shape disc --regime grazing --count 100"
        first, again = (self.judge(tee, line, wrong="3 ulps")["worst"] for _ in range(2))
        self.assertEqual([one["kind"] for one in first], ["largest error of t"])
        self.assertEqual(first, again)
        asked = contents("asked").count(b"\n") // 2 // 2  # of a run and a pass
        self.assertTrue(TRIES / 2 < asked - 100 < TRIES + 15 * 20, asked)

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_worst_cases_by_the_reference(self):
        """As simple as by exact, nearly."""
        line = "--shape cone --regime grazing --count 300 --truth "
        by = [self.judge(tier("textbook"), line + "exact")["worst"]]
        text = self.succeed("judge", *tier("textbook"), *(line + "reference").split(), "--json",
                            "verdict.json")
        by.append(loaded("verdict.json")["worst"])
        asked = re.findall("(?m)^  echo .*", text)
        self.assertEqual(len(asked), len(by[1]))
        self.assertTrue(all(one.endswith(" --truth reference") for one in asked), asked)
        self.assertEqual([one["kind"] for one in by[0]], [one["kind"] for one in by[1]])
        sizes = [sum(len(one["case"]) for one in worst) for worst in by]
        self.assertLess(sizes[1], 1.25 * sizes[0])
        for one in by[1]:
            self.check_again(tier("textbook"), one)

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_worst_cases_of_a_library_by_the_reference(self):
        """More are tried at a time than it is asked at once."""
        line = "--shape disc --regime grazing --count 100 --truth reference"
        (one,) = self.judge(ONE, line, wrong="3 ulps")["worst"]
        self.assertEqual(one["kind"], "largest error of t")
        self.check_again(ONE, one, wrong="3 ulps")


OTHERS = [candidate(name) for name in ("others.so", "others_prepared.so")]


class Others(InFolder):
    """Queries besides hit."""

    QUERIES = ["occluded", "interval", "inside"]
    # What SUREHIT_WRONG names, and what is found then in intervals; in decisions the same unless it
    # is said.
    WRONG = {
        "right": [],
        "false hit": ["false hit"],
        "false miss": ["false miss"],
        "refuses": ["valid refused"],
        "garbage": ["garbage"],
        "nan": ["not a number"],
        "one end": ["not a number"],
        "touches": ["outputs touched"],
        "clips": [],
    }
    OF_ENDS = ["nan", "one end", "touches"]

    def by_query(self, subject, line, **more):
        return {row["query"]: row for row in self.judge(subject, line, **more)["rows"]}

    def test_answers(self):
        for subject in OTHERS:
            for wrong, faults in self.WRONG.items():
                rows = self.by_query(subject, ROW, wrong=wrong)
                self.assertEqual(list(rows), self.QUERIES)
                for query, row in rows.items():
                    ends = query == "interval"
                    found = faults if ends or wrong not in self.OF_ENDS else []
                    self.assertEqual(self.found(row), set(found), (subject, wrong, query))
                    t = row["t_ulps"]
                    self.assertEqual(t["hits"] > 0, ends)
                    self.assertEqual(t["hits"] == t["correctly_rounded"],
                                     not ends or wrong not in ("nan", "one end", "clips"), wrong)

    def test_changes(self):
        for row in self.by_query(OTHERS[0], ROW, wrong="changes").values():
            self.assertIn("answer changes", self.found(row))

    def test_both_ends(self):
        """Each is measured; the worst case is one of the second."""
        line = "--shape cone --regime typical --count 500 --query interval"
        verdict = self.judge(OTHERS[0], line, wrong="3 ulps")
        t = verdict["rows"][0]["t_ulps"]
        self.assertEqual((t["hits"], t["most"]), (2 * verdict["rows"][0]["hits"], 3))
        self.assertTrue(0 < t["hits"] - t["correctly_rounded"] < t["hits"] / 8)
        (one,) = verdict["worst"]
        self.assertEqual((one["kind"], one["query"], one["ulps"]),
                         ("largest error of t", "interval", 3))
        given, right = one["answer"].split(), one["right"].split()
        self.assertEqual((given[:2], len(given)), (right[:2], 3))

    def test_seeded_margins(self):
        """Of who has each radius larger or smaller by a share; all pass near the surface."""
        for shape in ("sphere", "cylinder"):
            for share in (1e-7, -1e-7, 5e-3, -5e-3):
                rows = self.by_query(OTHERS[0], f"--shape {shape} --regime grazing --count 3000",
                                     env={**os.environ, "SUREHIT_RADIUS": repr(share)})
                for query, row in rows.items():
                    self.assertGreater(row["wrong"], 0, (shape, share, query))
                    most = row["margins"]["most"]
                    self.assertLessEqual(most, abs(share) * (1 + 1e-9), (shape, share, query))
                    if query != "inside":  # of which points lie within roundings
                        self.assertGreater(most, abs(share) / 16, (shape, share, query))

    def test_an_open_solid(self):
        """Points of the boundary are outside: a convention that can be declared."""
        line = "--regime integers --count 2000 --query inside"
        wrong = self.judge(OTHERS[0], line, wrong="open")["rows"]
        self.assertEqual([row["shape"] for row in wrong], list(SHAPES))
        for row in wrong:
            self.assertGreater(row["wrong"], 0)
            self.assertEqual(row["decisions"]["wrong"]["surface"], row["wrong"])
        for row in self.judge(OTHERS[0], line + " --entry surface=miss", wrong="open")["rows"]:
            self.assertEqual(row["wrong"], 0)

    def test_insides_are_not_excused(self):
        """By conventions of hits: from inside there may be none, but the point is inside."""
        for query in ("interval", "inside"):
            line = f"--shape sphere --regime inside --query {query} --entry inside=miss,outside"
            row = self.row(OTHERS[0], line.replace(",outside", ""), wrong="false miss")
            self.assertGreater(row["faults"]["false miss"], 0)
            self.assertEqual(self.row(OTHERS[0], line, wrong="false miss")["skipped"] > 0,
                             query == "interval")

    def test_entry(self):
        """Right within each of the conditions."""
        for words in ("unit", "local", "t_min=0", "ray", "segment", "outside", "scale=1..100"):
            line = f"--shape cone --regime typical --regime rim --count 200 --entry {words}"
            rows = self.judge(OTHERS[0], line)["rows"]
            self.assertEqual(len(rows), 2 * len(self.QUERIES))
            for row in rows:
                self.assertEqual((row["wrong"], row["cases"] > 50), (0, True), (words, row))

    def test_who_only_decides_tells_no_t(self):
        line = "--shape sphere --regime typical --count 200 --entry decision"
        for wrong in ("right", "nan", "3 ulps", "range"):
            row = self.row(ONE, line, wrong=wrong)
            self.assertEqual((self.found(row), row["t_ulps"]["hits"]), (set(), 0), wrong)

    def test_worst_cases(self):
        """The line that is printed asks the query again."""
        for wrong in ("false hit", "false miss", "garbage", "nan"):
            for query in self.QUERIES:
                line = f"--shape cylinder --regime rim --count 300 --query {query}"
                self.check_lines(OTHERS[0], line, query, wrong)
        line = "--shape sphere --regime bits --count 500 --seed 3 --query inside"
        self.check_lines(tier("textbook"), line, "inside", "right")

    def check_lines(self, subject, line, query, wrong):
        text = self.succeed("judge", *subject, *line.split(), wrong=wrong)
        for one in self.judge(subject, line, wrong=wrong)["worst"]:
            case = re.escape(f"{one['case']} # {one['regime']}")
            found = re.search(rf"(?m)^  (echo '{case}' .*)$", text)[1]
            again = subprocess.run(found, shell=True, capture_output=True, text=True,
                                   env={**os.environ, "SUREHIT_WRONG": wrong}, check=True).stdout
            row = f"{one['shape']} {query}"
            self.assertIn(f"\n{row}", again)
            self.assertIn(f"{one['kind']} ({row} {one['regime']})", again)

    def test_of_a_tier(self):
        """Hits alone unless it is asked for more; whatever is asked, both exact tiers agree."""
        line = "--shape box --regime rim --count 100"
        self.assertEqual(list(self.by_query(tier("exact"), line)), ["hit"])
        words = " ".join(f"--query {query}" for query in self.QUERIES)
        rows = self.by_query(tier("certain"), f"{line} {words}")
        self.assertEqual(list(rows), self.QUERIES)
        self.assertEqual([row["wrong"] for row in rows.values()], 3 * [0])
        for row in rows.values():
            self.assertTrue(all(time > 0 for time in row["nanoseconds"].values()))

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_by_the_reference(self):
        """It knows the chord by itself: exact is right by it, and who is wrong is as wrong."""
        words = " ".join(f"--query {query}" for query in self.QUERIES)
        line = f"--regime rim --regime integers --regime degenerate --count 60 {words} " \
               "--truth reference"
        rows = self.judge(tier("exact"), line + " --require decisions,contract,t<=0ulp")["rows"]
        self.assertEqual({row["query"] for row in rows}, set(self.QUERIES))
        self.assertGreater(sum(row["t_ulps"]["hits"] for row in rows), 400)
        line = f"--shape cone --regime rim --count 200 {words}"
        for wrong in ("right", "false miss", "3 ulps"):
            by_exact, by_reference = (self.rows(OTHERS[0], line + more, wrong=wrong)
                                      for more in ("", " --truth reference"))
            self.assertEqual(by_exact, by_reference, wrong)

    def test_what_is_required(self):
        """Decisions of every row, t of those that have one."""
        line = "--shape sphere --regime typical --count 200 --require decisions,contract,t<=0ulp"
        self.judge(OTHERS[0], line)
        for wrong, *kept in (("3 ulps", True, True, False), ("false miss", False, True, True)):
            verdict = self.judge(OTHERS[0], line, wrong=wrong, status=BROKEN)
            self.assertEqual([one["kept"] for one in verdict["required"]], kept)


WALLS = candidate("walls.so")


class Walls(InFolder):
    """Infinite cylinders and double cones, of a library that declares them."""

    def test_right(self):
        line = "--count 60 --require decisions,contract,t<=0ulp"
        rows = self.judge(WALLS, line)["rows"]
        self.assertEqual({row["shape"] for row in rows}, {"sphere", "cylinder", "cone"})
        self.assertFalse(any("normal_ulps" in row and row["normal_ulps"]["hits"] for row in rows))
        if HAS_REFERENCE:
            self.judge(WALLS, line + " --truth reference")

    def test_seeded(self):
        """Who answers solids, or one nappe, is found out, where the others are still right."""
        for wrong, shapes in (("capped", {"cylinder", "cone"}), ("one nappe", {"cone"}),
                              ("false miss", {"sphere", "cylinder", "cone"})):
            for truth in ["exact", "reference"][:1 + HAS_REFERENCE]:
                line = f"--regime typical --regime inside --count 400 --truth {truth}"
                rows = self.rows(WALLS, line, wrong=wrong)
                self.assertEqual({row["shape"] for row in rows if row["wrong"]}, shapes, wrong)
        row = self.row(WALLS, "--shape cone --regime typical --count 400", wrong="3 ulps")
        self.assertEqual((row["wrong"], row["t_ulps"]["most"]), (0, 3))
        row = self.row(WALLS, "--shape cone --regime typical --count 400", wrong="part")
        self.assertEqual(self.found(row), {"wrong part"})

    def test_seeded_margins(self):
        """Of a cylinder that is larger: at most by so much of its size, and not of a cone."""
        for shape in "cylinder", "cone":
            row = self.row(WALLS, f"--shape {shape} --regime grazing --count 400",
                           env={**os.environ, "SUREHIT_RADIUS": "0.01"})
            self.assertGreater(row["wrong"], 0)
            self.assertLessEqual(row["margins"]["most"], 0.01 * (1 + 1e-9))
            self.assertEqual(row["margins"]["most"] > 1e-4, shape == "cylinder")

    def test_where_they_are_none(self):
        """A tier has solids; a chord or an interior no wall has."""
        words = "--entry wall --shape cone --query interval --count 9".split()
        said = self.ask(WRONG_USAGE, "judge", *OTHERS[0], *words).stderr
        self.assertIn("no case has the entry", said)
        self.fail_with(WRONG_USAGE, "surehit judge: error: tier exact: .*'wall' .*", "judge",
                       *tier("exact"), "--entry", "wall")


class Verdicts(InFolder):
    def test_same_routine_same_verdict(self):
        """As a library, as a program, and by its answers in a file."""
        line = "--shape disc --shape cylinder --regime rim --regime degenerate --count 150"
        cases = self.succeed("cases", *line.split())
        for wrong in ("right", "false hit", "part", "3 ulps", "accepts", "nan"):
            put("answers", self.run_program(program=ON_A_PIPE[1], input=cases, wrong=wrong).stdout)
            first, *others = (self.rows(subject, line, wrong=wrong) for subject in
                              (ONE, MANY, *PROGRAMS, ["--answers", "answers"]))
            for other in others:
                self.assertEqual(first, other, wrong)

    def test_tier_is_its_own_line(self):
        """judge --tier against answer --tier, over all shapes and regimes."""
        line = "--count 40 --seed 5"
        cases = self.succeed("cases", *line.split())
        for name in ("textbook", "exact"):
            answers = self.succeed("answer", "--tier", name, input=cases)
            self.assertEqual(len(answers.splitlines()), len(cases.splitlines()))
            put("answers", answers)
            by_tier = self.rows(tier(name), line)
            self.assertEqual(self.rows(["--answers", "answers"], line), by_tier)
            self.assertEqual(sum(row["wrong"] for row in by_tier) == 0, name == "exact")

    def test_the_table_says_what_the_json_says(self):
        line = "--shape cone --regime rim --regime degenerate --count 300 --untimed"
        said = self.succeed("judge", *tier("textbook"), *line.split(), "--json", "verdict.json")
        for row in loaded("verdict.json")["rows"]:
            self.assertEqual(row["valid"] < row["cases"], row["regime"] == "degenerate")
            first, second = ([part.split() for part in line.split("|")] for line in
                             said.splitlines() if line.startswith(f"cone      {row['regime']} "))
            wrong, counts = 100 * row["wrong"] / row["valid"], row["faults"]
            self.assertEqual(first[0][2:], [
                f"{wrong:.2f}", f"{100 * row['wrong_from']:.3g}", "..",
                f"{100 * row['wrong_to']:.3g}", str(counts["false hit"]),
                str(counts["false miss"]), str(counts["wrong part"])])
            self.assertNotEqual(counts["false hit"], counts["false miss"])
            self.assertEqual([float(word) for word in first[1][:4]],
                             [float(f"{row['t_ulps'][key]:.2e}")
                              for key in ("median", "99", "99.99", "most")])
            self.assertEqual(second[0][2:], [str(count) for count in
                                             row["decisions"]["wrong"].values()])
            self.assertEqual(second[1], [f"{100 * one['wrong'] / row['valid']:.3g}"
                                         for one in row["margins"]["wrong"]])
            self.assertEqual(second[2], [f"{row['margins']['most']:.2g}"])
        self.assertTrue(any(one["wrong"] > 0 for one in row["margins"]["wrong"]) or
                        row["regime"] == "degenerate")

    def test_shares_of_right_hits_in_the_table(self):
        """100 are all of them."""
        case = "plane 0 0 1 0 0 -1 0 inf 0 0 0 0 0 1\n"
        for right, said in (9999, "99.99"), (10000, ">99.99"):
            put("answers", "hit 1 surface 0 0 1\n" * right +
                "hit 0x1.0000000000001p+0 surface 0 0 1\n")
            text = self.ask(0, "judge", "--answers", "answers", "--cases", "-",
                            input=case * (right + 1)).stdout
            _, t, normals = re.search("(?m)^plane +given .*", text)[0].split("|")
            self.assertEqual((t.split(), normals.split()),
                             (["0", "0", "0", "1", said], ["0", "100"]))

    def test_the_head_says_what_it_is(self):
        """What is no evidence, and whose time is not of answers alone."""
        line = "--shape plane --regime typical --count 1"
        words = [line] + HAS_REFERENCE * [line + " --truth reference"]
        for subject in (tier("textbook"), tier("certain"), ONE, *PROGRAMS):
            for one in words:
                said = self.succeed("judge", *subject, *one.split(), "--json", "verdict.json")
                self.assertEqual(loaded("verdict.json")["time_includes_text"], subject in PROGRAMS)
                self.assertEqual(", lines read and written included" in said, subject in PROGRAMS)
                self.assertEqual("no independent evidence" in said,
                                 subject == tier("certain") and one == line)

    def test_breaches_in_words(self):
        """What is not asked counts, and what is refused is told, which is none."""
        line = "--shape sphere --regime typical --count 400"
        for wrong, names in ("refuses", ["valid refused"]), ("always aborts", ["crash"]):
            said = self.succeed("judge", *ONE, *line.split(), "--json", "verdict.json", wrong=wrong)
            (row,) = loaded("verdict.json")["rows"]
            self.assertEqual(row["unasked"] > 0, wrong != "refuses")
            told = [f"{name} {row['faults'][name]}" for name in names]
            told += [f"given up, not asked {row['unasked']}"] if row["unasked"] else []
            sum_of = row["faults"]["crash"] + row["unasked"]
            self.assertIn(f"\nBreaches of the contract: {sum_of}\n"
                          f"  sphere typical: {', '.join(told)}\n", said)

    def test_deterministic_by_seed(self):
        line = "--shape sphere --count 200 --seed "
        first = self.rows(tier("float32"), line + "1")
        self.assertEqual(first, self.rows(tier("float32"), line + "1"))
        self.assertNotEqual(first, self.rows(tier("float32"), line + "2"))

    def test_cases_by_seed(self):
        words = "cases --shape cone --regime apex --count 20 --seed".split()
        first = self.succeed(*words, "1")
        self.assertEqual(first, self.succeed(*words, "1"))
        self.assertNotEqual(first, self.succeed(*words, "2"))
        self.assertEqual(len(set(first.splitlines())), 20)
        self.assertTrue(all(line.startswith("cone ") for line in first.splitlines()))

    def test_all_pairs(self):
        lines = self.succeed("cases", "--count", "1").splitlines()
        rows = self.rows(tier("certain"), "--count 1")
        self.assertEqual([line.split()[0] for line in lines], [row["shape"] for row in rows])
        self.assertEqual(len({(row["shape"], row["regime"]) for row in rows}), len(rows))

    def test_given_cases(self):
        """Of several shapes, in any order: a row for each, the same in a file as on a pipe."""
        cases = self.succeed("cases", "--regime", "tangent", "--count", "30").splitlines()
        mixed = "\n".join(sorted(cases, key=lambda line: line[::-1])) + "\n"
        put("cases", mixed)
        by_file = self.rows(tier("textbook"), "--cases cases")
        self.assertEqual(by_file, self.rows(tier("textbook"), "--cases -", input=mixed))
        made = self.rows(tier("textbook"), "--regime tangent --count 30")
        self.assertEqual([(row["shape"], row["regime"], row["wrong"]) for row in by_file],
                         [(row["shape"], "given", row["wrong"]) for row in made])

    def test_given_cases_with_their_regimes(self):
        """Whatever their order, and whatever is behind the others; a row each, as when made."""
        line = "--shape disc --shape cone --regime rim --regime apex --regime far --count 50"
        named = self.succeed("cases", "--named", *line.split())
        plain = self.succeed("cases", *line.split())
        self.assertEqual(re.sub(" # .*", "", named), plain)
        lines = sorted(named.splitlines(), key=lambda one: one[::-1])
        lines += [one + more for one in plain.splitlines()[:3]
                  for more in ("", " # ", " #rimm # rim", " # apex")]  # of a disc
        put("cases", "\n".join(lines) + "\n")
        *discs, given, apex, far, rim = self.rows(tier("textbook"), "--cases cases")
        self.assertEqual((given["shape"], given["regime"], given["cases"]), ("disc", "given", 12))
        made = self.rows(tier("textbook"), line)
        for one, other in zip([*discs, apex, far, rim], made, strict=True):
            for key in ("shape", "regime", "cases", "faults", "t_ulps_by_powers_of_two"):
                self.assertEqual(one[key], other[key])

    def test_given_cases_by_file_of_answers(self):
        """What isn't asked for has an answer, too."""
        cases = self.succeed("cases", *"--named --shape disc --shape cone --count 9".split())
        put("answers", self.succeed("answer", "--tier", "textbook", input=cases))
        words = "--shape cone --regime rim --regime far"
        by_answers = self.rows(["--answers", "answers"], words + " --cases -", input=cases)
        self.assertEqual(by_answers, self.rows(tier("textbook"), words + " --count 9"))
        text = self.ask(0, "judge", "--answers", "answers", "--cases", "-", *words.split(),
                        input=cases).stdout
        left_out = len(cases.splitlines()) - 18
        self.assertIn(f"of other shapes or regimes, left out: {left_out}\n", text)

    def test_sets(self):
        """Each the same as by its seed, and whole: its SHA-256 is that of its lines."""
        line = "--shape plane --regime typical --regime far"
        page = contents(os.path.join(ROOT, "docs/judge.md")).decode()
        for name, pairs in ("2026.1", 136), ("2026.2", 142):
            verdict = self.judge(tier("float32"), f"{line} --set {name}")
            named = verdict["set"]
            self.assertEqual(named["name"], name)
            lines = self.succeed("cases", "--set", name)
            self.assertEqual(named["sha256"], hashlib.sha256(lines.encode()).hexdigest())
            self.assertIn(f"`{named['sha256']}`", page)
            self.assertEqual(len(lines.splitlines()), pairs * 1000)
            seeded = self.judge(tier("float32"),
                                f"{line} --count 1000 --seed {verdict['seed']}")
            self.assertIsNone(seeded["set"])
            self.assertEqual([row["faults"] for row in verdict["rows"]],
                             [row["faults"] for row in seeded["rows"]])

    def test_who(self):
        """By its own words, by surehit's, and by its command."""
        line = "--shape sphere --regime typical --count 1"
        version = self.succeed("--version").split()
        for subject, *words in ((SOME, "Spheres & <co>", "2.1", None),
                                (tier("stable"), *version, None), (ONE, None, None, None),
                                (ON_A_PIPE, ON_A_PIPE[1], None, None)):
            said = self.judge(subject, line)
            self.assertEqual(said["judge"], version[1])
            self.assertEqual([said["name"], said["version"]], words[:2])
            self.assertEqual(said["build"], said["judge_build"] if "stable" in subject else None)
        self.assertIn("\nCandidate: Spheres & <co> 2.1\n", self.succeed("judge", *SOME))

    def test_lengths(self):
        """Of the rays of pictures alone; what is given has no picture, which the text says."""
        line = "--shape box --regime camera --regime rim --count 100"
        camera, rim = self.rows(tier("textbook"), line)
        single, _ = self.rows(tier("float32"), line)
        for name in ("t_extents", "t_pixels"):
            self.assertEqual(rim[name]["hits"], 0)
            self.assertEqual(camera[name]["hits"], camera["t_ulps"]["hits"])
            self.assertTrue(0 < camera[name]["99"] <= camera[name]["most"] < single[name]["99"])
        block = r"Errors of t as lengths.*\n.*\n\n(.*\n)(box .*\n)\n"
        chords = self.row(tier("textbook"), "--shape sphere --regime camera --query interval")
        self.assertTrue(0 < chords["t_pixels"]["hits"] < chords["t_extents"]["hits"])
        self.assertTrue(0 < chords["t_pixels"]["99"] <= chords["t_pixels"]["most"] < 1)
        head, found = re.search(block, self.succeed("judge", *tier("textbook"), *line.split())) \
            .groups()
        self.assertEqual([float(word) for word in found.split()[1:]],
                         [float(f"{camera[name][key]:.2e}") for name in ("t_extents", "t_pixels")
                          for key in ("median", "99", "99.99", "most")])
        self.assertLessEqual(max(len(head), len(found)), 81)
        given = self.succeed("cases", *line.split())
        text = self.succeed("judge", *tier("textbook"), "--cases", "-", input=given)
        self.assertEqual(re.search(block, text)[2].split(), ["box"] + 8 * ["-"])

    def test_float_inputs(self):
        """Not blamed for the rounding of its inputs: what is beyond floats is not asked."""
        typical, huge = self.rows(FLOAT, "--shape sphere --regime typical --regime huge "
                                         "--count 300")
        self.assertEqual((typical["wrong"], typical["skipped"]), (0, 0))
        self.assertEqual(typical["t_ulps"]["most"], 0)
        self.assertEqual((huge["cases"], huge["skipped"]), (0, 300))
        line = "--shape sphere --regime grazing --count 2000"
        unrounded = self.row(tier("float32"), line + " --inputs double")
        rounded = self.row(tier("float32"), line)
        self.assertGreater(unrounded["wrong"], rounded["wrong"])
        self.assertGreater(unrounded["t_ulps"]["median"], 2**20)
        self.assertLess(rounded["t_ulps"]["median"], 2**10)

    def test_what_is_not_asked_is_no_share(self):
        """Nor a breach."""
        line = "--shape sphere --regime typical --regime degenerate --count 20"
        text = self.succeed("judge", *tier("textbook"), *line.split(), "--entry",
                            "unit,scale=1..100")
        shares = [row.split() for row in re.findall("(?m)^sphere +degenerate +(.*)", text)]
        self.assertEqual([shares[0][:4], shares[1][:2], shares[1][-8:]],
                         [["-", "0", "0", "0"], ["20", "0"], [*"------|-"]])
        self.assertRegex(text, "\nBreaches of the contract: 0\n\nNot asked, since they are not in "
                               "the entry or invalid as floats\n(  sphere typical: .*\n)?"
                               "  sphere degenerate: 20\n\n")

    def test_tiers_in_floats(self):
        """certain and exact have functions of their own for floats: t is a float, rounded
        correctly."""
        words = "--count 40 --inputs float --require decisions,contract,t<=0ulp,normal<="
        for name, normal in ("certain", "1ulp"), ("exact", "0.5ulp"):
            rows = self.rows(tier(name), words + normal)
            self.assertEqual({row["shape"] for row in rows}, set(SHAPES))
            self.assertGreater(sum(row["hits"] for row in rows), 1000)
            self.assertGreater(max(row["t_relative"]["most"] for row in rows), 2**-26)

    def test_times(self):
        for subject in (tier("stable"), ONE, *PROGRAMS):
            row = self.row(subject, "--shape disc --regime typical --count 2000")
            self.assertTrue(all(time > 0 for time in row["nanoseconds"].values()), subject)
            self.assertNotIn("building", row["nanoseconds"])

    def test_time_of_building(self):
        """Apart, and said."""
        words = "--shape sphere --regime typical --count 2000"
        times = self.row(PREPARED, words)["nanoseconds"]
        self.assertGreater(times["building"], 0)
        self.assertRegex(self.succeed("judge", *PREPARED, *words.split()),
                         r"(?m)^sphere +typical .*, built in \d+$")

    def test_shapes_of_a_library(self):
        rows = self.rows(SOME, "--regime typical --count 10")
        self.assertEqual([row["shape"] for row in rows], ["sphere"])

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_reference_as_truth(self):
        by_exact = self.rows(tier("textbook"), "--count 4 --seed 3")
        verdict = self.judge(tier("textbook"), "--count 4 --seed 3 --truth reference")
        self.assertEqual(verdict["truth"], "reference")
        for row in verdict["rows"]:
            del row["nanoseconds"]
        self.assertEqual(by_exact, verdict["rows"])


# A tier in somebody's library, without a branch on the answer, which would be paid for.
ZEROS = r"""
import sys
if sys.argv[1:]:
    print("ready\n", flush=True)
for line in sys.stdin:
    print("\n" if line == "\n" else "miss\0\n", end="", flush=sys.argv[1:])
"""

SLOW = """
#include <surehit/candidate.h>
#include <unistd.h>
const int sure_candidate_version = SURE_CANDIDATE_VERSION;
void sure_candidate_disc_many(int count, const double *rays, const double *discs,
                              int *statuses, sure_candidate_hit *hits)
{
    (void)rays, (void)discs, (void)hits;
    for (int i = 0; i < count; i++)
        statuses[i] = SURE_CANDIDATE_MISS;
    usleep(10000 * count);
}
"""

HANGS_BELOW = """
#include <surehit/candidate.h>
#include <stdio.h>
#include <unistd.h>
const int sure_candidate_version = SURE_CANDIDATE_VERSION;
int sure_candidate_disc(const double *ray, const double *disc, sure_candidate_hit *hit)
{
    double over = 0, along = 0;
    for (int i = 0; i < 3; i++) {
        over += (disc[i] - ray[i]) * disc[3 + i];
        along += ray[3 + i] * disc[3 + i];
    }
    if (ray[7] < 1e300) {
        FILE *told = fopen("hangs", "a");
        fputs("hangs\\n", told);
        fclose(told);
        for (;;)
            sleep(1);
    }
    hit->t = over / along * 1.5;
    return hit->t >= ray[6] ? SURE_CANDIDATE_HIT : SURE_CANDIDATE_MISS;
}
"""

SPOILS = """
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <surehit/candidate.h>
const int sure_candidate_version = SURE_CANDIDATE_VERSION;
int sure_candidate_disc(const double *ray, const double *disc, sure_candidate_hit *hit)
{
    static int asked;
    char line[512], *from, *to;
    FILE *maps = ++asked == 7 ? fopen("/proc/self/maps", "r") : NULL;
    (void)ray, (void)disc, (void)hit;
    while (maps && fgets(line, sizeof line, maps))
        if (strstr(line, " rw-s ") && sscanf(line, "%p-%p", (void **)&from, (void **)&to) == 2)
            memset(from, 0x7f, to - from);
    if (maps)
        abort();
    return SURE_CANDIDATE_MISS;
}
"""

SPOILS_ON = """
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <surehit/candidate.h>
const int sure_candidate_version = SURE_CANDIDATE_VERSION;
static struct { char *from, *to; } shared[9];
static volatile int rounds;
static void *spoil(void *none)
{
    for (;; rounds = 1)
        for (int i = 0; i < 9; i++)
            if (shared[i].from)
                memset(shared[i].from, BYTE, shared[i].to - shared[i].from);
    return none;
}
int sure_candidate_disc(const double *ray, const double *disc, sure_candidate_hit *hit)
{
    static int asked, found;
    char line[512];
    pthread_t thread;
    FILE *maps = ++asked == 7 ? fopen("/proc/self/maps", "r") : NULL;
    (void)ray, (void)disc;
    while (maps && found < 9 && fgets(line, sizeof line, maps))
        if (strstr(line, " rw-s "))
            found += sscanf(line, "%p-%p", (void **)&shared[found].from,
                            (void **)&shared[found].to) == 2;
    if (maps && pthread_create(&thread, NULL, spoil, NULL) == 0)
        while (!rounds)
            ;
    hit->t = 1;
    return asked % 2;
}
"""

JOINS = """
import os, sys, time
os.setpgid(0, os.getpgid(os.getppid()))
if "--keep" not in sys.argv:
    time.sleep(1000)
print("ready sphere\\n", flush=True)
for line in sys.stdin:
    print("miss" if line.strip() else "", flush=True)
"""

TWO_ENDS = """
#include <stdlib.h>
#include <surehit/candidate.h>
#include <unistd.h>
const int sure_candidate_version = SURE_CANDIDATE_VERSION;
int sure_candidate_disc(const double *ray, const double *disc, sure_candidate_hit *hit)
{
    static int asked;
    (void)ray, (void)disc, (void)hit;
    if (++asked < 7)
        return SURE_CANDIDATE_MISS;
    if (HELPER && fork() == 0)
        for (;;)
            pause();
    if (HELPER)
        abort();
    for (int i = 0; i < 100; i++)
        close(i);
    for (;;)
        pause();
}
"""

SAME = """
#include <surehit/candidate.h>
#include <surehit/surehit.h>
const int sure_candidate_version = SURE_CANDIDATE_VERSION;
#define SAME(tier, shape) \\
    int sure_candidate_##shape(const double *ray, const double *shape, sure_candidate_hit *hit) \\
    { \\
        const sure_ray *r = (const void *)ray; \\
        const sure_##shape *o = (const void *)shape; \\
        sure_hit found = {hit->t, 0, (sure_part)hit->part}; \\
        sure_status status = sure_##shape##_hit_##tier(r, o, &found); \\
        hit->t = found.t, hit->part = (int)found.part; \\
        if (NORMALS && status == SURE_HIT) { \\
            sure_vec3 n = sure_##shape##_normal_##tier(r, o, &found); \\
            hit->normal[0] = n.x, hit->normal[1] = n.y, hit->normal[2] = n.z; \\
        } \\
        return (int)status; \\
    }
#define OF(tier, shape) SAME(tier, shape)
#define EACH(shape, SHAPE) OF(TIER, shape)
SURE_EACH_SHAPE(EACH)
"""


class Times(InFolder):
    """All are called and timed in one way. What scatters is a tenth, and to hand a hit on costs a
    library a few nanoseconds more; what was once unlike, was so by a factor of two and three."""

    def ratio(self, above, below, subject):
        """The median of the shapes."""
        rows = self.judge(subject, "--regime typical --count 20000")["rows"]
        self.assertEqual(len(rows), len(SHAPES))
        return statistics.median(row["nanoseconds"][above] / row["nanoseconds"][below]
                                 for row in rows)

    def check_alike(self, ratio, what):
        """Once of five times: on a busy machine one may be off, but what is unlike is so always."""
        ratios = []
        while len(ratios) < 5:
            ratios.append(ratio())
            if 5 / 8 < ratios[-1] < 8 / 5:
                return
        self.fail((ratios, what))

    def test_a_tier_is_as_fast_as_itself(self):
        for name in ("textbook", "certain"):
            self.check_alike(lambda: self.ratio("candidate", name, tier(name)), name)

    def test_a_library_is_as_fast_as_the_tier_it_calls(self):
        for name in ("textbook", "certain"):
            for normals in (0, 1):
                subject = self.build_same(name, normals)
                self.check_alike(lambda: self.ratio("candidate", name, subject), (name, normals))

    def test_who_gives_no_normals_is_beside_tiers_that_give_none(self):
        """Tiers too are timed without."""
        subject = self.build_same("textbook", 0)
        self.check_alike(lambda: self.textbook(tier("exact")) / self.textbook(subject), "a tier")
        without, normals = (min(self.textbook(self.build_same("textbook", normals))
                                for _ in range(4)) for normals in (0, 1))  # load adds time alone
        self.assertGreater(normals / without, 4 / 3)

    def textbook(self, subject):
        """Its time beside the candidate, in all."""
        rows = self.judge(subject, "--regime typical --count 20000")["rows"]
        return sum(row["nanoseconds"]["textbook"] for row in rows)

    def build_same(self, name, normals):
        """The words for it."""
        put("same.c", SAME)
        library = os.path.join(os.path.dirname(os.path.dirname(PROGRAM)), "libsurehit.so")
        if not os.path.exists(library):
            self.skipTest("a static libsurehit")
        subprocess.run([*CC, "-O2", "-shared", "-fPIC", f"-DTIER={name}", f"-DNORMALS={normals}",
                        "-I", os.path.join(ROOT, "include"), "same.c", "-o", "same.so", library,
                        "-Wl,-rpath," + os.path.dirname(library)], check=True)
        return "--candidate", "./same.so"


@unittest.skipUnless(shutil.which("valgrind"), "valgrind is not installed")
class Instructions(InFolder):
    """Bench, judge and report count the same first cases: they differ by their loops."""

    LINE = "--shape plane --shape cone --regime camera --instructions"
    LOOP = 20

    def counted(self, subject, line=""):
        """By shape."""
        return [row["instructions"] for row in
                self.judge(subject, f"{self.LINE} --count 515 {line}")["rows"]]

    def test_they_repeat(self):
        first = self.counted(ONE)
        self.assertGreater(min(min(of.values()) for of in first), 50)
        self.assertEqual(self.counted(ONE), first)

    def test_all_say_the_same(self):
        line = self.LINE.split()
        self.succeed("bench", *line, "--rays=mixed", "--tier=exact", "--cases=600", "--repeats=1",
                     "--json", "bench.json")
        self.succeed("report", *line, "--tier=exact", "--count=103", "--quiet", "-o", "r.html",
                     "--json", "report.json")
        judged = [of["candidate"] for of in self.counted(tier("exact"))]
        reported = [row["instructions"] for row in loaded("report.json")["candidates"][0]["rows"]]
        timed = [row["instructions"] for row in loaded("bench.json")["results"]
                 if row["tier"] == "exact"]
        for a, b, c in zip(judged, reported, timed, strict=True):
            self.assertAlmostEqual(a, b, delta=1)
            self.assertAlmostEqual(a, c, delta=self.LOOP)

    def test_text(self):
        words = f"--tier textbook {self.LINE} --count 9"
        text = self.succeed("judge", *words.split())
        self.assertIn(" |  instr textb  cert\n", text)
        row = re.search(r"(?m)^cone +camera .* \| +(\d+) +(\d+) +\d+$", text)
        self.assertAlmostEqual(int(row[1]), int(row[2]), delta=1)  # as they are rounded

    def test_who_is_not_counted(self):
        for words in ([*ON_A_PIPE], ["--answers", "x"], [*ONE, "--cases", "-"]):
            self.fail_with(WRONG_USAGE, "surehit judge: error: instructions are counted of .*",
                           "judge", *words, "--instructions")
        put("cases", self.succeed("cases", "--shape", "plane", "--count", "1"))
        self.fail_with(BROKEN, "surehit judge: error: valgrind is missing, .*", "judge", *ONE,
                       "--cases", "cases", "--instructions", env={"PATH": "/nowhere"})


class Requirements(InFolder):
    line = "--shape cylinder --regime typical --count 200 --require "

    def test_kept_or_broken(self):
        """Each of them, where that goes wrong."""
        for wrong, what, *kept in (
                ("right", "decisions,contract,t<=0ulp,normal<=0ulp,t<=0", *5 * [True]),
                ("false hit", "decisions", False), ("part", "decisions<=0.001", False),
                ("3 ulps", "t<=2ulp", False), ("3 ulps", "t<=1e-16", False),
                ("normal", "normal<=4ulp", False), ("normal", "normal<=1e-7", False),
                ("touches", "contract", False), ("aborts", "contract,decisions", False, False),
                ("leaks", "contract", False), ("range", "contract", False),
                ("nan", "t<=1e300ulp", False), ("3 ulps", "t<=3ulp", True),
                ("false miss", "decisions<=0.2", True),
                ("3 ulps", "decisions,t<=0ulp", True, False)):
            verdict = self.judge(ONE, self.line + what, wrong=wrong,
                                 status=0 if all(kept) else BROKEN)
            self.assertEqual([one["kept"] for one in verdict["required"]], kept, (wrong, what))

    def test_text(self):
        words = (self.line + "decisions,t<=2ulp").split()
        said = self.ask(BROKEN, "judge", *ONE, *words, wrong="3 ulps").stdout
        self.assertIn("kept    decisions", said)
        for never_broken in ("decisions<=50", "t<=inf", "t<=infulp", "normal<=1e999"):
            self.refuse(f"--require '{never_broken}'", "judge", *ONE, "--require", never_broken)
        self.assertIn("BROKEN  t<=2ulp: cylinder typical: 3", said)

    def test_nothing_to_compare(self):
        """What is told of none is not kept."""
        said = self.ask(BROKEN, "judge", *OTHERS[0], *self.line.split(), "t<=2ulp", "--query",
                        "occluded").stdout
        self.assertIn("\n  BROKEN  t<=2ulp: there is none to compare\n", said)
        put("answers", "hit 1\n")
        said = self.ask(BROKEN, "judge", "--answers", "answers", "--cases", "-", "--require",
                        "normal<=1ulp", input="plane 0 0 1 0 0 -1 0 inf 0 0 0 0 0 1\n").stdout
        self.assertIn("\n  BROKEN  normal<=1ulp: plane given: inf, none is told\n", said)


class ForOthers(InFolder):
    """JUnit's XML and SARIF, as those read them that show them."""

    ROWS = "--regime typical --regime rim --shape sphere --shape cone"
    LINE = " --count 200 --junit it.xml --sarif it.sarif"

    def written(self, subject, line="", rows=ROWS, **more):
        verdict = self.judge(subject, rows + self.LINE + line, **more)
        suites = xml.etree.ElementTree.parse("it.xml").getroot()
        self.assertEqual(suites.tag, "testsuites")
        (suite,) = suites
        self.assertEqual(suite.get("name"), verdict["candidate"])
        cases = suite.findall("testcase")
        for all_of in (suites, suite):
            self.assertEqual([int(all_of.get(key)) for key in ("tests", "failures", "errors")],
                             [len(cases), len(suite.findall("testcase/failure")), 0])
        self.assertEqual(int(suite.get("skipped")), len(suite.findall("testcase/skipped")))
        said = {one.get("name"): one.get("value") for one in suite.find("properties")}
        for key in ("name", "version", "build", "judge", "truth"):
            self.assertEqual(said.get(key), verdict[key])
        self.assertEqual((said.get("seed"), said.get("cases")), (str(verdict["seed"]), None))
        return verdict, cases, self.results(verdict)

    def results(self, verdict):
        """SARIF 2.1.0: what it and those who show it require."""
        log = loaded("it.sarif")
        self.assertEqual(set(log), {"$schema", "version", "runs"})
        self.assertEqual(log["version"], "2.1.0")
        (run,) = log["runs"]
        driver = run["tool"]["driver"]
        self.assertEqual((driver["name"], driver["version"]), ("surehit judge", verdict["judge"]))
        self.assertEqual(run["properties"], {key: verdict[key] or "" for key in
                                             ("candidate", "name", "version", "build")})
        rules = [rule["id"] for rule in driver["rules"]]
        self.assertEqual(len(rules), len(set(rules)))
        for one in run["results"]:
            self.assertIn(one["ruleId"], rules)
            self.assertEqual(one["level"], "error")
            self.assertTrue(one["message"]["text"])
            (place,) = one["locations"]
            self.assertTrue(place["logicalLocations"][0]["fullyQualifiedName"])
        keys = [one["partialFingerprints"]["row/v1"] for one in run["results"]]
        self.assertEqual(len(keys), len(set(keys)))
        return run["results"]

    def test_nothing_is_required(self):
        """A row is a test case, and none fails; breaches are told."""
        verdict, cases, results = self.written(ONE, wrong="touches")
        self.assertEqual([(one.get("classname"), one.get("name")) for one in cases],
                         [(row["shape"], row["regime"]) for row in verdict["rows"]])
        self.assertEqual([one["ruleId"] for one in results], 3 * ["outputs-touched"])
        self.assertEqual([one["message"]["text"].split(": ")[1].splitlines()[0]
                          for one in results],
                         [f"{row['faults']['outputs touched']} of {row['cases']} cases"
                          for row in verdict["rows"]])
        verdict, cases, _ = self.written(ONE, rows="--regime degenerate --shape cone")
        (row,) = verdict["rows"]
        self.assertLess(row["valid"], row["cases"])
        self.assertEqual(cases[0].find("system-out").text,
                         f"wrong {row['wrong']} of {row['valid']}")
        self.assertEqual(self.written(ONE)[2], [])

    def test_what_is_required(self):
        """The case that is shown does it again."""
        require = " --require decisions@1e-9,contract,t<=2ulp"
        for wrong, rules in (("false hit", {"decisions@1e-09"}), ("3 ulps", {"t<=2ulp"}),
                             ("leaks", {"contract", "leak"}), ("right", set())):
            verdict, cases, results = self.written(ONE, require, wrong=wrong,
                                                   status=BROKEN if rules else 0)
            self.assertEqual([one["kept"] for one in verdict["required"]],
                             [one["promise"] not in rules for one in verdict["required"]])
            self.assertEqual([(one.get("classname"), one.get("name")) for one in cases],
                             [(row["shape"], f"{row['regime']}: {one['promise']}")
                              for one in verdict["required"] for row in verdict["rows"]])
            self.assertEqual({one["ruleId"] for one in results}, rules)
            failures = [one.text for case in cases for one in case.findall("failure")]
            messages = [one["message"]["text"].split("\ncase    ")[1] for one in results
                        if one["ruleId"] not in ("leak",)]
            self.assertEqual(failures, messages)
            words = f"cases --named --count 200 {self.ROWS}".split()
            lines = self.succeed(*words).split("\n")
            for case in cases:
                for text in (one.text for one in case.findall("failure")):
                    line = text.split("\n")[0]
                    self.assertIn(f"{line} # {case.get('name').split(':')[0]}", lines)
                    self.assertEqual(line.split()[0], case.get("classname"))
                    row = self.alone(ONE, line, wrong=wrong)
                    self.assertTrue(self.found(row) or row["t_ulps"]["most"] == 3)

    def test_where_it_is(self):
        name = "./100% & \"so\" <it>.so"
        shutil.copy(SOME[1], name)
        (place,), *_ = (one["locations"] for one in self.written(
            ["--candidate", name], " --require decisions", rows="--regime typical",
            wrong="false hit", status=BROKEN)[2])
        self.assertEqual(place["physicalLocation"]["artifactLocation"]["uri"],
                         "100%25%20%26%20%22so%22%20%3Cit%3E.so")
        self.assertEqual(place["logicalLocations"], [{"fullyQualifiedName": "sphere typical"}])
        (place,) = self.written(SOME, " --require decisions", rows="--regime typical",
                                wrong="false hit", status=BROKEN)[2][0]["locations"]
        self.assertEqual(place["physicalLocation"]["artifactLocation"]["uri"],
                         pathlib.PurePath(SOME[1]).as_uri())
        place, = self.written(tier("float32"), " --require t<=0ulp",
                              status=BROKEN)[2][0]["locations"]
        self.assertNotIn("physicalLocation", place)

    def test_given_cases(self):
        """A breach is shown where the contract is broken, though another case is wrong, too."""
        put("cases", "sphere 0 9 9 0 0 -1 0 inf 0 0 0 1\nsphere 0 0 9 0 0 0 0 inf 0 0 0 1\n")
        put("answers", "hit 9\nmiss\n")
        verdict = self.judge(["--answers", "answers"], "--cases cases --require contract"
                             " --junit it.xml --sarif it.sarif", status=BROKEN)
        self.assertEqual(verdict["count"], 0)
        (suite,) = xml.etree.ElementTree.parse("it.xml").getroot()
        said = {one.get("name"): one.get("value") for one in suite.find("properties")}
        self.assertEqual((said.get("cases"), said.get("seed")), ("cases", None))
        failure = suite.find("testcase/failure")
        self.assertEqual((failure.get("type"), failure.get("message")), ("contract", "1"))
        shown = ["answer  miss", "right   invalid d"]
        self.assertEqual(failure.text.splitlines()[1:], shown)
        told = [one["message"]["text"].splitlines() for one in self.results(verdict)]
        self.assertEqual([(lines[0], lines[2:]) for lines in told],
                         [("invalid accepted, sphere given: 1 of 2 cases", shown),
                          ("contract, sphere given: 1", shown)])

    def test_any_answer(self):
        command = ["--command", "sed 's/.*/a<b\\x01\\xff/'"]
        *_, result = self.written(command, " --require contract", status=BROKEN)[2]
        self.assertIn("\nanswer  ", result["message"]["text"])

    def test_no_case_is_no_pass(self):
        """Of floats nothing is left; where that is all there is, it is no verdict."""
        line = "--shape sphere --regime huge --count 9 --require decisions"
        self.judge(FLOAT, line + ",t<=2ulp --regime typical --junit it.xml")
        (suite,) = xml.etree.ElementTree.parse("it.xml").getroot()
        self.assertEqual([(case.get("name").split(":")[0], [one.tag for one in case])
                          for case in suite.iter("testcase")],
                         2 * [("typical", []), ("huge", ["skipped"])])
        self.assertEqual((suite.get("tests"), suite.get("skipped")), ("4", "2"))
        far = "--shape sphere --regime on_surface --count 9 --entry line,apart=0.9"
        for subject, words in ((FLOAT, line), (tier("exact"), far)):
            result = self.ask(WRONG_USAGE, "judge", *subject, *words.split(), "--junit", "no.xml")
            self.assertIn("no case has the entry: none was asked", result.stderr)
            self.assertNotIn("kept", result.stdout)
            self.assertFalse(os.path.exists("no.xml"))


class Referee(InFolder):
    """Routines whose radius is off by a known share."""

    def row_with(self, share, shape):
        return self.row(ONE, f"--shape {shape} --regime grazing --count 3000",
                        env={**os.environ, "SUREHIT_RADIUS": repr(share)})

    def test_seeded_margins(self):
        for size in (1e-13, 1e-10, 1e-7, 1e-4, 5e-3, 0.4):
            for share in (size, -size):
                margins = self.row_with(share, "sphere")["margins"]
                self.assertEqual(margins["unit"], "size")
                for at in margins["wrong"]:
                    if at["beyond"] > size:
                        self.assertEqual(at["wrong"], 0, (share, at))
                    elif at["beyond"] < size / 4:
                        self.assertGreater(at["wrong"], 0, (share, at))
                self.assertLessEqual(margins["most"], size * (1 + 1e-9))
                if size > 1e-12:  # that regime's rays pass no farther than so
                    self.assertGreater(margins["most"], min(size / 4, 0.01))

    def test_other_seeded_shapes(self):
        for shape in ("disc", "cylinder"):
            for share in (1e-7, -1e-7, 5e-3, -5e-3):
                row = self.row_with(share, shape)
                self.assertGreater(row["wrong"], 0)
                self.assertLessEqual(row["margins"]["most"], abs(share) * (1 + 1e-9))
                self.assertGreater(row["margins"]["most"], abs(share) / 16)

    def test_worst_is_the_widest(self):
        """And stays as wide while it is made simple."""
        verdict = self.judge(ONE, "--shape sphere --regime grazing --count 3000",
                             env={**os.environ, "SUREHIT_RADIUS": "0.4"})
        hit, = (one for one in verdict["worst"] if one["kind"] == "false hit")
        self.assertGreater(hit["margin"], 0.3)
        again = self.row(ONE, "--cases -", input=hit["case"] + "\n",
                         env={**os.environ, "SUREHIT_RADIUS": "0.4"})
        self.assertGreaterEqual(again["margins"]["most"], 0.9 * hit["margin"])

    def test_required_at_a_margin(self):
        words = "--shape sphere --regime grazing --count 3000 --require "
        env = {**os.environ, "SUREHIT_RADIUS": "1e-7"}
        self.judge(ONE, words + "decisions@2e-7", env=env)
        self.judge(ONE, words + "decisions@1e-8", env=env, status=BROKEN)

    def test_faults_stay_valid(self):
        """What a valid case shows is shown by a valid one."""
        for wrong in ("garbage", "crashes", "nan", "refuses"):
            verdict = self.judge(ONE, "--shape sphere --regime typical --count 200", wrong=wrong)
            for one in verdict["worst"]:
                self.assertNotIn("invalid", one["right"], (wrong, one))


class Conventions(InFolder):
    def test_said_and_right(self):
        said = self.judge(tier("exact"), "--count 1")["conventions"]
        self.assertEqual(set(said), set(SHAPES))
        for one in said.values():
            self.assertTrue(all(word["says"] == word["contract"] for word in one.values()), one)
        right = {"touch": "hit", "inside": "exit", "surface, out": "0", "surface, in": "0",
                 "end": "hit"}
        solid = {name: {"says": word, "contract": word} for name, word in right.items()}
        for shape in SHAPES[2:]:
            self.assertEqual(said[shape], solid, shape)

    def test_others(self):
        """Who says miss to all; and who is asked no case that starts inside."""
        always = ["--command", "sed s/.*/miss/", "--shape", "cone"]
        said = self.judge(always, "--count 1")["conventions"]["cone"]
        self.assertEqual({one["says"] for one in said.values()}, {"miss"})
        always[1] = "sed s/.*/HIT:1/"
        said = self.judge(always, "--count 1")["conventions"]["cone"]
        self.assertEqual({one["says"] for one in said.values()}, {"garbage"})
        self.assertEqual(len(said), 5)
        decides = self.judge(always, "--count 1 --entry decision")["conventions"]["cone"]
        self.assertEqual({one["contract"] for one in decides.values()}, {"hit"})
        outside = self.judge(always, "--count 1 --entry outside")["conventions"]["cone"]
        self.assertEqual(set(outside), {"touch", "end"})


class Kept(InFolder):
    """What a program says when it is ready."""

    def kept(self, greeting, answer="s/..*/miss/"):
        put("kept", f"#!/bin/sh\nprintf '{greeting}'\nexec sed -u '{answer}'\n")
        os.chmod("kept", 0o755)
        return ["--command", "./kept", "--keep"]

    def test_shapes_and_entry(self):
        subject = self.kept("ready disc sphere\nunit, inside=miss\n\n")
        rows = self.rows(subject, "--regime inside --regime typical --count 20")
        self.assertEqual({row["shape"] for row in rows}, {"disc", "sphere"})
        inside = next(row for row in rows if row["regime"] == "inside")
        self.assertEqual((inside["wrong"], inside["faults"]["invalid accepted"]), (0, 0))

    def test_who_it_is(self):
        subject = self.kept("name=Mine version=1.2\nready build=ours\n\n")
        verdict = self.judge(subject, "--shape disc --regime typical --count 3")
        self.assertEqual([verdict[key] for key in ("name", "version", "build")],
                         ["Mine", "1.2", "ours"])

    def test_another_entry_is_said(self):
        subject = self.kept("ready sphere inside=miss\n\n")
        row = self.row(subject, "--regime inside --count 20 --entry unit")
        self.assertGreater(row["wrong"], 0)

    def test_line_ends(self):
        subject = self.kept("ready\r\n\r\n", "s/..*/miss\r/; s/^$/\r/")
        row = self.row(subject, "--shape sphere --regime typical --count 700")
        self.assertEqual((row["faults"]["garbage"], row["cases"], row["unasked"]), (0, 700, 0))

    def test_it_is_kept(self):
        """One start for all that is asked, and another one where it has ended."""
        def starts(answer):
            put("starts", "")
            put("kept", "#!/bin/sh\necho >> starts\nprintf 'ready\\n\\n'\n"
                        f"exec sed -u '{answer}'\n")
            self.judge(["--command", "./kept", "--keep"], "--shape cone --count 600")
            return contents("starts").count(b"\n")
        self.kept("")
        self.assertEqual(starts("s/..*/miss/"), 1)
        self.assertGreater(starts("s/..*/miss/; 700q"), 2)

    def test_lost_lines(self):
        """Too few or too many, in a block: the case is told."""
        for answer in ("d", "{s/.*/miss\\nmiss/; b}"):
            row = self.row(self.kept("ready\\n\\n", f"/0x1.2[0-7]/{answer}; s/..*/miss/"),
                           "--shape sphere --regime typical --count 60 --time-limit 1")
            self.assertEqual(self.found(row) - {"false miss"}, {"no answer"}, answer)

    @unittest.skipUnless(shutil.which("node"), "no Node")
    def test_node(self):
        """Beside its own time, which is none here, it takes little of a ray."""
        module = os.path.join(ROOT, "reference/peers/libraries/node/coprocess.mjs")
        put("none.mjs", f"import {{ serve }} from '{module}';\n"
                        "serve({ library: 'none', entry: 'unit ray' }, { sphere: () => null });\n")
        self.assertEqual(self.succeed("none.mjs", "--entry", program="node"), "unit ray\n")
        row = self.row(["--command", "node none.mjs", "--keep"], "--regime typical --count 50000")
        self.assertEqual(self.found(row), {"false miss"})
        self.assertLess(row["nanoseconds"]["candidate"], 2000)

    def test_slow(self):
        """Who is in time with each case, but not with a block of them, does not hang."""
        put("slow.py", "import sys, time\n"
                       "print('ready\\n', flush=True)\n"
                       "said = ''\n"
                       "for line in sys.stdin:\n"
                       "    if line > '\\n':\n"
                       "        time.sleep(0.02)\n"
                       "        said += 'miss\\n'\n"
                       "    else:\n"
                       "        print(said, flush=True)\n"
                       "        said = ''\n")
        row = self.row(["--command", f"{sys.executable} slow.py", "--keep"],
                       "--shape disc --regime typical --count 100 --time-limit 1")
        self.assertEqual((self.found(row), row["unasked"]), ({"false miss"}, 0))

    def test_slow_many(self):
        put("slow.c", SLOW)
        subprocess.run([*CC, "-shared", "-fPIC", "-I", os.path.join(ROOT, "include"), "slow.c",
                        "-o", "slow.so"], check=True)
        row = self.row(["--candidate", "./slow.so"],
                       "--shape disc --regime typical --count 100 --time-limit 0.4")
        self.assertEqual((self.found(row), row["unasked"]), ({"false miss"}, 0))

    def test_slow_start(self):
        """To be ready takes no answer's time."""
        subject = self.kept("ready\\n\\n")
        put("kept", contents("kept").decode().replace("printf", "sleep 2; printf"))
        row = self.row(subject, "--shape disc --regime typical --count 20 --time-limit 1")
        self.assertEqual((self.found(row), row["unasked"]), ({"false miss"}, 0))

    def test_not_ready(self):
        for greeting, pattern in (("", "does not say 'ready'"), ("hello\\n\\n", "does not say"),
                                  ("ready", "does not say 'ready'"),
                                  ("ready units\\n\\n", "says 'units ': expected binary, shapes")):
            self.fail_with(WRONG_USAGE, f".*{pattern}.*", "judge", *self.kept(greeting),
                           *"--shape disc --time-limit 0.2".split())
        self.fail_with(WRONG_USAGE, ".*'./nothing' cannot be started.*", "judge", "--command",
                       "./nothing", "--keep")
        self.fail_with(WRONG_USAGE, ".*--keep is for a --command.*", "judge", *ONE, "--keep")


LIBRARIES = os.path.join(ROOT, "reference/peers/libraries/node")


@unittest.skipUnless(shutil.which("node") and os.path.isdir(LIBRARIES + "/node_modules"),
                     "no libraries of npm: npm ci --prefix reference/peers/libraries/node")
class Libraries(InFolder):
    def test_each(self):
        """Judged to the end; what is right of everybody is right."""
        for name in ("three", "babylonjs", "cannon-es", "rapier", "jolt-physics"):
            adapter = os.path.join(LIBRARIES, name + ".mjs")
            about = json.loads(self.succeed(adapter, "--about", program="node"))
            self.assertEqual(self.succeed(adapter, "--entry", program="node").strip(),
                             about["entry"])
            rows = self.rows(["--command", f"node '{adapter}'", "--keep"],
                             "--regime typical --count 300")
            self.assertEqual({row["shape"] for row in rows}, set(about["shapes"]), name)
            for row in rows:
                self.assertLessEqual(self.found(row), set(FAULTS[:3]), (name, row["shape"]))
                self.assertEqual(row["unasked"], 0)
                if "float" not in about["entry"].split():
                    self.assertLess(row["wrong"], 3, (name, row["shape"]))


class Messages(InFolder):
    def judge_fails(self, pattern, subject, line="", **more):
        """Beneath the table's head, at most."""
        self.fail_with(WRONG_USAGE, f".*{pattern}.*", "judge", *subject, *line.split(),
                       stdout=subprocess.DEVNULL, **more)

    def test_no_candidate(self):
        put("text.so", "no library\n")
        for pattern, subject, line in (
                ("nowhere.so: cannot open shared object", ["--candidate", "nowhere.so"], ""),
                ("text.so: (file too short|invalid ELF header)", ["--candidate", "text.so"], ""),
                ("no symbol sure_candidate_version", candidate("none.so"), ""),
                ("sure_candidate_version is 2, expected 1", candidate("old.so"), ""),
                ("sure_candidate_plane_new without _prepared or _free", candidate("half.so"), ""),
                ("no symbol sure_candidate_cone", SOME, "--shape cone"),
                ("no symbol sure_candidate_sphere", FLOAT, "--shape sphere --inputs double"),
                ("'./nothing' cannot be started", ["--command", "./nothing"], ""),
                ("'exit 126' cannot be started", ["--command", "exit 126"], ""),
                ("is out of step: 1 lines for no case", ON_A_PIPE, "")):
            self.judge_fails(pattern, subject, line, wrong="greets")

    def test_a_line_for_nothing(self):
        """Who prints an empty line where there is no case is in step."""
        row = self.row(["--command", 'x=$(sed "s/.*/miss/"); echo "$x"'],
                       "--shape disc --regime typical --count 3")
        self.assertEqual((row["cases"], row["faults"]["no answer"]), (3, 0))

    def test_answers(self):
        line = "--shape disc --regime typical --count 3 --answers "
        self.judge_fails("standard input: too few answers: none to case 3", [], line + "-",
                         input="miss\nmiss\n")
        self.judge_fails("standard input: answers out of step: more than the 3 cases", [],
                         line + "-", input="miss\n" * 4)
        self.judge_fails("nothing: cannot be read: No such", [], line + "nothing")
        self.judge_fails("/tmp: answer 1: Is a directory", [], line + "/tmp")
        garbage = self.row([], line + "-", input="miss\n\nx" + 5000 * "y" + "\n")
        self.assertEqual(garbage["faults"]["garbage"], 2)
        for most in ("miss\0", "miss" + 5000 * " " + "x"):
            garbage = self.row([], line + "-", input=3 * (most + "\n"))
            self.assertEqual(garbage["faults"]["garbage"], 3)

    def test_ends_that_look_otherwise(self):
        """A crash whose pipe a helper holds is none that hangs; who closes all and goes on does;
        who spoils what tells the case has crashed somewhere."""
        put("ends.c", TWO_ENDS)
        for helper, fault in (1, "crash"), (0, "no answer in time"):
            subprocess.run([*CC, "-shared", "-fPIC", f"-DHELPER={helper}", "-I",
                            os.path.join(ROOT, "include"), "ends.c", "-o", "ends.so"], check=True)
            row = self.row(["--candidate", "./ends.so"],
                           "--shape disc --regime typical --count 8 --time-limit 0.2")
            self.assertGreater(row["faults"][fault], 0)
            self.assertEqual(row["faults"]["crash"] > 0, bool(helper))
        put("ends.c", SPOILS)
        subprocess.run([*CC, "-shared", "-fPIC", "-I", os.path.join(ROOT, "include"), "ends.c",
                        "-o", "ends.so"], check=True)
        row = self.row(["--candidate", "./ends.so"], "--shape disc --regime typical --count 20")
        self.assertGreater(row["faults"]["crash"], 0)

    def test_what_is_spoilt_is_garbage(self):
        """A thread writes over all that is shared, while answers are read. On a busy machine it
        may not run at that moment: then once more."""
        put("spoils.c", SPOILS_ON)
        for byte in (0, 65, 255):
            subprocess.run([*CC, "-shared", "-fPIC", "-pthread", f"-DBYTE={byte}", "-I",
                            os.path.join(ROOT, "include"), "spoils.c", "-o", "spoils.so"],
                           check=True)
            for _ in range(100):
                row = self.row(["--candidate", "./spoils.so"],
                               "--shape disc --regime typical --count 3000 --time-limit 1")
                self.assertEqual(row["cases"], 3000)
                broken = sum(row["faults"][name] for name in
                             ("garbage", "crash", "no answer in time", "no answer"))
                if byte == 0 or broken > 0: # a 0 is a miss
                    break
            self.assertTrue(byte == 0 or broken > 0, row)

    def test_who_joins_the_judge(self):
        """Its group, where a signal to its own does not reach it."""
        put("joins.py", JOINS)
        line = "--shape sphere --regime typical --count 9 --time-limit 0.1"
        for kept in ([], ["--keep"]):
            words = f"{sys.executable} joins.py {' '.join(kept)}"
            row = self.row(["--command", words, *kept], line)
            self.assertEqual(row["faults"]["no answer in time"] > 0, not kept)
            self.assertEqual(row["unasked"] == 0, bool(kept))

    def test_closed_streams(self):
        """Whoever is judged is judged alike."""
        for closed in (0, 1):
            row = self.judge(["--command", "sed s/.*/miss/"], ROW, status=closed,
                             preexec_fn=lambda closed=closed: os.close(closed))["rows"][0]
            self.assertEqual((row["faults"]["crash"], row["faults"]["no answer"]), (0, 0), closed)

    def test_a_byte_0_is_no_answer(self):
        """Nor the end of one, of a program that is kept or is not."""
        put("zeros.py", ZEROS)
        for kept in ([], ["--keep"]):
            row = self.row(["--command", f"{sys.executable} zeros.py {' '.join(kept)}", *kept],
                           "--shape sphere --regime typical --count 20")
            self.assertEqual((row["cases"], row["faults"]["garbage"]), (20, 20))

    def test_a_name_that_is_no_text(self):
        name = b"\xe9.so".decode(errors="surrogateescape")
        shutil.copy(os.path.join(CANDIDATES, "one.so"), name)
        said = self.judge(["--candidate", f"./{name}"],
                          f"{ROW} --sarif found.sarif --junit found.xml", errors="replace")
        self.assertEqual(said["candidate"], "./?.so")
        root = xml.etree.ElementTree.parse("found.xml").getroot()
        self.assertEqual([suite.get("name") for suite in root.iter("testsuite")], ["./?.so"])
        self.assertEqual(loaded("found.sarif")["runs"][0]["properties"]["candidate"], "./?.so")

    def test_a_name_that_xml_has_no_way_to_say(self):
        for letter in "\ufffe\uffff":
            name = f"./{letter}.so"
            shutil.copy(ONE[1], name)
            self.judge(["--candidate", name], f"{ROW} --junit found.xml")
            root = xml.etree.ElementTree.parse("found.xml").getroot()
            self.assertEqual([one.get("name") for one in root.iter("testsuite")], ["./?.so"])

    def test_whoever_ignores_the_end_of_children(self):
        row = self.row(["--command", "sed s/.*/miss/"], "--shape disc --regime typical --count 9",
                       preexec_fn=lambda: signal.signal(signal.SIGCHLD, signal.SIG_IGN))
        self.assertEqual((row["cases"], row["faults"]["no answer in time"]), (9, 0))

    def test_cases(self):
        case = "plane 0 0 1 0 0 -1 0 inf 0 0 0 0 0 1\n"
        self.assertEqual(self.row(tier("exact"), "--cases -", input=case)["hits"], 1)
        self.judge_fails("standard input: line 2 is no case", tier("exact"), "--cases -",
                         input=case + "plane\n")
        self.judge_fails("nothing: cannot be read", tier("exact"), "--cases nothing")
        self.judge_fails("zero: cannot be read after line 1: no end of a line", tier("exact"),
                         "--cases /dev/zero")
        self.judge_fails("standard input: no case of a shape that the candidate answers", SOME,
                         "--cases -", input="cone 0 0 1 0 0 -1 0 inf 0 0 0 0 0 1 1\n")

    def test_nothing_is_judged(self):
        for name in (".", os.devnull, "empty"):
            put("empty", "")
            pattern = "cannot be read after line 0" if name == "." else "there is no case"
            self.judge_fails(f"{name}: {pattern}", tier("exact"), f"--cases {name}")
        self.judge_fails("standard input: there is no case", tier("exact"), "--cases -", input="")

    def test_other_shapes(self):
        cases = ("cone 0 0 1 0 0 -1 0 inf 0 0 0 0 0 1 1\n" * 3 +
                 "sphere 0 0 9 0 0 -1 0 inf 0 0 0 1\n")
        said = self.ask(0, "judge", *SOME, "--cases", "-", input=cases).stdout
        self.assertIn("Case lines of other shapes or regimes, left out: 3", said)

    def test_entry(self):
        self.fail_with(WRONG_USAGE, ".*--entry.*of unit, aligned.*", "judge", *tier("exact"),
                       "--entry", "units")
        self.fail_with(WRONG_USAGE, ".*a margin is required.*", "judge", *tier("exact"),
                       *"--margin none --require decisions@1e-9".split())

    def test_no_such_regime(self):
        self.judge_fails("or the shape has no such regime", tier("exact"),
                         "--shape plane --regime apex")

    def test_not_answered(self):
        for subject, query in ((ONE, "inside"), (OTHERS[0], "hit")):
            self.judge_fails("that is not answered", subject, "--query " + query)

    def test_reference_missing(self):
        """A program that stands alone finds none."""
        shutil.copy(PROGRAM, "surehit")
        libraries = os.path.join(os.path.dirname(PROGRAM), os.pardir)
        result = self.ask(WRONG_USAGE, "judge", *"--tier exact --truth reference".split(),
                          program="./surehit",
                          env={"PATH": "/usr/bin:/bin", "LD_LIBRARY_PATH": libraries})
        self.assertIn("'surehit-reference' cannot be started", result.stderr)

    def test_answer(self):
        lines = ("sphere 0 0 9 0 0 -1 0 inf 0 0 0 1\nnonsense\n\n" + 9000 * "x" +
                 "\nsphere 0 0 9 0 0 0 0 inf 0 0 0 1\nsphere 0 0 9 0 1 0 0 inf 0 0 0 1")
        self.assertEqual(self.succeed("answer", input=lines).splitlines(),
                         ["hit 0x1p+3 surface 0x0p+0 0x0p+0 0x1p+0", "invalid line",
                          "invalid line", "invalid line", "invalid d", "miss"])
        endless = self.ask(WRONG_USAGE, "answer", input=lines + "\n" + (2 << 20) * "x")
        self.assertEqual(len(endless.stdout.splitlines()), 6)
        self.assertIn("cannot be read after line 7: no end of a line", endless.stderr)


class Answers(InFolder):
    """surehit answer --candidate: a library as a program."""

    def test_same_verdict(self):
        """The same library, asked by itself and by its lines."""
        line = "--shape cylinder --regime rim --regime degenerate --count 100"
        for wrong in ("right", "false hit", "garbage", "nan", "3 ulps", "aborts"):
            by_lines = ["--command", f"'{PROGRAM}' answer --candidate '{ONE[1]}'"]
            self.assertEqual(self.rows(by_lines, line, wrong=wrong),
                             self.rows(ONE, line, wrong=wrong), wrong)

    def test_where_it_ends(self):
        """The answers before it are there, and the line is named."""
        cases = self.succeed("cases", *"--shape cone --regime typical --count 100".split())
        whole = self.succeed("answer", *ONE, input=cases).splitlines()
        self.assertEqual(whole, self.succeed("answer", input=cases).splitlines())
        found = self.ask(BROKEN, "answer", *ONE, input=cases, wrong="aborts")
        given = found.stdout.splitlines()
        self.assertEqual(given, whole[:len(given)])
        self.assertEqual(found.stderr, "surehit answer: error: "
                         f"line {len(given) + 1}: crash: signal 6, Aborted\n")

    def test_words(self):
        lines = ("nonsense\nsphere 0 0 9 0 0 -1 0 inf 0 0 0 1\n" +
                 "cone 0 0 1 0 0 -1 0 inf 0 0 0 0 0 1 1\n")
        found = self.ask(WRONG_USAGE, "answer", *SOME, input=lines)
        self.assertEqual(found.stdout.splitlines(),
                         ["invalid line", "hit 0x1p+3 surface 0x0p+0 0x0p+0 0x1p+0"])
        self.assertIn("line 3: the candidate answers no cone", found.stderr)
        self.fail_with(WRONG_USAGE, ".*nowhere.so: cannot open shared object.*", "answer",
                       "--candidate", "nowhere.so")


class Examples(InFolder):
    """docs/examples, by the words in their first lines."""

    def build(self, name):
        subprocess.run([*CC, "-Wall", "-Wextra", "-Werror", "-O2", "-shared", "-fPIC", "-I",
                        os.path.join(ROOT, "include"), os.path.join(ROOT, "docs/examples", name),
                        "-o", "example.so", "-lm"], check=True)
        return "--candidate", "./example.so"

    def wrong_in_typical(self, subject, line=""):
        rows = self.rows(subject, line + " --regime typical --regime neighbour --regime degenerate")
        typical, neighbour, degenerate = (
            next(row for row in rows if row["regime"] == regime)
            for regime in ("typical", "neighbour", "degenerate"))
        self.assertEqual({row["shape"] for row in rows}, {"sphere"})
        self.assertLess(typical["wrong"], typical["cases"] / 10)
        self.assertGreater(neighbour["wrong"], neighbour["cases"] / 10)
        self.assertEqual(self.found(neighbour), {"false hit", "false miss"})
        self.assertIn("invalid accepted", self.found(degenerate))
        return typical["wrong"]

    def test_c(self):
        self.assertEqual(self.wrong_in_typical(self.build("sphere.c")), 0)

    def test_shader(self):
        self.assertGreater(self.wrong_in_typical(self.build("shader.c")), 0)

    def test_python(self):
        script = os.path.join(ROOT, "docs/examples/sphere.py")
        self.assertEqual(self.wrong_in_typical(["--command", f"{sys.executable} {script}"],
                                               "--shape sphere --count 500"), 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
