"""A small building model of somebody else: millimetres, a turned storey far from the origin."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import ifcopenshell
import ifcopenshell.guid

FAR = (3_470_000.0, 5_430_000.0)
"""Where the site is, in metres."""
BOX = ((0, 0), (5000, 0), (5000, 4000), (0, 4000), (0, 0))


def write_model(path: Path, schema: str, furniture: bool = False) -> None:
    """One storey, turned by a quarter, with one room of 5 by 4 m, and a chair if asked for."""
    file = ifcopenshell.file(schema=schema)
    make = file.create_entity
    maker = make("IfcOrganization", Name="Office")
    user = make("IfcPersonAndOrganization", make("IfcPerson", FamilyName="Draughtsman"), maker)
    tool = make("IfcApplication", maker, "1", "CAD", "CAD")
    owner = make("IfcOwnerHistory", user, tool, ChangeAction="ADDED", CreationDate=0)

    def root(kind: str, name: str, **more: Any) -> Any:
        guid = ifcopenshell.guid.compress(f"{len(list(file)):032x}")
        return make(kind, GlobalId=guid, OwnerHistory=owner, Name=name, **more)

    def point(*values: float) -> Any:
        return make("IfcCartesianPoint", tuple(map(float, values)))

    def axes(at: tuple[float, ...], along: tuple[float, ...] = (1, 0, 0)) -> Any:
        turned = (make("IfcDirection", tuple(map(float, one))) for one in ((0, 0, 1), along))
        return make("IfcAxis2Placement3D", point(*at), *turned)

    def placed(within: Any, at: tuple[float, ...], along: tuple[float, ...] = (1, 0, 0)) -> Any:
        return make("IfcLocalPlacement", within, axes(at, along))

    context = make("IfcGeometricRepresentationContext", None, "Model", 3, 1e-5, axes((0, 0, 0)))
    kinds = (("LENGTHUNIT", "MILLI", "METRE"), ("AREAUNIT", None, "SQUARE_METRE"))
    units = [make("IfcSIUnit", None, *kind) for kind in kinds]
    assigned = make("IfcUnitAssignment", units)
    project = root("IfcProject", "P", RepresentationContexts=[context], UnitsInContext=assigned)
    site = root("IfcSite", "Plot", ObjectPlacement=placed(None, (FAR[0] * 1e3, FAR[1] * 1e3, 0)))
    house = root("IfcBuilding", "House", ObjectPlacement=placed(site.ObjectPlacement, (0, 0, 0)))
    turned = placed(house.ObjectPlacement, (0, 0, 3000), (0, 1, 0))
    storey = root("IfcBuildingStorey", "Upper floor", ObjectPlacement=turned, Elevation=3000.0)

    def body(height: float) -> Any:
        line = make("IfcPolyline", [point(*corner) for corner in BOX])
        area = make("IfcArbitraryClosedProfileDef", "AREA", None, line)
        up = make("IfcDirection", (0.0, 0.0, 1.0))
        solid = make("IfcExtrudedAreaSolid", area, axes((0, 0, 0)), up, height)
        shape = make("IfcShapeRepresentation", context, "Body", "SweptSolid", [solid])
        return make("IfcProductDefinitionShape", Representations=[shape])

    space = root(
        "IfcSpace",
        "1",
        LongName="Wohnen \N{LATIN SMALL LETTER A WITH DIAERESIS}",
        ObjectPlacement=placed(turned, (1000, 0, 100)),
        Representation=body(2600.0),
        CompositionType="ELEMENT",
    )
    for whole, part in ((project, site), (site, house), (house, storey), (storey, space)):
        root("IfcRelAggregates", "", RelatingObject=whole, RelatedObjects=[part])
    if furniture:
        kind = "IfcFurnishingElement" if schema == "IFC2X3" else "IfcFurniture"
        chair = root(kind, "Chair", ObjectPlacement=placed(space.ObjectPlacement, (2000, 2000, 0)))
        root(
            "IfcRelContainedInSpatialStructure",
            "",
            RelatedElements=[chair],
            RelatingStructure=space,
        )
    file.write(str(path))
