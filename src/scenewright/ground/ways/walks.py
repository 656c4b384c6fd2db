"""Walks from the doors of buildings to the nearest street, lane or path, joined on their way."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.space import Points
from scenewright.geometry.wavefront import find_quickest
from scenewright.ground.plan import SitePlan
from scenewright.ground.streetside.border import Exits, find_exits, lead_out
from scenewright.ground.ways.lanes import corners_of, measure_ground
from scenewright.ground.ways.path_raster import PathRaster
from scenewright.ground.ways.path_tree import grow_paths, square_off, straighten
from scenewright.ground.works import Pathway, middle_lines

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
Flags = NDArray[np.bool_]

WALK = 1.5
"""Width of a walk in metres."""
COMFORT = 3.0
"""Metres that walks keep from buildings where they can."""
KERB = 0.05
"""Metres that walks keep from walls at least."""
STEPS = (1.0, 1.4, 1.9, 2.5, 3.2)
"""How far ahead of a door, in metres, its walk may begin to bend."""


class Doors(NamedTuple):
    """The doors of buildings: the middle of each front, ``places`` (n, 2), and the directions
    they look in, ``ways`` (n, 2)."""

    places: Floats
    ways: Floats


def find_doors(footprints: Sequence[Points], headings: Floats) -> Doors:
    """The middle of the side farthest ahead of each of some footprints, corners (k, 2).

    >>> square = np.array([(0, 0), (4, 0), (4, 4), (0, 4)], float)
    >>> find_doors([square], np.array([0.0])).places.tolist()
    [[4.0, 2.0]]
    """
    ways = np.stack([np.cos(headings), np.sin(headings)], 1).reshape(-1, 2)
    places, counts = np.zeros((len(footprints), 2)), np.array([len(ring) for ring in footprints])
    for count in np.unique(counts).tolist():
        own = np.flatnonzero(counts == count)
        rings = np.array([footprints[k] for k in own.tolist()], np.float64)
        middles = 0.5 * (rings + np.roll(rings, -1, axis=1))
        ahead = np.round((middles * ways[own, None]).sum(2), 6)
        places[own] = middles[np.arange(len(own)), ahead.argmax(1)]
    return Doors(places, ways)


def join_doors(*rows: Doors) -> Doors:
    """The doors of several rows as one."""
    return Doors(np.vstack([row.places for row in rows]), np.vstack([row.ways for row in rows]))


def lay_walks(
    plan: SitePlan,
    raster: PathRaster,
    built: NDArray[np.object_],
    doors: Doors,
    lanes: Sequence[Pathway],
) -> tuple[tuple[Pathway, ...], Flags]:
    """Walks to doors, and which doors have one. They begin on streets, paths and lanes."""
    streets = raster.walked.copy()
    for lane in lanes:
        line = shapely.segmentize(shapely.LineString(lane.line), raster.cell)
        streets.reshape(-1)[raster.cells_of(shapely.get_coordinates(line))] = True
    clear = 0.5 * WALK + KERB + 0.2 * raster.cell
    slow, starts = measure_ground(plan, raster, clear, COMFORT, streets)
    times, before = find_quickest(slow, raster.cell, starts)
    exits = find_exits(plan)
    outward = _find_ways_out(exits, doors)
    goals, served = _find_bends(raster, doors, times)
    served = served & ~np.isin(np.arange(len(served)), list(outward))
    pieces = grow_paths(slow, raster.cell, starts, goals[served], before)
    lines = _draw_lines(raster, slow, pieces, built)
    lines = [lead_out(line, exits, 2.0 * (clear + raster.cell)) for line in lines]
    stubs = [
        np.stack([place, raster.points_of(goals[k : k + 1])[0]])
        for k, place in enumerate(doors.places)
        if served[k]
    ]
    served[list(outward)] = True
    every = (line for line in (*lines, *stubs, *outward.values()) if len(line) > 1)
    corners = (corners_of(line) for line in every)
    walks = (Pathway("walk", WALK, line) for line in corners if len(line) > 1)
    return tuple(walks), served


def _find_ways_out(exits: Exits, doors: Doors) -> dict[int, Floats]:
    """By the number of a door the walk (2, 2) straight out of the site, where it is that near."""
    ahead = np.stack([doors.places, doors.places + STEPS[-1] * doors.ways], 1)
    met = shapely.intersection(exits.border, shapely.linestrings(ahead))
    ends = shapely.shortest_line(shapely.points(doors.places), met)
    return {
        k: lead_out(shapely.get_coordinates(ends[k]), exits, KERB)
        for k in range(len(ahead))
        if not met[k].is_empty and shapely.length(ends[k]) > 1e-3
    }


def _draw_lines(
    raster: PathRaster, slow: Floats, pieces: list[Ints], built: NDArray[np.object_]
) -> list[Floats]:
    """Pieces of ways pulled straight, but where that leads too near to what is ``built``."""
    straight = [
        raster.points_of(square_off(straighten(piece, slow, raster.cell), slow)) for piece in pieces
    ]
    lines = middle_lines([np.repeat(line, 2, axis=0).tolist() for line in straight])
    near = shapely.STRtree(built).query(lines, predicate="dwithin", distance=0.5 * WALK + KERB)[0]
    for k in np.unique(near).tolist():
        straight[k] = raster.points_of(pieces[k])
    return straight


def _find_bends(raster: PathRaster, doors: Doors, times: Floats) -> tuple[Ints, Flags]:
    """The first cell ahead of each door that a walk can reach, and whether there is one."""
    goals = np.zeros(len(doors.places), np.int32)
    served = np.zeros(len(doors.places), bool)
    for ahead in STEPS:
        cells = raster.cells_of(doors.places + ahead * doors.ways)
        fresh = ~served & np.isfinite(times[cells])
        goals[fresh], served = cells[fresh], served | fresh
    return goals, served
