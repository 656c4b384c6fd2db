"""The table of solvers. A new one is one file and one row here; the rows drive the tests."""

from __future__ import annotations

from scenewright.engine.rows import SolverRow, name_solvers

_PATCHES = ("patches", f"{__name__}.no_items:solve_items")
_PIECES = ("pieces", f"{__name__}.no_items:solve_items")

ROWS = (
    SolverRow(
        "anneal",
        "compiled annealing, a designer's moves, adaptive restarts (default)",
        "ours, after Kirkpatrick et al. 1983",
        f"{__name__}.anneal:anneal",
        *_PATCHES,
    ),
    SolverRow(
        "paper-ga",
        "the paper's genetic algorithm, 40 layouts, 100 generations",
        "Liu et al. 2017",
        f"{__name__}.genetic:paper_ga",
        *_PATCHES,
        traced=True,
    ),
    SolverRow(
        "paper-sa",
        "the paper's comparison: annealing over patches, 500 iterations",
        "Liu et al. 2017",
        f"{__name__}.paper_annealing:paper_sa",
        *_PATCHES,
    ),
    SolverRow(
        "merrell",
        "single pieces annealed by interior design guidelines, T from 100 by 0.99",
        "Merrell et al. 2011",
        f"{__name__}.merrell:merrell",
        *_PIECES,
    ),
    SolverRow(
        "pso",
        "particle swarm over patches, 40 particles, 100 rounds",
        "Kennedy, Eberhart 1995",
        f"{__name__}.swarm:swarm",
        *_PATCHES,
    ),
    SolverRow(
        "greedy",
        "largest patch first, each at its best corner, wall or partner",
        "Feo, Resende 1995",
        f"{__name__}.greedy:greedy",
        *_PATCHES,
    ),
    SolverRow(
        "random",
        "layouts drawn at random, the best kept",
        "baseline",
        f"{__name__}.random_search:random_search",
        *_PATCHES,
    ),
)
SOLVERS: dict[str, SolverRow] = name_solvers("home", ROWS)
