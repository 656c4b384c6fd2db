"""The referee of extensions: overlaps, what leaves its area, streets built on.

It sees the brief, the areas and the pieces, uses exact polygons, and shares no code with what
places buildings. What stood before is given.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Shapes
from scenewright.check.buildings import (
    find_collisions,
    find_off_ground,
    is_like,
    measure_shared,
    split_sound,
    state_fault,
)
from scenewright.check.owed import ALL, Owed, find_owed
from scenewright.check.owed_uses import list_owed_uses
from scenewright.check.rooms import count_findings
from scenewright.core.catalog import OWN, Catalog
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.report import Finding, Report
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import OLD, AreaPlan, ExtendPlan

STOREY = 3.0
"""Metres of a storey that is added to what is grown."""
VARIED = 0.25
"""The share of its floor by which a variant may differ from its original."""


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
    findings += find_owed([*list_owed(detail, solution.pieces)], solution.left_out)
    figures = {area.id: figures_of(area, detail, sound, shapes) for area in detail.areas}
    found = {**count_findings(solution.pieces, findings), "areas": figures}
    return Report(tuple(findings), (), found)


def list_owed(plan: ExtendPlan, pieces: Sequence[Piece]) -> Iterator[Owed]:
    """The buildings of each area, at least one where it states no number, all of kinds of the
    sources; and none beside those that the brief says stood before."""
    for area in plan.areas:
        known = _list_sizes(area, plan)
        here = [p for p in pieces if p.space == area.id and p.category == "building"]
        count, stay = area.row.count, {row.id for row in area.fixed}
        least = 1 if count is None else max(count, len(stay))
        yield Owed(area.id, "buildings", len(here), least, ALL if count is None else least)
        yield from list_owed_uses(area.id, area.row.uses, here)
        strange = sum(
            not any(size is None or is_like(p, *size, VARIED) for size in known.get(p.function, ()))
            for p in here
            if p.id not in stay
        )
        yield Owed(area.id, "buildings of no source", strange, 0, 0)
    built = [p for p in pieces if p.category == "building"]
    added = sum(p.space == OLD and not p.fixed for p in built)
    yield Owed(OLD, "buildings beside those that stood before", added, 0, 0)


def _list_sizes(area: AreaPlan, plan: ExtendPlan) -> dict[str, list[tuple[float, float] | None]]:
    """Square metres and height of what may be grown in an area, by the names of kinds; ``None``
    where a model of its own or of a catalogue is as large as it is."""
    sizes: dict[str, list[tuple[float, float] | None]] = {}
    for kind in plan.pattern.kinds:
        floor = float(shapely.Polygon(kind.local).area)
        grown = max(kind.size[2] + STOREY * area.row.storeys, STOREY)
        height = grown if area.row.storeys else kind.size[2]
        drawn = area.row.use == "catalogue" or kind.model.startswith(OWN)
        sizes.setdefault(kind.name, []).append(None if drawn else (floor, height))
    return sizes


def find_outside(area: AreaPlan, pieces: Sequence[Piece], shapes: Shapes) -> list[Finding]:
    """Buildings of an area that leave it or stand in a street by more than 1 cm, or stand
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
