"""Folding is exact: against a slow search, on the printed example, on meshes."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from deadline import HANGS, within
from scenewright import cli
from scenewright.catalog.loading import read_entry
from scenewright.core.brief.catalog import entry_of
from scenewright.geometry.folding import Repeat, cost_of, fold, parse, show, stretch, unfold
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.slabs import grow_slabs, repeated_part, slabs_of

PRINTED = ["E1", "E1", "E2", "E1", "E2", "E2", "E1", "E3", "E1", "E3", "E2"]


@cache
def least(text: str, star: float) -> float:
    """The least cost by trying everything."""
    if len(text) < 2:
        return float(len(text))
    best = min(least(text[:k], star) + least(text[k:], star) for k in range(1, len(text)))
    for p in range(1, len(text) // 2 + 1):
        if len(text) % p == 0 and text == text[:p] * (len(text) // p):
            best = min(best, least(text[:p], star) + star)
    return best


@given(st.text("abc", min_size=1, max_size=12), st.sampled_from([0.3, 1.0, 1.7]))
def test_no_expression_is_cheaper_and_it_unfolds_to_the_string(text: str, star: float) -> None:
    folded = fold(text, star)
    assert "".join(unfold(folded)) == text
    assert cost_of(folded, star) == pytest.approx(least(text, star))
    assert parse(show(folded)) == folded


@pytest.mark.parametrize("star", [0.1, 1.0, 1.9])
def test_the_printed_example_folds_as_printed(star: float) -> None:
    assert show(fold(PRINTED, star)) == "E1 (E1 E2)^2 E2 (E1 E3)^2 E2"


def test_greedy_from_the_left_costs_more_where_stars_are_not_free() -> None:
    greedy = (Repeat(("E1",), 2), "E2", "E1", Repeat(("E2",), 2), Repeat(("E1", "E3"), 2), "E2")
    assert list(unfold(greedy)) == PRINTED
    assert cost_of(greedy, 0.5) > cost_of(fold(PRINTED, 0.5), 0.5)


def test_planted_repeats_are_found() -> None:
    rng = np.random.default_rng(0)
    for _ in range(20):
        body = list(rng.permutation(list("abcdef"))[: rng.integers(2, 5)])
        times = int(rng.integers(3, 9))
        folded = fold(["x", *body * times, "y"])
        assert folded == ("x", Repeat(tuple(body), times), "y")


def test_a_long_string_without_repeats_is_folded_in_bounded_time() -> None:
    text = [chr(97 + k) for k in np.random.default_rng(1).integers(0, 4, 160)]
    with within(HANGS):
        fold(text)


@pytest.mark.parametrize("length", [2, 7, 12, 40])
def test_stretching_keeps_what_is_said_once(length: int) -> None:
    made = unfold(stretch(parse("F (A B)^2 C (D)^2 G"), length))
    assert made[0] == "F"
    assert made[-1] == "G"
    assert made.count("C") == 1
    assert abs(len(made) - max(length, 6)) <= 2


@pytest.mark.parametrize("text", ["(A B", "A)", "()^2", "^3 A", "(A B) C", "(A)^0"])
def test_what_is_no_expression_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r"character|bracket"):
        parse(text)
    assert cli.run(["fold", text]) == 2


@pytest.mark.realdata(quick=True)
def test_a_real_model_grows_by_its_storeys(real_data: Path) -> None:
    path = real_data / "kenney_city" / "starter_kit" / "building-small-c.glb"
    (one,) = read_entry(entry_of(str(path))).models
    mesh = merge([Mesh(part.vertices, part.faces) for part in one.model.parts])
    slabs = slabs_of(mesh)
    start, end, times = repeated_part(slabs.symbols)
    assert (end - start, times) == (5, 2)
    storey = float(slabs.cuts[end] - slabs.cuts[start])
    grown = grow_slabs(mesh, slabs, start, end, 3)
    assert np.ptp(grown.vertices[:, 2]) == pytest.approx(np.ptp(mesh.vertices[:, 2]) + 2 * storey)
    found = slabs_of(grown).symbols
    assert repeated_part(found)[2] >= 3


@pytest.mark.realdata
def test_rows_of_a_city_model_are_read_and_folded(real_data: Path) -> None:
    path = real_data / "citymodels_cityjson" / "delft.json"
    assert cli.run(["fold", str(path), "--to", "30"]) == 0
