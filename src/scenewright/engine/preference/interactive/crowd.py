"""Generations that a person rates: whom she is asked of next, from all she has said.

All is a function of the method, the first seed and what was said of every sheet; so the same log
gives the same sheets, and what was taken back is as if it had not been said.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.breeding import Genome, MatrixBreeder
from scenewright.engine.preference.alleles.art1 import STAGES
from scenewright.engine.preference.alleles.preference import measure_difference
from scenewright.engine.preference.interactive.estimates import (
    ELITES,
    MIDDLE,
    RatedLayouts,
    value_elites,
)
from scenewright.engine.preference.interactive.methods import InteractiveMethod
from scenewright.engine.preference.interactive.takeover import (
    describe_takeover,
    rate_by_network,
    try_network,
)

Floats = NDArray[np.float64]
ALIKE, SAME = 0.1, 0.95
"""Mean difference in stars, and share of equal cells, at which layouts count as alike."""
BARREN = 20
"""Generations without anything new after which layouts are drawn by chance."""


class Crowd(NamedTuple):
    """Where a method is: the number of its generation, from 0, its ``genomes``, those ``asked`` of,
    all that was ``rated`` in order, the stage of the takeover, whether it searches around the best
    (``local``), what is to be told (``notes``), and how many generations a network rated so far
    (``alone``)."""

    age: int
    genomes: tuple[Genome, ...]
    asked: tuple[Genome, ...]
    rated: tuple[tuple[Genome, float], ...] = ()
    stage: int = 0
    local: bool = False
    notes: tuple[str, ...] = ()
    alone: int = 0


class CrowdRun(NamedTuple):
    """What generations are bred by: a method, the matrices of a brief, the first seed."""

    method: InteractiveMethod
    matrix: MatrixBreeder
    seed: int

    def chance(self, age: int) -> np.random.Generator:
        """The stream of chance of a generation."""
        return np.random.default_rng([self.seed, 7, age])


def follow(
    method: InteractiveMethod,
    matrix: MatrixBreeder,
    seed: int,
    heard: Sequence[Mapping[Genome, float]],
) -> Crowd:
    """The state of a method after the sheets ``heard``, each the stars by genome; a candidate
    shown and not rated counts as :data:`MIDDLE`."""
    run = CrowdRun(method, matrix, seed)
    crowd = begin_crowd(run)
    for ratings in heard:
        crowd = hear_sheet(run, crowd, ratings)
    return crowd


def begin_crowd(run: CrowdRun) -> Crowd:
    """The first generation, shown whole."""
    first = run.matrix.draw(run.matrix.population, run.method.led, run.chance(0))
    return _ask(run, Crowd(0, tuple(first), ()))


def _ask(run: CrowdRun, crowd: Crowd) -> Crowd:
    """Whom to ask of in a generation: those that were not rated, as many as the method asks of, the
    whole first generation; where all were, in the next that has any."""
    for _ in range(BARREN):
        known = {genome for genome, _ in crowd.rated}
        new = list(dict.fromkeys(one for one in crowd.genomes if one not in known))
        if new:
            many = run.method.asked if crowd.rated and run.method.asked else len(new)
            return crowd._replace(asked=tuple(new[:many]))
        crowd = _breed(run, crowd, _value(run, crowd))
    rng = run.chance(crowd.age)
    fresh = tuple(run.matrix.draw(run.matrix.population, False, rng))
    note = f"nothing new in {BARREN} generations: drawn by chance"
    return crowd._replace(genomes=fresh, asked=fresh, notes=(*crowd.notes, note))


def hear_sheet(run: CrowdRun, crowd: Crowd, ratings: Mapping[Genome, float]) -> Crowd:
    """The next generation to ask of, after what was said of this one."""
    method, begun = run.method, crowd.age
    given = tuple((one, float(ratings.get(one, MIDDLE))) for one in crowd.asked)
    before, alone, notes = crowd.rated, 0, list[str]()
    crowd = crowd._replace(rated=(*before, *given))
    if method.network and before and crowd.stage < len(STAGES):
        test = try_network(_layouts(run, before), _layouts(run, given), STAGES[crowd.stage])
        if test.trusted:
            alone = min(STAGES[crowd.stage].generations, method.alone)
            crowd = crowd._replace(stage=crowd.stage + 1, alone=crowd.alone + alone)
        notes.append(describe_takeover(test, begun, alone))
    guessed = len(set(crowd.genomes) - {genome for genome, _ in crowd.rated})
    if guessed:
        notes.append(f"generation {begun + 1}: {len(given)} rated by you, {guessed} estimated")
    crowd = _breed(run, crowd, _value(run, crowd))
    for _ in range(alone):
        values = rate_by_network(_layouts(run, crowd.rated), _read(run, crowd.genomes))
        crowd = _breed(run, crowd, values)
    if crowd.local:
        notes.append("the layouts are alike: the search goes on around the best")
    return _ask(run, crowd._replace(notes=tuple(notes)))


def _value(run: CrowdRun, crowd: Crowd) -> Floats:
    """What each layout of a generation is worth: the stars it was given, else an estimate."""
    known, rng = dict(crowd.rated), run.chance(10_000 + crowd.age)
    layouts = _layouts(run, crowd.rated)
    estimate = run.method.estimate

    def value(genome: Genome) -> float:
        if genome in known:
            return known[genome]
        row = np.array(run.matrix.read(genome), np.int64)
        return MIDDLE if estimate is None else estimate(layouts, row, rng)

    return np.array([value(genome) for genome in crowd.genomes])


def _breed(run: CrowdRun, crowd: Crowd, values: Floats) -> Crowd:
    """The next generation: around the best once all are alike, else of parents drawn."""
    method, matrix, rng = run.method, run.matrix, run.chance(crowd.age + 1)
    best, many = crowd.genomes[int(values.argmax())], matrix.population
    local = crowd.local or _is_alike(method, crowd.genomes, values)
    worth = value_elites(_layouts(run, crowd.rated), ELITES) if method.worth else None
    made = list[Genome]()
    while len(made) < many and not local:
        one, other = (crowd.genomes[k] for k in _draw_pair(method, values, rng))
        pair = (one, other)
        if rng.random() < matrix.crossover:
            pair = matrix.cross(one, other, method.points, rng)
        made += [matrix.mutate(child, rng, worth) for child in pair]
    if local:
        made = [matrix.vary(best, rng) for _ in range(many)]
    kept = [best, *made] if method.keep else made
    return crowd._replace(age=crowd.age + 1, genomes=tuple(kept[:many]), local=local)


def _draw_pair(
    method: InteractiveMethod, values: Floats, rng: np.random.Generator
) -> tuple[int, int]:
    """Two parents: each the better of two, or in proportion to what they are worth."""
    if method.tournament:
        drawn = rng.integers(0, len(values), (2, 2))
        one, other = drawn[[0, 1], values[drawn].argmax(1)].tolist()
        return one, other
    one, other = rng.choice(len(values), 2, p=values / values.sum()).tolist()
    return one, other


def _is_alike(method: InteractiveMethod, genomes: Sequence[Genome], values: Floats) -> bool:
    """Whether the global search has ended: by (12) on the ratings, or by the genes."""
    if method.alike == "ratings":
        return measure_difference(values, float(values.mean()), ALIKE) <= 0.0
    rows = np.array(genomes)
    return method.alike == "genes" and float((rows == rows[0]).mean()) > SAME


def _read(run: CrowdRun, genomes: Sequence[Genome]) -> NDArray[np.int64]:
    return np.array([run.matrix.read(genome) for genome in genomes], np.int64)


def _layouts(run: CrowdRun, rated: Sequence[tuple[Genome, float]]) -> RatedLayouts:
    stars = np.array([given for _, given in rated])
    return RatedLayouts(
        _read(run, [one for one, _ in rated]), stars, np.array(run.matrix.qualities)
    )
