"""The table of solvers of sites. A new one is one file and one row; the rows drive the tests."""

from __future__ import annotations

from scenewright.engine.rows import SolverRow, name_solvers

ROWS = (
    SolverRow(
        "fill",
        "blocks filled row by row, the form of each chosen (default)",
        "ours",
        f"{__name__}.fill:fill_site",
        "buildings",
    ),
    SolverRow(
        "vp",
        "the paper's genetic algorithm over a matrix of cells, led by visual "
        "quality, 10 layouts, at most 200 generations",
        "Zhang, Yang 2023",
        f"{__name__}.genetic:viewpoint_site",
        "buildings",
        traced=True,
    ),
    SolverRow(
        "sga",
        "simple genetic algorithm over the same matrix",
        "Goldberg 1989",
        f"{__name__}.genetic:simple_site",
        "buildings",
        traced=True,
    ),
    SolverRow(
        "sa",
        "annealing of boxes with four headings",
        "Kirkpatrick et al. 1983",
        f"{__name__}.anneal:anneal_site",
        "buildings",
    ),
    SolverRow(
        "sa-free",
        "annealing of boxes at any angle",
        "ours",
        f"{__name__}.anneal:anneal_site_free",
        "buildings",
    ),
    SolverRow(
        "pso",
        "particle swarm over poses",
        "Kennedy, Eberhart 1995",
        f"{__name__}.swarm:swarm_site",
        "buildings",
    ),
    SolverRow(
        "random",
        "buildings dropped at random, the best layout kept",
        "baseline",
        f"{__name__}.random_search:random_site",
        "buildings",
    ),
)
SITE_SOLVERS: dict[str, SolverRow] = name_solvers("site", ROWS)
