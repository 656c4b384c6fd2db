"""What stands in slanted corners of halls, and small objects that people get to."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from tests.hall_briefs import answer, hall

from scenewright.core.brief.zones import Demand
from scenewright.core.layout import corners
from scenewright.domains.hall.accessories import place
from scenewright.domains.hall.demands.holdings import fill_defaults
from scenewright.domains.hall.walls.corners import corner_share
from scenewright.domains.hall.zoning.borders import WallStretch


@pytest.mark.parametrize("turn", np.deg2rad([40.0, 60.0, 80.0]))
def test_rows_behind_an_obtuse_corner_touch_where_it_says(turn):
    """The row before the corner ends in it; the next one begins at the share of its depth."""
    deep, way = 0.8, np.array([np.cos(turn), np.sin(turn)])
    end = 6.0 * way + [6.0, 0.0]
    floor = shapely.Polygon([(0, 0), (6, 0), end, (end[0] - 9.0, end[1] + 9.0), (0, 12)])
    share = corner_share(WallStretch(6.0, 0.0, *end), floor)
    assert share == pytest.approx(np.sin(turn))
    first = shapely.box(4.0, 0.0, 6.0, deep)
    for start, meets in ((share * deep - 0.02, True), (share * deep + 0.02, False)):
        middle = (
            np.array([6.0, 0.0]) + (start + 1.0) * way + 0.5 * deep * np.array([-way[1], way[0]])
        )
        box = np.array([[*middle, turn + np.pi / 2, 2.0, deep]])
        assert (shapely.area(shapely.Polygon(corners(box)[0]) & first) > 1e-6) == meets


def test_a_stage_fits_a_wall_between_slanted_corners():
    room = hall(
        outline=[[3, 0], [11, 0], [14, 3], [14, 7], [11, 10], [3, 10], [0, 7], [0, 3]],
        doors=[{"id": "main", "at": [7, 0], "width": 1.6, "use": "entrance"}],
        demands=[
            {"category": "stage", "size": [6.2, 2.0, 0.6]},
            {"category": "screen", "size": [4.0, 0.3, 2.2]},
        ],
    )
    found = answer(room)
    assert not found.left_out
    (stage,) = (p for p in found.pieces if p.category == "stage")
    assert stage.pose.y == pytest.approx(9.0, abs=0.02)


@pytest.mark.parametrize(
    ("category", "sides"), [("potted_tree", [1, 1, 1, 1]), ("bar_stool", [0, 0, 0, 0])]
)
def test_small_objects_are_reached_from_where_they_are_used_or_from_any_side(category, sides):
    wish = fill_defaults(Demand(category=category), category)
    boxes, access = place._find_used([wish], [[np.array([1.0, 2.0, 0.0, 0.5, 0.5]), None]])
    assert boxes.tolist() == [[1.0, 2.0, 0.0, 0.5, 0.5]]
    assert access.astype(int).tolist() == [sides]


@pytest.mark.parametrize(
    ("x", "heading", "stands"), [(0.25, 0.0, True), (0.4, 0.0, False), (0.25, np.pi, False)]
)
def test_what_is_to_stand_at_a_wall_has_one_behind_it(x, heading, stands):
    boxes = np.array([[x, 2.0, heading, 0.5, 0.5]])
    setting = place.Setting((), np.array([[0.0, 5.0, 0.0, 0.0]]), (), np.zeros((0, 5)))
    assert place._have_wall(boxes, setting).tolist() == [stands]
