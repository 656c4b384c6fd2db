"""A small picture of a model from above at an angle, without perspective: quick, for sheets."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from scenewright.core.catalog import Part
from scenewright.geometry import rays
from scenewright.geometry.mesh import Mesh, merge
from scenewright.render.picture import Pixels

TOWARDS = np.array([0.55, 0.75, -0.5]) / np.linalg.norm([0.55, 0.75, -0.5])
SUN = np.array([-0.25, -0.75, 0.6]) / np.linalg.norm([-0.25, -0.75, 0.6])
PAPER = 244
AMBIENT = 0.45


def draw_thumbnail(parts: Sequence[Part], side: int = 128) -> Pixels:
    """A model as pixels ``(side, side, 3)`` on plain paper.

    >>> from scenewright.core.catalog import Material
    >>> from scenewright.geometry.solids import block
    >>> cube = Part(Material("red", (1.0, 0.0, 0.0)), *block((0, 1), (0, 1), (0, 1)))
    >>> draw_thumbnail([cube], 32).shape
    (32, 32, 3)
    """
    mesh = merge([Mesh(part.vertices, part.faces) for part in parts])
    colours = np.array([part.material.color for part in parts])
    owner = np.repeat(np.arange(len(parts)), [len(part.faces) for part in parts])
    right = np.cross(TOWARDS, (0.0, 0.0, 1.0))
    right = right / np.linalg.norm(right)
    up = np.cross(right, TOWARDS)
    middle = (mesh.vertices.min(0) + mesh.vertices.max(0)) / 2
    flat = (mesh.vertices - middle) @ np.stack([right, up]).T
    centre = (flat.min(0) + flat.max(0)) / 2
    half = 0.54 * float(max(np.ptp(flat, axis=0).max(), 1e-6))
    steps = (np.arange(side) + 0.5) / side * 2 - 1
    x, y = np.meshgrid(centre[0] + half * steps, centre[1] - half * steps)
    far = 4 * half + float(np.linalg.norm(np.ptp(mesh.vertices, axis=0)))
    start = middle + x[..., None] * right + y[..., None] * up - far * TOWARDS
    ways = np.broadcast_to(TOWARDS, start.shape).reshape(-1, 3)
    caster = rays.build(mesh.vertices, mesh.faces)
    distance, face, normal = rays.hits(caster, start.reshape(-1, 3), ways)
    facing = np.where((normal @ TOWARDS) > 0, -1.0, 1.0)
    light = AMBIENT + (1 - AMBIENT) * np.maximum((normal @ SUN) * facing, 0.0)
    page = np.full((side * side, 3), PAPER, np.uint8)
    met = np.isfinite(distance)
    shaded = colours[owner[face[met]]] * light[met, None]
    page[met] = np.clip(255 * shaded, 0, 255).astype(np.uint8)
    return page.reshape(side, side, 3)
