"""The referee on tours, ways out and room to turn."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from tests.judged_halls import NORTH, answer, box, group, hall_brief, judge, piece, tour, wall, zone

from hall_floors import figures, gap, two_zones
from scenewright.domains.hall.check.escape import walking_distance


def long_hall(*pieces, points=((0, 2.5), (19, 2.5), (20, 2.5)), groups=(), doors=None, **more):
    """A hall 20 m by 5 m, entered from the west, left to the east, with a tour along it."""
    ends = (
        {"at": [0, 2.5], "width": 2, "swing": "none"},
        {"at": [20, 2.5], "width": 2, "use": "exit"},
    )
    brief = hall_brief(box(0, 0, 20, 5), ends if doors is None else doors, **more)
    return answer(brief, pieces, (zone("all", box(0, 0, 20, 5)),), (), groups, (tour(*points),))


def test_the_tour_is_measured_again():
    """5 m between the walls, 3 m where a plinth stands 1.5 m from the line, 2 m in the doors."""
    free = figures(judge(long_hall(piece("plinth", 10, 4.5, 1, 1))))["tour"]
    assert free["least_width"] == pytest.approx(2.0)
    assert free["length"] == 20
    assert (free["free"], free["from_entrance"], free["to_exit"]) == (True, True, True)
    assert free["bottlenecks"] == []
    assert figures(judge(long_hall(points=((5, 2.5), (5, 2.5001)))))["tour"]["least_width"] == 5.0


def test_the_tour_tells_where_it_is_narrow_and_between_what():
    pair = piece("plinth", 10, 4, 1, 2), piece("plinth", 10, 1, 1, 2)
    told = figures(judge(long_hall(*pair)))["tour"]
    (place,) = told["bottlenecks"]
    assert place["width"] == pytest.approx(1.0, abs=1e-3)
    assert place["at"] == [pytest.approx(10, abs=0.6), 2.5]
    assert set(place["between"]) == {p.id for p in pair}
    assert "1.00 m between plinth@10," in place["message"]
    assert told["free"]


def test_a_tour_through_a_piece_is_not_free():
    told = figures(judge(long_hall(piece("plinth", 10, 2.5, 1, 1))))["tour"]
    assert (told["free"], told["least_width"]) == (False, 0)
    astray = figures(judge(long_hall(points=((0, 2.5), (10, 9), (20, 2.5)))))["tour"]
    assert not astray["free"]
    backwards = figures(judge(long_hall(points=((20, 2.5), (0, 2.5)))))["tour"]
    assert (backwards["from_entrance"], backwards["to_exit"]) == (False, True)
    middle = figures(judge(long_hall(points=((5, 2.5), (15, 2.5)))))["tour"]
    assert (middle["from_entrance"], middle["to_exit"]) == (False, False)


def test_what_is_passed_and_seen():
    """One case beside the tour, one behind partitions, one shelf that shows its back."""
    beside, behind = piece("case", 5, 4.5, 0.5, 0.5), piece("case", 10, 4.6, 0.5, 0.5)
    turned_away = piece("shelf", 15, 4.5, 1, 0.5, heading=NORTH)
    screens = wall(9, 4.1, 11, 4.1), wall(9, 4.1, 9, 5), wall(11, 4.1, 11, 5)
    cases = beside, behind, turned_away
    groups = tuple(group(f"h/{k}", "all", case) for k, case in enumerate(cases))
    told = figures(judge(long_hall(*cases, *screens, groups=groups)))["tour"]
    assert told["traversal"] == told["seen"] == pytest.approx(1 / 3, abs=1e-4)
    assert told["groups_missed"] == ["h/1", "h/2"]
    assert told["unseen"] == [behind.id, turned_away.id]
    low = tuple(replace(s, size=s.size._replace(height=1.2)) for s in screens)
    assert figures(judge(long_hall(*cases, *low, groups=groups)))["tour"]["seen"] < 0.4
    low = tuple(replace(s, category="plinth", size=s.size._replace(height=1.2)) for s in screens)
    assert figures(judge(long_hall(*cases, *low, groups=groups)))["tour"]["seen"] > 0.6
    far = ((0, 2.5), (1.6, 2.5))
    told = figures(judge(long_hall(*cases[:1], groups=groups[:1], points=far)))["tour"]
    assert (told["traversal"], told["seen"]) == (0.0, 1.0)


def test_the_way_out_is_walked_not_flown():
    """From behind a partition across all but 1 m of a hall, round its end."""
    only = ({"at": [0, 1], "width": 1.6, "swing": "none"},)
    straight = figures(judge(long_hall(doors=only)))["escape"]
    corner = math.hypot(20 - 0.2, 5 - 0.2 - 1)
    assert straight["distance"] == pytest.approx(corner, rel=0.035)
    assert straight["distance"] > corner - 0.5
    around = figures(judge(long_hall(wall(10, 0, 10, 4), doors=only)))["escape"]
    bent = math.hypot(10 - 0.1, 4.2 - 1) + 0.2 + math.hypot(9.7, 4)
    assert around["distance"] == pytest.approx(bent, rel=0.04)


def test_nobody_walks_through_a_wall_one_cell_thick():
    free = np.ones((6, 9), bool)
    free[:, 4] = False
    start = np.where((np.arange(9) == 0)[None] & free, 0.0, np.inf)
    assert np.isinf(walking_distance(free, start, 1.0)[:, 5:]).all()
    corner = np.eye(2, dtype=bool)
    from_one = np.array([[0.0, np.inf], [np.inf, np.inf]])
    assert np.isinf(walking_distance(corner, from_one, 1.0)[1, 1])


def test_ways_out_are_notes():
    crowd = judge(long_hall(doors=({"at": [0, 2.5], "width": 1.0},), people=250))
    assert crowd.valid
    assert [note.function for note in crowd.notes] == ["narrow_exits", "narrow_exits"]
    assert figures(crowd)["escape"]["exit_width_needed"] == 1.25
    far = hall_brief(box(0, 0, 60, 5), ({"at": [0, 2.5], "width": 1.0},), people=40)
    report = judge(answer(far))
    assert [note.function for note in report.notes] == ["long_escape"]
    assert figures(report)["escape"]["distance"] == pytest.approx(60, abs=1.5)


def test_a_wheelchair_turns_where_a_circle_can_be_rolled_into():
    """West is open; east is a closet 0.7 m deep; behind a gap of 0.8 m nobody comes at all."""
    free = figures(judge(two_zones()))
    assert free["turning"] == {"west": True, "east": True}
    narrow = judge(two_zones(piece("plinth", 9.35, 3, 5.3, 6), width=1.0))
    assert figures(narrow)["turning"] == {"west": True, "east": False}
    assert figures(judge(two_zones(*gap(0.8), width=0.7)))["turning"] == {
        "west": True,
        "east": False,
    }
    assert figures(judge(two_zones(*gap(1.0), width=0.7)))["turning"] == {
        "west": True,
        "east": True,
    }
