"""The table of solvers of extensions. A new one is one file and one row."""

from __future__ import annotations

from scenewright.engine.rows import SolverRow, name_solvers

ROWS = (
    SolverRow(
        "grow",
        "rows, neighbours and whole patches of the sources continued; coverage repaired (default)",
        "ours",
        f"{__name__}.growing:grow_area",
        "buildings",
    ),
    SolverRow(
        "grammar",
        "the sources' grammar unfolded: arrays run on sideways, the layout is repeated across",
        "ours, after Zhang and Fei 2017",
        f"{__name__}.unfolding:unfold_area",
        "buildings",
    ),
    SolverRow(
        "colony",
        "ants and a genetic algorithm over a grid of plots, as printed",
        "Zhang and Fei 2017",
        f"{__name__}.paper:grow_printed",
        "matrix of plots",
        traced=True,
    ),
    SolverRow(
        "colony-repaired",
        "the same with an elite deposit, steady evaporation and allele values of carriers",
        "Zhang and Fei 2017, repaired",
        f"{__name__}.paper:grow_repaired",
        "matrix of plots",
        traced=True,
    ),
    SolverRow(
        "tiling",
        "copies of the whole source side by side, what does not fit left away (comparison)",
        "ours",
        f"{__name__}.baselines:tile_area",
        "copies of the source",
    ),
    SolverRow(
        "random",
        "buildings of the sources anywhere they do not overlap, turned as theirs (comparison)",
        "ours",
        f"{__name__}.baselines:scatter_area",
        "buildings",
    ),
    SolverRow(
        "scatter",
        "the same at the sources' least distances (comparison)",
        "ours",
        f"{__name__}.baselines:space_area",
        "buildings",
    ),
)
EXTEND_SOLVERS: dict[str, SolverRow] = name_solvers("extend", ROWS)
