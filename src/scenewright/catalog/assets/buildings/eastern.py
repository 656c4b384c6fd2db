"""East Asian buildings: palace hall, pagoda, garden pavilion, Buddhist temple."""

from __future__ import annotations

from scenewright.catalog.assets.buildings.facades import arch, arches, columns, row, steps
from scenewright.catalog.assets.buildings.roofs import gable, spire
from scenewright.catalog.assets.materials import (
    GILT,
    LIMESTONE,
    MASONRY,
    OCHRE,
    RENDER,
    TILES,
    TIMBER,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, Spot, block, disc, lathe


def _three_gables(w: float, h: float, d: float, y: Interval) -> tuple[list[Mesh], list[Mesh]]:
    """Three gables, each narrower, higher and further in than the one below, and their finials."""
    tiers = ((0.8, 0.0, 0.3, 0.58), (0.62, 0.09, 0.42, 0.68), (0.46, 0.18, 0.54, 0.78))
    roofs = [
        gable(
            (-wide * w, wide * w), (y[0] + s * d, y[1] - s * d), (low * h, high * h), "y", 0.01 * h
        )
        for wide, s, low, high in tiers
    ]
    finials = [
        spire(0.0, y[1] - s * d - 0.2, (high * h - 0.2, high * h + 0.08 * h), 0.4, 4, tip=0.3)
        for _, s, _, high in tiers
    ]
    return roofs, finials


def _stupa(radius: float, z: Interval, at: Spot) -> Mesh:
    """A bell on rings that ends in a needle; ``z`` from its terrace to its tip."""
    shape = [
        (1, z[0] / z[1]),
        (1, 0.16),
        (0.86, 0.17),
        (0.86, 0.24),
        (0.98, 0.26),
        (0.9, 0.36),
        (0.66, 0.48),
        (0.4, 0.56),
        (0.4, 0.6),
        (0.3, 0.61),
        (0.2, 0.72),
        (0.11, 0.84),
        (0.06, 1.0),
    ]
    return lathe([(r * radius, s * z[1]) for r, s in shape], at, 14)


def _buddhist_temple(size: Size) -> Parts:
    """A hall under three gables one in front of the other, a bell-shaped stupa behind it."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    base = 0.08 * h
    hall_y = (-0.2 * d, 0.78 * d)
    roofs, finials = _three_gables(w, h, d, hall_y)
    at, wide = (0.0, -0.6 * d), 0.36 * min(w, d)
    stupa = _stupa(wide, (base, h), at)
    spots = [(x, 0.7 * d) for x in row(-0.68 * w, 0.68 * w, 6)]
    spots += [(s * 0.7 * w, y) for s in (-1, 1) for y in row(-0.14 * d, 0.5 * d, 4)]
    portal = [
        arch(0.0, (base, 0.27 * h), 0.24 * w, (0.56 * d, 0.59 * d), pointed=True),
        *arches(
            (-0.34 * w, 0.34 * w),
            (base + 0.02 * h, 0.24 * h),
            0.13 * w,
            (0.56 * d, 0.58 * d),
            pointed=True,
        ),
    ]
    return parts(
        size,
        {
            LIMESTONE: [
                block((-0.96 * w, 0.96 * w), (-d, 0.88 * d), (0, base)),
                *steps((-0.3 * w, 0.3 * w), (0.85 * d, d), base, 4),
            ],
            RENDER: [
                block((-0.56 * w, 0.56 * w), (-0.14 * d, 0.57 * d), (base, 0.36 * h)),
                block((-0.44 * w, 0.44 * w), (-0.1 * d, 0.57 * d), (base, 0.49 * h)),
                block((-0.3 * w, 0.3 * w), (0.0, 0.57 * d), (base, 0.6 * h)),
                *columns(spots, (base, 0.32 * h), 0.028 * w),
            ],
            OCHRE: [
                block((-w, -0.93 * w), (-d, 0.86 * d), (0, 0.14 * h)),
                block((0.93 * w, w), (-d, 0.86 * d), (0, 0.14 * h)),
            ],
            TILES: roofs,
            GILT: [stupa, *finials, disc(0.03, (base, base + 0.05), at, 6)],
            TIMBER: portal,
            MASONRY: [disc(1.15 * wide, (base, 0.12 * h), at, 14)],
        },
    )
