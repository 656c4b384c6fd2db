"""East Asian buildings: palace hall, pagoda, garden pavilion, Buddhist temple."""

from __future__ import annotations

from itertools import pairwise

from scenewright.catalog.assets.buildings.building_plans import plan, ridge, ring, style, within
from scenewright.catalog.assets.buildings.facades import (
    arch,
    arches,
    bays,
    box,
    columns,
    rail,
    row,
    steps,
)
from scenewright.catalog.assets.buildings.roofs import (
    bell,
    drawn_in,
    gable,
    regular,
    spire,
    swept,
    swept_round,
)
from scenewright.catalog.assets.materials import (
    GILT,
    LIMESTONE,
    MASONRY,
    OCHRE,
    RENDER,
    STONE,
    TILES,
    TILES_DARK,
    TILES_GOLDEN,
    TIMBER,
    VERDIGRIS,
    VERMILION,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, Spot, block, disc, lathe


def _palace(size: Size) -> Parts:
    """A hall with two eaves on a terrace of three steps, columns all along the front."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    base, lower, upper = 0.17 * h, 0.5 * h, 0.66 * h
    terrace = [
        block((-w + s, w - s), (-d + s, d - s), (a * base / 3, (a + 1) * base / 3))
        for a, s in ((0, 0.0), (1, 0.04 * w), (2, 0.08 * w))
    ]
    hall, porch = ((-0.72 * w, 0.72 * w), (-0.66 * d, 0.42 * d)), 0.56 * d
    doors = [
        block((a + 0.5, b - 0.5), (hall[1][1], hall[1][1] + 0.12), (base, base + 0.26 * h))
        for a, b in bays(drawn_in(hall[0], 0.5), 4.2)
    ]
    spots = [(x, y) for y in (porch, -porch - 0.2 * d) for x in row(-0.76 * w, 0.76 * w, 10)]
    eaves = [
        swept(
            (-0.9 * w, 0.9 * w),
            (-0.92 * d, 0.74 * d),
            (lower, upper),
            ((-0.62 * w, 0.62 * w), (-0.5 * d, 0.3 * d)),
            0.05 * h,
        ),
        swept(
            (-0.78 * w, 0.78 * w),
            (-0.72 * d, 0.56 * d),
            (0.73 * h, 0.95 * h),
            ((-0.5 * w, 0.5 * w), (-0.1 * d, -0.06 * d)),
            0.05 * h,
        ),
    ]
    ridges = [
        block((-0.5 * w, 0.5 * w), (-0.12 * d, -0.04 * d), (0.94 * h, 0.97 * h)),
        *(
            block((x - 0.6, x + 0.6), (-0.14 * d, -0.02 * d), (0.94 * h, h))
            for x in (-0.5 * w, 0.5 * w)
        ),
    ]
    flight = steps((-0.22 * w, 0.22 * w), (0.7 * d, d), base, 5)
    return parts(
        size,
        {
            STONE: [
                *terrace,
                *flight,
                *rail((-0.92 * w, 0.92 * w), (-0.92 * d, 0.7 * d), (base, base + 0.9), 0.3),
            ],
            VERMILION: [
                box(*hall, (base, 0.735 * h)),
                *columns(spots, (base, lower + 0.2), 0.45, 6),
            ],
            TIMBER: doors,
            TILES_GOLDEN: [*eaves, *ridges],
            VERDIGRIS: [
                box((-0.76 * w, 0.76 * w), (-0.78 * d, 0.58 * d), (lower - 0.06 * h, lower))
            ],
        },
    )


def _pagoda(size: Size) -> Parts:
    """Eight-sided storeys, each with its own eaves, drawn in towards a spire of rings."""
    w, h = min(size.width, size.depth) / 2, size.height
    base, top = 0.05 * h, 0.84 * h
    count = max(3, round((top - base) / 5.8))
    walls, eaves, doors, galleries = [], [], [], []
    levels = [base + (top - base) * k / count for k in range(count + 1)]
    for k, (low, high) in enumerate(pairwise(levels)):
        inner = 0.64 * w * (1 - 0.5 * k / count)
        above = 0.64 * w * (1 - 0.5 * (k + 1) / count)
        wall = low + 0.62 * (high - low)
        last = k == count - 1
        walls.append(regular(inner, (low, wall + 0.1)))
        eaves.append(
            swept_round(
                inner + 0.33 * w,
                (wall, high + (last * 0.05 * h)),
                lift=0.05 * w,
                top=0.3 if last else above - 0.05,
            )
        )
        half, reach, door = (
            0.24 * inner,
            0.925 * inner + 0.1,
            (low + 0.1, low + 0.46 * (high - low)),
        )
        doors += [
            block((-half, half), (-reach, reach), door),
            block((-reach, reach), (-half, half), door),
        ]
    crown = 0.89 * h
    ornament = [
        lathe(
            [
                (r * w, crown - 0.04 * h + s * 0.15 * h)
                for r, s in (
                    (0.1, 0),
                    (0.14, 0.2),
                    (0.05, 0.3),
                    (0.11, 0.45),
                    (0.04, 0.55),
                    (0.08, 0.7),
                    (0.05, 0.8),
                    (0.035, 1.0),
                )
            ],
            sides=8,
        )
    ]
    galleries.append(regular(0.97 * w, (0, 0.5 * base)))
    flights = steps((-0.2 * w, 0.2 * w), (0.7 * w, w), base, 4)
    return parts(
        size,
        {
            STONE: [*galleries, regular(0.8 * w, (0.5 * base, base)), *flights],
            VERMILION: walls,
            TIMBER: doors,
            TILES_DARK: eaves,
            GILT: ornament,
        },
    )


def _pavilion(size: Size) -> Parts:
    """A garden pavilion: six columns, a balustrade, two swept roofs one over the other."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    base, eave = 0.1 * h, 0.46 * h
    spots = [
        (0.66 * w * x, 0.66 * d * y)
        for x, y in ((0.5, 0.866), (-0.5, 0.866), (-1, 0), (-0.5, -0.866), (0.5, -0.866), (1, 0))
    ]
    benches = [
        _between(a, b, (base, base + 0.09 * h))
        for a, b in zip(spots[1:], spots[2:] + spots[:1], strict=True)
    ]
    roofs = [
        swept_round(w, (eave, 0.64 * h), sides=6, top=0.42 * w, lift=0.07 * h),
        swept_round(0.66 * w, (0.68 * h, 0.92 * h), sides=6, top=0.04 * w, lift=0.06 * h),
    ]
    roofs = [Mesh(m.vertices * (1.0, d / w, 1.0), m.faces) for m in roofs]
    plinth = [
        Mesh(m.vertices * (1.0, d / w, 1.0), m.faces)
        for m in (
            regular(0.92 * w, (0, base / 2), sides=6),
            regular(0.82 * w, (base / 2, base), sides=6),
        )
    ]
    neck = regular(0.4 * w, (0.55 * h, 0.7 * h), sides=6)
    beams = [
        _between(a, b, (eave - 0.07 * h, eave))
        for a, b in zip(spots, spots[1:] + spots[:1], strict=True)
    ]
    knob = bell(0.09 * w, (0.9 * h, h))
    flight = steps((-0.3 * w, 0.3 * w), (0.7 * d, 0.96 * d), base, 3)
    return parts(
        size,
        {
            STONE: [*plinth, *flight],
            VERMILION: [*columns(spots, (base, eave + 0.05 * h), 0.035 * w), neck],
            TIMBER: [*benches, *beams],
            TILES_DARK: roofs,
            GILT: [knob],
        },
    )


def _between(a: tuple[float, float], b: tuple[float, float], z: Interval) -> Mesh:
    """A thin upright plate from one spot to another."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = (dx * dx + dy * dy) ** 0.5
    ux, uy, half = dx / length, dy / length, 0.02 * length
    plate = block((0.0, length), (-half, half), z)
    x, y, level = plate.vertices.T
    turned = [a[0] + x * ux - y * uy, a[1] + x * uy + y * ux, level]
    return Mesh(plate.vertices * 0 + list(zip(*turned, strict=True)), plate.faces)


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


ASSETS = (
    style(
        "palace",
        "Palace hall",
        _palace,
        plan(within(-0.8, 0.8, -0.75, 0.6), *ridge(0.5)),
        (60, 34, 28),
    ),
    style("pagoda", "Pagoda", _pagoda, plan(ring(0.95), ring(0.6), ring(0.3)), (16, 16, 50)),
    style("pavilion", "Garden pavilion", _pavilion, plan(ring(0.95), ring(0.6)), (9, 9, 8.5)),
    style(
        "buddhist_temple",
        "Buddhist temple",
        _buddhist_temple,
        plan(within(-0.8, 0.8, -0.2, 0.78), within(-0.02, 0.02, -0.2, 0.78), ring(0.3, 0, -0.6)),
        (24, 32, 24),
    ),
)
