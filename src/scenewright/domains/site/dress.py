"""From a solved site to its pieces: buildings and landmarks."""

from __future__ import annotations

import math

from scenewright.assets import shipped
from scenewright.catalog import Asset, Catalog
from scenewright.domains.site.wanted import Wanted
from scenewright.scene import Piece, Pose, Size
from scenewright.site.plan import SitePlan
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


def landmark_assets(plan: SitePlan, catalog: Catalog) -> tuple[Asset | None, ...]:
    """The models that draw the landmarks: those named, else shipped ones of about their size."""
    return tuple(
        catalog.assets[row.model] if row.model
        else shipped().choose("building", Size(row.box[3], row.box[4], row.height))
        for row in plan.landmarks
    )  # fmt: skip


def landmarks(plan: SitePlan, catalog: Catalog) -> tuple[Piece, ...]:
    """What stands already."""
    found = []
    for row, chosen in zip(plan.landmarks, landmark_assets(plan, catalog), strict=True):
        x, y, heading, width, depth = row.box
        size = Size(width, depth, row.height)
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
