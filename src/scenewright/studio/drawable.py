"""What a page needs to draw a scene in plan: plain values, metres, by level.

Symbols are told once each and named by a key, so that a version is little more than poses.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely
from numpy.typing import ArrayLike

from scenewright.catalog.loading import catalog_of
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.report import Finding, Report
from scenewright.core.scene import Piece, Scene, Wall
from scenewright.core.solution import Solution
from scenewright.core.space import Level, Opening, Points, Space
from scenewright.domains import scene_of
from scenewright.drawing.labels import polygon_of
from scenewright.drawing.pieces import drawing_height, hangs, is_drawn, symbol
from scenewright.drawing.shell import CUT_HEIGHT

Json = dict[str, Any]


def draw(solution: Solution, plan: Plan, report: Report) -> Json:
    """Levels with their shell, the symbols, the pieces from the floor up, what was left out and
    what the referee found."""
    scene, catalog = scene_of(solution, plan), catalog_of(solution.brief.catalogs)
    return {
        "name": scene.name,
        "domain": solution.brief.domain,
        "levels": [_level(scene, level) for level in scene.levels],
        **_pieces(scene, catalog),
        "left_out": [
            {"space": out.space, "what": out.what, "reason": out.reason, "required": out.required}
            for out in solution.left_out
        ],
        "valid": report.valid,
        "verdict": str(report),
        "findings": [describe_finding(found) for found in report.findings],
    }


def draw_card(solution: Solution, plan: Plan) -> Json:
    """What a small picture of a layout needs: shell, symbols, and poses (symbol, level, x, y,
    heading), a few kB."""
    scene, catalog = scene_of(solution, plan), catalog_of(solution.brief.catalogs)
    drawn = _pieces(scene, catalog)
    poses = [
        [one["symbol"], one["level"], *(round(one["pose"][k], 3) for k in (0, 1, 3))]
        for one in drawn["pieces"]
        if not one["hangs"]
    ]
    levels = [_level(scene, level) for level in scene.levels]
    return {"levels": levels, "symbols": drawn["symbols"], "pieces": poses}


def _pieces(scene: Scene, catalog: Catalog) -> Json:
    """The pieces of a scene from the floor up, and the symbols they are drawn by."""
    levels = {space.id: space.level for space in scene.spaces}
    first = scene.levels[0].id if scene.levels else ""
    shown = [piece for piece in scene.pieces if is_drawn(piece, catalog.kinds)]
    shown.sort(key=lambda piece: drawing_height(piece, catalog.kinds))
    symbols: dict[str, list[list[list[float]]]] = {}
    pieces = [_piece(p, levels.get(p.space, first), catalog, symbols) for p in shown]
    return {"symbols": symbols, "pieces": pieces}


def describe_finding(found: Finding) -> Json:
    """A finding as the page lists it: what is at fault, where, and in what words."""
    return {
        "kind": found.kind,
        "space": found.space,
        "pieces": [name for name in (found.piece, *found.other.split(",")) if name],
        "message": found.message,
        "blamed": found.is_blamed,
        "level": found.level,
        "polygons": found.polygons,
        "points": found.points,
    }


def _points(points: ArrayLike) -> list[list[float]]:
    found: list[list[float]] = np.round(np.asarray(points, np.float64), 3).tolist()
    return found


def _level(scene: Scene, level: Level) -> Json:
    spaces = [space for space in scene.spaces if space.level == level.id]
    here = {space.id for space in spaces}
    return {
        "id": level.id,
        "name": level.name,
        "elevation": level.elevation,
        "spaces": [_space(space) for space in spaces],
        "walls": [row for wall in scene.walls if wall.level == level.id for row in _wall(wall)],
        "openings": [_opening(one) for one in scene.openings if one.level == level.id],
        "surfaces": [
            {
                "kind": one.kind,
                "rings": [_points(ring) for outer, inner in one.areas for ring in (outer, *inner)],
            }
            for one in scene.surfaces
            if one.space in here or len(scene.levels) == 1
        ],
    }


def _rings(area: tuple[Points, tuple[Points, ...]]) -> tuple[Points, ...]:
    outer, inner = area
    return (outer, *inner)


def _space(space: Space) -> Json:
    rings = [_points(ring) for ring in (space.outline, *space.holes)]
    roomy = shapely.maximum_inscribed_circle(polygon_of(space), tolerance=0.05)
    return {"id": space.id, "name": space.name, "rings": rings, "label": _points(roomy.coords)[0]}


def _wall(wall: Wall) -> list[Json]:
    """Prisms that the plan's cut goes through, and those below it as low walls."""
    return [
        {
            "rings": [_points(ring) for ring in (prism.outline, *prism.holes)],
            "low": bool(prism.top <= CUT_HEIGHT),
        }
        for prism in wall.prisms
        if prism.base < CUT_HEIGHT
    ]


def _opening(one: Opening) -> Json:
    numbers = (one.x, one.y, one.ux, one.uy, one.width, one.thickness)
    x, y, ux, uy, width, thickness = (round(float(number), 4) for number in numbers)
    frame = {"at": [x, y], "along": [ux, uy], "width": width, "thickness": thickness}
    return frame | {"kind": one.kind, "hinge": one.hinge, "swing": one.swing}


def _piece(piece: Piece, level: str, catalog: Catalog, symbols: Json) -> Json:
    size = [round(float(side), 4) for side in piece.size]
    key = "|".join(map(str, (piece.asset, piece.category, *size, piece.footprint)))
    if key not in symbols:
        symbols[key] = [_points(line) for line in symbol(piece, catalog)]
    kind = catalog.kinds.get(piece.category)
    return {
        "id": piece.id,
        "name": kind.name if kind else piece.category,
        "category": piece.category,
        "space": piece.space,
        "level": level,
        "pose": [round(float(number), 5) for number in piece.pose],
        "size": size,
        "symbol": key,
        "locked": piece.fixed,
        "flat": bool(kind and kind.flat),
        "hangs": bool(hangs(piece)),
    }
