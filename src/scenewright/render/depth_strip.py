"""A model beside its light field: the ten depth maps from the corners of a dodecahedron above."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from scenewright.catalog.descriptors.depth_maps import depth_maps, light_field_ways
from scenewright.core.catalog import Part
from scenewright.geometry.mesh import Mesh, merge
from scenewright.render.picture import Pixels
from scenewright.render.thumbnail import PAPER, draw_thumbnail

NEAR, FAR = 40, 225
"""Grey of what is nearest and farthest."""
ROWS = 2


def draw_depth_strip(parts: Sequence[Part], side: int = 128) -> Pixels:
    """The picture of a model and, to its right, two rows of five depth maps, the highest views
    first: dark is near, paper is nothing.

    >>> from scenewright.core.catalog import Material
    >>> from scenewright.geometry.solids import block
    >>> cube = Part(Material("red", (1.0, 0.0, 0.0)), *block((0, 1), (0, 1), (0, 1)))
    >>> draw_depth_strip([cube], 32).shape
    (32, 112, 3)
    """
    mesh = merge([Mesh(part.vertices, part.faces) for part in parts])
    small = side // ROWS
    maps = depth_maps(mesh, light_field_ways(), small, stretched=False)[:, ::-1]
    grey = np.where(np.isfinite(maps), NEAR + (FAR - NEAR) * np.minimum(maps, 1.0), PAPER)
    rows = [np.concatenate(list(part), axis=1) for part in np.split(grey.astype(np.uint8), ROWS)]
    field = np.repeat(np.concatenate(rows)[..., None], 3, axis=2)
    return np.concatenate([draw_thumbnail(parts, side), field], axis=1)
