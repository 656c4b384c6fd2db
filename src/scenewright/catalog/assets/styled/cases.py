"""Wardrobes, chests, sideboards, stands and nightstands in the forms of styles."""

from __future__ import annotations

from scenewright.catalog.assets.bodies import Opens
from scenewright.catalog.assets.furniture.storage import draw_front_line, draw_hangers
from scenewright.catalog.assets.joinery import corpus, spread
from scenewright.catalog.assets.materials import BLACK, CREAM, OAK, RUBBER, WALNUT
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff, book_rows
from scenewright.catalog.assets.styled.forms import (
    Form,
    add,
    draw_forms,
    draw_fronts,
    draw_handles,
    stand,
)
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.solids import Interval, block, slab

BODY: dict[str, Material] = {
    "nordic": OAK,
    "classic": CREAM,
    "industrial": BLACK,
    "japandi": OAK,
    "retro": WALNUT,
    "boho": OAK,
}
"""What the bodies of a style's cases are of."""
FACE = 0.02
PULL = 0.02


def _case(form: Form, size: Size, lift: float) -> tuple[Stuff, Interval, Interval, float]:
    """Top, body and feet of a case; where its fronts go in x and z, and how far forward."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    face, body = d - FACE - PULL, BODY[form.name]
    over = 0.0 if form.name in ("japandi", "industrial") else 0.012
    found = stand(form, w - over, d - 0.03, lift + 0.005, body if body is not CREAM else WALNUT)
    top = OAK if form.name == "industrial" else body
    add(found, {top: [slab((-w, w), (-d, d - 0.015), (h - 0.022, h), min(form.edge, 0.02))]})
    add(found, {body: [block((-w + over, w - over), (-d + 0.004, face), (lift, h - 0.02))]})
    return found, (-w + over + 0.012, w - over - 0.012), (lift + 0.012, h - 0.028), face


def _fill(
    form: Form,
    found: Stuff,
    x: Interval,
    z: Interval,
    grid: tuple[int, int],
    face: float,
    opens: Opens,
) -> None:
    """Fronts with their handles over an interval in x and z."""
    columns, rows = grid
    add(found, draw_fronts(form, x, z, columns, rows, (face, face + FACE), form.panel, opens))
    add(found, draw_handles(form, x, z, columns, rows, face + FACE, PULL, opens == "door"))


def _wardrobe(form: Form, size: Size) -> Parts:
    """Doors over all its height; drawers below them where doors are framed or inset."""
    found, x, z, face = _case(form, size, 0.05 if form.legs == "turned" else min(form.lift, 0.12))
    doors = max(1, round(size.width / 0.5))
    if form.front in ("framed", "inset"):
        split = z[0] + 0.18 * (z[1] - z[0])
        _fill(form, found, x, (z[0], split), (max(1, doors // 2), 1), face, "drawer")
        z = (split, z[1])
    _fill(form, found, x, z, (doors, 1), face, "door")
    return parts(size, found)


def _chest(form: Form, size: Size) -> Parts:
    found, x, z, face = _case(form, size, form.lift)
    rows = max(2, round((z[1] - z[0]) / 0.24))
    _fill(form, found, x, z, (2 if size.width > 1.05 else 1, rows), face, "drawer")
    return parts(size, found)


def _sideboard(form: Form, size: Size) -> Parts:
    """Doors at both ends and drawers between; doors alone where handles are none."""
    found, x, z, face = _case(form, size, form.lift)
    if form.handle == "none":
        _fill(form, found, x, z, (max(2, round(size.width / 0.5)), 1), face, "door")
        return parts(size, found)
    a, b = (x[0] + k * (x[1] - x[0]) / 3 for k in (1, 2))
    _fill(form, found, (x[0], a), z, (1, 1), face, "door")
    _fill(form, found, (a, b), z, (1, 3), face, "drawer")
    _fill(form, found, (b, x[1]), z, (1, 1), face, "door")
    return parts(size, found)


def _tv_stand(form: Form, size: Size) -> Parts:
    """Two doors beside an open shelf."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    lift = min(form.lift, 0.35 * h)
    body = BODY[form.name]
    found = stand(form, w, d - 0.02, lift + 0.005, body if body is not CREAM else WALNUT)
    add(found, {body: corpus((-w, w), (-d, d - PULL), (lift, h), 0.022)})
    x, z, face = (-w + 0.024, w - 0.024), (lift + 0.024, h - 0.024), d - FACE - PULL
    a, b = (x[0] + k * (x[1] - x[0]) / 3 for k in (1, 2))
    for part in ((x[0], a), (b, x[1])):
        add(found, {body: [block(part, (-d + 0.01, face), z)]})
        _fill(form, found, part, z, (1, 1), face, "door")
    middle = sum(z) / 2
    add(found, {body: [block((a, b), (-d + 0.01, face), (middle - 0.008, middle + 0.008))]})
    add(
        found,
        {RUBBER: [block((-0.17, 0.17), (-d + 0.08, face - 0.06), (middle + 0.008, middle + 0.05))]},
    )
    return parts(size, found)


def _shoe_cabinet(form: Form, size: Size) -> Parts:
    found, x, z, face = _case(form, size, min(form.lift, 0.1))
    rows = max(2, round(size.height / 0.4))
    _fill(form, found, x, z, (2 if size.width > 0.95 else 1, rows), face, "flap")
    return parts(size, found)


def _nightstand(form: Form, size: Size) -> Parts:
    """One or two drawers, or a drawer over an open foot."""
    h = size.height
    lift = min(max(form.lift, 0.05), 0.4 * h)
    found, x, z, face = _case(form, size, 0.55 * h if form.legs in ("sled", "cross") else lift)
    _fill(form, found, x, z, (1, 1 if z[1] - z[0] < 0.26 else 2), face, "drawer")
    return parts(size, found)


def _bookcase(form: Form, size: Size) -> Parts:
    """Open shelves; on doors where cases are of cream or cane."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    body, columns = BODY[form.name], max(1, round(size.width / 0.8))
    shelves, low = max(2, round(h / 0.36) - 1), 0.0
    found: Stuff = {}
    if form.front in ("framed", "cane") and h > 1.2:
        low = 0.3 * h
        found, x, z, face = _case(form, size._replace(height=low), 0.05)
        _fill(form, found, x, z, (columns, 1), face, "door")
        shelves = max(1, shelves - 2)
    wood = OAK if body is BLACK else body
    case = corpus((-w, w), (-d, d - 0.02), (low, h), 0.022, shelves, columns - 1, body is not BLACK)
    add(found, {wood: case[2:] if body is BLACK else case})
    add(found, {BLACK: case[:2]} if body is BLACK else {})
    step = (h - low - 0.02) / (shelves + 1)
    levels = [(low + k * step + 0.014, low + (k + 1) * step - 0.014) for k in range(shelves + 1)]
    for k, (a, b) in enumerate(spread(-w + 0.02, w - 0.02, columns)):
        add(found, book_rows((a + 0.014, b - 0.014), (-d + 0.03, d - 0.05), levels, 0.6, 31 * k))
    return parts(size, found)


ASSETS = (
    *draw_forms("wardrobe", _wardrobe, draw_hangers),
    *draw_forms("chest_of_drawers", _chest, draw_front_line),
    *draw_forms("sideboard", _sideboard, draw_front_line),
    *draw_forms("tv_stand", _tv_stand, draw_front_line),
    *draw_forms("shoe_cabinet", _shoe_cabinet, draw_front_line),
    *draw_forms("nightstand", _nightstand, draw_front_line),
    *draw_forms("bookcase", _bookcase, draw_front_line),
)
