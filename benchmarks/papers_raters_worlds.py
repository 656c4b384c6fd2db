"""Sites and extensions that simulated raters rate as the shipped methods breed them.

Layouts are genomes of the matrix code of a brief, as ``evolve --method`` breeds them. Raters of
sites are those of :mod:`.papers_site_raters`; those of extensions are the persons of
:mod:`.person_raters`, here of matrices of plots: they like and dislike the four aims, shares of
kinds, and where things stand, and three waves over the ground that nothing tells of.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from benchmarks.papers_site_raters import SiteRater, like
from benchmarks.person_raters import SimulatedPerson
from benchmarks.person_world import FIRST, SeenLayout, World
from benchmarks.site_scenes import posed, scene_brief
from scenewright import domains
from scenewright.core.breeding import Breeder, Gene, Genome, MatrixBreeder
from scenewright.core.solution import Solution
from scenewright.domains import problems
from scenewright.domains.extend.matrix_breeding import make_matrix_breeder as plots_of
from scenewright.domains.extend.printed import PlotGrid, aims_of
from scenewright.domains.extend.solvers.paper import grid_of
from scenewright.domains.site.matrix_breeding import make_matrix_breeder, prepare_matrix
from scenewright.engine.preference.taste import FeatureScale, measure_scale
from scenewright.formats import read
from scenewright.workflow.evolution.population import draw_genomes

Floats = NDArray[np.float64]


class Rater(Protocol):
    """Somebody who rates layouts: how much one is truly liked, 0 as one by chance and 1 a standard
    deviation more, and stars as they are given."""

    def truth(self, genome: Genome) -> float: ...

    def rate(self, genomes: Sequence[Genome]) -> Floats: ...


class RatedWorld(NamedTuple):
    """A brief that raters by number look at: its matrices by first seed, and, where a taste can be
    learned, what is told of a layout and the scale of that."""

    matrix: Callable[[int], MatrixBreeder]
    rater: Callable[[int], Rater]
    look: Callable[[Genome], Floats] | None = None
    scale: FeatureScale | None = None


class _SiteRater(NamedTuple):
    inner: SiteRater
    boxes: Callable[[Genome], Floats]
    known: dict[Genome, float]

    def truth(self, genome: Genome) -> float:
        if genome not in self.known:
            self.known[genome] = like(self.inner.taste, self.boxes(genome))
        return self.known[genome]

    def rate(self, genomes: Sequence[Genome]) -> Floats:
        return self.inner.rate_liked([self.truth(genome) for genome in genomes])


def site_world(size: int) -> RatedWorld:
    """The scene of so many buildings; raters judge it as the default poses it."""
    brief = scene_brief(size)
    plan, problem = domains.plan_of(brief), posed(brief).problems["default"]
    boxes = prepare_matrix(brief, plan).boxes
    return RatedWorld(
        lambda seed: make_matrix_breeder(brief, plan, seed),
        lambda number: _SiteRater(SiteRater(problem, number), boxes, {}),
    )


def plots_world(sample: str) -> RatedWorld:
    """The plots of the one area of a sample."""
    brief = read(f"sample:{sample}")
    plan, grid = domains.plan_of(brief), grid_of(problems(brief)[0])
    world = plots_seen(grid)
    return RatedWorld(
        lambda seed: plots_of(brief, plan, seed),
        lambda number: SimulatedPerson(world, number),
        lambda genome: world.look(genome).values,
        world.scale,
    )


def plots_seen(grid: PlotGrid) -> World:
    """Matrices of plots as persons see them. By chance as much is built as is wanted: an allele
    above the number of kinds is a free plot."""
    kinds = len(grid.areas)
    share = grid.wanted / (float(grid.areas.mean()) * float(grid.free.sum()))
    genes = (Gene("plot", max(round(kinds / share), kinds + 1)),) * grid.free.size
    known: dict[Genome, SeenLayout] = {}

    def look(genome: Genome) -> SeenLayout:
        if genome not in known:
            matrix = np.array(genome, np.int64).reshape(grid.free.shape)
            built = np.where(grid.free & (matrix <= kinds), matrix, 0)
            known[genome] = SeenLayout(*_see(grid, built), 0)
        return known[genome]

    drawn = draw_genomes(genes, 99, FIRST, np.random.default_rng(1))
    values = np.array([look(genome).values for genome in drawn])
    names = [f"feature {k}" for k in range(values.shape[1])]
    return World("plots", genes, look, measure_scale(names, values), {}, Breeder(genes, _refuse))


def _refuse(genome: Genome) -> Solution:
    """Plots are judged as matrices: no method that is compared on them asks for a scene."""
    raise TypeError(f"plots are not developed into scenes: {genome}")


def _see(grid: PlotGrid, genes: NDArray[np.int64]) -> tuple[Floats, Floats]:
    """The aims, shares of kinds, where it is built and how closely (D,); three waves (3,)."""
    built = genes > 0
    middle = grid.middles - grid.middles.reshape(-1, 2).mean(0)
    unit = float(np.abs(middle).max())
    x, y = (middle[..., k] / unit for k in (0, 1))
    shares = [(genes == k + 1).mean() for k in range(len(grid.areas))]
    at = [np.where(built, v, 0.0).sum() / max(built.sum(), 1) for v in (x, y, np.hypot(x, y))]
    beside = [(built[1:] & built[:-1]).mean(), (built[:, 1:] & built[:, :-1]).mean()]
    waves = (np.sin(6 * x + 4 * y), np.sin(5 * y - 2 * x + 1), np.cos(8 * x - 6 * y + 2))
    unseen = [np.where(built, wave, 0.0).mean() for wave in waves]
    return np.array([*aims_of(grid, genes), *shares, *at, *beside]), np.array(unseen)
