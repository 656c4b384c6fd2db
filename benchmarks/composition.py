"""Faults of composition over real flats: ``scenewright bench composition``.

Every fourth flat of ``floorplans_r2v`` (every fiftieth if quick) is furnished and its faults are
counted by simple geometry. Beside them stands what an improvement could have been paid with: flats
that are valid, kitchens that are whole, beds, sofas, seats, tables, metres of worktop and storage.
The baseline is what was counted before any of it was worked on (:data:`BEFORE`, seed 0).
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Iterator
from functools import partial
from typing import Any, NamedTuple

from benchmarks import stages
from benchmarks.composition_before import BEFORE
from benchmarks.composition_faults import (
    FAULTS,
    SOFAS,
    TABLES,
    Count,
    Home,
    count_seats,
    list_rooms,
)
from benchmarks.plans_r2v import PLANS, adapt, raw_plans
from benchmarks.real_data import data_set
from benchmarks.spread import spread

Record = dict[str, Any]
USUAL, QUICK = 4, 50
STORAGE = ("wardrobe", "chest_of_drawers", "bookcase", "sideboard", "shelf_unit", "storage_shelf")
WORKTOP = ("base_cabinet", "drawer_cabinet", "corner_cabinet", "dishwasher")


class Seen(NamedTuple):
    """One furnished flat: its faults (how many, of how many), what it holds, and the processor's
    seconds it took."""

    faults: dict[str, Count]
    held: dict[str, float]
    seconds: float


def records(quick: bool = False, progress: stages.Progress | None = None) -> Iterator[Record]:
    """A record a fault and a record for each thing held; of an interrupted run those of the flats
    that are done."""
    data_set(PLANS)
    yield from stages.tally(furnish_flats(QUICK if quick else USUAL, progress), tally_flats)


def furnish_flats(step: int, progress: stages.Progress | None = None) -> Iterator[Seen]:
    """Every ``step``-th flat, furnished with seed 0."""
    numbers = range(0, len(raw_plans()), step)
    for done, seen in enumerate(spread([partial(furnish_flat, n) for n in numbers])):
        if progress:
            progress((done + 1) / len(numbers), f"{done + 1} of {len(numbers)} flats")
        if seen is not None:
            yield seen


def furnish_flat(number: int) -> Seen | None:
    """Furnish one flat and count; None where no brief could be made of the plan."""
    from scenewright.building import plan
    from scenewright.domains import check
    from scenewright.domains.home.solving import solve

    brief = adapt(raw_plans()[number]).brief
    if brief is None:
        return None
    begun = time.process_time()
    solution = solve(brief, seed=0, threads=1)
    seconds = time.process_time() - begun
    spaces = plan.spaces(brief)
    report = check(solution, spaces=spaces)
    home = list_rooms(spaces, solution.pieces)
    faults = {name: count(home) for name, count in FAULTS.items()}
    return Seen(faults, hold(home) | {"valid flats": float(not report.findings)}, seconds)


def hold(home: Home) -> dict[str, float]:
    """What a home holds that it should not lose."""
    pieces = [piece for room in home for piece in room.pieces]
    each = Counter(piece.category for piece in pieces)
    kitchens = ("hob_cabinet", "sink_cabinet", "fridge")
    return {
        "kitchens with hob, sink and fridge": sum(all(map(room.find, kitchens)) for room in home),
        "double beds": each["double_bed"],
        "single beds": each["single_bed"],
        "sofas": sum(each[name] for name in SOFAS),
        "seats": sum(map(count_seats, home)),
        "tables to eat at": sum(each[name] for name in TABLES),
        "metres of worktop": _metres(pieces, WORKTOP),
        "metres of storage": _metres(pieces, STORAGE),
        "pieces": len(pieces),
    }


def _metres(pieces: list[Any], categories: tuple[str, ...]) -> float:
    return sum(p.size.width for p in pieces if p.category in categories)


def tally_flats(flats: list[Seen]) -> list[Record]:
    """Shares of those that have each fault, then what a flat holds on the average."""
    found = []
    for name in FAULTS:
        faulty, of = (sum(flat.faults[name][k] for flat in flats) for k in (0, 1))
        found.append(_record(name, "share", faulty / max(of, 1), of))
    for name in flats[0].held:
        mean = sum(flat.held[name] for flat in flats) / len(flats)
        found.append(_record(name, "a flat", mean, len(flats)))
    pace = 60 * len(flats) / sum(flat.seconds for flat in flats)
    return [*found, _record("flats a minute and core", "speed", pace, len(flats))]


def _record(case: str, metric: str, ours: float, runs: int) -> Record:
    before = BEFORE.get(case, 0.0)
    return {
        "case": case,
        "metric": metric,
        "unit": "1",
        "ours": round(ours, 4),
        "baseline": before,
        "baseline_name": "before",
        "ratio": round(ours / before, 4) if before else None,
        "runs": runs,
    }
