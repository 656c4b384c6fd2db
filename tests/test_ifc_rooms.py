"""Rooms of a building model from its spaces, else from what its walls enclose."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import shapely

from scenewright.formats.ifc.reading import brief_of
from scenewright.formats.ifc.rooms import find_rooms

Row = dict[str, Any]


def product(kind: str, box: tuple[float, ...], number: int, **more: Any) -> Row:
    """A box on the plan (west, south, east, north), 2.5 m high."""
    ring = shapely.get_coordinates(shapely.box(*box))[:-1].tolist()
    named = {"name": str(number), "long_name": "", "use": "", "uses": [], "operation": ""}
    placed = {"storey": 0, "rings": [ring], "low": 0.0, "high": 2.5, "heading": 0.0}
    hosted = {"hosted": False}
    return {"kind": kind, "id": f"g{number}", "number": number, **named, **placed, **hosted} | more


def document(*products: Row) -> Row:
    storeys = [{"name": "Ground", "number": 900}]
    return {"schema": "IFC4", "unit": "metre", "storeys": storeys, "products": list(products)}


def found(*products: Row) -> tuple[list[float], list[str]]:
    """The floors of the rooms and why others are none."""
    rooms, fates = find_rooms(document(*products), np.zeros(2))
    return [round(room.floor.area, 2) for room in rooms], [fate.reason for fate in fates]


def test_the_area_of_a_storey_and_what_covers_rooms_is_no_room() -> None:
    rooms = (product("IfcSpace", (0, 0, 4, 5), 1), product("IfcSpace", (4, 0, 8, 5), 2))
    whole = product("IfcSpace", (0, 0, 8, 5), 3)
    assert found(*rooms, whole) == ([20, 20], ["", "", "other spaces take more than half of it"])
    assert found(*rooms, whole | {"operation": "GFA"})[1][2] == "it is the area of a storey"
    upper = whole | {"storey": 1, "low": 3.0, "high": 5.0}
    assert found(*rooms, upper) == ([20, 20, 40], ["", "", ""])


def test_of_two_that_overlap_the_smaller_has_the_floor() -> None:
    rooms = (product("IfcSpace", (0, 0, 4, 5), 1), product("IfcSpace", (3, 0, 5, 5), 2))
    assert found(*rooms) == ([15, 10], ["less what another takes", ""])


def walls(gap: float = 0.0) -> list[Row]:
    """Four walls around 5 by 4 m; one ends ``gap`` before the next."""
    boxes = ((-0.2, -0.2, 5.2, 0), (5, 0, 5.2, 4), (-0.2, 4, 5.2, 4.2), (-0.2, 0, 0, 4 - gap))
    return [product("IfcWall", box, number) for number, box in enumerate(boxes, 1)]


@pytest.mark.parametrize("gap", [0.0, 0.03, 0.25])
def test_walls_enclose_a_room(gap: float) -> None:
    (area,), _ = found(*walls(gap))
    assert area == pytest.approx(20, abs=0.1)


def test_a_gap_that_a_door_fills_or_a_curtain_wall_closes_is_closed() -> None:
    assert found(*walls(1.0))[0] == []
    door = product("IfcDoor", (-0.15, 3, -0.05, 4), 9)
    assert len(found(*walls(1.0), door)[0]) == 1
    glass = product("IfcCurtainWall", (-0.1, 0, 0, 4), 9)
    assert found(*walls()[:3], glass)[0] == [20]


@pytest.mark.parametrize(
    ("said", "function"),
    [
        ({"long_name": "K\u00fcche"}, ["kitchen"]),
        ({"use": "Bedroom"}, ["bedroom"]),
        ({"long_name": "Room", "uses": ["13-51 24: Living Spaces"]}, ["living"]),
        ({"long_name": "Room 12"}, None),
    ],
)
def test_what_a_space_is_for_is_said_by_name_type_or_properties(
    said: Row, function: list[str] | None, tmp_path: Any
) -> None:
    path = tmp_path / "model.ifc"
    path.write_bytes(b"")
    space = product("IfcSpace", (0, 0, 4, 5), 1, **said)
    assert brief_of(document(space), path).rooms[0].function == function
