"""SIGTERM and SIGHUP as an orderly end: temporary files are removed, then the process leaves."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


class Terminated(BaseException):
    """The process was asked to end; ``code`` is 128 plus the number of the signal."""

    def __init__(self, number: int) -> None:
        super().__init__(f"signal {number}")
        self.code = 128 + number


@contextmanager
def orderly_termination() -> Iterator[None]:
    """In the block the first SIGTERM or SIGHUP raises :class:`Terminated` in the main thread, and
    later ones do not disturb the cleaning up. Signals that are ignored stay so (``nohup``)."""
    named = (getattr(signal, name, None) for name in ("SIGTERM", "SIGHUP"))
    numbers = [n for n in named if n is not None and signal.getsignal(n) == signal.SIG_DFL]

    def end(number: int, _: FrameType | None) -> None:
        for other in numbers:
            signal.signal(other, signal.SIG_IGN)
        raise Terminated(number)

    try:
        for number in numbers:
            signal.signal(number, end)
    except ValueError:  # not the main thread: leave signals alone
        numbers = []
    try:
        yield
    finally:
        for number in numbers:
            signal.signal(number, signal.SIG_DFL)
