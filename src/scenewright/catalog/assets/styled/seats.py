"""Sofas, armchairs and corner sofas in the forms of styles."""

from __future__ import annotations

from typing import NamedTuple

from scenewright.catalog.assets.furniture.corners import cover, mirror_drawing
from scenewright.catalog.assets.furniture.seating import (
    LOOSE,
    SOFT,
    corner_sofa_outline,
    corner_sofa_symbol,
    sofa_symbol,
    throw_pillow,
)
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import (
    FABRIC,
    FABRIC_LIGHT,
    LEATHER,
    MUSTARD,
    NAVY,
    OAK,
    SAGE_FABRIC,
    TERRACOTTA,
    WALNUT,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.styled.forms import Form, add, draw_forms, stand
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import Interval, block, cushion, leg, pad, rod


class Upholstery(NamedTuple):
    """How a style's seats are made: ``cloth`` of the body and of the ``soft`` cushions, the ``arm``
    and its width, how the ``back`` is divided, metres of seat to a cushion (``each``), the ``lift``
    of the body above the floor, and how many throw ``pillows`` lie on a sofa."""

    cloth: Material
    soft: Material
    arm: str
    width: float
    back: str
    each: float
    lift: float
    pillows: int


STYLES: dict[str, Upholstery] = {
    "nordic": Upholstery(FABRIC, FABRIC, "slim", 0.09, "cushions", 0.8, 0.17, 2),
    "classic": Upholstery(FABRIC, FABRIC, "rolled", 0.22, "tufted", 0.65, 0.09, 2),
    "industrial": Upholstery(LEATHER, LEATHER, "club", 0.2, "cushions", 0.75, 0.13, 1),
    "japandi": Upholstery(OAK, FABRIC, "none", 0.02, "bench", 2.4, 0.13, 2),
    "retro": Upholstery(FABRIC, FABRIC, "wood", 0.08, "buttoned", 0.6, 0.2, 0),
    "boho": Upholstery(FABRIC, FABRIC_LIGHT, "puffy", 0.2, "cushions", 0.95, 0.06, 5),
}
ACCENTS = (TERRACOTTA, MUSTARD, NAVY, SAGE_FABRIC, FABRIC_LIGHT)


def _arm(row: Upholstery, x: Interval, y: Interval, z: tuple[float, float]) -> Stuff:
    """An arm over an interval in x, from the body's underside to ``z[1]``, the height of the
    seat."""
    low, seat = z
    middle = (x[0] + x[1]) / 2
    match row.arm:
        case "slim":
            return {row.cloth: [cushion(x, y, (low, seat + 0.2), 0.025)]}
        case "club":
            return {row.cloth: [cushion(x, y, (low, seat + 0.26), 0.06, 1)]}
        case "puffy":
            return {row.cloth: [cushion(x, y, (low, seat + 0.18), 0.09, 2)]}
        case "rolled":
            roll = rod((middle, y[0], seat + 0.14), (middle, y[1], seat + 0.14), 0.1, sides=7)
            return {
                row.cloth: [
                    cushion((middle - 0.075, middle + 0.075), y, (low, seat + 0.14), 0.02),
                    roll,
                ]
            }
        case "wood":
            rest = cushion(x, y, (seat + 0.16, seat + 0.19), 0.012, 1)
            posts = [
                rod((middle, v, 0.0), (middle, v, seat + 0.17), 0.02, 0.016)
                for v in (y[0] + 0.1, y[1] - 0.08)
            ]
            return {WALNUT: [rest, *posts]}
    return {}


def _backs(row: Upholstery, x: Interval, y: float, z: Interval) -> Stuff:
    """What one leans on, from the back ``y`` on, over an interval in x and z."""
    wide, tall = x[1] - x[0], z[1] - z[0]
    count = max(1, round(wide / row.each))
    thick = 0.17 if row.back != "bench" else 0.14
    lean = 0.14
    soft = [
        translate_mesh(
            rotate_mesh(pad((a + 0.004, b - 0.004), (0, thick), (0, tall), 0.05, LOOSE), "x", lean),
            0,
            y + 0.04,
            z[0],
        )
        for a, b in spread(*x, count)
    ]
    found: Stuff = {row.soft: soft}
    if row.back in ("tufted", "buttoned"):
        across = max(3, round(wide / 0.4))
        rows = (0.4, 0.72) if row.back == "tufted" else (0.6,)
        found[WALNUT if row.back == "buttoned" else TERRACOTTA] = [
            _button((a + b) / 2, y + 0.05 + thick - lean * r * tall, z[0] + r * tall)
            for r in rows
            for a, b in spread(*x, across)
        ]
    return found


def _button(x: float, y: float, z: float) -> Mesh:
    return block((x - 0.012, x + 0.012), (y - 0.02, y), (z - 0.012, z + 0.012))


def _seats(row: Upholstery, x: Interval, y: Interval, z: Interval) -> list[Mesh]:
    count = max(1, round((x[1] - x[0]) / row.each))
    return [pad((a + 0.003, b - 0.003), y, z, 0.05, SOFT) for a, b in spread(*x, count)]


def _pillows(row: Upholstery, x: Interval, y: float, z: float, side: float) -> Stuff:
    """Throw pillows from the ends inwards, each in another cloth."""
    found: Stuff = {}
    for k in range(row.pillows if x[1] - x[0] > 0.9 else min(row.pillows, 1)):
        sign, step = (-1 if k % 2 == 0 else 1), 0.24 + 0.3 * (k // 2)
        at = (x[0] if sign < 0 else x[1]) - sign * step
        if x[0] + 0.15 < at < x[1] - 0.15:
            pillow = throw_pillow(at, y - 0.03 * (k // 2), z, side, 0.3, sign * 0.3)
            add(found, {ACCENTS[k]: [pillow]})
    return found


def _sofa(form: Form, size: Size, cloths: Upholstery | None = None) -> Parts:
    row = cloths or STYLES[form.name]
    w, d, h = size.width / 2, size.depth / 2, size.height
    arm, seat, low = min(row.width, 0.3 * w), min(0.43, 0.55 * h), row.lift
    inner = (-w + arm, w - arm)
    top = h - (0.03 if row.back in ("tufted", "buttoned") else 0.07)
    found = stand(form, w, d, low + 0.01, WALNUT)
    rear = (-d, -d + (0.05 if row.arm in ("none", "wood") else 0.14))
    add(
        found,
        {
            row.cloth: [
                cushion(
                    (-w + 0.01, w - 0.01),
                    (-d + 0.01, d - 0.03),
                    (low, max(seat - 0.15, low + 0.04)),
                    0.015,
                    1,
                ),
                cushion(
                    (-w + 0.005, w - 0.005), rear, (low, top), 0.02 if row.arm == "none" else 0.05
                ),
            ]
        },
    )
    for side in (-1, 1):
        x = (-w, -w + arm) if side < 0 else (w - arm, w)
        add(found, _arm(row, x, (-d + 0.02, d - 0.01), (low, seat)))
    add(found, {row.soft: _seats(row, inner, (-d + 0.13, d), (seat - 0.16, seat))})
    add(found, _backs(row, inner, -d + 0.08, (seat - 0.02, h)))
    add(found, _pillows(row, inner, -d + 0.38, seat - 0.02, min(0.42, h - seat - 0.02)))
    return parts(size, found)


def _armchair(form: Form, size: Size) -> Parts:
    """The sofa's little brother: one seat, in the second cloth."""
    row = STYLES[form.name]
    cloth = SAGE_FABRIC if row.cloth is FABRIC else row.cloth
    soft = row.soft if row.soft is LEATHER else SAGE_FABRIC
    one = row._replace(cloth=cloth, soft=soft, width=0.7 * row.width, each=9.0, pillows=0)
    return _sofa(form, size, one)


def _corner_sofa(form: Form, size: Size) -> Parts:
    """A sofa with a lounge on its left, on plain feet."""
    row = STYLES[form.name]
    w, d, h = size.width / 2, size.depth / 2, size.height
    arm, seat, low = row.width, min(0.43, 0.55 * h), row.lift
    (_, front), (edge, _) = corner_sofa_outline(size)[2], corner_sofa_outline(size)[4]
    flat = max(seat - 0.15, low + 0.04)
    corners = (
        (-w, -d),
        (-w, d - 0.1),
        (edge - 0.1, d - 0.1),
        (w - 0.1, -d),
        (w - 0.1, front - 0.1),
    )
    found: Stuff = {
        WALNUT: [leg(x + 0.06, y + 0.06, (0, low + 0.01), 0.026, 0.02) for x, y in corners]
    }
    add(
        found,
        {
            row.cloth: [
                cushion((edge - 0.02, w - 0.01), (-d + 0.01, front - 0.03), (low, flat), 0.015, 1),
                cushion((-w + 0.01, edge), (-d + 0.01, d - 0.02), (low, flat), 0.015, 1),
                cushion((-w + 0.005, w - 0.005), (-d, -d + 0.14), (low, h - 0.06), 0.04),
            ]
        },
    )
    add(found, _arm(row, (w - arm, w), (-d + 0.02, front - 0.01), (low, seat)))
    add(found, _arm(row, (-w, -w + arm), (-d + 0.02, front - 0.01), (low, seat)))
    z, back = (seat - 0.16, seat), (seat - 0.02, h)
    add(
        found,
        {
            row.soft: [
                *_seats(row, (edge, w - arm), (-d + 0.13, front), z),
                pad((-w + arm, edge - 0.003), (-d + 0.13, front - 0.003), z, 0.05, SOFT),
                pad((-w, edge - 0.003), (front, d), z, 0.05, SOFT),
            ]
        },
    )
    add(found, _backs(row, (edge, w - arm), -d + 0.08, back))
    plain = row._replace(each=9.0, back="cushions")
    add(found, _backs(plain, (-w + arm, edge), -d + 0.08, back))
    add(
        found,
        _pillows(row, (-w + arm, w - arm), -d + 0.38, seat - 0.02, min(0.42, h - seat - 0.02)),
    )
    return parts(size, found)


CORNERS = draw_forms("corner_sofa", _corner_sofa, corner_sofa_symbol, cover(corner_sofa_outline))
ASSETS = (
    *draw_forms("sofa", _sofa, sofa_symbol),
    *draw_forms("loveseat", _sofa, sofa_symbol),
    *CORNERS,
    *map(mirror_drawing, CORNERS),
    *draw_forms("armchair", _armchair, sofa_symbol),
)
