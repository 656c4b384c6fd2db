"""Churches: Gothic, Byzantine, Baroque."""

from __future__ import annotations

from itertools import pairwise
from math import pi

from scenewright.catalog.assets.buildings.facades import arch, on
from scenewright.catalog.assets.buildings.roofs import hip
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import Interval, disc


def _gothic_windows(
    w: float, d: float, h: float, bay: list[float], half: tuple[float, float]
) -> list[Mesh]:
    """Pointed windows of nave, aisles and towers, and the rose."""
    nave, aisle = half
    found: list[Mesh] = []
    middles = [(a + b) / 2 for a, b in pairwise(bay)]
    middles = [y for y in middles if not -0.42 * d < y < 0.0]
    for s, side in ((-1, "l"), (1, "r")):
        for reach, low, high in ((nave, 0.3, 0.39), (aisle, 0.06, 0.19)):
            panes = [arch(0.0, (low * h, high * h), 1.5, (-0.1, 0.12), True, 4) for _ in middles]
            for pane, y in zip(panes, middles, strict=True):
                found += on(side, (-reach, reach), (y - 0.01, y + 0.01), [pane])
        found += [
            arch(s * 0.7 * w, (low * h, high * h), 0.16 * w, (0.95 * d, 0.97 * d), True, 4)
            for low, high in ((0.2, 0.34), (0.38, 0.54))
        ]
    rose = rotate_mesh(disc(0.27 * w, (-0.2, 0.2), sides=16), "x", -pi / 2)
    return [*found, translate_mesh(rose, 0.0, 0.94 * d, 0.33 * h)]


def _lean_to(s: int, inner: float, outer: float, y: Interval, z: Interval) -> Mesh:
    """A roof that leans against a higher wall to its middle."""
    x = (inner, outer) if s > 0 else (-outer, -inner)
    top = (inner, inner + 0.01) if s > 0 else (-inner - 0.01, -inner)
    low = hip(x, y, z)
    points = low.vertices.copy()
    high = points[:, 2] > (z[0] + z[1]) / 2
    points[high, 0] = top[0] if s > 0 else top[1]
    points[high, 1] = [y[0] if v < (y[0] + y[1]) / 2 else y[1] for v in points[high, 1]]
    return Mesh(points, low.faces)
