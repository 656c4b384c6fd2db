"""Rooms are composed after they are furnished: what is mended, and that nothing is paid for it."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from benchmarks import composition_kitchen

from rooms import full_problem, random_layouts
from scenewright.core.brief import Ask, Brief, Room
from scenewright.core.scene import Piece, Pose
from scenewright.domains import check
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.anew import list_starts
from scenewright.domains.home.composing.bedrooms.beds import wants_double_bed
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.compose import compose
from scenewright.domains.home.composing.modest import EXPECTED, find_shortage
from scenewright.domains.home.composing.places.forms import FURTHER, list_further
from scenewright.domains.home.composing.places.moving import make_unplaced, with_margin
from scenewright.domains.home.energy import evaluate
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.groups.sleeping import along_wall
from scenewright.domains.home.needs.household import decide_household, share_out
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import prepare_rooms, solve
from scenewright.domains.home.terms.openings import FIRST
from scenewright.workflow.documents import explained_document

KITCHENS = (*cases("kitchen").groups, *cases("kitchenette").groups)
ROOMS = {
    "bedroom": {
        "function": "single_bedroom",
        "outline": [[0, 0], [2.6, 0], [2.6, 3.4], [0, 3.4]],
        "doors": [{"at": [0.0, 0.6], "width": 0.8}],
        "windows": [{"at": [1.3, 3.4], "width": 1.4}],
    },
    "kitchen": {
        "function": "kitchen",
        "outline": [[0, 0], [2.6, 0], [2.6, 2.6], [0, 2.6]],
        "doors": [{"at": [0.7, 0.0], "width": 0.8}],
        "windows": [{"at": [1.3, 2.6], "width": 1.0, "sill": 1.0}],
    },
    "closet": {
        "function": "storage",
        "outline": [[0, 0], [2.0, 0], [2.0, 1.0], [0, 1.0]],
        "doors": [{"at": [1.0, 0.0], "width": 0.8, "swing": "out"}],
    },
}


def pieces_of(case):
    """The members of a case as pieces of a kitchen whose front looks along +y."""
    return [
        Piece(f"{k}", m.category, "", "room", Pose(m.x, m.y, m.z, m.heading + np.pi / 2), m.size)
        for k, m in enumerate(case.members)
    ]


@pytest.mark.parametrize("case", KITCHENS, ids=lambda case: case.name)
def test_faults_of_runs_are_those_the_benchmark_counts(case):
    found = {name for name, _ in find_case_faults(case)}
    counted = {
        "worktop": composition_kitchen.short_worktop,
        "hob_at_sink": composition_kitchen.hob_at_sink,
        "hob_at_end": composition_kitchen.hob_at_end,
    }
    assert {name for name, fault in counted.items() if fault(pieces_of(case))} <= found


def test_beds_along_the_wall_have_their_pillow_by_the_nightstand():
    for case in along_wall():
        bed = next(m for m in case.members if m.category == "single_bed")
        for stand in (m for m in case.members if m.category == "nightstand"):
            head = np.sin(bed.heading) * bed.size.depth / 2
            assert stand.x + np.sin(stand.heading) * stand.size.depth / 2 == pytest.approx(head)
            assert stand.y - stand.size.width / 2 > bed.y + bed.size.width / 2
        assert bed.y - bed.size.width / 2 >= -case.depth / 2


@pytest.mark.parametrize(("term", "kind"), [("daylight_kept", 1.0), ("openings_kept", 0.0)])
def test_width_covered_of_openings_is_what_shapely_finds(term, kind):
    problem = full_problem()._replace(weights={term: 1.0})
    (strip,) = (row for row in problem.ground.strips if row[5] == kind)
    minds = problem.items.shades if kind else np.ones(4)
    seen = 0.0
    for layout in random_layouts(problem, 200):
        metres = [_polygon(*box).intersection(_polygon(*strip[:5])).area / 0.3 for box in layout]
        wanted = sum(m * (w + min(w, FIRST) / FIRST) for m, w in zip(minds, metres, strict=True))
        assert evaluate(problem, layout[None])[0] == pytest.approx(wanted, abs=1e-9)
        seen += wanted
    assert seen > 0.0


def _polygon(x, y, heading, w, d):
    box = shapely.box(-d / 2, -w / 2, d / 2, w / 2)
    return shapely.affinity.translate(
        shapely.affinity.rotate(box, heading, origin=(0, 0), use_radians=True), x, y
    )


@pytest.fixture(scope="module", params=ROOMS)
def composed(request):
    brief = Brief(rooms=[Room.model_validate({"id": request.param, **ROOMS[request.param]})])
    return request.param, brief, solve(brief, seed=1, steps=2000)


def test_rooms_that_can_be_are_well_composed(composed):
    name, _, solution = composed
    assert check(solution).valid
    wide = {p.category: p.size.width for p in solution.pieces}
    if name == "bedroom":
        assert wide["wardrobe"] >= 0.999
    if name == "kitchen":
        assert not composition_kitchen.short_worktop(list(solution.pieces))
        assert not composition_kitchen.hob_at_end(list(solution.pieces))
    if name == "closet":
        shelves = [p.size.width for p in solution.pieces if p.category == "storage_shelf"]
        assert sum(shelves) >= 0.6 * 2.0


def test_composing_takes_nothing_away_and_is_done_once(composed):
    from scenewright.building.plan import spaces
    from scenewright.catalog.loading import catalog_of
    from scenewright.domains.home.wheelchair import furnish_by_use
    from scenewright.engine.solve import Budget

    _, brief, _ = composed
    rooms, preset = spaces(brief), PRESETS["default"]
    tasks, wishes = prepare_rooms(brief, rooms, catalog_of(()), preset, preset.solver, 5)
    before = furnish_by_use(tasks[0], wishes[0], Budget(steps=6000, threads=1))
    after = compose(tasks[0], before)
    assert len(after.placed) >= len(before.placed)
    assert len(after.missing) <= len(before.missing)
    again = compose(tasks[0], after)
    assert [p.name for p in again.placed] == [p.name for p in after.placed]


def test_shoes_stand_in_one_hall_and_a_home_has_a_table():
    from scenewright.building.plan import spaces

    halls = [
        {
            "id": f"hall{k}",
            "function": "hall",
            "outline": [[x, 0], [x + 2, 0], [x + 2, 2], [x, 2]],
            "doors": [{"at": [x + 1.0, 2.0 if k else 0.0], "width": 0.8}],
        }
        for k, x in ((0, 0.0), (1, 6.0))
    ]
    living = {"id": "living", "function": "living", "outline": [[0, 2], [4, 2], [4, 5], [0, 5]]}
    living["doors"] = [{"at": [1.0, 2.0], "width": 0.8}]
    brief = Brief(rooms=[Room.model_validate(room) for room in (*halls, living)])
    household = decide_household(spaces(brief))
    assert (household.shoes_in, household.eats_in) == ("hall0", "living")
    shoes = (Wish("shoes", 1), Wish("coats", 2))
    assert share_out(household, "hall0", shoes, frozenset()) == shoes
    assert [w.group for w in share_out(household, "hall1", shoes, frozenset())] == ["coats"]
    asked = (Wish("shoes", 0, required=True),)
    assert share_out(household, "hall1", asked, frozenset()) == asked
    eats = share_out(household, "living", (), frozenset(("seating",)))
    assert [w.group for w in eats] == ["dining_wall"]
    assert share_out(household, "living", (), frozenset(("dining",))) == ()


def test_one_of_several_washrooms_has_the_washing_machine():
    from scenewright.building.plan import spaces

    washrooms = [
        {
            "id": f"washroom{k}",
            "function": "washroom",
            "outline": [[x, 0], [x + wide, 0], [x + wide, 2], [x, 2]],
            "doors": [{"at": [x + 0.6, 0.0], "width": 0.7}],
        }
        for k, x, wide in ((0, 0.0, 1.6), (1, 6.0, 2.4))
    ]
    household = decide_household(spaces(Brief(rooms=[Room.model_validate(r) for r in washrooms])))
    usual, asked = (Wish("basin", 0), Wish("washer", 0)), (Wish("washer", 0, required=True),)
    assert share_out(household, "washroom1", usual, frozenset()) == usual
    assert share_out(household, "washroom0", usual, frozenset()) == usual[:1]
    assert share_out(household, "washroom0", asked, frozenset()) == asked
    without = decide_household([])
    assert share_out(without, "bathroom", usual, frozenset()) == usual


def test_explain_tells_the_programme(composed):
    _, _brief, solution = composed
    told = explained_document(solution)["programme"]
    assert told.endswith("m of storage.")
    assert "\n" not in told


@pytest.mark.parametrize("function", EXPECTED)
def test_the_shortage_of_a_group_grows_with_its_room_and_none_is_without_remedy(function):
    known = [*cases(function).groups, *list_further(function)]
    for case in known[::7]:
        degrees = [find_shortage(case, area) for area in np.arange(4.0, 40.0, 0.5)]
        assert degrees == sorted(degrees)
        assert 0.0 <= degrees[0] <= degrees[-1] <= 1.0
    assert min(find_shortage(case, 40.0) for case in known) == 0.0


def test_shelves_of_a_closet_stand_behind_its_sliding_door():
    """A closet 0.55 m deep is used through its door: nobody needs floor before its shelves."""
    closet = {
        "id": "closet",
        "function": "storage",
        "outline": [[0, 0], [1.6, 0], [1.6, 0.55], [0, 0.55]],
        "doors": [{"at": [0.8, 0.0], "width": 1.5, "swing": "slide"}],
    }
    solution = solve(Brief(rooms=[Room.model_validate(closet)]), seed=1, steps=2000)
    shelves = [p for p in solution.pieces if p.category == "storage_shelf"]
    assert sum(p.size.width for p in shelves) >= 0.6 * 1.6
    assert all(p.pose.y - p.size.depth / 2 >= 0.3 for p in shelves)
    assert check(solution).valid


def test_groups_that_are_asked_for_are_as_large_as_their_room():
    rooms = {
        "kitchen": ([[0, 0], [4.2, 0], [4.2, 4], [0, 4]], ["kitchenette", "fridge", "dining_wall"]),
        "living": ([[0, 0], [6, 0], [6, 5], [0, 5]], ["seating", "media"]),
        "bedroom": ([[0, 0], [3.6, 0], [3.6, 3.4], [0, 3.4]], ["sleeping", "wardrobe"]),
    }
    for name, (outline, groups) in rooms.items():
        room = {
            "id": name,
            "function": name,
            "outline": outline,
            "doors": [{"at": [0.0, 0.6], "width": 0.8}],
            "ask": [{"group": group, "required": True} for group in groups],
        }
        solution = solve(Brief(rooms=[Room.model_validate(room)]), seed=2, steps=2000)
        held = [p.category for p in solution.pieces]
        assert check(solution).valid
        assert held.count("fridge") == ("fridge" in groups)
        if name == "kitchen":
            assert held.count("dining_chair") >= 4
            fronts = ("hob_cabinet", "sink_cabinet", "base_cabinet", "drawer_cabinet")
            wide = sum(p.size.width for p in solution.pieces if p.category in fronts)
            assert wide + 1.4 * held.count("corner_cabinet") >= 2.8 - 1e-6
        if name == "living":
            sofa = next(p for p in solution.pieces if p.category in ("sofa", "corner_sofa"))
            assert sofa.size.width >= 2.0
        if name == "bedroom":
            assert (held.count("double_bed"), held.count("nightstand")) == (1, 2)


def test_a_room_for_two_gets_its_double_bed_back():
    from scenewright.building.plan import spaces
    from scenewright.catalog.loading import catalog_of
    from scenewright.domains.home.wheelchair import furnish_by_use
    from scenewright.engine.solve import Budget

    room = {
        "id": "bedroom",
        "function": "bedroom",
        "outline": [[0, 0], [3.6, 0], [3.6, 3.2], [0, 3.2]],
        "doors": [{"at": [0.0, 0.6], "width": 0.8}],
    }
    brief = Brief(rooms=[Room.model_validate(room)])
    preset, rooms = PRESETS["default"], spaces(brief)
    (task,), _ = prepare_rooms(brief, rooms, catalog_of(()), preset, preset.solver, 5)
    single = (Wish("single", 0, core=True), Wish("wardrobe", 0))
    before = furnish_by_use(task, single, Budget(steps=6000, threads=1))
    assert "single" in {p.wish.group for p in before.placed}
    assert {p.wish.group for p in compose(task, before).placed} >= {"sleeping", "wardrobe"}
    assert wants_double_bed(task)
    asked = task.asked.model_copy(update={"ask": [Ask(group="single")]})
    assert not wants_double_bed(task._replace(asked=asked))
    assert not wants_double_bed(task._replace(forbidden=frozenset({"double_bed"})))


@pytest.mark.parametrize("name", sorted(GROUPS))
def test_every_form_of_a_group_holds_what_makes_it_the_group(name: str) -> None:
    """What is moved by hand is carried by that piece; a form without it would be taken apart."""
    forms = [*GROUPS[name].cases(), *FURTHER.get(name, lambda: ())()]
    assert all(any(m.category in GROUPS[name].essential for m in form.members) for form in forms)


def test_places_to_start_from_leave_a_built_in_cupboard_open():
    """The cheapest places of a bed bar the cupboard; those a step beside them are not lost."""
    from scenewright.building.plan import spaces
    from scenewright.catalog.loading import catalog_of
    from scenewright.domains.home.attempts.attempt import find_blocked

    cupboard = {"category": "wardrobe", "at": [1.0, 0.66], "heading": np.pi / 2}
    room = {
        "name": "bedroom",
        "function": "bedroom",
        "outline": [[0, 0], [3.23, 0], [3.23, 3.4], [0, 3.4]],
        "doors": [{"at": [2.7, 0.0], "width": 0.9}],
        "fixed": [cupboard | {"size": [2.0, 0.08, 2.5]}],
    }
    brief, preset = Brief(rooms=[Room.model_validate(room)]), PRESETS["default"]
    (task,), _ = prepare_rooms(brief, spaces(brief), catalog_of(()), preset, preset.solver, 0)
    bed = make_unplaced(task, (), Wish("sleeping", 0), cases("sleeping").groups[0])
    starts = list_starts(task, bed, frozenset())
    assert not any(find_blocked(with_margin(task), start.placed) for start in starts)
    held = [p.category for p in starts[0].placed[0].pieces]
    assert held.count("nightstand") == 2


def test_a_chair_on_a_shallow_balcony_leaves_its_sliding_door_free():
    """Between the door's edge and the end of the balcony are 0.39 m, before the door 0.73 m."""
    balcony = {
        "id": "balcony",
        "function": "balcony",
        "outline": [[0, 0], [2.43, 0], [2.43, 0.73], [0, 0.73]],
        "doors": [{"at": [1.19, 0.73], "width": 1.7, "swing": "slide"}],
    }
    solution = solve(Brief(rooms=[Room.model_validate(balcony)]), seed=0, steps=2000)
    (chair,) = (p for p in solution.pieces if p.category == "outdoor_chair")
    before = shapely.box(0.34, 0.43, 2.04, 0.73).intersection(
        _polygon(chair.pose.x, chair.pose.y, chair.pose.heading, *chair.size[:2])
    )
    assert before.area < 0.02 * 0.3
    assert check(solution).valid
