"""Straight flights one above the other in a stairwell, as houses of three storeys have them."""

from __future__ import annotations

from math import pi
from typing import Any

from scenewright.building.plan import spaces
from scenewright.core.brief import Brief

LEVELS = [{"id": name, "elevation": 2.8 * k, "height": 2.5} for k, name in enumerate("abc")]


def stairwell(*flights: tuple[float, float, str, str]) -> Brief:
    halls = [
        {"name": f"Hall {level}", "level": level, "outline": [(0, 0), (2.4, 0), (2.4, 8), (0, 8)]}
        for level in "abc"
    ]
    stairs: list[dict[str, Any]] = [
        {"at": (0.5, y), "heading": heading, "level": level, "to": to, "id": f"s-{level}"}
        for y, heading, level, to in flights
    ]
    return Brief.model_validate({"levels": LEVELS, "rooms": halls, "stairs": stairs})


def parts(brief: Brief) -> list[list[str]]:
    return [[part.id for part in space.stair_parts] for space in spaces(brief)]


def test_a_flight_above_takes_the_place_of_the_well_below_it() -> None:
    brief = stairwell((1.2, pi / 2, "a", "b"), (1.2, pi / 2, "b", "c"))
    assert parts(brief) == [["s-a"], ["s-b"], ["s-b/well"]]
    ends = [[(end.stairs, end.kind) for end in space.stairs] for space in spaces(brief)]
    assert ends[1] == [("s-a", "head"), ("s-b", "foot")]


def test_a_flight_across_the_head_of_another_still_collides() -> None:
    brief = stairwell((1.2, pi / 2, "a", "b"), (5.4, -pi / 2, "b", "c"))
    assert parts(brief)[1] == ["s-a/well", "s-b"]


def test_flights_beside_each_other_keep_their_wells() -> None:
    brief = stairwell((1.2, pi / 2, "a", "b"))
    assert parts(brief) == [["s-a"], ["s-a/well"], []]


def test_what_is_left_of_a_longer_well_stays_open() -> None:
    brief = stairwell((1.2, pi / 2, "a", "b"), (0.9, pi / 2, "b", "c"))
    (rest, flight) = (
        {part.id: part.box for part in spaces(brief)[1].stair_parts}[name]
        for name in ("s-a/well", "s-b")
    )
    assert rest[1] - rest[4] / 2 >= flight[1] + flight[4] / 2 - 0.02
    assert rest[4] < 0.35
