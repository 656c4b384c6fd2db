"""What furnished rooms tell of distances, free floor and how much of a room is taken."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from math import cos, hypot, pi, remainder, sin

import numpy as np
import shapely

from scenewright.core.catalog import Catalog, Group
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.home.learned.learning import FurnishedSpace, GroupOccurrence
from scenewright.domains.home.learned.rows import SIDES, Beside, Clearance, Distance, Share, Targets
from scenewright.domains.home.learned.space import footprint, measure_coverage

SLIVER = 0.02
FARTHEST = 3.0
"""Free floor is looked for so far before a piece, in metres."""


def targets_of(
    rooms: Sequence[FurnishedSpace], found: Sequence[GroupOccurrence], catalog: Catalog
) -> Targets:
    """Statistics of rooms and of the groups found in them."""
    return Targets(
        _distances(found), _clearances(rooms, found, catalog), tuple(_shares(rooms, found))
    )


def _distances(found: Iterable[GroupOccurrence]) -> tuple[Distance, ...]:
    rooms: dict[tuple[str, str], list[GroupOccurrence]] = defaultdict(list)
    for one in found:
        rooms[one.home, one.room].append(one)
    pairs: dict[tuple[str, str], list[tuple[float, int]]] = defaultdict(list)
    for groups in rooms.values():
        for a in groups:
            for b in groups:
                if a is not b:
                    away = hypot(a.box[0] - b.box[0], a.box[1] - b.box[1])
                    turn = round(abs(remainder(a.box[2] - b.box[2], 2 * pi)) / (pi / 2))
                    pairs[a.case.function, b.case.function].append((away, turn))
    return tuple(_distance(pair, seen) for pair, seen in sorted(pairs.items()))


def _distance(pair: tuple[str, str], seen: list[tuple[float, int]]) -> Distance:
    apart, turned = [away for away, _ in seen], [turn for _, turn in seen]
    low, middle, high = (float(np.quantile(apart, q)) for q in (0.25, 0.5, 0.75))
    turns = turned.count(0), turned.count(1), turned.count(2)
    return Distance(*pair, middle, low, high, len(seen), turns)


def _clearances(
    rooms: Iterable[FurnishedSpace], found: Sequence[GroupOccurrence], catalog: Catalog
) -> tuple[Clearance, ...]:
    """Free floor round the boxes of groups; pieces inside a box do not reduce it."""
    depths: dict[tuple[str, Beside], list[float]] = defaultdict(list)
    for room in rooms:
        floor = shapely.Polygon(room.space.outline, list(room.space.holes))
        others = [footprint(p) for p in room.pieces if stands_on_floor(p, catalog)]
        here = (one for one in found if (one.home, one.room) == (room.home, room.space.id))
        for one in here:
            for number, side in enumerate(SIDES):
                free = free_before(side_of(*one.box, one.case, number), others, floor)
                depths[one.case.function, side].append(free)
    return tuple(
        Clearance(*key, float(np.quantile(free, 0.25)), float(np.median(free)), len(free))
        for key, free in sorted(depths.items())
    )


def side_of(x: float, y: float, heading: float, case: Group, number: int) -> Piece:
    """A group's box as a piece that looks over one of its sides: front, left, back, right."""
    size = (
        Size(case.width, case.depth, 1.0) if number % 2 == 0 else Size(case.depth, case.width, 1.0)
    )
    return Piece("", "", "", "", Pose(x, y, 0.0, heading + number * pi / 2), size)


def free_before(piece: Piece, others: Sequence[shapely.Polygon], floor: shapely.Polygon) -> float:
    """Depth of the free floor before a piece, over its whole width."""
    c, s = cos(piece.pose.heading), sin(piece.pose.heading)
    half, start = piece.size.width / 2 - SLIVER, piece.size.depth / 2 + SLIVER
    strip = shapely.Polygon(
        [
            (piece.pose.x + c * y + s * x, piece.pose.y + s * y - c * x)
            for x, y in ((-half, start), (half, start), (half, FARTHEST), (-half, FARTHEST))
        ]
    )
    taken = shapely.union_all([strip.difference(floor), *(strip.intersection(o) for o in others)])
    ahead = [
        (x - piece.pose.x) * c + (y - piece.pose.y) * s
        for x, y in shapely.get_coordinates(taken).tolist()
    ]
    free = min(ahead, default=FARTHEST) - piece.size.depth / 2
    return free if free > SLIVER + 1e-3 else 0.0


def _shares(rooms: Iterable[FurnishedSpace], found: Sequence[GroupOccurrence]) -> Iterable[Share]:
    groups: dict[tuple[str, str], set[str]] = defaultdict(set)
    for one in found:
        groups[one.home, one.room].add(one.case.function)
    for room in rooms:
        area = float(shapely.Polygon(room.space.outline, list(room.space.holes)).area)
        taken = measure_coverage(room.pieces)
        if taken and room.space.functions:
            here = tuple(sorted(groups[room.home, room.space.id]))
            yield Share(room.space.functions[0], area, min(taken / area, 1.0), here)


def stands_on_floor(piece: Piece, catalog: Catalog) -> bool:
    """Whether a piece takes floor one would walk on: a curtain does not, nor does a rug."""
    kind = catalog.kinds.get(piece.category)
    floor = kind is not None and not kind.flat and kind.support == "floor"
    return floor and piece.pose.z < 0.05
