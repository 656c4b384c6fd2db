"""Small things of kitchens and tables: plates, mugs, glasses, bottles, jars, pans, boards."""

from __future__ import annotations

from collections.abc import Callable

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.model import Parts
from scenewright.catalog.assets.symbols import plain
from scenewright.core.catalog import Material, Mesher, Symbol
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import lathe

Coloured = Callable[[Size, Material], Parts]


def in_colours(
    category: str, drawn: Coloured, colours: tuple[Material, ...], symbol: Symbol = plain
) -> tuple[Drawing, ...]:
    """A drawing of one kind in each of some materials; all but the first have their number."""

    def one(material: Material) -> Mesher:
        return lambda size: drawn(size, material)

    return tuple(
        Drawing(category, one(colour), symbol, f"{category}_{k}" if k else "")
        for k, colour in enumerate(colours)
    )


def vessel_wall(
    size: Size, shape: list[tuple[float, float]], thick: float, sides: int = 14
) -> Mesh:
    """A hollow vessel: a profile of shares of half the width and of the height, turned, with a
    wall ``thick`` metres thick and a floor as thick again."""
    radius, h = min(size.width, size.depth) / 2, size.height
    outer = [(r * radius, z * h) for r, z in shape]
    inner = [(max(r - thick, 0.001), max(z, 2 * thick)) for r, z in reversed(outer)]
    return lathe([*outer, *inner], sides=sides)
