"""Plots: the ground of each house, to the middle of the gap to its neighbours and to its street.

A point of open ground belongs to the nearest house; what lies farther than :data:`DEEP` from all
belongs to nobody. Outbuildings belong to a dwelling, and their ground is its ground.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.space import Points
from scenewright.ground.streetside.terraces import find_terraces, split_terrace

Shapes = NDArray[np.object_]
Indices = NDArray[np.int64]
Flags = NDArray[np.bool_]

STEP, APART = 2.0, 0.05
"""Metres between the points of a wall that ground is shared out by, and by which walls that touch
are taken to stand apart."""
SHAKEN = 2e-3
"""Metres by which these points are moved about."""
DEEP = 24.0
"""Metres from a house that its ground reaches at most."""
BENT = 2.5
"""Metres: the root of the area that a border may gain or lose where it is drawn straighter."""
JOINED = 0.5
"""Metres within which the ground of an outbuilding adjoins that of its dwelling."""
PASSAGE = 1.6
"""Metres between houses that one passes through."""
OUTBUILDING = 45.0
"""Square metres below which a building is taken for an outbuilding."""
LEAST = 4.0
"""Square metres of the least plot."""


class Plot(NamedTuple):
    """The ground of a house: the id of the ``house``, its ``outline`` (n, 2) counter-clockwise,
    square metres with the house, and the ids of the outbuildings on it."""

    house: str
    outline: Points
    area: float
    outbuildings: tuple[str, ...] = ()


def share_ground(ground: shapely.Geometry, shapes: Shapes) -> Shapes:
    """The part (n,) of some ground that is nearest to each of some footprints (n,), which it holds;
    borders between are as straight as :data:`BENT` allows.

    Voronoi cells of points along the walls (Voronoi 1908), joined by house; the ground of a
    straight terrace is shared out by the walls between its houses.

    >>> two = np.array([shapely.box(2, 2, 4, 4), shapely.box(8, 2, 10, 4)], object)
    >>> [round(float(part.area), 1) for part in share_ground(shapely.box(0, 0, 12, 6), two)]
    [36.0, 36.0]
    """
    if not len(shapes):
        return shapes
    rows = find_terraces(shapes)
    owner_of = np.arange(len(shapes))
    for row in rows:
        owner_of[row.houses] = row.houses[0]
    walls = shapely.buffer(shapes, -APART, join_style="mitre")
    walls = np.where(shapely.is_empty(walls), shapes, walls)
    dense = shapely.segmentize(shapely.normalize(walls), STEP)
    points, owner = shapely.get_coordinates(dense, return_index=True)
    points, first = np.unique(np.round(points, 4), axis=0, return_index=True)
    owner = owner_of[owner[first]]
    if len(shapes) == 1:
        return np.array([_near(ground, shapes[0])], object)
    parts = _cells(points, ground)
    runs = np.split(*_runs(owner, len(shapes)))
    straight = np.array([shapely.union_all(parts[rows]) for rows in runs], object)
    holds = shapely.area(straight) > 0  # the first of a terrace for all of it
    straight[holds] = shapely.coverage_simplify(straight[holds], BENT)
    for row in rows:
        straight[row.houses] = split_terrace(straight[row.houses[0]], row)
    own = _less_walls(shapely.intersection(straight, ground), shapes)
    return np.array([_near(a, b) for a, b in zip(own, shapes, strict=True)], object)


def _less_walls(parts: Shapes, shapes: Shapes) -> Shapes:
    """Parts (n,) of ground less the footprints (n,) of others that reach into them."""
    part, shape = shapely.STRtree(shapes).query(parts, predicate="intersects")
    found = parts.copy()
    for k, other in zip(part.tolist(), shape.tolist(), strict=True):
        if k != other:
            found[k] = shapely.difference(found[k], shapes[other])
    return found


def _cells(points: Points, ground: shapely.Geometry) -> Shapes:
    """The Voronoi cell (n,) of each point (n, 2), as far as some ground reaches."""
    k = np.arange(len(points))
    # cells of GEOS overlap where many points lie on one circle: none does once they are shaken
    shaken = points + SHAKEN * np.stack([np.sin(12.9898 * k), np.sin(78.233 * k)], 1)
    cells = shapely.voronoi_polygons(
        shapely.multipoints(shaken), extend_to=shapely.box(*ground.bounds), ordered=True
    )
    return np.asarray(shapely.get_parts(cells))


def _runs(owner: Indices, count: int) -> tuple[Indices, Indices]:
    """The numbers of cells by owner, and where the run of each owner after the first begins."""
    order = np.argsort(owner, kind="stable")
    return order, np.searchsorted(owner[order], np.arange(1, count))


def _near(part: shapely.Geometry, shape: shapely.Polygon) -> shapely.Polygon:
    """The piece of ground about a footprint, and the footprint."""
    wide = shapely.buffer(shape, DEEP, quad_segs=2, join_style="mitre", mitre_limit=1.5)
    reach = _about(wide, shape)  # of a court, GEOS also gives a shell within the outer one
    inside = shapely.get_parts(shapely.intersection(part, reach))
    pieces = [p for p in inside if p.geom_type == "Polygon"]
    near = shapely.union_all([*pieces, shape], grid_size=1e-3)
    return _about(near, shape)


def _about(ground: shapely.Geometry, shape: shapely.Polygon) -> shapely.Polygon:
    """The piece of some ground that a footprint stands on, without holes."""
    pieces = [p for p in shapely.get_parts(ground) if p.geom_type == "Polygon"]
    best = max(pieces, key=lambda p: p.intersection(shape).area)
    return shapely.Polygon(best.exterior)


def assign_outbuildings(shapes: Shapes, serving: Flags) -> Indices:
    """The number of the dwelling that each footprint (n,) belongs to: its own if it is none of
    those ``serving`` (n,), else the nearest; its own too where no dwelling stands.

    >>> three = np.array([shapely.box(0, 0, 9, 9), shapely.box(30, 0, 39, 9),
    ...                   shapely.box(22, 0, 25, 3)], object)
    >>> assign_outbuildings(three, np.array([False, False, True])).tolist()
    [0, 1, 1]
    """
    found = np.arange(len(shapes))
    homes, others = np.flatnonzero(~serving), np.flatnonzero(serving)
    if len(homes) and len(others):
        near = shapely.STRtree(shapes[homes]).query_nearest(shapes[others], all_matches=False)
        found[others[near[0]]] = homes[near[1]]
    return found


def lay_plots(
    ground: shapely.Geometry, names: Sequence[str], shapes: Shapes, serving: Flags
) -> tuple[Plot, ...]:
    """The plot of each dwelling on some ``ground`` free of streets and squares, with the names of
    the outbuildings that stand on it (``serving``, (n,)). An outbuilding whose ground does not
    adjoin that of its dwelling has a plot of its own."""
    if not len(shapes) or ground.is_empty:
        return ()
    parts, owner = share_ground(ground, shapes), assign_outbuildings(shapes, serving)
    for k in np.flatnonzero(serving).tolist():
        if owner[k] != k and not shapely.dwithin(parts[k], parts[owner[k]], JOINED):
            owner[k] = k
    found = []
    for home in np.flatnonzero(owner == np.arange(len(owner))).tolist():
        rows = np.flatnonzero(owner == home)
        whole = shapely.union_all(parts[rows], grid_size=1e-3)
        pieces = [p for p in shapely.get_parts(whole) if p.geom_type == "Polygon"]
        plot = shapely.Polygon(
            max(pieces, key=lambda p: p.intersection(shapes[home]).area).exterior
        )
        ring = shapely.get_coordinates(shapely.orient_polygons(plot).exterior)[:-1]
        if plot.area >= LEAST:
            others = tuple(names[k] for k in rows.tolist() if k != home)
            found.append(Plot(names[home], ring, float(plot.area), others))
    return tuple(found)
