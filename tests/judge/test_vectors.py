# SPDX-License-Identifier: MIT
"""The frozen vectors (docs/vectors.md): their bytes, their reader, and what CGAL says to them.

    test_vectors.py SUREHIT CC [REFERENCE]         the tests
    test_vectors.py SUREHIT --accept               renews the files

CC is a C compiler, REFERENCE the program surehit-reference."""

import ctypes
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import unittest
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from commands import PROGRAM, ROOT, WRONG_USAGE, InFolder, all_files, contents, put  # noqa: E402
from shapes import SHAPES  # noqa: E402

CC = sys.argv[2].split()
REFERENCE = [os.path.abspath(word) for word in sys.argv[3:4]]
FROZEN = pathlib.Path(ROOT, "tests/vectors")
PAGE = pathlib.Path(ROOT, "docs/vectors.md").read_text(encoding="utf-8")
EXAMPLES = pathlib.Path(ROOT, "docs/examples")
MOST_BYTES = 6_400_000

# The folders, and what is in each.
SETS = {
    ".": [f"--cases={ROOT}/tests/cases/{shape}.cases" for shape in SHAPES],
    "ordinary": ["--regime", "camera", "--regime", "typical", "--count", "50"],
    "unit": ["--entry", "unit", "--count", "6"],
    "unit_local": ["--entry", "unit local", "--count", "6"],
    "float": ["--entry", "float", "--count", "6"],
}
FILES = {f"{folder}/{shape}.jsonl": shape for folder in SETS for shape in SHAPES}


def freeze(root):
    """Makes all files in a folder."""
    for folder, words in SETS.items():
        target = pathlib.Path(root, folder)
        target.mkdir(exist_ok=True)
        subprocess.run([PROGRAM, "vectors", *words, "-o", str(target)], check=True)


def head(name):
    with open(FROZEN / name, encoding="ascii") as file:
        return json.loads(next(file))


def lines(name):
    """The objects of a file without its head."""
    with open(FROZEN / name, encoding="ascii") as file:
        next(file)
        return [json.loads(line) for line in file]


def of_bits(digits):
    return struct.unpack(">d", bytes.fromhex(digits))[0]


def answer_line(vector):
    if vector["answer"] == "hit":
        return " ".join(["hit", vector["t"], vector["part"], *vector["normal"]])
    return " ".join(["invalid", vector["field"]] if vector["answer"] == "invalid" else ["miss"])


class Bytes(InFolder):
    def test_the_same_bytes(self):
        freeze(".")
        stale = [name for name in FILES if contents(name) != contents(FROZEN / name)]
        self.assertEqual(stale, [], "renew them with `meson compile accept-vectors`")

    def test_size(self):
        files = sorted(FROZEN.rglob("*.jsonl"))
        self.assertEqual(files, sorted(FROZEN / name for name in FILES))
        size = sum(file.stat().st_size for file in files)
        self.assertLess(size, MOST_BYTES)
        count = sum(head(name)["lines"] for name in FILES)
        self.assertIn(f"{count // 100 * 100} cases, {size / 1e6:.1f} MB", PAGE)

    def test_as_documented(self):
        """Keys and their order; both forms of a number say the same; no blanks."""
        documented = re.findall(r"`(\w+)`", "".join(re.findall(r"^\| (`\w+`.*?) \|", PAGE, re.M)))
        head_keys, keys = documented[:7], documented[7:]
        hits = 0
        for name, shape in FILES.items():
            first, *rest = (FROZEN / name).read_text(encoding="ascii").splitlines()
            self.assertNotIn(" ", "".join(rest))
            first = json.loads(first)
            self.assertEqual(list(first), head_keys)
            self.assertEqual((first["surehit_vectors"], first["shape"]), (2, shape))
            self.assertEqual((first["set"], first["lines"]), ("2026.2", len(rest)))
            for vector in map(json.loads, rest):
                self.assertEqual(list(vector), [key for key in keys if key in vector])
                self.assertEqual(len(vector["case"]), len(first["case"]))
                self.check_numbers(vector["case"], vector["case_bits"])
                if vector["answer"] == "hit":
                    self.check_numbers([vector["t"]], [vector["t_bits"]])
                    self.check_numbers(vector["normal"], vector["normal_bits"])
                    hits += 1
        self.assertGreater(hits, 1000)

    def check_numbers(self, texts, bits):
        self.assertEqual(len(texts), len(bits))
        for text, digits in zip(texts, bits):
            number = of_bits(digits)
            self.assertRegex(digits, "^[0-9a-f]{16}$")
            if text == "nan":
                self.assertNotEqual(number, number)
            else:
                self.assertEqual(struct.pack(">d", float.fromhex(text)).hex(), digits)


def allows(vector):
    """At 1e-9, and where a touch may be a miss: is the other decision right, too?"""
    other = "miss" if vector["answer"] == "hit" else "hit"
    return vector.get("margin", {}).get(other, 1) <= 1e-9 or vector.get("event") == "touch"


class Allowed(InFolder):
    """What is right beside the exact answer, and what happens in the case."""

    KNOWN = [
        ("sphere 0 0 5 0 0 -1 0 inf 0 0 0 1", None, {}),
        ("sphere 1 0 5 0 0 -1 0 inf 0 0 0 1", "touch", {"miss": 1e-12}),
        ("sphere 1.0000000001 0 5 0 0 -1 0 inf 0 0 0 1", None, {"hit": 1e-9}),
        ("sphere 0.9999999 0 5 0 0 -1 0 inf 0 0 0 1", None, {"miss": 1e-6}),
        ("sphere 0.9999 0 5 0 0 -1 0 inf 0 0 0 1", None, {"miss": 1e-3}),
        ("sphere 0.99 0 5 0 0 -1 0 inf 0 0 0 1", None, {}),
        ("sphere 0 0 1 0 0 -1 0 inf 0 0 0 1", "surface", {"t": 1e-12}),
        ("sphere 0 0 1 0 0 1 0 inf 0 0 0 1", "surface", {"miss": 1e-12}),
        ("sphere 0 0 0 0 0 1 0 1.0000000001 0 0 0 1", "inside", {"miss": 1e-9}),
        ("sphere 0 0 0 0 0 1 0 0.5 0 0 0 1", "inside", {}),
        ("sphere 0 0 5 0 0 -1 0 4 0 0 0 1", "end", {"miss": 1e-12}),
        ("sphere 0 0 5 0 0 0 0 4 0 0 0 1", None, {}),
        ("cylinder -1.9999999 0 3 1 0 -1 0 inf 0 0 0 0 0 2 1", None, {"wall": 1e-6}),
        ("plane 0 0 5 0 0 -1 4.9999999999 9 0 0 0 0 0 1", None, {"miss": 1e-9}),
    ]

    def test_known(self):
        for line, event, margin in self.KNOWN:
            put("a.cases", line + "\n")
            shape = line.split()[0]
            self.succeed("vectors", "--shape", shape, "--count", "0", "--cases", "a.cases")
            vector = json.loads(contents(f"{shape}.jsonl").splitlines()[1])
            self.assertEqual((vector.get("event"), vector.get("margin", {})), (event, margin), line)

    def test_entries(self):
        for name, shape in FILES.items():
            self.assertEqual(head(name)["entry"],
                             {"unit": "unit", "unit_local": "unit local", "float": "float"}.get(
                                 name.split("/")[0], ""))
            for vector in lines(name):
                self.check_entry(name.split("/")[0], shape,
                                 [of_bits(digits) for digits in vector["case_bits"]])

    def check_entry(self, entry, shape, numbers):
        if entry in ("unit", "unit_local"):
            self.assertLess(abs(sum(Fraction(d) ** 2 for d in numbers[3:6]) - 1), 2**-50)
        if entry == "unit_local" and shape in ("plane", "disc", "cylinder", "cone"):
            self.assertEqual((numbers[8:13], numbers[13] > 0), ([0] * 5, True))
        if entry == "float":
            for number in numbers:
                self.assertEqual(repr(ctypes.c_float(number).value), repr(number))


class Loaders(InFolder):
    """docs/examples/vectors.*, in each language that is there."""

    def check_loader(self, *command):
        def load(path):
            return subprocess.run([*command, path], check=False, capture_output=True, text=True)

        for name in ("./sphere.jsonl", "unit/cone.jsonl", "float/box.jsonl"):
            expected = lines(name)
            said = load(FROZEN / name).stdout.splitlines()
            self.assertEqual(len(said), len(expected))
            for line, vector in zip(said, expected):
                self.check_line(line, vector)
        whole = contents(FROZEN / "sphere.jsonl")
        for spoiled in (whole.replace(b'"miss"', b'"hit"', 1), whole[:-200],
                        whole[:whole.rindex(b"\n", 0, -1) + 1],
                        whole.replace(b'"surehit_vectors":2', b'"surehit_vectors":3')):
            put("spoiled.jsonl", spoiled)
            self.assertNotEqual(load("spoiled.jsonl").returncode, 0)

    def check_line(self, line, vector):
        numbers, answer = line.split(":")
        answer, *rest = answer.split()
        read = [float(number) for number in numbers.split()]
        for number, digits in zip(read, vector["case_bits"], strict=True):
            self.assertTrue(number == of_bits(digits) or number != number, line)
        self.assertEqual(answer, vector["answer"])
        if answer == "hit":
            self.assertEqual(float(rest.pop(0)), of_bits(vector["t_bits"]))
        other = ["or", "miss" if answer == "hit" else "hit"]
        self.assertEqual(rest, other if allows(vector) else [])

    def test_python(self):
        self.check_loader(sys.executable, EXAMPLES / "vectors.py")

    def test_c(self):
        subprocess.run([*CC, EXAMPLES / "vectors.c", "-o", "loader"], check=True)
        self.check_loader("./loader")

    @unittest.skipUnless(shutil.which("rustc"), "no rustc")
    def test_rust(self):
        subprocess.run(["rustc", EXAMPLES / "vectors.rs", "-o", "loader"], check=True)
        self.check_loader("./loader")

    @unittest.skipUnless(shutil.which("node"), "no node")
    def test_javascript(self):
        self.check_loader("node", EXAMPLES / "vectors.js")


class Command(InFolder):
    def test_one_shape(self):
        self.succeed("vectors", "--shape", "disc")
        self.assertEqual(os.listdir("."), ["disc.jsonl"])
        made, whole = contents("disc.jsonl"), contents(FROZEN / "disc.jsonl")
        made, whole = made.split(b"\n", 1)[1], whole.split(b"\n", 1)[1]
        self.assertTrue(whole.startswith(made) and len(made) < len(whole))

    def test_others(self):
        self.succeed("vectors", "--shape", "cone", "--regime", "apex", "--count", "3")
        self.assertEqual([(vector["from"], vector["number"]) for vector in
                          map(json.loads, contents("cone.jsonl").splitlines()[1:])],
                         [("apex", 0), ("apex", 1), ("apex", 2)])

    def test_beyond_doubles(self):
        """A wall's first hit is at 2^1100: no next double has a point that could be asked for."""
        way = "0 0x1p700 1 0 -0x1p-400 0 0 inf"
        put("a.cases", f"cone {way} 0 0 4 0 0 0 1\ncylinder {way} 0 0 0 0 0 4 1\n")
        for shape in ("cone", "cylinder"):
            self.succeed("vectors", "--entry", "wall", "--shape", shape, "--count", "0",
                         "--cases", "a.cases")
            self.assertEqual(json.loads(contents(f"{shape}.jsonl").splitlines()[1])["t"], "inf")

    def test_refused(self):
        good = "# one\n\nsphere 0 0 0 0 0 -1 0 inf 0 0 -5 1 -> hit 4 ; why\n"
        for bad in ("cone 1 2\n", "sphere " + "0 " * 2000 + "\n"):
            put("a.cases", good + bad)
            self.fail_with(WRONG_USAGE, ".*line 4 is no case.*", "vectors", "--cases", "a.cases")
        self.fail_with(WRONG_USAGE, ".*No such file.*", "vectors", "--cases", "/nowhere/cases")


@unittest.skipIf(not REFERENCE, "the reference was not built")
class Reference(unittest.TestCase):
    def test_cgal_says_the_same(self):
        for name, shape in FILES.items():
            vectors = lines(name)
            asked = "".join(" ".join([shape, *vector["case"]]) + "\n" for vector in vectors)
            said = subprocess.run(REFERENCE, input=asked, check=True, capture_output=True,
                                  text=True).stdout.splitlines()
            self.assertEqual(said, list(map(answer_line, vectors)))


if __name__ == "__main__":
    if sys.argv[2:] == ["--accept"]:
        sys.exit(freeze(FROZEN))
    unittest.main(argv=sys.argv[:1])
