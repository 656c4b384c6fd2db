"""What a hall lacks once it is laid out, and whether other forms of its counters may help."""

from __future__ import annotations

from scenewright.core.brief.zones import Demand
from scenewright.core.space import Space
from scenewright.domains.hall.desks.counter_forms import COUNTER
from scenewright.domains.hall.desks.unserved import count_unserved
from scenewright.domains.hall.furnishing.assemble import Laid
from scenewright.domains.hall.visit.visitor_plan import ROPES

NOTHING = 1e-6
"""Cost below which a fault counts as none."""


def leaves_open(demands: list[Demand]) -> bool:
    """Whether some demands leave open where several counters stand."""
    open_ones = (d for d in demands if d.category == COUNTER and d.place is None)
    return any(not demand.patterns and demand.count != 1 for demand in open_ones)


def falls_short(laid: Laid) -> bool:
    """Whether something is left out of a hall, or the route misses some of it or is too narrow."""
    return bool(laid.left_out) or measure_shortfall(laid)[0] > 0.0


def measure_shortfall(laid: Laid) -> tuple[float, int, int]:
    """What the route misses of a hall and passages lack, and less than none of how many objects
    stand, ropes by themselves: the greater, the worse."""
    missed = sum(part.cost for part in laid.parts if part.term in ("reach", "access"))
    stand = {name for group in laid.groups for name in group.objects}
    kinds = [piece.category in ROPES for piece in laid.pieces if piece.id in stand]
    return (missed if missed > NOTHING else 0.0), sum(kinds) - len(kinds), -sum(kinds)


def measure_shortfall_and_staff(space: Space, laid: Laid) -> tuple[float, int, int]:
    """:func:`measure_shortfall`, where a desk at which nobody can serve is as good as none."""
    missed, count, ropes = measure_shortfall(laid)
    return missed, count + count_unserved(space, laid.pieces), ropes
