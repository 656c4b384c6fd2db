"""Outlets and radiators: on their walls, kept in reach and kept clear, judged, told, saved."""

from __future__ import annotations

from dataclasses import replace
from io import StringIO
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from scenewright.building.plan import spaces
from scenewright.building.standing import fixed_pieces
from scenewright.catalog.assets import shipped
from scenewright.cli import show
from scenewright.core.brief import Brief
from scenewright.core.catalog import Member
from scenewright.core.errors import InputError
from scenewright.core.report import Report
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.core.space import Outlet
from scenewright.domains import check, resolve, scene_of, solve
from scenewright.domains.home import solving as home
from scenewright.domains.home.energy import evaluate
from scenewright.domains.home.furnishing.furnish import Refused, furnish_patch
from scenewright.domains.home.furnishing.obstacles import standing_of
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.problem import Problem, empty_items
from scenewright.domains.home.wished.plugged import out_of_reach
from scenewright.drawing import rooms
from scenewright.drawing.svg import write_svg
from scenewright.formats import solution_json
from scenewright.formats.brief_json import loads
from scenewright.workflow import documents


def room(function: str = "living", width: float = 6.0, **services: Any) -> Brief:
    outline = [(0, 0), (width, 0), (width, 4.4), (0, 4.4)]
    asked = {
        "id": "r",
        "function": function,
        "outline": outline,
        "doors": [{"at": (width - 0.8, 0), "width": 0.9}],
        "windows": [{"at": (0, 2.2), "width": 1.6}],
    }
    return Brief.model_validate({"rooms": [asked | services]})


def holding(brief: Brief, *pieces: Piece) -> Report:
    given = home.solve(
        brief.model_copy(update={"rooms": [brief.rooms[0].model_copy(update={"ask": []})]}),
        steps=100,
    ).pieces
    empty = Solution(brief, (), (), (), (), {}, "", "", 0, "", "", 0.0, 0)
    return check(replace(empty, pieces=(*(p for p in given if p.fixed), *pieces)))


def piece(category: str, x: float, y: float, size: Size, z: float = 0.0) -> Piece:
    return Piece(f"r/{category}", category, "", "r", Pose(x, y, z, 0.0), size)


UNDER_WINDOW = {"radiators": [{"at": (0, 2.2), "width": 1.2}]}


def test_they_lie_on_the_walls_and_look_into_the_room() -> None:
    space = spaces(
        room(
            radiators=[{"at": (0.1, 2.2)}],
            outlets=[{"at": (3, 4.5), "kind": "power"}, {"at": (6, 1), "kind": "water"}],
        )
    )[0]
    radiator = space.radiators[0]
    assert (radiator.x, radiator.y) == pytest.approx((0.05, 2.2))
    assert radiator.heading == pytest.approx(0.0)
    assert [(o.kind, round(o.x, 6), round(o.y, 6)) for o in space.outlets] == [
        ("power", 3.0, 4.4),
        ("water", 6.0, 1.0),
    ]
    assert np.cos(
        [o.heading + t for o, t in zip(space.outlets, (np.pi / 2, np.pi), strict=True)]
    ) == pytest.approx([1, 1])


@pytest.mark.parametrize("seed", range(6))
def test_what_is_closed_keeps_clear_of_radiators(seed: int) -> None:
    brief = room(radiators=[{"at": (0, 2.2), "width": 2.0}, {"at": (2, 4.4), "width": 3.0}])
    solution = home.solve(brief, seed=seed, steps=2000)
    assert sum(p.category == "radiator" for p in solution.pieces) == 2
    assert check(solution).valid
    curtains = [p for p in solution.pieces if p.category == "curtain"]
    assert all(p.pose.z >= 0.7 for p in curtains)


def test_search_and_dressing_keep_the_floor_before_radiators_free() -> None:
    space = spaces(room(**UNDER_WINDOW))[0]
    fixed = tuple(fixed_pieces(room(**UNDER_WINDOW).rooms[0], space, shipped()))
    ground = ground_of(space, fixed, 20.0)
    assert ground.fronts == pytest.approx(np.array([[0.2, 2.2, 0.0, 1.2, 0.2]]))
    problem = Problem(ground, empty_items(1), ("bed",), {"keep_free": 1.0})
    boxes = np.array([[[0.7, 2.2, 0.0, 1.0, 1.0]], [[0.81, 2.2, 0.0, 1.0, 1.0]]])
    assert evaluate(problem, boxes) == pytest.approx([0.1, 0.0])
    patch = np.array([0.35, 2.2, 0.0, 1.0, 0.45])
    worn = furnish_patch(
        "chest",
        patch,
        ground._replace(windows=np.zeros((0, 6))),
        standing_of(fixed, frozenset()),
        shipped(),
        2.6,
    )
    assert isinstance(worn, Refused)
    assert worn.reason.endswith("would stand before a radiator")


@pytest.mark.parametrize(
    ("stands", "blamed"),
    [
        (piece("sofa", 0.6, 2.2, Size(2.0, 0.9, 0.8)), True),
        (piece("sofa", 0.78, 2.2, Size(2.0, 0.9, 0.8)), False),
        (piece("sofa", 0.45, 3.9, Size(0.9, 0.9, 0.8)), False),
        (piece("desk", 0.5, 2.2, Size(1.2, 0.7, 0.75)), False),
        (piece("rug", 0.6, 2.2, Size(1.0, 1.0, 0.02)), False),
        (piece("picture", 0.02, 2.2, Size(0.8, 0.04, 0.5), 1.4), False),
        (piece("curtain", 0.05, 2.2, Size(1.8, 0.08, 2.3), 0.02), True),
        (piece("curtain", 0.05, 2.2, Size(1.8, 0.08, 1.5), 0.8), False),
        (piece("chest_of_drawers", 0.5, 1.2, Size(1.0, 0.5, 0.9)), True),
    ],
)
def test_the_referee_sees_what_shuts_a_radiator_in(stands: Piece, blamed: bool) -> None:
    found = holding(room(**UNDER_WINDOW), stands).of("blocked_radiator")
    assert [f.piece for f in found] == [stands.id] * blamed
    assert all(f.other == "r/radiator_1" and not f.given for f in found)


def test_what_the_brief_puts_before_its_radiator_is_given() -> None:
    wardrobe = {"category": "wardrobe", "at": (0.45, 2.2), "size": (1.6, 0.6, 2.0)}
    report = check(home.solve(room(**UNDER_WINDOW, fixed=[wardrobe]), steps=500))
    assert [f.given for f in report.of("blocked_radiator")] == [True]
    assert report.valid


TV = piece("tv", 5.7, 2.2, Size(1.2, 0.1, 0.7))


def test_distances_to_outlets_are_told() -> None:
    far = room(outlets=[{"at": (1.0, 0), "kind": "power"}, {"at": (6, 2.2), "kind": "antenna"}])
    report = holding(far, TV)
    assert [(f["outlet"], f["within"]) for f in report.figures["outlets"]] == [
        ("power", False),
        ("antenna", True),
    ]
    assert report.figures["outlets"][0]["metres"] == pytest.approx(np.hypot(4.65, 1.6), abs=1e-3)
    assert not report.of("unserved")
    assert any("from the nearest power outlet, its lead" in note.message for note in report.notes)
    must = room(outlets=[{"at": (1.0, 0), "kind": "power", "required": True}])
    assert [f.other for f in holding(must, TV).of("unserved")] == ["power"]
    assert "outlets" not in holding(room(), TV).figures


def test_explain_tells_of_outlets() -> None:
    brief = room(outlets=[{"at": (1.0, 4.4), "kind": "power"}, {"at": (6, 3.9), "kind": "antenna"}])
    solution = home.solve(brief, steps=500)
    document = documents.explained_document(solution)
    assert document["outlets"] == check(solution).figures["outlets"] != []
    assert "wishes" not in check(solution).figures
    written = StringIO()
    show.print_explanation(Console(file=written, width=200), solution)
    far = [told for told in document["outlets"] if not told["within"]]
    told = f"outlets: {len(document['outlets']) - len(far)} of {len(document['outlets'])} leads"
    assert told in written.getvalue()
    assert all(each["piece"] in written.getvalue() for each in far)


def within(solution: Solution, brief: Brief) -> float:
    figures = check(replace(solution, brief=brief)).figures["outlets"]
    return float(np.mean([f["within"] for f in figures]))


@pytest.mark.parametrize(("at", "metres"), [((3.0, 1.0), 0.0), ((3.0, 3.0), 1.1), ((5, 0.2), 0.0)])
def test_leads_too_short_are_measured(at: tuple[float, float], metres: float) -> None:
    """A television of 1.2 by 0.2 m whose lead reaches 1.5 m; no antenna is listed, so none
    counts."""
    tv = Member("tv", 0.0, 0.0, 0.0, 0.0, Size(1.2, 0.2, 0.7))
    box = np.array([[3.0, 0.3, np.pi / 2, 1.2, 0.2]])
    outlet = Outlet("", "power", *at, 0.0, False)
    assert out_of_reach([tv], box, [outlet]) == pytest.approx(metres)


def test_outlets_draw() -> None:
    outlets = [{"at": (1.0, 4.4), "kind": "water"}, {"at": (5.0, 4.4), "kind": "power"}]
    asked = room("bathroom", width=5.2, outlets=outlets)
    plain = room("bathroom", width=5.2)
    heard = [within(home.solve(asked, seed=s, steps=2000), asked) for s in range(4)]
    ignored = [within(home.solve(plain, seed=s, steps=2000), asked) for s in range(4)]
    assert np.mean(heard) > np.mean(ignored) + 0.2


def test_a_saved_home_keeps_its_services_once() -> None:
    brief = room(
        **UNDER_WINDOW,
        outlets=[{"at": (6, 2), "kind": "power"}],
        wishes=[{"what": "armchair", "face": "window"}],
    )
    solution = home.solve(brief, steps=1000)
    text = solution_json.dumps(solution)
    again = loads(text)
    assert again.rooms[0].radiators == brief.rooms[0].radiators
    assert again.rooms[0].outlets == brief.rooms[0].outlets
    assert again.rooms[0].wishes == brief.rooms[0].wishes
    assert again.rooms[0].fixed == []
    assert sum(p.category == "radiator" for p in home.solve(again, steps=500).pieces) == 1


def test_radiators_are_not_moved_by_hand() -> None:
    solution = home.solve(room(**UNDER_WINDOW), steps=3000)
    with pytest.raises(InputError, match="belongs to the building"):
        resolve(solution, move={"radiator": (3.0, 2.0)})
    sofa = next(p for p in solution.pieces if p.category in ("sofa", "loveseat"))
    after = resolve(solution, move={sofa.id: (3.0, 2.2)}, steps=500)
    assert sum(p.category == "radiator" for p in after.pieces) == 1
    assert not check(after).of("blocked_radiator")


@pytest.mark.parametrize(
    ("services", "fault"),
    [
        ({"outlets": [{"at": (3, 2), "kind": "power"}]}, r"outlets\[0\]: is off the wall"),
        ({"radiators": [{"at": (3, 2)}]}, r"radiators\[0\]: is off the wall"),
        ({"radiators": [{"at": (5.2, 0)}]}, r"radiators\[0\]: stands before r-door-1"),
        ({"radiators": [{"at": (3, 0), "z": 2.0, "height": 1.0}]}, "ceiling"),
        ({"radiators": [{"at": (3, 0), "width": 9.0}]}, "9 m wide"),
        (
            {"radiators": [{"at": (3, 4.4)}], "slopes": [{"edge": 2, "knee": 0.6, "pitch": 0.7}]},
            r"radiators\[0\]: rises to 0.7 m, but the ceiling there is at 0.6 m",
        ),
        (
            {"radiators": [{"at": (1, 0), "id": "a"}, {"at": (3, 0), "id": "a"}]},
            r"radiators\[1\]: the id 'a' is used twice",
        ),
        (
            {
                "radiators": [{"at": (3, 0), "id": "a"}],
                "fixed": [{"category": "chair", "at": (3, 2), "size": (0.5, 0.5, 0.9), "id": "a"}],
            },
            r"radiators\[0\]: the id 'a' is used twice",
        ),
    ],
)
def test_what_cannot_be_is_told(services: dict[str, Any], fault: str) -> None:
    with pytest.raises(InputError, match=fault):
        spaces(room(**services))


def test_radiators_are_never_named_alike() -> None:
    space = spaces(room(radiators=[{"at": (0, 1)}, {"at": (0, 3), "id": "r/radiator_1"}]))[0]
    assert [radiator.id for radiator in space.radiators] == ["r/radiator_2", "r/radiator_1"]


def test_a_radiator_under_a_slope_ends_below_it() -> None:
    slopes = [{"edge": 2, "knee": 0.7, "pitch": 0.7}]
    assert spaces(room(radiators=[{"at": (3, 4.4)}], slopes=slopes))[0].radiators


def test_what_the_brief_puts_out_of_reach_is_not_tried_for_again() -> None:
    """A television that stands where no lead reaches will not be mended by furnishing anew."""
    standing = [{"category": "tv", "at": (5.9, 3), "heading": np.pi, "size": (1.2, 0.1, 0.7)}]
    near = room(fixed=standing, outlets=[{"at": (6, 3), "kind": "power"}])
    plain = home.solve(near, steps=300, seed=3)
    asked = room(fixed=standing, outlets=[{"at": (0.5, 4.4), "kind": "power"}])
    far = home.solve(asked, steps=300, seed=3)
    assert [f["within"] for f in check(far).figures["outlets"]] == [False]
    assert far.evaluations == plain.evaluations


POWER = '{"at":[0,1],"kind":"power"}'


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ('"outlets":[{"at":[0,1],"kind":"gas"}]', "power"),
        ('"outlets":[{"at":[0,NaN],"kind":"power"}]', "NaN"),
        (f'"outlets":[{",".join([POWER] * 10_000)}]', "at most 200"),
        ('"radiators":[{"at":[0,1],"depth":-1}]', "depth"),
        ('"wishes":[{"what":"sofa","face":"sofa"}]', "cannot face, be near or keep away"),
        ('"wishes":[{"what":"plant","near":"plant"}]', "cannot face, be near or keep away"),
        ('"wishes":[{"what":"tv","face":"door","forbid":true}]', "forbidden piece has no place"),
        ('"wishes":[{"what":"tv","near":"bed","away_from":"door"}]', "two wishes"),
    ],
)
def test_hostile_services_are_told_in_a_line(text: str, fault: str) -> None:
    start = '{"rooms":[{"name":"Living room","outline":[[0,0],[4,0],[4,4],[0,4]],'
    with pytest.raises(InputError, match=fault) as caught:
        loads(start + text + "}]}")
    assert "\n" not in str(caught.value)


def test_plans_draw_outlets_and_radiators() -> None:
    brief = room(
        **UNDER_WINDOW,
        outlets=[
            {"at": (3, 4.4), "kind": kind, "required": kind == "water"}
            for kind in ("power", "antenna", "data", "water")
        ],
    )
    solution = home.solve(brief, steps=500)
    drawn = write_svg(rooms.plan(scene_of(solution), shipped()))
    titles = ("power outlet", "antenna outlet", "data outlet", "water outlet, required", "Radiator")
    assert all(f"<title>{told}" in drawn for told in titles)
    without = write_svg(rooms.plan(scene_of(home.solve(room(), steps=500)), shipped()))
    assert "outlet" not in without


def test_homes_for_wheelchairs_and_halls_take_them_too() -> None:
    brief = room(**UNDER_WINDOW, outlets=[{"at": (6, 2), "kind": "power"}])
    accessible = Brief.model_validate(brief.model_dump() | {"accessible": True, "route_width": 0.9})
    assert check(home.solve(accessible, steps=1000)).valid
    hall = {
        "domain": "hall",
        "rooms": [
            {
                "name": "Hall",
                "outline": [(0, 0), (12, 0), (12, 9), (0, 9)],
                "doors": [{"at": (6, 0), "width": 2}],
                "radiators": [{"at": (0, 4), "width": 2}],
                "outlets": [{"at": (12, 4), "kind": "power"}],
                "demands": [{"category": "showcase", "count": 4}],
            }
        ],
    }
    solution = solve(Brief.model_validate(hall), steps=2000)
    assert sum(p.category == "radiator" for p in solution.pieces) == 1
    assert check(solution).valid
