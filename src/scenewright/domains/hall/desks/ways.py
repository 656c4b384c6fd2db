"""Ways between desks of one group: each is for one person, who gets up without others."""

from __future__ import annotations

from collections.abc import Iterator

from scenewright.catalog.kinds import hall_use
from scenewright.catalog.kinds.usual import DESKS
from scenewright.core.scene import Size
from scenewright.domains.hall.build_problem import HallContext, zone_areas
from scenewright.domains.hall.demands.holdings import SEATWAY, HallDemand
from scenewright.domains.hall.desks.chairs import ADVISING

WAY_PAST, DESKS_APART = 0.6, 1.2
"""Metres between the sides of two desks: one person passes; customers of two do not hear each
other's talk."""
SEATED = 0.55
"""How far chairs stand out on both sides of a desk at which customers sit, in metres."""
FULL_WAY, FULLEST = 0.5, 0.65
"""Of the floor of their zones, what desks with their ways and free floor take at most, and where
nothing is lost by it."""


def part_desks(hall: HallContext, wishes: list[HallDemand]) -> list[HallDemand]:
    """Demands with floor beside each of several desks, and on both sides of those for advice; as
    they are where that is more than half of the floor, for what has a pattern or free sides of its
    own, and where groups stay as printed."""
    if hall.settings.whole:
        return wishes
    areas = dict(zip(hall.names, zone_areas(hall), strict=True))
    return [_part(wish, areas) for wish in wishes]


def _part(wish: HallDemand, areas: dict[str, float]) -> HallDemand:
    """One demand, parted where it is of several desks and its zones of some areas hold that."""
    parted = _with_way(wish) if _is_open(wish) else wish
    return parted if _measure_share(parted, areas) <= FULL_WAY else wish


def list_parted(hall: HallContext, wish: HallDemand) -> Iterator[HallDemand]:
    """Desks with floor beside each that take more than half of their zones so: to be tried."""
    if _is_open(wish) and not wish.aside:
        parted, areas = _with_way(wish), dict(zip(hall.names, zone_areas(hall), strict=True))
        if FULL_WAY < _measure_share(parted, areas) <= FULLEST:
            yield parted


def _is_open(wish: HallDemand) -> bool:
    """Whether a demand is of several desks without a pattern or free sides of its own, that look
    at nothing: in rows before a screen one gets up to the way behind."""
    usual = hall_use(wish.category)
    own = set(wish.patterns) != set(usual.patterns) or wish.clearance[1::2] != usual.clearance[1::2]
    return wish.category in DESKS and len(wish.sizes) > 1 and not (own or wish.turned)


def _measure_share(wish: HallDemand, areas: dict[str, float]) -> float:
    """How much of the floor of its zones, of some areas, a demand takes with its free floor."""
    front, left, back, right = wish.clearance
    taken = sum((size.width + left + right) * (size.depth + front + back) for size in wish.sizes)
    return taken / max(sum(areas[name] for name in wish.zones or areas), 1e-9)


def _with_way(wish: HallDemand) -> HallDemand:
    """Desks with half of the way on either side, and the floor of the chairs that come with desks
    for advice."""
    advising = any(word in f"{wish.id} {wish.name}".casefold() for word in ADVISING)
    aside = 0.5 * (DESKS_APART if advising else WAY_PAST)
    chairs = SEATED if advising and not wish.seated else 0.0
    sizes = tuple(
        Size(size.width + 2.0 * aside, size.depth + 2.0 * chairs, size.height)
        for size in wish.sizes
    )
    parted = wish._replace(sizes=sizes, aside=aside, chairs=chairs)
    if not chairs:
        return parted
    _, left, _, right = wish.clearance
    return parted._replace(clearance=(SEATWAY, left, SEATWAY, right))
