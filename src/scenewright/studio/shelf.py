"""The shelf: what can be put on a floor, by pictures."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from io import BytesIO

import numpy as np
from PIL import Image

from scenewright.catalog.loading import catalog_of, find_asset
from scenewright.core.brief import Brief
from scenewright.core.catalog import transform_part
from scenewright.render.thumbnail import draw_thumbnail
from scenewright.studio.shapes import Json

TURNED = np.diag([-1.0, -1.0, 1.0])
"""Fronts look to the viewer."""
SIDE = 96
"""Pixels across a picture."""


def list_shelf(brief: Brief) -> list[Json]:
    """The models of a brief's catalog that stand on a floor, by kind and name."""
    catalog = catalog_of(brief.catalogs)
    rows = [
        {
            "asset": asset.id,
            "name": asset.name,
            "category": asset.category,
            "kind": catalog.kinds[asset.category].name,
            "size": [round(float(side), 2) for side in asset.usual],
        }
        for asset in catalog.assets.values()
        if asset.category in catalog.kinds and catalog.kinds[asset.category].support == "floor"
    ]
    return sorted(rows, key=lambda row: (row["kind"], row["name"]))


def find_models(rows: Sequence[Json], words: str) -> list[Json]:
    """The rows of a shelf whose kind or name holds every word.

    >>> find_models([{"kind": "sofa", "name": "Corner"}, {"kind": "desk", "name": "Oak"}], "corner")
    [{'kind': 'sofa', 'name': 'Corner'}]
    """
    wanted = words.lower().split()
    return [
        row
        for row in rows
        if all(word in f"{row['kind']} {row['name']}".lower() for word in wanted)
    ]


@lru_cache(maxsize=1024)
def _draw(catalogs: tuple[str, ...], name: str) -> bytes:
    asset = find_asset(catalog_of(catalogs), name)
    kept = BytesIO()
    parts = [transform_part(part, TURNED) for part in asset.mesh(asset.usual)]
    pixels = draw_thumbnail(parts, SIDE)
    Image.fromarray(pixels).quantize(64).save(kept, "PNG", optimize=True)
    return kept.getvalue()


def draw_shelf(brief: Brief, name: str) -> bytes:
    """The picture of a model, as PNG."""
    return _draw(tuple(map(str, brief.catalogs)), name)
