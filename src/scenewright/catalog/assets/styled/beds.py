"""Beds in the forms of styles: each its own head and frame, bedding as usual."""

from __future__ import annotations

from functools import partial
from math import pi

import numpy as np

from scenewright.catalog.assets.furniture.beds import HEAD, bed_symbol, make_bedding
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import (
    BLACK,
    FABRIC,
    MUSTARD,
    NAVY,
    OAK,
    RATTAN,
    SAGE_FABRIC,
    TERRACOTTA,
    WALNUT,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.styled.forms import Form, add, draw_forms, stand
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, block, cushion, frame, post, rod, sheet, slab

FRAMES: dict[str, tuple[Material, float, Material]] = {
    "nordic": (OAK, 0.2, NAVY),
    "classic": (WALNUT, 0.14, TERRACOTTA),
    "industrial": (BLACK, 0.22, SAGE_FABRIC),
    "japandi": (OAK, 0.06, SAGE_FABRIC),
    "retro": (WALNUT, 0.2, MUSTARD),
    "boho": (OAK, 0.12, TERRACOTTA),
}
"""What a style's bed is made of, how high its frame is above the floor, and the throw."""


def _head(form: Form, w: float, back: float, z: Interval) -> Stuff:
    """The head of a bed, between its back edge and :data:`HEAD` before it."""
    low, high = z
    y = (back + 0.01, back + 0.05)
    match form.name:
        case "nordic":
            bars = [
                rod(
                    ((a + b) / 2, back + 0.03, low),
                    ((a + b) / 2, back + 0.03, high - 0.03),
                    0.011,
                    sides=6,
                )
                for a, b in spread(-w + 0.04, w - 0.04, max(5, round(w / 0.07)))
            ]
            posts = [
                rod((s * (w - 0.025), back + 0.03, 0), (s * (w - 0.025), back + 0.03, high), 0.024)
                for s in (-1, 1)
            ]
            return {
                OAK: [
                    *bars,
                    *posts,
                    rod(
                        (-w + 0.02, back + 0.03, high - 0.03),
                        (w - 0.02, back + 0.03, high - 0.03),
                        0.022,
                    ),
                ]
            }
        case "classic":
            return _make_tufted(w, back, z)
        case "industrial":
            posts = [post(s * (w - 0.02), back + 0.03, (0, high), 0.018) for s in (-1, 1)]
            rails = [
                block((-w + 0.02, w - 0.02), (back + 0.02, back + 0.04), (v - 0.012, v + 0.012))
                for v in np.linspace(low + 0.1, high - 0.014, 4)
            ]
            return {BLACK: [*posts, *rails]}
        case "japandi":
            planks = spread(low, high, 3)
            return {OAK: [block((-w, w), y, (a + 0.002, b - 0.002)) for a, b in planks]}
        case "retro":
            panels = [
                cushion((a + 0.006, b - 0.006), (back + 0.03, back + HEAD), (low + 0.2, high), 0.02)
                for a, b in spread(-w + 0.02, w - 0.02, 2)
            ]
            return {WALNUT: [slab((-w, w), y, (low, high - 0.06), 0.004)], FABRIC: panels}
    arch = _arch(w - 0.03, low, high)
    weave = sheet(_arch(w - 0.07, low + 0.02, high - 0.04), (back + 0.02, back + 0.035))
    return {
        OAK: [sheet(arch, (back + 0.005, back + 0.02)), frame((-w, w), y, (low, low + 0.2), 0.05)],
        RATTAN: [weave],
    }


def _make_tufted(w: float, back: float, z: Interval) -> Stuff:
    low, high = z
    pad = cushion((-w + 0.05, w - 0.05), (back + 0.015, back + HEAD), (low, high - 0.05), 0.035)
    rim = frame((-w, w), (back + 0.005, back + 0.06), (low, high), 0.055, 0.1)
    columns = max(3, round(w / 0.16))
    buttons = [
        _button((a + b) / 2, back + HEAD + 0.004, low + r * (high - low))
        for r in (0.6, 0.8)
        for a, b in spread(-w + 0.08, w - 0.08, columns)
    ]
    return {FABRIC: [pad], WALNUT: [rim], TERRACOTTA: buttons}


def _button(x: float, y: float, z: float) -> Mesh:
    return block((x - 0.012, x + 0.012), (y - 0.02, y), (z - 0.012, z + 0.012))


def _arch(half: float, low: float, high: float) -> list[tuple[float, float]]:
    """A round-headed outline in x and z, counter-clockwise seen from the back."""
    rise = min(half, 0.6 * (high - low))
    turn = np.linspace(0, pi, 15)
    head = [(half * float(np.cos(a)), high - rise + rise * float(np.sin(a))) for a in turn]
    return [(half, low), *head, (-half, low)]


def _bed(form: Form, size: Size, sleepers: int) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    wood, low, throw = FRAMES[form.name]
    top = min(0.5 if form.name != "japandi" else 0.4, 0.62 * h)
    rail = max(0.6 * top, low + 0.05)
    over = 0.0 if form.name == "japandi" else 0.04
    found = make_bedding(
        (-w + 0.05, w - 0.05), (-d + HEAD + 0.01, d - 0.04), (rail - 0.04, top), sleepers, throw
    )
    body = block((-w, w), (-d + 0.03, d), (low, rail - over))
    add(found, {wood: [body]} if form.name != "classic" else {FABRIC: [body]})
    if form.name == "japandi":
        add(found, {OAK: [block((-w + 0.12, w - 0.12), (-d + 0.12, d - 0.12), (0, low + 0.01))]})
    else:
        add(
            found,
            stand(
                form._replace(legs="tapered") if form.legs == "cross" else form,
                w,
                d,
                low + 0.01,
                wood,
            ),
        )
    return parts(size, add(found, _head(form, w, -d, (low, h))))


def _double_bed(form: Form, size: Size) -> Parts:
    return _bed(form, size, 2)


def _single_bed(form: Form, size: Size) -> Parts:
    return _bed(form, size, 1)


ASSETS = (
    *draw_forms("double_bed", _double_bed, partial(bed_symbol, pillows=2)),
    *draw_forms("single_bed", _single_bed, partial(bed_symbol, pillows=1)),
)
