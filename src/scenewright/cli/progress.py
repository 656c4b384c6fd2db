"""What a person sees while waiting: a bar after the first second, a word about compiling, and
Ctrl-C that keeps the best so far."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Timer
from types import FrameType
from typing import NamedTuple

from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeElapsedColumn

PATIENCE = 1.0
"""Seconds before a bar appears."""


class Watch(NamedTuple):
    """Callbacks for a solver: tell the fraction done, ask whether to stop."""

    progress: Callable[[float, str], None]
    cancelled: Callable[[], bool]


@contextmanager
def watching(console: Console, quiet: bool = False) -> Iterator[Watch]:
    """A bar on ``console`` if the work takes over a second; the first Ctrl-C asks it to stop."""
    with _bar(console, quiet) as bar, interrupts() as interrupted:
        task = bar.add_task("starting", total=1.0)

        def progress(fraction: float, message: str = "") -> None:
            bar.update(task, completed=min(max(fraction, 0.0), 1.0), description=message[:40])

        yield Watch(progress, lambda: bool(interrupted))


@contextmanager
def _bar(console: Console, quiet: bool) -> Iterator[Progress]:
    """A progress bar that appears after :data:`PATIENCE` seconds, if anyone is looking."""
    bar = Progress(
        TextColumn("{task.description}", markup=False), BarColumn(), TaskProgressColumn(),
        TimeElapsedColumn(), console=console, transient=True,
        disable=quiet or not console.is_terminal,
    )  # fmt: skip
    timer = Timer(PATIENCE, bar.start)
    timer.start()
    try:
        yield bar
    finally:
        timer.cancel()
        timer.join()
        bar.stop()


@contextmanager
def interrupts() -> Iterator[list[int]]:
    """Counts Ctrl-C in a list; the second one interrupts for good."""
    seen: list[int] = []

    def note(number: int, frame: FrameType | None) -> None:
        if seen:
            signal.default_int_handler(number, frame)
        seen.append(number)

    try:
        before = signal.signal(signal.SIGINT, note)
    except ValueError:  # not the main thread: leave interrupts alone
        yield seen
        return
    try:
        yield seen
    finally:
        signal.signal(signal.SIGINT, before)


def tell_if_cold(console: Console) -> None:
    """Say once that the first run compiles; see :mod:`scenewright.geometry.compiled`."""
    from scenewright.geometry.compiled import is_cold

    if is_cold():
        console.print("compiling, first run only (up to a minute on a slow machine)", style="dim")
