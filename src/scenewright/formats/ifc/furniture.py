"""Furniture, appliances, sanitary ware, lamps and buildings: one type with one mesh a model and
size, mapped to every place it stands."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from typing import NamedTuple

from scenewright.formats.ifc.entities import (
    Entity,
    Model,
    add_properties,
    axes,
    mesh,
    name_material,
    point,
    represent,
    root,
    shape,
)
from scenewright.render.items import RenderItem


class ProductClass(NamedTuple):
    """How IFC calls a product: the entity, and the predefined type of it and of its type."""

    entity: str
    predefined: str


class Standing(NamedTuple):
    """Where a product is: the space or storey that holds it, and its placement."""

    holder: Entity
    placement: Entity


FURNITURE = ProductClass("IfcFurniture", "NOTDEFINED")
_OLD = {
    "IfcFurniture": "IfcFurnishingElement",
    "IfcSanitaryTerminal": "IfcFlowTerminal",
    "IfcElectricAppliance": "IfcFlowTerminal",
    "IfcAudioVisualAppliance": "IfcFlowTerminal",
    "IfcLightFixture": "IfcFlowTerminal",
    "IfcSpaceHeater": "IfcEnergyConversionDevice",
}
"""IFC2x3 classes of products whose types alone it knows, by their names in IFC4."""
_CATEGORIES: dict[tuple[str, str], str] = {
    (
        "IfcFurniture",
        "CHAIR",
    ): "armchair auditorium_seat bar_stool bench deck_chair dining_chair pew "
    "lounge_seat office_chair outdoor_chair pouf reading_chair site_bench stool",
    ("IfcFurniture", "SOFA"): "sofa corner_sofa loveseat",
    ("IfcFurniture", "TABLE"): "coffee_table console_table dining_table display_table "
    "interactive_table nightstand outdoor_table reading_table round_table side_table vanity",
    ("IfcFurniture", "DESK"): "desk corner_desk kids_desk info_desk",
    ("IfcFurniture", "BED"): "single_bed double_bed bunk_bed cot",
    ("IfcFurniture", "SHELF"): "bookcase gondola ring_shelf shelf_unit storage_shelf wall_shelf "
    "wall_shelving",
    ("IfcSanitaryTerminal", "TOILETPAN"): "toilet",
    ("IfcSanitaryTerminal", "BATH"): "bathtub",
    ("IfcSanitaryTerminal", "SHOWER"): "shower wall_shower",
    ("IfcSanitaryTerminal", "WASHHANDBASIN"): "basin pedestal_basin",
    ("IfcElectricAppliance", "REFRIGERATOR"): "fridge fridge_shelf",
    ("IfcElectricAppliance", "WASHINGMACHINE"): "washing_machine",
    ("IfcElectricAppliance", "TUMBLEDRYER"): "dryer",
    ("IfcElectricAppliance", "DISHWASHER"): "dishwasher",
    ("IfcElectricAppliance", "VENDINGMACHINE"): "vending_machine",
    ("IfcElectricAppliance", "NOTDEFINED"): "cash_machine copier ticket_machine",
    ("IfcAudioVisualAppliance", "DISPLAY"): "monitor screen tv",
    ("IfcAudioVisualAppliance", "SPEAKER"): "speaker",
    ("IfcLightFixture", "NOTDEFINED"): "ceiling_lamp desk_lamp floor_lamp lamp_post pendant_lamp "
    "table_lamp wall_lamp",
    ("IfcSpaceHeater", "RADIATOR"): "radiator towel_rail",
    ("IfcColumn", "COLUMN"): "column",
    ("IfcBuildingElementProxy", "COMPLEX"): "building house",
    ("IfcWall", "PARTITIONING"): "partition",
}
CLASSES = {
    category: ProductClass(*row) for row, names in _CATEGORIES.items() for category in names.split()
}
"""Classes of categories; any other is furniture without a type of its own."""


def add_furniture(
    model: Model, found: Sequence[RenderItem], standing: Callable[[RenderItem], Standing], key: str
) -> list[tuple[Entity, list[Entity]]]:
    """Pairs of a space (or storey) and the products that stand in it. ``standing`` places an item;
    identifiers of types follow from ``key``."""
    types: dict[Hashable, tuple[Entity, Entity]] = {}
    members: dict[Hashable, list[Entity]] = {}
    inside: dict[int, list[Entity]] = {}
    holders: dict[int, Entity] = {}
    for item in found:
        alike: Hashable = (item.extras.get("category"), item.key)
        if alike not in types:
            types[alike] = _type(model, item, f"{key} {len(types)}")
        spot = standing(item)
        product = _product(model, spot.placement, item, types[alike][1])
        members.setdefault(alike, []).append(product)
        holders[spot.holder.id()] = spot.holder
        inside.setdefault(spot.holder.id(), []).append(product)
    for alike, products in members.items():
        _define(model, types[alike][0], products)
    return [(holders[number], products) for number, products in inside.items()]


def class_of(category: str) -> ProductClass:
    """The class of a category.

    >>> class_of("toilet").entity, class_of("whatnot").entity
    ('IfcSanitaryTerminal', 'IfcFurniture')
    """
    return CLASSES.get(category, FURNITURE)


def _type(model: Model, item: RenderItem, key: str) -> tuple[Entity, Entity]:
    """The type of a model and size, and the map of its mesh."""
    row = class_of(str(item.extras.get("category", "")))
    body = represent(model, [mesh(model, part) for part in item.parts], "Tessellation")
    drawn = model.file.create_entity(
        "IfcRepresentationMap", MappingOrigin=axes(model), MappedRepresentation=body
    )
    made = root(
        model,
        type_entity(model, row),
        str(item.extras.get("asset", item.extras.get("category", item.name))),
        key=key,
        RepresentationMaps=[drawn],
        PredefinedType=row.predefined,
        AssemblyPlace="NOTDEFINED",
    )
    for name in dict.fromkeys(part.material.name for part in item.parts[:1]):
        name_material(model, [made], name)
    return made, drawn


def type_entity(model: Model, row: ProductClass) -> str:
    """The entity of the type of a class; IFC2x3 has none for what shows pictures or plays sound."""
    if model.old and row.entity == "IfcAudioVisualAppliance":
        return "IfcElectricApplianceType"
    return f"{row.entity}Type"


def _product(model: Model, placement: Entity, item: RenderItem, drawn: Entity) -> Entity:
    """One piece, where it stands."""
    row = class_of(str(item.extras.get("category", "")))
    target = model.file.create_entity(
        "IfcCartesianTransformationOperator3D", LocalOrigin=point(model, 0, 0, 0), Scale=1.0
    )
    mapped = model.file.create_entity("IfcMappedItem", MappingSource=drawn, MappingTarget=target)
    made = root(
        model,
        _OLD.get(row.entity, row.entity) if model.old else row.entity,
        item.name,
        key=f"{item.level} {item.name}",
        ObjectType=str(item.extras.get("category", "")) or None,
        ObjectPlacement=placement,
        Representation=shape(model, [mapped], "MappedRepresentation"),
        PredefinedType=row.predefined,
    )
    facts = {
        name.capitalize(): item.extras.get(name, "")
        for name in ("category", "group", "function", "space", "licence", "author")
    }
    add_properties(model, made, "Scenewright_Piece", facts)
    return made


def _define(model: Model, kind: Entity, products: Sequence[Entity]) -> None:
    root(
        model,
        "IfcRelDefinesByType",
        "",
        key=kind.GlobalId,
        RelatedObjects=list(products),
        RelatingType=kind,
    )
