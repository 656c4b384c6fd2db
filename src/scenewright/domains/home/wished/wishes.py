"""What a household wishes for in a room: kept out, added to the programme, drawn to a place.

Forbidden things are taken out of the programme and of the case library, so they cannot appear.
Places are soft: they weigh in the search as daylight, corners and relations between groups do.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from math import inf

import numpy as np
from numpy.typing import NDArray

from scenewright.building.plan import place
from scenewright.catalog.kinds import name_of
from scenewright.catalog.suggestions import suggest_kinds
from scenewright.core.brief import Brief, Room
from scenewright.core.brief.wishes import OPENINGS, WishBrief
from scenewright.core.catalog import Catalog, Group, Member
from scenewright.core.errors import InputError
from scenewright.core.solution import LeftOut
from scenewright.domains.home.cases.library import Library, cases, index_cases
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.problem import Items
from scenewright.domains.home.programme import Attraction, PlacementPreference, Wish
from scenewright.domains.home.wished.places import BACKWARD, list_attractions

Floats = NDArray[np.float64]

DAYLIGHT = 12.0  # how much a group wants a window that is wished at one (a desk of itself: 1)
CORNER = 6.0  # how much it wants a corner (a wardrobe of itself: 1)
NEAR = 4.0  # weight of the relation to what it is to be near (sofa and television: 3)
MAIN = {"media": "tv"}  # what a group is for though another piece makes its place
BY = {"door": 0.8, "wall": 0.02}  # how near to a door or wall is by it, metres
PASSING = 0.1  # between two groups that are near each other, side by side, metres


def check_wishes(brief: Brief, catalog: Catalog) -> None:
    """Every name in a wish is that of a group or of a kind some group holds."""
    known = [*GROUPS, *(c for c in catalog.kinds if c not in GROUPS)]
    for number, room in enumerate(brief.rooms):
        for k, wish in enumerate(room.wishes):
            named = {"what": wish.what, "near": wish.near}
            others = {"face": wish.face, "away_from": wish.away_from}
            named |= {key: name for key, name in others.items() if name not in OPENINGS}
            for key, name in named.items():
                if name is not None and name not in known:
                    near = get_close_matches(name, GROUPS, 2, 0.75)
                    near = near or suggest_kinds(name, catalog.kinds)
                    offered = f"use one of: {', '.join(near)}" if near else ""
                    raise InputError(
                        f"unknown furniture group or kind of piece '{name}'",
                        offered or "see: scenewright list groups",
                        place=place(brief, number, f"wishes[{k}].{key}"),
                    )
            if not wish.forbid and not groups_of(wish.what):
                raise InputError(
                    f"no furniture group holds a {name_of(wish.what)}",
                    'put it among the room\'s "fixed" items, or wish for a group: '
                    "scenewright list groups",
                    place=place(brief, number, f"wishes[{k}]"),
                )


def groups_of(name: str) -> tuple[str, ...]:
    """The groups that a name means: its own, those it makes, else those that may hold it."""
    if name in GROUPS:
        return (name,)
    made = tuple(g for g, kind in GROUPS.items() if name in kind.essential)
    return made or tuple(g for g in GROUPS if any(_holds(c, name) for c in cases(g).groups))


def _holds(case: Group, category: str) -> bool:
    return any(member.category == category for member in case.members)


def restrict_library(library: Library, room: Room) -> Library:
    """A library without what is forbidden in a room, and with what is wanted where cases differ
    in it."""
    own = dict(library.own)
    for wish in room.wishes:
        if wish.what in GROUPS:
            continue
        for group in groups_of(wish.what):
            known = own[group].groups if group in own else cases(group, library).groups
            if wish.forbid:
                left = tuple(c for case in known if (c := _without(case, wish.what)) is not None)
            else:
                left = tuple(case for case in known if _holds(case, wish.what))
            if left and left != known:
                own[group] = index_cases(left)
    return library if own == library.own else library._replace(own=own)


def _without(case: Group, category: str) -> Group | None:
    """A case less the members of a category and what is on them; None if it cannot do
    without."""
    if not _holds(case, category):
        return case
    if category == MAIN.get(case.function) or category in GROUPS[case.function].essential:
        return None
    kept: dict[int, int] = {}
    members: list[Member] = []
    for i, member in enumerate(case.members):
        if member.category != category and (member.on < 0 or member.on in kept):
            kept[i] = len(members)
            members.append(member._replace(on=kept.get(member.on, -1)))
    return case._replace(members=tuple(members))


def list_barred_groups(room: Room, library: Library) -> frozenset[str]:
    """The groups that cannot stand in a room because of what is forbidden there."""
    return frozenset(
        g for w in room.wishes if w.forbid for g in list_groups_barred_by(w.what, library)
    )


def list_groups_barred_by(what: str, library: Library) -> frozenset[str]:
    """The groups that cannot stand where a group or kind of piece is forbidden."""
    if what in GROUPS:
        return frozenset((what,))
    return frozenset(
        g
        for g in groups_of(what)
        if all(_without(c, what) is None for c in cases(g, library).groups)
    )


def apply_wishes(
    wishes: Sequence[Wish], room: Room, library: Library, there: frozenset[str] = frozenset()
) -> tuple[Wish, ...]:
    """A room's programme with the household's wishes: less what is barred, with what is wanted and
    not ``there`` already (groups and kinds of pieces), each drawn to its place."""
    out = list_barred_groups(room, library)
    found = [wish for wish in wishes if wish.group not in out]
    for asked in (w for w in room.wishes if not w.forbid):
        groups = groups_of(asked.what)
        if not any(wish.group in groups for wish in found):
            if there.intersection((asked.what, *groups)):
                continue
            found.append(Wish(groups[0], 0 if asked.required else 1, required=asked.required))
        number = next(i for i, wish in enumerate(found) if wish.group in groups)
        rank = 0 if asked.required else found[number].rank
        found[number] = found[number]._replace(
            sway=_sway(found[number].sway, asked),
            rank=rank,
            required=asked.required or found[number].required,
        )
    return tuple(sorted(found, key=lambda w: (w.rank, not w.core)))


def list_substitutes(
    room: Room, space: str, placed: Iterable[str], listed: Iterable[str]
) -> list[LeftOut]:
    """What is required and has only something else of its use in its place; ``placed`` are the
    functions of groups, ``listed`` those that are listed as left out."""
    known = {*placed, *listed}
    return [
        LeftOut(space, groups[0], "only something smaller of its use fits", True)
        for wish in room.wishes
        if wish.required and not known.intersection(groups := groups_of(wish.what))
    ]


def _sway(sway: PlacementPreference, asked: WishBrief) -> PlacementPreference:
    draws = (draw for draw in _draws(asked) if draw not in sway.draws)
    return PlacementPreference(
        DAYLIGHT if asked.by == "window" else sway.daylight,
        CORNER if asked.by == "corner" else sway.corner,
        (*sway.draws, *draws),
    )


def _draws(asked: WishBrief) -> Iterable[Attraction]:
    """What draws a wished group or keeps it away, as parts of the room and other groups."""
    if asked.by in BY:
        yield Attraction((asked.by,), far=BY[asked.by])
    if asked.near:
        yield Attraction((asked.near, *groups_of(asked.near)), far=asked.within)
    for name, draw in (
        (asked.face, Attraction((), facing=1.0)),
        (asked.away_from, Attraction((), near=asked.beyond)),
    ):
        if name:
            meant = (name,) if name in OPENINGS else (name, *groups_of(name))
            yield draw._replace(to=meant)


def apply_preferences(items: Items, wishes: Sequence[Wish]) -> Items:
    """Items drawn to the places wished for."""
    if not any(wish.sway != PlacementPreference() for wish in wishes):
        return items
    daylight = np.maximum(items.daylight, [w.sway.daylight for w in wishes])
    nestle = np.maximum(items.nestle, [w.sway.corner for w in wishes])
    drawn = list(_between(wishes))
    pairs = [(i, j) for i, j, _ in drawn]
    targets = [_target(draw, wishes[i].group, items.wish[i], items.wish[j]) for i, j, draw in drawn]
    return items._replace(
        daylight=daylight,
        nestle=nestle,
        pairs=np.concatenate([items.pairs, np.array(pairs, np.int64).reshape(-1, 2)]),
        pair_targets=np.concatenate(
            [items.pair_targets, np.array(targets, np.float64).reshape(-1, 3)]
        ),
        pair_weights=np.concatenate([items.pair_weights, np.full(len(pairs), NEAR)]),
    )


def _target(draw: Attraction, group: str, own: Floats, other: Floats) -> tuple[float, float, float]:
    """What a draw to another group means for the relation of both, of their wished sizes (2,):
    side by side, apart (below zero: at least so far), or looking at it."""
    nan = float("nan")
    if draw.far < inf:
        return float(own[0] + other[0]) / 2 + PASSING, nan, nan
    apart = draw.near + float(own.mean() + other.mean()) / 2
    ahead = np.pi if group in BACKWARD else 0.0
    return -apart if draw.near else nan, nan, ahead if draw.facing else nan


def _between(wishes: Sequence[Wish]) -> Iterable[tuple[int, int, Attraction]]:
    """The wishes that draw a group to another, keep it away or have it look there."""
    for i, wish in enumerate(wishes):
        for draw in list_attractions(wish):
            others = [j for j, w in enumerate(wishes) if j != i and w.group in draw.to]
            if others:
                yield i, others[0], draw
