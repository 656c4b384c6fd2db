"""The pieces of trees and lamps."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from scenewright.core.catalog import Asset
from scenewright.core.scene import Piece, Pose, Size


def tree_piece(
    name: str, space: str, asset: Asset, at: Sequence[float], scale: float, rng: np.random.Generator
) -> Piece:
    """A tree at a point, a ``scale`` of its usual size, turned by chance."""
    return Piece(
        id=name,
        category="tree",
        asset=asset.id,
        space=space,
        pose=Pose(float(at[0]), float(at[1]), 0.0, float(rng.uniform(-math.pi, math.pi))),
        size=Size(*(side * scale for side in asset.usual)),
        group=f"{space}/green",
        function="tree",
    )


def lamp_piece(name: str, space: str, asset: Asset, at: Sequence[float]) -> Piece:
    """A street lamp at x, y with its heading, along which its arm reaches."""
    return Piece(
        id=name,
        category="lamp_post",
        asset=asset.id,
        space=space,
        pose=Pose(float(at[0]), float(at[1]), 0.0, float(at[2])),
        size=asset.usual,
        group=f"{space}/green",
        function="lamp",
    )
