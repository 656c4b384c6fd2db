"""What goes round a corner covers an L: drawn, recognised, placed, and the nook is floor."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.catalog.assets import shipped
from scenewright.catalog.models.words import match
from scenewright.core.brief import Brief
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece

CORNERS = (
    "corner_desk",
    "corner_desk_right",
    "corner_counter",
    "corner_house",
    "corner_sofa",
    "corner_sofa_right",
    "corner_sofa_nordic",
    "corner_sofa_right_boho",
    "corner_desk_classic",
    "corner_desk_right_industrial",
)


def polygon(piece: Piece) -> shapely.Polygon:
    return shapely.Polygon(outline_of(piece))


def box(piece: Piece) -> shapely.Polygon:
    return polygon(replace(piece, footprint=()))


@pytest.mark.parametrize("name", CORNERS)
@pytest.mark.parametrize("size", ["smallest", "usual", "largest"])
def test_what_is_drawn_stands_on_its_l(name: str, size: str) -> None:
    asset = shipped().assets[name]
    wanted = getattr(asset, size)
    covered = shapely.Polygon(asset.footprint(wanted))
    assert covered.is_valid
    assert 0.25 < covered.area / (wanted.width * wanted.depth) < 0.85
    points = np.concatenate([part.vertices[:, :2] for part in asset.mesh(wanted)])
    assert shapely.distance(covered, shapely.points(points)).max() < 0.02 * wanted.width
    border = shapely.Polygon(asset.symbol(wanted)[0])
    assert border.symmetric_difference(covered).area < 1e-6


def test_the_two_corner_desks_are_each_others_mirror_image() -> None:
    left, right = (shipped().assets[name] for name in CORNERS[:2])
    one, other = (shapely.Polygon(asset.footprint(asset.usual)) for asset in (left, right))
    mirrored = shapely.transform(one, lambda points: points * [-1.0, 1.0])
    assert mirrored.symmetric_difference(other).area < 1e-9
    for asset in (left, right):
        for part in asset.mesh(asset.usual):
            a, b, c = (part.vertices[part.faces[:, k]] for k in range(3))
            assert np.einsum("ij,ij->", np.cross(a, b), c) > 0, "wound outwards"


@pytest.mark.parametrize(
    ("words", "kind"),
    [
        ("L-shaped desk", "corner_desk"),
        ("Eckschreibtisch", "corner_desk"),
        ("bureau d'angle", "corner_desk"),
        ("转角书桌", "corner_desk"),
        ("L字デスク", "corner_desk"),
        ("Corner reception desk", "corner_counter"),
        ("Ecktheke", "corner_counter"),
        ("desk", "desk"),
        ("reception desk", "info_desk"),
    ],
)
def test_they_are_recognised_by_name(words: str, kind: str) -> None:
    found = match(words)
    assert found is not None
    assert found.kinds[0] == kind


@pytest.mark.parametrize("seed", [0, 1])
def test_a_corner_desk_asked_for_stands_with_its_chair_in_the_nook(seed: int) -> None:
    room = {
        "id": "r",
        "function": "study",
        "outline": [[0, 0], [3.0, 0], [3.0, 2.6], [0, 2.6]],
        "doors": [{"at": [2.4, 0], "width": 0.85}],
        "wishes": [{"what": "corner_desk", "required": True}],
    }
    solution = sw.solve(Brief.model_validate({"rooms": [room]}), seed=seed, steps=4000)
    assert sw.check(solution).valid
    by_kind = {piece.category: piece for piece in solution.pieces}
    desk, chair = by_kind["corner_desk"], by_kind["office_chair"]
    assert "desk" not in by_kind, "one desk is asked for"
    assert box(desk).contains(polygon(chair).centroid)
    assert polygon(chair).difference(polygon(desk)).area > 0.5 * polygon(chair).area


def test_a_corner_counter_leaves_its_nook_to_the_staff() -> None:
    lobby = {
        "id": "lobby",
        "function": "hall",
        "outline": [[0, 0], [9, 0], [9, 7], [0, 7]],
        "doors": [{"at": [4.5, 0], "width": 1.6, "use": "both"}],
        "demands": [{"category": "corner_counter", "count": 1}],
    }
    solution = sw.solve(Brief.model_validate({"domain": "hall", "rooms": [lobby]}), steps=600)
    (counter,) = [piece for piece in solution.pieces if piece.category == "corner_counter"]
    assert sw.check(solution).valid
    nook = box(counter).difference(polygon(counter)).representative_point()
    chair = sw.Piece("c", "stool", "", "lobby", sw.Pose(nook.x, nook.y, 0, 0), sw.Size(0.4, 0.4, 1))
    crowded = replace(solution, pieces=(*solution.pieces, chair))
    assert not [f for f in sw.check(crowded).findings if f.kind == "collision"]


def test_l_shaped_houses_reach_into_each_others_corner() -> None:
    """On ground that holds one house of the same size that fills its box, two stand."""
    stand = []
    for model in ({"model": "corner_house"}, {"model": "villa", "size": [15, 13, 8.5]}):
        ground = {
            "id": "s",
            "outline": [[0, 0], [28, 0], [28, 26], [0, 26]],
            "setback": 1,
            "spacing": 3,
            "buildings": [{**model, "count": 4}],
        }
        brief = Brief.model_validate({"domain": "site", "name": "Close", "sites": [ground]})
        solution = sw.solve(brief, seed=0)
        assert sw.check(solution).valid
        stand.append(sum(piece.category == "building" for piece in solution.pieces))
    assert stand == [2, 1]
