"""In which forms a group that stands too near to others may stand instead."""

from __future__ import annotations

from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.forms import list_further
from scenewright.domains.home.composing.spacing import move


def test_a_stand_may_be_narrower_without_its_plant_but_never_without_its_screen():
    stands = {round(case.width, 1): case for case in cases("media").groups}
    assert [move._holds(stands[w], stands[2.2]) for w in (1.8, 2.0, 1.6)] == [True, True, False]
    bare = stands[1.8]._replace(members=stands[1.8].members[:1])
    assert not move._holds(bare, stands[2.2])


def test_chairs_may_go_to_other_sides_of_a_table_but_none_is_lost():
    tables = {(case.name, case.depth): case for case in cases("dining_wall").groups}
    front, ends = tables["1.0 m wall table for 2", 1.15], tables["1.0 m wall table for 2", 0.65]
    assert ends.width > front.width
    assert move._holds(ends, front)
    assert not move._holds(tables["1.0 m wall table for 3", 1.15], front)
    assert not move._holds(tables["0.9 m wall table for 1", 1.1], front)
    assert move._holds(tables["0.9 m wall table for 1", 1.1], front, 1)
    assert not move._holds(front, front, 1)


def test_a_shoe_cabinet_may_be_half_as_wide_for_the_doors_of_it_to_open():
    shoes = {round(case.width, 1): case for case in cases("shoes").groups}
    widest = max(shoes)
    assert move._holds(shoes[min(w for w in shoes if w >= widest / 2)], shoes[widest])
    wardrobes = {round(case.width, 1): case for case in cases("wardrobe").groups}
    assert not move._holds(wardrobes[0.6], wardrobes[1.0])


def test_a_sofa_may_lose_its_corner_but_nothing_else():
    forms = [*cases("seating").groups, *list_further("seating")]
    corner = next(f for f in forms if "corner_sofa" in {m.category for m in f.members})
    straight = [
        f
        for f in forms
        if move._straighten(corner) == move._list_kinds(f) and 0.75 * corner.width < f.width
    ]
    assert straight
    for form in straight:
        assert move._holds(form, corner, 1) == (form.width <= corner.width)
        assert not move._holds(form, corner)
