"""Machines and screens: washing machine, dryer, television, monitor, laptop, speaker."""

from __future__ import annotations

from math import pi

from scenewright.catalog.assets.bodies import front_joint
from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.furniture.cooking import BUILT_IN, UNDER_WORKTOP
from scenewright.catalog.assets.furniture.kitchen import TOP
from scenewright.catalog.assets.materials import (
    BLACK,
    CERAMIC_GLASS,
    CHROME,
    GREY,
    PLASTIC,
    RUBBER,
    SCREEN,
    STEEL,
    STONE,
    WALNUT,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.symbols import Lines, box, oval, path, plain, rectangle
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import block, disc, make_bevelled_box, pipe, rod, slab


def _facing(mesh: Mesh, x: float, y: float, z: float) -> Mesh:
    """A mesh whose axis points up, turned to look along +y, at a spot."""
    return translate_mesh(rotate_mesh(mesh, "x", -pi / 2), x, y, z)


def _machine(size: Size, glass: Material, rim: Material) -> Parts:
    top = TOP if BUILT_IN <= size.height <= UNDER_WORKTOP else 0.0
    w, d, h = size.width / 2, size.depth / 2, size.height - top
    face, panel = d - 0.045, h - 0.12
    radius = min(0.19, 0.68 * w, 0.3 * h)
    middle = 0.06 + (panel - 0.06) * 0.52
    found: Stuff = {
        STONE: [block((-w, w), (-d, d), (h, h + top))] if top else [],
        PLASTIC: [
            block((-w, w), (-d, face), (0.02, h)),
            block((-w + 0.004, w - 0.004), (face, face + 0.006), (panel, h - 0.004)),
        ],
        RUBBER: [
            block((-w + 0.02, w - 0.02), (-d + 0.02, face - 0.02), (0, 0.03)),
            block((-0.06, 0.1), (face + 0.005, face + 0.009), (panel + 0.035, panel + 0.085)),
        ],
        GREY: [
            block((-w + 0.03, -w + 0.19), (face + 0.005, face + 0.01), (panel + 0.02, panel + 0.1)),
            block((w - 0.14, w - 0.04), (face, face + 0.004), (0.04, 0.12)),
        ],
        CHROME: [
            rod(
                (w - 0.12, face + 0.004, panel + 0.06), (w - 0.12, d, panel + 0.06), 0.03, 0.026, 14
            )
        ],
    }
    ring = pipe(radius, 0.76 * radius, (0, 0.04), sides=24)
    across, up = (-radius, radius), (middle - radius, middle + radius)
    door = front_joint("door", across, up, (face, face + 0.04))
    found.setdefault(rim, []).append(_facing(ring, 0, face, middle)._replace(joint=door))
    pane = disc(0.78 * radius, (0, 0.02), sides=20)
    found.setdefault(glass, []).append(_facing(pane, 0, face, middle))
    return parts(size, found)


def _washing_machine(size: Size) -> Parts:
    return _machine(size, SCREEN, CHROME)


def _dryer(size: Size) -> Parts:
    return _machine(size, GREY, RUBBER)


def _tv(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    thin = min(0.045, 0.4 * size.depth)
    low, y = min(0.07, 0.12 * h), -thin / 2
    foot = [
        slab((s * 0.55 * w - 0.02, s * 0.55 * w + 0.02), (-d, d), (0, 0.012), 0.01) for s in (-1, 1)
    ]
    stems = [
        block((s * 0.55 * w - 0.012, s * 0.55 * w + 0.012), (-0.01, 0.01), (0.01, low + 0.02))
        for s in (-1, 1)
    ]
    return parts(
        size,
        {
            BLACK: [make_bevelled_box((-w, w), (y, y + thin), (low, h), 0.006), *foot, *stems],
            SCREEN: [
                block(
                    (-w + 0.012, w - 0.012),
                    (y + thin - 0.004, y + thin + 0.002),
                    (low + 0.018, h - 0.012),
                )
            ],
        },
    )


def _monitor(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    low = 0.3 * h
    return parts(
        size,
        {
            STEEL: [
                slab((-0.4 * w, 0.4 * w), (-d, d), (0, 0.012), 0.03),
                block((-0.025, 0.025), (-0.8 * d, -0.8 * d + 0.02), (0.01, 0.6 * h)),
                block((-0.025, 0.025), (-0.8 * d, 0.0), (0.56 * h, 0.6 * h)),
            ],
            BLACK: [make_bevelled_box((-w, w), (-0.005, 0.025), (low, h), 0.005)],
            SCREEN: [block((-w + 0.01, w - 0.01), (0.02, 0.027), (low + 0.014, h - 0.01))],
        },
    )


def _laptop(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    deep = 0.8 * size.depth
    lid = slab((-w, w), (0, h), (0, 0.008), 0.012)
    glass = block((-w + 0.01, w - 0.01), (0.012, h - 0.012), (-0.0015, 0.001))
    lean, hinge = pi / 2 + 0.22, -d + 0.2 * size.depth
    raised = [translate_mesh(rotate_mesh(m, "x", lean), 0, hinge, 0.012) for m in (lid, glass)]
    keys = block(
        (-w + 0.025, w - 0.025), (hinge + 0.1 * deep, hinge + 0.55 * deep), (0.012, 0.0145)
    )
    pad = block((-0.05, 0.05), (hinge + 0.62 * deep, hinge + 0.92 * deep), (0.012, 0.0135))
    return parts(
        size,
        {
            STEEL: [slab((-w, w), (hinge, d), (0, 0.013), 0.012), raised[0]],
            SCREEN: [raised[1]],
            RUBBER: [keys],
            GREY: [pad],
        },
    )


def _speaker(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    front = d - 0.02
    big, small = min(0.78 * w, 0.2 * h), min(0.45 * w, 0.11 * h)
    cones = [
        _facing(pipe(r, 0.8 * r, (0, 0.008), sides=16), 0, front + 0.01, z)
        for r, z in ((big, 0.4 * h if h < 0.6 else 0.55 * h), (small, 0.8 * h))
    ]
    domes = [
        _facing(disc(0.82 * r, (0, 0.004), sides=16), 0, front + 0.01, z)
        for r, z in ((big, 0.4 * h if h < 0.6 else 0.55 * h), (small, 0.8 * h))
    ]
    return parts(
        size,
        {
            WALNUT: [make_bevelled_box((-w, w), (-d, front), (0, h), 0.006)],
            BLACK: [block((-w + 0.01, w - 0.01), (front, front + 0.012), (0.01, h - 0.01))],
            GREY: cones,
            CERAMIC_GLASS: domes,
        },
    )


def _washer_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    radius = 0.6 * min(w, d)
    return rectangle(size), path((-w, d - 0.06), (w, d - 0.06)), oval(0, -0.03, radius)


def _dryer_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    radius = 0.6 * min(w, d)
    return *_washer_symbol(size), oval(0, -0.03, 0.3 * radius)


def _tv_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    thin = min(0.045, 0.4 * size.depth)
    return box(-w, w, -thin / 2, thin / 2), box(-0.4 * w, 0.4 * w, -d, -thin / 2)


def _laptop_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    hinge = -d + 0.2 * size.depth
    return (
        box(-w, w, hinge, d),
        box(-w, w, -d, hinge),
        box(-0.8 * w, 0.8 * w, hinge + 0.02, 0.4 * d),
    )


def _speaker_symbol(size: Size) -> Lines:
    return (*plain(size), oval(0, 0, 0.5 * min(size.width, size.depth) * 0.6))


ASSETS = (
    Drawing("washing_machine", _washing_machine, _washer_symbol),
    Drawing("dryer", _dryer, _dryer_symbol),
    Drawing("tv", _tv, _tv_symbol),
    Drawing("monitor", _monitor, _tv_symbol),
    Drawing("laptop", _laptop, _laptop_symbol),
    Drawing("speaker", _speaker, _speaker_symbol),
)
