"""Dining chairs and bar stools in the forms of styles."""

from __future__ import annotations

from collections.abc import Callable

from scenewright.catalog.assets.furniture.seating import chair_symbol
from scenewright.catalog.assets.joinery import bent, four_legs, spread
from scenewright.catalog.assets.materials import BLACK, FABRIC, LEATHER, OAK, RATTAN, WALNUT
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.styled.forms import Form, add, draw_forms, stand
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, cushion, frame, rod, slab, tube

Rest = Callable[[float, float, Interval], Stuff]
"""What one leans on: half the width, the back edge, from the seat to the top."""


def _spindles(w: float, back: float, z: Interval) -> Stuff:
    """A bent top rail on round bars."""
    bars = [
        rod((x, back + 0.06, z[0]), (x * 1.02, back + 0.035, z[1] - 0.05), 0.009, sides=6)
        for x in [(a + b) / 2 for a, b in spread(-w + 0.03, w - 0.03, 6)]
    ]
    return {OAK: [*bars, bent(w - 0.01, back + 0.05, 0.03, 0.025, (z[1] - 0.07, z[1]))]}


def _rim(tall: float) -> tuple[float, float]:
    """The breadth and corner radius of the frame of a back that is so tall."""
    wide = min(0.035, 0.2 * tall)
    return wide, min(0.09, 0.4 * tall)


def _make_padded(w: float, back: float, z: Interval) -> Stuff:
    """An upholstered panel in a wooden frame, on two posts."""
    panel = cushion(
        (-w + 0.03, w - 0.03), (back + 0.01, back + 0.07), (z[0] + 0.1, z[1] - 0.03), 0.028
    )
    rim = frame(
        (-w, w), (back + 0.02, back + 0.055), (z[0] + 0.07, z[1]), *_rim(z[1] - z[0] - 0.07)
    )
    posts = [
        rod(
            (s * (w - 0.04), back + 0.05, z[0] - 0.02),
            (s * (w - 0.04), back + 0.04, z[0] + 0.1),
            0.016,
        )
        for s in (-1, 1)
    ]
    return {FABRIC: [panel], WALNUT: [rim, *posts]}


def _make_strapped(w: float, back: float, z: Interval) -> Stuff:
    """Leather slung over a steel hoop."""
    hoop = [
        (-w + 0.02, back + 0.07, z[0] - 0.02),
        (-w + 0.02, back + 0.02, z[1]),
        (w - 0.02, back + 0.02, z[1]),
        (w - 0.02, back + 0.07, z[0] - 0.02),
    ]
    sling = bent(w - 0.02, back + 0.04, 0.02, 0.02, (z[0] + 0.45 * (z[1] - z[0]), z[1] - 0.01))
    return {BLACK: [tube(hoop, 0.012)], LEATHER: [sling]}


def _low(w: float, back: float, z: Interval) -> Stuff:
    """One broad bent board half way up, on two posts."""
    top = z[0] + 0.95 * (z[1] - z[0])
    posts = [
        rod((s * (w - 0.03), back + 0.05, z[0] - 0.02), (s * (w - 0.03), back + 0.04, z[1]), 0.015)
        for s in (-1, 1)
    ]
    return {OAK: [*posts, bent(w - 0.005, back + 0.06, 0.045, 0.02, (top - 0.13, top))]}


def _shell(w: float, back: float, z: Interval) -> Stuff:
    """A moulded shell that rises from the seat."""
    return {WALNUT: [bent(w - 0.005, back + 0.09, 0.075, 0.014, (z[0] + 0.02, z[1]), 8, 0.0)]}


def _make_caned(w: float, back: float, z: Interval) -> Stuff:
    """Cane in a rounded wooden frame."""
    low = z[0] + 0.08
    rim = frame((-w + 0.01, w - 0.01), (back + 0.01, back + 0.04), (low, z[1]), *_rim(z[1] - low))
    net = cushion(
        (-w + 0.04, w - 0.04), (back + 0.018, back + 0.032), (low + 0.02, z[1] - 0.02), 0.006, 1
    )
    posts = [
        rod(
            (s * (w - 0.06), back + 0.03, z[0] - 0.02),
            (s * (w - 0.06), back + 0.025, low + 0.02),
            0.016,
        )
        for s in (-1, 1)
    ]
    return {OAK: [rim, *posts], RATTAN: [net]}


SEATS: dict[str, tuple[Rest, Material, Material]] = {
    "nordic": (_spindles, OAK, OAK),
    "classic": (_make_padded, WALNUT, FABRIC),
    "industrial": (_make_strapped, BLACK, LEATHER),
    "japandi": (_low, OAK, RATTAN),
    "retro": (_shell, WALNUT, FABRIC),
    "boho": (_make_caned, OAK, FABRIC),
}
"""The back of a style's chairs, what the legs are of and what one sits on."""


def _legs(form: Form, w: float, d: float, high: float, wood: Material) -> Stuff:
    """Legs of a chair: steel bent to a frame, turned in front, or round and leaning."""
    if form.legs == "turned":
        return stand(form, w, d, high, wood)
    square = form.legs == "board"
    steel = form.legs == "sled"
    thick, foot = (0.011, 0.011) if steel else (0.019, 0.013)
    lean = {"splayed": 0.06, "tapered": 0.03}.get(form.legs, 0.0)
    return {wood: four_legs(w, d, (0, high), thick, foot, 0.005, lean, square)}


def _seat(material: Material, w: float, d: float, z: float) -> Mesh:
    if material is OAK:
        return slab((-w, w), (-d + 0.03, d), (z - 0.025, z), 0.06, 3)
    return cushion((-w + 0.01, w - 0.01), (-d + 0.04, d), (z - 0.035, z + 0.015), 0.024)


def _chair(form: Form, size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    seat = min(0.45, 0.56 * h)
    rest, wood, pad = SEATS[form.name]
    found = _legs(form, w, d, seat - 0.02, wood)
    rail = cushion(
        (-w + 0.03, w - 0.03), (-d + 0.06, d - 0.03), (seat - 0.06, seat - 0.02), 0.008, 1
    )
    add(found, {wood: [rail], pad: [_seat(pad, w, d, seat)]})
    return parts(size, add(found, rest(w, -d, (seat, h))))


def _bar_stool(form: Form, size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    seat = h - 0.14 if h < 0.85 else h - 0.3
    rest, wood, pad = SEATS[form.name]
    found: Stuff = {wood: four_legs(w, d, (0, seat - 0.02), 0.015, 0.012, 0.0, 0.04)}
    rungs = [
        rod((-w + 0.04, y, 0.22), (w - 0.04, y, 0.22), 0.01, sides=6) for y in (d - 0.05, 0.05 - d)
    ]
    add(found, {wood: rungs, pad: [_seat(pad, w, d, seat)]})
    return parts(size, add(found, rest(w, -d, (seat, h))))


ASSETS = (
    *draw_forms("dining_chair", _chair, chair_symbol),
    *draw_forms("bar_stool", _bar_stool, chair_symbol),
)
