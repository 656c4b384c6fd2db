"""Instances of a node's mesh (EXT_mesh_gpu_instancing): one place each."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.models.gltf_accessors import Store, floats
from scenewright.catalog.models.gltf_record import GltfNode
from scenewright.core.errors import InputError

Floats = NDArray[np.float64]
INSTANCING = "EXT_mesh_gpu_instancing"
MOST_INSTANCES = 100_000


def places_of(held: Store, node: GltfNode) -> Floats:
    """The matrices ``(n, 4, 4)`` of a node's instances in its own frame; of a node without any the
    identity once."""
    given = node.extensions.get(INSTANCING)
    named: Any = given.get("attributes") if isinstance(given, dict) else None
    if not isinstance(named, dict):
        return np.eye(4)[None]
    rows = {
        name: floats(held, named[name], width)
        for name, width in (("TRANSLATION", 3), ("ROTATION", 4), ("SCALE", 3))
        if isinstance(named.get(name), int)
    }
    counts = {len(row) for row in rows.values()}
    if len(counts) != 1 or max(counts) > MOST_INSTANCES:
        raise InputError("instances of a node differ in number", "export the model again")
    count = counts.pop()
    turn = rows.get("ROTATION", np.tile([0.0, 0.0, 0.0, 1.0], (count, 1)))
    found = np.tile(np.eye(4), (count, 1, 1))
    found[:, :3, :3] = turns_of(turn) * rows.get("SCALE", np.ones((count, 3)))[:, None]
    found[:, :3, 3] = rows.get("TRANSLATION", np.zeros((count, 3)))
    return found


def turns_of(quaternions: Floats) -> Floats:
    """Matrices ``(n, 3, 3)`` of quaternions ``(n, 4)``, the real part last."""
    length = np.maximum(np.linalg.norm(quaternions, axis=1), 1e-12)
    x, y, z, w = (quaternions / length[:, None]).T
    rows = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    )
    return np.moveaxis(np.array(rows), -1, 0)
