"""Tables and desks in the forms of styles."""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.furniture.corners import cover, mirror_drawing
from scenewright.catalog.assets.furniture.tables import (
    corner_desk_outline,
    corner_desk_symbol,
    drawers_wide,
)
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import BLACK, BRASS, CLEAR, OAK, STONE, WALNUT, WHITE
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.styled.forms import (
    Form,
    add,
    draw_forms,
    draw_fronts,
    draw_handles,
    stand,
)
from scenewright.catalog.assets.symbols import Lines, path, rectangle, round_plain
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, extrude
from scenewright.geometry.solids import block, disc, lathe, leg, rod, slab

TOPS: dict[str, tuple[Material, float]] = {
    "nordic": (OAK, 0.026),
    "classic": (WALNUT, 0.036),
    "industrial": (OAK, 0.05),
    "japandi": (OAK, 0.04),
    "retro": (WALNUT, 0.024),
    "boho": (OAK, 0.045),
}
"""What a style's table tops are of, and how thick, metres."""


def _top(form: Form, w: float, d: float, h: float) -> Stuff:
    """A table top; of planks where doors are planked."""
    wood, thick = TOPS[form.name]
    if form.front == "planked" and d > 0.3:
        boards = spread(-d, d, max(2, round(d / 0.09)))
        return {wood: [block((-w, w), (a + 0.001, b - 0.001), (h - thick, h)) for a, b in boards]}
    return {wood: [slab((-w, w), (-d, d), (h - thick, h), min(form.edge, 0.9 * d), 3)]}


def _dining_table(form: Form, size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    wood, thick = TOPS[form.name]
    found = stand(form, w, d, h - thick, wood, around=True)
    if form.legs in ("tapered", "turned", "splayed"):
        rails = [
            block((-w + 0.1, w - 0.1), (y - 0.01, y + 0.01), (h - 0.1, h - thick))
            for y in (d - 0.09, 0.09 - d)
        ]
        add(found, {wood: rails})
    return parts(size, add(found, _top(form, w, d, h)))


def _round_top(w: float, d: float, low: float, high: float, wood: Material) -> Stuff:
    plate = lathe(
        [(0.97, low), (1, low + 0.3 * (high - low)), (1, high - 0.002), (0.99, high)], sides=32
    )
    return {wood: [Mesh(plate.vertices * (w, d, 1), plate.faces)]}


def _column(form: Form, r: float, h: float, wood: Material) -> Stuff:
    """What a round table of radius ``r`` stands on."""
    match form.name:
        case "classic":
            rows = [
                (0.55, 0),
                (0.5, 0.05),
                (0.14, 0.1),
                (0.2, 0.3),
                (0.3, 0.5),
                (0.12, 0.7),
                (0.2, 0.9),
                (0.4, 1),
            ]
            return {wood: [lathe([(min(r, 0.55) * a, h * z) for a, z in rows], sides=16)]}
        case "industrial":
            return {
                BLACK: [
                    disc(min(0.6 * r, 0.3), (0, 0.02), sides=20),
                    disc(0.04, (0.01, h), sides=10),
                    disc(0.3 * r, (h - 0.012, h), sides=14),
                ]
            }
        case "japandi":
            fins = [disc(0.5 * r, (0, h), sides=20)]
            return {wood: fins}
        case "retro":
            rows = [
                (0.55, 0),
                (0.5, 0.02),
                (0.18, 0.08),
                (0.08, 0.4),
                (0.1, 0.75),
                (0.3, 0.97),
                (0.4, 1),
            ]
            return {WHITE: [lathe([(min(r, 0.6) * a, h * z) for a, z in rows], sides=20)]}
        case "boho":
            ways = ((1, 0), (-0.5, 0.87), (-0.5, -0.87))
            return {
                wood: [
                    rod((0.55 * r * x, 0.55 * r * y, 0.004), (-0.5 * r * x, -0.5 * r * y, h), 0.024)
                    for x, y in ways
                ]
            }
    feet = [
        leg(0.5 * r * x, 0.5 * r * y, (0, h), 0.024, 0.015, lean=(0.2 * r * x, 0.2 * r * y))
        for x in (-1, 1)
        for y in (-1, 1)
    ]
    return {wood: feet}


def _round_table(form: Form, size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    wood, thick = TOPS[form.name]
    found = _column(form, min(w, d), h - thick, wood)
    return parts(size, add(found, _round_top(w, d, h - thick, h, wood)))


def _coffee_table(form: Form, size: Size) -> Parts:
    """A low table: with a shelf, of glass, with a drawer, as a slab or a tray."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    wood, thick = TOPS[form.name]
    if form.name == "retro":
        found = stand(form, 0.85 * w, 0.85 * d, h - thick, wood)
        shelf = slab(
            (-0.7 * w, 0.7 * w), (-0.7 * d, 0.7 * d), (0.45 * h, 0.45 * h + 0.012), 0.5 * d, 4
        )
        top = slab((-w, w), (-d, d), (h - thick, h), 0.96 * d, 6)
        return parts(size, add(found, {wood: [top], OAK: [shelf]}))
    if form.name == "japandi":
        found = {
            wood: [
                block((-w, w), (-d, d), (h - 0.05, h)),
                *(
                    block((s * (w - 0.05) - 0.05, s * (w - 0.05) + 0.05), (-d, d), (0, h - 0.05))
                    for s in (-1, 1)
                ),
            ]
        }
        return parts(size, found)
    found = stand(form, w, d, h - thick, wood)
    low = 0.12
    if form.name == "classic":
        add(
            found,
            {
                STONE: [
                    slab((-w + 0.05, w - 0.05), (-d + 0.05, d - 0.05), (h - 0.004, h + 0.002), 0.01)
                ]
            },
        )
    if form.name in ("industrial", "boho"):
        add(found, {wood: [block((-w + 0.06, w - 0.06), (-d + 0.05, d - 0.05), (low, low + 0.02))]})
    return parts(size, add(found, _top(form, w, d, h)))


def _side_table(form: Form, size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    wood = BRASS if form.name == "classic" else TOPS[form.name][0]
    found = _column(form, 0.95 * min(w, d), h - 0.02, wood)
    top = CLEAR if form.name == "classic" else wood
    return parts(size, add(found, _round_top(w, d, h - 0.022, h, top)))


def _desk(form: Form, size: Size) -> Parts:
    """A table with drawers under its right end."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    wood, thick = TOPS[form.name]
    small = size.width < 1.1
    x = (w - drawers_wide(size) - 0.06, w - 0.06)
    rows, z, face = (1 if small else 3), (h - 0.085 if small else 0.16, h - thick), d - 0.06
    found = stand(form, w, d, h - thick, wood)
    add(found, {wood: [block(x, (-d + 0.06, face), z)]})
    add(found, draw_fronts(form, x, z, 1, rows, (face, face + 0.018), form.panel))
    add(found, draw_handles(form, x, z, 1, rows, face + 0.018, 0.02, False))
    return parts(size, add(found, _top(form, w, d, h)))


def _corner_desk(form: Form, size: Size) -> Parts:
    """A top round the corner, on legs at its ends and a chest without doors in its wing."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    wood, thick = TOPS[form.name]
    outline = corner_desk_outline(size)
    (_, front), (edge, _) = outline[2], outline[4]
    x, y = (-w + 0.03, edge - 0.03), (d - 0.48, d - 0.03)
    ends = ((w - 0.05, -d + 0.05), (w - 0.05, front - 0.05), (-w + 0.05, -d + 0.05))
    legs = [leg(a, b, (0, h - thick), 0.03, 0.022) for a, b in ends]
    rail = block((-w + 0.06, w - 0.06), (-d + 0.04, -d + 0.06), (h - 0.3, h - thick))
    chest = block(x, y, (form.lift, h - thick))
    under = ((a, b) for a in (x[0] + 0.04, x[1] - 0.04) for b in (y[0] + 0.04, y[1] - 0.04))
    feet = [leg(a, b, (0, form.lift), 0.024, 0.018) for a, b in under]
    top = extrude(np.array(outline), h - thick, h)
    return parts(size, add({wood: [top, rail, *legs, *feet]}, {form.panel: [chest]}))


def _draw_table(size: Size) -> Lines:
    return (rectangle(size, 0, 0.04),)


def _draw_desk(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    wide = drawers_wide(size)
    return rectangle(size), path((w - wide, -d), (w - wide, d))


CORNERS = draw_forms("corner_desk", _corner_desk, corner_desk_symbol, cover(corner_desk_outline))
ASSETS = (
    *draw_forms("dining_table", _dining_table, _draw_table),
    *draw_forms("round_table", _round_table, round_plain),
    *draw_forms("coffee_table", _coffee_table, _draw_table),
    *draw_forms("side_table", _side_table, round_plain),
    *draw_forms("desk", _desk, _draw_desk),
    *CORNERS,
    *map(mirror_drawing, CORNERS),
)
