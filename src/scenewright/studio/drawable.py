"""What a page needs to draw a scene in plan: plain values, metres, by level.

Symbols are told once each and named by a key, so that a version is little more than poses.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np
import shapely
from numpy.typing import ArrayLike

from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
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
from scenewright.studio.shapes import Json, Shapes

LOOKS = ("name", "category", "size", "flat", "rise")
"""What a piece has in common with all of its model and size."""


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


def draw_card(solution: Solution, plan: Plan, shapes: Shapes) -> Json:
    """What a small picture of a layout needs: its shell, and poses from the floor up (key of the
    symbol, number of the level, x, y, heading), a few kB."""
    scene, catalog = scene_of(solution, plan), catalog_of(solution.brief.catalogs)
    drawn = _pieces(scene, catalog)
    keys = _keep_symbols(drawn, shapes)
    numbers = {level.id: number for number, level in enumerate(scene.levels)}
    poses = [
        [keys[one["symbol"]], numbers[one["level"]], *_shorten(one["pose"][k] for k in (0, 1, 3))]
        for one in drawn["pieces"]
        if not one["hangs"]
    ]
    return {"levels": [_level(scene, level) for level in scene.levels], "pieces": poses}


def tell_by_key(state: Json, shapes: Shapes) -> Json:
    """A state with its symbols by key: of each piece an ``id``, what it ``is``, where it is ``at``
    and no more, in an order that does not change when it moves.

    >>> piece = {"id": "a", "name": "rug", "category": "rug", "space": "", "level": "0",
    ...          "pose": [1.0, 2.0, 0.0, 0.0], "size": [1, 1, 1], "symbol": "s", "locked": False,
    ...          "flat": True, "hangs": False, "rise": 0.0}
    >>> tell_by_key({"pieces": [piece], "symbols": {"s": []}}, Shapes())["pieces"]
    [{'id': 'a', 'is': '77lQO5T5', 'at': [1, 2, 0, 0]}]
    """
    if "symbols" not in state:
        return state
    keys = _keep_symbols(state, shapes)
    rows = sorted(state["pieces"], key=lambda one: str(one["id"]))
    told = [_tell_piece(one, keys[one["symbol"]]) for one in rows]
    return {k: v for k, v in state.items() if k != "symbols"} | {"pieces": told}


def _tell_piece(one: Json, key: str) -> Json:
    row = {"id": one["id"], "is": key, "at": _shorten(one["pose"])}
    if one["space"] != one["id"].rpartition("/")[0].partition("/")[0]:
        row["in"] = one["space"]
    return row | {flag: True for flag in ("locked", "hangs") if one[flag]}


def _keep_symbols(drawn: Json, shapes: Shapes) -> dict[str, str]:
    """The keys of the symbols of drawn pieces."""
    looks = {one["symbol"]: {name: one[name] for name in LOOKS} for one in drawn["pieces"]}
    lines = drawn["symbols"]
    return {name: shapes.add_symbol(look | {"lines": lines[name]}) for name, look in looks.items()}


def _shorten(numbers: Iterable[float]) -> list[float]:
    """Tenths of a millimetre; whole numbers without a point."""
    found = (round(number, 4) for number in numbers)
    return [int(number) if number == int(number) else number for number in found]


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


def _points(points: ArrayLike, decimals: int = 3) -> list[list[float]]:
    found: list[list[float]] = np.round(np.asarray(points, np.float64), decimals).tolist()
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
                "rings": [_points(r, 2) for outer, inner in one.areas for r in (outer, *inner)],
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
        "rise": _rise(piece, catalog),
    }


def _rise(piece: Piece, catalog: Catalog) -> float:
    """How far above its underside a piece counts as drawn, below the cut."""
    low = replace(piece, pose=piece.pose._replace(z=0.0))
    return round(drawing_height(low, catalog.kinds), 3)


def tell_reading(brief: Brief) -> list[Json]:
    """What became of the features of the file that a brief was read from, a row each; ``lost`` is
    what stands there and is missing now. Nothing where no reader said."""
    report = brief.input_report
    rows = report.rows if report else []
    lost = report.lost if report else ()
    return [{"text": f"{row.kind}: {row.describe()}", "lost": row in lost} for row in rows]
