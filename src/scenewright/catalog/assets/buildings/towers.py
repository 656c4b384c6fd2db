"""Many storeys: slabs and towers to live in, offices, shops with offices above."""

from __future__ import annotations

from scenewright.catalog.assets.buildings.building_plans import cross, plan, style, within
from scenewright.catalog.assets.buildings.facades import (
    bands,
    bays,
    box,
    columns,
    on,
    piers,
    rail,
    row,
    storeys,
    windows,
)
from scenewright.catalog.assets.buildings.roofs import drawn_in
from scenewright.catalog.assets.materials import (
    ASPHALT_FELT,
    BRICK,
    CONCRETE,
    CURTAIN_WALL,
    GREY,
    LIMESTONE,
    MASONRY,
    METAL_SHEET,
    PANE,
    RENDER,
    SLATE,
    STEEL,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, block


def _modern_residential(size: Size) -> Parts:
    """A slab of flats: stairs to the north, balconies to the south, a shallow parapet."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = h - 3.0 if h > 12 else 0.85 * h
    x, y = (-w, w), (-d + 0.6, d - 1.5)
    levels = storeys((0.0, top), 3.0)
    units = bays(x, 12.0)
    spans = [(a + 0.1 * (b - a), b - 0.1 * (b - a)) for a, b in units]
    balconies = [
        block(span, (y[1] - 0.1, d), (low - 0.2, low + 0.95))
        for span in spans
        for low, _ in levels[1:]
    ]
    glass = [
        block((a + 0.4, b - 0.4), (y[1] - 0.1, y[1] + 0.1), (2.6, top - 0.4)) for a, b in spans
    ]
    back = bands(x, y, levels, 0.4, 0.32, "b", 1.2)
    cores = [
        block(((a + b) / 2 - 1.4, (a + b) / 2 + 1.4), (-d, y[0] + 0.2), (0, top + 1.2))
        for a, b in units
    ]
    houses = [
        block(((a + b) / 2 - 2, (a + b) / 2 + 2), (y[0] + 0.4, y[0] + 6), (top, h))
        for a, b in units[::2]
    ]
    doors = [
        block(((a + b) / 2 - 1.1, (a + b) / 2 + 1.1), (y[1], y[1] + 0.15), (0, 2.3))
        for a, b in units
    ]
    return parts(
        size,
        {
            RENDER: [box(x, y, (0, top)), *rail(x, y, (top, top + 0.9), 0.25)],
            CONCRETE: [*cores, *houses],
            GREY: balconies,
            PANE: [*glass, *back],
            SLATE: doors,
            MASONRY: [box(drawn_in(x, 0.25), drawn_in(y, 0.25), (top, top + 0.1))],
        },
    )


def _point_tower(size: Size) -> Parts:
    """A free-standing tower of flats: notched corners, bands of windows, a stepped head."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    notch, top = 0.22, 0.93 * h
    x, y = drawn_in((-w, w), 1.0), drawn_in((-d, d), 1.0)
    base = min(5.0, 0.15 * h)
    core = box(drawn_in(x, notch * w), drawn_in(y, notch * d), (0, h))
    wings = [
        box(x, drawn_in(y, 2 * notch * d), (0, top)),
        box(drawn_in(x, 2 * notch * w), y, (0, top)),
    ]
    glass = [
        *bands(x, drawn_in(y, 2 * notch * d), storeys((base, top), 6.2), 0.62, 0.2, "lr"),
        *bands(drawn_in(x, 2 * notch * w), y, storeys((base, top), 6.2), 0.62, 0.2, "fb"),
    ]
    balconies = [
        block(
            (s * (1 - notch) * w * 0.96 - 1.2, s * (1 - notch) * w * 0.96 + 1.2),
            (t * (1 - notch) * d * 0.96 - 1.2, t * (1 - notch) * d * 0.96 + 1.2),
            (low - 0.15, low + 0.95),
        )
        for low, _ in storeys((base, top), 6.2)[1:]
        for s in (-1, 1)
        for t in (-1, 1)
    ]
    foot = [
        box(drawn_in(x, 0.1 * w), drawn_in(y, 0.1 * d), (0, 0.8 * base), 0.0),
        block((-0.3 * w, 0.3 * w), (0.8 * d, d), (0.72 * base, 0.8 * base)),
    ]
    doors = [block((-0.2 * w, 0.2 * w), (0.5 * d, y[1] + 0.12), (0, 0.66 * base))]
    return parts(
        size,
        {
            LIMESTONE: wings,
            GREY: [core, *foot],
            CONCRETE: [*balconies, block((-w, w), (-d, d), (0, 0.3))],
            PANE: [*glass, *doors],
        },
    )


def _office_tower(size: Size) -> Parts:
    """Curtain walls between upright fins, a recessed foot on columns, plant behind a screen."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    foot, crown = min(8.0, 0.2 * h), 0.94 * h
    x, y = drawn_in((-w, w), 0.6), drawn_in((-d, d), 0.6)
    floors = storeys((foot, crown), 12.0)
    lines = [box(x, y, (low - 0.25, low + 0.25), 0.15) for low, _ in floors]
    spots = [(px, py) for py in (y[0] + 0.8, y[1] - 0.8) for px in row(x[0] + 0.8, x[1] - 0.8, 5)]
    foot_in = (drawn_in(x, 0.16 * w), drawn_in(y, 0.16 * d))
    canopy = block((-0.3 * w, 0.3 * w), (0.6 * d, d), (0.55 * foot, 0.62 * foot))
    screen = box(drawn_in(x, 0.1 * w), drawn_in(y, 0.1 * d), (crown, h))
    return parts(
        size,
        {
            CURTAIN_WALL: [box(x, y, (foot, crown)), box(*foot_in, (0, foot))],
            STEEL: [*piers(x, y, (foot, 0.97 * h), 4.5, 0.3, 0.5), *lines, canopy],
            CONCRETE: [*columns(spots, (0, foot), 0.55, 6), block((-w, w), (-d, d), (0, 0.3))],
            SLATE: [screen],
        },
    )


def _commercial_block(size: Size) -> Parts:
    """Shops in a long foot with a canopy and signs, offices set back above them."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    foot = 0.36 * h
    x, y = drawn_in((-w, w), 0.8), (-d + 0.8, 0.84 * d)
    tower = ((-0.86 * w, 0.34 * w), (-0.8 * d, 0.5 * d))
    shops = windows(x, y, [(0.0, 0.48 * foot)], 7.0, 0.82, 0.8, "flr", 0.06)
    upper = windows(x, y, [(0.55 * foot, 0.95 * foot)], 7.0, 0.6, 0.6, "flr", 0.2)
    signs = on(
        "f",
        x,
        y,
        [block((a + 1.2, b - 1.2), (0, 0.5), (0.46 * foot, 0.54 * foot)) for a, b in bays(x, 14.0)],
    )
    corner = block((0.56 * w, 0.9 * w), (0.4 * d, d), (0, 0.62 * h))
    canopy = block((x[0], 0.52 * w), (y[1], d), (0.5 * foot - 0.9, 0.5 * foot - 0.5))
    levels = storeys((foot, 0.95 * h), 3.9)
    units = [
        block((px * w - 2, px * w + 2), (-0.6 * d, -0.3 * d), (foot - 0.1, foot + 2.2))
        for px in (0.5, 0.72)
    ]
    plant = block((-0.6 * w, -0.1 * w), (-0.5 * d, 0.1 * d), (0.94 * h, h))
    return parts(
        size,
        {
            LIMESTONE: [
                box(x, y, (0, foot)),
                *rail(x, y, (foot, foot + 0.9), 0.3),
                *(
                    box(*tower, (a - 0.45, a + 0.45), 0.15)
                    for a, _ in [*levels[1:], (0.945 * h, 0)]
                ),
            ],
            CURTAIN_WALL: [box(*tower, (foot, 0.95 * h)), corner],
            STEEL: [
                *piers(*tower, (foot, 0.95 * h), 6.0, 0.35, 0.3),
                canopy,
                *_ribs((0.56 * w, 0.9 * w), (0.4 * d, d), (0, 0.62 * h)),
            ],
            PANE: [*shops, *upper],
            BRICK: signs,
            METAL_SHEET: [*units, plant],
            ASPHALT_FELT: [block((-w, w), (-d, d), (0, 0.15))],
        },
    )


def _ribs(x: Interval, y: Interval, z: Interval) -> list[Mesh]:
    """Level bars round a glass corner."""
    return [box(x, y, (low - 0.15, low + 0.15), 0.12) for low, _ in storeys(z, 4.0)[1:]]


ASSETS = (
    style(
        "modern_residential",
        "Modern residential slab",
        _modern_residential,
        plan(within(-1, 1, -0.9, 0.8)),
        (60, 14, 36),
    ),
    style(
        "point_tower",
        "Point tower",
        _point_tower,
        plan(within(-0.78, 0.78, -0.78, 0.78), *cross()),
        (24, 24, 90),
    ),
    style(
        "office_tower",
        "Office tower",
        _office_tower,
        plan(within(-0.85, 0.85, -0.85, 0.85), *cross()),
        (36, 30, 96),
    ),
    style(
        "commercial_block",
        "Commercial building",
        _commercial_block,
        plan(within(-0.86, 0.34, -0.8, 0.5), within(0.56, 0.9, 0.4, 1)),
        (64, 36, 30),
    ),
)
