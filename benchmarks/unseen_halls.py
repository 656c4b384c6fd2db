"""Halls nobody has looked at: ``scenewright bench unseen --halls --seed S --count N``.

Halls are drawn by a seed (:mod:`benchmarks.unseen_halls_briefs`), laid out as by default, and
counted by counters that are no rows (:mod:`benchmarks.unseen_halls_counters`), each at its
threshold (the column *ours*) and 0.1 m beyond it (*baseline*); then come figures without
thresholds, the share that is valid, what was left out and the processor's seconds.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks import stages
from benchmarks.composition_faults import Count, list_rooms
from benchmarks.spread import spread
from benchmarks.unseen_halls_briefs import Drawn, draw_halls
from benchmarks.unseen_halls_counters import COUNTERS, Hall, count_all, measure_all
from benchmarks.unseen_records import BEYOND, Record, add_up, make_record

COUNT, QUICK = 40, 8


class SeenHall(NamedTuple):
    """One hall laid out: its name, its counters at the threshold and beyond, its figures, findings
    by the referee, required things left out, the processor's seconds."""

    name: str
    at: dict[str, Count]
    beyond: dict[str, Count]
    figures: dict[str, float]
    findings: int
    left_out: int
    seconds: float


def hall_records(
    quick: bool, progress: stages.Progress | None, seed: int, count: int, sheets: Path | None
) -> Iterator[Record]:
    """Records of ``count`` halls (40, 8 if ``quick``) drawn by ``seed``; of an interrupted run of
    the halls that are done."""
    number = count or (QUICK if quick else COUNT)
    yield from stages.tally(see_halls(seed, number, progress, sheets), tally_halls)


def see_halls(
    seed: int, count: int, progress: stages.Progress | None = None, sheets: Path | None = None
) -> Iterator[SeenHall]:
    """The halls drawn, laid out and counted; the sheets at the end."""
    pictures = []
    drawn = draw_halls(seed, count)
    jobs = [partial(see_hall, one, sheets is not None) for one in drawn]
    for done, (seen, picture) in enumerate(spread(jobs)):
        if progress:
            progress((done + 1) / count, f"{done + 1} of {count} halls")
        pictures.append((seen.name, picture))
        yield seen
    if sheets is not None:
        import_module("benchmarks.unseen_sheets").write_sheets(sheets, pictures)


def see_hall(drawn: Drawn, pictured: bool = False) -> tuple[SeenHall, Any]:
    """Lay out one hall with seed 0 and count, with its picture if ``pictured``."""
    from scenewright.building import plan
    from scenewright.domains import check
    from scenewright.domains.hall.solving import solve

    begun = time.process_time()
    solution = solve(drawn.brief, seed=0, threads=1)
    seconds = time.process_time() - begun
    [room] = list_rooms(plan.spaces(drawn.brief), solution.pieces)
    demands = drawn.brief.rooms[0].demands
    left_open = drawn.theme == "mall shop" or any(leaves_open(d) for d in demands)
    hall = Hall(drawn.theme, left_open, room)
    counts = count_all(hall), count_all(hall, BEYOND)
    findings = sum(not finding.given for finding in check(solution).findings)
    left = sum(out.required for out in solution.left_out)
    seen = SeenHall(drawn.name, *counts, measure_all(hall), findings, left, seconds)
    picture = import_module("benchmarks.unseen_sheets").draw_home(solution) if pictured else None
    return seen, picture


def leaves_open(demand: Any) -> bool:
    """Whether a demand does not say how many."""
    return demand.count is None and demand.length is None and not demand.sizes


def tally_halls(halls: list[SeenHall]) -> list[Record]:
    """Counters first, then figures, then the guard."""
    found = []
    for row in COUNTERS:
        at = add_up([hall.at[row.name] for hall in halls])
        beyond = add_up([hall.beyond[row.name] for hall in halls])
        share = beyond.faulty / max(beyond.of, 1)
        found.append(make_record(row.name, f"of {row.of}", at.faulty / max(at.of, 1), at.of, share))
    for name in dict.fromkeys(name for hall in halls for name in hall.figures):
        values = [hall.figures[name] for hall in halls if name in hall.figures]
        found.append(make_record(name, "mean", sum(values) / len(values), len(values)))
    guard = (
        ("valid", "share", sum(not hall.findings for hall in halls)),
        ("required things left out", "a hall", sum(hall.left_out for hall in halls)),
        ("processor seconds", "a hall", sum(hall.seconds for hall in halls)),
    )
    return found + [make_record(n, m, v / len(halls), len(halls)) for n, m, v in guard]
