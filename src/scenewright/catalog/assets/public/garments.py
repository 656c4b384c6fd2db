"""Clothes as shops show them: on hangers under rails, and on mannequins."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import NamedTuple

import numpy as np

from scenewright.catalog.assets import materials as m
from scenewright.catalog.assets.objects import Stuff, wobble
from scenewright.catalog.assets.public.wares import CLOTHS, merge_by_material
from scenewright.core.catalog import Material
from scenewright.geometry.mesh import Mesh, loft, rotate_mesh
from scenewright.geometry.solids import ball, limb, oval_ring, tube

_HUNG = ((0.78, 1.25, 1.0), (0.7, 1.0, 0.62), (0.74, 0.95, 0.32), (0.8, 0.85, 0.2),
         (0.92, 0.7, 0.07), (0.5, 0.5, 0.02), (0.2, 0.4, 0.0))  # fmt: skip
"""Sections of a garment on a hanger from its hem up: half breadth, half thickness, how far below
the shoulders as a share of its length."""


def hang_garment(
    half: float, rail: float, long: float, seed: int = 0, thick: float = 0.022
) -> tuple[Mesh, list[Mesh]]:
    """The hook of a hanger below a rail along x at the origin, and what hangs on it: shoulders
    across it in y, the cloth in folds, sleeves at its sides."""
    top = rail - 0.075
    turn, sway = 0.5 * (wobble(seed + 0.1) - 0.5), 0.012 * (wobble(seed + 0.7) - 0.5)
    rings = []
    for wide, deep, below in _HUNG:
        angle = np.arange(10) * 2 * pi / 10
        fold = 1 + 0.35 * below * np.sin(3 * angle + 6.3 * wobble(seed))
        ring = np.column_stack(
            [
                deep * thick * fold * np.cos(angle) + sway * below,
                wide * half * np.sin(angle),
                np.full(10, top - below * long),
            ]
        )
        rings.append(ring)
    sleeves = [
        limb(
            [(0.0, s * 0.8 * half, top - 0.05), (0.006, s * 0.96 * half, top - 0.24 * long - 0.1),
             (0.0, s * 0.93 * half, top - 0.5 * min(long, 0.9) - 0.05)],
            (0.9 * thick, 1.1 * thick, 0.9 * thick), 5)
        for s in (-1, 1)
    ]  # fmt: skip
    hook = tube([(0, 0, top - 0.005), (0, 0, rail - 0.03), (0, 0.012, rail + 0.012)], 0.003, 3)
    return hook, [rotate_mesh(part, "z", turn) for part in (loft(rings), *sleeves)]


def hang_row(
    count: int, half: float, rail: float, most: float, seed: int, put: Callable[[int, Mesh], Mesh]
) -> Stuff:
    """Garments in runs of one cut and colour, each ``put`` in its place along a rail."""
    found: Stuff = {m.STEEL: []}
    run, left, long, cloth = 0, 0, 0.0, CLOTHS[0]
    for k in range(count):
        if not left:
            run += 1
            left = 3 + int(3 * wobble(seed + run))
            long = most * (0.55 + 0.45 * wobble(seed + run + 0.4))
            cloth = CLOTHS[int(wobble(seed + 3 * run + 0.2) * len(CLOTHS))]
        hook, drawn = hang_garment(half, rail, long * (0.97 + 0.03 * wobble(k)), seed + k)
        found[m.STEEL].append(put(k, hook))
        found.setdefault(cloth, []).extend(put(k, mesh) for mesh in drawn)
        left -= 1
    return found


_TRUNK = (
    (0.44, 0.062, 0.056, 0.0), (0.475, 0.092, 0.066, 0.0), (0.52, 0.1, 0.069, -0.004),
    (0.57, 0.085, 0.058, 0.002), (0.615, 0.07, 0.05, 0.006), (0.66, 0.077, 0.056, 0.006),
    (0.72, 0.091, 0.066, 0.008), (0.765, 0.095, 0.062, 0.004), (0.8, 0.1, 0.048, 0.0),
    (0.822, 0.088, 0.036, -0.002), (0.838, 0.042, 0.032, 0.0), (0.865, 0.03, 0.031, 0.006),
    (0.885, 0.028, 0.03, 0.01),
)  # fmt: skip
"""Sections of a standing body from crotch to chin: height, half breadth, half depth and how far
ahead, as shares of its height (after the means of DIN 33402-2)."""
_LEG = ((0.085, 0.02, 0.02), (0.052, 0.46, 0.055), (0.056, 0.27, 0.036), (0.058, 0.2, 0.034),
        (0.06, 0.05, 0.02))  # fmt: skip
"""A leg from the hip down: how far aside, how high, how thick."""
_ARM = ((0.103, 0.0, 0.797, 0.026), (0.13, -0.012, 0.66, 0.022), (0.128, 0.004, 0.61, 0.019),
        (0.13, 0.035, 0.5, 0.015), (0.128, 0.05, 0.455, 0.017))  # fmt: skip
"""An arm from the shoulder down: aside, ahead, how high, how thick."""


class Outfit(NamedTuple):
    """What a mannequin wears: how low its upper and its lower part reach, how wide the hem flares,
    which shares of arms and legs are covered, how loose it is; ``stand``: a bust on a post."""

    name: str
    upper: float
    hem: float
    flare: float
    sleeves: float
    legs: float
    loose: float = 1.1
    stand: bool = False


OUTFITS = (
    Outfit("dress", 0.56, 0.36, 1.9, 0.35, 0.0),
    Outfit("suit", 0.43, 0.43, 1.12, 1.0, 1.0, 1.16),
    Outfit("shirt and jeans", 0.5, 0.43, 1.05, 0.4, 1.0, 1.1),
    Outfit("blouse and skirt", 0.55, 0.27, 1.5, 1.0, 0.0, 1.08),
    Outfit("long coat", 0.24, 0.24, 1.45, 1.0, 1.0, 1.24),
    Outfit("jacket on a bust", 0.46, 0.46, 1.1, 0.0, 0.0, 1.1, stand=True),
)


def trunk(h: float, low: float, high: float, loose: float, flare: float) -> Mesh:
    """A body between two heights; below the hips a hem that flares."""
    table = np.array(_TRUNK)
    levels = [low, *(z for z in table[:, 0] if low + 0.015 < z < high - 0.01), high]
    rings = []
    for z in levels:
        wide, deep, ahead = (float(np.interp(z, table[:, 0], table[:, k])) for k in (1, 2, 3))
        if z < 0.52:
            share = (0.52 - z) / max(0.52 - low, 1e-9)
            wide, deep = 0.1 * (1 + (flare - 1) * share), 0.069 * (1 + (flare - 1) * share)
        ring = oval_ring(wide * h * loose, deep * h * loose, z * h, 16, (0.0, ahead * h))
        if flare > 1.3 and z < 0.5:
            ring[:, :2] *= (1 + 0.05 * (-1) ** np.arange(16))[:, None]
        rings.append(ring)
    return loft(rings)


def _arms(h: float, share: float, loose: float, from_wrist: bool = False) -> list[Mesh]:
    """Arms down to a share of their length, or from it on."""
    cut = round(share * (len(_ARM) - 1))
    rows = _ARM[cut:] if from_wrist else _ARM[: cut + 1]
    if len(rows) < 2:
        return []
    return [
        limb([(s * x * h, y * h, z * h) for x, y, z, _ in rows],
             [r * h * loose for *_, r in rows], 8)
        for s in (-1, 1)
    ]  # fmt: skip


def dress_mannequin(h: float, outfit: Outfit, seed: int) -> Stuff:
    """A mannequin ``h`` metres high in an outfit, in the colours of a seed."""
    upper = CLOTHS[int(wobble(seed) * len(CLOTHS))]
    lower: Material = (m.CHARCOAL, m.DENIM, m.LINEN, m.NAVY)[int(wobble(seed + 0.5) * 4)]
    body: list[Mesh] = [trunk(h, 0.8, 0.885, 1.0, 1.0)]
    found: Stuff = {upper: [trunk(h, outfit.upper, 0.836, outfit.loose, outfit.flare)]}
    if outfit.upper > outfit.hem:
        below = trunk(h, outfit.hem, outfit.upper + 0.03, outfit.loose * 0.97, outfit.flare)
        found.setdefault(lower, []).append(below)
    if outfit.stand:
        post = [limb([(0, 0, 0.02), (0, 0, outfit.upper * h)], (0.015, 0.015), 8)]
        knob = [ball(0.03, 0.03, 0.03, (0, 0.01 * h, 0.9 * h), 8, 6)]
        return merge_by_material(found, {m.CHROME: post, m.LINEN: body, m.OAK: knob})
    legs = [[(s * x * h, 0.0, z * h) for x, z, _ in ((0.05, 0.49, 0), *_LEG[1:])] for s in (-1, 1)]
    thick = [0.052 * h, *(r * h for *_, r in _LEG[1:])]
    feet = [
        ball(0.028 * h, 0.07 * h, 0.024 * h, (s * 0.06 * h, 0.03 * h, 0.03 * h), 8, 5)
        for s in (-1, 1)
    ]
    head = ball(0.043 * h, 0.055 * h, 0.066 * h, (0, 0.014 * h, 0.934 * h), 12, 8)
    body += [*(limb(leg, thick, 8) for leg in legs), *feet, head]
    if outfit.legs:
        loose = [1.18 * r + 0.008 for r in thick[:-1]] + [0.036 * h]
        found.setdefault(lower, []).extend(limb(leg, loose, 8) for leg in legs)
    if outfit.sleeves:
        found[upper].extend(_arms(h, outfit.sleeves, outfit.loose * 1.2))
    body += _arms(h, 1.0, 1.0)
    return merge_by_material(found, {m.GREIGE if seed % 2 else m.WHITE: body})
