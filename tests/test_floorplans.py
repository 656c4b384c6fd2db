"""Generated plans: covered, wide, lit and reached, the same for the same seed; halls likewise."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

import scenewright as sw
from scenewright.building.outline_forms import NAMES
from scenewright.cli.commands import run
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.domains import plan_valid
from scenewright.domains.home.floorplans.openings import WALL
from scenewright.domains.home.floorplans.programme import ROWS
from scenewright.domains.home.floorplans.slicing import (
    SIDE_BY_SIDE,
    STACKED,
    measure_contacts,
    place_rooms,
)
from scenewright.formats import brief_json
from scenewright.workflow.generate import generate

Box = tuple[float, float, float, float]
ASKED: tuple[dict[str, Any], ...] = (
    {"rooms": 1, "area": 34.0},
    {"rooms": 3, "area": 75.0, "outline": "skew"},
    {"rooms": 4, "area": 95.0, "outline": "l"},
    {"rooms": 6, "area": 150.0, "outline": "rectangle"},
    {"rooms": 5, "area": 140.0, "storeys": 2},
    {"rooms": 6, "area": 190.0, "storeys": 3},
)


def divide_plainly(tokens: list[int], weights: np.ndarray, box: Box) -> dict[int, Box]:
    """The rooms of a tree in postfix order, by recursion: the slow reference."""
    if len(tokens) == 1:
        return {tokens[0]: box}
    pending, start = 0, len(tokens) - 1
    while pending < 1:  # the right subtree is the shortest end with one room more than cuts
        start -= 1
        pending += 1 if tokens[start] >= 0 else -1
    left, right = tokens[:start], tokens[start:-1]
    weight = [sum(weights[t] for t in half if t >= 0) for half in (left, right)]
    share = weight[0] / sum(weight)
    x0, y0, x1, y1 = box
    if tokens[-1] == SIDE_BY_SIDE:
        x = x0 + share * (x1 - x0)
        first, second = (x0, y0, x, y1), (x, y0, x1, y1)
    else:
        y = y0 + share * (y1 - y0)
        first, second = (x0, y0, x1, y), (x0, y, x1, y1)
    return divide_plainly(left, weights, first) | divide_plainly(right, weights, second)


@st.composite
def trees(draw: st.DrawFn) -> list[int]:
    """Random slicing trees in postfix order."""
    rooms = draw(st.permutations(range(draw(st.integers(2, 9)))))
    tokens, pending, waiting = [], 0, list(rooms)
    while waiting or pending > 1:
        if waiting and (pending < 2 or draw(st.booleans())):
            tokens.append(waiting.pop())
            pending += 1
        else:
            tokens.append(draw(st.sampled_from([SIDE_BY_SIDE, STACKED])))
            pending -= 1
    return tokens


@given(trees(), st.integers(0, 99))
def test_trees_are_laid_out_as_by_recursion_and_borders_measured_as_by_shapely(
    tokens: list[int], seed: int
) -> None:
    rng = np.random.default_rng(seed)
    count = (len(tokens) + 1) // 2
    weights = rng.uniform(1.0, 5.0, count)
    parts = np.array([[0.0, 0.0, 9.0, 7.0]])
    boxes, nodes = np.zeros((count, 4)), np.zeros((len(tokens), 7))
    place_rooms(parts, np.array([tokens]), np.array([len(tokens)]), weights, nodes, boxes)
    expected = divide_plainly(tokens, weights, (0.0, 0.0, 9.0, 7.0))
    assert np.allclose(boxes, [expected[k] for k in range(count)])
    contacts, sides = np.zeros((count, count)), np.zeros((count, 4))
    measure_contacts(boxes, contacts, sides)
    rooms = shapely.box(*boxes.T)
    for i, j in combinations(range(count), 2):
        shared = shapely.intersection(rooms[i], rooms[j], grid_size=1e-9).length
        assert abs(contacts[i, j] - shared) < 1e-6
    assert abs(sides.sum() - 32.0) < 1e-6  # the outline


def reached(brief: Brief) -> set[str]:
    """The ids of the rooms that can be reached from the front door, by doors and stairs."""
    joined = [(room.id, door.to) for room in brief.rooms for door in room.doors if door.to]
    halls = [room.id for room in brief.rooms if room.function == ["hall"]]
    joined += list(combinations(halls, 2)) if brief.stairs else []
    found = {room.id for room in brief.rooms if any(door.id == "entrance" for door in room.doors)}
    while more := {b for pair in joined for a, b in (pair, pair[::-1]) if a in found} - found:
        found |= more
    return found


def width_of(outline: np.ndarray) -> float:
    """The least width of a quadrilateral without its walls."""
    inner = shapely.Polygon(outline).buffer(-WALL / 2, join_style="mitre")
    corners = np.array(inner.minimum_rotated_rectangle.exterior.coords)
    return float(np.linalg.norm(np.diff(corners, axis=0), axis=1).min())


@pytest.mark.parametrize("asked", ASKED, ids=str)
@pytest.mark.parametrize("seed", range(4))
def test_rooms_are_wide_lit_and_reached_on_the_floor_asked_for(
    asked: dict[str, Any], seed: int
) -> None:
    brief = generate("home", seed=seed, **asked)
    assert reached(brief) == {room.id for room in brief.rooms}
    assert len(brief.levels) == asked.get("storeys", 1)
    floor = sum(shapely.Polygon(space.outline).area for space in plan_valid(brief).spaces)
    assert abs(floor / asked["area"] - 1) < 0.06
    skewed = asked.get("outline") in ("skew", None)
    for room in brief.rooms:
        row = ROWS[room.id.split("@")[0].split("-")[0]]
        assert width_of(np.array(room.outline)) > row.least * (0.8 if skewed else 1) - 0.01
        assert not row.light or room.windows, room.id
    for level in brief.levels:
        shapes = [shapely.Polygon(r.outline) for r in brief.rooms if r.level == level.id]
        assert abs(shapely.union_all(shapes).area - sum(s.area for s in shapes)) < 0.02


def test_the_same_seed_is_the_same_plan_and_others_are_others() -> None:
    plans = [brief_json.dumps(generate("home", rooms=3, seed=seed)) for seed in (*range(30), 0)]
    assert plans[0] == plans[-1]
    assert len({text.replace(f"Home {k}", "") for k, text in enumerate(plans[:-1])}) == 30


@pytest.mark.parametrize("outline", NAMES)
def test_outlines_are_of_the_form_asked_for(outline: str) -> None:
    brief = generate("home", rooms=4, area=95.0, outline=outline, seed=1)
    shape = shapely.union_all(
        [shapely.Polygon(room.outline) for room in brief.rooms], grid_size=1e-3
    )
    full = shape.minimum_rotated_rectangle.area
    hull = shape.convex_hull.area
    assert (shape.area / hull < 0.97) == (outline == "l")
    assert (hull / full < 0.995) == (outline != "rectangle")


def test_a_generated_home_and_a_generated_hall_can_be_arranged() -> None:
    for kind, asked in (("home", {"rooms": 2}), ("hall", {"use": "books", "area": 120.0})):
        brief = generate(kind, seed=3, **asked)
        solution = sw.solve(brief, seed=0)
        assert sw.check(solution).valid


def test_halls_hold_what_their_use_asks_for_on_their_floor() -> None:
    brief = generate("hall", use="grocery", area=420.0, outline="l", seed=5)
    assert abs(shapely.Polygon(brief.rooms[0].outline).area - 420.0) < 1.0
    assert {demand.category for demand in brief.rooms[0].demands} >= {"checkout", "gondola"}
    assert [door.id for door in brief.rooms[0].doors] == ["entrance", "back-door"]
    assert generate("hall", seed=5) == generate("hall", seed=5)


@pytest.mark.parametrize(
    ("kind", "asked", "fault"),
    [
        ("home", {"rooms": 0}, "0 rooms are asked for"),
        ("home", {"storeys": 9, "rooms": 8}, "9 storeys are asked for"),
        ("home", {"rooms": 2, "storeys": 2}, "2 rooms do not fill 2 storeys"),
        ("home", {"area": float("nan")}, "nan m² do not suit 3 rooms"),
        ("home", {"area": 1e9}, "give 59 to 155 m²"),
        ("home", {"outline": "round"}, "there is no outline 'round'"),
        ("home", {"use": "books"}, "a home is not asked for by 'use'"),
        ("hall", {"use": "smithy"}, "no programme for the use 'smithy'"),
        ("hall", {"area": 1.0}, "1 m² are asked for"),
        ("site", {}, "do not support 'generate'"),
        ("castle", {}, "'castle' is no kind of scene"),
    ],
)
def test_what_cannot_be_built_is_refused(kind: str, asked: dict[str, Any], fault: str) -> None:
    with pytest.raises(InputError, match=fault):
        generate(kind, **asked)


def test_the_command_writes_a_plan_or_a_folder_of_them(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    plan, folder = tmp_path / "plan.json", tmp_path / "plans"
    assert run(["generate", "home", "--rooms", "2", "--seed", "4", "-o", str(plan)]) == 0
    assert sw.read(plan).rooms == generate("home", rooms=2, seed=4).rooms
    asked = ["generate", "home", "--rooms", "2", "--count", "3", "--seed", "4", "-o"]
    assert run([*asked, str(folder)]) == 0
    names = [f"home-{k}.json" for k in (4, 5, 6)]
    assert sorted(path.name for path in folder.iterdir()) == [*names, "manifest.jsonl"]
    assert sw.read(folder / "home-4.json").rooms == sw.read(plan).rooms
    capsys.readouterr()
    assert run([*asked, str(plan)]) == 2
    assert "several plans are written into a folder" in capsys.readouterr().err
    taken = tmp_path / "taken"
    taken.write_text("mine")
    assert run([*asked, str(taken)]) == 2
    assert taken.read_text() == "mine"


@pytest.mark.parametrize(("rooms", "seed"), [(5, 488), (6, 624)])
def test_a_plan_that_takes_many_tries_comes_out(rooms: int, seed: int) -> None:
    brief = generate("home", rooms=rooms, storeys=2, seed=seed)
    assert len({room.level for room in brief.rooms}) == 2
