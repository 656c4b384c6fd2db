"""The user's own model with furniture added and nothing else changed.

The file stays as it is, byte for byte; what is new is put behind its last entity, with relations of
its own: types with mapped meshes, pieces contained in the space (or storey) they stand in.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import ifcopenshell
import ifcopenshell.util.placement
import ifcopenshell.util.unit
import numpy as np

from scenewright._version import __version__
from scenewright.core.brief.source_file import SourceFile
from scenewright.core.catalog import Catalog
from scenewright.core.errors import InputError
from scenewright.core.scene import Scene
from scenewright.formats.ifc.entities import Entity, Model, contain, place_by
from scenewright.formats.ifc.furniture import Standing, add_furniture
from scenewright.render.items import RenderItem, things

NAME = "Scenewright"
_END = re.compile(rb"ENDSEC\s*;(?:\s|/\*.*?\*/)*END-ISO-10303-21\s*;", re.DOTALL)


def furnish(scene: Scene, catalog: Catalog, source: SourceFile, data: bytes) -> bytes:
    """The model ``data`` with the pieces of a scene that are not in it."""
    end = find_end(data)
    theirs = frozenset(source.items)
    pieces = tuple(piece for piece in scene.pieces if piece.id not in theirs)
    if not pieces:
        return data
    file = ifcopenshell.open(source.file)
    last = max(entity.id() for entity in file)
    bare = replace(scene, pieces=pieces, walls=(), openings=(), stairs=(), surfaces=())
    _add_pieces(_model(file, source.sha256), bare, catalog, source)
    made = sorted((entity for entity in file if entity.id() > last), key=lambda one: one.id())
    rows = [f"{entity.to_string(True)};" for entity in made]
    line = b"\r\n" if b"\r\n" in data[:4096] else b"\n"
    return data[:end] + b"".join(row.encode("ascii") + line for row in rows) + data[end:]


def find_end(data: bytes) -> int:
    """Where the entities of a model end; :class:`InputError` for one that is cut short."""
    found = list(_END.finditer(data, max(len(data) - 65536, 0)))
    if not found:
        raise InputError("the model it was read from has no end (ENDSEC)", "export it again")
    return found[-1].start()


def _model(file: Any, salt: str) -> Model:
    """The open model in its own unit, with what all that is new refers to."""
    contexts = file.by_type("IfcGeometricRepresentationContext")
    bodies = [one for one in contexts if one.ContextIdentifier == "Body"]
    solid = [one for one in contexts if one.ContextType == "Model"]
    if not contexts:
        raise InputError("the model it was read from has no context of shapes", "export it again")
    body = (bodies or solid or contexts)[0]
    unit = float(ifcopenshell.util.unit.calculate_unit_scale(file))
    owner = _owner(file) if file.schema == "IFC2X3" else None
    return Model(file, body, {}, unit, owner, f"{salt} ")


def _owner(file: Any) -> Entity:
    """Who made what is new, which IFC2x3 wants to know of everything."""
    make = file.create_entity
    known = [one for one in file.by_type("IfcApplication") if one.ApplicationIdentifier == NAME]
    maker = make("IfcOrganization", Name=NAME)
    program = known[0] if known else make("IfcApplication", maker, __version__, NAME, NAME)
    user = make("IfcPersonAndOrganization", make("IfcPerson", FamilyName=NAME), maker)
    return make(
        "IfcOwnerHistory",
        OwningUser=user,
        OwningApplication=program,
        ChangeAction="ADDED",
        CreationDate=0,
    )


def _add_pieces(model: Model, scene: Scene, catalog: Catalog, source: SourceFile) -> None:
    """Furniture with its types, and the relations that say what it stands in."""
    found = [item for item in things(scene, catalog) if item.kind == "piece"]
    heights = {level.id: level.elevation for level in scene.levels}

    def stand(item: RenderItem) -> Standing:
        holder = _holder(model, item, source)
        low = source.floors.get(item.space, heights.get(item.level, 0.0))
        return Standing(holder, place_by(model, *_placed(model, holder, item, source.offset, low)))

    for holder, products in add_furniture(model, found, stand, "furniture"):
        contain(model, holder, products)


def _holder(model: Model, item: RenderItem, source: SourceFile) -> Entity:
    """The space an item stands in, else the storey, else the building."""
    number = source.rooms.get(item.space) or source.levels.get(item.level)
    if number is not None:
        return model.file.by_id(number)
    wholes = (*model.file.by_type("IfcBuilding"), *model.file.by_type("IfcSite"))
    if not wholes:
        raise InputError("the model it was read from has no building", "export it again")
    return wholes[0]


def _placed(
    model: Model, holder: Entity, item: RenderItem, offset: Sequence[float], floor: float
) -> tuple[Entity | None, np.ndarray]:
    """The placement of a holder, and that of an item relative to it in metres ``(4, 4)``."""
    cos, sin, (x, y, z) = np.cos(item.turn), np.sin(item.turn), item.at
    world = np.eye(4)
    world[:2, :2] = [[cos, -sin], [sin, cos]]
    world[:3, 3] = x + offset[0], y + offset[1], z + floor
    frame = np.array(ifcopenshell.util.placement.get_local_placement(holder.ObjectPlacement))
    frame[:3, 3] *= model.unit
    return holder.ObjectPlacement, np.linalg.inv(frame) @ world
