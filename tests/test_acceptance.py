"""Findings that are accepted: told with their reason, not blamed, kept in the files."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from scenewright import cli, read, read_solution
from scenewright.core.acceptance import accept_findings
from scenewright.core.brief import Brief
from scenewright.core.brief.accepted import AcceptedFinding
from scenewright.core.errors import InputError
from scenewright.core.report import Finding, Report
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import check
from scenewright.domains.home import solving as homes
from scenewright.formats import solution_json

REASON = "the box stays until spring"
FOUND = Finding("collision", "0", "a", "a/sofa_1", "a/tv_1", "they overlap", 0.2)
GIVEN = replace(FOUND, piece="a/old_1", other="a/old_2", given=True)


def accepted(**more: str) -> AcceptedFinding:
    return AcceptedFinding(**{"kind": "collision", "reason": REASON} | more)


@pytest.mark.parametrize("more", [{"piece": "a/tv_1"}, {"piece": "a/sofa_1", "space": "a"}])
def test_an_accepted_finding_is_told_and_not_blamed(more: dict[str, str]) -> None:
    report = accept_findings(Report((FOUND, GIVEN)), [accepted(**more)])
    assert report.valid
    assert [found.accepted for found in report.findings] == [REASON, ""]
    assert report.to_dict()["findings"][0]["accepted"] == REASON
    assert str(report) == "valid (1 more in what was given) (1 accepted)"
    assert report.notes == ()


def test_the_reason_is_shown_with_what_was_given_too() -> None:
    report = accept_findings(Report((FOUND, GIVEN)), [accepted()])
    assert [found.accepted for found in report.findings] == [REASON, REASON]
    assert str(report) == "valid (2 accepted)"


def test_a_piece_may_be_named_as_adjust_takes_it() -> None:
    found = replace(FOUND, piece="a/wardrobe/wardrobe")
    assert accept_findings(Report((found,)), [accepted(piece="a/wardrobe")]).valid


@pytest.mark.parametrize(
    ("name", "is_meant"),
    [("parents/oma", True), ("wardrobe", True), ("parents/opa", False), ("guests/oma", False)],
)
def test_a_piece_with_an_id_of_its_own_is_named_by_its_room_too(name: str, is_meant: bool) -> None:
    chest = Piece("oma", "wardrobe", "", "parents", Pose(0, 0, 0, 0), Size(1, 1, 1), "", "")
    report = Report((replace(FOUND, space="parents", piece="oma"),))
    assert accept_findings(report, [accepted(piece=name)], [chest]).valid is is_meant


def test_of_two_pieces_that_a_name_may_mean_neither_is_accepted() -> None:
    box = Piece("a/x/box", "box", "", "a", Pose(0, 0, 0, 0), Size(1, 1, 1), "a/x", "")
    both = (box, replace(box, id="a/y/box", group="a/y"))
    report = Report((replace(FOUND, piece="a/x/box"),))
    assert not accept_findings(report, [accepted(piece="box")], both).valid
    assert accept_findings(report, [accepted(piece="box")], both[:1]).valid


@pytest.mark.parametrize(
    "more", [{"kind": "floating"}, {"piece": "a/bed_1"}, {"space": "b"}, {"piece": "a/tv"}]
)
def test_what_was_not_accepted_is_blamed_and_what_is_idle_noted(more: dict[str, str]) -> None:
    report = accept_findings(Report((FOUND,)), [accepted(**more)])
    assert not report.valid
    (note,) = report.notes
    assert "accepted, but not found" in note.message
    named = more.get("kind", FOUND.kind) == FOUND.kind
    assert ("there is one of a/sofa_1, a/tv_1" in note.message) == named


def test_it_is_kept_in_brief_and_solution(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    """Two beds in one place: refused, then accepted in the saved solution, then shown so."""
    brief = read("sample:home-child")
    assert "accepted" not in brief.model_dump()
    solved = homes.solve(brief, steps=200, seed=1)
    first = max(solved.pieces, key=lambda p: p.size.width * p.size.depth * p.size.height)
    twice = replace(solved, pieces=(*solved.pieces, replace(first, id=f"{first.space}/box_9")))
    assert not check(twice).valid
    path = tmp_path / "home.json"
    path.write_text(solution_json.dumps(twice))
    document = json.loads(path.read_text())
    kinds = sorted({found.kind for found in check(twice).findings if found.is_blamed})
    document["brief"]["accepted"] = [{"kind": kind, "reason": REASON} for kind in kinds]
    path.write_text(json.dumps(document))
    assert check(read_solution(path)).valid
    assert cli.run(["check", str(path)]) == 0
    told = capsys.readouterr().out
    assert REASON in " ".join(told.split())
    again = Brief.model_validate(json.loads(read_solution(path).brief.model_dump_json()))
    assert [row.reason for row in again.accepted] == [REASON] * len(kinds)


@pytest.mark.parametrize(
    "wrong", [{"kind": "ugliness"}, {"reason": ""}, {"reason": None}, {"colour": "red"}]
)
def test_nonsense_is_refused_in_one_line(wrong: dict[str, str], tmp_path: Path) -> None:
    document = json.loads(read("sample:home-child").model_dump_json())
    document["accepted"] = [{"kind": "collision", "reason": REASON} | wrong]
    path = tmp_path / "brief.json"
    path.write_text(json.dumps(document))
    with pytest.raises(InputError) as caught:
        read(path)
    assert "\n" not in str(caught.value)
    assert "accepted" in str(caught.value)
