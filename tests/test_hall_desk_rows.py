"""Desks of a class stand in rows before its screen, and who sits there looks at it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.domains.hall.demands.holdings import collect_demands
from scenewright.domains.hall.desks.rows import turn_to_show
from scenewright.domains.hall.seats.turns import count_away

DESKS: dict[str, Any] = {"id": "places", "category": "desk", "count": 16, "size": [1.2, 0.6, 0.74]}
SCREEN: dict[str, Any] = {"id": "screen", "category": "screen", "size": [2.4, 0.4, 2.4]}


def training_room(*demands: dict[str, Any]) -> Brief:
    room = {
        "name": "Training room",
        "outline": [[0, 0], [12, 0], [12, 8], [0, 8]],
        "doors": [{"at": [10.8, 0], "width": 1.0}, {"at": [0, 6.8], "width": 0.9, "use": "exit"}],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "rooms": [room]})


@pytest.mark.parametrize("seed", [0, 1, 2])
@pytest.mark.parametrize("said", [{"facing": "screen"}, {}])
def test_who_sits_at_desks_of_a_class_looks_at_the_screen(seed: int, said: dict[str, str]) -> None:
    lectern, shelves = {"category": "lectern"}, {"category": "shelf_unit", "count": 2}
    brief = training_room(SCREEN, lectern, DESKS | said, shelves)
    found = scenewright.solve(brief, seed=seed, threads=1)
    rows = {
        name: np.array(
            [(*p.pose[:2], p.pose.heading, *p.size[:2]) for p in found.pieces if p.category == name]
        )
        for name in ("office_chair", "desk", "screen")
    }
    assert len(rows["desk"]) == len(rows["office_chair"]) == 16
    assert count_away(rows["office_chair"], rows["screen"][0]) == 0
    assert scenewright.check(found).valid


def turned(*demands: dict[str, Any]) -> bool:
    asked = collect_demands(training_room(*demands), 0, (), catalog_of([]))
    return next(w.turned for w in turn_to_show(asked, catalog_of([])) if w.category == "desk")


def test_few_desks_those_for_advice_and_those_without_a_screen_are_no_class() -> None:
    assert turned(SCREEN, DESKS)
    assert not turned(SCREEN, DESKS | {"count": 4})
    assert turned(SCREEN, DESKS | {"count": 4, "facing": "screen"})
    assert not turned(SCREEN, DESKS | {"name": "travel advice"})
    assert not turned(DESKS)
