"""Trees of cuts: which straight cuts divide a floor into zones, in which order.

A tree is the number of a zone, or ``(axis, lower, higher)``: a cut across axis 0 (x) or 1 (y) of
the hall's frame with a tree for the part at lower and one for that at higher coordinates. Where
to cut follows from the areas (Otten 1982; Wong and Liu 1986 for floor plans of chips).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import permutations, product
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.hall.zoning.cuts import cut

Tree = int | tuple[int, "Tree", "Tree"]
Forest = tuple["Tree", ...]


class FloorPart(NamedTuple):
    """A part of the floor: its number and its polygon."""

    number: int
    shape: shapely.Polygon


Cuts = dict[tuple[int, int, float], "tuple[FloorPart, FloorPart] | None"]


def divide(
    piece: FloorPart, tree: Tree, areas: Sequence[float], cuts: Cuts
) -> dict[int, FloorPart] | None:
    """The piece of every zone of a tree, or None where a cut cannot be made. ``cuts`` remembers
    those made before."""
    if isinstance(tree, int):
        return {tree: piece}
    axis, low, high = tree
    low_area, high_area = area_of(low, areas), area_of(high, areas)
    share = round(low_area / (low_area + high_area), 9)
    key = (piece.number, axis, share)
    if key not in cuts:
        parts = cut(piece.shape, axis, share * piece.shape.area)
        count = 1000 + 2 * len(cuts)
        cuts[key] = parts and (FloorPart(count, parts[0]), FloorPart(count + 1, parts[1]))
    made = cuts[key]
    if made is None:
        return None
    below = divide(made[0], low, areas, cuts)
    above = divide(made[1], high, areas, cuts) if below is not None else None
    return None if below is None or above is None else below | above


def leaves(tree: Tree) -> tuple[int, ...]:
    """The zones of a tree, from lower to higher coordinates.

    >>> leaves((0, 2, (1, 0, 1)))
    (2, 0, 1)
    """
    return (tree,) if isinstance(tree, int) else (*leaves(tree[1]), *leaves(tree[2]))


def area_of(tree: Tree, areas: Sequence[float]) -> float:
    """The areas of all zones of a tree together."""
    return sum(areas[leaf] for leaf in leaves(tree))


def every_tree(zones: Sequence[int]) -> Iterator[Tree]:
    """All trees of a few zones."""
    for order in permutations(zones):
        yield from _in_order(order)


def _in_order(zones: Sequence[int]) -> Iterator[Tree]:
    if len(zones) == 1:
        yield zones[0]
    for k in range(1, len(zones)):
        yield from product((0, 1), _in_order(zones[:k]), _in_order(zones[k:]))


def placed_tree(
    zones: Sequence[int],
    at: Points,
    areas: Sequence[float],
    bounds: tuple[float, float, float, float],
    rng: np.random.Generator,
) -> Tree:
    """A tree that keeps zones near the points ``at`` (n, 2) they would like to be: halves of
    about the same area, cut across the longer side of what is left."""
    if len(zones) == 1:
        return zones[0]
    sides = bounds[2] - bounds[0], bounds[3] - bounds[1]
    axis = int(sides[1] * rng.uniform(0.6, 1.6) > sides[0])
    order = sorted(zones, key=lambda zone: (float(at[zone, axis]), zone))
    share = np.cumsum([areas[zone] for zone in order])
    wish = rng.uniform(0.25, 0.75) * share[-1]
    k = 1 + int(np.argmin(np.abs(share[:-1] - wish)))
    low, high = list(bounds), list(bounds)
    low[2 + axis] = high[axis] = bounds[axis] + sides[axis] * float(share[k - 1] / share[-1])
    below = placed_tree(order[:k], at, areas, (low[0], low[1], low[2], low[3]), rng)
    above = placed_tree(order[k:], at, areas, (high[0], high[1], high[2], high[3]), rng)
    return axis, below, above


def mutate_tree(tree: Tree, rng: np.random.Generator) -> Tree:
    """A neighbour of a tree: two zones swapped, a cut turned or mirrored, or a zone moved."""
    zones = leaves(tree)
    if len(zones) < 2:
        return tree
    kind = int(rng.integers(4))
    one, two = (int(z) for z in rng.choice(len(zones), 2, replace=False))
    if kind == 0:
        return _relabel_tree(tree, {zones[one]: zones[two], zones[two]: zones[one]})
    if kind == 3 and len(zones) > 2:
        rest = _without(tree, zones[one])
        return _beside(rest, zones[two], zones[one], int(rng.integers(2)), bool(rng.integers(2)))
    return _turn_cut(tree, [int(rng.integers(len(zones) - 1))], mirror=kind == 2)


def _relabel_tree(tree: Tree, names: dict[int, int]) -> Tree:
    if isinstance(tree, int):
        return names.get(tree, tree)
    return tree[0], _relabel_tree(tree[1], names), _relabel_tree(tree[2], names)


def _without(tree: Tree, zone: int) -> Tree:
    if isinstance(tree, int):
        return tree
    axis, low, high = tree
    if zone in (low, high):
        return high if low == zone else low
    return axis, _without(low, zone), _without(high, zone)


def _beside(tree: Tree, zone: int, guest: int, axis: int, below: bool) -> Tree:
    if isinstance(tree, int):
        both = (guest, tree) if below else (tree, guest)
        return (axis, *both) if tree == zone else tree
    low, high = (_beside(part, zone, guest, axis, below) for part in tree[1:])
    return tree[0], low, high


def _turn_cut(tree: Tree, countdown: list[int], *, mirror: bool) -> Tree:
    """The tree with its cut number ``countdown[0]`` turned, or its two sides exchanged."""
    if isinstance(tree, int):
        return tree
    axis, low, high = tree
    mine = countdown[0] == 0
    countdown[0] -= 1
    low, high = _turn_cut(low, countdown, mirror=mirror), _turn_cut(high, countdown, mirror=mirror)
    if not mine:
        return axis, low, high
    return (axis, high, low) if mirror else (1 - axis, low, high)
