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

from scenewright.errors import InputError
from scenewright.geometry.boxes import make_frame
from scenewright.geometry.compiled import compiled
from scenewright.site_problem import SiteProblem
from scenewright.terms.site_measure import SitePrepared, inside_blocks, prepare_site

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

KIND, PART, TURN = range(3)
CELLS = 40_000
SHARES = 24
LOOSE = 1e-6


class Cells(NamedTuple):
    """The lattice of a site and what stands where on it.

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


def main_direction(edges: Floats) -> float:
    """The direction in [0, π/2) along or across which most of the outline runs; radians.

    >>> ring = np.array([[0, 0, 4, 1], [4, 1, 3, 5], [3, 5, -1, 4], [-1, 4, 0, 0]], float)
    >>> round(float(np.tan(main_direction(ring))), 6)
    0.25
    """
    dx, dy = edges[:, 2] - edges[:, 0], edges[:, 3] - edges[:, 1]
    angles, lengths = np.arctan2(dy, dx) % (0.5 * math.pi), np.hypot(dx, dy)
    gaps = np.abs(angles[:, None] - angles[None])
    near = np.minimum(gaps, 0.5 * math.pi - gaps) < math.radians(2.0)
    return float(angles[(near @ lengths).argmax()])


def cell_size(pitches: Floats, counts: Ints, area: float) -> float:
    """The size of cells that buildings of ``pitches`` (k, 2), sides with spacing, fill best: the
    share of their cells they leave empty is least, between the least and the greatest side.

    >>> cell_size(np.array([[10.0, 10.0], [20.0, 10.0]]), np.array([1, 1]), 4000.0)
    10.0
    """
    least = max(float(pitches.min()), (area / CELLS) ** 0.5)
    sizes = np.linspace(least, max(float(pitches.max()), least), SHARES)
    spans = np.ceil(pitches[None] / sizes[:, None, None] - 1e-9)
    used = ((spans * sizes[:, None, None]).prod(2) * counts).sum(1)
    return float(sizes[used.argmin()])


def make_cells(problem: SiteProblem) -> Cells:
    """The lattice of a site, its corner where most places for buildings lie inside the blocks."""
    made, ground = problem.buildings, problem.ground
    if not len(made.sizes):
        raise InputError("the site has no buildings to place", "ask for some under 'buildings'")
    rows = np.column_stack([made.models, made.sizes])
    _, first, kind = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    kind = kind.reshape(-1)
    counts = np.bincount(kind)
    sizes = made.sizes[first, :2]
    size = cell_size(sizes + max(problem.spacing, problem.fire_access), counts, ground.area)
    edges = ground.block_edges if len(ground.block_edges) else ground.edges
    steps = round((problem.facing - main_direction(edges)) / (0.5 * math.pi))
    base = main_direction(edges) + steps * 0.5 * math.pi
    spans = _spans(sizes + max(problem.spacing, problem.fire_access), size)
    p = prepare_site(problem)
    best: Cells | None = None
    for shift in np.stack(np.meshgrid([0.0, 0.5], [0.0, 0.5]), -1).reshape(-1, 2):
        lattice, shape = _lattice(edges, base, size, shift)
        cells = Cells(
            lattice, shape, spans, np.zeros((*spans.shape[:2], shape.prod()), np.uint8),
            np.argsort(kind, kind="stable").astype(np.int64),
            np.concatenate([[0, 0], np.cumsum(counts)]).astype(np.int64),
            np.vstack([np.zeros(2), sizes]), np.zeros(0, np.int64),
        )  # fmt: skip
        mark_fits(p, cells)
        cells = cells._replace(open_cells=np.flatnonzero(cells.fits.any((0, 1))))
        if best is None or places(cells) > places(best):
            best = cells
    assert best is not None
    return best


def places(cells: Cells) -> float:
    """Places for buildings on a lattice, kinds weighed by how many there are of each."""
    return float((cells.fits.sum((1, 2)) * cells.counts()).sum())


def _spans(pitches: Floats, size: float) -> Ints:
    """Columns and rows (kinds + 1, 2, 2) at even and odd turns."""
    even = np.ceil(pitches / size - 1e-9).astype(np.int64)
    both = np.stack([even, even[:, ::-1]], 1)
    return np.concatenate([np.zeros((1, 2, 2), np.int64), both])


def _lattice(edges: Floats, base: float, size: float, shift: Floats) -> tuple[Floats, Ints]:
    """Corner and number of cells of a lattice over all edges, its columns to the right of the
    base heading, its rows ahead; begun ``shift`` cells earlier."""
    axis = base - 0.5 * math.pi
    c, s = math.cos(axis), math.sin(axis)
    points = edges[:, :2] @ np.array([[c, -s], [s, c]])
    low = points.min(0) - shift * size
    count = np.maximum(np.ceil((points.max(0) - low) / size - 1e-9), 1).astype(np.int64)
    x, y = c * low[0] - s * low[1], s * low[0] + c * low[1]
    return np.array([x, y, c, s, size, base]), count[::-1].copy()


@compiled
def place_of(cells: Cells, kind: int, turn: int, anchor: int) -> tuple[float, float]:
    """The middle of the cells a building spans."""
    g, columns = cells.lattice, cells.shape[1]
    u = (anchor % columns + 0.5 * cells.spans[kind, turn % 2, 0]) * g[4]
    v = (anchor // columns + 0.5 * cells.spans[kind, turn % 2, 1]) * g[4]
    return g[0] + u * g[2] - v * g[3], g[1] + u * g[3] + v * g[2]


@compiled
def mark_fits(p: SitePrepared, cells: Cells) -> None:
    """Mark where buildings of each kind lie inside the lattice and the blocks. Roads, landmarks
    and what is not built on are no blocks, so they stay closed."""
    for kind in range(1, cells.spans.shape[0]):
        for odd in range(2):
            width, depth = cells.spans[kind, odd, 0], cells.spans[kind, odd, 1]
            for anchor in range(cells.fits.shape[2]):
                row, column = anchor // cells.shape[1], anchor % cells.shape[1]
                fit = row + depth <= cells.shape[0] and column + width <= cells.shape[1]
                if fit:
                    x, y = place_of(cells, kind, odd, anchor)
                    heading = cells.lattice[5] + 0.5 * math.pi * odd
                    w, d = cells.sizes[kind, 0], cells.sizes[kind, 1]
                    inside = inside_blocks(p, make_frame(x, y, heading, w, d))
                    fit = inside >= w * d * (1.0 - LOOSE)
                cells.fits[kind, odd, anchor] = 1 if fit else 0


@compiled
def is_whole(cells: Cells, genes: Ints, anchor: int) -> bool:
    """True if all parts of the building at an anchor are where they should be."""
    kind, turn = genes[anchor, KIND], genes[anchor, TURN]
    width, depth = cells.spans[kind, turn % 2, 0], cells.spans[kind, turn % 2, 1]
    for part in range(width * depth):
        cell = anchor + (part // width) * cells.shape[1] + part % width
        same = genes[cell, KIND] == kind and genes[cell, TURN] == turn
        if not same or genes[cell, PART] != part:
            return False
    return True


@compiled
def is_free(cells: Cells, genes: Ints, kind: int, turn: int, anchor: int) -> bool:
    """True if a building may be set at an anchor: inside the blocks, its cells empty."""
    if cells.fits[kind, turn % 2, anchor] == 0:
        return False
    width, depth = cells.spans[kind, turn % 2, 0], cells.spans[kind, turn % 2, 1]
    for part in range(width * depth):
        if genes[anchor + (part // width) * cells.shape[1] + part % width, KIND] > 0:
            return False
    return True


@compiled
def set_building(cells: Cells, genes: Ints, kind: int, turn: int, anchor: int) -> None:
    """Write all parts of a building."""
    width, depth = cells.spans[kind, turn % 2, 0], cells.spans[kind, turn % 2, 1]
    for part in range(width * depth):
        cell = anchor + (part // width) * cells.shape[1] + part % width
        genes[cell, KIND], genes[cell, PART], genes[cell, TURN] = kind, part, turn


@compiled
def clear_building(cells: Cells, genes: Ints, cell: int) -> None:
    """Empty all cells of the building that a cell is part of."""
    kind, part, turn = genes[cell, KIND], genes[cell, PART], genes[cell, TURN]
    if kind == 0:
        return
    width, depth = cells.spans[kind, turn % 2, 0], cells.spans[kind, turn % 2, 1]
    anchor = cell - (part // width) * cells.shape[1] - part % width
    for k in range(width * depth):
        other = anchor + (k // width) * cells.shape[1] + k % width
        genes[other, KIND], genes[other, PART], genes[other, TURN] = 0, 0, 0


@compiled
def repair(cells: Cells, genes: Ints, order: Ints, fresh: Ints, counts: Ints) -> None:
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
def strew(cells: Cells, genes: Ints, kinds: Ints, turns: Ints, anchors: Ints) -> None:
    """Set buildings of ``kinds`` (b,) one after another at the first of their ``anchors`` (b, t)
    that is free, at ``turns`` (b, t)."""
    for k in range(kinds.shape[0]):
        for t in range(anchors.shape[1]):
            if is_free(cells, genes, kinds[k], turns[k, t], anchors[k, t]):
                set_building(cells, genes, kinds[k], turns[k, t], anchors[k, t])
                break


@compiled
def decode_genes(cells: Cells, genes: Ints, used: Ints, boxes: Floats) -> None:
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


def decode(cells: Cells, genes: Ints) -> tuple[Floats, NDArray[np.bool_]]:
    """Boxes (n, 5) in the middle of their cells, headings in [0, 2π), and which stand (n,)."""
    boxes = np.empty((len(cells.members), 5))
    decode_genes(cells, np.ascontiguousarray(genes), np.zeros_like(cells.counts()), boxes)
    present = boxes[:, 3] > 0.0
    boxes[present, 2] %= 2.0 * math.pi
    return boxes, present


def encode(cells: Cells, boxes: Floats, present: NDArray[np.bool_]) -> Ints:
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
