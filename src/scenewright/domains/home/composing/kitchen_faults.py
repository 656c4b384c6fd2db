"""What is wrong with a kitchen beside its run: its table, what stands away from the units."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, sin

from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import FurnishedGroup
from scenewright.domains.home.composing.case_faults import IN_LINE, RAISED, RUN
from scenewright.domains.home.composing.forms import share_in
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.settings import ComposingSettings

EAT_IN, FOUR = 9.0, 4  # square metres of a kitchen whose table seats so many
PLACES = ("dining_chair", "stool")
ALIKE = 0.99  # cosine between headings that are one, at least
TOGETHER = 0.06  # pieces nearer to one another than this stand together, metres


def cost_of_table(groups: Sequence[FurnishedGroup], ground: Ground, cost: float) -> float:
    """What is wrong with a table for fewer than four in a kitchen of :data:`EAT_IN` square
    metres."""
    if ground.area < EAT_IN:
        return 0.0
    tables = [g for g in groups if g.wish.group in ("dining", "dining_wall")]
    seats = (sum(p.category in PLACES for p in g.pieces) for g in tables)
    return sum(cost * max(0.0, 1.0 - count / FOUR) for count in seats)


def cost_of_washer(groups: Sequence[FurnishedGroup], cost: float) -> float:
    """What is wrong with a washing machine in a kitchen with no unit of the run at its side."""
    return cost * _is_away(groups, "washer")


def cost_of_fridge(
    groups: Sequence[FurnishedGroup], ground: Ground, rule: ComposingSettings
) -> float:
    """What is wrong with a fridge of its own that stands away from the units one cooks at."""
    return (
        rule.costs.fridge_alone * share_in(ground.area, "fridge_alone") * _is_away(groups, "fridge")
    )


def _is_away(groups: Sequence[FurnishedGroup], name: str) -> bool:
    """Whether there are units in the other groups, but none at the side of the group so named."""
    own = next((g for g in groups if g.wish.group == name), None)
    if own is None:
        return False
    others = (p for g in groups if g is not own for p in g.pieces)
    units = [p for p in others if p.category in RUN and p.pose.z < RAISED]
    return bool(units) and not any(_stand_together(p, u) for p in own.pieces for u in units)


def _stand_together(one: Piece, other: Piece) -> bool:
    """Whether two pieces stand side by side along a wall and touch."""
    dx, dy = other.pose.x - one.pose.x, other.pose.y - one.pose.y
    s, c = sin(one.pose.heading), cos(one.pose.heading)
    gap = abs(dx * s - dy * c) - (one.size.width + other.size.width) / 2
    alike = cos(one.pose.heading - other.pose.heading) > ALIKE
    return alike and abs(gap) < TOGETHER and abs(dx * c + dy * s) < IN_LINE
