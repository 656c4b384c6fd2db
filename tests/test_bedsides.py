"""Single beds of a finished home: each has a nightstand at its pillow wherever one stands."""

from __future__ import annotations

from math import hypot

import numpy as np
import pytest
import shapely

from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.core.piece_outlines import outline_of
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer, RoomTask
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.homewide.bedsides import add_nightstands
from scenewright.domains.home.composing.places.forms import list_further
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.furnishing.whole import Gone
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import prepare_rooms, solve

NORTH = np.pi / 2
ROOM = {
    "id": "bed",
    "function": "single_bedroom",
    "outline": [[0, 0], [3, 0], [3, 3], [0, 3]],
    "doors": [{"at": [2.4, 3.0], "width": 0.8, "swing": "out"}],
}


def _task(**more) -> RoomTask:
    brief = Brief(rooms=[Room.model_validate(ROOM | more)])
    preset = PRESETS["default"]
    return prepare_rooms(brief, spaces(brief), catalog_of(()), preset, preset.solver, 0)[0][0]


def _stand(task: RoomTask, name: str, at, heading: float, fits) -> FurnishedGroup:
    """A group in the first of its forms that ``fits``, the middle of its back ``at`` a point."""
    case = next(c for c in (*cases(name).groups, *list_further(name)) if fits(c))
    group = make_unplaced(task, (), Wish(name, 0), case)
    middle = np.array(at) + case.depth / 2 * np.array([np.cos(heading), np.sin(heading)])
    box = np.array([*middle, heading, case.width, case.depth])
    dressed = dress_group(task, group, case, box, standing_of((), flat_kinds(task.catalog)))
    assert dressed is not None
    return dressed


def _bed(task: RoomTask, x: float) -> FurnishedGroup:
    """A bed without a nightstand, its head at the wall in the south."""
    return _stand(task, "single", (x, 0.0), NORTH, lambda c: c.width == 0.8)


def _answer(*placed: FurnishedGroup) -> RoomAnswer:
    return RoomAnswer(0.0, placed, (), (), None, 0.0, 0)


def _stands(answer: RoomAnswer) -> list:
    return [p for group in answer.placed for p in group.pieces if p.category == "nightstand"]


def test_bed_in_a_corner_has_its_nightstand_on_the_free_side():
    task = _task()
    bed = _bed(task, 0.4)
    (answer,) = add_nightstands([task], [_answer(bed)], list)
    (stand,) = _stands(answer)
    shapes = [shapely.Polygon(outline_of(p)) for p in (answer.placed[0].pieces[0], stand)]
    assert answer.placed[0].pieces[0].pose == bed.pieces[0].pose
    assert shapes[0].intersection(shapes[1]).area < 1e-9
    assert shapes[0].distance(shapes[1]) < 0.05
    assert stand.pose.x > 0.8
    assert shapely.LineString([(0, 0), (3, 0)]).distance(shapes[1]) < 0.05
    assert [p.category for p in answer.placed[0].pieces][-1] == "table_lamp"


def test_nightstand_stands_beside_the_pillow_of_a_bed_along_the_wall():
    task = _task()
    along = next(
        c
        for c in list_further("single")
        if c.members[0].heading > 0 and len(c.members) == 1 and c.members[0].size.depth < 1.95
    )
    bed = _stand(task, "single", (1.5, 0.0), NORTH, lambda c: c is along)
    (answer,) = add_nightstands([task], [_answer(bed)], list)
    (stand,) = _stands(answer)
    pose, size = bed.pieces[0].pose, bed.pieces[0].size
    ahead = (stand.pose.x - pose.x) * np.cos(pose.heading)
    ahead += (stand.pose.y - pose.y) * np.sin(pose.heading)
    assert -size.depth / 2 < ahead < -size.depth / 4
    assert stand.pose.y > size.width
    assert np.cos(stand.pose.heading - pose.heading) == pytest.approx(1.0)


def test_bed_between_walls_has_none():
    task = _task(outline=[[0, 0], [0.86, 0], [0.86, 2], [3, 2], [3, 3], [0, 3]])
    before = _answer(_bed(task, 0.41))
    assert add_nightstands([task], [before], list) == [before]


def test_smaller_nightstand_stands_where_a_larger_one_has_no_room():
    task = _task(outline=[[0, 0], [1.16, 0], [1.16, 2], [3, 2], [3, 3], [0, 3]])
    (answer,) = add_nightstands([task], [_answer(_bed(task, 0.41))], list)
    assert [p.size.width for p in _stands(answer)] == [0.3]


def test_nothing_stands_before_the_doors_of_a_wardrobe():
    task = _task()
    bed = _bed(task, 1.45)
    wardrobe = _stand(task, "wardrobe", (0.0, 0.9), 0.0, lambda c: c.width == 1.8)
    (stand,) = _stands(add_nightstands([task], [_answer(bed, wardrobe)], list)[0])
    assert stand.pose.x > bed.pieces[0].pose.x
    (alone,) = _stands(add_nightstands([task], [_answer(bed)], list)[0])
    assert alone.pose.x < bed.pieces[0].pose.x


def test_nightstand_that_bars_a_way_is_left_out():
    task = _task()

    def opened(answers):
        """The home without what holds a nightstand."""
        return [a._replace(gone=(Gone("nightstand", "barred"),) * len(_stands(a))) for a in answers]

    before = _answer(_bed(task, 0.4))
    assert add_nightstands([task], [before], opened) == [before]


def test_nightstand_that_gave_way_is_no_longer_listed_once_another_stands():
    task = _task()
    before = _answer(_bed(task, 0.4))._replace(gone=(Gone("nightstand", "barred"),))
    (answer,) = add_nightstands([task], [before], list)
    assert _stands(answer)
    assert answer.gone == ()


def test_none_where_nightstands_are_forbidden_or_the_bed_is_to_take_no_more_room():
    task = _task(wishes=[{"what": "nightstand", "forbid": True}])
    before = _answer(_bed(task, 0.4))
    assert add_nightstands([task], [before], list) == [before]
    bed = _bed(task := _task(), 0.4)
    bounded = _answer(bed._replace(wish=bed.wish._replace(most=(0.8, 1.93))))
    assert add_nightstands([task], [bounded], list) == [bounded]


def test_bed_of_a_list_has_a_nightstand_which_is_part_of_its_group():
    task = _task(ask=[{"group": "single"}])
    (answer,) = add_nightstands([task], [_answer(_bed(task, 0.4))], list)
    assert len(_stands(answer)) == 1


def test_bed_with_a_nightstand_gets_no_second_one():
    task = _task()
    (answer,) = add_nightstands([task], [_answer(_bed(task, 1.5))], list)
    assert len(_stands(answer)) == 1
    assert add_nightstands([task], [answer], list) == [answer]


def test_beds_side_by_side_share_the_nightstand_between_them():
    task = _task()
    beds = _bed(task, 0.41), _bed(task, 1.68)
    (answer,) = add_nightstands([task], [_answer(*beds)], list)
    (stand,) = _stands(answer)
    assert 0.8 < stand.pose.x < 1.28


def test_every_single_bed_of_a_roomy_home_has_a_nightstand():
    room = ROOM | {"windows": [{"at": [3.0, 1.5], "width": 1.0}]}
    home = solve(Brief(rooms=[Room.model_validate(room)]), seed=0, threads=1)
    beds = [p for p in home.pieces if p.category == "single_bed"]
    stands = [p for p in home.pieces if p.category == "nightstand"]
    assert beds
    for bed in beds:
        assert any(hypot(s.pose.x - bed.pose.x, s.pose.y - bed.pose.y) < 1.6 for s in stands)
