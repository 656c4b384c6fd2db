"""Counters that are no rows find what is planted, at their threshold and 0.1 m beyond."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from benchmarks.composition_faults import list_rooms
from benchmarks.unseen import ROWS, Seen, tally_flats
from benchmarks.unseen_counters import COUNTERS, count_all
from benchmarks.unseen_places import count_missing, list_places
from benchmarks.unseen_sheets import write_sheets

from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import LeftOut
from scenewright.core.space import Opening, Space

UP = np.pi / 2
FRONT = Opening("d", "door", "0", 1.0, 0.0, 1.0, 0.0, 0.9, 0.2, 0.0, 2.1, spaces=("room",))
OUTLINE = np.array([[0, 0], [5, 0], [5, 5], [0, 5]], np.float64)
ROOM = Space("room", "Room", ("living",), "0", OUTLINE, openings=(FRONT,))


def piece(category: str, x: float, y: float, width: float = 0.6, depth: float = 0.6) -> Piece:
    """A piece that faces north."""
    name = f"{category}{x}{y}"
    size = Size(width, depth, 1.8)
    return Piece(name, category, category, "room", Pose(x, y, 0.0, UP), size)


def dining(chairs: int, away: float) -> tuple[Piece, ...]:
    """A table with chairs so far from its edge."""
    at = [(2.2, 2.6 + away), (2.8, 2.6 + away), (2.2, 1.4 - away), (2.8, 1.4 - away)]
    seats = [piece("dining_chair", x, y, 0.4, 0.4) for x, y in at[:chairs]]
    return (piece("dining_table", 2.5, 2.0, 1.4, 0.8), *seats)


RUN = (piece("sink_cabinet", 1.0, 0.3), piece("hob_cabinet", 3.0, 0.3))
FULL = piece("bookcase", 2.5, 2.5, 4.2, 4.2)
SINK, BED = RUN[0], piece("double_bed", 4.0, 4.0, 1.6, 2.0)
TV = replace(piece("tv", 2.5, 4.5, 1.2, 0.1), pose=Pose(2.5, 4.5, 0.6, -UP))
CASES = {
    "no table": ((BED,), dining(0, 0.0), dining(0, 0.0)),
    "no table of 0.8 x 0.6 m": (
        (piece("dining_table", 2, 2, 0.79, 0.6),),
        (piece("dining_table", 2, 2, 0.8, 0.6),),
        (piece("dining_table", 2, 2, 0.9, 0.7),),
    ),
    "no seat": ((BED,), (piece("pouf", 2, 2),), (piece("pouf", 2, 2),)),
    "no soft seat from 20 m2": (
        (piece("stool", 2, 2),),
        (piece("armchair", 2, 2, 0.6),),
        (piece("armchair", 2, 2, 0.7),),
    ),
    "fewer places to eat than sleepers": (
        (BED, *dining(1, 0.0)),
        (BED, *dining(2, 0.45)),
        (BED, *dining(2, 0.35)),
    ),
    "wardrobe under 0.5 m deep": (
        (piece("wardrobe", 2, 2, 1.0, 0.49),),
        (piece("wardrobe", 2, 2, 1.0, 0.5),),
        (piece("wardrobe", 2, 2, 1.0, 0.6),),
    ),
    "home with a wardrobe under 0.5 m deep": (
        (piece("wardrobe", 2, 2, 1.0, 0.49), piece("wardrobe", 2, 4, 1.0, 0.6)),
        (piece("wardrobe", 2, 2, 1.0, 0.5),),
        (piece("wardrobe", 2, 2, 1.0, 0.6),),
    ),
    "drawer cabinet under 0.3 m wide": (
        (piece("drawer_cabinet", 2, 2, 0.07),),
        (piece("drawer_cabinet", 2, 2, 0.3),),
        (piece("drawer_cabinet", 2, 2, 0.4),),
    ),
    "sink under 0.5 m wide": (
        (piece("sink_cabinet", 2, 2, 0.45),),
        (piece("sink_cabinet", 2, 2, 0.5),),
        (piece("sink_cabinet", 2, 2, 0.6),),
    ),
    "wardrobe with rails across": (
        (replace(piece("wardrobe", 2, 2, 1.0, 0.45), asset="wardrobe_shallow"),),
        (piece("wardrobe", 2, 2, 1.0, 0.55),),
        (piece("wardrobe", 2, 2, 1.0, 0.55),),
    ),
    "bed under 0.8 x 1.9 m": tuple(
        (piece("single_bed", 2, 2, wide, 1.9 + wide - 0.8),) for wide in (0.75, 0.8, 0.9)
    ),
    "desk under 0.8 x 0.5 m": tuple((piece("desk", 2, 2, wide, 0.6),) for wide in (0.75, 0.8, 0.9)),
    "chest under 0.6 x 0.38 m": tuple(
        (piece("chest_of_drawers", 2, 2, 0.8, deep),) for deep in (0.36, 0.38, 0.48)
    ),
    "shelf under 0.4 x 0.19 m": tuple(
        (piece("storage_shelf", 2, 2, 0.5, deep),) for deep in (0.15, 0.19, 0.29)
    ),
    "basin under 0.45 x 0.3 m": tuple(
        (piece("pedestal_basin", 2, 2, wide, 0.42),) for wide in (0.4, 0.45, 0.55)
    ),
    "butted kitchen run": (
        (SINK, piece("wardrobe", 1.65, 0.3)),
        (SINK, piece("wardrobe", 1.75, 0.3)),
        (SINK, piece("wardrobe", 1.85, 0.3)),
    ),
    "soft seat at a unit": (
        (SINK, piece("sofa", 1.0, 1.15, 1.8, 0.9)),
        (SINK, piece("sofa", 1.0, 1.4, 1.8, 0.9)),
        (SINK, piece("sofa", 1.0, 1.5, 1.8, 0.9)),
    ),
    "fridge between sink and hob": (
        (*RUN, piece("fridge", 2.0, 0.3)),
        (*RUN, piece("fridge", 2.0, 0.65)),
        (*RUN, piece("fridge", 2.0, 0.75)),
    ),
    "pillow beside a fridge": (
        (BED, piece("fridge", 2.45, 3.3)),
        (BED, piece("fridge", 2.4, 3.3)),
        (BED, piece("fridge", 2.3, 3.3)),
    ),
    "screen nearer than 1.5 m": (
        (TV, piece("sofa", 2.5, 3.1, 1.8, 0.9)),
        (TV, piece("sofa", 2.5, 2.95, 1.8, 0.9)),
        (TV, piece("sofa", 2.5, 2.85, 1.8, 0.9)),
    ),
    "bed beside the front door": (
        (piece("single_bed", 1.0, 1.5, 0.9, 2.0),),
        (piece("single_bed", 1.0, 2.05, 0.9, 2.0),),
        (piece("single_bed", 1.0, 2.2, 0.9, 2.0),),
    ),
}
"""For each counter what breaks it, what keeps to its threshold, and what is 0.1 m beyond."""


def test_every_counter_has_its_case() -> None:
    assert set(CASES) == {row.name for row in COUNTERS}


@pytest.mark.parametrize("name", CASES)
def test_counters_find_what_is_planted(name: str) -> None:
    broken, kept, beyond = (list_rooms([ROOM], pieces) for pieces in CASES[name])
    assert count_all(broken)[name].faulty == 1
    assert count_all(kept)[name] == (0, 1)
    assert count_all(beyond, 0.1)[name] == (0, 1)
    if CASES[name][1] != CASES[name][2]:
        assert count_all(kept, 0.1)[name].faulty == 1, "its centimetres buy nothing"


def test_what_a_home_has_none_of_is_not_counted() -> None:
    small = replace(ROOM, outline=OUTLINE * 0.8)
    counts = count_all(list_rooms([small], ()))
    assert counts["no soft seat from 20 m2"] == (0, 0)
    assert counts["fewer places to eat than sleepers"] == (0, 0)
    assert counts["no table"] == (1, 1)


@pytest.mark.parametrize(
    ("taken", "free", "none"),
    [
        ((), 1, 0),
        ((piece("bookcase", 2.5, 2.5, 4.2, 4.2),), 0, 1),
        ((piece("armchair", 2, 2),), 0, 0),
    ],
)
def test_what_is_missing_is_told_apart_by_whether_floor_is_free(taken, free, none) -> None:
    found = count_missing(list_rooms([ROOM], taken), ())
    assert found["soft seat missing though floor is free for it"] == (free, 1)
    assert found["soft seat missing, no floor is free for it"] == (none, 1)
    assert found["soft seat missing without a proof"] == (free + none, free + none)


def test_a_place_leaves_the_door_and_the_ways_free() -> None:
    """In a corridor one may stand at its end, not so as to bar the way to the wardrobe there."""
    narrow = replace(ROOM, outline=np.array([[0, 0], [5, 0], [5, 1.2], [0, 1.2]], np.float64))
    (empty,) = list_rooms([narrow], ())
    boxes = np.array(list(list_places(empty, 0.66, 0.7, 0.4)))
    assert len(boxes)
    assert not ((abs(boxes[:, 0] - 1.0) < 0.45) & (boxes[:, 1] < 0.9)).any()
    wardrobe = replace(piece("wardrobe", 4.7, 0.6, 1.2, 0.6), pose=Pose(4.7, 0.6, 0, np.pi))
    (held,) = list_rooms([narrow], (wardrobe,))
    assert all(box[0] < 1.0 for box in list_places(held, 0.66, 0.7, 0.4))


def test_a_proof_says_what_was_tried() -> None:
    told = LeftOut("room", "reading", "tried an armchair (0.7 x 0.7 m of floor) in Room", False)
    found = count_missing(list_rooms([ROOM], ()), (told,))
    assert found["soft seat missing without a proof"] == (0, 1)
    assert found["table missing without a proof"] == (1, 1)


def test_records_tell_both_shares_and_the_guard() -> None:
    home = list_rooms([ROOM], (piece("wardrobe", 2, 2, 1.0, 0.55),))
    seen = Seen(
        "a", *(count_all(home, by, ROWS) for by in (0.0, 0.1)), {}, {"beds": 2}, [], {}, 1.5
    )
    found = {record["case"]: record for record in tally_flats([seen])}
    row = found["wardrobe under 0.5 m deep"]
    assert (row["ours"], row["baseline"], row["runs"]) == (0.0, 1.0, 1)
    assert [found[name]["ours"] for name in ("valid", "beds")] == [1.0, 2]


def test_sheets_hold_six_homes_each(tmp_path: Path) -> None:
    picture = np.zeros((20, 30, 3), np.uint8)
    write_sheets(tmp_path, [(str(k), picture) for k in range(7)])
    assert {p.name for p in tmp_path.iterdir()} == {"sheet-1.png", "sheet-2.png", "sheets.txt"}
