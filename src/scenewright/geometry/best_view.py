"""From where a model shows most: visible saliency, viewpoint entropy, and the best of all views.

Views are upright and from far away, so a direction says all. A view is judged by one of the rows
of :data:`MEASURES`; others can be added there.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry import rays
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.mesh_weld import clean_mesh
from scenewright.geometry.saliency import Saliency, values_at

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

LOWEST, HIGHEST = 0.0, np.pi / 3
"""How steeply one looks down, in radians."""
VIEWS = 96
PICKS = 4096
"""Points whose visibility stands for that of all saliency."""
RAYS = 6000
"""Rays of a picture."""
GOLDEN = np.pi * (3.0 - np.sqrt(5.0))
OFF = 1e-4
"""How far off the surface rays start, as a share of the size."""
ROUNDS = 4


class Subject(NamedTuple):
    """A model to look at: rays against it about its ``middle``, its saliency, its ``size``."""

    caster: rays.Caster
    found: Saliency
    middle: Floats
    size: float


class BestView(NamedTuple):
    """The best direction ``way`` (3,) from the model to the eye, its ``score``, and the
    ``scores`` (k,) of all ``ways`` (k, 3) tried first."""

    way: Floats
    score: float
    ways: Floats
    scores: Floats


def subject(mesh: Mesh, found: Saliency) -> Subject:
    """The model made ready for :data:`MEASURES`."""
    base = clean_mesh(mesh)
    return Subject(rays.build(*base.mesh[:2]), found, base.centre, base.size)


def best_view(mesh: Mesh, found: Saliency, measure: str = "picture") -> BestView:
    """The best direction to look at a mesh from, found among many and then step by step.

    >>> from scenewright.geometry.mesh import loft, merge, translate_mesh
    >>> from scenewright.geometry.saliency import saliency
    >>> square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> block = loft([[(x, y, z) for x, y in square] for z in (0.0, 3.0)])
    >>> sill = Mesh(block.vertices * 0.2, block.faces)
    >>> sills = (translate_mesh(sill, 1.0, y, z) for y in (-0.5, 0.5) for z in (1.0, 2.0))
    >>> house = merge([block, *sills])
    >>> bool(best_view(house, saliency(house), "saliency").way[0] > 0.3)
    True
    """
    judge, about = MEASURES[measure], subject(mesh, found)
    ways = directions(VIEWS)
    scores = judge(about, ways)
    best, score = ways[np.argmax(scores)], float(scores.max())
    step = np.sqrt(2 * np.pi / VIEWS) / 2
    for _ in range(ROUNDS):
        near = _around(best, step)
        others = judge(about, near)
        if others.max() > score:
            best, score = near[np.argmax(others)], float(others.max())
        step /= 2
    return BestView(best, score, ways, scores)


def directions(count: int, lowest: float = LOWEST, highest: float = HIGHEST) -> Floats:
    """Unit vectors ``(count, 3)`` evenly spread over a band of the sphere (a spiral that turns by
    the golden angle).

    >>> found = directions(500)
    >>> bool(abs(found[:, :2].mean(0)).max() < 0.01), found[:, 2].min().round(2).item()
    (True, 0.0)
    """
    low, high = np.sin(lowest), np.sin(highest)
    turn = GOLDEN * np.arange(count)
    z = low + (np.arange(count) + 0.5) / count * (high - low)
    flat = np.sqrt(1.0 - z * z)
    return np.stack([flat * np.cos(turn), flat * np.sin(turn), z], 1)


def visible_saliency(about: Subject, ways: Floats) -> Floats:
    """Share ``(k,)`` of a model's saliency that can be seen from each direction.

    The sum over the visible surface of C. H. Lee et al. (2005), by points that each stand for an
    equal part of the whole: picked at equal steps of the saliency added up from cell to cell.
    """
    held = (about.found.areas * about.found.values)[about.found.order]
    total = np.cumsum(held)
    if not total[-1] > 0.0:
        return np.zeros(len(ways))
    steps = (np.arange(PICKS) + 0.5) / PICKS * total[-1]
    picked = about.found.order[np.searchsorted(total, steps).clip(0, len(total) - 1)]
    places = about.found.points[picked] - about.middle
    return np.array(
        [
            1.0
            - rays.is_occluded(
                about.caster, places + OFF * about.size * way, np.broadcast_to(way, places.shape)
            ).mean()
            for way in ways
        ]
    )


def pictured_saliency(about: Subject, ways: Floats) -> Floats:
    """Saliency ``(k,)`` in the picture from each direction: over the visible surface as it is
    foreshortened there, as a share of the model's whole saliency.

    :func:`visible_saliency` counts a wall in full that is hardly turned to the eye; this does not.
    """
    whole = float(about.found.areas @ about.found.values)
    if not whole > 0.0:
        return np.zeros(len(ways))
    pixel = np.pi * (about.size / 2) ** 2 / RAYS
    return np.array([_sum_visible_values(about, way) for way in ways]) * (pixel / whole)


def _sum_visible_values(about: Subject, way: Floats) -> float:
    starts, along = parallel_rays(way, about.size)
    distance, met, _ = rays.hits(about.caster, starts, along)
    places = starts[met >= 0] + distance[met >= 0, None] * along[met >= 0]
    return float(values_at(about.found, places + about.middle).sum())


def viewpoint_entropy(about: Subject, ways: Floats) -> Floats:
    """Entropy ``(k,)`` in bits of the share of the picture each face takes up, the ground among
    them: P.-P. Vazquez, M. Feixas, M. Sbert and W. Heidrich (2001).

    Flat faces cut into many count as many, as the measure is meant.
    """
    return np.array(
        [_entropy(rays.first(about.caster, *parallel_rays(way, about.size))) for way in ways]
    )


def _entropy(met: NDArray[np.int32]) -> float:
    counts = np.bincount(met + 1)
    share = counts[counts > 0] / len(met)
    return float(-(share * np.log2(share)).sum())


def parallel_rays(way: Floats, size: float) -> tuple[Floats, Floats]:
    """Parallel rays towards the middle, over a disc as wide as the model can be.

    They lie on a spiral (H. Vogel 1979): rows would run along the bright edges of a building and
    meet them all or none. ``way`` (3,) of unit length, ``size`` in metres; origins (k, 3) and
    directions (k, 3).
    """
    right, up = _axes(way)
    radius = 0.5 * size * np.sqrt((np.arange(RAYS) + 0.5) / RAYS)[:, None]
    turn = (GOLDEN * np.arange(RAYS))[:, None]
    starts = size * way + radius * (np.cos(turn) * right + np.sin(turn) * up)
    return starts, np.broadcast_to(-way, starts.shape)


def _axes(way: Floats) -> tuple[Floats, Floats]:
    """The right and up directions of a viewer who looks against ``way``."""
    right = np.cross([0.0, 0.0, 1.0], way)
    right = right / np.linalg.norm(right)
    return right, np.cross(way, right)


def _around(way: Floats, step: float) -> Floats:
    """Eight directions about one, within the band."""
    azimuth, height = np.arctan2(way[1], way[0]), np.arcsin(way[2])
    angle = np.arange(8) * np.pi / 4
    heights = np.clip(height + step * np.sin(angle), LOWEST, HIGHEST)
    turns = azimuth + step * np.cos(angle) / np.cos(height)
    flat = np.cos(heights)
    return np.stack([flat * np.cos(turns), flat * np.sin(turns), np.sin(heights)], 1)


MEASURES: dict[str, Callable[[Subject, Floats], Floats]] = {
    "picture": pictured_saliency,
    "saliency": visible_saliency,
    "entropy": viewpoint_entropy,
}
"""Ways to judge views of a model."""
