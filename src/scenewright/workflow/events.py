"""What a run tells while it works, in the order in which it happens."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import closing
from pathlib import Path
from typing import NamedTuple, TypeVar

from scenewright.core.brief import Brief
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.solution import Solution
from scenewright.domains.contract import Domain

T = TypeVar("T")


class Planned(NamedTuple):
    """The brief is read, and can be built: its plan, and its domain."""

    brief: Brief
    plan: Plan
    domain: Domain


class Progress(NamedTuple):
    """The share done, 0 to 1, and what is being done."""

    share: float
    what: str


class Changed(NamedTuple):
    """A layout was changed after the search of its space: at which stage (``fit``, ``routes``,
    ``repair``), or that something is ``left out``, and the reason."""

    space: str
    stage: str
    reason: str


class Solved(NamedTuple):
    """A solution is found."""

    solution: Solution


class Judged(NamedTuple):
    """The referee has judged the solution found last."""

    report: Report


class Wrote(NamedTuple):
    """A file has appeared under its name."""

    path: Path


class Notice(NamedTuple):
    """Something the user should know that is no fault."""

    text: str


Event = Planned | Progress | Changed | Solved | Judged | Wrote | Notice
Hear = Callable[[Event], None]


def run_to_end(events: Generator[Event, None, T], hear: Hear | None = None) -> T:
    """What a run returns at its end; ``hear`` is called with each of its events. Whatever ends
    the run early closes it first, so that nothing is left half done.

    >>> def count():
    ...     yield Notice("one")
    ...     yield Notice("two")
    ...     return 2
    >>> run_to_end(count(), lambda event: print(event.text))
    one
    two
    2
    """
    with closing(events):
        while True:
            try:
                event = next(events)
            except StopIteration as end:
                result: T = end.value
                return result
            if hear is not None:
                hear(event)
