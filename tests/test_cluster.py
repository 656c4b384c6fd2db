"""Batches on a Dask cluster: the same rows and bytes as here, nothing lost when workers die."""

from __future__ import annotations

import json
import os
import signal
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import scenewright as sw
from scenewright.batch import Cluster, Variation
from scenewright.batch.cluster import arrange_on
from scenewright.batch.table import COMPLETE, FAILED, ResultRow
from scenewright.batch.worker import do_order
from scenewright.cli import run
from scenewright.core.errors import InputError
from test_sets import lines_of, plans
from thoroughness import few_or_many, only_thorough

distributed = pytest.importorskip("distributed")
MAKE: dict[str, Any] = {"steps": 200, "manifest": "jsonl", "variation": Variation(range(3), 1)}
CLUSTER = sys.modules[arrange_on.__module__]
pytestmark = pytest.mark.filterwarnings("ignore")


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    """Two workers, each a process, started anew when they die."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50
        ) as made:
            yield made


def pids(cluster: Any) -> list[int]:
    with distributed.Client(cluster.scheduler_address, set_as_default=False) as client:
        return [*client.run(os.getpid).values()]


def test_a_cluster_makes_the_same_bytes_and_goes_on(cluster: Any, tmp_path: Path) -> None:
    folder, before = plans(tmp_path / "in", 2), list[bool]()
    (folder / "broken.json").write_text("{")
    on = Cluster(cluster.scheduler_address)
    rows = sw.batch(folder, tmp_path / "there", cluster=on, **MAKE)
    here = sw.batch(folder, tmp_path / "here", jobs=1, **MAKE)
    assert [row.status for row in rows] == [row.status for row in here]
    assert sum(row.status == COMPLETE for row in rows) == 6
    for row in here:
        for path in map(Path, row.outputs):
            assert (tmp_path / "there" / path.name).read_bytes() == path.read_bytes()
    assert lines_of(tmp_path / "there") == lines_of(tmp_path / "here")
    heard = lambda *told: before.append(told[3])  # noqa: E731
    sw.batch(folder, tmp_path / "there", cluster=on, progress=heard, **MAKE)
    assert before == [True] * 6 + [False] * 3  # what failed is tried again


def test_results_at_an_address_and_files_workers_do_not_see(cluster: Any, tmp_path: Path) -> None:
    folder, store, before = plans(tmp_path / "in", 1), tmp_path / "store", list[bool]()
    on = Cluster(cluster.scheduler_address, f"file://{store}")
    rows = sw.batch(folder, tmp_path / "out", cluster=on, **MAKE)
    assert [row.status for row in rows] == [COMPLETE] * 3
    assert sorted(path.name for path in store.iterdir()) == [f"wc-0-{k}-1.json" for k in range(3)]
    for line in lines_of(tmp_path / "out"):
        assert (store / line["files"][0]["file"]).stat().st_size == line["files"][0]["bytes"]
    (store / "wc-0-1-1.json").unlink()
    heard = lambda *told: before.append(told[3])  # noqa: E731
    sw.batch(folder, tmp_path / "out", cluster=on, progress=heard, **MAKE)
    assert before == [True, True, False]
    assert (store / "wc-0-1-1.json").exists()


@pytest.mark.slow
def test_killed_workers_of_a_cluster_lose_nothing(cluster: Any, tmp_path: Path) -> None:
    """One worker, twice in the thorough check."""
    count, kills = few_or_many(2, 4), few_or_many(1, 2)
    folder, told, killed = plans(tmp_path / "in", count), list[ResultRow](), list[int]()

    def heard(row: ResultRow, done: int, total: int, was: bool) -> None:
        told.append(row)
        if done in (2, 6)[:kills]:
            killed.append(pids(cluster)[0])
            os.kill(killed[-1], signal.SIGKILL)

    on = Cluster(cluster.scheduler_address)
    rows = sw.batch(folder, tmp_path / "out", cluster=on, progress=heard, **MAKE)
    assert [row.status for row in rows] == [COMPLETE] * 3 * count
    assert len({row.outputs for row in told}) == len(told) == 3 * count
    assert len(killed) == kills


@only_thorough
@pytest.mark.slow
def test_a_job_that_kills_every_worker_is_told_in_one_line(
    cluster: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = plans(tmp_path / "in", 1)
    bad = folder / "bad.json"
    bad.write_text("{}")

    def die_of_bad(order: Any, *rest: Any) -> ResultRow:
        if order.name.startswith("bad"):
            os._exit(9)
        return do_order(order, *rest)

    monkeypatch.setattr(CLUSTER, "do_order", die_of_bad)
    on = Cluster(cluster.scheduler_address)
    make = MAKE | {"variation": Variation(range(1), 1)}
    rows = sw.batch(folder, tmp_path / "out", cluster=on, **make)
    assert [row.status for row in rows] == [FAILED, COMPLETE]
    assert "killed its worker again and again" in rows[0].message


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--scheduler", "tcp://127.0.0.1:9"], "no Dask scheduler answers"),
        (["--scheduler", "nowhere"], "no Dask scheduler answers"),
        (["--scheduler", "tcp://127.0.0.1:9", "--jobs", "2"], "are of this machine"),
        (["--to", "odd://bucket/set"], "is no address that can be written to"),
    ],
)
def test_a_cluster_that_is_not_there_is_one_line(
    words: list[str],
    said: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(CLUSTER, "ANSWER", "1s")
    folder = plans(tmp_path / "in", 1)
    assert run(["batch", str(folder), "-o", str(tmp_path / "out"), *words]) == 2
    fault = capsys.readouterr().err
    assert said in fault
    assert fault.count("\n") == 1


def test_a_scheduler_without_workers_is_one_line(tmp_path: Path) -> None:
    folder = plans(tmp_path / "in", 1)
    with distributed.LocalCluster(n_workers=0, processes=False, dashboard_address=None) as empty:
        on = Cluster(empty.scheduler_address, patience=0.5)
        with pytest.raises(InputError, match=r"has had no worker for 0\.5 s"):
            sw.batch(folder, tmp_path / "out", cluster=on, **MAKE)
    assert json.loads((tmp_path / "out" / "summary.json").read_text())["files"] == []
