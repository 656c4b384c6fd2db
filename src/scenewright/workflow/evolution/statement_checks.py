"""Whether what a person says can be meant: about candidates that were shown, in known words."""

from __future__ import annotations

from collections.abc import Collection

from scenewright.core.errors import InputError
from scenewright.engine.preference.events import (
    MOST_STARS,
    Edit,
    Event,
    Keep,
    Lock,
    Pick,
    Prefer,
    Reason,
    Stars,
    Undo,
    Worst,
)


def check_said(event: Event, shown: Collection[int], reasons: Collection[str]) -> None:
    """InputError for an event about candidates that were not ``shown``, an unknown reason or an
    impossible number of stars.

    >>> check_said(Stars(3, 6, 0), {3}, ())
    Traceback (most recent call last):
    scenewright.core.errors.InputError: 6 stars are not possible; give 1 to 5
    """
    for number in candidates_in(event):
        if number not in shown:
            raise InputError(f"candidate {number} was not shown", "name one that was")
    match event:
        case Pick(best, among) | Worst(best, among) if best not in among or len(among) < 2:
            raise InputError(f"candidate {best} has nothing to be compared with", "name another")
        case Prefer(one, other) if one == other:
            raise InputError("a candidate is not better than itself", "name two")
        case Stars(_, stars, _) if not 1 <= stars <= MOST_STARS:
            raise InputError(f"{stars} stars are not possible", f"give 1 to {MOST_STARS}")
        case Reason(_, reason) if reason not in reasons:
            known = ", ".join(reasons) or "none: this kind of scene has no reasons"
            raise InputError(f"unknown reason '{reason}'", f"use one of: {known}")
        case _:
            pass


def candidates_in(event: Event) -> set[int]:
    """The candidates an event speaks of, that must have been shown before.

    >>> sorted(candidates_in(Pick(3, (1, 3))))
    [1, 3]
    """
    match event:
        case Pick(one, among) | Worst(one, among):
            return {one, *among}
        case Prefer(one, other):
            return {one, other}
        case Keep(one) | Stars(one, _, _) | Reason(one, _) | Edit(one, _):
            return {one}
        case Lock() | Undo():
            return set()
