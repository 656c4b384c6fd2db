"""What found no place at first is tried again beside all that did."""

from __future__ import annotations

from hall_chains import Posed, posed, two_zones
from scenewright.catalog.assets import shipped
from scenewright.domains.hall.build_problem import build_problem
from scenewright.domains.hall.fit import Fitted, place_lacking, without
from scenewright.domains.hall.presets import PRESETS
from scenewright.domains.hall.shortfall.absent import list_absent


def hall(tables: int = 4) -> Posed:
    shelves = {"id": "shelves", "category": "wall_shelving", "count": 5, "zone": "west"}
    return posed(two_zones(shelves, {"category": "display_table", "count": tables}))


def give_up(there: Posed, demand: int) -> Fitted:
    """The layout without the units of a demand."""
    stay = [k for k, unit in enumerate(there.fitted.units) if unit.demand != demand]
    units = [there.fitted.units[k] for k in stay]
    rest = there.fitted
    start = without(rest.start, rest.problem, stay)
    weights = PRESETS["default"].weights
    problem = build_problem(there.hall, there.wishes, units, rest.hosts, weights, shipped())
    return Fitted(units, rest.hosts, problem, start)


def place(there: Posed, less: Fitted, cancelled: bool = False) -> Fitted:
    weights = PRESETS["default"].weights
    return place_lacking(there.hall, there.wishes, weights, shipped(), 0, less, lambda: cancelled)


def count(there: Posed, fitted: Fitted, demand: int) -> int:
    return sum(unit.last - unit.first for unit in fitted.units if unit.demand == demand)


def test_shelves_without_a_place_get_one_where_walls_are_free() -> None:
    there = hall()
    less = give_up(there, 0)
    assert count(there, less, 0) == 0
    more = place(there, less)
    assert count(there, more, 0) == 5
    assert count(there, more, 1) == 4
    assert not list_absent(there.wishes, more.units, there.hall.names)


def test_whoever_has_cancelled_waits_for_nothing_more() -> None:
    there = hall()
    less = give_up(there, 0)
    assert place(there, less, cancelled=True) is less


def test_only_what_is_absent_is_listed_in_the_zones_it_may_go_to() -> None:
    there = hall()
    assert not list_absent(there.wishes, there.fitted.units, there.hall.names)
    less = give_up(there, 0)
    found = list_absent(there.wishes, less.units, there.hall.names)
    assert [(u.demand, u.zone, u.first, u.last) for u in found] == [(0, 0, 0, 5), (0, 0, 0, 1)]
