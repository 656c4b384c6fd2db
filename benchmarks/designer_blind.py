"""Blind pairs: each room of the furnished homes twice, side by side, nobody told which is whose.

``python -m benchmarks.designer_blind OUT [SEED]`` writes to the folder OUT a sheet (SVG) for every
home, in which each numbered room stands as A and as B, one the designer's and one ours, in random
order, and ``key.json``, which tells them apart. Ours is furnished as by default: nothing that the
designer put there is asked for. Judge the sheets before the key is opened, a line a room (``7 A``:
the better one, ``7 -``: neither), then ``python -m benchmarks.designer_blind OUT VERDICTS`` tells
who was preferred where. Both are drawn alike: shipped models without a style; lamps, curtains and
what hangs on walls, which ours has everywhere and the homes as furnished hardly anywhere, are left
out of both.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from benchmarks.designer import homes
from benchmarks.designer_rooms import Home, Pair
from benchmarks.designer_sheet import draw_plan, place_side_by_side
from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.atomic_file import write_atomically
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution

OURS, DESIGNER = "ours", "designer"


class BlindPair(NamedTuple):
    """A room's number on its sheet, and which of both stands as ``a``."""

    number: int
    home: str
    room: str
    a: str
    b: str


def shuffle_pairs(found: list[Home], seed: int) -> list[BlindPair]:
    """Every room with its number and whose layout stands first.

    >>> shuffle_pairs([], 0)
    []
    """
    rng = np.random.default_rng(seed)
    pairs = [pair for home in found for pair in home.rooms]
    turned = rng.random(len(pairs)) < 0.5
    return [
        BlindPair(k + 1, p.home, p.ours.space.id, *((DESIGNER, OURS) if t else (OURS, DESIGNER)))
        for k, (p, t) in enumerate(zip(pairs, turned.tolist(), strict=True))
    ]


def only_room(solution: Solution, pair: Pair) -> Solution:
    """One room of a solution, with what stands in it, drawn by the shipped models."""
    whole = [space.id for space in spaces(solution.brief)]
    room = solution.brief.rooms[whole.index(pair.ours.space.id)]
    alone = {"rooms": [room.model_copy(update={"fixed": []})], "walls": []}
    brief = solution.brief.model_copy(update=alone)
    (space,) = spaces(brief)
    held = (p for p in solution.pieces if p.space == pair.ours.space.id)
    return replace(
        solution,
        brief=brief,
        pieces=tuple(_plain(p, space.id) for p in held if _is_shown(p)),
        patches=(),
        terms=(),
        left_out=(),
    )


def _is_shown(piece: Piece) -> bool:
    kind = shipped().kinds[piece.category]
    return kind.support in ("floor", "top") and (kind.flat or piece.function != "light")


def _plain(piece: Piece, space: str) -> Piece:
    """A piece without a style, a name or a room of its own."""
    asset = shipped().choose(piece.category, piece.size)
    return replace(piece, asset=asset.id if asset else "", space=space, fixed=False)


def draw_home(home: Home, pairs: list[BlindPair]) -> str:
    """The sheet of a home: its rooms as A and B in turn."""
    return place_side_by_side(list(_draw_rooms(home, pairs)), 2)


def _draw_rooms(home: Home, pairs: list[BlindPair]) -> Iterator[tuple[str, float, float]]:
    both = {OURS: home.ours, DESIGNER: home.designer}
    for pair, blind in zip(home.rooms, pairs, strict=True):
        for letter, whose in (("A", blind.a), ("B", blind.b)):
            name = f"{blind.number}{letter}"
            yield draw_plan(only_room(both[whose], pair), name, f"{name}-")


def open_key(key: list[BlindPair], verdicts: dict[int, str]) -> dict[str, list[str]]:
    """The rooms in which ours was preferred, the designer's, and neither (``tie``); ValueError for
    a room without a verdict. ``verdicts`` are A, B or - by the rooms' numbers."""
    told: dict[str, list[str]] = {OURS: [], DESIGNER: [], "tie": []}
    for pair in key:
        if pair.number not in verdicts:
            raise ValueError(f"room {pair.number} has no verdict")
        whose = {"A": pair.a, "B": pair.b}.get(verdicts[pair.number], "tie")
        told[whose].append(f"{pair.home}/{pair.room}")
    return told


def tell(folder: Path, verdicts: Path) -> None:
    """Print who was preferred where."""
    key = [BlindPair(**row) for row in json.loads((folder / "key.json").read_text())]
    rows = (line.split("#")[0].split() for line in verdicts.read_text().splitlines())
    told = {int(row[0]): row[1] for row in rows if row}
    for whose, rooms in open_key(key, told).items():
        print(f"{whose}: {len(rooms)} of {len(key)}", *rooms, sep="\n  ")


def main(folder: Path, seed: int = 0) -> None:
    """Write the sheets and the key."""
    found = list(homes(6, asked=False))
    pairs = shuffle_pairs(found, seed)
    folder.mkdir(parents=True, exist_ok=True)
    for home in found:
        mine = [pair for pair in pairs if pair.home == home.name]
        write_atomically(folder / f"{home.name}.svg", draw_home(home, mine))
    key = json.dumps([pair._asdict() for pair in pairs], indent=1)
    write_atomically(folder / "key.json", key + "\n")


def parse_args(given: list[str]) -> argparse.Namespace:
    """The folder of the sheets, and a seed to draw them by or the verdicts to count."""
    parser = argparse.ArgumentParser(prog="benchmarks.designer_blind", description=main.__doc__)
    parser.add_argument("out", type=Path, help="folder of the sheets and their key")
    parser.add_argument("then", nargs="?", default="0", help="seed, or a file of verdicts")
    return parser.parse_args(given)


if __name__ == "__main__":
    args = parse_args(sys.argv[1:])
    if args.then.isdigit():
        main(args.out, int(args.then))
    else:
        tell(args.out, Path(args.then))
