"""Planters and trees in pots: in pairs beside ways in and stages, else at ends of benches, in
corners, at walls."""

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
from scenewright.domains.hall.problem import Floats

FRAMED, SEATS = ("stage", "screen"), ("bench",)
"""What planters stand beside at both sides, and at whose ends."""
GAPS = (0.3, 0.6)
"""Metres between a planter and the door or stage beside which it stands."""
PAIR, RANK, LATER = 0.0, 0.3, 0.15
"""What a spot of a pair costs, and more for each door after the main entrance and a wider gap."""
BENCH, CORNER, WALL = 1.3, 1.0, 2.0
"""What a spot costs at the end of a bench, in a corner, and at a wall."""
IN_CORNER, END = 0.3, 0.12
"""Metres from the end of a wall that count as its corner, and from a bench."""
NEAR, CROWD = 4.0, 0.3
"""Within how many metres planters are too many, and what each metre of that costs."""


def find_planter_spots(setting: Setting, size: Size) -> Spots:
    """Spots for the next planter, cheaper away from those that stand."""
    pairs = [_frame_doors(setting, size), _frame_stages(setting, size)]
    found = join_spots([*pairs, _end_benches(setting, size), _line_walls(setting, size)])
    crowd = CROWD * measure_crowd(found.boxes, setting.others, NEAR)
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
    parts = [_end(p, size) for p in setting.pieces if p.category in SEATS]
    return make_spots(np.concatenate([np.zeros((0, 5)), *parts]), BENCH)


def _end(bench: Piece, size: Size) -> Floats:
    c, s = np.cos(bench.pose.heading), np.sin(bench.pose.heading)
    off = (0.5 * (bench.size.width + size.width) + END) * np.array([s, -c])
    middle = np.array(bench.pose[:2])
    return face(np.array([middle - off, middle + off]), bench.pose.heading, size)


def _line_walls(setting: Setting, size: Size) -> Spots:
    boxes, far = line_walls(setting.walls, size)
    return make_spots(boxes, np.where(far < IN_CORNER, CORNER, WALL))
