"""Matrix coding of sites: the ground as m x n cells, a gene the kind of building on a cell.

A chromosome is ``(cells, 3)``, line by line: kind (0 = empty), part and turn. A building spans as
many cells as it and its spacing need; the parts of M5 are M5, M5-1, M5-2 … line by line from its
lower left cell, the *anchor*, part 0. Turn t is the heading ``base + t π/2``; base is the one of
four along the site's main direction that is nearest to the preferred heading.
Zhang, Yang 2023, Fig. 12.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

KIND, PART, TURN = range(3)


class SiteLattice(NamedTuple):
    """The lattice of a site and the buildings on its cells.

    ``lattice`` (6,): x, y of its corner, cos and sin of its lines, size of a cell in metres,
    base heading. ``shape`` rows m and columns n. ``spans`` (kinds + 1, 2, 2): columns and rows of
    each kind at even and odd turns, row 0 empty; ``fits`` (kinds + 1, 2, cells) 1 where a
    building with its anchor there lies inside the blocks; ``members`` (n,) buildings by kind,
    those of kind k at ``firsts[k] : firsts[k + 1]``; ``sizes`` (kinds + 1, 2); ``open_cells``
    (o,) where an anchor of any kind may be.
    """

    lattice: Floats
    shape: Ints
    spans: Ints
    fits: NDArray[np.uint8]
    members: Ints
    firsts: Ints
    sizes: Floats
    open_cells: Ints

    def counts(self) -> Ints:
        """How many buildings there are of each kind (kinds + 1,), 0 of the empty one."""
        return np.diff(self.firsts)


@compiled
def place_of(cells: SiteLattice, kind: int, turn: int, anchor: int) -> tuple[float, float]:
    """The middle of the cells a building spans."""
    g, columns = cells.lattice, cells.shape[1]
    u = (anchor % columns + 0.5 * cells.spans[kind, turn % 2, 0]) * g[4]
    v = (anchor // columns + 0.5 * cells.spans[kind, turn % 2, 1]) * g[4]
    return g[0] + u * g[2] - v * g[3], g[1] + u * g[3] + v * g[2]


@compiled
def is_whole(cells: SiteLattice, genes: Ints, anchor: int) -> bool:
    """True if all parts of the building at an anchor are where they should be.

    ``genes`` (cells, 3).
    """
    kind, turn = genes[anchor, KIND], genes[anchor, TURN]
    width, depth = cells.spans[kind, turn % 2, 0], cells.spans[kind, turn % 2, 1]
    for part in range(width * depth):
        cell = anchor + (part // width) * cells.shape[1] + part % width
        same = genes[cell, KIND] == kind and genes[cell, TURN] == turn
        if not same or genes[cell, PART] != part:
            return False
    return True


@compiled
def is_free(cells: SiteLattice, genes: Ints, kind: int, turn: int, anchor: int) -> bool:
    """True if a building may be set at an anchor: inside the blocks, its cells empty.

    ``genes`` (cells, 3).
    """
    if cells.fits[kind, turn % 2, anchor] == 0:
        return False
    width, depth = cells.spans[kind, turn % 2, 0], cells.spans[kind, turn % 2, 1]
    for part in range(width * depth):
        if genes[anchor + (part // width) * cells.shape[1] + part % width, KIND] > 0:
            return False
    return True


@compiled
def set_building(cells: SiteLattice, genes: Ints, kind: int, turn: int, anchor: int) -> None:
    """Write all parts of a building.

    ``genes`` (cells, 3), changed in place.
    """
    width, depth = cells.spans[kind, turn % 2, 0], cells.spans[kind, turn % 2, 1]
    for part in range(width * depth):
        cell = anchor + (part // width) * cells.shape[1] + part % width
        genes[cell, KIND], genes[cell, PART], genes[cell, TURN] = kind, part, turn


@compiled
def clear_building(cells: SiteLattice, genes: Ints, cell: int) -> None:
    """Empty all cells of the building that a cell is part of.

    ``genes`` (cells, 3), changed in place.
    """
    kind, part, turn = genes[cell, KIND], genes[cell, PART], genes[cell, TURN]
    if kind == 0:
        return
    width, depth = cells.spans[kind, turn % 2, 0], cells.spans[kind, turn % 2, 1]
    anchor = cell - (part // width) * cells.shape[1] - part % width
    for k in range(width * depth):
        other = anchor + (k // width) * cells.shape[1] + k % width
        genes[other, KIND], genes[other, PART], genes[other, TURN] = 0, 0, 0


@compiled
def repair(cells: SiteLattice, genes: Ints, order: Ints, fresh: Ints, counts: Ints) -> None:
    """Make any genes (cells, 3) a layout: buildings cut in two are completed where their cells
    are empty and removed where not, and no kind stands more often than it is asked for.

    Anchors are visited in ``order`` (cells,), whole buildings first. ``fresh`` (cells, 3) and
    ``counts`` (kinds + 1,) are scratch.
    """
    for k in range(fresh.shape[0]):
        fresh[k, KIND], fresh[k, PART], fresh[k, TURN] = 0, 0, 0
    for k in range(counts.shape[0]):
        counts[k] = cells.firsts[k + 1] - cells.firsts[k]
    for whole in range(2):
        for place in range(order.shape[0]):
            anchor = order[place]
            kind, turn = genes[anchor, KIND], genes[anchor, TURN]
            if kind == 0 or genes[anchor, PART] != 0 or counts[kind] == 0:
                continue
            if not is_free(cells, fresh, kind, turn, anchor):
                continue
            if whole == 1 or is_whole(cells, genes, anchor):
                set_building(cells, fresh, kind, turn, anchor)
                counts[kind] -= 1
    for k in range(fresh.shape[0]):
        for column in range(3):
            genes[k, column] = fresh[k, column]


@compiled
def strew(cells: SiteLattice, genes: Ints, kinds: Ints, turns: Ints, anchors: Ints) -> None:
    """Set buildings of ``kinds`` (b,) one after another at the first of their ``anchors`` (b, t)
    that is free, at ``turns`` (b, t)."""
    for k in range(kinds.shape[0]):
        for t in range(anchors.shape[1]):
            if is_free(cells, genes, kinds[k], turns[k, t], anchors[k, t]):
                set_building(cells, genes, kinds[k], turns[k, t], anchors[k, t])
                break


@compiled
def decode_genes(cells: SiteLattice, genes: Ints, used: Ints, boxes: Floats) -> None:
    """Write the boxes (n, 5) genes stand for; of no width: left out. Buildings of a kind take
    its places line by line. ``used`` (kinds + 1,) is scratch."""
    for i in range(boxes.shape[0]):
        for column in range(5):
            boxes[i, column] = 0.0
    for k in range(used.shape[0]):
        used[k] = cells.firsts[k]
    for anchor in range(genes.shape[0]):
        kind, turn = genes[anchor, KIND], genes[anchor, TURN]
        if kind > 0 and genes[anchor, PART] == 0:
            i = cells.members[used[kind]]
            used[kind] += 1
            boxes[i, 0], boxes[i, 1] = place_of(cells, kind, turn, anchor)
            boxes[i, 2] = cells.lattice[5] + 0.5 * math.pi * turn
            boxes[i, 3], boxes[i, 4] = cells.sizes[kind, 0], cells.sizes[kind, 1]


def decode(cells: SiteLattice, genes: Ints) -> tuple[Floats, NDArray[np.bool_]]:
    """Boxes (n, 5) in the middle of their cells, headings in [0, 2π), and which stand (n,)."""
    boxes = np.empty((len(cells.members), 5))
    decode_genes(cells, np.ascontiguousarray(genes), np.zeros_like(cells.counts()), boxes)
    present = boxes[:, 3] > 0.0
    boxes[present, 2] %= 2.0 * math.pi
    return boxes, present


def encode(cells: SiteLattice, boxes: Floats, present: NDArray[np.bool_]) -> Ints:
    """Genes (cells, 3) of boxes (n, 5), each on the nearest cells and turn; those whose cells are
    taken or closed are lost. Undoes :func:`decode`."""
    genes = np.zeros((cells.fits.shape[2], 3), np.int64)
    kind_of = np.empty(len(cells.members), np.int64)
    kind_of[cells.members] = np.repeat(np.arange(len(cells.counts())), cells.counts())
    x, y, c, s, size, base = cells.lattice
    turns = np.rint((boxes[:, 2] - base) / (0.5 * math.pi)).astype(np.int64) % 4
    dx, dy = boxes[:, 0] - x, boxes[:, 1] - y
    middles = np.column_stack([dx * c + dy * s, dy * c - dx * s]) / size
    for i in np.flatnonzero(present):
        kind, turn = int(kind_of[i]), int(turns[i])
        column, row = np.rint(middles[i] - 0.5 * cells.spans[kind, turn % 2]).astype(int)
        if 0 <= row < cells.shape[0] and 0 <= column < cells.shape[1]:
            anchor = int(row * cells.shape[1] + column)
            if is_free(cells, genes, kind, turn, anchor):
                set_building(cells, genes, kind, turn, anchor)
    return genes
