"""Litter bins: at walls beside the doors people leave by and where they eat, one to each first."""

from __future__ import annotations

import numpy as np

from scenewright.core.scene import Size
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
from scenewright.domains.hall.classes import EATEN_AT
from scenewright.domains.hall.problem import Floats

GAPS = (0.6, 1.2)
"""Metres between a bin and the door beside which it stands."""
BIN_FURTHER, BIN_BESIDE, BIN_ELSEWHERE = 0.1, 0.15, 0.6
"""What a door counts that is not the main one, a spot at the end of a row of machines, and one at
any wall."""
LITTER_FAR, FARTHEST_BIN = 0.1, 12.0
"""What a metre from where litter comes from costs at walls, and the metres that count at most."""
BINS_WITHIN, BINS_CROWD = 9.0, 0.3
"""Within how many metres bins are too many, and what each metre of that costs."""


def find_bin_spots(setting: Setting, size: Size) -> Spots:
    """Spots for the next bin, cheaper away from those that stand."""
    boxes = line_walls(setting.walls, size)[0]
    walls = make_spots(boxes, BIN_ELSEWHERE + LITTER_FAR * _measure_way(setting, boxes))
    found = join_spots([*_flank_doors(setting, size), _end_machines(setting, size), walls])
    crowd = BINS_CROWD * measure_crowd(found.boxes, setting.others, BINS_WITHIN)
    return found._replace(costs=found.costs + crowd)


def _flank_doors(setting: Setting, size: Size) -> list[Spots]:
    """At the wall to both sides of each door, the nearer the better."""
    nearer = np.repeat(np.arange(len(GAPS), dtype=np.float64), 2)
    return [
        make_spots(
            flank(door.middle, door.inward, door.width, GAPS, size), BIN_FURTHER * (k + nearer)
        )
        for k, door in enumerate(setting.doorways)
    ]


def _end_machines(setting: Setting, size: Size) -> Spots:
    """Beside machines, their backs in line."""
    boxes = [np.zeros((0, 5))]
    for piece in setting.pieces:
        if piece.category == EATEN_AT[0]:
            heading = piece.pose.heading
            front = np.array([np.cos(heading), np.sin(heading)])
            right = np.array([front[1], -front[0]])
            back = np.array(piece.pose[:2]) - 0.5 * (piece.size.depth - size.depth) * front
            off = 0.5 * (piece.size.width + size.width) + 0.1
            boxes.append(face(np.array([back - off * right, back + off * right]), heading, size))
    return make_spots(np.concatenate(boxes), BIN_BESIDE)


def _measure_way(setting: Setting, boxes: Floats) -> Floats:
    """Metres (k,) from each of boxes (k, 5) to the nearest place litter comes from."""
    pieces = [piece.pose[:2] for piece in setting.pieces if piece.category in EATEN_AT]
    points = np.array([*pieces, *(door.middle for door in setting.doorways)]).reshape(-1, 2)
    off = boxes[:, None, :2] - points
    far: Floats = np.hypot(off[..., 0], off[..., 1]).min(1, initial=FARTHEST_BIN)
    return far
