"""The table of terms: what can be weighed, in which form, with what default weight.

The table drives the explanation of a layout, ``scenewright list terms`` and the contract tests.
A new term is one compiled function in a theme file, one number and one row here,
and one line in :mod:`scenewright.domains.home.terms.assemble`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.engine.weights import vector_of

(
    BOUNDARY,
    OVERLAP,
    KEEP_FREE,
    CORRIDORS,
    OBSTACLES,
    WINDOW,
    CLEAR_ROOM,
    CLEAR_ITEMS,
    MAIN_WALL,
    MAIN_WALL_PRINTED,
    AGAINST_WALL,
    AGAINST_WALL_PRINTED,
    ALIGNMENT,
    DAYLIGHT,
    NESTLE,
    PAIRS,
    PAIRS_PRINTED,
    SIZE,
    WISH,
    ROUTE,
    BALANCE,
    PLACES,
    SLOPE,
) = range(23)


class Term(NamedTuple):
    """One row. ``name`` is what weights are given by (two forms of one term share it), ``number``
    its place in the vector of weights. ``kind`` tells what the value is of: one box, one pair
    of boxes, or the whole layout. ``per_area``: an area, divided by the summed area of all items.
    ``function`` is the compiled function, as theme:name."""

    name: str
    number: int
    form: Literal["both", "printed", "repaired"]
    kind: Literal["box", "pair", "whole"]
    per_area: bool
    weight: float
    doc: str
    source: str
    function: str


LIU = "Liu et al. 2017"
OURS = "ours"

TERMS: tuple[Term, ...] = (
    Term(
        "boundary",
        BOUNDARY,
        "both",
        "box",
        True,
        5000,
        "area outside the room",
        f"{LIU}, C1",
        "packing:outside",
    ),
    Term(
        "overlap",
        OVERLAP,
        "both",
        "pair",
        True,
        600,
        "area shared by two items",
        f"{LIU}, C2",
        "packing:overlap",
    ),
    Term(
        "keep_free",
        KEEP_FREE,
        "both",
        "box",
        True,
        600,
        "area in door swings and thresholds",
        f"{LIU}, C3",
        "clearance:measure_entered_area",
    ),
    Term(
        "corridors",
        CORRIDORS,
        "both",
        "box",
        True,
        600,
        "area in the corridors between doors",
        f"{LIU}, C3",
        "clearance:measure_entered_area",
    ),
    Term(
        "obstacles",
        OBSTACLES,
        "repaired",
        "box",
        True,
        5000,
        "area on fixed pieces",
        OURS,
        "clearance:measure_entered_area",
    ),
    Term(
        "window",
        WINDOW,
        "repaired",
        "box",
        True,
        600,
        "area of an item taller than the sill before a window",
        OURS,
        "clearance:measure_entered_area",
    ),
    Term(
        "clear_room",
        CLEAR_ROOM,
        "repaired",
        "box",
        True,
        300,
        "clear zones outside the room or on fixed pieces",
        OURS,
        "clearance:zone_blocked",
    ),
    Term(
        "clear_items",
        CLEAR_ITEMS,
        "repaired",
        "pair",
        True,
        300,
        "clear zones covered by the other item",
        OURS,
        "clearance:zones_covered",
    ),
    Term(
        "main_wall",
        MAIN_WALL,
        "repaired",
        "box",
        False,
        1500,
        "angle off facing or backing the main wall",
        f"{LIU}, C4, wrapped, summed as absolutes",
        "orientation:main_wall",
    ),
    Term(
        "main_wall",
        MAIN_WALL_PRINTED,
        "printed",
        "whole",
        False,
        1500,
        "absolute value of the signed sum of angles off the main wall",
        f"{LIU}, C4 as printed",
        "orientation:main_wall_turn",
    ),
    Term(
        "against_wall",
        AGAINST_WALL,
        "repaired",
        "box",
        False,
        1000,
        "back edge off its wall, by the worse corner",
        f"{LIU}, C5, both corners, 0.02 m",
        "orientation:against_wall",
    ),
    Term(
        "against_wall",
        AGAINST_WALL_PRINTED,
        "printed",
        "box",
        False,
        1000,
        "back edge off its wall, by its midpoint",
        f"{LIU}, C5 as printed, 0.1 m",
        "orientation:against_wall_printed",
    ),
    Term(
        "alignment",
        ALIGNMENT,
        "repaired",
        "box",
        False,
        60,
        "free item askew to the nearest wall",
        OURS,
        "orientation:alignment",
    ),
    Term(
        "daylight",
        DAYLIGHT,
        "repaired",
        "box",
        False,
        30,
        "distance to the nearest window",
        OURS,
        "relations:daylight",
    ),
    Term(
        "nestle",
        NESTLE,
        "repaired",
        "box",
        False,
        30,
        "no side against a wall or fixed piece",
        OURS,
        "relations:nestle",
    ),
    Term(
        "pairs",
        PAIRS,
        "repaired",
        "pair",
        False,
        110,
        "distance, angle and bearing off what the relation wants",
        f"{LIU}, C6, with bearing",
        "relations:pair",
    ),
    Term(
        "pairs",
        PAIRS_PRINTED,
        "printed",
        "pair",
        False,
        110,
        "distance and angle off what the relation wants",
        f"{LIU}, C6 as printed",
        "relations:pair_printed",
    ),
    Term(
        "size",
        SIZE,
        "both",
        "whole",
        False,
        50,
        "share of the floor outside 0.40 to 0.55",
        f"{LIU}, C7",
        "packing:size",
    ),
    Term(
        "wish",
        WISH,
        "repaired",
        "box",
        False,
        50,
        "relative deviation from the preferred size",
        OURS,
        "packing:wish",
    ),
    Term(
        "route",
        ROUTE,
        "repaired",
        "whole",
        False,
        400,
        "items and doors that the walking route does not reach",
        OURS,
        "geometry.circulation:route",
    ),
    Term(
        "balance",
        BALANCE,
        "repaired",
        "whole",
        False,
        60,
        "middle of all furniture off that of the room",
        "Merrell et al. 2011, as a share",
        "composition:balance",
    ),
    Term(
        "places",
        PLACES,
        "repaired",
        "box",
        False,
        110,
        "too far from, too near to or not facing what it should",
        OURS,
        "places:place",
    ),
    Term(
        "slope",
        SLOPE,
        "repaired",
        "box",
        True,
        600,
        "area of an item taller than the sloped ceiling there",
        OURS,
        "clearance:measure_entered_area",
    ),
)


def terms_of(printed: bool) -> tuple[Term, ...]:
    """The rows of one form: those of both forms and those of the asked one."""
    return tuple(row for row in TERMS if row.form in ("both", "printed" if printed else "repaired"))


def default_weights(printed: bool = False) -> dict[str, float]:
    """Default weight of every term of a form.

    >>> sorted(default_weights(printed=True))[:3]
    ['against_wall', 'boundary', 'corridors']
    """
    return {row.name: float(row.weight) for row in terms_of(printed)}


def read_weights(weights: Mapping[str, float], printed: bool) -> NDArray[np.float64]:
    """Weights by name to the vector ``(terms,)``; a name left out weighs nothing.

    A term that has no printed form may be weighed beside the printed ones.

    >>> float(read_weights({"pairs": 110.0}, printed=True)[PAIRS_PRINTED])
    110.0
    """
    unwanted = "repaired" if printed else "printed"
    twice = {row.name for row in TERMS if row.form == "printed"}
    rows = [row for row in TERMS if row.form != unwanted or row.name not in twice]
    places = {row.name: row.number for row in sorted(rows, key=lambda row: row.name)}
    return vector_of(weights, places, np.zeros(len(TERMS)), "term")


MEANINGS: dict[str, str] = {
    row.name: row.doc for row in sorted(TERMS, key=lambda row: row.form == "repaired")
}
"""What each term says, in one line; of two forms the repaired one."""
