"""The frozen vectors (docs/vectors.md): their bytes, their reader, and what CGAL says to them.

    test_vectors.py SUREHIT [REFERENCE]            the tests
    test_vectors.py SUREHIT --accept               renews the files

REFERENCE is the program surehit-reference."""

import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from commands import PROGRAM, ROOT, WRONG_USAGE, InFolder, all_files, contents, put  # noqa: E402
from shapes import SHAPES  # noqa: E402

REFERENCE = [os.path.abspath(word) for word in sys.argv[2:3]]
FROZEN = pathlib.Path(ROOT, "tests/vectors")
PAGE = pathlib.Path(ROOT, "docs/vectors.md").read_text(encoding="utf-8")
MOST_BYTES = 650_000 * len(SHAPES)


def freeze(folder):
    """The words that make the files in a folder."""
    cases = [f"--cases={ROOT}/tests/cases/{shape}.cases" for shape in SHAPES]
    return ["vectors", *cases, "-o", str(folder)]


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


class Bytes(InFolder):
    def test_the_same_bytes(self):
        self.assertEqual(self.succeed(*freeze(".")), "")
        there = {f"./{shape}.jsonl": contents(FROZEN / f"{shape}.jsonl") for shape in SHAPES}
        self.assertEqual(all_files().keys(), there.keys())
        stale = [path for path, made in all_files().items() if there[path] != made]
        self.assertEqual(stale, [], "renew them with `meson compile accept-vectors`")

    def test_size(self):
        files = sorted(FROZEN.glob("*.jsonl"))
        self.assertEqual([file.stem for file in files], sorted(SHAPES))
        self.assertLess(sum(file.stat().st_size for file in files), MOST_BYTES)

    def test_as_documented(self):
        """Keys and their order; both forms of a number say the same; no blanks."""
        documented = re.findall(r"`(\w+)`", "".join(re.findall(r"^\| (`\w+`.*?) \|", PAGE, re.M)))
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
        self.assertIn("More than 3600 cases", PAGE)
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


class Page(InFolder):
    def test_the_reader(self):
        """The page's program, as it stands there, and in ten lines."""
        program = re.search(r"^```python\n(.*?)^```", PAGE, re.M | re.S)[1]
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
        put("later.jsonl", '{"surehit_vectors":2}\n')
        with self.assertRaises(AssertionError):
            list(names["vectors"]("later.jsonl"))


class Command(InFolder):
    def test_one_shape(self):
        self.succeed("vectors", "--shape", "disc")
        self.assertEqual(os.listdir("."), ["disc.jsonl"])
        made, whole = contents("disc.jsonl"), contents(FROZEN / "disc.jsonl")
        self.assertTrue(whole.startswith(made) and len(made) < len(whole))

    def test_refused(self):
        good = "# one\n\nsphere 0 0 0 0 0 -1 0 inf 0 0 -5 1 -> hit 4 ; why\n"
        for bad in ("cone 1 2\n", "sphere " + "0 " * 2000 + "\n"):
            put("a.cases", good + bad)
            self.fail_with(WRONG_USAGE, ".*line 4 is no case.*", "vectors", "--cases", "a.cases")
        self.fail_with(WRONG_USAGE, ".*No such file.*", "vectors", "--cases", "/nowhere/cases")


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
    if sys.argv[2:] == ["--accept"]:
        sys.exit(subprocess.run([PROGRAM, *freeze(FROZEN)], check=False).returncode)
    unittest.main(argv=sys.argv[:1])
