"""Walking routes through a dressed room: which pieces no route of the stated width reaches."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.ceiling import BENDING, HEADROOM, low_floor, lowest
from scenewright.core.catalog import Catalog
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece
from scenewright.domains.home.problem import Ground, KnownGround
from scenewright.geometry.boxes import frames_of, read_frame
from scenewright.geometry.compiled import compiled
from scenewright.geometry.flood import Bits, flood
from scenewright.geometry.paths import LOOK, RouteGrid, clear_boxes, make_grid, sweep_box

Floats = NDArray[np.float64]

CELL = 0.04
REACH = 0.2  # how far a hand gets beyond the route's edge, metres
HEAD_HEIGHT = 2.0
SIDES = ("front", "left", "back", "right")


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
    enough to walk. Seats that push under a table are moved aside. ``door 2`` names a door that
    no such route joins to the first.
    """
    if len(ground.doors) == 0:
        return frozenset()
    walked = list_walked(ground, pieces, catalog, width)
    far, joined = walk(ground, walked, width, entered)
    return frozenset(far | {f"door {k + 1}" for k in np.flatnonzero(~joined)})


class Walked(NamedTuple):
    """What a walk through a room looks at: boxes that stand in the way ``(k, 5)`` beside what is
    built in, and boxes to be reached ``(z, 5)``, of which one of the same ``owner`` is enough."""

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
    return Walked(_rows(solid), _rows(zones), tuple(owner))


def walk(
    ground: Ground, walked: Walked, width: float, entered: tuple[int, ...] = ()
) -> tuple[set[str], NDArray[np.bool_]]:
    """The owners none of whose zones is reached, and which doors are joined to the first."""
    grid = _empty_grid(KnownGround(ground), width)
    grid = grid._replace(free=grid.free.copy())
    clear_boxes(grid.free, grid, frames_of(walked.solid))
    reached, joined = _reach(grid, walked.zones, entered)
    near = {name for name, seen in zip(walked.owner, reached, strict=True) if seen}
    return set(walked.owner) - near, joined


@lru_cache(maxsize=256)
def _empty_grid(known: KnownGround, width: float) -> RouteGrid:
    """The grid of a room in which nothing stands but what is built in."""
    ground = known.ground
    low = low_floor(ground.slopes, width, ground.bounds)
    solid = frames_of(_rows([*ground.obstacles.tolist(), *low.tolist()]))
    return make_grid(ground.edges, solid, frames_of(ground.doors), ground.bounds, CELL, width)


def _reach(
    grid: RouteGrid, zones: Floats, entered: tuple[int, ...]
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Which of the boxes ``zones`` (k, 5) a route reaches on a grid from any door, or any of those
    ``entered`` by, and which of the doors are joined to the first."""
    first = grid.doors[0] & grid.free
    flood(first, grid.free)
    joined = (grid.doors & first).any(axis=(1, 2))
    come_in = np.zeros(len(grid.doors), bool)
    come_in[list(entered)] = True
    reached = _flood(grid, first, joined, come_in)
    if not reached.any():
        reached = _flood(grid, first, joined, np.ones(len(grid.doors), bool))
    found = np.zeros(len(zones), bool)
    mark_touched(reached, grid, frames_of(zones), found)
    return found, joined


def _flood(
    grid: RouteGrid, first: Bits, joined: NDArray[np.bool_], come_in: NDArray[np.bool_]
) -> Bits:
    """The cells reached from some of the doors; ``first`` are those from the first, which some are
    ``joined`` to."""
    reached = first.copy() if (joined & come_in).any() else np.zeros_like(first)
    for k in np.flatnonzero(~joined & come_in):
        more = grid.doors[k] & grid.free
        flood(more, grid.free)
        reached |= more
    return reached


@compiled
def mark_touched(reached: Bits, grid: RouteGrid, zones: Floats, found: NDArray[np.bool_]) -> None:
    """Write into ``found`` whether a reached cell lies in each of the zones (frames).

    ``zones`` (k, 8), ``found`` (k,).
    """
    for k in range(zones.shape[0]):
        found[k] = sweep_box(reached, grid, read_frame(zones, k), 0.0, LOOK)


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
    heading = pose.heading + side * np.pi / 2
    along, out = (size.width, size.depth) if side % 2 == 0 else (size.depth, size.width)
    shift = (out + depth) / 2
    return [
        pose.x + np.cos(heading) * shift,
        pose.y + np.sin(heading) * shift,
        heading,
        along,
        depth,
    ]


def _rows(rows: list[list[float]]) -> Floats:
    return np.array(rows, np.float64).reshape(-1, 5)
