"""Homes nobody has looked at: ``scenewright bench unseen --seed S --count N``.

A set of flats of ``floorplans_r2v`` at their true scale is drawn by a seed, furnished as by
default, and counted three ways: by counters that are no rows (:mod:`benchmarks.unseen_counters`,
:mod:`benchmarks.unseen_uses`), each at its threshold (the column *ours*) and 0.1 m beyond it
(*baseline*); by what is missing though a search of its own finds a place
(:mod:`benchmarks.unseen_places`); by what could have been paid for an improvement; and by what the
referee, the counters of composition and the rows of homes
say. ``--sheets FOLDER`` lays pictures out for an eye. A set that was looked at is no longer unseen:
take another seed.
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Iterator
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from benchmarks import stages
from benchmarks.composition import hold
from benchmarks.composition_faults import FAULTS, Count, list_rooms
from benchmarks.composition_rows import count_rows
from benchmarks.counters_r2v import name_kitchens
from benchmarks.plans_r2v import PLANS, adapt, raw_plans
from benchmarks.r2v import summarise
from benchmarks.real_data import data_set
from benchmarks.rescaled_r2v import rescale
from benchmarks.spread import spread
from benchmarks.unseen_counters import COUNTERS, count_all, count_sleepers
from benchmarks.unseen_places import count_missing
from benchmarks.unseen_records import BEYOND, Record, add_up, make_record
from benchmarks.unseen_uses import USES

COUNT, QUICK = 40, 8
ROWS = (*COUNTERS, *USES)


class Seen(NamedTuple):
    """One furnished flat: its id; its counters at the threshold and beyond; its other faults; what
    it holds; its usable rooms (function, area, what lacks, what of that is told); its faults by
    kind; the processor's seconds."""

    id: str
    at: dict[str, Count]
    beyond: dict[str, Count]
    faults: dict[str, Count]
    held: dict[str, float]
    rooms: list[list[Any]]
    findings: dict[str, int]
    seconds: float


def records(
    quick: bool = False,
    progress: stages.Progress | None = None,
    seed: int = 0,
    count: int = 0,
    sheets: Path | None = None,
    halls: bool = False,
) -> Iterator[Record]:
    """Records of ``count`` flats (40, 8 if ``quick``) drawn by ``seed``, or of ``halls``; of an
    interrupted run of those that are done."""
    if halls:
        module = import_module("benchmarks.unseen_halls")
        yield from module.hall_records(quick, progress, seed, count, sheets)
        return
    count = count or (QUICK if quick else COUNT)
    yield from stages.tally(see_flats(seed, count, progress, sheets), tally_flats)


def draw(seed: int, count: int, of: int) -> list[int]:
    """The numbers of ``count`` plans, no two the same.

    >>> draw(3, 4, 100) == draw(3, 4, 100), len(set(draw(3, 40, 100)))
    (True, 40)
    """
    return [int(n) for n in np.random.default_rng(seed).permutation(of)[:count]]


def see_flats(
    seed: int, count: int, progress: stages.Progress | None = None, sheets: Path | None = None
) -> Iterator[Seen]:
    """The flats drawn that a brief can be made of, furnished and counted; the sheets at the end."""
    data_set(PLANS)
    numbers = draw(seed, count, len(raw_plans()))
    pictures = []
    for done, got in enumerate(spread([partial(see_flat, n, sheets is not None) for n in numbers])):
        if progress:
            progress((done + 1) / len(numbers), f"{done + 1} of {len(numbers)} flats")
        if got is not None:
            pictures.append((got[0].id, got[1]))
            yield got[0]
    if sheets is not None:
        import_module("benchmarks.unseen_sheets").write_sheets(sheets, pictures)


def see_flat(number: int, pictured: bool = False) -> tuple[Seen, Any] | None:
    """Furnish one flat at its true scale with seed 0 and count, with its picture if ``pictured``;
    None where no brief can be made of the plan."""
    from scenewright.building import plan
    from scenewright.domains import check
    from scenewright.domains.home.solving import solve

    raw = name_kitchens(raw_plans()[number])
    brief = adapt(rescale(raw)).brief
    if brief is None:
        return None
    begun = time.process_time()
    solution = solve(brief, seed=0, threads=1)
    seconds = time.process_time() - begun
    spaces = plan.spaces(brief)
    summary = summarise(solution, check(solution, spaces=spaces), spaces)
    home = list_rooms(spaces, solution.pieces)
    faults = {name: fault(home) for name, fault in FAULTS.items()}
    faults |= count_rows(spaces, solution.pieces) | count_missing(home, solution.left_out)
    each = Counter(piece.category for piece in solution.pieces)
    held = hold(home) | {"sleepers": count_sleepers(home), "nightstands": each["nightstand"]}
    counts = count_all(home, 0.0, ROWS), count_all(home, BEYOND, ROWS)
    seen = Seen(raw["id"], *counts, faults, held, summary["rooms"], summary["faults"], seconds)
    picture = import_module("benchmarks.unseen_sheets").draw_home(solution) if pictured else None
    return seen, picture


def tally_flats(flats: list[Seen]) -> list[Record]:
    """Counters first, then the guard, then what rows say."""
    found = []
    for row in ROWS:
        at, beyond = (add_up([counts[row.name] for counts in both]) for both in _both(flats))
        share = beyond.faulty / max(beyond.of, 1)
        found.append(make_record(row.name, f"of {row.of}", at.faulty / max(at.of, 1), at.of, share))
    found += _guard(flats)
    for name in dict.fromkeys(name for flat in flats for name in flat.faults):
        total = add_up([flat.faults[name] for flat in flats if name in flat.faults])
        found.append(make_record(name, "share", total.faulty / max(total.of, 1), total.of))
    for kind in sorted({kind for flat in flats for kind in flat.findings}):
        number = sum(flat.findings.get(kind, 0) for flat in flats)
        found.append(make_record(f"finding: {kind}", "a flat", number / len(flats), len(flats)))
    return found


def _both(flats: list[Seen]) -> tuple[list[dict[str, Count]], list[dict[str, Count]]]:
    return [flat.at for flat in flats], [flat.beyond for flat in flats]


def _guard(flats: list[Seen]) -> list[Record]:
    """What must not be lost: valid flats, whole rooms, reasons told, what homes hold, the pace."""
    rooms = [room for flat in flats for room in flat.rooms]
    lacking = [room for room in rooms if room[2]]
    told = sum(len(room[3]) == len(room[2]) for room in lacking)
    whole = 1.0 - len(lacking) / max(len(rooms), 1)
    shares = (
        ("valid", sum(not flat.findings for flat in flats) / len(flats), len(flats)),
        ("rooms complete", whole, len(rooms)),
        ("others reported", told / len(lacking) if lacking else 1.0, len(lacking)),
    )
    found = [make_record(name, "share", value, of) for name, value, of in shares]
    for name in flats[0].held:
        mean = sum(flat.held[name] for flat in flats) / len(flats)
        found.append(make_record(name, "a flat", mean, len(flats)))
    seconds = sum(flat.seconds for flat in flats) / len(flats)
    return [*found, make_record("processor seconds", "a flat", seconds, len(flats))]


def markdown_lines(records: list[Record]) -> list[str]:
    """The counters at their thresholds and beyond, and after them the guard and the rows.

    >>> markdown_lines([make_record("valid", "share", 1.0, 40)])[-1]
    '| valid | share | 1.0 |  | 40 |'
    """
    head = [f"| what | share or mean | ours | {BEYOND} m beyond | runs |", "|---|---|---|---|---|"]
    rows = (
        (r["case"], r["metric"], r["ours"], "" if r["baseline"] is None else r["baseline"])
        for r in records
    )
    runs = (record["runs"] for record in records)
    return head + [
        f"| {' | '.join(map(str, (*row, n)))} |" for row, n in zip(rows, runs, strict=True)
    ]
