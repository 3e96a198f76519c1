# SPDX-License-Identifier: MIT
"""Daemons of a test's own on the loopback; campaigns that are held to what one process makes."""
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from pages import verdict  # noqa: E402

FIRST_PORT, ROOM = 17000, 16  # below those that the system gives away


def until(true, seconds, what):
    end = time.monotonic() + seconds
    while not true():
        if time.monotonic() > end:
            raise SystemExit(f"in {seconds} seconds it did not come true: {what}")
        time.sleep(0.1)


def free_ports(count):
    """That nobody listens to. Tests at one time look in places of their own."""
    port, found = FIRST_PORT + ROOM * (os.getpid() % 900), []
    while len(found) < count:
        with socket.socket() as one:
            if one.connect_ex(("127.0.0.1", port)) != 0:
                found.append(port)
        port += 1
    return found


def kill_where(variable):
    """Processes with NAME=VALUE in their environment."""
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if f"{variable}\0".encode() in (process / "environ").read_bytes():
                os.kill(int(process.name), signal.SIGKILL)
        except OSError:
            pass  # it has just ended, or is nobody's to look at


class Campaign:
    """In the folder where the test is; `planned` is what all of its plans have."""

    def __init__(self, program, *planned):
        self.program, self.planned = program, planned

    def run(self, *words):
        return subprocess.run([self.program, *words], check=True, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE).stdout

    def plan(self, cases, pieces):
        """`manifest`, in so many pieces, and `one`."""
        for name, count in (("manifest", pieces), ("one", 1)):
            self.run("plan", *self.planned, "--cases", str(cases), "--pieces", str(count),
                     "-o", name)

    def cases_of_a_second(self):
        said = self.run("plan", *self.planned, "--cases", "1e8", "-o", "rate")
        return int(1e8 / float(said.rsplit(", ", 1)[1].split()[0]))

    def differs(self, record):
        """From what one process makes of it."""
        alone = pathlib.Path("alone")
        if not alone.is_dir():
            alone.mkdir()
            self.run("work", "one", "1", "alone")
            self.run("merge", "alone", "-o", "whole")
        return pathlib.Path(record).read_bytes() != pathlib.Path("whole").read_bytes()


def trial(program, needed, faults_of):
    """The exit status. faults_of(campaign, folder) is asked in a folder of its own, by root, where
    all programs that are needed are there."""
    missing = [name for name in needed if not shutil.which(name)]
    if missing or os.geteuid() != 0:
        print(f"skipped: no {', '.join(missing) or 'root'}")
        return 77
    with tempfile.TemporaryDirectory(prefix="cluster-", dir="/tmp") as name:
        os.chdir(name)
        campaign = Campaign(program, "--against", "exact", "--seed", "3")
        return verdict([*faults_of(campaign, pathlib.Path(name))])
