"""Halls that cannot be: every bad brief is one line with its remedy, or a hall that tells what it
leaves out and by how much it does not fit. Nothing of it may hang, crash or break a rule."""

from __future__ import annotations

import json
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
from scenewright.domains.hall.demands import ids_of

LIMIT = 20
"""Seconds within which every brief is answered, once the code is compiled."""

Room = dict[str, Any]


def box(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def hall(**room: Any) -> Room:
    """A hall of 12 by 8 metres and 3 metres high with an entrance in the south."""
    doors = [{"id": "main", "at": [6, 0], "width": 1.6, "use": "entrance"}]
    return {"name": "Hall", "outline": box(0, 0, 12, 8), "height": 3.0, "doors": doors} | room


def asks(**demand: Any) -> Room:
    return hall(demands=[{"category": "showcase"} | demand])


def standing(count: int, **more: Any) -> list[dict[str, Any]]:
    """Showcases in a row that stand there already."""
    return [
        {
            "category": "showcase",
            "at": [1.5 + 2.4 * k, 4],
            "size": [1.2, 0.6, 2.0],
            "id": f"hall/showcase/showcase_{k + 1}",
            "group": "hall/showcase",
            "function": "showcase",
        }
        | more
        for k in range(count)
    ]


TWO = [{"id": "a", "outline": box(0, 0, 6, 8)}, {"id": "b", "outline": box(6, 0, 12, 8)}]
SMALL = {"outline": box(0, 0, 5, 4), "doors": [{"at": [2, 0]}]}
NAMES = [[f"z{row}-{k}" for k in range(200)] for row in range(60)]

FAULTS: dict[str, tuple[Room, str]] = {
    "zones that overlap": (
        hall(zones=[TWO[0], {"id": "b", "outline": box(5, 0, 12, 8)}]),
        "overlaps zone 'a' by 8.0",
    ),
    "a zone off the outline": (
        hall(zones=[{"id": "a", "outline": box(0, 0, 13, 8)}]),
        "reaches 1.00 m out of the hall",
    ),
    "a zone elsewhere": (
        hall(zones=[{"id": "a", "outline": box(90, 90, 99, 99)}]),
        "out of the hall at (99.00",
    ),
    "a zone that is a hole": (
        hall(zones=[{"id": "a", "outline": box(2, 2, 4, 4)}], holes=[box(2, 2, 4, 4)]),
        "zones[0] 'a': holds only 0.00 m² of floor",
    ),
    "a zone across a column wall": (
        hall(zones=[{"id": "a", "outline": box(0, 2, 12, 4)}], holes=[box(5, 1, 6, 5)]),
        "is cut into 2 pieces",
    ),
    "a link between zones apart": (
        hall(
            zones=[{"id": "a", "outline": box(0, 0, 3, 8)}, TWO[1]], links=[{"between": ["a", "b"]}]
        ),
        "share no border",
    ),
    "a passage wider than the border": (
        hall(zones=TWO, links=[{"between": ["a", "b"], "width": 9}]),
        "only 8.00 m long",
    ),
    "a negative passage": (
        hall(zones=TWO, links=[{"between": ["a", "b"], "width": -1}]),
        "links[0].width",
    ),
    "a link with itself": (hall(zones=TWO, links=[{"between": ["a", "a"]}]), "with itself"),
    "a link of an unknown zone": (
        hall(zones=TWO, links=[{"between": ["a", "c"]}]),
        "'c' is no zone",
    ),
    "a zone beside itself": (hall(zones=[{"id": "a", "beside": ["a"]}]), "beside itself"),
    "a zone beside no zone": (hall(zones=[{"id": "a", "beside": ["x"]}]), "'x' is no zone"),
    "a zone at no door": (hall(zones=[{"id": "a", "door": "x"}]), "'x' is no door of the hall"),
    "zones larger than the floor": (
        hall(zones=[{"id": "a", "area": 90}, {"id": "b", "area": 60}]),
        "the zones ask for 150.0 m², but only 96.0 m² of floor are free",
    ),
    "a zone of no area": (hall(zones=[{"id": "a", "area": 0}]), "zones[0].area"),
    "a zone twice": (hall(zones=[TWO[0], TWO[0] | {"outline": None}]), "the id is used twice"),
    "a thousand zones": (
        hall(zones=[{"id": f"z{k}"} for k in range(1000)]),
        "takes at most 200 entries, has 1000",
    ),
    "more zones than floor": (
        hall(zones=[{"id": f"z{k}"} for k in range(200)]),
        "only 96.0 m² of floor are left for",
    ),
    "12 000 zones by demands": (
        hall(demands=[{"category": "bench", "zone": names} for names in NAMES]),
        "demands: the demands name 12000 zones; a hall has at most 200",
    ),
    "a demand for no zone": (
        hall(zones=TWO, demands=[{"category": "bench", "zone": "c"}]),
        "'c' is no zone",
    ),
    "an unknown category": (asks(category="shwcase"), "use one of: showcase"),
    "an unknown pattern": (asks(patterns=["spiral"]), "demands[0].patterns[0]"),
    "an unknown place": (asks(place="roof"), "demands[0].place"),
    "an unknown key": (asks(colour="red"), "demands[0].colour: is not a known key"),
    "facing itself": (asks(id="x", facing="x"), "demands[0] 'x': is to face itself"),
    "facing itself by its category": (asks(facing="showcase"), "is to face itself"),
    "facing a zone": (
        hall(zones=TWO, demands=[{"category": "bench", "facing": "a"}, {"category": "stage"}]),
        "demands[0] 'bench': 'a' in facing is no demand of the hall; use one of: stage",
    ),
    "facing nothing": (asks(facing="stag"), "'stag' in facing is no demand of the hall; leave it"),
    "at a wall in rows": (
        asks(place="wall", patterns=["chain", "fan"]),
        "is to stand at a wall, but in the pattern chain or fan; leave out place or patterns",
    ),
    "free at walls": (asks(place="free", patterns=["wall"]), "is to stand free, but in the"),
    "count and length": (asks(count=3, length=9), "has both count and length"),
    "count and sizes": (asks(count=3, sizes=[[1, 1, 1]]), "count is 3, but 1 sizes are listed"),
    "size and sizes": (asks(size=[1, 1, 1], sizes=[[1, 1, 1]]), "has both size and sizes"),
    "less length than one": (asks(length=1, size=[1.2, 0.6, 2]), "more than the length of 1 m"),
    "a count of 0": (asks(count=0), "demands[0].count: 0 is not possible"),
    "a negative count": (asks(count=-3), "demands[0].count: -3 is not possible"),
    "half an object": (asks(count=2.5), "give a whole number"),
    "a count of millions": (asks(count=10**12), "demands[0].count"),
    "a text for a count": (asks(count="6"), "give a whole number"),
    "a width of 0": (asks(size=[0, 1, 1]), "demands[0].size[0]: 0 is not possible"),
    "a negative depth": (asks(size=[1, -1, 1]), "demands[0].size[1]: -1 is not possible"),
    "a size that is no number": (asks(size=[1, float("nan"), 1]), "NaN is not a number"),
    "an endless size": (asks(size=[1, float("inf"), 1]), "Infinity is not a number"),
    "a size in millimetres": (asks(size=[1200, 600, 2000]), "demands[0].size[0]: 1200"),
    "a size of a millimetre": (
        asks(count=2000, size=[0.001, 0.001, 0.001]),
        "one is only 0.001 by 0.001 m; lengths are",
    ),
    "a negative length": (asks(length=-4), "demands[0].length: -4 is not possible"),
    "a negative clearance": (asks(clearance=-1), "demands[0].clearance"),
    "three clearances": (asks(clearance=[1, 1, 1]), "demands[0].clearance"),
    "a clearance longer than the hall": (asks(clearance=15), "asks for 15 m free, but the hall is"),
    "taller than the ceiling": (
        asks(sizes=[[1, 1, 2], [1, 1, 5]]),
        "one is 5 m tall, 2.00 m more than the hall; give",
    ),
    "more objects than can be": (
        hall(demands=[{"category": "bench", "count": 15_000}] * 2),
        "of this hall to 30000",
    ),
    "two demands of one id": (
        hall(demands=[{"id": "x", "category": "bench"}] * 2),
        "demands[1] 'x': the id is used",
    ),
    "nobody": (hall(people=0), "rooms[0].people: 0 is not possible"),
    "a hall for a home": (hall(ask=[{"group": "sleeping"}]), "asks for groups of furniture"),
    "a hole over the entrance": (hall(holes=[box(5, -1, 7, 2)]), "doors[0]: is off the wall"),
    "a hole before the entrance": (
        hall(holes=[box(5, 0.1, 6.6, 2)]),
        "door 'main': a hole leaves 0.20 m of it free",
    ),
    "an exit inside": (hall(doors=[{"at": [6, 4], "use": "exit"}]), "is off the wall: (6, 4)"),
    "an exit elsewhere": (hall(doors=[{"at": [60, 4], "use": "exit"}]), "is off the wall: (60, 4)"),
    "an exit wider than its wall": (hall(doors=[{"at": [6, 0], "width": 19}]), "only 12.00 m"),
    "an exit over a corner": (hall(doors=[{"at": [0, 0], "width": 1.6}]), "over the end of its"),
    "an exit that is no exit": (hall(doors=[{"at": [6, 0], "use": "escape"}]), "doors[0].use"),
    "an outline that crosses itself": (hall(outline=[[0, 0], [5, 5], [5, 0], [0, 5]]), "crosses"),
    "coordinates far away": (hall(outline=box(0, 0, 1e9, 8)), "rooms[0].outline[1][0]"),
    "a hall of kilometres": (hall(outline=box(0, 0, 9000, 9000), doors=[]), "at most 300 m long"),
    "two halls of one place": (
        hall(name="B", outline=box(1, 1, 5, 5), doors=[]),
        "overlaps rooms[0] 'Hall'",
    ),
}
"""What is wrong, the room, and what is told."""

ROOMS_BESIDE = {"two halls of one place": [hall()]}


def document(name: str, room: Room) -> dict[str, Any]:
    return {"domain": "hall", "rooms": [*ROOMS_BESIDE.get(name, []), room]}


@pytest.mark.parametrize("name", FAULTS)
def test_a_bad_hall_is_one_line_and_writes_nothing(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    room, told = FAULTS[name]
    Path("hall.json").write_text(json.dumps(document(name, room)))
    with within(LIMIT):
        assert cli.run(["arrange", "hall.json", "-o", "out.svg"]) == 2
    out, line = capsys.readouterr()
    assert out == ""
    place = "" if "is not a number" in told else "rooms["
    assert line.startswith(f"scenewright: hall.json: {place}")
    assert line.count("\n") == 1
    assert told in line
    assert re.search(r"; \w.{7,}$", line), "no remedy"
    assert os.listdir() == ["hall.json"]


@pytest.fixture(scope="module", autouse=True)
def _compiled() -> None:
    """Compiling takes its time; what is measured here is the search."""
    crowd = hall(demands=[{"category": "showcase", "count": 99}, {"category": "lockers"}])
    answer(crowd)


def answer(room: Room) -> Solution:
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    return scenewright.solve(brief, preset="quick", steps=400, threads=1)


ROOM = (
    r"no room left in the hall: \d+\.\d m², what is placed needs \d+\.\d m² .*; {} m² more needed"
)
SHORT: dict[str, tuple[Room, str, str]] = {
    "20 000 objects in 20 m²": (
        hall(**SMALL, demands=[{"category": "showcase", "count": 20_000}]),
        r"199\d\d of 20000 showcase",
        ROOM.format(r"88\d\d\d\.\d"),
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
        r"no room left in a: 4\.0 m², .* more needed",
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
        r"no room left in a: 8\.\d m², .* 26\.5 m² more needed",
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
        r"no room left .* 2\.2 m² more needed",
    ),
    "more than the floor bears, not required": (
        asks(count=400, required=False),
        r"3\d\d of 400 showcase",
        ROOM.format(r"1\d\d\d\.\d"),
    ),
    "behind what stands there": (
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
        assert "showcase: no place in the hall is large enough for one of 20 by 9 m" in out
        assert sorted(os.listdir()) == ["hall.json", "out.json"]
