"""What a walker sees of real models, through embree; and the best place for a picture.

The visible quality is that of :mod:`.walker`, with the saliency of the very triangle met.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from scenewright.geometry import rays
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.prisms import box
from scenewright.geometry.walker import REACH, Floats, Ints, Sights, sights

MOST = 8_000_000
"""Triangles of a street; embree takes about 100 bytes each. What is more is drawn as boxes."""
PICTURE_RAYS = 256
VIEW = float(np.deg2rad(60.0))
STANDOFF = 40.0
STEEPEST = float(np.deg2rad(26.0))
RISE = float(np.deg2rad(6.0))
"""A street picture: how wide it is, how far away buildings should be in metres, how high up it
reaches and how much one looks up."""
BINS = 72


class SaliencyModel(NamedTuple):
    """A mesh in its own frame (front to +y, standing on z = 0 over the origin) and the saliency
    ``density`` (m,) of each of its faces."""

    mesh: Mesh
    density: Floats


class Street(NamedTuple):
    """Models in place: rays against them; of each triangle the saliency ``density`` (t,) and the
    building ``owner`` (t,); ``best``, the greatest mean saliency of one of the models."""

    caster: rays.Caster
    density: Floats
    owner: Ints
    best: float


class Viewpoint(NamedTuple):
    """Where to stand, ``point`` (3,), where to look, unit ``way`` (3,), and what is in view."""

    point: Floats
    way: Floats
    score: float


def street(
    models: Sequence[SaliencyModel], which: ArrayLike, poses: ArrayLike, most: int = MOST
) -> Street:
    """Buildings of models ``which`` (n,) at ``poses`` (n, 4): x, y, z and heading of the front.

    Where all would have more than ``most`` triangles, those with most are replaced by boxes.
    """
    used, rows = np.asarray(which, np.int64).reshape(-1), np.asarray(poses, np.float64)
    plain = _within(models, used, most)
    vertices, faces, density, owner, start = [], [], [], [], 0
    for i, k in enumerate(used):
        mesh = plain[k].mesh
        vertices.append(_place_vertices(mesh.vertices, rows[i]))
        faces.append(mesh.faces + start)
        density.append(plain[k].density)
        owner.append(np.full(len(mesh.faces), i, np.int64))
        start += len(mesh.vertices)
    best = max((_mean(models[k]) for k in np.unique(used)), default=0.0)
    none = [np.zeros((0, 3))]
    return Street(
        rays.build(np.concatenate(vertices or none), np.concatenate(faces or none)),
        np.concatenate([np.zeros(0), *density]),
        np.concatenate([np.zeros(0, np.int64), *owner]),
        best,
    )


def _within(models: Sequence[SaliencyModel], used: Ints, most: int) -> list[SaliencyModel]:
    """The models, the largest as boxes if all together would be too many triangles."""
    out = list(models)
    times = np.bincount(used, minlength=len(out))
    sizes = np.array([len(model.mesh.faces) for model in out]) * times
    for k in np.argsort(-sizes):
        if sizes.sum() <= most:
            break
        out[k] = to_bounding_box(out[k])
        sizes[k] = len(out[k].mesh.faces) * times[k]
    return out


def to_bounding_box(model: SaliencyModel) -> SaliencyModel:
    """A model's bounding box, all of it as salient as the model is on the mean."""
    low, high = model.mesh.vertices.min(0), model.mesh.vertices.max(0)
    mesh = box(low.tolist(), high.tolist())
    return SaliencyModel(mesh, np.full(len(mesh.faces), _mean(model)))


def _mean(model: SaliencyModel) -> float:
    """Mean saliency of a model's surface, by area."""
    a, b, c = (model.mesh.vertices[model.mesh.faces[:, k]] for k in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return float(areas @ model.density / areas.sum()) if areas.sum() > 0.0 else 0.0


def _place_vertices(vertices: Floats, pose: Floats) -> Floats:
    """Vertices at a pose: +y goes to the heading, +x to the right of it."""
    c, s = np.cos(pose[3]), np.sin(pose[3])
    turn = np.array([[s, -c, 0.0], [c, s, 0.0], [0.0, 0.0, 1.0]])
    return np.asarray(vertices @ turn + pose[:3])


def sights_of_meshes(
    of: Street,
    eyes: ArrayLike,
    best: float | None = None,
    count: int = PICTURE_RAYS,
    reach: float = REACH,
) -> Sights:
    """What eyes ``(p, 2)`` or ``(p, 3)`` see of the models of a street, by ``count`` rays each;
    ``best`` is q* (left out: the greatest mean of one of the models)."""
    made = sights(eyes, count)
    ways = ways_of(made)
    starts = np.broadcast_to(made.eyes[:, None], ways.shape)
    distance, met, normal = rays.hits(of.caster, starts, ways)
    flat = ways.reshape(-1, 3)
    hit = np.flatnonzero((met >= 0) & (distance < reach))
    top = of.best if best is None else best
    share = of.density[met[hit]] / (top if top > 0.0 else 1.0)
    facing = np.abs(np.einsum("ij,ij->i", normal[hit].astype(np.float64), flat[hit]))
    far = distance[hit].astype(np.float64)
    made.found.reshape(-1)[hit] = of.owner[met[hit]]
    made.distances.reshape(-1)[hit] = far
    made.values.reshape(-1)[hit] = share * (1.0 - far / reach) ** 2 * facing
    return made


def ways_of(made: Sights) -> Floats:
    """Directions ``(p, r, 3)`` of all rays of all eyes."""
    c, s = np.cos(made.turns)[:, None], np.sin(made.turns)[:, None]
    x, y, z = made.ways.T
    return np.stack([x * c - y * s, x * s + y * c, np.broadcast_to(z, (len(c), len(z)))], -1)


def side_densities(model: SaliencyModel, count: int = 2000) -> Floats:
    """Mean saliency (5,) of a model as its front, left, back and right side and its roof show it,
    over that side of its box; where the model leaves the box empty, nothing is seen.

    So boxes look to a walker about as the models do: for ``density`` of :mod:`.walker`.
    """
    low, high = model.mesh.vertices.min(0), model.mesh.vertices.max(0)
    caster = rays.build(*model.mesh[:2])
    steps = (np.arange(count) + 0.5) / count
    square = np.stack([steps, (np.arange(count) * 0.6180339887498949) % 1.0], 1)
    out = np.zeros(5)
    for side, (axis, sign) in enumerate([(1, 1), (0, -1), (1, -1), (0, 1), (2, 1)]):
        others = [k for k in range(3) if k != axis]
        starts, ways = np.zeros((count, 3)), np.zeros((count, 3))
        starts[:, others] = low[others] + square * (high - low)[others]
        starts[:, axis] = (high if sign > 0 else low)[axis] + sign
        ways[:, axis] = -sign
        met = rays.first(caster, starts, ways)
        out[side] = np.where(met >= 0, model.density[met], 0.0).mean()
    return out


def best_spots(made: Sights, view: float = VIEW, standoff: float = STANDOFF) -> list[Viewpoint]:
    """Of every eye the direction in which a picture shows most, the best eye first.

    A view ``view`` radians wide is judged by (Σ √v)², v being what one building adds to it: as
    much as all add if one building fills it, k times as much if k share it. Rays steeper than
    :data:`STEEPEST` are outside the picture, and those that meet something nearer than
    ``standoff`` metres count by the square of the distance (equal areas of wall alike), or the
    best picture would be of a wall. One looks at
    the middle of the view, slightly up. ``score`` is (Σ √v)².
    """
    ways = ways_of(made)
    nearness = np.minimum(made.distances / standoff, 1.0)
    worth = made.values * nearness**2 / made.values.shape[1]
    worth[:, made.ways[:, 2] > np.sin(STEEPEST)] = 0.0
    turn = np.arctan2(ways[..., 1], ways[..., 0])
    bins = ((turn / (2.0 * np.pi)) % 1.0 * BINS).astype(np.int64) % BINS
    wide = min(max(round(view / (2.0 * np.pi) * BINS), 1), BINS)
    scores = np.array(
        [_views(made.found[e], bins[e], worth[e], wide) for e in range(len(bins))]
    ).reshape(-1, BINS)
    firsts = scores.argmax(1)
    order = np.argsort(-scores.max(1), kind="stable")
    return [_spot(made.eyes[e], firsts[e] + wide / 2, scores[e, firsts[e]]) for e in order]


def _spot(eye: Floats, middle: float, score: float) -> Viewpoint:
    """The view whose middle is ``middle`` bins from +x."""
    turn = middle / BINS * 2.0 * np.pi
    way = np.array([np.cos(RISE) * np.cos(turn), np.cos(RISE) * np.sin(turn), np.sin(RISE)])
    return Viewpoint(eye, way, float(score))


def _views(found: Ints, bins: Ints, worth: Floats, wide: int) -> Floats:
    """(Σ √v)² of the views (BINS,) that begin at each bin and are ``wide`` bins wide."""
    shown = np.flatnonzero(worth > 0.0)
    names, row = np.unique(found[shown], return_inverse=True)
    sums = np.bincount(row * BINS + bins[shown], worth[shown], len(names) * BINS)
    gone = np.cumsum(np.tile(sums.reshape(-1, BINS), 2), 1)
    gone = np.concatenate([np.zeros((len(names), 1)), gone], 1)
    held = np.maximum(gone[:, wide : wide + BINS] - gone[:, :BINS], 0.0)
    return np.asarray(np.sqrt(held).sum(0) ** 2)
