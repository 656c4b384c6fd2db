"""Rugs of a home: its style's before the sofa, quiet ones of their places elsewhere."""

from __future__ import annotations

from dataclasses import replace

import pytest

from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import solve
from scenewright.domains.home.furnishing.rugs import match_rugs
from scenewright.formats import read

AT = Pose(0.0, 0.0, 0.0, 0.0)


def rug(space: str, group: str, asset: str = "rug", width: float = 1.4) -> Piece:
    return Piece(f"{group}/rug", "rug", asset, space, AT, Size(width, 1.0, 0.012), group)


def thing(category: str, space: str, group: str) -> Piece:
    return Piece(f"{group}/{category}", category, category, space, AT, Size(1.0, 1.0, 0.8), group)


def models(*pieces: Piece) -> list[str]:
    return [piece.asset for piece in match_rugs(pieces) if piece.category == "rug"]


def test_a_pattern_of_the_style_lies_before_the_sofa_alone() -> None:
    home = solve(read("sample:home-flat"), seed=7, steps=400)
    rugs = {p.id: p.asset for p in home.pieces if p.category == "rug"}
    patterned = {name for name, model in rugs.items() if model.startswith("rug_retro")}
    assert patterned == {name for name in rugs if "seating" in name}
    assert len(set(rugs.values())) >= 3


def test_a_studio_has_its_pattern_before_the_sofa_and_not_beside_the_bed() -> None:
    sofa, bed = thing("sofa", "a", "a/seating"), thing("double_bed", "a", "a/double")
    assert models(sofa, bed, rug("a", "a/seating"), rug("a", "a/double")) == ["rug", "rug_quiet"]


def test_a_mat_by_the_bath_a_runner_in_the_hall() -> None:
    assert models(thing("bathtub", "a", "a/bath"), rug("a", "a")) == ["rug_bath"]
    assert models(rug("a", "a", width=2.4)) == ["rug_runner"]
    assert models(rug("a", "a/double", width=2.4)) == ["rug_quiet"]


def test_a_users_own_rug_stays() -> None:
    assert models(rug("a", "a", asset="own:kilim")) == ["own:kilim"]


@pytest.mark.parametrize(
    ("width", "model"), [(1.8, "rug_quiet"), (1.9, "rug_runner"), (2.2, "rug_runner")]
)
@pytest.mark.parametrize("turned", [False, True])
def test_a_rug_by_itself_is_a_runner_from_nearly_twice_as_long_as_wide(
    width, model, turned
) -> None:
    mat = rug("a", "a", width=width)
    long, short, high = mat.size
    assert models(replace(mat, size=Size(short, long, high)) if turned else mat) == [model]


@pytest.mark.parametrize("category", ["sofa", "loveseat", "corner_sofa"])
def test_the_pattern_lies_in_the_group_of_the_seats_and_where_they_look_to(category) -> None:
    sofa = thing(category, "a", "a/seating")
    assert models(sofa, rug("a", "a/seating"), rug("a", "a")) == ["rug", "rug"]
    assert models(sofa, rug("b", "b"), rug("b", "b/seating")) == ["rug_quiet"] * 2


@pytest.mark.parametrize("category", ["bathtub", "shower", "toilet"])
def test_every_rug_of_a_bath_is_a_mat_and_none_beside_it(category) -> None:
    wet = thing(category, "a", "a/wash")
    long = rug("a", "a", width=2.4)
    assert models(wet, rug("a", "a/basin"), long, rug("b", "b")) == ["rug_bath"] * 2 + ["rug_quiet"]


def test_a_rug_of_the_brief_stays() -> None:
    assert models(replace(rug("a", "a"), fixed=True)) == ["rug"]
