"""Groups of sculptures and globes."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.materials import (
    ACCENT,
    BLACK,
    BRASS,
    BRONZE,
    CONCRETE,
    LEAF_LIGHT,
    OAK_DARK,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import Lines, close_line, oval, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, loft
from scenewright.geometry.solids import ball, block, disc, oval_ring, slab, tube


def _figures(size: Size) -> Parts:
    """Three slender bronze figures of unlike height on one podium."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(0.25, 0.2 * h)
    stood = ((-0.4, -0.1, 1.0, 0.0), (0.1, 0.3, 0.86, 2.0), (0.45, -0.3, 0.7, 4.1))
    wide = 0.26 * min(w, d)
    figures = [
        _figure(wide, top, top + share * (h - top), (x * w, y * d), turn)
        for x, y, share, turn in stood
    ]
    return parts(
        size,
        {
            CONCRETE: [block((-w, w), (-d, d), (0.05, top))],
            BLACK: [block((-w + 0.05, w - 0.05), (-d + 0.05, d - 0.05), (0, 0.05))],
            BRONZE: figures,
        },
    )


def _figure(wide: float, low: float, high: float, at: tuple[float, float], turn: float) -> Mesh:
    """A body that twists upwards: foot, hip, waist, shoulders, neck, head."""
    shape = (
        (0.75, 0.0),
        (0.55, 0.2),
        (0.95, 0.42),
        (0.6, 0.58),
        (1.0, 0.74),
        (0.34, 0.83),
        (0.5, 0.9),
        (0.45, 0.96),
        (0.1, 1.0),
    )
    rings = []
    for share, z in shape:
        a = turn + 1.6 * z
        ring = oval_ring(wide * share, 0.6 * wide * share, low + z * (high - low), 10)
        flat = ring[:, :2] @ np.array([[cos(a), sin(a)], [-sin(a), cos(a)]])
        rings.append(np.column_stack([flat + at, ring[:, 2]]))
    return loft(rings)


def _figures_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    spots = ((-0.4, -0.1), (0.1, 0.3), (0.45, -0.3))
    return rectangle(size), *(oval(x * w, y * d, 0.26 * min(w, d)) for x, y in spots)


def _globe(size: Size) -> Parts:
    """A globe in a ring of brass on a round foot."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    radius = min(0.86 * w, 0.86 * d, 0.42 * h)
    middle = h - 1.08 * radius
    turn = np.linspace(0.1, 2 * pi - 0.1, 25) + pi / 2
    ring = [(1.06 * radius * cos(a), 0.0, middle + 1.06 * radius * sin(a)) for a in turn]
    lands = [
        ball(
            0.5 * radius,
            0.34 * radius,
            0.3 * radius,
            (0.62 * radius * cos(a), 0.62 * radius * sin(a), middle + z * radius),
            9,
            5,
        )
        for a, z in ((0.4, 0.4), (2.2, -0.2), (3.6, 0.45), (5.2, -0.35))
    ]
    base = slab((-w, w), (-d, d), (0, 0.06), 0.45 * min(w, d), 5)
    stem = disc(0.16 * radius, (0.06, middle - 0.9 * radius), sides=12)
    return parts(
        size,
        {
            OAK_DARK: [base, stem],
            ACCENT: [ball(radius, radius, radius, (0, 0, middle), 20, 12)],
            LEAF_LIGHT: lands,
            BRASS: [tube(ring, 0.03 * radius, 6)],
        },
    )


def _globe_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    radius = 0.86 * min(w, d)
    return (
        rectangle(size, 0, 0.45 * min(w, d)),
        oval(0, 0, radius),
        close_line(np.column_stack([[-radius, radius], [0.0, 0.0]])),
    )


_FIGURES = (
    "sculpture statue bronze figure group monument giant skulptur statue bronzegruppe "
    "escultura estatua 雕塑 彫刻"
)
_GLOBES = "globe earth planet moon globus globo 地球仪 地球儀"

ASSETS = (
    Drawing(
        "exhibit_island",
        _figures,
        _figures_symbol,
        id="exhibit_island_figures",
        name="Group of sculptures",
        sizes=(Size(1.5, 1.2, 0.6), Size(3.0, 2.4, 2.4), Size(9.0, 6.0, 4.0)),
        called=tuple(_FIGURES.split()),
    ),
    Drawing(
        "exhibit_island",
        _globe,
        _globe_symbol,
        id="exhibit_island_globe",
        name="Globe",
        sizes=(Size(1.5, 1.2, 0.6), Size(2.4, 2.4, 2.4), Size(9.0, 6.0, 4.0)),
        called=tuple(_GLOBES.split()),
    ),
)
