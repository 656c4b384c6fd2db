"""What is shown singly stands in companies of three to five with floor between them, not in a
formation stretched over its zone (Morgan 2011, Visual Merchandising: odd groups, staggered)."""

from __future__ import annotations

from scenewright.domains.hall.classes import SHOWN_SINGLY
from scenewright.domains.hall.demands.holdings import HallDemand, LoungePart
from scenewright.domains.hall.measures import AISLE
from scenewright.domains.hall.seats.lounges import lay_as_one

FEWEST_SHOWN, COMPANY_SIZE = 6, 4
"""From how many on they stand in companies, and how many these have, about."""


def group_shown(wish: HallDemand) -> HallDemand:
    """A demand whose objects are companies of three to five; as it is where the brief says how they
    stand, or of few."""
    if wish.category not in SHOWN_SINGLY or not wish.unplaced or len(wish.sizes) < FEWEST_SHOWN:
        return wish
    number = round(len(wish.sizes) / COMPANY_SIZE)
    alone = wish._replace(least=0)
    companies = [_stagger(alone, k, number) for k in range(number)]
    return lay_as_one(wish, companies)._replace(
        clearance=(0.5 * AISLE,) * 4,
        patterns=("chain", "grid") if number > 1 else ("single",),
        aisle=AISLE,
    )


def _stagger(wish: HallDemand, first: int, step: int) -> tuple[LoungePart, ...]:
    """Every ``step``-th object from the ``first`` on in two rows, those behind beside the gaps of
    those before."""
    sizes = wish.sizes[first::step]
    wide = max(size.width for size in sizes) + max(wish.clearance)
    deep = max(size.depth for size in sizes) + max(wish.clearance)
    before = len(sizes) // 2
    shift = 0.5 * wide if len(sizes) % 2 == 0 else 0.0
    found = []
    for k, size in enumerate(sizes):
        count, at = (before, k) if k < before else (len(sizes) - before, k - before)
        along = (at - 0.5 * (count - 1)) * wide + (0.5 * shift if k < before else -0.5 * shift)
        found.append(LoungePart(wish, size, along=along, ahead=deep if k < before else 0.0))
    return tuple(found)
