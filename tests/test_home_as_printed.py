"""The preset ``paper`` is the cost Liu et al. (2017) print: each coefficient by its equation."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from scenewright.building.plan import plan_rooms, spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.domains.home.attempts.attempt import build_task_problem
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.encodings.boxes import gene_bounds
from scenewright.domains.home.energy import evaluate, explain
from scenewright.domains.home.paper_problem import PAIRS, door_areas
from scenewright.domains.home.presets import PAPER, PRESETS
from scenewright.domains.home.problem import Ground, Problem, empty_items
from scenewright.domains.home.solvers import paper_annealing
from scenewright.domains.home.solving import prepare_rooms
from scenewright.engine.genetic import GENERATIONS, PaperGenetic, roulette
from scenewright.formats import read

PRINTED = {  # the weights w1 to w7 of section 3.3.3; C3 is two terms of one weight
    "boundary": 5000.0,
    "overlap": 600.0,
    "keep_free": 600.0,
    "corridors": 600.0,
    "main_wall": 1500.0,
    "against_wall": 1000.0,
    "pairs": 110.0,
    "size": 50.0,
}


def square(**more) -> Ground:
    """A room of 5 by 5 m, its main wall below."""
    wall = np.array([[0, 0, 5, 0], [5, 0, 5, 5], [5, 5, 0, 5], [0, 5, 0, 0]], float)
    none = np.zeros((0, 5))
    return Ground(
        edges=wall,
        walls=wall,
        keep_free=none,
        use_space=none,
        obstacles=none,
        windows=np.zeros((0, 6)),
        doors=none,
        main_wall=wall[:1],
        bounds=np.array([0.0, 0.0, 5.0, 5.0]),
        area=25.0,
    )._replace(**more)


def two(printed: bool = True, roles=(0.0, 0.0), **more) -> Problem:
    """Two patches weighed as printed."""
    items = empty_items(2)._replace(
        back_to_wall=np.ones(2),
        main_wall=np.array(roles),
        pairs=np.array([[0, 1]]),
        pair_targets=np.array([[2.5, math.pi, 0.0]]),
        pair_weights=np.ones(1),
    )
    return Problem(square(**more), items, ("a", "b"), PAPER, printed, flush=0.1)


def costs(problem: Problem, *boxes) -> dict[str, float]:
    """Weighed costs of two boxes, by term."""
    found: dict[str, float] = {}
    for part in explain(problem, np.array(boxes, float)):
        found[part.term] = found.get(part.term, 0.0) + part.cost
    assert sum(found.values()) == pytest.approx(evaluate(problem, np.array([boxes], float))[0])
    return found


UP, DOWN = math.pi / 2, -math.pi / 2
BELOW = (2.5, 0.5, UP, 1.0, 1.0)


def test_weights_are_printed_ones():
    assert PAPER == PRINTED
    assert PRESETS["paper"].weights == PRESETS["paper-repaired"].weights == PRINTED


def test_c1_is_the_share_outside():
    found = costs(two(), BELOW, (5.0, 2.5, math.pi, 1.0, 1.0))
    assert found["boundary"] == pytest.approx(5000 * 0.5 / 2)


def test_c2_is_the_shared_area_over_all_area():
    assert costs(two(), BELOW, (3.0, 0.5, UP, 1.0, 1.0))["overlap"] == pytest.approx(600 * 0.5 / 2)


def test_c3_is_the_area_before_doors_and_on_the_path():
    swing = np.array([[2.5, 0.25, UP, 1.0, 0.5]])
    path = np.array([[4, 0, 5, 0], [5, 0, 5, 5], [5, 5, 4, 5], [4, 5, 4, 0]], float)
    found = costs(two(keep_free=swing, paths=path), BELOW, (4.5, 2.5, math.pi, 1.0, 1.0))
    assert found["keep_free"] == pytest.approx(600 * 0.5 / 2)
    assert found["corridors"] == pytest.approx(600 * 1.0 / 2)


def test_c4_sums_with_sign_and_does_not_wrap():
    boxes = (1.0, 4.5, DOWN + 0.2, 1.0, 1.0), (2.5, 0.5, UP + 0.2, 1.0, 1.0)
    assert costs(two(roles=(1.0, -1.0)), *boxes).get("main_wall", 0.0) == pytest.approx(
        0.0, abs=1e-9
    )
    found = costs(two(roles=(1.0, 1.0)), (1.0, 4.5, DOWN + 0.2, 1.0, 1.0), BELOW)
    assert found["main_wall"] == pytest.approx(1500 * abs(0.2 - math.pi))
    repaired = costs(two(False, roles=(1.0, -1.0)), *boxes)
    assert repaired["main_wall"] == pytest.approx(1500 * 0.4)


@pytest.mark.parametrize("far", [0.05, 0.1, 0.2, 1.0])
def test_c5_is_of_every_patch_within_ten_centimetres(far):
    away = (1.0, 4.5 - far, DOWN, 1.0, 1.0)
    value = 0.0 if far <= 0.1 else 1 - (0.1 / far) ** 2
    for printed in (True, False):
        found = costs(two(printed), away, BELOW).get("against_wall", 0.0)
        assert found == pytest.approx(1000 * value, abs=1e-6)


def test_c6_weighs_metres_and_radians_once():
    found = costs(two(), BELOW, (2.5, 4.0, DOWN + 0.3, 1.0, 1.0))
    assert found["pairs"] == pytest.approx(110 * (abs(3.5 - 2.5) + 0.3))


@pytest.mark.parametrize(("side", "value"), [(1.0, 1 - (0.08 / 0.4) ** 2), (2.4, 0.0)])
def test_c7_wants_forty_to_fifty_five_percent(side, value):
    boxes = (1.3, side / 2, UP, side, side), (3.8, side / 2, UP, side, side)
    assert costs(two(), *boxes).get("size", 0.0) == pytest.approx(50 * value)


def test_c7_above():
    boxes = (2.5, 1.25, UP, 5.0, 2.5), (2.5, 3.75, DOWN, 5.0, 2.5)
    assert costs(two(), *boxes)["size"] == pytest.approx(50 * (1 - 0.55**2))


def rooms_of(preset: str):
    brief = read("sample:home-flat")
    spaces = plan_rooms(brief).spaces
    chosen = PRESETS[preset]
    each = prepare_rooms(brief, spaces, catalog_of(brief.catalogs), chosen, chosen.solver, 0)
    for task, wishes in zip(*each, strict=True):
        if wishes:
            yield wishes, build_task_problem(task, wishes, task.ground)


@pytest.mark.parametrize("preset", ["paper", "paper-repaired"])
def test_rooms_are_the_papers_problem(preset):
    for wishes, problem in rooms_of(preset):
        items, ground = problem.items, problem.ground
        assert (items.back_to_wall == 1.0).all()
        assert (items.pair_weights == 1.0).all()
        assert len(items.pairs) == len({tuple(sorted(pair)) for pair in items.pairs.tolist()})
        assert not np.isnan(items.pair_targets[:, :2]).any()
        assert problem.weights == PRINTED
        assert problem.flush == 0.1
        assert len(ground.use_space) == len(ground.fronts) == 0
        low, high = gene_bounds(problem)
        for k, wish in enumerate(wishes):
            sizes = cases(wish.group).sizes
            assert low[k, 3:].tolist() == sizes.min(0).tolist()
            assert high[k, 3:].tolist() == sizes.max(0).tolist()
        assert problem.printed is (preset == "paper")


def test_the_printed_pair_is_two_and_a_half_metres_face_to_face():
    (pair,) = (row for row in PAIRS if {row.first, row.second} == {"seating", "media"})
    assert (pair.distance, pair.angle, pair.weight) == (2.5, math.pi, 1.0)


def test_repairs_are_all_that_the_repaired_preset_adds():
    paper, repaired = PRESETS["paper"], PRESETS["paper-repaired"]
    assert paper.settings.printed
    assert repaired._replace(doc=paper.doc, settings=paper.settings) == paper
    assert repaired.settings._replace(printed=True) == paper.settings


def test_the_genetic_algorithm_has_the_printed_parameters():
    ga = PaperGenetic()
    assert (ga.population, ga.generations, ga.crossover, ga.mutation, ga.step) == (
        40,
        100,
        0.9,
        0.85,
        0.3,
    )


@pytest.mark.parametrize("age", [51, 75, 99])
def test_late_mutation_keeps_its_sigma(age):
    ga, rng, low = PaperGenetic(), np.random.default_rng(0), np.full(5, -50.0)
    state = ga.init(rng, low, -low)._replace(age=age)
    mutated = rng.random(20_000) < ga.mutation
    moved = ga.mutate(np.zeros((20_000, 5)), mutated, state, rng)
    steps = moved[moved != 0.0]
    assert steps.std() == pytest.approx(0.3, rel=0.03)
    assert len(steps) / 20_000 == pytest.approx(0.85, abs=0.01)


def test_early_mutation_draws_from_the_whole_range():
    ga, rng, low = PaperGenetic(), np.random.default_rng(0), np.full(5, -50.0)
    state = ga.init(rng, low, -low)._replace(age=3)
    moved = ga.mutate(np.zeros((20_000, 5)), np.ones(20_000, bool), state, rng)
    assert ((moved != 0.0).sum(axis=1) <= 1).all()
    drawn = moved[moved != 0.0]
    assert np.quantile(drawn, [0.25, 0.5, 0.75]) == pytest.approx([-25, 0, 25], abs=1.5)


def test_the_best_is_selected_and_not_shielded_from_crossover_and_mutation():
    rng, low = np.random.default_rng(0), np.full(3, -1.0)
    kept = dict.fromkeys((0.0, 0.85), 0)
    for rate in kept:
        ga = PaperGenetic(mutation=rate, crossover=rate)
        state = ga.init(rng, low, -low)
        for _ in range(30):
            asked, state = ga.ask(state, rng)
            best = state.genes[state.energies.argmin()] if len(state.genes) else None
            state = ga.tell(state, asked, (asked**2).sum(axis=1))
            assert len(state.genes) == 40
            kept[rate] += best is not None and (state.genes == best).all(axis=1).any()
    assert kept[0.0] == 29
    assert 0 < kept[0.85] < 29


@pytest.mark.parametrize("width", [0.7, 0.9])
def test_c3_charges_one_area_a_door(width):
    door = {"at": [2.5, 0.0], "width": width, "swing": "in", "hinge": "left"}
    outline = [[0, 0], [5, 0], [5, 5], [0, 5]]
    room = {"id": "r", "function": "living", "outline": outline, "doors": [door]}
    (space,) = spaces(Brief.model_validate({"rooms": [room]}))
    found = door_areas(space)
    assert found[:, 3:].prod(axis=1).sum() == pytest.approx(math.pi / 4 * width**2)
    boxes = shapely.union_all(
        [shapely.box(x - w / 2, y - d / 2, x + w / 2, y + d / 2) for x, y, _, w, d in found]
    )
    assert boxes.area == pytest.approx(math.pi / 4 * width**2)
    doorway = shapely.box(2.5 - width / 2, 0, 2.5 + width / 2, 5)
    discs = [shapely.Point(2.5 + k * width / 2, 0.0).buffer(width, 64) for k in (-1, 1)]
    swept = max(boxes.intersection(disc).intersection(doorway).area for disc in discs)
    assert swept > 0.96 * math.pi / 4 * width**2


def test_roulette_draws_by_fitness():
    energies = np.array([0.0, 5.0, 10.0, 10.0])  # C_max - C: 10, 5, 0, 0
    drawn = np.bincount(roulette(energies, 30_000, np.random.default_rng(0)), minlength=4)
    assert drawn[:2] / 30_000 == pytest.approx([2 / 3, 1 / 3], abs=0.02)
    assert drawn[2] == drawn[3] == 0


def test_the_annealing_has_the_printed_schedule():
    assert GENERATIONS == 100
    found = paper_annealing
    assert (found.START, found.DECAY, found.ITERATIONS) == (100.0, 0.99, 500)
