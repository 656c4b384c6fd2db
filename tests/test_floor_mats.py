"""Mats and rugs on free floor: they lie on it, clear of all that stands and of doors."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest
import shapely

from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.catalog.classes import BEDS, SOFAS
from scenewright.core.brief import Brief, Room
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains import check
from scenewright.domains.home.furnishing.floor_mats import lay_mats
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.solving import solve
from scenewright.formats import read


def _floor(piece: Piece) -> shapely.Polygon:
    return shapely.Polygon(outline_of(piece))


@pytest.mark.parametrize("seed", range(3))
def test_mats_of_a_solved_home_lie_clear(seed):
    home = solve(read("sample:home-flat"), seed=seed, steps=600)
    kinds, rooms = shipped().kinds, {s.id: s for s in spaces(home.brief)}
    mats = [p for p in home.pieces if p.id.endswith("/mat")]
    assert mats
    for mat in mats:
        room = shapely.Polygon(rooms[mat.space].outline)
        assert room.buffer(1e-6).contains(_floor(mat))
        for other in home.pieces:
            kind = kinds[other.category]
            under = other.category in (*BEDS, *SOFAS)
            if other.pose.z < 0.05 and kind.support == "floor" and not kind.flat and not under:
                assert _floor(mat).intersection(_floor(other)).area < 1e-6, other.id
    assert check(home).valid


def test_a_mat_lies_before_the_bath_and_a_second_is_not_laid():
    bath = {"id": "bath", "function": "bathroom", "outline": [[0, 0], [3, 0], [3, 2.4], [0, 2.4]]}
    bath["doors"] = [{"at": [0.0, 1.9], "width": 0.8}]
    home = solve(Brief(rooms=[Room.model_validate(bath)]), seed=1, steps=600)
    (mat,) = (p for p in home.pieces if p.category == "rug")
    tub = next(p for p in home.pieces if p.category in ("bathtub", "shower"))
    assert _floor(mat).distance(_floor(tub)) < 0.06
    (space,) = spaces(home.brief)
    assert lay_mats(space, ground_of(space, (), 7.2), home.pieces, shipped()) == []


def test_what_stands_where_a_mat_would_lie_makes_it_smaller_or_moves_it():
    hall = {"id": "hall", "function": "hall", "outline": [[0, 0], [4, 0], [4, 1.3], [0, 1.3]]}
    (space,) = spaces(Brief(rooms=[Room.model_validate(hall)]))
    ground = ground_of(space, (), 5.2)
    (mat,) = lay_mats(space, ground, (), shipped())
    assert np.allclose(mat.pose[:2], (2.0, 0.65), atol=0.06)
    chest = replace(mat, id="hall/chest", category="shoe_cabinet", size=Size(0.4, 0.4, 1.0))
    (other,) = lay_mats(space, ground, (chest,), shipped())
    assert _floor(other).intersection(_floor(chest)).area < 1e-6
    assert other.size.width < mat.size.width


@pytest.mark.parametrize("turned", [0.0, np.pi], ids=["front to the room", "front to the wall"])
def test_a_mat_lies_along_the_open_side_of_a_tub(turned):
    bath = {"id": "bath", "function": "bathroom", "outline": [[0, 0], [3, 0], [3, 2.4], [0, 2.4]]}
    (space,) = spaces(Brief(rooms=[Room.model_validate(bath)]))
    pose = Pose(1.5, 0.39, 0.0, np.pi / 2 + turned)
    tub = Piece("tub", "bathtub", "", "bath", pose, Size(1.7, 0.75, 0.6))
    (mat,) = lay_mats(space, ground_of(space, (), 7.2), (tub,), shipped())
    assert _floor(mat).distance(_floor(tub)) < 0.06
    west, south, east, north = _floor(mat).bounds
    assert south > 0.7
    assert east - west > north - south
    assert (west + east) / 2 == pytest.approx(1.5, abs=0.06)


ROOM = {"id": "bed", "function": "bedroom", "outline": [[0, 0], [4, 0], [4, 3.4], [0, 3.4]]}


def _rug_of(room: dict, *pieces: Piece) -> list[Piece]:
    (space,) = spaces(Brief(rooms=[Room.model_validate(room)]))
    return lay_mats(space, ground_of(space, (), 13.0), pieces, shipped())


def _piece(category: str, pose: Pose, *size: float, room: str = "bed") -> Piece:
    return Piece(category, category, "", room, pose, Size(*size))


def test_a_rug_of_a_bed_for_two_reaches_out_alike_on_both_sides():
    bed = _piece("double_bed", Pose(1.05, 1.7, 0.0, 0.0), 1.6, 2.05, 0.9)
    (rug,) = _rug_of(ROOM, bed)
    assert rug.pose.y == pytest.approx(1.7)
    assert rug.size.width >= 1.6 + 0.6
    assert _floor(rug).intersection(_floor(bed)).area > 1.0


def test_a_rug_lies_along_the_open_side_of_a_bed_in_the_corner_and_a_little_under_it():
    bed = _piece("double_bed", Pose(1.05, 0.71, 0.0, 0.0), 1.4, 2.05, 0.9)
    chest = _piece("chest_of_drawers", Pose(3.0, 2.3, 0.0, pi), 1.0, 1.5, 0.9)
    (rug,) = _rug_of(ROOM, bed, chest)
    _, south, _, north = _floor(rug).bounds
    assert south == pytest.approx(1.41 - 0.2)
    assert north > 1.41 + 0.3
    assert abs(rug.pose.x - bed.pose.x) <= 0.4


def test_no_small_rug_lies_amid_a_bedroom_nor_before_the_doors_of_a_wardrobe():
    bed = _piece("double_bed", Pose(1.05, 0.71, 0.0, 0.0), 1.4, 2.05, 0.9)
    wardrobe = _piece("wardrobe", Pose(1.2, 2.35, 0.0, -pi / 2), 2.4, 0.6, 2.2)
    shelf = _piece("bookcase", Pose(2.5, 0.8, 0.0, pi), 1.6, 0.5, 2.0)
    assert _rug_of(ROOM, bed, wardrobe, shelf) == []
    lower = replace(wardrobe, category="sideboard")
    assert _rug_of(ROOM, bed, lower, shelf)


def test_a_runner_lies_before_the_middle_of_the_cupboards_of_a_hall():
    hall = {"id": "hall", "function": "hall", "outline": [[0, 0], [6, 0], [6, 1.5], [0, 1.5]]}
    cases = [
        _piece("bookcase", Pose(x, 0.16, 0.0, pi / 2), 0.8, 0.32, 2.0, room="hall")
        for x in (3.6, 4.4)
    ]
    (rug,) = _rug_of(hall, *cases)
    assert rug.pose.x == pytest.approx(4.0)


def test_a_rug_before_a_sofa_without_a_table_reaches_under_its_middle():
    living = {"id": "a", "function": "living", "outline": [[0, 0], [5, 0], [5, 3], [0, 3]]}
    sofa = _piece("sofa", Pose(2.2, 0.4, 0.0, pi / 2), 1.8, 0.8, 0.8, room="a")
    table = _piece("tv_stand", Pose(3.6, 1.3, 0.0, 0.0), 0.5, 0.4, 0.5, room="a")
    (rug,) = _rug_of(living, sofa, table)
    assert rug.pose.x == pytest.approx(2.2)
    assert _floor(rug).bounds[1] == pytest.approx(0.6)


def test_a_rug_of_a_sofa_in_the_corner_ends_with_it_and_reaches_beyond_its_other_side():
    living = {"id": "a", "function": "living", "outline": [[0, 0], [5, 0], [5, 3], [0, 3]]}
    sofa = _piece("sofa", Pose(0.92, 0.4, 0.0, pi / 2), 1.8, 0.8, 0.8, room="a")
    (rug,) = _rug_of(living, sofa)
    west, _, east, _ = _floor(rug).bounds
    assert west == pytest.approx(0.02)
    assert east >= 1.82 + 0.2


@pytest.mark.parametrize(
    ("door", "laid"),
    [
        ({"swing": "slide", "width": 1.2}, True),
        ({"swing": "out", "width": 0.8}, True),
        ({"swing": "in", "width": 0.8}, False),
    ],
)
def test_a_rug_lies_before_a_door_but_not_where_its_leaf_opens(door, laid):
    """The room ends 1.4 m before the sofa, with a door there."""
    living = {
        "id": "a",
        "function": "living",
        "outline": [[0, 0], [1.9, 0], [1.9, 1.65], [0, 1.65]],
    }
    living["doors"] = [{"at": [0.95, 1.65], **door}]
    sofa = _piece("sofa", Pose(0.95, 0.4, 0.0, pi / 2), 1.6, 0.8, 0.8, room="a")
    assert bool(_rug_of(living, sofa)) is laid


def _open_plan(*functions: str) -> tuple[Space, Ground]:
    room = {"id": "a", "function": list(functions), "outline": [[0, 0], [6, 0], [6, 4], [0, 4]]}
    (space,) = spaces(Brief(rooms=[Room.model_validate(room)]))
    return space, ground_of(space, (), 24.0)


@pytest.mark.parametrize(("ahead", "share"), [(0.85, 1), (1.4, 1), (1.8, 0), (2.4, 0)])
def test_a_low_table_stands_on_the_rug_with_all_its_legs_or_with_none(ahead, share):
    space, ground = _open_plan("living")
    sofa = Piece("s", "sofa", "", "a", Pose(0.5, 2.0, 0.0, 0.0), Size(2.0, 0.9, 0.8))
    table = Piece("t", "coffee_table", "", "a", Pose(0.5 + ahead, 2.0, 0, 0), Size(0.9, 0.5, 0.4))
    (mat,) = lay_mats(space, ground, (sofa, table), shipped())
    on = _floor(mat).intersection(_floor(table)).area / _floor(table).area
    assert on == pytest.approx(share, abs=1e-6)


def test_a_bed_in_a_kitchen_has_a_rug_off_the_floor_where_one_cooks():
    space, ground = _open_plan("kitchen", "bedroom")
    bed = Piece("b", "single_bed", "", "a", Pose(1.05, 2.0, 0.0, 0.0), Size(0.9, 2.0, 0.5))
    unit = Piece(
        "u",
        "hob_cabinet",
        "",
        "a",
        Pose(1.0, 0.3, 0, pi / 2),
        Size(1.8, 0.6, 0.9),
        "a/k",
        "kitchen",
    )
    (mat,) = lay_mats(space, ground, (bed, unit), shipped())
    assert _floor(mat).distance(shapely.box(0.1, 0.0, 1.9, 1.2)) > 0
    assert _floor(mat).intersects(_floor(bed))
