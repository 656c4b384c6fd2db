"""Mats and rugs on floor that is left free: before the bath or a sofa, in the hall, at a bed.

A mat bars no way, so it is laid last: the largest that lies on free floor, clear of doors and
furniture. It belongs to something: it reaches under the sofa or the bed (:mod:`.sofa_rugs`,
:mod:`.bed_rugs`), or has the middle of the cupboards of a hall. One walks over it before a door
that does not open into the room. Rooms with a rug of their own have enough.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product
from math import cos, inf, pi, remainder, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.door_approach import door_zone, gates, opens_here
from scenewright.catalog.classes import BEDS, SOFAS
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains.home.furnishing.bed_rugs import list_bed_rugs
from scenewright.domains.home.furnishing.cupboard_axes import find_cupboard_axis, front_boxes
from scenewright.domains.home.furnishing.obstacles import (
    StandingObstacles,
    find_faults,
    flat_kinds,
    join_standing,
    standing_of,
)
from scenewright.domains.home.furnishing.sofa_rugs import LOW_TABLE, list_sofa_rugs, stands_well
from scenewright.domains.home.problem import Ground

Floats = NDArray[np.float64]

THICK = 0.012  # of a mat, metres
BATH_TO_MAT = 0.04  # between a bath and the mat before it, metres
STEP = 0.1  # between places looked at, metres
HALL = (
    (2.4, 0.8),
    (2.0, 0.8),
    (2.4, 0.6),
    (1.6, 0.8),
    (1.8, 0.6),
    (1.4, 0.7),
    (1.2, 0.7),
    (0.9, 0.6),
)
ROOM = ((2.3, 1.6), (2.0, 1.4), (1.7, 1.2), (1.4, 1.0), (1.2, 0.8))
BATH = ((1.2, 0.7), (1.0, 0.6), (0.9, 0.6), (0.8, 0.5), (0.6, 0.5), (0.5, 0.4))
"""Widths and depths, metres, the largest first."""
USUAL = 0.9  # width of a mat that may be longer than what it lies before, metres
BATHS = ("bathtub", "shower", "basin", "pedestal_basin")
"""What one steps from onto a mat, the first there is."""
ROUND_RUG = 0.05  # free round a rug at a bed, metres
DOUBLE = "double_bed"
RUG_FROM = 2.8  # least rug in the middle of a room with a bed for one, m²
ON_AXIS = 1.2  # a runner that is shorter need not lie before the middle of a cupboard, metres


class Margin(NamedTuple):
    """Sizes of the rug of a room, and the floor left free round it, metres."""

    sizes: tuple[tuple[float, float], ...]
    margin: float


RUGS: dict[str, Margin] = {
    "hall": Margin(HALL, 0.12),
    "bedroom": Margin(ROOM, 0.1),
    "double_bedroom": Margin(ROOM, 0.1),
    "single_bedroom": Margin(ROOM, 0.1),
    "child_bedroom": Margin(ROOM, 0.1),
    "study": Margin(ROOM, 0.1),
}
"""Rooms by function that have a rug in the middle of their free floor."""
BUSY = frozenset(("living", "dining", "kitchen", "toilet"))
"""Rooms in which a rug that goes with no furniture lies in the way, halls besides or not."""


def lay_mats(
    space: Space, ground: Ground, pieces: Sequence[Piece], catalog: Catalog
) -> list[Piece]:
    """The mat of a room in which ``pieces`` stand; none where it has a rug or no floor is free.

    >>> from scenewright.building.plan import spaces
    >>> from scenewright.catalog.assets import shipped
    >>> from scenewright.domains.home.grounds.ground import ground_of
    >>> from scenewright.formats import read
    >>> (hall,) = (s for s in spaces(read("sample:home-flat")) if "hall" in s.functions)
    >>> [mat.category for mat in lay_mats(hall, ground_of(hall, (), 6.0), (), shipped())]
    ['rug']
    """
    here = [p for p in pieces if p.space == space.id]
    if any(p.category == "rug" for p in here):
        return []
    solid = [p for p in pieces if p.category not in flat_kinds(catalog)]
    for box in _choose_boxes(space, ground, here, solid):
        x, y, heading, width, depth = box.tolist()
        size = Size(width, depth, THICK)
        asset = catalog.choose("rug", size)
        name, pose = f"{space.id}/mat", Pose(x, y, 0.0, heading)
        drawn = asset.id if asset else ""
        return [Piece(name, "rug", drawn, space.id, pose, size, space.id, "light")]
    return []


def _choose_boxes(
    space: Space, ground: Ground, here: Sequence[Piece], solid: Sequence[Piece]
) -> Iterator[Floats]:
    """Boxes (5,) of mats that lie on free floor, the best first."""
    standing, fronts = standing_of(tuple(solid), frozenset()), front_boxes(here)
    if "bathroom" in space.functions:
        for bath in (p for name in BATHS for p in here if p.category == name):
            sizes = tuple(s for s in BATH if s[0] <= max(bath.size.width, USUAL))
            for side in _open_sides(bath):
                yield from _before(side, sizes, ground, standing)
    walked = ground._replace(keep_free=_without_thresholds(space, ground.keep_free))
    if "living" in space.functions:
        tables = [p for p in here if p.category == LOW_TABLE]
        for sofa in (p for p in here if p.category in SOFAS):
            boxes, rest = list_sofa_rugs(sofa), _without(solid, sofa, *tables)
            others = join_standing(standing_of(rest, frozenset()), fronts)
            free = boxes[_lie_free(boxes, walked, others, 0.0)]
            yield from (box for box in free if all(stands_well(t, box) for t in tables))
    if BUSY.isdisjoint(space.functions):
        along = here if "hall" in space.functions else ()
        for rug in (RUGS[f] for f in space.functions if f in RUGS):
            fitting = _fit_beside(rug, here)
            yield from _amid(ground, join_standing(standing, fronts), fitting, along)
    beds = [p for p in here if p.category in BEDS]
    for bed in sorted(beds, key=lambda p: -p.size.width):
        boxes, others = list_bed_rugs(bed), standing_of(_without(solid, bed), frozenset())
        yield from boxes[_lie_free(boxes, walked, join_standing(others, fronts), ROUND_RUG)]


def _without_thresholds(space: Space, keep_free: Floats) -> Floats:
    """Boxes (k, 5) that are kept free without those before openings whose leaves do not open into
    the room: one walks over a rug there."""
    doors = (gate for gate in gates(space) if gate.opening.kind != "window")
    zones = [door_zone(space, gate) for gate in doors if not opens_here(gate)]
    walked = np.array([box for zone in zones for box in zone]).reshape(-1, 5)
    return keep_free[~(keep_free[:, None] == walked).all(axis=2).any(axis=1)]


def _fit_beside(rug: Margin, here: Sequence[Piece]) -> Margin:
    """The rugs that may lie in the middle of a room: beside a bed for two none, as they belong to
    it, beside one for one a large one, to play on."""
    beds = {p.category for p in here if p.category in BEDS}
    least = inf if DOUBLE in beds else RUG_FROM if beds else 0.0
    return rug._replace(sizes=tuple(s for s in rug.sizes if s[0] * s[1] >= least))


def _without(solid: Sequence[Piece], *pieces: Piece) -> tuple[Piece, ...]:
    return tuple(p for p in solid if not any(p is one for one in pieces))


def _open_sides(bath: Piece) -> Iterator[Piece]:
    """A bath as it stands, and turned round: the front of a tub of a user's own may be at a wall,
    and one gets in from the other long side."""
    yield bath
    if bath.category == "bathtub":
        yield replace(
            bath, pose=bath.pose._replace(heading=remainder(bath.pose.heading + pi, 2 * pi))
        )


def _before(
    piece: Piece, sizes: Sequence[tuple[float, float]], ground: Ground, standing: StandingObstacles
) -> Iterator[Floats]:
    """Mats before a piece, the first of the ``sizes`` first, at its middle or aside."""
    (x, y, _, heading), c, s = piece.pose, cos(piece.pose.heading), sin(piece.pose.heading)
    for width, depth in sizes:
        ahead = piece.size.depth / 2 + BATH_TO_MAT + depth / 2
        room = abs(piece.size.width - width) / 2
        aside = sorted(np.arange(-room, room + 1e-9, STEP), key=abs)
        boxes = np.array(
            [(x + c * ahead - s * t, y + s * ahead + c * t, heading, width, depth) for t in aside]
        )
        yield from boxes[_lie_free(boxes, ground, standing, 0.0)]


def _amid(
    ground: Ground, standing: StandingObstacles, rug: Margin, along: Sequence[Piece] = ()
) -> Iterator[Floats]:
    """The largest rug, along the longest wall or across, before the middle of the cupboards that
    it lies ``along``, then in the middle of where it can lie."""
    found = list[Floats]()
    for free in _list_free(ground, standing, rug):
        off = np.hypot(*(free[:, :2] - free[:, :2].mean(0)).T)
        box = free[np.argmin(off)]
        found.append(box)
        moved = find_cupboard_axis(box, along)
        if moved is None or np.allclose(moved, box, atol=STEP / 2):
            break
        if _lie_free(moved[None], ground, standing, rug.margin)[0] and box[3] >= ON_AXIS:
            yield moved
    yield from found[:1]


def _list_free(ground: Ground, standing: StandingObstacles, rug: Margin) -> Iterator[Floats]:
    """Of each size, along the longest wall and across, the boxes (n, 5) on free floor, if any."""
    x0, y0, x1, y1 = ground.bounds.tolist()
    x, y = (a.ravel() for a in np.meshgrid(np.arange(x0, x1, STEP), np.arange(y0, y1, STEP)))
    walls = ground.walls
    longest = walls[np.argmax(np.hypot(walls[:, 2] - walls[:, 0], walls[:, 3] - walls[:, 1]))]
    turn = float(np.arctan2(longest[3] - longest[1], longest[2] - longest[0])) + np.pi / 2
    for (width, depth), way in product(rug.sizes, (turn, turn + np.pi / 2)):
        boxes = np.column_stack([x, y, *(np.full(len(x), v) for v in (way, width, depth))])
        free = boxes[_lie_free(boxes, ground, standing, rug.margin)]
        if len(free):
            yield free


def _lie_free(
    boxes: Floats, ground: Ground, standing: StandingObstacles, margin: float
) -> NDArray[np.bool_]:
    """On which of the boxes (n, 5), ``margin`` metres wider on each side, nothing stands and no
    door opens."""
    wider = boxes + np.array([0.0, 0.0, 0.0, 2 * margin, 2 * margin])
    spans = np.tile((0.0, THICK), (len(boxes), 1))
    return find_faults(wider, spans, ground._replace(windows=ground.windows[:0]), standing) == 0
