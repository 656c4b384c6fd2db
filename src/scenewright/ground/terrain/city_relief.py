"""City models on terrain: objects lifted onto shaped ground, and the ground as a TINRelief."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.heights import HeightGrid, facet_heights_at
from scenewright.ground.buildings.city_objects import free_key
from scenewright.ground.terrain.shaping import ShapedGround

Floats = NDArray[np.float64]
MOST = 8_000
"""About how many triangles of relief are written."""


class LiftedVertices:
    """The vertices of a document as they are lifted, each listed once."""

    def __init__(self, whole: Floats, scale: Floats) -> None:
        self.whole, self.scale = whole, scale
        self.numbers: dict[tuple[int, int, int], int] = {}

    def add(self, point: Floats) -> int:
        """The number of a point in metres."""
        key = tuple(int(v) for v in np.round(point / self.scale))
        return self.numbers.setdefault((key[0], key[1], key[2]), len(self.numbers))


def lay_on_relief(document: dict[str, Any], shaped: ShapedGround) -> dict[str, Any]:
    """A CityJSON document of flat ground with its buildings on their floors, all else on the
    finished ground in triangles, and that ground as an object of its own."""
    scale = np.array(document["transform"]["scale"], float)
    metres = np.array([0.001, 0.001, 0.001])
    whole = np.array(document["vertices"], float).reshape(-1, 3) * metres
    lifted = LiftedVertices(whole, metres)
    objects = {
        name: _lift(name, one, lifted, shaped) for name, one in document["CityObjects"].items()
    }
    objects[free_key("terrain", objects)] = _relief(shaped.finished, lifted)
    vertices = [list(key) for key in lifted.numbers]
    corners = np.array(vertices, float) * scale + document["transform"]["translate"]
    extent = [round(float(v), 3) for v in (*corners.min(0), *corners.max(0))]
    about = document["metadata"] | {"geographicalExtent": extent}
    return document | {"metadata": about, "CityObjects": objects, "vertices": vertices}


def _lift(
    name: str, one: dict[str, Any], lifted: LiftedVertices, shaped: ShapedGround
) -> dict[str, Any]:
    made, floor = [], shaped.floors.get(name)
    for geometry in one.get("geometry", ()):
        rows = geometry["boundaries"]
        if geometry["type"] == "Solid":
            used = sorted({k for shell in rows for face in shell for ring in face for k in ring})
            if floor is None:
                floor = float(facet_heights_at(shaped.finished, lifted.whole[used, :2]).mean())
            at = {k: lifted.add(lifted.whole[k] + (0.0, 0.0, floor)) for k in used}
            rows = [[[[at[k] for k in r] for r in face] for face in shell] for shell in rows]
        elif geometry["type"] == "MultiPoint":
            high = facet_heights_at(shaped.finished, lifted.whole[rows, :2])
            raised = zip(rows, high.tolist(), strict=True)
            rows = [lifted.add(lifted.whole[k] + (0.0, 0.0, z)) for k, z in raised]
        else:
            rows = [row for face in rows for row in _drape(face, lifted, shaped.deck)]
        made.append(geometry | {"boundaries": rows})
    return one | {"geometry": made}


def _drape(
    face: Sequence[Sequence[int]], lifted: LiftedVertices, ground: HeightGrid
) -> list[list[list[int]]]:
    """A flat area as triangles on the ground."""
    rings = [lifted.whole[list(ring), :2] for ring in face]
    shape = shapely.Polygon(rings[0], rings[1:]).buffer(0)
    parts = shapely.get_parts(shapely.constrained_delaunay_triangles(shapely.get_parts(shape)))
    corners = shapely.get_coordinates(shapely.get_parts(parts)).reshape(-1, 4, 2)[:, :3]
    found = []
    for points in corners:
        (ax, ay), (bx, by) = points[1] - points[0], points[2] - points[0]
        left = ax * by - ay * bx > 0
        ordered = points if left else points[::-1]
        high = facet_heights_at(ground, ordered)
        ring = [lifted.add(np.array([*p, z])) for p, z in zip(ordered, high, strict=True)]
        if len(set(ring)) == 3:
            found.append([ring])
    return found


def _relief(grid: HeightGrid, lifted: LiftedVertices) -> dict[str, Any]:
    """The ground as triangles, every few metres."""
    rows, columns = grid.values.shape
    skip = max(int(np.ceil(np.sqrt(2 * rows * columns / MOST))), 1)
    points, values = grid.points[::skip, ::skip], grid.values[::skip, ::skip]
    number = np.array(
        [
            [lifted.add(np.array([*p, z])) for p, z in zip(line, high, strict=True)]
            for line, high in zip(points, values, strict=True)
        ]
    )
    a, b, c, d = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    faces = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)
    geometry = {
        "type": "CompositeSurface",
        "lod": "1",
        "boundaries": [[face] for face in faces.tolist()],
    }
    return {"type": "TINRelief", "attributes": {"class": "finished"}, "geometry": [geometry]}
