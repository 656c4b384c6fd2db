"""A sofa asked for beside a low table stands at it with the armchairs asked for there."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.hall.demands.holdings import HallDemand, collect_demands
from scenewright.domains.hall.seats.lounges import join_lounges, part_lounges

SOFA: dict[str, Any] = {"category": "sofa"}
TABLE: dict[str, Any] = {"category": "coffee_table"}
CHAIRS: dict[str, Any] = {"category": "armchair", "count": 2}
MEALS: dict[str, Any] = {"category": "dining_table", "count": 4}


def cafe(*demands: dict[str, Any], size: float = 10.0) -> Brief:
    room = {
        "name": "Cafe",
        "outline": [[0, 0], [size, 0], [size, 8], [0, 8]],
        "doors": [{"at": [0, 2], "width": 1.2}],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "name": "Cafe", "rooms": [room]})


def join(*demands: dict[str, Any]) -> list[HallDemand]:
    return join_lounges(collect_demands(cafe(*demands), 0, (), catalog_of([])), 0.9)


def of(found: Solution, category: str) -> list[Piece]:
    return [piece for piece in found.pieces if piece.category == category]


def looks_at(seat: Piece, table: Piece) -> bool:
    """Whether a table stands less than a metre before the front of a seat."""
    off = np.array(table.pose[:2]) - np.array(seat.pose[:2])
    ahead = off @ (math.cos(seat.pose.heading), math.sin(seat.pose.heading))
    gap = ahead - 0.5 * (seat.size.depth + min(table.size[:2]))
    return 0.2 < gap < 1.0 and abs(ahead) > abs(math.hypot(*off)) * 0.6


@pytest.mark.parametrize("seed", [59, 61])
def test_sofa_and_armchairs_stand_round_the_low_table(seed: int) -> None:
    found = scenewright.solve(cafe(MEALS, TABLE, CHAIRS, SOFA), seed=seed, threads=1)
    (table,) = of(found, "coffee_table")
    assert len(of(found, "armchair")) == 2
    assert all(looks_at(seat, table) for seat in (*of(found, "sofa"), *of(found, "armchair")))
    assert len({piece.group for piece in (table, *of(found, "sofa"), *of(found, "armchair"))}) == 1
    assert table.function == "coffee_table"
    assert scenewright.check(found).valid
    assert not found.left_out


@pytest.mark.parametrize(("sofas", "tables", "chairs"), [(2, 1, 2), (2, 2, 5), (1, 1, 4)])
def test_one_gets_to_all_seats_of_a_lounge(sofas: int, tables: int, chairs: int) -> None:
    asked = [SOFA | {"count": sofas}, TABLE | {"count": tables}, CHAIRS | {"count": chairs}]
    found = scenewright.solve(cafe(*asked), seed=59, threads=1)
    assert len({piece.group for piece in found.pieces}) == 1
    assert scenewright.check(found).valid
    assert not found.left_out


def test_one_gets_to_narrow_sofas_and_by_a_wide_route() -> None:
    narrow = SOFA | {"size": [1.6, 0.85, 0.8]}
    for asked, route in ((narrow, 0.9), (SOFA, 1.2)):
        brief = cafe(asked, TABLE, CHAIRS).model_copy(update={"route_width": route})
        found = scenewright.solve(brief, seed=59, threads=1)
        assert len({piece.group for piece in found.pieces}) == 1
        assert scenewright.check(found).valid
        assert not found.left_out


def test_each_table_has_its_sofa_and_its_share_of_the_chairs() -> None:
    (one,) = join(SOFA | {"count": 2}, TABLE | {"count": 2}, CHAIRS | {"count": 5})
    kinds = [sorted(part.wish.category for part in lounge) for lounge in one.lounges]
    assert kinds[0] == ["armchair"] * 3 + ["coffee_table", "sofa"]
    assert kinds[1] == ["armchair"] * 2 + ["coffee_table", "sofa"]


def test_chairs_beyond_a_lounge_stand_by_themselves() -> None:
    one, rest = join(SOFA, TABLE, CHAIRS | {"count": 7})
    assert len(one.lounges[0]) == 6
    assert len(rest.sizes) == 3


def test_what_a_brief_says_more_of_stays_as_it_is() -> None:
    for demand in (TABLE | {"place": "free"}, TABLE | {"clearance": 1.0}):
        assert not any(wish.lounges for wish in join(SOFA, demand, CHAIRS))
    assert not any(wish.lounges for wish in join(SOFA | {"patterns": ["grid"]}, TABLE, CHAIRS))


def test_lounges_part_into_what_was_asked_for() -> None:
    asked = [SOFA | {"count": 2}, TABLE, CHAIRS]
    parted = {wish.id: len(wish.sizes) for wish in part_lounges(join(*asked))}
    assert parted == {"sofa": 2, "coffee_table": 1, "armchair": 2}


def test_armchairs_without_a_sofa_stand_round_the_table_asked_for() -> None:
    chairs = CHAIRS | {"count": 4}
    found = scenewright.solve(cafe(MEALS, TABLE, chairs), seed=59, threads=1)
    (table,) = of(found, "coffee_table")
    assert all(looks_at(seat, table) for seat in of(found, "armchair"))


def test_a_lounge_too_large_for_its_hall_stands_in_its_parts() -> None:
    found = scenewright.solve(cafe(SOFA, TABLE, CHAIRS, size=2.6), seed=59, threads=1)
    assert len(of(found, "sofa")) == 1
