"""The referee of extensions: overlaps, what leaves its area, streets built on.

It sees the brief, the areas and the pieces, uses exact polygons, and shares no code with what
places buildings. What stood before is given.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Shapes
from scenewright.check.buildings import (
    find_collisions,
    find_off_ground,
    measure_shared,
    split_sound,
    state_fault,
)
from scenewright.check.rooms import count_findings
from scenewright.core.catalog import Catalog
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.report import Finding, Report
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import OLD, AreaPlan, ExtendPlan


def check(solution: Solution, plan: Plan, kinds: Catalog) -> Report:
    """Judge the buildings of every area; see :func:`scenewright.domains.check`. Buildings have no
    ``kinds``."""
    del kinds
    detail: ExtendPlan = plan.detail
    known = {OLD, *(area.id for area in detail.areas)}
    findings, sound = split_sound(solution.pieces, known, "an area")
    shapes = polygons_of(sound)
    findings += find_collisions(sound, shapes)
    for area in detail.areas:
        findings += find_outside(area, sound, shapes)
    figures = {area.id: figures_of(area, detail, sound, shapes) for area in detail.areas}
    found = {**count_findings(solution.pieces, findings), "areas": figures}
    return Report(tuple(findings), (), found)


def find_outside(area: AreaPlan, pieces: Sequence[Piece], shapes: Shapes) -> list[Finding]:
    """Buildings of an area of which more than 1 cm leaves it or stands in a street, or that stand
    off the ground."""
    found = []
    wider = shapely.buffer(area.outline, TOLERANCE, join_style="mitre")
    streets = shapely.union_all(
        [
            shapely.buffer(shapely.LineString(road.line), road.width / 2, cap_style="flat")
            for road in area.roads
        ]
    )
    for piece, shape in zip(pieces, shapes, strict=True):
        if piece.space != area.id:
            continue
        if not shapely.covers(wider, shape):
            depth, size = measure_shared(shapely.difference(shape, area.outline))
            message = f"{piece.id} is {depth:.2f} m ({size:.2f} m²) outside {area.id}"
            if depth > TOLERANCE:
                found.append(state_fault("out_of_bounds", piece, message, depth, size))
        depth, size = measure_shared(shapely.intersection(shape, streets))
        if depth > TOLERANCE:
            message = f"{piece.id} stands in a street by {depth:.2f} m ({size:.2f} m²)"
            found.append(state_fault("blocked_path", piece, message, depth, size))
        found += find_off_ground(piece)
    return found


def figures_of(
    area: AreaPlan, plan: ExtendPlan, pieces: Sequence[Piece], shapes: Shapes
) -> dict[str, Any]:
    """Figures of an area: metres and square metres, shares in [0, 1]."""
    rows = [k for k, piece in enumerate(pieces) if piece.space == area.id]
    mine = shapes[rows] if rows else np.empty(0, object)
    covered = float(shapely.union_all(mine).intersection(area.outline).area) if rows else 0.0
    gap = None
    if rows and len(shapes) > 1:
        i, away = shapely.STRtree(shapes).query_nearest(
            mine, exclusive=True, return_distance=True, all_matches=False
        )
        del i
        gap = round(float(np.median(away)), 2)
    kinds = {pieces[k].function for k in rows}
    return {
        "buildings": len(rows),
        "area": round(float(area.outline.area), 2),
        "coverage": round(covered / float(area.outline.area), 4),
        "source_coverage": round(plan.pattern.coverage, 4),
        "kinds": len(kinds),
        "median_gap": gap,
        "streets_continued": len(area.continued),
    }
