"""Walls in plan, before openings are cut: one polygon a wall, none overlapping another.

Rooms are drawn by the inner faces of their walls, so the solid is what lies between them and a
wall's thickness around them. Each stretch of a room's outline (edges that turn by less than 25
degrees are one curved wall) takes the solid behind it, the longest first; what is left at the
corners joins the wall it shares most of its border with.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely
from shapely import LineString, Point, Polygon
from shapely.geometry.base import BaseGeometry

from scenewright.brief import Brief, WallBrief
from scenewright.space import Points, Space

PARTITION = 0.04
"""Thickness in metres of the wall drawn between rooms that touch."""
PARAPET = 1.05
"""Height in metres of what surrounds a balcony."""
PARAPET_THICKNESS = 0.1
GAP = 0.3
"""Half the widest gap between rooms, in metres, that is filled as wall."""
SHAFT = 0.4
"""Enclosed voids smaller than this, in square metres, are filled."""
CRUMB = 1e-4
"""Pieces of wall smaller than this, in square metres, join their neighbour or are dropped."""
MITRE = 4.0
CURVE = np.cos(np.deg2rad(25.0))


class Masonry(NamedTuple):
    """One wall in plan: its id, level, shape and the height of its top above the floor."""

    id: str
    level: str
    shape: Polygon
    top: float


def derived(brief: Brief, spaces: Sequence[Space], level: str) -> tuple[Masonry, ...]:
    """The walls of one level found from its rooms.

    >>> from scenewright.plan import spaces
    >>> room = {"id": "a", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]]}
    >>> brief = Brief.model_validate({"rooms": [room], "outer_wall_thickness": 0.25})
    >>> walls = derived(brief, spaces(brief), "0")
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
    walls = _shared_out(full, list(_stretches(mine)), reach)
    open_air = [space for space, out in zip(mine, outside, strict=True) if out]
    rails = _shared_out(low, list(_stretches(open_air)), reach)
    heights = np.array([space.height for space in mine])
    return tuple(
        [Masonry(name, level, shape, _top(shape, floors, heights)) for name, shape in walls]
        + [Masonry(f"{name}-parapet", level, shape, PARAPET) for name, shape in rails]
    )


def given(brief: Brief, level: str, height: float, first: str) -> tuple[Masonry, ...]:
    """The walls of one level as the brief gives them, by middle line and thickness.

    Walls that end within a wall's thickness of each other are joined by a mitre; the earlier
    wall keeps what both would cover. Walls that name no level stand on the ``first``.
    """
    listed = [(i, w) for i, w in enumerate(brief.walls) if (w.level or first) == level]
    listed = [(i, w) for i, w in listed if w.start != w.end]
    bodies: list[BaseGeometry] = [_body(wall) for _, wall in listed]
    bodies = [body.union(_joints(k, listed, bodies)) for k, body in enumerate(bodies)]
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


def polygons(shape: BaseGeometry) -> list[Polygon]:
    """The polygons in a shape that are more than a crumb, largest first.

    >>> [round(p.area, 1) for p in polygons(shapely.MultiPolygon(
    ...     [shapely.box(0, 0, 1, 1), shapely.box(2, 0, 4, 1)]))]
    [2.0, 1.0]
    """
    parts = (part for part in shapely.get_parts(shape) if isinstance(part, Polygon))
    return sorted((p for p in parts if p.area > CRUMB), key=lambda p: -p.area)


def _solids(
    floors: list[Polygon], outside: list[bool], thickness: float
) -> tuple[BaseGeometry, BaseGeometry]:
    """Full walls and parapets of a level, as regions."""
    rooms = shapely.union_all(floors)
    indoor = [floor for floor, out in zip(floors, outside, strict=True) if not out]
    balconies = [floor for floor, out in zip(floors, outside, strict=True) if out]
    around = _grown(shapely.union_all(_filled(indoor)), thickness)
    full = around.difference(rooms).union(_partitions(floors))
    if not balconies:
        return full, Polygon()
    terrace = _grown(shapely.union_all(_filled(balconies)), min(PARAPET_THICKNESS, thickness))
    whole = terrace.union(around)
    whole = _closed(whole, GAP / 2) if around.distance(terrace) < 2 * GAP else whole
    return full, terrace.union(whole.difference(around)).difference(around).difference(rooms)


def _filled(floors: Iterable[Polygon]) -> list[Polygon]:
    """Columns and whatever else stands inside an outline count as solid."""
    return [Polygon(floor.exterior) for floor in floors]


def _grown(rooms: BaseGeometry, thickness: float) -> BaseGeometry:
    """Rooms with a wall of ``thickness`` around them and the gaps between them filled."""
    if rooms.is_empty:
        return rooms
    spare = max(GAP - thickness, 0.05)
    grown = shapely.buffer(rooms, thickness + spare, join_style="mitre", mitre_limit=MITRE)
    grown = shapely.buffer(grown, -spare, join_style="mitre", mitre_limit=MITRE)
    return shapely.union_all([_without_shafts(part) for part in polygons(grown)])


def _closed(region: BaseGeometry, by: float) -> BaseGeometry:
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
    """What both rooms reach when grown by half the thickness (and half the gap)."""
    by = (PARTITION + first.distance(second)) / 2
    grown = shapely.buffer([first, second], by, join_style="mitre", mitre_limit=MITRE)
    return grown[0].intersection(grown[1])


def _stretches(spaces: Sequence[Space]) -> Iterator[tuple[str, LineString]]:
    """Every wall face of the rooms, named, the longest first; columns before all."""
    faces = []
    for space in spaces:
        for number, hole in enumerate(space.holes):
            closed = LineString(np.vstack([hole, hole[:1]]))
            faces.append((1, f"{space.id}/column-{number}", closed))
        for start, run in _runs(space.outline):
            faces.append((0, f"{space.id}/wall-{start}", LineString(run)))
    faces.sort(key=lambda face: (-face[0], -round(face[2].length, 6)))
    return ((name, line) for _, name, line in faces)


def _runs(ring: Points) -> Iterator[tuple[int, Points]]:
    """A ring cut at its corners of more than 25 degrees: first edge and polyline of each run."""
    along = np.roll(ring, -1, axis=0) - ring
    along = along / np.linalg.norm(along, axis=1)[:, None]
    cuts = np.flatnonzero((along * np.roll(along, 1, axis=0)).sum(1) < CURVE)
    cuts = cuts if len(cuts) > 1 else np.array([0, len(ring) // 2])
    turned = np.roll(ring, -cuts[0], axis=0)
    closed = np.vstack([turned, turned[:1]])
    for low, high in pairwise([*(cuts - cuts[0]).tolist(), len(ring)]):
        yield int((low + cuts[0]) % len(ring)), closed[low : high + 1]


def _shared_out(
    solid: BaseGeometry, stretches: list[tuple[str, LineString]], reach: float
) -> list[tuple[str, Polygon]]:
    """The solid cut into one piece (or more, numbered) for every stretch that has some."""
    shares: dict[str, list[Polygon]] = {}
    rest = solid
    for name, line in stretches:
        if rest.is_empty:
            break
        taken = polygons(rest.intersection(_behind(line, reach, "column" in name)))
        if taken:
            shares[name] = taken
            rest = rest.difference(shapely.union_all(taken))
    pieces = [(name, part) for name, parts in shares.items() for part in parts]
    return _numbered(_with_corners(pieces, polygons(rest)))


def _behind(line: LineString, reach: float, column: bool) -> BaseGeometry:
    """What lies within ``reach`` outside a wall face (the inside is on its left)."""
    if column:
        return Polygon(line)
    strip = shapely.buffer(
        line, -reach, cap_style="flat", join_style="mitre", mitre_limit=MITRE, single_sided=True
    )
    return strip if strip.is_valid else shapely.make_valid(strip)


def _with_corners(
    pieces: list[tuple[str, Polygon]], corners: list[Polygon]
) -> list[tuple[str, Polygon]]:
    """Each corner joined to the piece it borders on most; alone if it borders on none."""
    shapes = [shape for _, shape in pieces]
    names = [name for name, _ in pieces]
    for corner in corners:
        shared = shapely.length(shapely.intersection(shapely.buffer(corner, 1e-6), shapes))
        best = int(np.argmax(shared)) if len(shapes) else -1
        joined = shapely.union(shapes[best], corner) if best >= 0 else corner
        if best >= 0 and isinstance(joined, Polygon):
            shapes[best] = joined
        else:
            names.append("corner")
            shapes.append(corner)
    return list(zip(names, shapes, strict=True))


def _numbered(pieces: list[tuple[str, Polygon]]) -> list[tuple[str, Polygon]]:
    seen: dict[str, int] = {}
    found = []
    for name, shape in pieces:
        seen[name] = seen.get(name, 0) + 1
        found.append((name if seen[name] == 1 else f"{name}-{seen[name]}", shape))
    return found


def _top(shape: Polygon, floors: list[Polygon], heights: Points) -> float:
    """A wall is as high as the highest room it borders on."""
    near = shapely.distance(shape, floors) < 2 * PARTITION
    return float(heights[near].max() if near.any() else heights.max())


def _body(wall: WallBrief) -> Polygon:
    line = LineString([wall.start, wall.end])
    return shapely.buffer(line, wall.thickness / 2, cap_style="flat")


def _joints(
    k: int, listed: list[tuple[int, WallBrief]], bodies: list[BaseGeometry]
) -> BaseGeometry:
    """The wedges that close the corners between wall ``k`` and those that end where it does."""
    wall = listed[k][1]
    near = np.flatnonzero(shapely.dwithin(bodies[k], bodies, wall.thickness / 2)).tolist()
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
