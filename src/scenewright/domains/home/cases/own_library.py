"""The case library of a brief: shipped or learned cases, with the furniture of its catalogues."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

from scenewright.core.brief import Brief, Room
from scenewright.core.catalog import Catalog, Group
from scenewright.domains.home.cases.furnishing import Taste, anchor_of, stock_of, substitute_models
from scenewright.domains.home.cases.library import SHIPPED, Library, index_cases, shipped_cases
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.learned.groups import Known, read
from scenewright.domains.home.learned.habits import habits_of

Learned = tuple[tuple[Known, bool], ...]
"""Files of learned groups, and whether each is used beside the shipped ones."""


def taste_of(brief: Brief, room: Room) -> Taste:
    """What is wished for in a room: its own words, else the home's."""
    return Taste(room.style or brief.style, room.colour or brief.colour)


def libraries_of(brief: Brief, catalog: Catalog) -> dict[Taste, Library]:
    """The case library of each taste there is in a home."""
    learned = tuple(
        (read(Path(entry)), False)
        if isinstance(entry, str)
        else (read(Path(entry.path)), entry.beside)
        for entry in brief.groups
    )
    tastes = {taste_of(brief, room) for room in brief.rooms}
    return {taste: library_of(catalog, taste, learned) for taste in tastes}


@lru_cache(maxsize=32)
def library_of(catalog: Catalog, taste: Taste, learned: Learned = ()) -> Library:
    """The shipped cases, or learned ones in their place or beside them, with the furniture of a
    catalog."""
    stock = stock_of(catalog)
    if not stock and not learned:
        return SHIPPED
    own = {}
    for name in GROUPS:
        known, areas = _known(name, learned)
        if stock:
            cases = substitute_models(name, known, stock, catalog, taste)
            own[name] = index_cases(cases, _first(cases, known))
        else:
            own[name] = index_cases(known, (), areas)
    return Library(own, habits_of(one.targets for one, _ in learned))


def _known(name: str, learned: Learned) -> tuple[tuple[Group, ...], tuple[float, ...]]:
    """The cases of a function before furniture is chosen for them, and the areas of the rooms
    learned ones are of."""
    mine = [(one, beside) for one, beside in learned if name in one.cases]
    cases = tuple(case for one, _ in mine for case in one.cases[name])
    if not mine or any(beside for _, beside in mine):
        return (*cases, *shipped_cases(name).groups), ()
    return cases, tuple(area for one, _ in mine for area in one.areas[name])


def _first(cases: tuple[Group, ...], known: tuple[Group, ...]) -> tuple[bool, ...]:
    """Which cases come first: those about a real model, else those with one; but none if even
    the smallest of them is larger than any known case."""
    about = [bool(case.members[anchor_of(case)].asset) for case in cases]
    first = about if any(about) else [any(m.asset for m in case.members) for case in cases]
    areas = [case.width * case.depth for case, yes in zip(cases, first, strict=True) if yes]
    most = max(case.width * case.depth for case in known)
    return tuple(first) if min(areas, default=0.0) <= most else ()
