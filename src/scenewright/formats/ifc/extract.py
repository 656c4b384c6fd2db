"""What a reader of plans needs of an IFC file, as plain values; run in a process of its own.

Each product is a dict: ``kind`` (its entity), ``id``, ``number`` (in the file), ``name``,
``long_name``, ``use`` (its object type), ``uses`` (by property sets and classes), ``storey`` (an
index, or -1), ``rings`` (the outline of what it covers in plan and its holes), ``low`` and ``high``
(metres), ``heading``, ``hosted`` (a door or window in a wall) and ``operation`` (of doors, or the
type of a space). Storeys are names and numbers, from below. Metres in the file's own frame.
"""

from __future__ import annotations

import re
import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.core.errors import InputError
from scenewright.formats.ifc.corners import Known, corners_of

GREATEST_FILE = 256 * 2**20
"""Bytes above which a model is not read."""
HEAD = 65536
SCHEMA = re.compile(rb"FILE_SCHEMA\s*\(\s*\(\s*'([^']*)'")
EARLIER = ("IFC2X", "IFC2X_FINAL", "IFC2X2", "IFC2X2_FINAL")
"""Schemas that are read as IFC2x3, which has their entities of buildings as they were."""
MOST_PRODUCTS = 50_000
SHAPED = (
    "IfcSpace",
    "IfcWall",
    "IfcDoor",
    "IfcWindow",
    "IfcColumn",
    "IfcStair",
    "IfcCurtainWall",
    "IfcOpeningElement",
)
"""Entities whose shape in plan is read, with their subtypes."""
STANDING = ("IfcFurnishingElement", "IfcFlowTerminal", "IfcEnergyConversionDevice")
"""Classes of products in rooms: read by their convex outline, and only where they stay."""
MOVABLE = (
    "IfcFurnishingElement",
    "IfcLightFixture",
    "IfcElectricAppliance",
    "IfcAudioVisualAppliance",
)
"""Classes that are planned anew unless kept."""
TINY = 1e-7
MERGE = 0.002
"""Gap in metres between faces of one product that counts as none."""
APART = 0.05
"""The same between the panes and posts of a curtain wall."""
USES = {
    *("occupancytype", "category description", "omniclass table 13 category", "use", "usage"),
    *("function", "room function", "room type", "roomtype", "space type", "spacetype"),
    *("nutzung", "nutzungsart", "raumnutzung", "raumtyp", "raumfunktion"),
}
"""Properties that say what a space is for."""


class Surface(NamedTuple):
    """Triangles in space: ``points (n, 3)`` in metres, ``faces (m, 3)``."""

    points: np.ndarray
    faces: np.ndarray


class Drawing(NamedTuple):
    """How bodies are drawn: settings of the kernel, metres a unit of the file, and the corners of
    shapes that stand in several places, by number."""

    settings: Any
    unit: float
    known: Known


def extract(path: str, keep: bool = False) -> dict[str, Any]:
    """The document of a file; ``keep`` asks for the shapes of furniture too. Raises
    :class:`InputError` for what is no model."""
    import ifcopenshell

    data = _content(Path(path))
    named = SCHEMA.search(data, 0, HEAD)
    schema = named[1].decode("ascii", "replace") if named else ""
    try:
        if schema.upper() in EARLIER:
            data = data[: named.start(1)] + b"IFC2X3" + data[named.end(1) :] if named else data
        file = ifcopenshell.file.from_string(data.decode("latin-1"))
        file.by_type("IfcProject")
    except (ifcopenshell.Error, RuntimeError, ValueError, KeyError) as error:
        reason = " ".join(str(error).split())[:120] or f"its schema is {schema or 'not stated'}"
        fault = f"cannot be read as IFC: {reason}"
        raise InputError(fault, "export it as IFC2x3 or IFC4 (STEP)") from None
    return _document(file, keep) | {"schema": schema}


def _content(path: Path) -> bytes:
    """The STEP text of a model, out of its archive if it is in one."""
    data = path.read_bytes()
    if data.startswith(b"PK"):
        try:
            data = _unzip(path)
        except (zipfile.BadZipFile, zlib.error, NotImplementedError, RuntimeError) as error:
            reason = " ".join(str(error).split())[:80]
            fault = f"is an archive that cannot be unpacked ({reason})"
            raise InputError(fault, "give the .ifc in it") from None
    check_head(data[:HEAD])
    return data


def check_head(head: bytes) -> None:
    """Raise :class:`InputError` for what does not begin as a model or an archive does."""
    if not head.lstrip(b"\xef\xbb\xbf \r\n\t").startswith((b"ISO-10303-21", b"PK")):
        raise InputError("is no IFC text file (STEP)", "export it as .ifc, not as XML")


def _unzip(path: Path) -> bytes:
    """The one model in an archive."""
    with zipfile.ZipFile(path) as archive:
        models = [one for one in archive.infolist() if one.filename.lower().endswith(".ifc")]
        if len(models) != 1 or models[0].file_size > GREATEST_FILE:
            raise InputError(f"is an archive of {len(models)} models", "give one .ifc in it")
        with archive.open(models[0]) as file:
            return file.read(GREATEST_FILE)


def _document(file: Any, keep: bool) -> dict[str, Any]:
    import ifcopenshell.geom
    import ifcopenshell.util.element
    import ifcopenshell.util.unit

    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    storeys = sorted(file.by_type("IfcBuildingStorey"), key=lambda s: float(s.Elevation or 0.0))
    numbers = {storey.id(): k for k, storey in enumerate(storeys)}
    products = [*file.by_type("IfcSpace"), *file.by_type("IfcElement")]
    products = [p for p in products if not p.is_a("IfcFeatureElement")]
    products += [p for p in file.by_type("IfcOpeningElement") if not p.HasFillings]
    if len(products) > MOST_PRODUCTS:
        fault = f"holds {len(products):,} elements, more than {MOST_PRODUCTS:,}"
        raise InputError(fault, "export one building, or one storey")
    draw = Drawing(settings, ifcopenshell.util.unit.calculate_unit_scale(file), {})
    rows = [_product(p, draw, numbers, ifcopenshell.util.element, keep) for p in products]
    return {
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
    product: Any, draw: Drawing, storeys: dict[int, int], element: Any, keep: bool
) -> dict[str, Any]:
    row: dict[str, Any] = {
        "kind": product.is_a(),
        "id": product.GlobalId or f"#{product.id()}",
        "number": product.id(),
        "name": product.Name or "",
        "long_name": getattr(product, "LongName", None) or "",
        "use": product.ObjectType or "",
        "uses": _uses(product, element),
        "storey": storeys.get(_storey_of(product, element), -1),
        "operation": _operation(product),
        "rings": [],
    }
    stands = any(product.is_a(kind) for kind in STANDING)
    moves = any(product.is_a(kind) for kind in MOVABLE)
    if (stands and (keep or not moves)) or any(product.is_a(kind) for kind in SHAPED):
        row |= _hull_of(product, draw) if stands else _shape(product, draw.settings, hull=False)
    return row


def _operation(product: Any) -> str:
    """How a door opens, or the type of a space."""
    name = "PredefinedType" if product.is_a("IfcSpace") else "OperationType"
    return str(getattr(product, name, None) or "")


def _uses(product: Any, element: Any) -> list[str]:
    """The function of a space by its property sets and classes."""
    if not product.is_a("IfcSpace"):
        return []
    sets = element.get_psets(product, psets_only=True).values()
    found = [v for group in sets for key, v in group.items() if key.casefold().strip() in USES]
    for link in getattr(product, "HasAssociations", ()) or ():
        if link.is_a("IfcRelAssociatesClassification"):
            found.append(getattr(link.RelatingClassification, "Name", None))
    return [text[:200] for text in found if isinstance(text, str) and text.strip()]


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


def _hull_of(product: Any, draw: Drawing) -> dict[str, Any]:
    """The same of products in rooms, by their convex outline."""
    points = corners_of(product, draw.known)
    if points is None:
        return _shape(product, draw.settings, hull=True)
    return _solid(product, points * draw.unit, _hull(points * draw.unit), hosted=False)


def _shape(product: Any, settings: Any, hull: bool) -> dict[str, Any]:
    """What a product covers in plan, between which heights, and where its front looks."""
    holes = [filled.RelatingOpeningElement for filled in getattr(product, "FillsVoids", ()) or ()]
    own = (_surface(part, settings) for part in (*holes[:1], product))
    found = next((surface for surface in own if surface), None)
    found = found or _joined([s for part in _parts(product) if (s := _surface(part, settings))])
    if found is None:
        return {}
    points, faces = found
    gap = APART if product.is_a("IfcCurtainWall") else MERGE
    rings = _hull(points) if hull else _rings(points, faces, gap)
    return _solid(product, points, rings, hosted=bool(holes))


def _solid(
    product: Any, points: np.ndarray, rings: list[np.ndarray], *, hosted: bool
) -> dict[str, Any]:
    return {
        "rings": [ring.tolist() for ring in rings],
        "low": float(points[:, 2].min()),
        "high": float(points[:, 2].max()),
        "heading": _turn(product),
        "hosted": hosted,
    }


def _surface(product: Any, settings: Any) -> Surface | None:
    """The triangles of a product, at least one."""
    import ifcopenshell.geom

    try:
        made = ifcopenshell.geom.create_shape(settings, product)
    except (RuntimeError, ValueError):
        return None
    points = np.asarray(made.geometry.verts, float).reshape(-1, 3)
    faces = np.asarray(made.geometry.faces, int).reshape(-1, 3)
    return Surface(points, faces) if len(faces) and np.isfinite(points).all() else None


def _joined(surfaces: list[Surface]) -> Surface | None:
    """The surfaces of the parts of a product as one."""
    if not surfaces:
        return None
    starts = np.cumsum([0, *(len(one.points) for one in surfaces[:-1])])
    return Surface(
        np.vstack([one.points for one in surfaces]),
        np.vstack([one.faces + start for one, start in zip(surfaces, starts, strict=True)]),
    )


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


def _rings(points: np.ndarray, faces: np.ndarray, gap: float) -> list[np.ndarray]:
    """Outline and holes of the largest region that the faces cover in plan, over gaps."""
    flat = shapely.polygons(points[faces][:, :, :2])
    flat = flat[shapely.area(flat) > TINY]
    if not len(flat):
        return []
    region = shapely.union_all(shapely.buffer(flat, gap, join_style="mitre", mitre_limit=2.0))
    region = shapely.buffer(region, -gap, join_style="mitre", mitre_limit=2.0).simplify(1e-4)
    parts = [part for part in shapely.get_parts(region) if part.geom_type == "Polygon"]
    if not parts:
        return []
    largest = max(parts, key=lambda part: part.area)
    rings = (largest.exterior, *(r for r in largest.interiors if shapely.Polygon(r).area > 1e-3))
    return [shapely.get_coordinates(ring)[:-1].round(6) for ring in rings]
