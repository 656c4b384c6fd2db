"""Homes furnished by what other homes tell: learn from five, furnish the sixth, six times.

Each furnished home of Sweet Home 3D is emptied (what is built in stays) and furnished by the
programme three ways: with the shipped groups, with the groups learned from the other homes, and
with their habits as well. The last two differ in nothing but the statistics in the file. Beside
them is set what the designer of the home did: how much of each room is furnished, and the free
floor before and beside groups. ``scenewright bench home_learned``.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from benchmarks.designer_rooms import files
from benchmarks.stages import tally
from scenewright.building.plan import spaces
from scenewright.building.standing import fixed_pieces
from scenewright.catalog.assets import shipped
from scenewright.core.solution import Solution
from scenewright.domains import check, solve
from scenewright.domains.home.learned.groups import Learned, learn, write
from scenewright.domains.home.learned.learning import FurnishedSpace, found_in
from scenewright.domains.home.learned.rows import Targets
from scenewright.domains.home.learned.targets import targets_of
from scenewright.formats import read

Record = dict[str, Any]
Progress = Callable[[float, str], None]
WAYS = ("shipped groups", "learned groups", "learned groups and habits")
NOTHING = Targets((), (), ())
OFTEN = 5  # sides of groups seen less often are not compared


class Run(NamedTuple):
    """One home furnished one way: its rooms, and what is told of it."""

    way: str
    rooms: tuple[FurnishedSpace, ...]
    valid: bool
    left_out: int


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """How far each way is from the designers; ``quick`` takes two homes and one seed."""
    chosen = files()[: 2 if quick else 6]
    seeds = range(1 if quick else 3)
    theirs = [list_furnished(path) for path in files()]

    def runs() -> Iterator[list[Run]]:
        for number, path in enumerate(chosen):
            if progress:
                progress(number / len(chosen), path.stem)
            others = [room for home in theirs for room in home if room.home != path.stem]
            yield list(_runs(path, learn(others, shipped()), seeds))

    def told(homes: list[list[Run]]) -> Iterator[Record]:
        held = [room for home in theirs[: len(homes)] for room in home]
        return _told([run for home in homes for run in home], held)

    return tally(runs(), told)


def list_furnished(path: Path) -> list[FurnishedSpace]:
    """A home as its designer left it."""
    brief = read(path, keep=True)
    return [
        FurnishedSpace(path.stem, space, tuple(fixed_pieces(room, space, shipped())))
        for space, room in zip(spaces(brief), brief.rooms, strict=True)
    ]


def _runs(path: Path, learned: Learned, seeds: range) -> Iterator[Run]:
    with tempfile.TemporaryDirectory() as folder:
        cases, full = Path(folder) / "cases.json", Path(folder) / "full.json"
        write(learned._replace(targets=NOTHING), cases)
        write(learned, full)
        for way, groups in zip(WAYS, ([], [str(cases)], [str(full)]), strict=True):
            brief = read(path, groups=groups)
            for seed in seeds:
                home = solve(brief, seed=seed)
                lacking = sum(one.required for one in home.left_out)
                yield Run(way, tuple(_rooms(path.stem, home)), check(home).valid, lacking)


def _rooms(name: str, home: Solution) -> Iterator[FurnishedSpace]:
    for space in spaces(home.brief):
        yield FurnishedSpace(name, space, tuple(p for p in home.pieces if p.space == space.id))


def _told(runs: Sequence[Run], held: Sequence[FurnishedSpace]) -> Iterator[Record]:
    shares = _shares(held)
    floors = _floors(held)
    base: dict[str, float] = {}
    for way in WAYS:
        mine = [run for run in runs if run.way == way]
        rooms = [room for run in mine for room in run.rooms]
        off = [
            abs(share - shares[key])
            for run in mine
            for key, share in _shares(run.rooms).items()
            if key in shares
        ]
        own = _floors(rooms)
        both = [key for key in floors if key in own]
        figures = {
            "furnished share off the designer's": (float(np.mean(off)), "share", len(off)),
            "free floor off the designers'": (
                float(np.mean([abs(own[key] - floors[key]) for key in both])),
                "m",
                len(both),
            ),
            "homes valid": (float(np.mean([run.valid for run in mine])), "share", len(mine)),
            "required groups left out": (sum(run.left_out for run in mine), "groups", len(mine)),
        }
        for metric, (value, unit, count) in figures.items():
            start = base.setdefault(metric, value)
            yield Record(
                case=way,
                metric=metric,
                unit=unit,
                ours=round(value, 3),
                baseline=round(start, 3),
                baseline_name=WAYS[0],
                ratio=round(value / start, 2) if start else 1.0,
                runs=count,
            )


def _shares(rooms: Sequence[FurnishedSpace]) -> dict[tuple[str, str], float]:
    """The furnished share of each room."""
    return {
        (room.home, room.space.id): share.share
        for room in rooms
        for share in targets_of([room], [], shipped()).shares
    }


def _floors(rooms: Sequence[FurnishedSpace]) -> dict[tuple[str, str], float]:
    """Lower quartile of the free floor at each side of groups that is used and seen often."""
    found = [one for room in rooms for one in found_in(room, shipped())]
    rows = targets_of(rooms, found, shipped()).clearances
    return {
        (row.function, row.side): row.low
        for row in rows
        if row.seen >= OFTEN and row.side != "back"
    }


if __name__ == "__main__":
    for row in records():
        print(
            f"{row['case']:32} {row['metric']:40} {row['ours']:8.3f} {row['unit']} ({row['runs']})"
        )
