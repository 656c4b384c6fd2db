"""Colours of like buildings: every house of a street a little different, the same each time.

Only what people paint or burn themselves varies: render, brick, tiles, timber. Landmarks and
models from files keep their own colours.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from zlib import crc32

from scenewright.catalog.assets.materials import BRICK, LIMESTONE, RENDER, TILES, TILES_DARK, TIMBER
from scenewright.core.catalog import Material, Part

Colour = tuple[float, float, float]


def _shades(material: Material, *colours: Colour) -> tuple[Material, ...]:
    rest = (material.roughness, material.metallic, material.opacity, material.emission)
    return material, *(
        Material(f"{material.name} {number}", colour, *rest)
        for number, colour in enumerate(colours, 2)
    )


TINTS: dict[Material, tuple[Material, ...]] = {
    RENDER: _shades(RENDER, (0.89, 0.83, 0.71), (0.82, 0.81, 0.78), (0.88, 0.77, 0.69)),
    BRICK: _shades(BRICK, (0.50, 0.31, 0.25), (0.65, 0.45, 0.34), (0.54, 0.40, 0.34)),
    TILES: _shades(TILES, (0.55, 0.32, 0.25), (0.67, 0.40, 0.28), (0.50, 0.34, 0.29)),
    TILES_DARK: _shades(TILES_DARK, (0.34, 0.31, 0.30), (0.27, 0.30, 0.32), (0.36, 0.35, 0.36)),
    TIMBER: _shades(TIMBER, (0.24, 0.31, 0.28), (0.40, 0.20, 0.17), (0.22, 0.27, 0.36)),
    LIMESTONE: _shades(LIMESTONE, (0.78, 0.72, 0.62), (0.84, 0.80, 0.73), (0.77, 0.73, 0.68)),
}
"""The colours a material may take instead of its own, which comes first."""
COUNT = 4


def tint_of(identity: str, parts: Sequence[Part]) -> int:
    """The row of colours of one building by its id; 0 if none of its materials varies.

    >>> tint_of("site/villa_3", ())
    0
    """
    varies = any(part.material in TINTS for part in parts)
    return crc32(identity.encode()) % COUNT if varies else 0


def apply_tint(parts: tuple[Part, ...], tint: int) -> tuple[Part, ...]:
    """Parts in the colours of a row."""
    if not tint:
        return parts
    return tuple(
        replace(part, material=TINTS[part.material][tint]) if part.material in TINTS else part
        for part in parts
    )
