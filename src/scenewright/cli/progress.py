"""Progress: a bar after the first second, a message while compiling, and Ctrl-C that keeps the
best so far."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from threading import Timer
from types import FrameType
from typing import TYPE_CHECKING, NamedTuple

from rich.console import Console

from scenewright.text import printable, quantity

if TYPE_CHECKING:
    from rich.progress import Progress

PATIENCE = 1.0
"""Seconds before a bar appears."""
SPEAKING = 15.0
"""Seconds between lines of progress where there is no terminal, but a log."""


class SolverWatch(NamedTuple):
    """Callbacks for a solver: tell the fraction done, ask whether to stop."""

    progress: Callable[[float, str], None]
    cancelled: Callable[[], bool]


@contextmanager
def watching(
    console: Console, quiet: bool = False, stoppable: bool = True
) -> Iterator[SolverWatch]:
    """A bar on ``console`` if the work takes over a second; the first Ctrl-C asks it to stop, if
    it is ``stoppable``, else it ends it."""
    with ExitStack() as stack:
        progress = stack.enter_context(show_progress(console, quiet))
        interrupted = stack.enter_context(interrupts()) if stoppable else []
        yield SolverWatch(progress, lambda: bool(interrupted))


@contextmanager
def show_progress(console: Console, quiet: bool = False) -> Iterator[Callable[[float, str], None]]:
    """A bar on ``console`` if the work takes over a second, or a line now and then where it is no
    terminal; Ctrl-C interrupts the work at once."""
    with _bar(console, quiet) as bar:
        task = bar.add_task("starting", total=1.0)
        said = [time.monotonic()]

        def progress(fraction: float, message: str = "") -> None:
            text = printable(message)[:40]
            if not console.is_terminal and time.monotonic() - said[0] > SPEAKING:
                said[0] = time.monotonic()
                line = f"{100 * min(max(fraction, 0.0), 1.0):.0f} % done: {text}"
                console.print(line, style="dim", markup=False, highlight=False)
            bar.update(task, completed=min(max(fraction, 0.0), 1.0), description=text)

        def describe(message: str) -> None:
            bar.update(task, description=message)

        with compiling_noticed(console, describe):
            yield progress


@contextmanager
def _bar(console: Console, quiet: bool) -> Iterator[Progress]:
    """A progress bar that appears after :data:`PATIENCE` seconds, if anyone is looking."""
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeElapsedColumn

    bar = Progress(
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        TaskProgressColumn(),
        TimeElapsedColumn(),
        console=console,
        transient=True,
        disable=quiet or not console.is_terminal,
    )
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
            (before if callable(before) else signal.default_int_handler)(number, frame)
        seen.append(number)

    before = signal.getsignal(signal.SIGINT)
    try:
        signal.signal(signal.SIGINT, note)
    except ValueError:  # not the main thread: leave interrupts alone
        yield seen
        return
    try:
        yield seen
    finally:
        signal.signal(signal.SIGINT, before)


def tell_if_cold(console: Console) -> None:
    """Say once that the first run compiles; see :mod:`scenewright.geometry.compiled`. For work
    in other processes, which cannot be noticed while it is done."""
    from scenewright.geometry.compiled import is_cold

    if is_cold():
        console.print("compiling, first run only; see scenewright warm", style="dim")


@contextmanager
def compiling_noticed(console: Console, bar: Callable[[str], None] | None = None) -> Iterator[None]:
    """Say when something is compiled in the block, and how long that took; ``bar`` gets how
    far it is."""
    from scenewright.geometry.compile_clock import CompileClock, compile_clock

    def began(clock: CompileClock) -> None:
        if not clock.kernels:
            console.print("compiling, first run only", style="dim")
        if bar is not None:
            bar(f"compiling, part {clock.kernels + 1}")

    with compile_clock(began) as clock:
        yield
    if clock.kernels:
        parts = quantity(clock.kernels, "part")
        console.print(f"compiled {parts} in {clock.seconds:.1f} s", style="dim", highlight=False)
