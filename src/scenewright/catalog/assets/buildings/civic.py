"""Public buildings: gallery, museum, gymnasium, Rococo palace."""

from __future__ import annotations

from math import cos, pi, sin

from scenewright.catalog.assets.buildings.building_plans import plan, ridge, ring, style, within
from scenewright.catalog.assets.buildings.facades import (
    arches,
    bays,
    box,
    columns,
    pediment,
    piers,
    rail,
    row,
    steps,
    windows,
)
from scenewright.catalog.assets.buildings.roofs import (
    bell,
    dome,
    drawn_in,
    gable,
    loft_rectangles,
    regular,
)
from scenewright.catalog.assets.materials import (
    BLUSH,
    CONCRETE,
    CURTAIN_WALL,
    GILT,
    LIMESTONE,
    MASONRY,
    METAL_SHEET,
    PANE,
    RENDER,
    SLATE,
    STEEL,
    STONE,
    TIMBER,
    VERDIGRIS,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, Spot, block, disc, lathe, profile, sheet

Rectangle = tuple[Interval, Interval]
"""An upright box in plan: from x to x, from y to y."""


def _gallery(size: Size) -> Parts:
    """Shifted white boxes for pictures under saw-tooth rooflights, a glass foyer, a ramp."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    low = ((-w, 0.2 * w), (-0.9 * d, 0.6 * d))
    tall = ((0.1 * w, 0.86 * w), (-d, 0.3 * d))
    over = ((-0.76 * w, 0.44 * w), (-0.3 * d, 0.86 * d))
    foyer = ((-0.5 * w, 0.9 * w), (0.1 * d, 0.7 * d))
    lights, panes = _rooflights(w, d, h)
    fins = [
        block((x - 0.12, x + 0.12), (0.7 * d, 0.74 * d), (0, 0.4 * h))
        for x in row(-0.48 * w, 0.88 * w, 15)
    ]
    slots = [
        block((-0.7 * w, 0.38 * w), (0.86 * d, 0.865 * d), (0.52 * h, 0.6 * h)),
        block((0.858 * w, 0.866 * w), (-0.7 * d, -0.3 * d), (0.2 * h, 0.6 * h)),
        block((0.5 * w, 0.7 * w), (0.3 * d, 0.305 * d), (0.56 * h, 0.76 * h)),
    ]
    ramp = [
        profile([(0.72 * d, 0), (d, 0), (0.72 * d, 0.05 * h)], (0.5 * w, 0.72 * w)),
        block((0.72 * w, 0.735 * w), (0.74 * d, d), (0, 0.1 * h)),
    ]
    door = [block((0.52 * w, 0.7 * w), (0.69 * d, 0.735 * d), (0.02 * h, 0.26 * h))]
    return parts(
        size,
        {
            RENDER: [
                box(*low, (0, 0.55 * h)),
                box(*tall, (0, 0.86 * h)),
                box(*over, (0.4 * h, 0.68 * h)),
                *lights,
            ],
            CURTAIN_WALL: [box(*foyer, (0, 0.4 * h)), *panes],
            STEEL: fins,
            SLATE: [*slots, *door],
            MASONRY: [
                box(drawn_in(x, 0.7), drawn_in(y, 0.7), (z * h, z * h + 0.05))
                for (x, y), z in ((low, 0.55), (tall, 0.86), (over, 0.68))
            ],
            CONCRETE: [
                block((-0.6 * w, w), (0.05 * d, d), (0, 0.02 * h)),
                *ramp,
                box(foyer[0], foyer[1], (0.39 * h, 0.42 * h), 0.3),
                *columns(
                    [(x, 0.8 * d) for x in (-0.7 * w, -0.1 * w, 0.38 * w)], (0, 0.41 * h), 0.25
                ),
            ],
        },
    )


def _rooflights(w: float, d: float, h: float) -> tuple[list[Mesh], list[Mesh]]:
    """Saw-tooth rooflights over the low and the tall box, and the panes of their upright sides."""
    bands = [
        (a, b, x, z)
        for x, y, z in (
            ((-0.94 * w, 0.08 * w), (-0.88 * d, -0.34 * d), 0.55 * h),
            ((0.16 * w, 0.8 * w), (-0.96 * d, 0.26 * d), 0.86 * h),
        )
        for a, b in bays(y, 5.0)
    ]
    lights = [profile([(a, z), (b, z), (a, z + 0.14 * h)], x) for a, b, x, z in bands]
    panes = [
        profile(
            [(a - 0.05, z + 0.02 * h), (a + 0.02, z + 0.02 * h), (a - 0.05, z + 0.125 * h)],
            (x[0] + 0.5, x[1] - 0.5),
        )
        for a, _, x, z in bands
    ]
    return lights, panes


def _museum(size: Size) -> Parts:
    """A temple front at the head of a flight of steps, wings with pilasters, a low dome."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    base, eave = 0.12 * h, 0.56 * h
    wings = ((-w, w), (-0.9 * d, 0.4 * d))
    centre = ((-0.36 * w, 0.36 * w), (-d, 0.62 * d))
    front = 0.8 * d
    spots = [(x, front - 0.4) for x in row(-0.33 * w, 0.33 * w, 8)]
    spots += [(s * 0.33 * w, front - 0.14 * d) for s in (-1, 1)]
    capitals = [
        block((x - 0.75, x + 0.75), (y - 0.75, y + 0.75), (eave - 0.05 * h, eave)) for x, y in spots
    ]
    bases = [
        block((x - 0.75, x + 0.75), (y - 0.75, y + 0.75), (base, base + 0.03 * h)) for x, y in spots
    ]
    wing_w = 0.62 * w
    sides = [((-w, -w + wing_w), wings[1]), ((w - wing_w, w), wings[1])]
    pilasters = [p for x, y in sides for p in piers(x, y, (base, 0.5 * h), 6.0, 0.9, 0.25, "f")]
    panes = [
        p for x, y in sides for p in windows(x, y, [(base, 0.5 * h)], 6.0, 0.4, 0.6, "fb", 0.2)
    ]
    panes += [
        p
        for s, (x, y) in zip("lr", sides, strict=True)
        for p in windows(x, y, [(base, 0.5 * h)], 6.0, 0.4, 0.6, s, 0.2)
    ]
    trim = [
        box(*wings, (0.5 * h, 0.54 * h), 0.35),
        box(*wings, (0, base), 0.2),
        block((-0.38 * w, 0.38 * w), (-d, front + 0.3), (eave, 0.63 * h)),
        *rail(wings[0], wings[1], (0.54 * h, 0.58 * h), 0.4),
    ]
    roof = [
        gable((-0.39 * w, 0.39 * w), (-d, front), (0.63 * h, 0.8 * h), "y"),
        dome(0.24 * w, (0.8 * h, 0.98 * h), (0, -0.3 * d), 18, 4),
        disc(0.03 * w, (0.96 * h, h), (0, -0.3 * d), 8),
    ]
    drum = disc(0.25 * w, (0.6 * h, 0.82 * h), (0, -0.3 * d), 18)
    gable_face = pediment((-0.39 * w, 0.39 * w), (front - 0.5, front + 0.35), (0.63 * h, 0.805 * h))
    flight = steps((-0.42 * w, 0.42 * w), (0.6 * d, d), base, 8)
    doors = [
        block((x - 0.04 * w, x + 0.04 * w), (0.6 * d, 0.63 * d), (base, 0.4 * h))
        for x in (-0.16 * w, 0.0, 0.16 * w)
    ]
    return parts(
        size,
        {
            LIMESTONE: [box(*wings, (0, 0.5 * h)), box(*centre, (0, eave)), drum, gable_face],
            STONE: [
                *columns(spots, (base, eave), 0.52),
                *capitals,
                *bases,
                *trim,
                *pilasters,
                *flight,
            ],
            VERDIGRIS: roof,
            PANE: panes,
            TIMBER: doors,
        },
    )


def _gymnasium(size: Size) -> Parts:
    """A wide hall under a shallow vault, bent ribs at its sides, glass in front, low wings."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    spring, count = 0.42 * h, 7
    shell = _arch_strip((-0.9 * w, 0.9 * w), (spring, 0.97 * h), 0.06 * h)
    roof = _along(shell, (-0.9 * d, 0.84 * d))
    rib = _arch_strip((-0.98 * w, 0.98 * w), (0.0, 0.93 * h), 0.05 * h)
    ribs = [_along(rib, (y - 0.35, y + 0.35)) for y in row(-0.88 * d, 0.8 * d, count)]
    ends = _along(_solid((-0.87 * w, 0.87 * w), (spring, 0.92 * h)), (-0.86 * d, 0.78 * d))
    walls = [block((-0.86 * w, 0.86 * w), (-0.88 * d, 0.78 * d), (0, 0.3 * h))]
    glass = [
        block((-0.84 * w, 0.84 * w), (-0.86 * d, 0.76 * d), (0.3 * h, spring + 0.05 * h)),
        ends,
    ]
    mullions = [
        block(
            (x - 0.15, x + 0.15),
            (0.78 * d, 0.81 * d),
            (0.3 * h, (0.42 + 0.44 * cos(x / w * 1.5)) * h),
        )
        for x in row(-0.72 * w, 0.72 * w, 9)
    ]
    wings = [
        block((s * 0.9 * w - 0.1 * w, s * 0.9 * w + 0.1 * w), (-0.6 * d, 0.56 * d), (0, 0.2 * h))
        for s in (-1, 1)
    ]
    strip = [
        p
        for s, x in (("l", (-w, -0.8 * w)), ("r", (0.8 * w, w)))
        for p in windows(x, (-0.6 * d, 0.56 * d), [(0, 0.2 * h)], 4.0, 0.7, 0.3, s, 0.55)
    ]
    canopy = [
        block((-0.4 * w, 0.4 * w), (0.7 * d, d), (0.26 * h, 0.3 * h)),
        *columns([(x, 0.96 * d) for x in row(-0.38 * w, 0.38 * w, 4)], (0, 0.27 * h), 0.2),
    ]
    doors = [block((-0.3 * w, 0.3 * w), (0.77 * d, 0.8 * d), (0, 0.22 * h))]
    return parts(
        size,
        {
            METAL_SHEET: [roof],
            STEEL: [*mullions, *canopy],
            RENDER: [*walls, *wings],
            CONCRETE: ribs,
            CURTAIN_WALL: glass,
            PANE: [*strip, *doors],
        },
    )


def _arch_strip(
    x: Interval, z: Interval, thick: float, count: int = 8
) -> list[tuple[float, float]]:
    """A bent strip: an arc over ``x`` and, back again, one ``thick`` below it."""
    half = (x[1] - x[0]) / 2
    angle = [pi * k / count for k in range(count + 1)]
    outer = [(half * cos(a), z[0] + (z[1] - z[0]) * sin(a) ** 0.8) for a in angle]
    inner = [
        ((half - thick) * cos(a), z[0] + max((z[1] - z[0]) * sin(a) ** 0.8 - thick, 0.0))
        for a in reversed(angle)
    ]
    return [*outer, *inner]


def _solid(x: Interval, z: Interval, count: int = 8) -> list[tuple[float, float]]:
    half = (x[1] - x[0]) / 2
    return [
        (half * cos(pi * k / count), z[0] + (z[1] - z[0]) * sin(pi * k / count) ** 0.8)
        for k in range(count + 1)
    ]


def _along(outline: list[tuple[float, float]], y: Interval) -> Mesh:
    """A polygon over (x, height), counter-clockwise seen from the back, drawn out along y."""
    return sheet(outline, y)


def _palace_windows(
    main: Rectangle, ends: list[Rectangle], bow: float, inner: float, levels: list[Interval]
) -> list[Mesh]:
    """Windows of the front beside the bowed middle, of the pavilions and of the garden side."""
    front = main[1]
    spans = [((-inner, -bow), front), ((bow, inner), front), *ends]
    panes = [p for x, y in spans for p in windows(x, y, levels, 5.6, 0.26, 0.62, "f", 0.16)]
    for s, e in zip("lr", ends, strict=True):
        panes += windows(*e, levels, 5.6, 0.26, 0.62, s, 0.16)
    return [*panes, *windows(*main, levels, 8.0, 0.3, 0.62, "b", 0.16)]


def _palace_trim(
    main: Rectangle, ends: list[Rectangle], bow: float, at: Spot, h: float
) -> list[Mesh]:
    """String courses round the body, the pavilions and the bowed middle; pilasters."""
    bands = [box(*e, (z * h, (z + 0.02) * h), 0.2) for e in (main, *ends) for z in (0.26, 0.48)]
    bands += [regular(bow + 0.25, (z * h, (z + 0.025) * h), at, 10) for z in (0.26, 0.59)]
    return bands + [p for e in ends for p in piers(*e, (0, 0.5 * h), 9.0, 0.5, 0.2, "f")]


def _rococo_palace(size: Size) -> Parts:
    """A pale palace: a bowed middle under a dome, mansards, end pavilions, urns, round windows."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    eave = 0.5 * h
    main = ((-0.9 * w, 0.9 * w), (-0.7 * d, 0.5 * d))
    ends = [
        ((s * 0.84 * w - 0.14 * w, s * 0.84 * w + 0.14 * w), (-0.94 * d, 0.74 * d)) for s in (-1, 1)
    ]
    bow, at = 0.46 * d, (0.0, 0.34 * d)
    levels = [(0.04 * h, 0.27 * h), (0.27 * h, eave)]
    walls = [
        box(*main, (0, eave)),
        *(box(*e, (0, eave)) for e in ends),
        regular(bow, (0, 0.6 * h), at, 10),
    ]
    roofs = [
        loft_rectangles(*main, [(-0.4, eave), (0.1 * d, 0.7 * h), (0.5 * d, 0.76 * h)]),
        *(
            loft_rectangles(*e, [(-0.4, eave), (0.05 * w, 0.74 * h), (0.08 * w, 0.8 * h)])
            for e in ends
        ),
    ]
    cap = [dome(1.02 * bow, (0.61 * h, 0.9 * h), at, 10, 4), bell(0.24 * bow, (0.88 * h, h), at)]
    panes = _palace_windows(main, ends, bow, 0.68 * w, levels)
    trim = _palace_trim(main, ends, bow, at, h)
    urns = [
        lathe([(0.3, z), (0.55, z + 0.5), (0.2, z + 1.0), (0.0, z + 1.5)], (x, y), 6)
        for x, y, z in [(s * v * w, 0.49 * d, eave) for s in (-1, 1) for v in (0.42, 0.54)]
    ]
    dormers = [
        gable(
            (s * v * w - 0.8, s * v * w + 0.8), (0.0, 0.49 * d), (0.52 * h, 0.68 * h), "y", 0.1 * h
        )
        for s in (-1, 1)
        for v in (0.36, 0.48, 0.6)
    ]
    doors = arches(
        (-0.2 * bow, 0.2 * bow, 0.0),
        (0.02 * h, 0.22 * h),
        0.16 * bow,
        (at[1] + 0.9 * bow, at[1] + 0.99 * bow),
    )
    tall = arches(
        (-0.15 * bow, 0.15 * bow),
        (0.32 * h, 0.55 * h),
        0.16 * bow,
        (at[1] + 0.9 * bow, at[1] + 0.99 * bow),
    )
    return parts(
        size,
        {
            BLUSH: walls,
            RENDER: [*trim, *dormers, *steps((-0.3 * w, 0.3 * w), (0.6 * d, d), 0.02 * h, 2)],
            SLATE: roofs,
            VERDIGRIS: cap,
            GILT: urns,
            PANE: [*panes, *tall],
            TIMBER: doors,
        },
    )


ASSETS = (
    style(
        "gallery",
        "Gallery",
        _gallery,
        plan(within(-0.76, 0.44, -0.3, 0.86), within(0.1, 0.86, -1, 0.3), door=(0.61, 1.0)),
        (48, 40, 16),
    ),
    style(
        "museum",
        "Museum",
        _museum,
        plan(within(-0.39, 0.39, -1, 0.8), ring(0.25, 0, -0.3)),
        (72, 44, 26),
    ),
    style(
        "gymnasium",
        "Gymnasium",
        _gymnasium,
        plan(
            within(-0.9, 0.9, -0.9, 0.84),
            *(within(-0.98, 0.98, y - 0.01, y + 0.01) for y in (-0.5, 0.0, 0.5)),
        ),
        (54, 64, 18),
    ),
    style(
        "rococo_palace",
        "Rococo palace",
        _rococo_palace,
        plan(within(-0.9, 0.9, -0.7, 0.5), *ridge(0.4), ring(0.2, 0, 0.34)),
        (70, 26, 22),
    ),
)
