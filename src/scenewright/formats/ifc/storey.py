"""The shell of a storey: spaces, walls with the openings doors and windows fill, slab, stairs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import shapely

from scenewright.core.scene import Scene, Wall
from scenewright.core.space import Level, Opening, Points, Space
from scenewright.formats.ifc.entities import (
    Entity,
    Model,
    add_properties,
    add_quantities,
    extrude,
    extrude_prism,
    mesh,
    name_material,
    place,
    root,
    shape,
)
from scenewright.render.items import RenderItem

CLEAR = 0.02
"""Metres by which the body of an opening reaches beyond both faces of its wall."""
OPERATIONS = {
    (-1, 1): "SINGLE_SWING_LEFT",
    (1, 1): "SINGLE_SWING_RIGHT",
    (-1, -1): "SINGLE_SWING_LEFT",
    (1, -1): "SINGLE_SWING_RIGHT",
}
KINDS = {"slab": "IfcSlab", "stairs": "IfcStair", "surface": "IfcGeographicElement"}


def add_shell(
    model: Model, storey: Entity, level: Level, scene: Scene, found: Sequence[RenderItem]
) -> tuple[dict[str, Entity], list[Entity]]:
    """The spaces of a storey by id, and all its elements but furniture."""
    spaces = {s.id: _space(model, storey, s) for s in scene.spaces if s.level == level.id}
    openings = [o for o in scene.openings if o.level == level.id]
    walls = [wall for wall in scene.walls if wall.level == level.id and wall.prisms]
    made = _walls(model, storey, walls, openings)
    elements = list(made.values())
    if elements:
        name_material(model, elements, "masonry")
    looks = {item.name: item for item in found if item.kind == "opening"}
    for opening in openings:
        elements += _fill(model, storey, opening, _pierced(opening, walls), made, looks)
    for item in found:
        if item.kind in KINDS and item.parts:
            elements.append(_meshed(model, storey, item, KINDS[item.kind]))
    return spaces, elements


def _space(model: Model, storey: Entity, space: Space) -> Entity:
    """A room with its floor area and what it is for."""
    body = extrude(model, space.outline, 0.0, space.height, space.holes)
    made = root(
        model,
        "IfcSpace",
        space.id,
        key=f"space {space.id}",
        LongName=space.name or None,
        ObjectType=", ".join(space.functions) or None,
        ObjectPlacement=place(model, storey.ObjectPlacement),
        Representation=shape(model, [body], "SweptSolid"),
        CompositionType="ELEMENT",
        PredefinedType="INTERNAL",
    )
    floor = shapely.Polygon(space.outline, space.holes)
    area, around = floor.area, floor.exterior.length
    lengths = {"Height": space.height, "NetPerimeter": around}
    areas = {"NetFloorArea": area, "GrossFloorArea": area}
    add_quantities(model, made, "Qto_SpaceBaseQuantities", lengths, areas)
    uses = {"Reference": space.id, "IsExternal": "balcony" in space.functions}
    add_properties(model, made, "Pset_SpaceCommon", uses)
    add_properties(model, made, "Scenewright_Space", {"Use": ", ".join(space.functions)})
    return made


def rectangle(opening: Opening, beyond: float = 0.0) -> Points:
    """The corners ``(4, 2)`` of an opening in plan, from ``beyond`` both faces of its wall."""
    along = np.array([opening.ux, opening.uy]) * opening.width / 2
    across = np.array([-opening.uy, opening.ux]) * (opening.thickness / 2 + beyond)
    middle = np.array([opening.x, opening.y])
    return np.array(
        [
            middle - along - across,
            middle + along - across,
            middle + along + across,
            middle - along + across,
        ]
    )


def _pierced(opening: Opening, walls: Sequence[Wall]) -> tuple[Wall, ...]:
    """The walls an opening goes through, the one it is most in first."""
    hole = shapely.Polygon(rectangle(opening)).buffer(CLEAR)
    shares = [
        (max(shapely.Polygon(p.outline, p.holes).intersection(hole).area for p in wall.prisms), k)
        for k, wall in enumerate(walls)
    ]
    least = 0.3 * opening.width * CLEAR
    return tuple(walls[k] for share, k in sorted(shares, reverse=True) if share > least)


def _walls(
    model: Model, storey: Entity, walls: Sequence[Wall], openings: Sequence[Opening]
) -> dict[str, Entity]:
    """Walls by id. Their bodies are whole: what openings take of them is put back, and taken out
    by the opening elements."""
    holes: dict[str, list[Opening]] = {}
    for opening in openings:
        for wall in _pierced(opening, walls)[:1]:
            holes.setdefault(wall.id, []).append(opening)
    made = {}
    for wall in walls:
        bodies = [extrude_prism(model, prism) for prism in wall.prisms]
        bodies += [
            extrude(model, rectangle(o), o.sill, o.head - o.sill) for o in holes.get(wall.id, ())
        ]
        made[wall.id] = root(
            model,
            "IfcWall",
            wall.id,
            key=f"wall {wall.level} {wall.id}",
            ObjectPlacement=place(model, storey.ObjectPlacement),
            Representation=shape(model, bodies, "SweptSolid"),
            PredefinedType="NOTDEFINED",
        )
        add_properties(model, made[wall.id], "Pset_WallCommon", {"Reference": wall.id})
    return made


def _fill(
    model: Model,
    storey: Entity,
    opening: Opening,
    pierced: Sequence[Wall],
    walls: Mapping[str, Entity],
    looks: Mapping[str, RenderItem],
) -> list[Entity]:
    """The opening element of each wall an opening goes through, and the door or window in it."""
    holes = [_void(model, opening, walls[wall.id], k) for k, wall in enumerate(pierced)]
    look = looks.get(opening.id)
    if opening.kind == "passage":
        return []
    filling = _filling(model, storey, opening, look)
    if holes:
        root(
            model,
            "IfcRelFillsElement",
            "",
            key=f"{opening.level} {opening.id}",
            RelatingOpeningElement=holes[0],
            RelatedBuildingElement=filling,
        )
    return [filling]


def _void(model: Model, opening: Opening, wall: Entity, number: int) -> Entity:
    """The hole of an opening in one wall."""
    body = extrude(model, rectangle(opening, CLEAR), opening.sill, opening.head - opening.sill)
    key = f"{opening.level} {opening.id} {number}"
    hole = root(
        model,
        "IfcOpeningElement",
        opening.id,
        key=key,
        ObjectPlacement=place(model, wall.ObjectPlacement),
        Representation=shape(model, [body], "SweptSolid"),
        PredefinedType="OPENING",
    )
    root(
        model,
        "IfcRelVoidsElement",
        "",
        key=key,
        RelatingBuildingElement=wall,
        RelatedOpeningElement=hole,
    )
    return hole


def _filling(model: Model, storey: Entity, opening: Opening, look: RenderItem | None) -> Entity:
    """A door or window, drawn as in the scene."""
    door = opening.kind == "door"
    single = OPERATIONS.get((opening.hinge, opening.swing), "SLIDING_TO_LEFT")
    more = {"OperationType": single} if door else {"PartitioningType": "SINGLE_PANEL"}
    height = round(opening.head - opening.sill, 5)
    turn = float(np.arctan2(opening.uy, opening.ux))
    at = (opening.x, opening.y, 0.0)
    drawn = shape(model, [mesh(model, p) for p in look.parts], "Tessellation") if look else None
    made = root(
        model,
        "IfcDoor" if door else "IfcWindow",
        opening.id,
        key=f"{opening.level} {opening.id}",
        ObjectPlacement=place(model, storey.ObjectPlacement, at, turn),
        Representation=drawn if look and look.parts else None,
        OverallHeight=height,
        OverallWidth=round(opening.width, 5),
        PredefinedType="DOOR" if door else "WINDOW",
        **more,
    )
    outside = len(opening.spaces) < 2
    common = {"Reference": opening.id, "IsExternal": outside}
    add_properties(model, made, "Pset_DoorCommon" if door else "Pset_WindowCommon", common)
    facts = {"Sill": opening.sill, "Spaces": ", ".join(opening.spaces), "Use": opening.use}
    add_properties(model, made, "Scenewright_Opening", facts)
    return made


def _meshed(model: Model, storey: Entity, item: RenderItem, kind: str) -> Entity:
    """A slab, stairs or surface with the mesh of the scene."""
    types = {"IfcSlab": "FLOOR", "IfcStair": "NOTDEFINED", "IfcGeographicElement": "USERDEFINED"}
    more = {"ObjectType": str(item.extras.get("function", "surface"))}
    return root(
        model,
        kind,
        item.name,
        key=f"{item.level} {item.name}",
        ObjectPlacement=place(model, storey.ObjectPlacement, item.at, item.turn),
        Representation=shape(model, [mesh(model, part) for part in item.parts], "Tessellation"),
        PredefinedType=types[kind],
        **(more if types[kind] == "USERDEFINED" else {}),
    )
