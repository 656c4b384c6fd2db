"""Planters and trees in pots: in pairs beside ways in and stages, else at ends of benches, in
corners, at walls and partitions, at ends of desks, gates and lockers, and on in a row with others:
never in the open floor as long as one of these is free."""

from __future__ import annotations

import numpy as np

from scenewright.core.scene import Piece, Size
from scenewright.domains.hall.accessories.setting import Setting
from scenewright.domains.hall.accessories.spots import (
    Spots,
    face,
    flank,
    join_spots,
    line_walls,
    make_spots,
    measure_crowd,
)
from scenewright.domains.hall.classes import FRAMED, SERVING
from scenewright.domains.hall.problem import Floats

SEAT = "bench"
"""At whose ends planters stand."""
GAPS = (0.3, 0.6)
"""Metres between a planter and the door or stage beside which it stands."""
PAIR, RANK, LATER = 0.0, 0.3, 0.15
"""What a spot of a pair costs, and more for each door after the main entrance and a wider gap."""
EDGED = (*SERVING, "ticket_gate", "lockers")
"""Kinds whose ends planters border."""
BENCH, PLANTER_CORNER, PLANTER_WALL, PLANTER_EDGE, IN_ROW = 1.3, 1.0, 2.0, 2.3, 3.0
"""What a spot costs at the end of a bench, in a corner, at a wall, at the end of a desk, and on in
a row with planters."""
IN_CORNER, PLANTER_END, PLANTERS_TOUCH = 0.3, 0.12, 0.02
"""Metres from the end of a wall that count as its corner, from a bench, and between planters of a
row."""
PLANTERS_WITHIN, PLANTERS_CROWD = 4.0, 0.3
"""Within how many metres planters are too many, and what each metre of that costs."""


def find_planter_spots(setting: Setting, size: Size) -> Spots:
    """Spots for the next planter, cheaper away from those that stand."""
    pairs = [_frame_doors(setting, size), _frame_stages(setting, size)]
    edges = _border(setting, size), _go_on(setting, size)
    found = join_spots([*pairs, _end_benches(setting, size), _line_walls(setting, size), *edges])
    crowd = PLANTERS_CROWD * measure_crowd(found.boxes, setting.others, PLANTERS_WITHIN)
    return found._replace(costs=found.costs + crowd)


def _frame_doors(setting: Setting, size: Size) -> Spots:
    """To both sides of doors, their backs at the wall."""
    parts = [make_spots(np.zeros((0, 5)), 0.0)]
    for k, door in enumerate(setting.doorways):
        boxes = flank(door.middle, door.inward, door.width, GAPS, size)
        parts.append(_number(boxes, PAIR + RANK * k, 2 * k))
    return join_spots(parts)


def _frame_stages(setting: Setting, size: Size) -> Spots:
    """To both sides of stages and screens, in line with their backs."""
    first = 2 * len(setting.doorways)
    parts = [make_spots(np.zeros((0, 5)), 0.0)]
    for k, piece in enumerate(p for p in setting.pieces if p.category in FRAMED and not p.on):
        front = np.array([np.cos(piece.pose.heading), np.sin(piece.pose.heading)])
        back = np.array(piece.pose[:2]) - 0.5 * piece.size.depth * front
        boxes = flank(back, front, piece.size.width, GAPS, size)
        parts.append(_number(boxes, PAIR + RANK, first + 2 * k))
    return join_spots(parts)


def _number(boxes: Floats, cost: float, first: int) -> Spots:
    """Spots of pairs of boxes (2 g, 5), one after another."""
    which = np.arange(len(boxes)) // 2
    costs = cost + LATER * which.astype(np.float64)
    return make_spots(boxes, costs, first + which)


def _end_benches(setting: Setting, size: Size) -> Spots:
    """In line with benches, at both ends of each."""
    parts = [_end(p, size) for p in setting.pieces if p.category == SEAT]
    return make_spots(np.concatenate([np.zeros((0, 5)), *parts]), BENCH)


def _end(bench: Piece, size: Size) -> Floats:
    c, s = np.cos(bench.pose.heading), np.sin(bench.pose.heading)
    off = (0.5 * (bench.size.width + size.width) + PLANTER_END) * np.array([s, -c])
    middle = np.array(bench.pose[:2])
    return face(np.array([middle - off, middle + off]), bench.pose.heading, size)


def _line_walls(setting: Setting, size: Size) -> Spots:
    faces = [_list_faces(piece) for piece in setting.pieces if piece.category == "partition"]
    boxes, far = line_walls(np.concatenate([setting.walls, *faces]), size)
    return make_spots(boxes, np.where(far < IN_CORNER, PLANTER_CORNER, PLANTER_WALL))


def _list_faces(partition: Piece) -> Floats:
    """Both faces (2, 4) of a partition, what is before them on the left."""
    front = np.array([np.cos(partition.pose.heading), np.sin(partition.pose.heading)])
    left, middle = np.array([-front[1], front[0]]), np.array(partition.pose[:2])
    off, half = 0.5 * partition.size.depth * front, 0.5 * partition.size.width * left
    ends = middle + off + half, middle + off - half, middle - off - half, middle - off + half
    return np.array(ends).reshape(2, 4)


def _border(setting: Setting, size: Size) -> Spots:
    """At both ends of desks, gates and lockers, in line with their backs."""
    parts = [np.zeros((0, 5))]
    for piece in setting.pieces:
        if piece.category in EDGED:
            front = np.array([np.cos(piece.pose.heading), np.sin(piece.pose.heading)])
            back = np.array(piece.pose[:2]) - 0.5 * piece.size.depth * front
            parts.append(flank(back, front, piece.size.width, (PLANTER_END,), size))
    return make_spots(np.concatenate(parts), PLANTER_EDGE)


def _go_on(setting: Setting, size: Size) -> Spots:
    """End to end with planters that stand."""
    parts = [np.zeros((0, 5))]
    for x, y, heading, wide, _ in setting.others:
        along = (0.5 * (wide + size.width) + PLANTERS_TOUCH) * np.array(
            [np.sin(heading), -np.cos(heading)]
        )
        parts.append(face(np.array([x, y]) + np.array([along, -along]), heading, size))
    return make_spots(np.concatenate(parts), IN_ROW)
