"""Every solver of every domain tells how far it is, and stops at once when nobody waits."""

from __future__ import annotations

import importlib.util
import statistics
import time
from pathlib import Path

import pytest

import scenewright as sw
from scenewright.core.plan import Plan
from scenewright.domains import plan_of, solvers
from scenewright.engine.shared_progress import SharedProgress
from scenewright.engine.solve import Report
from scenewright.formats import solution_json

SAMPLES = {"home": "home-flat", "hall": "hall-shop", "site": "site-30"}
EVERY = [(domain, name) for domain in SAMPLES for name in solvers(domain)]
AT_ONCE = 0.2
"""Seconds within which a cancelled run returns, on a machine that does nothing else."""


@pytest.fixture(scope="module")
def planned() -> dict[str, tuple[sw.Brief, Plan]]:
    briefs = {domain: sw.read(f"sample:{name}") for domain, name in SAMPLES.items()}
    return {domain: (brief, plan_of(brief)) for domain, brief in briefs.items()}


@pytest.fixture(params=EVERY, ids=["-".join(each) for each in EVERY])
def case(request: pytest.FixtureRequest) -> tuple[str, str]:
    if request.param[1] == "miqp" and importlib.util.find_spec("ortools") is None:
        pytest.skip("ortools is not installed")
    found: tuple[str, str] = request.param
    return found


def test_shares_rise_to_one(
    case: tuple[str, str], planned: dict[str, tuple[sw.Brief, Plan]]
) -> None:
    (domain, name), shares = case, list[float]()
    brief, plan = planned[domain]
    sw.solve(brief, plan=plan, solver=name, steps=50)
    sw.solve(
        brief, plan=plan, solver=name, seconds=1.0, progress=lambda share, _: shares.append(share)
    )
    assert shares == sorted(shares)
    assert 0.0 <= shares[0] < 0.6
    assert shares[-1] == 1.0
    assert len(shares) >= 4


def test_cancelled_at_the_first_report_it_answers_at_once(
    case: tuple[str, str], planned: dict[str, tuple[sw.Brief, Plan]], tmp_path: Path
) -> None:
    domain, name = case
    brief, plan = planned[domain]
    sw.solve(brief, plan=plan, solver=name, steps=50)
    took = []
    for seed in range(3):
        told: list[float] = []
        found = sw.solve(
            brief,
            plan=plan,
            solver=name,
            seconds=60.0,
            seed=seed,
            progress=lambda _share, _what, told=told: told.append(time.perf_counter()),  # type: ignore[misc]
            cancel=lambda told=told: bool(told),  # type: ignore[misc]
        )
        took.append(time.perf_counter() - told[0])
    assert statistics.median(took) < 3.0 * AT_ONCE, "three times for a busy machine"
    assert found.evaluations > 0
    path = tmp_path / "found.json"
    solution_json.write(found, path)
    read = solution_json.read(path)
    assert read.pieces == found.pieces
    kinds = {finding.kind for finding in sw.check(read).findings}
    assert not kinds & {"malformed", "unknown_space"}


def test_progress_of_parts_side_by_side_only_rises() -> None:
    told: list[float] = []
    shared = SharedProgress(lambda share, _: told.append(share), [1.0, 1.0])
    for share in (0.5, 1.0, 0.2, 1.0):
        shared.part(0, "a")(Report(share, 0.0, tuple))
    shared.ended(0, "a")
    assert told == sorted(told)
    assert told[:2] == [0.125, 0.25]
    assert told[-1] == 0.5
    shared.ended(1, "b")
    assert told[-1] == 1.0
