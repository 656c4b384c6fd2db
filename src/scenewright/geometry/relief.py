"""How much there is to see on a building: relief at several scales, and variety of directions.

Mesh saliency as Lee et al. (2005) print it divides every scale by the model's own greatest value,
so one fine point, a spire, makes all else look plain; and Zhang and Yang (2023) sum it over the
mesh, so slender models, which have little surface for their size, come out low. Repaired here:

* at scale σ a place adds min(σ |𝒢(σ) - 𝒢(2σ)| / ρ, 1) with ρ = (π/4) / (2 √(2π)), what a long
  right-angled edge gives at any scale. So a sharp edge is 1, a plain wall 0, on every model alike;
* the quality of a model is the mean over what is in view from around it, not the sum over all
  its surface, times the variety of the directions in view: a grid of like windows has as much
  relief as a portal, but only the directions of a box.
"""

from __future__ import annotations

import itertools
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry import rays
from scenewright.geometry.best_view import directions, parallel_rays
from scenewright.geometry.gaussians import LEVELS, WIDTHS
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.mesh_weld import clean_mesh
from scenewright.geometry.saliency import UNIT, PointGrid, Saliency, saliency

Floats = NDArray[np.float64]

RIGHT_ANGLE = float(np.pi / 4 / (2.0 * np.sqrt(2.0 * np.pi)))
"""ρ: σ |𝒢(σ) - 𝒢(2σ)| on a long right-angled edge."""
COMPASS = np.array([d for d in itertools.product((-1.0, 0.0, 1.0), repeat=3) if any(d)])
COMPASS /= np.linalg.norm(COMPASS, axis=1)[:, None]
"""The 26 directions (26, 3) from the middle of a cube to its faces, edges and corners."""

VIEWS, STEEPEST = 16, float(np.deg2rad(20.0))


def relief(mesh: Mesh) -> Saliency:
    """The relief of a mesh in [0, 1], in the same form as its saliency.

    >>> from scenewright.geometry.prisms import box
    >>> from scenewright.geometry.saliency import values_at
    >>> found = relief(box((0, 0, 0), (10, 10, 10)))
    >>> edge, wall = values_at(found, [[10, 10, 5], [10, 5, 5]])
    >>> bool(edge > 0.7), bool(wall < 0.01)
    (True, True)
    """
    return saliency(mesh, measure_relief)


def measure_relief(levels: Floats, grid: PointGrid) -> Floats:  # noqa: ARG001
    """What each scale ``(n, 5)`` adds: a fifth of its difference over that of a right angle."""
    scaled = levels * (np.array(WIDTHS[:LEVELS]) * UNIT / RIGHT_ANGLE)
    return np.minimum(scaled, 1.0) / LEVELS


class ReliefView(NamedTuple):
    """What one sees of a model from all round: mean ``relief`` of what is in view, and the
    ``variety`` of directions it faces, both in [0, 1]; the ``quality`` is their product."""

    relief: float
    variety: float

    @property
    def quality(self) -> float:
        """The visual quality of the model."""
        return self.relief * self.variety


def measure_all_round(mesh: Mesh, found: Saliency) -> ReliefView:
    """What a mesh with some relief shows from :data:`VIEWS` directions round it, at eye height
    and from a little above, all views by their share of the pictures.

    Variety is 2^H / 26, H the entropy in bits of the 26 directions that faces in view look to,
    each turned to the eye: the effective number of directions (M. O. Hill, *Diversity and
    evenness*, 1973) as a share of all.

    >>> from scenewright.geometry.prisms import box
    >>> tower = box((0, 0, 0), (20, 20, 60))
    >>> round(measure_all_round(tower, relief(tower)).variety * 26, 1)
    4.5
    """
    base = clean_mesh(mesh)
    caster = rays.build(*mesh[:2])
    relieves, counts = [], np.zeros(len(COMPASS))
    for way in directions(VIEWS, 0.0, STEEPEST):
        starts, along = parallel_rays(way, base.size)
        _, met, normal = rays.hits(caster, starts + base.centre, along)
        there = met >= 0
        relieves.append(found.faces[met[there]])
        towards = normal[there] * np.sign(normal[there] @ way)[:, None]
        counts += np.bincount(np.argmax(towards @ COMPASS.T, axis=1), minlength=len(COMPASS))
    if not counts.any():
        return ReliefView(0.0, 0.0)
    share = counts[counts > 0] / counts.sum()
    entropy = float(-(share * np.log2(share)).sum())
    return ReliefView(float(np.concatenate(relieves).mean()), 2.0**entropy / len(COMPASS))
