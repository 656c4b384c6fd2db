"""Things round a corner: a leg along the back, a wing to the front on the left, and the nook."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.symbols import Line, Lines, close_line
from scenewright.core.catalog import Covering, Part, transform_part
from scenewright.core.footprint import Footprint, read_footprint
from scenewright.core.scene import Size

FLIP = np.diag([-1.0, 1.0, 1.0])
"""Left and right changed over."""
Outline = list[tuple[float, float]]
Parts = tuple[Part, ...]


def corner_outline(size: Size, leg: float, wing: float) -> Outline:
    """Corners of an L that fills a box, counter-clockwise from back left: ``leg`` is the depth
    of the arm along the back, ``wing`` the width of that on the left, metres.

    >>> corner_outline(Size(2.0, 2.0, 1.0), 0.5, 0.75)[2:5]
    [(1.0, -0.5), (-0.25, -0.5), (-0.25, 1.0)]
    """
    w, d = size.width / 2, size.depth / 2
    front, edge = -d + leg, -w + wing
    return [(-w, -d), (w, -d), (w, front), (edge, front), (edge, d), (-w, d)]


def turn_about(outline: Outline) -> Outline:
    """The same turned by half a turn: the leg along the front, the wing on the right.

    >>> turn_about([(1.0, -2.0)])
    [(-1.0, 2.0)]
    """
    return [(-x, -y) for x, y in outline]


def mirror_drawing(row: Drawing) -> Drawing:
    """The same model with left and right changed over, under an id and a name of its own."""
    model = row.id or row.category
    asset = model.replace(row.category, f"{row.category}_right", 1)
    name = row.name or row.category.replace("_", " ").capitalize()

    def mesh(size: Size) -> Parts:
        return tuple(transform_part(part, FLIP) for part in row.mesh(size))

    def symbol(size: Size) -> Lines:
        return tuple(line * (-1.0, 1.0) for line in row.symbol(size))

    def outline(size: Size) -> Outline:
        return [(-x, y) for x, y in reversed(row.footprint(size))]

    name = f"{name}, other way round"
    return row._replace(id=asset, name=name, mesh=mesh, symbol=symbol, footprint=cover(outline))


def cover(outline: Callable[[Size], Outline]) -> Covering:
    """What a thing of an outline covers at each size."""

    def covering(size: Size) -> Footprint:
        return read_footprint(outline(size), size.width, size.depth)

    return covering


def draw_border(outline: Outline) -> Line:
    """The outline as a closed line of a symbol."""
    return close_line(outline)
