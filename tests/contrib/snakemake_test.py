"""The batch by Snakemake, with a broken log and with a shard that fails once.

  snakemake_test.py SOURCE COMMAND
"""

import os
import pathlib
import subprocess
import sys
import tempfile

import made_batch

# Fails the first time that the second shard is tried, as a lost machine would.
FLAKY = """#!/bin/sh
case "$*" in
  *"--shard 2/3"*) [ -e "{mark}" ] || {{ touch "{mark}"; kill -KILL $$; }};;
esac
exec "{command}" "$@"
"""


def main():
    source, command = (pathlib.Path(word).resolve() for word in sys.argv[1:])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        manifest = made_batch.write(folder)
        flaky = folder / "flaky"
        flaky.write_text(FLAKY.format(mark=folder / "failed once", command=command))
        flaky.chmod(0o755)
        done = subprocess.run(
            ["snakemake", "-s", source / "contrib/snakemake/Snakefile", "-j", "2", "--retries", "2", "--config",
             f"manifest={manifest}", f"run={folder}/run", f"report={folder}/report", "shards=3",
             f"pentimento={flaky}", "options=--no-pictures"],
            cwd=folder, capture_output=True, text=True, env={**os.environ, "HOME": name, "XDG_CACHE_HOME": name})
        assert done.returncode == 0, done.stdout + done.stderr
        assert (folder / "failed once").exists(), "the shard was never lost"
        found = made_batch.verdicts(folder / "report/junit.xml")
        assert found == made_batch.expected(), found
        assert found == made_batch.on_this_machine(command, manifest, folder)
        assert (folder / "report/index.html").exists()
        print("the same report as without an engine")


main()
