"""Random sequences of changes by hand on furnished homes: what share can be read and solved again.

Each sequence makes one to four edits of :func:`scenewright.domains.adjust`, each on what the last
one left: pieces moved within their room, into other rooms or anywhere; swapped, locked, let go;
rooms furnished again. Edits that are refused with one line change nothing. After every edit the
home is written and read back, its ids and supports are looked at and the referee judges it; at the
end it is solved again as a brief. ``scenewright bench adjust_edits``.
"""

from __future__ import annotations

import json
import sys
import time
from collections import Counter
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from scenewright.building.plan import spaces
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains import adjust, check, solve
from scenewright.formats import read, solution_json

Record = dict[str, Any]
HOMES = ("sample:home-studio", "sample:home-flat", "sample:home-house")
STEPS, SHORT = 1000, 100
SEQUENCES, QUICK = 200, 12
MOST_EDITS = 4
KINDS = ("within", "into", "anywhere", "swap", "lock", "unlock", "again")
SHARES = (0.25, 0.25, 0.1, 0.2, 0.05, 0.05, 0.1)


class Outcome(NamedTuple):
    """One sequence: how many edits were ``made`` and ``refused``, how many changes came with a
    reason and how many without, and what is wrong (nothing, it is hoped)."""

    made: int
    refused: int
    reasons: int
    bare: int
    faults: tuple[str, ...]


def records(quick: bool, progress: Callable[[float, str], None] | None = None) -> list[Record]:
    """The share of sequences after which the home reads, is judged and is solved again."""
    count, found, started = QUICK if quick else SEQUENCES, [], time.perf_counter()
    for seed in range(count):
        if progress:
            progress(seed / count, f"sequence {seed + 1} of {count}")
        found.append(sequence(seed))
    sound = sum(not one.faults for one in found)
    for fault, times in Counter(f for one in found for f in one.faults).most_common():
        sys.stderr.write(f"{times} x {fault}\n")
    rows = (
        ("sequences that read, are judged and solved again", "share", sound / count, 1.0),
        ("changes with a reason", "share", _share(found), 1.0),
        ("edits made", "edits", float(sum(one.made for one in found)), 0.0),
        ("edits refused with one line", "edits", float(sum(one.refused for one in found)), 0.0),
        ("a sequence", "s", (time.perf_counter() - started) / count, 0.0),
    )
    return [
        {
            "case": "homes",
            "metric": metric,
            "unit": unit,
            "ours": ours,
            "baseline": aim,
            "baseline_name": "aim" if aim else "",
            "ratio": 1.0,
            "runs": count,
        }
        for metric, unit, ours, aim in rows
    ]


def _share(found: list[Outcome]) -> float:
    told, bare = sum(one.reasons for one in found), sum(one.bare for one in found)
    return told / max(told + bare, 1)


def sequence(seed: int) -> Outcome:
    """One random sequence of edits on one of the homes, and what is wrong after it."""
    rng = np.random.default_rng(seed)
    home, outcome = furnished(HOMES[seed % len(HOMES)]), Outcome(0, 0, 0, 0, ())
    for _ in range(rng.integers(1, MOST_EDITS + 1)):
        edit = random_edit(rng, home)
        try:
            home, changes = adjust(home, steps=SHORT, **edit)
        except InputError as error:
            plain = "\n" not in str(error)
            outcome = outcome._replace(
                refused=outcome.refused + 1,
                faults=outcome.faults if plain else (*outcome.faults, "a refusal in many lines"),
            )
            continue
        told = sum(bool(change.reason) for change in changes)
        outcome = Outcome(
            outcome.made + 1,
            outcome.refused,
            outcome.reasons + told,
            outcome.bare + len(changes) - told,
            (*outcome.faults, *faults_of(home)),
        )
    return outcome._replace(faults=(*outcome.faults, *_again(home)))


def faults_of(home: Solution) -> list[str]:
    """What is wrong with a home as it would be saved."""
    ids = [piece.id for piece in home.pieces]
    rooms = {piece.id: piece.space for piece in home.pieces}
    found = ["an id twice"] * (len(ids) > len(set(ids)))
    found += [
        "on what is not there"
        for p in home.pieces
        if p.on is not None and rooms.get(p.on) != p.space
    ]
    try:
        if solution_json.loads(solution_json.dumps(home)).pieces != home.pieces:
            found.append("reads as something else")
    except InputError as error:
        found.append(f"does not read: {error.fault}")
    check(home)
    return found


def _again(home: Solution) -> list[str]:
    try:
        document = json.loads(solution_json.dumps(home))
        again = solve(solution_json.brief_of(document), steps=SHORT)
    except InputError as error:
        return [f"cannot be solved again: {error.fault}"]
    kept = {p.id for p in home.pieces if p.fixed} - {p.id for p in again.pieces}
    return ["what is locked is gone when solved again"] * bool(kept)


@cache
def furnished(name: str) -> Solution:
    """A furnished sample."""
    return solve(read(name), seed=0, steps=STEPS)


def random_edit(rng: np.random.Generator, home: Solution) -> dict[str, Any]:
    """One edit of a random kind, of random pieces."""
    kind = str(rng.choice(KINDS, p=SHARES))
    rooms = spaces(home.brief)
    one, other = (home.pieces[i].id for i in rng.integers(len(home.pieces), size=2))
    if kind in ("lock", "unlock"):
        return {kind: [one]}
    if kind == "again":
        return {"again": [rooms[rng.integers(len(rooms))].id]}
    if kind == "swap":
        return {"swap": [(one, other)]}
    piece = next(p for p in home.pieces if p.id == one)
    return {"move": {one: _place(rng, kind, piece, home)}}


def _place(
    rng: np.random.Generator, kind: str, piece: Piece, home: Solution
) -> tuple[float, float, float]:
    rooms = spaces(home.brief)
    level = next(room.level for room in rooms if room.id == piece.space)
    near = [
        room
        for room in rooms
        if room.level == level
        and (kind == "anywhere" or (room.id == piece.space) == (kind == "within"))
    ]
    room = (near or list(rooms))[rng.integers(len(near or rooms))]
    low, high = room.outline.min(0), room.outline.max(0)
    x, y = rng.uniform(low + 0.1 * (high - low), high - 0.1 * (high - low))
    return float(x), float(y), float(rng.integers(4) * np.pi / 2)
