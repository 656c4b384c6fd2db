"""What a brief leaves open is filled to the usual share of its theme, walls first."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.domains import check, plan_of, solve
from scenewright.domains.hall.demands.programme import PROGRAMMES
from scenewright.domains.hall.demands.themes import THEMES, guess_theme
from scenewright.domains.hall.zoning.zones import check_halls

FRONT = {"id": "front", "at": [2, 0], "width": 1.8}
BACK = {"id": "back", "at": [12, 5], "width": 1.8, "use": "exit"}


def hall(*demands: dict[str, object], name: str = "Shop", **more: object) -> Brief:
    """A hall of 12 by 10 m."""
    room = {
        "id": "hall",
        "name": name,
        "outline": [[0, 0], [12, 0], [12, 10], [0, 10]],
        "height": 4,
        "doors": [FRONT],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "name": "x", "rooms": [room | more]})


def counted(brief: Brief, category: str, preset: str = "default") -> int:
    solution = solve(brief, steps=400, threads=1, preset=preset)
    return sum(piece.category == category for piece in solution.pieces)


def test_every_theme_has_a_programme_and_goods_that_are_in_it() -> None:
    assert set(PROGRAMMES) == set(THEMES)
    for name, rows in PROGRAMMES.items():
        assert {row.category for row in rows} & set(THEMES[name].goods), name


def test_goods_without_a_number_fill_walls_and_floor() -> None:
    brief = hall({"category": "gondola"}, {"category": "wall_shelving"}, {"category": "checkout"})
    solution = solve(brief, steps=2000, threads=1)
    held = [piece.category for piece in solution.pieces]
    assert held.count("checkout") == 1
    assert held.count("gondola") > 4
    shelves = [piece for piece in solution.pieces if piece.category == "wall_shelving"]
    assert sum(piece.size.width for piece in shelves) > 0.5 * 44
    assert not check(solution).findings
    assert not solution.left_out


@pytest.mark.parametrize("goods", ["gondola", "clothes_rail", "showcase"])
def test_goods_line_the_walls_where_shelves_are_counted(goods: str) -> None:
    brief = hall({"category": goods}, {"category": "wall_shelving", "count": 4})
    solution = solve(brief, steps=800, threads=1)
    backs = [
        (p.pose.x - c * p.size.depth / 2, p.pose.y - s * p.size.depth / 2, p)
        for p in solution.pieces
        for c, s in [(np.cos(p.pose.heading), np.sin(p.pose.heading))]
        if p.category in (goods, "wall_shelving")
    ]
    at_walls = [p for x, y, p in backs if min(x, y, 12 - x, 10 - y) < 0.2]
    assert sum(p.size.width for p in at_walls) > 0.6 * 42
    assert any(p.category == goods for *_, p in backs if p not in at_walls)
    assert sum(p.category == "wall_shelving" for p in solution.pieces) == 4
    assert not check(solution).findings


@pytest.mark.parametrize(
    ("demand", "room"),
    [({"fill": "none"}, {}), ({}, {"fill": "none"}), ({"count": 1}, {}), ({"length": 1.3}, {})],
)
def test_who_refuses_or_states_a_number_gets_it(
    demand: dict[str, object], room: dict[str, object]
) -> None:
    brief = hall({"category": "gondola", **demand}, **room)
    assert counted(brief, "gondola") == 1


def test_as_printed_a_number_left_open_is_one() -> None:
    assert counted(hall({"category": "gondola"}), "gondola", "paper") == 1


def test_a_share_of_the_room_takes_the_place_of_the_usual_one() -> None:
    few, usual = (
        counted(hall({"category": "gondola"}, **m), "gondola") for m in ({"fill": 0.2}, {})
    )
    assert 1 < few < usual


def test_a_stated_theme_adds_what_is_not_named() -> None:
    brief = hall({"category": "showcase", "count": 2}, name="Room", theme="museum")
    solution = solve(brief, steps=800, threads=1)
    held = [piece.category for piece in solution.pieces]
    assert held.count("showcase") == 2
    assert held.count("wall_exhibit") > 3
    assert "info_desk" in held
    assert not check(solution).findings


@pytest.mark.parametrize("theme", ["castle", "x"])
def test_an_unknown_theme_is_refused(theme: str) -> None:
    brief = hall(theme=theme)
    with pytest.raises(InputError, match="is not a theme of halls"):
        check_halls(brief, plan_of(brief))


def test_homes_have_no_theme() -> None:
    document = hall(theme="museum").model_dump(mode="json") | {"domain": "home"}
    document["rooms"][0] |= {"demands": [], "zones": []}
    with pytest.raises(InputError, match="theme"):
        plan_of(Brief.model_validate(document))


@pytest.mark.parametrize(
    ("names", "asked", "theme"),
    [
        (["Car showroom"], [], "showroom"),
        (["Shop"], ["clothes_rail"], "generic"),
        (["Hall"], ["auditorium_seat", "round_table"], ""),
        (["Hall"], ["stage"], ""),
    ],
)
def test_themes_are_guessed(names: list[str], asked: list[str], theme: str) -> None:
    assert guess_theme(names, asked) == theme


def church() -> Solution:
    altar = {"category": "stage", "size": [4, 2.5, 0.4]}
    return solve(
        hall(altar, {"category": "pew", "count": 16}, name="Church"), steps=2000, threads=1
    )


def test_pews_look_at_the_altar_at_their_pitch() -> None:
    solution = church()
    pews = [piece for piece in solution.pieces if piece.category == "pew"]
    [altar] = [piece for piece in solution.pieces if piece.category == "stage"]
    assert len(pews) == 16
    for pew in pews:
        way = np.array([altar.pose.x - pew.pose.x, altar.pose.y - pew.pose.y])
        look = np.array([np.cos(pew.pose.heading), np.sin(pew.pose.heading)])
        assert way @ look > 0.4 * np.hypot(*way)
    look = np.array([np.cos(pews[0].pose.heading), np.sin(pews[0].pose.heading)])
    steps = np.diff(np.sort([np.array(pew.pose[:2]) @ look for pew in pews]))
    assert ((steps < 0.02) | (np.abs(steps - 0.95) < 0.15)).all()
    assert (steps > 0.5).sum() > 2


def test_one_boards_at_the_door_one_only_leaves_by() -> None:
    asked = (
        {"category": "counter"},
        {"category": "ticket_gate", "count": 2},
        {"category": "auditorium_seat", "count": 20},
    )
    brief = hall(*asked, name="Gate", doors=[FRONT | {"use": "entrance"}, BACK])
    solution = solve(brief, steps=800, threads=1)
    for piece in solution.pieces:
        if piece.category in ("counter", "ticket_gate"):
            assert np.hypot(piece.pose.x - 12, piece.pose.y - 5) < 5.0
    assert not check(solution).findings
    assert not solution.left_out
