"""Things that belong to the building: radiator, column, staircase, fireplace, boxes."""

from __future__ import annotations

from scenewright.catalog.assets.materials import CARDBOARD, LINEN, OAK, PLASTER, RUBBER, SLATE
from scenewright.catalog.assets.model import Parts, parts
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import block, rod

PARCEL = 0.7
"""Longest side in metres that a parcel has; larger boxes stand for furniture of the user's own."""


def _box(size: Size) -> Parts:
    """A parcel with tape; if large a plain body on a recessed foot, under a top."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    if max(size.width, size.depth) > PARCEL:
        foot, top = min(0.08, 0.1 * h), min(0.04, 0.1 * h)
        return parts(
            size,
            {
                SLATE: [block((-w + 0.03, w - 0.03), (-d + 0.03, d - 0.03), (0, foot))],
                PLASTER: [block((-w + 0.01, w - 0.01), (-d + 0.01, d - 0.01), (foot, h - top))],
                OAK: [block((-w, w), (-d, d), (h - top, h))],
            },
        )
    tape = min(0.025, 0.2 * d)
    return parts(
        size,
        {
            CARDBOARD: [block((-w, w), (-d + 0.001, d - 0.001), (0, h - 0.001))],
            LINEN: [block((-w + 0.001, w - 0.001), (-tape, tape), (h - 0.01, h))],
            RUBBER: [
                block((0.2 * w, 0.7 * w), (d - 0.002, d), (0.35 * h, 0.6 * h)),
                block((0.2 * w, 0.7 * w), (-d, -d + 0.002), (0.35 * h, 0.6 * h)),
            ],
        },
    )


def _railing(
    x: float, d: float, rise: float, run: float, h: float
) -> tuple[list[Mesh], list[Mesh]]:
    """Handrails 0.9 m above the noses on both sides, up to the height ``h``, and their bars."""
    tall = min(0.9, 0.5 * h)
    steps = int((h - tall - rise) / rise)
    if steps < 1:
        return [], []
    spots = [(d - 0.04 - k * run, (k + 1) * rise) for k in range(steps + 1)]
    (y0, z0), (y1, z1) = spots[0], spots[-1]
    rails = [
        rod((s * x, y0, z0 + tall - 0.02), (s * x, y1, z1 + tall - 0.02), 0.02, sides=8)
        for s in (-1, 1)
    ]
    bars = [
        rod((s * x, y, z - 0.05), (s * x, y, z + tall - 0.02), 0.009, sides=4)
        for s in (-1, 1)
        for y, z in spots
    ]
    return rails, bars
