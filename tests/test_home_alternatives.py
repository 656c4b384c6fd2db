"""Plans of one home that differ: by room, by wall, by group, and by how much."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations
from math import pi
from pathlib import Path

import pytest

from scenewright import cli
from scenewright.core.solution import Patch, Solution
from scenewright.domains import alternatives, check
from scenewright.domains.home import solving as home
from scenewright.domains.home.alternatives import choose, difference, sides
from scenewright.domains.home.presets import PRESETS
from scenewright.formats import read


@pytest.fixture(scope="module")
def plans() -> tuple[Solution, ...]:
    return alternatives(read("sample:home-l-shape"), 3, steps=3000)


def with_patches(home_: Solution, *boxes: tuple[str, tuple[float, ...]]) -> Solution:
    room = home_.patches[0].space
    patches = tuple(Patch(f"{room}/{f}", room, f, b) for f, b in boxes)  # type: ignore[arg-type]
    return replace(home_, patches=patches)


def test_plans_are_valid_and_differ(plans: tuple[Solution, ...]) -> None:
    assert len(plans) == 3
    for plan in plans:
        assert check(plan).valid
        assert {p.space for p in plan.patches} == {p.space for p in plans[0].patches}
    assert min(difference(a, b) for a, b in combinations(plans, 2)) > 0.3


def test_they_are_ranked_and_the_best_is_no_worse_than_any_one_solution(
    plans: tuple[Solution, ...],
) -> None:
    energies = [sum(plan.energies.values()) for plan in plans]
    assert energies == sorted(energies)
    first = home.solve(read("sample:home-l-shape"), steps=3000)
    assert energies[0] <= sum(first.energies.values()) + 1e-9


def test_plans_that_do_not_differ_are_not_given(plans: tuple[Solution, ...]) -> None:
    assert len(choose([plans[0]] * 3, 3)) == 1
    assert PRESETS["default"].settings.variety.least > 0


def test_difference_counts_what_moved_turned_came_or_went(plans: tuple[Solution, ...]) -> None:
    bed, desk = ("sleeping", (1.0, 1.0, 0.0, 2.0, 2.0)), ("desk", (3.0, 3.0, 0.0, 1.0, 1.0))
    one = with_patches(plans[0], bed, desk)
    assert difference(one, one) == 0.0
    turned = with_patches(plans[0], ("sleeping", (1.0, 1.0, pi / 2, 2.0, 2.0)), desk)
    assert difference(one, turned) == pytest.approx(4 / 5)
    moved = with_patches(plans[0], ("sleeping", (2.0, 1.0, 0.0, 2.0, 2.0)), desk)
    assert difference(one, moved) == pytest.approx(2 / 5)
    gone = with_patches(plans[0], bed)
    assert difference(one, gone) == difference(gone, one) == pytest.approx(1 / 5)


def test_it_is_told_where_things_stand(plans: tuple[Solution, ...]) -> None:
    bed = with_patches(plans[0], ("sleeping", (1.0, 1.0, 0.0, 2.0, 2.0)))
    assert sides(bed).endswith(": bed at the west wall")


def test_alternatives_of_a_home_on_the_command_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "plan.json"
    command = ["arrange", "sample:home-l-shape", "-o", str(out), "--alternatives", "2"]
    assert cli.run([*command, "--steps", "1500"]) == 0
    told = capsys.readouterr().out
    assert "differs" in told
    assert "bed at the" in told or "sofa at the" in told
    assert sorted(p.name for p in tmp_path.iterdir()) == ["plan-1.json", "plan-2.json"]
