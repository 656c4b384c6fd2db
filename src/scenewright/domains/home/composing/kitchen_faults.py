"""What is wrong with a kitchen beside its run: its table, what stands away from the units."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, hypot, sin

from scenewright.catalog.classes import EATING_TABLES, RUN
from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import FurnishedGroup
from scenewright.domains.home.composing.case_faults import IN_LINE
from scenewright.domains.home.composing.forms import share_in
from scenewright.domains.home.composing.modest import find_few_places
from scenewright.domains.home.composing.placed_faults import find_darkness, list_standing
from scenewright.domains.home.groups.classes import RUNS, TABLES
from scenewright.domains.home.measures import ALIKE, RAISED
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.settings import ComposingSettings, CompositionCosts
from scenewright.geometry.boxes import common_area, make_frame

APART = 0.3  # a wardrobe nearer than this to a table, or a screen to a run, is beside it, metres
AT_FRIDGE = 0.5  # what a machine beside the fridge costs of one away from all units
TOGETHER = 0.06  # pieces nearer to one another than this stand together, metres


def cost_of_table(
    groups: Sequence[FurnishedGroup], ground: Ground, costs: CompositionCosts
) -> float:
    """What is wrong with the table of a kitchen: fewer places than its room has by
    :data:`~.modest.SEATED`, how far it is from daylight, a wardrobe within :data:`APART` of it."""
    total = 0.0
    for group in groups:
        if group.wish.group in TABLES:
            total += costs.few_places * find_few_places(list_standing(group), ground.area)
            table = next((p for p in group.pieces if p.category in EATING_TABLES), None)
            total += costs.dim_table * find_darkness(table, ground) if table else 0.0
            total += costs.beside_clothes * _is_near_clothes(group, groups)
    return total


def cost_of_stand(groups: Sequence[FurnishedGroup], cost: float) -> float:
    """What is wrong with a screen whose stand is within :data:`APART` of a unit of the kitchen."""
    media = next((g for g in groups if g.wish.group == "media" and g.pieces), None)
    if media is None:
        return 0.0
    units = [p for g in groups if g.wish.group in RUNS for p in g.pieces if p.pose.z < RAISED]
    return cost * _is_near(media.dressed.box.tolist(), units)


def _is_near_clothes(table: FurnishedGroup, groups: Sequence[FurnishedGroup]) -> bool:
    """Whether a wardrobe stands within :data:`APART` of the floor of those who eat."""
    clothes = [p for g in groups if g.wish.group == "wardrobe" for p in g.pieces]
    return _is_near(table.dressed.box.tolist(), clothes)


def _is_near(box: list[float], pieces: Sequence[Piece]) -> bool:
    """Whether one of some pieces is within :data:`APART` of a box."""
    x, y, heading, width, depth = box
    wide, deep = width + 2 * APART, depth + 2 * APART
    for piece in pieces:
        (a, b, _, turn), size = piece.pose, piece.size
        if hypot(a - x, b - y) < (hypot(wide, deep) + hypot(*size[:2])) / 2:
            own = make_frame(a, b, turn, size.width, size.depth)
            if float(common_area(own, make_frame(x, y, heading, wide, deep))) > 0.0:
                return True
    return False


def cost_of_washer(groups: Sequence[FurnishedGroup], cost: float) -> float:
    """What is wrong with a washing machine in a kitchen with no unit of the run at its side, or
    with none but the fridge, which then no longer ends the run (:data:`AT_FRIDGE`)."""
    if is_away(groups, "washer", RUN - {"fridge"}):
        return cost * (1.0 if is_away(groups, "washer") else AT_FRIDGE)
    return 0.0


def cost_of_fridge(
    groups: Sequence[FurnishedGroup], ground: Ground, rule: ComposingSettings
) -> float:
    """What is wrong with a fridge of its own that stands away from the units one cooks at."""
    return (
        rule.costs.fridge_alone * share_in(ground.area, "fridge_alone") * is_away(groups, "fridge")
    )


def is_away(groups: Sequence[FurnishedGroup], name: str, kinds: frozenset[str] = RUN) -> bool:
    """Whether there are units of some kinds in the other groups, but none at the side of the group
    so named."""
    own = next((g for g in groups if g.wish.group == name), None)
    if own is None:
        return False
    others = (p for g in groups if g is not own for p in g.pieces)
    units = [p for p in others if p.category in kinds and p.pose.z < RAISED]
    return bool(units) and not any(_stand_together(p, u) for p in own.pieces for u in units)


def _stand_together(one: Piece, other: Piece) -> bool:
    """Whether two pieces stand side by side along a wall and touch."""
    dx, dy = other.pose.x - one.pose.x, other.pose.y - one.pose.y
    s, c = sin(one.pose.heading), cos(one.pose.heading)
    gap = abs(dx * s - dy * c) - (one.size.width + other.size.width) / 2
    alike = cos(one.pose.heading - other.pose.heading) > ALIKE
    return alike and abs(gap) < TOGETHER and abs(dx * c + dy * s) < IN_LINE
