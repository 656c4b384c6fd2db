"""What museums show: vessels, busts, bronzes, fossils, small finds, each one metre high at the
origin, to be fitted to a case, a plinth or a podium."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import cos, pi, sin

import numpy as np

from scenewright.catalog.assets import materials as m
from scenewright.catalog.assets.exhibits.finds import (
    draw_ammonite,
    draw_crystals,
    draw_finds,
    draw_helmet,
    draw_mask,
    draw_ship,
    draw_skull,
    draw_tablet,
    outward,
)
from scenewright.catalog.assets.objects import Stuff, wobble
from scenewright.catalog.assets.public.garments import OUTFITS, dress_mannequin, trunk
from scenewright.catalog.assets.public.wares import merge_by_material
from scenewright.core.catalog import Material
from scenewright.geometry.mesh import Mesh, loft, rotate_mesh, translate_mesh
from scenewright.geometry.solids import (
    Interval,
    ball,
    block,
    connect_rings,
    disc,
    lathe,
    limb,
    profile,
    rectangle_ring,
    tube,
)

Profile = tuple[tuple[float, float], ...]
AMPHORA: Profile = (
    (0.05, 0),
    (0.06, 0.05),
    (0.13, 0.2),
    (0.235, 0.45),
    (0.25, 0.6),
    (0.2, 0.72),
    (0.085, 0.8),
    (0.075, 0.92),
    (0.11, 0.96),
    (0.11, 1.0),
    (0.08, 0.98),
)
KRATER: Profile = (
    (0.17, 0),
    (0.17, 0.06),
    (0.07, 0.12),
    (0.09, 0.22),
    (0.33, 0.5),
    (0.4, 0.75),
    (0.37, 0.88),
    (0.44, 0.97),
    (0.44, 1.0),
    (0.38, 0.97),
    (0.3, 0.6),
)
JUG: Profile = (
    (0.16, 0),
    (0.24, 0.2),
    (0.28, 0.42),
    (0.22, 0.62),
    (0.1, 0.74),
    (0.09, 0.9),
    (0.15, 1.0),
    (0.11, 0.98),
    (0.07, 0.8),
)
BOTTLE: Profile = (
    (0.14, 0),
    (0.2, 0.08),
    (0.21, 0.4),
    (0.13, 0.55),
    (0.055, 0.65),
    (0.05, 0.9),
    (0.09, 1.0),
    (0.06, 0.98),
)


def _turned(
    body: Material, rows: Profile, bands: Sequence[Interval], paint: Material, handles: Profile = ()
) -> Stuff:
    """A vessel with painted bands, two handles through points of radius and height."""
    radii, heights = np.array(rows).T
    top = int(heights.argmax())
    found: Stuff = {body: [lathe(rows, sides=16)], paint: []}
    for low, high in bands:
        inside = [z for z in heights[:top] if low < z < high]
        ring = [(float(np.interp(z, heights[:top], radii[:top])), z) for z in (low, *inside, high)]
        outer = [(r + 0.003, z) for r, z in ring]
        inner = [(r - 0.02, z) for r, z in ring[::-1]]
        circle = np.arange(16) * pi / 8
        stack = [
            np.column_stack([r * np.cos(circle), r * np.sin(circle), np.full(16, z)])
            for r, z in (*outer, *inner)
        ]
        found[paint].append(connect_rings(np.array(stack)))
    for s in (-1, 1) if handles else ():
        found[body].append(tube([(s * r, 0.0, z) for r, z in handles], 0.02, 8))
    return found


def _bust() -> Stuff:
    """Head and shoulders of marble on a round socle."""
    h = 2.05
    shift = (0.0, 0.0, 0.13 - 0.705 * h)
    body = trunk(h, 0.705, 0.885, 1.0, 1.0)
    x, z = 0.0, 0.93 * h
    head = [
        ball(0.043 * h, 0.056 * h, 0.066 * h, (x, 0.02 * h, z), 16, 12),
        ball(0.046 * h, 0.055 * h, 0.05 * h, (x, 0.005 * h, z + 0.026 * h), 14, 8),
        limb(
            [(x, 0.072 * h, z + 0.012 * h), (x, 0.086 * h, z - 0.014 * h)],
            (0.006 * h, 0.011 * h),
            6,
        ),
        *(
            ball(0.008 * h, 0.014 * h, 0.02 * h, (s * 0.045 * h, 0.012 * h, z), 6, 5)
            for s in (-1, 1)
        ),
        limb(
            [(-0.014 * h, 0.068 * h, z - 0.03 * h), (0.014 * h, 0.068 * h, z - 0.03 * h)],
            (0.007 * h, 0.007 * h),
            6,
        ),
    ]
    placed = [translate_mesh(part, *shift) for part in (body, *head)]
    socle = lathe([(0.16, 0), (0.16, 0.03), (0.1, 0.06), (0.09, 0.11), (0.14, 0.14)], sides=20)
    return {m.MARBLE: [*placed, socle]}


def _torso() -> Stuff:
    """A body without head and limbs, of marble."""
    h = 2.3
    stumps = [
        limb(
            [(s * 0.05 * h, 0, 0.5 * h), (s * 0.055 * h, 0.01 * h, 0.38 * h)],
            (0.05 * h, 0.042 * h),
            12,
        )
        for s in (-1, 1)
    ]
    arms = [
        limb(
            [(s * 0.085 * h, 0, 0.79 * h), (s * 0.12 * h, 0, 0.73 * h)], (0.028 * h, 0.025 * h), 10
        )
        for s in (-1, 1)
    ]
    return {
        m.LIMESTONE: [
            translate_mesh(one, 0, 0, -0.37 * h)
            for one in (trunk(h, 0.44, 0.845, 1.05, 1.0), *stumps, *arms)
        ]
    }


def _ring() -> Stuff:
    """An abstract ring of bronze, thick below and thin above."""
    rings = []
    for k in range(22):
        a = 2 * pi * k / 22
        thick = 0.075 * (1.7 + 0.9 * cos(a)) / 1.7
        centre = np.array([0.34 * sin(a), 0.0, 0.5 - 0.37 * cos(a)])
        around, out = np.arange(10) * pi / 5, np.array([sin(a), 0.0, -cos(a)])
        cross = np.outer(np.cos(around), out) + np.outer(np.sin(around), [0.25, 1.0, 0.0])
        rings.append(centre + thick * cross)
    body = connect_rings(np.array(rings))
    body = outward(body)
    return {m.BRONZE: [body], m.SLATE: [block((-0.14, 0.14), (-0.12, 0.12), (0.0, 0.06))]}


def _column() -> Stuff:
    """A twisted column of patinated bronze."""
    rings = []
    for z in np.linspace(0.04, 1.0, 24):
        half = 0.13 + 0.05 * sin(5.2 * z)
        ring = rectangle_ring((-half, half), (-0.6 * half, 0.6 * half), float(z), 0.4 * half, 2)
        a = 2.6 * z
        flat = ring[:, :2] @ np.array([[cos(a), sin(a)], [-sin(a), cos(a)]])
        rings.append(np.column_stack([flat, ring[:, 2]]))
    return {m.PATINA: [loft(rings)], m.BLACK: [disc(0.18, (0.0, 0.05), sides=20)]}


def _pebbles() -> Stuff:
    """Three rounded stones balanced on one another."""
    rows = (
        (0.3, 0.22, 0.2, 0.02, 0.2),
        (0.19, 0.16, 0.17, -0.05, 0.56),
        (0.11, 0.1, 0.14, 0.03, 0.86),
    )
    return {
        material: [ball(rx, ry, rz, (x, 0.0, z), 16, 10)]
        for material, (rx, ry, rz, x, z) in zip(
            (m.MARBLE, m.SLATE, m.TERRACOTTA), rows, strict=True
        )
    }


def _capital() -> Stuff:
    """The stump of a fluted column with its capital."""
    angle = np.arange(32) * pi / 16
    flute = 1 - 0.06 * (np.arange(32) % 2)
    rings = [
        np.column_stack(
            [0.22 * r * flute * np.cos(angle), 0.22 * r * flute * np.sin(angle), np.full(32, z)]
        )
        for r, z in ((1.0, 0.05), (0.95, 0.72))
    ]
    echinus = lathe([(0.21, 0.72), (0.24, 0.76), (0.34, 0.86)], sides=24)
    return {
        m.MARBLE: [
            loft(rings),
            echinus,
            block((-0.34, 0.34), (-0.34, 0.34), (0.86, 1.0)),
            block((-0.28, 0.28), (-0.28, 0.28), (0.0, 0.05)),
        ]
    }


def _sarcophagus() -> Stuff:
    """A stone chest under a lid like a roof, with columns along it."""
    body = block((-0.95, 0.95), (-0.4, 0.4), (0.06, 0.66))
    lid = profile(
        [(-0.46, 0.68), (0.46, 0.68), (0.46, 0.74), (0.0, 1.0), (-0.46, 0.74)], (-1.0, 1.0)
    )
    posts = [
        disc(0.045, (0.1, 0.66), (x, s * 0.42), 10)
        for x in np.linspace(-0.86, 0.86, 6)
        for s in (-1, 1)
    ]
    return {
        m.LIMESTONE: [
            body,
            lid,
            *posts,
            block((-1.0, 1.0), (-0.48, 0.48), (0.0, 0.1)),
            block((-1.0, 1.0), (-0.47, 0.47), (0.64, 0.685)),
        ]
    }


_HANDLES: Profile = ((0.2, 0.7), (0.22, 0.8), (0.17, 0.9), (0.08, 0.9))
TREASURES: dict[str, Callable[[], Stuff]] = {
    "amphora": lambda: _turned(
        m.OCHRE_CLAY, AMPHORA, ((0.3, 0.34), (0.42, 0.58), (0.66, 0.7)), m.EARTHENWARE, _HANDLES
    ),
    "krater": lambda: _turned(m.EARTHENWARE, KRATER, ((0.42, 0.46), (0.55, 0.72)), m.OCHRE_CLAY),
    "jug": lambda: _turned(m.CERAMIC, JUG, ((0.2, 0.4), (0.5, 0.54)), m.ACCENT),
    "bottle": lambda: _turned(m.TURQUOISE, BOTTLE, ((0.1, 0.14), (0.36, 0.4)), m.GILT),
    "bust": _bust,
    "torso": _torso,
    "ring": _ring,
    "column": _column,
    "pebbles": _pebbles,
    "helmet": draw_helmet,
    "mask": draw_mask,
    "ammonite": draw_ammonite,
    "crystals": draw_crystals,
    "skull": draw_skull,
    "ship": draw_ship,
    "tablet": draw_tablet,
    "finds": draw_finds,
    "capital": _capital,
    "coat": lambda: dress_mannequin(1.8, OUTFITS[4], 3),
    "gown": lambda: dress_mannequin(1.8, OUTFITS[0], 4),
    "sarcophagus": _sarcophagus,
}
"""Things to show, by name: meshes of each."""


def show(name: str, x: Interval, y: Interval, z: Interval, turn: float = 0.0) -> Stuff:
    """A treasure on the floor of a box, in its middle, as large as fits with its own shape."""
    drawn = TREASURES[name]()
    points = np.concatenate([part.vertices for meshes in drawn.values() for part in meshes])
    if turn:
        drawn = {k: [rotate_mesh(p, "z", turn) for p in v] for k, v in drawn.items()}
        points = np.concatenate([part.vertices for meshes in drawn.values() for part in meshes])
    low, high = points.min(0), points.max(0)
    room = np.array([x[1] - x[0], y[1] - y[0], z[1] - z[0]])
    scale = float((room / (high - low)).min())
    at = np.array([(x[0] + x[1]) / 2, (y[0] + y[1]) / 2, z[0]])
    middle = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    return {
        k: [Mesh((p.vertices - middle) * scale + at, p.faces) for p in v] for k, v in drawn.items()
    }


def show_row(
    names: Sequence[str], x: Interval, y: Interval, z: Interval, start: int = 0, most: int = 5
) -> Stuff:
    """Several treasures beside one another, of unlike height."""
    count = min(most, max(1, round((x[1] - x[0]) / max(1.1 * (z[1] - z[0]), 0.26))))
    step = (x[1] - x[0]) / count
    found: Stuff = {}
    for i in range(count):
        a = x[0] + i * step
        tall = (z[1] - z[0]) * (0.62 + 0.36 * wobble(start + i + 0.5))
        here = show(
            names[(start + i) % len(names)],
            (a + 0.06 * step, a + 0.94 * step),
            y,
            (z[0], z[0] + tall),
            0.5 * wobble(start + i) - 0.25,
        )
        found = merge_by_material(found, here)
    return found
