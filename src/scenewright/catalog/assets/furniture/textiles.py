"""Rugs, curtains and blinds."""

from __future__ import annotations

from math import pi

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import (
    BLACK,
    FABRIC,
    FABRIC_LIGHT,
    MUSTARD,
    NAVY,
    SAGE_FABRIC,
    SHEER,
    TERRACOTTA,
    WOOL,
)
from scenewright.catalog.assets.model import Parts, parts, pick
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.symbols import Lines, rectangle
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, extrude
from scenewright.geometry.solids import Interval, ball, block, frame, rod, slab


def _rug(size: Size) -> Parts:
    return pick(size, (_lozenge_rug, _striped_rug, _plain_rug))(size)


def _ground(size: Size, edge: float, border: Material, field: Material) -> Stuff:
    w, d, h = size.width / 2, size.depth / 2, size.height
    return {
        border: [slab((-w, w), (-d, d), (0, 0.6 * h), 0.01)],
        field: [block((-w + edge, w - edge), (-d + edge, d - edge), (0.3 * h, 0.8 * h))],
    }


def _striped_rug(size: Size) -> Parts:
    """Bands near both ends, across the longer side."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    edge, long, short = 0.05 * min(w, d), max(w, d), min(w, d)
    found = _ground(size, edge, FABRIC_LIGHT, WOOL)
    for cloth, middle, half in (
        (NAVY, 0.8, 0.05),
        (TERRACOTTA, 0.68, 0.03),
        (MUSTARD, 0.6, 0.015),
        (NAVY, 0.5, 0.015),
    ):
        for s in (-1, 1):
            band = (s * middle * long - half * long, s * middle * long + half * long)
            across = (-short + edge + 0.002, short - edge - 0.002)
            x, y = (band, across) if w >= d else (across, band)
            found.setdefault(cloth, []).append(block(x, y, (0.5 * h, h)))
    return parts(size, found)


def _plain_rug(size: Size) -> Parts:
    """One colour with a light line near the edge."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    found: Stuff = {SAGE_FABRIC: [slab((-w, w), (-d, d), (0, 0.8 * h), 0.01)]}
    found[WOOL] = [_border(w - 0.12 * min(w, d), d - 0.12 * min(w, d), 0.03 * min(w, d), h)]
    return parts(size, found)


def _framed_rug(size: Size) -> Parts:
    """A dark border, a light field with two lines round it: furniture stands on its middle."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    rim = 0.14 * min(w, d)
    found: Stuff = {TERRACOTTA: [slab((-w, w), (-d, d), (0, 0.5 * h), 0.01)]}
    found[WOOL] = [block((-w + rim, w - rim), (-d + rim, d - rim), (0.2 * h, 0.8 * h))]
    found[NAVY] = [
        _border(w - k * rim, d - k * rim, wide * rim, 0.9 * h)
        for k, wide in ((0.5, 0.2), (1.5, 0.12))
    ]
    found[TERRACOTTA].append(_border(w - 2.0 * rim, d - 2.0 * rim, 0.2 * rim, 0.9 * h))
    return parts(size, found)


def _ribbed_rug(size: Size) -> Parts:
    """One colour, woven in flat ribs across."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    ribs = [
        block((a + 0.2 * (b - a), b), (-d + 0.01, d - 0.01), (0.5 * h, h))
        for a, b in spread(-w + 0.01, w - 0.01, 14)
    ]
    return parts(size, {WOOL: [slab((-w, w), (-d, d), (0, 0.6 * h), 0.01)], FABRIC_LIGHT: ribs})


def _checked_rug(size: Size) -> Parts:
    """A field of large squares in three cloths."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    found: Stuff = {WOOL: [slab((-w, w), (-d, d), (0, 0.6 * h), 0.01)]}
    columns, rows = max(2, round(size.width / 0.45)), max(2, round(size.depth / 0.45))
    for i, (a, b) in enumerate(spread(-w + 0.05, w - 0.05, columns)):
        for k, (low, high) in enumerate(spread(-d + 0.05, d - 0.05, rows)):
            if (i + k) % 2 == 0:
                cloth = (MUSTARD, TERRACOTTA, NAVY)[(i + 2 * k) // 2 % 3]
                field = block((a, b), (low, high), (0.5 * h, h))
                found.setdefault(cloth, []).append(field)
    return parts(size, found)


def _border(w: float, d: float, rim: float, h: float) -> Mesh:
    """A flat frame on a rug."""
    upright = frame((-w, w), (0.0, 0.5 * h), (-d, d), rim)
    flat = upright.vertices[:, [0, 2, 1]] + (0, 0, 0.5 * h)
    return Mesh(flat, upright.faces[:, ::-1])


def _lozenge_rug(size: Size) -> Parts:
    """Lozenges within two fine lines and a border."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    edge = min(0.06, 0.1 * min(w, d))
    stripe = min(0.1, 0.12 * min(w, d))
    inner = edge + 2.2 * stripe
    lines = [_border(w - k, d - k, 0.3 * stripe, h) for k in (edge + stripe, edge + 1.7 * stripe)]
    diamonds = _diamonds(w - inner, d - inner, (0.5 * h, h))
    found = _ground(size, edge, FABRIC_LIGHT, WOOL)
    return parts(size, {**found, TERRACOTTA: lines, SAGE_FABRIC: diamonds})


def _diamonds(w: float, d: float, z: Interval) -> list[Mesh]:
    """A few lozenges along the longer side."""
    count = max(1, round(max(w, d) / min(w, d) * 1.5))
    found = []
    for a, b in spread(-max(w, d), max(w, d), count):
        middle, long, short = (a + b) / 2, 0.4 * (b - a), 0.62 * min(w, d)
        ring = [(middle + long, 0), (middle, short), (middle - long, 0), (middle, -short)]
        if d > w:
            ring = [(-y, x) for x, y in ring]
        found.append(extrude(ring, *z))
    return found


def _runner(size: Size) -> Parts:
    """One cloth, two fine lines along its long edges."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    short = min(w, d)
    lines = []
    for middle, half in ((0.72, 0.04), (0.56, 0.02)):
        for side in (-1, 1):
            across = (side * middle * short - half * short, side * middle * short + half * short)
            along = (-max(w, d) + 0.03, max(w, d) - 0.03)
            x, y = (along, across) if w >= d else (across, along)
            lines.append(block(x, y, (0.5 * h, h)))
    return parts(size, {FABRIC: [slab((-w, w), (-d, d), (0, 0.8 * h), 0.01)], WOOL: lines})


def _bath_mat(size: Size) -> Parts:
    """Towelling in one pale cloth, a flat band inside its edge."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    band = _border(w - 0.14 * min(w, d), d - 0.14 * min(w, d), 0.08 * min(w, d), h)
    return parts(size, {FABRIC_LIGHT: [slab((-w, w), (-d, d), (0, 0.8 * h), 0.02)], WOOL: [band]})


def _bordered_rug(size: Size) -> Parts:
    """A light field in a border of the sofa's cloth."""
    return parts(size, _ground(size, 0.12 * min(size.width, size.depth), FABRIC, WOOL))


def _quiet_rug(size: Size) -> Parts:
    return pick(size, (_bordered_rug, _plain_rug, _ribbed_rug))(size)


def _curtain(size: Size) -> Parts:
    """Two drawn-back lengths in folds on a rod."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    each = min(0.3 * size.width, 0.6)
    rail = h - 0.035
    lengths = [
        _folds((-w + 0.02, -w + 0.02 + each), d, rail),
        _folds((w - 0.02 - each, w - 0.02), d, rail),
    ]
    bar = [rod((-w + 0.015, 0, rail + 0.012), (w - 0.015, 0, rail + 0.012), 0.011, sides=8)]
    bar += [
        ball(0.02, min(0.02, d), 0.022, (s * (w - 0.02), 0, rail + 0.012), 8, 4) for s in (-1, 1)
    ]
    return parts(size, {SHEER: lengths, BLACK: bar})


def _blind(size: Size) -> Parts:
    """A roller blind as far as it is let down: a cassette, the cloth and a batten at its foot."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    roll, thin = min(0.07, 0.2 * h), min(0.004, 0.2 * d)
    cloth = block((-w + 0.012, w - 0.012), (-thin, thin), (0.02, h - 0.5 * roll))
    batten = block((-w + 0.008, w - 0.008), (-2.5 * thin, 2.5 * thin), (0, 0.026))
    cassette = slab((-w, w), (-d, d), (h - roll, h), 0.008)
    return parts(size, {SHEER: [cloth], FABRIC_LIGHT: [cassette, batten]})


def _folds(x: Interval, d: float, high: float) -> Mesh:
    waves = max(2, round((x[1] - x[0]) / 0.09))
    share = np.linspace(0, 1, 4 * waves + 1)
    thin = min(0.008, 0.2 * d)
    across = x[0] + share * (x[1] - x[0])
    swing = (d - thin) * np.sin(share * waves * 2 * pi)
    front = np.column_stack([across, swing + thin / 2])
    rear = np.column_stack([across, swing - thin / 2])
    return extrude(np.concatenate([rear, front[::-1]]), 0.0, high)


def _rug_symbol(size: Size) -> Lines:
    return rectangle(size), rectangle(size, min(0.08, 0.1 * min(size[:2])))


def _curtain_symbol(size: Size) -> Lines:
    """Both lengths drawn back, in folds, and the rail between them."""
    w, d = size.width / 2, size.depth / 2
    each = min(0.3 * size.width, 0.6)
    count = max(2, round(each / 0.09))
    share = np.linspace(0, 1, 6 * count + 1)
    wave = 0.9 * d * np.sin(share * count * 2 * pi)
    left = np.column_stack([-w + share * each, wave])
    rail = np.array([(-w + each, 0.0), (w - each, 0.0)])
    return left, left * (-1.0, 1.0), rail


def _blind_symbol(size: Size) -> Lines:
    return rectangle(size), np.array([(-size.width / 2, 0.0), (size.width / 2, 0.0)])


_RUGS = {
    "nordic": _striped_rug,
    "classic": _framed_rug,
    "industrial": _plain_rug,
    "japandi": _ribbed_rug,
    "retro": _checked_rug,
    "boho": _lozenge_rug,
}

ASSETS = (
    Drawing("rug", _rug, _rug_symbol),
    *(
        Drawing("rug", mesh, _rug_symbol, f"rug_{style}", f"{style.capitalize()} rug", style=style)
        for style, mesh in _RUGS.items()
    ),
    Drawing("rug", _quiet_rug, _rug_symbol, "rug_quiet", "Bedroom rug"),
    Drawing("rug", _runner, _rug_symbol, "rug_runner", "Runner"),
    Drawing("rug", _bath_mat, _rug_symbol, "rug_bath", "Bath mat"),
    Drawing("curtain", _curtain, _curtain_symbol),
    Drawing("blind", _blind, _blind_symbol),
)
