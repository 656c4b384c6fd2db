"""Catalogues of a user's own: what is inferred, corrected by a table, and found by a name."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import numpy as np
import pytest

from scenewright.catalog.assets import shipped
from scenewright.catalog.loading import catalog_of, read_entry
from scenewright.catalog.models import register
from scenewright.catalog.models.as_asset import HEAVY, LIGHT, lighter
from scenewright.catalog.models.decimation import decimate
from scenewright.catalog.models.hues import colour_name
from scenewright.catalog.models.listing import COLUMNS, Listed, csv_text, json_text, rows, table_of
from scenewright.core.brief.catalog import CatalogBrief, entry_of
from scenewright.core.catalog import Material, Part
from scenewright.core.errors import InputError
from scenewright.core.scene import Size
from scenewright.geometry.prisms import box

RED = Material("red", (0.7, 0.1, 0.1))


def obj(size: Size) -> str:
    """A cuboid of a size, y up and the front to +z, as OBJ."""
    vertices, faces, _ = box(
        (-size.width / 2, 0, -size.depth / 2), (size.width / 2, size.height, size.depth / 2)
    )
    lines = [f"v {x} {y} {z}" for x, y, z in vertices]
    return "\n".join([*lines, *(f"f {a + 1} {b + 1} {c + 1}" for a, b, c in faces)]) + "\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A sofa, a chair in centimetres and something without a telling name."""
    place = tmp_path / "mine"
    place.mkdir()
    (place / "sofa.obj").write_text(obj(Size(2.0, 0.9, 0.8)))
    (place / "chair.obj").write_text(obj(Size(45, 50, 90)))
    (place / "zorble.obj").write_text(obj(Size(0.4, 0.6, 0.5)))
    return place


def by_id(folder: Path, scale: float = 1.0) -> dict[str, Listed]:
    return {
        one.model.id: one for one in read_entry(CatalogBrief(path=str(folder), scale=scale)).models
    }


def test_models_are_understood_and_set_in_metres(folder: Path) -> None:
    found = by_id(folder)
    assert {key: one.category for key, one in found.items()} == {
        "sofa": "sofa",
        "chair": "dining_chair",
        "zorble": "other",
    }
    assert found["chair"].model.size == pytest.approx((0.45, 0.5, 0.9))
    assert found["sofa"].model.size == pytest.approx((2.0, 0.9, 0.8))


def test_a_stated_unit_is_not_second_guessed(folder: Path) -> None:
    assert by_id(folder, scale=0.1)["chair"].model.size == pytest.approx((4.5, 5, 9))


def test_furniture_larger_than_any_is_told_and_not_used(folder: Path) -> None:
    found = read_entry(CatalogBrief(path=str(folder), scale=1.0, up="+y"))
    assert "chair" not in {one.model.id for one in found.models}
    told = {one.name: one.reason for one in found.skipped}
    assert told["chair"].startswith("is 90 m large; its category goes up to 30 m")


@pytest.mark.parametrize("suffix", ["csv", "json"])
def test_a_table_corrects_what_was_inferred(folder: Path, suffix: str) -> None:
    table = rows(read_entry(entry_of(str(folder))).models)
    for cells in table:
        if cells["id"] == "zorble":
            cells.update(
                category="nightstand",
                front="right",
                author="Ada",
                licence="CC0-1.0",
                style="oak",
                colour="green",
                width="0.5",
                depth="",
                height="",
            )
        if cells["id"] == "chair":
            cells["skip"] = "yes"
    text = csv_text(table) if suffix == "csv" else json_text(table)
    (folder / f"catalog.{suffix}").write_text(text, encoding="utf-8")
    one = by_id(folder)["zorble"]
    assert (one.category, one.style, one.colour) == ("nightstand", "oak", "green")
    assert (one.model.author, one.model.licence) == ("Ada", "CC0-1.0")
    assert one.model.size == pytest.approx((0.5, 0.4, 0.5)), "turned, then as wide as told"
    catalog = catalog_of([str(folder)])
    assert "model:zorble" in catalog.assets
    assert "model:chair" not in catalog.assets
    assert catalog.broken["chair"] == "the table skips it"


def test_the_right_side_becomes_the_front(folder: Path) -> None:
    sides = np.array([[0.2, 0.3, 0.5], [0.2, -0.3, 0.5], [0.2, 0, 0.0]])
    shape = "".join(f"v {x} {z} {-y}\n" for x, y, z in [*sides, [-0.2, 0, 0]])
    (folder / "zorble.obj").write_text(shape + "f 1 2 3\nf 2 1 4\nf 1 3 4\nf 2 4 3\n")
    (folder / "catalog.csv").write_text("id,front\nzorble,right\n")
    parts = by_id(folder)["zorble"].model.parts
    ahead = np.concatenate([part.vertices for part in parts])
    top = ahead[ahead[:, 2] > 0.4]
    read_x = by_id_plain(folder)
    assert np.sort(top[:, 0]) == pytest.approx([-0.3, 0.3])
    assert abs(top[:, 1]) == pytest.approx([abs(read_x)] * 2)


def by_id_plain(folder: Path) -> float:
    (folder / "catalog.csv").unlink()
    parts = by_id(folder)["zorble"].model.parts
    points = np.concatenate([part.vertices for part in parts])
    return float(points[points[:, 2] > 0.4][0, 0])


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("id,category\na,sofas\n", "row 1: unknown category 'sofas'"),
        ("id,front\na,+x\n", "front '+x' is not a side"),
        ("id,width\na,-1\n", "width '-1' is not possible"),
        ("id,width\na,nan\n", "width 'nan' is not possible"),
        ("id,skip\na,perhaps\n", "skip is 'perhaps'"),
        ("id,price\na,3\n", "has a column 'price'"),
        ("name\na\n", "a row has no id"),
        ("id\n" + "a\n" * 20_001, "more than 20,000 rows"),
        ("id,name\n\xff,\xfe\n", "not UTF-8 text"),
    ],
)
def test_what_a_table_cannot_say_is_told(tmp_path: Path, text: str, told: str) -> None:
    file = tmp_path / "catalog.csv"
    file.write_bytes(text.encode("latin-1"))
    with pytest.raises(InputError) as caught:
        table_of(file)
    assert told in str(caught.value)
    assert str(file) in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_registered_catalogue_is_found_by_its_name(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SCENEWRIGHT_HOME", str(tmp_path / "home"))
    table = csv_text(rows(read_entry(entry_of(str(folder))).models))
    stored = register.register("mine", folder, table.replace(",other,", ",pouf,"))
    assert register.names() == ("mine",)
    assert catalog_of(["mine"]).assets["model:zorble"].category == "pouf"
    assert catalog_of([str(folder)]).assets["model:zorble"].category == "other"
    assert json.loads((stored / "catalog.json").read_text())["path"] == str(folder)
    with pytest.raises(InputError, match="unknown file or catalogue 'yours'; registered are: mine"):
        catalog_of(["yours"])
    with pytest.raises(InputError, match="is not a valid name"):
        register.register("../mine", folder, table)


def test_the_table_has_a_row_and_a_cell_for_everything(folder: Path) -> None:
    text = csv_text(rows(read_entry(entry_of(str(folder))).models))
    read = list(csv.DictReader(io.StringIO(text)))
    assert [row["id"] for row in read] == ["chair", "sofa", "zorble"]
    assert all(tuple(row) == COLUMNS for row in read)


def test_colours_have_plain_names() -> None:
    shades = {
        "white": (1, 1, 1),
        "black": (0, 0, 0),
        "grey": (0.5, 0.5, 0.5),
        "red": (0.8, 0, 0),
        "green": (0.1, 0.6, 0.2),
        "beige": (0.9, 0.84, 0.7),
    }
    assert {name: colour_name(shade) for name, shade in shades.items()} == {n: n for n in shades}


def ball(count: int) -> Part:
    """A sphere of two triangles a patch."""
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, count + 1), np.linspace(0, np.pi, count // 2 + 1))
    points = np.stack([np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)], -1).reshape(-1, 3)
    k = (np.arange(count // 2)[:, None] * (count + 1) + np.arange(count)).ravel()
    faces = np.concatenate(
        [np.stack([k, k + count + 1, k + 1], 1), np.stack([k + 1, k + count + 1, k + count + 2], 1)]
    )
    return Part(RED, points, faces)


@pytest.mark.parametrize("most", [200, 2000, 10_000])
def test_a_thinned_ball_is_a_ball_in_the_same_box(most: int) -> None:
    part = ball(200)
    found = decimate(part, most)
    assert most * 0.9 < len(found.faces) <= most
    assert found.vertices[found.faces.ravel()].min(0) == pytest.approx([-1, -1, -1], abs=0.01)
    used = found.vertices[np.unique(found.faces)]
    assert np.abs(np.linalg.norm(used, axis=1) - 1).max() < 4 / np.sqrt(most)


def test_what_collapses_nowhere_keeps_its_largest_triangles() -> None:
    """Faces that meet at random, and a fan so large that collapsing it takes minutes."""
    rng = np.random.default_rng(1)
    wild = Part(RED, rng.random((200, 3)), rng.integers(0, 200, (20_000, 3)))
    k = np.arange(1, 30_000)
    fan = Part(RED, rng.random((30_001, 3)), np.stack([np.zeros_like(k), k, k + 1], 1))
    for part in (wild, fan):
        found = decimate(part, 500)
        assert len(found.faces) == 500
        assert found.vertices.min(0) == pytest.approx(part.vertices.min(0))
    assert not len(decimate(Part(RED, np.zeros((90, 3)), np.arange(90).reshape(-1, 3)), 12).faces)


def test_light_furniture_stays_as_it_is() -> None:
    sofa = shipped().assets["sofa"]
    parts = sofa.mesh(sofa.usual)
    assert lighter(parts) is parts
    heavy = (ball(240), *parts)
    assert sum(len(p.faces) for p in heavy) > HEAVY
    assert sum(len(p.faces) for p in lighter(heavy)) <= LIGHT + 100


def test_what_is_kept_of_a_registered_catalogue_is_what_was_read(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SCENEWRIGHT_HOME", str(tmp_path / "home"))
    stored = register.register("mine", folder, "id\nsofa\n")
    read = [one.model for one in read_entry(entry_of("mine")).models]
    copy = stored / "models.npz"
    assert copy.is_file()
    first = copy.stat().st_mtime_ns
    again = [one.model for one in read_entry(entry_of("mine")).models]
    assert copy.stat().st_mtime_ns == first
    for a, b in zip(read, again, strict=True):
        assert a._replace(parts=()) == b._replace(parts=())
        for p, q in zip(a.parts, b.parts, strict=True):
            assert p.material == q.material
            assert np.array_equal(p.vertices, q.vertices)
            assert np.array_equal(p.faces, q.faces)
    (folder / "sofa.obj").write_text(obj(Size(1.9, 0.9, 0.8)))
    assert by_id_of("mine")["sofa"].model.size.width == pytest.approx(1.9)
    for damage in (b"", b"PK\x03\x04 no archive", copy.read_bytes()[:-400]):
        copy.write_bytes(damage)
        assert len(read_entry(entry_of("mine")).models) == 3


def by_id_of(name: str) -> dict[str, Listed]:
    return {one.model.id: one for one in read_entry(entry_of(name)).models}
