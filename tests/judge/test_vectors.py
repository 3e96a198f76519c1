"""The frozen vectors (docs/vectors.md): their bytes, their reader, and what CGAL says to them.

    test_vectors.py SUREHIT ROOT [REFERENCE]            the tests
    test_vectors.py SUREHIT ROOT --accept               renews the files

REFERENCE is the program surehit-reference."""

import filecmp
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from shapes import SHAPES  # noqa: E402

SUREHIT, ROOT = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
REFERENCE = [os.path.abspath(word) for word in sys.argv[3:4]]
FROZEN = ROOT / "tests/vectors"
MOST_BYTES = 650_000 * len(SHAPES)


def freeze(folder, *words):
    cases = [word for shape in SHAPES
             for word in ("--cases", str(ROOT / f"tests/cases/{shape}.cases"))]
    return subprocess.run([SUREHIT, "vectors", *cases, *words, "-o", folder], check=False,
                          capture_output=True, text=True)


def lines(shape):
    """The objects of a file without its head."""
    with open(FROZEN / f"{shape}.jsonl", encoding="ascii") as file:
        next(file)
        return [json.loads(line) for line in file]


def of_bits(digits):
    return struct.unpack(">d", bytes.fromhex(digits))[0]


def answer_line(vector):
    if vector["answer"] == "hit":
        return " ".join(["hit", vector["t"], vector["part"], *vector["normal"]])
    return " ".join(["invalid", vector["field"]] if vector["answer"] == "invalid" else ["miss"])


class Bytes(unittest.TestCase):
    def test_the_same_bytes(self):
        with tempfile.TemporaryDirectory() as folder:
            made = freeze(folder)
            self.assertEqual((made.returncode, made.stdout, made.stderr), (0, "", ""))
            self.assertEqual(sorted(os.listdir(folder)),
                             sorted(f"{shape}.jsonl" for shape in SHAPES))
            stale = [name for name in sorted(os.listdir(folder))
                     if not filecmp.cmp(os.path.join(folder, name), FROZEN / name, shallow=False)]
            self.assertEqual(stale, [], "renew them with `meson compile accept-vectors`")

    def test_size(self):
        files = sorted(FROZEN.glob("*.jsonl"))
        self.assertEqual([file.stem for file in files], sorted(SHAPES))
        self.assertLess(sum(file.stat().st_size for file in files), MOST_BYTES)

    def test_as_documented(self):
        """Keys and their order; both forms of a number say the same; no blanks."""
        page = (ROOT / "docs/vectors.md").read_text(encoding="utf-8")
        documented = re.findall(r"`(\w+)`", "".join(re.findall(r"^\| (`\w+`.*?) \|", page, re.M)))
        head_keys, keys = documented[:3], documented[3:]
        hits = 0
        for shape in SHAPES:
            text = (FROZEN / f"{shape}.jsonl").read_text(encoding="ascii")
            self.assertNotIn(" ", text)
            head, *rest = map(json.loads, text.splitlines())
            self.assertEqual(list(head), head_keys)
            self.assertEqual((head["surehit_vectors"], head["shape"]), (1, shape))
            for vector in rest:
                self.assertEqual(list(vector), [key for key in keys if key in vector])
                self.assertEqual(len(vector["case"]), len(head["case"]))
                self.check_numbers(vector["case"], vector["case_bits"])
                if vector["answer"] == "hit":
                    self.check_numbers([vector["t"]], [vector["t_bits"]])
                    self.check_numbers(vector["normal"], vector["normal_bits"])
                    hits += 1
        self.assertGreater(hits, 1000)
        self.assertIn("More than 3600 cases", page)
        self.assertGreater(sum(len(lines(shape)) for shape in SHAPES), 3600)

    def check_numbers(self, texts, bits):
        self.assertEqual(len(texts), len(bits))
        for text, digits in zip(texts, bits):
            number = of_bits(digits)
            self.assertRegex(digits, "^[0-9a-f]{16}$")
            if text == "nan":
                self.assertNotEqual(number, number)
            else:
                self.assertEqual(struct.pack(">d", float.fromhex(text)).hex(), digits)


class Page(unittest.TestCase):
    def test_the_reader(self):
        """The page's program, as it stands there, and in ten lines."""
        page = (ROOT / "docs/vectors.md").read_text(encoding="utf-8")
        program = re.search(r"^```python\n(.*?)^```", page, re.M | re.S)[1]
        self.assertLessEqual(len([line for line in program.splitlines() if line]), 10)
        names = {}
        exec(program, names)  # pylint: disable=exec-used
        for shape in SHAPES:
            expected = lines(shape)
            read = list(names["vectors"](FROZEN / f"{shape}.jsonl"))
            self.assertEqual(len(read), len(expected))
            for (ray, solid, answer, part, t), vector in zip(read, expected):
                numbers = [of_bits(digits) for digits in vector["case_bits"]]
                self.assertEqual(list(map(repr, ray + solid)), list(map(repr, numbers)))
                self.assertEqual((len(ray), answer, part), (8, vector["answer"],
                                                           vector.get("part")))
                self.assertEqual(repr(t), repr(of_bits(vector["t_bits"]) if answer == "hit"
                                               else None))
        with tempfile.NamedTemporaryFile("w", suffix=".jsonl") as later:
            later.write('{"surehit_vectors":2}\n')
            later.flush()
            with self.assertRaises(AssertionError):
                list(names["vectors"](later.name))


class Command(unittest.TestCase):
    def test_one_shape(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([SUREHIT, "vectors", "--shape", "disc"], cwd=folder, check=True)
            self.assertEqual(os.listdir(folder), ["disc.jsonl"])
            with open(os.path.join(folder, "disc.jsonl"), encoding="ascii") as file:
                made = file.read()
            whole = (FROZEN / "disc.jsonl").read_text(encoding="ascii")
            self.assertTrue(whole.startswith(made) and len(made) < len(whole))

    def check_refused(self, status, pattern, *words):
        with tempfile.TemporaryDirectory() as folder:
            result = subprocess.run([SUREHIT, "vectors", *words], cwd=folder, check=False,
                                    capture_output=True, text=True)
            self.assertEqual(result.returncode, status)
            self.assertRegex(result.stderr, pattern)
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
            self.assertEqual(os.listdir(folder), [])

    def test_refused(self):
        with tempfile.NamedTemporaryFile("w", suffix=".cases") as cases:
            cases.write("# one\n\nsphere 0 0 0 0 0 -1 0 inf 0 0 -5 1 -> hit 4 ; why\ncone 1 2\n")
            cases.flush()
            self.check_refused(2, "line 4 is no case", "--cases", cases.name)
            cases.write("sphere " + "0 " * 2000 + "\n")
            cases.flush()
            self.check_refused(2, "line 4 is no case", "--cases", cases.name)
        self.check_refused(2, "No such file", "--cases", "/nowhere/cases")
        self.check_refused(2, "unknown option", "--count", "3")
        self.check_refused(2, "one word too many", "sphere")
        self.check_refused(2, "shape", "--shape", "torus")
        self.check_refused(1, "nowhere", "-o", "/nowhere/at/all")

    def test_help(self):
        result = subprocess.run([SUREHIT, "vectors", "--help"], check=True, capture_output=True,
                                text=True)
        self.assertIn("--cases FILE", result.stdout)
        self.assertLessEqual(max(map(len, result.stdout.splitlines())), 80)


@unittest.skipIf(not REFERENCE, "the reference was not built")
class Reference(unittest.TestCase):
    def test_cgal_says_the_same(self):
        for shape in SHAPES:
            vectors = lines(shape)
            asked = "".join(" ".join([shape, *vector["case"]]) + "\n" for vector in vectors)
            said = subprocess.run(REFERENCE, input=asked, check=True, capture_output=True,
                                  text=True).stdout.splitlines()
            self.assertEqual(said, list(map(answer_line, vectors)))


if __name__ == "__main__":
    if sys.argv[3:] == ["--accept"]:
        renewed = freeze(FROZEN)
        sys.exit(renewed.stderr or renewed.returncode)
    unittest.main(argv=sys.argv[:1])
