"""The shipped catalog: parametric furniture of our own, found by category and size.

One file a theme. A new piece is a mesh function, a symbol function and a row in a theme's
``ASSETS``, with its row in :mod:`.kinds` and its range in :mod:`.sizes`.
"""

from __future__ import annotations

from functools import cache
from importlib import import_module

from scenewright.assets.kinds import KINDS
from scenewright.catalog import Asset, Catalog

_THEMES = (
    "seating", "tables", "beds", "storage", "shelves", "kitchen", "cooking", "sanitary",
    "appliances", "lighting", "textiles", "decor", "greenery", "outdoor", "building", "leisure",
    "exhibition", "islands", "gondolas", "shop", "reading", "auditorium", "reception",
    "eastern", "sacred", "civic", "houses", "towers", "works", "site_green",
)  # fmt: skip


def rows() -> tuple[Asset, ...]:
    """Every asset, theme by theme."""
    found: list[Asset] = []
    for theme in _THEMES:
        found += import_module(f"scenewright.assets.{theme}").ASSETS
    return tuple(found)


@cache
def shipped() -> Catalog:
    """Every shipped kind and asset.

    >>> from scenewright.scene import Size
    >>> shipped().choose("sofa", Size(2.0, 0.9, 0.8)).name
    'Sofa'
    """
    return Catalog(KINDS, {row.id: row for row in rows()})
