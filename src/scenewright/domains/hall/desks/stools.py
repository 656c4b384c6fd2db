"""High tables and counters beside which bar stools are asked for keep the floor of these."""

from __future__ import annotations

from scenewright.domains.hall.accessories.stools import (
    COUNTER,
    OFF,
    STOOL,
    count_around,
    count_before,
    is_bar,
    may_sit_at,
    sits_around,
)
from scenewright.domains.hall.demands.holdings import HallDemand, may_stand_together, with_floor


def keep_stools(wishes: list[HallDemand]) -> list[HallDemand]:
    """Demands in which bars, then high tables, then other counters also take up the floor of their
    stools: those of the stools' own zones first, until all have a place."""
    found = {wish.id: wish for wish in wishes}
    for stools in (wish for wish in wishes if wish.category == STOOL and wish.unstated):
        left = len(stools.sizes)
        near = [w for w in wishes if _rank(w) and may_stand_together(w, stools)]
        near.sort(key=lambda wish: (wish.zones != stools.zones, _rank(wish)))
        for one in near:
            if left > 0:
                deep = max(size.depth for size in stools.sizes) + OFF
                found[one.id] = _widen(found[one.id], deep)
                left -= _count_places(one)
    return list(found.values())


def _rank(wish: HallDemand) -> int:
    """1 for bars, 2 for high tables, 3 for other counters, 0 for what one does not sit at high."""
    if wish.category == COUNTER:
        return 1 if is_bar(wish.id) else 3
    return 2 if may_sit_at(wish.category, wish.sizes[0].height) else 0


def _count_places(wish: HallDemand) -> int:
    if wish.category == COUNTER:  # side by side
        return count_before(sum(size.width for size in wish.sizes))
    return sum(count_around(size) for size in wish.sizes)


def _widen(wish: HallDemand, out: float) -> HallDemand:
    """Counters with ``out`` metres more before them, tables at the sides at which stools stand."""
    if wish.category != COUNTER:
        return with_floor(wish, out, all(sits_around(size) for size in wish.sizes))
    more = max(out - wish.before, 0.0)
    sizes = tuple(size._replace(depth=size.depth + more) for size in wish.sizes)
    return wish._replace(sizes=sizes, before=wish.before + more)
