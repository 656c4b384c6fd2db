"""A plan to print: SVG 1.1 to scale, in millimetres, levels side by side.

Cut at 1.2 m: walls solid, windows and doors by their symbols, furniture by the symbols of its
assets, room names and areas, dimension chains, scale bar, north arrow and title block. The file
holds no script, no style sheet, no image and no font; names are escaped.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from typing import NamedTuple

from shapely import Geometry, Polygon, union_all

from scenewright.catalog import Catalog
from scenewright.ceiling import living_area_of
from scenewright.formats import svg_dimensions as dimensions
from scenewright.formats import svg_sheet as sheets
from scenewright.formats import svg_site
from scenewright.formats.svg_doors import doors_mark
from scenewright.formats.svg_hall_rows import legend_rows
from scenewright.formats.svg_halls import (
    Halls,
    floor_mark,
    halls_of,
    labelled,
    part_of,
    route_of,
    solid_of,
    ways_mark,
)  # fmt: skip
from scenewright.formats.svg_labels import area_words, labels_mark, polygon_of
from scenewright.formats.svg_legend import arrange, legend_mark
from scenewright.formats.svg_marks import INK, View, clean, group, tag, text
from scenewright.formats.svg_outlets import outlets_mark
from scenewright.formats.svg_pieces import Symbols, footprint, hangs, pieces_mark, repeated
from scenewright.formats.svg_shell import (
    cut_walls,
    floors,
    openings_mark,
    partition_walls,
    roof_windows,
    swing_square,
    tile_pattern,
    walls_mark,
)  # fmt: skip
from scenewright.formats.svg_slopes import low_lines, slopes_mark
from scenewright.formats.svg_stairs import stairs_mark
from scenewright.formats.svg_turning import Turns, turning_mark, turning_of
from scenewright.scene import Piece, Scene
from scenewright.solution import Solution
from scenewright.space import Level
from scenewright.whole_file import write_whole

CAPTION = 8.0
"""Millimetres below a level's plan for its name."""


class Storey(NamedTuple):
    """One level's part of a scene, with its outer bounds and dimension chains."""

    level: Level
    scene: Scene
    walls: Geometry
    bounds: dimensions.Bounds
    chains: dict[dimensions.Side, list[dimensions.Chain]]
    halls: Halls | None
    solid: Geometry


class Paper(NamedTuple):
    """What all storeys are drawn with."""

    catalog: Catalog
    sheet: sheets.Sheet
    symbols: Symbols
    turns: Turns


def write(solution: Solution, path: str | os.PathLike[str]) -> None:
    """Write the plan of a solution to ``path``; the file appears whole or not at all."""
    from scenewright.shell import scene_of
    from scenewright.stock import catalog_of

    if solution.brief.domain == "site":
        svg_site.write(solution, path)
        return
    catalog = catalog_of(solution.brief.catalogs)
    turns = turning_of(solution)
    write_whole(path, plan(scene_of(solution), catalog, halls_of(solution), turns))


def plan(
    scene: Scene, catalog: Catalog, halls: Halls | None = None, turns: Turns | None = None
) -> str:
    """The SVG text of a scene's plan, with the zones, groups and tours of its halls, and where
    wheelchairs turn."""
    found = [_storey(scene, level, catalog, halls) for level in scene.levels]
    storeys = [storey for storey in found if storey is not None]
    margins = [dimensions.margins(storey.chains) for storey in storeys]
    wide = sum(s.bounds[2] - s.bounds[0] for s in storeys)
    high = max((s.bounds[3] - s.bounds[1] for s in storeys), default=1.0)
    extra_wide = sum(m["west"] + m["east"] for m in margins)
    extra_high = max((m["south"] + m["north"] for m in margins), default=0.0) + CAPTION
    solids = {space.id: storey.solid for storey in storeys for space in storey.scene.spaces}
    rows = legend_rows(halls, scene, solids) if halls else ()
    arranged = arrange((wide, high), (extra_wide, extra_high), rows)
    sheet, (room_wide, room_high) = arranged.sheet, arranged.room
    symbols = repeated(1000 / sheet.scale, scene.pieces, catalog)
    paper = Paper(catalog, sheet, symbols, turns or {})
    summary = _summary(scene, halls)
    marks = [paper_defs(paper), sheets.sheet_mark(sheet, scene.name, summary)]
    spare = (room_wide - wide * 1000 / sheet.scale - extra_wide) / (len(storeys) + 1)
    below = max((m["south"] for m in margins), default=0.0)
    bottom = sheets.EDGE + room_high - CAPTION - below
    bottom -= (room_high - high * 1000 / sheet.scale - extra_high) / 2
    left = sheets.EDGE
    for storey, margin in zip(storeys, margins, strict=True):
        left += spare + margin["west"]
        marks.append(_storey_mark(storey, paper, left, bottom, below))
        left += (storey.bounds[2] - storey.bounds[0]) * 1000 / sheet.scale + margin["east"]
    return sheets.document(sheet, scene.name, [*marks, legend_mark(arranged)])


def _storey(scene: Scene, level: Level, catalog: Catalog, halls: Halls | None) -> Storey | None:
    """What belongs to a level; ``None`` if nothing does."""
    spaces = tuple(space for space in scene.spaces if space.level == level.id)
    walls = tuple(wall for wall in scene.walls if wall.level == level.id)
    ids = {space.id for space in spaces}
    part = Scene(
        scene.name, (level,), spaces, walls,
        tuple(opening for opening in scene.openings if opening.level == level.id),
        tuple(piece for piece in scene.pieces if piece.space in ids), (), scene.stairs,
    )  # fmt: skip
    drawn = [Polygon(prism.outline) for wall in walls for prism in wall.prisms]
    everything = union_all([*drawn, *(polygon_of(space) for space in spaces)])
    if everything.is_empty:
        return None
    west, south, east, north = map(float, everything.bounds)
    bounds = (west, south, east, north)
    cut = cut_walls(walls)
    solid = union_all([cut, *(polygon_of(space) for space in spaces)])
    chains = dimensions.chains(bounds, solid, spaces, part.openings)
    mine = part_of(halls, ids) if halls else None
    body = solid_of(cut, part.pieces, catalog) if halls else Polygon()
    return Storey(level, part, cut, bounds, chains, mine, body)


def paper_defs(paper: Paper) -> str:
    """What is defined once: floor tiles and the symbols that occur more than once."""
    view = View(1000 / paper.sheet.scale, 0.0, 0.0)
    return tag("defs", "\n".join([tile_pattern(view), *paper.symbols.definitions]))


def _storey_mark(
    storey: Storey, paper: Paper, left: float, bottom: float, below: float
) -> str:  # fmt: skip
    view = sheets.view_at(paper.sheet, storey.bounds[0], storey.bounds[1], left, bottom)
    part, halls = storey.scene, storey.halls
    west, south, east, north = storey.bounds
    middle = (west + east) / 2, (south + north) / 2
    marks = [
        floors(view, part.spaces),
        floor_mark(view, halls, storey.walls, part.pieces) if halls else "",
        stairs_mark(view, part.stairs, storey.level.id, part.spaces),
        pieces_mark(view, part.pieces, paper.catalog, paper.symbols),
        turning_mark(view, [paper.turns[s.id] for s in part.spaces if s.id in paper.turns]),
        slopes_mark(
            view,
            part.spaces,
            union_all([*_covered(part.pieces, paper.catalog), *roof_windows(part.openings)]),
        ),
        walls_mark(view, (*part.walls, *partition_walls(part.pieces))),
        openings_mark(view, part.openings),
        outlets_mark(view, part.spaces),
        doors_mark(view, part.openings, middle if halls else None),
        ways_mark(view, halls, storey.solid) if halls else "",
        _labels(view, storey, paper.catalog),
        dimensions.chains_mark(view, storey.bounds, storey.chains),
        _caption(storey, (left + (east - west) * view.scale / 2, bottom + below + CAPTION / 2)),
    ]
    return group(marks)


def _labels(view: View, storey: Storey, catalog: Catalog) -> str:
    """Names of rooms and zones off the furniture, doors' swings and routes."""
    part, halls = storey.scene, storey.halls
    named = labelled(halls, part.spaces) if halls else [(s, "#ffffff") for s in part.spaces]
    over = [s for opening in part.openings if (s := swing_square(opening)) is not None]
    if halls:
        over.append(route_of(halls).buffer(2.0 / view.scale))
    over += [line for space in part.spaces for line in low_lines(view, space)]
    covered = union_all([*_covered(part.pieces, catalog), *over])
    spaces, halos = zip(*named, strict=True) if named else ((), ())
    return labels_mark(view, spaces, [covered] * len(named), halos)


def _covered(pieces: Sequence[Piece], catalog: Catalog) -> list[Geometry]:
    """What stands on the floor, and the edges of rugs."""
    here = [piece for piece in pieces if not hangs(piece)]
    shapes = [(piece, Polygon(footprint(piece))) for piece in here]
    return [
        shape.boundary.buffer(0.04) if _flat(piece.category, catalog) else shape
        for piece, shape in shapes
    ]


def _flat(category: str, catalog: Catalog) -> bool:
    kind = catalog.kinds.get(category)
    return kind is not None and kind.flat


def _caption(storey: Storey, at: tuple[float, float]) -> str:
    spaces, level = storey.scene.spaces, storey.level
    floor = area_words(sum(polygon_of(space).area for space in spaces))
    if any(space.slopes for space in spaces):
        floor += f" · {area_words(sum(map(living_area_of, spaces)))} living area"
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


def _summary(scene: Scene, halls: Halls | None) -> str:
    total = area_words(sum(polygon_of(space).area for space in scene.spaces))
    if halls is None:
        rooms, pieces = _counted(len(scene.spaces), "room"), _counted(len(scene.pieces), "piece")
        return f"Furnished plan · {rooms} · {total} floor area · {pieces}"
    objects = sum(piece.category != "partition" for piece in scene.pieces)
    counts = (len(halls.graph.zones), "zone"), (len(halls.graph.groups), "group")
    told = [_counted(*count) for count in (*counts, (objects, "object"))]
    return " · ".join(["Hall plan", total, *told])


def _counted(count: int, word: str) -> str:
    return f"{count} {word}" if count == 1 else f"{count} {word}s"
