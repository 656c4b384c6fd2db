"""How buildings of a site are composed: directions, those along the border, ground far from any.

Measured on footprints alone, of the designer and of ours alike; nothing is shared with the solver.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

Floats = NDArray[np.float64]
BIN = math.radians(10.0)
ALONG, ASLANT = 25.0, math.radians(15.0)
"""Metres from the border up to which a building stands along it, and how far its sides may turn
from it."""
FAR = 25.0
"""Metres from a building beyond which ground is void."""
SMOOTH = 1.0
"""Metres by which a border is drawn more simply before its direction is read."""


def measure_composition(
    outline: shapely.Polygon,
    shapes: NDArray[np.object_],
    headings: Floats,
    parks: Sequence[shapely.Polygon] = (),
) -> dict[str, float]:
    """The figures of some footprints (n,) with ``headings`` (n,) on the ground of an outline;
    ``parks`` are void that is made something of."""
    near = share_along_border(outline, shapes, headings)
    far = shapely.union_all(shapely.buffer(shapes, FAR))
    ground = shapely.make_valid(outline)
    void = shapely.difference(ground, far)
    return {
        "directions": entropy(headings, math.pi),
        "grids": entropy(headings, math.pi / 2),
        "along_border": near,
        "void": float(void.area / ground.area),
        "bare": float(shapely.difference(void, shapely.union_all(parks)).area / ground.area),
    }


def entropy(headings: Floats, turn: float) -> float:
    """Entropy in nats of headings in bins of 10 degrees, those a ``turn`` apart being one.

    >>> round(entropy(np.radians([0.0, 90.0, 180.0, 270.0]), math.pi), 3)
    0.693
    """
    if not len(headings):
        return 0.0
    bins = np.round((headings % turn) / BIN).astype(int) % round(turn / BIN)
    shares = np.bincount(bins) / len(bins)
    shares = shares[shares > 0.0]
    return float(-(shares * np.log(shares)).sum())


def share_along_border(
    outline: shapely.Polygon, shapes: NDArray[np.object_], headings: Floats
) -> float:
    """The share of buildings near the border with a side along the edge of it that is nearest.

    >>> square = shapely.box(0.0, 0.0, 200.0, 200.0)
    >>> two = np.array([shapely.box(10.0, 10.0, 30.0, 20.0), shapely.box(90.0, 90.0, 99.0, 99.0)])
    >>> share_along_border(square, two, np.zeros(2))
    0.5
    """
    if not len(shapes):
        return 0.0
    ring = shapely.get_coordinates(shapely.simplify(outline, SMOOTH).exterior)
    steps = np.diff(ring, axis=0)
    edges = shapely.linestrings(np.stack([ring[:-1], ring[1:]], 1))
    apart = shapely.distance(shapes[:, None], edges[None])
    nearest = apart.argmin(1)
    along = np.arctan2(steps[nearest, 1], steps[nearest, 0])
    off = np.abs((headings - along + math.pi / 4) % (math.pi / 2) - math.pi / 4)
    return float(((apart.min(1) <= ALONG) & (off <= ASLANT)).mean())
