"""Hours of sun on the sunny side of buildings, by the shadows they throw on a plane.

On the plane at the height of window sills, 0.9 m, a building of height H throws the shadow it
covers when moved by (H - 0.9) / tan(altitude) away from the sun. A stretch of the sunny side (the
one that looks most towards the equator) is lit when the sun stands before the side and no shadow
of another building lies over it. Hours count between 8 and 16 in true solar time (GB 50180).
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.check.bodies import Floats, Indices, Shapes
from scenewright.core.report import Finding
from scenewright.domains.site.check.bodies import JudgedSite, SiteBodies

SILL, STEP, MOST = 0.9, 0.25, 120
"""Height of sills in metres, hours between two looks at the sun, and buildings looked at."""

FARTHEST = 600.0


def sun(latitude: float, day: int) -> Floats:
    """Rows ``(t, 3)`` of the unit direction to the sun (east, north, up), while it is up.

    Declination 23.45 degrees times sin(2 pi (284 + day) / 365) (P. I. Cooper, 1969).

    >>> sun(0.0, 81).shape, sun(80.0, 355).shape
    ((32, 3), (0, 3))
    """
    hours = np.arange(8.0 + STEP / 2, 16.0, STEP)
    tilt = np.deg2rad(23.45) * np.sin(2 * np.pi * (284 + day) / 365)
    phi, turn = np.deg2rad(latitude), (hours - 12) / 24 * 2 * np.pi
    rows = np.stack(
        [
            -np.cos(tilt) * np.sin(turn),
            np.sin(tilt) * np.cos(phi) - np.cos(tilt) * np.sin(phi) * np.cos(turn),
            np.sin(tilt) * np.sin(phi) + np.cos(tilt) * np.cos(phi) * np.cos(turn),
        ],
        -1,
    )
    return rows[rows[:, 2] > 0.02]


def sun_hours(bodies: SiteBodies, latitude: float, day: int, rows: Indices) -> Floats:
    """Hours of sun of the bodies ``rows``, each averaged along its sunny side."""
    sides = sunny_sides(bodies.corners[rows], latitude)
    along = sides[:, 1] - sides[:, 0]
    outward = np.stack([along[:, 1], -along[:, 0]], -1)
    edges, owner = _edges(bodies)
    total = np.zeros(len(rows))
    for east, north, up in sun(latitude, day):
        facing = np.flatnonzero(outward @ (east, north) > 0)
        if len(facing):
            away = -np.array([east, north]) / up
            ahead = (edges[:, 1] - edges[:, 0]) @ (-away[1], away[0]) > 1e-9
            last = np.flatnonzero(ahead & (bodies.high[owner] > SILL))
            shadows = _shadows(edges[last], bodies.high[owner[last]] - SILL, away)
            total[facing] += STEP * _lit(sides[facing], rows[facing], shadows, owner[last])
    return total


def find_sunless(grounds: JudgedSite, bodies: SiteBodies) -> list[Finding]:
    """Buildings, every one of them looked at, with fewer hours of sun than the brief requires."""
    own, asked = np.flatnonzero(~bodies.landmark), grounds.site.sun_hours
    if not len(own):
        return []
    hours = sun_hours(bodies, grounds.site.latitude, grounds.site.day, own)
    return [
        Finding(
            "lack_of_sun",
            "",
            grounds.plan.id,
            bodies.ids[row],
            "",
            f"{bodies.ids[row]} has {got:.2f} h of sun, {asked:g} h are required",
            round(asked - got, 3),
            0.0,
            bool(bodies.given[row]),
        )
        for row, got in zip(own.tolist(), hours.tolist(), strict=True)
        if got < asked - 1e-6
    ]


def sunny_sides(corners: Floats, latitude: float) -> Floats:
    """The side ``(n, 2, 2)`` of each box that looks most towards the equator, the inside on its
    left; the front where two do alike."""
    starts = corners[:, [1, 2, 3, 0]]
    ends = corners[:, [2, 3, 0, 1]]
    along = ends - starts
    away = -along[..., 0] / np.maximum(np.hypot(along[..., 0], along[..., 1]), 1e-12)
    best = np.argmax(np.round(-away if latitude >= 0 else away, 6), axis=1)
    number = np.arange(len(corners))
    return np.stack([starts[number, best], ends[number, best]], 1)


def sample_rows(count: int) -> Indices:
    """At most 120 of ``count`` rows, evenly spread."""
    return np.unique(np.linspace(0, count - 1, min(count, MOST)).round().astype(np.int64))


def _edges(bodies: SiteBodies) -> tuple[Floats, Indices]:
    """Edges ``(e, 2, 2)`` of all footprints, and the body of each."""
    points, owner = shapely.get_coordinates(bodies.footprints, return_index=True)
    same = owner[1:] == owner[:-1]
    return np.stack([points[:-1], points[1:]], 1)[same], owner[1:][same]


def _shadows(edges: Floats, heights: Floats, away: Floats) -> Shapes:
    """What each edge covers when moved. Those that look away from the sun make the shadows:
    what a footprint covers beyond itself, it covers by them."""
    moved = np.minimum(heights, FARTHEST / np.hypot(*away))
    shifted = edges[:, ::-1] + (moved[:, None] * away)[:, None]
    return shapely.polygons(np.concatenate([edges, shifted], 1))


def _lit(sides: Floats, rows: Indices, shadows: Shapes, owner: Indices) -> Floats:
    """The share of each side that lies in no shadow of another body."""
    segments = shapely.linestrings(sides)
    i, k = shapely.STRtree(shadows).query(segments, predicate="intersects")
    i, k = i[owner[k] != rows[i]], k[owner[k] != rows[i]]
    parts = shapely.intersection(segments[i], shadows[k])
    points, pair = shapely.get_coordinates(parts, return_index=True)
    start, along = sides[:, 0], sides[:, 1] - sides[:, 0]
    own = i[pair]
    t = ((points - start[own]) * along[own]).sum(-1) / (along[own] ** 2).sum(-1)
    low, high = np.full(len(i), np.inf), np.full(len(i), -np.inf)
    np.minimum.at(low, pair, t)
    np.maximum.at(high, pair, t)
    lit = np.ones(len(sides))
    for side in np.unique(i):
        order = np.flatnonzero(i == side)
        lit[side] -= _measure_union(low[order], high[order])
    return np.clip(lit, 0.0, 1.0)


def _measure_union(low: Floats, high: Floats) -> float:
    """The length of the union of intervals."""
    order = np.argsort(low)
    low, high = low[order], np.maximum.accumulate(high[order])
    before = np.concatenate([[-np.inf], high[:-1]])
    return float(np.maximum(high - np.maximum(low, before), 0.0).sum())
