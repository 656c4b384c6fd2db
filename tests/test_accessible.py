"""Homes for wheelchairs: the referee against plain geometry, and homes made for them."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np
import pytest
import shapely
from benchmarks.shapely_home import rectangle

from scenewright import cli
from scenewright.building.standing import item_of
from scenewright.core.brief import Brief
from scenewright.core.report import Report
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.domains import check
from scenewright.domains.home import solving as home
from scenewright.formats import read, svg
from scenewright.formats.solution_json import read as read_solution


def brief(width: float, depth: float, function: str, door: float = 0.95) -> Brief:
    outline = [(0, 0), (width, 0), (width, depth), (0, depth)]
    room = {
        "id": "r",
        "function": function,
        "outline": outline,
        "doors": [{"at": (0, 0.7), "width": door, "swing": "out"}],
    }
    return Brief.model_validate({"rooms": [room], "accessible": True})


def judged(asked: Brief, *pieces: Piece) -> Report:
    fixed = [item_of(piece) for piece in pieces if piece.fixed]
    asked = asked.model_copy(update={"rooms": [asked.rooms[0].model_copy(update={"fixed": fixed})]})
    empty = Solution(asked, (), (), (), (), {}, "default", "anneal", 0, "", "", 0.0, 0)
    return check(replace(empty, pieces=pieces))


def bed(x: float, y: float, *, fixed: bool = False) -> Piece:
    return Piece(
        "r/b", "double_bed", "", "r", Pose(x, y, 0, -pi / 2), Size(1.6, 2.0, 0.9), fixed=fixed
    )


def box(name: str, x: float, y: float, width: float, depth: float, *, fixed: bool = False) -> Piece:
    return Piece(
        name, "wardrobe", "", "r", Pose(x, y, 0, -pi / 2), Size(width, depth, 2.0), fixed=fixed
    )


def kinds(report: Report) -> set[str]:
    return {f.kind for f in report.findings if f.kind.startswith("no_")}


def test_routes_of_an_accessible_home_are_as_wide_as_a_wheelchair_needs() -> None:
    assert brief(4, 4, "living").route_width == 0.9
    assert Brief.model_validate(brief(4, 4, "living").model_dump()).route_width == 0.9
    wide = {"rooms": brief(4, 4, "living").model_dump()["rooms"], "accessible": True}
    assert Brief.model_validate(wide | {"route_width": 1.2}).route_width == 1.2


@pytest.mark.parametrize(("wall", "turns"), [(1.52, True), (1.48, False)])
def test_a_circle_of_a_metre_and_a_half_is_room_to_turn(wall: float, turns: bool) -> None:
    asked = brief(3.0, 3.0, "living")
    shut = box("r/w", 1.5, (3.0 + wall) / 2, 3.0, 3.0 - wall)
    report = judged(asked, shut)
    assert ("no_turning" in kinds(report)) is not turns
    if turns:
        x, y = report.figures["turning"]["r"]
        circle = shapely.Point(x, y).buffer(0.74)
        assert shapely.box(0, 0, 3, wall).covers(circle)


def test_what_came_fixed_or_a_narrow_room_is_told_and_not_blamed() -> None:
    shut = box("r/w", 1.5, 2.2, 3.0, 1.6, fixed=True)
    report = judged(brief(3.0, 3.0, "living"), shut)
    assert not kinds(report)
    assert any("no wheelchair can turn" in note.message for note in report.notes)
    narrow = judged(brief(1.2, 4.0, "hall"))
    assert any("does not fit in it (1.20 m wide)" in note.message for note in narrow.notes)
    assert not any("can turn" in n.message for n in judged(brief(1.2, 4.0, "storage")).notes)


@pytest.mark.parametrize(("gap", "free"), [(0.91, True), (0.85, False)])
def test_one_side_of_a_bed_is_free(gap: float, free: bool) -> None:
    report = judged(brief(5.0, 4.0, "bedroom"), bed(0.8, 3.0), box("r/w", 2.1 + gap, 3.0, 1.0, 2.0))
    assert ("no_transfer" in kinds(report)) is not free
    other = judged(brief(5.0, 4.0, "bedroom"), bed(3.6, 3.0), box("r/w", 4.9, 3.0, 0.2, 2.0))
    assert "no_transfer" not in kinds(other)


def test_a_nightstand_at_the_head_is_no_hindrance() -> None:
    head = box("r/n", 1.85, 3.8, 0.45, 0.4)
    assert "no_transfer" not in kinds(judged(brief(5.0, 4.0, "bedroom"), bed(0.8, 3.0), head))
    foot = box("r/n", 1.85, 2.3, 0.45, 0.4)
    assert "no_transfer" in kinds(judged(brief(5.0, 4.0, "bedroom"), bed(0.8, 3.0), foot))


def test_tight_doors_are_told() -> None:
    told = [n.message for n in judged(brief(4.0, 4.0, "living", door=0.7)).notes]
    assert any("0.70 m wide: a wheelchair needs 0.8 m" in message for message in told)
    assert not any("wheelchair needs" in n.message for n in judged(brief(4, 4, "living")).notes)


def test_an_ordinary_home_is_not_asked_for_room_to_turn() -> None:
    plain = brief(3.0, 3.0, "living").model_copy(update={"accessible": False})
    report = judged(plain, box("r/w", 1.5, 2.2, 3.0, 1.6))
    assert not kinds(report)
    assert "turning" not in report.figures


@pytest.mark.parametrize("seed", [0, 1])
def test_homes_made_for_wheelchairs(seed: int, tmp_path: Path) -> None:
    asked = read("sample:home-l-shape")
    asked = Brief.model_validate(asked.model_dump() | {"accessible": True, "route_width": 0.9})
    solution = home.solve(asked, seed=seed, steps=6000)
    report = check(solution)
    assert report.valid, [f.message for f in report.findings]
    assert {p.category for p in solution.pieces} & {"double_bed", "single_bed"}
    turning = report.figures["turning"]
    for room, (x, y) in turning.items():
        circle = shapely.Point(x, y).buffer(0.74)
        for p in solution.pieces:
            may = "chair" in p.category or p.category == "rug" or p.pose.z >= 2
            if p.space == room and not may:
                floor = rectangle(np.array([p.pose.x, p.pose.y, p.pose.heading, *p.size[:2]]))
                assert not floor.intersects(circle), p.id
    svg.write(solution, tmp_path / "plan.svg")
    drawn = (tmp_path / "plan.svg").read_text()
    assert drawn.count('stroke-dasharray="1.6 0.9"') == len(turning) > 1


def test_accessible_on_the_command_line(tmp_path: Path) -> None:
    out = tmp_path / "home.json"
    command = ["arrange", "sample:home-l-shape", "-o", str(out), "-q", "--accessible"]
    assert cli.run([*command, "--steps", "3000"]) in (0, 1)
    saved = read_solution(out).brief
    assert (saved.accessible, saved.route_width) == (True, 0.9)
    assert cli.run(["arrange", "sample:hall-shop", "--accessible", "-q"]) == 2
    assert cli.run([*command, "--batch"]) == 2


@pytest.mark.parametrize("seed", [1, 3])
def test_showers_stand_for_baths_and_beds_are_of_full_width(seed: int) -> None:
    """Also in a bathroom so large that it would have both, unless the bath is wished for."""

    def held(function: str, width: float, *names: str) -> list[Piece]:
        document = brief(width, 2.2 if function == "bathroom" else 3.1, function).model_dump()
        document["rooms"][0]["wishes"] = [{"what": name} for name in names]
        return list(home.solve(Brief.model_validate(document), seed=seed).pieces)

    washed = [p for p in held("bathroom", 3.5) if p.category in ("bathtub", "shower")]
    assert [p.category for p in washed] == ["shower"]
    assert min(washed[0].size[:2]) >= 0.9
    assert "bathtub" in [p.category for p in held("bathroom", 3.5, "bath")]
    assert [p.size.width >= 0.9 for p in held("child_bedroom", 3.5) if "bed" in p.category] == [
        True
    ]


def test_under_slopes_the_essential_stands_before_the_rest() -> None:
    """A wardrobe has one place at the gables of this loft, which a bookcase would take."""
    slopes = [{"edge": edge, "knee": 0.9, "pitch": 0.75} for edge in (0, 2)]
    loft = {
        "id": "loft",
        "function": ["double_bedroom", "study"],
        "height": 3.2,
        "outline": [[0, 0], [7, 0], [7, 5], [0, 5]],
        "slopes": slopes,
        "doors": [{"at": [7, 2.5], "width": 0.85}],
        "windows": [
            {"at": [3, 0], "width": 1.1, "sill": 1.0, "height": 1.3},
            {"at": [0, 2.5], "width": 1.2},
        ],
    }
    solution = home.solve(Brief.model_validate({"rooms": [loft], "accessible": True}))
    assert {"wardrobe", "double_bed", "desk"} <= {p.category for p in solution.pieces}
    assert not any(out.required for out in solution.left_out)
    assert check(solution).valid
