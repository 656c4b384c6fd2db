"""The referee on passages between zones, and on objects outside their zone."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from tests.judged_halls import (
    answer,
    box,
    group,
    hall_brief,
    judge,
    kinds,
    piece,
    turned,
    wall,
    zone,
)

from hall_floors import EAST_DOOR, SOUTH_DOOR, figures, gap, two_zones
from scenewright.building.standing import item_of
from scenewright.domains.hall.check.escape import walking_distance
from scenewright.domains.hall.check.passages import clear_width


@pytest.mark.parametrize(
    ("width", "found"), [(1.21, set()), (1.195, set()), (1.19, {"narrow_passage"})]
)
@pytest.mark.parametrize("angle", [0.0, 0.7])
def test_a_gap_in_a_partition_has_its_width(width, found, angle):
    report = judge(turned(two_zones(*gap(width)), angle, (20.0, -5.0)))
    assert kinds(report) == found
    assert figures(report)["passages"][0]["clear"] == pytest.approx(width, abs=0.012)


def test_a_narrow_passage_says_where_and_what_is_missing():
    (found,) = judge(two_zones(*gap(0.8))).findings
    assert found.amount == pytest.approx(0.4, abs=0.012)
    assert sorted(found.other.split(",wall")) == ["@6,2.8", "wall@6,0"]
    for word in ("west", "east", "1.20 m", "wall@6,0", "wall@6,2.8"):
        assert word in found.message
    x, y = figures(judge(two_zones(*gap(0.8))))["passages"][0]["at"]
    assert (x, y) == (pytest.approx(6, abs=0.11), pytest.approx(2.4, abs=0.02))


def test_a_piece_narrows_a_passage():
    """A gap of 2 m, and behind it a plinth whose corner comes within 1.10 m of the partition's."""
    behind = piece("plinth", 6.5, 4.05, 0.6, 1.9)
    report = judge(two_zones(*gap(2.0), behind))
    passage = figures(report)["passages"][0]
    assert kinds(report) == {"narrow_passage"}
    assert passage["clear"] == pytest.approx(math.hypot(0.1, 1.1), abs=0.012)
    assert {"plinth@6.5,4.05", "wall@6,0"} == set(passage["message"].split()) - {"between", "and"}


def test_a_partition_across_closes_the_passage():
    report = judge(two_zones(wall(6, 0, 6, 6)))
    found = report.of("narrow_passage")[0]
    assert found.amount == 1.2
    assert "closed" in found.message
    assert "wall@6,0" in found.message
    assert figures(report)["passages"][0]["clear"] == 0


def test_the_floor_of_no_zone_is_a_way_round():
    brief = hall_brief(box(0, 0, 12, 6), (SOUTH_DOOR,))
    zones = zone("west", box(0, 0, 6, 4)), zone("east", box(6, 0, 12, 4))
    around = answer(brief, (wall(6, 0, 6, 4),), zones, (("west", "east", 1.2),))
    assert not kinds(judge(around))
    third = (*zones, zone("north", box(0, 4, 12, 6)))
    assert kinds(
        judge(
            replace(
                around,
                detail=around.detail._replace(layout=around.detail.layout._replace(zones=third)),
            )
        )
    ) == {"narrow_passage"}


def test_a_link_of_the_brief_counts_even_if_the_graph_lacks_it():
    outlines = [
        {"id": "west", "outline": box(0, 0, 6, 6)},
        {"id": "east", "outline": box(6, 0, 12, 6)},
    ]
    asked = {"zones": outlines, "links": [{"between": ["west", "east"]}], "passage_width": 1.5}
    closed = two_zones(*gap(1.4), **asked)
    silent = replace(
        closed, detail=closed.detail._replace(layout=closed.detail.layout._replace(links=()))
    )
    assert not kinds(judge(closed))
    assert kinds(judge(silent)) == {"narrow_passage"}
    fixed = tuple(replace(p, fixed=True) for p in silent.pieces)
    assert [f.given for f in judge(replace(silent, pieces=fixed)).findings] == [False]
    items = [item_of(p).model_dump() for p in fixed]
    drawn = replace(silent, brief=two_zones(*fixed, **asked, fixed=items).brief)
    assert [f.given for f in judge(drawn).findings] == [True]
    drawn_by_us = two_zones(*fixed, width=1.5, fixed=items)
    assert [f.given for f in judge(drawn_by_us).findings] == [False]


def test_links_of_brief_and_graph_are_judged_together():
    """The brief links a to b, the graph b to c; both borders are closed."""
    zones = [zone(n, box(4 * k, 0, 4 * k + 4, 6)) for k, n in enumerate("abc")]
    listed = [{"id": z.id, "outline": z.outline.tolist()} for z in zones]
    asked = {"zones": listed, "links": [{"between": ["a", "b"]}]}
    brief = hall_brief(box(0, 0, 12, 6), (SOUTH_DOOR, EAST_DOOR), **asked)
    walls = wall(4, 1.6, 4, 6), wall(8, 0, 8, 5)
    report = judge(answer(brief, walls, zones, (("b", "c", 1.1),)))
    rows = figures(report)["passages"]
    assert [(r["first"], r["second"], r["needed"]) for r in rows] == [
        ("b", "c", 1.1),
        ("a", "b", 1.2),
    ]
    assert len(report.of("narrow_passage")) == 1


@given(st.lists(st.tuples(st.floats(0, 8), st.floats(0, 3), st.floats(0.2, 1.5)), max_size=8))
def test_clear_width_agrees_with_a_raster(boxes):
    """The widest path over a fine raster: at each point twice the distance to what is nearest."""
    west, east = shapely.box(0, 0, 4, 3), shapely.box(4, 0, 8, 3)
    solid = [shapely.box(x - s / 2, y - s / 2, x + s / 2, y + s / 2) for x, y, s in boxes]
    free = shapely.difference(shapely.box(0, 0, 8, 3), shapely.union_all(solid))
    step = 0.05
    x, y = np.meshgrid(np.arange(step / 2, 8, step), np.arange(step / 2, 3, step), indexing="ij")
    points = shapely.points(x, y)
    room = np.where(shapely.contains(free, points), shapely.distance(points, free.boundary), 0)
    low, high = 0.0, 3.0
    while high - low > 0.02:  # bisect the width with a flood over the raster
        middle = (low + high) / 2
        open_ = room >= middle / 2
        inside = np.where(x < 4, 4 - x, 0) >= middle / 2
        flood = np.where(open_ & inside, 0.0, np.inf)
        reached = np.isfinite(walking_distance(open_, flood, step))
        target = open_ & (np.where(x > 4, x - 4, 0) >= middle / 2)
        low, high = (middle, high) if (reached & target).any() else (low, middle)
    assert clear_width(west, east, free) == pytest.approx(low, abs=0.12)


def test_pieces_of_a_group_stay_in_its_zone():
    inside, over = piece("case", 5.5, 3, 1, 1), piece("case", 5.515, 5, 1, 1)
    grouped = group("h/cases", "west", inside, over)
    report = judge(two_zones(inside, over, groups=(grouped,)))
    (found,) = report.findings
    assert (found.kind, found.piece, found.other) == ("outside_zone", over.id, "west")
    assert found.amount == pytest.approx(0.015)
    nearly = replace(over, pose=over.pose._replace(x=5.508))
    assert judge(two_zones(inside, nearly, groups=(grouped,))).valid
