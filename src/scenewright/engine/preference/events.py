"""What a person says about candidates: small values that can be saved, read back and replayed.

Candidates are numbers that stay theirs for a whole evolution; a screen is the tuple of those shown
together.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

from scenewright.core.errors import InputError


class Pick(NamedTuple):
    """``best`` is the best of those shown ``among`` which it is."""

    best: int
    among: tuple[int, ...]


class Worst(NamedTuple):
    """``worst`` is the worst of those shown ``among`` which it is."""

    worst: int
    among: tuple[int, ...]


class Prefer(NamedTuple):
    """``one`` is better than ``other``."""

    one: int
    other: int


class Stars(NamedTuple):
    """A rating of 1 to 5 stars, given on a screen; how strict a person is may drift from screen to
    screen."""

    candidate: int
    stars: int
    screen: int


class Reason(NamedTuple):
    """What a candidate lacks: one of the reasons that a domain knows, such as ``too dense``."""

    candidate: int
    reason: str


class Lock(NamedTuple):
    """A piece or group of the champion that is to stay where it stands."""

    name: str


class Edit(NamedTuple):
    """A candidate changed by hand: ``after`` took the place of ``before`` and is better."""

    before: int
    after: int


class Keep(NamedTuple):
    """``candidate`` is the champion until another is kept, whatever is picked meanwhile."""

    candidate: int


class Undo(NamedTuple):
    """The last event that still counts does not count any more."""


Event = Pick | Worst | Prefer | Stars | Reason | Lock | Edit | Keep | Undo
KINDS: dict[str, Any] = {
    kind.__name__.lower(): kind
    for kind in (Pick, Worst, Prefer, Stars, Reason, Lock, Edit, Keep, Undo)
}
"""Every kind of event by the word it is saved under."""
MOST_STARS = 5


def counting(events: Iterable[Event]) -> tuple[Event, ...]:
    """The events that count: each :class:`Undo` takes back the last one before it that does.

    >>> counting([Pick(3, (1, 2, 3)), Keep(3), Undo(), Lock("church")])
    (Pick(best=3, among=(1, 2, 3)), Lock(name='church'))
    """
    kept: list[Event] = []
    for event in events:
        if not isinstance(event, Undo):
            kept.append(event)
        elif kept:
            kept.pop()
    return tuple(kept)


def champion_of(events: Iterable[Event]) -> int | None:
    """The candidate a person has chosen: the last kept; while none is, the last picked. Only what
    she says changes it.

    >>> champion_of([Pick(3, (1, 3)), Keep(1), Pick(2, (2, 4))])
    1
    """
    picked: int | None = None
    kept: int | None = None
    for event in counting(events):
        if isinstance(event, Pick):
            picked = event.best
        elif isinstance(event, Keep):
            kept = event.candidate
        elif isinstance(event, Edit) and event.before == (picked if kept is None else kept):
            picked, kept = event.after, None if kept is None else event.after
    return picked if kept is None else kept


def record_of(event: Event) -> dict[str, Any]:
    """An event as plain values, ready for JSON.

    >>> record_of(Stars(4, 5, 0))
    {'event': 'stars', 'candidate': 4, 'stars': 5, 'screen': 0}
    """
    return {"event": type(event).__name__.lower(), **event._asdict()}


def event_of(record: dict[str, Any]) -> Event:
    """The event a record holds; InputError for what is none.

    >>> event_of({"event": "prefer", "one": 2, "other": 7})
    Prefer(one=2, other=7)
    """
    kind = KINDS.get(str(record.get("event")))
    given = {key: value for key, value in record.items() if key != "event"}
    if kind is None or set(given) != set(kind._fields):
        raise InputError(f"is not an event: {str(record)[:80]}", f"events are {', '.join(KINDS)}")
    shaped = {k: tuple(v) if isinstance(v, list) else v for k, v in given.items()}
    for name, value in shaped.items():
        wanted = str if name in ("name", "reason") else tuple if name == "among" else int
        if not isinstance(value, wanted) or isinstance(value, bool):
            raise InputError(
                f"is not an event: {name} is {str(value)[:40]!r}", "undo and say it anew"
            )
    event: Event = kind(**shaped)
    return event
