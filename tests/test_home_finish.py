"""What completes a furnished room: rugs and screens grow, bare walls and windows are dressed."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import hypot, pi

import pytest
import shapely

from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief, Room
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import check
from scenewright.domains.home.furnishing.enlarge import enlarge_pieces
from scenewright.domains.home.furnishing.wall_art import fill_walls
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.groups.kitchen import kitchen
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.solving import solve

CABINETS = {"sink_cabinet", "hob_cabinet", "drawer_cabinet", "base_cabinet", "dishwasher", "fridge"}
LIVING = {
    "id": "living",
    "function": "living",
    "outline": [[0, 0], [5, 0], [5, 4.4], [0, 4.4]],
    "doors": [{"at": [0.0, 0.9], "width": 0.85}],
    "windows": [{"at": [2.5, 4.4], "width": 1.6}],
}


@pytest.fixture(scope="module")
def living():
    return solve(Brief(rooms=[Room.model_validate(LIVING)]), seed=3)


def one(solution, category):
    return next(p for p in solution.pieces if p.category == category)


def test_a_rug_reaches_beyond_its_sofa_and_a_screen_fits_its_distance(living):
    assert check(living).valid
    sofa, rug, screen = (one(living, c) for c in ("sofa", "rug", "tv"))
    assert max(rug.size.width, rug.size.depth) > sofa.size.width
    away = hypot(sofa.pose.x - screen.pose.x, sofa.pose.y - screen.pose.y)
    assert away <= 3.2 * screen.size.width


def test_a_rug_grows_no_further_than_walls_and_furniture_let_it(living):
    (space,) = spaces(living.brief)
    ground: Ground = ground_of(space, (), 22.0, ())
    rug, sofa = one(living, "rug"), one(living, "sofa")
    small = replace(rug, size=rug.size._replace(width=sofa.size.width))
    pieces = [small if p is rug else p for p in living.pieces if p.function != "light"]
    grown = enlarge_pieces(pieces, (), ground, space.height, shipped())
    found = shapely.Polygon(outline_of(next(p for p in grown if p.id == rug.id)))
    assert shapely.Polygon(space.outline).buffer(1e-6).contains(found)
    for piece in grown:
        if piece.group != rug.group and piece.pose.z < 0.01:
            assert found.intersection(shapely.Polygon(outline_of(piece))).area < 0.01
    wall = replace(sofa, id="wall", size=sofa.size._replace(width=9.0), group="")
    boxed = enlarge_pieces(pieces, [replace(wall, pose=rug.pose)], ground, space.height, shipped())
    assert "rug" not in {p.category for p in boxed if p.group == rug.group}, "no mat"
    fixed = [replace(p, fixed=True) for p in pieces]
    assert enlarge_pieces(fixed, (), ground, space.height, shipped()) == fixed


@pytest.mark.parametrize(("away", "wide"), [(2.3, 1.0), (3.0, 1.2), (3.6, 1.2), (4.2, 1.33)])
def test_a_screen_is_wider_than_its_stand_only_where_it_were_too_small(away, wide):
    (space,) = spaces(Brief(rooms=[Room.model_validate(LIVING | {"id": "a"})]))
    stand = Piece("s", "tv_stand", "", "a", Pose(4.8, 2, 0, pi), Size(1.2, 0.4, 0.45))
    screen = Piece("t", "tv", "", "a", Pose(4.8, 2, 0.45, pi), Size(0.8, 0.22, 0.5), on="s")
    sofa = Piece("c", "sofa", "", "a", Pose(4.8 - away, 2, 0, 0), Size(2, 0.9, 0.8))
    ground = ground_of(space, (), 22.0, ())
    grown = enlarge_pieces([stand, screen, sofa], (), ground, space.height, shipped())
    assert grown[1].size.width == pytest.approx(wide, abs=0.02)
    assert grown[1].pose == screen.pose


def test_what_a_room_has_it_is_not_given_again(living):
    hung = [p for p in living.pieces if p.category in ("picture", "wall_lamp", "curtain", "blind")]
    assert len(hung) == len({p.id for p in hung})
    assert sum(p.category in ("curtain", "blind") for p in hung) == 1


@pytest.mark.parametrize("wide", [2.4, 5.0])
def test_a_mirror_or_a_kitchen_makes_no_picture_needless(wide):
    """One picture hangs in every room that is lived in, small ones too."""
    room = {"id": "a", "function": "bedroom", "outline": [[0, 0], [wide, 0], [wide, 3], [0, 3]]}
    (space,) = spaces(Brief(rooms=[Room.model_validate(room)]))
    ground, size = ground_of(space, (), 3 * wide), Size(0.6, 0.03, 0.9)
    mirror = Piece("m", "mirror", "", "a", Pose(0.8, 0.02, 1.0, pi / 2), size)
    unit = replace(mirror, id="u", category="wall_cabinet")
    for there in ((), (mirror,), (mirror, unit)):
        hung = fill_walls(space, ground, there, shipped())
        assert [p.category for p in hung if p.category != "wall_lamp"] == ["picture"]
    art = replace(mirror, category="picture")
    assert "picture" not in {p.category for p in fill_walls(space, ground, (art,), shipped())}


@pytest.mark.parametrize("case", [c for c in kitchen() if c.width >= 2.3], ids=lambda c: c.name)
def test_a_kitchen_run_has_worktop_on_both_sides_of_its_hob(case):
    row = sorted((m for m in case.members if m.category in CABINETS), key=lambda m: m.x)
    at = next(i for i, m in enumerate(row) if m.category == "hob_cabinet")
    assert {row[at - 1].category, row[min(at + 1, len(row) - 1)].category}.isdisjoint(
        {"sink_cabinet", "fridge", "hob_cabinet"}
    )
    for a, b in pairwise(row):
        assert b.x - a.x == pytest.approx((a.size.width + b.size.width) / 2)
