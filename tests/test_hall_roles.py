"""Desks at their doors, closed behind, altars at the far wall, and islands in empty floor."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import shapely

from scenewright.building import plan
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.solution import Solution
from scenewright.domains import check
from scenewright.domains.hall.demands.themes import THEMES
from scenewright.domains.hall.furnishing.voids import fill_voids
from scenewright.domains.hall.solving import hall_contexts, solve


def lay(demands: list[dict[str, Any]], **room: Any) -> Solution:
    wide, deep = room.pop("sides", (10.0, 12.0))
    hall: dict[str, Any] = {
        "name": "Hall",
        "outline": [[0, 0], [wide, 0], [wide, deep], [0, deep]],
        "doors": [{"id": "street", "at": [wide / 2, 0], "width": 1.8, "swing": "slide"}],
        "demands": demands,
    }
    brief = {"domain": "hall", "name": "Hall", "rooms": [hall | room]}
    return solve(Brief.model_validate(brief), steps=1500, threads=1)


@pytest.mark.parametrize(
    ("category", "theme", "far"),
    [("info_desk", "library", 6.0), ("checkout", "clothes", 5.0), ("counter", "food", 12.5)],
)
def test_a_desk_looks_to_its_door_and_its_staff_is_shut_off(
    category: str, theme: str, far: float
) -> None:
    solution = lay([{"category": category}, {"category": "round_table", "count": 2}], theme=theme)
    [desk] = [p for p in solution.pieces if p.category == category]
    to_door = np.array([5.0 - desk.pose.x, 2.5 - desk.pose.y])
    ahead = np.array([math.cos(desk.pose.heading), math.sin(desk.pose.heading)])
    assert math.hypot(5.0 - desk.pose.x, desk.pose.y) < far
    assert to_door @ ahead > -0.3 * np.hypot(*to_door)
    behind = shapely.Point(np.array(desk.pose[:2]) - (0.5 * desk.size.depth + 0.4) * ahead)
    [space] = plan.spaces(solution.brief)
    hall = shapely.Polygon(space.outline)
    closing = [p for p in solution.pieces if p.category in ("gate_leaf", "glass_barrier")]
    solid = shapely.union_all(polygons_of([desk, *closing])).buffer(0.06)
    rooms = shapely.get_parts(hall.buffer(-0.05).difference(solid))
    [mine] = [part for part in rooms if part.contains(behind)]
    assert mine.area < 4.0
    assert not check(solution).findings


def test_an_altar_of_ones_own_stands_at_the_far_wall_with_pews_before_it() -> None:
    altar = {"category": "box", "name": "High altar", "size": [1.8, 0.8, 1.0]}
    solution = lay([altar, {"category": "pew", "count": 8}], theme="worship", sides=(9.0, 16.0))
    [shown] = [p for p in solution.pieces if p.category == "box"]
    pews = [p for p in solution.pieces if p.category == "pew"]
    assert not [p for p in solution.pieces if p.category == "stage"]
    assert shown.pose.x == pytest.approx(4.5, abs=0.01)
    assert shown.pose.y > 13.0
    assert len(pews) == 8
    assert all(math.sin(p.pose.heading) > 0.99 and p.pose.y < shown.pose.y for p in pews)
    assert not check(solution).findings


def test_islands_stand_in_empty_floor_off_the_way_in() -> None:
    room = {"name": "Hall", "outline": [(0, 0), (14, 0), (14, 14), (0, 14)], "demands": []}
    room |= {"doors": [{"id": "street", "at": (7, 0), "width": 1.8, "swing": "slide"}]}
    brief = Brief.model_validate({"domain": "hall", "name": "Hall", "rooms": [room]})
    [hall] = hall_contexts(brief, plan.spaces(brief), catalog_of([]), 0, 0)
    assert not fill_voids(hall, (), catalog_of([]))
    found = fill_voids(hall._replace(island=THEMES["museum"].island), (), catalog_of([]))
    assert len(found) >= 6
    assert all(math.hypot(piece.pose.x - 7.0, piece.pose.y) > 1.5 for piece in found)
    bodies = shapely.union_all(polygons_of(found))
    assert shapely.box(0, 0, 14, 14).contains(bodies)


def test_doors_called_after_who_works_there_are_not_the_way_in() -> None:
    doors = [
        {"id": "workshop", "at": [10, 9], "width": 3.0, "swing": "slide"},
        {"id": "front", "at": [3, 0], "width": 1.8, "swing": "slide"},
    ]
    solution = lay([{"category": "info_desk"}], theme="showroom", doors=doors)
    [desk] = [p for p in solution.pieces if p.category == "info_desk"]
    assert math.hypot(desk.pose.x - 3.0, desk.pose.y) < math.hypot(
        desk.pose.x - 10, desk.pose.y - 9
    )


def test_goods_that_staff_hands_over_stand_behind_its_counter() -> None:
    bread = {"category": "wall_shelving", "name": "bread", "count": 3}
    solution = lay([{"category": "counter", "count": 2}, bread], theme="food")
    goods = [p for p in solution.pieces if p.category == "wall_shelving"]
    desks = [p for p in solution.pieces if p.category == "counter"]
    assert len(goods) == 3
    for piece in goods:
        near = min(desks, key=lambda d: math.dist(d.pose[:2], piece.pose[:2]))
        ahead = np.array([math.cos(near.pose.heading), math.sin(near.pose.heading)])
        off = np.subtract(near.pose[:2], piece.pose[:2])
        assert piece.pose.heading == pytest.approx(near.pose.heading)
        assert off @ ahead == pytest.approx(0.95 + 0.5 * (near.size.depth + piece.size.depth))
    assert not check(solution).findings


def test_a_box_of_ones_own_is_drawn_as_the_thing_it_is_called() -> None:
    sizes = {"car": (4.4, 1.8, 1.5), "leather sofa": (2.0, 0.9, 0.8), "sofa": (0.3, 0.3, 0.3)}
    boxes = [
        {"category": "box", "id": f"own{k}", "name": name, "size": size}
        for k, (name, size) in enumerate(sizes.items())
    ]
    drawn = {p.function: p.asset for p in lay(boxes).pieces}
    assert drawn["own0"].startswith("exhibit_island_car")
    assert drawn["own1"].startswith("sofa")
    assert drawn["own2"] == "box"


def test_a_hall_without_doors_is_walked_from_its_roomiest_floor() -> None:
    shelves = {"category": "wall_shelving", "count": 26}
    solution = lay([shelves, {"category": "checkout", "count": 3}], doors=[])
    assert len([p for p in solution.pieces if p.category == "wall_shelving"]) == 26
    assert not check(solution).findings
