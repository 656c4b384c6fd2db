"""The benchmark of persons: what it measures is what it says, on the smallest of runs."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from benchmarks import person
from benchmarks.person_raters import SimulatedPerson, like
from benchmarks.person_world import FIRST, World, home_world
from benchmarks.sheets import describe, measure

from scenewright.workflow.evolution.population import BreedingPlan, draw_genomes

KEYS = ["case", "metric", "unit", "ours", "baseline", "baseline_name", "ratio", "runs"]


@pytest.fixture(scope="module")
def world() -> World:
    return home_world("home-child")


def genomes(world: World, count: int) -> list[tuple[int, ...]]:
    return draw_genomes(world.genes, 99, count, np.random.default_rng(1))


def test_a_taste_is_measured_from_the_usual(world: World) -> None:
    one = SimulatedPerson(world, 3)
    values = [one.truth(genome) for genome in genomes(world, FIRST)]
    assert np.mean(values) == pytest.approx(0.0, abs=1e-9)
    assert np.std(values) == pytest.approx(1.0)
    other = SimulatedPerson(world, 4)
    told = [other.truth(genome) for genome in genomes(world, FIRST)]
    assert abs(np.corrcoef(values, told)[0, 1]) < 0.95
    row = world.look(genomes(world, 1)[0])
    hidden = like(one.taster._replace(unseen=np.zeros(3)), world, row)
    assert hidden != like(one.taster, world, row)


def test_a_person_tires(world: World) -> None:
    one, same = SimulatedPerson(world, 3), genomes(world, 2)
    apart = abs(one.truth(same[0]) - one.truth(same[1]))
    assert apart > 0.0
    first = one._tired()
    for _ in range(200):
        one.best(same)
    assert one._tired() > 1.9 * first
    stars = one.rate(genomes(world, 30))
    assert set(stars.tolist()) <= {1.0, 2.0, 3.0, 4.0, 5.0}


@pytest.mark.parametrize("method", person.METHODS)
def test_methods_tell_steps_that_only_grow(world: World, method: str) -> None:
    search, much = person.METHODS[method]
    steps = list(search(world, SimulatedPerson(world, 1), 1, min(much, 40) if much > 40 else 2))
    assert len(steps) > 1
    for before, after in pairwise(steps):
        assert after.actions > before.actions
        assert after.looks >= before.looks
        assert after.best >= before.best
    if method.startswith("ours"):
        assert steps[0].actions <= 6
        assert steps[-1].looks <= 24


def test_records_say_that_persons_are_simulated(world: World) -> None:
    small = {"ours": 3, person.NOISY: 2, "rated GA": 30, "TIGA": 30}
    runs = {}
    for method, much in small.items():
        search, _ = person.METHODS[method]
        one = SimulatedPerson(world, 2)
        steps = tuple(search(world, one, 2, much))
        runs[method] = [person.PersonRun(steps, tuple(one.truth(s.champion) for s in steps), 3.0)]
    records = list(person.summarise("home", runs))
    assert all(list(record) == KEYS for record in records)
    assert all("simulated" in record["case"] for record in records)


def test_waits_are_measured_from_asking() -> None:
    waits, breeding = measure("home-child", 1, 0.0)
    breeding.close()
    assert all(0.0 < few < many for few, many in zip(waits.four, waits.twelve, strict=True))
    assert len(waits.later) == 1
    assert waits.solved == BreedingPlan().first + BreedingPlan().each
    assert all(list(record) == KEYS for record in describe("a room", waits))
