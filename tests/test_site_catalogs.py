"""Sites built of a user's own models: found by name, filled, drawn once, credited; and refused."""

from __future__ import annotations

import json
import struct
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from catalogs import house
from scenewright.catalog.loading import catalog_of, find_asset
from scenewright.catalog.models.licences import terms_of
from scenewright.cli import run
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.domains import check, scene_of, solve
from scenewright.domains.site.amounts import HOUSING
from scenewright.domains.site.plan import plans_of
from scenewright.formats import read, solution_json, write
from scenewright.render.items import things
from scenewright.render.level_of_detail import affordable

FIELD = [(0, 0), (150, 0), (150, 90), (0, 90)]


@pytest.fixture
def stock(tmp_path: Path) -> Path:
    """A folder of models: three houses, two towers of one name, and a broken one."""
    folder = tmp_path / "stock"
    house(folder / "cottage.obj", 10, 8, 6)
    house(folder / "row.obj", 30, 9, 9)
    house(folder / "old" / "tower.obj", 12, 12, 40)
    house(folder / "new" / "tower.obj", 14, 14, 60)
    (folder / "ruin.obj").write_text("v 0 0\nf 1 2 3\n")
    return folder


def brief(stock: object, **more) -> Brief:
    place = {"name": "Ground", "outline": FIELD, "setback": 3.0} | more
    return Brief.model_validate({"domain": "site", "catalogs": [stock], "sites": [place]})


def solved(stock: object, **more) -> Solution:
    return solve(brief(stock, **more), seed=1)


def built(solution: Solution) -> list:
    return [p for p in solution.pieces if p.category == "building" and not p.fixed]


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("cottage", "model:cottage"),
        ("model:cottage", "model:cottage"),
        ("Cottage", "model:cottage"),
        ("cottage.obj", "model:cottage"),
        ("stock/cottage.obj", "model:cottage"),
        ("new/tower", "model:tower"),
        ("old/tower.obj", "model:tower-2"),
        ("model:tower-2", "model:tower-2"),
        ("villa", "villa"),
    ],
)
def test_models_are_found_by_id_name_and_file(stock, name, meant):
    assert find_asset(catalog_of([str(stock)]), name).id == meant


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("tower", "'tower' may be any of 2 models; use one of: model:tower, model:tower-2"),
        ("cotage", "unknown model 'cotage'; use one of: cottage"),
        ("ruin", "'ruin' cannot be used: "),
        ("../stock/cottage", "unknown model"),
        ("", "unknown model"),
    ],
)
def test_names_that_mean_nothing_or_too_much_are_told(stock, name, told):
    with pytest.raises(InputError) as error:
        find_asset(catalog_of([str(stock)]), name)
    assert told in str(error.value)


def test_own_models_come_before_shipped_ones_of_the_same_name(tmp_path):
    house(tmp_path / "villa.obj", 20, 20, 20)
    catalog = catalog_of([str(tmp_path)])
    assert find_asset(catalog, "villa").id == "model:villa"
    assert catalog.assets["villa"].author == "Scenewright"


def test_a_changed_file_is_read_again(stock):
    before = find_asset(catalog_of([str(stock)]), "cottage").usual
    house(stock / "cottage.obj", 16, 8, 6)
    assert before.width == 10
    assert find_asset(catalog_of([str(stock)]), "cottage").usual.width == 16


@pytest.mark.parametrize("size", [None, (20.0, 10.0, 5.0)])
def test_a_landmark_is_drawn_as_its_file_is(stock, size):
    mark = {"model": "row", "at": (75, 45), "heading": 0.3} | ({"size": size} if size else {})
    solution = solved(str(stock), landmarks=[mark], coverage=0.1)
    (piece,) = [p for p in solution.pieces if p.fixed]
    assert piece.asset == "model:row"
    assert piece.size == pytest.approx(size or (30, 9, 9))
    (thing,) = [
        t for t in things(scene_of(solution), catalog_of([str(stock)])) if t.name == piece.id
    ]
    points = np.concatenate([part.vertices for part in thing.parts])
    own = np.concatenate(
        [p.vertices for p in catalog_of([str(stock)]).assets["model:row"].mesh(piece.size)]
    )
    assert np.ptp(points, axis=0) == pytest.approx(np.array(piece.size))
    assert points == pytest.approx(own)
    assert check(solution).valid


@pytest.mark.parametrize("size", [None, (20.0, 10.0, 5.0)])
def test_a_landmark_of_an_unknown_model_is_an_error(stock, size):
    mark = {"model": "cottge", "at": (75, 45)} | ({"size": size} if size else {})
    with pytest.raises(InputError) as error:
        plans_of(brief(str(stock), landmarks=[mark]))
    assert "landmarks[0]" in str(error.value)
    assert "cottage" in str(error.value)


def test_a_site_is_filled_from_its_catalogues_without_landmarks(stock):
    mark = {"model": "new/tower", "at": (75, 45)}
    solution = solved(str(stock), landmarks=[mark], coverage=0.3)
    used = {p.asset for p in built(solution)}
    assert used == {"model:cottage", "model:row", "model:tower-2"}
    assert check(solution).valid
    (figures,) = check(solution).figures["sites"].values()
    assert 0.1 < figures["coverage"] <= 0.32


def test_catalogues_that_do_not_fill_are_used_only_by_name(stock):
    entry = {"path": str(stock), "fill": False}
    mark = {"model": "row", "at": (75, 45)}
    solution = solved(entry, landmarks=[mark], coverage=0.2)
    assert {p.asset for p in built(solution)} <= set(HOUSING)
    asked = solved(entry, buildings=[{"model": "cottage", "count": 2}])
    assert {p.asset for p in built(asked)} == {"model:cottage"}


def test_every_model_of_a_filling_stands_about_as_often(stock):
    solution = solved(str(stock), coverage=0.2, spacing=2.0)
    counts = Counter(piece.asset for piece in built(solution))
    assert len(counts) == 4
    assert max(counts.values()) - min(counts.values()) <= 1


@pytest.mark.parametrize("ratio", [0.2, 0.5])
def test_the_floor_area_ratio_is_kept(stock, ratio):
    solution = solved(str(stock), floor_area_ratio=ratio, coverage=0.9)
    plan = plans_of(solution.brief)[0]
    floors = sum(
        p.size.width * p.size.depth * max(round(p.size.height / 3), 1) for p in built(solution)
    )
    assert floors <= ratio * plan.buildable + 14 * 14 * 20 / 2
    assert floors > 0.4 * ratio * plan.buildable


def test_a_model_larger_than_the_ground_is_left_out_and_named(stock, tmp_path):
    house(stock / "hall.obj", 200, 120, 20)
    solution = solved(str(stock), buildings=[{"model": "hall"}, {"model": "cottage", "count": 3}])
    assert [(out.what, out.required) for out in solution.left_out] == [("hall", True)]
    assert "200 x 120 m" in solution.left_out[0].reason
    assert len(built(solution)) == 3


def test_models_of_no_metric_size_are_told_and_work_with_a_size_or_scale(tmp_path):
    house(tmp_path / "block.obj", 1.0, 0.9, 1.2)
    with pytest.raises(InputError, match=r"as a building: 'block' is 1 x 0\.9 x 1\.2 m"):
        solved(str(tmp_path))
    with pytest.raises(InputError, match=r"is only 1 x 0.9 m, 1.2 m high by its file"):
        solved(str(tmp_path), buildings=[{"model": "block"}])
    sized = solved(str(tmp_path), buildings=[{"model": "block", "size": (12, 10, 15), "count": 2}])
    assert [p.size for p in built(sized)] == [(12, 10, 15)] * 2
    scaled = solved({"path": str(tmp_path), "scale": 10.0}, coverage=0.1)
    assert next(p.size for p in built(scaled)) == pytest.approx((10, 9, 12))


def test_a_landmark_that_is_small_by_its_file_is_told(tmp_path):
    house(tmp_path / "well.obj", 1.2, 1.0, 1.5)
    marks = [
        {"model": "well", "at": (30, 45)},
        {"model": "well", "at": (60, 45), "size": (1, 1, 1)},
    ]
    notes = check(solved(str(tmp_path), landmarks=marks)).notes
    assert [note.message.partition(" by")[0] for note in notes] == [
        "landmark-1 is only 1.2 x 1 m, 1.5 m high"
    ]


def test_what_stands_beside_buildings_does_not_fill_a_site(stock):
    for name in ("road_straight", "streetlight", "oak tree", "base"):
        house(stock / f"{name}.obj", 10, 10, 8)
    house(stock / "slab.obj", 20, 20, 0.5)
    house(stock / "house_without_base.obj", 10, 10, 8)
    used = {p.asset for p in built(solved(str(stock), coverage=0.5, spacing=2.0))}
    assert "model:house_without_base" in used
    assert used <= {
        "model:cottage",
        "model:row",
        "model:tower",
        "model:tower-2",
        "model:house_without_base",
    }


def document_of(path: Path) -> dict:
    content = path.read_bytes()
    (length,) = struct.unpack_from("<I", content, 12)
    return json.loads(content[20 : 20 + length])


def test_a_glb_holds_each_model_once(stock, tmp_path):
    few = solved(str(stock), buildings=[{"model": "cottage"}, {"model": "row"}])
    rows = [{"model": "cottage", "count": 60}, {"model": "row", "count": 6}]
    many = solved(str(stock), spacing=1.0, buildings=rows)
    for solution, name in ((few, "few.glb"), (many, "many.glb")):
        write(solution, tmp_path / name)
    document = document_of(tmp_path / "many.glb")
    numbers = {
        m["name"]: k for k, m in enumerate(document["meshes"]) if m["name"].startswith("model:")
    }
    assert set(numbers) == {"model:cottage", "model:row"}
    (node,) = (node for node in document["nodes"] if node.get("mesh") == numbers["model:cottage"])
    places = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"]
    placed = sum(p.asset == "model:cottage" for p in many.pieces)
    assert document["accessors"][places]["count"] == placed > 30


def test_pictures_of_heavy_models_are_taken_of_lighter_ones(stock):
    solution = solved(str(stock), buildings=[{"model": "cottage", "count": 9}])
    shown = things(scene_of(solution), catalog_of([str(stock)]))
    whole = sum(len(part.faces) for thing in shown for part in thing.parts)
    for most in (whole, 3 * whole // 5):
        drawn = affordable(shown, most)
        assert sum(len(p.faces) for thing in drawn for p in thing.parts) <= most
        assert [thing.name for thing in drawn] == [thing.name for thing in shown]
        light = {t.name for t in shown if sum(len(p.faces) for p in t.parts) <= 12}
        assert all(a.parts is b.parts for a, b in zip(drawn, shown, strict=True) if a.name in light)
        keys = {thing.key: thing.parts for thing in drawn}
        assert all(keys[thing.key] is thing.parts for thing in drawn if thing.kind == "piece")


def test_heavy_models_are_told(tmp_path, monkeypatch, capsys):
    side = np.arange(160)
    x, y = (grid.ravel() for grid in np.meshgrid(side, side))
    z = 5 + np.sin(x * y)
    corner = (side[:-1, None] * 160 + side[:-1] + 1).ravel()
    rows = [f"v {a / 10} {c} {b / 10}" for a, b, c in zip(x, y, z, strict=True)]
    rows += [f"f {k} {k + 1} {k + 161} {k + 160}" for k in corner]
    (tmp_path / "rock.obj").write_text("\n".join(rows))
    site = {"outline": FIELD, "buildings": [{"model": "rock"}]}
    document = {"domain": "site", "catalogs": ["rock.obj"], "sites": [site]}
    (tmp_path / "brief.json").write_text(json.dumps(document))
    monkeypatch.chdir(tmp_path)
    run(["arrange", "brief.json", "-o", "out.json"])
    assert "model:rock has 50,562 faces" in capsys.readouterr().err


def test_credits_tell_author_and_licence_everywhere(stock, tmp_path):
    (stock / "LICENSE.txt").write_text("Houses. Created by Jane Doe (doe.org)\nLicense: CC0")
    (stock / "old" / "licence.md").write_text("Some words of the maker")
    solution = solved(
        str(stock),
        buildings=[{"model": "cottage", "count": 2}, {"model": "old/tower"}],
        origin=[11.5, 49.5],
    )
    for name in ("out.json", "out.glb", "out.credits.txt", "out.geojson", "out.cityjson"):
        write(solution, tmp_path / name)
    text = (tmp_path / "out.credits.txt").read_text()
    assert "Jane Doe, licence CC0-1.0\n  cottage (model:cottage), 2 times\n" in text
    assert "Author not stated, licence see licence.md\n  tower (model:tower-2)\n" in text
    about = document_of(tmp_path / "out.glb")["asset"]
    assert "Jane Doe (CC0-1.0)" in about["copyright"]
    rows = json.loads((tmp_path / "out.json").read_text())["credits"]
    assert {"author": "Jane Doe", "licence": "CC0-1.0", "assets": ["model:cottage"]} in rows
    assert about["extras"]["credits"] == rows
    assert json.loads((tmp_path / "out.geojson").read_text())["credits"] == rows
    city = json.loads((tmp_path / "out.cityjson").read_text())["CityObjects"].values()
    told = [o["attributes"].get("credits") for o in city if o["type"] == "LandUse"]
    assert [one for one in told if one] == [rows]


@pytest.mark.parametrize(
    ("text", "licence"),
    [
        ("Creative Commons Attribution-NonCommercial 4.0", "CC-BY-NC"),
        ("CC BY-SA 3.0", "CC-BY-SA"),
        ("https://creativecommons.org/licenses/by/4.0/", "CC-BY"),
        ("MIT License\n\nCopyright", "MIT"),
        ("All rights reserved", "see LICENSE"),
    ],
)
def test_licence_texts_in_short(text, licence):
    assert terms_of(text, "LICENSE").licence == licence


def test_paths_are_relative_to_the_brief_and_saved_whole(stock, tmp_path, monkeypatch):
    place = {"outline": FIELD, "landmarks": [{"model": "row", "at": (75, 45)}], "coverage": 0.1}
    file = tmp_path / "deep" / "brief.json"
    file.parent.mkdir()
    file.write_text(json.dumps({"domain": "site", "catalogs": ["../stock"], "sites": [place]}))
    monkeypatch.chdir(tmp_path.parent)
    solution = solve(read(file), seed=1)
    write(solution, tmp_path / "out.json")
    back = solution_json.read(tmp_path / "out.json")
    assert back.pieces == solution.pieces
    assert check(back).valid
    assert read(tmp_path / "out.json").catalogs == solution.brief.catalogs


def test_the_command_line_takes_catalogues(stock, tmp_path, monkeypatch, capsys):
    place = {"outline": FIELD, "landmarks": [{"model": "row", "at": (75, 45)}], "coverage": 0.1}
    file = tmp_path / "brief.json"
    file.write_text(json.dumps({"domain": "site", "sites": [place]}))
    monkeypatch.chdir(tmp_path)
    assert run(["arrange", "brief.json", "-o", "out.json", "-q"]) == 2
    assert "unknown model 'row'" in capsys.readouterr().err
    assert run(["arrange", "brief.json", "--catalog", "stock", "-o", "out.json", "-q"]) == 0
    assert run(["check", "out.json", "-q"]) == 0
    (stock / "row.obj").unlink()
    assert run(["check", "out.json", "-q"]) == 2
    assert "landmarks[0]" in capsys.readouterr().err


@pytest.mark.parametrize("kind", ["missing", "empty", "broken", "text"])
def test_catalogues_that_hold_nothing_are_one_clear_error(kind, tmp_path):
    path = tmp_path / "models"
    if kind == "empty":
        path.mkdir()
    elif kind == "broken":
        path.mkdir()
        (path / "a.glb").write_bytes(b"glTF" + bytes(40))
        (path / "b.obj").write_text("f 1 2 3")
    elif kind == "text":
        path = tmp_path / "models.docx"
        path.write_text("no model")
    with pytest.raises(InputError) as error:
        solved(str(path), coverage=0.2)
    assert "models" in str(error.value)
    assert "\n" not in str(error.value)


def test_names_inside_models_do_not_lead_out_of_their_folder(stock, tmp_path):
    (tmp_path / "secret.mtl").write_text("newmtl a\nKd 1 0 0\n")
    house(stock / "spy.obj", 10, 8, 6, "mtllib ../secret.mtl")
    catalog = catalog_of([str(stock)])
    assert "model:spy" not in catalog.assets
    with pytest.raises(InputError, match=r"'spy' cannot be used: .*outside its folder"):
        find_asset(catalog, "spy")


@pytest.mark.realdata
@pytest.mark.parametrize(("folder", "scale"), [("kaykit_city", 8.0), ("kenney_city", 14.0)])
def test_low_poly_packs_fill_a_site(real_data, tmp_path, folder, scale):
    path = real_data / folder
    if not path.is_dir():
        pytest.skip(f"no {folder}")
    solution = solved({"path": str(path), "scale": scale}, coverage=0.3)
    assert check(solution).valid
    assert len(built(solution)) > 5
    used = {p.asset for p in built(solution)} - {"model:watertower"}
    assert all(name.startswith("model:building") for name in used)
    write(solution, tmp_path / "town.glb")
    assert (tmp_path / "town.glb").stat().st_size < 2_000_000
