"""Every solver of every domain tells how far it is, and stops at once when nobody waits."""

from __future__ import annotations

import importlib.util
from functools import partial
from pathlib import Path
from threading import Event

import pytest

import scenewright as sw
from scenewright.core.layout import SEARCH, SETTLED, STAGES, BestLayout, NamedBox
from scenewright.core.plan import Plan
from scenewright.domains import plan_of, solvers
from scenewright.domains.hall.solvers.blocks import stop_when
from scenewright.engine.shared_progress import SharedProgress
from scenewright.engine.solve import Report
from scenewright.formats import solution_json
from scenewright.studio.streaming import stream_layouts

SAMPLES = {
    "home": "home-room",
    "hall": "hall-shop",
    "site": "site-courtyards",
    "village": "village-hamlet",
    "extend": "extend-terrace",
}
TWO_ROOMS = "home-studio"
"""Solved by the default solver of homes, as well."""
STEPS = {"village": 2, "extend": 2}
"""Steps of a whole run (else 300): where one makes a whole layout."""
EVERY = [(domain, name) for domain in SAMPLES for name in solvers(domain)]
EVERY.append((TWO_ROOMS, "anneal"))
STOOD = {"source"}
"""Where pieces stand that no solver places."""
ASKED_AGAIN = 256
"""Times a run may ask once more whether it is to stop after it was told so: each of its threads,
and each stage on the way out, asks once or a few times."""


class Stop:
    """Answers true from its ``first``-th call on, and counts the calls after that."""

    def __init__(self, first: int) -> None:
        self.first, self.calls = first, 0

    def __call__(self) -> bool:
        self.calls += 1
        return self.calls >= self.first

    @property
    def after(self) -> int:
        return max(self.calls - self.first, 0)


@pytest.fixture(scope="module")
def planned() -> dict[str, tuple[sw.Brief, Plan]]:
    samples = {**SAMPLES, TWO_ROOMS: TWO_ROOMS}
    briefs = {domain: sw.read(f"sample:{name}") for domain, name in samples.items()}
    return {domain: (brief, plan_of(brief)) for domain, brief in briefs.items()}


@pytest.fixture(params=EVERY, ids=["-".join(each) for each in EVERY])
def case(request: pytest.FixtureRequest) -> tuple[str, str]:
    if request.param[1] == "miqp" and importlib.util.find_spec("ortools") is None:
        pytest.skip("ortools is not installed")
    found: tuple[str, str] = request.param
    return found


def test_cancelled_at_the_first_report_it_answers_at_once(
    case: tuple[str, str], planned: dict[str, tuple[sw.Brief, Plan]], tmp_path: Path
) -> None:
    """It reports no further progress of the search, and what it returns can be kept."""
    domain, name = case
    brief, plan = planned[domain]
    told: list[float] = []
    found = sw.solve(
        brief,
        plan=plan,
        solver=name,
        seconds=60.0,
        progress=lambda share, _what: told.append(share),
        cancel=lambda: bool(told),
    )
    assert told[0] < 1.0
    assert len(told) < ASKED_AGAIN
    assert found.evaluations > 0
    path = tmp_path / "found.json"
    solution_json.write(found, path)
    read = solution_json.read(path)
    assert read.pieces == found.pieces
    kinds = {finding.kind for finding in sw.check(read).findings}
    assert not kinds & {"malformed", "unknown_space"}


def test_the_best_layout_so_far_is_streamed_and_makes_a_solution(
    case: tuple[str, str], planned: dict[str, tuple[sw.Brief, Plan]]
) -> None:
    domain, name = case
    brief, plan = planned[domain]
    heard: list[tuple[str, str]] = []
    whys: set[tuple[str, bool]] = set()
    shares: list[float] = []
    rows: dict[str, tuple[NamedBox, ...]] = {}

    def watch(best: BestLayout) -> None:
        heard.append((best.space, best.stage))
        whys.add((best.stage, bool(best.reason)))
        rows[best.space] = best.rows()

    found = sw.solve(
        brief,
        plan=plan,
        solver=name,
        steps=STEPS.get(domain, 300),
        threads=1,
        watch=watch,
        progress=lambda share, _: shares.append(share),
    )
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    assert {piece.space for piece in found.pieces} - STOOD <= set(rows)
    assert len(heard) > len(rows), "heard of more than once"
    assert {stage for _, stage in heard} <= {*STAGES}
    assert all(told == (stage not in (SEARCH, SETTLED)) for stage, told in whys)
    last = dict(heard)
    assert {last[space] for space in last} == {SETTLED}, "the last picture is of what stays"
    drawn = sw.solution_of(brief, rows, plan=plan)
    assert len(drawn.pieces) > len(brief.rooms)
    assert not any(
        "the layout has no place" in out.reason for out in drawn.left_out if domain == "hall"
    )
    again = sw.solve(brief, plan=plan, solver=name, steps=STEPS.get(domain, 300), threads=1)
    assert again.pieces == found.pieces, "who watches changes nothing"


def test_the_first_boxes_are_shown_however_soon_they_come() -> None:
    """Nothing is said of empty pictures but the first; the first with boxes is not held back."""
    told: list[dict[str, object]] = []
    hear = stream_layouts(told.append)
    box = NamedBox("tower", (0.0, 0.0, 0.0, 8.0, 8.0))
    for rows in ((), (), (box,), (box, box)):
        hear(BestLayout("site", 0.1, 9.0, partial(tuple, rows)))
    assert [one["boxes"] for one in told] == [[], [["tower", 0.0, 0.0, 0.0, 8.0, 8.0]]]


def test_cancelled_in_the_middle_of_a_search_it_answers_at_once(
    case: tuple[str, str], planned: dict[str, tuple[sw.Brief, Plan]]
) -> None:
    """Whatever it is at, it hardly asks again."""
    domain, name = case
    brief, plan = planned[domain]
    stop = Stop(12)
    sw.solve(brief, plan=plan, solver=name, seconds=60.0, cancel=stop)
    assert stop.after < ASKED_AGAIN


def test_one_long_call_of_cp_sat_is_cancelled() -> None:
    """Twenty-six groups in one zone: one model, worked on until its seconds are spent. Told to
    stop while it works, the program returns with what it has."""
    pytest.importorskip("ortools")
    outline = [[0, 0], [40, 0], [40, 22], [30, 22], [30, 30], [0, 30]]
    demands = [
        {"id": f"g{k}", "category": "showcase", "count": 3 + k % 5, "size": [1.2, 0.7, 1.5]}
        for k in range(26)
    ]
    doors = [{"at": [20, 0], "width": 2, "use": "both"}]
    hall = {"id": "h", "function": "hall", "outline": outline, "doors": doors, "demands": demands}
    brief = sw.Brief.model_validate({"domain": "hall", "rooms": [hall]})
    stop = Stop(20)
    sw.solve(brief, solver="miqp", seconds=60.0, cancel=stop)
    assert 0 < stop.after < ASKED_AGAIN


def test_a_search_that_asks_nobody_is_stopped_from_beside() -> None:
    """As CP-SAT is: the first calls are not heard, the search has not begun."""
    stopped, waited = Event(), [0]

    def stop() -> None:
        waited[0] += 1
        if waited[0] > 2:
            stopped.set()

    with stop_when(Stop(5), stop, 0.01):
        assert stopped.wait(10.0)
    with stop_when(lambda: False, stop, 0.01):
        pass
    assert waited[0] == 3


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
