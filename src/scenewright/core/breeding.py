"""How a domain makes one layout of a brief out of many: genes, and what they develop into."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

from scenewright.core.solution import Solution

Genome = tuple[int, ...]
"""One allele a gene, counted from 0."""


class Gene(NamedTuple):
    """One choice a layout is made by, and how many alleles there are to choose from."""

    name: str
    alleles: int


class Breeder(NamedTuple):
    """The ``genes`` of a brief's layouts, and ``develop``, which solves the brief as a genome
    says: the same genome gives the same solution, of the brief as it was given. It may be called
    by several threads. ``measure`` tells the features of what a genome develops into, and how
    much that was asked for it lacks, where that is far quicker than developing it: of known
    parts put together anew, of buildings without ways. NaN is what only developing
    tells; there need be no features where something lacks."""

    genes: tuple[Gene, ...]
    develop: Callable[[Genome], Solution]
    measure: Callable[[Genome], tuple[Mapping[str, float], int]] | None = None
