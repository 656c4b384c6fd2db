"""Buildings as walkers are shown them: boxes with what each side of their models is worth."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.appearance import PLAIN, facts, qualities
from scenewright.core.catalog import Catalog, asset_of
from scenewright.core.scene import Piece

Floats = NDArray[np.float64]


class BuildingQuality(NamedTuple):
    """``boxes`` (n, 5), ``heights`` (n,) and ``sides`` (n, 5), the visual quality of front, left,
    back, right and roof, as :mod:`scenewright.geometry.walker` takes them."""

    boxes: Floats
    heights: list[float]
    sides: Floats


def collect_building_quality(buildings: Sequence[Piece], catalog: Catalog) -> BuildingQuality:
    """What some buildings show; one without a model is plain."""
    assets = [asset_of(piece, catalog) for piece in buildings]
    known = facts(asset for asset in assets if asset is not None)
    looks = [known[asset.id] if asset is not None else PLAIN for asset in assets]
    boxes = [(*p.pose[:2], p.pose.heading, p.size.width, p.size.depth) for p in buildings]
    heights = [piece.size.height for piece in buildings]
    return BuildingQuality(np.array(boxes, float).reshape(-1, 5), heights, qualities(looks)[1])
