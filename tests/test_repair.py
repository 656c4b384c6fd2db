"""The verdict and the loop that repairs: a state ends no worse than it began."""

from __future__ import annotations

from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from scenewright.arranging.repair import Repair, repair
from scenewright.arranging.verdict import Verdict, better, list_worst

ROWS = st.dictionaries(st.sampled_from("abc"), st.floats(0.0, 5.0), max_size=3)
VERDICTS = st.builds(Verdict, st.floats(0.0, 5.0), st.integers(0, 2), ROWS, ROWS)


@given(VERDICTS, VERDICTS)
def test_of_two_verdicts_at_most_one_is_better(a: Verdict, b: Verdict) -> None:
    assert not (better(a, b) and better(b, a) and a.total <= b.total)
    assert not better(a, a)


@pytest.mark.parametrize("worse", [{"lost": 1.0}, {"broken": 1}, {"findings": {"dark": 1.0}}])
def test_no_cost_buys_what_is_lost_broken_or_found(worse: dict[str, object]) -> None:
    cheap, dear = Verdict(**worse), Verdict(cost={"axis": 1000.0})  # type: ignore[arg-type]
    assert not better(cheap, dear)
    assert better(dear, cheap)


def test_rows_that_hold_are_not_listed() -> None:
    assert list_worst(Verdict(cost={"axis": 0.0})) == []


def _judge(state: tuple[int, int]) -> Verdict:
    x, y = state
    return Verdict(
        findings={"near": float(abs(x - y) < 2)}, cost={"x": abs(x - 3.0), "y": 1.0 * abs(y)}
    )


def _step(axis: int, by: int) -> object:
    def move(state: tuple[int, int], row: str) -> list[tuple[int, int]]:
        moved = [state[0], state[1]]
        moved[axis] += by
        return [(moved[0], moved[1])]

    return move


MOVES = {f"{axis}{by:+}": _step(axis, by) for axis, by in product((0, 1), (-1, 1))}
BY_ROW = dict.fromkeys(("near", "x", "y"), tuple(MOVES))


@pytest.mark.parametrize("start", list(product(range(-4, 8, 3), repeat=2)))
def test_it_settles_where_no_move_is_better_and_gains_what_it_says(start: tuple[int, int]) -> None:
    by = Repair(_judge, MOVES, BY_ROW, lambda state: state, 0.0)  # type: ignore[arg-type]
    done = repair(by, start, 500)
    begun = _judge(start)
    assert done.settled
    assert not better(begun, done.verdict)
    neighbours = [state for move in MOVES.values() for state in move(done.state, "")]  # type: ignore[operator]
    assert not any(better(_judge(state), done.verdict) for state in neighbours)
    assert sum(step.gained[3] for step in done.steps) == pytest.approx(
        begun.total - done.verdict.total
    )


def test_a_budget_or_a_stop_ends_it_and_says_so() -> None:
    by = Repair(_judge, MOVES, BY_ROW, lambda state: state)  # type: ignore[arg-type]
    assert not repair(by, (7, 7), 2).settled
    stopped = repair(by, (7, 7), 500, lambda: True)
    assert not stopped.settled
    assert stopped.state == (7, 7)


def test_what_a_better_state_must_hold_besides_is_asked_of_better_states_only() -> None:
    asked: list[tuple[int, int]] = []

    def holds(state: tuple[int, int]) -> bool:
        asked.append(state)
        return state[0] < 2

    by = Repair(_judge, MOVES, BY_ROW, lambda state: state, 0.0, holds)  # type: ignore[arg-type]
    done = repair(by, (0, 5), 500)
    assert done.state[0] < 2
    assert any(state[0] == 2 for state in asked)
    assert all(better(_judge(state), _judge((0, 5))) for state in asked)
