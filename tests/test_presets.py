"""What steers a search is in presets: changing a value there changes what is found."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import scenewright as sw
from scenewright.core.errors import InputError
from scenewright.domains import domain_of, domains, presets, problems, solvers
from scenewright.engine.rows import Preset, preset_named
from scenewright.engine.solve import Budget
from scenewright.workflow.lists import rows

SAMPLES = {"home": "sample:home-room", "hall": "sample:hall-exhibition", "site": "sample:site-30"}
CHANGED: list[tuple[str, str, str, Any, str, int]] = [
    ("home", "chains", "hot", 0.5, "anneal", 4000),
    ("home", "chains", "cold", 1e-3, "anneal", 4000),
    ("home", "chains", "agreed", 1, "anneal", 40_000),
    ("home", "chains", "alike", 0.5, "anneal", 40_000),
    ("home", "chains", "samples", 8, "anneal", 4000),
    ("home", "chains", "pilot", 64, "anneal", 4000),
    ("home", "greedy", "along", 0.6, "greedy", 400),
    ("home", "greedy", "apart", 1.1, "greedy", 400),
    ("home", "greedy", "one", 60, "greedy", 2000),
    ("home", "greedy", "first", 60, "greedy", 2000),
    ("home", "greedy", "shake", 3.0, "greedy", 4000),
    ("hall", "chains", "chains", 2, "anneal", 3200),
    ("hall", "chains", "low", 1.0, "anneal", 3200),
    ("hall", "chains", "high", 1.0, "anneal", 3200),
    ("hall", "chains", "free", 0.1, "anneal", 3200),
    ("hall", "chains", "tries", 3, "anneal", 6400),
    ("hall", "chains", "many", 2, "anneal", 6400),
    ("hall", "moves", "walls", 0.3, "anneal", 3200),
    ("hall", "moves", "few", 8.0, "anneal", 3200),
    ("hall", "moves", "out", 0.2, "anneal", 3200),
    ("hall", "moves", "aside", 0.9, "anneal", 3200),
    ("hall", "moves", "seldom", 0.6, "anneal", 3200),
    ("hall", "moves", "called", 0.9, "anneal", 3200),
    ("hall", "moves", "form", 0.5, "anneal", 3200),
    ("hall", "moves", "far", 0.9, "anneal", 3200),
    ("hall", "moves", "block", 4, "anneal", 9600),
    ("hall", "guided", "rate", 5.0, "gd-mh", 300),
    ("hall", "guided", "stuck", 1, "gd-mh", 300),
    ("hall", "guided", "draws", 1, "gd-mh", 300),
    ("hall", "guided", "shortest", 8.0, "gd-mh", 300),
    ("site", "fill", "loosest", (1.0,), "fill", 2),
    ("site", "fill", "variety", 20.0, "fill", 6),
    ("site", "fill", "askew", -20.0, "fill", 8),
    ("site", "exchange", "partners", 2, "fill", 2),
    ("site", "exchange", "tries", 1, "fill", 2),
    ("site", "exchange", "leeway", 3.2, "fill", 2),
    ("site", "exchange", "give", 0.0, "fill", 2),
    ("site", "matrix", "alike", 1.0, "vp", 300),
    ("site", "matrix", "position", 3.0, "vp", 300),
    ("site", "matrix", "eyes", 2, "vp", 300),
    ("site", "chain", "hot", 0.1, "sa", 4000),
    ("site", "chain", "cold", 1.0, "sa", 4000),
]
"""Domain, group of settings, name, another value, the solver and the steps that show it."""


def steered(problem: Any, group: str, name: str, value: Any) -> Any:
    """A problem with one setting changed; of halls the one that is started."""
    if hasattr(problem, "start"):
        return problem._replace(problem=steered(problem.problem, group, name, value))
    changed = getattr(problem.settings, group)._replace(**{name: value})
    return problem._replace(settings=problem.settings._replace(**{group: changed}))


@cache
def problem_of(source: str) -> Any:
    return problems(sw.read(source))[0]


@cache
def usual_of(source: str, domain: str, solver: str, steps: int) -> tuple[Any, int]:
    """What a solver finds with the settings as they are."""
    return found_by(problem_of(source), domain, solver, Budget(steps=steps))


def found_by(problem: Any, domain: str, solver: str, budget: Budget) -> tuple[Any, int]:
    found = solvers(domain)[solver].run(problem, budget, 1)
    return found.layouts[0].boxes, found.evaluations


@pytest.mark.parametrize(
    ("domain", "group", "name", "value", "solver", "steps"),
    CHANGED,
    ids=["-".join(row[:3]) for row in CHANGED],
)
def test_another_value_finds_another_layout(
    domain: str, group: str, name: str, value: Any, solver: str, steps: int
) -> None:
    problem = problem_of(SAMPLES[domain])
    usual, looked = usual_of(SAMPLES[domain], domain, solver, steps)
    other, also = found_by(
        steered(problem, group, name, value), domain, solver, Budget(steps=steps)
    )
    assert looked != also or not np.array_equal(usual, other)


@pytest.mark.parametrize(
    ("group", "name", "value", "solver", "steps"),
    [
        ("fill", "void", 50.0, "fill", 40),
        ("exchange", "shade", 0.0, "fill", 8),
        ("aims", "lit", 1, "fill", 8),
        ("fill", "steps", 0, "fill", 8),
        ("exchange", "rays", 1, "fill", 8),
        ("exchange", "paces", 300, "fill", 8),
        ("matrix", "templates", 9, "vp", 100),
        ("matrix", "rays", 1, "vp", 200),
    ],
)
def test_another_value_finds_another_site(
    group: str, name: str, value: Any, solver: str, steps: int
) -> None:
    problem = problem_of("sample:site-landmarks")
    usual, looked = usual_of("sample:site-landmarks", "site", solver, steps)
    other, also = found_by(
        steered(problem, group, name, value), "site", solver, Budget(steps=steps)
    )
    assert looked != also or not np.array_equal(usual, other)


@pytest.mark.parametrize(
    ("domain", "group", "name", "solver", "few", "many"),
    [
        ("home", "chains", "seconds", "anneal", 0.02, 0.4),
        ("hall", "chains", "seconds", "anneal", 0.02, 0.4),
        ("hall", "guided", "steps", "gd-mh", 50, 100),
        ("site", "fill", "tried", "fill", 2, 12),
        ("site", "chain", "moves", "sa", 100, 200),
    ],
)
def test_work_without_a_budget_is_what_the_settings_say(
    domain: str, group: str, name: str, solver: str, few: float, many: float
) -> None:
    problem = problem_of(SAMPLES[domain])
    found_by(problem, domain, solver, Budget(steps=20))
    less, more = (
        found_by(steered(problem, group, name, value), domain, solver, Budget())[1]
        for value in (few, many)
    )
    assert less < more


@pytest.mark.parametrize(
    ("name", "value"), [("attempts", 1), ("first", 0.3), ("again", 0.6), ("wrong", 1.0)]
)
def test_attempts_at_halls_follow_the_preset(
    name: str, value: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    brief, table = sw.read(SAMPLES["hall"]), presets("hall")
    usual = table["default"]
    search = usual.settings.search._replace(**{name: value})
    tuned = usual._replace(settings=usual.settings._replace(search=search))
    monkeypatch.setitem(table, "tuned", tuned)  # type: ignore[arg-type]

    def differs(seed: int) -> bool:
        one, two = (
            sw.solve(brief, preset=each, steps=200, seed=seed) for each in ("default", "tuned")
        )
        return one.pieces != two.pieces or one.evaluations != two.evaluations

    assert any(map(differs, range(3, 15))), "all that is tried again is tried alike"


@pytest.mark.parametrize(
    ("group", "name", "value"),
    [
        ("tries", "first", 0.1),
        ("tries", "fill", 0.9),
        ("tries", "layouts", 1),
        ("tries", "crowded", 1),
        ("tries", "again", 0.9),
        ("tries", "fills", 1),
        ("costs", "missing", (1000.0, 1.0, 0.0)),
        ("costs", "energy", 50.0),
    ],
)
def test_rooms_are_tried_and_answers_compared_by_the_preset(
    group: str, name: str, value: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    brief, table = sw.read("sample:home-flat"), presets("home")
    usual = table["quick"]
    changed = getattr(usual.settings, group)._replace(**{name: value})
    tuned = usual._replace(settings=usual.settings._replace(**{group: changed}))
    monkeypatch.setitem(table, "tuned", tuned)  # type: ignore[arg-type]
    one, other = (sw.solve(brief, preset=each, seed=4) for each in ("quick", "tuned"))
    assert one.pieces != other.pieces or one.evaluations != other.evaluations


def test_every_setting_is_listed() -> None:
    listed = {(row["domain"], row["name"]): row["settings"] for row in rows("presets")}
    for domain in domains():
        for name, preset in domain.table("presets").items():
            assert isinstance(preset, Preset)
            assert set(listed[domain.name, name]) == set(getattr(preset.settings, "_fields", ()))
    assert listed["home", "default"]["chains"]["hot"] == 0.07
    assert listed["site", "default"]["fill"]["loosest"] == (8.0, 2.0, *(1.0,) * 10)


def test_an_unknown_preset_is_refused_with_those_there_are() -> None:
    with pytest.raises(InputError, match="unknown preset 'x'"):
        preset_named(presets("site"), "x")
    with pytest.raises(InputError, match="one of default"):
        sw.solve(sw.read(SAMPLES["site"]), preset="x")
    assert domain_of("site").table("presets") is presets("site")
