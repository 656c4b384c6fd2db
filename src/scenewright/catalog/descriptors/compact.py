"""Our descriptor: upright harmonics, extents, height profile, normals and colour, each by its
weight.

Things stand upright and have a size: what the paper's descriptor throws away tells most. Turning
about the vertical changes nothing: of each harmonic coefficient only the amount counts.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Part
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.spherical import farthest_hits, harmonics

Floats = NDArray[np.float64]
GRID, DEGREES = 48, 8
SLICES, BANDS = 8, 6
WEIGHTS = {"shape": 0.7, "extent": 0.6, "profile": 0.9, "normals": 1.0, "colour": 0.65}
"""How much each part counts in distances; chosen on the classes of ``bench extend_features``."""


def compact_descriptor(parts: Sequence[Part]) -> Floats:
    """The descriptor (59,) of a model whose z is up, in metres or any unit that its set shares."""
    mesh = merge([Mesh(part.vertices, part.faces) for part in parts])
    found = {
        "shape": _upright_shape(mesh),
        "extent": _extents(mesh),
        "profile": _profile(mesh),
        "normals": _normals(mesh),
        "colour": _colour(parts),
    }
    return np.concatenate([WEIGHTS[name] * found[name] for name in WEIGHTS])


def _upright_shape(mesh: Mesh) -> Floats:
    """Amounts of the harmonics of the farthest hits from the middle of the box, scaled."""
    low, high = mesh.vertices.min(0), mesh.vertices.max(0)
    reach = farthest_hits(mesh, (low + high) / 2, GRID)
    scaled = reach / max(float(np.sqrt((reach**2).mean())), 1e-12)
    found = np.abs(harmonics(scaled, DEGREES))
    return np.asarray(found[np.tril_indices(DEGREES)])


def _extents(mesh: Mesh) -> Floats:
    """Logarithms of height, long and short side, and of their ratios."""
    size = np.maximum(np.ptp(mesh.vertices, axis=0), 1e-3)
    long, short = max(size[:2]), min(size[:2])
    logs = np.log([size[2], long, short])
    return np.asarray(np.concatenate([logs * 0.6, [logs[0] - logs[1], logs[1] - logs[2]]]))


def _areas(mesh: Mesh) -> tuple[Floats, Floats, Floats]:
    corners = mesh.vertices[mesh.faces]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(cross, axis=1) / 2
    return corners, area, cross / np.maximum(2 * area, 1e-12)[:, None]


def _profile(mesh: Mesh) -> Floats:
    """The share of the surface in each slice of the height, and how wide it is there."""
    corners, area, _ = _areas(mesh)
    low, high = mesh.vertices[:, 2].min(), mesh.vertices[:, 2].max()
    middle = (corners[..., 2].mean(1) - low) / max(high - low, 1e-9)
    row = np.clip((middle * SLICES).astype(int), 0, SLICES - 1)
    share = np.bincount(row, area, SLICES) / max(float(area.sum()), 1e-12)
    return np.asarray(np.sqrt(share))


def _normals(mesh: Mesh) -> Floats:
    """The share of the surface by how far it looks up."""
    _, area, normal = _areas(mesh)
    row = np.clip(((normal[:, 2] + 1) / 2 * BANDS).astype(int), 0, BANDS - 1)
    share = np.bincount(row, area, BANDS) / max(float(area.sum()), 1e-12)
    return np.asarray(np.sqrt(share))


def _colour(parts: Sequence[Part]) -> Floats:
    """Mean lightness and the two opponent colours, by area."""
    total, sums = 1e-12, np.zeros(4)
    for part in parts:
        area = float(_areas(Mesh(part.vertices, part.faces))[1].sum())
        red, green, blue = part.material.color
        light = 0.3 * red + 0.59 * green + 0.11 * blue
        sums += area * np.array(
            [light, red - green, (red + green) / 2 - blue, part.material.opacity]
        )
        total += area
    return np.asarray(sums / total)
