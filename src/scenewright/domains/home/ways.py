"""Walking routes through a dressed room: which pieces no route of the stated width reaches."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.building.ceiling import BENDING, HEADROOM, low_floor, lowest
from scenewright.core.catalog import Catalog
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece
from scenewright.domains.home.problem import Ground
from scenewright.geometry.boxes import frames_of, read_frame
from scenewright.geometry.compiled import compiled
from scenewright.geometry.flood import Bits, flood
from scenewright.geometry.paths import LOOK, RouteGrid, make_grid, sweep_box

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
    solid = [box for p in pieces if _stands(p, catalog) for box in boxes_of(p)]
    low = low_floor(ground.slopes, width, ground.bounds)
    used = [p for p in pieces if catalog.kinds[p.category].access]
    zones, owner = [], []
    for i, piece in enumerate(used):
        for side in catalog.kinds[piece.category].access:
            zones.append(used_from(piece, SIDES.index(side), width / 2 + REACH, ground.slopes))
            owner.append(i)
    reached, joined = reach(
        ground.edges,
        _rows([*ground.obstacles.tolist(), *solid, *low.tolist()]),
        ground.doors,
        _rows(zones),
        ground.bounds,
        CELL,
        width,
        entered,
    )
    found = np.zeros(len(used), bool)
    np.logical_or.at(found, np.array(owner, np.int64), reached)
    far = {p.id for p, seen in zip(used, found, strict=True) if not seen}
    return frozenset(far | {f"door {k + 1}" for k in np.flatnonzero(~joined)})


def reach(
    edges: Floats,
    solid: Floats,
    doors: Floats,
    zones: Floats,
    bounds: Floats,
    cell: float,
    width: float,
    entered: tuple[int, ...] = (),
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Which of the boxes ``zones`` a route of ``width`` reaches from any door, or any of those
    ``entered`` by, and which of the ``doors`` are joined to the first; ``solid`` stands in the
    way. All boxes are ``(k, 5)``."""
    grid = make_grid(edges, frames_of(solid), frames_of(doors), bounds, cell, width)
    first = grid.doors[0] & grid.free
    flood(first, grid.free)
    joined = (grid.doors & first).any(axis=(1, 2))
    come_in = np.isin(np.arange(len(doors)), entered)
    reached = _flood(grid, first, joined, come_in)
    if not reached.any():
        reached = _flood(grid, first, joined, np.ones(len(doors), bool))
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
