"""Aisles across rows: the pieces of a row between two of them are laid out as one object.

So every layout of the search has rows broken where the brief breaks them, and the aisles are floor
like any other: people, tours and the referee go through them.
"""

from __future__ import annotations

from scenewright.domains.hall.demands.holdings import HallDemand, LoungePart
from scenewright.domains.hall.seats.lounges import lay_as_one


def break_rows(wish: HallDemand) -> HallDemand:
    """A demand whose objects are each ``every`` pieces of a row between two aisles, the last
    the rest, with half an aisle free at both ends; as it is where no aisle is asked for."""
    if not wish.aisle or wish.chairs or wish.lounges:
        return wish
    front, left, back, right = wish.clearance
    gap, alone = max(left, right), wish._replace(every=0, aisle=0.0)
    blocks = [wish.sizes[k : k + wish.every] for k in range(0, len(wish.sizes), wish.every)]
    lines = []
    for sizes in blocks:
        at, line = 0.0, []
        for size in sizes:
            line.append(LoungePart(alone, size, along=at + 0.5 * size.width))
            at += size.width + gap
        lines.append(tuple(line))
    ends = 0.5 * wish.aisle
    clear = (front, max(left, ends), back, max(right, ends))
    return lay_as_one(wish, lines)._replace(
        clearance=clear, patterns=wish.patterns if len(lines) > 1 else ("single",)
    )
