"""Where zones meet each other and the walls of their hall.

Two rings run along each other where an edge of one lies within 2 cm of an edge of the other.
Rings need not share corners: overlaps of single edges are found first, then strung together
and drawn straight where they bend by no more than a few centimetres.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building import outlines
from scenewright.core.layout import corners
from scenewright.core.space import Opening, Points, Space
from scenewright.domains.hall.hall_layout import Zone

BORDERS_TOUCH = 0.02
JOG = 3 * BORDERS_TOUCH
BEND = 0.03
BORDER_BEND = 0.1
LEAST_BORDER = 0.1
LEAST_STRETCH = 0.4
LEAST_HOLE = 1.0
BESIDE_DOOR = 0.1


class Border(NamedTuple):
    """A straight piece of border from ``start`` to ``end`` (x, y): zone number ``first`` lies on
    its left, ``second`` on its right."""

    first: int
    second: int
    start: tuple[float, float]
    end: tuple[float, float]


class WallStretch(NamedTuple):
    """A straight piece of wall without doors, the zone on its left. ``windows`` are the windows
    in it: from, to (metres from the start) and the height of the sill."""

    x0: float
    y0: float
    x1: float
    y1: float
    windows: tuple[tuple[float, float, float], ...] = ()


def shared_borders(zones: Iterable[Zone]) -> tuple[Border, ...]:
    """Every straight piece of border between two zones, at least 0.1 m long, ``first`` the zone
    of lower number.

    >>> left = Zone("a", "", "hall", np.array([[0, 0], [2, 0], [2, 3], [0, 3]], float))
    >>> right = Zone("b", "", "hall", np.array([[2, 1], [5, 1], [5, 5], [2, 5]], float))
    >>> shared_borders([left, right])
    (Border(first=0, second=1, start=(2.0, 1.0), end=(2.0, 3.0)),)
    """
    rings = [zone_edges(zone) for zone in zones]
    owners = np.repeat(np.arange(len(rings)), [len(ring) for ring in rings])
    edges = np.vstack([np.zeros((0, 4)), *rings])
    own, other, pieces = _alongside(edges, edges, -1.0)
    keys = np.column_stack([owners[own], owners[other]])
    found: list[Border] = []
    for first, second in np.unique(keys[keys[:, 0] < keys[:, 1]], axis=0).tolist():
        mine = pieces[(keys[:, 0] == first) & (keys[:, 1] == second)]
        for line in _strung(mine, JOG):
            points = shapely.get_coordinates(shapely.simplify(line, BORDER_BEND))
            found += _segments(points, first, second)
    return tuple(found)


def border_lengths(borders: Iterable[Border]) -> dict[tuple[int, int], float]:
    """The length of the longest unbroken border of every two zones that share one, in metres;
    pieces that follow each other end to start count as one."""
    longest: dict[tuple[int, int], float] = {}
    run, last = 0.0, None
    for border in borders:
        pair = (border.first, border.second)
        goes_on = last is not None and (last.first, last.second, last.end) == (*pair, border.start)
        run = (run if goes_on else 0.0) + float(np.hypot(*np.subtract(border.end, border.start)))
        longest[pair], last = max(longest.get(pair, 0.0), run), border
    return longest


def wall_stretches(zone: Zone, space: Space) -> tuple[WallStretch, ...]:
    """The straight pieces of the hall's walls along a zone, at least 0.4 m long.

    Walls are the outline of the hall and its holes of at least 1 m around. Doors and passages
    are cut out with 0.1 m at each side. A curved wall is drawn straight where it bends by no
    more than 3 cm, and such a piece is moved in so that all of it lies inside the hall.
    """
    holes = (hole for hole in space.holes if outlines.run_lengths(hole)[-1] >= LEAST_HOLE)
    walls = np.vstack([outlines.edges(ring) for ring in (space.outline, *holes)])
    _, _, pieces = _alongside(zone_edges(zone), walls, 1.0)
    lines = _strung(pieces, BORDERS_TOUCH)
    gaps = [_gap(opening) for opening in space.openings if opening.kind != "window"]
    if gaps and lines:
        cut = shapely.difference(np.array(lines), shapely.union_all(gaps))
        lines = [part for part in shapely.get_parts(cut).tolist() if not part.is_empty]
    windows = [opening for opening in space.openings if opening.kind == "window"]
    return tuple(found for line in lines for found in _straighten_line(line, windows))


def floor_of(space: Space) -> shapely.Polygon:
    """The floor of a space: its outline without its holes."""
    return shapely.Polygon(space.outline, space.holes)


def zone_of(outline: shapely.Polygon, name: tuple[str, str], space: Space) -> Zone:
    """A zone with a clean outline; ``name`` is its id and its name."""
    ring, holes = outlines.rings(outline)
    return Zone(name[0], name[1] or name[0], space.id, ring, holes)


def zone_edges(zone: Zone) -> Points:
    """Directed edges ``(e, 4)`` of a zone's outline and holes, the zone on their left."""
    return np.vstack([outlines.edges(ring) for ring in (zone.outline, *zone.holes)])


def _alongside(
    edges: Points, others: Points, sense: float
) -> tuple[NDArray[np.int64], NDArray[np.int64], Points]:
    """The pieces of ``edges`` within 2 cm of edges of ``others`` that run the same way (sense 1)
    or the opposite way (-1): the numbers of both edges and the pieces (k, 4).

    On edge p + t u the other edge lies at signed distance d(t), linear in t; the piece is where
    both exist and abs(d) is at most 2 cm.
    """
    lines, tree = _lines(edges), shapely.STRtree(_lines(others))
    own, other = tree.query(lines, predicate="dwithin", distance=BORDERS_TOUCH)
    start, along, length = _split_edges(edges[own])
    a, b = others[other, :2] - start, others[other, 2:] - start
    ta, tb = (a * along).sum(1), (b * along).sum(1)
    da, db = (along[:, 0] * p[:, 1] - along[:, 1] * p[:, 0] for p in (a, b))
    steep = sense * (tb - ta) < 0.8 * np.hypot(*(b - a).T)
    slope = (db - da) / np.where(steep, 1.0, tb - ta)
    low, high = np.maximum(np.minimum(ta, tb), 0.0), np.minimum(np.maximum(ta, tb), length)
    flat = np.abs(slope) < 1e-9
    safe = np.where(flat, 1.0, slope)
    ends = np.sort([ta + (-BORDERS_TOUCH - da) / safe, ta + (BORDERS_TOUCH - da) / safe], axis=0)
    low = np.where(flat, low, np.maximum(low, ends[0]))
    high = np.where(flat, high, np.minimum(high, ends[1]))
    kept = ~steep & (high - low > 1e-6) & (~flat | (np.abs(da) <= BORDERS_TOUCH))
    pieces = np.hstack([start + low[:, None] * along, start + high[:, None] * along])
    return own[kept], other[kept], pieces[kept]


def _lines(edges: Points) -> NDArray[np.object_]:
    lines: NDArray[np.object_] = shapely.linestrings(edges.reshape(-1, 2, 2))
    return lines


def _split_edges(edges: Points) -> tuple[Points, Points, Points]:
    step = edges[:, 2:] - edges[:, :2]
    length = np.hypot(step[:, 0], step[:, 1])
    return edges[:, :2], step / length[:, None], length


def _strung(pieces: Points, gap: float) -> list[shapely.LineString]:
    """Directed pieces strung together where one starts (within ``gap``) where another ends."""
    if len(pieces) == 0:
        return []
    rows = np.unique(_snap_ends(pieces, gap), axis=0)
    merged = shapely.line_merge(shapely.multilinestrings(_lines(rows)), directed=True)
    return [part for part in shapely.get_parts(merged).tolist() if part.length >= LEAST_BORDER]


def _snap_ends(pieces: Points, gap: float) -> Points:
    """The pieces with ends that lie within ``gap`` of each other moved onto one point."""
    ends = pieces.reshape(-1, 2)
    tree = shapely.STRtree(shapely.points(ends))
    one, two = tree.query(shapely.points(ends), predicate="dwithin", distance=gap)
    lowest = np.arange(len(ends))
    np.minimum.at(lowest, one, two)
    moved = ends[lowest].reshape(-1, 4)
    return moved[np.hypot(*(moved[:, 2:] - moved[:, :2]).T) > outlines.SAME_POINT]


def _segments(points: Points, first: int, second: int) -> list[Border]:
    rows = [tuple(map(float, point)) for point in points]
    return [
        Border(first, second, (start[0], start[1]), (end[0], end[1]))
        for start, end in pairwise(rows)
        if np.hypot(end[0] - start[0], end[1] - start[1]) >= LEAST_BORDER
    ]


def _gap(opening: Opening) -> shapely.Polygon:
    """The wall a door takes: its width and 0.1 m at each side."""
    heading = np.arctan2(opening.ux, -opening.uy)
    width, depth = opening.width + 2 * BESIDE_DOOR, opening.thickness + 2 * (BEND + BORDERS_TOUCH)
    return shapely.Polygon(corners(np.array([[opening.x, opening.y, heading, width, depth]]))[0])


def _straighten_line(line: shapely.LineString, windows: list[Opening]) -> list[WallStretch]:
    """Straight stretches along a line, each moved in (to the left) past what bulges there."""
    fine = shapely.get_coordinates(line)
    kept = shapely.get_coordinates(shapely.simplify(line, BEND))
    found = []
    for start, end in pairwise(kept):
        length = float(np.hypot(*(end - start)))
        if length < LEAST_STRETCH:
            continue
        along = (end - start) / length
        left = np.array([-along[1], along[0]])
        t, d = (fine - start) @ along, (fine - start) @ left
        bulge = d[(t > -1e-6) & (t < length + 1e-6) & (np.abs(d) <= BEND + 1e-6)].max()
        start = start + max(float(bulge), 0.0) * left
        end = start + length * along
        seen = _windows(start, along, length, windows)
        x0, y0, x1, y1 = map(float, (*start, *end))
        found.append(WallStretch(x0, y0, x1, y1, seen))
    return found


def _windows(
    start: Points, along: Points, length: float, windows: list[Opening]
) -> tuple[tuple[float, float, float], ...]:
    found = []
    for window in windows:
        dx, dy = window.x - start[0], window.y - start[1]
        t, d = dx * along[0] + dy * along[1], dx * along[1] - dy * along[0]
        turned = along[0] * window.ux + along[1] * window.uy
        low, high = max(t - window.width / 2, 0.0), min(t + window.width / 2, length)
        if abs(turned) > 0.9 and abs(d) < window.thickness + 2 * BEND and high > low:
            found.append((float(low), float(high), window.sill))
    return tuple(sorted(found))
