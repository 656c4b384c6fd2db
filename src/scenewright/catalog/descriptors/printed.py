"""The paper's descriptor: turned to principal axes, sampled on a sphere, energies of harmonics.

Zhang and Fei 2017, section 1: continuous PCA, farthest hits of rays from the centroid scaled to
[0, 1], t_η = √(Σ_ω |h_ηω|²). Blind to size, to colour and to which way is up.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.mesh import Mesh
from scenewright.geometry.principal_axes import principal_axes
from scenewright.geometry.spherical import energies, farthest_hits, harmonics

Floats = NDArray[np.float64]
GRID, DEGREES = 64, 16
"""N of the grid and the number of energies; the paper takes as many as the grid has rows."""


def printed_descriptor(mesh: Mesh) -> Floats:
    """The descriptor (16,) of a surface; the same for any size, place and turn."""
    frame = principal_axes(mesh)
    turned = Mesh((mesh.vertices - frame.centre) @ frame.axes.T, mesh.faces)
    reach = farthest_hits(turned, np.zeros(3), GRID)
    scaled = reach / max(float(reach.max()), 1e-12)
    return energies(harmonics(scaled, DEGREES))
