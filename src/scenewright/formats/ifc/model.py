"""A scene as an IFC4 model: the project, its storeys, and the pieces in each."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import ifcopenshell

from scenewright._version import __version__
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Scene
from scenewright.core.space import Level
from scenewright.formats.ifc.entities import Entity, Model, axes, contain, direction, place, root
from scenewright.formats.ifc.furniture import Standing, add_furniture
from scenewright.formats.ifc.storey import add_shell
from scenewright.render.items import RenderItem, things

DAWN = "1970-01-01T00:00:00"
"""The time in the header: same solution, same bytes."""


def encode_scene(scene: Scene, catalog: Catalog) -> str:
    """The text of an IFC file."""
    text: str = make_model(scene, catalog).to_string()
    return text


def make_model(scene: Scene, catalog: Catalog) -> Any:
    """The open model of a scene, of ifcopenshell."""
    file = ifcopenshell.file(schema="IFC4")
    file.header.file_name.time_stamp = DAWN
    file.header.file_name.name = scene.name
    file.header.file_name.originating_system = f"Scenewright {__version__}"
    file.header.file_name.preprocessor_version = f"Scenewright {__version__}"
    file.header.file_description.description = ("ViewDefinition [DesignTransferView_V1.0]",)
    model, project = _open(file, scene.name or "home")
    site = root(model, "IfcSite", "site", ObjectPlacement=place(model, None))
    building = root(
        model,
        "IfcBuilding",
        scene.name or "home",
        ObjectPlacement=place(model, site.ObjectPlacement),
    )
    _aggregate(model, project, [site])
    _aggregate(model, site, [building])
    found = things(scene, catalog)
    storeys = [_storey(model, building, level, scene, found) for level in scene.levels]
    if storeys:
        _aggregate(model, building, storeys)
    return file


def _open(file: Any, name: str) -> tuple[Model, Entity]:
    """A model with its project, in metres and radians."""
    made = Model(file, None, {})
    context = file.create_entity(
        "IfcGeometricRepresentationContext",
        ContextType="Model",
        CoordinateSpaceDimension=3,
        Precision=1e-5,
        WorldCoordinateSystem=axes(made),
        TrueNorth=direction(made, 0, 1),
    )
    body = file.create_entity(
        "IfcGeometricRepresentationSubContext",
        ContextIdentifier="Body",
        ContextType="Model",
        ParentContext=context,
        TargetView="MODEL_VIEW",
    )
    kinds = (
        ("LENGTHUNIT", "METRE"),
        ("AREAUNIT", "SQUARE_METRE"),
        ("VOLUMEUNIT", "CUBIC_METRE"),
        ("PLANEANGLEUNIT", "RADIAN"),
    )
    units = [file.create_entity("IfcSIUnit", UnitType=kind, Name=unit) for kind, unit in kinds]
    model = Model(file, body, {})
    project = root(
        model,
        "IfcProject",
        name,
        RepresentationContexts=[context],
        UnitsInContext=file.create_entity("IfcUnitAssignment", Units=units),
    )
    return model, project


def _storey(
    model: Model, building: Entity, level: Level, scene: Scene, found: Sequence[RenderItem]
) -> Entity:
    """A storey with its spaces, walls, openings and furniture."""
    name = level.name or f"level {level.id or 1}"
    storey = root(
        model,
        "IfcBuildingStorey",
        name,
        key=f"level {level.id}",
        ObjectPlacement=place(model, building.ObjectPlacement, (0, 0, level.elevation)),
        Elevation=float(level.elevation),
    )
    mine = [item for item in found if item.level == level.id]
    spaces, elements = add_shell(model, storey, level, scene, mine)

    def stand(item: RenderItem) -> Standing:
        placement = place(model, storey.ObjectPlacement, item.at, item.turn)
        return Standing(spaces.get(item.space, storey), placement)

    pieces = [item for item in mine if item.kind == "piece"]
    inside = add_furniture(model, pieces, stand, storey.GlobalId)
    if spaces:
        _aggregate(model, storey, list(spaces.values()))
    for place_of, products in ((storey, elements), *inside):
        if products:
            contain(model, place_of, products)
    return storey


def _aggregate(model: Model, whole: Entity, parts: Sequence[Entity]) -> None:
    root(
        model,
        "IfcRelAggregates",
        "",
        key=whole.GlobalId,
        RelatingObject=whole,
        RelatedObjects=list(parts),
    )
