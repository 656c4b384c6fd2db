"""What is asked for of a home, judged before anything is solved: known, possible, not both wanted
and forbidden."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from difflib import get_close_matches

import numpy as np
from numpy.typing import NDArray

from scenewright.building.plan import place
from scenewright.catalog.kinds import KINDS
from scenewright.catalog.suggestions import suggest_kinds
from scenewright.core.brief import Brief, Room
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.domains.home.cases.library import Library, cases, subset
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.measures import ROUNDING
from scenewright.domains.home.wished.wishes import groups_of, list_groups_barred_by


def check_asks(brief: Brief) -> None:
    """Every group that is asked for is known."""
    for number, room in enumerate(brief.rooms):
        for k, ask in enumerate(room.ask or ()):
            if ask.group not in GROUPS:
                raise InputError(
                    f"unknown furniture group '{ask.group}'",
                    _offer_groups(ask.group),
                    place=place(brief, number, f"ask[{k}]"),
                )


def _offer_groups(name: str) -> str:
    """What to write instead of a name that is no group: those spelt like it, or that hold what it
    names, else all.

    >>> _offer_groups("couch")
    'use one of: seating'
    """
    kinds = (name, *suggest_kinds(name, KINDS))
    held = dict.fromkeys(group for kind in kinds for group in groups_of(kind))
    near = get_close_matches(name, GROUPS, 2) or list(held)[:4] or list(GROUPS)
    return f"use one of: {', '.join(near)}"


def check_possible(brief: Brief, libraries: Sequence[Library]) -> None:
    """No room, furnished from its library, wants what it forbids, or asks for a group smaller than
    any there is."""
    for number, (room, library) in enumerate(zip(brief.rooms, libraries, strict=True)):
        _check_wanted(brief, number, room, library)
        _check_sizes(brief, number, room, library)


def limit_sizes(library: Library, room: Room) -> Library:
    """A library whose groups are no larger than a room asks for, where it says so; of several
    sizes for one group any will do."""
    asked: dict[str, list[tuple[float, float] | None]] = {}
    for ask in room.ask or ():
        asked.setdefault(ask.group, []).append(ask.size)
    own = dict(library.own)
    for group, sizes in asked.items():
        known = cases(group, library)
        limits = [size for size in sizes if size is not None]
        if not limits or len(limits) < len(sizes):
            continue
        fits = np.logical_or.reduce([_within(known.sizes, size) for size in limits])
        if fits.any() and not fits.all():
            own[group] = subset(known, fits)
    return library if own == library.own else library._replace(own=own)


def _within(sizes: NDArray[np.float64], most: tuple[float, float]) -> NDArray[np.bool_]:
    return np.asarray((sizes <= np.array(most) + ROUNDING).all(-1))


def _check_sizes(brief: Brief, number: int, room: Room, library: Library) -> None:
    for k, ask in enumerate(room.ask or ()):
        known = cases(ask.group, library)
        if ask.size is None or _within(known.sizes, ask.size).any():
            continue
        width, depth = np.ceil(known.sizes[known.smallest] * 100 - ROUNDING) / 100
        raise InputError(
            f"no {ask.group} is as small as {ask.size[0]:g} x {ask.size[1]:g} m; "
            f"the smallest is {width:.2f} x {depth:.2f} m",
            'give at least that, or leave "size" out',
            place=place(brief, number, f"ask[{k}]"),
        )


def _check_wanted(brief: Brief, number: int, room: Room, library: Library) -> None:
    out = [
        (k, wish.what, list_groups_barred_by(wish.what, library))
        for k, wish in enumerate(room.wishes)
        if wish.forbid
    ]
    every = {group for _, _, groups in out for group in groups}
    for where, what in _list_requests(room):
        needed = groups_of(what)
        for k, forbidden, groups in out:
            if forbidden == what or (every.issuperset(needed) and groups.intersection(needed)):
                raise InputError(
                    f"{where} wants '{what}', but wishes[{k}] forbids '{forbidden}'",
                    "leave one of them out",
                    place=place(brief, number),
                )


def _list_requests(room: Room) -> Iterator[tuple[str, str]]:
    """What is wanted in a room, with its place in the brief."""
    for k, ask in enumerate(room.ask or ()):
        yield f"ask[{k}]", ask.group
    for k, wish in enumerate(room.wishes):
        if not wish.forbid:
            yield f"wishes[{k}]", wish.what


def check_plain(brief: Brief, plan: Plan) -> None:
    """InputError where a room of a home has what only halls have."""
    for number, room in enumerate(brief.rooms[: len(plan.spaces)]):
        for key in ("zones", "links", "demands"):
            if getattr(room, key):
                raise InputError(
                    f"has {key}, which only halls have",
                    f'set "domain": "hall" in the brief, or leave out {key}',
                    place=place(brief, number),
                )
