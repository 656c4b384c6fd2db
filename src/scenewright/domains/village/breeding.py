"""Villages bred block by block: a genome says of which sizes the houses of each are, and its draw.

What was grown of a block is kept, so that most of a new village is put together of known blocks.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from scenewright.core.breeding import Breeder, Gene, Genome
from scenewright.core.brief import Brief
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.village.build_problem import build_problem
from scenewright.domains.village.lanes import lay_village_lanes, with_lanes
from scenewright.domains.village.presets import PRESETS
from scenewright.domains.village.solvers import VILLAGE_SOLVERS
from scenewright.domains.village.solving import FilledBlock, assemble_solution, furnish_block
from scenewright.engine.solve import Budget

PRESET, SOLVER = "quick", "grow"
MIXES = (None, (0.6, 0.3, 0.1), (0.2, 0.6, 0.2), (0.1, 0.3, 0.6))
"""Shares of small, medium and large houses, where the brief states none; None: as real blocks of
the kind have them."""
CHANCES = 24
MOST_BLOCKS = 8
"""Blocks that have genes of their own; all further ones share the last."""
APART, FURTHER = 7919, 104729
"""Steps of the seed from one block, and from one draw, to the next: primes."""


class BlockWish(NamedTuple):
    """How one block is filled: the mix of sizes, and chance."""

    mix: int
    chance: int


def make_breeder(brief: Brief, plan: Plan, seed: int = 0) -> Breeder:
    """Genes of a village, for each block: which sizes of houses it has, and the draw of chance."""
    settings, lanes = PRESETS[PRESET].settings, lay_village_lanes(plan.detail)
    village = with_lanes(plan.detail, lanes)
    own = min(max(len(village.blocks), 1), MOST_BLOCKS)
    parts = {"sizes": len(MIXES), "chance": CHANCES}
    genes = tuple(Gene(f"{part} {k + 1}", n) for k in range(own) for part, n in parts.items())

    @cache
    def filled(place: int, wish: BlockWish) -> FilledBlock:
        block, one = brief.part.blocks[place], village.blocks[place]
        problem = build_problem(block, one, village, settings)
        problem = problem._replace(sizes=problem.sizes or MIXES[wish.mix])
        drawn = seed + APART * place + FURTHER * wish.chance
        answer = VILLAGE_SOLVERS[SOLVER].run(problem, Budget(None, 1, threads=1), drawn)
        told = problem, answer.layouts[0], answer.evaluations, drawn
        return furnish_block(block, one, village, *told)

    def develop(genome: Genome) -> Solution:
        wishes = read_genome(genome)
        found = [filled(k, wishes[min(k, own - 1)]) for k in range(len(village.blocks))]
        return assemble_solution(brief, found, PRESET, SOLVER, seed, 0.0, lanes)

    return Breeder(genes, develop)


def read_genome(genome: Genome) -> list[BlockWish]:
    """How a genome says that each block is to be filled.

    >>> read_genome((1, 0, 2, 7))
    [BlockWish(mix=1, chance=0), BlockWish(mix=2, chance=7)]
    """
    return [BlockWish(*genome[k : k + 2]) for k in range(0, len(genome), 2)]
