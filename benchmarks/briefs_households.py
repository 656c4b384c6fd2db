"""Thirty households and what must be so that each has what it says it needs.

Needs are counted on the final pieces by their categories; the words of a household are all that a
reader has to believe.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from benchmarks.composition_faults import SOFAS, TABLES, Home, count_seats
from scenewright.core.report import Report
from scenewright.core.solution import Solution

BEDS = {"double_bed": 2, "single_bed": 1, "bunk_bed": 2}
DESKS = ("desk", "corner_desk", "kids_desk")
BOOKS = ("bookcase", "shelf_unit")


class Furnished(NamedTuple):
    """A furnished flat: its solution, the referee's report, and its rooms with what they hold."""

    solution: Solution
    report: Report
    home: Home

    def count(self, *categories: str) -> int:
        """How many pieces of some categories there are."""
        return sum(p.category in categories for p in self.solution.pieces)


Met = Callable[[Furnished], bool]


def sleeps(people: int) -> Met:
    """Whether so many have a bed."""
    return lambda flat: sum(BEDS.get(p.category, 0) for p in flat.solution.pieces) >= people


def eats(people: int) -> Met:
    """Whether so many have a chair at a table in one room."""
    return lambda flat: any(
        room.find(*TABLES) and len(room.find("dining_chair")) >= people for room in flat.home
    )


def sits(people: int) -> Met:
    """Whether so many have a seat on sofas and armchairs in one room."""
    return lambda flat: any(room.find(*SOFAS) and count_seats(room) >= people for room in flat.home)


def works(people: int) -> Met:
    """Whether so many have a desk with a chair."""
    return lambda flat: (
        flat.count(*DESKS) >= people and flat.count("office_chair", "dining_chair") >= people
    )


def keeps(categories: tuple[str, ...], metres: float) -> Met:
    """Whether there are so many metres of furniture of some kinds."""
    return lambda flat: (
        sum(p.size.width for p in flat.solution.pieces if p.category in categories) >= metres
    )


def has(*categories: str) -> Met:
    """Whether there is a piece of one of some kinds."""
    return lambda flat: flat.count(*categories) > 0


def lacks(category: str) -> Met:
    """Whether there is none of a kind."""
    return lambda flat: flat.count(category) == 0


def cooks(flat: Furnished) -> bool:
    """Whether a room has a hob, a sink and a fridge."""
    kitchen = ("hob_cabinet", "sink_cabinet", "fridge")
    return any(all(map(room.find, kitchen)) for room in flat.home)


class FunctionalBrief(NamedTuple):
    """What a household says: in words, how many live there, the ``bedrooms`` and square metres of
    living room (``living``) it takes, whether a wheelchair is used, wishes by the function of their
    room, and what must then be so (``needs``)."""

    words: str
    residents: int
    bedrooms: int
    living: float
    needs: tuple[Met, ...]
    wishes: tuple[tuple[str, dict[str, Any]], ...] = ()
    accessible: bool = False


def _wish(room: str, what: str, **place: Any) -> tuple[str, dict[str, Any]]:
    return room, {"what": what, **place}


def _forbid(room: str, what: str) -> tuple[str, dict[str, Any]]:
    return room, {"what": what, "forbid": True}


WARDROBE = ("wardrobe",)
DESK = _wish("bedroom", "desk")
_LIVING_DESK = _wish("living", "desk")
BRIEFS = (
    FunctionalBrief("one person", 1, 1, 9, (sleeps(1), eats(1), sits(1), cooks)),
    FunctionalBrief("a couple", 2, 1, 12, (sleeps(2), eats(2), sits(2), cooks)),
    FunctionalBrief(
        "a couple, one works from home",
        2,
        1,
        14,
        (sleeps(2), eats(2), works(1), cooks),
        (_LIVING_DESK,),
    ),
    FunctionalBrief(
        "a couple, both work from home",
        2,
        2,
        16,
        (sleeps(2), eats(2), works(2), cooks),
        (DESK, _LIVING_DESK),
    ),
    FunctionalBrief(
        "a couple that cooks, one wheelchair", 2, 1, 16, (sleeps(2), eats(2), cooks), (), True
    ),
    FunctionalBrief("one person in a wheelchair", 1, 1, 14, (sleeps(1), eats(1), cooks), (), True),
    FunctionalBrief(
        "a couple that reads",
        2,
        1,
        16,
        (sleeps(2), eats(2), keeps(BOOKS, 0.8), cooks),
        (_wish("living", "shelf"),),
    ),
    FunctionalBrief(
        "a couple with two wardrobes' worth of clothes",
        2,
        1,
        12,
        (sleeps(2), eats(2), keeps(WARDROBE, 2.0), cooks),
    ),
    FunctionalBrief(
        "a couple without television",
        2,
        1,
        14,
        (sleeps(2), eats(2), lacks("tv"), cooks),
        (_forbid("living", "tv"),),
    ),
    FunctionalBrief("a couple and a child", 3, 2, 14, (sleeps(3), eats(3), sits(3), cooks)),
    FunctionalBrief(
        "a couple and a child, one works from home",
        3,
        2,
        16,
        (sleeps(3), eats(3), works(1), cooks),
        (_LIVING_DESK,),
    ),
    FunctionalBrief(
        "a couple and two children in a room each", 4, 3, 12, (sleeps(4), eats(4), sits(3), cooks)
    ),
    FunctionalBrief("a couple and two children", 4, 2, 18, (sleeps(4), eats(4), cooks)),
    FunctionalBrief(
        "a family of four that plays the piano",
        4,
        3,
        14,
        (sleeps(4), eats(4), has("piano"), cooks),
        (_wish("living", "piano"),),
    ),
    FunctionalBrief("a family of five", 5, 3, 12, (sleeps(5), eats(5), cooks)),
    FunctionalBrief(
        "two who share a flat, a room each",
        2,
        2,
        12,
        (sleeps(2), eats(2), works(2), cooks),
        (DESK, DESK),
    ),
    FunctionalBrief("three who share a flat", 3, 3, 12, (sleeps(3), eats(3), cooks)),
    FunctionalBrief("a student", 1, 1, 9, (sleeps(1), works(1), cooks), (DESK,)),
    FunctionalBrief(
        "an old couple, easy to walk through",
        2,
        1,
        14,
        (sleeps(2), eats(2), sits(2), cooks),
        (),
        True,
    ),
    FunctionalBrief(
        "a couple that has guests to dinner",
        2,
        1,
        22,
        (sleeps(2), eats(4), sits(3), cooks),
        (_wish("living", "dining"),),
    ),
    FunctionalBrief(
        "one person who trains at home",
        1,
        1,
        16,
        (sleeps(1), eats(1), has("exercise_bike"), cooks),
        (_wish("living", "exercise_bike"),),
    ),
    FunctionalBrief(
        "a couple with plants",
        2,
        1,
        14,
        (sleeps(2), eats(2), has("potted_tree"), cooks),
        (_wish("living", "plant"),),
    ),
    FunctionalBrief(
        "one who writes by the window",
        1,
        1,
        14,
        (sleeps(1), works(1), cooks),
        (_wish("living", "desk", by="window"),),
    ),
    FunctionalBrief(
        "a couple and a baby",
        3,
        2,
        14,
        (sleeps(3), has("cot"), eats(2), cooks),
        (_wish("bedroom", "cot"),),
    ),
    FunctionalBrief("a single parent and a child", 2, 2, 12, (sleeps(2), eats(2), sits(2), cooks)),
    FunctionalBrief(
        "a couple with an armchair to read in",
        2,
        1,
        18,
        (sleeps(2), eats(2), has("armchair"), cooks),
        (_wish("living", "reading"),),
    ),
    FunctionalBrief(
        "a couple that does its washing at home",
        2,
        1,
        12,
        (sleeps(2), eats(2), has("washing_machine"), cooks),
    ),
    FunctionalBrief("four who watch films", 4, 2, 16, (sleeps(4), sits(4), has("tv"), cooks)),
    FunctionalBrief(
        "one who dresses at a vanity",
        1,
        1,
        12,
        (sleeps(1), has("vanity"), cooks),
        (_wish("bedroom", "vanity"),),
    ),
    FunctionalBrief(
        "a couple and a grandparent in a wheelchair",
        3,
        2,
        18,
        (sleeps(3), eats(3), cooks),
        (),
        True,
    ),
)
"""Thirty households."""
