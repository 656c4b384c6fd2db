"""Natural heights of a brief: a slope, contours or a raster, as one grid."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.brief.terrain import TerrainBrief, Water
from scenewright.core.errors import InputError
from scenewright.core.heights import HeightGrid, heights_at
from scenewright.core.space import Points
from scenewright.ground.terrain.rasters import read_raster
from scenewright.ground.terrain.shaping import LevelWater, lay_lattice

Floats = NDArray[np.float64]
FAR = 2e4
"""Metres that a plain slope reaches."""
PACE = 4.0
"""Metres between points of contours that are used."""
HEIGHTS = ("height", "elevation", "elev", "ele", "contour", "level", "z")
"""Names of the height of a contour, in any case, the likeliest first."""
MOST_FILE = 500_000_000
"""Bytes of a file of heights."""
WITHIN = 0.5
"""The share of the lattice that contours must surround."""


def natural_ground(
    terrain: TerrainBrief, floor: shapely.Geometry, shift: tuple[float, float] = (0.0, 0.0)
) -> HeightGrid:
    """The natural heights over a ``floor`` in the plan; ``shift`` are the coordinates of its
    (0, 0) in its map, where files lie if the brief does not say ``at``.

    >>> steep = TerrainBrief(slope=0.1, towards=180)
    >>> ground = natural_ground(steep, shapely.box(0, 0, 50, 50))
    >>> heights_at(ground, np.array([[0.0, 0.0], [0.0, 50.0]])).round(6).tolist()
    [0.0, 5.0]
    """
    if terrain.contours is None and terrain.raster is None:
        return _slope(terrain.slope or 0.0, np.deg2rad(terrain.towards))
    at = terrain.at or shift
    key, path = ("raster", terrain.raster) if terrain.raster else ("contours", terrain.contours)
    try:
        file = _file(str(path))
        grid = _moved(read_raster(file), at) if terrain.raster else _contoured(file, floor, at)
        _check_cover(grid, floor)
    except InputError as error:
        raise error.located(place=f"terrain.{key}") from None
    return grid


def waters_of(rows: list[Water], natural: HeightGrid) -> tuple[LevelWater, ...]:
    """The water of a brief, each polygon level: as high as it says, else as the lowest ground along
    its edge."""
    found = []
    for number, row in enumerate(rows):
        shape = shapely.Polygon(row.outline)
        if not shape.is_valid or shape.area < 1.0:
            raise InputError(
                "its outline crosses itself or covers nothing",
                "list the corners of the bank in order",
                place=f"terrain.water[{number}]",
            )
        edge = shapely.get_coordinates(shapely.segmentize(shape.exterior, PACE))
        lowest = float(heights_at(natural, edge).min())
        found.append(LevelWater(shape, lowest if row.level is None else row.level))
    return tuple(found)


def _slope(slope: float, towards: float) -> HeightGrid:
    corners = np.array([[-FAR, -FAR], [FAR, -FAR], [-FAR, FAR], [FAR, FAR]])
    down = np.array([np.sin(towards), np.cos(towards)])
    return HeightGrid((-FAR, -FAR), 2 * FAR, (-slope * corners @ down).reshape(2, 2))


def _file(path: str) -> Path:
    file = Path(path)
    if not file.is_file():
        raise InputError(f"there is no file '{path[-200:]}'", "check the path")
    if file.stat().st_size > MOST_FILE:
        raise InputError("the file is larger than 500 MB", "cut it to the site")
    return file


def _moved(grid: HeightGrid, at: tuple[float, float]) -> HeightGrid:
    return grid._replace(start=(grid.start[0] - at[0], grid.start[1] - at[1]))


def _contoured(file: Path, floor: shapely.Geometry, at: tuple[float, float]) -> HeightGrid:
    """A lattice over the floor between contours: linear on the triangles of their points, beyond
    them as the nearest."""
    points = np.concatenate([np.zeros((0, 3)), *_contour_points(file)])
    points[:, :2] -= at
    spread = points[:, :2] - points[:1, :2]
    if len(points) < 3 or np.linalg.matrix_rank(spread) < 2:
        raise InputError(
            f"'{file.name}' has no contours: lines with a height",
            f"give GeoJSON lines with one of the properties {', '.join(HEIGHTS)}, or 3D points",
        )
    empty = HeightGrid((0.0, 0.0), 1.0, np.zeros((2, 2)))
    grid = lay_lattice(empty, floor)
    spots = grid.points
    heights = _interpolate(points, spots.reshape(-1, 2)).reshape(spots.shape[:2])
    beyond = np.isnan(heights)
    if beyond.mean() > 1 - WITHIN:
        raise InputError(
            "the contours lie beside the ground",
            'give contours around it, in metres; "at" is the map\'s place of (0, 0)',
        )
    if beyond.any():
        known = shapely.STRtree(shapely.points(points[:, :2]))
        heights[beyond] = points[known.nearest(shapely.points(spots[beyond])), 2]
    return grid._replace(values=heights)


def _interpolate(points: Floats, spots: Points) -> Floats:
    """Heights (n,) at spots (n, 2), linear on the triangles of points (m, 3); NaN beyond them."""
    mesh = shapely.delaunay_triangles(shapely.multipoints(shapely.points(points[:, :2])))
    shapes = shapely.get_parts(mesh)
    corners = shapely.get_coordinates(shapes).reshape(-1, 4, 2)[:, :3]
    tree = shapely.STRtree(shapely.points(points[:, :2]))
    heights = points[tree.nearest(shapely.points(corners.reshape(-1, 2))), 2].reshape(-1, 3)
    spot, face = shapely.STRtree(shapes).query(shapely.points(spots), predicate="intersects")
    a, b, c = (corners[face, k] for k in range(3))
    whole = _cross(b - a, c - a)
    one = _cross(spots[spot] - a, c - a) / whole
    two = _cross(b - a, spots[spot] - a) / whole
    z = heights[face]
    found = np.full(len(spots), np.nan)
    found[spot] = z[:, 0] + one * (z[:, 1] - z[:, 0]) + two * (z[:, 2] - z[:, 0])
    return found


def _cross(a: Points, b: Points) -> Floats:
    return np.asarray(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])


def _contour_points(file: Path) -> Iterator[Floats]:
    try:
        document = json.loads(file.read_text(encoding="utf-8"))
        features = document["features"]
        for feature in features:
            yield from _points_of(feature)
    except (ValueError, KeyError, TypeError, RecursionError, AttributeError):
        raise InputError(f"'{file.name}' is no GeoJSON of lines", "export it as GeoJSON") from None


def _points_of(feature: dict[str, Any]) -> Iterator[Floats]:
    facts = {str(k).lower(): v for k, v in (feature.get("properties") or {}).items()}
    stated = [facts[name] for name in HEIGHTS if facts.get(name) is not None]
    geometry = shapely.from_geojson(json.dumps(feature["geometry"]), on_invalid="ignore")
    for line in shapely.get_parts(geometry) if geometry is not None else ():
        if line.geom_type not in ("LineString", "Point") or line.is_empty:
            continue
        whole = line if line.geom_type == "Point" else shapely.segmentize(line, PACE)
        rows: Points = shapely.get_coordinates(whole, include_z=True)
        if stated:
            rows[:, 2] = float(stated[0])
        yield rows[np.isfinite(rows).all(1)]


def _check_cover(grid: HeightGrid, floor: shapely.Geometry) -> None:
    """InputError where a grid has no heights on the ground."""
    low = np.array(grid.start)
    high = low + grid.step * (np.array(grid.values.shape)[::-1] - 1)
    left, bottom, right, top = floor.bounds
    slack = grid.step
    inside = (
        left >= low[0] - slack
        and bottom >= low[1] - slack
        and right <= high[0] + slack
        and top <= high[1] + slack
    )
    if not inside:
        raise InputError(
            f"its heights from ({low[0]:.0f}, {low[1]:.0f}) to ({high[0]:.0f}, {high[1]:.0f}) do "
            f"not cover the ground from ({left:.0f}, {bottom:.0f}) to ({right:.0f}, {top:.0f})",
            'give heights of the whole ground; "at" is the map\'s place of (0, 0)',
        )
    spots = lay_lattice(grid, floor)
    if not np.isfinite(spots.values).all():
        raise InputError("has cells without a height on the ground", "fill them, or cut the site")
