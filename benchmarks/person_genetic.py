"""Interactive genetic algorithms, rated individual by individual: rated GA, TIGA and the paper's.

The paper's sizes: ten individuals, crossover 0.75, mutation 0.04; 284 ratings is what it says TIGA
asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from benchmarks.person_methods import SearchStep, draw_sane
from benchmarks.person_raters import SimulatedPerson
from benchmarks.person_world import World
from scenewright.core.breeding import Gene, Genome
from scenewright.engine.preference.alleles.art1 import (
    STAGES,
    Art1Settings,
    encode_alleles,
    learn_ratings,
    may_take_over,
    rate_pattern,
)
from scenewright.engine.preference.alleles.preference import (
    AlleleRecord,
    Form,
    accept_preference,
    estimate_fitness,
    observe_allele,
    prefer_allele,
)
from scenewright.engine.preference.alleles.subspaces import estimate_locally

Floats = NDArray[np.float64]
Estimate = Callable[..., float]
POPULATION, CROSSED, MUTATED = 10, 0.75, 0.04
TRIES = 30
"""Children of a pair that are tried until one holds all that was asked for."""
ASKED = 5
"""Individuals of a generation that the paper's method asks for; it estimates the others."""


def rated_ga(
    world: World, person: SimulatedPerson, seed: int, ratings: int
) -> Iterator[SearchStep]:
    """Tournaments of two, the best survives."""
    return _evolve(world, person, seed, ratings, True)


def tiga(world: World, person: SimulatedPerson, seed: int, ratings: int) -> Iterator[SearchStep]:
    """The traditional one: roulette on the ratings, no elite."""
    return _evolve(world, person, seed, ratings, False)


def _evolve(
    world: World, person: SimulatedPerson, seed: int, ratings: int, elite: bool
) -> Iterator[SearchStep]:
    rng, shown, given = np.random.default_rng([seed, 4]), set[Genome](), 0
    genomes = _begin(world, rng)
    champion, top, best = genomes[0], -1.0, -np.inf
    while given < ratings:
        told = person.rate(genomes)
        given, shown = given + len(genomes), shown | set(genomes)
        best = max(best, *(person.truth(g) for g in genomes))
        if told.max() >= top:
            champion, top = genomes[int(told.argmax())], float(told.max())
        yield SearchStep(given, len(shown), champion, best)
        genomes = breed(world, genomes, told, rng, champion if elite else None)


def paper(
    world: World, person: SimulatedPerson, seed: int, ratings: int, form: Form = "repaired"
) -> Iterator[SearchStep]:
    """Zhang, Yang 2023: allele preferences estimate half of each generation, an ART1 network
    rates whole generations once it may, in two stages."""
    return _evolve_estimated(world, person, seed, ratings, partial(estimate, form=form))


def paper_local(
    world: World, person: SimulatedPerson, seed: int, ratings: int
) -> Iterator[SearchStep]:
    """The same with the other estimate the paper gives: local models over sub-spaces, (13) to
    (21)."""
    return _evolve_estimated(world, person, seed, ratings, estimate_by_models)


def _evolve_estimated(
    world: World, person: SimulatedPerson, seed: int, ratings: int, guess: Estimate
) -> Iterator[SearchStep]:
    """Some of each generation are rated, the others estimated."""
    rng, shown = np.random.default_rng([seed, 5]), set[Genome]()
    rated: list[Genome] = []
    told: list[float] = []
    genomes, settings = _begin(world, rng), Art1Settings()
    champion, top, best, stage, alone = genomes[0], -1.0, -np.inf, 0, 0
    while len(rated) < ratings:
        alleles = [gene.alleles for gene in world.genes]
        if alone:
            network = learn_ratings(
                encode_alleles(np.array(rated), alleles), np.array(told), settings
            )
            bits = encode_alleles(np.array(genomes), alleles)
            fitness = np.array([rate_pattern(network, row, 3.0, settings) for row in bits])
            alone -= 1
        else:
            asked = genomes if not rated else genomes[:ASKED]
            given = person.rate(asked)
            if stage < len(STAGES) and rated:
                network = learn_ratings(
                    encode_alleles(np.array(rated), alleles), np.array(told), settings
                )
                bits = encode_alleles(np.array(asked), alleles)
                heard = np.array([rate_pattern(network, row, 3.0, settings) for row in bits])
                if may_take_over(given, heard, STAGES[stage]):
                    alone, stage = min(STAGES[stage].generations, 10), stage + 1
            rated += asked
            told += given.tolist()
            shown |= set(asked)
            best = max(best, *(person.truth(g) for g in asked))
            if given.max() >= top:
                champion, top = asked[int(given.argmax())], float(given.max())
            rest = [guess(world.genes, rated, told, g, rng) for g in genomes[len(asked) :]]
            fitness = np.array([*given, *rest])
            yield SearchStep(len(rated), len(shown), champion, best)
        genomes = breed(world, genomes, fitness, rng, champion)


def estimate(
    genes: tuple[Gene, ...],
    rated: list[Genome],
    told: list[float],
    genome: Genome,
    rng: np.random.Generator,
    form: Form = "repaired",
) -> float:
    """(7) for an individual not rated; genes of these worlds have no mesh, so τ is 1/2 for all."""
    rows, ratings = np.array(rated), np.array(told)
    records = []
    for gene, allele in enumerate(genome):
        carry = rows[:, gene] == allele
        wanted = prefer_allele(rows, ratings, gene, allele, form)
        seen = observe_allele(rows, gene, allele, genes[gene].alleles, form)
        used = accept_preference(wanted, seen, 0.5, 0.5, rng.random())
        fitness = float(ratings[carry].mean()) if carry.any() else 3.0
        records.append(AlleleRecord(used, 0.5, fitness))
    return estimate_fitness(records, 3.0, form)


def estimate_by_models(
    genes: tuple[Gene, ...],
    rated: list[Genome],
    told: list[float],
    genome: Genome,
    rng: np.random.Generator,  # noqa: ARG001
) -> float:
    """(21) for an individual not rated, over the bits of its genes."""
    alleles = [gene.alleles for gene in genes]
    points = encode_alleles(np.array([*rated, genome]), alleles)
    return estimate_locally(points[:-1], np.array(told), points[-1], 3.0)


def _begin(world: World, rng: np.random.Generator) -> list[Genome]:
    return list(islice(draw_sane(world, rng), POPULATION))


def breed(
    world: World,
    genomes: list[Genome],
    fitness: Floats,
    rng: np.random.Generator,
    elite: Genome | None,
) -> list[Genome]:
    """The next generation: two-point crossover of parents by tournament (by roulette without an
    elite) and single-point mutation. Children that lack what was asked for are not shown, as with
    ours; where :data:`TRIES` of them do, a parent is shown again."""
    made: list[Genome] = [] if elite is None else [elite]
    wheel = np.maximum(fitness, 1e-9) / np.maximum(fitness, 1e-9).sum()
    tried = 0
    while len(made) < len(genomes):
        tried += 1
        if elite is None:
            pair = rng.choice(len(genomes), 2, p=wheel)
        else:
            drawn = rng.integers(0, len(genomes), (2, 2))
            pair = drawn[[0, 1], fitness[drawn].argmax(1)]
        one, other = (genomes[k] for k in pair.tolist())
        child = list(one)
        if rng.random() < CROSSED:
            first, last = sorted(rng.integers(0, len(child) + 1, 2).tolist())
            child[first:last] = other[first:last]
        for k, gene in enumerate(world.genes):
            if rng.random() < MUTATED:
                child[k] = int(rng.integers(0, gene.alleles))
        if not world.look(tuple(child)).lacking or tried > TRIES:
            made.append(tuple(child) if tried <= TRIES else one)
            tried = 0
    return made


def find_best(world: World, person: SimulatedPerson, seed: int, generations: int) -> float:
    """What a search that knows the truth finds: the best of so many ``generations`` of a genetic
    algorithm of 60 individuals."""
    rng = np.random.default_rng([seed, 6])
    genomes = list(islice(draw_sane(world, rng), 60))
    best = -np.inf
    for _ in range(generations):
        fitness = np.array([person.truth(g) for g in genomes])
        best = max(best, float(fitness.max()))
        genomes = breed(world, genomes, fitness, rng, genomes[int(fitness.argmax())])
    return best
