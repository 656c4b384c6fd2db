"""Roofs of buildings: gables, hips, mansards, swept eaves, vaults, domes, spires.

``x`` and ``y`` are the intervals a roof covers at its eaves, ``z`` those of its height. Every
roof is one closed body.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, pi, sin, tau

import numpy as np

from scenewright.geometry.mesh import Mesh, loft, rotate_mesh
from scenewright.geometry.solids import Interval, Spot, lathe, profile, rectangle_ring


def middle(span: Interval) -> float:
    """The middle of an interval."""
    return (span[0] + span[1]) / 2


def drawn_in(span: Interval, inset: float) -> Interval:
    """The interval, shorter by ``inset`` at both ends (a negative one makes it longer)."""
    return span[0] + inset, span[1] - inset


def gable(x: Interval, y: Interval, z: Interval, along: str = "x", thick: float = 0.0) -> Mesh:
    """Two slopes to a ridge along x or y, over upright eaves ``thick`` high.

    >>> len(gable((0, 9), (0, 6), (5, 8)).faces)
    8
    """
    across, length = (y, x) if along == "x" else (x, y)
    eaves = [(across[1], z[0] + thick), (across[0], z[0] + thick)] if thick else []
    low = [(across[0], z[0]), (across[1], z[0])]
    outline = [*low, *eaves[:1], (middle(across), z[1]), *eaves[1:]]
    return _drawn_out(outline, length, along)


def vault(x: Interval, y: Interval, z: Interval, along: str = "x", steps: int = 10) -> Mesh:
    """Half an elliptic cylinder with its axis along x or y."""
    across, length = (y, x) if along == "x" else (x, y)
    half = (across[1] - across[0]) / 2
    angle = [pi * k / steps for k in range(steps + 1)]
    outline = [(middle(across) + half * cos(a), z[0] + (z[1] - z[0]) * sin(a)) for a in angle]
    return _drawn_out(outline, length, along)


def _drawn_out(outline: Sequence[Spot], length: Interval, along: str) -> Mesh:
    """A polygon over (y, height) drawn out along x, or one over (x, height) along y."""
    if along == "x":
        return profile(outline, length)
    flipped = [(-across, high) for across, high in reversed(outline)]
    return rotate_mesh(profile(flipped, length), "z", pi / 2)


def hip(x: Interval, y: Interval, z: Interval, ridge: float = 1.0) -> Mesh:
    """Four slopes to a ridge along the longer side; ``ridge`` 1 gives all slopes the same pitch,
    less a longer ridge, 0 one from end to end."""
    wide, deep = x[1] - x[0], y[1] - y[0]
    inset = ridge * min(wide, deep) / 2
    end_x = drawn_in(x, inset if wide > deep else wide / 2)
    end_y = drawn_in(y, inset if wide <= deep else deep / 2)
    return loft([rectangle_ring(x, y, z[0]), rectangle_ring(end_x, end_y, z[1])])


def loft_rectangles(x: Interval, y: Interval, levels: Sequence[Spot]) -> Mesh:
    """Rectangles one over the other: ``levels`` of (inset, height). A mansard is three of them."""
    return loft([rectangle_ring(drawn_in(x, s), drawn_in(y, s), z) for s, z in levels])


def spire(
    x: float,
    y: float,
    z: Interval,
    radius: float,
    sides: int = 8,
    turn: float = 0.0,
    tip: float = 0.09,
) -> Mesh:
    """A pyramid over a regular polygon, blunt by the share ``tip``: a needle would draw all
    attention to itself (:mod:`scenewright.geometry.saliency`)."""
    angle = turn + np.arange(sides) * tau / sides
    return loft(
        [
            np.column_stack([x + r * np.cos(angle), y + r * np.sin(angle), np.full(sides, high)])
            for r, high in zip((radius, tip * radius), z, strict=True)
        ]
    )


def dome(
    radius: float,
    z: Interval,
    at: Spot = (0.0, 0.0),
    sides: int = 16,
    rows: int = 5,
    bulge: float = 0.0,
) -> Mesh:
    """A round dome; ``bulge`` > 0 swells it beyond its base and draws it to a point (an onion)."""
    found: list[tuple[float, float]] = []
    for k in range(rows + 1):
        share = k / rows
        round_ = cos(share * pi / 2)
        swell = 1.0 + bulge * sin(pi * min(1.6 * share, 1.0))
        point = share ** (1.0 + bulge)
        high = (1 - bulge) * sin(share * pi / 2) + bulge * point
        found.append((radius * round_ * swell, z[0] + (z[1] - z[0]) * high))
    return lathe(found, at, sides)


def bell(radius: float, z: Interval, at: Spot = (0.0, 0.0), sides: int = 8) -> Mesh:
    """A curved cap with a lantern's neck and a point, as on baroque towers."""
    shape = [
        (1.0, 0.0),
        (0.96, 0.1),
        (0.7, 0.26),
        (0.42, 0.36),
        (0.3, 0.46),
        (0.3, 0.62),
        (0.36, 0.66),
        (0.22, 0.78),
        (0.12, 0.86),
        (0.09, 1.0),
    ]
    return lathe([(r * radius, z[0] + s * (z[1] - z[0])) for r, s in shape], at, sides)


def swept(
    x: Interval,
    y: Interval,
    z: Interval,
    top: tuple[Interval, Interval],
    lift: float = 0.4,
    rows: int = 3,
    sag: float = 0.45,
) -> Mesh:
    """An East Asian roof: slopes that flatten towards the eaves, corners turned up by ``lift``.

    ``top`` is the rectangle (x, y) it narrows to, a ridge if one side of it is nothing; ``sag``
    bends the slopes, 0 leaves them straight.
    """
    under = _eaves(drawn_in(x, 0.25 * lift), drawn_in(y, 0.25 * lift), z[0] - 0.35 * lift, lift)
    rings = [under]
    for k in range(rows + 1):
        share = k / rows
        high = share ** (1.0 + 2 * sag)
        now = [
            ((1 - share) * a[0] + share * b[0], (1 - share) * a[1] + share * b[1])
            for a, b in zip((x, y), top, strict=True)
        ]
        level = z[0] + (z[1] - z[0]) * high
        rings.append(_eaves(now[0], now[1], level, lift * (1 - share) ** 2))
    rings.append([(middle(top[0]), middle(top[1]), z[1] + 0.1)] * 12)
    return loft(rings)


def _eaves(x: Interval, y: Interval, z: float, lift: float) -> list[tuple[float, float, float]]:
    """A rectangle of twelve points, its corners ``lift`` higher than the middles of its sides."""
    bend = 0.32
    xs = [x[0], x[0] + bend * (x[1] - x[0]), x[1] - bend * (x[1] - x[0]), x[1]]
    ys = [y[0], y[0] + bend * (y[1] - y[0]), y[1] - bend * (y[1] - y[0]), y[1]]
    ring = [(px, y[0]) for px in xs] + [(x[1], py) for py in ys[1:]]
    ring += [(px, y[1]) for px in xs[-2::-1]] + [(x[0], py) for py in ys[-2:0:-1]]
    return [(px, py, z + lift * (k % 3 == 0)) for k, (px, py) in enumerate(ring)]


def swept_round(
    radius: float,
    z: Interval,
    at: Spot = (0.0, 0.0),
    sides: int = 8,
    top: float = 0.0,
    lift: float = 0.4,
) -> Mesh:
    """The same over a regular polygon, its corners turned up: pavilions and pagodas."""
    rings = []
    levels = ((0.93, -0.3 * lift, 1.0), (1.0, 0.0, 1.0), (0.4, 0.45, 0.2), (0.0, 1.0, 0.0))
    for share, high, raised in levels:
        reach = top + (radius - top) * share
        level = z[0] + (high if high < 0 else high * (z[1] - z[0]))
        rings.append(_make_cornered_ring(reach, level, lift * raised, at, sides))
    return loft(rings)


def regular(
    radius: float, z: Interval, at: Spot = (0.0, 0.0), sides: int = 8, top: float | None = None
) -> Mesh:
    """An upright prism over a regular polygon with a side, not a corner, to the front; ``top`` is
    its radius above, if another."""
    angle = pi / 2 - pi / sides + np.arange(sides) * tau / sides
    reach = (radius, radius if top is None else top)
    return loft(
        [
            np.column_stack(
                [at[0] + r * np.cos(angle), at[1] + r * np.sin(angle), np.full(sides, high)]
            )
            for r, high in zip(reach, z, strict=True)
        ]
    )


def _make_cornered_ring(
    radius: float, z: float, lift: float, at: Spot, sides: int
) -> list[tuple[float, ...]]:
    found: list[tuple[float, ...]] = []
    for k in range(2 * sides):
        angle = pi / 2 + (k - 1) * pi / sides
        reach = radius * (1.0 if k % 2 == 0 else cos(pi / sides) * 0.97)
        found.append(
            (at[0] + reach * cos(angle), at[1] + reach * sin(angle), z + lift * (k % 2 == 0))
        )
    return found
