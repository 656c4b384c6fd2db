"""What hangs on walls that would be bare: a picture, and a lamp where one under the ceiling is not
enough.

A wall's free stretches are what neither openings nor anything as high as one's shoulder takes of
it. A picture hangs over the middle of a low piece before a stretch (a sofa, a desk, a bed), else
in the middle of the longest.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.ceiling import lowest
from scenewright.building.door_approach import gates
from scenewright.core.catalog import Catalog
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains.home.furnishing.obstacles import (
    StandingObstacles,
    find_faults_of,
    flat_kinds,
    standing_of,
)
from scenewright.domains.home.grounds.hanging_walls import hanging_walls
from scenewright.domains.home.groups.classes import LIVED_IN
from scenewright.domains.home.problem import Ground
from scenewright.geometry.fit import faults, is_backed

Floats = NDArray[np.float64]

ADORNMENT = frozenset(("picture", "wall_shelf", "wall_clock", "wall_exhibit"))
"""What makes a wall lived in; a mirror over a chest or the cabinets of a kitchen do not."""
LAMPS = frozenset(
    ("ceiling_lamp", "pendant_lamp", "wall_lamp", "floor_lamp", "table_lamp", "desk_lamp")
)
SEATS = ("sofa", "loveseat", "corner_sofa", "armchair", "double_bed", "single_bed")
HANGS_WITHIN = 0.03  # what is this near to a wall hangs on it, metres
ADORNED = 5.0  # area from which a room has something on a wall, m²
LIT = 12.0  # area from which a room has a second lamp, m²
SHOULDER = 1.1  # what rises above this takes a wall from what hangs on it, metres
AGAINST = 0.15  # what is nearer than this leaves no way between it and the wall, metres
PASSED = 0.9  # floor left free before a wall with nothing at it, metres
ASIDE_OF_IT = 0.6  # and to either side of it
STANDS_BEFORE = 0.4  # what is nearer than this to a wall stands before it, metres
LOWEST = 0.8  # nothing hangs lower, as it would under a slope, metres
EYES = 1.55  # height of a picture's middle, metres
MARGIN = 0.1  # what hangs stays this far from openings and tall things, metres
WIDEST, SHARE = 1.2, 0.5  # a picture's greatest width, and what it takes of its stretch
NARROWEST_PICTURE = 0.45  # a narrower picture is not hung, metres
LAMP = Size(0.16, 0.14, 0.26)


class FreeStretch(NamedTuple):
    """A free stretch of a wall: its ends (2,) each in the plan, the unit vector into the room, its
    length in metres, and from where to where something low stands at it, in metres from its
    start."""

    start: Floats
    end: Floats
    inward: Floats
    length: float
    low: tuple[tuple[float, float], ...]


def fill_walls(
    space: Space, ground: Ground, pieces: tuple[Piece, ...], catalog: Catalog
) -> list[Piece]:
    """A picture for a room with nothing on its walls, a wall lamp for a large one with a single
    lamp; nothing where all walls are taken."""
    area = float(shapely.Polygon(space.outline, list(space.holes)).area)
    if not LIVED_IN & set(space.functions) or area < ADORNED:
        return []
    here = [p for p in pieces if p.space == space.id]
    found: list[Piece] = []
    if not any(p.category in ADORNMENT for p in here):
        found += _first_free(_pictures(space, ground, pieces), ground, pieces, catalog)
    if area >= LIT and sum(p.category in LAMPS for p in here) == 1:
        standing = (*pieces, *found)
        found += _first_free(_lamps(space, ground, standing), ground, standing, catalog)
    return found


def _pictures(space: Space, ground: Ground, pieces: Sequence[Piece]) -> Iterator[Piece]:
    """Pictures to try, the best places first."""
    stretches = find_stretches(space, ground, pieces)
    for stretch in sorted(stretches, key=lambda s: -s.length - bool(s.low)):
        middle = stretch.length / 2
        for share in (1.0, 0.7, 0.5):
            wide = round(share * min(WIDEST, SHARE * stretch.length), 2)
            if wide < NARROWEST_PICTURE:
                break
            size = Size(wide, 0.04, round(0.62 * wide, 2))
            over = [(a + b) / 2 for a, b in stretch.low if b - a >= wide]
            nearest = sorted(over, key=lambda t: abs(t - middle))[:1]
            for t in (*nearest, middle):
                if wide / 2 <= t <= stretch.length - wide / 2:
                    yield _hung("picture", space, ground, stretch, t, size)


def _lamps(space: Space, ground: Ground, pieces: Sequence[Piece]) -> Iterator[Piece]:
    """Wall lamps to try, those nearest to where one sits or lies first."""
    seats = [p.pose[:2] for p in pieces if p.space == space.id and p.category in SEATS]
    seats = seats or [tuple(space.outline.mean(0))]
    places = [
        (stretch, t)
        for stretch in find_stretches(space, ground, pieces)
        for t in np.arange(0.2, stretch.length - 0.2, 0.2)
    ]

    def away(place: tuple[FreeStretch, float]) -> float:
        at = _point(*place)
        return min(float(np.hypot(*(at - seat))) for seat in seats)

    for stretch, t in sorted(places, key=away):
        yield _hung("wall_lamp", space, ground, stretch, float(t), LAMP)


def _point(stretch: FreeStretch, t: float) -> Floats:
    return stretch.start + (stretch.end - stretch.start) * t / stretch.length


def _hung(
    category: str, space: Space, ground: Ground, stretch: FreeStretch, t: float, size: Size
) -> Piece:
    """Something with its middle at eye level, or under a ceiling that is lower."""
    x, y = _point(stretch, t) + stretch.inward * (size.depth / 2 + 0.002)
    heading = float(np.arctan2(stretch.inward[1], stretch.inward[0]))
    box = np.array([[x, y, heading, size.width, size.depth]])
    top = min(EYES + size.height / 2, lowest(box, ground.slopes, space.height)[0] - MARGIN)
    pose = Pose(float(x), float(y), float(top) - size.height, heading)
    return Piece(
        f"{space.id}/{category}_on_wall", category, "", space.id, pose, size, space.id, "light"
    )


def find_stretches(
    space: Space, ground: Ground, pieces: Sequence[Piece]
) -> tuple[FreeStretch, ...]:
    """The free stretches of the walls of a room in which ``pieces`` stand."""
    openings = [
        (g.face, g.opening.width / 2 + MARGIN, np.array([g.opening.ux, g.opening.uy]))
        for g in gates(space)
    ]
    outlines = [(p, outline_of(p)) for p in pieces]
    found: list[FreeStretch] = []
    for wall in hanging_walls(ground):
        start, end = wall[:2], wall[2:]
        length = float(np.hypot(*(end - start)))
        along = (end - start) / max(length, 1e-9)
        inward = np.array([-along[1], along[0]])
        taken = [
            ((face - start) @ along - half, (face - start) @ along + half)
            for face, half, _ in openings
            if abs((face - start) @ inward) < 0.05
        ]
        low: list[tuple[float, float]] = []
        for piece, outline in outlines:
            ahead, beside = (outline - start) @ inward, (outline - start) @ along
            if ahead.min() > STANDS_BEFORE or ahead.max() < 0 or piece.pose.z > EYES + 0.5:
                continue
            if piece.pose.z + piece.size.height > SHOULDER:
                taken.append((beside.min() - MARGIN, beside.max() + MARGIN))
            elif piece.size.height > 0.1 and ahead.min() < AGAINST:
                low.append((float(beside.min()), float(beside.max())))
        found += _between(start, along, inward, length, taken, low)
    return tuple(found)


def _between(
    start: Floats,
    along: Floats,
    inward: Floats,
    length: float,
    taken: list[tuple[float, float]],
    low: list[tuple[float, float]],
) -> Iterator[FreeStretch]:
    """What ``taken`` leaves of a wall, from MARGIN to its length less that."""
    at = MARGIN
    for first, last in (*sorted(taken), (length - MARGIN, length)):
        if first - at >= NARROWEST_PICTURE:
            inside = tuple((a - at, b - at) for a, b in low if at < (a + b) / 2 < first)
            yield FreeStretch(start + along * at, start + along * first, inward, first - at, inside)
        at = max(at, last)


def _first_free(
    forms: Iterator[Piece], ground: Ground, pieces: Sequence[Piece], catalog: Catalog
) -> list[Piece]:
    """The first that meets nothing and is under the ceiling, with the asset that draws it."""
    flat = flat_kinds(catalog)
    standing = standing_of(tuple(pieces), flat)
    for piece in forms:
        if (
            piece.pose.z > LOWEST
            and _is_free(piece, ground, standing)
            and _is_passed(piece, ground, standing, pieces)
        ):
            asset = catalog.choose(piece.category, piece.size)
            return [replace(piece, asset=asset.id if asset else "")]
    return []


def _is_free(piece: Piece, ground: Ground, standing: StandingObstacles) -> bool:
    """Whether a piece hangs on a wall and meets nothing."""
    box, _, codes = find_faults_of(piece, ground, standing)
    return bool(codes[0] == 0) and bool(is_backed(box[0], hanging_walls(ground), HANGS_WITHIN))


def _is_passed(
    piece: Piece, ground: Ground, standing: StandingObstacles, pieces: Sequence[Piece]
) -> bool:
    """Whether it takes no way: something stands at the wall below its whole width, or the floor
    before it is free."""
    c, s = np.cos(piece.pose.heading), np.sin(piece.pose.heading)
    middle = np.array(piece.pose[:2])
    for low in pieces:
        outline = outline_of(low) - middle
        beside, ahead = outline @ (s, -c), outline @ (c, s)
        wide = beside.min() <= -piece.size.width / 2 and beside.max() >= piece.size.width / 2
        if wide and -0.1 < ahead.min() < AGAINST and low.size.height > 0.1 and low.pose.z < 0.1:
            return True
    x, y = middle + (PASSED - piece.size.depth) / 2 * np.array([c, s])
    box = np.array([[x, y, piece.pose.heading, piece.size.width + 2 * ASIDE_OF_IT, PASSED]])
    none, span = np.zeros((0, 6)), np.array([[0.05, 2.0]])
    others = (standing.boxes, standing.spans)
    codes, _ = faults(box, span, np.zeros(1, bool), ground.edges, none[:, :5], none, *others, 0.005)
    return bool(codes[0] == 0)
