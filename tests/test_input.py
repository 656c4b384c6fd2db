"""Bad input is told in one line that names file and place; good input is read by name."""

from __future__ import annotations

import contextlib
import json
import random
import zipfile
from pathlib import Path
from typing import Any

import jsonschema
import pytest

import scenewright.formats as formats
from scenewright.building.plan import spaces
from scenewright.core.errors import InputError
from scenewright.core.registry import domain_of
from scenewright.formats import brief_json

ROOM = {"outline": [[0, 0], [5, 0], [5, 4], [0, 4]]}
XML = (
    "<?xml version='1.0' encoding='UTF-8'?><home version='7000' wallHeight='250'>"
    "<room name='Kitchen'><point x='0' y='0'/><point x='300' y='0'/><point x='300' y='300'/>"
    "<point x='0' y='300'/></room>{}</home>"
)


def one_room(**more: Any) -> str:
    return json.dumps({"rooms": [ROOM | more]})


def door(**more: Any) -> str:
    return one_room(name="Hall", doors=[{"at": [2, 0]} | more])


BAD_JSON = {
    "empty": ("", ".json: is empty: 0 bytes"),
    "broken": ('{"rooms": [', "line 1, column 12: broken JSON"),
    "trailing comma": ('{"rooms": [],}', "line 1"),
    "a list": ("[]", "no JSON object"),
    "a number": ("3", "no JSON object"),
    "too deep": ("[" * 100_000, "nested"),
    "NaN": (one_room().replace("4", "NaN"), "NaN"),
    "infinite": (one_room().replace("4", "1e999"), "rooms[0].outline[2][1]"),
    "a vast integer": (one_room().replace("4", "9" * 5000), "broken JSON"),
    "no rooms": ('{"rooms": []}', "rooms: is empty"),
    "rooms missing": ("{}", "rooms: is missing"),
    "a wrong key": (one_room(walls=1), "rooms[0].walls: is not a known key"),
    "a wrong version": ('{"version": 9, "rooms": []}', "version"),
    "an unknown function": (one_room(function="lounge"), "rooms[0].function"),
    "an unknown function in a list": (one_room(function=["lounge"]), "rooms[0].function[0]"),
    "a room of two corners": (one_room(outline=[[0, 0], [1, 0]]), "rooms[0].outline"),
    "a negative door": (door(width=-1), "rooms[0].doors[0].width"),
    "a negative height": (one_room(height=-2), "rooms[0].height"),
    "a far coordinate": (one_room(outline=[[0, 0], [1e9, 0], [1, 1]]), "rooms[0].outline[1][0]"),
    "a text for a number": (door(width="wide"), "rooms[0].doors[0].width"),
    "a self-crossing outline": (
        one_room(name="Bath", outline=[[0, 0], [4, 4], [4, 0], [0, 4]]),
        "rooms[0] 'Bath': the outline crosses or touches itself at (2.00, 2.00)",
    ),
    "an outline touching itself": (
        one_room(outline=[[0, 0], [4, 0], [4, 4], [2, 0], [0, 4]]),
        "crosses or touches itself",
    ),
    "an empty room": (one_room(outline=[[0, 0], [4, 0], [2, 0]]), "rooms[0]"),
    "one point": (one_room(outline=[[1, 1], [1, 1], [1, 1]]), "fewer than three"),
    "centimetres": (one_room(outline=[[0, 0], [500, 0], [500, 400]]), "lengths are metres"),
    "millimetres of floor": (one_room(outline=[[0, 0], [0.1, 0], [0, 0.1]]), "of floor"),
    "a hole outside": (one_room(holes=[[[8, 8], [9, 8], [9, 9]]]), "holes[0] is outside"),
    "a hole that cuts": (
        one_room(holes=[[[-1, 2], [6, 2], [6, 2.2], [-1, 2.2]]]),
        "holes[0] cuts the room in pieces",
    ),
    "a crossing hole": (one_room(holes=[[[1, 1], [2, 2], [2, 1], [1, 2]]]), "holes[0] crosses"),
    "two rooms with one id": (
        json.dumps({"rooms": [ROOM | {"id": "a"}, ROOM | {"id": "a"}]}),
        "the id 'a' is used twice",
    ),
    "overlapping rooms": (
        json.dumps({"rooms": [ROOM, ROOM | {"name": "Bath"}]}),
        "rooms[1] 'Bath': overlaps rooms[0] by 20.00 m²",
    ),
    "an unknown level": (one_room(level="9"), "the level '9' does not exist"),
    "two levels with one id": (
        json.dumps({"levels": [{"id": "0"}, {"id": "0"}], "rooms": [ROOM]}),
        "levels[1]: the id '0' is used twice",
    ),
    "a main wall too many": (one_room(main_wall=4), "edges 0 to 3"),
    "a main wall of no length": (
        one_room(outline=[[0, 0], [0, 0], [5, 0], [5, 4]], main_wall=0),
        "has no length",
    ),
    "a door off the wall": (door(at=[2, 1]), "doors[0]: is off the wall: (2, 1) is 1.00 m"),
    "a door wider than its wall": (door(width=6), "is 6 m wide, but its wall only 5.00 m"),
    "a door over the corner": (
        one_room(windows=[{"at": [0.1, 0], "width": 3}]),
        "windows[0]: reaches 1.40 m over the end",
    ),
    "a door to nowhere": (door(to="attic"), "leads to 'attic', which is not a room"),
    "a door to the wrong room": (door(to="hall"), "beyond the wall is the outside"),
    "a window in the ceiling": (one_room(windows=[{"at": [2, 0], "sill": 3}]), "above the ceiling"),
    "two openings at one place": (
        one_room(doors=[{"at": [2, 0]}], windows=[{"at": [2.3, 0], "sill": 0.5}]),
        "windows[0]: overlaps rooms[0] 'room-1' doors[0]",
    ),
    "two doors with one id": (
        one_room(doors=[{"at": [1, 0], "id": "d"}, {"at": [3, 0], "id": "d"}]),
        "two openings have the id 'd'",
    ),
    "a sofa outside": (
        one_room(fixed=[{"category": "sofa", "at": [8, 1], "size": [2, 1, 0.8]}]),
        "fixed[0]: the sofa stands",
    ),
    "degrees": (
        one_room(fixed=[{"category": "sofa", "at": [1, 1], "size": [2, 1, 0.8], "heading": 90}]),
        "rooms[0].fixed[0].heading: 90 is not possible; headings are radians",
    ),
    "a sofa in centimetres": (
        one_room(fixed=[{"category": "sofa", "at": [1, 1], "size": [200, 1, 0.8]}]),
        "fixed[0].size[0]: 200 is not possible; it should be at most 30 (lengths",
    ),
    "a number in quotes": (door(width="0.9"), 'doors[0].width: "0.9" is not possible; give a num'),
    "yes for true": (
        one_room(ask=[{"group": "desk", "required": "yes"}]),
        'ask[0].required: "yes" is not possible; give true or false',
    ),
    "a wish in short": (one_room(ask=["desk"]), 'ask[0]: "desk" is not possible; write {"group": '),
    "a misspelt key": (
        one_room().replace('"outline"', '"outlin"'),
        'rooms[0].outlin: is not a known key (and 1 more); did you mean "outline"?',
    ),
    "a key in place of the one that is missing": (
        one_room(fixed=[{"what": "fireplace", "at": [1, 1], "size": [1, 0.5, 1]}]),
        'fixed[0].what: is not a known key (and 1 more); did you mean "category"?',
    ),
    "a key far from any": (one_room(zzz=1), "rooms[0].zzz: is not a known key; correct its spell"),
    "a misspelt key of a catalogue": (
        json.dumps({"catalogs": [{"path": "x", "scal": 2}], "rooms": [ROOM]}),
        'catalogs[0].scal: is not a known key; did you mean "scale"?',
    ),
    "a door in centimetres": (door(width=90), "it should be at most 20 (lengths are metres)"),
    "a catalogue by number": (
        json.dumps({"catalogs": [3], "rooms": [ROOM]}),
        "catalogs[0]: 3 is not possible; give a text in quotes",
    ),
    "two corners": (one_room(outline=[[0, 0], [4, 0]]), "outline: needs at least 3 corners, has 2"),
    "three coordinates": (
        one_room(outline=[[0, 0], [4, 0, 1], [4, 4]]),
        "rooms[0].outline[1]: takes at most 2 entries, has 3",
    ),
    "a flat sofa": (
        one_room(fixed=[{"category": "sofa", "at": [1, 1], "size": [2, 0, 0.8]}]),
        "rooms[0].fixed[0].size[1]",
    ),
    "a room inside its walls": (
        json.dumps(
            {
                "outlines": "centre",
                "wall_thickness": 2,
                "rooms": [{"outline": [[0, 0], [1, 0], [1, 1], [0, 1]]}],
            }
        ),
        "nothing is left of the room",
    ),
}

BAD_XML = {
    "empty": ("", "is empty"),
    "broken": ("<home><room>", "broken XML"),
    "another root": ("<page/>", "is <page>, not a Sweet Home 3D home"),
    "a document type": ("<!DOCTYPE home [<!ENTITY a 'b'>]><home>&a;</home>", "document type"),
    "an outside entity": (
        '<!DOCTYPE home [<!ENTITY x SYSTEM "file:///etc/passwd">]><home name="&x;"/>',
        "document type",
    ),
    "an unknown encoding": ("<?xml version='1.0' encoding='x-none'?><home/>", "encoding"),
    "no room": ("<home/>", "has no room"),
    "too deep": ("<home>" + "<a>" * 100 + "</a>" * 100 + "</home>", "nested"),
    "a wall without start": (XML.format("<wall id='w' yStart='1'/>"), "<wall> 'w': xStart is"),
    "NaN": (XML.format("<wall xStart='NaN' yStart='0' xEnd='9' yEnd='9'/>"), "xStart is 'NaN'"),
    "an infinite point": (
        XML.format("<room><point x='inf' y='0'/></room>"),
        "line 1, <point>: x is 'inf'",
    ),
    "a negative width": (
        XML.format("<pieceOfFurniture name='Sofa' x='1' y='1' width='-9' depth='9' height='9'/>"),
        "<pieceOfFurniture> 'Sofa': width is '-9'",
    ),
    "a word for a number": (XML.format("<level id='l' elevation='high'/>"), "elevation is 'high'"),
    "a level without id": (XML.format("<level elevation='1'/>"), "id is missing"),
}


def refusal(path: Path | str) -> str:
    with pytest.raises(InputError) as caught:
        formats.read(path)
    told = str(caught.value)
    assert "\n" not in told
    assert told.startswith(str(path))
    assert len(told) < 600
    return told


@pytest.mark.parametrize("name", BAD_JSON)
def test_bad_json_is_told_in_one_line(tmp_path: Path, name: str) -> None:
    text, fault = BAD_JSON[name]
    path = tmp_path / "flat.json"
    path.write_text(text, encoding="utf-8")
    assert fault in refusal(path)


@pytest.mark.parametrize("suffix", [".xml", ".sh3d"])
@pytest.mark.parametrize("name", BAD_XML)
def test_bad_xml_is_told_in_one_line(tmp_path: Path, name: str, suffix: str) -> None:
    text, fault = BAD_XML[name]
    path = tmp_path / f"home{suffix}"
    if suffix == ".xml":
        path.write_text(text, encoding="utf-8")
    else:
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("Home.xml", text)
    assert fault in refusal(path)


def test_files_that_are_not_there_or_not_files(tmp_path: Path) -> None:
    (tmp_path / "folder.json").mkdir()
    assert "no such file" in refusal(tmp_path / "none.json")
    assert "is a folder; add --batch" in refusal(tmp_path / "folder.json")
    assert "is a folder; add --batch" in refusal(tmp_path)
    assert "'.odd' files cannot be read; use one of: .json, .sh3d, .xml" in refusal("flat.odd")
    assert "there is no such file or folder" in refusal("flat")
    (tmp_path / "flat").write_text("{}")
    assert "no suffix" in refusal(tmp_path / "flat")
    assert "; all: scenewright list samples" in refusal("sample:castle")
    assert "use one of: sample:home-flat" in refusal("sample:home-falt")
    assert "say sample:home-flat" in refusal("home-flat")


def test_text_that_is_not_utf8(tmp_path: Path) -> None:
    (tmp_path / "flat.json").write_bytes(b'{"name": "K\xfcche"}')
    assert "is not UTF-8" in refusal(tmp_path / "flat.json")


def test_archives_that_are_broken_or_hostile(tmp_path: Path) -> None:
    path = tmp_path / "home.sh3d"
    path.write_bytes(b"")
    assert "is empty" in refusal(path)
    path.write_bytes(b"not a zip")
    assert "not a whole zip" in refusal(path)
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("../Home.xml", XML.format(""))
    assert "holds no Home.xml" in refusal(path)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("Home.xml", XML.format(" " * 70 * 2**20))
    assert "larger than 64 MiB" in refusal(path)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("Home.xml", XML.format("<wall/>" * 1000))
    whole = path.read_bytes()
    for length in (10, len(whole) // 2, len(whole) - 5):
        path.write_bytes(whole[:length])
        assert "not a whole zip" in refusal(path)
    damaged = bytearray(whole)
    damaged[60:70] = b"\0" * 10
    path.write_bytes(damaged)
    refusal(path)


def test_a_zip_that_lies_about_its_size(tmp_path: Path) -> None:
    path = tmp_path / "home.sh3d"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("Home.xml", XML.format(" " * 2**20))
    content = bytearray(path.read_bytes())
    at = content.rindex(b"PK\x01\x02") + 24
    content[at : at + 4] = (100).to_bytes(4, "little")
    path.write_bytes(content)
    refusal(path)


def test_random_bytes_never_end_in_another_error(tmp_path: Path) -> None:
    chance = random.Random(0)
    good = tmp_path / "good.sh3d"
    with zipfile.ZipFile(good, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("Home.xml", XML.format(""))
    content = good.read_bytes()
    for _ in range(200):
        damaged = bytearray(content)
        for _ in range(chance.randint(1, 4)):
            damaged[chance.randrange(len(damaged))] = chance.randrange(256)
        path = tmp_path / "damaged.sh3d"
        path.write_bytes(damaged)
        with contextlib.suppress(InputError):
            formats.read(path)


def test_all_samples_read_and_obey_the_schema() -> None:
    names = formats.samples()
    assert "sample:home-flat" in names
    assert len(names) >= 6
    schema = brief_json.schema()
    valid = jsonschema.validators.validator_for(schema)(schema)
    for name in names:
        brief = formats.read(name)
        document = json.loads(brief_json.dumps(brief))
        valid.validate(document)
        assert brief_json.loads(brief_json.dumps(brief)) == brief


def test_every_room_of_a_sample_can_be_reached_from_outside() -> None:
    for name in formats.samples():
        brief = formats.read(name)
        if not domain_of(brief.domain).rooms:
            continue
        found = {space.id: space for space in spaces(brief)}
        ways = [o for s in found.values() for o in s.openings if o.kind != "window"]
        reached = {o.spaces[0] for o in ways if len(o.spaces) == 1}
        stairs = {s.id for s in found.values() if "hall" in s.functions}
        for _ in found:
            reached |= {s for o in ways if reached & set(o.spaces) for s in o.spaces}
            reached |= stairs if reached & stairs else set()
        assert reached == set(found), name


def test_the_flat_is_a_flat_of_three_bedrooms() -> None:
    found = {space.id: space for space in spaces(formats.read("sample:home-flat"))}
    assert {"living", "kitchen", "bathroom", "toilet", "hall", "balcony"} <= set(found)
    for space in found.values():
        kinds = {opening.kind for opening in space.openings}
        assert kinds & {"door", "passage"}, space.id
        if space.id in ("living", "kitchen", "bedroom", "child", "study"):
            assert "window" in kinds, space.id


def test_a_suffix_that_cannot_be_written_is_refused_early() -> None:
    with pytest.raises(InputError, match=r"'\.dwg' files cannot be written; use one of: \.json"):
        formats.writer("flat.dwg")
