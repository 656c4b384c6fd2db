"""Ropes round large islands, where nobody queues: along the long sides from the middle on, then
along the others, those of the largest island first."""

from __future__ import annotations

import numpy as np

from scenewright.core.scene import Piece, Size
from scenewright.domains.hall.accessories.benches import ISLAND, LARGE, is_large_island
from scenewright.domains.hall.accessories.setting import Setting
from scenewright.domains.hall.accessories.spots import Spots, face, join_spots, make_spots
from scenewright.domains.hall.classes import QUEUED_AT
from scenewright.domains.hall.demands.holdings import HallDemand, may_stand_together
from scenewright.domains.hall.problem import Floats

DESK = "info_desk"
"""So they do to this in a zone named for both."""
ROPE_GAP, ROPE_SPACE = 1.0, 0.05
"""Metres between an island and its ropes, and between two of them."""
OFF_LINE_OF_ROPES, SHORTEST_ROPE, ROPE_REACH = 0.01, 1.0, 5.0
"""What a metre off the middle of a side costs, one of the short sides, and the next island."""


def may_guard(wish: HallDemand, wishes: list[HallDemand]) -> bool:
    """Whether a large island may stand in a zone of ropes, and nothing one queues at."""
    beside = [other for other in wishes if may_stand_together(wish, other)]
    queued = any(
        other.category in QUEUED_AT or (other.category == DESK and bool(wish.zones))
        for other in beside
    )
    return not queued and any(map(is_large_island, beside))


def find_rope_spots(setting: Setting, size: Size) -> Spots:
    """Spots along all sides of the large islands that stand."""
    islands = [p for p in setting.pieces if p.category == ISLAND and max(p.size[:2]) >= LARGE]
    islands.sort(key=lambda p: -p.size.width * p.size.depth)
    parts = [make_spots(np.zeros((0, 5)), 0.0)]
    for rank, island in enumerate(islands):
        parts += [_line_side(island, side, size, ROPE_REACH * rank) for side in range(4)]
    return join_spots(parts)


def _line_side(island: Piece, side: int, size: Size, cost: float) -> Spots:
    """Spots in a line along one side of an island, counted from its front."""
    long, deep = island.size[:2] if side % 2 == 0 else island.size[1::-1]
    heading = island.pose.heading + 0.5 * np.pi * side
    front = np.array([np.cos(heading), np.sin(heading)])
    pitch = size.width + ROPE_SPACE
    count = max(int((long + ROPE_GAP) / pitch), 1)
    along: Floats = (np.arange(count, dtype=np.float64) - 0.5 * (count - 1)) * pitch
    points = np.array(island.pose[:2]) + (0.5 * (deep + size.depth) + ROPE_GAP) * front
    points = points + along[:, None] * np.array([front[1], -front[0]])
    return make_spots(
        face(points, heading, size),
        cost + SHORTEST_ROPE * (long < deep) + OFF_LINE_OF_ROPES * np.abs(along),
    )
