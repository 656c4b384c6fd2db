"""What furnished rooms tell of distances, free floor and how much of a room is taken."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from math import cos, hypot, sin
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.catalog import Catalog
from scenewright.domains.home.learning import Found, Furnished
from scenewright.domains.home.learning_space import footprint
from scenewright.scene import Piece

HAIR = 0.02
FARTHEST = 3.0
"""Free floor is looked for so far before a piece, in metres."""


class Distance(NamedTuple):
    """How far the middles of two groups of one room are apart: median and quartiles, metres."""

    first: str
    second: str
    median: float
    low: float
    high: float
    seen: int


class Clearance(NamedTuple):
    """Free floor before pieces of a category: least and median, metres (at most three)."""

    category: str
    least: float
    median: float
    seen: int


class Share(NamedTuple):
    """What share of a room of a function furniture covers: the room's area and the share."""

    function: str
    area: float
    share: float


class Targets(NamedTuple):
    """Statistics of furnished rooms."""

    distances: tuple[Distance, ...]
    clearances: tuple[Clearance, ...]
    shares: tuple[Share, ...]


def targets_of(rooms: Sequence[Furnished], found: Sequence[Found], catalog: Catalog) -> Targets:
    """Statistics of rooms and of the groups found in them."""
    return Targets(_distances(found), _clearances(rooms, catalog), tuple(_shares(rooms)))


def _distances(found: Iterable[Found]) -> tuple[Distance, ...]:
    rooms: dict[tuple[str, str], list[Found]] = defaultdict(list)
    for one in found:
        rooms[one.home, one.room].append(one)
    apart: dict[tuple[str, str], list[float]] = defaultdict(list)
    for groups in rooms.values():
        for a in groups:
            for b in groups:
                if a is not b:
                    away = hypot(a.box[0] - b.box[0], a.box[1] - b.box[1])
                    apart[a.case.function, b.case.function].append(away)
    return tuple(_distance(pair, away) for pair, away in sorted(apart.items()))


def _distance(pair: tuple[str, str], away: list[float]) -> Distance:
    low, middle, high = (float(np.quantile(away, q)) for q in (0.25, 0.5, 0.75))
    return Distance(*pair, middle, low, high, len(away))


def _clearances(rooms: Iterable[Furnished], catalog: Catalog) -> tuple[Clearance, ...]:
    depths: dict[str, list[float]] = defaultdict(list)
    for room in rooms:
        floor = shapely.Polygon(room.space.outline, list(room.space.holes))
        standing = [p for p in room.pieces if _stands(p, catalog)]
        for piece in standing:
            if "front" in catalog.kinds[piece.category].access:
                others = [footprint(p) for p in standing if p is not piece]
                depths[piece.category].append(free_before(piece, others, floor))
    return tuple(Clearance(kind, min(found), float(np.median(found)), len(found))
                 for kind, found in sorted(depths.items()))  # fmt: skip


def free_before(piece: Piece, others: Sequence[shapely.Polygon], floor: shapely.Polygon) -> float:
    """Depth of the free floor before a piece, over its whole width."""
    c, s = cos(piece.pose.heading), sin(piece.pose.heading)
    half, start = piece.size.width / 2 - HAIR, piece.size.depth / 2 + HAIR
    strip = shapely.Polygon([
        (piece.pose.x + c * y + s * x, piece.pose.y + s * y - c * x)
        for x, y in ((-half, start), (half, start), (half, FARTHEST), (-half, FARTHEST))
    ])  # fmt: skip
    taken = shapely.union_all([strip.difference(floor), *(strip.intersection(o) for o in others)])
    ahead = [(x - piece.pose.x) * c + (y - piece.pose.y) * s
             for x, y in shapely.get_coordinates(taken).tolist()]  # fmt: skip
    free = min(ahead, default=FARTHEST) - piece.size.depth / 2
    return free if free > HAIR + 1e-3 else 0.0


def _shares(rooms: Iterable[Furnished]) -> Iterable[Share]:
    for room in rooms:
        floor = shapely.Polygon(room.space.outline, list(room.space.holes))
        low = [footprint(p) for p in room.pieces if p.pose.z < 0.05 and p.size.height > 0.05]
        if low and room.space.functions:
            share = shapely.union_all(low).intersection(floor).area / floor.area
            yield Share(room.space.functions[0], float(floor.area), float(share))


def _stands(piece: Piece, catalog: Catalog) -> bool:
    kind = catalog.kinds.get(piece.category)
    return kind is not None and not kind.flat and piece.pose.z < 0.05
