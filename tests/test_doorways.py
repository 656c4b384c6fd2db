"""Wide doors: pieces before one when its home is done, and what they give way to."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from benchmarks.composition_faults import strip_before
from benchmarks.plans_r2v import adapt, raw_plans
from benchmarks.rescaled_r2v import rescale

import scenewright as sw
from scenewright.building.door_approach import gates
from scenewright.building.plan import spaces
from scenewright.catalog.classes import RUN
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.core.piece_outlines import outline_of
from scenewright.domains.home.attempts.attempt import Missing, RoomAnswer, find_blocked
from scenewright.domains.home.attempts.second_try import sum_lacks
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.case_faults import is_hung
from scenewright.domains.home.composing.filling.widening import widen_groups
from scenewright.domains.home.composing.mend_rooms import mend_rooms
from scenewright.domains.home.composing.placed_faults import (
    cost_of_group,
    cost_of_openings,
    measure_before_doors,
    measure_hung_over_doors,
)
from scenewright.domains.home.composing.places.forms import cost_of_case, list_further
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced
from scenewright.domains.home.composing.seats.unseen import WALL_LESS, leave_out_unseen_screen
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.rules.every import FIRMNESS
from scenewright.domains.home.settings import FaultCosts
from scenewright.domains.home.solving import prepare_rooms

NORTH = np.pi / 2
ROOM = {
    "id": "bed",
    "function": "bedroom",
    "outline": [[0, 0], [3, 0], [3, 2.6], [0, 2.6]],
    "doors": [
        {"at": [1.5, 2.6], "width": 1.8, "to": "closet", "swing": "slide"},
        {"at": [0.6, 0.0], "width": 0.8, "swing": "out"},
    ],
}
CLOSET = {
    "id": "closet",
    "function": "storage",
    "outline": [[0.4, 2.7], [2.6, 2.7], [2.6, 3.5], [0.4, 3.5]],
}


def task_of(room, *others):
    brief = Brief(rooms=[Room.model_validate(r) for r in (room, *others)])
    preset, rooms = PRESETS["default"], spaces(brief)
    return prepare_rooms(brief, rooms, catalog_of(()), preset, preset.solver, 0)[0][0]


def stand(task, name, x, y, heading, fits, **more):
    """A group in the first of its forms that ``fits``, its back at x, y."""
    case = next(c for c in (*cases(name).groups, *list_further(name)) if fits(c))
    group = make_unplaced(task, (), Wish(name, 0, **more), case)
    middle = np.array([x, y]) + case.depth / 2 * np.array([np.cos(heading), np.sin(heading)])
    box = np.array([*middle, heading, case.width, case.depth])
    empty = standing_of((), flat_kinds(task.catalog))
    dressed = dress_group(task, group, case, box, empty)
    assert dressed is not None
    return dressed


def answer_of(*placed):
    return RoomAnswer(0.0, placed, (), (), None, 0.0, 0)


def clear(task, *placed, opened=list):
    (answer,) = mend_rooms([task], [answer_of(*placed)], opened)
    return answer


def chest_in_doorway(task):
    """A chest a step from the left wall whose front stands 0.05 m before the sliding door."""
    return stand(task, "chest", 0.2, 2.3, 0.0, lambda c: c.width == 0.6)


def test_metres_before_doors_are_those_of_the_polygons():
    task = task_of(ROOM, CLOSET)
    (gate,) = (g for g in gates(task.space) if g.opening.width > 1.2)
    x, y = gate.face
    strip = shapely.box(x - 0.9, y - 0.3, x + 0.9, y)
    for left, most in ((0.0, 0.0), (0.2, 0.06), (0.4, 0.3)):
        chest = stand(task, "chest", left, 2.3, 0.0, lambda c: c.width == 0.6)
        shapes = [shapely.Polygon(outline_of(p)) for p in chest.pieces if p.pose.z < 0.1]
        area = shapely.union_all(shapes).intersection(strip).area
        metres = area / 0.3 if area / 0.3 > 0.02 else 0.0
        assert measure_before_doors(chest, task.ground) == pytest.approx(metres, abs=1e-6)
        assert 0.8 * most <= metres <= most


def test_a_chest_at_the_jamb_moves_along_its_wall_and_keeps_its_width():
    task = task_of(ROOM, CLOSET)
    chest = chest_in_doorway(task)
    assert measure_before_doors(chest, task.ground) > 0.02
    (moved,) = clear(task, chest).placed
    assert measure_before_doors(moved, task.ground) == 0.0
    assert moved.dressed.case.width >= chest.dressed.case.width - 1e-9
    assert not find_blocked(task, (moved,))


def test_nothing_moves_that_the_home_has_no_way_for_or_that_stands_free():
    task = task_of(ROOM, CLOSET)
    chest = chest_in_doorway(task)
    lost = answer_of()._replace(missing=(Missing(chest.wish, ""),))
    assert clear(task, chest, opened=lambda _: [lost]).placed == (chest,)
    free = stand(task, "chest", 3.0, 1.0, np.pi, lambda c: c.width == 0.6)
    assert clear(task, free).placed == (free,)


def test_a_plant_with_no_other_place_is_left_out_unless_it_was_asked_for():
    task = task_of(ROOM, CLOSET)
    tree = stand(task, "plant", 0.65, 2.6, -NORTH, lambda c: c.width < 0.6)
    spare, asked = (tree._replace(wish=Wish("plant", 2, required=r)) for r in (False, True))
    assert measure_before_doors(spare, task.ground) > 0.02
    lost = answer_of()._replace(missing=(Missing(tree.wish, ""),))
    answer = clear(task, spare, opened=lambda _: [lost])
    assert not answer.placed
    assert [m.wish for m in answer.missing] == [spare.wish]
    assert clear(task, asked, opened=lambda _: [lost]).placed == (asked,)
    (moved,) = clear(task, spare).placed
    assert measure_before_doors(moved, task.ground) == 0.0


def test_a_bed_is_turned_along_the_wall_and_hardly_smaller():
    low = ROOM | {"outline": [[0, 0], [3, 0], [3, 2.1], [0, 2.1]]}
    low["doors"] = [ROOM["doors"][0] | {"at": [1.5, 2.1]}, ROOM["doors"][1]]
    task = task_of(low, CLOSET | {"outline": [[0.4, 2.2], [2.6, 2.2], [2.6, 3], [0.4, 3]]})
    bed = stand(task, "single", 2.6, 0.0, NORTH, lambda c: c.width == 0.8)
    assert measure_before_doors(bed, task.ground) > 0.02
    (moved,) = clear(task, bed).placed
    size = next(p.size for p in moved.pieces if p.category == "single_bed")
    assert measure_before_doors(moved, task.ground) == 0.0
    assert size.width >= 0.75 - 1e-9
    assert size.depth >= 1.8 - 1e-9


def test_a_wardrobe_before_the_closet_gives_way_to_a_chest():
    """The bed leaves no other wall for a metre of wardrobe."""
    tight = ROOM | {"outline": [[0, 0], [2.4, 0], [2.4, 2.6], [0, 2.6]]}
    tight["doors"] = [
        ROOM["doors"][0] | {"at": [1.2, 2.6], "width": 2.0},
        {"at": [0.6, 0.0], "width": 0.8, "swing": "out"},
        {"at": [0.0, 1.1], "width": 0.8, "swing": "slide"},
    ]
    task = task_of(tight, CLOSET | {"outline": [[0.2, 2.7], [2.2, 2.7], [2.2, 3.5], [0.2, 3.5]]})
    assert task.closet
    bed = stand(task, "single", 2.0, 0.0, NORTH, lambda c: c.width == 0.8)
    wardrobe = stand(task, "wardrobe", 0.0, 2.1, 0.0, lambda c: c.width == 1.0)
    answer = clear(task, bed, wardrobe)
    assert [p.wish.group for p in answer.placed] == ["single", "chest"]
    assert all(measure_before_doors(p, task.ground) == 0.0 for p in answer.placed[1:])
    (out,) = answer.missing
    assert out.replaced
    asked = wardrobe._replace(wish=Wish("wardrobe", 0, required=True))
    assert "chest" not in [p.wish.group for p in clear(task, bed, asked).placed]
    alone = task._replace(closet=False)
    assert "chest" not in [p.wish.group for p in clear(alone, bed, wardrobe).placed]


def test_what_something_else_stands_for_is_not_lacking():
    costs, lack = FaultCosts(), Missing(Wish("wardrobe", 2), "")
    bare, hung = (answer_of()._replace(missing=(m,)) for m in (lack, lack._replace(replaced=True)))
    assert sum_lacks([bare], costs) == costs.missing[2]
    assert sum_lacks([hung], costs) == 0.0


def test_a_chest_of_a_bedroom_is_as_wide_as_its_stretch_of_wall():
    task = task_of(ROOM, CLOSET)
    chest = stand(task, "chest", 3.0, 1.0, np.pi, lambda c: c.width == 0.6)
    (grown,) = widen_groups(task, answer_of(chest), frozenset()).placed
    assert grown.dressed.case.width == pytest.approx(1.0)
    assert measure_before_doors(grown, task.ground) == 0.0


def test_a_screen_on_the_wall_over_a_door_is_left_out_by_name():
    """The door takes the wall from x = 0.6 to 2.4; the shelf is 0.9 m wide."""
    task = task_of({**ROOM, "function": "living"}, CLOSET)
    for middle, over in ((0.45, 0.3), (0.5, 0.35)):
        media = stand(task, "media", middle, 2.6, -NORTH, lambda c: c.width == 0.9 and is_hung(c))
        assert measure_hung_over_doors(media, task.ground) == pytest.approx(over, abs=1e-6)
        answer = leave_out_unseen_screen(task, answer_of(media))
        assert media not in answer.placed
        assert [(m.wish.group, m.reason) for m in answer.missing] == [("media", WALL_LESS)]
    asked = stand(
        task, "media", 0.5, 2.6, -NORTH, lambda c: c.width == 0.9 and is_hung(c), required=True
    )
    assert leave_out_unseen_screen(task, answer_of(asked)).placed == (asked,)


@pytest.mark.parametrize("name", ["chest", "wardrobe"])
def test_what_is_tall_before_a_wide_door_costs_more(name):
    """At the same distance from it; measured for one group as for many places at once."""
    task = task_of(ROOM, CLOSET)
    rule = task.preset.settings.composing
    group = stand(task, name, 0.3, 2.1, 0.0, lambda c: c.width == 1.0)
    metres = min(measure_before_doors(group, task.ground), 1.0)
    tall = FIRMNESS.get("wardrobe", 1.0) if name == "wardrobe" else 1.0
    found = cost_of_openings(group.dressed.case, group.dressed.box[None], task.ground, rule)
    assert metres > 0.1
    assert tall == 1.0 or tall > 2.0
    assert found[0] == pytest.approx(rule.costs.opening * tall * (1.0 + metres) / 2)
    more = cost_of_group(group, task.ground, rule) - cost_of_case(
        group.dressed.case, task.ground.area, rule
    )
    assert more == pytest.approx(found[0])


@pytest.mark.realdata(quick=True)
def test_a_kitchen_that_ends_before_a_wide_door_is_made_anew(real_data):
    """Its last drawers stood 0.6 m before the sliding door of a bedroom."""
    brief = adapt(rescale(raw_plans()[299])).brief
    home = sw.solve(brief, seed=401, threads=1)
    doors = [
        strip_before(gate, 0.3)
        for space in spaces(brief)
        for gate in gates(space)
        if gate.opening.kind == "door" and not gate.opening.hinge and gate.opening.width > 1.2
    ]
    run = [shapely.Polygon(outline_of(p)) for p in home.pieces if p.category in RUN]
    assert len(run) >= 4
    assert max(unit.intersection(door).area / 0.3 for unit in run for door in doors) < 0.1
