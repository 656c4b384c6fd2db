"""How many houses and which: blocks like real ones, classes and coverage as asked for."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import shapely

import scenewright as sw
from model_files import glb_of, gltf_of
from scenewright.catalog.loading import catalog_of, find_asset
from scenewright.core.brief import Brief
from scenewright.domains import problems, solvers
from scenewright.domains.village.choosing import choose_houses
from scenewright.domains.village.enclosures import LOOKS, enclose_plots
from scenewright.domains.village.learned.mix import HouseMix, draw_sizes, fetch_houses
from scenewright.domains.village.plan import plan_village
from scenewright.domains.village.problem import VillageProblem
from scenewright.engine.solve import Budget
from scenewright.ground.streetside.plots import Plot

MIX = HouseMix(
    np.array([[9.0, 0.3, 3.0], [9.0, 0.3, 12.0], [11.0, 0.3, 6.0]]),
    np.array([[150.0, 1.5]] * 3 + [[18.0, 1.2]] * 12 + [[90.0, 1.1]] * 6),
)


def brief(**more: object) -> Brief:
    block = {"id": "b", "outline": [[0, 0], [80, 0], [80, 60], [0, 60]], "streets": [0]}
    return Brief.model_validate({"domain": "village", "blocks": [block | more]})


def problem(**more: object) -> VillageProblem:
    return problems(brief(**more))[0]


def test_houses_of_a_block_are_those_of_one_real_block() -> None:
    for seed in range(20):
        sizes = draw_sizes(MIX, np.exp(9.0), 0.3, None, np.random.default_rng(seed))
        assert (len(sizes), sizes[0, 0]) in ((3, 150.0), (12, 18.0))


def test_a_count_that_is_asked_for_is_met_by_a_block_that_has_about_as_many() -> None:
    sizes = [draw_sizes(MIX, np.exp(9.0), 0.3, 11, np.random.default_rng(k)) for k in range(10)]
    assert all(len(rows) == 11 for rows in sizes)
    assert np.mean([rows[0, 0] == 18.0 for rows in sizes]) > 0.9


def test_sizes_that_are_the_same_are_one_house_and_shares_count_among_alike() -> None:
    library = np.array([[20.0, 1.2], [20.5, 1.2], [150.0, 1.5]])
    drawn = np.array([[20.2, 1.2]] * 8)
    picks = []
    for seed in range(200):
        found = fetch_houses(drawn, library, np.array([9.0, 1.0, 1.0]), np.random.default_rng(seed))
        assert len(set(found)) == 1
        picks.append(found[0])
    assert 0.82 < np.mean(np.array(picks) == 0) < 0.97
    assert 2 not in picks


def test_classes_asked_for_are_kept() -> None:
    one = problem(count=10, classes={"small": 1.0})
    assert {one.houses[k].size for k in choose_houses(one, np.random.default_rng(0))} == {0}
    half = problem(count=200, classes={"small": 0.5, "large": 0.5})
    sizes = [half.houses[k].size for k in choose_houses(half, np.random.default_rng(1))]
    assert len(sizes) == 200
    assert np.mean(np.array(sizes) == 0) == pytest.approx(0.5, abs=0.12)
    assert 1 not in sizes


def test_coverage_asked_for_is_reached_by_less_than_a_house() -> None:
    one = problem(coverage=0.4)
    areas = [one.houses[k].area for k in choose_houses(one, np.random.default_rng(2))]
    assert sum(areas) >= 0.4 * 4800
    assert sum(areas) - max(areas) < 0.4 * 4800


@pytest.mark.parametrize("look", LOOKS)
def test_walls_stand_along_streets_and_leave_walks_open(look: str) -> None:
    (block,) = plan_village(brief()).detail.blocks
    walk = shapely.box(30, -1, 32, 20)
    plot = Plot("b/house", block.outline, block.area)
    (_, wall, _), *_ = enclose_plots(block, [plot], np.zeros(0, object), walk, look)
    assert shapely.Polygon(block.outline).covers(wall)
    assert wall.distance(shapely.LineString([(0, 0), (80, 0)])) > 0.2
    assert wall.bounds[3] < 1.2
    assert not wall.intersection(walk).area
    assert 76 < sum(np.ptp(shapely.bounds(p)[[0, 2]]) for p in shapely.get_parts(wall)) < 80


def test_a_map_may_bring_its_own_houses_to_choose_from(tmp_path: Path) -> None:
    def polygon(name: str, points: list[tuple[float, float]], **tags: str) -> dict[str, object]:
        ring = [[11.0 + x / 72_900, 49.0 + y / 111_200] for x, y in [*points, points[0]]]
        shape = {"type": "Polygon", "coordinates": [ring]}
        return {"type": "Feature", "properties": {"name": name} | tags, "geometry": shape}

    features = [
        polygon("Green", [(0, 0), (80, 0), (80, 60), (0, 60)], block="yes"),
        polygon(
            "Mine",
            [(200, 0), (209, 0), (209, 7), (200, 7)],
            building="library",
            **{"roof:shape": "hipped", "building:levels": "1"},
        ),
    ]
    path = tmp_path / "own.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
    solution = sw.solve(sw.read(path), steps=1)
    placed = [piece for piece in solution.pieces if piece.category == "building"]
    assert placed
    assert {piece.function for piece in placed} == {"Mine"}
    alone = [piece for piece in placed if not piece.asset.startswith("row_")]
    assert alone
    assert all("hipped" in piece.asset for piece in alone)
    assert sw.check(solution).valid


def test_all_layouts_of_a_block_are_of_the_same_houses() -> None:
    """Else the best of several would be that with the fewest houses, which lacks least."""
    one = problem()
    found = solvers("village")["grow"].run(one, Budget(steps=4), 5).layouts
    assert {layout.asked for layout in found} == {found[0].asked}
    whole = [sorted(row.houses.tolist()) for row in found if len(row.houses) == row.asked]
    assert len(whole) >= 2
    asked = sorted(choose_houses(one, np.random.default_rng([5, 1])))
    assert any(row == asked for row in whole)


def test_a_folder_of_glb_is_a_library(tmp_path: Path) -> None:
    """An L and a shed as binary glTF (y is up there): their own footprints stand on the block."""
    folder = tmp_path / "stock"
    folder.mkdir()
    angle = [(0, 0), (14, 0), (14, 6), (6, 6), (6, 12), (0, 12)]
    for name, ring, high in (("angle", angle, 6.0), ("shed", [(0, 0), (5, 0), (5, 4), (0, 4)], 3)):
        (folder / f"{name}.glb").write_bytes(glb_of(gltf_of(*_prism(ring, high))))
    block = {"id": "b", "outline": [[0, 0], [90, 0], [90, 60], [0, 60]], "streets": [0], "count": 5}
    brief = Brief.model_validate(
        {"domain": "village", "catalogs": [str(folder)], "blocks": [block]}
    )
    library = {house.name: house for house in problems(brief)[0].houses}
    assert {name: house.area for name, house in library.items()} == {
        "angle": pytest.approx(14 * 6 + 6 * 6, abs=0.01),
        "shed": pytest.approx(20.0),
    }
    assert library["angle"].shape == 1
    solution = sw.solve(brief, seed=1, steps=1)
    assert sw.check(solution).valid
    placed = [piece.asset for piece in solution.pieces if piece.category == "building"]
    assert set(placed) <= {"model:angle", "model:shed"}
    assert len(placed) == 5
    # The model itself is drawn over its own plan, and over no other.
    asset = find_asset(catalog_of([str(folder)]), "angle")
    own = [piece.footprint for piece in solution.pieces if piece.asset == asset.id]
    assert asset.over is not None
    assert own == [] or asset.over(asset.usual, own[0])
    assert not asset.over(asset.usual, ((-7.0, -6.0), (7.0, -6.0), (7.0, 6.0), (-7.0, 6.0)))


def _prism(ring: list[tuple[int, int]], high: float) -> tuple[np.ndarray, np.ndarray]:
    """Walls and lids over a ring whose corner 0 sees all others."""
    count = len(ring)
    points = [(x, level, -y) for level in (0.0, high) for x, y in ring]
    walls = [(k, (k + 1) % count, k + count) for k in range(count)]
    walls += [((k + 1) % count, (k + 1) % count + count, k + count) for k in range(count)]
    fan = [(0, k, k + 1) for k in range(1, count - 1)]
    lids = [tuple(n + count for n in row) for row in fan] + [row[::-1] for row in fan]
    return np.array(points), np.array([*walls, *lids])
