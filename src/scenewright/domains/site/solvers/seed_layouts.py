"""First layouts of the matrix-coded genetic algorithm, made of local templates.

Zhang, Yang 2023, III-A: groups of buildings are laid out in a box by a planar form and annealed;
the site is then composed of such groups. Here every block gets its share of the buildings, in the
largest rectangle of cells inside it; the form is the one asked for, else each in turn.
"""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.site.encodings.cells import SiteLattice, encode
from scenewright.domains.site.encodings.forms import FORMS, FRONT, rotate_boxes
from scenewright.domains.site.problem import Buildings, Floats, Ints, SiteProblem
from scenewright.domains.site.solvers.blocks.front import inside
from scenewright.domains.site.solvers.templates import make_template
from scenewright.geometry.rectangles import largest_rectangle


def seed_layouts(problem: SiteProblem, cells: SiteLattice, count: int, seed: int) -> Floats:
    """Genes (count, cells · 3) of layouts whose blocks are templates."""
    grounds = [_find_rectangle(problem, cells, b) for b in range(len(problem.ground.block_areas))]
    queue = np.argsort(-problem.buildings.quality, kind="stable")
    shares = _share_out(problem, queue)
    return np.array(
        [_seed_layout(problem, cells, grounds, shares, k, seed) for k in range(count)], float
    ).reshape(count, -1)


def _seed_layout(
    problem: SiteProblem,
    cells: SiteLattice,
    grounds: list[tuple[Floats, tuple[float, float]]],
    shares: list[Ints],
    number: int,
    seed: int,
) -> Ints:
    boxes, present = (
        np.zeros((len(problem.buildings.sizes), 5)),
        np.zeros(len(problem.buildings.sizes), bool),
    )
    names = list(FORMS)
    for b, ((middle, target), own) in enumerate(zip(grounds, shares, strict=True)):
        if not len(own) or min(target) <= 0.0:
            continue
        form = problem.block_forms[b] if b < len(problem.block_forms) else ""
        form = form or names[(number + b) % len(names)]
        made = make_template(
            form,
            subset(problem.buildings, own),
            target,
            problem.spacing,
            problem.fire_access,
            problem.sun_spacing,
            seed + number,
            problem.settings.chain.template,
            problem.settings,
        )
        turn = cells.lattice[5] - FRONT
        boxes[own] = rotate_boxes(made.boxes, float(turn), float(middle[0]), float(middle[1]))
        present[own] = made.present
    return encode(cells, boxes, present)


def subset(made: Buildings, rows: Ints) -> Buildings:
    """The buildings of some rows (k,)."""
    return Buildings(
        made.sizes[rows],
        made.quality[rows],
        made.tone[rows],
        made.symmetry[rows],
        made.models[rows],
        made.floors[rows],
        sides=made.sides[rows] if len(made.sides) == len(made.quality) else made.sides,
    )


def _share_out(problem: SiteProblem, queue: Ints) -> list[Ints]:
    """The buildings of each block, by its share of the ground."""
    floor = (problem.buildings.sizes[queue, :2] + problem.spacing).prod(1)
    ends = np.cumsum(problem.ground.block_areas) / max(
        float(problem.ground.block_areas.sum()), 1e-9
    )
    place = (np.cumsum(floor) - 0.5 * floor) / max(float(floor.sum()), 1e-9)
    block = np.minimum(np.searchsorted(ends, place), max(len(ends) - 1, 0))
    return [queue[block == b] for b in range(len(ends))]


def _find_rectangle(
    problem: SiteProblem, cells: SiteLattice, b: int
) -> tuple[Floats, tuple[float, float]]:
    """Middle (2,) and sides, along a row and ahead, of a block's largest rectangle of cells."""
    rows, columns = cells.shape.tolist()
    x, y, c, s, size, base = cells.lattice
    row, column = np.divmod(np.arange(rows * columns), columns)
    u, v = (column + 0.5) * size, (row + 0.5) * size
    middles = np.column_stack([x + u * c - v * s, y + u * s + v * c])
    first, last = problem.ground.block_spans[b]
    edges = problem.ground.block_edges[first:last]
    low, high = edges.reshape(-1, 2).min(0), edges.reshape(-1, 2).max(0)
    free = ((middles > low) & (middles < high)).all(1)
    free[free] = inside(edges, middles[free])
    r0, r1, c0, c1 = largest_rectangle(free.reshape(rows, columns))
    u, v = 0.5 * (c0 + c1) * size, 0.5 * (r0 + r1) * size
    sides = (c1 - c0) * size, (r1 - r0) * size
    if round((base - math.atan2(s, c)) / (0.5 * math.pi)) % 2 == 0:
        sides = sides[1], sides[0]
    return np.array([x + u * c - v * s, y + u * s + v * c]), sides
