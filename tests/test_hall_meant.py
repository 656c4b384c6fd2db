"""Halls hold what is meant: chairs that fit their table, stools at bars, tills without belts."""

from __future__ import annotations

import math
from collections import Counter
from typing import Any

import pytest

import scenewright
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains.hall.demands.stand_ins import offer_stand_in

BOX = [[0, 0], [12, 0], [12, 9], [0, 9]]


def lay_out(*demands: dict[str, Any], seed: int = 0, name: str = "Hall", **more: Any) -> Solution:
    room = {"name": name, "outline": BOX, "height": 4, "doors": [{"at": [2, 0], "width": 1.8}]}
    room |= {"demands": list(demands)} | more
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    return scenewright.solve(brief, seed=seed, steps=3000, threads=1)


def count(found: Solution) -> Counter[str]:
    return Counter(piece.category for piece in found.pieces)


@pytest.mark.parametrize(("wide", "chairs"), [(0.9, 4), (1.2, 6), (1.8, 8)])
def test_a_round_table_seats_one_for_each_six_tenths_of_its_edge(wide: float, chairs: int) -> None:
    found = lay_out({"category": "round_table", "count": 2, "size": [wide, wide, 0.74]})
    assert count(found)["dining_chair"] == 2 * chairs
    assert scenewright.check(found).valid


def test_nobody_sits_on_a_dining_chair_at_a_table_to_stand_at() -> None:
    found = lay_out({"category": "round_table", "count": 3, "size": [0.8, 0.8, 1.1]})
    assert count(found) == {"round_table": 3}


def test_chairs_asked_for_stand_at_the_low_of_two_kinds_of_tables() -> None:
    high = {"id": "high", "category": "round_table", "count": 2, "size": [0.8, 0.8, 1.1]}
    low = {"id": "low", "category": "round_table", "count": 2}
    found = lay_out(high, low, {"category": "dining_chair", "count": 8})
    chairs = [piece for piece in found.pieces if piece.category == "dining_chair"]
    assert len(chairs) == 8
    assert all("/low/" in chair.id for chair in chairs)


def test_bar_stools_stand_before_the_bar_and_round_high_tables() -> None:
    bar = {"category": "counter", "size": [3, 0.65, 1.1]}
    high = {"category": "round_table", "count": 2, "size": [0.8, 0.8, 1.1]}
    found = lay_out(bar, high, {"category": "bar_stool", "count": 6})
    tables = [p for p in found.pieces if p.category in ("counter", "round_table")]
    for stool in (piece for piece in found.pieces if piece.category == "bar_stool"):
        c, s = math.cos(stool.pose.heading), math.sin(stool.pose.heading)
        at = stool.pose.x + 0.3 * c, stool.pose.y + 0.3 * s
        assert any(math.dist(at, p.pose[:2]) <= 0.6 * p.size.width for p in tables), stool.id
    assert count(found)["bar_stool"] == 6
    assert scenewright.check(found).valid


def test_a_coffee_table_asked_for_is_the_one_the_seats_stand_round() -> None:
    found = lay_out({"category": "lounge_seat", "count": 4}, {"category": "coffee_table"})
    (table,) = (piece for piece in found.pieces if piece.category == "coffee_table")
    seats = [piece for piece in found.pieces if piece.category == "lounge_seat"]
    assert table.function == "coffee_table"
    assert all(math.dist(table.pose[:2], seat.pose[:2]) < 1.6 for seat in seats)
    assert not found.left_out


TILLS = {"category": "checkout", "count": 2}
CLOTHES = {"category": "clothes_rail", "count": 4}


@pytest.mark.parametrize(
    ("name", "demands", "model"),
    [
        ("Boutique", [{"category": "checkout"}, CLOTHES], "checkout_desk"),
        ("Boutique", [TILLS, CLOTHES], "checkout_desk"),
        ("Shop", [TILLS, CLOTHES, {"category": "fridge_shelf"}], "checkout"),
        ("Supermarket", [{"category": "checkout"}], "checkout"),
        ("Boutique", [{"category": "checkout", "size": [2.2, 1.2, 1.3]}], "checkout"),
    ],
)
def test_belts_are_for_groceries(name: str, demands: list[dict[str, Any]], model: str) -> None:
    found = lay_out(*demands, name=name)
    models = {p.asset for p in found.pieces if p.category == "checkout"}
    assert models
    assert all(one.startswith(model) for one in models)
    assert all(("desk" in one) == ("desk" in model) for one in models)


@pytest.mark.parametrize(
    ("category", "name", "asset"),
    [
        ("vending_machine", "cash machines", "vending_machine_cash"),
        ("vending_machine", "Fahrkartenautomaten", "vending_machine_tickets"),
        ("exhibit_island", "mammoth diorama", "exhibit_island_skeleton"),
        ("exhibit_island", "model of the town", "exhibit_island_scale_model"),
    ],
)
def test_a_thing_is_drawn_as_what_it_is_called(category: str, name: str, asset: str) -> None:
    found = shipped().choose_called(category, name)
    assert found is not None
    assert found.id == asset


def test_a_plain_vending_machine_sells_drinks() -> None:
    (machine,) = lay_out({"category": "vending_machine", "name": "drinks"}).pieces
    assert machine.asset == "vending_machine"


def test_other_goods_leave_a_row_to_what_fills_a_zone() -> None:
    """Racks and tables alone take more than half of the floor."""
    others = [
        {"id": "sale", "category": "round_rack", "count": 8},
        {"id": "knits", "category": "display_table", "count": 6},
    ]
    found = lay_out({"category": "clothes_rail", "fill": 0.5, "id": "rails"}, *others)
    assert count(found)["clothes_rail"] >= 3
    (note,) = (note for note in found.brief.notes if note.startswith("rails"))
    assert "sale 0." in note


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_the_main_exhibit_stands_amid_its_zone_beside_the_entrance(seed: int) -> None:
    ship = {"id": "ship", "category": "exhibit_island", "size": [4, 2, 2], "zone": "show"}
    cases = {"category": "showcase", "count": 8, "zone": "show"}
    zones = [
        {"id": "foyer", "outline": [[0, 0], [6, 0], [6, 14], [0, 14]]},
        {"id": "show", "outline": [[6, 0], [20, 0], [20, 14], [6, 14]]},
    ]
    outline, desk = [[0, 0], [20, 0], [20, 14], [0, 14]], {"category": "info_desk", "zone": "foyer"}
    found = lay_out(ship, cases, desk, seed=seed, outline=outline, zones=zones)
    (piece,) = (piece for piece in found.pieces if piece.function == "ship")
    assert math.dist(piece.pose[:2], (13.0, 7.0)) < 2.0
    assert scenewright.check(found).valid


def test_a_zone_smaller_than_asked_is_noted() -> None:
    zones = [{"id": "a", "area": 30}, {"id": "b", "outline": [[0, 0], [4, 0], [4, 9], [0, 9]]}]
    report = scenewright.check(lay_out({"category": "bench", "zone": "a"}, zones=zones))
    assert [n.message for n in report.notes if "asked" in n.message] == [
        "hall: a has 72.0 m², 30 m² asked"
    ]


def test_a_copier_stands_at_a_wall() -> None:
    (copier,) = lay_out({"category": "copier"}).pieces
    assert copier.asset == "copier"
    assert copier.size.height == pytest.approx(1.1)


def test_who_asks_for_a_photocopier_is_told_of_copiers() -> None:
    assert offer_stand_in("photocopiers", {}) == "use copier"
