"""What a reader of plans needs of an IFC file, as plain values; run as a program of its own.

The parser is compiled code that a damaged file can bring down: it works in a process apart, with a
limit of memory and time, and what it finds comes back as one JSON document on the standard output.

Each product is a dict: ``kind`` (its entity), ``id``, ``number`` (in the file), ``name``,
``long_name``, ``use`` (its object type), ``storey`` (an index, or -1), ``rings`` (the outline of
what it covers in plan and its holes), ``low`` and ``high`` (metres), ``heading``, ``hosted`` (a
door or window in a wall) and ``operation`` (of doors). Storeys are names and numbers, from below.
Metres in the file's own frame.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from typing import Any

import numpy as np
import shapely

MOST_PRODUCTS = 50_000
SHAPED = (
    "IfcSpace",
    "IfcWall",
    "IfcDoor",
    "IfcWindow",
    "IfcColumn",
    "IfcStair",
    "IfcOpeningElement",
)
"""Entities whose shape in plan is read, with their subtypes."""
STANDING = ("IfcFurnishingElement", "IfcFlowTerminal", "IfcEnergyConversionDevice")
"""What stands in rooms: read by its convex outline, and only where it is to stay."""
MOVABLE = (
    "IfcFurnishingElement",
    "IfcLightFixture",
    "IfcElectricAppliance",
    "IfcAudioVisualAppliance",
)
"""What is planned anew unless it is kept."""
TINY = 1e-7
MERGE = 0.002
"""Gap in metres between faces of one product that counts as none."""


def main() -> int:
    """Print the document of the file named on the command line, or ``{"fault": …}``; a second
    argument ``keep`` asks for the shapes of furniture too."""
    print(json.dumps(extract(sys.argv[1], "keep" in sys.argv[2:])))  # noqa: T201
    return 0


def extract(path: str, keep: bool = False) -> dict[str, Any]:
    """The document of a file."""
    import ifcopenshell

    try:
        file = ifcopenshell.open(path)
        if file is None:
            return {"fault": "is no IFC file that can be parsed"}
        return _document(file, keep)
    except (ifcopenshell.SchemaError, RuntimeError, OSError, ValueError, KeyError) as error:
        return {"fault": " ".join(str(error).split())[:200] or "cannot be parsed"}


def _document(file: Any, keep: bool) -> dict[str, Any]:
    import ifcopenshell.geom
    import ifcopenshell.util.element

    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    storeys = sorted(file.by_type("IfcBuildingStorey"), key=lambda s: float(s.Elevation or 0.0))
    numbers = {storey.id(): k for k, storey in enumerate(storeys)}
    products = [*file.by_type("IfcSpace"), *file.by_type("IfcElement")]
    products = [p for p in products if not p.is_a("IfcFeatureElement")]
    products += [p for p in file.by_type("IfcOpeningElement") if not p.HasFillings]
    if len(products) > MOST_PRODUCTS:
        return {"fault": f"holds {len(products):,} elements, more than {MOST_PRODUCTS:,}"}
    rows = [_product(p, settings, numbers, ifcopenshell.util.element, keep) for p in products]
    return {
        "schema": str(file.schema),
        "unit": _unit_name(file),
        "storeys": [{"name": s.Name or s.LongName or "", "number": s.id()} for s in storeys],
        "products": rows,
    }


def _unit_name(file: Any) -> str:
    for assignment in file.by_type("IfcUnitAssignment"):
        for unit in assignment.Units:
            if getattr(unit, "UnitType", "") == "LENGTHUNIT":
                words = (getattr(unit, "Prefix", None) or "", getattr(unit, "Name", None) or "")
                return "".join(words).lower()
    return ""


def _product(
    product: Any, settings: Any, storeys: dict[int, int], element: Any, keep: bool
) -> dict[str, Any]:
    row: dict[str, Any] = {
        "kind": product.is_a(),
        "id": product.GlobalId or f"#{product.id()}",
        "number": product.id(),
        "name": product.Name or "",
        "long_name": getattr(product, "LongName", None) or "",
        "use": product.ObjectType or "",
        "storey": storeys.get(_storey_of(product, element), -1),
        "operation": str(getattr(product, "OperationType", None) or ""),
        "rings": [],
    }
    stands = any(product.is_a(kind) for kind in STANDING)
    moves = any(product.is_a(kind) for kind in MOVABLE)
    if (stands and (keep or not moves)) or any(product.is_a(kind) for kind in SHAPED):
        row |= _shape(product, settings, hull=stands)
    return row


def _storey_of(product: Any, element: Any) -> int:
    """The storey a product is in, by containment or as a part of what is; 0 if none."""
    seen = 0
    while product is not None and seen < 20:
        if product.is_a("IfcBuildingStorey"):
            return int(product.id())
        product, seen = (
            element.get_container(product) or element.get_aggregate(product) or _host(product),
            seen + 1,
        )
    return 0


def _host(product: Any) -> Any:
    """The wall a door or window stands in, or an opening goes through."""
    for void in getattr(product, "VoidsElements", ()) or ():
        return void.RelatingBuildingElement
    for filled in getattr(product, "FillsVoids", ()) or ():
        for void in filled.RelatingOpeningElement.VoidsElements:
            return void.RelatingBuildingElement
    return None


def _shape(product: Any, settings: Any, hull: bool) -> dict[str, Any]:
    """What a product covers in plan, between which heights, and where its front looks."""
    import ifcopenshell.geom

    holes = [filled.RelatingOpeningElement for filled in getattr(product, "FillsVoids", ()) or ()]
    for part in (*holes[:1], product, *_parts(product)):
        try:
            made = ifcopenshell.geom.create_shape(settings, part)
        except (RuntimeError, ValueError):
            continue
        points = np.asarray(made.geometry.verts, float).reshape(-1, 3)
        faces = np.asarray(made.geometry.faces, int).reshape(-1, 3)
        if not len(faces) or not np.isfinite(points).all():
            continue
        return {
            "rings": [r.tolist() for r in (_hull(points) if hull else _rings(points, faces))],
            "low": float(points[:, 2].min()),
            "high": float(points[:, 2].max()),
            "heading": _turn(product),
            "hosted": bool(holes),
        }
    return {}


def _parts(product: Any) -> Iterator[Any]:
    for related in getattr(product, "IsDecomposedBy", ()) or ():
        yield from related.RelatedObjects


def _turn(product: Any) -> float:
    """The turn of a product's own x about z, in radians."""
    import ifcopenshell.util.placement

    matrix = ifcopenshell.util.placement.get_local_placement(product.ObjectPlacement)
    return float(np.arctan2(matrix[1, 0], matrix[0, 0]))


def _hull(points: np.ndarray) -> list[np.ndarray]:
    """The convex outline of points in plan."""
    found = shapely.convex_hull(shapely.multipoints(points[:, :2]))
    return [shapely.get_coordinates(found)[:-1].round(6)] if found.area > TINY else []


def _rings(points: np.ndarray, faces: np.ndarray) -> list[np.ndarray]:
    """Outline and holes of the largest region that the faces cover in plan."""
    flat = shapely.polygons(points[faces][:, :, :2])
    flat = flat[shapely.area(flat) > TINY]
    if not len(flat):
        return []
    region = shapely.union_all(shapely.buffer(flat, MERGE, join_style="mitre", mitre_limit=2.0))
    region = shapely.buffer(region, -MERGE, join_style="mitre", mitre_limit=2.0).simplify(1e-4)
    parts = [part for part in shapely.get_parts(region) if part.geom_type == "Polygon"]
    if not parts:
        return []
    largest = max(parts, key=lambda part: part.area)
    rings = (largest.exterior, *(r for r in largest.interiors if shapely.Polygon(r).area > 1e-3))
    return [shapely.get_coordinates(ring)[:-1].round(6) for ring in rings]


if __name__ == "__main__":
    sys.exit(main())
