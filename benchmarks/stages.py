"""Records as they are measured: a benchmark that is interrupted keeps what it has."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, TypeVar

Record = dict[str, Any]
Progress = Callable[[float, str], None]
Stage = tuple[str, Callable[[], Iterable[Record]]]
Item = TypeVar("Item")


def run_stages(stages: Sequence[Stage], progress: Progress | None) -> Iterator[Record]:
    """The records of one stage after the other.

    >>> list(run_stages([("one", lambda: [{"runs": 1}]), ("two", lambda: [])], None))
    [{'runs': 1}]
    """
    for number, (name, stage) in enumerate(stages):
        if progress:
            progress(number / len(stages), name)
        yield from stage()


def tally(
    items: Iterable[Item], records: Callable[[list[Item]], Iterable[Record]]
) -> Iterator[Record]:
    """The records of all items, or of those that came before Ctrl-C, which then goes its way.

    >>> list(tally([1, 2], lambda items: [{"runs": len(items)}]))
    [{'runs': 2}]
    """
    found: list[Item] = []
    interruption: KeyboardInterrupt | None = None
    try:
        for item in items:
            found.append(item)
    except KeyboardInterrupt as caught:
        interruption = caught
    if found:
        yield from records(found)
    if interruption:
        raise interruption
