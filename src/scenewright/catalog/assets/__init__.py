"""The shipped catalog: parametric furniture of our own, found by category and size.

One family a theme: a text of declared parts (:mod:`scenewright.catalog.assets.declared`), a module
with what is grown by loops and its table ``ASSETS``, or both. Which of them draw a kind is stated
in its row (:mod:`scenewright.catalog.kinds`).
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from importlib import import_module
from importlib.util import resolve_name

from scenewright.catalog.assets.drawing import asset_of
from scenewright.core.catalog import Asset, Catalog
from scenewright.core.kind import Kind


def assets_of(kind: Kind) -> Iterator[Asset]:
    """The assets that draw a kind, in the order of its modules and their tables.

    >>> from scenewright.catalog.kinds import KINDS
    >>> [asset.id for asset in assets_of(KINDS["wardrobe"])][:3]
    ['wardrobe', 'wardrobe_sliding', 'wardrobe_shallow']
    """
    declared = import_module(".declared", __name__)  # the referee reads kinds, but no meshes
    for module in kind.drawn_by:
        for drawing in declared.drawings_of(resolve_name(module, __name__)):
            if drawing.category == kind.category:
                yield asset_of(drawing, kind)


@cache
def shipped() -> Catalog:
    """Every kind there is a row of, and every asset that draws one.

    >>> from scenewright.core.scene import Size
    >>> shipped().choose("sofa", Size(2.0, 0.9, 0.8)).name
    'Sofa'
    """
    from scenewright.catalog.kinds import KINDS  # its rows may be in a module that also draws them

    assets = (asset for kind in KINDS.values() for asset in assets_of(kind))
    return Catalog(KINDS, {asset.id: asset for asset in assets})
