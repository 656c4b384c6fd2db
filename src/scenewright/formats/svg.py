"""A plan to print: SVG 1.1 to scale, in millimetres, levels side by side.

Cut at 1.2 m: walls solid, windows and doors by their symbols, furniture by the symbols of its
assets, room names and areas, dimension chains, scale bar, north arrow and title block. The file
holds no script, no style sheet, no image and no font; names are escaped.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from shapely import Geometry, Polygon, union_all

from scenewright.catalog import Catalog
from scenewright.formats import svg_dimensions as dimensions
from scenewright.formats import svg_sheet as sheets
from scenewright.formats.svg_doors import doors_mark
from scenewright.formats.svg_labels import area_words, labels_mark, polygon_of
from scenewright.formats.svg_marks import INK, clean, group, tag, text, title
from scenewright.formats.svg_pieces import footprint, hangs, pieces_mark
from scenewright.formats.svg_shell import (
    cut_walls,
    floors,
    openings_mark,
    swing_square,
    tile_pattern,
    walls_mark,
)  # fmt: skip
from scenewright.scene import Piece, Scene
from scenewright.solution import Solution
from scenewright.space import Level

CAPTION = 8.0
"""Millimetres below a level's plan for its name."""


class Storey(NamedTuple):
    """One level's part of a scene, with its outer bounds and dimension chains."""

    level: Level
    scene: Scene
    walls: Geometry
    bounds: dimensions.Bounds
    chains: dict[dimensions.Side, list[dimensions.Chain]]


def write(solution: Solution, path: str | os.PathLike[str]) -> None:
    """Write the plan of a solution to ``path``; the file appears whole or not at all."""
    from scenewright.assets import shipped
    from scenewright.shell import scene_of

    final = Path(path)
    partial = final.with_name(f".{final.name}.partial")
    partial.write_text(plan(scene_of(solution), shipped()), encoding="utf-8")
    os.replace(partial, final)


def plan(scene: Scene, catalog: Catalog) -> str:
    """The SVG text of a scene's plan."""
    storeys = [storey for level in scene.levels if (storey := _storey(scene, level))]
    margins = [dimensions.margins(storey.chains) for storey in storeys]
    wide = sum(s.bounds[2] - s.bounds[0] for s in storeys)
    high = max((s.bounds[3] - s.bounds[1] for s in storeys), default=1.0)
    extra_wide = sum(m["west"] + m["east"] for m in margins)
    extra_high = max((m["south"] + m["north"] for m in margins), default=0.0) + CAPTION
    sheet = sheets.choose(wide, high, extra_wide, extra_high)
    marks = [sheets.sheet_mark(sheet, scene.name, _summary(scene))]
    room_wide, room_high = sheets.drawing_area(sheet)
    spare = (room_wide - wide * 1000 / sheet.scale - extra_wide) / (len(storeys) + 1)
    below = max((m["south"] for m in margins), default=0.0)
    bottom = sheets.EDGE + room_high - CAPTION - below
    bottom -= (room_high - high * 1000 / sheet.scale - extra_high) / 2
    left = sheets.EDGE
    for storey, margin in zip(storeys, margins, strict=True):
        left += spare + margin["west"]
        marks.append(_storey_mark(storey, catalog, sheet, left, bottom, below))
        left += (storey.bounds[2] - storey.bounds[0]) * 1000 / sheet.scale + margin["east"]
    return _document(sheet, scene.name, marks)


def _storey(scene: Scene, level: Level) -> Storey | None:
    """What belongs to a level; ``None`` if nothing does."""
    spaces = tuple(space for space in scene.spaces if space.level == level.id)
    walls = tuple(wall for wall in scene.walls if wall.level == level.id)
    ids = {space.id for space in spaces}
    part = Scene(
        scene.name, (level,), spaces, walls,
        tuple(opening for opening in scene.openings if opening.level == level.id),
        tuple(piece for piece in scene.pieces if piece.space in ids),
    )  # fmt: skip
    drawn = [Polygon(prism.outline) for wall in walls for prism in wall.prisms]
    everything = union_all([*drawn, *(polygon_of(space) for space in spaces)])
    if everything.is_empty:
        return None
    west, south, east, north = map(float, everything.bounds)
    bounds = (west, south, east, north)
    cut = cut_walls(walls)
    solid = union_all([cut, *(polygon_of(space) for space in spaces)])
    return Storey(level, part, cut, bounds, dimensions.chains(bounds, solid, spaces, part.openings))


def _storey_mark(
    storey: Storey, catalog: Catalog, sheet: sheets.Sheet, left: float, bottom: float, below: float
) -> str:
    view = sheets.view_at(sheet, storey.bounds[0], storey.bounds[1], left, bottom)
    part = storey.scene
    marks = [
        tag("defs", tile_pattern(view)),
        floors(view, part.spaces),
        pieces_mark(view, part.pieces, catalog),
        walls_mark(view, part.walls),
        openings_mark(view, part.openings),
        doors_mark(view, part.openings, notes=False),
        labels_mark(view, part.spaces, _busy(part, catalog)),
        dimensions.chains_mark(view, storey.bounds, storey.chains),
        _caption(storey, (left + (storey.bounds[2] - storey.bounds[0]) * view.scale / 2,
                          bottom + below + CAPTION / 2)),
    ]  # fmt: skip
    return group(marks)


def _busy(part: Scene, catalog: Catalog) -> list[Geometry]:
    """What the label of each space should not cover: standing pieces, edges of rugs, swings."""
    swings = [s for opening in part.openings if (s := swing_square(opening)) is not None]
    covered = [_covered(part.pieces, space.id, catalog) for space in part.spaces]
    return [union_all([*shapes, *swings]) for shapes in covered]


def _covered(pieces: Sequence[Piece], space: str, catalog: Catalog) -> list[Geometry]:
    here = [piece for piece in pieces if piece.space == space and not hangs(piece)]
    shapes = [(piece, Polygon(footprint(piece))) for piece in here]
    return [
        shape.boundary.buffer(0.04) if _flat(piece.category, catalog) else shape
        for piece, shape in shapes
    ]


def _flat(category: str, catalog: Catalog) -> bool:
    kind = catalog.kinds.get(category)
    return kind is not None and kind.flat


def _caption(storey: Storey, at: tuple[float, float]) -> str:
    floor = area_words(sum(polygon_of(space).area for space in storey.scene.spaces))
    level = storey.level
    height = f"{level.elevation:+.2f}" if level.elevation else "±0.00"
    return text(" · ".join([*level_name(level), height, floor]), at, 2.3, fill=INK)


def level_name(level: Level) -> list[str]:
    """The name of a storey; none if it only has a number.

    >>> level_name(Level("0", "0", 0.0, 2.6)), level_name(Level("0", "Ground floor", 0.0, 2.6))
    ([], ['Ground floor'])
    """
    name = clean(level.name, 30)
    told = name if name != level.id or re.search(r"[^\W\d_]{2}", name) else ""
    return [told] if told else []


def _summary(scene: Scene) -> str:
    total = area_words(sum(polygon_of(space).area for space in scene.spaces))
    rooms, pieces = _counted(len(scene.spaces), "room"), _counted(len(scene.pieces), "piece")
    return f"Furnished plan · {rooms} · {total} floor area · {pieces}"


def _counted(count: int, word: str) -> str:
    return f"{count} {word}" if count == 1 else f"{count} {word}s"


def _document(sheet: sheets.Sheet, name: str, marks: Sequence[str]) -> str:
    paper = tag("rect", width=sheet.width, height=sheet.height, fill="#ffffff")
    content = "\n".join([title(name), paper, *marks])
    body = tag(
        "svg", f"\n{content}\n",
        xmlns="http://www.w3.org/2000/svg", version="1.1",
        width=f"{sheet.width:g}mm", height=f"{sheet.height:g}mm",
        viewBox=f"0 0 {sheet.width:g} {sheet.height:g}",
        font_family="Helvetica, Arial, 'DejaVu Sans', sans-serif",
    )  # fmt: skip
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{body}\n'
