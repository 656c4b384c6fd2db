"""Many files on one machine: every core at work, each result written whole, nothing done twice.

The parent hands one file at a time to each of its workers (:mod:`scenewright.batch.worker_pool`)
and writes a line into the ledger for each that is done (:mod:`scenewright.batch.ledger`). Killed at
any moment and started again with the same words, it goes on where it was: what is finished and
unchanged is skipped. A file that cannot be used, takes too long or kills its worker twice has its
line in the table and stops nobody.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Sequence
from contextlib import ExitStack
from math import isfinite
from pathlib import Path

from scenewright.batch.cluster import HERE, Cluster, arrange_on
from scenewright.batch.jobs import AS_ASKED, BatchOptions, Job, Limits, Variation, list_jobs
from scenewright.batch.ledger import Ledger
from scenewright.batch.manifest import check_parquet, is_listed, manifest_line, write_manifest
from scenewright.batch.store import whole_at
from scenewright.batch.table import CSV, JSON, ResultRow, write_summary
from scenewright.batch.worker import Place
from scenewright.batch.worker_pool import WorkerPool, arrange_with
from scenewright.core.atomic_file import Identity, RunFiles, check_targets, recorded_run
from scenewright.core.errors import InputError
from scenewright.core.map_options import AS_IT_IS, MapOptions
from scenewright.workflow.looks import check_vary

__all__ = [
    "MEMORY",
    "TIME",
    "BatchOptions",
    "Cluster",
    "Job",
    "Limits",
    "ResultRow",
    "Variation",
    "batch",
]

MEMORY = 4.0
"""Memory a worker may take, GiB."""
TIME = 600.0
"""Seconds a file may take."""
OnResult = Callable[[ResultRow, int, int, bool], None]


def batch(
    sources: str | os.PathLike[str] | Sequence[str | os.PathLike[str]],
    folder: str | os.PathLike[str],
    *,
    formats: Sequence[str] = (".json",),
    jobs: int | None = None,
    preset: str = "default",
    solver: str | None = None,
    seconds: float | None = None,
    steps: int | None = None,
    seed: int = 0,
    keep: bool = False,
    catalogs: Sequence[str] = (),
    groups: Sequence[str] = (),
    accessible: bool = False,
    scale: float = 1.0,
    hidden_levels: bool = False,
    style: str = "",
    layouts: int | None = None,
    map_options: MapOptions = AS_IT_IS,
    clutter: str = "none",
    memory: float = MEMORY,
    limit: float = TIME,
    variation: Variation = AS_ASKED,
    manifest: str = "",
    cluster: Cluster = HERE,
    progress: OnResult | None = None,
    cancel: Callable[[], bool] | None = None,
) -> tuple[ResultRow, ...]:
    """Lay out every file of ``sources`` (files, folders, samples) into ``folder``.

    A row for each, in the order of the sources, is returned and written to ``summary.csv`` and
    ``summary.json``. ``jobs`` workers (one for each processor, if not stated) may take ``memory``
    GiB each and ``limit`` seconds a file; the other options are those of
    :func:`scenewright.arrange`. ``variation`` makes several homes and looks of every plan;
    ``manifest`` (``jsonl`` or ``parquet``) lists all scenes with what is known of them; ``cluster``
    names a Dask scheduler to work on, and an address of fsspec for the results.
    ``progress`` gets every row as it comes, how many are done, of how many, and whether the row was
    there before; when ``cancel`` answers true the workers are stopped and the rows so far returned.
    """
    given = [sources] if isinstance(sources, str | os.PathLike) else sources
    out = Path(folder)
    how = (preset, solver, seconds, steps, seed, keep)
    files = (tuple(catalogs), tuple(groups), scale, hidden_levels, accessible, style)
    vary = check_vary(variation.vary) if variation != AS_ASKED else ()
    options = BatchOptions(tuple(formats), *how, *files, layouts, map_options, vary, clutter)
    limits = _check_limits(Limits(jobs or os.cpu_count() or 1, memory, limit), options)
    _check_manifest(manifest)
    with recorded_run() as run:
        listed = list_jobs(given, out, options, variation)
        where = limits, cluster
        return _batch(listed, out, options, where, manifest, progress, cancel, run)


def _batch(
    orders: tuple[Job, ...],
    out: Path,
    options: BatchOptions,
    where: tuple[Limits, Cluster],
    manifest: str,
    progress: OnResult | None,
    cancel: Callable[[], bool] | None,
    run: RunFiles,
) -> tuple[ResultRow, ...]:
    """The rows of all orders; those that are done already are kept."""
    check_targets([out / CSV, out / JSON])
    address = where[1].address
    with Ledger(out, whole_at(address, out) if address else None) as ledger:
        rows = {order.name: ledger.find(order) for order in orders}
        found = {name: row for name, row in rows.items() if row is not None}
        for done, row in enumerate(found.values(), 1):
            _tell(progress, row, done, len(orders), True)
        waiting = [order for order in orders if order.name not in found]
        try:
            _work(waiting, options, *where, ledger, found, len(orders), progress, cancel, run.read)
        finally:
            rows_in_order = tuple(found[order.name] for order in orders if order.name in found)
            write_summary(out, rows_in_order, options)
            if manifest:
                _write_manifest(out, orders, found, manifest)
    return rows_in_order


def _write_manifest(
    out: Path, orders: tuple[Job, ...], found: dict[str, ResultRow], kind: str
) -> None:
    """The line of every scene there is, in the order of the jobs."""
    rows = [(job, found[job.name]) for job in orders if job.name in found]
    scenes = (manifest_line(*each) for each in rows if is_listed(each[1]))
    write_manifest(out, scenes, kind == "parquet")


def _check_manifest(kind: str) -> None:
    if kind not in ("", "jsonl", "parquet"):
        raise InputError(f"'{kind[:40]}' is no kind of manifest", "give jsonl or parquet")
    if kind == "parquet":
        check_parquet()


def _work(
    waiting: list[Job],
    options: BatchOptions,
    limits: Limits,
    cluster: Cluster,
    ledger: Ledger,
    found: dict[str, ResultRow],
    total: int,
    progress: OnResult | None,
    cancel: Callable[[], bool] | None,
    protected: Iterable[Identity],
) -> None:
    """Have the waiting orders done; every row goes to the ledger as it comes."""
    if not waiting:
        return
    with ExitStack() as stack:
        if cluster.scheduler:
            pairs = arrange_on(cluster, waiting, options, ledger.parts, cancel)
            stack.callback(pairs.close)
        else:
            place, count = Place(str(ledger.parts), cluster.address), min(limits.jobs, len(waiting))
            pool = WorkerPool(count, limits, options, place, protected)
            pairs = arrange_with(stack.enter_context(pool), waiting, cancel)
        for order, row in pairs:
            ledger.write(order, row)
            found[order.name] = row
            _tell(progress, row, len(found), total, False)


def _tell(progress: OnResult | None, row: ResultRow, done: int, total: int, before: bool) -> None:
    if progress is not None:
        progress(row, done, total, before)


def _check_limits(limits: Limits, options: BatchOptions) -> Limits:
    """Limits and options that can be used; whatever cannot is reported before anything starts."""
    from scenewright import domains

    for what, value in (("jobs", limits.jobs), ("memory", limits.memory), ("limit", limits.time)):
        if not (isfinite(value) and value > 0):
            raise InputError(f"--{what} {value:g} is not possible", "give a positive number")
    if not options.formats:
        raise InputError("no format is given", "name one, such as .json")
    for suffix in options.formats:
        if not suffix.startswith(".") or "/" in suffix:
            raise InputError(
                f"'{suffix}' is not a supported format", "give suffixes, such as .json,.glb"
            )
        _check_written(suffix)
    _known(
        "preset", options.preset, [n for d in domains.domain_names() for n in domains.presets(d)]
    )
    if options.solver is not None:
        _known(
            "solver",
            options.solver,
            [n for d in domains.domain_names() for n in domains.solvers(d)],
        )
    return limits


def _check_written(suffix: str) -> None:
    from scenewright.formats import writer

    try:
        writer(f"scene{suffix}")
    except InputError as error:
        raise InputError(error.fault, error.remedy, file="--format") from None


def _known(what: str, name: str, names: Collection[str]) -> None:
    if name not in names:
        text = ", ".join(_once(names))
        raise InputError(f"unknown {what} '{name}'", f"use one of: {text}")


def _once(names: Iterable[str]) -> list[str]:
    return list(dict.fromkeys(names))
