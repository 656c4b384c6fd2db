"""Counters keep the floor of the bar stools that are asked for beside them."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import pytest

import scenewright
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.domains.hall.accessories.stools import OFF
from scenewright.domains.hall.demands.holdings import collect_demands
from scenewright.domains.hall.desks.stools import keep_stools

BAR: dict[str, Any] = {"category": "counter", "size": [4.0, 0.8, 1.1], "place": "wall"}
STOOLS: dict[str, Any] = {"category": "bar_stool", "count": 4}
TABLES: dict[str, Any] = {"category": "round_table", "count": 6, "size": [0.8, 0.8, 0.74]}


def cafe(*demands: dict[str, Any]) -> Brief:
    room = {
        "name": "Cafe",
        "outline": [[0, 0], [12, 0], [12, 8], [0, 8]],
        "doors": [{"at": [2, 0], "width": 1.2}, {"at": [12, 4], "width": 1.2}],
        "zones": [],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "name": "Cafe", "rooms": [room]})


def test_counters_are_as_much_deeper_as_stools_take() -> None:
    asked = collect_demands(cafe(BAR, STOOLS, TABLES), 0, (), catalog_of([]))
    bar, stools, tables = keep_stools(asked)
    assert bar.before == pytest.approx(stools.sizes[0].depth + OFF)
    assert bar.sizes[0].depth == pytest.approx(0.8 + bar.before)
    assert tables == asked[2]


def test_no_more_counters_keep_floor_than_stools_need() -> None:
    second = BAR | {"id": "second"}
    asked = collect_demands(cafe(BAR, second, STOOLS), 0, (), catalog_of([]))
    first, other, _ = keep_stools(asked)
    assert first.before
    assert not other.before


@pytest.mark.parametrize("seed", [59, 61, 67])
def test_stools_stand_at_the_bar_among_many_tables(seed: int) -> None:
    more = {"category": "dining_table", "count": 3}
    found = scenewright.solve(cafe(BAR, STOOLS, TABLES, more), seed=seed, threads=1)
    (bar,) = (piece for piece in found.pieces if piece.category == "counter")
    stools = [piece for piece in found.pieces if piece.category == "bar_stool"]
    assert len(stools) == 4
    assert bar.size.depth == pytest.approx(0.8)
    for stool in stools:
        across = abs(stool.pose.x - bar.pose.x), abs(stool.pose.y - bar.pose.y)
        gap = min(across) if max(across) < 0.5 * bar.size.width else max(across)
        assert gap < 0.5 * (bar.size.depth + stool.size.depth) + 2 * OFF
    assert scenewright.check(found).valid


def test_what_may_help_is_said_where_no_stool_finds_a_place() -> None:
    found = scenewright.solve(cafe(BAR, STOOLS | {"count": 24}), seed=59, threads=1)
    assert all("longer counter" in lost.reason for lost in found.left_out)


def test_stools_stand_closer_where_all_find_a_place_at_the_counter_so() -> None:
    short = BAR | {"size": [3.0, 0.7, 1.1]}
    found = scenewright.solve(cafe(short, STOOLS, TABLES), seed=59, threads=1)
    (bar,) = (piece for piece in found.pieces if piece.category == "counter")
    stools = [piece for piece in found.pieces if piece.category == "bar_stool"]
    assert len(stools) == 4
    assert all(math.dist(stool.pose[:2], bar.pose[:2]) < 1.5 for stool in stools)


def test_no_stool_stands_by_itself_where_the_counter_has_no_more_places() -> None:
    short = BAR | {"size": [2.0, 0.7, 1.1]}
    found = scenewright.solve(cafe(short, STOOLS), seed=59, threads=1)
    (bar,) = (piece for piece in found.pieces if piece.category == "counter")
    stools = [piece for piece in found.pieces if piece.category == "bar_stool"]
    assert len(stools) == 2
    assert all(math.dist(stool.pose[:2], bar.pose[:2]) < 1.5 for stool in stools)
    (lost,) = found.left_out
    assert "longer counter" in lost.reason


HIGH: dict[str, Any] = {"category": "dining_table", "count": 1, "size": [1.8, 0.6, 1.05]}


def test_stools_stand_at_a_high_table_not_where_bread_is_sold() -> None:
    bread = BAR | {"id": "bread", "name": "bread counter"}
    found = scenewright.solve(cafe(bread, HIGH, STOOLS, TABLES), seed=59, threads=1)
    (table,) = (p for p in found.pieces if p.category == "dining_table")
    stools = [piece for piece in found.pieces if piece.category == "bar_stool"]
    assert len(stools) == 4
    assert all(math.dist(stool.pose[:2], table.pose[:2]) < 1.2 for stool in stools)
    assert scenewright.check(found).valid


def test_high_tables_keep_the_floor_of_stools_that_a_bar_has_no_place_for() -> None:
    bar = BAR | {"id": "bar"}
    for count, sides in ((4, 0.0), (7, 2 * OFF)):
        brief = cafe(bar, HIGH, STOOLS | {"count": count})
        _, table, stools = keep_stools(collect_demands(brief, 0, (), catalog_of([])))
        deep = 2 * stools.sizes[0].depth if sides else 0.0
        assert table.sizes[0].depth == pytest.approx(0.6 + sides + deep)
        assert table.sizes[0].width == pytest.approx(1.8)


@pytest.mark.parametrize("count", [2, 3])
def test_few_stools_stand_evenly_along_the_middle_of_a_bar(count: int) -> None:
    found = scenewright.solve(cafe(BAR, STOOLS | {"count": count}), seed=59, threads=1)
    (bar,) = (piece for piece in found.pieces if piece.category == "counter")
    way = (math.sin(bar.pose.heading), -math.cos(bar.pose.heading))
    along = sorted(
        sum((a - b) * w for a, b, w in zip(piece.pose[:2], bar.pose[:2], way, strict=True))
        for piece in found.pieces
        if piece.category == "bar_stool"
    )
    assert len(along) == count
    assert sum(along) == pytest.approx(0.0, abs=1e-6)
    steps = [after - before for before, after in pairwise(along)]
    assert steps == pytest.approx([steps[0]] * len(steps), abs=1e-6)


def test_counters_side_by_side_are_one_bar_to_sit_at() -> None:
    parts = BAR | {"name": "Ramen bar", "count": 3, "size": [1.6, 0.6, 1.05]}
    found = scenewright.solve(cafe(parts, STOOLS | {"count": 7}, TABLES), seed=59, threads=1)
    stools = [piece.pose[:2] for piece in found.pieces if piece.category == "bar_stool"]
    assert len(stools) == 7
    along = max(stools[0], stools[-1], key=lambda at: at[0]), min(stools, key=lambda at: at[0])
    way = 0 if abs(along[0][0] - along[1][0]) > 0.5 else 1
    places = sorted(at[way] for at in stools)
    assert max(b - a for a, b in pairwise(places)) < 0.9
    assert scenewright.check(found).valid


def test_without_a_counter_stools_stand_at_high_tables_with_something_on_them() -> None:
    charging = {"category": "display_table", "count": 2, "size": [2.0, 0.7, 1.05]}
    found = scenewright.solve(cafe(charging, STOOLS), seed=59, threads=1)
    tables = [piece for piece in found.pieces if piece.category == "display_table"]
    stools = [piece for piece in found.pieces if piece.category == "bar_stool"]
    assert (len(tables), len(stools)) == (2, 4)
    for stool in stools:
        assert min(math.dist(stool.pose[:2], table.pose[:2]) for table in tables) < 1.2
    assert scenewright.check(found).valid


@pytest.mark.parametrize("seed", [59, 61])
def test_few_stools_stand_amid_the_sides_of_a_long_high_table(seed: int) -> None:
    table = {"category": "display_table", "count": 1, "size": [3.0, 0.9, 1.05]}
    found = scenewright.solve(cafe(table, STOOLS, TABLES), seed=seed, threads=1)
    (long,) = (piece for piece in found.pieces if piece.category == "display_table")
    right = math.sin(long.pose.heading), -math.cos(long.pose.heading)
    off = [
        (p.pose.x - long.pose.x) * right[0] + (p.pose.y - long.pose.y) * right[1]
        for p in found.pieces
        if p.category == "bar_stool"
    ]
    assert sorted(off) == pytest.approx([-0.45, -0.45, 0.45, 0.45])
