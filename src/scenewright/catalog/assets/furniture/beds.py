"""Beds and nightstands. The head is at the back, the width across."""

from __future__ import annotations

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.joinery import drawer_pulls, four_legs, fronts, spread
from scenewright.catalog.assets.materials import (
    DUVET,
    FABRIC,
    LINEN,
    MATTRESS,
    MUSTARD,
    NAVY,
    OAK,
    PINE,
    SAGE_FABRIC,
    TERRACOTTA,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts, pick
from scenewright.catalog.assets.symbols import Line, Lines, box, close_line, path, rectangle
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import Interval, block, cushion, pad, post, rod, slab

HEAD = 0.08
FILLED, PLUMP = (0.0, 0.0, 0.02), (0.0, 0.0, 0.055)
"""How far duvets and pillows stand out in the middle, metres."""


def _pillows(x: Interval, back: float, z: float, count: int) -> list[Mesh]:
    found = []
    for a, b in spread(*x, count):
        half = min(0.35, (b - a) / 2 - 0.03)
        flat = pad((-half, half), (0, 0.42), (0, 0.15), 0.025, PLUMP)
        found.append(
            translate_mesh(rotate_mesh(flat, "x", -0.25), (a + b) / 2, back + 0.03, z + 0.09)
        )
    return found


def make_bedding(
    x: Interval, y: Interval, z: Interval, count: int, accent: Material, drop: float = 0.12
) -> dict[Material, list[Mesh]]:
    """Mattress, pillows, a duvet with its edge folded back, and a throw over the foot end."""
    length = y[1] - y[0]
    fold = y[0] + min(0.62, 0.32 * length)
    over, top = 0.012, z[1]
    wide = (x[0] - over, x[1] + over)
    throw = (y[1] - 0.26 * length, y[1] - 0.08 * length)
    return {
        MATTRESS: [cushion(x, y, z, 0.03, 2)],
        LINEN: [
            *_pillows((x[0] + 0.03, x[1] - 0.03), y[0], top, count),
            cushion(
                (wide[0] - 0.006, wide[1] + 0.006),
                (fold, fold + 0.24),
                (top - drop, top + 0.06),
                0.03,
            ),
        ],
        DUVET: [
            pad(wide, (fold + 0.1, y[1] + over), (top - drop, top + 0.045), 0.04, (0, 0, 0.02))
        ],
        accent: [
            cushion(
                (wide[0] - 0.008, wide[1] + 0.008), throw, (top - drop - 0.05, top + 0.058), 0.025
            )
        ],
    }


def _bed(size: Size, pillows: int, accent: Material, wood: Material, soft: bool) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(0.52, 0.62 * h)
    low, rail = 0.12, 0.3 * top / 0.52
    found = make_bedding(
        (-w + 0.04, w - 0.04), (-d + HEAD + 0.01, d - 0.03), (rail - 0.04, top), pillows, accent
    )
    frame = block((-w, w), (-d + 0.03, d), (low, rail))
    legs = four_legs(w, d, (0, low + 0.02), 0.03, 0.022, 0.04)
    found.setdefault(wood, []).extend([frame, *legs])
    if soft:
        panels = spread(-w, w, max(3, round(size.width / 0.3)))
        head = [cushion(p, (-d + 0.015, -d + HEAD), (low, h), 0.03) for p in panels]
        found.setdefault(FABRIC, []).extend(
            [*head, block((-w, w), (-d, -d + 0.03), (low, h - 0.02))]
        )
    else:
        board = slab((-w, w), (0, h - low), (0, 0.045), 0.06, 3)
        head = [translate_mesh(rotate_mesh(board, "x", 1.5707963267948966), 0, -d + 0.045, low)]
        found[wood].extend(head)
    return parts(size, found)


def _double_bed(size: Size) -> Parts:
    return _bed(size, 2, pick(size, (TERRACOTTA, NAVY, MUSTARD)), OAK, soft=True)


def _single_bed(size: Size) -> Parts:
    return _bed(size, 1, pick(size, (SAGE_FABRIC, MUSTARD, NAVY)), OAK, soft=False)


def _bunk_bed(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    upper = h - 0.42
    wood = [
        post(sx * (w - 0.03), sy * (d - 0.03), (0, h), 0.03) for sx in (-1, 1) for sy in (-1, 1)
    ]
    found: dict[Material, list[Mesh]] = {}
    for base, accent in ((0.18, NAVY), (upper - 0.08, SAGE_FABRIC)):
        bed = make_bedding(
            (-w + 0.04, w - 0.04),
            (-d + 0.06, d - 0.06),
            (base + 0.08, base + 0.24),
            1,
            accent,
            0.08,
        )
        for material, meshes in bed.items():
            found.setdefault(material, []).extend(meshes)
        wood += [
            block(
                (s * (w - 0.012) - 0.012, s * (w - 0.012) + 0.012),
                (-d + 0.06, d - 0.06),
                (base, base + 0.13),
            )
            for s in (-1, 1)
        ]
        wood += [
            block(
                (-w + 0.06, w - 0.06),
                (s * (d - 0.03) - 0.012, s * (d - 0.03) + 0.012),
                (base, base + 0.4),
            )
            for s in (-1, 1)
        ]
    for level in (upper + 0.22, upper + 0.34):
        for side in ((-w, -w + 0.022), (w - 0.022, w)):
            wood.append(block(side, (-d + 0.06, d - 0.06), (level, level + 0.06)))
    wood += _ladder(d, h - 0.04)
    found[PINE] = wood
    return parts(size, found)


def _ladder(d: float, h: float) -> list[Mesh]:
    """A ladder before the foot, where no wall is whichever side of the bed is at one."""
    rails = [block((s * 0.19 - 0.015, s * 0.19 + 0.015), (d - 0.025, d), (0, h)) for s in (-1, 1)]
    levels = [0.25 * k for k in range(1, int(h / 0.25) + 1)]
    return rails + [rod((-0.19, d - 0.013, z), (0.19, d - 0.013, z), 0.012) for z in levels]


def _cot(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    wood = [
        post(sx * (w - 0.025), sy * (d - 0.025), (0, h), 0.025, 0.02)
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    for s in (-1, 1):
        for z in ((h - 0.09, h - 0.045), (0.24, 0.28)):
            wood.append(
                block((s * (w - 0.025) - 0.014, s * (w - 0.025) + 0.014), (-d + 0.05, d - 0.05), z)
            )
        for a, b in spread(-d + 0.06, d - 0.06, round((size.depth - 0.1) / 0.1)):
            y = (a + b) / 2
            x = s * (w - 0.025)
            wood.append(block((x - 0.008, x + 0.008), (y - 0.011, y + 0.011), (0.27, h - 0.08)))
        wood.append(
            block(
                (-w + 0.05, w - 0.05),
                (s * (d - 0.025) - 0.012, s * (d - 0.025) + 0.012),
                (0.24, h - 0.02),
            )
        )
    inner = ((-w + 0.05, w - 0.05), (-d + 0.05, d - 0.05))
    pillow = pad((-w + 0.12, w - 0.12), (-d + 0.08, -d + 0.34), (0.4, 0.48), 0.02, FILLED)
    duvet = cushion((-w + 0.055, w - 0.055), (-d + 0.5, d - 0.055), (0.36, 0.44), 0.03)
    return parts(
        size,
        {
            WHITE: wood,
            MATTRESS: [cushion(*inner, (0.27, 0.41), 0.03)],
            LINEN: [pillow],
            SAGE_FABRIC: [duvet],
        },
    )


def _nightstand(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    low, face = 0.3 * h, d - 0.035
    x, z = (-w + 0.004, w - 0.004), (low, h - 0.02)
    legs = four_legs(w, d, (0, low + 0.01), 0.017, 0.011, 0.02, 0.02)
    return parts(
        size,
        {
            OAK: [
                slab((-w, w), (-d, d - 0.012), (h - 0.02, h), 0.015),
                *legs,
                block(x, (-d + 0.005, face), z),
            ],
            WHITE: fronts(
                (-w + 0.012, w - 0.012), (low + 0.008, h - 0.024), 1, 2, (face, face + 0.016)
            ),
            PINE: drawer_pulls(x, z, 1, 2, face + 0.016, 0.019, 0.3),
        },
    )


def bed_symbol(size: Size, pillows: int) -> Lines:
    """Headboard, pillows, duvet with one corner folded back."""
    w, d = size.width / 2, size.depth / 2
    head, length = min(HEAD, 0.08 * size.depth), size.depth
    fold = -d + 0.31 * length
    corner = min(0.45 * w, 0.2 * length)
    flap = close_line([(w, fold + corner), (w - corner, fold + corner), (w - corner, fold)])
    return (
        rectangle(size),
        path((-w, -d + head), (w, -d + head)),
        *_pillow_marks(w, -d + head, length, pillows),
        path((-w, fold), (w - corner, fold), (w, fold + corner)),
        flap,
    )


def _pillow_marks(w: float, y: float, length: float, count: int) -> list[Line]:
    deep = 0.18 * length
    return [
        box(a + 0.05, b - 0.05, y + 0.05, y + 0.02 + deep, 0.06)
        for a, b in spread(-w + 0.02, w - 0.02, count)
    ]


def _double_symbol(size: Size) -> Lines:
    return bed_symbol(size, 2)


def _single_symbol(size: Size) -> Lines:
    return bed_symbol(size, 1)


def _bunk_symbol(size: Size) -> Lines:
    d = size.depth / 2
    rungs = [path((x, d - 0.12), (x, d)) for x in (-0.17, -0.08, 0.0, 0.08, 0.17)]
    return *bed_symbol(size, 1), path((-0.2, d - 0.12), (0.2, d - 0.12)), *rungs


def _cot_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return (
        rectangle(size),
        rectangle(size, 0.05),
        box(-w + 0.12, w - 0.12, -d + 0.09, -d + 0.33, 0.05),
    )


def _nightstand_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), path((-w, d - 0.03), (w, d - 0.03))


ASSETS = (
    Drawing("double_bed", _double_bed, _double_symbol),
    Drawing("single_bed", _single_bed, _single_symbol),
    Drawing("bunk_bed", _bunk_bed, _bunk_symbol),
    Drawing("cot", _cot, _cot_symbol),
    Drawing("nightstand", _nightstand, _nightstand_symbol),
)
