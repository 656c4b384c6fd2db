"""Bedrooms composed: clothes in the closet, double beds past which one can walk."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import check
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.bed_places import are_adrift
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.placed_faults import cost_of_group
from scenewright.domains.home.composing.places.forms import cost_of_case, list_further
from scenewright.domains.home.furnishing.furnish import FurnishedPatch
from scenewright.domains.home.furnishing.window_dressing import dress_windows
from scenewright.domains.home.grounds.closets import has_closet
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.rules.weigh_home import sum_rows
from scenewright.domains.home.solving import solve
from scenewright.geometry.flanks import measure_flank_gaps

RULE = PRESETS["default"].settings.composing
CASE = next(c for c in cases("single").groups if len(c.members) == 1)
SLEEPS = {
    "id": "bed",
    "function": "bedroom",
    "outline": [[0, 0], [2.4, 0], [2.4, 2.4], [0, 2.4]],
    "doors": [
        {"at": [1.2, 2.4], "width": 1.6, "to": "closet", "swing": "slide"},
        {"at": [0.0, 1.2], "width": 1.0, "swing": "slide"},
        {"at": [2.4, 1.4], "width": 1.6, "swing": "slide"},
    ],
    "windows": [{"at": [1.2, 0.0], "width": 1.8}],
}
ENTERED = {
    "id": "a",
    "function": "bedroom",
    "outline": [[0, 0], [4, 0], [4, 3], [0, 3]],
    "doors": [{"at": [3.0, 0.0], "width": 0.9, "swing": "out"}],
}
CLOSET = {
    "id": "closet",
    "function": "storage",
    "outline": [[0, 2.5], [2.4, 2.5], [2.4, 3.3], [0, 3.3]],
}


def furnish(closet):
    rooms = [SLEEPS, CLOSET | closet]
    brief = Brief(rooms=[Room.model_validate(room) for room in rooms])
    return brief, solve(brief, seed=0, threads=1)


def held(solution):
    return {p.category: p.size.width for p in solution.pieces if p.space == "bed"}


def test_clothes_hang_in_the_closet_where_half_a_wardrobe_would_stand():
    _, solution = furnish({})
    there = held(solution)
    assert check(solution).valid
    assert "wardrobe" not in there
    assert there["chest_of_drawers"] >= 0.6
    (out,) = [out for out in solution.left_out if out.what == "wardrobe"]
    assert "closet" in out.reason
    assert not out.required


def test_a_closet_that_is_entered_from_elsewhere_too_is_nobodys():
    own, _ = furnish({})
    other, solution = furnish({"doors": [{"at": [1.2, 3.3], "width": 0.8}]})
    assert [has_closet(spaces(b)[0], spaces(b)) for b in (own, other)] == [True, False]
    assert "wardrobe" in held(solution)


def test_a_bed_for_two_in_a_narrow_room_has_two_sides_and_a_way_past_its_foot():
    room = {
        "function": "double_bedroom",
        "outline": [[0, 0], [2.6, 0], [2.6, 3.5], [0, 3.5]],
        "doors": [
            {"at": [0.5, 0.0], "width": 0.8, "swing": "out"},
            {"at": [0.5, 3.5], "width": 0.8, "swing": "out"},
        ],
    }
    solution = solve(Brief(rooms=[Room.model_validate(room)]), seed=0, threads=1)
    assert check(solution).valid
    beds = [p for p in solution.pieces if p.category == "double_bed"]
    assert len(beds) == 1
    assert sum(p.category == "nightstand" for p in solution.pieces) == 2


@pytest.mark.parametrize("case", [*cases("sleeping").groups, *list_further("sleeping")])
def test_faults_of_beds_for_two_are_those_of_their_sides_and_length(case):
    bed = next(m for m in case.members if m.category == "double_bed")
    left, right = (case.width / 2 + sign * bed.x - bed.size.width / 2 for sign in (1, -1))
    faults = dict(find_case_faults(case))
    assert ("one_side" in faults) == (min(left, right) < 0.449)
    assert ("short_bed" in faults) == (bed.size.depth < 2.0)
    stands = [m for m in case.members if m.category == "nightstand"]
    for stand in stands:
        assert abs(stand.x) + stand.size.width / 2 <= case.width / 2 + 1e-9
        beside = abs(stand.x - bed.x) - (stand.size.width + bed.size.width) / 2
        assert beside >= -1e-9
    assert np.isclose(bed.y - bed.size.depth / 2, -case.depth / 2)


def test_a_bed_in_the_entrance_costs_more_the_nearer_it_is_to_where_the_door_opens():
    brief = Brief(rooms=[Room.model_validate(ENTERED)])
    (space,) = spaces(brief)
    ground = ground_of(space, (), 12.0)
    end = ground.keep_free[:, 1].max() + ground.keep_free[:, 4].max() / 2
    rule = RULE._replace(costs=RULE.costs._replace(head_off=0.0))
    far, near, tight = (
        cost_of_group(_bed_at(1.0 + end + gap), ground, rule) for gap in (0.31, 0.2, 0.1)
    )
    assert far < near < tight <= far + RULE.costs.at_door
    small = ground._replace(area=6.0)
    assert cost_of_group(_bed_at(1.0 + end), small, rule) == cost_of_case(CASE, 6.0, rule)


def test_what_stands_before_the_doors_of_a_built_in_wardrobe_counts():
    wardrobe = Piece("w", "wardrobe", "", "a", Pose(0.0, 0.0, 0.0, 0.0), Size(2.0, 0.6, 2.2))
    before, beside = (Piece("b", "bed", "", "a", Pose(x, 0, 0, 0), Size(1, 1, 0.5)) for x in (1, 3))
    for bed, cost in ((before, True), (beside, False)):
        group = _bed_at(0.0)._replace(pieces=(bed,))
        assert (sum_rows(("doors",), (group,), None, (wardrobe,)) > 0.0) == cost
        assert sum_rows(("doors",), (group,)) == 0.0


def _bed_at(y):
    """A single bed along the wall on the right, its foot at ``y`` - 1."""
    piece = Piece("b", "single_bed", "", "a", Pose(3.0, y, 0.0, -np.pi / 2), Size(2.0, 2.0, 0.9))
    box = np.array([3.0, y, -np.pi / 2, CASE.width, CASE.depth])
    return FurnishedGroup(
        Wish("single", 0), "single", FurnishedPatch(CASE, box, (True,), 0), (piece,)
    )


def find_darkness(desk, ground):
    return sum_rows(("dark",), (_bed_at(0.0)._replace(pieces=(desk,)),), ground)


def test_a_desk_away_from_the_window_costs_the_more_the_farther_it_is():
    ground = _lit_ground(ENTERED | {"windows": [{"at": [2.0, 3.0], "width": 1.0}]})
    near, middle, far = (_desk_at(2.0, y) for y in (2.5, 1.4, 0.3))
    assert find_darkness(near, ground) == 0.0
    assert 0.0 < find_darkness(middle, ground) < find_darkness(far, ground) == 1.0
    assert find_darkness(_desk_at(0.3, 2.7), ground) == pytest.approx(
        (1.2366 - 1.05) / 1.05, abs=0.01
    )
    assert find_darkness(far, _lit_ground(ENTERED)) == 0.0
    group = _bed_at(0.0)._replace(pieces=(far,))
    lit = group._replace(pieces=(near,))
    costs = [cost_of_group(g, ground, RULE) for g in (group, lit)]
    assert costs[0] - costs[1] == pytest.approx(RULE.costs.dark)


def _lit_ground(room):
    brief = Brief(rooms=[Room.model_validate(room)])
    return ground_of(spaces(brief)[0], (), 12.0)


def _desk_at(x, y):
    return Piece("d", "desk", "", "a", Pose(x, y, 0.0, 0.0), Size(1.0, 0.6, 0.75))


def test_a_bed_half_past_the_end_of_a_wall_is_adrift():
    walls = np.array([[0.0, 0.0, 4.0, 0.0], [4.0, 0.0, 4.0, 1.4], [4.0, 1.4, 5.0, 1.4]])
    along = np.array([[3.5, 1.0, np.pi / 2, 1.0, 2.0]])
    past = np.array([[3.5, 1.5, np.pi / 2, 1.0, 2.0]])
    whole = np.array([[4.0, 0.0, 4.0, 4.0]])
    assert measure_flank_gaps(along, whole).min() == pytest.approx(0.0)
    assert measure_flank_gaps(along, walls).min() > 0.12
    assert [bool(are_adrift(CASE, b, w)[0]) for b, w in ((past, walls), (past, whole))] == [
        True,
        False,
    ]


def test_a_blind_hangs_where_a_curtain_would_lie_on_a_desk():
    room = ENTERED | {"windows": [{"at": [2.0, 3.0], "width": 1.4}]}
    brief = Brief(rooms=[Room.model_validate(room)])
    (space,) = spaces(brief)
    ground, catalog = ground_of(space, (), 12.0), catalog_of(())
    desk = Piece("d", "desk", "", "a", Pose(2.0, 2.7, 0.0, -np.pi / 2), Size(1.2, 0.6, 0.75))
    low = replace(desk, size=desk.size._replace(height=0.45))
    away = replace(desk, pose=desk.pose._replace(y=1.0))
    for piece, hung in ((desk, "blind"), (low, "curtain"), (away, "curtain")):
        (found,) = dress_windows(space, ground, (piece,), catalog)
        assert found.category == hung
