"""`surehit cases`, `answer` and `judge` as their users meet them:

    test_judge.py SUREHIT ROOT CC CANDIDATES [REFERENCE]

CANDIDATES is the folder of tests/judge/candidates/*.c as built: one.so, many.so, float.so,
some.so (the sphere alone), old.so (another version), none.so (nothing), program. Each does what
SUREHIT_WRONG names, in one case of sixteen. The last word says that surehit-reference is built."""

import json
import os
import statistics
import subprocess
import sys
import tempfile
import unittest

SUREHIT, ROOT, CC, CANDIDATES = (os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]),
                                 sys.argv[3], os.path.abspath(sys.argv[4]))
HAS_REFERENCE = "reference" in sys.argv[5:]
BROKEN = 1
WRONG_USAGE = 2
GIVEN_UP = 16  # crashes in a row of cases, ...
HANGS = 2      # ... and hangs
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
ENDS_OF_PROGRAM = {**ENDS, "exits quietly": "no answer", "skips misses": "no answer",
                   "floods": "no answer", "closes early": "no answer"}


def candidate(name):
    path = os.path.join(CANDIDATES, name)
    return ("--candidate", path) if name.endswith(".so") else ("--command", path)


class InFolder(unittest.TestCase):
    """Every test has a folder of its own, which is the working folder."""

    def setUp(self):
        self.start = os.getcwd()
        self.folder = tempfile.TemporaryDirectory(prefix="test_judge.", dir=self.start)
        os.chdir(self.folder.name)

    def tearDown(self):
        os.chdir(self.start)
        self.folder.cleanup()

    def run_surehit(self, *words, wrong="right", **more):
        more.setdefault("stdin", subprocess.DEVNULL if "input" not in more else None)
        if "input" in more:
            del more["stdin"]
        return subprocess.run([SUREHIT, *words], text=True, check=False, capture_output=True,
                              env={**os.environ, "SUREHIT_WRONG": wrong}, **more)

    def succeed(self, *words, **more):
        result = self.run_surehit(*words, **more)
        self.assertEqual((result.returncode, result.stderr), (0, ""), words)
        return result.stdout

    def fail_with(self, status, pattern, *words, **more):
        result = self.run_surehit(*words, **more)
        self.assertEqual(result.returncode, status, result.stderr)
        self.assertRegex(result.stderr, pattern)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)

    def judge(self, *words, wrong="right", status=0, **more):
        """The verdict as JSON."""
        result = self.run_surehit("judge", *words, "--json", "verdict.json", wrong=wrong, **more)
        self.assertEqual(result.returncode, status, result.stderr)
        with open("verdict.json", encoding="ascii") as file:
            return json.load(file)

    def row(self, *words, **more):
        """The only one."""
        rows = self.judge(*words, **more)["rows"]
        self.assertEqual(len(rows), 1)
        return rows[0]

    def found(self, row):
        self.assertEqual(list(row["faults"]), FAULTS)
        return {name for name, count in row["faults"].items() if count > 0}


def without_times(verdict):
    for row in verdict["rows"]:
        del row["nanoseconds"]
    return verdict


# A row in which every status occurs.
ROW = ("--shape", "cylinder", "--regime", "degenerate", "--count", "400")


class Faults(InFolder):
    def check_answers(self, name, expected):
        for wrong, faults in expected.items():
            row = self.row(*candidate(name), *ROW, wrong=wrong)
            self.assertEqual(self.found(row), set(faults), (name, wrong))
            self.assertEqual(row["unasked"], 0)
            if wrong == "normal":
                continue
            self.assertEqual(row["t_ulps"]["hits"] == row["t_ulps"]["correctly_rounded"],
                             wrong not in ("nan", "no t", "range", "remembers"), (name, wrong))

    def test_every_case_is_blamed_once(self):
        """The same cases, whatever is wrong with them."""
        sixteenth = self.row(*candidate("one.so"), *ROW, wrong="garbage")["faults"]["garbage"]
        self.assertTrue(15 <= sixteenth <= 35, sixteenth)
        for name in ("one.so", "many.so"):
            row = self.row(*candidate(name), *ROW, wrong="leaks")
            self.assertEqual(row["faults"]["leak"], sixteenth, name)
        row = self.row(*candidate("program"), *ROW, wrong="garbage")
        self.assertEqual(row["faults"]["garbage"], sixteenth)

    def test_remembering_shows_in_the_order(self):
        """Backwards each case has another one before it, and not only the first."""
        row = self.row(*candidate("one.so"), *ROW, wrong="remembers")
        self.assertGreater(row["faults"]["answer changes"], 20)

    def test_one_by_one(self):
        self.check_answers("one.so", {**ANSWERS, **ONLY_LIBRARIES})

    def test_many_at_once(self):
        self.check_answers("many.so", {**ANSWERS, **ONLY_LIBRARIES})

    def test_in_float(self):
        self.check_answers("float.so", {**ANSWERS, **ONLY_LIBRARIES})

    def test_program(self):
        self.check_answers("program", {wrong: faults for wrong, faults in ANSWERS.items()
                                       if wrong != "no t"})

    def test_errors_are_measured(self):
        for name in ("one.so", "many.so", "float.so", "program"):
            row = self.row(*candidate(name), "--shape", "cone", "--regime", "typical", "--count",
                           "500", wrong="3 ulps")
            t = row["t_ulps"]
            self.assertEqual((t["median"], t["99"], t["99.99"], t["most"]), (0, 3, 3, 3), name)
            self.assertEqual(row["t_ulps_by_powers_of_two"][3], t["hits"] - t["correctly_rounded"])
            row = self.row(*candidate(name), "--shape", "cone", "--regime", "typical", "--count",
                           "500", wrong="normal")
            self.assertEqual(row["t_ulps"]["most"], 0)
            normal = row["normal"]
            self.assertLess(normal["correctly_rounded"], normal["hits"])
            # The change is rounded to the component's own precision.
            self.assertAlmostEqual(normal["most"] / 2**-20, 1, delta=2**-3)

    def test_ends(self):
        for name, ends in (("one.so", ENDS), ("many.so", ENDS), ("float.so", ENDS),
                           ("program", ENDS_OF_PROGRAM)):
            for wrong, fault in ends.items():
                rows = self.judge(*candidate(name), *ROW, "--regime", "typical",
                                  wrong=wrong)["rows"]
                for row in rows:  # the run goes on with the next row
                    self.assertEqual(self.found(row), {fault}, (name, wrong))
                    self.assertEqual(row["faults"][fault], GIVEN_UP, (name, wrong))
                    self.assertGreater(row["unasked"], 0)

    def test_few_ends_are_survived(self):
        """The cases that crash, one by one, and no others."""
        self.few = ("--shape", "sphere", "--regime", "typical", "--count", "100")
        lines = self.succeed("cases", *self.few).splitlines()
        crashing = [line for line in lines if self.crashes_alone(line)]
        self.assertTrue(0 < len(crashing) < GIVEN_UP, crashing)
        for name in ("one.so", "many.so", "program"):
            row = self.row(*candidate(name), *self.few, wrong="aborts")
            self.assertEqual((row["faults"]["crash"], row["unasked"], row["cases"]),
                             (len(crashing), 0, 100))
            self.assertEqual(row["wrong"], len(crashing))

    def crashes_alone(self, line):
        row = self.row(*candidate("one.so"), "--cases", "-", input=line + "\n", wrong="aborts")
        return row["faults"]["crash"] == 1

    def test_crash_in_company(self):
        row = self.row(*candidate("many.so"), *ROW, wrong="crashes in company")
        self.assertEqual(self.found(row), {"crash"})

    def test_library_that_writes_its_input(self):
        row = self.row(*candidate("one.so"), *ROW, wrong="writes its input")
        self.assertEqual(self.found(row), {"crash"})

    def test_hangs(self):
        for name in ("one.so", "many.so", "program"):
            row = self.row(*candidate(name), "--shape", "disc", "--regime", "typical", "--count",
                           "64", "--time-limit", "0.1", wrong="hangs")
            self.assertEqual(self.found(row), {"no answer in time"}, name)
            self.assertEqual(row["faults"]["no answer in time"], HANGS)
            self.assertEqual(row["cases"] + row["unasked"], 64)

    def test_leak_of_a_program(self):
        words = ("--shape", "sphere", "--regime", "typical", "--count", "4000")
        self.assertEqual(self.found(self.row(*candidate("program"), *words, wrong="leaks always")),
                         {"leak"})

    def test_worst_cases(self):
        """Each is of its kind when it is asked again, by the line that is printed."""
        self.lines = self.succeed("cases", *ROW).splitlines()
        for wrong in ("false hit", "false miss", "part", "range", "accepts", "aborts", "3 ulps",
                      "nan", "leaks", "touches"):
            words = ("judge", *candidate("one.so"), *ROW)
            verdict = self.judge(*words[1:], wrong=wrong)
            text = self.succeed(*words, wrong=wrong)
            self.assertTrue(verdict["worst"], wrong)
            for one in verdict["worst"]:
                self.assertNotIn(one["case"], self.lines)  # but a simpler one
                self.assertIn("echo '%s' | surehit judge --cases - --candidate" % one["case"], text)
                row = self.row(*candidate("one.so"), "--cases", "-", input=one["case"] + "\n",
                               wrong=wrong)
                if one["kind"] in FAULTS:
                    self.assertEqual(row["faults"][one["kind"]], 1, one)
                elif one["kind"] == "largest error of t":
                    self.assertEqual(row["t_ulps"]["most"], one["ulps"])

    def test_worst_cases_of_a_program(self):
        self.lines = self.succeed("cases", *ROW).splitlines()
        for wrong in ("false hit", "part", "3 ulps", "aborts"):
            verdict = self.judge(*candidate("program"), *ROW, wrong=wrong)
            self.assertTrue(verdict["worst"], wrong)
            for one in verdict["worst"]:
                self.assertEqual(one["case"] in self.lines, wrong == "aborts", one)
                row = self.row(*candidate("program"), "--cases", "-", input=one["case"] + "\n",
                               wrong=wrong)
                if one["kind"] in FAULTS:
                    self.assertEqual(row["faults"][one["kind"]], 1, one)


    def test_worst_cases_by_the_count(self):
        """So many cases are tried to make one simple, and no more; always the same."""
        program = os.path.join(CANDIDATES, "program")
        words = ("--command", "tee -a asked | " + program, "--shape", "disc", "--regime",
                 "grazing", "--count", "100")
        first, again = (self.judge(*words, wrong="3 ulps")["worst"] for _ in range(2))
        self.assertEqual([one["kind"] for one in first], ["largest error of t"])
        self.assertEqual(first, again)
        with open("asked", encoding="ascii") as file:
            asked = len(file.readlines()) // 2 // 2  # of a run and a pass
        self.assertTrue(TRIES / 2 < asked - 100 < TRIES + 15 * 20, asked)

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_worst_cases_by_the_reference(self):
        """As simple as by exact, nearly."""
        words = ("--tier", "textbook", "--shape", "cone", "--regime", "grazing", "--count", "300")
        by = [self.judge(*words, "--truth", truth)["worst"] for truth in ("exact", "reference")]
        self.assertEqual([one["kind"] for one in by[0]], [one["kind"] for one in by[1]])
        sizes = [sum(len(one["case"]) for one in worst) for worst in by]
        self.assertLess(sizes[1], 1.25 * sizes[0])
        for one in by[1]:
            row = self.row("--tier", "textbook", "--cases", "-", input=one["case"] + "\n")
            if one["kind"] in FAULTS:
                self.assertEqual(row["faults"][one["kind"]], 1, one)

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_worst_cases_of_a_library_by_the_reference(self):
        """More are tried at a time than it is asked at once."""
        words = (*candidate("one.so"), "--shape", "disc", "--regime", "grazing", "--count", "100")
        (one,) = self.judge(*words, "--truth", "reference", wrong="3 ulps")["worst"]
        row = self.row(*candidate("one.so"), "--cases", "-", input=one["case"] + "\n",
                       wrong="3 ulps")
        self.assertEqual(row["t_ulps"]["most"], one["ulps"])


class Verdicts(InFolder):
    def test_same_routine_same_verdict(self):
        """As a library, as a program, and by its answers in a file."""
        for wrong in ("right", "false hit", "part", "3 ulps", "accepts", "nan"):
            verdicts = []
            words = ("--shape", "disc", "--shape", "cylinder", "--regime", "rim", "--regime",
                     "degenerate", "--count", "150")
            for name in ("one.so", "many.so", "program"):
                verdicts.append(without_times(self.judge(*candidate(name), *words, wrong=wrong)))
            with open("answers", "w", encoding="ascii") as file:
                subprocess.run(os.path.join(CANDIDATES, "program"), check=True, text=True,
                               input=self.succeed("cases", *words), stdout=file,
                               env={**os.environ, "SUREHIT_WRONG": wrong})
            verdicts.append(without_times(self.judge("--answers", "answers", *words)))
            for other in verdicts[1:]:
                self.assertEqual(verdicts[0]["rows"], other["rows"], wrong)

    def test_tier_is_its_own_line(self):
        """judge --tier against answer --tier, over all shapes and regimes."""
        cases = self.succeed("cases", "--count", "40", "--seed", "5")
        for tier in ("textbook", "exact"):
            answers = self.succeed("answer", "--tier", tier, input=cases)
            self.assertEqual(len(answers.splitlines()), len(cases.splitlines()))
            with open("answers", "w", encoding="ascii") as file:
                file.write(answers)
            by_file = self.judge("--answers", "answers", "--count", "40", "--seed", "5")
            by_tier = self.judge("--tier", tier, "--count", "40", "--seed", "5")
            self.assertEqual(without_times(by_file)["rows"], without_times(by_tier)["rows"])
            wrong = sum(row["wrong"] for row in by_tier["rows"])
            self.assertEqual(wrong == 0, tier == "exact")

    def test_deterministic_by_seed(self):
        words = ("--tier", "float32", "--shape", "sphere", "--count", "200")
        first = without_times(self.judge(*words, "--seed", "1"))
        self.assertEqual(first, without_times(self.judge(*words, "--seed", "1")))
        other = without_times(self.judge(*words, "--seed", "2"))
        self.assertNotEqual(first["rows"], other["rows"])

    def test_cases_by_seed(self):
        words = ("cases", "--shape", "cone", "--regime", "apex", "--count", "20")
        first = self.succeed(*words, "--seed", "1")
        self.assertEqual(first, self.succeed(*words, "--seed", "1"))
        self.assertNotEqual(first, self.succeed(*words, "--seed", "2"))
        self.assertEqual(len(set(first.splitlines())), 20)
        self.assertTrue(all(line.startswith("cone ") for line in first.splitlines()))

    def test_all_pairs(self):
        lines = self.succeed("cases", "--count", "1").splitlines()
        rows = self.judge("--tier", "certain", "--count", "1")["rows"]
        self.assertEqual(len(lines), len(rows))
        self.assertEqual(len({(row["shape"], row["regime"]) for row in rows}), len(rows))
        self.assertEqual([line.split()[0] for line in lines], [row["shape"] for row in rows])

    def test_given_cases(self):
        """Of several shapes, in any order: a row for each, the same in a file as on a pipe."""
        cases = self.succeed("cases", "--regime", "tangent", "--count", "30").splitlines()
        mixed = "\n".join(sorted(cases, key=lambda line: line[::-1])) + "\n"
        with open("cases", "w", encoding="ascii") as file:
            file.write(mixed)
        by_file = self.judge("--tier", "textbook", "--cases", "cases")
        by_pipe = self.judge("--tier", "textbook", "--cases", "-", input=mixed)
        made = self.judge("--tier", "textbook", "--regime", "tangent", "--count", "30")
        self.assertEqual(without_times(by_file), without_times(by_pipe))
        self.assertEqual([(row["shape"], row["regime"], row["wrong"]) for row in by_file["rows"]],
                         [(row["shape"], "given", row["wrong"]) for row in made["rows"]])

    def test_float_inputs(self):
        """Not blamed for the rounding of its inputs: what is beyond floats is not asked."""
        words = ("--shape", "sphere", "--regime", "typical", "--regime", "huge", "--count", "300")
        typical, huge = self.judge(*candidate("float.so"), *words)["rows"]
        self.assertEqual((typical["wrong"], typical["skipped"]), (0, 0))
        self.assertEqual(typical["t_ulps"]["most"], 0)
        self.assertEqual((huge["cases"], huge["skipped"]), (0, 300))
        words = ("--tier", "float32", "--shape", "sphere", "--regime", "grazing", "--count", "2000")
        unrounded = self.row(*words, "--inputs", "double")
        rounded = self.row(*words)
        self.assertGreater(unrounded["wrong"], rounded["wrong"])
        self.assertGreater(unrounded["t_ulps"]["median"], 2**20)
        self.assertLess(rounded["t_ulps"]["median"], 2**10)

    def test_times(self):
        for words in (("--tier", "stable"), candidate("one.so"), candidate("program")):
            row = self.row(*words, "--shape", "disc", "--regime", "typical", "--count", "2000")
            self.assertTrue(all(time > 0 for time in row["nanoseconds"].values()), words)

    def test_shapes_of_a_library(self):
        rows = self.judge(*candidate("some.so"), "--regime", "typical", "--count", "10")["rows"]
        self.assertEqual([row["shape"] for row in rows], ["sphere"])

    @unittest.skipUnless(HAS_REFERENCE, "no reference")
    def test_reference_as_truth(self):
        words = ("--count", "4", "--seed", "3")
        by_exact = self.judge("--tier", "textbook", *words)
        by_reference = self.judge("--tier", "textbook", *words, "--truth", "reference")
        self.assertEqual(by_reference["truth"], "reference")
        self.assertEqual(without_times(by_exact)["rows"], without_times(by_reference)["rows"])


# A tier in somebody's library, without a branch on the answer, which would be paid for.
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
#define ALL(tier) SAME(tier, plane) SAME(tier, disc) SAME(tier, sphere) SAME(tier, cylinder) \\
                  SAME(tier, cone)
ALL(TIER)
"""


class Times(InFolder):
    """All are called and timed in one way. What scatters is a tenth, and to hand a hit on costs a
    library a few nanoseconds more; what was once unlike, was so by a factor of two and three."""

    def ratio(self, above, below, *words):
        """The median of the shapes."""
        rows = self.judge(*words, "--regime", "typical", "--count", "20000")["rows"]
        self.assertEqual(len(rows), 5)
        return statistics.median(row["nanoseconds"][above] / row["nanoseconds"][below]
                                 for row in rows)

    def check_alike(self, ratio, what):
        self.assertTrue(5 / 8 < ratio < 8 / 5, (ratio, what))

    def test_a_tier_is_as_fast_as_itself(self):
        for tier in ("textbook", "certain"):
            self.check_alike(self.ratio("candidate", tier, "--tier", tier), tier)

    def test_a_library_is_as_fast_as_the_tier_it_calls(self):
        for tier in ("textbook", "certain"):
            for normals in (0, 1):
                words = self.build_same(tier, normals)
                self.check_alike(self.ratio("candidate", tier, *words), (tier, normals))

    def test_who_gives_no_normals_is_beside_tiers_that_give_none(self):
        """Tiers too are timed without."""
        without = self.textbook(*self.build_same("textbook", 0))
        self.check_alike(self.textbook("--tier", "exact") / without, "a tier")
        self.assertGreater(self.textbook(*self.build_same("textbook", 1)) / without, 4 / 3)

    def textbook(self, *words):
        """Its time beside the candidate, in all."""
        rows = self.judge(*words, "--regime", "typical", "--count", "20000")["rows"]
        return sum(row["nanoseconds"]["textbook"] for row in rows)

    def build_same(self, tier, normals):
        """The words for it."""
        with open("same.c", "w", encoding="ascii") as file:
            file.write(SAME)
        library = os.path.join(os.path.dirname(os.path.dirname(SUREHIT)), "libsurehit.so")
        if not os.path.exists(library):
            self.skipTest("a static libsurehit")
        subprocess.run([CC, "-O2", "-shared", "-fPIC", f"-DTIER={tier}", f"-DNORMALS={normals}",
                        "-I", os.path.join(ROOT, "include"), "same.c", "-o", "same.so", library,
                        "-Wl,-rpath," + os.path.dirname(library)], check=True)
        return "--candidate", "./same.so"


class Requirements(InFolder):
    words = ("--shape", "cylinder", "--regime", "typical", "--count", "200")

    def require(self, status, what, wrong="right"):
        verdict = self.judge(*candidate("one.so"), *self.words, "--require", what, wrong=wrong,
                             status=status)
        return [one["kept"] for one in verdict["required"]]

    def test_kept(self):
        self.assertEqual(self.require(0, "decisions,contract,t<=0ulp,normal<=0ulp,t<=0"),
                         [True] * 5)

    def test_broken(self):
        for wrong, what in (("false hit", "decisions"), ("part", "decisions<=0.001"),
                            ("3 ulps", "t<=2ulp"), ("3 ulps", "t<=1e-16"),
                            ("normal", "normal<=4ulp"), ("normal", "normal<=1e-7"),
                            ("touches", "contract"), ("aborts", "contract"),
                            ("aborts", "decisions"), ("leaks", "contract"),
                            ("range", "contract"), ("nan", "t<=1e300ulp")):
            self.assertEqual(self.require(BROKEN, what, wrong), [False], (wrong, what))

    def test_limits(self):
        self.assertEqual(self.require(0, "t<=3ulp", "3 ulps"), [True])
        self.assertEqual(self.require(0, "decisions<=0.2", "false miss"), [True])
        self.assertEqual(self.require(BROKEN, "decisions,t<=0ulp", "3 ulps"), [True, False])

    def test_text(self):
        result = self.run_surehit("judge", *candidate("one.so"), *self.words, "--require",
                                  "decisions,t<=2ulp", wrong="3 ulps")
        self.assertIn("kept    decisions", result.stdout)
        self.assertIn("BROKEN  t<=2ulp: cylinder typical: 3", result.stdout)


class Messages(InFolder):
    def judge_fails(self, pattern, *words, **more):
        self.fail_with(WRONG_USAGE, pattern, "judge", *words, **more)

    def test_no_candidate(self):
        self.judge_fails("missing '--tier")
        self.judge_fails("a second candidate", "--tier", "exact", *candidate("one.so"))
        self.judge_fails("expected float32", "--tier", "exactly")
        self.judge_fails("nowhere.so: cannot open shared object file", "--candidate", "nowhere.so")
        self.judge_fails("no symbol sure_candidate_version", *candidate("none.so"))
        self.judge_fails("sure_candidate_version is 2, expected 1", *candidate("old.so"))
        self.judge_fails("no symbol sure_candidate_cone", *candidate("some.so"), "--shape", "cone")
        self.judge_fails("no symbol sure_candidate_sphere", *candidate("float.so"), "--shape",
                         "sphere", "--inputs", "double")
        self.judge_fails("'./nothing' cannot be started", "--command", "./nothing")
        self.judge_fails("'exit 126' cannot be started", "--command", "exit 126")
        self.judge_fails("is out of step: 1 lines for no case", *candidate("program"),
                         wrong="greets")
        with open("text.so", "w", encoding="ascii") as file:
            file.write("no library\n")
        self.judge_fails("text.so: (file too short|invalid ELF header)", "--candidate", "text.so")

    def test_answers(self):
        words = ("--shape", "disc", "--regime", "typical", "--count", "3", "--answers", "-")
        self.judge_fails("standard input: too few answers: none to case 3", *words,
                         input="miss\nmiss\n")
        self.judge_fails("standard input: answers out of step: more than the 3 cases", *words,
                         input="miss\n" * 4)
        self.judge_fails("nothing: cannot be read", *words[:-1], "nothing")
        garbage = self.row(*words, input="miss\n\nx" + 5000 * "y" + "\n")
        self.assertEqual(garbage["faults"]["garbage"], 2)

    def test_cases(self):
        case = "plane 0 0 1 0 0 -1 0 inf 0 0 0 0 0 1\n"
        self.assertEqual(self.row("--tier", "exact", "--cases", "-", input=case)["hits"], 1)
        self.judge_fails("standard input: line 2 is no case", "--tier", "exact", "--cases", "-",
                         input=case + "plane\n")
        self.judge_fails("nothing: cannot be read", "--tier", "exact", "--cases", "nothing")
        self.judge_fails("cases are given and to be made", "--tier", "exact", "--cases", "-",
                         "--count", "3")
        self.judge_fails("can't both be '-'", "--answers", "-", "--cases", "-")
        self.judge_fails("the candidate answers no cone", *candidate("some.so"), "--cases", "-",
                         input="cone 0 0 1 0 0 -1 0 inf 0 0 0 0 0 1 1\n")

    def test_options(self):
        tier = ("--tier", "exact")
        self.judge_fails("expected plane, disc", *tier, "--shape", "torus")
        self.judge_fails("expected one of the regimes", *tier, "--regime", "easy")
        self.judge_fails("the shape has no such regime", *tier, "--shape", "plane", "--regime",
                         "apex")
        self.judge_fails("expected a whole number above 0", *tier, "--count", "0")
        self.judge_fails("expected exact or reference", *tier, "--truth", "me")
        self.judge_fails("expected float or double", *tier, "--inputs", "half")
        self.judge_fails("expected seconds", *tier, "--time-limit", "soon")
        self.judge_fails("expected a list of decisions", *tier, "--require", "all")
        self.judge_fails("one word too many: 'x'", *tier, "x")
        self.fail_with(BROKEN, "nowhere/x.json", "judge", *tier, "--json", "nowhere/x.json")
        self.assertFalse(os.path.exists("nowhere"))

    def test_reference_missing(self):
        """A program that stands alone finds none."""
        with open("surehit", "wb") as copy, open(SUREHIT, "rb") as program:
            copy.write(program.read())
        os.chmod("surehit", 0o755)
        result = subprocess.run(["./surehit", "judge", "--tier", "exact", "--truth", "reference"],
                                text=True, capture_output=True, check=False,
                                env={"PATH": "/usr/bin:/bin", "LD_LIBRARY_PATH": os.path.join(
                                    os.path.dirname(SUREHIT), os.pardir)})
        self.assertEqual(result.returncode, WRONG_USAGE)
        self.assertIn("'surehit-reference' cannot be started", result.stderr)

    def test_helps(self):
        for command in ("cases", "answer", "judge"):
            self.assertIn("Usage: surehit " + command, self.succeed(command, "--help"))

    def test_answer(self):
        lines = ("sphere 0 0 9 0 0 -1 0 inf 0 0 0 1\nnonsense\n\n" + 9000 * "x" +
                 "\nsphere 0 0 9 0 0 0 0 inf 0 0 0 1\nsphere 0 0 9 0 1 0 0 inf 0 0 0 1")
        self.assertEqual(self.succeed("answer", input=lines).splitlines(),
                         ["hit 0x1p+3 surface 0x0p+0 0x0p+0 0x1p+0", "invalid line",
                          "invalid line", "invalid line", "invalid d", "miss"])
        self.fail_with(WRONG_USAGE, "expected float32", "answer", "--tier", "exactly")
        self.fail_with(WRONG_USAGE, "expected a whole number", "cases", "--count", "many")


class Examples(InFolder):
    """docs/examples, by the words in their first lines."""

    def build(self, name):
        subprocess.run([CC, "-Wall", "-Wextra", "-Werror", "-O2", "-shared", "-fPIC", "-I",
                        os.path.join(ROOT, "include"), os.path.join(ROOT, "docs/examples", name),
                        "-o", "example.so", "-lm"], check=True)
        return "--candidate", "./example.so"

    def check(self, rows):
        by = {row["regime"]: row for row in rows}
        self.assertEqual({row["shape"] for row in rows}, {"sphere"})
        self.assertLess(by["typical"]["wrong"], by["typical"]["cases"] / 10)
        self.assertGreater(by["neighbour"]["wrong"], by["neighbour"]["cases"] / 10)
        self.assertEqual(self.found(by["neighbour"]), {"false hit", "false miss"})
        self.assertIn("invalid accepted", self.found(by["degenerate"]))
        return by

    regimes = ("--regime", "typical", "--regime", "neighbour", "--regime", "degenerate")

    def test_c(self):
        by = self.check(self.judge(*self.build("sphere.c"), *self.regimes)["rows"])
        self.assertEqual(by["typical"]["wrong"], 0)

    def test_shader(self):
        by = self.check(self.judge(*self.build("shader.c"), *self.regimes)["rows"])
        self.assertGreater(by["typical"]["wrong"], 0)

    def test_python(self):
        script = os.path.join(ROOT, "docs/examples/sphere.py")
        by = self.check(self.judge("--command", "%s %s" % (sys.executable, script), "--shape",
                                   "sphere", *self.regimes, "--count", "500")["rows"])
        self.assertEqual(by["typical"]["wrong"], 0)


if __name__ == "__main__":
    program = unittest.main(argv=sys.argv[:1], exit=False, verbosity=0)
    result = program.result
    failed = len(result.failures) + len(result.errors)
    print(f"{result.testsRun - failed} passed, {failed} failed")
    sys.exit(0 if result.wasSuccessful() and result.testsRun > 0 else 1)
