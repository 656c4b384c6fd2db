"""Where simulated persons look for layouts: briefs whose layouts are made and measured quickly.

A home is put together from rooms solved beforehand, so any genome can be had in a fraction of a
millisecond. Of a site only the buildings are placed, without ways and trees, which takes some
hundredths of a second.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright import domains
from scenewright.core.breeding import Breeder, Gene, Genome
from scenewright.core.solution import Solution
from scenewright.domains.site.breeding import draft_site, prepare_grounds
from scenewright.domains.site.features import DEVELOPED
from scenewright.engine.preference.features import boxes_of, stands_on_floor
from scenewright.engine.preference.taste import FeatureScale, Reasons, measure_scale
from scenewright.formats import read
from scenewright.workflow.evolution.population import BreedingPlan, draw_genomes

Floats = NDArray[np.float64]
UNSEEN = 3
"""Measures that the engine does not see."""
ALLELES = 24
"""Answers a room of the home is taken from."""
FIRST = 200
"""Genomes by chance that scales are measured on."""


class SeenLayout(NamedTuple):
    """A layout: features (D,) that the engine sees, ``unseen`` ones (3,), and what it lacks."""

    values: Floats
    unseen: Floats
    lacking: int


class World(NamedTuple):
    """A brief to evolve: its ``genes``, ``look`` at what a genome stands for, the scale of the
    features, the reasons of its domain and its breeder."""

    name: str
    genes: tuple[Gene, ...]
    look: Callable[[Genome], SeenLayout]
    scale: FeatureScale
    reasons: Reasons
    breeder: Breeder


def measure_unseen(solution: Solution) -> Floats:
    """Three things that somebody may like and no feature tells: whether what stands, what is tall
    and what is large is in favourite spots, by waves over the plan."""
    pieces = [p for p in solution.pieces if stands_on_floor(p)]
    boxes, tall = boxes_of(pieces), np.array([p.size.height for p in pieces])
    unit = float(np.ptp(boxes[:, :2], axis=0).max()) / 3.0
    x, y = boxes[:, 0] / unit, boxes[:, 1] / unit
    area = boxes[:, 3] * boxes[:, 4]
    return np.array(
        [
            np.sin(2.1 * x + 1.3 * y).mean(),
            (tall * np.sin(1.7 * y - 0.8 * x + 1.0)).sum() / tall.sum(),
            (area * np.cos(2.6 * x - 1.9 * y + 2.0)).sum() / area.sum(),
        ]
    )


def home_world(sample: str = "home-flat") -> World:
    """A flat of ten rooms."""
    brief = read(f"sample:{sample}")
    plan = domains.plan_of(brief)
    breeder = domains.breeder_of(brief, plan)
    genes = tuple(Gene(gene.name, ALLELES) for gene in breeder.genes)
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(breeder.develop, [tuple([k] * len(genes)) for k in range(ALLELES)]))
    measure = breeder.measure
    assert measure is not None
    names: list[str] = []
    known: dict[Genome, SeenLayout] = {}

    def look(genome: Genome) -> SeenLayout:
        if genome not in known:
            told, lacking = measure(genome)
            names[:] = list(told)
            unseen = measure_unseen(breeder.develop(genome))
            known[genome] = SeenLayout(np.array(list(told.values())), unseen, lacking)
        return known[genome]

    rng = np.random.default_rng(0)
    rows = [look(genome) for genome in draw_genomes(genes, ALLELES, FIRST, rng)]
    scale = measure_scale(names, np.array([row.values for row in rows]))
    return World(
        sample, genes, look, scale, domains.reasons_of("home"), breeder._replace(genes=genes)
    )


def site_world(sample: str = "site-30") -> World:
    """A site of thirty buildings; where a genome leaves some out, what it develops into."""
    brief = read(f"sample:{sample}")
    plan = domains.plan_of(brief)
    breeder, ready = domains.breeder_of(brief, plan), prepare_grounds(brief, plan)
    usual = domains.features_of(breeder.develop((0,) * len(breeder.genes)), plan)
    names, known = list(usual), dict[Genome, SeenLayout]()

    drafts: dict[Genome, tuple[SeenLayout | None, int]] = {}

    def describe(solution: Solution) -> SeenLayout:
        lacking = sum(out.required for out in solution.left_out)
        told = domains.features_of(solution, plan) | {name: usual[name] for name in DEVELOPED}
        values = np.array([told[name] for name in names])
        return SeenLayout(values, measure_unseen(solution), lacking)

    def draft(genome: Genome) -> tuple[SeenLayout | None, int]:
        if genome not in drafts:
            solution, lacking = draft_site(ready, genome)
            drafts[genome] = (None if solution is None else describe(solution), lacking)
        return drafts[genome]

    def look(genome: Genome) -> SeenLayout:
        if genome not in known:
            row, _ = draft(genome)
            known[genome] = describe(breeder.develop(genome)) if row is None else row
        return known[genome]

    def measure(genome: Genome) -> tuple[dict[str, float], int]:
        row, lacking = draft(genome)
        return {} if row is None else dict(zip(names, row.values.tolist(), strict=True)), lacking

    drawn = draw_genomes(breeder.genes, 99, FIRST, np.random.default_rng(1))
    scale = measure_scale(names, np.array([look(genome).values for genome in drawn]))
    breeder = breeder._replace(measure=measure)
    return World(sample, breeder.genes, look, scale, domains.reasons_of("site"), breeder)


def breeding_of(world: World) -> BreedingPlan:
    """How ours breeds in a world: all alleles from the first screen on, for they are known."""
    del world
    return BreedingPlan(alleles=ALLELES)
