"""Blocks cut into cells, one for each object: the fine level of Wu et al. 2018.

As Cao, Cheng, Zhang 2024 run it: a block is divided at random into as many cells as the group has
objects, then cells are moved and their gaps fitted to the objects, at most 1000 times; a change
that breaks a linear constraint (an object no longer fits into its cell) or costs more is refused.
"""

from __future__ import annotations

import itertools
import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.hall.solvers.blocks import UNIT, GroupBlock, Option

Floats = NDArray[np.float64]
CELL_SLACK = 0.01
UNEVEN = 0.2
"""Weight of cells of unequal size, against cells too small for the clearance."""


class CellObjects(NamedTuple):
    """The objects of a group: ``sizes`` (n, 2) and ``clear`` (n, 4) as in the problem."""

    sizes: Floats
    clear: Floats


class CellSubdivision(NamedTuple):
    """A subdivision: ``levels`` (rows + 1,) heights between rows, ``cuts`` between the cells of
    each row, in metres from the block's corner, and the object in each cell, row by row."""

    levels: Floats
    cuts: tuple[Floats, ...]
    order: NDArray[np.int64]


def options_for(members: CellObjects, share: float, most: int = 24) -> list[Option]:
    """Ways to lay a group out in columns and rows, with ``share`` of the clearances kept."""
    n, options = len(members.sizes), []
    wide, deep = needs(members, share).max(axis=0) + CELL_SLACK
    counts = sorted({-(-n // rows) for rows in range(1, n + 1)})
    picked = np.unique(np.linspace(0, len(counts) - 1, min(len(counts), most)).astype(int))
    for columns in (counts[i] for i in picked):
        rows = -(-n // columns)
        for turned in (False, True):
            w, h = (deep, wide) if turned else (wide, deep)
            options.append(
                Option(
                    columns,
                    rows,
                    turned,
                    math.ceil(columns * w / UNIT - 1e-6),
                    math.ceil(rows * h / UNIT - 1e-6),
                )
            )
    return options


def needs(members: CellObjects, share: float) -> Floats:
    """Width and depth (n, 2) of the objects with a share of their clearances."""
    clear = members.clear * share
    return members.sizes + np.stack([clear[:, 1] + clear[:, 3], clear[:, 0] + clear[:, 2]], 1)


def rows_of(option: Option, n: int) -> list[int]:
    """How many objects stand in each row; the last rows have one less."""
    return [n // option.rows + (k < n % option.rows) for k in range(option.rows)]


def divide(block: GroupBlock, members: CellObjects, rng: np.random.Generator) -> CellSubdivision:
    """A random subdivision in which every object fits."""
    sizes = members.sizes[:, ::-1] if block.option.turned else members.sizes
    counts, order = rows_of(block.option, len(sizes)), rng.permutation(len(sizes))
    ends = np.cumsum(counts)
    parts = [sizes[order[a:b]] for a, b in zip(ends - counts, ends, strict=True)]
    levels = _break(np.array([part[:, 1].max() for part in parts]), block.height * UNIT, rng)
    cuts = tuple(_break(part[:, 0], block.width * UNIT, rng) for part in parts)
    return CellSubdivision(levels, cuts, order)


def _break(least: Floats, length: float, rng: np.random.Generator) -> Floats:
    """Cuts (k + 1,) of a length into pieces of ``least`` (k,) metres, the rest shared at random."""
    spare = max(length - float(least.sum()) - CELL_SLACK * len(least), 0.0)
    pieces = least + CELL_SLACK + spare * rng.dirichlet(np.ones(len(least)))
    return np.concatenate([[0.0], np.cumsum(pieces)])


def rooms_of(cells: CellSubdivision) -> Floats:
    """Corner, width and height (n, 4) of every cell, row by row."""
    rows = []
    for k, cut in enumerate(cells.cuts):
        low, high = cells.levels[k], cells.levels[k + 1]
        rows += [(a, low, b - a, high - low) for a, b in itertools.pairwise(cut)]
    return np.array(rows)


def misfit(cells: CellSubdivision, block: GroupBlock, members: CellObjects) -> float:
    """Cost of a subdivision: squared lack of clearance and uneven cells, infinite if an object
    does not fit."""
    rooms, turned = rooms_of(cells)[:, 2:], block.option.turned
    wished, bodies = needs(members, 1.0)[cells.order], members.sizes[cells.order]
    if turned:
        wished, bodies = wished[:, ::-1], bodies[:, ::-1]
    if (rooms < bodies + 0.5 * CELL_SLACK).any():
        return math.inf
    spare = rooms - wished
    lacking = np.minimum(spare, 0.0)
    return float((lacking**2).sum() + UNEVEN * ((spare - spare.mean(axis=0)) ** 2).sum())


def perturb_cells(cells: CellSubdivision, rng: np.random.Generator) -> CellSubdivision:
    """Another subdivision: a cell or row moved, a gap fitted, or two objects changed over."""
    kind, k = rng.random(), int(rng.integers(len(cells.cuts)))
    if kind < 0.2 and len(cells.order) > 1:
        i, j = rng.choice(len(cells.order), 2, replace=False)
        order = cells.order.copy()
        order[[i, j]] = order[[j, i]]
        return cells._replace(order=order)
    if kind < 0.4 and len(cells.levels) > 2:
        return cells._replace(levels=_shift_cuts(cells.levels, rng))
    if len(cells.cuts[k]) < 3:
        return cells
    cuts = list(cells.cuts)
    cuts[k] = _shift_cuts(cuts[k], rng)
    return cells._replace(cuts=tuple(cuts))


def _shift_cuts(cuts: Floats, rng: np.random.Generator) -> Floats:
    """Cuts with one moved, or all brought half the way to even ones."""
    if rng.random() < 0.3:
        return 0.5 * (cuts + np.linspace(cuts[0], cuts[-1], len(cuts)))
    i, moved = int(rng.integers(1, len(cuts) - 1)), cuts.copy()
    moved[i] += rng.normal(0.0, 0.2)
    return moved


def boxes_in(
    cells: CellSubdivision, block: GroupBlock, members: CellObjects, front: float
) -> Floats:
    """Boxes (n, 5) of the objects in the order of the group, in metres along the sheet, their
    fronts looking along ``front``; with its clearances each stands in the middle of its cell."""
    rooms, boxes = rooms_of(cells), np.empty((len(cells.order), 5))
    ahead = np.array([math.cos(front), math.sin(front)])
    aside = np.array([-ahead[1], ahead[0]])
    for (x, y, w, h), i in zip(rooms, cells.order, strict=True):
        front_clear, left, back, right = members.clear[i]
        width, depth = members.sizes[i]
        across, along = (h, w) if block.option.turned else (w, h)
        shift = np.clip(0.5 * (back - front_clear), *_room(along - depth))
        slide = np.clip(0.5 * (right - left), *_room(across - width))
        middle = np.array([x + w / 2, y + h / 2]) + UNIT * np.array([block.x, block.y])
        boxes[i] = (*(middle + shift * ahead + slide * aside), front, width, depth)
    return boxes


def _room(spare: float) -> tuple[float, float]:
    half = max(0.5 * spare, 0.0)
    return -half, half
