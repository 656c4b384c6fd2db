"""The lattice of a site for its matrix code: where its cells lie, how large, what fits on them."""

from __future__ import annotations

import math

import numpy as np

from scenewright.core.errors import InputError
from scenewright.domains.site.encodings.cells import SiteLattice, place_of
from scenewright.domains.site.problem import Floats, Ints, SiteProblem
from scenewright.domains.site.terms.measure import SitePrepared, inside_blocks, prepare_site
from scenewright.geometry.boxes import make_frame
from scenewright.geometry.compiled import compiled

CELLS = 40_000
"""No more cells than about this."""
SHARES = 48
LOOSE = 1e-6


def main_direction(edges: Floats) -> float:
    """The direction in [0, π/2) along or across which most of the outline runs; radians.

    ``edges`` (e, 4) x0, y0, x1, y1 in metres.

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
    one, from half the least side on, whose cells they leave least empty; the largest of equals.

    >>> cell_size(np.array([[10.0, 10.0], [20.0, 10.0]]), np.array([1, 1]), 4000.0)
    10.0
    """
    least = max(0.5 * float(pitches.min()), (area / CELLS) ** 0.5)
    sizes = np.append(np.linspace(least, max(float(pitches.max()), least), SHARES), pitches.min())
    sizes = np.sort(sizes[sizes >= least])
    spans = np.ceil(pitches[None] / sizes[:, None, None] - 1e-9)
    used = ((spans * sizes[:, None, None]).prod(2) * counts).sum(1)
    return float(sizes[used <= used.min() * (1.0 + 1e-9)].max())


def make_cells(problem: SiteProblem) -> SiteLattice:
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
    best: SiteLattice | None = None
    for shift in np.stack(np.meshgrid([0.0, 0.5], [0.0, 0.5]), -1).reshape(-1, 2):
        lattice, shape = _lattice(edges, base, size, shift)
        cells = SiteLattice(
            lattice,
            shape,
            spans,
            np.zeros((*spans.shape[:2], shape.prod()), np.uint8),
            np.argsort(kind, kind="stable").astype(np.int64),
            np.concatenate([[0, 0], np.cumsum(counts)]).astype(np.int64),
            np.vstack([np.zeros(2), sizes]),
            np.zeros(0, np.int64),
        )
        mark_fits(p, cells)
        cells = cells._replace(open_cells=np.flatnonzero(cells.fits.any((0, 1))))
        if best is None or places(cells) > places(best):
            best = cells
    assert best is not None
    return best


def places(cells: SiteLattice) -> float:
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
def mark_fits(p: SitePrepared, cells: SiteLattice) -> None:
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
