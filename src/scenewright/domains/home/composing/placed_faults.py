"""What is wrong with how groups stand: before windows, adrift, too short for their wall."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import FurnishedGroup
from scenewright.domains.home.composing.forms import cost_of_case
from scenewright.domains.home.furnishing.enlarge import OVERHANG, SOFAS
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.settings import ComposingSettings
from scenewright.geometry.boxes import common_area, make_frame
from scenewright.geometry.fit import side_gaps

Floats = NDArray[np.float64]

_SEATS = ("sofa", "corner_sofa", "loveseat", "armchair")
_BEDS = ("single_bed", "double_bed", "bunk_bed")
_CHESTS = ("chest_of_drawers", "sideboard", "tv_stand", "bookcase", "wardrobe", "shelf_unit")
SHADES = frozenset((*_SEATS, *_BEDS, *_CHESTS, "hob_cabinet"))
"""What takes a window's light, or is not to stand in it."""
AT_WALL = 0.12  # a bed's side nearer than this is at its wall, metres
SHELVED = 0.75  # share of the longest wall that shelves of a storage room stand along
FARTHEST = 3.1  # a screen is watched from so many of its widths at most
SEEN = 0.02  # less of an opening that something stands before is not seen, metres


def cost_of_group(group: FurnishedGroup, ground: Ground, rule: ComposingSettings) -> float:
    """What is wrong with one group as it stands, each fault half for being there and half by its
    degree, by the costs of ``rule``."""
    found: list[tuple[float, float]] = []
    covered = (rule.costs.window, rule.costs.opening)
    for piece in group.pieces:
        if piece.pose.z > AT_WALL or piece.category == "rug":
            continue
        for strip in ground.strips:
            window = strip[5] == 1.0
            if not window or piece.category in SHADES:
                share = _metres_before(piece, strip)
                if share > SEEN:
                    found.append((covered[0 if window else 1], min(share, 1.0)))
        if piece.category == "single_bed":
            gap = min(side_gaps(_box(piece), ground.walls))
            found.append((rule.costs.adrift * (gap > AT_WALL), 1.0))
    standing = sum(cost * (1.0 + degree) / 2 for cost, degree in found)
    return standing + cost_of_case(group.dressed.case, ground.area, rule)


def _box(piece: Piece) -> Floats:
    pose, size = piece.pose, piece.size
    return np.array([pose.x, pose.y, pose.heading, size.width, size.depth])


def _metres_before(piece: Piece, strip: Floats) -> float:
    """Metres of an opening that a piece stands before."""
    return float(common_area(make_frame(*_box(piece)), make_frame(*strip[:5])) / strip[4])


def are_adrift(case: Group, boxes: Floats, walls: Floats) -> NDArray[np.bool_]:
    """On which of the boxes (n, 5) of a case neither long side of its single bed is at a wall."""
    bed = next(m for m in case.members if m.category == "single_bed")
    if abs(np.sin(bed.heading)) > 0.5:
        return np.zeros(len(boxes), bool)
    left, right = (case.width / 2 + sign * bed.x - bed.size.width / 2 for sign in (1, -1))
    gaps = np.array([side_gaps(box, walls) for box in boxes])
    return np.asarray(np.minimum(gaps[:, 0] + left, gaps[:, 1] + right) > AT_WALL)


def cost_of_screen(groups: Sequence[FurnishedGroup], cost: float) -> float:
    """What is wrong with a stand too narrow for a screen that is large enough for its distance."""
    stand = next((p for g in groups for p in g.pieces if p.category == "tv_stand"), None)
    seats = [p for g in groups for p in g.pieces if p.category in SOFAS]
    if stand is None or not seats:
        return 0.0
    away = min(hypot(p.pose.x - stand.pose.x, p.pose.y - stand.pose.y) for p in seats)
    short = 1.0 - (stand.size.width + OVERHANG) * FARTHEST / away
    return cost * (1.0 + short) / 2 if short > 0.0 else 0.0


def cost_of_shelves(groups: Sequence[FurnishedGroup], ground: Ground, cost: float) -> float:
    """What is wrong with the shelves of a storage room that stand along less of its longest wall
    than :data:`SHELVED`."""
    shelves = [p for g in groups if g.wish.group == "storage" for p in g.pieces]
    if not shelves:
        return 0.0
    walls = ground.walls
    longest = float(np.hypot(walls[:, 2] - walls[:, 0], walls[:, 3] - walls[:, 1]).max())
    short = 1.0 - sum(p.size.width for p in shelves) / (SHELVED * longest)
    return cost * (1.0 + short) / 2 if short > 0.0 else 0.0
