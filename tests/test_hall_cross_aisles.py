"""Rows that a brief breaks by aisles across are broken in every layout."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece
from scenewright.domains.hall.demands.checked import check_demands
from scenewright.domains.hall.demands.cross_aisles import break_rows
from scenewright.domains.hall.demands.holdings import collect_demands


def store(**demand: Any) -> Brief:
    racks = {
        "id": "racks",
        "category": "wall_shelving",
        "count": 14,
        "size": [1.4, 0.6, 2.0],
        "place": "free",
        "clearance": [1.0, 0, 1.0, 0],
        "patterns": ["grid", "chain"],
    }
    room = {
        "outline": [[0, 0], [16, 0], [16, 11], [0, 11]],
        "doors": [{"at": [8, 0], "width": 2.0, "swing": "slide"}],
        "demands": [racks | demand],
    }
    return Brief.model_validate({"domain": "hall", "rooms": [room]})


def longest_run(pieces: list[Piece], width: float) -> int:
    """Most pieces in a line, each nearer than ``width`` to the next."""
    most = 0
    for first in pieces:
        c, s = math.cos(first.pose.heading), math.sin(first.pose.heading)
        off = np.array([p.pose[:2] for p in pieces]) - first.pose[:2]
        line = abs(off @ (c, s)) < 0.5 * first.size.depth
        along, wide = off @ (s, -c), np.array([p.size.width for p in pieces])
        order = np.argsort(along[line])
        low, high = (along - wide / 2)[line][order], (along + wide / 2)[line][order]
        gaps = np.flatnonzero(low[1:] - high[:-1] >= width - 0.01)
        most = max(most, int(np.diff([-1, *gaps, len(order) - 1]).max()))
    return most


def test_what_stands_between_two_aisles_is_laid_out_as_one() -> None:
    brief = store(aisle={"every": 4, "width": 1.8})
    wish = break_rows(collect_demands(brief, 0, (), catalog_of([]))[0])
    assert [len(line) for line in wish.lounges] == [4, 4, 4, 2]
    assert wish.sizes[0][:2] == pytest.approx((5.6, 0.6))
    assert wish.clearance == (1.0, 0.9, 1.0, 0.9)


@pytest.mark.parametrize("seed", [0, 1])
def test_rows_are_broken_by_aisles_of_their_width(seed: int) -> None:
    found = scenewright.solve(store(aisle={"every": 3, "width": 1.8}), seed=seed, threads=1)
    racks = [piece for piece in found.pieces if piece.category == "wall_shelving"]
    assert len({piece.id for piece in racks}) == 14
    assert longest_run(racks, 1.8) <= 3
    assert scenewright.check(found).valid


def test_a_row_pushed_together_is_named() -> None:
    found = scenewright.solve(store(aisle={"every": 3, "width": 1.8}), seed=1, threads=1)
    racks = [piece for piece in found.pieces if piece.category == "wall_shelving"]
    heading = racks[0].pose.heading
    c, s = math.cos(heading), math.sin(heading)
    first = racks[0].pose
    row = {
        piece.id: piece.pose._replace(x=first.x + 1.4 * k * s, y=first.y - 1.4 * k * c)
        for k, piece in enumerate(racks[:4])
    }
    pieces = tuple(
        replace(p, pose=row[p.id]._replace(heading=heading)) if p.id in row else p
        for p in found.pieces
    )
    messages = [f.message for f in scenewright.check(replace(found, pieces=pieces)).findings]
    assert any("no aisle of 1.8 m" in message for message in messages)


def test_tables_with_chairs_of_their_own_are_not_broken() -> None:
    brief = store(category="dining_table", size=None, aisle={"every": 3, "width": 1.8})
    with pytest.raises(InputError, match="leave 'aisle' out"):
        check_demands(brief, 0, spaces(brief)[0])
    assert "aisle" not in store().model_dump_json()
