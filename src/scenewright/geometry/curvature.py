"""Mean curvature of triangle meshes, from the angles between neighbouring faces.

On a polyhedron all mean curvature lies in the edges: half the angle between the two normals times
the length (J. Steiner 1840; as a measure that converges on smooth surfaces: D. Cohen-Steiner and
J.-M. Morvan, *Restricted Delaunay triangulations and normal cycle*, 2003). Unlike estimates at
vertices (G. Taubin 1995; M. Meyer et al. 2003) it is exact for buildings, whose corners are sharp;
does not change when a flat face is cut into other triangles; never divides by a small angle or
area; and simply leaves out open and many-faced edges, where there is no angle to speak of.
At a vertex it becomes a density by the areas of Meyer et al.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.mesh import Mesh
from scenewright.geometry.mesh_edges import FaceAdjacency, seams, sides, sum_by_name

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


class Bends(NamedTuple):
    """The seams of a mesh, how far the surface turns there, and how long they are.

    ``angle`` (e,) in radians is positive where the surface is convex, seen from outside.
    """

    seams: FaceAdjacency
    angle: Floats
    length: Floats

    def total(self) -> Floats:
        """Integral ``(e,)`` in metres of the mean curvature over each edge: angle·length/2."""
        return 0.5 * self.angle * self.length


def bends(mesh: Mesh) -> Bends:
    """The angle at every edge with two faces. The mesh must have no face without area.

    Where a surface has only one side (a Moebius strip), one ring of edges gets the angle 0.

    >>> roof = Mesh(np.array([[0.0, 0, 0], [0, 4, 0], [-3, 2, -3], [3, 2, -3]]),
    ...             np.array([[0, 1, 2], [1, 0, 3]]))
    >>> [round(float(x), 6) for x in (bends(roof).angle[0], bends(roof).length[0])]
    [1.570796, 4.0]
    """
    found = seams(mesh.faces)
    side = sides(mesh, found)
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    normals = across * (side / np.linalg.norm(across, axis=1))[:, None]
    one, other = found.faces[:, 0], found.faces[:, 1]
    along = mesh.vertices[found.ends[:, 1]] - mesh.vertices[found.ends[:, 0]]
    length = np.linalg.norm(along, axis=1)
    first, second = normals[one], normals[other]
    sine = np.einsum("ij,ij->i", np.cross(first, second), along) * side[one] / length
    angle = np.arctan2(sine, np.einsum("ij,ij->i", first, second))
    agree = found.alike == (side[one] == side[other])
    return Bends(found, np.where(agree, angle, 0.0), length)


def mean_curvature(mesh: Mesh) -> Floats:
    """Mean curvature ``(n,)`` in 1/m at each vertex, positive where convex, 0 at unused ones.

    Half of each edge's total goes to each end; the area is that of :func:`vertex_areas`.
    1/r on a sphere, 1/(2 r) on a cylinder, 0 on a plane.
    """
    found = bends(mesh)
    half = np.repeat(0.5 * found.total(), 2)
    total = sum_by_name(found.seams.ends.reshape(-1), half, len(mesh.vertices))
    areas = vertex_areas(mesh)
    return np.divide(total, areas, out=np.zeros(len(total)), where=areas > 0.0)


def vertex_areas(mesh: Mesh) -> Floats:
    """Area ``(n,)`` in square metres of the part of the surface nearest to each vertex.

    The mixed areas of M. Meyer, M. Desbrun, P. Schroeder and A. H. Barr (*Discrete
    differential-geometry operators for triangulated 2-manifolds*, 2003): the Voronoi part of each
    triangle, or a half and two quarters of it if it is obtuse. They add up to the whole area.

    >>> sheet = Mesh(np.array([[0.0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]),
    ...              np.array([[0, 1, 2], [0, 2, 3]]))
    >>> vertex_areas(sheet).round(6).tolist()
    [1.0, 1.0, 1.0, 1.0]
    """
    corners = mesh.vertices[mesh.faces]
    ahead = np.roll(corners, -1, 1) - corners
    back = np.roll(corners, 1, 1) - corners
    double = np.linalg.norm(np.cross(ahead[:, 0], back[:, 0]), axis=1)[:, None]
    cosine = np.einsum("fki,fki->fk", ahead, back)
    square = np.einsum("fki,fki->fk", ahead, ahead)  # of the side from corner k to k + 1
    cot = cosine / double
    voronoi = (square * np.roll(cot, -2, 1) + np.roll(square, 1, 1) * np.roll(cot, -1, 1)) / 8
    obtuse = cosine < 0.0
    halves = np.where(obtuse, double / 4, double / 8)
    share = np.where(obtuse.any(1, keepdims=True), halves, voronoi)
    return sum_by_name(mesh.faces.reshape(-1), share.reshape(-1), len(mesh.vertices))
