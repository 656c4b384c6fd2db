"""Kitchen units to cook and wash up at: sinks, hobs, ovens, dishwashers, fridges."""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.bodies import lever_joint
from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.furniture.kitchen import (
    HANDLE,
    PLINTH,
    TOP,
    doors,
    drawers,
    unit,
    unit_symbol,
)
from scenewright.catalog.assets.joinery import door_pulls, front, fronts
from scenewright.catalog.assets.materials import (
    BLACK,
    CERAMIC_GLASS,
    CHROME,
    GREY,
    RUBBER,
    SAGE,
    STEEL,
    STONE,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.symbols import Lines, box, oval, path, rectangle
from scenewright.catalog.classes import WORKTOP
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, block, disc, pipe, rod, slab, trough, tube

UNDER_WORKTOP, BUILT_IN = 0.95, 0.89
"""A fridge no higher than this has the worktop on it, and a washing machine as high as this or
more, metres."""


def has_worktop(category: str, height: float) -> bool:
    """Whether worktop lies on a unit of a kitchen of a kind and height.

    >>> has_worktop("washing_machine", 0.85), has_worktop("washing_machine", 0.9)
    (False, True)
    """
    built_in = category == "washing_machine" and height >= BUILT_IN
    under = height <= UNDER_WORKTOP and (category == "fridge" or built_in)
    return under or category in WORKTOP


def _sink_cabinet(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(h, 0.9) if h > 1.0 else h
    found, x, z, face = unit(Size(size.width, size.depth, top), top=False)
    doors(found, x, z, face, 2 if size.width > 0.65 else 1)
    half = min(w - 0.05, 0.36)
    hole, bowl_y = (-d + 0.05, d - 0.1), (-d + 0.14, d - 0.1)
    under, high = top - TOP, (top - TOP, top)
    found[WHITE] = [trough(x, (-d, face), (PLINTH, under), 0.015, under - 0.19)]
    found[STONE] = [
        block((-w, w), (hole[1], d), high),
        block((-w, w), (-d, hole[0]), high),
        block((-w, -half), hole, high),
        block((half, w), hole, high),
    ]
    found[STEEL] = [
        trough((-half, half), bowl_y, (under - 0.18, top - 0.006), 0.012, under - 0.17, 0.03, 0.01),
        block((-half, half), (hole[0], bowl_y[0]), (under - 0.02, under)),
        disc(0.03, (under - 0.171, under - 0.166), (0, sum(bowl_y) / 2), 12),
    ]
    found[CHROME] = _tap(0.0, -d + 0.095, under, h - 0.004 if h > 1.0 else top, 0.2)
    return parts(size, found)


def _tap(x: float, y: float, low: float, high: float, reach: float) -> list[Mesh]:
    """A swan-necked tap and its lever."""
    bow = min(0.05, (high - low) / 3)
    neck = [
        (x, y, low),
        (x, y, high - bow),
        (x, y + bow, high - 0.012),
        (x, y + reach - bow, high - 0.012),
        (x, y + reach, high - 0.05),
    ]
    if high - low < 0.1:
        neck = [(x, y, low), (x, y, high - 0.012), (x, y + reach, high - 0.012)]
    ends = (x + 0.02, y, low + 0.4 * (high - low)), (x + 0.08, y, low + 0.6 * (high - low))
    lever = rod(*ends, 0.008)._replace(joint=lever_joint(*ends))
    return [tube(neck, 0.012, 8), disc(0.024, (low, low + 0.012), (x, y), 12), lever]


def _hob(size: Size, low: float) -> Stuff:
    w, d, h = size.width / 2, size.depth / 2, size.height
    half = min(w - 0.02, 0.29) if size.width < 0.85 else min(w - 0.05, 0.38)
    front = d - 0.06
    plate = slab((-half, half), (-d + 0.06, front), (low, h - 0.002), 0.015)
    rings = [
        pipe(r, r - 0.012, (h - 0.003, h), (sx * 0.5 * half, y), 20)
        for sx, y, r in _burners(half, (-d + 0.06, front))
    ]
    knobs = [
        disc(0.012, (h - 0.003, h), (k * 0.05, front - 0.035), 8) for k in (-1.5, -0.5, 0.5, 1.5)
    ]
    return {CERAMIC_GLASS: [plate], GREY: [*rings, *knobs]}


def _burners(half: float, y: Interval) -> list[tuple[float, float, float]]:
    """Side, y and radius of the four rings of a hob; two if it is narrow."""
    deep = y[1] - y[0]
    back, front = y[0] + 0.27 * deep, y[0] + 0.66 * deep
    big, small = min(0.105, 0.4 * half), min(0.08, 0.32 * half)
    if half < 0.2:
        radius = min(0.09, 0.7 * half)
        return [(0.0, back, radius), (0.0, front, radius * 0.85)]
    return [(-1, back, big), (1, back, small), (-1, front, small), (1, front, big)]


def _bar(x: Interval, face: float, z: float) -> list[Mesh]:
    """A round bar handle on two stays."""
    stays = [
        block((at - 0.006, at + 0.006), (face + 0.017, face + 0.034), (z - 0.006, z + 0.006))
        for at in (x[0] + 0.02, x[1] - 0.02)
    ]
    return [rod((x[0], face + 0.036, z), (x[1], face + 0.036, z), 0.009), *stays]


def _oven(found: Stuff, x: Interval, z: Interval, face: float) -> None:
    """An oven front: panel with knobs, window, bar handle."""
    wide = min(x[1] - x[0], 0.6) / 2
    if x[1] > wide + 0.02:
        for beside in ((x[0], -wide), (wide, x[1])):
            found[SAGE] += fronts(beside, z, 1, 1, (face, face + 0.018), "door")
    x = (-wide, wide)
    low, high = max(z[0], z[1] - 0.6), z[1]
    panel = high - 0.1
    across, up = (x[0] + 0.005, x[1] - 0.005), (low + 0.004, panel - 0.003)
    glass = front(across, up, (face, face + 0.018), "flap")
    window = ((x[0] + 0.09, x[1] - 0.09), (face + 0.017, face + 0.02), (low + 0.12, panel - 0.11))
    found.setdefault(CERAMIC_GLASS, []).append(glass)
    found.setdefault(GREY, []).append(block(*window))
    found.setdefault(STEEL, []).extend(
        [
            block((x[0] + 0.005, x[1] - 0.005), (face, face + 0.018), (panel, high - 0.003)),
            *_bar((x[0] + 0.05, x[1] - 0.05), face, panel - 0.05),
        ]
    )
    found[RUBBER] += [
        rod(
            (k * wide / 2.2, face + 0.015, high - 0.05),
            (k * wide / 2.2, face + 0.036, high - 0.05),
            0.017,
            sides=10,
        )
        for k in (-1.5, -0.5, 0.5, 1.5)
    ]
    if low > z[0] + 0.05:
        drawers(found, x, (z[0], low), face, [1.0])


def _hob_cabinet(size: Size) -> Parts:
    found, x, z, face = unit(Size(size.width, size.depth, size.height - 0.008))
    if size.width > 0.5:
        _oven(found, x, z, face)
    else:
        drawers(found, x, z, face, [0.4, 0.36, 0.24])
    for material, meshes in _hob(size, size.height - 0.009).items():
        found.setdefault(material, []).extend(meshes)
    return parts(size, found)


def _oven_cabinet(size: Size) -> Parts:
    found, x, z, face = unit(size)
    _oven(found, x, z, face)
    return parts(size, found)


def _dishwasher(size: Size) -> Parts:
    found, x, z, face = unit(size)
    strip = z[1] - 0.11
    wide = (x[0] + 0.004, x[1] - 0.004)
    found[STEEL] = [
        front(wide, (z[0] + 0.004, strip), (face, face + 0.018), "flap"),
        *_bar((x[0] + 0.08, x[1] - 0.08), face, strip - 0.05),
    ]
    found[RUBBER].append(block(wide, (face, face + 0.016), (strip + 0.004, z[1] - 0.004)))
    found[GREY] = [
        block(
            (x[1] - 0.16, x[1] - 0.08), (face + 0.015, face + 0.018), (strip + 0.04, strip + 0.07)
        )
    ]
    return parts(size, found)


def _low_fridge(size: Size) -> Parts:
    """A fridge under the worktop: one door, a grille in the plinth."""
    found, x, z, face = unit(size)
    wide = (x[0] + 0.004, x[1] - 0.004)
    found[STEEL] = [front(wide, (z[0] + 0.004, z[1] - 0.004), (face, face + 0.018), "door")]
    found[BLACK] = door_pulls(x, z, 1, face + 0.018, HANDLE, 0.7, 0.45)
    slats = np.linspace(0.03, PLINTH - 0.02, 4).tolist()
    across = (x[0] + 0.08, x[1] - 0.08)
    found[GREY] = [block(across, (face - 0.041, face - 0.03), (s, s + 0.008)) for s in slats]
    return parts(size, found)


def _fridge(size: Size) -> Parts:
    if size.height <= UNDER_WORKTOP:
        return _low_fridge(size)
    w, d, h = size.width / 2, size.depth / 2, size.height
    face = d - 0.075
    columns = 2 if size.width > 0.8 else 1
    split = 0.36 * h if h > 1.3 else 0.02
    doors = fronts((-w, w), (split, h), columns, 1, (face, face + 0.045), "door")
    pulls = door_pulls(
        (-w, w),
        (split, h),
        columns,
        face + 0.045,
        0.03,
        0.3 if h > 1.3 else 0.7,
        0.45 * (h - split),
    )
    if split > 0.1:
        doors += fronts((-w, w), (0.02, split), 1, 1, (face, face + 0.045), "door")
        pulls += door_pulls((-w, w), (0.02, split), 1, face + 0.045, 0.03, 0.7, 0.3)
    display = block((-w + 0.1, -w + 0.18), (face + 0.044, face + 0.047), (0.62 * h, 0.66 * h))
    return parts(
        size,
        {
            GREY: [block((-w, w), (-d, face - 0.006), (0.02, h))],
            STEEL: doors,
            BLACK: [*pulls, block((-w + 0.03, w - 0.03), (-d + 0.03, face - 0.02), (0, 0.03))],
            CERAMIC_GLASS: [display] if h > 1.3 else [],
        },
    )


def _sink_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    half = min(w - 0.05, 0.36)
    y = (-d + 0.1, d - 0.1)
    middle = sum(y) / 2
    return (
        rectangle(size),
        box(-half, half, *y, 0.06),
        oval(0, middle, 0.03),
        oval(0, -d + 0.06, 0.022),
        path((0, -d + 0.06), (0, -d + 0.22)),
    )


def _hob_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    half = min(w - 0.02, 0.29) if size.width < 0.85 else min(w - 0.05, 0.38)
    y = (-d + 0.06, d - 0.06)
    rings = [oval(s * 0.5 * half, yy, r) for s, yy, r in _burners(half, y)]
    return rectangle(size), box(-half, half, *y, 0.02), *rings


def _oven_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return *unit_symbol(size), box(-w + 0.06, w - 0.06, -d + 0.06, d - 0.1)


def _dishwasher_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    y = d - 0.04
    return (
        *unit_symbol(size),
        path((-w, -d), (w, y)),
        path((-w, y), (w, -d)),
        oval(0, (y - d) / 2, 0.35 * w),
    )


def _fridge_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    line = d - 0.07
    star = [
        path((-0.16 * w * a, -0.16 * w * b - 0.03), (0.16 * w * a, 0.16 * w * b - 0.03))
        for a, b in ((2, 0), (1, 1.73), (1, -1.73))
    ]
    return rectangle(size), path((-w, line), (w, line)), *star


ASSETS = (
    Drawing("sink_cabinet", _sink_cabinet, _sink_symbol),
    Drawing("hob_cabinet", _hob_cabinet, _hob_symbol),
    Drawing("oven_cabinet", _oven_cabinet, _oven_symbol),
    Drawing("dishwasher", _dishwasher, _dishwasher_symbol),
    Drawing("fridge", _fridge, _fridge_symbol),
)
