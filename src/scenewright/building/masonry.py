"""Walls in plan, before openings are cut: one polygon a wall, none overlapping another.

Rooms are drawn by the inner faces of their walls, so the solid is what lies between them and a
wall's thickness around them. Each stretch of a room's outline (edges that turn by less than 25
degrees are one curved wall) takes the solid behind it, the longest first; what is left at the
corners joins the wall it shares most of its border with.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from shapely import LineString, Point, Polygon
from shapely.geometry.base import BaseGeometry

from scenewright.building.wall_shares import MITRE, polygons, shared_out, stretches_of
from scenewright.core.brief import Brief, WallBrief
from scenewright.core.errors import InputError
from scenewright.core.space import Points, Space

PARTITION = 0.04
"""Thickness in metres of the wall drawn between rooms that touch."""
PARAPET = 1.05
"""Height in metres of what surrounds a balcony."""
PARAPET_THICKNESS = 0.1
GAP = 0.3
"""Half the widest gap between rooms, in metres, that is filled as wall."""
SHAFT = 0.4
"""Enclosed voids smaller than this, in square metres, are filled."""
MOST_MEETING = 500
"""Walls of a brief that one of them may meet."""


__all__ = ["Masonry", "derive_walls", "polygons", "walls_from_brief"]


class Masonry(NamedTuple):
    """One wall in plan: its id, level, shape and the height of its top above the floor."""

    id: str
    level: str
    shape: Polygon
    top: float


def derive_walls(brief: Brief, spaces: Sequence[Space], level: str) -> tuple[Masonry, ...]:
    """The walls of one level found from its rooms.

    >>> from scenewright.building.plan import spaces
    >>> room = {"id": "a", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]]}
    >>> brief = Brief.model_validate({"rooms": [room], "outer_wall_thickness": 0.25})
    >>> walls = derive_walls(brief, spaces(brief), "0")
    >>> [wall.id for wall in walls], round(sum(wall.shape.area for wall in walls), 3)
    (['a/wall-0', 'a/wall-2', 'a/wall-1', 'a/wall-3'], 3.75)
    """
    mine = [space for space in spaces if space.level == level]
    if not mine:
        return ()
    floors = [Polygon(space.outline, space.holes) for space in mine]
    outside = [space.functions == ("balcony",) for space in mine]
    full, low = _solids(floors, outside, brief.outer_wall_thickness)
    reach = max(2 * GAP, brief.outer_wall_thickness)
    walls = shared_out(full, list(stretches_of(mine)), reach)
    open_air = [space for space, out in zip(mine, outside, strict=True) if out]
    rails = shared_out(low, list(stretches_of(open_air)), reach)
    heights = np.array([space.height for space in mine])
    tops = _tops(walls, floors, heights)
    return tuple(
        [Masonry(name, level, shape, top) for (name, shape), top in zip(walls, tops, strict=True)]
        + [Masonry(f"{name}-parapet", level, shape, PARAPET) for name, shape in rails]
    )


def walls_from_brief(brief: Brief, level: str, height: float, first: str) -> tuple[Masonry, ...]:
    """The walls of one level as the brief gives them, by middle line and thickness.

    Walls that end within a wall's thickness of each other are joined by a mitre; the earlier
    wall keeps what both would cover. Walls that name no level stand on the ``first``.
    """
    listed = [(i, w) for i, w in enumerate(brief.walls) if (w.level or first) == level]
    listed = [(i, w) for i, w in listed if w.start != w.end]
    if not listed:
        return ()
    bodies: list[BaseGeometry] = [_body(wall) for _, wall in listed]
    near = _near(bodies, [wall for _, wall in listed])
    bodies = [body.union(_joints(k, near[k], listed, bodies)) for k, body in enumerate(bodies)]
    tree = shapely.STRtree(bodies)
    found = []
    for k, (number, wall) in enumerate(listed):
        earlier = [bodies[j] for j in sorted(tree.query(bodies[k]).tolist()) if j < k]
        rest = bodies[k].difference(shapely.union_all(earlier)) if earlier else bodies[k]
        name = wall.id or f"wall-{number + 1}"
        found += [
            Masonry(
                name if part == 0 else f"{name}-{part + 1}", level, shape, wall.height or height
            )
            for part, shape in enumerate(polygons(rest))
        ]
    return tuple(found)


def _solids(
    floors: list[Polygon], outside: list[bool], thickness: float
) -> tuple[BaseGeometry, BaseGeometry]:
    """Full walls and parapets of a level, as regions."""
    rooms = shapely.union_all(floors)
    indoor = [floor for floor, out in zip(floors, outside, strict=True) if not out]
    balconies = [floor for floor, out in zip(floors, outside, strict=True) if out]
    around = _grow_rooms(shapely.union_all(_fill_columns(indoor)), thickness)
    full = around.difference(rooms).union(_partitions(floors))
    if not balconies:
        return full, Polygon()
    terrace = _grow_rooms(
        shapely.union_all(_fill_columns(balconies)), min(PARAPET_THICKNESS, thickness)
    )
    whole = terrace.union(around)
    whole = _close_gaps(whole, GAP / 2) if around.distance(terrace) < 2 * GAP else whole
    return full, terrace.union(whole.difference(around)).difference(around).difference(rooms)


def _fill_columns(floors: Iterable[Polygon]) -> list[Polygon]:
    """Columns and whatever else stands inside an outline count as solid."""
    return [Polygon(floor.exterior) for floor in floors]


def _grow_rooms(rooms: BaseGeometry, thickness: float) -> BaseGeometry:
    """Rooms with a wall of ``thickness`` around them and the gaps between them filled."""
    if rooms.is_empty:
        return rooms
    spare = max(GAP - thickness, 0.05)
    grown = shapely.buffer(rooms, thickness + spare, join_style="mitre", mitre_limit=MITRE)
    grown = shapely.buffer(grown, -spare, join_style="mitre", mitre_limit=MITRE)
    return shapely.union_all([_without_shafts(part) for part in polygons(grown)])


def _close_gaps(region: BaseGeometry, by: float) -> BaseGeometry:
    wide = shapely.buffer(region, by, join_style="mitre", mitre_limit=MITRE)
    return shapely.buffer(wide, -by, join_style="mitre", mitre_limit=MITRE).union(region)


def _without_shafts(part: Polygon) -> Polygon:
    return Polygon(part.exterior, [h for h in part.interiors if Polygon(h).area > SHAFT])


def _partitions(floors: list[Polygon]) -> BaseGeometry:
    """Thin walls on the borders of rooms that touch or nearly do."""
    tree = shapely.STRtree(floors)
    firsts, seconds = tree.query(floors, predicate="dwithin", distance=PARTITION - 1e-6)
    pairs = [(a, b) for a, b in zip(firsts.tolist(), seconds.tolist(), strict=True) if a < b]
    return shapely.union_all([_partition(floors[a], floors[b]) for a, b in pairs])


def _partition(first: Polygon, second: Polygon) -> BaseGeometry:
    """The floor both rooms cover when grown by half the thickness (and half the gap)."""
    by = (PARTITION + first.distance(second)) / 2
    grown = shapely.buffer([first, second], by, join_style="mitre", mitre_limit=MITRE)
    return grown[0].intersection(grown[1])


def _tops(
    walls: Sequence[tuple[str, Polygon]], floors: list[Polygon], heights: Points
) -> list[float]:
    """A wall is as high as the highest room it borders on."""
    shapes = [shape for _, shape in walls]
    if not shapes:  # a lone balcony has none
        return []
    of_wall, of_floor = shapely.STRtree(floors).query(
        shapes, predicate="dwithin", distance=2 * PARTITION
    )
    tops = np.full(len(shapes), -np.inf)
    np.maximum.at(tops, of_wall, heights[of_floor])
    return np.where(np.isfinite(tops), tops, heights.max()).tolist()


def _body(wall: WallBrief) -> Polygon:
    line = LineString([wall.start, wall.end])
    return shapely.buffer(line, wall.thickness / 2, cap_style="flat")


def _near(bodies: list[BaseGeometry], walls: list[WallBrief]) -> list[list[int]]:
    """Walls within half of each wall's thickness; InputError where too many meet.

    Every pair that meets is looked at, so walls listed over and over would take forever.
    """
    reach = [wall.thickness / 2 for wall in walls]
    first, second = shapely.STRtree(bodies).query(bodies, predicate="dwithin", distance=reach)
    counts = np.bincount(first, minlength=len(bodies))
    if counts.max() > MOST_MEETING:
        wall = walls[int(counts.argmax())]
        raise InputError(
            f"{counts.max() - 1} walls meet the one from ({wall.start[0]:g}, {wall.start[1]:g}) "
            f"to ({wall.end[0]:g}, {wall.end[1]:g})",
            f"list every wall once; at most {MOST_MEETING} may meet",
            place="walls",
        )
    order = np.lexsort((second, first))
    return [part.tolist() for part in np.split(second[order], np.cumsum(counts)[:-1])]


def _joints(
    k: int, near: list[int], listed: list[tuple[int, WallBrief]], bodies: list[BaseGeometry]
) -> BaseGeometry:
    """The wedges that close the corners between wall ``k`` and those that end where it does."""
    wall = listed[k][1]
    wedges = [
        _wedge(a, b, wall, listed[j][1])
        for j in near
        if j != k
        for a in (wall.start, wall.end)
        for b in (listed[j][1].start, listed[j][1].end)
        if np.hypot(a[0] - b[0], a[1] - b[1]) <= max(wall.thickness, listed[j][1].thickness) / 2
    ]
    return shapely.union_all(wedges).difference(shapely.union_all([bodies[j] for j in near]))


def _wedge(
    here: tuple[float, float], there: tuple[float, float], wall: WallBrief, other: WallBrief
) -> BaseGeometry:
    """The corner where two walls meet: what both cover when they run on past their ends."""
    on = MITRE * max(wall.thickness, other.thickness) / 2
    near = Point((here[0] + there[0]) / 2, (here[1] + there[1]) / 2).buffer(on)
    return _longer(wall, here, on).intersection(_longer(other, there, on)).intersection(near)


def _longer(wall: WallBrief, end: tuple[float, float], by: float) -> Polygon:
    """A wall's body, longer at one end."""
    far = np.array(wall.end if end == wall.start else wall.start)
    way = (np.array(end) - far) / np.hypot(*(np.array(end) - far))
    return shapely.buffer(
        LineString([far, np.array(end) + by * way]), wall.thickness / 2, cap_style="flat"
    )
