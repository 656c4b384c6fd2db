"""Kitchens in one place: their parts stand side by side, and others keep off all their lines."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.core.piece_outlines import polygons_of
from scenewright.domains import check
from scenewright.domains.home.composing.judging import judge_of
from scenewright.domains.home.composing.kitchens.second_runs import list_given_up, price_of_spare
from scenewright.domains.home.composing.seats.lounges import _list_staying
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import prepare_rooms, solve
from scenewright.domains.home.wheelchair import furnish_by_use
from scenewright.engine.solve import Budget

KITCHENS = [
    ([3.4, 3.0], [2.6, 0.0], [1.6, 3.0]),
    ([4.2, 2.8], [0.6, 0.0], [4.2, 1.4]),
    ([3.6, 3.6], [3.6, 0.7], [1.8, 3.6]),
]
UNITS = (
    "sink_cabinet",
    "hob_cabinet",
    "fridge",
    "base_cabinet",
    "drawer_cabinet",
    "corner_cabinet",
    "dishwasher",
)


def room(size, door, window):
    wide, deep = size
    outline = [[0, 0], [wide, 0], [wide, deep], [0, deep]]
    doors, windows = [{"at": door, "width": 0.8}], [{"at": window, "width": 1.0, "sill": 1.0}]
    stated = {"function": "kitchen", "outline": outline, "doors": doors, "windows": windows}
    return Brief(rooms=[Room(id="kitchen", **stated)])


@pytest.mark.parametrize("stated", KITCHENS)
def test_sink_hob_and_fridge_stand_side_by_side_where_the_walls_hold_them(stated):
    home = solve(room(*stated), seed=0, threads=1)
    units = [p for p in home.pieces if p.category in UNITS and p.pose.z < 0.3]
    lots = shapely.get_parts(shapely.union_all(polygons_of(units)).buffer(0.05))
    holding = {
        k
        for k, lot in enumerate(lots)
        for p in units
        if p.category in UNITS[:3] and lot.contains(shapely.Point(p.pose[:2]))
    }
    assert {p.category for p in units}.issuperset(UNITS[:3])
    assert len(holding) == 1
    assert check(home).valid


def furnished():
    brief = room(*KITCHENS[0])
    task = prepare_rooms(brief, spaces(brief), catalog_of(()), PRESETS["default"], "anneal", 0)[0][
        0
    ]
    answer = furnish_by_use(task, (Wish("kitchen", 0), Wish("counter", 2)), Budget(1, steps=2000))
    return task, answer.placed


def test_what_is_put_onto_a_unit_of_a_kitchen_keeps_it_from_staying():
    task, placed = furnished()
    run = next(p for p in placed if p.wish.group == "kitchen")
    away = run.dressed.box - np.array([9.0, 0, 0, 0, 0])
    shifted = run._replace(dressed=run.dressed._replace(box=away))
    judge = judge_of(task, (run,))

    def stays_beside(x, y):
        box = np.array([x, y, 0.0, 0.2, 0.2])
        seats = run._replace(dressed=run.dressed._replace(box=box))
        return bool(_list_staying(judge.cost_of((seats,)), [shifted]))

    low = [piece for piece in run.pieces if piece.pose.z < 0.3]
    assert low
    assert not any(stays_beside(*piece.pose[:2]) for piece in low)
    assert stays_beside(20.0, 20.0)


def test_second_runs_that_gave_way_are_priced_and_listed():
    task, placed = furnished()
    rule = task.preset.settings.composing
    without = tuple(p for p in placed if p.wish.group != "counter")
    gone = len(placed) - len(without)
    assert gone == 1
    assert price_of_spare(placed, without, rule) == rule.addition
    assert price_of_spare(placed, placed, rule) == 0
    (lost,) = list_given_up(placed, without, "the kitchen takes its wall")
    assert lost.wish.group == "counter"


@pytest.mark.parametrize(("units", "made"), [(3, False), (1, True)])
def test_a_run_of_units_that_stands_is_the_kitchen(units: int, made: bool) -> None:
    """Nobody builds a second kitchen before units that a plan has; one cabinet is no kitchen."""
    brief = room([3.4, 3.0], [2.6, 0.0], [1.6, 3.0])
    fixed = [
        {"category": "base_cabinet", "at": [0.31, 0.4 + 0.7 * k], "size": [0.7, 0.6, 0.9]}
        | {"heading": 0.0}
        for k in range(units)
    ]
    stated = brief.model_dump(mode="json", exclude_none=True)
    stated["rooms"][0]["fixed"] = fixed
    home = solve(Brief.model_validate(stated), steps=20, seed=0, threads=1)
    assert ("hob_cabinet" in {piece.category for piece in home.pieces}) is made
