"""Ways to find what a simulated person likes; each tells after every screen how far it is."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from itertools import islice
from typing import NamedTuple

import numpy as np

from benchmarks.person_raters import SimulatedPerson
from benchmarks.person_world import World, breeding_of
from scenewright.core.breeding import Genome
from scenewright.engine.preference import taste as tastes
from scenewright.engine.preference.events import (
    Event,
    Pick,
    Reason,
    Worst,
    champion_of,
    favourites_of,
)
from scenewright.engine.preference.kernel import Kernel
from scenewright.engine.preference.screens import ScreenMix, choose_screen
from scenewright.engine.preference.trust import TrustRecord, count_hit
from scenewright.workflow.evolution.population import (
    BredLayout,
    choose_genomes,
    draw_genomes,
    fit_breeding,
)

PICKS, WORSTS, REASONS = 3, 2, 1
"""Marks a screen: the best ones in order, the worst ones, and reasons why the best, the worst and
the second best are no better."""
LINEAR = tastes.TasteRule(Kernel(4.0, 0.0, 0.0), 0)


class SearchStep(NamedTuple):
    """After a screen: actions and looks so far, the layout the person has chosen, the best shown so
    far by the truth, and how far predictions could be trusted."""

    actions: int
    looks: int
    champion: Genome
    best: float
    trust: TrustRecord = TrustRecord()


Search = Callable[[World, SimulatedPerson, int, int], Iterator[SearchStep]]


def ours(world: World, person: SimulatedPerson, seed: int, screens: int) -> Iterator[SearchStep]:
    """As the product does it: six marks a screen."""
    return _learn(world, person, seed, screens, ScreenMix(), True)


def bradley_terry(
    world: World, person: SimulatedPerson, seed: int, screens: int
) -> Iterator[SearchStep]:
    """A linear model of pairs (Bradley, Terry 1952, over features): the same marks but no reasons,
    the best by its mean and some by chance."""
    return _learn(world, person, seed, screens, ScreenMix(learning=0, least=1, greedy=1.0), False)


def _learn(
    world: World, person: SimulatedPerson, seed: int, screens: int, mix: ScreenMix, ours_: bool
) -> Iterator[SearchStep]:
    how, known = breeding_of(world), dict[Genome, BredLayout]()
    numbers: list[Genome] = []
    events: list[Event] = []
    shown: set[Genome] = set()
    actions, best, trust = 0, -np.inf, TrustRecord()
    taste = tastes.PersonTaste(world.scale, None, np.zeros(len(world.scale.names)))
    rule = tastes.TasteRule() if ours_ else LINEAR
    halves = taste, taste
    for screen in range(screens):
        breeding = np.random.default_rng([seed, 2, screen])
        _breed(world, halves, known, numbers, screen, breeding, how, mix.wide(halves[0].statements))
        rows = [g for g in numbers if known[g].lacking == 0]
        values = np.array([known[g].values for g in rows])
        seen = np.array([g in shown for g in rows])
        kept = [g for g in _kept(events, numbers) if g in rows][: 1 + mix.favourites]
        places = [rows.index(g) for g in kept]
        rng = np.random.default_rng([seed, 1, screen])
        chosen = [rows[k] for k in choose_screen(taste, values, seen, places, rng, mix)]
        shown |= set(chosen)
        best = max(best, *(person.truth(g) for g in chosen))
        told = _mark(person, chosen, numbers, ours_)
        champion = numbers[told[0].best]  # type: ignore[union-attr]
        if taste.posterior is not None:
            mean, _ = tastes.judge_each(taste, np.array([known[g].values for g in chosen]))
            late = 2 * mix.wide(taste.statements) <= len(chosen)
            trust = count_hit(trust, mean.tolist(), chosen.index(champion), late)
        events += told
        actions += len(told)
        by_number = {k: known[g].values for k, g in enumerate(numbers)}
        learn = partial(tastes.learn_taste, world.scale, values=by_number, reasons=world.reasons)
        first = events[: len(events) - len(told) + 1]
        halves = taste, learn(events=first, rule=rule)
        taste = learn(events=events, rule=rule)
        yield SearchStep(actions, len(shown), champion, best, trust)


def _kept(events: list[Event], numbers: list[Genome]) -> list[Genome]:
    """The champion and favourites, as the product keeps them on the sheet."""
    champion = champion_of(events)
    first = [] if champion is None else [champion]
    return [numbers[number] for number in (*first, *favourites_of(events))]


def _breed(world, tastes_, known, numbers, screen, rng, how, wide) -> None:  # type: ignore[no-untyped-def]
    """The next candidates, as the product breeds them: half on the taste before the last screen,
    half on that after its first mark."""
    rows, genomes = list(known.values()), list[Genome]()
    for part, taste in enumerate(tastes_ if screen else tastes_[:1]):
        fitted = fit_breeding(how, world.breeder, part)
        told = world.breeder, taste, rows, genomes, screen, rng, fitted
        genomes = [*genomes, *choose_genomes(*told, 0 if part else wide)]
    for genome in genomes:
        row = world.look(genome)
        if genome not in known:
            known[genome] = BredLayout(genome, row.values, row.lacking, row.lacking == 0)
            numbers.append(genome)


def _mark(
    person: SimulatedPerson, chosen: list[Genome], numbers: list[Genome], reasons: bool
) -> list[Event]:
    """What a person says of a screen: the best in order, the worst, and reasons."""
    left, told = list(chosen), list[Event]()
    for kind, count, sign in ((Pick, PICKS, 1.0), (Worst, WORSTS, -1.0)):
        for _ in range(min(count, len(left) - 1)):
            one = person.best(left, sign)
            told.append(kind(numbers.index(one), tuple(numbers.index(g) for g in left)))
            left.remove(one)
    picks = [event.best for event in told if isinstance(event, Pick)]
    worst = [event.worst for event in told if isinstance(event, Worst)]
    spoken_of = [*picks[:1], *worst[-1:], *picks[1:2]]
    for number in spoken_of[: REASONS if reasons else 0]:
        words = person.reason(numbers[number])
        told += [Reason(number, words)] if words else []
    return told


def draw_sane(world: World, rng: np.random.Generator) -> Iterator[Genome]:
    """Genomes by chance that hold all that was asked for: no other layout is shown by ours."""
    while True:
        (genome,) = draw_genomes(world.genes, 99, 1, rng)
        if not world.look(genome).lacking:
            yield genome


def random_search(
    world: World, person: SimulatedPerson, seed: int, screens: int
) -> Iterator[SearchStep]:
    """Layouts by chance, twelve at a time with the champion; one pick a screen."""
    drawing, shown = draw_sane(world, np.random.default_rng([seed, 3])), set[Genome]()
    champion: Genome | None = None
    best = -np.inf
    for screen in range(screens):
        drawn = list(islice(drawing, 12))
        chosen = drawn if champion is None else [champion, *drawn[:11]]
        shown |= set(chosen)
        best = max(best, *(person.truth(g) for g in chosen))
        champion = person.best(chosen)
        yield SearchStep(screen + 1, len(shown), champion, best)
