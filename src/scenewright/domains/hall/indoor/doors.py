"""Doors of an indoor map: points on outlines, openings of shop fronts, open borders of ways.

A door is listed once, in the unit it opens (else the room, else the way), at the nearest wall on
which it fits.
"""

from __future__ import annotations

import re
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.building import outlines
from scenewright.core.brief import Door
from scenewright.core.space import Points
from scenewright.domains.hall.indoor.floors import MAP_WALL, IndoorFloor

REACH = 0.3
NEIGHBOUR = 0.5
LEAST_WIDTH = 0.6
DOOR_END = 0.02
SLIDE = 0.6
SINGLE_DOOR = 0.9
DOUBLE = 1.8
WIDEST_LEAF = 1.1
FRONT_SHARE = 0.6
WIDEST_FRONT = 3.0
LEAST_FRONT = 0.7
WIDEST_BORDER = 20.0
THICKEST = 0.65
MOST_DOORS = 200
_NUMBER = re.compile(r"\d{1,3}(?:[.,]\d{1,4})?")


class FloorWalls(NamedTuple):
    """The clear outline of a floor (inside its walls) as runs ``(n, 2)``, and its floor."""

    runs: list[Points]
    floor: IndoorFloor


class PlacedDoor(NamedTuple):
    """A door put on a wall: in which floor, where, along which direction."""

    number: int
    door: Door
    along: tuple[float, float]


def walls_of(floors: list[IndoorFloor]) -> list[FloorWalls]:
    """Clear outlines of floors, as :mod:`scenewright.building.plan` will see them."""
    found = []
    for floor in floors:
        clear, _ = outlines.rings(outlines.shrink(floor.polygon, MAP_WALL / 2))
        found.append(FloorWalls(outlines.wall_runs(clear), floor))
    return found


def place_marked_doors(
    walls: list[FloorWalls], points: list[tuple[str, dict[str, str], Points]]
) -> tuple[list[PlacedDoor], list[tuple[str, str]]]:
    """Doors marked by points (id, tags, position) of one level, and those that found no wall,
    with the reason."""
    tree = shapely.STRtree([wall.floor.polygon.exterior for wall in walls])
    placed: list[PlacedDoor] = []
    lost: list[tuple[str, str]] = []
    ranks = {"unit": 0, "room": 1, "way": 2}
    for name, tags, at in points:
        near = tree.query(shapely.Point(at), predicate="dwithin", distance=REACH).tolist()
        if not near:
            lost.append((name, f"a door more than {REACH:g} m from every outline"))
            continue
        near.sort(key=lambda i: (ranks[walls[i].floor.role], i))
        tries = (_place_marked_door(walls[i], i, name, tags, at) for i in near)
        fits = [entry for entry in tries if entry is not None]
        clear = next((entry for entry in fits if not _clashes(entry, placed)), None)
        if clear is None:
            lost.append(
                (name, "a door on top of another" if fits else "a door wider than its wall")
            )
        else:
            placed.append(clear)
    return placed, lost


def front(
    walls: list[FloorWalls], tree: shapely.STRtree, number: int, placed: list[PlacedDoor]
) -> PlacedDoor | None:
    """An opening assumed for a unit without a door: on the longest straight edge it shares with
    a way, else (on the ground floor) the longest edge to the outside, else with any room.

    ``tree`` holds the polygons of ``walls``.
    """
    wall = walls[number]
    near = tree.query(wall.floor.polygon, predicate="dwithin", distance=NEIGHBOUR).tolist()
    beside = [walls[i].floor for i in near if i != number]
    ways = [floor.polygon for floor in beside if floor.role == "way"]
    rooms = [floor.polygon for floor in beside if floor.role != "way"]
    sides = [_facing(wall, ways), _facing(wall, rooms)]
    if wall.floor.level == 0:
        sides.insert(1, _facing(wall, ways + rooms, away=True))
    for side in sides:
        for start, end in sorted(side, key=_length, reverse=True)[:8]:
            width = min(FRONT_SHARE * _length((start, end)), WIDEST_FRONT)
            name = f"assumed-{wall.floor.feature}-{wall.floor.level:g}-{number}"
            if width < LEAST_FRONT:
                continue
            entry = _on(wall, number, (start + end) / 2, width, name, "none")
            if entry is not None and not _clashes(entry, placed):
                return entry
    return None


def borders(
    walls: list[FloorWalls], joined: set[tuple[int, int]], placed: list[PlacedDoor]
) -> list[PlacedDoor]:
    """Open passages on the longest border that each two ways share and no door joins."""
    ways = [i for i, wall in enumerate(walls) if wall.floor.role == "way"]
    tree = shapely.STRtree([walls[i].floor.polygon for i in ways])
    found: list[PlacedDoor] = []
    for first in ways:
        near = tree.query(walls[first].floor.polygon, predicate="dwithin", distance=0.1).tolist()
        for second in (ways[k] for k in near):
            if second <= first or (first, second) in joined:
                continue
            sides = _facing(walls[first], [walls[second].floor.polygon], 0.15)
            if not sides:
                continue
            start, end = max(sides, key=_length)
            width = min(_length((start, end)) - 0.3, WIDEST_BORDER)
            name = f"open-{walls[first].floor.feature}-{first}-{second}"
            entry = _on(walls[first], first, (start + end) / 2, width, name, "none")
            if width >= LEAST_FRONT and entry is not None and not _clashes(entry, placed + found):
                found.append(entry)
    return found


def _place_marked_door(
    wall: FloorWalls, number: int, name: str, tags: dict[str, str], at: Points
) -> PlacedDoor | None:
    shop = wall.floor.role == "unit" or tags.get("entrance") == "main"
    width = _width(tags) or (DOUBLE if shop else SINGLE_DOOR)
    kind = tags.get("door", "no")
    swing = "none" if kind == "no" else "in" if kind in ("hinged", "yes", "swinging") else "slide"
    if tags.get("automatic_door", "no") != "no" or (swing == "in" and width > WIDEST_LEAF):
        swing = "slide"
    use = {"exit": "exit", "emergency": "exit", "entrance": "entrance"}.get(
        tags.get("entrance", ""), "both"
    )
    return _on(wall, number, at, width, name, swing, use)


def _width(tags: dict[str, str]) -> float:
    """Width of a door by its tags, in metres; 0 where they give none that is likely."""
    for key in ("door:width", "width"):
        found = _NUMBER.match(tags.get(key, ""))
        if found:
            width = float(found[0].replace(",", "."))
            width = width / 100 if width > 30 else width
            if LEAST_WIDTH <= width <= 10:
                return width
    return 0.0


def _on(
    wall: FloorWalls,
    number: int,
    at: Points,
    width: float,
    name: str,
    swing: str,
    use: str = "both",
) -> PlacedDoor | None:
    """The door on the nearest run of the wall that holds it, narrowed or moved a little."""
    best: tuple[float, Points, Points, float] | None = None
    for run in wall.runs:
        s, away = outlines.project(run, at)
        lengths = outlines.run_lengths(run)
        fits = min(width, float(lengths[-1]) - 2 * DOOR_END)
        if away > REACH + MAP_WALL or fits < LEAST_WIDTH:
            continue
        slid = min(max(s, fits / 2 + DOOR_END), float(lengths[-1]) - fits / 2 - DOOR_END)
        cost = away + abs(slid - s)
        if abs(slid - s) > SLIDE or (best is not None and cost >= best[0]):
            continue
        ends = slid + np.array([-0.5, 0.0, 0.5]) * fits
        points = np.column_stack([np.interp(ends, lengths, run[:, axis]) for axis in (0, 1)])
        best = (cost, points[1], points[2] - points[0], fits)
    if best is None:
        return None
    _, middle, along, fits = best
    along = along / np.hypot(*along)
    door = Door.model_validate(
        {
            "at": middle.round(4).tolist(),
            "width": round(fits, 3),
            "swing": swing,
            "use": use,
            "id": name,
        }
    )
    return PlacedDoor(number, door, (float(along[0]), float(along[1])))


def _clashes(entry: PlacedDoor, placed: list[PlacedDoor]) -> bool:
    """Whether a door would share a piece of wall with one placed before, or its room is full."""
    (ux, uy), (x, y) = entry.along, entry.door.at
    for other in placed:
        dx, dy = other.door.at[0] - x, other.door.at[1] - y
        if abs(dx) + abs(dy) > 40:
            continue
        beside = abs(ux * other.along[0] + uy * other.along[1]) > 0.85
        along, across = abs(dx * ux + dy * uy), abs(dx * uy - dy * ux)
        if beside and across < THICKEST and along < (entry.door.width + other.door.width) / 2:
            return True
    return sum(other.number == entry.number for other in placed) >= MOST_DOORS


def _facing(
    wall: FloorWalls, others: list[shapely.Polygon], reach: float = NEIGHBOUR, *, away: bool = False
) -> list[tuple[Points, Points]]:
    """Straight pieces of a wall that face one of the ``others`` (or, ``away``, none of them)."""
    edges = [shapely.LineString(run[i : i + 2]) for run in wall.runs for i in range(len(run) - 1)]
    near = shapely.union_all([shapely.buffer(o, reach, join_style="mitre") for o in others])
    cut = shapely.difference(edges, near) if away else shapely.intersection(edges, near)
    pieces = [p for p in shapely.get_parts(cut) if isinstance(p, shapely.LineString) and p.length]
    ends = [shapely.get_coordinates(piece)[[0, -1]] for piece in pieces]
    return [(pair[0], pair[1]) for pair in ends]


def _length(edge: tuple[Points, Points]) -> float:
    return float(np.hypot(*(edge[1] - edge[0])))
