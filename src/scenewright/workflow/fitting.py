"""The nearest place that fits: where a piece could stand without a new finding."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np
import shapely
from shapely.affinity import rotate, translate
from shapely.ops import nearest_points

from scenewright.catalog.loading import catalog_of
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece
from scenewright.workflow.judging import MoveJudge

RINGS, AROUND = 28, 16
"""Rings round the wanted place that are tried, and places on each."""
PART, WIDER = 0.1, 0.06
"""Of a piece's longer side from ring to ring, and by which share each is wider than the one
before."""
JUDGED = 24
"""Places with nothing in the way that the referee is asked about at most."""
TOUCH = 0.005
"""Metres by which things beside one another may overlap."""

Place = tuple[float, float, float]


def find_nearest_fit(judge: MoveJudge, name: str, wanted: Sequence[float]) -> Place | None:
    """The place (x, y, heading) nearest to a wanted one where a piece, with all that lies on it,
    stands without a finding that there is not now; ``None`` where there is none among those tried.

    >>> import scenewright as sw
    >>> judge = MoveJudge(sw.solve(sw.read("sample:home-room"), steps=200))
    >>> x, y, _ = find_nearest_fit(judge, "room/desk/desk", (-9.0, -9.0, 0.0))
    >>> x > 0, y > 0, judge.find_new({"room/desk/desk": (x, y, 0.0)}) == ()
    (True, True, True)
    """
    moved = judge.carry_to(name, wanted)
    free = _list_free(judge, moved[name], {*moved})
    for _, place in zip(range(JUDGED), free, strict=False):
        if not judge.find_new({name: place}):
            return place
    return None


def _list_free(judge: MoveJudge, piece: Piece, carried: set[str]) -> Iterator[Place]:
    """Places on the floor with nothing in the way, the nearest first; as it is turned, then by
    quarter turns."""
    floor, taken = _floor_of(judge, piece), _standing(judge, piece, carried)
    x, y, heading = piece.pose.x, piece.pose.y, piece.pose.heading
    shape = shapely.Polygon(outline_of(piece)).buffer(-TOUCH, join_style="mitre")
    for turn in (0.0, math.pi / 2, -math.pi / 2, math.pi):
        turned = rotate(shape, turn, (x, y), use_radians=True)
        for dx, dy in _offsets(floor, (x, y), max(piece.size[:2])):
            there = translate(turned, dx, dy)
            if floor.covers(there) and not taken.query(there, "intersects").size:
                yield float(x + dx), float(y + dy), heading + turn


def _offsets(
    floor: shapely.Geometry, at: tuple[float, float], side: float
) -> list[tuple[float, float]]:
    """Ways from a place to those round the point of the floor that is nearest to it."""
    inner = floor.buffer(-side / 2)
    point = shapely.Point(at)
    start = nearest_points(floor if inner.is_empty else inner, point)[0]
    centre = point if floor.covers(point) else start
    steps, angles = np.arange(RINGS), np.arange(AROUND) * math.tau / AROUND
    radii = PART * side * steps * (1 + WIDER * steps)
    spots = [
        (centre.x + r * math.cos(a) - at[0], centre.y + r * math.sin(a) - at[1])
        for r in radii
        for a in (angles if r else angles[:1])
    ]
    return sorted(spots, key=lambda spot: math.hypot(*spot))


def _floor_of(judge: MoveJudge, piece: Piece) -> shapely.Geometry:
    """The floor of the space that a piece belongs to."""
    spaces = judge.plan.spaces
    own = [s for s in spaces if s.id == piece.space] or [*spaces]
    return shapely.union_all([shapely.Polygon(s.outline, [*s.holes]) for s in own]).buffer(TOUCH)


def _standing(judge: MoveJudge, piece: Piece, carried: set[str]) -> shapely.STRtree:
    """What stands in the way of a piece: all on its storey that is as low, but for rugs."""
    kinds = catalog_of(judge.solution.brief.catalogs).kinds
    flat = {kind.category for kind in kinds.values() if kind.flat}
    level = {one.id: one.level for one in judge.plan.spaces}
    top = piece.pose.z + piece.size.height
    shapes = [
        shapely.Polygon(outline_of(one))
        for one in judge.solution.pieces
        if one.id not in carried and one.on is None and one.category not in flat
        if level.get(one.space) == level.get(piece.space) and one.pose.z < top
    ]
    return shapely.STRtree(shapes if piece.category not in flat else [])
