"""Uses of buildings: by tags, by models, as wished for; and how houses are drawn by them."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.catalog.assets.buildings.house_looks import FORMS, LOOKS, asset_of_house
from scenewright.core.brief import Brief
from scenewright.core.brief.uses import USES, UseWish
from scenewright.core.errors import InputError
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import plan_of
from scenewright.domains.village.house import is_outbuilding
from scenewright.domains.village.library import our_houses
from scenewright.domains.village.uses import meet_uses, use_of_house
from scenewright.ground.buildings.dressing import ShopGround, dress, find_shop_fronts, share_walls
from scenewright.ground.buildings.use_wishes import dress_by_wish
from scenewright.ground.buildings.use_words import TAG_OF_USE, use_of_tags
from scenewright.ground.buildings.uses import count_uses, use_of_asset
from scenewright.workflow.schemes import find_schemes

BLOCK = {"outline": [[0, 0], [120, 0], [120, 90], [0, 90]], "streets": [0, 1], "count": 14}


def village(**more: object) -> Brief:
    block = {**BLOCK, **more}
    return Brief.model_validate({"domain": "village", "style": "hill", "blocks": [block]})


def house(name: str, x: float, y: float = 0.0, asset: str = "house_rural_gabled") -> Piece:
    return Piece(name, "building", asset, "b", Pose(x, y, 0.0, math.pi / 2), Size(6.0, 9.0, 8.5))


def test_every_use_has_a_form_a_tag_and_a_house_of_ours() -> None:
    assert {form.use for form in FORMS.values()} == set(USES)
    assert all(use_of_tags({"building": tag}) == use for use, tag in TAG_OF_USE.items())
    own = {use_of_house(row) for row in our_houses("rural", purposes=True)}
    assert own == set(USES) - {"shop"}
    for style in LOOKS:
        assert {use_of_asset(asset_of_house(form, style, "flat")) for form in FORMS} == set(USES)


def test_styles_have_their_storeys_and_narrow_lanes_on_hills() -> None:
    assert max(row.levels for row in our_houses("hill")) == 4
    assert all(1 <= row.levels <= LOOKS[style].most for style in LOOKS for row in our_houses(style))
    assert LOOKS["hill"].lane <= 3.0
    assert any(row.asset.endswith("flat") and row.levels > 1 for row in our_houses("plain"))


def test_houses_that_share_a_side_wall_are_a_row_and_no_others() -> None:
    pieces = [house("a", 0.0), house("b", 6.0), house("c", 20.0), house("d", 6.0, 9.0)]
    assert share_walls(pieces) == [True, True, False, False]
    drawn = dress(pieces, {"c": "outbuilding"}, {"a", "c", "d"})
    assert [p.asset.partition("_")[0] for p in drawn] == ["row", "house", "barn", "house"]


def test_shops_look_at_squares_and_main_streets() -> None:
    square, street = shapely.box(-4, 6, 10, 20), shapely.box(20, 8, 90, 14)
    pieces = [house("a", 0.0), house("b", 30.0), house("c", 40.0, -20.0)]
    pieces.append(
        Piece("d", "building", "house_rural_gabled", "b", Pose(50, 0, 0, 0), Size(6, 9, 8))
    )
    ground = ShopGround(square, street)
    assert find_shop_fronts(pieces, ground) == (["a"], ["b"])
    names = {piece.id for piece in pieces}
    made = dress_by_wish(pieces, {}, names, UseWish(count=2), ground)
    assert [p.id for p in made if use_of_asset(p.asset) == "shop"] == ["a", "b"]
    one = count_uses(made)["shop"].floor / 2
    made = dress_by_wish(pieces, {}, names, UseWish(floor=one), ground)
    assert count_uses(made)["shop"].number == 1
    assert count_uses(made)["dwelling"].floor > 0


def test_wishes_choose_houses_of_their_use() -> None:
    houses = our_houses("rural", purposes=True)
    homes = [k for k, row in enumerate(houses) if use_of_house(row) == "dwelling" and row.share > 0]
    wishes = {
        "works": UseWish(count=2),
        "public": UseWish(floor=300.0),
        "outbuilding": UseWish(count=0),
    }
    sheds = [k for k, row in enumerate(houses) if is_outbuilding(row.use, row.area)]
    found = meet_uses(houses, [*homes[:6], *sheds[:2]], wishes, np.random.default_rng(0))
    uses = [use_of_house(houses[k]) for k in found]
    assert (uses.count("works"), uses.count("outbuilding"), len(found)) == (2, 0, 8)
    assert (
        sum(houses[k].area * houses[k].levels for k in found if use_of_house(houses[k]) == "public")
        >= 300
    )


def test_a_village_has_the_uses_it_asks_for_or_says_why_not() -> None:
    wishes = {"works": {"count": 1}, "public": {"count": 1}, "shop": {"count": 60}}
    brief = village(uses=wishes, square=300)
    solution = sw.solve(brief, preset="quick")
    report = sw.check(solution)
    assert report.valid, [row.message for row in report.findings]
    there = count_uses(solution.pieces)
    assert (there["works"].number, there["public"].number) == (1, 1)
    (out,) = [row for row in solution.left_out if "shop" in row.what]
    assert out.what == f"{60 - there['shop'].number} of 60 shops"
    assert "look at a square or main street" in out.reason
    told = find_schemes(solution, plan_of(brief), report)["block-1"]
    assert told["buildings_by_use"]["shop"] == there["shop"].number
    silent = [row for row in solution.left_out if row is not out]
    lost = sw.check(replace(solution, left_out=tuple(silent)))
    assert any("shops stand" in row.message for row in lost.findings)


def test_outbuildings_stand_behind_a_house() -> None:
    solution = sw.solve(village(count=20), preset="quick")
    pieces = [p for p in solution.pieces if p.category == "building"]
    shapes = polygons_of(pieces)
    serving = [use_of_asset(p.asset) == "outbuilding" for p in pieces]
    laid = [shapely.LineString(row.line) for row in solution.detail or ()]
    streets = shapely.union_all([shapely.LineString([(0, 0), (120, 0), (120, 90)]), *laid])
    homes = [shape for shape, own in zip(shapes, serving, strict=True) if not own]
    for shape, own in zip(shapes, serving, strict=True):
        if own:
            near = [one for one in homes if shape.distance(one) <= 9.0 + 1e-6]
            assert any(one.distance(streets) < shape.distance(streets) for one in near)


def test_an_extension_draws_its_source_by_use_storeys_and_roof() -> None:
    rows = [
        {"outline": [[x, 8], [x + 9, 8], [x + 9, 18], [x, 18]], "levels": 2, **more}
        for x, more in (
            (0, {"use": "shop"}),
            (14, {"roof": "flat"}),
            (28, {"use": "public"}),
            (42, {}),
        )
    ]
    source = {"buildings": rows, "roads": [{"line": [[-10, 0], [200, 0]], "width": 8}]}
    area = {"outline": [[56, -30], [200, -30], [200, 40], [56, 40]], "count": 6}
    area["uses"] = {"works": {"count": 1}, "public": {"count": 40}}
    brief = Brief.model_validate(
        {"domain": "extend", "origin": [10.0, 53.5], "sources": [source], "areas": [area]}
    )
    solution = sw.solve(brief, preset="quick")
    assert sw.check(solution).valid
    old = {p.id: p for p in solution.pieces if p.space == "source"}
    drawn = sorted(p.asset for p in old.values())
    forms = ["hall_brick_gabled", "house_brick_flat", "house_brick_gabled", "shop_brick_gabled"]
    assert drawn == forms
    assert {round(p.size.height, 3) for p in old.values()} == {8.5, 6.5}
    new = count_uses(p for p in solution.pieces if p.space != "source")
    assert new["works"].number >= 1
    assert any(row.what.endswith("of 40 public halls") for row in solution.left_out)


@pytest.mark.parametrize("wish", [{}, {"count": -1}, {"counts": 2}])
def test_a_wish_that_says_nothing_is_refused(wish: dict[str, int]) -> None:
    with pytest.raises((InputError, ValueError), match="shop"):
        village(uses={"shop": wish})
