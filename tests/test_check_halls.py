"""The referee on whole halls: turned, renamed, odd and large ones."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.judged_halls import (
    EAST,
    SOUTH,
    answer,
    box,
    group,
    hall_brief,
    judge,
    piece,
    tour,
    turned,
    zone,
)

from deadline import within
from hall_floors import WEST_ZONE, figures, gap, grid, odd, rings, two_zones
from scenewright.domains.hall.hall_layout import (
    HallDetail,
    HallLayout,
    Layer,
    PatternPart,
    PlacedGroup,
    Tour,
    Zone,
    ZoneLink,
)
from thoroughness import only_thorough

FULL = two_zones(
    *gap(1.1),
    *grid(2, 2.0, (1.5, 2.0)),
    piece("case", 11.4, 4.9, 0.8, 0.8, heading=EAST),
    piece("shelf", 8, 5.7, 2, 0.4, 1.8, heading=SOUTH),
    groups=(
        group("h/cases", "west", *grid(2, 2.0, (1.5, 2.0))),
        group("h/shelf", "east", piece("shelf", 8, 5.7, 2, 0.4)),
        group("h/odd", "west", piece("case", 11.4, 4.9, 1, 1)),
    ),
    tours=(tour((3, 0), (2.5, 3), (6, 2.5), (9, 3), (12, 3)),),
)


def flat(value):
    """All numbers of nested figures, in order."""
    if isinstance(value, dict):
        return [
            n for key, part in value.items() if key not in ("at", "message") for n in flat(part)
        ]
    if isinstance(value, list):
        return [n for part in value for n in flat(part)]
    return [float(value)] if isinstance(value, (int, float)) else []


@pytest.mark.parametrize("angle", [0.4, math.pi / 2, 2.5])
def test_turning_a_hall_changes_nothing(angle):
    before, after = judge(FULL), judge(turned(FULL, angle, (30.0, -12.0)))
    assert [(f.kind, f.piece) for f in before.findings] == [
        (f.kind, f.piece) for f in after.findings
    ]
    assert {f.kind for f in before.findings} >= {"narrow_passage", "outside_zone"}
    out = [figures(report)["escape"].pop("distance") for report in (before, after)]
    assert out[0] == pytest.approx(out[1], rel=0.03, abs=0.4)  # a raster of 0.25 m
    assert flat(figures(before)) == pytest.approx(flat(figures(after)), rel=1e-3, abs=0.015)


def test_renaming_changes_only_names():
    def new(name):
        return f"x{name}" if name else name

    graph = FULL.detail.layout
    renamed = replace(
        FULL,
        pieces=tuple(replace(p, id=new(p.id)) for p in FULL.pieces),
        detail=FULL.detail._replace(
            layout=graph._replace(
                zones=tuple(z._replace(id=new(z.id)) for z in graph.zones),
                links=tuple(
                    k._replace(first=new(k.first), second=new(k.second)) for k in graph.links
                ),
                groups=tuple(
                    g._replace(id=new(g.id), zone=new(g.zone), objects=tuple(map(new, g.objects)))
                    for g in graph.groups
                ),
            )
        ),
    )
    before, after = judge(FULL), judge(renamed)
    assert flat(figures(before)) == flat(figures(after))
    assert [(f.kind, f.amount) for f in before.findings] == [
        (f.kind, f.amount) for f in after.findings
    ]


def test_what_the_graph_names_has_to_be_there():
    case = piece("case", 2, 3, 1, 1)
    graph = HallLayout(
        zones=(
            WEST_ZONE,
            WEST_ZONE,
            zone("line", [[0, 0], [1, 1], [2, 2]]),
            zone("z", box(0, 0, 1, 1), "?"),
        ),
        links=(ZoneLink("h", "west", "nowhere", 1.2), ZoneLink("h", "west", "west", 1.2)),
        groups=(
            group("a", "nowhere", case),
            group("b", "west", case, replace(case, id="gone")),
            group("c", "west", case, space="?"),
        ),
    )
    report = judge(replace(two_zones(case), detail=HallDetail(graph, two_zones(case).detail.tours)))
    told = [found.message for found in report.of("malformed")]
    assert len(told) == len(report.findings) == 8
    for word in (
        "there twice",
        "no floor",
        "zone nowhere is not there",
        "cannot be judged",
        "in zone nowhere",
        "names gone",
        "not a room",
    ):
        assert [m for m in told if word in m], word


names = st.sampled_from(["a", "b", "?", ""])


zones_ = st.lists(st.tuples(names, rings, rings), max_size=4)


links_ = st.lists(st.tuples(names, names, odd), max_size=3)


groups_ = st.lists(st.tuples(names, st.lists(names, max_size=3)), max_size=3)


@given(zones_, links_, groups_, rings)
def test_nothing_a_graph_or_tour_holds_raises(zones, links, groups, points):
    """However odd the scene graph and the tour are, there is a report that JSON can hold."""
    pieces = (piece("case", 3, 3, 1, 1, id="a"), piece("partition", 6, 3, 1, 0.2, id="b"))
    part = (PatternPart("grid", (Layer(1, math.nan, 1.0),)),)
    graph = HallLayout(
        tuple(Zone(n, n, "h", np.array(o), (np.array(i),)) for n, o, i in zones),
        tuple(ZoneLink("h", *link) for link in links),
        tuple(PlacedGroup(z, z, "h", z, "?", (0, 0, 0), part, tuple(o)) for z, o in groups),
        ("?",),
    )
    tours = (
        Tour("h", np.array(points), np.ones(1), ()),
        Tour("?", np.zeros((2, 2)), np.ones(2), ()),
    )
    report = judge(replace(two_zones(*pieces), detail=HallDetail(graph, tours)))
    json.dumps(report.to_dict(), allow_nan=False)
    assert str(report)


def test_a_home_has_no_halls():
    assert "halls" not in judge(replace(FULL, detail=None)).figures


@only_thorough
def test_two_thousand_pieces_are_judged_quickly():
    """About 2.5 s of one core; the limit leaves room for a slower machine."""
    cases = [
        piece("case", 2 + 2 * i, 2 + 1.8 * j, 1, 0.6, 1.8) for i in range(50) for j in range(40)
    ]
    brief = hall_brief(box(0, 0, 104, 76), ({"at": [52, 0], "width": 2, "swing": "none"},))
    zones = [zone(f"z{k}", box(26 * k, 0, 26 * k + 26, 76)) for k in range(4)]
    groups = [group(f"g{k}", f"z{k}", *cases[k * 480 : k * 480 + 400]) for k in range(4)]
    lanes = [(x, 2.9 + 1.8 * j) for j in range(0, 40, 2) for x in ((1, 103) if j % 4 else (103, 1))]
    links = [(f"z{k}", f"z{k + 1}", 1.2) for k in range(3)]
    solution = answer(brief, cases, zones, links, groups, (tour((52, 0), *lanes),))
    with within(60):
        report = judge(solution)
    assert figures(report)["objects"] == 1600
