"""From meshes and materials to the parts of an asset."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeVar

import numpy as np

from scenewright.catalog.assets.bodies import assign_bodies
from scenewright.core.catalog import Material, Part
from scenewright.core.scene import Size
from scenewright.geometry.joints import Joint, transform_joint
from scenewright.geometry.mesh import Mesh, map_points, merge

Choice = TypeVar("Choice")
Parts = tuple[Part, ...]
Meshes = Mapping[Material, Sequence[Mesh]]


def parts(size: Size, meshes: Meshes) -> Parts:
    """One part a material and body, taken affinely into exactly
    ``[-w/2, w/2] x [-d/2, d/2] x [0, h]``; bodies as their meshes declare them."""
    each = [(material, mesh) for material, found in meshes.items() for mesh in found]
    joints = assign_bodies([mesh for _, mesh in each])
    groups: dict[tuple[Material, Joint | None], list[Mesh]] = {}
    for (material, mesh), joint in zip(each, joints, strict=True):
        groups.setdefault((material, joint), []).append(mesh)
    merged = {key: merge(found) for key, found in groups.items()}
    points = np.concatenate([mesh.vertices for mesh in merged.values()])
    source = (points.min(0), points.max(0))
    high = np.array([size.width / 2, size.depth / 2, size.height])
    low = np.array([-size.width / 2, -size.depth / 2, 0.0])
    scale = (high - low) / np.maximum(source[1] - source[0], 1e-12)
    shift = low - scale * source[0]
    return tuple(
        Part(
            material,
            map_points(mesh.vertices, source, low, high),
            mesh.faces,
            joint and transform_joint(joint, np.diag(scale), shift),
        )
        for (material, joint), mesh in merged.items()
    )


def pick(size: Size, choices: Sequence[Choice]) -> Choice:
    """One of several looks, always the same for the same size to the centimetre.

    >>> pick(Size(1.6, 2.05, 0.95), "abc") == pick(Size(1.6, 2.05, 0.95), "abc")
    True
    """
    width, depth, height = (round(100 * v) for v in size)
    return choices[(7 * width + 3 * depth + 5 * height) // 5 % len(choices)]
