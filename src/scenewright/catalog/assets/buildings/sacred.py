"""Churches: Gothic, Byzantine, Baroque."""

from __future__ import annotations

from itertools import pairwise
from math import pi

from scenewright.catalog.assets.buildings.building_plans import plan, ring, style, within
from scenewright.catalog.assets.buildings.facades import (
    arch,
    arches,
    box,
    columns,
    on,
    pediment,
    row,
    steps,
)
from scenewright.catalog.assets.buildings.roofs import bell, dome, gable, hip, regular, spire, vault
from scenewright.catalog.assets.materials import (
    BRICK,
    GILT,
    LIMESTONE,
    MASONRY,
    OCHRE,
    PANE,
    RENDER,
    SLATE,
    TILES,
    TIMBER,
    VERDIGRIS,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import Interval, block, disc, lathe


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


def _byzantine_windows(w: float, d: float, h: float, core: float, arm: float) -> list[Mesh]:
    """Round-arched windows: twelve in the drum of the dome, three at each end of the cross."""
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
    return glass


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
    glass = _byzantine_windows(w, d, h, core, arm)
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


def _baroque_trim(w: float, d: float, h: float, face: float) -> list[Mesh]:
    """Columns in two orders, cornices, pediment, scrolls and the ring of the drum."""
    tower = 0.3 * w
    lines = [(x, face + 0.2) for x in (-0.46 * w, -0.3 * w, -0.16 * w, 0.16 * w, 0.3 * w, 0.46 * w)]
    return [
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


def _baroque_windows(w: float, d: float, h: float, face: float) -> list[Mesh]:
    """Arched windows of towers, front and both sides of the nave."""
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
    return [*glass, *sides]


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
    trim = _baroque_trim(w, d, h, face)
    roofs = [
        gable((-0.66 * w, 0.66 * w), (-0.96 * d, 0.7 * d), (wall, 0.48 * h), "y"),
        gable((-0.97 * w, 0.97 * w), (-0.52 * d, 0.08 * d), (wall, 0.47 * h)),
    ]
    caps = [
        *(bell(0.62 * tower, (0.63 * h, 0.9 * h), (s * 0.8 * w, 0.72 * d)) for s in (-1, 1)),
        dome(0.46 * w, (0.61 * h, 0.84 * h), (0, -0.22 * d), 12),
        bell(0.13 * w, (0.83 * h, h), (0, -0.22 * d)),
    ]
    glass = _baroque_windows(w, d, h, face)
    entry = [arch(0.0, (0.02 * h, 0.2 * h), 0.2 * w, (face - 0.1, face + 0.25))]
    return parts(
        size,
        {
            OCHRE: walls,
            RENDER: [*trim, *steps((-0.6 * w, 0.6 * w), (face, d), 0.02 * h, 3)],
            TILES: roofs,
            VERDIGRIS: caps,
            PANE: glass,
            TIMBER: entry,
        },
    )


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
)
