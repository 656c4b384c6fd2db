"""The candidates of an evolution and how more of them are bred on what the model predicts."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright import domains
from scenewright.core.breeding import Breeder, Gene, Genome
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.engine.preference.screens import find_unknown
from scenewright.engine.preference.taste import PersonTaste, judge_each

Floats = NDArray[np.float64]
BESIDE = 2
"""Of how many of the best genomes the neighbours are looked at."""


class BreedingPlan(NamedTuple):
    """How many candidates there are before the first screen and how many are bred for each later
    one, at most: the second half of them once a layout of the one before is marked; ``alleles`` of
    a gene that may be used at first, and how many more with each screen; ``fresh`` share of
    children made without parents, ``mutated`` genes of a child on average, ``crossed`` share of
    children of two parents, ``parents`` that children are made of; ``rounds`` of so large a
    ``brood`` are bred unseen where genomes can be measured by themselves, by what is predicted and
    ``hope`` times its standard deviation."""

    first: int = 24
    each: int = 24
    alleles: int = 8
    more: int = 4
    fresh: float = 0.2
    mutated: float = 1.2
    crossed: float = 0.7
    parents: int = 12
    rounds: int = 3
    brood: int = 64
    hope: float = 0.7


class BredLayout(NamedTuple):
    """One candidate: its genome (empty: changed by hand), its features (D,), how much that was
    asked for it lacks, and whether no rule is broken."""

    genome: Genome
    values: Floats
    lacking: int
    valid: bool

    def record(self) -> dict[str, Any]:
        """Plain values, ready for JSON."""
        return {**self._asdict(), "genome": list(self.genome), "values": self.values.tolist()}


class BreedingGround(NamedTuple):
    """What candidates are bred on: the plan of a brief and its breeder."""

    plan: Plan
    breeder: Breeder


def bred_of(record: dict[str, Any]) -> BredLayout:
    """The candidate a record holds."""
    values = np.array(record["values"], np.float64)
    return BredLayout(
        tuple(record["genome"]), values, int(record["lacking"]), bool(record["valid"])
    )


def measure_solution(solution: Solution, plan: Plan, genome: Genome = ()) -> BredLayout:
    """A solution as a candidate."""
    values = np.array(list(domains.features_of(solution, plan).values()), np.float64)
    lacking = sum(out.required for out in solution.left_out)
    valid = domains.check(solution, plan=plan, figures=False).valid
    return BredLayout(genome, np.nan_to_num(values), lacking, valid)


def draw_genomes(
    genes: Sequence[Gene], open_: int, count: int, rng: np.random.Generator
) -> list[Genome]:
    """``count`` genomes by chance, of the first ``open_`` alleles of each gene."""
    most = [min(gene.alleles, open_) for gene in genes]
    return [tuple(int(rng.integers(0, top)) for top in most) for _ in range(count)]


def breed_genomes(
    genes: Sequence[Gene],
    parents: Sequence[Genome],
    known: set[Genome],
    number: int,
    rng: np.random.Generator,
    how: BreedingPlan,
    open_: int = 0,
) -> list[Genome]:
    """Genomes of batch ``number`` that are not ``known``: some by chance, else of one or two
    ``parents``, the best first; fewer where there are no more. The first ``open_``
    alleles of each gene may be used (0: as many as suit the batch)."""
    count = how.each if number else how.first
    open_ = open_ or count_open(genes, len(known), number, how)
    made: dict[Genome, None] = {}
    for _ in range(20 * count):
        if len(made) == count:
            break
        if not parents or rng.random() < how.fresh:
            child = draw_genomes(genes, open_, 1, rng)[0]
        else:
            child = _make_child(genes, parents, open_, rng, how)
        if child not in known:
            made[child] = None
    return list(made)


def count_open(genes: Sequence[Gene], known: int, number: int, how: BreedingPlan) -> int:
    """How many alleles of each gene may be used in batch ``number``: a few more with each, and at
    least as many as make the genomes that are ``known`` and those wanted."""
    least, wanted = how.alleles + how.more * number, how.first + known
    most = max((gene.alleles for gene in genes), default=1)
    for open_ in range(least, most):
        if math.prod(min(gene.alleles, open_) for gene in genes) >= wanted:
            return open_
    return max(least, most)


def _make_child(
    genes: Sequence[Gene],
    parents: Sequence[Genome],
    open_: int,
    rng: np.random.Generator,
    how: BreedingPlan,
) -> Genome:
    """A child of a good parent, often crossed with another, with some genes drawn anew."""
    one, other = (parents[int(len(parents) * rng.random() ** 2)] for _ in range(2))
    mixed = rng.random() < how.crossed
    child = [b if mixed and rng.random() < 0.5 else a for a, b in zip(one, other, strict=True)]
    rate = how.mutated / max(len(genes), 1)
    for k, gene in enumerate(genes):
        if rng.random() < rate:
            child[k] = int(rng.integers(0, min(gene.alleles, open_)))
    return tuple(child)


def rank_parents(taste: PersonTaste, bred: Sequence[BredLayout], count: int) -> list[Genome]:
    """Genomes of the most promising sane candidates, best first: predicted mean and half a
    standard deviation."""
    rows = [one for one in bred if one.genome and one.valid]
    if not rows or (taste.posterior is None and not taste.start.any()):
        return []
    mean, deviation = judge_each(taste, np.array([one.values for one in rows]))
    order = np.argsort(-(mean + 0.5 * deviation), kind="stable")[:count]
    return [rows[k].genome for k in order.tolist()]


def fit_breeding(how: BreedingPlan, breeder: Breeder, part: int | None = None) -> BreedingPlan:
    """A plan with no more candidates than a breeder makes for one sheet; of them the first
    (``part`` 0) or the second half (1), if one is named. Broods too small to choose from are none.

    >>> slow = Breeder((), lambda genome: None, each=13, unseen=100)
    >>> [fit_breeding(BreedingPlan(), slow, part)[1] for part in (None, 0, 1)]
    [13, 7, 6]
    """
    each = min(how.each, breeder.each)
    shares = {None: each, 0: each - each // 2, 1: each // 2}
    brood = min(how.brood, breeder.unseen // (1 if part is None else 2) // (how.rounds + 2))
    return how._replace(each=shares[part], brood=brood)


def choose_genomes(
    breeder: Breeder,
    taste: PersonTaste | None,
    bred: Sequence[BredLayout],
    coming: Sequence[Genome],
    number: int,
    rng: np.random.Generator,
    how: BreedingPlan,
    wide: int = 0,
) -> list[Genome]:
    """Genomes of batch ``number``, after those that are ``bred`` and those ``coming``: by chance
    before anything is, then by what is predicted, ``wide`` of them to learn from."""
    parents = rank_parents(taste, bred, how.parents) if taste else []
    known = {*coming, *(one.genome for one in bred if one.genome)}
    begun = breed_genomes(breeder.genes, parents, known, number if bred else 0, rng, how)
    if taste is None or not bred:
        return list(dict.fromkeys((*breeder.first, *begun)))[: how.first]
    return breed_further(breeder, taste, [*parents, *begun], known, number, rng, how, wide)


def breed_further(
    breeder: Breeder,
    taste: PersonTaste,
    begun: Sequence[Genome],
    known: set[Genome],
    number: int,
    rng: np.random.Generator,
    how: BreedingPlan,
    wide: int = 0,
) -> list[Genome]:
    """Genomes bred by what is predicted, from genomes ``begun``, where genomes can be measured
    without developing them: ``wide`` of them to learn from, the others what is predicted best
    after ``how.rounds`` generations."""
    if breeder.measure is None or taste.posterior is None or not how.brood:
        return [genome for genome in begun if genome not in known][: how.each]
    open_ = count_open(breeder.genes, len(known), number, how)
    pool: dict[Genome, Floats] = {}
    drawn = draw_genomes(breeder.genes, open_, how.brood, rng)
    _measure_into(pool, breeder, drawn, taste.scale.middle)
    unseen = [genome for genome in pool if genome not in known]
    measured = np.array([pool[genome] for genome in unseen])
    chosen = [unseen[k] for k in find_unknown(taste, measured, wide)] if wide and unseen else []
    parents = _rank(taste, pool, list(begun), breeder, how)
    for _ in range(how.rounds):
        brood = how._replace(each=how.brood)
        children = breed_genomes(breeder.genes, parents, set(pool), 1, rng, brood, open_)
        parents = _rank(taste, pool, children, breeder, how)
    near = [child for one in parents[:BESIDE] for child in _list_neighbours(one, breeder, open_)]
    some = [near[k] for k in rng.permutation(len(near))[: how.brood].tolist()]
    _rank(taste, pool, some, breeder, how)
    mean, _ = judge_each(taste, np.array(list(pool.values())))
    ranked = [list(pool)[k] for k in np.argsort(-mean, kind="stable").tolist()]
    return _keep_different(pool, known, chosen + ranked)[: how.each]


def _keep_different(
    pool: dict[Genome, Floats], known: set[Genome], ranked: Sequence[Genome]
) -> list[Genome]:
    """Of some genomes those that are not known, nor look like one that is or came before: many a
    gene has no say."""
    looks = {pool[genome].round(9).tobytes() for genome in pool if genome in known}
    found = []
    for genome in ranked:
        look = pool[genome].round(9).tobytes()
        if look not in looks:
            found.append(genome)
            looks.add(look)
    return found


def _rank(
    taste: PersonTaste,
    pool: dict[Genome, Floats],
    more: Sequence[Genome],
    breeder: Breeder,
    how: BreedingPlan,
) -> list[Genome]:
    """The most promising of a ``pool`` that some more are taken into, best first."""
    _measure_into(pool, breeder, more, taste.scale.middle)
    mean, deviation = judge_each(taste, np.array(list(pool.values())))
    order = np.argsort(-(mean + how.hope * deviation), kind="stable")[: 2 * how.parents]
    ranked = list(pool)
    return [ranked[k] for k in order.tolist()]


def _measure_into(
    pool: dict[Genome, Floats], breeder: Breeder, genomes: Sequence[Genome], usual: Floats
) -> None:
    """Measure genomes and add those to a ``pool`` that lack no more than the others; what cannot
    be measured is as ``usual`` (D,)."""
    assert breeder.measure is not None
    measured = {genome: breeder.measure(genome) for genome in genomes if genome not in pool}
    known = [lacking for values, lacking in measured.values() if values]
    least = 0 if pool else min(known, default=0)
    for genome, (values, lacking) in measured.items():
        if values and lacking <= least:
            row = np.array(list(values.values()))
            pool[genome] = np.where(np.isnan(row), usual, row)


def _list_neighbours(genome: Genome, breeder: Breeder, open_: int) -> list[Genome]:
    """All genomes that differ in one gene, by one of the first ``open_`` alleles."""
    return [
        (*genome[:k], allele, *genome[k + 1 :])
        for k, gene in enumerate(breeder.genes)
        for allele in range(min(gene.alleles, open_))
        if allele != genome[k]
    ]


def develop(ground: BreedingGround, genome: Genome) -> tuple[BredLayout, Solution]:
    """What a genome develops into, measured."""
    solution = ground.breeder.develop(genome)
    return measure_solution(solution, ground.plan, genome), solution


def is_sane(bred: BredLayout, least: int) -> bool:
    """Whether a candidate may be shown: no rule broken, nothing lacking that others have."""
    return bred.valid and bred.lacking <= least
