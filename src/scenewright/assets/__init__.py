"""The shipped catalog: parametric furniture of our own, found by category and size."""

from __future__ import annotations

from functools import cache
from importlib import import_module

from scenewright.assets.kinds import KINDS
from scenewright.assets.materials import GREY
from scenewright.assets.model import asset, parts
from scenewright.assets.sizes import SIZES
from scenewright.assets.symbols import plain
from scenewright.catalog import Asset, Catalog, Part
from scenewright.geometry.solids import block
from scenewright.scene import Size

_THEMES = (
    "seating", "tables", "beds", "storage", "shelves", "kitchen", "sanitary", "appliances",
    "lighting", "decor", "outdoor", "building",
)  # fmt: skip


@cache
def shipped() -> Catalog:
    """Every shipped kind and asset.

    >>> shipped().choose("sofa", Size(2.0, 0.9, 0.8)).name
    'Sofa'
    """
    rows: list[Asset] = []
    for theme in _THEMES:
        try:
            rows += import_module(f"scenewright.assets.{theme}").ASSETS
        except ModuleNotFoundError:
            continue
    have = {row.category for row in rows}
    rows += [asset(name, _plain, plain) for name in SIZES if name not in have]
    return Catalog(KINDS, {row.id: row for row in rows})


def _plain(size: Size) -> tuple[Part, ...]:
    w, d, h = size
    return parts(size, {GREY: [block((-w / 2, w / 2), (-d / 2, d / 2), (0, h))]})
