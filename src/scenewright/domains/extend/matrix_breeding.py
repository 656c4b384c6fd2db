"""Extensions as matrices of plots that a person breeds: Zhang and Fei (2017), section 5."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np

from scenewright.core.breeding import Breeder, BreedingStage, Gene, Genome, MatrixBreeder
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.extend.presets import PRESETS
from scenewright.domains.extend.printed import Floats, Genes, PlotGrid
from scenewright.domains.extend.rating import rate_layout
from scenewright.domains.extend.solvers.ants import run_ants
from scenewright.domains.extend.solvers.colony import (
    BredPlots,
    ColonySettings,
    draw_plot_matrix,
    mutate,
    step_plots,
    swap_blocks,
)
from scenewright.domains.extend.solvers.paper import WEIGHTS, build_plots, grid_of
from scenewright.domains.extend.solving import assemble_solution, furnish_area
from scenewright.domains.extend.stages import cluster_kinds, read_sources, tell_ants
from scenewright.domains.extend.staging import stage_extension
from scenewright.engine.trace import Step

QUALITY = 0.5
"""Visual quality of every kind of building: the paper measures none."""


class PlotMatrix(NamedTuple):
    """The plots of an area, ready to be bred; ``ants`` finds layouts by the colony, once."""

    grid: PlotGrid
    settings: ColonySettings
    ants: Callable[[], BredPlots]

    def shape(self, genome: Genome) -> Genes:
        """A genome as a matrix (m, n)."""
        return np.array(genome, np.int64).reshape(self.grid.free.shape)

    def draw(self, count: int, led: bool, rng: np.random.Generator) -> list[Genome]:
        """First layouts: the best that the ants found, or by chance."""
        drawn = list(self.ants().few[:count]) if led else []
        kinds = len(self.grid.areas)
        while len(drawn) < count:
            drawn.append(draw_plot_matrix(self.grid, kinds, rng))
        return [_flatten(genes) for genes in drawn]

    def cross(
        self,
        one: Genome,
        other: Genome,
        points: int,  # noqa: ARG002
        rng: np.random.Generator,
    ) -> tuple[Genome, Genome]:
        """Each with a block of the other."""
        a, b = self.shape(one), self.shape(other)
        return _flatten(swap_blocks(a, b, rng)), _flatten(swap_blocks(b, a, rng))

    def mutate(self, genome: Genome, rng: np.random.Generator, worth: Floats | None) -> Genome:
        """Each gene drawn anew with the printed chance, by what alleles are worth if known."""
        genes, kinds = self.shape(genome), len(self.grid.areas) + 1
        hit = (rng.random(genes.shape) < self.settings.mutation) & self.grid.free
        known = np.ones((len(genome), kinds)) if worth is None else worth
        return _flatten(mutate(genes, known.reshape(*genes.shape, kinds), hit, rng))

    def vary(self, genome: Genome, rng: np.random.Generator) -> Genome:
        """A neighbour: one plot changed, or two exchanged."""
        return _flatten(step_plots(self.grid, self.shape(genome), len(self.grid.areas), rng))


def make_matrix_breeder(brief: Brief, plan: Plan, seed: int = 0) -> MatrixBreeder:
    """The plots of a brief of one area. Raises :class:`InputError` for several."""
    made = plan.detail
    if len(made.areas) != 1:
        fault = f"a matrix is of one area, and the brief has {len(made.areas)}"
        raise InputError(fault, "leave --method out, or the other areas")
    stage = stage_extension(brief, plan, PRESETS["paper"].settings)
    (staged,) = stage.areas
    problem = staged.problem
    grid, rule = grid_of(problem), ColonySettings()

    @cache
    def ants() -> tuple[BredPlots, list[Step]]:
        heard = list[Step]()
        rng = np.random.default_rng([seed, 11])
        return run_ants(grid, WEIGHTS, None, rng, rule, hear=heard.append), heard

    def stages() -> tuple[BreedingStage, ...]:
        classes = cluster_kinds(brief, problem.pattern, stage.catalog)
        found, heard = ants()
        return (*read_sources(made, problem.pattern, classes), tell_ants(found, heard))

    matrix = PlotMatrix(grid, rule, lambda: ants()[0])

    def develop(genome: Genome) -> Solution:
        layout = rate_layout(problem, build_plots(problem, matrix.grid, matrix.shape(genome)))
        found = furnish_area(staged, layout, 1)
        return assemble_solution(stage, [found], "paper", "colony", seed, 0.0)

    kinds = len(matrix.grid.areas) + 1
    genes = (Gene("plot", kinds),) * matrix.grid.free.size
    return MatrixBreeder(
        Breeder(genes, develop),
        (QUALITY,) * kinds,
        rule.population,
        rule.crossover,
        matrix.draw,
        matrix.cross,
        matrix.mutate,
        matrix.vary,
        lambda genome: genome,
        stages,
    )


def _flatten(genes: Genes) -> Genome:
    return tuple(genes.ravel().tolist())
