"""The referee on terrain: doors near the ground, ways not too steep, nothing built in water.

It knows the brief and what was made of the ground, reads heights by its own interpolation and has
its own doors; the natural ground of a slope it works out anew.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.check.buildings import measure_shared, state_fault
from scenewright.core.brief.terrain import TerrainBrief
from scenewright.core.heights import HeightGrid
from scenewright.core.piece_outlines import outline_of
from scenewright.core.report import Finding, Note
from scenewright.core.scene import Piece
from scenewright.core.space import Points

Floats = NDArray[np.float64]
DOOR = 0.3
"""Metres between the ground before a door and its floor, at most."""
AHEAD = 0.6
"""Metres before a door at which its ground is measured."""
GRADE, SLACK = 0.10, 0.005
"""The steepest a way may be, and by how much it may be missed, in metres a metre."""
STRIDE = 5.0
"""Metres between points at which a way is measured."""
SHARED = 0.01
DEEPEST, MOVED = 3.0, 1.0
"""Metres of cut or of fill beyond which a street or a building is reported, a storey, and cubic
metres moved by the square metre of ground."""
BEND = "lead streets along the contours, and up the slope in bends"
TURN = "turn long sides along the contours, or ask for smaller buildings or fewer"


class JudgedTerrain(NamedTuple):
    """What the referee is given: the brief's terrain, heights as finished and with ways over water,
    the natural ones, the floors of buildings by id, and the lines of ways with their names."""

    terrain: TerrainBrief
    natural: HeightGrid
    finished: HeightGrid
    deck: HeightGrid
    floors: dict[str, float]
    ways: Sequence[tuple[str, Points]]


def judge_terrain(
    judged: JudgedTerrain, pieces: Sequence[Piece]
) -> tuple[list[Finding], list[Note], dict[str, Any]]:
    """Findings on terrain, notes on how much of it is moved, and its figures: cubic metres moved by
    the square metre of lattice, grades in metres a metre, metres of plinth."""
    built = [piece for piece in pieces if piece.id in judged.floors]
    off = [_measure_door(judged, piece) for piece in built]
    grades = [(name, grade) for name, line in judged.ways for grade in _grades(judged, line)]
    steep = max((grade for _, grade in grades), default=0.0)
    findings = [
        state_fault(
            "door_off_ground",
            piece,
            f"the door of {piece.id} is {abs(high):.2f} m {'above' if high > 0 else 'below'} the "
            f"ground, {DOOR:g} m at most",
            abs(high),
        )
        for piece, high in zip(built, off, strict=True)
        if abs(high) > DOOR + SHARED
    ]
    findings += [*_find_in_water(judged, built), *_find_steep(grades)]
    plinths = [_measure_plinth(judged, piece) for piece in built]
    figures = {
        "natural_grade": round(_mean_grade(judged), 4),
        "steepest_way": round(steep, 4),
        "largest_door_step": round(max(map(abs, off), default=0.0), 3),
        "largest_plinth": round(max(plinths, default=0.0), 2),
        **_volumes(judged),
    }
    return findings, list(_find_earthworks(judged, built, figures)), figures


def _find_earthworks(
    judged: JudgedTerrain, built: Sequence[Piece], figures: dict[str, Any]
) -> Iterator[Note]:
    """Where more ground is moved than anyone would: ways and buildings in cuts and on banks deeper
    than :data:`DEEPEST`, and all of it by the area moved."""
    ways = [(name, _depth_of(judged, shapely.LineString(line))) for name, line in judged.ways]
    rows = [(one.id, _depth_of(judged, shapely.LinearRing(outline_of(one)))) for one in built]
    for what, depths, remedy in (("ways", ways, BEND), ("buildings", rows, TURN)):
        deep = sorted((r for r in depths if abs(r[1]) > DEEPEST), key=lambda r: -abs(r[1]))
        if deep:
            name, depth = deep[0]
            how = f"{name} {'on a bank' if depth > 0 else 'in a cut'} of {abs(depth):.1f} m"
            text = f"{len(deep)} of {len(depths)} {what} lie more than {DEEPEST:g} m "
            text += f"above or below the ground, {how}: {remedy}"
            yield Note("", "terrain", "earthworks", text)
    worked = judged.finished.values.size * judged.finished.step**2
    moved = figures["cut"] + figures["fill"]
    if moved > MOVED * worked:
        text = f"{moved:,.0f} m³ of ground are moved, {moved / worked:.1f} by the square metre "
        yield Note("", "terrain", "earthworks", text + f"({MOVED:g} at most): {BEND}")


def _depth_of(judged: JudgedTerrain, line: shapely.LineString) -> float:
    """By how many metres the ground along a line on land is raised or, below 0, lowered most."""
    points = shapely.get_coordinates(shapely.segmentize(line, STRIDE))
    heights = _sample(judged.finished, points)
    dry = np.abs(_sample(judged.deck, points) - heights) < SHARED
    moved = (heights - _natural(judged, points))[dry]
    return float(moved[np.argmax(np.abs(moved))]) if len(moved) else 0.0


def _sample(grid: HeightGrid, points: Floats) -> Floats:
    """Heights (n,) at points: those of the four about each by the area opposite to them."""
    rows, columns = grid.values.shape
    at = np.clip((np.asarray(points) - grid.start) / grid.step, 0, (columns - 1, rows - 1))
    low = np.minimum(np.floor(at).astype(int), (columns - 2, rows - 2))
    found = np.zeros(len(at))
    for corner in ((0, 0), (1, 0), (0, 1), (1, 1)):
        weight = np.prod(1 - np.abs(at - low - corner), axis=1)
        found += weight * grid.values[low[:, 1] + corner[1], low[:, 0] + corner[0]]
    return found


def _natural(judged: JudgedTerrain, points: Floats) -> Floats:
    terrain = judged.terrain
    if terrain.contours or terrain.raster:
        return _sample(judged.natural, points)
    bearing = np.deg2rad(terrain.towards)
    return np.asarray(-(terrain.slope or 0.0) * points @ [np.sin(bearing), np.cos(bearing)])


def _measure_door(judged: JudgedTerrain, piece: Piece) -> float:
    """How far the floor of a building lies above the ground before its front."""
    ring, heading = outline_of(piece), piece.pose.heading
    out = np.array([np.cos(heading), np.sin(heading)])
    middles = (ring + np.roll(ring, -1, axis=0)) / 2
    door = middles[int(np.argmax(np.round(middles @ out, 6)))] + AHEAD * out
    return judged.floors[piece.id] - float(_sample(judged.finished, door[None])[0])


def _measure_plinth(judged: JudgedTerrain, piece: Piece) -> float:
    ring = outline_of(piece)
    closed = shapely.segmentize(shapely.LinearRing(ring), 1.0)
    ground = _sample(judged.finished, shapely.get_coordinates(closed))
    return judged.floors[piece.id] - float(ground.min())


def _grades(judged: JudgedTerrain, line: Points) -> Iterator[float]:
    whole = shapely.LineString(line)
    if whole.length < STRIDE:
        return
    along = np.linspace(0.0, whole.length, int(whole.length // STRIDE) + 1)
    points = shapely.get_coordinates(shapely.line_interpolate_point(whole, along))
    heights = _sample(judged.deck, points)
    yield from np.abs(np.diff(heights) / np.diff(along)).tolist()


def _find_steep(grades: Sequence[tuple[str, float]]) -> Iterator[Finding]:
    worst: dict[str, float] = {}
    for name, grade in grades:
        worst[name] = max(worst.get(name, 0.0), grade)
    for name, grade in worst.items():
        if grade > GRADE + SLACK:
            text = f"{name} rises {grade:.1%}, {GRADE:.0%} at most"
            yield Finding("steep_way", "0", "", "", name, text, grade)


def _find_in_water(judged: JudgedTerrain, built: Sequence[Piece]) -> Iterator[Finding]:
    for number, row in enumerate(judged.terrain.water):
        water = shapely.Polygon(row.outline)
        for piece in built:
            shared = shapely.intersection(shapely.Polygon(outline_of(piece)).buffer(0), water)
            depth, area = measure_shared(shared)
            if depth > SHARED:
                name = row.name or f"water {number + 1}"
                text = f"{piece.id} stands in {name} by {depth:.2f} m ({area:.2f} m²)"
                yield state_fault("in_water", piece, text, depth, area, name)


def _mean_grade(judged: JudgedTerrain) -> float:
    points = judged.finished.points
    heights = _natural(judged, points.reshape(-1, 2)).reshape(points.shape[:2])
    across, along = np.gradient(heights, judged.finished.step)
    return float(np.hypot(across, along).mean())


def _volumes(judged: JudgedTerrain) -> dict[str, float]:
    """Ground taken away and brought on the whole lattice, water aside, in cubic metres."""
    points = judged.finished.points.reshape(-1, 2)
    moved = judged.finished.values.reshape(-1) - _natural(judged, points)
    for row in judged.terrain.water:
        moved[shapely.contains_xy(shapely.Polygon(row.outline), *points.T)] = 0.0
    cell = judged.finished.step**2
    return {
        "cut": round(float(-moved[moved < 0].sum()) * cell, 1),
        "fill": round(float(moved[moved > 0].sum()) * cell, 1),
    }
