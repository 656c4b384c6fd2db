"""How long 100 and 1,000 buildings take to grow from the terraces of the sample, how long folding
takes, and what it saves in rows of a city model."""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import Any

import numpy as np

import scenewright as sw
from benchmarks.real_data import data_set, skipped
from scenewright.core.errors import InputError
from scenewright.geometry.folding import cost_of, fold
from scenewright.ground.buildings.built import frames_of
from scenewright.ground.buildings.kinds import name_kinds
from scenewright.ground.buildings.rows import PASSAGE, find_rows, string_of
from scenewright.ground.reading import read_built

Record = dict[str, Any]
SIZES = {100: (200.0, 2.0), 1000: (1750.0, 20.0)}
"""Metres the area is long for so many buildings, and the seconds they may take."""


def speed_records(quick: bool) -> Iterator[Record]:
    """Processor seconds for each size, of one layout and of the default's four."""
    for count, (long, limit) in SIZES.items():
        if quick and count > 100:
            continue
        brief = sw.read("sample:extend-terrace")
        outline = [(127.0, -26.0), (127.0 + long, -26.0), (127.0 + long, 85.0), (127.0, 85.0)]
        area = brief.part.areas[0].model_copy(update={"outline": outline, "count": count})
        brief = brief.model_copy(update={"part": brief.part.model_copy(update={"areas": [area]})})
        for preset in ("quick", "default"):
            begun = time.process_time()
            solution = sw.solve(brief, preset=preset)
            took = time.process_time() - begun
            made = sum(p.space == "east" for p in solution.pieces)
            yield {
                "case": f"speed, {made} of {count} buildings, preset {preset}",
                "metric": "CPU seconds",
                "unit": "s",
                "ours": round(took, 3),
                "baseline": limit,
                "baseline_name": "the limit",
                "ratio": round(took / limit, 3),
                "runs": 1,
            }


SHUFFLES, LONGEST = 40, 160


def folding_records() -> Iterator[Record]:
    """Seconds to fold 160 symbols; cost by symbol of the rows of Delft against shuffled ones."""
    rng = np.random.default_rng(0)
    symbols = [chr(65 + k) for k in rng.integers(0, 3, LONGEST)]
    begun = time.process_time()
    fold(symbols)
    took = time.process_time() - begun
    yield _record("folding 160 symbols of 3 kinds", "CPU seconds", "s", took, 1.0, "the limit", 1)
    try:
        rows = _real_rows()
    except InputError as fault:
        yield skipped("folding", fault)
        return
    count = sum(map(len, rows))
    real = sum(cost_of(fold(row)) for row in rows) / count
    mixed: list[float] = []
    for _ in range(SHUFFLES):
        mixed.append(sum(cost_of(fold(rng.permutation(row).tolist())) for row in rows))
    other = float(np.mean(mixed)) / count
    case = f"folding, {len(rows)} rows of Delft, {count} buildings"
    yield _record(case, "cost a building", "1", real, other, "rows shuffled", SHUFFLES)


def _real_rows() -> list[list[str]]:
    scene = read_built(data_set("citymodels_cityjson") / "delft.json")
    frames = frames_of(scene.buildings)
    letters = name_kinds(scene.buildings, frames)
    strings = [string_of(row, letters) for row in find_rows(frames)]
    return [[s for s in row if s != PASSAGE] for row in strings]


def _record(
    case: str, metric: str, unit: str, ours: float, base: float, by: str, runs: int
) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": round(ours, 4),
        "baseline": round(base, 4),
        "baseline_name": by,
        "ratio": round(ours / base, 3),
        "runs": runs,
    }
