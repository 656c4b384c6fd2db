"""Labels that cannot be meant as they are: sense outweighs them, and it is said."""

from __future__ import annotations

from typing import Any

import pytest

from scenewright.building.labels import tell_labels
from scenewright.building.plan import spaces
from scenewright.core.brief import Brief
from scenewright.domains.home.needs.household import decide_household


def room(
    name: str,
    x: float,
    y: float,
    size: tuple[float, float],
    *doors: tuple[float, float],
    **more: Any,
) -> dict[str, Any]:
    width, depth = size
    outline = [(x, y), (x + width, y), (x + width, y + depth), (x, y + depth)]
    return {"name": name, "outline": outline, "doors": [{"at": at} for at in doors], **more}


def functions(*rooms: dict[str, Any]) -> list[tuple[str, ...]]:
    return [space.functions for space in spaces(Brief.model_validate({"rooms": rooms}))]


def test_kitchens_back_to_back_are_one() -> None:
    small = room("Kitchen", 0, 0, (3, 3), (1.5, 0))
    large = room("Küche", 3.12, 0, (4, 3), (6, 0))
    assert functions(small, large) == [("dining",), ("kitchen",)]
    assert functions(room("Kitchen", 2, 0, (1, 3), (2.5, 0)), large)[0] == ("storage",)
    brief = Brief.model_validate({"rooms": [small, large]})
    ((space, text),) = tell_labels(brief, spaces(brief))
    assert (space.name, "(9.0 m²) is furnished as dining" in text) == ("Kitchen", True)


def test_the_kitchen_is_where_something_stands_or_a_door_leads() -> None:
    stove = {"category": "hob_cabinet", "at": (0.3, 0.3), "size": (0.6, 0.6, 0.9)}
    small = room("Kitchen", 0, 0, (3, 3), (1.5, 0), fixed=[stove])
    closed = room("Kitchen", 3.12, 0, (4, 3))
    assert functions(small, closed) == [("kitchen",), ("storage",)]
    assert functions(room("Kitchen", 0, 0, (3, 3), (1.5, 0)), closed)[0] == ("kitchen",)


@pytest.mark.parametrize("gap", [0.12, 0.6])
def test_stated_functions_and_kitchens_apart_stay(gap: float) -> None:
    second = {"function": "kitchen"} if gap < 0.5 else {}
    first = room("Kitchen", 0, 0, (3, 3), (1.5, 0), **second)
    other = room("Kitchen", 3 + gap, 0, (3, 3), (4.5, 0), **second)
    assert functions(first, other) == [("kitchen",), ("kitchen",)]


def test_two_dwellings_back_to_back_keep_their_kitchens() -> None:
    rooms = [
        room("Kitchen", 0, 0, (3, 3), (1.5, 3)),
        room("Living room", 0, 3.1, (3, 4), (1.5, 7.1)),
        room("Kitchen", 3.2, 0, (3, 3), (4.7, 3)),
        room("Living room", 3.2, 3.1, (3, 4), (4.7, 7.1)),
    ]
    assert [f for f in functions(*rooms) if f == ("kitchen",)] == [("kitchen",)] * 2


def test_a_bedroom_too_small_for_a_bed_does_not_get_it() -> None:
    small = room("Bedroom", 0, 0, (1.2, 2), (0.6, 0))
    unknown = room("Xyzzy", 1.32, 0, (4, 3), (3, 0))
    assert functions(small, unknown) == [("storage",), ("bedroom",)]
    assert functions(room("Bedroom", 0, 0, (1.8, 2), (0.6, 0)))[0] == ("bedroom",)
    assert functions(small | {"function": "bedroom"})[0] == ("bedroom",)


def test_a_table_is_not_the_only_one_in_a_room_nobody_can_enter() -> None:
    closed = room("Dining", 0, 0, (5, 4))
    living = room("Living room", 5.12, 0, (6, 4), (7, 0))
    brief = Brief.model_validate({"rooms": [closed, living]})
    assert decide_household(spaces(brief)).eats_in == "living-room"
    opened = brief.model_validate({"rooms": [closed | {"doors": [{"at": (2, 0)}]}, living]})
    assert decide_household(spaces(opened)).eats_in == "dining"
