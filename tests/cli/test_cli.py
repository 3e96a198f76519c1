# SPDX-License-Identifier: MIT
"""The command line as its users meet it: test_cli.py SUREHIT

What all commands have in common is tested here; test_tracer_commands.py, test_forward_commands.py,
test_regress.py, test_judge.py and test_report.py have what each does."""

import math
import os
import re
import shlex
import signal
import socket
import subprocess
import sys
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
from commands import (FAULTY, OUTPUT_FAILED, PROGRAM, SCENE, TIERS,  # noqa: E402
                      WRONG_USAGE, InFolder, all_files, at_terminal, contents, limit_file_size,
                      limit_memory, limit_stack, loaded, put, respect_permissions, rows, rows_of)
from shapes import SHAPES  # noqa: E402

# What each help names, and its most lines where somebody counts them.
HELPS = {
    "": ("--help --version render merge check diff regress cases answer judge report shrink "
         "vectors bench plan work status", 32),
    "render": ("-o --size --tier --threads --quiet --handedness --fov --cylinder-position "
               "--cone-position --falloff --skip-unknown --dialect --camera --integrator --photons "
               "--seed --first --bounces --aperture --share --continue --depth auto backward "
               "forward mixed " + " ".join(TIERS), 64),
    "plan": ("render|judge -o --pieces", None),
    "work": ("MANIFEST NUMBER FOLDER --limit --keep", None),
    "status": ("MANIFEST FOLDER", None),
    "describe": ("man bash zsh fish", None),
    "merge": ("A.share -o --share --quiet", None),
    "check": ("--quick --threads --quiet", None),
    "diff": ("-o --json", None),
    "regress": ("--golden --accept --tier --size --threads --quiet", None),
    "cases": ("--shape --regime --count --seed --set --named 2026.1", None),
    "answer": ("--tier --candidate", None),
    "judge": ("--candidate --command --keep --answers --truth --require --junit --sarif", None),
    "report": ("--candidate=FILE", None),
    "shrink": ("--tier --against decision answer promise", None),
    "vectors": ("--cases --entry --regime --shape -o", None),
    "walk": ("--tier --candidate --nudge --shape --kind --steps --truth --require beside", 40),
    "bench": ("--shape --regime --rays --tier --cases --repeats --float --block --objects --json "
              "cylinder wall_parallel bits float32 exact", 34),
}
COMMANDS = [name for name in HELPS if name]

# A file of this name is written last, and more than the disk holds.
LARGE = """
1 render scene.rt --size 64x64 -o last.ppm
1 render scene.rt --size 64x64 --heat stage -o last.ppm
1 render scene.rt -o a.ppm --size 32x32 --certificate last.cert
1 render scene.rt -o a.ppm --size 32x32 --integrator forward --photons 30000 --share last.share
2 diff old.ppm old.ppm -o last.ppm
1 bench --cases 20 --repeats 3 --json last.json
"""

# t is 3/11, a little beyond t_max, which float32 does not see.
BEYOND = "plane 0.3 0.7 0.1 0.01 0.02 3.3 0 0.27272727272727 7.1 5.2 1 0 0 1\n"

# A measurement that takes no time.
QUICK = ("--cases", "20", "--repeats", "3")


class OfAll(InFolder):
    scene = SCENE

    def test_every_command_has_a_help(self):
        for command, (named, most) in HELPS.items():
            words = command.split()
            text = self.succeed(*words, "--help")
            lines = text.split("\n")
            self.assertTrue(text.startswith(" ".join(["Usage: surehit", *words]) + " "), text)
            self.assertLessEqual(max(map(len, lines)), 80)
            self.assertLess(len(lines), most or 100)
            for word in named.split() + (["Exit status"] if command else []):
                self.assertIn(word, text)
            self.refuse("a value was given to '--help'", *words, "--help=yes")
            self.assertEqual(self.succeed(*words, "-h"), text)
            self.assertEqual(self.succeed("help", *words), text)

    def test_no_word_at_all(self):
        result = self.ask(WRONG_USAGE)
        self.assertEqual((result.stdout, result.stderr), ("", self.succeed("--help")))

    def test_version(self):
        self.assertRegex(self.succeed("--version"), r"\Asurehit \d+\.\d+\.\d+\n\Z")

    def test_wrong_usage(self):
        self.refuse_all("cli/wrong_usage.txt")
        for command in COMMANDS:
            for word in ("--nope", "-x", "--hel", "--helpme", "---"):
                self.refuse(f"unknown option '{word}'", command, word)

    def test_values_that_are_wrong(self):
        for line in rows("cli/wrong_values.txt"):
            *words, option, value = shlex.split(line)
            for last in ([option, value], [f"{option}={value}"]):
                self.refuse(f"{option} '{value}': expected", *words, *last)

    def test_values_that_are_missing(self):
        """One has to follow, as a word of its own."""
        for words in {tuple(shlex.split(line)[:-1]) for line in rows("cli/wrong_values.txt")}:
            for last in ([], [""]):
                self.refuse(f"a value is missing after '{words[-1]}'", *words, *last)

    def put_inputs(self):
        """What the tables' commands read."""
        os.mkdir("folder")
        os.mkdir("folder.ppm")
        os.mkfifo("pipe.ppm")
        os.symlink("loop.ppm", "loop.ppm")
        put("file", "")
        put("a.cases", BEYOND)
        self.succeed("render", "scene.rt", "-o", "old.ppm", "--size", "64x64", "--certificate",
                     "old.cert", "--quiet")
        self.succeed("render", "scene.rt", "-o", "a.ppm", "--size", "8x8", "--integrator",
                     "forward", "--photons", "9", "--share", "old.share", "--quiet")

    def test_lost_output_is_reported(self):
        self.put_inputs()
        told = "surehit.*: error: standard output cannot be written"
        lines = ["--help", "--version", *(f"{command} --help" for command in COMMANDS),
                 "bench --cases 20 --repeats 3", "check old.cert scene.rt", "diff a.ppm a.ppm",
                 "diff a.ppm old.ppm", "shrink --tier float32 --against answer a.cases"]
        for line in lines + ["regress . --size 8x8"]:
            status = WRONG_USAGE if line.split()[0] in ("check", "diff", "regress") else 1
            with open("/dev/full", "w", encoding="ascii") as full:
                self.fail_with(status, told + ": No space left on device", *line.split(),
                               stdout=full)
            self.fail_with(status, told + ": Bad file descriptor", *line.split(),
                           preexec_fn=lambda: os.close(1))

    def test_places_are_checked_first(self):
        self.put_inputs()
        for line in rows("cli/no_place.txt"):
            line, _, why = line.partition(" | ")
            status, *words = line.split()
            self.fail_with(int(status), f"{re.escape(words[-1])}.*: error: .*{why}.*", *words)

    def test_endings_are_checked_first(self):
        self.put_inputs()
        for path in ("a", "ppm", "appm", "a.pp", ".", "a.jpg", "a.ppm.txt", "a.ppm.gz", "missing/a",
                     "a.ppm/", "/dev/null"):
            for words in (["render", "scene.rt"], ["render", "missing.rt"],
                          ["render", "scene.rt", "-o", "b.ppm"], ["merge", "old.share"]):
                self.fail_with(WRONG_USAGE, re.escape(path) + r": error: .*\.ppm.*", *words, "-o",
                               path)

    def test_write_protection_is_respected(self):
        os.mkdir("closed", 0o555)
        put("closed.ppm", "old")
        os.chmod("closed.ppm", 0o444)
        for path in ("closed/a.ppm", "closed.ppm"):
            self.fail_with(OUTPUT_FAILED, path + ": error: .*", "render", "scene.rt", "-o", path,
                           preexec_fn=respect_permissions)

    def test_a_full_disk_leaves_what_was_there(self):
        self.put_inputs()
        for line in LARGE.strip().splitlines():
            status, *words = line.split()
            more = {"stdout": subprocess.DEVNULL} if words[0] in ("bench", "diff") else {}
            self.ask(0, *words)  # what is written beside it is small
            os.remove(words[-1])
            for _ in range(2):
                self.fail_with(int(status), words[-1] + ": error: .*(too large|written)", *words,
                               preexec_fn=limit_file_size, **more)
                put(words[-1], "old")

    def test_a_faulty_scene_touches_nothing(self):
        self.put_inputs()
        put("faulty.rt", SCENE + FAULTY)
        before = all_files()
        for more in ("-o old.ppm", "-o new.ppm", "-o a.ppm --certificate old.cert",
                     "-o a.ppm --integrator forward --share old.share"):
            for scene in ("faulty.rt", "missing.rt", "."):
                result = self.ask(WRONG_USAGE, "render", scene, *more.split())
                self.assertEqual(result.stdout, "")
                self.assertTrue(result.stderr.startswith(scene + ":"), result.stderr)
                self.assertEqual(all_files(), before)

    def test_names_are_shown_and_not_obeyed(self):
        small = ("--size", "8x8")
        drawn = self.succeed("render", "scene.rt", "-o", "\x1b.ppm", "--certificate", "\x1b.cert",
                             *small)
        self.assertTrue(drawn.startswith("\\x1b.ppm, \\x1b.cert: 8x8"), drawn)
        checked = self.succeed("check", "\x1b.cert", "scene.rt")
        self.assertTrue(checked.startswith("\\x1b.cert: 64 pixels"), checked)
        put("\x1b.cert", "none\n")
        self.fail_with(WRONG_USAGE, r"\\x1b\.cert:1: error: .*", "check", "\x1b.cert", "scene.rt")
        same = self.succeed("diff", "\x1b.ppm", "\x1b.ppm")
        self.assertEqual(same, "\\x1b.ppm and \\x1b.ppm are the same\n")
        self.succeed("render", "scene.rt", "-o", "b.ppm", "--size", "4x4")
        unlike = self.ask(1, "diff", "b.ppm", "\x1b.ppm", "-o", "\x1b.png").stderr
        self.assertTrue(unlike.startswith("\\x1b.png: not written"), unlike)
        summed = self.succeed("render", "scene.rt", "-o", "c.ppm", *small, "--integrator",
                              "forward", "--photons", "100", "--share", "\x1b.share")
        self.assertIn("\\x1b.share: 8x8", summed)
        merged = self.succeed("merge", "\x1b.share", "-o", "\x1b.ppm")
        self.assertTrue(merged.startswith("\\x1b.ppm: 8x8"), merged)
        both = self.succeed("render", "scene.rt", "-o", "\u00e9\u009b\u00a0.ppm", *small)
        self.assertTrue(both.startswith("\u00e9\\xc2\\x9b\u00a0.ppm: 8x8"), both)
        os.mkdir("scenes")
        put("scenes/a.rt", SCENE)
        seen = self.ask(1, "regress", "scenes", *small, "-o", "\x1b.html").stdout
        self.assertIn("; see \\x1b.html\n", seen)

    def test_pipes_have_certificates_and_shares(self):
        """Those of a file with these bytes, in which the scene has another name."""
        os.mkfifo("pipe.rt")
        for more in (("--certificate",), ("--integrator", "forward", "--photons", "9", "--share")):
            words = ("-o", "a.ppm", "--size", "8x8", "--quiet", *more)
            self.succeed("render", "scene.rt", *words, "of_file")
            with subprocess.Popen(["cp", "scene.rt", "pipe.rt"]):
                self.succeed("render", "pipe.rt", *words, "of_pipe")
            self.assertEqual(contents("of_pipe").replace(b"pipe.rt", b"scene.rt"),
                             contents("of_file"))

    def test_a_socket_is_standard_input(self):
        """Some start programs with sockets where others have pipes; Node does."""
        words = ("--size", "8x8", "--quiet")
        self.succeed("render", "scene.rt", "-o", "of_file.ppm", *words)
        ours, theirs = socket.socketpair()
        with theirs:
            with ours:
                ours.sendall(SCENE.encode())
            self.succeed("render", "-", "-o", "of_socket.ppm", *words, stdin=theirs)
        self.assertEqual(contents("of_socket.ppm"), contents("of_file.ppm"))


# An output in the place of an input, which is `link`, another name of the file.
TAKEN = """
scene.rt | render scene.rt -o link.ppm
scene.rt | render scene.rt -o a.ppm --certificate link
old.share | render scene.rt -o link.ppm --integrator forward --continue old.share
old.share | merge old.share -o link.ppm
old.ppm | diff old.ppm old.ppm -o link.ppm
old.ppm | diff old.ppm old.ppm --json link
a.cases | judge --tier exact --cases a.cases --json link
a.cases | vectors --shape plane --cases a.cases -o place
scene.rt | walk --candidate ./scene.rt --json link
"""


class Streams(InFolder):
    """Outputs and inputs that are not files of their own."""

    scene = SCENE

    def test_no_output_takes_the_place_of_an_input(self):
        put("a.cases", BEYOND)
        os.mkdir("place")
        self.succeed("render", "scene.rt", "-o", "old.ppm", "--size", "8x8", "--quiet",
                     "--integrator", "forward", "--photons", "9", "--share", "old.share")
        for row in TAKEN.strip().splitlines():
            taken, line = row.split(" | ")
            for make in (os.symlink, os.link):
                for name in ("link", "link.ppm", "place/plane.jsonl"):
                    make(os.path.abspath(taken), name)
                self.fail_with(WRONG_USAGE, ".* may not take the place of a file that is read.*",
                               *line.split())
                for name in ("link", "link.ppm", "place/plane.jsonl"):
                    os.remove(name)

    def test_a_pipe_of_cases_is_read_once(self):
        os.mkfifo("cases")
        self.fail_with(WRONG_USAGE, ".*'cases': a pipe is read once, for one '--shape'.*",
                       "vectors", "--cases", "cases", "-o", ".")

    def test_a_share_that_is_gone_on_with_is_replaced(self):
        words = ("render", "scene.rt", "-o", "a.ppm", "--size", "8x8", "--quiet", "--integrator",
                 "forward", "--photons", "9", "--share", "a.share")
        self.succeed(*words)
        self.succeed(*words, "--continue", "a.share", "--photons", "18")

    def test_pictures_go_to_standard_output_and_pipes(self):
        self.succeed("render", "scene.rt", "-o", "a.ppm", "--size", "8x8")
        for name in ("-", "/dev/stdout"):
            with open("got", "wb") as got:
                said = self.ask(0, "render", "scene.rt", "-o", name, "--size", "8x8", stdout=got)
            self.assertEqual(contents("got"), contents("a.ppm"))
            self.assertRegex(said.stderr, r"8x8, \d+\.\d\d s\n\Z")
        os.mkfifo("pipe")
        with open("got", "wb") as got, subprocess.Popen(["cat", "pipe"], stdout=got) as reader:
            self.ask(0, "render", "scene.rt", "-o", "pipe", "--size", "8x8")
            reader.wait()
        self.assertEqual(contents("got"), contents("a.ppm"))
        self.refuse("one picture goes to standard output, not 2", "render", "scene.rt", "-o", "-",
                    "-o", "-")

    def test_a_scene_from_standard_input(self):
        self.succeed("render", "scene.rt", "-o", "a.ppm", "--size", "8x8")
        self.succeed("render", "-", "-o", "b.ppm", "--size", "8x8", input=SCENE)
        self.assertEqual(contents("b.ppm"), contents("a.ppm"))

    def test_what_is_too_large_is_not_read(self):
        with open("large.rt", "wb") as large:
            large.truncate((256 << 20) + 1)
        self.fail_with(WRONG_USAGE,
                       r"large\.rt:1:1: error: more than 256 MiB; expected a smaller.*",
                       "render", "large.rt", "-o", "a.ppm",
                       preexec_fn=lambda: limit_memory(256 << 20))

    def test_fewer_threads_where_there_is_no_memory_for_more(self):
        self.succeed("render", "scene.rt", "-o", "a.ppm", "--size", "64x64")
        self.ask(0, "render", "scene.rt", "-o", "b.ppm", "--size", "64x64", "--threads", "64",
                 preexec_fn=lambda: limit_memory(256 << 20))
        self.assertEqual(contents("b.ppm"), contents("a.ppm"))

    def test_a_small_stack_is_enough_or_refused(self):
        for words in (("judge", "--tier", "exact", "--shape", "cone", "--regime", "bits", "--count",
                       "100", "--untimed"),
                      ("render", "scene.rt", "-o", "a.ppm", "--size", "64x64", "--tier", "exact",
                       "--threads", "4")):
            self.ask(0, *words, preexec_fn=lambda: limit_stack(1024))
            self.fail_with(WRONG_USAGE, f"surehit {words[0]}: error: the stack may take 256 KB .*",
                           *words, preexec_fn=lambda: limit_stack(256))

    def test_a_pipe_that_nobody_reads_is_no_error(self):
        for line in ("cases --count 20000", "judge --tier exact --shape sphere --regime grazing",
                     "judge --command false --shape sphere --regime grazing", "bench --help"):
            ends = os.pipe()
            os.close(ends[0])
            said = self.ask(-signal.SIGPIPE, *line.split(), stdout=ends[1])
            os.close(ends[1])
            self.assertEqual(said.stderr, "", line)


# Lines of a scene whose camera is at 0,0,0 and looks along -z, and why its picture is black.
BLACK = (
    ("A 1 9,9,9", "no ray met anything: there is no object"),
    ("A 1 9,9,9\nsp 0,0,9 2 9,9,9\nsp 9,0,9 2 9,9,9\nsp 90,0,-1 2 9,9,9",
     "no ray met anything: of 3 objects 2 are behind the camera, 1 is beside the view; "
     "--handedness mirrors a view .*"),
    ("A 1 9,9,9\nsp 90,0,-1 2 9,9,9\npl 0,0,0 0,1,0 9,9,9",
     "no ray met anything: of 2 objects 1 is beside the view, 1 is edge-on, in a plane with the "
     "camera"),
    ("A 1 9,9,9\npl 0,0,9 0,0,1 9,9,9",
     "no ray met anything: of 1 object 1 is behind the camera; --handedness mirrors a view .*"),
    *((f"A 1 9,9,9\nsp {place} 0.1 9,9,9", "no ray met anything: of 1 object 1 is beside the view")
      for place in ("-1,0,-1", "0,0.6,-1", "0,-0.6,-1", "0.9,0.6,-1")),
    ("A 1 9,9,9\ncy 0,0,2 1,0,1 0.1 30 9,9,9",  # its box is about the eye
     "no ray met anything: of 1 object 1 is beside the view"),
    ("A 1 9,9,9\nsp 0.003,0.003,-99 0.0000001 9,9,9",
     "no ray met anything: of 1 object 1 is in front, but too small or thin for any ray"),
    ("A 1 9,9,9\nsp 0,0,-9 2 0,0,0",
     "rays met objects, and all that they saw is black: so is every object's colour"),
    ("A 0 9,9,9\nsp 0,0,-9 2 9,9,9",
     "rays met objects, and all that they saw is black: there is no light"),
    *((f"A 0 9,9,9\nL 0,9,0 {light}\nsp 0,0,-9 2 9,9,9",
       "rays met objects, and all that they saw is black: there is no light")
      for light in ("0 9,9,9", "1 0,0,0")),
    ("A 1 9,9,9\nsp 0,0,-9 2 9,9,9 refl:1",
     "rays met objects, .* is black: nothing but empty space is seen in mirrors and through glass"),
    ("A 0 9,9,9\nsp 0,0,-9 2 9,9,9 refr:1.5\nsp 0,0,-9 1 0,0,0",
     "rays met objects, .*: nothing but empty space and what is black is seen in mirrors .*"),
    ("A 0 9,9,9\nL 0,0,-99 1\nsp 0,0,-9 2 9,9,9",
     "rays met objects, .*: light is too faint there, or reaches none of it; of 1 object 0 are "
     "black"),
    ("A 0 9,9,9\nL 0,0,-99 1\nsp 0,0,-9 2 9,9,9 refr:1.5 spec:0.5",  # it may show the lamp
     "rays met objects, .*: light is too faint there, or reaches none of it; of 1 object 0 are "
     "black"),
    ("A 0 9,9,9\nL 0,0,-99 1\nsp 0,0,-9 2 9,9,9\nsp 5,0,-9 1 9,9,9 refl:1",
     "rays met objects, .* reaches none of it, or it is a mirror or glass, and shows nothing; of 2 "
     "objects 0 are black"),
)


class Render(InFolder):
    scene = SCENE

    def test_a_black_picture_says_why(self):
        for lines, why in BLACK:
            put("black.rt", lines + "\nC 0,0,0 0,0,-1 70\n")
            for more in ([], ["--explain"], ["--quiet"]):
                said = self.ask(0, "render", "black.rt", "-o", "a.ppm", "--size", "16x10", *more)
                last = said.stderr.splitlines()[-1]
                self.assertRegex(last, r"\Ablack\.rt: warning: " + why + r"\Z")
        put("mirror.rt", "A 0 9,9,9\nC 0,0,0 0,0,-1 70\nL 0,0,-99 1\nsp 0,0,-9 2 9,9,9 refl:1\n")
        for depth, why in ((0, "light is too faint there, .*"), (1, "nothing but empty space .*")):
            said = self.ask(0, "render", "mirror.rt", "-o", "a.ppm", "--depth", str(depth))
            self.assertRegex(said.stderr, r"\Amirror\.rt: warning: rays met .*: " + why + r"\n\Z")
        self.assertEqual(self.succeed("render", "scene.rt", "-o", "a.ppm", "--quiet"), "")
        put("glass.rt", "A 1 9,9,9\nC 0,0,0 0,0,-1 70\nL 0,0,0 1\nsp 0,0,-9 2 9,9,9 refr:1.5\n")
        said = self.ask(0, "render", "glass.rt", "-o", "a.ppm", "--size", "16x10", "--integrator",
                        "forward", "--photons", "5000")
        self.assertIn("glass.rt: warning: no point that photons lit is seen", said.stderr)

    def test_what_may_well_be_black(self):
        """A part of a picture, or of its photons; an opening that none of them entered."""
        glass = "A 1 9,9,9\nC 0,0,0 0,0,-1 70\nL 0,0,0 1\nsp 0,0,-9 2 9,9,9 refr:1.5\n"
        put("glass.rt", glass)
        put("behind.rt", glass.replace("-9", "9"))
        for line in ("behind.rt --tile 3,4,5x5",
                     "glass.rt --integrator forward --photons 5000 --share a.share",
                     "glass.rt --integrator forward --photons 5000 --aperture 1e-9"):
            self.succeed("render", "-o", "a.ppm", "--size", "16x10", "--quiet", *line.split())
            self.assertEqual(set(sum(rows_of("a.ppm"), [])), {(0, 0, 0)})

    def test_what_photons_change(self):
        for word, why in (("--photons", "no mirror, no glass"), ("--seed", "no mirror, no glass")):
            put("matte.rt", "A 1 9,9,9\nC 0,0,0 0,0,-1 70\nL 0,0,0 1\nsp 0,0,-9 2 9,9,9\n")
            said = self.ask(0, "render", "matte.rt", "-o", "a.ppm", "--size", "16x10", word, "3")
            self.assertEqual(said.stderr, f"matte.rt: warning: {word} changes nothing: {why}\n")
        put("away.rt", "A 1 99,99,99\nC 0,2,8 0,0,-1 70\nL 0,9,0 1\npl 0,0,0 0,1,0 99,99,99\n"
            "di 0,3,0 0,1,0 2 99,99,99 refl:1\n")
        self.succeed("render", "away.rt", "-o", "a.ppm", "--size", "16x10", "--falloff",
                     "inverse-square", "--photons", "30")  # which were sent

    def header(self, path):
        return contents(path)[:30].split(b"\n")[:3]

    def render(self, output, line, scene="scene.rt"):
        """What it says."""
        return self.succeed("render", scene, "-o", output, *shlex.split(line))

    def test_says_what_it_wrote(self):
        self.assertRegex(self.render("a.ppm", "--size 16x9"), r"\Aa\.ppm: 16x9, \d+\.\d\d s\n\Z")
        self.assertEqual(self.header("a.ppm"), [b"P6", b"16 9", b"255"])
        self.assertEqual(len(contents("a.ppm")), len(b"P6\n16 9\n255\n") + 3 * 16 * 9)
        self.assertEqual(self.render("a.ppm", "--quiet --size=4x4"), "")
        self.assertEqual(self.header("a.ppm"), [b"P6", b"4 4", b"255"])

    def test_options_before_between_and_after(self):
        found = set()
        for line in ("--size=8x8 -o a.ppm scene.rt --tier=textbook",
                     "-o a.ppm --tier textbook --size 8x8 -- scene.rt",
                     "scene.rt --size 9x9 -o a.ppm --size 8x8"):
            self.succeed("render", *line.split())
            found.add(contents("a.ppm"))
        self.assertEqual(len(found), 1)

    def test_every_option_reaches_the_picture(self):
        self.render("plain.ppm", "--size 64x48")
        for line in ("--handedness left", "--fov=vertical", "--cylinder-position base",
                     "--cone-position base", "--cone-position=apex", "--falloff inverse-square"):
            self.render("other.ppm", "--size 64x48 " + line)
            self.assertNotEqual(contents("other.ppm"), contents("plain.ppm"), line)
        put("tall.rt", SCENE + "sq 0,0,0 0,1,0 1 255,0,0\n")
        words = ("render", "tall.rt", "-o", "tall.ppm", "--size", "64x48")
        self.ask(WRONG_USAGE, *words)
        self.assertIn("sq", self.ask(0, *words, "--skip-unknown").stderr)
        self.assertEqual(contents("tall.ppm"), contents("plain.ppm"))

    def test_the_default_tier_is_certain(self):
        for tier in ("default", "certain", "float32"):
            self.render(f"{tier}.ppm", "--size 320x200" +
                        (f" --tier {tier}" if tier != "default" else ""))
        self.assertEqual(contents("default.ppm"), contents("certain.ppm"))
        self.assertNotEqual(contents("default.ppm"), contents("float32.ppm"))

    def test_two_pictures_of_one_rendering(self):
        self.render("alone.ppm", "--size 32x20")
        words = ("render", "scene.rt", "-o", "a.ppm", "-o", "a.png", "--size", "32x20")
        self.assertRegex(self.succeed(*words), r"\Aa\.ppm, a\.png: 32x20, ")
        self.assertEqual(contents("a.ppm"), contents("alone.ppm"))
        self.assertEqual(contents("a.png")[:24],
                         b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x20\0\0\0\x14")

    def test_unusual_names(self):
        os.mkdir("a folder")
        os.rename("scene.rt", "a folder/my scene.rt")
        for output in ("a folder/my picture.ppm", "-o.ppm", "--.PPM", ".ppm", "a;b'c\".ppm"):
            self.assertIn(output, self.render(output, "--size 4x4", "a folder/my scene.rt"))
            self.assertEqual(self.header(output), [b"P6", b"4 4", b"255"])
        os.rename("a folder/my scene.rt", "--size")
        self.ask(0, "render", "-o", "b.ppm", "--size", "4x4", "--", "--size")
        self.assertEqual(self.header("b.ppm"), [b"P6", b"4 4", b"255"])

    def test_an_existing_file_is_replaced(self):
        """And not written over: another link to it keeps the old bytes."""
        put("a.ppm", "old")
        os.link("a.ppm", "kept")
        self.render("a.ppm", "--size 4x4")
        self.assertEqual(self.header("a.ppm"), [b"P6", b"4 4", b"255"])
        self.assertEqual((contents("kept"), len(os.listdir("."))), (b"old", 3))

    def test_permissions_are_the_usual_ones(self):
        put("old.ppm", "old")
        os.chmod("old.ppm", 0o606)
        for path, mask, mode in (("new.ppm", 0o27, 0o640), ("old.ppm", 0o27, 0o606),
                                 ("open.ppm", 0, 0o666)):
            self.ask(0, "render", "scene.rt", "-o", path, "--size", "4x4", umask=mask)
            self.assertEqual(os.stat(path).st_mode & 0o7777, mode, path)

    def test_a_link_is_followed(self):
        os.mkdir("inner")
        put("inner/a.ppm", "old")
        os.symlink("inner/a.ppm", "link.ppm")
        self.render("link.ppm", "--size 4x4")
        self.assertEqual(os.readlink("link.ppm"), "inner/a.ppm")
        self.assertEqual(self.header("inner/a.ppm"), [b"P6", b"4 4", b"255"])
        os.remove("inner/a.ppm")
        self.fail_with(OUTPUT_FAILED, "link.ppm: error: .*link.*", "render", "scene.rt", "-o",
                       "link.ppm")

    def test_the_longest_name_fits(self):
        self.render(251 * "a" + ".ppm", "--size 4x4")
        self.fail_with(OUTPUT_FAILED, "a+.ppm: error: .*too long", "render", "scene.rt", "-o",
                       252 * "a" + ".ppm")

    def test_closed_streams_do_not_reach_the_picture(self):
        words = ("render", "scene.rt", "-o", "a.ppm", "--size", "4x4")
        self.succeed(*words)
        whole = contents("a.ppm")
        self.fail_with(OUTPUT_FAILED, "surehit render: error: .*Bad file descriptor", *words,
                       preexec_fn=lambda: os.close(1))
        for closed in ([0], [2], [0, 2], [0, 1, 2]):
            os.remove("a.ppm")
            self.run_program(*words, preexec_fn=lambda streams=closed: [*map(os.close, streams)])
            self.assertEqual(contents("a.ppm"), whole, closed)

    def test_an_interrupt_leaves_what_was_there(self):
        put("old.ppm", "old")
        before = all_files()
        with subprocess.Popen([PROGRAM, "render", "scene.rt", "-o", "old.ppm", "--size",
                               "20000x20000"], stderr=subprocess.DEVNULL) as running:
            time.sleep(0.3)
            running.terminate()
            self.assertEqual(running.wait(), -signal.SIGTERM)
        self.assertEqual(all_files(), before)


RAYS = ("mixed", "hits", "misses")


class Bench(InFolder):
    def rows(self, *words):
        """(shape, regime, rays, tier) of each row, after a head that ends with an empty line."""
        head, table = self.succeed("bench", *QUICK, *words).split("\n\n")
        self.assertIn("20 cases", head)
        rows = []
        for line in table.splitlines()[1:]:
            number = r"[\d.]+"
            row = re.fullmatch(rf"(\w+) +(\w+) +(\w+) +(\w+(?: block)?) +{number} +"
                               rf"(?:\d+|-)(?: +{number}){{3}} +{number}\.\.{number} +\d+ %", line)
            self.assertIsNotNone(row, line)
            rows.append(row.groups())
        return rows

    def test_everything(self):
        self.assertEqual(self.rows(), [
            (shape, regime, rays, tier) for shape in SHAPES for regime in ("camera", "typical")
            for rays in RAYS for tier in ("naive", *TIERS)])

    def test_a_choice(self):
        exact = self.rows("--shape=cone", "--regime", "apex", "--tier", "exact", "--rays=hits")
        self.assertEqual(exact, [("cone", "apex", "hits", name) for name in ("naive", "exact")])
        several = self.rows("--shape=disc", "--regime=rim", "--tier=stable", "--tier=float32",
                            "--rays", "mixed")
        self.assertEqual([row[3] for row in several], ["naive", "float32", "stable"])
        several = self.rows("--shape=disc", "--regime=rim", "--tier=exact", "--rays=repeated")
        self.assertEqual([row[2] for row in several], ["repeated", "repeated"])
        words = "--shape=cone", "--regime=rim", "--rays=mixed", "--float"
        self.assertEqual([row[3] for row in self.rows(*words)],
                         ["naive", "textbook", "certain", "exact"])
        self.assertEqual([row[3] for row in self.rows(*words, "--block=8")], ["naive", "certain"])
        words = "--shape=cone", "--regime=rim", "--rays=mixed", "--block=8", "--tier=certain"
        found = [row[3] for row in self.rows(*words)]
        self.assertIn(found, (["naive", "certain"], ["naive", "certain", "naive block"]))
        self.assertEqual([row[3] for row in self.rows(*words, "--objects")], ["naive", "certain"])
        solid = {row[0] for row in self.rows("--regime", "inside", "--rays=mixed")}
        self.assertEqual(solid & {"plane", "disc", "sphere", "cone"}, {"sphere", "cone"})

    def test_json(self):
        self.rows("--shape", "disc", "--json", "a.json")
        found = loaded("a.json")
        hits = {"hits": {20}, "misses": {0}, "mixed": range(21)}
        for key in ("cpu", "compiler", "flags"):
            self.assertTrue(found[key])
        self.assertIn("-ffp-contract=off", found["flags"])
        self.assertEqual(found["threads"], 1)
        self.assertEqual([(row["regime"], row["rays"], row["tier"]) for row in found["results"]],
                         [(regime, rays, tier) for regime in ("camera", "typical") for rays in RAYS
                          for tier in ("naive", *TIERS)])
        for row in found["results"]:
            self.assertEqual((row["shape"], row["cases"], row["repeats"]), ("disc", 20, 3))
            if row["tier"] in ("certain", "exact"):
                self.assertIn(row["hits"], hits[row["rays"]])
            self.assertIsNone(row["instructions"]) # which nobody asked for
            self.assertTrue(0 < row["quiet"] <= 1, row["quiet"])
            for figure in ("nanoseconds", "over_naive", "over_textbook", "over_faster"):
                lower, median, upper = (row[figure][key] for key in
                                        ("lower_quartile", "median", "upper_quartile"))
                self.assertTrue(0 < lower <= median <= upper, row)


class Shrink(InFolder):
    """Cases that are answered wrongly, made simple."""

    PLAIN = "sphere 0 0 0 0 0 -1 0 inf 0 0 -5 1\n"
    INVALID = "plane 0 0 0 0 0 0 0 inf 0 0 0 0 0 1\n"

    def shrink(self, text, line, *complaints, status=0):
        """Its standard output; the complaints are those on standard error."""
        result = self.ask(status, "shrink", *line.split(), input=text)
        self.assertEqual(result.stderr, "".join(f"surehit shrink: {complaint}\n"
                                                for complaint in complaints), (text, line))
        return result.stdout

    def test_what_fails_is_printed_simpler_and_fails_still(self):
        for against in ("decision", "answer"):
            line = "--tier float32 --against " + against
            simple = self.shrink(self.PLAIN + BEYOND, line, "line 1: does not fail")
            self.assertRegex(simple, r"\Aplane( -?0x[01](\.[0-9a-f]+)?p[+-]\d+){14}\n\Z")
            self.assertGreater(simple.count(" 0x0p+0"), 5)
            self.assertEqual(self.shrink(simple, line), simple)

    def test_what_does_not_fail_is_told(self):
        for line in ("--tier textbook", "--tier=certain --against promise",
                     "--tier stable --against=answer"):
            self.assertEqual(self.shrink(self.PLAIN + self.INVALID, line, "line 1: does not fail",
                                         "line 2: does not fail"), "")

    def test_lines_that_are_no_cases(self):
        for line in ("nonsense\n", "\n", self.PLAIN.replace(" 1\n", "\n"),
                     self.PLAIN[:-1] + "\0\n", self.PLAIN[:-1] + "0" * 5000 + "x\n"):
            said = self.shrink(self.PLAIN + line + self.PLAIN, "--tier textbook",
                               "line 1: does not fail", "error: line 2: no case",
                               "line 3: does not fail", status=WRONG_USAGE)
            self.assertEqual(said, "")

    def test_a_file_and_standard_input(self):
        put("a.cases", BEYOND)
        line = "--tier float32 --against answer"
        by_input = self.shrink(BEYOND, line)
        self.assertEqual(by_input.count("\n"), 1)
        self.assertEqual(self.shrink("", line + " a.cases"), by_input)
        self.assertEqual(self.shrink(BEYOND, line + " -"), by_input)
        self.fail_with(WRONG_USAGE, r"surehit shrink: error: missing: No such file.*", "shrink",
                       "--tier", "float32", "missing")
        self.fail_with(WRONG_USAGE, ".*after line 1: no end of a line.*", "shrink", "--tier",
                       "float32", "/dev/zero")


# What takes more than a second, if it is given as many as `N`.
SLOW = """
judge --tier textbook --shape sphere --regime typical --regime grazing --count N
walk --tier certain --shape sphere --kind alone --steps N --threads 1
vectors --shape plane --regime typical --count N
cases --shape sphere --regime typical --count N
judge --tier textbook --cases many.cases
"""


class Progress(InFolder):
    """The bar on a terminal, and its absence anywhere else."""

    scene = SCENE + "sp 0,9,0 1 9,9,9\n" * 200

    def render(self, size, *words):
        """What the terminal got, and when: from the start to the first byte and to the end."""
        *seen, status = at_terminal("render", "scene.rt", "-o", "a.ppm", "--threads", "1",
                                    "--size", size, *words)
        self.assertEqual(status, 0)
        return seen

    def slow_render(self):
        """As above, of a picture that takes two seconds at least; and its size."""
        side, elapsed = 128, 0
        while elapsed < 2:
            size = f"{side}x{side}"
            shown, first, elapsed = self.render(size)
            side = math.ceil(side * max(1.2, (2.4 / elapsed) ** 0.5))
        return shown, first, elapsed, size

    def until_slow(self, line):
        """What a terminal got of the command, with so many that it was slow; or of one that took a
        minute and showed nothing."""
        count, elapsed, shown = 20000, 0, ""
        while not shown and elapsed < 60:
            if "many.cases" in line:
                with open("many.cases", "w", encoding="ascii") as file:
                    self.ask(0, "cases", "--shape", "sphere", "--regime", "grazing", "--count",
                             str(count), stdout=file)
            words = line.replace(" N", f" {count}").split()
            shown, _, elapsed, status = at_terminal(*words)
            self.assertEqual(status, 0)
            count = math.ceil(count * max(1.5, min(10, 1.6 / elapsed)))
        return shown

    def test_whatever_is_slow_shows_it_and_erases_it(self):
        for line in SLOW.strip().splitlines():
            shown = self.until_slow(line)
            self.assertRegex(shown, r"\A(\r\[#* *\] +\d+ %, +\d+:\d\d left|\r +\r)+\Z")
            self.assertRegex(shown, r"\r +\r\Z", line)

    def test_a_line_every_ten_seconds_where_there_is_no_terminal(self):
        with subprocess.Popen([PROGRAM, "render", "scene.rt", "-o", "a.ppm", "--size",
                               "2000x2000", "--samples", "4096", "--threads", "1"],
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              text=True) as running:
            started = time.monotonic()
            time.sleep(0.5)
            running.send_signal(signal.SIGSTOP)  # the clock goes on, and nobody works meanwhile
            time.sleep(9)
            running.send_signal(signal.SIGCONT)
            first = running.stderr.readline()
            running.kill()
        self.assertRegex(first, r"\A\d+ %, \d+:\d\d left\n\Z")
        self.assertGreaterEqual(time.monotonic() - started, 9.5)

    def test_short_work_shows_no_bar(self):
        shown, _, elapsed = self.render("4x4")
        self.assertTrue(shown == "" or elapsed > 1, repr(shown))

    def test_long_work_shows_it_and_erases_it(self):
        shown, first, elapsed, size = self.slow_render()
        bars = re.fullmatch(r"((?:\r\[#* *\] +\d+ %, +\d+:\d\d left)+)\r +\r", shown)
        self.assertIsNotNone(bars, repr(shown))
        bars = bars[1].split("\r")[1:]
        self.assertGreaterEqual(first, 1)
        self.assertLessEqual(len(bars), 10 * (elapsed - 1) + 1)
        self.assertEqual(len({len(bar) for bar in bars}), 1)
        self.assertLess(len(bars[0]), 80)
        shares = [int(re.search(r"(\d+) %", bar)[1]) for bar in bars]
        self.assertEqual(shares, sorted(shares))
        self.assertLessEqual(shares[-1], 100)
        self.assertGreater(len(re.search(r" +\r\Z", shown)[0]), len(bars[0]))
        self.assertEqual(self.render(size, "--quiet")[0], "")
        self.succeed("render", "scene.rt", "-o", "a.ppm", "--threads", "1", "--size", size)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
