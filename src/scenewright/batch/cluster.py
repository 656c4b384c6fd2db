"""The jobs of a batch on a Dask cluster: the same function, run by Dask's workers.

Dask hands out the jobs, moves them when a worker dies and shows them on its page (``arrange``);
the ledger, the table and the manifest stay with who started the batch. Limits of memory and time
are the cluster's. Needs the extra ``cluster``.
M. Rocklin, *Dask: parallel computation with blocked algorithms and task scheduling* (2015).
"""

from __future__ import annotations

import os
import secrets
import time
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import contextmanager, suppress
from itertools import islice
from math import inf
from pathlib import Path
from typing import Any, NamedTuple

from scenewright._version import __version__
from scenewright.batch.jobs import BatchOptions, Job
from scenewright.batch.table import ResultRow, make_failed_row
from scenewright.batch.worker import Order, Place, do_order
from scenewright.batch.worker_pool import order_of
from scenewright.core.errors import InputError
from scenewright.core.extras import install_line
from scenewright.formats import SAMPLE

ANSWER = "10s"
"""How long a scheduler may take to answer at first."""
LOOK, LOOK_AT_WORKERS = 0.05, 2.0
"""Seconds between looks at what is done, and at whether anybody works."""
AHEAD = 3
"""Jobs at the scheduler for every thread of a worker, so that a long list takes no memory."""


class Cluster(NamedTuple):
    """The address of a Dask scheduler (empty: workers of this machine), the fsspec address results
    are put at (empty: the folder), and how long it is waited for workers, in seconds."""

    scheduler: str = ""
    address: str = ""
    patience: float = 60.0


HERE = Cluster()
"""This machine, into the folder."""


def arrange_on(
    cluster: Cluster,
    jobs: Sequence[Job],
    options: BatchOptions,
    parts: Path,
    cancel: Callable[[], bool] | None,
) -> Generator[tuple[Job, ResultRow], None, None]:
    """Jobs with their rows as Dask's workers end them; stops early when ``cancel`` answers true.

    A job whose workers die again and again fails with a line; one job is one task, so that what is
    done stays whatever happens. Raises :class:`InputError` where the scheduler or all workers are
    gone.
    """
    place = Place(str(parts), cluster.address)
    with _connected(cluster) as client:
        waiting = iter(jobs)
        _check_workers(client, cluster, place)
        running: dict[Any, Job] = {}
        seen = time.monotonic()
        while True:
            count = AHEAD * max(sum(client.nthreads().values()), 1)
            for job in islice(waiting, max(count - len(running), 0)):
                running[_submit(client, job, options, place)] = job
            if not running:
                return
            looked = time.monotonic()
            while time.monotonic() - looked < LOOK_AT_WORKERS:
                done = [future for future in running if future.done()]
                for future in done:
                    job = running.pop(future)
                    yield job, _row_of(future, job, cluster)
                if cancel is not None and cancel():
                    client.cancel([*running])
                    return
                if len(running) <= count // 2:
                    break
                time.sleep(LOOK)
            seen = _check_alive(client, cluster, seen)


@contextmanager
def _connected(cluster: Cluster) -> Iterator[Any]:
    """A client of the scheduler, quiet about what it retries."""
    import logging

    try:
        from distributed import Client
    except ImportError:
        raise InputError("--scheduler needs Dask", install_line("distributed")) from None
    for name in ("distributed", "tornado"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    try:
        client = Client(cluster.scheduler, timeout=ANSWER, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise _gone(cluster, "no Dask scheduler answers") from error
    try:
        yield client
    finally:
        with suppress(Exception):
            client.close(timeout=2)


def _gone(cluster: Cluster, fault: str) -> InputError:
    remedy = "start it (dask scheduler, dask worker) and run the same command again"
    return InputError(fault, remedy, file=f"--scheduler {cluster.scheduler}")


def _check_workers(client: Any, cluster: Cluster, place: Place) -> None:
    """Wait for a worker; all are to have this version, and to see the folder of results."""
    try:
        client.wait_for_workers(1, timeout=cluster.patience)
        told = client.run(_tell, place.parts)
    except TimeoutError:
        raise _gone(cluster, f"has had no worker for {cluster.patience:g} s") from None
    except ImportError:
        told = {"": ("", True)}
    for version, sees in told.values():
        if version != __version__:
            fault = f"has workers without Scenewright {__version__}"
            raise InputError(fault, "install the same there", file=f"--scheduler {cluster[0]}")
        if not (sees or place.address):
            fault = "has workers that do not see the folder of results"
            remedy = "give -o a folder all of them share, or --to ADDRESS"
            raise InputError(fault, remedy, file=f"--scheduler {cluster.scheduler}")


def _tell(parts: str) -> tuple[str, bool]:
    """What a worker is asked at first: its version, and whether it sees a folder."""
    return __version__, os.path.isdir(parts)


def _check_alive(client: Any, cluster: Cluster, seen: float) -> float:
    """When somebody was last seen at work. Raises :class:`InputError` where that is too long
    ago."""
    now = time.monotonic()
    with suppress(OSError, TimeoutError):
        if client.status == "running" and client.nthreads():
            return now
    if client.status in ("closed", "closing"):
        raise _gone(cluster, "the scheduler is gone")
    if now - seen > cluster.patience:
        raise _gone(cluster, f"nobody has worked for {cluster.patience:g} s")
    return seen


def _submit(client: Any, job: Job, options: BatchOptions, place: Place) -> Any:
    """One task: the job, with the content of its file for workers that do not see it."""
    order: Order = order_of(job)
    if not job.source.startswith(SAMPLE) and os.path.isfile(job.source):
        order = order._replace(content=Path(job.source).read_bytes())
    key = f"arrange-{job.key}-{secrets.token_hex(4)}"
    return client.submit(do_order, order, options, inf, place, key=key, pure=False)


def _row_of(future: Any, job: Job, cluster: Cluster) -> ResultRow:
    """The row of a task; one that failed says why in one line."""
    if future.status == "finished":
        row: ResultRow = future.result()
        return row
    if future.status in ("cancelled", "lost"):
        raise _gone(cluster, "the scheduler is gone")
    error = future.exception()
    text = f"{type(error).__name__}: {error}"
    if type(error).__name__ == "KilledWorker":
        text = "killed its worker again and again; give the workers more memory"
    return make_failed_row(job.source, 0.0, f"{job.source}: {text}")
