"""Scenes as triangles in place, with their finishes: what pictures are taken of."""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
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

CLEAR = 0.8
"""What lets more light through than this opacity does is glass."""
AT_ONCE = 50_000
"""Triangles that are prepared together."""

PATTERNS = {
    **{
        f"{wood} floor": finish.PLANKS
        for wood in ["oak", "pine", "cedar", "hinoki", "hickory", "larch"]
    },
    **{f"{stone} floor": finish.SLABS for stone in ("stone", "slate", "limestone")},
    **{f"{clay} floor": finish.TILES for clay in ("tile", "terracotta", "quarry tile")},
    "deck floor": finish.DECK,
    "page": finish.PAGE,
    "grass": finish.GRASS,
    "meadow": finish.GRASS,
    "asphalt": finish.GRIT,
    "pavement": finish.SLABS,
    "gravel path": finish.GRIT,
    "garden walk": finish.SLABS,
    "lane": finish.GRIT,
    "parking": finish.GRIT,
    "court lawn": finish.GRASS,
    "park lawn": finish.GRASS,
    "crown": finish.LEAVES,
    "light crown": finish.LEAVES,
    "needles": finish.LEAVES,
}

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]


class PartTriangles(NamedTuple):
    """The triangles of one part, in place, and the category of the thing it belongs to."""

    material: Material
    vertices: Floats
    faces: NDArray[np.int64]
    normals: Floats | Singles
    category: str = ""


def stage_of(
    blocks: Sequence[PartTriangles], bounds: Floats, page: Material = PAGE, shadow: float = SHADOW
) -> RenderStage:
    """All blocks as one stage on a wide page just below them; shadows fall on it as far as
    ``shadow`` metres.

    ``bounds`` (k, 3) points in metres that the page reaches beyond.
    """
    clear = [block for block in blocks if block.material.opacity < CLEAR]
    solid = [block for block in blocks if block.material.opacity >= CLEAR]
    solid.append(_page(bounds, page))
    numbers = {block.material: 0 for block in solid}
    numbers = {material: number for number, material in enumerate(numbers)}
    parts = [_triangles_of(batch, numbers) for batch in _batches(solid)]
    corners, normals, which, keys, smooth = (
        np.concatenate(column) for column in zip(*parts, strict=True)
    )
    tints = [np.tile(_tint(b.material), (len(b.faces), 1)) for b in clear]
    panes = [b.vertices[b.faces] for b in clear]
    return RenderStage(
        corners,
        normals,
        which,
        np.unique(keys, return_inverse=True)[1].astype(np.int32),
        smooth,
        np.array([_row(material) for material in numbers], np.float32),
        np.concatenate([np.zeros((0, 3, 3)), *panes]).astype(np.float32),
        np.concatenate([np.zeros((0, 4)), *tints]).astype(np.float32),
        np.stack([bounds.min(0) - shadow, bounds.max(0) + shadow]).astype(np.float32),
    )


def blocks_of(
    scene: Scene,
    catalog: Catalog,
    cut: float | None = None,
    towards: tuple[float, float, float] | None = None,
    turn: float = 0.0,
) -> list[PartTriangles]:
    """Every part of every thing, levels side by side on one ground, without what is above
    ``cut``; walls before a room for an eye that looks ``towards`` a direction are lower. All is
    turned by ``turn`` radians about z first, so that the eye sees it from another side."""
    seen = towards and turn_direction(towards, -turn)
    shown = [turn_item(one, turn) for one in affordable(things(scene, catalog, cut, seen))]
    normals = shared_normals(shown)
    found: list[PartTriangles] = []
    start = 0.0
    for level in scene.levels:
        mine = [thing for thing in shown if thing.level == level.id]
        blocks = [block for thing in mine for block in place_parts(thing, normals[thing.key])]
        if not blocks:
            continue
        low = min(block.vertices[:, 0].min() for block in blocks if len(block.vertices))
        high = max(block.vertices[:, 0].max() for block in blocks if len(block.vertices))
        shift = np.array([start - low if found else 0.0, 0.0, 0.0])
        found += [block._replace(vertices=block.vertices + shift) for block in blocks]
        start = float(high + shift[0]) + APART
    return found


def turn_direction(way: tuple[float, float, float], turn: float) -> tuple[float, float, float]:
    """A direction turned about z.

    >>> turn_direction((1.0, 0.0, -1.0), 0.0)
    (1.0, 0.0, -1.0)
    """
    cos, sin = float(np.cos(turn)), float(np.sin(turn))
    return (cos * way[0] - sin * way[1], sin * way[0] + cos * way[1], way[2])


def turn_item(item: RenderItem, turn: float) -> RenderItem:
    """An item turned about the origin of its level."""
    return item._replace(at=turn_direction(item.at, turn), turn=item.turn + turn) if turn else item


def shared_normals(shown: Sequence[RenderItem]) -> dict[Hashable, list[Singles]]:
    """Normals of the parts of every kind of thing, by its key."""
    kinds = {thing.key: thing.parts for thing in shown}
    meshes = [(p.vertices, p.faces) for parts in kinds.values() for p in parts]
    found = (normals.astype(np.float32) for normals in normals_of(meshes))
    return {key: [next(found) for _ in parts] for key, parts in kinds.items()}


def place_parts(thing: RenderItem, normals: Sequence[Singles]) -> list[PartTriangles]:
    """The parts of a thing in the frame of its level, with ``normals`` of its own frame."""
    turn = thing._replace(at=(0.0, 0.0, 0.0))
    return [
        PartTriangles(
            part.material,
            to_level_coordinates(thing, part.vertices),
            part.faces,
            to_level_coordinates(turn, corner.reshape(-1, 3).astype(np.float64))
            .reshape(-1, 3, 3)
            .astype(np.float32),
            str(thing.extras.get("category", "")),
        )
        for part, corner in zip(thing.parts, normals, strict=True)
    ]


def _batches(solid: Sequence[PartTriangles]) -> list[list[tuple[int, PartTriangles]]]:
    """The blocks with their numbers, :data:`AT_ONCE` faces and a block together: what is worked
    out for one batch takes no more memory however many there are."""
    ends = np.cumsum([0, *(len(block.faces) for block in solid)])[:-1] // AT_ONCE
    found: dict[int, list[tuple[int, PartTriangles]]] = {}
    for batch, numbered in zip(ends.tolist(), enumerate(solid), strict=True):
        found.setdefault(batch, []).append(numbered)
    return list(found.values())


def _triangles_of(
    batch: Sequence[tuple[int, PartTriangles]], numbers: Mapping[Material, int]
) -> tuple[Singles, Singles, NDArray[np.int32], NDArray[np.int64], NDArray[np.bool_]]:
    """Corners, normals, finishes, keys and whether it is round, for each triangle of a batch."""
    counts = [len(block.faces) for _, block in batch]
    corners = np.concatenate([block.vertices[block.faces] for _, block in batch])
    normals = np.concatenate([block.normals for _, block in batch])
    which = np.repeat([numbers[block.material] for _, block in batch], counts)
    flat = face_normals(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))
    smooth = np.abs(normals - normals[:, :1]).max((1, 2)) > 1e-3
    smooth |= np.abs(normals[:, 0] - flat).max(1) > 1e-3
    keys = _keys(corners, flat, smooth, which, np.repeat([number for number, _ in batch], counts))
    return (
        corners.astype(np.float32),
        normals.astype(np.float32),
        which.astype(np.int32),
        keys,
        smooth,
    )


def _keys(
    corners: Floats,
    flat: Floats,
    smooth: NDArray[np.bool_],
    which: NDArray[np.int64],
    owner: NDArray[np.int64],
) -> NDArray[np.int64]:
    """Equal for faces of one plane and finish, or of one round part."""
    offset = np.einsum("ij,ij->i", flat, corners[:, 0])
    plane = np.column_stack([flat * 200, offset * 200, which, np.zeros(len(flat))])
    plane[smooth] = 0.0
    plane[smooth, 5] = owner[smooth] + 1
    return row_keys(plane)


def _page(bounds: Floats, material: Material) -> PartTriangles:
    """A large sheet under the home that catches its shadow."""
    low, high = bounds.min(0), bounds.max(0)
    wide = 6 * float(np.max(high - low)) + 10
    (x, y), z = (low[:2] + high[:2]) / 2, min(-SLAB, float(low[2])) - 0.002
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
    pattern = PATTERNS.get(material.name.partition(", ")[0], finish.PLAIN)
    return [*color, material.roughness, material.metallic, material.emission, float(pattern)]


def _tint(material: Material) -> Floats:
    return np.array([*linear_of(np.array(material.color)), material.opacity])
