"""What floors and walls are of in a region: rows that replace the usual finishes of homes.

A region is asked for by a word of the ``style`` (``mediterranean``, ``boho greek``); furniture and
colours stay those of the style. Facades and roofs are the looks of villages.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from scenewright.building.finishes import PLASTER, STONE_FLOOR, TILE_FLOOR, WOOD_FLOOR
from scenewright.core.catalog import Material


class Region(NamedTuple):
    """The ``words`` that ask for a region, and what its homes have in place of the oak of rooms to
    live and sleep in, the stone of kitchens and halls, the tiles of bathrooms, and plaster."""

    words: str
    rooms: Material
    kitchens: Material
    baths: Material
    walls: Material = PLASTER

    @property
    def finishes(self) -> Mapping[Material, Material]:
        """Which material replaces which."""
        usual = (WOOD_FLOOR, STONE_FLOOR, TILE_FLOOR, PLASTER)
        return {old: new for old, new in zip(usual, self[1:], strict=True) if old != new}


_TERRACOTTA = Material("terracotta floor", (0.66, 0.48, 0.38), 0.7)
_SLATE = Material("slate floor", (0.36, 0.37, 0.38), 0.55)
_HONED = Material("limestone floor", (0.79, 0.76, 0.70), 0.45)
_MOSAIC = Material("mosaic floor", (0.70, 0.74, 0.74), 0.3)
_CEDAR = Material("cedar floor", (0.55, 0.44, 0.35), 0.5)

REGIONS: dict[str, Region] = {
    "northern": Region(
        "baltic finnish swedish norwegian danish",
        Material("pine floor", (0.86, 0.78, 0.64), 0.6),
        _SLATE,
        _SLATE,
    ),
    "mediterranean": Region(
        "italian spanish greek portuguese provencal andalusian",
        _TERRACOTTA,
        _HONED,
        _MOSAIC,
        Material("lime wash", (0.95, 0.92, 0.85), 0.95),
    ),
    "japanese": Region(
        "tatami washitsu",
        Material("tatami floor", (0.74, 0.69, 0.55), 0.9),
        _CEDAR,
        Material("hinoki floor", (0.80, 0.71, 0.57), 0.5),
        Material("clay wall", (0.87, 0.82, 0.73), 0.95),
    ),
    "american": Region(
        "colonial californian texan", Material("hickory floor", (0.55, 0.38, 0.25), 0.45),
        Material("penny tile floor", (0.86, 0.85, 0.82), 0.3), _MOSAIC,
    ),
    "british": Region(
        "victorian georgian scottish",
        Material("carpet floor", (0.66, 0.60, 0.52), 1.0),
        Material("quarry tile floor", (0.55, 0.38, 0.32), 0.6),
        TILE_FLOOR,
    ),
    "alpine": Region(
        "chalet swiss tyrolean bavarian",
        Material("larch floor", (0.72, 0.52, 0.35), 0.55),
        _SLATE,
        _HONED,
        Material("larch wall", (0.78, 0.60, 0.42), 0.7),
    ),
}  # fmt: skip
"""The regions, by name."""


def region_of(words: str) -> str:
    """The region some words ask for; empty if none.

    >>> region_of("boho, Greek"), region_of("nordic fjord")
    ('mediterranean', '')
    """
    asked = set(words.casefold().replace(",", " ").replace("/", " ").split())
    return next((k for k, row in REGIONS.items() if asked & {k, *row.words.split()}), "")
