"""Scenes as triangles in place, with their finishes: what pictures are taken of."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Catalog, Material
from scenewright.core.scene import Scene
from scenewright.geometry.prisms import face_normals, normals_of, row_keys
from scenewright.render import finish
from scenewright.render.colour import linear_of
from scenewright.render.items import SLAB, RenderItem, things, to_level_coordinates
from scenewright.render.level_of_detail import affordable
from scenewright.render.picture import PAGE, RenderStage

APART = 2.0
"""Distance of levels that stand side by side, in metres."""
SHADOW = 1.7
"""How far beyond the scene, in metres, its shadow is drawn."""

PATTERNS = {
    "oak floor": finish.PLANKS,
    "stone floor": finish.SLABS,
    "tile floor": finish.TILES,
    "deck floor": finish.DECK,
    "page": finish.PAGE,
    "grass": finish.GRASS,
    "meadow": finish.GRASS,
    "asphalt": finish.GRIT,
    "pavement": finish.SLABS,
    "gravel path": finish.GRIT,
    "garden walk": finish.SLABS,
    "crown": finish.LEAVES,
    "light crown": finish.LEAVES,
    "needles": finish.LEAVES,
}

Floats = NDArray[np.float64]


class PartTriangles(NamedTuple):
    """The triangles of one part, in place, and the category of the thing it belongs to."""

    material: Material
    vertices: Floats
    faces: NDArray[np.int64]
    normals: Floats
    category: str = ""


def stage_of(
    blocks: Sequence[PartTriangles], bounds: Floats, page: Material = PAGE, shadow: float = SHADOW
) -> RenderStage:
    """All blocks as one stage on a wide page just below them; shadows fall on it as far as
    ``shadow`` metres."""
    clear = [block for block in blocks if block.material.opacity < 0.8]
    solid = [block for block in blocks if block.material.opacity >= 0.8]
    solid.append(_page(bounds, page))
    materials = list({block.material: None for block in solid})
    counts = [len(block.faces) for block in solid]
    corners = np.concatenate([block.vertices[block.faces] for block in solid])
    normals = np.concatenate([block.normals for block in solid])
    which = np.repeat([materials.index(block.material) for block in solid], counts)
    smooth = np.abs(normals - normals[:, :1]).max((1, 2)) > 1e-3
    smooth |= np.abs(normals[:, 0] - _flat_normals(corners)).max(1) > 1e-3
    owner = np.repeat(np.arange(len(solid)), counts)
    tints = [np.tile(_tint(b.material), (len(b.faces), 1)) for b in clear]
    panes = [b.vertices[b.faces] for b in clear]
    return RenderStage(
        corners.astype(np.float32),
        normals.astype(np.float32),
        which.astype(np.int32),
        _keys(corners, smooth, which, owner),
        smooth,
        np.array([_row(material) for material in materials], np.float32),
        np.concatenate([np.zeros((0, 3, 3)), *panes]).astype(np.float32),
        np.concatenate([np.zeros((0, 4)), *tints]).astype(np.float32),
        np.stack([bounds.min(0) - shadow, bounds.max(0) + shadow]).astype(np.float32),
    )


def blocks_of(scene: Scene, catalog: Catalog, cut: float | None = None) -> list[PartTriangles]:
    """Every part of every thing, levels side by side on one ground, without what is above
    ``cut``."""
    shown = affordable(things(scene, catalog, cut))
    normals = _shared_normals(shown)
    found: list[PartTriangles] = []
    start = 0.0
    for level in scene.levels:
        mine = [thing for thing in shown if thing.level == level.id]
        blocks = [block for thing in mine for block in _of_thing(thing, normals[thing.key])]
        if not blocks:
            continue
        points = np.vstack([block.vertices for block in blocks])
        shift = np.array([start - points[:, 0].min() if found else 0.0, 0.0, 0.0])
        found += [block._replace(vertices=block.vertices + shift) for block in blocks]
        start = float(points[:, 0].max() + shift[0]) + APART
    return found


def _shared_normals(shown: Sequence[RenderItem]) -> dict[Hashable, list[Floats]]:
    """Normals of the parts of every kind of thing, by its key."""
    kinds = {thing.key: thing.parts for thing in shown}
    found = iter(normals_of([(p.vertices, p.faces) for parts in kinds.values() for p in parts]))
    return {key: [next(found) for _ in parts] for key, parts in kinds.items()}


def _of_thing(thing: RenderItem, normals: Sequence[Floats]) -> list[PartTriangles]:
    turn = thing._replace(at=(0.0, 0.0, 0.0))
    return [
        PartTriangles(
            part.material,
            to_level_coordinates(thing, part.vertices),
            part.faces,
            to_level_coordinates(turn, corner.reshape(-1, 3)).reshape(-1, 3, 3),
            str(thing.extras.get("category", "")),
        )
        for part, corner in zip(thing.parts, normals, strict=True)
    ]


def _flat_normals(corners: Floats) -> Floats:
    return face_normals(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))


def _keys(
    corners: Floats, smooth: NDArray[np.bool_], which: NDArray[np.int64], owner: NDArray[np.int64]
) -> NDArray[np.int32]:
    """Equal for faces of one plane and finish, or of one round part."""
    flat = _flat_normals(corners)
    offset = np.einsum("ij,ij->i", flat, corners[:, 0])
    plane = np.column_stack([flat * 200, offset * 200, which, np.zeros(len(flat))])
    plane[smooth] = 0.0
    plane[smooth, 5] = owner[smooth] + 1
    return np.unique(row_keys(plane), return_inverse=True)[1].astype(np.int32)


def _page(bounds: Floats, material: Material) -> PartTriangles:
    """A large sheet under the home that catches its shadow."""
    low, high = bounds.min(0), bounds.max(0)
    wide = 6 * float(np.max(high - low)) + 10
    (x, y), z = (low[:2] + high[:2]) / 2, -SLAB - 0.002
    vertices = np.array(
        [
            [x - wide, y - wide, z],
            [x + wide, y - wide, z],
            [x + wide, y + wide, z],
            [x - wide, y + wide, z],
        ]
    )
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    return PartTriangles(material, vertices, faces, np.tile([0.0, 0.0, 1.0], (2, 3, 1)))


def _row(material: Material) -> list[float]:
    color = linear_of(np.array(material.color)).tolist()
    pattern = PATTERNS.get(material.name, finish.PLAIN)
    return [*color, material.roughness, material.metallic, material.emission, float(pattern)]


def _tint(material: Material) -> Floats:
    return np.array([*linear_of(np.array(material.color)), material.opacity])
