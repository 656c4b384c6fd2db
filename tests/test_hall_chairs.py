"""Tables that bring chairs: placed with them, so that one can sit at every one."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import shapely

import scenewright
from scenewright.catalog.assets import shipped
from scenewright.catalog.kinds import KINDS
from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.hall.demands.holdings import SEATWAY, collect_demands
from scenewright.domains.hall.seats.chairs import out_of_table


def cafe(*more: dict[str, Any], tables: int = 8, **table: Any) -> Brief:
    room = {
        "name": "Cafe",
        "outline": [[0, 0], [12, 0], [12, 8], [0, 8]],
        "doors": [{"at": [2, 0], "width": 1.2}],
        "demands": [{"category": "dining_table", "count": tables, **table}, *more],
    }
    return Brief.model_validate({"domain": "hall", "name": "Cafe", "rooms": [room]})


def chairs_of(found: Solution) -> list[Piece]:
    return [piece for piece in found.pieces if piece.category == "dining_chair"]


def footprint(piece: Piece) -> shapely.Polygon:
    row = [piece.pose.x, piece.pose.y, piece.pose.heading, piece.size.width, piece.size.depth]
    return shapely.Polygon(corners(np.array([row]))[0])


@pytest.mark.parametrize("seed", range(4))
def test_all_chairs_of_a_cafe_stand_in_it_and_are_reached(seed: int) -> None:
    found = scenewright.solve(cafe({"category": "info_desk"}), seed=seed)
    assert len(chairs_of(found)) == 8 * 4
    assert not found.left_out
    floor = shapely.box(0, 0, 12, 8)
    assert all(floor.contains(footprint(chair)) for chair in chairs_of(found))
    report = scenewright.check(found)
    assert report.valid, report.findings


@pytest.mark.parametrize("long", [1.2, 1.6, 2.4])
def test_chairs_stand_in_their_zone(long: float) -> None:
    brief = cafe(tables=3, size=[long, 0.8, 0.74], zone="east")
    zones = [{"id": "west"}, {"id": "east", "area": 32}]
    rooms = brief.model_dump(mode="json")["rooms"]
    found = scenewright.solve(
        Brief.model_validate({"domain": "hall", "rooms": [rooms[0] | {"zones": zones}]}), seed=1
    )
    assert found.detail is not None
    east = next(shapely.Polygon(z.outline) for z in found.detail.layout.zones if z.id == "east")
    company = KINDS["dining_table"].chairs
    assert company is not None
    count = 2 * int(long / company.pitch)
    assert len(chairs_of(found)) == 3 * count
    assert all(east.buffer(1e-3).contains(footprint(chair)) for chair in chairs_of(found))
    assert scenewright.check(found).valid


def test_the_tour_goes_round_chairs() -> None:
    found = scenewright.solve(cafe({"category": "info_desk"}), seed=0)
    tour = scenewright.check(found).figures["halls"]["cafe"]["tour"]
    assert tour["least_width"] > 0.8
    assert not tour["groups_missed"]


def test_a_table_keeps_its_size_and_asks_for_floor_with_its_chairs() -> None:
    """The floor is the box round table and chairs; clearances are counted from the table."""
    brief = cafe(size=[1.6, 0.9, 0.74], clearance=[1.2, 0.3, 0.6, 0.3])
    out = out_of_table("dining_table", set(), shipped())
    wish = collect_demands(brief, 0, (), shipped())[0]
    assert {size.depth for size in wish.sizes} == {0.9 + 2 * out}
    assert wish.clearance == pytest.approx((1.2 - out, 0.3, SEATWAY, 0.3))
    found = scenewright.solve(brief, seed=3)
    tables = [piece for piece in found.pieces if piece.category == "dining_table"]
    assert {piece.size for piece in tables} == {(1.6, 0.9, 0.74)}
    for table in tables:
        mine = [footprint(c) for c in chairs_of(found) if c.id.startswith(table.id + "/")]
        away = [abs(_along(table, shape)) for shape in mine]
        assert max(away) == pytest.approx(0.45 + out)
        assert len(mine) == 4


def _along(table: Piece, shape: shapely.Polygon) -> float:
    """How far a shape reaches from the middle of a table, along its front and back."""
    way = np.array([math.cos(table.pose.heading), math.sin(table.pose.heading)])
    return float(np.abs((shapely.get_coordinates(shape) - table.pose[:2]) @ way).max())


def test_tables_stand_alone_where_chairs_are_asked_for() -> None:
    brief = cafe({"category": "dining_chair", "count": 6}, tables=2)
    table = collect_demands(brief, 0, (), shipped())[0]
    assert table.chairs == 0.0
    assert {size.depth for size in table.sizes} == {0.9}


@pytest.mark.parametrize("seed", range(3))
def test_chairs_stand_on_all_sides_of_round_tables_and_look_at_them(seed: int) -> None:
    brief = cafe(tables=6, category="round_table", size=[0.9, 0.9, 0.74])
    found = scenewright.solve(brief, seed=seed, steps=1000, threads=1)
    tables = {p.id: p for p in found.pieces if p.category == "round_table"}
    assert len(tables) == 6
    assert len(chairs_of(found)) == 24
    for chair in chairs_of(found):
        table = tables[chair.id.rpartition("/")[0]]
        far = np.subtract(table.pose[:2], chair.pose[:2])
        ahead = np.cos(chair.pose.heading), np.sin(chair.pose.heading)
        assert np.hypot(*far) == pytest.approx(0.45 + 0.25 - 0.1)
        assert far @ ahead == pytest.approx(np.hypot(*far))
    report = scenewright.check(found)
    assert report.valid, report.findings


def test_reading_tables_have_their_chairs_however_high_their_lamps():
    asset = shipped().of("reading_table")[0]
    assert asset.usual[2] > 1.0
    assert out_of_table("reading_table", (), shipped(), asset.usual[2]) > 0.0
    assert out_of_table("dining_table", (), shipped(), 1.1) == 0.0
    hall = scenewright.solve(scenewright.read("sample:hall-reading-room"), seed=0)
    tables = [p for p in hall.pieces if p.category == "reading_table"]
    chairs = [p for p in hall.pieces if p.category == "reading_chair"]
    assert len(chairs) >= 4 * len(tables) > 0
