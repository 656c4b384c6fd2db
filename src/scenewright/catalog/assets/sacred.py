"""Churches and mosques: Gothic, Byzantine, Baroque, Islamic."""

from __future__ import annotations

from itertools import pairwise
from math import pi

from scenewright.catalog.assets.building_plans import plan, ring, style, within
from scenewright.catalog.assets.facades import arch, arches, box, columns, on, pediment, row, steps
from scenewright.catalog.assets.materials import (
    BRICK,
    GILT,
    LIMESTONE,
    MASONRY,
    OCHRE,
    PANE,
    RENDER,
    SANDSTONE,
    SLATE,
    STONE,
    TILES,
    TIMBER,
    TURQUOISE,
    VERDIGRIS,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.roofs import bell, dome, gable, hip, regular, spire, vault
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import Interval, Spot, block, disc, lathe


def _gothic_church(size: Size) -> Parts:
    """Nave, lower aisles, buttresses with pinnacles, transept, two towers with spires."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    nave, aisle, wall = 0.42 * w, 0.76 * w, 0.4 * h
    back, front = -0.96 * d, 0.72 * d
    bay = row(back + 0.06 * d, 0.56 * d, 9)
    tower = 0.4 * w
    stone = [
        block((-nave, nave), (back, front), (0, wall)),
        block((-aisle, aisle), (back + 0.04 * d, front), (0, 0.22 * h)),
        block((-0.98 * w, 0.98 * w), (-0.36 * d, -0.06 * d), (0, wall)),
        block((-nave, nave), (front, 0.94 * d), (0, 0.44 * h)),
        *(
            block(
                (s * 0.7 * w - tower / 2, s * 0.7 * w + tower / 2),
                (0.68 * d, 0.96 * d),
                (0, 0.58 * h),
            )
            for s in (-1, 1)
        ),
        pediment((-nave, nave), (0.9 * d, 0.94 * d), (0.44 * h, 0.56 * h)),
    ]
    for s in (-1, 1):
        stone += [
            block((s * x - 0.05 * w, s * x + 0.05 * w), (y - 0.3, y + 0.3), (0, top * h))
            for y in bay
            for x, top in ((0.8 * w, 0.26),)
        ]
        stone += [spire(s * 0.8 * w, y, (0.26 * h, 0.34 * h), 0.55, 4, pi / 4, 0.3) for y in bay]
        stone += [
            spire(s * 0.7 * w + a * 0.18 * w, y, (0.56 * h, 0.68 * h), 0.06 * w, 4, pi / 4, 0.3)
            for a in (-1, 1)
            for y in (0.71 * d, 0.93 * d)
        ]
    roofs = [
        gable((-nave - 0.3, nave + 0.3), (back, 0.9 * d), (wall, 0.58 * h), "y"),
        gable((-w, w), (-0.37 * d, -0.05 * d), (wall, 0.56 * h)),
        *(
            _lean_to(s, nave, aisle + 0.3, (back + 0.04 * d, front), (0.22 * h, 0.3 * h))
            for s in (-1, 1)
        ),
        *(spire(s * 0.7 * w, 0.82 * d, (0.58 * h, h), 0.52 * tower, 8, tip=0.12) for s in (-1, 1)),
        spire(0.0, -0.21 * d, (0.52 * h, 0.76 * h), 0.1 * w, 8, tip=0.2),
    ]
    glass = _gothic_windows(w, d, h, bay, (nave, aisle))
    doors = [
        arch(x, (0.02 * h, top * h), wide * w, (0.93 * d, 0.975 * d), pointed=True)
        for x, top, wide in ((0.0, 0.2, 0.34), (-0.7 * w, 0.15, 0.2), (0.7 * w, 0.15, 0.2))
    ]
    entry = steps((-0.95 * w, 0.95 * w), (0.9 * d, d), 0.02 * h, 2)
    return parts(size, {MASONRY: [*stone, *entry], SLATE: roofs, PANE: glass, TIMBER: doors})


def _gothic_windows(
    w: float, d: float, h: float, bay: list[float], half: tuple[float, float]
) -> list[Mesh]:
    """Pointed windows of nave, aisles and towers, and the rose."""
    nave, aisle = half
    found: list[Mesh] = []
    middles = [(a + b) / 2 for a, b in pairwise(bay)]
    middles = [y for y in middles if not -0.42 * d < y < 0.0]
    for s, side in ((-1, "l"), (1, "r")):
        for reach, low, high in ((nave, 0.3, 0.39), (aisle, 0.06, 0.19)):
            panes = [arch(0.0, (low * h, high * h), 1.5, (-0.1, 0.12), True, 4) for _ in middles]
            for pane, y in zip(panes, middles, strict=True):
                found += on(side, (-reach, reach), (y - 0.01, y + 0.01), [pane])
        found += [
            arch(s * 0.7 * w, (low * h, high * h), 0.16 * w, (0.95 * d, 0.97 * d), True, 4)
            for low, high in ((0.2, 0.34), (0.38, 0.54))
        ]
    rose = rotate_mesh(disc(0.27 * w, (-0.2, 0.2), sides=16), "x", -pi / 2)
    return [*found, translate_mesh(rose, 0.0, 0.94 * d, 0.33 * h)]


def _lean_to(s: int, inner: float, outer: float, y: Interval, z: Interval) -> Mesh:
    """A roof that leans against a higher wall to its middle."""
    x = (inner, outer) if s > 0 else (-outer, -inner)
    top = (inner, inner + 0.01) if s > 0 else (-inner - 0.01, -inner)
    low = hip(x, y, z)
    points = low.vertices.copy()
    high = points[:, 2] > (z[0] + z[1]) / 2
    points[high, 0] = top[0] if s > 0 else top[1]
    points[high, 1] = [y[0] if v < (y[0] + y[1]) / 2 else y[1] for v in points[high, 1]]
    return Mesh(points, low.faces)


def _byzantine_church(size: Size) -> Parts:
    """A cross under a great dome on a drum, half domes around it, bands of brick and stone."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    core, arm = 0.62 * min(w, d), 0.46 * min(w, d)
    wall = 0.46 * h
    brick = [
        block((-core, core), (-core, core), (0, 0.52 * h)),
        block((-0.92 * w, 0.92 * w), (-arm, arm), (0, 0.4 * h)),
        block((-arm, arm), (-0.92 * d, 0.86 * d), (0, 0.4 * h)),
        block((-0.9 * w, 0.9 * w), (-0.84 * d, 0.72 * d), (0, 0.26 * h)),
        regular(0.58 * core, (0.5 * h, 0.68 * h), sides=12),
    ]
    stone = [
        box((-0.9 * w, 0.9 * w), (-0.84 * d, 0.72 * d), (z * h, (z + 0.018) * h), 0.12)
        for z in (0.06, 0.13, 0.2, 0.255)
    ]
    stone += [
        box((-core, core), (-core, core), (0.5 * h, 0.53 * h), 0.2),
        block((-0.86 * w, 0.86 * w), (0.7 * d, d), (0, 0.015 * h)),
        *columns([(x, 0.93 * d) for x in row(-0.8 * w, 0.8 * w, 6)], (0, 0.17 * h), 0.022 * w),
        block((-0.86 * w, 0.86 * w), (0.7 * d, d), (0.17 * h, 0.2 * h)),
    ]
    roofs = [
        vault((-0.94 * w, 0.94 * w), (-arm, arm), (0.4 * h, 0.52 * h), "x", 8),
        vault((-arm, arm), (-0.94 * d, 0.88 * d), (0.4 * h, 0.52 * h), "y", 8),
        dome(0.62 * core, (0.68 * h, 0.93 * h), rows=5),
        *(
            dome(0.24 * core, (wall * 0.98, 0.62 * h), (sx * 0.7 * core, sy * 0.7 * core), 8, 3)
            for sx in (-1, 1)
            for sy in (-1, 1)
        ),
        dome(0.5 * arm, (0.24 * h, 0.4 * h), (0.0, -0.92 * d + 0.3 * arm), 12, 4),
    ]
    drums = [
        disc(0.24 * core, (0.4 * h, wall), (sx * 0.7 * core, sy * 0.7 * core), 8)
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    glass = [
        rotate_mesh(
            arch(0.0, (0.55 * h, 0.65 * h), 0.12 * core, (0.56 * core, 0.59 * core), steps=2),
            "z",
            (k + 0.5) * pi / 6,
        )
        for k in range(12)
    ]
    glass += [
        m
        for side, reach in (("f", 0.86 * d), ("l", 0.92 * w), ("r", 0.92 * w))
        for m in on(
            side,
            (-reach, reach),
            (-reach, reach),
            arches((-0.5 * arm, 0.0, 0.5 * arm), (0.28 * h, 0.39 * h), 0.3 * arm, (-0.1, 0.12)),
        )
    ]
    doors = arches((-0.36 * w, 0.0, 0.36 * w), (0, 0.13 * h), 0.16 * w, (0.7 * d, 0.74 * d))
    cross = [
        block((-0.12, 0.12), (-0.12, 0.12), (0.92 * h, h)),
        block((-0.5, 0.5), (-0.1, 0.1), (0.965 * h, 0.975 * h)),
    ]
    return parts(
        size,
        {
            BRICK: [*brick, *drums],
            LIMESTONE: stone,
            VERDIGRIS: roofs,
            PANE: glass,
            TIMBER: doors,
            GILT: cross,
        },
    )


def _baroque_church(size: Size) -> Parts:
    """A front in two orders between towers with curved caps, a dome over the crossing."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    wall, tower = 0.36 * h, 0.3 * w
    face = 0.86 * d
    walls = [
        block((-0.62 * w, 0.62 * w), (-0.94 * d, 0.8 * d), (0, wall)),
        block((-0.94 * w, 0.94 * w), (-0.5 * d, 0.06 * d), (0, wall)),
        block((-0.5 * w, 0.5 * w), (0.6 * d, face), (0, 0.56 * h)),
        *(
            block(
                (s * 0.8 * w - tower / 2, s * 0.8 * w + tower / 2), (0.58 * d, face), (0, 0.62 * h)
            )
            for s in (-1, 1)
        ),
        disc(0.44 * w, (wall, 0.6 * h), (0, -0.22 * d), 12),
        disc(0.5 * w, (0, 0.3 * h), (0, -0.86 * d + 0.3 * w), 12),
    ]
    lines = [(x, face + 0.2) for x in (-0.46 * w, -0.3 * w, -0.16 * w, 0.16 * w, 0.3 * w, 0.46 * w)]
    trim = [
        *columns(lines, (0.02 * h, 0.27 * h), 0.022 * w, 6),
        *columns(lines, (0.31 * h, 0.51 * h), 0.018 * w, 6),
        block((-0.97 * w, 0.97 * w), (0.56 * d, face + 0.25), (0.27 * h, 0.3 * h)),
        block((-0.52 * w, 0.52 * w), (face - 0.3, face + 0.5), (0.27 * h, 0.31 * h)),
        block((-0.54 * w, 0.54 * w), (0.58 * d, face + 0.5), (0.51 * h, 0.55 * h)),
        pediment((-0.5 * w, 0.5 * w), (face - 0.6, face + 0.4), (0.55 * h, 0.66 * h)),
        *(
            block(
                (s * 0.8 * w - 0.55 * tower, s * 0.8 * w + 0.55 * tower),
                (0.57 * d, face + 0.3),
                (0.6 * h, 0.63 * h),
            )
            for s in (-1, 1)
        ),
        *(
            lathe(
                [(0.4, 0.31 * h), (0.7, 0.33 * h), (0.25, 0.36 * h), (0, 0.38 * h)],
                (s * 0.56 * w, face),
                6,
            )
            for s in (-1, 1)
        ),
        disc(0.47 * w, (0.57 * h, 0.61 * h), (0, -0.22 * d), 12),
    ]
    roofs = [
        gable((-0.66 * w, 0.66 * w), (-0.96 * d, 0.7 * d), (wall, 0.48 * h), "y"),
        gable((-0.97 * w, 0.97 * w), (-0.52 * d, 0.08 * d), (wall, 0.47 * h)),
    ]
    caps = [
        *(bell(0.62 * tower, (0.63 * h, 0.9 * h), (s * 0.8 * w, 0.72 * d)) for s in (-1, 1)),
        dome(0.46 * w, (0.61 * h, 0.84 * h), (0, -0.22 * d), 12),
        bell(0.13 * w, (0.83 * h, h), (0, -0.22 * d)),
    ]
    glass = [
        *arches((-0.8 * w, 0.8 * w), (0.36 * h, 0.5 * h), 0.12 * w, (face - 0.1, face + 0.15)),
        *arches((-0.38 * w, 0.38 * w), (0.08 * h, 0.2 * h), 0.09 * w, (face - 0.1, face + 0.15)),
        arch(0.0, (0.34 * h, 0.49 * h), 0.2 * w, (face - 0.1, face + 0.15)),
    ]
    sides = [
        m
        for s in "lr"
        for m in on(
            s,
            (-0.62 * w, 0.62 * w),
            (-0.9 * d, 0.8 * d),
            arches(
                [y for y in row(-0.7 * d, 0.5 * d, 6) if abs(y) > 0.1 * d],
                (0.12 * h, 0.3 * h),
                1.8,
                (-0.1, 0.12),
            ),
        )
    ]
    entry = [arch(0.0, (0.02 * h, 0.2 * h), 0.2 * w, (face - 0.1, face + 0.25))]
    return parts(
        size,
        {
            OCHRE: walls,
            RENDER: [*trim, *steps((-0.6 * w, 0.6 * w), (face, d), 0.02 * h, 3)],
            TILES: roofs,
            VERDIGRIS: caps,
            PANE: [*glass, *sides],
            TIMBER: entry,
        },
    )


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
    openings = [
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
    lights = [
        rotate_mesh(
            arch(0.0, (0.37 * h, 0.44 * h), 0.16 * reach, (0.85 * reach, 0.89 * reach), True, 2),
            "z",
            k * pi / 4,
        )
        for k in range(8)
    ]
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
        "gothic_church",
        "Gothic church",
        _gothic_church,
        plan(
            within(-0.42, 0.42, -0.96, 0.9),
            within(-0.98, 0.98, -0.36, -0.06),
            within(-0.9, -0.5, 0.68, 0.96),
            within(0.5, 0.9, 0.68, 0.96),
        ),
        (30, 60, 56),
    ),
    style(
        "byzantine_church",
        "Byzantine church",
        _byzantine_church,
        plan(within(-0.9, 0.9, -0.84, 0.72), ring(0.38), within(-0.92, 0.92, -0.46, 0.46)),
        (34, 36, 28),
    ),
    style(
        "baroque_church",
        "Baroque church",
        _baroque_church,
        plan(
            within(-0.62, 0.62, -0.94, 0.8), ring(0.44, 0, -0.22), within(-0.95, 0.95, 0.58, 0.86)
        ),
        (32, 48, 42),
    ),
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
