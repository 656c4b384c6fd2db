"""Small things of kitchens and tables: plates, mugs, glasses, bottles, jars, pans, boards."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.materials import (
    ACCENT,
    BLACK,
    BOTTLE_GREEN,
    CERAMIC,
    CHROME,
    CLAY,
    CLEAR,
    CREAM,
    GLASS,
    LINEN,
    MUSTARD,
    NAVY,
    OAK,
    OAK_DARK,
    PINE,
    SAGE,
    SAGE_FABRIC,
    SLATE,
    STEEL,
    TERRACOTTA,
    WALNUT,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff, wobble
from scenewright.catalog.assets.symbols import plain, round_plain
from scenewright.core.catalog import Material, Mesher, Symbol
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh
from scenewright.geometry.solids import block, disc, lathe, make_bevelled_box, rod, slab, tube

Coloured = Callable[[Size, Material], Parts]


def in_colours(
    category: str, drawn: Coloured, colours: tuple[Material, ...], symbol: Symbol = plain
) -> tuple[Drawing, ...]:
    """A drawing of one kind in each of some materials; all but the first have their number."""

    def one(material: Material) -> Mesher:
        return lambda size: drawn(size, material)

    return tuple(
        Drawing(category, one(colour), symbol, f"{category}_{k}" if k else "")
        for k, colour in enumerate(colours)
    )


def vessel_wall(
    size: Size, shape: list[tuple[float, float]], thick: float, sides: int = 14
) -> Mesh:
    """A hollow vessel: a profile of shares of half the width and of the height, turned, with a
    wall ``thick`` metres thick and a floor as thick again."""
    radius, h = min(size.width, size.depth) / 2, size.height
    outer = [(r * radius, z * h) for r, z in shape]
    inner = [(max(r - thick, 0.001), max(z, 2 * thick)) for r, z in reversed(outer)]
    return lathe([*outer, *inner], sides=sides)


def _plate(size: Size, glaze: Material) -> Parts:
    return parts(size, {glaze: [vessel_wall(size, [(0.6, 0), (0.75, 0.25), (1, 1)], 0.006, 20)]})


def _mug(size: Size, glaze: Material) -> Parts:
    """A mug with its handle to the right."""
    r, h = size.depth / 2, size.height
    cup = vessel_wall(Size(size.depth, size.depth, h), [(0.88, 0), (1, 0.12), (1, 1)], 0.005)
    bow = [(0.95 * r, 0, 0.8 * h), (1.5 * r, 0, 0.72 * h), (1.5 * r, 0, 0.35 * h)]
    handle = tube([*bow, (0.95 * r, 0, 0.22 * h)], 0.006, 6)
    return parts(size, {glaze: [cup, handle]})


def _glass(size: Size) -> Parts:
    return parts(size, {CLEAR: [vessel_wall(size, [(0.78, 0), (1, 1)], 0.003, 12)]})


def _bottle(size: Size, body: Material) -> Parts:
    r, h = min(size.width, size.depth) / 2, size.height
    shape = [(0.92, 0), (1, 0.03), (1, 0.58), (0.36, 0.76), (0.34, 0.93)]
    label = disc(1.004 * r, (0.18 * h, 0.46 * h), sides=14)
    cap = disc(0.38 * r, (0.93 * h, h), sides=10)
    bottle = lathe([(s * r, z * h) for s, z in shape], sides=14)
    return parts(size, {body: [bottle], LINEN: [label], BLACK: [cap]})


def _jar(size: Size, filling: Material) -> Parts:
    r, h = min(size.width, size.depth) / 2, size.height
    body = lathe([(0.9 * r, 0), (r, 0.05 * h), (r, 0.72 * h), (0.8 * r, 0.84 * h)], sides=14)
    lid = disc(0.88 * r, (0.84 * h, h), sides=14)
    return parts(size, {filling: [body], OAK: [lid]})


def _jug(size: Size) -> Parts:
    r, h = size.depth / 2, size.height
    body = vessel_wall(
        Size(size.depth, size.depth, h), [(0.72, 0), (1, 0.3), (0.7, 0.75), (0.85, 1)], 0.005
    )
    bow = [(0.75 * r, 0, 0.86 * h), (1.55 * r, 0, 0.8 * h), (1.45 * r, 0, 0.4 * h)]
    return parts(size, {CERAMIC: [body, tube([*bow, (0.9 * r, 0, 0.28 * h)], 0.007, 6)]})


def _kettle(size: Size) -> Parts:
    r, h = size.depth / 2, size.height
    body = lathe([(r, 0.06 * h), (0.95 * r, 0.4 * h), (0.62 * r, 0.86 * h), (0.2 * r, 0.92 * h)])
    bow = [(0.6 * r, 0, 0.86 * h), (1.5 * r, 0, 0.86 * h), (1.5 * r, 0, 0.3 * h)]
    spout = rod((-0.7 * r, 0, 0.5 * h), (-1.25 * r, 0, 0.8 * h), 0.018, 0.01)
    foot, knob = disc(0.95 * r, (0, 0.06 * h)), disc(0.14 * r, (0.92 * h, h), sides=8)
    handle = tube([*bow, (0.95 * r, 0, 0.22 * h)], 0.01, 6)
    return parts(size, {STEEL: [body, spout], BLACK: [foot, knob, handle]})


def _pan(size: Size, body: Material) -> Parts:
    """A pot with a lid and two ears."""
    r, h = size.depth / 2, size.height
    pot = disc(r, (0, 0.72 * h), sides=20)
    lid = lathe([(1.03 * r, 0.72 * h), (1.03 * r, 0.78 * h), (0.2 * r, 0.88 * h)], sides=20)
    knob = disc(0.13 * r, (0.86 * h, h), sides=8)
    ears = [
        block((s * 1.12 * r - 0.14 * r, s * 1.12 * r + 0.14 * r), (-0.25 * r, 0.25 * r), z)
        for s in (-1, 1)
        for z in ((0.55 * h, 0.63 * h),)
    ]
    return parts(size, {body: [pot, lid], BLACK: [knob, *ears]})


def _board(size: Size, wood: Material) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    return parts(size, {wood: [slab((-w, w), (-d, d), (0, h), 0.03)]})


def _utensils(size: Size) -> Parts:
    """A pot of spoons and whisks."""
    r, h = 0.36 * size.width, size.height
    pot = vessel_wall(Size(2 * r, 2 * r, 0.5 * h), [(0.9, 0), (1, 1)], 0.005)
    found: Stuff = {CERAMIC: [pot]}
    for k in range(5):
        turn = 2 * pi * k / 5 + 0.4
        end = 0.9 + 0.1 * wobble(k)
        handle = rod((0, 0, 0.04 * h), (0.34 * size.width, 0, 0.84 * end * h), 0.005)
        blade = block(
            (0.34 * size.width - 0.016, 0.34 * size.width + 0.016),
            (-0.006, 0.006),
            (0.8 * end * h, end * h),
        )
        wood = (PINE, OAK_DARK, STEEL)[k % 3]
        found.setdefault(wood, []).extend(rotate_mesh(m, "z", turn) for m in (handle, blade))
    return parts(size, found)


def _cutlery(size: Size) -> Parts:
    """A knife or a fork: a handle, a neck and a blade along y."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    handle = make_bevelled_box((-0.6 * w, 0.6 * w), (-d, 0.1 * d), (0, h), 0.3 * h)
    return parts(size, {CHROME: [handle, block((-w, w), (0.1 * d, d), (0.1 * h, 0.6 * h))]})


def _napkin(size: Size, cloth: Material) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    layers = [
        slab(
            (-w, w * (1 - 0.04 * k)), (-d, d * (1 - 0.02 * k)), (k * h / 2, (k + 1) * h / 2), 0.004
        )
        for k in (0, 1)
    ]
    return parts(size, {cloth: layers})


def _tray(size: Size, wood: Material) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    rim = 0.012
    rails = [
        block((-w, w), (s * d - rim * (s > 0), s * d + rim * (s < 0)), (0, h)) for s in (-1, 1)
    ]
    rails += [
        block((s * w - rim * (s > 0), s * w + rim * (s < 0)), (-d + rim, d - rim), (0, h))
        for s in (-1, 1)
    ]
    return parts(
        size, {wood: [block((-w + rim, w - rim), (-d + rim, d - rim), (0, 0.4 * h)), *rails]}
    )


def _toaster(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    body = make_bevelled_box((-w, 0.94 * w), (-d, d), (0.04 * h, 0.97 * h), 0.025)
    slots = [
        block((-0.7 * w, 0.6 * w), (y - 0.012, y + 0.012), (0.95 * h, h))
        for y in (-0.35 * d, 0.35 * d)
    ]
    lever = block((0.94 * w, w), (-0.15 * d, 0.15 * d), (0.6 * h, 0.7 * h))
    feet = block((-0.9 * w, 0.85 * w), (-0.85 * d, 0.85 * d), (0, 0.05 * h))
    return parts(size, {STEEL: [body], BLACK: [*slots, lever, feet]})


def _sponge(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    soft = make_bevelled_box((-w, w), (-d, d), (0, 0.75 * h), 0.004)
    return parts(size, {MUSTARD: [soft], SAGE_FABRIC: [block((-w, w), (-d, d), (0.75 * h, h))]})


ASSETS = (
    *in_colours("plate", _plate, (CERAMIC, ACCENT, CREAM), round_plain),
    *in_colours("mug", _mug, (CERAMIC, TERRACOTTA, NAVY, SAGE), round_plain),
    Drawing("drinking_glass", _glass, round_plain),
    *in_colours("bottle", _bottle, (BOTTLE_GREEN, GLASS, OAK_DARK), round_plain),
    *in_colours("jar", _jar, (LINEN, CLAY, MUSTARD, WALNUT), round_plain),
    Drawing("jug", _jug, round_plain),
    Drawing("kettle", _kettle, round_plain),
    *in_colours("cooking_pot", _pan, (STEEL, TERRACOTTA, SLATE), round_plain),
    *in_colours("chopping_board", _board, (OAK, WALNUT)),
    Drawing("utensil_pot", _utensils, round_plain),
    Drawing("cutlery", _cutlery),
    *in_colours("napkin", _napkin, (LINEN, SAGE_FABRIC, WHITE)),
    *in_colours("tray", _tray, (OAK, BLACK, WHITE)),
    Drawing("toaster", _toaster),
    Drawing("sponge", _sponge),
)
