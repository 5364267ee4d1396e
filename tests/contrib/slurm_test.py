"""The batch as an array of a private Slurm of one node, with a broken log and a task that is queued again.

  slurm_test.py SOURCE COMMAND
"""

import getpass
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import time

import made_batch

CONFIG = """
ClusterName=private
SlurmctldHost={host}
SlurmctldPort={port}
SlurmdPort={node_port}
AuthType=auth/none
AuthInfo=cred_expire=5
CredType=cred/none
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/ctld.pid
SlurmdPidFile={folder}/d.pid
SlurmctldLogFile={folder}/ctld.log
SlurmdLogFile={folder}/d.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
ReturnToService=2
SchedulerParameters=sched_interval=2
KillWait=20
JobRequeue=1
MinJobAge=300
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES State=UP MaxTime=INFINITE
"""


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Slurm:
    """A controller and a node, which end with the block."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        for part in ("state", "spool"):
            (self.folder / part).mkdir()
        host = socket.gethostname().split(".")[0]
        config = self.folder / "slurm.conf"
        config.write_text(CONFIG.format(host=host, port=free_port(), node_port=free_port(), user=getpass.getuser(),
                                        folder=self.folder))
        self.environment = {**os.environ, "SLURM_CONF": str(config)}

    def __enter__(self):
        self.daemons = [subprocess.Popen([daemon, "-D", "-f", self.folder / "slurm.conf"], env=self.environment,
                                         stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                        for daemon in ("/usr/sbin/slurmctld", "/usr/sbin/slurmd")]
        self.until(lambda: "idle" in self.run("sinfo", "-h", "-o", "%T", check=False), 60, "a node")
        return self

    def __exit__(self, *problem):
        for daemon in self.daemons:
            daemon.terminate()
        for daemon in self.daemons:
            daemon.wait()
        if problem[0]:
            for name in ("ctld.log", "d.log"):
                log = self.folder / name
                print(name, log.read_text()[-3000:] if log.exists() else "is not there")

    def run(self, *words, check=True, **more):
        return subprocess.run([str(word) for word in words], check=check, text=True, capture_output=True,
                              env={**self.environment, **more}).stdout

    def until(self, holds, seconds, what):
        end = time.monotonic() + seconds
        while not holds():
            assert time.monotonic() < end, f"waited {seconds} s for {what}"
            time.sleep(0.2)


def main():
    source, command = (pathlib.Path(word).resolve() for word in sys.argv[1:])
    with tempfile.TemporaryDirectory() as name, Slurm(name) as slurm:
        folder = pathlib.Path(name)
        manifest = made_batch.write(folder)
        # Slow enough that a task can be caught in the middle.
        slow = folder / "slow"
        slow.write_text(f'#!/bin/sh\nsleep 1\nexec "{command}" "$@"\n')
        slow.chmod(0o755)
        job = slurm.run("sbatch", "--parsable", "--array=1-2", f"--output={folder}/task-%a.txt", f"--chdir={folder}",
                        source / "contrib/slurm/batch.sbatch", manifest, folder / "run", "--no-pictures", "--program",
                        slow, PENTIMENTO=str(command)).strip()
        rows = folder / "run/rows"
        slurm.until(lambda: rows.exists() and len(list(rows.iterdir())) >= 2, 60, "the first rows")
        slurm.run("scontrol", "requeue", f"{job}_1")
        report = slurm.run("sbatch", "--parsable", f"--dependency=afterany:{job}", f"--output={folder}/report.txt",
                           source / "contrib/slurm/report.sbatch", folder / "run", folder / "report",
                           PENTIMENTO=str(command)).strip()
        slurm.until(lambda: not slurm.run("squeue", "-h", "-j", f"{job},{report}", check=False).strip(), 120,
                    "the end of all jobs")
        found = made_batch.verdicts(folder / "report/junit.xml")
        assert found == made_batch.expected(), found
        assert found == made_batch.on_this_machine(command, manifest, folder)
        restarts = slurm.run("scontrol", "show", "job", f"{job}_1", check=False)
        assert "Restarts=1" in restarts, restarts
        print("the same report as without an engine, after a task was queued again")


main()
