"""The referee against one of another hand: 5,000 random changes of a valid solution in each domain.

A change moves, turns, doubles, removes, swaps or resizes pieces of the saved JSON, and says of some
that they are fixed. A *false valid* is one that :mod:`.plain_rooms` or :mod:`.plain_ground` finds
grossly wrong and ``check`` calls valid: there should be none. The other way round, that ``check``
finds something where the plain referees find nothing, is no fault: they look at less.
``scenewright bench referee``.
"""

from __future__ import annotations

import copy
import json
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from benchmarks import plain_ground, plain_rooms
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.domains import check, plan_of, solve
from scenewright.formats import read, solution_json

Record = dict[str, Any]
Document = dict[str, Any]
Change = Callable[[Document, np.random.Generator], None]

MOVES, QUICK = 5000, 40
LOOKED = 10
"""Of so many changes that are called not valid the plain referee looks at one, too."""
SHARE = 0.2
"""The share of changes after which all that was touched says that it is fixed."""
MOST = 2
"""Changes made one after the other, at most."""
HALL: Document = {
    "domain": "hall",
    "name": "Little shop",
    "rooms": [
        {
            "id": "shop",
            "outline": [[0, 0], [10, 0], [10, 8], [0, 8]],
            "doors": [{"id": "door", "at": [5, 0], "width": 1.6, "swing": "slide"}],
            "zones": [{"id": "front", "area": 30}, {"id": "back", "area": 40}],
            "links": [{"between": ["front", "back"]}],
            "demands": [
                {"id": "till", "category": "checkout", "count": 1, "zone": "front"},
                {"id": "islands", "category": "display_table", "count": 3, "zone": "front"},
                {"id": "shelves", "category": "wall_shelving", "count": 4, "zone": "back"},
                {"id": "gondolas", "category": "gondola", "count": 4, "zone": "back"},
            ],
        }
    ],
}
SITE: Document = {
    "domain": "site",
    "name": "Close",
    "sites": [
        {
            "id": "close",
            "outline": [[0, 0], [110, 0], [110, 90], [0, 90]],
            "roads": [{"id": "road", "line": [[0, 45], [110, 45]], "width": 7}],
            "landmarks": [{"id": "hall", "at": [18, 70], "size": [14, 12, 9]}],
            "buildings": [{"model": "villa", "count": 5}, {"model": "row_houses", "count": 2}],
        }
    ],
}
KEPT: Document = {
    "name": "Room with a stove",
    "rooms": [
        {
            "id": "room",
            "function": "bedroom",
            "outline": [[0, 0], [4.6, 0], [4.6, 3.8], [0, 3.8]],
            "doors": [{"at": [4.0, 0], "width": 0.9}],
            "windows": [{"at": [2.0, 3.8]}],
            "fixed": [
                {"id": "stove", "category": "stove", "at": [0.4, 0.4], "size": [0.6, 0.6, 1.2]}
            ],
        }
    ],
}
CASES: dict[str, tuple[Document | str, ...]] = {
    "home": ("sample:home-room", KEPT),
    "hall": (HALL,),
    "site": (SITE,),
    "village": ("sample:village-hamlet",),
    "extend": ("sample:extend-village",),
}


class Tally(NamedTuple):
    """Of changes: how many were ``made``, how many of them are called ``valid``, what is grossly
    wrong with any of these, and of :data:`LOOKED` called not valid in how many the plain referee
    finds nothing (``alarms``)."""

    made: int
    valid: int
    missed: tuple[str, ...]
    looked: int
    alarms: int


def records(quick: bool, progress: Callable[[float, str], None] | None = None) -> Iterator[Record]:
    """False valids of each domain, and how many changes were wrong by both."""
    count = QUICK if quick else MOVES
    for number, (domain, cases) in enumerate(CASES.items()):
        found = [
            tally(text, count // len(cases), k, progress, (number, domain))
            for k, text in enumerate(solved_cases(cases))
        ]
        missed = Counter(fault for one in found for fault in one.missed)
        for fault, times in missed.most_common(20):
            sys.stderr.write(f"{domain}: {times} x {fault} called valid\n")
        made, valid, _, looked, alarms = (
            sum(rows[1:], rows[0]) for rows in zip(*found, strict=True)
        )
        yield _record(domain, "called valid and grossly wrong", missed.total(), valid, "valid")
        yield _record(domain, "called valid", valid, made, "made")
        yield _record(domain, "called not valid, nothing gross found", alarms, looked, "looked at")


def _record(domain: str, metric: str, ours: int, whole: int, name: str) -> Record:
    return {
        "case": domain,
        "metric": metric,
        "unit": "changes",
        "ours": float(ours),
        "baseline": float(whole),
        "baseline_name": name,
        "ratio": ours / max(whole, 1),
        "runs": whole,
    }


def solved_cases(cases: tuple[Document | str, ...]) -> Iterator[str]:
    """The solutions that are changed, as text."""
    for case in cases:
        brief = read(case) if isinstance(case, str) else Brief.model_validate(case)
        yield solution_json.dumps(solve(brief, seed=1))


def tally(
    text: str,
    count: int,
    seed: int,
    progress: Callable[[float, str], None] | None = None,
    place: tuple[int, str] = (0, ""),
) -> Tally:
    """Change a solution so many times, each time from the start, and have both judge it."""
    start, rng = json.loads(text), np.random.default_rng(seed)
    judge = plain_rooms.faults if start["brief"]["rooms"] else plain_ground.faults
    known, first = judge(start), solution_json.loads(text)
    planned = first.brief, plan_of(first.brief)
    made, called, alarms, looked, missed = 0, 0, 0, 0, list[str]()
    for k in range(count):
        if progress and k % 20 == 0:
            progress((place[0] + k / count) / len(CASES), f"{place[1]}: change {k} of {count}")
        changed = copy.deepcopy(start)
        words = change(changed, rng)
        made, valid = made + 1, is_valid(changed, planned)
        called += valid
        if not valid and k % LOOKED:
            continue
        faults = judge(changed) - known
        looked, alarms = looked + (not valid), alarms + (not valid and not faults)
        if valid and faults:
            missed.append(f"{min(faults)[0]} after {words}")
    return Tally(made, called, tuple(missed), looked, alarms)


def is_valid(document: Document, planned: tuple[Brief, Plan]) -> bool:
    """Whether a document is read and judged valid; its brief, if it is as ``planned``, once."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "changed.json"
        file.write_text(json.dumps(document), encoding="utf-8")
        try:
            solution, plan = solution_json.read_planned(file, planned)
        except InputError:
            return False
    return check(solution, plan=plan).valid


def change(document: Document, rng: np.random.Generator) -> str:
    """Make one change or two to a document, and say which."""
    made, before = [], {json.dumps(piece) for piece in document["pieces"]}
    for _ in range(rng.integers(1, MOST + 1)):
        name = str(rng.choice([*CHANGES]))
        CHANGES[name](document, rng)
        made.append(name)
    if rng.random() < SHARE:
        made.append("fix")
        for piece in document["pieces"]:
            piece["fixed"] |= json.dumps(piece) not in before
    return ", ".join(made)


def _pick(document: Document, rng: np.random.Generator) -> Document:
    """A piece that is no tree or lamp, if there is one."""
    rows = [p for p in document["pieces"] if p["category"] not in ("tree", "lamp_post")]
    chosen: Document = rows[int(rng.integers(len(rows)))]
    return chosen


def _move(document: Document, rng: np.random.Generator) -> None:
    piece = _pick(document, rng)
    far = float(rng.choice([0.3, 1.0, 3.0])) * max(piece["size"][:2])
    piece["pose"][:2] = (np.array(piece["pose"][:2]) + rng.normal(0, far, 2)).tolist()


def _turn(document: Document, rng: np.random.Generator) -> None:
    piece = _pick(document, rng)
    piece["pose"][3] = float(rng.uniform(-np.pi, np.pi))


def _double(document: Document, rng: np.random.Generator) -> None:
    piece = copy.deepcopy(_pick(document, rng))
    piece["id"] += f"-{len(document['pieces'])}"
    piece["pose"][:2] = (np.array(piece["pose"][:2]) + rng.normal(0, 4.0, 2)).tolist()
    document["pieces"].append(piece)


def _remove(document: Document, rng: np.random.Generator) -> None:
    piece = _pick(document, rng)
    document["pieces"] = [p for p in document["pieces"] if p["on"] != piece["id"]]
    document["pieces"].remove(piece)


def _swap(document: Document, rng: np.random.Generator) -> None:
    one, other = _pick(document, rng), _pick(document, rng)
    one["pose"], other["pose"] = other["pose"], one["pose"]


def _resize(document: Document, rng: np.random.Generator) -> None:
    piece, factor = _pick(document, rng), float(rng.uniform(0.5, 2.0))
    piece["size"] = [value * factor for value in piece["size"]]
    if piece.get("footprint"):
        piece["footprint"] = [[x * factor, y * factor] for x, y in piece["footprint"]]


CHANGES: dict[str, Change] = {
    "move": _move,
    "turn": _turn,
    "double": _double,
    "remove": _remove,
    "swap": _swap,
    "resize": _resize,
}
"""What is changed, by name."""
