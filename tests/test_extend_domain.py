"""Extensions from end to end: samples grow without a fault, by seed; bad input is refused."""

from __future__ import annotations

import json
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright import cli
from scenewright.catalog.models.gltf import SceneBody
from scenewright.catalog.models.gltf_scene import TURN, _join_bodies, _turn_body
from scenewright.catalog.models.model import PLAIN
from scenewright.core.brief import Brief
from scenewright.core.catalog import Part
from scenewright.core.errors import InputError
from scenewright.core.piece_outlines import polygons_of
from scenewright.domains import plan_of
from scenewright.domains.extend.areas import OLD
from scenewright.formats import solution_json
from scenewright.geometry.solids import block
from thoroughness import THOROUGH

SAMPLES = ("extend-terrace", "extend-court", "extend-village")


def box(x: float, y: float, w: float = 10.0, d: float = 8.0) -> list[list[float]]:
    return [[x, y], [x + w, y], [x + w, y + d], [x, y + d]]


def rows(count: int = 4) -> list[dict[str, object]]:
    """Two rows of like houses, 14 m apart, 20 m between the rows."""
    return [
        {"outline": box(24.0 * k, 28.0 * j), "height": 7.0} for k in range(count) for j in range(2)
    ]


def extension(source: dict[str, object] | None = None, **area: object) -> Brief:
    given = {"buildings": rows()} if source is None else source
    row = {"id": "a", "outline": [[86, -4], [200, -4], [200, 46], [86, 46]]} | area
    return Brief.model_validate({"domain": "extend", "sources": [given], "areas": [row]})


def new(solution: sw.Solution) -> list[sw.Piece]:
    return [p for p in solution.pieces if p.category == "building" and p.space != OLD]


@pytest.mark.parametrize("name", SAMPLES)
@pytest.mark.parametrize("seed", [0, 1])
def test_samples_grow_and_break_no_rule(name: str, seed: int) -> None:
    preset = "default" if seed == 0 or THOROUGH else "quick"
    solution = sw.solve(sw.read(f"sample:{name}"), seed=seed, preset=preset, steps=1)
    report = sw.check(solution)
    assert report.valid, [found.message for found in report.findings]
    for area, found in zip(
        solution.brief.part.areas, report.figures["areas"].values(), strict=True
    ):
        assert found["buildings"] >= 10
        assert area.count is not None or found["coverage"] == pytest.approx(
            found["source_coverage"], rel=0.35
        )


def test_rows_go_on_at_their_pitch() -> None:
    """Fronts stay in line and houses 24 m apart, as they are in the source."""
    solution = sw.solve(extension(), seed=3, preset="quick", steps=2)
    poses = np.array([[p.pose.x, p.pose.y] for p in new(solution)])
    assert len(poses) >= 8
    in_line = np.isin(poses[:, 1].round(3), (4.0, 32.0))
    assert in_line.mean() >= 0.8
    on_pitch = np.abs((poses[in_line, 0] - 5.0 + 12.0) % 24.0 - 12.0) < 0.01
    assert on_pitch.mean() >= 0.8


def test_rows_that_end_at_the_border_go_on_with_their_string() -> None:
    """Passages and kinds follow in order, fronts stay in line, and a bent street is followed."""
    wide = [9.0, 9.0, 14.0, 9.0]
    at, found = 0.0, []
    for k in range(8):
        found.append({"outline": box(at, 0.0, wide[k % 4]), "height": 7.0, "heading": -1.570796})
        at += wide[k % 4] + (6.0 if k % 4 == 3 else 1.0)
    street = {"line": [[-5, -9], [100, -9]], "width": 6}
    outline = [[at - 4, -30], [at + 120, -30], [at + 120, 30], [at - 4, 30]]
    source = {"buildings": found, "roads": [street]}
    solution = sw.solve(extension(source, outline=outline, count=7), preset="quick")
    made = sorted(new(solution), key=lambda p: p.pose.x)
    line = [p for p in made if abs(p.pose.y - p.size.depth / 2) < 1e-6]
    assert len(line) >= 6
    widths = [round(p.size.width) for p in line]
    assert "".join("B" if w == 14 else "A" for w in widths[:4]) in "AABAAABAAABA"


def test_a_source_turned_and_moved_grows_the_same_turned_and_moved() -> None:
    def turn(points: list[list[float]]) -> list[list[float]]:
        return [[500.0 - y, 200.0 + x] for x, y in points]

    source = {"buildings": [row | {"heading": -1.5707963267948966} for row in rows()]}
    turned = {
        "buildings": [
            row | {"outline": turn(row["outline"]), "heading": 0.0} for row in source["buildings"]
        ]
    }
    outline = [[86, -4], [200, -4], [200, 46], [86, 46]]
    one = sw.solve(extension(source, coverage=0.1), seed=1, preset="strict", steps=1)
    other = sw.solve(
        extension(turned, outline=turn(outline), coverage=0.1), seed=1, preset="strict", steps=1
    )
    here = sorted((round(p.pose.x, 2), round(p.pose.y, 2)) for p in new(one))
    there = sorted((round(p.pose.y - 200, 2), round(500 - p.pose.x, 2)) for p in new(other))
    assert len(here) == len(there)
    shared = len(set(here) & set(there))
    assert shared >= 0.7 * len(here)


def test_nothing_new_overlaps_or_leaves_the_area() -> None:
    solution = sw.solve(extension(), seed=0, preset="quick")
    shapes = polygons_of(new(solution))
    floor = shapely.box(86, -4, 200, 46).buffer(1e-2)
    assert shapely.covers(floor, shapes).all()
    assert shapely.union_all(shapes).area == pytest.approx(shapely.area(shapes).sum())


def test_counts_are_met_or_left_out_with_the_reason() -> None:
    assert len(new(sw.solve(extension(count=5), seed=0, preset="quick"))) == 5
    crowded = sw.solve(extension(count=90), seed=0, preset="quick")
    (out,) = crowded.left_out
    assert out.required
    assert len(new(crowded)) + int(out.what.split()[0]) == 90


def test_streets_that_end_at_the_border_go_on() -> None:
    source = {"buildings": rows(), "roads": [{"line": [[-5, 18], [84, 18]], "width": 6}]}
    brief = extension(source)
    (area,) = plan_of(brief).detail.areas
    (street,) = area.continued
    assert street.line.tolist() == [[84.0, 18.0], [200.0, 18.0]]
    shapes = polygons_of(new(sw.solve(brief, preset="quick")))
    assert not shapely.intersects(shapes, shapely.box(86, 15.01, 200, 20.99)).any()
    (none,) = plan_of(extension(source, continue_streets=False)).detail.areas
    assert none.continued == ()


def test_several_sources_are_followed_in_their_shares() -> None:
    small = [{"outline": box(20 * k, 400, 6, 6), "height": 4} for k in range(6)]
    large = [{"outline": box(40 * k, 600, 20, 12), "height": 15} for k in range(6)]

    def heights(share: float) -> float:
        brief = Brief.model_validate(
            {
                "domain": "extend",
                "sources": [{"buildings": small, "share": share}, {"buildings": large}],
                "areas": [{"id": "a", "outline": box(0, 0, 160, 160), "count": 16}],
            }
        )
        return float(np.mean([p.size.height for p in new(sw.solve(brief, seed=1, preset="quick"))]))

    assert heights(8.0) < heights(0.125)


def test_rows_of_the_brief_are_laid_as_written() -> None:
    kinds = [{"outline": box(30.0 * k, 0.0, 10.0 + 6 * (k % 2)), "height": 7.0} for k in range(4)]
    row = {"pattern": "(A B)^2 - A", "line": [[100, 20], [190, 20]], "gap": 2.0}
    solution = sw.solve(extension({"buildings": kinds}, rows=[row], count=5), preset="quick")
    found = sorted(new(solution), key=lambda p: p.pose.x)
    assert [p.function for p in found] == ["A", "B", "A", "B", "A"]
    edges = [(p.pose.x - p.size.width / 2, p.pose.x + p.size.width / 2) for p in found]
    gaps = [b[0] - a[1] for a, b in pairwise(edges)]
    assert gaps == pytest.approx([2.0, 2.0, 2.0, 5.0])
    assert {round(p.pose.y - p.size.depth / 2, 6) for p in found} == {20.0}
    with pytest.raises(InputError, match="no kind 'Z'"):
        sw.solve(extension({"buildings": kinds}, rows=[row | {"pattern": "A Z"}]), preset="quick")


@pytest.mark.parametrize("suffix", [".svg", ".geojson", ".glb", ".png", ".json", ".city.json"])
def test_extensions_are_written(suffix: str, tmp_path: Path) -> None:
    brief = extension(count=4).model_copy()
    part = brief.part.model_copy(update={"origin": (11.5, 49.5)})
    solution = sw.solve(brief.model_copy(update={"part": part}), preset="quick")
    sw.write(solution, tmp_path / f"e{suffix}")
    assert (tmp_path / f"e{suffix}").stat().st_size > 500


def test_a_map_reads_as_the_brief_it_was_written_from(tmp_path: Path) -> None:
    brief = extension(count=4)
    part = brief.part.model_copy(update={"origin": (11.5, 49.5)})
    solution = sw.solve(brief.model_copy(update={"part": part}), preset="quick")
    sw.write(solution, tmp_path / "e.geojson")
    again = sw.read(tmp_path / "e.geojson")
    assert again.domain == "extend"
    assert len(again.part.sources[0].buildings) == len(solution.pieces)
    area = shapely.Polygon(again.part.areas[0].outline).area
    assert area == pytest.approx(114 * 50, rel=1e-4)


def test_a_city_model_written_is_a_source_again(tmp_path: Path) -> None:
    first = sw.solve(extension(count=4), preset="quick")
    sw.write(first, tmp_path / "first.city.json")
    outline = [[202, -4], [300, -4], [300, 46], [202, 46]]
    source = {"path": str(tmp_path / "first.city.json"), "stands": False}
    second = sw.solve(extension(source, outline=outline, count=4), preset="quick")
    assert len(new(second)) == 4
    sizes = {(round(p.size.width), round(p.size.height)) for p in new(second)}
    assert sizes == {(10, 6)}  # up to the ridge; chimneys are not written
    assert all(p.asset.startswith("model:first") for p in new(second))


def test_a_saved_solution_is_a_source(tmp_path: Path) -> None:
    sw.write(sw.solve(extension(count=4), preset="quick"), tmp_path / "first.json")
    brief = {
        "domain": "extend",
        "sources": [{"path": "first.json"}],
        "areas": [{"outline": [[202, -4], [300, -4], [300, 46], [202, 46]], "count": 4}],
    }
    (tmp_path / "second.json").write_text(json.dumps(brief))
    solution = sw.solve(sw.read(tmp_path / "second.json"), preset="quick")
    assert len(new(solution)) == 4
    assert len(solution.pieces) == 16
    assert solution_json.loads(solution_json.dumps(solution)).pieces == solution.pieces


def test_what_is_wrong_with_a_source_is_left_out_by_name() -> None:
    bad = [
        {"id": "line", "outline": [[0, 90], [9, 90], [18, 90]]},
        {"id": "inside", "outline": box(1, 1, 4, 4)},
    ]
    solution = sw.solve(extension({"buildings": [*rows(), *bad]}, count=3), preset="quick")
    told = {out.what: out for out in solution.left_out}
    assert not any(out.required for out in told.values())
    assert {"line: has no usable footprint", "inside: overlaps another building"} == set(told)


@pytest.mark.parametrize(
    ("source", "area", "message"),
    [
        ({"buildings": rows()[:1]}, {}, "no arrangement can be learned"),
        ({}, {}, "has no buildings"),
        ({"path": "nowhere.geojson"}, {}, "there is no such file"),
        ({"path": "a.txt", "buildings": rows()}, {}, "names a file and draws buildings"),
        (None, {"outline": box(0, 0, 10, 8)}, "nothing of it is free"),
        (None, {"outline": [[0, 0], [9, 9], [9, 0], [0, 9]]}, "crosses or touches itself"),
        ({"buildings": [row | {"model": "castle"} for row in rows()]}, {}, "unknown model"),
        (None, {"use": "catalogue"}, "hold no building"),
    ],
)
def test_bad_input_is_refused_in_one_line(
    source: dict[str, object] | None, area: dict[str, object], message: str
) -> None:
    with pytest.raises(InputError, match=message) as caught:
        sw.solve(extension(source, **area), preset="quick")
    assert "\n" not in str(caught.value)


def test_maps_in_unknown_systems_are_refused(tmp_path: Path) -> None:
    ring = [[4.5e5, 5.4e6], [4.6e5, 5.4e6], [4.6e5, 5.5e6], [4.5e5, 5.4e6]]
    feature = {
        "type": "Feature",
        "properties": {"building": "yes"},
        "geometry": {"type": "Polygon", "coordinates": [ring]},
    }
    path = tmp_path / "map.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [feature]}))
    with pytest.raises(InputError, match="no longitude and latitude"):
        sw.solve(extension({"path": str(path)}))


def test_a_scene_of_models_is_a_source(tmp_path: Path) -> None:
    """A GLB of ours: every building is found where it stood, copies share a model and a kind."""
    first = sw.solve(extension(count=4), preset="quick")
    sw.write(first, tmp_path / "first.glb")
    outline = [[202, -4], [300, -4], [300, 46], [202, 46]]
    for path in (tmp_path / "first.glb", tmp_path):
        brief = extension({"path": str(path)}, outline=outline, count=4)
        (scene,) = plan_of(brief).detail.sources
        before = sorted(p.pose[:2] for p in first.pieces if p.category == "building")
        found = sorted(tuple(np.mean(one.outline, axis=0)) for one in scene.buildings)
        assert np.allclose(found, before, atol=0.3)
        second = sw.solve(brief, preset="quick")
        assert len(new(second)) == 4
        assert sw.check(second).valid
        assert {p.asset.partition("/")[0] for p in new(second)} == {"model:first"}


def test_bodies_that_overlap_are_one_building_and_ground_is_none() -> None:
    def body(x: float, low: float, high: float, wide: float = 8.0, mesh: int = 0) -> SceneBody:
        made = block((x, x + wide), (0, 6), (low, high))
        corners = made.vertices @ np.linalg.inv(TURN).T
        return SceneBody("b", "", (Part(PLAIN, corners, made.faces),), mesh, np.eye(4))

    bodies = [body(0, 0, 3), body(0, 3, 5), body(30, 0, 4), body(-50, -0.2, 0, 130.0)]
    groups = _join_bodies([_turn_body(one, 1.0) for one in bodies])
    assert [len(group) for group in groups] == [2, 1]


def test_a_source_away_from_its_borders_grows() -> None:
    """Nothing stands along an edge: nothing is learned of edges, and that is no fault."""
    far = [[-90, -90], [86, -90], [86, 130], [-90, 130]]
    source = {"buildings": rows(), "outline": far}
    solution = sw.solve(extension(source, count=6), preset="quick", steps=2)
    assert len(new(solution)) == 6
    assert sw.check(solution).valid


def test_models_without_surface_are_left_out_by_name(tmp_path: Path) -> None:
    kinds = [{"outline": box(24.0 * k, 0.0, 10.0 + k % 2), "height": 7.0} for k in range(6)]
    sw.write(
        sw.solve(extension({"buildings": kinds}, count=2), preset="quick"), tmp_path / "first.glb"
    )
    content = (tmp_path / "first.glb").read_bytes()
    end = 20 + int.from_bytes(content[12:16], "little")
    document = json.loads(content[20:end])
    node = next(n for n in document["nodes"] if n.get("extras", {}).get("category") == "building")
    for primitive in document["meshes"][node["mesh"]]["primitives"]:
        primitive["mode"] = 1
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    whole = b"JSON" + text + content[end:]
    header = content[:8] + (16 + len(whole)).to_bytes(4, "little")
    (tmp_path / "bare.glb").write_bytes(header + len(text).to_bytes(4, "little") + whole)
    bare = [n["name"] for n in document["nodes"] if n.get("mesh") == node["mesh"]]
    assert 0 < len(bare) < 7
    outline = [[202, -4], [300, -4], [300, 46], [202, 46]]
    brief = extension({"path": str(tmp_path / "bare.glb")}, outline=outline, count=3)
    told = {out.what for out in sw.solve(brief, preset="quick").left_out}
    assert {f"{name}: has no surface" for name in bare} <= told


def test_an_area_too_small_for_any_building_says_so() -> None:
    rings = [[[x, 0], [x + 8, 0], [x + 8, 9], [x, 9]] for x in (0, 12, 24)]
    source = {"buildings": [{"outline": ring} for ring in rings]}
    outline = [(40, 0), (43, 0), (43, 3), (40, 3)]
    solution = sw.solve(extension(source, outline=outline), preset="quick")
    assert [(one.what, one.required) for one in solution.left_out] == [("all buildings", False)]
    assert "none fits on 9 m²" in solution.left_out[0].reason


def test_alternatives_say_what_they_are(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["arrange", "sample:extend-village", "--preset", "quick", "--alternatives", "2"]
    assert cli.run([*words, "-o", str(tmp_path / "edge.json")]) == 0
    told = capsys.readouterr().out
    assert "plan 1: New edge: 20 buildings, " in told
    assert "% in patches" in told or "% in rows" in told
