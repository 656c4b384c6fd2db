"""What stands in slanted corners of halls, and small objects that people get to."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from tests.hall_briefs import answer, hall

from scenewright.core.layout import corners
from scenewright.domains import check
from scenewright.domains.hall.borders import WallStretch
from scenewright.domains.hall.wall_corners import corner_share


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


def test_no_small_object_stands_where_nobody_gets():
    """Two showcases shut off a corner of a small hall; no tree is put there."""
    fixed = [
        {"category": "showcase", "at": [4.5, 4.35], "size": [0.4, 1.3, 2.0]},
        {"category": "showcase", "at": [5.35, 3.5], "size": [1.3, 0.4, 2.0]},
    ]
    room = hall(
        outline=[[0, 0], [6, 0], [6, 5], [0, 5]],
        doors=[{"id": "main", "at": [3, 0], "width": 1.2, "use": "entrance"}],
        fixed=fixed,
        demands=[{"category": "potted_tree", "count": 6, "required": False}],
    )
    found = answer(room)
    trees = [p.pose for p in found.pieces if p.category == "potted_tree"]
    assert len(trees) > 3
    assert not any(tree.x > 4.7 and tree.y > 3.7 for tree in trees)
    assert not check(found).findings
