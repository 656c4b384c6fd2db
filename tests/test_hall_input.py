"""Halls that cannot be: every bad brief is one line with its remedy, and nothing is written."""

from __future__ import annotations

import json
import os
import re
from pathlib import Path

import pytest

from deadline import within
from hall_briefs import LIMIT, TWO, Room, asks, box, document, hall
from scenewright import cli

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
    "a passage wider than the hall": (
        hall(zones=[{"id": "a"}, {"id": "b"}], links=[{"between": ["a", "b"], "width": 8.5}]),
        "links[0].width: 8.5 m is wider than Hall is anywhere",
    ),
    "a negative passage": (
        hall(zones=TWO, links=[{"between": ["a", "b"], "width": -1}]),
        "links[0].width",
    ),
    "a link with itself": (hall(zones=TWO, links=[{"between": ["a", "a"]}]), "with itself"),
    "a link of an unknown zone": (
        hall(zones=TWO, links=[{"between": ["a", "c"]}]),
        "'c' is not a zone",
    ),
    "a zone beside itself": (hall(zones=[{"id": "a", "beside": ["a"]}]), "beside itself"),
    "a zone beside no zone": (hall(zones=[{"id": "a", "beside": ["x"]}]), "'x' is not a zone"),
    "a zone at no door": (hall(zones=[{"id": "a", "door": "x"}]), "'x' is not a door of the hall"),
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
        "'c' is not a zone",
    ),
    "an unknown category": (asks(category="shwcase"), "use one of: showcase"),
    "an unknown pattern": (
        asks(patterns=["spiral"]),
        "'spiral' is not a pattern; use one of: single",
    ),
    "an unknown place": (asks(place="roof"), "demands[0].place"),
    "an unknown key": (asks(colour="red"), "demands[0].colour: is not a known key"),
    "facing itself": (asks(id="x", facing="x"), "demands[0] 'x': is to face itself"),
    "a freezer": (asks(category="freezer"), "use fridge_shelf"),
    "chest freezers": (asks(category="chest_freezers"), "use fridge_shelf"),
    "a quantity": (asks(quantity=3), 'quantity: is not a known key; did you mean "count"?'),
    "a number": (asks(number=3), 'number: is not a known key; did you mean "count"?'),
    "an amount": (asks(amount=3), 'amount: is not a known key; did you mean "count"?'),
    "facing itself by its category": (asks(facing="showcase"), "is to face itself"),
    "facing a zone": (
        hall(zones=TWO, demands=[{"category": "bench", "facing": "a"}, {"category": "stage"}]),
        "demands[0] 'bench': 'a' in facing is not a demand of the hall; use one of: stage",
    ),
    "facing nothing": (asks(facing="stag"), "'stag' in facing is not a demand of the hall; leave"),
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


def test_passages_are_at_most_as_wide_as_the_hall(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    zones = [{"id": "a"}, {"id": "b"}]
    columns = [box(3.9, 3.9, 4.1, 4.1), box(7.9, 3.9, 8.1, 4.1)]
    for holes, width, code in (([], 8.5, 2), ([], 7.9, 1), (columns, 7.9, 2)):
        text = json.dumps(document("h", hall(zones=zones, holes=holes)) | {"passage_width": width})
        Path("hall.json").write_text(text)
        assert cli.run(["arrange", "hall.json", "--steps", "1"]) == code
    first, second = capsys.readouterr().err.splitlines()
    assert "hall.json: passage_width: 8.5 m is wider than Hall is anywhere" in first
    assert first.endswith("give at most 8 (metres)")
    assert "a disc of at most 4.8" in second
