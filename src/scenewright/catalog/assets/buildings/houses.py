"""Houses: villa, modernist house, row houses, classical and Japanese residences."""

from __future__ import annotations

from scenewright.catalog.assets.buildings.facades import bays, box, columns, on, rail, row
from scenewright.catalog.assets.buildings.roofs import drawn_in
from scenewright.catalog.assets.materials import GREY, MASONRY, RENDER, SLATE
from scenewright.catalog.assets.model import Parts, parts
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, block, disc


def _modernist_house(size: Size) -> Parts:
    """A white box on slender columns, one strip of window all round, curved walls on the roof."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    low, top = 0.3 * h, 0.7 * h
    x, y = (-w, w), (-d, d)
    spots = [(px, py) for px in row(-0.92 * w, 0.92 * w, 5) for py in (-0.9 * d, 0.9 * d)]
    spots += [(s * 0.92 * w, py) for s in (-1, 1) for py in row(-0.45 * d, 0.45 * d, 3)]
    ground = [
        block((-0.5 * w, 0.6 * w), (-0.7 * d, 0.3 * d), (0, low)),
        disc(0.5 * d, (0, low), (0.05 * w, 0.2 * d), 14),
    ]
    strips = []
    for side, half in (("f", w), ("b", w), ("l", d), ("r", d)):
        strip = [
            block((a + 0.12, b - 0.12), (-0.1, 0.06), (0.45 * h, 0.58 * h))
            for a, b in bays((-0.92 * half, 0.92 * half), 2.6)
        ]
        strips += on(side, x, y, strip)
    curved = [
        disc(0.3 * d, (top, h), (-0.35 * w, -0.1 * d), 14),
        block((-0.35 * w, 0.4 * w), (-0.4 * d, -0.34 * d), (top, 0.94 * h)),
        block((0.3 * w, 0.36 * w), (-0.4 * d, 0.3 * d), (top, 0.86 * h)),
    ]
    ramp = [block((0.45 * w, 0.55 * w), (-0.5 * d, 0.5 * d), (top, 0.76 * h))]
    glazing = [block((-0.4 * w, 0.5 * w), (0.3 * d, 0.34 * d), (0.02 * h, 0.26 * h))]
    door = [block((-0.05 * w, 0.15 * w), (0.66 * d, 0.72 * d), (0, 0.24 * h))]
    return parts(
        size,
        {
            RENDER: [
                box(x, y, (low, top)),
                *columns(spots, (0, low), 0.16, 8),
                *curved,
                *rail(x, y, (top, 0.76 * h), 0.2),
            ],
            SLATE: [*strips, *glazing, *door],
            GREY: [*ground, *ramp],
            MASONRY: [box(drawn_in(x, 0.3), drawn_in(y, 0.3), (top, top + 0.06))],
        },
    )


def _make_stepped_gable(y: Interval, z: Interval, x: float) -> tuple[list[Mesh], list[Mesh]]:
    """A gable wall of five steps, and the tiles that cover each."""
    walls, caps = [], []
    for k, (share, high) in enumerate(((0.0, 0.34), (0.16, 0.67), (0.34, 1.0))):
        a, b = drawn_in(y, share * (y[1] - y[0]))
        top = z[0] + high * (z[1] - z[0])
        walls.append(block((x - 0.3, x + 0.3), (a, b), (z[0] - 0.6 if k == 0 else z[0], top)))
        caps.append(block((x - 0.5, x + 0.5), (a - 0.25, b + 0.25), (top, top + 0.03 * z[1])))
    return walls, caps
