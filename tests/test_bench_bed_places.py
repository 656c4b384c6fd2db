"""Places of beds are found where there are any and nowhere else."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np
import shapely
from benchmarks.bed_places import (
    Case,
    find_beside_wardrobe,
    has_back,
    is_faulty,
    list_places,
    list_valid,
)
from benchmarks.composition_faults import bed_adrift, list_rooms, shape_of

import scenewright as sw
from scenewright.building import plan
from scenewright.core.brief import Brief


@lru_cache
def bedroom(width: float, depth: float) -> Case:
    """A bedroom of some size with a door in the south and a window in the north, and its bed."""
    brief = Brief.model_validate(
        {
            "rooms": [
                {
                    "name": "Bedroom",
                    "outline": [[0, 0], [width, 0], [width, depth], [0, depth]],
                    "doors": [{"at": [0.6, 0], "width": 0.8}],
                    "windows": [{"at": [width / 2, depth], "width": 1.0}],
                    "ask": [{"group": "single"}],
                }
            ]
        }
    )
    solution, spaces = sw.solve(brief, steps=500), plan.spaces(brief)
    (bed,) = (p for p in solution.pieces if p.category == "single_bed")
    return Case(solution, spaces, spaces[0], bed)


def along_walls(room):
    return not bed_adrift((room,)).faulty


def test_a_room_with_walls_has_places():
    case = bedroom(3.2, 3.0)
    beds = list(list_valid(case, (), along_walls))
    floor = shapely.Polygon(case.space.outline)
    assert beds
    for bed in beds:
        (room,) = list_rooms(case.spaces, (bed,))
        assert floor.buffer(1e-6).covers(shape_of(bed))
        assert along_walls(room)
    assert any(not is_faulty(case, list_rooms(case.spaces, (b,))[0]) for b in beds)
    assert find_beside_wardrobe(case, iter(beds))


def test_a_room_that_is_full_has_none():
    case = bedroom(3.2, 3.0)
    pose = case.bed.pose._replace(x=1.6, y=1.9)
    block = replace(
        case.bed, id="block", pose=pose, size=case.bed.size._replace(width=2.0, depth=2.0)
    )
    assert list_places(case, case.bed.size, ())
    assert not list_places(case, case.bed.size, (block,))


def test_no_wardrobe_stands_beside_a_bed_without_floor_to_spare():
    case = bedroom(1.3, 2.9)
    beds = list(list_valid(case, (), along_walls))
    assert not find_beside_wardrobe(case, iter(beds))


def test_a_back_is_at_a_wall_with_both_its_ends():
    case = bedroom(3.2, 3.0)
    stand = replace(case.bed, size=case.bed.size._replace(width=1.0, depth=0.5))
    east = stand.pose._replace(x=3.2 - 0.26, y=1.5, heading=np.pi)
    assert has_back(replace(stand, pose=east), case.space)
    assert not has_back(replace(stand, pose=east._replace(x=2.5)), case.space)
    assert not has_back(replace(stand, pose=east._replace(heading=np.pi + 0.2)), case.space)
