"""Ceilings as things to draw, for eyes inside: flat plates, slopes, and panes in slopes.

Pictures from above and files of 3D leave them out.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import inf

import numpy as np
import shapely

from scenewright.building.door_uses import OPEN_AIR
from scenewright.building.gables import height_at, roof_of, under_roofs
from scenewright.building.glazing import GLASS
from scenewright.building.masonry import polygons
from scenewright.building.stair_parts import well_of
from scenewright.core.catalog import Material, Part
from scenewright.core.scene import Prism, Scene
from scenewright.core.space import Level, Opening, Space
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.prisms import sheet
from scenewright.render.items import SLAB, RenderItem, ThingKind, extrude_polygon

CEILING = Material("ceiling", (0.955, 0.945, 0.925), roughness=0.95, emission=0.2)
"""What a floor throws back up is not traced: it is a glow."""
THIN = 0.02
"""Least thickness of a ceiling, in metres."""


def ceilings(scene: Scene) -> Iterator[RenderItem]:
    """The ceiling of every room but those in the open air, up to the slab of the next level, open
    over stairs; and the panes of the windows in its slopes."""
    levels = {level.id: level for level in scene.levels}
    for space in scene.spaces:
        if OPEN_AIR.isdisjoint(space.functions):
            level = levels[space.level]
            wells = [well_of(one) for one in scene.stairs if one.level == level.id]
            panes = {o.id: _cut(o, space) for o in space.openings if o.roof is not None}
            whole = shapely.Polygon(space.outline, space.holes)
            shut = whole.difference(shapely.union_all([*wells, *panes.values()]))
            top = _top_of(space, level, scene)
            yield _item(f"{space.id} ceiling", "ceiling", space, _cover(shut, space, top), False)
            for name, pane in panes.items():
                glass = _cover(whole.intersection(pane), space, top)
                yield _item(name, "opening", space, glass, True)


def _top_of(space: Space, level: Level, scene: Scene) -> float:
    """Where what is above a room begins, in metres above its floor."""
    above = [one.elevation for one in scene.levels if one.elevation > level.elevation]
    slab = min(above, default=-inf) - SLAB - level.elevation
    return max(slab, space.height + THIN)


def _cover(shape: shapely.Geometry, space: Space, top: float) -> list[Mesh]:
    """A region of a room's ceiling: plates up to ``top``, sheets where it slopes."""
    flat = [_prism_over(part, space.height) for part in polygons(shape)]
    parts = under_roofs(flat, [roof_of(space)]) if space.slopes else flat
    return [_close(part, space.height, top) for part in parts]


def _close(part: Prism, height: float, top: float) -> Mesh:
    if part.tilt is None:
        return extrude_polygon(shapely.Polygon(part.outline, part.holes), height, top)
    vertices, faces, _ = sheet(part.outline, part.holes, height)
    vertices[:, 2] = height_at(part.tilt, vertices[:, :2])
    return Mesh(vertices, faces[:, ::-1])


def _prism_over(shape: shapely.Polygon, top: float) -> Prism:
    ordered = shapely.orient_polygons(shape)
    rings = [shapely.get_coordinates(r)[:-1] for r in (ordered.exterior, *ordered.interiors)]
    return Prism(rings[0], 0.0, top, tuple(rings[1:]))


def _cut(opening: Opening, space: Space) -> shapely.Polygon:
    """What a window in a slope takes of the ceiling, in plan."""
    along = np.array([opening.ux, opening.uy])
    inwards = np.array([-opening.uy, opening.ux])
    middle = np.array([opening.x, opening.y])
    near, far = (opening.thickness / 2 + away for away in opening.roof or (0.0, 0.0))
    floor = shapely.Polygon(space.outline)
    if not floor.contains(shapely.Point(middle + (near + far) / 2 * inwards)):
        inwards = -inwards
    side = along * opening.width / 2
    return shapely.Polygon(
        [middle + a * inwards + b * side for a, b in ((near, -1), (near, 1), (far, 1), (far, -1))]
    )


def _item(name: str, kind: ThingKind, space: Space, meshes: list[Mesh], glazed: bool) -> RenderItem:
    part = (Part(GLASS if glazed else CEILING, *merge(meshes)),) if meshes else ()
    category = "window" if glazed else "ceiling"
    facts: dict[str, str | float] = {"category": category, "space": space.id}
    return RenderItem(name, kind, space.level, space.id, name, part, (0, 0, 0), 0.0, facts)
