"""The plan of a site: everything is where it is, to scale, and nothing in it is alive."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest

from deadline import within
from scenewright.domains import check
from scenewright.domains.site.drawing import marks as svg_site_marks
from scenewright.domains.site.drawing import plan as svg_site
from scenewright.domains.site.drawing.marks import FAULT, HATCH, tint
from scenewright.domains.site.drawing.views import views_of
from scenewright.domains.site.plan import plans_of
from scenewright.drawing.svg import write_svg
from scenewright.formats import svg
from sites import answer, building, field, quarter, site

SVG = "{http://www.w3.org/2000/svg}"


def draw_site(solution, views=None):
    return write_svg(svg_site.plan(solution, plans_of(solution.brief), check(solution), views))


def drawn(ground, pieces, views=None):
    return ElementTree.fromstring(draw_site(answer(ground, pieces), views))


def words(root):
    return [element.text or "" for element in root.iter(f"{SVG}text")]


def points(path):
    return np.array(re.findall(r"-?\d+\.?\d*", path.get("d", "")), float).reshape(-1, 2)


def shapes_named(root, start):
    for mark in root.iter(f"{SVG}g"):
        told = mark.find(f"{SVG}title")
        if told is not None and (told.text or "").startswith(start):
            yield mark.find(f"{SVG}path")


def test_buildings_stand_to_scale_north_up():
    first, second = building("a", 20, 20, 30, 10, asset="low"), building("b", 60, 50, asset="high")
    root = drawn(site(), [first, second])
    scale = float(next(w for w in words(root) if w.startswith("1:"))[2:])
    a, b = (points(next(shapes_named(root, name))) for name in ("low", "high"))
    assert np.ptp(a, axis=0) * scale / 1000 == pytest.approx([30, 10], abs=0.02)
    assert (b.mean(0) - a.mean(0)) * scale / 1000 == pytest.approx([40, -30], abs=0.02)


def test_landmarks_are_hatched_and_faults_red():
    ground, pieces = quarter()
    root = drawn(ground, pieces)
    fills = [path.get("fill") for path in shapes_named(root, "Rotunda")]
    assert fills == [HATCH]
    told = [
        mark.find(f"{SVG}title").text
        for group in root.iter(f"{SVG}g")
        if group.get("stroke") == FAULT
        for mark in group.findall(f"{SVG}g")
    ]
    assert any("stands on walk" in line for line in told)
    assert any("m apart, 7 m are required" in line for line in told)
    assert {"Mill Lane", "Rotunda", "18 m", "6 st"} <= set(words(root))
    clean = drawn(ground.model_copy(update={"spacing": 0.0}), pieces[:3])
    assert not any("apart" in (e.text or "") for e in clean.iter(f"{SVG}title"))


def test_the_legend_tells_figures_and_only_signs_in_use():
    ground, pieces = quarter()
    seen = words(drawn(ground, pieces))
    assert {"Road", "Path", "Landmark", "4–6 storeys", "Coverage", "Faults"} <= set(seen)
    plain = words(drawn(site(), [building("a", 20, 20)]))
    assert not {"Road", "Path", "Landmark", "Tree", "Setback", "Violation, distance in metres"} & {
        *plain
    }
    assert tint(3) != tint(4)


def test_what_walkers_see_is_drawn_where_it_is_told():
    places = np.array([(10.0, 10.0), (15.0, 10.0), (20.0, 10.0), (60.0, 70.0)])
    views = {"s": (places, np.array([0.0, 0.15, 0.3, 2.0]))}
    root = drawn(site(), [building("a", 20, 20)], views)
    band = [p for p in root.iter(f"{SVG}path") if p.get("stroke", "").startswith("#")]
    colours = [svg_site_marks.view_colour(share) for share in (0.0, 0.5, 1.0)]
    strokes = [path for path in band if path.get("stroke") in colours]
    assert [path.get("stroke") for path in strokes] == [*colours, colours[2]]
    first, second, third, alone = (points(path) for path in strokes)
    assert first[-1] == pytest.approx(second[0])
    assert second[-1] == pytest.approx(third[0])
    assert np.ptp(alone, axis=0) == pytest.approx([0, 0])
    assert {"Much to see", "Visual quality seen from the ways", "0.613"} <= set(words(root))


def test_views_are_those_of_a_walker_by_the_models():
    ground = site(120, 80, roads=[{"line": [(0, 5), (120, 5)], "width": 6}])
    rich, plain = (
        building("a", 60, 20, 24, 24, 40, asset=model) for model in ("pagoda", "modern_residential")
    )
    told = {}
    for piece in (rich, plain):
        solution = answer(ground, [piece])
        views = views_of(solution, plans_of(solution.brief))
        eyes, values = views["s"]
        assert eyes[:, 1] == pytest.approx(5.0)
        assert np.argmax(values) in range(8, 16), "most before the building"
        told[piece.asset] = values.mean()
    assert told["pagoda"] > 1.5 * told["modern_residential"] > 0.0
    broken = answer(ground, [building("far", 1e9, 0), building("nan", np.nan, 0)])
    assert views_of(broken, plans_of(broken.brief)) == {}
    lonely = answer(site(), [rich])
    assert views_of(lonely, plans_of(lonely.brief)) == {}


def test_hostile_names_and_places_are_harmless():
    ground, _ = quarter()
    odd = '<script>"&\u202e' * 9
    pieces = [
        building(odd, 20, 20, asset=odd),
        building("far", 1e9, 0),
        building("nan", np.nan, 0),
        building("flat", 20, 50, h=0.0),
    ]
    text = draw_site(answer(ground, pieces, name=odd))
    assert "<script" not in text
    root = ElementTree.fromstring(text)
    assert float(root.get("width", "0mm")[:-2]) <= 841
    assert not [e for e in root.iter() if e.tag.endswith(("script", "style", "image"))]


def test_large_sites_are_drawn_in_little_space(tmp_path):
    ground, pieces = field(1500)
    with within(60):
        svg.write(answer(ground, pieces), tmp_path / "plan.svg")
    assert (tmp_path / "plan.svg").stat().st_size < 3e6
    assert [p.name for p in tmp_path.iterdir()] == ["plan.svg"]


def test_models_have_letters_by_number_with_counts_in_the_legend():
    pieces = [building(f"v{k}", 15 + 25 * k, 20, asset="villa") for k in range(3)]
    pieces.append(building("r", 30, 60, 30, 10, asset="row_houses"))
    drawing = drawn(site(), pieces)
    told = words(drawing)
    assert told.count("A") == 3 * 2 + 1  # three buildings, each over a halo, and the legend
    assert told.count("B") == 1 * 2 + 1
    assert any(word.startswith("3 × ") for word in told)
    assert any(word.startswith("1 × ") for word in told)


def test_sites_are_drawn_on_handy_paper_and_labels_stay_within_their_buildings():
    grid = [building(f"v{k}", 20 + 20 * (k % 30), 20 + 20 * (k // 30), 14, 12) for k in range(900)]
    root = drawn(site(outline=[(0, 0), (640, 0), (640, 640), (0, 640)], roads=[]), grid)
    assert float(root.get("width", "0mm")[:-2]) <= 594.0
    sizes = [float(t.get("font-size", "0")) for t in root.iter(f"{SVG}text") if t.text == "A"]
    assert min(sizes) >= 1.0
