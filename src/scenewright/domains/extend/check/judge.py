"""The referee of extensions: overlaps, what leaves its area, streets built on.

It sees the brief, the areas and the pieces, uses exact polygons, and shares no code with what
places buildings. What stood before is given.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Shape, Shapes
from scenewright.check.rooms import count_findings
from scenewright.core.catalog import Catalog
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.report import Finding, Report
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import OLD, AreaPlan, ExtendPlan

LARGEST = 1e5


def check(solution: Solution, plan: Plan, kinds: Catalog) -> Report:
    """Judge the buildings of every area; see :func:`scenewright.domains.check`. Buildings have no
    ``kinds``."""
    del kinds
    detail: ExtendPlan = plan.detail
    known = {OLD, *(area.id for area in detail.areas)}
    findings, sound = [], []
    for piece in solution.pieces:
        fault = _fault(piece, known)
        if fault:
            told = f"{piece.id or 'a piece'} {fault}"
            findings.append(
                Finding("malformed", "", piece.space, piece.id, "", told, given=piece.fixed)
            )
        elif piece.category == "building":
            sound.append(piece)
    shapes = polygons_of(sound)
    findings += find_overlaps(sound, shapes)
    for area in detail.areas:
        findings += find_outside(area, sound, shapes)
    figures = {area.id: figures_of(area, detail, sound, shapes) for area in detail.areas}
    found = {**count_findings(solution.pieces, findings), "areas": figures}
    return Report(tuple(findings), (), found)


def _fault(piece: Piece, known: set[str]) -> str:
    """What is wrong with a piece that cannot be judged; empty if it can."""
    values = np.array([*piece.pose, *piece.size], float)
    if not np.isfinite(values).all() or np.abs(values).max() > LARGEST:
        return "has a pose or size that is not a number of metres"
    if (values[4:] <= 0).any():
        return f"has no size: {values[4]:g} x {values[5]:g} x {values[6]:g} m"
    return "" if piece.space in known else f"stands in {piece.space!r}, which is not an area"


def find_overlaps(pieces: Sequence[Piece], shapes: Shapes) -> list[Finding]:
    """Pairs that share more than a wall: an area more than 1 cm thick."""
    found: list[Finding] = []
    if len(pieces) < 2:
        return found
    i, j = shapely.STRtree(shapes).query(shapes, predicate="intersects")
    for a, b in sorted((int(a), int(b)) for a, b in zip(i, j, strict=True) if a < b):
        depth, area = _thickness(shapely.intersection(shapes[a], shapes[b]))
        one, other = pieces[a], pieces[b]
        if depth > TOLERANCE:
            told = f"{one.id} and {other.id} overlap by {depth:.2f} m ({area:.2f} m²)"
            given = one.fixed and other.fixed
            found.append(_finding("collision", one, told, depth, area, other.id, given))
    return found


def _thickness(shared: Shape) -> tuple[float, float]:
    """The short side of the least rectangle about a shape, and its area; 0 where it holds none."""
    area = float(shared.area)
    if area <= TOLERANCE**2:
        return 0.0, area
    frame = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shared))
    return float(np.hypot(*np.diff(frame[:3], axis=0).T).min()), area


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
            depth, size = _thickness(shapely.difference(shape, area.outline))
            told = f"{piece.id} is {depth:.2f} m ({size:.2f} m²) outside {area.id}"
            if depth > TOLERANCE:
                found.append(_finding("out_of_bounds", piece, told, depth, size))
        depth, size = _thickness(shapely.intersection(shape, streets))
        if depth > TOLERANCE:
            told = f"{piece.id} stands in a street by {depth:.2f} m ({size:.2f} m²)"
            found.append(_finding("blocked_path", piece, told, depth, size))
        if abs(piece.pose.z) > 0.02:
            kind = "floating" if piece.pose.z > 0 else "sunk"
            told = f"{piece.id} stands {piece.pose.z:+.2f} m off the ground"
            found.append(_finding(kind, piece, told, abs(piece.pose.z)))
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


def _finding(
    kind: str,
    piece: Piece,
    told: str,
    amount: float = 0.0,
    area: float = 0.0,
    other: str = "",
    given: bool | None = None,
) -> Finding:
    chosen = piece.fixed if given is None else given
    return Finding(
        kind, "", piece.space, piece.id, other, told, round(amount, 4), round(area, 4), bool(chosen)
    )
