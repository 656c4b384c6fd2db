"""Walking routes through a dressed room: which pieces no route of the stated width reaches."""

from __future__ import annotations

from functools import lru_cache
from math import cos, pi, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.ceiling import BENDING, HEADROOM, low_floor, lowest
from scenewright.core.catalog import Catalog
from scenewright.core.kind import SIDES
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece
from scenewright.domains.home.measures import HEAD_HEIGHT
from scenewright.domains.home.problem import Ground, KnownGround, known_ground
from scenewright.domains.home.walking.bed_aisles import DOUBLE, are_open, list_mouths
from scenewright.geometry.boxes import Frame, frames_of, make_frame
from scenewright.geometry.compiled import compiled, inlined
from scenewright.geometry.flood import NONE, Bits, flood
from scenewright.geometry.paths import CLEAR, LOOK, RouteGrid, make_grid, sweep_box

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

CELL = 0.04
REACH = 0.2  # how far a hand gets beyond the route's edge, metres


def find_unreached(
    ground: Ground,
    pieces: tuple[Piece, ...],
    catalog: Catalog,
    width: float,
    entered: tuple[int, ...] = (),
) -> frozenset[str]:
    """Ids of the pieces that no route of ``width`` metres from any door reaches; only from the
    doors that one has ``entered`` by, if stated (their numbers).

    A piece is reached if a disc as wide as the route, having come from a door, can stand with its
    centre in front of one of the sides its kind is used from, at most half a route and
    0.2 m away (0.4 m more where one bends down under a slope), and the ceiling there is high
    enough to walk. To a bed for two one also comes from its foot, sideways along narrow aisles on
    both sides (:mod:`.bed_aisles`). Seats that push under a table are moved aside. ``door 2`` names
    a door that no such route joins to the first.
    """
    if len(ground.doors) == 0:
        return frozenset()
    walked = list_walked(ground, pieces, catalog, width)
    far, joined = walk(ground, walked, width, entered)
    for number, met in enumerate(joined.tolist(), 1):
        if not met:
            far.add(f"door {number}")
    return frozenset(far)


class Walked(NamedTuple):
    """What a walk through a room looks at: boxes that stand in the way ``(k, 5)`` beside what is
    built in, and boxes to be reached ``(z, 5)``; one box of each ``owner`` is enough."""

    solid: Floats
    zones: Floats
    owner: tuple[str, ...]


def list_walked(
    ground: Ground, pieces: tuple[Piece, ...], catalog: Catalog, width: float
) -> Walked:
    """What pieces put in the way of a route of ``width`` metres and where it is to reach."""
    solid = [box for p in pieces if _stands(p, catalog) for box in boxes_of(p)]
    zones, owner = [], []
    for piece in pieces:
        for side in catalog.kinds[piece.category].access:
            zones.append(used_from(piece, SIDES.index(side), width / 2 + REACH, ground.slopes))
            owner.append(piece.id)
        if piece.category == DOUBLE and _is_open(piece, ground, solid):
            zones += map(list, list_mouths(piece, width / 2 + REACH))
            owner += [piece.id, piece.id]
    return Walked(_rows(solid), _rows(zones), tuple(owner))


def _is_open(bed: Piece, ground: Ground, solid: list[list[float]]) -> bool:
    """Whether one gets into a bed along its aisles, nowhere below a slope."""
    taken = [*solid, *ground.obstacles.tolist()]
    return not len(ground.slopes) and are_open(bed, taken, ground.edges)


def walk(
    ground: Ground, walked: Walked, width: float, entered: tuple[int, ...] = ()
) -> tuple[set[str], Flags]:
    """The owners none of whose zones is reached, and which doors are joined to the first."""
    grid = _empty_grid(known_ground(ground), width)
    come_in = np.zeros(len(grid.doors), bool)
    come_in[list(entered)] = True
    cells = np.empty((4, *grid.free.shape), np.uint64)
    joined, found = np.empty(len(grid.doors), bool), np.empty(len(walked.zones), bool)
    walk_cells(grid, walked.solid, walked.zones, come_in, cells, joined, found)
    near = {name for name, seen in zip(walked.owner, found.tolist(), strict=True) if seen}
    return set(walked.owner) - near, joined


def walk_floor(ground: Ground, solid: Floats, narrow: float, wide: float) -> float:
    """Square metres of the middles of discs ``wide`` metres across that stand free of boxes
    ``solid`` (n, 5) and to which none as ``narrow`` gets from any door."""
    known = known_ground(ground)
    grids = _empty_grid(known, narrow), _empty_grid(known, wide)
    cells = np.empty((3, *grids[0].free.shape), np.uint64)
    return count_cut_off(*grids, solid, cells) * CELL**2


@compiled
def count_cut_off(
    narrow: RouteGrid, wide: RouteGrid, solid: Floats, cells: NDArray[np.uint64]
) -> int:
    """How many cells are free in the ``wide`` grid beside boxes ``solid`` (n, 5) that nobody gets
    to in the ``narrow`` one. ``cells`` (3, h, k) is scratch."""
    free, reached, stand = cells[0], cells[1], cells[2]
    for row in range(free.shape[0]):
        for word in range(free.shape[1]):
            free[row, word], stand[row, word] = narrow.free[row, word], wide.free[row, word]
            reached[row, word] = NONE
    for k in range(solid.shape[0]):
        sweep_box(free, narrow, _frame(solid, k), narrow.radius, CLEAR)
        sweep_box(stand, wide, _frame(solid, k), wide.radius, CLEAR)
    for k in range(narrow.doors.shape[0]):
        for row in range(free.shape[0]):
            for word in range(free.shape[1]):
                reached[row, word] |= narrow.doors[k, row, word] & free[row, word]
    flood(reached, free)
    count = 0
    for row in range(free.shape[0]):
        for word in range(free.shape[1]):
            left = stand[row, word] & ~reached[row, word]
            while left != NONE:
                left &= left - np.uint64(1)
                count += 1
    return count


def find_shut_off(ground: Ground, solid: Floats, width: float) -> Flags:
    """Which of the leaves (f,) of a room, open at a right angle, shut their door off beside boxes
    ``solid`` (n, 5): no disc ``width`` metres across gets from it to another door."""
    grid = _empty_grid(known_ground(ground), width)
    cells, shut = np.empty((2, *grid.free.shape), np.uint64), np.zeros(len(ground.leaves), bool)
    if len(grid.doors) > 1:
        shut_off_doors(grid, solid, ground.leaves, cells, shut)
    return shut


@compiled
def shut_off_doors(
    grid: RouteGrid, solid: Floats, leaves: Floats, cells: NDArray[np.uint64], shut: Flags
) -> None:
    """Write which of the ``leaves`` (f, 6) shut off their door into ``shut`` (f,); ``cells`` (2, h,
    k) is scratch."""
    free, reached = cells[0], cells[1]
    for leaf in range(leaves.shape[0]):
        for row in range(free.shape[0]):
            for word in range(free.shape[1]):
                free[row, word] = grid.free[row, word]
        for k in range(solid.shape[0]):
            sweep_box(free, grid, _frame(solid, k), grid.radius, CLEAR)
        sweep_box(free, grid, _frame(leaves, leaf), grid.radius, CLEAR)
        own = int(leaves[leaf, 5])
        _flood_from(grid.doors[own], free, reached)
        shut[leaf] = True
        for k in range(grid.doors.shape[0]):
            if k != own and _meet(grid.doors[k], reached):
                shut[leaf] = False


@lru_cache(maxsize=256)
def _empty_grid(known: KnownGround, width: float) -> RouteGrid:
    """The grid of a room in which nothing stands but what is built in."""
    ground = known.ground
    low = low_floor(ground.slopes, width, ground.bounds)
    solid = frames_of(_rows([*ground.obstacles.tolist(), *low.tolist()]))
    return make_grid(ground.edges, solid, frames_of(ground.doors), ground.bounds, CELL, width)


@compiled
def walk_cells(
    grid: RouteGrid,
    solid: Floats,
    zones: Floats,
    come_in: Flags,
    cells: NDArray[np.uint64],
    joined: Flags,
    found: Flags,
) -> None:
    """Write which of the boxes ``zones`` (k, 5) a route reaches that has come in by any of the
    doors (d,) said to ``come_in``, by any door if by none of these, into ``found`` (k,), and which
    of the doors are ``joined`` (d,) to the first; ``solid`` (n, 5) stands in the way. ``cells``
    (4, h, k) is scratch."""
    free, first, reached, more = cells[0], cells[1], cells[2], cells[3]
    for row in range(free.shape[0]):
        for word in range(free.shape[1]):
            free[row, word] = grid.free[row, word]
    for k in range(solid.shape[0]):
        sweep_box(free, grid, _frame(solid, k), grid.radius, CLEAR)
    _flood_from(grid.doors[0], free, first)
    for k in range(joined.shape[0]):
        joined[k] = _meet(grid.doors[k], first)
    if not _flood_doors(grid, come_in, False, joined, free, first, reached, more):
        _flood_doors(grid, come_in, True, joined, free, first, reached, more)
    for k in range(found.shape[0]):
        found[k] = sweep_box(reached, grid, _frame(zones, k), 0.0, LOOK)


@inlined
def _frame(boxes: Floats, k: int) -> Frame:
    return make_frame(boxes[k, 0], boxes[k, 1], boxes[k, 2], boxes[k, 3], boxes[k, 4])


@inlined
def _flood_from(door: Bits, free: Bits, into: Bits) -> None:
    """Write the cells reached from those of one door."""
    for row in range(free.shape[0]):
        for word in range(free.shape[1]):
            into[row, word] = door[row, word] & free[row, word]
    flood(into, free)


@inlined
def _meet(some: Bits, others: Bits) -> bool:
    """Whether some cell is among both."""
    met = NONE
    for row in range(some.shape[0]):
        for word in range(some.shape[1]):
            met |= some[row, word] & others[row, word]
    return met != NONE


@inlined
def _flood_doors(
    grid: RouteGrid,
    come_in: Flags,
    every: bool,
    joined: Flags,
    free: Bits,
    first: Bits,
    reached: Bits,
    more: Bits,
) -> bool:
    """Write the cells ``reached`` from the doors one may ``come_in`` by, or from ``every`` one;
    whether there are any. ``first`` are those from the first, which some are ``joined`` to."""
    by_first = False
    for k in range(joined.shape[0]):
        by_first |= joined[k] and (every or come_in[k])
    for row in range(free.shape[0]):
        for word in range(free.shape[1]):
            reached[row, word] = first[row, word] if by_first else NONE
    for k in range(joined.shape[0]):
        if not joined[k] and (every or come_in[k]):
            _flood_from(grid.doors[k], free, more)
            for row in range(free.shape[0]):
                for word in range(free.shape[1]):
                    reached[row, word] |= more[row, word]
    return _meet(reached, reached)


def _stands(piece: Piece, catalog: Catalog) -> bool:
    kind = catalog.kinds[piece.category]
    low = kind.flat or bool(kind.under) or piece.on is not None
    return not low and piece.pose.z < HEAD_HEIGHT and kind.support not in ("ceiling",)


def used_from(piece: Piece, side: int, depth: float, slopes: Floats) -> list[float]:
    """The box before one side of a piece; deeper if one has to bend down under ``slopes`` (k,
    6)."""
    near = _access(piece, side, depth)
    low = len(slopes) and lowest(np.array([near]), slopes, np.inf)[0] < HEADROOM
    return _access(piece, side, depth + BENDING) if low else near


def _access(piece: Piece, side: int, depth: float) -> list[float]:
    """The box outside one side of a piece, as long as that side."""
    pose, size = piece.pose, piece.size
    heading = pose.heading + side * pi / 2
    along, out = (size.width, size.depth) if side % 2 == 0 else (size.depth, size.width)
    shift = (out + depth) / 2
    return [pose.x + cos(heading) * shift, pose.y + sin(heading) * shift, heading, along, depth]


def _rows(rows: list[list[float]]) -> Floats:
    return np.array(rows, np.float64).reshape(-1, 5)
