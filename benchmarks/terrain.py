"""Sites, a village and an extension on ground that is not flat.

Each is laid out as on flat ground, its ground is shaped, and the referee judges both: findings,
the steepest way for cars, the largest step at a door, the highest plinth, and cubic metres of
ground moved a square metre.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import shapely

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.domains import check, plan_of

Record = dict[str, Any]
Progress = Callable[[float, str], None]
HILL = {
    "domain": "site",
    "name": "Hillside at 20 %",
    "terrain": {"slope": 0.2, "towards": 180},
    "sites": [
        {
            "outline": [[0, 0], [230, 0], [240, 125], [-8, 120]],
            "roads": [
                {"line": [[-10, 32], [110, 30], [245, 34]], "width": 7},
                {"line": [[-15, 92], [110, 94], [245, 90]], "width": 6},
                {"line": [[12, 32], [120, 62], [228, 90]], "width": 6},
            ],
            "buildings": [{"model": "villa", "count": 14}, {"model": "row_houses", "count": 4}],
            "spacing": 6,
        }
    ],
}
BROOK = [[-40, 20], [100, 32], [180, 22], [300, 30], [300, 42], [180, 36], [100, 46], [-40, 34]]


def records(quick: bool, progress: Progress | None = None) -> Iterator[Record]:
    """Records of each scene; ``quick`` leaves out the village and the extension."""
    heard = progress or (lambda _share, _words: None)
    rows = list(scenes())[: 3 if quick else None]
    for number, (name, brief) in enumerate(rows):
        heard(number / len(rows), name)
        yield from _records(name, brief)


def scenes() -> Iterator[tuple[str, Brief]]:
    """The briefs, by name."""
    square = sw.read("sample:site-square")
    site = square.part.sites[0].model_copy(update={"blocks": [], "squares": []})
    by_river = square.model_copy(update={"part": square.part.model_copy(update={"sites": [site]})})
    river = {"name": "Brook", "outline": BROOK}
    yield "quarter by a river, 5 %", _on(by_river, {"slope": 0.05, "water": [river]})
    yield "quarter round a square, 10 %", _on(square, {"slope": 0.1, "towards": 200})
    yield "hillside, 20 %", Brief.model_validate(HILL)
    yield "hamlet, 12 %", _on(sw.read("sample:village-hamlet"), {"slope": 0.12, "towards": 150})
    yield "terraces continued, 6 %", _on(sw.read("sample:extend-terrace"), {"slope": 0.06})


def _on(brief: Brief, terrain: dict[str, Any]) -> Brief:
    part = brief.part.model_dump() | {"terrain": terrain}
    return brief.model_copy(update={"part": type(brief.part).model_validate(part)})


def _records(name: str, brief: Brief) -> Iterator[Record]:
    plan = plan_of(brief)
    solution = sw.solve(brief, plan=plan, preset="quick")
    report = check(solution, plan=plan)
    ground = report.figures["terrain"]
    area = sum(shapely.Polygon(space.outline, space.holes).area for space in plan.spaces)
    built = sum(piece.category == "building" for piece in solution.pieces)
    yield _record(name, "buildings", "1", built)
    yield _record(name, "findings", "1", len(report.findings))
    yield _record(name, "steepest way for cars", "m/m", ground["steepest_way"])
    yield _record(name, "largest step at a door", "m", ground["largest_door_step"])
    yield _record(name, "highest plinth", "m", ground["largest_plinth"])
    yield _record(name, "cut by area of ground", "m", ground["cut"] / area)
    yield _record(name, "fill by area of ground", "m", ground["fill"] / area)


def _record(case: str, metric: str, unit: str, value: float) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": round(value, 3),
        "baseline": None,
        "baseline_name": "",
        "ratio": None,
        "runs": 1,
    }
