"""Large things for pastimes and housework: piano, exercise bike, ironing board."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import (
    BLACK,
    CHARCOAL,
    CHROME,
    NAVY,
    RUBBER,
    STEEL,
    WALNUT,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import Lines, box, close_line, oval, path, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, extrude, rotate_mesh, translate_mesh
from scenewright.geometry.solids import block, cushion, disc, make_bevelled_box, pipe, rod, tube


def _piano(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    deck, lip = 0.62 * h, d - 0.02
    case = [
        block((-w, w), (-d, 0.05 * d), (0, h - 0.025)),
        make_bevelled_box((-w, w), (-d, 0.12 * d), (h - 0.025, h), 0.006),
        block((-w + 0.03, w - 0.03), (0.05 * d, d), (deck - 0.07, deck - 0.02)),
        block((-w, -w + 0.04), (0.05 * d, d), (deck - 0.07, deck + 0.04)),
        block((w - 0.04, w), (0.05 * d, d), (deck - 0.07, deck + 0.04)),
        *(
            block(
                (s * (w - 0.04) - 0.025, s * (w - 0.04) + 0.025),
                (d - 0.1, d - 0.04),
                (0, deck - 0.07),
            )
            for s in (-1, 1)
        ),
        block((-0.35 * w, 0.35 * w), (0.06 * d, 0.1 * d), (deck + 0.1, deck + 0.3 * h)),
    ]
    keys = block((-w + 0.06, w - 0.06), (0.35 * d, lip), (deck - 0.025, deck))
    count = 36
    step = (2 * w - 0.12) / count
    black = [
        block(
            (-w + 0.06 + (k + 0.7) * step, -w + 0.06 + (k + 1.3) * step),
            (0.35 * d, 0.68 * d),
            (deck - 0.01, deck + 0.012),
        )
        for k in range(count - 1)
        if k % 7 not in (2, 6)
    ]
    return parts(size, {WALNUT: case, WHITE: [keys], BLACK: black})


def _exercise_bike(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    seat = 0.72 * h
    wheel = translate_mesh(rotate_mesh(disc(1, (-0.03, 0.03), sides=20), "y", pi / 2), 0, 0, 0)
    radius = min(0.26, 0.24 * h)
    wheel = Mesh(wheel.vertices * (1, radius, radius) + (0, 0.45 * d, 0.08 + radius), wheel.faces)
    rim = rotate_mesh(pipe(1, 0.82, (-0.035, 0.035), sides=20), "y", pi / 2)
    rim = Mesh(rim.vertices * (1, radius, radius) + (0, 0.45 * d, 0.08 + radius), rim.faces)
    crank = (0.0, 0.0, 0.3)
    frame = [
        rod((0, -d + 0.05, 0.06), (0, d - 0.05, 0.06), 0.03),
        rod(crank, (0, -0.42 * d, seat - 0.03), 0.026),
        rod((0, 0.45 * d, 0.08 + radius), (0, 0.55 * d, h - 0.1), 0.026),
        rod(crank, (0, 0.52 * d, 0.62 * h), 0.026),
    ]
    feet = [rod((-w, y, 0.03), (w, y, 0.03), 0.03) for y in (-d + 0.03, d - 0.03)]
    bars = tube(
        [
            (-w + 0.06, 0.25 * d, h - 0.02),
            (-w + 0.06, 0.5 * d, h - 0.05),
            (w - 0.06, 0.5 * d, h - 0.05),
            (w - 0.06, 0.25 * d, h - 0.02),
        ],
        0.015,
    )
    saddle = cushion(
        (-0.11, 0.11), (-0.42 * d - 0.14, -0.42 * d + 0.14), (seat - 0.04, seat + 0.03), 0.03
    )
    pedals, cranks = [], []
    for s, y, z in ((1, 0.12, 0.38), (-1, -0.12, 0.22)):
        pedals.append(
            block((s * 0.12 - 0.05, s * 0.12 + 0.05), (y - 0.04, y + 0.04), (z - 0.012, z + 0.012))
        )
        cranks.append(rod((s * 0.05, 0, 0.3), (s * 0.08, y, z), 0.012))
    screen = make_bevelled_box((-0.1, 0.1), (0.5 * d, 0.5 * d + 0.03), (h - 0.14, h), 0.006)
    return parts(
        size,
        {
            CHARCOAL: [*frame, rim, screen],
            BLACK: [*feet, bars, saddle, *pedals],
            CHROME: [wheel, *cranks],
        },
    )


def _ironing_board(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    board = [(w, -d + 0.03), (w, 0.3 * d), (0.72 * w, 0.7 * d), (0.3 * w, 0.95 * d), (0, d)]
    ring = [*board, *[(-x, y) for x, y in board[-2::-1]], (-w + 0.03, -d), (w - 0.03, -d)]
    legs = [
        tube([(s * 0.5 * w, -0.75 * d, h - 0.085), (s * 0.9 * w, 0.62 * d, 0.012)], 0.011)
        for s in (-1, 1)
    ]
    legs += [
        tube([(s * 0.35 * w, 0.6 * d, h - 0.085), (s * 0.9 * w, -0.7 * d, 0.012)], 0.011)
        for s in (-1, 1)
    ]
    feet = [rod((-w, y, 0.014), (w, y, 0.014), 0.014) for y in (0.62 * d, -0.7 * d)]
    iron = [
        make_bevelled_box((-0.05, 0.05), (-0.62 * d, -0.62 * d + 0.22), (h - 0.06, h - 0.03), 0.012)
    ]
    iron.append(
        tube(
            [
                (0, -0.62 * d + 0.03, h - 0.035),
                (0, -0.62 * d + 0.03, h - 0.01),
                (0, -0.62 * d + 0.18, h - 0.01),
                (0, -0.62 * d + 0.18, h - 0.035),
            ],
            0.01,
        )
    )
    return parts(
        size, {NAVY: [extrude(ring, h - 0.09, h - 0.06)], STEEL: [*legs, *feet], RUBBER: iron}
    )


def _piano_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    keys = [path((x, 0.35 * d), (x, d - 0.02)) for x, _ in spread(-w + 0.06, w - 0.06, 26)[1:]]
    return (
        rectangle(size),
        path((-w, 0.1 * d), (w, 0.1 * d)),
        box(-w + 0.06, w - 0.06, 0.35 * d, d - 0.02),
        *keys,
    )


def _bike_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return (
        box(-0.07, 0.07, -d, d, 0.05),
        path((-w, -d + 0.03), (w, -d + 0.03)),
        path((-w, d - 0.03), (w, d - 0.03)),
        path(
            (-w + 0.06, 0.25 * d), (-w + 0.06, 0.5 * d), (w - 0.06, 0.5 * d), (w - 0.06, 0.25 * d)
        ),
        oval(0, -0.42 * d, 0.1, 0.14),
    )


def _board_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    angle = np.linspace(0, pi, 17)
    nose = [(w * cos(a), 0.2 * d + 0.8 * d * sin(a)) for a in angle]
    return close_line([(-w, -d), (w, -d), *nose]), box(
        -0.05, 0.05, -0.62 * d, -0.62 * d + 0.2, 0.04
    )


ASSETS = (
    Drawing("piano", _piano, _piano_symbol),
    Drawing("exercise_bike", _exercise_bike, _bike_symbol),
    Drawing("ironing_board", _ironing_board, _board_symbol),
)
