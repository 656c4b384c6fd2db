"""A limit of processor time for what must not hang."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager

HANGS = 60
"""Seconds of the processor after which a loop without end is assumed; no measure of speed."""


@contextmanager
def within(seconds: int) -> Iterator[None]:
    """Fail if this process computes for longer, however busy the machine is."""

    def late(*_: object) -> None:
        raise AssertionError(f"takes more than {seconds} s")

    before = signal.signal(signal.SIGPROF, late)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
