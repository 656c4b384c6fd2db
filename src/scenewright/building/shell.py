"""The shell: walls with their doors and windows cut out, and the scene they make with pieces.

No solid is ever cut from another: a wall is a polygon in plan, its openings are cut from the
polygon, and what stays below a sill or above a head is a prism of its own.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from scenewright.building import masonry
from scenewright.building.gables import Roof, roof_of, under_roofs
from scenewright.building.plan import levels
from scenewright.building.stairwells import stairs_of
from scenewright.core.brief import Brief
from scenewright.core.plan import Plan
from scenewright.core.scene import Prism, Scene, Wall
from scenewright.core.solution import Solution
from scenewright.core.space import Opening, Points, Space

REACH = 0.25
"""How far beyond its stated thickness an opening is cut, in metres, where the wall goes on."""
LEAST = 0.005
"""Sills and lintels lower than this, in metres, are left out."""


def scene_of_rooms(solution: Solution, plan: Plan) -> Scene:
    """The scene of a solution of rooms: walls with their openings cut, stairs, and its pieces."""
    walls, openings = shell(solution.brief, plan.spaces)
    return Scene(
        solution.brief.name,
        plan.levels,
        plan.spaces,
        walls,
        openings,
        solution.pieces,
        (),
        stairs_of(solution.brief, plan.levels),
        hour=solution.brief.hour,
    )


def shell(brief: Brief, spaces: Sequence[Space]) -> tuple[tuple[Wall, ...], tuple[Opening, ...]]:
    """Walls of all levels, cut by their openings, and the openings, each listed once.

    Walls are those of the brief if it lists any, else they are found from the rooms
    (:mod:`scenewright.building.masonry`). Heights are above the level's floor.

    >>> from scenewright.building.plan import spaces
    >>> brief = Brief.model_validate({"rooms": [{"id": "a",
    ...     "outline": [[0, 0], [4, 0], [4, 3], [0, 3]],
    ...     "windows": [{"at": [2, 0], "width": 1.0, "sill": 0.9, "height": 1.4}]}]})
    >>> walls, openings = shell(brief, spaces(brief))
    >>> [(p.base, p.top) for p in walls[0].prisms]
    [(0.0, 2.6), (0.0, 2.6), (0.0, 0.9), (2.3, 2.6)]
    """
    openings = tuple({(o.level, o.id): o for space in spaces for o in space.openings}.values())
    walls: list[Wall] = []
    storeys = levels(brief)
    for level in storeys:
        if brief.walls:
            bodies = masonry.walls_from_brief(brief, level.id, level.height, storeys[0].id)
        else:
            bodies = masonry.derive_walls(brief, spaces, level.id)
        mine = [o for o in openings if o.level == level.id and o.roof is None]
        roofs = [roof_of(space) for space in spaces if space.level == level.id]
        walls += _cut(bodies, mine, roofs)
    return tuple(walls), openings


def opening_box(opening: Opening, extra: float = 0.0) -> Polygon:
    """The rectangle an opening takes in plan, its thickness grown by ``extra`` on both sides."""
    along = np.array([opening.ux, opening.uy]) * opening.width / 2
    across = np.array([-opening.uy, opening.ux]) * (opening.thickness / 2 + extra)
    middle = np.array([opening.x, opening.y])
    return Polygon(
        [
            middle - along - across,
            middle + along - across,
            middle + along + across,
            middle - along + across,
        ]
    )


def _cut(
    bodies: Sequence[masonry.Masonry], openings: Sequence[Opening], roofs: Sequence[Roof]
) -> list[Wall]:
    """Walls as prisms: the wall beside its openings, below their sills, above their heads, all
    under the ceilings of the rooms beside it."""
    sloped = any(roof.sloped for roof in roofs)
    shapes = np.array([body.shape for body in bodies])
    tree = shapely.STRtree(shapes)
    holes: list[list[tuple[Opening, BaseGeometry]]] = [[] for _ in bodies]
    for opening in openings:
        touched, region = _cut_out(opening, shapes, tree)
        for number in touched:
            holes[number].append((opening, region))
    walls = []
    for number, body in enumerate(bodies):
        prisms = _prisms(body, holes[number])
        prisms = under_roofs(prisms, roofs) if sloped else prisms
        walls.append(Wall(body.id, body.level, tuple(prisms)))
    return walls


def _cut_out(
    opening: Opening, shapes: Points, tree: shapely.STRtree
) -> tuple[frozenset[int], BaseGeometry]:
    """The walls an opening goes through, and the region it takes out of them.

    Where the wall is thicker than the opening says (a curved wall, rooms drawn roughly) the cut
    goes on up to 0.25 m, but only in wall that is joined to the opening itself.
    """
    wide = opening_box(opening, REACH)
    touched = tree.query(wide, predicate="intersects")
    solid = shapely.union_all([shapely.intersection(shapes[i], wide) for i in touched])
    core = opening_box(opening, 0.02)
    met = [part for part in shapely.get_parts(solid) if part.intersects(core)]
    region = shapely.union_all([core, *(part for part in met if isinstance(part, Polygon))])
    return frozenset(touched.tolist()), region


def _prisms(body: masonry.Masonry, holes: list[tuple[Opening, BaseGeometry]]) -> list[Prism]:
    rest: BaseGeometry = body.shape
    filled: list[Prism] = []
    for opening, region in holes:
        inside = masonry.polygons(rest.intersection(region))
        if not inside:
            continue
        rest = rest.difference(region)
        filled += _between(inside, 0.0, min(opening.sill, body.top))
        filled += _between(inside, opening.head, body.top)
    return _between(masonry.polygons(rest), 0.0, body.top) + filled


def _between(shapes: Sequence[Polygon], base: float, top: float) -> list[Prism]:
    if top - base < LEAST:
        return []
    return [Prism(*_rings(shape, base, top)) for shape in shapes]


def _rings(
    shape: Polygon, base: float, top: float
) -> tuple[Points, float, float, tuple[Points, ...]]:
    ordered = shapely.orient_polygons(shape)
    outline = shapely.get_coordinates(ordered.exterior)[:-1]
    holes = tuple(shapely.get_coordinates(hole)[:-1] for hole in ordered.interiors)
    return outline, base, top, holes
