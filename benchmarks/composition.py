"""Faults of composition over real flats: ``scenewright bench composition``.

Every fourth flat of ``floorplans_r2v`` (every fiftieth if quick) is furnished and its faults are
counted by simple geometry; after them come the rows of homes, by the rooms that break each (no
row was counted before). Beside them stands what an improvement could have been paid with: flats
that are valid, kitchens that are whole, beds, sofas, seats, tables, metres of worktop and storage.
The baseline is what was counted before any of it was worked on (:data:`BEFORE`, seed 0). With
``--full`` as many flats that nobody looked at while it was worked on are counted instead
(:data:`BEFORE_ASIDE`). With ``--rescaled`` flats drawn too small are enlarged first
(:mod:`benchmarks.rescaled_r2v`); the first version was given the same (:data:`BEFORE_RESCALED`).
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Iterator, Mapping
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import shapely

from benchmarks import stages
from benchmarks.composition_before import (
    BEFORE,
    BEFORE_ASIDE,
    BEFORE_ASIDE_RESCALED,
    BEFORE_RESCALED,
)
from benchmarks.composition_faults import (
    FAULTS,
    SOFAS,
    TABLES,
    Count,
    Home,
    count_seats,
    list_rooms,
)
from benchmarks.composition_kitchen import is_under
from benchmarks.composition_rows import count_rows
from benchmarks.plans_r2v import PLANS, adapt, raw_plans
from benchmarks.real_data import data_set
from benchmarks.rescaled_r2v import rescale
from benchmarks.spread import spread

Record = dict[str, Any]
USUAL, QUICK = 4, 50
ASIDE = 2
"""The first of the flats that are kept aside; between them lie as many as between the others."""
STORAGE = ("wardrobe", "chest_of_drawers", "bookcase", "sideboard", "shelf_unit", "storage_shelf")
WORKTOP = ("base_cabinet", "drawer_cabinet", "corner_cabinet", "dishwasher", "filler_panel")


REFERENCE = 400
"""Rounds of the reference work."""
PACE = "flats a reference work"
BASELINES = {
    (False, False): BEFORE,
    (True, False): BEFORE_ASIDE,
    (False, True): BEFORE_RESCALED,
    (True, True): BEFORE_ASIDE_RESCALED,
}
"""What was counted before, by whether of flats kept aside and whether of rescaled ones."""


class Seen(NamedTuple):
    """One furnished flat: its faults (how many, of how many), what it holds, and the processor's
    seconds it took, and those of the reference work (:func:`time_reference`) just before."""

    faults: dict[str, Count]
    held: dict[str, float]
    seconds: float
    reference: float


def records(
    quick: bool = False,
    progress: stages.Progress | None = None,
    full: bool = False,
    rescaled: bool = False,
) -> Iterator[Record]:
    """A record a fault and a record for each thing held; of an interrupted run those of the flats
    that are done. ``full``: of the flats kept aside; ``rescaled``: of flats at their true scale."""
    data_set(PLANS)
    first, step = ASIDE if full else 0, QUICK if quick else USUAL
    flats = furnish_flats(step, progress, first, rescaled)
    yield from stages.tally(flats, partial(tally_flats, before=BASELINES[full, rescaled]))


def furnish_flats(
    step: int, progress: stages.Progress | None = None, first: int = 0, rescaled: bool = False
) -> Iterator[Seen]:
    """Every ``step``-th flat from the ``first`` on, furnished with seed 0."""
    numbers = range(first, len(raw_plans()), step)
    jobs = [partial(furnish_flat, n, rescaled) for n in numbers]
    for done, seen in enumerate(spread(jobs)):
        if progress:
            progress((done + 1) / len(numbers), f"{done + 1} of {len(numbers)} flats")
        if seen is not None:
            yield seen


def furnish_flat(number: int, rescaled: bool = False) -> Seen | None:
    """Furnish one flat and count; None where no brief could be made of the plan."""
    from scenewright.building import plan
    from scenewright.domains import check
    from scenewright.domains.home.solving import solve

    raw = raw_plans()[number]
    brief = adapt(rescale(raw) if rescaled else raw).brief
    if brief is None:
        return None
    reference, begun = time_reference(), time.process_time()
    solution = solve(brief, seed=0, threads=1)
    seconds = time.process_time() - begun
    spaces = plan.spaces(brief)
    report = check(solution, spaces=spaces)
    home = list_rooms(spaces, solution.pieces)
    faults = {name: count(home) for name, count in FAULTS.items()}
    faults |= count_rows(spaces, solution.pieces)
    return Seen(
        faults, hold(home) | {"valid flats": float(not report.findings)}, seconds, reference
    )


def time_reference() -> float:
    """The processor's seconds that a fixed piece of work takes, of the kinds furnishing is made of:
    arithmetic of Python, small arrays, polygons.

    Paces in flats a reference do not depend on the machine, nor much on what else runs on it: that
    of an earlier version is kept with the other figures of before.
    """
    begun, corners = time.process_time(), np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]])
    room, total = shapely.Polygon(corners), 0.0
    for k in range(REFERENCE):
        turned = corners @ np.array([[np.cos(k), -np.sin(k)], [np.sin(k), np.cos(k)]])
        total += float(np.hypot(turned[:, 0], turned[:, 1]).max())
        rows = sorted(((i * k) % 17, str(i)) for i in range(24))
        total += sum(float(number) for number, _ in rows)
        if k % 4 == 0:
            total += room.difference(shapely.Polygon(turned)).buffer(-0.3).area
    return time.process_time() - begun


def hold(home: Home) -> dict[str, float]:
    """What a home holds that it should not lose."""
    pieces = [piece for room in home for piece in room.pieces]
    each = Counter(piece.category for piece in pieces)
    kitchens = ("hob_cabinet", "sink_cabinet", "fridge")
    kinds = ("fridge", "washing_machine")
    under = [p for room in home for p in room.find(*kinds) if is_under(p, list(room.pieces))]
    return {
        "kitchens with hob, sink and fridge": sum(all(map(room.find, kitchens)) for room in home),
        "double beds": each["double_bed"],
        "single beds": each["single_bed"],
        "sofas": sum(each[name] for name in SOFAS),
        "seats": sum(map(count_seats, home)),
        "tables to eat at": sum(each[name] for name in TABLES),
        "metres of worktop": _metres(pieces, WORKTOP) + _metres(under, kinds),
        "metres of storage": _metres(pieces, STORAGE),
        "pieces": len(pieces),
    }


def _metres(pieces: list[Any], categories: tuple[str, ...]) -> float:
    return sum(p.size.width for p in pieces if p.category in categories)


def tally_flats(flats: list[Seen], before: Mapping[str, float] = BEFORE) -> list[Record]:
    """Shares of those that have each fault, then what a flat holds on the average, beside what was
    counted ``before``."""
    found = []
    for name in dict.fromkeys(name for flat in flats for name in flat.faults):
        counts = [flat.faults[name] for flat in flats if name in flat.faults]
        faulty, of = (sum(each) for each in zip(*counts, strict=True))
        found.append(_record(name, "share", faulty / max(of, 1), of, before))
    for name in flats[0].held:
        mean = sum(flat.held[name] for flat in flats) / len(flats)
        found.append(_record(name, "a flat", mean, len(flats), before))
    seconds, reference = (sum(f) for f in zip(*((f[2], f[3]) for f in flats), strict=True))
    speeds = {"flats a minute and core": 60 * len(flats) / seconds, PACE: reference / seconds}
    speed = [_record(name, "speed", v, len(flats), before) for name, v in speeds.items()]
    return [*found, *speed]


def _record(
    case: str, metric: str, ours: float, runs: int, baseline: Mapping[str, float]
) -> Record:
    before = baseline.get(case, 0.0)
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
