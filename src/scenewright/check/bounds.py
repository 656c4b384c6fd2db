"""Out of bounds, floating and sunk: does each piece stand in its room, and on something?

SceneEval (Tam et al. 2025) calls an object out of bounds when more than 1 % of points sampled on
it have no floor beneath them, and supported when what it hangs from or stands on is within
1 cm of it under (or behind) its middle. Here both are exact on the footprint: at most 1 cm may
leave the room's free area, and 2 cm may part a piece from its support (5 cm from a wall).
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.check.bodies import (
    PARTITION,
    TOLERANCE,
    WALL_GAP,
    Bodies,
    Flags,
    Floats,
    Rooms,
    Shapes,
)
from scenewright.check.ceilings import ceiling_over
from scenewright.core.report import Finding

SUPPORT_GAP = 0.02
"""Greatest gap between a piece and what holds it, in metres."""


def find_out_of_bounds(bodies: Bodies, rooms: Rooms) -> list[Finding]:
    """Pieces more than 1 cm outside their room's outline, inside a hole, or above its ceiling."""
    if not bodies.pieces:
        return []
    wider: Shapes = shapely.buffer(rooms.shapes, TOLERANCE, join_style="mitre")
    shapely.prepare(wider)
    outside = ~shapely.covers(wider[bodies.room], bodies.footprints)
    found = [_beyond(bodies, rooms, int(i)) for i in np.flatnonzero(outside)]
    ceiling = np.array([space.height for space in rooms.spaces])[bodies.room]
    through = np.flatnonzero(bodies.high > ceiling + TOLERANCE)
    return found + [_through(bodies, rooms, int(i), float(ceiling[i])) for i in through]


def _beyond(bodies: Bodies, rooms: Rooms, i: int) -> Finding:
    piece, room = bodies.pieces[i], rooms.shapes[bodies.room[i]]
    rest = shapely.difference(bodies.footprints[i], room)
    edge = shapely.points(shapely.get_coordinates(shapely.segmentize(rest, 0.02)))
    depth = float(shapely.distance(edge, room).max(initial=0.0))
    area = float(rest.area)
    text = f"{piece.id} is {depth:.2f} m ({area:.2f} m²) outside {piece.space}"
    if shapely.covers(shapely.Polygon(room.exterior), rest):
        text = f"{piece.id} stands in a column of {piece.space} ({area:.2f} m²)"
    return _finding("out_of_bounds", bodies, rooms, i, text, depth, area)


def _through(bodies: Bodies, rooms: Rooms, i: int, ceiling: float) -> Finding:
    piece, over = bodies.pieces[i], float(bodies.high[i]) - ceiling
    text = f"{piece.id} goes {over:.2f} m through the ceiling of {piece.space} ({ceiling:.2f} m)"
    return _finding("out_of_bounds", bodies, rooms, i, text, over)


def find_unsupported(bodies: Bodies, rooms: Rooms) -> list[Finding]:
    """Pieces that float (nothing holds them up) or are sunk (into the floor or what they are on).

    A floor piece stands on the floor; a piece ``on`` another with its middle over it and its
    underside at its top (or within it, if its kind may be in the other); a wall piece has the
    middle of its back edge at a wall; a ceiling piece reaches the ceiling. A piece whose category
    is unknown to the catalog may be held by any of these.
    """
    held = _is_held(bodies, rooms)
    found = [_sunk(bodies, rooms, int(i)) for i in np.flatnonzero(bodies.low < -SUPPORT_GAP)]
    floating = np.flatnonzero(~held & (bodies.low > SUPPORT_GAP))
    found += [_floating(bodies, rooms, int(i)) for i in floating]
    ids = {piece.id: i for i, piece in reversed(list(enumerate(bodies.pieces)))}
    for i, piece in enumerate(bodies.pieces):
        if piece.on is not None:
            found += _stands_wrong(bodies, rooms, i, ids.get(piece.on))
    return found


def _is_held(bodies: Bodies, rooms: Rooms) -> Flags:
    support = np.array([kind.support for kind in bodies.kinds])
    unknown = ~bodies.known
    declared = np.array([piece.on is not None for piece in bodies.pieces], bool)
    ceiling = ceiling_over(bodies, rooms)
    held: Flags = np.abs(bodies.low) <= SUPPORT_GAP
    held |= declared | _is_stacked(bodies)
    held |= ((support == "wall") | unknown) & (_wall_gap(bodies, rooms.shapes) <= WALL_GAP)
    held |= ((support == "ceiling") | unknown) & (np.abs(ceiling - bodies.high) <= SUPPORT_GAP)
    return held


def _is_stacked(bodies: Bodies) -> Flags:
    """Which rows have another piece's top just beneath their middle."""
    stacked = np.zeros(len(bodies.pieces), bool)
    raised = np.flatnonzero(bodies.low > SUPPORT_GAP)
    if len(raised):
        middles = shapely.points(bodies.corners[raised].mean(1))
        upper, lower = shapely.STRtree(bodies.footprints).query(middles, predicate="intersects")
        upper = raised[upper]
        near = np.abs(bodies.low[upper] - bodies.high[lower]) <= SUPPORT_GAP
        near &= bodies.level[upper] == bodies.level[lower]
        stacked[upper[near]] = True
    return stacked


def _wall_gap(bodies: Bodies, shapes: Shapes) -> Floats:
    """Distance from the middle of each back edge to the nearest wall or partition of its room."""
    backs = shapely.points((bodies.corners[:, 0] + bodies.corners[:, 3]) / 2)
    walls: Shapes = shapely.boundary(shapes)
    gap = np.asarray(shapely.distance(backs, walls[bodies.room]), np.float64)
    built = np.flatnonzero([piece.category == PARTITION for piece in bodies.pieces])
    for room in np.unique(bodies.room[built]):
        partitions = shapely.union_all(bodies.footprints[built[bodies.room[built] == room]])
        here = bodies.room == room
        gap[here] = np.minimum(gap[here], shapely.distance(backs[here], partitions))
    return gap


def _sunk(bodies: Bodies, rooms: Rooms, i: int) -> Finding:
    deep = -float(bodies.low[i])
    text = f"{bodies.pieces[i].id} is sunk {deep:.2f} m into the floor"
    return _finding("sunk", bodies, rooms, i, text, deep)


def _floating(bodies: Bodies, rooms: Rooms, i: int) -> Finding:
    gap, support = float(bodies.low[i]), bodies.kinds[i].support
    wanted = {"wall": "its back is at no wall", "ceiling": "it does not reach the ceiling"}
    text = f"{bodies.pieces[i].id} floats {gap:.2f} m above the floor: "
    text += wanted.get(support, "nothing is beneath it")
    return _finding("floating", bodies, rooms, i, text, gap)


def _stands_wrong(bodies: Bodies, rooms: Rooms, i: int, under: int | None) -> list[Finding]:
    piece = bodies.pieces[i]
    if under is None or under == i:
        text = f"{piece.id} is said to stand on {piece.on}, which is not there"
        return [_finding("floating", bodies, rooms, i, text, float(bodies.low[i]))]
    gap = float(bodies.low[i] - bodies.high[under])
    middle = shapely.points(bodies.corners[i].mean(0))
    beside = float(shapely.distance(middle, bodies.footprints[under]))
    inside = bodies.pieces[under].category in bodies.kinds[i].under
    inside = inside and bodies.low[i] >= bodies.low[under] - SUPPORT_GAP
    if gap > SUPPORT_GAP or beside > TOLERANCE or bodies.level[i] != bodies.level[under]:
        text = f"{piece.id} floats {max(gap, 0.0):.2f} m above and {beside:.2f} m beside {piece.on}"
        return [_finding("floating", bodies, rooms, i, text, max(gap, beside), other=under)]
    if gap < -SUPPORT_GAP and not inside:
        text = f"{piece.id} is sunk {-gap:.2f} m into {piece.on}"
        return [_finding("sunk", bodies, rooms, i, text, -gap, other=under)]
    return []


def _finding(
    kind: str,
    bodies: Bodies,
    rooms: Rooms,
    i: int,
    message: str,
    amount: float,
    area: float = 0.0,
    other: int | None = None,
) -> Finding:
    piece = bodies.pieces[i]
    beside = None if other is None else bodies.pieces[other]
    given = piece.fixed and (beside is None or beside.fixed)
    return Finding(
        kind,
        rooms.levels[bodies.level[i]],
        piece.space,
        piece.id,
        beside.id if beside else "",
        message,
        round(amount, 4),
        round(area, 4),
        given,
    )
