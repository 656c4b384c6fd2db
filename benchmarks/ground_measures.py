"""What an urban designer counts on a finished ground, by geometry of its own.

Nothing here is shared with what lays the ground: ways, walks and squares are the surfaces of the
scene, doors the middle of the side of a footprint that is farthest ahead, plots what is written.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import GroundSurface, Piece

WAYS, WALKS = ("asphalt", "path", "lane", "pavement", "marking"), ("walk", "square", "court")
BY_WAY, ASIDE, JOINED = 12.0, np.cos(np.pi / 4), 0.6
"""Metres within which a wall is by a way, cosine of how far a front may look aside, metres within
which ways, walks and doors meet."""
SMALL = 50.0
"""Square metres below which a building is an outbuilding, whatever it is called."""
SERVING = ("barn", "shed", "garage", "stable", "wash")
BELONGS = 9.0
"""Metres from a house within which an outbuilding belongs to it."""
RIM = 1.0
"""Metres between the points looked at along the rim of a square."""
HEAD, LONG = 5.0, 30.0
"""Metres of radius that make a turning head, and of a dead end that needs one."""


class Ground(NamedTuple):
    """Houses with footprints (n,), doors (n, 2) and the directions they look in (n, 2); ways,
    walks and squares as areas; laid lanes as lines with widths; plots by the house they are of."""

    houses: tuple[Piece, ...]
    shapes: Any
    doors: Any
    ahead: Any
    ways: shapely.Geometry
    walks: shapely.Geometry
    squares: tuple[shapely.Polygon, ...]
    lanes: tuple[tuple[shapely.LineString, float], ...]
    plots: dict[str, shapely.Polygon]
    border: shapely.Geometry
    area: float


def read_ground(
    houses: Sequence[Piece],
    surfaces: Sequence[GroundSurface],
    squares: Sequence[shapely.Polygon],
    lanes: Sequence[tuple[shapely.LineString, float]],
    plots: dict[str, shapely.Polygon],
    floors: Sequence[shapely.Polygon],
) -> Ground:
    """The ground of some houses of a scene."""
    rings = [outline_of(one) for one in houses]
    turn = np.array([one.pose.heading for one in houses])
    ahead = np.stack([np.cos(turn), np.sin(turn)], 1).reshape(-1, 2)
    doors = [_door(ring, out) for ring, out in zip(rings, ahead, strict=True)]
    shapes = np.array([shapely.Polygon(ring) for ring in rings], object)
    ways, walks = _joined(surfaces, WAYS), _joined(surfaces, WALKS)
    spots = np.array(doors).reshape(-1, 2)
    border = shapely.union_all([floor.exterior for floor in floors])
    area = float(sum(floor.area for floor in floors))
    paths = (ways, walks, tuple(squares), tuple(lanes))
    return Ground(tuple(houses), shapes, spots, ahead, *paths, plots, border, area)


def _door(ring: Any, out: Any) -> Any:
    middle = (ring + np.roll(ring, -1, axis=0)) / 2
    return middle[int(np.argmax(np.round(middle @ out, 6)))]


def _joined(surfaces: Sequence[GroundSurface], kinds: Sequence[str]) -> shapely.Geometry:
    parts = [shapely.Polygon(*area) for row in surfaces if row.kind in kinds for area in row.areas]
    return shapely.union_all([part.buffer(0) for part in parts])


def is_outbuilding(piece: Piece, area: float) -> bool:
    """Whether a building serves others: small, or called so."""
    return area < SMALL or any(word in piece.function.lower() for word in SERVING)


def counts_of(ground: Ground) -> dict[str, tuple[float, float]]:
    """Every measure as how many of how many."""
    serving = np.array(
        [is_outbuilding(p, s.area) for p, s in zip(ground.houses, ground.shapes, strict=True)], bool
    )
    home = ~serving
    return {
        "fronts to the way": _fronts(ground, home),
        "doors within 12 m of a way": _near_doors(ground, home),
        **_dead_ends(ground),
        "doors with their walk": _walks(ground),
        "houses with a plot": _plots(ground, home),
        "plots on a way": _plots_on_ways(ground),
        "rim of squares fronted": _rim(ground),
        "outbuildings": (float(serving.sum()), float(len(serving))),
        "outbuildings behind a house": _behind(ground, serving),
        "coverage": (float(shapely.area(shapely.union_all(ground.shapes))), ground.area),
    }


def _fronts(ground: Ground, home: Any) -> tuple[float, float]:
    """Houses by a way or square whose front looks at it within 45°."""
    if ground.ways.is_empty or not home.any():
        return 0.0, 0.0
    ways = shapely.union_all([ground.ways, *ground.squares])
    by = home & (shapely.distance(ground.shapes, ways) <= BY_WAY)
    step = _steps(shapely.points(ground.doors), ways)
    looks = (step * ground.ahead).sum(1) >= ASIDE * np.hypot(*step.T)
    return float((by & looks).sum()), float(by.sum())


def _steps(points: Any, goal: shapely.Geometry) -> Any:
    lines = shapely.get_coordinates(shapely.shortest_line(points, goal)).reshape(-1, 2, 2)
    return lines[:, 1] - lines[:, 0]


def _near_doors(ground: Ground, home: Any) -> tuple[float, float]:
    away = shapely.distance(shapely.points(ground.doors), ground.ways)
    return float((home & (away <= BY_WAY)).sum()), float(home.sum())


def _dead_ends(ground: Ground) -> dict[str, tuple[float, float]]:
    """Lanes with an end that meets no other way, and of those over 30 m such without a head; a
    street that leaves the ground over its border goes on beyond it."""
    dead, bare = 0, 0
    given = ground.ways
    for k, (line, width) in enumerate(ground.lanes):
        others = [o.buffer(w / 2) for j, (o, w) in enumerate(ground.lanes) if j != k]
        own = line.buffer(width / 2 + 0.01)
        rest = shapely.union_all([shapely.difference(given, own.buffer(0.3)), *others])
        ends = [shapely.Point(line.coords[i]) for i in (0, -1)]
        lost = [end for end in ends if end.distance(rest) > width / 2 + JOINED]
        lost = [end for end in lost if end.distance(ground.border) > 1.5]
        heads = [end.buffer(HEAD).intersection(given).area > 0.8 * np.pi * HEAD**2 for end in lost]
        dead += bool(lost)
        bare += bool(lost) and line.length > LONG and not all(heads)
    return {
        "dead ends among lanes": (float(dead), float(len(ground.lanes))),
        "long dead ends without a head": (float(bare), float(max(dead, 1) if dead else 0)),
    }


def _walks(ground: Ground) -> tuple[float, float]:
    """Doors from which paving leads to a way."""
    paved = shapely.union_all([ground.ways, ground.walks]).buffer(0.05)
    joined = [part for part in shapely.get_parts(paved) if part.intersects(ground.ways)]
    reach = shapely.union_all(joined)
    if not len(ground.doors) or ground.ways.is_empty:
        return 0.0, 0.0
    there = shapely.distance(shapely.points(ground.doors), reach) <= JOINED
    return float(there.sum()), float(len(there))


def _plots(ground: Ground, home: Any) -> tuple[float, float]:
    """Dwellings on a plot of their own that holds them."""
    held = [
        p.id in ground.plots and ground.plots[p.id].intersection(s).area >= 0.95 * s.area
        for p, s in zip(ground.houses, ground.shapes, strict=True)
    ]
    return float((home & np.array(held, bool)).sum()), float(home.sum())


def _behind(ground: Ground, serving: Any) -> tuple[float, float]:
    """Outbuildings within :data:`BELONGS` of a house that is nearer to a way or square."""
    ways = shapely.union_all([ground.ways, *ground.squares])
    away, homes = shapely.distance(ground.shapes, ways), np.flatnonzero(~serving)
    behind = 0
    for k in np.flatnonzero(serving).tolist():
        near = homes[shapely.distance(ground.shapes[homes], ground.shapes[k]) <= BELONGS]
        behind += bool((away[near] < away[k]).any())
    return float(behind), float(serving.sum())


def _plots_on_ways(ground: Ground) -> tuple[float, float]:
    on = [plot.distance(ground.ways) <= 2.0 for plot in ground.plots.values()]
    return float(sum(on)), float(len(on))


def _rim(ground: Ground) -> tuple[float, float]:
    """Metres of the sides of squares, less those along a way, before which a front stands."""
    fronted, whole = 0, 0
    for square in ground.squares:
        ring = shapely.get_coordinates(shapely.orient_polygons(square).exterior)
        for a, b in pairwise(ring):
            long = float(np.hypot(*(b - a)))
            way = (b - a) / max(long, 1e-9)
            out = np.array([way[1], -way[0]])
            for s in np.arange(RIM / 2, long, RIM):
                at = a + s * way
                if shapely.Point(at).distance(ground.ways) < 2.5:
                    continue
                ray = shapely.LineString([at, at + BY_WAY * out])
                met = [k for k in range(len(ground.shapes)) if ray.intersects(ground.shapes[k])]
                whole += 1
                if met:
                    first = min(met, key=lambda k: ground.shapes[k].distance(shapely.Point(at)))
                    fronted += bool(ground.ahead[first] @ -out >= ASIDE)
    return float(fronted), float(whole)
