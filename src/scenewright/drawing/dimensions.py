"""Dimension chains around a plan: openings, rooms and the whole, in metres."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from shapely import Geometry, LineString, intersects, union_all

from scenewright.building.wall_shares import polygons
from scenewright.core.space import Opening, Space
from scenewright.drawing.labels import polygon_of
from scenewright.drawing.marks import (
    CUT,
    FINE,
    GREY,
    NOTHING,
    Mark,
    MeantMark,
    PaperView,
    group,
    line,
    text,
    text_width,
    to_paper,
)
from scenewright.drawing.meanings import DimensionMeaning

Side = Literal["south", "west", "north", "east"]
Bounds = tuple[float, float, float, float]

FIRST, STEP, TICK, DIGITS, SMALL = 6.0, 5.0, 0.8, 1.8, 1.6
"""Millimetres: building to first chain, chain to chain, half a tick, text heights."""

APART = 1.0
"""Millimetres between the figures of neighbouring segments."""

THICKEST = 0.8
"""Gaps between rooms up to this many metres are walls, dimensioned to their middle."""

FACE, BEND = 0.4, 0.42
"""Metres of wall from which a corner is dimensioned, and the least sine of its turn (25°): a bow
has none."""

TOUCH, BEHIND = 0.05, 0.15
"""Metres by which rooms seen side by side may overlap, and by which they grow so that nothing is
seen through the wall between two of them."""


class DimensionChain(NamedTuple):
    """Stations along one side (x for south and north, y for west and east), in metres."""

    side: Side
    stations: tuple[float, ...]


def chains(
    whole: Geometry, solid: Geometry, spaces: Sequence[Space], openings: Sequence[Opening]
) -> dict[Side, list[DimensionChain]]:
    """Chains of each side from the building outwards; repeated and empty ones are left out.
    ``whole`` is the building with its walls, ``solid`` what hides openings: walls, cut where these
    are, and floors of rooms.

    South and west tell openings and corners, rooms and the whole; north and east the first only.
    """
    bounds: Bounds = whole.bounds
    found: dict[Side, list[DimensionChain]] = {}
    for side in ("south", "west", "north", "east"):
        ends = _ends(bounds, side)
        corners = [x for x in _corner_stations(side, whole) if ends[0] + FACE < x < ends[1] - FACE]
        rows = [[*_opening_stations(side, bounds, solid, openings), *corners]]
        if side in ("south", "west"):
            rows += [_room_stations(side, bounds, spaces), []]
        kept = [tuple(_merge_stations([*ends, *row])) for row in rows if row or row is rows[-1]]
        distinct = [row for i, row in enumerate(kept) if row not in kept[:i]]
        wanted = distinct if side in ("south", "west") else [r for r in distinct if len(r) > 2]
        found[side] = [DimensionChain(side, row) for row in wanted]
    return found


def margins(found: dict[Side, list[DimensionChain]]) -> dict[Side, float]:
    """Millimetres each side's chains need."""
    return {side: FIRST + STEP * len(rows) - 2.0 if rows else 3.0 for side, rows in found.items()}


def chains_mark(view: PaperView, bounds: Bounds, found: dict[Side, list[DimensionChain]]) -> Mark:
    """All chains of a plan, with the stations whose figures can be read at its scale."""
    marks = []
    for rows in found.values():
        kept = [chain._replace(stations=readable(chain.stations, view.scale)) for chain in rows]
        distinct = [chain for k, chain in enumerate(kept) if chain not in kept[:k]]
        marks += [
            _chain_mark(view, bounds, chain, FIRST + STEP * row)
            for row, chain in enumerate(distinct)
        ]
    return group(marks, stroke=GREY, stroke_width=FINE, fill="none")


def readable(stations: Sequence[float], scale: float) -> tuple[float, ...]:
    """Stations far enough apart for the figure between them at ``scale`` millimetres a metre.

    Two too close together (a narrow window) are dimensioned to their middle; what is too close
    still is left out. The ends stay.

    >>> readable((0.0, 2.0, 2.1, 5.0, 5.05), 20.0)
    (0.0, 2.05, 5.05)
    """
    least = (text_width("0.00", SMALL) + APART) / scale
    inner, paired = list(stations[1:-1]), list[float]()
    while inner:
        here = inner.pop(0)
        close = inner and inner[0] - here < least
        paired.append((here + inner.pop(0)) / 2 if close else here)
    kept, last = [stations[0]], stations[-1]
    for station in paired:
        if station - kept[-1] >= least and last - station >= least:
            kept.append(station)
    return (*kept, last)


def _chain_mark(view: PaperView, bounds: Bounds, chain: DimensionChain, offset: float) -> Mark:
    places = [_on_paper(view, bounds, chain.side, s) for s in chain.stations]
    out = _outward(chain.side)
    along = np.array([1.0, 0.0]) if chain.side in ("south", "north") else np.array([0.0, 1.0])
    slash = TICK * np.array([1.0, -1.0])
    marks = [
        line(
            [
                places[0] + offset * out - 1.2 * along * _sign(chain.side),
                places[-1] + offset * out + 1.2 * along * _sign(chain.side),
            ]
        )
    ]
    for place in places:
        foot = place + offset * out
        begin = max(1.5, offset - 1.6) if offset > FIRST else 1.5
        marks.append(line([place + begin * out, foot + 1.0 * out]))
        marks.append(line([foot - slash, foot + slash], stroke_width=CUT))
    turn = 90.0 if chain.side in ("west", "east") else 0.0
    figures = []
    for (a, b), (p, q) in zip(pairwise(chain.stations), pairwise(places), strict=True):
        words, size = _figure(abs(b - a), float(np.hypot(*(q - p))))
        marks.append(_measure(words, size, (p + q) / 2 + offset * out, turn))
        figures.append(words)
    measured = np.array(places)
    meaning = DimensionMeaning(measured, measured + offset * out, turn, tuple(figures))
    return MeantMark(group(marks), meaning)


def _figure(metres: float, room: float) -> tuple[str, float]:
    """The figure of a segment and its height, smaller where that is short; no words where there
    is no room."""
    words = f"{metres:.2f}"
    size = DIGITS if text_width(words, DIGITS) < room - APART else SMALL
    return ("" if text_width(words, size) > room else words), size


def _measure(words: str, size: float, middle: NDArray[np.float64], turn: float) -> Mark:
    """The figure over its segment."""
    if not words:
        return NOTHING
    up = np.array([-1.0, 0.0]) if turn else np.array([0.0, -1.0])
    return text(words, middle + 1.5 * up, size, turn, stroke="none", fill=GREY)


def _opening_stations(
    side: Side, bounds: Bounds, solid: Geometry, openings: Sequence[Opening]
) -> list[float]:
    """Jambs of the openings in walls that face this side with nothing beyond."""
    stations: list[float] = []
    for opening in openings:
        lengthwise = opening.ux if side in ("south", "north") else opening.uy
        if abs(lengthwise) < 0.999 or _hidden(opening, side, bounds, solid):
            continue
        middle = opening.x if side in ("south", "north") else opening.y
        stations += [middle - opening.width / 2, middle + opening.width / 2]
    return stations


def _corner_stations(side: Side, whole: Geometry) -> list[float]:
    """Corners of the building between straight walls that can be seen from this side."""
    axis = 0 if side in ("south", "north") else 1
    out = _outward(side) * (1, -1)
    west, south, east, north = whole.bounds
    far = out * (east - west + north - south)
    joined = whole.buffer(TOUCH, join_style="mitre").buffer(-TOUCH, join_style="mitre")
    stations: list[float] = []
    for part in polygons(joined):
        ring = np.asarray(part.simplify(TOUCH).exterior.coords)[:-1]
        before, after = ring - np.roll(ring, 1, 0), np.roll(ring, -1, 0) - ring
        cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
        shorter = np.minimum(np.hypot(*before.T), np.hypot(*after.T))
        sharp = np.abs(cross) > BEND * np.hypot(*before.T) * np.hypot(*after.T)
        stations += [
            float(point[axis])
            for point in ring[sharp & (shorter > FACE)]
            if joined.disjoint(_ray(point + 0.02 * out, far))
        ]
    return stations


def _hidden(opening: Opening, side: Side, bounds: Bounds, solid: Geometry) -> bool:
    """Whether a wall or room lies between the opening and this side of the building."""
    out = _outward(side) * (1, -1)
    start = np.array([opening.x, opening.y]) + out * (opening.thickness / 2 + 0.02)
    far = out * (bounds[2] - bounds[0] + bounds[3] - bounds[1])
    return len(opening.spaces) > 1 or bool(intersects(LineString([start, start + far]), solid))


def _room_stations(side: Side, bounds: Bounds, spaces: Sequence[Space]) -> list[float]:
    """Middles of the walls between rooms that can be seen from this side."""
    seen = sorted(_seen_intervals(side, bounds, spaces))
    stations: list[float] = []
    for (_, end), (begin, _) in pairwise(seen):
        gap = begin - end
        if gap > -TOUCH:
            stations += [(end + begin) / 2] if gap < THICKEST else [end, begin]
    return stations


def _seen_intervals(
    side: Side, bounds: Bounds, spaces: Sequence[Space]
) -> Iterable[tuple[float, float]]:
    """Extent along the side of the edges of each room that no other room hides."""
    rooms = [polygon_of(space) for space in spaces]
    closed = [room.buffer(BEHIND, join_style="mitre") for room in rooms]
    out = _outward(side) * (1, -1)
    axis = 0 if side in ("south", "north") else 1
    far = out * (bounds[2] - bounds[0] + bounds[3] - bounds[1])
    for index, space in enumerate(spaces):
        others = union_all([room for i, room in enumerate(closed) if i != index])
        ring = np.asarray(rooms[index].exterior.coords)
        ends: list[float] = []
        for a, b in pairwise(ring):
            start = (a + b) / 2 + out * 0.01
            if abs(a - b)[axis] > 0.2 and rooms[index].disjoint(_ray(start, far)):
                ends += [a[axis], b[axis]] if others.disjoint(_ray(start, far)) else []
        if ends and len(space.outline):
            yield min(ends), max(ends)


def _ray(start: NDArray[np.float64], far: NDArray[np.float64]) -> LineString:
    return LineString([start, start + far])


def _merge_stations(stations: Iterable[float], nearest: float = 0.03) -> list[float]:
    """Stations in order, those closer than 3 cm to the one before left out (the last is kept)."""
    ordered = sorted(stations)
    kept = ordered[:1]
    for station in ordered[1:]:
        if station - kept[-1] > nearest:
            kept.append(station)
    kept[-1] = max(kept[-1], ordered[-1])
    return kept


def _ends(bounds: Bounds, side: Side) -> tuple[float, float]:
    return (bounds[0], bounds[2]) if side in ("south", "north") else (bounds[1], bounds[3])


def _outward(side: Side) -> NDArray[np.float64]:
    """Unit vector on paper (y down) away from the building."""
    ways = {"south": (0, 1), "north": (0, -1), "west": (-1, 0), "east": (1, 0)}
    return np.array(ways[side], dtype=float)


def _sign(side: Side) -> float:
    return 1.0 if side in ("south", "north") else -1.0


def _on_paper(view: PaperView, bounds: Bounds, side: Side, station: float) -> NDArray[np.float64]:
    west, south, east, north = bounds
    points = {
        "south": (station, south),
        "north": (station, north),
        "west": (west, station),
        "east": (east, station),
    }
    return to_paper(view, points[side])
