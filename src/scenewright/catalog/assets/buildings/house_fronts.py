"""Facades of a house: its front with a door, a gate, a portal or a shop, and its other sides.

The entrance takes one bay of the front, its windows the others, so that neither covers the other
nor a window above.
"""

from __future__ import annotations

import shapely

from scenewright.catalog.assets.buildings.house_looks import HouseForm, HouseLook
from scenewright.catalog.assets.buildings.house_walls import (
    EDGE,
    FLOOR,
    OUT,
    SHORT,
    WINDOWS,
    Side,
    WallOpenings,
    count_storeys,
    fill_bays,
    frame_side,
    list_sides,
    on_side,
)
from scenewright.core.footprint import Footprint
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, block

DOOR = (1.1, 2.25)
"""Width and height of a door, in metres."""
GATE, PORTAL = (3.0, 3.0), (1.9, 2.7)
"""The same of the gate of a barn and of the portal of a hall, at most."""
SURROUND, APART = 0.14, 0.06
"""Metres of the frame of a door, and between it and what is beside it."""
BYRE = 2.4
"""Metres of height of the gate of a byre, below the windows over it."""
SHOP_TOP, SILL, SIGN, PANEL = 2.25, 0.45, (0.3, 0.5), 2.2
"""Of a shop in metres: the top of its windows, their sill, the height of its sign, and the widest
pane."""
BALCONY, PARAPET, FROM = 0.95, 0.12, 6.0
"""Height of the parapet of a balcony, its thickness, and the front from which there is one."""


HOUSE = HouseForm()


def openings(
    footprint: Footprint, eave: float, look: HouseLook, form: HouseForm = HOUSE
) -> WallOpenings:
    """Windows in every bay of every storey of every side, the entrance in the front, and the beams
    and the balcony of the style. A front with no room for a window beside its door has a light in
    the door."""
    found = WallOpenings([], [], [], [], [], [], [], [])
    windows, storeys = form.windows or look.windows, count_storeys(eave, look.most)
    around = shapely.length(shapely.LinearRing(footprint)) * storeys / WINDOWS
    sides, front = list_sides(footprint, max(windows.bay, around), form.party)
    open_front(found, front, eave, look, form)
    shown = 1 if form.entrance in ("gate", "portal") else storeys
    fill_bays(found, front, front.bays, range(1, shown), eave, windows)
    for side in sides:
        if side.length >= windows.wide + SHORT:
            fill_bays(found, side, side.bays, range(shown), eave, windows)
    if look.frame is not None and form.entrance not in ("gate", "portal"):
        first = int(storeys > 1 or form.entrance == "shop")
        for side in (front, *sides):
            frame_side(found, side, range(first, storeys), eave, windows)
    return found


def open_front(
    found: WallOpenings, side: Side, eave: float, look: HouseLook, form: HouseForm
) -> None:
    """The entrance of a front with what is beside it on the ground floor, and its balcony."""
    if form.entrance == "shop":
        _open_shop(found, side, eave)
    else:
        _open_house(found, side, eave, look, form)
    if look.balcony and form.entrance in ("door", "byre") and count_storeys(eave) > 1:
        _add_balcony(found, side, look.overhang)


def entrance_bay(side: Side) -> int:
    """The bay of the entrance: the middle one, of two either, by the length of the front."""
    count = len(side.bays)
    return round(100 * side.length) % 2 if count == 2 else count // 2


def _open_house(
    found: WallOpenings, side: Side, eave: float, look: HouseLook, form: HouseForm
) -> None:
    bay = entrance_bay(side)
    at = sum(side.bays[bay]) / 2
    asked = {"gate": GATE, "portal": PORTAL}.get(form.entrance, DOOR)
    most = 0.6 * side.length if form.entrance == "gate" else side.length - 0.5
    wide, top = max(min(asked[0], most), 0.6), max(min(asked[1], eave - 0.15), 1.2)
    if form.entrance == "gate":
        at = 0.0
    _add_door(found, side, at, wide, top, form.entrance != "gate")
    room = wide / 2 + SURROUND + APART
    spans = [
        (max(a, at + room) if a > at else a, min(b, at - room) if b < at else b)
        for k, (a, b) in enumerate(side.bays)
        if k != bay
    ]
    spans = [(a, b) for a, b in spans if not (a < at + room and b > at - room)]
    if form.entrance == "byre" and len(side.bays) > 4:
        spans = _open_byre(found, side, spans, eave)
    before = len(found.panes)
    fill_bays(found, side, spans, range(1), eave, form.windows or look.windows)
    if len(found.panes) == before:
        _add_light(found, side, at, wide, top)


def _open_byre(
    found: WallOpenings, side: Side, spans: list[Interval], eave: float
) -> list[Interval]:
    """The gate of the byre in the last bays of a farmhouse, and the bays that are left."""
    start, end = spans[-2][0], spans[-1][1]
    wide, top = min(GATE[0], end - start - 0.5), max(min(BYRE, eave - 0.15), 1.2)
    _add_door(found, side, (start + end) / 2, wide, top, False)
    return spans[:-2]


def _add_light(found: WallOpenings, side: Side, at: float, wide: float, top: float) -> None:
    """Glass in the head of a door."""
    pane = block((at - 0.3 * wide, at + 0.3 * wide), (-OUT, 1.3 * OUT), (top - 0.5, top - 0.15))
    found.panes.append(on_side(pane, side))


def _add_door(
    found: WallOpenings, side: Side, at: float, wide: float, top: float, step: bool
) -> None:
    """A door or gate about a place along a side, with a step before a door."""
    half = wide / 2
    leaf = block((at - half, at + half), (-OUT, OUT), (0.06, top))
    outer = (at - half - SURROUND, at + half + SURROUND)
    rim = block(outer, (-OUT, 0.6 * OUT), (0.0, top + SURROUND))
    found.doors.append(on_side(leaf, side))
    found.frames.append(on_side(rim, side))
    if step:
        tread = block((at - half - 0.25, at + half + 0.25), (-OUT, 0.3), (0.0, 0.1))
        found.stones.append(on_side(tread, side))


def _open_shop(found: WallOpenings, side: Side, eave: float) -> None:
    """A shop over the whole front: panes beside its door, and the band of its sign above."""
    reach = max(side.length / 2 - EDGE, 0.4)
    top = max(min(SHOP_TOP, eave - SIGN[1] - 0.2), 1.6)
    at = sum(side.bays[entrance_bay(side)]) / 2 if len(side.bays) > 1 else 0.0
    wide = min(DOOR[0] - 0.1, 1.2 * reach)
    _add_door(found, side, at, wide, top - 0.06, True)
    made = [block((-reach, reach), (-OUT, OUT), _sign(top, eave))]
    room = wide / 2 + SURROUND + APART
    for a, b in ((-reach, at - room), (at + room, reach)):
        if b - a > 0.5:
            made.append(block((a, b), (-OUT, 0.5 * OUT), (0.06, top)))
            found.panes.extend(on_side(pane, side) for pane in _shop_panes((a, b), top))
    if not any(b - a > 0.5 for a, b in ((-reach, at - room), (at + room, reach))):
        _add_light(found, side, at, wide, top)
    found.shops.extend(on_side(mesh, side) for mesh in made)


def _sign(top: float, eave: float) -> Interval:
    """From where to where the sign of a shop reaches, below the floor above and the eave."""
    return top + SURROUND + 0.02, max(min(top + SIGN[1], FLOOR + 0.1, eave - 0.05), top + SIGN[0])


def _shop_panes(span: Interval, top: float) -> list[Mesh]:
    count = max(1, round((span[1] - span[0]) / PANEL + 0.3))
    wide = (span[1] - span[0]) / count
    return [
        block(
            (span[0] + k * wide + 0.07, span[0] + (k + 1) * wide - 0.07),
            (-OUT, OUT),
            (SILL, top - 0.1),
        )
        for k in range(count)
    ]


def _add_balcony(found: WallOpenings, side: Side, deep: float) -> None:
    """A balcony of wood along the first floor of a front, under the eaves."""
    half, out = side.length / 2 - EDGE, deep - 0.1
    if side.length < FROM or out < 0.4:
        return
    slab = block((-half, half), (0.0, out), (FLOOR - 0.18, FLOOR - 0.02))
    rail = block((-half, half), (out - PARAPET, out), (FLOOR - 0.02, FLOOR + BALCONY - 0.25))
    top = block((-half, half), (out - PARAPET, out + 0.03), (FLOOR + 0.78, FLOOR + BALCONY))
    found.woods.extend(on_side(mesh, side) for mesh in (slab, rail, top))
