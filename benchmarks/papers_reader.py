"""A reader's test: ``bench papers_reader``, or ``python -m benchmarks.papers_reader 7``.

Dice choose five formulas and five steps a paper from the tables of ``docs/reproduction-*.md``. Each
is found by its row alone, computed in plain Python from the print (:mod:`.papers_reader_rooms`,
:mod:`.papers_reader_ground`), and by the function that the row names (copied into kernels: by the
energy that calls it) or by the fact of a trace.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from typing import Any

import numpy as np

from benchmarks import papers_reader_ground, papers_reader_rooms
from benchmarks.papers_reader_rows import CHECKS, PAGES, Dice, function_of, rows_of

DRAWN = 5
OF = (papers_reader_rooms, papers_reader_ground)
"""What fills the table of checks."""


def records(
    quick: bool = False,  # noqa: ARG001
    progress: Any = None,  # noqa: ARG001
    seed: int = 0,
) -> Iterator[dict[str, Any]]:
    """Every check drawn: by hand beside ours; ``quick`` draws as many."""
    dice = np.random.default_rng(seed)
    for page in PAGES:
        for kind in ("formula", "step"):
            known = sorted(row for one, sort, row in CHECKS if (one, sort) == (page, kind))
            chosen = dice.permutation(len(known))[:DRAWN].tolist()
            yield from (_record(page, kind, known[k], dice, seed) for k in chosen)


def _record(page: str, kind: str, row: str, dice: Dice, seed: int) -> dict[str, Any]:
    printed, path = next(one for one in rows_of(page) if one[0].startswith(row))
    hand, ours = CHECKS[page, kind, row](function_of(page, path), dice)
    return {
        "case": f"{page}, {kind}: {printed}",
        "metric": f"`{path}`",
        "unit": "1",
        "ours": ours,
        "baseline": hand,
        "baseline_name": "by hand",
        "ratio": None,
        "runs": 1,
        "seeds": f"{seed}",
        "agree": math.isclose(hand, ours, rel_tol=1e-6, abs_tol=1e-9),
    }


if __name__ == "__main__":
    for told_one in records(seed=int(sys.argv[1]) if len(sys.argv) > 1 else 0):
        mark = "agrees" if told_one["agree"] else "DIFFERS"
        print(f"{mark}: {told_one['case']}: {told_one['baseline']:.9g}, {told_one['ours']:.9g}")
