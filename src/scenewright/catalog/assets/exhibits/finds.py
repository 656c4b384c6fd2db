"""Fossils, arms and small finds, each about one metre high at the origin."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np

from scenewright.catalog.assets import materials as m
from scenewright.catalog.assets.objects import Stuff, wobble
from scenewright.geometry.mesh import Mesh, loft, rotate_mesh, translate_mesh
from scenewright.geometry.solids import (
    ball,
    block,
    disc,
    lathe,
    limb,
    mesh_is_inside_out,
    profile,
    sheet,
)


def outward(mesh: Mesh) -> Mesh:
    """A closed mesh with its faces looking outwards."""
    return Mesh(mesh.vertices, mesh.faces[:, ::-1]) if mesh_is_inside_out(mesh) else mesh


def draw_helmet() -> Stuff:
    """A helmet with a crest on a stand."""
    dome = [(0.3, 0.16), (0.31, 0.4), (0.28, 0.6), (0.19, 0.74), (0.05, 0.8)]
    crest = [
        (-0.3, 0.5),
        (-0.12, 0.78),
        (0.12, 0.84),
        (0.3, 0.72),
        (0.22, 0.9),
        (0.0, 1.0),
        (-0.26, 0.88),
    ]
    post = disc(0.03, (0.0, 0.2), sides=10)
    return {
        m.BRASS: [lathe(dome, sides=20)],
        m.VELVET: [profile(crest, (-0.025, 0.025))],
        m.BLACK: [post],
    }


def draw_mask() -> Stuff:
    """A gilt face upright on a pin."""
    face = ball(0.3, 0.16, 0.38, (0, 0, 0.6), 18, 12)
    eyes = [ball(0.055, 0.03, 0.028, (s * 0.11, 0.14, 0.66), 8, 5) for s in (-1, 1)]
    mouth = ball(0.09, 0.03, 0.02, (0, 0.135, 0.42), 8, 5)
    nose = limb([(0, 0.15, 0.66), (0, 0.2, 0.51)], (0.02, 0.035), 8)
    pin = disc(0.02, (0.02, 0.4), sides=8)
    return {m.GILT: [face, nose], m.BLACK: [*eyes, mouth, pin, disc(0.12, (0, 0.03), sides=16)]}


def draw_ammonite() -> Stuff:
    """A fossil spiral standing on edge in a cleft block."""
    angle = np.linspace(0.0, 5.2 * pi, 52)
    far = 0.035 * np.exp(0.145 * angle)
    far *= 0.36 / far[-1]
    path = np.column_stack([far * np.cos(angle), 0 * angle, 0.56 + far * np.sin(angle)])
    radii = (0.34 * far * (1 + 0.1 * np.sin(9 * angle))).tolist()
    base = block((-0.22, 0.22), (-0.1, 0.1), (0.0, 0.22))
    return {m.BONE: [limb(path, radii, 8)], m.SLATE: [base]}


def draw_crystals() -> Stuff:
    """A cluster of crystals on its rock."""
    found: Stuff = {m.AMETHYST: [], m.ROCK: [ball(0.36, 0.28, 0.16, (0, 0, 0.15), 12, 7)]}
    for k in range(11):
        a, lean, long = 2.4 * k, 0.12 + 0.3 * wobble(k), 0.35 + 0.5 * wobble(k + 0.4)
        foot = np.array([0.16 * cos(a), 0.12 * sin(a), 0.15])
        way = np.array([lean * cos(a), lean * sin(a), 1.0]) / np.hypot(1.0, lean)
        thick = 0.05 + 0.03 * wobble(k + 0.7)
        tip = [foot, foot + 0.8 * long * way, foot + long * way]
        found[m.AMETHYST].append(limb(tip, (thick, thick, 0.15 * thick), 6))
    return found


def draw_skull() -> Stuff:
    """A skull."""
    eyes = [ball(0.075, 0.05, 0.07, (s * 0.12, 0.24, 0.5), 8, 6) for s in (-1, 1)]
    teeth = [
        block((x - 0.016, x + 0.016), (0.2, 0.225), (0.19, 0.25))
        for x in np.linspace(-0.11, 0.11, 6)
    ]
    return {
        m.BONE: [
            ball(0.29, 0.34, 0.35, (0, -0.06, 0.65), 16, 11),
            ball(0.2, 0.16, 0.22, (0, 0.14, 0.36), 12, 8),
            limb(
                [(-0.18, -0.02, 0.24), (-0.13, 0.18, 0.1), (0.13, 0.18, 0.1), (0.18, -0.02, 0.24)],
                (0.05, 0.06, 0.06, 0.05),
                8,
            ),
            *teeth,
        ],
        m.BLACK: [*eyes, ball(0.035, 0.03, 0.05, (0, 0.285, 0.38), 6, 5)],
    }


def draw_ship() -> Stuff:
    """A model of a sailing ship on a cradle."""
    rim = ((-0.46, 0.06), (-0.3, 0.1), (0.0, 0.115), (0.3, 0.085), (0.48, 0.012))
    rings = []
    for share, z, rise in ((0.3, 0.1, 0.0), (0.75, 0.16, 0.01), (1.0, 0.26, 0.04)):
        right = [(x * (0.86 + 0.14 * share), -y * share, z + rise * (2 * x) ** 2) for x, y in rim]
        rings.append([*right, *[(x, -y, q) for x, y, q in right[::-1]]])
    masts = [
        limb([(x, 0, 0.24), (x, 0, top)], (0.011, 0.006), 6)
        for x, top in ((-0.26, 0.82), (0.02, 1.0), (0.27, 0.85))
    ]
    sails = []
    for x, top in ((-0.26, 0.82), (0.02, 1.0), (0.27, 0.85)):
        for a, b, half in ((0.38, 0.6, 0.17), (0.63, 0.8, 0.13), (0.82, 0.94, 0.09)):
            levels = [0.24 + share * (top - 0.24) for share in (a, (a + b) / 2, b)]
            bow = [
                [(x + 0.015 + 0.035 * bulge, y, level) for y in (-half, half)]
                + [(x + 0.011 + 0.035 * bulge, y, level) for y in (half, -half)]
                for level, bulge in zip(levels, (0.3, 1.0, 0.0), strict=True)
            ]
            mesh = loft(np.array(bow))
            sails.append(outward(mesh))
    hull = loft(rings)
    hull = outward(hull)
    cradle = [block((x - 0.015, x + 0.015), (-0.08, 0.08), (0.02, 0.16)) for x in (-0.22, 0.2)]
    return {
        m.TEAK: [hull],
        m.OAK_DARK: [*masts, *cradle, block((-0.4, 0.4), (-0.1, 0.1), (0, 0.025))],
        m.LINEN: sails,
    }


def draw_tablet() -> Stuff:
    """A slab with lines of writing, leaning on an easel."""
    slab = block((-0.34, 0.34), (-0.04, 0.04), (0.0, 1.0))
    lines = [
        block((-0.28, 0.28 - 0.2 * wobble(k)), (0.038, 0.044), (z, z + 0.03))
        for k, z in enumerate(np.linspace(0.1, 0.86, 9))
    ]
    return {
        m.SANDSTONE: [rotate_mesh(slab, "x", 0.22)],
        m.BRONZE: [rotate_mesh(line, "x", 0.22) for line in lines],
    }


def draw_finds() -> Stuff:
    """Small finds on a tilted board: coins, beads in a ring, a blade."""
    board = block((-0.75, 0.75), (-0.02, 0.02), (0.0, 1.0))
    coins = [rotate_mesh(disc(0.075, (-0.03, 0.0), sides=12), "x", -pi / 2) for _ in range(8)]
    coins = [
        translate_mesh(c, -0.55 + 0.22 * (k % 4), 0.02, 0.68 + 0.2 * (k // 4))
        for k, c in enumerate(coins)
    ]
    beads = [
        ball(0.03, 0.03, 0.03, (-0.35 + 0.2 * cos(a), 0.04, 0.3 + 0.2 * sin(a)), 6, 5)
        for a in np.arange(16) * pi / 8
    ]
    blade = [(0.28, 0.12), (0.36, 0.06), (0.42, 0.62), (0.36, 0.8), (0.3, 0.62)]
    hilt = [(0.3, 0.02), (0.38, 0.02), (0.38, 0.16), (0.3, 0.16)]
    turned = {
        m.LINEN: [board],
        m.GILT: coins,
        m.TURQUOISE: beads,
        m.SILVER: [sheet(blade[::-1], (0.02, 0.035))],
        m.OAK_DARK: [sheet(hilt[::-1], (0.02, 0.05))],
    }
    found: Stuff = {}
    for material, meshes in turned.items():
        righted = [outward(p) for p in meshes]
        found[material] = [rotate_mesh(p, "x", 0.5) for p in righted]
    return found
