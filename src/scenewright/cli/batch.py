"""``arrange --batch``: many files, a bar with the rate and the time left, a table at the end."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NamedTuple

import typer
from rich.console import Console

from scenewright.cli import tables, terminal
from scenewright.cli.progress import interrupts, tell_if_cold
from scenewright.core.errors import InputError
from scenewright.text import printable, quantity

if TYPE_CHECKING:
    from rich.progress import Progress

    from scenewright.batch import Cluster, ResultRow, Variation
    from scenewright.workflow.request import ArrangeRequest

BatchOption = Annotated[
    bool, typer.Option("--batch", help="Many files and folders into one folder, -o DIR.")
]
FormatOption = Annotated[
    str | None, typer.Option("--format", help="With --batch: suffixes, such as .json,.glb.")
]
JobsOption = Annotated[
    int | None, typer.Option(min=1, max=1024, help="With --batch: workers; one a core, if not.")
]
MemoryOption = Annotated[
    float | None, typer.Option(help="With --batch: GiB a worker may take (4).")
]
LimitOption = Annotated[
    float | None, typer.Option(help="With --batch: seconds a file may take (600).")
]
MOST = 25
"""Files listed one by one at the end."""


class BatchTerms(NamedTuple):
    """Options of batches alone: formats, workers, memory of each in GiB, seconds for a file, what
    is made of every plan, the manifest, and the cluster that works."""

    formats: str | None
    jobs: int | None
    memory: float | None
    limit: float | None
    variation: Variation | None = None
    manifest: str = ""
    cluster: Cluster | None = None


def check_single(sources: Sequence[str], terms: BatchTerms) -> None:
    """Refuse words that only a batch understands."""
    if len(sources) > 1:
        raise InputError(
            f"{len(sources)} inputs are given",
            "give each output with its own -o; for several inputs add --batch and -o FOLDER",
        )
    if any(term is not None for term in terms[:4]):
        raise InputError("--format, --jobs, --memory, --limit are of a batch", "add --batch")


def _is_name_of_file(path: Path) -> bool:
    """Whether there is a file of this name, or no folder and a suffix that can be written."""
    from scenewright.formats import formats, suffix_of

    written = {row.suffix for row in formats() if row.writer}
    return path.is_file() or (suffix_of(path) in written and not path.is_dir())


def run(
    sources: Sequence[str], request: ArrangeRequest, terms: BatchTerms, as_json: bool, quiet: bool
) -> int:
    """Lay out all files; the exit code: 0 all complete, 1 not all, 2 none could be used, 130
    interrupted."""
    from scenewright.batch import MEMORY, TIME, Cluster, Variation, batch

    if request.nets:
        raise InputError("--nets is of one run", 'name them as "nets" in the briefs of a batch')
    if len(request.outputs) != 1 or _is_name_of_file(request.outputs[0]):
        raise InputError("a batch writes into one folder", "give it with -o FOLDER")
    if request.alternatives > 1:
        raise InputError("--alternatives and --batch exclude each other", "give one of them")
    folder = request.outputs[0]
    formats = [f".{f.strip().removeprefix('.')}" for f in (terms.formats or ".json").split(",")]
    console = terminal.console(stderr=True, quiet=quiet)
    tell_if_cold(console)
    with interrupts() as interrupted, _bar(console) as watch:
        rows = batch(
            sources,
            folder,
            formats=formats,
            jobs=terms.jobs,
            preset=request.preset,
            solver=request.solver,
            seconds=request.seconds,
            steps=request.steps,
            seed=request.seed,
            keep=request.keep,
            catalogs=request.catalogs,
            groups=request.groups,
            accessible=request.accessible,
            scale=request.scale,
            hidden_levels=request.hidden_levels,
            style=request.style,
            layouts=request.layouts,
            map_options=request.map_options,
            clutter=request.clutter,
            memory=MEMORY if terms.memory is None else terms.memory,
            limit=TIME if terms.limit is None else terms.limit,
            variation=terms.variation or Variation(),
            manifest=terms.manifest,
            cluster=terms.cluster or Cluster(),
            progress=watch.on_row,
            cancel=lambda: bool(interrupted),
        )
    code = 130 if interrupted else _code(rows)
    if as_json:
        values = {"exit_code": code, "folder": str(folder), **_document(rows)}
        tables.print_json(values)
    elif not quiet:
        _tell(tables.output_console(), rows, folder, watch)
    else:
        sys.stderr.writelines(f"scenewright: {printable(line)}\n" for line in _failures(rows))
    if code == 130:
        state = f"interrupted after {len(rows)} of {watch.total or 'all'} files"
        sys.stderr.write(f"scenewright: {state}; run the same command again to continue\n")
    return code


def _code(rows: Sequence[ResultRow]) -> int:
    states = {row.status for row in rows}
    return 0 if states == {"complete"} else 2 if states == {"failed"} else 1


def _failures(rows: Sequence[ResultRow]) -> list[str]:
    """A line for each file that failed."""
    from scenewright.batch.table import FAILED

    return [f"{row.file}: {_without(row)}" for row in rows if row.status == FAILED]


def _document(rows: Sequence[ResultRow]) -> dict[str, object]:
    from scenewright.batch.table import totals

    return {"totals": totals(rows), "files": [row.listed() for row in rows]}


def _tell(console: Console, rows: Sequence[ResultRow], folder: Path, watch: BatchWatch) -> None:
    """The totals, the files that failed or break a rule, and where the full table is."""
    from scenewright.batch.table import CSV, FAILED, NOT_VALID, totals

    entries = [row for row in rows if row.status in (FAILED, NOT_VALID)]
    entries.sort(key=lambda row: row.status != FAILED)
    lines = [{"file": row.file, "status": row.status, "message": _without(row)} for row in entries]
    if lines:
        tables.table(console, lines[:MOST], title="files that need attention", whole=("file",))
    counted = [{"files": status, "": count} for status, count in totals(rows).items() if count]
    tables.table(console, counted, title="batch")
    rate = watch.made / max(watch.seconds(), 1e-9)
    words = [f"{quantity(len(rows), 'file')} in {folder}"]
    words += [f"{watch.made} in {watch.seconds():.0f} s, {rate:.1f} a second"] * bool(watch.made)
    words += [f"{watch.before} already done"] * bool(watch.before)
    words += [f"{len(entries) - MOST} more need attention"] * (len(entries) > MOST)
    words.append(f"full list: {folder / CSV}")
    tables.print_line(console, "; ".join(words), "dim")


def _without(row: ResultRow) -> str:
    """The message without the name of the file, which stands beside it."""
    return row.message.removeprefix(f"{row.file}: ")


class BatchWatch:
    """Moves a bar as rows come in and counts them: ``total`` files, some done
    ``before`` and others ``made`` now."""

    def __init__(self, bar: Progress) -> None:
        self.bar, self.total, self.made, self.before = bar, 0, 0, 0
        self.task = bar.add_task("files", total=None, rate="")
        self.begun = time.perf_counter()

    def seconds(self) -> float:
        """Since the start."""
        return time.perf_counter() - self.begun

    def on_row(self, _: ResultRow, done: int, total: int, before: bool) -> None:
        """A row has come."""
        self.total = total
        self.before, self.made = self.before + before, self.made + (not before)
        rate = f"{self.made / max(self.seconds(), 1e-9):.1f}/s" if self.made else ""
        self.bar.update(self.task, completed=done, total=total, rate=rate)


@contextmanager
def _bar(console: Console) -> Iterator[BatchWatch]:
    """A bar with count, rate and time left, if anyone is looking."""
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeRemainingColumn,
    )

    bar = Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.fields[rate]}", markup=False),
        TimeRemainingColumn(),
        console=console,
        transient=True,
        disable=console.quiet or not console.is_terminal,
    )
    with bar:
        yield BatchWatch(bar)
