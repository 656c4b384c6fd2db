"""Sites that cannot be: every bad brief is one line with its remedy, or a site that tells what it
leaves out. Nothing of it may hang, crash or break a rule."""

from __future__ import annotations

import json
import math
import os
import re
from pathlib import Path
from typing import Any

import pytest

import scenewright
from deadline import within
from scenewright import cli
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains import check

LIMIT = 30
"""Seconds within which every brief is answered on a busy machine, once the code is compiled."""

Ground = dict[str, Any]


def box(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def ring(count: int, radius: float, jag: float = 0.0) -> list[list[float]]:
    turns = [2 * math.pi * k / count for k in range(count)]
    far = [radius + jag * (k % 2) for k in range(count)]
    return [[r * math.cos(a), r * math.sin(a)] for r, a in zip(far, turns, strict=True)]


def site(**more: Any) -> Ground:
    """120 by 80 metres for three villas."""
    plain = {
        "id": "s",
        "outline": box(0, 0, 120, 80),
        "buildings": [{"model": "villa", "count": 3}],
    }
    return plain | more


def asks(**building: Any) -> Ground:
    return site(buildings=[{"model": "villa"} | building])


def road(*line: list[float], **more: Any) -> Ground:
    return site(roads=[{"line": list(line)} | more])


def stands(*rows: Ground) -> Ground:
    return site(landmarks=list(rows))


HERE = {"at": [30, 30], "size": [10, 10, 10]}

FAULTS: dict[str, tuple[Ground, str]] = {
    "an outline that crosses itself": (
        site(outline=[[0, 0], [100, 80], [100, 0], [0, 80]]),
        "itself at (50.00, 40.00)",
    ),
    "an outline on a line": (site(outline=[[0, 0], [100, 0], [50, 0]]), "holds only 0 m²"),
    "an outline of two corners": (site(outline=[[0, 0], [9, 0]]), "needs at least 3 corners"),
    "an outline of 100 000 corners": (site(outline=ring(100_000, 200)), "at most 5000 corners"),
    "a number that is none": (site(outline=[[0, 0], [float("nan"), 0], [5, 5]]), "NaN is not"),
    "an endless distance": (site(spacing=float("inf")), "Infinity is not a number"),
    "huge numbers": (site(outline=box(0, 0, 1e12, 1e12)), "sites[0].outline[1][0]"),
    "projected coordinates": (
        site(outline=box(390_000, 5_819_000, 390_120, 5_819_080)),
        "sites[0].outline[0][0]",
    ),
    "degrees for metres": (
        site(outline=[[13.37, 52.51], [13.38, 52.51], [13.38, 52.52], [13.37, 52.52]]),
        "holds only 0.0001 m² of ground; give its corners in metres",
    ),
    "a site of two metres": (site(outline=box(0, 0, 2, 2)), "the setback of 3 m leaves nothing"),
    "a setback that leaves nothing": (
        site(outline=box(0, 0, 120, 30), setback=18),
        "give a setback of less than 15.00 m",
    ),
    "buildings kilometres apart": (site(spacing=500), "sites[0].spacing: 500 is not possible"),
    "fronts many times round": (site(facing=1e3), "sites[0].facing: 1000"),
    "a hole outside": (site(holes=[box(200, 200, 210, 210)]), "holes[0] lies outside"),
    "a hole that takes all": (site(holes=[box(-5, -5, 130, 90)]), "leaves nothing of the site"),
    "a hole that cuts": (site(holes=[box(50, -5, 60, 90)]), "cuts the site in 2 pieces"),
    "a hole that crosses itself": (
        site(holes=[[[10, 10], [40, 40], [40, 10], [10, 40]]]),
        "holes[0] crosses or touches",
    ),
    "a building of no size": (asks(size=[0, 0, 0]), "buildings[0].size[0]: 0 is not possible"),
    "a building of a millimetre": (
        asks(size=[0.001, 0.001, 0.001], count=20_000),
        "buildings[0].size[0]: 0.001 is not",
    ),
    "a building in millimetres": (asks(size=[14_000, 12_000, 9000]), "size[0]: 14000 is not"),
    "no buildings of a model": (asks(count=0), "buildings[0].count: 0 is not possible"),
    "more than can be": (
        site(buildings=[{"model": "villa", "count": 15_000}] * 2),
        "asks for 30000 buildings",
    ),
    "an unknown model": (asks(model="castle"), "'castle'"),
    "furniture for a building": (asks(model="sofa"), "'sofa' is not a building"),
    "higher than the limit": (site(height_limit=5), "is 9 m high, the limit of the site is 5 m"),
    "a limit below all dwellings": (
        site(height_limit=5, buildings=[]),
        "no dwelling is as low as the height limit of 5 m",
    ),
    "a landmark outside": (stands({"at": [300, 300], "size": [9, 9, 9]}), "outside the site"),
    "landmarks that overlap": (
        stands(HERE, HERE | {"at": [35, 30]}),
        "overlaps landmarks[0] 'landmark-1' by 50.00 m²",
    ),
    "a landmark without a place": (stands({"model": "villa"}), "landmarks[0]: has no place"),
    "a landmark without a size": (stands({"at": [30, 30]}), "its size is not known"),
    "a landmark of an unknown model": (
        stands({"model": "vila", "at": [60, 40]}),
        "unknown model 'vila'",
    ),
    "a landmark that takes all": (
        stands({"at": [60, 40], "size": [118, 78, 9]}),
        "leave nothing to build on",
    ),
    "a road of hardly a width": (road([0, 40], [120, 40], width=0.2), "roads[0].width: "),
    "a road of no length": (road([5, 40], [5, 40]), "roads[0]: the road has no length"),
    "a road of one point": (road([5, 40]), "roads[0].line: needs at least 2"),
    "a road that takes all": (road([0, 40], [120, 40], width=100), "leave nothing to build on"),
    "5000 roads that take all": (
        site(
            roads=[{"line": [[k * 0.024, -5], [k * 0.024, 90]], "width": 0.5} for k in range(5000)]
        ),
        "leave nothing to build on",
    ),
    "5000 roads across each other": (
        site(
            roads=[
                {"line": [[k * 7919 % 120, -5], [k * 104729 % 120, 85.5]], "width": 0.5}
                for k in range(5000)
            ]
        ),
        "roads: the roads cross each other more than 20000",
    ),
    "a latitude beyond the pole": (site(latitude=95), "sites[0].latitude: 95 is not possible"),
    "an id used twice": (stands(HERE | {"id": "a"}, HERE | {"id": "a"}), "the id 'a' is used"),
}
"""What is wrong, the site, and what is told."""


def told_for(document: Any, name: str, capsys: pytest.CaptureFixture[str]) -> str:
    """The one line told for a document that cannot be used, and nothing written."""
    Path(name).write_text(json.dumps(document))
    with within(LIMIT):
        assert cli.run(["arrange", name, "-o", "out.svg", "-o", "out.street.png"]) == 2
    out, line = capsys.readouterr()
    assert out == ""
    assert line.startswith(f"scenewright: {name}: ")
    assert line.count("\n") == 1
    assert re.search(r"; \w.{7,}$", line), "no remedy"
    assert os.listdir() == [name]
    return line


@pytest.mark.parametrize("name", FAULTS)
def test_a_bad_site_is_one_line_and_writes_nothing(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    ground, told = FAULTS[name]
    assert told in told_for({"domain": "site", "sites": [ground]}, "site.json", capsys)


def feature(ring_: list[list[float]], **tags: str) -> dict[str, Any]:
    geometry = {"type": "Polygon", "coordinates": [[*ring_, ring_[0]]]}
    return {"type": "Feature", "properties": tags, "geometry": geometry}


def berlin(swapped: bool = False, wide: float = 0.002) -> list[list[float]]:
    ring_ = box(13.37, 52.51, 13.37 + wide, 52.51 + wide)
    return [[y, x] for x, y in ring_] if swapped else ring_


METRES = {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::3857"}}
MAPS: dict[str, tuple[list[dict[str, Any]], dict[str, Any], str]] = {
    "an empty map": ([], {}, "holds no"),
    "only buildings": ([feature(berlin(), building="yes")], {}, "holds no outline of a site"),
    "a speck": ([feature(berlin(wide=1e-6), site="yes")], {}, "holds only"),
    "degrees called metres": ([feature(berlin(), site="yes")], {"crs": METRES}, ""),
    "a country": ([feature(berlin(wide=3.0), site="yes")], {}, "spread over 3 degrees"),
}
"""Features of a map, what else it says, and what is told."""


@pytest.mark.parametrize("name", MAPS)
def test_a_bad_map_is_one_line(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    features, more, told = MAPS[name]
    document = {"type": "FeatureCollection", "features": features} | more
    assert told in told_for(document, "map.geojson", capsys)


def answer(ground: Ground) -> Solution:
    brief = Brief.model_validate({"domain": "site", "sites": [ground]})
    return scenewright.solve(brief, preset="quick", threads=1)


SHORT: dict[str, tuple[Ground, str]] = {
    "larger than the site": (asks(size=[300, 200, 10]), "Villa"),
    "as wide as the site": (asks(size=[118, 20, 10]), "Villa"),
    "20 000 on a hectare": (asks(count=20_000), r"199\d\d of 20000 Villa"),
    "a site eight metres wide": (
        site(outline=[[0, 0], [1000, 0], [1000, 8], [0, 8.01]]),
        "3 of 3 Villa",
    ),
    "far from each other": (
        site(outline=box(0, 0, 50, 30), spacing=20, setback=0),
        r"[12] of 3 Villa",
    ),
}
"""What is asked for, and what is left out."""


@pytest.mark.parametrize("name", SHORT)
def test_what_finds_no_place_is_told(name: str) -> None:
    ground, what = SHORT[name]
    with within(LIMIT):
        found = answer(ground)
        report = check(found)
    assert not [f for f in report.findings if f.kind not in ("left_out",)]
    assert len(found.left_out) == 1
    assert re.fullmatch(what, found.left_out[0].what)
    assert "no place left" in found.left_out[0].reason


FINE: dict[str, Ground] = {
    "points given twice": site(
        outline=[[0, 0], [0, 0], [120, 0], [120, 0], [120, 80], [0, 80], [0, 80], [0, 0]]
    ),
    "holes that overlap": site(holes=[box(10, 10, 40, 40), box(30, 30, 60, 60)]),
    "a hole at the border": site(holes=[box(0, 10, 40, 40)]),
    "a jagged outline": site(outline=ring(1000, 80, 9.0)),
    "a road that crosses itself": road([0, 40], [120, 40], [60, 70], [60, 0]),
    "forty roads across each other": site(
        outline=box(0, 0, 1000, 800),
        roads=[
            {"line": [[k * 79 % 997, -5], [k * 47 % 991, 805]], "width": 0.5} for k in range(40)
        ],
    ),
    "a road there and back": road([0, 40], [120, 40], [0, 40], [120, 40]),
    "a landmark on a road": road([0, 40], [120, 40]) | {"landmarks": [HERE | {"at": [60, 40]}]},
    "a landmark above the limit": site(
        height_limit=10, landmarks=[{"at": [60, 40], "size": [9, 9, 50]}]
    ),
    "no sun at all": site(latitude=89, sun_spacing=2),
    "an id of odd letters": site(id="a/b\n<c> 𝄞"),
    "at the end of the world": site(outline=box(9000, 9000, 9120, 9080)),
}
"""Odd sites on which everything finds its place."""


@pytest.mark.parametrize("name", FINE)
def test_odd_sites_are_built_on(name: str, tmp_path: Path) -> None:
    with within(LIMIT):
        found = answer(FINE[name])
        report = check(found)
        for suffix in ("svg", "glb", "cityjson", "json"):
            scenewright.write(found, tmp_path / f"out.{suffix}")
    assert found.left_out == ()
    assert report.valid, report.findings
    assert sum(p.category == "building" and not p.fixed for p in found.pieces) == 3
