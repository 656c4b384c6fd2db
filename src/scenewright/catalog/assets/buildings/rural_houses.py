"""Houses of villages over any footprint, in every style of
:mod:`~scenewright.catalog.assets.buildings.house_looks` and every form a use gives them.

Gabled wings, hips, saddles and flat roofs; Hui houses have stepped gables that keep fire from the
neighbour's roof, and, where they are wide enough, a court that the roofs drain into.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.catalog.assets.buildings.building_plans import plan, ridge
from scenewright.catalog.assets.buildings.court_houses import COURT, build_court_house
from scenewright.catalog.assets.buildings.gable_walls import list_ends, show_gable
from scenewright.catalog.assets.buildings.house_fronts import openings
from scenewright.catalog.assets.buildings.house_looks import (
    FORMS,
    LOOKS,
    SHED,
    HouseForm,
    HouseLook,
    asset_of_house,
)
from scenewright.catalog.assets.buildings.house_parts import join_parts
from scenewright.catalog.assets.buildings.house_roofs import roof_over
from scenewright.catalog.assets.buildings.house_shapes import (
    Wing,
    gabled_roof,
    gabled_walls,
    hips,
    inset,
    list_wings,
    saddle,
    split_wings,
    stepped_gable,
    tallest,
)
from scenewright.catalog.assets.buildings.house_walls import FLOOR, SPARE, count_storeys
from scenewright.catalog.assets.buildings.roofs import spire
from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.materials import STONE
from scenewright.catalog.assets.model import Parts
from scenewright.core.footprint import Footprint
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, extrude
from scenewright.geometry.solids import Interval, block

LIVED = ("door", "byre", "shop")
"""Entrances of what is lived in."""
CHIMNEY, TURRET, THICK, LOWEST = 0.55, 1.8, 0.16, 1.9
"""Height of chimneys and of the turrets of halls over the ridge, thickness of roofs, least height
of eaves, in metres."""
WALLED, ROW_PITCH = 0.5, 0.5
"""Least share of a house's height below its eaves, and the rise of the roof of a row by a metre."""
LOWERED = 0.7
"""The share of its usual rise to which a roof is lowered for the sake of a storey."""
BROAD = 6.0
"""Metres of span and height from which a hall has a turret."""
PARAPET = 0.3
"""Thickness of walls that stand above a roof, in metres."""


class HouseBody(NamedTuple):
    """What is drawn: the size, outline in the frame of the box and square metres of a house, its
    style, its form, and whether its gables are stepped."""

    size: Size
    outline: Footprint
    area: float
    look: HouseLook
    form: HouseForm
    stepped: bool


def build_house(
    size: Size, footprint: Footprint, style: str, roof: str, form: str = "house"
) -> Parts:
    """A house of a style and form over a footprint: its roof gabled, hipped or flat."""
    body = body_of(size, footprint, style, form)
    roofing, wings = roofing_of(body, roof)
    if roofing == "flat":
        return _build_flat(body)
    if roofing == "court":
        return build_court_house(size, body.look, body.form)
    return _build_hips(body) if roofing == "hips" else _build_gables(body, wings)


def body_of(size: Size, footprint: Footprint, style: str, form: str) -> HouseBody:
    """What is drawn of a house; one too small to live in has the gate of a barn."""
    w, d = size.width / 2, size.depth / 2
    outline = footprint or ((-w, -d), (w, -d), (w, d), (-w, d))
    area = float(shapely.Polygon(outline).area)
    drawn = FORMS["barn"] if form == "house" and area < SHED else FORMS[form]
    return HouseBody(size, outline, area, LOOKS[style], drawn, style == "hui")


def roofing_of(body: HouseBody, roof: str) -> tuple[str, tuple[Wing, ...]]:
    """How a house is roofed (flat, court, hips or gables) and the wings of its footprint; the
    ridge of a row runs along it."""
    wings = split_wings(body.outline) if body.stepped else list_wings(body.outline)
    if body.form.party and len(wings) == 1:
        wings = (wings[0]._replace(along="x"),)
    if roof == "flat":
        return "flat", wings
    lived = body.form.entrance in LIVED
    if body.stepped and lived and len(wings) == 1 and min(body.size[:2]) >= COURT:
        return "court", wings
    if not wings or (roof == "hipped" and not body.stepped):
        return "hips", wings
    return "gables", wings


class GableHeights(NamedTuple):
    """Of a gabled house in metres: its chimney or turret, what gables stand above the roof, the
    ridge of the widest wing below the roof's thickness, the rise by a metre, and the eaves."""

    chimney: float
    above: float
    top: float
    pitch: float
    eave: float


def gable_heights(body: HouseBody, wings: tuple[Wing, ...]) -> GableHeights:
    """The heights of a house of gabled wings, the widest first."""
    lived = body.form.entrance in LIVED and body.area >= SHED
    chimney = CHIMNEY if lived and not body.stepped else 0.0
    broad = wings[0].span >= BROAD and body.size.height >= BROAD
    chimney = TURRET if body.form.entrance == "portal" and broad else chimney
    above, half = (0.5 if body.stepped else 0.0), wings[0].span / 2
    top = body.size.height - chimney - THICK - above
    pitch = min(body.look.pitch, ROW_PITCH) if body.form.party else body.look.pitch
    pitch = _raise_eave(body, top, min(pitch, (top - _least_eave(body)) / half), half)
    return GableHeights(chimney, above, top, pitch, top - pitch * half)


def _least_eave(body: HouseBody) -> float:
    """Metres of the lowest eaves: half the height of a house, which is no roof on the ground."""
    return max(LOWEST, WALLED * body.size.height if body.area >= SHED else 0.0)


def _raise_eave(body: HouseBody, top: float, pitch: float, half: float) -> float:
    """The rise of a roof by a metre, a little less where that gives room for one storey more."""
    eave = top - pitch * half
    storeys = min(count_storeys(eave) + 1, body.look.most)
    lower = (top - storeys * FLOOR + SPARE - 1e-6) / half
    return lower if LOWERED * pitch <= lower < pitch else pitch


def hip_heights(body: HouseBody) -> tuple[float, float]:
    """The eaves of a hipped house and the rise of its roof by a metre."""
    half = tallest(body.outline)
    top = body.size.height
    pitch = _raise_eave(body, top, min(body.look.pitch, (top - _least_eave(body)) / half), half)
    return top - pitch * half, pitch


def _build_gables(body: HouseBody, wings: tuple[Wing, ...]) -> Parts:
    """Wings under gables; stepped gables stand above the roof."""
    look, (chimney, above, top, pitch, eave) = body.look, gable_heights(body, wings)
    walls, caps = list[Mesh](), list[Mesh]()
    roofs = [] if body.stepped else roof_over(wings, eave, pitch, THICK)
    inner = walls_of(body)
    shown = openings(inner, eave, look, body.form)
    for wing in wings:
        rise = pitch * wing.span / 2
        walls.append(
            gabled_walls(wing, eave, rise, look.overhang, 0.0 if body.form.party else None)
        )
        if body.stepped:
            roofs.append(gabled_roof(wing, eave, rise, THICK, 0.2, 0.03))
            for wall, copings in _gable_ends(wing, wings[0], eave, eave + rise + THICK + above):
                walls.append(wall)
                caps += copings
        elif body.area >= SHED and not body.form.party:
            for end in list_ends(wing, look.overhang):
                show_gable(shown, end, eave, pitch, look, body.form)
    stack = _stand_on_ridge(body, wings[0], top, chimney)
    return join_parts(body.size, look, inner, eave, walls, [*roofs, *caps], shown, stack)


def walls_of(body: HouseBody) -> Footprint:
    """The outline of the walls, under the eaves; the side walls of a row stand on its borders."""
    inner = inset(body.outline, body.look.overhang)
    if not body.form.party:
        return inner
    ring, by = np.array(inner), body.size.width / np.ptp(np.array(inner)[:, 0])
    return tuple((float(x * by), float(y)) for x, y in ring)


def _gable_ends(wing: Wing, main: Wing, eave: float, top: float) -> list[tuple[Mesh, list[Mesh]]]:
    """The stepped gables of a wing; none at an end that is within the ``main`` one."""
    across, length = (wing.y, wing.x) if wing.along == "x" else (wing.x, wing.y)
    ends: tuple[Interval, ...] = (
        (length[0], length[0] + PARAPET),
        (length[1] - PARAPET, length[1]),
    )
    theirs = main.x if wing.along == "x" else main.y
    if wing is not main:
        ends = tuple(e for e in ends if e[1] < theirs[0] or e[0] > theirs[1])
    return [stepped_gable(across, end, eave, top - 0.14, wing.along) for end in ends]


def _stand_on_ridge(body: HouseBody, wing: Wing, top: float, high: float) -> list[Mesh]:
    """The chimney of a house, or the turret of a hall."""
    if not high:
        return []
    x, y = sum(wing.x) / 2, sum(wing.y) / 2
    if body.form.entrance == "portal":
        y = y + 0.3 * (wing.y[1] - wing.y[0]) if wing.along == "y" else y
        walls = block((x - 0.55, x + 0.55), (y - 0.55, y + 0.55), (top - 1.2, top + 0.55 * high))
        return [walls, spire(x, y, (top + 0.55 * high, body.size.height), 0.75, 4, np.pi / 4)]
    if wing.along == "x":
        x, y = x + 0.22 * (wing.x[1] - wing.x[0]), y + 0.35
    else:
        x, y = x + 0.35, y + 0.22 * (wing.y[1] - wing.y[0])
    return [block((x - 0.3, x + 0.3), (y - 0.3, y + 0.3), (top - 1.2, top + THICK + high))]


def _build_hips(body: HouseBody) -> Parts:
    """Hips of one slope where there are any, a saddle over anything else."""
    eave, pitch = hip_heights(body)
    outline, inner = body.outline, walls_of(body)
    walls = [extrude(inner, 0.0, eave + 0.05)]
    roofs = hips(outline, eave, pitch) or saddle(outline, eave, body.size.height)
    shown = openings(inner, eave, body.look, body.form)
    return join_parts(body.size, body.look, inner, eave, walls, roofs, shown, [])


def _build_flat(body: HouseBody) -> Parts:
    """Walls to the top, the roof set a little below them."""
    outline, top = body.outline, body.size.height
    inner = inset(outline, 0.25)
    walls = [extrude(outline, 0.0, top - 0.25)]
    rim = shapely.difference(shapely.Polygon(outline), shapely.Polygon(inner))
    if rim.geom_type == "Polygon" and rim.interiors:
        walls += _rim(outline, inner, (top - 0.3, top))
    else:
        walls.append(extrude(outline, top - 0.3, top))
    roof = [extrude(inner, top - 0.3, top - 0.2)]
    look = body.look._replace(roof=STONE, balcony=False)
    shown = openings(outline, top - 0.4, look, body.form)
    return join_parts(body.size, look, outline, top - 0.4, walls, roof, shown, [])


def _rim(outline: Footprint, inner: Footprint, z: tuple[float, float]) -> list[Mesh]:
    """The parapet as one block a side."""
    outer, within = np.array(outline), np.array(inner)
    if len(outer) != len(within):
        return []
    first = int(np.argmin(np.hypot(*(within - outer[0]).T)))
    within = np.roll(within, -first, axis=0)
    made = []
    for k in range(len(outer)):
        after = (k + 1) % len(outer)
        made.append(extrude([outer[k], outer[after], within[after], within[k]], *z))
    return made


def storeys_of_house(size: Size, footprint: Footprint, words: Sequence[str]) -> int:
    """Storeys with windows of a house by its form, style and roof.

    >>> storeys_of_house(Size(12, 9, 9.6), (), ("house", "rural", "gabled"))
    2
    """
    form, style, roof = words
    body = body_of(size, footprint, style, form)
    if body.form.entrance not in LIVED:
        return 1
    roofing, wings = roofing_of(body, roof)
    if roofing == "gables":
        return count_storeys(gable_heights(body, wings).eave, body.look.most)
    eave = hip_heights(body)[0] if roofing == "hips" else size.height - 0.4
    return count_storeys(eave, body.look.most)


def _drawing(form: str, style: str, roof: str) -> Drawing:
    build = partial(build_house, style=style, roof=roof, form=form)
    name = NAMES.get(style, f"{style[:1].upper()}{style[1:]}")
    return Drawing(
        "house",
        lambda size: build(size, ()),
        plan(*(ridge(0.5) if roof == "hipped" else ridge(1.0)[:1] if roof == "gabled" else ())),
        asset_of_house(form, style, roof),
        f"{name} {CALLED[form]}, {roof}",
        over=build,
    )


NAMES = {"timbered": "Half-timbered", "hill": "Hill-village", "plain": "Contemporary"}
CALLED = {
    "house": "house",
    "row": "terraced house",
    "farm": "farmhouse",
    "shop": "house with a shop",
    "rowshop": "terraced house with a shop",
    "barn": "barn",
    "works": "workshop",
    "hall": "hall",
}
ASSETS = tuple(
    _drawing(form, style, roof)
    for form, row in FORMS.items()
    for style in LOOKS
    for roof in row.roofs
)
