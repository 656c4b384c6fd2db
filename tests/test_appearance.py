"""How models look: the shipped table, our measure against the printed one, and the cache."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scenewright.catalog import appearance
from scenewright.catalog.appearance import Facts, facts, facts_of, qualities, shipped_facts, table
from scenewright.catalog.assets import shipped
from scenewright.core.catalog import Asset, Material, Part
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, loft, merge, translate_mesh
from scenewright.geometry.prisms import box
from scenewright.geometry.relief import measure_all_round, relief
from scenewright.geometry.saliency import saliency, values_at, visual_quality

GREY = Material("grey", (0.5, 0.5, 0.5))


def model(mesh: Mesh) -> tuple[Part, ...]:
    return (Part(GREY, mesh.vertices, mesh.faces),)


def hall() -> Mesh:
    """A body with sills on its front."""
    sill = box((-0.6, 0.0, 0.0), (0.6, 0.5, 0.6))
    sills = [translate_mesh(sill, x, 6.0, z) for x in (-6, -2, 2, 6) for z in (2, 5, 8)]
    return merge([box((-10, -6, 0), (10, 6, 12)), *sills])


def spired() -> Mesh:
    """The same with a fine point on its roof."""
    ring = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
    levels = [np.column_stack([ring * r, np.full(4, z)]) for r, z in ((0.4, 12), (0.01, 18))]
    return merge([hall(), loft(levels)])


def asset_of(mesh: Mesh, name: str = "model:own") -> Asset:
    size = Size(*np.ptp(mesh.vertices, axis=0).tolist())
    return replace(shipped().assets["villa"], id=name, mesh=lambda _: model(mesh), usual=size)


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return tmp_path / "scenewright" / "appearance"


@pytest.mark.parametrize("name", ["gothic_church", "villa", "pavilion"])
def test_the_table_is_what_the_models_say(name: str) -> None:
    asset, row = shipped().assets[name], shipped_facts()[name]
    found = facts_of(asset.mesh(asset.usual))
    assert found[:4] == pytest.approx(row[:4], abs=2e-4)
    assert found.sides == pytest.approx(row.sides, abs=2e-4)


def test_every_shipped_building_is_in_the_table_and_nothing_else() -> None:
    assert set(shipped_facts()) == {asset.id for asset in shipped().of("building")}
    text = table(shipped_facts())
    assert text == Path(appearance.__file__).with_name("appearance.csv").read_text()


def test_a_fine_point_does_not_make_the_rest_plain() -> None:
    """As printed, the front's relief all but vanishes; by ours it stays what it was."""
    places = [[x, 6.5, z + 0.6] for x in (-6.6, -2.6, 1.4) for z in (2, 5, 8)]
    ours = [values_at(relief(mesh), places).mean() for mesh in (hall(), spired())]
    printed = [values_at(saliency(mesh), places).mean() for mesh in (hall(), spired())]
    assert ours[1] > 0.6 * ours[0]
    assert printed[1] < 0.6 * printed[0]
    assert visual_quality(saliency(spired())) < visual_quality(saliency(hall()))
    assert (
        measure_all_round(spired(), relief(spired())).quality
        > 0.8 * measure_all_round(hall(), relief(hall())).quality
    )


def test_a_sharp_edge_is_as_much_relief_on_any_model() -> None:
    for side in (3.0, 30.0):
        found = relief(box((0, 0, 0), (side, side, side)))
        edge, wall = values_at(found, [[side, side, side / 2], [side, side / 2, side / 2]])
        assert 0.8 < edge <= 1.0
        assert wall < 0.01
    assert relief(box((0, 0, 0), (3, 3, 3))).values.max() <= 1.0 + 1e-12


def test_quality_does_not_change_with_size_or_place_and_little_when_turned() -> None:
    mesh = spired()
    base = measure_all_round(mesh, relief(mesh))
    larger = Mesh(mesh.vertices * 7.0 + [900.0, -40.0, 3.0], mesh.faces)
    assert measure_all_round(larger, relief(larger)).quality == pytest.approx(
        base.quality, rel=0.02
    )
    c, s = np.cos(np.pi / 2), np.sin(np.pi / 2)
    turned = Mesh(mesh.vertices @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]), mesh.faces)
    assert measure_all_round(turned, relief(turned)).quality == pytest.approx(base.quality, rel=0.1)


def test_variety_tells_a_dome_from_a_box() -> None:
    ring = np.stack([np.cos(np.arange(24) * np.pi / 12), np.sin(np.arange(24) * np.pi / 12)], 1)
    dome = loft(
        [
            np.column_stack([ring * np.cos(t), np.full(24, np.sin(t))])
            for t in np.linspace(0.0, 1.5, 9)
        ]
    )
    block = box((-1, -1, 0), (1, 1, 1))
    assert (
        measure_all_round(dome, relief(dome)).variety
        > 2.0 * measure_all_round(block, relief(block)).variety
    )


def test_facts_of_other_models_are_kept(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    own, heard = asset_of(hall()), []
    first = facts([own, shipped().assets["villa"]], lambda _, name: heard.append(name))
    assert heard == [own.name]
    assert first["villa"] is shipped_facts()["villa"]
    assert len(list(cache.iterdir())) == 1
    monkeypatch.setattr(appearance, "facts_of", lambda _: pytest.fail("computed again"))
    assert facts([own]) == {own.id: first[own.id]}


def test_a_broken_cache_or_none_does_no_harm(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    own = asset_of(box((0, 0, 0), (9, 9, 9)))
    found = facts([own])[own.id]
    kept = next(cache.iterdir())
    for text in ("", "[1, 2]", '{"a": 1}', "[NaN, 1, 1, 1, 1, 1, 1, 1, 1]", "[-1,1,1,1,1,1,1,1,1]"):
        kept.write_text(text)
        assert facts([own])[own.id] == found
        assert kept.read_text().startswith("[0.")
    (cache.parent / "file").write_text("")
    monkeypatch.setenv("XDG_CACHE_HOME", str(cache.parent / "file"))
    assert facts([own])[own.id] == found


def test_a_model_of_a_shipped_name_has_its_own_facts(cache: Path) -> None:
    other = asset_of(box((0, 0, 0), (9, 9, 9)), "villa")
    assert facts([other])["villa"] != shipped_facts()["villa"]


def test_a_model_without_surface_is_plain() -> None:
    flat = Mesh(np.zeros((3, 3)), np.array([[0, 1, 2]]))
    assert facts_of(model(flat)) == appearance.PLAIN


def test_qualities_are_shares_of_the_best() -> None:
    rows = [shipped_facts()[name] for name in ("pagoda", "warehouse", "gothic_church")]
    ours, sides = qualities([*rows, Facts(9.0, 9.0, 0, 0, (9.0,) * 5), appearance.PLAIN])
    assert ours[0] == 1.0 == ours[3]
    assert ours[0] > ours[2] > ours[1] > 0.0 < ours[4]
    assert sides.shape == (5, 5)
    assert sides.max() == 1.0
    printed, same = qualities(rows, "printed")
    assert printed.max() == 1.0
    assert printed[0] < printed[2], "as printed the Gothic church is worth more than the pagoda"
    assert same == pytest.approx(sides[:3])
    assert qualities([], "relief")[0].shape == (0,)
