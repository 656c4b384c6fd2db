"""Halls bred by proposal of zones, patterns and chance."""

from __future__ import annotations

from functools import partial

from scenewright.core.breeding import Breeder, Gene, Genome
from scenewright.core.brief import Brief
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.hall.solving import solve

ZONES, PATTERNS, SEEDS = 6, 12, 8
"""Proposals of zones, ways to narrow the patterns, and seeds to choose from."""
EACH = 12
"""Candidates of a later sheet: each is a hall solved."""


def make_breeder(brief: Brief, plan: Plan, seed: int = 0) -> Breeder:
    """Genes of a hall: which proposal of zones (where the brief leaves them open), to which of
    its patterns each demand is narrowed, and the seed."""
    genes = (Gene("zones", ZONES), Gene("patterns", PATTERNS), Gene("chance", SEEDS))
    return Breeder(genes, partial(_develop, brief, plan, seed), each=EACH)


def _develop(brief: Brief, plan: Plan, seed: int, genome: Genome) -> Solution:
    variant, lean, chance = genome
    return solve(brief, plan=plan, seed=seed + chance, variant=variant, lean=lean, threads=1)
