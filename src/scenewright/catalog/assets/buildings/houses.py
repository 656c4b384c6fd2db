"""Houses: villa, modernist house, row houses, classical and Japanese residences."""

from __future__ import annotations

from scenewright.catalog.assets.buildings.building_plans import plan, ridge, style, within
from scenewright.catalog.assets.buildings.facades import (
    bays,
    box,
    columns,
    on,
    rail,
    row,
    steps,
    windows,
)
from scenewright.catalog.assets.buildings.roofs import drawn_in, gable, hip, swept
from scenewright.catalog.assets.materials import (
    BRICK,
    CONCRETE,
    GREY,
    LIMESTONE,
    MASONRY,
    PANE,
    RENDER,
    SLATE,
    STONE,
    TEAK,
    TILES,
    TILES_DARK,
    TIMBER,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import path
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, block, disc, sheet


def _villa(size: Size) -> Parts:
    """Two storeys under hips, a gabled bay, a garage at the side, a porch and a chimney."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    eave = 0.62 * h
    main = ((-0.94 * w, 0.5 * w), (-0.9 * d, 0.62 * d))
    bay = ((-0.8 * w, -0.22 * w), (0.5 * d, 0.88 * d))
    garage = ((0.4 * w, 0.94 * w), (-0.6 * d, 0.5 * d))
    roofs = [
        hip((-w, 0.57 * w), (-d, 0.72 * d), (eave, 0.95 * h)),
        gable((-0.86 * w, -0.16 * w), (0.0, 0.94 * d), (eave - 0.02 * h, 0.86 * h), "y"),
        hip((0.36 * w, w), (-0.68 * d, 0.58 * d), (0.34 * h, 0.5 * h)),
    ]
    walls = [
        box(*main, (0, eave)),
        box(*bay, (0, eave)),
        sheet(
            [(bay[0][0], eave), (bay[0][1], eave), ((bay[0][0] + bay[0][1]) / 2, 0.83 * h)],
            (0.6 * d, bay[1][1]),
        ),
        box(*garage, (0, 0.36 * h)),
    ]
    levels = [(0.04 * h, 0.32 * h), (0.34 * h, 0.6 * h)]
    panes = [
        *windows(main[0], main[1], levels, 3.2, 0.42, 0.5, "blr"),
        *windows(bay[0], bay[1], levels, 2.2, 0.6, 0.56, "f"),
        *windows((-0.2 * w, 0.46 * w), main[1], levels[1:], 2.2, 0.46, 0.5, "f"),
    ]
    porch = [
        block((-0.14 * w, 0.34 * w), (0.6 * d, 0.92 * d), (0.31 * h, 0.34 * h)),
        *columns([(x, 0.88 * d) for x in (-0.1 * w, 0.3 * w)], (0, 0.32 * h), 0.02 * w),
    ]
    doors = [
        block((0.0, 0.16 * w), (0.6 * d, 0.64 * d), (0.03 * h, 0.28 * h)),
        block((0.5 * w, 0.84 * w), (0.48 * d, 0.52 * d), (0, 0.28 * h)),
    ]
    chimney = block((0.24 * w, 0.36 * w), (-0.44 * d, -0.28 * d), (eave, h))
    return parts(
        size,
        {
            RENDER: walls,
            TILES: roofs,
            PANE: panes,
            TIMBER: doors,
            BRICK: [chimney],
            LIMESTONE: porch,
            STONE: [
                *steps((-0.14 * w, 0.34 * w), (0.7 * d, d), 0.03 * h, 2),
                block((-0.97 * w, 0.52 * w), (-0.93 * d, 0.65 * d), (0, 0.03 * h)),
            ],
        },
    )


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


def _dormer(x: float, half: float, front: float, d: float, z: Interval, eave: float) -> Mesh:
    """A gable over one dormer from the ridge to ``front``; ``d`` is half the house's depth."""
    return gable((x - half, x + half), (0.1 * d, front), z, "y", eave)


def _row_houses(size: Size) -> Parts:
    """A row of narrow brick houses, each with its door, gable dormer and chimney."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    eave = 0.6 * h
    y = (-0.92 * d, 0.84 * d)
    units = bays((-w, w), 6.0)
    doors, panes, dormers, hoods, chimneys, stoops, trim = [], [], [], [], [], [], []
    for k, (a, b) in enumerate(units):
        at = [a + s * (b - a) for s in ((0.24, 0.7) if k % 2 == 0 else (0.76, 0.3))]
        middle = (a + b) / 2
        doors.append(block((at[0] - 0.5, at[0] + 0.5), (y[1], y[1] + 0.1), (0.05 * h, 0.26 * h)))
        stoops += steps((at[0] - 0.8, at[0] + 0.8), (y[1], d), 0.05 * h, 2)
        spots = [(at[1], 0.08), (at[0], 0.36), (at[1], 0.36)]
        panes += [
            block((px - 0.65, px + 0.65), (y[1], y[1] + 0.08), (z * h, (z + 0.17) * h))
            for px, z in spots
        ]
        panes += [
            block((px - 0.6, px + 0.6), (y[0] - 0.08, y[0]), (z * h, (z + 0.17) * h))
            for px in at
            for z in (0.08, 0.36)
        ]
        dormers.append(_dormer(middle, 1.2, 0.74 * d, d, (0.62 * h, 0.9 * h), 0.14 * h))
        hoods.append(_dormer(middle, 1.35, 0.77 * d, d, (0.75 * h, 0.92 * h), 0.015 * h))
        panes.append(
            block((middle - 0.6, middle + 0.6), (0.72 * d, 0.76 * d), (0.66 * h, 0.75 * h))
        )
        chimneys.append(block((b - 0.9, b - 0.1), (-0.2 * d, 0.0), (0.7 * h, h)))
        if k:
            trim.append(block((a - 0.12, a + 0.12), (y[0], y[1] + 0.12), (0, eave)))
    ends = [
        gable((min(x, x - s * 0.4), max(x, x - s * 0.4)), (-d, 0.92 * d), (0, 0.95 * h), "x", eave)
        for s, x in ((-1, -w), (1, w))
    ]
    return parts(
        size,
        {
            BRICK: [box((-w + 0.1, w - 0.1), y, (0, eave)), *ends, *chimneys],
            LIMESTONE: [*stoops, *trim],
            SLATE: [
                gable((-w + 0.1, w - 0.1), (-0.99 * d, 0.91 * d), (eave, 0.93 * h), "x", 0.01 * h),
                *hoods,
            ],
            RENDER: dormers,
            PANE: panes,
            TIMBER: doors,
        },
    )


def _classical_residence(size: Size) -> Parts:
    """White walls round two courts, dark roofs, gables that step up like stairs."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    eave = 0.6 * h
    halls = [(-0.96 * d, -0.34 * d), (-0.16 * d, 0.28 * d), (0.5 * d, 0.94 * d)]
    highs = [h, 0.92 * h, 0.86 * h]
    walls = [
        block((-0.9 * w, 0.9 * w), y, (0, eave * top / h))
        for y, top in zip(halls, highs, strict=True)
    ]
    walls += [
        block((s * 0.9 * w - 0.35, s * 0.9 * w + 0.35), (-0.96 * d, 0.94 * d), (0, 0.52 * h))
        for s in (-1, 1)
    ]
    roofs, stepped, caps = [], [], []
    for (low, high), top in zip(halls, highs, strict=True):
        roofs.append(
            gable(
                (-0.88 * w, 0.88 * w),
                (low - 0.5, high + 0.5),
                (eave * top / h, 0.88 * top),
                "x",
                0.12,
            )
        )
        for s in (-1, 1):
            made = _make_stepped_gable(
                (low - 0.4, high + 0.4), (eave * top / h, 0.97 * top), s * 0.9 * w
            )
            stepped += made[0]
            caps += made[1]
    panes = [
        block((x * w - 0.5, x * w + 0.5), (0.94 * d, 0.95 * d), (0.3 * h, 0.42 * h))
        for x in (-0.6, 0.6)
    ]
    gate = [
        block((-0.16 * w, 0.16 * w), (0.92 * d, 0.99 * d), (0, 0.34 * h)),
        block((-0.22 * w, 0.22 * w), (0.92 * d, d), (0.4 * h, 0.47 * h)),
    ]
    screens = [
        block((-0.6 * w, 0.6 * w), (y, y + 0.1), (0.04 * h, 0.5 * h)) for y in (-0.34 * d, 0.28 * d)
    ]
    door = [block((-0.1 * w, 0.1 * w), (0.98 * d, 0.996 * d), (0, 0.28 * h))]
    return parts(
        size,
        {
            RENDER: [*walls, *stepped],
            TILES_DARK: [*roofs, *caps, gate[1]],
            STONE: [gate[0], block((-w, w), (-d, d), (0, 0.012 * h))],
            TIMBER: [*panes, *screens, *door],
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


def _lattice(span: Interval, wide: float, z: Interval) -> list[Mesh]:
    """White panels side by side along a wall, each about ``wide`` metres with its posts."""
    return [block((a + 0.06, b - 0.06), (-0.05, 0.06), z) for a, b in bays(span, wide)]


def _veranda_posts(w: float, d: float, h: float, eave: float) -> list[Mesh]:
    """Square posts along the veranda, and lower ones along that of the wing."""
    return [
        block((a - 0.09, a + 0.09), (y - 0.09, y + 0.09), (0, z))
        for xs, y, z in (
            (row(-0.84 * w, 0.3 * w, 6), 0.66 * d, eave),
            (row(0.36 * w, 0.84 * w, 3), 0.86 * d, 0.36 * h),
        )
        for a in xs
    ]


def _japanese_house(size: Size) -> Parts:
    """Timber and white panels on posts, a veranda, a deep hip-and-gable roof, a lower wing."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    floor, eave = 0.08 * h, 0.42 * h
    main = ((-0.8 * w, 0.4 * w), (-0.72 * d, 0.5 * d))
    wing = ((0.34 * w, 0.86 * w), (-0.46 * d, 0.78 * d))
    roofs = [
        swept(
            (-w, 0.6 * w),
            (-d, 0.8 * d),
            (eave, 0.7 * h),
            ((-0.62 * w, 0.22 * w), (-0.5 * d, 0.3 * d)),
            0.03 * h,
        ),
        gable((-0.66 * w, 0.26 * w), (-0.56 * d, 0.36 * d), (0.68 * h, 0.95 * h), "x", 0.02 * h),
        swept(
            (0.2 * w, w),
            (-0.66 * d, 0.96 * d),
            (0.35 * h, 0.62 * h),
            ((0.56 * w, 0.64 * w), (-0.3 * d, 0.6 * d)),
            0.03 * h,
        ),
    ]
    ridge_ = [
        block((-0.68 * w, 0.28 * w), (-0.15 * d, -0.05 * d), (0.93 * h, h)),
        block((0.57 * w, 0.63 * w), (-0.1 * d, 0.64 * d), (0.61 * h, 0.65 * h)),
    ]
    posts = _veranda_posts(w, d, h, eave)
    panels = (floor + 0.1, 0.34 * h)
    lattice = on("f", *main, _lattice((-0.58 * w, 0.52 * w), 0.95, panels))
    lattice += on("l", *main, _lattice((-0.55 * d, 0.55 * d), 1.4, panels))
    deck = [
        block((-0.88 * w, 0.34 * w), (-0.76 * d, 0.72 * d), (0.6 * floor, floor)),
        block((0.3 * w, 0.9 * w), (-0.5 * d, 0.9 * d), (0.5 * floor, floor)),
    ]
    gables = [block((-0.6 * w, -0.58 * w), (-0.3 * d, 0.1 * d), (0.7 * h, 0.8 * h))]
    door = [block((0.48 * w, 0.72 * w), (0.77 * d, 0.8 * d), (floor, 0.33 * h))]
    stones = [block((x, x + 0.5), (0.9 * d, d), (0, 0.03 * h)) for x in (0.5 * w, 0.62 * w)]
    return parts(
        size,
        {
            TIMBER: [box(*main, (0, eave + 0.01 * h)), *posts, *gables, *door],
            RENDER: [*lattice, box(*wing, (0, 0.38 * h))],
            TEAK: deck,
            TILES_DARK: [*roofs, *ridge_],
            MASONRY: stones,
            CONCRETE: [box(*main, (0, 0.3 * floor), 0.3)],
        },
    )


ASSETS = (
    style(
        "villa",
        "Villa",
        _villa,
        plan(
            within(-1, 0.57, -1, 0.72),
            path((-0.4, -0.14), (-0.02, -0.14)),
            within(0.36, 1, -0.68, 0.58),
            door=(0.1, 1.0),
        ),
        (14, 12, 9),
    ),
    style(
        "modernist_house",
        "Modernist house",
        _modernist_house,
        plan(within(-0.92, 0.92, -0.92, 0.92)),
        (21, 18, 9.5),
    ),
    style("row_houses", "Row houses", _row_houses, plan(path((-1, 0), (1, 0))), (36, 11, 10)),
    style(
        "classical_residence",
        "Classical residence",
        _classical_residence,
        plan(within(-0.9, 0.9, -0.34, -0.16), within(-0.9, 0.9, 0.28, 0.5)),
        (16, 28, 9),
    ),
    style(
        "japanese_house",
        "Japanese house",
        _japanese_house,
        plan(*ridge(0.5), door=(0.6, 1.0)),
        (20, 14, 8),
    ),
)
