"""Sites as matrices that a person breeds: the code, operators and sizes of Zhang, Yang 2023.

Operators are the repaired ones, which lose no building.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.catalog.loading import catalog_of
from scenewright.core.breeding import Breeder, Gene, Genome, MatrixBreeder
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.site.encodings.cell_moves import cross, random_genes, repair_genes
from scenewright.domains.site.encodings.cells import KIND, PART, TURN, SiteLattice, decode_genes
from scenewright.domains.site.encodings.refill import Amount, make_amount, mutate_surely, refill
from scenewright.domains.site.presets import PRESETS
from scenewright.domains.site.problem import Floats, Ints, SiteProblem
from scenewright.domains.site.solvers.lattice import make_cells
from scenewright.domains.site.solvers.seed_layouts import seed_layouts
from scenewright.domains.site.solving import build_site_problem, solve
from scenewright.domains.site.variants import Variant

PRESET, TURNS, AROUND = "paper-repaired", 4, 3
"""The preset that sites are bred by, turns of a building, and most mutations of a neighbour."""
MOST_CELLS = 10_000
"""Cells that a log keeps of a layout."""


class SiteMatrix(NamedTuple):
    """A site ready to be bred: its problem, its cells, what is to stand, parts of a building at
    most."""

    problem: SiteProblem
    cells: SiteLattice
    amount: Amount
    parts: int

    def pack(self, genes: Ints) -> Genome:
        """Genes (cells, 3) as one number a cell."""
        whole = (genes[:, KIND] * self.parts + genes[:, PART]) * TURNS + genes[:, TURN]
        return tuple(whole.tolist())

    def unpack(self, genome: Genome) -> Ints:
        """The other way round."""
        whole, turn = np.divmod(np.array(genome, np.int64), TURNS)
        kind, part = np.divmod(whole, self.parts)
        return np.ascontiguousarray(np.column_stack([kind, part, turn]))

    def fill(self, genes: Ints, rng: np.random.Generator) -> Genome:
        """Genes, with what they lack of what is to stand, as a genome."""
        refill(self.cells, genes, self.amount, rng)
        return self.pack(genes)

    def boxes(self, genome: Genome) -> Floats:
        """The buildings (n, 5) of a genome; of no width: left out."""
        found, used = np.empty((len(self.cells.members), 5)), np.zeros_like(self.cells.counts())
        decode_genes(self.cells, self.unpack(genome), used, found)
        return found

    def draw(self, count: int, led: bool, rng: np.random.Generator) -> list[Genome]:
        """First layouts: of local templates and led by visual quality, or by chance."""
        rule, quality = self.problem.settings.matrix, self.problem.buildings.quality
        made = list[Ints]()
        if led:
            rows = seed_layouts(self.problem, self.cells, rule.templates, int(rng.integers(2**31)))
            made = [row.reshape(-1, 3).astype(np.int64) for row in rows[:count]]
        share = 0.5 if led else 0.0
        made += [random_genes(self.cells, rng, quality, share) for _ in range(count - len(made))]
        return [self.fill(genes, rng) for genes in made]

    def cross(
        self, one: Genome, other: Genome, points: int, rng: np.random.Generator
    ) -> tuple[Genome, Genome]:
        """Crossover of the strings of cells, repaired and filled up."""
        first, second = (
            self.fill(repair_genes(self.cells, child, rng), rng)
            for child in cross(self.unpack(one), self.unpack(other), rng, points)
        )
        return first, second

    def mutate(self, genome: Genome, rng: np.random.Generator, worth: Floats | None) -> Genome:  # noqa: ARG002
        """Single-point mutation with the printed chance."""
        chance = PRESETS["paper"].settings.matrix.mutation
        return self.change(genome, 1, rng) if rng.random() < chance else genome

    def vary(self, genome: Genome, rng: np.random.Generator) -> Genome:
        """A neighbour: one to three mutations."""
        return self.change(genome, int(rng.integers(1, AROUND + 1)), rng)

    def change(self, genome: Genome, times: int, rng: np.random.Generator) -> Genome:
        """A genome with ``times`` mutations."""
        genes = self.unpack(genome)
        for _ in range(times):
            mutate_surely(self.cells, genes, self.amount, rng)
        return self.pack(genes)

    def read(self, genome: Genome) -> tuple[int, ...]:
        """The kind anchored at each cell, 0 for none."""
        genes = self.unpack(genome)
        return tuple(np.where(genes[:, PART] == 0, genes[:, KIND], 0).tolist())


def make_matrix_breeder(brief: Brief, plan: Plan, seed: int = 0) -> MatrixBreeder:
    """The matrix code of a brief of one site. Raises :class:`InputError` for several."""
    matrix = prepare_matrix(brief, plan)
    kinds, rule = len(matrix.cells.counts()), PRESETS["paper"].settings.matrix
    quality, cells = matrix.problem.buildings.quality, matrix.cells

    def develop(genome: Genome) -> Solution:
        variant = Variant(boxes=matrix.boxes(genome))
        given = {"preset": PRESET, "solver": "vp", "seed": seed, "threads": 1}
        return solve(brief, plan=plan, variant=variant, **given)  # type: ignore[arg-type]

    gene = Gene("cell", kinds * matrix.parts * TURNS)
    tau = [float(quality[cells.members[k : k + 1]].sum()) for k in cells.firsts[:-1]]
    return MatrixBreeder(
        Breeder((gene,) * cells.fits.shape[2], develop),
        tuple(tau),
        rule.population,
        rule.crossover,
        matrix.draw,
        matrix.cross,
        matrix.mutate,
        matrix.vary,
        matrix.read,
    )


def prepare_matrix(brief: Brief, plan: Plan) -> SiteMatrix:
    """The one site of a brief, ready to be bred."""
    if len(brief.part.sites) != 1:
        fault = f"a matrix is of one site, and the brief has {len(brief.part.sites)}"
        raise InputError(fault, "leave --method out, or the other sites")
    site, ground, catalog = brief.part.sites[0], plan.detail[0], catalog_of(brief.catalogs)
    choose, preset = bool(site.library), PRESETS[PRESET]
    _, problem = build_site_problem(site, ground, "sites[0]", catalog, preset, None, choose)
    cells = make_cells(problem)
    if cells.fits.shape[2] > MOST_CELLS:
        fault = f"the site is {cells.fits.shape[2]:,} cells large, of {MOST_CELLS:,} at most"
        raise InputError(fault, "leave --method out")
    amount = make_amount(problem.target, cells, problem.buildings.floors)
    return SiteMatrix(problem, cells, amount, int(cells.spans.prod(-1).max()) + 1)
