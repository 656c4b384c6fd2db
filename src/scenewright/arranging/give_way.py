"""Least change by hand: what a changed piece runs into moves to the nearest free place.

Nothing else moves. Where no place is free without, what stands there gives way in its turn; each
moves once at most.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.piece_edits import carry_pieces, frame_of
from scenewright.core.piece_outlines import outline_of, polygons_of
from scenewright.core.scene import Piece, Pose

TOUCH = 0.005
"""Metres by which things beside one another may overlap."""
BACKED = 0.06
"""Metres between the back of a piece and a wall it stands against, at most."""
RINGS = ((0.6, 0.05), (3.0, 0.15), (12.0, 0.5))
"""How far places are tried, and in what steps, in metres: near by first, then wider."""
TURNS = (0.0, math.pi / 2, -math.pi / 2, math.pi)
Floats = NDArray[np.float64]
Frame = tuple[float, float, float]


class Ways(NamedTuple):
    """What pieces may do: the ``units`` that move as one, by the id of each piece; the ``floor``
    each piece may stand on; what stays where it is (``held``); what nothing runs into
    (``through``: rugs); the metres kept ``apart`` where they were there before; which pieces are
    ``walls`` within spaces; the metres in ``front`` of a piece that it is used from; and how many
    times as far, in steps as much longer, places are tried. What is put in keeps ``apart`` from
    all where that is ``strict``."""

    units: Mapping[str, tuple[str, ...]]
    floor: Callable[[Piece], shapely.Geometry]
    held: Collection[str] = frozenset()
    through: Callable[[Piece], bool] = lambda _piece: False
    apart: float = 0.0
    walls: Callable[[Piece], bool] = lambda _piece: False
    front: float = 0.0
    times: float = 1.0
    strict: bool = False


class GaveWay(NamedTuple):
    """All pieces, the ids of those that moved to make room, and of those that found none."""

    pieces: tuple[Piece, ...]
    moved: frozenset[str]
    stuck: tuple[str, ...]


def give_way(
    before: Sequence[Piece], after: Sequence[Piece], changed: Collection[str], ways: Ways
) -> GaveWay:
    """Pieces ``after`` a change, with all that those ``changed`` run into, and did not ``before``,
    at the nearest free place."""
    now = {piece.id: piece for piece in after}
    queue = _find_hit(before, now, changed, ways)
    settled, moved, stuck = {*changed, *ways.held}, set[str](), list[str]()
    while queue:
        unit = queue.pop(0)
        settled |= {*unit}
        waiting = {name for other in queue for name in other}
        place = _find_place(now, unit, settled, waiting, ways)
        if place is None:
            stuck.append(unit[0])
            continue
        carried = _carry(now, unit, place.frame)
        now |= carried
        moved |= carried.keys()
        queue += [ways.units[name] for name in place.pushed]
    return GaveWay(tuple(now.values()), frozenset(moved), tuple(stuck))


def nearest_place(
    pieces: Sequence[Piece], unit: Sequence[str], wanted: Frame, ways: Ways
) -> Frame | None:
    """The free place for a unit nearest to the one wanted for its first piece; none if there is
    none within reach. All other pieces stay."""
    now = {piece.id: piece for piece in pieces}
    now |= _carry(now, unit, wanted)
    found = _find_place(now, tuple(unit), {*now}, (), ways, stay=True)
    return found.frame if found else None


class _Place(NamedTuple):
    frame: Frame
    pushed: tuple[str, ...]


def _find_hit(
    before: Sequence[Piece], now: Mapping[str, Piece], changed: Collection[str], ways: Ways
) -> list[tuple[str, ...]]:
    """Units that something changed runs into now and did not before, the nearest first."""
    was = {piece.id: piece for piece in before}
    found: dict[tuple[str, ...], float] = {}
    for name in changed:
        one = now.get(name)
        if one is None or ways.through(one):
            continue
        there = [
            p
            for p in now.values()
            if p.id not in changed and p.id not in ways.held and _may_meet(one, p, ways)
        ]
        for other in _hitting(one, there):
            if name in was and other.id in was and _hitting(was[name], [was[other.id]]):
                continue
            unit = ways.units.get(other.id)
            if unit and not {*unit} & {*ways.held, *changed}:
                found[unit] = math.dist(one.pose[:2], other.pose[:2])
    return sorted(found, key=lambda unit: (found[unit], unit))


def _may_meet(one: Piece, other: Piece, ways: Ways) -> bool:
    """Whether two pieces could run into each other: in one space, at the same height."""
    if one.space != other.space or ways.through(other) or one.on == other.id or other.on == one.id:
        return False
    low = max(one.pose.z, other.pose.z)
    return low < min(one.pose.z + one.size.height, other.pose.z + other.size.height) - TOUCH


def _hitting(one: Piece, others: Sequence[Piece]) -> list[Piece]:
    if not others:
        return []
    shape = shapely.Polygon(outline_of(one)).buffer(-TOUCH)
    met = shapely.intersects(shape, polygons_of(others))
    return [other for other, hit in zip(others, met.tolist(), strict=True) if hit]


def _carry(now: Mapping[str, Piece], unit: Sequence[str], frame: Frame) -> dict[str, Piece]:
    here = [now[name] for name in unit]
    there = carry_pieces(here, frame_of(here[0]), frame)
    return {p.id: replace(p, fixed=q.fixed) for p, q in zip(there, here, strict=True)}


def _find_place(
    now: Mapping[str, Piece],
    unit: tuple[str, ...],
    settled: Collection[str],
    waiting: Collection[str],
    ways: Ways,
    stay: bool = False,
) -> _Place | None:
    """The nearest place for a unit where nothing is in its way; else where only what is not yet
    ``settled`` is, as little of it as can be."""
    here = [now[name] for name in unit]
    lead = here[0]
    others = [
        p
        for p in now.values()
        if p.id not in unit and p.id not in waiting and _may_meet_any(here, p, ways)
    ]
    firm = [p for p in others if p.id in settled or p.id not in ways.units]
    loose = [p for p in others if p not in firm]
    shapes = [shapely.Polygon(outline_of(p)).buffer(-TOUCH) for p in here if not ways.through(p)]
    floor = ways.floor(lead)
    walls = _walls(floor, [p for p in others if ways.walls(p)])
    backed = bool(_back_distance(walls, lead, np.zeros((1, 2)), 0.0)[0] < BACKED)
    every = shapely.union_all(polygons_of([*firm, *loose]))
    near = _keep_apart(None if stay else shapely.union_all(shapes), others, ways.apart)
    used = [*near, *_fronts([*firm, *loose], ways.front)]
    strangers = [p for p in [*firm, *loose] if p in firm or p.group != lead.group]
    tries = [
        (shapes, shapely.union_all(polygons_of(strangers)), backed, RINGS[:1]),
        ([*shapes, *_fronts(here[:1], ways.front)], shapely.union_all(used), backed, RINGS),
        (shapes, every, backed, RINGS),
        *([(shapes, every, False, RINGS)] if backed else ()),
        *([] if stay else [(shapes, shapely.union_all(polygons_of(firm)), backed, RINGS)]),
    ]
    for own, taken, at_wall, rings in tries[1:2] if stay and ways.strict else tries[stay:]:
        scaled = [(far * ways.times, step * ways.times) for far, step in rings]
        frame = _find_free(lead, own, floor, taken, walls if at_wall else None, scaled, stay)
        if frame is not None:
            return _Place(frame, _find_pushed(now, unit, frame, loose, ways))
    return None


def _fronts(pieces: Sequence[Piece], deep: float) -> list[shapely.Geometry]:
    """The ground, some metres ``deep``, before pieces."""
    if not deep or not pieces:
        return []
    ahead = [
        replace(
            p,
            pose=step_ahead(p.pose, (p.size.depth + deep) / 2),
            size=p.size._replace(depth=deep - 2 * TOUCH),
            footprint=(),
        )
        for p in pieces
    ]
    found: list[shapely.Geometry] = polygons_of(ahead).tolist()
    return found


def step_ahead(pose: Pose, ahead: float) -> Pose:
    """A pose some metres further on along its heading.

    >>> step_ahead(Pose(1.0, 2.0, 0.0, 0.0), 0.5)
    Pose(x=1.5, y=2.0, z=0.0, heading=0.0)
    """
    c, s = math.cos(pose.heading), math.sin(pose.heading)
    return pose._replace(x=pose.x + ahead * c, y=pose.y + ahead * s)


def _may_meet_any(here: Sequence[Piece], other: Piece, ways: Ways) -> bool:
    return any(_may_meet(one, other, ways) for one in here if not ways.through(one))


def _find_pushed(
    now: Mapping[str, Piece], unit: Sequence[str], frame: Frame, loose: Sequence[Piece], ways: Ways
) -> tuple[str, ...]:
    """The first piece of every unit that has to give way to one put at ``frame``."""
    there = [p for p in _carry(now, unit, frame).values() if not ways.through(p)]
    hit = {other.id for p in there for other in _hitting(p, loose)}
    return tuple({ways.units[name][0]: None for name in sorted(hit)})


def _keep_apart(
    shape: shapely.Geometry | None, others: Sequence[Piece], apart: float
) -> list[shapely.Geometry]:
    """Outlines of pieces, grown by the metres kept apart: those as far from a ``shape`` now, or
    all."""
    if not others:
        return []
    outlines = polygons_of(others)
    far = np.full(len(outlines), shape is None) | (
        shapely.distance(outlines, shape) >= apart - TOUCH
    )
    grown = shapely.buffer(outlines[far], max(apart - TOUCH, 0.0), quad_segs=2)
    return [*outlines[~far].tolist(), *grown.tolist()]


def _walls(floor: shapely.Geometry, partitions: Sequence[Piece]) -> shapely.Geometry:
    edges = [floor.boundary, *(one.boundary for one in polygons_of(partitions).tolist())]
    return shapely.union_all(edges)


def _back_distance(walls: shapely.Geometry, lead: Piece, at: Floats, turn: float) -> Floats:
    """Metres from the middle of the back of a piece to the nearest wall, moved by ``at`` (k, 2)."""
    heading = lead.pose.heading + turn
    back = np.array(lead.pose[:2]) - lead.size.depth / 2 * np.array(
        [math.cos(heading), math.sin(heading)]
    )
    return np.asarray(shapely.distance(walls, shapely.points(back + at)))


def _find_free(
    lead: Piece,
    shapes: Sequence[shapely.Geometry],
    floor: shapely.Geometry,
    taken: shapely.Geometry,
    walls: shapely.Geometry | None,
    rings: Sequence[tuple[float, float]],
    stay: bool,
) -> Frame | None:
    """The nearest place for a unit on free floor, turned as little as can be; with its back to
    ``walls``, if given."""
    inside = floor.buffer(2 * TOUCH)
    shapely.prepare(inside)
    shapely.prepare(taken)
    start = np.array(lead.pose[:2])
    for far, step in rings:
        for turn in TURNS:
            at = _ring(far, step, lead.pose.heading + turn, stay)
            at = at if walls is None else _set_back(walls, lead, at, turn, step)
            moved = [_move(shape, start, turn, at) for shape in shapes]
            free = np.ones(len(at), np.bool_)
            for outlines in moved:
                free[free] &= shapely.covers(inside, outlines[free])
                free[free] &= ~shapely.intersects(taken, outlines[free])
            if free.any():
                x, y = (start + at[free][0]).tolist()
                return x, y, lead.pose.heading + turn
    return None


def _set_back(walls: shapely.Geometry, lead: Piece, at: Floats, turn: float, step: float) -> Floats:
    """Of the ways to go ``at`` (k, 2) those that end less than a ``step`` before a wall, drawn
    back to it."""
    heading = lead.pose.heading + turn
    ahead = np.array([math.cos(heading), math.sin(heading)])
    away = _back_distance(walls, lead, at, turn)
    near = away < step
    drawn: Floats = at[near] - np.outer(away[near], ahead)
    drawn = drawn[_back_distance(walls, lead, drawn, turn) < TOUCH]
    return drawn[np.argsort(np.hypot(*drawn.T), kind="stable")]


def _ring(far: float, step: float, heading: float, stay: bool) -> Floats:
    """Ways to go (k, 2), the shortest first, along a heading and across it."""
    rows = np.arange(-far, far + step / 2, step)
    along, across = np.meshgrid(rows, rows)
    c, s = math.cos(heading), math.sin(heading)
    at = np.stack([c * along - s * across, s * along + c * across], -1).reshape(-1, 2)
    length = np.hypot(*at.T)
    kept = (length <= far) & ((length > 0) | stay)
    order = np.argsort(np.round(length[kept], 6), kind="stable")
    found: Floats = at[kept][order]
    return found


def _move(shape: shapely.Geometry, about: Floats, turn: float, at: Floats) -> NDArray[np.object_]:
    """A shape turned ``about`` a point and moved by ``at`` (k, 2)."""
    corners = shapely.get_coordinates(shapely.get_exterior_ring(shape))
    c, s = math.cos(turn), math.sin(turn)
    rotated = (corners - about) @ np.array([[c, s], [-s, c]]) + about
    return np.asarray(shapely.polygons(rotated[None] + at[:, None]))
