"""Notice when kernels are compiled, and how long it takes."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from numba.core.event import Event, Listener, install_listener


class CompileClock(Listener):
    """Counts the kernels that are compiled and the seconds this takes.

    ``began`` is called whenever one is begun; what a kernel compiles on its way is a part of it.
    Compiling holds a lock, so that no two threads are in here at once.
    """

    def __init__(self, began: Callable[[CompileClock], None]) -> None:
        self.kernels = 0
        self.seconds = 0.0
        self._began = began
        self._depth = 0
        self._start = 0.0

    def on_start(self, event: Event) -> None:  # noqa: ARG002
        """A function is begun."""
        self._depth += 1
        if self._depth == 1:
            self._start = time.perf_counter()
            self._began(self)

    def on_end(self, event: Event) -> None:  # noqa: ARG002
        """A function is done."""
        self._depth -= 1
        if self._depth == 0:
            self.kernels += 1
            self.seconds += time.perf_counter() - self._start


def ignore(clock: CompileClock) -> Any:
    """Do nothing when a kernel is begun."""


@contextmanager
def compile_clock(began: Callable[[CompileClock], None] = ignore) -> Iterator[CompileClock]:
    """A clock of what is compiled in the block.

    >>> with compile_clock() as clock:
    ...     pass
    >>> clock.kernels, clock.seconds
    (0, 0.0)
    """
    clock = CompileClock(began)
    with install_listener("numba:compile", clock):
        yield clock
