"""Once cancelled, nothing further is begun, and what is missing is listed."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any

import pytest

import scenewright as sw
from scenewright.core.errors import CancelledError
from scenewright.core.passes import Pass, PassOptions, run_passes
from scenewright.core.solution import STOPPED
from scenewright.domains import adjust
from scenewright.domains.extend.solvers import anneal as annealing
from scenewright.domains.hall.accessories import place
from scenewright.domains.hall.retouch import loop


class Asked:
    """Says that a run is cancelled from the ``last`` time on that it is asked."""

    def __init__(self, last: int) -> None:
        self.left = last

    def __call__(self) -> bool:
        self.left -= 1
        return self.over

    @property
    def over(self) -> bool:
        return self.left <= 0


def watched(work: Callable[..., Any], asked: Asked, done: list[str]) -> Callable[..., Any]:
    """The same work, noted in ``done`` where it is begun after the run was cancelled."""

    @wraps(work)
    def noted(*args: Any, **more: Any) -> Any:
        if asked.over:
            done.append(work.__name__)
        return work(*args, **more)

    return noted


def test_no_pass_is_run_once_cancelled() -> None:
    rows = [Pass(name, "all", 1, "one more") for name in "abcd"]
    options = PassOptions(cancelled=Asked(3))
    assert run_passes(rows, 0, options, lambda by, n: n + by, lambda *_: []) == 2


@pytest.mark.parametrize("last", [5, 40, 90])
def test_a_hall_begins_nothing_more(monkeypatch: pytest.MonkeyPatch, last: int) -> None:
    asked, done = Asked(last), list[str]()
    for module, name in ((loop, "list_likely"), (place, "find_floor")):
        monkeypatch.setattr(module, name, watched(getattr(module, name), asked, done))
    solution = sw.solve(sw.read("sample:hall-exhibition"), threads=1, cancel=asked)
    assert asked.over
    assert done == []
    assert STOPPED in {out.reason for out in solution.left_out}
    report = sw.check(solution, figures=False)
    # Before the search a passage between zones may be some centimetres short.
    assert {found.kind for found in report.findings} <= {"narrow_passage"}
    assert last == 5 or report.valid
    assert not report.complete


def test_a_hall_cancelled_at_once_lists_all_that_it_lacks() -> None:
    brief = sw.read("sample:hall-shop")
    solution = sw.solve(brief, cancel=lambda: True)
    demands = [wish for room in brief.rooms for wish in room.demands]
    assert len([out for out in solution.left_out if out.reason == STOPPED]) == len(demands)
    assert not sw.check(solution, figures=False).complete


@pytest.mark.parametrize("sample", ["home-room", "site-30", "village-street", "extend-terrace"])
def test_what_is_cancelled_at_once_is_not_said_to_be_whole(sample: str) -> None:
    solution = sw.solve(sw.read(f"sample:{sample}"), cancel=lambda: True)
    assert any(out.required for out in solution.left_out)
    assert not sw.check(solution, figures=False).complete


def test_an_extension_is_polished_no_further(monkeypatch: pytest.MonkeyPatch) -> None:
    moves: list[int] = []

    def count(*_: object) -> float:
        moves.append(1)
        return 0.0

    monkeypatch.setattr(annealing, "_energy", count)
    brief = sw.read("sample:extend-court")
    sw.solve(brief, threads=1, steps=1)
    whole = len(moves)
    moves.clear()
    solution = sw.solve(brief, threads=1, steps=1, cancel=lambda: len(moves) > 3)
    assert 3 < len(moves) < 10 < whole
    assert solution.pieces


def test_a_cancelled_change_changes_nothing() -> None:
    room = sw.solve(sw.read("sample:home-room"), steps=200)
    with pytest.raises(CancelledError):
        adjust(room, again=["room"], seed=7, cancel=lambda: True)
    asked = Asked(10**9)
    again = adjust(room, again=["room"], seed=7, cancel=asked)
    assert asked.left < 10**9 - 1
    assert again.solution == adjust(room, again=["room"], seed=7).solution
