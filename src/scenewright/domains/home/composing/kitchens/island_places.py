"""Where an island may stand before a kitchen run, and the passages round it.

Kitchen planners ask for a work aisle of 42 inches for one cook and walkways of 36 inches (NKBA,
Planning Guidelines, 2012, 6 and 7); here a metre is free on all four sides.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.furnishing.obstacles import flat_kinds
from scenewright.domains.home.measures import RAISED

Floats = NDArray[np.float64]

PASSAGE = 1.0  # free on all sides of an island, metres
AISLES = (1.0, 1.1, 1.2)  # between the fronts of a run and its island, metres
ALONG, STEP = 1.6, 0.1  # from the middle of hob and sink, and between places, metres
SLACK = 0.01  # by which a passage may be narrower, metres


class RunFront(NamedTuple):
    """The front of a run: the point before the middle of its hob and sink, and the direction in
    which it looks."""

    x: float
    y: float
    heading: float


def clear_floor(task: RoomTask, standing: tuple[Piece, ...]) -> shapely.Geometry:
    """The floor of a room on which nothing stands but seats, which are pushed under tables."""
    flat = flat_kinds(task.catalog)
    kinds = task.catalog.kinds
    solid = [
        p
        for p in standing
        if p.pose.z < 1.0 and p.category not in flat and not kinds[p.category].under
    ]
    floor = shapely.Polygon(task.space.outline, list(task.space.holes))
    clear = floor.difference(shapely.union_all(polygons_of(solid)))
    shapely.prepare(clear)
    return clear


def has_hob(run: FurnishedGroup) -> bool:
    """Whether one cooks at a run: a short one may be but a sink."""
    return any(p.category == "hob_cabinet" and p.pose.z < RAISED for p in run.pieces)


def front_of(run: FurnishedGroup) -> RunFront:
    """The front of the line of a run in which its hob is; it has one."""
    units = [p for p in run.pieces if p.pose.z < RAISED]
    hob = next(p for p in units if p.category == "hob_cabinet")
    turn = hob.pose.heading
    line = [p for p in units if p.category == "sink_cabinet" and abs(p.pose.heading - turn) < 0.1]
    shift = 0.0
    for sink in line:
        dx, dy = sink.pose.x - hob.pose.x, sink.pose.y - hob.pose.y
        shift = (dx * np.sin(turn) - dy * np.cos(turn)) / 2
    out = hob.size.depth / 2
    x = hob.pose.x + out * np.cos(turn) + shift * np.sin(turn)
    y = hob.pose.y + out * np.sin(turn) - shift * np.cos(turn)
    return RunFront(float(x), float(y), turn)


def list_island_places(case: Group, front: RunFront, clear: shapely.Geometry) -> Iterator[Floats]:
    """The boxes ``(5,)`` of an island before a front that have their passages, the nearest
    first."""
    body = next(m for m in case.members if m.category == "kitchen_island")
    back = body.y - body.size.depth / 2
    c, s = np.cos(front.heading), np.sin(front.heading)
    count = round(ALONG / STEP)
    size = [side + 2 * (PASSAGE - SLACK) for side in body.size[:2]]
    steps = np.array(sorted(range(-count, count + 1), key=abs)) * STEP
    for aisle in AISLES:
        out = aisle - back
        x, y = front.x + steps * s + out * c, front.y - steps * c + out * s
        middles = x + body.y * c, y + body.y * s
        around = np.column_stack([*middles, *(np.full_like(x, v) for v in (front.heading, *size))])
        free = shapely.contains(clear, shapely.polygons(corners(around)))
        for k in np.flatnonzero(free):
            yield np.array([x[k], y[k], front.heading, case.width, case.depth])


def has_passages(task: RoomTask, placed: Placed) -> bool:
    """Whether the passages round an island are free of all else that stands."""
    body = next(q for p in placed for q in p.pieces if q.category == "kitchen_island")
    others = [q for p in placed if p.wish.group != "island" for q in p.pieces]
    floor = clear_floor(task, (*task.fixed, *task.beside, *others))
    (x, y, _, turn), size = body.pose, body.size
    wide, deep = (side + 2 * (PASSAGE - SLACK) for side in (size.width, size.depth))
    return bool(
        shapely.contains(floor, shapely.polygons(corners(np.array([[x, y, turn, wide, deep]])))[0])
    )
