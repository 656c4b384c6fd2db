"""Bathroom fittings: toilet, basins, bath, showers, mirror, towel rail."""

from __future__ import annotations

from scenewright.geometry.mesh import Mesh


def _lid_below(lid: Mesh, h: float) -> Mesh:
    """The raised lid, no higher than just under the top of the cistern."""
    low, high = lid.vertices[:, 2].min(), lid.vertices[:, 2].max()
    scale = min(1.0, (h - 0.03 - low) / (high - low))
    vertices = lid.vertices.copy()
    vertices[:, 2] = low + (vertices[:, 2] - low) * scale
    return Mesh(vertices, lid.faces)
