# SPDX-License-Identifier: MIT
"""Pieces of any command: each is done once, whole or not at all, and only those of one plan add up.

    test_commands.py"""
import itertools
import json
import os
import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
COMMANDS, FUZZ = str(HERE / "commands.py"), str(ROOT / "fuzz" / "run")
sys.argv = [sys.argv[0], COMMANDS]
sys.path.insert(0, str(HERE.parent / "support"))
from commands import InFolder, contents, put  # noqa: E402
from sealed import lines_of, sealed  # noqa: E402
sys.path.insert(0, str(ROOT / "fuzz"))
from engines import sources_of  # noqa: E402

COMPLAINTS, WRONG, MISSING = 1, 2, 3


class Commands(InFolder):
    def plan(self, manifest, pieces, script):
        self.succeed("plan", "--pieces", str(pieces), "-o", manifest, "sh", "-c", script)

    def work(self, manifest, folder, numbers):
        for number in numbers:
            self.succeed("work", manifest, str(number), folder)

    def refuse(self, complaint, *words):
        self.fail_with(WRONG, f"commands.py: error: .*{complaint}.*", *words)

    def missing(self, manifest, folder, expected):
        said = self.ask(MISSING if expected else 0, "status", manifest, folder)
        self.assertEqual(said.stdout, f"{expected}\n")
        return said.stderr

    def test_pieces_in_any_order(self):
        self.plan("m", 3, "echo piece {piece} of {pieces}")
        self.work("m", "done", [3, 1, 2])
        records = []
        for order in itertools.permutations(["done/1.json", "done/2.json", "done/3.json"]):
            self.succeed("merge", *order, "-o", "sum")
            records.append(contents("sum"))
        said = self.ask(COMPLAINTS, "merge", "done/1.json", "done/3.json", "-o", "most")
        self.assertEqual(said.stdout, "2 of 3 pieces, 0 with complaints\n")
        self.succeed("merge", "most", "done/2.json", "-o", "sum")
        records.append(contents("sum"))
        self.assertEqual(len(set(records)), 1)
        self.assertEqual(self.succeed("said", "sum"),
                         "piece 1 of 3\npiece 2 of 3\npiece 3 of 3\n")

    def test_done_once(self):
        self.plan("m", 2, f"echo {{piece}} >> '{os.path.abspath('ran')}'")
        self.work("m", "done", [1, 1, 2, 1])
        self.assertEqual(len(pathlib.Path("ran").read_text().split()), 2)

    def test_what_is_missing(self):
        self.plan("m", 7, "echo {piece}")
        self.missing("m", "done", "1-7")
        self.work("m", "done", [2, 5])
        self.assertIn("2 of 7 pieces are done, 28.57 % of all",
                      self.missing("m", "done", "1,3-4,6-7"))
        put("done/2.json", contents("done/2.json")[:-5])
        self.assertIn("done/2.json", self.missing("m", "done", "1-4,6-7"))
        self.work("m", "done", [1, 3, 4, 6, 7])
        self.assertIn("done/2.json", self.ask(0, "work", "m", "2", "done").stderr)
        self.missing("m", "done", "")

    def test_complaints_are_results_and_crashes_are_none(self):
        self.plan("m", 3, "echo {piece}; exit $(({piece} - 1))")
        self.work("m", "done", [1, 2])
        self.refuse("piece 3: sh: ended with status 2", "work", "m", "3", "done")
        self.missing("m", "done", "3")
        said = self.ask(COMPLAINTS, "merge", "done", "-o", "sum")
        self.assertEqual(said.stdout, "2 of 3 pieces, 1 with complaints: 2\n")
        self.plan("killed", 1, "kill -9 $$; echo {piece}")
        os.mkdir("of_killed")
        self.refuse("ended with status -9", "work", "killed", "1", "of_killed")
        self.plan("silent", 1, "exit {piece}")
        os.mkdir("of_silent")
        self.refuse("ended with status 1 and no complaint", "work", "silent", "1", "of_silent")
        self.missing("silent", "of_silent", "1")

    def test_what_is_refused(self):
        self.plan("m", 2, "echo {piece}")
        self.plan("other", 2, "echo not {piece}")
        self.work("m", "done", [1, 2])
        self.work("other", "others", [1])
        self.refuse("done/1.json: piece 1 is in another file, too",
                    "merge", "done", "done/1.json", "-o", "sum")
        self.refuse("has another surehit command than", "merge", "done", "others", "-o",
                    "sum")
        for way in (["work", "other", "1", "done"], ["status", "other", "done"]):
            self.refuse("done/1.json: is another plan's", *way)
        self.refuse("others/1.json: may not take the place of a file that is read", "merge",
                    "others", "-o", "others/1.json")
        os.mkfifo("pipe")
        self.refuse("pipe: is no regular file", "merge", "done", "-o", "pipe")
        os.unlink("pipe")
        os.mkdir("moved")
        put("moved/1.json", contents("done/2.json"))
        for way in (["work", "m", "1", "moved"], ["status", "m", "moved"]):
            self.refuse("moved/1.json: is no result of piece 1", *way)
        head, piece = lines_of("done/2.json")
        for bad in ({}, {**piece, "piece": 3}, {**piece, "piece": "2"}, {**piece, "status": 2},
                    {**piece, "more": 1}):
            put("bad", sealed([head, bad]))
            self.refuse("bad: has what is no piece", "merge", "bad", "-o", "sum")
        for bad in ([{"surehit command": ["ls"]}], [[]], [7, 8]):
            put("bad", sealed(bad))
            self.refuse("bad", "merge", "bad", "-o", "sum")
        self.refuse("m: piece 3: has no such piece", "work", "m", "3", "done")
        self.succeed("plan", "--pieces", "1", "-o", "dashes", "--", "echo", "{piece}")
        self.work("dashes", "of_dashes", [1])
        self.refuse("no .piece. in the command", "plan", "--pieces", "2", "-o", "m2", "ls")
        self.refuse("expected a number above 0", "plan", "--pieces", "0", "-o", "m2",
                    "echo", "{piece}")
        os.mkdir("empty")
        self.refuse("no piece is there", "merge", "empty", "-o", "sum")
        head = lines_of("m")[0]
        put("older", sealed([{**head, "sources": "0" * 16}]))
        self.refuse("older: is for another program than this one", "work", "older", "1",
                    "done")
        self.assertFalse(os.path.exists("sum") or os.path.exists("m2"))


class Fuzzed(InFolder):
    """What fuzz/run --add takes."""

    def refuse(self, complaint, *words):
        said = self.ask(WRONG, *words, program=FUZZ)
        self.assertIn(complaint, said.stderr)

    def test_what_is_refused(self):
        piece = {"target": "case", "engine": "libfuzzer", "sanitizers": "", "executions": 10,
                 "compared": 9, "seconds": 1.0, "edges": 8, "finds": [], "inputs": {}}
        put("one", json.dumps({**piece, "sources": "0" * 16}) + "\n")
        self.refuse("one:1: case: is of other sources", "--add", "one")
        put("none", "")
        self.refuse("none: has no piece", "--add", "none")
        put("text", "9 mutants\n")
        self.refuse("text:1: expected what --piece writes", "--add", "text")
        self.refuse("expected I/K", "case", "--executions", "9", "--piece", "3/2")
        self.refuse("--piece wants --executions", "case", "--piece", "1/2")
        self.refuse("--add takes what is in its file", "case", "--add", "none")

    def test_what_is_no_piece(self):
        """Before anything is written."""
        record = contents(ROOT / "fuzz" / "record.json")
        piece = {"target": "case", "engine": "libfuzzer", "sanitizers": "", "executions": 10,
                 "compared": 9, "seconds": 1.0, "edges": 8, "finds": [], "inputs": {},
                 "sources": sources_of("case")}
        put("twice", (json.dumps(piece) + "\n") * 2)
        self.refuse("twice:2: case: is there twice", "--add", "twice", "--record")
        for wrong in ({"target": "nix"}, {"engine": "nix"}, {"sanitizers": []}, {"compared": -1},
                      {"executions": "9"}, {"seconds": float("nan")}, {"finds": [1]},
                      {"inputs": {"../../own": "41"}}, {"inputs": {"0" * 16: "4"}},
                      {"inputs": ["41"]}):
            put("bad", json.dumps(piece) + "\n" + json.dumps({**piece, **wrong}) + "\n")
            self.refuse("bad:2: expected what --piece writes", "--add", "bad", "--record")
        put("other", json.dumps(piece) + "\n" + json.dumps({**piece, "engine": "afl"}) + "\n")
        self.refuse("other:2: case: is by another engine", "--add", "other", "--record")
        self.assertEqual(contents(ROOT / "fuzz" / "record.json"), record)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
