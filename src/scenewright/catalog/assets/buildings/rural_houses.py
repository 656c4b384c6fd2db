"""Houses of villages over any footprint, in three styles: rural, riviera, and Hui.

Rural houses have rendered walls, steep clay roofs and shutters; those of the Riviera ochre walls
and flat slopes; Hui houses (Anhui, China) white walls, grey tiles, stepped gables that keep fire
from the neighbour's roof, and, where they are wide enough, a court that the roofs drain into.
"""

from __future__ import annotations

from functools import partial
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.catalog.assets.buildings.building_plans import plan, ridge
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
from scenewright.catalog.assets.buildings.house_walls import WallOpenings, WindowLook, openings
from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.materials import (
    BLUSH,
    BRICK,
    LIMESTONE,
    OCHRE,
    PANE,
    PLASTER,
    RENDER,
    SAGE,
    SANDSTONE,
    STONE,
    TILES,
    TILES_DARK,
    TIMBER,
    WALNUT,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts, pick
from scenewright.core.catalog import Material
from scenewright.core.footprint import Footprint
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, extrude
from scenewright.geometry.solids import block


class HouseLook(NamedTuple):
    """A style: materials of walls (one is picked by size), roof and shutters, the rise of a roof by
    half its span, the overhang of the eaves, and its windows."""

    walls: tuple[Material, ...]
    roof: Material
    shutters: Material
    pitch: float
    overhang: float
    windows: WindowLook


LOOKS = {
    "rural": HouseLook(
        (RENDER, RENDER, OCHRE), TILES, TIMBER, 0.85, 0.35, WindowLook(2.7, 0.95, 1.25, 0.95, True)
    ),
    "riviera": HouseLook(
        (OCHRE, BLUSH, SANDSTONE, RENDER),
        TILES,
        SAGE,
        0.42,
        0.25,
        WindowLook(2.9, 0.9, 1.45, 0.85, True),
    ),
    "hui": HouseLook(
        (PLASTER,), TILES_DARK, TIMBER, 0.55, 0.0, WindowLook(4.2, 0.6, 0.7, 1.7, False)
    ),
}
SHED = 45.0
"""Square metres below which a building is no dwelling: a gate, no windows nor chimney."""
CHIMNEY, THICK, LOWEST = 0.55, 0.16, 1.9
"""Height of chimneys over the ridge, thickness of roofs, least height of eaves, in metres."""
COURT = 9.5
"""Metres on both sides from which a Hui house has a court."""
PARAPET, YARD = 0.3, 0.12
"""Thickness of walls that stand above a roof, height of the ground of a court, in metres."""


def build_house(size: Size, footprint: Footprint, style: str, roof: str) -> Parts:
    """A house of a style over a footprint: its roof gabled, hipped or flat."""
    w, d = size.width / 2, size.depth / 2
    outline = footprint or ((-w, -d), (w, -d), (w, d), (-w, d))
    look = LOOKS[style]
    area = float(shapely.Polygon(outline).area)
    form, wings = form_of(size, outline, style, roof)
    if form == "flat":
        return _flat(size, outline, look, area)
    if form == "court":
        return _court_house(size, look)
    if form == "hips":
        return _build_hips(size, outline, look, area)
    return _build_gables(size, outline, wings, look, area, style == "hui")


def form_of(size: Size, outline: Footprint, style: str, roof: str) -> tuple[str, tuple[Wing, ...]]:
    """How a house is roofed (flat, court, hips or gables) and the wings of its footprint."""
    wings = split_wings(outline) if style == "hui" else list_wings(outline)
    if roof == "flat":
        return "flat", wings
    if style == "hui" and len(wings) == 1 and min(size.width, size.depth) >= COURT:
        return "court", wings
    if not wings or (roof == "hipped" and style != "hui"):
        return "hips", wings
    return "gables", wings


class GableHeights(NamedTuple):
    """Of a gabled house in metres: its chimney, what gables stand above the roof, the ridge of the
    widest wing below the roof's thickness, the rise by a metre, and the eaves."""

    chimney: float
    above: float
    top: float
    pitch: float
    eave: float


def gable_heights(
    size: Size, wings: tuple[Wing, ...], look: HouseLook, area: float, stepped: bool
) -> GableHeights:
    """The heights of a house of gabled wings, the widest first."""
    chimney = CHIMNEY if area >= SHED and not stepped else 0.0
    above = 0.5 if stepped else 0.0
    top = size.height - chimney - THICK - above
    pitch = min(look.pitch, (top - LOWEST) / (wings[0].span / 2))
    return GableHeights(chimney, above, top, pitch, top - pitch * wings[0].span / 2)


def _build_gables(
    size: Size,
    outline: Footprint,
    wings: tuple[Wing, ...],
    look: HouseLook,
    area: float,
    stepped: bool,
) -> Parts:
    """Wings under gables; ``stepped`` gables stand above the roof."""
    chimney, above, top, pitch, eave = gable_heights(size, wings, look, area, stepped)
    walls, caps = list[Mesh](), list[Mesh]()
    roofs = [] if stepped else roof_over(wings, eave, pitch, THICK)
    for wing in wings:
        rise = pitch * wing.span / 2
        walls.append(gabled_walls(wing, eave, rise, look.overhang))
        if stepped:
            roofs.append(gabled_roof(wing, eave, rise, THICK, 0.2, 0.03))
            for wall, copings in _gable_ends(wing, eave, eave + rise + THICK + above):
                walls.append(wall)
                caps += copings
    shown = openings(inset(outline, look.overhang), eave, look.windows, _gate(area, outline))
    stack = [_chimney(wings[0], top, chimney)] if chimney else []
    return _parts(size, look, walls, [*roofs, *caps], shown, stack)


def _gable_ends(wing: Wing, eave: float, top: float) -> list[tuple[Mesh, list[Mesh]]]:
    across, length = (wing.y, wing.x) if wing.along == "x" else (wing.x, wing.y)
    ends = ((length[0], length[0] + PARAPET), (length[1] - PARAPET, length[1]))
    return [stepped_gable(across, end, eave, top - 0.14, wing.along) for end in ends]


def _chimney(wing: Wing, ridge_top: float, chimney: float) -> Mesh:
    x, y = (sum(wing.x) / 2, sum(wing.y) / 2)
    if wing.along == "x":
        x, y = x + 0.22 * (wing.x[1] - wing.x[0]), y + 0.35
    else:
        x, y = x + 0.35, y + 0.22 * (wing.y[1] - wing.y[0])
    return block(
        (x - 0.3, x + 0.3), (y - 0.3, y + 0.3), (ridge_top - 1.2, ridge_top + THICK + chimney)
    )


def _build_hips(size: Size, outline: Footprint, look: HouseLook, area: float) -> Parts:
    """Hips of one slope where there are any, a saddle over anything else."""
    span = 2 * tallest(outline)
    rise = min(look.pitch * span / 2, size.height - LOWEST)
    eave = size.height - rise
    walls = [extrude(inset(outline, look.overhang), 0.0, eave + 0.05)]
    roofs = hips(outline, eave, rise / (span / 2)) or saddle(outline, eave, size.height)
    shown = openings(inset(outline, look.overhang), eave, look.windows, _gate(area, outline))
    return _parts(size, look, walls, roofs, shown, [])


def _flat(size: Size, outline: Footprint, look: HouseLook, area: float) -> Parts:
    """Walls to the top, the roof set a little below them."""
    inner = inset(outline, 0.25)
    top = size.height
    walls = [extrude(outline, 0.0, top - 0.25)]
    rim = shapely.difference(shapely.Polygon(outline), shapely.Polygon(inner))
    if rim.geom_type == "Polygon" and rim.interiors:
        walls += _rim(outline, inner, (top - 0.3, top))
    else:
        walls.append(extrude(outline, top - 0.3, top))
    roof = [extrude(inner, top - 0.3, top - 0.2)]
    shown = openings(outline, top - 0.4, look.windows, _gate(area, outline))
    stone = look._replace(roof=STONE)
    return _parts(size, stone, walls, roof, shown, [])


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


def _court_house(size: Size, look: HouseLook) -> Parts:
    """Four roofs that drain into a court, behind high white walls with stepped ends."""
    w, d = size.width / 2, size.depth / 2
    court_x, court_y, low, high = court_heights(size)
    rings = [(w - PARAPET, d - PARAPET, high), (court_x, court_y, low)]
    roofs = _court_roofs(rings)
    inner = [
        block((-w, w), (-d, -d + PARAPET), (0, high + 0.35)),
        block((-w, w), (d - PARAPET, d), (0, high + 0.35)),
    ]
    caps = [
        block(
            (-w - 0.1, w + 0.1),
            (s * (d - PARAPET / 2) - 0.25, s * (d - PARAPET / 2) + 0.25),
            (high + 0.35, high + 0.47),
        )
        for s in (-1, 1)
    ]
    for s in (-1, 1):
        at = (w - PARAPET, w) if s > 0 else (-w, -w + PARAPET)
        wall, copings = stepped_gable((-d, d), at, high - 0.2, size.height - 0.14, "x", 3)
        inner.append(wall)
        caps += copings
    yard = [block((-court_x, court_x), (-court_y, court_y), (0, YARD))]
    wood = [
        block(
            (-court_x - 0.15, court_x + 0.15),
            (s * court_y - 0.08, s * court_y + 0.08),
            (0, low - 0.1),
        )
        for s in (-1, 1)
    ] + [
        block((x - 0.08, x + 0.08), (-court_y, court_y), (0, low - 0.1))
        for x in (-court_x, court_x)
    ]
    outline = ((-w, -d), (w, -d), (w, d), (-w, d))
    shown = openings(outline, high, look.windows)
    shown.stones.extend(yard)
    shown.doors.extend(wood)
    return _parts(size, look, inner, [*roofs, *caps], shown, [])


def court_heights(size: Size) -> tuple[float, float, float, float]:
    """Half the width and depth of a court, and the heights of the roofs over it and outside."""
    court_x, court_y = 0.15 * size.width, 0.15 * size.depth
    low = 0.55 * size.height
    return court_x, court_y, low, low + min(0.5 * (size.depth / 2 - court_y), 0.28 * size.height)


def _court_roofs(rings: list[tuple[float, float, float]]) -> list[Mesh]:
    """Four slopes between an outer and an inner rectangle, each a closed slab."""
    corners = [np.array([(-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z)]) for x, y, z in rings]
    made = []
    for k in range(4):
        after = (k + 1) % 4
        quad = np.array([corners[0][k], corners[0][after], corners[1][after], corners[1][k]])
        vertices = np.concatenate([quad - (0, 0, 0.15), quad])
        base = extrude([(0, 0), (1, 0), (1, 1), (0, 1)], 0.0, 1.0)
        made.append(Mesh(vertices, base.faces))
    return made


def _gate(area: float, outline: Footprint) -> float:
    """The width of the gate of a shed; 0 of a house."""
    if area >= SHED:
        return 0.0
    return min(2.4, 0.6 * float(np.ptp(np.array(outline)[:, 0])))


def _parts(
    size: Size,
    look: HouseLook,
    walls: list[Mesh],
    roofs: list[Mesh],
    shown: WallOpenings,
    stack: list[Mesh],
) -> Parts:
    wall = pick(size, look.walls)
    meshes: dict[Material, list[Mesh]] = {wall: list(walls)}
    frame = LIMESTONE if wall is not PLASTER else STONE
    wood = WALNUT if wall is PLASTER else TIMBER
    rows = (
        (look.roof, roofs),
        (PANE, shown.panes),
        (WHITE if frame is LIMESTONE else STONE, shown.frames),
        (look.shutters, shown.shutters),
        (wood, shown.doors),
        (STONE, shown.stones),
        (BRICK, stack),
    )
    for material, found in rows:
        meshes.setdefault(material, []).extend(found)
    return parts(size, meshes)


def _drawing(style: str, roof: str, name: str) -> Drawing:
    build = partial(build_house, style=style, roof=roof)
    return Drawing(
        "house",
        lambda size: build(size, ()),
        plan(*(ridge(0.5) if roof == "hipped" else ridge(1.0)[:1] if roof == "gabled" else ())),
        f"house_{style}_{roof}",
        name,
        over=build,
    )


ASSETS = tuple(
    _drawing(style, roof, f"{style[:1].upper()}{style[1:]} house, {roof}")
    for style in LOOKS
    for roof in ("gabled", "hipped", "flat")
)
