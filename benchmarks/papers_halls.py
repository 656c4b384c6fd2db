"""The tables of Cao, Cheng and Zhang (2024) on our halls: ``scenewright bench papers_halls``.

Their three measures (eqs. 7 to 9) of every sample, and of a home laid out as a hall, by every
method over 20 seeds, with the share of valid runs, the energy above its floor and the seconds, and
of layouts drawn by hand (:mod:`.papers_halls_measures`); tables 1 and 2 are made of these. Then
each energy left out in every sample (Fig. 6, :mod:`.hall_ablation`), one outline with several
requirement lists (Fig. 5, :mod:`.papers_halls_lists`), and the energies of eqs. 1 and 3 as printed
beside the repaired ones as a group is spread out (:mod:`.papers_halls_forms`).

Runs are spread over the cores. ``-o tables.json -o tables.md`` writes the records and the tables.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any

from benchmarks.hall_ablation import ablation
from benchmarks.hall_methods import halls
from benchmarks.papers_halls_forms import printed_forms
from benchmarks.papers_halls_lists import lists, requirement_list
from benchmarks.papers_halls_markdown import markdown_lines
from benchmarks.papers_halls_measures import LOOSE, measures, names
from benchmarks.papers_halls_scenes import HOME
from benchmarks.spread import Progress, SpreadTable, spread_tables

__all__ = ["markdown_lines", "records"]

Row = dict[str, Any]
SEEDS, QUICK_SEEDS = 20, 1
ABLATED = ("gd-mh", "anneal")
"""The solvers of the ablation: the paper's, and ours on the paper's energies."""
QUICK, QUICK_LISTS = ("sample:hall-irregular",), ("paintings",)


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Row]:
    """All records; ``quick`` takes one sample, one seed, three methods and one process."""
    among = ["default", "paper", "paper-repaired"] if quick else names()
    seeds = QUICK_SEEDS if quick else SEEDS
    cases = list(QUICK) if quick else halls()
    tables = [measures(case, seeds, among) for case in (*cases, HOME)]
    if not quick:
        tables.append(measures(LOOSE, seeds, [name for name in among if name != "merrell"]))
    tables += [ablation(case, solver, seeds) for case in cases for solver in ABLATED]
    tables += [requirement_list(name, seeds) for name in (QUICK_LISTS if quick else lists())]
    tables += [forms(case) for case in cases]
    yield from spread_tables(tables, progress, 1 if quick else None)


def forms(case: str) -> SpreadTable:
    """Eqs. 1 and 3 as printed and repaired."""
    job = partial(printed_forms, case)
    return SpreadTable(f"printed forms, {case}", [job], lambda found: found[0])
