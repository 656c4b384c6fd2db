"""From a solved site to its pieces: buildings and landmarks."""

from __future__ import annotations

import math

from scenewright.assets import shipped
from scenewright.catalog import Catalog
from scenewright.domains.site.wanted import Wanted
from scenewright.scene import Piece, Pose, Size
from scenewright.site_plan import SitePlan
from scenewright.site_problem import Flags, Floats


def buildings(
    plan: SitePlan, rows: list[Wanted], boxes: Floats, present: Flags
) -> tuple[Piece, ...]:
    """One piece a building that found a place; ids count by model."""
    counts: dict[str, int] = {}
    found = []
    for row, box, there in zip(rows, boxes, present, strict=True):
        if not there:
            continue
        counts[row.asset.id] = counts.get(row.asset.id, 0) + 1
        x, y, heading = (float(v) for v in box[:3])
        found.append(
            Piece(
                id=f"{plan.id}/{row.asset.id}_{counts[row.asset.id]}", category="building",
                asset=row.asset.id, space=plan.id, pose=Pose(x, y, 0.0, wrapped(heading)),
                size=row.size, group=f"{plan.id}/buildings", function=row.name,
            )
        )  # fmt: skip
    return tuple(found)


def landmarks(plan: SitePlan, catalog: Catalog) -> tuple[Piece, ...]:
    """What stands already."""
    found = []
    for row in plan.landmarks:
        x, y, heading, width, depth = row.box
        size = Size(width, depth, row.height)
        chosen = catalog.assets[row.model] if row.model else shipped().choose("building", size)
        found.append(
            Piece(
                id=f"{plan.id}/{row.id}", category="building",
                asset=chosen.id if chosen else "", space=plan.id,
                pose=Pose(x, y, 0.0, wrapped(heading)), size=size,
                group=f"{plan.id}/landmarks", function="landmark", fixed=True,
            )
        )  # fmt: skip
    return tuple(found)


def wrapped(angle: float) -> float:
    """An angle in [-π, π)."""
    return (angle + math.pi) % (2 * math.pi) - math.pi
