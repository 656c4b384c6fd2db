"""What a person says about candidates: small values that can be saved, read back and replayed.

Candidates are numbers that stay theirs for a whole evolution; a screen is the tuple of those shown
together.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
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
    """``candidate`` is the champion, until another is said to be better than it."""

    candidate: int


class Undo(NamedTuple):
    """The last event that still counts does not count any more."""


Event = Pick | Worst | Prefer | Stars | Reason | Lock | Edit | Keep | Undo
Judgement = Pick | Worst | Prefer | Stars | Keep
"""What says how much a layout is liked."""
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
    """The candidate a person likes best by what she said: the first picked or the last kept, until
    another is picked from a choice that holds it, preferred to it, or made of it by hand. A pick
    from the others, the second best of a screen, does not change it, unless it was called the
    worst before. Only what she says changes it.

    >>> champion_of([Pick(3, (1, 2, 3)), Pick(2, (1, 2))])
    3
    >>> champion_of([Keep(1), Pick(2, (1, 2, 4))])
    2
    """
    return _rank(events)[0]


def favourites_of(events: Iterable[Event]) -> tuple[int, ...]:
    """The candidates a person liked besides the champion, the last liked first: picked, kept, given
    the most stars, changed by hand or champions before, and not called the worst since.

    >>> favourites_of([Pick(3, (1, 2, 3)), Pick(2, (1, 2)), Stars(1, 5, 0), Worst(1, (1, 4))])
    (2,)
    """
    champion, liked = _rank(events)
    return tuple(number for number in reversed(liked) if number != champion)


def _rank(events: Iterable[Event]) -> tuple[int | None, list[int]]:
    """The champion, and all that is liked, the last last."""
    champion: int | None = None
    liked: list[int] = []
    for event in counting(events):
        before, champion = champion, _follow(champion, liked, event)
        new: list[int] = []
        gone: list[int] = []
        match event:
            case Keep(one) | Pick(one, _):
                new = [one]
            case Stars(one, stars, _) if stars == MOST_STARS:
                new = [one]
            case Edit(old, one):
                new, gone = [one], [old]
            case Worst(one, _):
                gone = [one]
        if before is not None and before != champion and before in liked:
            new.append(before)
        liked = [n for n in liked if n not in (*new, *gone)] + [n for n in new if n not in gone]
    return champion, liked


def _follow(champion: int | None, liked: Sequence[int], event: Event) -> int | None:
    """The champion after an event; one that is not ``liked`` any more was called the worst."""
    match event:
        case Keep(candidate):
            return candidate
        case Pick(best, among) if champion not in liked or champion in among:
            return best
        case Prefer(one, other) | Edit(other, one) if other == champion:
            return one
        case _:
            return champion


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
