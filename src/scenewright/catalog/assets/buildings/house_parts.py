"""From the meshes of a house to its parts: which material each is of."""

from __future__ import annotations

from scenewright.catalog.assets.buildings.house_looks import HouseLook
from scenewright.catalog.assets.buildings.house_shapes import inset
from scenewright.catalog.assets.buildings.house_walls import FLOOR, WallOpenings
from scenewright.catalog.assets.materials import (
    BRICK,
    NAVY_LACQUER,
    PANE,
    SAGE,
    STONE,
    VELVET,
    WALNUT,
)
from scenewright.catalog.assets.model import Parts, parts, pick
from scenewright.core.catalog import Material
from scenewright.core.footprint import Footprint
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, extrude

SHOPS = (SAGE, NAVY_LACQUER, WALNUT, VELVET)
"""Colours of the fronts of shops."""
PLINTH, CLAD = 0.6, 0.02
"""Height of a base below a single storey, and how far it stands out, in metres."""


def join_parts(
    size: Size,
    look: HouseLook,
    outline: Footprint,
    eave: float,
    walls: list[Mesh],
    roofs: list[Mesh],
    shown: WallOpenings,
    stack: list[Mesh],
) -> Parts:
    """The parts of a house over the ``outline`` of its walls, one of the colours of its style."""
    meshes: dict[Material, list[Mesh]] = {pick(size, look.walls): list(walls)}
    base = list[Mesh]()
    if look.base is not None:
        high = FLOOR - 0.1 if eave > 1.5 * FLOOR else PLINTH
        base = [extrude(inset(outline, -CLAD), 0.0, high)]
    rows = (
        (look.base or STONE, base),
        (look.roof, roofs),
        (PANE, shown.panes),
        (look.trim, shown.frames),
        (look.shutters, shown.shutters),
        (look.wood, shown.doors),
        (STONE, shown.stones),
        (look.frame or look.wood, shown.beams),
        (look.wood, shown.woods),
        (pick(size, SHOPS), shown.shops),
        (BRICK if look.overhang else STONE, stack),
    )
    for material, found in rows:
        if found:
            meshes.setdefault(material, []).extend(found)
    return parts(size, meshes)
