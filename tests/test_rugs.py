"""Rugs of a home: its style's before the sofa, quiet ones of their places elsewhere."""

from __future__ import annotations

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
    home = solve(read("sample:home-flat"), seed=0, steps=400)
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
