"""Wishes of a household: kept out, wanted, drawn to a place; told whether they came true."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import Any

import pytest

from scenewright.building.plan import spaces
from scenewright.building.standing import fixed_pieces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.domains import check, resolve
from scenewright.domains.home import solving as home
from scenewright.domains.home.attempts.attempt import build_task_problem, score_answer
from scenewright.domains.home.build_problem import items_of
from scenewright.domains.home.cases.library import SHIPPED
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.settings import FaultCosts
from scenewright.domains.home.tasks import task_of
from scenewright.domains.home.wished.wishes import apply_preferences, apply_wishes
from scenewright.formats import solution_json
from scenewright.formats.brief_json import loads
from scenewright.workflow import documents
from thoroughness import spread


def room(function: str, *wishes: dict[str, Any], width: float = 6.0) -> Brief:
    outline = [(0, 0), (width, 0), (width, 4.4), (0, 4.4)]
    asked = {
        "id": "r",
        "function": function,
        "outline": outline,
        "wishes": list(wishes),
        "doors": [{"at": (width - 0.8, 0), "width": 0.9}],
        "windows": [{"at": (0, 2.2), "width": 1.6}],
    }
    return Brief.model_validate({"rooms": [asked]})


def solved(brief: Brief, seed: int = 0) -> Solution:
    return home.solve(brief, seed=seed, steps=4000)


def told(solution: Solution) -> list[bool]:
    return [wish["fulfilled"] for wish in check(solution).figures["wishes"]]


@cache
def usual_livings() -> list[Solution]:
    return [solved(room("living"), seed) for seed in range(4)]


@pytest.mark.parametrize("what", ["tv", "media", "picture", "curtain", "rug"])
def test_what_is_forbidden_is_not_there(what: str) -> None:
    assert any(what in (p.category, p.function) for home_ in usual_livings() for p in home_.pieces)
    without = solved(room("living", {"what": what, "forbid": True}))
    assert not any(what in (p.category, p.function) for p in without.pieces)
    assert not any(out.what == "media" and out.required for out in without.left_out)
    assert told(without) == [True]
    assert check(without).valid


def test_what_is_forbidden_stays_away_when_a_room_is_furnished_again() -> None:
    first = solved(room("living", {"what": "curtain", "forbid": True}))
    again = resolve(first, again=["r"], seed=3)
    assert not any(p.category == "curtain" for p in again.pieces)


def test_what_is_wished_and_stands_already_does_not_come_twice() -> None:
    wishes = ({"what": "double_bed", "away_from": "door"}, {"what": "desk", "by": "window"})
    first = solved(room("double_bedroom", *wishes))
    again = resolve(first, lock=["bed", "desk"], again=["r"], seed=3)
    kinds = [piece.category for piece in again.pieces]
    assert [kinds.count(kind) for kind in ("double_bed", "desk", "office_chair")] == [1, 1, 1]
    bed = {"category": "double_bed", "at": [3, 1.0], "size": [1.6, 2.0, 0.5], "heading": 1.5708}
    brief = room("double_bedroom", *wishes)
    fixed = Brief.model_validate(
        {"rooms": [{**brief.rooms[0].model_dump(exclude_defaults=True), "fixed": [bed]}]}
    )
    assert [p.category for p in solved(fixed).pieces].count("double_bed") == 1


def test_what_is_wanted_comes_beside_the_usual() -> None:
    solution = solved(room("double_bedroom", {"what": "desk", "required": True}))
    assert {"sleeping", "wardrobe", "desk"} <= {p.function for p in solution.pieces}
    crowded = solved(room("study", {"what": "sleeping", "required": True}, width=1.5))
    assert told(crowded) == [False]
    assert any(out.what == "sleeping" and out.required for out in crowded.left_out)


@pytest.mark.parametrize(
    ("function", "what", "bed"),
    [
        ("child_bedroom", "double_bed", "double_bed"),
        ("child_bedroom", "bunk", "bunk_bed"),
        ("double_bedroom", "single_bed", "single_bed"),
    ],
)
def test_the_bed_that_is_wished_for_is_the_bed_of_the_room(
    function: str, what: str, bed: str
) -> None:
    """It takes the place of the usual bed; a wish for a nightstand takes that of none."""

    def beds(*wishes: dict[str, Any]) -> list[str]:
        pieces = solved(room(function, *wishes, width=3.0)).pieces
        return [p.category for p in pieces if p.category.endswith("_bed")]

    usual = "double_bed" if function == "double_bedroom" else "single_bed"
    assert beds({"what": what, "required": True}) == [bed]
    assert beds({"what": "nightstand"}) == [usual]


@pytest.mark.parametrize(
    "wish", [{"what": "chest", "by": "window"}, {"what": "desk", "near": "bed", "metres": 0.8}]
)
def test_places_draw(wish: dict[str, Any]) -> None:
    wish = {key: "single_bed" if value == "bed" else value for key, value in wish.items()}
    with_, without = 0, 0
    for seed in range(4):
        asked = room("single_bedroom", wish)
        drawn = solved(asked, seed)
        with_ += told(drawn)[0]
        plain = solved(room("single_bedroom", {"what": wish["what"]}), seed)
        without += told(replace(plain, brief=asked))[0]
    assert with_ >= 3
    assert with_ > without


def test_wishes_are_measured() -> None:
    desk = Piece("r/d", "desk", "", "r", Pose(0.4, 2.2, 0, 0.0), Size(1.2, 0.6, 0.75))
    far = Piece("r/b", "bookcase", "", "r", Pose(5.0, 2.2, 0, 3.14), Size(0.8, 0.3, 2.0))
    wishes: list[dict[str, Any]] = [
        {"what": "desk", "by": "window"},
        {"what": "bookcase", "by": "window"},
        {"what": "desk", "near": "bookcase", "metres": 4.2},
        {"what": "desk", "near": "bookcase", "metres": 4.0},
        {"what": "desk", "by": "corner"},
        {"what": "plant"},
        {"what": "desk", "forbid": True},
    ]
    empty = Solution(room("study", *wishes), (), (), (), (), {}, "", "", 0, "", "", 0.0, 0)
    assert told(replace(empty, pieces=(desk, far))) == [
        True,
        False,
        True,
        False,
        False,
        False,
        False,
    ]


def piece(category: str, x: float, y: float, turn: float, size: Size) -> Piece:
    return Piece(f"r/{category}", category, "", "r", Pose(x, y, 0, turn), size)


@pytest.mark.parametrize(
    ("wish", "fulfilled"),
    [
        ({"what": "armchair", "face": "window"}, True),
        ({"what": "armchair", "face": "door"}, False),
        ({"what": "armchair", "face": "bookcase"}, False),
        ({"what": "bookcase", "face": "armchair"}, True),
        ({"what": "desk", "face": "window"}, False),
        ({"what": "desk", "face": "door"}, True),
        ({"what": "armchair", "away_from": "window", "metres": 2.5}, True),
        ({"what": "armchair", "away_from": "window", "metres": 2.7}, False),
        ({"what": "armchair", "away_from": "door"}, True),
        ({"what": "bookcase", "away_from": "door"}, False),
        ({"what": "bookcase", "away_from": "armchair", "metres": 2.1}, True),
        ({"what": "bookcase", "away_from": "armchair", "metres": 2.3}, False),
        ({"what": "bookcase", "away_from": "piano"}, True),
        ({"what": "bookcase", "face": "piano"}, False),
        ({"what": "chest_of_drawers", "by": "door"}, True),
        ({"what": "bookcase", "by": "door"}, False),
        ({"what": "armchair", "by": "door"}, False),
        ({"what": "bookcase", "by": "wall"}, True),
        ({"what": "armchair", "by": "wall"}, False),
    ],
)
def test_places_are_measured(wish: dict[str, Any], fulfilled: bool) -> None:
    """A room with its window in the west and its door in the south-east corner."""
    stands = (
        piece("armchair", 3.0, 2.2, math.pi, Size(0.8, 0.8, 0.85)),
        piece("bookcase", 5.8, 2.2, math.pi, Size(0.8, 0.4, 2.0)),
        piece("desk", 5.2, 3.8, math.pi / 2, Size(1.2, 0.6, 0.75)),
        piece("chest_of_drawers", 4.0, 0.3, math.pi / 2, Size(0.8, 0.5, 0.9)),
    )
    empty = Solution(room("study", wish), (), (), (), (), {}, "", "", 0, "", "", 0.0, 0)
    assert told(replace(empty, pieces=stands)) == [fulfilled]


@pytest.mark.parametrize(
    ("function", "wish"),
    spread(
        [
            ("living", {"what": "sideboard", "by": "door"}),
            ("living", {"what": "dining", "by": "window"}),
            ("single_bedroom", {"what": "desk", "face": "window"}),
            ("double_bedroom", {"what": "double_bed", "face": "window"}),
            ("living", {"what": "tv", "away_from": "window", "metres": 3.0}),
            ("double_bedroom", {"what": "chest", "away_from": "wardrobe"}),
            ("living", {"what": "armchair", "face": "tv"}),
        ],
        3,
    ),
)
def test_new_places_draw(function: str, wish: dict[str, Any]) -> None:
    heard, ignored = 0, 0
    for seed in range(6):
        asked = room(function, wish)
        heard += told(home.solve(asked, seed=seed))[0]
        plain = home.solve(room(function, {"what": wish["what"]}), seed=seed)
        ignored += told(replace(plain, brief=asked))[0]
    assert heard >= 4
    assert heard > ignored


def test_nothing_is_near_itself() -> None:
    """A sofa belongs to its seating, but its neighbours are what counts."""
    alone = piece("sofa", 3.0, 2.0, 0.0, Size(2.0, 0.9, 0.8))
    alone = replace(alone, function="seating")
    table = replace(piece("coffee_table", 3.0, 3.8, 0.0, Size(0.6, 0.6, 0.4)), function="seating")
    asked = room(
        "living",
        {"what": "sofa", "near": "seating"},
        {"what": "sofa", "face": "seating"},
        {"what": "sofa", "away_from": "seating", "metres": 0.5},
    )
    empty = home.solve(asked, steps=1)
    assert told(replace(empty, pieces=(alone,))) == [False, False, True]
    assert told(replace(empty, pieces=(alone, table))) == [True, False, True]


def test_every_wish_to_be_near_something_draws() -> None:
    """Two wishes of one thing: the first counts as much as the second, said twice as much as
    once."""
    asked = [{"what": "bookcase", "near": near} for near in ("media", "plant", "plant")]
    wishes = (Wish("media", 0), Wish("plant", 1), Wish("shelf", 1))
    wanted = apply_wishes(wishes, room("living", *asked).rooms[0], SHIPPED)
    names = [wish.group for wish in wanted]
    items = items_of(wanted, 24.0)
    pairs = apply_preferences(items, wanted).pairs[len(items.pairs) :]
    assert [(names[i], names[j]) for i, j in pairs] == [("shelf", "media"), ("shelf", "plant")]


@pytest.mark.parametrize(("x", "deaf"), [(0.6, 0), (4.0, 1)])
def test_layouts_that_meet_a_wish_score_better(x: float, deaf: int) -> None:
    """A plant that stands by the window, or far from it, and nothing else."""
    plant = {
        "category": "potted_tree",
        "at": (x, 2.2),
        "size": (0.4, 0.4, 1.5),
        "function": "plant",
    }
    brief = room("living", {"what": "plant", "by": "window"})
    brief = Brief.model_validate({"rooms": [brief.rooms[0].model_dump() | {"fixed": [plant]}]})
    asked, space = brief.rooms[0], spaces(brief)[0]
    standing = tuple(fixed_pieces(asked, space, shipped()))
    task = task_of(brief, asked, space, standing, shipped(), SHIPPED, PRESETS["default"], "", 0)
    told = score_answer(task, (), (), build_task_problem(task, (), task.ground), 0.0)
    assert (told.unmet, told.score) == (deaf, deaf * FaultCosts().unmet)


def test_a_fixed_piece_draws_too() -> None:
    piano = {"category": "piano", "at": [5.6, 3.4], "heading": math.pi, "size": [1.5, 0.6, 1.2]}
    near, far = 0, 0
    for seed in range(6):
        asked, plain = (
            Brief.model_validate(
                {"rooms": [room("living", wish).rooms[0].model_dump() | {"fixed": [piano]}]}
            )
            for wish in ({"what": "bookcase", "near": "piano"}, {"what": "bookcase"})
        )
        near += told(solved(asked, seed))[0]
        far += told(replace(solved(plain, seed), brief=asked))[0]
    assert near >= 5
    assert near > far


def test_explain_and_json_tell() -> None:
    solution = solved(room("study", {"what": "desk", "by": "window"}))
    document = documents.explained_document(solution)
    assert document["wishes"][0]["wish"] == "desk by a window"
    again = solution_json.loads(solution_json.dumps(solution))
    assert documents.explained_document(again)["wishes"] == document["wishes"]


@pytest.mark.parametrize(
    ("wish", "fault"),
    [
        ({"what": "dsk"}, r"rooms\[0\] 'r' wishes\[0\].what: unknown .* 'dsk'; .*desk"),
        ({"what": "desk", "near": "bedd"}, r"wishes\[0\].near: unknown .* 'bedd'"),
        ({"what": "desk", "face": "windw"}, r"wishes\[0\].face: unknown .* 'windw'"),
        ({"what": "desk", "away_from": "wall"}, r"wishes\[0\].away_from: unknown .* 'wall'"),
        ({"what": "staircase"}, "no furniture group holds a staircase"),
    ],
)
def test_unknown_names_are_told(wish: dict[str, Any], fault: str) -> None:
    with pytest.raises(InputError, match=fault):
        solved(room("study", wish))


def test_a_forbidden_thing_has_no_place() -> None:
    brief = (
        room("study")
        .model_dump_json()
        .replace('"wishes":[]', '"wishes":[{"what":"tv","forbid":true,"by":"window"}]')
    )
    with pytest.raises(InputError, match="forbidden piece has no place"):
        loads(brief)
