"""How high openings reach under their ceilings, and windows that lie in a slope.

A window whose sill is at least as high as the knee wall it is listed at lies in the slope above
it, its ``height`` measured along the slope, as makers state it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from scenewright.building.ceiling import SHOULDERS, heights, planes
from scenewright.core.brief import Door, Window
from scenewright.core.errors import InputError
from scenewright.core.space import Opening, Points, Slope, Space

ON = 0.02
"""How near to a slope's wall a window lies that may be in the slope, in metres."""
LEVEL = 0.01
LEAST = 0.5
"""The share of a window's height that its ceiling must leave."""

Heads = tuple[float, tuple[float, float] | None]


def heads_of(space: Space, start: Points, end: Points, wish: Door | Window) -> Heads:
    """The height of an opening's head and, of a window in a slope, how far inwards its lower and
    upper edges lie; ``start`` and ``end`` (2,) are its ends on the wall's inner face."""
    sill = wish.sill if isinstance(wish, Window) else 0.0
    if isinstance(wish, Window) and space.slopes:
        for slope, row in zip(space.slopes, planes(space), strict=True):
            off = (np.stack([start, end]) - row[:2]) @ row[2:4]
            if np.abs(off).max() < ON and sill >= slope.knee - 1e-9:
                return _in_slope(space, slope, (start + end) / 2, row[2:4], wish)
    over = float(heights(np.stack([start, end]), planes(space), space.height).min())
    head = _cut_to(over, sill, sill + wish.height)
    if space.slopes:
        _check_cut(wish, sill, head)
    return head, None


def under_other(opening: Opening, other: Space, wish: Door | Window) -> Opening:
    """An opening that ends below the slopes of the room it leads to, too."""
    if not other.slopes or other.id == opening.spaces[0]:
        return opening
    along = np.array([opening.ux, opening.uy])
    face = opening.thickness / 2 * np.array([along[1], -along[0]]) + (opening.x, opening.y)
    ends = face + np.array([[-0.5], [0.5]]) * opening.width * along
    over = float(heights(ends, planes(other), other.height).min())
    head = _cut_to(over, opening.sill, opening.head)
    if head < opening.head:
        _check_cut(wish, opening.sill, head)
    return replace(opening, head=head)


def _cut_to(over: float, sill: float, head: float) -> float:
    """The head of an opening under a ceiling."""
    if sill >= over:
        raise InputError(
            f"its sill is at {sill:g} m, above the ceiling at {over:g} m", "lower the sill"
        )
    return min(head, over)


def _check_cut(wish: Door | Window, sill: float, head: float) -> None:
    """InputError if a slope leaves too little of an opening."""
    if isinstance(wish, Door) and head < min(SHOULDERS, wish.height):
        raise InputError(
            f"the slope over it is only {head:.2f} m high", "put it where the ceiling is higher"
        )
    if isinstance(wish, Window) and head - sill < LEAST * wish.height - 1e-9:
        raise InputError(
            f"the slope leaves only {head - sill:.2f} m of its height",
            f"lower it, or raise its sill to {head:.2f} m to have it in the slope",
        )


def _in_slope(space: Space, slope: Slope, middle: Points, inward: Points, wish: Window) -> Heads:
    """A window in one slope, all of it."""
    near = (wish.sill - slope.knee) / np.tan(slope.pitch)
    far, head = (
        near + wish.height * np.cos(slope.pitch),
        wish.sill + wish.height * np.sin(slope.pitch),
    )
    ends = middle + np.array([[near], [far]]) * inward
    if np.abs(heights(ends, planes(space), space.height) - (wish.sill, head)).max() > LEVEL:
        raise InputError(
            f"in the slope it would reach from {wish.sill:.2f} m to {head:.2f} m of height, "
            "beyond the slope",
            "make it lower, or change its sill",
        )
    return float(head), (float(near), float(far))
