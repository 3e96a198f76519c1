# SPDX-License-Identifier: MIT
"""A campaign on a Slurm cluster of four nodes, all on this machine: a node dies, tasks end by their
limit, a third of the pieces is worked off twice, and the record is that of one process, byte for
byte.

    test_cluster.py CAMPAIGN SLURM"""
import os
import pathlib
import re
import socket
import subprocess
import sys

from daemons import free_ports, kill_where, trial, until

CAMPAIGN, SLURM = map(os.path.abspath, sys.argv[1:3])
NODES, PIECES, LIMIT = 4, 44, 1
CGROUPS = "CgroupPlugin=cgroup/v1\nCgroupMountpoint={folder}\n"  # none: not every root has any
CONFIG = """\
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
SlurmdTimeout=10
MaxArraySize=31
ReturnToService=1
SchedulerParameters=sched_interval=1,batch_sched_delay=0
"""


class Slurm:
    """One machine, one controller, and a daemon a node; all they write is in one folder."""

    def __init__(self, folder):
        self.folder, self.daemons = folder, {}
        ports = free_ports(NODES + 1)
        for name in ("state", *(f"n{i}" for i in range(NODES))):
            (folder / name).mkdir()
        config = CONFIG.format(folder=folder, port=ports[0], host=socket.gethostname())
        for i in range(NODES):
            config += (f"NodeName=n{i} NodeHostname=localhost NodeAddr=127.0.0.1 "
                       f"Port={ports[i + 1]} CPUs=1\n")
        config += f"PartitionName=all Nodes=n[0-{NODES - 1}] Default=YES State=UP\n"
        (folder / "slurm.conf").write_text(config)
        (folder / "cgroup.conf").write_text(CGROUPS.format(folder=folder))
        key = folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}

    def start(self, name, *words):
        with open(self.folder / f"{name}.out", "wb") as out:
            self.daemons[name] = subprocess.Popen(words, env=self.environment, stdout=out,
                                                  stderr=out, start_new_session=True)

    def __enter__(self):
        at = self.folder
        self.start("munged", "munged", "--foreground", "--force", f"--key-file={at}/munge.key",
                   f"--socket={at}/munge.socket", f"--pid-file={at}/munged.pid",
                   f"--log-file={at}/munged.log", f"--seed-file={at}/munged.seed")
        until((at / "munge.socket").exists, 60, "munge answers")
        self.start("slurmctld", "slurmctld", "-D", "-f", f"{at}/slurm.conf")
        for i in range(NODES):
            self.start(f"n{i}", "slurmd", "-D", "-f", f"{at}/slurm.conf", "-N", f"n{i}")
        self.until_idle()
        return self

    def until_idle(self):
        try:
            until(lambda: self.ask("sinfo", "-h", "-N", "-o", "%T").split() == ["idle"] * NODES,
                  120, "all nodes are idle")
        except SystemExit:
            print(*((self.folder / f"{name}.out").read_text() for name in self.daemons))
            self.__exit__()
            raise

    def __exit__(self, *_):
        if self.ask("sinfo", "-h"):
            self.ask("scancel", "--user=root")
        for daemon in self.daemons.values():
            daemon.terminate()
        for daemon in self.daemons.values():
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()

    def ask(self, *words):
        return subprocess.run(words, env=self.environment, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL).stdout

    def kill_node(self, name):
        """The daemon and what it runs: the machine is gone."""
        self.daemons[name].kill()
        kill_where(f"SLURMD_NODENAME={name}")


def faults_of(campaign, folder):
    # A piece takes more than its limit.
    campaign.plan(int(1.4 * LIMIT * PIECES * campaign.cases_of_a_second()), PIECES)
    (folder / "slurm").mkdir()
    with Slurm(folder / "slurm") as cluster:
        yield from hold(campaign, cluster, folder)


def hold(campaign, cluster, folder):
    pieces = folder / "pieces"
    pieces.mkdir()
    watching = subprocess.Popen([sys.executable, SLURM, CAMPAIGN, "manifest", "pieces", "record",
                                 "--limit", str(LIMIT)],
                                env=cluster.environment, text=True, stdout=subprocess.PIPE)
    until(lambda: list(pieces.glob("*.part")), 120, "some piece is under way")
    twice = f"1-{PIECES // 3}"
    cluster.ask("sbatch", f"--array={twice}", "--wrap", f"{CAMPAIGN} work {folder}/manifest "
                f"$SLURM_ARRAY_TASK_ID {pieces}", "--output=/dev/null")
    until(lambda: "n1 " in cluster.ask("squeue", "-h", "-o", "%N "), 120, "the second node works")
    cluster.kill_node("n1")
    said = watching.communicate()[0]
    print(said, end="")
    if watching.returncode != 0:
        yield f"slurm.py ends with {watching.returncode}"
    logs = "".join(path.read_text() for path in (pieces / "logs").glob("*.txt"))
    if logs.count("no processor time is left") < NODES:
        yield f"limits ended only {logs.count('no processor time is left')} tasks"
    if "down" not in cluster.ask("sinfo", "-h", "-N", "-n", "n1", "-o", "%T"):
        yield "the node that was killed is not down"
    if f"of {PIECES} pieces done" not in said:
        yield "no line says how far it is"
    if not re.search(r"pieces done.*, about \d+ s left", said):
        yield "no line says how long the rest takes"
    if campaign.differs("record"):
        yield "the record is not that of one process"


if __name__ == "__main__":
    sys.exit(trial(CAMPAIGN, ("munged", "slurmctld", "slurmd", "sbatch"), faults_of))
