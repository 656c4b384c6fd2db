"""Villages from end to end: samples are filled, valid, the same by seed; bad input is refused."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import shapely
from benchmarks.village_data import real_blocks

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.piece_outlines import polygons_of
from scenewright.domains import features_of, plan_of, reasons_of, scene_of
from scenewright.formats import solution_json
from thoroughness import few_or_many

SAMPLES = ("village-hamlet", "village-street", "village-dense")
SQUARE = [[0, 0], [60, 0], [60, 50], [0, 50]]


def village(**more: object) -> Brief:
    block = {"id": "b", "outline": SQUARE, "streets": [0]}
    keys = {"lanes", "houses", "style", "origin", "blocks"}
    top = {key: value for key, value in more.items() if key in keys}
    own = {key: value for key, value in more.items() if key not in keys}
    return Brief.model_validate({"domain": "village", "blocks": [block | own]} | top)


def houses(solution: sw.Solution) -> list[sw.Piece]:
    return [p for p in solution.pieces if p.category == "building"]


@pytest.mark.parametrize("name", SAMPLES)
@pytest.mark.parametrize("seed", [0, 1])
def test_samples_are_filled_and_break_no_rule(name: str, seed: int) -> None:
    brief = sw.read(f"sample:{name}")
    solution = sw.solve(brief, seed=seed)
    report = sw.check(solution)
    assert report.valid, [found.message for found in report.findings]
    for block, found in zip(brief.part.blocks, report.figures["blocks"].values(), strict=True):
        assert found["reached_share"] == 1.0
        if block.count is not None:
            assert found["houses"] == block.count
        if block.coverage is not None:
            assert found["coverage"] == pytest.approx(block.coverage, abs=0.12)


def test_the_same_seed_gives_the_same_village_and_another_another() -> None:
    brief = village(count=6)
    one, other = (sw.solve(brief, seed=4) for _ in range(2))
    assert one.pieces == other.pieces
    assert one.pieces != sw.solve(brief, seed=5).pieces


def test_houses_may_share_walls_and_nothing_else() -> None:
    solution = sw.solve(village(coverage=0.5), seed=2, steps=1)
    shapes = polygons_of(houses(solution))
    floor = shapely.Polygon(SQUARE).buffer(1e-6)
    assert shapely.covers(floor, shapes).all()
    shared = shapely.area(shapely.intersection(shapes[:, None], shapes[None]))
    np.fill_diagonal(shared, 0.0)
    assert shared.max() < 0.1
    assert shapely.area(shapes).sum() > 0.35 * floor.area


def test_classes_and_counts_are_what_was_asked_for() -> None:
    solution = sw.solve(village(count=5, classes={"small": 1.0}), seed=0)
    areas = shapely.area(polygons_of(houses(solution)))
    assert len(areas) == 5
    assert areas.max() < 50.0


def test_a_square_stays_free_on_the_street() -> None:
    solution = sw.solve(village(count=8, square=225.0), seed=3)
    (patch,) = solution.patches
    assert patch.box[3] * patch.box[4] == pytest.approx(225.0)
    assert patch.box[1] == pytest.approx(7.51, abs=0.02)
    square = shapely.box(patch.box[0] - 7.4, 0.2, patch.box[0] + 7.4, 14.8)
    assert not shapely.intersects(square, polygons_of(houses(solution))).any()


def test_too_much_is_left_out_with_its_reason() -> None:
    solution = sw.solve(village(count=60), seed=0, steps=1)
    (out,) = solution.left_out
    assert "of 60 houses" in out.what
    assert out.required
    assert len(houses(solution)) + int(out.what.split()[0]) == 60


def test_ones_own_houses_are_placed_as_they_are() -> None:
    ell = [[0, 0], [12, 0], [12, 5], [6, 5], [6, 10], [0, 10]]
    rows = [{"name": "Mine", "footprint": ell, "levels": 1, "roof": "hipped"}]
    solution = sw.solve(village(count=4, houses=rows), seed=1)
    assert {p.function for p in houses(solution)} == {"Mine"}
    areas = shapely.area(polygons_of(houses(solution)))
    assert areas == pytest.approx(np.full(len(areas), 90.0))


def test_houses_that_stand_stay_and_count() -> None:
    kept = {"id": "b/old", "house": "House", "model": "house_rural_gabled"}
    kept |= {"at": [30, 25], "heading": -1.5707963, "size": [12, 9, 8]}
    solution = sw.solve(village(count=4, fixed=[kept]), seed=0)
    found = {p.id: p for p in houses(solution)}
    assert len(found) == 4
    assert found["b/old"].fixed
    assert found["b/old"].pose[:2] == (30.0, 25.0)
    assert sw.check(solution).valid


def test_sides_along_lanes_are_streets() -> None:
    brief = village(streets=None, lanes=[{"line": [[-5, -3], [65, -3]], "width": 5}])
    (block,) = plan_of(brief).detail.blocks
    assert block.streets.tolist() == [[[0.0, 0.0], [60.0, 0.0]]]
    assert block.street_share == pytest.approx(60 / 220)


@pytest.mark.parametrize("suffix", [".svg", ".geojson", ".glb", ".png", ".street.png"])
def test_villages_are_written(suffix: str, tmp_path: Path) -> None:
    solution = sw.solve(village(count=4, origin=[11.5, 49.5]), steps=1)
    sw.write(solution, tmp_path / f"v{suffix}")
    assert (tmp_path / f"v{suffix}").stat().st_size > 500


def test_a_map_reads_as_the_village_it_was_written_from(tmp_path: Path) -> None:
    solution = sw.solve(village(count=4, origin=[11.5, 49.5]), seed=1, steps=1)
    sw.write(solution, tmp_path / "v.geojson")
    brief = sw.read(tmp_path / "v.geojson")
    (block,) = brief.part.blocks
    assert brief.domain == "village"
    assert len(block.fixed) == 4
    assert block.streets == [0]
    again = sw.solve(brief.model_copy(update={"part": _with_count(brief, 4)}))
    was, now = (polygons_of(houses(s)) for s in (solution, again))
    assert shapely.area(now) == pytest.approx(shapely.area(was), rel=1e-3)
    west, south, east, north = shapely.total_bounds(np.array([shapely.Polygon(block.outline)]))
    assert (east - west, north - south) == pytest.approx((60.0, 50.0), abs=0.01)


def _with_count(brief: Brief, count: int) -> object:
    blocks = [block.model_copy(update={"count": count}) for block in brief.part.blocks]
    return brief.part.model_copy(update={"blocks": blocks})


def test_a_saved_village_reads_back() -> None:
    solution = sw.solve(village(count=3, square=64.0), steps=1)
    again = solution_json.loads(solution_json.dumps(solution))
    assert again.pieces == solution.pieces
    assert again.patches == solution.patches


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ({"streets": []}, "no side of its outline is a street"),
        ({"streets": [9]}, "has no side 9"),
        ({"outline": [[0, 0], [40, 30], [40, 0], [0, 30]]}, "crosses or touches itself"),
        ({"outline": [[0, 0], [40, 0], [40, 2], [0, 2]]}, "no house fits"),
        ({"houses": [{"name": "Hall", "footprint": [[0, 0], [90, 0], [90, 70]]}]}, "no house fits"),
        ({"houses": [{"name": "Air"}]}, "neither footprint nor model"),
        ({"houses": [{"name": "X", "model": "zeppelin"}]}, "zeppelin"),
        ({"style": "gothic"}, "no style of villages"),
        ({"blocks": [{"outline": SQUARE, "streets": [0]}] * 2}, "overlaps blocks[0]"),
    ],
)
def test_what_cannot_be_built_on_is_refused_in_one_line(more: dict, told: str) -> None:
    with pytest.raises(InputError) as caught:
        plan_of(village(**more))
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)


def test_maps_need_a_place_on_earth(tmp_path: Path) -> None:
    solution = sw.solve(village(count=2), steps=1)
    with pytest.raises(InputError, match="origin"):
        sw.write(solution, tmp_path / "v.geojson")


def test_a_map_without_streets_takes_every_side(tmp_path: Path) -> None:
    ring = [[11.5, 49.5], [11.501, 49.5], [11.501, 49.5005], [11.5, 49.5005], [11.5, 49.5]]
    block = {"type": "Feature", "properties": {"block": "yes"}}
    block["geometry"] = {"type": "Polygon", "coordinates": [ring]}
    path = tmp_path / "m.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [block]}))
    assert sw.read(path).part.blocks[0].streets == [0, 1, 2, 3]


@pytest.mark.realdata
def test_real_blocks_are_filled_without_a_fault() -> None:
    for number, block in enumerate(real_blocks()[:: few_or_many(120, 30)]):
        outline = shapely.get_coordinates(block.floor.exterior)[:-1].round(3).tolist()
        lanes = [{"line": side.round(3).tolist(), "width": 4} for side in block.streets]
        document = {"domain": "village", "blocks": [{"outline": outline}], "lanes": lanes}
        solution = sw.solve(Brief.model_validate(document), seed=number, steps=1)
        report = sw.check(solution)
        assert report.valid, (block.name, [found.message for found in report.findings])
        assert scene_of(solution).surfaces


def test_the_data_a_village_was_learned_from_is_credited(tmp_path: Path) -> None:
    """In the credits, the scene, the map, the city model and the saved solution."""
    block = {"outline": [[0, 0], [40, 0], [40, 30], [0, 30]], "streets": [0], "count": 1}
    brief = Brief.model_validate({"domain": "village", "blocks": [block], "origin": [11.5, 48.1]})
    solution = sw.solve(brief, preset="quick")
    for name in ("a.credits.txt", "a.glb", "a.geojson", "a.city.json", "a.json"):
        sw.write(solution, tmp_path / name)
        content = (tmp_path / name).read_bytes()
        assert b"OpenStreetMap contributors" in content, name
        assert b"ODbL-1.0" in content, name


def test_every_reason_of_a_village_speaks_of_features_there_are() -> None:
    brief = sw.read("sample:village-hamlet")
    plan = plan_of(brief)
    told = features_of(sw.solve(brief, plan=plan, steps=1), plan)
    for words, wanted in reasons_of("village").items():
        assert set(wanted) <= set(told), words
