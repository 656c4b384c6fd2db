"""What a walker sees of buildings: rays from eye height along the paths.

Of an eye e, R rays fill the band of directions :data:`BAND` evenly, each for an equal solid
angle. A ray that first meets building b at distance d, at an angle θ to the wall's normal, sees

    v = (q / q*) (1 - d/D)² cos θ,

with q the saliency of the wall per square metre, q* the greatest mean of a side in the library
and D the ``reach`` beyond which nothing counts. The visible quality of the eye is V(e) = Σ v / R,
in [0, 1]: 1 if the best facade stood all round, close by and facing (cut there, as single
triangles may be more salient than q*). Streets reach 0.02 to 0.2.
The sum over the mesh S(O) of Zhang and Yang (2023) counts backs, roofs and courts in full that
nobody sees: :func:`summed_quality`.

Here buildings are boxes, fast enough to be asked while solving; meshes: :mod:`.walker_meshes`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scenewright.geometry.best_view import GOLDEN, directions
from scenewright.geometry.box_grid import BoxGrid, box_grid, first_box
from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

EYE = 1.6
"""Height of the eye above the path, metres."""
BAND = (float(np.deg2rad(-5.0)), float(np.deg2rad(50.0)))
"""How far below and above the horizon walkers look, radians."""
RAYS = 64
REACH = 200.0
"""D: distance in metres at which a building no longer counts; at 60 m it counts half."""


class Sights(NamedTuple):
    """What the rays of p eyes meet. ``eyes`` (p, 3), ``ways`` (r, 3) unit directions, turned at
    each eye by ``turns`` (p,) about the vertical; ``found`` (p, r) building first met or -1,
    ``distances`` (p, r) in metres (infinite: none), ``values`` (p, r) what each ray sees, v."""

    eyes: Floats
    ways: Floats
    turns: Floats
    found: Ints
    distances: Floats
    values: Floats


class VisibleQuality(NamedTuple):
    """Visible quality: ``points`` (p,) V(e) of each eye and ``buildings`` (n,) what each one adds
    to their mean: it is the sum of all buildings'. ``nearest`` (n,) the eye that sees
    most of a building (-1: it is never seen) and ``most`` (n,) what it adds there."""

    points: Floats
    buildings: Floats
    nearest: Ints
    most: Floats


def eyes_along(lines: list[ArrayLike], every: float = 5.0) -> Floats:
    """Points ``(p, 2)`` along lines ``(k, 2)``, evenly spaced on each, about ``every`` metres.

    >>> eyes_along([[(0, 0), (10, 0), (10, 10)]]).tolist()
    [[2.5, 0.0], [7.5, 0.0], [10.0, 2.5], [10.0, 7.5]]
    """
    found = [np.zeros((0, 2))]
    for line in lines:
        points = np.asarray(line, np.float64).reshape(-1, 2)
        gone = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
        count = max(round(gone[-1] / every), 1)
        stops = (np.arange(count) + 0.5) / count * gone[-1]
        found.append(np.stack([np.interp(stops, gone, points[:, k]) for k in range(2)], 1))
    return np.concatenate(found)


def sights(eyes: ArrayLike, rays: int = RAYS, height: float = EYE) -> Sights:
    """Eyes at points ``(p, 2)``, or ``(p, 3)`` with their own heights, that see nothing yet.

    Each eye's rays are turned by the golden angle against the last one's, so that together they
    meet walls everywhere.
    """
    points = np.asarray(eyes, np.float64)
    if points.shape[-1] == 2:
        points = np.column_stack([points, np.full(len(points), height)])
    shape = (len(points), rays)
    return Sights(
        np.ascontiguousarray(points),
        directions(rays, *BAND),
        GOLDEN / rays * np.arange(len(points)),
        np.full(shape, -1, np.int64),
        np.full(shape, np.inf),
        np.zeros(shape),
    )


def sights_of_boxes(
    grid: BoxGrid,
    density: ArrayLike,
    eyes: ArrayLike,
    best: float | None = None,
    rays: int = RAYS,
    reach: float = REACH,
) -> Sights:
    """What eyes see of the buildings of a grid (:func:`scenewright.geometry.box_grid.box_grid`).

    ``density`` (n,) mean saliency of each building's surface, or (n, 5) of its front, left, back
    and right side and roof; ``best`` is q* (left out: the greatest density). 120 buildings from
    200 points by 64 rays take some milliseconds.
    """
    quality = np.asarray(density, np.float64)
    if quality.ndim == 1:
        quality = np.repeat(quality[:, None], 5, 1)
    top = float(quality.max(initial=0.0)) if best is None else best
    made = sights(eyes, rays)
    look(grid, np.ascontiguousarray(quality / (top if top > 0.0 else 1.0)), made, reach)
    return made


@compiled
def look(grid: BoxGrid, quality: Floats, made: Sights, reach: float) -> None:
    """Fill in what all eyes see; ``quality`` (n, 5) is q / q* of each side and roof."""
    for e in range(made.eyes.shape[0]):
        look_from(grid, quality, made, reach, e)


@compiled
def look_from(grid: BoxGrid, quality: Floats, made: Sights, reach: float, e: int) -> float:
    """Fill in what one eye sees; its visible quality V(e).

    ``quality`` (n, 5) of each building's sides and roof, ``reach`` in metres.
    """
    total = 0.0
    for r in range(made.ways.shape[0]):
        look_along(grid, quality, made, reach, e, r)
        total += made.values[e, r]
    return total / made.ways.shape[0]


@inlined
def way_of(made: Sights, e: int, r: int) -> tuple[float, float, float]:
    """The direction of a ray of an eye."""
    c, s = np.cos(made.turns[e]), np.sin(made.turns[e])
    x, y = made.ways[r, 0], made.ways[r, 1]
    return x * c - y * s, x * s + y * c, made.ways[r, 2]


@inlined
def look_along(grid: BoxGrid, quality: Floats, made: Sights, reach: float, e: int, r: int) -> None:
    """Fill in what one ray of an eye sees.

    ``quality`` (n, 5) of each building's sides and roof, ``reach`` in metres.
    """
    x, y, z = made.eyes[e, 0], made.eyes[e, 1], made.eyes[e, 2]
    ax, ay, az = way_of(made, e, r)
    far = min(reach, z / -az) if az < 0.0 else reach
    b, distance, side, cosine = first_box(grid, x, y, z, ax, ay, az, far, -1)
    made.found[e, r], made.values[e, r] = b, 0.0
    if b >= 0 and side >= 0:
        made.values[e, r] = quality[b, side] * (1.0 - distance / reach) ** 2 * cosine
    made.distances[e, r] = distance if b >= 0 else np.inf


def seen_of(made: Sights, count: int) -> VisibleQuality:
    """The visible quality of eyes and of ``count`` buildings."""
    p, r = made.found.shape
    eye, ray = np.nonzero(made.values > 0.0)
    building = made.found[eye, ray]
    pairs, each = np.unique(eye * count + building, return_inverse=True)
    adds = np.bincount(each, made.values[eye, ray], len(pairs)) / max(r, 1)
    at, of = np.divmod(pairs, max(count, 1))
    order = np.argsort(adds, kind="stable")
    nearest, most = np.full(count, -1, np.int64), np.zeros(count)
    nearest[of[order]], most[of[order]] = at[order], adds[order]
    points = np.minimum(made.values.mean(1), 1.0)
    return VisibleQuality(points, np.bincount(of, adds, count) / max(p, 1), nearest, most)


def seen(
    eyes: ArrayLike,
    boxes: ArrayLike,
    heights: ArrayLike,
    density: ArrayLike,
    best: float | None = None,
    rays: int = RAYS,
    reach: float = REACH,
) -> VisibleQuality:
    """The visible quality of buildings ``(n, 5)`` of ``heights`` (n,) from eyes ``(p, 2)``.

    >>> found = seen([[0, 0]], [[0, 30, 0, 20, 20], [0, 60, 0, 20, 20]], [9.0, 9.0], [1.0, 1.0])
    >>> bool(found.points[0] > 0), found.nearest.tolist()
    (True, [0, -1])
    """
    grid = box_grid(boxes, heights)
    return seen_of(sights_of_boxes(grid, density, eyes, best, rays, reach), len(grid.heights))


def summed_quality(density: ArrayLike, sizes: ArrayLike) -> Floats:
    """S(O) ``(n,)`` of boxes: saliency over sides and roof, seen or not (Zhang and Yang 2023).

    ``density`` (n,) or (n, 5) as above; ``sizes`` (n, 3) width, depth and height in metres.

    >>> summed_quality([0.5], [[10, 20, 30]]).tolist()
    [1000.0]
    """
    quality, size = np.asarray(density, np.float64), np.asarray(sizes, np.float64)
    if quality.ndim == 1:
        quality = np.repeat(quality[:, None], 5, 1)
    wide, deep = size[:, 0] * size[:, 2], size[:, 1] * size[:, 2]
    areas = np.stack([wide, deep, wide, deep, size[:, 0] * size[:, 1]], 1)
    return np.asarray((quality * areas).sum(1))
