"""Surfaces laid over ground that is not flat: cut along the triangles of its heights, so that what
lies on them is everywhere parallel to them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.finishes import SURFACES
from scenewright.building.outlines import rings
from scenewright.core.catalog import Part
from scenewright.core.heights import HeightGrid, facet_heights_at
from scenewright.core.scene import GroundSurface, Scene, Terrain
from scenewright.core.space import Points
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.prisms import mound, prism, sheet

Floats = NDArray[np.float64]
THICK = 0.3
"""Metres that paving reaches into the ground."""
DEEP = 1.5
"""Metres of earth shown below the lowest ground."""
AROUND = 12.0
"""Metres of ground drawn beyond what is built on."""
NOTCH = 20.0
"""Half the width of gaps at the border that are drawn over, in metres."""
SPECK = 1e-6


def drape_floor(shape: shapely.Polygon, terrain: Terrain) -> Mesh:
    """The ground of a space."""
    return drape(shape, terrain.finished, 0.0)


def lay_surface(surface: GroundSurface) -> Mesh:
    """What lies on level ground; without an underside if it reaches into it, a sheet if it has no
    thickness."""
    rows, (base, top) = surface.areas, (surface.base, surface.top)
    if base == top:
        return merge([sheet(outline, holes, top) for outline, holes in rows])
    solid = mound if base < 0.0 else prism
    return _let_down(merge([solid(outline, base, top, holes) for outline, holes in rows]), surface)


def drape_surface(surface: GroundSurface, terrain: Terrain) -> Mesh:
    """What lies on the ground, with its edges."""
    shapes = [shapely.Polygon(outline, holes) for outline, holes in surface.areas]
    base = surface.base if surface.base > 0 else -THICK
    tops = [drape(shape, terrain.deck, surface.top) for shape in shapes]
    edged = shapes if surface.base < surface.top else []
    sides = [drape_sides(shape, terrain.deck, base, surface.top) for shape in edged]
    return _let_down(merge([*tops, *sides]), surface, terrain.deck)


def _let_down(mesh: Mesh, surface: GroundSurface, grid: HeightGrid | None = None) -> Mesh:
    """The mesh of a surface with its upper corners as low as it falls there; over the heights of a
    ``grid`` (none: 0)."""
    if surface.fall is None:
        return mesh
    lines, low, reach = surface.fall
    flat = mesh.vertices[:, :2]
    above = mesh.vertices[:, 2] - (facet_heights_at(grid, flat) if grid else 0.0)
    upper = above > (surface.base + surface.top) / 2
    edge = shapely.multilinestrings([shapely.LineString(line) for line in lines])
    share = np.clip(shapely.distance(shapely.points(flat[upper]), edge) / reach, 0.0, 1.0)
    vertices = mesh.vertices.copy()
    vertices[upper, 2] -= (surface.top - low) * (1.0 - share)
    return mesh._replace(vertices=vertices)


def lay_terrain(scene: Scene) -> Iterator[tuple[str, Part]]:
    """What else is drawn of terrain, by name: the ground beyond all spaces, the earth below its
    border, water, and the plinths of buildings."""
    terrain = scene.terrain
    if terrain is None:
        return
    spaces = shapely.union_all([shapely.Polygon(s.outline, s.holes) for s in scene.spaces])
    ground = extent_of(scene)
    beyond = shapely.difference(ground, spaces)
    around = [drape(part, terrain.finished, 0.0) for part in _polygons(beyond)]
    low = float(terrain.finished.values.min()) - DEEP
    earth = [_side(part, terrain.finished, low) for part in _polygons(ground)]
    waters = [
        prism(rings(part)[0], level - 0.05, level)
        for outline, level in terrain.waters
        for part in _polygons(shapely.Polygon(outline).intersection(ground))
    ]
    plinths = [prism(row.outline, row.base, row.top) for row in terrain.plinths]
    named = {"around": around, "earth": earth, "water": waters, "plinth": plinths}
    for name, meshes in named.items():
        if meshes:
            yield name, Part(SURFACES[name], *merge(meshes))


def extent_of(scene: Scene) -> shapely.Polygon:
    """The ground that is drawn: all spaces and surfaces and a strip about them, in one piece."""
    shapes = [shapely.Polygon(s.outline) for s in scene.spaces]
    shapes += [shapely.Polygon(outline) for s in scene.surfaces for outline, _ in s.areas]
    wide = shapely.union_all(shapely.buffer(shapes, AROUND + NOTCH, quad_segs=4))
    parts = _polygons(wide.buffer(-NOTCH, quad_segs=4))
    return shapely.Polygon(parts[0].exterior) if len(parts) == 1 else wide.convex_hull


def drape(shape: shapely.Polygon, grid: HeightGrid, above: float) -> Mesh:
    """A polygon as triangles ``above`` metres over heights."""
    corners = _cut(shape, grid)
    flat = corners.reshape(-1, 2)
    points, faces = np.unique(np.round(flat, 6), axis=0, return_inverse=True)
    vertices = np.column_stack([points, facet_heights_at(grid, points) + above])
    return Mesh(vertices, faces.reshape(-1, 3).astype(np.int64))


def drape_sides(shape: shapely.Polygon, grid: HeightGrid, low: float, high: float) -> Mesh:
    """The sides of a polygon between two distances over heights."""
    meshes = []
    for line in _edges(shape, grid.step):
        ground = facet_heights_at(grid, line)
        meshes.append(_fence(line, ground + low, ground + high))
    return merge(meshes)


def _side(shape: shapely.Polygon, grid: HeightGrid, low: float) -> Mesh:
    """The sides of a polygon from a level up to the ground."""
    lines = [*_edges(shape, grid.step)]
    return merge([_fence(li, np.full(len(li), low), facet_heights_at(grid, li)) for li in lines])


def _edges(shape: shapely.Polygon, step: float) -> Iterator[Points]:
    outline, holes = rings(shape)
    for ring in (outline, *holes):
        closed = shapely.LineString(np.vstack([ring, ring[:1]]))
        yield shapely.get_coordinates(shapely.segmentize(closed, step))


def _fence(line: Points, low: Floats, high: Floats) -> Mesh:
    count = len(line)
    vertices = np.vstack([np.column_stack([line, low]), np.column_stack([line, high])])
    i = np.arange(count - 1)
    lower = np.stack([i, i + 1, i + 1 + count], 1)
    upper = np.stack([i, i + 1 + count, i + count], 1)
    return Mesh(vertices, np.concatenate([lower, upper]))


def _cut(shape: shapely.Polygon, grid: HeightGrid) -> Floats:
    """A polygon as triangles (n, 3, 2), counter-clockwise, each within one of the grid's."""
    facets = _facets(grid, shape.bounds)
    polygons = shapely.polygons(facets)
    shapely.prepare(shape)
    whole = shapely.covers(shape, polygons)
    crossed = polygons[~whole & shapely.intersects(shape, polygons)]
    parts = shapely.get_parts(shapely.get_parts(shapely.intersection(crossed, shape)))
    parts = parts[shapely.area(parts) > SPECK]
    thin = shapely.get_parts(shapely.constrained_delaunay_triangles(parts))
    rest = shapely.get_coordinates(thin).reshape(-1, 4, 2)[:, :3]
    return np.concatenate([facets[whole], _turn_left(rest)])


def _facets(grid: HeightGrid, bounds: Sequence[float]) -> Floats:
    """The triangles (n, 3, 2) of a grid within bounds, each cell halved from its lower left to its
    upper right."""
    step, (x0, y0) = grid.step, grid.start
    rows, columns = grid.values.shape
    left, low = (int((b - s) // step) for b, s in zip(bounds[:2], (x0, y0), strict=True))
    right, high = (int((b - s) // step) + 1 for b, s in zip(bounds[2:], (x0, y0), strict=True))
    i = np.arange(max(left, 0), min(right, columns - 1))
    j = np.arange(max(low, 0), min(high, rows - 1))
    x, y = (v.reshape(-1) for v in np.meshgrid(x0 + step * i, y0 + step * j))
    a, b = np.stack([x, y], 1), np.stack([x + step, y], 1)
    c, d = np.stack([x + step, y + step], 1), np.stack([x, y + step], 1)
    return np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def _turn_left(triangles: Floats) -> Floats:
    one, two = triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    right = one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0] < 0
    found = triangles.copy()
    found[right] = triangles[right][:, ::-1]
    return found


def _polygons(shape: shapely.Geometry) -> list[shapely.Polygon]:
    parts = [p for p in shapely.get_parts(shape) if p.geom_type == "Polygon" and p.area > 0.05]
    return sorted(parts, key=lambda part: -part.area)
