"""Pieces in the rooms of a building model, as fixed items of a brief."""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely

from scenewright.catalog.models.furniture import meanings, nearest
from scenewright.catalog.models.words import match
from scenewright.core.brief.fields import FURNITURE
from scenewright.core.scene import Size
from scenewright.formats.ifc.furniture import CLASSES

BUILT_IN = (
    "IfcColumn",
    "IfcStair",
    "IfcSanitaryTerminal",
    "IfcFlowTerminal",
    "IfcSpaceHeater",
    "IfcEnergyConversionDevice",
)
MOVABLE = (
    "IfcFurniture",
    "IfcFurnishingElement",
    "IfcSystemFurnitureElement",
    "IfcElectricAppliance",
    "IfcAudioVisualAppliance",
    "IfcLightFixture",
)
OF_ENTITY = {"IfcColumn": "column", "IfcStair": "staircase", "IfcSpaceHeater": "radiator"}
"""Categories that follow from the entity alone."""
LEAST = 0.02
"""Sides in metres below which a thing is drawn as thick as this."""


def category_of(row: dict[str, Any], size: Size) -> str:
    """The kind of furniture a product is, by its entity, its type, the words of its name and,
    where these mean several, its size."""
    if row["kind"] in OF_ENTITY:
        return OF_ENTITY[row["kind"]]
    if row["use"] in CLASSES:
        return str(row["use"])
    family = row["name"].partition(":")[0]  # Revit: family:type:number
    found = match(family) or match(f"{row['name']} {row['use']}")
    kinds = tuple(one for kind in (found.kinds if found else ()) for one in meanings(kind))
    return nearest(kinds, size)[0] if kinds else "obstacle"


def fixed_item(row: dict[str, Any], box: shapely.Polygon, floor: float) -> dict[str, Any] | None:
    """A product as a fixed item with the box of its footprint, its front along its heading;
    ``None`` where it is larger than furniture."""
    heading = row["heading"] + np.pi / 2
    width, depth, middle = _measure(box, heading)
    height = max(row["high"] - row["low"], LEAST)
    if max(width, depth, height) > FURNITURE:
        return None
    return {
        "category": category_of(row, Size(width, depth, height)),
        "at": [round(float(v), 5) for v in middle],
        "heading": round(float(np.arctan2(np.sin(heading), np.cos(heading))), 6),
        "size": [round(max(v, LEAST), 4) for v in (width, depth, height)],
        "z": round(max(row["low"] - floor, 0.0), 4),
        "name": row["name"][:80],
    }


def _measure(box: shapely.Polygon, heading: float) -> tuple[float, float, np.ndarray]:
    """Width, depth and middle of a footprint seen along a heading."""
    front = np.array([np.cos(heading), np.sin(heading)])
    side = np.array([front[1], -front[0]])
    points = shapely.get_coordinates(box)
    across, along = points @ side, points @ front
    middle = side * (across.min() + across.max()) / 2 + front * (along.min() + along.max()) / 2
    return float(np.ptp(across)), float(np.ptp(along)), middle
