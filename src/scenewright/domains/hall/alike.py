"""Rooms that are to be like another: wards, hotel rooms, classrooms of one row.

A room with ``like`` holds what the other does. That is laid out once; its pieces are carried over
by the door, turned or mirrored, whichever lets the floors cover each other best, moved to a wall
that lies a little farther or nearer, and what then stands free is kept. The rest is laid out anew
around it, and every difference is told.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import product
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.building.door_approach import DoorApproach, door_zone, gates
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece, Pose
from scenewright.core.space import Space
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.problem import Floats

PARTITION = "partition"
BACK_AT_WALL, FARTHER, TINY = 0.06, 0.8, 0.01
"""How near to a wall a back stands at it, by how much farther or nearer that wall may be elsewhere,
and square metres that may overlap; metres."""
LEAST_COVER = 0.5
"""The least share of two floors together that both cover, for one to be like the other."""
MOST_TOLD = 4


class Isometry(NamedTuple):
    """x -> turn @ x + shift; ``mirrored`` where left becomes right."""

    turn: Floats
    shift: Floats
    mirrored: bool


class Alike(NamedTuple):
    """The pieces of another room that stand in this one, and what is to be said of it."""

    pieces: tuple[Piece, ...]
    told: str


def carry_over(
    model: Space, hall: HallContext, pieces: Sequence[Piece], asked: Collection[str]
) -> Alike:
    """The pieces of a room that belong to demands ``asked`` for, carried over to a hall as far as
    they stand free there."""
    space = hall.space
    best, share = max(
        ((way, _cover(model, space, way)) for way in _list_ways(model, space)), key=lambda r: r[1]
    )
    if share < LEAST_COVER:
        return Alike((), f"{space.id} is not laid out like {model.id}: its floor is another")
    mine = {p.group for p in pieces if p.function in asked}
    wanted = [p for p in pieces if p.group in mine and p.function != PARTITION]
    carried = [_carry(piece, best, model, space) for piece in wanted]
    kept, lost, moved = list[Piece](), list[str](), list[str]()
    for piece, way in carried:
        met = [other for other in kept if way > BACK_AT_WALL and not _belong(piece, other)]
        if _is_beside_lost(piece, lost) or not _stands_free(hall, piece, met):
            lost.append(piece.id)
            continue
        kept.append(piece)
        moved += [piece.id] if way > BACK_AT_WALL else []
    return Alike(tuple(kept), _describe(model, space, best, kept, moved, lost))


def _list_ways(model: Space, space: Space) -> Iterator[Isometry]:
    """Door upon door, and the middles of the floors upon each other, plain and mirrored."""
    for one, other in product(_frames(model), _frames(space)):
        for mirrored in (False, True):
            yield _move(one, other, mirrored)


def _frames(space: Space) -> list[tuple[Floats, Floats]]:
    """Points of a room with a direction: its doors, else its middle and the four directions."""
    doors = [(g.face, g.inward) for g in gates(space) if g.opening.kind != "window"]
    middle = np.array(shapely.Polygon(space.outline).centroid.coords[0])
    edge = space.outline[1] - space.outline[0]
    first = edge / np.hypot(*edge)
    turned = np.array([[first[0], first[1]], [-first[1], first[0]]])
    return doors or [(middle, side) for way in turned for side in (way, -way)]


def _move(one: tuple[Floats, Floats], other: tuple[Floats, Floats], mirrored: bool) -> Isometry:
    (start, ahead), (end, way) = one, other
    side = np.array([[ahead[0], -ahead[1]], [ahead[1], ahead[0]]])
    flip = np.diag([1.0, -1.0 if mirrored else 1.0])
    onto = np.array([[way[0], -way[1]], [way[1], way[0]]])
    turn = onto @ flip @ side.T
    return Isometry(turn, end - turn @ start, mirrored)


def _cover(model: Space, space: Space, way: Isometry) -> float:
    """The share of both floors together that both cover."""
    moved = shapely.Polygon(model.outline @ way.turn.T + way.shift)
    floor = shapely.Polygon(space.outline)
    return float(floor.intersection(moved).area / max(floor.union(moved).area, 1e-9))


def _carry(piece: Piece, way: Isometry, model: Space, space: Space) -> tuple[Piece, float]:
    """A piece in the other room, at its wall if it was at one, and by how much it moved to that."""
    x, y = way.turn @ np.array(piece.pose[:2]) + way.shift
    front = way.turn @ np.array([math.cos(piece.pose.heading), math.sin(piece.pose.heading)])
    name = piece.id.replace(f"{model.id}/", f"{space.id}/", 1)
    group = piece.group.replace(f"{model.id}/", f"{space.id}/", 1)
    on = None if piece.on is None else piece.on.replace(f"{model.id}/", f"{space.id}/", 1)
    pose = Pose(float(x), float(y), piece.pose.z, math.atan2(front[1], front[0]))
    moved = replace(piece, id=name, group=group, on=on, space=space.id, pose=pose, fixed=False)
    behind = _find_behind(piece, model)
    step = _find_behind(moved, space) - behind if behind <= BACK_AT_WALL else 0.0
    if abs(step) > FARTHER:
        return moved, 0.0
    at = pose._replace(x=pose.x - step * float(front[0]), y=pose.y - step * float(front[1]))
    return replace(moved, pose=at), abs(step)


def _find_behind(piece: Piece, space: Space) -> float:
    """Metres from the back of a piece to the wall behind it, below 0 where it stands in it."""
    front = np.array([math.cos(piece.pose.heading), math.sin(piece.pose.heading)])
    start = np.array(piece.pose[:2])
    ray = shapely.LineString([start, start - 100.0 * front])
    met = ray.intersection(shapely.Polygon(space.outline, list(space.holes)).boundary)
    far = shapely.Point(start).distance(met) if not met.is_empty else 100.0
    return float(far - 0.5 * piece.size.depth)


def _is_beside_lost(piece: Piece, lost: Sequence[str]) -> bool:
    """Whether a piece belongs to one that is not there: a chair of a table, a thing on it."""
    return any(piece.id.startswith(f"{name}/") or piece.on == name for name in lost)


def _belong(one: Piece, other: Piece) -> bool:
    """Whether one of two pieces goes under or beside the other, as chairs do at a table."""
    return one.id.startswith(f"{other.id}/") or other.id.startswith(f"{one.id}/")


def _stands_free(hall: HallContext, piece: Piece, others: Sequence[Piece]) -> bool:
    """Whether a piece stands on the floor of a hall, not in its door zones nor in others."""
    if piece.on is not None:
        return True
    shape = shapely.union_all(shapely.polygons(corners(np.array(boxes_of(piece)))))
    floor = shapely.Polygon(hall.space.outline, list(hall.space.holes))
    if shape.difference(floor).area > TINY:
        return False
    zones = [box for gate in gates(hall.space) for box in _keep_free(hall.space, gate)]
    stand = [list(box) for other in (*hall.fixed, *others) for box in boxes_of(other)]
    taken = shapely.polygons(corners(np.array([*zones, *stand]).reshape(-1, 5)))
    return not (shapely.area(shapely.intersection(taken, shape)) > TINY).any()


def _keep_free(space: Space, gate: DoorApproach) -> list[list[float]]:
    return [] if gate.opening.kind == "window" else door_zone(space, gate)


def _describe(
    model: Space,
    space: Space,
    way: Isometry,
    kept: Sequence[Piece],
    moved: Sequence[str],
    lost: Sequence[str],
) -> str:
    """How a room is like another, and where it differs."""
    how = ", mirrored" if way.mirrored else ""
    text = f"{space.id} is laid out like {model.id}{how}: {len(kept)} pieces stand alike"
    for names, what in ((moved, "nearer to or farther from their wall"), (lost, "laid out anew")):
        if names:
            listed = ", ".join(names[:MOST_TOLD]) + ", …" * (len(names) > MOST_TOLD)
            text += f"; {len(names)} {what}: {listed}"
    return text
