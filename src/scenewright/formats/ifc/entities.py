"""The parts IFC models are made of: identifiers, placements, profiles, bodies, properties.

Everything takes the open model first and answers with an entity of it. Metres, z up.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple
from uuid import NAMESPACE_URL, uuid5

import numpy as np

from scenewright.core.catalog import Material, Part
from scenewright.core.scene import Prism
from scenewright.core.space import Points

Entity = Any
"""An entity of ifcopenshell, which has no types of its own."""
DIGITS = 5
"""Decimals of a metre in coordinates."""
_LETTERS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$"


class Model(NamedTuple):
    """An open model: the ``file``, the context of bodies, and the ``styles`` made so far."""

    file: Any
    body: Entity
    styles: dict[Material, Entity]


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
    guid = make_guid(f"{kind}:{key or name}")
    return model.file.create_entity(kind, GlobalId=guid, Name=name or None, **attributes)


def point(model: Model, *values: float) -> Entity:
    """A point in plan or in space."""
    return model.file.create_entity(
        "IfcCartesianPoint", Coordinates=tuple(round(float(v), DIGITS) for v in values)
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
        Depth=round(float(height), DIGITS),
    )


def extrude_prism(model: Model, prism: Prism) -> Entity:
    """A prism of a wall; one under a slope ends level at its highest."""
    return extrude(model, prism.outline, prism.base, prism.top - prism.base, prism.holes)


def shape(model: Model, bodies: Sequence[Entity], kind: str) -> Entity:
    """The body of a product from solids (``SweptSolid``), meshes (``Tessellation``) or a map."""
    body = model.file.create_entity(
        "IfcShapeRepresentation",
        ContextOfItems=model.body,
        RepresentationIdentifier="Body",
        RepresentationType=kind,
        Items=list(bodies),
    )
    return model.file.create_entity("IfcProductDefinitionShape", Representations=[body])


def mesh(model: Model, part: Part) -> Entity:
    """The triangles of a part, in its colour."""
    points = model.file.create_entity(
        "IfcCartesianPointList3D", CoordList=np.round(part.vertices, DIGITS).tolist()
    )
    faces = model.file.create_entity(
        "IfcTriangulatedFaceSet",
        Coordinates=points,
        Closed=None,
        CoordIndex=(part.faces + 1).tolist(),
    )
    paint(model, faces, part.material)
    return faces


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
    return make("IfcSurfaceStyle", Name=material.name, Side="BOTH", Styles=[rendering])


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
