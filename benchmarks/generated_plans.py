"""Generated floor plans: how long one takes, whether it can be lived in, and how its rooms compare
with those of real flats. ``scenewright bench generated_plans``.

Plans of 1 to 6 rooms on one to three storeys by seed, beside the flats of Raster-to-Vector (Liu,
Wu, Kohli, Furukawa 2017) at their true scale. Times are processor seconds.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from time import process_time
from typing import Any

import numpy as np
import shapely

from benchmarks.plans_r2v import adapt, raw_plans
from benchmarks.rescaled_r2v import rescale
from scenewright.core.brief import Brief
from scenewright.domains import check, plan_valid, solve
from scenewright.formats import brief_json
from scenewright.workflow.generate import generate

Record = dict[str, Any]
Progress = Callable[[float, str], None]
QUICK, USUAL = 60, 1000
QUICK_FURNISHED, FURNISHED = 2, 24
KINDS = ("living", "kitchen", "bedroom", "bathroom", "hall")
PAIRS = (("living", "kitchen"), ("living", "hall"), ("bathroom", "hall"), ("bedroom", "hall"))


def records(quick: bool = False, progress: Progress | None = None) -> list[Record]:
    """Milliseconds a plan, shares distinct, valid and complete, areas and doors, beside real flats
    read from their file."""
    count, furnished = (QUICK, QUICK_FURNISHED) if quick else (USUAL, FURNISHED)
    generate("home", rooms=3, seed=0)  # compiled
    made = (generate("home", seed=k, **asked_of(k)) for k in range(count))
    real = (adapt(rescale(raw)).brief for raw in raw_plans()[:count])
    sets = [_timed(made), _timed(brief for brief in real if brief is not None)]
    found = [_row("plan", "processor time", "ms", [each for _, each in sets], count)]
    briefs = [list_ for list_, _ in sets]
    found.append(_row("plans", "distinct", "%", [100 * _distinct(each) for each in briefs], count))
    shares = []
    for k, list_ in enumerate(briefs):
        if progress:
            progress(0.2 + 0.4 * k, "furnishing")
        shares.append(_furnished(list_[:furnished]))
    for k, metric in enumerate(("valid", "complete")):
        pair = [100 * share[k] for share in shares]
        found.append(_row("homes furnished", metric, "%", pair, furnished))
    return [*found, *_compared(briefs[0], briefs[1], count)]


def asked_of(seed: int) -> dict[str, Any]:
    """What the plan of a seed is asked for: rooms and storeys drawn, all else as usual."""
    rng = np.random.default_rng([seed, 1])
    rooms = int(rng.integers(1, 7))
    storeys = 2 if rooms >= 4 and rng.random() < 0.3 else 1
    return {"rooms": rooms, "storeys": storeys}


def _row(case: str, metric: str, unit: str, pair: Sequence[float], runs: int) -> Record:
    ours, theirs = (round(float(value), 2) for value in pair)
    ratio = round(ours / theirs, 2) if theirs else 1.0
    record = Record(case=case, metric=metric, unit=unit, ours=ours, baseline=theirs)
    return record | {"baseline_name": "real flats", "ratio": ratio, "runs": runs}


def _timed(briefs: Iterator[Brief]) -> tuple[list[Brief], float]:
    """The briefs and the milliseconds of processor time that one took."""
    start = process_time()
    found = list(briefs)
    return found, 1000 * (process_time() - start) / len(found)


def _distinct(briefs: list[Brief]) -> float:
    texts = {brief_json.dumps(brief.model_copy(update={"name": ""})) for brief in briefs}
    return len(texts) / len(briefs)


def _furnished(briefs: list[Brief]) -> tuple[float, float]:
    """Shares of homes that are valid, and complete, once furnished by default."""
    reports = [check(solve(brief, seed=0)) for brief in briefs]
    valid, complete = ([getattr(r, name) for r in reports] for name in ("valid", "complete"))
    return float(np.mean(valid)), float(np.mean(complete))


def _compared(made: list[Brief], real: list[Brief], count: int) -> Iterator[Record]:
    """Medians of areas by kind of room, and the shares of homes with a door between two kinds."""
    areas = [_areas(made), _areas(real)]
    for kind in KINDS:
        pair = [float(np.median(found[kind])) if found[kind] else 0.0 for found in areas]
        yield _row(kind, "median floor", "m²", pair, count)
    doors = [_doors(made), _doors(real)]
    for first, second in PAIRS:
        shares = [100 * found[frozenset((first, second))] / found[frozenset()] for found in doors]
        yield _row(f"{first} and {second}", "homes with a door between", "%", shares, count)


def _kind(functions: Any) -> str:
    """The first of :data:`KINDS` that a room's functions name."""
    names = [functions] if isinstance(functions, str) else list(functions or ())
    return next((kind for name in names for kind in KINDS if kind in name), "")


def _areas(briefs: list[Brief]) -> dict[str, list[float]]:
    """Square metres of the rooms of each kind; storeys and homes together."""
    found: dict[str, list[float]] = {kind: [] for kind in (*KINDS, "")}
    for brief in briefs:
        for room in brief.rooms:
            found[_kind(room.function)].append(shapely.Polygon(room.outline).area)
    return found


def _doors(briefs: list[Brief]) -> Counter[frozenset[str]]:
    """In how many homes a door joins two kinds of rooms; under the empty set, how many homes."""
    found: Counter[frozenset[str]] = Counter({frozenset(): len(briefs)})
    for brief in briefs:
        spaces = plan_valid(brief).spaces
        kinds = {space.id: _kind(space.functions) for space in spaces}
        doors = [door for space in spaces for door in space.openings if door.kind != "window"]
        found.update({frozenset(kinds[end] for end in door.spaces) for door in doors})
    return found
