"""Closed solids to build furniture of: blocks, cushions, rods, bowls, tubes, leaves.

Intervals are ``(low, high)`` pairs in metres. Every function gives a closed mesh whose faces run
counter-clockwise seen from outside.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, pi, sin

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scenewright.geometry.mesh import (
    Floats,
    Mesh,
    extrude,
    loft,
    rotate_mesh,
    translate_mesh,
    volume,
)

Interval = tuple[float, float]
Spot = tuple[float, float]


def block(x: Interval, y: Interval, z: Interval) -> Mesh:
    """A plain box.

    >>> len(block((0, 1), (0, 1), (0, 1)).faces)
    12
    """
    corners = np.array([(px, py, pz) for pz in z for py in y for px in x], np.float64)
    return Mesh(corners, _BLOCK)


_BLOCK = np.array(
    [
        (0, 2, 3),
        (0, 3, 1),
        (4, 5, 7),
        (4, 7, 6),
        (0, 1, 5),
        (0, 5, 4),
        (2, 6, 7),
        (2, 7, 3),
        (0, 4, 6),
        (0, 6, 2),
        (1, 3, 7),
        (1, 7, 5),
    ]
)


def rectangle_ring(
    x: Interval, y: Interval, z: float, radius: float = 0.0, steps: int = 1
) -> Floats:
    """A rectangle at height ``z``, counter-clockwise, its corners rounded in ``steps``."""
    if radius <= 0:
        corners = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])]
        return np.array([(px, py, z) for px, py in corners])
    radius = max(min(radius, (x[1] - x[0]) / 2, (y[1] - y[0]) / 2), 0.0)
    centres = [(x[1], y[1], -1, -1), (x[0], y[1], 1, -1), (x[0], y[0], 1, 1), (x[1], y[0], -1, 1)]
    found = []
    for quarter, (px, py, sx, sy) in enumerate(centres):
        for step in range(steps + 1):
            angle = (quarter + step / steps) * pi / 2
            found.append((px + radius * (sx + cos(angle)), py + radius * (sy + sin(angle)), z))
    return np.array(found)


def oval_ring(rx: float, ry: float, z: float, sides: int, at: Spot = (0.0, 0.0)) -> Floats:
    """An ellipse of ``sides`` points at height ``z``, counter-clockwise."""
    angle = np.arange(sides) * 2 * pi / sides
    return np.column_stack(
        [at[0] + rx * np.cos(angle), at[1] + ry * np.sin(angle), np.full(sides, z)]
    )


def slab(x: Interval, y: Interval, z: Interval, radius: float = 0.02, steps: int = 2) -> Mesh:
    """A plate with corners rounded in plan."""
    return loft([rectangle_ring(x, y, level, radius, steps) for level in z])


def cushion(
    x: Interval, y: Interval, z: Interval, radius: float = 0.04, steps: int = 2, puff: float = 0.0
) -> Mesh:
    """A box with all edges rounded by ``radius``; ``puff`` in [0, 1] draws the sides in towards
    the seams, so that the middle looks filled."""
    radius = min(radius, *((b - a) / 2 for a, b in (x, y, z)))
    levels = [(i / steps - 1) * pi / 2 for i in range(steps + 1)]
    levels = [*levels, *(-a for a in reversed(levels))]
    rings = []
    for k, angle in enumerate(levels):
        middle = z[0] + radius if k <= steps else z[1] - radius
        inset = radius * (1 - cos(angle))
        inset += puff * radius * 0.5 * (k in (0, 2 * steps + 1))
        round_by = max(radius - inset, 1e-12)
        level = middle + radius * sin(angle)
        ring = rectangle_ring(
            _inset_interval(x, inset), _inset_interval(y, inset), level, round_by, steps
        )
        rings.append(ring)
    return loft(rings)


def pad(x: Interval, y: Interval, z: Interval, radius: float, crown: Sequence[float]) -> Mesh:
    """A filled pad that touches its box: edges rounded by ``radius``, and the middle of the sides
    in x, y and z standing out beyond their edges by ``crown`` (3,) metres. With u and v in [-1, 1]
    along a side, its point lies ``crown (1 - u^2)(1 - v^2)`` beyond its edges; 432 triangles.

    >>> soft = pad((0, 0.7), (0, 0.8), (0.3, 0.45), 0.05, (0, 0.01, 0.03))
    >>> len(soft.faces), soft.vertices.max(0).round(3).tolist()
    (432, [0.7, 0.8, 0.45])
    """
    low, high = np.array([x, y, z], np.float64).T
    crown = np.minimum(crown, 0.3 * (high - low))
    middle, half = (low + high) / 2, (high - low) / 2 - crown
    radius = min(radius, 0.95 * float(half.min()))
    on_cube, faces = _gridded_cube(*(_pad_lines(h, radius) for h in half))
    core = np.clip(on_cube, radius - half, half - radius)
    away = on_cube - core
    away *= radius / np.maximum(np.linalg.norm(away, axis=1), 1e-12)[:, None]
    places = core + away
    share = places / half
    swell = 1 - share**2
    out = crown * share * np.roll(swell, 1, axis=1) * np.roll(swell, 2, axis=1)
    return Mesh(middle + places + out, faces)


def _pad_lines(half: float, radius: float) -> Floats:
    """Where the grid of a pad is cut along an axis: in the middle, and twice in its edges."""
    inner = half - radius
    return np.array(
        [-half, -inner - 0.414 * radius, -inner, 0, inner, inner + 0.414 * radius, half]
    )


def _gridded_cube(x: Floats, y: Floats, z: Floats) -> tuple[Floats, NDArray[np.int64]]:
    """A box of grids ``(n, 3)`` with its faces; equal points of two sides are one point."""
    corners, lines = [], (x, y, z)
    for axis in range(3):
        a, b = lines[(axis + 1) % 3], lines[(axis + 2) % 3]
        for end, (p, q) in ((-1, (b, a)), (1, (a, b))):
            grid = np.empty((len(p), len(q), 3))
            first, second = ((axis + 1) % 3, (axis + 2) % 3)[::end]
            grid[..., axis] = lines[axis][0 if end < 0 else -1]
            grid[..., first], grid[..., second] = p[:, None], q[None, :]
            round_it = (grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:])
            corners.append(np.stack(round_it, 2).reshape(-1, 3))
    rows = np.concatenate(corners).round(9) + 0.0
    points, where = np.unique(rows, axis=0, return_inverse=True)
    where = where.reshape(-1, 4)
    return points, np.concatenate([where[:, [0, 1, 2]], where[:, [0, 2, 3]]])


def _inset_interval(span: Interval, inset: float) -> Interval:
    inset = min(inset, (span[1] - span[0]) / 2)
    return span[0] + inset, span[1] - inset


def make_bevelled_box(x: Interval, y: Interval, z: Interval, bevel: float = 0.008) -> Mesh:
    """A box with chamfered edges, 44 triangles."""
    return cushion(x, y, z, bevel, 1)


def rod(
    start: ArrayLike, end: ArrayLike, radius: float, tip: float | None = None, sides: int = 8
) -> Mesh:
    """A round bar from ``start`` to ``end``, tapering to the radius ``tip``."""
    path = np.array([start, end], np.float64)
    return _swept(path, [radius, radius if tip is None else tip], sides)


def leg(
    x: float,
    y: float,
    z: Interval,
    top: float,
    foot: float | None = None,
    sides: int = 8,
    lean: Spot = (0.0, 0.0),
) -> Mesh:
    """An upright leg with flat ends; ``lean`` is how far its foot stands out from its top."""
    foot = top if foot is None else foot
    return loft(
        [
            oval_ring(foot, foot, z[0], sides, (x + lean[0], y + lean[1])),
            oval_ring(top, top, z[1], sides, (x, y)),
        ]
    )


def post(
    x: float, y: float, z: Interval, top: float, foot: float | None = None, lean: Spot = (0.0, 0.0)
) -> Mesh:
    """A square leg of half width ``top`` above and ``foot`` below, flat ends."""
    foot = top if foot is None else foot
    fx, fy = x + lean[0], y + lean[1]
    return loft(
        [
            rectangle_ring((fx - foot, fx + foot), (fy - foot, fy + foot), z[0]),
            rectangle_ring((x - top, x + top), (y - top, y + top), z[1]),
        ]
    )


def tube(path: ArrayLike, radius: float, sides: int = 6) -> Mesh:
    """A bent round bar along a polyline ``(k, 3)``, mitred at the bends."""
    points = np.asarray(path, np.float64)
    return _swept(points, [radius] * len(points), sides)


def limb(path: ArrayLike, radii: Sequence[float], sides: int = 8) -> Mesh:
    """A bent round bar along a polyline ``(k, 3)`` that is ``radii`` (k,) thick at its points."""
    return _swept(np.asarray(path, np.float64), radii, sides)


def _swept(path: Floats, radii: Sequence[float], sides: int) -> Mesh:
    """Circles carried along a polyline without twist, each joint cut in the plane that halves
    the bend."""
    steps = np.diff(path, axis=0)
    steps /= np.linalg.norm(steps, axis=1, keepdims=True)
    mitres = np.concatenate([steps[:1], steps[:-1] + steps[1:], steps[-1:]])
    normal = np.cross(steps[0], np.eye(3)[np.argmin(np.abs(steps[0]))])
    normal /= np.linalg.norm(normal)
    angle = (np.arange(sides) + 0.5) * 2 * pi / sides
    rings = []
    for i, (point, mitre, radius) in enumerate(zip(path, mitres, radii, strict=True)):
        along = steps[max(i - 1, 0)]
        circle = np.outer(np.cos(angle), normal) + np.outer(np.sin(angle), np.cross(along, normal))
        rings.append(point + radius * (circle - np.outer(circle @ mitre / (along @ mitre), along)))
        if 0 < i < len(steps):
            half = along + steps[i]
            normal = normal - half * (half @ normal) / (1 + along @ steps[i])
    return loft(rings)


def lathe(
    profile: Sequence[Spot], at: Spot = (0.0, 0.0), sides: int = 16, squash: float = 1.0
) -> Mesh:
    """A profile of ``(radius, height)`` points turned about the upright axis through ``at``.

    The profile starts and ends near the axis and runs so that the outside lies on its right
    seen from above going out: up the outer face, then down the inner one. ``squash`` scales y.

    >>> len(lathe([(0, 0), (1, 0), (1, 1), (0, 1)], sides=8).faces)
    32
    """
    return loft([oval_ring(max(r, 0.0), max(r, 0.0) * squash, z, sides, at) for r, z in profile])


def disc(
    radius: float, z: Interval, at: Spot = (0.0, 0.0), sides: int = 16, squash: float = 1.0
) -> Mesh:
    """A round plate or cylinder."""
    return loft([oval_ring(radius, radius * squash, level, sides, at) for level in z])


def pipe(outer: float, inner: float, z: Interval, at: Spot = (0.0, 0.0), sides: int = 16) -> Mesh:
    """A hollow cylinder, open above and below."""
    angle = np.arange(sides) * 2 * pi / sides
    circle = np.column_stack([np.cos(angle), np.sin(angle)])
    corners = [(outer, z[0]), (outer, z[1]), (inner, z[1]), (inner, z[0])]
    stack = [np.column_stack([circle * r + at, np.full(sides, level)]) for r, level in corners]
    return connect_rings(np.array(stack))


def frame(x: Interval, y: Interval, z: Interval, rim: float, radius: float = 0.0) -> Mesh:
    """A rectangular frame standing upright: the hole goes through in y, ``rim`` wide all round."""
    inner_x, inner_z = (x[0] + rim, x[1] - rim), (z[0] + rim, z[1] - rim)
    corners = [(x, z, y[1]), (x, z, y[0]), (inner_x, inner_z, y[0]), (inner_x, inner_z, y[1])]
    stack = [
        rectangle_ring(a, b, level, r, 2)[:, [0, 2, 1]]
        for (a, b, level), r in zip(corners, (radius, radius, radius / 2, radius / 2), strict=True)
    ]
    return connect_rings(np.array(stack))


def connect_rings(stack: Floats) -> Mesh:
    """A closed ring of rings ``(k, n, 3)``: sides between each and the next, the last and first."""
    k, n = stack.shape[:2]
    i, j = np.meshgrid(np.arange(k), np.arange(n), indexing="ij")
    a, b = i * n + j, i * n + (j + 1) % n
    c, d = (i + 1) % k * n + (j + 1) % n, (i + 1) % k * n + j
    faces = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)
    return Mesh(stack.reshape(-1, 3), faces)


def trough(
    x: Interval,
    y: Interval,
    z: Interval,
    rim: float,
    floor: float,
    radius: float = 0.0,
    slope: float = 0.0,
    steps: int = 3,
) -> Mesh:
    """A rectangular tub: walls ``rim`` thick at the top, inner floor at height ``floor``, drawn
    in by ``slope`` on the way down."""
    inner = max(radius - rim, 0.01)
    top = rectangle_ring((x[0] + rim, x[1] - rim), (y[0] + rim, y[1] - rim), z[1], inner, steps)
    low = rim + slope
    down = rectangle_ring((x[0] + low, x[1] - low), (y[0] + low, y[1] - low), floor, inner, steps)
    return loft(
        [
            rectangle_ring(x, y, z[0], max(radius, 0.001), steps),
            rectangle_ring(x, y, z[1], max(radius, 0.001), steps),
            top,
            down,
        ]
    )


def ball(
    rx: float, ry: float, rz: float, at: tuple[float, float, float], sides: int = 10, rows: int = 5
) -> Mesh:
    """An ellipsoid around ``at``."""
    levels = [pi * (k / rows - 0.5) for k in range(rows + 1)]
    rings = [
        oval_ring(rx * cos(a), ry * cos(a), at[2] + rz * sin(a), sides, at[:2])
        for a in levels[1:-1]
    ]
    poles = [np.tile([*at[:2], at[2] + s * rz], (sides, 1)) for s in (-1, 1)]
    return loft([poles[0], *rings, poles[1]])


def leaf(
    length: float,
    width: float,
    rise: float,
    droop: float,
    turn: float,
    at: tuple[float, float, float],
) -> Mesh:
    """A thin leaf from ``at`` outwards: ``rise`` is its slope in radians at the root, ``droop``
    how much it bends down along its length, ``turn`` its direction in plan."""
    spine = [(0.0, 0.0, 0.15)]
    angle = rise
    for share, wide in ((0.35, 0.9), (0.35, 0.85), (0.3, 0.0)):
        x, z, _ = spine[-1]
        spine.append((x + share * length * cos(angle), z + share * length * sin(angle), wide))
        angle -= droop / 2
    thick = 0.06 * width
    rings = [
        [
            (x, -w * width / 2, z),
            (x, 0, z - thick * (w + 0.05)),
            (x, w * width / 2, z),
            (x, 0, z + thick * (w + 0.05) * 0.2),
        ]
        for x, z, w in spine[:-1]
    ]
    x, z, _ = spine[-1]
    mesh = loft([*rings, [(x, 0.0, z)] * 4])
    if mesh_is_inside_out(mesh):
        mesh = Mesh(mesh.vertices, mesh.faces[:, ::-1])
    return translate_mesh(rotate_mesh(mesh, "z", turn), *at)


def mesh_is_inside_out(mesh: Mesh) -> bool:
    """Whether the signed volume is negative."""
    return volume(Mesh(mesh.vertices - mesh.vertices.mean(0), mesh.faces)) < 0


def sheet(outline: ArrayLike, y: Interval) -> Mesh:
    """A polygon in the x-z plane, counter-clockwise seen from the back (-y), as a plate in y."""
    mesh = extrude(outline, -y[1], -y[0])
    v = mesh.vertices
    return Mesh(np.column_stack([v[:, 0], -v[:, 2], v[:, 1]]), mesh.faces)


def profile(outline: ArrayLike, x: Interval) -> Mesh:
    """A polygon in the y-z plane, counter-clockwise seen from the right (+x), drawn out in x."""
    mesh = extrude(outline, *x)
    return Mesh(mesh.vertices[:, [2, 0, 1]], mesh.faces)
