"""Halls that are too small or odd: what does not fit is left out, with by how much it does not.
None of them may hang, crash or break a rule."""

from __future__ import annotations

import json
import os
import re
from pathlib import Path

import pytest

from deadline import within
from hall_briefs import LIMIT, SMALL, TWO, Room, answer, asks, box, document, hall, standing
from scenewright import cli
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains import check
from scenewright.domains.hall.demands.checked import ids_of


@pytest.fixture(scope="module", autouse=True)
def _compiled() -> None:
    """Compiling takes its time; what is measured here is the search."""
    crowd = hall(demands=[{"category": "showcase", "count": 99}, {"category": "lockers"}])
    answer(crowd)


MORE = r"m² more needed( in one piece)?"
ROOM = r"no room left in the hall: \d+\.\d m², what is placed needs \d+\.\d m² .*; {} " + MORE
SHORT: dict[str, tuple[Room, str, str]] = {
    "5000 objects in 20 m²": (
        hall(**SMALL, demands=[{"category": "showcase", "count": 5000}]),
        r"49\d\d of 5000 showcase",
        ROOM.format(r"2[12]\d\d\d\.\d"),
    ),
    "2000 benches in 20 m²": (
        hall(**SMALL, demands=[{"category": "bench", "count": 2000, "patterns": ["grid"]}]),
        r"19\d\d of 2000 bench",
        ROOM.format(r"4\d\d\d\.\d"),
    ),
    "a fan in 2 by 2 metres": (
        hall(
            zones=[{"id": "a", "outline": box(0, 0, 2, 2)}],
            demands=[
                {
                    "id": "seats",
                    "category": "auditorium_seat",
                    "count": 40,
                    "zone": "a",
                    "patterns": ["fan"],
                }
            ],
        ),
        r"3\d of 40 seats",
        r"no room left in a: 4\.0 m², .* more needed( in one piece)?",
    ),
    "larger than the hall": (
        asks(size=[20, 9, 1]),
        "showcase",
        r"no place in the hall is large enough for one of 20 by 9 m: 8\.00 m are missing",
    ),
    "one of three too large": (
        asks(sizes=[[1, 1, 1], [9.5, 9, 1], [1, 1, 1]]),
        "1 of 3 showcase",
        r"for one of 9\.5 by 9 m: 1\.00 m are missing",
    ),
    "larger than its zone": (
        hall(zones=TWO, demands=[{"category": "stage", "size": [7, 7, 1], "zone": "a"}]),
        "stage",
        r"no place in a is large enough for one of 7 by 7 m: 1\.00 m are missing",
    ),
    "wider than any wall": (
        asks(count=2, size=[12.5, 0.5, 2], place="wall"),
        "2 of 2 showcase",
        r"no wall in the hall is large enough for one of 12\.5 by 0\.5 m: 0\.50 m are missing",
    ),
    "as wide as the wall": (
        asks(size=[11.99, 0.5, 2], place="wall"),
        "showcase",
        r"no wall left in the hall: 12\.0 m more wall needed",
    ),
    "72 m of cases at 38 m of wall": (
        asks(id="cases", count=60, size=[1.2, 0.5, 2], place="wall"),
        r"\d\d of 60 cases",
        r"no wall left in the hall: \d\d\.\d m more wall needed",
    ),
    "no partition can be built": (
        hall(
            outline=box(0, 0, 4, 4),
            doors=[{"at": [2, 0]}],
            demands=[{"category": "wall_exhibit", "count": 60}],
        ),
        r"5\d of 60 wall exhibit",
        r"no wall left in the hall: 6\d\.\d m more wall needed",
    ),
    "a zone filled by a hole": (
        hall(
            zones=TWO,
            holes=[box(0.5, 0.5, 5.9, 7.9)],
            demands=[{"category": "showcase", "count": 6, "zone": "a"}],
        ),
        "6 of 6 showcase",
        rf"no room left in a: 8\.\d m², .* 26\.5 {MORE}",
    ),
    "a zone 0.3 m deep": (
        hall(
            zones=[
                {"id": "a", "outline": box(0, 0, 12, 0.3)},
                {"id": "b", "outline": box(0, 0.3, 12, 8)},
            ],
            demands=[{"category": "showcase", "count": 4, "zone": "a"}],
        ),
        "4 of 4 showcase",
        r"no place in a is .* 1\.2 by 0\.6 m: 0\.30 m are missing",
    ),
    "two zones of a metre": (
        hall(
            zones=[
                {"id": "a", "outline": box(0, 0, 1, 1)},
                {"id": "b", "outline": box(2, 2, 3, 3)},
            ],
            demands=[{"category": "showcase", "count": 8, "zone": ["a", "b"]}],
        ),
        "8 of 8 showcase",
        r"no place in a, b is large enough .* 0\.20 m are missing",
    ),
    "a hall of one square metre": (
        hall(
            outline=box(0, 0, 1.1, 1.1),
            doors=[{"at": [0.5, 0], "width": 0.7}],
            demands=[{"category": "showcase", "count": 2}],
        ),
        "2 of 2 showcase",
        r"one of 1\.2 by 0\.6 m: 0\.10 m are missing",
    ),
    "a hall full of columns": (
        hall(
            holes=[box(x + 0.1, y + 0.1, x + 0.9, y + 0.9) for x in range(12) for y in range(1, 8)],
            demands=[{"category": "stage"}],
        ),
        "stage",
        r"no (room|place) .*",
    ),
    "a thousand demands": (
        hall(demands=[{"id": f"bench {k}", "category": "bench"} for k in range(1000)]),
        r"bench \d+",
        rf"(no room left .* 2\.2 {MORE}"
        r"|no layout was found where a route 0\.90 m wide reaches all with it)",
    ),
    "more than the floor bears, not required": (
        asks(count=400, required=False),
        r"3\d\d of 400 showcase",
        ROOM.format(r"1\d\d\d\.\d"),
    ),
    "behind fixed objects": (
        hall(
            fixed=standing(1, size=[11.9, 6.0, 1], at=[6, 4.9], heading=1.5707963),
            demands=[{"category": "stage"}],
        ),
        "stage",
        r"no room left in the hall: 24\.\d m², .*",
    ),
}
"""What is asked for, the room, what is left out and why."""


@pytest.mark.parametrize("name", SHORT)
def test_what_does_not_fit_is_told_by_how_much(name: str) -> None:
    room, what, reason = SHORT[name]
    with within(LIMIT):
        found = answer(room)
        report = check(found)
    broken = {finding.kind for finding in report.findings}
    assert not broken & {"collision", "out_of_bounds", "malformed", "outside_zone"}
    assert found.left_out
    for entry in found.left_out:
        assert re.fullmatch(what, entry.what), entry.what
        assert re.fullmatch(".*" + reason, entry.reason), entry.reason
    counts_add_up(room, found)


def counts_add_up(room: Room, found: Solution) -> None:
    """What is placed, what stood there and what is left out are what was asked for."""
    demands = Brief.model_validate({"domain": "hall", "rooms": [room]}).rooms[0].demands
    for name, demand in zip(ids_of(demands), demands, strict=True):
        asked = len(demand.sizes) or demand.count or 1
        placed = sum(piece.function == name for piece in found.pieces)
        told = [
            entry.what
            for entry in found.left_out
            if entry.what.endswith(demand.id or demand.category.replace("_", " "))
        ]
        missing = int(told[0].split(" of ")[0]) if told and " of " in told[0] else len(told)
        assert placed + missing == asked, name


FINE: dict[str, Room] = {
    "no doors": asks(count=4) | {"doors": []},
    "no demands": hall(zones=TWO),
    "clearance larger than the zone": hall(
        zones=TWO, demands=[{"category": "showcase", "count": 2, "zone": "a", "clearance": 9}]
    ),
    "a fan of one": asks(category="auditorium_seat", count=1, patterns=["fan"]),
    "a fan of two": asks(category="auditorium_seat", count=2, patterns=["fan"]),
    "a ring of two": asks(count=2, patterns=["circulation"]),
    "a ring of one": asks(count=1, patterns=["radiation"]),
    "a mixture of three": asks(count=3, patterns=["mixture"]),
    "five by themselves": asks(count=5, patterns=["single"]),
    "a pattern twice": asks(count=5, patterns=["chain", "chain"]),
    "an id of odd letters": asks(count=2, id="a/b\n<c> 𝄞"),
    "pieces of no demand": hall(
        fixed=standing(2, function="zzz", group="hall/zzz"), demands=[{"category": "bench"}]
    ),
    "as many as asked stand there": hall(
        fixed=standing(4), demands=[{"category": "showcase", "count": 4}]
    ),
    "more than asked stand there": hall(
        fixed=standing(4), demands=[{"category": "showcase", "count": 2}]
    ),
    "some stand there": hall(fixed=standing(3), demands=[{"category": "showcase", "count": 5}]),
    "at the end of the world": hall(
        outline=box(9980, 9990, 9992, 9998),
        doors=[{"at": [9986, 9990], "width": 1.6}],
        demands=[{"category": "showcase", "count": 6}],
    ),
    "a ceiling lower than things are": asks(count=2) | {"height": 1.6},
}
"""Odd halls in which everything finds its place."""


@pytest.mark.parametrize("name", FINE)
def test_odd_halls_are_laid_out(name: str) -> None:
    room = FINE[name]
    with within(LIMIT):
        found = answer(room)
        report = check(found)
    assert found.left_out == ()
    assert report.valid, report.findings
    ids = [piece.id for piece in found.pieces]
    assert len(set(ids)) == len(ids)
    stood = {item["id"] for item in room.get("fixed", [])}
    assert stood <= {piece.id for piece in found.pieces if piece.fixed}
    if name != "more than asked stand there":
        counts_add_up(room, found)


def test_objects_by_themselves_are_groups_of_their_own() -> None:
    found = answer(FINE["five by themselves"])
    assert found.detail is not None
    assert [(group.pattern, len(group.objects)) for group in found.detail.layout.groups] == [
        ("single", 1)
    ] * 5


def test_what_is_left_out_is_exit_code_1(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """If it was required; else the hall is as asked for."""
    monkeypatch.chdir(tmp_path)
    for required in (True, False):
        room = asks(size=[20, 9, 1], required=required)
        Path("hall.json").write_text(json.dumps(document("", room)))
        arguments = ["arrange", "hall.json", "-o", "out.json", "--steps", "100"]
        assert cli.run(arguments) == (1 if required else 0)
        out = " ".join(capsys.readouterr().out.split())
        assert "no place in the hall is large enough for one of 20 by 9 m" in out
        assert sorted(os.listdir()) == ["hall.json", "out.json"]


def test_what_would_narrow_a_passage_is_left_out_for_that_reason() -> None:
    tables = [{"id": z, "category": "display_table", "count": 10, "zone": z} for z in ("a", "b")]
    room = hall(zones=TWO, demands=tables, links=[{"between": ["a", "b"], "width": 6.0}])
    reasons = {entry.reason for entry in answer(room).left_out}
    assert reasons == {"no layout was found where passages are as wide as asked for with it"}
