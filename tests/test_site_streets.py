"""Streets on the border of a site, across it and beside it: houses stand, whatever their line."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.domains.site.brief import Site
from scenewright.domains.site.check.streets import find_serving_streets
from scenewright.domains.site.plan import site_plan
from sites import building

GROUND = [(0, 0), (120, 0), (120, 70), (0, 70)]
WITHOUT = 5
"""Buildings that fill this ground where there is no street."""


def slope(degrees: float) -> float:
    return 160.0 * math.tan(math.radians(degrees))


LINES = {
    "on the border": [(-20, 0), (140, 0)],
    "on the border, from corner to corner": [(0, 0), (120, 0)],
    "1 m over it": [(-20, -2), (140, -2)],
    "2.5 m over it": [(-20, -0.5), (140, -0.5)],
    "touching it": [(-20, -3), (140, -3)],
    "inside along it": [(-20, 3), (140, 3)],
    "through the middle": [(-20, 35), (140, 35)],
    "0.5 m outside": [(-20, -3.5), (140, -3.5)],
    "2 m outside": [(-20, -5), (140, -5)],
    "4 m outside": [(-20, -7), (140, -7)],
    "8 m outside": [(-20, -11), (140, -11)],
    "30 m outside": [(-20, -33), (140, -33)],
    "ending at the border": [(60, -40), (60, 0)],
    "ending 5 m before it": [(60, -40), (60, -5)],
    "ending inside": [(60, -40), (60, 20)],
    "across at 45 degrees": [(-10, -20), (100, 90)],
    "across at 10 degrees": [(-20, -10), (140, -10 + slope(10))],
    "across at 3 degrees": [(-20, -6), (140, -6 + slope(3))],
    "with a kink": [(-20, -2), (60, -4), (140, -2)],
    "turning in": [(-20, -2), (60, -2), (60, 40)],
    "drawn the other way": [(140, -2), (-20, -2)],
    "wavering over the border": [(x, (-1) ** k - 1.0) for k, x in enumerate(range(-20, 141, 8))],
    "all round outside": [(-4, -4), (124, -4), (124, 74), (-4, 74), (-4, -4)],
    "all round on the border": [*GROUND, GROUND[0]],
}
OTHERS = {
    "in two pieces": [{"line": [(-20, -2), (50, -2)]}, {"line": [(50, -2), (140, -2)]}],
    "of no known width": [{"line": LINES["1 m over it"], "width": 0}],
    "half a metre wide": [{"line": LINES["on the border"], "width": 0.5}],
    "narrow and just inside": [{"line": [(-20, 0.5), (140, 0.5)], "width": 2}],
    "a path on the border": [{"line": LINES["on the border"], "width": 2, "kind": "path"}],
    "a path outside": [{"line": [(-20, -3), (140, -3)], "width": 2, "kind": "path"}],
}
STREETS = {name: [{"line": line}] for name, line in LINES.items()} | OTHERS


def fill(**site) -> sw.Solution:
    brief = sw.Brief.model_validate(
        {"domain": "site", "sites": [{"id": "g", "outline": GROUND} | site]}
    )
    return sw.solve(brief, preset="quick", seed=0)


def count(solution: sw.Solution) -> int:
    return sum(piece.category == "building" for piece in solution.pieces)


@pytest.mark.parametrize("roads", STREETS.values(), ids=STREETS)
def test_as_many_houses_stand_as_without_the_street(roads):
    solution = fill(roads=roads)
    assert count(solution) >= WITHOUT
    assert not solution.left_out
    assert [f.message for f in sw.check(solution).findings] == []


def test_the_field_case_holds_as_much_as_without_its_street():
    path = Path(__file__).parent / "data" / "field_cases" / "f01_street_overlaps_parcel_1m.json"
    solution = sw.solve(sw.read(path), seed=0)
    assert count(solution) == WITHOUT == count(fill())
    assert sw.check(solution).valid


def test_walks_lead_over_the_verge_to_the_street():
    solution = fill(roads=[{"line": LINES["4 m outside"]}])
    walks = [row.line for row in solution.detail[0].pathways if row.kind == "walk"]
    assert sum(line[-1][1] == pytest.approx(-4.0, abs=0.01) for line in walks) >= 2
    assert min(y for line in walks for _, y in line) >= -4.01


def test_a_street_beyond_the_verge_is_kept_and_noted():
    for far, said in ((8.0, False), (8.5, True)):
        solution = fill(roads=[{"id": "mill", "line": [(-20, -3 - far), (140, -3 - far)]}])
        notes = [note.message for note in sw.check(solution).notes]
        assert any("mill lies 8.5 m from the border" in text for text in notes) == said
    near = fill(roads=[{"line": [(-20, -5), (140, -5)]}], verge=1.0)
    assert any("raise verge (1 m)" in note.message for note in sw.check(near).notes)


@pytest.mark.parametrize("width", [0.2, -1.0])
def test_a_street_has_a_width_or_none_known(width):
    with pytest.raises(ValueError, match="width"):
        fill(roads=[{"line": LINES["on the border"], "width": width}])


def beside(line, **more):
    return site_plan(Site.model_validate({"outline": GROUND, "roads": [{"line": line} | more]}))


def test_the_border_is_open_where_a_street_faces_it():
    (way,) = beside([(30, -6), (60, -6)]).roads
    (mouth,) = way.mouths
    assert np.ptp(mouth, axis=0).tolist() == pytest.approx(
        [30 + 2 * math.sqrt(8**2 - 3**2), 0], abs=0.05
    )
    for name in ("through the middle", "across at 45 degrees", "ending inside", "30 m outside"):
        assert beside(LINES[name]).roads[0].mouths == ()
    assert len(beside(LINES["all round outside"]).roads[0].mouths) == 1


def test_ways_in_are_where_a_street_crosses_the_border_not_where_it_runs_along():
    assert beside(LINES["on the border"]).entrances == ()
    assert len(beside(LINES["through the middle"]).entrances) == 2
    assert len(beside(LINES["ending at the border"]).entrances) == 1


def test_the_referee_crosses_from_the_line_of_the_brief():
    site = Site.model_validate({"outline": GROUND, "roads": [{"line": LINES["4 m outside"]}]})
    floor = shapely.box(0, 0, 120, 70)
    (crossing,) = find_serving_streets(site, floor).crossings
    assert crossing.touches(floor)
    assert crossing.contains(shapely.LineString([(60, -0.1), (60, -7)]))
    assert not len(find_serving_streets(site.model_copy(update={"verge": 3.0}), floor).surfaces)


def test_the_referee_sees_what_bars_the_way_from_the_street():
    """A building that fills the site from side to side cuts off those behind it."""
    site = {"roads": [{"line": LINES["4 m outside"]}], "setback": 0, "spacing": 0}
    solution = fill(**site)
    rows = [building("wall", 60, 10, 120, 8, 6, space="g"), building("b", 60, 45, space="g")]
    judged = sw.check(
        sw.Solution(
            **{n: getattr(solution, n) for n in solution.__slots__} | {"pieces": tuple(rows)}
        )
    )
    cut_off = {f.piece for f in judged.findings if f.kind == "unreachable_building"}
    assert cut_off == {"b"}
