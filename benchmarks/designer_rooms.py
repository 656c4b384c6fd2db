"""Rooms that a designer furnished and we furnish anew: emptied, with the same groups asked for.

Six example homes of Sweet Home 3D. What is built in there stays in both; the groups of the rest are
found as :mod:`scenewright.domains.home.learned.learning` finds them and asked for in the emptied
rooms, beside the groups for which other pieces stand; or nothing is asked for, and the rooms are
furnished as by default.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from benchmarks.real_data import data_files
from scenewright.building.plan import spaces
from scenewright.building.standing import fixed_pieces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Ask, Brief
from scenewright.core.report import Report
from scenewright.core.scene import Piece
from scenewright.core.solution import Patch, Solution
from scenewright.core.space import Space
from scenewright.domains import check
from scenewright.domains.home.attempts.attempt import floor_of
from scenewright.domains.home.build_problem import build_problem
from scenewright.domains.home.energy import explain
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.learned.learning import FurnishedSpace, GroupOccurrence, found_in
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import PROGRAMME, STANDS_FOR, Wish, part_of
from scenewright.domains.home.solving import solve
from scenewright.formats import read

Floats = NDArray[np.float64]


SMALL = 0.25
"""What is lower does not count, in metres."""
KITCHEN = frozenset(("hob_cabinet", "sink_cabinet", "fridge"))
"""What makes a whole kitchen, in however many runs a designer has it."""


class Seen(NamedTuple):
    """One layout of a room: the space, its floor, all pieces, the boxes of its groups (k, 5), and
    how many faults the referee finds in the room."""

    space: Space
    floor: shapely.Polygon
    pieces: tuple[Piece, ...]
    boxes: Floats
    faults: int


class Pair(NamedTuple):
    """A room as the designer left it and as we furnish it: their energies by term on the groups
    both hold (none if they share none), and the groups we left out."""

    home: str
    designer: Seen
    ours: Seen
    designer_terms: dict[str, float]
    our_terms: dict[str, float]
    left_out: tuple[str, ...]


class Home(NamedTuple):
    """A home furnished twice, and its rooms that hold groups."""

    name: str
    designer: Solution
    ours: Solution
    rooms: tuple[Pair, ...]


def files() -> list[Path]:
    """The furnished homes."""
    return data_files("furnished_homes_sh3d", "*.xml")


def furnish(path: Path, seed: int, asked: bool = True, groups: Sequence[str] = ()) -> Home:
    """A home as it was and as we furnish it with the same groups; as by default where not
    ``asked``; with the files of learned ``groups``."""
    full, bare = read(path, keep=True), read(path, groups=list(groups))
    homes = list(spaces(bare))
    stood = {
        s.id: tuple(fixed_pieces(room, s, shipped()))
        for s, room in zip(homes, full.rooms, strict=True)
    }
    stays = {
        s.id: tuple(fixed_pieces(room, s, shipped()))
        for s, room in zip(homes, bare.rooms, strict=True)
    }
    free = {s.id: _free(stood[s.id], stays[s.id]) for s in homes}
    found = {
        s.id: tuple(found_in(FurnishedSpace(path.stem, s, free[s.id]), shipped())) for s in homes
    }
    asks = {s.id: _asked(s, found[s.id], free[s.id]) for s in homes}
    wishes = [asks[s.id] if asked else None for s in homes]
    rooms = [
        room.model_copy(update={"ask": wish}) for room, wish in zip(bare.rooms, wishes, strict=True)
    ]
    brief = bare.model_copy(update={"rooms": rooms})
    ours = solve(brief, seed=seed)
    was = replace(
        ours,
        brief=full,
        pieces=tuple(p for pieces in stood.values() for p in pieces),
        patches=tuple(patch for s in homes for patch in _patches(s, found[s.id])),
    )
    reports = check(was), check(ours)
    pairs = tuple(
        _pair(path.stem, brief, s, stays[s.id], (was, ours), reports) for s in homes if asks[s.id]
    )
    return Home(path.stem, was, ours, pairs)


def _free(stood: Sequence[Piece], stays: Sequence[Piece]) -> tuple[Piece, ...]:
    """What stands in a room and does not stay."""
    left = {(p.category, p.pose) for p in stays}
    return tuple(p for p in stood if (p.category, p.pose) not in left)


def _asked(space: Space, found: Sequence[GroupOccurrence], free: Sequence[Piece]) -> list[Ask]:
    """The groups found, those that other free pieces stand for, and one kitchen for its parts."""
    counts = Counter(one.case.function for one in found)
    kinds = {p.category for p in free if p.size.height > SMALL}
    if kinds >= KITCHEN:
        counts["kitchen"], counts["kitchenette"], counts["fridge"] = 1, 0, 0
    for kind in sorted(kinds):
        group = group_of(kind, space.functions, frozenset(+counts))
        counts[group] += bool(group)
    return [Ask(group=name, count=n, required=True) for name, n in counts.items() if n]


def group_of(kind: str, functions: Sequence[str], found: frozenset[str]) -> str:
    """The group that a piece of a kind stands for, of those usual in rooms of some functions,
    first what is for that kind; none where one of them was found.

    >>> group_of("single_bed", ("bedroom",), frozenset()), group_of("tv", ("living",), frozenset())
    ('single', 'media')
    >>> group_of("single_bed", ("bedroom",), frozenset({"bunk"}))
    ''
    """
    groups = [group for group, kinds in STANDS_FOR.items() if kind in kinds]
    names = [n for n in PROGRAMME if any(n == f or n.endswith(f"_{f}") for f in functions)]
    usual = {row.group for name in names for row in PROGRAMME[name]}
    chosen = [group for group in groups if group in usual]
    if found.intersection(groups) or not chosen:
        return ""
    return max(chosen, key=lambda group: kind in GROUPS[group].essential)


def _patches(space: Space, found: Sequence[GroupOccurrence]) -> Iterator[Patch]:
    for k, one in enumerate(found):
        box = (*one.box, one.case.width, one.case.depth)
        yield Patch(f"{space.id}/{one.case.function}_{k}", space.id, one.case.function, box)


def _pair(
    home: str,
    brief: Brief,
    space: Space,
    stays: tuple[Piece, ...],
    solutions: tuple[Solution, Solution],
    reports: tuple[Report, Report],
) -> Pair:
    was, ours = (_seen(space, s, r) for s, r in zip(solutions, reports, strict=True))
    theirs, mine = (_boxes(space, s) for s in solutions)
    shared = {f: min(len(boxes), len(mine.get(f, []))) for f, boxes in theirs.items()}
    terms = [_terms(brief, space, stays, shared, boxes) for boxes in (theirs, mine)]
    out = tuple(one.what for one in solutions[1].left_out if one.space == space.id)
    return Pair(home, was, ours, terms[0], terms[1], out)


def _seen(space: Space, solution: Solution, report: Report) -> Seen:
    pieces = tuple(p for p in solution.pieces if p.space == space.id)
    boxes = [patch.box for patch in solution.patches if patch.space == space.id]
    faults = sum(found.space == space.id for found in report.findings)
    floor = shapely.Polygon(space.outline, list(space.holes))
    return Seen(space, floor, pieces, np.array(boxes).reshape(-1, 5), faults)


def _boxes(space: Space, solution: Solution) -> dict[str, list[tuple[float, ...]]]:
    boxes: dict[str, list[tuple[float, ...]]] = {}
    for patch in solution.patches:
        if patch.space == space.id:
            boxes.setdefault(patch.function, []).append(patch.box)
    return boxes


def _terms(
    brief: Brief,
    space: Space,
    stays: tuple[Piece, ...],
    shared: dict[str, int],
    boxes: dict[str, list[tuple[float, ...]]],
) -> dict[str, float]:
    """Cost by term of the groups both layouts hold, as one problem with the same wishes."""
    groups = [group for group, count in shared.items() for _ in range(count)]
    if not groups:
        return {}
    taken = sum(p.size.width * p.size.depth for p in stays if p.size.height > 0.05)
    whole = float(shapely.Polygon(space.outline, list(space.holes)).area)
    ground = ground_of(space, stays, max(whole - taken, 0.1))
    problem = build_problem(
        ground,
        tuple(Wish(group, 1) for group in groups),
        PRESETS["default"].weights,
        False,
        brief.route_width,
        part_of(space.functions, floor_of(ground)),
    )
    chosen = [box for group, count in shared.items() for box in boxes.get(group, [])[:count]]
    costs: Counter[str] = Counter()
    for part in explain(problem, np.array(chosen)):
        costs[part.term] += part.cost  # type: ignore[assignment]
    return {name: float(cost) for name, cost in costs.items()}
