"""What is learned of real blocks, and the benchmark's measures on cases whose truth is known."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from benchmarks import village, village_data, village_location, village_metrics
from benchmarks.village_annealing import anneal_block

from scenewright.domains.village.house import to_own_frame
from scenewright.domains.village.learning.examples import turns_of
from scenewright.domains.village.learning.tables import (
    FEWEST_OF_REGION,
    RealBlock,
    learn_manner,
    learn_regions,
    relate_in_order,
)
from scenewright.domains.village.library import classify_house
from thoroughness import THOROUGH


def block(number: int = 0, gap: float = 3.0) -> RealBlock:
    """Houses 10 by 8 m in a row behind a street in the south, 5 m from it."""
    rings = []
    for k in range(4):
        west = 4 + k * (10 + gap)
        rings.append(np.array([[west, 5.0], [west + 10, 5], [west + 10, 13], [west, 13]]))
    floor = shapely.box(0, 0, 4 * (10 + gap) + 8 + number, 40)
    street = np.array([[[0.0, 0.0], [4 * (10 + gap) + 8 + number, 0.0]]])
    return RealBlock(f"b{number}", "here", floor, street, tuple(rings))


def test_tables_hold_what_the_blocks_do() -> None:
    manner = learn_manner([block(k) for k in range(30)])
    for table, value in ((manner.gap, 3.0), (manner.street, 5.0), (manner.turn, 0.0)):
        best = int(np.argmax(table.large))
        assert table.edges[best] <= value <= table.edges[best + 1]
        assert sum(table.large) == pytest.approx(1.0)
        assert table.large[best] > 0.9
    assert manner.sizes[1] > 0.9


def test_regions_are_learned_apart_where_each_has_blocks_enough() -> None:
    near = [block(k, 1.5)._replace(region="near") for k in range(FEWEST_OF_REGION)]
    far = [block(k, 12.0)._replace(region="far") for k in range(FEWEST_OF_REGION)]
    few = [block(k, 5.0)._replace(region="few") for k in range(FEWEST_OF_REGION - 1)]
    known = learn_manner([*near, *far, *few])
    regions = learn_regions([*near, *far, *few], known)
    assert set(regions) == {"near", "far"}
    for name, gap in (("near", 1.5), ("far", 12.0)):
        table = regions[name].manner.gap
        best = int(np.argmax(table.large))
        assert table.edges[best] <= gap <= table.edges[best + 1]
        assert len(regions[name].mix.blocks) == FEWEST_OF_REGION
    assert learn_regions(near, known) == {}


def test_the_law_of_counts_finds_the_line_it_was_made_from() -> None:
    made = []
    for k in range(40):
        wide = 50.0 + 10 * k
        count = round(0.002 * wide * 60)
        ring = np.array([[1.0, 1.0], [9.0, 1.0], [9.0, 7.0], [1.0, 7.0]])
        street = np.array([[[0.0, 0.0], [wide, 0.0]]])
        rings = tuple(ring + np.array([10.0 * n, 0.0]) for n in range(count))
        made.append(RealBlock(f"{k}", "", shapely.box(0, 0, wide, 60), street, rings))
    a, b, c, spread = learn_manner(made).count_law
    block_ = made[30]
    guessed = a + b * np.log(block_.floor.area) + c * block_.street_share
    assert np.exp(guessed) == pytest.approx(len(block_.houses), rel=0.05)
    assert spread < 0.05


def test_gaps_are_to_larger_houses_only() -> None:
    rows = relate_in_order(block())
    assert np.isnan(rows[0, 0])
    assert rows[1:, 0] == pytest.approx([3.0, 3.0, 3.0])
    assert rows[:, 2] == pytest.approx(np.full(4, 5.0))


def test_the_same_blocks_are_not_told_apart_and_others_are() -> None:
    near = [_figures(block(k, 3.0)) for k in range(40)]
    same = [_figures(block(k + 100, 3.0)) for k in range(40)]
    far = [_figures(block(k, 12.0)) for k in range(40)]
    assert village_metrics.classifier_auc(near, same) == pytest.approx(0.5, abs=0.1)
    assert village_metrics.classifier_auc(near, far) > 0.95
    told = village_metrics.divergences(near, far)
    assert told["KL gap"] > 3.0
    assert told["KL area"] == pytest.approx(0.0)


def _figures(one: RealBlock) -> village_metrics.BlockFigures:
    return village_metrics.figures(one.floor, one.streets, one.standing)


def test_what_is_foretold_is_scored_against_even_ground() -> None:
    free = village_location.free_middles(shapely.box(0, 0, 50, 40), np.zeros(0, object))
    assert len(free) == 2000
    rng = np.random.default_rng(0)
    poses = np.column_stack(
        [rng.uniform(0, 50, 40_000), rng.uniform(0, 40, 40_000), rng.random(40_000)]
    )
    found = village_location.Sampled(poses, None, np.ones(40_000))
    real = np.array([[20.0, 15.0]])
    even = village_location.foretell(found, np.zeros(40_000), free, real)
    assert even.nats == pytest.approx(0.0, abs=0.15)
    away = np.hypot(*(poses[:, :2] - real).T)
    sure = village_location.foretell(found, -0.5 * (away / 2.0) ** 2, free, real)
    # A bell of 2 m blurred by 1 m: its height is 1 / (2 pi (4 + 1)).
    assert sure.nats == pytest.approx(np.log(0.9 * 2000 / (2 * np.pi * 5.0) + 0.1), abs=0.1)
    assert sure.strict < 0.5
    wrong = village_location.foretell(found, -0.5 * (away / 2.0) ** 2, free, real + 15.0)
    assert wrong.nats == pytest.approx(np.log(0.1), abs=0.05)
    # Of two missing houses the second stands where it is foretold.
    both = np.concatenate([real + 15.0, real])
    other = village_location.foretell(found, -0.5 * (away / 2.0) ** 2, free, both)
    assert other.strict == pytest.approx(wrong.strict)
    assert other.any == pytest.approx(sure.strict)


def test_denser_proposals_near_the_real_middle_change_nothing_but_the_error() -> None:
    """A share of one in ten for ten times as many poses near the middle: the same density."""
    free = village_location.free_middles(shapely.box(0, 0, 50, 40), np.zeros(0, object))
    rng, real = np.random.default_rng(0), np.array([[20.0, 15.0]])
    poses = rng.uniform(0, (50, 40, 1), (6000, 3))
    near = np.hypot(*(poses[:, :2] - real[0]).T) < 4.0
    more = rng.uniform(0, (50, 40, 1), (60_000, 3))
    more = more[np.hypot(*(more[:, :2] - real[0]).T) < 4.0]
    share = np.concatenate([np.where(near, 0.0, 1.0), np.full(len(more), 0.1)])
    found = village_location.Sampled(np.concatenate([poses, more]), None, share)
    told = village_location.foretell(found, np.zeros(len(share)), free, real)
    assert told.nats == pytest.approx(0.0, abs=0.1)


def test_missing_houses_are_those_that_do_not_stand_yet() -> None:
    one = block()
    turns = list(turns_of(one, np.random.default_rng(0)))
    for k, turn in enumerate(turns):
        missing = village_location.missing_houses(one, turn)
        assert len(missing) == len(one.houses) - k
        middle = one.standing.frames[missing[0], :2]
        assert middle == pytest.approx(turn.pose[:2])


def test_faulty_houses_are_counted() -> None:
    one = block()
    moved = (*one.houses[:3], one.houses[2] + np.array([1.0, 0.0]))
    assert _figures(one).faulty == 0.0
    assert _figures(one._replace(houses=moved)).faulty == pytest.approx(0.5)


def test_annealing_goes_where_its_objective_leads() -> None:
    one = block(gap=6.0)
    houses = [
        classify_house(f"{k}", to_own_frame(ring)[0], 2, 7.0, "", 1.0)
        for k, ring in enumerate(one.houses)
    ]
    found = _figures(one._replace(houses=_rings(anneal_block(one, houses, 1, 6000))))
    assert found.faulty == 0.0
    assert found.rows[:, 2].mean() == pytest.approx(5.0, abs=1.5)


def _rings(standing: object) -> tuple[np.ndarray, ...]:
    return tuple(shapely.get_coordinates(s.exterior)[:-1] for s in standing.shapes)


@pytest.mark.realdata(quick=True)
def test_the_data_are_split_by_place_and_rebuilt_without_a_leak() -> None:
    blocks = village_data.real_blocks()
    assert len(blocks) > 600
    places = {one.place for one in blocks}
    for held in village_data.SPLITS.values():
        assert set(held) <= places
    train, test = village_data.split("A")
    assert not {one.place for one in train} & {one.place for one in test}
    away = np.concatenate(
        [shapely.distance(one.standing.shapes, one.floor.exterior) for one in blocks[:80]]
    )
    assert ((away > 8.5) & (away < 10.5)).mean() < 0.3


@pytest.mark.skipif(not THOROUGH, reason="many real scenes: in make test-all")
@pytest.mark.realdata
def test_ours_is_nearer_to_real_blocks_than_what_is_proposed() -> None:
    grown, proposed = (village.fill_split("A", name, 8, 10) for name in ("grow", "proposals"))
    ours, theirs = (village_metrics.divergences(r[0], r[1]) for r in (grown, proposed))
    relations = ("KL gap", "KL turn", "KL street", "KL street_turn")
    assert sum(ours[name] for name in relations) < sum(theirs[name] for name in relations)
    assert all(one.faulty == 0.0 for one in grown[1])
