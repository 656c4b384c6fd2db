"""From a solved hall to its pieces and its scene graph."""

from __future__ import annotations

import math

import numpy as np
import shapely

from scenewright.catalog import Catalog
from scenewright.domains.hall.assign import Unit
from scenewright.domains.hall.pose import Hall
from scenewright.domains.hall.wanted import Wanted
from scenewright.encodings.patterns import ACROSS, ALONG, CODE, NUMBER, PART, PATTERNS
from scenewright.hall_energy import capacity
from scenewright.hall_problem import Floats, HallProblem
from scenewright.scene import Piece, Pose, Size
from scenewright.scene_graph import Layer, Part, PlacedGroup
from scenewright.terms.hall_state import Kept

NAMES = tuple(PATTERNS)
CEILING = 0.3
"""A partition stays this far below the ceiling, and under four metres, in metres."""
TALLEST = 4.0


def dressed(
    hall: Hall, wishes: list[Wanted], units: list[Unit], problem: HallProblem, boxes: Floats,
    catalog: Catalog,
) -> tuple[Piece, ...]:  # fmt: skip
    """One piece an object, in the order of the problem."""
    pieces: list[Piece] = []
    row = 0
    for unit, group in zip(units, problem.names, strict=True):
        wish = wishes[unit.demand]
        for number, size in enumerate(wish.sizes[unit.first : unit.last], 1):
            low = min(size.height, hall.space.height)
            fitted = Size(size.width, round(size.depth - 2 * wish.chairs, 9), low)
            asset = catalog.choose(wish.category, fitted)
            x, y, heading = (float(v) for v in boxes[row, :3])
            pieces.append(
                Piece(
                    id=f"{group}/{wish.category}_{number}", category=wish.category,
                    asset=asset.id if asset else "", space=hall.space.id,
                    pose=Pose(x, y, 0.0, _wrapped(heading)), size=fitted,
                    group=group, function=wish.id,
                )
            )  # fmt: skip
            row += 1
    return tuple(pieces)


def partitions(hall: Hall, problem: HallProblem, kept: Kept, catalog: Catalog) -> list[Piece]:
    """The generated walls as pieces."""
    height = min(max(hall.space.height - CEILING, 2.0), TALLEST, hall.space.height)
    found: list[Piece] = []
    for host, (low, high) in zip(problem.ground.hosts, kept.walls, strict=True):
        if high - low < 0.3:
            continue
        start, end = np.array(host[:2]), np.array(host[2:4])
        way = (end - start) / np.hypot(*(end - start))
        x, y = start + way * (low + high) / 2
        size = Size(float(high - low), problem.ground.thickness, height)
        asset = catalog.choose("partition", size)
        found.append(
            Piece(
                id=f"{hall.space.id}/partitions/partition_{len(found) + 1}", category="partition",
                asset=asset.id if asset else "", space=hall.space.id,
                pose=Pose(float(x), float(y), 0.0, _wrapped(math.atan2(way[0], -way[1]))),
                size=size, group=f"{hall.space.id}/partitions", function="partition",
            )
        )  # fmt: skip
    return found


def placed_groups(
    hall: Hall, wishes: list[Wanted], units: list[Unit], problem: HallProblem, kept: Kept,
    pieces: tuple[Piece, ...],
) -> tuple[PlacedGroup, ...]:  # fmt: skip
    """The groups of the scene graph."""
    found: list[PlacedGroup] = []
    row, layer = 0, 0
    for number, (unit, name) in enumerate(zip(units, problem.names, strict=True)):
        count = unit.last - unit.first
        mine = pieces[row : row + count]
        used = int(kept.rows[number, 1])
        layers = kept.layers[layer : layer + used]
        pattern = NAMES[int(kept.rows[number, 0])]
        parts = _parts(pattern, layers, float(kept.pose[number, 3]), count)
        found.append(
            PlacedGroup(
                id=name, demand=wishes[unit.demand].id, space=hall.space.id,
                zone=hall.names[unit.zone], pattern=pattern,
                pose=_pose(pattern, kept.pose[number], mine), parts=parts,
                objects=tuple(piece.id for piece in mine),
            )
        )  # fmt: skip
        row, layer = row + count, layer + int(capacity(np.array(count)))
    return tuple(found)


def kept_groups(hall: Hall, locked: tuple[Piece, ...]) -> tuple[PlacedGroup, ...]:
    """Groups that stand already, as single objects; their zone is where their middle lies."""
    found = []
    for name in dict.fromkeys(piece.group for piece in locked if piece.function != "partition"):
        mine = tuple(piece for piece in locked if piece.group == name)
        x, y = np.mean([piece.pose[:2] for piece in mine], axis=0)
        inside = [zone.id for zone in hall.plan.zones
                  if shapely.Polygon(zone.outline).contains(shapely.Point(x, y))]  # fmt: skip
        found.append(
            PlacedGroup(
                id=name, demand=mine[0].function, space=hall.space.id,
                zone=inside[0] if inside else hall.names[0], pattern="single",
                pose=(float(x), float(y), mine[0].pose.heading),
                parts=(Part("single", (Layer(len(mine), 0.0, 0.0),)),),
                objects=tuple(piece.id for piece in mine),
            )
        )  # fmt: skip
    return tuple(found)


def _parts(pattern: str, layers: Floats, extra: float, count: int) -> tuple[Part, ...]:
    if pattern == "wall":
        return (Part("wall", (Layer(count, extra, 0.0),)),)
    if pattern == "single":
        return (Part("single", (Layer(count, 0.0, 0.0),)),)
    parts: list[Part] = []
    for number in np.unique(layers[:, PART]):
        rows = layers[layers[:, PART] == number]
        parts.append(
            Part(
                NAMES[int(rows[0, CODE])],
                tuple(Layer(int(r[NUMBER]), float(r[ALONG]), float(r[ACROSS])) for r in rows),
                extra if pattern == "fan" else 0.0,
            )
        )
    return tuple(parts)


def _pose(pattern: str, pose: Floats, pieces: tuple[Piece, ...]) -> tuple[float, float, float]:
    if pattern not in ("wall", "single"):
        return (float(pose[0]), float(pose[1]), _wrapped(float(pose[2])))
    x, y = np.mean([piece.pose[:2] for piece in pieces], axis=0)
    return (float(x), float(y), pieces[0].pose.heading)


def _wrapped(angle: float) -> float:
    return (angle + math.pi) % (2 * math.pi) - math.pi
