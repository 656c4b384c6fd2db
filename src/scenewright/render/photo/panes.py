"""What glass does to rays from the eye: some are mirrored by it, the rest are tinted."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry import rays
from scenewright.render.light import OFFSET
from scenewright.render.observations.world import VisibleWorld

Singles = NDArray[np.float32]

STRAIGHT = 0.08
"""Share of light that a pane of two faces mirrors straight on: twice 0.04, of an index of 1.5."""
MOST = 0.15
"""The most that is mirrored: more is noise beside what is seen through it."""
GOLDEN = 0.618034
"""Samples of a pixel are evenly spread by steps of this."""


def pass_panes(
    world: VisibleWorld, first: int, sample: int, starts: Singles, ways: Singles, through: Singles
) -> None:
    """Change rays ``(n, 3)`` of pixels from number ``first`` on in place where the first thing they
    meet is glass: by C. Schlick's formula (1994) a share is sent on as off a mirror, the others
    lose what the glass keeps."""
    away, face, _ = rays.hits(world.casters.panes, starts, ways)
    seen = np.flatnonzero(face >= 0)
    if not len(seen):
        return
    open_to = ~rays.is_occluded(world.casters.solid, starts[seen], ways[seen], away[seen])
    seen = seen[open_to]
    corners = world.stage.glass[face[seen]]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
    along = (normal * ways[seen]).sum(1)
    grazing = (1.0 - np.minimum(np.abs(along), 1.0)) ** 5
    drawn = np.random.default_rng(first).random(len(starts))[seen] + GOLDEN * sample
    share = np.minimum(STRAIGHT + (1.0 - STRAIGHT) * grazing, MOST)
    mirrored = drawn % 1.0 < share
    tints = world.stage.tints[face[seen[~mirrored]]]
    through[seen[~mirrored]] *= 1.0 - tints[:, 3:] * (1.0 - tints[:, :3])
    back, normal, along = seen[mirrored], normal[mirrored], along[mirrored, None]
    side = -np.sign(along) * normal
    starts[back] += away[back, None] * ways[back] + OFFSET * side
    ways[back] -= 2.0 * along * normal
