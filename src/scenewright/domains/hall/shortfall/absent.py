"""What found no place is tried again beside all that did: it may have been given up for something
that found no place itself, or for walls that were not built yet."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.zoning.assign import Unit


def list_absent(
    wishes: Sequence[HallDemand], units: Sequence[Unit], names: Sequence[str]
) -> list[Unit]:
    """What has no place, as units in each of the zones it may go to: all that a demand lacks
    together, or one of it.

    >>> from scenewright.core.scene import Size
    >>> box = HallDemand("b", "b", "lockers", (Size(1, 0.5, 2),) * 3, (0,) * 4, (), (), "", True)
    >>> [unit[1:] for unit in list_absent([box], [Unit(0, 0, 0, 1)], ["hall"])]
    [(0, 1, 3), (0, 1, 2)]
    """
    found = list[Unit]()
    for number, wish in enumerate(wishes):
        there = sorted((u.first, u.last) for u in units if u.demand == number)
        gaps = _list_gaps(there, len(wish.sizes))
        if 0 < wish.least <= len(wish.sizes) - sum(b - a for a, b in gaps):
            continue
        zones = [names.index(zone) for zone in wish.zones] or list(range(len(names)))
        together = [gap for gap in gaps if wish.patterns != ("single",) and gap[1] > gap[0] + 1]
        runs = [*together, *((first, first + 1) for first, _ in gaps)]
        found += [Unit(number, zone, *run) for run in runs for zone in zones]
    return found


def _list_gaps(there: Sequence[tuple[int, int]], count: int) -> list[tuple[int, int]]:
    """The runs of numbers below ``count`` that are in none of some runs in order."""
    ends = [0, *(last for _, last in there)]
    starts = [*(first for first, _ in there), count]
    return [(a, b) for a, b in zip(ends, starts, strict=True) if a < b]
