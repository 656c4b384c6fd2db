"""Scenes on terrain: the ground shaped for what a scene holds, and all of it lifted onto it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import shapely

from scenewright.core.brief.terrain import TerrainBrief
from scenewright.core.heights import facet_heights_at, heights_at
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece, Prism, Scene, Terrain
from scenewright.core.space import Points, Space
from scenewright.ground.buildings.built import BuiltRoad
from scenewright.ground.terrain.reading import natural_ground, waters_of
from scenewright.ground.terrain.shaping import GroundBuilding, ShapedGround, shape_ground
from scenewright.ground.ways.walks import find_doors

AROUND = 14.0
"""Metres of ground that is shaped beyond the spaces and ways."""
FOOT = 0.05
"""Metres that a plinth stands out before its building."""
INTO = 0.4
"""Metres that a plinth reaches into the ground."""
RISE, TREAD, STAIR = 0.17, 0.3, 1.4
"""Greatest rise of a step, its depth, and the width of steps at doors, in metres."""


def shape_for(
    terrain: TerrainBrief,
    spaces: Sequence[Space],
    ways: Sequence[BuiltRoad],
    pieces: Sequence[Piece],
    shift: tuple[float, float] = (0.0, 0.0),
) -> ShapedGround:
    """The ground of ``spaces`` shaped for ``ways`` and the buildings among some pieces."""
    floor = extent(spaces, ways)
    natural = natural_ground(terrain, floor, shift)
    waters = waters_of(terrain.water, natural)
    built = [piece for piece in pieces if piece.category == "building"]
    rings = [outline_of(piece) for piece in built]
    doors = find_doors(rings, np.array([piece.pose.heading for piece in built])).places
    buildings = [
        GroundBuilding(piece.id, shapely.Polygon(ring).buffer(0), door)
        for piece, ring, door in zip(built, rings, doors, strict=True)
    ]
    return shape_ground(natural, floor, ways, buildings, waters)


def extent(spaces: Sequence[Space], ways: Sequence[BuiltRoad]) -> shapely.Geometry:
    """The ground that is shaped."""
    shapes = [shapely.Polygon(space.outline) for space in spaces]
    shapes += [shapely.LineString(way.line).buffer(way.width / 2) for way in ways]
    return shapely.union_all(shapely.buffer(shapes, AROUND, join_style="mitre"))


def lift_scene(scene: Scene, shaped: ShapedGround) -> Scene:
    """A scene on shaped ground: buildings on their floors, all else on the ground."""
    loose = [piece for piece in scene.pieces if piece.id not in shaped.floors]
    at = np.array([piece.pose[:2] for piece in loose]).reshape(-1, 2)
    ground = facet_heights_at(shaped.deck, at).tolist()
    heights = shaped.floors | dict(zip((p.id for p in loose), ground, strict=True))
    pieces = tuple(_raise(piece, heights[piece.id]) for piece in scene.pieces)
    stand = [piece for piece in pieces if piece.id in shaped.floors]
    plinths = tuple(prism for piece in stand for prism in list_plinths(piece, shaped))
    waters = tuple((shapely.get_coordinates(w.shape)[:-1], w.level) for w in shaped.waters)
    terrain = Terrain(shaped.natural, shaped.finished, shaped.deck, plinths, waters)
    return replace(scene, pieces=pieces, terrain=terrain)


def _raise(piece: Piece, height: float) -> Piece:
    return replace(piece, pose=piece.pose._replace(z=piece.pose.z + height))


def list_plinths(piece: Piece, shaped: ShapedGround) -> list[Prism]:
    """What a building on its floor stands on, and the steps before its door."""
    ring, floor = outline_of(piece), shaped.floors[piece.id]
    wide = shapely.buffer(shapely.Polygon(ring), FOOT, join_style="mitre")
    foot = shapely.get_coordinates(wide.exterior)[:-1]
    foot = foot if shapely.is_ccw(wide.exterior) else foot[::-1]
    lowest = float(facet_heights_at(shaped.finished, foot).min())
    return [Prism(foot, lowest - INTO, floor), *list_steps(piece, ring, shaped)]


def list_steps(piece: Piece, ring: Points, shaped: ShapedGround) -> list[Prism]:
    """Steps from the ground before a door to its floor; none where that is one rise above it."""
    doors = find_doors([ring], np.array([piece.pose.heading]))
    (door,), (out,) = doors.places, doors.ways
    floor = shaped.floors[piece.id]
    below = floor - float(heights_at(shaped.finished, (door + 0.6 * out)[None])[0])
    count = int(np.ceil(below / RISE - 1e-6)) - 1
    across = np.array([-out[1], out[0]]) * STAIR / 2
    steps = []
    for k in range(count):
        near, far = door, door + TREAD * (k + 1) * out
        outline = np.stack([near - across, far - across, far + across, near + across])
        steps.append(Prism(outline, floor - below - INTO, floor - below / (count + 1) * (k + 1)))
    return steps
