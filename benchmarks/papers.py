"""All five papers at once: ``scenewright bench papers -o papers.json -o papers.md``.

Each part is a benchmark of its own, run with the same ``--quick``; ``--all`` adds every choice that
the papers leave open (:mod:`.papers_open`). Real blocks of villages are not among the quick parts.
A part that lacks its data or a package is left out, with a word.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from importlib import import_module
from typing import Any, NamedTuple

from benchmarks.page_tables import list_lines
from benchmarks.spread import Progress
from scenewright.core.errors import InputError
from scenewright.core.extras import install_line

Record = dict[str, Any]


class PaperPart(NamedTuple):
    """A paper, the benchmark that repeats its experiments, and whether it is ``--quick`` too."""

    paper: str
    bench: str
    is_quick: bool = True


OPEN = PaperPart("what the papers leave open", "papers_open")
PARTS = (
    PaperPart("Cao, Cheng, Zhang 2024", "papers_halls"),
    PaperPart("Cao, Cheng, Zhang 2024, at equal budgets", "papers_halls_equal"),
    PaperPart("Liu, Jiang, Mao, Wang 2017", "papers_home"),
    PaperPart("Zhang, Yang 2023", "papers_site"),
    PaperPart("Zhang, Yang 2023; Zhang, Fei 2017", "papers_raters"),
    PaperPart("Zhang, Fei 2017", "extend_paper"),
    OPEN,
    PaperPart("Zhu, Jiang, Li 2022", "village_hui"),
    PaperPart("Zhu, Jiang, Li 2022, on real blocks", "village", False),
)


def records(
    quick: bool = False, progress: Progress | None = None, everything: bool = False
) -> Iterator[Record]:
    """The records of one part after the other, each with its ``bench`` and ``paper``; a last record
    of each part says how many seconds it took."""
    parts = [part for part in PARTS if everything or part != OPEN]
    parts = [part for part in parts if part.is_quick or not quick]
    for number, part in enumerate(parts):
        begun = time.perf_counter()
        if progress:
            progress(number / len(parts), part.bench)
        try:
            for record in import_module(f"benchmarks.{part.bench}").records(quick):
                yield record | {"paper": part.paper, "bench": part.bench}
        except (InputError, ModuleNotFoundError) as fault:
            print(f"{part.bench} is left out: {tell_lack(fault)}")
            continue
        yield tell_seconds(part, time.perf_counter() - begun)


def tell_lack(fault: Exception) -> str:
    """What a part lacks: its fault, or the package to install."""
    module = getattr(fault, "name", None) if isinstance(fault, ModuleNotFoundError) else None
    return f"needs {module}; {install_line(module)}" if module else str(fault)


def tell_seconds(part: PaperPart, seconds: float) -> Record:
    """The record of how long a part took, which its tables leave out."""
    return {
        "case": part.bench,
        "metric": "measured within",
        "unit": "s",
        "ours": round(seconds, 1),
        "baseline": None,
        "baseline_name": "",
        "ratio": None,
        "runs": 1,
        "bench": "papers",
        "paper": part.paper,
    }


def markdown_lines(told: Sequence[Record]) -> Iterator[str]:
    """The tables of every part under its paper's name, and what each part took."""
    for part in PARTS:
        mine = [row for row in told if row["bench"] == part.bench]
        if mine:
            yield from (f"## {part.paper}: `bench {part.bench}`", "")
            yield from list_lines(part.bench, mine)
            yield ""
    yield from ("| measured | s |", "|---|---|")
    took = [row for row in told if row["bench"] == "papers"]
    yield from (f"| {row['case']} | {row['ours']:.0f} |" for row in took)
