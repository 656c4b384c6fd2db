"""glTF scenes taken apart: every building that stands in one, as a model of its own.

Where nodes say that they are buildings (``extras.category``, as in scenes of ours) these are; else
bodies that overlap in plan are parts of one building, and what is low or spans most of the scene
is ground.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.catalog.models.cityjson import rotate_parts, turn_of
from scenewright.catalog.models.files import Beside
from scenewright.catalog.models.gltf import SceneBody, open_scene, read_credits, scene_bodies
from scenewright.catalog.models.model import RawModel, SkippedModel, check_count, merge_parts
from scenewright.core.catalog import Part
from scenewright.core.errors import InputError

Floats = NDArray[np.float64]
TURN = np.array([[1.0, 0, 0], [0, 0, -1.0], [0, 1.0, 0]])
"""From the axes of glTF (y up) to ours (z up)."""
LOW, SHARED, GROUND = 1.5, 0.25, 0.5
"""Metres above the lowest point below which a body is ground; the share of a plan within another
from which both are one building; and the share of the whole scene that only ground covers."""
MOST_BODIES = 20_000


class SceneBuilding(NamedTuple):
    """A building of a scene: its name, the name of its model, its parts where they stand, in
    metres, z up (none: it has no surface), and by what angle in radians it is turned from the
    first building of its ``model`` (the same meshes at the same scale), whose number is
    ``like``."""

    name: str
    model: str
    parts: tuple[Part, ...]
    turn: float
    like: int


def read(content: bytes, stem: str, beside: Beside) -> Iterator[RawModel | SkippedModel]:
    """Every building that is not another one's copy as a model, turned until its footprint fills
    its box best, as those of city models are."""
    author, licence, _ = read_credits(content, beside)
    for number, one in enumerate(scene_buildings(content, stem, beside)):
        if one.like != number:
            continue
        if not one.parts:
            yield SkippedModel(one.model, "has no surface")
            continue
        parts = rotate_parts(one.parts, turn_of(one.parts))
        yield RawModel(one.model, one.name, parts, "+z", "-y", author, licence)


def scene_buildings(
    content: bytes, stem: str, beside: Beside, scale: float = 1.0
) -> tuple[SceneBuilding, ...]:
    """The buildings of a scene in the order of its nodes; ``scale`` is metres a unit. InputError
    if there are none."""
    bodies = [_turn_body(body, scale) for body in scene_bodies(open_scene(content, beside))]
    check_count(len(bodies), MOST_BODIES, "bodies")
    buildings = [body for body in bodies if body.category == "building"]
    groups = [[body] for body in buildings] if buildings else _join_bodies(bodies)
    if not groups:
        raise InputError("holds no building", "give a scene whose buildings stand on the ground")
    found, seen = list[SceneBuilding](), dict[str, int]()
    first: dict[tuple[object, ...], int] = {}
    for group in groups:
        name = group[0].name or "building"
        seen[name] = seen.get(name, 0) + 1
        name += f"-{seen[name]}" if seen[name] > 1 else ""
        parts = merge_parts([part for body in group for part in body.parts])
        like = first.setdefault(_copy_key(group), len(found))
        turn = _heading(group[0]) - _heading(groups[like][0])
        model = found[like].model if like < len(found) else f"{stem}/{name}".replace(" ", "-")
        found.append(SceneBuilding(name, model, parts, turn, like))
    return tuple(found)


def _copy_key(group: list[SceneBody]) -> tuple[object, ...]:
    """What copies of one building share: the meshes, their sizes, and where they stand from the
    first."""
    scales = [round(float(abs(np.linalg.det(body.place[:3, :3]))), 3) for body in group]
    steps = [body.place[:3, 3] - group[0].place[:3, 3] for body in group]
    away = [(round(float(np.hypot(s[0], s[2])), 2), round(float(s[1]), 2)) for s in steps]
    return tuple(zip((body.mesh for body in group), scales, away, strict=True))


def _heading(body: SceneBody) -> float:
    """By what angle a body is turned in plan."""
    x, _, z = body.place[:3, 0]
    return float(np.arctan2(-z, x))


def _turn_body(body: SceneBody, scale: float) -> SceneBody:
    parts = tuple(Part(p.material, p.vertices @ TURN.T * scale, p.faces) for p in body.parts)
    return body._replace(parts=parts)


def plan_of_parts(parts: tuple[Part, ...]) -> shapely.Geometry:
    """What some parts cover in plan: the union of their triangles seen from above."""
    corners = np.concatenate([part.vertices[part.faces][..., :2] for part in parts])
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    wide = np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) > 1e-6
    return shapely.union_all(shapely.polygons(corners[wide]), grid_size=1e-3)


def _join_bodies(bodies: list[SceneBody]) -> list[list[SceneBody]]:
    """Bodies that overlap in plan together, without the ground."""
    bodies = [body for body in bodies if body.parts]
    if not bodies:
        return []
    lowest = min(float(p.vertices[:, 2].min()) for body in bodies for p in body.parts)
    tops = [max(float(p.vertices[:, 2].max()) for p in body.parts) for body in bodies]
    plans = [plan_of_parts(body.parts) for body in bodies]
    whole = shapely.convex_hull(shapely.union_all(plans)).area
    kept = [
        k
        for k, plan in enumerate(plans)
        if tops[k] > lowest + LOW
        and not plan.is_empty
        and (len(bodies) < 3 or plan.area < GROUND * whole)
    ]
    parent = {k: k for k in kept}
    shapes = np.array([plans[k] for k in kept], object)
    pairs = shapely.STRtree(shapes).query(shapes, predicate="intersects") if kept else ()
    for i, j in zip(*pairs, strict=True) if kept else ():
        one, other = shapes[i], shapes[j]
        if i < j and one.intersection(other).area > SHARED * min(one.area, other.area):
            _unite(parent, kept[i], kept[j])
    found: dict[int, list[SceneBody]] = {}
    for k in kept:
        found.setdefault(_root(parent, k), []).append(bodies[k])
    return list(found.values())


def _root(parent: dict[int, int], k: int) -> int:
    while parent[k] != k:
        k = parent[k]
    return k


def _unite(parent: dict[int, int], a: int, b: int) -> None:
    one, other = sorted((_root(parent, a), _root(parent, b)))
    parent[other] = one
