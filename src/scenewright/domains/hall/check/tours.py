"""The visitors' tour, measured again: where it goes, how wide it is, what it passes.

The clear width at a point is twice its distance to the nearest wall, partition or piece, so a
person or wheelchair that follows the line has it on both sides. Doorways belong to the floor.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.check.bodies import Bodies, Floats, Indices
from scenewright.check.routes import JoinedFloor
from scenewright.core.space import Opening
from scenewright.domains.hall.check.halls import JudgedHall
from scenewright.domains.hall.check.passages import describe_neighbours
from scenewright.domains.hall.check.sight import FAR, NEAR, resample_line

_STEP = 0.1
_MOST_POINTS = 20_000
_AT_DOOR = 1.0
_MOST_NAMED = 20


class Line(NamedTuple):
    """A tour in small steps: points (k, 2), the clear width (k,) at each and the row of what is
    nearest (k,), -1 a wall; width 0 where something stands or outside."""

    points: Floats
    widths: Floats
    nearest: Indices


def tour_figures(
    bodies: Bodies, hall: JudgedHall, ground: JoinedFloor, seen: Floats, wanted: float
) -> dict[str, Any]:
    """What there is to tell of the tour of a hall (empty if it has none).

    ``seen`` is from how far each object is seen on it, ``wanted`` the clear width in metres
    under which a place is a bottleneck. ``traversal`` is the share of objects passed within 3 m
    and in sight, ``seen`` of those seen from 15 m. ``seen`` (n,) in metres, one for each of the
    hall's objects.
    """
    if hall.tour is None:
        return {}
    line = line_of(bodies, hall, ground)
    passed = set(hall.objects[seen <= NEAR].tolist())
    unseen = [bodies.pieces[row].id for row in hall.objects[seen > FAR]]
    length = float(shapely.length(shapely.linestrings(hall.tour)))
    return {
        "length": round(length, 2),
        "free": bool((line.widths > 0).all()),
        "least_width": round(float(line.widths.min()), 3),
        "mean_width": round(float(line.widths.mean()), 3),
        "from_entrance": _at_door(hall, hall.tour[0], "exit"),
        "to_exit": _at_door(hall, hall.tour[-1], "entrance"),
        "bottlenecks": bottlenecks(bodies, hall, line, wanted),
        "groups_missed": [g.id for g in hall.groups if len(g.rows) and not passed & set(g.rows)],
        "traversal": _share(seen <= NEAR),
        "seen": _share(seen <= FAR),
        "unseen": unseen[:_MOST_NAMED],
    }


def _share(flags: Any) -> float:
    return round(float(np.mean(flags)), 4) if len(flags) else 1.0


def _at_door(hall: JudgedHall, point: Floats, other_way: str) -> bool:
    """Whether a point is within 1 m of a door that is not only for the other way."""
    doors: list[Opening] = [o for o in hall.space.openings if o.kind != "window"]
    usable = [o for o in doors if _use(o, hall) != other_way] or doors
    apart = [max(np.hypot(*(point - (o.x, o.y))) - o.width / 2, 0.0) for o in usable]
    return bool(min(apart, default=np.inf) <= _AT_DOOR)


def _use(opening: Opening, hall: JudgedHall) -> str:
    """Which way visitors go through a door, seen from a hall."""
    if opening.spaces[:1] == (hall.space.id,):
        return opening.use
    return {"entrance": "exit", "exit": "entrance"}.get(opening.use, "both")


def line_of(bodies: Bodies, hall: JudgedHall, ground: JoinedFloor) -> Line:
    """The tour of a hall every 0.1 m, with its clear widths."""
    assert hall.tour is not None
    length = float(shapely.length(shapely.linestrings(hall.tour)))
    points = resample_line(hall.tour, max(_STEP, length / _MOST_POINTS))[: 2 * _MOST_POINTS]
    shapes = shapely.points(points)
    edge = shapely.boundary(ground.floor)
    shapely.prepare(edge)
    wall = np.asarray(shapely.distance(edge, shapes))
    shapely.prepare(ground.floor)
    wall[~shapely.intersects(ground.floor, shapes)] = 0.0
    nearest = np.full(len(points), -1, np.int64)
    if len(hall.solids):
        tree = shapely.STRtree(bodies.footprints[hall.solids])
        (index, which), apart = tree.query_nearest(shapes, return_distance=True, all_matches=False)
        closer = apart < wall[index]
        nearest[index[closer]] = hall.solids[which[closer]]
        wall[index] = np.minimum(wall[index], apart)
    return Line(points, 2 * wall, nearest)


def bottlenecks(
    bodies: Bodies, hall: JudgedHall, line: Line, wanted: float
) -> list[dict[str, Any]]:
    """Where the tour is narrower than ``wanted`` metres: the narrowest place of each stretch, the
    objects on both sides, the narrowest first.

    Near the doors, where the width is that of the opening, nothing is reported.
    """
    narrow = line.widths < wanted
    for opening in hall.space.openings:
        if opening.kind != "window":
            away = np.hypot(*(line.points - (opening.x, opening.y)).T)
            narrow &= away > (opening.width + opening.thickness) / 2
    stretches = np.flatnonzero(np.diff(np.concatenate([[0], narrow.astype(int), [0]])))
    places = [a + int(np.argmin(line.widths[a:b])) for a, b in stretches.reshape(-1, 2)]
    places.sort(key=lambda k: (line.widths[k], k))
    return [_describe_bottleneck(bodies, hall, line, k) for k in places[:_MOST_NAMED]]


def _describe_bottleneck(bodies: Bodies, hall: JudgedHall, line: Line, k: int) -> dict[str, Any]:
    x, y = (round(float(v), 2) for v in line.points[k])
    rows = _both_sides(bodies, hall, line, k)
    width = float(line.widths[k])
    words = f"{width:.2f} m {describe_neighbours(bodies, rows)} at ({x:.2f}, {y:.2f})"
    between = [bodies.pieces[row].id if row >= 0 else "" for row in rows]
    return {"width": round(width, 3), "at": [x, y], "between": between, "message": words}


def _both_sides(bodies: Bodies, hall: JudgedHall, line: Line, k: int) -> tuple[int, ...]:
    """The nearest thing, and the nearest on the other side of the tour."""
    here = shapely.Point(line.points[k])
    shapes = [*bodies.footprints[hall.solids], shapely.boundary(hall.shape)]
    names = [*hall.solids.tolist(), -1]
    ends = shapely.get_coordinates(shapely.shortest_line(here, np.array(shapes, object)))
    away = ends[1::2] - line.points[k]
    apart = np.hypot(*away.T)
    first = names.index(int(line.nearest[k]))
    other = np.flatnonzero((away @ away[first] < 0) & (apart < 3 * apart[first] + 1))
    if not len(other):
        return (names[first],)
    return names[first], names[int(other[np.argmin(apart[other])])]
