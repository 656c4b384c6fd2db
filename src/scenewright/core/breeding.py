"""How a domain makes one layout of a brief out of many: genes, and what they develop into."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

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
    tells; there need be no features where something lacks. ``first`` are genomes that are quickest
    to develop of all: they begin the first batch, and can be looked at while it is bred. No more
    than ``each`` candidates are developed for a later sheet and no more than ``unseen`` measured:
    as many as two cores make while a person looks at one. They are counts, not seconds, so that
    the same marks lead to the same sheet on any machine."""

    genes: tuple[Gene, ...]
    develop: Callable[[Genome], Solution]
    measure: Callable[[Genome], tuple[Mapping[str, float], int]] | None = None
    first: tuple[Genome, ...] = ()
    each: int = 24
    unseen: int = 640


class BreedingStage(NamedTuple):
    """What was done before the first layouts are shown: its name, lines to read, facts to keep."""

    name: str
    lines: tuple[str, ...]
    facts: Mapping[str, Any]


class MatrixBreeder(NamedTuple):
    """Layouts of a brief coded as matrices, a whole number a cell, line by line, for the genetic
    algorithms that a person rates: the ``breeder`` of such genomes; the visual quality τ of each
    kind of building (kind 0: nothing stands); size of a generation, chances of crossover and
    mutation, as the paper of the domain prints them.

    ``draw(count, led, rng)`` makes first layouts, ``led`` by quality or by chance; ``cross(one,
    other, points, rng)`` exchanges what lies between two points, or behind one, or a block;
    ``mutate(genome, rng, worth)`` mutates with the chance of the domain, by what alleles are
    ``worth`` (cells, kinds) if that is known; ``vary(genome, rng)`` makes a neighbour; ``read``
    gives the kind that is anchored at each cell. ``stages`` tells what led to the first layouts
    that are ``led``.
    """

    breeder: Breeder
    qualities: tuple[float, ...]
    population: int
    crossover: float
    draw: Callable[[int, bool, Any], list[Genome]]
    cross: Callable[[Genome, Genome, int, Any], tuple[Genome, Genome]]
    mutate: Callable[[Genome, Any, Any], Genome]
    vary: Callable[[Genome, Any], Genome]
    read: Callable[[Genome], tuple[int, ...]]
    stages: Callable[[], tuple[BreedingStage, ...]] = tuple
