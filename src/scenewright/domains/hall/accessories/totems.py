"""Totems and signs: before those who come in, beside their way and turned to them; those of a zone
without a way in beside its islands."""

from __future__ import annotations

from itertools import product

import numpy as np

from scenewright.core.scene import Size
from scenewright.domains.hall.accessories.setting import Doorway, Setting
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

AHEAD, ASIDE = (2.4, 3.2, 1.8, 1.4), (0.4, 0.9, 1.5, 2.2)
"""Metres inside a door and beside the way in at which a totem stands, the best first."""
WORSE, TOTEM_FURTHER = 0.1, 0.6
"""Costs of each place but the best, and of a door that is not the main entrance."""
LEAVING, TOTEM_ELSEWHERE = 1.0, 1.8
"""Costs of a spot beside a door where a totem looks into the hall, and of one at any wall."""
ISLAND, OF, TOTEM_NEXT = -0.8, "exhibit_island", 0.25
"""What a spot beside an island costs, which has too little floor around it always; what is one, and
metres between both."""
TOTEMS_WITHIN, TOTEMS_CROWD = 5.0, 0.5
"""Within how many metres totems say the same, and what each metre of that costs."""


def find_totem_spots(setting: Setting, size: Size) -> Spots:
    """Spots behind doors and beside them, one to each door first, beside islands, and at walls."""
    parts = [_turn_to(door, size, TOTEM_FURTHER * k) for k, door in enumerate(setting.doorways)]
    parts += [
        _stand_beside(door, size, TOTEM_FURTHER * k) for k, door in enumerate(setting.doorways)
    ]
    parts.append(_stand_by_islands(setting, size))
    parts.append(make_spots(line_walls(setting.walls, size)[0], TOTEM_ELSEWHERE))
    found = join_spots(parts)
    return found._replace(
        costs=found.costs + TOTEMS_CROWD * measure_crowd(found.boxes, setting.others, TOTEMS_WITHIN)
    )


def _turn_to(door: Doorway, size: Size, cost: float) -> Spots:
    """Spots inside a door people come in by, to both sides of their way."""
    if not door.entrance:
        return make_spots(np.zeros((0, 5)), 0.0)
    right = np.array([door.inward[1], -door.inward[0]])
    points, costs = list[Floats](), list[float]()
    for (k, ahead), (n, aside) in product(enumerate(AHEAD), enumerate(ASIDE)):
        off = 0.5 * (door.width + size.width) + aside
        points += [door.middle + ahead * door.inward + side * off * right for side in (1, -1)]
        costs += [cost + WORSE * (k + n)] * 2
    heading = float(np.arctan2(-door.inward[1], -door.inward[0]))
    return make_spots(face(np.array(points), heading, size), np.array(costs))


def _stand_beside(door: Doorway, size: Size, cost: float) -> Spots:
    """Spots at the wall to both sides of a door."""
    boxes = flank(door.middle, door.inward, door.width, ASIDE, size)
    return make_spots(boxes, LEAVING + cost)


def _stand_by_islands(setting: Setting, size: Size) -> Spots:
    """Beside islands at both ends of their fronts, turned as these are."""
    boxes = [np.zeros((0, 5))]
    for piece in (piece for piece in setting.pieces if piece.category == OF):
        front = np.array([np.cos(piece.pose.heading), np.sin(piece.pose.heading)])
        right = np.array([front[1], -front[0]])
        edge = np.array(piece.pose[:2]) + 0.5 * (piece.size.depth - size.depth) * front
        off = 0.5 * (piece.size.width + size.width) + TOTEM_NEXT
        ends = np.array([edge + off * right, edge - off * right])
        boxes.append(face(ends, piece.pose.heading, size))
    return make_spots(np.concatenate(boxes), ISLAND)
