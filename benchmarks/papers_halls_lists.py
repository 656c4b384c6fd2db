"""One outline with several requirement lists (Cao, Cheng and Zhang 2024, Fig. 5), and one list laid
out several times.

The outline is that of the irregular sample, with its columns, doors and wishes for zones; the lists
are its own and those of ``scenes/lists.json``. :mod:`.draw_hall_lists` draws them.
"""

from __future__ import annotations

import json
import time
from functools import partial
from typing import Any

from benchmarks.hall_methods import count_pieces, judged
from benchmarks.papers_halls_measures import make_record
from benchmarks.papers_halls_scenes import FOLDER
from benchmarks.spread import SpreadTable
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains.hall.solving import solve
from scenewright.formats import read

Row = dict[str, Any]
OUTLINE, OWN = "sample:hall-irregular", "museum"
"""The sample, and what its own list is called."""


def lists() -> dict[str, list[Row]]:
    """What each list asks for, after the sample's own."""
    document = read(OUTLINE).model_dump()
    others = json.loads((FOLDER / "lists.json").read_text(encoding="utf-8"))
    return {OWN: document["rooms"][0]["demands"]} | others


def listed(name: str) -> Brief:
    """The outline of the sample with one of the lists."""
    document = read(OUTLINE).model_dump()
    document["name"], document["rooms"][0]["demands"] = name.capitalize(), lists()[name]
    return Brief.model_validate(document)


def lay_out(name: str, seed: int) -> Solution:
    """One list laid out by our default."""
    return solve(listed(name), seed=seed, threads=1)


def run(name: str, seed: int) -> Row:
    """One list laid out and judged."""
    begun = time.process_time()
    solution = lay_out(name, seed)
    seconds, walls = time.process_time() - begun, sum(_is_wall(p) for p in solution.pieces)
    size = {"objects": count_pieces(solution) - walls, "walls": walls}
    return judged(solution) | size | {"seconds": seconds}


def _is_wall(piece: Any) -> bool:
    return bool(piece.category == "partition")


def requirement_list(name: str, seeds: int) -> SpreadTable:
    """The share of valid runs of one list, its objects, the walls built and the seconds."""
    jobs = [partial(run, name, seed) for seed in range(seeds)]
    return SpreadTable(f"requirement list, {name}", jobs, partial(_records, name))


def _records(name: str, rows: list[Row]) -> list[Row]:
    told = []
    for figure, unit in (("valid", "share"), ("objects", "1"), ("walls", "1"), ("seconds", "s")):
        mean = float(sum(row[figure] for row in rows)) / len(rows)
        record = make_record(f"requirement list, {name}", figure, unit, mean, mean)
        told.append(record | {"baseline_name": "same", "runs": len(rows)})
    return told
