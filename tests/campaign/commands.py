#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Any command in pieces, for those who know none of their own: mutants, fuzzing.

    commands.py plan --pieces N -o MANIFEST COMMAND WORD ...
    commands.py work MANIFEST NUMBER FOLDER
    commands.py status MANIFEST FOLDER
    commands.py merge FOLDER|RECORD ... -o RECORD
    commands.py said RECORD

The command is run where the tree begins. In its words {piece} is the piece's number, {pieces} how
many there are. What it writes to its standard output is the result of a piece, if it ends with 0,
or with 1 and complaints. The scripts beside this one take commands.py in the place of a campaign's
program: `status` prints the pieces that are missing, and ends with 3 if there are any; `merge` ends
with 1 where a piece does, or is missing. `said` writes what all pieces wrote, in their order."""
import argparse
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
from sealed import sealed  # noqa: E402

FOLDERS = ["include", "src", "tests", "fuzz", "reference"]
ENDINGS = {".c", ".h", ".cpp", ".def", ".py", ".mutants", ".gappa", ".build", ".hex", ""}
IGNORED = {"__pycache__", "node_modules"}
MISSING = 3


class Wrong(Exception):
    """A file that can't be used, or what is asked of it."""


def sources():
    """A digest of what commands do here."""
    found = hashlib.sha256()
    paths = (path for folder in FOLDERS for path in (ROOT / folder).rglob("*")
             if path.suffix in ENDINGS and path.is_file() and not IGNORED & set(path.parts))
    for path in sorted(paths):
        found.update(path.relative_to(ROOT).as_posix().encode() + b"\0")
        found.update(hashlib.sha256(path.read_bytes()).digest())
    return found.hexdigest()[:16]


def is_head(line):
    return (isinstance(line, dict) and isinstance(line.get("surehit command"), list)
            and all(isinstance(word, str) for word in line["surehit command"])
            and type(line.get("pieces")) is int and line["pieces"] > 0)


def is_piece(line, pieces):
    return (isinstance(line, dict) and line.keys() == {"piece", "status", "said"}
            and type(line["piece"]) is int and 1 <= line["piece"] <= pieces
            and type(line["status"]) is int and line["status"] in (0, 1)
            and isinstance(line["said"], str))


def read(path):
    """Its lines, the last one but for its checksum."""
    try:
        text = pathlib.Path(path).read_text(encoding="utf-8")
        lines = [json.loads(line) for line in text.splitlines()]
        whole = text == sealed(lines[:-1]) and is_head(lines[0])
    except (OSError, ValueError, IndexError) as error:
        raise Wrong(f"{path}: {error}") from error
    if not whole:
        raise Wrong(f"{path}: is damaged, or of something else")
    if not all(is_piece(line, lines[0]["pieces"]) for line in lines[1:-1]):
        raise Wrong(f"{path}: has what is no piece")
    return lines[:-1]


def write(path, lines):
    """All of it or nothing; a device stays what it is."""
    path = os.path.realpath(path)
    if os.path.exists(path) and not os.path.isfile(path):
        raise Wrong(f"{path}: is no regular file, and is never replaced")
    folder = os.path.dirname(path)
    with tempfile.NamedTemporaryFile("w", dir=folder, delete=False, encoding="utf-8") as file:
        try:
            file.write(sealed(lines))
            file.flush()
            os.fsync(file.fileno())
            os.chmod(file.name, 0o644)
            os.replace(file.name, path)
        except BaseException:
            os.unlink(file.name)
            raise


def result_path(folder, number):
    return os.path.join(folder, f"{number}.json")


def plan(options):
    if options.pieces < 1:
        raise Wrong("--pieces: expected a number above 0")
    if options.words[:1] == ["--"]:
        del options.words[0]
    if not any("{piece}" in word for word in options.words):
        raise Wrong("no {piece} in the command: all pieces would be the same")
    write(options.output, [{"surehit command": options.words, "pieces": options.pieces,
                            "sources": sources()}])


def is_done(folder, number, head):
    """What is damaged is done again; what is another plan's, or piece's, is not lost."""
    path = result_path(folder, number)
    try:
        found, *pieces = read(path) if os.path.exists(path) else [None]
    except Wrong as wrong:
        print(f"commands.py: error: {wrong}", file=sys.stderr)
        return False
    if found and found != head:
        raise Wrong(f"{path}: is another plan's")
    if found and [piece["piece"] for piece in pieces] != [number]:
        raise Wrong(f"{path}: is no result of piece {number}")
    return bool(found)


def work(options):
    head = read(options.manifest)[0]
    number = options.number
    if not 1 <= number <= head["pieces"]:
        raise Wrong(f"{options.manifest}: piece {number}: has no such piece")
    if head["sources"] != sources():
        raise Wrong(f"{options.manifest}: is for another program than this one: "
                    "it has another sources")
    if is_done(options.folder, number, head):
        return 0
    words = [word.replace("{piece}", str(number)).replace("{pieces}", str(head["pieces"]))
             for word in head["surehit command"]]
    os.makedirs(options.folder, exist_ok=True)
    done = subprocess.run(words, stdout=subprocess.PIPE, cwd=ROOT, text=True, errors="replace")
    if done.returncode not in (0, 1):
        raise Wrong(f"piece {number}: {words[0]}: ended with status {done.returncode}")
    if done.returncode == 1 and not done.stdout:
        raise Wrong(f"piece {number}: {words[0]}: ended with status 1 and no complaint")
    write(result_path(options.folder, number),
          [head, {"piece": number, "status": done.returncode, "said": done.stdout}])
    return 0


def status(options):
    head = read(options.manifest)[0]
    missing, done = [], 0
    for number in range(1, head["pieces"] + 1):
        fits = is_done(options.folder, number, head)
        done += fits
        if not fits and missing and missing[-1][1] == number - 1:
            missing[-1][1] = number
        elif not fits:
            missing.append([number, number])
    print(",".join(f"{a}-{b}" if a < b else f"{a}" for a, b in missing))
    print(f"{done} of {head['pieces']} pieces are done, {100 * done / head['pieces']:.2f} % of all",
          file=sys.stderr)
    return MISSING if missing else 0


def parts_of(given):
    """The files of a folder, or the file."""
    if not os.path.isdir(given):
        return [given]
    names = sorted(name for name in os.listdir(given) if name.endswith(".json"))
    return [os.path.join(given, name) for name in names]


def merge(options):
    head, pieces = None, {}
    for path in (path for given in options.given for path in parts_of(given)):
        if os.path.exists(options.output) and os.path.samefile(path, options.output):
            raise Wrong(f"{options.output}: may not take the place of a file that is read")
        first, *rest = read(path)
        if head is None:
            head, where = first, path
        for key in sorted({*head, *first}):
            if head.get(key) != first.get(key):
                raise Wrong(f"{path}: has another {key} than {where}")
        for piece in rest:
            if piece["piece"] in pieces:
                raise Wrong(f"{path}: piece {piece['piece']} is in another file, too")
            pieces[piece["piece"]] = piece
    if not pieces:
        raise Wrong("no piece is there")
    write(options.output, [head, *(pieces[number] for number in sorted(pieces))])
    complaints = [number for number in sorted(pieces) if pieces[number]["status"] != 0]
    print(f"{len(pieces)} of {head['pieces']} pieces, {len(complaints)} with complaints"
          + (f": {', '.join(map(str, complaints))}" if complaints else ""))
    return 1 if complaints or len(pieces) < head["pieces"] else 0


def said(options):
    for piece in read(options.record)[1:]:
        sys.stdout.write(piece["said"])


def parse():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    ways = parser.add_subparsers(required=True, metavar="plan|work|status|merge|said")

    def way(call, *names):
        made = ways.add_parser(call.__name__)
        made.set_defaults(call=call)
        for name in names:
            made.add_argument(name)
        return made

    planned = way(plan)
    planned.add_argument("--pieces", type=int, required=True)
    planned.add_argument("-o", "--output", required=True)
    planned.add_argument("words", nargs=argparse.REMAINDER)
    worked = way(work, "manifest")
    worked.add_argument("number", type=int)
    worked.add_argument("folder")
    way(status, "manifest", "folder")
    merged = way(merge)
    merged.add_argument("given", nargs="+")
    merged.add_argument("-o", "--output", required=True)
    way(said, "record")
    return parser.parse_args()


def main():
    options = parse()
    try:
        return options.call(options) or 0
    except (Wrong, OSError) as wrong:
        print(f"commands.py: error: {wrong}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
