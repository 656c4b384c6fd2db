"""The ledger of a household: what a home owes by residents and floor, what it has, why not."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import scenewright as sw
from flat import flat_brief, flat_solution
from scenewright import cli
from scenewright.core.explanation import LedgerRow
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import LeftOut
from scenewright.core.space import Space
from scenewright.domains import plan_of
from scenewright.domains.home.needs.counting import count_eaters, count_sleepers
from scenewright.domains.home.needs.household import is_dwelling
from scenewright.domains.home.needs.ledger import make_ledger
from scenewright.domains.home.needs.table import NEEDS, Residence

WET = {
    "id": "bath",
    "name": "Bath",
    "function": "bathroom",
    "level": "ground",
    "outline": [[0, 4.12], [2.2, 4.12], [2.2, 6.4], [0, 6.4]],
    "doors": [{"at": [1, 4.12], "to": "living"}],
}


def piece(kind: str, space: str, x: float, y: float, *size: float) -> Piece:
    return Piece(f"{space}/{kind}-{x}-{y}", kind, "", space, Pose(x, y, 0, 0), Size(*size))


def dwelling(
    pieces: Sequence[Piece], left_out: Sequence[LeftOut] = (), **keys: object
) -> sw.Solution:
    """The small flat with a bath, so that it is a dwelling, and its furniture."""
    document = json.loads(flat_brief().model_dump_json())
    document["rooms"].append(WET)
    brief = type(flat_brief()).model_validate(document | keys)
    return replace(flat_solution(), brief=brief, pieces=tuple(pieces), left_out=tuple(left_out))


def rows_of(solution: sw.Solution) -> dict[str, LedgerRow]:
    return {row.need: row for row in make_ledger(solution, plan_of(solution.brief))}


def test_what_stands_is_counted_by_need_and_told_where() -> None:
    table = piece("dining_table", "living", 2, 2, 0.8, 0.8, 0.75)
    chairs = [piece("dining_chair", "living", 2, y, 0.45, 0.5, 0.9) for y in (1.3, 2.7)]
    far = piece("dining_chair", "living", 4.5, 2, 0.45, 0.5, 0.9)
    bed = piece("double_bed", "bedroom", 6.5, 2, 1.6, 2.0, 0.5)
    rows = rows_of(dwelling([table, *chairs, far, bed]))
    assert (rows["beds"].owed, rows["beds"].stands, rows["beds"].where) == (2.0, 2.0, "Bedroom")
    assert (rows["places to eat"].stands, rows["places to eat"].why) == (2.0, "")
    assert rows["soft seats"].stands == 0.0
    assert rows["soft seats"].why
    assert "worktop" not in rows  # nobody cooks in a home without a kitchen


def test_a_table_feeds_no_more_than_its_edge_has_room_for() -> None:
    table = piece("round_table", "a", 0, 0, 0.6, 0.6, 0.75)
    chairs = [
        piece("dining_chair", "a", *at, 0.4, 0.4, 0.9)
        for at in ((0.5, 0), (-0.5, 0), (0, 0.5), (0, -0.5))
    ]
    assert count_eaters([table, *chairs]) == 3.0  # pi * 0.6 m of edge, 0.6 m each
    assert count_eaters(chairs) == 0.0


@pytest.mark.parametrize(("stated", "people"), [(None, 2.0), (1, 1.0), (5, 5.0)])
def test_residents_are_stated_or_those_the_bedrooms_are_for(
    stated: int | None, people: float
) -> None:
    keys = {} if stated is None else {"residents": stated}
    rows = rows_of(dwelling([], **keys))
    assert rows["beds"].owed == rows["places to eat"].owed == people
    assert rows["clothes"].owed == pytest.approx(0.75 * people)


def test_the_reason_is_the_one_reported_of_the_needs_groups() -> None:
    out = LeftOut("living", "dining_wall", "no free wall of 1.2 m to stand against", False)
    plant = LeftOut("living", "plant", "no room is left beside the rest", False)
    why = rows_of(dwelling([], [plant, out]))["places to eat"].why
    assert why == "Living room: no free wall of 1.2 m to stand against"


def test_rooms_without_water_are_no_dwelling_and_owe_nothing() -> None:
    assert make_ledger(flat_solution(), plan_of(flat_brief())) == ()
    square = np.array([[0, 0], [3, 0], [3, 3], [0, 3]], float)
    kitchen = Space("k", "k", ("kitchen",), "0", square)
    bed = Space("b", "b", ("child_bedroom",), "0", square)
    assert not is_dwelling([kitchen])
    assert is_dwelling([kitchen, bed])


def test_more_people_and_more_floor_owe_no_less() -> None:
    uses = frozenset(("living", "kitchen", "bathroom", "bedroom"))
    for need in NEEDS:
        few = [need.owed(Residence(n, 50.0, uses)) for n in range(1, 8)]
        wide = [need.owed(Residence(3, area, uses)) for area in (15.0, 25.0, 60.0, 120.0)]
        assert few == sorted(few), need.name
        assert wide == sorted(wide), need.name
        assert need.source, need.name


def test_beds_of_asked_rooms_say_who_sleeps_there() -> None:
    solution = dwelling([piece("single_bed", "bedroom", 6.5, 2, 0.9, 2.0, 0.5)])
    asked = solution.brief.model_copy(
        update={"rooms": [room.model_copy(update={"ask": []}) for room in solution.brief.rooms]}
    )
    assert rows_of(replace(solution, brief=asked))["beds"].owed == 1.0
    assert rows_of(solution)["beds"].owed == 2.0
    assert count_sleepers(solution.pieces) == 1.0


def test_explain_prints_the_ledger_and_json_holds_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    solution = dwelling([piece("double_bed", "bedroom", 6.5, 2, 1.6, 2.0, 0.5)])
    path = str(tmp_path / "flat.json")
    sw.write(solution, path)
    assert cli.run(["explain", path]) == 0
    lines = capsys.readouterr().out.splitlines()
    (head,) = [line for line in lines if "owed" in line and "stands" in line]
    assert head.split() == ["need", "owed", "stands", "where", "why", "not"]
    assert any(line.split()[:4] == ["beds", "2", "2", "Bedroom"] for line in lines)
    assert cli.run(["explain", path, "--json"]) == 0
    ledger = json.loads(capsys.readouterr().out)["ledger"]
    assert ledger[0] | {"need": "beds", "owed": 2.0, "stands": 2.0} == ledger[0]
    assert "soft seats: 0 of" in str(sw.explain(solution))
    assert "<th>why not</th>" in sw.explain(solution)._repr_html_()
