"""The corners of what is drawn by flat faces, as the file states them.

Of furniture only the outline in plan and its heights are asked for. A kernel of solids sews the
faces of every piece anew, which takes seconds where a model of thousands of faces stands twenty
times; its corners are read once and moved to each place.
"""

from __future__ import annotations

from typing import Any

import numpy as np

FLAT = frozenset(
    (
        "IfcFaceBasedSurfaceModel",
        "IfcShellBasedSurfaceModel",
        "IfcFacetedBrep",
        "IfcConnectedFaceSet",
        "IfcClosedShell",
        "IfcOpenShell",
        "IfcFace",
        "IfcFaceOuterBound",
        "IfcFaceBound",
        "IfcPolyLoop",
        "IfcCartesianPoint",
    )
)
"""Entities that make up a body of flat faces, besides the lists of IFC4."""
LISTED = ("IfcTriangulatedFaceSet", "IfcPolygonalFaceSet")
Known = dict[int, np.ndarray | None]


def corners_of(product: Any, known: Known) -> np.ndarray | None:
    """The corners (n, 3) of a product in the unit of its file; ``None`` where its body is not all
    flat faces. ``known`` are those of shapes that stand in several places, by number."""
    shapes = getattr(product.Representation, "Representations", None) or ()
    bodies = [one for one in shapes if one.RepresentationIdentifier == "Body"]
    if len(bodies) != 1:
        return None
    local = _joined([_item(item, known) for item in bodies[0].Items])
    if local is None:
        return None
    import ifcopenshell.util.placement as placements

    return _moved(local, placements.get_local_placement(product.ObjectPlacement))


def _item(item: Any, known: Known) -> np.ndarray | None:
    if item.is_a("IfcMappedItem"):
        import ifcopenshell.util.placement as placements

        number = item.MappingSource.id()
        if number not in known:
            known[number] = None  # a shape that is part of itself has no corners
            parts = item.MappingSource.MappedRepresentation.Items
            known[number] = _joined([_item(part, known) for part in parts])
        local = known[number]
        if local is None:
            return None
        return _moved(local, placements.get_mappeditem_transformation(item))
    if item.is_a() in LISTED:
        return np.asarray(item.Coordinates.CoordList, float).reshape(-1, 3)
    return _corners_of_faces(item)


def _corners_of_faces(item: Any) -> np.ndarray | None:
    """The corners of faces that are written out one by one."""
    if item.is_a() not in FLAT:
        return None
    made = item.file.traverse(item)
    if any(one.is_a() not in FLAT for one in made):
        return None
    return np.array([p.Coordinates for p in made if p.is_a() == "IfcCartesianPoint"], float)


def _joined(parts: list[np.ndarray | None]) -> np.ndarray | None:
    """All corners of some parts, if every part has some."""
    there = [part for part in parts if part is not None and part.ndim == 2 and len(part)]
    if not there or len(there) < len(parts):
        return None
    found = np.vstack(there)
    return found if np.isfinite(found).all() else None


def _moved(points: np.ndarray, matrix: Any) -> np.ndarray:
    frame = np.asarray(matrix, float)
    moved: np.ndarray = points @ frame[:3, :3].T + frame[:3, 3]
    return moved
