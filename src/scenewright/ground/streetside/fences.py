"""Fences, walls and hedges about plots: every end is on a house, on another fence or at a gate."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.scene import Piece
from scenewright.ground.streetside.plots import PASSAGE, Plot, Shapes
from scenewright.ground.ways.door_walks import find_doors

SETBACK = 0.25
"""Metres between the border of plots and what encloses them."""
HELD, REACH = 0.05, 3.5
"""Metres within which the end of a fence is on what holds it, and up to which it is led on to a
house."""
SHORT, FREE = 1.5, 3.0
"""Metres of the shortest fence, and of one that no house holds."""
ALONG = 0.3
"""Metres farther from a way than it is set back, within which a fence stands along it."""
COURT = (1.8, 2.2)
"""Width and depth in metres of the ground before a door that is kept open."""
ROUNDS = 4


class FenceLines(NamedTuple):
    """The middle lines of fences: along ways, and all others."""

    street: shapely.Geometry
    other: shapely.Geometry


def fence_lines(
    plots: Sequence[Plot],
    shapes: Shapes,
    ways: shapely.Geometry,
    gates: shapely.Geometry,
    thick: float,
) -> FenceLines:
    """Where fences ``thick`` metres stand: behind the border of all plots, and between them; none
    on ground of ``gates`` (walks, squares, what is before doors) and where a house is so near that
    nobody could pass: there a fence leads on to the house.

    >>> ring = np.array([[0, 0], [20, 0], [20, 12], [0, 12.0]])
    >>> house = np.array([shapely.box(8, 6, 14, 10)], object)
    >>> gate = shapely.box(10, -1, 12, 6)
    >>> lines = fence_lines([Plot("a", ring, 240.0)], house, shapely.box(0, -4, 20, 0), gate, 0.1)
    >>> round(float(lines.street.length), 1)
    18.0
    """
    if not plots:
        return FenceLines(shapely.LineString(), shapely.LineString())
    back = SETBACK + thick / 2
    grounds = [shapely.Polygon(row.outline) for row in plots]
    whole = shapely.buffer(shapely.union_all(grounds, grid_size=1e-3), -back, join_style="mitre")
    borders = shapely.union_all([shapely.LinearRing(row.outline) for row in plots], grid_size=1e-3)
    lines = shapely.union(shapely.boundary(whole), shapely.intersection(borders, whole))
    near = shapely.union_all(shapely.buffer(shapes, PASSAGE, join_style="mitre"))
    lines = shapely.difference(lines, shapely.union(near, gates), grid_size=1e-3)
    kept = _hold(lines, shapely.union_all(shapes), gates)
    along = shapely.buffer(ways, back + ALONG, quad_segs=2)
    rim = shapely.buffer(shapely.boundary(whole), HELD, quad_segs=1)
    front = shapely.intersection(along, rim)
    return FenceLines(shapely.intersection(kept, front), shapely.difference(kept, front))


def list_forecourts(houses: Sequence[Piece]) -> list[shapely.Polygon]:
    """The ground before the door of each house."""
    doors, ahead = find_doors(houses)
    aside = COURT[0] / 2 * np.stack([-ahead[:, 1], ahead[:, 0]], 1)
    far = doors + COURT[1] * ahead
    corners = np.stack([doors - aside, doors + aside, far + aside, far - aside], 1)
    return list(shapely.polygons(corners))


def _hold(
    lines: shapely.Geometry, houses: shapely.Geometry, gates: shapely.Geometry
) -> shapely.Geometry:
    """Lines whose loose ends are led on to a house, and those that cannot be taken away."""
    edges = _edges(lines)
    loose = _loose_ends(edges, houses, gates)
    spots = shapely.points(np.array(sorted(loose)).reshape(-1, 2))
    links = shapely.shortest_line(spots, houses)
    good = (shapely.length(links) <= REACH) & ~shapely.intersects(links, gates)
    edges = _edges(shapely.union_all([*edges, *links[good]]))
    for _ in range(ROUNDS):
        loose = _loose_ends(edges, houses, gates)
        kept = [edge for edge in edges if not loose & set(_ends(edge))]
        if len(kept) == len(edges):
            break
        edges = _edges(shapely.union_all(kept))
    return shapely.union_all([run for run in _runs(edges) if _is_long(run, houses)])


def _edges(lines: shapely.Geometry) -> list[shapely.LineString]:
    """The pieces of lines between the points where they meet."""
    parts = shapely.get_parts(shapely.get_parts(shapely.union_all(lines)))
    kept = [p for p in parts if p.geom_type in ("LineString", "LinearRing") and p.length > 1e-3]
    return list(shapely.get_parts(shapely.line_merge(shapely.union_all(kept))))


def _ends(edge: shapely.LineString) -> tuple[tuple[float, float], ...]:
    return tuple((round(x, 3), round(y, 3)) for x, y in (edge.coords[0], edge.coords[-1]))


def _loose_ends(
    edges: Sequence[shapely.LineString], houses: shapely.Geometry, gates: shapely.Geometry
) -> set[tuple[float, float]]:
    """The ends of edges that are on no other, no house and no gate."""
    single = [at for at, n in Counter(at for edge in edges for at in _ends(edge)).items() if n == 1]
    spots = shapely.points(np.array(single).reshape(-1, 2))
    held = shapely.dwithin(spots, houses, HELD) | shapely.dwithin(spots, gates, HELD)
    return {at for at, fast in zip(single, held, strict=True) if not fast}


def _runs(edges: Sequence[shapely.LineString]) -> list[shapely.Geometry]:
    """Edges that hang together."""
    joined = shapely.get_parts(shapely.union_all([edge.buffer(HELD) for edge in edges]))
    found = [[e for e in edges if e.intersects(part)] for part in joined]
    return [shapely.union_all(rows) for rows in found if rows]


def _is_long(run: shapely.Geometry, houses: shapely.Geometry) -> bool:
    least = SHORT if shapely.dwithin(run, houses, HELD) else FREE
    return bool(run.length >= least)
