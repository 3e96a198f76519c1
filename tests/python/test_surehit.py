#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The package `surehit`, installed, against the frozen vectors and the program of the same tree.

    test_surehit.py ROOT PROGRAM

Of arrays of any strides, in doubles and floats, broadcast in every way: each answer has the bits of
the single call. Bad input is named, Python's lock is given back, and callables are judged."""
import contextlib
import functools
import io
import itertools
import json
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np
import surehit

ROOT, PROGRAM = pathlib.Path(sys.argv[1]), sys.argv[2]
RAY = 8
INFINITE = [0, 0, 0, 0, 0, -1, 0, np.inf]
BALL = [0, 0, -5, 1]


def same(a, b):
    """Bit by bit, a NaN for a NaN."""
    return all(np.array_equal(x, y, equal_nan=x.dtype.kind == "f") and
               np.array_equal(np.signbit(x) & ~np.isnan(x), np.signbit(y) & ~np.isnan(y))
               if x.dtype.kind == "f" else np.array_equal(x, y) for x, y in zip(a, b))


def from_bits(words):
    return np.array([int(word, 16) for word in words], np.uint64).view(np.float64)


def vectors(path):
    lines = [json.loads(line) for line in path.read_text(encoding="ascii").splitlines()]
    return lines[0]["shape"], lines[1:]


def one_by_one(shape, cases, tier):
    """What the program answers to case lines, each alone: status, part, t, normal."""
    text = "".join(f"{shape} {' '.join(float(x).hex() for x in case)}\n" for case in cases)
    said = subprocess.run([PROGRAM, "answer", "--tier", tier], input=text, text=True, check=True,
                          stdout=subprocess.PIPE).stdout.splitlines()
    answers = surehit.hits(shape, np.tile(INFINITE, (len(cases), 1)), np.ones(cases.shape[1] - RAY),
                           invalid="answer")
    answers = answers._replace(status=np.zeros_like(answers.status))
    for array, value in ((answers.part, surehit.NO_PART), (answers.t, np.nan),
                         (answers.normal, np.nan)):
        array.fill(value)
    for i, line in enumerate(said):
        words = line.split()
        answers.status[i] = surehit.STATUSES.index(words[0])
        if words[0] == "hit":
            answers.t[i] = float.fromhex(words[1])
            answers.part[i] = surehit.PARTS.index(words[2])
            answers.normal[i] = [float.fromhex(word) for word in words[3:]]
    if len(said) != len(cases):
        raise AssertionError(f"{len(said)} answers to {len(cases)} cases")
    return answers.status, answers.part, answers.t, answers.normal


def in_steps(shape, strides):
    """An array of zeros, some of which may be one."""
    return np.lib.stride_tricks.as_strided(np.zeros(6), shape, strides)


def told(hits):
    return hits.status, hits.part, hits.t, hits.normal


class Vectors(unittest.TestCase):
    def test_exact_answers(self):
        count = 0
        for path in sorted((ROOT / "tests/vectors").rglob("*.jsonl")):
            shape, lines = vectors(path)
            cases = np.array([from_bits(line["case_bits"]) for line in lines])
            got = surehit.hits(shape, cases[:, :RAY], cases[:, RAY:], "exact", invalid="answer")
            for i, line in enumerate(lines):
                count += 1
                self.assertEqual(surehit.STATUSES[got.status[i]], line["answer"], line)
                if line["answer"] == "hit":
                    self.assertEqual(surehit.PARTS[got.part[i]], line["part"], line)
                    self.assertTrue(same((got.t[i:i + 1], got.normal[i]),
                                         (from_bits([line["t_bits"]]),
                                          from_bits(line["normal_bits"]))), line)
                else:
                    self.assertEqual(got.part[i], surehit.NO_PART)
                    self.assertTrue(np.isnan(got.t[i]) and np.isnan(got.normal[i]).all())
        self.assertGreater(count, 8000)

    def test_every_tier_is_the_programs(self):
        for shape, tier in itertools.product(surehit.SHAPES, surehit.TIERS):
            _, lines = vectors(ROOT / f"tests/vectors/{shape}.jsonl")
            cases = np.array([from_bits(line["case_bits"]) for line in lines[::7]])
            got = surehit.hits(shape, cases[:, :RAY], cases[:, RAY:], tier, invalid="answer")
            self.assertTrue(same(told(got), one_by_one(shape, cases, tier)), (shape, tier))


def laid_out(array, rng):
    """The same numbers elsewhere in memory: in steps, backwards, or in another order of axes, at an
    odd address."""
    steps = [int(rng.choice([-3, -2, -1, 1, 2, 3])) for _ in array.shape]
    order = rng.permutation(array.ndim)
    room = [size * abs(step) for size, step in zip(array.shape, steps)]
    memory = np.full(int(np.prod([room[axis] for axis in order])) * 8 + 1, 0x5a, np.uint8)
    whole = np.frombuffer(memory[1:].data, np.float64).reshape([room[axis] for axis in order])
    whole = whole.transpose(np.argsort(order)) if array.ndim else whole.reshape(())
    part = whole[tuple(slice(None, None, step) for step in steps)]
    part = part[tuple(slice(size) for size in array.shape)]
    part[...] = array
    return part


class Strides(unittest.TestCase):
    def setUp(self):
        self.rng = np.random.default_rng(1)

    def cases_of(self, shape, count):
        regimes = [name for name in surehit.REGIMES
                   if not isinstance(self.tried(shape, name), ValueError)]
        all_of = [surehit.cases(shape, name, count) for name in regimes]
        return (np.concatenate([made.rays for made in all_of]),
                np.concatenate([made.objects for made in all_of]))

    @staticmethod
    def tried(shape, name):
        try:
            return surehit.cases(shape, name, 0)
        except ValueError as error:
            return error

    def test_any_strides(self):
        for shape in surehit.SHAPES:
            rays, objects = self.cases_of(shape, 3)
            plain = surehit.hits(shape, rays, objects, invalid="answer")
            for _ in range(20):
                there = laid_out(rays, self.rng), laid_out(objects, self.rng)
                self.assertTrue(same(surehit.hits(shape, *there, invalid="answer"), plain))

    def test_columns_of_any_strides(self):
        for shape in surehit.SHAPES:
            rays, objects = self.cases_of(shape, 2)
            plain = surehit.hits(shape, rays, objects, invalid="answer")
            parts = rays[:, :3], rays[:, 3:6], rays[:, 6], rays[:, 7]
            fields, at = [], 0
            for _, size in surehit.FIELDS[shape]:
                fields.append(objects[:, at:at + size] if size > 1 else objects[:, at])
                at += size
            for _ in range(5):
                there = (tuple(laid_out(part, self.rng) for part in each)
                         for each in (parts, fields))
                self.assertTrue(same(surehit.hits(shape, *there, invalid="answer"), plain))

    def test_every_way_to_broadcast(self):
        """All axes against each pair alone."""
        for shape in surehit.SHAPES:
            rays, objects = self.cases_of(shape, 1)
            rays, objects = rays[:12].reshape(3, 1, 4, RAY), objects[:10].reshape(5, 1, 2, 1, -1)
            grid = surehit.hits(shape, rays, objects, invalid="answer")
            self.assertEqual(grid.t.shape, (5, 3, 2, 4))
            all_rays = np.broadcast_to(rays, (*grid.t.shape, RAY))
            all_objects = np.broadcast_to(objects, (*grid.t.shape, objects.shape[-1]))
            for place in np.ndindex(*grid.t.shape):
                alone = surehit.hits(shape, all_rays[place], all_objects[place], invalid="answer")
                self.assertTrue(same(alone, [array[place] for array in grid]), (shape, place))

    def test_floats_are_the_same_numbers(self):
        for shape in surehit.SHAPES:
            with np.errstate(over="ignore"):
                rays, objects = (part.astype(np.float32) for part in self.cases_of(shape, 5))
            wide = surehit.hits(shape, rays.astype(np.float64), objects.astype(np.float64),
                                invalid="answer")
            for kind in (np.float32, ">f4"):
                there = rays.astype(kind)[::-1], objects.astype(kind)[::-1]
                self.assertTrue(same(surehit.hits(shape, *there, invalid="answer"),
                                     [array[::-1] for array in wide]))
        swapped = np.array(INFINITE).astype(">f8")
        self.assertEqual(surehit.hits("sphere", swapped, np.array(BALL, np.int16)).t, 4)

    def test_defaults_of_the_range(self):
        whole = surehit.hits("sphere", INFINITE, BALL)
        for rays in (INFINITE[:6], ([0, 0, 0], [0, 0, -1]), ([0, 0, 0], [0, 0, -1], 0)):
            self.assertTrue(same(surehit.hits("sphere", rays, ([0, 0, -5], 1)), whole))
        late = surehit.hits("sphere", ([0, 0, 0], [0, 0, -1], [0, 5]), BALL)
        self.assertEqual(late.t.tolist(), [4, 6])

    def test_masks_that_mask_nothing(self):
        for mask in (np.ma.nomask, False, [False] * 8):
            rays = np.ma.masked_array(INFINITE, mask=mask)
            self.assertEqual(surehit.hits("sphere", rays, np.ma.masked_array(BALL)).t, 4)

    def test_nothing(self):
        none = surehit.hits("box", np.empty((0, 5, 8)), [0, 0, 0, 1, 1, 1])
        self.assertEqual([array.shape for array in none], [(0, 5)] * 5 + [(0, 5, 3)])
        into = none._replace(t=in_steps((0, 5), (0, 0)))
        self.assertIs(surehit.hits("box", np.empty((0, 5, 8)), [0, 0, 0, 1, 1, 1], out=into), into)

    def test_given_arrays(self):
        rays, objects = surehit.cases("cone", "rim", 50)
        plain = surehit.hits("cone", rays, objects)
        out = surehit.Hits(*(np.zeros_like(array) for array in plain))
        self.assertIs(surehit.hits("cone", rays, objects, out=out), out)
        self.assertTrue(same(out, plain))
        room = np.zeros(50, [("t", "f8"), ("normal", "f8", 3), ("status", "u1")])
        into = out._replace(t=room["t"], normal=room["normal"], status=room["status"])
        self.assertTrue(same(surehit.hits("cone", rays, objects, out=into), plain))
        one = surehit.hits("cone", rays[:1], objects[:1])  # whose step is no distance
        surehit.hits("cone", rays[:1], objects[:1], out=one._replace(t=in_steps((1,), (0,))))
        without = surehit.hits("cone", rays, objects, normals=False)
        self.assertIsNone(without.normal)
        self.assertTrue(same(without[:5], plain[:5]))


class Faults(unittest.TestCase):
    def check(self, kind, words, call):
        with self.assertRaises(kind) as caught:
            call()
        self.assertRegex(str(caught.exception), words)

    def test_named(self):
        hits = surehit.hits
        many = np.tile(INFINITE, (4, 1))
        bad = many.copy()
        bad[2, 4] = np.nan
        worse = many.copy()
        worse[[1, 3], 4] = np.nan
        out = hits("sphere", many, BALL)
        masked = np.ma.masked_array(many, mask=np.eye(4, 8, dtype=bool))
        for kind, words, call in [
                (ValueError, "^rays: .* masked", lambda: hits("sphere", masked, BALL)),
                (ValueError, "^rays: .* masked", lambda: hits("sphere", list(masked), BALL)),
                (ValueError, "^rays: t_min: .* masked", lambda: hits(
                    "sphere", (many[:, :3], many[:, 3:6], masked[:, 0]), BALL)),
                (ValueError, "^objects: radius: .* masked",
                 lambda: hits("sphere", many, (BALL[:3], np.ma.masked))),
                (ValueError, "^shape 'ball': ", lambda: hits("ball", INFINITE, BALL)),
                (TypeError, "^shape: ", lambda: hits(2, INFINITE, BALL)),
                (ValueError, "^tier 'best': ", lambda: hits("sphere", INFINITE, BALL, "best")),
                (ValueError, "^invalid 'no': ",
                 lambda: hits("sphere", INFINITE, BALL, invalid="no")),
                (ValueError, "^rays: .* 6 or 8", lambda: hits("sphere", INFINITE[:7], BALL)),
                (ValueError, "^rays: ", lambda: hits("sphere", 3.0, BALL)),
                (ValueError, "^rays: ", lambda: hits("sphere", [[0, 0], [1]], BALL)),
                (ValueError, "^rays: .* tuple", lambda: hits("sphere", tuple(INFINITE), BALL)),
                (ValueError, "^rays: direction: ",
                 lambda: hits("sphere", ([0, 0, 0], [0, 1]), BALL)),
                (ValueError, "^rays: shapes",
                 lambda: hits("sphere", (many[:, :3], many[:3, 3:6]), BALL)),
                (ValueError, "^objects: .* 4", lambda: hits("sphere", INFINITE, BALL + [1])),
                (ValueError, "^objects: .* rays'", lambda: hits("sphere", many, [BALL] * 3)),
                (ValueError, "^objects: .* centre, radius, not of 1",
                 lambda: hits("sphere", INFINITE, (BALL,))),
                (TypeError, "^rays: .*complex", lambda: hits("sphere", many + 0j, BALL)),
                (TypeError, "^rays: .*bool", lambda: hits("sphere", many > 0, BALL)),
                (TypeError, "^objects: .*object", lambda: hits("sphere", many, [None] * 4)),
                (TypeError, "^rays: ", lambda: hits("sphere", many.astype(np.longdouble), BALL)),
                (ValueError, "^objects: .* no double",
                 lambda: hits("sphere", many, [0, 0, 2**53 + 1, 1])),
                (ValueError, r"^rays\[2\]: invalid d;", lambda: hits("sphere", bad, BALL)),
                (ValueError, r"^rays\[1\]: invalid d;", lambda: hits("sphere", worse, BALL)),
                (ValueError, r"^rays\[1, 2\]: invalid d;",
                 lambda: hits("sphere", np.stack([many, bad]), BALL)),
                (ValueError, r"^rays\[3\]: invalid d;",
                 lambda: hits("sphere", [*many[:3], bad[2]], [[BALL], [BALL]])),
                (ValueError, "^rays: invalid d;", lambda: hits("sphere", [0] * 6, [BALL] * 2)),
                (ValueError, r"^objects\[1, 0\]: invalid radius;",
                 lambda: hits("sphere", many, [[BALL], [[0, 0, 0, -1]]])),
                (ValueError, "^rays: .* no double",
                 lambda: hits("sphere", [2**53 + 1, 0, 0.5, 0, 0, -1], BALL)),
                (ValueError, "^rays: .* no double",
                 lambda: hits("sphere", [10**400, 0, 0, 0, 0, -1], BALL)),
                (ValueError, "^rays: .* no double",
                 lambda: hits("sphere", [np.int64(2**53 + 1), 0, 0.5, 0, 0, -1], BALL)),
                (ValueError, "^out.t: several of its elements are one",
                 lambda: hits("sphere", many, BALL, out=hits("sphere", many, BALL)._replace(
                     t=in_steps((4,), (0,))))),
                (ValueError, "^out.normal: several of its elements are one",
                 lambda: hits("sphere", many, BALL,
                              out=out._replace(normal=in_steps((4, 3), (8, 8))))),
                (ValueError, r"^objects: invalid radius;",
                 lambda: hits("sphere", many, [0, 0, 0, np.inf])),
                (ValueError, "^rays: invalid t_max;",
                 lambda: hits("sphere", INFINITE[:7] + [-1], BALL)),
                (TypeError, "^out: ", lambda: hits("sphere", many, BALL, out=tuple(out))),
                (ValueError, r"^out\.status: .*\(4,\)",
                 lambda: hits("sphere", many[:3], BALL, out=out)),
                (TypeError, r"^out\.t: ",
                 lambda: hits("sphere", many, BALL, out=out._replace(t=out.status))),
                (ValueError, r"^out\.t: shares .* asked",
                 lambda: hits("sphere", many, BALL, out=out._replace(t=many[:, 0]))),
                (ValueError, r"^out\.t_error: shares memory with out\.t",
                 lambda: hits("sphere", many, BALL, out=out._replace(t_error=out.t[::-1]))),
                (ValueError, "^regime 'odd': ", lambda: surehit.cases("sphere", "odd", 1)),
                (ValueError, "^regime 'apex': ", lambda: surehit.cases("sphere", "apex", 1)),
                (ValueError, "^count: ", lambda: surehit.cases("sphere", "far", -1)),
                (TypeError, "^seed: ", lambda: surehit.cases("sphere", "far", 1, 0.5)),
                (ValueError, "^seed: ", lambda: surehit.cases("sphere", "far", 1, 2**63)),
                (ValueError, "^first: ", lambda: surehit.cases("sphere", "far", 1, 0, 2**64)),
                (TypeError, r"^count: .*array\(\[3\]\)",
                 lambda: surehit.cases("sphere", "far", np.array([3]))),
                (TypeError, "^routine: ", lambda: surehit.judge("sphere")),
                (TypeError, "^shape: ", lambda: surehit.judge(print, shape=b"sphere")),
                (TypeError, "^time_limit: ", lambda: surehit.judge(print, time_limit=True)),
                (TypeError, "^count: ", lambda: surehit.judge(print, count=1j)),
                (ValueError, "^time_limit '0.0': ",
                 lambda: surehit.judge(print, time_limit=np.float32(0))),
                (ValueError, r"^count '1\.5': ", lambda: surehit.judge(print, count=np.array(1.5))),
                (TypeError, "^shape: ", lambda: surehit.judge(print, shape=[None])),
                (ValueError, "^shape 'ball': ", lambda: surehit.judge(print, shape="ball")),
                (ValueError, "^time_limit '0': ", lambda: surehit.judge(print, time_limit=0)),
                (ValueError, "^case_set '1': ", lambda: surehit.judge(print, case_set="1"))]:
            with self.subTest(words):
                self.check(kind, words, call)
        for name in ("shape", "regime", "case_set", "inputs", "entry", "margin", "require"):
            for value in ("", [""], "a\0b", [], (), {}, np.array([])):
                with self.subTest(name, value=value):
                    self.check(ValueError, f"^{name}: ",
                               lambda: surehit.judge(print, **{name: value}))
        locked = out._replace(t=np.zeros(4))
        locked.t.flags.writeable = False
        self.check(ValueError, r"^out\.t: .* writeable",
                   lambda: hits("sphere", many, BALL, out=locked))


class Lock(unittest.TestCase):
    """While the library answers, other threads run."""

    def count_during(self, call):
        counts, done = [0], threading.Event()

        def count():
            while not done.is_set():
                counts[0] += 1
                time.sleep(0)  # gives the lock to who asks for it
        other = threading.Thread(target=count)
        switch = sys.getswitchinterval()
        sys.setswitchinterval(1000)  # nobody has to give the lock away
        try:
            other.start()
            while counts[0] == 0:
                time.sleep(0)
            before = counts[0]
            for _ in range(100):  # a busy machine wakes the other thread late
                call()
                if counts[0] > before:
                    break
            return counts[0] - before
        finally:
            done.set()
            sys.setswitchinterval(switch)
            other.join()

    def test_is_released(self):
        rays, objects = surehit.cases("cone", "tangent", 3000)
        out = surehit.hits("cone", rays, objects)
        inner = sys.modules["surehit._surehit"]
        self.assertGreater(self.count_during(lambda: inner.hits(
            surehit.SHAPES.index("cone"), surehit.TIERS.index("exact"), (rays, objects),
            tuple(out))), 0, "hits keeps Python's lock")
        room = np.empty((300000, RAY + 7))
        self.assertGreater(self.count_during(lambda: inner.cases(
            surehit.SHAPES.index("cone"), surehit.REGIMES.index("typical"), 0, 0, room)), 0,
            "cases keeps Python's lock")

    def test_threads_get_the_same(self):
        rays, objects = surehit.cases("cylinder", "typical", 20000)
        alone, found = surehit.hits("cylinder", rays, objects), [None] * 4

        def ask(i):
            found[i] = surehit.hits("cylinder", rays, objects)
        threads = [threading.Thread(target=ask, args=(i,)) for i in range(4)]
        for each in threads:
            each.start()
        for each in threads:
            each.join()
        self.assertTrue(all(same(one, alone) for one in found))


class Cases(unittest.TestCase):
    def test_are_the_programs(self):
        asked = ("sphere", "grazing", 0), ("box", "rim", 7), ("cone", "apex", 1)
        for shape, regime, seed in asked:
            lines = subprocess.run([PROGRAM, "cases", "--shape", shape, "--regime", regime,
                                    "--count", "50", "--seed", str(seed)], check=True, text=True,
                                   stdout=subprocess.PIPE).stdout.splitlines()
            numbers = np.array([[float.fromhex(word) for word in line.split()[1:]]
                                for line in lines])
            made = surehit.cases(shape, regime, 50, seed)
            self.assertTrue(same((np.hstack(made),), (numbers,)))
            later = surehit.cases(shape, regime, 20, seed, first=30)
            self.assertTrue(same((np.hstack(later),), (numbers[30:],)))


def tier(name):
    return lambda shape, rays, objects: surehit.hits(shape, rays, objects, name, invalid="answer")


def nearest(shape, rays, objects):
    """A sphere by the textbook."""
    m, d = rays[:, :3] - objects[:, :3], rays[:, 3:6]
    with np.errstate(all="ignore"):
        a, b, c = (d * d).sum(1), (m * d).sum(1), (m * m).sum(1) - objects[:, 3]**2
        root = np.sqrt(b * b - a * c)
        near, far = (-b - root) / a, (-b + root) / a
        t = np.where(near >= rays[:, 6], near, far)
        return np.where((t >= rays[:, 6]) & (t <= rays[:, 7]), t, np.nan)


CLOSED = """import surehit, sys
found = surehit.judge(lambda shape, *asked: surehit.hits(shape, *asked, invalid="answer"),
                      shape="box", count=5, require="decisions")
sys.exit(7 if found.kept and sys.stdout is None and sys.stderr is None else 1)"""


HANGING = """import os, pathlib, signal, surehit, time
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background ignores it
def hangs(*asked):
    pathlib.Path("new.pid").write_text(str(os.getppid()), encoding="ascii")
    os.replace("new.pid", "judge.pid")
    time.sleep(60)
surehit.judge(hangs, shape="box", count=5, time_limit=60)"""
# What is written once, into a stream that is written late.
BUFFERED = """import surehit
print("before")
told = []
def routine(shape, *asked):
    if not told:
        told.append(print("asked"))
    return surehit.hits(shape, *asked, invalid="answer")
found = surehit.judge(routine, shape="box", count=5)
print("before" in found.table)"""
FAILING = """import surehit
def routine(shape, *asked):
    if len(asked[0]) > 1:
        print("many")
        raise ArithmeticError
    return surehit.hits(shape, *asked, invalid="answer")
surehit.judge(routine, shape="box", count=5)"""


def run_buffered(code):
    variables = {name: value for name, value in os.environ.items() if name != "PYTHONUNBUFFERED"}
    return subprocess.run([sys.executable, "-c", code], text=True, env=variables,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)


class Judge(unittest.TestCase):
    def test_exact_is_right(self):
        verdict = surehit.judge(tier("exact"), count=20, regime=["rim", "typical", "tangent"],
                                require="decisions,contract,t<=0ulp,normal<=0ulp")
        self.assertTrue(verdict.kept)
        self.assertIsNone(verdict.error)
        self.assertEqual({row["shape"] for row in verdict.rows}, set(surehit.SHAPES))
        self.assertEqual(sum(row["wrong"] for row in verdict.rows), 0)

    def test_a_tier_is_the_programs(self):
        """The very same answers: counts and errors of each row are those of the tier itself."""
        options = ["--shape", "sphere", "--shape", "cone", "--count", "60", "--seed", "5"]
        path = "tier.json"
        subprocess.run([PROGRAM, "judge", "--tier", "textbook", *options, "--json", path],
                       check=True, stdout=subprocess.DEVNULL)
        theirs = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))["rows"]
        ours = surehit.judge(tier("textbook"), shape=["sphere", "cone"], count=60, seed=5).rows
        self.assertGreater(sum(row["wrong"] for row in ours), 50)
        for one, other in zip(theirs, ours, strict=True):
            for key in ("shape", "regime", "cases", "wrong", "faults", "t_ulps", "margins"):
                self.assertEqual(one[key], other[key], (one["regime"], key))

    def test_options_are_the_programs(self):
        """Those that change what is asked, and how what is wrong is measured."""
        for given in {"count": 40, "margin": "ulps"}, {"count": 40, "entry": "unit,outside"}, {
                "count": 40, "margin": "none"}, {"case_set": "2026.1"}:
            words = [word for name, value in given.items()
                     for word in ("--" + name.removeprefix("case_"), str(value))]
            subprocess.run([PROGRAM, "judge", "--tier", "textbook", "--shape", "cone", "--regime",
                            "rim", *words, "--json", "given.json"], check=True,
                           stdout=subprocess.DEVNULL)
            theirs = json.loads(pathlib.Path("given.json").read_text(encoding="utf-8"))
            ours = surehit.judge(tier("textbook"), shape="cone", regime="rim", **given).json
            (one,), (other,) = theirs["rows"], ours["rows"]
            self.assertGreater(one["wrong"], 0)
            for key in ("cases", "unasked", "wrong", "margins"):
                self.assertEqual(one.get(key), other.get(key), (given, key))

    def test_words_of_numpy(self):
        rows = surehit.judge(tier("exact"), shape=np.array(["sphere", "box"]),
                             regime=np.array(["typical"]), count=np.array(5), seed=np.uint64(3),
                             time_limit=np.float32(0.5)).rows
        self.assertEqual([(row["shape"], row["cases"]) for row in rows],
                         [("sphere", 5), ("box", 5)])

    def test_t_alone_and_case_by_case(self):
        options = {"shape": "sphere", "regime": "typical", "count": 100, "entry": "outside"}
        at_once = surehit.judge(nearest, **options)

        def alone(shape, ray, ball):
            t = nearest(shape, ray[np.newaxis], ball[np.newaxis])[0]
            return None if np.isnan(t) else (t, surehit.PARTS.index("surface"))
        each = surehit.judge(alone, each=True, **options)
        self.assertEqual(at_once.rows[0]["wrong"], 0)
        self.assertGreater(at_once.rows[0]["t_ulps"]["hits"], 20)
        for key in ("wrong", "faults", "t_ulps"):
            self.assertEqual(at_once.rows[0][key], each.rows[0][key])
        self.assertIn("nearest", str(at_once))

    def test_floats(self):
        def asked(shape, rays, objects):
            if rays.dtype != np.float32 or objects.dtype != np.float32:
                raise TypeError("not floats")
            return nearest(shape, rays, objects)
        row = surehit.judge(asked, shape="sphere", regime="typical", count=50, inputs="float",
                            entry="outside").rows[0]
        self.assertEqual((row["faults"]["crash"], row["t_ulps"]["hits"] > 10), (0, True))

    def test_an_exception_is_a_crash(self):
        def some(shape, rays, objects):
            if (rays[:, 0] > 0).any():
                raise ArithmeticError("to the right")
            return tier("exact")(shape, rays, objects)
        verdict = surehit.judge(some, shape="sphere", regime="far", count=30)
        rays, _ = surehit.cases("sphere", "far", 30)
        self.assertEqual(verdict.rows[0]["faults"]["crash"], (rays[:, 0] > 0).sum())
        self.assertIn("ArithmeticError: to the right", verdict.error)

    def test_complex_and_masked_answers_are_exceptions(self):
        ball = {"shape": "sphere", "regime": "typical", "count": 20}
        normals, imaginary = np.ones((20, 3)), np.ones(20) + 1j
        for words, said in [("t: .* complex", imaginary), ("part: .* complex", (1, 0j)),
                            ("part 0.5: expected", (1, 0.5)),
                            ("normal: .* complex", (1, 0, normals[0] + 0j)),
                            ("t: .* masked", np.ma.masked_array(normals[:, 0], mask=True))]:
            def answers(shape, rays, objects, said=said):
                return said[:len(rays)] if isinstance(said, np.ndarray) else said
            with self.subTest(words), self.assertRaisesRegex(RuntimeError, f"Error: {words}"):
                surehit.judge(answers, **ball)
        with self.assertRaisesRegex(RuntimeError, "TypeError: t: .* complex"):
            surehit.judge(lambda *asked: 1j, each=True, **ball)

    def test_nothing_but_exceptions(self):
        with self.assertRaisesRegex(RuntimeError, "ZeroDivisionError"):
            surehit.judge(lambda *asked: 1 / 0, shape="disc", regime="far", count=20)

    def test_the_first_exception(self):
        calls = pathlib.Path("calls")
        calls.write_text("", encoding="ascii")

        def counts(*asked):
            calls.write_text(calls.read_text(encoding="ascii") + "I", encoding="ascii")
            raise ArithmeticError(f"call {calls.read_text(encoding='ascii')}")
        with self.assertRaisesRegex(RuntimeError, "ArithmeticError: call I$"):
            surehit.judge(counts, shape="disc", regime="far", count=20)

    def test_an_interruption(self):
        """Ends the judge, too, whose process the callable's comes from."""
        pid = pathlib.Path("judge.pid")
        pid.unlink(missing_ok=True)
        user = subprocess.Popen([sys.executable, "-c", HANGING], stderr=subprocess.PIPE, text=True)
        self.addCleanup(user.kill)
        while not pid.exists() and user.poll() is None:
            time.sleep(0.01)
        user.send_signal(signal.SIGINT)
        self.assertIn("KeyboardInterrupt", user.communicate(timeout=30)[1])
        with self.assertRaises(ProcessLookupError):
            os.kill(int(pid.read_text(encoding="ascii")), 0)

    def test_a_hang_and_an_end(self):
        def hangs(shape, rays, objects):
            while len(rays) == 1 and rays[0, 0] > 0:
                time.sleep(1)
            if len(rays) > 1:
                os.kill(os.getpid(), 9)
            return tier("exact")(shape, rays, objects)
        row = surehit.judge(hangs, shape="sphere", regime="far", count=8, time_limit=0.5,
                            margin="none").rows[0]
        self.assertGreater(row["faults"]["no answer in time"], 0)

    def test_what_it_prints_is_no_answer(self):
        def talks(shape, rays, objects):
            print("hit 3")
            return tier("exact")(shape, rays, objects)
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            verdict = surehit.judge(talks, shape="box", count=5, require="decisions")
        self.assertTrue(verdict.kept)
        self.assertIn("hit 3", said.getvalue())
        self.assertNotIn("hit 3\n", verdict.table)

    def test_what_is_printed_late(self):
        """By the caller once, and there alone; by the routine before an exception, too."""
        done = run_buffered(BUFFERED)
        self.assertEqual(done.stdout, "before\nFalse\n")
        self.assertRegex(done.stderr, "(?m)^asked$")
        self.assertNotIn("before", done.stderr)
        self.assertRegex(run_buffered(FAILING).stderr, "(?m)^many$")

    def test_without_streams(self):
        """As Python has them whose files were closed before: `>&-`."""
        for one, other in itertools.product((None, io.StringIO()), repeat=2):
            with contextlib.redirect_stdout(one), contextlib.redirect_stderr(other):
                found = surehit.judge(tier("exact"), shape="box", count=5, require="decisions")
            self.assertTrue(found.kept)
        told = subprocess.run(["sh", "-c", '"$0" -c "$1" >&- 2>&- <&-', sys.executable, CLOSED])
        self.assertEqual(told.returncode, 7)

    def test_who_ignores_ends_of_children(self):
        before = signal.signal(signal.SIGCHLD, signal.SIG_IGN)
        try:
            kept = [surehit.judge(lambda *asked: np.nan, shape="plane", regime="typical", count=9,
                                  require=words).kept for words in (None, "decisions")]
            with self.assertRaisesRegex(ValueError, "^shape 'ball': "):
                surehit.judge(print, shape="ball")
        finally:
            signal.signal(signal.SIGCHLD, before)
        self.assertEqual(kept, [True, False])

    def test_names_of_callables(self):
        def odd(*asked):
            return nearest(*asked)
        odd.__name__ = "odd\ud800\0one"
        for routine, name in (functools.partial(nearest), "partial"), (odd, "odd??one"):
            found = surehit.judge(routine, shape="sphere", regime="typical", count=5)
            self.assertIn(f"\nCandidate: {name}\n", found.table)

    def test_from_a_thread(self):
        found = []
        other = threading.Thread(target=lambda: found.append(
            surehit.judge(tier("exact"), shape="box", count=5, require="decisions").kept))
        other.start()
        other.join()
        self.assertEqual(found, [True])

    def test_wrong_is_seen(self):
        verdict = surehit.judge(lambda shape, rays, objects: np.zeros(len(rays)), shape="plane",
                                regime="typical", count=50, require="decisions")
        self.assertFalse(verdict.kept)
        self.assertGreater(verdict.rows[0]["faults"]["false hit"], 10)
        self.assertTrue(any(worst["kind"] == "false hit" for worst in verdict.worst))
        self.assertNotIn(" | ", verdict.table.partition("Worst cases")[2])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
