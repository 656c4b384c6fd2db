"""A plan of rooms to print, to scale, in millimetres, levels side by side.

Cut at 1.2 m: walls solid, windows and doors by their symbols, furniture by the symbols of its
assets, room names and areas, dimension chains, scale bar, north arrow and title block.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NamedTuple

from shapely import Geometry, Polygon, union_all

from scenewright.building.ceiling import living_area_of
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece, Scene
from scenewright.core.space import Level, Space
from scenewright.drawing import dimensions as dimensions
from scenewright.drawing import sheet as sheets
from scenewright.drawing.doors import doors_mark, heights_mark, triangle_places
from scenewright.drawing.labels import Floor, labels_mark, polygon_of
from scenewright.drawing.layers import PlanDrawing, PlanLayer, merge_layers
from scenewright.drawing.legend import Arrangement, LegendRow, arrange, legend_mark
from scenewright.drawing.marks import INK, Definition, Mark, PaperView, clean, group, text
from scenewright.drawing.outlets import outlets_mark
from scenewright.drawing.pieces import (
    Symbols,
    define_repeated_symbols,
    footprint,
    hangs,
    pieces_mark,
)
from scenewright.drawing.shafts import shaft_pattern, shafts_mark
from scenewright.drawing.shell import (
    FLOOR,
    cut_walls,
    floors,
    low_walls,
    openings_mark,
    partition_walls,
    roof_windows,
    swing_square,
    tile_pattern,
    walls_mark,
)
from scenewright.drawing.slopes import low_lines, slopes_mark
from scenewright.drawing.stairs import stairs_mark
from scenewright.drawing.wordings import area_words

CAPTION = 8.0
"""Millimetres below a level's plan for its name."""


Arrange = Callable[[tuple[float, float], tuple[float, float], Sequence[LegendRow]], Arrangement]


class Storey(NamedTuple):
    """One level's part of a scene, with its outer bounds, doors that swing out included, and its
    dimension chains, of the building alone."""

    level: Level
    scene: Scene
    walls: Geometry
    bounds: dimensions.Bounds
    chains: dict[dimensions.Side, list[dimensions.DimensionChain]]


def _nothing(view: PaperView, storey: Storey) -> Sequence[PlanLayer]:
    del view, storey
    return ()


def _keep_nothing(view: PaperView, storey: Storey) -> list[Geometry]:
    del view, storey
    return []


def _plain_labels(storey: Storey) -> list[tuple[Space, str]]:
    return [(space, FLOOR) for space in storey.scene.spaces]


def _as_usual(sheet: sheets.PaperSheet) -> float:
    del sheet
    return 1.0


def _no_rows(scene: Scene, storeys: Sequence[Storey]) -> Sequence[LegendRow]:
    del scene, storeys
    return ()


def furnished_summary(scene: Scene) -> str:
    """The line below the title: rooms, floor area, pieces."""
    rooms, pieces = count_words(len(scene.spaces), "room"), count_words(len(scene.pieces), "piece")
    return f"Furnished plan · {rooms} · {_total_area(scene)} floor area · {pieces}"


class Overlay(NamedTuple):
    """What a domain adds to the plan of its rooms.

    ``floor`` are layers under the furniture, ``over`` above it, ``ways`` above walls and doors,
    each of a storey; ``keep_off`` are shapes that names of rooms do not cover; ``labels`` what is
    named, with the colour around the words; ``legend`` the rows of the legend; ``summary`` the line
    below the title; ``arrange`` chooses the sheet, ``enlarge`` how large
    names of rooms are on it at best; ``inward`` whether the triangles at doors point
    to the middle of the storey; ``title`` the number of the sheet and its date.
    """

    floor: Callable[[PaperView, Storey], Sequence[PlanLayer]] = _nothing
    over: Callable[[PaperView, Storey], Sequence[PlanLayer]] = _nothing
    ways: Callable[[PaperView, Storey], Sequence[PlanLayer]] = _nothing
    keep_off: Callable[[PaperView, Storey], list[Geometry]] = _keep_nothing
    labels: Callable[[Storey], list[tuple[Space, str]]] = _plain_labels
    legend: Callable[[Scene, Sequence[Storey]], Sequence[LegendRow]] = _no_rows
    summary: Callable[[Scene], str] = furnished_summary
    arrange: Arrange = arrange
    enlarge: Callable[[sheets.PaperSheet], float] = _as_usual
    inward: bool = False
    title: sheets.TitleBlock = sheets.UNDATED


class Paper(NamedTuple):
    """The settings all storeys are drawn with."""

    catalog: Catalog
    sheet: sheets.PaperSheet
    symbols: Symbols
    overlay: Overlay


def plan(scene: Scene, catalog: Catalog, overlay: Overlay | None = None) -> PlanDrawing:
    """A scene's plan, with what its domain adds."""
    overlay = overlay or Overlay()
    found = [_storey(scene, level) for level in scene.levels]
    storeys = [storey for storey in found if storey is not None]
    margins = [dimensions.margins(storey.chains) for storey in storeys]
    wide = sum(s.bounds[2] - s.bounds[0] for s in storeys)
    high = max((s.bounds[3] - s.bounds[1] for s in storeys), default=1.0)
    extra_wide = sum(m["west"] + m["east"] for m in margins)
    extra_high = max((m["south"] + m["north"] for m in margins), default=0.0) + CAPTION
    rows = tuple(overlay.legend(scene, storeys))
    arranged = overlay.arrange((wide, high), (extra_wide, extra_high), rows)
    sheet, (room_wide, room_high) = arranged.sheet, arranged.room
    symbols = define_repeated_symbols(1000 / sheet.scale, scene.pieces, catalog)
    paper = Paper(catalog, sheet, symbols, overlay)
    summary = overlay.summary(scene)
    parts = [[PlanLayer("Sheet", sheets.sheet_mark(sheet, scene.name, summary, overlay.title))]]
    spare = (room_wide - wide * 1000 / sheet.scale - extra_wide) / (len(storeys) + 1)
    below = max((m["south"] for m in margins), default=0.0)
    bottom = sheets.EDGE + room_high - CAPTION - below
    bottom -= (room_high - high * 1000 / sheet.scale - extra_high) / 2
    left = sheets.EDGE
    views = []
    for storey, margin in zip(storeys, margins, strict=True):
        left += spare + margin["west"]
        views.append(sheets.view_at(sheet, storey.bounds[0], storey.bounds[1], left, bottom))
        parts.append(_storey_layers(storey, paper, views[-1], left, bottom + below))
        left += (storey.bounds[2] - storey.bounds[0]) * 1000 / sheet.scale + margin["east"]
    parts.append([PlanLayer("Legend", legend_mark(arranged))])
    tiles = tile_pattern(PaperView(1000 / sheet.scale, 0.0, 0.0))
    defined: tuple[Definition, ...] = (tiles, shaft_pattern(), *symbols.definitions)
    only = views[0] if len(views) == 1 else None
    return PlanDrawing(scene.name, sheet, defined, merge_layers(parts), only)


def split_levels(scene: Scene) -> tuple[Scene, ...]:
    """A scene for each level that has rooms, so that each has a sheet of its own; named by its
    level where there are several."""
    ids = {space.level for space in scene.spaces}
    levels = [level for level in scene.levels if level.id in ids]
    return tuple(_of_level(scene, level, len(levels) > 1) for level in levels)


def _of_level(scene: Scene, level: Level, several: bool) -> Scene:
    spaces = tuple(space for space in scene.spaces if space.level == level.id)
    ids = {space.id for space in spaces}
    name = level_name(level) or [f"Level {level.id}"]
    return replace(
        scene,
        name=" · ".join(filter(None, [scene.name, *name])) if several else scene.name,
        levels=(level,),
        spaces=spaces,
        walls=tuple(wall for wall in scene.walls if wall.level == level.id),
        openings=tuple(opening for opening in scene.openings if opening.level == level.id),
        pieces=tuple(piece for piece in scene.pieces if piece.space in ids),
    )


def _storey(scene: Scene, level: Level) -> Storey | None:
    """The drawing of a level; ``None`` if it is empty."""
    spaces = tuple(space for space in scene.spaces if space.level == level.id)
    walls = tuple(wall for wall in scene.walls if wall.level == level.id)
    ids = {space.id for space in spaces}
    part = Scene(
        scene.name,
        (level,),
        spaces,
        walls,
        tuple(opening for opening in scene.openings if opening.level == level.id),
        tuple(piece for piece in scene.pieces if piece.space in ids),
        (),
        scene.stairs,
    )
    drawn = [Polygon(prism.outline) for wall in walls for prism in wall.prisms]
    everything = union_all([*drawn, *(polygon_of(space) for space in spaces)])
    if everything.is_empty:
        return None
    cut = cut_walls(walls)
    solid = union_all([cut, *(polygon_of(space) for space in spaces)])
    chains = dimensions.chains(everything, solid, spaces, part.openings)
    swings = [s for opening in part.openings if (s := swing_square(opening)) is not None]
    return Storey(level, part, cut, _bounds(union_all([everything, *swings])), chains)


def _bounds(shape: Geometry) -> dimensions.Bounds:
    west, south, east, north = map(float, shape.bounds)
    return west, south, east, north


def _storey_layers(
    storey: Storey, paper: Paper, view: PaperView, left: float, foot_line: float
) -> list[PlanLayer]:
    """A storey on paper, from the floor up; its chains end at ``foot_line``."""
    part, overlay = storey.scene, paper.overlay
    west, south, east, north = storey.bounds
    middle = (west + east) / 2, (south + north) / 2
    foot = (left + (east - west) * view.scale / 2, foot_line + CAPTION / 2)
    busy = [*_list_footprints(part.pieces, paper.catalog), *roof_windows(part.openings)]
    walls = (*part.walls, *partition_walls(part.pieces))
    return [
        PlanLayer("Floors", group([floors(view, part.spaces), shafts_mark(view, part.spaces)])),
        *overlay.floor(view, storey),
        PlanLayer("Stairs", stairs_mark(view, part.stairs, storey.level.id, part.spaces)),
        PlanLayer("Furniture", pieces_mark(view, part.pieces, paper.catalog, paper.symbols)),
        *overlay.over(view, storey),
        PlanLayer("Sloped ceilings", slopes_mark(view, part.spaces, union_all(busy))),
        PlanLayer("Walls", walls_mark(view, walls)),
        PlanLayer("Windows and doors", openings_mark(view, part.openings)),
        PlanLayer("Sills and heads", heights_mark(view, part.openings, low_walls(walls))),
        PlanLayer("Outlets", outlets_mark(view, part.spaces)),
        PlanLayer("Ways in", doors_mark(view, part.openings, middle if overlay.inward else None)),
        *overlay.ways(view, storey),
        PlanLayer("Names", _labels(view, storey, paper)),
        PlanLayer("Dimensions", dimensions.chains_mark(view, storey.bounds, storey.chains)),
        PlanLayer("Levels", _caption(storey, foot)),
    ]


def _labels(view: PaperView, storey: Storey, paper: Paper) -> Mark:
    """Names of rooms and zones off the furniture and routes, and off rugs and the swings of doors
    where there is other floor."""
    part, overlay = storey.scene, paper.overlay
    low = [piece for piece in part.pieces if not hangs(piece)]
    flat = [piece for piece in low if _flat(piece.category, paper.catalog)]
    taken: list[Geometry] = [Polygon(footprint(piece)) for piece in low if piece not in flat]
    taken += overlay.keep_off(view, storey)
    taken += [line for space in part.spaces for line in low_lines(view, space)]
    taken += [] if overlay.inward else triangle_places(view, part.openings)
    crossed: list[Geometry] = [Polygon(footprint(piece)) for piece in part.pieces if hangs(piece)]
    crossed += [Polygon(footprint(piece)) for piece in flat]
    crossed += [s for opening in part.openings if (s := swing_square(opening)) is not None]
    named = overlay.labels(storey)
    spaces, halos = zip(*named, strict=True) if named else ((), ())
    floor = Floor(union_all(taken), union_all(crossed))
    return labels_mark(view, spaces, floor, halos, overlay.enlarge(paper.sheet))


def _list_footprints(pieces: Sequence[Piece], catalog: Catalog) -> list[Geometry]:
    """The pieces on the floor, and the edges of rugs."""
    here = [piece for piece in pieces if not hangs(piece)]
    shapes = [(piece, Polygon(footprint(piece))) for piece in here]
    return [
        shape.boundary.buffer(0.04) if _flat(piece.category, catalog) else shape
        for piece, shape in shapes
    ]


def _flat(category: str, catalog: Catalog) -> bool:
    kind = catalog.kinds.get(category)
    return kind is not None and kind.flat


def _caption(storey: Storey, at: tuple[float, float]) -> Mark:
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
    message = name if name != level.id or re.search(r"[^\W\d_]{2}", name) else ""
    return [message] if message else []


def _total_area(scene: Scene) -> str:
    return area_words(sum(polygon_of(space).area for space in scene.spaces))


def count_words(count: int, word: str) -> str:
    """A number with its word: ``1 room``, ``2 rooms``."""
    return f"{count} {word}" if count == 1 else f"{count} {word}s"
