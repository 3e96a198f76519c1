# SPDX-License-Identifier: MIT
"""The program surehit as its users meet it: what the tests of its commands share.

Their first argument is the program."""

import ctypes
import fcntl
import json
import os
import pty
import re
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.path.abspath(sys.argv[1])
TIERS = ["float32", "textbook", "stable", "certain", "exact"]
OUTPUT_FAILED, WRONG_USAGE, INTERRUPTED = 1, 2, 130
PR_CAPBSET_DROP, CAP_DAC_OVERRIDE = 24, 1

# A floor, and from left to right a ball, a cylinder that shows its cap, and a cone, under one lamp;
# the sky is empty.
SCENE = """\
A 0.2 255,255,255
C 0,2,8 0,-0.15,-1 60
L -5,8,5 0.7 255,255,255
pl 0,-1,0 0,1,0 200,200,200
sp -2.5,0,0 2 255,60,60
cy 0,0,0 0,1,0 1.4 2 60,255,60
co 2.5,0,0 0,1,0 1.8 2 60,60,255
"""
FAULTY = "pll 0,-1,0 0,1,0 200,200,200\n"  # a line of a scene


def contents(path):
    with open(path, "rb") as file:
        return file.read()


def put(path, data):
    with open(path, "wb") as file:
        file.write(data if isinstance(data, bytes) else data.encode())


def loaded(path):
    """Of JSON."""
    return json.loads(contents(path))


def rows(name):
    """The lines of a file in the tests' folder, without its comments."""
    lines = contents(os.path.join(ROOT, "tests", name)).decode().splitlines()
    found = [line for line in lines if not line.startswith("#")]
    assert found, name
    return found


def all_files(folder="."):
    """{path: contents} of every file below, and None for what is no file."""
    found = {}
    for where, folders, names in os.walk(folder):
        for path in (os.path.join(where, name) for name in folders + names):
            found[path] = contents(path) if os.path.isfile(path) else None
    return found


def rows_of(path):
    """A PPM as rows of (r, g, b)."""
    data = contents(path)
    head = re.match(rb"P6\n(\d+) (\d+)\n255\n", data)
    width, height = int(head[1]), int(head[2])
    data = data[head.end():]
    assert len(data) == 3 * width * height
    return [[tuple(data[3 * (y * width + x):][:3]) for x in range(width)] for y in range(height)]


def limit_file_size():
    """Less than a test's output, and more than an OpenMP library keeps for itself in a file."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192))


def limit_stack(kilobytes):
    resource.setrlimit(resource.RLIMIT_STACK, (kilobytes << 10, kilobytes << 10))


def limit_memory(size):
    resource.setrlimit(resource.RLIMIT_AS, (size, size))


def respect_permissions():
    """Takes from root what lets it write anywhere (CAP_DAC_OVERRIDE)."""
    if os.geteuid() == 0 and ctypes.CDLL(None).prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0):
        raise OSError("root cannot be kept from writing")


def at_terminal(*words, meanwhile=lambda running: None, **more):
    """What a terminal gets on standard error; seconds to its first byte and to the end; and the
    status."""
    master, slave = pty.openpty()
    started, shown, first, part = time.monotonic(), b"", None, b" "
    running = subprocess.Popen([PROGRAM, *words], stdin=subprocess.DEVNULL,
                               stdout=subprocess.DEVNULL, stderr=slave, **more)
    os.close(slave)
    meanwhile(running)
    while part:
        try:
            part = os.read(master, 4096)
        except OSError:  # the terminal's other side is closed
            break
        first = first or time.monotonic() - started
        shown += part
    os.close(master)
    return shown.decode("ascii"), first, time.monotonic() - started, running.wait()


class InFolder(unittest.TestCase):
    """Every test has a folder of its own, which is the working folder."""

    scene = None  # what scene.rt holds, where there is one

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="test.", dir=os.getcwd())
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        if self.scene:
            put("scene.rt", self.scene)

    def run_program(self, *words, program=PROGRAM, **more):
        streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
        if "input" not in more:
            streams["stdin"] = subprocess.DEVNULL
        done = subprocess.run([program, *words], text=True, check=False, **{**streams, **more})
        if done.stderr:  # what a machine that is slow says of the time left
            done.stderr = re.sub(r"(?m)^(\d+ %, \d+:\d\d left|\d+ done)\n", "", done.stderr)
        return done

    def ask(self, status, *words, **more):
        """What was said, on either stream."""
        result = self.run_program(*words, **more)
        self.assertEqual(result.returncode, status, (words, result.stdout, result.stderr))
        return result

    def ask_while(self, status, path, data, *words):
        """What was said where the file is replaced when it has been opened for the first time, and
        nothing of it was read: its lease, of which the kernel tells, keeps the program there."""
        put("replacing", data)
        signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGIO])
        with open(path, "rb") as file:
            try:
                fcntl.fcntl(file, fcntl.F_SETLEASE, fcntl.F_WRLCK)
            except OSError as error:
                self.skipTest(f"no leases in this folder: {error}")
            with subprocess.Popen([PROGRAM, *words], text=True, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
                opened = signal.sigtimedwait([signal.SIGIO], 30)
                os.replace("replacing", path)
                fcntl.fcntl(file, fcntl.F_SETLEASE, fcntl.F_UNLCK)
                said = "".join(running.communicate())
        self.assertIsNotNone(opened, words)
        self.assertEqual(running.returncode, status, (words, said))
        return said

    def succeed(self, *words, **more):
        """Its standard output; nothing was said on standard error."""
        result = self.ask(0, *words, **more)
        self.assertEqual(result.stderr, "", words)
        return result.stdout

    def fail_with(self, status, pattern, *words, **more):
        """One line on standard error, which the pattern matches; no output and no file changed."""
        before = all_files()
        result = self.ask(status, *words, **more)
        self.assertRegex(result.stderr, r"\A" + pattern + r"\n\Z", words)
        self.assertEqual((result.stderr.count("\n"), result.stdout or ""), (1, ""), words)
        self.assertEqual(all_files(), before, words)

    def refuse(self, complaint, *words):
        """Wrong usage of the command that the words begin with."""
        name = " ".join(["surehit", *re.findall(r"\A[a-z]+", words[0])])
        if "unknown command" in complaint:
            name = "surehit"
        self.fail_with(WRONG_USAGE,
                       re.escape(f"{name}: error: {complaint}") + f".*; see '{name} --help'",
                       *words)

    def refuse_all(self, name):
        """Words and a complaint."""
        for line in rows(name):
            words, complaint = line.split(" | ")
            self.refuse(complaint, *shlex.split(words))
