"""Pictures at eye height: found by suffix, from a clear spot, with sky above and ground below."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely
from PIL import Image

import scenewright as sw
from flat import flat_solution
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.layout import corners
from scenewright.core.solution import Solution
from scenewright.domains import scene_of
from scenewright.domains.site.plan import plans_of
from scenewright.formats import street_png, suffix_of, writer
from scenewright.geometry.box_grid import box_grid
from scenewright.geometry.walker import sights_of_boxes
from scenewright.geometry.walker_meshes import best_spots
from scenewright.render.stage import blocks_of
from scenewright.render.street import sun_for
from scenewright.render.street_spot import FREE, Standpoint, standpoint

ROADS = [{"line": [[-5, 45], [125, 45]], "width": 9}]


def solved(roads: list[dict[str, object]], count: int = 8) -> Solution:
    ground = {
        "id": "s",
        "outline": [[0, 0], [120, 0], [120, 90], [0, 90]],
        "roads": roads,
        "buildings": [{"model": "villa", "count": count}],
    }
    return sw.solve(Brief.model_validate({"domain": "site", "sites": [ground]}))


def spot_of(solution: Solution) -> Standpoint:
    catalog = catalog_of(solution.brief.catalogs)
    blocks = blocks_of(scene_of(solution), catalog)
    return standpoint(plans_of(solution.brief), solution.pieces, blocks, catalog)


@pytest.mark.parametrize("roads", [ROADS, []], ids=["street", "open ground"])
def test_one_stands_on_the_site_clear_of_everything(roads: list[dict[str, object]]) -> None:
    solution = solved(roads)
    spot = spot_of(solution)
    at = shapely.Point(spot.eye[:2])
    assert spot.eye[2] == pytest.approx(1.6)
    assert np.hypot(*spot.way) == pytest.approx(1.0)
    for piece in solution.pieces:
        box = [(*piece.pose[:2], piece.pose.heading, piece.size.width, piece.size.depth)]
        thin = piece.category != "building"
        body = shapely.Point(piece.pose[:2]) if thin else shapely.Polygon(corners(np.array(box))[0])
        assert body.distance(at) >= FREE
    if roads:
        assert abs(spot.eye[1] - 45) <= 4.5
    again = spot_of(solution)
    assert np.array_equal(again.eye, spot.eye)
    assert np.array_equal(again.way, spot.way)


@pytest.mark.parametrize("roads", [ROADS, []], ids=["street", "open ground"])
def test_there_is_sky_above_and_ground_below(roads: list[dict[str, object]]) -> None:
    made = street_png.picture(solved(roads), 200).astype(int)
    assert made.shape == (125, 200, 3)
    top, bottom = made[0], made[-1]
    assert np.median(top[:, 2] - top[:, 0]) > 20
    assert np.median(bottom[:, 2] - bottom[:, 0]) < 15
    assert made.std() > 25


def test_the_sun_is_never_in_the_north_and_lights_what_is_seen() -> None:
    for angle in np.linspace(0, 2 * np.pi, 16, endpoint=False):
        way = np.array([np.cos(angle), np.sin(angle)])
        sun = np.array(sun_for(way))
        assert np.linalg.norm(sun) == pytest.approx(1.0)
        assert sun[1] <= 1e-9
        if way[1] > 0.3:
            assert sun[:2] @ way < 0


def test_the_best_spot_comes_first() -> None:
    grid = box_grid(np.array([[0, 30, -np.pi / 2, 20, 10], [40, 35, -np.pi / 2, 20, 10]]), [9, 30])
    made = sights_of_boxes(grid, np.ones(2), [[0, 0], [20, -10], [400, 0]])
    found = best_spots(made)
    assert len(found) == 3
    assert [s.score for s in found] == sorted((s.score for s in found), reverse=True)
    assert found[-1].score == 0.0


def test_the_longest_suffix_wins(tmp_path: Path) -> None:
    for name in ("a.street.png", "a.STREET.PNG"):
        assert writer(tmp_path / name).__module__ == "scenewright.formats.street_png"
    assert writer(tmp_path / "street.png").__module__ == "scenewright.formats.png"
    assert suffix_of("A.Street.png") == ".Street.png"
    sw.write(solved(ROADS, 2), tmp_path / "a.street.png")
    with Image.open(tmp_path / "a.street.png") as image:
        assert image.size == (1280, 800)
    assert [path.name for path in tmp_path.iterdir()] == ["a.street.png"]


def test_homes_have_no_street(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"only sites can be written as \.street"):
        sw.write(flat_solution(), tmp_path / "flat.street.png")
    assert not list(tmp_path.iterdir())
