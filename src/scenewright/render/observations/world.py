"""A scene as seen from inside: all levels in place, ceilings, ground and sky, every triangle with
the number of the thing it belongs to. Built once for all cameras."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import count
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.kinds import KINDS
from scenewright.core.catalog import Catalog, Part
from scenewright.core.scene import Scene
from scenewright.geometry import rays
from scenewright.render.items import RenderItem, things
from scenewright.render.lamps import lamps_of
from scenewright.render.light_rows import dark_rows, row_item
from scenewright.render.observations.ceilings import ceilings
from scenewright.render.picture import RenderStage, StageCasters, build_caster, build_casters
from scenewright.render.public_rooms import fittings
from scenewright.render.stage import CLEAR, place_parts, shared_normals, stage_of
from scenewright.render.street import AIR, MEADOW

BUILT = (
    "wall",
    "floor",
    "ceiling",
    "door",
    "window",
    "passage",
    "staircase",
    "slab",
    "surface",
    "ground",
)
"""What is no piece of furniture: classes 1, 2, 3 …"""
FIRST = 32
"""The class of the first kind of furniture, by the alphabet."""
UNKNOWN = 31
"""The class of furniture of a kind that is not known."""
SHADOW = 2.0
"""How far around the building shadows are drawn on the ground, in metres."""

Ints = NDArray[np.int32]


class Instance(NamedTuple):
    """One thing that can be seen: its number in masks and that of its class, the id it has in the
    scene, its kind (``piece`` or one of :data:`BUILT`), category, room and level."""

    instance: int
    semantic: int
    id: str
    kind: str
    category: str
    room: str
    level: str


class VisibleWorld(NamedTuple):
    """``scene``; the ``stage`` that colour is taken of, with its ``casters``; ``measured``: the
    same with glass among its triangles and the numbers of instances as keys, which ``every`` ray
    that measures is cast against; the ``instances`` (number k at place k - 1)."""

    scene: Scene
    stage: RenderStage
    casters: StageCasters
    measured: RenderStage
    every: rays.Caster
    instances: tuple[Instance, ...]

    @property
    def classes(self) -> NDArray[np.uint16]:
        """The class of each instance by its number, 0 of nothing."""
        return np.array([0, *(one.semantic for one in self.instances)], np.uint16)


def class_of(category: str) -> int:
    """The number of a class, the same in all scenes of a version.

    >>> class_of("wall"), class_of("floor"), class_of("no such kind"), class_of("sofa") > 32
    (1, 2, 31, True)
    """
    if category in BUILT:
        return 1 + BUILT.index(category)
    return FIRST + sorted(KINDS).index(category) if category in KINDS else UNKNOWN


def shown_items(scene: Scene, catalog: Catalog) -> tuple[RenderItem, ...]:
    """The things that are seen from inside, in the order of the world's triangles."""
    found = things(scene, catalog)
    rows = [row_item(row) for row in dark_rows(scene.spaces, lamps_of(found, catalog))]
    return tuple(one for one in (*found, *ceilings(scene), *rows, *fittings(scene)) if one.parts)


def solid_parts(scene: Scene, catalog: Catalog) -> list[Part]:
    """The parts of a world's stage, in the order of its triangles, which end in the ground's."""
    parts = (part for one in shown_items(scene, catalog) for part in one.parts)
    return [part for part in parts if part.material.opacity >= CLEAR]


def build_world(scene: Scene, catalog: Catalog) -> VisibleWorld:
    """Everything that can be seen of a scene of rooms, ready to be looked at."""
    heights = {level.id: level.elevation for level in scene.levels}
    shown = shown_items(scene, catalog)
    normals = shared_normals(shown)
    blocks, owners = [], []
    for number, one in enumerate(shown, 1):
        x, y, z = one.at
        placed = one._replace(at=(x, y, z + heights[one.level]))
        parts = place_parts(placed, normals[one.key])
        blocks += parts
        owners += [number] * len(parts)
    bounds = np.array([f(b.vertices) for b in blocks for f in (_low, _high)])
    ends = np.stack([bounds.min(0), bounds.max(0)])
    stage = stage_of(blocks, ends, MEADOW, SHADOW)._replace(air=AIR)
    clear = [block.material.opacity < CLEAR for block in blocks]
    faces = [len(block.faces) for block in blocks]
    solid, glass = (_repeat(owners, faces, clear, which) for which in (False, True))
    ground = np.full(len(stage.corners) - len(solid), len(shown) + 1, np.int32)
    measured = _measured(stage, np.concatenate([solid, ground, glass]))
    return VisibleWorld(
        scene,
        stage,
        build_casters(stage),
        measured,
        build_caster(measured.corners),
        tuple(_instances(shown)),
    )


def _low(points: NDArray[np.float64]) -> NDArray[np.float64]:
    return points.min(0)


def _high(points: NDArray[np.float64]) -> NDArray[np.float64]:
    return points.max(0)


def _repeat(owners: Sequence[int], faces: Sequence[int], clear: list[bool], which: bool) -> Ints:
    rows = np.flatnonzero(np.array(clear, bool) == which)
    return np.repeat(np.array(owners, np.int32)[rows], np.array(faces, np.int64)[rows])


def _measured(stage: RenderStage, numbers: Ints) -> RenderStage:
    """A stage with its glass as triangles like all others, flat, with ``numbers`` (m,) as keys."""
    corners = np.concatenate([stage.corners, stage.glass])
    everywhere = np.array([[-np.inf] * 3, [np.inf] * 3], np.float32)
    flat = np.zeros(len(corners), np.bool_)
    return stage._replace(
        corners=corners, normals=corners, keys=numbers, smooth=flat, near=everywhere, air=None
    )


def category_of(item: RenderItem) -> str:
    """The class of a thing in words: what kind of furniture, or which of :data:`BUILT`."""
    if item.kind in ("piece", "opening"):
        return str(item.extras.get("category", ""))
    return {"space": "floor", "stairs": "staircase"}.get(item.kind, item.kind)


def _instances(shown: Sequence[RenderItem]) -> Iterable[Instance]:
    numbers = count(1)
    for one in shown:
        category = category_of(one)
        named = "piece" if one.kind == "piece" else category
        room = one.space or str(one.extras.get("space", ""))
        number = class_of(category)
        yield Instance(next(numbers), number, one.name, named, category, room, one.level)
    yield Instance(next(numbers), class_of("ground"), "ground", "ground", "ground", "", "")
