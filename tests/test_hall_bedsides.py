"""Nightstands asked for where beds stand are beside the heads of these."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.domains.hall.demands.bedsides import join_bedsides
from scenewright.domains.hall.demands.holdings import HallDemand, collect_demands


def showroom(*demands: dict[str, Any]) -> Brief:
    room = {
        "name": "Beds",
        "outline": [[0, 0], [12, 0], [12, 9], [0, 9]],
        "doors": [{"at": [0, 2], "width": 1.6}],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "name": "Beds", "rooms": [room]})


def join(*demands: dict[str, Any]) -> list[HallDemand]:
    return join_bedsides(collect_demands(showroom(*demands), 0, (), catalog_of([])))


def is_beside(stand: Piece, bed: Piece) -> bool:
    """Whether a nightstand stands at a side of a bed, by its head, and looks the same way."""
    c, s = math.cos(bed.pose.heading), math.sin(bed.pose.heading)
    off = np.array(stand.pose[:2]) - np.array(bed.pose[:2])
    ahead, along = off @ (c, s), abs(off @ (s, -c))
    gap = along - 0.5 * (bed.size.width + stand.size.width)
    turn = math.cos(stand.pose.heading - bed.pose.heading)
    return -1e-6 < gap < 0.2 and ahead < -0.25 * bed.size.depth and turn > 0.99


@pytest.mark.parametrize(("beds", "stands"), [(3, 3), (2, 4), (3, 2)])
def test_nightstands_are_beside_heads_of_beds(beds: int, stands: int) -> None:
    asked = showroom(
        {"category": "double_bed", "count": beds}, {"category": "nightstand", "count": stands}
    )
    found = scenewright.solve(asked, seed=5, threads=1)
    each = [piece for piece in found.pieces if piece.category == "double_bed"]
    small = [piece for piece in found.pieces if piece.category == "nightstand"]
    assert (len(each), len(small)) == (beds, stands)
    assert all(any(is_beside(stand, bed) for bed in each) for stand in small)
    assert scenewright.check(found).valid
    assert not found.left_out


def test_nightstands_beyond_two_a_bed_and_stated_ones_stand_by_themselves() -> None:
    five = join({"category": "double_bed", "count": 2}, {"category": "nightstand", "count": 5})
    assert [(wish.category, len(wish.sizes)) for wish in five] == [
        ("double_bed", 2),
        ("nightstand", 1),
    ]
    at_wall = {"category": "nightstand", "count": 2, "place": "wall"}
    apart = join({"category": "double_bed", "count": 2}, at_wall)
    assert not any(wish.lounges for wish in apart)
