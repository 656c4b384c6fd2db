"""Matrix coding of sites: round trips, repair, operators, what the cells may hold."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from benchmarks.shapely_hall import polygon
from benchmarks.shapely_home import rectangle
from benchmarks.site_instances import example_site
from hypothesis import given
from hypothesis import strategies as st

from scenewright.core.errors import InputError
from scenewright.domains.site.encodings.cell_moves import (
    cross,
    mutate,
    random_genes,
    repair_genes,
    roulette,
    spread,
    tournament,
)
from scenewright.domains.site.encodings.cells import (
    KIND,
    PART,
    SiteLattice,
    decode,
    encode,
    is_whole,
)
from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.solvers.lattice import cell_size, main_direction, make_cells

PROBLEM = example_site(20, 160.0)
CELLS = make_cells(PROBLEM)


def is_layout(cells: SiteLattice, genes: np.ndarray) -> bool:
    """All buildings whole, none more often than asked for, every part owned by an anchor."""
    anchors = np.flatnonzero((genes[:, KIND] > 0) & (genes[:, PART] == 0))
    if not all(is_whole(cells, genes, int(a)) for a in anchors):
        return False
    kinds = genes[anchors, KIND]
    spans = cells.spans[kinds, genes[anchors, 2] % 2].prod(1)
    counted = np.bincount(kinds, minlength=len(cells.counts()))
    return bool((counted <= cells.counts()).all()) and spans.sum() == (genes[:, KIND] > 0).sum()


def assert_stands(problem: SiteProblem, boxes: np.ndarray, present: np.ndarray) -> None:
    ground = problem.ground
    blocks = shapely.union_all([polygon(ground.block_edges[a:b]) for a, b in ground.block_spans])
    shapes = [rectangle(box) for box in boxes[present]]
    for shape in shapes:
        assert shape.difference(blocks).area < 1e-3
    tree = shapely.STRtree(shapes)
    near = tree.query(shapes, "dwithin", problem.spacing - 1e-6)
    assert (near[0] == near[1]).all()


@given(st.integers(0, 2**32))
def test_round_trip(seed: int) -> None:
    genes = random_genes(CELLS, np.random.default_rng(seed))
    assert is_layout(CELLS, genes)
    boxes, present = decode(CELLS, genes)
    assert present.sum() == ((genes[:, KIND] > 0) & (genes[:, PART] == 0)).sum()
    assert np.array_equal(encode(CELLS, boxes, present), genes)
    assert np.allclose(boxes[present, 3:], PROBLEM.buildings.sizes[present, :2])


@given(st.integers(0, 2**32))
def test_whatever_is_crossed_and_mutated_becomes_a_layout_again(seed: int) -> None:
    rng = np.random.default_rng(seed)
    for child in cross(random_genes(CELLS, rng), random_genes(CELLS, rng), rng):
        genes = repair_genes(CELLS, child, rng)
        assert is_layout(CELLS, genes)
        for _ in range(5):
            mutate(CELLS, genes, rng)
        assert is_layout(CELLS, genes)
        assert np.array_equal(repair_genes(CELLS, genes, rng), genes)


def test_layouts_stand_inside_the_blocks_and_keep_their_spacing() -> None:
    for turn in (0.0, 0.3):
        problem = turned(PROBLEM, turn)
        cells = make_cells(problem)
        for seed in range(4):
            genes = random_genes(cells, np.random.default_rng(seed))
            boxes, present = decode(cells, genes)
            assert present.sum() > 8
            assert_stands(problem, boxes, present)
            headings = (boxes[present, 2] - problem.facing) % (0.5 * math.pi)
            assert np.allclose(np.minimum(headings, 0.5 * math.pi - headings), 0.0, atol=1e-6)


def turned(problem: SiteProblem, angle: float) -> SiteProblem:
    """The whole site turned about the origin."""
    c, s = math.cos(angle), math.sin(angle)
    matrix, ground = np.array([[c, s], [-s, c]]), problem.ground
    edges = np.hstack([ground.edges[:, :2] @ matrix, ground.edges[:, 2:] @ matrix])
    blocks = np.hstack([ground.block_edges[:, :2] @ matrix, ground.block_edges[:, 2:] @ matrix])
    bounds = np.array([*edges[:, :2].min(0), *edges[:, :2].max(0)])
    return problem._replace(
        ground=ground._replace(edges=edges, block_edges=blocks, bounds=bounds),
        facing=problem.facing + angle,
    )


def test_a_building_cut_in_two_is_completed_or_removed() -> None:
    genes, rng = random_genes(CELLS, np.random.default_rng(4)), np.random.default_rng(5)
    anchors = np.flatnonzero((genes[:, KIND] > 0) & (genes[:, PART] == 0))
    wide = [a for a in anchors if CELLS.spans[genes[a, KIND], genes[a, 2] % 2, 0] > 1]
    one, two = int(wide[0]), int(wide[1])
    cut = genes.copy()
    cut[one + 1] = 0  # its second part is lost, the cell empty
    cut[two] = 0  # its anchor is lost
    whole = repair_genes(CELLS, cut, rng)
    assert is_whole(CELLS, whole, one)
    assert whole[one, KIND] == genes[one, KIND]
    assert whole[two, KIND] == 0
    assert whole[two + 1, KIND] == 0


def test_more_buildings_than_asked_for_are_removed() -> None:
    kinds = np.flatnonzero(CELLS.spans[:, 0].prod(1) == 1)
    if not len(kinds):
        kinds = np.array([1])
    genes = np.zeros((CELLS.fits.shape[2], 3), np.int64)
    genes[:, KIND] = kinds[0]
    whole = repair_genes(CELLS, genes, np.random.default_rng(0))
    assert is_layout(CELLS, whole)
    placed = ((whole[:, KIND] == kinds[0]) & (whole[:, PART] == 0)).sum()
    assert placed == CELLS.counts()[kinds[0]]


def test_cells_follow_the_library() -> None:
    pitches = np.array([[12.0, 12.0], [24.0, 12.0]])
    assert cell_size(pitches, np.array([3, 5]), 10_000.0) == 12.0
    assert main_direction(PROBLEM.ground.block_edges) == pytest.approx(0.0, abs=1e-9)
    assert CELLS.counts().sum() == 20
    empty = PROBLEM.buildings._replace(sizes=np.zeros((0, 3)))
    with pytest.raises(InputError, match="no buildings"):
        make_cells(PROBLEM._replace(buildings=empty))


def test_a_site_without_room_has_no_layout() -> None:
    ground = PROBLEM.ground._replace(
        block_edges=np.zeros((0, 4)),
        block_spans=np.zeros((0, 2), np.int64),
        block_areas=np.zeros(0),
    )
    cells, rng = make_cells(PROBLEM._replace(ground=ground)), np.random.default_rng(0)
    genes = random_genes(cells, rng)
    mutate(cells, genes, rng)
    assert not decode(cells, genes)[1].any()


def test_the_better_are_drawn_more_often() -> None:
    costs, rng = np.array([3.0, 1.0, 2.0, 9.0]), np.random.default_rng(0)
    for draw in (tournament, roulette):
        often = np.bincount(draw(costs, 4000, rng), minlength=4)
        assert often[1] > often[2] > often[0] > often[3]
    assert spread(np.array([1.0, 2.0]), 0.5) == pytest.approx(0.5)
    assert spread(np.array([1.0, 1.001]), 0.5) < 0.0
