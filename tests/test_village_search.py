"""Villages as every kind of scene: watched, stopped, locked, several layouts, bred for a person."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely

from scenewright.core.brief import Brief
from scenewright.core.edits import Edits
from scenewright.core.layout import BestLayout
from scenewright.core.piece_outlines import outline_of
from scenewright.core.solution import Solution
from scenewright.domains import alternatives, check, plan_of, solution_of, solve
from scenewright.domains.village.adjust import adjust
from scenewright.domains.village.locks import lock_village
from scenewright.engine.preference.events import Pick
from scenewright.formats import read
from scenewright.workflow.evolution.population import BreedingPlan
from scenewright.workflow.evolve import evolve


@pytest.fixture(scope="module")
def brief() -> Brief:
    return read("sample:village-hamlet")


@pytest.fixture(scope="module")
def solved(brief: Brief) -> Solution:
    return solve(brief, steps=1, seed=2)


def houses(solution: Solution) -> dict[str, tuple[float, ...]]:
    return {p.id: tuple(p.pose) for p in solution.pieces if p.category == "building"}


def test_who_watches_is_told_boxes_that_make_the_same_village(brief: Brief) -> None:
    heard: list[BestLayout] = []
    solution = solve(brief, steps=3, seed=1, watch=heard.append)
    assert {best.space for best in heard} == {space.id for space in plan_of(brief).spaces}
    again = solution_of(brief, {heard[-1].space: heard[-1].rows()})
    mine, theirs = (sorted(houses(one).values()) for one in (solution, again))
    assert np.array(mine) == pytest.approx(np.array(theirs), abs=1e-6)


def test_a_run_that_is_stopped_has_one_whole_layout(brief: Brief) -> None:
    asked: list[bool] = []

    def cancel() -> bool:
        asked.append(True)
        return True

    solution = solve(brief, steps=50, seed=1, cancel=cancel)
    assert asked
    assert solution.evaluations < 3
    assert check(solution).valid


def test_the_same_seed_gives_the_same_village_and_another_another(
    brief: Brief, solved: Solution
) -> None:
    assert houses(solve(brief, steps=1, seed=2)) == houses(solved)
    assert houses(solve(brief, steps=1, seed=3)) != houses(solved)


def test_locked_houses_stay_and_count(solved: Solution) -> None:
    kept = list(houses(solved))[:3]
    pieces = tuple(replace(p, fixed=p.id in kept) for p in solved.pieces)
    again = solve(lock_village(replace(solved, pieces=pieces)), steps=1, seed=9)
    assert all(houses(again)[name] == pytest.approx(houses(solved)[name]) for name in kept)
    assert len(houses(again)) == len(houses(solved))
    assert check(again).valid


def test_a_house_moved_by_hand_makes_others_give_way(solved: Solution) -> None:
    first, second, *_ = houses(solved)
    target = houses(solved)[second]
    moved = adjust(solved, Edits({first: (target[0], target[1])}, (), (), (), ()), steps=1)
    assert houses(moved.solution)[first][:2] == pytest.approx(target[:2])
    pieces = [p for p in moved.solution.pieces if p.category == "building"]
    shapes = [shapely.Polygon(outline_of(p)) for p in pieces]
    for k, one in enumerate(shapes):
        assert all(one.intersection(other).area < 0.1 for other in shapes[:k])


def test_alternatives_differ_and_are_valid(brief: Brief) -> None:
    found = alternatives(brief, 3, steps=1)
    assert len({str(houses(one)) for one in found}) == 3
    assert all(check(one).valid for one in found)


def test_a_person_is_shown_villages_to_choose_from(brief: Brief) -> None:
    evolution = evolve(brief, breeding=BreedingPlan(first=6, each=4))
    shown = tuple(one.number for one in evolution.ask().candidates)
    evolution.tell(Pick(shown[0], shown))
    assert len(evolution.ask().candidates) >= 2
