"""Auditoria: rows of seats, lectern, stage, projection screen."""

from __future__ import annotations

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.joinery import bent, spread
from scenewright.catalog.assets.materials import (
    BLACK,
    CHARCOAL,
    OAK,
    OAK_DARK,
    PAPER,
    STEEL,
    VELVET,
    WALNUT,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import Lines, box, crescent, path, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import rotate_mesh
from scenewright.geometry.solids import block, make_bevelled_box, rod, tube


def _seat(size: Size) -> Parts:
    """One seat of a row, its side panels shared by eye with its neighbours."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    seat, arm = min(0.45, 0.5 * h), min(0.64, 0.7 * h)
    sides = [
        block((s * (w - 0.02) - 0.02, s * (w - 0.02) + 0.02), (-d + 0.08, 0.7 * d), (0, arm - 0.03))
        for s in (-1, 1)
    ]
    rests = [
        block(
            (s * (w - 0.025) - 0.025, s * (w - 0.025) + 0.025),
            (-d + 0.06, 0.75 * d),
            (arm - 0.03, arm),
        )
        for s in (-1, 1)
    ]
    pad = make_bevelled_box((-w + 0.045, w - 0.045), (-d + 0.14, d), (seat - 0.11, seat), 0.03)
    back = bent(w - 0.03, -d + 0.16, 0.03, 0.07, (seat - 0.06, h), 4, lean=0.06)
    shell = bent(w - 0.045, -d + 0.088, 0.03, 0.02, (seat - 0.1, h - 0.06), 4, lean=0.055)
    return parts(size, {VELVET: [pad, back], CHARCOAL: sides, OAK_DARK: [*rests, shell]})


def _pew(size: Size) -> Parts:
    """A bench for a row of people: a back with a shelf for books behind it, and ends."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    seat = min(0.45, 0.5 * h)
    ends = [block((s * (w - 0.02) - 0.02, s * (w - 0.02) + 0.02), (-d, d), (0, h)) for s in (-1, 1)]
    board = block((-w + 0.04, w - 0.04), (-0.55 * d, 0.9 * d), (seat - 0.04, seat))
    back = block((-w + 0.04, w - 0.04), (-0.7 * d, -0.55 * d), (0.1, h - 0.03))
    shelf = block((-w + 0.04, w - 0.04), (-d + 0.01, -0.7 * d), (0.75 * h, 0.75 * h + 0.03))
    return parts(size, {OAK: [board, back, shelf], OAK_DARK: ends})


def _lectern(size: Size) -> Parts:
    """The audience sees the front; the speaker stands behind a board that slopes to him."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    tilt, low = 0.3, h - 0.3
    board = rotate_mesh(
        block((-w, w), (-d, 0.7 * d), (low + 0.09, low + 0.12)), "x", tilt, (0, 0, low + 0.12)
    )
    page = rotate_mesh(
        block((-0.15, 0.15), (-0.7 * d, 0.3 * d), (low + 0.12, low + 0.13)),
        "x",
        tilt,
        (0, 0, low + 0.12),
    )
    microphone = tube(
        [(0.5 * w, 0.5 * d, low + 0.1), (0.5 * w, 0.45 * d, h - 0.06), (0.5 * w, 0.1 * d, h)],
        0.008,
        5,
    )
    return parts(
        size,
        {
            WALNUT: [
                block((-0.85 * w, 0.85 * w), (0.35 * d, 0.6 * d), (0.04, low + 0.12)),
                *(
                    block(
                        (s * 0.8 * w - 0.02, s * 0.8 * w + 0.02),
                        (-0.4 * d, 0.35 * d),
                        (0.04, low + 0.02),
                    )
                    for s in (-1, 1)
                ),
                board,
            ],
            CHARCOAL: [block((-w, w), (-0.7 * d, d), (0, 0.04))],
            PAPER: [page],
            BLACK: [microphone],
        },
    )


def _steps(size: Size) -> tuple[int, float, float]:
    """Number of steps before the deck, how deep they are together and how wide."""
    count = max(1, round(size.height / 0.17) - 1)
    return count, min(0.3 * count, 0.3 * size.depth), min(1.2, 0.25 * size.width)


def _stage(size: Size) -> Parts:
    """A platform with steps in both front corners."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    count, run, wide = _steps(size)
    edge = d - run
    deck = [
        block((-w, w), (-d, edge), (h - 0.04, h)),
        block((-w + wide, w - wide), (edge, d), (h - 0.04, h)),
    ]
    body = [
        block((-w + 0.01, w - 0.01), (-d + 0.01, edge - 0.01), (0, h - 0.04)),
        block((-w + wide + 0.01, w - wide - 0.01), (edge - 0.01, d - 0.02), (0, h - 0.04)),
    ]
    treads = []
    for s in (-1, 1):
        x = (-w, -w + wide) if s < 0 else (w - wide, w)
        for k, (a, b) in enumerate(spread(edge, d, count)):
            treads.append(block(x, (a, b), (0, h * (count - k) / (count + 1))))
    return parts(size, {OAK: [*deck, *treads], CHARCOAL: body})


def _screen(size: Size) -> Parts:
    """A projection screen: on feet where it has the depth, else against the wall."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    low, y = 0.3 * h, (-0.02, 0.02) if d > 0.06 else (-d, d - 0.004)
    front = (y[1], y[1] + 0.004)
    rim = 0.05
    feet = [block((s * 0.8 * w - 0.03, s * 0.8 * w + 0.03), (-d, d), (0, 0.03)) for s in (-1, 1)]
    posts = [
        rod((s * 0.8 * w, 0, 0.02), (s * 0.8 * w, 0, low + 0.05), 0.02, sides=6) for s in (-1, 1)
    ]
    legs = (
        [*feet, *posts]
        if d > 0.06
        else [block((s * 0.8 * w - 0.02, s * 0.8 * w + 0.02), (-d, d), (0, low)) for s in (-1, 1)]
    )
    return parts(
        size,
        {
            BLACK: [block((-w, w), y, (low, h))],
            WHITE: [block((-w + rim, w - rim), front, (low + rim, h - rim))],
            STEEL: legs,
        },
    )


def _seat_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    arm = min(0.05, 0.2 * w)
    return (
        box(-w + arm, w - arm, -d + 0.12, d, 0.05),
        crescent(w - arm, -d, 0.1, 0.05),
        box(-w, -w + arm, -d + 0.08, 0.7 * d),
        box(w - arm, w, -d + 0.08, 0.7 * d),
    )


def _pew_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), path((-w, -0.6 * d), (w, -0.6 * d))


def _lectern_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), box(-0.15, 0.15, -0.6 * d, 0.3 * d), path((-w, 0.5 * d), (w, 0.5 * d))


def _stage_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    count, run, wide = _steps(size)
    edges = [a for a, _ in spread(d - run, d, count)]
    return (
        rectangle(size),
        path((-w + wide, d), (-w + wide, edges[0])),
        path((w - wide, d), (w - wide, edges[0])),
        *(path((-w, y), (-w + wide, y)) for y in edges),
        *(path((w - wide, y), (w, y)) for y in edges),
    )


def _screen_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    half = min(0.02, 0.5 * d)
    stays = [box(s * 0.8 * w - 0.03, s * 0.8 * w + 0.03, -d, d) for s in (-1, 1)]
    return box(-w, w, -half, half), *stays


ASSETS = (
    Drawing("auditorium_seat", _seat, _seat_symbol),
    Drawing("pew", _pew, _pew_symbol),
    Drawing("lectern", _lectern, _lectern_symbol),
    Drawing("stage", _stage, _stage_symbol),
    Drawing("screen", _screen, _screen_symbol),
)
