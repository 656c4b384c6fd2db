"""The parts IFC models are made of: identifiers, placements, profiles, bodies, properties.

Everything takes the open model first and answers with an entity of it. Metres, z up; in the file
they become its unit, and attributes its schema does not have are left out.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple
from uuid import NAMESPACE_URL, uuid5

import numpy as np
from ifcopenshell import ifcopenshell_wrapper

from scenewright.core.catalog import Material, Part
from scenewright.core.scene import Prism
from scenewright.core.space import Points

Entity = Any
"""An entity of ifcopenshell, which has no types of its own."""
DIGITS = 5
"""Decimals of a metre in coordinates."""
_LETTERS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$"


class Model(NamedTuple):
    """An open model: the ``file``, the context of bodies, and the ``styles`` made so far; metres in
    its ``unit`` of length, the ``owner`` history of what is made, and what is put before names
    that identifiers follow from."""

    file: Any
    body: Entity
    styles: dict[Material, Entity]
    unit: float = 1.0
    owner: Entity = None
    salt: str = ""

    @property
    def old(self) -> bool:
        """Whether the schema is IFC2x3, which has no triangulated faces."""
        return str(self.file.schema) == "IFC2X3"


def make_guid(name: str) -> str:
    """The identifier of IFC (22 letters of base 64) that follows from a name.

    >>> make_guid("living/sofa") == make_guid("living/sofa"), len(make_guid("x"))
    (True, 22)
    """
    number, letters = uuid5(NAMESPACE_URL, f"scenewright:{name}").int, ""
    for _ in range(22):
        number, rest = divmod(number, 64)
        letters = _LETTERS[rest] + letters
    return letters


def root(model: Model, kind: str, name: str, /, key: str = "", **attributes: Any) -> Entity:
    """An entity with an identifier that follows from its kind and ``key`` (its name)."""
    guid = make_guid(f"{model.salt}{kind}:{key or name}")
    given = {"OwnerHistory": model.owner, "Name": name or None, **attributes}
    known = schema_attributes(str(model.file.schema_identifier), kind)
    held = {
        attribute: "NOTDEFINED" if known[attribute] and value not in known[attribute] else value
        for attribute, value in given.items()
        if attribute in known and value is not None
    }
    return model.file.create_entity(kind, GlobalId=guid, **held)


@cache
def schema_attributes(schema: str, kind: str) -> dict[str, tuple[str, ...]]:
    """The attributes of an entity in a schema, with their choices where these are few.

    >>> "PredefinedType" in schema_attributes("IFC2X3", "IfcFurnitureType")
    False
    """
    declared: Any = ifcopenshell_wrapper.schema_by_name(schema).declaration_by_name(kind)
    found = {}
    for attribute in declared.all_attributes():
        kind_of = attribute.type_of_attribute().as_named_type()
        choices = kind_of.declared_type().as_enumeration_type() if kind_of else None
        found[str(attribute.name())] = tuple(choices.enumeration_items()) if choices else ()
    return found


def point(model: Model, *values: float) -> Entity:
    """A point in plan or in space."""
    return model.file.create_entity(
        "IfcCartesianPoint", Coordinates=tuple(round(float(v) / model.unit, DIGITS) for v in values)
    )


def direction(model: Model, *values: float) -> Entity:
    """A direction, as it is given."""
    return model.file.create_entity(
        "IfcDirection", DirectionRatios=tuple(round(float(v), 9) for v in values)
    )


def axes(model: Model, at: Sequence[float] = (0, 0, 0), turn: float = 0.0) -> Entity:
    """A frame at a point, turned by ``turn`` radians about z."""
    return model.file.create_entity(
        "IfcAxis2Placement3D",
        Location=point(model, *at),
        Axis=direction(model, 0, 0, 1),
        RefDirection=direction(model, np.cos(turn), np.sin(turn), 0),
    )


def place(
    model: Model, within: Entity | None, at: Sequence[float] = (0, 0, 0), turn: float = 0.0
) -> Entity:
    """A placement relative to that of another product."""
    return model.file.create_entity(
        "IfcLocalPlacement", PlacementRelTo=within, RelativePlacement=axes(model, at, turn)
    )


def place_by(model: Model, within: Entity | None, matrix: np.ndarray) -> Entity:
    """A placement relative to that of another product by a matrix ``(4, 4)`` in metres."""
    frame = model.file.create_entity(
        "IfcAxis2Placement3D",
        Location=point(model, *matrix[:3, 3]),
        Axis=direction(model, *matrix[:3, 2]),
        RefDirection=direction(model, *matrix[:3, 0]),
    )
    return model.file.create_entity(
        "IfcLocalPlacement", PlacementRelTo=within, RelativePlacement=frame
    )


def ring(model: Model, outline: Points) -> Entity:
    """A closed line through corners ``(n, 2)``."""
    corners = [point(model, *corner) for corner in outline]
    return model.file.create_entity("IfcPolyline", Points=[*corners, corners[0]])


def extrude(
    model: Model, outline: Points, base: float, height: float, holes: Sequence[Points] = ()
) -> Entity:
    """A prism over a polygon, from ``base`` upwards."""
    kind = "IfcArbitraryProfileDefWithVoids" if holes else "IfcArbitraryClosedProfileDef"
    inner = {"InnerCurves": [ring(model, hole) for hole in holes]} if holes else {}
    profile = model.file.create_entity(
        kind, ProfileType="AREA", OuterCurve=ring(model, outline), **inner
    )
    return model.file.create_entity(
        "IfcExtrudedAreaSolid",
        SweptArea=profile,
        Position=axes(model, (0, 0, base)),
        ExtrudedDirection=direction(model, 0, 0, 1),
        Depth=round(float(height) / model.unit, DIGITS),
    )


def extrude_prism(model: Model, prism: Prism) -> Entity:
    """A prism of a wall; one under a slope ends level at its highest."""
    return extrude(model, prism.outline, prism.base, prism.top - prism.base, prism.holes)


def shape(model: Model, bodies: Sequence[Entity], kind: str) -> Entity:
    """The body of a product from solids (``SweptSolid``), meshes (``Tessellation``) or a map."""
    body = represent(model, bodies, kind)
    return model.file.create_entity("IfcProductDefinitionShape", Representations=[body])


def represent(model: Model, bodies: Sequence[Entity], kind: str) -> Entity:
    """Bodies as a representation of a kind; in IFC2x3 meshes are a ``SurfaceModel``."""
    return model.file.create_entity(
        "IfcShapeRepresentation",
        ContextOfItems=model.body,
        RepresentationIdentifier="Body",
        RepresentationType="SurfaceModel" if model.old and kind == "Tessellation" else kind,
        Items=list(bodies),
    )


def mesh(model: Model, part: Part) -> Entity:
    """The triangles of a part, in its colour."""
    faces = _old_faces(model, part) if model.old else _faces(model, part)
    paint(model, faces, part.material)
    return faces


def _faces(model: Model, part: Part) -> Entity:
    points = model.file.create_entity(
        "IfcCartesianPointList3D", CoordList=np.round(part.vertices / model.unit, DIGITS).tolist()
    )
    return model.file.create_entity(
        "IfcTriangulatedFaceSet",
        Coordinates=points,
        Closed=None,
        CoordIndex=(part.faces + 1).tolist(),
    )


def _old_faces(model: Model, part: Part) -> Entity:
    """Triangles as IFC2x3 knows them, one face each."""
    make = model.file.create_entity
    corners = [point(model, *corner) for corner in part.vertices.tolist()]
    loops = [make("IfcPolyLoop", [corners[k] for k in face]) for face in part.faces.tolist()]
    faces = [make("IfcFace", [make("IfcFaceOuterBound", loop, True)]) for loop in loops]
    return make("IfcFaceBasedSurfaceModel", [make("IfcConnectedFaceSet", faces)])


def paint(model: Model, body: Entity, material: Material) -> None:
    """Give a body the colour of a material."""
    if material not in model.styles:
        model.styles[material] = _style(model, material)
    model.file.create_entity("IfcStyledItem", Item=body, Styles=[model.styles[material]])


def _style(model: Model, material: Material) -> Entity:
    make = model.file.create_entity
    colour = make("IfcColourRgb", None, *(round(float(c), 4) for c in material.color))
    rendering = make(
        "IfcSurfaceStyleRendering",
        SurfaceColour=colour,
        Transparency=round(1.0 - float(material.opacity), 4),
        ReflectanceMethod="NOTDEFINED",
    )
    style = make("IfcSurfaceStyle", Name=material.name, Side="BOTH", Styles=[rendering])
    return make("IfcPresentationStyleAssignment", [style]) if model.old else style


def add_properties(model: Model, product: Entity, name: str, values: Mapping[str, Any]) -> None:
    """A property set of a product; numbers as reals, switches as booleans, else labels."""
    rows = [
        model.file.create_entity(
            "IfcPropertySingleValue", Name=key, NominalValue=_value(model, value)
        )
        for key, value in values.items()
        if value not in ("", None)
    ]
    if rows:
        key = f"{name}:{product.GlobalId}"
        group = root(model, "IfcPropertySet", name, key=key, HasProperties=rows)
        _define(model, product, group, key)


def add_quantities(
    model: Model,
    product: Entity,
    name: str,
    lengths: Mapping[str, float],
    areas: Mapping[str, float],
) -> None:
    """The quantities of a product: lengths in metres, areas in m²."""
    make = model.file.create_entity
    rows = [make("IfcQuantityLength", Name=k, LengthValue=round(v, 6)) for k, v in lengths.items()]
    rows += [make("IfcQuantityArea", Name=k, AreaValue=round(v, 6)) for k, v in areas.items()]
    key = f"{name}:{product.GlobalId}"
    group = root(model, "IfcElementQuantity", name, key=key, Quantities=rows)
    _define(model, product, group, key)


def _define(model: Model, product: Entity, group: Entity, key: str) -> None:
    root(
        model,
        "IfcRelDefinesByProperties",
        "",
        key=key,
        RelatedObjects=[product],
        RelatingPropertyDefinition=group,
    )


def _value(model: Model, value: Any) -> Entity:
    if isinstance(value, bool):
        return model.file.create_entity("IfcBoolean", value)
    if isinstance(value, (int, float)):
        return model.file.create_entity("IfcReal", float(value))
    return model.file.create_entity("IfcLabel", str(value)[:255])


def name_material(model: Model, products: Sequence[Entity], name: str) -> None:
    """Say what products are made of."""
    material = model.file.create_entity("IfcMaterial", Name=name)
    key = f"{name}:{products[0].GlobalId}"
    root(
        model,
        "IfcRelAssociatesMaterial",
        "",
        key=key,
        RelatedObjects=list(products),
        RelatingMaterial=material,
    )


def contain(model: Model, where: Entity, products: Sequence[Entity]) -> None:
    """Say that products stand in a storey or space."""
    root(
        model,
        "IfcRelContainedInSpatialStructure",
        "",
        key=where.GlobalId,
        RelatingStructure=where,
        RelatedElements=list(products),
    )
