"""Whether small objects stand: measured on the meshes of a finished scene, by rays.

An object rests where its lowest points meet what it stands on. It is stable if its centre of mass
lies over the convex hull of these points in plan, the *support polygon* (McGhee, Frank 1968); its
*margin* is the distance of the centre from the edge of the polygon, below 0 outside it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.clutter.rows import SOFT
from scenewright.clutter.surfaces import Floats
from scenewright.clutter.tops import to_level
from scenewright.core.catalog import Catalog, Part
from scenewright.core.scene import CLUTTER, Piece, Scene
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.rays import build, hits
from scenewright.render.items import parts_of

FOOT = 0.003
"""Metres above its lowest point up to which an object's points are its foot."""
TOUCH = 0.004
"""Greatest gap in metres between a foot and what it rests on."""
SOFT_GIVES = 0.05
"""The same on and of what gives way: cushions, seats, beds."""
LEAST = 0.001
"""The least margin of a stable object, metres."""
_INSIDE = np.array([0.9, 0.87])
"""Shares of the way from the middle to the rim: not alike, so that no ray runs along an edge."""
_ABOVE = {False: 0.01, True: 0.6}


class Standing(NamedTuple):
    """How a small object stands: the share of the points of its foot that rest on something, and
    the margin of its centre of mass in metres."""

    piece: Piece
    resting: float
    margin: float

    @property
    def stable(self) -> bool:
        """Whether its centre is over what it rests on."""
        return self.margin > LEAST


def measure_standing(scene: Scene, catalog: Catalog) -> tuple[Standing, ...]:
    """How each small object of a scene stands on the piece it is on."""
    named = {piece.id: piece for piece in scene.pieces}
    found = (
        standing
        for on, small in _by_carrier(scene.pieces).items()
        for standing in _on_one(named[on], small, catalog)
    )
    return tuple(found)


def _by_carrier(pieces: Sequence[Piece]) -> dict[str, list[Piece]]:
    carried: dict[str, list[Piece]] = {}
    for piece in pieces:
        if piece.function == CLUTTER:
            carried.setdefault(piece.on or "", []).append(piece)
    return carried


def keep_standing(pieces: Sequence[Piece], small: Sequence[Piece], catalog: Catalog) -> list[Piece]:
    """The stable small objects, without unstable ones and whatever rests on those."""
    named = {piece.id: piece for piece in (*pieces, *small)}
    fallen = {
        one.piece.id
        for on, group in _by_carrier(small).items()
        for one in _on_one(named[on], group, catalog)
        if not one.stable
    }
    kept = list[Piece]()
    for piece in small:  # what carries comes first
        if piece.id in fallen or piece.on in fallen:
            fallen.add(piece.id)
        else:
            kept.append(piece)
    return kept


def _on_one(carrier: Piece, small: Sequence[Piece], catalog: Catalog) -> Iterator[Standing]:
    bearing = _placed(carrier, parts_of(carrier, catalog))
    caster = build(bearing.vertices, bearing.faces)
    soft = carrier.category in SOFT
    for piece in small:
        parts = parts_of(piece, catalog)
        mesh = _placed(piece, parts)
        centre = _centre_of_mass(mesh)
        foot = _foot(mesh, soft)
        start = foot + np.array([0.0, 0.0, _ABOVE[soft]])
        depth, _, _ = hits(caster, start, np.tile([0.0, 0.0, -1.0], (len(foot), 1)))
        gap = depth - _ABOVE[soft]
        rests = gap <= (SOFT_GIVES if soft else TOUCH)
        yield Standing(
            piece, float(rests.sum()) / max(len(foot), 1), _margin(foot[rests, :2], centre[:2])
        )


def _placed(piece: Piece, parts: Sequence[Part]) -> Mesh:
    """The mesh of a piece in the frame of its level."""
    mesh = merge([Mesh(part.vertices, part.faces) for part in parts])
    plan = to_level(piece, mesh.vertices[:, :2])
    return Mesh(np.column_stack([plan, mesh.vertices[:, 2] + piece.pose.z]), mesh.faces)


def _centre_of_mass(mesh: Mesh) -> Floats:
    """The middle of what a closed mesh encloses: the mean of its tetrahedra by volume."""
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    volume = np.einsum("ij,ij->i", a, np.cross(b, c))
    centre: Floats = ((a + b + c) * volume[:, None]).sum(0) / (4 * volume.sum())
    return centre


def _foot(mesh: Mesh, soft: bool) -> Floats:
    """Points (n, 3) by which an object may rest: the rim of its lowest ones, drawn in a
    little; of one on something soft, on which it also leans, all of its underside and back."""
    if soft:
        return mesh.vertices
    base = mesh.vertices[:, 2].min()
    low = mesh.vertices[mesh.vertices[:, 2] <= base + FOOT, :2]
    ring = shapely.get_coordinates(shapely.convex_hull(shapely.multipoints(low)))
    shares = np.linspace(0, 1, 5)[1:, None, None]
    plan = (ring[:-1] + shares * np.diff(ring, axis=0)).reshape(-1, 2)
    plan = low.mean(0) + _INSIDE * (plan - low.mean(0))
    return np.column_stack([plan, np.full(len(plan), base)])


def _margin(points: Floats, centre: Floats) -> float:
    """How far a centre is inside the hull of points; negative outside, -1 without a hull."""
    hull = shapely.convex_hull(shapely.multipoints(points)) if len(points) else None
    if hull is None or hull.geom_type != "Polygon":
        return -1.0
    middle = shapely.Point(centre)
    edge = float(shapely.distance(shapely.get_exterior_ring(hull), middle))
    return edge if shapely.contains(hull, middle) else -edge
