"""How different homes look: ``scenewright bench styles``.

A hundred flats of ``floorplans_r2v`` (ten if quick) are furnished with their number as the seed and
no word about style, in few steps: which models they use is counted, not how well they stand. The
baseline is what 17 homes used when all furniture was of one style.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any, NamedTuple

from benchmarks import stages
from benchmarks.plans_r2v import PLANS, adapt, raw_plans
from benchmarks.real_data import data_set
from benchmarks.spread import spread
from scenewright.catalog.loading import catalog_of

Record = dict[str, Any]
HOMES, QUICK, STEPS = 100, 10, 300
BEFORE = {"different models": 57.0, "palettes": 1.0, "styles": 1.0}
MAIN = [
    "sofa",
    "armchair",
    "dining_chair",
    "dining_table",
    "coffee_table",
    "double_bed",
    "single_bed",
    "nightstand",
    "wardrobe",
    "chest_of_drawers",
    "tv_stand",
    "sink_cabinet",
    "floor_lamp",
    "table_lamp",
    "ceiling_lamp",
    "rug",
]
"""Kinds of which three models or more are expected."""


class Looked(NamedTuple):
    """What a home is furnished with: its models with their kinds, and its palette."""

    models: frozenset[tuple[str, str]]
    palette: str


def records(quick: bool = False, progress: stages.Progress | None = None) -> Iterator[Record]:
    """What all homes use; of an interrupted run what those use that are done."""
    data_set(PLANS)
    yield from stages.tally(furnish_homes(QUICK if quick else HOMES, progress), tally_homes)


def furnish_homes(count: int, progress: stages.Progress | None = None) -> Iterator[Looked]:
    """So many flats, spread over the data."""
    step = len(raw_plans()) // count
    numbers = [k * step for k in range(count)]
    for done, home in enumerate(spread([partial(furnish_home, n) for n in numbers])):
        if progress:
            progress((done + 1) / count, f"{done + 1} of {count} homes")
        if home is not None:
            yield home


def furnish_home(number: int) -> Looked | None:
    """One flat with its number as the seed; None where no brief could be made of the plan."""
    from scenewright.domains.home.furnishing.look import palette_of
    from scenewright.domains.home.solving import solve

    brief = adapt(raw_plans()[number]).brief
    if brief is None:
        return None
    solution = solve(brief, seed=number, steps=STEPS, threads=1)
    models = frozenset((p.category, p.asset) for p in solution.pieces)
    return Looked(models, palette_of(brief, number).id)


def tally_homes(homes: list[Looked]) -> list[Record]:
    """Models, palettes and styles, and the fewest models of a main kind, used and shipped."""
    models = frozenset().union(*(home.models for home in homes))
    used = [category for category, _ in models]
    shipped = [asset.category for asset in catalog_of([]).assets.values()]
    palettes = {home.palette for home in homes}
    figures = {
        "different models": len({asset for _, asset in models}),
        "palettes": len(palettes),
        "styles": len({palette.split("/")[0] for palette in palettes}),
        "models used of the main kind that has fewest": min(map(used.count, MAIN)),
        "models shipped of the main kind that has fewest": min(map(shipped.count, MAIN)),
    }
    return [_record(name, float(value), len(homes)) for name, value in figures.items()]


def _record(case: str, ours: float, runs: int) -> Record:
    before = BEFORE.get(case, 1.0)
    return {
        "case": case,
        "metric": "count",
        "unit": "1",
        "ours": ours,
        "baseline": before,
        "baseline_name": "before",
        "ratio": round(ours / before, 4),
        "runs": runs,
    }
