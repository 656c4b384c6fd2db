"""The table of solvers of halls. A new one is one file and one row here; the rows drive the tests.

A solver takes a problem with a first layout in which every unit has a place
(:class:`.outcome.StartedHall`) and answers with layouts, best first.
"""

from __future__ import annotations

from scenewright.engine.rows import SolverRow, name_solvers

_PATTERNS = ("patterns", f"{__name__}.outcome:by_patterns")
_OBJECTS = ("objects", f"{__name__}.outcome:by_objects")

ROWS = (
    SolverRow(
        "anneal",
        "four chains over patterns, annealed, the better half cooled again (default)",
        "ours",
        f"{__name__}.chains:anneal_hall",
        *_PATTERNS,
    ),
    SolverRow(
        "gd-mh",
        "the paper's graph-driven Metropolis-Hastings, 1000 iterations",
        "Cao, Cheng, Zhang 2024",
        f"{__name__}.chains:gd_mh",
        *_PATTERNS,
        traced=True,
    ),
    SolverRow(
        "merrell",
        "object by object annealing by interior design guidelines, T from 1000 by 0.99",
        "Merrell et al. 2011",
        f"{__name__}.merrell:merrell",
        *_OBJECTS,
    ),
    SolverRow(
        "miqp",
        "blocks for groups, cells for objects, by CP-SAT (extra solve)",
        "Wu, Fan, Liu, Wonka 2018",
        f"{__name__}.miqp:miqp",
        *_OBJECTS,
    ),
    SolverRow(
        "ga",
        "genetic algorithm over the parameters of patterns",
        "baseline",
        f"{__name__}.genetic:genetic_hall",
        *_PATTERNS,
    ),
    SolverRow(
        "random",
        "patterns drawn at random, the best layout kept",
        "baseline",
        f"{__name__}.random_search:random_hall",
        *_PATTERNS,
    ),
)
HALL_SOLVERS: dict[str, SolverRow] = name_solvers("hall", ROWS)
