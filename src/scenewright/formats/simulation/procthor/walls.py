"""Walls as one-sided upright rectangles, one or more an edge of a floor, with the holes in them.

Each hole is in the middle of a piece of wall of its own, on both sides of the wall: so its place
is the same from either end, and whether a reader mirrors it for the far side does not matter.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.scene import Scene
from scenewright.core.space import Level, Opening

Floats = NDArray[np.float64]
MARGIN = 0.05
"""How far a piece of wall with a hole goes on beside it, in metres, where there is room."""
THIN = 1e-4
EXTERIOR = "exterior"


class WallPiece(NamedTuple):
    """A piece of wall: the id of the floor it belongs to, from where to where in plan, seen from
    its right; how high; and the id of the opening in its middle, if any."""

    owner: str
    start: Floats
    end: Floats
    base: float
    height: float
    opening: str = ""


class _Hole(NamedTuple):
    opening: Opening
    edge: int
    along: float
    room: float


def wall_pieces(scene: Scene) -> Iterator[WallPiece]:
    """All walls: those of rooms, of columns in them, and the faces outside."""
    levels = {level.id: level for level in scene.levels}
    sides = [*_sides(scene, levels)]
    found = [_find_holes(ring, openings) for _, ring, openings, _, _ in sides]
    margins: dict[str, float] = {}
    for holes in found:
        for hole in holes:
            known = margins.get(hole.opening.id, MARGIN)
            margins[hole.opening.id] = max(min(known, hole.room), 0.0)
    for (owner, ring, _, base, height), holes in zip(sides, found, strict=True):
        yield from _cut_ring(owner, ring, holes, margins, (base, height))


def _sides(
    scene: Scene, levels: dict[str, Level]
) -> Iterator[tuple[str, Floats, Sequence[Opening], float, float]]:
    """Rings walked with what they are seen from on the right: floors, columns, the outside."""
    for space in scene.spaces:
        base = levels[space.level].elevation
        openings = [one for one in scene.openings if space.id in one.spaces]
        yield space.id, space.outline[::-1], openings, base, space.height
        for hole in space.holes:
            yield space.id, hole[::-1], (), base, space.height
    for level in scene.levels:
        outer = [o for o in scene.openings if o.level == level.id and len(o.spaces) == 1]
        for ring in _outside(scene, level):
            yield EXTERIOR, ring, outer, level.elevation, level.height


def _outside(scene: Scene, level: Level) -> Iterator[Floats]:
    """The outlines of what is built of a level, counter-clockwise."""
    prisms = [p for wall in scene.walls if wall.level == level.id for p in wall.prisms]
    shapes = [shapely.Polygon(p.outline, p.holes) for p in prisms]
    shapes += [shapely.Polygon(s.outline) for s in scene.spaces if s.level == level.id]
    whole = shapely.union_all(shapely.buffer(shapes, 0.002, join_style="mitre"))
    plain = whole.buffer(-0.002, join_style="mitre").simplify(0.003)
    for part in shapely.get_parts(plain):
        yield shapely.get_coordinates(shapely.orient_polygons(part).exterior)[:-1]


def _find_holes(ring: Floats, openings: Sequence[Opening]) -> list[_Hole]:
    """The openings of a ring with the edge each is in, how far along, and the room beside it."""
    starts, ends = ring, np.roll(ring, -1, axis=0)
    ways = ends - starts
    lengths = np.linalg.norm(ways, axis=1)
    ways = ways / np.maximum(lengths, 1e-12)[:, None]
    placed = []
    for one in openings:
        away = np.array([one.x, one.y]) - starts
        along = np.einsum("ij,ij->i", away, ways)
        across = np.abs(away[:, 0] * ways[:, 1] - away[:, 1] * ways[:, 0])
        beyond = np.maximum(np.maximum(-along, along - lengths), 0.0)
        askew = np.abs(ways[:, 0] * one.uy - ways[:, 1] * one.ux)
        edge = int(np.argmin(across + beyond + 10.0 * askew))
        if across[edge] + beyond[edge] < one.thickness + 0.3:
            placed.append((one, edge, float(along[edge]), float(lengths[edge])))
    return [_Hole(o, e, s, _room_beside(o, e, s, length, placed)) for o, e, s, length in placed]


def _room_beside(
    one: Opening,
    edge: int,
    along: float,
    length: float,
    placed: Sequence[tuple[Opening, int, float, float]],
) -> float:
    """Half of the shortest wall beside a hole, to the end of its edge or to the next hole."""
    half = one.width / 2
    gaps = [along - half, length - along - half]
    gaps += [
        abs(s - along) - half - o.width / 2 for o, e, s, _ in placed if e == edge and o is not one
    ]
    return min(gaps) / 2


def _cut_ring(
    owner: str,
    ring: Floats,
    holes: Sequence[_Hole],
    margins: dict[str, float],
    heights: tuple[float, float],
) -> Iterator[WallPiece]:
    for number, (start, end) in enumerate(zip(ring, np.roll(ring, -1, axis=0), strict=True)):
        length = float(np.linalg.norm(end - start))
        if length < THIN:
            continue
        way, done = (end - start) / length, 0.0
        for hole in sorted((h for h in holes if h.edge == number), key=lambda h: h.along):
            reach = hole.opening.width / 2 + margins[hole.opening.id]
            low, high = hole.along - reach, hole.along + reach
            if low - done > THIN:
                yield WallPiece(owner, start + done * way, start + low * way, *heights)
            ends = start + low * way, start + high * way
            yield WallPiece(owner, *ends, *heights, hole.opening.id)
            done = high
        if length - done > THIN:
            yield WallPiece(owner, start + done * way, end, *heights)


def hinge_of(opening: Opening, piece: WallPiece) -> tuple[str, str]:
    """On which side a door's hinges are, seen from the room of a piece of wall facing it, and
    whether its leaf turns in or out, slides or is missing."""
    if opening.kind == "passage":
        return "left", "none"
    if opening.hinge == 0:
        return "left", "slide"
    way = (piece.end - piece.start) / np.linalg.norm(piece.end - piece.start)
    same = 1 if way @ (opening.ux, opening.uy) > 0 else -1
    inwards = -same  # the room is on the right of its walls
    hinge = "left" if opening.hinge * same < 0 else "right"
    return hinge, "in" if opening.swing == inwards else "out"
