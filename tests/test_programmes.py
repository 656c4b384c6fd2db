"""What a kind of shop on an indoor map holds."""

from __future__ import annotations

import math

import pytest

from scenewright.catalog.assets import shipped
from scenewright.catalog.kinds import SIZES
from scenewright.core.brief import Room
from scenewright.core.scene import Size
from scenewright.domains.hall.demands.programme import (
    PROGRAMMES,
    SMALLEST_SHOP,
    shop_kind,
    shop_programme,
)
from scenewright.domains.hall.demands.themes import THEMES
from scenewright.domains.hall.desks.cash_desks import is_cash_desk, measure_cash_desk

# Programmes


def used(kind: str, floor_area: float, perimeter: float) -> float:
    total = 0.0
    for demand in shop_programme(kind, floor_area, perimeter):
        assert demand.count
        if demand.clearance is None:  # generated at its door, with the floor it needs
            rows = (row for row in PROGRAMMES[kind] if row.category == demand.category)
            total += demand.count * max(row.used for row in rows)
            continue
        assert isinstance(demand.clearance, tuple)
        front, left, back, right = demand.clearance
        till = measure_cash_desk(shipped())
        width, depth, _ = demand.size or (
            till if demand.category == "checkout" else SIZES[demand.category][1]
        )
        total += demand.count * (width + left + right) * (depth + front + back)
    return total / floor_area


@pytest.mark.parametrize("kind", PROGRAMMES)
@pytest.mark.parametrize("floor_area", [30, 47, 80, 150, 600, 3000])
def test_the_usual_share_of_the_floor_is_used(kind: str, floor_area: float) -> None:
    share, most = used(kind, floor_area, 4.4 * math.sqrt(floor_area)), THEMES[kind].fill
    one = max(row.used for row in PROGRAMMES[kind] if row.fills) / floor_area
    assert most - one - 0.02 <= share <= most + 0.02
    ids = [d.id for d in shop_programme(kind, floor_area, 4.4 * math.sqrt(floor_area))]
    assert len(ids) == len(set(ids))


def test_everything_is_in_the_catalog_at_its_size() -> None:
    for row in (row for rows in PROGRAMMES.values() for row in rows):
        asset = shipped().choose(row.category, Size(*row.size))
        assert asset is not None, row.category
        sizes = zip(asset.smallest, row.size, asset.largest, strict=True)
        assert all(low <= size <= high for low, size, high in sizes), row.category


def test_no_programme_is_too_large_to_lay_out() -> None:
    for kind in PROGRAMMES:
        assert sum(demand.count or 0 for demand in shop_programme(kind, 90_000, 1_200)) < 10_000


def test_walls_hold_what_stands_at_them() -> None:
    for kind in PROGRAMMES:
        wall = sum(
            (d.count or 0) * (d.size or SIZES[d.category][1])[0]
            for d in shop_programme(kind, 400, 80)
            if d.place == "wall"
        )
        assert wall <= THEMES[kind].walls * 80 + 1e-9


def test_small_and_unknown_units_hold_nothing() -> None:
    assert shop_programme("clothes", SMALLEST_SHOP - 0.01, 22) == []
    assert shop_programme("", 100, 40) == []
    assert shop_programme("castle", 100, 40) == []


@pytest.mark.parametrize(
    ("tags", "kind"),
    [
        ({"shop": "supermarket"}, "grocery"),
        ({"shop": "bakery", "amenity": "cafe"}, "food"),
        ({"room": "shop"}, "generic"),
        ({"room": "shop", "shop": "vacant"}, ""),
        ({"room": "disused", "shop": "toys"}, ""),
        ({"amenity": "toilets"}, ""),
        ({"amenity": "library"}, "library"),
        ({"shop": " Books ; toys"}, "books"),
    ],
)
def test_kinds_by_tags(tags: dict[str, str], kind: str) -> None:
    assert shop_kind(tags) == kind


@pytest.mark.parametrize(
    ("kind", "desks"), [(k, k != "grocery") for k in ("clothes", "books", "generic", "grocery")]
)
def test_only_groceries_have_tills_with_belts(kind: str, desks: bool) -> None:
    demands = shop_programme(kind, 600.0, 100.0)
    tills = next(demand for demand in demands if demand.category == "checkout")
    assert tills.count
    assert tills.count > 1
    room = Room(name="Shop", outline=[(0, 0), (30, 0), (30, 20)], demands=demands)
    assert is_cash_desk(tills, room) is desks


@pytest.mark.parametrize(("area", "every"), [(110.0, 0), (900.0, 10)])
def test_long_rows_of_goods_have_aisles_across(area: float, every: int) -> None:
    rows = next(d for d in shop_programme("books", area, 100.0) if d.category == "book_stack")
    assert (rows.aisle.every if rows.aisle else 0) == every
