# SPDX-License-Identifier: MIT
"""Pieces of any command: each is done once, whole or not at all, and only those of one plan add up.

    test_commands.py"""
import argparse
import itertools
import json
import os
import pathlib
import runpy
import signal
import sys
import unittest
from unittest import mock

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
COMMANDS, FUZZ = str(HERE / "commands.py"), str(ROOT / "fuzz" / "run")
sys.argv = [sys.argv[0], COMMANDS]
sys.path.insert(0, str(HERE.parent / "support"))
from commands import InFolder, contents, put  # noqa: E402
from sealed import lines_of, sealed  # noqa: E402
sys.path.insert(0, str(ROOT / "fuzz"))
import coverage  # noqa: E402
import engines  # noqa: E402
import page  # noqa: E402
from engines import sources_of  # noqa: E402

COMPLAINTS, WRONG, MISSING = 1, 2, 3
TAKE_PIECE = runpy.run_path(FUZZ)["take_piece"]
SOURCES = runpy.run_path(COMMANDS)["sources"]


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

    def test_where_a_command_runs(self):
        """Where the tree begins; what is no text is told as far as it is."""
        self.plan("m", 1, "pwd; printf '\\377'; : {piece}")
        self.work("m", "done", [1])
        self.assertEqual(self.succeed("said", "done/1.json"), f"{ROOT}\n\ufffd")

    def test_what_is_written_and_read(self):
        """What everybody may read, where a link leads; of a folder results alone."""
        os.symlink("there", "m")
        self.plan("m", 1, "echo {piece}")
        self.assertTrue(os.path.islink("m"))
        self.work("there", "done", [1])
        self.assertEqual(os.stat("done/1.json").st_mode & 0o777, 0o644)
        os.mkdir("done/logs")
        put("done/notes", "")
        self.succeed("merge", "done", "-o", "sum")

    def test_what_a_plan_is_for(self):
        """Names and bytes of sources in each folder, and nothing that comes and goes."""
        with mock.patch.dict(SOURCES.__globals__, ROOT=pathlib.Path.cwd()):
            seen = [SOURCES()]
            for path, data, changes in (
                    ("src/a.c", "1", True), ("src/a.c", "2", True), ("src/b.c", "2", True),
                    ("include/a.h", "", True), ("tests/a.py", "", True), ("fuzz/run", "", True),
                    ("reference/peers/meson.build", "", True), ("docs/a.c", "", False),
                    ("src/a.md", "", False), ("fuzz/__pycache__/a.py", "", False),
                    ("reference/node_modules/a.h", "", False)):
                os.makedirs(os.path.dirname(path), exist_ok=True)
                put(path, data)
                seen.append(SOURCES())
                self.assertEqual(seen[-1] not in seen[:-1], changes, path)
            os.rename("src/b.c", "src/c.c")
            self.assertNotIn(SOURCES(), seen)

    def test_what_is_refused(self):
        self.plan("m", 2, "echo {piece}")
        self.plan("other", 2, "echo not {piece}")
        self.work("m", "done", [1, 2])
        self.work("other", "others", [1])
        self.refuse("done/1.json: piece 1 is in another file, too",
                    "merge", "done", "done/1.json", "-o", "sum")
        self.refuse("has another surehit command than", "merge", "done", "others", "-o",
                    "sum")
        head, piece = lines_of("done/2.json")
        put("more", sealed([{**head, "more": 1}, piece]))
        self.refuse("more: has another more than done/1.json", "merge", "done/1.json", "more", "-o",
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
                    {**piece, "more": 1}, {**piece, "piece": True}, {**piece, "status": 0.0}, 7,
                    [1]):
            put("bad", sealed([head, bad]))
            for way in (["merge", "bad", "-o", "sum"], ["said", "bad"]):
                self.refuse("bad: has what is no piece", *way)
        for bad in ([{"surehit command": ["ls"]}], [[]], [7, 8], [{**head, "pieces": "2"}, piece],
                    [{**head, "surehit command": 5}, piece]):
            put("bad", sealed(bad))
            for way in (["merge", "bad", "-o", "sum"], ["work", "bad", "1", "done"]):
                self.refuse("bad: is damaged, or of something else", *way)
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


class FuzzingKept(InFolder):
    """What a run of the fuzzer leaves behind, in a folder in place of the tree."""
    NAMES = "case", "libfuzzer", ""

    def replace(self, room, **others):
        for name, other in others.items():
            patch = mock.patch.object(room, name, other)
            patch.start()
            self.addCleanup(patch.stop)

    def setUp(self):
        super().setUp()
        self.replace(engines, ROOT=pathlib.Path.cwd())
        self.replace(page, RECORD=pathlib.Path("record.json"))

    def add(self, sources, finds=(), piece=None, edges=8):
        result = engines.Result("case")
        result.executions, result.compared, result.seconds = 10, 9, 1.5
        result.edges, result.finds = edges, list(finds)
        page.add_run(*self.NAMES, sources, result, piece)
        return page.read()["runs"]["case libfuzzer"]

    def test_runs_add_up(self):
        """Those of the same sources, until one finds something."""
        self.add("old")
        row = self.add("old", edges=3)
        self.assertEqual([row[name] for name in ("executions", "compared", "seconds", "edges")],
                         [20, 18, 3.0, 8])
        self.assertEqual(page.compared_so_far(*self.NAMES, "old"), 18)
        self.assertEqual(page.compared_so_far(*self.NAMES, "new"), 0)
        self.assertEqual(self.add("new")["compared"], 9)
        self.assertEqual(self.add("new", finds=["a law"])["finds"], 1)
        self.assertEqual(page.compared_so_far(*self.NAMES, "new"), 0)
        self.assertEqual(self.add("new")["compared"], 9)

    def test_pieces_are_remembered(self):
        for piece in ("one", "two", None):
            self.add("old", piece=piece)
        found = [page.has_run(*self.NAMES, "old", piece) for piece in ("one", "two", "three")]
        self.assertEqual(found, [True, True, False])
        self.assertFalse(page.has_run(*self.NAMES, "new", "one"))

    def test_seeded_bugs_that_are_gone(self):
        for name in ("here", "gone"):
            bug = argparse.Namespace(name=name, stem="case", source="a.c", why="wrong")
            page.add_seeded(bug, 1.234, "a law")
        page.drop_seeded({"here", "new"})
        self.assertEqual(list(page.read()["seeded"]), ["here"])
        self.assertEqual(page.read()["seeded"]["here"]["seconds"], 1.23)

    def test_shares_add_up(self):
        for executions, pieces in itertools.product((4, 7, 100), (1, 3, 4)):
            shares = [argparse.Namespace(piece=f"{i}/{pieces}", executions=executions, record=False)
                      for i in range(1, pieces + 1)]
            for share in shares:
                TAKE_PIECE(None, share)
            self.assertEqual(sum(share.executions for share in shares), executions)
            self.assertEqual(len({share.number for share in shares}), pieces)

    def test_what_is_found(self):
        for log, found in (("INFO\nfind: case: a law\nline\nother\nmore", "find: case: a law\n"
                            "line\nother"),
                           ("x\nSUMMARY: AddressSanitizer: heap-use a.c:3", "AddressSanitizer: "
                            "heap-use"),
                           ("nothing", "ended with status 77")):
            self.assertEqual(engines.find_in(log, 77), found)

    def test_an_interruption_is_no_find(self):
        processes = engines.Processes()
        for interrupted, fine in ((False, [0]), (True, [0, engines.INTERRUPTED, -signal.SIGTERM,
                                                        -signal.SIGINT])):
            processes.interrupted = interrupted
            for code in (0, 1, 77, engines.INTERRUPTED, -signal.SIGTERM, -signal.SIGINT,
                         -signal.SIGSEGV):
                process = argparse.Namespace(returncode=code)
                self.assertEqual(processes.failed(process), code not in fine, (interrupted, code))

    def test_what_is_kept_of_a_corpus(self):
        """What was made by hand, and of what the engine leaves the smallest."""
        file = pathlib.Path("fuzz/corpus/case.hex")
        file.parent.mkdir(parents=True)
        file.write_text("0123456789abcdef 05\nby_hand 0203\n")
        left = {"a" * 40: b"\1\2\3", "b" * 40: b"\4", "c" * 40: b"\5\6"}

        def merge(command):
            for name, data in left.items():
                (command[-2] / name).write_bytes(data)
        self.replace(engines, quietly=merge, MOST_FILES=2)
        build = argparse.Namespace(folder=pathlib.Path("build"), program=str)
        engines.minimise(build, "case", pathlib.Path("corpus"))
        self.assertEqual(engines.committed("case"),
                         {"b" * 16: b"\4", "by_hand": b"\2\3", "c" * 16: b"\5\6"})
        self.assertEqual(engines.corpus_size("case"), (3, 5))

    def test_sources(self):
        """Without comments, blanks, other shapes and bounds that are not used."""
        cone, disc = "src/shapes/cone/cone.c", "src/shapes/disc/disc.c"
        bounds, code = "include/surehit/bounds.h", "int a = SURE_USED; /* x */\n"
        last, seen = None, []
        for path, text, changes in ((disc, "int b;\n", True), (cone, code, True),
                                    (bounds, "#define SURE_USED 1\n", True),
                                    (cone, "int a =\n  SURE_USED; /* y\n */", False),
                                    (disc, "int c;\n", False),
                                    (bounds, "#define SURE_USED 1\n#define SURE_NOT 2\n", False),
                                    (bounds, "#define SURE_USED 3\n", True),
                                    (cone, "int d = SURE_USED;", True)):
            pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
            pathlib.Path(path).write_text(text)
            pathlib.Path(bounds).parent.mkdir(parents=True, exist_ok=True)
            pathlib.Path(bounds).touch()
            now = sources_of("cone")
            seen += [] if path == disc and last is None else [(now != last) == changes]
            last = now
        self.assertEqual(seen, [True] * 7)
        self.assertNotEqual(sources_of("disc"), last)

    def test_what_is_not_reached(self):
        """A reason is one for so many lines and branches, neither more nor fewer."""
        path, other = "src/numbers/a.c", "src/stages/b.c"
        for name in (path, other):
            pathlib.Path(name).parent.mkdir(parents=True)
            pathlib.Path(name).write_text("first;\n  second;\n")
        pathlib.Path("fuzz").mkdir()
        pathlib.Path("fuzz/unreachable").write_text(f"{path} | 3 | second; | why\n"
                                                    f"{other} | 1 | second; | so\n")
        lines = {(path, 1): 4, (path, 2): 0, (other, 1): 0}
        branches = {(path, 2, "f", 2, 0): 0, (path, 2, "f", 2, 1): 5,
                    (other, 2, "g", 2, 0): 0, (other, 2, "g", 2, 1): 0}
        self.assertEqual(coverage.judged(lines, branches), [
            [path, 2, "second;", ""], [other, 1, "first;", ""], [other, 2, "second;", ""]])
        pathlib.Path("fuzz/unreachable").write_text(f"{path} | 2 | second; | why\n")
        self.assertEqual(coverage.judged(lines, branches)[0][3], "why")
        rooms = coverage.summed(lines, branches)
        self.assertEqual(list(rooms["src/numbers"].values()), [2, 1, 2, 1])
        self.assertEqual(list(rooms["src/stages"].values()), [1, 1, 2, 2])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
