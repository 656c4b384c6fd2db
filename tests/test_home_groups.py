"""Contracts over the table of furniture groups and the case library."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapely import Polygon

from scenewright.catalog.assets import shipped
from scenewright.core.catalog import Group, Member
from scenewright.core.layout import corners
from scenewright.core.space import Space
from scenewright.domains.home.cases.library import (
    cases,
    find_preferred_case,
    fitting,
    nearest,
    nearest_first,
)
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.needs.household import FURTHER
from scenewright.domains.home.programme import ALSO, FALLBACK, PROGRAMME, programme


def footprint(member: Member) -> Polygon:
    box = [member.x, member.y, member.heading + np.pi / 2, member.size.width, member.size.depth]
    return Polygon(corners(np.array(box)))


def may_meet(first: Member, second: Member, group: Group) -> bool:
    kinds = shipped().kinds
    if kinds[first.category].flat or kinds[second.category].flat:
        return True
    if (
        second.category in kinds[first.category].under
        or first.category in kinds[second.category].under
    ):
        return True
    low, high = max(first.z, second.z), min(first.z + first.size[2], second.z + second.size[2])
    return low > high - 1e-9


def list_forms(function: str) -> list[Group]:
    """The cases of a function, and the forms for households that say how many they are."""
    return [*cases(function).groups, *(FURTHER[function]() if function in FURTHER else ())]


@pytest.mark.parametrize("function", GROUPS)
def test_members_stay_inside_the_footprint(function: str) -> None:
    for group in list_forms(function):
        outline = Polygon(
            np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * [group.width / 2, group.depth / 2]
        ).buffer(1e-6)
        for member in group.members:
            assert outline.contains(footprint(member)), (group.name, member.category)


@pytest.mark.parametrize("function", GROUPS)
def test_members_do_not_run_into_each_other(function: str) -> None:
    for group in list_forms(function):
        for first, second in itertools.combinations(group.members, 2):
            if not may_meet(first, second, group):
                common = footprint(first).buffer(-0.003).intersection(footprint(second))
                assert common.area < 1e-6, (group.name, first.category, second.category)


@pytest.mark.parametrize("function", GROUPS)
def test_what_stands_on_something_rests_on_it(function: str) -> None:
    for group in cases(function).groups:
        for member in group.members:
            if member.on >= 0:
                below = group.members[member.on]
                assert member.z == pytest.approx(below.z + below.size.height)
                assert footprint(below).buffer(0.02).contains(footprint(member))


@pytest.mark.parametrize("function", GROUPS)
def test_every_case_holds_what_makes_it(function: str) -> None:
    catalog = shipped()
    for group in cases(function).groups:
        held = {m.category for m in group.members}
        assert held & set(GROUPS[function].essential), group.name
        assert held <= set(catalog.kinds), held - set(catalog.kinds)
        assert group.function == function


@given(st.sampled_from(sorted(GROUPS)), st.floats(0.2, 5), st.floats(0.2, 5))
def test_fitting_cases_fit_and_come_nearest_first(
    function: str, width: float, depth: float
) -> None:
    found = fitting(function, width, depth)
    far = [np.hypot(g.width - width, g.depth - depth) for g in found]
    assert far == sorted(far)
    assert all(g.width <= width + 0.01 and g.depth <= depth + 0.01 for g in found)
    fit = [g for g in cases(function).groups if g.width <= width and g.depth <= depth]
    assert {g.name for g in fit} <= {g.name for g in found}


@given(st.sampled_from(sorted(GROUPS)), st.floats(0.2, 5), st.floats(0.2, 5))
def test_nearest_agrees_with_a_plain_search(function: str, width: float, depth: float) -> None:
    found = cases(function).groups
    assert nearest(function, width, depth) is min(
        found, key=lambda g: math.dist((g.width, g.depth), (width, depth))
    )


COARSE = st.integers(0, 6).map(float)  # many equal coordinates and distances


@given(st.lists(st.tuples(COARSE, COARSE), min_size=1), st.tuples(COARSE, COARSE), COARSE)
def test_cases_come_as_a_full_sort_of_those_that_fit(
    sizes: list[tuple[float, float]], size: tuple[float, float], most: float
) -> None:
    fits = [i for i, own in enumerate(sizes) if own[0] - size[0] <= most >= own[1] - size[1]]
    wanted = sorted(fits, key=lambda i: (math.dist(sizes[i], size), i))
    assert nearest_first(np.array(sizes), size, most).tolist() == wanted


@pytest.mark.parametrize("function", GROUPS)
def test_larger_rooms_wish_for_larger_cases(function: str) -> None:
    areas = [find_preferred_case(function, area) for area in (2, 6, 12, 20, 40)]
    sizes = [g.width * g.depth for g in areas]
    assert sizes == sorted(sizes)


def test_the_programme_names_only_known_groups() -> None:
    named = {row.group for rows in PROGRAMME.values() for row in rows}
    assert named | set(FALLBACK.values()) | set(ALSO.values()) <= set(GROUPS)


@pytest.mark.parametrize(
    "function", [f for f in PROGRAMME if f not in ("other", "balcony", "hall")]
)
def test_every_function_has_something_essential_in_a_good_room(function: str) -> None:
    outline = np.array([[0, 0], [4, 0], [4, 3], [0, 3]], float)
    wishes = programme(Space("r", "", (function,), "0", outline), 12.0, frozenset())
    assert wishes[0].rank == 0
    assert [w.rank for w in wishes] == sorted(w.rank for w in wishes)


@pytest.mark.parametrize("function", ["kitchen", "kitchenette"])
def test_worktop_lies_on_both_sides_of_a_hob(function: str):
    for case in cases(function).groups:
        units = sorted((m.x, m) for m in case.members if m.z == 0)
        row = [m.category for _, m in units]
        hob = row.index("hob_cabinet")
        wide = next(m.size.width for _, m in units if m.category == "hob_cabinet")
        left = units[hob][1].x - wide / 2 + case.width / 2
        spare = min(left, case.width - wide - left)
        assert abs(hob - row.index("fridge")) > 1 if "fridge" in row else True
        if case.width - 0.6 * ("fridge" in row) >= 1.8:
            assert spare >= 0.3 - 1e-6, case.name


def test_units_of_a_kitchen_fill_its_run():
    for case in cases("kitchenette").groups:
        widths = [m.size.width for m in case.members if m.z == 0]
        assert sum(widths) == pytest.approx(case.width)
        assert min(widths) >= 0.3 - 1e-6
