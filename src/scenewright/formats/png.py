"""A picture of the whole home from above at an angle: walls cut open, soft light, no screen.

Levels stand side by side. Walls are cut just below the heads of doors and windows, so
that every room shows.
"""

from __future__ import annotations

import os
from collections.abc import Hashable, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog import Catalog, Material
from scenewright.formats.glb import linear_of
from scenewright.formats.picture import PAGE, Camera, Pixels, Stage, render, view_of
from scenewright.geometry import finish
from scenewright.geometry.prisms import face_normals, normals_of, row_keys
from scenewright.scene import Scene
from scenewright.solution import Solution
from scenewright.staging import SLAB, Thing, placed, things

CUT = 2.0
"""Height in metres above the floor at which walls are cut."""
APART = 2.0
SHADOW = 1.7
"""How far beyond the home, in metres, its shadow is drawn."""
WIDTH, TALLEST = 1440, 1026
ANGLE = np.deg2rad(26.0)
TOWARDS = (0.08, 0.42, -1.0)
"""Direction of view: mostly down, a little to the north and east."""
MARGIN = 1.06

PATTERNS = {
    "oak floor": finish.PLANKS, "stone floor": finish.SLABS, "tile floor": finish.TILES,
    "deck floor": finish.DECK, "page": finish.PAGE,
}  # fmt: skip

Floats = NDArray[np.float64]


class Block(NamedTuple):
    """The triangles of one part, in place."""

    material: Material
    vertices: Floats
    faces: NDArray[np.int64]
    normals: Floats


def write(solution: Solution, path: str | os.PathLike[str]) -> None:
    """Write the picture of a solution to ``path``; the file appears whole or not at all."""
    from PIL import Image

    from scenewright.assets import shipped
    from scenewright.shell import scene_of

    final = Path(path)
    partial = final.with_name(f".{final.name}.partial")
    pixels = picture(scene_of(solution), shipped())
    Image.fromarray(pixels).save(partial, format="png", compress_level=3)
    os.replace(partial, final)


def picture(scene: Scene, catalog: Catalog, width: int = WIDTH) -> Pixels:
    """The home as pixels ``(height, width, 3)``; the height follows the home's shape."""
    blocks = _blocks(scene, catalog)
    corners = [block.vertices for block in blocks] or [np.zeros((1, 3))]
    bounds = np.vstack(corners)
    camera, shape = framed(bounds)
    height = int(np.clip(round(width * shape), width // 3, TALLEST * width // WIDTH))
    return render(stage_of(blocks, bounds), camera, width, height)


def framed(points: Floats) -> tuple[Camera, float]:
    """A camera that sees all points with a margin, and height by width of the picture."""
    ahead = np.array(TOWARDS) / np.linalg.norm(TOWARDS)
    target = (points.min(0) + points.max(0)) / 2
    away, shape = 10.0, 0.7
    for _ in range(16):
        view = view_of(Camera(tuple(target - ahead), tuple(target), ANGLE), 1, 1)
        local = (points - target) @ view.axes.T.astype(float)
        deep = local[:, 2] + away
        x, y = local[:, 0] / deep, local[:, 1] / deep
        middle = np.array([x.min() + x.max(), y.min() + y.max()]) / 2 * away
        target = target + middle @ view.axes[:2].astype(float)
        half = max((x.max() - x.min()) / 2, (y.max() - y.min()) / 2 / (TALLEST / WIDTH)) * MARGIN
        shape = (y.max() - y.min() + 2 * (MARGIN - 1) * half) / (2 * half)
        away *= half / view.across
    return Camera(tuple(target - away * ahead), tuple(target), ANGLE), float(shape)


def stage_of(blocks: Sequence[Block], bounds: Floats) -> Stage:
    """All blocks as one stage on a wide page just below them."""
    clear = [block for block in blocks if block.material.opacity < 0.8]
    solid = [block for block in blocks if block.material.opacity >= 0.8]
    solid.append(_page(bounds))
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
    return Stage(
        corners.astype(np.float32), normals.astype(np.float32), which.astype(np.int32),
        _keys(corners, smooth, which, owner), smooth,
        np.array([_row(material) for material in materials], np.float32),
        np.concatenate([np.zeros((0, 3, 3)), *panes]).astype(np.float32),
        np.concatenate([np.zeros((0, 4)), *tints]).astype(np.float32),
        np.stack([bounds.min(0) - SHADOW, bounds.max(0) + SHADOW]).astype(np.float32),
    )  # fmt: skip


def _blocks(scene: Scene, catalog: Catalog) -> list[Block]:
    """Every part of every thing, levels side by side on one ground."""
    shown = things(scene, catalog, CUT)
    normals = _shared_normals(shown)
    found: list[Block] = []
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


def _shared_normals(shown: Sequence[Thing]) -> dict[Hashable, list[Floats]]:
    """Normals of the parts of every kind of thing, by its key."""
    kinds = {thing.key: thing.parts for thing in shown}
    found = iter(normals_of([(p.vertices, p.faces) for parts in kinds.values() for p in parts]))
    return {key: [next(found) for _ in parts] for key, parts in kinds.items()}


def _of_thing(thing: Thing, normals: Sequence[Floats]) -> list[Block]:
    turn = thing._replace(at=(0.0, 0.0, 0.0))
    return [
        Block(part.material, placed(thing, part.vertices), part.faces,
              placed(turn, corner.reshape(-1, 3)).reshape(-1, 3, 3))
        for part, corner in zip(thing.parts, normals, strict=True)
    ]  # fmt: skip


def _flat_normals(corners: Floats) -> Floats:
    return face_normals(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))


def _keys(corners: Floats, smooth: NDArray[np.bool_],
          which: NDArray[np.int64], owner: NDArray[np.int64]) -> NDArray[np.int32]:  # fmt: skip
    """Equal for faces of one plane and finish, or of one round part."""
    flat = _flat_normals(corners)
    offset = np.einsum("ij,ij->i", flat, corners[:, 0])
    plane = np.column_stack([flat * 200, offset * 200, which, np.zeros(len(flat))])
    plane[smooth] = 0.0
    plane[smooth, 5] = owner[smooth] + 1
    return np.unique(row_keys(plane), return_inverse=True)[1].astype(np.int32)


def _page(bounds: Floats) -> Block:
    """A large sheet under the home that catches its shadow."""
    low, high = bounds.min(0), bounds.max(0)
    wide = 6 * float(np.max(high - low)) + 10
    (x, y), z = (low[:2] + high[:2]) / 2, -SLAB - 0.002
    vertices = np.array([[x - wide, y - wide, z], [x + wide, y - wide, z],
                         [x + wide, y + wide, z], [x - wide, y + wide, z]])  # fmt: skip
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    return Block(PAGE, vertices, faces, np.tile([0.0, 0.0, 1.0], (2, 3, 1)))


def _row(material: Material) -> list[float]:
    color = linear_of(np.array(material.color)).tolist()
    pattern = PATTERNS.get(material.name, finish.PLAIN)
    return [*color, material.roughness, material.metallic, material.emission, float(pattern)]


def _tint(material: Material) -> Floats:
    return np.array([*linear_of(np.array(material.color)), material.opacity])
