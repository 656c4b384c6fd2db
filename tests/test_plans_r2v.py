"""The adapter of real flats: what becomes of rooms, openings and slivers."""

from __future__ import annotations

from statistics import median

import pytest
from benchmarks.counters_r2v import name_kitchens
from benchmarks.plans_r2v import adapt, raw_plans
from benchmarks.r2v import tally
from benchmarks.rescaled_r2v import enlarge, find_factor, list_leaves, rescale

from scenewright.building import plan


def box(x0: float, y0: float, x1: float, y1: float, *labels: str) -> dict:
    polygon = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
    return {"labels": list(labels), "polygon": polygon, "area": (x1 - x0) * (y1 - y0)}


def opening(a: list[float], b: list[float], kind: str = "door") -> dict:
    return {"a": a, "b": b, "rooms": [], "kind": kind, "width": abs(a[0] - b[0] + a[1] - b[1])}


FLAT = {
    "id": "flat",
    "rooms": [
        box(0, 0, 4, 3, "bedroom"),
        box(4, 0, 6, 3, "corridor", "entrance"),
        box(0, -1, 4, 0, "balcony"),
        box(4, 3, 6, 4.2, "closet"),
        box(0, 3, 4, 3.1),
    ],
    "openings": [
        opening([4, 1], [4, 1.8]),
        opening([1, 0], [2.8, 0]),
        opening([4.5, 3], [5.4, 3]),
        opening([6, 1], [6, 1.9], "entrance_or_window"),
        opening([0, 1], [0, 2], "window_or_outer"),
        opening([8, 8], [9, 8]),
    ],
}


def test_a_flat_becomes_a_brief_with_doors_where_they_belong():
    found = adapt(FLAT)
    spaces = {space.functions[0]: space for space in plan.spaces(found.brief)}
    assert set(spaces) == {"bedroom", "hall", "balcony", "storage"}
    openings = {o.id: o for space in spaces.values() for o in space.openings}.values()
    joined = {frozenset(s.split("-")[1] for s in o.spaces): o for o in openings}
    leaf = joined[frozenset(("bedroom", "hall"))]
    assert leaf.spaces[0].endswith("bedroom")
    assert leaf.hinge != 0
    assert leaf.swing == 1
    assert joined[frozenset(("bedroom", "balcony"))].hinge == 0
    assert joined[frozenset(("hall", "storage"))].kind == "door"
    assert joined[frozenset(("hall",))].swing == -1
    assert joined[frozenset(("bedroom",))].kind == "window"
    assert len(found.words) == 2, found.words


def test_a_room_within_another_becomes_a_hole():
    rooms = [box(0, 0, 5, 5, "living_room"), box(2, 2, 3, 3, "restroom")]
    found = adapt({"id": "x", "rooms": rooms, "openings": [opening([2, 2.1], [2, 2.9])]})
    living, toilet = sorted(plan.spaces(found.brief), key=lambda s: s.functions != ("living",))
    assert len(living.holes) == 1
    assert toilet.openings[0].spaces == living.openings[0].spaces


def test_a_flat_of_slivers_is_told_to_be_useless():
    found = adapt({"id": "x", "rooms": [box(0, 0, 4, 0.1)], "openings": []})
    assert found.brief is None
    assert found.words[-1] == "no room is left"


def test_a_cooking_counter_names_the_kitchen_of_a_plan_that_names_none():
    rooms = [box(0, 0, 4, 3, "bedroom"), box(4, 0, 9, 3, "living_room")]
    counter = {"kind": "cooking_counter", "box": [8.4, 1, 9.1, 2.6]}
    basin = {"kind": "washing_basin", "box": [0, 0, 0.5, 0.5]}
    raw = {"id": "x", "rooms": rooms, "openings": [], "icons": [counter, basin]}
    named = name_kitchens(raw)
    assert [room["labels"] for room in named["rooms"]] == [["bedroom"], ["living_room", "kitchen"]]
    assert rooms[1]["labels"] == ["living_room"]
    assert name_kitchens(named) is named
    assert name_kitchens(raw | {"icons": [basin]})["rooms"] == rooms


def test_the_tally_counts_flats_and_rooms():
    rooms = [
        ["bedroom", 9.0, [], []],
        ["toilet", 1.0, ["toilet"], ["toilet"]],
        ["kitchen", 5.0, ["hob", "sink"], ["hob"]],
    ]
    more = {"solve": 1.0, "check": 0.5, "doorless": 1, "spaces": 4}
    done = {"faults": {"collision": 2}, "rooms": rooms} | more
    good = {"faults": {}, "rooms": rooms[:1]} | more
    crash = {"crash": "ValueError: x", "solve": 0.0, "check": 0.0}
    found = {r["case"]: (r["ours"], r["runs"]) for r in tally([done, good, crash])}
    assert found["no crash"] == (0.6667, 3)
    assert found["no collision"] == (0.5, 2)
    assert found["rooms complete"] == (0.5, 4)
    assert found["others reported"] == (0.5, 2)
    assert found["rooms with a door"] == (0.75, 8)
    assert "valid 50.0%, complete 50.0%, others reported 50.0%" in found
    assert found["solve + check"][0] == pytest.approx(60 * 3 / 1.5)


@pytest.mark.realdata(quick=True)
@pytest.mark.usefixtures("real_data")
def test_real_flats_become_briefs_that_build():
    plans = raw_plans()
    assert len(plans) > 800
    for raw in plans[::25]:
        found = adapt(raw)
        assert found.brief is not None, (found.id, found.words)
        kept = len(found.brief.rooms)
        assert kept >= 0.6 * len(raw["rooms"])


SMALL = enlarge(FLAT | {"px_per_m": 50.0, "area_m2": 20.0, "icons": []}, 0.5)


def test_a_flat_drawn_too_small_is_enlarged_until_its_hinged_doors_are_usual():
    assert list_leaves(SMALL) == pytest.approx([0.4])
    grown = rescale(SMALL)
    assert len(list_leaves(grown)) == 2, "a front door of 0.45 m was none"
    assert median(list_leaves(grown)) == pytest.approx(0.75, rel=0.01)
    assert find_factor(SMALL) == pytest.approx(1.765)
    assert rescale(SMALL) == grown
    assert rescale(grown)["px_per_m"] == pytest.approx(grown["px_per_m"], rel=0.02)


def test_no_flat_is_made_smaller_or_enlarged_beyond_the_limit():
    large = enlarge(SMALL, 2.4)
    assert rescale(large) is large
    assert find_factor(enlarge(SMALL, 0.75)) == 2.2
    assert find_factor(enlarge(SMALL, 0.7)) == 1.0  # no door is wide enough to be one
    bare = SMALL | {"openings": []}
    assert rescale(bare) is bare


@pytest.mark.realdata(quick=True)
def test_of_real_flats_every_room_and_opening_is_read_or_said() -> None:
    raw = raw_plans()
    for flat in raw[:: len(raw) // 24][:24]:
        found = adapt(flat)
        slivers = [words for words in found.words if words.startswith("dropped a sliver")]
        openings = [words for words in found.words if words.startswith("dropped an opening")]
        placed = sum(len(room.doors) + len(room.windows) for room in found.brief.rooms)
        assert len(found.brief.rooms) + len(slivers) == len(flat["rooms"]), flat["id"]
        assert placed + len(openings) == len(flat["openings"]), flat["id"]
        lost = sum(float(words.split(", ")[1].split()[0]) for words in slivers)
        drawn = sum(room["area"] for room in flat["rooms"])
        assert lost <= 0.05 * drawn, flat["id"]
        assert len(plan.spaces(found.brief)) == len(found.brief.rooms)
