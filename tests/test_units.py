"""Plans in feet, inches, centimetres and millimetres: the factor is named, and it works."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from scenewright import formats
from scenewright.building.plan import spaces
from scenewright.check.plan_notes import note_scale, note_vast_rooms
from scenewright.core.errors import InputError

METRES = {"feet": 0.3048, "inches": 0.0254, "centimetres": 0.01, "millimetres": 0.001}


def house(unit: float, doors: bool = True) -> dict[str, Any]:
    """Two rooms and a hall, 14.2 m long, in a unit of ``unit`` metres."""

    def room(name: str, x: float, width: float) -> dict[str, Any]:
        outline = [(x, 0), (x + width, 0), (x + width, 4), (x, 4)]
        hole = [{"at": [(x + width) / unit, 2 / unit], "width": 0.85 / unit}] if doors else []
        return {"name": name, "outline": [[a / unit, b / unit] for a, b in outline], "doors": hole}

    return {"rooms": [room("Living room", 0, 6), room("Bedroom", 6.1, 4), room("Hall", 10.2, 4)]}


@pytest.mark.parametrize("unit", METRES)
@pytest.mark.parametrize("doors", [True, False])
def test_a_plan_in_another_unit_is_told_the_factor(tmp_path: Path, unit: str, doors: bool) -> None:
    path = tmp_path / "house.json"
    path.write_text(json.dumps(house(METRES[unit], doors)))
    wanted = f"--scale {METRES[unit]:g} if "
    try:
        brief = formats.read(path)
    except InputError as error:
        said = str(error)
    else:
        rooms = spaces(brief)
        said = "; ".join(n.message for n in (*note_scale(brief, rooms), *note_vast_rooms(rooms)))
    if doors or unit != "feet":
        assert wanted in said
        assert unit in said
    brief = formats.read(path, scale=METRES[unit])
    assert spaces(brief)[0].outline.max() == pytest.approx(6.0)
    assert all(door.width == pytest.approx(0.85) for r in brief.rooms for door in r.doors)


def test_what_is_wrong_otherwise_is_told_no_factor(tmp_path: Path) -> None:
    document = house(1.0)
    document["rooms"][0]["doors"][0]["width"] = 30
    path = tmp_path / "house.json"
    path.write_text(json.dumps(document))
    with pytest.raises(InputError) as caught:
        formats.read(path)
    assert "--scale" not in str(caught.value)
