"""Made-up sites for tests and measurements."""

from __future__ import annotations

from math import pi

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.domains.site.problem import Buildings, SiteGround, SiteProblem

Floats = NDArray[np.float64]
STYLES = np.array(
    [
        [12.0, 10.0, 9.0, 0.35, 0.3, 0.9],
        [18.0, 12.0, 24.0, 0.55, 0.5, 0.8],
        [15.0, 15.0, 60.0, 0.45, 0.7, 1.0],
        [30.0, 14.0, 18.0, 0.7, 0.4, 0.6],
        [24.0, 20.0, 15.0, 1.0, 0.2, 0.7],
    ]
)
"""Width, depth, height, visual quality, tone and symmetry of five styles."""


def edges_of(shape: shapely.Polygon) -> Floats:
    """Directed edges (e, 4), the inside on the left."""
    shape = shapely.normalize(shape)
    rings = [shapely.geometry.polygon.orient(shape).exterior]
    rings += list(shapely.geometry.polygon.orient(shape).interiors)
    parts = []
    for ring in rings:
        points = shapely.get_coordinates(ring)
        parts.append(np.hstack([points[:-1], points[1:]]))
    return np.concatenate(parts)


def example_ground(width: float, depth: float, setback: float = 3.0) -> SiteGround:
    """A site with a corner cut off, a road across, a path along and a landmark in a block."""
    outline = shapely.Polygon(
        [(0, 0), (width, 0), (width, 0.7 * depth), (0.8 * width, depth), (0, depth)]
    )
    roads = np.array(
        [
            [0.45 * width, 0.5 * depth, pi / 2, 8.0, depth],
            [0.5 * width, 0.3 * depth, 0.0, 4.0, width],
        ]
    )
    landmark = np.array([[0.2 * width, 0.65 * depth, -pi / 2, 12.0, 12.0]])
    taken = [
        shapely.box(0.45 * width - 7, -1, 0.45 * width + 7, depth + 1),
        shapely.box(-1, 0.3 * depth - 5, width + 1, 0.3 * depth + 5),
        shapely.box(0.2 * width - 12, 0.65 * depth - 12, 0.2 * width + 12, 0.65 * depth + 12),
    ]
    free = outline.buffer(-setback, join_style="mitre").difference(shapely.union_all(taken))
    blocks = [edges_of(part) for part in shapely.get_parts(free)]
    ends = np.cumsum([0, *map(len, blocks)])
    along = np.arange(0.0, width, 5.0)
    return SiteGround(
        edges_of(outline),
        np.concatenate(blocks),
        np.column_stack([ends[:-1], ends[1:]]).astype(np.int64),
        np.array([part.area for part in shapely.get_parts(free)]),
        roads,
        landmark,
        np.array([20.0]),
        np.array([0.9]),
        np.column_stack([along, np.full(len(along), 0.3 * depth)]),
        np.array([0.0, 0.0, width, depth]),
        float(outline.area),
    )


def example_site(count: int = 15, side: float = 0.0) -> SiteProblem:
    """A site for ``count`` buildings of five styles; ``side`` its width, by default ample."""
    side = side or 60.0 + 32.0 * count**0.5
    models = np.sort(np.arange(count) % len(STYLES)).astype(np.int64)
    rows = STYLES[models]
    made = Buildings(
        rows[:, :3].copy(),
        rows[:, 3].copy(),
        rows[:, 4].copy(),
        rows[:, 5].copy(),
        models,
        np.maximum(rows[:, 2] // 3.0, 1.0).astype(np.int64),
    )
    return SiteProblem(
        example_ground(side, 0.8 * side),
        made,
        tuple(f"b{k}" for k in range(count)),
        {},
        6.0,
        0.0,
        -pi / 2,
        4.0,
        35.0,
        20,
    )
