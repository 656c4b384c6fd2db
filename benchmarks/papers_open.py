"""Every choice that the five papers leave open, made otherwise: ``scenewright bench papers_open``.

A row of :data:`OPEN` is one choice: what was tried, first as we have it. Each value runs by the
same seeds on a small instance; a value is *told apart* from ours if the mean difference of the
pairs is not 0 at 95 % (Student). What is told apart for no value hardly matters here.
"""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

from benchmarks.comparison import ratio
from benchmarks.papers_open_measures import (
    anneal_site,
    breed_room,
    breed_site,
    fill_block,
    lay_hall,
    sort_blobs,
    try_network,
    walk_plots,
)
from benchmarks.spread import Progress, SpreadTable, spread_tables

Record = dict[str, Any]
RUNS, QUICK = 20, 5
T95 = {4: 2.776, 19: 2.093}
"""Student's quantiles by degrees of freedom."""


class Open(NamedTuple):
    """A choice left open: the scene, what it is, the figure that tells, and what was tried: words
    and the run by a seed, as we have it first."""

    scene: str
    choice: str
    figure: str
    tried: tuple[tuple[str, Callable[[int], float]], ...]


def _settings(
    measure: Callable[[dict[str, float], int], float], name: str, *values: float
) -> tuple[tuple[str, Callable[[int], float]], ...]:
    return tuple((f"{value:g}", partial(measure, {name: value})) for value in values)


def _values(
    measure: Callable[..., float], *values: float
) -> tuple[tuple[str, Callable[[int], float]], ...]:
    return tuple((f"{value:g}", partial(measure, value)) for value in values)


def _readings(**words: dict[str, Any]) -> tuple[tuple[str, Callable[[int], float]], ...]:
    return tuple((name.replace("_", " "), partial(breed_room, by)) for name, by in words.items())


HALL, HOME, SITE, PLOTS, HAMLET = "halls", "homes", "sites", "extensions", "villages"
ENERGY, COST, VALUE, BUILT, HOUSES = "energy", "cost C", "F_eva", "F", "houses"
OPEN = (
    Open(HALL, "δ_min, a share of the demand", ENERGY, _settings(lay_hall, "least", 0.75, 0.5, 1)),
    Open(HALL, "Z of eq. 5, m", ENERGY, _settings(lay_hall, "z", 1, 0.5, 2)),
    Open(HALL, "κ of 3.1", ENERGY, _settings(lay_hall, "kappa", 0.1, 0.05, 0.3)),
    Open(HALL, "λ, start to end", ENERGY, _settings(lay_hall, "rate", 0.1, 0.03, 0.3, 1, 10)),
    Open(
        HALL, "refusals before a pattern changes", ENERGY, _settings(lay_hall, "stuck", 20, 5, 100)
    ),
    Open(
        HALL, "chance that a move tries a wall", ENERGY, _settings(lay_hall, "walls", 0.05, 0, 0.25)
    ),
    Open(
        HALL, "chance to turn, not translate", ENERGY, _settings(lay_hall, "turned", 0.5, 0.2, 0.8)
    ),
    Open(HOME, "headings", COST, _readings(any={}, quarter_turns={"quarters": True})),
    Open(HOME, "σ = 0.3", COST, _readings(metres={}, of_the_range={"ranged": True})),
    Open(HOME, "a mutation changes", COST, _readings(one_gene={}, each_gene={"every": True})),
    Open(HOME, "C_max", COST, _readings(greatest={}, median={"limit": 0.5})),
    Open(HOME, "parents", COST, _readings(die={}, survive={"survive": True})),
    Open(HOME, "first layouts", COST, _readings(random={}, backs_at_walls={"start": "walls"})),
    Open(
        HOME,
        "distance of C5",
        COST,
        _readings(middle_of_back={}, back_edge={"back": "edge"}, patch={"back": "patch"}),
    ),
    Open(SITE, "δ of (12)", VALUE, _values(breed_site, 0.002, 0, 0.0005, 0.01)),
    Open(SITE, "E_max of (6), annealing", VALUE, _values(anneal_site, 10, 2, 50)),
    Open(
        SITE,
        "ART1, ρ",
        "σ (24)",
        tuple((f"{v:g}", partial(try_network, v, 1.0)) for v in (0.6, 0.3, 0.9)),
    ),
    Open(
        SITE,
        "ART1, β",
        "σ (24)",
        tuple((f"{v:g}", partial(try_network, 0.6, v)) for v in (1.0, 0.2, 0.5)),
    ),
    Open(PLOTS, "q₀ of (18)", BUILT, _settings(walk_plots, "choice", 0.5, 0.1, 0.9)),
    Open(PLOTS, "p₀ of (15)", BUILT, _settings(walk_plots, "far", 0.1, 0, 0.5)),
    Open(PLOTS, "a of (17), 0 to 1", BUILT, _settings(walk_plots, "a", 1, 0.3, 0.6)),
    Open(PLOTS, "b of (17), 1 to 2", BUILT, _settings(walk_plots, "b", 2, 1, 1.5)),
    Open(PLOTS, "ρ_min of (16)", BUILT, _settings(walk_plots, "least", 0.1, 0.01, 0.3)),
    Open(
        PLOTS,
        "form of ART",
        "AMI",
        tuple(
            (form, partial(sort_blobs, form, 0.75))
            for form in ("minima, complements", "minima", "products")
        ),
    ),
    Open(
        PLOTS,
        "vigilance of ART",
        "AMI",
        tuple((f"{v:g}", partial(sort_blobs, "minima, complements", v)) for v in (0.75, 0.6, 0.9)),
    ),
    Open(
        HAMLET,
        "odds from which *continue* says yes",
        HOUSES,
        tuple((f"{v:g}", partial(fill_block, "LIKELY", v)) for v in (0.5, 0.3, 0.7)),
    ),
    Open(
        HAMLET,
        "places tried for a house",
        HOUSES,
        tuple((f"{v:g}", partial(fill_block, "TRIES", v)) for v in (12, 3, 40)),
    ),
)
"""The grid."""


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """Each choice by each value, beside ours; ``quick`` takes five seeds and one process."""
    runs = QUICK if quick else RUNS
    tables = [
        SpreadTable(
            f"{row.scene}: {row.choice}",
            [partial(_run, tried, runs) for _, tried in row.tried],
            partial(_records, row, runs),
        )
        for row in OPEN
    ]
    yield from spread_tables(tables, progress, 1 if quick else None)


def _run(tried: Callable[[int], float], runs: int) -> list[float]:
    return [tried(seed) for seed in range(runs)]


def _records(row: Open, runs: int, found: list[list[float]]) -> Iterator[Record]:
    ours = statistics.fmean(found[0])
    for (words, _), values in zip(row.tried[1:], found[1:], strict=True):
        mean = statistics.fmean(values)
        yield {
            "case": f"{row.scene}: {row.choice}",
            "metric": f"{row.figure} by {words} for {row.tried[0][0]}",
            "unit": row.figure,
            "ours": round(ours, 4),
            "baseline": round(mean, 4),
            "baseline_name": words,
            "ratio": ratio(round(ours, 4), round(mean, 4), row.figure),
            "runs": runs,
            "seeds": f"0 to {runs - 1}",
            "as_run": row.tried[0][0],
            "apart": are_apart(found[0], values),
        }


def are_apart(one: Sequence[float], other: Sequence[float]) -> bool:
    """Whether pairs by the same seed differ in their mean at 95 %.

    >>> are_apart([1.0, 2.0, 3.0, 4.0, 5.0], [2.0, 3.1, 4.0, 5.1, 6.0])
    True
    >>> are_apart([1.0, 2.0, 3.0, 4.0, 5.0], [2.0, 1.0, 4.0, 3.0, 5.0])
    False
    """
    gaps = [b - a for a, b in zip(one, other, strict=True)]
    error = statistics.stdev(gaps) / math.sqrt(len(gaps))
    return abs(statistics.fmean(gaps)) > T95[len(gaps) - 1] * error


def page_lines(told: Sequence[Record]) -> Iterator[str]:
    """A row a choice: as we have it, and what else was tried, in bold what is told apart."""
    yield "| left open | figure | ours | tried | matters |"
    yield "|---|---|---|---|---|"
    for case in dict.fromkeys(row["case"] for row in told):
        mine = [row for row in told if row["case"] == case]
        tried = "; ".join(_cell(row) for row in mine)
        matters = "yes" if any(row["apart"] for row in mine) else "not told apart"
        ours = f"{mine[0]['as_run']}: {mine[0]['ours']:.4g}"
        yield f"| {case} | {mine[0]['unit']} | {ours} | {tried} | {matters} |"


def _cell(row: Record) -> str:
    mark = "**" if row["apart"] else ""
    return f"{row['baseline_name']}: {mark}{row['baseline']:.4g}{mark}"
