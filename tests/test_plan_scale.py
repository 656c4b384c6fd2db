"""Plans drawn too small are noticed and can be corrected; hidden levels are named."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from pydantic import ValidationError

import scenewright as sw
from scenewright import formats
from scenewright.building.plan import spaces
from scenewright.check.drawn_scale import DrawnScale, estimate_scale
from scenewright.cli.commands import run
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.report import Report


def plan(*widths: float, **more: Any) -> dict[str, Any]:
    doors = [{"at": [0.6 + 0.8 * k, 0], "width": w} for k, w in enumerate(widths)]
    return {
        "rooms": [
            {
                "name": "Bedroom",
                "outline": [[0, 0], [4, 0], [4, 3], [0, 3]],
                "doors": doors,
                "windows": [{"at": [2, 3], "width": 1.0}],
            }
        ]
    } | more


def judged(document: dict[str, Any]) -> Report:
    return sw.check(sw.solve(Brief.model_validate(document), steps=50))


@pytest.mark.parametrize(
    ("widths", "noted"),
    [((0.5, 0.55, 0.8), True), ((0.6, 0.85), False), ((0.5,), False), ((0.7, 0.7, 0.6), False)],
)
def test_a_plan_of_narrow_doors_is_noted_with_the_factor(
    widths: tuple[float, ...], noted: bool
) -> None:
    notes = [n for n in judged(plan(*widths)).notes if n.missing == "scale"]
    assert len(notes) == noted
    assert not noted or "hinged doors measure 0.55 m (median of 3)" in notes[0].message
    assert not noted or "1.4 times too small; arrange it with --scale 1.4" in notes[0].message


@pytest.mark.parametrize(
    ("widths", "factor"),
    [
        ((0.35, 0.35, 0.4), 0.75 / 0.35),
        ((1.6, 1.8, 2.0), 0.5),
        ((0.75, 0.9), 1.0),
        ((0.5, 0.6), 1.25),
        ((), None),
    ],
)
def test_the_factor_brings_the_middle_door_to_a_usual_width(
    widths: tuple[float, ...], factor: float | None
) -> None:
    doors = [{"at": [2.0 + 2.5 * k, 3], "width": w} for k, w in enumerate(widths)]
    rooms = [
        {"name": "Hall", "outline": [[0, 0], [9, 0], [9, 3], [0, 3]], "doors": doors},
        {"name": "Bedroom", "outline": [[0, 3.1], [9, 3.1], [9, 6], [0, 6]]},
    ]
    brief = Brief.model_validate({"rooms": rooms})
    found = estimate_scale(brief, spaces(brief))
    assert (found and found.factor) == pytest.approx(factor)


def test_toilets_and_bathtubs_speak_for_a_scale_or_against_it() -> None:
    toilet = {"name": "WC", "outline": [[4, 0], [4.4, 0], [4.4, 1], [4, 1]]}
    tub = {"category": "bathtub", "at": [2, 2.6], "size": [0.8, 0.5, 0.5]}
    document = plan(0.5)
    document["rooms"].append(toilet | {"function": "toilet"})
    document["rooms"][0] |= {"fixed": [tub, tub | {"size": [1.6, 0.7, 0.5]}]}
    brief = Brief.model_validate(document)
    found = estimate_scale(brief, spaces(brief))
    assert found is not None
    assert found.factor == pytest.approx(1.25)  # of 1.5, 0.75 / 0.4, 1 / 0.8 and 1
    assert (found.doors, found.is_doubtful) == (1, False)


def test_two_leaves_to_the_outside_say_nothing() -> None:
    document = plan()
    document["rooms"][0]["doors"] = [{"at": [1, 0], "width": 1.5}, {"at": [3, 0], "width": 0.8}]
    brief = Brief.model_validate(document)
    assert estimate_scale(brief, spaces(brief)) == DrawnScale(1.0, 1, 0.8)


@pytest.mark.parametrize("sample", [name for name in formats.samples() if "home" in name])
def test_no_sample_is_doubted(sample: str) -> None:
    brief, found = formats.read_planned(sample)
    scale = estimate_scale(brief, found.spaces)
    assert scale is not None
    assert not scale.is_doubtful


def test_a_sample_drawn_half_as_large_is_doubted() -> None:
    brief, found = formats.read_planned("sample:home-flat", scale=0.5)
    scale = estimate_scale(brief, found.spaces)
    assert scale is not None
    assert scale.is_doubtful
    assert 1.6 < scale.factor < 2.0


def test_the_note_goes_with_the_scale_it_names() -> None:
    assert not [n for n in judged(plan(0.55, 0.6, 0.65, scale=1.33)).notes if n.missing == "scale"]


def test_every_command_says_so_once_on_the_standard_error(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, saved = tmp_path / "flat.json", str(tmp_path / "solved.json")
    path.write_text(json.dumps(plan(0.35, 0.35, 0.4)))
    text = "hinged doors measure 0.35 m (median of 3): the plan seems drawn 2.1 times too small"
    commands = (
        ["arrange", str(path), "-o", saved, "--steps", "50"],
        ["arrange", str(path), "--alternatives", "2", "--steps", "50"],
        ["check", saved],
        ["explain", saved],
        ["explain", saved, "--json"],
    )
    for command in commands:
        assert run(command) in (0, 1)
        out, err = capsys.readouterr()
        assert f"{command[1]}: {text}; arrange it with --scale 2.1\n" in err
        assert "hinged doors" not in out
    for command in (["arrange", str(path), "-q", "--steps", "50"], ["check", saved, "-q"]):
        run(command)
        assert capsys.readouterr().err == ""
    run(["arrange", str(path), "--scale", "1.5", "--steps", "50"])
    assert "1.4 times too small; arrange it with --scale 2.1\n" in capsys.readouterr().err
    run(["arrange", str(path), "--scale", "2.1", "--steps", "50"])
    assert "hinged" not in capsys.readouterr().err


def test_a_scale_is_applied_once_to_what_is_drawn_in_plan() -> None:
    box = {"category": "wardrobe", "at": [3.7, 1.0], "heading": 3.14, "size": [1.2, 0.6, 2.0]}
    vase = {"category": "vase", "at": [3.7, 1.2], "size": [0.2, 0.2, 0.3], "z": 2.0, "on": "w"}
    document = plan(0.6, walls=[{"start": [0, 0], "end": [4, 0], "thickness": 0.1}], scale=1.5)
    document["rooms"][0] |= {
        "fixed": [box | {"id": "w"}, vase],
        "outlets": [{"at": [4, 1], "kind": "power"}],
        "radiators": [{"at": [2, 3], "width": 1.0}],
    }
    brief = Brief.model_validate(document)
    room = brief.rooms[0]
    assert room.outline[2] == (6.0, 4.5)
    assert room.doors[0].width == pytest.approx(0.9)
    assert brief.walls[0].end == (6.0, 0.0)
    assert brief.walls[0].thickness == pytest.approx(0.15)
    wardrobe, standing = room.fixed
    assert wardrobe.size == (1.2, 0.6, 2.0)
    assert 6.0 - wardrobe.at[0] == pytest.approx(4.0 - 3.7, abs=0.01)
    shift = [a - b for a, b in zip(standing.at, wardrobe.at, strict=True)]
    assert shift == pytest.approx([0.0, 0.2])
    assert room.outlets[0].at == (6.0, 1.5)
    assert room.radiators[0].width == 1.0
    again = Brief.model_validate_json(brief.model_dump_json())
    assert brief.scale == 1.0
    assert again == brief
    assert spaces(again)[0].outline.max() == 6.0


def test_a_plan_in_centimetres_is_read_with_its_scale(tmp_path: Path) -> None:
    document = json.loads(json.dumps(plan(), default=list))
    room = document["rooms"][0]
    room["outline"] = [[100 * x, 100 * y] for x, y in room["outline"]]
    room["doors"] = [{"at": [60, 0], "width": 85}, {"at": [200, 0]}]
    room["windows"] = [{"at": [200, 300], "width": 120}]
    document["walls"] = [{"start": [0, 0], "end": [400, 0], "thickness": 12}]
    path = tmp_path / "centimetres.json"
    path.write_text(json.dumps(document))
    with pytest.raises(InputError, match="at most 20"):
        formats.read(path)
    brief = formats.read(path, scale=0.01)
    assert brief.input_report is not None
    assert {row.outcome for row in brief.input_report.rows} == {"changed"}
    plain = brief.model_copy(update={"input_report": None})
    assert plain == Brief.model_validate(document | {"scale": 0.01})
    assert [door.width for door in brief.rooms[0].doors] == pytest.approx([0.85, 0.85])
    assert brief.rooms[0].outline[2] == (4.0, 3.0)
    assert brief.rooms[0].windows[0].width == pytest.approx(1.2)
    assert brief.walls[0].thickness == pytest.approx(0.12)
    path.write_text(json.dumps(document | {"scale": 0.02}))
    again = formats.read(path, scale=0.5).rooms[0]
    assert (again.outline, again.doors[0]) == (brief.rooms[0].outline, brief.rooms[0].doors[0])


def test_models_are_scaled_as_documents_are() -> None:
    document = plan(0.6, walls=[{"start": [0, 0], "end": [4, 0], "thickness": 0.1}])
    brief = Brief.model_validate(document)
    made = Brief(rooms=brief.rooms, walls=brief.walls, scale=1.5)
    assert made == Brief.model_validate(document | {"scale": 1.5})
    assert brief.rooms[0].doors[0].width == 0.6


@pytest.mark.parametrize(
    ("more", "told"),
    [
        ({"scale": 0}, "greater"),
        ({"scale": "2"}, "number"),
        ({"scale": 1e3}, "less"),
        ({"domain": "site", "sites": [], "scale": 2.0}, "only homes and halls have a scale"),
    ],
)
def test_a_scale_that_cannot_be_is_refused(more: dict[str, Any], told: str) -> None:
    with pytest.raises(ValidationError, match=told):
        Brief.model_validate(plan(0.8) | more)


def test_a_plan_is_not_scaled_out_of_reach(tmp_path: Path) -> None:
    far = plan(0.8, scale=20.0)
    far["rooms"][0]["outline"] = [[9000, 0], [9004, 0], [9004, 3]]
    path = tmp_path / "far.json"
    path.write_text(json.dumps(far))
    with pytest.raises(InputError, match="within 10 km"):
        formats.read(path)


def test_the_scale_of_the_command_line_and_of_a_batch(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "small.json").write_text(json.dumps(plan(0.55, 0.54)))
    small, words = str(tmp_path / "small.json"), ["--steps", "50"]
    assert run(["arrange", small, "--json", *words]) in (0, 1)
    first = json.loads(capsys.readouterr().out)
    assert any("--scale 1.4" in note["message"] for note in first["check"]["notes"])
    assert run(["arrange", small, "--json", "--scale", "1.4", *words]) in (0, 1)
    second = json.loads(capsys.readouterr().out)
    assert not any("--scale" in note["message"] for note in second["check"]["notes"])
    area = [d["check"]["figures"]["rooms"]["bedroom"]["area"] for d in (first, second)]
    assert area[1] == pytest.approx(1.4**2 * area[0], rel=1e-3)
    row = sw.batch([small], tmp_path / "out", steps=50, scale=1.4)[0]
    assert "--scale" not in row.message
    assert run(["arrange", small, "--scale", "0"]) == 2


HOME = """<home name='h'>
<level id='l0' name='Ground' elevation='0' height='250'/>
<level id='l1' name='Bedrooms' elevation='262' height='250' visible='false'/>
<level id='l2' name='Roof' elevation='524' height='250' viewable='false'/>
<room level='l0' name='Living room'><point x='0' y='0'/><point x='500' y='0'/>
<point x='500' y='400'/><point x='0' y='400'/></room>
<room level='l1' name='Bedroom'><point x='0' y='0'/><point x='400' y='0'/>
<point x='400' y='400'/><point x='0' y='400'/></room>
</home>"""


def test_hidden_levels_are_named_and_can_be_included(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "home.xml"
    path.write_text(HOME)
    brief = formats.read(path)
    assert [room.name for room in brief.rooms] == ["Living room"]
    assert brief.notes == [
        "the level 'Bedrooms' (1 room, 16 m²) is hidden in Sweet Home 3D and "
        "was not read; add --hidden-levels to include it"
    ]
    whole = formats.read(path, hidden_levels=True)
    assert [room.name for room in whole.rooms] == ["Living room", "Bedroom"]
    assert whole.notes == []
    run(["arrange", str(path), "--json", "--steps", "50"])
    told = json.loads(capsys.readouterr().out)["check"]["notes"]
    assert any("the level 'Bedrooms'" in note["message"] for note in told)
    run(["arrange", str(path), "--hidden-levels", "--steps", "50"])
    out = capsys.readouterr()
    assert "Bedroom" in out.out
    assert "hidden in" not in out.out


def test_a_home_of_hidden_levels_only_says_so(tmp_path: Path) -> None:
    path = tmp_path / "home.xml"
    path.write_text(HOME.replace("name='Ground'", "name='Ground' visible='false'"))
    with pytest.raises(InputError, match="all its levels are hidden; show them, or add --hidden"):
        formats.read(path)


def test_other_files_have_no_hidden_levels(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "plan.json"
    path.write_text(json.dumps(plan(0.85)))
    run(["arrange", str(path), "--hidden-levels", "--steps", "50"])
    assert "--hidden-levels has no effect" in " ".join(capsys.readouterr().err.split())


@pytest.mark.parametrize("domain", ["home", "hall"])
def test_openings_above_the_ceiling_are_noted(domain: str) -> None:
    room = plan(0.9, domain=domain)["rooms"][0] | {"height": 2.4}
    high = {"doors": [{"at": [1, 0], "height": 2.6}, {"at": [3, 0], "height": 2.45}]}
    rooms = [room | high | {"windows": [{"at": [2, 3], "sill": 0.9, "height": 2.0}]}]
    noted = [n for n in judged({"domain": domain, "rooms": rooms}).notes if n.missing == "height"]
    assert [note.message for note in noted] == [
        "doors[0] of Bedroom reaches 2.6 m, above the ceiling at 2.4 m, and ends there "
        "(as does 1 more); lower its sill or height"
    ]
    usual = [n.missing for n in judged({"domain": domain, "rooms": [room]}).notes]
    assert "height" not in usual
