"""Figures of uses of a scheme: buildings and floor by use, and their coverage."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from scenewright.catalog.assets.buildings.house_looks import FORMS, read_asset
from scenewright.core.brief.uses import UseName
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece
from scenewright.ground.buildings.uses import count_uses, use_of_asset

KINDS = ("houses", "terraced", "flats")
"""Kinds of dwellings: houses that stand by themselves, with party walls, and of many flats."""
LIVED = ("dwelling", "farm", "shop")
"""Uses of houses that are lived in, be it above a shop."""


def measure_uses(
    pieces: Sequence[Piece], area: float, known: Mapping[str, UseName] | None = None
) -> dict[str, Any]:
    """Buildings and square metres of floor by use, their sum, and the share of the ground of some
    ``area`` that is built on; ``known`` are uses of models that are not shipped, by function."""
    built = [piece for piece in pieces if piece.category == "building"]
    found = count_uses(built, known)
    floor = sum(row.floor for row in found.values())
    covered = sum(float(shape.area) for shape in polygons_of(built)) if built else 0.0
    return {
        "buildings_by_use": {use: row.number for use, row in found.items()},
        "dwellings_by_kind": count_kinds(built),
        "floor_by_use": {use: row.floor for use, row in found.items()},
        "floor_area": round(floor, 1),
        "floor_area_ratio": round(floor / area, 4),
        "coverage": round(covered / area, 4),
    }


def count_kinds(pieces: Sequence[Piece]) -> dict[str, int]:
    """Buildings that are lived in, by kind: houses by themselves, terraced ones, and flats.

    >>> from scenewright.core.scene import Pose, Size
    >>> rows = ("house_hui_gabled", "rowshop_hui_gabled", "modern_residential", "barn_hui_flat")
    >>> spot, size = Pose(0, 0, 0, 0), Size(9, 9, 9)
    >>> count_kinds([Piece("p", "building", asset, "b", spot, size) for asset in rows])
    {'houses': 1, 'terraced': 1, 'flats': 1}
    """
    found = dict.fromkeys(KINDS, 0)
    for piece in pieces:
        words = read_asset(piece.asset)
        if words is not None and FORMS[words[0]].use in LIVED:
            found[KINDS[int(FORMS[words[0]].party)]] += 1
        elif words is None and use_of_asset(piece.asset) == "dwelling":
            found[KINDS[2]] += 1
    return {kind: number for kind, number in found.items() if number}
