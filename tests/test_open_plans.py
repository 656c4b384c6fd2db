"""Open plans: every seating group can be sat in, large rooms are furnished whole and in zones."""

from __future__ import annotations

import math

import numpy as np
import pytest

import scenewright as sw
from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.catalog import Group
from scenewright.core.scene import Piece
from scenewright.domains.home.build_problem import RELATIONS, holds, items_of, scale_area_weights
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.furnishing.furnish import FurnishedPatch, pieces_of
from scenewright.domains.home.furnishing.high_walls import free_stretch
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.presets import HOME
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.walking.ways import find_unreached


def room(**more: object) -> Brief:
    wanted = {"name": "x", "outline": [[0, 0], [14, 0], [14, 12], [0, 12]]}
    wanted |= {"doors": [{"at": [12, 12], "width": 0.9}]}
    return Brief.model_validate({"rooms": [wanted | more]})


def stood(case: Group, function: str, x: float, y: float) -> tuple[Piece, ...]:
    box = np.array([x, y, math.pi / 2, case.width, case.depth])
    dressed = FurnishedPatch(case, box, tuple(True for _ in case.members), 0)
    return pieces_of(dressed, "x", "x/g", function, catalog_of([]))


@pytest.mark.parametrize("function", GROUPS)
def test_every_case_can_be_reached_in_a_large_empty_room(function: str) -> None:
    space = spaces(room())[0]
    ground, catalog = ground_of(space, (), 168.0), catalog_of([])
    for case in cases(function).groups:
        for x, y in ((6.0, 6.0), (5.987, 6.021)):
            far = find_unreached(ground, stood(case, function, x, y), catalog, 0.6)
            assert not far, case.name


def test_a_square_metre_weighs_as_much_in_a_room_of_much_furniture() -> None:
    few = items_of((Wish("sleeping", 0), Wish("wardrobe", 0)), 14.0)
    many = items_of(tuple(Wish(g, 0) for g in GROUPS), 90.0)
    assert scale_area_weights(HOME, few) == HOME
    heavier = scale_area_weights(HOME, many)
    share = float(many.wish.prod(-1).sum()) / 16.0
    assert share > 2
    assert heavier["keep_free"] == pytest.approx(share * HOME["keep_free"])
    assert heavier["pairs"] == HOME["pairs"]


def test_the_longest_stretch_of_wall_that_is_free() -> None:
    asked = room(
        outline=[[0, 0], [6, 0], [6, 3], [0, 3]],
        doors=[{"at": [0.6, 0], "width": 0.9, "swing": "none"}],
        windows=[{"at": [3, 3], "width": 1.0, "sill": 0.9}],
        slopes=[{"edge": 1, "knee": 1.9, "pitch": 0.5}],
    )
    ground = ground_of(spaces(asked)[0], (), 18.0)
    assert free_stretch(ground, 1.9) == pytest.approx(6 - 1.05, abs=0.25)
    assert free_stretch(ground, 2.3) < 4.4  # under the slope from x = 5.2 on
    assert free_stretch(ground, 0.8) == pytest.approx(6.0, abs=0.25)


def test_zones_of_open_plans_belong_together_only_there() -> None:
    far = next(r for r in RELATIONS if (r.first, r.second) == ("sleeping", "wardrobe"))
    assert holds(far, ["sleeping", "wardrobe", "kitchenette"])
    assert not holds(far, ["sleeping", "wardrobe", "chest"])


@pytest.mark.parametrize("seed", [0, 1])
def test_the_loft_reads_in_zones(seed: int) -> None:
    solution = sw.solve(sw.read("sample:home-loft"), seed=seed)
    report = sw.check(solution)
    assert report.valid
    assert not report.notes
    at = {p.category: np.array(p.pose[:2]) for p in solution.pieces if p.space == "loft"}
    cooking = [p for p in solution.pieces if p.function in ("kitchen", "kitchenette", "fridge")]
    floor = np.array([p.pose[:2] for p in cooking if p.pose.z < 0.05])
    assert np.ptp(floor, axis=0).max() < 5.0
    assert np.hypot(*(at["double_bed"] - (0.0, 4.2))) > 3.0  # the entrance
    sofa = next(at[name] for name in ("sofa", "corner_sofa", "loveseat") if name in at)
    assert np.hypot(*(at["tv"] - sofa)) < 4.0
    assert np.hypot(*(at["dining_table"] - floor.mean(0))) < 7.0
