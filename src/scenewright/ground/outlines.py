"""The polygons of a site: checked outlines, ground less what must stay free, roads as areas.

Distances are kept by buffers with mitred corners, which never come nearer than the round ones
they stand for. Overlays of lines that run along each other are sometimes wrong at odd angles, so
all are snapped to a grid of 0.1 mm.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from functools import lru_cache

import numpy as np
import shapely

from scenewright.building.outlines import ring
from scenewright.core.errors import InputError
from scenewright.core.space import Points

GRID = 1e-4
LEAST_AREA = 1.0
MITRE = 2.0
TOUCH = 0.02
MOST_CROSSINGS = 20_000
"""Roads may cross so often: every crossing costs time, and cities have a few for each road."""
LOT = 64

Corners = Sequence[tuple[float, float]] | Points


def simple(points: Corners, what: str, least: float = 0.0) -> shapely.Polygon:
    """A ring of corners as a valid polygon of at least ``least`` square metres; InputError that
    says what is wrong.

    >>> simple([(0, 0), (4, 0), (4, 3), (0, 3)], "the outline").area
    12.0
    """
    corners = ring(points)
    shape = shapely.Polygon(corners) if len(corners) > 2 else shapely.Polygon()
    area = shape.area if shape.is_valid else shapely.convex_hull(shape).area
    if area <= max(least, 1e-3):
        raise InputError(f"{what} holds only {area:.2g} m² of ground", "give its corners in metres")
    if not shape.is_valid:
        raise InputError(
            f"{what} crosses or touches itself{_where(shape)}",
            "list the corners in order, once around",
        )
    return shape


def ground(outline: Corners, holes: Sequence[Corners]) -> shapely.Polygon:
    """The ground of a site: its outline less its holes; one valid polygon."""
    floor = simple(outline, "the outline", LEAST_AREA)
    for number, hole in enumerate(holes):
        cut = simple(hole, f"holes[{number}]")
        if floor.intersection(cut).area < 0.5 * cut.area:
            raise InputError(
                f"holes[{number}] lies outside the outline", "move it in or leave it out"
            )
        rest = polygons(shapely.difference(floor, cut, grid_size=GRID))
        if len(rest) != 1:
            text = f"cuts the site in {len(rest)} pieces" if rest else "leaves nothing of the site"
            raise InputError(f"holes[{number}] {text}", "make each piece a site of its own")
        floor = rest[0]
    return floor


def inset(floor: shapely.Polygon, setback: float) -> list[shapely.Polygon]:
    """The parts of a site at least ``setback`` from its outline and holes; InputError, with what
    would be possible, if there are none."""
    found = polygons(shapely.buffer(floor, -setback, join_style="mitre", mitre_limit=MITRE))
    if not found:
        most = inscribed_radius(floor)
        raise InputError(
            f"the setback of {setback:g} m leaves nothing: the site is at most {2 * most:.2f} m "
            f"wide, {max(2 * (setback - most), 0.0):.2f} m too narrow",
            f"give a setback of less than {most:.2f} m",
        )
    return found


def way(line: Corners, width: float) -> tuple[Points, shapely.Polygon]:
    """The clean middle line ``(n, 2)`` of a road and the area it covers, cut square at its ends;
    InputError if it has no length."""
    corners = np.asarray(line, float).reshape(-1, 2)
    far = np.hypot(*np.diff(corners, axis=0).T) > 1e-3
    corners = corners[np.concatenate([[True], far])]
    if len(corners) < 2:
        raise InputError("the road has no length", "give at least two different points")
    area = shapely.buffer(
        shapely.LineString(corners),
        width / 2,
        cap_style="flat",
        join_style="mitre",
        mitre_limit=MITRE,
    )
    return corners, area


def crossings(lines_: Sequence[Points]) -> int:
    """How often the straight pieces of lines (n, 2) cross, each other or themselves, counted until
    there are more than :data:`MOST_CROSSINGS`; ends that touch do not count.

    >>> crossings([np.array([(0, 0), (4, 4)]), np.array([(0, 4), (4, 0), (9, 0)])])
    1
    """
    pieces = [np.stack([line[:-1], line[1:]], 1) for line in lines_]
    if not pieces:
        return 0
    made = shapely.linestrings(np.concatenate(pieces))
    tree, count = shapely.STRtree(made), 0
    for first in range(0, len(made), LOT):
        own, other = tree.query(made[first : first + LOT], predicate="crosses")
        count += int((own + first < other).sum())
        if count > MOST_CROSSINGS:
            break
    return count


@lru_cache(maxsize=32)
def grow(floor: shapely.Polygon, far: float) -> shapely.Geometry:
    """A floor and what lies within ``far`` metres of it, or the part that deep inside if
    negative; made once for all streets of a width.

    >>> round(grow(shapely.box(0, 0, 4, 3), -1.0).area, 6)
    2.0
    """
    return shapely.buffer(floor, far)


def kept_free(areas: Iterable[shapely.Geometry], distance: float) -> shapely.Geometry:
    """The floor within ``distance`` of some areas."""
    shapes = np.array(list(areas), object)
    if not len(shapes):
        return shapely.Polygon()
    wider = shapely.buffer(shapes, distance, join_style="mitre", mitre_limit=MITRE)
    return shapely.union_all(wider, grid_size=GRID)


def less(
    parts: Sequence[shapely.Polygon], taken: Iterable[shapely.Geometry]
) -> list[shapely.Polygon]:
    """The connected parts of ground that are left, largest first; none under 1 m²."""
    rest = shapely.union_all(np.array(list(parts), object), grid_size=GRID)
    for shape in taken:
        rest = shapely.difference(rest, shape, grid_size=GRID)
    return polygons(rest)


def polygons(shape: shapely.Geometry) -> list[shapely.Polygon]:
    """The polygons of at least 1 m² in a geometry, largest first."""
    parts = shapely.get_parts(shapely.get_parts(shape))
    found = [part for part in parts if part.geom_type == "Polygon" and part.area >= LEAST_AREA]
    return sorted(found, key=lambda part: (-part.area, part.bounds))


def lines(shape: shapely.Geometry) -> tuple[Points, ...]:
    """The lines ``(n, 2)`` longer than 1 cm in a geometry."""
    parts = shapely.get_parts(shapely.line_merge(shape) if not shape.is_empty else shape)
    found = [p for p in parts if p.geom_type == "LineString" and p.length > 0.01]
    return tuple(shapely.get_coordinates(part) for part in found)


def inscribed_radius(shape: shapely.Polygon) -> float:
    """The radius of the largest circle in a polygon, to a hundredth of it."""
    size = max(shape.bounds[2] - shape.bounds[0], shape.bounds[3] - shape.bounds[1])
    return float(shapely.maximum_inscribed_circle(shape, tolerance=max(1e-4 * size, 1e-3)).length)


def _where(shape: shapely.Polygon) -> str:
    found = re.search(r"\[(\S+) (\S+?)\]", shapely.is_valid_reason(shape))
    return f" at ({float(found[1]):.2f}, {float(found[2]):.2f})" if found else ""
