"""Rows of the sources that end at an area, continued into it: their strings unfolded onward.

A row goes on straight from its last building: the same kinds in the same order with the same gaps,
each front as far before or behind the line as in the source, from the start of the string or, by
chance, from behind one of its passages.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.domains.extend.problem import ExtendProblem, Floats, StandingGround
from scenewright.domains.extend.solvers.canvas import Canvas
from scenewright.ground.buildings.built import BuiltFrames, BuiltRoad, from_frames, to_frames
from scenewright.ground.buildings.rows import WIDE, BuildingRow, find_rows

NEAR, STEP, MOST = 30.0, 1.0, 400
"""Metres between the end of a row and the area within which it goes on, metres a building moves on
where it cannot stand, and most buildings of one row."""
STRAIGHT = 8
"""Metres that may be moved on in a row before the row ends."""
FRONTAGE = 25.0
"""Metres within which a front faces a street."""


class RowString(NamedTuple):
    """A row to go on with: the buildings of the sources in order (outwards), the gap after each,
    how far each front stands before the row's line, and the frame (5,) at the end of the row: x, y
    on the line of the fronts, heading, 1, 1; ``side`` 1 to the right, -1 to the left; and the
    ``setbacks`` of the fronts from the middle of the street (infinite: there is none)."""

    origins: tuple[int, ...]
    gaps: tuple[float, ...]
    before: tuple[float, ...]
    frame: Floats
    side: float
    setbacks: tuple[float, ...]


class RowsToContinue(NamedTuple):
    """The strings of all rows that end near an area, and the streets about them."""

    strings: tuple[RowString, ...]
    streets: shapely.Geometry


def read_rows(problem: ExtendProblem) -> RowsToContinue:
    """The rows of what stands that may go on into the area."""
    streets, standing = union_streets(problem.roads), problem.standing
    known = np.flatnonzero(standing.origin >= 0)
    if len(known) < 3:
        return RowsToContinue((), streets)
    frames = BuiltFrames(standing.boxes[known], standing.shapes[known], np.ones(len(known)))
    strings = [
        _string(standing, known, row, side, streets)
        for row in find_rows(frames)
        for side in (1.0, -1.0)
    ]
    return RowsToContinue(tuple(s for s in strings if _enters(problem, s)), streets)


def continue_rows(canvas: Canvas, rows: RowsToContinue, rng: np.random.Generator) -> int:
    """Continue all rows of buildings; how many were added."""
    made = 0
    for string in rows.strings:
        canvas.tell()
        made += _go_on(canvas, string, rows.streets, rng)
    return made


def _string(
    standing: StandingGround,
    known: np.ndarray,
    row: BuildingRow,
    side: float,
    streets: shapely.Geometry,
) -> RowString:
    members = known[list(row.members)].tolist()
    gaps = list(row.gaps)
    if side < 0:
        members, gaps = members[::-1], gaps[::-1]
    boxes = standing.boxes[members]
    last = boxes[-1]
    frame = np.array([last[0], last[1], row.heading, 1.0, 1.0])
    local = to_frames(boxes[:, :2], frame)
    fronts = local[:, 1] + boxes[:, 4] / 2
    line = float(np.median(fronts))
    frame[:2] = from_frames(np.array([side * last[3] / 2, line]), frame)
    between = max(gaps)
    return RowString(
        tuple(int(v) for v in standing.origin[members]),
        (*gaps, between),
        tuple((fronts - line).tolist()),
        frame,
        side,
        tuple(setback_of(box, streets) for box in boxes),
    )


def union_streets(roads: Sequence[BuiltRoad]) -> shapely.Geometry:
    """The middle lines of those roads that are streets."""
    return shapely.union_all([shapely.LineString(r.line) for r in roads if r.kind == "road"])


def setback_of(box: Floats, streets: shapely.Geometry) -> float:
    """Metres from the middle of the front of a box (5,) to the nearest street; infinite where that
    is farther than :data:`FRONTAGE`."""
    ahead = np.array([np.cos(box[2]), np.sin(box[2])])
    front = shapely.Point(box[:2] + ahead * box[4] / 2)
    away = float(shapely.distance(front, streets)) if not streets.is_empty else np.inf
    return away if away <= FRONTAGE else np.inf


def face_street(pose: Floats, deep: float, setback: float, streets: shapely.Geometry) -> Floats:
    """A pose (3,) moved and turned to stand ``setback`` from a street and face it, where one is
    near and its original faces one: rows follow streets that bend.

    >>> street = shapely.LineString([(-20, 1), (20, 1)])
    >>> face_street(np.array([0.0, -9.0, np.pi / 2]), 8.0, 5.0, street).round(3).tolist()
    [0.0, -8.0, 1.571]
    """
    if not np.isfinite(setback) or streets.is_empty:
        return pose
    ahead = np.array([np.cos(pose[2]), np.sin(pose[2])])
    front = pose[:2] + ahead * deep / 2
    near = shapely.get_coordinates(shapely.shortest_line(shapely.Point(front), streets))[-1]
    step = near - front
    length = float(np.hypot(*step))
    if length < 1e-6 or length > 1.6 * FRONTAGE or step @ ahead < 0.7 * length:
        return pose
    way = step / length
    middle = near - way * (setback + deep / 2)
    return np.array([*middle, np.arctan2(way[1], way[0])])


def _enters(problem: ExtendProblem, row: RowString) -> bool:
    """Whether a row ends near the area and goes on into it."""
    start = shapely.Point(row.frame[:2])
    ahead = shapely.Point(from_frames(np.array([row.side * NEAR, -5.0]), row.frame))
    outline, line = problem.outline, shapely.LineString([start, ahead])
    return bool(outline.distance(start) <= NEAR and outline.intersects(line))


def _go_on(
    canvas: Canvas, row: RowString, streets: shapely.Geometry, rng: np.random.Generator
) -> int:
    """Lay a row on from its end until it leaves the area or enough is built."""
    outline = canvas.problem.outline
    at, k, made, moved = row.gaps[-1], _begin(row, rng), 0, 0.0
    reach = float(np.hypot(*np.subtract(outline.bounds[2:], outline.bounds[:2]))) + NEAR
    pattern = canvas.problem.pattern
    while at < reach and made < MOST and not canvas.full():
        origin = row.origins[k]
        width, deep = pattern.boxes[origin, 3:]
        spot = np.array([row.side * (at + width / 2), row.before[k] - deep / 2])
        pose = np.array([*from_frames(spot, row.frame), row.frame[2]])
        pose = face_street(pose, float(deep), row.setbacks[k], streets)
        one = np.array([origin])
        if canvas.room_for(origin) and canvas.legal(pose[None], one)[0]:
            canvas.add(pose, origin, "continued")
            at, made, moved = at + width + row.gaps[k], made + 1, 0.0
        elif not canvas.room_for(origin):
            moved += 0.5
        else:
            at, moved = at + STEP, moved + STEP
            if moved <= NEAR if not made else moved <= STRAIGHT:
                continue
            if made:
                break
        k = (k + 1) % len(row.origins)
        if moved > 2 * NEAR:
            break
    return made


def _begin(row: RowString, rng: np.random.Generator) -> int:
    """Where in the string a row goes on: at its start, or behind a passage."""
    usual = float(np.median(row.gaps))
    behind = [0, *(k + 1 for k, gap in enumerate(row.gaps[:-1]) if gap > WIDE * usual + 1.0)]
    return int(rng.choice(behind))
