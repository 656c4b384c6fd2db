"""Budgets of a search: steps where it goes step by step, layouts where whole ones are made."""

from __future__ import annotations

import pytest

from scenewright import cli


@pytest.mark.parametrize(
    ("options", "fault"),
    [
        (["sample:village-hamlet", "--steps", "5"], "give --layouts"),
        (["sample:extend-terrace", "--steps", "5"], "give --layouts"),
        (["sample:home-room", "--layouts", "5"], "give --steps"),
        (["sample:hall-shop", "--layouts", "5"], "give --steps"),
        (["sample:home-room", "--steps", "5", "--layouts", "5"], "exclude each other"),
        (["sample:home-room", "--steps", "0"], "give a positive whole number"),
        (["sample:village-hamlet", "--layouts", "99999999999"], "takes more than a day here"),
        (["sample:home-room", "--steps", "99999999999"], "takes more than a day here"),
    ],
)
def test_a_budget_of_another_kind_or_of_days_is_refused(
    options: list[str], fault: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.run(["arrange", *options]) == 2
    refusal = capsys.readouterr().err
    assert fault in refusal
    assert refusal.count("\n") == 1


def test_layouts_are_what_a_village_is_given(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.run(["arrange", "sample:village-hamlet", "--layouts", "1"]) in (0, 1)
    assert "1 layouts evaluated" in capsys.readouterr().out
