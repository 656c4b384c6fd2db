"""Homes: valid whatever the room, the same for the same seed, honest about what is missing."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from scenewright.core.brief import Ask, Brief, FixedItem
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.domains import check
from scenewright.domains.home import solving as home
from scenewright.domains.home.programme import PROGRAMME
from scenewright.formats import read, samples
from scenewright.formats.solution_json import brief_of, to_document

FUNCTIONS = sorted(set(PROGRAMME) - {"other"})


def one_room(function: str, width: float, depth: float, skew: float = 0.0, **more: object) -> Brief:
    outline = [(0.0, 0.0), (width, 0.0), (width + skew, depth), (0.0, depth)]
    door = {"at": (min(0.7, width / 2), 0.0), "width": 0.8, "swing": "in", "hinge": "left"}
    window = {"at": (width / 2, depth), "width": min(1.2, width / 2), "sill": 0.9}
    room = {
        "id": "r",
        "function": function,
        "outline": outline,
        "doors": [door],
        "windows": [window],
        **more,
    }
    return Brief.model_validate({"rooms": [room]})


def faults(solution: Solution) -> list[str]:
    return [f.message for f in check(solution).findings]


@pytest.mark.parametrize("name", [n for n in samples() if n.startswith("sample:home-")])
def test_samples_are_valid_and_complete(name: str) -> None:
    solution = home.solve(read(name), seed=0)
    report = check(solution)
    assert report.valid, faults(solution)
    assert not report.notes, report.notes
    assert not [out for out in solution.left_out if out.required]


def test_the_same_seed_gives_the_same_home_on_any_number_of_threads() -> None:
    brief = read("sample:home-studio")
    first = home.solve(brief, seed=5, steps=2000, threads=3)
    second = home.solve(brief, seed=5, steps=2000, threads=1)
    assert first.pieces == second.pieces
    assert first.terms == second.terms
    assert home.solve(brief, seed=6, steps=2000).pieces != first.pieces


@settings(max_examples=25, deadline=None, suppress_health_check=list(HealthCheck))
@given(
    function=st.sampled_from(FUNCTIONS),
    width=st.floats(1.2, 6.0),
    depth=st.floats(1.2, 6.0),
    skew=st.floats(-0.5, 1.5),
    seed=st.integers(0, 1000),
)
@example(function="dining", width=2.0, depth=1.625, skew=0.0, seed=0)
def test_nothing_collides_or_blocks_in_any_room(
    function: str, width: float, depth: float, skew: float, seed: int
) -> None:
    solution = home.solve(one_room(function, width, depth, skew), seed=seed, steps=2000)
    wrong = [f for f in check(solution).findings if f.kind not in ("unreachable_piece",)]
    assert not wrong, [f.message for f in wrong]


def test_what_cannot_fit_is_left_out_with_a_reason() -> None:
    brief = one_room("double_bedroom", 1.5, 1.5)
    solution = home.solve(brief, steps=1000)
    assert {"sleeping", "wardrobe"} & {out.what for out in solution.left_out if out.required}
    assert all(out.reason for out in solution.left_out)


def test_a_wish_replaces_the_programme() -> None:
    brief = one_room("living", 4.0, 4.0, ask=[Ask(group="desk", count=2).model_dump()])
    solution = home.solve(brief, steps=4000)
    assert [p.function for p in solution.patches] == ["desk", "desk"]
    assert not solution.left_out


def test_an_unknown_wish_is_told() -> None:
    brief = one_room("living", 4.0, 4.0, ask=[{"group": "sofabed"}])
    with pytest.raises(InputError, match="unknown furniture group 'sofabed'"):
        home.solve(brief, steps=10)


def test_fixed_things_stay_and_are_kept_clear_of() -> None:
    bed = FixedItem(category="double_bed", at=(3.0, 1.2), heading=np.pi, size=(1.6, 2.0, 0.9))
    brief = one_room("double_bedroom", 4.2, 3.6, fixed=[bed.model_dump()])
    solution = home.solve(brief, seed=2, steps=6000)
    beds = [p for p in solution.pieces if p.category.endswith("_bed")]
    assert [p.fixed for p in beds] == [True]
    assert beds[0].pose[:2] == (3.0, 1.2)
    assert not faults(solution)


def test_cancelling_returns_what_was_found() -> None:
    solution = home.solve(read("sample:home-flat"), cancel=lambda: True)
    assert check(solution).valid


def test_progress_runs_to_the_end() -> None:
    heard: list[float] = []
    home.solve(read("sample:home-studio"), steps=500, progress=lambda share, _: heard.append(share))
    assert heard == sorted(heard)
    assert heard[-1] == 1.0


def test_energies_are_the_sums_of_the_explained_costs() -> None:
    solution = home.solve(read("sample:home-studio"), steps=2000)
    assert all(t.cost == pytest.approx(t.value * t.weight) for t in solution.terms)
    for space, energy in solution.energies.items():
        costs = [t.cost for t in solution.terms if t.space == space]
        assert energy == pytest.approx(sum(costs))


@pytest.mark.parametrize("preset", ["paper", "paper-repaired", "quick"])
def test_presets_run(preset: str) -> None:
    solution = home.solve(one_room("living", 5.0, 4.5), preset=preset, steps=500)
    assert solution.preset == preset
    assert solution.patches


def test_seconds_bound_the_work() -> None:
    brief = read("sample:home-studio")
    solution = home.solve(brief, seconds=0.02)
    assert solution.pieces
    assert solution.evaluations < home.solve(brief, steps=10_000).evaluations


def test_locked_groups_stay_whole_when_solved_again() -> None:
    first = home.solve(read("sample:home-studio"), seed=2)
    locked = [
        replace(p, fixed=p.category == "double_bed" or p.category == "single_bed")
        for p in first.pieces
    ]
    document = to_document(replace(first, pieces=tuple(locked)))
    second = home.solve(brief_of(document), seed=9)
    group = next(p.group for p in locked if p.fixed)
    kept = {(p.id, p.pose, p.on) for p in second.pieces if p.group == group}
    assert kept == {(p.id, p.pose, p.on) for p in first.pieces if p.group == group}
    assert len({p.id for p in second.pieces}) == len(second.pieces)
    assert not [f for f in check(second).findings if f.kind in ("collision", "floating")]
