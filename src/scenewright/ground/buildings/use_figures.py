"""Figures of uses of a scheme: buildings and floor by use, and their coverage."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from scenewright.core.brief.uses import UseName
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece
from scenewright.ground.buildings.uses import count_uses


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
        "floor_by_use": {use: row.floor for use, row in found.items()},
        "floor_area": round(floor, 1),
        "floor_area_ratio": round(floor / area, 4),
        "coverage": round(covered / area, 4),
    }
