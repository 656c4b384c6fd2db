"""Mosques: a hall under a pointed dome with four minarets."""

from __future__ import annotations

from math import pi

from scenewright.catalog.assets.buildings.building_plans import plan, ring, style, within
from scenewright.catalog.assets.buildings.facades import arch, arches, box, on, row, steps
from scenewright.catalog.assets.buildings.roofs import dome, regular, spire
from scenewright.catalog.assets.materials import GILT, PANE, SANDSTONE, STONE, TIMBER, TURQUOISE
from scenewright.catalog.assets.model import Parts, parts
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh
from scenewright.geometry.solids import Spot, block, disc, lathe


def _mosque_openings(w: float, d: float, h: float) -> list[Mesh]:
    """Pointed openings of the front and of both sides."""
    return [
        *arches(
            [s * x * w for s in (-1, 1) for x in (0.37, 0.52, 0.67)],
            (0.02 * h, 0.18 * h),
            0.11 * w,
            (0.77 * d, 0.79 * d),
            True,
            2,
        ),
        *(
            m
            for side in "lr"
            for m in on(
                side,
                (-0.84 * w, 0.84 * w),
                (-0.86 * d, 0.78 * d),
                arches(
                    row(-0.6 * d, 0.6 * d, 5), (0.04 * h, 0.19 * h), 0.13 * d, (-0.1, 0.12), True, 2
                ),
            )
        ),
    ]


def _drum_lights(h: float, reach: float) -> list[Mesh]:
    """Eight pointed windows round the drum of the dome."""
    return [
        rotate_mesh(
            arch(0.0, (0.37 * h, 0.44 * h), 0.16 * reach, (0.85 * reach, 0.89 * reach), True, 2),
            "z",
            k * pi / 4,
        )
        for k in range(8)
    ]


def _mosque(size: Size) -> Parts:
    """A hall under a pointed dome, a high portal, arcades, a minaret at each corner."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    wall, face, reach = 0.26 * h, 0.9 * d, 0.5 * min(w, d)
    corners = [(sx * 0.9 * w, sy * 0.86 * d) for sx in (-1, 1) for sy in (-1, 1)]
    walls = [
        block((-0.84 * w, 0.84 * w), (-0.86 * d, 0.78 * d), (0, wall)),
        block((-0.26 * w, 0.26 * w), (0.5 * d, face), (0, 0.42 * h)),
        regular(1.02 * reach, (wall, 0.36 * h)),
        disc(0.88 * reach, (0.34 * h, 0.46 * h), sides=16),
    ]
    rounds = [_minaret(0.075 * w, h, spot) for spot in corners]
    cornice = [
        box((-0.84 * w, 0.84 * w), (-0.86 * d, 0.78 * d), (wall - 0.02 * h, wall + 0.01 * h), 0.25),
        block((-0.27 * w, 0.27 * w), (0.49 * d, face + 0.2), (0.41 * h, 0.43 * h)),
    ]
    domes = [
        dome(0.92 * reach, (0.45 * h, 0.76 * h), sides=16, rows=5, bulge=0.12),
        *(
            dome(0.17 * w, (wall, 0.39 * h), (sx * 0.62 * w, sy * 0.56 * d), 8, 3, 0.12)
            for sx in (-1, 1)
            for sy in (-1, 1)
        ),
        *(spire(*spot, (0.86 * h, 0.97 * h), 0.07 * w, 6, tip=0.15) for spot in corners),
    ]
    openings = _mosque_openings(w, d, h)
    lights = _drum_lights(h, reach)
    portal = [arch(0.0, (0.02 * h, 0.37 * h), 0.38 * w, (face - 0.1, face + 0.1), pointed=True)]
    door = [arch(0.0, (0.02 * h, 0.2 * h), 0.16 * w, (face, face + 0.2), pointed=True)]
    tips = [
        *(spire(*spot, (0.96 * h, h), 0.016 * w, 4, tip=0.4) for spot in corners),
        spire(0.0, 0.0, (0.75 * h, 0.85 * h), 0.025 * w, 6, tip=0.3),
    ]
    return parts(
        size,
        {
            SANDSTONE: walls,
            STONE: [*rounds, *cornice, *steps((-0.4 * w, 0.4 * w), (0.78 * d, d), 0.02 * h, 2)],
            TURQUOISE: [*domes, *portal],
            PANE: [*openings, *lights],
            TIMBER: door,
            GILT: tips,
        },
    )


def _minaret(radius: float, h: float, at: Spot) -> Mesh:
    """A slender tower with two galleries."""
    shape = [
        (1.3, 0.0),
        (1.3, 0.1),
        (0.95, 0.12),
        (0.88, 0.5),
        (1.4, 0.53),
        (1.4, 0.56),
        (0.8, 0.56),
        (0.7, 0.78),
        (1.2, 0.8),
        (0.66, 0.82),
        (0.66, 0.87),
    ]
    return lathe([(r * radius, z * h) for r, z in shape], at, 6)


ASSETS = (
    style(
        "mosque",
        "Mosque",
        _mosque,
        plan(
            within(-0.84, 0.84, -0.86, 0.78),
            ring(0.46),
            *(ring(0.08, x, y) for x in (-0.9, 0.9) for y in (-0.86, 0.86)),
        ),
        (44, 44, 40),
    ),
)
