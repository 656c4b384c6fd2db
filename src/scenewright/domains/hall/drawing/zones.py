"""The zones of a hall in plan: soft tints, dashed borders, the passages that must stay open."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Geometry, LineString, Polygon

from scenewright.domains.hall.hall_layout import Zone, ZoneLink
from scenewright.domains.hall.zoning.borders import shared_borders
from scenewright.drawing.marks import (
    FINE,
    GREY,
    INK,
    LINE,
    WARNING,
    Mark,
    PaperView,
    arrow_head,
    group,
    line,
    plate,
    shape,
    text_width,
    to_paper,
)

TINTS = ("#faf0d6", "#c6dbec", "#fce0ce", "#d6cce0", "#cde5d2", "#d9eff5", "#efcccc", "#c3cbd9")
"""Soft fills of CIE lightness 95 to 81, at least 1.4 apart, so that they differ in grey too."""

BESIDE = 0.3
"""Most metres between neighbouring zones."""

ARROW, HEAD, WORDS = 3.0, 1.5, 1.8
"""Millimetres: half the arrow of a passage, its heads, the text beside it."""

Key = tuple[str, str]
Vector = NDArray[np.float64]


def shape_of(zone: Zone) -> Polygon:
    """The zone's floor as a polygon."""
    return Polygon(zone.outline, zone.holes)


def tints(zones: Sequence[Zone]) -> dict[Key, str]:
    """A fill for every zone by space and id: another than that of zones it shares a border with,
    evenly used; those with most neighbours choose first (Welsh and Powell, 1967).

    >>> square = np.array([[0, 0], [4, 0], [4, 4], [0, 4]], float)
    >>> list(tints([Zone(name, name, "hall", square) for name in "ab"]).values())
    ['#faf0d6', '#c6dbec']
    """
    shapes = shapely.buffer([shape_of(zone) for zone in zones], BESIDE / 2, join_style="mitre")
    one, two = shapely.STRtree(shapes).query(shapes, predicate="intersects")
    shared = shapely.area(shapely.intersection(shapes[one], shapes[two])) > 1.5 * BESIDE**2
    beside = [set(two[shared & (one == k)].tolist()) - {k} for k in range(len(zones))]
    chosen: dict[int, int] = {}
    for number in sorted(range(len(zones)), key=lambda k: (-len(beside[k]), k)):
        near = [chosen[k] for k in beside[number] if k in chosen]
        used = list(chosen.values())
        chosen[number] = min(
            range(len(TINTS)), key=lambda tint: (near.count(tint), used.count(tint), tint)
        )
    return {(zone.space, zone.id): TINTS[chosen[k]] for k, zone in enumerate(zones)}


def zones_mark(view: PaperView, zones: Sequence[Zone], colours: dict[Key, str]) -> Mark:
    """The tinted floors."""
    marks = [
        shape(
            [to_paper(view, ring) for ring in (zone.outline, *zone.holes)],
            fill=colours[zone.space, zone.id],
        )
        for zone in zones
    ]
    return group(marks, fill_rule="evenodd", stroke="none")


def borders_mark(view: PaperView, zones: Sequence[Zone], walls: Geometry) -> Mark:
    """Borders of the zones, each drawn once, dashed, where no wall or partition stands."""
    rings = shapely.set_precision([shape_of(zone).boundary for zone in zones], 0.01)
    open_ = shapely.difference(shapely.union_all(rings), walls.buffer(0.06))
    parts = shapely.get_parts(shapely.line_merge(shapely.simplify(open_, 0.02)))
    marks = [
        line(to_paper(view, shapely.get_coordinates(part)))
        for part in parts.tolist()
        if part.geom_type in ("LineString", "LinearRing") and part.length > 0.15
    ]
    return group(marks, fill="none", stroke=GREY, stroke_width=LINE, stroke_dasharray="1.6 1")


class ZoneCrossing(NamedTuple):
    """Where people pass from zone to zone: a point on the border, the unit vector along the
    border there, and whether the passage is as wide as it must be."""

    at: Vector
    along: Vector
    open: bool


def links_mark(
    view: PaperView,
    links: Sequence[ZoneLink],
    zones: Sequence[Zone],
    bodies: Geometry,
    route: Geometry,
) -> Mark:
    """A double arrow through the border of zones that must be linked, with the least width."""
    known = {(zone.space, zone.id): zone for zone in zones}
    busy = shapely.union(bodies, route.buffer(0.8 / view.scale))
    marks = []
    for link in links:
        pair = [known.get((link.space, name)) for name in (link.first, link.second)]
        found = passage([zone for zone in pair if zone], link.width, bodies, route)
        if found is not None:
            marks.append(_link(view, found, link.width, busy))
    return group(marks)


def passage(
    pair: Sequence[Zone], width: float, bodies: Geometry, route: Geometry
) -> ZoneCrossing | None:
    """Where a passage ``width`` wide fits the border of two zones: in the longest free stretch,
    off the route if possible; ``None`` if they share no border."""
    borders = [LineString([border.start, border.end]) for border in shared_borders(pair)]
    if not borders:
        return None
    near = bodies.intersection(shapely.union_all(borders).buffer(width))
    wide = [part.difference(near.buffer(width / 2 - 0.01)) for part in borders]
    free = [part for part in shapely.get_parts(wide).tolist() if not part.is_empty]
    bare = shapely.get_parts([part.difference(near) for part in borders]).tolist()
    best = max(free or bare or borders, key=lambda part: float(part.length))
    spots = shapely.line_interpolate_point(best, np.linspace(0.1, 0.9, 9), normalized=True)
    off = np.minimum(shapely.distance(spots, route), 1.5)
    order = off - 0.02 * np.abs(np.arange(9) - 4)
    spot = spots[int(np.argmax(np.where(np.isfinite(order), order, 0.0)))]
    ends = shapely.get_coordinates(best)[[0, -1]]
    along = ends[1] - ends[0]
    return ZoneCrossing(
        shapely.get_coordinates(spot)[0], along / max(np.hypot(*along), 1e-9), bool(free)
    )


def _link(view: PaperView, found: ZoneCrossing, width: float, busy: Geometry) -> Mark:
    middle = to_paper(view, found.at)
    along = found.along * (1.0, -1.0)
    across = np.array([-along[1], along[0]])
    ends = middle - ARROW * across, middle + ARROW * across
    colour = INK if found.open else WARNING
    words = f"≥ {width:.2f} m"
    place = _beside(view, found.at, (text_width(words, WORDS) / 2 + 0.7, WORDS / 2 + 0.8), busy)
    heads = [
        shape([arrow_head(end, way, HEAD)], fill=colour, stroke="none")
        for end, way in ((ends[0], -across), (ends[1], across))
    ]
    halo = line(ends, stroke="#ffffff", stroke_width=5 * LINE)
    bar = line(ends, stroke=colour, stroke_width=2 * FINE)
    return group([halo, bar, *heads, plate(words, place, WORDS, fill=colour)])


def _beside(view: PaperView, at: Vector, half: tuple[float, float], busy: Geometry) -> Vector:
    """The paper point in that quarter around a plan point where words of half a size ``half``
    cover least of what is there."""
    signs = np.array([(1, -1), (1, 1), (-1, -1), (-1, 1)])
    centres = at + signs * half / view.scale
    low, high = centres - np.array(half) / view.scale, centres + np.array(half) / view.scale
    boxes = shapely.box(*low.T, *high.T)
    covered = shapely.area(shapely.intersection(boxes, busy))
    away = np.minimum(shapely.distance(shapely.points(centres), busy), 10.0)
    best = np.lexsort((-np.round(away, 6), np.round(covered, 6)))[0]
    return to_paper(view, centres[best])
