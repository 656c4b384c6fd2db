"""Where in a room a bed could stand: every place parallel to a wall, tried exhaustively.

Nothing of the search is used: candidates are kept by exact polygons and judged by the referee on
the whole home, so that a room without a place has none for any method.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import islice
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from benchmarks.composition_faults import Room, bed_adrift, before_window, one_sided_bed, shape_of
from scenewright.building.door_approach import door_zone, edges_of, gates
from scenewright.catalog.assets import shipped
from scenewright.core.layout import corners
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.core.space import Space
from scenewright.domains import check

Floats = NDArray[np.float64]
STEP = 0.05
"""Metres between places of a bed, along and across the walls."""
ASIDE = 0.01
"""Metres between a back and the wall behind it."""
JUDGED = 150
"""So many places of a room are judged by the referee, spread evenly over all that are free."""
BESIDE = 12
"""With so many of the beds that are valid a wardrobe is tried."""
LEAST = {"single_bed": Size(0.8, 1.9, 0.5), "double_bed": Size(1.4, 1.9, 0.5)}
"""The beds tried, metres."""
WARDROBE = Size(1.0, 0.5, 2.0)


class Case(NamedTuple):
    """A bed with a fault: the home it stands in, the spaces of that, its own space and itself."""

    solution: Solution
    spaces: tuple[Space, ...]
    space: Space
    bed: Piece


def is_faulty(case: Case, room: Room) -> bool:
    """Whether a bed of a room is adrift or one-sided, or before a window."""
    alone = room._replace(pieces=tuple(p for p in room.pieces if "bed" in p.category))
    sides = bed_adrift if case.bed.category == "single_bed" else one_sided_bed
    return sides((room,)).faulty > 0 or before_window((alone,)).faulty > 0


def list_places(case: Case, size: Size, taken: tuple[Piece, ...]) -> list[Piece]:
    """Beds of some size, parallel to a wall, on the floor of the room, clear of doors and of what
    is ``taken``, in steps of :data:`STEP`."""
    ring = shapely.Polygon(case.space.outline, list(case.space.holes))
    boxes = np.concatenate([_grid(ring, size, turn) for turn in _turns(case.space)])
    doors = (gate for gate in gates(case.space) if gate.opening.kind != "window")
    kept_free = [zone for gate in doors for zone in door_zone(case.space, gate)]
    zones = shapely.polygons(corners(np.array(kept_free).reshape(-1, 5)))
    clear = shapely.union_all([*zones, *map(shape_of, taken)])
    shapes = shapely.polygons(corners(boxes))
    floor = ring.buffer(1e-3, join_style="mitre")
    shapely.prepare(floor)
    shapely.prepare(clear)
    kept = np.flatnonzero(shapely.covers(floor, shapes))
    kept = kept[shapely.area(shapely.intersection(shapes[kept], clear)) < 1e-4]
    return [_stand(case, size, boxes[k]) for k in kept.tolist()]


def _turns(space: Space) -> Floats:
    """Headings parallel to a wall of a metre and more, each once."""
    edges = edges_of(space)
    along = edges[:, 2:] - edges[:, :2]
    long = along[np.hypot(along[:, 0], along[:, 1]) > 1.0]
    turns = np.mod(np.arctan2(long[:, 1], long[:, 0]), np.pi / 2)
    single = np.unique(turns.round(2) % round(np.pi / 2, 2))
    return np.concatenate([single + k * np.pi / 2 for k in range(4)])


def _grid(floor: shapely.Polygon, size: Size, heading: float) -> Floats:
    """Boxes (k, 5) of a heading, from the walls of the floor on in steps of :data:`STEP`."""
    turned = shapely.affinity.rotate(floor, -heading, origin=(0, 0), use_radians=True)
    x0, y0, x1, y1 = turned.bounds
    xs = _steps(x0 + ASIDE + size.depth / 2, x1 - ASIDE - size.depth / 2)
    ys = _steps(y0 + ASIDE + size.width / 2, y1 - ASIDE - size.width / 2)
    u, v = (a.ravel() for a in np.meshgrid(xs, ys))
    c, s = np.cos(heading), np.sin(heading)
    rest = np.broadcast_to([heading, size.width, size.depth], (u.size, 3))
    return np.column_stack([c * u - s * v, s * u + c * v, rest])


def _steps(low: float, high: float) -> Floats:
    return np.append(np.arange(low, high, STEP), high) if low <= high else np.zeros(0)


def _stand(case: Case, size: Size, box: Floats) -> Piece:
    x, y, heading = (float(v) for v in box[:3])
    return replace(case.bed, pose=Pose(x, y, 0.0, heading), size=size, footprint=())


def is_valid(case: Case, held: tuple[Piece, ...]) -> bool:
    """Whether the home with nothing but ``held`` in the room pleases the referee."""
    others = tuple(p for p in case.solution.pieces if p.space != case.space.id)
    alone = tuple(replace(p, on=None, group="") for p in held)
    changed = replace(case.solution, pieces=(*others, *alone))
    return not check(changed, spaces=case.spaces).findings


def list_valid(
    case: Case, taken: tuple[Piece, ...], good: Callable[[Room], bool]
) -> Iterator[Piece]:
    """Places of the bed beside what is ``taken`` of which the room says ``good`` and in which the
    referee finds nothing."""
    floor = shapely.Polygon(case.space.outline, list(case.space.holes))
    sizes = dict.fromkeys((LEAST[case.bed.category], case.bed.size))
    for size in sizes:
        free = [
            bed
            for bed in list_places(case, size, taken)
            if good(Room(case.space, floor, (*taken, bed)))
        ]
        stride = max(1, len(free) // JUDGED)
        yield from (bed for bed in free[::stride] if is_valid(case, (*taken, bed)))


def find_beside_wardrobe(case: Case, beds: Iterator[Piece]) -> bool:
    """Whether beside one of some beds a wardrobe of a metre finds a wall."""
    model = shipped().choose("wardrobe", WARDROBE)
    for bed in islice(beds, BESIDE):
        stand = replace(bed, id="w", category="wardrobe", asset=model.id if model else "")
        places = list_places(case._replace(bed=stand), WARDROBE, (bed,))
        backed = [p for p in places if has_back(p, case.space)]
        stride = max(1, len(backed) // BESIDE)
        if any(is_valid(case, (bed, p)) for p in backed[::stride]):
            return True
    return False


def has_back(piece: Piece, space: Space) -> bool:
    """Whether both ends of a back stand at a wall."""
    wall = shapely.Polygon(space.outline, list(space.holes)).boundary
    box = corners(np.array([[*piece.pose[:2], piece.pose.heading, *piece.size[:2]]]))[0]
    return all(wall.distance(shapely.Point(p)) < 2.5 * ASIDE for p in box[[0, 3]])
