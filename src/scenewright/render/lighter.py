"""Level of detail: what small things of a model become where a scene holds very many of them."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from scenewright.core.catalog import Part
from scenewright.geometry.mesh import merge
from scenewright.geometry.solids import block
from scenewright.render.textures.projection import boards_of

if TYPE_CHECKING:
    from scenewright.render.items import RenderItem

MANY = 2_000_000
"""Triangles of a scene from which on small bodies are drawn as boxes."""
SMALL = 0.4
"""Bodies shorter than this, in metres, are small: goods on shelves, garments, handles."""
BOX = 12
"""Triangles of a box."""


def lighten(items: tuple[RenderItem, ...]) -> tuple[RenderItem, ...]:
    """The items; in a scene of :data:`MANY` triangles and more, with boxes for the small bodies
    of their pieces."""
    if sum(len(part.faces) for item in items for part in item.parts) < MANY:
        return items
    made: dict[Hashable, tuple[Part, ...]] = {}
    for item in items:
        if item.kind == "piece" and item.key not in made:
            made[item.key] = tuple(box_small_bodies(part) for part in item.parts)
    return tuple(item._replace(parts=made.get(item.key, item.parts)) for item in items)


def box_small_bodies(part: Part) -> Part:
    """A part with each of its small bodies that has more triangles than a box replaced by the box
    about it.

    >>> from scenewright.core.catalog import Material
    >>> from scenewright.geometry.solids import ball
    >>> lump = Part(Material("x", (1, 1, 1)), *ball(0.1, 0.1, 0.1, (0, 0, 0))[:2])
    >>> len(lump.faces), len(box_small_bodies(lump).faces)
    (80, 12)
    """
    body = boards_of(part.faces, len(part.vertices))
    count = int(body.max()) + 1
    low, high = (np.full((count, 3), sign * np.inf) for sign in (1, -1))
    np.minimum.at(low, body, part.vertices)
    np.maximum.at(high, body, part.vertices)
    of_face = body[part.faces[:, 0]]
    faces = np.bincount(of_face, minlength=count)
    boxed = ((high - low).max(1) < SMALL) & (faces > BOX)
    if not boxed.any():
        return part
    kept = part.faces[~boxed[of_face]]
    used, renamed = np.unique(kept, return_inverse=True)
    boxes = merge(
        [block(*zip(low[k].tolist(), high[k].tolist(), strict=True)) for k in np.flatnonzero(boxed)]
    )
    vertices = np.concatenate([part.vertices[used], boxes.vertices])
    return replace(
        part,
        vertices=vertices,
        faces=np.concatenate([renamed.reshape(-1, 3), boxes.faces + len(used)]),
    )
