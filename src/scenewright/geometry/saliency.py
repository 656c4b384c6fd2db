"""Mesh saliency: where a surface differs from its surroundings, at five scales.

C. H. Lee, A. Varshney and D. W. Jacobs, *Mesh saliency* (2005): the Gaussian mean 𝒢(v, σ) of the
mean curvature within 2σ of a place; at each scale |𝒢(v, σ) - 𝒢(v, 2σ)|; scales that hold a few
strong peaks weigh more than scales with many like ones (the suppression of L. Itti, C. Koch and
E. Niebur, 1998); summed. Three things differ, so that a model's saliency does not depend on how
it was cut into triangles, turned or written: means weigh places by area, not vertices alike; a
peak is the greatest value within σ, not among the vertices that happen to be joined to it; and ε
is a share of twice the greatest distance from the centroid, not of an axis-parallel box.

Any scale divided by its own greatest value makes a model with one fine point look plain all over.
:func:`scenewright.geometry.relief.measure_relief` weighs scales without that.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scenewright.geometry.gaussians import CELL, LEVELS, WIDTHS, blend, gaussian_sums, peaks
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.mesh_edges import sum_by_name
from scenewright.geometry.mesh_weld import CleanMesh, clean_mesh
from scenewright.geometry.surface_samples import Samples, sample_surface

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

UNIT = 0.003
"""ε as a share of the mesh's size; the scales are 2ε, 3ε, 4ε, 5ε, 6ε."""
PAIRS = 3.6e7
"""More pairs of points within reach than this, and points are put together."""
FAINT = 2.0
"""Differences of curvature, times the size, below which nothing stands out: the curvature of a
sphere as large as the mesh."""


class PointGrid(NamedTuple):
    """Points in the order of the cells of a uniform grid, in units from its ``low`` corner."""

    points: Floats
    starts: Ints
    shape: Ints
    low: Floats
    unit: float


Weighed = Callable[[Floats, PointGrid], Floats]
"""From differences of curvature times the size ``(n, 5)`` to what each scale adds."""


class Saliency(NamedTuple):
    """How much a surface stands out, from 0 (not at all) to about 5.

    ``vertices`` (n,) and ``faces`` (m,) belong to the given mesh (0 for what has no area; a
    face's is its mean). ``points`` (k, 3) on the surface have ``values`` (k,) and stand for
    ``areas`` (k,) in square metres; ``size`` is the mesh's, in metres. ``grid``, ``order`` and
    ``spacing`` (in units) are for :func:`values_at`.
    """

    vertices: Floats
    faces: Floats
    points: Floats
    values: Floats
    areas: Floats
    size: float
    grid: PointGrid
    order: Ints
    spacing: float


def saliency(mesh: Mesh, weighed: Weighed | None = None) -> Saliency:
    """The saliency of a mesh of any quality: open, of several parts, coarse or with loose faces.

    ``weighed`` brings the differences of the five scales together (:func:`suppress_weak_scales`).

    Takes less than a second for 100,000 triangles; points closer than can matter are put
    together, so that ten times as many take four. What :func:`.mesh_weld.sound` cannot use
    raises :class:`ValueError`.

    >>> cube = Mesh(np.array([[x, y, z] for x in (0.0, 1) for y in (0.0, 1) for z in (0.0, 1)]),
    ...             np.array([[0, 1, 3], [0, 3, 2], [4, 7, 5], [4, 6, 7], [0, 5, 1], [0, 4, 5],
    ...                       [2, 3, 7], [2, 7, 6], [0, 6, 4], [0, 2, 6], [1, 5, 7], [1, 7, 3]]))
    >>> corner, edge, face = values_at(saliency(cube), [[1, 1, 1], [1, 1, 0.5], [1, 0.5, 0.5]])
    >>> bool(corner > edge > 10 * face)
    True
    """
    base = clean_mesh(mesh)
    unit = UNIT * base.size
    every = sample_surface(base.mesh, 2.0 * unit)
    group, samples = _thin_samples(every, unit)
    grid, order = arrange_on_grid(samples.points, unit)
    held = np.stack([samples.area, samples.bend], 1)[order]
    sums = np.zeros((len(order), len(WIDTHS), 2))
    gaussian_sums(grid.points, held, grid.starts, grid.shape, sums)
    levels = contrasts(sums) * base.size
    sorted_values = np.sum((weighed or suppress_weak_scales)(levels, grid), 1)
    values = np.empty(len(order))
    values[order] = sorted_values
    spacing = max(2.0, every.step / unit)
    result = Saliency(
        np.zeros(len(mesh.vertices)),
        np.zeros(len(mesh.faces)),
        samples.points + base.centre,
        values,
        samples.area,
        base.size,
        grid,
        order,
        spacing,
    )
    _hand_back(result, base, every, values[group])
    return result


def contrasts(sums: Floats) -> Floats:
    """|𝒢(σ) - 𝒢(2σ)| ``(n, 5)`` from the sums ``(n, 8, 2)`` of area and curvature.

    A width too small to reach any area (only where points had to be few) takes the next one's.
    """
    mean = np.zeros(sums.shape[:2])
    for k in range(len(WIDTHS) - 1, -1, -1):
        wider = mean[:, min(k + 1, len(WIDTHS) - 1)]
        some = sums[:, k, 0] > 0.0
        mean[:, k] = np.divide(sums[:, k, 1], sums[:, k, 0], out=wider.copy(), where=some)
    twice = [WIDTHS.index(2 * width) for width in WIDTHS[:LEVELS]]
    return np.asarray(np.abs(mean[:, :LEVELS] - mean[:, twice]))


def suppress_weak_scales(levels: Floats, grid: PointGrid) -> Floats:
    """Each scale ``(n, 5)`` brought to [0, 1] and weighed by (1 - mean of the other peaks)².

    Scales without anything above :data:`FAINT` stay as low as they are.
    """
    greatest = levels.max(0)
    shares = levels / np.maximum(greatest, FAINT)
    top = shares > 1e-3
    peaks(grid.points, shares, grid.starts, grid.shape, 1e-9, top)
    weights = np.zeros(LEVELS)
    for k in range(LEVELS):
        found = np.sort(shares[top[:, k], k])[:-1]
        weights[k] = (1.0 - found.mean()) ** 2 if len(found) else 1.0
    return np.asarray(shares * weights)


def arrange_on_grid(points: Floats, unit: float) -> tuple[PointGrid, Ints]:
    """The grid over some points, and their numbers in its order.

    ``points`` (n, 3), ``unit`` in the same length; numbers (n,).
    """
    low = points.min(0) - 1e-3 * unit
    scaled = (points - low) / unit
    cells = (scaled / CELL).astype(np.int64)
    shape = cells.max(0) + 1
    key = (cells[:, 2] * shape[1] + cells[:, 1]) * shape[0] + cells[:, 0]
    order = np.argsort(key, kind="stable")
    starts = np.concatenate([[0], np.cumsum(np.bincount(key, minlength=int(np.prod(shape))))])
    return PointGrid(scaled[order], starts, shape, low, unit), order


def values_at(found: Saliency, places: ArrayLike) -> Floats:
    """Saliency ``(q,)`` at any places ``(q, 3)`` on the surface, 0 away from it."""
    grid = found.grid
    middle = found.points[found.order[0]] - grid.points[0] * grid.unit
    local = (np.asarray(places, np.float64).reshape(-1, 3) - middle) / grid.unit
    out = np.zeros(len(local))
    blend(
        grid.points,
        found.values[found.order],
        grid.starts,
        grid.shape,
        0.5 * found.spacing,
        local,
        out,
    )
    return out


def visual_quality(found: Saliency) -> float:
    """S(O): saliency over the whole surface, as a share of the size's square.

    Zhang and Yang (2023) add up the vertices (:func:`sum_over_vertices`); the area makes it
    independent of their number.
    """
    return float(found.areas @ found.values) / found.size**2


def sum_over_vertices(found: Saliency) -> float:
    """S(O) as printed: the saliency of all vertices of the given mesh, added up. It grows with how
    finely a model is cut into triangles, whatever it looks like."""
    return float(found.vertices.sum())


def relative_quality(qualities: Sequence[float]) -> Floats:
    """τ(O) in (0, 1] over a library: each quality as a share of the greatest (equation 8).

    >>> relative_quality([0.2, 0.8, 0.0]).tolist()
    [0.25, 1.0, 1e-06]
    """
    given = np.asarray(qualities, np.float64)
    greatest = given.max(initial=0.0)
    return np.maximum(given / greatest, 1e-6) if greatest > 0.0 else np.ones(len(given))


def _thin_samples(every: Samples, unit: float) -> tuple[Ints, Samples]:
    """The points, those within a cell put together where there are too many; and for each given
    point the number of the one it went to."""
    group, samples, side = np.arange(len(every.points)), every, 0.4 * unit
    while (pairs := _pairs(samples.points, unit)) > PAIRS:
        side *= max(1.05, (pairs / PAIRS) ** 0.25)
        cells = ((every.points - every.points.min(0)) / side).astype(np.int64)
        reach = cells.max(0) + 1
        key = (cells[:, 2] * reach[1] + cells[:, 1]) * reach[0] + cells[:, 0]
        _, group = np.unique(key, return_inverse=True)
        count = int(group.max()) + 1
        share = every.area + 1e-9 * every.area.sum() / len(group)
        weight = sum_by_name(group, share, count)
        middle = [sum_by_name(group, share * every.points[:, k], count) / weight for k in range(3)]
        area, bend = (sum_by_name(group, held, count) for held in (every.area, every.bend))
        samples = every._replace(points=np.stack(middle, 1), area=area, bend=bend)
    return group, samples


def _pairs(points: Floats, unit: float) -> float:
    """About how many pairs of points are within reach, by counts in cells as wide as that."""
    cells = ((points - points.min(0)) / (2 * WIDTHS[-1] * unit)).astype(np.int64)
    counts = np.zeros(cells.max(0) + 3)
    np.add.at(counts, tuple((cells + 1).T), 1.0)
    near = counts.copy()
    for axis in range(3):
        near = near + np.roll(near, 1, axis) + np.roll(near, -1, axis)
    return float((counts * near).sum()) / 3.0


def _hand_back(result: Saliency, base: CleanMesh, every: Samples, values: Floats) -> None:
    """Fill in what the given vertices and faces have."""
    own = values[: len(base.mesh.vertices)]
    result.vertices[:] = np.where(base.vertex >= 0, own[base.vertex], 0.0)
    means = own[base.mesh.faces].mean(1)
    inside = every.face >= 0
    weight = sum_by_name(every.face[inside], every.area[inside], len(means))
    total = sum_by_name(every.face[inside], (every.area * values)[inside], len(means))
    means = np.divide(total, weight, out=means, where=weight > 0.0)
    result.faces[base.face] = means
