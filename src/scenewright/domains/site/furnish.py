"""From a solved site to its pieces: buildings and landmarks."""

from __future__ import annotations

import math

import numpy as np

from scenewright.catalog.assets import shipped
from scenewright.core.catalog import Asset, Catalog
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece, Pose, Scene, Size
from scenewright.core.solution import Solution
from scenewright.domains.site.holdings import BuildingDemand
from scenewright.domains.site.problem import Flags, Floats
from scenewright.domains.site.works import works_of
from scenewright.ground.plan import SitePlan
from scenewright.ground.ways.surfaces import surfaces


def buildings(
    plan: SitePlan, rows: list[BuildingDemand], boxes: Floats, present: Flags
) -> tuple[Piece, ...]:
    """One piece a building that found a place; ids count by model, past those that stay.

    ``boxes`` (n, 5) x, y, heading, width, depth in metres and radians, ``present`` (n,).
    """
    counts: dict[str, int] = {}
    taken = {row.id for row in plan.fixed}
    found = []
    for row, box, there in zip(rows, boxes, present, strict=True):
        if not there:
            continue
        counts[row.asset.id] = counts.get(row.asset.id, 0) + 1
        while f"{plan.id}/{row.asset.id}_{counts[row.asset.id]}" in taken:
            counts[row.asset.id] += 1
        x, y, heading = (float(v) for v in box[:3])
        found.append(
            Piece(
                id=f"{plan.id}/{row.asset.id}_{counts[row.asset.id]}",
                category="building",
                asset=row.asset.id,
                space=plan.id,
                pose=Pose(x, y, 0.0, wrap_angle(heading)),
                size=row.size,
                group=f"{plan.id}/buildings",
                function=row.name,
                footprint=row.footprint,
            )
        )
    return tuple(found)


def landmark_assets(plan: SitePlan, catalog: Catalog) -> tuple[Asset | None, ...]:
    """The models that draw the landmarks: those named, else plain ones by what they are."""
    return tuple(
        catalog.assets[row.model] if row.model else shipped().assets.get(row.drawn)
        for row in plan.landmarks
    )


def landmarks(plan: SitePlan, catalog: Catalog) -> tuple[Piece, ...]:
    """The landmarks of a site, as pieces."""
    found = []
    for row, chosen in zip(plan.landmarks, landmark_assets(plan, catalog), strict=True):
        x, y, heading, width, depth = row.box
        size = Size(width, depth, row.height)
        found.append(
            Piece(
                id=f"{plan.id}/{row.id}",
                category="building",
                asset=chosen.id if chosen else "",
                space=plan.id,
                pose=Pose(x, y, 0.0, wrap_angle(heading)),
                size=size,
                group=f"{plan.id}/landmarks",
                function="landmark",
                fixed=True,
                footprint=row.local,
            )
        )
    return tuple(found)


def wrap_angle(angle: float) -> float:
    """An angle in [-π, π)."""
    return (angle + math.pi) % (2 * math.pi) - math.pi


def scene_of_sites(solution: Solution, plan: Plan) -> Scene:
    """The scene of a solution of sites: surfaces of the ground, and buildings."""
    built = [
        piece
        for piece in solution.pieces
        if piece.category == "building" and np.isfinite([*piece.pose, *piece.size]).all()
    ]
    ground = surfaces(plan.detail, works_of(solution, plan.detail), polygons_of(built))
    return Scene(solution.brief.name, plan.levels, plan.spaces, (), (), solution.pieces, ground, ())
