# SPDX-License-Identifier: MIT
"""A campaign by GNU parallel over ssh, one of whose hosts dies, and by MPI: the record of one
process, byte for byte. The Job for Kubernetes holds nothing that its interface does not know.

    test_others.py CAMPAIGN SOURCES"""
import json
import os
import pathlib
import shutil
import subprocess
import sys

from daemons import free_ports, kill_where, trial, until

CAMPAIGN, SOURCES = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
PIECES, HOSTS, RANKS = 24, 2, 2
SSHD = """\
ListenAddress 127.0.0.1
HostKey {folder}/key
AuthorizedKeysFile {folder}/key.pub
AcceptEnv NOTHING
SetEnv SUREHIT_HOST={name}
StrictModes no
UsePAM no
PermitRootLogin yes
PidFile none
Port {port}
"""
SSH = """\
Host {name}
HostName 127.0.0.1
Port {port}
IdentityFile {folder}/key
UserKnownHostsFile {folder}/known
StrictHostKeyChecking no
BatchMode yes
LogLevel ERROR
"""


class Hosts:
    """Each a daemon of ssh, and known by its name."""

    def __init__(self, folder):
        self.folder, self.daemons = folder, {}
        os.makedirs("/run/sshd", exist_ok=True)  # where the daemon parts with its rights
        subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", folder / "key"],
                       check=True)
        self.ports = {f"h{i}": port for i, port in enumerate(free_ports(HOSTS))}
        self.write("config", SSH)
        (folder / "hosts").write_text("".join(f"1/{name}\n" for name in self.ports))

    def write(self, path, form):
        (self.folder / path).write_text("\n".join(
            form.format(folder=self.folder, name=name, port=port)
            for name, port in self.ports.items()))

    def __enter__(self):
        for name, port in self.ports.items():
            config = self.folder / f"sshd.{name}"
            config.write_text(SSHD.format(folder=self.folder, name=name, port=port))
            self.daemons[name] = subprocess.Popen(
                [shutil.which("sshd", path="/usr/sbin:/sbin"), "-D", "-f", config])
            until(lambda name=name: self.ssh(name, "true") == 0, 60, f"{name} answers")
        return self

    def __exit__(self, *_):
        for daemon in self.daemons.values():
            daemon.kill()

    def ssh(self, *words):
        return subprocess.run(["ssh", "-F", self.folder / "config", *words],
                              stderr=subprocess.DEVNULL).returncode

    def kill(self, name):
        self.daemons[name].kill()
        kill_where(f"SUREHIT_HOST={name}")


def by_ssh(campaign, folder):
    pieces = folder / "by_ssh"
    (folder / "ssh").mkdir()
    with Hosts(folder / "ssh") as hosts:
        work = subprocess.Popen(["sh", SOURCES / "here.sh", CAMPAIGN, folder / "manifest", pieces,
                                 folder / "ssh/hosts"],
                                env={**os.environ, "PARALLEL_SSH": f"ssh -F {folder}/ssh/config",
                                     "PARALLEL_HOME": str(folder / "parallel")})
        until(lambda: len([*pieces.glob("*.json")]) > PIECES // 4, 300, "some pieces are done")
        hosts.kill("h1")
        if work.wait() != 0:
            yield f"here.sh ends with {work.returncode}"
    campaign.run("merge", "by_ssh", "-o", "record")
    if campaign.differs("record"):
        yield "the record by ssh is not that of one process"


def by_mpi(campaign, folder):
    subprocess.run(["mpicc", "-std=c11", "-Wall", "-Wextra", "-Werror", "-O2",
                    SOURCES / "mpi.c", "-o", "campaign-mpi"], check=True)
    (folder / "by_mpi").mkdir()
    campaign.run("work", "manifest", "5", "by_mpi")
    missing = subprocess.run(["sh", SOURCES / "missing.sh", CAMPAIGN, "manifest", "by_mpi"],
                             check=True, text=True, stdout=subprocess.PIPE).stdout.split()
    if len(missing) != PIECES - 1:
        yield f"{len(missing)} pieces are missing"

    def ranks(*numbers):
        return subprocess.run(["mpirun", "--allow-run-as-root", "--oversubscribe", "-np",
                               str(RANKS), "./campaign-mpi", CAMPAIGN, "manifest", "by_mpi",
                               *numbers], text=True, stderr=subprocess.PIPE)
    done = ranks(*missing)
    if done.returncode != 0 or f"{len(missing)} of {len(missing)} pieces" not in done.stderr:
        yield f"mpirun ends with {done.returncode}: {done.stderr}"
    campaign.run("merge", "by_mpi", "-o", "record")
    if campaign.differs("record"):
        yield "the record by MPI is not that of one process"
    if ranks(str(PIECES + 1)).returncode == 0:
        yield "a piece that is not there is no fault by MPI"


def kubernetes():
    """Its interface makes an object of the file, and of that the same file."""
    import kubernetes.client
    import yaml
    written = yaml.safe_load((SOURCES / "kubernetes.yaml").read_text())
    client = kubernetes.client.ApiClient()

    class Said:
        data = json.dumps(written)
    read = client.sanitize_for_serialization(client.deserialize(Said, "V1Job"))
    if read != written:
        yield f"kubernetes.yaml is not what is read of it: {json.dumps(read)}"


def faults_of(campaign, folder):
    campaign.plan(PIECES * campaign.cases_of_a_second() // 2, PIECES)
    yield from kubernetes()
    yield from by_ssh(campaign, folder)
    yield from by_mpi(campaign, folder)


if __name__ == "__main__":
    sys.exit(trial(CAMPAIGN, ("ssh", "ssh-keygen", "parallel", "mpicc", "mpirun"), faults_of))
