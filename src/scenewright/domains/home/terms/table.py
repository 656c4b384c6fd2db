"""The table of terms: what can be weighed, in which form, with what default weight.

The table drives the explanation of a layout, ``scenewright list terms`` and the contract tests.
A new term is one file with two functions, what a layout costs and what numbers of the problem
that takes (:mod:`scenewright.engine.whole_terms`), and one row here, or one entry point of another
package. Terms of single boxes and of pairs, which a moved item alone measures again, also have a
line in :mod:`scenewright.domains.home.terms.assemble`.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.terms.picture_rows import PICTURE_ROWS
from scenewright.engine.rows import TermRow
from scenewright.engine.weights import vector_of
from scenewright.engine.whole_terms import add_terms

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
    DAYLIGHT_KEPT,
    OPENINGS_KEPT,
) = range(25)


LIU = "Liu et al. 2017"
OURS = "ours"
THEMES = "scenewright.domains.home.terms"

_ROWS = (
    TermRow(
        "boundary",
        BOUNDARY,
        "box",
        5000,
        "area outside the room",
        f"{LIU}, C1",
        form="both",
        per_area=True,
        function=f"{THEMES}.packing:outside",
    ),
    TermRow(
        "overlap",
        OVERLAP,
        "pair",
        600,
        "area shared by two items",
        f"{LIU}, C2",
        form="both",
        per_area=True,
        function=f"{THEMES}.packing:overlap",
    ),
    TermRow(
        "keep_free",
        KEEP_FREE,
        "box",
        600,
        "area in door swings and thresholds",
        f"{LIU}, C3",
        form="both",
        per_area=True,
        function=f"{THEMES}.clearance:measure_entered_area",
    ),
    TermRow(
        "corridors",
        CORRIDORS,
        "box",
        600,
        "area on the ways from door to door, and before fixed pieces",
        f"{LIU}, C3",
        form="both",
        per_area=True,
        function=f"{THEMES}.clearance:measure_entered_area",
    ),
    TermRow(
        "obstacles",
        OBSTACLES,
        "box",
        5000,
        "area on fixed pieces",
        OURS,
        form="repaired",
        per_area=True,
        function=f"{THEMES}.clearance:measure_entered_area",
    ),
    TermRow(
        "window",
        WINDOW,
        "box",
        600,
        "area of an item taller than the sill before a window",
        OURS,
        form="repaired",
        per_area=True,
        function=f"{THEMES}.clearance:measure_entered_area",
    ),
    TermRow(
        "clear_room",
        CLEAR_ROOM,
        "box",
        300,
        "clear zones outside the room or on fixed pieces",
        OURS,
        form="repaired",
        per_area=True,
        function=f"{THEMES}.clearance:zone_blocked",
    ),
    TermRow(
        "clear_items",
        CLEAR_ITEMS,
        "pair",
        300,
        "clear zones covered by the other item",
        OURS,
        form="repaired",
        per_area=True,
        function=f"{THEMES}.clearance:zones_covered",
    ),
    TermRow(
        "main_wall",
        MAIN_WALL,
        "box",
        1500,
        "angle off facing or backing the main wall",
        f"{LIU}, C4, wrapped, summed as absolutes",
        form="repaired",
        function=f"{THEMES}.orientation:main_wall",
    ),
    TermRow(
        "main_wall",
        MAIN_WALL_PRINTED,
        "whole",
        1500,
        "absolute value of the signed sum of angles off the main wall",
        f"{LIU}, C4 as printed",
        form="printed",
        function=f"{THEMES}.orientation:main_wall_turn",
    ),
    TermRow(
        "against_wall",
        AGAINST_WALL,
        "box",
        1000,
        "back edge off its wall, by the worse corner",
        f"{LIU}, C5, both corners, 0.02 m",
        form="repaired",
        function=f"{THEMES}.orientation:against_wall",
    ),
    TermRow(
        "against_wall",
        AGAINST_WALL_PRINTED,
        "box",
        1000,
        "back edge off its wall, by its midpoint",
        f"{LIU}, C5 as printed, 0.1 m",
        form="printed",
        function=f"{THEMES}.orientation:against_wall_printed",
    ),
    TermRow(
        "alignment",
        ALIGNMENT,
        "box",
        60,
        "free item askew to the nearest wall",
        OURS,
        form="repaired",
        function=f"{THEMES}.orientation:alignment",
    ),
    TermRow(
        "daylight",
        DAYLIGHT,
        "box",
        30,
        "distance to the nearest window",
        OURS,
        form="repaired",
        function=f"{THEMES}.relations:daylight",
    ),
    TermRow(
        "nestle",
        NESTLE,
        "box",
        30,
        "no side against a wall or fixed piece",
        OURS,
        form="repaired",
        function=f"{THEMES}.relations:nestle",
    ),
    TermRow(
        "pairs",
        PAIRS,
        "pair",
        110,
        "distance, angle and bearing off what the relation wants",
        f"{LIU}, C6, with bearing",
        form="repaired",
        function=f"{THEMES}.relations:pair",
    ),
    TermRow(
        "pairs",
        PAIRS_PRINTED,
        "pair",
        110,
        "distance and angle off what the relation wants",
        f"{LIU}, C6 as printed",
        form="printed",
        function=f"{THEMES}.relations:pair_printed",
    ),
    TermRow(
        "size",
        SIZE,
        "whole",
        50,
        "share of the floor outside 0.40 to 0.55",
        f"{LIU}, C7",
        form="both",
        function=f"{THEMES}.packing:size",
    ),
    TermRow(
        "wish",
        WISH,
        "box",
        50,
        "relative deviation from the preferred size",
        OURS,
        form="repaired",
        function=f"{THEMES}.packing:wish",
    ),
    TermRow(
        "route",
        ROUTE,
        "whole",
        400,
        "items and doors that the walking route does not reach",
        OURS,
        form="repaired",
        function="scenewright.geometry.circulation:route",
    ),
    TermRow(
        "balance",
        BALANCE,
        "layout",
        60,
        "middle of all furniture off that of the room",
        "Merrell et al. 2011, as a share",
        form="repaired",
        function=f"{THEMES}.composition:balance",
        data=f"{THEMES}.composition:find_middle",
    ),
    TermRow(
        "places",
        PLACES,
        "box",
        110,
        "too far from, too near to or not facing what it should",
        OURS,
        form="repaired",
        function=f"{THEMES}.places:place",
    ),
    TermRow(
        "slope",
        SLOPE,
        "box",
        600,
        "area of an item taller than the sloped ceiling there",
        OURS,
        form="repaired",
        per_area=True,
        function=f"{THEMES}.clearance:measure_entered_area",
    ),
    TermRow(
        "daylight_kept",
        DAYLIGHT_KEPT,
        "box",
        60,
        "metres of a window behind what takes its light or is lit from behind",
        OURS,
        form="repaired",
        function=f"{THEMES}.openings:covered_width",
    ),
    TermRow(
        "openings_kept",
        OPENINGS_KEPT,
        "box",
        60,
        "metres of a wide door or passage that an item stands before",
        OURS,
        form="repaired",
        function=f"{THEMES}.openings:covered_width",
    ),
    *PICTURE_ROWS,
)
TERMS: tuple[TermRow, ...] = add_terms("home", _ROWS)
"""All terms of homes, those of other packages last."""


def terms_of(printed: bool) -> tuple[TermRow, ...]:
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
    return vector_of(weights, _number_terms(printed), np.zeros(len(TERMS)), "term")


@cache
def _number_terms(printed: bool) -> Mapping[str, int]:
    """The number of each term that may be weighed in one form, by name."""
    unwanted = "repaired" if printed else "printed"
    twice = {row.name for row in TERMS if row.form == "printed"}
    rows = [row for row in TERMS if row.form != unwanted or row.name not in twice]
    return {row.name: row.number for row in sorted(rows, key=lambda row: row.name)}


MEANINGS: dict[str, str] = {
    row.name: row.doc for row in sorted(TERMS, key=lambda row: row.form == "repaired")
}
"""What each term says, in one line; of two forms the repaired one."""
