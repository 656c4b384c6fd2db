"""Tall things between the eye and things behind them, drawn as if of glass in pictures from
above at an angle.

A wardrobe 2 m high hides the bed behind it, a partition the exhibits of the next zone. An eye that
looks ``towards`` (x, y, z) sees a thing at a height h hidden by whatever lies nearer and rises
higher: the footprint of a tall thing, swept away from the eye by (its height - h) |xy| / |z|. A
piece counts as hidden by its middle.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.catalog import Material, Part
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]

TALL = 1.5
"""Pieces as high as this above the floor hide others, metres."""
WIDE = 0.8
"""So do only those as wide as this, metres: one looks past a plant."""
CLEAR = 0.6
"""How opaque what hides others is drawn."""
WALL, HUNG = "partition", "wall_exhibit"
BEHIND = 0.02
"""Metres from a picture within which a partition is the wall it hangs on."""

OVER, BEFORE = 1.2, 0.25
"""What hangs as high as this over the floor and is as deep as this, metres, hides things
below it, unless its front is turned to the eye."""
SIDEWAYS = 0.6
"""Cosine of the angle in plan between a front and the way to the eye, above which one sees below
what hangs there."""


SHARE, FLOOR = 0.8, 1.0
"""The share of its floor over which a thing is hidden, and its least area in m², to count: an
exhibit, a bed, a sofa or a bath all but gone. A wall or a wardrobe of glass looks wrong at first
glance, so no lesser thing is worth one; what is hidden by its like is not either, as nobody misses
the next rail of a row."""


def find_hiding(pieces: Sequence[Piece], towards: tuple[float, float, float]) -> frozenset[str]:
    """The ids of the tall pieces of a level that hide others for an eye looking ``towards`` a
    direction; what looks straight down or up hides nothing.

    >>> from scenewright.core.scene import Pose, Size
    >>> def piece(name, kind, y, height):
    ...     pose, size = Pose(0.0, y, 0.0, 0.0), Size(1.2, 1.0, height)
    ...     return Piece(name, kind, "", "a", pose, size)
    >>> two = [piece("high", "wardrobe", 0.0, 2.2), piece("low", "bed", 0.9, 0.5)]
    >>> sorted(find_hiding(two, (0.0, 0.7, -0.7))), find_hiding(two, (0.0, -0.7, -0.7))
    (['high'], frozenset())
    """
    flat = float(np.hypot(*towards[:2]))
    if flat < 1e-6 or towards[2] > -1e-6:
        return frozenset()
    standing = [p for p in pieces if p.pose.z < TALL and p.on is None]
    outlines = np.array(polygons_of(tuple(standing)), object)
    foot = np.array([p.pose.z for p in standing])
    height = np.array([p.size.height for p in standing])
    wide = np.array([p.size.width >= WIDE for p in standing], bool)
    names = np.array([p.category for p in standing], str)
    bare = [p.category != WALL or not _carries(p, pieces, towards) for p in standing]
    high = np.flatnonzero(wide & (foot + height >= TALL) & np.array(bare, bool))
    low = np.flatnonzero((names != WALL) & (shapely.area(outlines) >= FLOOR))
    lean = np.array(towards[:2]) / -towards[2]
    seen = _Standing(outlines, foot + height, foot + height / 2, names)
    return frozenset(standing[k].id for k in _pair_hidden(seen, high, low, lean))


def _carries(wall: Piece, pieces: Sequence[Piece], towards: tuple[float, float, float]) -> bool:
    """Whether pictures that face an eye looking ``towards`` a direction hang on a partition: on one
    of glass they would float."""
    outline = polygons_of((wall,))[0].buffer(BEHIND)
    return any(
        p.category == HUNG
        and towards[0] * np.cos(p.pose.heading) + towards[1] * np.sin(p.pose.heading) < 0.0
        and outline.intersects(polygons_of((p,))[0])
        for p in pieces
    )


def find_hanging_over(
    pieces: Sequence[Piece], towards: tuple[float, float, float]
) -> frozenset[str]:
    """The ids of the cabinets and hoods that hang over a worktop and are seen from above only, by
    an eye that looks ``towards`` a direction: on walls that run along the view or stand before it.
    They are left out of pictures, so that the worktop is seen.

    >>> from scenewright.core.scene import Pose, Size
    >>> def piece(name, heading):
    ...     pose, size = Pose(0.0, 0.0, 1.4, heading), Size(0.6, 0.35, 0.7)
    ...     return Piece(name, "wall_cabinet", "", "a", pose, size)
    >>> three = [piece("east", 0.0), piece("south", -np.pi / 2), piece("north", np.pi / 2)]
    >>> sorted(find_hanging_over(three, (0.0, 0.42, -1.0)))
    ['east', 'north']
    """
    flat = float(np.hypot(*towards[:2]))
    if flat < 1e-6:
        return frozenset()
    x, y = -towards[0] / flat, -towards[1] / flat
    return frozenset(
        p.id
        for p in pieces
        if p.pose.z >= OVER
        and p.on is None
        and p.size.depth >= BEFORE
        and x * np.cos(p.pose.heading) + y * np.sin(p.pose.heading) < SIDEWAYS
    )


class _Standing(NamedTuple):
    """Footprints (n,), their tops and middles (n,) above the floor, metres, and categories (n,)."""

    outlines: NDArray[np.object_]
    tops: Floats
    middles: Floats
    names: NDArray[np.str_]


def _pair_hidden(things: _Standing, high: Indices, low: Indices, lean: Floats) -> Indices:
    """Those of ``high`` that hide any of ``low``, their like apart: candidates meet the shadow that
    falls on the lowest middle there is, and are hidden where :data:`SHARE` of them lies in the
    shadow at their own."""
    if not len(high) or not len(low):
        return high[:0]
    deepest = np.maximum(things.tops[high] - things.middles[low].min(), 0.0)
    reach = _sweep(things.outlines[high], deepest[:, None] * lean)
    first, second = shapely.STRtree(things.outlines[low]).query(reach, "intersects")
    tall, other = high[first], low[second]
    rise = things.tops[tall] - things.middles[other]
    behind = (rise > 0) & (things.names[tall] != things.names[other])
    tall, other, rise = tall[behind], other[behind], rise[behind]
    shadows = _sweep(things.outlines[tall], rise[:, None] * lean)
    hidden = shapely.area(shapely.intersection(shadows, things.outlines[other]))
    return np.unique(tall[hidden >= SHARE * shapely.area(things.outlines[other])])


def _sweep(outlines: NDArray[np.object_], steps: Floats) -> NDArray[np.object_]:
    """Per outline (p,) the hull of it and of the same moved by its step (p, 2), metres."""
    corners, owner = shapely.get_coordinates(outlines, return_index=True)
    both = np.vstack([corners, corners + steps[owner]])
    order = np.argsort(np.tile(owner, 2), kind="stable")
    hulls = shapely.multipoints(both[order], indices=np.tile(owner, 2)[order])
    return np.asarray(shapely.convex_hull(hulls), object)


def make_clear(parts: tuple[Part, ...], opacity: float = CLEAR) -> tuple[Part, ...]:
    """Parts as if of glass, in their colours."""
    return tuple(replace(part, material=_clear(part.material, opacity)) for part in parts)


def _clear(material: Material, opacity: float) -> Material:
    opacity = min(material.opacity, opacity)
    return replace(material, name=f"{material.name}, seen through", opacity=opacity)
