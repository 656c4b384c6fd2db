"""A bed and a wardrobe placed together: against slow references, and in rooms that need it."""

from __future__ import annotations

from math import inf

import numpy as np
import pytest
import shapely

from rooms import full_problem
from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece, Pose
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    find_blocked,
)
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.judging import judge_of, sum_faults
from scenewright.domains.home.composing.mend_rooms import mend_rooms
from scenewright.domains.home.composing.placed_faults import cost_of_group, cost_of_openings
from scenewright.domains.home.composing.places.forms import cost_of_case
from scenewright.domains.home.composing.places.moving import make_unplaced, with_margin
from scenewright.domains.home.composing.places.pairs import do_overlap, find_pair, list_pair_starts
from scenewright.domains.home.furnishing.furnish import FurnishedPatch
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import prepare_rooms

RULE = PRESETS["default"].settings.composing


def _polygon(x, y, heading, width, depth):
    return shapely.Polygon(outline_of(_piece("box", x, y, heading, width, depth)))


def _piece(category, x, y, heading, width, depth):
    from scenewright.core.scene import Size

    return Piece("p", category, "", "room", Pose(x, y, 0.0, heading), Size(width, depth, 1.0))


def test_boxes_overlap_where_their_polygons_do():
    rng = np.random.default_rng(4)
    boxes = np.column_stack(
        (rng.uniform(0, 3, (60, 2)), rng.uniform(-4, 4, 60), rng.uniform(0.3, 2, (60, 2)))
    )
    shapes = [_polygon(*box) for box in boxes]
    found, seen = do_overlap(boxes[:30], boxes[30:]), set()
    for i, one in enumerate(shapes[:30]):
        for j, other in enumerate(shapes[30:]):
            deep = one.buffer(-0.01).intersects(other)
            if deep == one.buffer(0.01).intersects(other):
                assert found[i, j] == deep
                seen.add(deep)
    assert seen == {True, False}


def test_faults_before_openings_of_many_places_are_those_of_each():
    ground = full_problem().ground
    seen = 0.0
    for function in ("single", "sleeping", "wardrobe"):
        case = cases(function).groups[-1]
        rng = np.random.default_rng(8)
        boxes = np.column_stack(
            (
                rng.uniform(*ground.bounds[[0, 2]], 80),
                rng.uniform(*ground.bounds[[1, 3]], 80),
                rng.integers(0, 4, 80) * np.pi / 2,
                np.full((80, 2), (case.width, case.depth)),
            )
        )
        for box, cost in zip(boxes, cost_of_openings(case, boxes, ground, RULE), strict=True):
            own = cost_of_case(case, ground.area, RULE)
            group = _stand(case, box)
            single = next((p for p in group.pieces if p.category == "single_bed"), None)
            wanted = cost_of_group(group, ground, RULE._replace(costs=_by_openings()))
            assert cost == pytest.approx(wanted - own, abs=1e-9), (function, single)
            seen += cost
    assert seen > 0.0


def _by_openings():
    return RULE.costs._replace(adrift=0.0, at_door=0.0, head_off=0.0)


def _stand(case, box):
    """A group with its pieces on a box, as if nothing were in the way."""
    c, s = np.cos(box[2]), np.sin(box[2])
    pieces = tuple(
        Piece(
            f"{k}",
            m.category,
            "",
            "room",
            Pose(box[0] + m.x * s + m.y * c, box[1] - m.x * c + m.y * s, m.z, box[2] + m.heading),
            m.size,
        )
        for k, m in enumerate(case.members)
    )
    wish = Wish(case.function, 0)
    return FurnishedGroup(wish, case.function, FurnishedPatch(case, box, (), 0), pieces)


@pytest.fixture(scope="module")
def narrow():
    """A room of 2.1 by 2.6 m in which a wardrobe of a metre has a place beside few beds."""
    room = {
        "id": "bedroom",
        "function": "single_bedroom",
        "outline": [[0, 0], [2.1, 0], [2.1, 2.6], [0, 2.6]],
        "doors": [{"at": [0.0, 2.1], "width": 0.8, "swing": "out"}],
        "windows": [{"at": [1.05, 0.0], "width": 0.8}],
    }
    brief = Brief(rooms=[Room.model_validate(room)])
    preset, rooms = PRESETS["default"], spaces(brief)
    (task,), _ = prepare_rooms(brief, rooms, catalog_of(()), preset, preset.solver, 5)
    pair = tuple(
        make_unplaced(task, (), Wish(name, 0), cases(name).groups[0])
        for name in ("single", "wardrobe")
    )
    return task, pair


def test_a_bed_and_a_wardrobe_of_a_metre_share_a_narrow_room(narrow):
    task, pair = narrow
    assert find_pair(pair) == pair
    assert find_pair((*pair, pair[1])) == ()
    starts = list(list_pair_starts(judge_of(task, pair), pair, frozenset(), inf))
    assert starts
    costs = [start.cost for start in starts]
    unforeseen = RULE.costs.doors + RULE.costs.bed_way  # shows once both are furnished
    assert costs == pytest.approx(sorted(costs), abs=unforeseen)
    best = min(starts, key=lambda start: sum_faults(task, start.placed))
    assert find_case_faults(best.placed[1].dressed.case) == ()
    for start in starts:
        bed, wardrobe = (shapely.Polygon(outline_of(group.pieces[0])) for group in start.placed)
        assert bed.intersection(wardrobe).area < 1e-3
        assert not find_blocked(with_margin(task), start.placed)


def test_pairs_that_cost_too_much_are_not_furnished(narrow):
    task, pair = narrow
    every = list(list_pair_starts(judge_of(task, pair), pair, frozenset(), inf))
    half = sorted(start.cost for start in every)[len(every) // 2]
    assert len(list(list_pair_starts(judge_of(task, pair), pair, frozenset(), half))) < len(every)
    assert list(list_pair_starts(judge_of(task, pair), pair, frozenset(), 0.0)) == []


@pytest.fixture(scope="module")
def finished(narrow):
    """The narrow room with its bed, and half a wardrobe where a whole one would stand."""
    task, pair = narrow
    starts = list_pair_starts(judge_of(task, pair), pair, frozenset(), inf)
    bed, wide = min(starts, key=lambda start: sum_faults(task, start.placed)).placed
    case = cases("wardrobe").groups[0]
    half = _stand(case, np.array([*wide.dressed.box[:3], case.width, case.depth]))
    return task, RoomAnswer(0.0, (bed, half), (), (), None, 0.0, 0)


def test_half_a_wardrobe_of_a_finished_home_becomes_a_whole_one(finished):
    task, answer = finished
    (mended,) = mend_rooms([task], [answer], list)
    bed, wardrobe = mended.placed
    assert wardrobe.dressed.case.width >= 0.999
    assert {name for name, _ in find_case_faults(bed.dressed.case)} <= {"narrow_bed"}
    was, now = (g.pieces[0].size for g in (answer.placed[0], bed))
    assert min(now.width - was.width, now.depth - was.depth) > -1e-9 or now.width >= 0.8
    assert not find_blocked(task, mended.placed)


def test_a_bedroom_is_mended_only_where_the_ways_of_the_home_allow_it(finished):
    task, answer = finished
    lost = answer._replace(placed=(), missing=tuple(Missing(g.wish, "") for g in answer.placed))
    assert mend_rooms([task], [answer], lambda _: [lost]) == [answer]
    asked = answer.placed[1].wish._replace(required=True)
    stated = answer._replace(placed=(answer.placed[0], answer.placed[1]._replace(wish=asked)))
    assert mend_rooms([task], [stated], list) == [stated]
