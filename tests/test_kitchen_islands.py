"""Islands of kitchens: before the run, with a metre free on all sides, the table kept."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from scenewright.core.brief import Brief, Room
from scenewright.core.catalog import Group
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import check
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer
from scenewright.domains.home.composing.kitchens.islands import add_island
from scenewright.domains.home.furnishing.furnish import FurnishedPatch
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import solve
from test_alignment import room_task


def kitchen(wide, deep, **more):
    return Room(
        id="kitchen",
        function="kitchen",
        outline=[[0, 0], [wide, 0], [wide, deep], [0, deep]],
        doors=[{"at": [wide - 0.8, 0.0], "width": 0.9}],
        windows=[{"at": [wide / 2, deep], "width": 1.6, "sill": 1.0}],
        **more,
    )


@pytest.fixture(scope="module")
def large():
    return solve(Brief(rooms=[kitchen(3.9, 6.0)]), seed=0, steps=1500)


def test_a_large_kitchen_has_an_island_before_its_hob(large):
    assert not check(large).findings
    body = next(p for p in large.pieces if p.category == "kitchen_island")
    hob = next(p for p in large.pieces if p.category == "hob_cabinet")
    ahead = np.array([np.cos(hob.pose.heading), np.sin(hob.pose.heading)])
    away = np.array([body.pose.x - hob.pose.x, body.pose.y - hob.pose.y]) @ ahead
    aisle = away - body.size.depth / 2 - hob.size.depth / 2
    assert 1.0 <= round(float(aisle), 3) <= 1.2
    stools = [p for p in large.pieces if p.category == "bar_stool"]
    assert len(stools) == 2
    for stool in stools:
        beyond = np.array([stool.pose.x - body.pose.x, stool.pose.y - body.pose.y]) @ ahead
        assert beyond > body.size.depth / 2


def test_a_metre_is_free_all_round_an_island(large):
    body = next(p for p in large.pieces if p.category == "kitchen_island")
    (x, y, _, turn), size = body.pose, body.size
    around = shapely.polygons(corners(np.array([[x, y, turn, size.width + 1.96,
                                                 size.depth + 1.96]])))[0]  # fmt: skip
    assert shapely.box(0, 0, 3.9, 6.0).contains(around)
    seats = ("dining_chair", "bar_stool", "stool")
    others = [p for p in large.pieces if p.pose.z < 1.0 and p is not body]
    solid = [p for p in others if p.category not in (*seats, "rug", "runner", "mat")]
    assert not [p.id for p, shape in zip(solid, polygons_of(solid), strict=True)
                if shape.intersection(around).area > 0.02]  # fmt: skip


def test_the_table_is_kept_beside_an_island(large):
    names = [p.category for p in large.pieces]
    assert "dining_table" in names
    assert names.count("dining_chair") >= 4


@pytest.mark.parametrize(
    ("wide", "deep", "more"),
    [(3.4, 4.0, {}), (3.9, 6.0, {"wishes": [{"what": "kitchen_island", "forbid": True}]})],
)
def test_small_kitchens_and_those_that_forbid_it_have_no_island(wide, deep, more):
    found = solve(Brief(rooms=[kitchen(wide, deep, **more)]), seed=0, steps=1500)
    assert "kitchen_island" not in {p.category for p in found.pieces}


def test_no_island_stands_before_a_run_without_a_hob():
    task = room_task("kitchen", 6.0)
    assert task.ground.area >= 14.0
    sink = Piece(
        "sink", "sink_cabinet", "", "a", Pose(1.0, 0.3, 0.0, np.pi / 2), Size(0.6, 0.6, 0.9)
    )
    patch = FurnishedPatch(Group("kitchen", "sink", 0.6, 0.6, ()), np.zeros(5), (True,), 0)
    run = FurnishedGroup(Wish("kitchen", 0), "sink", patch, (sink,))
    answer = RoomAnswer(0.0, (run,), (), (), None, 0.0, 0)
    assert add_island(task, answer, frozenset()) is answer
