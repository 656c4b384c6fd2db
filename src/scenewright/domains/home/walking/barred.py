"""What no walking route leads to in a whole home, and what would have to give way for one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, lru_cache
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.ceiling import planes
from scenewright.core.catalog import Catalog
from scenewright.core.kind import SIDES
from scenewright.core.layout import corners
from scenewright.core.same import Same
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.walking.bed_aisles import DOUBLE, PASSED, list_aisles, list_mouths
from scenewright.domains.home.walking.home_floor import (
    SLACK,
    FloorWalk,
    HomeFloor,
    erode,
    join_to,
    list_bearing,
    list_obstacles,
    reach_without,
    walk,
)
from scenewright.domains.home.walking.ways import REACH, used_from

Shape = Any  # a shapely geometry
Shapes = NDArray[np.object_]
Reach = Callable[[tuple[int, ...]], Shapes]

SIDEWAYS = 0.2  # the radius of a person turned sideways, metres
TRIED = 12  # pieces taken away on trial, those nearest to the gap


class Barred(NamedTuple):
    """What no route leads to, a room or a piece of it (empty: the room), and the pieces that
    would open the way, any one of them or else only all together (none: nothing would)."""

    space: str
    piece: str
    openers: tuple[str, ...]


class BarredRegion(NamedTuple):
    """What is to be reached, and the region the middle of the route has to come into."""

    space: str
    piece: str
    region: Shape


def find_barred(
    pieces: Sequence[Piece], spaces: Sequence[Space], floors: Sequence[HomeFloor], catalog: Catalog
) -> list[Barred]:
    """All that no route reaches on the ``floors`` of a home, as wide as these are made for.

    A room is reached if the middle of the route comes into it; one that no route could enter empty
    is passed over. A piece is reached if that middle comes within half a width and an arm's length
    straight before a side it is used from, a bed for two also from its foot along narrow aisles
    (:mod:`.bed_aisles`). Of a tight room the doorway is enough, and there a person goes on
    sideways. Pieces of rooms that are barred are not listed one by one.
    """
    found: list[Barred] = []
    level = {space.id: space.level for space in spaces}
    for floor in floors:
        storey = level[next(iter(floor.rooms))]
        near = [p for p in pieces if level.get(p.space) == storey]
        mine = tuple(Same(space) for space in spaces if space.id in floor.rooms)
        here = tuple(map(Same, list_bearing(near, floor, catalog)))
        found += _find_on(Same(floor), mine, here, Same(catalog))
    return found


@lru_cache(maxsize=64)
def _find_on(
    floor: Same[HomeFloor],
    rooms_of: tuple[Same[Space], ...],
    here: tuple[Same[Piece], ...],
    stock: Same[Catalog],
) -> tuple[Barred, ...]:
    """What is barred on one floor; a floor where all stands as before is not walked again."""
    spaces, pieces, catalog = [s.value for s in rooms_of], [p.value for p in here], stock.value
    walked = walk(floor.value, list_obstacles(pieces, catalog))
    rooms = [target for space in spaces if (target := _room_target(walked, space)) is not None]
    missed = [target for target in rooms if not walked.reached.intersects(target.region)]
    entered = {target.space for target in rooms} - {target.space for target in missed}
    for space in spaces:
        if space.id in entered:
            inside = [p for p in pieces if p.space == space.id]
            missed += _missed_pieces(walked, space, inside, catalog)
    return tuple(
        Barred(target.space, target.piece, openers)
        for target, openers in zip(missed, _find_openers(walked, missed), strict=True)
    )


def _room_target(walked: FloorWalk, space: Space) -> BarredRegion | None:
    """A room as what is to be reached; none if no route could enter it even empty."""
    room, within = walked.floor.rooms[space.id], walked.floor.within[space.id]
    for region in (within if _is_tight(walked, space.id) else room, within):
        if walked.empty.intersects(region):
            return BarredRegion(space.id, "", region)
    return None


def _is_tight(walked: FloorWalk, room: str) -> bool:
    """Nowhere as wide as two routes, or closed to the route by its own doorway while empty."""
    floor = walked.floor
    return room in floor.narrow or not walked.empty.intersects(floor.inner[room])


def _missed_pieces(
    walked: FloorWalk, space: Space, pieces: Sequence[Piece], catalog: Catalog
) -> list[BarredRegion]:
    """The pieces of a room whose sides of use are all off the route."""
    here = tuple(map(Same, pieces))
    named, regions = _regions_within(Same(walked.floor), Same(space), here, Same(catalog))
    far = ~shapely.intersects(walked.reached, regions)
    missed = [BarredRegion(space.id, named[k], regions[k]) for k in np.flatnonzero(far)]
    if missed and _is_tight(walked, space.id):
        near = _squeeze(walked, walked.floor.within[space.id])
        missed = [t for t in missed if not near.intersects(t.region)]
    double = {p.id: p for p in pieces if p.category == DOUBLE and not space.slopes}
    return [
        target
        for target in missed
        if target.piece not in double or not _is_entered(walked, space, double[target.piece])
    ]


def _is_entered(walked: FloorWalk, space: Space, bed: Piece) -> bool:
    """Whether a bed for two is got into from its foot, along free aisles on both sides."""
    taken = shapely.union_all([o.footprint for o in walked.obstacles if o.piece != bed.id])
    free = walked.floor.within[space.id].difference(taken)
    aisles = shapely.polygons(corners(np.array(list_aisles(bed))))
    mouths = shapely.polygons(corners(np.array(list_mouths(bed, walked.radius + REACH))))
    kept = shapely.area(shapely.intersection(aisles, free)) / shapely.area(aisles)
    return bool((kept >= 1.0 - PASSED).all() and walked.reached.intersects(mouths).any())


@lru_cache(maxsize=256)
def _regions_within(
    on: Same[HomeFloor], of: Same[Space], here: tuple[Same[Piece], ...], stock: Same[Catalog]
) -> tuple[list[str], Shapes]:
    """What :func:`_use_regions` gives, as far as it is in the room and its doorways; of a room in
    which all stands as before found once."""
    floor, space = on.value, of.value
    within, pieces = floor.within[space.id], [p.value for p in here]
    named, regions = _use_regions(pieces, space, stock.value, floor.radius + REACH)
    beyond = ~shapely.covers(within, regions)
    regions[beyond] = shapely.intersection(regions[beyond], within)
    return named, regions


def _use_regions(
    pieces: Sequence[Piece], space: Space, catalog: Catalog, depth: float
) -> tuple[list[str], Shapes]:
    """The pieces that are used from some side, by id, and the floor before these sides."""
    slopes, named = planes(space), list[str]()
    boxes, owner = list[list[float]](), list[int]()
    for piece in pieces:
        kind = catalog.kinds.get(piece.category)
        if kind is not None and kind.access:
            boxes += [used_from(piece, SIDES.index(side), depth, slopes) for side in kind.access]
            owner += [len(named)] * len(kind.access)
            named.append(piece.id)
    if not named:
        return [], np.empty(0, object)
    return named, shapely.multipolygons(shapely.polygons(corners(np.array(boxes))), indices=owner)


def _squeeze(walked: FloorWalk, within: Shape) -> Shape:
    """Where a person gets sideways from the route, in a room and its doorways."""
    floor = walked.floor
    near = floor.whole.intersection(within.buffer(2 * walked.radius))
    solid = [obstacle.footprint for obstacle in walked.obstacles]
    return join_to(walked.reached, erode(near, solid, floor.low, SIDEWAYS))


def _find_openers(walked: FloorWalk, missed: Sequence[BarredRegion]) -> list[tuple[str, ...]]:
    """For each target the pieces that each open the way to it alone, else a least set that does
    so together."""
    if not missed or not walked.obstacles:
        return [()] * len(missed)
    parts = shapely.get_parts(walked.free)
    shapely.prepare(parts)
    tried = _nearest_obstacles(walked, parts, missed)
    reach: Reach = cache(lambda away: reach_without(walked, parts, away))
    without = {k: reach((k,)) for k in tried if _is_at_hand(walked, k)}
    found: list[tuple[str, ...]] = []
    for target in missed:
        mine = [k for k in tried if walked.obstacles[k].piece != target.piece]
        one = [k for k in mine if k in without and _meets(without[k], target)]
        chosen = one or _find_least_set(reach, mine, target)
        found.append(tuple(walked.obstacles[k].piece for k in chosen))
    return found


def _meets(shapes: Shapes, target: BarredRegion) -> bool:
    """Whether some of what is reached meets a target."""
    return bool(shapely.intersects(shapes, target.region).any())


def _is_at_hand(walked: FloorWalk, obstacle: int) -> bool:
    """Whether what an obstacle takes is near enough to what is reached to add to it."""
    shape, near = walked.obstacles[obstacle].footprint, walked.radius + 2 * SLACK
    return any(not s.is_empty and s.distance(shape) <= near for s in (walked.reached, walked.start))


def _find_least_set(reach: Reach, tried: Sequence[int], target: BarredRegion) -> list[int]:
    """Obstacles that open the way to a target if all of them are gone, none of them to spare;
    none if not even all together do. ``reach`` tells what is reached without some."""
    if not _meets(reach(tuple(tried)), target):
        return []
    needed = list(tried)
    for k in reversed(tried):
        fewer = [j for j in needed if j != k]
        if fewer and _meets(reach(tuple(fewer)), target):
            needed = fewer
    return needed


def _nearest_obstacles(
    walked: FloorWalk, parts: Shapes, missed: Sequence[BarredRegion]
) -> list[int]:
    """The obstacles nearest to both what is reached and what is cut off, the larger first;
    ``parts`` are those of the free floor."""
    beyond = [*parts[~shapely.intersects(parts, walked.start)], *(t.region for t in missed)]
    shapes = np.array([obstacle.footprint for obstacle in walked.obstacles], object)
    sides = [shapely.union_all(beyond), *([] if walked.reached.is_empty else [walked.reached])]
    apart = sum(np.maximum(shapely.distance(shapes, side) - walked.radius, 0.0) for side in sides)
    order = np.lexsort((-shapely.area(shapes), np.round(apart, 2)))
    return [int(k) for k in order[:TRIED]]
