"""Tables of a benchmark whose runs are spread over processes, one a core.

The runs share nothing: each has one thread, and what it costs is told by the processor's time of
its process (:func:`time.process_time`), which other processes hardly change.
"""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from typing import Any, NamedTuple

from scenewright.core.garbage import collect_rarely

Record = dict[str, Any]
Progress = Callable[[float, str], None]
Job = Callable[[], Any]
"""A function of a module with its arguments (:func:`functools.partial`), so that it can be sent
to another process."""


class SpreadTable(NamedTuple):
    """A table: its name, its runs, and what makes records of their results, which come in the
    order of the runs."""

    name: str
    jobs: Sequence[Job]
    records: Callable[[list[Any]], Iterable[Record]]


def spread_tables(
    tables: Sequence[SpreadTable], progress: Progress | None = None, workers: int | None = None
) -> Iterator[Record]:
    """The records of one table after the other; a later one's runs begin while an earlier one's
    end, so that no core waits.

    >>> double = SpreadTable("n", [lambda: 1, lambda: 2], lambda got: [{"n": 2 * n} for n in got])
    >>> list(spread_tables([double], workers=1))
    [{'n': 2}, {'n': 4}]
    """
    jobs = [job for table in tables for job in table.jobs]
    results, done = spread(jobs, workers), 0
    for table in tables:
        found = []
        for _ in table.jobs:
            if progress:
                progress(done / len(jobs), table.name)
            found.append(next(results))
            done += 1
        yield from table.records(found)


def spread(jobs: Iterable[Job], workers: int | None = None) -> Iterator[Any]:
    """What each job returns, in the order of the jobs, on as many processes as there are cores.

    With one worker everything is done in this process. An interruption drops what has not begun,
    and waits for what has.
    """
    number = workers or os.cpu_count() or 1
    if number == 1:
        yield from map(_call, jobs)
        return
    pool = ProcessPoolExecutor(number, get_context("spawn"), _set_up_worker)
    try:
        yield from pool.map(_call, jobs)
    finally:
        pool.shutdown(cancel_futures=True)


def _call(job: Job) -> Any:
    return job()


def _set_up_worker() -> None:
    """Ctrl-C reaches every process of a terminal; the one that waits for the others ends them.
    Garbage is looked for as rarely as by the command line."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    collect_rarely()
