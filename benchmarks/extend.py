"""Extensions against real places: does the measure know a place, and is what grew still it?

*Telling*: the excess between halves of one compound against halves of two; the area under the
curve (AUC) is how often the first is less. *Growing*: one half of every compound of 16 buildings
and more is hidden and grown from the other, its coverage told; ours beside the paper's, copies of
the source side by side, buildings at random, and the half that is really there. *Folding*: what
rows of a city model save against the same rows shuffled. *Speed*: 100 and 1,000 buildings.
Compounds held out are judged apart; nothing that is below the real half is called better.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from benchmarks.extend_data import cut_compounds, village_halves
from benchmarks.extend_growth import growth_records
from benchmarks.extend_speed import folding_records, speed_records
from benchmarks.real_data import skipped
from scenewright.core.errors import InputError
from scenewright.ground.buildings.built import BuiltScene
from scenewright.ground.likeness.excess import Excess, find_excess
from scenewright.ground.likeness.features import join_measures, measure_scene

Record = dict[str, Any]
Progress = Callable[[float, str], None]
OTHERS = 8
"""Other places each half is compared with."""


def records(quick: bool, progress: Progress | None = None, full: bool = False) -> Iterator[Record]:
    """Records of telling, growing and speed; ``full`` grows with three seeds."""
    heard = progress or (lambda _share, _words: None)
    try:
        yield from telling_records()
        heard(0.1, "telling places apart")
        yield from growth_records(4 if quick else None, 3 if full else 1, heard)
    except InputError as fault:
        yield skipped("real places", fault)
    yield from folding_records()
    yield from speed_records(quick)


def telling_records() -> Iterator[Record]:
    """How well the measure knows compounds and villages."""
    places = cut_compounds()
    measured = [(measure_scene(p.one), measure_scene(p.other)) for p in places]
    for name, chosen in (
        ("compounds held out", [k for k, p in enumerate(places) if p.held]),
        ("all compounds", list(range(len(places)))),
        (
            "compounds held out, halves of 17 and more",
            [k for k, p in enumerate(places) if p.held and len(p.one.buildings) >= 17],
        ),
    ):
        same, other = _pairs([measured[k] for k in chosen])
        yield from _told(name, same, other)
    villages = [(_joined(one), _joined(two)) for _, one, two in village_halves()]
    same, other = _pairs(villages)
    yield from _told("villages", same, other)


def _joined(scenes: list[BuiltScene]) -> dict[str, np.ndarray]:
    """The features of several blocks, each measured by itself."""
    return join_measures([measure_scene(scene) for scene in scenes])


def _pairs(
    halves: list[tuple[dict[str, np.ndarray], dict[str, np.ndarray]]],
) -> tuple[list[Excess], list[Excess]]:
    """The excess of halves of one place, and of halves of two."""
    rng = np.random.default_rng(0)
    same = [find_excess(a, b) for a, b in halves]
    other = []
    for i in range(len(halves)):
        rest = np.delete(np.arange(len(halves)), i)
        for j in rng.choice(rest, min(OTHERS, len(rest)), replace=False).tolist():
            other.append(find_excess(halves[i][0], halves[j][1]))
    return same, other


def _told(name: str, same: list[Excess], other: list[Excess]) -> Iterator[Record]:
    for side in ("what", "how", "whole"):
        a, b = (np.array([getattr(e, side) for e in rows]) for rows in (same, other))
        area = (a[:, None] < b[None]).mean() + 0.5 * (a[:, None] == b[None]).mean()
        yield _record(f"telling, {name}", f"AUC of {side}", "1", float(area), 0.5, "chance", len(a))
        if side == "whole":
            marks = (float(np.percentile(a, 75)), float(np.median(b)))
            case = f"telling, {name}"
            metric = "excess, 75 % point of one place"
            yield _record(case, metric, "1", marks[0], marks[1], "two places, median", len(a))


def _record(
    case: str, metric: str, unit: str, ours: float, base: float | None, by: str, runs: int
) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": round(ours, 4),
        "baseline": None if base is None else round(base, 4),
        "baseline_name": by,
        "ratio": None if not base else round(ours / base, 3),
        "runs": runs,
    }
