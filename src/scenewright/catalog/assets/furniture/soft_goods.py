"""Soft things people leave about: cushions, throws, towels, shoes, bags, hats, teddies, balls."""

from __future__ import annotations

from math import pi

import numpy as np

from scenewright.catalog.assets.furniture.tableware import in_colours
from scenewright.catalog.assets.materials import (
    ACCENT,
    CHARCOAL,
    CREAM,
    FABRIC_LIGHT,
    LEATHER,
    LINEN,
    MUSTARD,
    NAVY,
    OAK,
    RED,
    SAGE_FABRIC,
    TERRACOTTA,
    WALNUT,
    WHITE,
    WOOL,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.symbols import round_plain
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh
from scenewright.geometry.solids import ball, block, cushion, lathe, slab, tube

LEAN = 0.28
"""How far a cushion leans back, radians: with the slope of a sofa's back."""


def _flatten(mesh: Mesh, level: float) -> Mesh:
    """A mesh pressed flat below, as what is soft or heavy rests."""
    return Mesh(np.maximum(mesh.vertices, (-np.inf, -np.inf, level)), mesh.faces)


def _cushion(size: Size, cloth: Material) -> Parts:
    """A square pillow with a piped seam, leaning on what is behind it."""
    w, h = size.width / 2, size.height
    thick = max(size.depth - 0.25 * h, 0.08) / 2
    body = cushion((-w, w), (-thick, thick), (0, h), thick, 3, 0.6)
    return parts(size, {cloth: [rotate_mesh(body, "x", LEAN)]})


def _throw(size: Size, cloth: Material) -> Parts:
    """A folded blanket: three layers, the last turned back, and a fringe."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    layers = [
        cushion(
            (-w + 0.012 * k, w - 0.006 * k),
            (-0.94 * d, d - 0.02 * k),
            (k * h / 3, (k + 1.06) * h / 3),
            0.16 * h,
            2,
        )
        for k in range(3)
    ]
    fringe = [
        block((x - 0.006, x + 0.006), (-d, -0.9 * d), (0.02 * h, 0.16 * h))
        for x in (-w + 2 * w * (k + 0.5) / 16 for k in range(16))
    ]
    return parts(size, {cloth: layers, LINEN: fringe})


def _towels(size: Size, cloth: Material) -> Parts:
    """A pile of folded towels."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    count = max(1, round(h / 0.045))
    found: Stuff = {cloth: [], LINEN: []}
    for k in range(count):
        x, level = w - 0.006 * (k % 3), (k * h / count, (k + 1) * h / count)
        found[(cloth, LINEN)[k % 2]].append(
            cushion((-x, x), (-d + 0.005 * (k % 2), d), level, 0.45 * h / count, 2)
        )
    return parts(size, found)


def _rolled_towel(size: Size, cloth: Material) -> Parts:
    w, r, h = size.width / 2, size.depth / 2, size.height
    roll = lathe(
        [(0.9 * r, -w), (r, -0.96 * w), (r, 0.96 * w), (0.9 * r, w)], sides=14, squash=h / (2 * r)
    )
    return parts(size, {cloth: [_flatten(rotate_mesh(roll, "y", pi / 2), -0.42 * h)]})


def _shoes(size: Size, upper: Material) -> Parts:
    """A pair side by side, toes to the front."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    made: Stuff = {upper: [], WHITE: []}
    for s in (-1, 1):
        x = (s * 0.54 * w - 0.44 * w, s * 0.54 * w + 0.44 * w)
        made[WHITE].append(slab(x, (-d, d), (0, 0.22 * h), 0.03))
        toe = cushion(x, (-0.1 * d, 0.97 * d), (0.2 * h, 0.62 * h), 0.03)
        made[upper] += [
            toe,
            cushion((x[0] + 0.004, x[1] - 0.004), (-0.97 * d, 0.25 * d), (0.2 * h, h), 0.03),
        ]
    return parts(size, made)


def _teddy(size: Size, fur: Material) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    body = _flatten(ball(0.62 * w, 0.62 * d, 0.3 * h, (0, -0.2 * d, 0.3 * h)), 0.03 * h)
    head = ball(0.5 * w, 0.5 * d, 0.21 * h, (0, -0.15 * d, 0.72 * h))
    ears = [
        ball(0.16 * w, 0.12 * d, 0.09 * h, (s * 0.4 * w, -0.15 * d, 0.91 * h), 8, 4)
        for s in (-1, 1)
    ]
    limbs = [
        ball(0.2 * w, 0.45 * d, 0.11 * h, (s * 0.5 * w, 0.5 * d, 0.11 * h), 8, 4) for s in (-1, 1)
    ]
    arms = [ball(0.2 * w, 0.22 * d, 0.17 * h, (s * 0.75 * w, 0, 0.42 * h), 8, 4) for s in (-1, 1)]
    snout = ball(0.22 * w, 0.2 * d, 0.07 * h, (0, 0.32 * d, 0.67 * h), 8, 4)
    return parts(
        size,
        {
            fur: [body, head, *ears, *(_flatten(limb, 0.03 * h) for limb in limbs), *arms],
            WOOL: [snout],
        },
    )


def _ball(size: Size, skin: Material) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    return parts(size, {skin: [_flatten(ball(w, d, h / 2, (0, 0, h / 2), 14, 8), 0.03 * h)]})


def _bag(size: Size, skin: Material) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    body = cushion((-w, w), (-d, d), (0, 0.68 * h), 0.03, 2)
    bow = [
        (-0.5 * w, 0, 0.64 * h),
        (-0.42 * w, 0, 0.97 * h),
        (0.42 * w, 0, 0.97 * h),
        (0.5 * w, 0, 0.64 * h),
    ]
    return parts(size, {skin: [body, tube(bow, 0.007, 6)]})


def _hat(size: Size, felt: Material) -> Parts:
    w, h = size.width / 2, size.height
    brim = [(w, 0), (w, 0.06 * h), (0.6 * w, 0.12 * h), (0.55 * w, 0.9 * h), (0.3 * w, h)]
    return parts(size, {felt: [lathe(brim, sides=18, squash=size.depth / size.width)]})


ASSETS = (
    *in_colours("cushion", _cushion, (SAGE_FABRIC, TERRACOTTA, MUSTARD, LINEN, NAVY)),
    *in_colours("throw", _throw, (WOOL, TERRACOTTA, SAGE_FABRIC, NAVY)),
    *in_colours("towels", _towels, (WHITE, SAGE_FABRIC, NAVY)),
    *in_colours("rolled_towel", _rolled_towel, (LINEN, SAGE_FABRIC, TERRACOTTA)),
    *in_colours("shoes", _shoes, (NAVY, LEATHER, CHARCOAL, TERRACOTTA)),
    *in_colours("teddy", _teddy, (WALNUT, CREAM, OAK)),
    *in_colours("ball", _ball, (RED, MUSTARD, ACCENT), round_plain),
    *in_colours("bag", _bag, (LEATHER, CHARCOAL, SAGE_FABRIC)),
    *in_colours("hat", _hat, (FABRIC_LIGHT, CHARCOAL), round_plain),
)
