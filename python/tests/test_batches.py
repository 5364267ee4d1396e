"""Many logs, here and on workers of Dask."""

import os

import pytest

import pentimento
from pentimento import batches

COMMAND = os.environ["PENTIMENTO_COMMAND"]


@pytest.fixture
def logs(tmp_path):
    names = []
    for i in range(4):
        names.append(tmp_path / f"{i}.jsonl")
        with pentimento.Session(names[-1], 0.4, 0.3, grid=(64, 48)) as session:
            session.spline([(0.1, 0.05 + 0.05 * i), (0.3, 0.1)])
    names[2].write_text("broken\n")
    return names


def test_each_log_has_its_row_in_order(logs):
    rows = pentimento.batch(logs, command=COMMAND)
    assert [row.log for row in rows] == [str(log) for log in logs]
    assert [row.exit_code for row in rows] == [0, 0, 3, 0]
    assert "2.jsonl:1" in rows[2].message and rows[2].state_sha256 is None
    assert len({row.state_sha256 for row in rows}) == 4


def test_a_hang_and_options(logs, tmp_path):
    slow = tmp_path / "slow"
    slow.write_text("#!/bin/sh\nexec sleep 60\n")
    slow.chmod(0o755)
    assert "longer than 0.2 s" in pentimento.batch(logs[:1], command=str(slow), timeout_s=0.2)[0].message
    picture = tmp_path / "a.png"
    assert batches.render(logs[0], ["-o", picture], COMMAND).exit_code == 0
    assert picture.exists()


def test_dask_gives_the_same_rows_though_a_worker_dies(logs, tmp_path):
    distributed = pytest.importorskip("distributed")
    killing = tmp_path / "killing"
    mark = tmp_path / "killed once"
    # The first job kills the worker that runs it: a child of the worker is its process's child.
    killing.write_text(f'#!/bin/sh\nif mkdir "{mark}" 2>/dev/null; then kill -KILL $PPID; sleep 5; fi\n'
                       f'exec "{COMMAND}" "$@"\n')
    killing.chmod(0o755)
    here = pentimento.batch(logs, command=COMMAND)
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None,
                                  local_directory=str(tmp_path)) as cluster, distributed.Client(cluster) as client:
        rows = pentimento.batch(logs, client, command=str(killing))
    assert mark.exists(), "no worker was killed"
    assert [(row.exit_code, row.state_sha256) for row in rows] == [(row.exit_code, row.state_sha256) for row in here]
