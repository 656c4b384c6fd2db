"""How like our own drawings of a kind a model is, in each of the 24 ways it can be set down.

A model is described by where its surface lies within its box and which way it faces there: shares
of the area ``(3, N, N, N)`` in N³ cells, parted by the squares of the normal's components, so that
a turn by quarters only reorders them. The energy of a turn under a kind is

    E = ½ Σ|h − t| + 0.5 Σ max(ln(l/s), ln(s/m), 0) + 0.1 Σ|ln(s/u)|

with h the turned description, t that of the nearest drawing of the kind, s the turned sides and
l, u, m the kind's smallest, usual and largest: 0 for the usual drawing itself, about 0.3 to 0.5 for
furniture that stands upright. The idea of an upright pose as what a shape is most at home in is
that of Fu, Cohen-Or, Dror, Sheffer, *Upright orientation of man-made objects* (2008).
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.assets import shipped
from scenewright.catalog.kinds import SIZES
from scenewright.core.catalog import Part
from scenewright.core.scene import Size

Floats = NDArray[np.float64]

CELLS = 6
SAMPLES = 4096
OUTSIDE, UNUSUAL = 0.5, 0.1
"""What a side counts outside the range of its kind, and away from the usual, per factor e."""

UPS = ("top", "front", "back", "right", "left", "bottom")
"""Which side of a model as read is up."""
_STOOD = (
    ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    ((1, 0, 0), (0, 0, -1), (0, 1, 0)),
    ((1, 0, 0), (0, 0, 1), (0, -1, 0)),
    ((0, 0, -1), (0, 1, 0), (1, 0, 0)),
    ((0, 0, 1), (0, 1, 0), (-1, 0, 0)),
    ((1, 0, 0), (0, -1, 0), (0, 0, -1)),
)
_QUARTERS = ((1, 0), (0, 1), (-1, 0), (0, -1))
"""Cosine and sine of the quarter turns counter-clockwise."""


def turn_matrix(up: int, quarters: int) -> Floats:
    """The rotation (3, 3) that sets a side of :data:`UPS` up and then turns by quarters.

    >>> turn_matrix(UPS.index("back"), 0) @ [0.0, -1.0, 0.0]
    array([0., 0., 1.])
    """
    cos, sin = _QUARTERS[quarters]
    around = np.array([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]], np.float64)
    return around @ np.array(_STOOD[up], np.float64) + 0.0


TURNS = np.stack([turn_matrix(up, quarters) for up in range(6) for quarters in range(4)])
"""All 24: six ups, four quarter turns of each."""


def describe_shape(parts: Sequence[Part]) -> Floats:
    """Shares of the surface ``(3, N, N, N)`` by the way it faces and the cell of the box it lies
    in; they sum to 1. Samples lie evenly over the area, always in the same places."""
    corners = np.concatenate([part.vertices[part.faces] for part in parts])
    sides = corners[:, 1:] - corners[:, :1]
    normals = np.cross(sides[:, 0], sides[:, 1])
    areas = np.linalg.norm(normals, axis=1)
    passed = np.cumsum(areas)
    k = np.arange(SAMPLES)
    chosen = np.searchsorted(passed, (k + 0.5) / SAMPLES * passed[-1]).clip(0, len(areas) - 1)
    u, v = (k * 0.7548776662466927) % 1.0, (k * 0.5698402909980532) % 1.0
    u, v = np.where(u + v > 1.0, 1.0 - u, u), np.where(u + v > 1.0, 1.0 - v, v)
    points = corners[chosen, 0] + u[:, None] * sides[chosen, 0] + v[:, None] * sides[chosen, 1]
    facing = (normals[chosen] / areas[chosen, None].clip(1e-300)) ** 2
    low, high = corners.min((0, 1)), corners.max((0, 1))
    return _spread((points - low) / (high - low).clip(1e-300), facing)


def _spread(places: Floats, weights: Floats) -> Floats:
    """Weights ``(n, 3)`` at places in the unit cube shared among the eight cells next to each."""
    scaled = places * CELLS - 0.5
    first = np.floor(scaled).astype(np.int64)
    part = scaled - first
    found = np.zeros((3, CELLS**3))
    for step in itertools.product((0, 1), repeat=3):
        cell = np.clip(first + step, 0, CELLS - 1) @ [CELLS * CELLS, CELLS, 1]
        share = np.where(step, part, 1.0 - part).prod(1)
        for way in range(3):
            found[way] += np.bincount(cell, share * weights[:, way], CELLS**3)
    return (found / max(float(found.sum()), 1e-300)).reshape(3, CELLS, CELLS, CELLS)


def turn_energies(shape: Floats, size: Size, kinds: Sequence[str]) -> Floats:
    """The energy (24,) of each of :data:`TURNS` under the kind it suits best; infinite where no
    kind has drawings and usual sizes."""
    found = np.full(len(TURNS), np.inf)
    for kind in kinds:
        drawings = _drawings(kind)
        if not len(drawings):
            continue
        low, usual, high = np.log(np.array(SIZES[kind]))
        sides = np.log(np.abs(TURNS) @ np.array(size))
        outside = np.maximum(np.maximum(low - sides, sides - high), 0.0).sum(1)
        unusual = np.abs(sides - usual).sum(1)
        turned = np.stack([_turn(shape, matrix).ravel() for matrix in TURNS])
        away = 0.5 * np.abs(turned[:, None] - drawings).sum(2).min(1)
        found = np.minimum(found, away + OUTSIDE * outside + UNUSUAL * unusual)
    return found


def _turn(shape: Floats, matrix: Floats) -> Floats:
    """A description as it is of the model turned by a matrix of quarter turns."""
    source = np.abs(matrix).argmax(1)
    turned: Floats = shape[source].transpose(0, *(source + 1))
    mirrored = tuple(axis + 1 for axis in range(3) if matrix[axis, source[axis]] < 0.0)
    return np.flip(turned, mirrored)


@cache
def _drawings(kind: str) -> Floats:
    """Descriptions ``(k, 3N³)`` of the shipped drawings of a kind at their usual sizes."""
    assets = shipped().of(kind) if kind in SIZES else ()
    rows = [describe_shape(asset.mesh(asset.usual)).ravel() for asset in assets]
    return np.array(rows).reshape(len(rows), 3 * CELLS**3)
