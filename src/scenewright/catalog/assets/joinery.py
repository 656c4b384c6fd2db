"""What cabinets, tables and chairs are joined of: boards, fronts, handles, legs, bent panels."""

from __future__ import annotations

from itertools import pairwise
from math import pi

import numpy as np

from scenewright.catalog.assets.bodies import Opens, front_joint
from scenewright.geometry.mesh import Mesh, extrude
from scenewright.geometry.solids import Interval, block, leg, post, rod

GAP = 0.004


def spread(low: float, high: float, count: int) -> list[Interval]:
    """``count`` equal intervals that fill ``(low, high)``."""
    ends = np.linspace(low, high, count + 1)
    return [(float(a), float(b)) for a, b in pairwise(ends)]


def fronts(
    x: Interval, z: Interval, columns: int, rows: int, y: Interval, opens: Opens = "drawer"
) -> list[Mesh]:
    """A grid of fronts with gaps between, looking to +y, each a body that ``opens``: doors are
    hung in pairs, the first of each on its left."""
    return [
        front((a + GAP, b - GAP), (c + GAP, e - GAP), y, opens, right=bool(i % 2))
        for i, (a, b) in enumerate(spread(*x, columns))
        for c, e in spread(*z, rows)
    ]


def front(x: Interval, z: Interval, y: Interval, opens: Opens, right: bool = False) -> Mesh:
    """A plain front, looking to +y, that ``opens``; a door hung on the ``right`` or the left."""
    return block(x, y, z)._replace(joint=front_joint(opens, x, z, y, right))


def drawer_pulls(
    x: Interval,
    z: Interval,
    columns: int,
    rows: int,
    y: float,
    reach: float = 0.02,
    wide: float = 0.4,
) -> list[Mesh]:
    """A level bar on each front of a grid, near its upper edge, standing out to ``y + reach``."""
    found = []
    for a, b in spread(*x, columns):
        for c, e in spread(*z, rows):
            half = min(0.5 * wide * (b - a), 0.12)
            level = e - min(0.05, 0.35 * (e - c))
            middle = (a + b) / 2
            found.append(
                block(
                    (middle - half, middle + half), (y, y + reach), (level - 0.006, level + 0.006)
                )
            )
    return found


def door_pulls(
    x: Interval,
    z: Interval,
    columns: int,
    y: float,
    reach: float = 0.02,
    at: float = 0.5,
    tall: float = 0.2,
) -> list[Mesh]:
    """An upright bar on each door of a row, at the edge where pairs meet."""
    found = []
    middle = z[0] + at * (z[1] - z[0])
    half = min(tall, 0.6 * (z[1] - z[0])) / 2
    for i, (a, b) in enumerate(spread(*x, columns)):
        edge = b - min(0.045, (b - a) / 4) if i % 2 == 0 else a + min(0.045, (b - a) / 4)
        found.append(
            block((edge - 0.007, edge + 0.007), (y, y + reach), (middle - half, middle + half))
        )
    return found


def knobs(
    x: Interval,
    z: Interval,
    columns: int,
    rows: int,
    y: float,
    reach: float = 0.025,
    pair: float = 0.0,
) -> list[Mesh]:
    """Round knobs on each front of a grid; two of them, ``pair`` of the width apart, if wide."""
    found = []
    for a, b in spread(*x, columns):
        for c, e in spread(*z, rows):
            middle, level = (a + b) / 2, (c + e) / 2
            offset = pair * (b - a) / 2
            for px in (middle - offset, middle + offset) if offset > 0.08 else (middle,):
                found.append(rod((px, y - 0.002, level), (px, y + reach, level), 0.013, 0.016))
    return found


def corpus(
    x: Interval,
    y: Interval,
    z: Interval,
    thick: float = 0.02,
    shelves: int = 0,
    uprights: int = 0,
    back: bool = True,
) -> list[Mesh]:
    """An open case: two sides, floor, top, back, level shelves and upright divisions."""
    inner = (x[0] + thick, x[1] - thick)
    found = [
        block((x[0], inner[0]), y, z),
        block((inner[1], x[1]), y, z),
        block(inner, y, (z[0], z[0] + thick)),
        block(inner, y, (z[1] - thick, z[1])),
    ]
    if back:
        found.append(block(inner, (y[0], y[0] + 0.008), (z[0] + thick, z[1] - thick)))
    levels = np.linspace(z[0] + thick / 2, z[1] - thick / 2, shelves + 2)[1:-1]
    deep = (y[0] + 0.008, y[1] - 0.005)
    found += [block(inner, deep, (k - thick / 2, k + thick / 2)) for k in levels]
    ends = [z[0] + thick / 2, *levels, z[1] - thick / 2]
    for k in np.linspace(x[0] + thick / 2, x[1] - thick / 2, uprights + 2)[1:-1]:
        for low, high in pairwise(ends):
            level = (low + thick / 2, high - thick / 2)
            found.append(block((k - thick / 2, k + thick / 2), deep, level))
    return found


def four_legs(
    w: float,
    d: float,
    z: Interval,
    top: float,
    foot: float,
    inset: float = 0.0,
    lean: float = 0.0,
    square: bool = False,
    aside: float | None = None,
) -> list[Mesh]:
    """Legs near the corners of ``[-w, w] x [-d, d]``; leaning legs touch the corners below. They
    lean ``aside`` by another measure than to the front and the back, where it is given."""
    slant = lean if aside is None else aside
    found = []
    for sx in (-1, 1):
        for sy in (-1, 1):
            edge = inset + max(top, foot)
            x, y = sx * (w - edge - slant), sy * (d - edge - lean)
            shape = post if square else leg
            found.append(shape(x, y, z, top, foot, lean=(sx * slant, sy * lean)))
    return found


def bent(
    half: float, y: float, sag: float, thick: float, z: Interval, steps: int = 6, lean: float = 0.0
) -> Mesh:
    """An upright board bent in plan: its middle lies ``sag`` behind its ends at ``y``; the top
    edge stands ``lean`` further back than the lower one."""
    share = np.linspace(-1, 1, steps + 1)
    inner = np.column_stack([share * half, y - sag * np.cos(share * pi / 2)])
    outer = inner - (0.0, thick)
    mesh = extrude(np.concatenate([outer, inner[::-1]]), *z)
    rise = (mesh.vertices[:, 2] - z[0]) / (z[1] - z[0])
    return Mesh(mesh.vertices - np.outer(rise * lean, (0.0, 1.0, 0.0)), mesh.faces)
