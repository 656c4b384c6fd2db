"""Rooms among the faces that lines enclose: those that are not as thin as walls."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from shapely import Geometry, MultiLineString, Polygon, prepare

from scenewright.building.drawn.bridges import (
    THICK,
    Gap,
    bridge_lines,
    extend_loose_ends,
    find_gaps,
)
from scenewright.building.drawn.drawing import Drawn, Word
from scenewright.building.drawn.names import name_rooms
from scenewright.building.drawn.niches import cut_niches
from scenewright.building.room_names import says_nothing

GRID = 0.002
"""Metres to which lines are drawn together."""
THIN, LEAST_AREA, SLIT = 0.27, 0.7, 0.03
"""The radius in metres of the largest circle in a wall, the area in m² of the least room, and
half the width of a slit that is no opening."""
AROUND = 0.5
"""A face whose holes take this share of it lies around a building: a frame, a plot, a terrace."""
LEAST_LED, BESIDE = 6, 0.2
"""Twice the fewest rooms along a corridor; metres beside a wall at which it is looked for rooms."""
SHARED = 0.1
"""The share of a painted area that other rooms may have."""
WAY_IN = 0.5
"""Metres from a room to what leads into it."""
MOST_ROOMS, LEAST_FLOOR, USUAL_ROOM = 600, 6.0, (1.5, 600.0)
"""The most rooms of a plan, its least floor, and the area of its middle room, in m²."""


class Faces(NamedTuple):
    """Rooms of a drawing, the walls and openings between them, the gaps, and what lies around."""

    rooms: list[Polygon]
    walls: list[Polygon]
    gaps: list[Gap]
    around: list[Polygon]
    small: list[Polygon]


def find_faces(drawn: Drawn) -> Faces:
    """The faces of a drawing in metres: rooms, walls (thin), what lies around the building."""
    lines = node_lines(drawn)
    gaps = find_gaps(lines, drawn)
    whole = shapely.union_all([lines, *bridge_lines(gaps)], grid_size=GRID / 2)
    faces = list(shapely.get_parts(shapely.polygonize([whole])))
    found = Faces([], [], gaps, [], [])
    for face in faces:
        _sort(face, found)
    rooms, closed = cut_niches(found.rooms, found.walls)
    return _take_corridors(found._replace(rooms=rooms, gaps=gaps + closed))


def _take_corridors(found: Faces) -> Faces:
    """The faces around a building as rooms where half of the rooms lead into them: corridors."""
    corridors = [
        face
        for face in found.around
        if 2 * len(_leading_into(face, found)) >= max(len(found.rooms), LEAST_LED)
    ]
    around = [face for face in found.around if not any(face is one for one in corridors)]
    tidied = [part for face in corridors for part in _tidy(face)]
    return found._replace(rooms=found.rooms + tidied, around=around)


def _leading_into(face: Polygon, found: Faces) -> set[int]:
    """The rooms by number that a gap joins to a face."""
    rooms: set[int] = set()
    prepare(face)
    for gap in found.gaps:
        aside = (gap.thickness / 2 + BESIDE) * np.array([-gap.along[1], gap.along[0]])
        sides = [shapely.Point(gap.middle + sign * aside) for sign in (1, -1)]
        for here, beyond in (sides, sides[::-1]):
            if face.contains(here):
                rooms |= {k for k, room in enumerate(found.rooms) if room.contains(beyond)}
    return rooms


def without_solid(found: Faces, solid: Geometry) -> Faces:
    """The faces without rooms that lie in what walls cover: these are thick walls."""
    prepare(solid)
    inside = [solid.contains(room.representative_point()) for room in found.rooms]
    rooms = [room for room, within in zip(found.rooms, inside, strict=True) if not within]
    walls = [room for room, within in zip(found.rooms, inside, strict=True) if within]
    return found._replace(rooms=rooms, walls=found.walls + walls)


def with_painted(found: Faces, painted: Sequence[Polygon], words: Sequence[Word]) -> Faces:
    """The faces with rooms that no walls close, such as balconies: areas painted beside other
    rooms, with a known name for a room written in them."""
    rooms = list(found.rooms)
    for area in painted:
        near = [room for room in rooms if room.distance(area) <= THICK]
        covered = sum(room.intersection(area).area for room in near)
        if near and area.area >= LEAST_AREA and covered <= SHARED * area.area:
            named = name_rooms(words, [area])[0]
            rooms += [area] if named and not says_nothing(named) else []
    return found._replace(rooms=rooms)


def node_lines(drawn: Drawn) -> shapely.Geometry:
    """The lines of walls, cut where they meet, repeated ones once, loose bits left out."""
    lines = shapely.linestrings(drawn.walls)
    lines = lines[shapely.length(lines) > GRID]
    noded = shapely.union_all(MultiLineString(list(lines)), grid_size=GRID)
    longer = extend_loose_ends(list(shapely.get_parts(noded)))
    return shapely.union_all([noded, *longer], grid_size=GRID) if longer else noded


def _sort(face: Polygon, found: Faces) -> None:
    hollow = sum(Polygon(ring).area for ring in face.interiors)
    if hollow > AROUND * (hollow + face.area):
        found.around.append(face)
    elif shapely.is_empty(face.buffer(-THIN)):
        found.walls.append(face)
    elif face.area < LEAST_AREA:
        found.small.append(face)
    else:
        found.rooms.extend(_tidy(face))


def _tidy(face: Polygon) -> list[Polygon]:
    """The rooms of a face: parted where only a slit joins them, without spikes; columns stay as
    holes."""
    smooth = face.buffer(-SLIT, join_style="mitre").buffer(SLIT, join_style="mitre")
    found = []
    for part in shapely.get_parts(smooth):
        if isinstance(part, Polygon) and part.area >= LEAST_AREA:
            holes = [ring for ring in part.interiors if Polygon(ring).area > 0.01]
            plain = shapely.simplify(Polygon(part.exterior, holes), 0.004)
            found.append(plain if isinstance(plain, Polygon) and plain.is_valid else part)
    return found or [face]


def is_plan(found: Faces, drawn: Drawn) -> bool:
    """Whether rooms are as many and as large as those of a building, and there is a way in: a gap,
    a leaf, or something on a layer of doors; most rooms lie together."""
    groups = entered_groups(found, drawn)
    areas = sorted(found.rooms[k].area for group in groups for k in group)
    if not areas or len(areas) > MOST_ROOMS or sum(areas) < LEAST_FLOOR:
        return False
    middle = areas[len(areas) // 2]
    if not USUAL_ROOM[0] <= middle <= USUAL_ROOM[1]:
        return False
    together = sum(found.rooms[k].area for k in groups[0]) >= 0.3 * sum(areas)
    return together and bool(found.gaps or drawn.arcs or len(drawn.doors))


def entered_groups(found: Faces, drawn: Drawn) -> list[list[int]]:
    """Rooms in groups that lie apart, the largest first: those with a way in, where any has one;
    elevations and sections beside a plan have none."""
    ways = [gap.middle for gap in found.gaps] + [np.array(arc.middle) for arc in drawn.arcs]
    ways += list(drawn.doors.mean(1))
    groups = group_rooms(found.rooms)
    if not ways or not groups:
        return groups
    tree = shapely.STRtree(shapely.points(np.array(ways)))
    near, _ = tree.query(found.rooms, predicate="dwithin", distance=WAY_IN)
    entered = set(near.tolist())
    return [group for group in groups if not entered.isdisjoint(group)] or groups


def group_rooms(rooms: list[Polygon], apart: float = 1.2) -> list[list[int]]:
    """Rooms in groups that lie beside each other: the storeys of a sheet, the largest first."""
    if not rooms:
        return []
    grown = shapely.union_all([room.buffer(apart / 2) for room in rooms])
    parts = list(shapely.get_parts(grown))
    homes = [
        int(np.argmax([part.contains(room.representative_point()) for part in parts]))
        for room in rooms
    ]
    groups: dict[int, list[int]] = {}
    for number, home in enumerate(homes):
        groups.setdefault(home, []).append(number)
    return sorted(groups.values(), key=lambda group: -sum(rooms[k].area for k in group))
