"""Skirting boards along the walls of rooms, open at doors and stairs."""

from __future__ import annotations

from collections.abc import Iterator

import shapely

from scenewright.building.door_uses import OPEN_AIR
from scenewright.building.joinery import PAINT
from scenewright.building.masonry import polygons
from scenewright.building.shell import opening_box
from scenewright.core.catalog import Part
from scenewright.core.scene import Scene
from scenewright.geometry.mesh import merge
from scenewright.render.items import RenderItem, extrude_polygon

TALL, THICK = 0.07, 0.013
"""Height and thickness in metres."""
BESIDE = 0.03
"""How far from a wall, in metres, an outline may run that has a board."""
REACH = 0.2
"""How far beside an opening's wall, in metres, no board stands in its way."""
WET = frozenset(("bathroom", "toilet", "washroom"))
"""Rooms that are tiled: no board."""


def skirting(scene: Scene) -> Iterator[RenderItem]:
    """The boards of every room with walls that is dry and under a roof."""
    for level in scene.levels:
        solids = [p for wall in scene.walls if wall.level == level.id for p in wall.prisms]
        stand = [shapely.Polygon(p.outline, p.holes) for p in solids if not p.base]
        gaps = [
            opening_box(one, REACH)
            for one in scene.openings
            if one.level == level.id and one.sill < TALL and one.roof is None
        ]
        reach = (
            shapely.union_all(stand)
            .buffer(BESIDE, join_style="mitre")
            .difference(shapely.union_all(gaps))
        )
        for space in scene.spaces:
            dry = WET.isdisjoint(space.functions) and OPEN_AIR.isdisjoint(space.functions)
            if space.level == level.id and dry and scene.walls:
                floor = shapely.Polygon(space.outline, space.holes)
                rim = floor.difference(floor.buffer(-THICK, join_style="mitre"))
                boards = [extrude_polygon(s, 0.0, TALL) for s in polygons(rim.intersection(reach))]
                if boards:
                    name = f"{space.id} skirting"
                    facts: dict[str, str | float] = {"category": "skirting", "space": space.id}
                    part = Part(PAINT, *merge(boards))
                    yield RenderItem(
                        name, "skirting", level.id, space.id, name, (part,), (0, 0, 0), 0.0, facts
                    )
