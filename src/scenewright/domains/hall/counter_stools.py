"""Counters beside which bar stools are asked for keep the floor of these before them."""

from __future__ import annotations

from scenewright.domains.hall.accessories.stools import COUNTER, OFF, count_before
from scenewright.domains.hall.holdings import HallDemand, may_stand_together

STOOL = "bar_stool"


def keep_stools(wishes: list[HallDemand]) -> list[HallDemand]:
    """Demands of which counters take up the floor of the stools before them as well: those of the
    stools' own zones first, until all have a place."""
    found = {wish.id: wish for wish in wishes}
    for stools in (wish for wish in wishes if wish.category == STOOL and wish.unstated):
        left = len(stools.sizes)
        near = [w for w in wishes if w.category == COUNTER and may_stand_together(w, stools)]
        near.sort(key=lambda wish: wish.zones != stools.zones)
        for counters in near:
            if left > 0:
                deep = max(size.depth for size in stools.sizes) + OFF
                found[counters.id] = _deepen(found[counters.id], deep)
                left -= sum(count_before(size.width) for size in counters.sizes)
    return list(found.values())


def _deepen(wish: HallDemand, before: float) -> HallDemand:
    """Counters with so many metres more before them."""
    more = max(before - wish.before, 0.0)
    sizes = tuple(size._replace(depth=size.depth + more) for size in wish.sizes)
    return wish._replace(sizes=sizes, before=wish.before + more)
