"""Mats and rugs on free floor: they lie on it, clear of all that stands and of doors."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely

from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief, Room
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import check
from scenewright.domains.home.furnishing.floor_mats import lay_mats
from scenewright.domains.home.ground import ground_of
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
            if other.pose.z < 0.05 and kind.support == "floor" and not kind.flat:
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
