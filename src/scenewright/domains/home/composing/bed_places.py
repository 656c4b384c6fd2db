"""Beds for one by the walls: a long side along one, the head at one or in its corner."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group, Member
from scenewright.domains.home.measures import AT_WALL
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.rules.bedroom import DEAD
from scenewright.domains.home.settings import ComposingSettings
from scenewright.geometry.flanks import measure_flank_gaps

Floats = NDArray[np.float64]

SINGLE = "single_bed"


def cost_of_bed_places(
    case: Group, boxes: Floats, ground: Ground, rule: ComposingSettings
) -> Floats:
    """What is wrong with a case of a single bed on each of boxes (n, 5) as it stands by the walls:
    adrift, or its head off them."""
    cost = rule.costs.adrift * are_adrift(case, boxes, ground.walls)
    bed = next(m for m in case.members if m.category == SINGLE)
    gaps = measure_head_gaps(place_member(bed, boxes), ground.walls)
    off = rule.costs.head_off * (1.0 + np.minimum(gaps / DEAD, 1.0)) / 2
    return np.asarray(cost + np.where(gaps > AT_WALL, off, 0.0))


def measure_head_gaps(boxes: Floats, walls: Floats) -> Floats:
    """Metres (n,) from the heads of beds, boxes (n, 5), to the nearest of ``walls`` (w, 4), the
    larger of two places of each."""
    turned = boxes[:, [0, 1, 2, 4, 3]] + [0.0, 0.0, np.pi / 2, 0.0, 0.0]
    return measure_flank_gaps(turned, walls)[:, 0]


def place_member(member: Member, boxes: Floats) -> Floats:
    """The boxes (n, 5) of a member of a case on boxes (n, 5)."""
    c, s = np.cos(boxes[:, 2]), np.sin(boxes[:, 2])
    return np.column_stack(
        (
            boxes[:, 0] + member.x * s + member.y * c,
            boxes[:, 1] - member.x * c + member.y * s,
            boxes[:, 2] + member.heading,
            np.full((len(boxes), 2), (member.size.width, member.size.depth)),
        )
    )


def are_adrift(case: Group, boxes: Floats, walls: Floats) -> NDArray[np.bool_]:
    """On which of the boxes (n, 5) of a case neither long side of its single bed is at a wall over
    most of its length."""
    bed = next(m for m in case.members if m.category == "single_bed")
    if abs(np.sin(bed.heading)) > 0.5:
        return np.zeros(len(boxes), bool)
    left, right = (case.width / 2 + sign * bed.x - bed.size.width / 2 for sign in (1, -1))
    gaps = measure_flank_gaps(boxes, walls)
    return np.asarray(np.minimum(gaps[:, 0] + left, gaps[:, 1] + right) > AT_WALL)
