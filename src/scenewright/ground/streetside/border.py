"""Where a site is entered from streets that lie on its border, or up to a verge beside it.

A street that runs into a site is entered on its own ground. Of one that runs along the border too
little lies inside for a lane to begin there, or nothing: then the border is open wherever the
street runs beside it, and lanes and walks come in over the verge.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.space import Points
from scenewright.ground.outlines import grow, lines, way
from scenewright.ground.plan import SitePlan, Way
from scenewright.ground.ways.path_raster import is_drivable

Floats = NDArray[np.float64]

EDGE, ROOM = 0.05, 1.0
"""Metres inside the border at least from which a line has left it, and by which a street must
reach deeper inside than half a lane for one to begin on it."""
LEAST, ASIDE = 1.0, 0.3
"""Metres of the shortest stretch of border that counts, and the cosine of how far from straight
out a street beside it may lie."""


def open_border(floor: shapely.Polygon, street: Way, verge: float, lane: float) -> Way:
    """A street with the parts of its middle line that run outside beside a site (``beside``) and
    the stretches of the outline that are open to it (``mouths``): those at most ``verge`` metres
    from its edge, none near where it reaches in far enough for a ``lane`` to begin.

    >>> line = np.array([[-90.0, -5.0], [90.0, -5.0]])
    >>> street = Way("a", "", "road", 6.0, line, (), ())
    >>> site = shapely.box(0, 0, 40, 30)
    >>> [mouth.tolist() for mouth in open_border(site, street, 8.0, 4.0).mouths]
    [[[0.0, 0.0], [40.0, 0.0]]]
    >>> open_border(site, street, 1.0, 4.0).mouths
    ()
    """
    reach = 0.5 * street.width + verge
    middle, border = shapely.LineString(street.line), floor.exterior
    if not shapely.dwithin(middle, border, reach):
        return street
    deep = max(0.5 * lane + ROOM - 0.5 * street.width, EDGE)
    whole = shapely.Polygon(border)
    inner, near = grow(whole, -deep), shapely.intersection(middle, grow(whole, reach + ROOM))
    parts = lines(shapely.difference(near, inner))
    ground = shapely.union_all([way(part, street.width)[1] for part in parts])
    entered = shapely.buffer(shapely.intersection(middle, inner), 2.0 * reach)
    open_ = shapely.difference(shapely.buffer(ground, verge), entered)
    mouths = _facing(shapely.intersection(border, open_), floor, ground)
    close = shapely.buffer(_join(mouths), reach + ROOM)
    outside = shapely.difference(near, floor)
    return street._replace(beside=lines(shapely.intersection(outside, close)), mouths=mouths)


class Exits(NamedTuple):
    """The ``border`` of a site where ways may end, and the ``streets`` outside that they lead on to
    from there; either may be empty."""

    border: shapely.Geometry
    streets: shapely.Geometry


def find_mouths(plan: SitePlan, width: float = 0.0) -> shapely.Geometry:
    """The border of a site as far as it is open to streets beside it; to those on which a lane of
    some ``width`` may begin, where there are any."""
    return _join(mouth for street in _list_driven(plan, width) for mouth in street.mouths)


def find_exits(plan: SitePlan, width: float = 0.0) -> Exits:
    """Where ways may end: the border as far as it is open to streets beside it (see
    :func:`find_mouths`), or all round a site into which none comes."""
    mouths = find_mouths(plan, width)
    beside = [cover_beside(street) for street in _list_driven(plan, width)]
    if plan.entrances or not mouths.is_empty:
        return Exits(mouths, shapely.union_all(beside))
    return Exits(shapely.LinearRing(plan.outline), shapely.Polygon())


def cover_beside(street: Way) -> shapely.Geometry:
    """The ground that a street beside a site covers there, border or not."""
    return shapely.union_all([way(line, street.width)[1] for line in street.beside])


def lead_out(line: Floats, exits: Exits, reach: float) -> Floats:
    """A line (n, 2) led on to where ways leave a site if it ends within ``reach`` metres of it, and
    over the verge to the street there."""
    end = shapely.Point(line[-1])
    if exits.border.is_empty or exits.border.distance(end) > reach:
        return line
    for goal in exits:
        step = shapely.get_coordinates(shapely.shortest_line(shapely.Point(line[-1]), goal))
        line = np.vstack([line, step[1:]])
    return line


def _list_driven(plan: SitePlan, width: float) -> Sequence[Way]:
    """The streets on which a lane may begin, or all where none of those serves the site."""
    driven = [street for street in plan.roads if is_drivable(street, width)]
    return driven if any(street.areas or street.mouths for street in driven) else plan.roads


def is_entered_anywhere(plan: SitePlan) -> bool:
    """Whether no street covers ground of a site, comes in or runs beside it: it is then entered
    from anywhere on its border."""
    return not plan.entrances and not any(street.areas or street.mouths for street in plan.roads)


def list_fronts(streets: Iterable[Way]) -> list[tuple[Points, float]]:
    """Lines (n, 2) with widths in metres along which ground lies beside streets: of those inside,
    of those beside the border, and of the border that is open to them."""
    return [
        row
        for street in streets
        for row in (
            *((line, street.width) for line in (*street.inside, *street.beside)),
            *((mouth, 0.0) for mouth in street.mouths),
        )
    ]


def _facing(
    border: shapely.Geometry, floor: shapely.Polygon, ground: shapely.Geometry
) -> tuple[Points, ...]:
    """The stretches of a border whose outside looks towards the ``ground`` of a street, or that lie
    on it."""
    rows = [np.stack([row[:-1], row[1:]], 1) for row in lines(border)]
    edges = np.concatenate([np.zeros((0, 2, 2)), *rows])
    if not len(edges):
        return ()
    middle, along = edges.mean(1), edges[:, 1] - edges[:, 0]
    out = np.stack([along[:, 1], -along[:, 0]], 1) / np.hypot(*along.T)[:, None]
    out[shapely.contains_xy(floor, *(middle + EDGE * out).T)] *= -1.0
    ways = shapely.shortest_line(shapely.points(middle), ground)
    step = np.diff(shapely.get_coordinates(ways).reshape(-1, 2, 2), axis=1)[:, 0]
    looks = (step * out).sum(1) >= ASIDE * np.hypot(*step.T)
    found = lines(shapely.union_all(shapely.linestrings(edges[looks])))
    return tuple(row for row in found if np.hypot(*np.diff(row, axis=0).T).sum() >= LEAST)


def _join(rows: Iterable[Points]) -> shapely.Geometry:
    return shapely.union_all([shapely.LineString(row) for row in rows])
