"""Tables, desks and consoles."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.furniture.corners import (
    Outline,
    corner_outline,
    cover,
    draw_border,
    mirror_drawing,
)
from scenewright.catalog.assets.joinery import drawer_pulls, four_legs, fronts, knobs
from scenewright.catalog.assets.materials import (
    BLACK,
    BRASS,
    MIRROR,
    OAK,
    OAK_DARK,
    PINE,
    SAGE,
    WALNUT,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import Lines, box, oval, path, rectangle, round_plain
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, extrude, rotate_mesh
from scenewright.geometry.solids import block, disc, lathe, leg, make_bevelled_box, rod, slab


def _dining_table(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = slab((-w, w), (-d, d), (h - 0.032, h), 0.05, 3)
    apron = [
        block((-w + 0.1, w - 0.1), (y - 0.011, y + 0.011), (h - 0.1, h - 0.032))
        for y in (d - 0.085, -d + 0.085)
    ]
    apron += [
        block((x - 0.011, x + 0.011), (-d + 0.1, d - 0.1), (h - 0.1, h - 0.032))
        for x in (w - 0.085, -w + 0.085)
    ]
    legs = four_legs(w, d, (0, h - 0.032), 0.027, 0.02, 0.0, 0.0, square=True)
    return parts(size, {OAK_DARK: [top, *apron, *legs]})


def _round_table(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = lathe([(0.96, h - 0.035), (1, h - 0.022), (1, h - 0.004), (0.99, h)], sides=32)
    foot = [(0.5, 0), (0.5, 0.012), (0.2, 0.03), (0.1, 0.09), (0.085, 0.35), (0.13, h - 0.05)]
    column = lathe([*foot, (0.28, h - 0.034)], sides=20)
    return parts(
        size,
        {
            OAK: [Mesh(top.vertices * (w, d, 1), top.faces)],
            WHITE: [Mesh(column.vertices * (min(w, 0.6), min(d, 0.6), 1), column.faces)],
        },
    )


def _coffee_table(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = slab((-w, w), (-d, d), (h - 0.028, h), min(0.16, 0.45 * d), 4)
    shelf = slab((-w + 0.09, w - 0.09), (-d + 0.08, d - 0.08), (0.12, 0.135), min(0.1, 0.3 * d), 3)
    legs = four_legs(w, d, (0, h - 0.028), 0.022, 0.014, 0.055, 0.025)
    return parts(size, {WALNUT: [top, *legs], BLACK: [shelf]})


def _side_table(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    tray = lathe(
        [(0.97, h - 0.035), (1, h - 0.03), (1, h), (0.955, h), (0.95, h - 0.022)], sides=24
    )
    angles = [pi / 2 + k * 2 * pi / 3 for k in range(3)]
    legs = [
        leg(
            0.62 * w * cos(a),
            0.62 * d * sin(a),
            (0, h - 0.03),
            0.015,
            0.011,
            lean=(0.2 * w * cos(a), 0.2 * d * sin(a)),
        )
        for a in angles
    ]
    return parts(size, {WALNUT: [Mesh(tray.vertices * (w, d, 1), tray.faces), *legs]})


def drawers_wide(size: Size) -> float:
    """How wide the drawers of a desk are: a chair 0.62 m wide stands beside those down to the
    floor."""
    small = size.width < 1.1
    return 0.4 * size.width if small else min(0.42, size.width / 2 - 0.37)


def _desk(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    x = (w - drawers_wide(size) - 0.03, w - 0.03)
    z = (h - 0.085 if size.width < 1.1 else 0.12, h - 0.025)
    rows = 1 if size.width < 1.1 else 3
    face = d - 0.05
    chest = block(x, (-d + 0.04, face), z)
    legs = [
        make_bevelled_box(
            (sx * (w - 0.045) - 0.02, sx * (w - 0.045) + 0.02),
            (sy * (d - 0.05) - 0.02, sy * (d - 0.05) + 0.02),
            (0, h - 0.025),
            0.005,
        )
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    rail = block((-w + 0.06, w - 0.06), (-d + 0.04, -d + 0.06), (h - 0.3, h - 0.025))
    return parts(
        size,
        {
            OAK: [slab((-w, w), (-d, d), (h - 0.025, h), 0.02), rail],
            WHITE: [chest, *fronts(x, z, 1, rows, (face, face + 0.016))],
            BLACK: [*legs, *drawer_pulls(x, z, 1, rows, face + 0.016)],
        },
    )


def corner_desk_outline(size: Size) -> Outline:
    """The L of a desk round a corner, its wing on the left."""
    return corner_outline(size, min(0.7, 0.5 * size.depth), min(0.6, 0.45 * size.width))


def _corner_desk(size: Size) -> Parts:
    """A top round the corner, drawers under the end of its wing, a rail along both walls."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    outline = corner_desk_outline(size)
    (_, front), (edge, _) = outline[2], outline[4]
    x, y, z = (-w + 0.03, edge - 0.03), (d - 0.5, d - 0.03), (0.12, h - 0.025)
    chest = block((x[0], x[1] - 0.016), y, z)
    feet = ((w - 0.05, -d + 0.05), (w - 0.05, front - 0.05), (-w + 0.05, -d + 0.05))
    legs = [
        make_bevelled_box((fx - 0.02, fx + 0.02), (fy - 0.02, fy + 0.02), (0, h - 0.025), 0.005)
        for fx, fy in (*feet, (-w + 0.05, y[0] + 0.04), (-w + 0.05, y[1] - 0.04))
    ]
    rails = [
        block((-w + 0.06, w - 0.06), (-d + 0.04, -d + 0.06), (h - 0.3, h - 0.025)),
        block((-w + 0.04, -w + 0.06), (-d + 0.06, d - 0.06), (h - 0.3, h - 0.025)),
    ]
    middle = (y[0] + y[1]) / 2
    drawers = [
        rotate_mesh(mesh, "z", -pi / 2, (x[1] - 0.016, middle, 0.0))
        for mesh in fronts(
            (x[1] - 0.016 - 0.235, x[1] - 0.016 + 0.235), z, 1, 3, (middle, middle + 0.016)
        )
    ]
    return parts(
        size,
        {
            OAK: [extrude(np.array(outline), h - 0.025, h), *rails],
            WHITE: [chest, *drawers],
            BLACK: legs,
        },
    )


def _kids_desk(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    x, z = (-w + 0.04, w - 0.04), (h - 0.13, h - 0.022)
    legs = four_legs(w, d, (0, h - 0.022), 0.024, 0.016, 0.015, 0.025)
    face = d - 0.06
    return parts(
        size,
        {
            PINE: [slab((-w, w), (-d, d), (h - 0.022, h), 0.05, 3), *legs],
            SAGE: [block(x, (-d + 0.04, face), z), *fronts(x, z, 2, 1, (face, face + 0.015))],
            WHITE: knobs(x, z, 2, 1, face + 0.015),
        },
    )


def _console_table(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    legs = [
        block(
            (sx * (w - 0.011) - 0.011, sx * (w - 0.011) + 0.011),
            (sy * (d - 0.011) - 0.011, sy * (d - 0.011) + 0.011),
            (0, h - 0.03),
        )
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    low = block((-w + 0.02, w - 0.02), (-d + 0.01, d - 0.01), (0.16, 0.182))
    x, z = (-w + 0.022, w - 0.022), (h - 0.14, h - 0.03)
    chest = block(x, (-d + 0.01, d - 0.025), z)
    face = fronts(x, z, 2, 1, (d - 0.025, d - 0.008))
    return parts(
        size,
        {
            OAK: [block((-w, w), (-d, d), (h - 0.03, h)), low, chest, *face],
            BLACK: [*legs, *knobs(x, z, 2, 1, d - 0.008, 0.008)],
        },
    )


def _vanity(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(h, 0.76)
    x, z = (-w + 0.03, w - 0.03), (top - 0.14, top - 0.022)
    face = d - 0.045
    legs = four_legs(w, d, (0, top - 0.022), 0.02, 0.013, 0.02, 0.02)
    found = {
        WHITE: [block(x, (-d + 0.02, face), z), *fronts(x, z, 2, 1, (face, face + 0.016))],
        OAK: [slab((-w, w), (-d, d), (top - 0.022, top), 0.03), *legs],
        BRASS: knobs(x, z, 2, 1, face + 0.016),
    }
    if h > top + 0.2:
        rim = 0.5 * min(w, 0.35)
        glass = disc(1.0, (0.0, 0.01), sides=28)
        plate = glass.vertices[:, [0, 2, 1]] * (1.4 * rim, 1, (h - top) / 2)
        middle = (0, -d + 0.03, (h + top) / 2)
        found[MIRROR] = [Mesh(plate + middle, glass.faces[:, ::-1])]
        found[OAK].append(rod((0, -d + 0.02, top - 0.02), (0, -d + 0.02, h - 0.05), 0.015))
    return parts(size, found)


def _table_symbol(size: Size) -> Lines:
    return (rectangle(size, 0, 0.04),)


def _coffee_symbol(size: Size) -> Lines:
    radius = min(0.16, 0.2 * size.depth)
    return rectangle(size, 0, radius), rectangle(size, 0.03, max(radius - 0.03, 0.01))


def _side_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return oval(0, 0, w, d), oval(0, 0, 0.9 * w, 0.9 * d)


def _desk_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    wide = drawers_wide(size)
    return rectangle(size), path((w - wide, -d), (w - wide, d))


def corner_desk_symbol(size: Size) -> Lines:
    """Outline of a desk round a corner and the line of its chest."""
    outline = corner_desk_outline(size)
    (edge, _), d = outline[4], size.depth / 2
    return draw_border(outline), path((-size.width / 2, d - 0.5), (edge, d - 0.5))


def _vanity_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size, 0, 0.02), box(-0.5 * w, 0.5 * w, -d + 0.02, -d + 0.06)


def _console_symbol(size: Size) -> Lines:
    return rectangle(size), rectangle(size, 0.025)


CORNER_DESK = Drawing(
    "corner_desk", _corner_desk, corner_desk_symbol, footprint=cover(corner_desk_outline)
)
ASSETS = (
    Drawing("dining_table", _dining_table, _table_symbol),
    Drawing("round_table", _round_table, round_plain),
    Drawing("coffee_table", _coffee_table, _coffee_symbol),
    Drawing("side_table", _side_table, _side_symbol),
    Drawing("desk", _desk, _desk_symbol),
    CORNER_DESK,
    mirror_drawing(CORNER_DESK),
    Drawing("kids_desk", _kids_desk, _table_symbol),
    Drawing("console_table", _console_table, _console_symbol),
    Drawing("vanity", _vanity, _vanity_symbol),
)
