"""Real malls and stations of ``indoor_osm``: every unit of at least 30 m² filled and judged.

A unit is valid if the referee finds nothing in it.
"""

from __future__ import annotations

import time
from collections import Counter
from typing import Any

from benchmarks.comparison import ratio
from benchmarks.real_data import data_files, data_set, skipped
from scenewright.building.plan import room_ids
from scenewright.core.errors import InputError
from scenewright.core.report import Report
from scenewright.core.solution import Solution
from scenewright.domains import check
from scenewright.domains.hall.indoor.geojson import read_report
from scenewright.domains.hall.solving import solve

Row = dict[str, Any]


def names() -> list[str]:
    """The maps there are, by name."""
    return [path.stem for path in data_files("indoor_osm", "*.geojson")]


def rows(name: str, seed: int = 0) -> tuple[list[Row], Row]:
    """Every unit of a map that is to be filled, and the figures of the whole map."""
    told = read_report(data_set(f"indoor_osm/{name}.geojson"))
    solution = solve(told.brief, seed=seed)
    begun = time.perf_counter()
    report = check(solution)
    judged = time.perf_counter() - begun
    ids = [
        space
        for space, room in zip(room_ids(told.brief), told.brief.rooms, strict=True)
        if room.demands
    ]
    units = [unit(space, solution, report) for space in ids]
    whole = {
        "map": name,
        "rooms": len(told.brief.rooms),
        "units": told.units,
        "filled": told.filled,
        "solving": solution.seconds,
        "judging": judged,
    }
    return units, whole


def unit(space: str, solution: Solution, report: Report) -> Row:
    """What became of one unit: pieces, findings by kind, what was left out and why."""
    found = [f for f in report.findings if f.space == space and not f.given]
    left = [out for out in solution.left_out if out.space == space]
    return {
        "space": space,
        "pieces": sum(piece.space == space for piece in solution.pieces),
        "area": report.figures["rooms"].get(space, {}).get("area"),
        "findings": dict(Counter(finding.kind for finding in found)),
        "told": [finding.message for finding in found][:3],
        "left_out": [f"{out.what}: {out.reason}" for out in left],
    }


def records(seed: int = 0, maps: list[str] | None = None) -> list[Row]:
    """Records of every map: valid units, findings by kind, units that lack something, seconds;
    a word without the data."""
    found: list[Row] = []
    try:
        maps = maps or names()
    except InputError as fault:
        return [skipped("malls", fault)]
    for name in maps:
        units, whole = rows(name, seed)
        number = len(units)
        kinds = Counter(kind for one in units for kind in one["findings"])
        found += [
            _record(name, "valid units", number - sum(bool(u["findings"]) for u in units), number),
            _record(
                name,
                "units with nothing left out",
                number - sum(bool(u["left_out"]) for u in units),
                number,
            ),
            _record(name, "units with pieces", sum(u["pieces"] > 0 for u in units), number),
            *(
                _record(name, f"units with {kind.replace('_', ' ')}", n, number, 0.0)
                for kind, n in sorted(kinds.items())
            ),
            _seconds(name, "solving", whole["solving"]),
            _seconds(name, "judging", whole["judging"]),
        ]
    return found


def _record(case: str, metric: str, ours: int, of: int, aim: float | None = None) -> Row:
    base = float(of) if aim is None else aim
    return {
        "case": case,
        "metric": metric,
        "unit": "1",
        "ours": float(ours),
        "baseline": base,
        "baseline_name": "aim",
        "ratio": ratio(ours, base, "1"),
        "runs": of,
    }


def _seconds(case: str, metric: str, seconds: float) -> Row:
    return {
        "case": case,
        "metric": metric,
        "unit": "s",
        "ours": seconds,
        "baseline": None,
        "baseline_name": "",
        "ratio": None,
        "runs": 1,
    }
