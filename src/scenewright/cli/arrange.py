"""The verb ``arrange``: read, solve, judge, and write every file or none."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import NamedTuple

from rich.console import Console

from scenewright.brief import ROUTE_WIDTHS, Brief
from scenewright.check import Report, check
from scenewright.cli.progress import Watch, tell_if_cold, watching
from scenewright.errors import InputError
from scenewright.solution import Solution

HEAVY = 50_000
"""Faces of a model above which it is told."""
SWEET_HOME = (".sh3d", ".xml")


class Request(NamedTuple):
    """What the command line asks for."""

    source: str
    outputs: tuple[Path, ...]
    preset: str
    solver: str | None
    seconds: float | None
    steps: int | None
    seed: int
    keep: bool
    alternatives: int = 1
    catalogs: tuple[str, ...] = ()
    groups: tuple[str, ...] = ()
    accessible: bool = False


class Arranged(NamedTuple):
    """What came of it; ``interrupted`` if Ctrl-C ended the search early."""

    solution: Solution
    report: Report
    interrupted: bool


def arrange(request: Request, console: Console) -> Arranged:
    """Solve the request, write its outputs, and return the solution with the referee's report.

    Interrupted before anything was found it raises ``KeyboardInterrupt`` and writes nothing.
    """
    from scenewright import domains

    brief = prepared(request, console)
    with watching(console, console.quiet) as watch:
        try:
            solution = domains.solve(
                brief, preset=request.preset, solver=request.solver, seconds=request.seconds,
                steps=request.steps, seed=request.seed, progress=watch.progress,
                cancel=watch.cancelled,
            )  # fmt: skip
        except InputError as error:
            raise error.located(file=str(request.source)) from None
        interrupted = watch.cancelled()
        if interrupted and not solution.evaluations:
            raise KeyboardInterrupt
        report = check(solution)
        write_together(solution, request.outputs, watch)
    _tell_heavy(solution, console)
    return Arranged(solution, report, interrupted)


def _tell_heavy(solution: Solution, console: Console) -> None:
    """Name the user's models in use that have more than :data:`HEAVY` faces."""
    from scenewright.stock import OWN, catalog_of

    catalog = catalog_of(solution.brief.catalogs)
    for name in sorted({piece.asset for piece in solution.pieces if piece.asset.startswith(OWN)}):
        asset = catalog.assets.get(name)
        faces = sum(len(part.faces) for part in asset.mesh(asset.usual)) if asset else 0
        if faces > HEAVY:
            told = f"{name} has {faces:,} faces: files with it are large"
            console.print(told, style="dim", markup=False)


def prepared(request: Request, console: Console) -> Brief:
    """The brief of a request whose outputs and names can be used."""
    from scenewright import domains, formats

    check_outputs(request.outputs)
    brief = formats.read(
        request.source, keep=request.keep, catalogs=request.catalogs, groups=request.groups
    )
    formats.check_kept(request.source, request.outputs)
    for path in request.outputs:
        formats.writer(path, brief.domain)
    if request.accessible:
        brief = made_accessible(brief)
    named("preset", request.preset, domains.presets(brief.domain))
    if request.solver is not None:
        named("solver", request.solver, domains.solvers(brief.domain))
    if request.keep and not _keeps(request.source, brief):
        console.print("--keep has no effect: the file holds no furniture to keep", style="dim")
    tell_if_cold(console)
    return brief


def made_accessible(brief: Brief) -> Brief:
    """The brief of a home with room for wheelchairs and routes of at least 0.9 m."""
    if brief.domain != "home":
        raise InputError("--accessible is for homes", "leave it out; halls have room to turn told")
    width = max(brief.route_width, ROUTE_WIDTHS["hall"])
    return brief.model_copy(update={"accessible": True, "route_width": width})


def check_outputs(outputs: Sequence[Path]) -> None:
    """Every suffix can be written and no file is named twice."""
    from scenewright import formats

    seen = set()
    for path in outputs:
        formats.writer(path)
        if path.resolve() in seen:
            raise InputError("is given twice", "give each -o another name", file=str(path))
        seen.add(path.resolve())


def _keeps(source: str, brief: Brief) -> bool:
    """Whether there is something that stays because of ``--keep``."""
    return Path(source).suffix.lower() in SWEET_HOME and any(r.fixed for r in brief.rooms)


def write_together(solution: Solution, outputs: Sequence[Path], watch: Watch) -> None:
    """Write all files under temporary names, two at a time, then rename them all: either all
    appear or none."""

    def written(path: Path, part: Path) -> None:
        watch.progress(1.0, f"writing {path.name}")
        _write(solution, part, path)

    with _temporary(outputs) as parts:
        with ThreadPoolExecutor(2) as pool:
            list(pool.map(written, outputs, parts))
        for path, part in zip(outputs, parts, strict=True):
            _rename(part, path)


@contextmanager
def _temporary(outputs: Sequence[Path]) -> Iterator[list[Path]]:
    """Names beside the outputs with the same suffixes; what is left of them is removed."""
    parts = [path.with_name(f".{os.getpid()}-{i}-{path.name}") for i, path in enumerate(outputs)]
    try:
        yield parts
    finally:
        for part in parts:
            with suppress(OSError):
                part.unlink()


def _write(solution: Solution, part: Path, path: Path) -> None:
    """Write to ``part``; a fault names ``path``, which the user knows."""
    from scenewright import formats

    try:
        formats.write(solution, part)
    except InputError as error:
        raise InputError(error.fault, error.remedy, file=str(path)) from None


def _rename(part: Path, path: Path) -> None:
    try:
        os.replace(part, path)
    except OSError as error:
        raise InputError(
            f"cannot be written: {error.strerror}", "choose another place", file=str(path)
        ) from None


def named(what: str, name: str, known: Collection[str]) -> None:
    """Raise :class:`InputError` naming the choices unless ``name`` is one of them.

    >>> named("preset", "papper", ["default", "paper"])
    Traceback (most recent call last):
    scenewright.errors.InputError: there is no preset 'papper'; use one of: default, paper
    """
    if name not in known:
        raise InputError(f"there is no {what} '{name}'", f"use one of: {', '.join(known)}")
