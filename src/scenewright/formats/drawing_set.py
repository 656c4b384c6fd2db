"""The set of sheets a solution is printed as: plans, elevations, schedule, pictures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from shapely import Polygon, box, get_parts

from scenewright.catalog.loading import catalog_of
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.scene import Prism, Scene, Wall
from scenewright.core.solution import Solution
from scenewright.core.space import Space
from scenewright.domains import draw_levels, scene_of
from scenewright.drawing.elevations import elevation_sheets, wall_views
from scenewright.drawing.layers import PlanDrawing, PlanLayer
from scenewright.drawing.marks import GREY, Mark, PictureMark, group, text
from scenewright.drawing.schedule import schedule_rows, schedule_sheets
from scenewright.drawing.sheet import EDGE, PaperSheet, TitleBlock, drawing_area, sheet_mark
from scenewright.formats.png import OPEN, picture
from scenewright.render.picture import Pixels

MOST_PICTURES, PIXELS = 6, 560
"""Rooms that are pictured, the largest, and the width of a picture."""
AROUND = 0.4
"""Metres of wall around a room that its picture shows."""
SHEET = PaperSheet(420.0, 297.0, 0)
Place = tuple[float, float]


def draw_set(solution: Solution, plan: Plan | None = None) -> tuple[PlanDrawing, ...]:
    """All sheets of a solution in order."""
    plans = draw_levels(solution, plan)
    scene, catalog = scene_of(solution, plan), catalog_of(solution.brief.catalogs)
    name, date = scene.name or "Plan", solution.brief.date
    sheets = [*plans]
    sheets += elevation_sheets(wall_views(scene), catalog, name, len(sheets) + 1, date)
    sheets += schedule_sheets(schedule_rows(scene, catalog), name, len(sheets) + 1, date)
    return (*sheets, *_pictures(scene, catalog, name, TitleBlock(str(len(sheets) + 1), date)))


def _pictures(scene: Scene, catalog: Catalog, name: str, block: TitleBlock) -> list[PlanDrawing]:
    """The furnished rooms from above, the largest; where there are no rooms, the whole."""
    furnished = {piece.space for piece in scene.pieces}
    rooms = [s for s in scene.spaces if s.id in furnished and not OPEN & set(s.functions)]
    largest = sorted(rooms, key=lambda s: -Polygon(s.outline).area)[:MOST_PICTURES]
    shown = [(room.name or room.id, only_room(scene, room)) for room in largest]
    shown = shown or ([(name, scene)] if scene.pieces else [])
    if not shown:
        return []
    columns = 1 if len(shown) == 1 else 2 if len(shown) <= 4 else 3
    wide, high = drawing_area(SHEET)
    rows = -(-len(shown) // columns)
    cell = (wide / columns, high / rows)
    marks: list[Mark] = []
    for number, (words, part) in enumerate(shown):
        corner = EDGE + number % columns * cell[0], EDGE + number // columns * cell[1]
        marks.append(_place(words, picture(part, catalog, PIXELS), corner, cell))
    words = f"Pictures · {len(shown)} of {len(rooms) or 1} rooms"
    layers = (
        PlanLayer("Sheet", sheet_mark(SHEET, name, words, block)),
        PlanLayer("Pictures", group(marks)),
    )
    return [PlanDrawing(name, SHEET, (), layers)]


def _place(
    words: str, pixels: Pixels, corner: tuple[float, float], cell: tuple[float, float]
) -> Mark:
    """A picture in the middle of its cell with its name below."""
    high, wide = pixels.shape[:2]
    scale = min((cell[0] - 8.0) / wide, (cell[1] - 14.0) / high)
    size = wide * scale, high * scale
    x, y = corner[0] + (cell[0] - size[0]) / 2, corner[1] + 4.0
    name = text(words, (corner[0] + cell[0] / 2, y + size[1] + 4.0), 2.6, fill=GREY, stroke="none")
    return group([PictureMark(pixels, x, y, *size), name])


def only_room(scene: Scene, room: Space) -> Scene:
    """A scene of one room: its floor, its pieces, and the walls close around it."""
    reach = Polygon(room.outline).buffer(AROUND, join_style="mitre")
    walls = tuple(
        Wall(wall.id, wall.level, prisms)
        for wall in scene.walls
        if wall.level == room.level and (prisms := _clip(wall, reach))
    )
    ids = {opening.id for opening in room.openings}
    return replace(
        scene,
        name=room.name,
        levels=tuple(level for level in scene.levels if level.id == room.level),
        spaces=(room,),
        walls=walls,
        openings=tuple(o for o in scene.openings if o.id in ids),
        pieces=tuple(piece for piece in scene.pieces if piece.space == room.id),
        surfaces=(),
    )


def _clip(wall: Wall, reach: Polygon) -> tuple[Prism, ...]:
    """The prisms of a wall as far as they lie near a room."""
    found: list[Prism] = []
    for prism in wall.prisms:
        body = Polygon(prism.outline, prism.holes)
        if not body.intersects(box(*reach.bounds)):
            continue
        for part in get_parts(body.intersection(reach)):
            if isinstance(part, Polygon) and part.area > 1e-4:
                ring = np.asarray(part.exterior.coords)[:-1]
                ring = ring if part.exterior.is_ccw else ring[::-1]
                holes = tuple(np.asarray(h.coords)[:-1] for h in part.interiors)
                found.append(replace(prism, outline=ring, holes=holes))
    return tuple(found)
