"""The table of solvers of villages. A new one is one file and one row."""

from __future__ import annotations

from scenewright.engine.rows import SolverRow, name_solvers

ROWS = (
    SolverRow(
        "grow",
        "house by house, largest first, where houses of the region would stand (default)",
        "ours",
        f"{__name__}.growing:grow_block",
        "houses",
    ),
    SolverRow(
        "tables",
        "the same weighed by tables of single relations instead of the net (comparison)",
        "ours",
        f"{__name__}.growing:fill_by_tables",
        "houses",
    ),
    SolverRow(
        "proposals",
        "the same without weights: any legal pose proposed (comparison)",
        "ours",
        f"{__name__}.growing:fill_unweighed",
        "houses",
    ),
    SolverRow(
        "paper",
        "networks that look at pixels say another? which? where? which way? (comparison)",
        "Zhu, Jiang and Li 2022",
        f"{__name__}.paper:fill_by_paper",
        "houses",
        traced=True,
    ),
)
VILLAGE_SOLVERS: dict[str, SolverRow] = name_solvers("village", ROWS)
